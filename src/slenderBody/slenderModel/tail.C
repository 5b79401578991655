// SPDX-License-Identifier: GPL-3.0-or-later
// Fins like a cross.

#include "slenderModel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

//  Lift of a wing of small aspect ratio (Helmbold 1942), with the drag of a plate across the stream where that is what is left of it
//  (C = a sin cos + 1.2 sin^2; Hoerner 1965, ch. 7), for each pair, and the friction of both sides. Their added mass, and what body and
//  fins do to each other, are left out.
void Foam::slenderBody::slenderModel::steer(instant& now) const
{
    const slenderProperties::tailFins& fins = properties_.tail;
    if (!(fins.area > 0) || now.wet.isDry())
    {
        return;
    }
    // As wet as the slice there
    std::size_t i = 0;
    while (i + 1 < slices_.size() && slices_[i].high < fins.position)
    {
        ++i;
    }
    const scalar wet = isWettable(slices_[i]) ? now.wet.slices[i].wet : 0;
    if (!(wet > 0))
    {
        return;
    }
    const vector at(axisPoint(fins.position));
    const vector v(now.velocity.linear + (now.velocity.angular ^ at));
    const scalar half = 0.5*now.density*fins.area*wet;
    vector force(Zero);
    for (const int d : {1, 2})
    {
        force[d] = -half*(fins.liftSlope*mag(v.x()) + 1.2*mag(v[d]))*v[d];
    }
    if (properties_.hasFriction && now.viscosity > 0)
    {
        const scalar Re = now.density*mag(v.x())*fins.chord/now.viscosity;
        force.x() = -half*4*frictionLaw_.mean(Re)*v.x()*mag(v.x());
    }
    now.forces[tail].addForce(force, at);
}

// ************************************************************************* //
