// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene.H"
#include "bodyMotion.H"
#include "dynamicOversetFvMesh.H"
#include "staticFvMesh.H"
#include "Switch.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::scene::bodyType> Foam::scene::bodyTypeNames
({
    { bodyType::none, "none" },
    { bodyType::sixDoF, "sixDoF" },
});

const Foam::Enum<Foam::scene::motionType> Foam::scene::motionTypeNames
({
    { motionType::none, "none" },
    { motionType::motion, "motion" },
    { motionType::overset, "overset" },
});

const Foam::Enum<Foam::scene::initialFlowType>
Foam::scene::initialFlowTypeNames
({
    { initialFlowType::fields, "fields" },
    { initialFlowType::potential, "potential" },
});

const Foam::Enum<Foam::scene::fringeType> Foam::scene::fringeTypeNames
({
    { fringeType::interpolated, "interpolated" },
    { fringeType::conserved, "conserved" },
});

const Foam::Enum<Foam::scene::boundaryLayerType>
Foam::scene::boundaryLayerTypeNames
({
    { boundaryLayerType::laminar, "laminar" },
    { boundaryLayerType::wallFunction, "wallFunction" },
    { boundaryLayerType::frictionLine, "frictionLine" },
    { boundaryLayerType::none, "none" },
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

scene::motionType motionOf(const fvMesh& mesh)
{
    if (isA<dynamicOversetFvMesh>(mesh))
    {
        return scene::motionType::overset;
    }
    return
        isA<staticFvMesh>(mesh) || !isA<dynamicFvMesh>(mesh)
      ? scene::motionType::none
      : scene::motionType::motion;
}


word simulationType(const fvMesh& mesh)
{
    const word name(turbulenceModel::propertiesName);
    const IOdictionary dict
    (
        IOobject
        (
            name,
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    return dict.get<word>("simulationType");
}

scene::boundaryLayerType boundaryLayerOf(const dictionary& dict)
{
    if (dict.isDict("boundaryLayer"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry boundaryLayer is a dictionary" << nl
            << "Expected: one of "
            << scene::boundaryLayerTypeNames.sortedToc()
            << "; what a friction line takes is in frictionLineCoeffs."
            << exit(FatalIOError);
    }
    return scene::boundaryLayerTypeNames.lookupOrDefault
    (
        "boundaryLayer",
        dict,
        scene::boundaryLayerType::unstated
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::scene::checkKeywords() const
{
    const wordHashSet known
    ({
        "FoamFile", "body", "meshMotion", "compressibility", "gravity",
        "surfaceTension", "boundaryLayer", "frictionLineCoeffs", "interface",
        "initialFlow", "fringe", "ambientPressure", "reference"
    });

    for (const entry& e : dict_)
    {
        if (!known.found(e.keyword()))
        {
            FatalIOErrorInFunction(dict_)
                << "Unknown entry " << e.keyword() << nl
                << "Expected: any of " << known.sortedToc()
                << exit(FatalIOError);
        }
    }
}


template<class Type>
void Foam::scene::checkAgrees
(
    const word& entry,
    const Type& asked,
    const Type& present,
    const char* where
) const
{
    if (asked != present)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry " << entry << " is " << asked << ", but " << where
            << " makes it " << present << nl
            << "Expected: the two to agree." << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::scene::scene(const fvMesh& mesh)
:
    dict_
    (
        IOobject
        (
            "sceneProperties",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        )
    ),
    body_(bodyMotion::found(mesh) ? bodyType::sixDoF : bodyType::none),
    meshMotion_(motionOf(mesh)),
    gravity_(dict_.lookupOrDefault<Switch>("gravity", true)),
    surfaceTension_(dict_.lookupOrDefault<Switch>("surfaceTension", true)),
    boundaryLayer_(boundaryLayerOf(dict_)),
    simulationType_(simulationType(mesh)),
    interface_(dict_.lookupOrDefault<word>("interface", "MULES")),
    initialFlow_
    (
        initialFlowTypeNames.lookupOrDefault
        (
            "initialFlow",
            dict_,
            initialFlowType::fields
        )
    ),
    fringe_
    (
        fringeTypeNames.lookupOrDefault
        (
            "fringe",
            dict_,
            fringeType::interpolated
        )
    )
{
    checkKeywords();

    checkAgrees
    (
        "body",
        bodyTypeNames[bodyTypeNames.lookupOrDefault("body", dict_, body_)],
        bodyTypeNames[body_],
        "the motion solver of constant/dynamicMeshDict"
    );
    checkAgrees
    (
        "meshMotion",
        motionTypeNames
        [
            motionTypeNames.lookupOrDefault("meshMotion", dict_, meshMotion_)
        ],
        motionTypeNames[meshMotion_],
        "dynamicFvMesh in constant/dynamicMeshDict"
    );
    if
    (
        boundaryLayer_ != boundaryLayerType::unstated
     && turbulence() != (boundaryLayer_ == boundaryLayerType::wallFunction)
    )
    {
        FatalIOErrorInFunction(dict_)
            << "Entry boundaryLayer is "
            << boundaryLayerTypeNames[boundaryLayer_]
            << ", but simulationType in constant/turbulenceProperties is "
            << simulationType_ << nl
            << "Expected: simulationType "
            << (turbulence() ? "laminar" : "RAS or LES")
            << ", or boundaryLayer "
            << (turbulence() ? "wallFunction." : "laminar, frictionLine or none.")
            << exit(FatalIOError);
    }
    transitionReynolds();

    if (conservesFringe() && meshMotion_ != motionType::overset)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry fringe is conserved, but the mesh is not overset" << nl
            << "Expected: no entry fringe." << exit(FatalIOError);
    }

    const word compressibility
    (
        dict_.lookupOrDefault<word>("compressibility", "none")
    );
    if (compressibility != "none")
    {
        FatalIOErrorInFunction(dict_)
            << "Entry compressibility is " << compressibility << nl
            << "Expected: none, the only choice so far."
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::scene::transitionReynolds() const
{
    if (dict_.found("frictionLineCoeffs") && !dict_.isDict("frictionLineCoeffs"))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry frictionLineCoeffs is no dictionary" << nl
            << "Expected: { transitionReynolds 5e5; patches (body); }, each"
            << " optional." << exit(FatalIOError);
    }
    const dictionary coeffs(dict_.subOrEmptyDict("frictionLineCoeffs"));
    for (const entry& e : coeffs)
    {
        if (e.keyword() != "transitionReynolds" && e.keyword() != "patches")
        {
            FatalIOErrorInFunction(dict_.subDict("frictionLineCoeffs"))
                << "Unknown entry " << e.keyword() << nl
                << "Expected: transitionReynolds or patches."
                << exit(FatalIOError);
        }
    }
    const scalar Re = coeffs.lookupOrDefault<scalar>("transitionReynolds", 5e5);
    if (!(Re >= 0))
    {
        FatalIOErrorInFunction(dict_.subDict("frictionLineCoeffs"))
            << "Entry transitionReynolds is " << Re << nl
            << "Expected: 0, for a layer that is turbulent throughout, or a"
            << " positive number." << exit(FatalIOError);
    }
    return Re;
}


void Foam::scene::print(Ostream& os) const
{
    auto onOff = [](const bool b) { return b ? "on" : "off"; };

    os  << "body " << bodyTypeNames[body_]
        << ", mesh motion " << motionTypeNames[meshMotion_]
        << ", interface " << interface_
        << ", gravity " << onOff(gravity_)
        << ", surface tension " << onOff(surfaceTension_)
        << ", boundary layer "
        << (
               boundaryLayer_ == boundaryLayerType::unstated
             ? "not stated"
             : boundaryLayerTypeNames[boundaryLayer_].c_str()
           );
    if (turbulence())
    {
        os  << ", turbulence " << simulationType_;
    }
    os  << ", initial flow " << initialFlowTypeNames[initialFlow_];
    if (meshMotion_ == motionType::overset)
    {
        os  << ", fringe " << fringeTypeNames[fringe_];
    }
    os  << ", both fluids incompressible";
}

// ************************************************************************* //
