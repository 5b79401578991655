#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same dive in several ways: result.csv.

- one process and two, all linear systems solved to 1e-12: what is left is multiplied from step to step;
- uninterrupted, and stopped and started again twice;
- killed at arbitrary moments and started again by the case's Allrun, as often.

The dive is that of cases/gannetPlunge, tier fast, over its first DURATION; the body meets the surface at 0.4 ms. Differences
are over the field's cells at the end, over its largest value, and over all time steps of the path and the loads, over their
largest value: the largest, and for the processes, where single cells at the interface decide on round-off, the root mean square.
"""
import os
import random
import re
import shutil
import signal
import subprocess
from pathlib import Path
from typing import List, Tuple

import numpy as np

from plunge.results import gather
from plunge.studies.dives import CASE, setUp
from plunge.studies.foamFields import readCells, times
from plunge.studies.particleRuns import CONTROL, call, converge, override
from plunge.studies.resultTable import Row, limit, show, write

FOLDER = Path(__file__).resolve().parent
SOLVER = "plungeFoam"
DURATION, FRAMES = 4e-3, 4          # [s]; of 25 m/s and a body of 1 m
OPTIONS = ("-set", f"dive.travel={25*DURATION:g}", "-set", f"output.frames={FRAMES}")
FIELDS = ("alpha.liquid", "U", "p_rgh")
LOADS = ("Fpx_N", "Fpz_N", "My_Nm")
KILLS, SEED = 5, 1


def dive(name: str, ranks: int = 1, converged: bool = False) -> Path:
    """Runs the case in run/<name>, from where it was stopped."""
    run = FOLDER / "run" / name
    options = ["-np", str(ranks), *OPTIONS]
    if setUp(run, options, {CONTROL: "writeFormat ascii; writePrecision 17; timePrecision 12;"}) and converged:
        converge(run)
    subprocess.run([str(CASE / "Allrun"), "-run", str(run), *options], check=True)
    return run


def again(reference: Path, name: str) -> Path:
    """A run that has all of another one but what the solver made."""
    run = FOLDER / "run" / name
    shutil.copytree(reference, run, ignore=shutil.ignore_patterns("postProcessing", "results", f"log.{SOLVER}", "log.plungePost",
                                                                  *times(reference)))
    return run


def inParts(reference: Path, name: str) -> Path:
    """Stopped and started again at the written times after the first and the second."""
    run = again(reference, name)
    for end in (*times(reference)[:2], times(reference)[-1]):
        override(run, CONTROL, f"endTime {end};")
        call(run, SOLVER, mode="a")
    return run


def killed(reference: Path, name: str) -> Path:
    """Killed KILLS times at arbitrary moments: after up to four fifths of what the whole run takes."""
    run = again(reference, name)
    whole = float(re.findall(r"ClockTime = (\S+) s", (reference / f"log.{SOLVER}").read_text())[-1])
    moments = random.Random(SEED)
    command = [str(CASE / "Allrun"), "-run", str(run), "-np", "1", *OPTIONS]
    for _ in range(KILLS):
        process = subprocess.Popen(command, start_new_session=True)
        try:
            process.wait(timeout=moments.uniform(0.3, 0.8)*whole)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    subprocess.run(command, check=True)
    return run


def differences(what: str, run: Path, reference: Path, most: float, meanSquare: bool = False) -> List[Row]:
    end = times(reference)[-1]
    rows: List[Row] = []

    def judge(name: str, pairs: List[Tuple[np.ndarray, np.ndarray]]) -> None:
        largest, rms = (max(float(norm(ours - theirs)/np.abs(theirs).max()) for ours, theirs in pairs)
                        for norm in (lambda d: np.abs(d).max(), lambda d: np.sqrt(np.mean(d*d))))
        if meanSquare:
            rows.append(limit(f"{what}: {name}, root mean square", rms, "1", most))
            rows.append(Row(f"{what}: {name}, largest", largest, "1"))
        else:
            rows.append(limit(f"{what}: {name}, largest", largest, "1", most))

    for field in FIELDS:
        judge(field, [tuple(readCells(case / end / field) for case in (run, reference))])
    ours, theirs = (gather(case)["trajectory"] for case in (run, reference))
    if len(ours["time_s"]) != len(theirs["time_s"]):
        raise SystemExit(f"{run}: {len(ours['time_s'])} time steps; expected {len(theirs['time_s'])}, those of {reference}")
    for name, columns in (("path of the body", ("x_m", "z_m")), ("loads on the body", LOADS)):
        judge(name, [(ours[c], theirs[c]) for c in columns])
    return rows


def main() -> None:
    serial, parallel = dive("serial", converged=True), dive("parallel", ranks=2, converged=True)
    whole = dive("whole")
    rows = differences("two processes against one", parallel, serial, 1e-6, meanSquare=True)
    rows += differences("stopped and started again twice against uninterrupted", inParts(whole, "parts"), whole, 1e-10)
    rows += differences(f"killed {KILLS} times against uninterrupted", killed(whole, "killed"), whole, 1e-10)
    write(FOLDER / "result.csv", rows)
    show(rows)


if __name__ == "__main__":
    main()
