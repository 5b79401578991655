// SPDX-License-Identifier: GPL-3.0-or-later

#include "restart.H"
#include "IOdictionary.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "surfaceFields.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::fileName markOf(const Foam::Time& time)
{
    return time.timePath()/"uniform"/"unfinished";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::restart::unfinishedTime::unfinishedTime(const Time& time, const bool isWritten)
:
    mark_()
{
    // Collated processors have no directories of their own
    if (isWritten && isDir(time.path()))
    {
        mark_ = markOf(time);
        mkDir(mark_.path());
        OFstream os(mark_);
    }
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::restart::unfinishedTime::~unfinishedTime()
{
    if (!mark_.empty())
    {
        rm(mark_);
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::restart::begin(Time& time)
{
    if (returnReduce(isFile(markOf(time)), orOp<bool>()))
    {
        FatalErrorInFunction
            << "Time " << time.timeName() << " is not complete: a run was"
            << " interrupted while it wrote it." << nl
            << "Expected: a complete time. Remove the directory "
            << time.timeName() << (Pstream::parRun() ? " of each processor" : "")
            << " to go on from the time before." << exit(FatalError);
    }

    const IOdictionary saved
    (
        IOobject
        (
            "time",
            time.timeName(),
            "uniform",
            time,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    scalar value;
    if
    (
        saved.readIfPresent("value", value)
     && Time::timeName(value) == time.timeName()
    )
    {
        time.setTime(time.userTimeToTime(value), time.timeIndex());
    }
}


bool Foam::restart::isFrom(const fvMesh& mesh)
{
    return IOobject("phi", mesh.time().timeName(), mesh).typeHeaderOk<surfaceScalarField>(true);
}


Foam::IOobject Foam::restart::field(const word& name, const fvMesh& mesh)
{
    return IOobject(name, mesh.time().timeName(), mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE);
}


void Foam::restart::alignTimeStep(Time& time)
{
    const dictionary& control = time.controlDict();
    const word writes(control.getOrDefault<word>("writeControl", word::null));
    if (writes != "adjustable" && writes != "adjustableRunTime")
    {
        return;
    }

    const scalar interval = control.get<scalar>("writeInterval");
    const scalar start = time.startTime().value();
    const scalar deltaT = time.deltaTValue();
    const scalar nearby = 1e-3*deltaT;
    if (mag(start - interval*std::round(start/interval)) > nearby)
    {
        return;
    }

    const scalar next =
        interval*(std::floor((time.value() + 0.5*deltaT)/interval) + 1);
    const scalar left = next - time.value();
    const scalar aligned = left/max(scalar(1), std::round(left/deltaT));
    if (mag(aligned - deltaT) < nearby)
    {
        time.setDeltaT(aligned, false);
    }
}

// ************************************************************************* //
