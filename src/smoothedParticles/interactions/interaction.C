// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC optimize("no-math-errno", "no-trapping-math")

#include "interaction.H"
#include "particleShifting.H"
#include "smoothingKernels.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * * Loops  * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace smoothedParticles
{

namespace SSE2
{
    #include "interactionLoop.H"
}

// In interactionAVX2.C and interactionAVX512.C
namespace AVX2
{
    template<class Real, int dim>
    struct chooseLoop
    {
        static typename interaction<Real, dim>::loops all(const interactionModel& model);
    };
}

namespace AVX512
{
    template<class Real, int dim>
    struct chooseLoop
    {
        static typename interaction<Real, dim>::loops all(const interactionModel& model);
    };
}

} // End namespace smoothedParticles
} // End namespace Foam


// * * * * * * * * * * * * * * Packed Particles  * * * * * * * * * * * * * * //

template<class Real, int dim>
void Foam::smoothedParticles::packedParticles<Real, dim>::resize(std::size_t nPlaces)
{
    // Far enough for any support, near enough for its square
    constexpr Real farAway = 1e15;

    // With a cluster that is always empty, after the last
    packs_.assign((nPlaces + clusterSize)*nFields, 0);
    for (std::size_t i = 0; i < nPlaces + clusterSize; ++i)
    {
        for (int d = 0; d < dim; ++d)
        {
            (*this)(i, x + d) = farAway;
        }
    }
    densityRate.assign(nPlaces, 0);
    wallPressure.assign(nPlaces, 0);
    for (int d = 0; d < dim; ++d)
    {
        acceleration[d].assign(nPlaces, 0);
        friction[d].assign(nPlaces, 0);
        wallVelocity[d].assign(nPlaces, 0);
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::packedParticles<Real, dim>::moveWalls()
{
    for (int d = 0; d < dim; ++d)
    {
        ownVelocity[d].assign(densityRate.size(), 0);
        ownAcceleration[d].assign(densityRate.size(), 0);
        wallHead[d].assign(densityRate.size(), 0);
        wallPush[d].assign(densityRate.size(), 0);
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::packedParticles<Real, dim>::addDensityGradient()
{
    // With a cluster that is always empty, after the last
    for (int d = 0; d < dim; ++d)
    {
        densityGradient[d].assign(densityRate.size() + clusterSize, 0);
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::packedParticles<Real, dim>::addEnergy()
{
    for (int d = 0; d < dim; ++d)
    {
        velocity[d].assign(densityRate.size() + clusterSize, 0);
    }
    energyRate.assign(densityRate.size(), 0);
    heating.assign(densityRate.size(), 0);
}


template<class Real, int dim>
void Foam::smoothedParticles::packedParticles<Real, dim>::addShifting()
{
    for (int d = 0; d < dim; ++d)
    {
        concentration[d].assign(densityRate.size(), 0);
        surfaceNormal[d].assign(densityRate.size(), 0);
    }
    positionDivergence.assign(densityRate.size() + clusterSize, 0);
    nearSurface.assign(densityRate.size(), 0);
    wallDistance2.assign(densityRate.size(), 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Real, int dim>
Foam::smoothedParticles::interaction<Real, dim>::interaction(const interactionModel& model, instructionSet widest)
:
    model_(model)
{
    const bool hasAVX2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    const bool hasAVX512 =
        hasAVX2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
     && __builtin_cpu_supports("avx512vl");

    if (widest == instructionSet::AVX512 && hasAVX512)
    {
        loops_ = AVX512::chooseLoop<Real, dim>::all(model);
        instructions_ = "AVX-512";
    }
    else if (widest != instructionSet::SSE2 && hasAVX2)
    {
        loops_ = AVX2::chooseLoop<Real, dim>::all(model);
        instructions_ = "AVX2";
    }
    else
    {
        loops_ = SSE2::chooseLoop<Real, dim>::all(model);
        instructions_ = "SSE2";
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Real, int dim>
void Foam::smoothedParticles::interaction<Real, dim>::run
(
    loop what,
    const clusterNeighbours<dim>& neighbours,
    packedParticles<Real, dim>& particles,
    const std::vector<std::int32_t>& places,
    int nThreads
) const
{
    constexpr std::size_t chunk = 64*clusterSize;
    const std::int64_t nChunks = (places.size() + chunk - 1)/chunk;

    #pragma omp parallel for num_threads(nThreads) schedule(dynamic, 1)
    for (std::int64_t k = 0; k < nChunks; ++k)
    {
        what(model_, neighbours, particles, places.data() + k*chunk, std::min(places.size() - k*chunk, chunk));
    }
}


template class Foam::smoothedParticles::packedParticles<float, 2>;
template class Foam::smoothedParticles::packedParticles<float, 3>;
template class Foam::smoothedParticles::packedParticles<double, 2>;
template class Foam::smoothedParticles::packedParticles<double, 3>;

template class Foam::smoothedParticles::interaction<float, 2>;
template class Foam::smoothedParticles::interaction<float, 3>;
template class Foam::smoothedParticles::interaction<double, 2>;
template class Foam::smoothedParticles::interaction<double, 3>;
