// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "extrapolatedCalculatedFvPatchFields.H"
#include "fvc.H"
#include "fvcSmooth.H"
#include "inputChecks.H"
#include "localEulerDdtScheme.H"
#include "restart.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField>
Foam::freeSurfaceFlow::newLocalTimeSteps() const
{
    if (!fv::localEulerDdt::enabled(mesh_))
    {
        return tmp<volScalarField>();
    }

    // A mesh moves, and isoAdvection carries the interface, by one step of time
    if (mesh_.dynamic() || scene_.interface() != "MULES")
    {
        refuseEntry
        (
            mesh_.schemesDict().subDict("ddtSchemes"),
            "default",
            text
            (
                "is localEuler, but ",
                (
                    mesh_.dynamic()
                  ? string("the mesh is a " + mesh_.type())
                  : string("the interface is carried by " + scene_.interface())
                )
            ),
            "a scheme that is accurate in time; localEuler is for MULES on a"
            " mesh that does not change."
        );
    }

    return tmp<volScalarField>::New
    (
        restart::field(fv::localEulerDdt::rDeltaTName, mesh_),
        mesh_,
        dimensionedScalar("one", dimless/dimTime, 1),
        extrapolatedCalculatedFvPatchScalarField::typeName
    );
}


void Foam::freeSurfaceFlow::chooseLocalTimeSteps()
{
    const dictionary& dict = pimple_.dict();
    const scalar maxCo = dict.lookupOrDefault<scalar>("maxCo", 0.9);
    const scalar maxAlphaCo = dict.lookupOrDefault<scalar>("maxAlphaCo", 0.2);
    const scalar maxDeltaT = dict.lookupOrDefault<scalar>("maxDeltaT", GREAT);
    const scalar smoothing =
        dict.lookupOrDefault<scalar>("rDeltaTSmoothingCoeff", 0.1);
    const scalar damping =
        dict.lookupOrDefault<scalar>("rDeltaTDampingCoeff", 1);
    const label nSpread = dict.lookupOrDefault<label>("nAlphaSpreadIter", 1);
    const label nSweep = dict.lookupOrDefault<label>("nAlphaSweepIter", 5);
    const scalar spreadDiff =
        dict.lookupOrDefault<scalar>("alphaSpreadDiff", 0.2);
    const scalar spreadMax =
        dict.lookupOrDefault<scalar>("alphaSpreadMax", 0.99);
    const scalar spreadMin =
        dict.lookupOrDefault<scalar>("alphaSpreadMin", 0.01);

    volScalarField& rDeltaT = rDeltaT_.ref();
    const volScalarField& alpha1 = mixture_.alpha1();
    const volScalarField rDeltaT0("rDeltaT0", rDeltaT);

    auto print = [&](const char* name)
    {
        const scalarField steps(1/rDeltaT.primitiveField());
        Info<< name << " time scale min/max = "
            << gMin(steps) << ", " << gMax(steps) << endl;
    };

    rDeltaT.ref() =
        max
        (
            1/dimensionedScalar("maxDeltaT", dimTime, maxDeltaT),
            fvc::surfaceSum(mag(rhoPhi_))()()
           /((2*maxCo)*mesh_.V()*rho_())
        );

    if (maxAlphaCo < maxCo)
    {
        // Where the interface, spread by a cell, is
        const volScalarField alphaBar(fvc::average(alpha1));
        rDeltaT.ref() =
            max
            (
                rDeltaT(),
                pos0(alphaBar() - spreadMin)
               *pos0(spreadMax - alphaBar())
               *fvc::surfaceSum(mag(phi_))()()
               /((2*maxAlphaCo)*mesh_.V())
            );
    }
    rDeltaT.correctBoundaryConditions();
    print("Flow");

    if (smoothing < 1)
    {
        fvc::smooth(rDeltaT, smoothing);
    }
    if (nSpread > 0)
    {
        fvc::spread
        (
            rDeltaT,
            alpha1,
            nSpread,
            spreadDiff,
            spreadMax,
            spreadMin
        );
    }
    if (nSweep > 0)
    {
        fvc::sweep(rDeltaT, alpha1, nSweep, spreadDiff);
    }
    print("Smoothed flow");

    if (damping < 1 && time_.timeIndex() > time_.startTimeIndex() + 1)
    {
        rDeltaT = max(rDeltaT, (1 - damping)*rDeltaT0);
        print("Damped flow");
    }
}

// ************************************************************************* //
