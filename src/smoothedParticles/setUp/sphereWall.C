// SPDX-License-Identifier: GPL-3.0-or-later
// A wall that is a sphere: layers of rings

#include "filledWall.H"

#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"
#include "sphereShape.H"

namespace Foam
{
namespace smoothedParticles
{

class sphereWall
:
    public filledWall
{
    const sphereShape& sphere_;

    virtual wallParticles fillUp()
    {
        return sphereLayers(sphere_.centre(), sphere_.radius(), grid_.dim, grid_.spacing, grid_.nLayers(), represented_);
    }


public:

    sphereWall(const dictionary& dict, const shape& region, const lattice& grid)
    :
        filledWall(dict, region, grid),
        sphere_(refCast<const sphereShape>(region))
    {
        if (!(sphere_.radius() >= grid.spacing))
        {
            refuseEntry
            (
                dict,
                "radius",
                text("is ", sphere_.radius()),
                text("at least the spacing, ", grid.spacing, " m.")
            );
        }
    }

    virtual scalar nParticles() const
    {
        return std::pow(2*sphere_.radius()/grid_.spacing, grid_.dim);
    }
};


addNamedToRunTimeSelectionTable(filledWall, sphereWall, shape, sphere);

} // End namespace smoothedParticles
} // End namespace Foam

// ************************************************************************* //
