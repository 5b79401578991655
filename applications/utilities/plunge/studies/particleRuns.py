# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of plungeSPH for validations and tests: a case of the repository with other entries, and its tables."""
import os
import re
import subprocess
from pathlib import Path
from typing import Dict, List, Mapping, Tuple

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from plunge.foamDictionary import read
from plunge.results import Table, merge_restarts, read_table
from plunge.studies import REPOSITORY
from plunge.surfaces import read_series, read_surface

PROPERTIES, CONTROL = "constant/particleProperties", "system/controlDict"
LOG = "log.plungeSPH"


def setEntry(run: Path, file: str, entry: str, value: object = None) -> None:
    """Sets an entry of a dictionary, or removes it where there is no value; sub-dictionaries with slashes."""
    change = ["-remove"] if value is None else ["-set", str(value)]
    done = subprocess.run(["foamDictionary", "-disableFunctionEntries", "-entry", entry, *change, file], cwd=run,
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
    path = run / f"log.{program}"
    with path.open(mode) as log:
        # OpenFOAM takes a PWD that is not the working directory for a mistake
        status = subprocess.run([program, *map(str, options)], cwd=run, env={**os.environ, "PWD": str(run)}, stdout=log,
                                stderr=subprocess.STDOUT).returncode
    if check and status:
        said = path.read_text()
        raise RuntimeError(f"{program} failed; {path} ends with:\n{said[max(said.rfind('FOAM FATAL'), len(said) - 2000):]}")


def table(run: Path, name: str) -> Table:
    """One of its tables, over restarts."""
    return merge_restarts([(float(path.parent.name), read_table(path), path) for path in run.glob(f"postProcessing/{name}/*/{name}.csv")])


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
