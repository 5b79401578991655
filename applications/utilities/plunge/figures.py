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

from plunge.results import G0, Body, Quantities, Table, fluid_force, running_mean
from plunge.uncertainty import Uncertainty, two_digits

plt.rcParams.update({
    "font.size": 9, "axes.titlesize": 9.5, "axes.grid": True, "grid.alpha": 0.35, "grid.linewidth": 0.5,
    "lines.linewidth": 1.1, "legend.fontsize": 8, "legend.frameon": False, "savefig.dpi": 150,
    "axes.spines.top": False, "axes.formatter.useoffset": False,
})

A4 = (8.27, 11.69)  # inches
PANELS = 8  # on a page
STRAIGHT = 0.01  # way to the side, over the way down, of a path that is not worth a panel
NOTES = {"size": 6.5, "columns": 170, "line": 0.111}  # font size, width in characters, height of a line [inches]


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
    """Those that the body has; nan where they do not happen."""
    names = {"contact": "contact time", "immersed": "full immersion time"}
    return {event: numbers[name][0] if name in numbers else float("nan") for event, name in names.items()}


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
    bottom = (NOTES["line"] * len(lines) + 0.14) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, bottom, 1, 1 - bottom))


def path_panel(axes: Axes, table: Table, body: Body, events: dict[str, float]) -> None:
    height = table[f"{body.up}_m"]
    axes.plot(table["x_m"], height, color="C0")
    for name, when in events.items():
        if np.isfinite(when):
            x, z = (np.interp(when, table["time_s"], values) for values in (table["x_m"], height))
            axes.plot(x, z, "o", color="0.35", markersize=3.5)
            axes.annotate(name, (x, z), textcoords="offset points", xytext=(6, 0), fontsize=7, color="0.35", va="center")
    axes.axhline(0, color="C0", linewidth=0.6)
    axes.set_title("Path of the centre of mass", loc="left", pad=12)
    axes.set_xlabel("x [m]")
    axes.set_ylabel(f"{body.up} [m]")
    axes.set_aspect("equal", adjustable="datalim")


def force_panel(axes: Axes, table: Table, body: Body, events: dict[str, float]) -> None:
    """Forces against the motion; of a body at rest, the fluids' along the axes."""
    whole = "per metre" if body.inPlane else "whole body"
    time = table["time_s"]
    if body.freedom == "fixed":
        curves = {c: force for c, force in zip("xyz", fluid_force(table)) if np.any(force)}
        title = f"Force of the fluids, {whole}"
    else:
        curves = {label: along_path(table, part) for label, part in (("pressure", "p"), ("viscous", "v"), ("gravity", "g"))}
        title = f"Force against the motion, {whole}"
    for i, (label, force) in enumerate(curves.items()):
        axes.plot(1e3 * time, force, color=f"C{i}", label=label)
    limits_from_contact(axes, [(time, force, events["contact"]) for force in curves.values()])
    panel(axes, title, f"force [{body.force}]", events)
    axes.legend()


def coefficient_panel(axes: Axes, table: Table, body: Body, events: dict[str, float]) -> None:
    """The fluids' force in the way that impacts are compared."""
    depth, force = table["penetration_m"] / body.width, np.linalg.norm(fluid_force(table), axis=0)
    axes.plot(depth, force / (body.pressure * body.area), color="C0")
    limits_from_contact(axes, [(table["time_s"], force / (body.pressure * body.area), events["contact"])])
    axes.set_title(r"Force of the fluids over $\rho U^2 A/2$ of the start", loc="left", pad=12)
    axes.set_xlabel("penetration depth over the body's width")
    axes.set_ylabel("coefficient")


def ledger_panel(axes: Axes, ledger: Table, events: dict[str, float]) -> None:
    # The axis' own power of ten would lie on the names of the events
    error = ledger["error_percent_of_body_volume"]
    largest = np.max(np.abs(error), initial=0.0)
    power = int(np.floor(np.log10(largest))) if largest > 0 else 0
    axes.plot(1e3 * ledger["time_s"], error / 10.0**power, color="C5")
    panel(axes, "Error of the ledger of liquid volume", f"error [$10^{{{power}}}$ % of body volume]", events)


def trajectory_figure(title: str, table: Table, ledger: Table | None, numbers: Quantities, uncertainties: dict[str, Uncertainty],
                      notes: Sequence[str], body: Body = Body()) -> Figure:
    """One page on one body, with error bars where uncertainties are known, and the notes below; panels that could show no more than
    a constant are left out."""
    wanders = body.turns and np.ptp(table["x_m"]) > STRAIGHT * np.ptp(table[f"{body.up}_m"])
    wanted = [
        *(["path"] if wanders else []),
        *(["depth"] if body.freedom != "fixed" else []),
        *(["speed", "slow"] if not body.driven else []),
        *(["lateral", "pitch"] if body.turns else []),
        "force",
        *(["ledger"] if ledger is not None else []),
    ]
    if body.freedom != "fixed" and body.area and body.pressure and (not wanders or len(wanted) % 2):
        wanted.insert(wanted.index("force") + 1, "coefficient")
    rows = -(-len(wanted) // 2)
    figure, axes = plt.subplots(rows, 2, figsize=(A4[0], A4[1] * (2 * rows + 0.4) / (PANELS + 0.4)), constrained_layout=True,
                                squeeze=False)
    figure.suptitle(textwrap.fill(title, 132), fontsize=9)
    write_notes(figure, notes)
    at = dict(zip(wanted, axes.flat))
    for ax in axes.flat[len(wanted):]:
        ax.set_axis_off()
    time, events = table["time_s"], events_of(numbers)
    ms, contact = 1e3 * time, events["contact"]

    if "path" in at:
        path_panel(at["path"], table, body, events)
    if "depth" in at:
        at["depth"].plot(ms, table["penetration_m"])
        panel(at["depth"], "Penetration depth", "depth [m]", events)
    if "speed" in at:
        at["speed"].plot(ms, table["speed_m_s"])
        panel(at["speed"], "Speed of the centre of mass", "speed [m/s]", events)

        slow = at["slow"]
        slow.plot(ms, table["deceleration_m_s2"], color="C3")
        limits_from_contact(slow, [(time, table["deceleration_m_s2"], contact)])
        panel(slow, "Axial deceleration", "deceleration [m/s$^2$]", events)
        deceleration_axis_in_g(slow)
    if "lateral" in at:
        lateral = at["lateral"]
        lateral.plot(ms, table["a3_m_s2"], color="C4", label="dorsal, $a_3$")
        lateral.plot(ms, table["a2_m_s2"], color="C2", linewidth=0.8, label="sideways, $a_2$")
        limits_from_contact(lateral, [(time, table[a], contact) for a in ("a3_m_s2", "a2_m_s2")])
        panel(lateral, "Lateral acceleration, body axes", "acceleration [m/s$^2$]", events)
        deceleration_axis_in_g(lateral)
        lateral.legend()

        at["pitch"].plot(ms, table["pitch_deg"], color="C4")
        panel(at["pitch"], "Pitch", "pitch [deg]", events)
    force_panel(at["force"], table, body, events)
    if "coefficient" in at:
        coefficient_panel(at["coefficient"], table, body, events)
    if "ledger" in at:
        ledger_panel(at["ledger"], ledger, events)

    def sure(name: str, where: str, when: float, column: str, what: str, beside: tuple[int, int], along: str = "y") -> None:
        if name not in uncertainties or where not in at or not np.isfinite(when):
            return
        value, unit = numbers[name]
        scale, unit = (1, unit.replace("m/s2", "m/s$^2$")) if along == "y" else (1e3, "ms")
        bar = scale * uncertainties[name].total
        total, decimals = two_digits(bar)
        show_uncertainty(at[where], when, float(np.interp(when, time, table[column])),
                         rf"{what}{scale * value:.{decimals}f} $\pm$ {total} {unit}", along, bar, beside)

    def when(name: str) -> float:
        return numbers[name][0] if name in numbers else float("nan")

    immersed = events["immersed"]
    impact, peak = when("time of impact deceleration"), when("time of peak deceleration")
    sure("impact deceleration", "slow", impact, "deceleration_m_s2", "", (1, 0))
    if peak != impact:
        sure("peak deceleration", "slow", peak, "deceleration_m_s2", "", (1, -1))
    sure("velocity lost at full immersion", "speed", immersed, "speed_m_s", "lost: ", (-1, -1))
    sure("pitch change at full immersion", "pitch", immersed, "pitch_deg", "change: ", (-1, 1))
    sure("full immersion time", "depth", immersed, "penetration_m", "", (-1, 1), along="x")
    return figure


def overlay_figure(runs: list[tuple[str, Table, Quantities, Body]], mean: float | None = None) -> Figure:
    """Several runs (label, trajectory, key numbers, body) on the same axes, in the panels that any of them has something to show in.

    mean: decelerations and forces as their running mean over this time [s], before the computed curves in pale.
    """
    bodies = [body for *_, body in runs]
    turning = any(body.turns for body in bodies)
    wanted = [*([] if all(body.driven for body in bodies) else ["slow", "lost"]), "depth", "pitch" if turning else "force"]
    figure, axes = plt.subplots(len(wanted) // 2, 2, figsize=(A4[0] * 1.25, A4[0] * 0.475 * (len(wanted) // 2)), constrained_layout=True,
                                squeeze=False)
    at = dict(zip(wanted, axes.flat))
    spiky: dict[str, list[tuple[np.ndarray, np.ndarray, float]]] = {"slow": [], "force": []}

    def draw_spiky(name: str, table: Table, values: np.ndarray, colour: str, contact: float) -> None:
        if mean is not None:
            at[name].plot(1e3 * table["time_s"], values, color=colour, linewidth=0.5, alpha=0.3)
            values = running_mean(table["time_s"], values, mean)
        at[name].plot(1e3 * table["time_s"], values, color=colour)
        spiky[name].append((table["time_s"], values, contact))

    for i, (label, table, numbers, body) in enumerate(runs):
        ms, colour, contact = 1e3 * table["time_s"], f"C{i}", events_of(numbers)["contact"]
        at["depth"].plot(ms, table["penetration_m"], color=colour, label=label)
        if "slow" in at and not body.driven:
            draw_spiky("slow", table, table["deceleration_m_s2"], colour, contact)
            at["lost"].plot(ms, table["speed_m_s"][0] - table["speed_m_s"], color=colour)
        if "force" in at:
            draw_spiky("force", table, np.linalg.norm(fluid_force(table), axis=0), colour, contact)
        elif body.turns:
            at["pitch"].plot(ms, table["pitch_deg"], color=colour)
        for ax in axes.flat:
            for time in events_of(numbers).values():
                if np.isfinite(time):
                    ax.axvline(1e3 * time, color=colour, linewidth=0.7, linestyle=(0, (4, 3)), alpha=0.7, zorder=0)
    over = "" if mean is None else f", mean over {1e3 * mean:.2g} ms (pale: as computed)"
    if "slow" in at:
        limits_from_contact(at["slow"], spiky["slow"])
        panel(at["slow"], f"Axial deceleration{over}", "deceleration [m/s$^2$]", {})
        deceleration_axis_in_g(at["slow"])
        panel(at["lost"], "Speed lost", "initial speed - speed [m/s]", {})
    panel(at["depth"], "Penetration depth", "depth [m]", {})
    if "pitch" in at:
        panel(at["pitch"], "Pitch", "pitch [deg]", {})
    else:
        limits_from_contact(at["force"], spiky["force"])
        units = " or ".join(dict.fromkeys(body.force for body in bodies))
        panel(at["force"], f"Force of the fluids{over}", f"force [{units}]", {})
    figure.legend(*at["depth"].get_legend_handles_labels(), loc="lower center",
                  bbox_to_anchor=(0.5, 1.0), ncol=1,
                  title="dashed: contact and full immersion", title_fontsize=8)
    return figure


def save(figure: Figure, path: Path) -> None:
    """Write the figure in the format of the path's suffix."""
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, bbox_inches="tight")
