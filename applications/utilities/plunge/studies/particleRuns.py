# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of plungeSPH for validations and tests: a case of the repository with other entries, and its tables."""
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Dict, List, Mapping, Sequence, Tuple

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from plunge.foamDictionary import read
from plunge.studies import REPOSITORY
from plunge.surfaces import read_series, read_surface

PROPERTIES, CONTROL = "constant/particleProperties", "system/controlDict"
LOG = "log.plungeSPH"


def setEntry(run: Path, file: str, entry: str, value: object) -> None:
    """Sets an entry of a dictionary; sub-dictionaries with slashes."""
    done = subprocess.run(["foamDictionary", "-disableFunctionEntries", "-entry", entry, "-set", str(value), file], cwd=run,
                          env={**os.environ, "PWD": str(run)}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        raise RuntimeError(f"{run / file}, entry {entry}: cannot be set to {value}\n{done.stdout[-2000:]}")


def override(run: Path, file: str, text: str) -> None:
    """Entries that take the place of a dictionary's, or add to its sub-dictionaries, whatever directives (#ifeq) it holds."""
    with (run / file).open("a") as dictionary:
        dictionary.write(f"\n{text}\n")


def converge(run: Path) -> None:
    """Solves all linear systems of a run on meshes to 1e-12, whatever they started from."""
    path = run / "system/fvSolution"
    text = re.sub(r"(\btolerance\s+)[^;]+;", r"\g<1>1e-12;", path.read_text())
    text = re.sub(r"(\brelTol\s+)[^;]+;", r"\g<1>0;", text)
    path.write_text(re.sub(r"(\bmaxIter\s+)[^;]+;", r"\g<1>500;", text))


def setUp(case: str, run: Path, entries: Mapping[str, object] = {}, **control: object) -> Path:
    """A case of cases/ by particles, with other entries of particleProperties and controlDict."""
    made = subprocess.run(["plungeCase", str(REPOSITORY / "cases" / case), "-method", "particles", "-run", str(run)],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if made.returncode:
        raise RuntimeError(f"{case}: {made.stderr}")
    if "body" in read(run / "constant/scene"):
        call(run, "plungeBodySurface")
    for file, changes in ((PROPERTIES, entries), (CONTROL, control)):
        for entry, value in changes.items():
            setEntry(run, file, entry, value)
    return run


def isComplete(run: Path, solver: str = "plungeSPH") -> bool:
    """Has it come to its end?"""
    log = run / f"log.{solver}"
    return log.exists() and log.read_text().rstrip().endswith("End")


def call(run: Path, program: str, *options: object, check: bool = True, mode: str = "w") -> None:
    """Runs a program of OpenFOAM there, into its log; mode is that of opening the log."""
    with (run / f"log.{program}").open(mode) as log:
        # OpenFOAM takes a PWD that is not the working directory for a mistake
        subprocess.run([program, *map(str, options)], cwd=run, check=check, env={**os.environ, "PWD": str(run)}, stdout=log,
                       stderr=subprocess.STDOUT)


def solve(run: Path, *options: object) -> None:
    """Runs plungeSPH with its options to the end, from where it was stopped if it was; a run that is complete stays."""
    if not isComplete(run):
        call(run, "plungeSPH", *options, mode="a")


def solveCase(case: str, run: Path, entries: Mapping[str, object], *options: object, **control: object) -> None:
    """Sets a case up with other entries, unless it is there, and runs it to its end."""
    if not run.exists():
        setUp(case, run, entries, **control)
    print(f"Running in {run}", flush=True)
    solve(run, *options)


def table(run: Path, name: str) -> Dict[str, np.ndarray]:
    """Columns of a table by their names; of a run in parts each time once, from the later part."""
    parts = [np.genfromtxt(path, delimiter=",", names=True)
             for path in sorted((run / "postProcessing" / name).glob(f"*/{name}.csv"), key=lambda path: float(path.parent.name))]
    for i, after in enumerate(parts[1:]):
        parts[i] = parts[i][parts[i]["time_s"] < after["time_s"][0]]
    return {column: np.concatenate([part[column] for part in parts]) for column in parts[0].dtype.names}


def series(run: Path) -> List[Tuple[float, Path]]:
    """Times and files that ParaView shows."""
    return read_series(run / "VTK", "particles")


def particles(file: Path) -> Dict[str, np.ndarray]:
    """Fields of one of them: x, U, p, rho, wall, and the time in the file."""
    output = read_surface(file)
    if not output.GetNumberOfCells() == output.GetNumberOfPoints() > 0:
        raise RuntimeError(f"{file}: expected a vertex for each particle")
    fields = {name: vtk_to_numpy(output.GetPointData().GetArray(name)) for name in ("U", "p", "rho", "wall")}
    return {"x": vtk_to_numpy(output.GetPoints().GetData()), "time": vtk_to_numpy(output.GetFieldData().GetArray("TimeValue")), **fields}


def runs(folder: Path) -> List[Tuple[float, Path]]:
    """Spacings and directories of a validation's complete runs, which spacings name, the coarsest first."""
    complete = [(float(run.name), run) for run in (folder / "run").glob("[0-9]*") if isComplete(run)]
    if not complete:
        raise SystemExit(f"{folder / 'run'}: no complete run: expected one at least, of Allrun")
    return sorted(complete, reverse=True)


def commandLine() -> Tuple[List[str], List[str]]:
    """Its words before the first option, and the others, which are options of plungeSPH."""
    words = sys.argv[1:]
    n = next((i for i, word in enumerate(words) if word.startswith("-")), len(words))
    return words[:n], words[n:]


def resolutions(case: str, folder: Path, entries: Mapping[str, object] = {}, default: Sequence[float] = (), **control: object) -> None:
    """What a validation's run.py does: the case at several spacings, those of the command line before the first option, or
    else the default ones; other words are options of plungeSPH. Complete runs stay."""
    words, options = commandLine()
    for spacing in map(float, words or default):
        solveCase(case, folder / "run" / f"{spacing:g}", {**entries, "geometry/spacing": spacing}, *options, **control)
