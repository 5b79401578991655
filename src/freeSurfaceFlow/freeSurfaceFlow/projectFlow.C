// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "CorrectPhi.H"
#include "adjustPhi.H"
#include "fixedValueFvPatchFields.H"
#include "fvc.H"
#include "fvm.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::freeSurfaceFlow::potentialTypes() const
{
    wordList types
    (
        p_rgh_.boundaryField().size(),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(types, patchi)
    {
        if (p_rgh_.boundaryField()[patchi].fixesValue())
        {
            types[patchi] = fixedValueFvPatchScalarField::typeName;
        }
    }
    return types;
}


Foam::tmp<Foam::surfaceScalarField> Foam::freeSurfaceFlow::meshFlux() const
{
    if (!mesh_.moving())
    {
        return tmp<surfaceScalarField>::New("meshFlux", 0*phi_);
    }
    return backward_ ? tmp<surfaceScalarField>(mesh_.phi()) : fvc::meshPhi(U_);
}


void Foam::freeSurfaceFlow::projectFlux()
{
    correctUphiBCs(U_, phi_);
    if (backward_ && mesh_.moving())
    {
        // The velocity of a wall is that of the end of the step
        const surfaceScalarField atEnd(fvc::meshPhi(U_));
        forAll(U_.boundaryField(), patchi)
        {
            if (U_.boundaryField()[patchi].fixesValue())
            {
                phi_.boundaryFieldRef()[patchi] += mesh_.phi().boundaryField()[patchi] - atEnd.boundaryField()[patchi];
            }
        }
    }

    volScalarField pcorr
    (
        IOobject("pcorr", time_.timeName(), mesh_),
        mesh_,
        dimensionedScalar(p_rgh_.dimensions(), Zero),
        potentialTypes()
    );
    mesh_.setFluxRequired(pcorr.name());

    if (pcorr.needReference())
    {
        const tmp<surfaceScalarField> tmeshFlux(meshFlux());
        phi_ -= tmeshFlux();
        adjustPhi(phi_, U_, pcorr);
        phi_ += tmeshFlux();
    }

    // On a single mesh with the coefficient of the pressure, if it is kept
    tmp<surfaceScalarField> trAUf;
    if (rAU_.valid())
    {
        trAUf = fvc::interpolate(rAU_());
    }
    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pcorrEqn
        (
            (
                trAUf.valid()
              ? fvm::laplacian(trAUf(), pcorr)
              : fvm::laplacian(dimensionedScalar("one", dimTime/dimDensity, 1), pcorr)
            )
         == fvc::div(phi_)
        );
        if (composite_.isOverset())
        {
            // Each zone by itself: the fluxes of the fringe are given
            composite_.setReferences(pcorrEqn);
        }
        else
        {
            pcorrEqn.setReference(0, 0);
        }

        // fvMesh's own: without the interpolation between the zones
        mesh_.fvMesh::solve
        (
            pcorrEqn,
            mesh_.solver(pcorr.select(pimple_.finalNonOrthogonalIter()))
        );

        if (pimple_.finalNonOrthogonalIter())
        {
            phi_ -= pcorrEqn.flux();
        }
    }
    if (!composite_.isOverset())
    {
        printContinuityError();
    }
}


void Foam::freeSurfaceFlow::startImpulsively()
{
    Info<< "Initial flow: potential of the body's velocity" << endl;

    // Impulsive pressure: where a wall moves its gradient gives the fluid the
    // wall's normal velocity
    volScalarField impulse
    (
        IOobject("impulse", time_.timeName(), mesh_),
        mesh_,
        dimensionedScalar(p_rgh_.dimensions()*dimTime, Zero),
        body_->drivenTypes(potentialTypes())
    );
    mesh_.setFluxRequired(impulse.name());

    const volScalarField rRho("rRho", 1/rho_);
    const surfaceScalarField rRhof("rRhof", fvc::interpolate(rRho));

    for (const label patchi : body_->patches())
    {
        const vectorField wall(body_->velocity(mesh_.boundary()[patchi].Cf()));
        U_.boundaryFieldRef()[patchi] == wall;
        body_->drive(impulse, rRhof, patchi, wall);
    }

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix eqn(fvm::laplacian(rRhof, impulse) == fvc::div(phi_));
        eqn.setReference(pRefCell_, 0);
        eqn.solve(mesh_.solver(p_rgh_.name() + "Final"));

        if (pimple_.finalNonOrthogonalIter())
        {
            const surfaceScalarField dPhi(-eqn.flux());
            phi_ += dPhi;
            U_ += rRho*fvc::reconstruct(dPhi/rRhof);
        }
    }

    composite_.mask(U_);
    U_.correctBoundaryConditions();
    correctUf();
    printContinuityError();
}

// ************************************************************************* //
