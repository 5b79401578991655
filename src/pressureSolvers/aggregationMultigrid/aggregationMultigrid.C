// SPDX-License-Identifier: GPL-3.0-or-later

#include "aggregationMultigrid.H"
#include "addToRunTimeSelectionTable.H"
#include "cyclicLduInterface.H"
#include "processorLduInterface.H"
#include "globalIndex.H"
#include "ListListOps.H"
#include "UIndirectList.H"
#include "profiling.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(aggregationMultigrid, 0);

    lduMatrix::preconditioner::addsymMatrixConstructorToTable<aggregationMultigrid>
        addAggregationMultigridSymMatrixConstructorToTable_;

    lduMatrix::preconditioner::addasymMatrixConstructorToTable<aggregationMultigrid>
        addAggregationMultigridAsymMatrixConstructorToTable_;
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A level of so many rows goes to all processors
constexpr label maxCommon = 4000;

//- So many rows are solved directly, or are made fewer
constexpr label maxDirect = 100;

//- Aggregates per row, at most; else the level is the last
constexpr scalar leastReduction = 0.8;

//- Of the corrections; beyond 2 a smooth error would grow
constexpr float overCorrection = 1.4;

//- The coarser levels that are visited twice
constexpr label lastTwice = 3;


//- Cells of the processors' boundaries, as they are numbered on the other side
labelListList neighbourCells(const lduInterfacePtrsList& interfaces, const label nCells)
{
    const labelList own(identity(nCells));
    const label nRequests = UPstream::nRequests();
    const auto forAllPairs = [&](const auto& function)
    {
        forAll(interfaces, i)
        {
            if
            (
                interfaces.set(i)
             && (
                    isA<processorLduInterface>(interfaces[i])
                 || isA<cyclicLduInterface>(interfaces[i])
                )
            )
            {
                function(i);
            }
        }
    };

    forAllPairs
    (
        [&](const label i)
        {
            interfaces[i].initInternalFieldTransfer(UPstream::commsTypes::nonBlocking, own);
        }
    );
    if (UPstream::parRun())
    {
        UPstream::waitRequests(nRequests);
    }

    labelListList neighbours(interfaces.size());
    forAllPairs
    (
        [&](const label i)
        {
            neighbours[i] = interfaces[i].internalFieldTransfer(UPstream::commsTypes::nonBlocking, own);
        }
    );
    return neighbours;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::aggregationMultigrid::level::level(compressedRows&& rows, ghostCells&& others)
:
    A(std::move(rows)),
    ghosts(std::move(others)),
    x(max(A.size(), ghosts.size()), Zero),
    b(A.size(), Zero),
    r(A.size(), Zero)
{}


void Foam::aggregationMultigrid::addFinest(const lduMatrix::solver& solver)
{
    const lduMatrix& matrix = solver.matrix();
    const label nCells = matrix.diag().size();

    // An overset mesh's own: the fields of its stencil name another interface
    const lduInterfacePtrsList interfaces(matrix.mesh().interfaces());
    const labelListList neighbours(neighbourCells(interfaces, nCells));

    const auto processor = [&](const label i)
    {
        const auto* other = isA<processorLduInterface>(interfaces[i]);
        return other ? other->neighbProcNo() : UPstream::myProcNo(comm_);
    };
    const auto forAllCouplings = [&](const auto& function)
    {
        forAll(neighbours, i)
        {
            forAll(neighbours[i], facei)
            {
                const scalar coeff = -solver.interfaceBouCoeffs()[i][facei];
                if (coeff != 0)
                {
                    function
                    (
                        interfaces[i].faceCells()[facei],
                        labelPair(processor(i), neighbours[i][facei]),
                        coeff
                    );
                }
            }
        }
    };

    DynamicList<labelPair> needed;
    forAllCouplings
    (
        [&](const label, const labelPair& other, const scalar)
        {
            if (other.first() != UPstream::myProcNo(comm_))
            {
                needed.append(other);
            }
        }
    );
    ghostCells ghosts(nCells, comm_, needed);

    DynamicList<compressedRows::coupling> couplings;
    forAllCouplings
    (
        [&](const label cell, const labelPair& other, const scalar coeff)
        {
            const label column =
                other.first() == UPstream::myProcNo(comm_)
              ? other.second()
              : ghosts.slot(other);
            couplings.append(compressedRows::coupling{cell, column, coeff});
        }
    );
    levels_.append(new level(compressedRows(matrix, couplings), std::move(ghosts)));
}


bool Foam::aggregationMultigrid::addCoarser()
{
    level& fine = levels_.last();
    const compressedRows& A = fine.A;
    const label nGhosts = max(A.size(), fine.ghosts.size()) - A.size();

    const boolList lone(A.lone());
    const boolList interpolated
    (
        levels_.size() == 1 ? A.interpolated() : boolList(A.size(), false)
    );
    boolList leftOut(lone);
    forAll(leftOut, row)
    {
        leftOut[row] = lone[row] || interpolated[row];
    }

    // Twice in pairs. The ghosts come last, as they are
    const auto first = A.pairs(leftOut);
    labelList stands(first.of);
    stands.append(identity(nGhosts, first.size));
    for (label pass = 0; pass < 3; ++pass)
    {
        // Donors may be interpolated
        forAll(interpolated, row)
        {
            if (interpolated[row] && stands[row] == -1)
            {
                stands[row] = stands[A.strongest(row)];
            }
        }
    }
    const compressedRows paired(A, first, stands);
    const auto second = paired.pairs(boolList(paired.size(), false));

    fine.restricted.setSize(A.size(), -1);
    fine.corrected.setSize(A.size(), -1);
    forAll(fine.corrected, row)
    {
        if (stands[row] != -1 && stands[row] < first.size)
        {
            fine.corrected[row] = second.of[stands[row]];
        }
        if (first.of[row] != -1)
        {
            fine.restricted[row] = fine.corrected[row];
        }
    }
    if (isCommon(levels_.size()))
    {
        if (second.size > leastReduction*A.size())
        {
            return false;
        }
        levels_.append
        (
            new level(compressedRows(paired, second, second.of), ghostCells())
        );
        return true;
    }

    if
    (
        returnReduce(second.size, sumOp<label>(), UPstream::msgType(), comm_)
      > leastReduction*returnReduce(A.size(), sumOp<label>(), UPstream::msgType(), comm_)
    )
    {
        return false;
    }

    // Aggregates of all processors are numbered through. Cells that stand for
    // one of another processor know it after their ghosts do
    const label me = UPstream::myProcNo(comm_);
    const globalIndex numbers(second.size, UPstream::msgType(), comm_, true);
    labelList global(stands.size(), -1);
    forAll(fine.corrected, row)
    {
        if (fine.corrected[row] != -1)
        {
            global[row] = numbers.toGlobal(me, fine.corrected[row]);
        }
    }
    fine.ghosts.exchange(global);
    forAll(fine.corrected, row)
    {
        if (stands[row] >= first.size)
        {
            global[row] = global[A.size() + stands[row] - first.size];
        }
    }
    fine.ghosts.exchange(global);

    const auto place = [&](const label number)
    {
        const label proci = numbers.whichProcID(number);
        return labelPair(proci, numbers.toLocal(proci, number));
    };
    DynamicList<labelPair> needed(nGhosts);
    for (label ghost = A.size(); ghost < A.size() + nGhosts; ++ghost)
    {
        if (global[ghost] != -1 && !numbers.isLocal(me, global[ghost]))
        {
            needed.append(place(global[ghost]));
        }
    }
    ghostCells ghosts(second.size, comm_, needed);

    labelList columns(second.of);
    columns.setSize(first.size + nGhosts, -1);
    for (label i = 0; i < nGhosts; ++i)
    {
        const label number = global[A.size() + i];
        if (number != -1)
        {
            columns[first.size + i] =
                numbers.isLocal(me, number)
              ? numbers.toLocal(me, number)
              : ghosts.slot(place(number));
        }
    }
    levels_.append
    (
        new level(compressedRows(paired, second, columns), std::move(ghosts))
    );
    return true;
}


void Foam::aggregationMultigrid::makeCommon()
{
    const level& own = levels_.last();
    const label n = own.A.size();
    const label nProcs = UPstream::nProcs(comm_);
    const label me = UPstream::myProcNo(comm_);

    const globalIndex numbers(n, UPstream::msgType(), comm_, true);
    labelList global(own.x.size());
    for (label row = 0; row < n; ++row)
    {
        global[row] = numbers.toGlobal(me, row);
    }
    own.ghosts.exchange(global);

    List<realList> diags(nProcs), coeffs(nProcs);
    List<labelList> sizes(nProcs), columns(nProcs);
    diags[me] = own.A.diag();
    coeffs[me] = own.A.coeffs();
    sizes[me] = own.A.rowSizes();
    columns[me] = UIndirectList<label>(global, own.A.columns());
    const auto share = [&](auto& lists)
    {
        Pstream::gatherList(lists, UPstream::msgType(), comm_);
        Pstream::scatterList(lists, UPstream::msgType(), comm_);
    };
    share(diags);
    share(coeffs);
    share(sizes);
    share(columns);

    commonStart_.setSize(nProcs + 1, Zero);
    for (label proci = 0; proci < nProcs; ++proci)
    {
        commonStart_[proci + 1] = commonStart_[proci] + diags[proci].size();
    }
    common_ = levels_.size() - 1;
    levels_.set
    (
        common_,
        new level
        (
            compressedRows
            (
                ListListOps::combine<realList>(diags, accessOp<realList>()),
                ListListOps::combine<labelList>(sizes, accessOp<labelList>()),
                ListListOps::combine<labelList>(columns, accessOp<labelList>()),
                ListListOps::combine<realList>(coeffs, accessOp<realList>())
            ),
            ghostCells()
        )
    );
}


Foam::UList<Foam::aggregationMultigrid::real> Foam::aggregationMultigrid::ownPart
(
    const label leveli,
    realList& values
) const
{
    const label start = leveli == common_ ? commonStart_[UPstream::myProcNo(comm_)] : 0;
    return UList<real>(values.begin() + start, values.size() - start);
}


void Foam::aggregationMultigrid::share(const label leveli) const
{
    if (leveli != common_ || !UPstream::parRun())
    {
        return;
    }
    realList& b = levels_[leveli].b;
    List<realList> parts(UPstream::nProcs(comm_));
    const label me = UPstream::myProcNo(comm_);
    parts[me] = SubList<real>(b, commonStart_[me + 1] - commonStart_[me], commonStart_[me]);
    Pstream::gatherList(parts, UPstream::msgType(), comm_);
    Pstream::scatterList(parts, UPstream::msgType(), comm_);
    b = ListListOps::combine<realList>(parts, accessOp<realList>());
}


void Foam::aggregationMultigrid::solve(const label leveli) const
{
    share(leveli);
    cycle(leveli);
    if (leveli == 0 || leveli > lastTwice || leveli == levels_.size() - 1)
    {
        return;
    }
    const level& l = levels_[leveli];
    const realList first(SubList<real>(l.x, l.A.size()));
    l.ghosts.exchange(l.x);
    l.A.residual(l.r, l.x, l.b);
    l.b.swap(l.r);
    cycle(leveli);
    forAll(first, row)
    {
        l.x[row] += first[row];
    }
}


void Foam::aggregationMultigrid::cycle(const label leveli) const
{
    const level& l = levels_[leveli];
    const compressedRows& A = l.A;
    if (pivots_.size() && leveli == levels_.size() - 1)
    {
        List<scalar> solution(A.size());
        forAll(solution, row)
        {
            solution[row] = l.b[row];
        }
        LUBacksubstitute(coarsest_, pivots_, solution);
        forAll(solution, row)
        {
            l.x[row] = solution[row];
        }
        return;
    }

    A.sweepFromZero(l.x, l.b);
    l.ghosts.exchange(l.x);
    if (leveli < levels_.size() - 1)
    {
        const level& coarser = levels_[leveli + 1];
        coarser.b = Zero;
        UList<real> sums(ownPart(leveli + 1, coarser.b));
        A.addResidualAbove(sums, l.restricted, l.x);
        solve(leveli + 1);

        const UList<real> correction(ownPart(leveli + 1, coarser.x));
        forAll(l.corrected, row)
        {
            if (l.corrected[row] != -1)
            {
                l.x[row] += overCorrection*correction[l.corrected[row]];
            }
        }
        l.ghosts.exchange(l.x);
    }
    A.sweepUp(l.x, l.b);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aggregationMultigrid::aggregationMultigrid
(
    const lduMatrix::solver& solver,
    const dictionary&
)
:
    lduMatrix::preconditioner(solver),
    comm_(solver.matrix().mesh().comm()),
    common_(UPstream::parRun() ? -1 : 0),
    commonStart_(1, Zero)
{
    addProfiling(levels, "aggregationMultigrid::levels");

    addFinest(solver);
    while (!isCommon(levels_.size()))
    {
        const label n = returnReduce(levels_.last().A.size(), sumOp<label>(), UPstream::msgType(), comm_);
        if (n <= maxCommon || !addCoarser())
        {
            makeCommon();
        }
    }
    while (levels_.last().A.size() > maxDirect && addCoarser())
    {}

    const compressedRows& last = levels_.last().A;
    if (last.size() <= maxDirect)
    {
        coarsest_ = last.square();
        pivots_.setSize(last.size());
        LUDecompose(coarsest_, pivots_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aggregationMultigrid::precondition
(
    solveScalarField& w,
    const solveScalarField& r,
    const direction
) const
{
    const level& finest = levels_[0];
    UList<real> b(ownPart(0, finest.b));
    forAll(r, celli)
    {
        b[celli] = r[celli];
    }
    solve(0);
    const UList<real> x(ownPart(0, finest.x));
    forAll(w, celli)
    {
        w[celli] = x[celli];
    }
}

// ************************************************************************* //
