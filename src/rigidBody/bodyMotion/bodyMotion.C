// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyMotion.H"
#include "bodyCoefficients.H"
#include "fixedGradientFvPatchFields.H"
#include "foamVersion.H"
#include "pointConstraint.H"
#include "sixDoFRigidBodyMotionConstraint.H"
#include "sixDoFRigidBodyMotionRestraint.H"
#include "sixDoFRigidBodyMotionSolver.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const sixDoFRigidBodyMotionSolver* findSolver(const fvMesh& mesh)
{
    const auto solvers(mesh.lookupClass<sixDoFRigidBodyMotionSolver>());
    if (solvers.size() > 1)
    {
        FatalErrorInFunction
            << solvers.size() << " bodies in constant/dynamicMeshDict: "
            << solvers.sortedToc() << nl
            << "Expected: one sixDoFRigidBodyMotion." << exit(FatalError);
    }
    return solvers.size() ? *solvers.begin() : nullptr;
}


const sixDoFRigidBodyMotionSolver& theSolver(const fvMesh& mesh)
{
    const sixDoFRigidBodyMotionSolver* solver = findSolver(mesh);
    if (!solver)
    {
        FatalErrorInFunction
            << "No body moves this mesh." << nl
            << "Expected: motionSolver (or solver) sixDoFRigidBodyMotion in"
            << " constant/dynamicMeshDict." << exit(FatalError);
    }
    return *solver;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::bodyLoads Foam::bodyMotion::patchForces::calculate
(
    const point& centre
)
{
    bodyLoads l;
    #if foamForcesAreVectors
    calcForcesMoments();
    l.pressure = sumPatchForcesP_;
    l.viscous = sumPatchForcesV_;
    #else
    calcForcesMoment();
    l.pressure = sum(force_[0]);
    l.viscous = sum(force_[1]);
    #endif
    l.moment = momentEff() + ((foamForcesOrigin - centre) ^ forceEff());
    return l;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyMotion::bodyMotion(const fvMesh& mesh)
:
    mesh_(mesh),
    motion_(theSolver(mesh).motion()),
    dict_(theSolver(mesh).coeffDict()),
    patches_(mesh.boundaryMesh().patchSet(dict_.get<wordRes>("patches"))),
    freeForces_(tensor::I),
    freeMoments_(tensor::I)
{
    pointConstraint forces;
    pointConstraint moments;
    for (const entry& e : dict_.subOrEmptyDict("constraints"))
    {
        if (e.isDict())
        {
            const auto constraint(sixDoFRigidBodyMotionConstraint::New(e.keyword(), e.dict(), motion_));
            constraint->constrainTranslation(forces);
            constraint->constrainRotation(moments);
        }
    }
    for (const entry& e : dict_.subOrEmptyDict("restraints"))
    {
        if (e.isDict())
        {
            restraints_.append(sixDoFRigidBodyMotionRestraint::New(e.keyword(), e.dict()));
        }
    }
    freeForces_ = forces.constraintTransformation();
    freeMoments_ = moments.constraintTransformation();
    checkBodyCoefficients(dict_);
    startStep();
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

// Where the type of its restraints is complete
Foam::bodyMotion::~bodyMotion() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::bodyMotion::found(const fvMesh& mesh)
{
    return findSolver(mesh);
}


void Foam::bodyMotion::check(const boundBox& domain) const
{
    if (patches_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "Entry patches " << dict_.get<wordRes>("patches")
            << " names no patch of the mesh." << nl
            << "Expected: one or more of " << mesh_.boundaryMesh().names()
            << exit(FatalIOError);
    }

    if (hasLaggingRestraints(dict_))
    {
        WarningInFunction
            << "solver " << integrator().get<word>("type") << " in " << dict_.name()
            << " takes restraints as they stood a time step before: a spring with little damping gains energy. Use addedMass or symplectic."
            << endl;
        // For the summary, too
        Info<< nl << "Run" << nl << "    Note: The integrator " << integrator().get<word>("type")
            << " takes the body's restraints as they stood a time step before: a spring with little damping gains energy." << nl << endl;
    }

    // What lies on a plane of symmetry or on an axis is on the boundary, to round-off
    boundBox about(domain);
    about.inflate(1e-9);
    const boundBox body(bounds());
    if (!about.contains(body))
    {
        FatalIOErrorInFunction(dict_)
            << "The body reaches outside the domain: its patches span "
            << body << nl
            << "Expected: a body inside " << domain << exit(FatalIOError);
    }
    if (!about.contains(motion_.centreOfMass()))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry centreOfMass: " << motion_.centreOfMass() << nl
            << "Expected: a point inside the domain " << domain
            << exit(FatalIOError);
    }
}


Foam::tmp<Foam::vectorField> Foam::bodyMotion::velocity
(
    const pointField& points
) const
{
    return velocity() + (omega() ^ (points - centreOfMass()));
}


Foam::bodyLoads Foam::bodyMotion::fluidLoads() const
{
    if (!forces_)
    {
        dictionary d;
        d.add("type", functionObjects::forces::typeName);
        d.add("patches", dict_.get<wordRes>("patches"));
        d.add("rho", dict_.lookupOrDefault<word>("rho", "rho"));
        d.add("rhoInf", dict_.lookupOrDefault<scalar>("rhoInf", 1));
        d.add("CofR", motion_.centreOfMass());
        forces_.reset(new patchForces("forces", mesh_, d));
    }

    return forces_->calculate(motion_.centreOfMass());
}


Foam::wordList Foam::bodyMotion::drivenTypes(const wordList& types) const
{
    wordList driven(types);
    for (const label patchi : patches_)
    {
        driven[patchi] = fixedGradientFvPatchScalarField::typeName;
    }
    return driven;
}


void Foam::bodyMotion::drive
(
    volScalarField& pressure,
    const surfaceScalarField& rRhof,
    const label patchi,
    const vectorField& wall
) const
{
    refCast<fixedGradientFvPatchScalarField>
    (
        pressure.boundaryFieldRef()[patchi]
    ).gradient() =
        -(wall & mesh_.boundary()[patchi].nf())/rRhof.boundaryField()[patchi];
}


Foam::boundBox Foam::bodyMotion::bounds() const
{
    boundBox box;
    for (const label patchi : patches_)
    {
        box.add(mesh_.boundaryMesh()[patchi].localPoints());
    }
    box.reduce();
    return box;
}


Foam::scalar Foam::bodyMotion::enclosedVolume() const
{
    // The boundary's normals point out of the flow, into the body. Each of the coordinates gives the volume, by Gauss, unless
    // the body is open to its side (at a plane of symmetry, at the ends of a slice) or has no face to it
    vector net(Zero);
    vector area(Zero);
    vector volume(Zero);
    for (const label patchi : patches_)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        net += sum(patch.Sf());
        area += sum(cmptMag(patch.Sf()));
        volume -= sum(cmptMultiply(patch.Cf(), patch.Sf()));
    }
    reduce(net, sumOp<vector>());
    reduce(area, sumOp<vector>());
    reduce(volume, sumOp<vector>());

    scalar all = 0;
    label n = 0;
    for (direction d = 0; d < 3; ++d)
    {
        if (area[d] > 1e-6*cmptSum(area) && mag(net[d]) < 1e-6*area[d])
        {
            all += volume[d];
            ++n;
        }
    }
    return n ? all/n : cmptSum(volume)/mesh_.nGeometricD();
}


Foam::scalar Foam::bodyMotion::reach(const vector& direction) const
{
    scalar furthest = -GREAT;
    for (const label patchi : patches_)
    {
        for (const point& p : mesh_.boundaryMesh()[patchi].localPoints())
        {
            furthest = max(furthest, p & direction);
        }
    }
    return returnReduce(furthest, maxOp<scalar>());
}

// ************************************************************************* //
