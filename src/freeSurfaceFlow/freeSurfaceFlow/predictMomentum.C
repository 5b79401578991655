// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "EulerDdtScheme.H"
#include "fvc.H"
#include "fvm.H"
#include "profiling.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::freeSurfaceFlow::setBodyForces()
{
    bodyForces_.clear();
    if (scene_.surfaceTension())
    {
        bodyForces_ = interface_->surfaceTensionForce();
    }
    if (buoyancy_)
    {
        tmp<surfaceScalarField> tweight(-buoyancy_->ghf*fvc::snGrad(rho_));
        if (bodyForces_.valid())
        {
            bodyForces_.ref() += tweight;
        }
        else
        {
            bodyForces_ = tweight;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::freeSurfaceFlow::predictMomentum()
{
    addProfiling(momentum, "momentum");

    MRF_.correctBoundaryVelocity(U_);

    correctorTerms_.clear();
    setBodyForces();
    tmp<surfaceScalarField> trhoPhi(rhoPhi_);
    if (backward_)
    {
        trhoPhi = backward_->massFlux(rho_, rhoPhi_);
        if (pimple_.firstIter())
        {
            backward_->extrapolate(U_);
        }
    }
    const surfaceScalarField& rhoPhi = trhoPhi();
    UEqn_ = tmp<fvVectorMatrix>
    (
        (backward_ ? backward_->ddt(rho_, U_) : fvm::ddt(rho_, U_)) + fvm::div(rhoPhi, U_)
      + MRF_.DDt(rho_, U_)
      + turbulence_->divDevRhoReff(rho_, U_)
     ==
        fvOptions_(rho_, U_)
    );
    fvVectorMatrix& UEqn = UEqn_.ref();

    // Where mass is not conserved, which is in the fringe of an overset mesh and where momentum has a flux of its own, take out
    // what that would drag in
    if (backward_)
    {
        UEqn -= fvm::Sp(fv::EulerDdtScheme<scalar>(mesh_).fvcDdt(rho_) + fvc::div(rhoPhi), U_);
    }
    else if (composite_.isOverset())
    {
        UEqn -= fvm::Sp(fvc::ddt(rho_) + fvc::div(rhoPhi), U_);
    }

    UEqn.relax();
    fvOptions_.constrain(UEqn);

    if (!pimple_.momentumPredictor())
    {
        return;
    }

    surfaceScalarField force(-fvc::snGrad(p_rgh_));
    if (bodyForces_.valid())
    {
        force += bodyForces_();
    }

    volVectorField::Internal source
    (
        IOobject("forces", time_.timeName(), mesh_),
        mesh_,
        force.dimensions(),
        reconstruct(mesh_.Sf(), force)
    );
    composite_.mask(source);
    solve(UEqn == source);
    fvOptions_.correct(U_);
}

// ************************************************************************* //
