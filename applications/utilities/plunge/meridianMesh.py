# SPDX-License-Identifier: GPL-3.0-or-later
"""The body's own mesh: layers of cells along a meridian's normals.

A meridian grid X(u, t), u along the body and t from the wall to the outer surface, is

- revolved about the axis (half, full), without cells collapsed on it: within the first and last `capCells + ringCells` cells along
  the body the polar grid of the surface is replaced by a butterfly, a square of 2*capCells by 2*capCells quadrilaterals around the
  axis, and a ring of ringCells that leads to the circle, which has 8*capCells cells (the half model has half of all that);
- turned by 2.5 degrees to either side (axisymmetric);
- mirrored in the axis, or met there by the grid of the outline's other side, and made 1 m deep (plane).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import ceil, log
from typing import Iterator

import numpy as np
from scipy.interpolate import PchipInterpolator
from scipy.optimize import brentq

from plunge.shapes import Curve, Plane, Revolution, Shape


class MeshError(Exception):
    """A mesh that cannot be made."""


@dataclass(frozen=True)
class MeshSize:
    """Cell sizes and layer counts of the body mesh; lengths [m]."""

    cap_cells: int        # from the axis to the edge of the square
    ring_cells: int       # from the edge of the square to the circle
    axial_cells: tuple[int, ...]  # from nose to tail, of each smooth piece of the meridian
    layers: int           # from the wall to the outer surface
    outer_layers: int     # from there on to the far boundary, of a mesh that has no background; else 0
    nose_spacing: float   # along the meridian, at the nose
    body_spacing: float   # the longest along the meridian
    tail_spacing: float   # at the edge of the tail's cap
    corner_spacing: float  # at corners between
    growth: float         # of the spacing per unit of arc length
    offset: tuple[float, float, float]     # from the wall to the outer surface at nose, thickest section, tail
    stretching: tuple[float, float, float]  # ln(outermost layer/first layer), same places
    reach: float          # from the wall to the far boundary


# In the cap of a pointed tail the arc length from the tip goes with this power of the number of cells. On a slender cone the
# butterfly's cells are sheared; longer cells towards the tip halve that, and cost no time step.
_TIP_POWER = 0.6
# Angle of the normal at the tail, from the axis, above which the tail is pointed [rad]; else it is round or flat
_POINTED = np.radians(20)


def cap_cells(size: MeshSize) -> int:
    """Cells along the body in each of the two caps."""
    return size.cap_cells + size.ring_cells


def _tip_power(curve: Curve) -> float:
    last = len(curve.breaks) - 2
    return _TIP_POWER if abs(float(curve.normal_angle(np.array([1.0]), last)[0])) > _POINTED else 1.0


def _tail_cap_length(curve: Curve, size: MeshSize) -> float:
    """Arc length of the tail's cap [m], such that the spacing is continuous at its edge; at most most of the last piece."""
    begin, end = curve.arc_length(np.array(curve.breaks[-2:]))
    return min(cap_cells(size) * size.tail_spacing / _tip_power(curve), 0.8 * (end - begin))


def _spacing(curve: Curve, size: MeshSize, s: np.ndarray, tail_cap: float) -> np.ndarray:
    """Wanted spacing at arc length s: constant over the nose, least at the tail's cap, which begins at tail_cap, and at corners,
    growing between."""
    breaks = curve.arc_length(np.array(curve.breaks))
    nose = size.nose_spacing + size.growth * np.maximum(0, s - 2 * curve.nose_radius)
    tail = size.tail_spacing + size.growth * (tail_cap - s)
    inverse = nose**-4 + tail**-4 + size.body_spacing**-4
    for corner in breaks[1:-1]:
        inverse = inverse + (size.corner_spacing + size.growth * np.abs(s - corner)) ** -4
    return inverse ** -0.25


def axial_cell_counts(curve: Curve, size: MeshSize) -> tuple[int, ...]:
    """Cells of each piece from nose to tail that the wanted spacings ask for: at least a cap, and one more, in the first and last."""
    breaks = curve.arc_length(np.array(curve.breaks))
    tail = breaks[-1] - _tail_cap_length(curve, size)
    cap, last = cap_cells(size), len(breaks) - 2
    counts = []
    for piece, (begin, end) in enumerate(zip(breaks, breaks[1:])):
        s = np.linspace(begin, min(end, tail), 20001)
        cells = float(np.trapz(1 / _spacing(curve, size, s, tail), s)) + (cap if piece == last else 0)
        fewest = (cap + 1) * ((piece == 0) + (piece == last)) or 2
        counts.append(max(round(cells), fewest))
    return tuple(counts)


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


def _monotone(angle: np.ndarray) -> np.ndarray:
    """Angles that nowhere grow from nose to tail, so that lines do not cross however far they reach: those of a hollow are made one."""
    return (np.minimum.accumulate(angle) + np.maximum.accumulate(angle[::-1])[::-1]) / 2


class Meridian:
    """The grid in a half plane through the axis: point(u, t) with u in [0, sum(axial_cells)], t in [0, layers + outer_layers]."""

    def __init__(self, curve: Curve, size: MeshSize):
        self.size = size
        cap = cap_cells(size)
        pieces = range(len(curve.breaks) - 1)
        tail_cap = _tail_cap_length(curve, size)
        ends = curve.arc_length(curve.samples(pieces[-1]))
        tail_begin = float(ends[ends <= ends[-1] - tail_cap][-1])
        power = _tip_power(curve)
        total = sum(size.axial_cells)
        corners = np.concatenate(([0], np.cumsum(size.axial_cells)))  # u there

        all_u, all_c, angles = [], [], []
        for piece in pieces:
            c = curve.samples(piece)
            s = curve.arc_length(c)
            last = piece == pieces[-1]
            cells = size.axial_cells[piece] - (cap if last else 0)
            before = s <= s[-1] - tail_cap if last else np.ones(len(s), bool)
            density = 1 / _spacing(curve, size, s[before], tail_begin)
            u = np.concatenate(([0], np.cumsum((density[1:] + density[:-1]) / 2 * np.diff(s[before]))))
            u *= cells / u[-1]
            if last:
                to_tip = s[-1] - s[~before]
                u = np.concatenate((u, size.axial_cells[piece] - cap * (to_tip / tail_cap) ** (1 / power)))
            first = 0 if piece == 0 else 1  # a corner is there already
            all_u.append((corners[piece] + u)[first:])
            all_c.append(c[first:])
            angles.append(curve.normal_angle(c, piece)[first:])

        u, c = np.concatenate(all_u), np.concatenate(all_c)
        self._curve = curve
        self._c = PchipInterpolator(u, c)

        # Where the normal jumps (a pointed nose or tail, corners) the lines turn to the mean of its two angles, at the wall just
        # before the jump, at the outer surface from well before the cap, to keep it round. The powers were chosen for the least
        # non-orthogonality of a pointed tail.
        def turned(width: float, exponent: float) -> np.ndarray:
            parts = []
            for piece in pieces:
                angle, at = angles[piece], all_u[piece]
                begin, end = angles[piece][0], angles[piece][-1]
                middle = 0.0 if piece == pieces[-1] else (end + angles[piece + 1][0]) / 2
                if abs(middle - end) > 1e-12:
                    weight = np.clip(1 - (corners[piece + 1] - at) / width, 0, 1) ** exponent
                    angle = angle * (1 - weight) + middle * weight
                middle = np.pi if piece == 0 else (begin + angles[piece - 1][-1]) / 2
                if abs(middle - begin) > 1e-12:
                    weight = np.clip(1 - (at - corners[piece]) / width, 0, 1) ** exponent
                    angle = angle * (1 - weight) + middle * weight
                parts.append(angle)
            return np.concatenate(parts)

        self._wall_angle = PchipInterpolator(u, turned(cap, 6))
        self._outer_angle = PchipInterpolator(u, _monotone(turned(1.7 * cap, 1.8)))

        middle = np.clip(np.interp(curve.widest, c, u), cap, total - cap)
        knots = [0, middle, u[-1]]
        self._offset = PchipInterpolator(knots, size.offset)
        self._stretching = PchipInterpolator(knots, size.stretching)
        if size.outer_layers:
            self._outer_stretching = PchipInterpolator(knots, [_outer_stretching(size, *at) for at in zip(size.offset, size.stretching)])

    def point(self, u: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Distance from the nose along the axis and distance from the axis [m]."""
        x, r = self._curve.point(self._c(u))
        share = _share(self._stretching(u), np.minimum(t, self.size.layers) / self.size.layers)
        wall, outer = self._wall_angle(u), self._outer_angle(u)
        distance = self._offset(u) * share
        x = x + distance * ((1 - share) * np.cos(wall) + share * np.cos(outer))
        r = r + distance * ((1 - share) * np.sin(wall) + share * np.sin(outer))
        if self.size.outer_layers:
            beyond = np.maximum(t - self.size.layers, 0) / self.size.outer_layers
            further = (self.size.reach - self._offset(u)) * _share(self._outer_stretching(u), beyond)
            x += further * np.cos(outer)
            r += further * np.sin(outer)
        return x, r

    def grid(self) -> tuple[np.ndarray, np.ndarray]:
        """x and r of all nodes, (layers + outer_layers + 1, cells along the body + 1); on the axis r is 0."""
        u, t = np.meshgrid(np.arange(sum(self.size.axial_cells) + 1.0), np.arange(self.size.layers + self.size.outer_layers + 1.0))
        x, r = self.point(u, t)
        r[:, [0, -1]] = 0.0
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
    n, m, total = size.cap_cells, size.ring_cells, sum(size.axial_cells)
    cap = cap_cells(size)
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
    front: np.ndarray = field(default_factory=lambda: np.empty((0, 4), int))    # of one layer of cells
    back: np.ndarray = field(default_factory=lambda: np.empty((0, 4), int))


def build(shape: Shape, size: MeshSize, model: str) -> VolumeMesh:
    """The body mesh of a model: half (y >= 0), full, axisymmetric or plane."""
    if model == "plane":
        return _checked(plane(shape, size))
    if model == "axisymmetric":
        return _checked(sector(shape, size))
    half = _checked(extrude(butterfly_surface(size), shape, size))
    return _mirrored(half) if model == "full" else half


# Of an axisymmetric model's sector, in degrees
SECTOR = 5.0


def sector(shape: Revolution, size: MeshSize) -> VolumeMesh:
    """Cells of the meridian grid turned to either side of y = 0; on the axis they are prisms."""
    x, r = Meridian(shape.curve, size).grid()
    turn = np.radians(SECTOR / 2)
    sides = [np.stack((x, sign * r * np.sin(turn), r * np.cos(turn)), axis=-1) for sign in (-1, 1)]
    on_axis = np.zeros(x.shape, bool)
    on_axis[:, [0, -1]] = True
    return _between(sides[0], sides[1], on_axis)


def plane(shape: Plane, size: MeshSize) -> VolumeMesh:
    """Cells about the outline, from y = -0.5 to 0.5."""
    above = Meridian(shape.upper, size)
    below = above if shape.mirrored else Meridian(shape.lower, replace(size, axial_cells=axial_cell_counts(shape.lower, size)))
    x, z = above.grid()
    x_below, z_below = below.grid()
    # Round the body: above from nose to tail, below from tail to nose; the nodes on the axis are shared
    x = np.hstack((x, x_below[:, -2:0:-1]))
    z = np.hstack((z, -z_below[:, -2:0:-1]))
    x, z = (np.hstack((values, values[:, :1])) for values in (x, z))
    sides = [np.stack((x, np.full_like(x, y), z), axis=-1) for y in (-0.5, 0.5)]
    return _between(sides[0], sides[1], np.zeros(x.shape, bool), closed=True)


def _between(near: np.ndarray, far: np.ndarray, shared: np.ndarray, closed: bool = False) -> VolumeMesh:
    """One layer of cells between two copies of a grid (layers + 1, n + 1, 3), which share some nodes; a closed grid ends where it begins."""
    layers, count = near.shape[0], near.shape[1]
    number = np.arange(near[..., 0].size).reshape(layers, count)
    if closed:
        number[:, -1] = number[:, 0]
    other = np.where(shared, number, number + number.size)
    nodes = np.vstack((near.reshape(-1, 3), far.reshape(-1, 3)))

    def corners(of: np.ndarray) -> np.ndarray:
        return np.stack((of[:-1, :-1], of[:-1, 1:], of[1:, 1:], of[1:, :-1]), axis=-1).reshape(-1, 4)

    front, back = corners(number), corners(other)
    cells = np.concatenate((front, back), axis=1)
    wall = np.stack((number[0, :-1], other[0, :-1], other[0, 1:], number[0, 1:]), axis=-1)
    outer = np.stack((number[-1, :-1], number[-1, 1:], other[-1, 1:], other[-1, :-1]), axis=-1)
    used = np.unique(cells)
    renumber = np.full(len(nodes), -1)
    renumber[used] = np.arange(len(used))
    return VolumeMesh(nodes[used], renumber[cells], renumber[wall], renumber[outer], np.empty((0, 4), int),
                      renumber[front], renumber[back])


def cell_faces(mesh: VolumeMesh) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Middle [m] and area vector [m2] of each of the six faces of all cells, (n, 3) each; the vectors point out of cells that are
    wound as gmsh's are."""
    corners = mesh.nodes[mesh.hexahedra]
    for face in ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):
        points = corners[:, face]
        middle = points.mean(axis=1)
        edges = points - middle[:, None]
        yield middle, 0.5 * np.cross(edges, np.roll(edges, -1, axis=1)).sum(axis=1)


def _checked(mesh: VolumeMesh) -> VolumeMesh:
    """The mesh, no cell of which is turned inside out."""
    centre = mesh.nodes[mesh.hexahedra].mean(axis=1)
    volume = sum(np.einsum("ij,ij->i", area, middle - centre) for middle, area in cell_faces(mesh)) / 3
    sign = np.sign(np.median(volume))
    bad = sign * volume <= 0
    if bad.any():
        x, y, z = centre[int(np.argmax(bad))]
        raise MeshError(f"{bad.sum()} of {len(bad)} cells of the body mesh are folded, the first {x:.3g} m aft of the nose and "
                        f"{np.hypot(y, z):.3g} m from the axis; expected a body without hollows that are narrower than the mesh's "
                        "offset: give its surface as an STL (shape surface)")
    return mesh


def extrude(surface: SurfaceGrid, shape: Revolution, size: MeshSize) -> VolumeMesh:
    """Layers of hexahedra over a half surface, along the meridian's lines."""
    meridian = Meridian(shape.curve, size)
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


_NODES = 100    # entity that holds all nodes


def _by_type(cells: np.ndarray, points: np.ndarray) -> list[tuple[int, np.ndarray]]:
    """gmsh's element types and elements of quadrilaterals or hexahedra, some of which are collapsed to triangles or prisms."""
    triangle, quadrilateral, hexahedron, prism = 2, 3, 5, 6
    if cells.shape[1] == 4:
        repeats = cells == np.roll(cells, -1, axis=1)
        whole = ~repeats.any(axis=1)
        rest = cells[~whole][~repeats[~whole]].reshape(-1, 3)
        found = [(quadrilateral, cells[whole]), (triangle, rest)]
    else:
        low, high = cells[:, 0] == cells[:, 4], cells[:, 1] == cells[:, 5]
        found = [(hexahedron, cells[~low & ~high]), (prism, cells[low][:, [0, 1, 5, 3, 2, 6]]),
                 (prism, cells[high][:, [1, 4, 0, 2, 7, 3]])]
        for kind, elements in found:
            # gmshToFoam takes a prism as it is: its first triangle's normal points to the second one
            p = points[elements]
            inverted = np.einsum("ij,ij->i", np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), p[:, 3] - p[:, 0]) < 0
            if kind == prism:
                elements[inverted] = elements[inverted][:, [0, 2, 1, 3, 5, 4]]
    return [(kind, elements) for kind, elements in found if len(elements)]


def write_msh(mesh: VolumeMesh, place: np.ndarray, nose: np.ndarray, path: str) -> dict[str, float]:
    """Hand the mesh to gmsh, write it as .msh 2.2 and return gmsh's quality figures.

    `place` holds the directions of x, y, z as rows, `nose` is the nose's position [m].
    """
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.add("body")
    gmsh.model.addDiscreteEntity(3, _NODES)
    points = mesh.nodes @ place + nose
    gmsh.model.mesh.addNodes(3, _NODES, np.arange(1, len(points) + 1), points.ravel())
    element = 1
    parts = [(2, mesh.wall, "wall"), (2, mesh.outer, "outer"), (2, mesh.symmetry, "plane"),
             (2, mesh.front, "nearSide"), (2, mesh.back, "farSide"), (3, mesh.hexahedra, "bodyMesh")]
    for entity, (dimension, cells, name) in enumerate(parts, 1):
        if not len(cells):
            continue
        gmsh.model.addDiscreteEntity(dimension, entity)
        for kind, elements in _by_type(cells, points):
            gmsh.model.mesh.addElementsByType(entity, kind, np.arange(element, element + len(elements)), (elements + 1).ravel())
            element += len(elements)
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
    open(path, "wb").close()    # Where it cannot be written gmsh does not say why
    gmsh.write(path)
    gmsh.finalize()
    with open(path, "rb") as file:
        file.seek(-20, 2)
        if not file.read().rstrip().endswith(b"$EndElements"):
            raise MeshError(f"{path} could not be written whole; expected a disk with room")
    return quality
