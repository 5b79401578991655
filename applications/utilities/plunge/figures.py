# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of one dive, and of several dives on the same axes.

Curves are drawn as computed; a running mean, where one is asked for, is drawn over the computed curve and named.
"""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import Sequence

import matplotlib

matplotlib.use("Agg")  # no display needed

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plunge.results import G0, Quantities, Table, running_mean
from plunge.uncertainty import Uncertainty, two_digits

plt.rcParams.update({
    "font.size": 9, "axes.titlesize": 9.5, "axes.grid": True, "grid.alpha": 0.35, "grid.linewidth": 0.5,
    "lines.linewidth": 1.1, "legend.fontsize": 8, "legend.frameon": False, "savefig.dpi": 150,
    "axes.spines.top": False, "axes.formatter.useoffset": False,
})

A4 = (8.27, 11.69)  # inches
NOTES = {"size": 6.5, "columns": 170, "line": 0.0095}  # font size, width in characters, height of a line over the page's


def limits_from_contact(axes: Axes, curves: list[tuple[np.ndarray, np.ndarray, float]]) -> None:
    """Fit the axis to what happens from contact on; the start-up before it is named where it does not fit.

    curves: (time in s, values, time of contact in s).
    """
    wet = np.concatenate([v[(t >= contact) | ~np.isfinite(contact)] for t, v, contact in curves])
    whole = np.concatenate([v for _, v, _ in curves])
    low, high = min(0.0, wet.min(initial=0.0)), max(0.0, wet.max(initial=0.0))
    if low == high:
        return
    margin = 0.05 * (high - low)
    axes.set_ylim(low - margin, high + margin)
    beyond = [f"{v:.3g}" for v in (whole.min(), whole.max()) if not low - margin <= v <= high + margin]
    if beyond:
        axes.text(0.99, 0.98, f"before contact, off the axis: {', '.join(beyond)}", transform=axes.transAxes,
                  ha="right", va="top", fontsize=7, color="0.35")


def mark(axes: Axes, events: dict[str, float]) -> None:
    """Vertical lines at the events (name -> time in s); the time axis is in ms."""
    for name, time in events.items():
        if np.isfinite(time):
            axes.axvline(1e3 * time, color="0.45", linewidth=0.8, linestyle=(0, (4, 3)), zorder=0)
            axes.text(1e3 * time, 1.005, name, transform=axes.get_xaxis_transform(), fontsize=7,
                      color="0.35", ha="center", va="bottom")


def events_of(numbers: Quantities) -> dict[str, float]:
    return {"contact": numbers["contact time"][0], "immersed": numbers["full immersion time"][0]}


def panel(axes: Axes, title: str, ylabel: str, events: dict[str, float]) -> None:
    axes.set_title(title, loc="left", pad=12)
    axes.set_ylabel(ylabel)
    axes.set_xlabel("time [ms]")
    mark(axes, events)


def deceleration_axis_in_g(axes: Axes) -> None:
    axes.secondary_yaxis("right", functions=(lambda a: a / G0, lambda g: g * G0)).set_ylabel("[g]")


def along_path(table: Table, part: str) -> np.ndarray:
    """Component of a force against the velocity of the centre of mass, in N (positive: it slows the body)."""
    velocity = np.array([table[f"v{c}_m_s"] for c in "xyz"])
    force = np.array([table[f"F{part}{c}_N"] for c in "xyz"])
    return -(force * velocity).sum(axis=0) / np.maximum(np.linalg.norm(velocity, axis=0), 1e-12)


def show_uncertainty(axes: Axes, when: float, value: float, label: str, along: str, bar: float, beside: tuple[int, int]) -> None:
    """Error bar on a curve at a time in s, and the number that it belongs to on that side of it: right or left, above or below.

    bar: half its length, along y, or along x in ms.
    """
    axes.errorbar(1e3 * when, value, **{f"{along}err": bar}, color="0.15", linewidth=1, capsize=3, marker="o", markersize=2.5,
                  zorder=5)
    right, up = beside
    axes.annotate(label, (1e3 * when, value), textcoords="offset points", xytext=(8 * right, 5 * up), fontsize=7, color="0.15",
                  ha="left" if right > 0 else "right", va={1: "bottom", 0: "center", -1: "top"}[up])


def write_notes(figure: Figure, notes: Sequence[str]) -> None:
    """Sentences along the bottom; the panels end above them."""
    lines = [line for note in notes for line in textwrap.wrap(note, NOTES["columns"], subsequent_indent="    ")]
    figure.text(0.015, 0.006, "\n".join(lines), fontsize=NOTES["size"], color="0.25", va="bottom", linespacing=1.25,
                parse_math=False)
    bottom = NOTES["line"] * len(lines) + 0.012
    figure.get_layout_engine().set(rect=(0, bottom, 1, 1 - bottom))


def trajectory_figure(title: str, table: Table, ledger: Table | None, numbers: Quantities, uncertainties: dict[str, Uncertainty],
                      notes: Sequence[str]) -> Figure:
    """One A4 page on one dive, with error bars where uncertainties are known, and the notes below."""
    figure, axes = plt.subplots(4, 2, figsize=A4, constrained_layout=True)
    figure.suptitle(title, fontsize=9)
    write_notes(figure, notes)
    (path, depth), (speed, slow), (lateral, pitch), (force, volume) = axes
    time, events = table["time_s"], events_of(numbers)
    ms, contact = 1e3 * time, events["contact"]

    path.plot(table["x_m"], table["z_m"], color="C0")
    for name, when in events.items():
        if np.isfinite(when):
            x, z = (np.interp(when, table["time_s"], table[c]) for c in ("x_m", "z_m"))
            path.plot(x, z, "o", color="0.35", markersize=3.5)
            path.annotate(name, (x, z), textcoords="offset points", xytext=(6, 0), fontsize=7, color="0.35", va="center")
    path.axhline(0, color="C0", linewidth=0.6)
    path.set_title("Path of the centre of mass", loc="left", pad=12)
    path.set_xlabel("x [m]")
    path.set_ylabel("z [m]")
    path.set_aspect("equal", adjustable="datalim")

    depth.plot(ms, table["penetration_m"])
    panel(depth, "Penetration depth", "depth [m]", events)

    speed.plot(ms, table["speed_m_s"])
    panel(speed, "Speed of the centre of mass", "speed [m/s]", events)

    slow.plot(ms, table["deceleration_m_s2"], color="C3")
    limits_from_contact(slow, [(time, table["deceleration_m_s2"], contact)])
    panel(slow, "Axial deceleration", "deceleration [m/s$^2$]", events)
    deceleration_axis_in_g(slow)

    lateral.plot(ms, table["a3_m_s2"], color="C4", label="dorsal, $a_3$")
    lateral.plot(ms, table["a2_m_s2"], color="C2", linewidth=0.8, label="sideways, $a_2$")
    limits_from_contact(lateral, [(time, table[a], contact) for a in ("a3_m_s2", "a2_m_s2")])
    panel(lateral, "Lateral acceleration, body axes", "acceleration [m/s$^2$]", events)
    deceleration_axis_in_g(lateral)
    lateral.legend()

    pitch.plot(ms, table["pitch_deg"], color="C4")
    panel(pitch, "Pitch", "pitch [deg]", events)

    parts = {"pressure": ("p", "C0"), "viscous": ("v", "C1"), "gravity": ("g", "C2")}
    drags = {label: along_path(table, part) for label, (part, _) in parts.items()}
    for label, (_, colour) in parts.items():
        force.plot(ms, drags[label], color=colour, label=label)
    limits_from_contact(force, [(time, drag, contact) for drag in drags.values()])
    panel(force, "Force against the motion, whole body", "force [N]", events)
    force.legend(loc="center right")

    if ledger is None:
        volume.set_axis_off()
    else:
        # The axis' own power of ten would lie on the names of the events
        error = ledger["error_percent_of_body_volume"]
        largest = np.max(np.abs(error), initial=0.0)
        power = int(np.floor(np.log10(largest))) if largest > 0 else 0
        volume.plot(1e3 * ledger["time_s"], error / 10.0**power, color="C5")
        panel(volume, "Error of the ledger of liquid volume", f"error [$10^{{{power}}}$ % of body volume]", events)

    def sure(name: str, ax: Axes, when: float, column: str, what: str, beside: tuple[int, int], along: str = "y") -> None:
        if name not in uncertainties or not np.isfinite(when):
            return
        value, unit = numbers[name]
        scale, unit = (1, unit.replace("m/s2", "m/s$^2$")) if along == "y" else (1e3, "ms")
        bar = scale * uncertainties[name].total
        total, decimals = two_digits(bar)
        show_uncertainty(ax, when, float(np.interp(when, time, table[column])),
                         f"{what}{scale * value:.{decimals}f} $\\pm$ {total} {unit}", along, bar, beside)

    immersed = events["immersed"]
    impact, peak = (numbers[f"time of {name}"][0] for name in ("impact deceleration", "peak deceleration"))
    sure("impact deceleration", slow, impact, "deceleration_m_s2", "", (1, 0))
    if peak != impact:
        sure("peak deceleration", slow, peak, "deceleration_m_s2", "", (1, -1))
    sure("velocity lost at full immersion", speed, immersed, "speed_m_s", "lost: ", (-1, -1))
    sure("pitch change at full immersion", pitch, immersed, "pitch_deg", "change: ", (-1, 1))
    sure("full immersion time", depth, immersed, "penetration_m", "", (-1, 1), along="x")
    return figure


def overlay_figure(dives: list[tuple[str, Table, Quantities]], mean: float | None = None) -> Figure:
    """Several dives (label, trajectory, key numbers) on the same axes.

    mean: decelerations as their running mean over this time [s], before the computed curves in pale.
    """
    figure, axes = plt.subplots(2, 2, figsize=(A4[0] * 1.25, A4[0] * 0.95), constrained_layout=True)
    (slow, lost), (depth, pitch) = axes
    decelerations = []
    for i, (label, table, numbers) in enumerate(dives):
        ms, colour = 1e3 * table["time_s"], f"C{i}"
        deceleration = table["deceleration_m_s2"]
        if mean is not None:
            slow.plot(ms, deceleration, color=colour, linewidth=0.5, alpha=0.3)
            deceleration = running_mean(table["time_s"], deceleration, mean)
        slow.plot(ms, deceleration, color=colour, label=label)
        decelerations.append((table["time_s"], deceleration, numbers["contact time"][0]))
        lost.plot(ms, table["speed_m_s"][0] - table["speed_m_s"], color=colour)
        depth.plot(ms, table["penetration_m"], color=colour)
        pitch.plot(ms, table["pitch_deg"], color=colour)
        for ax in axes.flat:
            for time in events_of(numbers).values():
                if np.isfinite(time):
                    ax.axvline(1e3 * time, color=colour, linewidth=0.7, linestyle=(0, (4, 3)), alpha=0.7, zorder=0)
    limits_from_contact(slow, decelerations)
    over = "" if mean is None else f", mean over {1e3 * mean:.2g} ms (pale: as computed)"
    panel(slow, f"Axial deceleration{over}", "deceleration [m/s$^2$]", {})
    deceleration_axis_in_g(slow)
    panel(lost, "Speed lost", "initial speed - speed [m/s]", {})
    panel(depth, "Penetration depth", "depth [m]", {})
    panel(pitch, "Pitch", "pitch [deg]", {})
    figure.legend(*slow.get_legend_handles_labels(), loc="lower center",
                  bbox_to_anchor=(0.5, 1.0), ncol=1,
                  title="dashed: contact and full immersion", title_fontsize=8)
    return figure


def save(figure: Figure, path: Path) -> None:
    """Write the figure in the format of the path's suffix."""
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, bbox_inches="tight")
