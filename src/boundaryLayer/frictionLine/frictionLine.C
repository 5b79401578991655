// SPDX-License-Identifier: GPL-3.0-or-later

#include "frictionLine.H"
#include "bodyMotion.H"
#include "fvm.H"
#include "incompressibleTwoPhaseMixture.H"
#include "indexedOctree.H"
#include "PatchTools.H"
#include "pointIOField.H"
#include "treeDataPoint.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(frictionLine, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- How far from the wall cells belong to it, of its extent: 1.5 thicknesses of
//  a laminar layer at Re 2e3, where layers cease to be thin
const scalar reachOfLayer = 0.17;

//- Distance of the layer's edge, in its thicknesses. Beyond 1 since the layer
//  grows where the body tapers
const scalar edgeDistance = 1.5;

//- Below this part of the edge's speed, at which the layer has left the wall,
//  the stress falls to zero with the speed at the wall
const scalar attached = 0.2;

// Cebeci and Smith 1974; shape factor delta*/theta of a turbulent layer at the
// Reynolds numbers of ships and vehicles
const scalar kappa = 0.4, clauser = 0.0168, shapeFactor = 1.3;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::frictionLine::nFaces() const
{
    label n = 0;
    for (const label patchi : patches_)
    {
        n += mesh_.boundary()[patchi].size();
    }
    return n;
}


Foam::labelList Foam::frictionLine::wallFaces() const
{
    labelList faces(nFaces());
    label n = 0;
    for (const label patchi : patches_)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        forAll(patch, i)
        {
            faces[n++] = patch.start() + i;
        }
    }
    return faces;
}


Foam::pointField Foam::frictionLine::meshedPoints() const
{
    return pointIOField
    (
        IOobject
        (
            "points",
            mesh_.facesInstance(),
            polyMesh::meshSubDir,
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
}


void Foam::frictionLine::setStreamlines(const pointField& points)
{
    const indirectPrimitivePatch walls
    (
        IndirectList<face>(mesh_.faces(), wallFaces()),
        points
    );
    // gatherAndMerge takes all points of a patch's mesh: give it no others
    const primitivePatch compact
    (
        SubList<face>(walls.localFaces(), walls.size()),
        walls.localPoints()
    );

    pointField mergedPoints;
    faceList mergedFaces;
    labelList mergedMap;
    PatchTools::gatherAndMerge
    (
        1e-7*mesh_.bounds().mag(),
        compact,
        mergedPoints,
        mergedFaces,
        mergedMap
    );
    if (Pstream::master())
    {
        streamlines_.reset(new wallStreamlines(mergedFaces));
    }
}


void Foam::frictionLine::setNearWall
(
    const pointField& points,
    const labelUList& zones
)
{
    const labelList walls(wallFaces());

    // Centres and normals, on all processors
    pointField centres(faces_.size());
    vectorField normals(faces_.size());
    {
        pointField localCentres(walls.size());
        vectorField localNormals(walls.size());
        forAll(walls, i)
        {
            const face& f = mesh_.faces()[walls[i]];
            localCentres[i] = f.centre(points);
            localNormals[i] = f.unitNormal(points);
        }
        faces_.gather(localCentres, centres);
        faces_.gather(localNormals, normals);
        Pstream::scatter(centres);
        Pstream::scatter(normals);
    }

    label wallZone = -1;
    if (zones.size() && walls.size())
    {
        wallZone = zones[mesh_.faceOwner()[walls[0]]];
    }
    reduce(wallZone, maxOp<label>());

    boundBox box(centres, false);
    const scalar reach = reachOfLayer*box.mag();
    box.min() -= vector::uniform(reach);
    box.max() += vector::uniform(reach);

    const indexedOctree<treeDataPoint> tree
    (
        treeDataPoint(centres),
        treeBoundBox(box),
        10,
        10,
        3
    );

    DynamicList<label> cells, faces;
    DynamicList<scalar> distances;
    forAll(mesh_.cells(), celli)
    {
        if (zones.size() && zones[celli] != wallZone)
        {
            continue;
        }
        const point C(mesh_.cells()[celli].centre(points, mesh_.faces()));
        if (!box.contains(C))
        {
            continue;
        }
        label nearest = tree.findNearest(C, GREAT).index();
        scalar y = normals[nearest] & (centres[nearest] - C);
        if (y <= 0)
        {
            // The other side of a wall without thickness
            for
            (
                const label twin
              : tree.findSphere(centres[nearest], sqr(1e-6*reach))
            )
            {
                const scalar yTwin = normals[twin] & (centres[twin] - C);
                if (yTwin > 0)
                {
                    nearest = twin;
                    y = yTwin;
                    break;
                }
            }
        }
        if (y > 0 && y < reach)
        {
            cells.append(celli);
            faces.append(nearest);
            distances.append(y);
        }
    }
    near_.reach = reach;
    near_.cells.transfer(cells);
    near_.faces.transfer(faces);
    near_.distances.transfer(distances);
}


Foam::tmp<Foam::vectorField> Foam::frictionLine::wallVelocity
(
    const pointField& points
) const
{
    return
        body_
      ? body_->velocity(points)
      : tmp<vectorField>::New(points.size(), Zero);
}


Foam::tmp<Foam::vectorField> Foam::frictionLine::slip() const
{
    auto tslip = tmp<vectorField>::New(nFaces());
    vectorField& slip = tslip.ref();
    label n = 0;
    for (const label patchi : patches_)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const vectorField nf(patch.nf());
        const vectorField u
        (
            patch.patchInternalField(U_.primitiveField())
          - wallVelocity(patch.Cf())
        );
        forAll(patch, i)
        {
            slip[n++] = u[i] - nf[i]*(nf[i] & u[i]);
        }
    }
    return tslip;
}


Foam::tmp<Foam::scalarField> Foam::frictionLine::lengths
(
    const vectorField& slip
) const
{
    vectorField centres(slip.size());
    label n = 0;
    for (const label patchi : patches_)
    {
        for (const vector& C : mesh_.boundary()[patchi].Cf())
        {
            centres[n++] = C;
        }
    }

    vectorField allCentres, allSlip;
    faces_.gather(centres, allCentres);
    faces_.gather(slip, allSlip);

    auto tlengths = tmp<scalarField>::New();
    if (Pstream::master())
    {
        tlengths = streamlines_->lengths(allCentres, allSlip);
    }
    Pstream::scatter(tlengths.ref());
    return tlengths;
}


Foam::tmp<Foam::scalarField> Foam::frictionLine::edgeSpeeds
(
    const scalarField& lengths,
    const vectorField& slip,
    const scalarField& nu1
) const
{
    const scalarField& alpha = mixture_.alpha1().primitiveField();
    const labelList walls(wallFaces());

    // Where the layer ends
    scalarField edges(faces_.size(), Zero);
    scalarField speeds(faces_.size(), Zero);
    forAll(walls, i)
    {
        const label facei = faces_.toGlobal(i);
        const scalar nu = max(nu1[mesh_.faceOwner()[walls[i]]], VSMALL);
        speeds[facei] = mag(slip[i]);
        edges[facei] =
            edgeDistance*lengths[facei]
           *law_.thickness(speeds[facei]*lengths[facei]/nu);
    }
    Pstream::listCombineGather(edges, maxEqOp<scalar>());
    Pstream::listCombineScatter(edges);

    // The nearest wet cell beyond it; where there is none, the furthest; on a
    // dry wall the cell there
    const pointField C(mesh_.cellCentres(), near_.cells);
    const vectorField Uw(wallVelocity(C));
    scalarField nearest(faces_.size(), GREAT);
    forAll(near_.cells, i)
    {
        const label celli = near_.cells[i];
        const label facei = near_.faces[i];
        const scalar beyond = near_.distances[i] - edges[facei];
        const scalar rank = beyond >= 0 ? beyond : near_.reach - beyond;
        if (rank < nearest[facei] && alpha[celli] > 0.5)
        {
            nearest[facei] = rank;
            speeds[facei] = mag(U_[celli] - Uw[i]);
        }
    }

    if (Pstream::parRun())
    {
        // Of the processors' candidates the nearest
        scalarField nearestOfAll(nearest);
        Pstream::listCombineGather(nearestOfAll, minEqOp<scalar>());
        Pstream::listCombineScatter(nearestOfAll);
        forAll(speeds, facei)
        {
            if (nearest[facei] > nearestOfAll[facei])
            {
                speeds[facei] = 0;
            }
        }
        Pstream::listCombineGather(speeds, maxEqOp<scalar>());
        Pstream::listCombineScatter(speeds);
    }
    return tmp<scalarField>::New(speeds);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::frictionLine::frictionLine
(
    const volVectorField& U,
    const surfaceScalarField& phi,
    const incompressibleTwoPhaseMixture& mixture,
    const bodyMotion* body,
    const scalar transitionReynolds,
    const labelList& patches,
    const labelUList& zones
)
:
    viscousStress
    (
        typeName,
        geometricOneField(),
        geometricOneField(),
        U,
        phi,
        phi,
        mixture,
        turbulenceModel::propertiesName
    ),
    mixture_(mixture),
    body_(body),
    law_(transitionReynolds),
    patches_(patches),
    faces_(nFaces()),
    streamlines_(),
    near_(),
    nut_
    (
        IOobject
        (
            "nut",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar(dimViscosity, Zero)
    ),
    stress_(patches.size())
{
    forAll(patches_, i)
    {
        stress_[i].setSize(mesh_.boundary()[patches_[i]].size(), Zero);
    }
    const pointField points(meshedPoints());
    setStreamlines(points);
    setNearWall(points, zones);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::frictionLine::read()
{
    return true;
}


void Foam::frictionLine::correct()
{
    viscousStress::correct();

    if (mesh_.topoChanging())
    {
        FatalErrorInFunction
            << "The mesh has changed its topology, which boundaryLayer"
            << " frictionLine (constant/sceneProperties) does not follow" << nl
            << "Expected: a mesh that keeps its cells, or another boundaryLayer."
            << exit(FatalError);
    }

    const vectorField slip(this->slip());
    const scalarField s(lengths(slip));
    const scalarField nu1(mixture_.nuModel1().nu()().primitiveField());
    const scalarField speeds(edgeSpeeds(s, slip, nu1));

    const volScalarField& alpha = mixture_.alpha1();
    const scalar rho1 = mixture_.rho1().value();

    label n = 0;
    forAll(patches_, i)
    {
        const fvPatch& patch = mesh_.boundary()[patches_[i]];
        const labelUList& cells = patch.faceCells();
        forAll(patch, j)
        {
            const label facei = faces_.toGlobal(n);
            const scalar u = speeds[facei];
            const scalar wetted = min(max(alpha[cells[j]], scalar(0)), scalar(1));
            const scalar Re = u*s[facei]/max(nu1[cells[j]], VSMALL);
            stress_[i][j] =
                wetted*0.5*rho1*sqr(u)*law_.local(Re)
               *slip[n]/max(max(mag(slip[n]), attached*u), VSMALL);
            ++n;
        }
    }

    scalarField& nut = nut_.primitiveFieldRef();
    nut = Zero;
    forAll(near_.cells, i)
    {
        const label celli = near_.cells[i];
        const label facei = near_.faces[i];
        const scalar y = near_.distances[i];
        const scalar u = speeds[facei];
        const scalar Re = u*s[facei]/max(nu1[celli], VSMALL);
        if (law_.turbulent(Re))
        {
            const scalar uTau = u*Foam::sqrt(law_.local(Re)/2);
            const scalar displacement = shapeFactor*law_.mean(Re)/2*s[facei];
            const scalar delta = law_.thickness(Re)*s[facei];
            const scalar intermittency = 1/(1 + 5.5*pow6(y/delta));
            nut[celli] =
                min(max(alpha[celli], scalar(0)), scalar(1))
               *min(kappa*uTau*y, clauser*u*displacement*intermittency);
        }
    }
    nut_.correctBoundaryConditions();
}


void Foam::frictionLine::validate()
{
    correct();
}


Foam::tmp<Foam::volScalarField> Foam::frictionLine::nut() const
{
    return nut_;
}


Foam::tmp<Foam::scalarField> Foam::frictionLine::nut(const label patchi) const
{
    return nut_.boundaryField()[patchi];
}


Foam::tmp<Foam::volScalarField> Foam::frictionLine::nuEff() const
{
    return volScalarField::New("nuEff", nu() + nut_);
}


Foam::tmp<Foam::scalarField> Foam::frictionLine::nuEff(const label patchi) const
{
    return nu(patchi) + nut_.boundaryField()[patchi];
}


Foam::tmp<Foam::volSymmTensorField> Foam::frictionLine::devRhoReff() const
{
    tmp<volSymmTensorField> tstress(viscousStress::devRhoReff());
    volSymmTensorField::Boundary& stress = tstress.ref().boundaryFieldRef();

    forAll(patches_, i)
    {
        const label patchi = patches_[i];
        const scalarField& alpha = mixture_.alpha1().boundaryField()[patchi];
        const scalarField rho
        (
            alpha*mixture_.rho1().value()
          + (scalar(1) - alpha)*mixture_.rho2().value()
        );
        // The force on the wall is Sf & stress
        stress[patchi] ==
            twoSymm(mesh_.boundary()[patchi].nf()()*(stress_[i]/rho));
    }
    return tstress;
}


Foam::tmp<Foam::fvVectorMatrix> Foam::frictionLine::divDevRhoReff
(
    const volScalarField& rho,
    volVectorField& U
) const
{
    tmp<fvVectorMatrix> teqn(viscousStress::divDevRhoReff(rho, U));
    vectorField& source = teqn.ref().source();

    forAll(patches_, i)
    {
        const fvPatch& patch = mesh_.boundary()[patches_[i]];
        const labelUList& cells = patch.faceCells();
        forAll(patch, j)
        {
            source[cells[j]] -= stress_[i][j]*patch.magSf()[j];
        }
    }
    return teqn;
}

// ************************************************************************* //
