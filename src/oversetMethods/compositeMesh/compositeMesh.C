// SPDX-License-Identifier: GPL-3.0-or-later

#include "compositeMesh.H"
#include "cellCellStencilObject.H"
#include "dynamicOversetFvMesh.H"
#include "fvScalarMatrix.H"
#include "localMin.H"
#include "mapDistribute.H"
#include "oversetFvPatch.H"
#include "processorFvPatchField.H"
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
        dynamicOversetFvMesh::correctBoundaryConditions
        <
            fieldType,
            processorFvPatchField<Type>
        >(const_cast<fieldType*>(field)->boundaryFieldRef(false), true);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::compositeMesh::compositeMesh(const fvMesh& mesh)
:
    mesh_(mesh),
    cellMask_
    (
        IOobject
        (
            "cellMask",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar("one", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    ),
    faceMask_
    (
        IOobject
        (
            "faceMask",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar("one", dimless, 1)
    ),
    faceMaskOld_
    (
        IOobject
        (
            "faceMaskOld",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        faceMask_
    )
{
    // The mesh loads its stencil, but fills it only when it first moves
    const_cast<cellCellStencilObject&>(Stencil::New(mesh_)).update();

    doNotInterpolate({cellMask_.name()});
    setCellMask();
    cellMask_.oldTime();
    faceMask_ = localMin<scalar>(mesh_).interpolate(cellMask_);
    faceMaskOld_ = faceMask_;
}


Foam::autoPtr<Foam::compositeMesh> Foam::compositeMesh::New(const fvMesh& mesh)
{
    if (isA<dynamicOversetFvMesh>(mesh))
    {
        return autoPtr<compositeMesh>::New(mesh);
    }
    return nullptr;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::compositeMesh::setCellMask()
{
    const labelUList& types = Stencil::New(mesh_).cellTypes();
    scalarField& mask = cellMask_.primitiveFieldRef();

    forAll(mask, celli)
    {
        mask[celli] = (types[celli] == cellCellStencil::HOLE ? 0 : 1);
    }
    cellMask_.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::compositeMesh::calculatedCells() const
{
    const labelUList& types = Stencil::New(mesh_).cellTypes();
    auto tcalculated = tmp<scalarField>::New(mesh_.nCells());
    scalarField& calculated = tcalculated.ref();

    forAll(calculated, celli)
    {
        calculated[celli] =
            (types[celli] == cellCellStencil::CALCULATED ? 1 : 0);
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
    mapDistributeBase::distribute
    (
        Pstream::commsTypes::nonBlocking,
        List<labelPair>(),
        mesh_.nCells(),
        map.constructMap(),
        false,
        map.subMap(),
        false,
        used,
        maxEqOp<scalar>(),
        flipOp(),
        scalar(0)
    );
    return used*calculatedCells();
}


const Foam::labelList& Foam::compositeMesh::zoneID() const
{
    return cellCellStencil::zoneID(mesh_);
}


Foam::label Foam::compositeMesh::nZones() const
{
    return gMax(zoneID()) + 1;
}


Foam::boundBox Foam::compositeMesh::backgroundBounds() const
{
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
    // The stencil offers its list only as const through the mesh object
    const_cast<wordHashSet&>
    (
        Stencil::New(mesh_).nonInterpolatedFields()
    ).insert(fieldNames);
}


void Foam::compositeMesh::update()
{
    // The mesh has interpolated the fields' cells alone
    if (Pstream::parRun())
    {
        exchange<scalar>(mesh_);
        exchange<vector>(mesh_);
    }

    setCellMask();
    faceMask_ = localMin<scalar>(mesh_).interpolate(cellMask_);
    faceMaskOld_ = localMin<scalar>(mesh_).interpolate(cellMask_.oldTime());
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
        if (types[celli] == cellCellStencil::HOLE)
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


void Foam::compositeMesh::checkDonors() const
{
    const labelUList& types = Stencil::New(mesh_).cellTypes();
    const labelList& zones = zoneID();

    labelList atBoundary(nZones(), Zero);
    labelList found(nZones(), Zero);
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (isA<oversetFvPatch>(patch))
        {
            for (const label celli : patch.faceCells())
            {
                ++atBoundary[zones[celli]];
                if (types[celli] == cellCellStencil::INTERPOLATED)
                {
                    ++found[zones[celli]];
                }
            }
        }
    }
    Pstream::listCombineGather(atBoundary, plusEqOp<label>());
    Pstream::listCombineScatter(atBoundary);
    Pstream::listCombineGather(found, plusEqOp<label>());
    Pstream::listCombineScatter(found);

    forAll(atBoundary, zonei)
    {
        if (atBoundary[zonei] && !found[zonei])
        {
            FatalErrorInFunction
                << "Overset zone " << zonei << " (field zoneID): none of the "
                << atBoundary[zonei] << " cells at its overset patches finds"
                << " a donor in another zone." << nl
                << "Expected: a zone that lies inside the background zone 0"
                << " and cells not much smaller than its own; check the"
                << " position of the mesh, zoneID in the start time, and"
                << " searchBox in system/fvSchemes::oversetInterpolation."
                << exit(FatalError);
        }
        if (found[zonei] < atBoundary[zonei])
        {
            WarningInFunction
                << "Overset zone " << zonei << ": "
                << atBoundary[zonei] - found[zonei] << " of "
                << atBoundary[zonei] << " cells at its overset patches find"
                << " no donor and keep a zero gradient." << endl;
        }
    }
}

// ************************************************************************* //
