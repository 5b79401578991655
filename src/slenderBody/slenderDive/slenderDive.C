// SPDX-License-Identifier: GPL-3.0-or-later

#include "slenderDive.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Shortest step over the duration
constexpr Foam::scalar leastStep = 1e-12;

//- So many shortest steps on end, or steps at all, are those of a dive that is lost
constexpr int mostShortest = 1000, mostSteps = 20000000;

//- Halvings of the step in which an event is found
constexpr int nHalvings = 30;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slenderBody::slenderDive::slenderDive
(
    const slenderProperties& properties,
    const scalar duration,
    const slenderDive* ofThisShape
)
:
    properties_(properties),
    model_(properties, ofThisShape ? &ofThisShape->model_ : nullptr),
    integrator_(properties.tolerance, leastStep*duration, model_.scales()),
    events_(properties.dict),
    duration_(duration),
    nextStep_(1e-3*min(properties.interval, duration)),
    state_(model_.start()),
    now_(model_.evaluate(state_)),
    energy_(model_.kineticEnergy(now_) + model_.potentialEnergy(now_))
{
    watchCavity();
    event_ = events_.happened(place(now_));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::bodyEvent::place Foam::slenderBody::slenderDive::place(const slenderModel::instant& at) const
{
    return {at.wet.lowest, at.wet.highest, mag(at.velocity.linear), at.velocity.linear & at.up};
}


void Foam::slenderBody::slenderDive::findEvent(const slenderModel::state& before, const scalar step)
{
    const diveEvents remembered(events_);
    const auto rate = [&](const slenderModel::state& y){ return model_.rate(y); };
    event_ = events_.happened(place(now_));
    if (event_.empty())
    {
        return;
    }
    scalar without = 0, with = step;
    slenderModel::state last(state_);
    for (int i = 0; i < nHalvings; ++i)
    {
        const scalar middle = 0.5*(without + with);
        const slenderModel::state tried(integrator_.step(rate, before, middle));
        const slenderModel::instant at(model_.evaluate(tried));
        diveEvents events(remembered);
        if (events.happened(place(at)).empty())
        {
            without = middle;
        }
        else
        {
            with = middle;
            last = tried;
            now_ = at;
        }
    }
    state_ = last;
    time_ += with - step;
}


void Foam::slenderBody::slenderDive::checkStep(const scalar taken)
{
    nShortest_ = taken <= 1.01*leastStep*duration_ ? nShortest_ + 1 : 0;
    const bool isFinite = std::all_of(state_.begin(), state_.end(), [](const scalar y){ return std::isfinite(y); });
    if (!isFinite || nShortest_ > mostShortest || nSteps_ > mostSteps)
    {
        FatalErrorInFunction
            << "At " << time_ << " s, after " << nSteps_ << " steps, the last of " << taken << " s, the motion "
            << (isFinite ? "changes faster than steps can follow" : "is not finite any more") << nl
            << "Expected: a body whose forces the model has: look at its mass, its moments of inertia and its tail." << exit(FatalError);
    }
}


void Foam::slenderBody::slenderDive::watchCavity()
{
    if (!model_.hasCavity())
    {
        return;
    }
    if (cavityBegan_ < 0 && now_.wet.length > model_.shoulder())
    {
        cavityBegan_ = time_;
    }
    if (cavityBegan_ >= 0 && time_ - cavityBegan_ >= model_.closureTime()*(1 - 1e-9))
    {
        model_.closeCavity();
        now_ = model_.evaluate(state_);
        nextStep_ = min(nextStep_, 1e-3*properties_.interval);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slenderBody::slenderDive::advance()
{
    scalar longest = min(properties_.interval, duration_ - time_);
    if (model_.hasCavity() && cavityBegan_ >= 0)
    {
        longest = min(longest, max(cavityBegan_ + model_.closureTime() - time_, leastStep*duration_));
    }
    scalar step = min(nextStep_, longest), taken;
    const slenderModel::state before(state_);
    state_ = integrator_.advance([&](const slenderModel::state& y){ return model_.rate(y); }, before, step, taken);
    nextStep_ = step;
    time_ += taken;
    ++nSteps_;
    checkStep(taken);
    now_ = model_.evaluate(state_);
    findEvent(before, taken);
    watchCavity();
}


Foam::scalar Foam::slenderBody::slenderDive::imbalance() const
{
    scalar work = 0;
    for (int i = 0; i < slenderModel::nForces; ++i)
    {
        work += state_[13 + i];
    }
    return model_.kineticEnergy(now_) + model_.potentialEnergy(now_) - energy_ - work;
}

// ************************************************************************* //
