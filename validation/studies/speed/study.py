# SPDX-License-Identifier: GPL-3.0-or-later
"""What a dive costs with plungeFoam and with OpenFOAM's overInterDyMFoam, and how wrong each is; plunge.studies.stockContest says how they
compare. Each runs alone. plungeFoam is as plungeCase makes it, on a background that follows the body, and on a single mesh; the stock
solver, which can do neither, stands on a background along the path, with Euler's steps at the Courant number 1, its tutorials' correctors or
those that are enough here. Its errors are larger than ours; steps of the Courant number 4 bring ours nearer to them. plungeFoam on that mesh
with those steps says what is gained in a step, and what by the method. Errors are differences to a dive on a single mesh with steps eight
times as short.

Judged, of each way of ours: a fifth of the time of the stock solver as its tutorials have it, 0.35 of that of the best tuned, with no larger
mean error of the axial load than the latter's. Beside these: half of the time for OpenFOAM's tutorial floatingBody with the same steps; the
tier standard in 20 minutes on two cores; two processes, which include waiting in their CPU time, at an efficiency of 90 %."""
from functools import lru_cache
from pathlib import Path

from plunge.studies.dives import Difference, Dive
from plunge.studies.particleRuns import CONTROL
from plunge.studies.pictures import draw
from plunge.studies.scenes import solveScene
from plunge.studies.signals import Signal
from plunge.studies.solverLogs import perStep, readLog
from plunge.studies.stockContest import DIVES, LONGER, OURS, REFERENCE, SAME, SINGLE, STOCK, TUNED, floatingBody, height, profile
from plunge.studies.study import Done, Quantity, Run, Study, only, twin

ONE, TWO = "1 process", "2 processes"
COUNT, STEP = 100, 3e-5     # time steps [-], [s]
PARTS = ("lduMatrix::solver.p_rgh", "mesh motion", "interface", "momentum", "overset stencil", "pressure", "unique volume")
WAYS = OURS, SINGLE, LONGER
dive = lru_cache(maxsize=None)(Dive)


def solve(run: Run, path: Path) -> None:
    if run.scene == "floatingBody":
        return floatingBody(path, run.variant)
    if run.variant in DIVES:
        mesh, changes = DIVES[run.variant]
        return solveScene(run, path, ["-mesh", mesh], changes)
    solveScene(run, path, ["-set", f"travel={25*COUNT*STEP:g}", "-set", "frames=1"], {CONTROL: f"adjustTimeStep no; deltaT {STEP};"})


def against(variant: str, value, *of: str, scene: str = "gannetPlunge"):
    """A figure of runs of some variants and that of another one."""
    return twin(value, lambda run: run.variant in of and run.scene == scene, variant=variant)


def error(load: str, norm: str):
    return against(REFERENCE, lambda done, other: float(getattr(getattr(Difference(dive(done.path), dive(other.path)), load), norm)()), *DIVES)


def meanError(done: Done) -> float:
    """Of the axial load [%], against the reference."""
    return float(Difference(dive(done.path), dive(done.beside(variant=REFERENCE).path)).axial.mean())


def isDive(run: Run) -> bool:
    return run.scene == "gannetPlunge" and run.variant in DIVES


def step(done: Done) -> float:
    """CPU time of a step [s], without those that pay for what is constructed once."""
    return perStep(readLog(done.path / "log.plungeFoam"), 5)


study = Study(
    title="A dive takes a fifth of the time that it takes with the stock overset solver, and is as right", alone=True,
    runs=[*(Run("gannetPlunge", "meshes", variant, "fast", cores=1 + (variant in (REFERENCE, TWO))) for variant in (*DIVES, ONE, TWO)),
          Run("gannetPlunge", "meshes", OURS, "standard", cores=2),
          *(Run("gannetPlunge", "meshes", variant, "fast 0.5", ("quick",), given={"options": ["-set", "travel=0.2"]}) for variant in (OURS, SAME)),
          *(Run("floatingBody", "meshes", variant, "0.5") for variant in (OURS, STOCK, REFERENCE))],
    solve=solve, sources=("src/freeSurfaceFlow", "src/oversetMethods", "src/rigidBody", "applications/solvers/plungeFoam", "etc/methods"),
    quantities=[
        Quantity("CPU time over that of the stock solver, as in its tutorials", "1", against(STOCK, lambda ours, done: ours.cpu/done.cpu, *WAYS), most=0.2),
        Quantity("CPU time over that of the stock solver, best tuned", "1", against(TUNED, lambda ours, done: ours.cpu/done.cpu, *WAYS), most=0.35),
        Quantity("mean error of the axial load over that of the stock solver, best tuned", "1",
                 against(TUNED, lambda ours, done: meanError(ours)/meanError(done), *WAYS), most=1),
        Quantity("CPU time of plungeFoam over that of this, same steps", "1", against(OURS, lambda done, ours: ours.cpu/done.cpu, STOCK, scene="floatingBody"), most=0.5),
        Quantity("CPU time over that of plungeFoam on the same mesh with the same steps", "1",
                 against(SAME, lambda done, same: done.cpu/same.cpu, STOCK, TUNED)),
        Quantity("time from the scene to the tables on two cores", "min", only(lambda done: done.record["wall_s"]/60, lambda run: run.resolution == "standard"), most=20),
        Quantity("time steps", "1", only(lambda done: done.steps, isDive)),
        Quantity("speed, largest error over the impact speed", "%", error("speed", "max")),
        *(Quantity(f"{load} load, running mean, {name} error over the largest axial", "%", error(load, norm))
          for load in ("axial", "lateral") for name, norm in (("largest", "max"), ("mean", "mean"))),
        *(Quantity(f"{load} load, rms about its mean over the largest axial", "%", against(
            REFERENCE, lambda done, other, n=load: 100*dive(done.path).noise(n)/float(dive(other.path).mean["axial"].max()), *DIVES))
          for load in ("axial", "lateral")),
        Quantity("liquid's volume, largest error over the body's", "%", only(lambda done: dive(done.path).ledger(), isDive)),
        Quantity("efficiency of two processes", "1", against(ONE, lambda two, one: step(one)/(2*step(two)), TWO), least=0.9),
        Quantity("height of the body, largest error over its way", "%", against(REFERENCE, lambda done, other: 100*float(
            abs(height(done.path).less(height(other.path))).max()/height(other.path).value.ptp()), OURS, STOCK, scene="floatingBody")),
        *(Quantity(f"share of a step: {part}", "%", only(lambda done, p=part: profile(done.path).get(p), lambda run: isDive(run) and run.variant in (OURS, SINGLE)))
          for part in PARTS)],
    headlines=["CPU time over that of the stock solver, as in its tutorials", "CPU time over that of the stock solver, best tuned"],
    figure=lambda done, file: draw(file, [({"xlabel": "time [ms]", "ylabel": f"{load} load on the body, running mean [N]"}, {}, {
        each.run.variant: Signal(1e3*dive(each.path).time, dive(each.path).mean[load])
        for each in done if isDive(each.run)}) for load in ("axial", "lateral")], 2))
