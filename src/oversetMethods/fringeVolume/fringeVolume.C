// SPDX-License-Identifier: GPL-3.0-or-later

#include "fringeVolume.H"
#include "surfaceFields.H"
#include "volFields.H"
#include "profiling.H"

#include <cstdio>
#include <cstdlib>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fringeVolume::fringeVolume
(
    const compositeMesh& composite,
    const volScalarField& alpha
)
:
    IOdictionary
    (
        IOobject
        (
            "fringeVolume",
            alpha.time().timeName(),
            "uniform",
            alpha.time(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    composite_(composite),
    unique_(uniqueVolume::New(alpha.mesh())),
    expected_
    (
        found("expected")
      ? std::strtod(get<string>("expected").c_str(), nullptr)
      : unique_.of(alpha.primitiveField())
    ),
    expectedOld_(expected_),
    timeIndex_(alpha.time().timeIndex())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fringeVolume::conserve
(
    volScalarField& alpha,
    const surfaceScalarField& alphaPhi
)
{
    addProfiling(fringe, "fringe volume");

    if (timeIndex_ != alpha.time().timeIndex())
    {
        timeIndex_ = alpha.time().timeIndex();
        expectedOld_ = expected_;
    }

    expected_ =
        expectedOld_ - unique_.outflow(alphaPhi)*alpha.time().deltaTValue();

    // Fractions of what a cell has or lacks, at most, in a step
    const scalar most = 0.1;

    scalarField& a = alpha.primitiveFieldRef();
    scalar error = unique_.of(a) - expected_;
    const auto giveBack = [&](const scalarField& cells)
    {
        scalarField room(cells*max(a*(1 - a), scalar(0)));

        // Acceptors follow what their donors are given
        alpha.mesh().interpolate(room);

        const scalar all = unique_.of(room);
        if (all <= 0)
        {
            return false;
        }
        const scalar share = error/all;
        a -= max(-most, min(most, share))*room;
        alpha.correctBoundaryConditions();
        error = unique_.of(a) - expected_;
        return mag(share) <= most;
    };

    // Where it arose, or else wherever there is an interface: a body that is
    // deep has left the surface behind, with what it has drawn down
    if (!giveBack(composite_.donorCells()))
    {
        giveBack(composite_.calculatedCells());
    }

    // With all its digits, whatever precision is written with
    char digits[32];
    std::snprintf(digits, sizeof(digits), "%.17g", expected_);
    set("expected", string(digits));
    set("error", error);
}


// ************************************************************************* //
