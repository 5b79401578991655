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

// ************************************************************************* //
