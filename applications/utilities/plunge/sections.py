# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the flow in a plane: of plane and axisymmetric meshes, and of particles."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass
from pathlib import Path
from typing import Iterator, Protocol, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.image import imsave
from matplotlib.tri import Triangulation
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCutter, vtkStripper

from plunge.figures import plt, save
from plunge.results import parameters

PANELS = 6
HEIGHT = 900        # of a picture [pixels]
LEVEL = 0.5         # fraction of liquid at the free surface
AROUND = 0.65       # of the frame beside the body and below it, over the root of its length times its width
OUTLIERS = 0.5      # of the values that lie beyond the colours [%]
GAS, SURFACE, BODY = "0.9", "#12355b", "0.45"
DOT = 1.3           # diameter of a particle, which so leaves no gap [spacings]
SKIN = 5            # width of the line along the body that shows the pressure on it; its outer half is cut off [pt]


@dataclass(frozen=True)
class Section:
    """The flow in a plane at a written time: points on the mesh's triangles, or particles.

    Points are across and up [m], pressures in Pa (None before the solver has any), speeds in m/s. A mirrored section holds the
    half right of the axis; the body is always whole.
    """

    time: float
    points: np.ndarray                      # (n, 2)
    pressure: np.ndarray | None             # (n)
    speed: np.ndarray                       # (n)
    body: list[np.ndarray]                  # closed lines (m, 2)
    onBody: list[np.ndarray] | None = None  # pressure along these lines (m)
    alpha: np.ndarray | None = None         # (n), fraction of liquid; None: particles, of the liquid alone
    triangles: np.ndarray | None = None     # (k, 3)
    spacing: float = 0.0                    # of the particles [m]


class Film(Protocol):
    """The written times of a case, seen in a plane."""

    directory: Path
    times: list[float]
    axes: tuple[str, str]   # names of the directions across and up
    plane: str              # what is seen, for the title; empty where there is nothing to say
    mirrored: bool

    def section(self, instant: int) -> Section: ...


def cut(data: vtkDataSet, normal: int, place: float) -> vtkPolyData:
    """Where the plane at that place on the axis normal to it (0, 1, 2) cuts a mesh, in triangles, or a surface."""
    plane = vtkPlane()
    plane.SetNormal(*np.eye(3)[normal])
    plane.SetOrigin(*(place * np.eye(3)[normal]))
    cutter = vtkCutter()
    cutter.SetInputData(data)
    cutter.SetCutFunction(plane)
    cutter.Update()
    return cutter.GetOutput()


def outlines(body: vtkPolyData, normal: int = 1, place: float = 0.0) -> list[tuple[np.ndarray, np.ndarray | None]]:
    """The lines (n, 2) in which a plane cuts a surface, and the pressure along them where the surface has it."""
    joined = vtkStripper()
    joined.SetInputData(cut(body, normal, place))
    joined.SetMaximumLength(1000000)
    joined.JoinContiguousSegmentsOn()
    joined.Update()
    lines = joined.GetOutput()
    if not lines.GetNumberOfLines():
        return []
    points = np.delete(vtk_to_numpy(lines.GetPoints().GetData()), normal, axis=1)
    pressure = lines.GetPointData().GetArray("p")
    values = None if pressure is None else vtk_to_numpy(pressure)
    cells = lines.GetLines()
    numbers, ends = vtk_to_numpy(cells.GetConnectivityArray()), vtk_to_numpy(cells.GetOffsetsArray())
    strips = [numbers[a:b] for a, b in zip(ends[:-1], ends[1:])]
    return [(points[strip], None if values is None else values[strip]) for strip in strips]


def instants(times: Sequence[float], count: int = PANELS) -> list[int]:
    """So many of the written times, evenly spread."""
    wanted = np.linspace(times[0], times[-1], count)
    return sorted({int(np.argmin(np.abs(np.asarray(times) - t))) for t in wanted})


def frame(bodies: list[np.ndarray]) -> tuple[float, float, float, float]:
    """What is looked at (left, right, bottom, top) [m]: the path of the body, whose points are given at each instant, and what is
    around it; of a body that stays mostly above the surface, its lower part."""
    low, high = (np.array([of(points, axis=0) for points in bodies]) for of in (np.min, np.max))
    length = float(np.ptp(bodies[0][:, 1]))
    around = AROUND * float(np.sqrt((high[0] - low[0]).prod()))
    deep = high[:, 1].max() < -2 * around  # the surface is far
    bottom = (low[:, 1].min() if deep else min(0.0, low[:, 1].min())) - around
    top = high[:, 1].max() + around
    if not deep and high[0, 1] > 0:
        last = high[-1, 1]
        top = min(top, max(0.8 * around, last + 0.3 * around if last < 0.5 * length else 0.25 * length))
    seen = np.concatenate([points[(points[:, 1] < top) & (points[:, 1] > bottom)] for points in bodies])
    left, right = seen[:, 0].min() - around, seen[:, 0].max() + around
    narrow = 0.5 * max(0.0, 0.45 * (top - bottom) - (right - left))  # no panel is a slit
    return left - narrow, right + narrow, bottom, top


def round_up(value: float) -> float:
    """The smallest of 1, 1.5, 2, 3, 5 and 8 times a power of ten that is not below the value."""
    power = 10.0 ** np.floor(np.log10(max(value, 1e-12)))
    return next(power * n for n in (1, 1.5, 2, 3, 5, 8, 10) if power * n >= value * (1 - 1e-9))


@dataclass(frozen=True)
class Look:
    """What all pictures of a case have in common: frame, and colours of pressure and speed."""

    limits: tuple[float, float, float, float]
    pressure: ScalarMappable
    speed: ScalarMappable
    perPressure: float      # Pa
    perSpeed: float         # m/s
    labels: tuple[str, str]

    @classmethod
    def of(cls, film: Film) -> "Look":
        sections = [film.section(i) for i in instants(film.times)]
        limits = frame([np.concatenate(section.body) for section in sections])
        per_pressure, per_speed, *labels = scales(film.directory)
        largest = {"pressure": 0.0, "speed": 0.0}
        for section in sections:
            left, right, bottom, top = limits
            x, z = (np.abs(section.points[:, 0]) if film.mirrored else section.points[:, 0]), section.points[:, 1]
            near = (x >= left) & (x <= right) & (z >= bottom) & (z <= top)
            if section.alpha is not None:
                near &= section.alpha > LEVEL
            for name, values in (("pressure", section.pressure), ("speed", section.speed)):
                if values is not None and near.any():
                    largest[name] = max(largest[name], float(np.percentile(np.abs(values[near]), 100 - OUTLIERS)))
        pressure, speed = (round_up(largest[name] / per or 1.0) for name, per in (("pressure", per_pressure), ("speed", per_speed)))
        return cls(limits, ScalarMappable(Normalize(-pressure, pressure), "RdBu_r"), ScalarMappable(Normalize(0, speed), "GnBu"),
                   per_pressure, per_speed, (labels[0], labels[1]))

    @property
    def aspect(self) -> float:
        left, right, bottom, top = self.limits
        return (top - bottom) / (right - left)


def scales(case: Path) -> tuple[float, float, str, str]:
    """What pressures [Pa] and speeds [m/s] are divided by for the colours, and what that is called."""
    given = parameters(case)
    if "referenceSpeed" not in given or not float(given["referenceSpeed"]) > 0:
        return 1e3, 1.0, "pressure [kPa]", "speed [m/s]"
    speed, density = float(given["referenceSpeed"]), float(given["liquidDensity"])
    return (0.5 * density * speed**2, speed, rf"pressure / ($\frac{{1}}{{2}}\rho U^2$), $U$ = {speed:.4g} m/s",
            f"speed / $U$, $U$ = {speed:.4g} m/s")


def draw(axes: Axes, film: Film, section: Section, look: Look) -> None:
    """The section at a written time: pressure, of mirrored sections left of the axis, with speed right of it."""
    halves = [(-1, True), (1, False)] if film.mirrored else [(1, True)]
    for side, of_pressure in halves:
        # The sector of a body that heads upwards lies left of the axis
        own = np.sign(np.median(section.points[:, 0])) or 1.0
        points = section.points * [own * side if film.mirrored else 1.0, 1]
        values, per, colours = ((section.pressure, look.perPressure, look.pressure) if of_pressure else
                                (section.speed, look.perSpeed, look.speed))
        values = np.zeros(len(points)) if values is None else values / per
        if section.triangles is None:
            size = DOT * section.spacing
            axes.add_collection(EllipseCollection(size, size, 0, units="xy", offsets=points, transOffset=axes.transData, array=values,
                                                  cmap=colours.cmap, norm=colours.norm, linewidths=0))
            continue
        left, right, bottom, top = look.limits
        seen = ((points >= [left, bottom]) & (points <= [right, top])).all(axis=1)[section.triangles].any(axis=1)
        if not seen.any():
            continue
        mesh = Triangulation(*points.T, section.triangles[seen])
        axes.tripcolor(mesh, values, shading="gouraud", cmap=colours.cmap, norm=colours.norm, rasterized=True)
        there = section.alpha[mesh.triangles]
        if there.min() < LEVEL:
            axes.tricontourf(mesh, section.alpha, levels=[-1e3, LEVEL], colors=[GAS])
            if there.max() > LEVEL:
                axes.tricontour(mesh, section.alpha, levels=[LEVEL], colors=[SURFACE], linewidths=1.1)
    for i, line in enumerate(section.body):
        hull, = axes.fill(*line.T, facecolor=BODY, edgecolor="0.2", linewidth=0.6, zorder=3)
        if section.onBody is not None:
            ends = np.stack((line[:-1], line[1:]), axis=1)
            values = (section.onBody[i][:-1] + section.onBody[i][1:]) / 2
            skin = LineCollection(ends, array=values / look.perPressure, cmap=look.pressure.cmap, norm=look.pressure.norm,
                                  linewidths=SKIN, capstyle="round", zorder=4)
            axes.add_collection(skin)
            skin.set_clip_path(hull)
    if film.mirrored:
        axes.axvline(0, color="0.2", linewidth=0.5, linestyle=(0, (6, 3, 1, 3)), zorder=2)
    axes.set(xlim=look.limits[:2], ylim=look.limits[2:])
    axes.set_aspect("equal")
    axes.set_facecolor(GAS)
    axes.grid(False)
    axes.set_title(f"t = {1e3 * section.time:.4g} ms", loc="left")


def colour_bars(figure: Figure, axes: Sequence[Axes], film: Film, look: Look) -> None:
    """The one that belongs to the left half is nearest."""
    if film.mirrored:
        figure.colorbar(look.speed, ax=axes, aspect=40, extend="max", label=f"{look.labels[1]}, right")
    figure.colorbar(look.pressure, ax=axes, aspect=40, extend="both", label=look.labels[0] + (", left" if film.mirrored else ""))


def sheet(title: str, film: Film, look: Look) -> Figure:
    """The case in a few instants."""
    chosen = instants(film.times)
    columns = min(len(chosen), 2 if look.aspect < 0.5 else 3 if look.aspect < 2.2 else 6)
    rows = -(-len(chosen) // columns)
    panel = ((7.4 if film.mirrored else 8.5) / columns - 0.15) * look.aspect
    figure, axes = plt.subplots(rows, columns, figsize=(10.2, 1.0 + rows * (panel + 0.35)), sharex=True, sharey=True, squeeze=False,
                                layout="compressed")
    shown = [film.section(instant) for instant in chosen]
    seen = [film.plane, "" if all(section.onBody is None for section in shown) else "the band inside the body is the pressure on it"]
    figure.suptitle("\n".join([*textwrap.wrap(title, 140), *filter(None, ["; ".join(filter(None, seen))])]), fontsize=9)
    for ax in axes.flat[len(chosen):]:
        ax.set_axis_off()
    for ax, section in zip(axes.flat, shown):
        draw(ax, film, section, look)
    for ax in axes.flat[len(chosen) - columns : len(chosen)]:  # the lowest of each column
        ax.set_xlabel(f"{film.axes[0]} [m]")
        ax.tick_params(labelbottom=True)
    for ax in axes[:, 0]:
        ax.set_ylabel(f"{film.axes[1]} [m]")
    colour_bars(figure, list(axes.flat), film, look)
    return figure


def pictures(film: Film, look: Look, wanted: Sequence[int], height: int) -> Iterator[np.ndarray]:
    """Pictures (rows, columns, rgb) at these of the written times, so many pixels high."""
    inches = 6.0
    figure, ax = plt.subplots(figsize=(min((inches - 1) / look.aspect + (2.6 if film.mirrored else 1.7), 1.8 * inches), inches),
                              dpi=height / inches, layout="compressed")
    colour_bars(figure, [ax], film, look)
    for instant in wanted:
        ax.clear()
        draw(ax, film, film.section(instant), look)
        ax.set(xlabel=f"{film.axes[0]} [m]", ylabel=f"{film.axes[1]} [m]")
        figure.canvas.draw()
        figure.set_layout_engine("none")  # all pictures have the first one's
        yield np.asarray(figure.canvas.buffer_rgba())[..., :3].copy()
    plt.close(figure)


def save_pictures(title: str, film: Film, look: Look, results: Path) -> None:
    """dive.png, and each instant of it by itself in dive/."""
    save(sheet(title, film, look), results / "dive.png")
    (results / "dive").mkdir(exist_ok=True)
    for number, picture in enumerate(pictures(film, look, instants(film.times), HEIGHT)):
        imsave(results / "dive" / f"dive_{number}.png", picture)
