// SPDX-License-Identifier: GPL-3.0-or-later
// The body's time integrator addedMass: exact free motion, and its limit of
// stability when the fluid answers each acceleration with a reaction.

#include <gtest/gtest.h>

#include "mathematicalConstants.H"
#include "sixDoFRigidBodyMotion.H"
#include "StringStream.H"
#include "Time.H"

using namespace Foam;

namespace
{

const scalar mass = 2;


//- Body with the integrator under test; orientation as OpenFOAM writes it
struct Body
{
    autoPtr<Time> time;
    dictionary dict;
    autoPtr<sixDoFRigidBodyMotion> motion;

    Body
    (
        const vector& addedMass,
        const vector& addedInertia,
        const tensor& orientation = tensor::I,
        const scalar m = mass
    )
    :
        time(Time::New())
    {
        dict.add("mass", m);
        dict.add("centreOfMass", vector(Zero));
        dict.add("momentOfInertia", diagTensor(0.5, 3, 4));
        dict.add("orientation", orientation);
        dict.add("velocity", vector(25, 0, 0));

        dictionary solver;
        solver.add("type", word("addedMass"));
        solver.add("addedMass", addedMass);
        solver.add("addedInertia", addedInertia);
        dict.add("solver", solver);

        motion.reset(new sixDoFRigidBodyMotion(dict, dict, time()));
    }

    scalar lastDeltaT = 0;

    void step(const vector& force, const vector& moment, const scalar deltaT)
    {
        motion->newTime();
        motion->update(true, force, moment, deltaT, lastDeltaT > 0 ? lastDeltaT : deltaT);
        lastDeltaT = deltaT;
    }

    //- Solve the last step again
    void repeat(const vector& force, const vector& moment)
    {
        motion->update(false, force, moment, lastDeltaT, lastDeltaT);
    }
};


//- A body in an ideal fluid, along x: what moves with it feels the velocity that it moves with over the step
struct BodyInFluid
{
    Body body;
    const scalar Mf;
    scalar wall;
    scalar wallLast;
    scalar x;

    BodyInFluid(const scalar mass, const scalar Ma, const scalar Mf)
    :
        body(vector(Ma, Ma, Ma), Zero, tensor::I, mass),
        Mf(Mf),
        wall(25),
        wallLast(25),
        x(0)
    {}

    //- Step under a force and the fluid's reaction
    void step(const scalar force, const scalar deltaT)
    {
        const scalar reaction = body.lastDeltaT > 0 ? Mf*(wall - wallLast)/body.lastDeltaT : 0;
        wallLast = wall;
        body.step(vector(force - reaction, 0, 0), Zero, deltaT);
        moved(deltaT);
    }

    void moved(const scalar deltaT)
    {
        wall = (body.motion->centreOfMass().x() - x)/deltaT;
    }

    //- The step ends here
    void next()
    {
        x = body.motion->centreOfMass().x();
    }

    //- Velocity, less that of the start
    scalar v() const
    {
        return body.motion->v().x() - 25;
    }
};


//- Acceleration after n steps under the force F - Mf a_last, in x
scalar accelerationInFluid(const scalar Ma, const scalar Mf, const label n)
{
    const scalar deltaT = 1e-3;
    BodyInFluid body(mass, Ma, Mf);
    scalar v0 = 0;
    for (label i = 0; i < n; ++i)
    {
        v0 = body.v();
        body.step(10, deltaT);
        body.next();
    }
    return (body.v() - v0)/deltaT;
}


} // End anonymous namespace


TEST(addedMass, constantForceIsExactWithoutEstimate)
{
    Body body(Zero, Zero);
    const vector force(1, -2, 3);
    for (label i = 0; i < 10; ++i)
    {
        body.step(force, Zero, 0.01);
    }
    const vector expected = vector(25, 0, 0) + 0.1*force/mass;
    EXPECT_LT(mag(body.motion->v() - expected), 1e-12);
}


TEST(addedMass, estimateDoesNotChangeTheAcceleration)
{
    // The body's mass and the fluid's share the force, whatever the estimate.
    const scalar Mf = 3;
    for (const scalar Ma : {0.6*Mf, Mf, 2*Mf})
    {
        EXPECT_NEAR(accelerationInFluid(Ma, Mf, 200), 10/(mass + Mf), 1e-9)
            << "estimate " << Ma;
    }
}


TEST(addedMass, exactEstimateNeedsNoIteration)
{
    EXPECT_NEAR(accelerationInFluid(3, 3, 1), 10.0/5.0, 1e-9);
}


TEST(addedMass, stableAboveHalfOfTheMassDifference)
{
    // Each step multiplies the error by (Ma - Mf)/(mass + Ma).
    const scalar Mf = 3;
    const scalar limit = 0.5*(Mf - mass);
    EXPECT_GT(mag(accelerationInFluid(0.8*limit, Mf, 400)), 100);
    EXPECT_LT(mag(accelerationInFluid(1.2*limit, Mf, 400)), 10);
}


TEST(addedMass, estimateIsInBodyAxes)
{
    // The body's first axis points along the earth's z axis.
    const tensor orientation(0, 0, 1, 0, 1, 0, -1, 0, 0);
    ASSERT_LT(mag((orientation & vector(1, 0, 0)) - vector(0, 0, -1)), 1e-15);

    Body body(vector(6, 0, 0), Zero, orientation);
    body.step(vector(1, 1, 1), Zero, 1);
    const vector dv = body.motion->v() - vector(25, 0, 0);
    EXPECT_LT(mag(dv - vector(1/mass, 1/mass, 1/(mass + 6))), 1e-12);
}


TEST(addedMass, rotationIsBlendedToo)
{
    Body body(Zero, vector(0.5, 1, 0));
    const scalar deltaT = 1e-6;
    body.step(Zero, vector(1, 1, 1), deltaT);
    const vector expected(1/(0.5 + 0.5), 1/(3.0 + 1.0), 1/4.0);
    EXPECT_LT(mag(body.motion->omega()/deltaT - expected), 1e-5);
}


TEST(addedMass, negativeEstimateIsRefused)
{
    FatalIOError.throwExceptions();
    EXPECT_THROW(Body(vector(-1, 0, 0), Zero), IOerror);
    FatalIOError.dontThrowExceptions();
}


TEST(addedMass, pathIsExactUnderAnyConstantAcceleration)
{
    // Whatever accelerates it, by whatever steps
    Body body(Zero, Zero);
    const vector force(1, -2, 3);
    const vector moment(0.2, 0, 0);
    scalar t = 0;
    for (const scalar deltaT : {0.01, 0.02, 0.005, 0.03, 0.03, 0.011})
    {
        body.step(force, moment, deltaT);
        t += deltaT;
        EXPECT_LT(mag(body.motion->v() - vector(25, 0, 0) - t*force/mass), 1e-13);
        EXPECT_LT(mag(body.motion->centreOfMass() - t*vector(25, 0, 0) - 0.5*sqr(t)*force/mass), 1e-14);
        EXPECT_NEAR(body.motion->omega().x(), t*0.2/0.5, 1e-14);
        EXPECT_NEAR(std::asin(body.motion->orientation().zy()), 0.5*sqr(t)*0.2/0.5, 1e-14);
    }
}


TEST(addedMass, risingDiscInAnIdealFluidIsFirstOrder)
{
    // Density 0.8 of the fluid's, gravity 1: (1 - 0.8)/(1 + 0.8)
    scalar errors[2][2];
    for (label fine = 0; fine < 2; ++fine)
    {
        const scalar deltaT = fine ? 0.0125 : 0.025;
        BodyInFluid disc(0.8, 1, 1);
        for (label n = 0; n < label(3/deltaT + 0.5); ++n)
        {
            disc.step(0.2, deltaT);
            disc.next();
        }
        errors[fine][0] = disc.x - 3*25 - 0.5;
        errors[fine][1] = disc.v() - 1.0/3;
        EXPECT_LT(mag(errors[fine][0]), 0.01*0.5);
        EXPECT_LT(mag(errors[fine][1]), 0.01/3);
    }
    EXPECT_NEAR(errors[0][0]/errors[1][0], 2, 0.3);
}


TEST(addedMass, floatNeitherGainsNorLosesEnergy)
{
    // In an ideal fluid: frequency^2 k/(M + Mf), light and heavy, with steps that vary
    for (const scalar mass : {0.05, 0.5, 5.0})
    {
        const scalar Mf = 1;
        const scalar omega = std::sqrt(10/(mass + Mf));
        scalar error[2] = {0, 0};
        for (label fine = 0; fine < 2; ++fine)
        {
            BodyInFluid afloat(mass, Mf, Mf);
            const scalar mean = 0.02/(omega*(fine ? 2 : 1));
            const scalar periods = 10*constant::mathematical::twoPi/omega;
            scalar t = 0;
            scalar last = 0;
            for (label n = 0; t < periods; ++n)
            {
                const scalar deltaT = mean*(1 + 0.1*std::sin(0.01*n));
                afloat.step(-10*(afloat.x - 25*t + 0.1), deltaT);
                afloat.next();
                t += deltaT;
                if (t > 0.9*periods)
                {
                    last = max(last, mag(afloat.x - 25*t + 0.1));
                }
                error[fine] = max(error[fine], mag(afloat.x - 25*t + 0.1 - 0.1*std::cos(omega*t)));
            }
            EXPECT_NEAR(last, 0.1, 0.001) << mass;
        }
        EXPECT_GT(error[0]/error[1], 1.8) << mass;
    }
}


TEST(addedMass, stepsThatAreSolvedAgainObeyNewton)
{
    // The estimate is of the immersed body, ten times what the fluid adds now: a fifth pass holds m a = F to 1e-6
    BodyInFluid body(0.01, 10, 1);
    const scalar deltaT = 1e-3;
    scalar v0 = 0;
    for (label n = 0; n < 20; ++n)
    {
        const scalar force = 1 + 0.2*n;
        body.step(force, deltaT);
        scalar F = 0;
        for (label pass = 0; pass < 5; ++pass)
        {
            F = force - body.Mf*(body.wall - body.wallLast)/deltaT;
            body.body.repeat(vector(F, 0, 0), Zero);
            body.moved(deltaT);
        }
        F = force - body.Mf*(body.wall - body.wallLast)/deltaT;
        EXPECT_NEAR(0.01*(body.v() - v0)/deltaT, F, 1e-6*force) << n;
        v0 = body.v();
        body.next();
    }
}
