// SPDX-License-Identifier: GPL-3.0-or-later

#include "addedMass.H"
#include "addedMassTensor.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyHistory.H"
#include "bodyInertia.H"
#include "inputChecks.H"
#include "scalarMatrices.H"
#include "Tuple2.H"

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

typedef SquareMatrix<scalar> matrix;

//- Of blocks 3 x 3
matrix blocks(const tensor& xx, const tensor& xy, const tensor& yx, const tensor& yy)
{
    const tensor* all[] = {&xx, &xy, &yx, &yy};
    matrix result(6, 6, Zero);
    for (label block = 0; block < 4; ++block)
    {
        for (label k = 0; k < 9; ++k)
        {
            result(3*(block/2) + k/3, 3*(block % 2) + k % 3) = (*all[block])[k];
        }
    }
    return result;
}


scalarField joined(const vector& a, const vector& b)
{
    scalarField result(6);
    std::copy(a.begin(), a.end(), result.begin());
    std::copy(b.begin(), b.end(), result.begin() + 3);
    return result;
}


vector first(const scalarField& x)
{
    return vector(x[0], x[1], x[2]);
}


vector second(const scalarField& x)
{
    return vector(x[3], x[4], x[5]);
}


scalarField times(const matrix& A, const scalarField& x)
{
    scalarField result(6, Zero);
    for (label i = 0; i < 6; ++i)
    {
        for (label j = 0; j < 6; ++j)
        {
            result[i] += A(i, j)*x[j];
        }
    }
    return result;
}


scalarField unit(const label k)
{
    scalarField result(6, Zero);
    result[k] = 1;
    return result;
}


//- x of A x = b within the freedom that a projection leaves
scalarField solved(const matrix& A, const scalarField& b, const matrix& free)
{
    matrix system(free*A*free);
    for (label i = 0; i < 6; ++i)
    {
        for (label j = 0; j < 6; ++j)
        {
            system(i, j) += (i == j) - free(i, j);
        }
    }
    scalarField x(times(free, b));
    LUsolve(system, x);
    return x;
}


//- crossing(a) & b = a ^ b
tensor crossing(const vector& a)
{
    return tensor(0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0);
}


//- By an angle about the vector's direction [rad]
tensor rotation(const vector& angle)
{
    const scalar a = mag(angle);
    if (!(a > 0))
    {
        return tensor::I;
    }
    const tensor n(crossing(angle/a));
    return tensor::I + std::sin(a)*n + 2*sqr(std::sin(0.5*a))*(n & n);
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
    addedInertia_(isGiven_ ? readEstimate(dict, "addedInertia") : vector(Zero)),
    learned_(6, 6, Zero)
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


Foam::vector Foam::sixDoFSolvers::addedMass::arm() const
{
    return body_.orientation().T() & body_.momentArm();
}


Foam::symmTensor Foam::sixDoFSolvers::addedMass::inertia() const
{
    return centralInertia(body_) + steiner(body_.mass(), arm());
}


bool Foam::sixDoFSolvers::addedMass::tumbles() const
{
    return mag(rConstraints() - tensor::I) < SMALL && mag(tConstraints()) > SMALL && magSqr(arm()) > VSMALL;
}


Foam::scalarField Foam::sixDoFSolvers::addedMass::loads(const vector& fGlobal, const vector& tauGlobal)
{
    // Force over mass and torque, with the restraints
    updateAcceleration(fGlobal, tauGlobal);

    const vector omega(inv(body_.momentOfInertia()) & pi());
    const vector force(body_.mass()*((Q().T() & a()) - (omega ^ (omega ^ arm()))));
    return joined(force, tumbles() || history() ? tau() - (omega ^ (inertia() & omega)) : tau());
}


Foam::Tuple2<Foam::tensor, Foam::vector>
Foam::sixDoFSolvers::addedMass::turned(const vector& omega, const scalar deltaT) const
{
    if (mag(rConstraints() - tensor::I) > SMALL || tumbles())
    {
        return {Q0() & rotation(deltaT*omega), omega};
    }

    const scalar w[] =
        {0.784513610477560, 0.235573213359357, -1.17767998417887};
    const scalar middle = 1 - 2*(w[0] + w[1] + w[2]);

    const symmTensor I(inertia());
    const bool isDiagonal = mag(I.xy()) + mag(I.xz()) + mag(I.yz()) < SMALL*tr(I);
    const vector principal(isDiagonal ? vector(I.xx(), I.yy(), I.zz()) : eigenValues(I));
    // Rows are the principal axes, right-handed
    tensor axes(isDiagonal ? tensor::I : eigenVectors(I, principal));
    if (det(axes) < 0)
    {
        axes = -axes;
    }

    tensor Q(Q0() & axes.T());
    vector L(cmptMultiply(principal, axes & omega));
    const auto about = [&](const direction axis, const scalar time)
    {
        vector angle(Zero);
        angle[axis] = time*L[axis]/principal[axis];
        const tensor R(rotation(angle));
        L = L & R;
        Q = Q & R;
    };
    for (const scalar part : {w[0], w[1], w[2], middle, w[2], w[1], w[0]})
    {
        about(0, 0.5*part*deltaT);
        about(1, 0.5*part*deltaT);
        about(2, part*deltaT);
        about(1, 0.5*part*deltaT);
        about(0, 0.5*part*deltaT);
    }
    return {Q & axes, axes.T() & vector(cmptDivide(L, principal))};
}


Foam::bodyHistory* Foam::sixDoFSolvers::addedMass::history() const
{
    return body_.time().getObjectPtr<bodyHistory>(bodyHistory::registryName);
}


void Foam::sixDoFSolvers::addedMass::forget()
{
    learned_ = matrix(6, 6, Zero);
    loadsBefore_.clear();
}


void Foam::sixDoFSolvers::addedMass::correctChange
(
    const SquareMatrix<scalar>& M,
    const SquareMatrix<scalar>& estimated,
    const SquareMatrix<scalar>& free,
    const scalarField& now
)
{
    if (loadsBefore_.size())
    {
        const scalarField difference(change_ - changeBefore_);
        const scalarField weight(times(M, difference));
        const scalar size = sumProd(difference, weight);
        if (size > 1e-20*sumProd(change_, times(M, change_)))
        {
            const scalarField missed(loadsBefore_ - now - times(estimated + learned_, difference));
            for (label k = 0; k < 36; ++k)
            {
                learned_(k/6, k % 6) += missed[k/6]*weight[k % 6]/size;
            }
        }
    }
    loadsBefore_ = now;
    changeBefore_ = change_;
    change_ += solved(M + estimated + learned_, now - times(M, change_), free);
}


void Foam::sixDoFSolvers::addedMass::solveBackward
(
    const bool firstIter,
    bodyHistory& history,
    const SquareMatrix<scalar>& M,
    const SquareMatrix<scalar>& estimated,
    const SquareMatrix<scalar>& free,
    const scalarField& last,
    const scalarField& now,
    const scalar deltaT
)
{
    if (firstIter)
    {
        forget();
        const bodyHistory::step& before = history.last();

        // Loads of the end of the step, and what they give it, on a line through the last two. Before its first step a flow has no pressure
        const scalar ahead = before.number > 1 ? deltaT/before.deltaT : 0;
        const scalarField acceleration(last + ahead*(last - before.acceleration));
        change_ = solved(M + estimated, now + ahead*(now - before.loads) + times(estimated, acceleration), free);
        history.now().loads = now;
        history.now().acceleration = last;
    }
    else
    {
        correctChange(M, estimated, free, now);
    }

    const bodyHistory::step& before = history.last();
    const scalar b = history.weight(deltaT);
    const diagTensor& I = body_.momentOfInertia();
    bodyHistory::step& s = history.now();
    // In the first step it is the velocity of the end, which is that of the wall to the flow
    const auto meanOf = [&](const vector& end, const vector& lastMean)
    {
        return vector((end + b*lastMean)/(1 + b));
    };

    const vector omega0(inv(I) & pi0());
    const vector omega
    (
        rConstraints() & (omega0 + deltaT/(1 + b)*(aDamp()*second(change_) + b*before.spinChange))
    );
    s.spinChange = (omega - omega0)/deltaT;
    s.meanSpin = meanOf(omega, before.meanSpin);
    Q() = Q0() & rotation(deltaT*s.meanSpin);
    pi() = I & omega;
    tau() = I & (rConstraints() & second(change_));

    // In the axes of the end of the step
    a() = tConstraints() & Q() & first(change_);
    v() = tConstraints() & (v0() + deltaT/(1 + b)*(aDamp()*a() + b*before.velocityChange));
    s.velocityChange = (v() - v0())/deltaT;
    s.meanVelocity = meanOf(v(), before.meanVelocity);
    centreOfRotation() = centreOfRotation0() + deltaT*(tConstraints() & s.meanVelocity);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sixDoFSolvers::addedMass::solve
(
    bool firstIter,
    const vector& fGlobal,
    const vector& tauGlobal,
    scalar deltaT,
    scalar deltaT0
)
{
    const tensor axes(Q());
    const diagTensor& I = body_.momentOfInertia();
    const scalar mass = body_.mass();
    const tensor coupling(mass*crossing(arm()));
    const matrix M(blocks(mass*tensor::I, -coupling, coupling, tensor::I & inertia()));
    const matrix free(blocks(axes.T() & tConstraints() & axes, Zero, Zero, rConstraints()));

    boolList isFree(6);
    forAll(isFree, k)
    {
        isFree[k] = sumSqr(times(free, unit(k))) > sqr(SMALL);
    }
    const matrix estimated(estimate(isFree));

    const scalarField last(joined(axes.T() & a0(), inv(I) & tau0()));
    if (bodyHistory* h = history())
    {
        solveBackward(firstIter, *h, M, estimated, free, last, loads(fGlobal, tauGlobal), deltaT);
        return;
    }

    // The square of the body's own share in what it accelerates
    matrix share(6, 6, Zero);
    for (label k = 0; k < 6; ++k)
    {
        scalarField column(times(free, unit(k)));
        for (label power = 0; power < 2; ++power)
        {
            column = solved(M + estimated, times(M, column), free);
        }
        for (label j = 0; j < 6; ++j)
        {
            share(j, k) = column[j];
        }
    }
    const matrix carried((sumSqr(last) > 0 ? 0.5*deltaT0/deltaT : 0)*share);
    const scalarField now(loads(fGlobal, tauGlobal));
    scalarField s;
    if (firstIter)
    {
        forget();
        s = solved(M + estimated, now + times(estimated, last), free);
        change_ = s + times(carried, s - last);
    }
    else
    {
        correctChange(M, estimated, free, now);
        s = change_ + times(carried, last);
        matrix system(carried);
        for (label k = 0; k < 6; ++k)
        {
            system(k, k) += 1;
        }
        LUsolve(system, s);
    }
    const scalarField half(0.5*deltaT*aDamp()*times(share, s));

    v() = tConstraints() & (v0() + aDamp()*deltaT*(axes & first(change_)));
    centreOfRotation() = centreOfRotation0() + deltaT*(v() - (tConstraints() & axes & first(half)));

    const vector omega(rConstraints() & ((inv(I) & pi0()) + aDamp()*deltaT*second(change_)));
    const Tuple2<tensor, vector> Qomega(turned(omega - (rConstraints() & second(half)), deltaT));
    Q() = Qomega.first();
    // With the moments of inertia that OpenFOAM's state goes by
    pi() = I & (Qomega.second() + (rConstraints() & second(half)));

    a() = tConstraints() & axes & first(s);
    tau() = I & (rConstraints() & second(s));
}

// ************************************************************************* //
