// SPDX-License-Identifier: GPL-3.0-or-later

#include "stopAfterWriting.H"
#include "Time.H"

#include <cstdlib>

void Foam::stopAfterWriting
(
    const fvMesh& mesh,
    const std::string& what,
    const std::string& expected
)
{
    const Time& time = mesh.time();
    if (time.timeIndex() != time.startTimeIndex())
    {
        const_cast<Time&>(time).writeNow();
    }
    FatalErrorInFunction
        << what.c_str() << nl
        << "Time: " << time.timeName() << " s" << nl
        << "Expected: " << expected.c_str() << exit(FatalError);

    // Not reached; exit() does not say so
    std::abort();
}

// ************************************************************************* //
