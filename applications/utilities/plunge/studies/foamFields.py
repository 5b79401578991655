# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields that a solver has written."""
import re
from pathlib import Path
from typing import List

import numpy as np


class ComparisonError(RuntimeError):
    """A run lacks what the comparison needs."""


def readCells(path: Path) -> np.ndarray:
    """Cell values of an ascii volScalarField or volVectorField; a uniform field is one value."""
    if not path.exists():
        raise ComparisonError(f"{path}: expected a field")
    match = re.search(r"internalField\s+(?:uniform\s+(\([^)]*\)|[^;]+);|nonuniform\s+List<(\w+)>\s*(\d+)\s*\()", path.read_text())
    if not match:
        raise ComparisonError(f"{path}: entry internalField: expected an ascii field")
    if match.group(1):
        return np.array([match.group(1).strip("()").split()], dtype=float)
    text = path.read_text()[match.end():]
    width = {"scalar": 1, "vector": 3}[match.group(2)]
    text = text[:re.search(r"\n\)\s*;?\s*\n", text).start()] if width == 3 else text[:text.index(")")]
    values = np.array(text.replace("(", " ").replace(")", " ").split(), dtype=float)
    if values.size != width*int(match.group(3)):
        raise ComparisonError(f"{path}: {values.size} values: expected {width}*{match.group(3)}")
    return values.reshape(-1, width)


def times(run: Path) -> List[str]:
    """Time directories after the start, as they are named, in order."""
    found = [path.name for path in run.iterdir() if re.fullmatch(r"[0-9.]+(e-?\d+)?", path.name) and float(path.name) > 0]
    return sorted(found, key=float)
