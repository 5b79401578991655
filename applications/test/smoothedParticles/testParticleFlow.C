// SPDX-License-Identifier: GPL-3.0-or-later
// The liquid in particles: rest, free flight, collision, twins.

#include <gtest/gtest.h>

#include "particleScenes.H"
#include "particleShifting.H"
#include "smoothingKernels.H"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <new>
#include <stdexcept>

using namespace Foam::smoothedParticles;
using namespace Foam::smoothedParticles::test;
using Foam::bodyState;

// * * * * * * * * * * * * * * *  Allocations  * * * * * * * * * * * * * * * //

std::atomic<long> Foam::smoothedParticles::test::nAllocations(0);

void* operator new(std::size_t n)
{
    ++nAllocations;
    void* p = std::malloc(n ? n : 1);
    if (!p)
    {
        throw std::bad_alloc();
    }
    return p;
}

void operator delete(void* p) noexcept
{
    std::free(p);
}

void operator delete(void* p, std::size_t) noexcept
{
    std::free(p);
}


namespace
{

//- A square tank of side 1 full of liquid at rest, in which the pressure is hydrostatic; walls 0 (floor) and 1 (sides)
particleState<2> tank(int n, double c0)
{
    constexpr int layers = 4;
    const double spacing = 1.0/n;
    particleState<2> s;
    addBlock<2>(s, spacing, {{0, 0}}, {{n, n}}, {{0, 0}});
    for (std::size_t k = 0; k < s.size(); ++k)
    {
        s.density[k] = densityOf(rho0*g*(1 - s.x[k][1]), c0);
    }
    for (int i = -layers; i < n + layers; ++i)
    {
        for (int j = -layers; j < n + layers; ++j)
        {
            if (i >= 0 && i < n && j >= 0)
            {
                continue;
            }
            addParticle<2>(s, {{(i + 0.5)*spacing, (j + 0.5)*spacing}}, {{0, 0}}, 0, j < 0 ? 0 : 1);
        }
    }
    return s;
}


//- Two blocks that collide
particleState<2> collision()
{
    particleState<2> s;
    addBlock<2>(s, 0.01, {{0, 0}}, {{12, 12}}, {{1, 0.3}});
    addBlock<2>(s, 0.01, {{0.14, 0.03}}, {{8, 16}}, {{-0.5, 0}});
    return s;
}


template<class Exception, class Function>
std::string messageOf(const Function& f)
{
    try
    {
        f();
    }
    catch (const Exception& e)
    {
        return e.what();
    }
    return "nothing was thrown";
}

} // End anonymous namespace


// A still tank stays still: pressure within 1 % of hydrostatics in the lower half, the floor carries the weight. The
// exact pressure is that of the compressible liquid, 0.4 % above that of constant density at the depth of 0.75.
TEST(ParticleFlow, stillTank)
{
    constexpr int n = 20;
    const double c0 = 10*std::sqrt(g);
    particleFlowModel<2> m = modelOf<2>(1.0/n, c0);
    m.interaction.g = {{0, -g, 0}};
    auto flow = newParticleFlow<2>(tank(n, c0), m, 1);

    // Mean over a second: sound goes up and down
    double weight = 0;
    const particleState<2> start = flow->state();
    for (std::size_t k = 0; k < start.size(); ++k)
    {
        weight += start.wall[k] == particleState<2>::fluid ? start.mass[k]*g : 0;
    }
    run(*flow, 1.0);
    double error = 0;
    double force = 0;
    int samples = 0;
    while (flow->time() < 2)
    {
        run(*flow, flow->time() + 0.01);
        const particleState<2> s = flow->state();
        double mean = 0;
        int counted = 0;
        for (std::size_t k = 0; k < s.size(); ++k)
        {
            const double depth = 1 - s.x[k][1];
            if (s.wall[k] == particleState<2>::fluid && depth > 0.5)
            {
                // dp/dz = rho g with Murnaghan's rho(p)
                const double B = rho0*c0*c0/7;
                const double exact = B*(std::pow(1 + 6.0/7*rho0*g*depth/B, 7.0/6) - 1);
                mean += s.pressure[k]/exact - 1;
                ++counted;
            }
        }
        error += mean/counted;
        force += flow->wallForces()[0][1];
        ++samples;
    }
    EXPECT_LT(std::abs(error/samples), 0.01);
    EXPECT_NEAR(-force/samples/weight, 1, 0.01);
    EXPECT_LT(flow->maxSpeed(), 0.01*std::sqrt(g));
}


// Without walls and pressure a block falls as a point does
TEST(ParticleFlow, freeFlightIsExact)
{
    particleState<3> s;
    addBlock<3>(s, 0.01, {{0, 0, 0}}, {{6, 5, 4}}, {{1, 2, 0.5}});
    particleFlowModel<3> m = modelOf<3>(0.01, 30);
    m.interaction.g = {{0, 0, -g}};
    m.interaction.diffusion = diffusionType::Molteni;
    auto flow = newParticleFlow<3>(s, m, 2);
    run(*flow, 0.1);
    const particleState<3> end = flow->state();
    const double t = flow->time();
    for (std::size_t k = 0; k < s.size(); ++k)
    {
        EXPECT_NEAR(end.v[k][2], 0.5 - g*t, 1e-11);
        EXPECT_NEAR(end.v[k][0], 1, 1e-12);
        EXPECT_NEAR(end.x[k][2], s.x[k][2] + 0.5*t - 0.5*g*t*t, 1e-12);
        EXPECT_NEAR(end.x[k][1], s.x[k][1] + 2*t, 1e-12);
    }
}


// Colliding drops keep their momentum to round-off and lose energy, whatever is chosen
TEST(ParticleFlow, collisionKeepsMomentum)
{
    for (const diffusionType diffusion : {diffusionType::Fourtakas, diffusionType::Antuono, diffusionType::Riemann})
    {
        for (const double shifting : {0, 2})
        {
            for (const pressureType pressure : {pressureType::fluid, pressureType::solid})
            {
                particleFlowModel<2> m = modelOf<2>(0.01, 30);
                m.interaction.diffusion = diffusion;
                m.interaction.pressure = pressure;
                m.shifting = shifting;
                auto flow = newParticleFlow<2>(collision(), m, 2);
                auto momentum = [&](int d)
                {
                    const particleState<2> s = flow->state();
                    double sum = 0;
                    for (std::size_t k = 0; k < s.size(); ++k)
                    {
                        sum += s.mass[k]*s.v[k][d];
                    }
                    return sum;
                };
                const double before[] = {momentum(0), momentum(1)};
                const particleFlow<2>::energies start = flow->energy();
                run(*flow, 0.06);
                const particleFlow<2>::energies end = flow->energy();
                EXPECT_NEAR(momentum(0), before[0], 1e-11*std::abs(before[0]));
                EXPECT_NEAR(momentum(1), before[1], 1e-11*std::abs(before[0]));
                EXPECT_LT(end.kinetic + end.internal, start.kinetic + start.internal);
                EXPECT_LT(end.kinetic, 0.95*start.kinetic);
                EXPECT_GT(end.kinetic, 0.3*start.kinetic);
            }
        }
    }
}


// The budget of energy holds to the time step's order, with a free surface, walls, one of which moves, and planes of
// symmetry; and to sum it changes nothing
TEST(ParticleFlow, energyBudget)
{
    const auto piston = [](double Courant, viscosityType viscosity, timeSteppingType timeStepping)
    {
        constexpr int n = 20;
        const double c0 = 20;
        particleFlowModel<2> m = modelOf<2>(1.0/n, c0);
        m.interaction.h = 1.5/n;
        m.interaction.g = {{0, -g, 0}};
        m.interaction.diffusion = diffusionType::none;
        m.interaction.viscosity = viscosity;
        m.interaction.mu = 20;
        m.interaction.beta = 0.1;
        m.interaction.noSlip = true;
        m.Courant = Courant;
        m.timeStepping = timeStepping;
        m.symmetry.push_back({0, 0.5, -1});
        m.energy = true;
        particleState<2> all = tank(n, c0);
        particleState<2> half;
        for (std::size_t k = 0; k < all.size(); ++k)
        {
            if (all.x[k][0] < 0.5)
            {
                half.x.push_back(all.x[k]);
                half.v.push_back(all.v[k]);
                half.density.push_back(all.density[k]);
                half.wall.push_back(all.wall[k]);
            }
        }
        // The floor goes up and down
        const auto motion = [](double t)
        {
            return bodyState
            {
                {0, 0.02*(1 - std::cos(10*t)), 0},
                Foam::tensor::I,
                {0, 0.2*std::sin(10*t), 0},
                Foam::vector::zero,
                {0, 2*std::cos(10*t), 0},
                Foam::vector::zero
            };
        };
        auto flow = newParticleFlow<2>(half, m, 1, {{0, motion(0)}});
        m.energy = false;
        auto twin = newParticleFlow<2>(half, m, 1, {{0, motion(0)}});
        const particleFlow<2>::energies start = flow->energy();
        EXPECT_EQ(start.internalEq2, start.internal);
        double drift = 0;
        while (flow->time() < 0.25)
        {
            const double deltaT = flow->stableTimeStep();
            flow->moveWall(0, motion(flow->time() + deltaT));
            twin->moveWall(0, motion(flow->time() + deltaT));
            flow->advance(deltaT);
            twin->advance(deltaT);
            drift = std::max(drift, std::abs(flow->energy().budget() - start.budget()));
        }
        EXPECT_EQ(flow->state().x, twin->state().x);
        EXPECT_EQ(twin->energy().dissipated, 0);
        const particleFlow<2>::energies end = flow->energy();
        EXPECT_GT(std::abs(end.workOfWalls), 5);
        EXPECT_NEAR(end.internalEq2/end.internal, 1, 0.1);
        return drift/std::abs(end.workOfWalls);
    };
    for (const viscosityType viscosity : {viscosityType::none, viscosityType::laminar, viscosityType::artificial})
    {
        const double coarse = piston(0.4, viscosity, timeSteppingType::Verlet);
        const double fine = piston(0.2, viscosity, timeSteppingType::Verlet);
        RecordProperty("drift", std::to_string(coarse));
        std::printf("budget: drift over work %g at Courant number 0.4, %g at 0.2\n", coarse, fine);
        EXPECT_LT(coarse, 1e-3);
        EXPECT_LT(fine, coarse/1.8);
    }
    const double symplectic = piston(0.2, viscosityType::artificial, timeSteppingType::symplectic);
    std::printf("symplectic %g\n", symplectic);
    EXPECT_LT(symplectic, 1e-3);
}


namespace
{

//- Root mean square of h times the gradient of the concentration, over particles away from a free surface
double unevenness(const particleState<2>& s, double h, double inset)
{
    double sum2 = 0;
    int n = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
    {
        const bool inside = s.x[i][0] > inset && s.x[i][0] < 1 - inset && s.x[i][1] > inset && s.x[i][1] < 1 - inset;
        double gradient[2] = {0, 0};
        for (std::size_t j = 0; inside && j < s.size(); ++j)
        {
            const double r[] = {s.x[i][0] - s.x[j][0], s.x[i][1] - s.x[j][1]};
            const double q = std::sqrt(r[0]*r[0] + r[1]*r[1])/h;
            if (j != i && q < 2)
            {
                for (int d = 0; d < 2; ++d)
                {
                    gradient[d] +=
                        s.mass[j]/(rho0 + s.density[j])*WendlandC2::normalisation(2)*WendlandC2::f<double>(q)*r[d]
                       /(h*h*h*h);
                }
            }
        }
        sum2 += h*h*(gradient[0]*gradient[0] + gradient[1]*gradient[1]);
        n += inside;
    }
    return std::sqrt(sum2/n);
}

} // End anonymous namespace


// A vortex of Taylor and Green in a box of planes of symmetry stretches the lattice; shifting brings it to an even distribution.
// None passes a plane
TEST(ParticleFlow, shiftingEvensTheParticles)
{
    const auto vortex = [](double shifting)
    {
        constexpr int n = 40;
        particleFlowModel<2> m = modelOf<2>(1.0/n, 10);
        m.interaction.h = 1.5/n;
        m.interaction.diffusion = diffusionType::Antuono;
        m.shifting = shifting;
        m.singlePrecision = true;
        for (int axis = 0; axis < 2; ++axis)
        {
            m.symmetry.push_back({axis, 0, 1});
            m.symmetry.push_back({axis, 1, -1});
        }
        particleState<2> s;
        addBlock<2>(s, 1.0/n, {{0, 0}}, {{n, n}}, {{0, 0}});
        for (std::size_t k = 0; k < s.size(); ++k)
        {
            const double x = pi*s.x[k][0];
            const double y = pi*s.x[k][1];
            s.v[k] = {{std::sin(x)*std::cos(y), -std::cos(x)*std::sin(y)}};
            // Under a pressure of 5 rho, so that it stays above 0
            s.density[k] = rho0*(std::pow(1 + 7*(5 + 0.25*(std::cos(2*x) + std::cos(2*y)))/100, 1.0/7) - 1);
        }
        auto flow = newParticleFlow<2>(s, m, 1);
        run(*flow, 0.6);
        const particleState<2> end = flow->state();
        for (const std::array<double, 2>& x : end.x)
        {
            EXPECT_TRUE(x[0] > 0 && x[0] < 1 && x[1] > 0 && x[1] < 1);
        }
        return unevenness(end, m.interaction.h, 0.1);
    };
    const double without = vortex(0);
    const double with = vortex(2);
    std::printf("unevenness %g without shifting, %g with\n", without, with);
    EXPECT_LT(with, 0.5*without);
}


// With shifting a tank at rest stays at rest, nothing passes its walls, and its surface stays where it was
TEST(ParticleFlow, shiftingLeavesATankStill)
{
    constexpr int n = 20;
    const double c0 = 10*std::sqrt(g);
    particleFlowModel<2> m = modelOf<2>(1.0/n, c0);
    m.interaction.g = {{0, -g, 0}};
    m.shifting = 2;
    auto flow = newParticleFlow<2>(tank(n, c0), m, 1);
    run(*flow, 1.5);
    const particleState<2> s = flow->state();
    double highest = 0;
    for (std::size_t k = 0; k < s.size(); ++k)
    {
        if (s.wall[k] == particleState<2>::fluid)
        {
            EXPECT_TRUE(s.x[k][0] > 0 && s.x[k][0] < 1 && s.x[k][1] > 0);
            highest = std::max(highest, s.x[k][1]);
        }
    }
    EXPECT_LT(flow->maxSpeed(), 0.01*std::sqrt(g));
    EXPECT_NEAR(highest, 1 - 0.5/n, 0.2/n);
}


// Of a particle: along the surface alone, not past a wall, half the way to a plane
TEST(ParticleShifting, limits)
{
    shiftingParticle<2> p;
    p.x = {{0.5, 0.01}};
    p.speed = 1;
    p.concentration = {{3, 4}};
    p.positionDivergence = 2;
    p.nearSurface = false;
    p.surfaceNormal = {{0, -2}};
    p.wallDistance = 1e7;
    const auto shift = [&](const std::vector<symmetryPlane>& planes)
    {
        return p.shift(2, 0.1, 0.1, 0.001, planes);
    };
    const auto expect = [&](double x, double y, const std::vector<symmetryPlane>& planes)
    {
        const auto s = shift(planes);
        EXPECT_NEAR(s[0], x, 1e-15);
        EXPECT_NEAR(s[1], y, 1e-15);
    };
    expect(-6e-4, -8e-4, {});
    expect(-6e-4, -8e-4, {{1, 0, 1}});
    expect(-6e-4, -5e-4, {{1, 0.009, 1}});
    expect(-6e-4, 0, {{1, 0.01, 1}});
    expect(-6e-4, -8e-4, {{1, 0.1, -1}});
    p.nearSurface = true;
    expect(-6e-4, 0, {});
    p.positionDivergence = 1.4;
    expect(0, 0, {});
    p.positionDivergence = 2;
    p.nearSurface = false;
    p.wallDistance = 0.05*std::sqrt(2) + 1e-3;
    expect(-3e-4, -4e-4, {});
    p.wallDistance = 0.07;
    expect(0, 0, {});
    p.wallDistance = 1;
    p.speed = 1e3;
    expect(-6e-3, -8e-3, {});
}


TEST(ParticleFlow, twins)
{
    particleFlowModel<2> m = modelOf<2>(0.01, 30);
    auto one = newParticleFlow<2>(collision(), m, 1);
    auto two = newParticleFlow<2>(collision(), m, 2);
    m.singlePrecision = true;
    auto single = newParticleFlow<2>(collision(), m, 2);
    run(*one, 0.03);
    run(*two, 0.03);
    run(*single, 0.03);

    // The number of threads changes nothing
    const particleState<2> a = one->state();
    const particleState<2> b = two->state();
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.v, b.v);
    EXPECT_EQ(a.density, b.density);

    // Stopped and started again at the same time
    m.singlePrecision = false;
    auto first = newParticleFlow<2>(collision(), m, 2);
    run(*first, 0.015);
    auto second = newParticleFlow<2>(first->state(), m, 2);
    run(*first, 0.03);
    run(*second, 0.03);
    const particleState<2> whole = first->state();
    const particleState<2> split = second->state();
    const particleState<2> f = single->state();
    double restarted = 0;
    double inSingle = 0;
    for (std::size_t k = 0; k < whole.size(); ++k)
    {
        for (int d = 0; d < 2; ++d)
        {
            restarted = std::max(restarted, std::abs(whole.x[k][d] - split.x[k][d]));
            inSingle = std::max(inSingle, std::abs(a.x[k][d] - f.x[k][d]));
        }
    }
    EXPECT_LT(restarted, 1e-12);
    EXPECT_LT(inSingle, 1e-3*m.spacing);
    EXPECT_GT(inSingle, 0);
}


// With all that adds to the state, and planes of symmetry
TEST(ParticleFlow, restartWithEveryChoice)
{
    particleFlowModel<2> m = modelOf<2>(0.01, 30);
    m.interaction.diffusion = diffusionType::Antuono;
    m.shifting = 2;
    m.energy = true;
    m.symmetry.push_back({1, 0, 1});
    for (const timeSteppingType timeStepping : {timeSteppingType::Verlet, timeSteppingType::symplectic})
    {
        m.timeStepping = timeStepping;
        auto first = newParticleFlow<2>(collision(), m, 2);
        run(*first, 0.015);
        auto second = newParticleFlow<2>(first->state(), m, 1);
        run(*first, 0.03);
        run(*second, 0.03);
        const particleState<2> whole = first->state();
        const particleState<2> split = second->state();
        double apart = 0;
        double energyApart = 0;
        for (std::size_t k = 0; k < whole.size(); ++k)
        {
            for (int d = 0; d < 2; ++d)
            {
                apart = std::max(apart, std::abs(whole.x[k][d] - split.x[k][d]));
            }
            energyApart = std::max(energyApart, std::abs(whole.energy[k] - split.energy[k]));
            energyApart = std::max(energyApart, std::abs(whole.heat[k] - split.heat[k]));
        }
        EXPECT_LT(apart, 1e-12);
        EXPECT_LT(energyApart, 1e-12);
        EXPECT_GT(first->energy().dissipated, 0);
    }
}


TEST(ParticleFlow, stepsDoNotAllocate)
{
    particleFlowModel<2> m = modelOf<2>(0.01, 30);
    m.interaction.diffusion = diffusionType::Antuono;
    m.shifting = 2;
    m.energy = true;
    auto flow = newParticleFlow<2>(collision(), m, 1);
    run(*flow, 0.03);
    const long searches = flow->nSearches();
    const long before = nAllocations;
    for (int k = 0; k < 20; ++k)
    {
        flow->advance(0.5*flow->stableTimeStep());
    }
    EXPECT_EQ(nAllocations - before, 0);
    EXPECT_GT(searches, 1);
}


TEST(ParticleFlow, badInputIsRefused)
{
    const particleFlowModel<2> good = modelOf<2>(0.01, 30);
    auto refusal = [&](void (*spoil)(particleFlowModel<2>&))
    {
        particleFlowModel<2> m = good;
        spoil(m);
        return messageOf<std::invalid_argument>([&]{newParticleFlow<2>(collision(), m, 1);});
    };
    EXPECT_EQ(refusal([](particleFlowModel<2>& m){m.spacing = 0;}), "spacing is 0: expected a number above 0");
    EXPECT_EQ(refusal([](particleFlowModel<2>& m){m.rho0 = -1;}), "rho0 is -1: expected a number above 0");
    EXPECT_EQ(refusal([](particleFlowModel<2>& m){m.interaction.gamma = 1;}), "gamma is 1: expected a number above 1");
    EXPECT_EQ(refusal([](particleFlowModel<2>& m){m.interaction.h = 0.2;}), "h is 20: expected 1 to 10 spacings");
    EXPECT_EQ(refusal([](particleFlowModel<2>& m){m.interaction.alpha = -1;}), "alpha is -1: expected 0 or above");
    EXPECT_EQ(refusal([](particleFlowModel<2>& m){m.shifting = -1;}), "shifting is -1: expected 0 or above");
    const std::string rings = refusal
    (
        [](particleFlowModel<2>& m)
        {
            m.interaction.axisymmetric = true;
            m.interaction.leastRadius = 0.002;
        }
    );
    EXPECT_EQ(rings.find("axisymmetric: expected two dimensions, the plane x = 0 as one of symmetry"), 0u) << rings;
    EXPECT_EQ
    (
        refusal([](particleFlowModel<2>& m){m.interaction.c0 = std::numeric_limits<double>::quiet_NaN();}),
        "c0 is nan: expected a number above 0"
    );
    EXPECT_NE
    (
        messageOf<std::invalid_argument>([&]{newParticleFlow<2>(particleState<2>(), good, 1);}).find("no particle"),
        std::string::npos
    );

    particleState<2> broken = collision();
    broken.v[7][1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ
    (
        messageOf<std::invalid_argument>([&]{newParticleFlow<2>(broken, good, 1);}),
        "particle 7 starts with a position, velocity or density that is not a number"
    );

    // A run that blows up stops and says where and when
    auto blown = newParticleFlow<2>(collision(), good, 1);
    const std::string message = messageOf<std::runtime_error>
    (
        [&]
        {
            for (int k = 0; k < 100; ++k)
            {
                blown->advance(0.1);
            }
        }
    );
    EXPECT_NE(message.find("that is not a number at 0."), std::string::npos) << message;

    auto flow = newParticleFlow<2>(collision(), good, 1);
    EXPECT_THROW(flow->advance(-1), std::invalid_argument);
}
