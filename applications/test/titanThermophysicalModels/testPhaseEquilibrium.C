// SPDX-License-Identifier: GPL-3.0-or-later
// Vapour-liquid equilibrium of Titan's liquids, and the limits beyond which they are something else.

#include <gtest/gtest.h>

#include "phaseEquilibrium.H"
#include "refusals.H"

#include <algorithm>
#include <cmath>

using namespace Foam::titan;
typedef thermoError::reason reason;

namespace
{

bool warns(const std::vector<std::string>& warnings, const std::string& part)
{
    return std::any_of
    (
        warnings.begin(), warnings.end(),
        [&](const std::string& w){return w.find(part) != std::string::npos;}
    );
}

} // End anonymous namespace


// Vapour pressures as CoolProp 7.2.0 prints them (eight digits), with the same reference equations
TEST(PhaseEquilibrium, pureSaturation)
{
    EXPECT_NEAR(pureSaturation(N2, 80).p/136871.77, 1, 1e-7);
    EXPECT_NEAR(pureSaturation(N2, 105).p/1083309.6, 1, 1e-7);
    EXPECT_NEAR(pureSaturation(CH4, 95).p/19814.954, 1, 1e-7);
    EXPECT_NEAR(pureSaturation(C2H6, 115).p/167.9422, 1, 1e-6);
    EXPECT_NEAR(pureSaturation(C2H6, 90.368).p/1.142108, 1, 1e-6);
    EXPECT_NEAR(pureSaturation(N2, 80).liquidDensity*molarMass(N2)/793.93714, 1, 1e-7);
}


// Wherever it is found: equal fugacities, the fractions of the vapour add up to one
TEST(PhaseEquilibrium, bubblePointIsAnEquilibrium)
{
    for (const composition& x : {composition(0.05, 0.25, 0.70), composition(0.1, 0.6, 0.25, 0.05), composition(0, 0.5, 0.5)})
    {
        for (const double T : {90.0, 94.0, 110.0})
        {
            const equilibrium e = bubblePoint(x, T);
            const helmholtzMixture liquid(e.liquid), vapour(e.vapour);
            const helmholtzMixture::isotherm liquidT(liquid, T), vapourT(vapour, T);
            const composition::fractions l = liquidT.lnFugacityCoefficients(e.liquidDensity, e.p);
            const composition::fractions v = vapourT.lnFugacityCoefficients(e.vapourDensity, e.p);
            for (int i = 0; i < nSpecies; ++i)
            {
                if (x[i] > 0)
                {
                    EXPECT_NEAR(l[i] + std::log(x[i]), v[i] + std::log(e.vapour[i]), 1e-6)
                        << speciesName(i) << " of " << x.name() << " at " << T;
                }
            }
        }
    }
}


// GERG-2008's own bubble pressures of nitrogen-methane (AGA8, whose pure fluids are shorter equations) agree within
// 0.2 %; digitised measurements scatter by 1 to 2 % about them
TEST(PhaseEquilibrium, nitrogenMethane)
{
    const double rows[][4] =
    {
        // T [K], x_N2, measured and GERG's p [bar]
        {110, 0.209441, 4.78953, 4.8462},
        {110, 0.406551, 7.41977, 7.4293},
        {115, 0.501927, 11.0953, 11.0036},
        {120, 0.298459, 9.9488, 9.9485},
        {120, 0.788054, 19.8628, 19.4249}
    };
    for (const auto& r : rows)
    {
        const double p = bubblePoint(composition(r[1], 1 - r[1], 0), r[0]).p/1e5;
        EXPECT_NEAR(p/r[3], 1, 2e-3);
        EXPECT_NEAR(p/r[2], 1, 2.5e-2);
    }
}


// TITANPOOL (Steckloff et al. 2020), at the 147.0 kPa inferred from its densities: methane share, T, x_N2
TEST(PhaseEquilibrium, dissolvedNitrogen)
{
    const double rows[][3] =
    {
        {0, 90, 0.045354}, {0.25, 90, 0.056805}, {0.75, 90, 0.15409}, {1, 90, 0.24484}, {0, 94, 0.034949}, {1, 94, 0.15542}
    };
    for (const auto& r : rows)
    {
        const equilibrium e = saturateWithNitrogen(r[0], 1 - r[0], 0, r[1], 147000);
        EXPECT_NEAR(e.liquid[N2], r[2], 2e-4) << r[0] << " " << r[1];
        EXPECT_NEAR(bubblePoint(e.liquid, r[1]).p/147000, 1, 1e-6);
    }
    // Any amounts in the same ratio
    EXPECT_NEAR
    (
        saturateWithNitrogen(3, 9, 0, 94, 1.467e5).liquid[N2], saturateWithNitrogen(0.25, 0.75, 0, 94, 1.467e5).liquid[N2],
        1e-9
    );
}


TEST(PhaseEquilibrium, illPosedIsRefused)
{
    const double nan = std::nan("");
    expectRefusal(reason::composition, "no methane", []{saturateWithNitrogen(0, 0, 0, 94, 1.467e5);});
    expectRefusal(reason::composition, "amount of ethane", []{saturateWithNitrogen(1, -1, 0, 94, 1.467e5);});
    expectRefusal(reason::notANumber, "propane", [=]{saturateWithNitrogen(1, 1, nan, 94, 1.467e5);});
    expectRefusal(reason::temperatureRange, "200 K", []{saturateWithNitrogen(1, 1, 0, 200, 1.467e5);});

    // Methane boils at 115 K under 1.3 bar; nitrogen condenses at 75 K under 1.467 bar
    expectRefusal(reason::noEquilibrium, "boil", []{saturateWithNitrogen(1, 0, 0, 118, 1.467e5);});
    expectRefusal(reason::noEquilibrium, "", []{saturateWithNitrogen(0.5, 0.5, 0, 75, 1.467e5);});

    // Nitrogen and ethane split in two liquids well below nitrogen's vapour pressure
    expectRefusal(reason::noEquilibrium, "splits", []{saturateWithNitrogen(0, 1, 0, 94, 4.8e5);});
    expectRefusal(reason::noEquilibrium, "splits", []{bubblePoint(composition(0.5, 0.01, 0.49), 92);});
}


TEST(PhaseEquilibrium, warnings)
{
    const composition kraken = saturateWithNitrogen(0.3, 0.7, 0, 93, 1.467e5).liquid;
    EXPECT_TRUE(stateWarnings(kraken, phase::liquid, 93, 1.467e5).empty());
    EXPECT_TRUE(warns(stateWarnings(kraken, phase::liquid, 96, 1.467e5), "superheated"));
    EXPECT_TRUE(warns(stateWarnings(composition::pure(CH4), phase::liquid, 94, 1.7e4), "it would boil"));
    EXPECT_TRUE(stateWarnings(composition::pure(CH4), phase::liquid, 94, 1.8e4).empty());
    EXPECT_TRUE(warns(stateWarnings(composition(0.5, 0.01, 0.49), phase::liquid, 92, 1e6), "two liquids"));
    EXPECT_TRUE(warns(stateWarnings(composition::pure(C2H6), phase::liquid, 89, 1.5e5), "freeze"));
    EXPECT_TRUE(warns(stateWarnings(composition::pure(CH4), phase::liquid, 90, 1.5e5), "freeze"));

    const composition cold = saturateWithNitrogen(0.6, 0.4, 0, 84, 1.467e5).liquid;
    EXPECT_TRUE(warns(stateWarnings(cold, phase::liquid, 84, 1.467e5), "stratifies"));
    EXPECT_TRUE(warns(stateWarnings(cold, phase::liquid, 84, 1.467e5), "bubbles"));
    EXPECT_FALSE(warns(stateWarnings(kraken, phase::liquid, 93, 1.467e5), "bubbles"));

    EXPECT_TRUE(stateWarnings(composition(0.943, 0.057, 0), phase::gas, 94, 1.467e5).empty());
    EXPECT_TRUE(warns(stateWarnings(composition(0.8, 0.2, 0), phase::gas, 94, 1.467e5), "condense"));
}


// Triple points of the pure fluids and the eutectic of methane and ethane, with what a bar moves them
TEST(PhaseEquilibrium, liquidus)
{
    EXPECT_NEAR(liquidusTemperature(composition::pure(CH4), 1e4), 90.694, 0.01);
    EXPECT_NEAR(liquidusTemperature(composition::pure(C2H6), 1), 90.368, 0.01);
    EXPECT_NEAR(liquidusTemperature(composition(0, 0.644, 0.356), 1e4), 71.15, 0.01);
    EXPECT_LT(liquidusTemperature(composition(0.1, 0.6, 0.3), 1e5), liquidusTemperature(composition(0, 2.0/3, 1.0/3), 1e5) + 5);
}
