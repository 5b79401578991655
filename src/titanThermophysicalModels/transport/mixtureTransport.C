// SPDX-License-Identifier: GPL-3.0-or-later
#include "mixtureTransport.H"
#include "pureFluids.H"

#include <algorithm>
#include <cmath>
#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using namespace Foam::titan;

//- Grunberg and Nissan's sum_i<j x_i x_j G_ij, see mixtureTransport.H
double excessViscosity(const composition& x)
{
    return
      - 0.37*x[N2]*x[CH4]
      - 1.30*x[N2]*x[C2H6]
      + (0.45 + 0.63*(x[CH4] - x[C2H6]))*x[CH4]*x[C2H6];
}


//- A pressure [Pa] that the vapour pressure does not reach: spares its computation where the liquid is well above it
double vapourPressureLimit(int i, double T)
{
    // Slopes of ln p over Tc/T that are less steep than the vapour pressure's anywhere below 125 K
    static const double slope[nSpecies] = {4.5, 5.3, 6.0, 6.6};

    const pureFluid& fluid = pureFluidOf(i);
    return fluid.pc*std::exp(slope[i]*(1 - fluid.Tc/T));
}


[[noreturn]] void refuse(thermoError::reason why, const char* name, double value, const char* expected)
{
    char buffer[256];
    std::snprintf(buffer, sizeof buffer, "%s is %.6g: expected %s", name, value, expected);
    throw thermoError(why, buffer);
}


void checkPositive(const char* name, double value)
{
    if (!std::isfinite(value))
    {
        refuse(thermoError::reason::notANumber, name, value, "a number");
    }
    if (value <= 0)
    {
        refuse(thermoError::reason::badEntry, name, value, "more than 0");
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Functions  * * * * * * * * * * * * * * * //

Foam::titan::mixtureTransport::component::component(species i, double T)
:
    fluid_(i, T),
    state_()
{}


void Foam::titan::mixtureTransport::component::setLiquid(double p)
{
    const double pSaturated = p < vapourPressureLimit(fluid_.fluid(), fluid_.T()) ? fluid_.saturated().p : 0;
    tension_ = std::min(p - pSaturated, 0.0);
    p = std::max(p, pSaturated);
    if (p != state_.p)
    {
        setState(fluid_.isotherm().state(p, phase::liquid, state_.molarDensity));
    }
}


void Foam::titan::mixtureTransport::component::setGas(double molarDensity)
{
    if (molarDensity != state_.molarDensity)
    {
        setState(fluid_.isotherm().stateAtDensity(molarDensity));
    }
}


void Foam::titan::mixtureTransport::component::setState(const fluidState& s)
{
    state_ = s;
    viscosity_ = 0;
    conductivity_ = 0;
}


template<class Property>
double Foam::titan::mixtureTransport::component::extended(double& value, double& slope, const Property& of)
{
    // Over this step the logarithms are straight to 1e-4 of their change
    constexpr double step = 1e5;

    if (value == 0)
    {
        value = of(state_);
    }
    if (tension_ == 0)
    {
        return value;
    }
    if (slope == 0)
    {
        const fluidState above = fluid_.isotherm().state(state_.p + step, phase::liquid, state_.molarDensity);
        slope = std::log(of(above)/value)/step;
    }
    return value*std::exp(slope*tension_);
}


double Foam::titan::mixtureTransport::component::viscosity()
{
    return extended(viscosity_, viscositySlope_, [this](const fluidState& s){return fluid_.viscosity(s);});
}


double Foam::titan::mixtureTransport::component::conductivity()
{
    return extended(conductivity_, conductivitySlope_, [this](const fluidState& s){return fluid_.conductivity(s);});
}


void Foam::titan::mixtureTransport::setState(const fluidState& s) const
{
    range::checkTemperature(s.T);
    checkPositive("pressure p", s.p);
    checkPositive("molar density", s.molarDensity);
    if (s.T != T_)
    {
        T_ = s.T;
        surfaceTension_ = -1;
        for (auto& c : components_)
        {
            c.reset();
        }
    }
}


Foam::titan::mixtureTransport::component& Foam::titan::mixtureTransport::at(int i) const
{
    if (!components_[i])
    {
        components_[i].reset(new component(species(i), T_));
    }
    return *components_[i];
}


Foam::titan::mixtureTransport::component& Foam::titan::mixtureTransport::liquid(int i, double p) const
{
    component& c = at(i);
    c.setLiquid(p);
    return c;
}


Foam::titan::mixtureTransport::component&
Foam::titan::mixtureTransport::gas(int i, double molarDensity) const
{
    component& c = at(i);
    c.setGas(std::min(x()[i]*molarDensity, c.fluid().saturated().vapourDensity));
    return c;
}


void Foam::titan::mixtureTransport::wilke(double molarDensity, values& viscosities, values& sums) const
{
    for (int i = 0; i < nSpecies; ++i)
    {
        viscosities[i] = x()[i] > 0 ? gas(i, molarDensity).viscosity() : 0;
    }
    sums.fill(0);
    for (int i = 0; i < nSpecies; ++i)
    {
        for (int j = 0; j < nSpecies; ++j)
        {
            if (x()[i] > 0 && x()[j] > 0)
            {
                const double M = titan::molarMass(i)/titan::molarMass(j);
                const double root = 1 + std::sqrt(viscosities[i]/viscosities[j]/std::sqrt(M));
                sums[i] += x()[j]*root*root/std::sqrt(8*(1 + M));
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::titan::mixtureTransport::mixtureTransport(const composition& x, phase ph)
:
    mixture_(x),
    phase_(ph),
    excess_(excessViscosity(x)),
    T_(0),
    surfaceTension_(-1)
{
    double volume = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        volumeFractions_[i] = x[i]/pureFluidOf(i).rhoc;
        volume += volumeFractions_[i];
    }
    for (double& phi : volumeFractions_)
    {
        phi /= volume;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::titan::mixtureTransport::viscosity(const fluidState& s) const
{
    setState(s);
    if (phase_ == phase::gas)
    {
        values viscosities, sums;
        wilke(s.molarDensity, viscosities, sums);
        double mu = 0;
        for (int i = 0; i < nSpecies; ++i)
        {
            if (x()[i] > 0)
            {
                mu += x()[i]*viscosities[i]/sums[i];
            }
        }
        return mu;
    }

    double lnMu = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        if (x()[i] > 0)
        {
            lnMu += x()[i]*std::log(liquid(i, s.p).viscosity());
        }
    }
    return std::exp(lnMu + excess_);
}


double Foam::titan::mixtureTransport::conductivity(const fluidState& s) const
{
    setState(s);
    double k = 0;
    if (phase_ == phase::gas)
    {
        values viscosities, sums;
        wilke(s.molarDensity, viscosities, sums);
        for (int i = 0; i < nSpecies; ++i)
        {
            if (x()[i] > 0)
            {
                k += x()[i]*gas(i, s.molarDensity).conductivity()/sums[i];
            }
        }
        return k;
    }

    values resistances;
    for (int i = 0; i < nSpecies; ++i)
    {
        resistances[i] = x()[i] > 0 ? 1/liquid(i, s.p).conductivity() : 0;
    }
    for (int i = 0; i < nSpecies; ++i)
    {
        for (int j = 0; j < nSpecies; ++j)
        {
            if (x()[i] > 0 && x()[j] > 0)
            {
                k += volumeFractions_[i]*volumeFractions_[j]*2/(resistances[i] + resistances[j]);
            }
        }
    }
    return k;
}


double Foam::titan::mixtureTransport::surfaceTension(const fluidState& s) const
{
    if (phase_ == phase::gas)
    {
        throw thermoError(thermoError::reason::badEntry, "surface tension is asked of a gas: expected a liquid");
    }
    setState(s);
    if (surfaceTension_ < 0)
    {
        double p = 0;
        for (int i = 0; i < nSpecies; ++i)
        {
            if (x()[i] > 0)
            {
                p += x()[i]*at(i).fluid().saturated().p;
            }
        }
        const double rho = helmholtzMixture::isotherm(mixture_, T_).molarDensity(p, phase::liquid);

        double root = 0;
        for (int i = 0; i < nSpecies; ++i)
        {
            if (x()[i] > 0)
            {
                const saturation& pure = at(i).fluid().saturated();
                const double parachor =
                    std::sqrt(std::sqrt(pureSurfaceTension(species(i), T_)))
                   /(pure.liquidDensity - pure.vapourDensity);
                root += x()[i]*parachor*(rho - pure.vapourDensity);
            }
        }
        surfaceTension_ = root*root*root*root;
    }
    return surfaceTension_;
}
