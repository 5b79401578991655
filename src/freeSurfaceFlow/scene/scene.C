// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene.H"
#include "bodyMotion.H"
#include "dynamicOversetFvMesh.H"
#include "inputChecks.H"
#include "motionSolver.H"
#include "staticFvMesh.H"
#include "Switch.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

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

//- How it moves, by dynamicFvMesh in constant/dynamicMeshDict
word motionOf(const fvMesh& mesh)
{
    if (isA<dynamicOversetFvMesh>(mesh))
    {
        return "overset";
    }
    return isA<staticFvMesh>(mesh) || !isA<dynamicFvMesh>(mesh) ? "off" : "on";
}


//- What else than OpenFOAM's sixDoFRigidBodyMotion moves a body; empty without one
word otherBody(const fvMesh& mesh)
{
    for (const motionSolver* solver : mesh.lookupClass<motionSolver>())
    {
        if (solver->type().find("rigidBodyMotion") == 0)
        {
            return solver->type();
        }
    }
    return word::null;
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

//- The controls of the volume fraction, whose phase has no name yet
const dictionary& alphaControls(const fvMesh& mesh)
{
    for (const entry& e : mesh.solutionDict().subOrEmptyDict("solvers"))
    {
        if (e.isDict() && e.keyword().substr(0, 5) == "alpha")
        {
            return mesh.solutionDict().subDict("solvers").subDict(e.keyword());
        }
    }
    return dictionary::null;
}


//- interFoam's scheme, or interIsoFoam's where the case has controls that are
//  read by isoAdvection alone, or lacks the one that MULES cannot do without
word interfaceOf(const dictionary& dict, const fvMesh& mesh)
{
    if (dict.found("interface"))
    {
        return dict.get<word>("interface");
    }

    const dictionary& controls = alphaControls(mesh);
    for
    (
        const word name :
        {
            "isoFaceTol", "surfCellTol", "gradAlphaNormal", "nAlphaBounds",
            "snapTol", "clip", "reconstructionScheme"
        }
    )
    {
        if (controls.found(name))
        {
            return "isoAdvector";
        }
    }
    return
        controls.found("nAlphaSubCycles") && !controls.found("nAlphaCorr")
      ? "isoAdvector"
      : "MULES";
}


scene::boundaryLayerType boundaryLayerOf(const dictionary& dict)
{
    if (dict.isDict("boundaryLayer"))
    {
        refuseEntry
        (
            dict,
            "boundaryLayer",
            "is a dictionary",
            text
            (
                "one of ", scene::boundaryLayerTypeNames.sortedToc(),
                "; what a friction line takes is in frictionLineCoeffs."
            )
        );
    }
    return readChoice(scene::boundaryLayerTypeNames, dict, "boundaryLayer", scene::boundaryLayerType::unstated);
}

} // End anonymous namespace


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
    hasBody_(bodyMotion::found(mesh)),
    otherBody_(otherBody(mesh)),
    meshMotion_(motionOf(mesh)),
    gravity_(dict_.lookupOrDefault<Switch>("gravity", true)),
    surfaceTension_(dict_.lookupOrDefault<Switch>("surfaceTension", true)),
    boundaryLayer_(boundaryLayerOf(dict_)),
    simulationType_(simulationType(mesh)),
    interface_(interfaceOf(dict_, mesh)),
    initialFlow_(readChoice(initialFlowTypeNames, dict_, "initialFlow", initialFlowType::fields)),
    fringe_(readChoice(fringeTypeNames, dict_, "fringe", fringeType::interpolated))
{
    for (const word entry : {"body", "meshMotion", "compressibility"})
    {
        if (dict_.found(entry))
        {
            refuseEntry
            (
                dict_,
                entry,
                "is given",
                "no such entry: the body and the motion of the mesh follow from constant/dynamicMeshDict, and both fluids are"
                " incompressible."
            );
        }
    }
    checkKeywords
    (
        dict_,
        {
            "FoamFile", "gravity", "surfaceTension", "boundaryLayer", "frictionLineCoeffs", "interface", "initialFlow",
            "fringe", "ambientPressure", "reference"
        }
    );
    if
    (
        boundaryLayer_ != boundaryLayerType::unstated
     && turbulence() != (boundaryLayer_ == boundaryLayerType::wallFunction)
    )
    {
        refuseEntry
        (
            dict_,
            "boundaryLayer",
            text
            (
                "is ", boundaryLayerTypeNames[boundaryLayer_],
                ", but simulationType in constant/turbulenceProperties is ", simulationType_
            ),
            text
            (
                "simulationType ", (turbulence() ? "laminar" : "RAS or LES"), ", or boundaryLayer ",
                (turbulence() ? "wallFunction." : "laminar, frictionLine or none.")
            )
        );
    }
    transitionReynolds();

    if (conservesFringe() && meshMotion_ != "overset")
    {
        refuseEntry(dict_, "fringe", "is conserved, but the mesh is not overset", "no entry fringe.");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::scene::transitionReynolds() const
{
    if (dict_.found("frictionLineCoeffs") && !dict_.isDict("frictionLineCoeffs"))
    {
        refuseEntry
        (
            dict_,
            "frictionLineCoeffs",
            "is no dictionary",
            "{ transitionReynolds 5e5; patches (body); }, each optional."
        );
    }
    const dictionary coeffs(dict_.subOrEmptyDict("frictionLineCoeffs"));
    checkKeywords(coeffs, {"transitionReynolds", "patches"});
    const scalar Re = coeffs.lookupOrDefault<scalar>("transitionReynolds", 5e5);
    if (!(Re >= 0))
    {
        refuseEntry
        (
            dict_.subDict("frictionLineCoeffs"),
            "transitionReynolds",
            text("is ", Re),
            "0, for a layer that is turbulent throughout, or a positive number."
        );
    }
    return Re;
}


void Foam::scene::print(Ostream& os) const
{
    auto onOff = [](const bool b) { return b ? "on" : "off"; };

    os  << "body " << (hasBody_ ? "sixDoF" : otherBody_.empty() ? "none" : (otherBody_ + ", whose loads are not reported").c_str())
        << ", mesh motion " << meshMotion_
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
    if (meshMotion_ == "overset")
    {
        os  << ", fringe " << fringeTypeNames[fringe_];
    }
    os  << ", both fluids incompressible";
}

// ************************************************************************* //
