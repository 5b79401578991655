// SPDX-License-Identifier: GPL-3.0-or-later

#include "plungeEvent.H"
#include "addToRunTimeSelectionTable.H"
#include "gravityMeshObject.H"
#include "restart.H"
#include "whileRunning.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(plungeEvent, 0);
    addToRunTimeSelectionTable(functionObject, plungeEvent, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const Foam::word memoryName("memory");

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::plungeEvent::plungeEvent
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, whileRunning(dict)),
    body_(mesh_),
    up_(upwards(meshObjects::gravity::New(runTime).value())),
    event_(),
    surfaceLevel_(0)
{
    read(dict);
    event_->remember(getProperty<FixedList<scalar, 2>>(memoryName, event_->memory()));
    if (hasHappened())
    {
        event_->end(const_cast<Time&>(time_));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::functionObjects::plungeEvent::hasHappened()
{
    const vector v(body_.velocity());
    const bool happened =
        event_->hasHappened
        ({
            -body_.reach(-up_) - surfaceLevel_, body_.reach(up_) - surfaceLevel_, mag(v), v & up_
        });
    setProperty(memoryName, event_->memory());
    return happened;
}


// * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * * //

bool Foam::functionObjects::plungeEvent::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    surfaceLevel_ = dict.get<scalar>("surfaceLevel");
    autoPtr<bodyEvent> event(new bodyEvent(dict, "event"));
    if (event_)
    {
        event->remember(event_->memory());
    }
    event_.reset(event.release());
    return true;
}


bool Foam::functionObjects::plungeEvent::execute()
{
    if (hasHappened())
    {
        Time& time = const_cast<Time&>(time_);
        event_->end(time);
        if (!time.writeTime())
        {
            const restart::unfinishedTime mark(time, true);
            time.writeNow();
        }
    }
    return true;
}

// ************************************************************************* //
