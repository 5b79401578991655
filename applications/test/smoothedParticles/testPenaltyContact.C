// SPDX-License-Identifier: GPL-3.0-or-later
// Contact by springs: depths by hand, weight, momentum, time step.

#include <gtest/gtest.h>

#include "particleFlow.H"

#include "IStringStream.H"
#include "OSspecific.H"

#include <cmath>
#include <fstream>

#include <unistd.h>

using namespace Foam;
using namespace Foam::smoothedParticles;

namespace
{

constexpr double spacing = 0.1;
constexpr double radius = 0.05;
constexpr double thickness = 0.3;


contactSurface surfaceOf(const std::string& entries, int dim, double dp = spacing, const fileName& directory = ".")
{
    IStringStream stream("name wall; " + entries);
    return contactSurface(shape::New(dictionary(stream), {dim, directory, thickness/spacing*dp}), dp);
}


//- Expects this depth along this normal; no touch for a depth of 0
void expectTouch(const contactSurface& surface, const point& x, double depth, const vector& normal)
{
    shape::touching t;
    const bool touches = surface.touch(x, t);
    EXPECT_EQ(touches, depth > 0) << "at " << x.x() << ' ' << x.y() << ' ' << x.z();
    if (touches && depth > 0)
    {
        EXPECT_NEAR(t.depth, depth, 1e-12);
        EXPECT_LT(mag(t.normal - normal), 1e-12);
    }
}


particleFlowModel<2> modelOf(double dp, double c0)
{
    particleFlowModel<2> m;
    m.spacing = dp;
    m.rho0 = 1000;
    m.interaction.h = 1.5*dp;
    m.interaction.c0 = c0;
    m.interaction.viscosity = viscosityType::artificial;
    m.interaction.alpha = 0.1;
    m.singlePrecision = false;
    m.contact.stiffness = contactStiffness::node;
    m.contact.factor = 0.1;
    return m;
}


//- A block of n[0] times n[1] particles from this corner
particleState<2> block(double dp, double x, double y, int nx, int ny, double vx)
{
    particleState<2> s;
    for (int i = 0; i < nx; ++i)
    {
        for (int j = 0; j < ny; ++j)
        {
            s.x.push_back({{x + (i + 0.5)*dp, y + (j + 0.5)*dp}});
            s.v.push_back({{vx, 0}});
            s.density.push_back(0);
            s.wall.push_back(particleState<2>::fluid);
        }
    }
    return s;
}


//- At a point, turned by an angle about z
bodyState poseOf(const point& centre, double angle)
{
    bodyState s;
    s.centreOfMass = centre;
    s.orientation = tensor(std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1);
    s.velocity = s.omega = s.acceleration = s.angularAcceleration = Zero;
    return s;
}


//- A body in the plane that velocity Verlet moves together with the flow
struct planeBody
{
    double mass, inertia;
    point x;
    vector v;
    double angle, omega;

    void kick(const bodyLoads& loads, double deltaT)
    {
        v += deltaT/mass*loads.pressure;
        omega += deltaT/inertia*loads.moment.z();
    }

    void drift(double deltaT)
    {
        x += deltaT*v;
        angle += deltaT*omega;
    }
};

} // End anonymous namespace


TEST(ContactSurface, tank)
{
    const auto tank = surfaceOf("type box; min (0 0 0); max (1 2 0); open (top);", 2);
    expectTouch(tank, point(0.5, 1, 0), 0, Zero);
    expectTouch(tank, point(0.05 + 1e-9, 1, 0), 0, Zero);
    expectTouch(tank, point(0.02, 1, 0), 0.03, vector(1, 0, 0));
    expectTouch(tank, point(1.1, 1, 0), 0.15, vector(-1, 0, 0));
    expectTouch(tank, point(0.5, -0.05, 0), 0.1, vector(0, 1, 0));
    // Both faces of a corner
    expectTouch(tank, point(-0.04, -0.07, 0), 0.15, vector(0.6, 0.8, 0));
    // Over the open top there is no wall, and the nearest way out of the wall is over the rim or to the outside
    expectTouch(tank, point(0.5, 2, 0), 0, Zero);
    expectTouch(tank, point(-0.1, 2.06, 0), 0, Zero);
    expectTouch(tank, point(-0.1, 2.02, 0), 0.03, vector(0, 1, 0));
    expectTouch(tank, point(-0.25, 1, 0), 0.1, vector(-1, 0, 0));
    expectTouch(tank, point(-0.36, 1, 0), 0, Zero);
}


TEST(ContactSurface, boxAndSphere)
{
    const auto box = surfaceOf("type box; solid yes; min (0 0 0); max (1 1 1);", 3);
    expectTouch(box, point(0.5, 0.5, 1.06), 0, Zero);
    expectTouch(box, point(0.5, 0.5, 1.02), 0.03, vector(0, 0, 1));
    expectTouch(box, point(0.5, 0.1, 0.6), 0.15, vector(0, -1, 0));
    expectTouch(box, point(1.03, 1.04, 0.5), 0, Zero);
    expectTouch(box, point(1.018, 1.024, 0.5), 0.02, vector(0.6, 0.8, 0));

    const auto sphere = surfaceOf("type sphere; centre (1 0 0); radius 0.5;", 3);
    expectTouch(sphere, point(1, 0.56, 0), 0, Zero);
    expectTouch(sphere, point(1.324, 0.432, 0), 0.01, vector(0.6, 0.8, 0));
    expectTouch(sphere, point(1, 0, -0.3), 0.25, vector(0, 0, -1));
}


// The unit cube in triangles is the box
TEST(ContactSurface, triangles)
{
    const fileName directory(fileName("contactSurface." + std::to_string(::getpid())));
    mkDir(directory);
    // From the ground, and half below it, for the cut with z = 0
    for (const char* name : {"cube.obj", "sunk.obj"})
    {
        std::ofstream os(directory/name);
        const double lowest = name[0] == 's' ? -0.5 : 0;
        for (int i = 0; i < 8; ++i)
        {
            os << "v " << (i & 1) << ' ' << (i >> 1 & 1) << ' ' << lowest + (i >> 2) << '\n';
        }
        // Normals as they come: orientation is not asked for
        for (const char* f : {"1 2 4", "1 4 3", "5 6 8", "5 8 7", "1 2 6", "1 6 5", "3 4 8", "3 8 7", "1 3 7", "1 7 5", "2 4 8", "2 8 6"})
        {
            os << "f " << f << '\n';
        }
    }
    const auto cube = surfaceOf("type surface; file cube.obj;", 3, spacing, directory);
    const auto box = surfaceOf("type box; solid yes; min (0 0 0); max (1 1 1);", 3);
    const auto square = surfaceOf("type surface; file sunk.obj;", 2, spacing, directory);
    const auto flat = surfaceOf("type box; solid yes; min (0 0 0); max (1 1 0);", 2);
    rmDir(directory);

    int nTouching = 0;
    for (double x = -0.0717; x < 1.1; x += 0.0931)
    {
        for (double y = -0.0623; y < 1.1; y += 0.1033)
        {
            for (double z = -0.0571; z < 1.1; z += 0.0877)
            {
                shape::touching t;
                const bool touches = box.touch(point(x, y, z), t);
                nTouching += touches;
                expectTouch(cube, point(x, y, z), touches ? t.depth : 0, t.normal);
            }
            shape::touching t;
            const bool touches = flat.touch(point(x, y, 0), t);
            expectTouch(square, point(x, y, 0), touches ? t.depth : 0, t.normal);
        }
    }
    EXPECT_GT(nTouching, 1000);
    EXPECT_NEAR(cube.maxArea(), 0.5, 1e-12);
    // The plane crosses each side's two triangles
    EXPECT_NEAR(square.maxArea(), 0.5, 1e-12);
}


// A block falls to the floor of a tank, with sides that keep it, and comes to rest where the springs bear its weight:
// each of the lowest row as deep as its column weighs
TEST(PenaltyContact, blockRests)
{
    constexpr double dp = 0.02, g = 9.81;
    constexpr int nx = 5, ny = 10;
    for (const contactStiffness stiffness : {contactStiffness::node, contactStiffness::segment})
    {
        particleFlowModel<2> m = modelOf(dp, 20);
        m.interaction.alpha = 1;
        m.interaction.g = {{0, -g, 0}};
        m.contact.stiffness = stiffness;
        m.contact.bulkModulus = 1e7;
        m.contact.thickness = 0.5;
        m.contact.walls = {surfaceOf("type box; min (0 0 0); max (0.1 1 0); open (top);", 2, dp)};
        auto flow = newParticleFlow<2>(block(dp, 0, 0.5*dp, nx, ny, 0), m, 1);
        while (flow->time() < 3)
        {
            flow->advance(flow->stableTimeStep());
        }
        const double mass = m.rho0*dp*dp;
        const double step = m.Courant*m.interaction.h/m.interaction.c0;
        const double k = stiffness == contactStiffness::node ? 0.1*mass/(step*step) : 0.1*dp*1e7/0.5;
        const particleState<2> s = flow->state();
        double depth = 0;
        double lowest = 1;
        for (std::size_t i = 0; i < s.size(); ++i)
        {
            depth += std::max(0.5*dp - s.x[i][1], 0.0);
            lowest = std::min(lowest, s.x[i][1]);
            EXPECT_GT(s.x[i][0], 0);
            EXPECT_LT(s.x[i][0], 0.1);
        }
        EXPECT_NEAR(depth, nx*ny*mass*g/k, 0.02*nx*ny*mass*g/k);
        EXPECT_NEAR(-flow->wallForces()[0][1], nx*ny*mass*g, 0.02*nx*ny*mass*g);
        EXPECT_GT(lowest, 0);
        EXPECT_LT(flow->maxSpeed(), 0.02*std::sqrt(g*ny*dp));
        EXPECT_GT(flow->energy().contact, 0);
    }
}


// A block hits a free box off its centre: linear and angular momentum of both together stay, to round-off
TEST(PenaltyContact, momentumIsKept)
{
    constexpr double dp = 0.01;
    particleFlowModel<2> m = modelOf(dp, 30);
    m.contact.walls = {surfaceOf("type box; solid yes; min (0.1 0 0); max (0.15 0.1 0);", 2, dp)};
    planeBody body{4, 0.005, point(0.125, 0.05, 0), Zero, 0, 0};
    m.contact.homes[0] = poseOf(body.x, 0);
    auto flow = newParticleFlow<2>(block(dp, 0, 0.06, 8, 8, 2), m, 2, m.contact.homes);

    const auto momenta = [&]
    {
        vector linear(body.mass*body.v);
        double angular = body.inertia*body.omega + (body.x ^ linear).z();
        const particleState<2> s = flow->state();
        for (std::size_t k = 0; k < s.size(); ++k)
        {
            const vector p(s.mass[k]*vector(s.v[k][0], s.v[k][1], 0));
            linear += p;
            angular += (vector(s.x[k][0], s.x[k][1], 0) ^ p).z();
        }
        return vector(linear.x(), linear.y(), angular);
    };

    const vector start(momenta());
    while (flow->time() < 0.06)
    {
        const double deltaT = flow->stableTimeStep();
        body.kick(flow->wallLoads(0), 0.5*deltaT);
        body.drift(deltaT);
        flow->moveWall(0, poseOf(body.x, body.angle));
        flow->advance(deltaT);
        body.kick(flow->wallLoads(0), 0.5*deltaT);
    }
    EXPECT_LT(mag(momenta() - start), 1e-12*mag(start));
    EXPECT_GT(body.v.x(), 0.3);
    EXPECT_LT(body.omega, -1);
}


// The springs of eq. 7 have their say in the time step; those of eq. 8 do not need it
TEST(PenaltyContact, timeStep)
{
    constexpr double dp = 0.01;
    particleFlowModel<2> m = modelOf(dp, 30);
    m.contact.walls = {surfaceOf("type box; min (0 0 0); max (1 1 0);", 2, dp)};
    const particleState<2> s = block(dp, 0.2, 0.2, 4, 4, 0);
    const double sound = m.Courant*m.interaction.h/30;
    EXPECT_DOUBLE_EQ(newParticleFlow<2>(s, m, 1)->stableTimeStep(), sound);
    m.contact.factor = 1;
    EXPECT_NEAR(newParticleFlow<2>(s, m, 1)->stableTimeStep(), sound, 1e-12*sound);
    m.contact.stiffness = contactStiffness::segment;
    m.contact.bulkModulus = 1e9;
    m.contact.thickness = 0.02;
    const double k = dp*1e9/0.02;
    EXPECT_DOUBLE_EQ(newParticleFlow<2>(s, m, 1)->stableTimeStep(), std::sqrt(1000*dp*dp/k));
}


// What is deeper than maxDepth is let go; the number of threads changes nothing
TEST(PenaltyContact, depthAndThreads)
{
    constexpr double dp = 0.01;
    particleFlowModel<2> m = modelOf(dp, 30);
    m.contact.walls = {surfaceOf("type sphere; centre (0.15 0.05 0); radius 0.05;", 2, dp)};
    const auto end = [&](int nThreads)
    {
        auto flow = newParticleFlow<2>(block(dp, 0, 0, 10, 10, 2), m, nThreads);
        while (flow->time() < 0.04)
        {
            flow->advance(flow->stableTimeStep());
        }
        const particleState<2> s = flow->state();
        double nearest = 1;
        for (const auto& x : s.x)
        {
            nearest = std::min(nearest, std::hypot(x[0] - 0.15, x[1] - 0.05));
        }
        return std::make_pair(s, nearest);
    };
    const auto one = end(1);
    EXPECT_EQ(one.first.x, end(2).first.x);
    EXPECT_GT(one.second, 0.05 - 0.5*dp);
    m.contact.maxDepth = 0.01*dp;
    EXPECT_LT(end(1).second, 0.04);
}
