// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyVTK.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothedParticles::bodyVTK::bodyVTK
(
    const Time& runTime,
    const word& name,
    const shape& body,
    const bodyState& start
)
:
    series_(runTime, name)
{
    shape::polygons outside(body.outline());
    points_.transfer(outside.points);
    for (point& p : points_)
    {
        p = start.orientation.T() & (p - start.centreOfMass);
    }
    faces_.transfer(outside.faces);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::smoothedParticles::bodyVTK::reach(const bodyState& now, const vector& direction) const
{
    return (now.centreOfMass & direction) + max(points_ & (now.orientation.T() & direction));
}


void Foam::smoothedParticles::bodyVTK::write(const bodyState& now)
{
    label nCorners = 0;
    for (const face& f : faces_)
    {
        nCorners += f.size();
    }
    series_.write
    (
        points_.size(), 0, faces_.size(),
        [&](vtk::formatter& format)
        {
            format.tag(vtk::fileTag::POINTS);
            vtpSeries::writeVectors
            (
                format,
                "Points",
                points_.size(),
                [&](const label i){ return point(now.centreOfMass + (now.orientation & points_[i])); }
            );
            format.endTag(vtk::fileTag::POINTS);

            format.tag(vtk::fileTag::POLYS);
            format.beginDataArray<label>("connectivity");
            format.writeSize(vtk::sizeofData<label>(nCorners));
            for (const face& f : faces_)
            {
                vtk::writeList(format, f);
            }
            format.flush();
            format.endDataArray();
            label end = 0;
            vtpSeries::writeArray<label, 1>
            (
                format, "offsets", faces_.size(), [&](const label i){ format.write(end += faces_[i].size()); }
            );
            format.endTag(vtk::fileTag::POLYS);
        }
    );
}

// ************************************************************************* //
