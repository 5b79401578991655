# SPDX-License-Identifier: GPL-3.0-or-later
"""A body that the fluid's reaction outweighs, on a wall that moves and slips."""
from pathlib import Path

import pytest

from addedMass import compare


@pytest.mark.parametrize("ratio", (0.1, 10.0))
def test_release(ratio: float, tmp_path: Path) -> None:
    """A circle released from rest: (1 - r)/(1 + r) of g. At rest a slip wall would let the fluid through."""
    track = compare.release(tmp_path / "run", "plungeFoam", ratio, (12, 32), 0.2)
    assert compare.isWhole(track, 0.2)
    assert track["vy_m_s"][-1] == pytest.approx((1 - ratio)/(1 + ratio)*0.2, rel=0.03)
    assert abs(track["vx_m_s"]).max() < 1e-3*abs(track["vy_m_s"][-1])
