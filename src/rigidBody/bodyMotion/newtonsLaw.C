// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyInertia.H"
#include "bodyMotion.H"
#include "sixDoFRigidBodyMotionRestraint.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::bodyMotion::angularMomentum() const
{
    const tensor& Q = orientation();
    return Q & (centralInertia(motion_) & (Q.T() & omega()));
}


Foam::bodyLoads Foam::bodyMotion::restraintLoads() const
{
    bodyLoads sum{Zero, Zero, Zero};
    for (const sixDoFRigidBodyMotionRestraint& restraint : restraints_)
    {
        point where(Zero);
        vector force(Zero);
        vector moment(Zero);
        restraint.restrain(motion_, where, force, moment);
        sum.pressure += force;
        sum.moment += moment + ((where - centreOfMass()) ^ force);
    }
    return sum;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bodyMotion::startStep()
{
    startVelocity_ = velocity();
    startAngularMomentum_ = angularMomentum();
    startRestraints_ = restraintLoads();
}


Foam::scalar Foam::bodyMotion::imbalance(const scalar deltaT) const
{
    const bodyLoads flow(fluidLoads());
    const bodyLoads held(restraintLoads());
    const auto* g = mesh_.time().findObject<uniformDimensionedVectorField>("g");
    const vector weight(g ? mass()*g->value() : vector(Zero));

    const vector force(flow.pressure + flow.viscous + weight + 0.5*(held.pressure + startRestraints_.pressure));
    const vector change(mass()*(velocity() - startVelocity_)/deltaT);

    // About the centre of rotation
    const vector arm(motion_.momentArm());
    const tensor& Q = orientation();
    const tensor freeMoments(Q & freeMoments_ & Q.T());
    const vector moment
    (
        freeMoments & (flow.moment + 0.5*(held.moment + startRestraints_.moment) + (arm ^ force))
    );
    const vector spin(freeMoments & ((angularMomentum() - startAngularMomentum_)/deltaT + (arm ^ change)));

    // Of a body that nothing accelerates only round-off is there to compare
    const scalar total = mag(flow.pressure + flow.viscous) + mag(weight);
    const scalar forces = max(max(mag(freeForces_ & force), mag(freeForces_ & change)), 0.01*total);
    const scalar length = std::sqrt(tr(centralInertia(motion_))/mass());
    const scalar moments = max(max(mag(moment), mag(spin)), 0.1*length*forces);
    return max(mag(freeForces_ & (force - change))/max(forces, VSMALL), mag(moment - spin)/max(moments, VSMALL));
}

// ************************************************************************* //
