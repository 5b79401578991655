# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of triangles as files."""

from __future__ import annotations

from pathlib import Path

import numpy as np


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
