// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape.H"

#include "boxShape.H"
#include "FlatOutput.H"
#include "inputChecks.H"
#include "Switch.H"
#include "tankShape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(shape, 0);
    defineRunTimeSelectionTable(shape, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::shape> Foam::shape::New(const dictionary& dict, const setting& where)
{
    word type(dict.get<word>("type"));
    if (type == boxShape::typeName && !dict.lookupOrDefault<Switch>("solid", false))
    {
        type = tankShape::typeName;
    }
    const auto constructor = dictionaryConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        refuseEntry(dict, "type", "is " + type, text("one of ", flatOutput(dictionaryConstructorTablePtr_->sortedToc())));
    }
    return constructor()(dict, where);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::shape::touch(const point& centre, const scalar radius, touching& t) const
{
    const foot nearest(findNearest(centre, GREAT));
    t.depth = radius + nearest.depth;
    t.normal = nearest.normal;
    t.area = 0;
    return t.depth > 0;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::vector Foam::readVector(const dictionary& dict, const word& entry, const int dim)
{
    const vector v(dict.get<vector>(entry));
    if (dim == 2 && v.z() != 0)
    {
        refuseEntry(dict, entry, text("is ", v, " in a two-dimensional case"), "a third component of 0.");
    }
    return v;
}


Foam::boundBox Foam::readBox(const dictionary& dict, const int dim)
{
    const boundBox box(readVector(dict, "min", dim), readVector(dict, "max", dim));
    for (direction d = 0; d < dim; ++d)
    {
        if (!(box.min()[d] < box.max()[d]))
        {
            refuse
            (
                dict,
                text("Entries min and max are ", box.min(), " and ", box.max()),
                "min below max in each direction."
            );
        }
    }
    return box;
}


Foam::label Foam::faceOf(const word& face, const int dim, const dictionary& dict, const word& entry)
{
    static const wordList plane({"left", "right", "bottom", "top"});
    static const wordList space({"left", "right", "front", "back", "bottom", "top"});
    const wordList& faces = dim == 2 ? plane : space;
    const label i = faces.find(face);
    if (i < 0)
    {
        refuseEntry(dict, entry, text("has the face ", face), text("any of ", flatOutput(faces)));
    }
    return i;
}

// ************************************************************************* //
