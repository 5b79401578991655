// SPDX-License-Identifier: GPL-3.0-or-later

#include "filledWall.H"

#include "inputChecks.H"
#include "layeredWall.H"

#include "DynamicList.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace smoothedParticles
{
    defineTypeNameAndDebug(filledWall, 0);
    defineRunTimeSelectionTable(filledWall, shape);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Particles nearer than this part of the spacing to one of a wall are removed. Round-off does not decide at the half.
constexpr Foam::scalar nearest = 0.5*(1 - 1e-6);

//- A solid whose particles' volume is off by more is refused
constexpr Foam::scalar volumeTolerance = 0.05;

//- Radius of a solid, over the spacing, from which on particles resolve the flow about it
constexpr Foam::scalar resolvedRadius = 2;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothedParticles::filledWall::filledWall(const dictionary& dict, const shape& region, const lattice& grid)
:
    shape_(region),
    grid_(grid),
    name(dict.get<word>("name"))
{}


Foam::autoPtr<Foam::smoothedParticles::filledWall> Foam::smoothedParticles::filledWall::New
(
    const dictionary& dict,
    const shape& region,
    const lattice& grid
)
{
    const auto own = shapeConstructorTablePtr_->cfind(region.type());
    if (own.found())
    {
        return own()(dict, region, grid);
    }
    return autoPtr<filledWall>(new layeredWall(dict, region, grid));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::smoothedParticles::filledWall::occupies(const point& p) const
{
    return reach_.contains(p) && (shape_.contains(p) || columns_->findNearest(p, nearest*grid_.spacing) >= 0);
}


void Foam::smoothedParticles::filledWall::make(const UPtrList<const filledWall>& others, const dictionary& dict)
{
    const wallParticles all(fillUp());
    DynamicList<point> kept;
    DynamicList<scalar> volume;
    forAll(all.x, k)
    {
        bool occupied = false;
        forAll(others, i)
        {
            occupied = occupied || others[i].occupies(all.x[k]);
        }
        if (occupied)
        {
            ++nRemoved;
        }
        else if (isOnNearSide(all.x[k], grid_.symmetry, sizeTolerance*grid_.spacing))
        {
            kept.append(all.x[k]);
            volume.append(all.volume[k]);
        }
    }
    if (kept.empty())
    {
        refuse
        (
            dict,
            text("Wall ", name, " has no particles; ", nRemoved, " were removed where there is another wall"),
            text("a larger wall, or a spacing below ", grid_.spacing, " m.")
        );
    }

    particles_.x.transfer(kept);
    particles_.volume.transfer(volume);
    columns_.reset(new pointColumns(particles_.x, grid_.spacing));
    reach_ = shape_.bounds();
    reach_.min() -= vector::uniform(grid_.spacing);
    reach_.max() += vector::uniform(grid_.spacing);
}


void Foam::smoothedParticles::filledWall::printSolid(Ostream& os) const
{
    const solidMeasures& solid = shape_.measures();
    if (solid.volume > 0)
    {
        os  << "        " << (grid_.dim == 2 ? "area" : "volume") << " of the lattice " << represented_.volume
            << ", of the shape " << solid.volume << (grid_.dim == 2 ? " m2" : " m3") << " ("
            << 100*(represented_.volume/solid.volume - 1) << " %); centroids "
            << mag(represented_.centroid() - solid.centroid())/grid_.spacing << " spacings apart; inertia differs by "
            << 100*mag(represented_.inertia() - solid.inertia())/mag(solid.inertia()) << " %" << nl;
    }
}


Foam::scalar Foam::smoothedParticles::filledWall::radius(const scalar enough) const
{
    const auto depth = [&](const point& p){ return shape_.findNearest(p, GREAT).depth; };
    scalarField depths(particles_.x.size());
    forAll(depths, k)
    {
        depths[k] = depth(particles_.x[k]);
    }

    // Uphill from the deepest particles, of which some may be on a ridge
    scalar largest = max(depths);
    const scalar deep = largest - 0.25*grid_.spacing;
    for (label k = 0; k < depths.size() && largest < enough; ++k)
    {
        point centre(particles_.x[k]);
        scalar here = depths[k];
        for (scalar step = here < deep ? 0 : 0.5*grid_.spacing; step > 0.01*grid_.spacing; step *= 0.5)
        {
            for (bool grows = true; grows;)
            {
                grows = false;
                for (direction i = 0; i < 2*grid_.dim; ++i)
                {
                    point p(centre);
                    p[i/2] += i % 2 ? step : -step;
                    const scalar there = depth(p);
                    if (there > here)
                    {
                        here = there;
                        centre = p;
                        grows = true;
                    }
                }
            }
        }
        largest = max(largest, here);
    }
    return largest;
}


void Foam::smoothedParticles::filledWall::checkSolid(const dictionary& dict, DynamicList<string>& notes) const
{
    const scalar volume = shape_.measures().volume;
    if (!(volume > 0))
    {
        return;
    }
    const word kind(grid_.dim == 2 ? "area" : "volume");
    const scalar off = represented_.volume/volume - 1;
    if (!(mag(off) <= volumeTolerance))
    {
        refuse
        (
            dict,
            text
            (
                "Wall ", name, ": the ", kind, " of its particles is ", represented_.volume, ", of the solid ", volume, ": ",
                100*off, " % off"
            ),
            text("at most ", 100*volumeTolerance, " %: a spacing below ", grid_.spacing, " m, or a thicker solid.")
        );
    }
    const scalar enough = resolvedRadius*grid_.spacing;
    const scalar largest = radius(enough);
    if (largest < 0.999*enough)
    {
        notes.append
        (
            text
            (
                "The particles are coarse: their spacing, ", grid_.spacing, " m, is more than half the radius of ", name, ", ",
                largest, " m: the forces on it may come out far too large."
            )
        );
    }
}

// ************************************************************************* //
