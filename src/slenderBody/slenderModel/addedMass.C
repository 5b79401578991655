// SPDX-License-Identifier: GPL-3.0-or-later
// The wetted part, and what it adds to the mass.

#include "slenderModel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::slenderBody::slenderModel::wet(instant& now) const
{
    now.wet.update
    (
        slices_, *properties_.shape, properties_.nose(), now.up, now.height, now.velocity.linear, now.velocity.angular
    );
    const vector atNose(now.velocity.linear + (now.velocity.angular ^ properties_.nose()));
    now.forward = atNose.x();

    const slenderLiquid& liquid = *properties_.liquid;
    if (!liquid.isStratified())
    {
        now.density = liquid.density(0);
        now.viscosity = liquid.viscosity(0);
        return;
    }
    scalar volume = 0, mass = 0, viscous = 0;
    for (std::size_t i = 0; i < slices_.size(); ++i)
    {
        const wettedPart::share& s = now.wet.slices[i];
        if (s.wet > 0)
        {
            const scalar wetVolume = s.wet*slices_[i].volume;
            volume += wetVolume;
            mass += wetVolume*liquid.density(s.depth);
            viscous += wetVolume*liquid.viscosity(s.depth);
        }
    }
    now.density = volume > 0 ? mass/volume : liquid.density(0);
    now.viscosity = volume > 0 ? viscous/volume : liquid.viscosity(0);
}


void Foam::slenderBody::slenderModel::addMass(instant& now) const
{
    now.added = motionMatrix();
    now.rate = motion();
    if (now.wet.isDry())
    {
        return;
    }

    // Across the axis: sums over the slices of mass, and of its first and second moment along the axis
    scalar sums[3] = {}, rates[3] = {};
    const slenderLiquid& liquid = *properties_.liquid;
    for (std::size_t i = 0; i < slices_.size(); ++i)
    {
        const meridian::slice& of = slices_[i];
        const wettedPart::share& s = now.wet.slices[i];
        if (!(s.wet > 0) || !isWettable(of))
        {
            continue;
        }
        const scalar whole = across_*of.volume*(liquid.isStratified() ? liquid.density(s.depth) : now.density);
        const scalar x = properties_.centreFromNose.x() - of.centre;
        const scalar own = x*x + ownInertia_;
        const scalar m = whole*s.wet;
        const scalar mRate = whole*max(s.rate, scalar(0));
        sums[0] += m;
        sums[1] += m*x;
        sums[2] += m*own;
        rates[0] += mRate;
        rates[1] += mRate*x;
        rates[2] += mRate*own;
    }

    // Velocities across the axis at x ahead of the centre of mass: (j0 + x j1) & V, to the side and dorsal
    const vector nose(properties_.nose());
    const motion side{vector(0, 1, 0), vector(-nose.z(), 0, 0)}, dorsal{vector(0, 0, 1), vector(nose.y(), 0, 0)};
    const motion yaw{Zero, vector(0, 0, 1)}, pitch{Zero, vector(0, -1, 0)};
    motionMatrix growth;
    const auto addSums = [&](motionMatrix& M, const scalar s[3])
    {
        const motion* const pairs[2][2] = {{&side, &yaw}, {&dorsal, &pitch}};
        for (const auto& pair : pairs)
        {
            const motion& j0 = *pair[0];
            const motion& j1 = *pair[1];
            M.add(s[0], j0);
            M.add(s[2], j1);
            // j0 j1^T + j1 j0^T
            M.add(0.5*s[1], j0 + j1);
            M.add(-0.5*s[1], j0 - j1);
        }
    };
    addSums(now.added, sums);
    addSums(growth, rates);
    now.rate = growth & now.velocity;

    // Along the axis
    const axialEntry& entry = hasCavity_ ? *cavityEntry_ : *attachedEntry_;
    const motion axis{vector(1, 0, 0), vector(0, nose.z(), -nose.y())};
    now.added.add(now.density*entry.mass(entryDepth(now)), axis);
}

// ************************************************************************* //
