// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleVTK.H"

#include "foamVtkOutput.H"
#include "OSspecific.H"

#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const char* const seriesName = "particles.vtp";


//- One array with nCmpt values for each of n particles; put(i) writes those of the particle i
template<class Type, direction nCmpt, class Put>
void writeArray(vtk::formatter& format, const word& name, const std::size_t n, const Put& put)
{
    format.beginDataArray<Type, nCmpt>(name);
    format.writeSize(vtk::sizeofData<Type, nCmpt>(n));
    for (std::size_t i = 0; i < n; ++i)
    {
        put(i);
    }
    format.flush();
    format.endDataArray();
}


template<std::size_t dim>
void writeVectors(vtk::formatter& format, const word& name, const std::vector<std::array<double, dim>>& vectors)
{
    writeArray<float, 3>
    (
        format,
        name,
        vectors.size(),
        [&](const std::size_t i)
        {
            for (std::size_t d = 0; d < 3; ++d)
            {
                format.write(static_cast<float>(d < dim ? vectors[i][d] : 0));
            }
        }
    );
}


//- So that each particle is a cell, without which ParaView shows nothing
void writeVertices(vtk::formatter& format, const label n)
{
    format.tag(vtk::fileTag::VERTS);
    for (const bool ends : {false, true})
    {
        writeArray<label, 1>
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
    time_(runTime)
{
    mkDir(runTime.path()/"VTK");
    if (isFile(path(std::string(seriesName) + ".series")))
    {
        series_.load(path(seriesName), true, runTime.value());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::smoothedParticles::particleVTK::path(const std::string& name) const
{
    return time_.path()/"VTK"/fileName(name);
}


template<int dim>
void Foam::smoothedParticles::particleVTK::write(const particleState<dim>& state, const double rho0)
{
    const fileName file(path("particles_" + time_.timeName() + ".vtp"));
    const std::size_t n = state.size();

    std::ofstream os(file);
    autoPtr<vtk::formatter> formatter(vtk::outputOptions(vtk::formatType::INLINE_BASE64).newFormatter(os));
    vtk::formatter& format = formatter();

    format
        .xmlHeader()
        .xmlComment("time='" + time_.timeName() + "'")
        .beginVTKFile<vtk::fileTag::POLY_DATA>();
    format
        .beginFieldData()
        .writeTimeValue(time_.value())
        .endFieldData();
    format.tag
    (
        vtk::fileTag::PIECE,
        vtk::fileAttr::NUMBER_OF_POINTS, label(n),
        vtk::fileAttr::NUMBER_OF_VERTS, label(n)
    );

    format.tag(vtk::fileTag::POINTS);
    writeVectors(format, "Points", state.x);
    format.endTag(vtk::fileTag::POINTS);
    writeVertices(format, n);

    format.beginPointData();
    writeVectors(format, "U", state.v);
    writeArray<float, 1>
    (
        format, "p", n, [&](const std::size_t i){ format.write(static_cast<float>(state.pressure[i])); }
    );
    writeArray<float, 1>
    (
        format, "rho", n, [&](const std::size_t i){ format.write(static_cast<float>(rho0 + state.density[i])); }
    );
    writeArray<label, 1>
    (
        format, "wall", n, [&](const std::size_t i){ format.write(static_cast<label>(state.wall[i])); }
    );
    format.endPointData();

    format.endPiece();
    format.endTag(vtk::fileTag::POLY_DATA).endVTKFile();
    os.close();
    if (!os)
    {
        FatalErrorInFunction
            << "Cannot write " << file << exit(FatalError);
    }

    // Renamed, for a kill may come while it is written
    series_.append(time_.value(), file);
    const std::string part(std::string("part.") + seriesName);
    series_.write(path(part));
    mv(path(part + ".series"), path(std::string(seriesName) + ".series"));
}


template void Foam::smoothedParticles::particleVTK::write<2>(const particleState<2>&, double);
template void Foam::smoothedParticles::particleVTK::write<3>(const particleState<3>&, double);

// ************************************************************************* //
