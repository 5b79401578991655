// SPDX-License-Identifier: GPL-3.0-or-later
#include "pureTransport.H"
#include "pureFluids.H"

#include <algorithm>
#include <cmath>
#include <cstdio>

// Figures copied from the publications that pureTransport.H names

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using namespace Foam::titan;

constexpr double pi = 3.14159265358979323846;

// CODATA 2010, of the time of the correlations
constexpr double avogadro = 6.02214129e23;      // [1/mol]
constexpr double boltzmann = 1.3806488e-23;     // [J/K]

// Reducing temperatures [K] and densities [mol/m3] of the residual viscosity
constexpr double N2Tc = 126.192;
constexpr double N2Density = 11183.9;
constexpr double CH4Tc = 190.564;
constexpr double C2H6Tc = 305.322;
constexpr double C2H6Density = 206.18/0.03006904;
constexpr double C3H8Tc = 369.825;
constexpr double C3H8Density = 5000;

// The same of the residual conductivity, where it differs
constexpr double CH4FriendTc = 190.55;
constexpr double CH4FriendDensity = 10139;
constexpr double C2H6FriendTc = 305.33;
constexpr double C2H6FriendDensity = 206.5809/0.03006904;
constexpr double C3H8MarshTc = 369.82;
constexpr double C3H8MarshDensity = 220.3/0.04409562;

// Energy parameters over k [K] of Friend's dilute gases
constexpr double CH4FriendEnergy = 174;
constexpr double C2H6FriendEnergy = 245;


double sqr(double x)
{
    return x*x;
}


//- The equations of state of the pure fluids
const helmholtzMixture& pureEquation(species i)
{
    static const helmholtzMixture equations[nSpecies] =
    {
        helmholtzMixture(composition::pure(N2)),
        helmholtzMixture(composition::pure(CH4)),
        helmholtzMixture(composition::pure(C2H6)),
        helmholtzMixture(composition::pure(C3H8))
    };
    return equations[i];
}


[[noreturn]] void refuse(thermoError::reason why, const char* format, double value, species i)
{
    char buffer[256];
    std::snprintf(buffer, sizeof buffer, format, value, speciesLongName(i));
    throw thermoError(why, buffer);
}


double checkedTemperature(species i, double T)
{
    if (!std::isfinite(T))
    {
        refuse(thermoError::reason::notANumber, "temperature T is %g for %s: expected a number", T, i);
    }
    if (T <= 0)
    {
        refuse(thermoError::reason::temperatureRange, "temperature T is %.6g K for %s: expected more than 0", T, i);
    }
    return T;
}


//- Dilute-gas viscosity [Pa s] of kinetic theory, with a collision integral exp(sum_k a_k ln(T*)^k)
template<int N>
double kineticViscosity(double C, double M, double sigma, double reducedT, double T, const double (&a)[N])
{
    const double lnT = std::log(reducedT);
    double lnOmega = 0;
    for (int k = N - 1; k >= 0; --k)
    {
        lnOmega = lnOmega*lnT + a[k];
    }
    return C*std::sqrt(M*T)/(sqr(sigma)*std::exp(lnOmega));
}


//- Dilute-gas viscosity over its factor, [-]: Friend et al. 1989, eq. 8, the same for methane and ethane
double friendViscosity(double reducedT)
{
    static const double C[] =
    {
        -3.0328138281, 16.918880086, -37.189364917, 41.288861858, -24.61592114,
        8.9488430959, -1.8739245042, 0.2096610139, -0.0096570437074
    };
    const double cubeRoot = std::cbrt(reducedT);
    double sum = 0;
    for (int k = 8; k >= 0; --k)
    {
        sum = sum*cubeRoot + C[k];
    }
    return std::sqrt(reducedT)*sum/reducedT;
}


double dilutedViscosityOf(species i, double T)
{
    switch (i)
    {
        case N2:
        {
            static const double a[] = {0.431, -0.4623, 0.08406, 0.005341, -0.00331};
            return kineticViscosity(2.66958e-8, 28.01348, 0.3656, T/98.94, T, a);
        }
        case CH4:
        {
            const double root = std::sqrt(T/CH4Tc);
            return 2.60536e-6 - 1.85247e-5*std::sqrt(root) + 2.34216e-5*root;
        }
        case C2H6:
        {
            const double cubeRoot = std::cbrt(T);
            const double root = std::sqrt(T);
            const double e = std::exp(-cubeRoot);
            return 1e-6*root/(0.79330 + 262.946*e + (13.8366 + 1339.77*e)/root - 322.242*T*e*e);
        }
        default:
        {
            static const double a[] = {0.25104574, -0.47271238, 0, 0.060836515};
            return kineticViscosity(2.1357e-8, 44.0956, 0.49748, T/263.88, T, a);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Series * * * * * * * * * * * * * * * * * //

template<int N>
Foam::titan::pureTransport::series::series(const term (&terms)[N], double reducingDensity, double tau)
:
    reducingDensity_(reducingDensity),
    degree_{0, 0, 0, 0},
    c_()
{
    for (const term& k : terms)
    {
        c_[k.l][k.d] += k.n*std::pow(tau, k.t);
        degree_[k.l] = std::max(degree_[k.l], k.d);
    }
}


double Foam::titan::pureTransport::series::operator()(double molarDensity) const
{
    const double delta = molarDensity/reducingDensity_;
    double sum = 0;
    double powerL = 1;
    for (int l = 0; l < 4; ++l)
    {
        if (degree_[l])
        {
            double q = 0;
            for (int d = degree_[l]; d >= 0; --d)
            {
                q = q*delta + c_[l][d];
            }
            sum += l ? q*std::exp(-powerL) : q;
        }
        powerL *= delta;
    }
    return sum;
}


Foam::titan::pureTransport::series Foam::titan::pureTransport::viscositySeries(species i, double T)
{
    switch (i)
    {
        case N2:
        {
            static const term terms[] =
            {
                {1.072e-05, 0.1, 2, 0},
                {3.989e-08, 0.25, 10, 1},
                {1.208e-09, 3.2, 12, 1},
                {-7.402e-06, 0.9, 2, 2},
                {4.62e-06, 0.3, 1, 3}
            };
            return series(terms, N2Density, N2Tc/T);
        }
        case CH4:
        {
            // Friction theory instead
            static const term none[] = {{0, 0, 0, 0}};
            return series(none, 1, 1);
        }
        case C2H6:
        {
            static const term terms[] =
            {
                {20.101502550505e-6, 0, 1, 0},
                {-5.3310495236264e-6, 1, 1, 0},
                {-0.0091932109313455e-6, 7, 2, 0},
                {-0.3269275033724e-6, 2, 4, 0},
                {0.28850975314454e-6, 0, 6, 0},
                {0.00018714822381408e-6, 7, 6, 0},
                {6.5739794167039e-12, 1, 15, 0},
                {-13.249185654669e-6, 0, 1, 1},
                {-25.958989867061e-6, 1, 3, 1},
                {23.489171321456e-6, 2, 3, 1},
                {7.8770433769273e-6, 0, 4, 1}
            };
            return series(terms, C2H6Density, C2H6Tc/T);
        }
        default:
        {
            static const term terms[] =
            {
                {3.59873030195e-05, 0, 2, 0},
                {-0.000180512188564, 1, 2, 0},
                {8.77124888223e-05, 2, 2, 0},
                {-0.000105773052525, 0, 3, 0},
                {0.000205319740877, 1, 3, 0},
                {-0.00012921093261, 2, 3, 0},
                {5.89491587759e-05, 0, 4, 0},
                {-0.0001297400331, 1, 4, 0},
                {7.66280419971e-05, 2, 4, 0},
                {-9.59407868475e-06, 0, 5, 0},
                {2.10726986598e-05, 1, 5, 0},
                {-1.43971968187e-05, 2, 5, 0}
            };
            return series(terms, C3H8Density, C3H8Tc/T);
        }
    }
}


Foam::titan::pureTransport::series Foam::titan::pureTransport::conductivitySeries(species i, double T)
{
    switch (i)
    {
        case N2:
        {
            static const term terms[] =
            {
                {0.008862, 0, 1, 0},
                {0.03111, 0.03, 2, 0},
                {-0.07313, 0.2, 3, 1},
                {0.02003, 0.8, 4, 2},
                {-0.0007096, 0.6, 8, 2},
                {0.0002672, 1.9, 10, 2}
            };
            return series(terms, pureFluidOf(N2).rhoc, N2Tc/T);
        }
        case CH4:
        {
            constexpr double unit = 6.29638e-3;
            static const term terms[] =
            {
                {2.4149207*unit, 0, 1, 0},
                {0.55166331*unit, 0, 3, 0},
                {-0.52837734*unit, 0, 4, 0},
                {0.073809553*unit, 1, 4, 0},
                {0.24465507*unit, 0, 5, 0},
                {-0.047613626*unit, 1, 5, 0}
            };
            return series(terms, CH4FriendDensity, CH4FriendTc/T);
        }
        case C2H6:
        {
            static const term terms[] =
            {
                {0.0042448708279092, 0, 1, 0},
                {0.01214921881971, 0, 2, 0},
                {-0.00011755611350154, 0, 3, 0},
                {-0.00034524130817994, 0, 4, 0},
                {0.0009666869231454, 0, 5, 0},
                {0.010536403039518, 1.5, 1, 0},
                {-0.0033184300792206, 1, 3, 0}
            };
            return series(terms, C2H6FriendDensity, C2H6FriendTc/T);
        }
        default:
        {
            static const term terms[] =
            {
                {-0.03695, 0, 1, 0},
                {0.148658, 0, 2, 0},
                {-0.119986, 0, 3, 0},
                {0.0412431, 0, 4, 0},
                {-0.00486905, 0, 5, 0},
                {0.0482798, -1, 1, 0},
                {-0.135636, -1, 2, 0},
                {0.117588, -1, 3, 0},
                {-0.0436911, -1, 4, 0},
                {0.00616079, -1, 5, 0}
            };
            return series(terms, C3H8MarshDensity, C3H8MarshTc/T);
        }
    }
}


// * * * * * * * * * * * * * Private Functions  * * * * * * * * * * * * * * * //

double Foam::titan::pureTransport::dilutedConductivity() const
{
    // Translation and internal degrees of freedom: Friend et al. 1989, eq. 13 and 1991, eq. 22
    auto eucken = [this](double factor, double viscosity, double fInternal)
    {
        // So dilute that the gas is ideal
        const fluidState s = isotherm_.stateAtDensity(1e-6);
        const double heatCapacity = s.cv*molarMass(i_)/pureFluidOf(i_).R;
        return factor*viscosity*(3.75 + fInternal*(heatCapacity - 1.5));
    };

    switch (i_)
    {
        case N2:
        {
            const double tau = N2Tc/T_;
            return 0.001511*1e6*dilutedViscosity_ + 0.002117/tau - 0.003332*std::pow(tau, -0.7);
        }
        case CH4:
        {
            const double t = T_/CH4FriendEnergy;
            return eucken(0.51828e-3, 10.50*friendViscosity(t), 1.458850 - 0.4377162/t);
        }
        case C2H6:
        {
            const double t = T_/C2H6FriendEnergy;
            return eucken(0.276505e-3, 12.0085*friendViscosity(t), 1.7104147 - 0.6936482/t);
        }
        default:
        {
            const double Tr = T_/369.85;
            return -0.00124778 + Tr*(0.00816371 + Tr*0.0199374);
        }
    }
}


Foam::titan::pureTransport::frictionTheory::frictionTheory(double T)
{
    const double tau = CH4Tc/T;
    const double psi = std::exp(tau) - 1;
    const double tau3 = tau*tau*tau;

    a = (-3.12118e-8 + 1.99422e-10*psi)*tau;
    r = (5.98858e-8 - 4.91143e-8*psi)*tau;
    i = (3.49668e-8 - 1.73176e-8*psi)*tau;
    aa = (-8.52992e-13 - 3.58009e-13*psi)*tau3;
    rr = (1.60099e-11 + 8.50221e-13*psi)*tau3;
    ii = (-3.55631e-10 + 2.80326e-10*psi)*tau3;
}


double Foam::titan::pureTransport::methaneFriction(const fluidState& s) const
{
    constexpr double bar = 1e5;
    const double repulsive = T_*s.expansivity*s.isothermalBulkModulus/bar;
    const double attractive = s.p/bar - repulsive;
    const double ideal = s.molarDensity*pureFluidOf(CH4).R*T_/bar;
    const double residual = repulsive - ideal;

    const frictionTheory& k = friction_;
    return
        k.a*attractive + k.r*residual + k.i*ideal
      + k.aa*sqr(attractive) + k.rr*sqr(residual) + k.ii*sqr(ideal);
}


double Foam::titan::pureTransport::ethaneNearCritical(double molarDensity) const
{
    const double tau = C2H6Tc/T_;
    const double delta = molarDensity/C2H6Density;
    const double T = std::abs(tau - 1);
    const double rho = sqr(delta - 1);
    return 1e-6*delta*tau
       *(
            0.64266651197353*std::exp(-90*rho - 100*T)
          + 0.70693316317088*std::exp(-50*rho - 250*T)
        );
}


Foam::titan::pureTransport::freeVolume::freeVolume(double T)
{
    // Rainwater and Friend
    const double reducedT = T/263.88;
    const double root = std::sqrt(reducedT);
    const double fourth = std::sqrt(root);
    virial =
        avogadro*std::pow(4.9748e-10, 3)
       *(
          - 19.572881 + 219.73999/fourth - 1015.3226/root + 2471.01251/(root*fourth) - 3375.1717/reducedT
          + 2491.6597/(reducedT*fourth) - 787.26086/(reducedT*root)
          + 14.085455/(sqr(reducedT)*root) - 0.34664158*std::pow(reducedT, -5.5)
        );
    closePacked = 2.50053938863 + 2.1517543007382995*std::sqrt(T/C3H8Tc);
}


double Foam::titan::pureTransport::propaneFreeVolume(double molarDensity) const
{
    // Of close packing: the liquid under its vapour comes so close to the pole at 73 K, six times as viscous as at its
    // triple point, and meets it at 67 K
    constexpr double densest = 0.98;

    const double delta = molarDensity/C3H8Density;
    const double closePacked = freeVolume_.closePacked;
    if (delta > densest*closePacked)
    {
        refuse
        (
            thermoError::reason::temperatureRange,
            "temperature T is %.6g K: too low for the viscosity of %s, whose correlation ends at about 73 K, and higher"
            " under pressure",
            T_,
            C3H8
        );
    }
    return
        dilutedViscosity_*freeVolume_.virial*molarDensity
      + 0.00161688405374*delta*(1/(closePacked - delta) - 1/closePacked);
}


double Foam::titan::pureTransport::nitrogenEnhancement(const fluidState& s) const
{
    // Lemmon and Jacobsen 2004, eqs. 7-10
    constexpr double referenceT = 252.384;
    constexpr double Gamma = 0.055;
    constexpr double exponent = 0.63/1.2415;
    constexpr double xi0 = 1.7e-10;
    constexpr double qD = 2.5e9;
    constexpr double R0 = 1.01;
    static const helmholtzMixture::isotherm reference(pureEquation(N2), referenceT, false);

    double p, referenceSlope;
    reference.pressure(s.molarDensity, p, referenceSlope);
    const double slope = s.isothermalBulkModulus/s.molarDensity;

    const pureFluid& fluid = pureFluidOf(N2);
    const double susceptibility =
        fluid.pc*s.molarDensity/sqr(fluid.rhoc)*(1/slope - referenceT/(T_*referenceSlope));
    if (!(susceptibility > 0))
    {
        return 0;
    }
    const double xi = xi0*std::pow(susceptibility/Gamma, exponent);
    const double y = qD*xi;

    const double ratio = s.cv/s.cp;
    const double Omega = (1 - ratio)*std::atan(y) + ratio*y;
    const double Omega0 = 1 - std::exp(-1/(1/y + sqr(y*fluid.rhoc/s.molarDensity)/3));

    return s.density*s.cp*R0*boltzmann*T_/(6*pi*viscosity(s)*xi)*2/pi*(Omega - Omega0);
}


double Foam::titan::pureTransport::methaneQuadratic(double molarDensity) const
{
    // Friend et al. 1989, eq. 16: the divisor is 1 but for the vapour
    const pureFluid& fluid = pureFluidOf(CH4);
    const bool vapour = T_ < fluid.Tc && molarDensity < fluid.rhoc;
    const double divisor = vapour ? saturated().vapourDensity/fluid.rhoc : 1;
    return 6.29638e-3*1.5554612*sqr(molarDensity/CH4FriendDensity)/divisor;
}


double Foam::titan::pureTransport::methaneEnhancement(const fluidState& s) const
{
    // Friend et al. 1989, eqs. 17 and 19a
    const double tau = CH4FriendTc/T_;
    const double delta = s.molarDensity/CH4FriendDensity;
    const double fromTc = 1 - 1/tau;
    const double fromDensity = 1 - delta;
    const double damping =
        std::exp(-2.646*std::sqrt(std::abs(fromTc)) - 2.678*sqr(fromDensity) + 0.637*fromDensity);

    // Friend's own viscosity [uPa s], for this alone
    const double numerator =
        delta
       *(
            0.41250137 - 0.14390912*tau
          + delta
           *(
                0.10366993 + 0.40287464*tau - 0.24903524*tau*std::sqrt(tau)
              + delta*(-0.12953131 + 0.06575776*sqr(tau) + delta*(0.02566628 - 0.03716526*tau))
            )
        );
    const double denominator = 1 + delta*(-0.38798341 + 0.03533815*tau);
    const double friction = 10.50*friendViscosity(T_/CH4FriendEnergy) + 12.149*numerator/denominator;

    const double RT = pureFluidOf(CH4).R*T_;
    const double susceptibility = 0.28631*delta*tau*s.molarDensity*RT/s.isothermalBulkModulus;
    const double slope = s.expansivity*s.isothermalBulkModulus*T_/(s.molarDensity*RT);

    return 91.855e-3/(friction*sqr(tau))*sqr(slope)*std::pow(susceptibility, 0.4681)*damping;
}


double Foam::titan::pureTransport::viscosityOfDensity(double molarDensity) const
{
    const double mu = dilutedViscosity_ + viscosity_(molarDensity);
    switch (i_)
    {
        case C2H6: return mu + ethaneNearCritical(molarDensity);
        case C3H8: return mu + propaneFreeVolume(molarDensity);
        default:   return mu;
    }
}


void Foam::titan::pureTransport::check(double molarDensity) const
{
    if (!std::isfinite(molarDensity))
    {
        refuse(thermoError::reason::notANumber, "density is %g for %s: expected a number", molarDensity, i_);
    }
    if (molarDensity < 0)
    {
        refuse(thermoError::reason::badEntry, "density is %.6g mol/m3 for %s: expected 0 or more", molarDensity, i_);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::titan::pureTransport::pureTransport(species i, double T)
:
    i_(i),
    T_(checkedTemperature(i, T)),
    isotherm_(pureEquation(i), T, false),
    dilutedViscosity_(dilutedViscosityOf(i, T)),
    viscosity_(viscositySeries(i, T)),
    conductivity_(conductivitySeries(i, T)),
    friction_(T),
    freeVolume_(T),
    saturated_{0, 0, 0}
{
    dilutedConductivity_ = dilutedConductivity();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::titan::saturation& Foam::titan::pureTransport::saturated() const
{
    if (saturated_.p == 0)
    {
        saturated_ = pureSaturation(i_, T_);
    }
    return saturated_;
}


double Foam::titan::pureTransport::viscosity(const fluidState& s) const
{
    const double mu = viscosityOfDensity(s.molarDensity);
    return i_ == CH4 ? mu + methaneFriction(s) : mu;
}


double Foam::titan::pureTransport::viscosity(double molarDensity) const
{
    check(molarDensity);
    if (i_ == CH4 && molarDensity > 0)
    {
        return viscosity(isotherm_.stateAtDensity(molarDensity));
    }
    return viscosityOfDensity(molarDensity);
}


double Foam::titan::pureTransport::conductivity(const fluidState& s) const
{
    const double k = dilutedConductivity_ + conductivity_(s.molarDensity);
    switch (i_)
    {
        case N2:  return k + nitrogenEnhancement(s);
        case CH4: return k + methaneQuadratic(s.molarDensity) + methaneEnhancement(s);
        default:  return k;
    }
}


double Foam::titan::pureTransport::conductivity(double molarDensity) const
{
    check(molarDensity);
    if ((i_ == N2 || i_ == CH4) && molarDensity > 0)
    {
        return conductivity(isotherm_.stateAtDensity(molarDensity));
    }
    return dilutedConductivity_ + conductivity_(molarDensity);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

double Foam::titan::pureViscosity(species i, double T, double rho)
{
    return pureTransport(i, T).viscosity(rho/molarMass(i));
}


double Foam::titan::pureConductivity(species i, double T, double rho)
{
    return pureTransport(i, T).conductivity(rho/molarMass(i));
}


double Foam::titan::pureSurfaceTension(species i, double T)
{
    struct correlation
    {
        double Tc;
        double sigma[3];
        double n[3];
    };
    static const correlation correlations[nSpecies] =
    {
        {126.192, {0.02898, 0, 0}, {1.246, 1, 1}},
        {190.564, {0.03825, -0.006024, -0.0007065}, {1.191, 5.422, 0.6161}},
        {305.322, {0.07602, -0.02912, 0}, {1.32, 1.676, 1}},
        {369.89, {0.05334, -0.01748, 0}, {1.235, 4.404, 1}}
    };
    const correlation& c = correlations[i];
    const double t = 1 - checkedTemperature(i, T)/c.Tc;
    if (t <= 0)
    {
        return 0;
    }
    double sigma = 0;
    for (int k = 0; k < 3; ++k)
    {
        sigma += c.sigma[k]*std::pow(t, c.n[k]);
    }
    return sigma;
}
