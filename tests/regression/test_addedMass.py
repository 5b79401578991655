# SPDX-License-Identifier: GPL-3.0-or-later
"""A body that the fluid's reaction outweighs, on a wall that moves and slips."""
import math
import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from plunge.studies import planeBody
from tutorials import copy, foam, solve


def release(*given: object) -> np.ndarray:
    """The trajectory of a circle released from rest."""
    planeBody.release(*given)
    return planeBody.track(given[0])


@pytest.mark.parametrize("ratio", (0.1, 10.0))
def test_release(ratio: float, tmp_path: Path) -> None:
    """A circle released from rest: (1 - r)/(1 + r) of g. At rest a slip wall would let the fluid through."""
    track = release(tmp_path / "run", "plungeFoam", ratio, (12, 32), 0.2)
    assert planeBody.isWhole(track, 0.2)
    assert track["vy_m_s"][-1] == pytest.approx((1 - ratio)/(1 + ratio)*0.2, rel=0.03)
    assert abs(track["vx_m_s"]).max() < 1e-3*abs(track["vy_m_s"][-1])
    # What it was computed with: the mass that the circle displaces, and of no spin
    expected = np.zeros((6, 6))
    expected[0, 0] = expected[1, 1] = math.pi*planeBody.RADIUS**2
    np.testing.assert_allclose(planeBody.tensor(tmp_path / "run", 0.2), expected, atol=0.01)


@pytest.mark.parametrize("stop", (0.15, 0.19))
def test_restart(stop: float, tmp_path: Path) -> None:
    """Stopped and restarted between two estimates of the added mass, or just before one, the body goes on as if it had not been
    stopped."""
    whole = release(tmp_path / "whole", "plungeFoam", 0.1, (8, 16), 0.3)
    run = tmp_path / "parts"
    release(run, "plungeFoam", 0.1, (8, 16), stop)
    parameters = run / "system/parameters"
    parameters.write_text(parameters.read_text().replace(f"end {stop};", "end 0.3;"))
    control = run / "system/controlDict"
    control.write_text(control.read_text().replace("startTime;\n", "latestTime;\n", 1))
    foam("plungeFoam", case=run)
    again = np.genfromtxt(run / "postProcessing/trajectory" / f"{stop:g}/trajectory.csv", delimiter=",", names=True)
    for column in ("y_m", "vy_m_s"):
        np.testing.assert_allclose(again[column], whole[column][-len(again):], rtol=1e-8)


def test_ranks(tmp_path: Path) -> None:
    """Two ranks move the body as one does, also after the second estimate."""
    serial = release(tmp_path / "serial", "plungeFoam", 0.1, (8, 16), 0.25)
    run = copy(tmp_path / "serial", "parallel")
    for old in ("0.25", "postProcessing"):
        shutil.rmtree(run / old)
    solve(run, "plungeFoam", ranks=2)
    parallel = np.genfromtxt(run / "postProcessing/trajectory/0/trajectory.csv", delimiter=",", names=True)
    np.testing.assert_allclose(parallel["vy_m_s"], serial["vy_m_s"], rtol=1e-6)


def constrained(text: str) -> dict:
    """Changes of the case that give these constraints beside those in its plane."""
    return {"constant/dynamicMeshDict": f"sixDoFRigidBodyMotionCoeffs {{ constraints {{ {text} }} }}"}


def newton(track: np.ndarray, mass: float, gravity: float) -> np.ndarray:
    """Difference of the force on a body and of m a along y, over the larger, at each step."""
    force = track["Fpy_N"] + track["Fvy_N"] - mass*gravity
    return (abs(mass*track["ay_m_s2"] - force)/np.maximum(abs(force), abs(mass*track["ay_m_s2"])))[1:]


@pytest.mark.parametrize("ratio", (0.0015, 0.1, 0.8))
def test_newton(ratio: float, tmp_path: Path) -> None:
    """Force and change of momentum agree to 1 % at each step."""
    track = release(tmp_path / "run", "plungeFoam", ratio, (8, 16), 0.2)
    assert newton(track, ratio*math.pi*planeBody.RADIUS**2, 1).max() < 0.01


@pytest.mark.parametrize("ratio", (0.2, 5.0))
def test_hinge(ratio: float, tmp_path: Path) -> None:
    """An ellipse hinged at its end turns about the hinge: Lamb's inertia about it, arts. 71 and 124."""
    a, b, run = planeBody.A, planeBody.B, tmp_path / "run"
    area = math.pi*a*b
    mass, inertia = ratio*area, ratio*area*(a*a + b*b)/4
    planeBody.solve(run, "plungeFoam", (a, b), (24, 64), constrained(
        f"hinge {{ sixDoFRigidBodyMotionConstraint point; centreOfRotation ({-a} 0 0.5); }}"), mass=mass, momentOfInertia=f"(1 1 {inertia})",
        velocity="(0 0 0)", angularMomentum="(0 0 0)", gravity="(0 -1 0)", end=0.05)
    of = planeBody.track(run)
    exact = (1 - ratio)*area*a/(inertia + mass*a*a + math.pi*(a*a - b*b)**2/8 + math.pi*a*a*a*a)
    # The mesh's cells; and the fluid feels less than all of the first step, from rest
    rate = np.diff(of["omega3_rad_s"])/np.diff(of["time_s"])
    assert rate[2:] == pytest.approx(exact, rel=0.04)
    assert rate[:2] == pytest.approx(exact, rel=0.12)
    assert (of["x_m"] + a)**2 + of["y_m"]**2 == pytest.approx(a*a)


@pytest.mark.parametrize("form", ("ascii", "binary"))
def test_restartOnALine(form: str, tmp_path: Path) -> None:
    """With all digits a restart repeats the run, also of a body that moves along a line, and from binary files."""
    changes = {"constant/dynamicMeshDict": "sixDoFRigidBodyMotionCoeffs { constraints { "
               "plane { sixDoFRigidBodyMotionConstraint line; direction (0.6 0.8 0); } axis { sixDoFRigidBodyMotionConstraint orientation; } } }",
               "system/controlDict": f"writeFormat {form}; writePrecision 17; writeInterval 0.05;"}
    whole = release(tmp_path / "whole", "plungeFoam", 0.1, (8, 16), 0.15, changes)
    run = copy(tmp_path / "whole", "parts")
    for time in ("0.1", "0.15"):
        shutil.rmtree(run / time)
    control = run / "system/controlDict"
    control.write_text(control.read_text().replace("startTime;\n", "latestTime;\n", 1))
    foam("plungeFoam", case=run)
    again = np.genfromtxt(run / "postProcessing/trajectory/0.05/trajectory.csv", delimiter=",", names=True)
    for column in ("x_m", "y_m", "vx_m_s", "vy_m_s"):
        np.testing.assert_array_equal(again[column][1:], whole[column][-len(again) + 1:])


def test_massOfASlice(tmp_path: Path) -> None:
    """The body's density over the fluid's, on a mesh in the plane whose sides are empty, or slip."""
    release(tmp_path / "run", "plungeFoam", 0.5, (8, 16), 0.01)
    run = copy(tmp_path / "run", "slip")
    shutil.rmtree(run / "0.01")
    boundary = run / "constant/polyMesh/boundary"
    boundary.write_text(boundary.read_text().replace("empty", "patch"))
    for field, kind in {"U": "slip", "p_rgh": "zeroGradient", "alpha.fluid": "zeroGradient", "pointDisplacement": "slip"}.items():
        path = run / "0" / field
        path.write_text(path.read_text().replace("empty;", f"{kind};"))
    for case in (tmp_path / "run", run):
        log = foam("plungeFoam", case=case) if case == run else (case / "log.plungeFoam").read_text()
        found = re.search(r"mass +: body/displaced fluid (\S+)", log)
        # Of a circle of 32 sides
        assert found and float(found[1]) == pytest.approx(0.5, rel=0.01), case
