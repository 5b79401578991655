# SPDX-License-Identifier: GPL-3.0-or-later
"""What the pressure costs with more cells and more processes: PBiCGStab on the matrix of the composite mesh, with the case's own
preconditioner, aggregationMultigrid, with DILU and with OpenFOAM's multigrid. The dive, half immersed at the start, for a few steps at
equal Courant numbers. Each runs alone; profiled times are those of the clock.

DILU and GAMG on the finest mesh take half an hour each: the tier night. Iterations should stay within a factor of 1.3 of those of the coarsest mesh and of one process."""
from pathlib import Path

from plunge.studies.particleRuns import CONTROL
from plunge.studies.scenes import solveScene
from plunge.studies.solverLogs import perStep, readLog
from plunge.studies.stockContest import MULTIGRID, PROFILED, WITH_DILU, iterations, profile
from plunge.studies.study import Done, Quantity, Run, Study, twin

OURS, DILU, GAMG = "aggregationMultigrid", "DILU", "GAMG"
CHANGES = {OURS: {}, DILU: {"system/fvSolution": WITH_DILU}, GAMG: MULTIGRID}
# 32,000 cells, 246,000 and 1.7 million
COARSE, MIDDLE, FINE = "fast", "fast 1.95", "fast 3.7"
STEPS, STEP = 10, 3e-5      # and their length [s] at the factor 1
PROCESSES = {f"{OURS}, {n} processes": n for n in (2, 4, 8)}


def solve(run: Run, path: Path) -> None:
    length = STEP*run.size
    solveScene(run, path, ["-set", "entry.depth=0", "-set", f"travel={25*STEPS*length:g}", "-set", "frames=1"],
               {CONTROL: f"{PROFILED[CONTROL]} adjustTimeStep no; deltaT {length};", **CHANGES[run.variant.split(",")[0]]})


def step(done: Done) -> float:
    """CPU time of a step and a cell [us], without those that pay for what is constructed once."""
    return 1e6*perStep(readLog(done.path / "log.plungeFoam"), 2)/done.cells


def pressure(done: Done) -> float:
    """Share of the solutions for the pressure in the time [%]."""
    return profile(done.path)["lduMatrix::solver.p_rgh"]


def more(done: Done, other: Done) -> float:
    return iterations(done.path)/iterations(other.path)


study = Study(
    title="The pressure's iterations hardly grow with the cells and with the processes", alone=True,
    runs=[*(Run("gannetPlunge", "meshes", variant, size, ("night",) if size == FINE and variant != OURS else ("full",))
            for size in (COARSE, MIDDLE, FINE) for variant in CHANGES),
          *(Run("gannetPlunge", "meshes", variant, size, cores=n) for variant, n in PROCESSES.items() for size in (COARSE, MIDDLE)),
          *(Run("gannetPlunge", "meshes", variant, "fast 0.5", ("quick",)) for variant in CHANGES)],
    solve=solve, sources=("src/pressureSolvers", "src/freeSurfaceFlow", "src/oversetMethods", "etc/methods/meshes"),
    quantities=[
        Quantity("iterations of the pressure", "1", lambda done: iterations(done.path)),
        Quantity("iterations over those on the coarsest mesh", "1", twin(more, resolution=COARSE), most=1.3,
                 judged=lambda run: run.variant == OURS),
        Quantity("iterations over those of one process", "1", twin(more, lambda run: run.cores > 1, variant=OURS), most=1.3),
        Quantity("time of a step and cell", "us", step),
        Quantity("share of the solutions for the pressure", "%", pressure),
        Quantity("time of a step over that with DILU", "1", twin(lambda done, other: step(done)/step(other), lambda run: run.cores == 1,
                                                                variant=DILU))],
    headlines=["iterations over those on the coarsest mesh"])
