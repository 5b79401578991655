// SPDX-License-Identifier: GPL-3.0-or-later
// Moments and consistency of the smoothing kernels.

#include <gtest/gtest.h>

#include "smoothingKernels.H"

#include <algorithm>
#include <array>
#include <cmath>

using namespace Foam::smoothedParticles;

namespace
{

//- On a lattice of spacing h/2: the error of sum V W = 1 and of sum V x dW/dx = -1, which makes gradients of linear fields exact
template<class Kernel>
std::array<double, 2> latticeErrors(int dim)
{
    constexpr double spacing = 0.5;
    constexpr int n = 4;
    double one = 0;
    double gradient = 0;
    for (int i = -n; i <= n; ++i)
    {
        for (int j = -n; j <= n; ++j)
        {
            for (int k = dim == 3 ? -n : 0; k <= (dim == 3 ? n : 0); ++k)
            {
                const double q = std::min(spacing*std::sqrt(double(i*i + j*j + k*k)), supportRatio);
                const double x = i*spacing;
                one += Kernel::template w<double>(q);
                gradient += x*x*Kernel::template f<double>(q);
            }
        }
    }
    const double scale = Kernel::normalisation(dim)*std::pow(spacing, dim);
    return {{scale*one - 1, scale*gradient + 1}};
}


//- Integral of alpha w(q) over the plane or space, at h = 1, by the midpoint rule
template<class Kernel>
double integral(int dim)
{
    constexpr int n = 200000;
    const double dq = supportRatio/n;
    double sum = 0;
    for (int k = 0; k < n; ++k)
    {
        const double q = (k + 0.5)*dq;
        sum += Kernel::template w<double>(q)*(dim == 2 ? 2*pi*q : 4*pi*q*q)*dq;
    }
    return Kernel::normalisation(dim)*sum;
}


template<class Kernel>
void checkKernel()
{
    for (const int dim : {2, 3})
    {
        EXPECT_NEAR(integral<Kernel>(dim), 1, 1e-9) << dim;
        const std::array<double, 2> errors = latticeErrors<Kernel>(dim);
        EXPECT_LT(std::abs(errors[0]), 2e-3) << dim;
        EXPECT_LT(std::abs(errors[1]), 2e-3) << dim;
    }

    // f is dw/dq/q, all end smoothly at the edge of the support
    for (double q = 0.05; q < supportRatio; q += 0.1)
    {
        const double step = 1e-5;
        const double slope =
            (Kernel::template w<double>(q + step) - Kernel::template w<double>(q - step))/(2*step);
        EXPECT_NEAR(Kernel::template f<double>(q), slope/q, 1e-8) << q;
        EXPECT_LT(Kernel::template f<double>(q), 0) << q;
    }
    EXPECT_EQ(Kernel::template w<double>(supportRatio), 0);
    EXPECT_EQ(Kernel::template f<double>(supportRatio), 0);
}

} // End anonymous namespace


TEST(SmoothingKernels, WendlandC2)
{
    checkKernel<WendlandC2>();
}


TEST(SmoothingKernels, WendlandC4)
{
    checkKernel<WendlandC4>();
}


TEST(SmoothingKernels, cubicSpline)
{
    checkKernel<cubicSpline>();
}
