// SPDX-License-Identifier: GPL-3.0-or-later
// The force along the axis on a nose that enters, and on one with a cavity behind it.

#include "slenderModel.H"

#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Drag of a cone with a cavity at the surface's pressure behind it, over rho U^2 A/2: Guzevskii's approximation of his
//  computations (1973; quoted in Savchenko 2001, RTO-EN-010). 0.5 at 45 degrees, 0.82 of a disc
scalar cavityDrag(const scalar halfAngle)
{
    const scalar a = halfAngle/constant::mathematical::pi;
    return a < 1.0/12 ? a*(0.915 + 9.5*a) : 0.5 + 1.81*(a - 0.25) - 2*sqr(a - 0.25);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::slenderBody::slenderModel::enter(instant& now) const
{
    now.entryForce = 0;
    const scalar U = now.forward;
    const vector nose(properties_.nose());
    if (now.wet.isDry() || !(U > 0))
    {
        return;
    }
    const axialEntry& entry = hasCavity_ ? *cavityEntry_ : *attachedEntry_;
    const scalar depth = entryDepth(now);
    const scalar f = now.wet.lengthRate > 0 ? entry.force(depth) : 0;
    now.entryForce = -f*sqr(U);

    if (hasCavity_ && depth > cavityDepth_)
    {
        // Where that is more than what is left of the entry's
        const scalar R = properties_.shape->radius(shoulder_*(1 - 1e-9));
        const scalar halfAngle = shoulder_ > 0 ? std::atan2(R, shoulder_) : 0.5*constant::mathematical::pi;
        const scalar steady = 0.5*cavityDrag(halfAngle)*constant::mathematical::pi*sqr(R);
        now.forces[form].addForce(vector(-now.density*max(steady - f, scalar(0))*sqr(U), 0, 0), nose);
    }
}

// ************************************************************************* //
