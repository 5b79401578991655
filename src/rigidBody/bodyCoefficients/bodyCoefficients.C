// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyCoefficients.H"

#include "diagTensor.H"
#include "inputChecks.H"
#include "tensor.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Is there a constraint that leaves one axis of rotation or none?
bool isRotationConstrained(const dictionary& coefficients)
{
    const dictionary constraints(coefficients.subOrEmptyDict("constraints"));
    for (const entry& e : constraints)
    {
        if (e.isDict())
        {
            const word type(e.dict().get<word>("sixDoFRigidBodyMotionConstraint"));
            if (type == "axis" || type == "orientation")
            {
                return true;
            }
        }
    }
    return false;
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
    if
    (
        (integrator == "Newmark" || integrator == "CrankNicolson")
     && !isRotationConstrained(coefficients)
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
