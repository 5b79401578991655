#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the body mesh's butterfly gains in time step over cells that are collapsed on the axis.

Both meshes are built with the same spacings, layers and cells around the body, in memory. For each, the largest
0.5*sum|phi|/V over the cells gives the time step at Courant number 1 in flows past the body: uniform at several
angles to the axis, and, over the fore body, the potential flow of the dive (point sources on the axis, which do
not represent the tip of the tail). Writes result.csv.
"""

from __future__ import annotations

import time
from pathlib import Path
from typing import Callable

import numpy as np

from plunge import bodyMesh, diveParameters
from plunge.bodyGeometry import Body
from plunge.studies import REPOSITORY
from plunge.studies.resultTable import Row, show, write

HERE = Path(__file__).resolve().parent
SPEED = 25.0          # m/s
INCIDENCES = (0, 5, 15)  # deg, of uniform flow
LEAST_GAIN = 1.0      # of the time step where the flow crosses the axis

FORE_BODY = "of the dive over the fore body"

Flow = Callable[[np.ndarray], np.ndarray]  # velocity [m/s] at points [m]
HEX_FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def polar_surface(size: bodyMesh.MeshSize) -> bodyMesh.SurfaceGrid:
    """The alternative: (u, phi) cells right to the axis, where their inner edge has no length."""
    u = np.arange(size.axial_cells + 1, dtype=float)
    phi = np.pi * np.arange(4 * size.cap_cells + 1) / (4 * size.cap_cells)
    u, phi = np.meshgrid(u, phi, indexing="ij")
    sin_phi = np.where(np.abs(np.sin(phi)) < 1e-12, 0.0, np.sin(phi))
    grid = np.arange(u.size).reshape(u.shape)
    quads = np.stack((grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]), axis=-1).reshape(-1, 4)
    return bodyMesh.SurfaceGrid(u.ravel(), np.cos(phi).ravel(), sin_phi.ravel(), quads)


def inverse_time_step(mesh: bodyMesh.VolumeMesh, flow: Flow) -> np.ndarray:
    """0.5*sum|phi|/V of each cell [1/s]."""
    corners = mesh.nodes[mesh.hexahedra]
    centre = corners.mean(axis=1)
    through, volume = np.zeros(len(corners)), np.zeros(len(corners))
    for face in HEX_FACES:
        points = corners[:, face]
        middle = points.mean(axis=1)
        triangles = 0.5 * np.cross(points - middle[:, None], np.roll(points, -1, axis=1) - middle[:, None])
        area = triangles.sum(axis=1)
        through += np.abs(np.einsum("ij,ij->i", flow(middle), area))
        volume += np.einsum("ij,ij->i", area, middle - centre) / 3
    return 0.5 * through / np.abs(volume)


def potential_flow(body: Body, count: int = 60) -> Flow:
    """Flow along the axis past the body: sources on the axis, fitted to a vanishing stream function on the wall."""
    first, last = 0.5 * body.nose_radius, 0.998 * body.length
    place = first + (last - first) * (1 - np.cos(np.pi * (np.arange(count) + 0.5) / count)) / 2
    x, r = body.point(np.linspace(0, 1, 800)[1:-1])
    matrix = -(1 + (x[:, None] - place) / np.hypot(x[:, None] - place, r[:, None])) / (4 * np.pi)
    strength = np.linalg.lstsq(matrix / r[:, None], -0.5 * r, rcond=1e-10)[0]

    def velocity(points: np.ndarray) -> np.ndarray:
        result = np.zeros_like(points)
        result[:, 0] = 1
        for position, source in zip(place, strength):
            away = points - [position, 0, 0]
            result += source / (4 * np.pi) * away / np.linalg.norm(away, axis=1)[:, None] ** 3
        return SPEED * result

    leak = np.abs(matrix @ strength + 0.5 * r**2) / (0.5 * r**2)
    if np.median(leak) > 1e-4:
        raise RuntimeError(f"the sources do not represent the body: median leak {np.median(leak):.2g}")
    return velocity


def uniform_flow(incidence: float) -> Flow:
    angle = np.radians(incidence)
    direction = SPEED * np.array([np.cos(angle), 0, np.sin(angle)])
    return lambda points: np.broadcast_to(direction, points.shape)


def main() -> None:
    start = time.process_time()
    rows = []
    case = REPOSITORY / "cases/gannetPlunge"
    for tier, resolution in (("fast", 1), ("fast", 2), ("standard", 1)):
        dive = diveParameters.read(case, {"tier": tier, "resolution": resolution})
        body = Body(float(dive.given["body.length"]), dive.given["body.thicknessRatio"])
        size = diveParameters.mesh_size(body, dive.tier, resolution)
        meshes = {
            "butterfly": bodyMesh.extrude(bodyMesh.butterfly_surface(size), body, size),
            "collapsed": bodyMesh.extrude(polar_surface(size), body, size),
        }
        flows = {f"uniform at {angle} deg": uniform_flow(angle) for angle in INCIDENCES}
        flows[FORE_BODY] = potential_flow(body)
        name = f"{tier} resolution {resolution}"
        for kind, mesh in meshes.items():
            rows.append(Row(f"{name}: cells, {kind}", str(len(mesh.hexahedra)), "1"))
        for flow, velocity in flows.items():
            step = {}
            for kind, mesh in meshes.items():
                rate = inverse_time_step(mesh, velocity)
                if flow == FORE_BODY:
                    rate = rate[mesh.nodes[mesh.hexahedra].mean(axis=1)[:, 0] < body.length / 2]
                step[kind] = 1e6 / rate.max()
                rows.append(Row(f"{name}: time step at Co 1, flow {flow}, {kind}", step[kind], "us"))
            gain = step["butterfly"] / step["collapsed"]
            asserted = flow.startswith("uniform") and flow != "uniform at 0 deg"
            gained = Row(f"{name}: time step gained, flow {flow}", f"{gain:.3g}", "1")
            if asserted:
                gained = gained._replace(reference=f"at least {LEAST_GAIN:g}", tolerance=0,
                                         holds="yes" if gain >= LEAST_GAIN else "no")
            rows.append(gained)

    seconds = f"{time.process_time() - start:.1f}"
    rows = [row._replace(cpu_s=seconds) for row in rows]
    write(HERE / "result.csv", rows)
    show(rows)


if __name__ == "__main__":
    main()
