# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies in the plane, 1 m deep."""

from __future__ import annotations

import numpy as np

from plunge.shapes.curve import Curve
from plunge.shapes.shape import Shape

_POINTS = 480


class Plane(Shape):
    """An outline: one curve above the axis and one below it, from the nose to the tail."""

    dimensions = 2

    def __init__(self, upper: Curve, lower: "Curve | None" = None):
        self.upper, self.lower = upper, lower or upper
        self.mirrored = lower is None   # in the axis
        self.length = float(max(upper.x.max(), self.lower.x.max()))
        self.max_diameter = float(upper.r.max() + self.lower.r.max())

    def _both(self, of: "callable") -> float:
        """Integral over x of a function of x and z at the outline, above less below."""
        return self.upper.integral(of) - self.lower.integral(lambda x, r: of(x, -r))

    @property
    def volume(self) -> float:
        return self._both(lambda x, z: z)

    @property
    def wetted_area(self) -> float:
        return float(self.upper.arc_length(1.0) + self.lower.arc_length(1.0))

    @property
    def centre(self) -> np.ndarray:
        area = self.volume
        return np.array([self._both(lambda x, z: x * z) / area, 0.0, self._both(lambda x, z: z**2 / 2) / area])

    @property
    def inertia(self) -> np.ndarray:
        x0, _, z0 = self.centre
        along = self._both(lambda x, z: (x - x0) ** 2 * z)
        across = self._both(lambda x, z: z**3 / 3) - self.volume * z0**2
        depth = self.volume / 12
        return np.diag([across + depth, along + across, along + depth])

    @property
    def nose_radius(self) -> float:
        return min(self.upper.nose_radius, self.lower.nose_radius)

    def added_mass_coefficients(self) -> "tuple[np.ndarray, np.ndarray]":
        """Those of the ellipse of this length and width (Lamb 1932, art. 71)."""
        ratio = self.slenderness
        return np.array([ratio, 0, 1 / ratio]), np.array([0, (1 - ratio**2) ** 2 / (2 * ratio * (1 + ratio**2)), 0])

    def outline(self) -> np.ndarray:
        """Points (n, 2) in x, z: from the nose above the axis to the tail, and back below it."""
        sides = []
        for curve in (self.upper, self.lower):
            total = float(curve.arc_length(1.0))
            c = [np.linspace(begin, end, max(2, round(_POINTS / 2 * (float(curve.arc_length(end)) - float(curve.arc_length(begin))) / total)) + 1)[:-1]
                 for begin, end in zip(curve.breaks, curve.breaks[1:])]
            sides.append(np.column_stack(curve.point(np.concatenate((*c, [1.0])))))
        above, below = sides[0][:-1], (sides[1] * [1, -1])[::-1][:-1]
        return np.vstack((above, below))

    def surface(self) -> "tuple[np.ndarray, np.ndarray]":
        outline = self.outline()
        n = len(outline)
        near = np.column_stack((outline[:, 0], np.full(n, -0.5), outline[:, 1]))
        far = near + [0, 1, 0]
        i = np.arange(n)
        j = np.roll(i, -1)
        # Seen with y towards the eye the outline goes round clockwise in x, z
        sides = np.vstack((np.column_stack((i, j, j + n)), np.column_stack((i, j + n, i + n))))
        cap = _triangulated(outline)
        triangles = np.vstack((sides, cap[:, ::-1], cap + n))
        return np.vstack((near, far)), _outwards(np.vstack((near, far)), triangles)


def _triangulated(outline: np.ndarray) -> np.ndarray:
    """Triangles of a polygon, by cutting off ears."""
    from vtkmodules.vtkCommonCore import vtkIdList
    from vtkmodules.vtkCommonDataModel import vtkPolygon

    polygon = vtkPolygon()
    polygon.GetPoints().SetNumberOfPoints(len(outline))
    polygon.GetPointIds().SetNumberOfIds(len(outline))
    for number, (x, z) in enumerate(outline):
        polygon.GetPoints().SetPoint(number, x, z, 0)
        polygon.GetPointIds().SetId(number, number)
    found = vtkIdList()
    polygon.Triangulate(found)
    return np.array([found.GetId(i) for i in range(found.GetNumberOfIds())]).reshape(-1, 3)


def _outwards(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """The triangles of a closed surface, which are wound alike, with their normals outwards."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return triangles if np.einsum("ij,ij->", a, np.cross(b, c)) > 0 else triangles[:, ::-1]
