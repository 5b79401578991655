// SPDX-License-Identifier: GPL-3.0-or-later
// Start and state

#include "flowIn.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Real, int dim>
Foam::smoothedParticles::flowIn<Real, dim>::flowIn
(
    const particleState<dim>& start,
    const particleFlowModel<dim>& model,
    int nThreads,
    const wallMotions& moving,
    const bodyResponse& response
)
:
    model_(model),
    nThreads_(nThreads),
    state_(model.rho0, model.interaction.c0, model.interaction.gamma),
    interaction_(model.interaction),
    response_(response),
    time_(start.time),
    wall_(start.wall),
    x_(start.x),
    v_(start.v),
    a_(start.size(), vector{}),
    density_(start.density),
    mass_(start.mass)
{
    packed_.rho0 = model.rho0;
    const double cell = std::pow(model.spacing, dim);
    for (std::size_t k = mass_.size(); k < density_.size(); ++k)
    {
        mass_.push_back((model.rho0 + (isFluid(k) ? density_[k] : 0))*cell*model.interaction.circumference(x_[k][0]));
    }
    for (const auto& motion : moving)
    {
        body& b = bodies_[motion.first];
        b.now = b.end = b.felt = b.at = motion.second;
        if (!start.felt.empty())
        {
            const std::array<double, 6>& a = start.felt[bodies_.size() - 1];
            b.felt.acceleration = Foam::vector(a[0], a[1], a[2]);
            b.felt.angularAcceleration = Foam::vector(a[3], a[4], a[5]);
        }
    }
    original_.resize(x_.size());
    for (std::size_t k = 0; k < x_.size(); ++k)
    {
        original_[k] = k;
        nFluid_ += isFluid(k);
        const auto found = bodies_.find(wall_[k]);
        if (found != bodies_.end())
        {
            const bodyState& now = found->second.now;
            const Foam::vector r(toVector(x_[k]) - now.centreOfMass);
            const Foam::vector v(now.velocity + (now.omega ^ r));
            std::copy_n(v.begin(), dim, v_[k].begin());
            bodyParticles_.push_back({std::int32_t(k), 0, &found->second, now.orientation.T() & r});
        }
    }
    if (model_.energy)
    {
        energy_ = start.energy;
        heat_ = start.heat;
        for (std::size_t k = energy_.size(); k < x_.size(); ++k)
        {
            energy_.push_back(isFluid(k) ? state_.energy(density_[k]) : 0);
            heat_.push_back(0);
        }
        energyRate_.resize(x_.size());
        heating_.resize(x_.size());
    }
    search();
    if (model_.contact.isOn())
    {
        setUpContact();
    }
    sumAcceleration();
    if (model_.energy)
    {
        sumEnergyRates();
    }
    if (!start.acceleration.empty())
    {
        for (std::size_t k = 0; k < x_.size(); ++k)
        {
            a_[k] = start.acceleration[original_[k]];
        }
    }
    checkFields();
}


template<class Real, int dim>
Foam::smoothedParticles::particleState<dim> Foam::smoothedParticles::flowIn<Real, dim>::state() const
{
    particleState<dim> s;
    s.time = time_;
    s.x.resize(x_.size());
    s.v.resize(x_.size());
    s.acceleration.resize(x_.size());
    s.density.resize(x_.size());
    s.mass.resize(x_.size());
    s.pressure.resize(x_.size());
    s.wall.resize(x_.size());
    s.energy.resize(energy_.size());
    s.heat.resize(heat_.size());
    for (std::size_t k = 0; k < x_.size(); ++k)
    {
        const std::int32_t i = original_[k];
        s.x[i] = x_[k];
        s.v[i] = v_[k];
        s.acceleration[i] = a_[k];
        s.density[i] = density_[k];
        s.mass[i] = mass_[k];
        s.pressure[i] = state_.pressure(density_[k]);
        s.wall[i] = wall_[k];
        if (model_.energy)
        {
            s.energy[i] = energy_[k];
            s.heat[i] = heat_[k];
        }
    }
    for (const auto& b : bodies_)
    {
        const Foam::vector& a = b.second.felt.acceleration;
        const Foam::vector& alpha = b.second.felt.angularAcceleration;
        s.felt.push_back({{a[0], a[1], a[2], alpha[0], alpha[1], alpha[2]}});
    }
    return s;
}


template<class Real, int dim>
std::vector<std::array<double, dim>> Foam::smoothedParticles::flowIn<Real, dim>::wallForces()
{
    if (model_.contact.isOn())
    {
        std::vector<vector> forces(contactLoads_.size());
        for (std::size_t w = 0; w < forces.size(); ++w)
        {
            std::copy_n(contactLoads_[w].pressure.begin(), dim, forces[w].begin());
        }
        return forces;
    }
    interaction_.sumWallForce(neighbours_, packed_, packed_.walls, nThreads_);
    const std::int32_t last = wall_.empty() ? -1 : *std::max_element(wall_.begin(), wall_.end());
    std::vector<vector> forces(last + 1, vector{});
    for (std::size_t k = 0; k < x_.size(); ++k)
    {
        if (!isFluid(k))
        {
            for (int d = firstDirection(); d < dim; ++d)
            {
                forces[wall_[k]][d] += double(packed_.acceleration[d][place_[k]]) + packed_.friction[d][place_[k]];
            }
        }
    }
    return forces;
}


template<class Real, int dim>
typename Foam::smoothedParticles::particleFlow<dim>::energies Foam::smoothedParticles::flowIn<Real, dim>::energy() const
{
    typename particleFlow<dim>::energies e{};
    e.contact = contactEnergy_;
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
        if (model_.energy)
        {
            (isFluid(k) ? e.internalEq2 : e.wallLayers) += mass_[k]*energy_[k];
            (isFluid(k) ? e.dissipated : e.workOfWalls) += mass_[k]*heat_[k];
        }
    }
    return e;
}


template<class Real, int dim>
std::size_t Foam::smoothedParticles::flowIn<Real, dim>::bytes() const
{
    return
        neighbours_.bytes()
      + neighbours_.size()*(fields::nFields + 3*dim + 2 + 4*dim*!bodies_.empty())*sizeof(Real)
      + (model_.interaction.diffusion == diffusionType::Antuono)*neighbours_.size()*dim*sizeof(Real)
      + model_.energy*(neighbours_.size()*(dim + 2)*sizeof(Real) + x_.size()*4*sizeof(double))
      + (model_.shifting > 0)*neighbours_.size()*(2*dim + 3)*sizeof(Real)
      + x_.size()*(6*sizeof(vector) + 3*sizeof(double) + 5*sizeof(std::int32_t))
      + push_.size()*(sizeof(vector) + sizeof(double))
      + xAll_.size()*sizeof(vector) + images_.size()*sizeof(mirrorImage<dim>);
}


template class Foam::smoothedParticles::flowIn<float, 2>;
template class Foam::smoothedParticles::flowIn<float, 3>;
template class Foam::smoothedParticles::flowIn<double, 2>;
template class Foam::smoothedParticles::flowIn<double, 3>;
