// SPDX-License-Identifier: GPL-3.0-or-later
// Moments and consistency of the smoothing kernels.

#include <gtest/gtest.h>

#include "smoothingKernels.H"

#include <cmath>

using namespace Foam::smoothedParticles;

namespace
{

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
