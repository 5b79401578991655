// SPDX-License-Identifier: GPL-3.0-or-later
#include "phaseEquilibrium.H"
#include "pureFluids.H"

#include <algorithm>
#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using namespace Foam::titan;
typedef composition::fractions fractions;

constexpr int maxIterations = 200;

// Relative error of equilibrium pressures and fugacities
constexpr double tolerance = 1e-10;

// A second liquid is mostly nitrogen: below this share of nitrogen's own vapour pressure none can form
constexpr double splitPressureShare = 0.5;


[[noreturn]] void refuseEquilibrium(const std::string& message)
{
    throw thermoError(thermoError::reason::noEquilibrium, message);
}


//- x with its sum brought to one
composition normalised(fractions x)
{
    double sum = 0;
    for (const double xi : x)
    {
        sum += xi;
    }
    for (double& xi : x)
    {
        xi /= sum;
    }
    return composition(x);
}


//- Fugacities over the mole fractions of the vapour, x_i phi_i p [Pa], of a liquid at p [Pa]
class liquidFugacity
{
    const helmholtzMixture mixture_;
    const helmholtzMixture::isotherm isotherm_;
    double density_ = 0;


public:

    liquidFugacity(const composition& x, double T)
    :
        mixture_(x),
        isotherm_(mixture_, T)
    {}

    fractions operator()(double p)
    {
        density_ = isotherm_.molarDensity(p, phase::liquid, density_);
        fractions f = isotherm_.lnFugacityCoefficients(density_, p);
        for (int i = 0; i < nSpecies; ++i)
        {
            f[i] = mixture_.x()[i] > 0 ? mixture_.x()[i]*std::exp(f[i])*p : 0;
        }
        return f;
    }

    double density() const
    {
        return density_;
    }
};


//- Fugacity coefficients of a vapour
struct vapourState
{
    double density;
    fractions phi;

    vapourState(const composition& y, double T, double p)
    {
        const helmholtzMixture mixture(y);
        const helmholtzMixture::isotherm isotherm(mixture, T);
        density = isotherm.molarDensity(p, phase::gas);
        phi = isotherm.lnFugacityCoefficients(density, p);
        for (int i = 0; i < nSpecies; ++i)
        {
            phi[i] = y[i] > 0 ? std::exp(phi[i]) : 1;
        }
    }
};


double largestDifference(const composition& a, const composition& b)
{
    double largest = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}


//- Refuses a liquid that would split
void checkSplit(const composition& liquid, double T, double p)
{
    if (liquidStability(liquid, phase::liquid, T, p) < 0)
    {
        refuseEquilibrium
        (
            formatted("at %.6g K and %.6g Pa ", T, p) + liquid.name()
          + " splits into two liquids, one of them mostly nitrogen"
        );
    }
}


//- Least tangent-plane distance by successive substitution from trial amounts W in a phase
double tangentPlaneDistance
(
    const composition& x,
    const fractions& d,
    fractions W,
    phase trial,
    double T,
    double p
)
{
    constexpr double none = std::numeric_limits<double>::infinity();

    // Looser than an equilibrium: only the sign counts
    constexpr double converged = 1e-8;

    double density = 0;
    for (int k = 0; k < maxIterations; ++k)
    {
        const composition w = normalised(W);
        fractions lnPhi;
        try
        {
            const helmholtzMixture mixture(w);
            const helmholtzMixture::isotherm isotherm(mixture, T);
            density = isotherm.molarDensity(p, trial, density);
            lnPhi = isotherm.lnFugacityCoefficients(density, p);
        }
        catch (const thermoError&)
        {
            return none;
        }
        double change = 0;
        double distance = 0;
        double sum = 0;
        for (int i = 0; i < nSpecies; ++i)
        {
            if (x[i] > 0)
            {
                const double next = std::exp(d[i] - lnPhi[i]);
                change = std::max(change, std::abs(next - W[i]));
                W[i] = std::max(next, std::numeric_limits<double>::min());
                sum += W[i];
                distance = std::max(distance, std::abs(W[i] - x[i]));
            }
        }
        if (distance < 1e-4)
        {
            // Fallen back onto the state itself
            return none;
        }
        if (change < converged*sum)
        {
            return 1 - sum;
        }
    }
    return none;
}


//- ln(x_i phi_i) of a state
fractions lnActivities(const composition& x, phase ph, double T, double p)
{
    const helmholtzMixture mixture(x);
    const helmholtzMixture::isotherm isotherm(mixture, T);
    fractions d = isotherm.lnFugacityCoefficients(isotherm.molarDensity(p, ph), p);
    for (int i = 0; i < nSpecies; ++i)
    {
        d[i] = x[i] > 0 ? d[i] + std::log(x[i]) : 0;
    }
    return d;
}


//- Vapour pressure to a few percent [Pa]: where iterations start (Wilson's equation)
double startingPressure(int i, double T)
{
    const pureFluid& fluid = pureFluidOf(i);
    return fluid.pc*std::exp(5.373*(1 + fluid.acentricFactor)*(1 - fluid.Tc/T));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Pure Fluids  * * * * * * * * * * * * * * * * //

Foam::titan::saturation Foam::titan::pureSaturation(species i, double T)
{
    const helmholtzMixture mixture(composition::pure(i));
    const helmholtzMixture::isotherm isotherm(mixture, T);

    saturation s{startingPressure(i, T), 0, 0};
    for (int k = 0; k < maxIterations; ++k)
    {
        s.liquidDensity = isotherm.molarDensity(s.p, phase::liquid, s.liquidDensity);
        s.vapourDensity = isotherm.molarDensity(s.p, phase::gas);
        const double lnRatio =
            isotherm.lnFugacityCoefficients(s.liquidDensity, s.p)[i]
          - isotherm.lnFugacityCoefficients(s.vapourDensity, s.p)[i];

        // Newton's method in ln p: the slope is that of the volumes
        const double RT = mixture.gasConstant()*T;
        const double slope = s.p*(1/s.vapourDensity - 1/s.liquidDensity)/RT;
        const double step = lnRatio/slope;
        s.p *= std::exp(step);
        if (std::abs(step) < tolerance)
        {
            return s;
        }
    }
    refuseEquilibrium(formatted("no saturation pressure found at %.6g K for ", T) + speciesLongName(i));
}


// * * * * * * * * * * * * * * * * Mixtures  * * * * * * * * * * * * * * * * //

Foam::titan::equilibrium Foam::titan::bubblePoint(const composition& liquid, double T)
{
    range::checkTemperature(T);

    for (int i = 0; i < nSpecies; ++i)
    {
        if (liquid[i] == 1)
        {
            const saturation s = pureSaturation(species(i), T);
            return {T, s.p, liquid, liquid, s.liquidDensity, s.vapourDensity};
        }
    }

    liquidFugacity fugacity(liquid, T);
    auto sum = [](const fractions& f)
    {
        return f[N2] + f[CH4] + f[C2H6] + f[C3H8];
    };

    // Fugacities in the liquid hardly depend on p: with an ideal vapour they add up to p
    double p = 1e5;
    fractions f{};
    for (bool found = false; !found; )
    {
        try
        {
            f = fugacity(p);
            found = true;
        }
        catch (const thermoError&)
        {
            p *= 3;
            if (p > range::pMax)
            {
                throw;
            }
        }
    }
    p = sum(f);

    // Secant on ln(sum of the vapour's amounts) = 0 in ln p; the vapour follows
    composition y = normalised(f);
    double lnPOld = 0;
    double residualOld = 0;
    for (int k = 0; k < maxIterations; ++k)
    {
        double residual = 0;
        try
        {
            f = fugacity(p);
            const vapourState vapour(y, T, p);
            fractions amounts{};
            for (int i = 0; i < nSpecies; ++i)
            {
                amounts[i] = f[i]/(vapour.phi[i]*p);
            }
            const composition next = normalised(amounts);
            const double change = largestDifference(next, y);
            y = next;
            residual = std::log(sum(amounts));
            if (std::abs(residual) < tolerance && change < std::sqrt(tolerance))
            {
                if (p > splitPressureShare*startingPressure(N2, T))
                {
                    checkSplit(liquid, T, p);
                }
                return {T, p, liquid, y, fugacity.density(), vapour.density};
            }
        }
        catch (const thermoError& refused)
        {
            if (refused.why() != thermoError::reason::noSuchPhase)
            {
                throw;
            }
            // Beyond the last vapour, or below the last liquid: half way back
            if (k == 0)
            {
                p *= 0.7;
                continue;
            }
            p = std::exp(0.5*(std::log(p) + lnPOld));
            continue;
        }
        const double lnP = std::log(p);
        double slope = -1;
        if (residualOld != 0 && lnP != lnPOld)
        {
            slope = std::min(-0.2, std::max(-3.0, (residual - residualOld)/(lnP - lnPOld)));
        }
        lnPOld = lnP;
        residualOld = residual;
        p = std::exp(lnP - std::min(0.5, std::max(-0.5, residual/slope)));
    }
    refuseEquilibrium(formatted("no bubble pressure found at %.6g K for ", T) + liquid.name());
}


Foam::titan::equilibrium Foam::titan::saturateWithNitrogen
(
    double CH4Amount,
    double C2H6Amount,
    double C3H8Amount,
    double T,
    double p
)
{
    range::check(T, p);
    const double amounts[nSpecies] = {0, CH4Amount, C2H6Amount, C3H8Amount};
    double sum = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        if (!(amounts[i] >= 0) || !std::isfinite(amounts[i]))
        {
            throw thermoError
            (
                std::isfinite(amounts[i]) ? thermoError::reason::composition : thermoError::reason::notANumber,
                formatted("amount of ", 0) + speciesLongName(i) + formatted(" is %.6g: expected 0 or more", amounts[i])
            );
        }
        sum += amounts[i];
    }
    if (!(sum > 0))
    {
        throw thermoError
        (
            thermoError::reason::composition,
            "no methane, ethane or propane: expected a positive amount of one of them"
        );
    }

    auto liquidWith = [&](double nitrogen)
    {
        fractions x;
        x[N2] = nitrogen;
        for (int i = CH4; i < nSpecies; ++i)
        {
            x[i] = (1 - nitrogen)*amounts[i]/sum;
        }
        return composition(x);
    };

    // Mostly nitrogen, with a trace of all that is in the liquid
    constexpr double trace = 1e-6;
    composition y = normalised({{1, trace*amounts[CH4]/sum, trace*amounts[C2H6]/sum, trace*amounts[C3H8]/sum}});
    double vapourDensity = 0;
    double liquidDensity = 0;

    // Logarithm of nitrogen's fugacity in the liquid over that in the gas, which holds the alkanes that the liquid gives
    // it and is nitrogen else. Positive where the liquid holds more nitrogen than it can.
    auto excess = [&](double nitrogen)
    {
        liquidFugacity fugacity(liquidWith(nitrogen), T);
        const fractions f = fugacity(p);
        liquidDensity = fugacity.density();
        for (int k = 0; k < maxIterations; ++k)
        {
            const vapourState vapour(y, T, p);
            vapourDensity = vapour.density;
            fractions next{};
            next[N2] = 1;
            for (int i = CH4; i < nSpecies; ++i)
            {
                next[i] = f[i]/(vapour.phi[i]*p);
                next[N2] -= next[i];
            }
            if (!(next[N2] > 0))
            {
                refuseEquilibrium
                (
                    formatted("at %.6g K the alkanes alone boil at %.6g Pa: no nitrogen dissolves", T, p)
                );
            }
            const composition nextY = normalised(next);
            const double change = largestDifference(nextY, y);
            y = nextY;
            if (change < tolerance)
            {
                break;
            }
        }
        return std::log(f[N2]/(vapourState(y, T, p).phi[N2]*y[N2]*p));
    };

    // The first crossing from the dilute side, bracketed: any other is that of a second liquid
    double low = 1e-6;
    double excessLow;
    double high = 0.03;
    double excessHigh;
    try
    {
        excessLow = excess(low);
        for (excessHigh = excess(high); excessHigh < 0; excessHigh = excess(high))
        {
            if (high > 0.999)
            {
                refuseEquilibrium
                (
                    formatted("at %.6g K and %.6g Pa nitrogen dissolves without limit: it condenses itself", T, p)
                );
            }
            if (excessHigh < excessLow)
            {
                refuseEquilibrium
                (
                    formatted("at %.6g K and %.6g Pa the liquid splits in two before it is saturated with nitrogen", T, p)
                );
            }
            low = high;
            excessLow = excessHigh;
            high = std::min(1.5*high, 0.5*(1 + high));
        }

        // Regula falsi, Illinois' form
        for (int k = 0; k < maxIterations; ++k)
        {
            const double nitrogen = low - excessLow*(high - low)/(excessHigh - excessLow);
            const double value = excess(nitrogen);
            if (std::abs(value) < tolerance || high - low < tolerance*high)
            {
                const composition liquid = liquidWith(nitrogen);
                if (p > splitPressureShare*startingPressure(N2, T))
                {
                    checkSplit(liquid, T, p);
                }
                return {T, p, liquid, y, liquidDensity, vapourDensity};
            }
            if (value < 0)
            {
                low = nitrogen;
                excessLow = value;
                excessHigh *= 0.5;
            }
            else
            {
                high = nitrogen;
                excessHigh = value;
                excessLow *= 0.5;
            }
        }
    }
    catch (const thermoError& refused)
    {
        if (refused.why() == thermoError::reason::noSuchPhase)
        {
            refuseEquilibrium
            (
                formatted("at %.6g K and %.6g Pa there is no lake under nitrogen: ", T, p) + refused.what()
            );
        }
        throw;
    }
    refuseEquilibrium(formatted("no solubility of nitrogen found at %.6g K and %.6g Pa", T, p));
}


// * * * * * * * * * * * * * * * * Stability  * * * * * * * * * * * * * * * * //

double Foam::titan::vapourStability(const composition& x, phase ph, double T, double p)
{
    const fractions d = lnActivities(x, ph, T, p);
    fractions W{};
    for (int i = 0; i < nSpecies; ++i)
    {
        W[i] = x[i] > 0 ? std::max(std::exp(d[i]), std::numeric_limits<double>::min()) : 0;
    }
    return tangentPlaneDistance(x, d, W, phase::gas, T, p);
}


double Foam::titan::liquidStability(const composition& x, phase ph, double T, double p)
{
    const fractions d = lnActivities(x, ph, T, p);
    double least = std::numeric_limits<double>::infinity();
    auto tryFrom = [&](const fractions& W)
    {
        least = std::min(least, tangentPlaneDistance(x, d, W, phase::liquid, T, p));
    };

    if (ph == phase::gas)
    {
        // The liquid that Raoult's law would condense
        fractions W{};
        for (int i = 0; i < nSpecies; ++i)
        {
            W[i] = x[i]*p/startingPressure(i, T);
        }
        tryFrom(W);
    }
    if (x[N2] > 0 && x[N2] < 1)
    {
        // A liquid mostly of nitrogen, and one with little
        for (const double nitrogen : {0.97, 0.03})
        {
            fractions W{};
            for (int i = 0; i < nSpecies; ++i)
            {
                W[i] = i == N2 ? nitrogen : (1 - nitrogen)*x[i]/(1 - x[N2]);
            }
            tryFrom(W);
        }
    }
    return least;
}


double Foam::titan::liquidusTemperature(const composition& liquid, double p)
{
    // The eutectic of methane and ethane: Hofgartner and Lunine, Icarus 223 (2013) 628
    constexpr double eutecticT = 71.15;
    constexpr double eutecticMethane = 0.644;
    constexpr double R = 8.31446261815324;

    auto enthalpy = [](double x, double melting)
    {
        return -R*std::log(x)/(1/eutecticT - 1/melting);
    };

    struct solid
    {
        species i;
        double enthalpy;    // of melting [J/mol]
        double slope;       // of the melting curve [K/Pa]
    };

    // Melting curves: Setzmann and Wagner 1991, Buecker and Wagner 2006, Reeves et al. 1964; enthalpy of propane's
    // melting: Lide, CRC Handbook
    static const solid solids[] =
    {
        {CH4, enthalpy(eutecticMethane, pureFluidOf(CH4).Tt), 0.26e-6},
        {C2H6, enthalpy(1 - eutecticMethane, pureFluidOf(C2H6).Tt), 0.16e-6},
        {C3H8, 3500, 0.10e-6}
    };

    double highest = 0;
    for (const solid& s : solids)
    {
        if (liquid[s.i] > 0)
        {
            const double Tt = pureFluidOf(s.i).Tt;
            const double T = 1/(1/Tt - R*std::log(liquid[s.i])/s.enthalpy);
            highest = std::max(highest, T + s.slope*p);
        }
    }
    return highest;
}


std::vector<std::string> Foam::titan::stateWarnings(const composition& x, phase ph, double T, double p)
{
    // The composition of a table printed to four digits moves the bubble pressure by about this share
    constexpr double printed = 1e-3;

    // Nitrogen-saturated: within this share of the bubble pressure
    constexpr double saturated = 0.05;

    // Printed triple points are rounded
    constexpr double roundedT = 0.01;

    std::vector<std::string> warnings;

    if (ph == phase::gas)
    {
        if (liquidStability(x, ph, T, p) < -printed)
        {
            warnings.push_back("The gas is supersaturated: part of it would condense.");
        }
        return warnings;
    }

    const double excess = -vapourStability(x, ph, T, p);
    if (excess > printed && std::isfinite(excess))
    {
        std::string bubble;
        try
        {
            bubble = formatted(": its bubble pressure is %.5g Pa", bubblePoint(x, T).p);
        }
        catch (const thermoError&)
        {}
        warnings.push_back
        (
            std::string("The liquid is superheated") + bubble + "; it would "
          + (x[N2] > 0 ? "release nitrogen." : "boil.")
        );
    }
    const bool nearSaturation = x[N2] > 0 && std::isfinite(excess) && excess > -saturated;

    if (liquidStability(x, ph, T, p) < -printed)
    {
        warnings.push_back("The liquid would split into two liquids, one of them mostly nitrogen.");
    }
    const double liquidus = liquidusTemperature(x, p);
    if (T < liquidus - roundedT)
    {
        warnings.push_back(formatted("The liquid may freeze: it is below its liquidus, about %.1f K.", liquidus));
    }
    if (nearSaturation && T < 86)
    {
        warnings.push_back
        (
            "Below 86 K a lake saturated with nitrogen stratifies: the denser layer is the richer in nitrogen."
        );
    }
    const double alkanes = x[CH4] + x[C2H6] + x[C3H8];
    if (nearSaturation && x[CH4] > 0.4*alkanes && x[CH4] < 0.95*alkanes)
    {
        warnings.push_back
        (
            "Saturated with nitrogen at 40 to 95 % methane: bubbles of nitrogen come out where the liquid is warmed "
            "or its pressure falls."
        );
    }
    return warnings;
}
