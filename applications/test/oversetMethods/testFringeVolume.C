// SPDX-License-Identifier: GPL-3.0-or-later
// The balance of the liquid's volume that fringeVolume keeps.

#include <gtest/gtest.h>

#include "compositeCase.H"
#include "fringeVolume.H"

#include "surfaceFields.H"
#include "transform.H"

using namespace Foam;

namespace
{

//- Liquid below a level, the air's cells above it and two cells of interface, about a zone that is turned
struct liquidCase
:
    public compositeCase
{
    compositeMesh composite;
    volScalarField alpha;
    surfaceScalarField alphaPhi;

    explicit liquidCase(scalar level)
    :
        composite(mesh()),
        alpha
        (
            IOobject("alpha", time().timeName(), mesh()),
            mesh(),
            dimensionedScalar(dimless, Zero),
            wordList({"overset", "zeroGradient", "zeroGradient"})
        ),
        alphaPhi
        (
            IOobject("alphaPhi", time().timeName(), mesh()),
            mesh(),
            dimensionedScalar(dimVolume/dimTime, Zero)
        )
    {
        turn(0.3);
        fill(level);
    }

    void turn(scalar angle)
    {
        move([&](const point& p){ return start() + (Ra(normalised(vector(1, 2, 3)), angle) & (p - start())); });
        composite.update();
    }

    void fill(scalar level)
    {
        forAll(alpha, celli)
        {
            alpha[celli] = max(scalar(0), min(scalar(1), 0.5 - (mesh().C()[celli].z() - level)/2));
        }
        alpha.correctBoundaryConditions();
    }

    scalar volume()
    {
        return uniqueVolume::New(mesh()).of(alpha);
    }

    //- What the fractions in the donors may change by
    scalarField room() const
    {
        return composite.donorCells()*alpha.primitiveField()*(1 - alpha.primitiveField());
    }

    //- Let this volume leave the domain in every step
    void drain(scalar volume)
    {
        alphaPhi.boundaryFieldRef()[mesh().boundaryMesh().findPatchID("outer")] =
            volume/time().deltaTValue()/mesh().boundary()["outer"].size();
    }

    void step(fringeVolume& fringe)
    {
        ++time();
        fringe.conserve(alpha, alphaPhi);
    }
};

} // End anonymous namespace


TEST(FringeVolume, ClosesTheBalance)
{
    // Interface beside the body; at the overset boundary on top, and through its corner
    for (const scalar level : {0.2, 3.1, 4.5})
    {
        SCOPED_TRACE(level);
        liquidCase c(level);
        fringeVolume fringe(c.composite, c.alpha);
        const scalar leaving = 0.3;
        c.drain(leaving);

        // Between the zones nothing leaves the domain
        c.alphaPhi.boundaryFieldRef()[c.mesh().boundaryMesh().findPatchID("fringe")] = 100;

        scalar expected = c.volume();
        for (label i = 1; i <= 3; ++i)
        {
            SCOPED_TRACE(i);
            c.turn(0.3 + 0.01*i);
            c.alpha.correctBoundaryConditions();
            c.step(fringe);
            expected -= leaving;
            EXPECT_NEAR(c.volume(), expected, 1e-12*expected);
            EXPECT_NEAR(fringe.get<scalar>("error"), 0, 1e-12*expected);
        }
    }
}


TEST(FringeVolume, TakesFromTheInterfaceInTheDonorsAlone)
{
    for (const scalar leaving : {0.5, -0.5})
    {
        SCOPED_TRACE(leaving);
        liquidCase c(0.2);
        fringeVolume fringe(c.composite, c.alpha);
        const scalarField before(c.alpha.primitiveField());
        const scalarField room(c.room());
        const scalarField calculated(c.composite.calculatedCells());
        c.drain(leaving);
        c.step(fringe);

        // One k for all
        const scalarField change(before - c.alpha.primitiveField());
        const scalar k = sum(change*room)/sumSqr(room);
        EXPECT_GT(k*leaving, 0);
        forAll(change, celli)
        {
            if (calculated[celli])
            {
                EXPECT_NEAR(change[celli], k*room[celli], 1e-14) << "cell " << celli;
            }
        }
        EXPECT_GE(gMin(c.alpha), 0);
        EXPECT_LE(gMax(c.alpha), 1 + 1e-14);
    }
}


TEST(FringeVolume, GivesWhatExceedsTheLimitToAllInterfaces)
{
    liquidCase c(0.2);
    fringeVolume fringe(c.composite, c.alpha);
    const scalar all = uniqueVolume::New(c.mesh()).of(c.room());
    const scalar expected = c.volume() - 0.25*all;
    const scalarField calculated(c.composite.calculatedCells());
    const scalarField others(calculated - c.composite.donorCells());

    c.drain(0.25*all);
    for (label i = 0; i < 10; ++i)
    {
        const scalarField before(c.alpha.primitiveField());
        c.step(fringe);
        c.drain(0);
        const scalarField change(mag(c.alpha.primitiveField() - before));

        // Twice a tenth of what a cell has or lacks, which the first has changed
        EXPECT_LE(max(calculated*change - 0.22*before*(1 - before)), 1e-14) << "step " << i;
        if (i == 0)
        {
            EXPECT_GT(max(others*change), 1e-6);
        }
    }
    EXPECT_NEAR(c.volume(), expected, 1e-12*expected);
}


TEST(FringeVolume, WaitsForAnInterfaceInTheFringe)
{
    // Liquid everywhere
    liquidCase c(9);
    fringeVolume fringe(c.composite, c.alpha);
    const scalarField before(c.alpha.primitiveField());
    const scalar full = c.volume();
    const scalar leaving = 0.5;
    c.drain(leaving);
    c.step(fringe);
    EXPECT_EQ(max(mag(c.alpha.primitiveField() - before)), 0);
    EXPECT_NEAR(fringe.get<scalar>("error"), leaving, 1e-12*full);

    // The level sinks into the fringe
    c.fill(0.2);
    const scalar below = c.volume();
    c.drain(full - below);
    c.step(fringe);
    EXPECT_NEAR(c.volume(), below - leaving, 1e-12*full);
}


TEST(FringeVolume, CountsTheOutflowOfAStepOnce)
{
    liquidCase c(0.2);
    fringeVolume fringe(c.composite, c.alpha);
    const scalar expected = c.volume();
    c.drain(0.3);
    c.step(fringe);

    // A second correction of the step, with another flux
    c.drain(0.2);
    fringe.conserve(c.alpha, c.alphaPhi);
    EXPECT_NEAR(std::stod(fringe.get<string>("expected")), expected - 0.2, 1e-12*expected);
    c.step(fringe);
    EXPECT_NEAR(std::stod(fringe.get<string>("expected")), expected - 0.4, 1e-12*expected);
}


TEST(FringeVolume, GoesOnAfterARestart)
{
    liquidCase c(0.2);
    string expected;
    {
        fringeVolume fringe(c.composite, c.alpha);
        c.drain(1.0/3);
        c.step(fringe);
        expected = fringe.get<string>("expected");
        ASSERT_TRUE(fringe.regIOobject::write());
    }

    // What has been lost in between shows
    c.fill(0.1);
    fringeVolume fringe(c.composite, c.alpha);
    c.drain(0);
    c.step(fringe);
    EXPECT_EQ(fringe.get<string>("expected"), expected);
}

// ************************************************************************* //
