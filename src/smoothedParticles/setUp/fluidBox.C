// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidBox.H"

#include "inputChecks.H"
#include "shape.H"
#include "Switch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothedParticles::fluidBox::fluidBox(const dictionary& dict, const lattice& grid)
:
    dict_(dict),
    grid_(grid),
    box_(readBox(dict, grid.dim)),
    n_(grid.nCells(box_)),
    velocity(dict.found("velocity") ? readVector(dict, "velocity", grid.dim) : Zero)
{
    checkKeywords(dict, {"type", "min", "max", "velocity", "hydrostatic", "surface"});
    grid.checkFits(dict, "Box of fluid", box_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::smoothedParticles::fluidBox::load(const pointField& points, const vector& weight) const
{
    const bool given = dict_.found("surface");
    if (!dict_.lookupOrDefault<Switch>("hydrostatic", true))
    {
        if (given)
        {
            refuseEntry(dict_, "surface", "is given, but hydrostatic is off", "one of them.");
        }
        return scalarField(points.size(), Zero);
    }

    const vector up(mag(weight) > 0 ? -weight/mag(weight) : vector::zero);
    const scalar top = cmptSum(max(cmptMultiply(up, box_.min()), cmptMultiply(up, box_.max())));
    const scalar surface = given ? dict_.get<scalar>("surface") : top;
    if (given && surface < top - sizeTolerance*grid_.spacing)
    {
        refuseEntry
        (
            dict_,
            "surface",
            text("is ", surface, " m, below the highest corner of the box at ", top, " m"),
            "a height at or above it."
        );
    }

    return mag(weight)*(surface - (points & up));
}

// ************************************************************************* //
