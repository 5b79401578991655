# SPDX-License-Identifier: GPL-3.0-or-later
"""plungeFoam against the stock solvers on their own tutorials, coarse and short: the application is all that differs."""
from pathlib import Path
from typing import Tuple

import numpy as np

from tutorials import cellVolumes, compare, converge, copy, setEntry, setUp, solve


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
    """Overset mesh and free body. Added mass hides much of a wrong body in so short a run: hence a tenth of a per cent."""
    case = setUp("floatingBody", tmp_path / "floatingBody", "-coarser", 4, "-endTime", 0.01, "-writeInterval", 0.005)
    run, stock = solveBoth(case, "overInterDyMFoam")
    time = compare.times(stock)[-1]
    motion = compare.motionDifference(run, stock)
    assert motion.travel > 1e-5 and motion.position < 0.001*motion.travel
    assert compare.forceDifference(run, stock) < 0.001
    assert compare.interfaceDifference(run, stock, time) < 0.001


def test_floatingObject(tmp_path: Path) -> None:
    """Mesh that deforms with the body. Debian's interFoam is compiled with a defect that grows on such meshes (src/compilerOptions)."""
    case = setUp("floatingObject", tmp_path / "floatingObject", "-coarser", 2, "-endTime", 0.1, "-writeInterval", 0.1)
    converge(case)
    run, stock = solveBoth(case, "interFoam")
    motion = compare.motionDifference(run, stock)
    assert motion.travel > 1e-4 and motion.position < 0.03*motion.travel and motion.angle < 0.03*motion.turn
    assert compare.forceDifference(run, stock) < 0.01
    assert compare.interfaceDifference(run, stock, "0.1") < 0.01


def test_floatingObjectIsStable(tmp_path: Path) -> None:
    """Where Debian's interFoam has long diverged, the body swings at a physical speed and the liquid is still there."""
    case = setUp("floatingObject", tmp_path / "floatingObject", "-application", "plungeFoam", "-coarser", 2,
                 "-endTime", 1, "-writeInterval", 1)
    solve(case, "plungeFoam")
    cellVolumes(case)
    speed = np.linalg.norm(compare.readCells(case / "1/U"), axis=1)
    assert speed.max() < 10
    volume = compare.readCells(case / "1/V").ravel()
    liquid = compare.readCells(case / "1/alpha.water").ravel()
    assert abs(np.sum(liquid*volume)/np.sum(volume) - 0.5282) < 0.005
