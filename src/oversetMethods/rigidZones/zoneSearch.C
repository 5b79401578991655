// SPDX-License-Identifier: GPL-3.0-or-later

#include "zoneSearch.H"
#include "oversetFvPatch.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::zoneSearch::build()
{
    const fvMesh& zone = zone_.subMesh();
    reach_ = boundBox(zone.points(), true);
    reach_.inflate(1e-6);
    roundOff_ = 1e-10*reach_.mag();

    // Collective, and kept for the search of warped cells, which is not
    (void)zone.tetBasePtIs();

    if (!zone.nCells())
    {
        return;
    }

    // Of the whole zone, for a processor may have a single face of its boundary
    treeBoundBox tree(boundBox(zone.points(), false));
    tree.inflate(0.01);

    cells_.reset
    (
        new indexedOctree<treeDataCell>
        (
            treeDataCell(true, zone, polyMesh::FACE_PLANES),
            tree,
            10, 10, 5
        )
    );

    DynamicList<point> centres;
    DynamicList<bool> isOverset;
    for (const fvPatch& patch : zone.boundary())
    {
        const bool overset = isA<oversetFvPatch>(patch);
        if
        (
            (overset || !polyPatch::constraintType(patch.type()))
         && patch.name() != fvMeshSubset::exposedPatchName
        )
        {
            centres.append(patch.Cf());
            isOverset.append(boolList(patch.size(), overset));
        }
    }
    boundaryCentres_.transfer(centres);
    isOverset_.transfer(isOverset);
    if (boundaryCentres_.size())
    {
        boundary_.reset
        (
            new indexedOctree<treeDataPoint>
            (
                treeDataPoint(boundaryCentres_),
                tree,
                10, 10, 5
            )
        );
    }

    // Three points that are far apart
    const pointField& points = zone.points();
    anchors_.setSize(3);
    anchors_[0] = 0;
    const auto furthest = [&](const auto& distance)
    {
        label result = 0;
        forAll(points, pointi)
        {
            if (distance(points[pointi]) > distance(points[result]))
            {
                result = pointi;
            }
        }
        return result;
    };
    const point& a = points[anchors_[0]];
    anchors_[1] = furthest([&](const point& p){ return magSqr(p - a); });
    const vector along = normalised(points[anchors_[1]] - a);
    anchors_[2] = furthest([&](const point& p){ return magSqr((p - a) ^ along); });

    rotation_ = tensor::I;
    translation_ = Zero;
    bounds_ = boundBox(points, false);
}


Foam::tensor Foam::zoneSearch::axes(const UList<point>& points) const
{
    const point& a = points[anchors_[0]];
    const vector x = normalised(points[anchors_[1]] - a);
    const vector z = normalised(x ^ (points[anchors_[2]] - a));
    return tensor(x, z ^ x, z);
}


Foam::zoneSearch::hit Foam::zoneSearch::hitOf
(
    const label zoneCell,
    const point& p
) const
{
    const label celli = zone_.cellMap()[zoneCell];
    const point& centre = mesh_.cellCentres()[celli];
    return hit{celli, centre, magSqr(centre - p)};
}


Foam::label Foam::zoneSearch::side
(
    const label zoneCell,
    const point& r
) const
{
    const fvMesh& zone = zone_.subMesh();
    bool within = true;
    for (const label facei : zone.cells()[zoneCell])
    {
        const vector& Sf = zone.faceAreas()[facei];
        const scalar outwards =
            ((r - zone.faceCentres()[facei]) & Sf)
           *(zone.faceOwner()[facei] == zoneCell ? 1 : -1);

        if (sqr(outwards) <= sqr(roundOff_)*magSqr(Sf))
        {
            within = false;
        }
        else if (outwards > 0)
        {
            return 1;
        }
    }
    return within ? -1 : 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::zoneSearch::zoneSearch
(
    const fvMesh& mesh,
    const label zone,
    const labelList& zoneID
)
:
    mesh_(mesh),
    zone_(mesh, zone, zoneID),
    rotation_(tensor::I),
    translation_(Zero),
    bounds_(),
    reach_(),
    roundOff_(0)
{
    // Collective: processors without cells of the zone take part
    (void)zone_.subMesh().nGeometricD();
    build();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::zoneSearch::comesBefore
(
    const point& a,
    const point& b,
    const scalar roundOff
)
{
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (mag(a[d] - b[d]) > roundOff)
        {
            return a[d] < b[d];
        }
    }
    return false;
}


bool Foam::zoneSearch::hit::isBefore(const hit& other) const
{
    const scalar least = 1e-6*max(distance, other.distance);
    if (mag(distance - other.distance) > least)
    {
        return distance < other.distance;
    }
    return comesBefore(centre, other.centre, 1e-3*sqrt(least));
}



void Foam::zoneSearch::update()
{
    const pointField now(mesh_.points(), zone_.pointMap());
    const pointField& then = zone_.subMesh().points();
    bool rigid = true;

    if (cells_)
    {
        rotation_ = axes(now).T() & axes(then);
        translation_ = now[anchors_[0]] - (rotation_ & then[anchors_[0]]);

        const scalar tolerance = sqr(1e-8*bounds_.mag());
        forAll(now, pointi)
        {
            rigid =
                rigid
             && magSqr(reference(now[pointi]) - then[pointi]) <= tolerance;
        }
        bounds_ = boundBox(now, false);
    }

    if (!returnReduce(rigid, andOp<bool>()))
    {
        zone_.subMesh().movePoints(now);
        build();
    }
}


Foam::zoneSearch::hit Foam::zoneSearch::findCell(const point& p) const
{
    hit best{-1, Zero, GREAT};
    if (!cells_)
    {
        return best;
    }
    const point r(reference(p));
    if (!cells_->bb().contains(r))
    {
        return best;
    }
    const labelUList& zoneCells = cells_->shapes().cellLabels();
    const auto take = [&](const label zoneCell)
    {
        const hit other(hitOf(zoneCell, p));
        if (best.cell == -1 || other.isBefore(best))
        {
            best = other;
        }
    };

    label nFound = 0;
    bool atFace = false;
    for (const label i : cells_->findIndices(r))
    {
        const label where = side(zoneCells[i], r);
        if (where <= 0)
        {
            take(zoneCells[i]);
            ++nFound;
            atFace = atFace || where == 0;
        }
    }
    if (nFound && !atFace)
    {
        return best;
    }

    // Cells that share the face may be in other leaves of the tree
    const labelList near
    (
        cells_->findBox(treeBoundBox(r - roundOff_*vector::one, r + roundOff_*vector::one))
    );
    for (const label i : near)
    {
        if (side(zoneCells[i], r) <= 0)
        {
            take(zoneCells[i]);
        }
    }
    if (best.cell != -1)
    {
        return best;
    }

    // Tetrahedra fill the space between warped faces too
    const fvMesh& zone = zone_.subMesh();
    for (const label i : near)
    {
        if
        (
            zone.pointInCellBB(r, zoneCells[i])
         && zone.pointInCell(r, zoneCells[i], polyMesh::CELL_TETS)
        )
        {
            take(zoneCells[i]);
        }
    }
    return best;
}


Foam::scalar Foam::zoneSearch::nearestBoundary
(
    const point& p,
    bool& isInside
) const
{
    isInside = false;
    const point r(reference(p));
    if (!boundary_ || !reach_.contains(r))
    {
        return GREAT;
    }
    const pointIndexHit nearest(boundary_->findNearest(r, GREAT));
    isInside = !isOverset_[nearest.index()];
    return magSqr(nearest.hitPoint() - r);
}

// ************************************************************************* //
