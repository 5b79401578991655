// SPDX-License-Identifier: GPL-3.0-or-later

#include "slenderProperties.H"

#include "inputChecks.H"
#include "mathematicalConstants.H"

#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::slenderBody;

const Enum<flowType> flowNames
({
    { flowType::attached, "attached" },
    { flowType::cavity, "cavity" },
    { flowType::automatic, "auto" },
});

const Enum<freedomType> freedomNames
({
    { freedomType::prescribed, "prescribed" },
    { freedomType::axial, "axial" },
    { freedomType::planar, "planar" },
    { freedomType::free, "free" },
});

//- Has friction?
const Enum<bool> boundaryLayerNames
({
    { true, "frictionLine" },
    { false, "none" },
});

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::slenderBody::slenderProperties::readTail(const dictionary& dict)
{
    checkKeywords(dict, {"volumeCoefficient", "aspectRatio", "position"});
    const scalar coefficient = readPositive(dict, "volumeCoefficient");
    const scalar ratio = readPositiveOrDefault(dict, "aspectRatio", 2);
    tail.position = dict.lookupOrDefault<scalar>("position", shape->length());
    const scalar arm = tail.position - centreFromNose.x();
    if (!(mag(arm) > 1e-3*shape->length()))
    {
        refuseEntry(dict, "position", text("is ", tail.position, " m, at the centre of mass"), "a place ahead of it or behind it.");
    }
    tail.area = coefficient*constant::mathematical::pi*sqr(shape->maxRadius())*shape->length()/mag(arm);
    // Helmbold (1942)
    tail.liftSlope = constant::mathematical::twoPi*ratio/(2 + Foam::sqrt(4 + sqr(ratio)));
    tail.chord = Foam::sqrt(tail.area/ratio);
}


void Foam::slenderBody::slenderProperties::readBody(const dictionary& dict, const fileName& caseDirectory)
{
    checkKeywords
    (
        dict,
        {
            "meridian", "mass", "momentOfInertia", "centreFromNose", "centreOfMass", "orientation", "velocity", "angularVelocity",
            "freedom", "heading", "tail"
        }
    );
    if (!shape)
    {
        fileName file(dict.get<fileName>("meridian"));
        try
        {
            shape = std::make_shared<meridian>(meridian::read(file.isAbsolute() ? file : caseDirectory/file));
        }
        catch (const std::invalid_argument& e)
        {
            refuse(dict, std::string("Entry meridian: ") + e.what(), "a meridian x, r [m] from the nose to the tail.");
        }
    }
    mass = readPositive(dict, "mass", "a positive mass [kg].");
    momentOfInertia = dict.get<vector>("momentOfInertia");
    if (!(cmptMin(momentOfInertia) > 0))
    {
        refuseEntry(dict, "momentOfInertia", text("is ", momentOfInertia), "three positive moments of inertia [kg m^2].");
    }
    centreFromNose = dict.get<vector>("centreFromNose");
    centreOfMass = dict.get<vector>("centreOfMass");
    orientation = dict.get<tensor>("orientation");
    if (!(mag((orientation & orientation.T()) - tensor::I) < 1e-3 && det(orientation) > 0))
    {
        refuseEntry(dict, "orientation", text("is ", orientation), "a rotation, with the body's axes as columns.");
    }
    velocity = dict.get<vector>("velocity");
    angularVelocity = dict.lookupOrDefault<vector>("angularVelocity", Zero);
    freedom = readChoice(freedomNames, dict, "freedom", freedomType::free);
    heading = dict.lookupOrDefault<vector>("heading", Zero);
    if (freedom == freedomType::axial)
    {
        if (!(mag(heading) > 0))
        {
            refuseEntry(dict, "heading", text("is ", heading), "the direction of the line that the body is free to move along.");
        }
        heading /= mag(heading);
        velocity = heading*(heading & velocity);
        angularVelocity = Zero;
    }
    if (dict.found("tail"))
    {
        readTail(dict.subDict("tail"));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slenderBody::slenderProperties::slenderProperties
(
    const dictionary& all,
    const vector& gravity,
    const fileName& caseDirectory,
    std::shared_ptr<const meridian> known
)
:
    dict(all),
    g(gravity),
    shape(known)
{
    checkKeywords
    (
        dict,
        {
            "FoamFile", "body", "liquid", "surfaceLevel", "flow", "boundaryLayer", "transitionReynolds", "crossFlow", "until",
            "outputs", "tolerance"
        }
    );
    readBody(dict.subDict("body"), caseDirectory);
    liquid = std::make_shared<slenderLiquid>(dict.subDict("liquid"), mag(g));
    surfaceLevel = dict.lookupOrDefault<scalar>("surfaceLevel", 0);
    flow = readChoice(flowNames, dict, "flow", flowType::automatic);
    hasFriction = readChoice(boundaryLayerNames, dict, "boundaryLayer", true);
    transitionReynolds = dict.lookupOrDefault<scalar>("transitionReynolds", 5e5);
    if (!(transitionReynolds >= 0))
    {
        refuseEntry(dict, "transitionReynolds", text("is ", transitionReynolds), "a Reynolds number; 0 for a layer that is turbulent throughout.");
    }
    hasCrossFlow = dict.lookupOrDefault<bool>("crossFlow", true);
    const dictionary& outputs = dict.subDict("outputs");
    checkKeywords(outputs, {"interval"});
    interval = readPositive(outputs, "interval", "a positive time, the longest step [s].");
    tolerance = readPositiveOrDefault(dict, "tolerance", 1e-8);
    if (tolerance > 1e-3)
    {
        refuseEntry(dict, "tolerance", text("is ", tolerance), "1e-3 or less.");
    }
}

// ************************************************************************* //
