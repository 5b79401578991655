// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceParts.H"

#include "boundBox.H"
#include "HashSet.H"
#include "inputChecks.H"
#include "mathematicalConstants.H"
#include "triangleTree.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Of the surface's size
constexpr scalar rounding = 1e-5;
constexpr scalar shrinking = 1e-4;

//- As many runs or triangles are named
constexpr label nNamed = 8;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceParts::surfaceParts(const triSurface& surface)
:
    size_(boundBox(surface.points(), false).mag()),
    surface_(surface),
    part_(surface.size(), -1),
    nParts_(0),
    twisted_(-1)
{
    findParts();
    if (twisted_ < 0)
    {
        findCrossings();
    }
    if (twisted_ < 0 && crossing_.empty())
    {
        dropNested();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::surfaceParts::findParts()
{
    const List<triSurface::FaceType>& faces = surface_.localFaces();
    labelList sense(surface_.size(), 1);
    DynamicList<label> front;
    forAll(faces, first)
    {
        if (part_[first] >= 0)
        {
            continue;
        }
        part_[first] = nParts_++;
        front.append(first);
        while (front.size())
        {
            const label i = front.remove();
            for (const label e : surface_.faceEdges()[i])
            {
                const edge& side = surface_.edges()[e];
                for (const label j : surface_.edgeFaces()[e])
                {
                    if (j == i)
                    {
                        continue;
                    }
                    // Two neighbours pass their edge in opposite directions
                    const label expected = -sense[i]*faces[i].edgeDirection(side)*faces[j].edgeDirection(side);
                    if (part_[j] < 0)
                    {
                        part_[j] = part_[i];
                        sense[j] = expected;
                        front.append(j);
                    }
                    else if (sense[j] != expected)
                    {
                        twisted_ = j;
                    }
                }
            }
        }
    }

    List<labelledTri> triangles(surface_);
    scalarField volumes(nParts_, Zero);
    vectorField middles(nParts_, Zero);
    labelList n(nParts_, 0);
    forAll(triangles, i)
    {
        middles[part_[i]] += triangles[i].centre(surface_.points());
        ++n[part_[i]];
    }
    forAll(triangles, i)
    {
        const vector to(triangles[i].centre(surface_.points()) - middles[part_[i]]/n[part_[i]]);
        volumes[part_[i]] += sense[i]*(to & triangles[i].areaNormal(surface_.points()))/3;
    }
    forAll(triangles, i)
    {
        if (sense[i]*volumes[part_[i]] < 0)
        {
            triangles[i].flip();
            turned_.append(i);
        }
    }
    surface_ = triSurface(triangles, surface_.patches(), pointField(surface_.points()));
}


Foam::label Foam::surfaceParts::crossed
(
    const triangleTree& tree,
    const point& a,
    const point& b,
    const label notPart,
    const labelledTri* ends
) const
{
    const pointField& points = surface_.points();
    label found = -1;
    boundBox box(a, a);
    box.add(b);
    tree.forOverlapping
    (
        box,
        [&](const label i)
        {
            const labelledTri& f = surface_[i];
            if
            (
                found >= 0 || part_[i] == notPart
             || (ends && (f.found((*ends)[0]) || f.found((*ends)[1])))
            )
            {
                return;
            }
            const vector normal(f.unitNormal(points));
            const scalar da = (a - points[f[0]]) & normal;
            const scalar db = (b - points[f[0]]) & normal;
            if (da*db >= 0 || min(mag(da), mag(db)) <= rounding*size_)
            {
                return;
            }
            const point x(a + da/(da - db)*(b - a));
            bool inside = true;
            for (label k = 0; k < 3; ++k)
            {
                const point& p = points[f[k]];
                const vector side(points[f[(k + 1) % 3]] - p);
                inside = inside && (((side ^ (x - p)) & normal) > rounding*size_*mag(side));
            }
            found = inside ? i : found;
        }
    );
    return found;
}


void Foam::surfaceParts::findCrossings()
{
    const pointField& points = surface_.points();
    const triangleTree tree(surface_);
    labelHashSet found;
    const auto cross = [&](const label i, const label j)
    {
        if (j >= 0)
        {
            found.insert(i);
            found.insert(j);
        }
    };
    forAll(surface_, i)
    {
        for (label k = 0; k < 3; ++k)
        {
            const label a = surface_[i][k];
            const label b = surface_[i][(k + 1) % 3];
            if (a < b)
            {
                const labelledTri ends(a, b, b, 0);
                cross(i, crossed(tree, points[a], points[b], -1, &ends));
            }
        }
    }
    for (label part = 0; part < nParts_ && nParts_ > 1; ++part)
    {
        boundBox box(boundBox::invertedBox);
        const labelList own(trianglesOf(part));
        for (const label i : own)
        {
            box.add(points, surface_[i]);
        }
        const point middle(box.midpoint());
        const auto shrunk = [&](const label p){ return point(points[p] + shrinking*(middle - points[p])); };
        for (const label i : own)
        {
            for (label k = 0; k < 3; ++k)
            {
                cross(i, crossed(tree, shrunk(surface_[i][k]), shrunk(surface_[i][(k + 1) % 3]), part, nullptr));
            }
        }
    }
    crossing_ = found.sortedToc();
}


Foam::labelList Foam::surfaceParts::trianglesOf(const label part) const
{
    DynamicList<label> result;
    forAll(part_, i)
    {
        if (part_[i] == part)
        {
            result.append(i);
        }
    }
    return labelList(std::move(result));
}


bool Foam::surfaceParts::contains(const label part, const point& p) const
{
    // Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125
    scalar angle = 0;
    forAll(surface_, i)
    {
        if (part_[i] == part)
        {
            vector r[3];
            scalar l[3];
            for (label k = 0; k < 3; ++k)
            {
                r[k] = surface_.points()[surface_[i][k]] - p;
                l[k] = mag(r[k]);
            }
            angle += 2*std::atan2
            (
                r[0] & (r[1] ^ r[2]),
                l[0]*l[1]*l[2] + (r[0] & r[1])*l[2] + (r[1] & r[2])*l[0] + (r[2] & r[0])*l[1]
            );
        }
    }
    return mag(angle) > constant::mathematical::twoPi;
}


void Foam::surfaceParts::dropNested()
{
    if (nParts_ == 1)
    {
        return;
    }
    boolList isInside(nParts_, false);
    forAll(surface_, i)
    {
        // One triangle of each will do, for parts do not cross
        const label part = part_[i];
        if (i && part_[i - 1] == part)
        {
            continue;
        }
        for (label other = 0; other < nParts_; ++other)
        {
            isInside[part] = isInside[part] || (other != part && contains(other, surface_[i].centre(surface_.points())));
        }
    }
    boolList keep(surface_.size(), true);
    forAll(surface_, i)
    {
        if (isInside[part_[i]])
        {
            keep[i] = false;
            dropped_.append(i);
        }
    }
    if (dropped_.size())
    {
        labelList pointMap, faceMap;
        surface_ = triSurface(surface_.subsetMesh(keep, pointMap, faceMap));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::string Foam::surfaceParts::runs(const labelUList& ascending)
{
    std::string result;
    label n = 0;
    for (label i = 0; i < ascending.size(); ++n)
    {
        if (n == nNamed)
        {
            return result + " ...";
        }
        label last = i;
        while (last + 1 < ascending.size() && ascending[last + 1] == ascending[last] + 1)
        {
            ++last;
        }
        result += (n ? " " : "") + text(ascending[i]) + (last > i ? "-" + text(ascending[last]) : "");
        i = last + 1;
    }
    return result;
}

// ************************************************************************* //
