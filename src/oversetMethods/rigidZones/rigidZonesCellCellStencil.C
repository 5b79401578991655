// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidZonesCellCellStencil.H"
#include "addToRunTimeSelectionTable.H"
#include "CPCCellToCellStencil.H"
#include "inputChecks.H"
#include "oversetFvPatch.H"
#include "PstreamBuffers.H"
#include "stopAfterWriting.H"
#include "syncTools.H"
#include "profiling.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace cellCellStencils
{
    defineTypeNameAndDebug(rigidZones, 0);
    addToRunTimeSelectionTable(cellCellStencil, rigidZones, mesh);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

label readLayers(const dictionary& dict)
{
    const label layers = dict.lookupOrDefault<label>("layers", 1);
    if (layers < 1)
    {
        refuseEntry(dict, "layers", text("is ", layers), "one or more layers of acceptors.");
    }
    return layers;
}


//- What processors ask of each other: for each question that the others pose
//  an answer, in their order
template<class Question, class Answer, class Function>
List<List<Answer>> askAll
(
    const List<DynamicList<Question>>& questions,
    const Function& answer
)
{
    const auto exchange = [](const auto& send, auto& receive)
    {
        PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
        forAll(send, proci)
        {
            if (proci == Pstream::myProcNo())
            {
                receive[proci] = send[proci];
            }
            else
            {
                UOPstream os(proci, buffers);
                os << send[proci];
            }
        }
        buffers.finishedSends();
        forAll(receive, proci)
        {
            if (proci != Pstream::myProcNo())
            {
                UIPstream is(proci, buffers);
                is >> receive[proci];
            }
        }
    };

    List<List<Question>> asked(Pstream::nProcs());
    exchange(questions, asked);

    List<List<Answer>> given(Pstream::nProcs());
    forAll(asked, proci)
    {
        given[proci].setSize(asked[proci].size());
        forAll(asked[proci], i)
        {
            given[proci][i] = answer(asked[proci][i]);
        }
    }

    List<List<Answer>> answers(Pstream::nProcs());
    exchange(given, answers);
    return answers;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellCellStencils::rigidZones::setNeighbours()
{
    const CPCCellToCellStencil all(mesh_);

    // The library counts boundary faces too, after the cells
    const globalIndex& both = all.globalNumbering();
    labelList cellOf(both.localSize(), -1);
    forAll(neighbours_, celli)
    {
        cellOf[celli] = globalCells_.toGlobal(celli);
    }
    labelListList slots(all);
    List<Map<label>> compactMap;
    mapDistribute(both, slots, compactMap).distribute(cellOf);

    forAll(neighbours_, celli)
    {
        DynamicList<label> cells(slots[celli].size());
        for (const label slot : slots[celli])
        {
            if (cellOf[slot] != -1)
            {
                cells.append(cellOf[slot]);
            }
        }
        neighbours_[celli].transfer(cells);
    }
    compactMap.clear();
    neighbourMap_.reset
    (
        new mapDistribute(globalCells_, neighbours_, compactMap)
    );
}


Foam::boolList Foam::cellCellStencils::rigidZones::nextTo
(
    const boolList& marked
) const
{
    boolList result(mesh_.nCells(), false);
    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    forAll(nei, facei)
    {
        if (marked[own[facei]])
        {
            result[nei[facei]] = true;
        }
        if (marked[nei[facei]])
        {
            result[own[facei]] = true;
        }
    }

    boolList beyond;
    syncTools::swapBoundaryCellList(mesh_, marked, beyond);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                if (beyond[patch.start() - mesh_.nInternalFaces() + i])
                {
                    result[patch.faceCells()[i]] = true;
                }
            }
        }
    }
    return result;
}


void Foam::cellCellStencils::rigidZones::find
(
    const label zone,
    const UList<point>& points,
    labelList& donors,
    boolList& isInside,
    boolList& isDonor
) const
{
    List<boundBox> bounds(Pstream::nProcs());
    bounds[Pstream::myProcNo()] = zones_[zone].bounds();
    Pstream::gatherList(bounds);
    Pstream::scatterList(bounds);

    boundBox all;
    for (const boundBox& b : bounds)
    {
        if (b.valid())
        {
            all.add(b);
        }
    }

    // The parts of the zone on the processors need not fill their common box:
    // where none has the point, all of them are asked for their nearest wall
    List<DynamicList<point>> questions(Pstream::nProcs());
    labelListList who(Pstream::nProcs());
    List<DynamicList<label>> asked(Pstream::nProcs());
    forAll(points, i)
    {
        forAll(bounds, proci)
        {
            if (bounds[proci].valid() && all.contains(points[i]))
            {
                questions[proci].append(points[i]);
                asked[proci].append(i);
            }
        }
    }

    // Cell and is it a donor; its centre and the square of the distance from
    // it, or without a cell from the nearest boundary, and is that a wall
    typedef Tuple2<labelPair, Tuple2<point, Tuple2<scalar, bool>>> answer;
    const zoneSearch& search = zones_[zone];
    const List<List<answer>> answers
    (
        askAll<point, answer>
        (
            questions,
            [&](const point& p)
            {
                const zoneSearch::hit hit(search.findCell(p));
                labelPair cell(-1, false);
                scalar distance = hit.distance;
                bool inside = false;
                if (hit.cell != -1)
                {
                    cell = labelPair(globalCells_.toGlobal(hit.cell), isDonor_[hit.cell]);
                }
                else if (zone)
                {
                    distance = search.nearestBoundary(p, inside);
                }
                return answer
                (
                    cell,
                    Tuple2<point, Tuple2<scalar, bool>>
                    (
                        hit.centre,
                        Tuple2<scalar, bool>(distance, inside)
                    )
                );
            }
        )
    );

    donors = labelList(points.size(), -1);
    isInside = boolList(points.size(), false);
    isDonor = boolList(points.size(), false);
    scalarList nearest(points.size(), GREAT);
    pointField centre(points.size());
    forAll(answers, proci)
    {
        forAll(answers[proci], k)
        {
            const label i = asked[proci][k];
            const answer& a = answers[proci][k];
            const zoneSearch::hit found
            {
                a.first().first(),
                a.second().first(),
                a.second().second().first()
            };
            if (found.cell != -1)
            {
                const zoneSearch::hit best{donors[i], centre[i], nearest[i]};
                if (best.cell == -1 || found.isBefore(best))
                {
                    donors[i] = found.cell;
                    isDonor[i] = a.first().second();
                    isInside[i] = false;
                    centre[i] = found.centre;
                    nearest[i] = found.distance;
                }
            }
            else if (donors[i] == -1 && found.distance < nearest[i])
            {
                nearest[i] = found.distance;
                isInside[i] = a.second().second().second();
            }
        }
    }
}


void Foam::cellCellStencils::rigidZones::checkOverlap() const
{
    // Boxes about the zones on top, over all processors, tell first
    List<boundBox> bounds(zones_.size());
    forAll(zones_, zonei)
    {
        if (zones_[zonei].bounds().valid())
        {
            bounds[zonei] = zones_[zonei].bounds();
        }
        bounds[zonei].reduce();
    }

    const labelList& zoneID = this->zoneID();
    const pointField& C = mesh_.cellCentres();
    labelList found;
    boolList isInside, isDonor;
    for (label zonei = 1; zonei < zones_.size(); ++zonei)
    {
        for (label other = 1; other < zones_.size(); ++other)
        {
            if (other == zonei || !bounds[zonei].overlaps(bounds[other]))
            {
                continue;
            }
            DynamicList<point> fringe;
            forAll(zoneTypes_, celli)
            {
                if
                (
                    zoneID[celli] == zonei
                 && zoneTypes_[celli] == INTERPOLATED
                 && bounds[other].contains(C[celli])
                )
                {
                    fringe.append(C[celli]);
                }
            }
            find(other, fringe, found, isInside, isDonor);

            label n = 0;
            point where(point::max);
            forAll(found, i)
            {
                if (found[i] != -1)
                {
                    ++n;
                    where = min(where, fringe[i]);
                }
            }
            if (returnReduce(n, sumOp<label>()))
            {
                stopAfterWriting
                (
                    mesh_,
                    text
                    (
                        "Overset zones ", zonei, " and ", other, " (field zoneID) overlap: ",
                        returnReduce(n, sumOp<label>()), " cells at the outer boundary of zone ", zonei,
                        " lie in zone ", other, ", beyond ", returnReduce(where, minOp<point>()), "."
                    ),
                    "zones that lie on the background alone, which method rigidZones is for (system/fvSchemes::oversetInterpolation):"
                    " bodies whose meshes keep apart, or another method."
                );
            }
        }
    }
}


Foam::labelList Foam::cellCellStencils::rigidZones::setTypes()
{
    const labelList& zoneID = this->zoneID();
    const pointField& C = mesh_.cellCentres();

    cellTypes_ = zoneTypes_;
    labelList donors(mesh_.nCells(), -1);
    labelList found;
    boolList isInside, isDonor;

    // Acceptors of the zones on top
    boolList needed(mesh_.nCells(), false);
    {
        DynamicList<label> acceptors;
        forAll(zoneTypes_, celli)
        {
            if (zoneTypes_[celli] == INTERPOLATED)
            {
                acceptors.append(celli);
            }
        }
        find(0, pointField(C, acceptors), found, isInside, isDonor);

        List<DynamicList<label>> theirs(Pstream::nProcs());
        forAll(acceptors, i)
        {
            const label celli = acceptors[i];
            donors[celli] = found[i];
            if (found[i] == -1)
            {
                cellTypes_[celli] = HOLE;
            }
            else
            {
                theirs[globalCells_.whichProcID(found[i])].append(found[i]);
            }
        }
        (void)askAll<label, bool>
        (
            theirs,
            [&](const label donor)
            {
                needed[globalCells_.toLocal(donor)] = true;
                return true;
            }
        );
        const boolList neighbours(nextTo(needed));
        forAll(needed, celli)
        {
            needed[celli] = needed[celli] || neighbours[celli];
        }
    }

    // The background under them
    boolList isCovered(mesh_.nCells(), false);
    {
        DynamicList<label> background;
        boundBox all;
        for (label zonei = 1; zonei < zones_.size(); ++zonei)
        {
            if (zones_[zonei].bounds().valid())
            {
                all.add(zones_[zonei].bounds());
            }
        }
        all.reduce();
        forAll(zoneID, celli)
        {
            if (zoneID[celli] == 0 && all.contains(C[celli]))
            {
                background.append(celli);
            }
        }

        for (label zonei = 1; zonei < zones_.size(); ++zonei)
        {
            find(zonei, pointField(C, background), found, isInside, isDonor);
            forAll(background, i)
            {
                const label celli = background[i];
                if (isInside[i])
                {
                    cellTypes_[celli] = HOLE;
                }
                else if (found[i] != -1 && isDonor[i] && !needed[celli])
                {
                    isCovered[celli] = true;
                    donors[celli] = found[i];
                }
            }
        }
    }

    // Layers of acceptors about what is left of the background
    boolList front(mesh_.nCells(), false);
    forAll(front, celli)
    {
        front[celli] =
            zoneID[celli] == 0
         && !isCovered[celli]
         && cellTypes_[celli] == CALCULATED;
    }
    for (label layer = 0; layer < layers_; ++layer)
    {
        const boolList neighbours(nextTo(front));
        forAll(front, celli)
        {
            front[celli] = neighbours[celli] && isCovered[celli];
            if (front[celli])
            {
                isCovered[celli] = false;
                cellTypes_[celli] = INTERPOLATED;
            }
        }
    }
    forAll(isCovered, celli)
    {
        if (isCovered[celli])
        {
            cellTypes_[celli] = HOLE;
        }
        if (cellTypes_[celli] != INTERPOLATED)
        {
            donors[celli] = -1;
        }
    }
    return donors;
}


void Foam::cellCellStencils::rigidZones::setStencils(const labelList& donors)
{
    typedef Tuple2<label, point> question;      // donor, and who takes from it
    typedef Tuple2<labelList, scalarList> answer;   // its stencil and weights

    List<DynamicList<question>> questions(Pstream::nProcs());
    List<DynamicList<label>> asked(Pstream::nProcs());
    DynamicList<label> acceptors;
    forAll(donors, celli)
    {
        if (donors[celli] != -1)
        {
            const label proci = globalCells_.whichProcID(donors[celli]);
            questions[proci].append(question(donors[celli], mesh_.cellCentres()[celli]));
            asked[proci].append(celli);
            acceptors.append(celli);
        }
    }
    interpolationCells_.transfer(acceptors);

    // Of the neighbours, on other processors too
    boolList isCalculated(mesh_.nCells());
    labelList global
    (
        identity(globalCells_.localSize(), globalCells_.localStart())
    );
    pointField centre(mesh_.cellCentres());
    forAll(isCalculated, celli)
    {
        isCalculated[celli] = cellTypes_[celli] == CALCULATED;
    }
    neighbourMap_->distribute(isCalculated);
    neighbourMap_->distribute(global);
    neighbourMap_->distribute(centre);

    label nWithoutCalculated = 0;
    const auto stencil = [&](const question& q)
    {
        const label donor = globalCells_.toLocal(q.first());
        DynamicList<label> cells;
        DynamicList<point> centres;
        if (!isCalculated[donor])
        {
            ++nWithoutCalculated;
            cells.append(q.first());
            centres.append(mesh_.cellCentres()[donor]);
        }
        for (const label slot : neighbours_[donor])
        {
            if (isCalculated[slot])
            {
                cells.append(global[slot]);
                centres.append(centre[slot]);
            }
        }

        answer a;
        scalarList weights;
        stencilWeights(q.second(), centres, weights);
        forAll(weights, i)
        {
            if (weights[i] > 0)
            {
                a.first().append(cells[i]);
                a.second().append(weights[i]);
            }
        }
        return a;
    };
    const List<List<answer>> answers(askAll<question, answer>(questions, stencil));

    stencil_ = labelListList(mesh_.nCells());
    weights_ = scalarListList(mesh_.nCells());
    factor_ = scalarList(mesh_.nCells(), scalar(0));
    forAll(answers, proci)
    {
        forAll(answers[proci], k)
        {
            const label celli = asked[proci][k];
            stencil_[celli] = answers[proci][k].first();
            weights_[celli] = answers[proci][k].second();
            factor_[celli] = 1;
        }
    }

    List<Map<label>> compactMap;
    map_.reset(new mapDistribute(globalCells_, stencil_, compactMap));

    // This processor's values are in their places already: of them only those
    // that are used need to travel
    boolList isUsed(mesh_.nCells(), false);
    for (const label celli : interpolationCells_)
    {
        for (const label slot : stencil_[celli])
        {
            if (slot < isUsed.size())
            {
                isUsed[slot] = true;
            }
        }
    }
    const labelList used(findIndices(isUsed, true));
    map_->subMap()[Pstream::myProcNo()] = used;
    map_->constructMap()[Pstream::myProcNo()] = used;

    if (returnReduce(nWithoutCalculated, sumOp<label>()))
    {
        WarningInFunction
            << returnReduce(nWithoutCalculated, sumOp<label>())
            << " cells are interpolated from cells that are not calculated: a"
            << " body is too near to the overset boundary about it." << nl
            << "Expected: at least " << 2*layers_ + 2
            << " cells of the background between them." << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellCellStencils::rigidZones::rigidZones
(
    const fvMesh& mesh,
    const dictionary& dict,
    const bool doUpdate
)
:
    cellCellStencil(mesh),
    layers_(readLayers(dict)),
    globalCells_(mesh.nCells()),
    neighbours_(mesh.nCells()),
    zones_(gMax(zoneID()) + 1),
    zoneTypes_(mesh.nCells(), CALCULATED),
    isDonor_(mesh.nCells(), false),
    cellTypes_(mesh.nCells(), CALCULATED)
{
    setNeighbours();

    const labelList& zoneID = this->zoneID();
    forAll(zones_, zonei)
    {
        zones_.set(zonei, new zoneSearch(mesh, zonei, zoneID));
    }

    boolList front(mesh.nCells(), false);
    for (const fvPatch& patch : mesh.boundary())
    {
        if (isA<oversetFvPatch>(patch))
        {
            UIndirectList<bool>(front, patch.faceCells()) = true;
        }
    }
    boolList isAcceptor(front);
    for (label layer = 1; layer < layers_; ++layer)
    {
        front = nextTo(isAcceptor);
        forAll(front, celli)
        {
            isAcceptor[celli] = isAcceptor[celli] || front[celli];
        }
    }

    const boolList nextToAcceptor(nextTo(isAcceptor));
    forAll(isAcceptor, celli)
    {
        if (zoneID[celli])
        {
            zoneTypes_[celli] = isAcceptor[celli] ? INTERPOLATED : CALCULATED;
            isDonor_[celli] = !isAcceptor[celli] && !nextToAcceptor[celli];
        }
    }

    if (doUpdate)
    {
        update();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::cellCellStencils::rigidZones::update()
{
    addProfiling(stencil, "overset stencil");

    for (zoneSearch& zone : zones_)
    {
        zone.update();
    }
    if (zones_.size() > 2)
    {
        checkOverlap();
    }
    setStencils(setTypes());

    const labelList n(count(3, cellTypes_));
    Info<< "Overset: " << n[CALCULATED] << " cells calculated, "
        << n[INTERPOLATED] << " interpolated, " << n[HOLE] << " holes" << endl;
    return true;
}


void Foam::cellCellStencils::rigidZones::stencilWeights
(
    const point& sample,
    const pointList& donors,
    scalarList& weights
) const
{
    weights.setSize(donors.size());
    const scalar size = magSqr(boundBox(donors, false).span()) + ROOTVSMALL;
    const scalar nearest = 1e-6*size;

    boolList isUsed(donors.size(), true);
    while (true)
    {
        // Importance of each donor, and their mean position
        scalar total = 0;
        vector mean(Zero);
        forAll(donors, i)
        {
            weights[i] =
                isUsed[i] ? 1/sqr(magSqr(donors[i] - sample) + nearest) : 0;
            total += weights[i];
            mean += weights[i]*(donors[i] - sample);
        }
        mean /= total;

        symmTensor moment(Zero);
        forAll(donors, i)
        {
            moment += weights[i]*sqr(donors[i] - sample - mean);
        }
        // Those left may span a plane, or less; where they span, what that
        // takes from the gradient is given back
        const symmTensor inverse
        (
            inv(moment + symmTensor::I*(1e-6*tr(moment) + 1e-12*total*size))
        );
        vector gradient(inverse & mean);
        for (label i = 0; i < 2; ++i)
        {
            gradient += inverse & (mean - (moment & gradient));
        }

        label least = 0;
        forAll(donors, i)
        {
            weights[i] *= 1/total - ((donors[i] - sample - mean) & gradient);
            if (weights[i] < weights[least])
            {
                least = i;
            }
        }
        if (weights[least] >= 0)
        {
            break;
        }
        isUsed[least] = false;
    }

    const scalar all = sum(weights);
    for (scalar& w : weights)
    {
        w /= all;
    }
}

// ************************************************************************* //
