# SPDX-License-Identifier: GPL-3.0-or-later
"""Every tutorial of interFoam, interIsoFoam and overInterDyMFoam, run for some steps by its own solver and by plungeFoam.

A tutorial is set up by its own Allrun, on one core, on a mesh whose block counts are divided by a factor. Between the two runs the entry
application is all that differs. Both have entries of system/controlDict that end them after some steps and write all digits; both solve all
linear systems to 1e-12, for a multigrid solver that stops at a hundredth finds another rest of the error where a mesh differs in its last
digit; and code that OpenFOAM would compile at run time, which it refuses to root, is given as what it computes, or left out.

The stock solvers are compiled here from OpenFOAM's sources with -D__restrict__= (src/compilerOptions says why); without optimisation, which
changes no digit and is four times faster."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

import numpy as np

from plunge.results import CaseError
from plunge.studies.foamFields import readCells, times
from plunge.studies.particleRuns import CONTROL, converge, override, setEntry
from plunge.studies.tutorials import HOLE, installed

OURS = "plungeFoam"
# Where the sources of each stock solver are, in OpenFOAM's applications/solvers/multiphase
SOURCES = {"interFoam": "interFoam", "interIsoFoam": "interIsoFoam", "overInterDyMFoam": "interFoam/overInterDyMFoam"}
STEPS = 4
TRIES = 20
AGREE = 1e-7            # largest difference of a field, over its largest value

# Fields that a solver keeps for itself
WORK = {"rAU", "cellMask", "interpolatedCells"}
# Not compared: the transported scalar s (OpenFOAM v1912 carries it with a flux that is zero, plungeFoam with the liquid's). On overset meshes
# p and p_rgh may differ by a constant (the level of a closed tank is that of p, as in interFoam)
CHOICES = {"s", "cellTypes"}

# Entries of system/fvSolution that both have: of CrankNicolson's ddtCorr OpenFOAM v1912 makes another at each correction, plungeFoam one
BOTH = {"interIsoFoam/standingWave": "PIMPLE { nCorrectors 1; }"}

# Counts of cells are divided by this; 4 where nothing is said
COARSER = {
    "interFoam/LES/nozzleFlow2D": 3, "interFoam/RAS/damBreak/damBreak": 1, "interFoam/RAS/damBreakPorousBaffle": 1,
    "interFoam/RAS/floatingObject": 2, "interFoam/RAS/waterChannel": 2, "interFoam/RAS/weirOverflow": 2,
    "interFoam/laminar/damBreak/damBreak": 1, "interFoam/laminar/mixerVessel2D": 2, "interFoam/laminar/sloshingTank2D": 1,
    "interFoam/laminar/sloshingTank2D3DoF": 1, "interFoam/laminar/sloshingTank3D": 2, "interFoam/laminar/sloshingTank3D3DoF": 2,
    "interFoam/laminar/sloshingTank3D6DoF": 2, "interFoam/laminar/testTubeMixer": 1, "interFoam/laminar/vofToLagrangian/eulerianInjection": 5,
    "interFoam/laminar/waves/mangroveInteraction": 6, "interFoam/laminar/waves/solitaryGrimshaw": 6,
    "interFoam/laminar/waves/solitaryMcCowan": 6, "interFoam/laminar/waves/streamFunction": 8,
    "interFoam/laminar/waves/waveMakerMultiPaddleFlap": 5, "interFoam/laminar/waves/waveMakerMultiPaddlePiston": 5,
    "interIsoFoam/damBreak": 2, "interIsoFoam/damBreakWithObstacle": 1, "interIsoFoam/discInConstantFlow": 2,
    "interIsoFoam/discInConstantFlowCyclicBCs": 1, "interIsoFoam/discInReversedVortexFlow": 2,
    "interIsoFoam/notchedDiscInSolidBodyRotation": 2, "interIsoFoam/sloshingTank2D": 1, "interIsoFoam/standingWave": 2,
    "interIsoFoam/waveExampleStreamFunction": 8, "interIsoFoam/weirOverflow": 2, "overInterDyMFoam/twoSimpleRotors": 2,
    "overInterDyMFoam/boatAndPropeller": 2,
}

# Left to the tier validation
SLOW = {
    "interFoam/RAS/DTCHull": "snappyHexMesh: minutes on any mesh that holds the hull",
    "interFoam/RAS/DTCHullMoving": "snappyHexMesh: minutes on any mesh that holds the hull",
    "interFoam/RAS/mixerVesselAMI": "snappyHexMesh: minutes on any mesh that holds the impeller",
    "interFoam/RAS/motorBike": "snappyHexMesh: minutes on any mesh that holds the motorbike",
    "interFoam/laminar/sloshingCylinder": "snappyHexMesh",
    "overInterDyMFoam/boatAndPropeller": "a mesh that holds the boat's parts has too many cells",
}


REMARKS = {
    "interFoam/RAS/angledDuct": "without the scalar s, which the stock solver does not carry with the liquid",
    "interFoam/RAS/waterChannel": "without the scalar s, which the stock solver does not carry with the liquid",
    "interIsoFoam/standingWave": "nCorrectors 1 in both",
    **{f"interFoam/laminar/waves/{name}": "OpenFOAM's wave model reads freed memory; runs, of either solver, that crash or are elsewhere by it are repeated"
       for name in ("mangroveInteraction", "solitary", "solitaryGrimshaw", "solitaryMcCowan")},
}


class Outcome(NamedTuple):
    """Of a tutorial: the largest difference of any field over its largest value, and in which."""
    tutorial: str
    cells: int
    steps: int
    difference: float
    field: str


def tutorials() -> list[str]:
    """Directories in multiphase/ that one of the solvers runs in."""
    root, found = installed(), []
    for solver in SOURCES:
        for control in sorted((root / solver).rglob(CONTROL)):
            if applicationOf(control.parent.parent) in SOURCES:
                found.append(str(control.parent.parent.relative_to(root)))
    return found


def applicationOf(case: Path) -> str:
    match = re.search(r"^\s*application\s+(\w+)\s*;", (case / CONTROL).read_text(), re.M)
    return match[1] if match else ""


def fewer(count: str, factor: float) -> str:
    return str(max(1, int(int(count)/factor + 0.5)))


def coarsen(path: Path, factor: float) -> None:
    """Divides the counts of cells of a blockMeshDict, given as numbers, as variables or as definitions of m4."""
    text = path.read_text()
    counts = set(re.findall(r"\$(\w+)", " ".join(re.findall(r"hex\s*\([^)]*\)\s*\w*\s*\(([^)]*\$[^)]*)\)", text))))
    for name in counts:
        text = re.sub(rf"^(\s*{name}\s+)(\d+);", lambda m: f"{m[1]}{fewer(m[2], factor)};", text, flags=re.M)
    text = re.sub(r"^(define\((?:N\w{1,3}|n(?:cells|inlet|poro|outlet)),\s*)(\d+)\)", lambda m: f"{m[1]}{fewer(m[2], factor)})", text, flags=re.M)
    text = re.sub(r"(hex\s*\([^)]*\)\s*\w*\s*)\(([\d\s]+)\)",
                  lambda m: f"{m[1]}({' '.join(fewer(n, factor) for n in m[2].split())})", text)
    path.write_text(text)


def writeShims(folder: Path) -> None:
    """Programs that an Allrun finds before OpenFOAM's: everything on one core, and no solution."""
    programs = {
        "decomposePar": "exit 0",
        "reconstructPar": "exit 0",
        "mpirun": 'shift 2; program=$1; shift; [ "$1" != -parallel ] || shift; exec "$program" "$@"',
        # notchedDiscInSolidBodyRotation sets its velocity by the option -postProcess of its solver
        "noSolver": f'for word; do [ "$word" != -postProcess ] || exec {OURS} "$@"; done',
    }
    folder.mkdir()
    for name, script in programs.items():
        (folder / name).write_text(f"#!/bin/sh\n{script}\n")
        (folder / name).chmod(0o755)


def withoutCode(case: Path) -> None:
    """What run-time compilation would do: a cuboid's moments of inertia, m (Ly^2 + Lz^2)/12 and so on, and functions that print."""
    dynamic = case / "constant/dynamicMeshDict"
    if dynamic.exists():
        text = dynamic.read_text()
        side = {name: float(value) for name, value in re.findall(r"^\s*(L[xyz]|rhoSolid)\s+([\d.e+-]+);", text, re.M)}
        if len(side) == 4:
            x, y, z, rho = (side[name] for name in ("Lx", "Ly", "Lz", "rhoSolid"))
            moments = " ".join(f"{rho*x*y*z*of/12:.15g}" for of in (y*y + z*z, x*x + z*z, x*x + y*y))
            text = re.sub(r"(momentOfInertia\s+)#codeStream\b.*?/12\.0;\s*#\};\s*\};", rf"\g<1>({moments});", text, flags=re.S)
            dynamic.write_text(text)
    if re.search(r"^\s*type\s+coded;", (case / CONTROL).read_text(), re.M):
        setEntry(case, CONTROL, "functions")


def setUp(tutorial: str, directory: Path) -> Path:
    """The directory to run a solver in, meshed and with its initial fields."""
    source = installed() / tutorial
    part = "."
    if not (source / "Allrun").exists() and (source.parent / "Allrun").exists():
        source, part = source.parent, source.name
    shutil.copytree(source, directory)
    for path in (directory, *directory.rglob("*")):
        path.chmod(path.stat().st_mode | 0o200)
    for path in directory.rglob("All*"):
        path.chmod(0o755)
    for path in (*directory.rglob("blockMeshDict"), *directory.rglob("blockMeshDict.m4")):
        coarsen(path, COARSER.get(tutorial, 4))
    case = directory / part
    control = case / CONTROL
    control.write_text(re.sub(r"^(application\s+)\w+\s*;", r"\1noSolver;", control.read_text(), flags=re.M))
    withoutCode(case)

    shims = directory.with_name(f"{directory.name}.shims")
    writeShims(shims)
    done = subprocess.run(["./Allrun"], cwd=directory, env={**os.environ, "PWD": str(directory), "PATH": f"{shims}:{os.environ['PATH']}"},
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    failed = [log for log in directory.rglob("log.*") if "FOAM FATAL" in log.read_text(errors="replace")]
    if done.returncode or failed or not (case / "0").is_dir():
        raise CaseError(f"{tutorial}: its Allrun failed{''.join(f' in {log.name}' for log in failed)}\n{done.stdout[-1000:]}"
                        f"{''.join(log.read_text()[-2000:] for log in failed)}")
    override(case, CONTROL, f"stopAt nextWrite; writeControl timeStep; writeInterval {STEPS}; writeFormat ascii; writePrecision 17;\n"
                            "writeCompression off; purgeWrite 0; runTimeModifiable no;")
    converge(case)
    override(case, "system/fvSolution", BOTH.get(tutorial, ""))
    # angledDuct's porous part takes more than that gives
    solution = case / "system/fvSolution"
    solution.write_text(re.sub(r"(\bmaxIter\s+)500;", r"\g<1>5000;", solution.read_text()))
    return case


def solve(tutorial: str, case: Path, program: Path) -> None:
    """Runs a solver. OpenFOAM v1912's solitary waves read their place x0, here 0, from memory that they have freed, in any solver: they are
    elsewhere now and then, or crash. Then once more."""
    control = case / CONTROL
    control.write_text(re.sub(r"^(application\s+)\w+\s*;", rf"\g<1>{program.name};", control.read_text(), flags=re.M))
    log = case / f"log.{program.name}"
    for _ in range(TRIES):
        with log.open("w") as output:
            status = subprocess.run([str(program)], cwd=case, env={**os.environ, "PWD": str(case)}, stdout=output,
                                    stderr=subprocess.STDOUT).returncode
        said = log.read_text()
        place = re.search(r"^ +x0: (\S+)$", said, re.M)
        if not status and (not place or abs(float(place[1])) < 1e-9):
            return
        if not place and "solitaryWaveModel" not in said:
            break
    raise RuntimeError(f"{tutorial}: {program.name} failed:\n{said[max(said.rfind('FOAM FATAL'), len(said) - 2000):]}")


def build(folder: Path) -> Path:
    """The folder of the stock solvers, compiled unless they are there."""
    solvers = Path(os.environ["WM_PROJECT_DIR"]) / "applications/solvers"
    sources = solvers / "multiphase"
    programs = folder / "bin"
    for solver, part in SOURCES.items():
        if (programs / solver).exists():
            continue
        if not (sources / part).is_dir():
            raise CaseError(f"no sources of {solver} in '{sources}': expected those of OpenFOAM")
        if not (folder / "source").exists():
            programs.mkdir(parents=True, exist_ok=True)
            for name in ("VoF", "interFoam", "interIsoFoam"):
                shutil.copytree(sources / name, folder / "source" / name)
        with (folder / "source" / part / "Make/options").open("a") as options:
            options.write("\nEXE_INC += -D__restrict__= -O0\n")
        done = subprocess.run(["wmake", "-s", str(folder / "source" / part)], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, "FOAM_APPBIN": str(programs), "FOAM_SOLVERS": str(solvers)})
        if done.returncode:
            raise RuntimeError(f"{solver} does not compile:\n{done.stdout[-3000:]}")
    return programs


def fields(case: Path, time: str) -> dict[str, np.ndarray]:
    """Cell values of all fields of scalars and vectors of a time."""
    found = {}
    for path in sorted((case / time).iterdir()):
        if path.is_file() and re.search(r"class\s+vol(Scalar|Vector)Field;", path.read_text()[:1000]):
            found[path.name] = readCells(path)
    return found


def compare(tutorial: str, ours: Path, theirs: Path) -> Outcome:
    """Of the last time of two runs. Holes of overset meshes do not count."""
    time = times(theirs)[-1]
    if times(ours) != times(theirs):
        raise CaseError(f"{tutorial}: times {times(ours)}: expected {times(theirs)}")
    a, b = fields(ours, time), fields(theirs, time)
    cells = max(value.shape[0] for value in b.values())
    counts = np.ones(cells, dtype=bool)
    overset = "cellTypes" in b
    if overset:
        counts = b["cellTypes"].ravel() != HOLE
    missing = set(b) - set(a) - WORK
    if missing or not {"U", "p_rgh"} < set(b):
        raise CaseError(f"{tutorial}: fields {sorted(a)}: expected {sorted(b)}")
    worst, where = 0.0, ""
    for name in sorted(set(a) & set(b) - CHOICES):
        ours_, theirs_ = (np.broadcast_to(v, (cells, v.shape[1]))[counts] for v in (a[name], b[name]))
        scale = np.abs(theirs_).max()
        if scale == 0:
            scale = 1.0
        apart = ours_ - theirs_
        if overset and name in ("p", "p_rgh"):
            apart = apart - apart.mean()
        difference = float(np.abs(apart).max()/scale)
        if not difference <= worst:
            worst, where = difference, name
    return Outcome(tutorial, cells, STEPS, worst, where)


def runBoth(tutorial: str, folder: Path, programs: Path) -> Outcome:
    """Sets a tutorial up, runs it by its own solver and by plungeFoam, and compares."""
    solver = applicationOf(installed() / tutorial)
    theirs = setUp(tutorial, folder / "stock")
    part = theirs.relative_to(folder / "stock")
    shutil.copytree(folder / "stock", folder / OURS)
    ours = folder / OURS / part
    solve(tutorial, theirs, programs / solver)
    solve(tutorial, ours, Path(shutil.which(OURS) or OURS))
    return compare(tutorial, ours, theirs)
