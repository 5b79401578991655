// SPDX-License-Identifier: GPL-3.0-or-later
// What is refused in a dictionary, and what the error says of it.

#include "../refusedInput.H"

#include "inputChecks.H"

#include "IStringStream.H"

#include <cmath>

using namespace Foam;

namespace
{

enum class colour { red, blue };

const Enum<colour> colours({{ colour::red, "red" }, { colour::blue, "blue" }});


dictionary parsed(const std::string& entries)
{
    IStringStream stream(entries);
    stream.name() = "constant/paint";
    return dictionary(stream);
}

} // End anonymous namespace


TEST(inputChecks, messagesAreWhatAStreamPrints)
{
    EXPECT_EQ(text("of ", 0.25, " m, ", word("left"), ' ', std::string("or right")), "of 0.25 m, left or right");
}


TEST(inputChecks, anUnknownKeywordIsRefusedWithTheKnownOnes)
{
    checkKeywords(parsed("hue 1; gloss 2;"), {"hue", "gloss", "base"});
    expectRefusal
    (
        {"Unknown entry glosss", "Expected: any of", "gloss", "hue", "constant/paint"},
        []{ checkKeywords(parsed("hue 1; glosss 2;"), {"hue", "gloss"}); }
    );
}


TEST(inputChecks, onlyPositiveFiniteNumbersPass)
{
    EXPECT_EQ(readPositive(parsed("layers 2;"), "layers"), 2);
    EXPECT_EQ(readPositiveOrDefault(parsed(""), "layers", 3), 3);
    EXPECT_EQ(readPositiveOrDefault(parsed("layers 2;"), "layers", 3), 2);
    for (const std::string bad : {"0", "-1"})
    {
        expectRefusal
        (
            {"Entry layers is", "Expected: some [m].", "constant/paint"},
            [&]{ readPositive(parsed("layers " + bad + ";"), "layers", "some [m]."); }
        );
    }
    for (const scalar bad : {std::nan(""), HUGE_VAL})
    {
        expectRefusal({"Entry layers is"}, [&]{ checkPositive(parsed(""), "layers", bad); });
    }
    expectRefusal({"layers", "constant/paint"}, []{ readPositive(parsed(""), "layers"); });
}


TEST(inputChecks, onlyNamesOfTheListPass)
{
    EXPECT_EQ(readChoice(colours, parsed("base blue;"), "base"), colour::blue);
    EXPECT_EQ(readChoice(colours, parsed(""), "base", colour::red), colour::red);
    EXPECT_EQ(readChoice(colours, parsed("base blue;"), "base", colour::red), colour::blue);
    expectRefusal
    (
        {"Entry base is green", "Expected: one of", "red", "blue", "constant/paint"},
        []{ readChoice(colours, parsed("base green;"), "base", colour::red); }
    );
}
