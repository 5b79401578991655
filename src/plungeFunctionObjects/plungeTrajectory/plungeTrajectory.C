// SPDX-License-Identifier: GPL-3.0-or-later

#include "plungeTrajectory.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyHistory.H"
#include "gravityMeshObject.H"
#include "whileRunning.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(plungeTrajectory, 0);
    addToRunTimeSelectionTable(functionObject, plungeTrajectory, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::plungeTrajectory::plungeTrajectory
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, whileRunning(dict)),
    body_(mesh_),
    surfaceLevel_(0),
    model_(modelledPart::partType::full),
    lastVelocity_(body_.velocity()),
    lastTime_(runTime.value()),
    table_(runTime, name, meshObjects::gravity::New(runTime).value())
{
    read(dict);
    writeLine(Zero);
}


// * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * * //

bool Foam::functionObjects::plungeTrajectory::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    surfaceLevel_ = dict.get<scalar>("surfaceLevel");
    if (dict.found("halfModel"))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown entry halfModel" << nl
            << "Expected: model half; (or one of " << modelledPart::typeNames.sortedToc() << ")."
            << exit(FatalIOError);
    }
    model_ = modelledPart::New(dict, mesh_.boundaryMesh());
    return true;
}


bool Foam::functionObjects::plungeTrajectory::execute()
{
    const scalar t = time_.value();
    if (t <= lastTime_)
    {
        return true;
    }
    const vector v(body_.velocity());
    const bodyHistory* history = body_.history();
    writeLine
    (
        history
      ? history->difference(history->now().centreChange, history->last().centreChange, history->now().deltaT)
      : vector((v - lastVelocity_)/(t - lastTime_))
    );
    lastVelocity_ = v;
    lastTime_ = t;
    return true;
}


void Foam::functionObjects::plungeTrajectory::writeLine
(
    const vector& acceleration
)
{
    bodyState state;
    state.centreOfMass = body_.centreOfMass();
    state.orientation = body_.orientation();
    state.velocity = body_.velocity();
    state.omega = body_.omega();
    state.acceleration = acceleration;

    const bodyTrajectory::line line
    (
        table_.write
        (
            time_.value(),
            state,
            body_.fluidLoads(),
            body_.mass(),
            body_.reach(-table_.up()) + surfaceLevel_,
            model_
        )
    );
    setResult("penetration", line.penetration);
    setResult("speed", line.speed);
    setResult("deceleration", line.deceleration);
}

// ************************************************************************* //
