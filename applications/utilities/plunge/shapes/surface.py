# SPDX-License-Identifier: GPL-3.0-or-later
"""A body given as a closed surface of triangles: an STL (ascii or binary) or OBJ file in any units and axes."""

from __future__ import annotations

import multiprocessing
from functools import cached_property
from pathlib import Path
from typing import Any, Sequence

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from plunge.shapes.ellipsoid import ellipsoid_added_mass
from plunge.shapes.shape import Shape, ShapeError

_READERS = {".stl": "vtkSTLReader", ".obj": "vtkOBJReader"}

# Points nearer to each other than this share of the diagonal are one: many times the rounding of an STL's single precision.
_MERGED = 1e-6
# Triangles pass through each other where the ends of an edge are farther than this share of the diagonal from a plane that it crosses
_CROSSED = 1e-5
# By this share of the diagonal one of two parts is moved before they are united, more at each try: of bodies that are drawn with a plane of
# symmetry, edges meet edges exactly, where VTK's filter does not end.
_MOVED = (1e-6, 3e-6, 1e-5)
_UNITING = 30.0     # [s], and as many ms as there are triangles: longer no try takes
# Runs of triangles that a message names
_NAMED = 8
# Diameter of a body of revolution over that of the cylinder of its volume and length: a spheroid has 1.22, NACA-0010 1.35
_FULLNESS = 1.3
# Longest and shortest body [m] that is believed
_LONGEST, _SHORTEST = 100.0, 1e-3
# How far the mirror image of a symmetric body may lie from it, in lengths: the facets of a round body need not be mirrored.
_ASYMMETRY = 2e-3
_PROBES = 4000      # points that are mirrored
# Moments of inertia within this ratio are equal; the file's axis is taken for a principal one within this angle [deg], since
# bodies are drawn along axes and a fin tilts the principal one.
_EQUAL, _NEAR = 0.02, 15.0
# An end whose section, this share of the length behind it, is more than half of the largest one is flat.
_CAP = 0.01


class SurfaceError(ShapeError):
    """A surface that cannot be a body; the message names file, place and what is expected."""


def _edges(triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Edges as sorted pairs of points, for each side of each triangle the number of its edge, and how many triangles share it."""
    sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, number, shared = np.unique(sides, axis=0, return_inverse=True, return_counts=True)
    return edges, number.ravel(), shared


def _parts(pairs: np.ndarray, count: int) -> np.ndarray:
    """Number of the connected part that each of `count` nodes belongs to."""
    return connected_components(coo_matrix((np.ones(len(pairs)), pairs.T), shape=(count, count)), directed=False)[1]


def _volume(points: np.ndarray, triangles: np.ndarray) -> float:
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def polydata(points: np.ndarray, triangles: np.ndarray) -> Any:
    """Triangles as VTK has them."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    corners, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    corners.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, dtype=np.int64).ravel(), deep=True))
    data.SetPoints(corners)
    data.SetPolys(cells)
    return data


def _triangles_of(data: Any) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles of a vtkPolyData whose polygons are triangles."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    if not data.GetNumberOfPolys():
        return np.empty((0, 3)), np.empty((0, 3), dtype=int)
    return (vtk_to_numpy(data.GetPoints().GetData()).astype(float),
            vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(int))


def _distance(points: np.ndarray, triangles: np.ndarray, probes: np.ndarray) -> np.ndarray:
    """Distance of the probes from the surface, negative inside."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkDoubleArray
    from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

    function, found = vtkImplicitPolyDataDistance(), vtkDoubleArray()
    function.SetInput(polydata(points, triangles))
    function.FunctionValue(numpy_to_vtk(np.ascontiguousarray(probes, dtype=float), deep=True), found)
    return vtk_to_numpy(found).copy()


def read_triangles(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles of an STL or OBJ file, as they are there."""
    from vtkmodules import vtkIOGeometry
    from vtkmodules.vtkCommonCore import vtkObject
    from vtkmodules.vtkFiltersCore import vtkTriangleFilter

    name = _READERS.get(path.suffix.lower())
    if name is None:
        raise SurfaceError(f"{path}: expected a file that ends in {' or '.join(_READERS)}")
    if not path.is_file():
        raise SurfaceError(f"{path}: cannot be read; expected an STL or OBJ file")
    reader, triangulated = getattr(vtkIOGeometry, name)(), vtkTriangleFilter()
    reader.SetFileName(str(path))
    triangulated.SetInputConnection(reader.GetOutputPort())
    triangulated.PassVertsOff()
    triangulated.PassLinesOff()
    loud = vtkObject.GetGlobalWarningDisplay()
    vtkObject.GlobalWarningDisplayOff()
    triangulated.Update()
    vtkObject.SetGlobalWarningDisplay(loud)
    points, triangles = _triangles_of(triangulated.GetOutput())
    if not len(triangles):
        raise SurfaceError(f"{path}: has no triangles; expected the surface of a body")
    if not np.isfinite(points).all():
        raise SurfaceError(f"{path}: has points that are not numbers")
    return points, triangles


def _runs(numbers: np.ndarray) -> str:
    """Ascending numbers of triangles in runs: 0-11 17 20-23."""
    groups = np.split(numbers, 1 + np.flatnonzero(np.diff(numbers) > 1))
    named = " ".join(f"{g[0]}-{g[-1]}" if len(g) > 1 else f"{g[0]}" for g in groups[:_NAMED])
    return f"from 0 the triangles {named}" + (" ..." if len(groups) > _NAMED else "")


def _crossing(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Triangles that pass through others: both ends of an edge of theirs are clearly on either side of a triangle inside which
    it crosses that one's plane, or the reverse."""
    from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
    from vtkmodules.vtkFiltersGeneral import vtkOBBTree

    tree, hits, found = vtkOBBTree(), vtkPoints(), vtkIdList()
    tree.SetDataSet(polydata(points, triangles))
    tree.SetTolerance(1e-12)    # with 0 it finds nothing
    tree.BuildLocator()
    edges, number, _ = _edges(triangles)
    pairs = []
    for edge, (a, b) in enumerate(edges):
        tree.IntersectWithLine(points[a], points[b], hits, found)
        pairs += [(edge, found.GetId(i)) for i in range(found.GetNumberOfIds())]
    if not pairs:
        return np.empty(0, dtype=int)
    edge, met = np.array(pairs).T
    corners, ends = points[triangles[met]], points[edges[edge]]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    height = np.einsum("ikj,ij->ik", ends - corners[:, :1], normal)
    tolerance = _CROSSED * np.linalg.norm(np.ptp(points, axis=0))
    apart = (triangles[met][:, :, None] != edges[edge][:, None, :]).all(axis=(1, 2))
    crossed = apart & (height.prod(axis=1) < 0) & (np.abs(height).min(axis=1) > tolerance)
    owners = np.argsort(number, kind="stable").reshape(-1, 2) // 3    # the two triangles of each edge
    return np.unique(np.concatenate((met[crossed], owners[edge[crossed]].ravel())))


def _merged(points: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Equal points made one; dropped are triangles that have no area because of that, those that lie on each other in pairs and
    enclose nothing, and points that no triangle uses. And the number that each triangle had."""
    points, number = np.unique(points, axis=0, return_inverse=True)
    tolerance = _MERGED * np.linalg.norm(np.ptp(points, axis=0))
    group = _parts(cKDTree(points).query_pairs(tolerance, output_type="ndarray"), len(points))
    _, first = np.unique(group, return_index=True)
    points, triangles = points[first], group[number.ravel()[triangles]]
    a, b, c = triangles.T
    kept = np.flatnonzero((a != b) & (b != c) & (c != a))
    _, first, count = np.unique(np.sort(triangles[kept], axis=1), axis=0, return_index=True, return_counts=True)
    kept = kept[np.sort(first[count % 2 == 1])]
    used, triangles = np.unique(triangles[kept], return_inverse=True)
    return points[used], triangles.reshape(-1, 3), kept


def _checked_closed(points: np.ndarray, triangles: np.ndarray, source: str) -> None:
    edges, _, shared = _edges(triangles)
    bad = edges[shared != 2]
    if not len(bad):
        return
    holes = _parts(bad, len(points))[bad[:, 0]]
    names, counts = np.unique(holes, return_counts=True)
    worst = points[bad[holes == names[counts.argmax()]]].reshape(-1, 3)
    low, high = worst.min(axis=0), worst.max(axis=0)

    def at(point: np.ndarray) -> str:
        return "(" + " ".join(f"{x:.6g}" for x in point) + ")"

    open_edges, crowded = int((shared == 1).sum()), int((shared > 2).sum())
    kinds = [f"{open_edges} open edges" if open_edges else "", f"{crowded} edges with more than two triangles" if crowded else ""]
    raise SurfaceError(
        f"{source}: is not watertight: {' and '.join(filter(None, kinds))}, in {len(names)} place(s); the largest is at "
        f"{at((low + high) / 2)}, from {at(low)} to {at(high)} in the file's units; expected every edge to have two triangles")


def _oriented(points: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The triangles of a closed surface wound outwards, each one's part, and which had to be turned."""
    from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

    _, number, _ = _edges(triangles)
    pairs = np.argsort(number, kind="stable").reshape(-1, 2) // 3
    part = _parts(pairs, len(triangles))
    consistent = vtkPolyDataNormals()
    consistent.SetInputData(polydata(points, triangles))
    consistent.ConsistencyOn()
    consistent.SplittingOff()
    consistent.ComputePointNormalsOff()
    consistent.ComputeCellNormalsOn()   # without normals the filter does nothing
    consistent.Update()
    turned = _triangles_of(consistent.GetOutput())[1]
    for name in range(part.max() + 1):
        own = part == name
        if _volume(points, turned[own]) < 0:
            turned[own] = turned[own, ::-1]
    normals = [np.cross(points[t[:, 1]] - points[t[:, 0]], points[t[:, 2]] - points[t[:, 0]]) for t in (triangles, turned)]
    return turned, part, np.flatnonzero(np.einsum("ij,ij->i", *normals) < 0)


def _unite(one: tuple[np.ndarray, np.ndarray], other: tuple[np.ndarray, np.ndarray], found: Any) -> None:
    """Sends the union of two closed surfaces to a connection, by a filter of VTK that may not end."""
    from vtkmodules.vtkCommonCore import vtkObject
    from vtkmodules.vtkFiltersGeneral import vtkLoopBooleanPolyDataFilter

    vtkObject.GlobalWarningDisplayOff()
    union = vtkLoopBooleanPolyDataFilter()
    union.SetOperationToUnion()
    union.SetInputData(0, polydata(*one))
    union.SetInputData(1, polydata(*other))
    union.Update()
    found.send(_triangles_of(union.GetOutput()))


def _union(one: tuple[np.ndarray, np.ndarray], other: tuple[np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray] | None:
    """Points and triangles of the union of two closed surfaces that overlap, if there is one without triangles that pass through each other;
    None where none can be had."""
    size = np.linalg.norm(np.ptp(np.vstack((one[0], other[0])), axis=0))
    volumes = [_volume(*part) for part in (one, other)]
    fork, folded = multiprocessing.get_context("fork"), None
    for share in _MOVED:
        # Turned a little and moved, off all axes
        turned = other[0] + share * np.cross([0.31, -0.83, 0.47], other[0] - other[0].mean(axis=0))
        receive, send = fork.Pipe(duplex=False)
        child = fork.Process(target=_unite, args=(one, (turned + share * size * np.array([0.59, 0.37, -0.72]), other[1]), send), daemon=True)
        child.start()
        send.close()
        try:
            result = receive.recv() if receive.poll(_UNITING + 1e-3 * (len(one[1]) + len(other[1]))) else None
        except EOFError:
            result = None
        child.kill()
        child.join()
        if result is None or not len(result[1]):
            continue
        result = _merged(*result)[:2]
        if (_edges(result[1])[2] != 2).any() or not max(volumes) < _volume(*result) < sum(volumes):
            continue
        if not len(_crossing(*result)):
            return result
        folded = folded or result
    return folded


def _united(points: np.ndarray, triangles: np.ndarray, part: np.ndarray, number: np.ndarray, source: str,
            notes: list[str]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The one outer surface of all parts: what lies inside another part is dropped, parts that overlap are united. And the triangles that
    have part in it, as they were."""
    parts = [_merged(points, triangles[part == name])[:2] for name in range(part.max() + 1)]
    bySize = sorted(range(len(parts)), key=lambda k: -_volume(*parts[k]))
    named = [_runs(number[part == k]) for k in bySize]
    parts, names = [parts[k] for k in bySize], list(bySize)
    whole, _, used = parts.pop(0), named.pop(0), [names.pop(0)]
    dropped = united = 0
    while parts:
        inside = [_distance(*whole, p[0]) < 0 for p in parts]
        # Points inside, or triangles that cross though no point of one part is inside the other: a wing through a hull
        met = [k for k, (p, i) in enumerate(zip(parts, inside)) if i.any() or (_distance(*p, whole[0]) < 0).any()
               or len(_crossing(np.vstack((whole[0], p[0])), np.vstack((whole[1], p[1] + len(whole[0])))))]
        if not met:
            raise SurfaceError(f"{source}: has {len(parts) + 1} closed parts that do not touch, or in their faces only; expected one body: "
                               f"unite them in the program that made the file. The smallest one has {named[-1]}")
        other, within, its, name = parts.pop(met[0]), inside[met[0]], named.pop(met[0]), names.pop(met[0])
        if within.all():
            dropped += 1
            continue
        result = _union(whole, other)
        if result is None:
            raise SurfaceError(f"{source}: has closed parts that overlap, and they could not be united, one of them {its}; expected one "
                               "closed surface: unite them in the program that made the file")
        whole = result
        used.append(name)
        united += 1
    if dropped:
        notes.append(f"{dropped} closed part(s) inside the body dropped: it is solid")
    if united:
        notes.append(f"{united + 1} closed parts that overlap united")
    return *whole, triangles[np.isin(part, used)]


def _moments(points: np.ndarray, triangles: np.ndarray) -> tuple[float, np.ndarray, np.ndarray]:
    """Volume, centroid and second moments int (x - c)(x - c)^T dV of what the triangles enclose, exact for the polyhedron:
    the sum of the tetrahedra between the triangles and one point."""
    middle = points.mean(axis=0)    # keeps the digits of a body far from its file's origin
    corners = points[triangles] - middle
    six = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
    total = corners.sum(axis=1)
    volume = six.sum() / 6
    centroid = np.einsum("i,ij->j", six, total) / 24 / volume
    second = (np.einsum("i,ij,ik->jk", six, total, total) + np.einsum("i,inj,ink->jk", six, corners, corners)) / 120
    return float(volume), middle + centroid, second - volume * np.outer(centroid, centroid)


def _word(direction: np.ndarray) -> str:
    return "(" + " ".join(f"{x + 0.0:.4g}" for x in direction) + ")"


def _unit(given: Sequence[float], entry: str, source: str) -> np.ndarray:
    direction = np.asarray(given, dtype=float)
    length = np.linalg.norm(direction)
    if direction.shape != (3,) or not np.isfinite(length) or length == 0:
        raise SurfaceError(f"{source}: entry '{entry}' is {given}; expected a direction in the file's axes, e.g. (1 0 0)")
    return direction / length


def _nearest_axis(direction: np.ndarray) -> np.ndarray:
    """The file's axis along a direction, either way."""
    axis = np.zeros(3)
    largest = np.abs(direction).argmax()
    axis[largest] = np.copysign(1, direction[largest])
    return axis


class Surface(Shape):
    """The body inside a closed surface, in the body's frame [m]: origin at the nose (the foremost point's place on the axis
    that runs through the centroid), x aft, y to the side, z dorsal. All of it is exact for the polyhedron but `nose_radius`
    and the added mass.

    `notes` says what was found or changed, and how to overrule it.
    """

    def __init__(self, file: Path, scale: float = 1.0, nose: Sequence[float] | None = None, dorsal: Sequence[float] | None = None):
        self.file, source = Path(file), str(file)
        self.notes: list[str] = []
        if not (np.isfinite(scale) and scale > 0):
            raise SurfaceError(f"{source}: entry 'scale' is {scale}; expected metres per unit of the file, above 0")

        points, triangles, number = _merged(*read_triangles(self.file))
        if not len(triangles):
            raise SurfaceError(f"{source}: all its triangles are points or lines, or lie on each other in pairs; expected the surface of "
                               "a body")
        _checked_closed(points, triangles, source)
        triangles, part, turned = _oriented(points, triangles)
        if len(turned):
            self.notes.append(f"{len(turned)} of {len(triangles)} triangles turned: they were wound inwards, {_runs(number[turned])}")
        for name in range(part.max() + 1):
            own = np.flatnonzero(part == name)
            crossing = own[_crossing(points, triangles[own])]
            if len(crossing):
                place = " ".join(f"{x:.4g}" for x in points[triangles[crossing[0]]].mean(axis=0))
                raise SurfaceError(f"{source}: passes through itself: {len(crossing)} of its {len(triangles)} triangles do, "
                                   f"{_runs(number[crossing])}, the first at ({place}) in the file's units; expected one closed surface")
        drawn = points, triangles
        if part.max() > 0:
            points, triangles, parts = _united(points, triangles, part, number, source, self.notes)
            drawn = drawn[0], parts
        points = points * scale

        size = np.ptp(points, axis=0).max()
        if not _SHORTEST <= size <= _LONGEST:
            raise SurfaceError(f"{source}: the body is {size:.4g} m long with a scale of {scale:g}; expected {_SHORTEST:g} to "
                               f"{_LONGEST:g} m: give the entry 'scale', metres per unit of the file (0.001 for millimetres)")
        self._volume, centroid, second = _moments(points, triangles)
        if self._volume < 1e-9 * size**3:
            raise SurfaceError(f"{source}: encloses no volume; expected the surface of a body")

        forward = self._forward(points, triangles, centroid, second) if nose is None else _unit(nose, "nose", source)
        drawn = drawn[0] * scale - centroid, drawn[1]
        up = self._dorsal(points - centroid, drawn, second, forward, size) if dorsal is None else _unit(dorsal, "dorsal", source)
        up = up - forward * (up @ forward)
        if np.linalg.norm(up) < 1e-3:
            raise SurfaceError(f"{source}: entry 'dorsal' is {dorsal}; expected a direction across the nose's, {_word(forward)}")
        up /= np.linalg.norm(up)

        # Aft, y and dorsal are a left-handed system: what is wound outwards turns round.
        axes = np.stack((-forward, np.cross(up, forward), up))
        self._triangles = triangles[:, ::-1]
        self._points = (points - centroid) @ axes.T
        ahead = self._points[:, 0].min()
        self._points[:, 0] -= ahead
        self._asymmetry = _asymmetry(*drawn, axes[1])
        self.centroid = np.array([-ahead, 0.0, 0.0])
        self._second = axes @ second @ axes.T
        self.length = float(self._points[:, 0].max())

    def _forward(self, points: np.ndarray, triangles: np.ndarray, centroid: np.ndarray, second: np.ndarray) -> np.ndarray:
        """The direction in which a body flies whose nose is not given: along its axis of least inertia, its flat end behind,
        or else its fuller end in front."""
        spread, axes = np.linalg.eigh(second)
        if spread[1] > (1 - _EQUAL) * spread[2]:
            forward = np.array([1.0, 0.0, 0.0])
            self.notes.append("nose: taken as (1 0 0) of the file, no axis of the body stands out; the entry 'nose' overrules it")
            return forward
        axis = axes[:, 2]
        if abs(axis @ _nearest_axis(axis)) > np.cos(np.radians(_NEAR)):
            axis = np.abs(_nearest_axis(axis))

        x = (points - centroid) @ axis
        length = np.ptp(x)
        # Section a little behind either end: what of the volume lies beyond it, over its length
        stations = np.linspace(x.min(), x.max(), 51)
        beyond = np.array([self._volume_before(x, points, triangles, axis, at) for at in stations])
        largest = np.diff(beyond).max() / (length / 50)
        cap = _CAP * length
        low = self._volume_before(x, points, triangles, axis, x.min() + cap) / cap
        high = self._volume_before(-x, points, triangles, -axis, -x.max() + cap) / cap
        flat = [section > 0.5 * largest for section in (low, high)]
        if flat[0] != flat[1]:
            sense, why = (1 if flat[0] else -1), "its flat end is behind"
        elif abs(x.max() + x.min()) > 0.01 * length:
            sense, why = (1 if x.max() < -x.min() else -1), "its fuller end is in front"
        else:
            sense, why = np.sign(axis[np.abs(axis).argmax()]), "both ends are alike"
        forward = sense * axis
        self.notes.append(f"nose: found as {_word(forward)} in the file's axes: along the body, and {why}; the entry 'nose' overrules it")
        return forward

    @staticmethod
    def _volume_before(x: np.ndarray, points: np.ndarray, triangles: np.ndarray, axis: np.ndarray, at: float) -> float:
        """Volume where x < at, x being the points' coordinate along the axis: the flux of (x - at) axis through what of the
        surface lies there, for there is none through the section itself."""
        a, b, c = np.moveaxis(points[triangles], 1, 0)
        projected = np.cross(b - a, c - a) @ axis / 2
        f = np.sort(x[triangles] - at, axis=1).T
        below, above = f[0] < 0, f[2] > 0
        # Of a triangle with one corner below: the small triangle there; with two: all of it less that above
        with np.errstate(divide="ignore", invalid="ignore"):
            one = f[0] ** 3 / ((f[0] - f[1]) * (f[0] - f[2])) / 3
            two = f.sum(axis=0) / 3 - f[2] ** 3 / ((f[2] - f[0]) * (f[2] - f[1])) / 3
        mean = np.where(~below, 0, np.where(~above, f.sum(axis=0) / 3, np.where(f[1] >= 0, one, two)))
        return float(projected @ mean)

    def _dorsal(self, points: np.ndarray, drawn: tuple[np.ndarray, np.ndarray], second: np.ndarray, forward: np.ndarray,
                size: float) -> np.ndarray:
        """The direction across the nose's in which a body has its back: in its plane of symmetry, across its span, to where it
        reaches farther (a fin). Points are from its centroid on."""
        def across(direction: np.ndarray) -> np.ndarray:
            direction = direction - forward * (direction @ forward)
            return direction / np.linalg.norm(direction)

        axes = [across(axis) for axis in np.eye(3) if abs(axis @ forward) < 0.9]
        first = across(axes[0])
        frame = np.stack((first, np.cross(forward, first)))
        principal = np.linalg.eigh(frame @ second @ frame.T)[1].T @ frame
        candidates = [*axes, *principal]
        symmetric = [side for side in candidates if _asymmetry(*drawn, side) < _ASYMMETRY * size]
        how = "by symmetry"
        if not symmetric:
            side = min(axes, key=lambda axis: abs(axis[2]))
            how = "as the file's axis, the body has no plane of symmetry"
        else:
            spans = [np.ptp(points @ side) for side in symmetric]
            # Of equal spans the one that leaves the file's z dorsal
            side = min((s for s, span in zip(symmetric, spans) if span > 0.999 * max(spans)), key=lambda s: abs(s[2]))
        up = np.cross(forward, side)
        z = points @ up
        if abs(z.max() + z.min()) > 0.01 * np.ptp(z):
            up = up * np.sign(z.max() + z.min())
        else:
            up = up * np.sign(up[np.abs(up).argmax()])
        self.notes.append(f"dorsal: found as {_word(up)} in the file's axes, {how}; the entry 'dorsal' overrules it")
        return up

    def surface(self) -> tuple[np.ndarray, np.ndarray]:
        """Points (n, 3) [m] in the body's frame and triangles (m, 3) that are wound outwards, of the whole body."""
        return self._points, self._triangles

    @property
    def volume(self) -> float:
        return self._volume

    @property
    def slenderness(self) -> float:
        """Of a body of revolution, as full as most, of this volume and length: wings do not count [-]."""
        return _FULLNESS * float(np.sqrt(4 * self.volume / (np.pi * self.length))) / self.length

    @property
    def centre(self) -> np.ndarray:
        """Centre of volume in the body's frame [m]."""
        return self.centroid

    @property
    def bounds(self) -> tuple[np.ndarray, np.ndarray]:
        """Least and largest coordinates in the body's frame [m]."""
        return self._points.min(axis=0), self._points.max(axis=0)

    @property
    def max_diameter(self) -> float:
        """Twice the largest distance from the axis [m]."""
        return 2 * float(np.hypot(*self._points[:, 1:].T).max())

    @cached_property
    def wetted_area(self) -> float:
        """Surface of the whole body [m2]."""
        a, b, c = np.moveaxis(self._points[self._triangles], 1, 0)
        return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)

    @property
    def inertia(self) -> np.ndarray:
        """Inertia tensor about the centroid at unit density, in the axes aft, y, dorsal [m5]."""
        return np.trace(self._second) * np.eye(3) - self._second

    @property
    def isSymmetric(self) -> bool:
        """About y = 0, to 0.2 % of the length: as it was drawn, for the filter that unites parts leaves small folds."""
        return self._asymmetry < _ASYMMETRY * self.length

    @cached_property
    def nose_radius(self) -> float:
        """Radius of the nose [m], an estimate: of the sphere that holds as much within 1 % of the length, extrapolated to the
        tip (0 for a point), at most half the body's diameter (a flat nose)."""
        x, axis = self._points[:, 0], np.array([1.0, 0.0, 0.0])

        def radius(depth: float) -> float:
            volume = self._volume_before(x, self._points, self._triangles, axis, depth)
            return volume / (np.pi * depth**2) + depth / 3

        depth = 0.01 * self.length
        return float(np.clip(2 * radius(depth) - radius(2 * depth), 0, self.max_diameter / 2))

    def added_mass_coefficients(self) -> tuple[np.ndarray, np.ndarray]:
        """Added mass along x, y, z and added inertia about them in unbounded fluid, over the displaced fluid's: those of the
        ellipsoid with this body's radii of gyration, an estimate [-]."""
        return ellipsoid_added_mass(*np.sqrt(5 * np.diag(self._second) / self.volume))


def _asymmetry(points: np.ndarray, triangles: np.ndarray, side: np.ndarray) -> float:
    """Farthest that the surface's mirror image in the plane through the origin with normal `side` lies from it [m]."""
    triangles, used = np.unique(triangles, return_inverse=True)
    points, triangles = points[triangles], used.reshape(-1, 3)
    probes = np.vstack((points, points[triangles].mean(axis=1)))
    probes = probes[:: max(1, len(probes) // _PROBES)]
    return float(np.abs(_distance(points, triangles, probes - 2 * np.outer(probes @ side, side))).max())
