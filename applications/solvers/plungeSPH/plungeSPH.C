// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    plungeSPH

Description
    A weakly compressible liquid with a free surface by smoothed-particle
    hydrodynamics, in two or three dimensions, on all cores of a machine. A case
    has constant/particleProperties, constant/g and system/controlDict.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "particleSimulation.H"
#include "sigFpe.H"

#include <omp.h>

using namespace Foam;

//- All cores that the process may use, unless OMP_NUM_THREADS or -threads says otherwise
label numberOfThreads(const argList& args)
{
    const label n = args.lookupOrDefault<label>("threads", omp_get_max_threads());
    if (n < 1)
    {
        FatalErrorInFunction
            << "Option -threads is " << n << nl
            << "Expected: 1 or more." << exit(FatalError);
    }
    return n;
}


template<int dim>
void simulate(Time& runTime, const smoothedParticles::particleProperties& properties, const label nThreads)
{
    smoothedParticles::particleSimulation<dim> flow(runTime, properties, nThreads);

    Info<< "Starting time loop\n" << endl;

    while (runTime.run())
    {
        flow.chooseTimeStep();

        ++runTime;

        flow.advance();
        flow.report();
        flow.endAtEvent();
        flow.write();
        flow.stopAtCollision();
    }
}


int main(int argc, char *argv[])
{
    argList::addNote
    (
        "A weakly compressible liquid with a free surface by smoothed-particle hydrodynamics."
    );
    argList::noParallel();
    argList::addOption("threads", "N", "Number of threads (default: OMP_NUM_THREADS, or all cores)");

    #include "setRootCaseLists.H"
    #include "createTime.H"

    // Each step looks for numbers that are not finite, and says which particle has them. Lanes of the sums that no
    // particle uses may divide by zero.
    sigFpe::unset();

    const smoothedParticles::particleProperties properties(runTime);
    properties.print(Info);

    if (properties.dimensions() == 2)
    {
        simulate<2>(runTime, properties, numberOfThreads(args));
    }
    else
    {
        simulate<3>(runTime, properties, numberOfThreads(args));
    }

    runTime.printExecutionTime(Info);
    Info<< "End\n" << endl;

    return 0;
}

// ************************************************************************* //
