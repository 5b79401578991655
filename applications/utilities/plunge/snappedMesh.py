# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh of a body of any shape, from snappyHexMesh in the body's frame: what the dictionaries of etc/methods/meshes/snapped
take, the surface that is meshed, and the mesh's way to its place at t = 0."""

from __future__ import annotations

from math import ceil, log, log2, pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np

from plunge import bodySurface
from plunge.shapes.surface import Surface

# Of a mesh without a background: how far it reaches, in body lengths.
_SINGLE_REACH = 1.6
# Cells across the outer part of an overset mesh, at least: both sides interpolate over some.
_LEAST_OFFSET = 6
# Cells of the tier's lengths get no finer than this many over the body's thickness, and over the nose's radius.
_OVER_THICKNESS, _OVER_NOSE = 18, 4
# The surface's cells over the tier's, which are stretched along the body: a wall's cells here are cubes.
_CUBES = 0.5
# Layers at the wall: the first and the last over the cell that they lie under, and each over the one before.
_FIRST, _LAST, _EXPANSION = 0.3, 0.5, 1.3


def sections(shape: Surface, tier: dict[str, Any], resolution: float, full: bool, single: bool,
             first_layer: float | None = None) -> list[tuple[str, dict[str, Any]]]:
    """What the dictionaries of the snapped mesh include, in the body's frame: origin at the nose, x forward, y, z dorsal [m].

    `tier` gives, in body lengths, backgroundSpacing, refinementLevels, bodySpacing, noseSpacing and offset; `first_layer`
    is the thickness wanted at the wall [m], else it follows from the cells there.
    """
    length = shape.length
    finest = tier["backgroundSpacing"] * length / 2 ** tier["refinementLevels"] / resolution
    offset = max(max(np.atleast_1d(tier["offset"])) * length, _LEAST_OFFSET * finest)

    def level(spacing: float) -> int:
        return max(0, round(log2(finest / spacing)))

    thickness = sqrt(4 * shape.volume / (pi * length))  # of a cylinder of this volume and length
    wall = level(max(_CUBES * tier["bodySpacing"] * length, thickness / _OVER_THICKNESS) / resolution)
    edge = max(wall, level(max(tier["noseSpacing"] * length, shape.nose_radius / _OVER_NOSE) / resolution))

    # Shells about the body, finest innermost; each coarser one is four of its cells wide.
    shells = [[4 * finest / 2**wall, wall]] if wall else []
    spacing, reach, base = finest, offset, 0
    if single:
        base = tier["refinementLevels"]
        spacing, reach = finest * 2**base, _SINGLE_REACH * length
        shells = [[distance, base + k] for distance, k in shells]
        radius = offset
        for k in range(base, 0, -1):
            shells.append([radius, k])
            radius += 4 * spacing / 2 ** (k - 1)

    low, high = shape.bounds
    low, high = np.array([-high[0], low[1], low[2]]), np.array([-low[0], high[1], high[2]])
    half = (high - low) / 2 + reach
    middle = (low + high) / 2
    if not full:
        half[1], middle[1] = (high[1] + reach) / 2, (high[1] + reach) / 2
    cells = [ceil(h / spacing - 1e-9) * 2 if full or i != 1 else ceil(2 * h / spacing - 1e-9) for i, h in enumerate(half)]
    half = np.array(cells) * spacing / 2
    if not full:
        middle[1] = half[1]
    box = [[float(m + s * h) + 0.0 for m, s, h in zip(middle, corner, half)]
           for corner in ((-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))]

    first = _FIRST if first_layer is None else first_layer / (finest / 2**wall)
    return [("Snapped body mesh", {
        "snappedBox": box,
        "snappedCells": cells,
        "snappedWallLevel": base + wall, "snappedEdgeLevel": base + edge,
        "snappedShells": shells if shells else [[finest, 0]],
        "snappedLayers": 1 + max(0, ceil(log(_LAST / first) / log(_EXPANSION) - 1e-9)),
        "snappedFirstLayer": first, "snappedExpansion": _EXPANSION,
        # In a corner cell, off its faces
        "snappedLocation": [float(x - 0.37 * spacing) for x in box[6]],
        # How far the outer boundary is from the axis: the background's finest shell reaches farther
        "snappedReach": float(max(np.hypot(y, z) for _, y, z in box)),
    })]


def place(forward: np.ndarray, dorsal: np.ndarray, nose: np.ndarray) -> dict[str, list[float]]:
    """What transformPoints takes the body's frame to its place with: the translation [m], which comes first, and then roll,
    pitch and yaw [deg], R = Rx(roll) Ry(pitch) Rz(yaw)."""
    rotation = np.column_stack((forward, np.cross(dorsal, forward), dorsal))
    pitch = np.arcsin(np.clip(rotation[0, 2], -1, 1))
    roll = np.arctan2(-rotation[1, 2], rotation[2, 2])
    yaw = np.arctan2(-rotation[0, 1], rotation[0, 0])
    return {
        "snappedTranslation": [float(x) + 0.0 for x in rotation.T @ nose],
        "snappedRollPitchYaw": [float(x) + 0.0 for x in np.degrees((roll, pitch, yaw))],
    }


def write_surface(shape: Surface, run: Path) -> None:
    """Write the surface that is meshed, <run>/body/constant/triSurface/body.stl, in the body's frame."""
    points, triangles = shape.surface()
    bodySurface.write_stl(run / "body/constant/triSurface/body.stl", points * [-1, 1, 1], triangles[:, ::-1])
