# SPDX-License-Identifier: GPL-3.0-or-later
"""Prescribed motion, and events of a body at which a run ends, by both methods."""
import re
import shutil
from pathlib import Path
from typing import Dict

import numpy as np
import pytest

from tutorials import checkRefused, compare, copy, foam, setEntry, setUp, solve, steps
from plunge.studies.particleRuns import CONTROL, setUp as case, table

COEFFS = "sixDoFRigidBodyMotionCoeffs"
EVENT = re.compile(r"^Event (\w+) at (\S+) s: the run ends here$", re.MULTILINE)


@pytest.fixture(scope="module")
def floatingBody(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A box whose top is at z = 0.609 m, pulled down at 2 m/s: 2 mm in each step."""
    run = setUp("floatingBody", tmp_path_factory.mktemp("events") / "floatingBody", "-coarser", 4, "-application", "plungeFoam",
                "-endTime", 0.01, "-deltaT", 0.001, "-writeInterval", 0.003)
    for entry, value in (("solver", "{ type prescribed; }"), ("constraints", "{}"), ("velocity", "(0 0 -2)")):
        setEntry(run, "constant/dynamicMeshDict", f"{COEFFS}/{entry}", value)
    for entry, value in (("writePrecision", 17), ("timePrecision", 12), ("startFrom", "latestTime")):
        setEntry(run, CONTROL, entry, value)
    return run


def until(run: Path, event: str, level: float) -> Path:
    """Ends the run at the event, for a surface at that height."""
    setEntry(run, CONTROL, "functions/until",
             f"{{ type plungeEvent; libs (plungeFunctionObjects); event {event}; surfaceLevel {level}; }}")
    return run


def test_plungeFoamImmersed(floatingBody: Path) -> None:
    """The run ends at the step at which the top is below the surface, with its fields, also when it was interrupted; the body
    has moved at the velocity given, under its weight and the water's forces."""
    whole = until(copy(floatingBody, "whole"), "immersed", 0.598)
    output = solve(whole, "plungeFoam")
    assert steps(output)[-1] == "0.006" and EVENT.findall(output) == [("immersed", "0.006")]
    assert re.search(r"^End$", output, re.MULTILINE)
    assert compare.times(whole)[-1] == "0.006"
    centres = [line.centre for line in compare.readLog(whole / "log.solver")]
    np.testing.assert_allclose(centres[-1], (0.5, 0.5, 0.3 - 0.012), atol=1e-12)
    assert np.abs(compare.readForces(whole)[1]).max() > 1

    halves = until(copy(floatingBody, "halves"), "immersed", 0.598)
    setEntry(halves, CONTROL, "endTime", 0.003)
    assert not EVENT.search(solve(halves, "plungeFoam"))
    setEntry(halves, CONTROL, "endTime", 0.01)
    assert EVENT.findall(solve(halves, "plungeFoam")) == [("immersed", "0.006")]
    for name in ("U", "phi", "uniform/sixDoFRigidBodyMotionState", "uniform/functionObjects/functionObjectProperties", "uniform/time"):
        assert (halves / "0.006" / name).read_bytes() == (whole / "0.006" / name).read_bytes(), name

    # There is nothing left to run
    output = solve(whole, "plungeFoam")
    assert not steps(output) and EVENT.search(output) and re.search(r"^End$", output, re.MULTILINE)


def test_plungeFoamRemembers(floatingBody: Path) -> None:
    """A restart knows how fast the body was before."""
    run = until(copy(floatingBody, "remembers"), "atRest", 0)
    setEntry(run, CONTROL, "endTime", 0.003)
    assert not EVENT.search(solve(run, "plungeFoam"))
    setEntry(run, "0.003/uniform/sixDoFRigidBodyMotionState", "velocity", "(0 0 -0.019)")
    setEntry(run, CONTROL, "endTime", 0.01)
    assert EVENT.findall(solve(run, "plungeFoam")) == [("atRest", "0.003")]


def test_plungeFoamUnknownEvent(floatingBody: Path) -> None:
    run = until(copy(floatingBody, "unknown"), "sunk", 0)
    checkRefused("plungeFoam", run, ("controlDict", "event", "sunk", "immersed", "atRest", "leftTheLiquid"))


def circle(run: Path, body: str, centre: str, event: str, **control: object) -> Path:
    """A circle of 0.06 m in a plane tank with water to 0.5 m."""
    entries: Dict[str, object] = {
        "geometry/walls": "( { name tank; type box; min (0 0 0); max (1 0.7 0); open (top); }"
                          f" {{ name log; type sphere; centre {centre}; radius 0.06; }} )",
        "bodies": f"{{ log {{ mass 6; momentOfInertia (0.1 0.1 0.1); centreOfMass {centre}; {body} }} }}",
        "geometry/spacing": 0.02, "precision": "double", "until": event, "outputs/surfaceLevel": 0.5}
    return case("stillTank", run, entries, endTime=1, **{"writeInterval": 0.05, "purgeWrite": 0, **control})


def restartedIs(run: Path, at: str, event: str) -> None:
    """Once it has ended at the event, and once it goes on from a time before, to the same end."""
    output = foam("plungeSPH", "-threads", 1, case=run)
    (name, end), = EVENT.findall(output)
    assert name == event and re.search(r"^End$", output, re.MULTILINE)
    assert (run / end / "particles").exists()
    twin = copy(run, "twin")
    for path in twin.glob("[0-9]*"):
        if float(path.name) > float(at):
            shutil.rmtree(path)
    shutil.rmtree(twin / "postProcessing")
    assert EVENT.findall(foam("plungeSPH", "-threads", 1, case=twin)) == [(name, end)]
    whole, again = (table(directory, "trajectory") for directory in (run, twin))
    for column in again:
        np.testing.assert_allclose(again[column][-1], whole[column][-1], rtol=1e-8, atol=1e-9)


def test_plungeSPHImmersed(tmp_path: Path) -> None:
    """A circle that is pushed in and turned at a given pace; it reports what that takes."""
    run = circle(tmp_path / "run", "velocity (0 -1 0); angularMomentum (0 0 0.2); solver { type prescribed; }", "(0.5 0.57 0)", "immersed")
    restartedIs(run, "0.1", "immersed")
    path = table(run, "trajectory")
    assert path["y_m"][-1] < 0.44 + 1e-9 and path["y_m"][-2] > 0.44 - 1e-9
    np.testing.assert_allclose(path["y_m"], 0.57 - path["time_s"], atol=1e-9)
    assert (path["vy_m_s"] == -1).all() and np.allclose(path["omega3_rad_s"], 2) and (path["ay_m_s2"] == 0).all()
    assert path["Fpy_N"].max() > 50


def test_plungeSPHRemembers(tmp_path: Path) -> None:
    """A circle thrown up is at rest where it turns, as a restart knows that has seen little of its speed."""
    run = circle(tmp_path / "run", "velocity (0 1 0); solver { type symplectic; }", "(0.5 0.65 0)", "atRest", writeInterval=0.095)
    restartedIs(run, "0.095", "atRest")
    path = table(run, "trajectory")
    assert path["vy_m_s"][-1] == pytest.approx(0.01, abs=0.01) and path["time_s"][-1] == pytest.approx(1/9.81, rel=0.02)


def test_plungeSPHUnknownEvent(tmp_path: Path) -> None:
    run = circle(tmp_path / "run", "solver { type prescribed; }", "(0.5 0.57 0)", "sunk")
    checkRefused("plungeSPH", run, ("particleProperties", "until", "sunk", "immersed", "atRest", "leftTheLiquid"))
    setEntry(run, "constant/particleProperties", "until", "immersed")
    setEntry(run, "constant/particleProperties", "bodies", "{}")
    checkRefused("plungeSPH", run, ("particleProperties", "until", "0 bodies", "one body"))
