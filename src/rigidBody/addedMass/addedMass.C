// SPDX-License-Identifier: GPL-3.0-or-later

#include "addedMass.H"
#include "addedMassTensor.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"
#include "scalarMatrices.H"
#include "uniformDimensionedFields.H"

namespace Foam
{
namespace sixDoFSolvers
{
    defineTypeNameAndDebug(addedMass, 0);
    addToRunTimeSelectionTable(sixDoFSolver, addedMass, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Block of a matrix of blocks 3 x 3
tensor block(const SquareMatrix<scalar>& matrix, const label i, const label j)
{
    tensor result;
    for (label k = 0; k < 9; ++k)
    {
        result[k] = matrix(3*i + k/3, 3*j + k % 3);
    }
    return result;
}


vector readEstimate(const dictionary& dict, const word& name)
{
    const vector estimate(dict.get<vector>(name));
    if (cmptMin(estimate) < 0)
    {
        refuseEntry(dict, name, text("is ", estimate), "three values that are not negative.");
    }
    return estimate;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sixDoFSolvers::addedMass::addedMass
(
    const dictionary& dict,
    sixDoFRigidBodyMotion& body
)
:
    sixDoFSolver(dict, body),
    isGiven_(dict.found("addedMass") || dict.found("addedInertia")),
    addedMass_(isGiven_ ? readEstimate(dict, "addedMass") : vector(Zero)),
    addedInertia_(isGiven_ ? readEstimate(dict, "addedInertia") : vector(Zero))
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SquareMatrix<Foam::scalar> Foam::sixDoFSolvers::addedMass::estimate(const boolList& isFree) const
{
    if (isGiven_)
    {
        SquareMatrix<scalar> given(6, 6, Zero);
        for (direction d = 0; d < 3; ++d)
        {
            given(d, d) = addedMass_[d];
            given(3 + d, 3 + d) = addedInertia_[d];
        }
        return given;
    }

    auto* computed = body_.time().getObjectPtr<addedMassTensor>(addedMassTensor::registryName);
    if (!computed)
    {
        refuse
        (
            dict_,
            "Entries addedMass and addedInertia are not there, and this solver does not compute them",
            "both, or plungeFoam."
        );
    }
    computed->setFree(isFree);
    return computed->tensor();
}


Foam::vector Foam::sixDoFSolvers::addedMass::gravity() const
{
    const auto* g =
        body_.time().findObject<uniformDimensionedVectorField>("g");
    return g ? g->value() : vector(Zero);
}


Foam::Tuple2<Foam::tensor, Foam::vector>
Foam::sixDoFSolvers::addedMass::rotateFreely
(
    const tensor& Q,
    const vector& pi,
    const scalar deltaT
) const
{
    const scalar w[] =
        {0.784513610477560, 0.235573213359357, -1.17767998417887};
    const scalar middle = 1 - 2*(w[0] + w[1] + w[2]);

    Tuple2<tensor, vector> Qpi(Q, pi);
    for (const scalar part : {w[0], w[1], w[2], middle, w[2], w[1], w[0]})
    {
        Qpi = rotate(Qpi.first(), Qpi.second(), part*deltaT);
    }
    return Qpi;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sixDoFSolvers::addedMass::solve
(
    bool,
    const vector& fGlobal,
    const vector& tauGlobal,
    scalar deltaT,
    scalar
)
{
    const vector aLast(a());
    const vector tauLast(tau());

    // Force over mass and torque, with the restraints
    updateAcceleration(fGlobal, tauGlobal);

    // In body axes: accelerations, and what constraints leave of them
    const diagTensor& I = body_.momentOfInertia();
    const diagTensor rI(1/I.xx(), 1/I.yy(), 1/I.zz());
    const tensor free[2] = {Q().T() & tConstraints() & Q(), rConstraints()};
    const tensor inertia[2] = {body_.mass()*tensor::I, tensor::I & I};
    const vector unhindered[2] = {Q().T() & a(), rI & tau()};
    const vector last[2] = {Q().T() & aLast, rI & tauLast};

    boolList isFree(6);
    forAll(isFree, k)
    {
        vector axis(Zero);
        axis[k % 3] = 1;
        isFree[k] = mag(free[k/3] & axis) > SMALL;
    }
    const SquareMatrix<scalar> added(estimate(isFree));

    SquareMatrix<scalar> matrix(6, 6, Zero);
    scalarField x(6);
    for (label i = 0; i < 2; ++i)
    {
        vector source(inertia[i] & unhindered[i]);
        for (label j = 0; j < 2; ++j)
        {
            const tensor A(block(added, i, j));
            source += A & last[j];
            tensor M(free[i] & (i == j ? inertia[i] + A : A) & free[j]);
            if (i == j)
            {
                M += tensor::I - free[i];
            }
            for (label k = 0; k < 9; ++k)
            {
                matrix(3*i + k/3, 3*j + k % 3) = M[k];
            }
        }
        source = free[i] & source;
        std::copy(source.begin(), source.end(), x.begin() + 3*i);
    }
    LUsolve(matrix, x);

    a() = tConstraints() & (Q() & vector(x[0], x[1], x[2]));
    tau() = rConstraints() & (I & vector(x[3], x[4], x[5]));

    v() = tConstraints() & (v0() + aDamp()*deltaT*a());
    centreOfRotation() =
        centreOfRotation0()
      + deltaT*v()
      - 0.5*sqr(deltaT)*(tConstraints() & gravity());

    const Tuple2<tensor, vector> Qpi =
        rotateFreely
        (
            Q0(),
            rConstraints() & (pi0() + aDamp()*deltaT*tau()),
            deltaT
        );
    Q() = Qpi.first();
    pi() = rConstraints() & Qpi.second();
}

// ************************************************************************* //
