// SPDX-License-Identifier: GPL-3.0-or-later

#include "followedBody.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "pointPatchDist.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(followedBody, 0);
    addToRunTimeSelectionTable(motionSolver, followedBody, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::followedBody::followedBody(const polyMesh& mesh, const IOdictionary& dict)
:
    sixDoFRigidBodyMotionSolver(mesh, dict),
    share_(mesh.nPoints())
{
    // As that of sixDoFRigidBodyMotionSolver, which keeps it to itself
    const scalar inner = coeffDict().get<scalar>("innerDistance");
    const scalar outer = coeffDict().get<scalar>("outerDistance");
    const labelHashSet patches(mesh.boundaryMesh().patchSet(coeffDict().get<wordRes>("patches")));
    const pointPatchDist distance(pointMesh::New(mesh), patches, points0());
    share_ = min(max((outer - distance.primitiveField())/(outer - inner), scalar(0)), scalar(1));
    share_ = 0.5 - 0.5*cos(constant::mathematical::pi*share_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::followedBody::solve()
{
    sixDoFRigidBodyMotionSolver::solve();

    const vector travel = motion().centreOfMass() - motion().initialCentreOfMass();
    pointDisplacement_.primitiveFieldRef() += (1 - share_)*travel;
}

// ************************************************************************* //
