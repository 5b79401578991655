// SPDX-License-Identifier: GPL-3.0-or-later
#include "helmholtzMixture.H"
#include "pureFluids.H"
#include "reducingFunctions.H"

#include <cmath>
#include <cstdio>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using namespace Foam::titan;

// CODATA 2018 [J/(mol K)]
constexpr double molarGasConstant = 8.31446261815324;

// Bells below exp(-100) are lost in the round-off of the rest
constexpr double negligibleExponent = 100;

// Relative change of density at which Newton's method stops: the error is then of the order of its square
constexpr double newtonTolerance = 1e-7;

constexpr int maxIterations = 100;


std::string text(const char* format, double a, double b = 0, double c = 0)
{
    char buffer[256];
    std::snprintf(buffer, sizeof buffer, format, a, b, c);
    return buffer;
}


//- Density of the saturated liquid [mol/m3], to 2 %: where Newton's method starts, nothing else
double startingDensity(const composition& x, double T)
{
    // Lines through the reference equations at 91 K and 110 K
    static const double at100K[nSpecies] = {24400, 27350, 21320, 16310};
    static const double slope[nSpecies] = {-178, -86, -36.6, -24};

    double volume = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        volume += x[i]/(at100K[i] + slope[i]*(T - 100));
    }
    return 1/volume;
}


[[noreturn]] void refusePhase(const composition& x, double T, double p, phase ph)
{
    throw thermoError
    (
        thermoError::reason::noSuchPhase,
        text("at %.6g K and %.6g Pa ", T, p) + x.name() + " has no stable " + phaseName(ph)
      + (ph == phase::liquid ? ": the pressure is too low for it" : ": the pressure is too high for it")
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Range  * * * * * * * * * * * * * * * * * //

constexpr double Foam::titan::range::Tmin;
constexpr double Foam::titan::range::Tmax;
constexpr double Foam::titan::range::pMin;
constexpr double Foam::titan::range::pMax;


void Foam::titan::range::checkTemperature(double T)
{
    if (!std::isfinite(T))
    {
        throw thermoError(thermoError::reason::notANumber, "temperature T is not a number");
    }
    if (T < Tmin || T > Tmax)
    {
        throw thermoError
        (
            thermoError::reason::temperatureRange,
            text("temperature T is %.6g K: expected %.6g to %.6g K", T, Tmin, Tmax)
        );
    }
}


void Foam::titan::range::check(double T, double p)
{
    checkTemperature(T);
    if (!std::isfinite(p))
    {
        throw thermoError(thermoError::reason::notANumber, "pressure p is not a number");
    }
    if (p < pMin || p > pMax)
    {
        throw thermoError
        (
            thermoError::reason::pressureRange,
            text("pressure p is %.6g Pa: expected %.6g to %.6g Pa", p, pMin, pMax)
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

int Foam::titan::helmholtzMixture::powerIndex(double t)
{
    int k = 0;
    while (k < nPowers_ && powers_[k] != t)
    {
        ++k;
    }
    if (k == nPowers_)
    {
        powers_[nPowers_++] = t;
    }
    return k;
}


int Foam::titan::helmholtzMixture::groupIndex(const bellGroup& g)
{
    for (int k = 0; k < nGroups_; ++k)
    {
        const bellGroup& other = groups_[k];
        if (other.eta == g.eta && other.epsilon == g.epsilon && other.beta == g.beta && other.gamma == g.gamma)
        {
            return k;
        }
    }
    groups_[nGroups_] = g;
    return nGroups_++;
}


Foam::titan::helmholtzMixture::helmholtzMixture(const composition& x)
:
    x_(x),
    M_(x.molarMass()),
    R_(molarGasConstant)
{
    const reducingFunctions reduced(x.x());
    Tr_ = reduced.T();
    rhor_ = reduced.density();

    auto isEighth = [](double t)
    {
        return t >= 0 && 8*t == std::floor(8*t) && 8*t <= maxEighths;
    };

    // Whole eighths first, then the others
    for (const bool eighths : {true, false})
    {
        auto wanted = [&](double t)
        {
            return isEighth(t) == eighths;
        };
        auto addTerm = [&](double weight, double n, double t, int d, int l)
        {
            terms_[nTerms_++] =
            {
                weight*n, t,
                static_cast<unsigned char>(d), static_cast<unsigned char>(l),
                static_cast<unsigned char>(powerIndex(t))
            };
        };
        auto addBell = [&](double weight, double n, double t, int d, double betaT, double gammaT, const bellGroup& g)
        {
            bells_[nBells_++] =
            {
                weight*n, t, betaT, gammaT,
                static_cast<unsigned char>(d), static_cast<unsigned char>(groupIndex(g)),
                static_cast<unsigned char>(powerIndex(t))
            };
        };

        for (int i = 0; i < nSpecies; ++i)
        {
            if (x[i] == 0)
            {
                continue;
            }
            const pureFluid& fluid = pureFluidOf(i);
            if (x.isPure())
            {
                R_ = fluid.R;
            }
            for (const powerTerm& k : fluid.power)
            {
                if (wanted(k.t))
                {
                    addTerm(x[i], k.n, k.t, k.d, k.l);
                }
            }
            for (const gaussianTerm& k : fluid.gaussian)
            {
                if (wanted(k.t))
                {
                    addBell(x[i], k.n, k.t, k.d, k.beta, k.gamma, {k.eta, k.epsilon, 0, 0});
                }
            }
        }
        for (int pair = 0; pair < nPairs; ++pair)
        {
            const binaryPair& ij = binaryPairOf(pair);
            const double weight = x[ij.i]*x[ij.j];
            if (weight == 0)
            {
                continue;
            }
            for (const departureTerm& k : ij.departure)
            {
                if (!wanted(k.t))
                {
                    continue;
                }
                if (k.eta == 0 && k.beta == 0)
                {
                    addTerm(weight, k.n, k.t, k.d, 0);
                }
                else
                {
                    addBell(weight, k.n, k.t, k.d, 0, 0, {k.eta, k.epsilon, k.beta, k.gamma});
                }
            }
        }
        if (eighths)
        {
            nEighths_ = nPowers_;
        }
    }

    degree_.fill(0);
    for (int k = 0; k < nTerms_; ++k)
    {
        degree_[terms_[k].l] = std::max<int>(degree_[terms_[k].l], terms_[k].d);
    }
}


Foam::titan::helmholtzMixture::isotherm::isotherm(const helmholtzMixture& mixture, double T)
:
    mixture_(mixture),
    T_(T),
    tau_(mixture.Tr_/T)
{
    range::checkTemperature(T);
    const helmholtzMixture& m = mixture_;

    // tau^(k/8) by multiplication: most exponents are whole eighths
    double whole[maxEighths/8 + 1];
    whole[0] = 1;
    for (int k = 1; k <= maxEighths/8; ++k)
    {
        whole[k] = whole[k-1]*tau_;
    }
    double eighths[8];
    eighths[0] = 1;
    eighths[4] = std::sqrt(tau_);
    eighths[2] = std::sqrt(eighths[4]);
    eighths[1] = std::sqrt(eighths[2]);
    eighths[3] = eighths[2]*eighths[1];
    eighths[5] = eighths[4]*eighths[1];
    eighths[6] = eighths[4]*eighths[2];
    eighths[7] = eighths[4]*eighths[3];
    for (int k = 0; k < m.nEighths_; ++k)
    {
        const int n = static_cast<int>(8*m.powers_[k]);
        tauPowers_[k] = whole[n/8]*eighths[n%8];
    }
    const double lnTau = std::log(tau_);
    for (int k = m.nEighths_; k < m.nPowers_; ++k)
    {
        tauPowers_[k] = std::exp(m.powers_[k]*lnTau);
    }

    for (int order = 0; order < 3; ++order)
    {
        for (int l = 0; l < 5; ++l)
        {
            std::fill_n(terms_[order][l], m.degree_[l] + 1, 0.0);
        }
    }
    for (int k = 0; k < m.nTerms_; ++k)
    {
        const term& a = m.terms_[k];
        const double value = a.n*tauPowers_[a.power];
        terms_[0][a.l][a.d] += value;
        terms_[1][a.l][a.d] += a.t*value;
        terms_[2][a.l][a.d] += a.t*(a.t - 1)*value;
    }

    nGroups_ = 0;
    std::array<int, maxGroups> place;
    place.fill(-1);
    for (int k = 0; k < m.nBells_; ++k)
    {
        const bell& a = m.bells_[k];
        const double offset = tau_ - a.gammaT;
        const double exponent = a.betaT*offset*offset;
        if (exponent > negligibleExponent)
        {
            continue;
        }
        int& g = place[a.group];
        if (g < 0)
        {
            g = nGroups_++;
            groups_[g] = m.groups_[a.group];
            for (auto& order : bells_)
            {
                std::fill_n(order[g], maxBellD + 1, 0.0);
            }
        }
        const double value = a.n*tauPowers_[a.power]*(exponent != 0 ? std::exp(-exponent) : 1.0);
        const double slope = a.t - 2*a.betaT*tau_*offset;
        bells_[0][g][a.d] += value;
        bells_[1][g][a.d] += slope*value;
        bells_[2][g][a.d] += (slope*slope - a.t - 2*a.betaT*tau_*tau_)*value;
    }
}


// * * * * * * * * * * * * * * Private Functions  * * * * * * * * * * * * * //

namespace
{

//- sum_d c_d x^d and its derivatives x d/dx and x^2 d2/dx2
struct polynomial
{
    double a, aD, aDD;

    polynomial(const double* c, int degree, double x)
    :
        a(c[degree]),
        aD(0),
        aDD(0)
    {
        for (int d = degree - 1; d >= 0; --d)
        {
            aDD = aDD*x + aD;
            aD = aD*x + a;
            a = a*x + c[d];
        }
        aD *= x;
        aDD *= 2*x*x;
    }
};


//- sum_d c_d x^d
double polynomialValue(const double* c, int degree, double x)
{
    double a = c[degree];
    for (int d = degree - 1; d >= 0; --d)
    {
        a = a*x + c[d];
    }
    return a;
}

} // End anonymous namespace


Foam::titan::helmholtzMixture::isotherm::residual
Foam::titan::helmholtzMixture::isotherm::evaluate(double molarDensity) const
{
    const double delta = molarDensity/mixture_.rhor_;
    residual r{0, 0, 0};

    double powerL = 1;
    for (int l = 0; l < 5; ++l)
    {
        const int degree = mixture_.degree_[l];
        if (degree)
        {
            const polynomial q(terms_[0][l], degree, delta);
            const double h = l ? powerL : 0;
            const double e = l ? std::exp(-h) : 1.0;
            r.a += q.a*e;
            r.aD += (q.aD - l*h*q.a)*e;
            r.aDD += (q.aDD - 2*l*h*q.aD + l*h*(l*h - l + 1)*q.a)*e;
        }
        powerL *= delta;
    }
    for (int g = 0; g < nGroups_; ++g)
    {
        const bellGroup& group = groups_[g];
        const double offset = delta - group.epsilon;
        const double e = std::exp(-group.eta*offset*offset - group.beta*(delta - group.gamma));
        const double slope = -delta*(2*group.eta*offset + group.beta);
        const polynomial q(bells_[0][g], maxBellD, delta);
        r.a += q.a*e;
        r.aD += (q.aD + slope*q.a)*e;
        r.aDD += (q.aDD + 2*slope*q.aD + (slope*slope - 2*group.eta*delta*delta)*q.a)*e;
    }
    return r;
}


void Foam::titan::helmholtzMixture::isotherm::pressure(double molarDensity, double& p, double& dpdrho) const
{
    const residual r = evaluate(molarDensity);
    const double RT = mixture_.R_*T_;
    p = molarDensity*RT*(1 + r.aD);
    dpdrho = RT*(1 + 2*r.aD + r.aDD);
}


double Foam::titan::helmholtzMixture::isotherm::liquidDensity(double p, double guess) const
{
    // The isotherm is convex from the spinodal upwards: Newton's method from the dense side falls towards the root and
    // stays in that branch. A step of a tenth cannot cross the unstable branch, which is wider below 125 K.
    constexpr double longestStep = 0.1;
    constexpr double closeStep = 0.02;

    double value, slope;

    double rho = guess;
    if (guess > 0)
    {
        // A guess counts if it is as good as at the root
        pressure(rho, value, slope);
        if (!(slope > 0 && std::abs(value - p) < closeStep*slope*rho && rho > 0.8*startingDensity(mixture_.x_, T_)))
        {
            guess = 0;
        }
    }
    if (!(guess > 0))
    {
        rho = 1.02*startingDensity(mixture_.x_, T_);
        for (int k = 0; ; ++k)
        {
            pressure(rho, value, slope);
            if (slope > 0 && value >= p)
            {
                break;
            }
            if (k == 20)
            {
                refusePhase(mixture_.x_, T_, p, phase::liquid);
            }
            rho *= 1.03;
        }
    }
    for (int k = 0; k < maxIterations; ++k)
    {
        if (!(slope > 0))
        {
            break;
        }
        const double step = (value - p)/slope;
        if (std::abs(step) < newtonTolerance*rho)
        {
            return rho - step;
        }
        rho -= std::min(step, longestStep*rho);
        pressure(rho, value, slope);
    }
    refusePhase(mixture_.x_, T_, p, phase::liquid);
}


double Foam::titan::helmholtzMixture::isotherm::gasDensity(double p) const
{
    // The isotherm is concave up to the spinodal: Newton's method from the dilute side climbs towards the root
    constexpr double longestStep = 0.25;

    double rho = p/(mixture_.R_*T_);
    for (int k = 0; k < maxIterations; ++k)
    {
        double value, slope;
        pressure(rho, value, slope);
        if (!(slope > 0))
        {
            break;
        }
        const double step = (p - value)/slope;
        if (std::abs(step) < newtonTolerance*rho)
        {
            return rho + step;
        }
        rho += std::min(step, longestStep*rho);
    }
    refusePhase(mixture_.x_, T_, p, phase::gas);
}


double Foam::titan::helmholtzMixture::idealHeatCapacity(double T) const
{
    double sum = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        if (x_[i] == 0)
        {
            continue;
        }
        const pureFluid& fluid = pureFluidOf(i);
        const double tau = fluid.Tc/T;
        double cv = fluid.lnTau;
        for (const oscillator& k : fluid.oscillators)
        {
            const double u = k.theta*tau;
            const double e = std::exp(-u);
            cv += k.n*u*u*e/((1 - e)*(1 - e));
        }
        for (const idealPower& k : fluid.idealPowers)
        {
            cv -= k.n*k.t*(k.t - 1)*std::pow(tau, k.t);
        }
        // The figures are those of the fluid's own gas constant (Kunz and Wagner 2012, eq. 13)
        sum += x_[i]*cv*fluid.R;
    }
    return sum/R_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::titan::helmholtzMixture::isotherm::molarDensity(double p, phase ph, double guess) const
{
    range::check(T_, p);
    return ph == phase::liquid ? liquidDensity(p, guess) : gasDensity(p);
}


Foam::titan::fluidState Foam::titan::helmholtzMixture::isotherm::stateAtDensity(double molarDensity) const
{
    if (!(molarDensity > 0) || !std::isfinite(molarDensity))
    {
        throw thermoError
        (
            std::isnan(molarDensity) ? thermoError::reason::notANumber : thermoError::reason::badEntry,
            text("molar density is %.6g mol/m3: expected more than 0", molarDensity)
        );
    }
    const helmholtzMixture& m = mixture_;
    const double delta = molarDensity/m.rhor_;
    const residual r = evaluate(molarDensity);

    // Derivatives in temperature: tau alphar_tau delta-differentiated, and tau^2 alphar_tautau
    double aDT = 0;
    double aTT = 0;
    double powerL = 1;
    for (int l = 0; l < 5; ++l)
    {
        const int degree = m.degree_[l];
        if (degree)
        {
            const double h = l ? powerL : 0;
            const double e = l ? std::exp(-h) : 1.0;
            const polynomial q(terms_[1][l], degree, delta);
            aDT += (q.aD - l*h*q.a)*e;
            aTT += polynomialValue(terms_[2][l], degree, delta)*e;
        }
        powerL *= delta;
    }
    for (int g = 0; g < nGroups_; ++g)
    {
        const bellGroup& group = groups_[g];
        const double offset = delta - group.epsilon;
        const double e = std::exp(-group.eta*offset*offset - group.beta*(delta - group.gamma));
        const double slope = -delta*(2*group.eta*offset + group.beta);
        const polynomial q(bells_[1][g], maxBellD, delta);
        aDT += (q.aD + slope*q.a)*e;
        aTT += polynomialValue(bells_[2][g], maxBellD, delta)*e;
    }

    const double RT = m.R_*T_;
    const double dpdrho = 1 + 2*r.aD + r.aDD;       // over RT
    const double dpdT = 1 + r.aD - aDT;             // over R rho
    const double cv = m.idealHeatCapacity(T_) - aTT;    // over R
    const double cp = cv + dpdT*dpdT/dpdrho;

    if (!(dpdrho > 0) || !(cv > 0) || !std::isfinite(cp))
    {
        throw thermoError
        (
            thermoError::reason::noSuchPhase,
            text("at %.6g K and %.6g mol/m3 ", T_, molarDensity) + m.x_.name() + " is mechanically unstable"
        );
    }

    fluidState s;
    s.T = T_;
    s.p = molarDensity*RT*(1 + r.aD);
    s.molarDensity = molarDensity;
    s.density = molarDensity*m.M_;
    s.cv = cv*m.R_/m.M_;
    s.cp = cp*m.R_/m.M_;
    s.isothermalBulkModulus = molarDensity*RT*dpdrho;
    s.isentropicBulkModulus = s.isothermalBulkModulus*cp/cv;
    s.soundSpeed = std::sqrt(s.isentropicBulkModulus/s.density);
    s.expansivity = dpdT/(T_*dpdrho);
    return s;
}


Foam::titan::fluidState Foam::titan::helmholtzMixture::isotherm::state(double p, phase ph, double guess) const
{
    fluidState s = stateAtDensity(molarDensity(p, ph, guess));
    s.p = p;
    return s;
}


double Foam::titan::helmholtzMixture::molarDensity(double T, double p, phase ph, double guess) const
{
    range::check(T, p);
    return isotherm(*this, T).molarDensity(p, ph, guess);
}


Foam::titan::fluidState Foam::titan::helmholtzMixture::state(double T, double p, phase ph, double guess) const
{
    range::check(T, p);
    return isotherm(*this, T).state(p, ph, guess);
}


Foam::titan::fluidState Foam::titan::helmholtzMixture::stateAtDensity(double T, double molarDensity) const
{
    return isotherm(*this, T).stateAtDensity(molarDensity);
}
