// SPDX-License-Identifier: GPL-3.0-or-later

#include "walls.H"

#include "DynamicList.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::PtrList<Foam::dictionary> Foam::smoothedParticles::readWalls(const dictionary& geometry)
{
    return geometry.found("walls") ? PtrList<dictionary>(geometry.lookup("walls")) : PtrList<dictionary>();
}


Foam::wordList Foam::smoothedParticles::readWallNames(const dictionary& geometry)
{
    DynamicList<word> names;
    for (const dictionary& wall : readWalls(geometry))
    {
        const word name(wall.get<word>("name"));
        if (names.found(name))
        {
            refuse(geometry, text("Entry walls: two walls have the name ", name), "different names.");
        }
        names.append(name);
    }
    return wordList(std::move(names));
}


Foam::PtrList<Foam::shape> Foam::smoothedParticles::readShapes(const dictionary& geometry, const shape::setting& where)
{
    const PtrList<dictionary> dicts(readWalls(geometry));
    PtrList<shape> shapes(dicts.size());
    forAll(shapes, i)
    {
        shapes.set(i, shape::New(dicts[i], where));
    }
    return shapes;
}

// ************************************************************************* //
