// SPDX-License-Identifier: GPL-3.0-or-later
// The friction law against tabulated values and its own integral.

#include <gtest/gtest.h>

#include "frictionLaw.H"

#include <cmath>

using namespace Foam;

namespace
{

//- Mean of the local coefficient from the leading edge to Re, by its integral
double integral(const frictionLaw& law, const double Re)
{
    const int n = 200000;
    double sum = 0;
    for (int i = 0; i < n; ++i)
    {
        // Equal steps in sqrt(Re), in which a laminar layer's are equal drags
        const double low = Re*std::pow(double(i)/n, 2), high = Re*std::pow((i + 1.0)/n, 2);
        sum += law.local(0.5*(low + high))*(high - low);
    }
    return sum/Re;
}

} // End anonymous namespace


TEST(frictionLaw, meansAreThoseOfTheTable)
{
    // Prandtl and Schlichting's line, and Blasius'
    const double rows[][3] = {{1e6, 0.004471, 0.001328}, {1e7, 0.003004, 0.000420}, {1e8, 0.002128, 0.000133}};
    for (const auto& row : rows)
    {
        EXPECT_NEAR(frictionLaw::turbulentMean(row[0]), row[1], 6e-7);
        EXPECT_NEAR(frictionLaw::laminarMean(row[0]), row[2], 6e-7);
        EXPECT_DOUBLE_EQ(frictionLaw(0).mean(row[0]), frictionLaw::turbulentMean(row[0]));
        EXPECT_DOUBLE_EQ(frictionLaw(1e9).mean(row[0]), frictionLaw::laminarMean(row[0]));
    }
}


TEST(frictionLaw, laminarRunSavesWhatSchlichtingSays)
{
    // A = Re_tr (C_turbulent - C_laminar)
    const double rows[][2] = {{5e5, 1614}, {1e6, 3143}, {3e6, 8709}};
    for (const auto& row : rows)
    {
        const double Re = 1.637e7;
        EXPECT_NEAR((frictionLaw::turbulentMean(Re) - frictionLaw(row[0]).mean(Re))*Re, row[1], 1);
    }
}


TEST(frictionLaw, localCoefficientsAddUpToTheMean)
{
    EXPECT_NEAR(integral(frictionLaw(1e9), 1e5)/frictionLaw::laminarMean(1e5), 1, 1e-2);
    for (const double transition : {5e5, 3e6})
    {
        EXPECT_NEAR(integral(frictionLaw(transition), 1.6e7)/frictionLaw(transition).mean(1.6e7), 1, 1e-3);
    }
}


TEST(frictionLaw, layerThickensAtTransitionAndAlong)
{
    const frictionLaw law(5e5);
    EXPECT_NEAR(law.thickness(1e5), 5/std::sqrt(1e5), 1e-12);
    // Of a velocity profile of power 1/7: about 0.37 Re^-0.2
    EXPECT_NEAR(frictionLaw(0).thickness(1e7), 0.37*std::pow(1e7, -0.2), 0.1*0.37*std::pow(1e7, -0.2));
    double last = 0;
    for (double Re = 1e4; Re < 1e8; Re *= 1.1)
    {
        EXPECT_GT(law.thickness(Re)*Re, last);
        last = law.thickness(Re)*Re;
    }
}


TEST(frictionLaw, beginningIsFinite)
{
    for (const double transition : {0.0, 5e5})
    {
        const frictionLaw law(transition);
        for (const double Re : {0.0, 1e-6, 1.0, 1e3})
        {
            EXPECT_TRUE(std::isfinite(law.local(Re)) && law.local(Re) > 0);
            EXPECT_TRUE(std::isfinite(law.mean(Re)) && std::isfinite(law.thickness(Re)));
        }
    }
}
