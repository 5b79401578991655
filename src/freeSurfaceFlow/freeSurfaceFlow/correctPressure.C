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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sum over each cell's faces of a function of a face vector and a factor
template<class Type, class Function>
tmp<Field<Type>> sumOverFaces
(
    const surfaceVectorField& vectors,
    const surfaceScalarField& factors,
    const Function& f
)
{
    const fvMesh& mesh = vectors.mesh();
    tmp<Field<Type>> tsum(new Field<Type>(mesh.nCells(), Zero));
    Field<Type>& sum = tsum.ref();

    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(nei, facei)
    {
        const Type value(f(vectors[facei], factors[facei]));
        sum[own[facei]] += value;
        sum[nei[facei]] += value;
    }
    forAll(vectors.boundaryField(), patchi)
    {
        const labelUList& cells = mesh.boundary()[patchi].faceCells();
        const fvsPatchVectorField& vp = vectors.boundaryField()[patchi];
        const fvsPatchScalarField& fp = factors.boundaryField()[patchi];
        forAll(vp, i)
        {
            sum[cells[i]] += f(vp[i], fp[i]);
        }
    }
    return tsum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::vectorField> Foam::freeSurfaceFlow::reconstruct
(
    const surfaceVectorField& a,
    const surfaceScalarField& b
)
{
    if (!cellShapes_.valid())
    {
        cellShapes_ =
            inv
            (
                sumOverFaces<symmTensor>
                (
                    mesh_.Sf(),
                    mesh_.magSf(),
                    [](const vector& Sf, const scalar magSf)
                    {
                        return sqr(Sf)/magSf;
                    }
                )
            );
    }
    return
        cellShapes_()
      & sumOverFaces<vector>
        (
            a,
            b,
            [](const vector& ai, const scalar bi)
            {
                return ai*bi;
            }
        );
}


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


void Foam::freeSurfaceFlow::setCorrectorTerms()
{
    const tmp<volScalarField> trAU(1.0/UEqn_().A());
    if (rAU_.valid())
    {
        rAU_.ref() = trAU();
    }
    correctorTerms_.reset(new correctorTerms(trAU));
    const volScalarField& rAU = correctorTerms_->rAU;

    if (!composite_.isOverset())
    {
        correctorTerms_->ddtCorr =
            MRF_.zeroFilter
            (
                fvc::interpolate(rho_*rAU)
               *(backward_ ? backward_->ddtCorr(phi_, Uf_) : fvc::ddtCorr(U_, phi_, Uf_))
            );
    }
    else if (controls().ddtCorr)
    {
        correctorTerms_->ddtCorr =
            fvc::interpolate(rho_*rAU)
           *composite_.faceMaskOld()
           *(backward_ ? backward_->ddtCorr(phi_, Uf_) : fvc::ddtCorr(U_, Uf_()));
    }

    if (bodyForces_.valid())
    {
        tmp<surfaceScalarField> tforces
        (
            bodyForces_*correctorTerms_->rAUf*mesh_.magSf()
        );
        composite_.mask(tforces.ref());
        correctorTerms_->bodyForces = tforces;
    }
}


void Foam::freeSurfaceFlow::printContinuityError()
{
    scalarField error(fvc::div(phi_)().primitiveField());
    // Fringe and holes are not solved: the volume ledger covers them
    composite_.maskCalculated(error);

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

    if (!correctorTerms_)
    {
        setCorrectorTerms();
    }
    const volScalarField& rAU = correctorTerms_->rAU;
    const surfaceScalarField& rAUf = correctorTerms_->rAUf;
    const tmp<surfaceScalarField>& tphig = correctorTerms_->bodyForces;

    const volVectorField HbyA
    (
        "HbyA",
        constrainHbyA(rAU*UEqn.H(), U_, p_rgh_)
    );
    surfaceScalarField phiHbyA("phiHbyA", fvc::flux(HbyA));
    if (correctorTerms_->ddtCorr.valid())
    {
        phiHbyA += correctorTerms_->ddtCorr();
    }
    MRF_.makeRelative(phiHbyA);

    if (p_rgh_.needReference())
    {
        fvc::makeRelative(phiHbyA, U_);
        adjustPhi(phiHbyA, U_, p_rgh_);
        fvc::makeAbsolute(phiHbyA, U_);
    }

    if (tphig.valid())
    {
        phiHbyA += tphig();
    }

    if (c.oversetAdjustPhi)
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
        const auto solvePressure = [&]
        {
            p_rghEqn.setReference(pRefCell_, getRefCellValue(p_rgh_, pRefCell_));
            p_rghEqn.solve(mesh_.solver(p_rgh_.select(pimple_.finalInnerIter())));
        };
        solvePressure();

        // In a closed domain the fluid that the interpolation between zones
        // makes or takes has nowhere to go: the cell that is the reference
        // would be its source. It is spread over the flow. That source is
        // linear in what is spread, so that two more solutions make it zero
        if (composite_.isOverset() && p_rgh_.needReference())
        {
            const scalarField calculated(composite_.calculatedCells()*mesh_.V().field());
            const auto source = [&](const scalar spread)
            {
                const scalarField div(fvc::div(phiHbyA - p_rghEqn.flux())().primitiveField());
                return returnReduce
                (
                    pRefCell_ == -1 ? 0 : (div[pRefCell_] - spread)*mesh_.V()[pRefCell_],
                    sumOp<scalar>()
                );
            };
            const auto solveWith = [&](const scalar spread)
            {
                p_rghEqn =
                    fvScalarMatrix
                    (
                        fvm::laplacian(rAUf, p_rgh_) == fvc::div(phiHbyA)
                    );
                p_rghEqn.source() -= spread*calculated;
                solvePressure();
            };

            const scalar volume = gSum(calculated);
            const scalar first = source(0);
            if (mag(first) > SMALL*volume)
            {
                const scalar guess = first/volume;
                solveWith(guess);
                const scalar slope = (first - source(guess))/guess;

                // Zones that overlap too little leave it where it is
                solveWith(slope > 0.1*volume ? first/slope : 0);
            }
        }

        if (pimple_.finalNonOrthogonalIter())
        {
            surfaceScalarField dPhi(-p_rghEqn.flux());
            phi_ = phiHbyA + dPhi;
            p_rgh_.relax();

            if (tphig.valid())
            {
                dPhi += tphig();
            }
            U_.primitiveFieldRef() =
                HbyA.primitiveField()
              + rAU.primitiveField()
               *reconstruct(correctorTerms_->nByrAUf, dPhi);
            composite_.mask(U_);
            U_.correctBoundaryConditions();
            composite_.settle(U_);
            fvOptions_.correct(U_);
        }
    }

    printContinuityError();

    const bool last = pimple_.corrPISO() == pimple_.nCorrPISO();
    if (last)
    {
        correctUf();
    }
    fvc::makeRelative(phi_, U_);
    composite_.mask(phi_);
    if (last)
    {
        setPressure();
    }
}

// ************************************************************************* //
