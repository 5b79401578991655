// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a body's path: its lines by hand, of a half model and of a whole body.

#include <gtest/gtest.h>

#include "bodyTrajectory.H"

#include "Time.H"

#include <fstream>
#include <sstream>

using namespace Foam;

namespace
{

//- The numbers of the last line of a new table after one line was written
std::vector<double> lineOf(const modelledPart& model, bodyTrajectory::line& result)
{
    bodyState s;
    s.centreOfMass = point(1, 2, 3);
    // The forward axis is straight up, the third axis along -x
    s.orientation = tensor(0, 0, -1, 0, 1, 0, 1, 0, 0);
    s.velocity = vector(3, 0, 4);
    s.omega = vector(0.1, 0.2, 0.3);
    s.acceleration = vector(-1, 0.5, -9.80665);

    bodyLoads loads;
    loads.pressure = vector(10, 20, 30);
    loads.viscous = vector(1, 2, 3);
    loads.moment = vector(4, 5, 6);

    {
        const autoPtr<Time> time(Time::New());
        bodyTrajectory table(time(), "dive", vector(0, 0, -2));
        EXPECT_EQ(table.up(), vector(0, 0, 1));
        result = table.write(0.25, s, loads, 7, 0.125, model);
    }

    std::ifstream file("postProcessing/dive/0/trajectory.csv");
    std::string header, text;
    EXPECT_TRUE(std::getline(file, header) && std::getline(file, text));
    EXPECT_EQ(header.substr(0, 52), "time_s,penetration_m,speed_m_s,deceleration_m_s2,dec");
    EXPECT_FALSE(std::getline(file, header));

    std::vector<double> numbers;
    std::istringstream fields(text);
    for (std::string field; std::getline(fields, field, ',');)
    {
        numbers.push_back(std::stod(field));
    }
    return numbers;
}


void expectLine(const modelledPart& model, const std::vector<double>& loads)
{
    std::vector<double> expected
    ({
        0.25, 0.125, 5, 9.80665, 1, 1, 2, 3, 3, 0, 4, -1, 0.5, -9.80665,
        4, 0, -3, -9.80665, 0.5, 1, 90, 0.3, 0.2, -0.1
    });
    expected.insert(expected.end(), loads.begin(), loads.end());

    bodyTrajectory::line line;
    const std::vector<double> written(lineOf(model, line));
    ASSERT_EQ(written.size(), expected.size());
    for (std::size_t i = 0; i < written.size(); ++i)
    {
        EXPECT_NEAR(written[i], expected[i], 1e-10) << "column " << i;
    }
    EXPECT_EQ(line.penetration, 0.125);
    EXPECT_EQ(line.speed, 5);
    EXPECT_EQ(line.deceleration, 9.80665);
}

} // End anonymous namespace


TEST(bodyTrajectory, wholeBody)
{
    expectLine(modelledPart(modelledPart::partType::full), {10, 20, 30, 1, 2, 3, 0, 0, -14, 4, 5, 6});
}


TEST(bodyTrajectory, halfModelIsReportedAsTheWholeBody)
{
    expectLine(modelledPart(modelledPart::partType::half), {20, 0, 60, 2, 0, 6, 0, 0, -28, 0, 10, 0});
}


TEST(bodyTrajectory, quarterIsReportedAsTheWholeBody)
{
    expectLine(modelledPart(modelledPart::partType::quarter), {0, 0, 120, 0, 0, 12, 0, 0, -56, 0, 0, 0});
}
