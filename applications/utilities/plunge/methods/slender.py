# SPDX-License-Identifier: GPL-3.0-or-later
"""slenderBody: the meridian, the tail and the steps of its tables."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from plunge import decisions
from plunge.checks import ParameterError
from plunge.decisions import Decision
from plunge.methods import Asked
from plunge.methods.meshes import vector
from plunge.scene import Scene
from plunge.shapes.revolution import Revolution

MERIDIAN = "constant/meridian.csv"
_POINTS = 1000          # of each smooth piece
_TABLE_ROWS = 450       # at least
# Of a scene that ends with an event, the longest way in body lengths at the speed of the start
_LONGEST = 1000.0
_ASPECT_RATIO = 2.0     # of a tail, unless given


@dataclass(frozen=True)
class Slender(Asked):
    """What is asked for of the slender body of a scene."""

    flow: str = "auto"

    @property
    def duration(self) -> float:
        """[s]"""
        scene = self.scene
        if "duration" in scene.given or "travel" in scene.given:
            return scene.duration
        return _LONGEST * scene.shape.length / scene.reference_speed


def check(scene: Scene) -> None:
    """Refuses shapes that it cannot take."""
    if not scene.shape.isRevolution:
        raise ParameterError(f"{scene.source}: -method slenderBody, but the shape {scene.given['body.shape']['type']} is none of revolution; "
                             "expected one that is, or -method meshes or particles")
    if scene.thrust[0]:
        raise ParameterError(f"{scene.source}: -method slenderBody, but the body has an entry thrust, which it leaves out; expected none, or "
                             "-method meshes or particles")


def sections(slender: Slender) -> list[tuple[str, dict[str, Any]]]:
    scene = slender.scene
    tail = {key.rpartition(".")[2]: value for key, value in scene.given.items() if key.startswith("body.tail.")}
    return [
        ("Slender body", {
            "centreFromNose": vector(scene.centre),
            "angularVelocity": vector(scene.spin),
            "flow": slender.flow,
            "tail": "yes" if tail else "no",
            **({"tailVolumeCoefficient": tail["volumeCoefficient"], "tailAspectRatio": tail.get("aspectRatio", _ASPECT_RATIO),
                "tailPosition": tail.get("position", scene.shape.length)} if tail else {}),
        }),
        ("Run", {
            "cores": 1, "estimatedSteps": 2 * _TABLE_ROWS, "diveDuration": slender.duration, "frameInterval": slender.duration,
            "tableInterval": slender.duration / _TABLE_ROWS,
        }),
    ]


def decide(slender: Slender, boundary_layer: str, surface_tension: str) -> dict[str, Decision]:
    return {
        "boundary_layer": decisions.boundary_layer(slender.scene, "slenderBody", boundary_layer, 0.0, False),
        "surface_tension": decisions.surface_tension(slender.scene, "slenderBody", surface_tension),
        "compressibility": decisions.compressibility(slender.scene, "slenderBody"),
    }


def write_meridian(shape: Revolution, path: Path) -> None:
    """Points from the nose to the tail [m], closest where pieces end."""
    curve = shape.curve
    share = (1 - np.cos(np.linspace(0, np.pi, _POINTS))) / 2
    c = np.unique(np.concatenate([begin + (end - begin) * share for begin, end in zip(curve.breaks, curve.breaks[1:])]))
    x, r = curve.point(c)
    x = np.maximum.accumulate(np.where(np.abs(x) < 1e-12 * shape.length, 0, x)) if (np.diff(x) > -1e-9 * shape.length).all() else x
    r[0] = r[-1] = 0.0
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w") as file:
        file.write("x_m,r_m\n")
        file.writelines(f"{a:.15g},{b:.15g}\n" for a, b in zip(x, r))
