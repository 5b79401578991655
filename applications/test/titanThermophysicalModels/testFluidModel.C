// SPDX-License-Identifier: GPL-3.0-or-later
// One fluid at three speeds.

#include <gtest/gtest.h>

#include "fluidModel.H"
#include "refusals.H"

#include <cmath>
#include <random>

using namespace Foam::titan;
typedef thermoError::reason reason;

namespace
{

const composition lake(0.05, 0.25, 0.65, 0.05);
const tableLimits limits{90, 100, 1e5, 5e6, 1e-6};

const property all[] =
{
    property::density, property::soundSpeed, property::cp, property::cv, property::viscosity, property::conductivity,
    property::surfaceTension, property::isothermalBulkModulus, property::isentropicBulkModulus, property::expansivity
};

} // End anonymous namespace


TEST(FluidModel, directAgreesWithTheEquationOfState)
{
    const std::unique_ptr<fluidModel> direct = directFluid(lake, phase::liquid);
    const fluidState s = helmholtzMixture(lake).state(94, 1.467e5, phase::liquid);
    EXPECT_STREQ(direct->type(), "direct");
    EXPECT_DOUBLE_EQ(direct->value(property::density, 94, 1.467e5), s.density);
    EXPECT_DOUBLE_EQ(direct->value(property::soundSpeed, 94, 1.467e5), s.soundSpeed);

    // A field, in any order of temperatures, gives what single states give
    const double T[] = {94, 94, 91, 99, 94};
    const double p[] = {1.467e5, 2e6, 1e5, 1e5, 1.467e5};
    const fluidProperties single = direct->properties(T[1], p[1]);
    for (const property q : all)
    {
        double values[5];
        direct->evaluate(q, 5, T, p, values);
        EXPECT_NEAR(values[1]/single[q], 1, 1e-12) << propertyName(q);
        EXPECT_NEAR(values[0]/values[4], 1, 1e-12) << propertyName(q);
        EXPECT_NEAR(values[3]/direct->value(q, 99, 1e5), 1, 1e-12) << propertyName(q);
    }
}


TEST(FluidModel, everyPropertyHasAnUncertainty)
{
    const fluidProperties liquid = directFluid(lake, phase::liquid)->properties(94, 1.467e5);
    const fluidProperties gas = directFluid(composition(0.95, 0.05, 0), phase::gas)->properties(94, 1.467e5);
    for (const property q : all)
    {
        EXPECT_GT(liquid.uncertainty(q), 0) << propertyName(q);
        EXPECT_LT(liquid.uncertainty(q), 0.5) << propertyName(q);
        if (q != property::surfaceTension)
        {
            EXPECT_GT(gas.uncertainty(q), 0) << propertyName(q);
        }
    }
    EXPECT_TRUE(std::isnan(gas[property::surfaceTension]));
}


TEST(FluidModel, tableKeepsItsErrorBound)
{
    const std::unique_ptr<fluidModel> direct = directFluid(lake, phase::liquid);
    const std::unique_ptr<fluidModel> table =
        tabulatedFluid(lake, phase::liquid, limits, std::vector<property>(std::begin(all), std::end(all)));

    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    double worst = 0;
    for (int k = 0; k < 20000; ++k)
    {
        const double T = limits.Tmin + uniform(generator)*(limits.Tmax - limits.Tmin);
        const double p = limits.pMin + uniform(generator)*(limits.pMax - limits.pMin);
        const property q = all[k % nProperties];
        const double error = std::abs(table->value(q, T, p)/direct->value(q, T, p) - 1);
        EXPECT_LE(error, limits.relativeError) << propertyName(q) << " at " << T << " " << p;
        worst = std::max(worst, error);
    }
    // It is a table
    EXPECT_GT(worst, 1e-3*limits.relativeError);

    // The corners belong to it
    for (const double T : {limits.Tmin, limits.Tmax})
    {
        for (const double p : {limits.pMin, limits.pMax})
        {
            EXPECT_NEAR(table->value(property::density, T, p)/direct->value(property::density, T, p), 1, 1e-6);
        }
    }
}


TEST(FluidModel, tableOfAGas)
{
    const composition air(0.943, 0.057, 0);
    const tableLimits gasLimits{90, 100, 1e4, 2e5, 1e-5};
    const std::unique_ptr<fluidModel> direct = directFluid(air, phase::gas);
    const std::unique_ptr<fluidModel> table =
        tabulatedFluid(air, phase::gas, gasLimits, {property::density, property::viscosity});
    for (const double p : {1.01e4, 3.3e4, 1.467e5})
    {
        EXPECT_NEAR(table->value(property::density, 93.3, p)/direct->value(property::density, 93.3, p), 1, 1e-5);
    }
    expectRefusal
    (
        reason::badEntry, "no table of soundSpeed", [&]{table->value(property::soundSpeed, 94, 1e5);}
    );
}


TEST(FluidModel, tableRefusesWhatItDoesNotHold)
{
    const std::unique_ptr<fluidModel> table = tabulatedFluid(lake, phase::liquid, limits, {property::density});
    expectRefusal(reason::temperatureRange, "89.9", [&]{table->value(property::density, 89.9, 1e6);});
    expectRefusal(reason::pressureRange, "the table holds", [&]{table->value(property::density, 94, 6e6);});
    expectRefusal(reason::notANumber, "not a number", [&]{table->value(property::density, std::nan(""), 1e6);});

    auto make = [](const tableLimits& l)
    {
        tabulatedFluid(lake, phase::liquid, l, {property::density});
    };
    expectRefusal(reason::badEntry, "Tmin below Tmax", [&]{make({94, 94, 1e5, 1e6, 1e-6});});
    expectRefusal(reason::badEntry, "relative error", [&]{make({90, 94, 1e5, 1e6, 0});});
    expectRefusal(reason::temperatureRange, "300", [&]{make({90, 300, 1e5, 1e6, 1e-6});});

    // A liquid that is a gas in part of the table
    expectRefusal
    (
        reason::noSuchPhase, "no stable liquid",
        []{tabulatedFluid(composition::pure(N2), phase::liquid, {100, 124, 1e4, 5e6, 1e-6}, {property::density});}
    );
}


TEST(FluidModel, constantIsConstant)
{
    const fluidProperties values = directFluid(lake, phase::liquid)->properties(94, 1.467e5);
    const std::unique_ptr<fluidModel> constant = constantFluid(values);
    EXPECT_EQ(constant->value(property::viscosity, 94, 1.467e5), values[property::viscosity]);
    EXPECT_EQ(constant->value(property::viscosity, 1000, -5), values[property::viscosity]);
}
