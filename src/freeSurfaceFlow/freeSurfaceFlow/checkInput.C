// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "inputChecks.H"
#include "IOobjectList.H"
#include "localIOdictionary.H"
#include "restart.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- How far a fraction may be out of 0 to 1: as setAlphaField leaves it in the
//  warped cells of a snapped mesh, which is cut off, and as runs leave it
const scalar givenExcess = 0.05, computedExcess = 0.1;

//- Entries of boundary conditions that are values of the field
const wordHashSet values({"value", "inletValue", "refValue", "freestreamValue"});


template<class Type>
bool isFinite(const Type& value)
{
    for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
    {
        if (!std::isfinite(component(value, d)))
        {
            return false;
        }
    }
    return true;
}


//- Refuse a list of values, if it is one of this type, in which something is
//  not a number
template<class Type>
void checkFinite(const token::compound& list, const dictionary& dict, const word& name)
{
    if (!isA<token::Compound<List<Type>>>(list))
    {
        return;
    }
    const List<Type>& field = dynamicCast<const token::Compound<List<Type>>>(list);
    forAll(field, i)
    {
        if (!isFinite(field[i]))
        {
            refuseEntry(dict, name, text("has no number at ", i), "finite numbers.");
        }
    }
}


void checkFraction(const scalar value, const scalar excess, const dictionary& dict, const word& name)
{
    if (!(value >= -excess && value <= 1 + excess))
    {
        refuseEntry(dict, name, text("holds ", value), "fractions of the liquid, from 0 to 1.");
    }
}


//- Refuse the values of an entry that cannot be; excess: of a volume fraction,
//  or negative
void checkValues(const entry& e, const scalar excess, const dictionary& dict)
{
    if (!e.isStream())
    {
        return;
    }
    for (const token& t : e.stream())
    {
        if (t.isCompound())
        {
            const token::compound& list = t.compoundToken();
            checkFinite<scalar>(list, dict, e.keyword());
            checkFinite<vector>(list, dict, e.keyword());
            checkFinite<symmTensor>(list, dict, e.keyword());
            checkFinite<tensor>(list, dict, e.keyword());
            if (excess >= 0 && isA<token::Compound<List<scalar>>>(list))
            {
                for (const scalar value : dynamicCast<const token::Compound<List<scalar>>>(list))
                {
                    checkFraction(value, excess, dict, e.keyword());
                }
            }
        }
        else if (t.isNumber() && excess >= 0)
        {
            checkFraction(t.number(), excess, dict, e.keyword());
        }
    }
}


//- The number at the end of an entry, with or without dimensions; refused
//  unless it is at least, or above, zero
void checkProperty(const dictionary& dict, const word& name, const bool mayBeZero)
{
    const entry* e = dict.findEntry(name);
    if (!e || !e->isStream() || e->stream().empty() || !e->stream().last().isNumber())
    {
        // That of a model
        return;
    }
    const scalar value = e->stream().last().number();
    if (!(mayBeZero ? value >= 0 : value > 0) || !std::isfinite(value))
    {
        refuseEntry(dict, name, text("is ", value), mayBeZero ? "0, or a positive number." : "a positive number.");
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dynamicFvMesh& Foam::freeSurfaceFlow::withCheckedInput(dynamicFvMesh& mesh)
{
    const Time& time = mesh.time();
    const IOdictionary transport
    (
        IOobject("transportProperties", time.constant(), mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false)
    );
    const wordList phases(transport.get<wordList>("phases"));
    if (phases.size() != 2)
    {
        refuseEntry(transport, "phases", text("is ", flatOutput(phases)), "two names, the liquid's first.");
    }
    for (const word& phase : phases)
    {
        const dictionary& properties = transport.subDict(phase);
        checkProperty(properties, "rho", false);
        checkProperty(properties, "nu", true);
    }
    checkProperty(transport.isDict("sigma") ? transport.subDict("sigma") : transport, "sigma", true);

    // The fields, before anything reckons with them
    const word liquid(IOobject::groupName("alpha", phases[0]));
    const IOobjectList objects(mesh, time.timeName());
    for (const word& name : objects.sortedNames())
    {
        const IOobject& file = *objects[name];
        const word& type = file.headerClassName();
        if (!(type.starts_with("vol") || type.starts_with("surface")) || !type.ends_with("Field"))
        {
            continue;
        }
        const localIOdictionary field
        (
            IOobject(name, time.timeName(), mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false),
            type
        );
        const scalar excess = name != liquid ? -1 : restart::isFrom(mesh) ? computedExcess : givenExcess;
        if (const entry* internal = field.findEntry("internalField"))
        {
            checkValues(*internal, excess, field);
        }
        for (const entry& patch : field.subOrEmptyDict("boundaryField"))
        {
            if (!patch.isDict())
            {
                continue;
            }
            for (const entry& e : patch.dict())
            {
                checkValues(e, values.found(e.keyword()) ? excess : -1, patch.dict());
            }
        }
    }
    return mesh;
}


void Foam::freeSurfaceFlow::checkFluids() const
{
    const dictionary& transport = mixture_;
    const wordList phases(transport.get<wordList>("phases"));
    const auto refuseFluid = [&](const label phasei, const char* what, const scalar value, const char* expected)
    {
        refuse(transport.subDict(phases[phasei]), text("The ", what, " of ", phases[phasei], " is ", value), expected);
    };

    // Also of those that a model gives
    const scalar rho[] = {mixture_.rho1().value(), mixture_.rho2().value()};
    const scalar nu[] =
    {
        gMin(mixture_.nuModel1().nu()().primitiveField()),
        gMin(mixture_.nuModel2().nu()().primitiveField())
    };
    for (const label phasei : {0, 1})
    {
        if (!(rho[phasei] > 0))
        {
            refuseFluid(phasei, "density", rho[phasei], "a positive one [kg/m3].");
        }
        if (!(nu[phasei] >= 0))
        {
            refuseFluid(phasei, "kinematic viscosity", nu[phasei], "0, or a positive one [m2/s].");
        }
    }
}


void Foam::freeSurfaceFlow::checkCorrections() const
{
    const dictionary& pimple = pimple_.dict();
    for (const word name : {"nOuterCorrectors", "nCorrectors"})
    {
        const label n = pimple.getOrDefault<label>(name, 1);
        if (n < 1 && !(name == "nCorrectors" && isGiven()))
        {
            refuseEntry(pimple, name, text("is ", n), "a whole number, at least 1; nCorrectors -1 for a flow that is given, without a body.");
        }
    }
    const label n = pimple.getOrDefault<label>("nNonOrthogonalCorrectors", 0);
    if (n < 0 && !isGiven())
    {
        refuseEntry(pimple, "nNonOrthogonalCorrectors", text("is ", n), "a whole number, at least 0.");
    }

    const dictionary& interface = mesh_.solverDict(mixture_.alpha1().name());
    for (const word name : {"nAlphaCorr", "nAlphaSubCycles"})
    {
        const label n = interface.getOrDefault<label>(name, 1);
        if (n < 1)
        {
            refuseEntry(interface, name, text("is ", n), "a whole number, at least 1.");
        }
    }
}


void Foam::freeSurfaceFlow::checkDiffusion() const
{
    if (isGiven())
    {
        return;
    }
    const label n = pimple_.dict().getOrDefault<label>("nCorrectors", 1);
    const scalar D = diffusionNumber();
    if (D > runGuard::largestDiffusion(n))
    {
        refuseEntry
        (
            pimple_.dict(),
            "nCorrectors",
            text("is ", n, ", but the diffusion number of the first step is ", D),
            text("3, or a shorter deltaT: a diffusion number of at most ", runGuard::largestDiffusion(n), '.')
        );
    }
}


bool Foam::freeSurfaceFlow::isGiven() const
{
    return !body_ && pimple_.dict().getOrDefault<label>("nCorrectors", 1) < 0;
}


Foam::label Foam::freeSurfaceFlow::nCorrections() const
{
    return pimple_.dict().getOrDefault<label>("nOuterCorrectors", 1)*pimple_.dict().getOrDefault<label>("nCorrectors", 1);
}

// ************************************************************************* //
