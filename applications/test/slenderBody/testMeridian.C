// SPDX-License-Identifier: GPL-3.0-or-later
// Meridians: volumes, corners, and points that are none of a body.

#include <gtest/gtest.h>

#include "bodies.H"

#include <stdexcept>

TEST(meridian, sphere)
{
    const meridian sphere(spheroidOf(1, 1));
    EXPECT_NEAR(sphere.volume(), 4*pi/3, 2e-5);
    EXPECT_NEAR(sphere.area(), 4*pi, 2e-5);
    EXPECT_NEAR(sphere.centre(), 1, 1e-12);
    EXPECT_NEAR(sphere.maxRadius(), 1, 1e-12);
    EXPECT_NEAR(sphere.arcLength(), pi, 1e-5);
    EXPECT_LT(sphere.sharpCorner(10), 0);
    EXPECT_EQ(sphere.faceRadius(), 0);
    EXPECT_EQ(sphere.baseRadius(), 0);
    const meridian::place at(sphere.at(pi/3));
    EXPECT_NEAR(at.x, 0.5, 1e-5);
    EXPECT_NEAR(at.r, std::sqrt(0.75), 1e-5);
    EXPECT_NEAR(at.tx, std::sqrt(0.75), 1e-5);
    EXPECT_NEAR(at.tr, 0.5, 1e-5);
}


TEST(meridian, slicesMakeTheBody)
{
    const meridian cone(coneOf(30, 2));
    scalar volume = 0, moment = 0, area = 0, end = 0;
    for (const meridian::slice& s : cone.slices(50))
    {
        EXPECT_NEAR(s.low, end, 1e-12);
        volume += s.volume;
        moment += s.volume*s.centre;
        area += s.area;
        end = s.high;
    }
    EXPECT_NEAR(end, cone.length(), 1e-12);
    EXPECT_NEAR(volume, pi*(std::sqrt(3.0)/3 + 2), 1e-10);
    EXPECT_NEAR(moment/volume, cone.centre(), 1e-12);
    EXPECT_NEAR(area, pi*(2 + 4), 1e-10);
}


TEST(meridian, corners)
{
    const meridian cone(coneOf(45, 2));
    EXPECT_NEAR(cone.at(cone.sharpCorner(10)).x, 1, 1e-9);
    EXPECT_NEAR(cone.baseRadius(), 1, 1e-12);
    EXPECT_NEAR(cone.widest(), 1, 1e-12);
    EXPECT_NEAR(cone.xOf(0.5), 0.5, 1e-12);
    const meridian cylinder(cone.withCylinder(1, 7));
    EXPECT_NEAR(cylinder.length(), 8, 1e-12);
    EXPECT_NEAR(cylinder.volume(), pi*(1.0/3 + 7), 1e-10);
}


TEST(meridian, refusesWhatIsNoBody)
{
    EXPECT_THROW(meridian({0, 1}, {0, 0}), std::invalid_argument);
    EXPECT_THROW(meridian({0, 1, 0.5, 2}, {0, 1, 1, 0}), std::invalid_argument);
    EXPECT_THROW(meridian({0, 1, 2}, {0, 1, 0.5}), std::invalid_argument);
    EXPECT_THROW(meridian({0, 1, 2}, {0, -1, 0}), std::invalid_argument);
    EXPECT_THROW(meridian::read("isNotThere.csv"), std::invalid_argument);
}
