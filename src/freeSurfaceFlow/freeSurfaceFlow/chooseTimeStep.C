// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "fvc.H"
#include "profiling.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::freeSurfaceFlow::courantNumber
(
    const char* name,
    const surfaceScalarField& phi,
    const tmp<scalarField>& indicator
) const
{
    if (!mesh_.nInternalFaces())
    {
        return 0;
    }

    scalarField sumPhi
    (
        composite_
      ? fvc::surfaceSum(mag(composite_->faceMask()*phi))().primitiveField()
      : fvc::surfaceSum(mag(phi))().primitiveField()
    );
    if (indicator.valid())
    {
        sumPhi *= indicator();
    }

    const scalarField& V = mesh_.V().field();
    const scalar largest = 0.5*gMax(sumPhi/V)*time_.deltaTValue();
    const scalar mean = 0.5*(gSum(sumPhi)/gSum(V))*time_.deltaTValue();

    Info<< name << " mean: " << mean << " max: " << largest << endl;
    return largest;
}


void Foam::freeSurfaceFlow::checkTimeStep()
{
    const dictionary& control = time_.controlDict();
    const scalar deltaT = time_.deltaTValue();
    longestDeltaT_ = max(longestDeltaT_, deltaT);

    // No flow that this solver is for needs steps so much shorter than before
    const scalar minDeltaT =
        control.lookupOrDefault<scalar>("minDeltaT", 1e-6*longestDeltaT_);
    if (deltaT >= minDeltaT)
    {
        return;
    }

    const scalarField speed(mag(U_.primitiveField()));
    const label fastest = speed.size() ? findMax(speed) : -1;
    const scalar largest = gMax(speed);
    point where(-VGREAT, -VGREAT, -VGREAT);
    if (fastest != -1 && speed[fastest] == largest)
    {
        where = mesh_.C()[fastest];
    }
    reduce(where, maxOp<point>());

    FatalIOErrorInFunction(control)
        << "The time step has fallen to " << deltaT << " s, less than "
        << (control.found("minDeltaT") ? "minDeltaT, " : "")
        << minDeltaT << " s" << nl
        << "The flow diverges: it is fastest, " << largest << " m/s, at "
        << where << nl
        << "Expected: smaller maxCo and maxAlphaCo, or a better mesh there"
        << exit(FatalIOError);
}


Foam::tmp<Foam::scalarField> Foam::freeSurfaceFlow::nearInterface() const
{
    const scalarField& alpha = mixture_.alpha1().primitiveField();
    return pos0(alpha - 0.01)*pos0(0.99 - alpha);
}


void Foam::freeSurfaceFlow::alignTimeStep(Time& time)
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


void Foam::freeSurfaceFlow::renewAfterWrite()
{
    if (!time_.writeTime())
    {
        return;
    }
    if (addedMass_)
    {
        addedMass_->forgetPressures();
    }
    if (interface_ && mesh_.dynamic())
    {
        // First free the names of its fields
        interface_.clear();
        interface_.reset
        (
            new interfaceProperties(mixture_.alpha1(), U_, mixture_)
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::freeSurfaceFlow::restoreTime(Time& time)
{
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


void Foam::freeSurfaceFlow::chooseTimeStep(Time& time)
{
    addProfiling(timeStep, "time step");

    renewAfterWrite();

    const dictionary& control = time.controlDict();

    const scalar Co = courantNumber("Courant Number", phi_, nullptr);
    const scalar alphaCo =
        courantNumber("Interface Courant Number", phi_, nearInterface());
    const scalar maxMeshCo = control.lookupOrDefault<scalar>("maxMeshCo", GREAT);
    const scalar meshCo =
        mesh_.moving()
     && (maxMeshCo < GREAT || controls().checkMeshCourantNo)
      ? courantNumber("Mesh Courant Number", mesh_.phi(), nullptr)
      : 0;

    if (!control.lookupOrDefault<bool>("adjustTimeStep", false))
    {
        return;
    }

    const scalar maxDeltaT = control.lookupOrDefault<scalar>("maxDeltaT", GREAT);

    // How far the first step given by the user can stand
    scalar deltaT = time.deltaTValue();
    if (time.timeIndex() == 0 && Co > SMALL)
    {
        deltaT =
            min(control.get<scalar>("maxCo")*deltaT/Co, min(deltaT, maxDeltaT));
    }
    const scalar shrunk = deltaT/time.deltaTValue();

    // Allowed growth; a reduction takes effect at once
    const scalar allowed =
        min
        (
            control.get<scalar>("maxCo")/(shrunk*Co + SMALL),
            min
            (
                control.get<scalar>("maxAlphaCo")/(shrunk*alphaCo + SMALL),
                maxMeshCo/(shrunk*meshCo + SMALL)
            )
        );
    const scalar factor = min(min(allowed, 1 + 0.1*allowed), scalar(1.2));
    time.setDeltaT(min(factor*deltaT, maxDeltaT));
    alignTimeStep(time);

    Info<< "deltaT = " << time.deltaTValue() << endl;
    checkTimeStep();
}

// ************************************************************************* //
