// SPDX-License-Identifier: GPL-3.0-or-later

#include "triangleTree.H"

#include "triPointRef.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

constexpr std::int32_t leafSize = 4;

//- Squared distance of a point from a box
inline scalar distance2(const boundBox& box, const point& p)
{
    scalar r2 = 0;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar r = std::max(std::max(box.min()[d] - p[d], p[d] - box.max()[d]), scalar(0));
        r2 += r*r;
    }
    return r2;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::triangleTree::triangleTree(const triSurface& surface)
:
    triangles_(surface.size())
{
    const pointField& points = surface.points();
    forAll(surface, i)
    {
        const labelledTri& f = surface[i];
        triangles_[i] = {{points[f[0]], points[f[1]], points[f[2]]}, i};
    }
    build(0, triangles_.size());
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::triangleTree::build(const std::int32_t first, const std::int32_t last)
{
    boundBox box(boundBox::invertedBox);
    for (std::int32_t i = first; i < last; ++i)
    {
        for (const point& p : triangles_[i].corners)
        {
            box.add(p);
        }
    }
    const std::size_t self = nodes_.size();
    nodes_.push_back({box, first, last - first});
    if (last - first <= leafSize)
    {
        return;
    }

    const vector span(box.span());
    const direction d = span.x() >= cmptMax(span) ? 0 : span.y() >= cmptMax(span) ? 1 : 2;
    const std::int32_t middle = first + (last - first)/2;
    std::nth_element
    (
        triangles_.begin() + first, triangles_.begin() + middle, triangles_.begin() + last,
        [d](const triangle& a, const triangle& b)
        {
            return
                a.corners[0][d] + a.corners[1][d] + a.corners[2][d]
              < b.corners[0][d] + b.corners[1][d] + b.corners[2][d];
        }
    );
    build(first, middle);
    nodes_[self].first = nodes_.size();
    nodes_[self].n = 0;
    build(middle, last);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::triangleTree::nearest Foam::triangleTree::findNearest
(
    const point& p,
    const scalar reach
) const
{
    nearest result;
    scalar least = sqr(reach);

    // Nodes that wait, with their distances: at most one for each level
    std::pair<std::int32_t, scalar> waiting[64];
    label nWaiting = 0;
    std::int32_t at = 0;
    scalar from = distance2(nodes_[0].box, p);
    for (;;)
    {
        if (from <= least)
        {
            const node& here = nodes_[at];
            if (here.n == 0)
            {
                const scalar a = distance2(nodes_[at + 1].box, p), b = distance2(nodes_[here.first].box, p);
                waiting[nWaiting++] = a < b ? std::make_pair(here.first, b) : std::make_pair(at + 1, a);
                at = a < b ? at + 1 : here.first;
                from = std::min(a, b);
                continue;
            }
            for (std::int32_t i = here.first; i < here.first + here.n; ++i)
            {
                const triangle& t = triangles_[i];
                const point x(triPointRef(t.corners[0], t.corners[1], t.corners[2]).nearestPoint(p).rawPoint());
                const scalar r2 = magSqr(x - p);
                if (r2 <= least)
                {
                    least = r2;
                    result = {t.index, x};
                }
            }
        }
        if (nWaiting == 0)
        {
            return result;
        }
        std::tie(at, from) = waiting[--nWaiting];
    }
}

// ************************************************************************* //
