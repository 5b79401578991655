// SPDX-License-Identifier: GPL-3.0-or-later
// The flow along the axis: Lamb's added masses, cones against self-similar solutions.

#include <gtest/gtest.h>

#include "axialEntry.H"
#include "bodies.H"
#include "spheroid.H"

namespace
{

//- Force over rho U^2 c^2 of a cone of this deadrise angle that enters at a steady speed, by the modified Logvinovich model
//  (Korobkin 2004) with Wagner's contact line c = 4 z/(pi tan(deadrise)), in closed form
scalar modifiedLogvinovich(const scalar deadrise)
{
    const scalar T = std::tan(deadrise*pi/180);
    const scalar first = 8/(pi*pi*T), kappa = 2/(pi*pi*(1 + T*T));
    // sqrt(1 - s^2) where the pressure is zero
    const scalar q = (first - std::sqrt(first*first - 4*(0.5 - kappa)*kappa))/(2*(0.5 - kappa));
    return pi*2*(first*(1 - q) - 0.25*(1 - q*q) - kappa*(-std::log(q) - 0.5*(1 - q*q)));
}

} // End anonymous namespace


TEST(spheroid, isLambs)
{
    const spheroid sphere(1, 1), prolate(5, 1), nearly(1.0001, 1), disc(1e-4, 1);
    EXPECT_NEAR(sphere.along, 0.5, 1e-12);
    EXPECT_NEAR(sphere.across, 0.5, 1e-12);
    EXPECT_NEAR(sphere.about, 0, 1e-12);
    EXPECT_NEAR(nearly.along, 0.5, 1e-4);
    // Lamb 1932, art. 115, table, of 4.99 in three digits
    EXPECT_NEAR(prolate.along, 0.059, 1.5e-3);
    EXPECT_NEAR(prolate.across, 0.895, 1.5e-3);
    EXPECT_NEAR(prolate.about, 0.701, 1.5e-3);
    // 8/3 rho b^3
    EXPECT_NEAR(disc.along*4*pi/3*1e-4, 8.0/3, 1e-3);
}


TEST(axialEntry, immersedBodiesHaveLambsAddedMass)
{
    const meridian sphere(spheroidOf(1, 1)), slender(spheroidOf(5, 0.5));
    EXPECT_NEAR(axialEntry(sphere).immersedMass()/sphere.volume(), 0.5, 3e-4);
    EXPECT_NEAR(axialEntry(slender).immersedMass()/slender.volume(), spheroid(5, 0.5).along, 1e-5);
}


TEST(axialEntry, halfASphereBelowTheSurface)
{
    const meridian sphere(spheroidOf(1, 1));
    EXPECT_NEAR(axialEntry::mass(axialEntry::solve(sphere, 1, 48)), pi/3, 1e-3);
}


TEST(axialEntry, riseOfTheLiquid)
{
    EXPECT_NEAR(axialEntry::rise(coneOf(89.5, 1), 0.004), 4/pi, 5e-3);
    EXPECT_NEAR(axialEntry::rise(coneOf(45, 1), 0.5), 1.125, 1e-3);
    EXPECT_NEAR(axialEntry::rise(coneOf(5, 1), 5), 1, 0.02);
    // A parabola's is 3/2
    EXPECT_NEAR(axialEntry::rise(spheroidOf(1, 1), 1e-4), 1.5, 0.02);
}


TEST(axialEntry, conesAreSelfSimilar)
{
    for (const scalar angle : {12.0, 25.0, 45.0, 80.0})
    {
        const axialEntry entry(coneOf(angle, 20));
        const scalar height = 1/std::tan(angle*pi/180);
        const auto coefficient = [&](const scalar depth){ return entry.force(depth*height)/sqr(depth*height); };
        EXPECT_NEAR(coefficient(0.2)/coefficient(0.7), 1, 0.04) << angle;
        const auto mass = [&](const scalar depth){ return entry.mass(depth*height)/pow3(depth*height); };
        EXPECT_NEAR(mass(0.2)/mass(0.7), 1, 0.06) << angle;
    }
}


//  Blunt cones: the force of Korobkin's model, which has the body's slope to first order. Allowed is what that leaves out
TEST(axialEntry, bluntConesHaveTheForceOfTheSelfSimilarFormula)
{
    for (const auto& each : {std::make_pair(5.0, 0.02), std::make_pair(10.0, 0.03), std::make_pair(20.0, 0.05), std::make_pair(45.0, 0.12)})
    {
        const meridian cone(coneOf(90 - each.first, 20));
        const axialEntry entry(cone);
        const scalar c = 0.9;
        const scalar depth = cone.xOf(c)/axialEntry::rise(cone, cone.xOf(c));
        EXPECT_NEAR(entry.force(depth)/(c*c)/modifiedLogvinovich(each.first), 1, each.second) << each.first;
    }
}


//  Slender cones: half the rate of the added mass, whose other half is the liquid's kinetic energy
TEST(axialEntry, slenderConesLoseNoEnergyToJets)
{
    const axialEntry entry(coneOf(6, 60));
    const scalar height = 1/std::tan(6*pi/180);
    const scalar rate = (entry.mass(0.55*height) - entry.mass(0.45*height))/(0.1*height);
    EXPECT_NEAR(entry.force(0.5*height)/(0.5*rate), 1, 0.06);
}


TEST(axialEntry, aFlatFaceHasTheImpulseOfADisc)
{
    std::vector<scalar> x, r;
    for (int i = 0; i <= 200; ++i)
    {
        x.push_back(0);
        r.push_back(i/200.0);
    }
    for (int i = 1; i <= 200; ++i)
    {
        x.push_back(i/20.0);
        r.push_back(1);
    }
    x.push_back(10);
    r.push_back(0);
    const axialEntry entry(meridian(x, r));
    scalar impulse = 0;
    for (int i = 0; i < 1000; ++i)
    {
        impulse += entry.force(0.01*(i + 0.5)/1000)*0.01/1000;
    }
    EXPECT_NEAR(impulse, 4.0/3, 1e-3);
    EXPECT_NEAR(entry.mass(0.06), 4.0/3, 0.2);
}
