// SPDX-License-Identifier: GPL-3.0-or-later

#include "lakeStratification.H"

#include "addToRunTimeSelectionTable.H"
#include "FlatOutput.H"
#include "fvMatrices.H"
#include "inputChecks.H"
#include "IOdictionary.H"
#include "volFields.H"

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(lakeStratification, 0);
    addToRunTimeSelectionTable(option, lakeStratification, dictionary);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fv::lakeStratification::readProfile()
{
    const word phase(coeffs_.get<word>("phase"));
    alphaName_ = IOobject::groupName("alpha", phase);

    const dictionary& liquid =
        mesh_.lookupObject<IOdictionary>("transportProperties").subDict(phase);
    profile_.reset
    (
        new titan::lakeProfile(liquid.subDict("stratification"), mesh_)
    );
}


void Foam::fv::lakeStratification::checkPressure() const
{
    const auto* p = mesh_.findObject<volScalarField>("p_rgh");
    if (!p)
    {
        return;
    }

    wordList patches;
    for (const fvPatchScalarField& patch : p->boundaryField())
    {
        if (patch.type() == "fixedFluxPressure")
        {
            patches.append(patch.patch().name());
        }
    }
    if (patches.size())
    {
        IOWarningInFunction(coeffs_)
            << "p_rgh on patches " << flatOutput(patches)
            << " is fixedFluxPressure, which leaves out the weight that is"
            << " added here: pressures next to them are off by that of half a"
            << " cell" << nl
            << "Expected: fixedFluxExtrapolatedPressure." << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fv::lakeStratification::lakeStratification
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh),
    profile_(nullptr)
{
    readProfile();
    checkPressure();
    fieldNames_ = {coeffs_.lookupOrDefault<word>("U", "U")};
    applied_.setSize(1, false);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fv::lakeStratification::addSup
(
    const volScalarField&,
    fvMatrix<vector>& eqn,
    const label
)
{
    const scalarField& alpha =
        mesh_.lookupObject<volScalarField>(alphaName_).primitiveField();
    scalarField rho(alpha.size());
    profile_->evaluate
    (
        titan::property::density,
        mesh_.C().primitiveField(),
        rho
    );

    eqn += volVectorField::Internal
    (
        IOobject(name_, mesh_.time().timeName(), mesh_),
        mesh_,
        dimDensity*dimAcceleration,
        alpha*(rho - profile_->surfaceDensity())*profile_->g()
    );
}


void Foam::fv::lakeStratification::addSup(fvMatrix<vector>&, const label)
{
    refuse(coeffs_, "A solver for one fluid of constant density", "a solver for two fluids, such as interFoam.");
}


bool Foam::fv::lakeStratification::read(const dictionary& dict)
{
    if (option::read(dict))
    {
        readProfile();
        return true;
    }
    return false;
}

// ************************************************************************* //
