// SPDX-License-Identifier: GPL-3.0-or-later

#include "uniqueVolume.H"
#include "cellCellStencilObject.H"
#include "dynamicOversetFvMesh.H"
#include "oversetFvPatch.H"
#include "ListListOps.H"
#include "surfaceFields.H"
#include "unitConversion.H"
#include "wedgePolyPatch.H"
#include "profiling.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(uniqueVolume, 0);
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// A triangle cut by the six planes of a box has at most nine corners
typedef DynamicList<point, 12> polygon;

//- Keep the part of the polygon with sign*(x[axis] - level) <= 0
void clipAt
(
    polygon& poly,
    polygon& work,
    const direction axis,
    const scalar level,
    const scalar sign
)
{
    work.clear();
    forAll(poly, i)
    {
        const point& a = poly[i];
        const point& b = poly[poly.fcIndex(i)];
        const scalar da = sign*(a[axis] - level);
        const scalar db = sign*(b[axis] - level);

        if (da <= 0)
        {
            work.append(a);
        }
        if ((da < 0 && db > 0) || (da > 0 && db < 0))
        {
            work.append(a + (da/(da - db))*(b - a));
        }
    }
    poly.swap(work);
}


//- Integral of x[axis] - level over the projection of the polygon along the
//  axis, signed by its normal, and the signed projected area
void projectedMoment
(
    const polygon& poly,
    const direction axis,
    const scalar level,
    scalar& moment,
    scalar& area
)
{
    moment = 0;
    area = 0;
    for (label i = 2; i < poly.size(); ++i)
    {
        const scalar a =
            0.5*((poly[i-1] - poly[0]) ^ (poly[i] - poly[0]))[axis];
        area += a;
        moment +=
            a
           *(
                (poly[0][axis] + poly[i-1][axis] + poly[i][axis])/3.0
              - level
            );
    }
}


//- The axis along which the surface is closed
direction closedAxis(const UList<uniqueVolume::triangle>& surface)
{
    vector net(Zero);
    vector total(Zero);
    for (const uniqueVolume::triangle& t : surface)
    {
        const vector area = 0.5*((t[1] - t[0]) ^ (t[2] - t[0]));
        net += area;
        total += cmptMag(area);
    }

    // Along the empty direction of a plane mesh, and across the middle plane of
    // a wedge, there is nothing but round-off to tell
    const scalar least = 1e-9*cmptMax(total);

    direction axis = 0;
    scalar openness = GREAT;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        const scalar o = mag(net[d])/max(total[d], VSMALL);
        if (total[d] > least && o < openness)
        {
            openness = o;
            axis = d;
        }
    }

    if (openness > 1e-6)
    {
        FatalErrorInFunction
            << "The overset boundary does not close along any axis: its net"
            << " area is " << net << " of " << total << " m^2." << nl
            << "Expected: overset patches that enclose each zone, if need be"
            << " together with a plane of symmetry." << exit(FatalError);
    }
    return axis;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::uniqueVolume::setBackground()
{
    const labelList& zones = cellCellStencil::zoneID(mesh_);
    const pointField& points = mesh_.points();
    const labelListList& cellPoints = mesh_.cellPoints();
    const scalarField& V = mesh_.cellVolumes();

    DynamicList<label> cells(mesh_.nCells());
    DynamicList<boundBox> boxes(mesh_.nCells());
    forAll(zones, celli)
    {
        if (zones[celli] == 0)
        {
            cells.append(celli);
            boxes.append(boundBox(points, cellPoints[celli], false));
            if
            (
                mag(boxes.last().volume() - V[celli]) > 1e-6*V[celli]
             && !isPartOfBox(celli, boxes.last())
            )
            {
                FatalErrorInFunction
                    << "Cell " << celli << " at " << mesh_.cellCentres()[celli]
                    << " of the background (zoneID 0) is not a box along the"
                    << " axes: the volume that the other zones cover cannot"
                    << " be computed." << nl
                    << "Expected: a background of axis-aligned hexahedra, or in"
                    << " a wedge of what its planes leave of them; or neither"
                    << " a function object volumeLedger in system/controlDict"
                    << " nor fringe conserved in constant/sceneProperties."
                    << exit(FatalError);
            }
        }
    }
    cells_.transfer(cells);
    boxes_.transfer(boxes);
}


bool Foam::uniqueVolume::isPartOfBox(const label celli, const boundBox& box) const
{
    const scalar roundOff = 1e-6*box.mag();
    bool onWedge = false;
    for (const label facei : mesh_.cells()[celli])
    {
        const label patchi = mesh_.boundaryMesh().whichPatch(facei);
        if (patchi != -1 && isA<wedgePolyPatch>(mesh_.boundaryMesh()[patchi]))
        {
            onWedge = true;
            continue;
        }
        const boundBox flat(mesh_.points(), mesh_.faces()[facei], false);
        bool onBox = false;
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            onBox =
                onBox
             || flat.max()[d] - box.min()[d] < roundOff
             || box.max()[d] - flat.min()[d] < roundOff;
        }
        if (!onBox)
        {
            return false;
        }
    }
    return onWedge;
}


void Foam::uniqueVolume::checkThickness() const
{
    // Of plane meshes
    const labelList& zones = cellCellStencil::zoneID(mesh_);
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (mesh_.solutionD()[d] != -1)
        {
            continue;
        }
        boundBox background, others;
        forAll(zones, celli)
        {
            (zones[celli] ? others : background).add(mesh_.points(), mesh_.cellPoints()[celli]);
        }
        background.reduce();
        others.reduce();
        const scalar most = 1e-6*background.span()[d];
        if
        (
            others.valid()
         && (
                mag(background.min()[d] - others.min()[d]) > most
             || mag(background.max()[d] - others.max()[d]) > most
            )
        )
        {
            FatalErrorInFunction
                << "Across the plane of this mesh the background (zoneID 0) is from "
                << background.min()[d] << " to " << background.max()[d]
                << " m, the other zones are from " << others.min()[d] << " to "
                << others.max()[d] << " m: their volumes do not go together." << nl
                << "Expected: zones between the same empty patches' planes."
                << exit(FatalError);
        }
    }

    // Of wedges
    scalar cosAngle = -1;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const wedgePolyPatch* wedge = isA<wedgePolyPatch>(patch);
        if (wedge && returnReduce(wedge->size(), sumOp<label>()))
        {
            // All faces of the patch: of one of its planes on a processor without
            const scalar c = returnReduce(wedge->size() ? wedge->cosAngle() : scalar(-1), maxOp<scalar>());
            if (cosAngle != -1 && mag(::acos(min(c, scalar(1))) - ::acos(min(cosAngle, scalar(1)))) > 1e-6)
            {
                FatalErrorInFunction
                    << "The planes of the wedge are " << radToDeg(::acos(cosAngle))
                    << " and, on patch " << patch.name() << ", " << radToDeg(::acos(c))
                    << " degrees from its middle: their volumes do not go together." << nl
                    << "Expected: one angle for all zones." << exit(FatalError);
            }
            cosAngle = c;
        }
    }
}


Foam::List<Foam::uniqueVolume::triangle>
Foam::uniqueVolume::oversetBoundary() const
{
    const labelList& zones = cellCellStencil::zoneID(mesh_);
    const pointField& points = mesh_.points();

    DynamicList<triangle> triangles;
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (!isA<oversetFvPatch>(patch))
        {
            continue;
        }
        forAll(patch, facei)
        {
            if (zones[patch.faceCells()[facei]] == 0)
            {
                continue;
            }
            // Fan about a corner: edges, shared with the next face, stay
            const face& f = mesh_.faces()[patch.start() + facei];
            for (label fp = 2; fp < f.size(); ++fp)
            {
                triangle t;
                t[0] = points[f[0]];
                t[1] = points[f[fp - 1]];
                t[2] = points[f[fp]];
                triangles.append(t);
            }
        }
    }

    List<List<triangle>> all(Pstream::nProcs());
    all[Pstream::myProcNo()].transfer(triangles);
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    return ListListOps::combine<List<triangle>>(all, accessOp<List<triangle>>());
}


void Foam::uniqueVolume::setWeights()
{
    addProfiling(unique, "unique volume");

    weights_ = 1;
    const scalarField covered(coveredVolume(boxes_, oversetBoundary()));
    const scalarField& V = mesh_.cellVolumes();
    forAll(cells_, i)
    {
        const label celli = cells_[i];
        weights_[celli] = max(scalar(0), 1 - covered[i]/V[celli]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::uniqueVolume::uniqueVolume(const fvMesh& mesh)
:
    MeshObject<fvMesh, MoveableMeshObject, uniqueVolume>(mesh),
    overset_(isA<dynamicOversetFvMesh>(mesh)),
    weights_(mesh.nCells(), 1)
{
    if (overset_)
    {
        checkThickness();
        setBackground();
        setWeights();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::uniqueVolume::movePoints()
{
    if (overset_)
    {
        // A background that moves does so as a whole
        if
        (
            cells_.size()
         && boxes_[0].min() != boundBox(mesh_.points(), mesh_.cellPoints()[cells_[0]], false).min()
        )
        {
            setBackground();
        }
        setWeights();
    }
    return true;
}


Foam::scalar Foam::uniqueVolume::of(const scalarField& fraction) const
{
    return gSum(fraction*weights_*mesh_.cellVolumes());
}


Foam::scalar Foam::uniqueVolume::outflow(const surfaceScalarField& flux) const
{
    scalar rate = 0;
    forAll(flux.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!patch.coupled() && !isA<oversetFvPatch>(patch))
        {
            rate += sum(flux.boundaryField()[patchi]);
        }
    }
    return returnReduce(rate, sumOp<scalar>());
}


Foam::scalarField Foam::uniqueVolume::coveredVolume
(
    const UList<boundBox>& boxes,
    const UList<triangle>& surface
)
{
    scalarField covered(boxes.size(), Zero);
    if (surface.empty() || boxes.empty())
    {
        return covered;
    }

    const direction d0 = closedAxis(surface);
    const direction d1 = (d0 + 1) % vector::nComponents;
    const direction d2 = (d0 + 2) % vector::nComponents;

    boundBox reach;
    for (const triangle& t : surface)
    {
        reach.add(t[0]);
        reach.add(t[1]);
        reach.add(t[2]);
    }

    // Bin the boxes within reach on the plane across the axis
    const label n = max(label(1), label(std::sqrt(scalar(boxes.size()))/4));
    const vector binSize = reach.span()/n;
    auto bin = [&](const scalar x, const direction d) -> label
    {
        return min(n - 1, max(label(0), label((x - reach.min()[d])/binSize[d])));
    };

    List<DynamicList<label>> bins(n*n);
    forAll(boxes, i)
    {
        const boundBox& box = boxes[i];
        if (box.overlaps(reach))
        {
            const label hi1 = bin(box.max()[d1], d1);
            const label hi2 = bin(box.max()[d2], d2);
            for (label i1 = bin(box.min()[d1], d1); i1 <= hi1; ++i1)
            {
                for (label i2 = bin(box.min()[d2], d2); i2 <= hi2; ++i2)
                {
                    bins[i1*n + i2].append(i);
                }
            }
        }
    }

    labelList lastTriangle(boxes.size(), -1);
    polygon inColumn, work, cut;
    forAll(surface, ti)
    {
        const triangle& t = surface[ti];
        boundBox tb;
        tb.add(t[0]);
        tb.add(t[1]);
        tb.add(t[2]);

        const label hi1 = bin(tb.max()[d1], d1);
        const label hi2 = bin(tb.max()[d2], d2);
        for (label i1 = bin(tb.min()[d1], d1); i1 <= hi1; ++i1)
        {
            for (label i2 = bin(tb.min()[d2], d2); i2 <= hi2; ++i2)
            {
                for (const label i : bins[i1*n + i2])
                {
                    const point& lo = boxes[i].min();
                    const point& hi = boxes[i].max();
                    if
                    (
                        lastTriangle[i] == ti
                     || tb.max()[d0] <= lo[d0]
                     || tb.max()[d1] <= lo[d1] || tb.min()[d1] >= hi[d1]
                     || tb.max()[d2] <= lo[d2] || tb.min()[d2] >= hi[d2]
                    )
                    {
                        continue;
                    }
                    lastTriangle[i] = ti;

                    inColumn.clear();
                    inColumn.append(t[0]);
                    inColumn.append(t[1]);
                    inColumn.append(t[2]);
                    if (tb.min()[d1] < lo[d1]) clipAt(inColumn, work, d1, lo[d1], -1);
                    if (tb.max()[d1] > hi[d1]) clipAt(inColumn, work, d1, hi[d1], 1);
                    if (tb.min()[d2] < lo[d2]) clipAt(inColumn, work, d2, lo[d2], -1);
                    if (tb.max()[d2] > hi[d2]) clipAt(inColumn, work, d2, hi[d2], 1);

                    // Beyond the box: its whole length counts
                    scalar moment, area;
                    const scalar length = hi[d0] - lo[d0];
                    if (tb.min()[d0] >= hi[d0])
                    {
                        projectedMoment(inColumn, d0, lo[d0], moment, area);
                        covered[i] += length*area;
                        continue;
                    }
                    if (tb.max()[d0] > hi[d0])
                    {
                        cut = inColumn;
                        clipAt(cut, work, d0, hi[d0], -1);
                        projectedMoment(cut, d0, lo[d0], moment, area);
                        covered[i] += length*area;
                        clipAt(inColumn, work, d0, hi[d0], 1);
                    }
                    if (tb.min()[d0] < lo[d0])
                    {
                        clipAt(inColumn, work, d0, lo[d0], -1);
                    }
                    projectedMoment(inColumn, d0, lo[d0], moment, area);
                    covered[i] += moment;
                }
            }
        }
    }

    return covered;
}

// ************************************************************************* //
