# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes of bodies: what a scene's entry `shape` can be.

A new analytic shape is a function here that returns a Revolution or a Plane, and an entry of TYPES."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, NamedTuple

import numpy as np

from plunge.checks import Check, checked, number, positive, text, triple
from plunge.shapes.curve import Curve, arc, line, through
from plunge.shapes.plane import Plane
from plunge.shapes.revolution import NACA, Revolution
from plunge.shapes.shape import Shape, ShapeError

__all__ = ["Curve", "NACA", "Plane", "Revolution", "Shape", "ShapeError", "TYPES", "read_shape"]


def _with_afterbody(nose: list, height: float, radius: float, length: float, what: str) -> Curve:
    """A nose with a cylinder of the same radius behind it, and a flat base."""
    if length < height * (1 - 1e-9):
        raise ShapeError(f"entry 'length' is {length:g}; expected at least that of the {what}, {height:.6g} m")
    pieces = list(nose)
    if length > height * (1 + 1e-9):
        pieces.append(line((height, radius), (length, radius)))
    return Curve([*pieces, line((max(length, height), radius), (max(length, height), 0.0))])


def _cone(halfAngle: float, radius: float, length: float) -> Curve:
    height = radius / np.tan(np.radians(halfAngle))
    return _with_afterbody([line((0.0, 0.0), (height, radius))], height, radius, length, "cone")


def _ogive(radius: float, noseLength: float, length: float) -> Curve:
    """A tangent ogive: an arc that meets the cylinder without a corner."""
    if noseLength < radius:
        raise ShapeError(f"entry 'noseLength' is {noseLength:g}; expected at least the radius, {radius:g} m")
    curvature = (radius**2 + noseLength**2) / (2 * radius)
    begin = np.pi - np.arcsin((curvature - radius) / curvature)
    x, r = arc(noseLength, radius - curvature, curvature, curvature, begin, np.pi / 2)
    x[0], r[0] = 0.0, 0.0
    return _with_afterbody([(x, r)], noseLength, radius, length, "ogive")


def _hemisphere(radius: float, length: float) -> Curve:
    return _with_afterbody([arc(radius, 0, radius, radius, np.pi, np.pi / 2)], radius, radius, length, "hemisphere")


def _flat(radius: float, length: float) -> Curve:
    return Curve([line((0.0, 0.0), (0.0, radius)), line((0.0, radius), (length, radius)), line((length, radius), (length, 0.0))])


def _ellipse(length: float, width: float) -> Curve:
    return Curve([arc(length / 2, 0, length / 2, width / 2, np.pi, 0.0)])


_MOST_POINTS = 5000


def _points(path: Path, scale: float) -> np.ndarray:
    """Two columns of a .csv file [m]; a line that holds no numbers may be the header."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise ShapeError(f"entry 'file': {path} cannot be read: {getattr(error, 'strerror', None) or 'not a text'}") from None
    rows = [row.split("#")[0].replace(";", ",").replace(",", " ").split() for row in text.splitlines()]
    header = next((number_ for number_, row in enumerate(rows, 1) if row), 0)
    points = []
    for number_, row in enumerate(rows, 1):
        if not row:
            continue
        try:
            values = [float(word) for word in row]
        except ValueError:
            if number_ != header or any(character.isdigit() for word in row for character in word):
                raise ShapeError(f"{path}, line {number_}: '{' '.join(row)}'; expected two numbers") from None
            continue
        if len(values) != 2 or not np.isfinite(values).all():
            raise ShapeError(f"{path}, line {number_}: '{' '.join(row)}'; expected two numbers")
        points.append(values)
    if len(points) < 3:
        raise ShapeError(f"{path}: {len(points)} points; expected three or more")
    if len(points) > _MOST_POINTS:
        raise ShapeError(f"{path}: {len(points)} points; expected {_MOST_POINTS} at most: a spline goes through them")
    return scale * np.array(points)


def _meridian(file: Path, scale: float = 1.0) -> Revolution:
    """Points (x, r) from the nose to the tail."""
    x, r = _points(file, scale).T
    if x[-1] < x[0]:
        x, r = x[::-1], r[::-1]
    extent = max(np.ptp(x), r.max())
    if np.ptp(x) <= 1e-9 * extent or r.max() <= 0:
        raise ShapeError(f"{file}: points on one line; expected a meridian with length and width")
    if (r < -1e-9 * extent).any():
        raise ShapeError(f"{file}: a radius of {r.min():g}; expected none below 0")
    x = x - x[0]
    # Ends that are off the axis are flat faces
    if r[0] > 1e-9 * extent:
        x, r = np.concatenate(([x[0]], x)), np.concatenate(([0.0], r))
    if r[-1] > 1e-9 * extent:
        x, r = np.concatenate((x, [x[-1]])), np.concatenate((r, [0.0]))
    r[0] = r[-1] = 0.0
    _no_crossing(np.column_stack((x, r)), str(file), closed=False)
    if x.min() < -1e-9 * extent:
        raise ShapeError(f"{file}: a point at x = {x.min():g} ahead of the first one; expected the nose to be foremost")
    return Revolution(through(x, r, str(file)))


def _outline(file: Path, scale: float = 1.0) -> Plane:
    """A closed outline (x, z), x aft; the nose is its foremost point, the tail its aftmost, both on the axis or moved there."""
    points = _points(file, scale)
    if np.allclose(points[0], points[-1], atol=1e-9 * np.ptp(points)):
        points = points[:-1]
    if len(points) < 3:
        raise ShapeError(f"{file}: {len(points)} points; expected three or more")
    _no_crossing(points, str(file), closed=True)
    area = 0.5 * np.sum(points[:, 0] * np.roll(points[:, 1], -1) - np.roll(points[:, 0], -1) * points[:, 1])
    if abs(area) < 1e-9 * np.ptp(points) ** 2:
        raise ShapeError(f"{file}: the outline encloses no area; expected a closed one")
    if area > 0:  # above the axis it shall go from the nose to the tail
        points = points[::-1]

    def extreme(sign: int) -> np.ndarray:
        """The foremost or aftmost point; of a flat face its middle, which becomes a point of its own."""
        nonlocal points
        ahead = sign * points[:, 0]
        at = np.flatnonzero(ahead > ahead.max() - 1e-6 * np.ptp(ahead))
        if len(at) == 1:
            return points[at[0]]
        first = next(int(i) for i in at if (i - 1) % len(points) not in at)
        points = np.roll(points, -first, axis=0)    # the face comes first
        middle = (points[0] + points[len(at) - 1]) / 2
        points = np.vstack((points[:1], middle, points[len(at) - 1:]))
        return middle

    front, tail = extreme(-1), extreme(1)
    nose = int(np.flatnonzero((points == front).all(axis=1))[0])
    points = np.roll(points, -nose, axis=0)
    nose_point = points[0].copy()
    aft = int(np.flatnonzero((points == tail).all(axis=1))[0])
    upper, lower = points[:aft + 1] - nose_point, np.vstack((points[aft:], points[:1]))[::-1] - nose_point
    if abs(tail[1] - nose_point[1]) > 1e-6 * np.ptp(points[:, 0]):
        raise ShapeError(f"{file}: the foremost point is at z = {nose_point[1]:g} and the aftmost at z = {tail[1]:g}; "
                         "expected an outline whose axis, from the one to the other, lies along x")
    for side in (upper, lower):
        side[0, 1] = side[-1, 1] = 0.0
    above, below = upper, lower * [1, -1]
    same = above.shape == below.shape and np.allclose(above, below, atol=1e-9 * np.ptp(points))
    return Plane(through(*above.T, str(file)), None if same else through(*below.T, str(file)))


def _no_crossing(points: np.ndarray, source: str, closed: bool) -> None:
    """Refuses a polygon whose edges cross."""
    ends = np.roll(points, -1, axis=0) if closed else points[1:]
    starts = points if closed else points[:-1]
    count = len(starts)

    def side(a: np.ndarray, b: np.ndarray, p: np.ndarray) -> np.ndarray:
        return np.sign((b[..., 0] - a[..., 0]) * (p[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (p[..., 0] - a[..., 0]))

    for i in range(count):
        j = np.arange(i + 2, count - (1 if closed and i == 0 else 0))
        if not len(j):
            continue
        crosses = (side(starts[i], ends[i], starts[j]) * side(starts[i], ends[i], ends[j]) < 0) \
            & (side(starts[j], ends[j], starts[i]) * side(starts[j], ends[j], ends[i]) < 0)
        if crosses.any():
            other = int(j[np.argmax(crosses)])
            raise ShapeError(f"{source}: the line from point {i + 1} crosses the one from point {other + 1}; expected an outline "
                             "that does not cross itself")


def _wedge(halfAngle: float, halfWidth: float, length: "float | None" = None) -> Plane:
    height = halfWidth / np.tan(np.radians(halfAngle))
    return Plane(_cone(halfAngle, halfWidth, height if length is None else length))


def _surface(**entries: Any) -> Shape:
    from plunge.shapes.surface import Surface   # loads vtk

    return Surface(**entries)


class Type(NamedTuple):
    """A type of shape: its builder, and the entries that it takes, as keywords."""

    build: Callable[..., Shape]
    required: dict[str, Check]
    optional: dict[str, Check] = {}


_ANGLE = number("degrees from the axis, from 2 to 88", lambda v: 2 <= v <= 88)
_VECTOR = triple("three numbers, not all of them 0", lambda v: any(v))
TYPES: dict[str, Type] = {
    "NACA": Type(lambda length, thicknessRatio: NACA(length, thicknessRatio),
                 {"length": positive, "thicknessRatio": number("a number from 0.05 to 0.5", lambda v: 0.05 <= v <= 0.5)}),
    "coneCylinder": Type(lambda **e: Revolution(_cone(**e)), {"halfAngle": _ANGLE, "radius": positive, "length": positive}),
    "ogiveCylinder": Type(lambda **e: Revolution(_ogive(**e)), {"radius": positive, "noseLength": positive, "length": positive}),
    "hemisphereCylinder": Type(lambda **e: Revolution(_hemisphere(**e)), {"radius": positive, "length": positive}),
    "flatCylinder": Type(lambda **e: Revolution(_flat(**e)), {"radius": positive, "length": positive}),
    "sphere": Type(lambda radius: Revolution(_ellipse(2 * radius, 2 * radius)), {"radius": positive}),
    "spheroid": Type(lambda length, diameter: Revolution(_ellipse(length, diameter)), {"length": positive, "diameter": positive}),
    "meridian": Type(_meridian, {"file": text}, {"scale": positive}),
    "circle": Type(lambda radius: Plane(_ellipse(2 * radius, 2 * radius)), {"radius": positive}),
    "ellipse": Type(lambda length, width: Plane(_ellipse(length, width)), {"length": positive, "width": positive}),
    "wedge": Type(_wedge, {"halfAngle": _ANGLE, "halfWidth": positive}, {"length": positive}),
    "outline": Type(_outline, {"file": text}, {"scale": positive}),
    "surface": Type(_surface, {"file": text}, {"scale": positive, "nose": _VECTOR, "dorsal": _VECTOR}),
}


def read_shape(entries: Any, folder: Path, source: str) -> Shape:
    """The shape of an entry `shape`; files are seen from the folder. Errors name the source, the entry and what is expected."""
    if not isinstance(entries, dict) or not isinstance(entries.get("type"), str):
        raise ShapeError(f"{source}: entry 'shape' has no type; expected shape {{ type ...; }}, one of: {' '.join(TYPES)}")
    name = entries["type"]
    if name not in TYPES:
        raise ShapeError(f"{source}: entry 'shape.type' is {name}; expected one of: {' '.join(TYPES)}")
    kind = TYPES[name]
    given = checked({k: v for k, v in entries.items() if k != "type"}, f"{source}, shape {name}", kind.required, kind.optional)
    given = {k: folder / v if k == "file" else np.array(v, float) if isinstance(v, list) else float(v) for k, v in given.items()}
    try:
        return kind.build(**given)
    except ShapeError as error:
        raise ShapeError(f"{source}, shape {name}: {error}") from None
