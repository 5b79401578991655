# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves from the nose to the tail: the meridian of a body of revolution, or one side of an outline in the plane."""

from __future__ import annotations

from typing import Sequence

import numpy as np

from plunge.shapes.shape import ShapeError

_SAMPLES = 4001         # of each smooth piece
# A polygon's angles above the second are corners; those above the first are, where they are several times their neighbours'
_CORNERS = np.radians(5), np.radians(20)
_MOST_CORNERS = 40
_STRAIGHT = 4.0


class Curve:
    """Smooth pieces that meet in corners: points (x, r), x aft from the nose, r >= 0 the distance from the axis [m].

    The parameter c in [0, 1] goes with the arc length."""

    def __init__(self, pieces: Sequence[tuple[np.ndarray, np.ndarray]]):
        """Pieces of dense points, each from the last one's end; the first starts on the axis, and the last ends there."""
        lengths = [np.concatenate(([0], np.cumsum(np.hypot(np.diff(x), np.diff(r))))) for x, r in pieces]
        total = sum(s[-1] for s in lengths)
        self.breaks = [0.0]     # c at the ends of the pieces
        self._c: list[np.ndarray] = []
        self._angles: list[np.ndarray] = []
        for (x, r), s in zip(pieces, lengths):
            self._c.append(self.breaks[-1] + s / total)
            self.breaks.append(float(self._c[-1][-1]))
            angle = np.unwrap(np.arctan2(np.gradient(x, s), -np.gradient(r, s)))
            self._angles.append(angle)
        self.breaks[-1] = 1.0
        self._c[-1][-1] = 1.0
        self._total = float(total)
        self.x = np.concatenate([x for x, _ in pieces])
        self.r = np.concatenate([r for _, r in pieces])
        self._all = np.concatenate(self._c)

    def samples(self, piece: int) -> np.ndarray:
        """Dense parameters of a piece, with its ends."""
        return self._c[piece]

    def point(self, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """x and r [m]."""
        return np.interp(c, self._all, self.x), np.interp(c, self._all, self.r)

    def normal_angle(self, c: np.ndarray, piece: int) -> np.ndarray:
        """Angle of the outward normal from the axis' aft direction [rad], at parameters of a piece: pi at a blunt nose."""
        return np.interp(c, self._c[piece], self._angles[piece])

    def arc_length(self, c: np.ndarray) -> np.ndarray:
        """From the nose [m]."""
        return np.asarray(c) * self._total

    @property
    def widest(self) -> float:
        """c of the first of the points furthest from the axis."""
        return float(self._all[np.argmax(self.r > self.r.max() * (1 - 1e-9))])

    @property
    def nose_radius(self) -> float:
        """Radius of curvature at the nose [m]: 0 where it is pointed, that of its face where it is flat."""
        angle = float(self._angles[0][0])
        if abs(angle - np.pi) > np.radians(20):
            return 0.0
        x, r = self.point(self._c[0])
        if np.ptp(x) < 1e-9 * r.max():
            return float(r[-1])
        near = (r > 0) & (r < 0.1 * self.r.max()) & (x > 0)
        if not near.any():
            near = (r > 0) & (x > 0)
        return float(np.min((r[near] ** 2 + x[near] ** 2) / (2 * x[near])))

    def integral(self, of: "callable") -> float:
        """Of a function of x and r over x [by Gauss's three points on the chords, exact to the fifth power]."""
        nodes, weights = np.polynomial.legendre.leggauss(3)
        total = 0.0
        dx, dr = np.diff(self.x), np.diff(self.r)
        for node, weight in zip((nodes + 1) / 2, weights / 2):
            total += weight * float(np.sum(of(self.x[:-1] + node * dx, self.r[:-1] + node * dr) * dx))
        return total


def line(start: tuple[float, float], end: tuple[float, float]) -> tuple[np.ndarray, np.ndarray]:
    """A straight piece."""
    share = np.linspace(0, 1, _SAMPLES)
    return start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])


def arc(x: float, r: float, semi_x: float, semi_r: float, begin: float, end: float) -> tuple[np.ndarray, np.ndarray]:
    """A piece of an ellipse about (x, r), between two angles from the axis' aft direction [rad]."""
    phi = np.linspace(begin, end, _SAMPLES)
    return x + semi_x * np.cos(phi), np.maximum(r + semi_r * np.sin(phi), 0)


def through(x: np.ndarray, r: np.ndarray, source: str) -> Curve:
    """A curve through given points from the nose to the tail, both on the axis. Between corners, where the polygon turns
    by more than its neighbours do, it is a smooth spline by arc length."""
    from scipy.interpolate import CubicSpline

    steps = np.hypot(np.diff(x), np.diff(r))
    if (steps <= 0).any():
        at = int(np.argmin(steps))
        raise ShapeError(f"{source}: points {at + 1} and {at + 2} are the same, ({x[at]:g} {r[at]:g}); expected one of them")
    if (r[1:-1] <= 0).any():
        at = 1 + int(np.argmax(r[1:-1] <= 0))
        raise ShapeError(f"{source}: point {at + 1}, ({x[at]:g} {r[at]:g}), is on the axis or beyond it; expected a radius above 0 "
                         "between the nose and the tail")
    heading = np.unwrap(np.arctan2(np.diff(r), np.diff(x)))
    turn = np.abs(np.diff(heading))
    corners = []
    for i, angle in enumerate(turn):
        around = np.concatenate((turn[max(0, i - 2):i], turn[i + 1:i + 3]))
        around = around[around < _CORNERS[1]]
        if angle > max(3 * around.max(initial=0), _CORNERS[0]) or angle > _CORNERS[1]:
            corners.append(i + 1)
    # A step that is much longer than those beside it is straight: a cylinder behind an ogive
    for i, step in enumerate(steps):
        beside = np.concatenate((steps[max(0, i - 1):i], steps[i + 1:i + 2]))
        if len(beside) and step > _STRAIGHT * beside.min():
            corners += [end for end in (i, i + 1) if 0 < end < len(x) - 1]
    corners = sorted(set(corners))
    if len(corners) > _MOST_CORNERS:
        raise ShapeError(f"{source}: {len(corners)} corners; expected {_MOST_CORNERS} at most: smooth the points, or give a surface")
    pieces = []
    for first, last in zip([0, *corners], [*corners, len(x) - 1]):
        px, pr = x[first:last + 1], r[first:last + 1]
        if len(px) == 2:
            pieces.append(line((px[0], pr[0]), (px[1], pr[1])))
            continue
        s = np.concatenate(([0], np.cumsum(np.hypot(np.diff(px), np.diff(pr)))))
        # Round ends meet the axis at a right angle
        blunt = {"start": first == 0 and heading[0] > np.radians(45), "end": last == len(x) - 1 and heading[-1] < -np.radians(45)}
        start_r = (1, 1.0) if blunt["start"] else (2, 0.0)
        start_x = (1, 0.0) if blunt["start"] else (2, 0.0)
        end_r = (1, -1.0) if blunt["end"] else (2, 0.0)
        end_x = (1, 0.0) if blunt["end"] else (2, 0.0)
        fine = np.linspace(0, s[-1], _SAMPLES)
        sx = CubicSpline(s, px, bc_type=(start_x, end_x))(fine)
        sr = np.maximum(CubicSpline(s, pr, bc_type=(start_r, end_r))(fine), 0)
        pieces.append((sx, sr))
    return Curve(pieces)
