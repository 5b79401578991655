// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of a weakly compressible liquid against their definitions, and the choices of their stiffness.

#include "refusals.H"
#include "weaklyCompressible.H"

#include <limits>

using namespace Foam::titan;

namespace
{

const double noNumber = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

// Of liquid ethane at 94 K, roughly
const double p0 = 1.467e5;
const double rho0 = 645;
const stiffness liquid{2.5e9, 9.5};

//- A gas with p = rho R T and constant cp: K_T = p, K_s = gamma p
class idealGas
:
    public fluidModel
{
    const double R_, gamma_;

public:

    idealGas(double R, double gamma)
    :
        R_(R),
        gamma_(gamma)
    {}

    const char* type() const override
    {
        return "ideal gas";
    }

    void evaluate
    (
        property q,
        std::size_t n,
        const double* T,
        const double* p,
        double* values
    ) const override
    {
        for (std::size_t i = 0; i < n; ++i)
        {
            values[i] = properties(T[i], p[i])[q];
        }
    }

    fluidProperties properties(double T, double p) const override
    {
        fluidProperties s{T, p, {}, {}};
        auto set = [&s](property q, double value)
        {
            s.values[static_cast<int>(q)] = value;
        };
        set(property::density, p/(R_*T));
        set(property::cp, gamma_*R_/(gamma_ - 1));
        set(property::expansivity, 1/T);
        // Not linear, so that the order of the difference shows
        set(property::isothermalBulkModulus, p*(1 + 1e-7*p));
        set(property::isentropicBulkModulus, gamma_*p*(T/300));
        return s;
    }
};


template<class Law>
class Laws
:
    public testing::Test
{};

typedef thermoError::reason reason;

typedef testing::Types<MurnaghanLaw, TaitLaw> laws;
TYPED_TEST_SUITE(Laws, laws);

} // End anonymous namespace


TYPED_TEST(Laws, roundTrip)
{
    const TypeParam law(TypeParam::of(p0, rho0, liquid));
    for (double p = -2e8; p < 1e9; p += 1.3e6)
    {
        // What one unit in the last place of the density is worth in pressure
        const double ulp = 2.3e-16*law.bulkModulus(p);
        EXPECT_NEAR(law.pressure(law.density(p)), p, 4*ulp) << p;
    }
    EXPECT_DOUBLE_EQ(law.density(p0), rho0);
    EXPECT_DOUBLE_EQ(law.pressure(rho0), p0);
}


TYPED_TEST(Laws, stiffnessAtReference)
{
    const TypeParam law(TypeParam::of(p0, rho0, liquid));
    EXPECT_NEAR(law.bulkModulus(p0)/liquid.bulkModulus, 1, 1e-14);
    EXPECT_NEAR(law.soundSpeed(p0), std::sqrt(2.5e9/645), 1e-10);

    const double dp = 1e4;
    EXPECT_NEAR
    (
        (law.bulkModulus(p0 + dp) - law.bulkModulus(p0 - dp))/(2*dp),
        liquid.derivative,
        1e-6
    );
}


TYPED_TEST(Laws, derivatives)
{
    const TypeParam law(TypeParam::of(p0, rho0, liquid));
    for (const double p : {-2e8, -1e7, 0., p0, 1e7, 1e9})
    {
        const double dp = 1e5;
        const double dRhodp =
            (law.density(p + dp) - law.density(p - dp))/(2*dp);
        EXPECT_NEAR(dRhodp*law.bulkModulus(p)/law.density(p), 1, 1e-5) << p;
        EXPECT_NEAR(1/std::sqrt(dRhodp)/law.soundSpeed(p), 1, 1e-5) << p;

        const double dh =
            (law.enthalpy(p + dp) - law.enthalpy(p - dp))/(2*dp);
        EXPECT_NEAR(dh*law.density(p), 1, 1e-5) << p;
    }
    EXPECT_EQ(law.enthalpy(p0), 0);
}


TYPED_TEST(Laws, refused)
{
    const TypeParam law(TypeParam::of(p0, rho0, liquid));
    const double least = law.lowestPressure();
    EXPECT_NO_THROW(law.density(least + 1e4));
    for (const double p : {least, least - 1e4, -1e300})
    {
        expectRefusal(reason::pressureRange, "pressure", [&]{ law.density(p); });
        expectRefusal(reason::pressureRange, "pressure", [&]{ law.soundSpeed(p); });
        expectRefusal(reason::pressureRange, "pressure", [&]{ law.enthalpy(p); });
    }
    for (const double x : {noNumber, infinity})
    {
        expectRefusal(reason::notANumber, "pressure", [&]{ law.density(x); });
        expectRefusal(reason::notANumber, "density", [&]{ law.pressure(x); });
    }
    for (const double rho : {0., -1.})
    {
        expectRefusal(reason::badEntry, "density", [&]{ law.pressure(rho); });
    }

    auto refused = [](reason why, const char* what, double p, double rho, double K, double dK)
    {
        expectRefusal(why, what, [=]{ TypeParam::of(p, rho, stiffness{K, dK}); });
    };
    refused(reason::notANumber, "p0", noNumber, rho0, 2.5e9, 9.5);
    refused(reason::badEntry, "rho0", p0, -rho0, 2.5e9, 9.5);
    refused(reason::badEntry, "[Pa]", p0, rho0, 0, 9.5);
    refused(reason::badEntry, "gamma", p0, rho0, 2.5e9, -1);
    refused(reason::notANumber, "gamma", p0, rho0, 2.5e9, noNumber);
}


TEST(Tait, highestPressure)
{
    // Stiff enough a law that its volume vanishes at a pressure in reach
    const TaitLaw law(0, 1000, 1e8, 0.5);
    const double most = 1e8*(std::exp(2) - 1);
    EXPECT_GT(law.density(0.999*most), 1000);
    expectRefusal(reason::pressureRange, "pressure", [&]{ law.density(1.001*most); });
}


TEST(Murnaghan, asInThePaper)
{
    // Eq. 4 of IAC-20-E2.1.9, in gauge pressure
    const MurnaghanLaw law(0, 664, 1.2e4, 7);
    EXPECT_NEAR(law.pressure(1.1*664), 1.2e4*(std::pow(1.1, 7) - 1), 1e-9);
    // Without curvature K is k0 + p
    EXPECT_NEAR(MurnaghanLaw(0, 664, 1e4, 1).enthalpy(1e4), 1e4/664*std::log(2), 1e-12);
}


TEST(Stiffness, waveTank)
{
    // Eq. 6; c0 by eq. 5 is ten times the speed of long waves
    const stiffness s(waveTankStiffness(664, 1.35, 1, 7));
    const MurnaghanLaw law(MurnaghanLaw::of(0, 664, s));
    EXPECT_NEAR(law.k0(), 100*1.35*1*664/7., 1e-9);
    EXPECT_NEAR(law.soundSpeed(0), 10*std::sqrt(1.35*1), 1e-12);
    expectRefusal(reason::badEntry, "H", []{ waveTankStiffness(664, 1.35, 0, 7); });
    expectRefusal(reason::badEntry, "gamma", []{ waveTankStiffness(664, 1.35, 1, -7); });
}


TEST(Stiffness, machNumber)
{
    const stiffness s(machNumberStiffness(664, 25, 0.1, 7));
    EXPECT_NEAR(TaitLaw::of(p0, 664, s).soundSpeed(p0), 250, 1e-10);
    expectRefusal(reason::badEntry, "Ma", []{ machNumberStiffness(664, 25, 0, 7); });
    expectRefusal(reason::badEntry, "U", []{ machNumberStiffness(664, -25, 0.1, 7); });
    expectRefusal(reason::notANumber, "Ma", []{ machNumberStiffness(664, 25, noNumber, 7); });
}


TEST(Stiffness, alongTheCompression)
{
    const double gamma = 1.4;
    const idealGas gas(287, gamma);
    const stiffness isothermal
    (
        realStiffness(gas, 300, 1e5, compression::isothermal)
    );
    EXPECT_DOUBLE_EQ(isothermal.bulkModulus, 1e5*1.01);
    // A parabola is differentiated without error
    EXPECT_NEAR(isothermal.derivative, 1 + 2e-7*1e5, 1e-8);

    // d/dp of gamma p T/300 along the isentrope, where dT/dp = (gamma - 1)/gamma T/p
    const stiffness isentropic
    (
        realStiffness(gas, 300, 1e5, compression::isentropic)
    );
    EXPECT_DOUBLE_EQ(isentropic.bulkModulus, gamma*1e5);
    EXPECT_NEAR(isentropic.derivative, gamma + (gamma - 1), 1e-8);
}


TEST(Stiffness, asTheRealLiquid)
{
    const double T = 94;
    const auto lake =
        directFluid(composition(0.05, 0.25, 0.70), phase::liquid);
    const fluidProperties s(lake->properties(T, p0));
    const double rho = s[property::density];

    const stiffness sound(realStiffness(*lake, T, p0, compression::isentropic));
    EXPECT_NEAR
    (
        MurnaghanLaw::of(p0, rho, sound).soundSpeed(p0)
       /s[property::soundSpeed],
        1,
        1e-12
    );

    // 100 bar, which compress it by 0.7 %: what K'' leaves is of third order
    const stiffness still
    (
        realStiffness(*lake, T, p0, compression::isothermal)
    );
    const double compressed = lake->value(property::density, T, p0 + 1e7);
    EXPECT_GT(compressed/rho, 1.005);
    EXPECT_NEAR
    (
        MurnaghanLaw::of(p0, rho, still).density(p0 + 1e7)/compressed,
        1,
        1e-5
    );
    EXPECT_NEAR
    (
        TaitLaw::of(p0, rho, still).density(p0 + 1e7)/compressed,
        1,
        1e-5
    );
}

// ************************************************************************* //
