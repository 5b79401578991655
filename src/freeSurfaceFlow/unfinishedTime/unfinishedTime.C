// SPDX-License-Identifier: GPL-3.0-or-later

#include "unfinishedTime.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::fileName markOf(const Foam::Time& time)
{
    return time.timePath()/"uniform"/"unfinished";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::unfinishedTime::unfinishedTime(const Time& time, const bool isWritten)
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

Foam::unfinishedTime::~unfinishedTime()
{
    if (!mark_.empty())
    {
        rm(mark_);
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::unfinishedTime::refuse(const Time& time)
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
}

// ************************************************************************* //
