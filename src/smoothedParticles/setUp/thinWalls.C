// SPDX-License-Identifier: GPL-3.0-or-later

#include "thinWalls.H"
#include "wallLayers.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::smoothedParticles;

//- visit(x, area) of points all over a triangle, about so far apart
template<class Function>
void sample(const point& a, const point& b, const point& c, const scalar apart, const Function& visit)
{
    const label n = label(std::ceil(max(max(mag(b - a), mag(c - b)), mag(a - c))/apart));
    const scalar area = 0.5*mag((b - a) ^ (c - a))/sqr(scalar(n));
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < 2*(n - i) - 1; ++j)
        {
            // Upright parts and, between them, those that are upside down
            const scalar third = j % 2 ? 2.0/3 : 1.0/3;
            visit(a + (i + third)/n*(b - a) + (j/2 + third)/n*(c - a), area);
        }
    }
}


//- visit(x, a direction across the surface there, area) of points all over the surface; in two dimensions of the outline
template<class Function>
void sample(const shape& wall, const scalar apart, const Function& visit)
{
    const shape::polygons outline(wall.outline());
    for (const face& f : outline.faces)
    {
        const point middle(f.centre(outline.points));
        forAll(f, i)
        {
            const point& a = outline.points[f[i]];
            const point& b = outline.points[f.nextLabel(i)];
            if (wall.dim() == 3)
            {
                const vector across(normalised(f.areaNormal(outline.points)));
                sample(a, b, middle, apart, [&](const point& x, const scalar area){ visit(x, across, area); });
                continue;
            }
            const label n = label(std::ceil(mag(b - a)/apart));
            const vector across(normalised(vector(b.y() - a.y(), a.x() - b.x(), 0)));
            for (label k = 0; k < n; ++k)
            {
                const point x(a + (k + 0.5)/n*(b - a));
                visit(point(x.x(), x.y(), 0), across, mag(b - a)/n);
            }
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::smoothedParticles::thinPart Foam::smoothedParticles::findThinPart
(
    const shape& wall,
    const PtrList<shape>& all,
    const lattice& grid
)
{
    const scalar step = 0.25*grid.spacing;
    const scalar limit = grid.support;

    const auto isWall = [&](point p)
    {
        for (const symmetryPlane& plane : grid.symmetry)
        {
            if (plane.distance(p) < 0)
            {
                p[plane.axis] = 2*plane.at - p[plane.axis];
            }
        }
        bool found = wall.contains(p);
        forAll(all, i)
        {
            found = found || all[i].contains(p);
        }
        return found;
    };
    const auto reach = [&](const point& from, const vector& direction)
    {
        scalar length = 0;
        while (length < limit && isWall(from + (length + step)*direction))
        {
            length += step;
        }
        return length;
    };

    thinPart result;
    scalar wetted = 0, thin = 0;
    sample
    (
        wall, grid.spacing,
        [&](const point& x, const vector& across, const scalar area)
        {
            const shape::foot foot(wall.findNearest(x + 0.01*grid.spacing*across, GREAT));
            if (!isOnNearSide(foot.x, grid.symmetry) || isWall(foot.x + 0.05*grid.spacing*foot.normal))
            {
                return;
            }
            wetted += area;
            const point centre(foot.x - 0.5*limit*foot.normal);
            if (!wall.findNearest(centre, 0.49*limit).found && wall.contains(centre))
            {
                return;
            }
            const scalar thickness = reach(foot.x, -foot.normal);
            if (thickness >= limit - step)
            {
                return;
            }
            const point middle(foot.x - 0.5*thickness*foot.normal);
            // A tangent across the axis on which the normal is shortest
            vector axis(0, 0, 1);
            if (grid.dim == 3)
            {
                const vector size(cmptMag(foot.normal));
                axis = Zero;
                axis[size.x() <= cmptMin(size) ? 0 : size.y() <= cmptMin(size) ? 1 : 2] = 1;
            }
            vector along(normalised(axis ^ foot.normal));
            bool plate = true;
            for (int d = 1; d < grid.dim; ++d)
            {
                plate = plate && reach(middle, along) + reach(middle, -along) > 1.5*limit;
                along = foot.normal ^ along;
            }
            if (plate)
            {
                thin += area;
                if (thickness < result.thickness)
                {
                    result.thickness = thickness;
                    result.x = foot.x;
                }
            }
        }
    );
    result.share = wetted > 0 ? thin/wetted : 0;
    return result;
}

// ************************************************************************* //
