# SPDX-License-Identifier: GPL-3.0-or-later
"""Methods: from a scene to the numbers that their dictionaries in etc/methods need."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from plunge.scene import Scene


@dataclass(frozen=True)
class Asked:
    """What is asked for of any method."""

    scene: Scene
    tier: dict[str, Any]
    resolution: float
    cores: int
    model: str
