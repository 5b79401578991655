// SPDX-License-Identifier: GPL-3.0-or-later
// A body without a mesh: exact motions, constraints, restart bit for bit, refusals.

#include <gtest/gtest.h>

#include "../refusedInput.H"

#include "freeBody.H"

#include "IStringStream.H"
#include "mathematicalConstants.H"
#include "Time.H"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace Foam;

namespace
{

const char* const symplectic = "solver { type symplectic; }";
const char* const noEstimate = "solver { type addedMass; addedMass (0 0 0); addedInertia (0 0 0); }";

//- One half of a body about y = const, as cases/gannetPlunge has it
const char* const halfModel =
    "constraints"
    "{"
    "    plane { sixDoFRigidBodyMotionConstraint plane; normal (0 1 0); }"
    "    axis { sixDoFRigidBodyMotionConstraint axis; axis (0 1 0); }"
    "}";


dictionary parsed(const std::string& entries)
{
    IStringStream stream(entries);
    stream.name() = "constant/body";
    return dictionary(stream);
}


//- A body of 2 kg with these moments of inertia and further entries
struct Body
{
    autoPtr<Time> time;
    freeBody body;

    Body(const std::string& inertia, const std::string& entries, const vector& g = Zero)
    :
        time(Time::New()),
        body
        (
            parsed("mass 2; centreOfMass (1 2 3); momentOfInertia " + inertia + ";" + entries),
            time(),
            g
        )
    {}

    freeBody* operator->()
    {
        return &body;
    }
};


vector angularMomentum(const freeBody::fullState& s)
{
    return s.orientation & s.motion.pi();
}


//- Of the rotation [J]
scalar energy(const freeBody::fullState& s)
{
    return 0.5*(angularMomentum(s) & s.omega);
}


//- Largest difference of the angular velocity in body axes from
//  (wt cos(s t), -wt sin(s t), wn), s = (I1 - I3)/I1 wn, of a symmetric top
//  (Landau and Lifshitz, Mechanics, section 36), until 1 s
scalar symmetricTopError(const char* solver, const label nSteps)
{
    // As in the table torque_free_symmetric_top_exact: wt 0.5, wn 10, I3/I1 0.1
    Body top("(2 2 0.2)", std::string(solver) + "angularMomentum (1 0 2);");
    scalar error = 0;
    for (label n = 1; n <= nSteps; ++n)
    {
        top->advance(Zero, Zero, 1.0/nSteps);
        const bodyState s(top->state());
        const scalar phase = 0.9*10*n/nSteps;
        const vector exact(0.5*std::cos(phase), -0.5*std::sin(phase), 10);
        error = max(error, mag((s.orientation.T() & s.omega) - exact));
    }
    return error;
}


//- I = (1 2 3), omega = (0.05 2 0.1), until 20 s: differences of the body's
//  angular velocity [rad/s] and of its orientation [rad]
std::pair<scalar, scalar> asymmetricTopError(const char* solver, const scalar deltaT)
{
    Body top("(1 2 3)", std::string(solver) + "angularMomentum (0.05 4 0.3);");
    const label nSteps = label(std::floor(20/deltaT + 0.5));
    for (label n = 0; n < nSteps; ++n)
    {
        top->advance(Zero, Zero, deltaT);
    }

    // Euler's equations integrated to round-off, ten digits: last line of torque_free_asymmetric_top
    const vector omega(-0.0727144492, -1.999303031, 0.1045424812);
    const scalar q0 = 0.07214044773;
    const vector q(-0.9267049959, 0.01358958063, -0.3685497656);
    const tensor Q(tensor::I*(2*sqr(q0) - 1) + 2*(q*q) + 2*q0*tensor(0, -q.z(), q.y(), q.z(), 0, -q.x(), -q.y(), q.x(), 0));

    const bodyState s(top->state());
    const tensor turn(s.orientation & Q.T());
    const vector axis(turn.zy() - turn.yz(), turn.xz() - turn.zx(), turn.yx() - turn.xy());
    return {mag((s.orientation.T() & s.omega) - omega), std::atan2(mag(axis), tr(turn) - 1)};
}


//- Same bits?
bool same(const std::vector<double>& a, const std::vector<double>& b)
{
    return a.size() == b.size() && !std::memcmp(a.data(), b.data(), a.size()*sizeof(double));
}


//- Expects an error whose message, with the name of its file, holds these parts
template<class Function>
void expectRefused(const std::vector<std::string>& parts, const Function& function)
{
    FatalIOError.throwExceptions();
    FatalError.throwExceptions();
    std::string message;
    try
    {
        function();
    }
    catch (const IOerror& refused)
    {
        message = refused.message() + " in " + refused.ioFileName();
    }
    catch (const error& refused)
    {
        message = refused.message();
    }
    FatalIOError.dontThrowExceptions();
    FatalError.dontThrowExceptions();
    for (const std::string& part : parts)
    {
        EXPECT_NE(message.find(part), std::string::npos) << part << " is not in\n" << message;
    }
}


void expectRefused(const std::string& entries, const std::vector<std::string>& parts)
{
    std::vector<std::string> all(parts);
    all.push_back("constant/body");
    expectRefused
    (
        all,
        [&]
        {
            const autoPtr<Time> time(Time::New());
            freeBody(parsed(entries), time(), Zero);
        }
    );
}

} // End anonymous namespace


TEST(freeBody, pathWithoutForceIsStraight)
{
    for (const char* solver : {symplectic, noEstimate, "solver { type Newmark; }", "solver { type CrankNicolson; }"})
    {
        const vector v(25, -3, 0.1);
        Body body("(1 2 3)", std::string(solver) + "velocity (25 -3 0.1); angularMomentum (0.05 4 0.3);");
        for (label n = 0; n < 1000; ++n)
        {
            body->advance(Zero, Zero, 1e-3);
        }
        const bodyState s(body->state());
        EXPECT_EQ(s.velocity, v) << solver;
        EXPECT_EQ(s.acceleration, vector(Zero)) << solver;
        EXPECT_LT(mag(s.centreOfMass - (vector(1, 2, 3) + v)), 1e-12) << solver;
    }
}


TEST(freeBody, gravityOfTheCaseAddsToTheForce)
{
    // The entry g is for a case without constant/g
    const vector g(0, 0, -1.35);
    Body body("(1 2 3)", std::string(noEstimate) + "g (0 0 -9.81);", g);
    const vector force(2, -4, 6);
    for (label n = 0; n < 10; ++n)
    {
        body->advance(force, Zero, 0.01);
    }
    const bodyState s(body->state());
    EXPECT_LT(mag(s.velocity - 0.1*(g + force/2)), 1e-14);
    EXPECT_LT(mag(s.acceleration - (g + force/2)), 1e-12);
    EXPECT_EQ(s.omega, vector(Zero));
}


TEST(freeBody, torqueFreeTopsConvergeInTheirOrder)
{
    for (const char* solver : {symplectic, noEstimate})
    {
        const scalar coarseSymmetric = symmetricTopError(solver, 1000);
        const scalar fineSymmetric = symmetricTopError(solver, 10000);
        const std::pair<scalar, scalar> coarse(asymmetricTopError(solver, 1e-2));
        const std::pair<scalar, scalar> fine(asymmetricTopError(solver, 1e-3));
        EXPECT_LT(fineSymmetric, 7e-9) << solver;
        EXPECT_LT(fine.first, 7e-7) << solver;
        EXPECT_LT(fine.second, 4e-7) << solver;

        if (solver == symplectic)
        {
            EXPECT_NEAR(coarseSymmetric/fineSymmetric, 100, 1) << solver;
            EXPECT_NEAR(coarse.first/fine.first, 100, 1) << solver;
            EXPECT_NEAR(coarse.second/fine.second, 100, 1) << solver;
        }
        else
        {
            // Sixth order: nothing left to converge, at the coarse steps already
            EXPECT_LT(coarseSymmetric, 7e-9) << solver;
            EXPECT_LT(std::max(coarse.first, coarse.second), 1e-8) << solver;
            EXPECT_LT(std::max(fine.first, fine.second), 1e-8) << solver;
        }
    }
}


TEST(freeBody, torqueFreeTopKeepsAngularMomentumAndEnergy)
{
    Body top("(1 2 3)", std::string(symplectic) + "angularMomentum (0.05 4 0.3);");
    const freeBody::fullState start(top->state());
    scalar worst = 0;
    for (label n = 0; n < 20000; ++n)
    {
        top->advance(Zero, Zero, 1e-3);
        const freeBody::fullState s(top->state());
        EXPECT_LT(mag(angularMomentum(s) - angularMomentum(start)), 1e-11);
        EXPECT_LT(mag((s.orientation & s.orientation.T()) - tensor::I), 1e-12);
        worst = max(worst, mag(energy(s) - energy(start))/energy(start));
    }
    // It oscillates with the square of the time step
    EXPECT_LT(worst, 3e-8);
}


TEST(freeBody, halfModelStaysInItsPlane)
{
    Body body("(1 2 3)", std::string(noEstimate) + halfModel + "velocity (25 0 -5); angularMomentum (0 1 0);", vector(0, 0, -9.81));
    for (label n = 0; n < 100; ++n)
    {
        body->advance(vector(1, 7, 2), vector(3, 4, -5), 1e-2);
        const bodyState s(body->state());
        EXPECT_EQ(s.centreOfMass.y(), 2);
        EXPECT_EQ(s.velocity.y(), 0);
        EXPECT_EQ(s.acceleration.y(), 0);
        EXPECT_EQ(s.omega.x(), 0);
        EXPECT_EQ(s.omega.z(), 0);
        EXPECT_EQ(s.orientation & vector(0, 1, 0), vector(0, 1, 0));
    }
    // Within the plane it is free
    const bodyState s(body->state());
    EXPECT_NEAR(s.velocity.x(), 25 + 0.5, 1e-12);
    EXPECT_NEAR(s.velocity.z(), -5 + (1 - 9.81), 1e-12);
    EXPECT_NEAR(s.omega.y(), 0.5 + 4.0/2, 1e-12);
}


TEST(freeBody, pivotTakesMomentsAboutTheCentreOfMass)
{
    // The centre of mass is 0.5 m from the pivot along x
    Body body
    (
        "(1 2 3)",
        std::string(noEstimate)
      + "constraints { pivot { sixDoFRigidBodyMotionConstraint point; centreOfRotation (0.5 2 3); } }"
    );
    const scalar deltaT = 1e-6;
    body->advance(vector(0, 0, 3), vector(0, 4, 0), deltaT);
    const bodyState s(body->state());
    const scalar expected = (4 - 0.5*3)/(2 + 2*sqr(0.5));
    EXPECT_LT(mag(s.angularAcceleration - vector(0, expected, 0)), 1e-9);
    EXPECT_LT(mag(s.acceleration - vector(0, 0, -0.5*expected)), 1e-5);
    EXPECT_LT(mag(s.velocity - vector(0, 0, -0.5*expected*deltaT)), 1e-11);
}


TEST(freeBody, springOscillates)
{
    // 2 kg on 8 N/m: 2 rad/s, let go 0.1 m below where it would hang at rest. The integrator needs the first acceleration.
    Body body
    (
        "(1 1 1)",
        std::string(symplectic)
      + "acceleration (0 0 0.4);"
        "restraints"
        "{"
        "    spring"
        "    {"
        "        sixDoFRigidBodyMotionRestraint linearSpring;"
        "        anchor (1 2 5); refAttachmentPt (1 2 3); restLength 0.55; stiffness 8; damping 0;"
        "    }"
        "}",
        vector(0, 0, -5.4)
    );
    // At rest the spring is 0.55 + 2*5.4/8 = 1.9 m long
    const label nSteps = 10000;
    scalar error = 0;
    for (label n = 1; n <= nSteps; ++n)
    {
        body->advance(Zero, Zero, 5.0/nSteps);
        error = max(error, mag(body->state().centreOfMass.z() - (3.1 - 0.1*std::cos(2*5.0*n/nSteps))));
    }
    EXPECT_LT(error, 4e-8);
}


TEST(freeBody, thrustHasItsImpulseWhateverTheSteps)
{
    // Turned by a right angle about z: 8 N along the body's x drive 2 kg along y, from within a step to within another
    for (const scalar deltaT : {0.01, 0.03})
    {
        Body body
        (
            "(1 1 1)",
            std::string(symplectic)
          + "orientation (0 -1 0 1 0 0 0 0 1);"
            "restraints"
            "{"
            "    motor"
            "    {"
            "        sixDoFRigidBodyMotionRestraint thrust;"
            "        force 8; direction (2 0 0); refAttachmentPt (1 5 3); start 0.105; end 0.305;"
            "    }"
            "}"
        );
        body.time->setDeltaT(deltaT, false);
        for (label n = 1; n*deltaT < 0.5; ++n)
        {
            body.time->setTime(n*deltaT, n);
            body->advance(Zero, Zero, deltaT);
        }
        body->advance(Zero, Zero, deltaT);  // the acceleration of a step's end acts in the next one, too
        EXPECT_LT(mag(body->state().velocity - vector(0, 0.8, 0)), 1e-12) << deltaT;
        EXPECT_LT(mag(body->state().omega), 1e-12);
    }
}


TEST(freeBody, thrustIsRefusedWithoutADirectionOrATime)
{
    for (const std::string wrong : {"direction (0 0 0);", "direction (1 0 0); start 2; end 1;", "direction (1 0 0); until 1;"})
    {
        expectRefusal
        (
            {"constant/body"},
            [&]
            {
                Body
                (
                    "(1 1 1)",
                    std::string(symplectic) + "restraints { motor { sixDoFRigidBodyMotionRestraint thrust; force 8; refAttachmentPt (0 0 0); "
                  + wrong + " } }"
                );
            }
        );
    }
}


TEST(freeBody, springKeepsItsEnergyWithEveryIntegrator)
{
    // 2 kg on 200 N/m: 10 rad/s, ten periods of 200 steps
    for (const char* solver : {symplectic, noEstimate, "solver { type Newmark; }", "solver { type CrankNicolson; }"})
    {
        Body body
        (
            "(1 1 1)",
            std::string(solver)
          + "restraints"
            "{"
            "    spring"
            "    {"
            "        sixDoFRigidBodyMotionRestraint linearSpring;"
            "        anchor (1 2 5); refAttachmentPt (1 2 3); restLength 1.9; stiffness 200; damping 0;"
            "    }"
            "}"
        );
        const label nSteps = 2000;
        const scalar period = constant::mathematical::twoPi/10;
        scalar highest = 0;
        for (label n = 1; n <= nSteps; ++n)
        {
            body->advance(Zero, Zero, 10*period/nSteps);
            if (n > 0.9*nSteps)
            {
                highest = max(highest, body->state().centreOfMass.z());
            }
        }
        EXPECT_NEAR(highest - 3.1, 0.1, 0.001) << solver;
    }
}


namespace
{

//- Of a body that is hinged or slides, with the centre of mass at (1 2 3) at the start and this inertia about it [J]
scalar wholeEnergy(const freeBody::fullState& s, const symmTensor& I, const vector& g)
{
    const vector omega(s.orientation.T() & s.omega);
    return magSqr(s.velocity) + 0.5*(omega & (I & omega)) - 2*(g & s.centreOfMass);
}


//- Largest change of the energy, over the kinetic energy of the start, in 2 s
scalar energyDrift(const std::string& entries, const vector& g, const label nSteps, vector* momentum = nullptr)
{
    Body body("(1 2 3)", std::string(noEstimate) + entries, g);
    const symmTensor I(1, 0, 0, 2, 0, 3);
    // The first step takes from a start what constraints do not allow
    body->advance(Zero, Zero, 2.0/nSteps);
    const scalar start = wholeEnergy(body->state(), I, g);
    const scalar kinetic = wholeEnergy(body->state(), I, Zero);
    const vector velocity(body->state().velocity);
    scalar drift = 0;
    for (label n = 1; n < nSteps; ++n)
    {
        body->advance(Zero, Zero, 2.0/nSteps);
        drift = max(drift, mag(wholeEnergy(body->state(), I, g) - start)/kinetic);
    }
    if (momentum)
    {
        *momentum = body->state().velocity - velocity;
    }
    return drift;
}

} // End anonymous namespace


TEST(freeBody, hingedBodiesKeepTheirEnergy)
{
    const std::string pivot("point { sixDoFRigidBodyMotionConstraint point; centreOfRotation (1.5 1.8 3.7); }");
    const std::string hinge("axis { sixDoFRigidBodyMotionConstraint axis; axis (0 1 0); }");
    const std::string oblique("axis { sixDoFRigidBodyMotionConstraint axis; axis (1 1 0.5); }");
    const std::string slider("line { sixDoFRigidBodyMotionConstraint line; centreOfRotation (1.5 1.8 3.7); direction (1 0 0); }");
    const std::string table("plane { sixDoFRigidBodyMotionConstraint plane; centreOfRotation (1.5 1.8 3.7); normal (0 0 1); }");
    const std::string spin("angularMomentum (0.5 4 1);");
    // About an axis that is not its own the body turns as the axis lets it
    const std::string turned("orientation (0.8 0 0.6 0 1 0 -0.6 0 0.8);");

    for (const std::string& start : {spin, spin + turned})
    {
        for (const std::string& constraints : {pivot, pivot + hinge, pivot + oblique, slider + hinge, slider, table, table + hinge})
        {
            for (const vector& g : {vector(Zero), vector(0, 0, -9.81)})
            {
                const std::string entries(start + "constraints {" + constraints + "}");
                const scalar coarse = energyDrift(entries, g, 2000);
                const scalar fine = energyDrift(entries, g, 4000);
                EXPECT_LT(fine, 0.02) << entries << ' ' << g.z();
                EXPECT_LT(fine, 0.6*coarse + 1e-10) << entries << ' ' << g.z();
            }
        }
    }

    // What slides keeps its momentum along the line
    vector change(Zero);
    energyDrift(spin + "constraints {" + slider + hinge + "}", Zero, 2000, &change);
    EXPECT_LT(mag(change.x()), 2e-3);
}


TEST(freeBody, everyPairOfConstraintsLeavesWhatItShould)
{
    // Accelerations under a force and a moment about the centre of mass, from rest: of the centre of mass, and about it
    const std::string at(" centreOfRotation (1 2 3);");
    const std::vector<std::pair<std::string, std::pair<vector, vector>>> cases
    ({
        {"", {{2, 3, 4}, {6, 6, 6}}},
        {"a { sixDoFRigidBodyMotionConstraint point;" + at + "}", {{0, 0, 0}, {6, 6, 6}}},
        {"a { sixDoFRigidBodyMotionConstraint line; direction (0 0 2); }", {{0, 0, 4}, {6, 6, 6}}},
        {"a { sixDoFRigidBodyMotionConstraint plane; normal (0 1 0); }", {{2, 0, 4}, {6, 6, 6}}},
        {"a { sixDoFRigidBodyMotionConstraint axis; axis (0 3 0); }", {{2, 3, 4}, {0, 6, 0}}},
        {"a { sixDoFRigidBodyMotionConstraint orientation; }", {{2, 3, 4}, {0, 0, 0}}},
        {
            "a { sixDoFRigidBodyMotionConstraint line; direction (1 0 0); } b { sixDoFRigidBodyMotionConstraint orientation; }",
            {{2, 0, 0}, {0, 0, 0}}
        },
        {
            "a { sixDoFRigidBodyMotionConstraint plane; normal (1 0 0); } b { sixDoFRigidBodyMotionConstraint plane; normal (0 1 0); }",
            {{0, 0, 4}, {6, 6, 6}}
        },
        {
            "a { sixDoFRigidBodyMotionConstraint line; direction (1 0 0); } b { sixDoFRigidBodyMotionConstraint plane; normal (1 0 0); }",
            {{0, 0, 0}, {6, 6, 6}}
        },
        {
            "a { sixDoFRigidBodyMotionConstraint axis; axis (1 0 0); } b { sixDoFRigidBodyMotionConstraint axis; axis (0 1 0); }",
            {{2, 3, 4}, {0, 0, 0}}
        },
        {
            "a { sixDoFRigidBodyMotionConstraint line; centreOfRotation (1.5 2 3); direction (1 0 0); }"
            "b { sixDoFRigidBodyMotionConstraint axis; axis (0 1 0); }",
            // Turns about the slider, half a metre from the centre of mass, by (12 + 0.5*8)/(2 + 2*0.25)
            {{2, 0, 3.2}, {0, 6.4, 0}}
        }
    });
    for (const auto& each : cases)
    {
        Body body("(1 2 3)", std::string(noEstimate) + "constraints {" + each.first + "}");
        const scalar deltaT = 1e-6;
        body->advance(vector(4, 6, 8), vector(6, 12, 18), deltaT);
        const bodyState s(body->state());
        EXPECT_LT(mag(s.acceleration - each.second.first), 1e-5) << each.first;
        EXPECT_LT(mag(s.angularAcceleration - each.second.second), 1e-5) << each.first;
    }
}


TEST(freeBody, goesOnFromItsNumbersBitForBit)
{
    const char* const spring =
        "restraints"
        "{"
        "    spring"
        "    {"
        "        sixDoFRigidBodyMotionRestraint linearSpring;"
        "        anchor (2 1 5); refAttachmentPt (1 2 3.5); restLength 1; stiffness 80; damping 3;"
        "    }"
        "}";

    for (const char* solver : {symplectic, noEstimate, "solver { type Newmark; }", "solver { type CrankNicolson; }"})
    {
        for (const char* relaxation : {"", "accelerationRelaxation 0.5;"})
        {
            const std::string entries
            (
                std::string(solver) + spring + relaxation + "velocity (25 0 -5); angularMomentum (0.05 4 0.3);"
            );
            const auto steps = [](freeBody& body, const label from, const label to)
            {
                for (label n = from; n < to; ++n)
                {
                    body.advance(vector(n, 7, 2), vector(3, 4, n), (n % 3 + 1)*1e-3);
                }
            };

            Body whole("(1 2 3)", entries, vector(0, 0, -9.81));
            steps(whole.body, 0, 20);
            const std::vector<double> half(whole->numbers());
            const freeBody::fullState halfState(whole->state());
            steps(whole.body, 20, 40);

            Body restarted("(1 2 3)", entries, vector(0, 0, -9.81));
            restarted->set(half);
            EXPECT_TRUE(same(restarted->numbers(), half));
            EXPECT_EQ(restarted->state().centreOfMass, halfState.centreOfMass);
            EXPECT_EQ(restarted->state().acceleration, halfState.acceleration);
            steps(restarted.body, 20, 40);
            EXPECT_TRUE(same(restarted->numbers(), whole->numbers())) << entries;

            restarted->setState(halfState);
            steps(restarted.body, 20, 40);
            EXPECT_TRUE(same(restarted->numbers(), whole->numbers())) << entries;
        }
    }
}


TEST(freeBody, firstStepIsRelaxedLikeAnyOther)
{
    // OpenFOAM spares the first step of a process
    for (label n = 0; n < 2; ++n)
    {
        Body body("(1 2 3)", std::string(noEstimate) + "accelerationRelaxation 0.5;");
        body->advance(vector(4, 0, 0), Zero, 1e-3);
        EXPECT_NEAR(body->state().acceleration.x(), 1, 1e-12);
    }
}


TEST(freeBody, badEntriesAreNamed)
{
    const std::string mass("mass 2;");
    const std::string centre("centreOfMass (1 2 3);");
    const std::string inertia("momentOfInertia (1 2 3);");
    const std::string solver(symplectic);

    expectRefused(centre + inertia + solver, {"'mass' not found"});
    expectRefused("mass 0;" + centre + inertia + solver, {"Entry mass is 0", "positive mass"});
    expectRefused(mass + centre + "momentOfInertia (1 0 3);" + solver, {"Entry momentOfInertia is (1 0 3)", "positive"});
    expectRefused(mass + inertia + solver, {"'centreOfMass' not found"});
    expectRefused(mass + centre + inertia, {"'solver' not found"});
    expectRefused(mass + centre + inertia + solver + "velocty (1 0 0);", {"Unknown entry velocty", "velocity"});
    expectRefused(mass + centre + inertia + solver + "orientation (1 0 0 0 2 0 0 0 1);", {"Entry orientation", "rotation"});
    expectRefused(mass + centre + inertia + solver + "orientation (1 0 0 0 1 0 0 0 -1);", {"Entry orientation", "rotation"});
    expectRefused(mass + centre + inertia + solver + "accelerationRelaxation 0;", {"Entry accelerationRelaxation is 0", "above 0"});
    expectRefused
    (
        mass + centre + inertia + solver + "restraints { chain { sixDoFRigidBodyMotionRestraint linearSpringDamper; } }",
        {"Entry frelax is 0.8", "frelax 1", "chain"}
    );
}


TEST(freeBody, constraintsOfOtherCentresAreRefused)
{
    const std::string properties("mass 2; centreOfMass (1 2 3); momentOfInertia (1 2 3);" + std::string(noEstimate) + "constraints {");
    const std::string hinge("hinge { sixDoFRigidBodyMotionConstraint point; centreOfRotation (0 2 3); }");
    const std::string inPlane("table { sixDoFRigidBodyMotionConstraint plane; normal (0 0 1); }");
    const std::string upright("axis { sixDoFRigidBodyMotionConstraint axis; axis (0 0 1); }");
    const std::string slider("slider { sixDoFRigidBodyMotionConstraint line; direction (1 0 0); }");
    const std::string other("other { sixDoFRigidBodyMotionConstraint point; centreOfRotation (3 2 3); }");

    // The last one's was taken: the hinge held the centre of mass
    const std::vector<std::string> named({"Entry centreOfRotation is (0 2 3)", "that of table (1 2 3)", "the same in all", "hinge"});
    expectRefused(properties + hinge + inPlane + upright + "}", named);
    expectRefused(properties + hinge + other + upright + "}", {"Entry centreOfRotation is (0 2 3)", "that of other (3 2 3)"});
    expectRefused(properties + hinge + slider + upright + "}", {"Entry centreOfRotation is (0 2 3)", "that of slider"});
    expectRefused(properties + inPlane + hinge + "}", {"Entry centreOfRotation is (1 2 3)", "that of hinge", "table"});

    // In the plane, or without rotation, it means the same
    Body("(1 2 3)", noEstimate + ("constraints {" + inPlane + hinge + upright + "}"));
    Body("(1 2 3)", noEstimate + ("constraints {" + hinge + slider + "turn { sixDoFRigidBodyMotionConstraint orientation; } }"));
}


// What OpenFOAM's integrators leave out; a plate that slides by its end fell with 1.9 g
TEST(freeBody, constraintsThatAnIntegratorCannotHoldAreRefused)
{
    const std::string properties("mass 2; centreOfMass (1 2 3); momentOfInertia (1 2 3);");
    const std::string upright("axis { sixDoFRigidBodyMotionConstraint axis; axis (0 0 1); }");
    const std::string slider("slider { sixDoFRigidBodyMotionConstraint line; direction (0 1 0); centreOfRotation (0 2 3); }");
    const std::string table("table { sixDoFRigidBodyMotionConstraint plane; normal (1 0 0); centreOfRotation (0 2 3); }");
    const std::string along("along { sixDoFRigidBodyMotionConstraint line; direction (0 0 1); centreOfRotation (1 2 0); }");
    const std::string hinge("hinge { sixDoFRigidBodyMotionConstraint point; centreOfRotation (0 1 3); }");
    const std::string oblique("axis { sixDoFRigidBodyMotionConstraint axis; axis (1 1 0); }");
    for (const std::string name : {"symplectic", "Newmark", "CrankNicolson"})
    {
        const std::string solver("solver { type " + name + "; } constraints {");
        const std::string start("Entry type is " + name);
        for (const std::string& constraints : {slider + upright, slider, table + upright, table})
        {
            expectRefused(properties + solver + constraints + "}", {start, "translation and rotation are coupled", "addedMass"});
        }
        for (const std::string& constraints : {hinge, oblique})
        {
            expectRefused(properties + solver + constraints + "}", {start, "products of inertia", "addedMass"});
        }
        // Along the axis that it turns about, as the tutorial floatingObject, a body slides without a coupling
        const std::string beside("beside { sixDoFRigidBodyMotionConstraint line; direction (0 0 1); centreOfRotation (0 2 3); }");
        for (const std::string& constraints : {hinge + upright, along + upright, beside + upright, upright})
        {
            Body("(1 2 3)", solver + constraints + "}");
        }
    }
}


TEST(freeBody, numbersOfAnotherKindAreRefused)
{
    Body body("(1 2 3)", symplectic);
    expectRefused({"30 numbers", "Expected: 31"}, [&]{ body->set(std::vector<double>(30)); });
}
