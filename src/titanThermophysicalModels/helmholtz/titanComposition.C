// SPDX-License-Identifier: GPL-3.0-or-later
#include "titanComposition.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using namespace Foam::titan;

// Of the reference equations of state, [kg/mol]
const double molarMasses[nSpecies] = {0.02801348, 0.0160428, 0.03006904, 0.04409562};

const char* const shortNames[nSpecies] = {"N2", "CH4", "C2H6", "C3H8"};
const char* const longNames[nSpecies] = {"nitrogen", "methane", "ethane", "propane"};


//- The fractions, checked and normalised
composition::fractions checked(composition::fractions x)
{
    constexpr double tolerance = 1e-3;

    double sum = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        if (!std::isfinite(x[i]))
        {
            throw thermoError
            (
                thermoError::reason::notANumber,
                std::string("mole fraction of ") + shortNames[i] + " is not a number"
            );
        }
        if (x[i] < 0)
        {
            throw thermoError
            (
                thermoError::reason::composition,
                std::string("mole fraction of ") + shortNames[i] + " is " + formatted("%.6g", x[i])
              + ": expected 0 or more"
            );
        }
        sum += x[i];
    }
    // The sum of decimal figures misses the limit by round-off
    if (std::abs(sum - 1) > tolerance*(1 + 1e-9))
    {
        throw thermoError
        (
            thermoError::reason::composition,
            "mole fractions add up to " + formatted("%.6g", sum) + ": expected 1 within 0.001"
        );
    }
    for (double& xi : x)
    {
        xi /= sum;
    }
    return x;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const char* Foam::titan::speciesName(int i)
{
    return shortNames[i];
}


const char* Foam::titan::speciesLongName(int i)
{
    return longNames[i];
}


double Foam::titan::molarMass(int i)
{
    return molarMasses[i];
}


const char* Foam::titan::phaseName(phase ph)
{
    return ph == phase::liquid ? "liquid" : "gas";
}


Foam::titan::phase Foam::titan::phaseNamed(const std::string& name)
{
    if (name == "liquid")
    {
        return phase::liquid;
    }
    if (name == "gas")
    {
        return phase::gas;
    }
    throw thermoError
    (
        thermoError::reason::unknownName,
        "phase is '" + name + "': expected liquid or gas"
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::titan::composition::composition(double xN2, double xCH4, double xC2H6, double xC3H8)
:
    composition(fractions{{xN2, xCH4, xC2H6, xC3H8}})
{}


Foam::titan::composition::composition(const fractions& x)
:
    x_(checked(x))
{}


Foam::titan::composition Foam::titan::composition::pure(species i)
{
    fractions x{{0, 0, 0, 0}};
    x[i] = 1;
    return composition(x);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::titan::composition::molarMass() const
{
    double M = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        M += x_[i]*molarMasses[i];
    }
    return M;
}


bool Foam::titan::composition::isPure() const
{
    int present = 0;
    for (const double xi : x_)
    {
        present += xi > 0;
    }
    return present == 1;
}


std::string Foam::titan::composition::name() const
{
    std::string result;
    for (int i = 0; i < nSpecies; ++i)
    {
        if (x_[i] > 0)
        {
            result += (result.empty() ? "" : ", ") + formatted("%.6g", x_[i]) + " " + shortNames[i];
        }
    }
    return result;
}
