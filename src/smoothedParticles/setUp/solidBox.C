// SPDX-License-Identifier: GPL-3.0-or-later
// A wall that is a full box: its cells. Deeper than the kernel reaches there are no particles

#include "boxWall.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace smoothedParticles
{

class solidBox
:
    public boxWall
{
    virtual wallParticles fillUp()
    {
        return withVolumes
        (
            crossings
            (
                fill(box_, n_),
                [&](const point& p)
                {
                    represented_.add(p, cellVolume(p));
                    bool deep = true;
                    for (direction d = 0; d < grid_.dim; ++d)
                    {
                        deep = deep && min(p[d] - box_.min()[d], box_.max()[d] - p[d]) > grid_.support;
                    }
                    return !deep;
                }
            )
        );
    }


public:

    solidBox(const dictionary& dict, const shape& region, const lattice& grid)
    :
        boxWall(dict, region, grid, region.bounds())
    {}

    virtual scalar nParticles() const
    {
        scalar deep = 1;
        for (direction d = 0; d < grid_.dim; ++d)
        {
            deep *= max(n_[d] - 2*grid_.nLayers(), scalar(0));
        }
        return cmptProduct(n_) - deep;
    }
};


addNamedToRunTimeSelectionTable(filledWall, solidBox, shape, box);

} // End namespace smoothedParticles
} // End namespace Foam

// ************************************************************************* //
