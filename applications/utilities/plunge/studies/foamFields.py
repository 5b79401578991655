# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields and tables that a solver has written."""
import re
from pathlib import Path
from typing import List

import numpy as np

from plunge.results import CaseError


def readCells(path: Path) -> np.ndarray:
    """Cell values of an ascii volScalarField or volVectorField; a uniform field is one value."""
    if not path.exists():
        raise CaseError(f"{path}: expected a field")
    match = re.search(r"internalField\s+(?:uniform\s+(\([^)]*\)|[^;]+);|nonuniform\s+List<(\w+)>\s*(\d+)\s*\()", path.read_text())
    if not match:
        raise CaseError(f"{path}: entry internalField: expected an ascii field")
    if match.group(1):
        return np.array([match.group(1).strip("()").split()], dtype=float)
    text = path.read_text()[match.end():]
    width = {"scalar": 1, "vector": 3}[match.group(2)]
    text = text[:re.search(r"\n\)\s*;?\s*\n", text).start()] if width == 3 else text[:text.index(")")]
    values = np.array(text.replace("(", " ").replace(")", " ").split(), dtype=float)
    if values.size != width*int(match.group(3)):
        raise CaseError(f"{path}: {values.size} values: expected {width}*{match.group(3)}")
    return values.reshape(-1, width)


def times(run: Path) -> List[str]:
    """Time directories after the start, as they are named, in order."""
    found = [path.name for path in run.iterdir() if re.fullmatch(r"[0-9.]+(e-?\d+)?", path.name) and float(path.name) > 0]
    return sorted(found, key=float)


def numbers(*files: Path) -> np.ndarray:
    """Tables that a function object has written, one below the other, without their brackets; a row for each time."""
    lines = (re.sub("[()]", " ", line).split() for file in files for line in file.read_text().splitlines() if not line.startswith("#"))
    return np.array([list(map(float, line)) for line in lines])
