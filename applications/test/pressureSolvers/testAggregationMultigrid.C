// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions for a pressure with the preconditioner, of two fluids on a single and on a composite mesh.

#include <gtest/gtest.h>

#include "../oversetMethods/compositeCase.H"
#include "aggregationMultigrid.H"
#include "fvm.H"
#include "fvMatrices.H"
#include "lduPrimitiveMesh.H"
#include "Random.H"
#include "surfaceFields.H"

using namespace Foam;

namespace
{

//- The cells of a box with n along an edge, coupled to their six neighbours, and by the ratio of two fluids more in its upper half;
//  the outside of one side has the value 0
struct boxMatrix
{
    autoPtr<lduPrimitiveMesh> mesh;
    autoPtr<lduMatrix> matrix;
    FieldField<Field, scalar> none;
    lduInterfaceFieldPtrsList noInterfaces;

    boxMatrix(const label n, const scalar ratio, const scalar skew = 0)
    {
        const auto cell = [&](label i, label j, label k) { return i + n*(j + n*k); };
        labelList low, high;
        DynamicList<label> l, u;
        DynamicList<scalar> coeffs;
        for (label k = 0; k < n; ++k)
        for (label j = 0; j < n; ++j)
        for (label i = 0; i < n; ++i)
        {
            const scalar coeff = -(k > n/2 ? ratio : 1);
            const auto couple = [&](label other) { l.append(cell(i, j, k)); u.append(other); coeffs.append(coeff); };
            if (i + 1 < n) couple(cell(i + 1, j, k));
            if (j + 1 < n) couple(cell(i, j + 1, k));
            if (k + 1 < n) couple(cell(i, j, k + 1));
        }
        low.transfer(l);
        high.transfer(u);
        mesh.reset(new lduPrimitiveMesh(n*n*n, low, high, UPstream::worldComm, true));
        matrix.reset(new lduMatrix(mesh()));
        matrix->upper() = coeffs;
        if (skew)
        {
            matrix->lower() = (1 + skew)*matrix->upper();
        }
        scalarField& diag = matrix->diag();
        diag = 0;
        forAll(coeffs, facei)
        {
            diag[mesh->lduAddr().lowerAddr()[facei]] -= coeffs[facei];
            diag[mesh->lduAddr().upperAddr()[facei]] -= (1 + skew)*coeffs[facei];
        }
        for (label k = 0; k < n; ++k)
        for (label j = 0; j < n; ++j)
        {
            diag[cell(0, j, k)] += 2;
        }
    }

    autoPtr<lduMatrix::solver> solver(const string& entries) const
    {
        IStringStream stream(entries);
        return lduMatrix::solver::New("p", matrix(), none, none, noInterfaces, dictionary(stream));
    }
};

const char* const multigrid = "preconditioner aggregationMultigrid; tolerance 0; relTol 1e-8;";

scalarField noise(const label n, const label seed)
{
    Random random(seed);
    scalarField field(n);
    for (scalar& value : field)
    {
        value = random.sample01<scalar>() - 0.5;
    }
    return field;
}

scalarField preconditioned(const boxMatrix& box, const scalarField& r)
{
    const auto solver = box.solver(string("solver PBiCGStab;") + multigrid);
    scalarField w(r.size());
    aggregationMultigrid(solver(), dictionary()).precondition(w, r, 0);
    return w;
}

//- Iterations of a flow from one corner to another
label iterations(const boxMatrix& box, const string& solver)
{
    scalarField x(box.matrix->diag().size(), Zero), b(x);
    b.first() = 1;
    b.last() = -1;
    return box.solver(solver + multigrid)->solve(x, b).nIterations();
}

//- A pressure with fluids of two densities above and below the body's middle
struct compositePressure
:
    public compositeCase
{
    volScalarField p;
    surfaceScalarField rDensity;

    compositePressure(label nZone, label nBackground, scalar spacing)
    :
        compositeCase("", nZone, nBackground, spacing),
        p
        (
            IOobject("p", time().timeName(), mesh()),
            mesh(),
            dimensionedScalar(dimless, Zero),
            wordList({"overset", "fixedValue", "zeroGradient"})
        ),
        rDensity
        (
            IOobject("rDensity", time().timeName(), mesh()),
            mesh(),
            dimensionedScalar("one", dimless, 1)
        )
    {
        move([](const point& q){ return q + vector(0.31, 0.27, -0.41); });
        mesh().update();
        forAll(rDensity, facei)
        {
            rDensity[facei] = mesh().Cf()[facei].z() > 0 ? 1000 : 1;
        }
    }

    //- The iterations of a solution from zero; the body gives fluid
    label solve(const string& entries)
    {
        p = dimensionedScalar(dimless, Zero);
        fvScalarMatrix equation(fvm::laplacian(rDensity, p));
        for (const label celli : mesh().boundary()["body"].faceCells())
        {
            equation.source()[celli] = 1;
        }
        IStringStream stream("solver PBiCGStab; tolerance 0; " + entries);
        return equation.solve(dictionary(stream)).nIterations();
    }
};

} // End anonymous namespace


TEST(AggregationMultigrid, solvesAsADirectSolverDoes)
{
    const boxMatrix box(7, 1000, 0.2);
    const label n = 343;
    scalarSquareMatrix dense(n, Zero);
    forAll(box.matrix->diag(), celli)
    {
        dense(celli, celli) = box.matrix->diag()[celli];
    }
    forAll(box.matrix->upper(), facei)
    {
        const label low = box.mesh->lduAddr().lowerAddr()[facei], high = box.mesh->lduAddr().upperAddr()[facei];
        dense(low, high) = box.matrix->upper()[facei];
        dense(high, low) = box.matrix->lower()[facei];
    }
    const scalarField b(noise(n, 1));
    scalarField direct(b), x(n, Zero);
    labelList pivots(n);
    LUDecompose(dense, pivots);
    LUBacksubstitute(dense, pivots, direct);

    EXPECT_LT(box.solver(string("solver PBiCGStab;") + multigrid)->solve(x, b).nIterations(), 25);
    EXPECT_LT(max(mag(x - direct)), 1e-6*max(mag(direct)));
}


TEST(AggregationMultigrid, isLinearAndRepeatsItself)
{
    const boxMatrix box(12, 1000);
    const scalarField a(noise(1728, 1)), b(noise(1728, 2));
    const scalarField x(preconditioned(box, a)), y(preconditioned(box, b));
    EXPECT_LT(max(mag(preconditioned(box, 3*a - 2*b) - 3*x + 2*y)), 1e-4*max(mag(x)));
    EXPECT_EQ(preconditioned(box, a), x);
}


TEST(AggregationMultigrid, isSymmetricWhereTheMatrixIs)
{
    const boxMatrix box(12, 1000);
    const scalarField a(noise(1728, 1)), b(noise(1728, 2));
    const scalarField x(preconditioned(box, a)), y(preconditioned(box, b));
    EXPECT_LT(mag(sumProd(a, y) - sumProd(b, x)), 1e-4*std::sqrt(sumProd(a, x)*sumProd(b, y)));
    EXPECT_GT(sumProd(a, x), 0);
}


TEST(AggregationMultigrid, needsHardlyMoreIterationsForMoreCells)
{
    for (const char* solver : {"solver PBiCGStab;", "solver PCG;"})
    {
        const label few = iterations(boxMatrix(10, 124), solver), many = iterations(boxMatrix(32, 124), solver);
        RecordProperty(string(solver), std::to_string(few) + " " + std::to_string(many));
        EXPECT_LE(many, 1.5*few) << solver;
    }
}


TEST(AggregationMultigrid, solvesOnACompositeMeshWithHoles)
{
    compositePressure few(9, 16, 1.5), many(21, 36, 1.5);

    few.solve("preconditioner DILU; relTol 1e-12;");
    const scalarField right(few.p.primitiveField());
    const label nFew = few.solve("preconditioner aggregationMultigrid; relTol 1e-10;");
    EXPECT_LT(max(mag(few.p.primitiveField() - right)), 1e-7*max(mag(right)));

    const label n = many.solve("preconditioner aggregationMultigrid; relTol 1e-10;");
    const label nDILU = many.solve("preconditioner DILU; relTol 1e-10;");
    EXPECT_LE(nFew, 12);
    EXPECT_LE(n, 1.3*nFew);
    EXPECT_LT(3*n, nDILU);
}

// ************************************************************************* //
