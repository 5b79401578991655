// SPDX-License-Identifier: GPL-3.0-or-later
// The body's time integrator prescribed: velocity and spin of the start, whatever acts on the body, by OpenFOAM's motion
// solver and without a mesh; restart bit for bit; refusals.

#include "../refusedInput.H"

#include "freeBody.H"

#include "IStringStream.H"
#include "Time.H"

#include <cmath>
#include <cstring>

using namespace Foam;

namespace
{

const vector g(0, 0, -9.81);
const vector velocity(3, -2, 1);

// About no axis of inertia
const vector spin(2, -1, 0.5);


dictionary coefficients(const std::string& more = "")
{
    IStringStream stream
    (
        "mass 2; centreOfMass (1 2 3); momentOfInertia (0.5 3 4); velocity (3 -2 1); angularMomentum (1 -3 2);"
        "solver { type prescribed; }" + more
    );
    stream.name() = "constant/body";
    return dictionary(stream);
}


struct Body
{
    autoPtr<Time> time;
    freeBody body;

    Body()
    :
        time(Time::New()),
        body(coefficients(), time(), g)
    {}

    void advance(label nSteps, scalar deltaT)
    {
        for (label i = 0; i < nSteps; ++i)
        {
            body.advance(vector(100*i, -50, 20), vector(3, 2*i, -1), deltaT);
        }
    }
};


//- By an angle about the spin
tensor turned(const scalar angle)
{
    const vector n(spin/mag(spin));
    const tensor cross(0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0);
    return std::cos(angle)*tensor::I + std::sin(angle)*cross + (1 - std::cos(angle))*(n*n);
}

} // End anonymous namespace


TEST(prescribed, keepsVelocityAndSpinWhateverActs)
{
    for (const label nSteps : {1, 7, 100})
    {
        Body b;
        b.advance(nSteps, 2.0/nSteps);
        const bodyState s(b.body.state());
        EXPECT_EQ(s.velocity, velocity);
        EXPECT_LT(mag(s.omega - spin), 1e-13);
        EXPECT_LT(mag(s.centreOfMass - vector(1, 2, 3) - 2*velocity), 1e-12);
        EXPECT_LT(mag(s.orientation - turned(2*mag(spin))), 1e-12) << nSteps;
        EXPECT_LT(mag(s.acceleration), 1e-12);
        EXPECT_LT(mag(s.angularAcceleration), 1e-10);
    }
}


TEST(prescribed, movesOpenFOAMsBodyLikewise)
{
    const autoPtr<Time> time(Time::New());
    const dictionary dict(coefficients());
    sixDoFRigidBodyMotion motion(dict, dict, time());
    for (label i = 0; i < 10; ++i)
    {
        motion.newTime();
        motion.update(true, vector(5, 6, 7), vector(8, 9, 10), 0.1, 0.1);
    }
    EXPECT_EQ(motion.v(), velocity);
    EXPECT_LT(mag(motion.omega() - spin), 1e-13);
    EXPECT_LT(mag(motion.centreOfMass() - vector(1, 2, 3) - velocity), 1e-13);
    EXPECT_LT(mag(motion.orientation() - turned(mag(spin))), 1e-13);
}


TEST(prescribed, doesNotMoveWithoutVelocityAndSpin)
{
    const autoPtr<Time> time(Time::New());
    freeBody body(coefficients("velocity (0 0 0); angularMomentum (0 0 0);"), time(), g);
    body.advance(vector(5, 6, 7), vector(8, 9, 10), 0.1);
    EXPECT_EQ(body.state().centreOfMass, point(1, 2, 3));
    EXPECT_EQ(body.state().orientation, tensor::I);
}


TEST(prescribed, goesOnFromASavedStateBitForBit)
{
    Body whole, first, second;
    whole.advance(20, 0.01);
    first.advance(10, 0.01);
    second.body.set(first.body.numbers());
    second.advance(10, 0.01);
    const std::vector<double> a(whole.body.numbers()), b(second.body.numbers());
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size()*sizeof(double)), 0);
}


TEST(prescribed, constraintsAndRestraintsAreRefused)
{
    const autoPtr<Time> time(Time::New());
    const std::string line("{ line { sixDoFRigidBodyMotionConstraint line; direction (0 0 1); } }");
    for (const std::string entry : {"constraints", "restraints"})
    {
        expectRefusal({entry, "prescribed", "constant/body"}, [&]{ freeBody(coefficients(entry + line), time(), g); });
    }
    freeBody(coefficients("constraints {} restraints {}"), time(), g);
}
