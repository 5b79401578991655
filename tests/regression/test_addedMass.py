# SPDX-License-Identifier: GPL-3.0-or-later
"""A body that the fluid's reaction outweighs, on a wall that moves and slips."""
import math
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
