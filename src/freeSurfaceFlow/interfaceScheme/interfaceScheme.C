// SPDX-License-Identifier: GPL-3.0-or-later

#include "interfaceScheme.H"
#include "alphaContactAngleTwoPhaseFvPatchScalarField.H"
#include "inputChecks.H"
#include "isoAdvectorScheme.H"
#include "restart.H"
#include "fvc.H"
#include "localEulerDdtScheme.H"
#include "subCycle.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(interfaceScheme, 0);
    defineRunTimeSelectionTable(interfaceScheme, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

bool hasContactAngles(const Foam::volScalarField& alpha)
{
    for (const auto& p : alpha.boundaryField())
    {
        if (Foam::isA<Foam::alphaContactAngleTwoPhaseFvPatchScalarField>(p))
        {
            return true;
        }
    }
    return false;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfaceScheme::interfaceScheme(const fields& f)
:
    f_(f),
    mesh_(f.U.mesh()),
    alpha1_(f.mixture.alpha1()),
    alpha2_(f.mixture.alpha2()),
    alphaPhi_
    (
        restart::field(IOobject::groupName("alphaPhi0", alpha1_.group()), mesh_),
        f.phi*fvc::interpolate(alpha1_)
    ),
    contactAngles_(f.interface && hasContactAngles(alpha1_))
{}


Foam::autoPtr<Foam::interfaceScheme> Foam::interfaceScheme::New
(
    const word& name,
    const dictionary& sceneDict,
    const fields& f
)
{
    const auto constructor = dictionaryConstructorTablePtr_->cfind(name);
    if (!constructor.found())
    {
        refuseEntry
        (
            sceneDict,
            "interface",
            text("is ", name),
            text("one of ", dictionaryConstructorTablePtr_->sortedToc())
        );
    }
    return constructor()(f);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::interfaceScheme::subCycle()
{
    const label nSubCycles = controls().get<label>("nAlphaSubCycles");

    if (nSubCycles == 1)
    {
        advance();
        return;
    }

    const dimensionedScalar deltaT(mesh_.time().deltaT());
    surfaceScalarField meanAlphaPhi("meanAlphaPhi", 0*alphaPhi_);

    // Registered by its name, for the time scheme
    tmp<volScalarField> rSubDeltaT;
    if (fv::localEulerDdt::enabled(mesh_))
    {
        rSubDeltaT = fv::localEulerDdt::localRSubDeltaT(mesh_, nSubCycles);
    }

    for
    (
        Foam::subCycle<volScalarField> cycle(alpha1_, nSubCycles);
        !(++cycle).end();
    )
    {
        advance();
        meanAlphaPhi += (mesh_.time().deltaT()/deltaT)*alphaPhi_;
    }

    alphaPhi_ = meanAlphaPhi;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::interfaceScheme::needsNormals(const word& name)
{
    return name != interfaceSchemes::isoAdvector::typeName;
}

// ************************************************************************* //
