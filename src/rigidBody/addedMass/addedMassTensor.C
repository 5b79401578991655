// SPDX-License-Identifier: GPL-3.0-or-later

#include "addedMassTensor.H"
#include "fvc.H"
#include "fvm.H"
#include "inputChecks.H"
#include "profiling.H"

const Foam::word Foam::addedMassTensor::registryName("addedMass");

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::vectorField> Foam::addedMassTensor::unitAcceleration
(
    const label k,
    const pointField& x
) const
{
    vector axis(Zero);
    axis[k % 3] = 1;
    axis = body_.orientation() & axis;
    return k < 3 ? tmp<vectorField>::New(x.size(), axis) : axis ^ (x - body_.centreOfRotation());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::addedMassTensor::addedMassTensor(const fvMesh& mesh, const bodyMotion& body)
:
    IOdictionary
    (
        IOobject
        (
            registryName,
            mesh.time().timeName(),
            "uniform",
            mesh.time(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    body_(body),
    interval_(body.integrator().getOrDefault<label>("interval", 20)),
    tensor_(6, 6, Zero),
    isFree_(6, true),
    pressures_(6)
{
    if (interval_ < 1)
    {
        refuseEntry(body.integrator(), "interval", text("is ", interval_), "1 or more time steps.");
    }
    if (found("tensor"))
    {
        const scalarList values(get<scalarList>("tensor"));
        forAll(values, i)
        {
            tensor_(i/6, i % 6) = values[i];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::addedMassTensor::isWanted(const bodyMotion& body)
{
    return body.isMovedBy("addedMass") && !body.integrator().found("addedMass");
}



void Foam::addedMassTensor::solve
(
    const volScalarField& rho,
    const volScalarField& p,
    const wordList& types,
    const label nNonOrthogonal,
    const label reference
)
{
    addProfiling(addedMass, "added mass");

    const surfaceScalarField rRhof("rRhof", fvc::interpolate(1/rho));

    // Only the master moves the body, and knows its constraints
    Pstream::scatter(isFree_);

    for (label k = 0; k < 6; ++k)
    {
        if (!isFree_[k])
        {
            continue;
        }
        if (!pressures_.set(k))
        {
            pressures_.set
            (
                k,
                new volScalarField
                (
                    IOobject("addedMassPressure", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE, false),
                    mesh_,
                    dimensionedScalar(p.dimensions(), Zero),
                    body_.drivenTypes(types)
                )
            );
            mesh_.setFluxRequired(pressures_[k].name());
        }
        volScalarField& P = pressures_[k];
        for (const label patchi : body_.patches())
        {
            body_.drive(P, rRhof, patchi, unitAcceleration(k, mesh_.boundary()[patchi].Cf()));
        }
        for (label i = 0; i <= nNonOrthogonal; ++i)
        {
            fvScalarMatrix eqn(fvm::laplacian(rRhof, P));
            eqn.setReference(reference, 0);
            eqn.solve(mesh_.solver(p.name()));
        }
        for (label j = 0; j < 6; ++j)
        {
            scalar force = 0;
            for (const label patchi : body_.patches())
            {
                const fvPatch& patch = mesh_.boundary()[patchi];
                force += sum(P.boundaryField()[patchi]*(unitAcceleration(j, patch.Cf()) & patch.Sf()));
            }
            tensor_(j, k) = -returnReduce(force, sumOp<scalar>());
        }
    }

    // It is symmetric but for the errors of the solutions
    for (label j = 0; j < 6; ++j)
    {
        for (label k = 0; k < 6; ++k)
        {
            if (!isFree_[j] || !isFree_[k])
            {
                tensor_(j, k) = 0;
            }
            else if (k < j)
            {
                tensor_(j, k) = tensor_(k, j) = 0.5*(tensor_(j, k) + tensor_(k, j));
            }
        }
    }

    scalarList values(36);
    forAll(values, i)
    {
        values[i] = tensor_(i/6, i % 6);
    }
    set("tensor", values);
}

// ************************************************************************* //
