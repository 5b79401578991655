// SPDX-License-Identifier: GPL-3.0-or-later

#include "titanFluidViscosity.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"

namespace Foam
{
namespace viscosityModels
{
    defineTypeNameAndDebug(titanFluid, 0);
    addToRunTimeSelectionTable(viscosityModel, titanFluid, dictionary);
}
}

using Foam::titan::property;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::viscosityModels::titanFluid::addEntry
(
    const dictionary& dict,
    const word& name,
    const scalar value
)
{
    // A value that was copied from a log has six digits
    scalar given = value;
    if
    (
        dict.readIfPresent(name, given)
     && mag(given - value) > 5e-6*mag(value)
    )
    {
        refuseEntry
        (
            dict,
            name,
            text
            (
                "is ", given, ", but that of ", fluid_->fluid().name(), " at ", fluid_->fluid().T(), " K and ",
                fluid_->fluid().p(), " Pa is ", value
            ),
            text("no entry ", name, ", or the same value.")
        );
    }
    viscosityProperties_.add(name, value, true);
}


void Foam::viscosityModels::titanFluid::select(const dictionary& dict)
{
    // The dictionary of a single phase holds entries of others, too
    if (&dict.parent() != &dictionary::null)
    {
        checkKeywords
        (
            dict,
            titan::fluidField::keywords()
          | wordHashSet
            ({
                "transportModel", "stratification",
                "rho", "nu", "soundSpeed", "vapourPressure"
            })
        );
    }

    fluid_.reset
    (
        new titan::fluidField(dict, U_.mesh(), {property::viscosity})
    );
    const titan::fluidSelection& fluid = fluid_->fluid();
    const scalar rho = fluid.value(property::density, dict);
    const scalar nu = fluid.value(property::viscosity, dict)/rho;
    const scalar pVapour = fluid.vapourPressure();

    addEntry(dict, "rho", rho);
    addEntry(dict, "nu", nu);
    if (fluid.has(property::soundSpeed))
    {
        addEntry
        (
            dict,
            "soundSpeed",
            fluid.value(property::soundSpeed, dict)
        );
    }
    if (pVapour > 0)
    {
        addEntry(dict, "vapourPressure", pVapour);
    }

    Info<< typeName << ": ";
    fluid_->print
    (
        Info,
        {property::density, property::viscosity, property::soundSpeed}
    );
    if (debug)
    {
        titan::fluidField::printInFull(Info, {{"nu", nu}, {"rho", rho}});
    }
}


void Foam::viscosityModels::titanFluid::update()
{
    fluid_->evaluate
    (
        property::viscosity,
        viscosityProperties_.get<scalar>("rho"),
        nu_
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityModels::titanFluid::titanFluid
(
    const word& name,
    const dictionary& viscosityProperties,
    const volVectorField& U,
    const surfaceScalarField& phi
)
:
    viscosityModel(name, viscosityProperties, U, phi),
    fluid_(nullptr),
    nu_
    (
        IOobject
        (
            name,
            U.time().timeName(),
            U.db(),
            IOobject::NO_READ,
            IOobject::NO_WRITE
        ),
        U.mesh(),
        dimensionedScalar(dimViscosity, Zero)
    )
{
    select(viscosityProperties);
    update();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscosityModels::titanFluid::correct()
{
    if (!fluid_->steady())
    {
        update();
    }
}


bool Foam::viscosityModels::titanFluid::read
(
    const dictionary& viscosityProperties
)
{
    viscosityModel::read(viscosityProperties);
    select(viscosityProperties);
    update();
    return true;
}

// ************************************************************************* //
