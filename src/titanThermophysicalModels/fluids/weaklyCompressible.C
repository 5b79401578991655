// SPDX-License-Identifier: GPL-3.0-or-later

#include "weaklyCompressible.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace titan
{

namespace
{

[[noreturn]] void refuse
(
    const thermoError::reason why,
    const char* what,
    const double value,
    const std::string& expected
)
{
    std::ostringstream message;
    message.precision(10);
    message << what << " is " << value << ", expected " << expected;
    throw thermoError(why, message.str());
}


double checkPositive(const char* what, const double value)
{
    if (!std::isfinite(value) || !(value > 0))
    {
        refuse
        (
            std::isfinite(value)
          ? thermoError::reason::badEntry
          : thermoError::reason::notANumber,
            what,
            value,
            "a positive number"
        );
    }
    return value;
}


double checkFinite(const char* what, const double value)
{
    if (!std::isfinite(value))
    {
        refuse(thermoError::reason::notANumber, what, value, "a number");
    }
    return value;
}


std::string number(const double x)
{
    std::ostringstream os;
    os.precision(10);
    os << x;
    return os.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

stiffness realStiffness
(
    const fluidModel& fluid,
    const double T,
    const double p,
    const compression along
)
{
    const bool isentropic = along == compression::isentropic;
    const property K =
        isentropic
      ? property::isentropicBulkModulus
      : property::isothermalBulkModulus;

    const fluidProperties s(fluid.properties(T, p));

    // One-sided, of second order: towards lower pressures the liquid may boil.
    // Half a thousandth of a liquid's pressure scale K/K', and enough for the
    // difference to keep nine digits
    const double dp = 1e-4*s[K];
    const double dTdp =
        isentropic
      ? T*s[property::expansivity]
       /(s[property::density]*s[property::cp])
      : 0;

    return
    {
        checkPositive("bulk modulus [Pa]", s[K]),
        checkPositive
        (
            "derivative dK/dp of the bulk modulus",
            (
                4*fluid.value(K, T + dTdp*dp, p + dp)
              - fluid.value(K, T + 2*dTdp*dp, p + 2*dp)
              - 3*s[K]
            )/(2*dp)
        )
    };
}


stiffness waveTankStiffness
(
    const double rho0,
    const double g,
    const double H,
    const double gamma
)
{
    return
    {
        100*checkPositive("g [m/s2]", g)*checkPositive("H [m]", H)
       *checkPositive("rho0 [kg/m3]", rho0),
        checkPositive("gamma", gamma)
    };
}


stiffness machNumberStiffness
(
    const double rho0,
    const double U,
    const double Ma,
    const double gamma
)
{
    const double c0 = checkPositive("U [m/s]", U)/checkPositive("Ma", Ma);
    return
    {
        checkPositive("rho0 [kg/m3]", rho0)*c0*c0,
        checkPositive("gamma", gamma)
    };
}


// * * * * * * * * * * * * * * * MurnaghanLaw  * * * * * * * * * * * * * * * //

MurnaghanLaw::MurnaghanLaw
(
    const double p0,
    const double rho0,
    const double k0,
    const double gamma
)
:
    p0_(checkFinite("p0 [Pa]", p0)),
    rho0_(checkPositive("rho0 [kg/m3]", rho0)),
    k0_(checkPositive("k0 [Pa]", k0)),
    gamma_(checkPositive("gamma", gamma))
{}


MurnaghanLaw MurnaghanLaw::of
(
    const double p0,
    const double rho0,
    const stiffness& s
)
{
    const double gamma = checkPositive("gamma", s.derivative);
    return MurnaghanLaw(p0, rho0, s.bulkModulus/gamma, gamma);
}


void MurnaghanLaw::refusePressure(const double p) const
{
    refuse
    (
        std::isfinite(p)
      ? thermoError::reason::pressureRange
      : thermoError::reason::notANumber,
        "pressure [Pa]",
        p,
        "more than p0 - k0 = " + number(lowestPressure())
      + ", where Murnaghan's law has no liquid left"
    );
}


// * * * * * * * * * * * * * * * * * TaitLaw * * * * * * * * * * * * * * * * //

TaitLaw::TaitLaw
(
    const double p0,
    const double rho0,
    const double B,
    const double C
)
:
    p0_(checkFinite("p0 [Pa]", p0)),
    rho0_(checkPositive("rho0 [kg/m3]", rho0)),
    B_(checkFinite("B [Pa]", B)),
    C_(checkPositive("C", C))
{
    checkPositive("B + p0 [Pa]", B + p0);
}


TaitLaw TaitLaw::of
(
    const double p0,
    const double rho0,
    const stiffness& s
)
{
    const double C = 1/(1 + checkPositive("gamma", s.derivative));
    return
        TaitLaw
        (
            p0,
            rho0,
            C*checkPositive("bulk modulus [Pa]", s.bulkModulus) - p0,
            C
        );
}


void TaitLaw::refusePressure(const double p) const
{
    refuse
    (
        std::isfinite(p)
      ? thermoError::reason::pressureRange
      : thermoError::reason::notANumber,
        "pressure [Pa]",
        p,
        "between -B = " + number(lowestPressure()) + " and "
      + number(p0_ + (B_ + p0_)*std::expm1(1/C_))
      + ", where Tait's law has a liquid"
    );
}


} // End namespace titan
} // End namespace Foam

// ************************************************************************* //
