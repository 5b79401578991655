// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    slenderBody

Description
    The dive of a slender body of revolution by ordinary differential equations:
    added mass by strips of the wetted part, its hydrostatics, the entry's force,
    a friction line, drag across the axis and a tail, in six degrees of freedom.
    A case has constant/slenderBodyProperties, constant/g and
    system/controlDict, of which the end time counts.

    With -sample TABLE many dives, each a line of the table (function
    diveSample).
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "diveSample.H"
#include "diveTables.H"
#include "IOdictionary.H"
#include "sigFpe.H"
#include "timeControls.H"
#include "uniformDimensionedFields.H"

using namespace Foam;
using namespace Foam::slenderBody;

void dive(const Time& runTime, const dictionary& dict, const vector& g)
{
    const slenderProperties properties(dict, g, runTime.path());
    slenderDive dive(properties, runTime.endTime().value());
    diveTables tables(runTime, properties);

    diveTables::printScene(Info, properties, dive.model());
    tables.write(dive);

    while (dive.runs())
    {
        dive.advance();
        tables.write(dive);
    }

    diveTables::printEnd(Info, dive);
}


int main(int argc, char *argv[])
{
    argList::addNote("The dive of a slender body of revolution, by strips.");
    argList::noParallel();
    argList::addOption("sample", "table", "Many dives: columns are entries of constant/slenderBodyProperties, as body/mass");

    #include "setRootCaseLists.H"
    #include "createTime.H"

    checkTimeControls(runTime);

    // Each step looks for numbers that are not finite
    sigFpe::unset();

    const IOdictionary dict(IOobject("slenderBodyProperties", runTime.constant(), runTime, IOobject::MUST_READ, IOobject::NO_WRITE, false));
    const vector g
    (
        uniformDimensionedVectorField(IOobject("g", runTime.constant(), runTime, IOobject::MUST_READ, IOobject::NO_WRITE, false)).value()
    );

    if (args.found("sample"))
    {
        diveSample(runTime, dict, g, args.get<fileName>("sample"), runTime.endTime().value());
    }
    else
    {
        dive(runTime, dict, g);
    }

    runTime.printExecutionTime(Info);
    Info<< "End\n" << endl;

    return 0;
}

// ************************************************************************* //
