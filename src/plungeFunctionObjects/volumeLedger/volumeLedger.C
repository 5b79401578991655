// SPDX-License-Identifier: GPL-3.0-or-later

#include "volumeLedger.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"
#include "surfaceFields.H"
#include "volFields.H"
#include "whileRunning.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(volumeLedger, 0);
    addToRunTimeSelectionTable(functionObject, volumeLedger, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::volumeLedger::volumeLedger
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, whileRunning(dict)),
    bodyVolume_(0),
    interval_(1),
    initialVolume_(0),
    outflow_(0),
    error_(0),
    largestError_(0),
    table_
    (
        runTime,
        name,
        "volumeLedger",
        "time_s,uniqueLiquid_m3,outflow_m3,error_m3,"
        "error_percent_of_body_volume"
    )
{
    read(dict);

    // A restart carries on the account of the run before
    const scalar now = volume();
    initialVolume_ = getProperty<scalar>("initialVolume", now);
    outflow_ = getProperty<scalar>("outflow", 0);
    largestError_ = getProperty<scalar>("largestError", 0);
    balance(now);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::functionObjects::volumeLedger::alphaName() const
{
    const IOdictionary& transport =
        mesh_.lookupObject<IOdictionary>("transportProperties");
    return IOobject::groupName("alpha", transport.get<wordList>("phases")[0]);
}


Foam::scalar Foam::functionObjects::volumeLedger::volume() const
{
    return uniqueVolume::New(mesh_).of
    (
        mesh_.lookupObject<volScalarField>(alphaName()).primitiveField()
    );
}


Foam::scalar Foam::functionObjects::volumeLedger::outflowRate() const
{
    return uniqueVolume::New(mesh_).outflow
    (
        mesh_.lookupObject<surfaceScalarField>
        (
            "alphaPhi0" + alphaName().substr(5)
        )
    );
}


void Foam::functionObjects::volumeLedger::balance(const scalar volume)
{
    error_ = volume + outflow_ - initialVolume_;
    if (mag(error_) > mag(largestError_))
    {
        largestError_ = error_;
    }

    const scalar percent = 100*error_/bodyVolume_;
    setResult("errorPercent", percent);
    table_ << time_.value() << volume << outflow_ << error_ << percent;
    table_.endLine();
}


// * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * * //

bool Foam::functionObjects::volumeLedger::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);

    bodyVolume_ = dict.get<scalar>("bodyVolume");
    interval_ = dict.lookupOrDefault<label>("interval", 1);
    for (const auto& e : {std::make_pair("bodyVolume", bodyVolume_),
                          std::make_pair("interval", scalar(interval_))})
    {
        checkPositive(dict, e.first, e.second);
    }
    return true;
}


bool Foam::functionObjects::volumeLedger::execute()
{
    outflow_ += outflowRate()*time_.deltaTValue();

    if (time_.timeIndex() % interval_ == 0)
    {
        balance(volume());
    }
    return true;
}


bool Foam::functionObjects::volumeLedger::write()
{
    setProperty("initialVolume", initialVolume_);
    setProperty("outflow", outflow_);
    setProperty("largestError", largestError_);
    return true;
}


bool Foam::functionObjects::volumeLedger::end()
{
    Log << "Liquid volume ledger: error " << 100*error_/bodyVolume_
        << " % of the body's volume at the end, "
        << 100*largestError_/bodyVolume_ << " % at most" << nl << endl;
    return true;
}

// ************************************************************************* //
