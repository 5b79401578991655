# SPDX-License-Identifier: GPL-3.0-or-later
"""The liquid's particles and the body of a case of plungeSPH, from the series that it writes for ParaView."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection
from matplotlib.figure import Figure
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCutter, vtkStripper

from plunge.figures import plt
from plunge.results import CaseError, entry
from plunge.surfaces import read_series, read_surface

PANELS, COLUMNS = 6, 3
FAST = 0.3  # speed at the end of the colour scale, over the body's


def outlines(body: vtkPolyData) -> list[np.ndarray]:
    """Closed lines (n, 2) in x and z where the plane y = 0 cuts a surface."""
    plane = vtkPlane()
    plane.SetNormal(0, 1, 0)
    cut = vtkCutter()
    cut.SetInputData(body)
    cut.SetCutFunction(plane)
    joined = vtkStripper()
    joined.SetInputConnection(cut.GetOutputPort())
    joined.SetMaximumLength(1000000)
    joined.JoinContiguousSegmentsOn()
    joined.Update()
    lines = joined.GetOutput()
    if not lines.GetNumberOfLines():
        return []
    points = vtk_to_numpy(lines.GetPoints().GetData())[:, [0, 2]]
    cells = lines.GetLines()
    numbers, ends = vtk_to_numpy(cells.GetConnectivityArray()), vtk_to_numpy(cells.GetOffsetsArray())
    return [points[numbers[a:b]] for a, b in zip(ends[:-1], ends[1:])]


class Case:
    """The written times of a case; the body is the moving wall of this name."""

    def __init__(self, directory: Path, body: str) -> None:
        self.spacing = float(entry(directory, "constant/particleProperties", "geometry/spacing"))
        folder = directory / "VTK"
        self.particles, self.body = (read_series(folder, name) for name in ("particles", body))
        if [t for t, _ in self.particles] != [t for t, _ in self.body]:
            raise CaseError(f"{folder}: the times of {body}.vtp.series and particles.vtp.series differ; expected the same")
        self.files = [folder / f"{name}.vtp.series" for name in ("particles", body)]

    def extent(self) -> dict[str, np.ndarray]:
        """The table time_s, low_m, high_m of the body's lowest and highest point."""
        heights = [(time, *read_surface(path).GetBounds()[4:6]) for time, path in self.body]
        return dict(zip(("time_s", "low_m", "high_m"), np.array(heights).T))

    def slice(self, path: Path) -> tuple[np.ndarray, np.ndarray]:
        """Positions (n, 2) in x and z and speeds (n) of the liquid's particles within a spacing of y = 0."""
        data = read_surface(path)
        points = vtk_to_numpy(data.GetPoints().GetData())
        wall, velocity = (vtk_to_numpy(data.GetPointData().GetArray(name)) for name in ("wall", "U"))
        near = (wall < 0) & (np.abs(points[:, 1]) <= self.spacing)
        return points[near][:, [0, 2]], np.linalg.norm(velocity[near], axis=1)

    def draw(self, axes: Axes, instant: int, fast: float) -> EllipseCollection:
        """The slice at a written time, coloured by speed up to fast [m/s], and the body."""
        time, path = self.particles[instant]
        points, speed = self.slice(path)
        dots = EllipseCollection(self.spacing, self.spacing, 0, units="xy", offsets=points, transOffset=axes.transData,
                                 array=speed, cmap="viridis", clim=(0, fast), linewidths=0)
        axes.add_collection(dots)
        for line in outlines(read_surface(self.body[instant][1])):
            axes.fill(*line.T, facecolor="#f2a23a", edgecolor="0.2", linewidth=0.6)
        axes.set_title(f"t = {1e3 * time:.1f} ms", loc="left")
        axes.set_aspect("equal")
        axes.grid(False)
        return dots

    def figure(self, until: float, title: str) -> Figure:
        """The dive in the plane of symmetry, to a time [s]; to the last that is written if that is not finite."""
        times = np.array([time for time, _ in self.particles])
        last = until if np.isfinite(until) else times[-1]
        chosen = sorted({int(np.argmin(np.abs(times - t))) for t in np.linspace(times[0], last, PANELS)})
        bounds = {i: np.array(read_surface(self.body[i][1]).GetBounds()) for i in chosen}
        first, final = bounds[chosen[0]], bounds[chosen[-1]]
        speed = np.linalg.norm((final - first)[::2]) / max(times[chosen[-1]] - times[chosen[0]], 1e-300)

        # Of a body that is still in the air, its lower half
        length = float(np.linalg.norm(first[1::2] - first[::2]))
        middle = 0.5 * (min(first[0], final[0]) + max(first[1], final[1]))
        x_limits = (middle - 0.45 * length, middle + 0.45 * length)
        z_limits = (min(final[4], first[4]) - 0.15 * length, 0.5 * length)

        rows = -(-len(chosen) // COLUMNS)
        height = 2.7 * np.diff(z_limits)[0] / np.diff(x_limits)[0] + 0.3
        figure, axes = plt.subplots(rows, COLUMNS, figsize=(9.5, 0.8 + height * rows), sharex=True, sharey=True, squeeze=False,
                                    constrained_layout=True)
        axes[0, 0].set(xlim=x_limits, ylim=z_limits)
        figure.suptitle(f"{title}\nliquid within a spacing of y = 0", fontsize=10)
        for ax in axes.flat[len(chosen):]:
            ax.set_axis_off()
        for ax, instant in zip(axes.flat, chosen):
            dots = self.draw(ax, instant, max(FAST * speed, 1e-300))
        for ax in axes[-1]:
            ax.set_xlabel("x [m]")
        for ax in axes[:, 0]:
            ax.set_ylabel("z [m]")
        figure.colorbar(dots, ax=axes, shrink=0.6, extend="max", label="speed [m/s]")
        return figure
