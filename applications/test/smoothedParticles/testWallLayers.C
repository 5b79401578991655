// SPDX-License-Identifier: GPL-3.0-or-later
// Layers of particles behind curved walls: where they are, the solid that they represent, and what a kernel sees of them.

#include "../surfaceInCase.H"

#include "closedSurface.H"
#include "smoothingKernels.H"
#include "sphereShape.H"
#include "wallLayers.H"

#include "IStringStream.H"

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace Foam;
using Foam::smoothedParticles::sphereLayers;
using Foam::smoothedParticles::surfaceLayers;
using Foam::smoothedParticles::wallParticles;
using Foam::smoothedParticles::WendlandC2;

namespace
{

constexpr label nLayers = 3;

//- Of a kernel with the support of three spacings
double kernel(double r, double spacing, int dim)
{
    const double h = 1.5*spacing;
    return
        WendlandC2::normalisation(dim)/std::pow(h, dim)*WendlandC2::w<double>(std::min(r/h, 2.0));
}


double kernelSum(const wallParticles& wall, const point& at, double spacing, int dim)
{
    double sum = 0;
    forAll(wall.x, i)
    {
        sum += wall.volume[i]*kernel(mag(at - wall.x[i]), spacing, dim);
    }
    return sum;
}


//- Kernel sum of layers of a square lattice with a flat face, at a distance from the face
double flatLatticeSum(double distance, double spacing, int dim)
{
    double sum = 0;
    for (int i = -4; i <= 4; ++i)
    {
        for (int j = dim == 2 ? 0 : -4; j <= (dim == 2 ? 0 : 4); ++j)
        {
            for (int k = 0; k < nLayers; ++k)
            {
                sum += std::pow(spacing, dim)*kernel(mag(vector(i*spacing, j*spacing, distance + (k + 0.5)*spacing)), spacing, dim);
            }
        }
    }
    return sum;
}


//- Kernel sum of the layers of a ball of radius 1, as if each were spread over its shell evenly, at a distance from the face
double shellSum(double distance, double spacing)
{
    // Over a shell of radius a, at D from its middle: the integral of W dA is 2 pi a/D times that of W s ds
    double sum = 0;
    const double D = 1 + distance;
    for (int k = 0; k < nLayers; ++k)
    {
        const double a = 1 - (k + 0.5)*spacing;
        const double volume = 4*M_PI/3*(std::pow(1 - k*spacing, 3) - std::pow(1 - (k + 1)*spacing, 3));
        constexpr int n = 2000;
        const double from = D - a, step = std::max(3*spacing - from, 0.0)/n;
        for (int i = 0; i < n; ++i)
        {
            const double s = from + (i + 0.5)*step;
            sum += volume/(4*M_PI*a*a)*2*M_PI*a/D*kernel(s, spacing, 3)*s*step;
        }
    }
    return sum;
}


//- Triangles of a ball of radius 1: an octahedron's, halved again and again
void ball(int refinements, pointField& points, List<triFace>& triangles)
{
    points = corners(1);
    triangles = octahedron;
    for (int k = 0; k < refinements; ++k)
    {
        std::map<std::pair<label, label>, label> middles;
        List<triFace> finer;
        const auto middle = [&](label a, label b)
        {
            const auto key = std::minmax(a, b);
            if (!middles.count(key))
            {
                const point m(points[a] + points[b]);
                middles[key] = points.size();
                points.append(m/mag(m));
            }
            return middles[key];
        };
        for (const triFace& f : triangles)
        {
            const label a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
            finer.append(triFace(f[0], a, c));
            finer.append(triFace(a, f[1], b));
            finer.append(triFace(c, b, f[2]));
            finer.append(triFace(a, b, c));
        }
        triangles = finer;
    }
}


//- Least and largest distance of a particle to the next
std::pair<double, double> distances(const pointField& x)
{
    double least = GREAT, largest = 0;
    forAll(x, i)
    {
        double next = GREAT;
        forAll(x, j)
        {
            next = j == i ? next : std::min(next, mag(x[j] - x[i]));
        }
        least = std::min(least, next);
        largest = std::max(largest, next);
    }
    return {least, largest};
}


class wallLayers
:
    public surfaceInCase
{
protected:

    autoPtr<closedSurface> surface(int dim) const
    {
        IStringStream stream("file \"constant/body.stl\";");
        return autoPtr<closedSurface>(new closedSurface(dictionary(stream), {dim, directory}));
    }
};

} // End anonymous namespace


TEST_F(wallLayers, ofASphereAreSymmetric)
{
    const point centre(0.3, -0.2, 0.1);
    for (const int dim : {2, 3})
    {
        const point c(centre.x(), centre.y(), dim == 2 ? 0 : centre.z());
        solidMeasures represented;
        const wallParticles wall = sphereLayers(c, 1, dim, 0.1, nLayers, represented);
        std::set<std::array<long, 3>> all;
        double volume = 0;
        forAll(wall.x, i)
        {
            const vector r(wall.x[i] - c);
            const double layer = (1 - mag(r))/0.1 - 0.5;
            EXPECT_NEAR(layer, std::round(layer), 1e-9);
            EXPECT_LT(layer, nLayers);
            std::array<long, 3> place;
            for (int d = 0; d < 3; ++d)
            {
                place[d] = std::lround(1e6*r[d]);
                EXPECT_TRUE(place[d] != 0 || d >= dim);
            }
            all.insert(place);
            volume += wall.volume[i];
        }
        EXPECT_EQ(label(all.size()), wall.x.size());
        for (std::array<long, 3> place : all)
        {
            for (int d = 0; d < dim; ++d)
            {
                place[d] *= -1;
                EXPECT_TRUE(all.count(place));
            }
        }
        EXPECT_NEAR(volume, (dim == 2 ? M_PI : 4*M_PI/3)*(1 - std::pow(0.7, dim)), 1e-12);
        const auto next = distances(wall.x);
        EXPECT_GT(next.first, dim == 2 ? 0.09 : 0.065);
        EXPECT_LT(next.second, 0.11);
    }
}


// The particles are at the middle depth of their layers: of the second order
TEST_F(wallLayers, ofASphereConverge)
{
    for (const int dim : {2, 3})
    {
        const auto error = [&](double spacing)
        {
            solidMeasures represented;
            sphereLayers(point(0.3, 0.2, 0), 1, dim, spacing, nLayers, represented);
            const solidMeasures exact = ballMeasures(point(0.3, 0.2, 0), 1, dim);
            EXPECT_NEAR(represented.volume, dim == 2 ? M_PI : 4*M_PI/3, 1e-12);
            EXPECT_LT(mag(represented.centroid() - point(0.3, 0.2, 0)), 1e-12);
            EXPECT_NEAR(exact.inertia().zz(), dim == 2 ? M_PI/2 : 8*M_PI/15, 1e-12);
            return mag(represented.inertia() - exact.inertia())/mag(exact.inertia());
        };
        EXPECT_LT(error(0.1), 0.01);
        EXPECT_GT(error(0.1)/error(0.025), 12);
    }
}


TEST_F(wallLayers, aFlatterSphereHasTheKernelSumOfAFlatLattice)
{
    for (const double distance : {0.25, 0.5, 1.0})
    {
        const auto difference = [&](double spacing)
        {
            solidMeasures represented;
            const wallParticles wall = sphereLayers(point::zero, 1, 3, spacing, nLayers, represented);
            const double flat = flatLatticeSum(distance*spacing, spacing, 3);
            double worst = 0;
            std::mt19937 engine(1);
            std::normal_distribution<double> random;
            for (int k = 0; k < 20; ++k)
            {
                const vector r(random(engine), random(engine), random(engine));
                const point at((1 + distance*spacing)/mag(r)*r);
                worst = std::max(worst, std::abs(kernelSum(wall, at, spacing, 3)/flat - 1));
            }
            return worst;
        };

        // What is left is the curvature, of the first order
        EXPECT_LT(difference(0.02), distance > 0.5 ? 0.06 : 0.035) << distance;
        EXPECT_LT(difference(0.02), 0.6*difference(0.04)) << distance;
    }
}


TEST_F(wallLayers, ofASurfaceFollowIt)
{
    pointField points;
    List<triFace> triangles;
    ball(5, points, triangles);
    write(points, triangles);
    const double spacing = 0.08;
    const autoPtr<closedSurface> body(surface(3));
    solidMeasures represented;
    const wallParticles wall = surfaceLayers(*body, spacing, nLayers, {}, represented);

    // Half a spacing, one and a half, ... behind the face
    std::map<long, int> inLayer;
    forAll(wall.x, i)
    {
        const double layer = body->findNearest(wall.x[i], GREAT).depth/spacing - 0.5;
        EXPECT_NEAR(layer, std::round(layer), 1e-3);
        ++inLayer[std::lround(layer)];
    }
    ASSERT_EQ(inLayer.size(), 3u);
    for (int k = 0; k < 3; ++k)
    {
        EXPECT_NEAR(inLayer[k]/(4*M_PI*sqr((1 - (k + 0.5)*spacing)/spacing)), 1, 0.1) << k;
    }
    const auto next = distances(wall.x);
    EXPECT_GT(next.first, 0.65*spacing);
    EXPECT_LT(next.second, 1.3*spacing);

    EXPECT_NEAR(represented.volume/body->measures().volume, 1, 2e-4);
    EXPECT_LT(mag(represented.centroid()), 1e-3*spacing);
    EXPECT_LT(mag(represented.inertia() - body->measures().inertia()), 3e-3*mag(body->measures().inertia()));

    // The noise of the kernel sum outside; a lattice inside the sphere would have 18 %
    std::mt19937 engine(1);
    std::normal_distribution<double> random;
    double mean = 0, square = 0;
    constexpr int n = 100;
    const double exact = shellSum(0.5*spacing, spacing);
    for (int k = 0; k < n; ++k)
    {
        const vector r(random(engine), random(engine), random(engine));
        const double ratio = kernelSum(wall, (1 + 0.5*spacing)/mag(r)*r, spacing, 3)/exact;
        mean += ratio/n;
        square += ratio*ratio/n;
    }
    EXPECT_NEAR(mean, 1, 0.02);
    EXPECT_LT(std::sqrt(square - mean*mean), 0.02);
}


// An octahedron's edges are sharp and its faces oblique to any lattice
TEST_F(wallLayers, ofASurfaceConverge)
{
    write(corners(1), octahedron);
    const autoPtr<closedSurface> body(surface(3));
    EXPECT_NEAR(body->measures().volume, 4.0/3, 1e-6);
    EXPECT_NEAR(body->area(), 4*std::sqrt(3.0), 1e-6);
    EXPECT_LT(mag(body->measures().centroid()), 1e-6);
    EXPECT_NEAR(body->measures().inertia().xx(), 4.0/3/5, 1e-6);

    const auto represented = [&](double spacing)
    {
        solidMeasures result;
        surfaceLayers(*body, spacing, nLayers, {}, result);
        return result;
    };
    const solidMeasures coarse(represented(0.12)), fine(represented(0.06));
    const symmTensor exact(body->measures().inertia());
    EXPECT_NEAR(coarse.volume/body->measures().volume, 1, 2e-3);
    EXPECT_NEAR(fine.volume/body->measures().volume, 1, 5e-4);
    EXPECT_LT(mag(fine.centroid()), 1e-3);
    EXPECT_LT(mag(coarse.inertia() - exact), 0.02*mag(exact));
    EXPECT_LT(mag(fine.inertia() - exact), mag(coarse.inertia() - exact)/3);

    // A flat face is like a lattice's
    solidMeasures unused;
    const wallParticles wall = surfaceLayers(*body, 0.06, nLayers, {}, unused);
    const vector normal(vector(1, 1, 1)/std::sqrt(3.0));
    const double flat = flatLatticeSum(0.03, 0.06, 3);
    for (int k = 0; k < 20; ++k)
    {
        const vector along(0.05*std::cos(k), -0.05*std::cos(k), 0.04*std::sin(3*k));
        const point at(vector(1, 1, 1)/3.0 + along - (along & normal)*normal + 0.03*normal);
        EXPECT_NEAR(kernelSum(wall, at, 0.06, 3)/flat, 1, 0.04);
    }
}


TEST_F(wallLayers, ofACut)
{
    // Four of the corners and of the edges are in the plane
    write(corners(1), octahedron);
    const autoPtr<closedSurface> square(surface(2));
    EXPECT_NEAR(square->measures().volume, 2, 1e-6);
    EXPECT_NEAR(square->measures().inertia().zz(), 2.0/3, 1e-6);
    EXPECT_NEAR(square->area(), 4*std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(square->bounds().max().x(), 1, 1e-6);
    EXPECT_EQ(square->bounds().max().z(), 0);
    EXPECT_NEAR(square->findNearest(point(0.25, 0.25, 0), GREAT).depth, std::sqrt(0.125), 1e-6);
    EXPECT_NEAR(square->findNearest(point(0.75, 0.75, 0), GREAT).depth, -std::sqrt(0.125), 1e-6);
    EXPECT_NEAR(square->findNearest(point(1.5, 0, 0), GREAT).depth, -0.5, 1e-6);
    EXPECT_FALSE(square->findNearest(point(1.5, 0, 0), 0.4).found);

    const auto represented = [&](double spacing)
    {
        solidMeasures result;
        surfaceLayers(*square, spacing, nLayers, {}, result);
        return result;
    };
    EXPECT_NEAR(represented(0.05).volume, 2, 1e-3);
    const auto error = [&](double spacing)
    {
        return mag(represented(spacing).inertia() - square->measures().inertia());
    };
    EXPECT_LT(error(0.05), 0.005*mag(square->measures().inertia()));
    EXPECT_LT(error(0.025), error(0.1)/8);

    // Obliquely
    pointField points(corners(1));
    for (point& p : points)
    {
        p = point(0.8*p.x() - 0.6*p.z(), p.y(), 0.6*p.x() + 0.8*p.z() + 0.1);
    }
    write(points, octahedron);
    const autoPtr<closedSurface> oblique(surface(2));
    EXPECT_TRUE(oblique->contains(point(0.0, 0.1, 0)));
    EXPECT_FALSE(oblique->contains(point(0.9, 0.9, 0)));
    EXPECT_GT(oblique->measures().volume, 1);
}


// A prism across the plane is the circle that it is drawn out from
TEST_F(wallLayers, ofAPrismAreThoseOfACircle)
{
    constexpr label n = 400;
    const point centre(0.3, -0.2, 0);
    pointField points(2*n + 2);
    List<triFace> triangles;
    points[2*n] = centre - vector(0, 0, 0.7);
    points[2*n + 1] = centre + vector(0, 0, 0.4);
    for (label i = 0; i < n; ++i)
    {
        const vector r(std::cos(2*M_PI*i/n), std::sin(2*M_PI*i/n), 0);
        const label next = (i + 1) % n;
        points[i] = points[2*n] + r;
        points[n + i] = points[2*n + 1] + r;
        triangles.append(triFace(i, next, n + next));
        triangles.append(triFace(i, n + next, n + i));
        triangles.append(triFace(next, i, 2*n));
        triangles.append(triFace(n + i, n + next, 2*n + 1));
    }
    write(points, triangles);
    const autoPtr<closedSurface> prism(surface(2));

    const solidMeasures circle(ballMeasures(centre, 1, 2));
    EXPECT_NEAR(prism->measures().volume, circle.volume, 1e-3);
    EXPECT_LT(mag(prism->measures().centroid() - centre), 1e-6);
    EXPECT_NEAR(prism->measures().inertia().zz(), circle.inertia().zz(), 1e-3);
    EXPECT_NEAR(prism->area(), 2*M_PI, 1e-3);
    EXPECT_LT(mag(prism->bounds().max() - centre - vector(1, 1, 0)), 1e-5);
    EXPECT_LT(mag(prism->bounds().min() - centre + vector(1, 1, 0)), 1e-5);
    for (const double r : {0.0, 0.5, 0.999, 1.001, 1.5})
    {
        const point p(centre + r*vector(0.6, 0.8, 0));
        EXPECT_EQ(prism->contains(p), r < 1) << r;
        EXPECT_NEAR(prism->findNearest(p, GREAT).depth, 1 - r, 1e-4);
    }

    const double spacing = 0.05;
    solidMeasures represented, expected;
    const wallParticles ofPrism(surfaceLayers(*prism, spacing, nLayers, {}, represented));
    const wallParticles ofCircle(sphereLayers(centre, 1, 2, spacing, nLayers, expected));
    EXPECT_NEAR(represented.volume, expected.volume, 2e-3);
    EXPECT_LT(mag(represented.centroid() - centre), 1e-3*spacing);
    EXPECT_NEAR(represented.inertia().zz(), expected.inertia().zz(), 0.005*expected.inertia().zz());
    EXPECT_NEAR(sum(ofPrism.volume), sum(ofCircle.volume), 2e-3);
    EXPECT_NEAR(double(ofPrism.x.size())/ofCircle.x.size(), 1, 0.05);
    forAll(ofPrism.x, i)
    {
        const double layer = (1 - mag(ofPrism.x[i] - centre))/spacing - 0.5;
        EXPECT_NEAR(layer, std::round(layer), 0.01);
    }

    // Half a spacing off the face the kernel sees as much of the one as of the other, but for the noise of its particles
    double mean = 0, square = 0;
    constexpr label nPoints = 100;
    for (label k = 0; k < nPoints; ++k)
    {
        const point at(centre + (1 + 0.5*spacing)*vector(std::cos(k), std::sin(k), 0));
        const double ratio = kernelSum(ofPrism, at, spacing, 2)/kernelSum(ofCircle, at, spacing, 2);
        mean += ratio/nPoints;
        square += sqr(ratio)/nPoints;
    }
    EXPECT_NEAR(mean, 1, 0.01);
    EXPECT_LT(std::sqrt(square - sqr(mean)), 0.03);
}


// A wedge, 1 long and 0.5 high at its end, to a sharp edge at x = 0
TEST_F(wallLayers, thinParts)
{
    const pointField points
    ({
        point(0, 0, 0), point(1, 0, -0.25), point(1, 0, 0.25), point(0, 1, 0), point(1, 1, -0.25), point(1, 1, 0.25)
    });
    write
    (
        points,
        List<triFace>
        ({
            triFace(0, 1, 2), triFace(3, 5, 4), triFace(0, 3, 4), triFace(0, 4, 1),
            triFace(0, 2, 5), triFace(0, 5, 3), triFace(1, 4, 5), triFace(1, 5, 2)
        })
    );
    const double spacing = 0.1;
    const autoPtr<closedSurface> wedge(surface(3));
    EXPECT_NEAR(wedge->measures().volume, 0.25, 1e-6);
    solidMeasures represented;
    const wallParticles wall = surfaceLayers(*wedge, spacing, nLayers, {}, represented);
    double first = 1;
    forAll(wall.x, i)
    {
        EXPECT_GT(wedge->findNearest(wall.x[i], GREAT).depth, 0.2*spacing);
        first = std::min(first, wall.x[i].x());
    }

    // It is half a spacing thick at x = 0.1, and a whole one at 0.2
    EXPECT_GT(first, 0.1);
    EXPECT_LT(first, 0.2);
    EXPECT_LT(represented.volume, 0.25);
    EXPECT_GT(represented.volume, 0.245);
    EXPECT_GT(distances(wall.x).first, 0.5*spacing);
}


// A quarter of a ball and its images are evenly spread, too
TEST_F(wallLayers, ofAQuarter)
{
    pointField points;
    List<triFace> triangles;
    ball(5, points, triangles);
    const vector centre(0.3, 0.2, -0.1);
    write(points + centre, triangles);
    const double spacing = 0.1;
    const autoPtr<closedSurface> body(surface(3));
    solidMeasures represented;
    const wallParticles quarter = surfaceLayers(*body, spacing, nLayers, {{0, 0.3, 1}, {1, 0.2, -1}}, represented);
    EXPECT_NEAR(represented.volume/body->measures().volume, 1, 1e-3);
    EXPECT_LT(mag(represented.centroid() - centre), 1e-3);
    EXPECT_LT(mag(represented.inertia() - body->measures().inertia()), 0.01*mag(body->measures().inertia()));

    wallParticles whole;
    forAll(quarter.x, i)
    {
        const vector r(quarter.x[i] - centre);
        EXPECT_GT(r.x(), 0.3*spacing);
        EXPECT_LT(r.y(), -0.3*spacing);
        for (const vector& image : {r, vector(-r.x(), r.y(), r.z()), vector(r.x(), -r.y(), r.z()), vector(-r.x(), -r.y(), r.z())})
        {
            whole.x.append(image);
            whole.volume.append(quarter.volume[i]);
        }
    }
    EXPECT_GT(distances(whole.x).first, 0.7*spacing);
    EXPECT_NEAR(whole.x.size()*pow3(spacing)/(4*M_PI/3*(1 - 0.343)), 1, 0.08);
    const double exact = shellSum(0.5*spacing, spacing);
    double square = 0;
    constexpr int n = 50;
    for (int k = 0; k < n; ++k)
    {
        // Along one of the planes
        const point at((1 + 0.5*spacing)*vector(0, std::cos(k), std::sin(k)));
        square += sqr(kernelSum(whole, at, spacing, 3)/exact - 1)/n;
    }
    EXPECT_LT(std::sqrt(square), 0.03);
}
