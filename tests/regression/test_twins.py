# SPDX-License-Identifier: GPL-3.0-or-later
"""The same run in two ways: one process and two, uninterrupted and restarted."""
import shutil
from pathlib import Path

import numpy as np
import pytest

from conftest import REPOSITORY
from test_stockSolvers import difference
from tutorials import cellVolumes, checkRefused, compare, converge, copy, foam, runScene, setEntry, setUp, solve


@pytest.mark.parametrize("tutorial, coarser, endTime, tolerance", [
    # Linear systems are solved to 1e-12; steps multiply what is left.
    ("damBreak", 2, 0.1, 1e-6),
    ("floatingBody", 4, 0.005, 1e-6),
])
def test_parallel(tutorial: str, coarser: int, endTime: float, tolerance: float, tmp_path: Path) -> None:
    case = setUp(tutorial, tmp_path / tutorial, "-application", "plungeFoam", "-coarser", coarser,
                 "-endTime", endTime, "-writeInterval", endTime)
    converge(case)
    serial, parallel = copy(case, "serial"), copy(case, "parallel")
    solve(serial, "plungeFoam")
    solve(parallel, "plungeFoam", ranks=2)
    cellVolumes(serial)
    for field in ("alpha.water", "U", "p_rgh"):
        assert difference(parallel, serial, field) < tolerance, field
    assert compare.forceDifference(parallel, serial) < tolerance
    assert compare.interfaceDifference(parallel, serial, compare.times(serial)[-1]) < tolerance
    if tutorial == "floatingBody":
        motion = compare.motionDifference(parallel, serial)
        assert motion.travel > 1e-5 and motion.position < tolerance*motion.travel


@pytest.mark.parametrize("tutorial, coarser, deltaT, tolerance", [
    ("damBreak", 2, 0.001, 1e-12),
    ("floatingBody", 4, 0.001, 0.01),
])
def test_restart(tutorial: str, coarser: int, deltaT: float, tolerance: float, tmp_path: Path) -> None:
    """Ten steps, and five and five. A restarted body differs: OpenFOAM's motion solver does not relax its first acceleration."""
    case = setUp(tutorial, tmp_path / tutorial, "-application", "plungeFoam", "-coarser", coarser, "-deltaT", deltaT,
                 "-endTime", 10*deltaT, "-writeInterval", 5*deltaT)
    for entry, value in (("writePrecision", 17), ("timePrecision", 12), ("startFrom", "latestTime")):
        setEntry(case, "system/controlDict", entry, value)
    whole, halves = copy(case, "whole"), copy(case, "halves")
    solve(whole, "plungeFoam")
    setEntry(halves, "system/controlDict", "endTime", 5*deltaT)
    solve(halves, "plungeFoam")
    setEntry(halves, "system/controlDict", "endTime", 10*deltaT)
    solve(halves, "plungeFoam")
    cellVolumes(whole)
    assert len(compare.readForces(halves)[0]) == 10
    for field in ("alpha.water", "U", "p_rgh"):
        assert difference(halves, whole, field) < tolerance, field
    assert compare.forceDifference(halves, whole) < tolerance
    if tutorial == "floatingBody":
        last = [compare.readLog(run / "log.solver")[-1].centre for run in (halves, whole)]
        travel = np.linalg.norm(last[1] - compare.readLog(whole / "log.solver")[0].centre)
        assert np.linalg.norm(last[0] - last[1]) < 0.03*travel


@pytest.mark.parametrize("mesh, ranks, layer", [("following", 1, "auto"), ("following", 2, "auto"), ("overset", 1, "auto"), ("single", 1, "auto"),
                                                ("following", 1, "wallFunction")])
def test_interruptedDive(mesh: str, ranks: int, layer: str, tmp_path: Path) -> None:
    """Stopped and started again, and killed while it wrote, a dive is bit for bit the one that went through."""
    whole = tmp_path / "whole"
    runScene(REPOSITORY / "cases/gannetPlunge", whole, "-mesh", mesh, "-np", ranks, "-boundaryLayer", layer, "-resolution", 0.5,
             "-set", f"travel={0.05 if layer == 'wallFunction' else 0.1}", "-set", "frames=7")
    parts = [f"processor{i}" for i in range(ranks)] if ranks > 1 else ["."]
    written = compare.times(whole / parts[0])

    run = copy(whole, "interrupted")
    for name in ("postProcessing", "results"):
        shutil.rmtree(run / name)
    for log in ("plungeFoam", "reconstructPar", "plungePost"):
        (run / f"log.{log}").unlink(missing_ok=True)
    for time in written:
        for part in {".", *parts}:
            shutil.rmtree(run / part / time)

    control = run / "system/controlDict"
    original = control.read_text()
    for last in (written[1], written[3]):
        control.write_text(f"{original}\nendTime {last};\n")
        foam(*(("mpirun", "-np", ranks, "plungeFoam", "-parallel") if ranks > 1 else ("plungeFoam",)), case=run)
    control.write_text(original)

    half = run / parts[-1] / written[3]
    shutil.rmtree(half / "polyMesh")
    (half / "uniform/unfinished").touch()
    if ranks == 1:
        checkRefused("plungeFoam", run, (f"Time {written[3]} is not complete", "Remove"))
    foam(run / "Allrun", case=tmp_path)

    assert (run / "results/trajectory.csv").read_bytes() == (whole / "results/trajectory.csv").read_bytes()
    assert compare.times(run / parts[0]) == written
    for part in parts:
        for name in ("U", "p_rgh", "alpha.liquid", "phi", "Uf", "polyMesh/points", "uniform/time", "uniform/sixDoFRigidBodyMotionState"):
            file = Path(part, written[-1], name)
            assert (run / file).read_bytes() == (whole / file).read_bytes(), file
