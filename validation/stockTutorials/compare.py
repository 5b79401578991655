#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares runs of plungeFoam with runs of a stock solver on the same case: interface, force, motion of the body, CPU time.

Run directories hold ascii fields, a `forces` function object named bodyForces (both as of ./setUp), the field V of
`postProcess -func writeCellVolumes`, and the solver's output in log.solver.
"""
import argparse
import sys
from pathlib import Path
from typing import Dict, List, NamedTuple, Sequence, Tuple

import numpy as np

from plunge.results import CaseError
from plunge.studies.foamFields import numbers, readCells, times
from plunge.studies.resultTable import Row, show, write
from plunge.studies.solverLogs import perStep, readLog

PHASE = "alpha.water"
HOLE = 2                # in the field cellTypes of an overset mesh
FIRST_STEPS = 2         # steps left out of CPU times: they pay for what is constructed once


def interfaceDifference(run: Path, reference: Path, time: str) -> float:
    """Volume between the two interfaces at a time, as a fraction of the liquid's volume. Holes of overset meshes do not count."""
    a, b = (readCells(case / time / PHASE).ravel() for case in (run, reference))
    volume = readCells(reference / time / "V").ravel()
    if (reference / time / "cellTypes").exists():
        volume = volume*(readCells(reference / time / "cellTypes").ravel() != HOLE)
    if not a.size == b.size == volume.size:
        raise CaseError(f"{run}, {reference}: {a.size}, {b.size} cells and {volume.size} volumes at {time}: expected the same mesh")
    return float(np.sum(np.abs(a - b)*volume)/np.sum(b*volume))


def readForces(run: Path) -> Tuple[np.ndarray, np.ndarray]:
    """Times [s] and total force [N] of the function object bodyForces."""
    paths = sorted(run.glob("postProcessing/bodyForces/*/force.dat"), key=lambda path: float(path.parent.name))
    if not paths:
        raise CaseError(f"{run}: expected postProcessing/bodyForces/*/force.dat")
    table = numbers(*paths)
    return table[:, 0], table[:, 1:4]


def resample(time: np.ndarray, values: np.ndarray, at: np.ndarray) -> np.ndarray:
    """Columns of values at other times, linearly."""
    return np.stack([np.interp(at, time, column) for column in values.T], axis=1)


def forceDifference(run: Path, reference: Path) -> float:
    """Root mean square of the difference of the forces over the run, over the reference's root mean square."""
    time, force = readForces(reference)
    difference = resample(*readForces(run), time) - force
    # Steps differ in length.
    weight = np.gradient(time)[:, None] if len(time) > 1 else 1.0
    return float(np.sqrt(np.sum(weight*difference**2)/np.sum(weight*force**2)))


class Motion(NamedTuple):
    """Difference of two motions, and how far the reference moved."""
    position: float     # largest distance between the centres [m]
    travel: float       # [m]
    angle: float        # largest angle between the orientations [rad]
    turn: float         # [rad]


def angles(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Angle between orientations, matrices in rows [rad]; from their distance, which is exact where the angle is small."""
    return 2*np.arcsin(np.clip(np.linalg.norm(a - b, axis=1)/np.sqrt(8), 0, 1))


def motionDifference(run: Path, reference: Path) -> Motion:
    """Compares the motion of the body over the run; the reference's own is counted from its first step."""
    ours, theirs = (readLog(case / "log.solver") for case in (run, reference))
    if any(step.centre is None for step in ours + theirs):
        raise CaseError(f"{run}, {reference}: expected 'report on' in constant/dynamicMeshDict")
    at = np.array([step.time for step in theirs])
    stacked = {name: [np.stack([getattr(step, name) for step in steps]) for steps in (ours, theirs)] for name in ("centre", "orientation")}
    time = np.array([step.time for step in ours])
    centre, orientation = (resample(time, stacked[name][0], at) for name in ("centre", "orientation"))
    centre0, orientation0 = stacked["centre"][1], stacked["orientation"][1]
    return Motion(float(np.linalg.norm(centre - centre0, axis=1).max()),
                  float(np.linalg.norm(centre0 - centre0[0], axis=1).max()),
                  float(angles(orientation, orientation0).max()),
                  float(angles(orientation0, orientation0[:1]).max()))


def cpuPerStep(runs: Sequence[Path]) -> float:
    """CPU time per step [s], without the first steps; of several runs the fastest, the one that was disturbed least."""
    return min(perStep(readLog(run / "log.solver"), FIRST_STEPS) for run in runs)


def rows(name: str, runs: Sequence[Path], references: Sequence[Path]) -> List[Row]:
    """All figures of one case, from repeated runs of plungeFoam and of the stock solver."""
    run, reference = runs[0], references[0]
    cpu = readLog(run / "log.solver")[-1].cpu
    compared = times(reference)
    if not compared or compared != times(run):
        raise CaseError(f"{run}: times {times(run)}: expected those of {reference}, {compared}")

    def row(quantity: str, value: float, unit: str, expected: float, tolerance: float) -> Row:
        holds = "yes" if value <= expected + tolerance else "no"
        return Row(f"{name} to {compared[-1]} s: {quantity}", value, unit, expected, tolerance, holds, cpu)

    differences = [interfaceDifference(run, reference, time) for time in compared]
    found = [row("volume between the interfaces, largest of the run", 100*max(differences), "% of liquid volume", 0, 1),
             row("force, rms of the difference over the run", 100*forceDifference(run, reference), "% of rms force", 0, 1)]
    if readLog(reference / "log.solver")[-1].centre is not None:
        motion = motionDifference(run, reference)
        found.append(row("position of the body, largest difference", 100*motion.position/motion.travel, "% of travel", 0, 1))
        if motion.turn > 1e-6:
            found.append(row("orientation of the body, largest difference", 100*motion.angle/motion.turn, "% of turn", 0, 1))
    ratio = cpuPerStep(runs)/cpuPerStep(references)
    # The tolerance is what repeated runs of one program differ by.
    found.append(row("CPU time per step over the stock solver's", ratio, "1", 1, 0.03))
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=Path, help="holds <case>/plungeFoam.* and <case>/stock.*, the runs")
    parser.add_argument("cases", nargs="+", help="names of the cases")
    parser.add_argument("-result", type=Path, default=Path("result.csv"), help="table to write (default: %(default)s)")
    arguments = parser.parse_args()

    table: List[Row] = []
    for case in arguments.cases:
        found: Dict[str, List[Path]] = {}
        for solver in ("plungeFoam", "stock"):
            found[solver] = sorted(log.parent for log in (arguments.directory / case).glob(f"{solver}.*/**/log.solver"))
            if not found[solver]:
                raise CaseError(f"{arguments.directory / case}: expected {solver}.*/log.solver")
        table += rows(case, found["plungeFoam"], found["stock"])

    # Cases that were not run again keep their rows.
    write(arguments.result, table, keep=lambda quantity: quantity.split()[0] not in arguments.cases)
    show(table)
    return 0 if all(row.holds == "yes" for row in table) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except CaseError as error:
        sys.exit(f"compare.py: {error}")
