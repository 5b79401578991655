// SPDX-License-Identifier: GPL-3.0-or-later
// The drag of the wetted slices across the axis.

#include "slenderModel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Of an infinite circular cylinder: 1.2 below the drag crisis, 0.3 behind it, 0.7 far behind it (Hoerner 1965, ch. 3, fig. 12; Roshko
//  1961), linear in the logarithm of the Reynolds number between
scalar cylinderDrag(const scalar Re)
{
    static constexpr scalar numbers[] = {2e5, 5e5, 3.5e6}, drags[] = {1.2, 0.3, 0.7};
    if (Re <= numbers[0])
    {
        return drags[0];
    }
    for (int i = 1; i < 3; ++i)
    {
        if (Re < numbers[i])
        {
            return drags[i - 1] + (drags[i] - drags[i - 1])*std::log(Re/numbers[i - 1])/std::log(numbers[i]/numbers[i - 1]);
        }
    }
    return drags[2];
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

//  Allen and Perkins (1951, NACA 1048): a slice has the drag of a cylinder in the velocity across the axis, times the factor of a
//  cylinder of the body's length over diameter.
void Foam::slenderBody::slenderModel::resistCrossFlow(instant& now) const
{
    if (!properties_.hasCrossFlow || now.wet.isDry())
    {
        return;
    }
    const vector& v = now.velocity.linear;
    const vector& omega = now.velocity.angular;
    for (std::size_t i = 0; i < slices_.size(); ++i)
    {
        const meridian::slice& of = slices_[i];
        const scalar wet = now.wet.slices[i].wet;
        if (!(wet > 0) || !isWettable(of))
        {
            continue;
        }
        const vector at(axisPoint(of.centre));
        vector across(v + (omega ^ at));
        across.x() = 0;
        const scalar speed = mag(across);
        if (speed > 0)
        {
            const scalar Re = now.viscosity > 0 ? now.density*speed*2*of.radius/now.viscosity : GREAT;
            const scalar width = 2*of.radius*(of.high - of.low)*wet;
            now.forces[crossFlow].addForce(-0.5*now.density*crossFlowEnds_*cylinderDrag(Re)*width*speed*across, at);
        }
    }
}

// ************************************************************************* //
