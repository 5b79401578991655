# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenFOAM's tutorials with their own solver and with plungeFoam: only the application differs; what else is changed in both copies,
plunge.studies.tutorials says. Variants are solvers.

Each solver runs twice, alone; the CPU time per step is that of the faster run. Interface and force may differ by 1 %, the motion by 1 % of
its extent; the CPU time per step by what repeated runs of one program differ by, 3 %. The binaries of OpenFOAM may hold a defect that
plungeFoam is built without (src/compilerOptions): Debian's interFoam diverges on floatingObject at 0.376 s."""
import shutil
from pathlib import Path

from plunge.studies.foamFields import times
from plunge.studies.particleRuns import call, isComplete
from plunge.studies.scenes import once
from plunge.studies.study import Quantity, Run, Study, twin
from plunge.studies.tutorials import cpuPerStep, forceDifference, interfaceDifference, motionDifference, setUp, stepsOf

OURS, STOCK = "plungeFoam", {"damBreak": "interFoam", "floatingObject": "interFoam", "floatingBody": "overInterDyMFoam"}
# Tutorial, cells that are larger by, end and write interval [s]
CASES = (("damBreak", 1, 1, 0.05, "full"), ("floatingObject", 1, 0.3, 0.1, "full"), ("floatingBody", 2, 0.05, 0.01, "full"),
         ("damBreak", 2, 0.1, 0.05, "quick"))


def again(path: Path) -> Path:
    return path.with_name(f"{path.name}.again")


def solve(run: Run, path: Path) -> None:
    def make() -> None:
        folder = path.with_name(f"{path.name}.tutorial")
        shutil.rmtree(folder, ignore_errors=True)
        setUp(run.scene, folder, application=run.variant, **run.given).rename(path)

    once(path, make)
    once(again(path), lambda: shutil.copytree(path, again(path), ignore=shutil.ignore_patterns("prepared")))
    for case in (path, again(path)):
        if not isComplete(case, run.variant):
            call(case, run.variant)
    call(path, "postProcess", "-func", "writeCellVolumes")


def against(value):
    """A figure of two cases, ours and the stock solver's."""
    return lambda done: twin(lambda ours, stock: value(ours.path, stock.path), variant=STOCK[done.run.scene])(done)


def moves(value):
    """A figure of the difference of two motions, where there is one."""
    return against(lambda ours, stock: value(motionDifference(ours, stock)) if stepsOf(stock)[-1].centre is not None else None)


def perStep(path: Path) -> float:
    return cpuPerStep([path, again(path)])


study = Study(
    title="The stock tutorials run in plungeFoam after changing the application alone, with the same result", alone=True,
    runs=[Run(tutorial, "meshes", solver, f"{1/coarser:g}", (tier,), given={"coarser": coarser, "endTime": end, "writeInterval": write})
          for tutorial, coarser, end, write, tier in CASES for solver in (STOCK[tutorial], OURS)],
    solve=solve, sources=("src/freeSurfaceFlow", "src/oversetMethods", "applications/solvers/plungeFoam"),
    quantities=[
        Quantity("volume between the interfaces, largest, over the liquid's", "%", against(
            lambda ours, stock: 100*max(interfaceDifference(ours, stock, time) for time in times(stock))), 0, tolerance=1),
        Quantity("force, rms of the difference over the rms force", "%", against(lambda ours, stock: 100*forceDifference(ours, stock)), 0, tolerance=1),
        Quantity("position of the body, largest difference over the travel", "%", moves(lambda m: 100*m.position/m.travel), 0, tolerance=1),
        Quantity("orientation of the body, largest difference over the turn", "%", moves(
            lambda m: 100*m.angle/m.turn if m.turn > 1e-6 else None), 0, tolerance=1),
        Quantity("CPU time of a step over the stock solver's", "1", against(lambda ours, stock: perStep(ours)/perStep(stock)), most=1.03)],
    headlines=["volume between the interfaces, largest, over the liquid's"])
