// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    plungeFoam

Description
    A rigid body that plunges into a liquid: two incompressible immiscible
    fluids with a free surface by the volume-of-fluid method, on a mesh that
    moves with the body, overset meshes included. Cases are interFoam's;
    constant/sceneProperties says what a scene contains.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "freeSurfaceFlow.H"
#include "functionObjectList.H"
#include "mapPolyMesh.H"
#include "profileTable.H"
#include "profiling.H"
#include "restart.H"
#include "timeControls.H"
#include "timeSelector.H"

#include <malloc.h>

using namespace Foam;

int main(int argc, char *argv[])
{
    // Fields come and go many times in a step: keep their memory
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);

    argList::addNote
    (
        "Two incompressible immiscible fluids with a free surface and a rigid"
        " body that plunges into them, on any dynamic mesh, overset included."
    );

    // The option -postProcess, as every solver has it
    #define CREATE_MESH createDynamicFvMesh.H
    #define NO_CONTROL
    #define CREATE_FIELDS createFlow.H
    #include "postProcess.H"

    #include "addCheckCaseOptions.H"
    #include "setRootCaseLists.H"
    #include "createTime.H"
    restart::begin(runTime);
    checkTimeControls(runTime);
    #include "createDynamicFvMesh.H"

    #include "createFlow.H"

    Info<< "\nStarting time loop\n" << endl;

    while (runTime.run())
    {
        flow.chooseTimeStep(runTime);

        ++runTime;
        Info<< "Time = " << runTime.timeName() << nl << endl;

        do
        {
            while (flow.pimple().loop())
            {
                flow.moveMesh();
                flow.advectInterface();

                if (flow.pimple().frozenFlow())
                {
                    continue;
                }

                flow.predictMomentum();

                while (flow.pimple().correct())
                {
                    flow.correctPressure();
                }

                flow.correctTurbulence();
            }
        }
        while (flow.repeatStep());

        {
            addProfiling(output, "output");
            const restart::unfinishedTime mark(runTime, runTime.writeTime());
            if (!runTime.write() && runTime.writeTime())
            {
                FatalErrorInFunction
                    << "Time " << runTime.timeName() << " could not be written" << nl
                    << "Expected: room on the disk, and a directory that this user may write to." << exit(FatalError);
            }
        }
        runTime.printExecutionTime(Info);
    }

    flow.finish();
    printProfile
    (
        Info,
        runTime.timeIndex() - runTime.startTimeIndex(),
        mesh.globalData().nTotalCells()
    );
    flow.reportBalance(Info);
    Info<< "End\n" << endl;

    return 0;
}

// ************************************************************************* //
