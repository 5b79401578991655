// SPDX-License-Identifier: GPL-3.0-or-later
// The walls around a tank: layers of cells behind its closed faces

#include "boxWall.H"

#include "addToRunTimeSelectionTable.H"
#include "tankShape.H"

namespace Foam
{
namespace smoothedParticles
{

class tankWall
:
    public boxWall
{
    const tankShape& tank_;

    virtual wallParticles fillUp()
    {
        latticeLines lines(fill(box_, n_));
        for (direction d = 0; d < grid_.dim; ++d)
        {
            const scalar dp = grid_.spacing;
            const label n = grid_.nLayers();
            if (!tank_.isOpen(2*d))
            {
                appendCells(lines[d], box_.min()[d], -dp, n);
            }
            if (!tank_.isOpen(2*d + 1))
            {
                appendCells(lines[d], box_.max()[d], dp, n);
            }
        }
        return withVolumes(crossings(lines, [&](const point& p){ return !box_.contains(p); }));
    }


public:

    tankWall(const dictionary& dict, const shape& region, const lattice& grid)
    :
        boxWall(dict, region, grid, refCast<const tankShape>(region).inside()),
        tank_(refCast<const tankShape>(region))
    {}

    virtual scalar nParticles() const
    {
        scalar all = 1;
        for (direction d = 0; d < grid_.dim; ++d)
        {
            all *= n_[d] + (!tank_.isOpen(2*d) + !tank_.isOpen(2*d + 1))*grid_.nLayers();
        }
        return all - cmptProduct(n_);
    }
};


addNamedToRunTimeSelectionTable(filledWall, tankWall, shape, tank);

} // End namespace smoothedParticles
} // End namespace Foam

// ************************************************************************* //
