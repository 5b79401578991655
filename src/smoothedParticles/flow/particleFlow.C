// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleFlow.H"
#include "smoothingKernels.H"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using namespace Foam::smoothedParticles;

// Search radius beyond the support, over the spacing: larger is slower to sum, and searched more seldom
constexpr double skinRatio = 0.3;

// Every so many particles have their neighbours counted
constexpr int countedShare = 64;


[[noreturn]] void refuse(const std::string& entry, double value, const char* expected)
{
    std::ostringstream message;
    message << entry << " is " << value << ": expected " << expected;
    throw std::invalid_argument(message.str());
}


void checkPositive(const std::string& entry, double value)
{
    if (!(value > 0) || !std::isfinite(value))
    {
        refuse(entry, value, "a number above 0");
    }
}


void checkNotNegative(const std::string& entry, double value)
{
    if (!(value >= 0) || !std::isfinite(value))
    {
        refuse(entry, value, "0 or above");
    }
}


//- p = B ((rho/rho0)^gamma - 1)
class MurnaghanPressure
{
    double rho0_;
    double gamma_;
    double B_;


public:

    MurnaghanPressure(double rho0, double c0, double gamma)
    :
        rho0_(rho0),
        gamma_(gamma),
        B_(rho0*c0*c0/gamma)
    {}

    //- p [Pa] of rho - rho0 [kg/m3]
    double pressure(double density) const
    {
        return B_*std::expm1(gamma_*std::log1p(density/rho0_));
    }

    //- rho - rho0 [kg/m3] of p [Pa]
    double density(double p) const
    {
        return rho0_*std::expm1(std::log1p(p/B_)/gamma_);
    }

    //- Internal energy [J/kg]: the integral of p/rho^2 from rho0
    double energy(double density) const
    {
        const double lnRatio = std::log1p(density/rho0_);
        return B_/rho0_*(std::expm1((gamma_ - 1)*lnRatio)/(gamma_ - 1) + std::expm1(-lnRatio));
    }
};


template<class Real, int dim>
class flowIn
:
    public particleFlow<dim>
{
    typedef packedParticles<Real, dim> fields;
    typedef std::array<double, dim> vector;

    const particleFlowModel<dim> model_;
    const int nThreads_;
    const MurnaghanPressure state_;
    const interaction<Real, dim> interaction_;

    //- spacing^dim, the volume of a particle of a wall [m3]
    const double cell_;

    double time_;

    // In the order in which the particles are in memory

        std::vector<std::int32_t> original_;
        std::vector<std::int32_t> wall_;
        std::vector<unsigned char> passive_;
        std::vector<vector> x_, v_;
        std::vector<double> density_, mass_;

        //- At the start of the step
        std::vector<vector> xOld_, vOld_;
        std::vector<double> densityOld_;

        //- Where each was when neighbours were last searched, and its place among the clusters
        std::vector<vector> xSearched_;
        std::vector<std::int32_t> place_;

    clusterNeighbours<dim> neighbours_;
    fields packed_;

    //- Origin of the packed positions: single precision counts from the middle
    vector middle_;

    double maxSpeed_ = 0;
    double maxAcceleration_ = 0;

    long nSearches_ = 0;
    double pairsPerSum_ = 0;
    double nPairs_ = 0;
    double nParticleSteps_ = 0;
    std::size_t nFluid_ = 0;


    //- Bring an array into a new order
    template<class T>
    static void reorder(std::vector<T>& values, const std::vector<std::int32_t>& order, std::vector<T>& spare)
    {
        spare.clear();
        for (const std::int32_t k : order)
        {
            if (k >= 0)
            {
                spare.push_back(values[k]);
            }
        }
        values.swap(spare);
    }

    bool isFluid(std::size_t k) const
    {
        return wall_[k] == particleState<dim>::fluid;
    }

    double supportRadius() const
    {
        return supportRatio*model_.interaction.h;
    }

    void search()
    {
        neighbours_.sort(x_, model_.spacing);
        const std::vector<std::int32_t>& order = neighbours_.order();
        reorder(original_, order, place_);
        reorder(wall_, order, place_);
        reorder(x_, order, xOld_);
        reorder(v_, order, vOld_);
        reorder(density_, order, densityOld_);
        reorder(mass_, order, densityOld_);
        neighbours_.renumber();
        passive_.resize(x_.size());
        for (std::size_t k = 0; k < x_.size(); ++k)
        {
            passive_[k] = !isFluid(k);
        }
        neighbours_.search(x_, passive_, supportRadius() + skinRatio*model_.spacing, nThreads_);

        place_.resize(x_.size());
        packed_.resize(neighbours_.size());
        middle_.fill(0);
        for (std::size_t i = 0; i < order.size(); ++i)
        {
            const std::int32_t k = order[i];
            if (k >= 0)
            {
                place_[k] = i;
                packed_.contents[i] = isFluid(k) ? fields::content::fluid : fields::content::wall;
                packed_(i, fields::share) = isFluid(k) ? 1 : 0;
                for (int d = 0; d < dim; ++d)
                {
                    middle_[d] += x_[k][d]/x_.size();
                }
            }
        }
        xSearched_ = x_;
        ++nSearches_;
        countPairs();
    }

    //- Pairs inside the support of one sum over all particles of the fluid, from some of them
    void countPairs()
    {
        double pairs = 0;
        double counted = 0;
        const double radius2 = supportRadius()*supportRadius();
        for (std::size_t k = 0; k < x_.size(); k += countedShare)
        {
            if (!isFluid(k))
            {
                continue;
            }
            ++counted;
            for (auto c = neighbours_.begin(place_[k]); c != neighbours_.end(place_[k]); ++c)
            {
                for (int lane = 0; lane < clusterSize; ++lane)
                {
                    const std::int32_t j = neighbours_.order()[*c*clusterSize + lane];
                    if (j < 0 || std::size_t(j) == k)
                    {
                        continue;
                    }
                    double r2 = 0;
                    for (int d = 0; d < dim; ++d)
                    {
                        r2 += (x_[j][d] - x_[k][d])*(x_[j][d] - x_[k][d]);
                    }
                    pairs += r2 < radius2;
                }
            }
        }
        pairsPerSum_ = counted > 0 ? pairs/counted*nFluid_ : 0;
    }

    //- Rates of change of the fluid as it is now
    void evaluate()
    {
        const std::int64_t n = x_.size();

        #pragma omp parallel for num_threads(nThreads_) schedule(static)
        for (std::int64_t k = 0; k < n; ++k)
        {
            const std::size_t i = place_[k];
            for (int d = 0; d < dim; ++d)
            {
                packed_(i, fields::x + d) = x_[k][d] - middle_[d];
                packed_(i, fields::v + d) = v_[k][d];
            }
            packed_(i, fields::density) = density_[k];
            packed_(i, fields::volume) = isFluid(k) ? mass_[k]/(model_.rho0 + density_[k]) : cell_;
            packed_(i, fields::pressure) = state_.pressure(density_[k]);
        }

        interaction_.extrapolate(neighbours_, packed_, nThreads_);
        #pragma omp parallel for num_threads(nThreads_) schedule(static)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k))
            {
                continue;
            }
            const std::size_t i = place_[k];
            const double p = packed_.wallPressure[i];
            density_[k] = state_.density(p);
            packed_(i, fields::density) = density_[k];
            packed_(i, fields::pressure) = p;
            for (int d = 0; d < dim; ++d)
            {
                packed_(i, fields::v + d) = packed_.wallVelocity[d][i];
            }
        }

        interaction_.sum(neighbours_, packed_, nThreads_);
        nPairs_ += pairsPerSum_;
    }

    //- Acceleration of a particle of the fluid with gravity [m/s2]
    double acceleration(std::size_t k, int d) const
    {
        return packed_.acceleration[d][place_[k]] + model_.interaction.g[d];
    }

    double rate(std::size_t k) const
    {
        return packed_.densityRate[place_[k]];
    }

    //- Largest speed and acceleration; throws where a number is not finite
    void checkFields()
    {
        double speed2 = 0;
        double acceleration2 = 0;
        const std::int64_t n = x_.size();
        std::int64_t broken = n;

        #pragma omp parallel for num_threads(nThreads_) schedule(static) \
            reduction(max: speed2, acceleration2) reduction(min: broken)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (!isFluid(k))
            {
                continue;
            }
            double v2 = 0;
            double a2 = 0;
            for (int d = 0; d < dim; ++d)
            {
                v2 += v_[k][d]*v_[k][d];
                a2 += acceleration(k, d)*acceleration(k, d);
            }
            speed2 = std::max(speed2, v2);
            acceleration2 = std::max(acceleration2, a2);
            if (!std::isfinite(v2 + a2 + density_[k] + rate(k)))
            {
                broken = std::min(broken, k);
            }
        }
        if (broken < n)
        {
            std::ostringstream message;
            message << "particle " << original_[broken] << " at (";
            for (int d = 0; d < dim; ++d)
            {
                message << (d ? " " : "") << x_[broken][d];
            }
            message << ") m has a velocity, density or rate that is not a number at " << time_ << " s";
            throw std::runtime_error(message.str());
        }
        maxSpeed_ = std::sqrt(speed2);
        maxAcceleration_ = std::sqrt(acceleration2);
    }

    //- Has a particle moved so far that a neighbour may be missing by the end of a step that moves it this far?
    bool isStale(double ahead) const
    {
        const double allowed = 0.5*skinRatio*model_.spacing - ahead;
        if (allowed <= 0)
        {
            return true;
        }
        double farthest2 = 0;
        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static) reduction(max: farthest2)
        for (std::int64_t k = 0; k < n; ++k)
        {
            double moved2 = 0;
            for (int d = 0; d < dim; ++d)
            {
                moved2 += (x_[k][d] - xSearched_[k][d])*(x_[k][d] - xSearched_[k][d]);
            }
            farthest2 = std::max(farthest2, moved2);
        }
        return farthest2 > allowed*allowed;
    }


public:

    flowIn(const particleState<dim>& start, const particleFlowModel<dim>& model, int nThreads)
    :
        model_(model),
        nThreads_(nThreads),
        state_(model.rho0, model.interaction.c0, model.interaction.gamma),
        interaction_(model.interaction),
        cell_(std::pow(model.spacing, dim)),
        time_(start.time),
        wall_(start.wall),
        x_(start.x),
        v_(start.v),
        density_(start.density),
        mass_(start.mass)
    {
        packed_.rho0 = model.rho0;
        for (std::size_t k = mass_.size(); k < density_.size(); ++k)
        {
            mass_.push_back((model.rho0 + density_[k])*cell_);
        }
        original_.resize(x_.size());
        for (std::size_t k = 0; k < x_.size(); ++k)
        {
            original_[k] = k;
            nFluid_ += isFluid(k);
        }
        search();
        evaluate();
        checkFields();
    }

    double time() const override
    {
        return time_;
    }

    double stableTimeStep() const override
    {
        const double h = model_.interaction.h;
        double step = h/(model_.interaction.c0 + maxSpeed_);
        if (maxAcceleration_ > 0)
        {
            step = std::min(step, std::sqrt(h/maxAcceleration_));
        }
        if (model_.interaction.viscosity == viscosityType::laminar && model_.interaction.mu > 0)
        {
            // Morris et al. 1997, eq. 22, whose factor of 0.125 is the Courant number's 0.2 here
            step = std::min(step, 0.6*h*h*model_.rho0/model_.interaction.mu);
        }
        return model_.Courant*step;
    }

    void advance(double deltaT) override
    {
        if (!(deltaT > 0) || !std::isfinite(deltaT))
        {
            refuse("time step", deltaT, "a number above 0");
        }
        if (isStale((maxSpeed_ + maxAcceleration_*deltaT)*deltaT))
        {
            search();
        }
        evaluate();

        const std::int64_t n = x_.size();
        xOld_ = x_;
        vOld_ = v_;
        densityOld_ = density_;
        const double half = 0.5*deltaT;

        #pragma omp parallel for num_threads(nThreads_) schedule(static)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k))
            {
                density_[k] += half*rate(k);
                for (int d = 0; d < dim; ++d)
                {
                    x_[k][d] += half*v_[k][d];
                    v_[k][d] += half*acceleration(k, d);
                }
            }
        }
        evaluate();

        #pragma omp parallel for num_threads(nThreads_) schedule(static)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k))
            {
                const double growth = deltaT*rate(k)/(model_.rho0 + density_[k]);
                const double rho = (model_.rho0 + densityOld_[k])*(2 + growth)/(2 - growth);
                density_[k] = rho - model_.rho0;
                for (int d = 0; d < dim; ++d)
                {
                    v_[k][d] = vOld_[k][d] + deltaT*acceleration(k, d);
                    x_[k][d] = xOld_[k][d] + half*(vOld_[k][d] + v_[k][d]);
                }
            }
        }
        time_ += deltaT;
        nParticleSteps_ += nFluid_;
        checkFields();
    }

    particleState<dim> state() const override
    {
        particleState<dim> s;
        s.time = time_;
        s.x.resize(x_.size());
        s.v.resize(x_.size());
        s.density.resize(x_.size());
        s.mass.resize(x_.size());
        s.pressure.resize(x_.size());
        s.wall.resize(x_.size());
        for (std::size_t k = 0; k < x_.size(); ++k)
        {
            const std::int32_t i = original_[k];
            s.x[i] = x_[k];
            s.v[i] = v_[k];
            s.density[i] = density_[k];
            s.mass[i] = mass_[k];
            s.pressure[i] = state_.pressure(density_[k]);
            s.wall[i] = wall_[k];
        }
        return s;
    }

    std::vector<vector> wallForces() const override
    {
        const interactionModel& m = model_.interaction;
        const double h = m.h;
        std::vector<vector> forces;
        const std::int32_t last = wall_.empty() ? -1 : *std::max_element(wall_.begin(), wall_.end());
        vector zero;
        zero.fill(0);
        forces.assign(last + 1, zero);

        auto packed = [this](std::size_t place, int field)
        {
            return static_cast<double>(packed_(place, field));
        };
        for (std::size_t k = 0; k < x_.size(); ++k)
        {
            if (!isFluid(k))
            {
                continue;
            }
            const std::size_t i = place_[k];
            for (auto c = neighbours_.begin(i); c != neighbours_.end(i); ++c)
            {
                for (int lane = 0; lane < clusterSize; ++lane)
                {
                    const std::size_t j = *c*clusterSize + lane;
                    if (packed_.contents[j] != fields::content::wall)
                    {
                        continue;
                    }
                    double r2 = 0;
                    double approach = 0;
                    vector r, dv;
                    for (int d = 0; d < dim; ++d)
                    {
                        r[d] = packed(i, fields::x + d) - packed(j, fields::x + d);
                        dv[d] = packed(i, fields::v + d) - packed(j, fields::v + d);
                        r2 += r[d]*r[d];
                        approach += r[d]*dv[d];
                    }
                    if (r2 >= supportRadius()*supportRadius())
                    {
                        continue;
                    }
                    const double weight =
                        packed(i, fields::volume)*packed(j, fields::volume)*kernelFactor(m.kernel, std::sqrt(r2)/h)
                       *kernelNormalisation(m.kernel, dim)/std::pow(h, dim + 2);
                    const double regular = r2 + 0.01*h*h;
                    double stress = packed(i, fields::pressure) + packed(j, fields::pressure);
                    if (m.viscosity == viscosityType::artificial && approach < 0)
                    {
                        stress -=
                            m.alpha*h*m.c0*approach/regular
                           *(model_.rho0 + 0.5*(packed(i, fields::density) + packed(j, fields::density)));
                    }
                    const double friction =
                        m.viscosity == viscosityType::laminar && m.noSlip ? 2*m.mu*r2/regular : 0;
                    vector& force = forces[wall_[neighbours_.order()[j]]];
                    for (int d = 0; d < dim; ++d)
                    {
                        force[d] += weight*(stress*r[d] - friction*dv[d]);
                    }
                }
            }
        }
        return forces;
    }

    typename particleFlow<dim>::energies energy() const override
    {
        typename particleFlow<dim>::energies e{0, 0, 0};
        for (std::size_t k = 0; k < x_.size(); ++k)
        {
            if (isFluid(k))
            {
                for (int d = 0; d < dim; ++d)
                {
                    e.kinetic += 0.5*mass_[k]*v_[k][d]*v_[k][d];
                    e.potential -= mass_[k]*model_.interaction.g[d]*x_[k][d];
                }
                e.internal += mass_[k]*state_.energy(density_[k]);
            }
        }
        return e;
    }

    double maxSpeed() const override
    {
        return maxSpeed_;
    }

    double nPairs() const override
    {
        return nPairs_;
    }

    double nParticleSteps() const override
    {
        return nParticleSteps_;
    }

    const char* instructions() const override
    {
        return interaction_.instructions();
    }

    std::size_t bytes() const override
    {
        return
            neighbours_.bytes()
          + packed_.contents.size()*(fields::nFields + 2*dim + 2)*sizeof(Real)
          + x_.size()*(5*sizeof(vector) + 3*sizeof(double) + 3*sizeof(std::int32_t));
    }

    long nSearches() const override
    {
        return nSearches_;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int dim>
std::unique_ptr<Foam::smoothedParticles::particleFlow<dim>> Foam::smoothedParticles::newParticleFlow
(
    const particleState<dim>& start,
    const particleFlowModel<dim>& model,
    int nThreads
)
{
    const interactionModel& m = model.interaction;
    checkPositive("spacing", model.spacing);
    checkPositive("rho0", model.rho0);
    checkPositive("Courant", model.Courant);
    checkPositive("h", m.h);
    checkPositive("c0", m.c0);
    checkNotNegative("mu", m.mu);
    checkNotNegative("alpha", m.alpha);
    checkNotNegative("delta", m.delta);
    checkPositive("number of threads", nThreads);
    if (!(m.gamma > 1) || !std::isfinite(m.gamma))
    {
        refuse("gamma", m.gamma, "a number above 1");
    }
    if (m.h < model.spacing || m.h > 10*model.spacing)
    {
        refuse("h", m.h/model.spacing, "1 to 10 spacings");
    }
    const std::size_t n = start.size();
    if (start.v.size() != n || start.density.size() != n || start.wall.size() != n || (start.mass.size() != n && !start.mass.empty()))
    {
        throw std::invalid_argument("state of the particles: expected as many velocities, densities, walls, and masses if any, as positions");
    }
    for (std::size_t k = 0; k < n; ++k)
    {
        double sum = start.density[k];
        for (int d = 0; d < dim; ++d)
        {
            sum += start.x[k][d] + start.v[k][d];
        }
        if (!std::isfinite(sum))
        {
            throw std::invalid_argument
            (
                "particle " + std::to_string(k) + " starts with a position, velocity or density that is not a number"
            );
        }
    }
    if (std::count(start.wall.begin(), start.wall.end(), particleState<dim>::fluid) == 0)
    {
        throw std::invalid_argument("no particle of fluid: expected one at least");
    }

    if (model.singlePrecision)
    {
        return std::unique_ptr<particleFlow<dim>>(new flowIn<float, dim>(start, model, nThreads));
    }
    return std::unique_ptr<particleFlow<dim>>(new flowIn<double, dim>(start, model, nThreads));
}


template std::unique_ptr<Foam::smoothedParticles::particleFlow<2>> Foam::smoothedParticles::newParticleFlow<2>
(const particleState<2>&, const particleFlowModel<2>&, int);

template std::unique_ptr<Foam::smoothedParticles::particleFlow<3>> Foam::smoothedParticles::newParticleFlow<3>
(const particleState<3>&, const particleFlowModel<3>&, int);
