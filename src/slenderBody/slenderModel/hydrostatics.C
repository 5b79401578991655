// SPDX-License-Identifier: GPL-3.0-or-later
// The weight of the liquid that the wetted part displaces.

#include "slenderModel.H"

#include "mathematicalConstants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::slenderBody::slenderModel::buoy(instant& now) const
{
    const scalar g = mag(properties_.g);
    if (!(g > 0) || now.wet.isDry())
    {
        return;
    }
    motion& force = now.forces[buoyancy];
    const slenderLiquid& liquid = *properties_.liquid;
    for (std::size_t i = 0; i < slices_.size(); ++i)
    {
        const meridian::slice& of = slices_[i];
        const wettedPart::share& s = now.wet.slices[i];
        if (s.wet > 0 && isWettable(of))
        {
            const scalar weight = (liquid.isStratified() ? liquid.density(s.depth) : now.density)*g*of.volume;
            force.addForce(weight*s.wet*now.up, axisPoint(of.centre));
            force.angular += weight*s.offset*(now.wet.across ^ now.up);
        }
    }
    if (hasCavity_)
    {
        // On the section at the shoulder acts the surface's pressure, not that of the depth
        const vector at(axisPoint(shoulder_));
        const scalar depth = -now.height - (at & now.up);
        const scalar R = properties_.shape->radius(shoulder_*(1 - 1e-9));
        if (depth > 0)
        {
            force.addForce(vector(-now.density*g*depth*constant::mathematical::pi*sqr(R), 0, 0), at);
        }
    }
}

// ************************************************************************* //
