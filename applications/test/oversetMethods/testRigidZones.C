// SPDX-License-Identifier: GPL-3.0-or-later
// The stencil rigidZones: weights, donors and layers, against a search of all cells.

#include "../refusedInput.H"
#include "compositeCase.H"

#include "Random.H"
#include "transform.H"

#include <map>
#include <set>

using namespace Foam;

namespace
{

//- Rotation about any axis and translation, without symmetry to the background; zone 1 stays on it
struct motion
{
    const char* name;
    vector axis;
    scalar angle;
    vector translation;
    scalar stretch;

    point operator()(const point& p) const
    {
        point q(p - compositeCase::start());
        q.x() *= stretch;
        return compositeCase::start() + translation + (Ra(normalised(axis), angle) & q);
    }
};

//- One after the other on the same mesh. The last two deform the zone, and turn what is deformed
const motion motions[] =
{
    {"translation", vector(1, 0, 0), 0, vector(0.34, 0.28, -0.41), 1},
    {"rotation", vector(1, 2, 3), 0.7, Zero, 1},
    {"both", vector(-3, 1, 0.5), 2.1, vector(-0.23, 0.31, 0.12), 1},
    {"stretching", vector(1, 2, 3), 0.3, Zero, 0.9},
    {"turning", vector(0.2, -1, 0.6), -0.8, vector(0.05, -0.1, 0.2), 0.9}
};


//- Donors of each acceptor with their weights
typedef std::map<label, scalar> donorWeights;

std::map<label, donorWeights> stencilOf(compositeCase& c)
{
    const cellCellStencil& stencil = c.stencil();
    labelList cells(identity(c.mesh().nCells()));
    stencil.cellInterpolationMap().distribute(cells);

    std::map<label, donorWeights> result;
    for (const label acceptor : stencil.interpolationCells())
    {
        const labelList& slots = stencil.cellStencil()[acceptor];
        forAll(slots, i)
        {
            result[acceptor][cells[slots[i]]] += stencil.cellInterpolationWeights()[acceptor][i];
        }
    }
    return result;
}


//- Calls a function with the stencil after each motion
template<class Function>
void forAllMotions(compositeCase& c, const Function& function)
{
    for (const motion& m : motions)
    {
        SCOPED_TRACE(m.name);
        c.move(m);
        const auto stencil = stencilOf(c);
        ASSERT_GT(stencil.size(), 400u);
        function(c, stencil);
    }
}


template<class Function>
void forAllMotions(const Function& function)
{
    compositeCase c;
    forAllMotions(c, function);
}


//- Cells of the other zone that have a point on the inner side of all their faces
labelList cellsAround(const fvMesh& mesh, const labelList& zoneID, const point& p, label zone)
{
    DynamicList<label> around;
    forAll(mesh.cells(), celli)
    {
        bool inside = zoneID[celli] == zone;
        for (const label facei : mesh.cells()[celli])
        {
            const scalar outwards = mesh.faceOwner()[facei] == celli ? 1 : -1;
            inside = inside && outwards*((p - mesh.faceCentres()[facei]) & mesh.faceAreas()[facei]) <= 0;
        }
        if (inside)
        {
            around.append(celli);
        }
    }
    return around;
}


//- Steps over faces to each cell from the nearest of some, labelMax where there is no way
labelList stepsFrom(const fvMesh& mesh, const labelList& cells)
{
    labelList steps(mesh.nCells(), labelMax);
    UIndirectList<label>(steps, cells) = 0;
    DynamicList<label> front(cells);
    while (front.size())
    {
        DynamicList<label> next;
        for (const label celli : front)
        {
            for (const label neighbour : mesh.cellCells()[celli])
            {
                if (steps[neighbour] == labelMax)
                {
                    steps[neighbour] = steps[celli] + 1;
                    next.append(neighbour);
                }
            }
        }
        front.transfer(next);
    }
    return steps;
}


scalar sumOf(const donorWeights& donors)
{
    scalar sum = 0;
    for (const auto& donor : donors)
    {
        sum += donor.second;
    }
    return sum;
}


//- Centres of 3 x 3 x 3 cells of 1 m about the origin
pointList lattice()
{
    pointList centres;
    for (label i = 0; i < 27; ++i)
    {
        centres.append(point(i % 3 - 1, i/3 % 3 - 1, i/9 - 1));
    }
    return centres;
}

} // End anonymous namespace


TEST(RigidZones, WeightsSumToOne)
{
    forAllMotions
    (
        [](compositeCase&, const auto& stencil)
        {
            for (const auto& acceptor : stencil)
            {
                EXPECT_NEAR(sumOf(acceptor.second), 1, 4e-15) << "cell " << acceptor.first;
            }
        }
    );

    // Donors in a plane far from the sample are where round-off is largest
    compositeCase c;
    pointList plane;
    for (label i = 0; i < 9; ++i)
    {
        plane.append(point(i % 3 - 0.9, i/3 - 1.2, 0.3*(i % 3) + 0.2*(i/3)));
    }
    scalarList weights;
    c.stencil().stencilWeights(point(0.1, 0.2, 1.1), plane, weights);
    EXPECT_NEAR(sum(weights), 1, 4e-15);
}


TEST(RigidZones, WeightsAreNotNegative)
{
    forAllMotions
    (
        [](compositeCase&, const auto& stencil)
        {
            for (const auto& acceptor : stencil)
            {
                for (const auto& donor : acceptor.second)
                {
                    EXPECT_GE(donor.second, 0) << "cell " << acceptor.first;
                }
            }
        }
    );
}


TEST(RigidZones, LinearFieldsAreExactBetweenDonors)
{
    compositeCase c;
    const pointList donors(lattice());
    Random random(1);
    scalarList weights;
    for (label i = 0; i < 100; ++i)
    {
        // In the cell in the middle
        const point sample(random.sample01<vector>() - 0.5*vector::one);
        c.stencil().stencilWeights(sample, donors, weights);
        EXPECT_GE(min(weights), 0);
        EXPECT_LT(mag(sum(weights*donors) - sample), 1e-14) << i;
    }
}


// Where donors are at equal distances, and as far below zero, as they are in aligned meshes: whatever their order
TEST(RigidZones, WeightsDoNotDependOnTheOrderOfDonors)
{
    compositeCase c;
    const pointList donors(lattice());
    scalarList weights, shuffledWeights;
    Random random(2);
    for (const point& sample : {point(0.5, 0, 0), point(0.5, 0.5, 0.5), point(0.3, 0.3, 0), point(0.4, 0.4, 0.4), point(0.45, 0.2, 0.45)})
    {
        c.stencil().stencilWeights(sample, donors, weights);
        for (label trial = 0; trial < 20; ++trial)
        {
            labelList order(identity(donors.size()));
            forAll(order, i)
            {
                Swap(order[i], order[random.position<label>(0, i)]);
            }
            // Numbered otherwise, and their centres are summed otherwise
            pointList shuffled(donors, order);
            for (point& p : shuffled)
            {
                p += 1e-15*(random.sample01<vector>() - 0.5*vector::one);
            }
            c.stencil().stencilWeights(sample, shuffled, shuffledWeights);
            forAll(order, i)
            {
                EXPECT_NEAR(shuffledWeights[i], weights[order[i]], 1e-9) << order[i];
            }
        }
    }
}


// Centres of the zone on corners of the background: of the eight cells about each the first one in space is its donor
TEST(RigidZones, TiesBetweenCellsAreResolvedByTheirPlaces)
{
    compositeCase c;
    c.move(motion{"", vector(1, 0, 0), 0, -compositeCase::start(), 1});
    const pointField& C = c.mesh().cellCentres();
    const labelList& zoneID = cellCellStencil::zoneID(c.mesh());
    label n = 0;
    for (const auto& acceptor : stencilOf(c))
    {
        if (zoneID[acceptor.first])
        {
            ++n;
            for (const auto& donor : acceptor.second)
            {
                EXPECT_LT(cmptMax(C[donor.first] - C[acceptor.first]), 0.51);
            }
        }
    }
    EXPECT_GT(n, 300);
}


// Of the whole mesh, in the fringe of which not all neighbours are donors
TEST(RigidZones, LinearFieldsAreInterpolatedExactly)
{
    forAllMotions
    (
        [](compositeCase& c, const auto& stencil)
        {
            const pointField& C = c.mesh().cellCentres();
            for (const auto& acceptor : stencil)
            {
                vector interpolated(Zero);
                for (const auto& donor : acceptor.second)
                {
                    interpolated += donor.second*C[donor.first];
                }
                EXPECT_LT(mag(interpolated - C[acceptor.first]), 1e-13) << "cell " << acceptor.first;
            }
        }
    );
}


TEST(RigidZones, DonorsAreCalculated)
{
    // In a coarser background a zone's acceptors reach into what the zone covers
    compositeCase same;
    compositeCase coarser("", 17, 12, 0.35);
    for (compositeCase* c : {&same, &coarser})
    {
        forAllMotions
        (
            *c,
            [](compositeCase& c, const auto& stencil)
            {
                for (const auto& acceptor : stencil)
                {
                    for (const auto& donor : acceptor.second)
                    {
                        EXPECT_EQ(c.stencil().cellTypes()[donor.first], cellCellStencil::CALCULATED)
                            << "cell " << donor.first << " for cell " << acceptor.first;
                    }
                }
            }
        );
    }
}


TEST(RigidZones, StencilsAreThoseOfASearchOfAllCells)
{
    forAllMotions
    (
        [](compositeCase& c, const auto& stencil)
        {
            const fvMesh& mesh = c.mesh();
            const pointField& C = mesh.cellCentres();
            const labelList& zoneID = cellCellStencil::zoneID(mesh);
            const labelUList& types = c.stencil().cellTypes();

            label nth = 0;
            for (const auto& acceptor : stencil)
            {
                // A few dozen of both zones
                if (nth++ % 7)
                {
                    continue;
                }
                const point& centre = C[acceptor.first];
                const labelList around(cellsAround(mesh, zoneID, centre, 1 - zoneID[acceptor.first]));
                ASSERT_EQ(around.size(), 1) << "cell " << acceptor.first;

                const labelList& corners = mesh.cellPoints()[around[0]];
                std::set<label> cells;
                for (const label pointi : corners)
                {
                    const labelList& sharing = mesh.pointCells()[pointi];
                    cells.insert(sharing.begin(), sharing.end());
                }
                labelList donors;
                pointList centres;
                for (const label celli : cells)
                {
                    if (types[celli] == cellCellStencil::CALCULATED)
                    {
                        donors.append(celli);
                        centres.append(C[celli]);
                    }
                }
                scalarList weights;
                c.stencil().stencilWeights(centre, centres, weights);

                donorWeights difference(acceptor.second);
                forAll(donors, i)
                {
                    difference[donors[i]] -= weights[i];
                }
                for (const auto& donor : difference)
                {
                    EXPECT_NEAR(donor.second, 0, 1e-10) << "cell " << donor.first << " for cell " << acceptor.first;
                }
            }
        }
    );
}


TEST(RigidZones, BackgroundInTheBodyIsAHole)
{
    label nInBody = 0;
    forAllMotions
    (
        [&](compositeCase& c, const auto&)
        {
            // The body is what its six faces enclose
            const fvMesh& mesh = c.mesh();
            const fvPatch& body = mesh.boundary()[mesh.boundaryMesh().findPatchID("body")];
            ASSERT_EQ(body.size(), 6);
            forAll(mesh.cells(), celli)
            {
                bool inside = cellCellStencil::zoneID(mesh)[celli] == 0;
                forAll(body, facei)
                {
                    inside = inside && ((mesh.cellCentres()[celli] - body.Cf()[facei]) & body.Sf()[facei]) > 0;
                }
                if (inside)
                {
                    ++nInBody;
                    EXPECT_EQ(c.stencil().cellTypes()[celli], cellCellStencil::HOLE) << "cell " << celli;
                }
            }
        }
    );
    EXPECT_GT(nInBody, 0);
}


TEST(RigidZones, LayersOfAcceptorsAreAsManyAsAsked)
{
    for (const label n : {1, 2, 3})
    {
        SCOPED_TRACE(n);
        compositeCase c(n == 1 ? std::string() : "layers " + std::to_string(n) + ";", 4*n + 5, 4*n + 10);
        c.move(motion{"", vector(1, 2, 3), 0.1, Zero, 1});
        const fvMesh& mesh = c.mesh();
        const labelList& zoneID = cellCellStencil::zoneID(mesh);
        const labelUList& types = c.stencil().cellTypes();

        DynamicList<label> calculated;
        forAll(types, celli)
        {
            if (types[celli] == cellCellStencil::CALCULATED)
            {
                calculated.append(celli);
            }
        }
        const labelList fromCalculated(stepsFrom(mesh, calculated));
        const labelList fromFringe(stepsFrom(mesh, mesh.boundary()[mesh.boundaryMesh().findPatchID("fringe")].faceCells()));

        std::map<label, label> nCells;
        forAll(types, celli)
        {
            ++nCells[types[celli]];
            if (zoneID[celli])
            {
                EXPECT_EQ(types[celli], fromFringe[celli] < n ? cellCellStencil::INTERPOLATED : cellCellStencil::CALCULATED);
            }
            else if (fromCalculated[celli])
            {
                EXPECT_EQ(types[celli], fromCalculated[celli] <= n ? cellCellStencil::INTERPOLATED : cellCellStencil::HOLE);
            }
        }
        EXPECT_GT(nCells[cellCellStencil::HOLE], 0);
        EXPECT_GT(nCells[cellCellStencil::INTERPOLATED], 0);
    }
}


TEST(RigidZones, RefusesLayersThatAreNone)
{
    for (const std::string bad : {"0", "-1", "two"})
    {
        expectRefusal
        (
            {"layers", "system/fvSchemes", "oversetInterpolation"},
            [&]{ compositeCase("layers " + bad + ";"); }
        );
    }
    expectRefusal({"Entry layers is 0", "one or more"}, []{ compositeCase("layers 0;"); });
}

// ************************************************************************* //
