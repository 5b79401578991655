// SPDX-License-Identifier: GPL-3.0-or-later

#include "backwardDifference.H"
#include "backwardDdtScheme.H"
#include "EulerDdtScheme.H"
#include "fvc.H"
#include "fvm.H"
#include "localMin.H"
#include "oversetFvPatch.H"
#include "processorFvPatch.H"
#include "restart.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::backwardDifference::weight() const
{
    const Time& time = mesh_.time();
    return hasPast() ? time.deltaTValue()/(time.deltaTValue() + time.deltaT0Value()) : 0;
}


Foam::scalar Foam::backwardDifference::half() const
{
    return hasPast() ? 0.5*mesh_.time().deltaTValue()/mesh_.time().deltaT0Value() : 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::backwardDifference::backwardDifference
(
    const compositeMesh& composite,
    const volVectorField& U
)
:
    mesh_(U.mesh()),
    composite_(composite),
    U_(U),
    steady_
    (
        restart::field("ddtSteady", mesh_),
        mesh_,
        dimensionedScalar("one", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    ),
    share_(),
    toEnd_()
{
    composite_.doNotInterpolate({steady_.name()});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::backwardDifference::isWanted(const fvMesh& mesh)
{
    return word(mesh.ddtScheme("ddt(rho,U)")) == fv::backwardDdtScheme<vector>::typeName;
}


Foam::tmp<Foam::surfaceVectorField> Foam::backwardDifference::velocityToMiddle()
{
    volVectorField change("change", hasPast() ? half()*(U_.oldTime() - U_.oldTime().oldTime()) : 0*U_);
    for (fvPatchVectorField& p : change.boundaryFieldRef())
    {
        // Of an overset boundary a restart knows the cells alone
        if (isA<oversetFvPatch>(p.patch()))
        {
            p == p.patchInternalField();
        }
    }
    tmp<surfaceVectorField> tchange(fvc::interpolate(change));
    // With that of the mesh, whose flux is the mean of the step
    toEnd_ = (mesh_.Sf() & tchange()) - (fvc::meshPhi(U_) - mesh_.phi());
    for (fvsPatchScalarField& p : toEnd_.ref().boundaryFieldRef())
    {
        if (!p.coupled())
        {
            p = 0;
        }
    }
    return tchange;
}


void Foam::backwardDifference::moveToMiddle(surfaceScalarField& phi, const bool first)
{
    if (first && !hasPast())
    {
        toEnd_ = 0*phi;
    }
    else if (first)
    {
        toEnd_ = half()*(phi.oldTime() - phi.oldTime().oldTime());
        phi += toEnd_();
    }
    else
    {
        toEnd_ = 0.5*(phi - phi.oldTime());
        composite_.maskOld(toEnd_.ref());
        phi -= toEnd_();
    }
}


void Foam::backwardDifference::update(const volScalarField& rho)
{
    const scalarField& now = rho.primitiveField();
    const scalarField& before = rho.oldTime().primitiveField();
    steady_.oldTime();
    scalarField& steady = steady_.primitiveFieldRef();
    forAll(steady, celli)
    {
        steady[celli] = max(scalar(0), 1 - mag(now[celli] - before[celli])/min(now[celli], before[celli]));
    }
    composite_.maskCalculated(steady);
    steady_.correctBoundaryConditions();
    share_ = min(steady_, steady_.oldTime());
}


Foam::tmp<Foam::surfaceScalarField> Foam::backwardDifference::massFlux
(
    const volScalarField& rho,
    const surfaceScalarField& rhoPhi
) const
{
    return tmp<surfaceScalarField>::New
    (
        rhoPhi.name(),
        rhoPhi + localMin<scalar>(mesh_).interpolate(share_())*fvc::interpolate(rho)*toEnd_()
    );
}


void Foam::backwardDifference::extrapolate(volVectorField& U) const
{
    if (hasPast())
    {
        U.primitiveFieldRef() =
            U_.oldTime().primitiveField()
          + 2*half()*share_().primitiveField()*(U_.oldTime().primitiveField() - U_.oldTime().oldTime().primitiveField());
        U.correctBoundaryConditions();
    }
}


Foam::tmp<Foam::fvVectorMatrix> Foam::backwardDifference::ddt
(
    const volScalarField& rho,
    volVectorField& U
) const
{
    tmp<fvVectorMatrix> teqn(fv::EulerDdtScheme<vector>(mesh_).fvmDdt(rho, U));
    if (hasPast())
    {
        const volVectorField& U0 = U.oldTime();
        const volScalarField rate(share_()/mesh_.time().deltaT());
        const volScalarField last("ddtLast", weight()*rate*rho);
        const volScalarField density("ddtDensity", rate*(rho - rho.oldTime()));
        teqn.ref() +=
            fvm::Sp(last, U) - last*(U0 + 2*half()*(U0 - U0.oldTime()))
          + fvm::Sp(density, U) - density*U0;
    }
    return teqn;
}


Foam::tmp<Foam::surfaceScalarField> Foam::backwardDifference::ddtCorr
(
    const surfaceScalarField& phi,
    const autoPtr<surfaceVectorField>& Uf
) const
{
    // By how much the flux differs from the velocity's
    const auto excess = [&](const surfaceScalarField& flux, const volVectorField& U)
    {
        return tmp<surfaceScalarField>(flux - fvc::flux(U));
    };
    const volVectorField& U0 = U_.oldTime();
    const surfaceScalarField flux0(Uf ? tmp<surfaceScalarField>(mesh_.Sf() & Uf().oldTime()) : tmp<surfaceScalarField>(phi.oldTime()));
    const surfaceScalarField excess0(excess(flux0, U0));

    tmp<surfaceScalarField> tfactor(fv::EulerDdtScheme<vector>(mesh_).fvcDdtPhiCoeff(U0, flux0, excess0));
    tmp<surfaceScalarField> tkept(excess0);
    if (hasPast())
    {
        const surfaceScalarField faceShare(localMin<scalar>(mesh_).interpolate(share_()));
        const auto keep = [](scalarField& factor, const scalarField& share)
        {
            factor += share*(1 - factor);
        };
        surfaceScalarField& factor = tfactor.ref();
        keep(factor.primitiveFieldRef(), faceShare.primitiveField());
        forAll(faceShare.boundaryField(), patchi)
        {
            if (isA<processorFvPatch>(mesh_.boundary()[patchi]))
            {
                keep(factor.boundaryFieldRef()[patchi], faceShare.boundaryField()[patchi]);
            }
        }
        tkept =
            excess0
          + weight()*faceShare
           *(
                (1 + 2*half())*excess0
              - 2*half()*excess(Uf ? tmp<surfaceScalarField>(mesh_.Sf() & Uf().oldTime().oldTime()) : tmp<surfaceScalarField>(phi.oldTime().oldTime()), U0.oldTime())
            );
    }
    return tfactor*tkept/mesh_.time().deltaT();
}


void Foam::backwardDifference::endStep
(
    const surfaceScalarField& phi,
    const autoPtr<surfaceVectorField>& Uf
) const
{
    // Also of the first step, which a restart goes on from as from any other
    const auto keep = [](const auto& field)
    {
        field.oldTime().oldTime();
        const_cast<IOobject&>(static_cast<const IOobject&>(field.oldTime())).writeOpt() = IOobject::AUTO_WRITE;
    };
    keep(U_);
    keep(phi);
    if (Uf)
    {
        keep(Uf());
    }
}

// ************************************************************************* //
