# SPDX-License-Identifier: GPL-3.0-or-later
"""The first milliseconds of the dive in several ways that must give the same; the body meets the surface at 0.4 ms.

- one process and two, all linear systems solved to 1e-12: what is left is multiplied from step to step;
- uninterrupted, and stopped and started again twice;
- killed at arbitrary moments and started again, as often.

Differences are over the field's cells at the end, over its largest value, and over all time steps of the path and the loads, over
their largest value: the largest, and for the processes, where single cells at the interface decide on round-off, the root mean square."""
import random
import re
from dataclasses import replace
from pathlib import Path

import numpy as np

from plunge.studies.foamFields import readCells, times
from plunge.studies.particleRuns import CONTROL, call, converge, override
from plunge.studies.scenes import again, kill, prepare, solve as solveRun
from plunge.studies.study import Done, Quantity, Run, Study

KILLS, DURATION = 5, {"fast": 4e-3, "fast 0.5": 1e-3}    # duration [s]; of 25 m/s and a body of 1 m
EXACT = {CONTROL: "writeFormat ascii; writePrecision 17; timePrecision 12;"}
ONE, TWO, WHOLE, PARTS, KILLED = "one process, converged", "two processes, converged", "uninterrupted", "stopped twice", "killed"
TWIN = {TWO: ONE, PARTS: WHOLE, KILLED: WHOLE}
FIELDS, TABLES = ("alpha.liquid", "U", "p_rgh"), {"path of the body": ("x_m", "z_m"), "loads on the body": ("Fpx_N", "Fpz_N", "My_Nm")}


def solve(run: Run, path: Path) -> None:
    whole = path.parent / replace(run, variant=WHOLE).name
    if run.variant in (ONE, TWO, WHOLE):
        if prepare(run, path, ["-set", f"travel={25*DURATION[run.resolution]:g}", "-set", "frames=4"], EXACT) and run.variant != WHOLE:
            converge(path)
        return solveRun(path)
    again(whole, path)
    if run.variant == PARTS:
        for end in (*times(whole)[:2], times(whole)[-1]):
            override(path, CONTROL, f"endTime {end};")
            call(path, "plungeFoam", mode="a")
        return None
    # After up to four fifths of what the whole run takes
    moments, clock = random.Random(1), float(re.findall(r"ClockTime = (\S+) s", (whole / "log.plungeFoam").read_text())[-1])
    for _ in range(KILLS):
        kill(path, moments.uniform(0.3, 0.8)*clock)
    return solveRun(path)


def difference(what: str, norm):
    def of(done: Done):
        twin = done.beside(variant=TWIN.get(done.run.variant, ""))
        if not twin:
            return None
        if what in FIELDS:
            pairs = [[readCells(each.path / times(each.path)[-1] / what) for each in (done, twin)]]
        else:
            tables = [each.track for each in (done, twin)]
            pairs = [[table[column] for table in tables] for column in TABLES[what]]
        return max(float(norm(ours - theirs)/np.abs(theirs).max()) if ours.shape == theirs.shape else np.inf for ours, theirs in pairs)
    return of


study = Study(
    title="A dive is the same on one process and two, uninterrupted, stopped and killed",
    runs=[*(Run("gannetPlunge", "meshes", variant, "fast", cores=1 + (variant == TWO), needs=needs)
            for variant, needs in ((ONE, ""), (TWO, ""), (WHOLE, ""), (PARTS, WHOLE), (KILLED, WHOLE))),
          *(Run("gannetPlunge", "meshes", variant, "fast 0.5", ("quick",), 1 + (variant == TWO)) for variant in (ONE, TWO))],
    solve=solve, sources=("src/freeSurfaceFlow", "src/oversetMethods", "src/rigidBody", "applications/solvers/plungeFoam"),
    quantities=[Quantity(f"{what}, {name} difference over the largest value", "1", difference(what, norm), reference=0,
                         tolerance=lambda done: 1e-6 if done.run.variant == TWO else 1e-10,
                         judged=lambda run, rms=name != "largest": rms == (run.variant == TWO))
                for what in (*FIELDS, *TABLES)
                for name, norm in (("rms", lambda d: np.sqrt(np.mean(d*d))), ("largest", lambda d: np.abs(d).max()))],
    headlines=["loads on the body, rms difference over the largest value", "loads on the body, largest difference over the largest value"])
