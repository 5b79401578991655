# SPDX-License-Identifier: GPL-3.0-or-later
"""What a dive costs with plungeFoam and with OpenFOAM's overInterDyMFoam, and how wrong each is; plunge.studies.stockContest says how they
compare. Each runs alone. The stock solver runs with the correctors of its tutorials and with those of this case. Errors are differences to
a dive on a single mesh with a quarter of the time step.

Two processes against one: the same time steps; the efficiency is that of the CPU time, which includes waiting. The pressure's matrix of
the composite mesh, which is not symmetric: PBiCGStab with DILU and with OpenFOAM's multigrid as preconditioner, at two
sizes; the case's own is that of the study pressureSolver. plungeFoam should take half the time of the stock solver, and two processes 85 %
of twice one's."""
from functools import lru_cache
from pathlib import Path

from plunge.studies.dives import AS_STOCK, Difference, Dive
from plunge.studies.particleRuns import CONTROL
from plunge.studies.pictures import draw
from plunge.studies.scenes import solveScene
from plunge.studies.signals import Signal
from plunge.studies.solverLogs import perStep, readLog
from plunge.studies.stockContest import (AS_OURS, AS_TUTORIAL, MULTIGRID, OURS, PROFILED, QUARTER_STEPS, REFERENCE, STOCK, floatingBody, height,
                                         WITH_DILU, iterations, profile)
from plunge.studies.study import Done, Quantity, Run, Study, only, twin

TUNED, ONE, TWO, DILU, GAMG = f"{STOCK}, this case's correctors", "1 process", "2 processes", "DILU", "GAMG"
DIVES = {OURS: {**AS_STOCK, **PROFILED}, STOCK: AS_TUTORIAL, TUNED: AS_OURS, REFERENCE: QUARTER_STEPS}
STEPS = {"fast": (100, 3e-5), "standard": (15, 1e-5), "fast 0.5": (20, 6e-5)}   # number and length [s]
PRECONDITIONERS = {DILU: {"system/fvSolution": WITH_DILU}, GAMG: MULTIGRID}
PARTS = ("lduMatrix::solver.p_rgh", "mesh motion", "interface", "momentum", "overset stencil", "pressure", "unique volume")
dive = lru_cache(maxsize=None)(Dive)


def solve(run: Run, path: Path) -> None:
    if run.scene == "floatingBody":
        return floatingBody(path, run.variant)
    if run.variant in DIVES:
        return solveScene(run, path, ["-mesh", "single" if run.variant == REFERENCE else "overset"], DIVES[run.variant])
    count, length = STEPS[run.resolution]
    changes = {CONTROL: f"adjustTimeStep no; deltaT {length};", **PRECONDITIONERS.get(run.variant, {})}
    solveScene(run, path, ["-set", f"travel={25*count*length:g}", "-set", "frames=1"], changes)


def against(variant: str, value, *of: str, scene: str = "gannetPlunge"):
    """A figure of runs of some variants and that of another one."""
    return twin(value, lambda run: run.variant in of and run.scene == scene, variant=variant)


def error(load: str, norm: str):
    return against(REFERENCE, lambda done, other: float(getattr(getattr(Difference(dive(done.path), dive(other.path)), load), norm)()), *DIVES)


def isDive(run: Run) -> bool:
    return run.scene == "gannetPlunge" and run.variant in DIVES


def step(done: Done) -> float:
    """CPU time of a step [s], without those that pay for what is constructed once."""
    return perStep(readLog(done.path / "log.plungeFoam"), 5)


study = Study(
    title="A dive takes half the time that it takes with the stock overset solver, and is as right", alone=True,
    runs=[*(Run("gannetPlunge", "meshes", variant, "fast", cores=1 + (variant in (REFERENCE, TWO))) for variant in (*DIVES, ONE, TWO)),
          *(Run("gannetPlunge", "meshes", variant, tier) for variant in (DILU, GAMG) for tier in ("fast", "standard")),
          *(Run("gannetPlunge", "meshes", variant, "fast 0.5", ("quick",)) for variant in (DILU, GAMG)),
          *(Run("floatingBody", "meshes", variant, "0.5") for variant in (OURS, STOCK, REFERENCE))],
    solve=solve, sources=("src/freeSurfaceFlow", "src/oversetMethods", "src/rigidBody", "applications/solvers/plungeFoam"),
    quantities=[
        *(Quantity("CPU time of plungeFoam over that of this", "1", against(OURS, lambda done, ours: ours.cpu/done.cpu, STOCK, TUNED, scene=scene),
                   most=0.5) for scene in ("gannetPlunge", "floatingBody")),
        Quantity("speed, largest error over the impact speed", "%", error("speed", "max")),
        *(Quantity(f"{load} load, running mean, {name} error over the largest axial", "%", error(load, norm))
          for load in ("axial", "lateral") for name, norm in (("largest", "max"), ("mean", "mean"))),
        *(Quantity(f"{load} load, rms about its mean over the largest axial", "%", against(
            REFERENCE, lambda done, other, n=load: 100*dive(done.path).noise(n)/float(dive(other.path).mean["axial"].max()), *DIVES))
          for load in ("axial", "lateral")),
        Quantity("liquid's volume, largest error over the body's", "%", only(lambda done: dive(done.path).ledger(), isDive)),
        Quantity("efficiency of two processes", "1", against(ONE, lambda two, one: step(one)/(2*step(two)), TWO), least=0.85),
        Quantity("iterations of the pressure", "1", only(lambda done: iterations(done.path), lambda run: run.variant in (DILU, GAMG))),
        Quantity("time of a step over that with DILU", "1", against(DILU, lambda done, dilu: step(done)/step(dilu), GAMG)),
        Quantity("height of the body, largest error over its way", "%", against(REFERENCE, lambda done, other: 100*float(
            abs(height(done.path).less(height(other.path))).max()/height(other.path).value.ptp()), OURS, STOCK, scene="floatingBody")),
        *(Quantity(f"share of a step: {part}", "%", only(lambda done, p=part: profile(done.path).get(p), lambda run: isDive(run) and run.variant == OURS)) for part in PARTS)],
    headlines=["CPU time of plungeFoam over that of this"],
    figure=lambda done, file: draw(file, [({"xlabel": "time [ms]", "ylabel": f"{load} load on the body, running mean [N]"}, {}, {
        each.run.variant: Signal(1e3*dive(each.path).time, dive(each.path).mean[load])
        for each in done if isDive(each.run)}) for load in ("axial", "lateral")], 2))
