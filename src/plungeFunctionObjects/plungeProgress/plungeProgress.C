// SPDX-License-Identifier: GPL-3.0-or-later

#include "plungeProgress.H"
#include "addToRunTimeSelectionTable.H"
#include "timeLeft.H"
#include "whileRunning.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(plungeProgress, 0);
    addToRunTimeSelectionTable(functionObject, plungeProgress, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::plungeProgress::plungeProgress
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, whileRunning(dict)),
    pace_(0),
    lastTime_(runTime.value()),
    lastClock_(runTime.elapsedClockTime())
{
    read(dict);
}


// * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * * //

bool Foam::functionObjects::plungeProgress::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    trajectory_ = dict.lookupOrDefault<word>("trajectory", word::null);
    volumeLedger_ = dict.lookupOrDefault<word>("volumeLedger", word::null);
    return true;
}


bool Foam::functionObjects::plungeProgress::execute()
{
    const scalar t = time_.value();
    const scalar tEnd = time_.endTime().value();

    // The pace of the last fifty steps or so
    const scalar clock = time_.elapsedClockTime();
    if (clock > lastClock_)
    {
        const scalar pace = (t - lastTime_)/(clock - lastClock_);
        pace_ = (pace_ > 0 ? 0.98*pace_ + 0.02*pace : pace);
        lastTime_ = t;
        lastClock_ = clock;
    }

    std::ostringstream os;
    os  << std::setprecision(4)
        << "Progress: t = " << 1e3*t << " ms ("
        << std::setprecision(3)
        << 100*(t - time_.startTime().value())
          /max(tEnd - time_.startTime().value(), VSMALL)
        << " %)";
    if (pace_ > 0)
    {
        os  << ", left " << hoursMinutesSeconds((tEnd - t)/pace_);
    }
    os  << ", dt = " << 1e6*time_.deltaTValue() << " us";
    if (!trajectory_.empty())
    {
        os  << std::setprecision(4) << " | depth "
            << getObjectResult<scalar>(trajectory_, "penetration")
            << " m, speed " << std::setprecision(5)
            << getObjectResult<scalar>(trajectory_, "speed")
            << " m/s, deceleration " << std::setprecision(4)
            << getObjectResult<scalar>(trajectory_, "deceleration")
            << " m/s2";
    }
    if (!volumeLedger_.empty())
    {
        os  << std::setprecision(3) << " | ledger "
            << getObjectResult<scalar>(volumeLedger_, "errorPercent") << " %";
    }
    Log << os.str().c_str() << endl;

    return true;
}

// ************************************************************************* //
