// SPDX-License-Identifier: GPL-3.0-or-later

#include "liquidLaw.H"
#include "fluidSelection.H"

#include "Enum.H"
#include "FlatOutput.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::titan;

enum class stiffnessType
{
    fluid,
    waveTank,
    MachNumber,
    given
};

const Enum<stiffnessType> stiffnessTypeNames
({
    { stiffnessType::fluid, "fluid" },
    { stiffnessType::waveTank, "waveTank" },
    { stiffnessType::MachNumber, "MachNumber" },
    { stiffnessType::given, "given" },
});

const Enum<compression> compressionNames
({
    { compression::isentropic, "isentropic" },
    { compression::isothermal, "isothermal" },
});

//- "Typically chosen to be around 7" (IAC-20-E2.1.9)
constexpr scalar defaultGamma = 7;


//- What a law is about
struct reference
{
    //- None if rho0 and p0 are given
    autoPtr<fluidSelection> fluid;

    scalar p0;
    scalar rho0;
    stiffnessType type;
};


reference readReference(const dictionary& dict)
{
    reference ref;
    if (dict.found("fluid") || dict.found("composition"))
    {
        for (const word name : {"rho0", "p0"})
        {
            if (dict.found(name))
            {
                refuse
                (
                    dict,
                    text("Entry ", name, ": density and pressure are those of the fluid"),
                    "either a fluid, with T and p if these are not the surface's, or rho0 and p0."
                );
            }
        }
        ref.fluid.reset(new fluidSelection(dict));
        ref.p0 = ref.fluid->p();
        ref.rho0 = ref.fluid->value(property::density, dict);
        ref.type = readChoice(stiffnessTypeNames, dict, "stiffness", stiffnessType::fluid);
    }
    else
    {
        ref.p0 = dict.get<scalar>("p0");
        ref.rho0 = dict.get<scalar>("rho0");
        ref.type = readChoice(stiffnessTypeNames, dict, "stiffness");
        if (ref.type == stiffnessType::fluid)
        {
            refuseEntry
            (
                dict,
                "stiffness",
                "is fluid, but there is no fluid",
                text
                (
                    "entry fluid or composition, or another stiffness of ",
                    flatOutput(stiffnessTypeNames.sortedToc())
                )
            );
        }
    }
    return ref;
}


stiffness readFluidStiffness
(
    const dictionary& dict,
    const fluidSelection& fluid
)
{
    const compression along = readChoice(compressionNames, dict, "along", compression::isentropic);
    const property K =
        along == compression::isentropic
      ? property::isentropicBulkModulus
      : property::isothermalBulkModulus;

    stiffness s{fluid.value(K, dict), 0};
    if (dict.readIfPresent("gamma", s.derivative))
    {
        return s;
    }
    if (fluid.isConstant())
    {
        refuse
        (
            dict,
            text("No entry gamma, and none is known of ", fluid.name(), ", a set of constants"),
            "gamma, the derivative dK/dp of the bulk modulus."
        );
    }
    return orRefuse
    (
        dict,
        "stiffness",
        [&]
        {
            return
                realStiffness
                (
                    *directFluid(fluid.x(), fluid.ph()),
                    fluid.T(),
                    fluid.p(),
                    along
                );
        }
    );
}


//- Not for stiffness given, whose coefficients are the law's own
stiffness readStiffness(const dictionary& dict, const reference& ref)
{
    const scalar gamma = dict.lookupOrDefault<scalar>("gamma", defaultGamma);
    switch (ref.type)
    {
        case stiffnessType::waveTank:
        {
            const scalar g = dict.get<scalar>("g");
            const scalar H = dict.get<scalar>("H");
            return orRefuse
            (
                dict,
                "rho0, g, H or gamma",
                [&]{ return waveTankStiffness(ref.rho0, g, H, gamma); }
            );
        }
        case stiffnessType::MachNumber:
        {
            const scalar U = dict.get<scalar>("U");
            const scalar Ma = dict.get<scalar>("Ma");
            return orRefuse
            (
                dict,
                "rho0, U, Ma or gamma",
                [&]{ return machNumberStiffness(ref.rho0, U, Ma, gamma); }
            );
        }
        default:
        {
            return readFluidStiffness(dict, ref.fluid());
        }
    }
}


//- The entries that stand beside those of fluidSelection
void checkEntries
(
    const dictionary& dict,
    const stiffnessType type,
    const wordHashSet& ofLaw
)
{
    wordHashSet known
    (
        fluidSelection::keywords | wordHashSet({"p0", "rho0", "stiffness"})
    );
    switch (type)
    {
        case stiffnessType::fluid:
            known |= wordHashSet({"along", "gamma"});
            break;
        case stiffnessType::waveTank:
            known |= wordHashSet({"g", "H", "gamma"});
            break;
        case stiffnessType::MachNumber:
            known |= wordHashSet({"U", "Ma", "gamma"});
            break;
        case stiffnessType::given:
            known |= ofLaw;
            break;
    }
    checkKeywords(dict, known);
}


template<class Law>
Law report(const Law& law, const reference& ref)
{
    Info<< Law::name() << "'s law, stiffness " << stiffnessTypeNames[ref.type]
        << ": ";
    writeLaw(Info, law);
    Info<< nl << "    Speed of sound at p0: " << law.soundSpeed(law.p0())
        << " m/s. Lowest pressure: " << law.lowestPressure() << " Pa" << nl;
    if (ref.fluid.valid())
    {
        Info<< "    Reference: ";
        ref.fluid->print(Info, {property::density, property::soundSpeed});
    }
    Info<< endl;
    return law;
}

//- The law, whose own coefficients have these names
template<class Law>
Law lawOf(const dictionary& dict, const word& first, const word& second)
{
    const reference ref(readReference(dict));
    checkEntries(dict, ref.type, {first, second});
    if (ref.type == stiffnessType::given)
    {
        const scalar a = dict.get<scalar>(first);
        const scalar b = dict.get<scalar>(second);
        return report
        (
            orRefuse
            (
                dict,
                ("p0, rho0, " + first + " or " + second).c_str(),
                [&]{ return Law(ref.p0, ref.rho0, a, b); }
            ),
            ref
        );
    }
    const stiffness s(readStiffness(dict, ref));
    return report
    (
        orRefuse
        (
            dict,
            "p0, rho0 or gamma",
            [&]{ return Law::of(ref.p0, ref.rho0, s); }
        ),
        ref
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

template<>
Foam::titan::MurnaghanLaw Foam::titan::readLaw(const dictionary& dict)
{
    return lawOf<MurnaghanLaw>(dict, "k0", "gamma");
}


template<>
Foam::titan::TaitLaw Foam::titan::readLaw(const dictionary& dict)
{
    return lawOf<TaitLaw>(dict, "B", "C");
}


void Foam::titan::writeLaw(Ostream& os, const MurnaghanLaw& law)
{
    os  << "p0 " << law.p0() << "; rho0 " << law.rho0()
        << "; stiffness given; k0 " << law.k0() << "; gamma " << law.gamma()
        << ';';
}


void Foam::titan::writeLaw(Ostream& os, const TaitLaw& law)
{
    os  << "p0 " << law.p0() << "; rho0 " << law.rho0()
        << "; stiffness given; B " << law.B() << "; C " << law.C() << ';';
}


void Foam::titan::refuseState(const thermoError& e)
{
    FatalErrorInFunction
        << "Equation of state of a liquid: " << e.what() << nl
        << "Expected: a liquid that is not in such tension. A solver's entry"
        << " pMin (in constant/thermophysicalProperties or system/fvSolution)"
        << " keeps the pressure above a floor; or choose a stiffer liquid."
        << exit(FatalError);
}

// ************************************************************************* //
