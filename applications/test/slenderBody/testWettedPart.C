// SPDX-License-Identifier: GPL-3.0-or-later
// What of a body is below the surface, at any angle.

#include <gtest/gtest.h>

#include "bodies.H"
#include "wettedPart.H"

namespace
{

//- Of a body whose nose is ahead of the origin by its centre, at a height, with its axis this far below the horizontal [rad]
wettedPart part(const meridian& body, const scalar angle, const scalar height, const vector& v = Zero, const vector& omega = Zero)
{
    wettedPart wet;
    const vector up(-std::sin(angle), 0, std::cos(angle));
    wet.update(body.slices(96), body, vector(body.centre(), 0, 0), up, height, v, omega);
    return wet;
}

scalar volume(const meridian& body, const wettedPart& wet)
{
    const auto slices = body.slices(96);
    scalar sum = 0;
    for (std::size_t i = 0; i < slices.size(); ++i)
    {
        sum += slices[i].volume*wet.slices[i].wet;
    }
    return sum;
}

} // End anonymous namespace


TEST(wettedPart, capsOfASphereAtAnyAngle)
{
    const meridian sphere(spheroidOf(1, 1));
    for (const scalar angle : {0.0, 0.3, 1.0, 0.5*pi, -0.7, 2.5})
    {
        for (const scalar height : {-1.2, -0.9, -0.5, 0.0, 0.4, 0.8, 1.1})
        {
            const scalar h = max(min(1 - height, scalar(2)), scalar(0));
            EXPECT_NEAR(volume(sphere, part(sphere, angle, height)), pi*h*h*(3 - h)/3, 4e-3) << angle << ' ' << height;
            EXPECT_NEAR(part(sphere, angle, height).lowest, height - 1, 2e-3);
            EXPECT_NEAR(part(sphere, angle, height).highest, height + 1, 2e-3);
        }
    }
}


TEST(wettedPart, uprightTheLengthIsTheDepth)
{
    const meridian body(spheroidOf(2, 0.2));
    for (const scalar depth : {1e-6, 0.01, 0.5, 1.7, 3.9})
    {
        const wettedPart wet(part(body, 0.5*pi, 2 - depth, vector(3, 0, 0)));
        EXPECT_NEAR(wet.length, depth, 1e-9);
        EXPECT_NEAR(wet.lengthRate, 3, 1e-9);
    }
    EXPECT_NEAR(part(body, 0.5*pi, -2.5).length, 4.5, 1e-9);
}


TEST(wettedPart, ratesAreDerivatives)
{
    const meridian body(spheroidOf(2, 0.3));
    const vector v(2, 0.5, -1), omega(0.3, 0.8, -0.2);
    for (const scalar angle : {0.02, 0.6, 1.3, 1.55})
    {
        const scalar dt = 1e-6, height = 0.15;
        const wettedPart now(part(body, angle, height, v, omega));
        // The motion in a short time, up in axes that turn
        const vector up0(-std::sin(angle), 0, std::cos(angle));
        wettedPart later;
        later.update(body.slices(96), body, vector(body.centre(), 0, 0), up0 - dt*(omega ^ up0), height + dt*(v & up0), v, omega);
        EXPECT_NEAR((later.length - now.length)/dt, now.lengthRate, 1e-3*mag(now.lengthRate) + 1e-3) << angle;
        scalar largest = 0;
        for (std::size_t i = 0; i < now.slices.size(); ++i)
        {
            largest = max(largest, mag((later.slices[i].wet - now.slices[i].wet)/dt - now.slices[i].rate));
        }
        EXPECT_LT(largest, 2e-2) << angle;
    }
}
