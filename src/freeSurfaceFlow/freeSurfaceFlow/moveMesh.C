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

    // Of the first step of a run as of every other
    composite_.storeOldTimes(U_, rho_, mixture_.alpha1(), mixture_.alpha2());
    if (Uf_)
    {
        composite_.storeOldTimes(Uf_());
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

    composite_.update();
    if (composite_.isOverset() || c.correctPhi)
    {
        composite_.setUncovered(Uf_(), U_);
        phi_ = mesh_.Sf() & Uf_();
        if (c.correctPhi)
        {
            projectFlux();
        }
        composite_.mask(phi_);
        composite_.mask(U_);
        fvc::makeRelative(phi_, U_);
        scheme_->meshMoved();
    }
}

// ************************************************************************* //
