// SPDX-License-Identifier: GPL-3.0-or-later
// Events of a body at which a run ends.

#include "../refusedInput.H"

#include "bodyEvent.H"

#include "IStringStream.H"

using namespace Foam;

namespace
{

bodyEvent event(const std::string& name)
{
    IStringStream stream("until " + name + ";");
    stream.name() = "constant/body";
    return bodyEvent(dictionary(stream), "until");
}


//- A body that reaches 1 m up and down from its middle
bodyEvent::place at(const scalar height, const scalar climb, const scalar speed)
{
    return {height - 1, height + 1, speed, climb};
}

} // End anonymous namespace


TEST(bodyEvent, immersedIsTheWholeBody)
{
    bodyEvent immersed(event("immersed"));
    EXPECT_FALSE(immersed.hasHappened(at(2, -1, 1)));
    EXPECT_FALSE(immersed.hasHappened(at(-0.99, -1, 1)));
    EXPECT_TRUE(immersed.hasHappened(at(-1.01, -1, 1)));
}


TEST(bodyEvent, atRestIsAHundredthOfTheHighestSpeed)
{
    bodyEvent atRest(event("atRest"));
    // It has not moved yet
    EXPECT_FALSE(atRest.hasHappened(at(2, 0, 0)));
    EXPECT_FALSE(atRest.hasHappened(at(2, -1, 1)));
    EXPECT_FALSE(atRest.hasHappened(at(2, -5, 5)));
    EXPECT_FALSE(atRest.hasHappened(at(2, -0.051, 0.051)));
    EXPECT_TRUE(atRest.hasHappened(at(2, -0.049, 0.049)));
}


TEST(bodyEvent, leavesTheLiquidOnceItHasTouchedIt)
{
    bodyEvent left(event("leftTheLiquid"));
    EXPECT_FALSE(left.hasHappened(at(2, 1, 1)));
    EXPECT_FALSE(left.hasHappened(at(0.5, -1, 1)));
    // Above it, but on the way down
    EXPECT_FALSE(left.hasHappened(at(1.1, -1, 1)));
    EXPECT_FALSE(left.hasHappened(at(0.9, 1, 1)));
    EXPECT_TRUE(left.hasHappened(at(1.1, 1, 1)));
}


TEST(bodyEvent, surfacesOnceItWasImmersed)
{
    bodyEvent surfaced(event("surfaced"));
    EXPECT_FALSE(surfaced.hasHappened(at(0.5, -1, 1)));
    EXPECT_FALSE(surfaced.hasHappened(at(-1.1, -1, 1)));
    bodyEvent again(event("surfaced"));
    again.remember(surfaced.memory());
    EXPECT_FALSE(again.hasHappened(at(-1.1, 1, 1)));
    EXPECT_TRUE(again.hasHappened(at(-0.9, 1, 1)));
}


TEST(bodyEvent, remembers)
{
    bodyEvent atRest(event("atRest")), left(event("leftTheLiquid"));
    atRest.hasHappened(at(2, -5, 5));
    left.hasHappened(at(0.5, -5, 5));
    bodyEvent atRestAgain(event("atRest")), leftAgain(event("leftTheLiquid"));
    atRestAgain.remember(atRest.memory());
    leftAgain.remember(left.memory());
    EXPECT_TRUE(atRestAgain.hasHappened(at(2, 0.04, 0.04)));
    EXPECT_TRUE(leftAgain.hasHappened(at(2, 1, 1)));
    EXPECT_FALSE(event("atRest").hasHappened(at(2, 0.04, 0.04)));
    EXPECT_FALSE(event("leftTheLiquid").hasHappened(at(2, 1, 1)));
}


TEST(bodyEvent, anotherNameIsRefused)
{
    expectRefusal({"until", "sunk", "immersed", "atRest", "leftTheLiquid", "constant/body"}, []{ event("sunk"); });
}
