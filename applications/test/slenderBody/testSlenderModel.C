// SPDX-License-Identifier: GPL-3.0-or-later
// What acts on a body, and dives that are known exactly.

#include <gtest/gtest.h>

#include "bodies.H"
#include "refusedInput.H"
#include "slenderDive.H"
#include "spheroid.H"
#include "StringStream.H"

namespace
{

const vector g(0, 0, -10);

//- A spheroid of half axes 1 and 0.1 m with its axis this far below the horizontal [deg], its centre at a height, and more entries
dictionary entries(const scalar mass, const scalar angle, const scalar height, const vector& v, const std::string& more = "")
{
    const scalar a = angle*pi/180;
    OStringStream os;
    os.precision(17);
    os  << "body { mass " << mass << "; momentOfInertia (0.1 6 6); centreFromNose (1 0 0); centreOfMass (0 0 " << height
        << "); orientation (" << std::cos(a) << " 0 " << std::sin(a) << " 0 1 0 " << -std::sin(a) << " 0 " << std::cos(a)
        << "); velocity " << v << "; freedom free; } liquid { rho 1000; mu 0.001; } outputs { interval 0.01; } " << more.c_str();
    IStringStream is(os.str());
    return dictionary(is);
}

std::shared_ptr<const meridian> slender()
{
    static const auto shape = std::make_shared<const meridian>(spheroidOf(1, 0.1));
    return shape;
}

slenderProperties properties(const dictionary& dict, const vector& gravity = g)
{
    return slenderProperties(dict, gravity, ".", slender());
}

} // End anonymous namespace


TEST(slenderModel, aNeutralBodyRests)
{
    const auto p = properties(entries(1000*slender()->volume(), 30, -5, Zero));
    const slenderModel model(p);
    const auto now = model.evaluate(model.start());
    EXPECT_LT(mag(now.acceleration.linear), 1e-12);
    EXPECT_LT(mag(now.acceleration.angular), 1e-12);
}


TEST(slenderModel, aFloatingBodyIsInEquilibrium)
{
    // Upright, by half its length: half of its weight
    const auto p = properties(entries(500*slender()->volume(), 90, 0, Zero));
    const slenderModel model(p);
    const auto now = model.evaluate(model.start());
    EXPECT_LT(mag(now.acceleration.linear), 1e-4);
    EXPECT_LT(mag(now.acceleration.angular), 1e-10);
}


TEST(slenderModel, MunksMoment)
{
    const auto p = properties(entries(1000*slender()->volume(), 0, -5, vector(3, 0, 0.5), "boundaryLayer none; crossFlow off;"));
    const slenderModel model(p);
    const auto now = model.evaluate(model.start());
    const spheroid lamb(1, 0.1);
    const scalar munk = 1000*slender()->volume()*(lamb.across - lamb.along)*3*0.5;
    // It turns the nose away from the velocity: down
    EXPECT_NEAR(now.acceleration.angular.y()*(6 + lamb.about*1000*slender()->volume()*1.01/5), munk, 1e-4*munk);
}


TEST(slenderModel, freeFallIsExact)
{
    const auto p = properties(entries(10, 75, 30, vector(2, 1, -3)));
    slenderDive dive(p, 2);
    while (dive.runs())
    {
        dive.advance();
    }
    EXPECT_NEAR(dive.time(), 2, 1e-12);
    EXPECT_NEAR(dive.state()[0], 4, 1e-12);
    EXPECT_NEAR(dive.state()[1], 2, 1e-12);
    EXPECT_NEAR(dive.state()[2], 30 - 6 - 20, 1e-11);
}


TEST(slenderModel, terminalSpeedHoldsTheWeight)
{
    const scalar mass = 1.5*1000*slender()->volume();
    const auto p = properties(entries(mass, 90, -3, vector(0, 0, -1), "body { freedom axial; heading (0 0 -1); }"));
    slenderDive dive(p, 60);
    while (dive.runs())
    {
        dive.advance();
    }
    const auto& now = dive.now();
    const scalar drag = -(now.forces[slenderModel::friction].linear.x() + now.forces[slenderModel::form].linear.x());
    EXPECT_NEAR(drag, (mass - 1000*slender()->volume())*10, 1e-5*drag);
    EXPECT_LT(mag(now.acceleration.linear), 1e-5);
}


TEST(slenderModel, theBudgetOfEnergyCloses)
{
    // Through the surface at an angle, with all forces
    const auto p = properties
    (
        entries
        (
            20, 70, 1.05, vector(8, 0, -20),
            "transitionReynolds 0; body { tail { volumeCoefficient 0.2; } angularVelocity (0.5 0.1 -0.1); }"
        )
    );
    slenderDive dive(p, 0.5);
    const scalar energy = dive.model().kineticEnergy(dive.now());
    scalar largest = 0;
    while (dive.runs())
    {
        dive.advance();
        largest = max(largest, mag(dive.imbalance()));
    }
    EXPECT_LT(largest, 1e-6*energy);
    EXPECT_LT(dive.state()[13 + slenderModel::inertia], -1e-3*energy);
    EXPECT_LT(dive.state()[13 + slenderModel::friction], -1e-3*energy);
}


TEST(slenderModel, anIdealLiquidKeepsTheEnergyOfAnImmersedBody)
{
    const auto p = properties(entries(30, 10, -50, vector(3, 0.3, 0.2), "boundaryLayer none; crossFlow off; tolerance 1e-11;"), Zero);
    slenderDive dive(p, 3);
    const auto energyOf = [&]
    {
        const auto& now = dive.now();
        return dive.model().kineticEnergy(now) + 0.5*(now.velocity & (now.added & now.velocity));
    };
    const scalar first = energyOf();
    while (dive.runs())
    {
        dive.advance();
    }
    EXPECT_GT(mag(dive.now().velocity.angular), 0.1);
    EXPECT_NEAR(energyOf()/first, 1, 1e-8);
}


TEST(slenderModel, anEventIsFoundInTime)
{
    // At 10 m/s straight down without gravity and liquid forces: the highest point is 0.95 m above the surface
    const auto p = properties(entries(1e9, 90, -0.05, vector(0, 0, -10), "until immersed;"), Zero);
    slenderDive dive(p, 1);
    while (dive.runs())
    {
        dive.advance();
    }
    EXPECT_EQ(dive.event(), "immersed");
    EXPECT_NEAR(dive.time(), 0.095, 1e-6);
}


TEST(slenderModel, whetherTheFlowLeavesTheBody)
{
    const auto flowOf = [](const std::shared_ptr<const meridian>& shape, const scalar speed, const char* asked)
    {
        const dictionary dict(entries(10, 90, 5, vector(0, 0, -speed), std::string("liquid { sigma 0.072; } flow ") + asked + ";"));
        const slenderProperties p(dict, g, ".", shape);
        return slenderModel(p).hasCavity();
    };
    const auto sphere = std::make_shared<const meridian>(spheroidOf(1, 1)), cone = std::make_shared<const meridian>(coneOf(30, 5));
    EXPECT_FALSE(flowOf(slender(), 30, "auto"));
    EXPECT_TRUE(flowOf(slender(), 30, "cavity"));
    EXPECT_TRUE(flowOf(cone, 1, "auto"));
    EXPECT_FALSE(flowOf(cone, 1, "attached"));
    EXPECT_FALSE(flowOf(sphere, 5, "auto"));
    EXPECT_TRUE(flowOf(sphere, 10, "auto"));
}


//  From the moment at which the liquid, which rises, reaches the shoulder the force is that of the steady cavity or more
TEST(slenderModel, noForceBelowThatOfTheCavity)
{
    const auto cone = std::make_shared<const meridian>(coneOf(25, 10));
    const scalar height = 1/std::tan(25*pi/180);
    // 0.274 of a cone of 25 degrees, over rho U^2 A/2
    const scalar steady = 0.274*500*100*pi;
    for (const scalar depth : {0.96*height, 1.2*height, 2.5*height})
    {
        dictionary dict(entries(1e6, 90, 0, vector(0, 0, -10), "boundaryLayer none; body { freedom prescribed; centreFromNose (0 0 0); }"));
        dict.subDict("body").set("centreOfMass", vector(0, 0, -depth));
        const slenderProperties p(dict, Zero, ".", cone);
        const slenderModel model(p);
        const auto now = model.evaluate(model.start());
        const scalar force = -now.forces[slenderModel::inertia].linear.x() - now.forces[slenderModel::form].linear.x();
        EXPECT_GT(force, 0.99*steady) << depth/height;
    }
}


TEST(slenderProperties, refusesWhatCannotBe)
{
    const auto read = [](const dictionary& dict){ return [dict]{ properties(dict); }; };
    expectRefusal({"Entry mass is -1", "positive mass"}, read(entries(-1, 0, 1, Zero)));
    expectRefusal({"Unknown entry wings"}, read(entries(1, 0, 1, Zero, "wings 2;")));
    expectRefusal({"Entry freedom is loose", "prescribed"}, read(entries(1, 0, 1, Zero, "body { freedom loose; }")));
    expectRefusal({"Entry heading", "direction"}, read(entries(1, 0, 1, Zero, "body { freedom axial; }")));
    expectRefusal({"Entry volumeCoefficient is 0"}, read(entries(1, 0, 1, Zero, "body { tail { volumeCoefficient 0; } }")));
    expectRefusal({"at the centre of mass"}, read(entries(1, 0, 1, Zero, "body { tail { volumeCoefficient 1; position 1; } }")));
    expectRefusal({"Entry mu is -1"}, read(entries(1, 0, 1, Zero, "liquid { mu -1; }")));
    expectRefusal({"Entry tolerance is 0.1"}, read(entries(1, 0, 1, Zero, "tolerance 0.1;")));
    expectRefusal({"Entry interval is 0"}, read(entries(1, 0, 1, Zero, "outputs { interval 0; }")));
}


//  A sphere's centre of buoyancy is below its middle, whatever its attitude
TEST(slenderModel, theBuoyancyOfASphereHasNoMoment)
{
    const auto sphere = std::make_shared<const meridian>(spheroidOf(1, 1));
    for (const scalar angle : {0.0, 20.0, 50.0, 80.0})
    {
        for (const scalar height : {-0.6, 0.1, 0.7})
        {
            const slenderProperties p(entries(1000, angle, height, Zero, "flow attached;"), g, ".", sphere);
            const slenderModel model(p);
            const motion& force = model.evaluate(model.start()).forces[slenderModel::buoyancy];
            const scalar h = 1 - height;
            EXPECT_NEAR(mag(force.linear), 1e4*pi*h*h*(3 - h)/3, 40);
            EXPECT_LT(mag(force.angular), 3e-3*mag(force.linear)) << angle << ' ' << height;
        }
    }
}


TEST(slenderModel, frictionIsThatOfTheLine)
{
    // Blasius at Re = 2e5, then Prandtl and Schlichting at 2e7 without a laminar part
    for (const auto& each : {std::make_pair(0.1, 1.328/std::sqrt(2e5)), std::make_pair(10.0, 0.455/std::pow(std::log10(2e7), 2.58))})
    {
        const scalar U = each.first;
        const auto p = properties
        (
            entries(50, 0, -5, vector(U, 0, 0), std::string("transitionReynolds ") + (U < 1 ? "5e5;" : "0;"))
        );
        const slenderModel model(p);
        const auto now = model.evaluate(model.start());
        const scalar unit = 500*U*U*each.second*slender()->area();
        EXPECT_NEAR(-now.forces[slenderModel::friction].linear.x()/unit, 1 + 1.5*std::pow(0.1, 1.5), 1e-6);
        EXPECT_NEAR(-now.forces[slenderModel::form].linear.x()/unit, 7e-3, 1e-6);
        EXPECT_EQ(mag(now.forces[slenderModel::crossFlow].linear), 0);
    }
}


TEST(slenderModel, cylindersAcrossTheStreamHaveTheirDrag)
{
    // Re = 2e4 of the widest section: 1.2, times 0.68 of a cylinder ten diameters long
    const auto p = properties(entries(50, 0, -5, vector(0, 0, 0.1)));
    const slenderModel model(p);
    const scalar force = -model.evaluate(model.start()).forces[slenderModel::crossFlow].linear.z();
    EXPECT_NEAR(force, 500*0.01*1.2*0.68*pi*0.1, 0.01*force);
}


TEST(slenderModel, aTailSteers)
{
    const auto p = properties(entries(50, 0, -5, vector(5, 0, 0.05), "boundaryLayer none; body { tail { volumeCoefficient 0.5; aspectRatio 2; } }"));
    const slenderModel model(p);
    const motion& force = model.evaluate(model.start()).forces[slenderModel::tail];
    // Area times distance is half the frontal area times the length; Helmbold's slope
    const scalar slope = 2*pi*2/(2 + std::sqrt(8.0)), area = 0.5*pi*0.01*2/1;
    EXPECT_NEAR(force.linear.z(), -500*area*(slope*5 + 1.2*0.05)*0.05, 1e-9);
    // It turns the nose into the stream: up
    EXPECT_NEAR(force.angular.y(), force.linear.z(), 1e-9);
}


TEST(slenderDive, aDiveThatIsLostStops)
{
    const auto p = properties(entries(10, 60, -3, vector(0, 1e160, 0)));
    FatalError.throwExceptions();
    slenderDive dive(p, 1);
    EXPECT_THROW
    (
        while (dive.runs())
        {
            dive.advance();
        },
        Foam::error
    );
}
