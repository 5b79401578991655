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
    if (!zone.nCells())
    {
        return;
    }

    const auto tree = [](const boundBox& box)
    {
        treeBoundBox result(box);
        result.inflate(0.01);
        return result;
    };

    cells_.reset
    (
        new indexedOctree<treeDataCell>
        (
            treeDataCell(true, zone, polyMesh::FACE_PLANES),
            tree(boundBox(zone.points(), false)),
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
                tree(boundBox(boundaryCentres_, false)),
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
    reach_()
{
    // Collective: processors without cells of the zone take part
    (void)zone_.subMesh().nGeometricD();
    (void)zone_.subMesh().tetBasePtIs();
    build();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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


Foam::label Foam::zoneSearch::findCell(const point& p) const
{
    if (!cells_)
    {
        return -1;
    }
    const point r(reference(p));
    if (!cells_->bb().contains(r))
    {
        return -1;
    }
    const treeDataCell& shapes = cells_->shapes();
    const labelList& near = cells_->findIndices(r);
    for (const label i : near)
    {
        if (shapes.contains(i, r))
        {
            return zone_.cellMap()[shapes.cellLabels()[i]];
        }
    }

    // Tetrahedra fill the space between warped faces too
    for (const label i : near)
    {
        const label celli = shapes.cellLabels()[i];
        if
        (
            zone_.subMesh().pointInCellBB(r, celli)
         && zone_.subMesh().pointInCell(r, celli, polyMesh::CELL_TETS)
        )
        {
            return zone_.cellMap()[celli];
        }
    }
    return -1;
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
