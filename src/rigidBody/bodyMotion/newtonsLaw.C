// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHistory.H"
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

const Foam::bodyHistory* Foam::bodyMotion::history() const
{
    return mesh_.time().findObject<bodyHistory>(bodyHistory::registryName);
}


void Foam::bodyMotion::startStep()
{
    startVelocity_ = velocity();
    startAngularMomentum_ = angularMomentum();
    startRestraints_ = restraintLoads();
}


void Foam::bodyMotion::endStep(bodyHistory& history, const scalar deltaT) const
{
    bodyHistory::step& s = history.now();
    s.deltaT = deltaT;
    s.centreChange = (velocity() - startVelocity_)/deltaT;
    s.momentChange = (angularMomentum() - startAngularMomentum_)/deltaT;
}


Foam::scalar Foam::bodyMotion::imbalance(const scalar deltaT) const
{
    const bodyLoads flow(fluidLoads());
    const bodyLoads held(restraintLoads());
    const auto* g = mesh_.time().findObject<uniformDimensionedVectorField>("g");
    const vector weight(g ? mass()*g->value() : vector(Zero));

    // Restraints act at the end of a step of second order, and from its start to its end in others
    const bodyHistory* past = history();
    const scalar start = past ? 0 : 0.5;
    const vector force(flow.pressure + flow.viscous + weight + (1 - start)*held.pressure + start*startRestraints_.pressure);
    vector change((velocity() - startVelocity_)/deltaT);
    vector turn((angularMomentum() - startAngularMomentum_)/deltaT);
    if (past)
    {
        change = past->difference(change, past->last().centreChange, deltaT);
        turn = past->difference(turn, past->last().momentChange, deltaT);
    }
    change *= mass();

    // About the centre of rotation
    const vector arm(motion_.momentArm());
    const tensor& Q = orientation();
    const tensor freeMoments(Q & freeMoments_ & Q.T());
    const vector moment
    (
        freeMoments & (flow.moment + (1 - start)*held.moment + start*startRestraints_.moment + (arm ^ force))
    );
    const vector spin(freeMoments & (turn + (arm ^ change)));

    // Of a body that nothing accelerates only round-off is there to compare
    const scalar total = mag(flow.pressure + flow.viscous) + mag(weight);
    const scalar forces = max(max(mag(freeForces_ & force), mag(freeForces_ & change)), 0.01*total);
    const scalar length = std::sqrt(tr(centralInertia(motion_))/mass());
    const scalar moments = max(max(mag(moment), mag(spin)), 0.1*length*forces);
    return max(mag(freeForces_ & (force - change))/max(forces, VSMALL), mag(moment - spin)/max(moments, VSMALL));
}

// ************************************************************************* //
