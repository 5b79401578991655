# SPDX-License-Identifier: GPL-3.0-or-later
"""States of liquids, as titanProperties and as references have them, and what their evaluation costs."""

from __future__ import annotations

import csv
import subprocess
from functools import lru_cache
from pathlib import Path
from typing import Callable, Sequence

from plunge.studies.pictures import pyplot
from plunge.studies.references import REFERENCES
from plunge.studies.resultTable import read
from plunge.studies.study import Done
from plunge.titanProperties import titanProperties

STATE = ("x_N2", "x_CH4", "x_C2H6", "x_C3H8", "phase", "T_K", "p_Pa")
TIMINGS = "timings"     # the run that has them
State = dict[str, str]


@lru_cache(maxsize=None)
def published(source: str, table: str, p: str = "") -> list[State]:
    """States of a reference that have a pressure, theirs or p [Pa]."""
    rows = read(REFERENCES / source / f"{table}.csv")
    return [row for row in ({"x_C3H8": "0", "phase": "liquid", "p_Pa": p, **row} for row in rows) if row["p_Pa"]]


def evaluate(states: list[State], folder: Path) -> None:
    """Writes what titanProperties says of the states, in their order."""
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "states.csv").open("w", newline="") as file:
        out = csv.DictWriter(file, STATE, extrasaction="ignore", lineterminator="\n")
        out.writeheader()
        out.writerows(states)
    (folder / "evaluated.csv").write_text(subprocess.run(["titanProperties", "-states", folder / "states.csv", "-format", "csv"], check=True,
                                                         stdout=subprocess.PIPE, text=True).stdout)


def evaluated(folder: Path) -> list[State]:
    return read(folder / "evaluated.csv")


def worst(states: list[State], answers: list[State], column: str, chosen: Callable[[State], bool] = lambda row: True) -> float | None:
    """Largest relative difference in a column over the chosen states; a refusal counts as infinite. None where there are no states."""
    found = [abs(float(ours[column])/float(row[column]) - 1) if ours[column] else float("inf")
             for row, ours in zip(states, answers, strict=True) if chosen(row) and row.get(column)]
    return max(found, default=None)


@lru_cache(maxsize=None)
def nitrogen(alkanes: str, T: str, p: str) -> dict[float, float]:
    """Mole fraction of nitrogen that titanProperties dissolves in alkanes at p [Pa], by temperature [K]; T: one or a range."""
    return {float(row["T_K"]): float(row["x_N2"]) for row in titanProperties("-saturate", alkanes, "-T", T, "-p", p)}


def timeEvaluations(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "speed.csv").write_text(subprocess.run(["titanSpeed"], check=True, stdout=subprocess.PIPE, text=True).stdout)


def time_us(done: Done, evaluation: str, over: float = 1) -> float | None:
    """Of the slowest evaluation whose name begins so, over a time [us]."""
    if done.run.variant != TIMINGS:
        return None
    return max(float(row["time_us"]) for row in read(done.path / "speed.csv") if row["evaluation"].startswith(evaluation))/over


def drawSpeed(done: Sequence[Done], file: Path) -> None:
    """Error against time of one evaluation; AGA8's density differs as much from the direct model's as the run AGA8 says."""
    of = {each.run.variant: each for each in done}
    if not {TIMINGS, "AGA8"} <= set(of):
        return
    rows = read(of[TIMINGS].path / "speed.csv")
    figure, axes = pyplot.subplots(figsize=(8, 5), layout="constrained")
    for quantity, marker in (("density", "o"), ("viscosity", "s")):
        chosen = [row for row in rows if row["evaluation"].endswith(f"field of {quantity}")]
        for kind, colour in (("constant", "tab:green"), ("table", "tab:blue"), ("direct", "tab:red")):
            points = [(1000*float(row["time_us"]), max(float(row["relative_error"]), 1e-12))
                      for row in chosen if row["evaluation"].startswith(kind)]
            axes.loglog(*zip(*points), marker, color=colour, label=f"{kind}, {quantity}", markersize=7,
                        markerfacecolor="none" if quantity == "viscosity" else colour)
    axes.plot(3400, worst(published("AGA8", "states"), evaluated(of["AGA8"].path), "density_kg_m3"), "k*", markersize=11,
              label="AGA8's GERG-2008, density\nand properties, warm start")
    axes.set_xlabel("time of one property of one cell [ns]")
    axes.set_ylabel("largest relative error against the direct model")
    axes.set_title("Three speeds of one liquid: 0.05 N$_2$, 0.25 CH$_4$, 0.70 C$_2$H$_6$ at 90-98 K and 0.1-2 MPa", fontsize=11)
    axes.grid(alpha=0.3)
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False)
    figure.savefig(file, dpi=150)
