// SPDX-License-Identifier: GPL-3.0-or-later
// Order of the particles, their neighbours and their mirror images

#include "flowIn.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

// Every so many particles have their neighbours counted
constexpr int countedShare = 64;

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::placeImages()
{
    if (!images_.empty())
    {
        copy(x_, xAll_);
        for (const mirrorImage<dim>& image : images_)
        {
            xAll_.push_back(image.position(x_[image.source]));
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::sort()
{
    const std::size_t n = x_.size();
    findMirrorImages<dim>(model_.symmetry, x_, searchRadius(), images_);
    placeImages();
    neighbours_.sort(positions(), model_.spacing, nThreads_);

    const std::vector<std::int32_t>& order = neighbours_.order();
    from_.clear();
    for (const std::int32_t k : order)
    {
        if (k >= 0 && k < std::int32_t(n))
        {
            from_.push_back(k);
        }
    }
    reorder(original_, place_);
    reorder(wall_, place_);
    reorder(x_, xOld_);
    reorder(v_, xOld_);
    reorder(a_, xOld_);
    reorder(density_, densityOld_);
    reorder(mass_, densityOld_);
    if (model_.energy)
    {
        for (std::vector<double>* values : {&energy_, &heat_, &energyRate_, &heating_})
        {
            reorder(*values, densityOld_);
        }
    }
    if (!images_.empty())
    {
        std::vector<std::int32_t>& newOf = imagePlace_;
        newOf.resize(n);
        for (std::size_t k = 0; k < n; ++k)
        {
            newOf[from_[k]] = k;
        }
        std::vector<mirrorImage<dim>> sorted;
        for (const std::int32_t k : order)
        {
            if (k >= std::int32_t(n))
            {
                sorted.push_back(images_[k - n]);
                sorted.back().source = newOf[sorted.back().source];
            }
        }
        images_.swap(sorted);
        placeImages();
    }
    neighbours_.renumber(n);
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::search()
{
    sort();
    const std::int64_t n = x_.size();
    passive_.resize(n + images_.size());
    silent_.assign(n + images_.size(), false);
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        passive_[k] = !isFluid(k);
    }
    for (std::size_t g = 0; g < images_.size(); ++g)
    {
        passive_[n + g] = !isFluid(images_[g].source);
        silent_[n + g] = true;
    }
    neighbours_.search(positions(), passive_, silent_, searchRadius(), nThreads_);

    place_.resize(n);
    imagePlace_.resize(images_.size());
    packed_.resize(neighbours_.size());
    packed_.fluid.clear();
    packed_.walls.clear();
    middle_ = neighbours_.middle();
    if (model_.interaction.axisymmetric)
    {
        // The packed coordinate is the radius
        middle_[0] = 0;
    }
    const std::vector<std::int32_t>& order = neighbours_.order();
    const std::int64_t nPlaces = order.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t i = 0; i < nPlaces; ++i)
    {
        if (order[i] >= 0)
        {
            packed_(i, fields::share) = passive_[order[i]] ? 0 : 1;
            (order[i] < n ? place_[order[i]] : imagePlace_[order[i] - n]) = i;
        }
    }
    for (std::int64_t k = 0; k < n; ++k)
    {
        (passive_[k] ? packed_.walls : packed_.fluid).push_back(place_[k]);
    }
    findBodyParticles();
    if (model_.interaction.diffusion == diffusionType::Antuono)
    {
        packed_.addDensityGradient();
    }
    if (model_.energy)
    {
        packed_.addEnergy();
    }
    if (model_.shifting > 0)
    {
        packed_.addShifting();
    }
    copy(x_, xSearched_);
    ++nSearches_;
    countPairs();
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::findBodyParticles()
{
    if (bodies_.empty())
    {
        return;
    }
    packed_.moveWalls();
    const std::int64_t n = x_.size();
    std::vector<std::int32_t> newOf(n);
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
    for (std::int64_t k = 0; k < n; ++k)
    {
        newOf[original_[k]] = k;
    }
    bodyPlaces_.clear();
    for (bodyParticle& p : bodyParticles_)
    {
        p.now = newOf[p.original];
        bodyPlaces_.push_back(place_[p.now]);
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::countPairs()
{
    double pairs = 0;
    double counted = 0;
    const double radius2 = supportRadius()*supportRadius();
    const std::vector<vector>& x = positions();
    const std::int64_t n = x_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(dynamic, 64) reduction(+: pairs, counted)
    for (std::int64_t k = 0; k < n; k += countedShare)
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
                if (j < 0 || j == k)
                {
                    continue;
                }
                double r2 = 0;
                for (int d = 0; d < dim; ++d)
                {
                    r2 += (x[j][d] - x[k][d])*(x[j][d] - x[k][d]);
                }
                pairs += r2 < radius2;
            }
        }
    }
    pairsPerSum_ = counted > 0 ? pairs/counted*nFluid_ : 0;
}


template<class Real, int dim>
bool Foam::smoothedParticles::flowIn<Real, dim>::isStale(double ahead) const
{
    const double allowed = 0.5*skinRatio*model_.spacing - ahead;
    if (allowed <= 0)
    {
        return true;
    }
    double farthest2 = 0;
    const std::int64_t n = x_.size();
    #pragma omp parallel for num_threads(nThreads_) schedule(static, turn) reduction(max: farthest2)
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


template class Foam::smoothedParticles::flowIn<float, 2>;
template class Foam::smoothedParticles::flowIn<float, 3>;
template class Foam::smoothedParticles::flowIn<double, 2>;
template class Foam::smoothedParticles::flowIn<double, 3>;
