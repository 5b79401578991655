// SPDX-License-Identifier: GPL-3.0-or-later
// The interaction loops for processors with AVX2.

// Before any header, so that their inline functions may be inlined here
#pragma GCC target("avx2,fma")
#pragma GCC optimize("no-math-errno", "no-trapping-math")
#define plungeAVX2

#include "interaction.H"
#include "particleShifting.H"
#include "smoothingKernels.H"

#include <algorithm>

namespace Foam
{
namespace smoothedParticles
{
namespace AVX2
{

#include "interactionLoop.H"

template struct chooseLoop<float, 2>;
template struct chooseLoop<float, 3>;
template struct chooseLoop<double, 2>;
template struct chooseLoop<double, 3>;

} // End namespace AVX2
} // End namespace smoothedParticles
} // End namespace Foam
