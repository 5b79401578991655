// SPDX-License-Identifier: GPL-3.0-or-later
#include "uncertainty.H"
#include "pureFluids.H"

#include <algorithm>
#include <cmath>
#include <limits>

// The figures, in %, are those of uncertainty.H

namespace
{

using namespace Foam::titan;

//- Of the pure fluids, then of mixtures; liquid, then gas
struct figures
{
    double liquid[nSpecies + 1];
    double gas[nSpecies + 1];
};

const figures density = {{0.02, 0.03, 0.03, 0.03, 0.5}, {0.02, 0.03, 0.03, 0.03, 0.1}};
const figures soundSpeed = {{1, 0.3, 1, 1, 2}, {0.1, 0.1, 0.1, 0.1, 0.1}};
const figures heatCapacity = {{0.8, 1, 1, 0.5, 3}, {0.3, 1, 1, 0.5, 1}};
const figures expansivity = {{1, 1, 1, 1, 3}, {1, 1, 1, 1, 3}};
const figures conductivity = {{2, 3, 4, 4, 8}, {2, 3, 4, 4, 4}};
const figures surfaceTension = {{2, 2, 3, 3, 10}, {0, 0, 0, 0, 0}};
const figures gasViscosity = {{0, 0, 0, 0, 0}, {2, 1, 2, 2, 3}};


//- Index of the only fluid, or that of mixtures
int place(const composition& x)
{
    for (int i = 0; i < nSpecies; ++i)
    {
        if (x[i] == 1)
        {
            return i;
        }
    }
    return nSpecies;
}


double lookUp(const figures& f, const composition& x, phase ph)
{
    return (ph == phase::liquid ? f.liquid : f.gas)[place(x)];
}


double pureLiquidViscosity(int i, double T)
{
    if (T < pureFluidOf(i).Tt)
    {
        return i == C3H8 ? 25 : 10;
    }
    switch (i)
    {
        case C2H6: return T < 95 ? 6 : 4;
        case C3H8: return 5;
        default:   return 2;
    }
}


double liquidViscosity(const composition& x, double T)
{
    double mean = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        mean += x[i]*pureLiquidViscosity(i, T);
    }
    if (place(x) < nSpecies)
    {
        return mean;
    }
    return std::hypot(std::max(mean, 6.0), 100*x[C3H8]*(1 - x[C3H8]));
}

} // End anonymous namespace


double Foam::titan::relativeUncertainty(property q, const composition& x, phase ph, double T)
{
    range::checkTemperature(T);

    const double bulk = std::hypot(lookUp(density, x, ph), 2*lookUp(soundSpeed, x, ph));
    const double heat = lookUp(heatCapacity, x, ph);
    double percent = std::numeric_limits<double>::quiet_NaN();
    switch (q)
    {
        case property::density:
            percent = lookUp(density, x, ph);
            break;
        case property::soundSpeed:
            percent = lookUp(soundSpeed, x, ph);
            break;
        case property::cp:
            percent = heat;
            break;
        case property::cv:
        case property::isothermalBulkModulus:
            // cp - cv = T alpha^2 K_T/rho: about as certain as cp and the sound speed together
            percent = std::hypot(bulk, heat);
            break;
        case property::isentropicBulkModulus:
            percent = bulk;
            break;
        case property::expansivity:
            percent = lookUp(expansivity, x, ph);
            break;
        case property::viscosity:
            percent = ph == phase::liquid ? liquidViscosity(x, T) : lookUp(gasViscosity, x, ph);
            break;
        case property::conductivity:
            percent = lookUp(conductivity, x, ph);
            break;
        case property::surfaceTension:
            if (ph == phase::liquid)
            {
                percent = lookUp(surfaceTension, x, ph);
            }
            break;
    }
    return percent/100;
}
