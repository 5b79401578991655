// SPDX-License-Identifier: GPL-3.0-or-later
// The accelerations that the forces make, and the force of the added mass that follows from them.

#include "slenderModel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::slenderBody::slenderModel::accelerate(instant& now) const
{
    const vector& v = now.velocity.linear;
    const vector& omega = now.velocity.angular;
    const vector nose(properties_.nose());

    // Rates of momenta in axes that turn
    const motion liquid(now.added & now.velocity);
    const motion body(bodyMass_ & now.velocity);
    const motion turned{-(omega ^ liquid.linear), -(omega ^ liquid.angular) - (v ^ liquid.linear)};

    motion entering;
    entering.addForce(vector(now.density*now.entryForce, 0, 0), nose);
    const motion ofLiquid(turned + entering - now.rate);

    if (properties_.freedom == freedomType::prescribed)
    {
        now.acceleration = {-(omega ^ v), Zero};
    }
    else
    {
        motion all(ofLiquid);
        all += {properties_.mass*(-mag(properties_.g)*now.up) - (omega ^ body.linear), -(omega ^ body.angular)};
        for (const motion& force : now.forces)
        {
            all += force;
        }
        motionMatrix mass(bodyMass_);
        for (int i = 0; i < 6; ++i)
        {
            for (int k = 0; k < 6; ++k)
            {
                mass.a[i][k] += now.added.a[i][k];
            }
        }
        now.acceleration = solveAmong(mass, all, directions_, nDirections_);
    }
    now.forces[inertia] = ofLiquid - (now.added & now.acceleration);
}

// ************************************************************************* //
