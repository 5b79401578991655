// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "fvc.H"
#include "inputChecks.H"
#include "profiling.H"
#include "stopAfterWriting.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::freeSurfaceFlow::checkMotion() const
{
    const scalarField& V = mesh_.V().field();
    const label smallest = V.size() ? findMin(V) : -1;
    if (gMin(V) <= 0)
    {
        point where(point::max);
        if (smallest != -1 && V[smallest] <= 0)
        {
            where = mesh_.cellCentres()[smallest];
        }
        stopAfterWriting
        (
            mesh_,
            text
            (
                "The motion has turned cells inside out, the worst at ", returnReduce(where, minOp<point>()),
                ": the body is too near to another boundary, or has moved too far for its mesh."
            ),
            "a body that keeps away from the boundaries: where its mesh is not rigid, by more than innerDistance of"
            " constant/dynamicMeshDict."
        );
    }
    composite_.checkZones();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::freeSurfaceFlow::moveMesh()
{
    addProfiling(mesh, "mesh motion");

    const meshControls c = controls();
    const bool first = pimple_.firstIter();
    if (!(first || c.moveMeshOuterCorrectors))
    {
        if (backward_)
        {
            backward_->moveToMiddle(phi_, first);
        }
        return;
    }

    const bool isNew = first && nRepeats_ == 0;
    if (addedMass_ && isNew && addedMass_->isDue())
    {
        addedMass_->solve(rho_, p_rgh_, potentialTypes(), pimple_.nNonOrthCorr(), pRefCell_);
    }
    if (body_ && isNew)
    {
        body_->startStep();
        if (history_)
        {
            history_->startStep();
        }
    }
    if (repeats_)
    {
        // What a step that is solved again starts from
        phi_.oldTime();
        U_.oldTime();
        mixture_.alpha1().oldTime();
        if (Uf_)
        {
            Uf_().oldTime();
        }
    }

    // Of the first step of a run as of every other
    composite_.storeOldTimes(U_, rho_, mixture_.alpha1(), mixture_.alpha2());
    if (Uf_)
    {
        composite_.storeOldTimes(Uf_());
        if (backward_)
        {
            Uf_().oldTime();
        }
    }
    mesh_.update();

    if (!mesh_.changing())
    {
        if (backward_)
        {
            backward_->moveToMiddle(phi_, first);
        }
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
    checkMotion();
    if (composite_.isOverset() && p_rgh_.needReference())
    {
        pRefCell_ = composite_.calculatedCell(pressureReference());
    }
    if (composite_.isOverset() || c.correctPhi)
    {
        composite_.setUncovered(Uf_(), U_);
        phi_ = mesh_.Sf() & Uf_();
        if (backward_)
        {
            phi_ += mesh_.Sf() & backward_->velocityToMiddle();
        }
        if (c.correctPhi)
        {
            projectFlux();
        }
        composite_.mask(phi_);
        composite_.mask(U_);
        phi_ -= meshFlux();
        scheme_->meshMoved();
    }
    else if (backward_)
    {
        backward_->moveToMiddle(phi_, first);
    }
}

// ************************************************************************* //
