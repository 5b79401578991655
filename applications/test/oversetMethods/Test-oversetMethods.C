// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests of the overset methods: volumes that a closed surface covers.

#include <gtest/gtest.h>

#include "mathematicalConstants.H"
#include "uniqueVolume.H"

using namespace Foam;

namespace
{

typedef uniqueVolume::triangle triangle;

triangle corners(const point& a, const point& b, const point& c)
{
    triangle t;
    t[0] = a;
    t[1] = b;
    t[2] = c;
    return t;
}


//- The faces of a box, turned about its centre by a rotation tensor
List<triangle> turnedBox(const boundBox& box, const tensor& R)
{
    const point c = box.centre();
    const vector h = 0.5*box.span();
    auto corner = [&](int i)
    {
        return c + (R & vector(i & 1 ? h.x() : -h.x(), i & 2 ? h.y() : -h.y(), i & 4 ? h.z() : -h.z()));
    };

    List<triangle> surface;
    const int faces[6][4] =
        {{0,4,6,2}, {1,3,7,5}, {0,1,5,4}, {2,6,7,3}, {0,2,3,1}, {4,5,7,6}};
    for (const auto& f : faces)
    {
        surface.append(corners(corner(f[0]), corner(f[1]), corner(f[2])));
        surface.append(corners(corner(f[0]), corner(f[2]), corner(f[3])));
    }
    return surface;
}


//- The unit cube cut into n^3 boxes
List<boundBox> grid(const label n)
{
    List<boundBox> boxes;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            for (label k = 0; k < n; ++k)
            {
                boxes.append(boundBox(point(i, j, k)/n, point(i + 1, j + 1, k + 1)/n));
            }
        }
    }
    return boxes;
}


tensor rotation(const scalar a, const scalar b)
{
    const tensor Rz(::cos(a), -::sin(a), 0, ::sin(a), ::cos(a), 0, 0, 0, 1);
    const tensor Rx(1, 0, 0, 0, ::cos(b), -::sin(b), 0, ::sin(b), ::cos(b));
    return Rx & Rz;
}

} // End anonymous namespace


TEST(UniqueVolume, AlignedBoxCoversItsCellsExactly)
{
    const boundBox box(point(0.15, 0.35, 0.2), point(0.55, 0.8, 0.65));
    const List<boundBox> cells(grid(10));
    const scalarField covered
    (
        uniqueVolume::coveredVolume(cells, turnedBox(box, tensor::I))
    );

    forAll(cells, i)
    {
        scalar expected = 1;
        for (direction d = 0; d < 3; ++d)
        {
            expected *= max
            (
                scalar(0),
                min(cells[i].max()[d], box.max()[d])
              - max(cells[i].min()[d], box.min()[d])
            );
        }
        EXPECT_NEAR(covered[i], expected, 1e-15);
    }
}


TEST(UniqueVolume, TurnedBoxKeepsItsVolumeAndNoCellIsOverfull)
{
    const boundBox box(point(0.3, 0.35, 0.4), point(0.7, 0.6, 0.65));
    const List<boundBox> cells(grid(9));

    for (const scalar a : {0.1, 0.7, 1.3})
    {
        const scalarField covered
        (
            uniqueVolume::coveredVolume
            (
                cells,
                turnedBox(box, rotation(a, 2*a))
            )
        );
        EXPECT_NEAR(sum(covered), box.volume(), 1e-14);
        EXPECT_GT(min(covered), -1e-15);
        EXPECT_LT(max(covered), cells[0].volume() + 1e-15);
    }
}


TEST(UniqueVolume, PlaneOfSymmetryMayCloseTheSurface)
{
    // A box whose face at y = 0 is missing
    const boundBox box(point(0.2, 0, 0.3), point(0.6, 0.5, 0.7));
    List<triangle> open;
    for (const triangle& t : turnedBox(box, tensor::I))
    {
        if (t[0].y() + t[1].y() + t[2].y() > SMALL)
        {
            open.append(t);
        }
    }
    ASSERT_EQ(open.size(), 10);
    EXPECT_NEAR
    (
        sum(uniqueVolume::coveredVolume(grid(7), open)),
        box.volume(),
        1e-14
    );
}


// The boundary of a zone in a plane mesh has no ends: across the empty direction, whichever that is, it is not closed
TEST(UniqueVolume, BoundaryAcrossAPlaneMeshCoversItsArea)
{
    const boundBox box(point(0.3, 0.35, 0), point(0.7, 0.6, 1));
    for (const tensor& axes : {tensor::I, tensor(0, 0, 1, 1, 0, 0, 0, 1, 0), tensor(0, 1, 0, 0, 0, 1, 1, 0, 0)})
    {
        for (const scalar angle : {0.0, 0.7, 1.3})
        {
            List<triangle> sides;
            for (triangle t : turnedBox(box, rotation(angle, 0)))
            {
                if (mag(((t[1] - t[0]) ^ (t[2] - t[0])).z()) < SMALL)
                {
                    // To round-off
                    t[0].z() += 1e-17;
                    t[1].x() -= 1e-17;
                    sides.append(corners(axes & t[0], axes & t[1], axes & t[2]));
                }
            }
            ASSERT_EQ(sides.size(), 8);

            List<boundBox> cells;
            for (label i = 0; i < 9; ++i)
            {
                for (label j = 0; j < 9; ++j)
                {
                    cells.append(boundBox(axes & (point(i, j, 0)/9), axes & point((i + 1)/9.0, (j + 1)/9.0, 1)));
                }
            }
            const scalarField covered(uniqueVolume::coveredVolume(cells, sides));
            EXPECT_NEAR(sum(covered), box.volume(), 1e-14);
            EXPECT_GT(min(covered), -1e-15);
            EXPECT_LT(max(covered), cells[0].volume() + 1e-15);
        }
    }
}


// Between planes at 2.5 degrees to that of x and z, and in boxes about the cells of the wedge
TEST(UniqueVolume, BoundaryInAWedgeCoversItsSector)
{
    const scalar slope = ::tan(2.5*constant::mathematical::pi/180);
    const auto at = [&](scalar x, scalar r, int side)
    {
        return point(x, side*slope*r, r);
    };
    List<triangle> surface;
    const auto append = [&](const point& a, const point& b, const point& c)
    {
        surface.append(corners(a, b, c));
    };
    const scalar x0 = 0.23, x1 = 0.61, R = 0.37;
    append(at(x0, 0, 1), at(x0, R, -1), at(x0, R, 1));
    append(at(x1, 0, 1), at(x1, R, 1), at(x1, R, -1));
    append(at(x0, R, -1), at(x1, R, 1), at(x0, R, 1));
    append(at(x0, R, -1), at(x1, R, -1), at(x1, R, 1));

    List<boundBox> cells;
    for (label i = 0; i < 10; ++i)
    {
        for (label k = 0; k < 10; ++k)
        {
            const scalar r = 0.1*(k + 1);
            cells.append(boundBox(point(0.1*i, -slope*r, 0.1*k), point(0.1*(i + 1), slope*r, r)));
        }
    }
    const scalarField covered(uniqueVolume::coveredVolume(cells, surface));
    forAll(cells, c)
    {
        const boundBox& b = cells[c];
        const scalar length = max(scalar(0), min(x1, b.max().x()) - max(x0, b.min().x()));
        const scalar r = max(min(R, b.max().z()), b.min().z());
        EXPECT_NEAR(covered[c], length*slope*(sqr(r) - sqr(b.min().z())), 1e-15) << c;
    }
}


TEST(UniqueVolume, SurfaceOutOfReachCoversNothing)
{
    const boundBox box(point(2, 2, 2), point(3, 3, 3));
    EXPECT_EQ
    (
        sum(uniqueVolume::coveredVolume(grid(4), turnedBox(box, tensor::I))),
        0
    );
}

// ************************************************************************* //
