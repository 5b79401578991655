// SPDX-License-Identifier: GPL-3.0-or-later
#include "helmholtzMixture.H"
#include "pureFluids.H"
#include "reducingFunctions.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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


void checkWithin(const char* name, double value, const char* unit, double low, double high, thermoError::reason why)
{
    if (!std::isfinite(value))
    {
        throw thermoError(thermoError::reason::notANumber, std::string(name) + " is not a number");
    }
    if (value < low || value > high)
    {
        throw thermoError
        (
            why,
            std::string(name) + formatted(" is %.6g ", value) + unit + formatted(": expected %.6g to %.6g ", low, high) + unit
        );
    }
}


[[noreturn]] void refusePhase(const composition& x, double T, double p, phase ph)
{
    throw thermoError
    (
        thermoError::reason::noSuchPhase,
        formatted("at %.6g K and %.6g Pa ", T, p) + x.name() + " has no stable " + phaseName(ph)
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
    checkWithin("temperature T", T, "K", Tmin, Tmax, thermoError::reason::temperatureRange);
}


void Foam::titan::range::check(double T, double p)
{
    checkTemperature(T);
    checkWithin("pressure p", p, "Pa", pMin, pMax, thermoError::reason::pressureRange);
}


// * * * * * * * * * * * * * * * * Term Table  * * * * * * * * * * * * * * * //

struct Foam::titan::helmholtzMixture::termTable
{
    typedef isotherm::bell bell;

    //- n delta^d tau^t exp(-delta^l), times the weight of its owner
    struct power
    {
        double n;
        double t;
        unsigned char d;
        unsigned char l;
        unsigned char tauPower;
        unsigned char owner;
    };

    //- n delta^d tau^t bell(delta) exp(-beta (tau - gamma)^2), times the weight of its owner
    struct bellTerm
    {
        double n;
        double t;
        double beta;
        double gamma;
        unsigned char d;
        unsigned char bell;
        unsigned char tauPower;
        unsigned char owner;
    };

    //- Highest whole exponent of tau that is formed by multiplication
    static constexpr int maxWhole = 28;

    std::vector<power> powers;
    std::vector<bellTerm> bellTerms;
    std::vector<bell> bells;

    //- Distinct exponents of tau: the whole eighths, up to maxWhole, first
    std::vector<double> exponents;
    int nEighths = 0;

    //- Highest power of delta, by l
    std::array<int, 5> degree{};

    //- present: bit i is set where fluid i is there
    explicit termTable(unsigned present);

    //- The table of these fluids
    static const termTable& of(const composition& x);


private:

    int place(double exponent)
    {
        const auto found = std::find(exponents.begin(), exponents.end(), exponent);
        const int k = found - exponents.begin();
        if (found == exponents.end())
        {
            exponents.push_back(exponent);
        }
        return k;
    }

    int place(const bell& b)
    {
        const auto found = std::find_if
        (
            bells.begin(), bells.end(),
            [&](const bell& a)
            {
                return a.eta == b.eta && a.epsilon == b.epsilon && a.beta == b.beta && a.gamma == b.gamma;
            }
        );
        const int k = found - bells.begin();
        if (found == bells.end())
        {
            bells.push_back(b);
        }
        return k;
    }

    void add(double n, double t, int d, int l, int owner)
    {
        const int tauPower = place(t);
        powers.push_back({n, t, uchar(d), uchar(l), uchar(tauPower), uchar(owner)});
        degree[l] = std::max(degree[l], d);
    }

    void add(double n, double t, int d, double beta, double gamma, const bell& b, int owner)
    {
        const int tauPower = place(t);
        bellTerms.push_back({n, t, beta, gamma, uchar(d), uchar(place(b)), uchar(tauPower), uchar(owner)});
    }

    static unsigned char uchar(int i)
    {
        return static_cast<unsigned char>(i);
    }
};


Foam::titan::helmholtzMixture::termTable::termTable(unsigned present)
{
    auto isPresent = [=](int i)
    {
        return (present >> i) & 1;
    };
    auto isEighth = [](double t)
    {
        return t >= 0 && t <= maxWhole && 8*t == std::floor(8*t);
    };

    for (const bool eighths : {true, false})
    {
        for (int i = 0; i < nSpecies; ++i)
        {
            if (!isPresent(i))
            {
                continue;
            }
            const pureFluid& fluid = pureFluidOf(i);
            for (const powerTerm& k : fluid.power)
            {
                if (isEighth(k.t) == eighths)
                {
                    add(k.n, k.t, k.d, k.l, i);
                }
            }
            for (const gaussianTerm& k : fluid.gaussian)
            {
                if (isEighth(k.t) == eighths)
                {
                    add(k.n, k.t, k.d, k.beta, k.gamma, bell{k.eta, k.epsilon, 0, 0}, i);
                }
            }
        }
        for (int pair = 0; pair < nPairs; ++pair)
        {
            const binaryPair& ij = binaryPairOf(pair);
            if (!isPresent(ij.i) || !isPresent(ij.j))
            {
                continue;
            }
            for (const departureTerm& k : ij.departure)
            {
                if (isEighth(k.t) != eighths)
                {
                    continue;
                }
                if (k.eta == 0 && k.beta == 0)
                {
                    add(k.n, k.t, k.d, 0, nSpecies + pair);
                }
                else
                {
                    add(k.n, k.t, k.d, 0, 0, bell{k.eta, k.epsilon, k.beta, k.gamma}, nSpecies + pair);
                }
            }
        }
        if (eighths)
        {
            nEighths = exponents.size();
        }
    }
}


const Foam::titan::helmholtzMixture::termTable& Foam::titan::helmholtzMixture::termTable::of(const composition& x)
{
    static const std::vector<termTable> tables = []
    {
        std::vector<termTable> all;
        for (unsigned present = 0; present < (1u << nSpecies); ++present)
        {
            all.emplace_back(present);
            if
            (
                all.back().exponents.size() > isotherm::maxPowers
             || all.back().bells.size() > isotherm::maxGroups
             || *std::max_element(all.back().degree.begin(), all.back().degree.end()) > isotherm::maxD
            )
            {
                throw std::logic_error("helmholtzMixture: more terms than an isotherm has room for");
            }
        }
        return all;
    }();

    unsigned present = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        present |= unsigned(x[i] > 0) << i;
    }
    return tables[present];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::titan::helmholtzMixture::helmholtzMixture(const composition& x)
:
    x_(x),
    M_(x.molarMass()),
    R_(molarGasConstant),
    table_(&termTable::of(x))
{
    static_assert(nPairs == 6, "one weight for each pair");

    const reducingFunctions reduced(x.x());
    Tr_ = reduced.T();
    rhor_ = reduced.density();

    for (int i = 0; i < nSpecies; ++i)
    {
        weights_[i] = x[i];
        if (x[i] == 1)
        {
            R_ = pureFluidOf(i).R;
        }
    }
    for (int pair = 0; pair < nPairs; ++pair)
    {
        weights_[nSpecies + pair] = x[binaryPairOf(pair).i]*x[binaryPairOf(pair).j];
    }
}


Foam::titan::helmholtzMixture::isotherm::isotherm(const helmholtzMixture& mixture, double T, bool check)
:
    mixture_(mixture),
    T_(T),
    tau_(mixture.Tr_/T)
{
    if (check)
    {
        range::checkTemperature(T);
    }
    const termTable& table = *mixture_.table_;

    // tau^(k/8) by multiplication: most exponents are whole eighths
    double whole[termTable::maxWhole + 1];
    whole[0] = 1;
    for (int k = 1; k <= termTable::maxWhole; ++k)
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
    for (int k = 0; k < table.nEighths; ++k)
    {
        const int n = static_cast<int>(8*table.exponents[k]);
        tauPowers_[k] = whole[n/8]*eighths[n%8];
    }
    const double lnTau = std::log(tau_);
    const int nExponents = table.exponents.size();
    for (int k = table.nEighths; k < nExponents; ++k)
    {
        tauPowers_[k] = std::exp(table.exponents[k]*lnTau);
    }

    for (auto& order : powers_)
    {
        for (int l = 0; l < 5; ++l)
        {
            std::fill_n(order[l], table.degree[l] + 1, 0.0);
        }
    }
    for (const termTable::power& a : table.powers)
    {
        const double value = mixture_.weights_[a.owner]*a.n*tauPowers_[a.tauPower];
        powers_[0][a.l][a.d] += value;
        powers_[1][a.l][a.d] += a.t*value;
        powers_[2][a.l][a.d] += a.t*(a.t - 1)*value;
    }

    nBells_ = 0;
    int placeOf[maxGroups];
    std::fill_n(placeOf, maxGroups, -1);
    for (const termTable::bellTerm& a : table.bellTerms)
    {
        const double offset = tau_ - a.gamma;
        const double exponent = a.beta*offset*offset;
        if (exponent > negligibleExponent)
        {
            continue;
        }
        int& k = placeOf[a.bell];
        if (k < 0)
        {
            k = nBells_++;
            bells_[k] = table.bells[a.bell];
            for (auto& order : bellPowers_)
            {
                std::fill_n(order[k], maxBellD + 1, 0.0);
            }
        }
        const double value =
            mixture_.weights_[a.owner]*a.n*tauPowers_[a.tauPower]*(exponent != 0 ? std::exp(-exponent) : 1.0);
        const double slope = a.t - 2*a.beta*tau_*offset;
        bellPowers_[0][k][a.d] += value;
        bellPowers_[1][k][a.d] += slope*value;
        bellPowers_[2][k][a.d] += (slope*slope - a.t - 2*a.beta*tau_*tau_)*value;
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
        const int degree = mixture_.table_->degree[l];
        if (degree)
        {
            const polynomial q(powers_[0][l], degree, delta);
            const double h = l ? powerL : 0;
            const double e = l ? std::exp(-h) : 1.0;
            r.a += q.a*e;
            r.aD += (q.aD - l*h*q.a)*e;
            r.aDD += (q.aDD - 2*l*h*q.aD + l*h*(l*h - l + 1)*q.a)*e;
        }
        powerL *= delta;
    }
    for (int k = 0; k < nBells_; ++k)
    {
        const bell& b = bells_[k];
        const double offset = delta - b.epsilon;
        const double e = std::exp(-b.eta*offset*offset - b.beta*(delta - b.gamma));
        const double slope = -delta*(2*b.eta*offset + b.beta);
        const polynomial q(bellPowers_[0][k], maxBellD, delta);
        r.a += q.a*e;
        r.aD += (q.aD + slope*q.a)*e;
        r.aDD += (q.aDD + 2*slope*q.aD + (slope*slope - 2*b.eta*delta*delta)*q.a)*e;
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


template<class End>
void Foam::titan::helmholtzMixture::isotherm::checkBranch(double root, double p, phase ph, const End& isEnd) const
{
    // Between the spinodals the reference equations oscillate, through further roots at which the pressure rises. On the
    // branch of a phase the slope rises all the way from the root to the dense end (liquid) or to the dilute end (gas).
    constexpr double shortestStep = 5e-4;
    constexpr double longestStep = 0.01;
    constexpr double growth = 1.5;

    double rho = root;
    double value, slope;
    pressure(rho, value, slope);
    double lastSlope = 0;
    for (double step = shortestStep; slope > lastSlope; step = std::min(growth*step, longestStep))
    {
        if (isEnd(rho, slope))
        {
            // The equations may lose their meaning in the last per cents before the spinodal
            stateAtRoot(root);
            return;
        }
        lastSlope = slope;
        rho *= ph == phase::liquid ? 1 + step : 1 - step;
        pressure(rho, value, slope);
    }
    refusePhase(mixture_.x_, T_, p, ph);
}


double Foam::titan::helmholtzMixture::isotherm::liquidDensity(double p, double guess) const
{
    // The isotherm is convex from the spinodal upwards: Newton's method from the dense side falls towards the root, and
    // where the slope rises again the spinodal has been crossed
    constexpr double longestStep = 0.1;
    constexpr double closeStep = 0.02;

    // Reduced slope above which nothing of the unstable region is met. It is 9 at nitrogen's boiling point, 30 and more
    // in lakes, and 4 or less in every saturated liquid that a positive pressure can bring to its spinodal.
    const double steepSlope = 8*mixture_.R_*T_;

    double value, slope;

    double rho = guess;
    if (guess > 0)
    {
        // A guess counts if it is as good as at the root
        pressure(rho, value, slope);
        if
        (
           !(
                slope > steepSlope
             && std::abs(value - p) < closeStep*slope*rho
             && rho > 0.8*startingDensity(mixture_.x_, T_)
            )
        )
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
    double lastSlope = std::numeric_limits<double>::infinity();
    for (int k = 0; k < maxIterations; ++k)
    {
        if (!(slope > 0) || slope > lastSlope*(1 + newtonTolerance))
        {
            break;
        }
        const double step = (value - p)/slope;
        if (std::abs(step) < newtonTolerance*rho)
        {
            rho -= step;
            if (slope < steepSlope)
            {
                checkBranch(rho, p, phase::liquid, [=](double, double s){return s > steepSlope;});
            }
            return rho;
        }
        // From a guess on the thin side the first step climbs
        lastSlope = step > 0 ? slope : std::numeric_limits<double>::infinity();
        rho -= std::min(step, longestStep*rho);
        pressure(rho, value, slope);
    }
    refusePhase(mixture_.x_, T_, p, phase::liquid);
}


double Foam::titan::helmholtzMixture::isotherm::gasDensity(double p) const
{
    // The isotherm is concave up to the spinodal: Newton's method from the dilute side climbs towards the root, and where
    // the slope rises again the spinodal has been crossed
    constexpr double longestStep = 0.15;

    // The gas is stable up to here at every temperature
    constexpr double diluteDelta = 0.02;

    // The slope halves well before the spinodal: farther away than the longest step
    const double flatSlope = 0.5*mixture_.R_*T_;

    double rho = std::min(p/(mixture_.R_*T_), diluteDelta*mixture_.rhor_);
    double lastSlope = std::numeric_limits<double>::infinity();
    for (int k = 0; k < maxIterations; ++k)
    {
        double value, slope;
        pressure(rho, value, slope);
        if (!(slope > 0) || slope > lastSlope*(1 + newtonTolerance))
        {
            break;
        }
        lastSlope = slope;
        const double step = (p - value)/slope;
        if (std::abs(step) < newtonTolerance*rho)
        {
            rho += step;
            if (slope < flatSlope)
            {
                const double dilute = diluteDelta*mixture_.rhor_;
                checkBranch(rho, p, phase::gas, [=](double r, double){return r < dilute;});
            }
            return rho;
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
    return ph == phase::liquid ? liquidDensity(p, guess) : gasDensity(p);
}


Foam::titan::fluidState Foam::titan::helmholtzMixture::isotherm::stateAtRoot(double molarDensity) const
{
    const helmholtzMixture& m = mixture_;
    const double delta = molarDensity/m.rhor_;
    const residual r = evaluate(molarDensity);

    // Derivatives in temperature: tau alphar_tau delta-differentiated, and tau^2 alphar_tautau
    double aDT = 0;
    double aTT = 0;
    double powerL = 1;
    for (int l = 0; l < 5; ++l)
    {
        const int degree = m.table_->degree[l];
        if (degree)
        {
            const double h = l ? powerL : 0;
            const double e = l ? std::exp(-h) : 1.0;
            const polynomial q(powers_[1][l], degree, delta);
            aDT += (q.aD - l*h*q.a)*e;
            aTT += polynomialValue(powers_[2][l], degree, delta)*e;
        }
        powerL *= delta;
    }
    for (int k = 0; k < nBells_; ++k)
    {
        const bell& b = bells_[k];
        const double offset = delta - b.epsilon;
        const double e = std::exp(-b.eta*offset*offset - b.beta*(delta - b.gamma));
        const double slope = -delta*(2*b.eta*offset + b.beta);
        const polynomial q(bellPowers_[1][k], maxBellD, delta);
        aDT += (q.aD + slope*q.a)*e;
        aTT += polynomialValue(bellPowers_[2][k], maxBellD, delta)*e;
    }

    const double RT = m.R_*T_;
    const double dpdrho = 1 + 2*r.aD + r.aDD;       // over RT
    const double dpdT = 1 + r.aD - aDT;             // over R rho
    const double idealCv = m.idealHeatCapacity(T_);     // over R
    const double cv = idealCv - aTT;                    // over R
    const double cp = cv + dpdT*dpdT/dpdrho;

    auto refuse = [&](const char* why)
    {
        throw thermoError
        (
            thermoError::reason::noSuchPhase,
            formatted("at %.6g K and %.6g mol/m3 ", T_, molarDensity) + m.x_.name() + why
        );
    };
    if (!(dpdrho > 0))
    {
        refuse(" is mechanically unstable");
    }
    // Attraction only adds to the heat capacity: less than the ideal gas has comes of an equation beyond its range
    if (!(cv > 0.99*idealCv) || !std::isfinite(cp))
    {
        refuse(" is beyond what the equation of state describes: the heat capacity falls below that of the ideal gas");
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


Foam::titan::fluidState Foam::titan::helmholtzMixture::isotherm::stateAtDensity(double molarDensity) const
{
    if (!(molarDensity > 0) || !std::isfinite(molarDensity))
    {
        throw thermoError
        (
            std::isnan(molarDensity) ? thermoError::reason::notANumber : thermoError::reason::badEntry,
            formatted("molar density is %.6g mol/m3: expected more than 0", molarDensity)
        );
    }

    // Between the branches the equations have further densities at which the pressure rises: none is a state
    double p, slope;
    pressure(molarDensity, p, slope);
    for (const phase ph : {phase::liquid, phase::gas})
    {
        try
        {
            if (std::abs(this->molarDensity(p, ph)/molarDensity - 1) < newtonTolerance)
            {
                return stateAtRoot(molarDensity);
            }
        }
        catch (const thermoError&)
        {}
    }
    throw thermoError
    (
        thermoError::reason::noSuchPhase,
        formatted("at %.6g K and %.6g mol/m3 ", T_, molarDensity) + mixture_.x_.name() + " is neither liquid nor gas"
    );
}


Foam::titan::fluidState Foam::titan::helmholtzMixture::isotherm::state(double p, phase ph, double guess) const
{
    fluidState s = stateAtRoot(molarDensity(p, ph, guess));
    s.p = p;
    return s;
}


Foam::titan::composition::fractions
Foam::titan::helmholtzMixture::isotherm::lnFugacityCoefficients(double molarDensity, double p) const
{
    const helmholtzMixture& m = mixture_;
    const termTable& table = *m.table_;
    const double delta = molarDensity/m.rhor_;

    double deltaPowers[maxD + 1];
    deltaPowers[0] = 1;
    for (int d = 1; d <= maxD; ++d)
    {
        deltaPowers[d] = deltaPowers[d-1]*delta;
    }
    const double decay[5] =
    {
        1, std::exp(-deltaPowers[1]), std::exp(-deltaPowers[2]), std::exp(-deltaPowers[3]), std::exp(-deltaPowers[4])
    };

    // The parts of alphar, weighted, by fluid and pair; those of delta dalphar/ddelta and tau dalphar/dtau in all
    double parts[nSpecies + nPairs] = {};
    double aD = 0;
    double aT = 0;
    for (const termTable::power& a : table.powers)
    {
        const double value =
            m.weights_[a.owner]*a.n*tauPowers_[a.tauPower]*deltaPowers[a.d]*decay[a.l];
        parts[a.owner] += value;
        aD += (a.d - (a.l ? a.l*deltaPowers[a.l] : 0))*value;
        aT += a.t*value;
    }
    double bellValues[maxGroups];
    const int nBells = table.bells.size();
    for (int k = 0; k < nBells; ++k)
    {
        const bell& b = table.bells[k];
        const double offset = delta - b.epsilon;
        bellValues[k] = std::exp(-b.eta*offset*offset - b.beta*(delta - b.gamma));
    }
    for (const termTable::bellTerm& a : table.bellTerms)
    {
        const double tauOffset = tau_ - a.gamma;
        const double exponent = a.beta*tauOffset*tauOffset;
        if (exponent > negligibleExponent)
        {
            continue;
        }
        const bell& b = table.bells[a.bell];
        const double value =
            m.weights_[a.owner]*a.n*tauPowers_[a.tauPower]*deltaPowers[a.d]*bellValues[a.bell]
           *(exponent != 0 ? std::exp(-exponent) : 1.0);
        parts[a.owner] += value;
        aD += (a.d - delta*(2*b.eta*(delta - b.epsilon) + b.beta))*value;
        aT += (a.t - 2*a.beta*tau_*tauOffset)*value;
    }

    // alphar, and sum_k x_k dalphar/dx_k
    double a = 0;
    double sum = 0;
    composition::fractions slope{};
    for (int i = 0; i < nSpecies; ++i)
    {
        a += parts[i];
        sum += parts[i];
        slope[i] += parts[i];
    }
    for (int pair = 0; pair < nPairs; ++pair)
    {
        const double part = parts[nSpecies + pair];
        a += part;
        sum += 2*part;
        slope[binaryPairOf(pair).i] += part;
        slope[binaryPairOf(pair).j] += part;
    }

    const reducingFunctions reduced(m.x_.x());
    const double lnZ = std::log(p/(molarDensity*m.R_*T_));
    composition::fractions lnPhi;
    for (int i = 0; i < nSpecies; ++i)
    {
        lnPhi[i] = m.x_[i] > 0
          ? a
          + aD*(1 - reduced.molarDlnDensity(i, m.x_.x()))
          + aT*reduced.molarDlnT(i, m.x_.x())
          + slope[i]/m.x_[i] - sum
          - lnZ
          : std::numeric_limits<double>::quiet_NaN();
    }
    return lnPhi;
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
