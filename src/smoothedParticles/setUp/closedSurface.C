// SPDX-License-Identifier: GPL-3.0-or-later

#include "closedSurface.H"

#include "DynamicList.H"
#include "EdgeMap.H"
#include "OSspecific.H"
#include "momentOfInertia.H"
#include "orientedSurface.H"
#include "triSurfaceSearch.H"
#include "triSurfaceTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::smoothedParticles;

//- Of the inside of triangles whose normals are outwards
solidMeasures insideOf(const triSurface& surface)
{
    scalar volume;
    vector centroid;
    tensor inertia;
    momentOfInertia::massPropertiesSolid(surface, 1, volume, centroid, inertia);
    solidMeasures result;
    result.add(centroid, volume, 0.5*tr(inertia)*symmTensor::I - symm(inertia));
    return result;
}


//- Add the triangle of the origin and an edge that has the inside on its left
void addSector(solidMeasures& m, const point& a, const point& b)
{
    const scalar area = 0.5*(a.x()*b.y() - a.y()*b.x());
    m.volume += area;
    m.first += area/3*(a + b);
    m.second += area/12*(sqr(a) + sqr(b) + sqr(a + b));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::smoothedParticles::surfaceFile(const dictionary& dict, const fileName& caseDirectory)
{
    fileName file(dict.get<fileName>("file"));
    file.expand();
    if (!file.isAbsolute())
    {
        file = caseDirectory/file;
    }
    if (!isFile(file))
    {
        FatalIOErrorInFunction(dict)
            << "Entry file: there is no " << file << nl
            << "Expected: a surface, relative to the case." << exit(FatalIOError);
    }
    return file;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothedParticles::closedSurface::closedSurface
(
    const dictionary& dict,
    const fileName& caseDirectory,
    const int dim
)
:
    file_(surfaceFile(dict, caseDirectory)),
    surface_(file_)
{
    checkWatertight(dict);
    const boundBox box(surface_.points(), false);
    orientedSurface::orient(surface_, triSurfaceSearch(surface_), box.max() + box.span(), true);
    if (dim == 2)
    {
        cut(dict);
        box_ = boundBox(surface_.points(), false);
        box_.min().z() = box_.max().z() = 0;
    }
    else
    {
        measures_ = insideOf(surface_);
        area_ = sum(mag(surface_.faceAreas()));
        box_ = box;
    }
    tree_.reset(new triangleTree(surface_));

    // All that triSurface makes when it is first asked for, before there are threads
    surface_.faceNormals();
    surface_.edges();
    surface_.edgeFaces();
    surface_.faceEdges();
    surface_.pointEdges();
    surface_.localFaces();
    surface_.localPoints();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::smoothedParticles::closedSurface::checkWatertight(const dictionary& dict) const
{
    if (surface_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry file: " << file_ << " has no triangles" << nl
            << "Expected: a watertight surface." << exit(FatalIOError);
    }
    label first = -1, nOpen = 0;
    forAll(surface_.edgeFaces(), i)
    {
        if (surface_.edgeFaces()[i].size() != 2)
        {
            first = nOpen++ ? first : i;
        }
    }
    if (nOpen)
    {
        const edge& e = surface_.edges()[first];
        FatalIOErrorInFunction(dict)
            << "Entry file: " << file_ << " leaks: " << nOpen << " of its "
            << surface_.nEdges() << " edges have not exactly two triangles; the first, from "
            << surface_.localPoints()[e.start()] << " to " << surface_.localPoints()[e.end()]
            << ", has " << surface_.edgeFaces()[first].size() << nl
            << "Expected: a watertight surface." << exit(FatalIOError);
    }
}


void Foam::smoothedParticles::closedSurface::cut(const dictionary& dict)
{
    // A point on the plane counts as above it, so that each triangle has two edges across, or none
    const pointField& points = surface_.points();
    const auto above = [&](const label i){ return points[i].z() >= 0; };

    // Drawn out so far that nothing is nearer to its ends
    const boundBox box(points, false);
    const vector up(0, 0, max(box.span().x(), box.span().y()));

    DynamicList<point> corners;
    DynamicList<labelledTri> triangles;
    EdgeMap<label> cornerOf;
    const auto corner = [&](const label i, const label j)
    {
        // All triangles share a point that is on the plane
        const edge e(points[i].z() == 0 ? edge(i, i) : points[j].z() == 0 ? edge(j, j) : edge(i, j));
        const auto found = cornerOf.cfind(e);
        if (found.good())
        {
            return found.val();
        }
        const scalar t = points[i].z()/(points[i].z() - points[j].z());
        point p(points[i] + t*(points[j] - points[i]));
        p.z() = 0;
        corners.append(p - up);
        corners.append(p + up);
        cornerOf.insert(e, corners.size() - 2);
        return corners.size() - 2;
    };

    for (const labelledTri& f : surface_)
    {
        label from = -1, to = -1;
        for (label i = 0; i < 3; ++i)
        {
            const label j = (i + 1) % 3;
            if (above(f[i]) && !above(f[j]))
            {
                from = corner(f[i], f[j]);
            }
            else if (!above(f[i]) && above(f[j]))
            {
                to = corner(f[i], f[j]);
            }
        }
        if (from >= 0 && mag(corners[to] - corners[from]) > VSMALL)
        {
            // Anticlockwise about the inside, as the triangle is about its normal
            addSector(measures_, corners[from] + up, corners[to] + up);
            area_ += mag(corners[to] - corners[from]);
            triangles.append(labelledTri(from, to, to + 1, 0));
            triangles.append(labelledTri(from, to + 1, from + 1, 0));
        }
    }
    if (triangles.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry file: " << file_ << " is between z = " << box.min().z() << " and "
            << box.max().z() << " m" << nl
            << "Expected: in two dimensions, a surface that crosses z = 0." << exit(FatalIOError);
    }
    surface_ = triSurface(triangles, pointField(corners));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::smoothedParticles::closedSurface::foot Foam::smoothedParticles::closedSurface::findNearest
(
    const point& p,
    const scalar reach
) const
{
    foot result;
    const triangleTree::nearest nearest(tree_->findNearest(p, reach));
    if (nearest.triangle >= 0)
    {
        result.found = true;
        result.x = nearest.x;
        result.triangle = nearest.triangle;
        result.depth = mag(p - result.x);
        if (triSurfaceTools::surfaceSide(surface_, p, nearest.triangle) != triSurfaceTools::INSIDE)
        {
            result.depth *= -1;
        }
    }
    return result;
}


bool Foam::smoothedParticles::closedSurface::contains(const point& p) const
{
    return box_.contains(p) && findNearest(p, GREAT).depth > 0;
}

// ************************************************************************* //
