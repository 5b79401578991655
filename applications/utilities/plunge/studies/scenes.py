# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of cases/: how a run of one is prepared and made. No study knows another way."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
from pathlib import Path
from typing import Callable, Mapping, Sequence

from plunge.studies import REPOSITORY
from plunge.studies.foamFields import times
from plunge.studies.particleRuns import call, override
from plunge.studies.study import Run

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

    scene: a name in cases/, a directory like one or a scene file; options: those of plungeCase; changes: text that takes the place of
    entries."""
    def make() -> None:
        quietly("plungeCase", str(REPOSITORY / "cases" / scene), "-run", str(run), *options)
        for file, text in changes.items():
            override(run, file, text)

    return once(run, make)


def prepare(run: Run, path: Path, options: Sequence[str] = (), changes: Mapping[str, str] = {}, scene: Path | None = None) -> bool:
    """Prepares a point of a study's matrix: its scene, or another in its place, by its method, resolution and cores, with options and
    changes, and those of its `given`."""
    tier, factor = run.grade if run.graded else ("fast", "1")
    options = ["-method", run.method, "-tier", tier, "-resolution", factor, "-np", str(run.cores), *options]
    return prepareCase(scene or run.scene, path, [*options, *run.given.get("options", ())], {**changes, **run.given.get("changes", {})})


def solve(run: Path) -> None:
    """Runs all of a prepared run, or goes on with it, and its tables, without pictures. Its output is in <run>.log."""
    path = run.with_name(f"{run.name}.log")
    # Allrun's own line for a step that is done: the pictures take ten times as long as a coarse dive
    (run / "log.plungePost").write_text("No pictures\n# Allrun: finished\n")
    with path.open("w") as log:
        if subprocess.run([str(run / "Allrun")], stdout=log, stderr=subprocess.STDOUT).returncode:
            raise RuntimeError(f"failed; {path} ends with:\n{path.read_text()[-2000:]}")
    if (run / "postProcessing/trajectory").exists():
        call(run, "plungePost", "-noPictures")


def kill(run: Path, after: float) -> None:
    """Goes on with a run and kills it after so many seconds [s], unless it comes to its end before."""
    process = subprocess.Popen([str(run / "Allrun")], start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
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
    solve(path)


def spacings(scene: str, of: Mapping[float, Sequence[str]], changes: Mapping[str, str] = {}, variant: str = "", cores: int = 1) -> list[Run]:
    """Runs with particles at several spacings [m], each with the tiers that it belongs to."""
    properties = "constant/particleProperties"
    return [Run(scene, "particles", variant, f"{spacing:g} m", tuple(tiers), cores,
                {"changes": {**changes, properties: f"geometry {{ spacing {spacing!r}; }}\n{changes.get(properties, '')}"}})
            for spacing, tiers in of.items()]
