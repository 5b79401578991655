// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "adjustPhi.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "findRefCell.H"
#include "fvc.H"
#include "fvm.H"
#include "oversetAdjustPhi.H"
#include "profiling.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::freeSurfaceFlow::correctUf()
{
    if (!Uf_)
    {
        return;
    }

    // The normal part is the flux's, the rest is interpolated
    surfaceVectorField& Uf = Uf_();
    Uf = fvc::interpolate(U_);
    const surfaceVectorField n(mesh_.Sf()/mesh_.magSf());
    Uf += n*(phi_/mesh_.magSf() - (n & Uf));
}


void Foam::freeSurfaceFlow::printContinuityError()
{
    scalarField error(fvc::div(phi_)().primitiveField());
    if (composite_)
    {
        // Fringe and holes are not solved: the volume ledger covers them
        error *= composite_->calculatedCells();
    }

    const scalarField& V = mesh_.V().field();
    const scalar perVolume = time_.deltaTValue()/gSum(V);
    const scalar global = perVolume*gSum(error*V);
    cumulativeContinuityError_ += global;

    Info<< "time step continuity errors : sum local = "
        << perVolume*gSum(mag(error)*V)
        << ", global = " << global
        << ", cumulative = " << cumulativeContinuityError_ << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::freeSurfaceFlow::correctPressure()
{
    addProfiling(pressure, "pressure");

    const meshControls c = controls();
    fvVectorMatrix& UEqn = UEqn_.ref();

    tmp<volScalarField> trAU;
    if (rAU_.valid())
    {
        rAU_.ref() = 1.0/UEqn.A();
        trAU = tmp<volScalarField>(rAU_());
    }
    else
    {
        trAU = 1.0/UEqn.A();
    }
    const volScalarField& rAU = trAU();
    const surfaceScalarField rAUf("rAUf", fvc::interpolate(rAU));

    const volVectorField HbyA
    (
        "HbyA",
        constrainHbyA(rAU*UEqn.H(), U_, p_rgh_)
    );
    surfaceScalarField phiHbyA("phiHbyA", fvc::flux(HbyA));

    if (!composite_)
    {
        phiHbyA +=
            MRF_.zeroFilter
            (
                fvc::interpolate(rho_*rAU)*fvc::ddtCorr(U_, phi_, Uf_)
            );
    }
    else if (c.ddtCorr)
    {
        phiHbyA +=
            fvc::interpolate(rho_*rAU)
           *composite_->faceMaskOld()
           *fvc::ddtCorr(U_, Uf_());
    }
    MRF_.makeRelative(phiHbyA);

    if (p_rgh_.needReference())
    {
        fvc::makeRelative(phiHbyA, U_);
        adjustPhi(phiHbyA, U_, p_rgh_);
        fvc::makeAbsolute(phiHbyA, U_);
    }

    tmp<surfaceScalarField> tphig(bodyForces());
    if (tphig.valid())
    {
        tphig = tphig*rAUf*mesh_.magSf();
        if (composite_)
        {
            tphig.ref() *= composite_->faceMask();
        }
        phiHbyA += tphig();
    }

    if (composite_ && c.oversetAdjustPhi)
    {
        fvc::makeRelative(phiHbyA, U_);
        oversetAdjustPhi(phiHbyA, U_);
        fvc::makeAbsolute(phiHbyA, U_);
    }

    constrainPressure(p_rgh_, U_, phiHbyA, rAUf, MRF_);

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix p_rghEqn
        (
            fvm::laplacian(rAUf, p_rgh_) == fvc::div(phiHbyA)
        );
        p_rghEqn.setReference(pRefCell_, getRefCellValue(p_rgh_, pRefCell_));
        p_rghEqn.solve(mesh_.solver(p_rgh_.select(pimple_.finalInnerIter())));

        if (pimple_.finalNonOrthogonalIter())
        {
            surfaceScalarField dPhi(-p_rghEqn.flux());
            phi_ = phiHbyA + dPhi;
            p_rgh_.relax();

            if (tphig.valid())
            {
                dPhi += tphig();
            }
            U_ = HbyA + rAU*fvc::reconstruct(dPhi/rAUf);
            if (composite_)
            {
                U_ *= composite_->cellMask();
            }
            U_.correctBoundaryConditions();
            fvOptions_.correct(U_);
        }
    }

    printContinuityError();

    correctUf();
    fvc::makeRelative(phi_, U_);
    if (composite_)
    {
        phi_ *= composite_->faceMask();
    }

    setPressure();
}

// ************************************************************************* //
