// SPDX-License-Identifier: GPL-3.0-or-later

#include "compressedRows.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Of an aggregate, over the sum of its rows'
constexpr Foam::scalar leastDiagonal = 1e-4;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::compressedRows::compressedRows
(
    const lduMatrix& matrix,
    const UList<coupling>& couplings
)
:
    start_(matrix.diag().size() + 1, Zero),
    above_(matrix.diag().size()),
    diag_(matrix.diag().size()),
    rDiag_(matrix.diag().size())
{
    const labelUList& low = matrix.lduAddr().lowerAddr();
    const labelUList& high = matrix.lduAddr().upperAddr();
    const scalarField& lower = matrix.lower();
    const scalarField& upper = matrix.upper();

    scalarField diag(matrix.diag());
    forAll(low, facei)
    {
        start_[high[facei] + 1] += lower[facei] != 0;
        start_[low[facei] + 1] += upper[facei] != 0;
    }
    for (const coupling& c : couplings)
    {
        if (c.column == c.row)
        {
            diag[c.row] += c.coeff;
        }
        else
        {
            ++start_[c.row + 1];
        }
    }
    forAll(diag, row)
    {
        start_[row + 1] += start_[row];
        diag_[row] = diag[row];
        rDiag_[row] = 1/diag[row];
    }
    columns_.setSize(start_.last());
    coeffs_.setSize(start_.last());

    List<label> next(SubList<label>(start_, size()));
    const auto append = [&](const label row, const label column, const scalar coeff)
    {
        if (coeff != 0)
        {
            columns_[next[row]] = column;
            coeffs_[next[row]++] = coeff;
        }
    };

    // Faces are in the order of their upper triangle, and so are columns
    forAll(low, facei)
    {
        append(high[facei], low[facei], lower[facei]);
    }
    for (const coupling& c : couplings)
    {
        if (c.column < c.row)
        {
            append(c.row, c.column, c.coeff);
        }
    }
    above_ = next;
    forAll(low, facei)
    {
        append(low[facei], high[facei], upper[facei]);
    }
    for (const coupling& c : couplings)
    {
        if (c.column > c.row)
        {
            append(c.row, c.column, c.coeff);
        }
    }
}


Foam::compressedRows::compressedRows
(
    const UList<real>& diag,
    const UList<label>& rowSizes,
    const UList<label>& columns,
    const UList<real>& coeffs
)
:
    start_(diag.size() + 1, Zero),
    above_(diag.size()),
    columns_(columns),
    coeffs_(coeffs),
    diag_(diag),
    rDiag_(diag.size())
{
    forAll(diag_, row)
    {
        start_[row + 1] = start_[row] + rowSizes[row];
        rDiag_[row] = 1/diag_[row];

        label& above = above_[row];
        above = start_[row];
        for (label i = start_[row]; i < start_[row + 1]; ++i)
        {
            if (columns_[i] < row)
            {
                Swap(columns_[i], columns_[above]);
                Swap(coeffs_[i], coeffs_[above]);
                ++above;
            }
        }
    }
}


Foam::compressedRows::compressedRows
(
    const compressedRows& fine,
    const aggregates& rows,
    const UList<label>& newColumns
)
:
    start_(rows.size + 1, Zero),
    above_(rows.size),
    columns_(fine.nCoeffs()/2),
    coeffs_(fine.nCoeffs()/2),
    diag_(rows.size),
    rDiag_(rows.size)
{
    columns_.clear();
    coeffs_.clear();

    // The rows of each aggregate as a chain
    labelList first(rows.size, -1);
    labelList next(fine.size(), -1);
    forAllReverse(rows.of, row)
    {
        const label aggregate = rows.of[row];
        if (aggregate != -1)
        {
            next[row] = first[aggregate];
            first[aggregate] = row;
        }
    }

    label nColumns = rows.size;
    for (const label column : newColumns)
    {
        nColumns = max(nColumns, column + 1);
    }
    labelList slots(nColumns, -1);

    forAll(first, aggregate)
    {
        const label start = start_[aggregate];
        scalar diag = 0, own = 0;
        for (label row = first[aggregate]; row != -1; row = next[row])
        {
            diag += fine.diag_[row];
            own += fine.diag_[row];
            for (label i = fine.start_[row]; i < fine.start_[row + 1]; ++i)
            {
                const label column = newColumns[fine.columns_[i]];
                if (column == aggregate)
                {
                    diag += fine.coeffs_[i];
                }
                else if (column != -1)
                {
                    label& slot = slots[column];
                    if (slot < start)
                    {
                        slot = columns_.size();
                        columns_.append(column);
                        coeffs_.append(fine.coeffs_[i]);
                    }
                    else
                    {
                        coeffs_[slot] += fine.coeffs_[i];
                    }
                }
            }
        }
        // Where zones overlap too little, the acceptors that stand for an
        // aggregate may leave nothing of its balance: it corrects little
        if (diag/own < leastDiagonal)
        {
            diag = own;
        }
        diag_[aggregate] = diag;
        rDiag_[aggregate] = 1/diag;
        start_[aggregate + 1] = columns_.size();

        label& above = above_[aggregate];
        above = start;
        for (label i = start; i < columns_.size(); ++i)
        {
            // Of other rows from here on
            slots[columns_[i]] = -1;
            if (columns_[i] < aggregate)
            {
                Swap(columns_[i], columns_[above]);
                Swap(coeffs_[i], coeffs_[above]);
                ++above;
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::compressedRows::rowSizes() const
{
    labelList sizes(size());
    forAll(sizes, row)
    {
        sizes[row] = start_[row + 1] - start_[row];
    }
    return sizes;
}


Foam::scalarSquareMatrix Foam::compressedRows::square() const
{
    scalarSquareMatrix matrix(size(), Zero);
    forAll(diag_, row)
    {
        matrix(row, row) = diag_[row];
        for (label i = start_[row]; i < start_[row + 1]; ++i)
        {
            matrix(row, columns_[i]) += coeffs_[i];
        }
    }
    return matrix;
}


bool Foam::compressedRows::has(const label row, const label column) const
{
    for (label i = start_[row]; i < start_[row + 1]; ++i)
    {
        if (columns_[i] == column)
        {
            return true;
        }
    }
    return false;
}


Foam::label Foam::compressedRows::strongest(const label row) const
{
    label column = -1;
    real largest = 0;
    for (label i = start_[row]; i < start_[row + 1]; ++i)
    {
        if (mag(coeffs_[i]) > largest)
        {
            largest = mag(coeffs_[i]);
            column = columns_[i];
        }
    }
    return column;
}


Foam::boolList Foam::compressedRows::lone() const
{
    boolList is(size());
    forAll(is, row)
    {
        is[row] = start_[row] == start_[row + 1];
    }
    return is;
}


Foam::boolList Foam::compressedRows::interpolated() const
{
    boolList is(size(), false);
    forAll(is, row)
    {
        bool given = false;
        for (label i = start_[row]; !given && i < start_[row + 1]; ++i)
        {
            given = columns_[i] < size() && has(columns_[i], row);
        }
        is[row] = !given && start_[row] != start_[row + 1];
    }
    return is;
}


Foam::compressedRows::aggregates Foam::compressedRows::pairs
(
    const boolList& leftOut
) const
{
    // Of the largest coupling of a row
    const real strong = 0.25;
    const label largest = 3;

    aggregates pairs{labelList(size(), -1), 0};
    labelList& of = pairs.of;
    DynamicList<label> sizes(size()/2);

    forAll(of, row)
    {
        if (leftOut[row] || of[row] != -1)
        {
            continue;
        }
        const real sign = diag_[row] > 0 ? -1 : 1;
        real most = 0, mostFree = 0, mostJoined = 0;
        label free = -1, joined = -1;
        for (label i = start_[row]; i < start_[row + 1]; ++i)
        {
            const label column = columns_[i];
            if (column >= size() || leftOut[column])
            {
                continue;
            }
            const real strength = sign*coeffs_[i];
            most = max(most, strength);
            if (of[column] == -1)
            {
                if (strength > mostFree && has(column, row))
                {
                    mostFree = strength;
                    free = column;
                }
            }
            else if (strength > mostJoined && sizes[of[column]] < largest && has(column, row))
            {
                mostJoined = strength;
                joined = of[column];
            }
        }

        if (free != -1 && mostFree >= strong*most)
        {
            of[row] = of[free] = pairs.size++;
            sizes.append(2);
        }
        else if (joined != -1 && mostJoined >= strong*most)
        {
            of[row] = joined;
            ++sizes[joined];
        }
        else
        {
            of[row] = pairs.size++;
            sizes.append(1);
        }
    }
    return pairs;
}


void Foam::compressedRows::sweepFromZero(UList<real>& x, const UList<real>& b) const
{
    const label n = size();
    for (label row = 0; row < n; ++row)
    {
        x[row] = less(b[row], start_[row], above_[row], x)*rDiag_[row];
    }
}


void Foam::compressedRows::addResidualAbove
(
    UList<real>& sums,
    const UList<label>& aggregate,
    const UList<real>& x
) const
{
    const label n = size();
    for (label row = 0; row < n; ++row)
    {
        if (aggregate[row] != -1)
        {
            sums[aggregate[row]] += less(0, above_[row], start_[row + 1], x);
        }
    }
}


void Foam::compressedRows::sweepUp(UList<real>& x, const UList<real>& b) const
{
    for (label row = size() - 1; row >= 0; --row)
    {
        x[row] = less(b[row], start_[row], start_[row + 1], x)*rDiag_[row];
    }
}


void Foam::compressedRows::residual
(
    UList<real>& r,
    const UList<real>& x,
    const UList<real>& b
) const
{
    const label n = size();
    for (label row = 0; row < n; ++row)
    {
        r[row] = less(b[row] - diag_[row]*x[row], start_[row], start_[row + 1], x);
    }
}

// ************************************************************************* //
