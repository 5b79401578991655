# SPDX-License-Identifier: GPL-3.0-or-later
"""plungeFoam against the stock solvers on their own tutorials, coarse and short: the application is all that differs.

Linear solvers converge to 1e-12 here where two programs are compared: at the tutorials' own tolerances, what is left of the
residuals is all that one would see.
"""
import re
from pathlib import Path
from typing import Tuple

import numpy as np
import pytest

from tutorials import cellVolumes, compare, copy, setEntry, setUp, solve


def converge(case: Path) -> None:
    """Solves all linear systems to 1e-12, whatever they started from."""
    path = case / "system/fvSolution"
    text = re.sub(r"(\btolerance\s+)[^;]+;", r"\g<1>1e-12;", path.read_text())
    text = re.sub(r"(\brelTol\s+)[^;]+;", r"\g<1>0;", text)
    path.write_text(re.sub(r"(\bmaxIter\s+)[^;]+;", r"\g<1>500;", text))


def difference(run: Path, reference: Path, field: str) -> float:
    """Root mean square of the difference of a field at the end, over the reference's largest value."""
    time = compare.times(reference)[-1]
    ours, theirs = (compare.readCells(case / time / field) for case in (run, reference))
    return float(np.sqrt(np.mean((ours - theirs)**2))/np.abs(theirs).max())


def solveBoth(case: Path, stock: str) -> Tuple[Path, Path]:
    """Runs of plungeFoam and of the stock solver in copies of a case."""
    runs = copy(case, "plungeFoam"), copy(case, "stock")
    for run, solver in zip(runs, ("plungeFoam", stock)):
        setEntry(run, "system/controlDict", "application", solver)
        solve(run, solver)
    cellVolumes(runs[1])
    assert compare.times(runs[0]) == compare.times(runs[1])
    return runs


def test_damBreak(tmp_path: Path) -> None:
    """At the tutorial's own tolerances: the same operations, so the same fields."""
    run, stock = solveBoth(setUp("damBreak", tmp_path / "damBreak", "-coarser", 2, "-endTime", 0.1, "-writeInterval", 0.05), "interFoam")
    for field in ("alpha.water", "U", "p_rgh", "p"):
        assert difference(run, stock, field) < 1e-10, field
    assert compare.forceDifference(run, stock) < 1e-10


def test_floatingBody(tmp_path: Path) -> None:
    """Overset mesh and free body."""
    case = setUp("floatingBody", tmp_path / "floatingBody", "-coarser", 4, "-endTime", 0.01, "-writeInterval", 0.005)
    run, stock = solveBoth(case, "overInterDyMFoam")
    time = compare.times(stock)[-1]
    motion = compare.motionDifference(run, stock)
    assert motion.travel > 1e-5 and motion.position < 0.01*motion.travel
    assert compare.forceDifference(run, stock) < 0.01
    assert compare.interfaceDifference(run, stock, time) < 0.01
