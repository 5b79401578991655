// SPDX-License-Identifier: GPL-3.0-or-later
#include "namedFluid.H"
#include "phaseEquilibrium.H"

#include <cstdio>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using namespace Foam::titan;

const double none = std::numeric_limits<double>::quiet_NaN();

const double surfacePressure = 1.467e5;

const char* const surfacePressureSource =
    "p: 1467 +- 1 hPa at the landing site of Huygens (Fulchignoni et al., Nature 438 (2005) 785); 100 m lower it is"
    " 7 hPa more";


//- In three digits
std::string percent(double fraction)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %%", 100*fraction);
    return text;
}


//- What has been published of a lake
struct lakeFigures
{
    const char* name;
    const char* description;

    //- Mole fractions as published
    double CH4, C2H6, N2;

    double T;

    const char* compositionSource;
    const char* temperatureSource;
};

const char* const radarUncertainty =
    "The radar measures the loss tangent, with a standard error of 20-40 % (Poggiali et al., Nat. Commun. 15 (2024)"
    " 5454); no uncertainty of the composition is published";

//- Stands for @ in the sources below
const char* const secondHand =
    "the figures are as other authors quote them (Cornell-MIT/PlanetWaves); the paper itself was not at hand";

const lakeFigures krakenFigures =
{
    "Kraken",
    "Kraken Mare, of the liquid of its bay Moray Sinus",
    0.70, 0.14, 0.16,
    92,
    "Poggiali et al., J. Geophys. Res. Planets 125 (2020) e2020JE006558: 70 % methane, 16 % nitrogen, 14 % ethane fit"
    " the radar absorption of Moray Sinus; the main body, where no echo of the floor was found, may hold more ethane",
    "between 91.5 +- 0.2 K at the north pole and 93.65 +- 0.15 K at 16 N in 2014 (Jennings et al., Astrophys. J. Lett."
    " 816 (2016) L17); the value at 68 N is an estimate, +- 1 K"
};

const lakeFigures ligeiaFigures =
{
    "Ligeia",
    "Ligeia Mare",
    0.71, 0.12, 0.17,
    92,
    "Mastrogiuseppe et al., IEEE Trans. Geosci. Remote Sens. 54 (2016) 5646: 71:12:17 methane:ethane:nitrogen (also"
    " quoted as 69:14:17); @; Le Gall et al., J. Geophys. Res. Planets 121 (2016) 233, find mostly methane too",
    "92 +- 0.5 K at 80 N (Zebker et al., Geophys. Res. Lett. 41 (2014) 308)"
};

const lakeFigures pungaFigures =
{
    "Punga",
    "Punga Mare",
    0.80, 0, 0.20,
    91.5,
    "Mastrogiuseppe et al., Earth Planet. Sci. Lett. 496 (2018) 89: 80:0:20 methane:ethane:nitrogen; @",
    "91.5 +- 0.2 K at the north pole in 2014 (Jennings et al., Astrophys. J. Lett. 816 (2016) L17)"
};

const lakeFigures ontarioFigures =
{
    "Ontario",
    "Ontario Lacus",
    0.51, 0.38, 0.11,
    91,
    "Mastrogiuseppe et al., Icarus 300 (2018) 203: 51:38:11 methane:ethane:nitrogen (also quoted as 47:40:13); @",
    "near 91 K at the poles at the equinox of 2009, the radar having sounded the lake in December 2008 (Jennings et"
    " al., Astrophys. J. Lett. 737 (2011) L15); 72 S may be up to 1 K warmer"
};


std::string sourceOf(const lakeFigures& lake, const composition& x)
{
    std::string compositionSource = lake.compositionSource;
    const std::size_t place = compositionSource.find('@');
    if (place != std::string::npos)
    {
        compositionSource.replace(place, 1, secondHand);
    }
    return
        "Composition: " + compositionSource + ". Taken as mole fractions, of which the ratio of the alkanes is used:"
        " in equilibrium with the atmosphere they dissolve " + percent(x[N2]) + " nitrogen, against "
      + percent(lake.N2) + " published. " + radarUncertainty + ". T: " + lake.temperatureSource + ". "
      + surfacePressureSource;
}


namedFluid lake(const lakeFigures& figures)
{
    namedFluid fluid = namedFluid::saturatedLake(figures.CH4, figures.C2H6, 0, figures.T, surfacePressure);
    fluid.name = figures.name;
    fluid.description = std::string(figures.description) + ", saturated with nitrogen";
    fluid.source = sourceOf(figures, fluid.x);
    return fluid;
}


namedFluid titanAir()
{
    const composition x(1 - 0.0565, 0.0565, 0);
    const double T = 93.65;
    return
    {
        "titanAir",
        "Titan's atmosphere at the surface",
        "Methane: 5.65 % near the surface (Niemann et al., J. Geophys. Res. 115 (2010) E12006); the rest is taken as"
        " nitrogen (0.1 % hydrogen left out). T: 93.65 +- 0.25 K, and " + std::string(surfacePressureSource),
        phase::gas,
        T,
        surfacePressure,
        false,
        x,
        directFluid(x, phase::gas)->properties(T, surfacePressure)
    };
}


//- Values and uncertainties in the order of property
namedFluid constants
(
    const char* name,
    const char* description,
    const std::string& source,
    phase ph,
    double T,
    double p,
    const std::array<double, nProperties>& values,
    const std::array<double, nProperties>& uncertainties
)
{
    return
    {
        name, description, source, ph, T, p, true, composition::pure(N2), {T, p, values, uncertainties}
    };
}


namedFluid astraeusPaper()
{
    std::array<double, nProperties> unknown;
    unknown.fill(none);
    std::array<double, nProperties> values = unknown;
    values[static_cast<int>(property::density)] = 664;
    values[static_cast<int>(property::viscosity)] = 1014e-6;
    return constants
    (
        "astraeusPaper",
        "Constants of Kraken Mare in IAC-20-E2.1.9",
        "IAC-20-E2.1.9, section 4.1, which refers to Hartwig et al. and gives density and viscosity alone. T and p are"
        " assumed: the paper names neither",
        phase::liquid,
        94,
        surfacePressure,
        values,
        unknown
    );
}


namedFluid water()
{
    return constants
    (
        "water",
        "Water at 20 C and 1 atm",
        "IAPWS: density, sound speed, heat capacities and their derivatives R6-95, viscosity R12-08, conductivity"
        " R15-11, surface tension against its vapour R1-76; uncertainties are the releases'",
        phase::liquid,
        293.15,
        101325,
        {{998.207, 1482.3, 4184, 4157, 1.0016e-3, 0.5985, 0.07274, 2.179e9, 2.1934e9, 2.068e-4}},
        {{1e-6, 5e-5, 1e-3, 1e-3, 0.01, 0.015, 0.005, 1e-3, 1e-4, 1e-3}}
    );
}


namedFluid earthAir()
{
    return constants
    (
        "earthAir",
        "Dry air at 20 C and 1 atm",
        "Density, sound speed, heat capacities and their derivatives: Lemmon et al., J. Phys. Chem. Ref. Data 29 (2000)"
        " 331; viscosity and conductivity: Lemmon and Jacobsen, Int. J. Thermophys. 25 (2004) 21; uncertainties are"
        " the authors'",
        phase::gas,
        293.15,
        101325,
        {{1.2043, 343.38, 1006.4, 717.8, 18.206e-6, 0.02587, none, 1.01287e5, 1.4200e5, 3.421e-3}},
        {{1e-3, 2e-3, 0.01, 0.01, 0.05, 0.05, none, 2e-3, 4e-3, 0.01}}
    );
}


//- Names, and the fluids: each is computed when it is asked for first
struct catalogueEntry
{
    const char* name;
    const namedFluid& (*fluid)();
};

const catalogueEntry catalogue[] =
{
    {"Kraken", []() -> const namedFluid& { static const namedFluid f = lake(krakenFigures); return f; }},
    {"Ligeia", []() -> const namedFluid& { static const namedFluid f = lake(ligeiaFigures); return f; }},
    {"Punga", []() -> const namedFluid& { static const namedFluid f = lake(pungaFigures); return f; }},
    {"Ontario", []() -> const namedFluid& { static const namedFluid f = lake(ontarioFigures); return f; }},
    {"astraeusPaper", []() -> const namedFluid& { static const namedFluid f = astraeusPaper(); return f; }},
    {"titanAir", []() -> const namedFluid& { static const namedFluid f = titanAir(); return f; }},
    {"water", []() -> const namedFluid& { static const namedFluid f = water(); return f; }},
    {"earthAir", []() -> const namedFluid& { static const namedFluid f = earthAir(); return f; }}
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Members  * * * * * * * * * * * * * * * * //

Foam::titan::namedFluid Foam::titan::namedFluid::lookup(const std::string& name)
{
    std::string all;
    for (const catalogueEntry& entry : catalogue)
    {
        if (name == entry.name)
        {
            return entry.fluid();
        }
        all += std::string(all.empty() ? "" : ", ") + entry.name;
    }
    throw thermoError(thermoError::reason::unknownName, "fluid is '" + name + "', expected one of: " + all);
}


Foam::titan::namedFluid Foam::titan::namedFluid::saturatedLake
(
    double CH4,
    double C2H6,
    double C3H8,
    double T,
    double p
)
{
    const composition x = saturateWithNitrogen(CH4, C2H6, C3H8, T, p).liquid;
    return
    {
        "lake",
        "Alkanes saturated with nitrogen",
        "Composition, T and p as given",
        phase::liquid,
        T,
        p,
        false,
        x,
        directFluid(x, phase::liquid)->properties(T, p)
    };
}


std::vector<std::string> Foam::titan::namedFluid::names()
{
    std::vector<std::string> result;
    for (const catalogueEntry& entry : catalogue)
    {
        result.push_back(entry.name);
    }
    return result;
}


std::unique_ptr<Foam::titan::fluidModel> Foam::titan::namedFluid::model() const
{
    return isConstant ? constantFluid(properties) : directFluid(x, ph);
}
