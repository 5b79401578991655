// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtpSeries.H"

#include "OSspecific.H"

#include <fstream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothedParticles::vtpSeries::vtpSeries(const Time& runTime, const word& name)
:
    time_(runTime),
    name_(name)
{
    mkDir(runTime.path()/"VTK");
    if (isFile(path(".vtp.series")))
    {
        series_.load(path(".vtp"), true, runTime.value());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::smoothedParticles::vtpSeries::path(const std::string& end) const
{
    return time_.path()/"VTK"/fileName(name_ + end);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::smoothedParticles::vtpSeries::write
(
    const label nPoints,
    const label nVerts,
    const label nPolys,
    const std::function<void(vtk::formatter&)>& piece
)
{
    const fileName file(path("_" + time_.timeName() + ".vtp"));
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
        vtk::fileAttr::NUMBER_OF_POINTS, nPoints,
        vtk::fileAttr::NUMBER_OF_VERTS, nVerts,
        vtk::fileAttr::NUMBER_OF_POLYS, nPolys
    );
    piece(format);
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
    series_.write(path(".vtp.part"));
    mv(path(".vtp.part.series"), path(".vtp.series"));
}

// ************************************************************************* //
