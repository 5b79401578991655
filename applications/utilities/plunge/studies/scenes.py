# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of cases/: how a run of one is prepared and made. No study knows another way."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
from pathlib import Path
from typing import Callable, Mapping, Sequence

from plunge.studies import REPOSITORY
from plunge.studies.foamFields import times
from plunge.studies.particleRuns import call, isComplete, make as make_particles, override
from plunge.studies.study import Run

MARK = "prepared.json"
SOLVERS = {"meshes": "plungeFoam", "particles": "plungeSPH"}


def once(run: Path, make: Callable[[], object], mark: str = "prepared") -> bool:
    """Makes a run's directory by make(), unless that has come to its end before; what an interrupted one left goes. Was it made?"""
    if (run / mark).exists():
        return False
    shutil.rmtree(run, ignore_errors=True)
    make()
    (run / mark).touch()
    return True


def quietly(*command: str) -> None:
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)} failed:\n{done.stdout[-2000:]}")


def prepareCase(scene: str | Path, run: Path, options: Sequence[str] = (), changes: Mapping[str, str] = {}) -> bool:
    """Makes the directory of a run, in which files take other entries, unless it is there. Was it made?

    scene: a name in cases/, or a directory like one; options: those of plungeCase; changes: text that takes the place of entries."""
    case = REPOSITORY / "cases" / scene

    def make() -> None:
        if (case / "system/plungeParameters").exists():
            quietly("plungeCase", "-case", str(case), "-run", str(run), *options)
        else:
            make_particles(scene, run, *options)
        for file, text in changes.items():
            override(run, file, text)
        (run / MARK).write_text(json.dumps({"case": str(case), "options": list(options)}))

    return once(run, make)


def prepare(run: Run, path: Path, options: Sequence[str] = (), changes: Mapping[str, str] = {}, case: Path | None = None) -> bool:
    """Prepares a point of a study's matrix: its scene, or a case in its place, by its method, resolution and cores, with options and
    changes, and those of its `given`."""
    if (REPOSITORY / "cases" / run.scene / "system/plungeParameters").exists():
        tier, factor = run.grade
        options = ["-solver", SOLVERS[run.method], "-tier", tier, "-resolution", factor, "-np", str(run.cores), *options]
    return prepareCase(case or run.scene, path, [*options, *run.given.get("options", ())], {**changes, **run.given.get("changes", {})})


def command(run: Path, cores: int = 1) -> list[str]:
    """That runs all of a prepared run, or goes on with it."""
    given = json.loads((run / MARK).read_text())
    case = Path(given["case"])
    if (case / "system/plungeParameters").exists():
        # A copy of the case has no Allrun of its own
        return [str(REPOSITORY / "cases/gannetPlunge/Allrun"), "-case", str(case), "-run", str(run), *given["options"]]
    return ["plungeSPH", "-case", str(run), "-threads", str(cores)]


def solve(run: Path, cores: int = 1) -> None:
    """Runs all of a prepared run, or goes on with it, and its tables, without pictures. Its output is in <run>.log."""
    program, *options = command(run, cores)
    if program == "plungeSPH":
        if not isComplete(run):
            call(run, program, *options, mode="a")
        return
    path = run.with_name(f"{run.name}.log")
    # Allrun's own line for a step that is done: the pictures take ten times as long as a coarse dive
    (run / "log.plungePost").write_text("No pictures\n# Allrun: finished\n")
    with path.open("w") as log:
        if subprocess.run([program, *options], stdout=log, stderr=subprocess.STDOUT).returncode:
            raise RuntimeError(f"failed; {path} ends with:\n{path.read_text()[-2000:]}")
    call(run, "plungePost", "--no-pictures")


def kill(run: Path, after: float) -> None:
    """Goes on with a run and kills it after so many seconds [s], unless it comes to its end before."""
    process = subprocess.Popen(command(run), start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        process.wait(timeout=after)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def again(reference: Path, run: Path, solver: str = "plungeFoam") -> None:
    """A run that has all of another one but what the solver made."""
    shutil.rmtree(run, ignore_errors=True)
    shutil.copytree(reference, run, ignore=shutil.ignore_patterns("postProcessing", "results", f"log.{solver}", "log.plungePost",
                                                                  *times(reference)))


def solveScene(run: Run, path: Path, options: Sequence[str] = (), changes: Mapping[str, str] = {}) -> None:
    """Prepares a point of a study's matrix and runs it to its end."""
    prepare(run, path, options, changes)
    solve(path, run.cores)


def spacings(scene: str, of: Mapping[float, Sequence[str]], changes: Mapping[str, str] = {}, variant: str = "", cores: int = 1) -> list[Run]:
    """Runs with particles at several spacings [m], each with the tiers that it belongs to."""
    properties = "constant/particleProperties"
    return [Run(scene, "particles", variant, f"{spacing:g} m", tuple(tiers), cores,
                {"changes": {**changes, properties: f"geometry {{ spacing {spacing!r}; }}\n{changes.get(properties, '')}"}})
            for spacing, tiers in of.items()]
