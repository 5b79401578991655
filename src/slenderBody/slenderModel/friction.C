// SPDX-License-Identifier: GPL-3.0-or-later
// Friction on the wetted area, and the drag of a tail and of a base.

#include "slenderModel.H"

#include "mathematicalConstants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

//  The friction line of class frictionLaw at the Reynolds number of the wetted length, over the wetted area, with Hoerner's
//  1 + 1.5 (d/l)^1.5 for the speeds beside a body of revolution and, with a closed tail as far as it is wetted, his 7 (d/l)^3
//  for its pressure (Fluid-Dynamic Drag, 1965, eq. 6-28). A base that the liquid has reached: 0.029/sqrt(C), with C the friction
//  over the base's area (ibid., ch. 3, eq. 36). The layer is that of a steady flow.
void Foam::slenderBody::slenderModel::rub(instant& now) const
{
    const scalar U = now.forward;
    if (!properties_.hasFriction || now.wet.isDry() || !(now.viscosity > 0) || !(mag(U) > 0))
    {
        return;
    }
    const meridian& body = *properties_.shape;
    scalar area = 0;
    for (std::size_t i = 0; i < slices_.size(); ++i)
    {
        if (isWettable(slices_[i]))
        {
            area += now.wet.slices[i].wet*slices_[i].area;
        }
    }
    const scalar wetted = min(now.wet.length, hasCavity_ ? shoulder_ : body.length());
    const scalar Re = now.density*mag(U)*wetted/now.viscosity;
    const scalar coefficient = frictionLaw_.mean(Re);
    const scalar pressure = 0.5*now.density*U*mag(U);
    const vector nose(properties_.nose());
    const scalar rubbing = coefficient*frictionForm_*area;
    now.forces[friction].addForce(vector(-pressure*rubbing, 0, 0), nose);

    if (hasCavity_)
    {
        return;
    }
    const scalar tail = body.length() - body.widest();
    const scalar immersed = tail > 0 ? min(max((wetted - body.widest())/tail, scalar(0)), scalar(1)) : scalar(now.wet.isImmersed());
    scalar drag = coefficient*pressureForm_*area*immersed;
    const scalar base = constant::mathematical::pi*sqr(body.baseRadius());
    if (base > 0 && now.wet.isImmersed())
    {
        drag += 0.029/std::sqrt(rubbing/base)*base;
    }
    now.forces[form].addForce(vector(-pressure*drag, 0, 0), nose);
}

// ************************************************************************* //
