// SPDX-License-Identifier: GPL-3.0-or-later
// What particles do to each other

#include "flowIn.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::packFields()
{
    const interactionModel& m = model_.interaction;
    const double damping = m.acousticDamper*m.c0*m.h;
    const std::int64_t n = x_.size();

    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        const std::size_t i = place_[k];
        for (int d = 0; d < dim; ++d)
        {
            packed_(i, fields::x + d) = x_[k][d] - middle_[d];
            packed_(i, fields::v + d) = v_[k][d];
        }
        packed_(i, fields::density) = density_[k];
        packed_(i, fields::volume) = mass_[k]/(m.circumference(x_[k][0])*(model_.rho0 + (isFluid(k) ? density_[k] : 0)));
        packed_(i, fields::pressure) = state_.pressure(density_[k]) + damping*packed_.densityRate[i];
    }
    packImages();
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::packImages()
{
    const std::int64_t n = images_.size();

    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t g = 0; g < n; ++g)
    {
        const mirrorImage<dim>& image = images_[g];
        const std::size_t from = place_[image.source];
        const std::size_t to = imagePlace_[g];
        for (int d = 0; d < dim; ++d)
        {
            packed_(to, fields::x + d) = image.sign[d]*x_[image.source][d] + image.offset[d] - middle_[d];
            packed_(to, fields::v + d) = image.sign[d]*packed_(from, fields::v + d);
        }
        for (const int field : {fields::density, fields::volume, fields::pressure})
        {
            packed_(to, field) = packed_(from, field);
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::packImages(std::array<packVector<Real>, dim>& vectors)
{
    const std::int64_t n = images_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t g = 0; g < n; ++g)
    {
        for (int d = 0; d < dim; ++d)
        {
            vectors[d][imagePlace_[g]] = images_[g].sign[d]*vectors[d][place_[images_[g].source]];
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::packImages(packVector<Real>& scalars)
{
    const std::int64_t n = images_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t g = 0; g < n; ++g)
    {
        scalars[imagePlace_[g]] = scalars[place_[images_[g].source]];
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::extrapolateToWalls()
{
    packWalls();
    coupleBodies();
    packImages();
    const std::int64_t n = x_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        if (!isFluid(k))
        {
            density_[k] = packed_(place_[k], fields::density);
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::packWalls()
{
    for (const bodyParticle& p : bodyParticles_)
    {
        const bodyState& felt = p.of->felt;
        const Foam::vector r(toVector(x_[p.now]) - p.of->at.centreOfMass);
        const Foam::vector a
        (
            felt.acceleration + (felt.angularAcceleration ^ r) + (felt.omega ^ (felt.omega ^ r))
        );
        for (int d = 0; d < dim; ++d)
        {
            packed_.ownVelocity[d][place_[p.now]] = v_[p.now][d];
            packed_.ownAcceleration[d][place_[p.now]] = a[d];
        }
    }
    interaction_.extrapolate(neighbours_, packed_, nThreads_);

    const std::int64_t n = x_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        if (isFluid(k))
        {
            continue;
        }
        const std::size_t i = place_[k];
        packWallPressure(i);
        for (int d = 0; d < dim; ++d)
        {
            packed_(i, fields::v + d) = packed_.wallVelocity[d][i];
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::sumDensityRate()
{
    packFields();
    if (model_.interaction.diffusion == diffusionType::Antuono)
    {
        interaction_.sumDensityGradient(neighbours_, packed_, nThreads_);
        packImages(packed_.densityGradient);
    }
    interaction_.sumDensityRate(neighbours_, packed_, nThreads_);
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::sumAcceleration()
{
    packFields();
    extrapolateToWalls();
    interaction_.sumAcceleration(neighbours_, packed_, nThreads_);

    const std::int64_t n = x_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        if (isFluid(k))
        {
            for (int d = 0; d < dim; ++d)
            {
                a_[k][d] = packed_.acceleration[d][place_[k]] + model_.interaction.g[d];
            }
        }
    }
    if (model_.contact.isOn())
    {
        sumContact();
    }
    nPairs_ += pairsPerSum_;
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::sumEnergyRates()
{
    packFields();
    const std::int64_t n = x_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        for (int d = 0; d < dim; ++d)
        {
            packed_.velocity[d][place_[k]] = v_[k][d];
        }
    }
    packImages(packed_.velocity);
    packWalls();
    packImages();
    interaction_.sumEnergyRate(neighbours_, packed_, nThreads_);
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        energyRate_[k] = packed_.energyRate[place_[k]];
        heating_[k] = packed_.heating[place_[k]];
    }
}


template class Foam::smoothedParticles::flowIn<float, 2>;
template class Foam::smoothedParticles::flowIn<float, 3>;
template class Foam::smoothedParticles::flowIn<double, 2>;
template class Foam::smoothedParticles::flowIn<double, 3>;
