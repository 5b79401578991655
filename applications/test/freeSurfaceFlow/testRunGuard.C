// SPDX-License-Identifier: GPL-3.0-or-later
// What a run shows that is not solved, or that diverges: told once, and stopped where nothing is left to save.

#include <gtest/gtest.h>

#include "../oversetMethods/compositeCase.H"

#include "runGuard.H"

#include <cmath>
#include <functional>
#include <random>

using namespace Foam;

namespace
{

//- Loads below which flips do not matter [N]
const scalar small = 0.1;


//- A mesh with a pressure, and the guard of a run on it
class guarded
:
    public ::testing::Test
{
protected:

    compositeCase flow;
    volScalarField p_rgh;
    runGuard guard;

    guarded()
    :
        flow("", 3, 6),
        p_rgh
        (
            IOobject("p_rgh", flow.time().timeName(), flow.mesh(), IOobject::NO_READ, IOobject::NO_WRITE),
            flow.mesh(),
            dimensionedScalar(dimPressure, Zero)
        ),
        guard(flow.mesh(), small)
    {}

    //- How often, in so many steps, something is told; -1 if the run is stopped
    int told(const std::string& what, const label nSteps, const std::function<void(label)>& step)
    {
        FatalError.throwExceptions();
        ::testing::internal::CaptureStdout();
        bool stopped = false;
        for (label n = 0; n < nSteps && !stopped; ++n)
        {
            ++flow.time();
            try
            {
                step(n);
            }
            catch (const Foam::error&)
            {
                stopped = true;
            }
        }
        const std::string log(::testing::internal::GetCapturedStdout());
        FatalError.dontThrowExceptions();
        int count = 0;
        for (std::size_t at = log.find(what); at != std::string::npos; at = log.find(what, at + 1))
        {
            ++count;
        }
        return stopped ? -1 : count;
    }

    int toldOfLoads(const label nSteps, const std::function<vector(label)>& load)
    {
        return told("\nRun\n    Note: The load on the walls flips from step to step", nSteps, [&](label n){ guard.checkLoads(load(n)); });
    }

    int toldOfSolvers(const label nSteps, const std::function<scalar(label)>& residual)
    {
        // Of a uniform field residuals say nothing
        p_rgh[0] = 1;
        return told
        (
            "\nRun\n    Note: p_rgh was not solved: its solver PCG stopped after 7 iterations",
            nSteps,
            [&](label n)
            {
                const scalar r = residual(n);
                flow.mesh().setSolverPerformance("p_rgh", solverPerformance("PCG", "p_rgh", 1, r, 7, r <= 1e-9));
                guard.checkSolvers();
            }
        );
    }
};


scalar flip(const label n)
{
    return n % 2 ? 1 : -1;
}

} // End anonymous namespace


TEST_F(guarded, loadsThatFlipAreToldOnce)
{
    // Less than the load that they flip about
    EXPECT_EQ(toldOfLoads(200, [](label n){ return vector(0, 0, 10 + 4*flip(n)); }), 1);
    EXPECT_EQ(toldOfLoads(200, [](label n){ return vector(0, 0, 10 + 4*flip(n)); }), 0);
}


TEST_F(guarded, loadsThatFlipTheirSignStopTheRun)
{
    EXPECT_EQ(toldOfLoads(45, [](label n){ return vector(0, 0, 1 + 10*flip(n)); }), 1);
    EXPECT_EQ(toldOfLoads(10, [](label n){ return vector(0, 0, 1 + 10*flip(n + 1)); }), -1);
}


TEST_F(guarded, otherLoadsAreNotTold)
{
    std::mt19937 engine(1);
    std::normal_distribution<scalar> noise;
    EXPECT_EQ(toldOfLoads(1000, [&](label n){ return vector(0, 0, 10 + 20*Foam::sin(0.1*n) + 0.3*noise(engine)); }), 0);
    EXPECT_EQ(toldOfLoads(200, [](label n){ return vector(0, 0, 10 + 0.5*flip(n)); }), 0);
    EXPECT_EQ(toldOfLoads(200, [](label n){ return vector(0, 0, 0.4*small*flip(n)); }), 0);
    EXPECT_EQ(toldOfLoads(200, [](label n){ return vector(0, 0, 10*Foam::sin(0.5*n)); }), 0);
}


TEST_F(guarded, systemsThatAreNotSolvedAreToldOnce)
{
    EXPECT_EQ(toldOfSolvers(30, [](label){ return 1e-10; }), 0);
    EXPECT_EQ(toldOfSolvers(30, [](label){ return 1e-7; }), 0);
    EXPECT_EQ(toldOfSolvers(30, [](label){ return 0.04; }), 1);
}


TEST_F(guarded, systemsOfWhichNothingIsSolvedStopTheRun)
{
    EXPECT_EQ(toldOfSolvers(100, [](label n){ return n % 10 == 9 ? 0.01 : 0.6; }), 1);
    EXPECT_EQ(toldOfSolvers(9, [](label){ return 0.6; }), 0);
    EXPECT_EQ(toldOfSolvers(1, [](label){ return 0.6; }), -1);
}


TEST_F(guarded, CourantNumbers)
{
    const auto toldOf = [&](const scalar Co, const label nCorrections)
    {
        return told("\nRun\n    Note: The Courant number is", 3, [&](label){ guard.checkCourant(Co, nCorrections); });
    };
    EXPECT_EQ(toldOf(0.9, 1), 0);
    EXPECT_EQ(toldOf(5, 2), 0);
    EXPECT_EQ(toldOf(5, 1), 1);
    EXPECT_EQ(toldOf(1e4, 2), -1);
    EXPECT_EQ(toldOf(std::nan(""), 2), -1);
}
