// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleVTK.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::smoothedParticles;

//- So that each particle is a cell, without which ParaView shows nothing
void writeVertices(vtk::formatter& format, const label n)
{
    format.tag(vtk::fileTag::VERTS);
    for (const bool ends : {false, true})
    {
        vtpSeries::writeArray<label, 1>
        (
            format,
            ends ? "offsets" : "connectivity",
            n,
            [&](const std::size_t i){ format.write(static_cast<label>(ends ? i + 1 : i)); }
        );
    }
    format.endTag(vtk::fileTag::VERTS);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothedParticles::particleVTK::particleVTK(const Time& runTime)
:
    series_(runTime, "particles")
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int dim>
void Foam::smoothedParticles::particleVTK::write(const particleState<dim>& state, const double rho0)
{
    const std::size_t n = state.size();
    series_.write
    (
        n, n, 0,
        [&](vtk::formatter& format)
        {
            format.tag(vtk::fileTag::POINTS);
            vtpSeries::writeVectors(format, "Points", n, [&](const std::size_t i){ return state.x[i]; });
            format.endTag(vtk::fileTag::POINTS);
            writeVertices(format, n);

            format.beginPointData();
            vtpSeries::writeVectors(format, "U", n, [&](const std::size_t i){ return state.v[i]; });
            vtpSeries::writeArray<float, 1>
            (
                format, "p", n, [&](const std::size_t i){ format.write(static_cast<float>(state.pressure[i])); }
            );
            vtpSeries::writeArray<float, 1>
            (
                format, "rho", n, [&](const std::size_t i){ format.write(static_cast<float>(rho0 + state.density[i])); }
            );
            vtpSeries::writeArray<label, 1>
            (
                format, "wall", n, [&](const std::size_t i){ format.write(static_cast<label>(state.wall[i])); }
            );
            if (!state.energy.empty())
            {
                vtpSeries::writeArray<float, 1>
                (
                    format, "energy", n, [&](const std::size_t i){ format.write(static_cast<float>(state.energy[i])); }
                );
                vtpSeries::writeArray<float, 1>
                (
                    format, "heat", n, [&](const std::size_t i){ format.write(static_cast<float>(state.heat[i])); }
                );
            }
            format.endPointData();
        }
    );
}


template void Foam::smoothedParticles::particleVTK::write<2>(const particleState<2>&, double);
template void Foam::smoothedParticles::particleVTK::write<3>(const particleState<3>&, double);

// ************************************************************************* //
