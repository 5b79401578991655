// SPDX-License-Identifier: GPL-3.0-or-later
#include "reducingFunctions.H"
#include "pureFluids.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using namespace Foam::titan;

//- What the pairs contribute per f_ij: twice gamma times the combination of the critical figures
struct pairFigures
{
    double T[nPairs];
    double volume[nPairs];

    pairFigures()
    {
        for (int k = 0; k < nPairs; ++k)
        {
            const binaryPair& ij = binaryPairOf(k);
            const pureFluid& a = pureFluidOf(ij.i);
            const pureFluid& b = pureFluidOf(ij.j);
            const double edge = 0.5*(1/std::cbrt(a.rhoc) + 1/std::cbrt(b.rhoc));
            T[k] = 2*ij.gammaT*ij.betaT*std::sqrt(a.Tc*b.Tc);
            volume[k] = 2*ij.gammaV*ij.betaV*edge*edge*edge;
        }
    }
};


//- Adds weight*f_ij to value and its derivatives in x_i and x_j to theirs
void addPair(double weight, double beta, double xi, double xj, double& value, double& dxi, double& dxj)
{
    const double beta2 = beta*beta;
    const double sum = xi + xj;
    const double over = 1/(beta2*xi + xj);
    const double f = weight*xi*xj*over;
    value += f*sum;
    dxi += weight*xj*sum*over + f*(1 - beta2*sum*over);
    dxj += weight*xi*sum*over + f*(1 - sum*over);
}


double dot(const composition::fractions& a, const composition::fractions& b)
{
    double sum = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        sum += a[i]*b[i];
    }
    return sum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::titan::reducingFunctions::reducingFunctions(const composition::fractions& x)
{
    static const pairFigures figures;

    for (int i = 0; i < nSpecies; ++i)
    {
        const pureFluid& fluid = pureFluidOf(i);
        T_ += x[i]*x[i]*fluid.Tc;
        volume_ += x[i]*x[i]/fluid.rhoc;
        dT_[i] = 2*x[i]*fluid.Tc;
        dVolume_[i] = 2*x[i]/fluid.rhoc;
    }
    for (int k = 0; k < nPairs; ++k)
    {
        const binaryPair& ij = binaryPairOf(k);
        if (x[ij.i] > 0 && x[ij.j] > 0)
        {
            addPair(figures.T[k], ij.betaT, x[ij.i], x[ij.j], T_, dT_[ij.i], dT_[ij.j]);
            addPair(figures.volume[k], ij.betaV, x[ij.i], x[ij.j], volume_, dVolume_[ij.i], dVolume_[ij.j]);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::titan::reducingFunctions::molarDlnT(int i, const composition::fractions& x) const
{
    return (dT_[i] - dot(x, dT_))/T_;
}


double Foam::titan::reducingFunctions::molarDlnDensity(int i, const composition::fractions& x) const
{
    return -(dVolume_[i] - dot(x, dVolume_))/volume_;
}
