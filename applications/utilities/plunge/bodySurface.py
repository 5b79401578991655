# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole body's surface as triangles: rings of equally spaced points between the nose and the tail."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from plunge.bodyGeometry import Body

RINGS, AROUND = 160, 96


def build(body: Body, rings: int = RINGS, around: int = AROUND) -> tuple[np.ndarray, np.ndarray]:
    """Points (n, 3) [m], in x aft from the nose, y, z dorsal, and triangles (m, 3) that are wound outwards.

    The rings are equally spaced in sqrt(x/length), so that the round nose has the finest. Their radius is that of a
    polygon with the circle's area: what is left of the volume's error is that of the meridian's chords.
    """
    x, r = body.point(np.linspace(0, 1, rings + 1))
    phi = 2 * np.pi * np.arange(around) / around
    r *= np.sqrt(phi[1] / np.sin(phi[1]))
    circles = np.stack(np.broadcast_arrays(x[1:-1, None], r[1:-1, None] * np.sin(phi), r[1:-1, None] * np.cos(phi)), axis=-1)
    points = np.vstack(([[x[0], 0, 0]], circles.reshape(-1, 3), [[x[-1], 0, 0]]))

    number = 1 + np.arange((rings - 1) * around).reshape(rings - 1, around)
    ahead = np.roll(number, -1, axis=1)
    a, b, c, d = number[:-1].ravel(), ahead[:-1].ravel(), ahead[1:].ravel(), number[1:].ravel()
    nose, tail = np.zeros(around, int), np.full(around, len(points) - 1)
    triangles = np.vstack((
        np.column_stack((nose, number[0], ahead[0])),
        np.column_stack((a, c, b)), np.column_stack((a, d, c)),
        np.column_stack((tail, ahead[-1], number[-1])),
    ))
    return points, triangles


def write_stl(path: Path, points: np.ndarray, triangles: np.ndarray) -> None:
    """Write a binary STL; equal points stay equal in its single precision."""
    corners = points.astype("<f4")[triangles]
    facets = np.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    facets["normal"] = normal / np.linalg.norm(normal, axis=1, keepdims=True)
    facets["corners"] = corners
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("wb") as file:
        file.write(b"body".ljust(80))
        file.write(np.uint32(len(triangles)).tobytes())
        file.write(facets.tobytes())
