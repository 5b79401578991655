// SPDX-License-Identifier: GPL-3.0-or-later

#include "lattice.H"

#include "inputChecks.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::smoothedParticles::lattice::checkFits(const dictionary& dict, const string& what, const boundBox& box) const
{
    const vector n(nCells(box));
    for (direction d = 0; d < dim; ++d)
    {
        if (!(n[d] >= 1))
        {
            refuse
            (
                dict,
                text("Entries min and max are ", box.min(), " and ", box.max()),
                text("a box of at least half the spacing, ", spacing, " m, in each direction.")
            );
        }
    }
    if (!isMultiple(box))
    {
        IOWarningInFunction(dict)
            << what.c_str() << ": the size of the box, " << box.max() - box.min()
            << " m, is no multiple of the spacing, " << spacing << " m." << nl
            << "    Its particles are stretched to cells of " << cell(box) << " m." << endl;
    }
}


Foam::vector Foam::smoothedParticles::lattice::cell(const boundBox& box) const
{
    const vector n(nCells(box));
    vector size(1, 1, 1);
    for (direction d = 0; d < dim; ++d)
    {
        size[d] = (box.max()[d] - box.min()[d])/n[d];
    }
    return size;
}

// ************************************************************************* //
