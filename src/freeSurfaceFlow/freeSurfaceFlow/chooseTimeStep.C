// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "fvc.H"
#include "inputChecks.H"
#include "profiling.H"
#include "restart.H"
#include "timeControls.H"

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

    scalarField sumPhi(fvc::surfaceSum(mag(composite_.masked(phi)))().primitiveField());
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

    refuse
    (
        control,
        text
        (
            "The time step has fallen to ", deltaT, " s, less than ",
            (control.found("minDeltaT") ? "minDeltaT, " : ""), minDeltaT, " s\nThe flow diverges: it is fastest, ",
            largest, " m/s, at ", where
        ),
        "smaller maxCo and maxAlphaCo, or a better mesh there"
    );
}


Foam::tmp<Foam::scalarField> Foam::freeSurfaceFlow::nearInterface() const
{
    const scalarField& alpha = mixture_.alpha1().primitiveField();
    return pos0(alpha - 0.01)*pos0(0.99 - alpha);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //


void Foam::freeSurfaceFlow::chooseTimeStep(Time& time)
{
    addProfiling(timeStep, "time step");

    if (time.timeIndex() == time.startTimeIndex())
    {
        checkFunctionObjects(time);
    }
    else
    {
        checkLastStep();
    }
    renewAfterWrite();

    if (rDeltaT_.valid())
    {
        chooseLocalTimeSteps();
        return;
    }

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
        checkFixedStep(Co);
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
    time.setDeltaT(restart::untied(time, min(factor*deltaT, maxDeltaT)));
    restart::alignTimeStep(time);

    Info<< "deltaT = " << time.deltaTValue() << endl;
    checkTimeStep();
}

// ************************************************************************* //
