// SPDX-License-Identifier: GPL-3.0-or-later

#include "compositeMesh.H"
#include "cellCellStencilObject.H"
#include "dynamicOversetFvMesh.H"
#include "foamVersion.H"
#include "fvc.H"
#include "fvm.H"
#include "fvMatrices.H"
#include "localMin.H"
#include "inputChecks.H"
#include "mapDistribute.H"
#include "oversetFvPatch.H"
#include "patchWave.H"
#include "processorFvPatchField.H"
#include "rigidZonesCellCellStencil.H"
#include "stopAfterWriting.H"
#include "wallPolyPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Bring all fields' values on the faces between processors up to date
template<class Type>
void exchange(const fvMesh& mesh)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    for (const fieldType* field : mesh.lookupClass<fieldType>())
    {
        foamVersion::correctBoundariesOf
        <
            dynamicOversetFvMesh,
            fieldType,
            processorFvPatchField<Type>
        >(const_cast<fieldType&>(*field));
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::compositeMesh::masks::masks(const fvMesh& mesh)
:
    cell
    (
        IOobject("cellMask", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false),
        mesh,
        dimensionedScalar("one", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    ),
    face
    (
        IOobject("faceMask", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false),
        mesh,
        dimensionedScalar("one", dimless, 1)
    ),
    faceOld
    (
        IOobject("faceMaskOld", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false),
        face
    ),
    straysAtStart(),
    nInterpolations(1)
{}


Foam::compositeMesh::compositeMesh(const fvMesh& mesh)
:
    mesh_(mesh),
    masks_(isA<dynamicOversetFvMesh>(mesh) ? new masks(mesh) : nullptr)
{
    if (!isOverset())
    {
        return;
    }

    // The mesh loads its stencil, but fills it only when it first moves
    const_cast<cellCellStencilObject&>(Stencil::New(mesh_)).update();

    // The last two only as they are written
    doNotInterpolate({masks_->cell.name(), "cellTypes", "zoneID"});
    setCellMask();
    setInterpolations();
    masks_->cell.oldTime();
    masks_->face = localMin<scalar>(mesh_).interpolate(masks_->cell);
    masks_->faceOld = masks_->face;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::compositeMesh::setCellMask()
{
    const labelUList& types = Stencil::New(mesh_).cellTypes();
    scalarField& mask = masks_->cell.primitiveFieldRef();

    forAll(mask, celli)
    {
        mask[celli] = (foamVersion::isHole<cellCellStencil>(types[celli]) ? 0 : 1);
    }
    masks_->cell.correctBoundaryConditions();
}


void Foam::compositeMesh::setInterpolations()
{
    const cellCellStencil& stencil = Stencil::New(mesh_);
    const labelUList& types = stencil.cellTypes();

    // Steps from calculated cells. Rings of acceptors that take from each other
    // have no end: they are left after a few
    const label most = 4;
    labelList steps(mesh_.nCells());
    forAll(steps, celli)
    {
        steps[celli] = types[celli] == cellCellStencil::INTERPOLATED;
    }
    label& longest = masks_->nInterpolations;
    label before = 0;
    for (longest = 1; longest > before && longest < most; )
    {
        before = longest;
        labelList known(steps);
        stencil.cellInterpolationMap().distribute(known);
        for (const label celli : stencil.interpolationCells())
        {
            if (steps[celli])
            {
                for (const label slot : stencil.cellStencil()[celli])
                {
                    steps[celli] = max(steps[celli], min(known[slot] + 1, most));
                }
            }
        }
        longest = max(before, gMax(steps));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::compositeMesh::maskOld(surfaceScalarField& field) const
{
    if (isOverset())
    {
        field *= masks_->faceOld;
    }
}


void Foam::compositeMesh::mask(volVectorField& field) const
{
    if (isOverset())
    {
        field *= masks_->cell;
    }
}


void Foam::compositeMesh::mask(volVectorField::Internal& field) const
{
    if (isOverset())
    {
        field *= masks_->cell();
    }
}


void Foam::compositeMesh::mask(surfaceScalarField& field) const
{
    if (isOverset())
    {
        field *= masks_->face;
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::compositeMesh::masked(const surfaceScalarField& field) const
{
    if (isOverset())
    {
        return masks_->face*field;
    }
    return field;
}


void Foam::compositeMesh::maskCalculated(scalarField& field) const
{
    if (isOverset())
    {
        field *= calculatedCells();
    }
}


void Foam::compositeMesh::setUncovered(surfaceVectorField& Uf, const volVectorField& U) const
{
    if (!isOverset())
    {
        return;
    }
    const surfaceVectorField Uint(fvc::interpolate(U));
    const surfaceScalarField& old = masks_->faceOld;
    Uf = old*Uf + (scalar(1) - old)*Uint;
    forAll(Uf.boundaryField(), patchi)
    {
        // Faces between processors are faces inside the mesh
        if (!Uf.boundaryField()[patchi].coupled())
        {
            Uf.boundaryFieldRef()[patchi] = Uint.boundaryField()[patchi];
        }
    }
}


Foam::tmp<Foam::scalarField> Foam::compositeMesh::calculatedCells() const
{
    const labelUList& types = Stencil::New(mesh_).cellTypes();
    auto tcalculated = tmp<scalarField>::New(mesh_.nCells());
    scalarField& calculated = tcalculated.ref();

    forAll(calculated, celli)
    {
        calculated[celli] =
            (foamVersion::isCalculated<cellCellStencil>(types[celli]) ? 1 : 0);
    }
    return tcalculated;
}


Foam::tmp<Foam::scalarField> Foam::compositeMesh::donorCells() const
{
    const cellCellStencil& stencil = Stencil::New(mesh_);
    const mapDistribute& map = stencil.cellInterpolationMap();

    // Slots that are used, back to where they come from
    scalarField used(map.constructSize(), Zero);
    for (const label celli : stencil.interpolationCells())
    {
        for (const label slot : stencil.cellStencil()[celli])
        {
            used[slot] = 1;
        }
    }
    foamVersion::reverseCombine<mapDistributeBase>
    (
        map, mesh_.nCells(), used, maxEqOp<scalar>(), scalar(0)
    );
    return used*calculatedCells();
}


const Foam::labelList& Foam::compositeMesh::zoneID() const
{
    if (!isOverset())
    {
        return labelList::null();
    }
    return cellCellStencil::zoneID(mesh_);
}


Foam::label Foam::compositeMesh::nZones() const
{
    return gMax(zoneID()) + 1;
}


Foam::boundBox Foam::compositeMesh::backgroundBounds() const
{
    if (!isOverset())
    {
        return mesh_.bounds();
    }
    const labelList& zones = zoneID();
    boundBox box;
    forAll(zones, celli)
    {
        if (zones[celli] == 0)
        {
            box.add(mesh_.points(), mesh_.cellPoints()[celli]);
        }
    }
    box.reduce();
    return box;
}


void Foam::compositeMesh::doNotInterpolate(const wordList& fieldNames) const
{
    if (!isOverset())
    {
        return;
    }
    // The stencil offers its list only as const through the mesh object
    const_cast<wordHashSet&>
    (
        Stencil::New(mesh_).nonInterpolatedFields()
    ).insert(fieldNames);
}


void Foam::compositeMesh::update()
{
    if (!isOverset())
    {
        return;
    }

    // The mesh has interpolated the fields' cells alone
    if (Pstream::parRun())
    {
        exchange<scalar>(mesh_);
        exchange<vector>(mesh_);
    }

    setCellMask();
    setInterpolations();
    masks_->face = localMin<scalar>(mesh_).interpolate(masks_->cell);
    masks_->faceOld = localMin<scalar>(mesh_).interpolate(masks_->cell.oldTime());
}


bool Foam::compositeMesh::isInFlow(const point& p) const
{
    const labelUList& types = Stencil::New(mesh_).cellTypes();
    bool found = false;
    forAll(types, celli)
    {
        if (found || types[celli] == cellCellStencil::HOLE)
        {
            continue;
        }
        // On a face is inside, to round-off
        const scalar roundOff = 1e-6*cbrt(mesh_.cellVolumes()[celli]);
        bool inside = true;
        for (const label facei : mesh_.cells()[celli])
        {
            const scalar outwards =
                ((p - mesh_.faceCentres()[facei]) & mesh_.faceAreas()[facei])
               *(mesh_.faceOwner()[facei] == celli ? 1 : -1);
            if (outwards > roundOff*mag(mesh_.faceAreas()[facei]))
            {
                inside = false;
                break;
            }
        }
        found = inside;
    }
    return returnReduce(found, orOp<bool>());
}


Foam::label Foam::compositeMesh::calculatedCell(const point& p) const
{
    const labelUList& types = Stencil::New(mesh_).cellTypes();
    const pointField& C = mesh_.cellCentres();

    zoneSearch::hit best{-1, Zero, GREAT};
    forAll(types, celli)
    {
        if (types[celli] == cellCellStencil::CALCULATED)
        {
            const zoneSearch::hit other{celli, C[celli], magSqr(C[celli] - p)};
            if (best.cell == -1 || other.isBefore(best))
            {
                best = other;
            }
        }
    }

    typedef Tuple2<scalar, point> place;
    List<place> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = place(best.distance, best.centre);
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    for (label proci = 0; proci < all.size(); ++proci)
    {
        const zoneSearch::hit other{0, all[proci].second(), all[proci].first()};
        if (proci != Pstream::myProcNo() && other.isBefore(best))
        {
            return -1;
        }
    }
    return best.cell;
}


void Foam::compositeMesh::setReferences(fvScalarMatrix& eqn) const
{
    const labelUList& types = Stencil::New(mesh_).cellTypes();
    const labelList& zones = zoneID();

    // The lowest processor that has a calculated cell of a zone sets it
    const label n = nZones();
    labelList firstCell(n, -1);
    forAllReverse(zones, celli)
    {
        if (types[celli] == cellCellStencil::CALCULATED)
        {
            firstCell[zones[celli]] = celli;
        }
    }

    labelList owner(n, labelMax);
    forAll(owner, zonei)
    {
        if (firstCell[zonei] != -1)
        {
            owner[zonei] = Pstream::myProcNo();
        }
    }
    Pstream::listCombineGather(owner, minEqOp<label>());
    Pstream::listCombineScatter(owner);

    labelList cells;
    forAll(owner, zonei)
    {
        if (owner[zonei] == Pstream::myProcNo())
        {
            cells.append(firstCell[zonei]);
        }
    }
    eqn.setReferences(cells, scalar(0), true);
}


void Foam::compositeMesh::checkHoles() const
{
    if (!isOverset())
    {
        return;
    }

    const labelUList& types = Stencil::New(mesh_).cellTypes();
    const labelList& zones = zoneID();
    const pointField& C = mesh_.cellCentres();

    List<boundBox> bounds(nZones());
    forAll(zones, celli)
    {
        bounds[zones[celli]].add(C[celli]);
    }
    for (boundBox& b : bounds)
    {
        b.reduce();
        b.inflate(0.05);
    }

    label nLeaked = 0;
    forAll(zones, celli)
    {
        if (foamVersion::isHole<cellCellStencil>(types[celli]))
        {
            bool covered = false;
            forAll(bounds, zonei)
            {
                covered =
                    covered
                 || (zonei != zones[celli] && bounds[zonei].contains(C[celli]));
            }
            nLeaked += !covered;
        }
    }

    if (returnReduce(nLeaked, sumOp<label>()))
    {
        FatalErrorInFunction
            << returnReduce(nLeaked, sumOp<label>()) << " cells that no other"
            << " overset zone covers are holes: the cutting of the holes has"
            << " leaked out of the body." << nl
            << "Expected: several cells across the body in every zone; for"
            << " trackingInverseDistance also voxels"
            << " (system/fvSchemes::oversetInterpolation::searchBoxDivisions)"
            << " that are smaller than the body." << exit(FatalError);
    }
}


Foam::compositeMesh::fringe Foam::compositeMesh::theFringe() const
{
    const labelUList& types = Stencil::New(mesh_).cellTypes();
    const labelList& zones = zoneID();
    const label n = nZones();

    fringe f{labelList(n, Zero), labelList(n, Zero), List<DynamicList<point>>(n)};
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (isA<oversetFvPatch>(patch))
        {
            for (const label celli : patch.faceCells())
            {
                ++f.all[zones[celli]];
                if (types[celli] != cellCellStencil::INTERPOLATED)
                {
                    ++f.strays[zones[celli]];
                    f.centres[zones[celli]].append(mesh_.cellCentres()[celli]);
                }
            }
        }
    }
    for (labelList* counts : {&f.all, &f.strays})
    {
        Pstream::listCombineGather(*counts, plusEqOp<label>());
        Pstream::listCombineScatter(*counts);
    }
    return f;
}


bool Foam::compositeMesh::isExact() const
{
    return
        mesh_.schemesDict().subDict("oversetInterpolation").get<word>("method")
     == cellCellStencils::rigidZones::typeName;
}


void Foam::compositeMesh::stopAt(const label zone, const fringe& f) const
{
    // The one that is furthest out, in whatever direction
    const boundBox domain(backgroundBounds());
    const point middle(domain.centre());
    point where(middle);
    for (const point& p : f.centres[zone])
    {
        where = magSqr(p - middle) > magSqr(where - middle) ? p : where;
    }
    List<point> furthest(Pstream::nProcs());
    furthest[Pstream::myProcNo()] = where;
    Pstream::gatherList(furthest);
    Pstream::scatterList(furthest);
    for (const point& p : furthest)
    {
        where = magSqr(p - middle) > magSqr(where - middle) ? p : where;
    }

    // OpenFOAM's own methods lose donors where zones overlap too little, too
    const bool leaves = isExact() || !domain.contains(where);
    stopAfterWriting
    (
        mesh_,
        text
        (
            "Overset zone ", zone, " (field zoneID) ", leaves ? "leaves" : "overlaps too little with", " the background: of the ",
            f.all[zone], " cells at its overset patches ", f.strays[zone],
            " find no donor there, one of them at ", where,
            ". The background spans ", domain, "."
        ),
        !leaves ? "five cells of the background, or more, between the body and the outer boundary of its mesh."
      : "a body whose mesh stays within the background. A background that is larger there, a shorter run, or a function object that ends"
        " it before (plungeEvent); walls hold no body back."
    );
}


void Foam::compositeMesh::checkDonors()
{
    if (!isOverset())
    {
        return;
    }

    const fringe f(theFringe());
    masks_->straysAtStart = f.strays;
    forAll(f.all, zonei)
    {
        if (!f.strays[zonei])
        {
            continue;
        }
        if (f.strays[zonei] == f.all[zonei])
        {
            FatalErrorInFunction
                << "Overset zone " << zonei << " (field zoneID): none of the "
                << f.all[zonei] << " cells at its overset patches finds"
                << " a donor in another zone." << nl
                << "Expected: a zone that lies inside the background zone 0"
                << " and cells not much smaller than its own; check the"
                << " position of the mesh, zoneID in the start time, and"
                << " searchBox in system/fvSchemes::oversetInterpolation."
                << exit(FatalError);
        }
        if (isExact())
        {
            stopAt(zonei, f);
        }
        WarningInFunction
            << "Overset zone " << zonei << ": "
            << f.strays[zonei] << " of "
            << f.all[zonei] << " cells at its overset patches find"
            << " no donor and keep a zero gradient." << endl;
    }
    noteOverlap();
}


void Foam::compositeMesh::noteOverlap() const
{
    const labelList& zones = zoneID();
    const auto& stencil = Stencil::New(mesh_);

    // Of a cell its volume, and of the area that it shows along each coordinate
    scalarField volume(mesh_.V().field());
    vectorField shown(mesh_.nCells(), Zero);
    for (label facei = 0; facei < mesh_.nFaces(); ++facei)
    {
        const vector half(0.5*cmptMag(mesh_.faceAreas()[facei]));
        shown[mesh_.faceOwner()[facei]] += half;
        if (mesh_.isInternalFace(facei))
        {
            shown[mesh_.faceNeighbour()[facei]] += half;
        }
    }
    stencil.cellInterpolationMap().distribute(volume);
    stencil.cellInterpolationMap().distribute(shown);

    labelHashSet walls;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<wallPolyPatch>(patch))
        {
            walls.insert(patch.index());
        }
    }
    const patchWave wave(mesh_, walls);

    // From the body's walls to the overset boundary about it, in cells of the background
    scalarField least(nZones(), GREAT);
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (!isA<oversetFvPatch>(patch))
        {
            continue;
        }
        const vectorField n(patch.nf());
        forAll(patch, i)
        {
            const label celli = patch.faceCells()[i];
            const scalar distance = wave.distance()[celli] + ((patch.Cf()[i] - mesh_.cellCentres()[celli]) & n[i]);
            for (const label slot : stencil.cellStencil()[celli])
            {
                const scalar size = volume[slot]/max(shown[slot] & cmptMag(n[i]), VSMALL);
                least[zones[celli]] = min(least[zones[celli]], distance/size);
            }
        }
    }
    Pstream::listCombineGather(least, minEqOp<scalar>());
    Pstream::listCombineScatter(least);

    // OpenFOAM's methods put their holes further out
    const scalar needed = isExact() ? 4 : 5;
    forAll(least, zonei)
    {
        // Cells are counted from one middle to another
        if (least[zonei] < needed - 0.25)
        {
            Info<< nl << text
                (
                    "Note: Between the body of overset zone ", zonei, " and the outer boundary of its mesh there are ", least[zonei],
                    " cells of the background; expected ", needed, " or more: forces may come out far wrong, and in a closed tank the run"
                    " may diverge."
                ).c_str() << nl << endl;
        }
    }
}


void Foam::compositeMesh::checkZones() const
{
    if (!isOverset())
    {
        return;
    }

    fringe f(theFringe());
    forAll(f.all, zonei)
    {
        if (f.strays[zonei] <= masks_->straysAtStart[zonei])
        {
            continue;
        }
        if (!isExact() && f.strays[zonei] < f.all[zonei])
        {
            // Those that found none for want of suitable cells do not count
            const boundBox domain(backgroundBounds());
            DynamicList<point> outside;
            for (const point& p : f.centres[zonei])
            {
                if (!domain.contains(p))
                {
                    outside.append(p);
                }
            }
            f.centres[zonei].transfer(outside);
            f.strays[zonei] = returnReduce(f.centres[zonei].size(), sumOp<label>());
            if (f.strays[zonei] <= masks_->straysAtStart[zonei])
            {
                continue;
            }
        }
        stopAt(zonei, f);
    }
}

// ************************************************************************* //
