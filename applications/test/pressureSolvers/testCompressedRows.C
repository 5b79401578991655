// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a matrix and how they are joined.

#include <gtest/gtest.h>

#include "compressedRows.H"

using namespace Foam;

namespace
{

typedef compressedRows::real real;

//- Four cells in a row, coupled by 1, 4 and 1; the fifth takes 0.3 of the first and 0.7 of the fourth; the sixth is alone
compressedRows sixCells()
{
    return compressedRows
    (
        List<real>({1, 5, 5, 1, 1, 2}),
        labelList({1, 2, 2, 1, 2, 0}),
        labelList({1,  2, 0,  3, 1,  2,  3, 0}),
        List<real>({-1,  -4, -1,  -1, -4,  -1,  -0.7f, -0.3f})
    );
}

const boolList fifth({false, false, false, false, true, false});

} // End anonymous namespace


TEST(CompressedRows, areWhatTheyWereMadeOf)
{
    const scalarSquareMatrix A(sixCells().square());
    EXPECT_EQ(sixCells().nCoeffs(), 8);
    EXPECT_EQ(A(1, 0), -1);
    EXPECT_EQ(A(1, 2), -4);
    EXPECT_EQ(A(2, 3), -1);
    EXPECT_FLOAT_EQ(A(4, 0), -0.3);
    EXPECT_EQ(A(0, 4), 0);
    EXPECT_EQ(A(5, 5), 2);
}


TEST(CompressedRows, tellInterpolatedAndLoneRows)
{
    EXPECT_EQ(sixCells().interpolated(), fifth);
    EXPECT_EQ(sixCells().lone(), boolList({false, false, false, false, false, true}));
    EXPECT_EQ(sixCells().strongest(4), 3);
    EXPECT_EQ(sixCells().strongest(5), -1);
}


TEST(CompressedRows, joinWhatIsCoupledMost)
{
    boolList leftOut(fifth);
    leftOut[5] = true;
    const auto pairs = sixCells().pairs(leftOut);

    // The first finds the second free, and so the third is left with the fourth
    EXPECT_EQ(pairs.of, labelList({0, 0, 1, 1, -1, -1}));
    EXPECT_EQ(pairs.size, 2);

    // Whoever comes too late joins the pair that he is coupled to
    leftOut[3] = true;
    EXPECT_EQ(sixCells().pairs(leftOut).of, labelList({0, 0, 0, -1, -1, -1}));

    // A row that only takes is not joined with whom it takes from
    EXPECT_EQ(sixCells().pairs(boolList(6, false)).of, labelList({0, 0, 1, 1, 2, 3}));
}


TEST(CompressedRows, areAddedUp)
{
    boolList leftOut(fifth);
    leftOut[5] = true;
    const compressedRows A(sixCells());
    const auto pairs = A.pairs(leftOut);

    // The fifth stands for the fourth, the sixth for none
    const scalarSquareMatrix coarse(compressedRows(A, pairs, labelList({0, 0, 1, 1, 1, -1})).square());
    EXPECT_EQ(coarse(0, 0), 4);
    EXPECT_EQ(coarse(0, 1), -4);
    EXPECT_EQ(coarse(1, 0), -4);
    EXPECT_EQ(coarse(1, 1), 4);
}


TEST(CompressedRows, sweepTowardsTheSolution)
{
    const compressedRows A(sixCells());
    const scalarSquareMatrix dense(A.square());
    const List<real> b({1, 2, 3, 4, 5, 6});
    List<real> x(6, Zero), r(6);

    // What a sweep downwards leaves is what is above the diagonal
    A.sweepFromZero(x, b);
    List<real> above(6, Zero);
    A.addResidualAbove(above, identity(6), x);
    A.residual(r, x, b);
    forAll(r, row)
    {
        scalar left = b[row];
        for (label column = 0; column < 6; ++column)
        {
            left -= dense(row, column)*x[column];
        }
        EXPECT_NEAR(r[row], left, 1e-5);
        EXPECT_NEAR(above[row], left, 1e-5);
    }

    // A sweep upwards what is below
    A.sweepUp(x, b);
    A.residual(r, x, b);
    EXPECT_NEAR(r[0], 0, 1e-5);
    EXPECT_GT(mag(r[2]), 0.1);
}

// ************************************************************************* //
