// SPDX-License-Identifier: GPL-3.0-or-later
// Walls that move, planes of symmetry and absorbing layers: forces of the liquid on bodies against exact ones, and twins.

#include <gtest/gtest.h>

#include "particleScenes.H"

using namespace Foam::smoothedParticles;
using Foam::bodyLoads;
using Foam::bodyState;
using Foam::tensor;
using namespace Foam::smoothedParticles::test;

namespace
{

//- Liquid at rest up to a level, [0, width] or [-width, width] wide and symmetric, on a floor, wall 0, around a circle, wall 1
particleState<2> tankWithCircle(double spacing, double width, double level, double radius, double height, double c0, bool right)
{
    const int n = std::lround(width/spacing);
    particleState<2> s, block;
    addBlock<2>(block, spacing, {{-width, 0}}, {{2*n, int(std::lround(level/spacing))}}, {{0, 0}});
    for (const auto& x : block.x)
    {
        if (std::hypot(x[0], x[1] - height) > radius + 0.4*spacing)
        {
            const double density = densityOf(rho0*g*(level - x[1]), c0);
            addParticle<2>(s, x, {{0, 0}}, density, s.fluid);
            s.mass.push_back((rho0 + density)*spacing*spacing);
        }
    }
    for (int i = -n - 5*right; i < n + 5*right; ++i)
    {
        for (int j = -5; j < (i < -n || i >= n ? std::lround(level/spacing) + 5 : 0); ++j)
        {
            addParticle<2>(s, {{(i + 0.5)*spacing, (j + 0.5)*spacing}}, {{0, 0}}, 0, 0);
            s.mass.push_back(rho0*spacing*spacing);
        }
    }
    addCircle(s, spacing, radius, {{0, height}}, 1);
    return s;
}


//- All at once: half a tank with friction at its walls, a layer that absorbs, half a circle that rises
struct everything
{
    static constexpr double spacing = 0.025;
    static constexpr double c0 = 25;
    static constexpr double radius = 0.12;

    particleFlowModel<2> model;
    std::unique_ptr<particleFlow<2>> flow;
    drivenBody body;

    everything(bool half, int nThreads, bool singlePrecision, double ratio = 0.4)
    :
        model(modelOf<2>(spacing, c0)),
        body(1, (half ? 0.5 : 1)*ratio*rho0*pi*radius*radius, {{false, true}}, {{0, 0.3}})
    {
        model.interaction.viscosity = viscosityType::laminar;
        model.interaction.mu = 2;
        model.interaction.noSlip = true;
        model.interaction.g = {{0, -g, 0}};
        model.singlePrecision = singlePrecision;
        model.absorption.thickness = 0.2;
        model.absorption.min = {{-0.6, 0, 0}};
        model.absorption.max = {{0.6, 1, 0}};
        model.absorption.absorbs[0] = model.absorption.absorbs[1] = true;
        model.absorption.surface = 0.6;
        particleState<2> s(tankWithCircle(spacing, 0.6, 0.6, radius, 0.3, c0, true));
        if (half)
        {
            s = above<2>(s, 0);
            model.symmetry = {{0, 0, 1}};
        }
        start(s, nThreads);
    }

    void start(const particleState<2>& s, int nThreads)
    {
        wallMotions motions;
        motions[1] = body.state;
        body.force = Foam::vector(0, -body.mass*g, 0);
        flow = newParticleFlow<2>(s, model, nThreads, motions, body.response());
    }

    void advance(double deltaT)
    {
        body.advance(*flow, deltaT, Foam::vector(0, -body.mass*g, 0));
    }

    void run(int steps)
    {
        for (int k = 0; k < steps; ++k)
        {
            advance(8e-4);
        }
    }
};

//- Largest difference of positions [m]
double difference(const particleState<2>& a, const particleState<2>& b)
{
    EXPECT_EQ(a.size(), b.size());
    double largest = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    {
        for (int d = 0; d < 2; ++d)
        {
            largest = std::max(largest, std::abs(a.x[k][d] - b.x[k][d]));
        }
    }
    return largest;
}


//- Added mass over that of the liquid, of a circle in the middle of a closed square of side 1. The walls' mirror images of
//  its dipole, of alternate sign along the motion, bring sum (-1)^m/(m + i n)^2 = S, and (1 + R^2 S)/(1 - R^2 S).
double addedMass(double radius)
{
    double S = pi*pi/6;
    for (int n = 1; n < 8; ++n)
    {
        S += 2*pi*pi*std::cosh(pi*n)/std::pow(std::sinh(pi*n), 2);
    }
    return (1 + radius*radius*S)/(1 - radius*radius*S);
}


//- Acceleration of a circle of this density over the liquid's in that square under a force, over the exact one. No gravity; the
//  pressure is well above zero everywhere. The force grows smoothly, so that it makes little sound; nothing has gone far.
double accelerationRatio(double density)
{
    constexpr int n = 40;
    constexpr double spacing = 1.0/n;
    constexpr double radius = 0.1;
    constexpr double c0 = 60;
    particleFlowModel<2> m = idealModel<2>(spacing, c0);
    m.interaction.diffusion = diffusionType::Molteni;
    m.symmetry = {{0, -0.5, 1}, {0, 0.5, -1}, {1, -0.5, 1}, {1, 0.5, -1}};
    particleState<2> s, block;
    addBlock<2>(block, spacing, {{-0.5, -0.5}}, {{n, n}}, {{0, 0}});
    const double compressed = densityOf(6000, c0);
    for (const auto& x : block.x)
    {
        if (std::hypot(x[0], x[1]) > radius + 0.4*spacing)
        {
            addParticle<2>(s, x, {{0, 0}}, compressed, s.fluid);
        }
    }
    s.mass.assign(s.size(), (rho0 + compressed)*(1 - pi*radius*radius)/s.size());
    addCircle(s, spacing, radius, {{0, 0}}, 0);

    const double displaced = rho0*pi*radius*radius;
    drivenBody body(0, density*displaced, {{true, true}}, {{0, 0}});
    auto flow = newParticleFlow<2>(s, m, 1, {{0, body.state}}, body.response());
    body.moves = {{false, false}};
    run(*flow, 0.1);
    body.moves = {{true, true}};

    const double force = 10*displaced*(density + addedMass(radius));
    std::vector<double> t, v;
    while (flow->time() < 0.17)
    {
        const double part = std::min(1.0, (flow->time() - 0.1)/0.02);
        body.advance(*flow, flow->stableTimeStep(), Foam::vector(force*part*part*(3 - 2*part), 0, 0));
        if (part >= 1)
        {
            t.push_back(flow->time());
            v.push_back(body.state.velocity[0]);
        }
    }
    EXPECT_NEAR(body.state.velocity[1], 0, 1e-6);
    return slope(t, v)/10;
}


//- Of a circle that floats, half of it left of a plane of symmetry: height of its centre over the level of the liquid at rest
//  after a time, from its lower starting point, and the share of its weight that the liquid carries
struct floating
{
    double height, load;
};

floating floatCircle(double radius, double ratio, double start)
{
    constexpr double spacing = 0.025;
    constexpr double c0 = 25;
    constexpr double level = 0.6;
    particleFlowModel<2> m = modelOf<2>(spacing, c0);
    m.interaction.alpha = 0.05;
    m.interaction.g = {{0, -g, 0}};
    m.symmetry = {{0, 0, 1}, {0, 1, -1}};
    m.absorption.thickness = 0.4;
    m.absorption.max = {{1, 2, 0}};
    m.absorption.absorbs[1] = true;
    m.absorption.surface = level;
    const particleState<2> s = above<2>(tankWithCircle(spacing, 1, level, radius, level + start, c0, false), 0);
    drivenBody body(1, 0.5*ratio*rho0*pi*radius*radius, {{false, true}}, {{0, level + start}});
    auto flow = newParticleFlow<2>(s, m, 1, {{1, body.state}}, body.response());

    // The tank is 1 wide
    double still = body.mass/rho0;
    for (std::size_t k = 0; k < s.size(); ++k)
    {
        still += s.wall[k] == s.fluid ? s.mass[k]/(rho0 + s.density[k]) : 0;
    }
    floating result{0, 0};
    double weight = 0;
    while (flow->time() < 4)
    {
        const double deltaT = flow->stableTimeStep();
        body.advance(*flow, deltaT, Foam::vector(0, -body.mass*g, 0));
        if (flow->time() > 2)
        {
            const bodyLoads loads = flow->wallLoads(1);
            result.height += deltaT*(body.state.centreOfMass[1] - still);
            result.load += deltaT*(loads.pressure[1] + loads.viscous[1])/(body.mass*g);
            weight += deltaT;
        }
    }
    result.height /= weight;
    result.load /= weight;
    return result;
}

} // End anonymous namespace


// The number of threads changes nothing; half a tank with mirror images is half of the whole tank; nothing is allocated
TEST(ParticleBodies, twinsWithEverything)
{
    everything one(true, 1, false), two(true, 2, false), single(true, 2, true), whole(false, 2, false);
    for (everything* each : {&one, &two, &single, &whole})
    {
        each->run(150);
    }
    EXPECT_GT(one.flow->nSearches(), 5);
    EXPECT_GT(one.body.state.centreOfMass[1], 0.3 + one.spacing);
    const particleState<2> a = one.flow->state();
    const particleState<2> b = two.flow->state();
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.v, b.v);
    EXPECT_EQ(a.density, b.density);

    EXPECT_LT(difference(a, single.flow->state()), 1e-4*one.spacing);
    EXPECT_LT(difference(a, above<2>(whole.flow->state(), 0)), 1e-10*one.spacing);
    const bodyLoads half = one.flow->wallLoads(1);
    const bodyLoads both = whole.flow->wallLoads(1);
    EXPECT_NEAR(2*half.pressure[1], both.pressure[1], 1e-9*both.pressure[1]);
    EXPECT_NEAR(2*half.viscous[1], both.viscous[1], 1e-9*both.pressure[1]);
    EXPECT_NEAR(both.pressure[0], 0, 1e-9*both.pressure[1]);
    EXPECT_NEAR(both.moment[2], 0, 1e-9*both.pressure[1]);
    EXPECT_NEAR(one.flow->wallForces()[1][1], half.pressure[1] + half.viscous[1], 1e-9*both.pressure[1]);

    const long searches = one.flow->nSearches();
    const long before = nAllocations;
    for (int k = 0; k < 20; ++k)
    {
        one.advance(1e-5);
    }
    EXPECT_EQ(nAllocations - before, 0);
    EXPECT_EQ(one.flow->nSearches(), searches);
}


// Built anew from its state, the flow goes on as it would have: a light body, which the pressure on it hangs on, too
TEST(ParticleBodies, restart)
{
    everything whole(true, 1, false, 0.1), split(true, 1, false, 0.1);
    whole.run(20);
    split.run(20);
    const double load = split.flow->wallLoads(1).pressure[1];
    split.start(split.flow->state(), 1);
    EXPECT_NEAR(split.flow->wallLoads(1).pressure[1], load, 1e-3*load);
    whole.run(50);
    split.run(50);
    EXPECT_LT(difference(whole.flow->state(), split.flow->state()), 1e-5*whole.spacing);
}


// A quarter of a collapse in a corner of two planes of symmetry, in space, is a quarter of the whole
TEST(ParticleBodies, quarterModel)
{
    constexpr double spacing = 0.02;
    particleState<3> whole;
    addBlock<3>(whole, spacing, {{-0.1, -0.1, 0}}, {{10, 10, 6}}, {{0, 0, 0}});
    particleState<3> floor;
    addBlock<3>(floor, spacing, {{-0.2, -0.2, -0.08}}, {{20, 20, 4}}, {{0, 0, 0}});
    for (const auto& x : floor.x)
    {
        addParticle<3>(whole, x, {{0, 0, 0}}, 0, 0);
    }
    particleFlowModel<3> m = modelOf<3>(spacing, 15);
    m.interaction.g = {{0, 0, -g}};
    m.interaction.viscosity = viscosityType::laminar;
    m.interaction.mu = 1;
    m.interaction.noSlip = true;
    auto full = newParticleFlow<3>(whole, m, 1);
    m.symmetry = {{1, 0, 1}, {0, 0, 1}};
    auto quarter = newParticleFlow<3>(above<3>(above<3>(whole, 0), 1), m, 1);
    for (int k = 0; k < 60; ++k)
    {
        full->advance(1.2e-3);
        quarter->advance(1.2e-3);
    }
    EXPECT_GT(quarter->nSearches(), 2);
    const particleState<3> part = quarter->state();
    const particleState<3> same = above<3>(above<3>(full->state(), 0), 1);
    ASSERT_EQ(part.size(), same.size());
    for (std::size_t k = 0; k < part.size(); ++k)
    {
        for (int d = 0; d < 3; ++d)
        {
            EXPECT_NEAR(part.x[k][d], same.x[k][d], 1e-9*spacing);
        }
    }
    EXPECT_NEAR(4*quarter->wallForces()[0][2], full->wallForces()[0][2], 1e-9*std::abs(full->wallForces()[0][2]));
}


// Planes of symmetry as the walls of a box that liquid falls into, hard: nothing goes through, the kinetic energy is lost
TEST(ParticleBodies, nothingGoesThroughPlanes)
{
    constexpr double spacing = 0.02;
    particleState<2> s;
    addBlock<2>(s, spacing, {{0, 0}}, {{10, 20}}, {{1, -4}});
    particleFlowModel<2> m = modelOf<2>(spacing, 15);
    m.interaction.diffusion = diffusionType::Molteni;
    m.interaction.g = {{0, -g, 0}};
    m.symmetry = {{0, 0, 1}, {0, 0.4, -1}, {1, 0, 1}};
    auto flow = newParticleFlow<2>(s, m, 1);
    run(*flow, 1.0);
    const particleState<2> end = flow->state();
    for (std::size_t k = 0; k < end.size(); ++k)
    {
        EXPECT_GE(end.x[k][0], 0);
        EXPECT_LE(end.x[k][0], 0.4);
        EXPECT_GE(end.x[k][1], 0);
    }
    EXPECT_LT(flow->energy().kinetic, flow->energy().potential);
}


// The particles of a body keep their distances and go exactly where it goes, turning too; nothing pushes it without liquid
TEST(ParticleBodies, freeFlight)
{
    particleState<2> s;
    addBlock<2>(s, 0.02, {{5, 5}}, {{4, 4}}, {{0, 0}});
    s.mass.assign(s.size(), rho0*4e-4);
    addCircle(s, 0.02, 0.1, {{0, 0}}, 0);
    drivenBody body(0, 1, {{false, false}}, {{0, 0}});
    for (const timeSteppingType steps : {timeSteppingType::Verlet, timeSteppingType::symplectic})
    {
        particleFlowModel<2> m = modelOf<2>(0.02, 10);
        m.timeStepping = steps;
        auto flow = newParticleFlow<2>(s, m, 1, {{0, body.state}});
        bodyState now = body.state;
        now.velocity = Foam::vector(1, 2, 0);
        now.omega = Foam::vector(0, 0, 3);
        constexpr double deltaT = 1e-3;
        for (int k = 1; k <= 1000; ++k)
        {
            const double t = k*deltaT;
            now.centreOfMass = t*now.velocity;
            now.orientation = tensor(std::cos(3*t), -std::sin(3*t), 0, std::sin(3*t), std::cos(3*t), 0, 0, 0, 1);
            flow->moveWall(0, now);
            flow->advance(deltaT);
        }
        const particleState<2> end = flow->state();
        for (std::size_t k = 16; k < end.size(); ++k)
        {
            const double x = std::cos(3.0)*s.x[k][0] - std::sin(3.0)*s.x[k][1] + 1;
            const double y = std::sin(3.0)*s.x[k][0] + std::cos(3.0)*s.x[k][1] + 2;
            EXPECT_NEAR(end.x[k][0], x, 1e-12);
            EXPECT_NEAR(end.x[k][1], y, 1e-12);

            // Mean of the last step
            EXPECT_NEAR(end.v[k][0], 1 - 3*(y - 2), 1e-3);
        }
        EXPECT_EQ(mag(flow->wallLoads(0).pressure), 0);
        EXPECT_EQ(mag(flow->wallLoads(0).moment), 0);
    }
}


// Added mass: a light body, which is nearly all added mass, is stable
TEST(ParticleBodies, addedMass)
{
    for (const double density : {3.0, 1.0, 0.1})
    {
        EXPECT_NEAR(accelerationRatio(density), 1, 0.06) << density;
    }
}


// A circle of half the liquid's density floats with its centre at the surface, and the liquid carries it
TEST(ParticleBodies, floats)
{
    const floating half = floatCircle(0.2, 0.5, -0.03);
    EXPECT_NEAR(half.height, 0, 0.25*0.025);
    EXPECT_NEAR(half.load, 1, 0.01);
}


// Archimedes: the force on a circle that is held, over the weight of the liquid that it displaces
TEST(ParticleBodies, Archimedes)
{
    constexpr double c0 = 30;
    constexpr double radius = 0.2;
    particleFlowModel<2> m = modelOf<2>(0.025, c0);
    m.interaction.alpha = 0.3;
    m.interaction.g = {{0, -g, 0}};
    m.symmetry = {{0, 0, 1}, {0, 0.5, -1}};
    const particleState<2> s = above<2>(tankWithCircle(0.025, 0.5, 1, radius, 0.5, c0, false), 0);
    auto flow = newParticleFlow<2>(s, m, 1, {{1, drivenBody(1, 1, {{false, false}}, {{0, 0.5}}).state}});
    run(*flow, 1.5);
    double sum = 0;
    double time = 0;
    while (flow->time() < 3)
    {
        const double deltaT = flow->stableTimeStep();
        flow->advance(deltaT);
        const bodyLoads loads = flow->wallLoads(1);
        sum += deltaT*(loads.pressure[1] + loads.viscous[1]);
        time += deltaT;
    }
    const double density = rho0 + densityOf(rho0*g*0.5, c0);
    EXPECT_NEAR(sum/time/(0.5*density*g*pi*radius*radius), 1, 0.015);
}


// Let go at rest in a deep tank, a circle far lighter than the liquid, or far heavier, moves as in an ideal fluid, to what six
// spacings along its radius resolve and the sound of the start leaves; m a is the force on it at each step
TEST(ParticleBodies, lightAndHeavy)
{
    constexpr double spacing = 0.02;
    constexpr double c0 = 28;
    constexpr double radius = 0.12;
    for (const double ratio : {0.001, 0.01, 0.1, 0.5, 20.0})
    {
        particleFlowModel<2> m = modelOf<2>(spacing, c0);
        m.interaction.g = {{0, -g, 0}};
        m.symmetry = {{0, 0, 1}, {0, 1.2, -1}};
        const particleState<2> s = above<2>(tankWithCircle(spacing, 1.2, 1.6, radius, 0.8, c0, false), 0);
        drivenBody body(1, 0.5*ratio*rho0*pi*radius*radius, {{false, true}}, {{0, 0.8}});
        body.force = Foam::vector(0, -body.mass*g, 0);
        auto flow = newParticleFlow<2>(s, m, 1, {{1, body.state}}, body.response());
        const double ideal = (1 - ratio)/(1 + ratio)*g;
        double largest = 0;
        for (const double end : {0.02, 0.05, 0.1})
        {
            while (flow->time() < end)
            {
                body.advance(*flow, std::min(flow->stableTimeStep(), end - flow->time()), body.force);
                largest = std::max(largest, std::abs(body.respond(flow->wallLoads(1)).linear[1]));
            }
            EXPECT_NEAR(body.state.velocity[1]/(ideal*end), 1, 0.1) << ratio << " at " << end;
        }
        // No swinging: at the start the liquid near by goes along, all of it when the sound has gone round
        EXPECT_LT(largest, 6*std::abs(ideal)) << ratio;
    }
}
