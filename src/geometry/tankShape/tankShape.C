// SPDX-License-Identifier: GPL-3.0-or-later

#include "tankShape.H"

#include "addToRunTimeSelectionTable.H"
#include "boxShape.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(tankShape, 0);
    addToRunTimeSelectionTable(shape, tankShape, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tankShape::tankShape(const dictionary& dict, const setting& where)
:
    shape(where),
    inside_(readBox(dict, dim_)),
    open_(2*dim_, false),
    thickness_(where.wallThickness),
    outside_(inside_)
{
    checkKeywords(dict, {"name", "type", "solid", "min", "max", "open"});

    for (const word& face : dict.lookupOrDefault<wordList>("open", wordList()))
    {
        open_[faceOf(face, dim_, dict, "open")] = true;
    }
    for (direction d = 0; d < dim_; ++d)
    {
        outside_.min()[d] -= open_[2*d] ? 0 : thickness_;
        outside_.max()[d] += open_[2*d + 1] ? 0 : thickness_;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::tankShape::touch(const point& p, const scalar radius, touching& t) const
{
    // Behind the closed faces, and nearest way out over a rim or through the wall
    vector into(Zero);
    vector way(Zero);
    scalar out = GREAT;
    for (direction i = 0; i < 2*dim_; ++i)
    {
        const direction d = i/2;
        const scalar side = i % 2 ? 1 : -1;
        const scalar behind = side*(p[d] - (i % 2 ? inside_.max()[d] : inside_.min()[d]));
        if (!open_[i])
        {
            into[d] = behind > -radius ? side*(behind + radius) : into[d];
        }
        const scalar left = radius + (open_[i] ? 0 : thickness_) - behind;
        if (left <= 0)
        {
            return false;
        }
        if (left < out)
        {
            out = left;
            way = Zero;
            way[d] = side;
        }
    }
    const scalar depth = mag(into);
    if (!(depth > 0))
    {
        return false;
    }
    const bool over = depth > out;
    const scalar distance = radius - (over ? out : depth);
    t.depth = radius - distance;
    t.normal = over ? way : -into/depth;
    t.area = 0;
    return t.depth > 0;
}


Foam::shape::foot Foam::tankShape::findNearest(const point& p, const scalar reach) const
{
    // A point of the box's face is inside the box, but for its own coordinate
    const point clamped(min(max(p, inside_.min()), inside_.max()));
    foot result;
    scalar least = reach;
    for (direction i = 0; i < 2*dim_; ++i)
    {
        const direction d = i/2;
        point x(clamped);
        x[d] = i % 2 ? inside_.max()[d] : inside_.min()[d];
        const scalar distance = mag(p - x);
        if (!open_[i] && distance <= least)
        {
            least = distance;
            result.found = true;
            result.x = x;
            result.depth = contains(p) ? distance : -distance;
            result.normal = Zero;
            result.normal[d] = i % 2 ? -1 : 1;
        }
    }
    return result;
}


Foam::scalar Foam::tankShape::area() const
{
    const vector size(inside_.span());
    scalar sum = 0;
    for (direction i = 0; i < 2*dim_; ++i)
    {
        if (!open_[i])
        {
            const direction a = (i/2 + 1) % dim_, b = (i/2 + 2) % dim_;
            sum += dim_ == 2 ? size[a] : size[a]*size[b];
        }
    }
    return sum;
}


Foam::shape::polygons Foam::tankShape::outline() const
{
    return outlineOf(inside_, dim_);
}

// ************************************************************************* //
