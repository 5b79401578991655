// SPDX-License-Identifier: GPL-3.0-or-later

#include "ghostCells.H"
#include "ListOps.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::ghostCells::ghostCells
(
    const label nCells,
    const label comm,
    const UList<labelPair>& needed
)
:
    nCells_(nCells),
    comm_(comm)
{
    if (!UPstream::parRun())
    {
        return;
    }
    needed_.setSize(UPstream::nProcs(comm));

    labelList counts(needed_.size(), Zero);
    for (const labelPair& cell : needed)
    {
        ++counts[cell.first()];
    }
    forAll(needed_, proci)
    {
        needed_[proci].setSize(counts[proci]);
    }
    counts = 0;
    for (const labelPair& cell : needed)
    {
        needed_[cell.first()][counts[cell.first()]++] = cell.second();
    }

    first_.setSize(needed_.size() + 1);
    first_[0] = nCells;
    forAll(needed_, proci)
    {
        inplaceUniqueSort(needed_[proci]);
        first_[proci + 1] = first_[proci] + needed_[proci].size();
    }
    Pstream::exchange<labelList, label>(needed_, sent_, UPstream::msgType(), comm);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::ghostCells::slot(const labelPair& cell) const
{
    return
        first_[cell.first()]
      + findSortedIndex(needed_[cell.first()], cell.second());
}

// ************************************************************************* //
