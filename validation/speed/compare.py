#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The dive of cases/gannetPlunge, tier fast, by plungeFoam and by overInterDyMFoam: result.csv, docs/figures/speed.png.

Each program of a pair has a core of its own at the same time, the same meshes, time step limits, schemes, tolerances and body, and walls
without slip and without a boundary layer's model. The
stock solver has the stencil of OpenFOAM that is the fastest here, and the integrator addedMass, without which it would need outer
iterations; it runs once with the correctors of its tutorials and once with those of this case. Errors are differences to a dive
on a single mesh (validation/singleMeshTwin) with a quarter of the time step.

Two processes against one: the same time steps, alternately; the efficiency is that of the CPU time, which includes waiting.

The pressure's matrix of the composite mesh, which is not symmetric: PBiCGStab with DILU, the case's own, and with OpenFOAM's
multigrid as preconditioner, at two sizes.

OpenFOAM's tutorial floatingBody with cells of twice the size, without probes and output, which are no part of the solvers: stock with
two outer iterations and relaxation, which its motion solver needs, and the same stencil as above; plungeFoam with its own stencil and
the integrator addedMass in one pass. Errors are differences to plungeFoam with a quarter of the Courant numbers.
"""
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Dict, List, NamedTuple, Tuple

import numpy as np

from plunge.results import CaseError, cell_count, cpu_seconds, solver_log
from plunge.studies.dives import AS_STOCK, STOCK_STENCIL, WINDOW, Difference, Dive, finish, start
from plunge.studies.particleRuns import CONTROL, call, isComplete, override
from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row, least, limit, show, write
from plunge.studies.solverLogs import Step, perStep, readLog

HERE = Path(__file__).resolve().parent
FIGURE = HERE.parents[1] / "docs/figures/speed.png"
RUNS = HERE / "run"
REFERENCE = RUNS / "reference"
STOCK = {
    **AS_STOCK,
    CONTROL: "application overInterDyMFoam; libs (overset fvMotionSolvers rigidBody plungeFunctionObjects);",
    "system/fvSchemes": f"oversetInterpolation {{ {STOCK_STENCIL} }}",
}
FLOATING_END = 0.5  # [s]
FLOATING = {
    "overInterDyMFoam": {"system/fvSchemes": "oversetInterpolation { method trackingInverseDistance; "
                                             "searchBoxDivisions ((64 64 64) (64 64 64)); }"},
    "plungeFoam": {
        "system/fvSchemes": "oversetInterpolation { method rigidZones; }",
        "system/fvSolution": "PIMPLE { momentumPredictor yes; nOuterCorrectors 1; nCorrectors 2; }",
        CONTROL: "libs (overset fvMotionSolvers rigidBody);",
        "constant/dynamicMeshDict": "sixDoFRigidBodyMotionCoeffs { accelerationRelaxation 1; accelerationDamping 1; "
                                    "solver { type addedMass; } }",
    },
}
TUTORIAL = {"system/fvSolution": "PIMPLE { momentumPredictor no; nCorrectors 3; }"}
QUARTER_STEPS = {CONTROL: "maxCo 0.25; maxAlphaCo 0.125; maxDeltaT 2.5e-5;"}
FIRST_STEPS = 5             # left out: they pay for what is constructed once
PROCESSES = 2
MULTIGRID = {"system/fvSolution": "solvers { p_rgh { preconditioner { preconditioner GAMG; agglomerator algebraicPair; "
                                  "smoother GaussSeidel; nFinestSweeps 2; scaleCorrection no; nCellsInCoarsestLevel 100; "
                                  "directSolveCoarsest yes; } } p_rghFinal { $p_rgh; relTol 1e-3; } }"}
SPEED = 25  # [m/s], of a body of 1 m
TIERS = {"fast": (100, 3e-5), "standard": (15, 1e-5)}   # steps and their length [s]


class Contest(NamedTuple):
    """A stock solver beside plungeFoam."""
    name: str
    stock: Path
    ours: Path
    changes: Dict[str, str]


CONTESTS = (
    Contest("overInterDyMFoam", RUNS / "stock", RUNS / "plungeFoam-1", {**STOCK, **TUTORIAL}),
    Contest("overInterDyMFoam with this case's correctors", RUNS / "stock-tuned", RUNS / "plungeFoam-2", STOCK),
)


def profile(run: Path) -> List[Tuple[str, float]]:
    """Parts of a step and their shares of the time [%], from the table that `profiling { active true; }` leaves in the log."""
    lines = re.findall(r"^ *\d+ +[\d.e+-]+ +\d+ +([\d.e+-]+) +[\d.e+-]+   (.+)$", solver_log(run).split("Profile over")[-1], re.M)
    times = {name: float(time) for time, name in lines}
    total = times.pop("total")
    return [(name, 100*time/total) for name, time in times.items()]


def accuracy(name: str, dive: Dive, reference: Dive) -> List[Row]:
    apart = Difference(dive, reference)
    rows = [Row(f"{name}: time steps", str(len(dive.time) - 1), "1", cpu_s=f"{cpu_seconds(dive.run):.0f}"),
            Row(f"{name}: speed, largest error over the impact speed", float(apart.speed.max()), "%")]
    for load in ("axial", "lateral"):
        error = getattr(apart, load)
        rows += [Row(f"{name}: {load} load, means over {1e3*WINDOW:g} ms, {what} error over the largest axial", float(value), "%")
                 for what, value in (("largest", error.max()), ("mean", error.mean()))]
        rows.append(Row(f"{name}: {load} load, rms about its mean over {1e3*WINDOW:g} ms, over the largest axial load",
                        100*dive.noise(load)/apart.peak, "%"))
    return rows + [Row(f"{name}: largest error of the liquid's volume over the body's", dive.ledger(), "%")]


def stepTime(run: Path) -> float:
    """CPU time of a step of a dive [s]: of one process, which in parallel never sleeps."""
    return perStep(readLog(run / "log.plungeFoam"), FIRST_STEPS)


def fixedSteps(tier: str, processes: int, changes: Dict[str, str] = {}) -> "Tuple[List[str], Dict[str, str]]":
    """Options and changes of the case for the first steps of the dive."""
    count, length = TIERS[tier]
    options = ["-np", str(processes), "-tier", tier, "-set", f"dive.travel={SPEED*count*length:g}", "-set", "output.frames=1"]
    return options, {CONTROL: f"adjustTimeStep no; deltaT {length}; profiling {{ active true; }}", **changes}


def efficiency() -> List[Row]:
    """Of PROCESSES processes on as many cores."""
    found: Dict[int, List[float]] = {1: [], PROCESSES: []}
    for turn in (1, 2):
        for count in found:
            run = RUNS / f"processes-{count}-{turn}"
            finish(start(run, *fixedSteps("fast", count)))
            found[count].append(stepTime(run))
    serial, parallel = (min(times) for times in found.values())
    return [least(f"{PROCESSES} processes: efficiency against one", serial/(PROCESSES*parallel), "1", 0.85)]


def iterations(run: Path) -> float:
    """Of PBiCGStab, mean of the pressure's solutions."""
    found = [int(n) for n in re.findall(r"Solving for p_rgh,.* No Iterations (\d+)", solver_log(run))]
    return sum(found)/len(found)


def pressureSolvers() -> List[Row]:
    """Side by side, each preconditioner on one core."""
    rows: List[Row] = []
    for tier in TIERS:
        runs = {name: RUNS / f"{name}-{tier}" for name in ("DILU", "GAMG")}
        finish(*(start(run, *fixedSteps(tier, 1, MULTIGRID if name == "GAMG" else {})) for name, run in runs.items()))
        cells = cell_count(runs["DILU"])
        rows += [Row(f"pressure, {cells} cells, {name}: iterations", iterations(run), "1") for name, run in runs.items()]
        rows.append(Row(f"pressure, {cells} cells: time of a step with GAMG over that with DILU",
                        stepTime(runs["GAMG"])/stepTime(runs["DILU"]), "1"))
    return rows


def heights(steps: List[Step]) -> Tuple[np.ndarray, np.ndarray]:
    """Times [s] and heights of the body [m] at the ends of the steps."""
    return np.array([step.time for step in steps]), np.array([step.centre[2] for step in steps])


def floatingBody() -> List[Row]:
    """The tutorial, side by side."""
    folder = RUNS / "floatingBody"
    if not folder.exists():
        subprocess.run([str(HERE.parent / "stockTutorials/setUp"), "-coarser", "2", "-endTime", str(FLOATING_END), "-writeInterval",
                        str(2*FLOATING_END), "floatingBody", str(folder / "ready")], check=True, stdout=subprocess.DEVNULL)
        # They search their cells anew in each step: a third of its time
        call(folder / "ready/background", "foamDictionary", "-disableFunctionEntries", "-entry", "functions/probes", "-remove", CONTROL)
    runs = {name: folder / name for name in (*FLOATING, "reference")}
    for name, run in runs.items():
        if not run.exists():
            shutil.copytree(folder / "ready/background", run)
            for file, text in FLOATING["plungeFoam" if name == "reference" else name].items():
                override(run, file, text)
            if name == "reference":
                override(run, CONTROL, "maxCo 0.375; maxAlphaCo 0.5;")
                override(run, "system/fvSolution", "PIMPLE { momentumPredictor no; nCorrectors 3; }")

    def solve(name: str) -> None:
        solver = "plungeFoam" if name == "reference" else name
        if not isComplete(runs[name], solver):
            call(runs[name], solver)

    with ThreadPoolExecutor() as pool:
        list(pool.map(solve, FLOATING))
    solve("reference")

    time, z = heights(readLog(runs["reference"] / "log.plungeFoam"))
    logs = {name: readLog(runs[name] / f"log.{name}") for name in FLOATING}
    cpu = {name: steps[-1].cpu for name, steps in logs.items()}
    ratio = cpu["plungeFoam"]/cpu["overInterDyMFoam"]
    rows = [limit("floatingBody: CPU time of plungeFoam over that of overInterDyMFoam", ratio, "1", 0.5)]
    for name, steps in logs.items():
        at, ours = heights(steps)
        error = np.abs(np.interp(at, time, z) - ours).max()
        rows.append(Row(f"floatingBody: {name}, height of the body, largest error over its way", 100*float(error/np.ptp(z)), "%"))
        rows.append(Row(f"floatingBody: {name}, time steps", str(len(steps)), "1", cpu_s=f"{cpu[name]:.0f}"))
    return rows


def draw(dives: Dict[str, Dive], cost: Dict[str, float]) -> None:
    picture, axes = pyplot.subplots(1, 3, figsize=(15, 4.5))
    for number, (name, dive) in enumerate(dives.items()):
        for axis, load in zip(axes, ("axial", "lateral")):
            color = "black" if dive.run == REFERENCE else f"C{number}"
            axis.plot(1e3*dive.time[2:], dive.load[load][2:], color=color, linewidth=0.4, alpha=0.5)
            axis.plot(1e3*dive.time, dive.mean[load], color=color, linewidth=1, label=name)
            axis.set(xlabel="time [ms]", ylabel=f"{load} load on the body [N]")
    axes[0].set(ylim=(-20, 180))
    axes[1].set(ylim=(-20, 50))
    axes[0].legend(fontsize="small")
    axes[0].set_title(f"Thin: as computed; thick: means over {1e3*WINDOW:g} ms", fontsize="medium")
    axes[2].barh(list(cost), list(cost.values()), color=[f"C{i + 1}" for i in range(len(cost))])
    axes[2].invert_yaxis()
    axes[2].set_yticks([])
    for i, (name, value) in enumerate(cost.items()):
        axes[2].text(0.02, i, f"{name}: {value:.2f}", va="center", fontsize="small")
    axes[2].set(xlabel="CPU time of the dive over overInterDyMFoam's")
    picture.tight_layout()
    picture.savefig(FIGURE, dpi=90)


def main() -> None:
    profiled = {**AS_STOCK, CONTROL: "profiling { active true; }"}
    for contest in CONTESTS:
        finish(start(contest.ours, ["-np", "1"], profiled), start(contest.stock, ["-np", "1"], contest.changes))
    rows = efficiency() + pressureSolvers() + floatingBody()
    finish(start(REFERENCE, ["-np", str(PROCESSES), "-mesh", "single"], {**AS_STOCK, **QUARTER_STEPS}))

    reference, ours = Dive(REFERENCE), Dive(CONTESTS[0].ours)
    found = [Row("cells", str(cell_count(ours.run)), "1"), Row("reference: cells", str(cell_count(REFERENCE)), "1"),
             Row("reference: time steps", str(len(reference.time) - 1), "1")]
    cost = {"plungeFoam": 0.0}
    for contest in CONTESTS:
        cpu = {run: cpu_seconds(run) for run in (contest.ours, contest.stock)}
        ratio = cpu[contest.ours]/cpu[contest.stock]
        found.append(limit(f"CPU time of plungeFoam over that of {contest.name}", ratio, "1", 0.5))
        if contest is CONTESTS[0]:
            cost.update({"plungeFoam": ratio, contest.name: 1.0})
        else:
            cost[contest.name] = cost["plungeFoam"]/ratio
    dives = {"reference": reference, "plungeFoam": ours, **{contest.name: Dive(contest.stock) for contest in CONTESTS}}
    for name, dive in dives.items():
        if dive is not reference:
            found += accuracy(name, dive, reference)
    found += rows
    found += [Row(f"plungeFoam: share of a step, {part}", share, "%") for part, share in profile(ours.run)]
    write(HERE / "result.csv", found)
    show(found)
    draw(dives, cost)


if __name__ == "__main__":
    try:
        main()
    except CaseError as error:
        sys.exit(f"compare.py: {error}")
