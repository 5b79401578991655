// SPDX-License-Identifier: GPL-3.0-or-later

#include "isoAdvectorScheme.H"
#include "addToRunTimeSelectionTable.H"
#include "foamVersion.H"
#include "fvc.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace interfaceSchemes
{
    defineTypeNameAndDebug(isoAdvector, 0);
    addToRunTimeSelectionTable(interfaceScheme, isoAdvector, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfaceSchemes::isoAdvector::isoAdvector(const fields& f)
:
    interfaceScheme(f),
    advector_(alpha1_, f.phi, f.U)
{
    #if OPENFOAM < 2006
    const word reconstruction
    (
        controls().lookupOrDefault<word>("reconstructionScheme", "isoAlpha")
    );
    if (reconstruction != "isoAlpha")
    {
        refuseEntry
        (
            controls(),
            "reconstructionScheme",
            text
            (
                "is ", reconstruction, ", which OpenFOAM v", OPENFOAM,
                " does not have"
            ),
            "isoAlpha, the only one before OpenFOAM v2006."
        );
    }
    #endif

    if (f.composite.isOverset())
    {
        FatalErrorInFunction
            << "constant/sceneProperties: entry interface is " << typeName
            << ", which does not hold on an overset mesh: the fluxes that are"
            << " interpolated at its fringe do not conserve volume." << nl
            << "Expected: MULES." << exit(FatalError);
    }
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::interfaceSchemes::isoAdvector::advance()
{
    // The interface moves relative to the mesh
    if (mesh_.moving())
    {
        f_.U -= fvc::reconstruct(mesh_.phi());
    }

    foamVersion::advect(advector_);

    if (mesh_.moving())
    {
        f_.U += fvc::reconstruct(mesh_.phi());
    }

    // The mass flux of a liquid of density one in nothing
    alphaPhi_ = advector_.getRhoPhi
    (
        dimensionedScalar("one", dimless, 1),
        dimensionedScalar(dimless, Zero)
    );
    alpha2_ = 1 - alpha1_;

    if (contactAngles_)
    {
        f_.interface->correct();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::interfaceSchemes::isoAdvector::advect()
{
    const bool iterate = f_.pimple.nCorrPIMPLE() > 1;

    if (iterate && f_.pimple.firstIter())
    {
        alpha1_.storePrevIter();
        f_.phi.storePrevIter();
        f_.U.storePrevIter();
    }

    if (!iterate || f_.pimple.firstIter())
    {
        subCycle();
        setRhoPhi(f_.phi);
        return;
    }

    // Start again from the old interface, carried by the mean velocity
    const volVectorField latestU("latestU", f_.U);
    const surfaceScalarField latestPhi("latestPhi", f_.phi);

    alpha1_ = alpha1_.prevIter();
    f_.U = 0.5*(f_.U.prevIter() + latestU);
    f_.phi = 0.5*(f_.phi.prevIter() + latestPhi);

    subCycle();
    setRhoPhi(f_.phi);

    f_.U = latestU;
    f_.phi = latestPhi;
}

// ************************************************************************* //
