# SPDX-License-Identifier: GPL-3.0-or-later
"""What every body shape gives.

Body frame: x aft from the nose along the axis, y to the side, z dorsal; metres. A shape in the plane lies in x and z and is 1 m deep."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np

Triangles = "tuple[np.ndarray, np.ndarray]"  # points (n, 3) [m] in the body frame, triangles (m, 3) wound outwards


class ShapeError(Exception):
    """A shape that cannot be; the message names the entry and what is expected."""


class Shape(ABC):
    """A closed body. Masses and inertias are at unit density."""

    dimensions = 3
    isRevolution = False
    isSymmetric = True          # in y = 0
    notes: list[str] = []       # what was found about it that the user may want to overrule

    length: float               # along the axis [m]
    max_diameter: float         # largest extent across it [m]

    @property
    def slenderness(self) -> float:
        """Largest extent across the axis over the length [-]."""
        return self.max_diameter / self.length

    @property
    @abstractmethod
    def volume(self) -> float:
        """[m3]"""

    @property
    @abstractmethod
    def wetted_area(self) -> float:
        """[m2]"""

    @property
    @abstractmethod
    def centre(self) -> np.ndarray:
        """Centre of volume in the body frame [m]."""

    @property
    @abstractmethod
    def inertia(self) -> np.ndarray:
        """Inertia tensor about the centre of volume (3, 3) [m5]."""

    @property
    @abstractmethod
    def nose_radius(self) -> float:
        """Radius of curvature at the nose [m]: 0 where it is pointed, that of its flat face where it is flat."""

    @abstractmethod
    def added_mass_coefficients(self) -> "tuple[np.ndarray, np.ndarray]":
        """Estimates, over the displaced fluid's: added mass along the body frame's axes, and added inertia about them [-]."""

    @abstractmethod
    def surface(self) -> Triangles:
        """Triangles of the whole body; in the plane, of a prism from y = -0.5 to 0.5."""
