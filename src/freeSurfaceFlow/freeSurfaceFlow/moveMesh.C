// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "fvc.H"
#include "profiling.H"

void Foam::freeSurfaceFlow::moveMesh()
{
    addProfiling(mesh, "mesh motion");

    const meshControls c = controls();
    if (!(pimple_.firstIter() || c.moveMeshOuterCorrectors))
    {
        return;
    }

    if (addedMass_ && pimple_.firstIter() && addedMass_->isDue())
    {
        addedMass_->solve(rho_, p_rgh_, potentialTypes(), pimple_.nNonOrthCorr());
    }

    // An overset mesh changes fields as it moves: take their old values first,
    // in the first step of a run as in every other
    if (composite_)
    {
        U_.oldTime();
        Uf_().oldTime();
        rho_.oldTime();
        mixture_.alpha1().oldTime();
        mixture_.alpha2().oldTime();
    }
    mesh_.update();

    if (!mesh_.changing())
    {
        return;
    }
    cellShapes_.clear();

    if (mesh_.topoChanging())
    {
        scheme_->topologyChanged();
    }
    if (buoyancy_)
    {
        buoyancy_->update(mesh_);
    }
    MRF_.update();

    if (composite_)
    {
        composite_->update();

        // Faces that were inside holes have no velocity of their own yet
        surfaceVectorField& Uf = Uf_();
        const surfaceVectorField Uint(fvc::interpolate(U_));
        const surfaceScalarField& old = composite_->faceMaskOld();
        Uf = old*Uf + (scalar(1) - old)*Uint;
        forAll(Uf.boundaryField(), patchi)
        {
            // Faces between processors are faces inside the mesh
            if (!Uf.boundaryField()[patchi].coupled())
            {
                Uf.boundaryFieldRef()[patchi] = Uint.boundaryField()[patchi];
            }
        }

        phi_ = mesh_.Sf() & Uf;
        if (c.correctPhi)
        {
            projectFlux();
        }
        phi_ *= composite_->faceMask();
        U_ *= composite_->cellMask();
        fvc::makeRelative(phi_, U_);
    }
    else if (c.correctPhi)
    {
        phi_ = mesh_.Sf() & Uf_();
        projectFlux();
        fvc::makeRelative(phi_, U_);
    }
}

// ************************************************************************* //
