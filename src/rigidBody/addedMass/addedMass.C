// SPDX-License-Identifier: GPL-3.0-or-later

#include "addedMass.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace sixDoFSolvers
{
    defineTypeNameAndDebug(addedMass, 0);
    addToRunTimeSelectionTable(sixDoFSolver, addedMass, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- (inertia + added) x_new = inertia x + added x_last, in body axes
vector blend
(
    const vector& inertia,
    const vector& added,
    const vector& x,
    const vector& xLast
)
{
    return cmptDivide
    (
        cmptMultiply(inertia, x) + cmptMultiply(added, xLast),
        inertia + added
    );
}


vector readEstimate(const dictionary& dict, const word& name)
{
    const vector estimate(dict.get<vector>(name));
    if (cmptMin(estimate) < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << name << " is " << estimate << nl
            << "Expected: three values that are not negative."
            << exit(FatalIOError);
    }
    return estimate;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sixDoFSolvers::addedMass::addedMass
(
    const dictionary& dict,
    sixDoFRigidBodyMotion& body
)
:
    sixDoFSolver(dict, body),
    addedMass_(readEstimate(dict, "addedMass")),
    addedInertia_(readEstimate(dict, "addedInertia"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sixDoFSolvers::addedMass::solve
(
    bool,
    const vector& fGlobal,
    const vector& tauGlobal,
    scalar deltaT,
    scalar
)
{
    const vector aLast(a());
    const vector tauLast(tau());

    // Force over mass and torque, with the restraints
    updateAcceleration(fGlobal, tauGlobal);

    const diagTensor& I = body_.momentOfInertia();
    a() =
        tConstraints()
      & (
            Q()
          & blend
            (
                vector::uniform(body_.mass()),
                addedMass_,
                Q().T() & a(),
                Q().T() & aLast
            )
        );
    tau() =
        rConstraints()
      & blend(vector(I.xx(), I.yy(), I.zz()), addedInertia_, tau(), tauLast);

    v() = tConstraints() & (v0() + aDamp()*deltaT*a());
    centreOfRotation() = centreOfRotation0() + deltaT*v();

    const Tuple2<tensor, vector> Qpi =
        rotate(Q0(), rConstraints() & (pi0() + aDamp()*deltaT*tau()), deltaT);
    Q() = Qpi.first();
    pi() = rConstraints() & Qpi.second();
}

// ************************************************************************* //
