# SPDX-License-Identifier: GPL-3.0-or-later
"""The body: a NACA 4-digit half thickness with closed trailing edge, revolved about its chord."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Polynomial

# Half thickness / (5 t c) in powers of x/c; the first term multiplies sqrt(x/c).
# The last coefficient, -0.1036 in place of -0.1015, closes the trailing edge.
_ROOT, _POWERS = 0.2969, (-0.1260, -0.3516, 0.2843, -0.1036)


@dataclass(frozen=True)
class Body:
    """Body of revolution of length `length` [m] and maximum diameter `thickness_ratio`*length."""

    length: float
    thickness_ratio: float

    # The parameter c = sqrt(x/length) runs from 0 (nose) to 1 (tail); in it both
    # coordinates are polynomials, so the round nose needs no special treatment.
    @property
    def _x(self) -> Polynomial:
        return Polynomial([0, 0, self.length])

    @property
    def _r(self) -> Polynomial:
        p1, p2, p3, p4 = _POWERS
        return Polynomial([0, _ROOT, p1, 0, p2, 0, p3, 0, p4]) * (5 * self.thickness_ratio * self.length)

    def point(self, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Distance from the nose along the axis and radius [m]."""
        return self._x(c), np.where(np.isclose(c, 1, atol=1e-14), 0.0, self._r(c))

    def normal_angle(self, c: np.ndarray) -> np.ndarray:
        """Angle of the outward normal from the axis' aft direction [rad]: pi at the nose."""
        return np.arctan2(self._x.deriv()(c), -self._r.deriv()(c))

    def arc_length(self, c: np.ndarray) -> np.ndarray:
        """Arc length along the meridian from the nose [m] for increasing c, c[0] = 0."""
        fine = np.linspace(0, 1, 20001)
        speed = np.hypot(self._x.deriv()(fine), self._r.deriv()(fine))
        s = np.concatenate(([0], np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(fine))))
        return np.interp(c, fine, s)

    @property
    def nose_radius(self) -> float:
        """Radius of the leading edge [m]."""
        return self._r.deriv()(0.0) ** 2 / (2 * self.length)

    def _integral(self, integrand: Polynomial) -> float:
        primitive = (integrand * self._x.deriv()).integ()
        return float(primitive(1.0) - primitive(0.0))

    @property
    def volume(self) -> float:
        """Volume of the whole body [m3]."""
        return np.pi * self._integral(self._r**2)

    @property
    def wetted_area(self) -> float:
        """Surface of the whole body [m2]."""
        x, r = self.point(np.linspace(0, 1, 20001))
        return float(np.pi * np.sum((r[1:] + r[:-1]) * np.hypot(np.diff(x), np.diff(r))))

    @property
    def centroid(self) -> float:
        """Distance of the centre of volume from the nose [m]."""
        return np.pi * self._integral(self._r**2 * self._x) / self.volume

    def added_mass_coefficients(self) -> tuple[float, float, float]:
        """Added mass along the axis, across it and added inertia about a transverse axis, of the prolate spheroid
        of this thickness ratio in unbounded fluid, over the displaced fluid's (Lamb 1932, arts. 114-115) [-]."""
        e = np.sqrt(1 - self.thickness_ratio**2)
        log = np.log((1 + e) / (1 - e))
        alpha = 2 * (1 - e**2) / e**3 * (log / 2 - e)
        beta = 1 / e**2 - (1 - e**2) / (2 * e**3) * log
        rotary = e**4 * (beta - alpha) / ((2 - e**2) * (2 * e**2 - (2 - e**2) * (beta - alpha)))
        return float(alpha / (2 - alpha)), float(beta / (2 - beta)), float(rotary)

    def unit_inertia(self) -> tuple[float, float]:
        """Moments of inertia about the centre of volume at unit density [m5]: about the axis, across it."""
        r2 = self._r**2
        offset = self._x - self.centroid
        return (
            np.pi / 2 * self._integral(r2**2),
            np.pi * self._integral(r2**2 / 4 + r2 * offset**2),
        )
