// SPDX-License-Identifier: GPL-3.0-or-later

#include "MULESScheme.H"
#include "addToRunTimeSelectionTable.H"
#include "backwardDdtScheme.H"
#include "CMULES.H"
#include "CrankNicolsonDdtScheme.H"
#include "EulerDdtScheme.H"
#include "fvc.H"
#include "fvm.H"
#include "gaussConvectionScheme.H"
#include "inputChecks.H"
#include "localEulerDdtScheme.H"
#include "upwind.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace interfaceSchemes
{
    defineTypeNameAndDebug(MULES, 0);
    addToRunTimeSelectionTable(interfaceScheme, MULES, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfaceSchemes::MULES::MULES(const fields& f)
:
    interfaceScheme(f),
    restart_(alphaPhi_.typeHeaderOk<surfaceScalarField>(true)),
    lastCorrection_()
{
    mesh_.setFluxRequired(alpha1_.name());

    // Refuse the time schemes that the method does not cover
    (void)offCentring();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::interfaceSchemes::MULES::offCentring() const
{
    const tmp<fv::ddtScheme<scalar>> scheme
    (
        fv::ddtScheme<scalar>::New(mesh_, mesh_.ddtScheme("ddt(alpha)"))
    );

    if
    (
        isType<fv::EulerDdtScheme<scalar>>(scheme())
     || isType<fv::localEulerDdtScheme<scalar>>(scheme())
    )
    {
        return 0;
    }

    if (isType<fv::backwardDdtScheme<scalar>>(scheme()))
    {
        return 1;
    }

    if (isType<fv::CrankNicolsonDdtScheme<scalar>>(scheme()))
    {
        if (controls().get<label>("nAlphaSubCycles") > 1)
        {
            refuseEntry
            (
                controls(),
                "nAlphaSubCycles",
                text("is ", controls().get<label>("nAlphaSubCycles")),
                "1 with the CrankNicolson time scheme."
            );
        }

        // The first step has no old flux to blend with
        const Time& time = mesh_.time();
        return
            restart_ || time.timeIndex() > time.startTimeIndex() + 1
          ? refCast<const fv::CrankNicolsonDdtScheme<scalar>>
            (
                scheme()
            ).ocCoeff()
          : 0;
    }

    refuse
    (
        mesh_.schemesDict().subDict("ddtSchemes"),
        text("Entry ddt(alpha) (or default) is ", scheme().type()),
        "Euler, localEuler, backward or CrankNicolson for the interface scheme MULES."
    );
    return 0;
}


bool Foam::interfaceSchemes::MULES::isBackward() const
{
    return word(mesh_.ddtScheme("ddt(alpha)")) == fv::backwardDdtScheme<scalar>::typeName;
}


bool Foam::interfaceSchemes::MULES::isUniform() const
{
    // Processors have different numbers of patches
    MinMax<scalar> range(minMax(alpha1_.primitiveField()));
    for (const fvPatchScalarField& p : alpha1_.boundaryField())
    {
        range.add(minMax(p));
    }
    scalar least = range.min();
    scalar most = range.max();
    reduce(least, minOp<scalar>());
    reduce(most, maxOp<scalar>());
    return least == most;
}


Foam::tmp<Foam::surfaceScalarField>
Foam::interfaceSchemes::MULES::centredPhi(const scalar cn) const
{
    // With backward it is that of the middle of the step already
    if (cn == 1 || isBackward())
    {
        return f_.phi;
    }
    return cn*f_.phi + (1 - cn)*f_.phi.oldTime();
}


Foam::tmp<Foam::volScalarField::Internal>
Foam::interfaceSchemes::MULES::absoluteDivergence
(
    const surfaceScalarField& phi
) const
{
    return tmp<volScalarField::Internal>::New
    (
        mesh_.moving()
      ? fvc::div(phi + mesh_.phi())().internalField()
      : fvc::div(phi)().internalField()
    );
}


Foam::tmp<Foam::surfaceScalarField>
Foam::interfaceSchemes::MULES::compression(const dictionary& controls) const
{
    const scalar cAlpha = f_.interface->cAlpha();
    const scalar icAlpha = controls.lookupOrDefault<scalar>("icAlpha", 0);
    const scalar scAlpha = controls.lookupOrDefault<scalar>("scAlpha", 0);

    tmp<surfaceScalarField> tphic(cAlpha*mag(f_.phi/mesh_.magSf()));
    surfaceScalarField& phic = tphic.ref();

    // Isotropic share
    if (icAlpha > 0)
    {
        phic *= 1 - icAlpha;
        phic += (cAlpha*icAlpha)*fvc::interpolate(mag(f_.U));
    }

    // Share of the shear
    if (scAlpha > 0)
    {
        phic +=
            scAlpha
           *mag(mesh_.delta() & fvc::interpolate(symm(fvc::grad(f_.U))));
    }

    // The liquid that a boundary lets in or out is not compressed
    for (fvsPatchScalarField& p : phic.boundaryFieldRef())
    {
        if (!p.coupled())
        {
            p == 0;
        }
    }

    return tphic;
}


void Foam::interfaceSchemes::MULES::predict
(
    const surfaceScalarField& phi,
    const bool applyLastCorrection
)
{
    fvScalarMatrix eqn
    (
        (
            fv::localEulerDdt::enabled(mesh_)
          ? fv::localEulerDdtScheme<scalar>(mesh_).fvmDdt(alpha1_)
          : fv::EulerDdtScheme<scalar>(mesh_).fvmDdt(alpha1_)
        )
      + fv::gaussConvectionScheme<scalar>
        (
            mesh_,
            phi,
            upwind<scalar>(mesh_, phi)
        ).fvmDiv(phi, alpha1_)
    );
    if (f_.composite.isOverset())
    {
        eqn -= fvm::Sp(absoluteDivergence(phi)(), alpha1_);
    }
    eqn.solve();

    const tmp<surfaceScalarField> tupwind(eqn.flux());
    alphaPhi_ = tupwind();

    if (applyLastCorrection && lastCorrection_.valid())
    {
        Foam::MULES::correct
        (
            geometricOneField(),
            alpha1_,
            alphaPhi_,
            lastCorrection_.ref(),
            oneField(),
            zeroField()
        );
        alphaPhi_ += lastCorrection_();
    }

    lastCorrection_ = tupwind;
    alpha2_ = 1 - alpha1_;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::interfaceSchemes::MULES::advance()
{
    const dictionary& c = controls();
    const label nCorr = c.get<label>("nAlphaCorr");
    const bool implicit = c.lookupOrDefault<bool>("MULESCorr", false);
    const bool reuse = c.lookupOrDefault<bool>("alphaApplyPrevCorr", false);

    // Weight of the new time level
    const scalar cn = 1/(1 + offCentring());

    const tmp<surfaceScalarField> tphi(centredPhi(cn));
    const surfaceScalarField& phi = tphi();

    if (isUniform())
    {
        alphaPhi_ = phi*fvc::interpolate(alpha1_);
        return;
    }

    const surfaceScalarField phic(compression(c));

    if (implicit)
    {
        predict(phi, reuse);
    }

    for (label corr = 0; corr < nCorr; ++corr)
    {
        // With contact angles the normals are those that the last step, or
        // correction, has found
        if (!contactAngles_ || (implicit && corr == 0))
        {
            f_.interface->correct();
        }
        const surfaceScalarField phir(phic*f_.interface->nHatf());

        tmp<surfaceScalarField> tunbounded
        (
            fvc::flux
            (
                phi,
                cn*alpha1_ + (1 - cn)*alpha1_.oldTime(),
                "div(phi,alpha)"
            )
          + fvc::flux
            (
               -fvc::flux(-phir, alpha2_, "div(phirb,alpha)"),
                alpha1_,
                "div(phirb,alpha)"
            )
        );

        if (implicit)
        {
            tmp<surfaceScalarField> tcorrection(tunbounded() - alphaPhi_);
            const volScalarField alphaLast("alphaLast", alpha1_);

            Foam::MULES::correct
            (
                geometricOneField(),
                alpha1_,
                tunbounded(),
                tcorrection.ref(),
                oneField(),
                zeroField()
            );

            // All but the first corrector are under-relaxed
            if (corr == 0)
            {
                alphaPhi_ += tcorrection();
            }
            else
            {
                alpha1_ = 0.5*alpha1_ + 0.5*alphaLast;
                alphaPhi_ += 0.5*tcorrection();
            }
        }
        else
        {
            alphaPhi_ = tunbounded;

            if (f_.composite.isOverset())
            {
                const volScalarField::Internal divU(absoluteDivergence(phi));
                Foam::MULES::explicitSolve
                (
                    geometricOneField(),
                    alpha1_,
                    phi,
                    alphaPhi_,
                    zeroField(),
                    (divU*min(alpha1_(), scalar(1)))(),
                    oneField(),
                    zeroField()
                );
            }
            else
            {
                Foam::MULES::explicitSolve
                (
                    geometricOneField(),
                    alpha1_,
                    phi,
                    alphaPhi_,
                    oneField(),
                    zeroField()
                );
            }
        }

        alpha2_ = 1 - alpha1_;

        if (contactAngles_)
        {
            f_.interface->correct();
        }
    }

    if (reuse && implicit)
    {
        lastCorrection_ = alphaPhi_ - lastCorrection_;
        lastCorrection_.ref().rename("alphaPhiCorrection");
    }
    else
    {
        lastCorrection_.clear();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::interfaceSchemes::MULES::advect()
{
    subCycle();

    const scalar oc = offCentring();
    const scalar cn = 1/(1 + oc);

    const word scheme(mesh_.ddtScheme("ddt(rho,U)"));
    if
    (
        scheme == fv::EulerDdtScheme<vector>::typeName
     || scheme == fv::localEulerDdtScheme<vector>::typeName
     || scheme == fv::backwardDdtScheme<vector>::typeName
    )
    {
        setRhoPhi(centredPhi(cn)());
        return;
    }

    // The momentum equation wants the flux at the end of the step
    if (oc > 0)
    {
        alphaPhi_ = (alphaPhi_ - (1 - cn)*alphaPhi_.oldTime())/cn;
    }
    setRhoPhi(f_.phi);
}

// ************************************************************************* //
