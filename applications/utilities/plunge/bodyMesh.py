# SPDX-License-Identifier: GPL-3.0-or-later
"""The body's own mesh: hexahedra in wall-normal layers, without cells collapsed on the axis.

A meridian grid X(u, t), u along the body and t from the wall to the outer surface, is revolved about the
axis. Within the first and last `capCells + ringCells` cells along the body the polar grid of the surface is
replaced by a butterfly: a square of 2*capCells by 2*capCells quadrilaterals around the axis, and a ring of
ringCells that leads to the circle, which has 8*capCells cells (the half model has half of all that).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil, log

import numpy as np
from scipy.interpolate import PchipInterpolator
from scipy.optimize import brentq

from plunge.bodyGeometry import Body


@dataclass(frozen=True)
class MeshSize:
    """Cell sizes and layer counts of the body mesh; lengths [m]."""

    cap_cells: int        # from the axis to the edge of the square
    ring_cells: int       # from the edge of the square to the circle
    axial_cells: int      # from nose to tail
    layers: int           # from the wall to the outer surface
    outer_layers: int     # from there on to the far boundary, of a mesh that has no background; else 0
    nose_spacing: float   # along the meridian, at the nose
    body_spacing: float   # the longest along the meridian
    tail_spacing: float   # at the edge of the tail's cap
    growth: float         # of the spacing per unit of arc length
    offset: tuple[float, float, float]     # from the wall to the outer surface at nose, thickest section, tail
    stretching: tuple[float, float, float]  # ln(outermost layer/first layer), same places
    reach: float          # from the wall to the far boundary


# In the tail's cap the arc length from the tip goes with this power of the number of cells. On a slender cone the
# butterfly's cells are sheared; longer cells towards the tip halve that, and cost no time step.
_TIP_POWER = 0.6


def _cap(size: MeshSize) -> int:
    """Cells along the body in each of the two caps."""
    return size.cap_cells + size.ring_cells


def _tail_cap_length(size: MeshSize) -> float:
    """Arc length of the tail's cap [m], such that the spacing is continuous at its edge."""
    return _cap(size) * size.tail_spacing / _TIP_POWER


def _spacing(body: Body, size: MeshSize, s: np.ndarray) -> np.ndarray:
    """Wanted spacing at arc length s: constant over the nose, least at the tail's cap, growing between."""
    nose = size.nose_spacing + size.growth * np.maximum(0, s - 2 * body.nose_radius)
    tail = size.tail_spacing + size.growth * (s[-1] - s)
    return (nose**-4 + tail**-4 + size.body_spacing**-4) ** -0.25


def axial_cell_count(body: Body, size: MeshSize) -> float:
    """Cells from nose to tail that the wanted spacings ask for."""
    end = body.arc_length(np.array([1.0]))[0] - _tail_cap_length(size)
    s = np.linspace(0, end, 20001)
    return float(np.trapz(1 / _spacing(body, size, s), s)) + _cap(size)


def _share(stretching: np.ndarray | float, t: np.ndarray | float) -> np.ndarray | float:
    """Of the way that a share t of geometrically growing layers goes."""
    return np.expm1(stretching * t) / np.expm1(stretching)


def _last_layer(size: MeshSize, offset: float, stretching: float) -> float:
    """Thickness of the layer at the outer surface [m]."""
    return offset * (1 - _share(stretching, 1 - 1 / size.layers))


def first_layers(size: MeshSize) -> tuple[float, ...]:
    """Thickness of the layer at the wall [m] at nose, thickest section, tail."""
    return tuple(float(offset * _share(stretching, 1 / size.layers)) for offset, stretching in zip(size.offset, size.stretching))


def with_first_layer(size: MeshSize, most: float) -> MeshSize:
    """The mesh with a layer at the wall of at most `most` [m]: more layers and more stretching, to the same outer surface.
    There they are no thicker than the thickest one was."""
    if most >= max(first_layers(size)):
        return size
    first = [min(most, own) for own in first_layers(size)]
    last = max(_last_layer(size, *at) for at in zip(size.offset, size.stretching))
    # Geometric series from the first to the last that add up to the offset
    layers = ceil(max(1 + log(last / a) / log((d - a) / (d - last)) for d, a in zip(size.offset, first)) - 1e-6)
    stretching = tuple(brentq(lambda s: d * _share(s, 1 / layers) - a, 1e-3, 50) for d, a in zip(size.offset, first))
    return replace(size, layers=layers, stretching=stretching)


def _outer_stretching(size: MeshSize, offset: float, stretching: float) -> float:
    """ln(outermost layer/first layer) of the outer layers, the first of which is as thick as the last one within."""
    last = _last_layer(size, offset, stretching)
    return brentq(lambda b: (size.reach - offset) * _share(b, 1 / size.outer_layers) - last, 1e-3, 50)


class Meridian:
    """The grid in a half plane through the axis: point(u, t) with u in [0, axial_cells], t in [0, layers + outer_layers]."""

    def __init__(self, body: Body, size: MeshSize):
        self.size = size
        c = np.linspace(0, 1, 20001)
        s = body.arc_length(c)
        cap = _cap(size)
        before = s <= s[-1] - _tail_cap_length(size)
        density = 1 / _spacing(body, size, s[before])
        u = np.concatenate(([0], np.cumsum((density[1:] + density[:-1]) / 2 * np.diff(s[before]))))
        u *= (size.axial_cells - cap) / u[-1]
        to_tip = s[-1] - s[~before]
        u = np.concatenate((u, size.axial_cells - cap * (to_tip / _tail_cap_length(size)) ** (1 / _TIP_POWER)))
        self._body = body
        self._c = PchipInterpolator(u, c)

        angle = body.normal_angle(c)
        # The tail is the tip of a cone: there the lines turn from the cone's normal to the axis, at the wall
        # just before the tip, at the outer surface from well before the cap, to keep it round. The powers
        # were chosen for the least non-orthogonality.
        to_tip = size.axial_cells - u
        self._wall_angle = PchipInterpolator(u, angle * (1 - np.clip(1 - to_tip / cap, 0, 1) ** 6))
        self._outer_angle = PchipInterpolator(u, angle * (1 - np.clip(1 - to_tip / (1.7 * cap), 0, 1) ** 1.8))

        middle = np.interp(np.sqrt(0.3), c, u)
        knots = [0, middle, u[-1]]
        self._offset = PchipInterpolator(knots, size.offset)
        self._stretching = PchipInterpolator(knots, size.stretching)
        if size.outer_layers:
            self._outer_stretching = PchipInterpolator(knots, [_outer_stretching(size, *at) for at in zip(size.offset, size.stretching)])

    def point(self, u: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Distance from the nose along the axis and distance from the axis [m]."""
        x, r = self._body.point(self._c(u))
        share = _share(self._stretching(u), np.minimum(t, self.size.layers) / self.size.layers)
        wall, outer = self._wall_angle(u), self._outer_angle(u)
        distance = self._offset(u) * share
        x += distance * ((1 - share) * np.cos(wall) + share * np.cos(outer))
        r += distance * ((1 - share) * np.sin(wall) + share * np.sin(outer))
        if self.size.outer_layers:
            beyond = np.maximum(t - self.size.layers, 0) / self.size.outer_layers
            further = (self.size.reach - self._offset(u)) * _share(self._outer_stretching(u), beyond)
            x += further * np.cos(outer)
            r += further * np.sin(outer)
        return x, r


@dataclass
class SurfaceGrid:
    """Quadrilaterals on a surface of revolution; nodes are given by (u, cos phi, sin phi)."""

    u: np.ndarray
    cos_phi: np.ndarray
    sin_phi: np.ndarray
    quads: np.ndarray  # (n, 4) node numbers


# How far the butterfly's square is rounded towards a disc: 0 not at all, 1 entirely. More opens the cells at its
# corners and takes from the ring beyond them; chosen for the longest time step at the nose, where the flow
# is fast over the corners, and between time step and non-orthogonality on the tail's cone.
_ROUNDING = {"nose": 0.25, "tail": 0.6}


def _disc(size: MeshSize, rounding: float) -> tuple[np.ndarray, np.ndarray]:
    """Half disc 0 <= y of the butterfly: the square's nodes (2n+1, n+1, 2) and the ring's (m, 4n+1, 2)."""
    n, m = size.cap_cells, size.ring_cells
    p, q = np.meshgrid(np.arange(-n, n + 1) / n, np.arange(0, n + 1) / n, indexing="ij")
    disc = np.stack((p * np.sqrt(1 - q**2 / 2), q * np.sqrt(1 - p**2 / 2)), axis=-1)
    square = 0.93 * n / (n + m) * ((1 - rounding) * np.stack((p, q), axis=-1) + rounding * disc)

    rim = square[_rim(n)[:, 0], _rim(n)[:, 1]]
    phi = np.pi * np.arange(4 * n + 1) / (4 * n)
    circle = np.stack((np.cos(phi), np.sin(phi)), axis=-1)
    weight = (np.arange(1, m + 1) / m)[:, None, None]
    return square, (1 - weight) * rim + weight * circle


def _rim(n: int) -> np.ndarray:
    """Indices of the square's nodes along its edge, from phi = 0 to phi = pi."""
    return np.array(
        [(2 * n, j) for j in range(n)] + [(i, n) for i in range(2 * n, 0, -1)] + [(0, j) for j in range(n, -1, -1)]
    )


def butterfly_surface(size: MeshSize) -> SurfaceGrid:
    """The half surface, 0 <= phi <= pi: butterfly caps at nose and tail, (u, phi) cells between."""
    n, m, total = size.cap_cells, size.ring_cells, size.axial_cells
    cap = _cap(size)
    nodes: list[np.ndarray] = []   # (u, cos, sin) blocks
    quads: list[np.ndarray] = []
    count = 0

    def add(u: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
        """Append nodes; return their numbers in the shape of u."""
        nonlocal count
        nodes.append(np.stack((u, y, z), axis=-1).reshape(-1, 3))
        numbers = np.arange(count, count + u.size).reshape(u.shape)
        count += u.size
        return numbers

    def patch(grid: np.ndarray, flip: bool) -> None:
        corners = np.stack((grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]), axis=-1).reshape(-1, 4)
        quads.append(corners[:, ::-1] if flip else corners)

    def polar(points: np.ndarray, tail: bool) -> np.ndarray:
        radius = np.hypot(points[..., 0], points[..., 1])
        safe = np.where(radius > 0, radius, 1)
        u = cap * radius
        return add(total - u if tail else u, points[..., 0] / safe, points[..., 1] / safe)

    circles = []
    for tail in (False, True):
        square, ring = _disc(size, _ROUNDING["tail" if tail else "nose"])
        core = polar(square, tail)
        rings = np.vstack((core[_rim(n)[:, 0], _rim(n)[:, 1]][None], polar(ring, tail)))
        patch(core, flip=not tail)
        patch(rings, flip=not tail)
        circles.append(rings[-1])

    phi = np.pi * np.arange(4 * n + 1) / (4 * n)
    u = np.arange(cap + 1, total - cap, dtype=float)
    between = add(*np.broadcast_arrays(u[:, None], np.cos(phi), np.sin(phi)))
    patch(np.vstack((circles[0][None], between, circles[1][None])), flip=True)

    table = np.vstack(nodes)
    # On the plane of symmetry sin(phi) is exactly zero.
    sin_phi = np.where(np.abs(table[:, 2]) < 1e-12, 0.0, table[:, 2])
    return SurfaceGrid(table[:, 0], table[:, 1], sin_phi, np.vstack(quads))


@dataclass
class VolumeMesh:
    """Nodes [m] in (x aft from the nose, y, z dorsal) and the elements of each part, as node numbers."""

    nodes: np.ndarray
    hexahedra: np.ndarray
    wall: np.ndarray
    outer: np.ndarray
    symmetry: np.ndarray


def build(body: Body, size: MeshSize, full: bool) -> VolumeMesh:
    """The body mesh: half, y >= 0, or `full` with its mirror image."""
    half = extrude(butterfly_surface(size), body, size)
    return _mirrored(half) if full else half


def extrude(surface: SurfaceGrid, body: Body, size: MeshSize) -> VolumeMesh:
    """Layers of hexahedra over a half surface, along the meridian's lines."""
    meridian = Meridian(body, size)
    count = size.layers + size.outer_layers
    layers = []
    for k in range(count + 1):
        x, r = meridian.point(surface.u, np.full_like(surface.u, k))
        layers.append(np.stack((x, r * surface.sin_phi, r * surface.cos_phi), axis=-1))
    nodes = np.vstack(layers)
    stride = len(surface.u)

    lower = surface.quads[None] + stride * np.arange(count)[:, None, None]
    hexahedra = np.concatenate((lower, lower + stride), axis=-1).reshape(-1, 8)
    wall = surface.quads[:, ::-1]
    outer = surface.quads + stride * count

    edges = np.vstack([surface.quads[:, [a, (a + 1) % 4]] for a in range(4)])
    _, first, counts = np.unique(np.sort(edges, axis=1), axis=0, return_index=True, return_counts=True)
    open_edges = edges[first[counts == 1]]
    low = open_edges[None] + stride * np.arange(count)[:, None, None]
    symmetry = np.concatenate((low, low[..., ::-1] + stride), axis=-1).reshape(-1, 4)

    return VolumeMesh(nodes, hexahedra, wall, outer, symmetry)


def _mirrored(half: VolumeMesh) -> VolumeMesh:
    """The half mesh and its image in y = 0; the nodes on the plane are shared."""
    off_plane = half.nodes[:, 1] != 0
    image = np.arange(len(half.nodes))
    image[off_plane] = len(half.nodes) + np.arange(off_plane.sum())
    nodes = np.vstack((half.nodes, half.nodes[off_plane] * [1, -1, 1]))

    def with_image(quads: np.ndarray) -> np.ndarray:
        return np.vstack((quads, image[quads[:, ::-1]]))

    turned = half.hexahedra[:, [3, 2, 1, 0, 7, 6, 5, 4]]
    return VolumeMesh(
        nodes,
        np.vstack((half.hexahedra, image[turned])),
        with_image(half.wall),
        with_image(half.outer),
        np.empty((0, 4), dtype=int),
    )


def write_msh(mesh: VolumeMesh, place: np.ndarray, nose: np.ndarray, path: str) -> dict[str, float]:
    """Hand the mesh to gmsh, write it as .msh 2.2 and return gmsh's quality figures.

    `place` holds the directions of x, y, z as rows, `nose` is the nose's position [m].
    """
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.add("body")
    for entity in (1, 2, 3):
        gmsh.model.addDiscreteEntity(2, entity)
    gmsh.model.addDiscreteEntity(3, 1)
    tags = np.arange(1, len(mesh.nodes) + 1)
    gmsh.model.mesh.addNodes(3, 1, tags, (mesh.nodes @ place + nose).ravel())
    quadrilateral, hexahedron, element = 3, 5, 1
    parts = [(2, 1, mesh.wall, "wall"), (2, 2, mesh.outer, "outer"), (2, 3, mesh.symmetry, "plane"),
             (3, 1, mesh.hexahedra, "bodyMesh")]
    for dimension, entity, cells, name in parts:
        if not len(cells):
            continue
        gmsh.model.mesh.addElementsByType(
            entity, hexahedron if dimension == 3 else quadrilateral,
            np.arange(element, element + len(cells)), (cells + 1).ravel())
        element += len(cells)
        group = gmsh.model.addPhysicalGroup(dimension, [entity])
        gmsh.model.setPhysicalName(dimension, group, name)

    quality = {}
    for measure in ("IGEMeasure", "ICNMeasure"):
        for other in ("JacobianDeterminant", "IGEMeasure", "ICNMeasure"):
            gmsh.plugin.setNumber("AnalyseMeshQuality", other, float(other == measure))
        gmsh.plugin.setNumber("AnalyseMeshQuality", "DimensionOfElements", 3)
        gmsh.plugin.setNumber("AnalyseMeshQuality", "CreateView", 1)
        gmsh.plugin.run("AnalyseMeshQuality")
        kinds, _, data, _, _ = gmsh.view.getModelData(gmsh.view.getTags()[-1], 0)
        values = np.array([value[0] for value in data])
        quality[measure] = float(values.min())
        quality[measure + " mean"] = float(values.mean())

    gmsh.option.setNumber("Mesh.MshFileVersion", 2.2)
    gmsh.option.setNumber("Mesh.Binary", 0)
    gmsh.write(path)
    gmsh.finalize()
    return quality
