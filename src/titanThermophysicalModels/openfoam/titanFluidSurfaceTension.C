// SPDX-License-Identifier: GPL-3.0-or-later

#include "titanFluidSurfaceTension.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"
#include "volFields.H"

namespace Foam
{
namespace surfaceTensionModels
{
    defineTypeNameAndDebug(titanFluid, 0);
    addToRunTimeSelectionTable(surfaceTensionModel, titanFluid, dictionary);
}
}

using Foam::titan::property;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::surfaceTensionModels::titanFluid::select(const dictionary& dict)
{
    checkKeywords
    (
        dict,
        titan::fluidField::keywords() | wordHashSet({"type"})
    );
    fluid_.reset(new titan::fluidField(dict, mesh_, {property::surfaceTension}));
    sigma_ = fluid_->fluid().value(property::surfaceTension, dict);

    Info<< typeName << ": ";
    fluid_->print(Info, {property::surfaceTension});
    if (debug)
    {
        titan::fluidField::printInFull(Info, {{"sigma", sigma_}});
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceTensionModels::titanFluid::titanFluid
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    surfaceTensionModel(mesh),
    fluid_(nullptr),
    sigma_(0)
{
    select(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField>
Foam::surfaceTensionModels::titanFluid::sigma() const
{
    auto tsigma = tmp<volScalarField>::New
    (
        IOobject
        (
            "sigma",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar("sigma", dimSigma, sigma_)
    );
    if (!fluid_->uniform())
    {
        fluid_->evaluate(property::surfaceTension, 1, tsigma.ref());
    }
    return tsigma;
}


bool Foam::surfaceTensionModels::titanFluid::readDict(const dictionary& dict)
{
    select(sigmaDict(dict));
    return true;
}


bool Foam::surfaceTensionModels::titanFluid::writeData(Ostream& os) const
{
    if (surfaceTensionModel::writeData(os))
    {
        os  << sigma_ << token::END_STATEMENT << nl;
        return os.good();
    }
    return false;
}

// ************************************************************************* //
