# SPDX-License-Identifier: GPL-3.0-or-later
"""The time step that cells of a body's mesh allow in given flows, and a mesh whose cells are collapsed on the axis."""

from __future__ import annotations

from typing import Callable

import numpy as np

from plunge import meridianMesh
from plunge.shapes import Revolution

Flow = Callable[[np.ndarray], np.ndarray]  # velocity [m/s] at points [m]


def polar_surface(size: meridianMesh.MeshSize) -> meridianMesh.SurfaceGrid:
    """The alternative: (u, phi) cells right to the axis, where their inner edge has no length."""
    u = np.arange(sum(size.axial_cells) + 1, dtype=float)
    phi = np.pi * np.arange(4 * size.cap_cells + 1) / (4 * size.cap_cells)
    u, phi = np.meshgrid(u, phi, indexing="ij")
    sin_phi = np.where(np.abs(np.sin(phi)) < 1e-12, 0.0, np.sin(phi))
    grid = np.arange(u.size).reshape(u.shape)
    quads = np.stack((grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]), axis=-1).reshape(-1, 4)
    return meridianMesh.SurfaceGrid(u.ravel(), np.cos(phi).ravel(), sin_phi.ravel(), quads)


def inverse_time_step(mesh: meridianMesh.VolumeMesh, flow: Flow) -> np.ndarray:
    """0.5*sum|phi|/V of each cell [1/s]."""
    centre = mesh.nodes[mesh.hexahedra].mean(axis=1)
    through, volume = np.zeros(len(centre)), np.zeros(len(centre))
    for middle, area in meridianMesh.cell_faces(mesh):
        through += np.abs(np.einsum("ij,ij->i", flow(middle), area))
        volume += np.einsum("ij,ij->i", area, middle - centre) / 3
    return 0.5 * through / np.abs(volume)


def potential_flow(body: Revolution, speed: float, count: int = 60) -> Flow:
    """Flow along the axis past the body: sources on the axis, fitted to a vanishing stream function on the wall."""
    first, last = 0.5 * body.nose_radius, 0.998 * body.length
    place = first + (last - first) * (1 - np.cos(np.pi * (np.arange(count) + 0.5) / count)) / 2
    x, r = body.curve.point(np.linspace(0, 1, 800)[1:-1])
    matrix = -(1 + (x[:, None] - place) / np.hypot(x[:, None] - place, r[:, None])) / (4 * np.pi)
    strength = np.linalg.lstsq(matrix / r[:, None], -0.5 * r, rcond=1e-10)[0]

    def velocity(points: np.ndarray) -> np.ndarray:
        result = np.zeros_like(points)
        result[:, 0] = 1
        for position, source in zip(place, strength):
            away = points - [position, 0, 0]
            result += source / (4 * np.pi) * away / np.linalg.norm(away, axis=1)[:, None] ** 3
        return speed * result

    leak = np.abs(matrix @ strength + 0.5 * r**2) / (0.5 * r**2)
    if np.median(leak) > 1e-4:
        raise RuntimeError(f"the sources do not represent the body: median leak {np.median(leak):.2g}")
    return velocity


def uniform_flow(incidence: float, speed: float) -> Flow:
    """At an angle to the axis [deg]."""
    angle = np.radians(incidence)
    direction = speed * np.array([np.cos(angle), 0, np.sin(angle)])
    return lambda points: np.broadcast_to(direction, points.shape)
