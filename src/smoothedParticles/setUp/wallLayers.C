// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallLayers.H"
#include "pointColumns.H"
#include "smoothingKernels.H"
#include "sphereShape.H"

#include "DynamicList.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::smoothedParticles;

//- A multiple of four of about this size: symmetric about two planes
label fourfold(const scalar n)
{
    return 4*max(label(1), label(std::lround(n/4)));
}


//- The solid behind a surface: points of a fine lattice as deep as the layers, and the cells that are deeper
class sampledSolid
{
    const shape& surface_;
    const int dim_;
    const scalar spacing_;
    const scalar depth_;        //!< of the layers [m]
    const label nFine_;         //!< points along a spacing
    const std::vector<symmetryPlane>& symmetry_;


    //- The middles of n parts of a cube in each direction
    template<class Function>
    void forParts(const point& centre, const scalar size, const label n, const Function& visit) const
    {
        const label nz = dim_ == 2 ? 1 : n;
        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; j < n; ++j)
            {
                for (label k = 0; k < nz; ++k)
                {
                    visit(centre + 0.5*size/n*vector(2*i + 1 - n, 2*j + 1 - n, 2*k + 1 - nz));
                }
            }
        }
    }

    void addDeep(const point& centre, const scalar size)
    {
        const symmTensor about(dim_ == 2 ? symmTensor(1, 0, 0, 1, 0, 0) : symmTensor::I);
        deep.add(centre, std::pow(size, dim_), std::pow(size, dim_ + 2)/12*about);
    }

    //- A cube, in parts where the surface is near
    void add(const point& centre, const scalar size)
    {
        const scalar halfDiagonal = 0.5*size*std::sqrt(scalar(dim_));
        const shape::foot foot(surface_.findNearest(centre, depth_ + halfDiagonal));
        if (!foot.found)
        {
            if (surface_.contains(centre))
            {
                addDeep(centre, size);
            }
        }
        else if (foot.depth < -halfDiagonal)
        {
            return;
        }
        else if (size > 1.5*spacing_)
        {
            forParts(centre, size, 2, [&](const point& p){ add(p, 0.5*size); });
        }
        else
        {
            forParts(centre, size, nFine_, [&](const point& p){ addPoint(p, mag(p - foot.x)); });
        }
    }

    //- The surface is no farther than this [m]
    void addPoint(const point& p, const scalar reach)
    {
        const scalar size = pointSpacing();
        const shape::foot foot(surface_.findNearest(p, min(depth_, (1 + 1e-9)*reach)));
        if (foot.found)
        {
            // What the surface cuts off a cell, as if it were parallel to a face
            const scalar share = min(0.5 + foot.depth/size, scalar(1));
            if (share > 0 && isOnNearSide(p, symmetry_))
            {
                points.append({p, foot.depth, share*std::pow(size, dim_)});
            }
        }
        else if (surface_.contains(p))
        {
            addDeep(p, size);
        }
    }


public:

    struct sample
    {
        point x;            //!< [m]
        scalar depth;       //!< from the surface [m]
        scalar volume;      //!< of the cell's part inside [m3]
    };

    DynamicList<sample> points;
    solidMeasures deep;


    sampledSolid
    (
        const shape& surface,
        const scalar spacing,
        const label nLayers,
        const std::vector<symmetryPlane>& symmetry
    )
    :
        surface_(surface),
        dim_(surface.dim()),
        spacing_(spacing),
        depth_(nLayers*spacing),
        nFine_(dim_ == 2 ? 8 : 3),
        symmetry_(symmetry)
    {
        scalar size = spacing;
        while (size < cmptMax(surface.bounds().span()) + spacing)
        {
            size *= 2;
        }
        add(surface.bounds().midpoint(), size);

        // So that the first particles are beside the planes, half a spacing from them, from their corner on
        const auto distance = [&](const sample& s)
        {
            scalar sum = 0;
            for (const symmetryPlane& plane : symmetry)
            {
                sum += min(scalar(plane.distance(s.x)), spacing);
            }
            return sum;
        };
        std::stable_sort
        (
            points.begin(), points.end(), [&](const sample& a, const sample& b){ return distance(a) < distance(b); }
        );
    }

    scalar pointSpacing() const
    {
        return spacing_/nFine_;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool Foam::smoothedParticles::isOnNearSide
(
    const point& p,
    const std::vector<symmetryPlane>& symmetry,
    const scalar distance
)
{
    bool near = true;
    for (const symmetryPlane& plane : symmetry)
    {
        near = near && plane.distance(p) >= distance;
    }
    return near;
}


Foam::smoothedParticles::wallParticles Foam::smoothedParticles::sphereLayers
(
    const point& centre,
    const scalar radius,
    const int dim,
    const scalar spacing,
    const label nLayers,
    solidMeasures& represented
)
{
    DynamicList<point> x;
    DynamicList<scalar> volume;
    represented = solidMeasures();
    const auto append = [&](const point& p, const scalar v)
    {
        x.append(p);
        volume.append(v);
        represented.add(p, v);
    };
    const auto ring = [&](const scalar r, const scalar z, const scalar ringVolume)
    {
        const label n = fourfold(2*pi*r/spacing);
        for (label i = 0; i < n; ++i)
        {
            const scalar phi = 2*pi*(i + 0.5)/n;
            append(centre + vector(r*std::cos(phi), r*std::sin(phi), z), ringVolume/n);
        }
    };
    const auto ball = [&](const scalar r){ return ballMeasures(centre, r, dim).volume; };

    scalar outer = radius;
    for (label layer = 0; layer < nLayers && outer > 0; ++layer)
    {
        const scalar inner = outer - spacing;
        const scalar middle = outer - 0.5*spacing;
        if (inner <= 0)
        {
            append(centre, ball(outer));
        }
        else if (dim == 2)
        {
            ring(middle, 0, ball(outer) - ball(inner));
        }
        else
        {
            // An even number of rings, for the symmetry about the equator
            const label n = 2*max(label(1), label(std::lround(0.5*pi*middle/spacing)));
            for (label i = 0; i < n; ++i)
            {
                const scalar theta = pi*(i + 0.5)/n;
                const scalar share = 0.5*(std::cos(pi*i/n) - std::cos(pi*(i + 1)/n));
                ring(middle*std::sin(theta), middle*std::cos(theta), share*(ball(outer) - ball(inner)));
            }
        }
        outer = inner;
    }
    if (outer > 0)
    {
        represented += ballMeasures(centre, outer, dim);
    }
    return {pointField(std::move(x)), scalarField(std::move(volume))};
}


Foam::smoothedParticles::wallParticles Foam::smoothedParticles::surfaceLayers
(
    const shape& surface,
    const scalar spacing,
    const label nLayers,
    const std::vector<symmetryPlane>& symmetry,
    solidMeasures& represented
)
{
    const int dim = surface.dim();
    const sampledSolid solid(surface, spacing, nLayers, symmetry);

    // Parts that are thinner than a spacing have their particles in the middle, up to this much nearer to the surface
    const scalar thin = 0.25*spacing;

    // From a particle to the points of its part
    const scalar reach = 1.25*spacing;

    // Particles at the start are no nearer to each other; so that on average each has the volume of a cell of the spacing
    const scalar apart = (dim == 2 ? 0.9 : 0.82)*spacing;

    const auto layerOf = [&](const scalar depth){ return label(max(depth, scalar(0))/spacing); };
    const auto depthOf = [&](const label layer){ return (layer + 0.5)*spacing; };
    const auto moved = [](const shape::foot& foot, const point& p, const scalar depth)
    {
        return foot.x + depth/foot.depth*(p - foot.x);
    };

    DynamicList<point> x;
    DynamicList<label> layers;
    pointColumns columns(surface.bounds(), reach);
    const auto append = [&](const point& p, const label layer, const scalar distance)
    {
        if (columns.findNearest(p, distance) < 0 && isOnNearSide(p, symmetry, 0.5*distance))
        {
            columns.append(p);
            x.append(p);
            layers.append(layer);
        }
    };
    for (const auto& p : solid.points)
    {
        const label layer = layerOf(p.depth);
        const scalar beyond = p.depth - depthOf(layer);
        if (beyond >= 0 && beyond < 2*solid.pointSpacing())
        {
            const shape::foot foot(surface.findNearest(p.x, (1 + 1e-9)*p.depth));
            append(moved(foot, p.x, depthOf(layer)), layer, apart);
        }
    }

    // Where the solid is too thin for these
    for (const auto& p : solid.points)
    {
        const label layer = layerOf(p.depth);
        const scalar beyond = p.depth - depthOf(layer);
        if (beyond < 0 && beyond > -thin)
        {
            append(p.x, layer, 1.15*spacing);
        }
    }

    // Each point belongs to the nearest particles, softly, so that the number of points does not show: shares of a Gaussian
    const scalar overWidth2 = 1/sqr(0.2*spacing);
    scalarField volume;
    vectorField moment;
    const auto partition = [&]()
    {
        const pointColumns now(pointField(x), reach);
        volume = scalarField(x.size(), Zero);
        moment = vectorField(x.size(), Zero);
        DynamicList<label> near;
        DynamicList<scalar> share;
        for (const auto& p : solid.points)
        {
            near.clear();
            share.clear();
            scalar least = GREAT;
            now.forNear
            (
                p.x, reach,
                [&](const label i, const scalar r2)
                {
                    near.append(i);
                    share.append(r2);
                    least = min(least, r2);
                }
            );
            scalar sum = 0;
            for (scalar& s : share)
            {
                s = std::exp(-0.5*overWidth2*(s - least));
                sum += s;
            }
            forAll(near, k)
            {
                const scalar part = share[k]/sum*p.volume;
                volume[near[k]] += part;
                moment[near[k]] += part*p.x;
            }
        }
    };

    constexpr label nIterations = 5;
    for (label iteration = 0; iteration < nIterations; ++iteration)
    {
        partition();
        forAll(x, i)
        {
            if (volume[i] > 0)
            {
                x[i] = moment[i]/volume[i];
                const scalar depth = depthOf(layers[i]);
                const shape::foot foot(surface.findNearest(x[i], GREAT));
                const point onSet(moved(foot, x[i], depth));
                if (foot.depth >= depth || surface.findNearest(onSet, GREAT).depth > depth - thin)
                {
                    x[i] = onSet;
                }
            }
        }
    }
    partition();

    represented = solidMeasures();
    forAll(x, i)
    {
        represented.add(x[i], volume[i]);
    }
    for (const symmetryPlane& plane : symmetry)
    {
        const boundBox& box = surface.bounds();
        if (plane.distance(box.min()) < 0 || plane.distance(box.max()) < 0)
        {
            represented += represented.mirrored(plane.axis, plane.at);
        }
    }
    represented += solid.deep;
    return {pointField(std::move(x)), std::move(volume)};
}

// ************************************************************************* //
