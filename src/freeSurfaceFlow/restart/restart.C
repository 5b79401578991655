// SPDX-License-Identifier: GPL-3.0-or-later

#include "restart.H"
#include "dynamicFvMesh.H"
#include "fileOperation.H"
#include "FlatOutput.H"
#include "IOdictionary.H"
#include "motionSolver.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "surfaceFields.H"
#include "volFields.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::fileName markOf(const Foam::Time& time)
{
    return time.timePath()/"uniform"/"unfinished";
}


//- Between written times that steps are to meet [s]; 0 if they need not
Foam::scalar adjustableInterval(const Foam::Time& time)
{
    const Foam::dictionary& control = time.controlDict();
    const Foam::word writes(control.getOrDefault<Foam::word>("writeControl", Foam::word::null));
    return
        writes == "adjustable" || writes == "adjustableRunTime"
      ? control.get<Foam::scalar>("writeInterval")
      : 0;
}


//- From now to the next of them [s]
Foam::scalar untilNext(const Foam::Time& time, const Foam::scalar interval)
{
    return interval*(std::floor((time.value() + 0.5*time.deltaTValue())/interval) + 1) - time.value();
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


void Foam::restart::check(const fvMesh& mesh, const bool hasBody, const bool isBackward, const bool hasHistory)
{
    const Time& time = mesh.time();
    if (mag(time.value()) < SMALL)
    {
        // Of a first start; phi may be there, from potentialFoam
        return;
    }

    const auto state = [&](const word& name, const objectRegistry& registry)
    {
        return IOobject(name, time.timeName(), "uniform", registry).typeHeaderOk<IOdictionary>(true);
    };
    const auto flux = [&](const word& name, const bool isScalar)
    {
        IOobject io(name, time.timeName(), mesh);
        return isScalar ? io.typeHeaderOk<surfaceScalarField>(true) : io.typeHeaderOk<surfaceVectorField>(true);
    };

    DynamicList<word> there, missing;
    const auto sort = [&](const char* name, const bool isThere)
    {
        (returnReduce(isThere, andOp<bool>()) ? there : missing).append(name);
    };
    const auto refuseParts = [&]
    {
        if (there.size() && missing.size())
        {
            FatalErrorInFunction
                << "Time " << time.timeName() << " was written by a run, but lacks " << flatOutput(missing) << nl
                << "Expected: beside " << flatOutput(there) << " all that the run goes on from. Remove the directory "
                << time.timeName() << " to go on from the time before, or these files, too, to begin anew with its fields;"
                << " decomposePar takes uniform along with -copyUniform." << exit(FatalError);
        }
    };
    sort("phi", flux("phi", true));
    sort("uniform/time", state("time", time));
    const auto* moved = dynamic_cast<const dynamicFvMesh*>(&mesh);
    if (moved && moved->dynamic())
    {
        sort("Uf", flux("Uf", false));
    }
    if (mesh.lookupClass<motionSolver>().size())
    {
        const IOobject points("points", time.timeName(), polyMesh::meshSubDir, mesh);
        sort("polyMesh/points", !fileHandler().filePath(points.objectPath()).empty());
    }
    if (hasBody)
    {
        sort("uniform/sixDoFRigidBodyMotionState", state("sixDoFRigidBodyMotionState", mesh));
    }

    refuseParts();

    // A run with another time scheme leaves none of these: the first step is then Euler's
    if (isBackward)
    {
        there.clear();
        missing.clear();
        sort("phi_0", flux("phi_0", true));
        sort("U_0", IOobject("U_0", time.timeName(), mesh).typeHeaderOk<volVectorField>(true));
        sort("ddtSteady", IOobject("ddtSteady", time.timeName(), mesh).typeHeaderOk<volScalarField>(true));
        if (moved && moved->dynamic())
        {
            sort("Uf_0", flux("Uf_0", false));
        }
        if (hasHistory)
        {
            sort("uniform/bodyHistory", state("bodyHistory", time));
        }
        refuseParts();
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


Foam::scalar Foam::restart::untied(const Time& time, const scalar deltaT)
{
    const scalar interval = adjustableInterval(time);
    const scalar count = interval > 0 ? untilNext(time, interval)/deltaT : 0;
    return mag(count - std::floor(count) - 0.5) < 1e-6 ? (1 - 1e-5)*deltaT : deltaT;
}


void Foam::restart::alignTimeStep(Time& time)
{
    const scalar interval = adjustableInterval(time);
    if (interval <= 0)
    {
        return;
    }

    const scalar start = time.startTime().value();
    const scalar deltaT = time.deltaTValue();
    const scalar nearby = 1e-3*deltaT;
    if (mag(start - interval*std::round(start/interval)) > nearby)
    {
        return;
    }

    const scalar left = untilNext(time, interval);
    const scalar aligned = left/max(scalar(1), std::round(left/deltaT));
    if (mag(aligned - deltaT) < nearby)
    {
        time.setDeltaT(aligned, false);
    }
}

// ************************************************************************* //
