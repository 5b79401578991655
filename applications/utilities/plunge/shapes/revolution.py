# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies of revolution."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import Polynomial

from plunge.shapes.curve import Curve
from plunge.shapes.ellipsoid import ellipsoid_added_mass
from plunge.shapes.shape import Shape

_RINGS, _AROUND = 160, 96


class Revolution(Shape):
    """A meridian revolved about the axis."""

    isRevolution = True

    def __init__(self, curve: Curve):
        self.curve = curve
        self.length = float(curve.x.max())
        self.max_diameter = 2 * float(curve.r.max())

    def _integral(self, of: "callable") -> float:
        return self.curve.integral(of)

    @property
    def volume(self) -> float:
        return np.pi * self._integral(lambda x, r: r**2)

    @property
    def wetted_area(self) -> float:
        x, r = self.curve.x, self.curve.r
        return float(np.pi * np.sum((r[1:] + r[:-1]) * np.hypot(np.diff(x), np.diff(r))))

    @property
    def centroid(self) -> float:
        """Distance of the centre of volume from the nose [m]."""
        return np.pi * self._integral(lambda x, r: r**2 * x) / self.volume

    @property
    def centre(self) -> np.ndarray:
        return np.array([self.centroid, 0.0, 0.0])

    def unit_inertia(self) -> tuple[float, float]:
        """Moments of inertia about the centre of volume at unit density [m5]: about the axis, across it."""
        centroid = self.centroid
        return (
            np.pi / 2 * self._integral(lambda x, r: r**4),
            np.pi * self._integral(lambda x, r: r**4 / 4 + r**2 * (x - centroid) ** 2),
        )

    @property
    def inertia(self) -> np.ndarray:
        roll, pitch = self.unit_inertia()
        return np.diag([roll, pitch, pitch])

    @property
    def nose_radius(self) -> float:
        return self.curve.nose_radius

    def added_mass_coefficients(self) -> "tuple[np.ndarray, np.ndarray]":
        """Those of the spheroid of this length and volume in unbounded fluid."""
        diameter = float(np.sqrt(6 * self.volume / (np.pi * self.length)))
        return ellipsoid_added_mass(self.length, diameter, diameter)

    def _rings(self) -> np.ndarray:
        """c of the surface's rings, nose and tail among them: corners are kept."""
        breaks = self.curve.breaks
        counts = [max(2, round(_RINGS * (end - begin))) for begin, end in zip(breaks, breaks[1:])]
        parts = [np.linspace(begin, end, count + 1)[:-1] for begin, end, count in zip(breaks, breaks[1:], counts)]
        return np.concatenate((*parts, [1.0]))

    def surface(self) -> "tuple[np.ndarray, np.ndarray]":
        """Rings of a polygon with the circle's area: what is left of the volume's error is that of the meridian's chords."""
        x, r = self.curve.point(self._rings())
        phi = 2 * np.pi * np.arange(_AROUND) / _AROUND
        r = r * np.sqrt(phi[1] / np.sin(phi[1]))
        circles = np.stack(np.broadcast_arrays(x[1:-1, None], r[1:-1, None] * np.sin(phi), r[1:-1, None] * np.cos(phi)), axis=-1)
        points = np.vstack(([[x[0], 0, 0]], circles.reshape(-1, 3), [[x[-1], 0, 0]]))

        rings = len(x) - 1
        number = 1 + np.arange((rings - 1) * _AROUND).reshape(rings - 1, _AROUND)
        ahead = np.roll(number, -1, axis=1)
        a, b, c, d = number[:-1].ravel(), ahead[:-1].ravel(), ahead[1:].ravel(), number[1:].ravel()
        nose, tail = np.zeros(_AROUND, int), np.full(_AROUND, len(points) - 1)
        triangles = np.vstack((
            np.column_stack((nose, number[0], ahead[0])),
            np.column_stack((a, c, b)), np.column_stack((a, d, c)),
            np.column_stack((tail, ahead[-1], number[-1])),
        ))
        return points, triangles


# Half thickness / (5 t c) in powers of x/c; the first term multiplies sqrt(x/c).
# The last coefficient, -0.1036 in place of -0.1015, closes the trailing edge.
_ROOT, _POWERS = 0.2969, (-0.1260, -0.3516, 0.2843, -0.1036)


class _NACACurve:
    """The half thickness of a NACA 4-digit section with closed trailing edge, as a Curve.

    c = sqrt(x/length): in it both coordinates are polynomials, so the round nose needs no special treatment."""

    breaks = [0.0, 1.0]
    widest = float(np.sqrt(0.3))

    def __init__(self, length: float, thickness_ratio: float):
        p1, p2, p3, p4 = _POWERS
        self.X = Polynomial([0, 0, length])
        self.R = Polynomial([0, _ROOT, p1, 0, p2, 0, p3, 0, p4]) * (5 * thickness_ratio * length)
        self.x, self.r = self.point(self.samples(0))

    def samples(self, piece: int) -> np.ndarray:
        return np.linspace(0, 1, 20001)

    def point(self, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return self.X(c), np.where(np.isclose(c, 1, atol=1e-14), 0.0, self.R(c))

    def normal_angle(self, c: np.ndarray, piece: int) -> np.ndarray:
        return np.arctan2(self.X.deriv()(c), -self.R.deriv()(c))

    def arc_length(self, c: np.ndarray) -> np.ndarray:
        fine = np.linspace(0, 1, 20001)
        speed = np.hypot(self.X.deriv()(fine), self.R.deriv()(fine))
        s = np.concatenate(([0], np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(fine))))
        return np.interp(c, fine, s)

    @property
    def nose_radius(self) -> float:
        return self.R.deriv()(0.0) ** 2 / (2 * self.X.coef[-1])

    def integral(self, of: "callable") -> float:
        primitive = (of(self.X, self.R) * self.X.deriv()).integ()
        return float(primitive(1.0) - primitive(0.0))


class NACA(Revolution):
    """A NACA 4-digit half thickness with closed trailing edge, revolved about its chord."""

    def __init__(self, length: float, thickness_ratio: float):
        self.curve = _NACACurve(length, thickness_ratio)
        self.length = length
        self.max_diameter = thickness_ratio * length
        self._thickness_ratio = thickness_ratio

    @property
    def slenderness(self) -> float:
        return self._thickness_ratio

    def added_mass_coefficients(self) -> "tuple[np.ndarray, np.ndarray]":
        """Those of the spheroid of this thickness ratio."""
        return ellipsoid_added_mass(1.0, self._thickness_ratio, self._thickness_ratio)

    def _rings(self) -> np.ndarray:
        """Equally spaced in sqrt(x/length), so that the round nose has the finest."""
        return np.linspace(0, 1, _RINGS + 1)
