// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleProperties.H"

#include "particleSetUp.H"
#include "smoothingKernels.H"
#include "walls.H"

#include "Enum.H"
#include "FlatOutput.H"
#include "fluidSelection.H"
#include "inputChecks.H"
#include "PtrList.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::smoothedParticles;

const Enum<kernelType> kernelNames
({
    { kernelType::WendlandC2, "WendlandC2" },
    { kernelType::WendlandC4, "WendlandC4" },
    { kernelType::cubicSpline, "cubicSpline" },
});

const Enum<pressureType> pressureNames
({
    { pressureType::fluid, "fluid" },
    { pressureType::solid, "solid" },
});

const Enum<viscosityType> viscosityNames
({
    { viscosityType::none, "none" },
    { viscosityType::laminar, "laminar" },
    { viscosityType::artificial, "artificial" },
    { viscosityType::Riemann, "Riemann" },
});

const Enum<diffusionType> diffusionNames
({
    { diffusionType::none, "none" },
    { diffusionType::Molteni, "Molteni" },
    { diffusionType::Fourtakas, "Fourtakas" },
    { diffusionType::Antuono, "Antuono" },
    { diffusionType::Riemann, "Riemann" },
});

const Enum<timeSteppingType> timeSteppingNames
({
    { timeSteppingType::Verlet, "Verlet" },
    { timeSteppingType::symplectic, "symplectic" },
});

const Enum<contactStiffness> stiffnessNames
({
    { contactStiffness::node, "node" },
    { contactStiffness::segment, "segment" },
});

//- Of rings, over the spacing: half of what the first have on a lattice
constexpr scalar leastRadiusRatio = 0.25;

//- noSlip?
const Enum<bool> wallNames
({
    { false, "slip" },
    { true, "noSlip" },
});

//- singlePrecision?
const Enum<bool> precisionNames
({
    { true, "single" },
    { false, "double" },
});


//- A coefficient that a choice needs, which is refused without that choice
scalar readCoefficient(const dictionary& dict, const word& entry, const bool needed, const char* choice)
{
    if (needed)
    {
        return readPositive(dict, entry);
    }
    if (dict.found(entry))
    {
        refuseEntry(dict, entry, "is given", text("no such entry, or ", choice, "."));
    }
    return 0;
}


vector readGravity(const Time& runTime)
{
    return uniformDimensionedVectorField
    (
        IOobject("g", runTime.constant(), runTime, IOobject::MUST_READ, IOobject::NO_WRITE, false)
    ).value();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::smoothedParticles::particleProperties::readLiquid(const dictionary& dict)
{
    wordHashSet known({"gamma"});
    interactionModel& m = common_.interaction;
    m.gamma = dict.lookupOrDefault<scalar>("gamma", 7);
    if (dict.found("fluid") || dict.found("composition"))
    {
        known += titan::fluidSelection::keywords;
        checkKeywords(dict, known);
        const titan::fluidSelection liquid(dict);
        if (liquid.ph() != titan::phase::liquid)
        {
            refuse(dict, text("Entry fluid or composition is ", liquid.name(), ", a gas"), "a liquid.");
        }
        common_.rho0 = liquid.value(titan::property::density, dict);
        m.mu = liquid.value(titan::property::viscosity, dict);
        liquidSoundSpeed_ =
            liquid.has(titan::property::soundSpeed) ? liquid.value(titan::property::soundSpeed, dict) : 0;
        liquid.print(Info, {titan::property::density, titan::property::viscosity, titan::property::soundSpeed});
        return;
    }

    known.insert("rho");
    known.insert("mu");
    checkKeywords(dict, known);
    common_.rho0 = readPositive(dict, "rho");
    m.mu = dict.found("mu") || m.viscosity == viscosityType::laminar ? readPositive(dict, "mu") : 0;
}


void Foam::smoothedParticles::particleProperties::readSoundSpeed(const dictionary& dict)
{
    const wordList choices({"c0", "maxSpeed", "depth", "bulkModulus", "liquid"});
    wordHashSet known(choices);
    known.insert("factor");
    checkKeywords(dict, known);
    wordList given;
    for (const word& choice : choices)
    {
        if (dict.found(choice))
        {
            given.append(choice);
        }
    }
    if (given.size() != 1)
    {
        refuse
        (
            dict,
            text("Entries given: ", flatOutput(given)),
            "one of them: c0 [m/s]; maxSpeed, the highest speed that is expected [m/s], and optionally factor, c0"
            " over it (10); depth of the liquid [m]; bulkModulus [Pa]; or liquid yes, the sound speed of a fluid of"
            " the library."
        );
    }
    interactionModel& m = common_.interaction;
    if (given[0] != "maxSpeed")
    {
        readCoefficient(dict, "factor", false, "maxSpeed");
    }
    if (given[0] == "c0")
    {
        m.c0 = readPositive(dict, "c0");
    }
    else if (given[0] == "depth")
    {
        if (!(mag(g_) > 0))
        {
            refuseEntry(dict, "depth", "is given, but there is no gravity", "gravity, or another choice.");
        }
        m.c0 = Foam::sqrt(100*mag(g_)*readPositive(dict, "depth"));
    }
    else if (given[0] == "bulkModulus")
    {
        m.c0 = Foam::sqrt(readPositive(dict, "bulkModulus")/common_.rho0);
    }
    else if (given[0] == "liquid")
    {
        if (!dict.get<bool>("liquid") || !(liquidSoundSpeed_ > 0))
        {
            refuseEntry
            (
                dict,
                "liquid",
                "is " + dict.get<word>("liquid")
              + (liquidSoundSpeed_ > 0 ? "" : ", but the speed of sound of the liquid is not known"),
                "yes, and a fluid or composition in the entry liquid of particleProperties."
            );
        }
        m.c0 = liquidSoundSpeed_;
    }
    else
    {
        expectedSpeed_ = readPositive(dict, "maxSpeed");
        m.c0 = readPositiveOrDefault(dict, "factor", 10)*expectedSpeed_;
    }
}


void Foam::smoothedParticles::particleProperties::readSmoothingLength()
{
    if (!dict_.found("neighbours"))
    {
        common_.interaction.h =
            common_.spacing
           *readPositiveOrDefault(dict_, "smoothingLength", 1.5);
        return;
    }
    if (dict_.found("smoothingLength"))
    {
        refuseEntry(dict_, "neighbours", "is given, and smoothingLength too", "one of them.");
    }
    const label n = dict_.get<label>("neighbours");
    if (n < 10 || n > 500)
    {
        refuseEntry(dict_, "neighbours", text("is ", n), "10 to 500.");
    }
    const scalar ratio = smoothingLengthOf(n, dimensions_);
    if (ratio < 1)
    {
        refuseEntry
        (
            dict_,
            "neighbours",
            text("is ", n, ", by which the smoothing length is ", ratio, " spacings"),
            "so many that it is a spacing or more: 33 in three dimensions, 12 in two."
        );
    }
    common_.interaction.h = ratio*common_.spacing;
}


void Foam::smoothedParticles::particleProperties::readAxis()
{
    interactionModel& m = common_.interaction;
    m.axisymmetric = dict_.lookupOrDefault<bool>("axisymmetric", false);
    if (!m.axisymmetric)
    {
        return;
    }
    m.leastRadius = leastRadiusRatio*common_.spacing;
    common_.symmetry.push_back({0, 0, 1});
    const auto refuseIf = [&](const bool found, const std::string& what, const char* expected)
    {
        if (found)
        {
            refuseEntry(dict_, "axisymmetric", "is given, but " + what, expected);
        }
    };
    refuseIf(dimensions_ != 2, "dimensions is 3", "2: the axis is x = 0.");
    refuseIf(g_.x() != 0, "the gravity of constant/g has a component across the axis", "gravity along y.");
    refuseIf(dict_.found("contact"), "there is contact", "walls of particles.");
    refuseIf
    (
        m.viscosity != viscosityType::none && m.viscosity != viscosityType::artificial,
        "viscosity is " + viscosityNames[m.viscosity],
        "none or artificial: the others leave out what a ring's own curvature does."
    );
    refuseIf(m.diffusion == diffusionType::none, "densityDiffusion is none", "one: the sums of rings do not keep the energy to round-off.");
}


void Foam::smoothedParticles::particleProperties::readSymmetry()
{
    if (!dict_.found("symmetry"))
    {
        return;
    }
    for (const dictionary& dict : PtrList<dictionary>(dict_.lookup("symmetry")))
    {
        checkKeywords(dict, wordHashSet({"point", "normal"}));
        const vector p(dict.get<vector>("point"));
        const vector n(dict.get<vector>("normal"));
        direction axis = 0;
        for (direction d = 1; d < dimensions_; ++d)
        {
            axis = mag(n[d]) > mag(n[axis]) ? d : axis;
        }
        if (!(mag(n[axis]) > 0) || mag(n - n[axis]*vector(axis == 0, axis == 1, axis == 2)) > 0)
        {
            refuseEntry
            (
                dict,
                "normal",
                text("is ", n),
                text
                (
                    "a direction along a coordinate", (dimensions_ == 2 ? " of the plane" : ""), ", into the fluid."
                )
            );
        }
        common_.symmetry.push_back({axis, p[axis], n[axis] > 0 ? 1 : -1});
    }
}


void Foam::smoothedParticles::particleProperties::readAbsorption()
{
    if (!dict_.found("absorption"))
    {
        return;
    }
    const dictionary& dict = dict_.subDict("absorption");
    checkKeywords(dict, wordHashSet({"min", "max", "thickness", "faces", "surface"}));
    absorbingLayer& layer = common_.absorption;
    layer.thickness = readPositive(dict, "thickness");
    layer.surface = dict.get<scalar>("surface");
    const vector low(dict.get<vector>("min"));
    const vector high(dict.get<vector>("max"));
    for (direction d = 0; d < dimensions_; ++d)
    {
        layer.min[d] = low[d];
        layer.max[d] = high[d];
        if (!(low[d] < high[d]))
        {
            refuse(dict, text("Entries min and max are ", low, " and ", high), "min below max in each direction.");
        }
    }
    for (const word& face : dict.get<wordList>("faces"))
    {
        layer.absorbs[faceOf(face, dimensions_, dict, "faces")] = true;
    }
}


void Foam::smoothedParticles::particleProperties::readContact(const fileName& caseDirectory)
{
    if (!dict_.found("contact"))
    {
        return;
    }
    const dictionary& dict = dict_.subDict("contact");
    checkKeywords(dict, wordHashSet({"stiffness", "factor", "bulkModulus", "thickness", "maxDepth"}));
    if (common_.interaction.noSlip)
    {
        refuseEntry(dict_, "walls", "is noSlip, but there is contact", "slip: contact has no friction.");
    }
    penaltyContact& contact = common_.contact;
    contact.stiffness = readChoice(stiffnessNames, dict, "stiffness");
    contact.factor = readPositive(dict, "factor");
    const bool segment = contact.stiffness == contactStiffness::segment;
    contact.bulkModulus = readCoefficient(dict, "bulkModulus", segment, "stiffness segment");
    contact.thickness = readCoefficient(dict, "thickness", segment, "stiffness segment");
    if (dict.found("maxDepth"))
    {
        contact.maxDepth = common_.spacing*readPositive(dict, "maxDepth");
    }
    const shape::setting where(shapesOf(caseDirectory));
    for (const dictionary& wall : readWalls(geometry()))
    {
        contact.walls.emplace_back(shape::New(wall, where), common_.spacing);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothedParticles::particleProperties::particleProperties(const Time& runTime)
:
    dict_
    (
        IOobject
        (
            "particleProperties",
            runTime.constant(),
            runTime,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    ),
    g_(readGravity(runTime)),
    dimensions_(dict_.get<label>("dimensions"))
{
    checkKeywords
    (
        dict_,
        wordHashSet
        ({
            "FoamFile", "dimensions", "kernel", "smoothingLength", "viscosity", "alpha", "densityDiffusion", "delta",
            "walls", "precision", "timeStepping", "Courant", "liquid", "speedOfSound", "geometry", "bodies", "symmetry", "axisymmetric",
            "absorption", "contact", "momentum", "beta", "acousticDamper", "wallTension", "outputs", "neighbours", "shifting", "energy",
            "until"
        })
    );
    if (dimensions_ != 2 && dimensions_ != 3)
    {
        refuseEntry(dict_, "dimensions", text("is ", dimensions_), "2 or 3.");
    }
    if (dimensions_ == 2 && g_.z() != 0)
    {
        refuseEntry(dict_, "dimensions", "is 2, but the gravity of constant/g has a component along z", "gravity in the plane of x and y.");
    }

    common_.spacing = readSpacing(geometry());
    common_.timeStepping = readChoice(timeSteppingNames, dict_, "timeStepping", timeSteppingType::Verlet);
    common_.Courant = readPositiveOrDefault
    (
        dict_,
        "Courant",
        common_.timeStepping == timeSteppingType::Verlet ? 0.5 : 0.2
    );
    common_.singlePrecision = readChoice(precisionNames, dict_, "precision", true);

    interactionModel& m = common_.interaction;
    m.kernel = readChoice(kernelNames, dict_, "kernel", kernelType::WendlandC2);
    readSmoothingLength();
    m.pressure = readChoice(pressureNames, dict_, "momentum", pressureType::fluid);
    m.viscosity = readChoice(viscosityNames, dict_, "viscosity");
    const bool artificial = m.viscosity == viscosityType::artificial;
    if (dict_.found("beta"))
    {
        m.beta = readCoefficient(dict_, "beta", artificial, "viscosity artificial");
    }
    // Quadratic bulk viscosity may do without the linear one
    if (dict_.found("alpha") || !(m.beta > 0))
    {
        m.alpha = readCoefficient(dict_, "alpha", artificial, "viscosity artificial");
    }
    m.diffusion = readChoice(diffusionNames, dict_, "densityDiffusion");
    m.delta = readCoefficient
    (
        dict_,
        "delta",
        m.diffusion != diffusionType::none && m.diffusion != diffusionType::Riemann,
        "densityDiffusion Molteni, Fourtakas or Antuono"
    );
    m.acousticDamper = dict_.found("acousticDamper") ? readPositive(dict_, "acousticDamper") : 0;
    if (dict_.found("shifting"))
    {
        const dictionary& shifting = dict_.subDict("shifting");
        checkKeywords(shifting, wordHashSet({"coefficient"}));
        common_.shifting = readPositiveOrDefault(shifting, "coefficient", 2);
    }
    common_.wallTension = dict_.found("wallTension") ? readPositive(dict_, "wallTension") : 0;
    common_.energy = dict_.lookupOrDefault<bool>("energy", false);
    m.noSlip = readChoice(wallNames, dict_, "walls");
    readAxis();
    readLiquid(dict_.subDict("liquid"));
    readSoundSpeed(dict_.subDict("speedOfSound"));
    readSymmetry();
    readAbsorption();
    readContact(runTime.path());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::shape::setting Foam::smoothedParticles::particleProperties::shapesOf(const fileName& caseDirectory) const
{
    return {int(dimensions_), caseDirectory, supportRatio*common_.interaction.h};
}


Foam::modelledPart Foam::smoothedParticles::particleProperties::modelled() const
{
    bool across[3] = {};
    for (const symmetryPlane& plane : common_.symmetry)
    {
        across[plane.axis] = true;
    }
    return modelledPart
    (
        !across[1] ? modelledPart::partType::full
      : across[0] ? modelledPart::partType::quarter
      : modelledPart::partType::half
    );
}


template<int dim>
Foam::smoothedParticles::particleFlowModel<dim> Foam::smoothedParticles::particleProperties::model() const
{
    particleFlowModel<dim> result;
    result.interaction = common_.interaction;
    for (int d = 0; d < 3; ++d)
    {
        result.interaction.g[d] = g_[d];
    }
    result.spacing = common_.spacing;
    result.rho0 = common_.rho0;
    result.timeStepping = common_.timeStepping;
    result.Courant = common_.Courant;
    result.symmetry = common_.symmetry;
    result.absorption = common_.absorption;
    result.wallTension = common_.wallTension;
    result.shifting = common_.shifting;
    result.energy = common_.energy;
    result.contact = common_.contact;
    result.singlePrecision = common_.singlePrecision;
    return result;
}


void Foam::smoothedParticles::particleProperties::print(Ostream& os) const
{
    const interactionModel& m = common_.interaction;
    os  << "Method: " << dimensions_ << " dimensions, " << (m.axisymmetric ? "axisymmetric, " : "") << kernelNames[m.kernel] << ", momentum " << pressureNames[m.pressure]
        << ", viscosity " << viscosityNames[m.viscosity] << ", density diffusion " << diffusionNames[m.diffusion] << ", walls "
        << wallNames[m.noSlip] << ", " << precisionNames[common_.singlePrecision] << " precision, "
        << timeSteppingNames[common_.timeStepping] << " steps at Courant number " << common_.Courant << nl
        << "Lengths: spacing " << common_.spacing << " m, smoothing length " << m.h << " m, "
        << neighboursOnLattice(m.h/common_.spacing, dimensions_) << " neighbours in the support on the lattice" << nl
        << "Liquid: density " << common_.rho0 << " kg/m3, viscosity "
        << (m.viscosity == viscosityType::laminar ? m.mu : scalar(0)) << " Pa s, gamma " << m.gamma << nl
        << "Speed of sound: c0 = " << m.c0 << " m/s, k0 = rho c0^2/gamma = " << common_.rho0*sqr(m.c0)/m.gamma
        << " Pa; a tenth of c0 is " << boundOnSpeed() << " m/s" << endl;
    if (m.acousticDamper > 0)
    {
        os  << "Acoustic damper: a bulk viscosity of " << m.acousticDamper << " rho h c0" << endl;
    }
    if (common_.wallTension > 0)
    {
        os  << "Wall tension: walls hold the liquid up to " << common_.wallTension << " Pa below zero" << endl;
    }
    if (common_.shifting > 0)
    {
        os  << "Shifting: coefficient " << common_.shifting << endl;
    }
    if (common_.contact.isOn())
    {
        os  << "Contact: springs by " << stiffnessNames[common_.contact.stiffness] << ", factor " << common_.contact.factor
            << "; walls have no particles" << endl;
    }
    if (expectedSpeed_ > boundOnSpeed()*(1 + SMALL))
    {
        WarningInFunction
            << "The flow is expected to reach " << expectedSpeed_ << " m/s: c0 is below ten times that." << endl;
    }
}


void Foam::smoothedParticles::particleProperties::printScene(Ostream& os, const UList<string>& notes) const
{
    const interactionModel& m = common_.interaction;
    os  << "Scene" << nl
        << "    models      : particles of the liquid alone, weakly compressible, viscosity " << viscosityNames[m.viscosity]
        << ", walls " << wallNames[m.noSlip] << nl
        << "    Note: There is no gas: nothing cushions an impact, and cavities are empty." << nl
        << "    Note: "
        << (
               m.noSlip
             ? "Friction on the walls is that of what particles of this spacing resolve of a boundary layer"
             : "The walls slip: there is no boundary layer and no friction, which plungeFoam has"
           )
        << '.' << nl
        << "    Note: The liquid is as soft as c0 = " << m.c0 << " m/s: pressures of an impact ring with that speed of sound." << nl;
    for (const string& note : notes)
    {
        os  << "    Note: " << note.c_str() << nl;
    }
    os  << endl;
}


template Foam::smoothedParticles::particleFlowModel<2> Foam::smoothedParticles::particleProperties::model<2>() const;
template Foam::smoothedParticles::particleFlowModel<3> Foam::smoothedParticles::particleProperties::model<3>() const;

// ************************************************************************* //
