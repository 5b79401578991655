// SPDX-License-Identifier: GPL-3.0-or-later
// Particles from a dictionary: counted and placed by hand, refused where they cannot be.

#include <gtest/gtest.h>

#include "particleSetUp.H"
#include "../surfaceInCase.H"
#include "walls.H"

#include "IStringStream.H"

#include <algorithm>
#include <cmath>
#include <set>

using namespace Foam;
using namespace Foam::smoothedParticles;

namespace
{

//- Support 0.3 m: three layers of the spacing 0.1 m
constexpr double spacing = 0.1;
constexpr double support = 0.3;

constexpr double rho0 = 1000;
constexpr double c0 = 20;
constexpr double gravity = 9.81;

const char* const box2D = "type box; min (0 0 0); max (1 0.5 0);";
const char* const box3D = "type box; min (0 0 0); max (1 1 1);";
const char* const pool = "fluid ({ type box; min (5 5 5); max (5.2 5.2 5.2); });";


template<int dim>
particleFlowModel<dim> liquid()
{
    particleFlowModel<dim> model;
    model.spacing = spacing;
    model.rho0 = rho0;
    model.interaction.h = support/2;
    model.interaction.c0 = c0;
    model.interaction.g[dim - 1] = -gravity;
    return model;
}


dictionary parsed(const std::string& entries)
{
    IStringStream stream(entries);
    stream.name() = "particleProperties.geometry";
    return dictionary(stream);
}


//- Of the last set-up
DynamicList<Foam::string> notes;


//- Of entries after the spacing
template<int dim>
particleState<dim> particles(const std::string& entries, const fileName& caseDirectory = ".")
{
    return readParticles<dim>(parsed("spacing 0.1; " + entries), liquid<dim>(), caseDirectory, notes);
}


template<int dim>
long count(const particleState<dim>& state, int wall)
{
    return std::count(state.wall.begin(), state.wall.end(), wall);
}


//- Positions of a wall's particles in units of a thousandth of the spacing
template<int dim>
std::set<std::array<long, dim>> places(const particleState<dim>& state, int wall)
{
    std::set<std::array<long, dim>> all;
    for (std::size_t i = 0; i < state.size(); ++i)
    {
        if (state.wall[i] == wall)
        {
            std::array<long, dim> place;
            for (int d = 0; d < dim; ++d)
            {
                place[d] = std::lround(state.x[i][d]/spacing*1000);
            }
            all.insert(place);
        }
    }
    return all;
}


//- Least distance between particles, one of which is no fluid, or of the fluid alone
template<int dim>
double leastDistance(const particleState<dim>& state, bool fluidAlone)
{
    double least2 = 1e300;
    for (std::size_t i = 0; i < state.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            const bool fluid = state.wall[i] < 0 && state.wall[j] < 0;
            if (fluid != fluidAlone)
            {
                continue;
            }
            double r2 = 0;
            for (int d = 0; d < dim; ++d)
            {
                r2 += std::pow(state.x[i][d] - state.x[j][d], 2);
            }
            least2 = std::min(least2, r2);
        }
    }
    return std::sqrt(least2);
}


//- The walls' mass over the liquid's density, and over a cell of the spacing
template<int dim>
double volumeInCells(const particleState<dim>& state, int wall)
{
    double volume = 0;
    for (std::size_t i = 0; i < state.size(); ++i)
    {
        volume += state.wall[i] == wall ? state.mass[i]/rho0 : 0;
    }
    return volume/std::pow(spacing, dim);
}


class surfaceFile
:
    public surfaceInCase
{
protected:

    particleState<3> body(const std::string& fluid = pool) const
    {
        return particles<3>
        (
            fluid + "walls ({ name body; type surface; file \"constant/body.stl\"; });",
            directory
        );
    }
};


//- Pressure at a depth [m]: dp/dz = rho g with Murnaghan's rho(p), integrated by Runge's method
double atRest(double depth)
{
    constexpr int n = 2000;
    const double B = rho0*c0*c0/7;
    const auto slope = [&](double p){ return rho0*std::pow(1 + p/B, 1.0/7)*gravity; };
    double p = 0;
    for (int k = 0; k < n; ++k)
    {
        p += slope(p + 0.5*depth/n*slope(p))*depth/n;
    }
    return p;
}

} // End anonymous namespace


TEST(particleSetUp, tankInTwoDimensions)
{
    const particleState<2> state = particles<2>
    (
        std::string("fluid ({") + box2D + "velocity (1 2 0); });"
        "walls ({ name tank; type box; min (0 0 0); max (1 1 0); open (top); });"
    );

    ASSERT_EQ(count(state, -1), 50);
    EXPECT_EQ(count(state, 0), 16*13 - 100);
    EXPECT_EQ(state.size(), 50u + 108u);
    EXPECT_EQ(state.v.size(), state.size());
    EXPECT_EQ(state.density.size(), state.size());
    EXPECT_EQ(state.pressure.size(), state.size());
    EXPECT_EQ(state.wall.size(), state.size());
    EXPECT_EQ(state.time, 0);
    ASSERT_EQ(state.mass.size(), state.size());
    EXPECT_NEAR(leastDistance(state, true), spacing, 1e-12);
    EXPECT_NEAR(leastDistance(state, false), spacing, 1e-12);

    double lowest = 1e300, highest = -1e300;
    for (std::size_t i = 0; i < state.size(); ++i)
    {
        EXPECT_EQ(state.wall[i], i < 50 ? -1 : 0);
        if (i < 50)
        {
            const double p = atRest(0.5 - state.x[i][1]);
            EXPECT_NEAR(state.pressure[i], p, 1e-5);
            EXPECT_NEAR(state.density[i], rho0*(std::pow(1 + 7*p/(rho0*c0*c0), 1.0/7) - 1), 1e-9);
            EXPECT_NEAR(state.mass[i], (rho0 + state.density[i])*spacing*spacing, 1e-9);
            EXPECT_EQ(state.v[i], (std::array<double, 2>{{1, 2}}));
        }
        else
        {
            lowest = std::min(lowest, state.x[i][1]);
            highest = std::max(highest, state.x[i][1]);
            EXPECT_NEAR(state.mass[i], rho0*spacing*spacing, 1e-9);
            EXPECT_EQ(state.v[i], (std::array<double, 2>{{0, 0}}));
        }
    }
    EXPECT_NEAR(lowest, -0.25, 1e-12);
    EXPECT_NEAR(highest, 0.95, 1e-12);
}


TEST(particleSetUp, pressureAtRestIsByChoice)
{
    const auto bottomPressure = [](const std::string& entries)
    {
        return particles<2>(std::string("fluid ({") + box2D + entries + "});").pressure[0];
    };
    EXPECT_NEAR(bottomPressure("surface 2;"), atRest(1.95), 1e-5);
    EXPECT_NEAR(bottomPressure("hydrostatic yes;"), atRest(0.45), 1e-5);
    EXPECT_EQ(bottomPressure("hydrostatic no;"), 0);

    particleFlowModel<2> sideways(liquid<2>());
    sideways.interaction.g = {{gravity, 0, 0}};
    const particleState<2> state = readParticles<2>
    (
        parsed(std::string("spacing 0.1; fluid ({") + box2D + "});"), sideways, ".", notes
    );
    for (std::size_t i = 0; i < state.size(); ++i)
    {
        EXPECT_NEAR(state.pressure[i], atRest(state.x[i][0]), 1e-5);
    }

    particleFlowModel<2> weightless(liquid<2>());
    weightless.interaction.g = {{0, 0, 0}};
    EXPECT_EQ(readParticles<2>(parsed(std::string("spacing 0.1; fluid ({") + box2D + "});"), weightless, ".", notes).pressure[0], 0);
}


TEST(particleSetUp, columnInTheFluid)
{
    const particleState<3> state = particles<3>
    (
        std::string("fluid ({") + box3D + "});"
        "walls ("
        "    { name tank; type box; min (0 0 0); max (1 1 1.5); open (top front); }"
        "    { name column; type box; solid yes; min (0.4 0.3 -0.1); max (0.6 0.5 1.5); }"
        ");"
    );
    EXPECT_EQ(count(state, -1), 1000 - 40);
    EXPECT_EQ(count(state, 0), 16*13*18 - 1500);

    // Without its lowest layer, which is in the floor
    EXPECT_EQ(count(state, 1), 2*2*15);
    EXPECT_NEAR(leastDistance(state, false), spacing, 1e-12);
}


TEST(particleSetUp, noParticlesDeepInAnObstacle)
{
    const particleState<3> state = particles<3>
    (
        std::string(pool) + "walls ({ name block; solid yes;" + box3D + "});"
    );
    EXPECT_EQ(count(state, 0), 1000 - 64);
}


TEST(particleSetUp, wallOfOneParticle)
{
    const particleState<2> state = particles<2>
    (
        std::string("fluid ({") + box2D + "});"
        "walls ({ name post; type box; solid yes; min (0.3 0.2 0); max (0.4 0.3 0); });"
    );
    EXPECT_EQ(count(state, -1), 49);
    EXPECT_EQ(places(state, 0), (std::set<std::array<long, 2>>{{{3500, 2500}}}));
}


TEST(particleSetUp, boxesThatAreNoMultiples)
{
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const particleState<2> state = particles<2>
    (
        "fluid ({ type box; min (0 0 0); max (0.93 0.5 0); });"
        "walls ({ name tank; type box; min (0 0 0); max (1.04 1 0); });"
    );
    const std::string warnings =
        testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout();

    ASSERT_EQ(count(state, -1), 45);
    EXPECT_NE(warnings.find("Box of fluid: the size"), std::string::npos) << warnings;
    double volume = 0;
    for (std::size_t i = 0; i < 45; ++i)
    {
        volume += state.mass[i]/(rho0 + state.density[i]);
        EXPECT_NEAR(std::remainder(state.x[i][0] - 0.5*0.93/9, 0.93/9), 0, 1e-12);
    }
    EXPECT_NEAR(volume, 0.465, 1e-12);
    EXPECT_NE(warnings.find("Wall tank: the size"), std::string::npos) << warnings;

    // The faces of the tank are where they were asked for
    for (std::size_t i = 45; i < state.size(); ++i)
    {
        const auto& x = state.x[i];
        if (x[1] > 0 && x[1] < 1)
        {
            const double behind = x[0] < 0 ? -x[0] : x[0] - 1.04;
            EXPECT_NEAR(std::remainder(behind - 0.05, spacing), 0, 1e-12);
            EXPECT_GT(behind, 0);
        }
        if (x[0] > 0 && x[0] < 1.04)
        {
            EXPECT_NEAR(std::remainder(x[0] - 0.052, 0.104), 0, 1e-12);
            EXPECT_NEAR(state.mass[i], rho0*0.104*0.1, 1e-9);
        }
    }
}


TEST(particleSetUp, wallsAreAsDeepAsTheKernelReaches)
{
    // Of a particle on the face of the wall: the layers are 0.05, 0.15, 0.25 and 0.35 m from it
    const std::vector<std::pair<double, int>> layers{{0.24, 2}, {0.25, 2}, {0.26, 3}, {0.36, 4}};
    for (const auto& expected : layers)
    {
        particleFlowModel<2> model(liquid<2>());
        model.interaction.h = expected.first/2;
        const particleState<2> state = readParticles<2>
        (
            parsed
            (
                std::string("spacing 0.1; fluid ({") + box2D + "});"
                "walls ({ name floor; open (top left right);" + box2D + "});"
            ),
            model,
            ".",
            notes
        );
        EXPECT_EQ(count(state, 0), 10*expected.second) << expected.first;
    }
}


TEST(particleSetUp, overlappingFluidCountsOnce)
{
    const particleState<2> state = particles<2>
    (
        std::string("fluid ({") + box2D + "} { type box; min (0.53 0.02 0); max (1.53 0.52 0); });"
    );
    EXPECT_EQ(count(state, -1), 50 + 5*5);
    EXPECT_GT(leastDistance(state, false), 0.5*spacing);
}


//- Neither the rows beyond it nor the row on it, which would be its own image
TEST(particleSetUp, nothingIsBeyondAPlaneOfSymmetry)
{
    const dictionary whole(parsed("spacing 0.1; fluid ({ type box; min (0 -0.25 0); max (1 0.25 0); });"));
    particleFlowModel<2> model(liquid<2>());
    EXPECT_EQ(readParticles<2>(whole, model, ".", notes).size(), 50u);
    model.symmetry = {{1, 0, 1}};
    const particleState<2> half(readParticles<2>(whole, model, ".", notes));
    EXPECT_EQ(half.size(), 20u);
    EXPECT_TRUE(std::all_of(half.x.begin(), half.x.end(), [](const std::array<double, 2>& x){ return x[1] > 0.05; }));
    model.symmetry = {{0, 0.6, -1}};
    const particleState<2> left(readParticles<2>(whole, model, ".", notes));
    EXPECT_EQ(left.size(), 30u);
    EXPECT_TRUE(std::all_of(left.x.begin(), left.x.end(), [](const std::array<double, 2>& x){ return x[0] < 0.6; }));
}


TEST(particleSetUp, wallNames)
{
    const dictionary dict(parsed("walls ({ name b; } { name a; });"));
    EXPECT_EQ(readWallNames(dict), wordList({"b", "a"}));
    EXPECT_TRUE(readWallNames(parsed("")).empty());
}


TEST(particleSetUp, circleInTheFluid)
{
    testing::internal::CaptureStdout();
    const particleState<2> state = particles<2>
    (
        "fluid ({ type box; min (0 0 0); max (2 2 0); });"
        "walls ({ name tank; type box; min (0 0 0); max (2 2 0); } { name disc; type sphere; centre (1 1 0); radius 0.5; });"
    );
    const std::string log = testing::internal::GetCapturedStdout();

    // Those of the lattice that are outside of the circle
    long outside = 0;
    for (int i = 0; i < 400; ++i)
    {
        outside += std::hypot(-0.95 + 0.1*(i % 20), -0.95 + 0.1*(i/20)) > 0.5;
    }
    EXPECT_EQ(count(state, -1), outside);
    EXPECT_GE(leastDistance(state, true), 0.5*spacing*(1 - 1e-6));
    EXPECT_NEAR(volumeInCells(state, 1), M_PI*(25 - 4), 1e-9);
    EXPECT_NE(log.find("removed " + std::to_string(400 - outside) + " in or near walls"), std::string::npos) << log;
    EXPECT_NE(log.find("and 0 of the fluid\n    wall disc"), std::string::npos) << log;
    EXPECT_NE(log.find("and " + std::to_string(400 - outside) + " of the fluid\n        area"), std::string::npos) << log;
    EXPECT_NE(log.find("of the shape 0.785398 m2"), std::string::npos) << log;
}


TEST(particleSetUp, halfOfACircle)
{
    particleFlowModel<2> model(liquid<2>());
    model.symmetry = {{0, 1, -1}};
    const particleState<2> state = readParticles<2>
    (
        parsed
        (
            "spacing 0.1; fluid ({ type box; min (0 0 0); max (2 2 0); });"
            "walls ({ name disc; type sphere; centre (1 1 0); radius 0.5; });"
        ),
        model,
        ".",
        notes
    );
    for (const auto& x : state.x)
    {
        EXPECT_LT(x[0], 1);
    }
    EXPECT_NEAR(volumeInCells(state, 0), M_PI/2*(25 - 4), 1e-9);
    EXPECT_GT(count(state, -1), 150);
}


// The points in the middle of the cells miss the cells' own moments of inertia alone: 1/n^2 of that of a square of n cells
TEST(particleSetUp, latticeOfABoxConverges)
{
    for (const int n : {2, 4, 8})
    {
        testing::internal::CaptureStdout();
        particles<2>
        (
            "fluid ({ type box; min (2 2 0); max (3 3 0); });"
            "walls ({ name block; type box; solid yes; min (0 0 0); max (" + std::to_string(0.1*n) + " "
          + std::to_string(0.1*n) + " 0); });"
        );
        const std::string log = testing::internal::GetCapturedStdout();
        double latticeArea, area, percent, apart, inertia;
        const std::size_t at = log.find("        area");
        ASSERT_NE(at, std::string::npos) << log;
        ASSERT_EQ
        (
            std::sscanf
            (
                log.c_str() + at, " area of the lattice %lf, of the shape %lf m2 (%lf %%); centroids %lf spacings apart;"
                " inertia differs by %lf %%", &latticeArea, &area, &percent, &apart, &inertia
            ),
            5
        ) << log;
        EXPECT_NEAR(latticeArea, 0.01*n*n, 1e-6);
        EXPECT_NEAR(area, 0.01*n*n, 1e-6);
        EXPECT_NEAR(percent, 0, 1e-6);
        EXPECT_NEAR(apart, 0, 1e-6);
        EXPECT_NEAR(inertia, 100.0/(n*n), 1e-3);
    }
}


TEST_F(surfaceFile, isFilled)
{
    write(corners(0.9), octahedron);
    const particleState<3> state = body();
    for (std::size_t i = 0; i < state.size(); ++i)
    {
        const double depth =
            (0.9 - std::abs(state.x[i][0]) - std::abs(state.x[i][1]) - std::abs(state.x[i][2]))/std::sqrt(3.0);
        EXPECT_TRUE(state.wall[i] < 0 || (depth > 0.25*spacing && depth < support)) << i;
    }

    // Less what is deeper than three layers: an octahedron, too
    const double deep = 9 - 3*std::sqrt(3.0);
    EXPECT_NEAR(volumeInCells(state, 0), 4.0/3*(9*9*9 - deep*deep*deep), 0.01*4.0/3*9*9*9);
}


TEST_F(surfaceFile, inwardsIsFilledLikewise)
{
    write(corners(0.9), octahedron);
    const std::set<std::array<long, 3>> expected(places(body(), 0));
    List<triFace> inwards(octahedron);
    for (triFace& f : inwards)
    {
        f.flip();
    }
    write(corners(0.9), inwards);
    EXPECT_EQ(places(body(), 0), expected);

    // Of no direction
    inwards[3].flip();
    write(corners(0.9), inwards);
    EXPECT_EQ(places(body(), 0), expected);
}


TEST_F(surfaceFile, fluidStaysInAVessel)
{
    pointField points(12);
    List<triFace> triangles(16);
    for (label i = 0; i < 6; ++i)
    {
        points[i] = corners(0.9)[i];
        points[6 + i] = corners(0.4)[i];
    }
    forAll(octahedron, i)
    {
        const triFace& f = octahedron[i];
        triangles[i] = f;
        triangles[8 + i] = triFace(f[0] + 6, f[1] + 6, f[2] + 6);
    }
    write(points, triangles);

    const particleState<3> state = body("fluid ({ type box; min (-1 -1 -1); max (1 1 1); });");
    for (std::size_t i = 0; i < state.size(); ++i)
    {
        const double sum = std::abs(state.x[i][0]) + std::abs(state.x[i][1]) + std::abs(state.x[i][2]);
        EXPECT_EQ(state.wall[i], sum > 0.4 && sum < 0.9 ? 0 : -1);
    }
}


TEST_F(surfaceFile, keepsTheFluidOutside)
{
    write(corners(0.9), octahedron);
    const particleState<3> state = body
    (
        "fluid ({ type box; min (-0.98 -0.98 -0.98); max (1.02 1.02 1.02); });"
    );
    long outside = 0;
    for (long i = 0; i < 8000; ++i)
    {
        const double x[] = {-0.93 + 0.1*(i % 20), -0.93 + 0.1*(i/20 % 20), -0.93 + 0.1*(i/400)};
        outside += std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]) > 0.9;
    }

    // At the sharp edges some that are outside are too near to particles inside
    EXPECT_LE(count(state, -1), outside);
    EXPECT_GE(count(state, -1), outside - 50);
    EXPECT_GE(leastDistance(state, true), 0.5*spacing*(1 - 1e-6));
}


TEST_F(surfaceFile, cutInTwoDimensions)
{
    write(corners(0.9), octahedron);
    const std::string body = "walls ({ name body; type surface; file \"constant/body.stl\"; });";
    const std::string fluid = "fluid ({ type box; min (2 2 0); max (3 3 0); });";
    const particleState<2> state = particles<2>(fluid + body, directory);
    for (std::size_t i = 0; i < state.size(); ++i)
    {
        const double depth = (0.9 - std::abs(state.x[i][0]) - std::abs(state.x[i][1]))/std::sqrt(2.0);
        EXPECT_TRUE(state.wall[i] < 0 || (depth > 0.25*spacing && depth < support)) << i;
    }
    const double deep = 9 - 3*std::sqrt(2.0);
    EXPECT_NEAR(volumeInCells(state, 0), 2*(81 - deep*deep), 0.01*162);

    pointField above(corners(0.9));
    above += vector(0, 0, 0.91);
    write(above, octahedron);
    expectRefusal({"body.stl\" is between z = 0.01", "crosses z = 0", "geometry.walls"}, [&]{ particles<2>(fluid + body, directory); });
}


TEST_F(surfaceFile, thatLeaksIsRefused)
{
    List<triFace> leaking(octahedron);
    leaking.resize(7);
    write(corners(0.9), leaking);
    expectRefusal
    (
        {"body.stl\" leaks: 3 of its 12 edges", "the first, from (", "has 1", "watertight", "geometry.walls"},
        [&]{ body(); }
    );
}


TEST_F(surfaceFile, thatIsNotThereIsRefused)
{
    expectRefusal({"Entry file: there is no \"" + directory + "/constant/body.stl\""}, [&]{ body(); });
}


TEST_F(surfaceFile, tooSmallForAnyParticleIsRefused)
{
    write(corners(0.02), octahedron);
    expectRefusal({"Wall body has no particles", "a larger wall"}, [&]{ body(); });
    expectRefusal
    (
        {"Wall body has no particles"},
        [&]
        {
            particles<2>
            (
                "fluid ({ type box; min (2 2 0); max (3 3 0); }); walls ({ name body; type surface; file \"constant/body.stl\"; });", directory
            );
        }
    );
}


TEST(particleSetUp, refusals)
{
    const std::string fluid = std::string("fluid ({") + box3D + "});";
    const auto refuse3 = [](const std::string& entries, const std::vector<std::string>& parts)
    {
        expectRefusal(parts, [&]{ particles<3>(entries); });
    };
    const auto refuse2 = [](const std::string& entries, const std::vector<std::string>& parts)
    {
        expectRefusal(parts, [&]{ particles<2>(entries); });
    };

    for (const std::string bad : {"0", "-0.1", "nan"})
    {
        expectRefusal({"spacing"}, [&]{ readSpacing(parsed("spacing " + bad + ";")); });
    }
    expectRefusal({"spacing", "particleProperties.geometry"}, [&]{ readSpacing(parsed("")); });

    refuse3("", {"fluid"});
    refuse3("fluid ();", {"Entry fluid: no particle", "particleProperties.geometry"});
    refuse3
    (
        fluid + "walls ({ name all; type box; solid yes; min (-1 -1 -1); max (2 2 2); });",
        {"no particle of fluid, all 1000 are in walls"}
    );
    refuse3("fluid ({ type sphere; });", {"Entry type is sphere", "box", "geometry.fluid"});
    refuse3("fluid ({ type box; min (0 0 0); max (1 0 1); });", {"(0 0 0) and (1 0 1)", "min below max"});
    refuse3("fluid ({ type box; min (0 0 0); max (1 0.04 1); });", {"at least half the spacing, 0.1 m"});
    refuse3("fluid ({ type box; min (0 0 0); max (nan 1 1); });", {""});
    refuse3("fluid ({ type box; min (0 0 0); max (200 200 200); });", {"Entry spacing is 0.1", "8e+09", "2147483647"});
    refuse3
    (
        fluid + "walls ({ name tank; type box; min (0 0 0); max (3000 3000 1); });",
        {"Entry spacing is 0.1", "particles"}
    );
    refuse3(std::string("fluid ({ velocty (0 0 1);") + box3D + "});", {"Unknown entry velocty"});
    refuse3(std::string("fluid ({ surface 0.9;") + box3D + "});", {"Entry surface is 0.9", "at 1 m"});
    refuse3(std::string("fluid ({ surface 2; hydrostatic no;") + box3D + "});", {"hydrostatic is off"});
    refuse3(fluid + "wall ();", {"Unknown entry wall"});

    refuse3(fluid + "walls ({" + box3D + "});", {"name", "geometry.walls"});
    refuse3(fluid + "walls ({ name a;" + box3D + "} { name a;" + box3D + "});", {"two walls have the name a"});
    refuse3(fluid + "walls ({ name a; type cone; });", {"Entry type is cone", "sphere", "surface"});
    refuse3
    (
        fluid + "walls ({ name a; type sphere; centre (0 0 0); radius 0.09; });",
        {"Entry radius is 0.09", "at least the spacing, 0.1 m", "geometry.walls"}
    );
    refuse3(fluid + "walls ({ name a; type sphere; centre (0 0 0); radius 1; solid yes; });", {"Unknown entry solid"});
    refuse2
    (
        std::string("fluid ({") + box2D + "}); walls ({ name a; type sphere; centre (0 0 1); radius 1; });",
        {"Entry centre is (0 0 1)", "third component of 0"}
    );
    refuse3(fluid + "walls ({ name a; open (up);" + box3D + "});", {"face up", "front", "top"});
    refuse3(fluid + "walls ({ name a; solid yes; open (top);" + box3D + "});", {"Unknown entry open"});
    refuse3
    (
        fluid + "walls ({ name a;" + box3D + "} { name b;" + box3D + "});",
        {"Wall b has no particles", "removed"}
    );

    refuse2(fluid, {"Entry max is (1 1 1)", "third component of 0"});
    refuse2
    (
        std::string("fluid ({ velocity (0 0 1);") + box2D + "});",
        {"Entry velocity is (0 0 1)", "third component of 0"}
    );
    refuse2(std::string("fluid ({") + box2D + "}); walls ({ name a; type surface; });", {"file", "geometry.walls"});
    refuse2
    (
        std::string("fluid ({") + box2D + "}); walls ({ name a; open (front);" + box2D + "});",
        {"face front", "left"}
    );
}


// A plate that the kernel, whose reach is 0.3, reaches through is refused, unless another wall covers one of its sides
TEST(particleSetUp, thinWalls)
{
    const std::string fluid("fluid ({ type box; min (5 5 0); max (6 6 0); }); walls (");
    const auto plate = [&](const std::string& thickness, const std::string& more = "")
    {
        notes.clear();
        return particles<2>
        (
            fluid + "{ name plate; type box; solid yes; min (0 0 0); max (" + thickness + " 2 0); }" + more + ");"
        );
    };
    for (const char* thickness : {"0.1", "0.2"})
    {
        expectRefusal({"Wall plate is, on ", "the liquid on its two sides meets through it", "0.3 m thick"}, [&]{ plate(thickness); });
    }
    EXPECT_EQ(count(plate("0.3"), 0), 60);
    ASSERT_EQ(notes.size(), 1);
    EXPECT_NE(notes[0].find("more than half the radius of plate, 0.15 m"), std::string::npos) << notes[0];
    EXPECT_EQ(count(plate("0.4"), 0), 80);
    EXPECT_TRUE(notes.empty());
    plate("0.1", "{ name behind; type box; solid yes; min (-0.5 0 0); max (0 2 0); }");
}


// Half a plate, with its mirror image, is thick enough
TEST(particleSetUp, thinWallsAcrossSymmetry)
{
    particleFlowModel<2> model(liquid<2>());
    model.symmetry = {{0, 0, 1}};
    const dictionary geometry
    (
        parsed
        (
            "spacing 0.1; fluid ({ type box; min (5 5 0); max (6 6 0); });"
            "walls ({ name plate; type box; solid yes; min (0 0 0); max (0.2 2 0); });"
        )
    );
    EXPECT_EQ(count(readParticles<2>(geometry, model, ".", notes), 0), 40);
}
