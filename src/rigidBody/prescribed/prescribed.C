// SPDX-License-Identifier: GPL-3.0-or-later

#include "prescribed.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace sixDoFSolvers
{
    defineTypeNameAndDebug(prescribed, 0);
    addToRunTimeSelectionTable(sixDoFSolver, prescribed, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- By an angle about the vector's direction [rad]
tensor rotation(const vector& angle)
{
    const scalar a = mag(angle);
    if (!(a > 0))
    {
        return tensor::I;
    }
    const vector n(angle/a);
    const tensor cross(0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0);
    return tensor::I + std::sin(a)*cross + 2*sqr(std::sin(0.5*a))*(cross & cross);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sixDoFSolvers::prescribed::prescribed
(
    const dictionary& dict,
    sixDoFRigidBodyMotion& body
)
:
    sixDoFSolver(dict, body)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sixDoFSolvers::prescribed::solve
(
    bool,
    const vector&,
    const vector&,
    scalar deltaT,
    scalar
)
{
    a() = Zero;
    tau() = Zero;
    v() = v0();
    pi() = pi0();
    centreOfRotation() = centreOfRotation0() + deltaT*v();
    Q() = Q0() & rotation(deltaT*(inv(body_.momentOfInertia()) & pi()));
}

// ************************************************************************* //
