// SPDX-License-Identifier: GPL-3.0-or-later
// The body's time integrator addedMass: exact free motion, and its limit of
// stability when the fluid answers each acceleration with a reaction.

#include <gtest/gtest.h>

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
        const tensor& orientation = tensor::I
    )
    :
        time(Time::New())
    {
        dict.add("mass", mass);
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

    void step(const vector& force, const vector& moment, const scalar deltaT)
    {
        motion->newTime();
        motion->update(true, force, moment, deltaT, deltaT);
    }
};


//- Acceleration after n steps under the force F - Mf a_last, in x
scalar accelerationInFluid(const scalar Ma, const scalar Mf, const label n)
{
    const scalar force = 10;
    const scalar deltaT = 1e-3;
    Body body(vector(Ma, Ma, Ma), Zero);

    scalar a = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar v0 = body.motion->v().x();
        body.step(vector(force - Mf*a, 0, 0), Zero, deltaT);
        a = (body.motion->v().x() - v0)/deltaT;
    }
    return a;
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
