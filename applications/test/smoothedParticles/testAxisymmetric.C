// SPDX-License-Identifier: GPL-3.0-or-later
// Particles that are rings, on the axis and beside it: at rest, in flows whose solution is known, about a sphere.

#include <gtest/gtest.h>

#include "particleScenes.H"

using namespace Foam::smoothedParticles;
using Foam::bodyLoads;
using namespace Foam::smoothedParticles::test;

namespace
{

//- About the axis x = 0
void makeRings(particleFlowModel<2>& m)
{
    m.interaction.axisymmetric = true;
    m.interaction.leastRadius = 0.25*m.spacing;
    m.symmetry = {{0, 0, 1}};
}


//- Of a round tank at rest: pressure in its lower half, largest error on the axis and anywhere, and force on the floor, over the
//  exact ones; and the highest speed [m/s]
struct atRest
{
    double onAxis, anywhere, floor, speed;
};

atRest stillTank(int n, double end)
{
    const double spacing = 1.0/n;
    constexpr double c0 = 30;
    particleFlowModel<2> m = modelOf<2>(spacing, c0);
    makeRings(m);
    m.interaction.alpha = 0.05;
    m.interaction.g = {{0, -g, 0}};
    particleState<2> s;
    for (int i = 0; i < n/2 + 5; ++i)
    {
        for (int j = -5; j < n + 5; ++j)
        {
            const std::array<double, 2> x{{(i + 0.5)*spacing, (j + 0.5)*spacing}};
            const bool inside = i < n/2 && j >= 0;
            if (!inside || j < n)
            {
                addParticle<2>(s, x, {{0, 0}}, inside ? densityOf(rho0*g*(1 - x[1]), c0) : 0, inside ? s.fluid : j < 0 ? 0 : 1);
            }
        }
    }
    auto flow = newParticleFlow<2>(s, m, 1);
    double force = 0, samples = 0;
    while (flow->time() < end)
    {
        flow->advance(flow->stableTimeStep());
        if (flow->time() > 0.5*end)
        {
            force -= flow->wallForces()[0][1];
            ++samples;
        }
    }
    double weight = 0;
    for (std::size_t k = 0; k < s.size(); ++k)
    {
        weight += s.wall[k] == s.fluid ? flow->state().mass[k]*g : 0;
    }
    atRest result{0, 0, force/samples/weight, 0};
    const particleState<2> now = flow->state();
    for (std::size_t k = 0; k < now.size(); ++k)
    {
        if (now.wall[k] == now.fluid)
        {
            const double off = now.x[k][1] < 0.5 ? std::abs(now.pressure[k]/(rho0*g*(1 - now.x[k][1])) - 1) : 0;
            result.anywhere = std::max(result.anywhere, off);
            result.onAxis = std::max(result.onAxis, now.x[k][0] < 2*spacing ? off : 0);
            result.speed = std::max(result.speed, std::hypot(now.v[k][0], now.v[k][1]));
        }
    }
    return result;
}


//- A ball of 1 m that is drawn out along the axis (rate above 0), to a column, or pressed flat
//
//     u = (-s x/2, s y),  p = p0 (1 - (x/a)^2 - (y/b)^2):  s' = s^2 (a^2/4 - b^2)/(b^2 + a^2/2),  a' = -s a/2,  b' = s b
//
//  which follows from Euler's equations along x and y with the same p0.
struct spheroid
{
    double a, b;
};

spheroid exactSpheroid(double rate, double end)
{
    double s = rate, a = 1, b = 1;
    constexpr int n = 20000;
    const double dt = end/n;
    const auto change = [](double s, double a, double b){ return s*s*(0.25*a*a - b*b)/(b*b + 0.5*a*a); };
    for (int k = 0; k < n; ++k)
    {
        // Midpoints
        const double sm = s + 0.5*dt*change(s, a, b);
        const double am = a - 0.25*dt*s*a;
        const double bm = b + 0.5*dt*s*b;
        s += dt*change(sm, am, bm);
        a -= 0.5*dt*sm*am;
        b += dt*sm*bm;
    }
    return {a, b};
}


//- By the moments of the mass, over those of the start
spheroid semiAxes(const particleState<2>& s)
{
    double mass = 0, xx = 0, yy = 0;
    for (std::size_t k = 0; k < s.size(); ++k)
    {
        mass += s.mass[k];
        xx += s.mass[k]*s.x[k][0]*s.x[k][0];
        yy += s.mass[k]*s.x[k][1]*s.x[k][1];
    }
    return {std::sqrt(xx/mass), std::sqrt(yy/mass)};
}


//- Added mass of a sphere in the middle of a hollow one of three times its radius, over the exact one (Lamb 1932, art. 93:
//  2/3 pi rho a^3 (b^3 + 2 a^3)/(b^3 - a^3)), from the acceleration of a sphere a hundredth as heavy as the liquid
double addedMassRatio(int n)
{
    constexpr double radius = 0.1;
    constexpr double outer = 3*radius;
    constexpr double c0 = 200;
    const double spacing = radius/n;
    particleFlowModel<2> m = idealModel<2>(spacing, c0);
    m.interaction.diffusion = diffusionType::Molteni;
    makeRings(m);
    const double compressed = densityOf(6000, c0);
    particleState<2> s;
    for (int layer = -5; layer < 2*n + 5; ++layer)
    {
        const double r = radius + (layer + 0.5)*spacing;
        const int parts = 4*std::lround(0.5*pi*r/spacing);
        for (int k = 0; k < parts/2; ++k)
        {
            const double angle = 2*pi*(k + 0.5)/parts;
            const double volume = 2*pi*r*std::sin(angle)*2*pi*r*spacing/parts;
            const bool fluid = layer >= 0 && layer < 2*n;
            addParticle<2>
            (
                s, {{r*std::sin(angle), r*std::cos(angle)}}, {{0, 0}}, fluid ? compressed : 0, fluid ? s.fluid : layer < 0 ? 0 : 1
            );
            s.mass.push_back((rho0 + s.density.back())*volume);
        }
    }

    const double displaced = rho0*4.0/3*pi*std::pow(radius, 3);
    const double exact = 0.5*29/26*displaced;
    const double mass = 0.01*displaced;
    drivenBody body(0, mass, {{false, true}}, {{0, 0}});
    auto flow = newParticleFlow<2>(s, m, 1, {{0, body.state}}, body.response());
    std::vector<double> t, v;
    while (flow->time() < 0.03)
    {
        const double part = std::min(1.0, flow->time()/0.01);
        body.advance(*flow, flow->stableTimeStep(), Foam::vector(0, 10*(exact + mass)*part*part*(3 - 2*part), 0));
        if (part >= 1)
        {
            t.push_back(flow->time());
            v.push_back(body.state.velocity[1]);
        }
    }
    return (10*(exact + mass)/slope(t, v) - mass)/exact;
}

} // End anonymous namespace


// As in the plane: to the floor, on the axis and beside it
TEST(Axisymmetric, atRest)
{
    const atRest still = stillTank(20, 3);
    EXPECT_LT(still.onAxis, 0.01);
    EXPECT_LT(still.anywhere, 0.01);
    EXPECT_NEAR(still.floor, 1, 0.01);
    EXPECT_LT(still.speed, 0.01*std::sqrt(g));
}


TEST(Axisymmetric, spheroids)
{
    constexpr int n = 20;
    for (const double rate : {1.0, -1.0})
    {
        particleFlowModel<2> m = idealModel<2>(1.0/n, 15);
        m.interaction.diffusion = diffusionType::Molteni;
        makeRings(m);
        m.energy = true;
        particleState<2> block, s;
        addBlock<2>(block, 1.0/n, {{0, -1}}, {{n, 2*n}}, {{0, 0}});
        for (const auto& x : block.x)
        {
            if (std::hypot(x[0], x[1]) < 1)
            {
                addParticle<2>(s, x, {{-0.5*rate*x[0], rate*x[1]}}, 0, s.fluid);
            }
        }
        auto flow = newParticleFlow<2>(s, m, 1);
        const spheroid start = semiAxes(flow->state());
        const auto before = flow->energy();
        run(*flow, 0.8);
        const spheroid now = semiAxes(flow->state());
        const spheroid exact = exactSpheroid(rate, 0.8);
        EXPECT_NEAR(now.a/start.a, exact.a, 0.02*exact.a) << rate;
        EXPECT_NEAR(now.b/start.b, exact.b, 0.02*exact.b) << rate;
        EXPECT_NEAR(total<2>(flow->energy()), total<2>(before), 0.02*before.kinetic) << rate;
        EXPECT_NEAR(flow->energy().budget(), before.budget(), 0.02*before.kinetic) << rate;
    }
}


TEST(Axisymmetric, addedMassOfASphere)
{
    EXPECT_NEAR(addedMassRatio(10), 1, 0.02);
}
