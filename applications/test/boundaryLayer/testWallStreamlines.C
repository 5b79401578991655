// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths of streamlines on walls whose streamlines are known.

#include <gtest/gtest.h>

#include "wallStreamlines.H"

#include <cmath>
#include <functional>

using namespace Foam;

namespace
{

//- A grid of n x m quadrilaterals, on a surface of two coordinates from 0 to 1
struct Surface
{
    faceList faces;
    pointField centres;

    Surface(const label n, const label m, const std::function<point(double, double)>& at, const bool periodic = false)
    {
        const label columns = periodic ? m : m + 1;
        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; j < m; ++j)
            {
                const label k = (j + 1) % columns;
                face f(4);
                f[0] = i*columns + j;
                f[1] = (i + 1)*columns + j;
                f[2] = (i + 1)*columns + k;
                f[3] = i*columns + k;
                faces.append(f);
                centres.append(at((i + 0.5)/n, (j + 0.5)/m));
            }
        }
    }

    scalarField lengths(const vectorField& velocities) const
    {
        return wallStreamlines(faces).lengths(centres, velocities);
    }
};


point plane(const double u, const double v)
{
    return point(u, 0.3*v, 0);
}

} // End anonymous namespace


TEST(wallStreamlines, plateCountsFromItsLeadingEdge)
{
    const Surface plate(40, 6, plane);
    const scalarField s(plate.lengths(vectorField(plate.centres.size(), vector(7, 0, 0))));
    forAll(s, i)
    {
        EXPECT_NEAR(s[i], plate.centres[i].x(), 1e-12);
    }
}


TEST(wallStreamlines, directionOfTheGridDoesNotMatter)
{
    const Surface plate(40, 6, [](double u, double v) { return plane(1 - u, v); });
    const scalarField s(plate.lengths(vectorField(plate.centres.size(), vector(7, 0, 0))));
    forAll(s, i)
    {
        EXPECT_NEAR(s[i], plate.centres[i].x(), 1e-12);
    }
}


TEST(wallStreamlines, skewedFacesDoNotMatter)
{
    // Lines of the grid at 45 degrees to a flow that is even across it
    const label n = 60, m = 20;
    const Surface plate(n, m, [](double u, double v) { return point(u, 0.3*v + 0.3*u, 0); }, true);
    const scalarField s(plate.lengths(vectorField(plate.centres.size(), vector(2, 0, 0))));
    for (label i = 1; i < n; ++i)
    {
        // Away from where the last column meets the first
        const label facei = i*m + m/2;
        if (i < m)
        {
            EXPECT_NEAR(s[facei] - s[facei - m], plate.centres[facei].x() - plate.centres[facei - m].x(), 1e-9);
        }
    }
}


TEST(wallStreamlines, sphereCountsFromItsStagnationPoint)
{
    // Without the pole's triangles the foremost ring begins
    const label n = 90;
    auto at = [](double u, double v)
    {
        const double a = M_PI*(0.005 + 0.98*u), b = 2*M_PI*v;
        return point(-std::cos(a), std::sin(a)*std::cos(b), std::sin(a)*std::sin(b));
    };
    const Surface sphere(n, 24, at, true);
    vectorField U(sphere.centres.size());
    forAll(U, i)
    {
        const vector r(sphere.centres[i]/mag(sphere.centres[i]));
        U[i] = 1.5*(vector(1, 0, 0) - r*r.x());
    }
    const scalarField s(sphere.lengths(U));
    forAll(s, i)
    {
        const double angle = std::acos(-sphere.centres[i].x()/mag(sphere.centres[i]));
        EXPECT_NEAR(s[i], angle, 0.03 + 0.01*angle);
    }
}


TEST(wallStreamlines, attachmentLineBegins)
{
    // The flow parts at x = 0.5
    const Surface plate(40, 3, plane);
    vectorField U(plate.centres.size());
    forAll(U, i)
    {
        U[i] = vector(plate.centres[i].x() > 0.5 ? 1 : -1, 0, 0);
    }
    const scalarField s(plate.lengths(U));
    forAll(s, i)
    {
        EXPECT_NEAR(s[i], mag(plate.centres[i].x() - 0.5), 1e-9);
    }
}


TEST(wallStreamlines, oppositeFlowsAreFollowedToTheirEnds)
{
    // Two plates of more faces than there are passes, which share no edge
    const label n = 400;
    const Surface plate(n, 3, plane);
    faceList faces(plate.faces);
    pointField centres(plate.centres);
    vectorField U(centres.size(), vector(25, 0, 0));
    for (const face& f : plate.faces)
    {
        face other(f);
        for (label& pointi : other)
        {
            pointi += 10*n;
        }
        faces.append(other);
    }
    for (const point& C : plate.centres)
    {
        centres.append(C + vector(0, 0, 1));
        U.append(vector(-26, 0, 0));
    }
    const scalarField s(wallStreamlines(faces).lengths(centres, U));
    forAll(s, i)
    {
        EXPECT_NEAR(s[i], U[i].x() > 0 ? centres[i].x() : 1 - centres[i].x(), 1e-9);
    }
}


TEST(wallStreamlines, closedStreamlinesAreLimited)
{
    // Round and round on a ring
    const Surface ring(3, 30, [](double u, double v)
    {
        return point((1 + 0.1*u)*std::cos(2*M_PI*v), (1 + 0.1*u)*std::sin(2*M_PI*v), 0);
    }, true);
    vectorField U(ring.centres.size());
    forAll(U, i)
    {
        U[i] = vector(0, 0, 1) ^ ring.centres[i];
    }
    for (const scalar s : ring.lengths(U))
    {
        EXPECT_GT(s, 0);
        EXPECT_LT(s, 10);
    }
}


TEST(wallStreamlines, fluidAtRestHasNone)
{
    const Surface plate(4, 3, plane);
    for (const scalar s : plate.lengths(vectorField(plate.centres.size(), Zero)))
    {
        EXPECT_EQ(s, 0);
    }
}
