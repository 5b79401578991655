// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyEvent.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::bodyEvent::kind> Foam::bodyEvent::names
({
    { kind::immersed, "immersed" },
    { kind::atRest, "atRest" },
    { kind::leftTheLiquid, "leftTheLiquid" },
    { kind::surfaced, "surfaced" },
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Of the highest speed, below which a body is at rest
constexpr Foam::scalar restingShare = 0.01;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyEvent::bodyEvent(const dictionary& dict, const word& entry)
:
    kind_(readChoice(names, dict, entry))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::bodyEvent::hasHappened(const place& now)
{
    highestSpeed_ = max(highestSpeed_, now.speed);
    hasTouched_ = hasTouched_ || now.lowest < 0;
    wasImmersed_ = wasImmersed_ || now.highest < 0;
    switch (kind_)
    {
        case kind::immersed: return now.highest < 0;
        case kind::atRest: return now.speed < restingShare*highestSpeed_;
        case kind::leftTheLiquid: return hasTouched_ && now.lowest > 0 && now.climb > 0;
        case kind::surfaced: return wasImmersed_ && now.highest > 0;
    }
    return false;
}


void Foam::bodyEvent::end(Time& time) const
{
    Info<< "Event " << name() << " at " << time.timeName() << " s: the run ends here" << nl << endl;
    time.setEndTime(time.value());
}


void Foam::bodyEvent::remember(const FixedList<scalar, 2>& memory)
{
    highestSpeed_ = memory[0];
    hasTouched_ = memory[1] > 0;
    wasImmersed_ = memory[1] > 1.5;
}

// ************************************************************************* //
