// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHistory.H"

const Foam::word Foam::bodyHistory::registryName("bodyHistory");

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- f(name, value) for each part of a step
template<class Step, class Function>
void forParts(Step& s, const Function& f)
{
    f("deltaT", s.deltaT);
    f("number", s.number);
    f("meanVelocity", s.meanVelocity);
    f("meanSpin", s.meanSpin);
    f("velocityChange", s.velocityChange);
    f("spinChange", s.spinChange);
    f("acceleration", s.acceleration);
    f("loads", s.loads);
    f("centreChange", s.centreChange);
    f("momentChange", s.momentChange);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyHistory::bodyHistory(const Time& time)
:
    IOdictionary
    (
        IOobject
        (
            registryName,
            time.timeName(),
            "uniform",
            time,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    time_(time),
    now_{0, 0, Zero, Zero, Zero, Zero, scalarField(6, Zero), scalarField(6, Zero), Zero, Zero},
    last_(now_)
{
    if (found("deltaT"))
    {
        forParts(now_, [&](const word& name, auto& value){ this->readEntry(name, value); });
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bodyHistory::startStep()
{
    last_ = now_;
    ++now_.number;
}


bool Foam::bodyHistory::writeObject
(
    IOstream::streamFormat,
    IOstream::versionNumber version,
    IOstream::compressionType compression,
    const bool valid
) const
{
    dictionary& entries = const_cast<bodyHistory&>(*this);
    forParts(now_, [&](const word& name, const auto& value){ entries.set(name, value); });
    return IOdictionary::writeObject(IOstream::ASCII, version, compression, valid);
}

// ************************************************************************* //
