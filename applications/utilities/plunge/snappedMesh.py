# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh of a body of any shape, from snappyHexMesh in the body's frame: what the dictionaries of etc/methods/meshes/snapped
take, the surface that is meshed, and the mesh's way to its place at t = 0.

In a run directory that holds a copy of these dictionaries (body/system) and system/plungeGenerated:

    blockMesh -case body
    snappyHexMesh -case body -dict system/refineDict -overwrite
    surfaceFeatureExtract -case body
    snappyHexMesh -case body -overwrite
    surfaceMeshExtract -case body -constant -patches '(wall)' meshed.stl; plungeBodyMesh -check
    transformPoints -case body -translate snappedTranslation -rollPitchYaw snappedRollPitchYaw
    cp -r body/constant/polyMesh constant

The patches are then those of gmshToFoam after plungeBodyMesh (wall, outer and in the half model plane), all cells are in the
zone bodyMesh, and createPatch is next.
"""

from __future__ import annotations

from math import ceil, log, log2, pi, radians, sin, sqrt
from pathlib import Path
from typing import Any

import numpy as np

from plunge.stl import write_stl
from plunge.shapes.surface import Surface, SurfaceError, polydata, read_triangles

# Of a mesh without a background: how far it reaches, in body scales, and at least in largest diameters (a sphere's added mass
# is 0.3 % less than in unbounded fluid).
_SINGLE_REACH, _SINGLE_REACH_ACROSS = 1.6, 3.5
# Cells across the outer part of an overset mesh, at least: both sides interpolate over some.
_LEAST_OFFSET = 6
# Cells of the tier's lengths get no finer than this many over the body's thickness, and over the nose's radius.
_OVER_THICKNESS, _OVER_NOSE = 18, 4
# The surface's cells over the tier's, which are stretched along the body: a wall's cells here are cubes.
_CUBES = 0.5
# Layers at the wall: the first and the last over the cell that they lie under, and each over the one before.
_FIRST, _LAST, _EXPANSION = 0.3, 0.5, 1.3
# Where edges have finer cells than the wall: faces there over the wall's, and cells on each of them beside the layers, from
# slender bodies with and without wings.
_EDGE_FACES, _EDGE_CELLS = 2.9, 4
# Part of a body's volume or area that its mesh may lose
_MOST_LOST = 0.05
# Where a body is thinner than this many of the wall's cells, finer ones: one over its thickness, but where it is still thinner on
# this share of its area, as at a trailing edge, and halved no more often than this.
_THIN, _THIN_IGNORED, _THIN_HALVINGS = 2, 0.02, 3
# An edge is sharp from this angle between its triangles on, as in surfaceFeatureExtractDict; a tip where a cone's half angle is
# below 70 deg: its angles add up to sin(70 deg) of a full turn. Length of the line that marks it, over the body's.
_SHARP, _TIP, _TIP_LINE = radians(30), 2 * pi * (1 - sin(radians(70))), 1e-3


def sections(shape: Surface, tier: dict[str, Any], scale: float, resolution: float, full: bool, single: bool,
             first_layer: float | None = None) -> list[tuple[str, dict[str, Any]]]:
    """What the dictionaries of the snapped mesh include, in the body's frame: origin at the nose, x forward, y, z dorsal [m].

    `tier` gives, in scales, backgroundSpacing, refinementLevels, bodySpacing, noseSpacing and offset; `first_layer`
    is the thickness wanted at the wall [m], else it follows from the cells there.
    """
    length = shape.length
    finest = tier["backgroundSpacing"] * scale / 2 ** tier["refinementLevels"] / resolution
    offset = max(max(np.atleast_1d(tier["offset"])) * scale, _LEAST_OFFSET * finest)

    def level(spacing: float) -> int:
        return max(0, round(log2(finest / spacing)))

    thickness = sqrt(4 * shape.volume / (pi * length))  # of a cylinder of this volume and length
    wall = level(max(_CUBES * tier["bodySpacing"] * scale, thickness / _OVER_THICKNESS) / resolution)
    fine = max(tier["noseSpacing"] * scale, shape.nose_radius / _OVER_NOSE) / resolution
    edge = max(wall, level(fine))
    # A round nose in facets is blunt: in the dive a cell of 0.6 of its radius makes the peak of the deceleration 14 % too
    # high, one of 0.3 2.5 %.
    nose = max(edge, ceil(log2(finest / fine)))

    # Shells about the body, finest innermost; each coarser one is four of its cells wide.
    shells = [[4 * finest / 2**wall, wall]] if wall else []
    spacing, reach, base = finest, offset, 0
    if single:
        base = tier["refinementLevels"]
        spacing, reach = finest * 2**base, max(_SINGLE_REACH * scale, _SINGLE_REACH_ACROSS * shape.max_diameter)
        shells = [[distance, base + k] for distance, k in shells]
        radius = offset
        for k in range(base, 0, -1):
            shells.append([radius, k])
            radius += 4 * spacing / 2 ** (k - 1)

    thin = thin_level(shape, finest / 2**wall)
    points = shape.surface()[0]
    tip = points[points[:, 0].argmin()] * [-1, 1, 1]

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
    layers = 1 + max(0, ceil(log(_LAST / first) / log(_EXPANSION) - 1e-9))

    # Of the box, of each shell (the volume within a distance of a convex body, Steiner's formula), and of the wall
    share = 1.0 if full else 0.5
    count = np.prod(cells) - share * shape.volume / spacing**3
    for distance, k in shells:
        within = shape.wetted_area * distance + pi * length * distance**2 + 4 / 3 * pi * distance**3
        count += share * within * 7 * 8 ** (k - 1) / spacing**3
    faces = share * shape.wetted_area / (finest / 2**wall) ** 2
    if thin:
        count += share * thin_triangles(shape, finest / 2**wall)[1] * 4**thin / (finest / 2**wall) ** 2 * (layers + _EDGE_CELLS)
    count += faces * (_EDGE_FACES * (layers + _EDGE_CELLS) if edge > wall else layers)
    return [("Snapped body mesh", {
        "snappedBox": box,
        "snappedCells": cells,
        "snappedWallLevel": base + wall, "snappedEdgeLevel": base + edge, "snappedNoseLevel": base + nose,
        "snappedNose": [float(x) + 0.0 for x in tip], "snappedNoseReach": 2 * max(shape.nose_radius, finest / 2**nose),
        "snappedShells": shells if shells else [[finest, 0]],
        "snappedWallSpacing": finest / 2**wall, "snappedNoseSpacing": finest / 2**nose,
        "snappedThin": "yes" if thin else "no", "snappedThinLevel": base + wall + thin, "snappedThinReach": finest / 2**wall,
        "snappedLayers": layers, "snappedFirstLayer": first, "snappedExpansion": _EXPANSION,
        # In a corner cell, off its faces
        "snappedLocation": [float(x - 0.37 * spacing) for x in box[6]],
        # How far the outer boundary is from the axis: the background's finest shell reaches farther
        "snappedReach": float(max(np.hypot(y, z) for _, y, z in box)),
        "snappedEstimatedCells": round(float(count), -2),
    })]


def thickness(shape: Surface) -> tuple[np.ndarray, np.ndarray]:
    """Of the body behind each triangle, along its normal, and the triangle's area [m, m2]."""
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkFiltersGeneral import vtkOBBTree

    points, triangles = shape.surface()
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    normal = np.cross(b - a, c - a)
    twice = np.linalg.norm(normal, axis=1)
    inwards = -normal / np.maximum(twice, 1e-300)[:, None]
    size = np.linalg.norm(np.ptp(points, axis=0))
    start = (a + b + c) / 3 + 1e-6 * size * inwards
    tree, hits = vtkOBBTree(), vtkPoints()
    tree.SetDataSet(polydata(points, triangles))
    tree.SetTolerance(1e-12)
    tree.BuildLocator()
    found = np.full(len(triangles), size)
    for k, (x, n) in enumerate(zip(start, inwards)):
        if tree.IntersectWithLine(x, x + size * n, hits, None):
            found[k] = min(np.linalg.norm(np.subtract(hits.GetPoint(i), x)) for i in range(hits.GetNumberOfPoints()))
    return found, twice / 2


def thin_triangles(shape: Surface, cell: float) -> tuple[np.ndarray, float]:
    """Which have less than _THIN cells of this size behind them, and their area [m2]."""
    deep, area = thickness(shape)
    thin = deep < _THIN * cell
    return thin, float(area[thin].sum())


def thin_level(shape: Surface, cell: float) -> int:
    """How often cells of this size are halved where the body is thin."""
    deep, area = thickness(shape)
    halvings = 0
    while halvings < _THIN_HALVINGS and area[deep < cell / 2**halvings].sum() > _THIN_IGNORED * area.sum():
        halvings += 1
    return halvings


def check_meshed(shape: Surface, run: Path, full: bool, spacing: float) -> str:
    """What of the body's volume and area the mesh has, whose wall surfaceMeshExtract has written to <run>/body/meshed.stl; an
    error where more than 5 % of either is lost. `spacing` is that of the wall's cells [m]."""
    points, triangles = read_triangles(run / "body/meshed.stl")
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    normal = np.cross(b - a, c - a) / 2
    share = 1.0 if full else 0.5
    # By the flux of (0, y, 0), none of which passes through the plane of symmetry
    volume = abs(float(normal[:, 1] @ (a + b + c)[:, 1] / 3)) / (share * shape.volume)
    area = float(np.linalg.norm(normal, axis=1).sum()) / (share * shape.wetted_area)
    said = f"the mesh has {100 * volume:.4g} % of the body's volume and {100 * area:.4g} % of its area"
    if min(volume, area) < 1 - _MOST_LOST:
        raise SurfaceError(f"{shape.file}: {said}: parts of it are too thin for cells of {spacing:.3g} m at the wall; expected at least "
                           f"{100 * (1 - _MOST_LOST):g} %: a higher -resolution or -tier, or thicker parts")
    return said


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


def tips(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Points of a closed surface that are sharp without an edge that is, a cone's, each with a neighbour on the surface:
    pairs of point numbers."""
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    legs = np.roll(corners, -1, axis=1) - corners
    lengths = np.linalg.norm(legs, axis=2)
    cosines = -np.einsum("ijk,ijk->ij", legs, np.roll(legs, 1, axis=1)) / np.maximum(lengths * np.roll(lengths, 1, axis=1), 1e-300)
    # What the angles about a point lack of a full turn
    lack = np.full(len(points), 2 * np.pi)
    np.subtract.at(lack, triangles, np.arccos(np.clip(cosines, -1, 1)))

    sides = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    owner = np.arange(len(sides)) // 3
    order = np.lexsort(np.sort(sides, axis=1).T)
    edges, owner = sides[order[::2]], owner[order].reshape(-1, 2)
    sharp = np.einsum("ij,ij->i", *normals[owner.T]) < np.cos(_SHARP)
    lack[edges[sharp]] = 0
    both = np.vstack((edges, edges[:, ::-1]))
    both = both[lack[both[:, 0]] > _TIP]
    # The neighbour nearest to the plane of symmetry
    both = both[np.argsort(np.abs(points[both[:, 1], 1]), kind="stable")]
    return both[np.unique(both[:, 0], return_index=True)[1]]


def write_surface(shape: Surface, run: Path, cell: float) -> None:
    """Write what is meshed, in the body's frame, to <run>/body/constant/triSurface: body.stl, of it thin.stl where it is thin for
    cells of this size [m], if it is anywhere, and, of its tips, tips.eMesh."""
    points, triangles = shape.surface()
    points, folder = points * [-1, 1, 1], run / "body/constant/triSurface"
    write_stl(folder / "body.stl", points, triangles[:, ::-1])
    thin, _ = thin_triangles(shape, cell)
    if thin.any():
        write_stl(folder / "thin.stl", points, triangles[thin, ::-1])

    # Lines that are short, for the mesh follows them: it is their first points that matter
    found = tips(points, triangles)
    start, way = points[found[:, 0]], points[found[:, 1]] - points[found[:, 0]]
    far = np.linalg.norm(way, axis=1, keepdims=True)
    ends = np.stack((start, start + way * np.minimum(1, _TIP_LINE * shape.length / far)), axis=1).reshape(-1, 3)
    lines = [f"({2 * k} {2 * k + 1})" for k in range(len(found))]
    (folder / "tips.eMesh").write_text(
        "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       featureEdgeMesh;\n    object      tips.eMesh;\n}\n\n"
        f"{len(ends)}\n(\n" + "\n".join(f"({x:.9g} {y:.9g} {z:.9g})" for x, y, z in ends) + "\n)\n\n"
        f"{len(lines)}\n(\n" + "\n".join(lines) + "\n)\n")
