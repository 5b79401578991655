// SPDX-License-Identifier: GPL-3.0-or-later
// Steps in time

#include "flowIn.H"
#include "particleShifting.H"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::shift(double deltaT)
{
    if (!(model_.shifting > 0))
    {
        return;
    }
    packFields();
    interaction_.sumConcentration(neighbours_, packed_, nThreads_);
    packImages(packed_.positionDivergence);
    interaction_.sumSurfaceNormal(neighbours_, packed_, nThreads_);

    const std::int64_t n = x_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        if (!isFluid(k))
        {
            continue;
        }
        const std::size_t i = place_[k];
        shiftingParticle<dim> one;
        one.x = x_[k];
        double speed2 = 0;
        for (int d = 0; d < dim; ++d)
        {
            speed2 += v_[k][d]*v_[k][d];
            one.concentration[d] = packed_.concentration[d][i];
            one.surfaceNormal[d] = packed_.surfaceNormal[d][i];
        }
        one.speed = std::sqrt(speed2);
        one.positionDivergence = packed_.positionDivergence[i];
        one.nearSurface = packed_.nearSurface[i] > 0;
        one.wallDistance = std::sqrt(double(packed_.wallDistance2[i]));
        const vector s(one.shift(model_.shifting, model_.interaction.h, model_.spacing, deltaT, model_.symmetry));
        for (int d = 0; d < dim; ++d)
        {
            x_[k][d] += s[d];
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::integrateEnergy(double deltaT)
{
    if (!model_.energy)
    {
        return;
    }
    for (const bool after : {false, true})
    {
        if (after)
        {
            sumEnergyRates();
        }
        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            energy_[k] += 0.5*deltaT*energyRate_[k];
            heat_[k] += 0.5*deltaT*heating_[k];
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::kickAndDrift(double half)
{
    const std::int64_t n = x_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        if (isFluid(k))
        {
            for (int d = 0; d < dim; ++d)
            {
                v_[k][d] += half*a_[k][d];
                x_[k][d] += half*v_[k][d];
            }
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::absorb(double deltaT)
{
    if (!(model_.absorption.thickness > 0))
    {
        return;
    }
    const std::array<double, 3>& g = model_.interaction.g;
    const double weight = std::sqrt(g[0]*g[0] + g[1]*g[1] + g[2]*g[2]);
    const std::int64_t n = x_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        const double rate = isFluid(k) ? model_.absorption.rate(x_[k], model_.interaction.c0) : 0;
        if (rate > 0)
        {
            double load = weight*model_.absorption.surface;
            for (int d = 0; d < dim; ++d)
            {
                load += g[d]*x_[k][d];
            }
            const double still = state_.densityAtRest(std::max(0.0, load));
            const double kept = std::exp(-rate*deltaT);
            density_[k] = still + kept*(density_[k] - still);
            for (int d = 0; d < dim; ++d)
            {
                v_[k][d] *= kept;
            }
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::keepInside()
{
    for (const symmetryPlane& plane : model_.symmetry)
    {
        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k) && plane.distance(x_[k]) < 0)
            {
                x_[k][plane.axis] = 2*plane.at - x_[k][plane.axis];
                v_[k][plane.axis] *= -1;
                // Gravity stays
                a_[k][plane.axis] = 2*model_.interaction.g[plane.axis] - a_[k][plane.axis];
            }
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::stepVerlet(double deltaT)
{
    const std::int64_t n = x_.size();
    const double half = 0.5*deltaT;

    if (!bodies_.empty())
    {
        copy(x_, xOld_);
    }
    kickAndDrift(half);
    moveBodies(0.5, deltaT);
    sumDensityRate();

    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        if (isFluid(k))
        {
            density_[k] += deltaT*rate(k);
            for (int d = 0; d < dim; ++d)
            {
                x_[k][d] += half*v_[k][d];
            }
        }
    }
    moveBodies(1, deltaT);
    arriveBodies();
    shift(deltaT);
    sumAcceleration();

    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        if (isFluid(k))
        {
            for (int d = 0; d < dim; ++d)
            {
                v_[k][d] += half*a_[k][d];
            }
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::stepSymplectic(double deltaT)
{
    const std::int64_t n = x_.size();
    const double half = 0.5*deltaT;
    copy(x_, xOld_);
    copy(v_, vOld_);
    copy(density_, densityOld_);

    sumDensityRate();
    sumAcceleration();

    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        if (isFluid(k))
        {
            density_[k] += half*rate(k);
            for (int d = 0; d < dim; ++d)
            {
                x_[k][d] += half*v_[k][d];
                v_[k][d] += half*a_[k][d];
            }
        }
    }
    moveBodies(0.5, deltaT);
    sumDensityRate();
    sumAcceleration();

    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        if (isFluid(k))
        {
            const double growth = deltaT*rate(k)/(model_.rho0 + density_[k]);
            const double rho = (model_.rho0 + densityOld_[k])*(2 + growth)/(2 - growth);
            density_[k] = rho - model_.rho0;
            for (int d = 0; d < dim; ++d)
            {
                v_[k][d] = vOld_[k][d] + deltaT*a_[k][d];
                x_[k][d] = xOld_[k][d] + half*(vOld_[k][d] + v_[k][d]);
            }
        }
    }
    moveBodies(1, deltaT);
    arriveBodies();
    shift(deltaT);
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::checkFields()
{
    double speed2 = 0;
    double acceleration2 = 0;
    const std::int64_t n = x_.size();
    std::int64_t broken = n;

    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn) \
        reduction(max: speed2, acceleration2) reduction(min: broken)
    for (std::int64_t k = 0; k < n; ++k)
    {
        double v2 = 0;
        double a2 = 0;
        for (int d = 0; d < dim; ++d)
        {
            v2 += v_[k][d]*v_[k][d];
            a2 += a_[k][d]*a_[k][d];
        }
        speed2 = std::max(speed2, v2);
        acceleration2 = std::max(acceleration2, a2);
        if (!std::isfinite(v2 + a2 + density_[k]))
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
        message << ") m has a velocity, density or acceleration that is not a number at " << time_ << " s";
        throw std::runtime_error(message.str());
    }
    for (const auto& b : bodies_)
    {
        // Without particles, too
        speed2 = std::max(speed2, magSqr(b.second.now.velocity));
    }
    maxSpeed_ = std::sqrt(speed2);
    maxAcceleration_ = std::sqrt(acceleration2);
}


template<class Real, int dim>
double Foam::smoothedParticles::flowIn<Real, dim>::stableTimeStep() const
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
    step *= model_.Courant;
    if (contactFrequency2_ > 0)
    {
        // Half of what is stable: 2 over the frequency
        step = std::min(step, 1/std::sqrt(contactFrequency2_ + bodyFrequency2_));
    }
    return step;
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::advance(double deltaT)
{
    if (!(deltaT > 0) || !std::isfinite(deltaT))
    {
        refuse("time step", deltaT, "a number above 0");
    }
    const double longest = model_.shifting > 0 ? longestShift*model_.spacing : 0;
    if (isStale((maxSpeed_ + maxAcceleration_*deltaT)*deltaT + longest))
    {
        search();
    }
    if (model_.timeStepping == timeSteppingType::Verlet)
    {
        stepVerlet(deltaT);
    }
    else
    {
        stepSymplectic(deltaT);
    }
    keepInside();
    absorb(deltaT);
    integrateEnergy(deltaT);
    time_ += deltaT;
    nParticleSteps_ += nFluid_;
    checkFields();
}


template class Foam::smoothedParticles::flowIn<float, 2>;
template class Foam::smoothedParticles::flowIn<float, 3>;
template class Foam::smoothedParticles::flowIn<double, 2>;
template class Foam::smoothedParticles::flowIn<double, 3>;
