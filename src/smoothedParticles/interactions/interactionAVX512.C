// SPDX-License-Identifier: GPL-3.0-or-later
// The interaction loops for processors with AVX-512.

// Before any header, so that their inline functions may be inlined here
#pragma GCC target("avx512f,avx512dq,avx512vl,avx2,fma")
#pragma GCC optimize("no-math-errno", "no-trapping-math")
#define plungeAVX512

// Of g++ 12's own header of the instructions
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "interaction.H"
#include "particleShifting.H"
#include "smoothingKernels.H"

#include <algorithm>

namespace Foam
{
namespace smoothedParticles
{
namespace AVX512
{

#include "interactionLoop.H"

template struct chooseLoop<float, 2>;
template struct chooseLoop<float, 3>;
template struct chooseLoop<double, 2>;
template struct chooseLoop<double, 3>;

} // End namespace AVX512
} // End namespace smoothedParticles
} // End namespace Foam
