// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluidModel.H"
#include "mixtureTransport.H"
#include "uncertainty.H"

#include <limits>

namespace
{

using namespace Foam::titan;

class directFluidModel
:
    public fluidModel
{
    const helmholtzMixture mixture_;
    const phase phase_;

    double transportValue(property q, const mixtureTransport& transport, const fluidState& s) const
    {
        switch (q)
        {
            case property::viscosity:
                return transport.viscosity(s);

            case property::conductivity:
                return transport.conductivity(s);

            default:
                return
                    phase_ == phase::liquid
                  ? transport.surfaceTension(s)
                  : std::numeric_limits<double>::quiet_NaN();
        }
    }

    static bool isTransport(property q)
    {
        return q == property::viscosity || q == property::conductivity || q == property::surfaceTension;
    }

    static double stateValue(property q, const fluidState& s)
    {
        switch (q)
        {
            case property::soundSpeed:
                return s.soundSpeed;

            case property::cp:
                return s.cp;

            case property::cv:
                return s.cv;

            case property::isothermalBulkModulus:
                return s.isothermalBulkModulus;

            case property::isentropicBulkModulus:
                return s.isentropicBulkModulus;

            case property::expansivity:
                return s.expansivity;

            default:
                return s.density;
        }
    }


public:

    directFluidModel(const composition& x, phase ph)
    :
        mixture_(x),
        phase_(ph)
    {}

    const char* type() const override
    {
        return "direct";
    }

    void evaluate(property q, std::size_t n, const double* T, const double* p, double* values) const override
    {
        // Neighbours are alike: an isotherm is kept as long as T stays, and each density starts the next
        const mixtureTransport transport(mixture_.x(), phase_);
        std::unique_ptr<helmholtzMixture::isotherm> isotherm;
        double density = 0;
        for (std::size_t i = 0; i < n; ++i)
        {
            range::check(T[i], p[i]);
            if (!isotherm || isotherm->T() != T[i])
            {
                isotherm.reset(new helmholtzMixture::isotherm(mixture_, T[i]));
            }
            if (q == property::density)
            {
                density = isotherm->molarDensity(p[i], phase_, density);
                values[i] = density*mixture_.molarMass();
                continue;
            }
            const fluidState s = isotherm->state(p[i], phase_, density);
            density = s.molarDensity;
            values[i] = isTransport(q) ? transportValue(q, transport, s) : stateValue(q, s);
        }
    }

    fluidProperties properties(double T, double p) const override
    {
        const fluidState s = mixture_.state(T, p, phase_);
        const mixtureTransport transport(mixture_.x(), phase_);

        fluidProperties result;
        result.T = T;
        result.p = p;
        for (int i = 0; i < nProperties; ++i)
        {
            const property q = static_cast<property>(i);
            result.values[i] = isTransport(q) ? transportValue(q, transport, s) : stateValue(q, s);
            result.uncertainties[i] = relativeUncertainty(q, mixture_.x(), phase_, T);
        }
        return result;
    }
};

} // End anonymous namespace


std::unique_ptr<Foam::titan::fluidModel> Foam::titan::directFluid(const composition& x, phase ph)
{
    return std::unique_ptr<fluidModel>(new directFluidModel(x, ph));
}
