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


void Foam::freeSurfaceFlow::roundTime(Time& time)
{
    const auto rounded = [](const scalar x, const int bits)
    {
        int exponent;
        const scalar mantissa = std::frexp(x, &exponent);
        return
            std::ldexp
            (
                std::round(std::ldexp(mantissa, bits)),
                exponent - bits
            );
    };
    // Of written times, beyond the digits of their names
    const int ofTimes = 44;
    // Of steps, such that their sums are exact
    const int ofSteps = 24;

    if (time.timeIndex() == time.startTimeIndex())
    {
        time.setTime(rounded(time.value(), ofTimes), time.timeIndex());
    }

    const dictionary& control = time.controlDict();
    const word writes(control.getOrDefault<word>("writeControl", word::null));
    const scalar next = time.deltaTValue();
    if (writes == "adjustable" || writes == "adjustableRunTime")
    {
        const scalar interval = control.get<scalar>("writeInterval");
        const scalar n =
            (time.value() + next - time.startTime().value())/interval;
        if (mag(n - std::round(n))*interval < 1e-6*next)
        {
            time.setDeltaT
            (
                rounded(time.value() + next, ofTimes) - time.value(),
                false
            );
            return;
        }
    }
    time.setDeltaT(rounded(next, ofSteps), false);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::freeSurfaceFlow::chooseTimeStep(Time& time)
{
    addProfiling(timeStep, "time step");

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
    if (composite_)
    {
        roundTime(time);
    }

    Info<< "deltaT = " << time.deltaTValue() << endl;
    checkTimeStep();
}

// ************************************************************************* //
