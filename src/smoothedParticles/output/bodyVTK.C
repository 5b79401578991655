// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyVTK.H"

#include "closedSurface.H"

#include "boundBox.H"
#include "mathematicalConstants.H"
#include "triSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::smoothedParticles;

//- Parts of a circle's circumference, and the angle of each; a sphere has half as many from pole to pole
constexpr label nRound = 48;
constexpr scalar part = constant::mathematical::twoPi/nRound;


struct polygons
{
    pointField points;
    faceList faces;
};


point onSphere(const point& centre, const scalar radius, const scalar polar, const scalar azimuth)
{
    return centre + radius*vector(std::sin(polar)*std::cos(azimuth), std::sin(polar)*std::sin(azimuth), std::cos(polar));
}


polygons circle(const point& centre, const scalar radius)
{
    polygons result{pointField(nRound), faceList(1, face(identity(nRound)))};
    forAll(result.points, i)
    {
        const scalar angle = i*part;
        result.points[i] = centre + radius*vector(std::cos(angle), std::sin(angle), 0);
    }
    return result;
}


polygons sphere(const point& centre, const scalar radius)
{
    DynamicList<point> points({centre + vector(0, 0, radius), centre - vector(0, 0, radius)});
    DynamicList<face> faces;
    const auto at = [](const label ring, const label i)
    {
        return ring == 0 ? 0 : ring == nRound/2 ? 1 : 2 + (ring - 1)*nRound + i % nRound;
    };
    for (label ring = 1; ring <= nRound/2; ++ring)
    {
        for (label i = 0; i < nRound; ++i)
        {
            if (ring < nRound/2)
            {
                points.append(onSphere(centre, radius, ring*part, i*part));
                faces.append(triFace(at(ring - 1, i), at(ring, i), at(ring, i + 1)).triFaceFace());
            }
            if (ring > 1)
            {
                faces.append(triFace(at(ring - 1, i), at(ring, i), at(ring - 1, i + 1)).triFaceFace());
            }
        }
    }
    return {pointField(std::move(points)), faceList(std::move(faces))};
}


polygons box(const boundBox& bounds, const int dim)
{
    // The plane of a plane case is the face at z = 0 that looks along z
    const pointField points(bounds.points());
    return {pointField(bounds.points()), dim == 2 ? faceList(1, boundBox::faces[5]) : faceList(boundBox::faces)};
}


polygons surface(const dictionary& wall, const fileName& caseDirectory)
{
    const triSurface triangles(surfaceFile(wall, caseDirectory));
    polygons result{triangles.points(), faceList(triangles.size())};
    forAll(triangles, i)
    {
        result.faces[i] = triangles[i].triFaceFace();
    }
    return result;
}


polygons polygonsOf(const dictionary& wall, const int dim, const fileName& caseDirectory)
{
    const word type(wall.get<word>("type"));
    if (type == "surface")
    {
        return surface(wall, caseDirectory);
    }
    if (type == "sphere")
    {
        const point centre(wall.get<point>("centre"));
        const scalar radius = wall.get<scalar>("radius");
        return dim == 2 ? circle(centre, radius) : sphere(centre, radius);
    }
    return box(boundBox(wall.get<point>("min"), wall.get<point>("max")), dim);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothedParticles::bodyVTK::bodyVTK
(
    const Time& runTime,
    const dictionary& wall,
    const int dim,
    const bodyState& start
)
:
    series_(runTime, wall.get<word>("name"))
{
    polygons outside(polygonsOf(wall, dim, runTime.path()));
    points_.transfer(outside.points);
    for (point& p : points_)
    {
        p = start.orientation.T() & (p - start.centreOfMass);
    }
    faces_.transfer(outside.faces);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::smoothedParticles::bodyVTK::reach(const bodyState& now, const vector& direction) const
{
    return (now.centreOfMass & direction) + max(points_ & (now.orientation.T() & direction));
}


void Foam::smoothedParticles::bodyVTK::write(const bodyState& now)
{
    label nCorners = 0;
    for (const face& f : faces_)
    {
        nCorners += f.size();
    }
    series_.write
    (
        points_.size(), 0, faces_.size(),
        [&](vtk::formatter& format)
        {
            format.tag(vtk::fileTag::POINTS);
            vtpSeries::writeVectors
            (
                format,
                "Points",
                points_.size(),
                [&](const label i){ return point(now.centreOfMass + (now.orientation & points_[i])); }
            );
            format.endTag(vtk::fileTag::POINTS);

            format.tag(vtk::fileTag::POLYS);
            format.beginDataArray<label>("connectivity");
            format.writeSize(vtk::sizeofData<label>(nCorners));
            for (const face& f : faces_)
            {
                vtk::writeList(format, f);
            }
            format.flush();
            format.endDataArray();
            label end = 0;
            vtpSeries::writeArray<label, 1>
            (
                format, "offsets", faces_.size(), [&](const label i){ format.write(end += faces_[i].size()); }
            );
            format.endTag(vtk::fileTag::POLYS);
        }
    );
}

// ************************************************************************* //
