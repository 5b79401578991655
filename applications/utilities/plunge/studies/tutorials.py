# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenFOAM's tutorials, copied, meshed and ready to run, and the comparison of two runs of one: interface, force, motion of the body.

Dictionaries keep what the tutorial says, but for
- code that OpenFOAM would compile at run time, which some builds refuse: the body's moment of inertia is given as numbers, and a
  function object that only prints the mean of alpha.water is left out;
- damBreak's sampling at each step, which would hide the solver's own time;
- a function object that writes the force on the body (damBreak: on the walls) after each step;
- what is asked for."""

from __future__ import annotations

import gzip
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple, Sequence

import numpy as np

from plunge.results import CaseError
from plunge.studies.foamFields import numbers, readCells, times  # noqa: F401: for tests
from plunge.studies.particleRuns import CONTROL, call, override, setEntry
from plunge.studies.solverLogs import Step, perStep, readLog

# Where it is in multiphase/, the directory that the solver runs in, and the patches of the force
TUTORIALS = {
    "damBreak": ("interFoam/laminar/damBreak/damBreak", ".", "leftWall rightWall lowerWall"),
    "floatingObject": ("interFoam/RAS/floatingObject", ".", "floatingObject"),
    "floatingBody": ("overInterDyMFoam/floatingBody", "background", "floatingObject"),
}
PHASE = "alpha.water"
HOLE = 2                # in the field cellTypes of an overset mesh
FIRST_STEPS = 2         # steps left out of CPU times: they pay for what is constructed once


def installed() -> Path:
    """The folder multiphase of the tutorials; Debian has them in a package of their own, too."""
    found = Path(os.environ.get("FOAM_TUTORIALS", "")) / "multiphase"
    if not found.is_dir():
        listing = subprocess.run(["dpkg", "-L", "openfoam-examples"], capture_output=True, text=True).stdout
        found = next((Path(line) for line in listing.splitlines() if line.endswith("/multiphase")), found)
    if not found.is_dir():
        raise CaseError(f"no tutorials in '{found}': expected those of OpenFOAM, in $FOAM_TUTORIALS or Debian's package openfoam-examples")
    return found


def coarsen(case: Path, factor: float) -> None:
    """Divides the cell counts in the lines `hex (...) (nx ny nz)` of blockMeshDict."""
    path = case / "system/blockMeshDict"

    def fewer(match: re.Match[str]) -> str:
        return f"{match[1]}({' '.join(str(max(1, int(int(n)/factor + 0.5))) for n in match[2].split())})"

    path.write_text(re.sub(r"(hex\s*\([^)]*\)\s*)\(([\d ]+)\)", fewer, path.read_text()))


def giveInertia(case: Path) -> None:
    """What floatingBody's code computes: a cuboid's m (Ly^2 + Lz^2)/12 and so on."""
    path = case / "constant/dynamicMeshDict"
    text = path.read_text()
    side = {name: float(re.search(rf"^\s*{name}\s+([\d.e+-]+);", text, re.M)[1]) for name in ("Lx", "Ly", "Lz", "rhoSolid")}
    x, y, z, rho = side.values()
    m = rho*x*y*z
    moments = " ".join(f"{m*of/12:.15g}" for of in (y*y + z*z, x*x + z*z, x*x + y*y))
    setEntry(case, "constant/dynamicMeshDict", "sixDoFRigidBodyMotionCoeffs/momentOfInertia", f"({moments})")


def setUp(tutorial: str, directory: Path, application: str = "", endTime: float = 0, deltaT: float = 0, writeInterval: float = 0,
          coarser: float = 1) -> Path:
    """The directory to run the solver in. deltaT: fixed steps [s] in place of Courant numbers; coarser: cells that are larger by it."""
    source, part, patches = TUTORIALS[tutorial]
    if directory.exists():
        raise CaseError(f"{directory} exists: expected a new directory")
    shutil.copytree(installed() / source, directory)
    for path in directory.rglob("*"):
        path.chmod(path.stat().st_mode | 0o200)
        if path.suffix == ".gz":
            path.with_suffix("").write_bytes(gzip.decompress(path.read_bytes()))
            path.unlink()
    case = directory / part

    if tutorial == "floatingBody":
        setEntry(case, CONTROL, "functions/alphaVol")
        giveInertia(case)
    if tutorial == "damBreak":
        control = case / CONTROL
        control.write_text(re.sub(r"^#sinclude.*\n", "", control.read_text(), flags=re.M))
    steps = {"adjustTimeStep": "no", "deltaT": deltaT} if deltaT else {}
    for entry, value in {"application": application, "endTime": endTime, "writeInterval": writeInterval, **steps, "writePrecision": 12}.items():
        if value:
            override(case, CONTROL, f"{entry} {value};")
    override(case, CONTROL, f"functions {{ bodyForces {{ type forces; libs (forces); patches ({patches}); CofR (0 0 0); "
                            "writeControl timeStep; writeInterval 1; } }")

    body = directory / "floatingBody"
    for mesh in (case, body) if tutorial == "floatingBody" else (case,):
        coarsen(mesh, coarser)
    for program in {
        "damBreak": ("blockMesh",),
        "floatingObject": ("blockMesh", "topoSet", "subsetMesh -overwrite c0 -patch floatingObject"),
        "floatingBody": (f"blockMesh -case {body}", f"topoSet -case {body}", f"subsetMesh -case {body} -overwrite c0 -patch floatingObject",
                         "blockMesh", f"mergeMeshes . {body} -overwrite", "topoSet"),
    }[tutorial]:
        call(case, *program.split(), mode="a")
    if (case / "0.orig").exists():
        shutil.copytree(case / "0.orig", case / "0")
    else:
        shutil.copy(case / "0/alpha.water.orig", case / "0/alpha.water")
    call(case, "setFields")
    return case


def interfaceDifference(run: Path, reference: Path, time: str) -> float:
    """Volume between the two interfaces at a time, as a fraction of the liquid's volume. Holes of overset meshes do not count."""
    a, b = (readCells(case / time / PHASE).ravel() for case in (run, reference))
    volume = readCells(reference / time / "V").ravel()
    if (reference / time / "cellTypes").exists():
        volume = volume*(readCells(reference / time / "cellTypes").ravel() != HOLE)
    if not a.size == b.size == volume.size:
        raise CaseError(f"{run}, {reference}: {a.size}, {b.size} cells and {volume.size} volumes at {time}: expected the same mesh")
    return float(np.sum(np.abs(a - b)*volume)/np.sum(b*volume))


def readForces(run: Path) -> tuple[np.ndarray, np.ndarray]:
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


def stepsOf(case: Path) -> list[Step]:
    """What its solver has printed, into log.solver or log.<its name>."""
    return readLog(next(path for name in ("solver", "plungeFoam", "interFoam", "overInterDyMFoam") if (path := case / f"log.{name}").exists()))


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
    ours, theirs = (stepsOf(case) for case in (run, reference))
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
    return min(perStep(stepsOf(run), FIRST_STEPS) for run in runs)
