// SPDX-License-Identifier: GPL-3.0-or-later

#include "closedSurface.H"

#include "addToRunTimeSelectionTable.H"
#include "DynamicList.H"
#include "EdgeMap.H"
#include "inputChecks.H"
#include "Map.H"
#include "OSspecific.H"
#include "momentOfInertia.H"
#include "surfaceParts.H"
#include "triSurfaceTools.H"

#include <cstdint>
#include <fstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(closedSurface, 0);
    addToRunTimeSelectionTable(shape, closedSurface, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

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


//- By the entry file, which is relative to the case
fileName surfaceFile(const dictionary& dict, const fileName& caseDirectory)
{
    fileName file(dict.get<fileName>("file"));
    file.expand();
    if (!file.isAbsolute())
    {
        file = caseDirectory/file;
    }
    if (!isFile(file))
    {
        refuse(dict, text("Entry file: there is no ", file), "a surface, relative to the case.");
    }
    return file;
}

//- What triSurface is to read a file as: a binary STL is as long as its triangles say, and OpenFOAM takes one whose header starts
//  with "solid" for text
word formatOf(const fileName& file)
{
    const word format(file.ext());
    std::ifstream is(file, std::ios::binary);
    std::uint32_t n = 0;
    is.seekg(80);
    is.read(reinterpret_cast<char*>(&n), sizeof(n));
    return format == "stl" && is && fileSize(file) == 84 + 50*off_t(n) ? "stlb" : format;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::closedSurface::closedSurface(const dictionary& dict, const setting& where)
:
    shape(where),
    file_(surfaceFile(dict, where.caseDirectory)),
    surface_(file_, formatOf(file_))
{
    checkKeywords(dict, {"name", "type", "file"});
    checkWatertight(dict);
    orient(dict);
    const boundBox box(surface_.points(), false);
    outline_ = {surface_.points(), faceList(surface_.size())};
    forAll(surface_, i)
    {
        outline_.faces[i] = surface_[i].triFaceFace();
    }
    if (dim_ == 2)
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
    facets_ = surface_.magFaceAreas();
    if (dim_ == 2)
    {
        // An edge of the cut is two triangles
        facets_ *= 2/boundBox(surface_.points(), false).span().z();
    }

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

void Foam::closedSurface::checkWatertight(const dictionary& dict) const
{
    if (surface_.empty())
    {
        refuse(dict, text("Entry file: ", file_, " has no triangles"), "a watertight surface.");
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
        refuse
        (
            dict,
            text
            (
                "Entry file: ", file_, " leaks: ", nOpen, " of its ", surface_.nEdges(),
                " edges have not exactly two triangles; the first, from ", surface_.localPoints()[e.start()], " to ",
                surface_.localPoints()[e.end()], ", has ", surface_.edgeFaces()[first].size(), ", from 0 the triangles ",
                surfaceParts::runs(labelList(surface_.edgeFaces()[first]))
            ),
            "a watertight surface."
        );
    }
}


void Foam::closedSurface::orient(const dictionary& dict)
{
    const surfaceParts parts(surface_);
    if (parts.twisted() >= 0)
    {
        refuse
        (
            dict,
            text("Entry file: ", file_, " has one side only: triangle ", parts.twisted(), " cannot be turned like its neighbours"),
            "a surface with an inside."
        );
    }
    if (parts.crossing().size())
    {
        refuse
        (
            dict,
            text
            (
                "Entry file: ", file_, ", of ", parts.nParts(), " closed part(s), passes through itself: ",
                parts.crossing().size(), " of its ", surface_.size(), " triangles do, from 0 the triangles ",
                surfaceParts::runs(parts.crossing()), ", the first at ",
                surface_[parts.crossing()[0]].centre(surface_.points())
            ),
            "one closed surface: unite its parts in the program that made the file."
        );
    }
    if (parts.turned().size())
    {
        Info<< "Surface " << file_ << ": " << parts.turned().size() << " of " << surface_.size()
            << " triangles turned, they were wound inwards: from 0 the triangles "
            << surfaceParts::runs(parts.turned()).c_str() << endl;
    }
    if (parts.dropped().size())
    {
        Info<< "Surface " << file_ << ": part(s) inside another left out, for what moves is solid: from 0 the triangles "
            << surfaceParts::runs(parts.dropped()).c_str() << endl;
    }
    surface_ = parts.surface();
    const boundBox box(surface_.points(), false);
    const scalar volume = insideOf(surface_).volume;
    if (!(volume > 1e-9*pow3(box.mag())))
    {
        refuse(dict, text("Entry file: ", file_, " encloses ", volume, " m3"), "the surface of a solid.");
    }
}


void Foam::closedSurface::cut(const dictionary& dict)
{
    // A point on the plane counts as above it, so that each triangle has two edges across, or none
    const pointField& points = surface_.points();
    const auto above = [&](const label i){ return points[i].z() >= 0; };

    // Drawn out so far that nothing is nearer to its ends
    const boundBox box(points, false);
    const vector up(0, 0, max(box.span().x(), box.span().y()));

    DynamicList<point> corners;
    DynamicList<labelledTri> triangles;
    Map<label> next;
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
            next.insert(from/2, to/2);
        }
    }
    if (triangles.empty())
    {
        refuse
        (
            dict,
            text("Entry file: ", file_, " is between z = ", box.min().z(), " and ", box.max().z(), " m"),
            "in two dimensions, a surface that crosses z = 0."
        );
    }
    surface_ = triSurface(triangles, pointField(corners));

    // Round each outline
    DynamicList<point> round;
    DynamicList<face> outlines;
    while (next.size())
    {
        DynamicList<label> outline;
        auto at = next.begin();
        while (at.good())
        {
            outline.append(round.size());
            round.append(corners[2*at.key()] + up);
            const label to = at.val();
            next.erase(at);
            at = next.find(to);
        }
        outlines.append(face(labelList(std::move(outline))));
    }
    outline_ = {pointField(std::move(round)), faceList(std::move(outlines))};
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::shape::foot Foam::closedSurface::findNearest(const point& p, const scalar reach) const
{
    foot result;
    const triangleTree::nearest nearest(tree_->findNearest(p, reach));
    if (nearest.triangle >= 0)
    {
        result.found = true;
        result.x = nearest.x;
        result.facet = nearest.triangle;
        result.depth = mag(p - result.x);
        if (triSurfaceTools::surfaceSide(surface_, p, nearest.triangle) != triSurfaceTools::INSIDE)
        {
            result.depth *= -1;
        }
        // On the surface itself there is no direction to it
        result.normal =
            mag(result.depth) > SMALL*mag(box_.span())
          ? vector((result.x - p)/result.depth)
          : surface_.faceNormals()[nearest.triangle];
        if (dim_ == 2)
        {
            // Not off the plane, where nothing is inside, by round-off
            result.x.z() = result.normal.z() = 0;
        }
    }
    return result;
}


bool Foam::closedSurface::touch(const point& p, const scalar radius, touching& t) const
{
    const foot nearest(findNearest(p, GREAT));
    t = {radius + nearest.depth, nearest.normal, facets_[nearest.facet]};
    return t.depth > 0;
}


bool Foam::closedSurface::contains(const point& p) const
{
    return box_.contains(p) && findNearest(p, GREAT).depth > 0;
}

// ************************************************************************* //
