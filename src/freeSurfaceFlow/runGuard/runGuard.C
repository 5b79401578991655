// SPDX-License-Identifier: GPL-3.0-or-later

#include "runGuard.H"
#include "inputChecks.H"
#include "stopAfterWriting.H"
#include "surfaceFields.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Of a linear system that counts as solved, whatever its own tolerance:
//  OpenFOAM's default tolerance
const scalar solvedResidual = 1e-6;

//- Share by which a field varies that is as good as uniform
const scalar uniformField = 1e-6;

//- Residual from which on a system is not solved at all, and steps of that in
//  a row after which a run is lost
const scalar unsolvedResidual = 0.5;
const label lostUnsolved = 10;

//- Steps that the means of the loads go back
const scalar memory = 20;

//- Flips in a row that are no chance, and after which a run is lost if the
//  flips outweigh the load
const label toldFlips = 10, lostFlips = 50;

//- Share of the load that a flip has at least
const scalar largeChange = 0.2;

//- Of a volume fraction beyond its bounds, what is told
const scalar toldExcess = 0.01;

//- A flow that is followed has no such Courant numbers
const scalar lostCourant = 1000;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::runGuard::slendernessOf(const fvMesh& mesh)
{
    // |Sf|/(V d) is 1/h^2 along d
    scalarField least(mesh.nCells(), GREAT), greatest(mesh.nCells(), Zero);
    const scalarField& V = mesh.V().field();
    const scalarField perFace
    (
        (mesh.magSf()*mesh.nonOrthDeltaCoeffs())().primitiveField()
    );
    forAll(perFace, facei)
    {
        for (const label celli : {mesh.owner()[facei], mesh.neighbour()[facei]})
        {
            const scalar s = perFace[facei]/V[celli];
            least[celli] = min(least[celli], s);
            greatest[celli] = max(greatest[celli], s);
        }
    }
    // Of a cell without neighbours on this processor nothing is known
    return sqrt(pos0(greatest - VSMALL)*least*greatest);
}


void Foam::runGuard::note(const word& kind, const std::string& sentence)
{
    if (told_.insert(kind))
    {
        Info<< nl << "Run" << nl
            << "    Note: " << sentence.c_str() << ", first at t = " << mesh_.time().timeName() << " s." << nl << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::runGuard::runGuard(const fvMesh& mesh, const scalar smallLoad)
:
    mesh_(mesh),
    smallLoad_(smallLoad),
    slenderness_(slendernessOf(mesh)),
    told_(),
    load_(Zero),
    change_(Zero),
    meanLoad_(Zero),
    meanMagnitude_(0),
    nFlips_(0),
    nLoads_(0),
    nUnsolved_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::runGuard::largestCourant(const label nCorrections)
{
    return nCorrections > 1 ? GREAT : 1;
}


void Foam::runGuard::checkSolvers()
{
    bool unsolved = false;
    for (const entry& e : mesh_.solverPerformanceDict())
    {
        const volScalarField* field = mesh_.findObject<volScalarField>(e.keyword());
        // OpenFOAM's residuals are relative to how much a field varies: of a uniform one, as in a liquid without a surface, they say nothing
        if (!field || gMax(*field) - gMin(*field) <= uniformField*gMax(mag(field->primitiveField())))
        {
            continue;
        }
        const List<solverPerformance> solutions(e.stream());
        for (const solverPerformance& s : solutions)
        {
            if (!s.converged() && s.nIterations() > 0 && !(s.finalResidual() <= solvedResidual))
            {
                note
                (
                    "solver:" + e.keyword(),
                    text
                    (
                        e.keyword(), " was not solved: its solver ", s.solverName(), " stopped after ", s.nIterations(),
                        " iterations, its maxIter, with a residual of ", s.finalResidual(), " (system/fvSolution)"
                    )
                );
                unsolved = unsolved || !(s.finalResidual() < unsolvedResidual);
            }
        }
    }

    nUnsolved_ = unsolved ? nUnsolved_ + 1 : 0;
    if (nUnsolved_ >= lostUnsolved)
    {
        stop
        (
            text("A linear system has not been solved for ", nUnsolved_, " steps: half of its residual, or more, is left"),
            "a solver, preconditioner and maxIter in system/fvSolution that solve it."
        );
    }
}


void Foam::runGuard::checkLoads(const vector& load)
{
    const vector change(load - load_);
    const bool isKnown = nLoads_++ > 1;
    const scalar small = max(largeChange*meanMagnitude_, smallLoad_);
    const bool flips = isKnown && (change & change_) < 0 && mag(change) > small && mag(change_) > small;
    nFlips_ = flips ? nFlips_ + 1 : 0;

    const scalar weight = 1/min(scalar(nLoads_), memory);
    meanLoad_ += weight*(load - meanLoad_);
    meanMagnitude_ += weight*(mag(load) - meanMagnitude_);
    load_ = load;
    change_ = change;

    if (nFlips_ >= toldFlips)
    {
        note
        (
            "loads",
            text
            (
                "The load on the walls flips from step to step, by ", mag(change), " N about ", mag(meanLoad_),
                " N: the step is too long, or one pass too few (nCorrectors, nOuterCorrectors)"
            )
        );
    }
    if (nFlips_ >= lostFlips && 0.5*mag(change) > mag(meanLoad_))
    {
        stop
        (
            text
            (
                "The load on the walls has changed its sign with each of ", nFlips_, " steps, by ", mag(change),
                " N about ", mag(meanLoad_), " N"
            ),
            "shorter steps, or more nCorrectors or nOuterCorrectors."
        );
    }
}


void Foam::runGuard::checkFractions(const scalar excess)
{
    // Not stopped: with local time steps such states pass
    if (excess > toldExcess)
    {
        note
        (
            "fractions",
            text("Volume fractions of the liquid are out of 0 to 1 by ", excess, ": expected at most ", toldExcess, ", by shorter steps or a better mesh")
        );
    }
}


void Foam::runGuard::checkCourant(const scalar Co, const label nCorrections)
{
    if (!(Co < lostCourant))
    {
        stop(text("The flow diverges: the Courant number is ", Co), "shorter steps, or a better mesh.");
    }
    if (Co > largestCourant(nCorrections))
    {
        note
        (
            "Courant",
            text
            (
                "The Courant number is ", Co, ", and a step has ", nCorrections, " pressure correction: expected at most ",
                largestCourant(nCorrections), ", or more nCorrectors"
            )
        );
    }
}


Foam::scalar Foam::runGuard::diffusionNumber(const scalarField& nu) const
{
    // The mesh may have changed its cells
    return nu.size() == slenderness_.size() ? gMax(nu*slenderness_)*mesh_.time().deltaTValue() : 0;
}


Foam::scalar Foam::runGuard::largestDiffusion(const label nCorrectors)
{
    return nCorrectors > 2 ? GREAT : 1;
}


void Foam::runGuard::checkDiffusion(const scalar D, const label nCorrectors)
{
    if (D > largestDiffusion(nCorrectors))
    {
        note
        (
            "diffusion",
            text
            (
                "The diffusion number is ", D, ", and a pass has ", nCorrectors, " pressure corrections: expected at most ",
                largestDiffusion(nCorrectors), ", or nCorrectors 3"
            )
        );
    }
}


void Foam::runGuard::stop(const std::string& wrong, const std::string& expected) const
{
    stopAfterWriting(mesh_, wrong, expected);
}

// ************************************************************************* //
