// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyCoefficients.H"

#include "diagTensor.H"
#include "inputChecks.H"
#include "point.H"
#include "pointConstraint.H"
#include "tensor.H"

#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- One of OpenFOAM's that has a centre of rotation, and what it takes of that centre's translation
struct heldCentre
{
    const dictionary& dict;
    point centre;
    pointConstraint held;
};


//- All constraints: as OpenFOAM puts them together, in the axes of space the translation and in those of the body the rotation
struct allConstraints
{
    const dictionary dict;
    const point centreOfMass;
    const tensor orientation;
    std::vector<heldCentre> centres;
    pointConstraint translation, rotation;

    explicit allConstraints(const dictionary& coefficients)
    :
        dict(coefficients.subOrEmptyDict("constraints")),
        centreOfMass(coefficients.lookupOrDefault("initialCentreOfMass", coefficients.get<vector>("centreOfMass"))),
        orientation
        (
            coefficients.lookupOrDefault("initialOrientation", coefficients.lookupOrDefault("orientation", tensor::I))
        )
    {
        for (const entry& e : dict)
        {
            if (!e.isDict())
            {
                continue;
            }
            const word type(e.dict().get<word>("sixDoFRigidBodyMotionConstraint"));
            if (type == "axis" || type == "orientation")
            {
                rotation.combine(type == "axis" ? leaves(2, e.dict().get<vector>("axis")) : leaves(3, Zero));
            }
            else if (type == "point" || type == "line" || type == "plane")
            {
                const pointConstraint held
                (
                    type == "point" ? leaves(3, Zero)
                  : type == "line" ? leaves(2, e.dict().get<vector>("direction"))
                  : leaves(1, e.dict().get<vector>("normal"))
                );
                translation.combine(held);
                centres.push_back({e.dict(), e.dict().lookupOrDefault("centreOfRotation", centreOfMass), held});
            }
        }
    }

    //- So many directions are taken: with one a normal, with two what they leave
    static pointConstraint leaves(const label n, const vector& direction)
    {
        return pointConstraint(Tuple2<label, vector>(n, normalised(direction)));
    }

    //- Does the body turn about one axis alone? In its own axes rotation.second()
    bool turnAboutAxis() const
    {
        return rotation.first() == 2;
    }
};


//- OpenFOAM's motion has one centre of rotation, that of the constraint which is listed last. Refuse another one, unless it means
//  the same there
void checkCentres(const allConstraints& constraints)
{
    const vector axis(constraints.orientation & constraints.rotation.second());
    for (const heldCentre& c : constraints.centres)
    {
        const heldCentre& last = constraints.centres.back();
        const vector apart(c.centre - last.centre);
        // What turns about an axis stays as far along it
        const bool isAlike =
            constraints.rotation.first() == 3
         || mag(apart) <= 1e-6*(mag(c.centre) + mag(last.centre))
         || (
                constraints.turnAboutAxis()
             && (mag(apart ^ axis) < 1e-6*mag(apart) || (c.held.first() == 1 && mag(c.held.second() ^ axis) < 1e-3))
            );
        if (!isAlike)
        {
            refuseEntry
            (
                c.dict,
                "centreOfRotation",
                text("is ", c.centre, ", and that of ", last.dict.dictName(), ' ', last.centre),
                "the same in all constraints (the centre of mass, unless given): OpenFOAM's motion has one, that of the last."
            );
        }
    }
}


//- OpenFOAM's own integrators leave out what couples translation and rotation about another point than the centre of mass, and the
//  products of inertia. Refuse constraints that need them
void checkCouplings(const dictionary& coefficients, const allConstraints& constraints)
{
    if (constraints.rotation.first() == 3)
    {
        return;
    }
    const vector axis(constraints.rotation.second());
    const bool aboutAxis = constraints.turnAboutAxis();
    const vector arm(constraints.centres.empty() ? vector(Zero) : constraints.centreOfMass - constraints.centres.back().centre);
    // Does a turn move the centre of mass in a direction in which the body slides?
    const tensor free(constraints.translation.constraintTransformation());
    const scalar near = 1e-6*(mag(constraints.centreOfMass) + mag(arm));
    bool slides = false;
    for (const vector& turn : {vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)})
    {
        const vector about(aboutAxis ? constraints.orientation & axis : turn);
        slides = slides || mag(free & (about ^ arm)) > near;
    }

    // As OpenFOAM has it, and as it is
    const diagTensor own(coefficients.get<diagTensor>("momentOfInertia"));
    const scalar mass = coefficients.get<scalar>("mass");
    const auto about = [&](const vector& r){ return mass*(tensor::I*magSqr(r) - sqr(r)); };
    const tensor used(tensor::I & (own + diag(about(arm))));
    const tensor exact(own + about(constraints.orientation.T() & arm));
    const scalar small = 1e-6*mag(exact);
    const bool isRight =
        aboutAxis
      ? mag(axis & (exact - used) & axis) < small && mag((used & axis) ^ axis) < small
      : mag(exact - used) < small;
    if (slides || !isRight)
    {
        const dictionary& solver = coefficients.subDict("solver");
        refuseEntry
        (
            solver,
            "type",
            text
            (
                "is ", solver.get<word>("type"), ", which leaves out ",
                slides
              ? "how translation and rotation are coupled where the centre of rotation is not the centre of mass"
              : "the products of inertia about the axis, or the centre of rotation, that the constraints give"
            ),
            "addedMass, which has them."
        );
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::checkBodyCoefficients(const dictionary& coefficients)
{
    readPositive(coefficients, "mass", "a positive mass [kg].");

    const diagTensor I(coefficients.get<diagTensor>("momentOfInertia"));
    if (!(min(min(I.xx(), I.yy()), I.zz()) > 0))
    {
        refuseEntry(coefficients, "momentOfInertia", text("is ", I), "three positive moments of inertia [kg m^2].");
    }

    // Room for a rotation that is written with few digits
    const tensor Q(coefficients.lookupOrDefault("orientation", tensor::I));
    if (!(mag((Q & Q.T()) - tensor::I) < 1e-3 && det(Q) > 0))
    {
        refuseEntry(coefficients, "orientation", text("is ", Q), "a rotation, with the body's axes as columns.");
    }

    const scalar damping =
        coefficients.lookupOrDefault<scalar>("accelerationDamping", 1);
    if (damping != 1)
    {
        WarningInFunction
            << "accelerationDamping " << damping << " in "
            << coefficients.name()
            << " multiplies the body's acceleration: its trajectory is wrong"
            << " by that factor. Use 1." << endl;
    }

    const word integrator(coefficients.subDict("solver").get<word>("type"));
    for (const word entry : {"constraints", "restraints"})
    {
        if (integrator == "prescribed" && coefficients.subOrEmptyDict(entry).size())
        {
            refuseEntry
            (
                coefficients,
                entry,
                "is given, but solver prescribed keeps the velocity and the spin of the start",
                text("no ", entry, ", or another solver.")
            );
        }
    }
    for (const entry& e : coefficients.subOrEmptyDict("constraints"))
    {
        // OpenFOAM takes it as it is
        if (e.isDict() && e.dict().get<word>("sixDoFRigidBodyMotionConstraint") == "plane")
        {
            const vector normal(e.dict().get<vector>("normal"));
            if (mag(mag(normal) - 1) > 1e-3)
            {
                refuseEntry(e.dict(), "normal", text("is ", normal), "a vector of length 1.");
            }
        }
    }
    const allConstraints constraints(coefficients);
    checkCentres(constraints);
    if (integrator == "symplectic" || integrator == "Newmark" || integrator == "CrankNicolson")
    {
        checkCouplings(coefficients, constraints);
    }
    if
    (
        (integrator == "Newmark" || integrator == "CrankNicolson")
     && constraints.rotation.first() == 0
    )
    {
        WarningInFunction
            << "solver " << integrator << " in " << coefficients.name()
            << " leaves the gyroscopic moment out: a body that turns about"
            << " more than one axis does not keep its angular momentum. Use"
            << " symplectic or addedMass." << endl;
    }
}


bool Foam::hasLaggingRestraints(const dictionary& coefficients)
{
    const word integrator(coefficients.subDict("solver").get<word>("type"));
    return (integrator == "Newmark" || integrator == "CrankNicolson") && coefficients.subOrEmptyDict("restraints").size();
}

// ************************************************************************* //
