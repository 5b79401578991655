// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeBody.H"

#include "bodyCoefficients.H"
#include "dimensionedVector.H"
#include "fluidSelection.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A time step in which nothing moves, that integrators can divide by [s]
constexpr scalar noStep = VSMALL;

//- All that sixDoFRigidBodyMotion and its mesh motion solver read
const wordHashSet keywords
({
    "mass", "momentOfInertia", "centreOfMass", "initialCentreOfMass",
    "centreOfRotation", "orientation", "initialOrientation", "velocity",
    "acceleration", "angularMomentum", "torque", "g", "solver", "constraints",
    "restraints", "accelerationRelaxation", "accelerationDamping", "report",
    "patches", "innerDistance", "outerDistance", "rho", "rhoInf", "test",
    "CofGvelocity"
});


//- The coefficients, checked, and without a report of every step
dictionary checked(const dictionary& coefficients)
{
    checkKeywords(coefficients, keywords);
    checkBodyCoefficients(coefficients);

    const scalar relaxation =
        coefficients.lookupOrDefault<scalar>("accelerationRelaxation", 1);
    if (!(relaxation > 0 && relaxation <= 1))
    {
        refuseEntry(coefficients, "accelerationRelaxation", text("is ", relaxation), "above 0, up to 1.");
    }
    if (relaxation < 1)
    {
        WarningInFunction
            << "accelerationRelaxation " << relaxation << " in "
            << coefficients.name() << ": there are no outer corrections here,"
            << " and the body's acceleration lags by "
            << (1 - relaxation)/relaxation << " time steps. Use 1." << endl;
    }

    const dictionary restraints(coefficients.subOrEmptyDict("restraints"));
    for (const entry& e : restraints)
    {
        if
        (
            e.isDict()
         && e.dict().get<word>("sixDoFRigidBodyMotionRestraint")
         == "linearSpringDamper"
         && e.dict().lookupOrDefault<scalar>("frelax", 0.8) != 1
        )
        {
            refuseEntry
            (
                e.dict(),
                "frelax",
                text("is ", e.dict().lookupOrDefault<scalar>("frelax", 0.8)),
                "frelax 1, for the force of the step before is not kept when the case is restarted."
            );
        }
    }

    dictionary result(coefficients);
    result.remove("report");
    if (result.isDict("solver") && result.subDict("solver").getOrDefault<word>("type", "") == "addedMass")
    {
        // The flow's own coupling has the added mass: an estimate would only delay the body's acceleration
        dictionary& solver = result.subDict("solver");
        solver.set("addedMass", vector(Zero));
        solver.set("addedInertia", vector(Zero));
    }
    return result;
}


//- Share of the acceleration at the end of a step in the change of the velocity, of integrators that want it
scalar endWeight(const dictionary& coefficients)
{
    const dictionary solver(coefficients.subOrEmptyDict("solver"));
    const word type(solver.getOrDefault<word>("type", ""));
    const scalar share =
        type == "symplectic" ? 0.5
      : type == "Newmark" ? solver.getOrDefault<scalar>("gamma", 0.5)
      : type == "CrankNicolson" ? solver.getOrDefault<scalar>("aoc", 0.5)
      : 0;
    return share*coefficients.getOrDefault<scalar>("accelerationDamping", 1);
}


//- f(number) for each number of a state, in the order of a file
template<class State, class Function>
void forNumbers(State& s, const Function& f)
{
    const auto forComponents = [&](auto& value)
    {
        for (direction d = 0; d < value.size(); ++d)
        {
            f(value[d]);
        }
    };
    forComponents(s.motion.centreOfRotation());
    forComponents(s.motion.Q());
    forComponents(s.motion.v());
    forComponents(s.motion.a());
    forComponents(s.motion.pi());
    forComponents(s.motion.tau());
    forComponents(s.acceleration);
    forComponents(s.angularAcceleration);
    f(s.lastDeltaT);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::freeBody::freeBody
(
    const dictionary& coefficients,
    const Time& time,
    const vector& g
)
:
    motion_(checked(coefficients), coefficients, time),
    g_
    (
        IOobject("g", time.constant(), time),
        dimensionedVector("g", dimAcceleration, g)
    ),
    acceleration_(Zero),
    angularAcceleration_(Zero),
    lastDeltaT_(0),
    endWeight_(endWeight(coefficients)),
    freeTranslation_(Zero),
    freeRotation_(Zero)
{
    // The first call in a process is not relaxed: use it up, without a step
    const sixDoFRigidBodyMotionState start(motion_.state());
    motion_.update(true, Zero, Zero, 0, 0);

    // Which motions constraints leave, OpenFOAM tells nobody: what is left of unit ones
    for (direction d = 0; d < 3; ++d)
    {
        vector unit(Zero);
        unit[d] = 1;
        sixDoFRigidBodyMotionState& s = motionState();
        s = start;
        s.v() = s.pi() = unit;
        s.a() = s.tau() = Zero;
        motion_.newTime();
        motion_.update(true, Zero, Zero, 0, 0);
        for (direction i = 0; i < 3; ++i)
        {
            freeTranslation_(i, d) = s.v()[i];
            freeRotation_(i, d) = s.pi()[i];
        }
    }
    motionState() = start;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::sixDoFRigidBodyMotionState& Foam::freeBody::motionState()
{
    return const_cast<sixDoFRigidBodyMotionState&>(motion_.state());
}


Foam::vector Foam::freeBody::velocity() const
{
    return motion_.velocity(motion_.centreOfMass());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::freeBody::endLastStep(const vector& total, const vector& about)
{
    if (!(endWeight_ > 0))
    {
        return;
    }
    const sixDoFRigidBodyMotionState last(motion_.state());
    motion_.newTime();
    motion_.update(true, total, about, noStep, 0);
    const vector a(motion_.state().a()), tau(motion_.state().tau());
    sixDoFRigidBodyMotionState& s = motionState();
    s = last;
    s.v() += endWeight_*lastDeltaT_*(freeTranslation_ & (a - s.a()));
    s.pi() += endWeight_*lastDeltaT_*(freeRotation_ & (tau - s.tau()));
    s.a() = a;
    s.tau() = tau;
}


void Foam::freeBody::advance
(
    const vector& force,
    const vector& moment,
    const scalar deltaT
)
{
    const vector lastVelocity(velocity());
    const vector lastOmega(motion_.omega());

    // OpenFOAM takes moments about the centre of rotation
    const vector total(force + motion_.mass()*g_.value());
    const vector about(moment + (motion_.momentArm() ^ total));
    endLastStep(total, about);
    motion_.newTime();
    motion_.update(true, total, about, deltaT, deltaT);

    acceleration_ = (velocity() - lastVelocity)/deltaT;
    angularAcceleration_ = (motion_.omega() - lastOmega)/deltaT;
    lastDeltaT_ = deltaT;
}


Foam::bodyAcceleration Foam::freeBody::accelerationUnder(const vector& force, const vector& moment)
{
    const sixDoFRigidBodyMotionState now(motion_.state());
    const vector omega(motion_.omega());
    const vector total(force + motion_.mass()*g_.value());
    motion_.newTime();
    motion_.update(true, total, moment + (motion_.momentArm() ^ total), noStep, 0);
    const vector linear(freeTranslation_ & motion_.state().a());
    const vector torque(freeRotation_ & motion_.state().tau());
    motionState() = now;

    // In body axes I domega/dt = tau - omega x (I omega), of which constraints leave a part
    const tensor& Q = motion_.orientation();
    const diagTensor& I = motion_.momentOfInertia();
    const vector spin(Q.T() & omega);
    const vector change(torque - (freeRotation_ & (spin ^ (I & spin))));
    const vector angular(Q & vector(change.x()/I.xx(), change.y()/I.yy(), change.z()/I.zz()));
    const vector arm(motion_.centreOfMass() - motion_.centreOfRotation());
    return {linear + (angular ^ arm) + (omega ^ (omega ^ arm)), angular};
}


Foam::freeBody::fullState Foam::freeBody::state() const
{
    fullState s;
    s.centreOfMass = motion_.centreOfMass();
    s.orientation = motion_.orientation();
    s.velocity = velocity();
    s.omega = motion_.omega();
    s.acceleration = acceleration_;
    s.angularAcceleration = angularAcceleration_;
    s.motion = motion_.state();
    s.lastDeltaT = lastDeltaT_;
    return s;
}


void Foam::freeBody::setState(const fullState& s)
{
    motionState() = s.motion;
    acceleration_ = s.acceleration;
    angularAcceleration_ = s.angularAcceleration;
    lastDeltaT_ = s.lastDeltaT;
}


std::vector<double> Foam::freeBody::numbers() const
{
    std::vector<double> result;
    const fullState s(state());
    forNumbers(s, [&](const scalar x){ result.push_back(x); });
    return result;
}


void Foam::freeBody::set(const std::vector<double>& numbers)
{
    fullState s(state());
    std::size_t n = 0;
    forNumbers(s, [&](const scalar){ ++n; });
    if (numbers.size() != n)
    {
        FatalErrorInFunction
            << "The saved state of a body has " << label(numbers.size())
            << " numbers" << nl
            << "Expected: " << label(n) << '.' << exit(FatalError);
    }

    auto next = numbers.begin();
    forNumbers(s, [&](scalar& x){ x = *next++; });
    setState(s);
}

// ************************************************************************* //
