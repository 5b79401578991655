// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluidModel.H"

#include <algorithm>

namespace
{

using namespace Foam::titan;

class constantFluidModel
:
    public fluidModel
{
    const fluidProperties values_;


public:

    explicit constantFluidModel(const fluidProperties& values)
    :
        values_(values)
    {}

    const char* type() const override
    {
        return "constant";
    }

    void evaluate(property q, std::size_t n, const double*, const double*, double* values) const override
    {
        std::fill_n(values, n, values_[q]);
    }

    fluidProperties properties(double, double) const override
    {
        return values_;
    }
};

} // End anonymous namespace


std::unique_ptr<Foam::titan::fluidModel> Foam::titan::constantFluid(const fluidProperties& values)
{
    return std::unique_ptr<fluidModel>(new constantFluidModel(values));
}
