// SPDX-License-Identifier: GPL-3.0-or-later

#include "diveTables.H"

#include "inputChecks.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slenderBody::diveTables::diveTables(const Time& time, const slenderProperties& properties)
:
    properties_(properties),
    trajectory_(time, "trajectory", properties.g),
    extent_(time, "extent", "extent", "time_s,low_m,high_m"),
    energy_
    (
        time,
        "energy",
        "energy",
        "time_s,kinetic_J,potential_J,inertia_J,buoyancy_J,friction_J,form_J,crossFlow_J,tail_J,imbalance_J"
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slenderBody::diveTables::write(const slenderDive& dive)
{
    const slenderModel& model = dive.model();
    const slenderModel::instant& now = dive.now();
    const scalar level = properties_.surfaceLevel;
    trajectory_.write
    (
        dive.time(), model.bodyStateOf(dive.state(), now), model.loadsOf(now), properties_.mass, -now.wet.lowest,
        modelledPart(modelledPart::partType::full)
    );
    extent_ << dive.time() << now.wet.lowest + level << now.wet.highest + level;
    extent_.endLine();
    energy_ << dive.time() << model.kineticEnergy(now) << model.potentialEnergy(now);
    for (int i = 0; i < slenderModel::nForces; ++i)
    {
        energy_ << dive.state()[13 + i];
    }
    energy_ << dive.imbalance();
    energy_.endLine();
}


void Foam::slenderBody::diveTables::printScene(Ostream& os, const slenderProperties& properties, const slenderModel& model)
{
    const meridian& body = *properties.shape;
    const slenderLiquid& liquid = *properties.liquid;
    const scalar slenderness = 2*body.maxRadius()/body.length();
    os  << "Body: " << body.length() << " m long, " << 2*body.maxRadius() << " m wide, " << body.volume() << " m3, centre of volume "
        << body.centre() << " m aft of the nose, wetted area " << body.area() << " m2" << nl
        << "Added mass of the immersed body over that of the displaced liquid: along the axis " << model.addedMassAlong()
        << ", across it " << model.addedMassAcross() << nl
        << "Liquid: density " << liquid.density(0) << " kg/m3, viscosity " << liquid.viscosity(0) << " Pa s"
        << (liquid.isStratified() ? " at the surface" : "") << nl << nl;

    os  << "Scene" << nl
        << "    models      : slender body in six degrees of freedom, added mass by strips, "
        << (properties.hasFriction ? "friction line" : "no friction") << ", flow behind the shoulder "
        << (model.hasCavity() ? "leaves the body: a cavity" : "attached") << nl
        << "    Note: The flow behind the shoulder is taken to be "
        << (model.hasCavity() ? text("a cavity, from ", model.shoulder(), " m aft of the nose") : std::string("attached")).c_str() << ": "
        << model.rule().c_str() << '.' << nl;
    if (!model.hasCavity() && properties.flow == flowType::automatic && liquid.viscosity(0) > 0 && liquid.surfaceTension() > 0)
    {
        const scalar limit = 0.1*liquid.surfaceTension()/liquid.viscosity(0);
        if (mag(properties.velocity) > limit)
        {
            os  << "    Note: Smooth spheres draw air in above " << limit << " m/s here (Duez and others 2007); -flow cavity says what that"
                << " would do." << nl;
        }
    }
    os  << "    Note: There is no gas, whose drag is its density's share of the liquid's, and no waves." << nl;
    if (slenderness > 0.25)
    {
        os  << "    Note: The body is " << slenderness << " as wide as long: strips, form factor and cross-flow drag are for slender ones, a"
            << " quarter or less." << nl;
    }
    const scalar U = mag(properties.velocity);
    const scalar climb = U > 0 ? properties.velocity.z()/U : 0;
    if
    (
        (properties.freedom == freedomType::planar || properties.freedom == freedomType::free)
     && properties.centreOfMass.z() > properties.surfaceLevel && climb < 0 && climb > -1 + 1e-9
    )
    {
        const scalar specificGravity = properties.mass/(body.volume()*liquid.density(0));
        os  << "    Note: The body comes down at an angle of " << radToDeg(std::asin(-climb)) << " deg. What of it is wetted from below has no force"
            << " across the axis here: its entry turns it too little, and there is no ricochet, which spheres of this density have below "
            << 18/std::sqrt(specificGravity) << " deg (Johnson and Reid 1975)." << nl;
    }
    if (properties.centreOfMass.z() > properties.surfaceLevel && (properties.orientation & vector(1, 0, 0)).z() > 0)
    {
        os  << "    Note: The tail is below the nose: the force of an entry is that of a nose, and a tail that enters first has none." << nl;
    }
    const scalar Re = liquid.viscosity(0) > 0 ? liquid.density(0)*U*body.length()/liquid.viscosity(0) : GREAT;
    if (properties.hasFriction && U > 0 && Re < 1000)
    {
        os  << "    Note: The Reynolds number is " << Re << ": below 1000 there is no boundary layer, and the friction of one is far from the drag"
            << " of a liquid that creeps." << nl;
    }
    if (properties.tail.area > 0)
    {
        os  << "    Note: The tail, " << properties.tail.area << " m2 a pair, lifts and rubs; its added mass is left out." << nl;
    }
    if (body.faceRadius() > 0)
    {
        os  << "    Note: The nose is flat: the impulse of its contact is right, the peak of the force has no meaning." << nl;
    }
    os  << endl;
}


void Foam::slenderBody::diveTables::printEnd(Ostream& os, const slenderDive& dive)
{
    if (dive.event().size())
    {
        os  << "Event " << dive.event().c_str() << " at " << dive.time() << " s: the run ends here" << nl;
    }
    os  << dive.steps() << " steps to " << dive.time() << " s; what the energy budget lacks: " << dive.imbalance() << " J" << nl << nl;
    const scalar closes = dive.cavityBegan() + dive.model().closureTime();
    if (dive.cavityBegan() >= 0 && closes < dive.time())
    {
        os  << "Run" << nl << "    Note: The cavity closed at " << closes << " s, 2.285 sqrt(R/g) after its shoulder had passed the surface"
            << " (Glasheen and McMahon 1996, discs); the flow is taken to be attached from then on." << nl << nl;
    }
    os  << flush;
}

// ************************************************************************* //
