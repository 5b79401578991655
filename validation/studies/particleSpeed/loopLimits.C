// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of src/smoothedParticles/interactions over particles that are read, and what one core of this machine can do:
//     loopLimits PARTICLES SPACING H C0 RHO0 ALPHA DELTA SKIN
// PARTICLES holds for each particle x, y, z, rho - rho0 and 1 for the fluid or 0, as doubles. Prints names and numbers.

#include "interaction.H"

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>

using namespace Foam::smoothedParticles;

namespace
{

typedef pack<float>::type V;

//- Of this thread [s]: time in which others have the core does not count
double now()
{
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}


//- Least time of a call [s], of those in about a second
template<class Function>
double leastTime(Function call)
{
    const double start = now();
    double least = 1e300;
    while (now() - start < 1)
    {
        const double t = now();
        call();
        least = std::min(least, now() - t);
    }
    return least;
}


// Results go here, so that the compiler cannot leave the work out
volatile float sink;


//- Multiplications and additions in registers, as many at a time as hide their latency [flop/s]
double peak()
{
    constexpr int n = 12;
    constexpr long repeats = 2000000;
    V x[n];
    for (int k = 0; k < n; ++k)
    {
        x[k] = V{} + float(k + 1);
    }
    const V a = V{} + 0.999f;
    const V b = V{} + 0.001f;
    const double t = leastTime([&]()
    {
        for (long r = 0; r < repeats; ++r)
        {
            for (int k = 0; k < n; ++k)
            {
                x[k] = x[k]*a + b;
            }
        }
    });
    V all = {};
    for (int k = 0; k < n; ++k)
    {
        all += x[k];
    }
    sink = sum(all);
    return 2.0*n*repeats*clusterSize/t;
}


//- Reading this many bytes again and again [byte/s]
double readRate(std::size_t bytes)
{
    const std::size_t n = bytes/sizeof(V)/8*8;
    V* const data = static_cast<V*>(aligned_alloc(64, n*sizeof(V)));
    std::fill(data, data + n, V{} + 1e-3f);
    V total[8] = {};
    const int repeats = std::max<std::size_t>(1, (std::size_t(1) << 24)/bytes);
    const double t = leastTime([&]()
    {
        for (int r = 0; r < repeats; ++r)
        {
            for (std::size_t k = 0; k < n; k += 8)
            {
                for (int j = 0; j < 8; ++j)
                {
                    total[j] += data[k + j];
                }
            }
            // The sums of one repetition are not those of another
            asm volatile("" ::: "memory");
        }
    });
    for (const V& x : total)
    {
        sink = sum(x);
    }
    std::free(data);
    return double(n)*sizeof(V)*repeats/t;
}


//- a = b + s c in memory, of the size that no cache holds [byte/s], as STREAM counts
double triad()
{
    const std::size_t n = std::size_t(1) << 24;
    std::vector<float> a(n, 1), b(n, 2), c(n, 3);
    const double t = leastTime([&]()
    {
        for (std::size_t k = 0; k < n; ++k)
        {
            a[k] = b[k] + 0.5f*c[k];
        }
        asm volatile("" :: "r"(a.data()) : "memory");
    });
    sink = a[n/2];
    return 3.0*n*sizeof(float)/t;
}


struct particle
{
    double x[3];
    double density;
    double isFluid;
};

} // End anonymous namespace


int main(int argc, char* argv[])
{
    if (argc != 9)
    {
        std::cerr << "loopLimits: " << argc - 1 << " arguments: expected 8\n";
        return 1;
    }
    std::ifstream file(argv[1], std::ios::binary);
    std::vector<particle> particles;
    for (particle p; file.read(reinterpret_cast<char*>(&p), sizeof(p));)
    {
        particles.push_back(p);
    }
    const double spacing = std::atof(argv[2]);
    interactionModel model;
    model.viscosity = viscosityType::artificial;
    model.diffusion = diffusionType::Fourtakas;
    model.h = std::atof(argv[3]);
    model.c0 = std::atof(argv[4]);
    model.alpha = std::atof(argv[6]);
    model.delta = std::atof(argv[7]);
    model.g = {{0, 0, -9.81}};
    const double rho0 = std::atof(argv[5]);

    std::vector<std::array<double, 3>> x;
    for (const particle& p : particles)
    {
        x.push_back({{p.x[0], p.x[1], p.x[2]}});
    }
    clusterNeighbours<3> neighbours;
    neighbours.sort(x, spacing, 1);
    const std::vector<std::int32_t> order(neighbours.order());
    std::vector<unsigned char> passive;
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        passive.push_back(particles[k].isFluid == 0);
    }
    const std::vector<unsigned char> silent(x.size(), 0);
    neighbours.search(x, passive, silent, supportRatio*model.h + std::atof(argv[8])*spacing, 1);

    packedParticles<float, 3> packed;
    packed.rho0 = rho0;
    packed.resize(neighbours.size());
    double lanes = 0, inside = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        if (order[i] < 0)
        {
            continue;
        }
        const particle& p = particles[order[i]];
        for (int d = 0; d < 3; ++d)
        {
            packed(i, packed.x + d) = p.x[d];
            packed(i, packed.v + d) = 0;
        }
        packed(i, packed.density) = p.density;
        packed(i, packed.pressure) = model.c0*model.c0*p.density;
        packed(i, packed.volume) = spacing*spacing*spacing;
        packed(i, packed.share) = p.isFluid;
        (p.isFluid ? packed.fluid : packed.walls).push_back(i);
        if (!p.isFluid)
        {
            continue;
        }
        lanes += clusterSize*double(neighbours.end(i) - neighbours.begin(i));
        for (auto c = neighbours.begin(i); c != neighbours.end(i); ++c)
        {
            for (int lane = 0; lane < clusterSize; ++lane)
            {
                const std::int32_t j = order[*c*clusterSize + lane];
                if (j >= 0 && j != order[i])
                {
                    double r2 = 0;
                    for (int d = 0; d < 3; ++d)
                    {
                        r2 += (x[j][d] - p.x[d])*(x[j][d] - p.x[d]);
                    }
                    inside += r2 < supportRatio*supportRatio*model.h*model.h;
                }
            }
        }
    }

    const interaction<float, 3> sums(model);
    const double density = leastTime([&](){ sums.sumDensityRate(neighbours, packed, 1); });
    const double momentum = leastTime([&](){ sums.sumAcceleration(neighbours, packed, 1); });

    std::cout
        << "instructions " << sums.instructions() << "\n"
        << "pairs " << inside << "\n"
        << "lanes " << lanes << "\n"
        << "density " << density << "\n"
        << "momentum " << momentum << "\n"
        << "peak " << peak() << "\n"
        << "L1 " << readRate(1 << 14) << "\n"
        << "L2 " << readRate(1 << 20) << "\n"
        << "memory " << triad() << "\n";
    return 0;
}
