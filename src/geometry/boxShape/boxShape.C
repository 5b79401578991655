// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxShape.H"

#include "addToRunTimeSelectionTable.H"
#include "foamVersion.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(boxShape, 0);
    addToRunTimeSelectionTable(shape, boxShape, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::boxShape::boxShape(const dictionary& dict, const setting& where)
:
    shape(where),
    box_(readBox(dict, dim_))
{
    checkKeywords(dict, {"name", "type", "solid", "min", "max"});

    const vector size(box_.span());
    const scalar volume = dim_ == 2 ? size.x()*size.y() : cmptProduct(size);
    const vector second(volume/12*cmptMultiply(size, size));
    measures_.add(box_.midpoint(), volume, symmTensor(second.x(), 0, 0, second.y(), 0, second.z()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::shape::foot Foam::boxShape::findNearest(const point& p, const scalar reach) const
{
    vector beyond(Zero);
    scalar inside = GREAT;
    foot result;
    result.normal = Zero;
    for (direction d = 0; d < dim_; ++d)
    {
        const scalar low = p[d] - box_.min()[d];
        const scalar high = box_.max()[d] - p[d];
        beyond[d] = low < 0 ? low : high < 0 ? -high : 0;
        if (min(low, high) < inside)
        {
            inside = min(low, high);
            result.normal = Zero;
            result.normal[d] = low < high ? -1 : 1;
        }
    }
    if (inside >= 0)
    {
        result.depth = inside;
        result.x = p + inside*result.normal;
    }
    else
    {
        result.depth = -mag(beyond);
        result.normal = beyond/mag(beyond);
        result.x = p - beyond;
    }
    result.found = mag(result.depth) <= reach;
    return result;
}


Foam::scalar Foam::boxShape::area() const
{
    const vector size(box_.span());
    return
        dim_ == 2
      ? 2*(size.x() + size.y())
      : 2*(size.x()*size.y() + size.y()*size.z() + size.z()*size.x());
}


Foam::shape::polygons Foam::boxShape::outline() const
{
    return outlineOf(box_, dim_);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::shape::polygons Foam::outlineOf(const boundBox& box, const int dim)
{
    const faceList& faces = foamVersion::hexFaces<boundBox>();
    return {pointField(box.points()), dim == 2 ? faceList(1, faces[5]) : faces};
}

// ************************************************************************* //
