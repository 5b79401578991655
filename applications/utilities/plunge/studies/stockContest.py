# SPDX-License-Identifier: GPL-3.0-or-later
"""The dive and OpenFOAM's tutorial floatingBody in plungeFoam and in OpenFOAM's overInterDyMFoam, with as much in common as can be.

Both have the same meshes, time step limits, schemes, tolerances and body, and walls without slip and without a boundary layer's model. The
stock solver has the stencil of OpenFOAM that is the fastest here, and the integrator addedMass, without which it would need outer
iterations. floatingBody, with cells of twice the size, without probes and output, which are no part of the solvers: stock with two outer
iterations and relaxation, which its motion solver needs; plungeFoam with its own stencil and the integrator addedMass in one pass."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import numpy as np

from plunge.results import solver_log
from plunge.studies.dives import AS_STOCK, STOCK_STENCIL
from plunge.studies.particleRuns import CONTROL, call, isComplete, override, setEntry
from plunge.studies.scenes import once
from plunge.studies.signals import Signal
from plunge.studies.solverLogs import readLog
from plunge.studies.tutorials import setUp

OURS, STOCK, REFERENCE = "plungeFoam", "overInterDyMFoam", "quarter steps"
SAME, SINGLE, TUNED = "plungeFoam, stock's mesh and steps", "plungeFoam, single mesh", f"{STOCK}, this case's correctors"
LONGER = "plungeFoam, single mesh, Courant number 4"


PROFILED = {CONTROL: "profiling { active true; }"}
# What every OpenFOAM has for the pressure
WITH_DILU = "solvers { p_rgh { preconditioner DILU; } p_rghFinal { preconditioner DILU; } }"
MULTIGRID = {"system/fvSolution": "solvers { p_rgh { preconditioner { preconditioner GAMG; agglomerator algebraicPair; "
                                  "smoother GaussSeidel; nFinestSweeps 2; scaleCorrection no; nCellsInCoarsestLevel 100; "
                                  "directSolveCoarsest yes; } } p_rghFinal { $p_rgh; relTol 1e-3; } }"}


def _changes(control: str = "", solution: str = "", schemes: str = "") -> dict[str, str]:
    return {**AS_STOCK, CONTROL: f"{PROFILED[CONTROL]} {control}", "system/fvSolution": solution, "system/fvSchemes": schemes}


# The steps that all had when they were compared first, and correctors that are enough for them
_STEPS = "maxCo 1; maxAlphaCo 0.5; maxDeltaT 2e-4;"
_CORRECTORS = "PIMPLE { momentumPredictor yes; nCorrectors 1; }"
_ONE_CYCLE = 'solvers { "alpha.liquid.*" { nAlphaSubCycles 1; } }'
_PROGRAM = "application overInterDyMFoam; libs (overset fvMotionSolvers rigidBody plungeFunctionObjects);"
_SCHEMES = f"ddtSchemes {{ default Euler; }} oversetInterpolation {{ {STOCK_STENCIL} }}"
# Of each dive: its mesh, and what its case has in place of plungeCase's entries
DIVES = {
    OURS: ("auto", _changes()),
    SINGLE: ("single", _changes()),
    LONGER: ("single", _changes("maxCo 4; maxAlphaCo 2; maxDeltaT 8e-4;", 'solvers { "alpha.liquid.*" { nAlphaSubCycles 4; } }')),
    SAME: ("overset", _changes(_STEPS, f"{_CORRECTORS} {_ONE_CYCLE}")),
    STOCK: ("overset", _changes(f"{_PROGRAM} {_STEPS}", f"PIMPLE {{ momentumPredictor no; nCorrectors 3; }} {_ONE_CYCLE} {WITH_DILU}", _SCHEMES)),
    TUNED: ("overset", _changes(f"{_PROGRAM} {_STEPS}", f"{_CORRECTORS} {_ONE_CYCLE} {WITH_DILU}", _SCHEMES)),
    REFERENCE: ("single", _changes("maxCo 0.25; maxAlphaCo 0.125; maxDeltaT 2.5e-5;", _ONE_CYCLE)),
}
FLOATING_END = 0.5  # [s]
FLOATING = {
    STOCK: {"system/fvSchemes": "oversetInterpolation { method trackingInverseDistance; searchBoxDivisions ((64 64 64) (64 64 64)); }"},
    OURS: {
        "system/fvSchemes": "oversetInterpolation { method rigidZones; }",
        "system/fvSolution": "solvers { p_rgh { preconditioner aggregationMultigrid; } p_rghFinal { preconditioner aggregationMultigrid; } } "
                             "PIMPLE { momentumPredictor yes; nOuterCorrectors 1; nCorrectors 2; }",
        CONTROL: "libs (overset fvMotionSolvers rigidBody);",
        "constant/dynamicMeshDict": "sixDoFRigidBodyMotionCoeffs { accelerationRelaxation 1; accelerationDamping 1; "
                                    "solver { type addedMass; } }",
    },
}


def floatingBody(run: Path, variant: str) -> None:
    """Runs the tutorial as one of FLOATING, or as REFERENCE: plungeFoam with a quarter of the Courant numbers."""
    solver = STOCK if variant == STOCK else OURS

    def make() -> None:
        folder = run.with_name(f"{run.name}.tutorial")
        shutil.rmtree(folder, ignore_errors=True)
        setUp("floatingBody", folder, application=solver, coarser=2, endTime=FLOATING_END, writeInterval=2*FLOATING_END).rename(run)
        # They search their cells anew in each step: a third of its time
        setEntry(run, CONTROL, "functions/probes")
        for file, text in FLOATING[solver].items():
            override(run, file, text)
        if variant == REFERENCE:
            override(run, CONTROL, "maxCo 0.375; maxAlphaCo 0.5;")
            override(run, "system/fvSolution", "PIMPLE { momentumPredictor no; nCorrectors 3; }")

    once(run, make)
    if not isComplete(run, solver):
        call(run, solver)


def height(run: Path) -> Signal:
    """Of the body [m], at the ends of the steps."""
    steps = readLog(next(path for path in (run / f"log.{OURS}", run / f"log.{STOCK}") if path.exists()))
    return Signal(np.array([step.time for step in steps]), np.array([step.centre[2] for step in steps]))


def profile(run: Path) -> dict[str, float]:
    """Parts of a step and their shares of the time [%], from the table that PROFILED leaves in the log."""
    lines = re.findall(r"^ *\d+ +[\d.e+-]+ +\d+ +([\d.e+-]+) +[\d.e+-]+   (.+)$", solver_log(run).split("Profile over")[-1], re.M)
    times = {name: float(time) for time, name in lines}
    total = times.pop("total")
    return {name: 100*time/total for name, time in times.items()}


def iterations(run: Path) -> float:
    """Of PBiCGStab, mean of the pressure's solutions."""
    found = [int(n) for n in re.findall(r"Solving for p_rgh,.* No Iterations (\d+)", solver_log(run))]
    return sum(found)/len(found)
