// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes by their type: all that the interface says of them, against each other and by hand.

#include "../surfaceInCase.H"

#include "shape.H"

#include "IStringStream.H"
#include "foamVersion.H"

#include <cmath>
#include <random>

using namespace Foam;

namespace
{

const char* const cube = "type box; solid yes; min (0 0 0); max (1 2 3);";


class shapes
:
    public surfaceInCase
{
protected:

    autoPtr<shape> read(const std::string& entries, const int dim = 3, const scalar thickness = 0) const
    {
        IStringStream stream(entries);
        stream.name() = "geometry";
        return shape::New(dictionary(stream), {dim, directory, thickness});
    }

    //- The triangles of a box
    void writeBox(const boundBox& box) const
    {
        List<triFace> triangles;
        for (const face& f : foamVersion::hexFaces<boundBox>())
        {
            triangles.append(triFace(f[0], f[1], f[2]));
            triangles.append(triFace(f[0], f[2], f[3]));
        }
        write(box.points(), triangles);
    }
};


//- Points in and about a box of three metres
pointField aboutIt()
{
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> random(-0.7, 3.7);
    pointField points(300);
    for (point& p : points)
    {
        p = point(random(engine), random(engine), random(engine));
    }
    return points;
}


//- Volume that the polygons enclose
scalar enclosed(const shape::polygons& outline)
{
    scalar volume = 0;
    for (const face& f : outline.faces)
    {
        volume += (f.centre(outline.points) & f.areaNormal(outline.points))/3;
    }
    return volume;
}


void expectAlike(const shape& a, const shape& b, const pointField& points, const scalar tolerance)
{
    EXPECT_LT(mag(a.bounds().min() - b.bounds().min()) + mag(a.bounds().max() - b.bounds().max()), tolerance);
    EXPECT_NEAR(a.measures().volume, b.measures().volume, tolerance);
    EXPECT_LT(mag(a.measures().centroid() - b.measures().centroid()), tolerance);
    EXPECT_LT(mag(a.measures().inertia().zz() - b.measures().inertia().zz()), 2*tolerance);
    EXPECT_NEAR(a.area(), b.area(), tolerance);
    for (const point& p : points)
    {
        const shape::foot f(a.findNearest(p, GREAT)), g(b.findNearest(p, GREAT));
        EXPECT_NEAR(f.depth, g.depth, tolerance) << p.x() << " " << p.y() << " " << p.z();
        EXPECT_NEAR(mag(p - f.x), mag(f.depth), 1e-12);
        EXPECT_NEAR((f.x - p) & f.normal, f.depth, 1e-9) << p.x() << " " << p.y() << " " << p.z();
        if (mag(f.depth) > tolerance)
        {
            EXPECT_EQ(a.contains(p), f.depth > 0);
            EXPECT_EQ(b.contains(p), f.depth > 0);
            EXPECT_TRUE(a.findNearest(p, 1.01*mag(f.depth)).found);
            EXPECT_FALSE(a.findNearest(p, 0.99*mag(f.depth)).found);
        }
        shape::touching t;
        EXPECT_EQ(a.touch(p, 0.2, t), f.depth > -0.2);
        if (f.depth > -0.2)
        {
            EXPECT_NEAR(t.depth, 0.2 + f.depth, 1e-12);
        }
    }
}

} // End anonymous namespace


TEST_F(shapes, aBoxIsThatOfItsTriangles)
{
    writeBox(boundBox(point::zero, point(1, 2, 3)));
    const autoPtr<shape> box(read(cube)), surface(read("type surface; file \"constant/body.stl\";"));
    expectAlike(*box, *surface, aboutIt(), 1e-5);
    expectAlike(*surface, *box, aboutIt(), 1e-5);
    EXPECT_EQ(box->outline().faces.size(), 6);
    EXPECT_EQ(surface->outline().faces.size(), 12);
    EXPECT_NEAR(mag(enclosed(box->outline())), 6, 1e-12);
    EXPECT_EQ(box->largestFacet(), 0);
    EXPECT_NEAR(surface->largestFacet(), 3, 1e-5);
}


TEST_F(shapes, aRectangleIsTheCutOfABox)
{
    writeBox(boundBox(point(0, 0, -0.4), point(1, 2, 0.7)));
    const autoPtr<shape> box(read("type box; solid yes; min (0 0 0); max (1 2 0);", 2));
    const autoPtr<shape> cut(read("type surface; file \"constant/body.stl\";", 2));
    pointField points(aboutIt());
    for (point& p : points)
    {
        p.z() = 0;
    }
    expectAlike(*box, *cut, points, 1e-5);

    // In the plane to the last digit, off which nothing is inside
    for (const point& p : points)
    {
        const shape::foot foot(cut->findNearest(p, GREAT));
        EXPECT_EQ(foot.x.z(), 0);
        EXPECT_EQ(foot.normal.z(), 0);
    }

    // Each side of the box is two triangles
    EXPECT_NEAR(cut->largestFacet(), 14.0/11, 1e-5);

    // One outline round the rectangle
    const shape::polygons outline(cut->outline());
    ASSERT_EQ(outline.faces.size(), 1);
    EXPECT_NEAR(mag(outline.faces[0].areaNormal(outline.points)), 2, 1e-5);
    EXPECT_EQ(box->outline().faces.size(), 1);
}


TEST_F(shapes, aSphereAndACircle)
{
    const autoPtr<shape> ball(read("type sphere; centre (1 2 3); radius 2;")), disc(read("type sphere; centre (1 2 0); radius 2;", 2));
    EXPECT_NEAR(ball->measures().volume, 32*M_PI/3, 1e-12);
    EXPECT_NEAR(ball->area(), 16*M_PI, 1e-12);
    EXPECT_NEAR(disc->measures().volume, 4*M_PI, 1e-12);
    EXPECT_NEAR(disc->area(), 4*M_PI, 1e-12);
    EXPECT_NEAR(mag(enclosed(ball->outline())), 32*M_PI/3, 0.3);
    EXPECT_EQ(disc->outline().faces.size(), 1);
    const shape::foot foot(ball->findNearest(point(1, 2, 0.5), GREAT));
    EXPECT_NEAR(foot.depth, -0.5, 1e-12);
    EXPECT_LT(mag(foot.x - point(1, 2, 1)), 1e-12);
    EXPECT_LT(mag(foot.normal - vector(0, 0, -1)), 1e-12);
    EXPECT_TRUE(ball->contains(point(1, 2, 4.9)));
    EXPECT_FALSE(ball->contains(point(1, 2, 5.1)));
}


TEST_F(shapes, aTankIsAroundItsBox)
{
    const autoPtr<shape> tank(read("type box; min (0 0 0); max (1 2 3); open (top);", 3, 0.5));
    EXPECT_TRUE(tank->surrounds());
    EXPECT_FALSE(read(cube)->surrounds());
    EXPECT_TRUE(tank->contains(point(-0.4, 1, 1)));
    EXPECT_FALSE(tank->contains(point(0.5, 1, 1)));
    EXPECT_FALSE(tank->contains(point(-0.6, 1, 1)));
    EXPECT_FALSE(tank->contains(point(0.5, 1, 3.1)));
    EXPECT_EQ(tank->measures().volume, 0);
    EXPECT_NEAR(tank->area(), 2 + 2*(2*3 + 1*3), 1e-12);
    EXPECT_NEAR(tank->findNearest(point(0.3, 1, 2.9), GREAT).depth, -0.3, 1e-12);
    EXPECT_NEAR(tank->findNearest(point(-0.3, 1, 1), GREAT).depth, 0.3, 1e-12);
    EXPECT_LT(mag(tank->findNearest(point(-0.3, 1, 1), GREAT).normal - vector(1, 0, 0)), 1e-12);
}


TEST_F(shapes, whatIsImpossibleIsRefused)
{
    expectRefusal({"Entry type is cone", "box", "sphere", "surface", "geometry"}, [&]{ read("type cone;"); });
    expectRefusal({"Unknown entry radius"}, [&]{ read(std::string(cube) + "radius 1;"); });
    expectRefusal({"min below max"}, [&]{ read("type box; min (0 0 0); max (1 0 1);"); });
    expectRefusal({"Entry radius is -1", "positive"}, [&]{ read("type sphere; centre (0 0 0); radius -1;"); });
    expectRefusal({"Entry centre", "two-dimensional"}, [&]{ read("type sphere; centre (0 0 1); radius 1;", 2); });
    expectRefusal({"Entry open has the face front", "left"}, [&]{ read("type box; min (0 0 0); max (1 1 0); open (front);", 2); });
}
