// SPDX-License-Identifier: GPL-3.0-or-later

#include "modelledPart.H"

#include "inputChecks.H"
#include "mathematicalConstants.H"
#include "polyBoundaryMesh.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::modelledPart::partType> Foam::modelledPart::typeNames
({
    { partType::full, "full" },
    { partType::half, "half" },
    { partType::quarter, "quarter" },
    { partType::axisymmetric, "axisymmetric" },
    { partType::plane, "plane" },
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sectors in a circle. Between plane wedges a sector has the volume of a
//  polygon's, r^2 sin(angle)/2 of a circle's pi r^2.
scalar sectors(const polyBoundaryMesh& patches)
{
    for (const polyPatch& patch : patches)
    {
        if (isA<wedgePolyPatch>(patch))
        {
            const scalar cosHalf = refCast<const wedgePolyPatch>(patch).cosAngle();
            return constant::mathematical::twoPi/std::sin(2*std::acos(cosHalf));
        }
    }
    FatalErrorInFunction
        << "Entry model is axisymmetric, but the mesh has no patch of type wedge" << nl
        << "Expected: two of them." << exit(FatalError);
    return 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::modelledPart::modelledPart(const partType type)
:
    type_(type),
    count_(type == partType::half ? 2 : type == partType::quarter ? 4 : 1)
{}


Foam::modelledPart::modelledPart(const partType type, const polyBoundaryMesh& patches)
:
    modelledPart(type)
{
    if (type == partType::axisymmetric)
    {
        count_ = sectors(patches);
    }
}


Foam::modelledPart Foam::modelledPart::New(const dictionary& dict, const polyBoundaryMesh& patches)
{
    return modelledPart(readChoice(typeNames, dict, "model", partType::full), patches);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::bodyLoads Foam::modelledPart::whole(const bodyLoads& part) const
{
    if (type_ == partType::full || type_ == partType::plane)
    {
        return part;
    }
    // What the planes of symmetry leave of a force and of a moment
    const bool half = type_ == partType::half;
    const vector force(half ? count_ : 0, 0, count_);

    bodyLoads all;
    all.pressure = cmptMultiply(force, part.pressure);
    all.viscous = cmptMultiply(force, part.viscous);
    all.moment = vector(0, half ? count_*part.moment.y() : 0, 0);
    return all;
}

// ************************************************************************* //
