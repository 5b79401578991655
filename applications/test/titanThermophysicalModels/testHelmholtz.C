// SPDX-License-Identifier: GPL-3.0-or-later
// Equation of state of N2, CH4, C2H6 and C3H8: against another implementation of the same formulation, against its own
// derivatives, and over the whole range of T, p and composition.

#include <gtest/gtest.h>

#include "helmholtzMixture.H"
#include "refusals.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace Foam::titan;
typedef thermoError::reason reason;

namespace
{

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

struct row
{
    composition::fractions x;
    phase ph;
    double T, p, density, soundSpeed, cp;
};

// CoolProp 7.2.0 (98b3523d), reference equations and Kunz-Wagner mixtures with the departure of ethane-propane off.
// Printed to eight digits; mole fractions of the mixtures to six.
const row coolProp[] =
{
    {{0, 0, 1, 0}, phase::liquid, 91, 150000, 650.88705, 2004.6559, 2321.2512},
    {{0, 0, 1, 0}, phase::liquid, 100, 150000, 641.00764, 1939.0282, 2282.5732},
    {{0, 0, 1, 0}, phase::liquid, 110, 1000000, 630.409, 1870.5463, 2271.931},
    {{0, 1, 0, 0}, phase::liquid, 91, 150000, 451.15904, 1536.7738, 3368.0357},
    {{0, 1, 0, 0}, phase::liquid, 100, 150000, 438.9736, 1452.9546, 3407.5222},
    {{0, 1, 0, 0}, phase::liquid, 100, 1000000, 439.6187, 1459.6285, 3401.0583},
    {{0, 0, 0, 1}, phase::liquid, 88, 150000, 730.59181, 2120.1037, 1917.7638},
    {{0, 0, 0, 1}, phase::liquid, 94, 150000, 724.37337, 2079.2733, 1923.5116},
    {{0, 0, 0, 1}, phase::liquid, 110, 150000, 707.99103, 1969.9049, 1942.9734},
    {{1, 0, 0, 0}, phase::liquid, 70, 38544.773, 838.51466, 925.73988, 2014.4904},
    {{1, 0, 0, 0}, phase::liquid, 92, 426159.18, 734.54057, 697.09018, 2166.3669},
    {{1, 0, 0, 0}, phase::liquid, 105, 1083309.6, 657.51637, 543.29819, 2478.9044},
    {{0, 1, 0, 0}, phase::liquid, 90.6941, 11696.064, 451.47511, 1538.6019, 3367.7935},
    {{0, 1, 0, 0}, phase::liquid, 100, 34375.892, 438.88524, 1452.0402, 3408.4181},
    {{0, 1, 0, 0}, phase::liquid, 115, 132214.23, 417.44798, 1304.5823, 3506.4366},
    {{0, 0, 1, 0}, phase::liquid, 90.368, 1.142108, 651.52948, 2008.6855, 2325.8148},
    {{0, 0, 1, 0}, phase::liquid, 95, 3.6267909, 646.43382, 1974.7761, 2299.0653},
    {{0, 0, 1, 0}, phase::liquid, 115, 167.9422, 624.47245, 1830.4139, 2275.056},
    {{1, 0, 0, 0}, phase::gas, 88, 150000, 6.0056146, 186.48227, 1119.2423},
    {{1, 0, 0, 0}, phase::gas, 92, 150000, 5.711387, 191.32563, 1106.7543},
    {{1, 0, 0, 0}, phase::gas, 110, 150000, 4.6993676, 211.23451, 1075.3496},
    {{0, 1, 0, 0}, phase::gas, 91, 12164.065, 0.25995908, 249.51199, 2110.9572},
    {{0, 1, 0, 0}, phase::gas, 94, 17613.28, 0.36530237, 253.19926, 2120.8695},
    {{0, 1, 0, 0}, phase::gas, 100, 34375.892, 0.67456737, 260.09215, 2145.8342},
    {{0.11252, 0.44374, 0.44374, 0}, phase::liquid, 88, 150000, 596.07343, 1703.7548, 2557.4953},
    {{0.08611, 0.685418, 0.228472, 0}, phase::liquid, 96, 150000, 530.46459, 1529.2534, 2806.889},
    {{0.02686, 0.97314, 0, 0}, phase::liquid, 110, 150000, 432.37141, 1323.2509, 3401.6759},
    {{0, 0.25, 0.75, 0}, phase::liquid, 91, 150000, 615.28764, 1954.5929, 2537.4444},
    {{0, 0.5, 0.5, 0}, phase::liquid, 94, 150000, 566.70709, 1793.93, 2701.3555},
    {{0, 0.75, 0.25, 0}, phase::liquid, 105, 150000, 498.2765, 1548.2993, 2965.9505},
    {{0.05, 0.1, 0.75, 0.1}, phase::liquid, 92, 1000000, 653.43267, 1938.1028, 2310.2906},
    {{0.03, 0.3, 0.47, 0.2}, phase::liquid, 95, 1000000, 630.1135, 1901.9774, 2378.736},
    {{0.03, 0.3, 0.47, 0.2}, phase::liquid, 110, 1000000, 612.45107, 1764.2611, 2333.6571},
    {{0.98, 0.02, 0, 0}, phase::gas, 90, 146700, 5.6771246, 189.54463, 1130.2699},
    {{0.98, 0.02, 0, 0}, phase::gas, 94, 146700, 5.4067622, 194.34091, 1117.4367},
    {{0.943, 0.057, 0, 0}, phase::gas, 95, 146700, 5.2667748, 196.60054, 1147.9243},
};

const composition lake(0.05, 0.25, 0.65, 0.05);
const composition air(0.943, 0.057, 0);


double densityAt(const composition& x, phase ph, double T, double p)
{
    return helmholtzMixture(x).state(T, p, ph).density;
}

} // End anonymous namespace


TEST(Helmholtz, agreesWithCoolProp)
{
    for (const row& r : coolProp)
    {
        const fluidState s = helmholtzMixture(composition(r.x)).state(r.T, r.p, r.ph);
        const std::string where = composition(r.x).name() + " at " + std::to_string(r.T) + " K";
        EXPECT_NEAR(s.density/r.density, 1, 1e-7) << where;
        EXPECT_NEAR(s.soundSpeed/r.soundSpeed, 1, 1e-7) << where;
        EXPECT_NEAR(s.cp/r.cp, 1, 1e-7) << where;
    }
}


// The publications' own tables, to the digits that they print
TEST(Helmholtz, agreesWithPublishedTables)
{
    struct
    {
        species i;
        double T, p, density, soundSpeed, cp, densityDigit, soundSpeedDigit, cpDigit;
    }
    const rows[] =
    {
        // Buecker and Wagner 2006, table 30
        {C2H6, 90.384, 1e5, 651.55, 2008.97, 2325.6, 0.01, 0.01, 0.1},
        {C2H6, 110, 1.5e6, 630.62, 1872.62, 2271.3, 0.01, 0.01, 0.1},
        // Setzmann and Wagner 1991
        {CH4, 110, 101325, 424.79, 1354.8, 3469.1, 0.01, 0.1, 0.1},
        // Span et al. 2000, which prints 26.615 mol/dm3
        {N2, 90, 5e5, 745.58, 720.8, 2137, 0.028, 0.1, 1}
    };
    for (const auto& r : rows)
    {
        const fluidState s = helmholtzMixture(composition::pure(r.i)).state(r.T, r.p, phase::liquid);
        EXPECT_NEAR(s.density, r.density, 0.51*r.densityDigit) << speciesName(r.i) << " at " << r.T;
        EXPECT_NEAR(s.soundSpeed, r.soundSpeed, 0.51*r.soundSpeedDigit) << speciesName(r.i) << " at " << r.T;
        EXPECT_NEAR(s.cp, r.cp, 0.51*r.cpDigit) << speciesName(r.i) << " at " << r.T;
    }
}


TEST(Helmholtz, derivativesAgreeWithDifferences)
{
    struct
    {
        composition x;
        phase ph;
        double T, p;
    }
    const states[] =
    {
        {lake, phase::liquid, 94, 1.467e5},
        {lake, phase::liquid, 110, 5e7},
        {air, phase::gas, 94, 1.467e5},
        {composition::pure(N2), phase::liquid, 117, 3e6},
        {composition::pure(C3H8), phase::liquid, 90, 1e6}
    };
    for (const auto& s : states)
    {
        const helmholtzMixture mixture(s.x);
        const fluidState state = mixture.state(s.T, s.p, s.ph);
        const helmholtzMixture::isotherm isotherm(mixture, s.T);

        // Central differences: of the order of 1e-8 of the value
        const double h = 1e-4*state.molarDensity;
        double above, below, slope;
        isotherm.pressure(state.molarDensity + h, above, slope);
        isotherm.pressure(state.molarDensity - h, below, slope);
        EXPECT_NEAR((above - below)/(2*h)*state.molarDensity/state.isothermalBulkModulus, 1, 1e-6);

        const double dT = 1e-3;
        const double rise = densityAt(s.x, s.ph, s.T + dT, s.p) - densityAt(s.x, s.ph, s.T - dT, s.p);
        EXPECT_NEAR(-rise/(2*dT)/state.density/state.expansivity, 1, 1e-6);

        // cp - cv = T v K_T expansivity^2, and c^2 = K_s/rho
        const double mayer =
            s.T*state.isothermalBulkModulus*state.expansivity*state.expansivity/state.density;
        EXPECT_NEAR((state.cp - state.cv)/mayer, 1, 1e-9);
        EXPECT_NEAR(state.soundSpeed*state.soundSpeed*state.density/state.isentropicBulkModulus, 1, 1e-12);

        // (d cv/d v)_T = T (d2p/dT2)_v
        const double step = 1e-3*state.molarDensity;
        const double cvAbove = mixture.stateAtDensity(s.T, state.molarDensity + step).cv*mixture.molarMass();
        const double cvBelow = mixture.stateAtDensity(s.T, state.molarDensity - step).cv*mixture.molarMass();
        const double dcvdv =
            (cvAbove - cvBelow)/(1/(state.molarDensity + step) - 1/(state.molarDensity - step));
        auto p = [&](double T)
        {
            double value, ignored;
            helmholtzMixture::isotherm(mixture, T).pressure(state.molarDensity, value, ignored);
            return value;
        };
        const double wide = 0.05;
        const double d2pdT2 = (p(s.T + wide) - 2*p(s.T) + p(s.T - wide))/(wide*wide);
        EXPECT_NEAR(dcvdv/(s.T*d2pdT2), 1, 5e-3);
    }
}


// n (d(n alphar)/d n_i) by differences of the Helmholtz energy at constant volume
TEST(Helmholtz, fugacityAgreesWithDifferences)
{
    const double T = 94;
    for (const double density : {21000.0, 190.0})
    {
        const helmholtzMixture mixture(lake);
        const helmholtzMixture::isotherm isotherm(mixture, T);
        double p, slope;
        isotherm.pressure(density, p, slope);
        if (!(p > 0))
        {
            p = 1e5;
        }
        const composition::fractions lnPhi = isotherm.lnFugacityCoefficients(density, p);
        const double lnZ = std::log(p/(density*mixture.gasConstant()*T));
        double mean = 0;
        for (int i = 0; i < nSpecies; ++i)
        {
            // n alphar at amounts n_i + h, in a volume that holds one mole at this density
            auto nAlphar = [&](double h)
            {
                composition::fractions x = lake.x();
                x[i] += h;
                const double n = 1 + h;
                for (double& xi : x)
                {
                    xi /= n;
                }
                const helmholtzMixture other{composition(x)};
                return n*helmholtzMixture::isotherm(other, T).evaluate(density*n).a;
            };
            const double h = 1e-5;
            const double slopeI = (nAlphar(h) - nAlphar(-h))/(2*h);
            EXPECT_NEAR(lnPhi[i], slopeI - lnZ, 1e-6*(1 + std::abs(slopeI))) << speciesName(i);
            mean += lake[i]*lnPhi[i];
        }
        // sum x_i ln phi_i = alphar + Z - 1 - ln Z
        const helmholtzMixture::isotherm::residual r = isotherm.evaluate(density);
        EXPECT_NEAR(mean, r.a + r.aD - lnZ, 1e-9);
    }
}


TEST(Helmholtz, traceOfAFluidIsContinuous)
{
    const fluidState pure = helmholtzMixture(composition::pure(C2H6)).state(94, 1.467e5, phase::liquid);
    const fluidState trace = helmholtzMixture(composition(0, 1e-9, 1 - 1e-9)).state(94, 1.467e5, phase::liquid);
    EXPECT_NEAR(trace.density/pure.density, 1, 1e-8);
    // Mixtures have the gas constant of CODATA 2018, pure fluids that of their equation: 1e-6 apart
    EXPECT_NEAR(trace.soundSpeed/pure.soundSpeed, 1, 1e-5);
}


TEST(Helmholtz, aGuessDoesNotChooseTheRoot)
{
    const helmholtzMixture mixture(lake);
    const double liquid = mixture.molarDensity(94, 1.467e5, phase::liquid);
    for (const double guess : {0.0, 1.0, 190.0, 5000.0, 12000.0, 0.98*liquid, liquid, 1.05*liquid, 1e5})
    {
        EXPECT_NEAR(mixture.molarDensity(94, 1.467e5, phase::liquid, guess)/liquid, 1, 1e-12) << guess;
    }
}


TEST(Helmholtz, badInputIsRefused)
{
    const helmholtzMixture mixture(lake);
    expectRefusal(reason::notANumber, "temperature T is not a number", [&]{mixture.state(notANumber, 1e5, phase::liquid);});
    expectRefusal(reason::notANumber, "pressure p is not a number", [&]{mixture.state(94, notANumber, phase::liquid);});
    expectRefusal
    (
        reason::notANumber, "not a number",
        [&]{mixture.state(94, std::numeric_limits<double>::infinity(), phase::gas);}
    );
    expectRefusal(reason::temperatureRange, "is 60 K", [&]{mixture.state(60, 1e5, phase::liquid);});
    expectRefusal(reason::temperatureRange, "is 300 K", [&]{mixture.state(300, 1e5, phase::gas);});
    expectRefusal(reason::pressureRange, "is -1 Pa", [&]{mixture.state(94, -1, phase::liquid);});
    expectRefusal(reason::pressureRange, "is 0 Pa", [&]{mixture.state(94, 0, phase::gas);});
    expectRefusal(reason::noSuchPhase, "no stable gas", [&]{mixture.state(94, 1e7, phase::gas);});
    expectRefusal
    (
        reason::noSuchPhase, "no stable liquid",
        []{helmholtzMixture(composition::pure(N2)).state(124, 1e5, phase::liquid);}
    );
    expectRefusal(reason::badEntry, "molar density", [&]{mixture.stateAtDensity(94, -1);});
    expectRefusal(reason::noSuchPhase, "neither liquid nor gas", [&]{mixture.stateAtDensity(94, 8000);});
}


TEST(Composition, isCheckedAndNormalised)
{
    expectRefusal(reason::composition, "mole fraction of CH4 is -0.1", []{composition(0.1, -0.1, 1);});
    expectRefusal(reason::composition, "add up to 1.002", []{composition(0.1, 0.2, 0.702);});
    expectRefusal(reason::composition, "add up to 0.99", []{composition(0.1, 0.2, 0.69);});
    expectRefusal(reason::composition, "add up to 0", []{composition(0, 0, 0);});
    expectRefusal(reason::notANumber, "mole fraction of C3H8", []{composition(0.1, 0.2, 0.7, notANumber);});
    expectRefusal(reason::unknownName, "phase is 'solid'", []{phaseNamed("solid");});

    const composition rounded(0.1002, 0.2, 0.7);
    EXPECT_DOUBLE_EQ(rounded[N2] + rounded[CH4] + rounded[C2H6], 1);
    EXPECT_DOUBLE_EQ(rounded[N2], 0.1002/1.0002);

    // At the limit, whichever way the sum rounds
    EXPECT_NO_THROW(composition(0.101, 0.2, 0.7));
    EXPECT_NO_THROW(composition(0.099, 0.2, 0.7));

    EXPECT_TRUE(composition::pure(CH4).isPure());
    EXPECT_FALSE(lake.isPure());
    EXPECT_EQ(lake.name(), "0.05 N2, 0.25 CH4, 0.65 C2H6, 0.05 C3H8");
    EXPECT_NEAR(composition(0.5, 0.5, 0).molarMass(), 0.5*(0.02801348 + 0.0160428), 1e-15);
}


// A million states over the whole range: a stable root in its own branch, or a named refusal
TEST(Helmholtz, everyStateIsAStableRootOrARefusal)
{
    constexpr int nStates = 1000000;

    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> uniform(0, 1);

    int answered[2] = {0, 0};
    int refused[2] = {0, 0};
    for (int k = 0; k < nStates; ++k)
    {
        // Faces and edges of the composition's simplex too
        composition::fractions x{};
        double sum = 0;
        for (double& xi : x)
        {
            xi = uniform(generator) < 0.3 ? 0 : -std::log(1 - uniform(generator));
            sum += xi;
        }
        if (!(sum > 0))
        {
            x[CH4] = sum = 1;
        }
        for (double& xi : x)
        {
            xi /= sum;
        }
        const double T = range::Tmin + uniform(generator)*(range::Tmax - range::Tmin);
        const double p = range::pMin*std::pow(range::pMax/range::pMin, uniform(generator));
        const phase ph = uniform(generator) < 0.6 ? phase::liquid : phase::gas;
        const bool liquid = ph == phase::liquid;

        try
        {
            const helmholtzMixture mixture{composition(x)};
            const helmholtzMixture::isotherm isotherm(mixture, T);
            const fluidState s = isotherm.state(p, ph);
            ++answered[liquid];

            double back, slope;
            isotherm.pressure(s.molarDensity, back, slope);
            bool good =
                slope > 0
             && std::abs(back - p) < 1e-9*(p + s.isothermalBulkModulus)
             && s.cv > 0 && s.cp >= s.cv*(1 - 1e-12)
             && std::isfinite(s.cp) && std::isfinite(s.expansivity);

            // No unstable density between the root and the end of its branch: dense for liquids, dilute for gases.
            // Rough limits of density and sound speed tell the two apart.
            for (int i = 1; i <= 8; ++i)
            {
                double ignored;
                isotherm.pressure(s.molarDensity*(liquid ? 1 + 0.02*i : 1 - 0.12*i), ignored, slope);
                good = good && slope > 0;
            }
            good = good
             && (
                    liquid
                  ? s.density > 300 && s.soundSpeed > 200 && s.soundSpeed < 4000
                  : s.density < 220 && s.soundSpeed > 80 && s.soundSpeed < 300
                );
            ASSERT_TRUE(good)
                << phaseName(ph) << " " << composition(x).name() << " at " << T << " K, " << p << " Pa: density "
                << s.density << ", sound speed " << s.soundSpeed;
        }
        catch (const thermoError& refusal)
        {
            ++refused[liquid];
            ASSERT_EQ(refusal.why(), reason::noSuchPhase) << refusal.what();
        }
    }
    // A liquid is refused only where it would have boiled long before
    EXPECT_LT(refused[1], 0.01*answered[1]);
    EXPECT_GT(answered[0], refused[0]);
}


// Nitrogen at 2 MPa: the spinodal is crossed at about 120.3 K, beyond it the equation has a shelf with further roots
TEST(Helmholtz, nothingIsLiquidBeyondItsSpinodal)
{
    const helmholtzMixture nitrogen(composition::pure(N2));
    EXPECT_NEAR(nitrogen.state(120, 2e6, phase::liquid).density, 485.875, 0.001);

    bool ended = false;
    double last = nitrogen.state(119, 2e6, phase::liquid).molarDensity;
    for (int k = 1; k < 600; ++k)
    {
        const double T = 119 + 0.01*k;
        try
        {
            const double rho = nitrogen.molarDensity(T, 2e6, phase::liquid);
            EXPECT_FALSE(ended) << "a liquid again at " << T << " K";
            EXPECT_LT(rho, last);
            EXPECT_GT(rho, 0.99*last);
            last = rho;
        }
        catch (const thermoError&)
        {
            ended = true;
        }
    }
    for (const double T : {120.45, 120.5, 120.65, 120.7})
    {
        expectRefusal(reason::noSuchPhase, "1 N2", [&]{nitrogen.molarDensity(T, 2e6, phase::liquid);});
        expectRefusal(reason::noSuchPhase, "1 N2", [&]{nitrogen.molarDensity(T, 2e6, phase::liquid, 14855);});
    }
}


// Pressures about those at which liquids and gases that are mostly nitrogen lose their stability, seeded: what is
// answered is on its own branch, the one on which the slope rises to the dense (dilute) end, whatever the guess
TEST(Helmholtz, nothingIsAnsweredBeyondASpinodal)
{
    constexpr int nIsotherms = 600;
    constexpr double fine = 0.0025;

    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> uniform(0, 1);

    int answered[2] = {0, 0};
    for (int k = 0; k < nIsotherms; ++k)
    {
        composition::fractions x{{1, 0, 0, 0}};
        if (k % 3)
        {
            const double rest = std::pow(10, -4*uniform(generator));
            const double amounts[] = {uniform(generator), uniform(generator), uniform(generator)};
            for (int i = CH4; i < nSpecies; ++i)
            {
                x[i] = rest*amounts[i-1]/(amounts[0] + amounts[1] + amounts[2]);
            }
            x[N2] = 1 - x[CH4] - x[C2H6] - x[C3H8];
        }
        const double T = 105 + uniform(generator)*(range::Tmax - 105);
        const bool liquid = uniform(generator) < 0.6;
        const phase ph = liquid ? phase::liquid : phase::gas;

        const helmholtzMixture mixture{composition(x)};
        const helmholtzMixture::isotherm isotherm(mixture, T);

        // The end of the branch, by a walk in small steps
        double end = liquid ? isotherm.molarDensity(1e8, ph) : 0.01;
        double pEnd = 0;
        double p, slope;
        double lastSlope = std::numeric_limits<double>::infinity();
        for (double rho = end; ; rho *= liquid ? 1 - fine : 1 + fine)
        {
            isotherm.pressure(rho, p, slope);
            if (!(slope > 0 && slope < lastSlope))
            {
                break;
            }
            lastSlope = slope;
            end = rho;
            pEnd = p;
        }

        for (int n = 0; n < 8; ++n)
        {
            p = std::max(pEnd, 1e5)*(1 + (uniform(generator) - 0.5)*std::pow(10, -4*uniform(generator)));
            for (const double guess : {0.0, 0.7*end, 0.9*end, 0.98*end, end, 1.02*end})
            {
                double rho;
                try
                {
                    rho = isotherm.molarDensity(p, ph, guess);
                }
                catch (const thermoError& refusal)
                {
                    // A few per cent before the end at most
                    ASSERT_EQ(refusal.why(), reason::noSuchPhase);
                    ASSERT_LT((liquid ? p - pEnd : pEnd - p)/mixture.gasConstant()/T/end, 0.01)
                        << phaseName(ph) << " " << composition(x).name() << " at " << T << " K, " << p << " Pa";
                    continue;
                }
                ++answered[liquid];
                ASSERT_TRUE(liquid ? rho > end*(1 - 2*fine) : rho < end*(1 + 2*fine))
                    << phaseName(ph) << " " << composition(x).name() << " at " << T << " K, " << p << " Pa, guess "
                    << guess << ": " << rho << " mol/m3 is beyond " << end;
                ASSERT_NEAR(isotherm.state(p, ph).molarDensity/rho, 1, 1e-6);
            }
        }
    }
    EXPECT_GT(answered[0], 500);
    EXPECT_GT(answered[1], 500);
}
