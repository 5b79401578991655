// SPDX-License-Identifier: GPL-3.0-or-later

#include "timeControls.H"
#include "inputChecks.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"

#include <unistd.h>

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::checkTimeControls(const Time& time)
{
    const dictionary& control = time.controlDict();

    checkPositive(control, "deltaT", time.deltaTValue(), "a positive step [s].");
    for (const word name : {"maxDeltaT", "minDeltaT", "maxMeshCo", "writeInterval"})
    {
        if (control.found(name))
        {
            readPositive(control, name, "a positive number.");
        }
    }

    // Of a run that goes on from its end there is nothing to do, which is no mistake
    const scalar start = time.startTime().value();
    const scalar end = time.endTime().value();
    const bool isNew = !returnReduce(isFile(time.timePath()/"uniform"/"time"), orOp<bool>());
    if
    (
        control.getOrDefault<word>("stopAt", "endTime") == "endTime"
     && (!(end < GREAT) || end < start - SMALL*mag(start) || (isNew && end - start < 0.5*time.deltaTValue()))
    )
    {
        refuseEntry(control, "endTime", text("is ", end), text("a time after the start, ", start, " s."));
    }

    // Of collated processors not all have directories of their own
    const fileName path(isDir(time.path()) ? time.path() : time.globalPath());
    const bool isWritable = access(path.c_str(), W_OK) == 0;
    if (!returnReduce(isWritable, andOp<bool>()))
    {
        FatalErrorInFunction
            << "The case " << time.globalPath() << " cannot be written" << nl
            << "Expected: a directory that this user may write to." << exit(FatalError);
    }
}


void Foam::checkFunctionObjects(const Time& time)
{
    const functionObjectList& made = time.functionObjects();
    if (!made.status())
    {
        return;
    }

    for (const entry& e : time.controlDict().subOrEmptyDict("functions"))
    {
        if (e.isDict() && e.dict().getOrDefault("enabled", true) && made.findObjectID(e.keyword()) == -1)
        {
            refuse
            (
                e.dict(),
                text("The function object ", e.keyword(), " could not be made: a warning above says why"),
                "a type that one of its libs has, libs that can be loaded, or enabled no."
            );
        }
    }
}

// ************************************************************************* //
