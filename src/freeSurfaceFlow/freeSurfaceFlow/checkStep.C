// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "inputChecks.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::freeSurfaceFlow::smallLoad() const
{
    scalar length, speed;
    string origin;
    referenceScales(length, speed, origin);

    const scalar g = buoyancy_ ? mag(buoyancy_->g).value() : 0;
    return
        body_
      ? 0.01*body_->mass()*(g + sqr(speed)/length)
      : 0.01*mixture_.rho1().value()*sqr(speed)*scalesOfWalls().area;
}


Foam::scalar Foam::freeSurfaceFlow::diffusionNumber() const
{
    const scalar heavier = max(mixture_.rho1().value(), mixture_.rho2().value());

    // The liquid may come to the finest cells, wherever it is now
    const scalar nu = gMax(mixture_.nu()().primitiveField()*rho_.primitiveField())/heavier;
    return guard_->diffusionNumber(scalarField(mesh_.nCells(), nu));
}


void Foam::freeSurfaceFlow::checkLastStep()
{
    checkCorrections();
    if (isGiven())
    {
        return;
    }
    guard_->checkSolvers();
    guard_->checkDiffusion
    (
        diffusionNumber(),
        pimple_.dict().getOrDefault<label>("nCorrectors", 1)
    );

    const labelHashSet patches
    (
        body_ ? body_->patches() : mesh_.boundaryMesh().findPatchIDs<wallPolyPatch>()
    );
    vector load(Zero);
    for (const label patchi : patches)
    {
        load += sum(p_.boundaryField()[patchi]*mesh_.boundary()[patchi].Sf());
    }
    guard_->checkLoads(returnReduce(load, sumOp<vector>()));
}


void Foam::freeSurfaceFlow::checkFixedStep(const scalar Co)
{
    if (isGiven())
    {
        return;
    }
    const scalar largest = runGuard::largestCourant(nCorrections());
    if (time_.timeIndex() == time_.startTimeIndex() && Co > largest)
    {
        refuseEntry
        (
            time_.controlDict(),
            "deltaT",
            text("is ", time_.deltaTValue(), ", at which the Courant number is ", Co, ", but a step has one pressure correction"),
            text("a Courant number of at most ", largest, ", or nCorrectors 2 in system/fvSolution.")
        );
    }
    guard_->checkCourant(Co, nCorrections());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::freeSurfaceFlow::finish()
{
    if (time_.timeIndex() != time_.startTimeIndex())
    {
        checkLastStep();
    }
}

// ************************************************************************* //
