# SPDX-License-Identifier: GPL-3.0-or-later
"""The liquid's particles and the body of a case of plungeSPH, from the series that it writes for ParaView."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator

from plunge.results import CaseError, entry, parameters
from plunge.sections import Section, outlines
from plunge.surfaces import read_series, read_surface

NEIGHBOURHOOD = 1.5  # of the body's outline, where its pressure is that of particles [spacings]


class Case:
    """The written times of a case; the body is the moving wall of this name."""

    def __init__(self, directory: Path, body: str) -> None:
        self.directory = directory
        self.spacing = float(entry(directory, "constant/particleProperties", "geometry/spacing"))
        self.flat = entry(directory, "constant/particleProperties", "dimensions") == "2"  # in x and y, y up
        folder = directory / "VTK"
        self.particles, self.body = (read_series(folder, name) for name in ("particles", body))
        self.times = [time for time, _ in self.particles]
        if self.times != [t for t, _ in self.body]:
            raise CaseError(f"{folder}: the times of {body}.vtp.series and particles.vtp.series differ; expected the same")
        self.files = [folder / f"{name}.vtp.series" for name in ("particles", body)]
        self.mirrored = parameters(directory).get("model") in ("quarter", "axisymmetric")
        self.axes = ("r" if self.mirrored else "x", "y" if self.flat else "z")
        self.plane = "" if self.flat else "liquid within a spacing of y = 0"

    def extent(self) -> dict[str, np.ndarray]:
        """The table time_s, low_m, high_m of the body's lowest and highest point."""
        up = 2 if self.flat else 4
        heights = [(time, *read_surface(path).GetBounds()[up : up + 2]) for time, path in self.body]
        return dict(zip(("time_s", "low_m", "high_m"), np.array(heights).T))

    def section(self, instant: int) -> Section:
        """The liquid's particles within a spacing of the plane, at a written time."""
        time, path = self.particles[instant]
        data = read_surface(path)
        normal = 2 if self.flat else 1
        points = vtk_to_numpy(data.GetPoints().GetData())
        wall, velocity, pressure = (vtk_to_numpy(data.GetPointData().GetArray(name)) for name in ("wall", "U", "p"))
        near = (wall < 0) & (np.abs(points[:, normal]) <= self.spacing)
        lines = self._outlines(read_surface(self.body[instant][1]))
        points, pressure = np.delete(points[near], normal, axis=1), pressure[near]
        return Section(time, points, pressure, np.linalg.norm(velocity[near], axis=1), lines,
                       [self._beside(line, points, pressure) for line in lines], spacing=self.spacing)

    def _outlines(self, body: vtkPolyData) -> list[np.ndarray]:
        """Closed lines (n, 2) around the body in the plane; in a plane case it is polygons there."""
        if not self.flat:
            return [line for line, _ in outlines(body)]
        points = vtk_to_numpy(body.GetPoints().GetData())[:, :2]
        polygons = [body.GetCell(k).GetPointIds() for k in range(body.GetNumberOfCells())]
        numbers = [[ids.GetId(k) for k in range(ids.GetNumberOfIds())] for ids in polygons]
        return [points[[*polygon, polygon[0]]] for polygon in numbers]

    def _beside(self, line: np.ndarray, points: np.ndarray, pressure: np.ndarray) -> np.ndarray:
        """Mean pressure of the particles that are near each point of a line; 0 where there are none."""
        cloud, there = vtkPolyData(), vtkPoints()
        there.SetData(numpy_to_vtk(np.column_stack((points, np.zeros(len(points)))), deep=True))
        cloud.SetPoints(there)
        locator, found = vtkStaticPointLocator(), vtkIdList()
        locator.SetDataSet(cloud)
        locator.BuildLocator()
        values = np.zeros(len(line))
        for i, place in enumerate(np.column_stack((np.abs(line[:, 0]), line[:, 1])) if self.mirrored else line):
            locator.FindPointsWithinRadius(NEIGHBOURHOOD * self.spacing, (*place, 0.0), found)
            ids = [found.GetId(k) for k in range(found.GetNumberOfIds())]
            values[i] = pressure[ids].mean() if ids else 0.0
        return values
