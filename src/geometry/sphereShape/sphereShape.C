// SPDX-License-Identifier: GPL-3.0-or-later

#include "sphereShape.H"

#include "addToRunTimeSelectionTable.H"
#include "DynamicList.H"
#include "inputChecks.H"
#include "mathematicalConstants.H"
#include "triFace.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(sphereShape, 0);
    addToRunTimeSelectionTable(shape, sphereShape, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using constant::mathematical::pi;

//- Parts of a circle's circumference, and the angle of each; a sphere has half as many from pole to pole
constexpr label nRound = 48;
constexpr scalar part = constant::mathematical::twoPi/nRound;

point onSphere(const point& centre, const scalar radius, const scalar polar, const scalar azimuth)
{
    return centre + radius*vector(std::sin(polar)*std::cos(azimuth), std::sin(polar)*std::sin(azimuth), std::cos(polar));
}


shape::polygons circle(const point& centre, const scalar radius)
{
    shape::polygons result{pointField(nRound), faceList(1, face(identity(nRound)))};
    forAll(result.points, i)
    {
        const scalar angle = i*part;
        result.points[i] = centre + radius*vector(std::cos(angle), std::sin(angle), 0);
    }
    return result;
}


shape::polygons ball(const point& centre, const scalar radius)
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

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sphereShape::sphereShape(const dictionary& dict, const setting& where)
:
    shape(where),
    centre_(readVector(dict, "centre", dim_)),
    radius_(readPositive(dict, "radius", "a positive number [m].")),
    measures_(ballMeasures(centre_, radius_, dim_))
{
    checkKeywords(dict, {"name", "type", "centre", "radius"});
    const vector toCorner(radius_, radius_, dim_ == 2 ? 0 : radius_);
    box_ = boundBox(centre_ - toCorner, centre_ + toCorner);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::shape::foot Foam::sphereShape::findNearest(const point& p, const scalar reach) const
{
    const vector r(p - centre_);
    const scalar distance = mag(r);
    foot result;
    result.depth = radius_ - distance;
    result.normal = distance > 0 ? vector(r/distance) : vector(1, 0, 0);
    result.x = centre_ + radius_*result.normal;
    result.found = mag(result.depth) <= reach;
    return result;
}


Foam::scalar Foam::sphereShape::area() const
{
    return dim_ == 2 ? 2*pi*radius_ : 4*pi*sqr(radius_);
}


Foam::shape::polygons Foam::sphereShape::outline() const
{
    return dim_ == 2 ? circle(centre_, radius_) : ball(centre_, radius_);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::solidMeasures Foam::ballMeasures
(
    const point& centre,
    const scalar radius,
    const int dim
)
{
    solidMeasures result;
    if (dim == 2)
    {
        result.add(centre, pi*sqr(radius), pi/4*pow4(radius)*symmTensor(1, 0, 0, 1, 0, 0));
    }
    else
    {
        result.add(centre, 4*pi/3*pow3(radius), 4*pi/15*pow5(radius)*symmTensor::I);
    }
    return result;
}

// ************************************************************************* //
