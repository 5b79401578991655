#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The force of a bore on a column against Yeh and Petroff: result.csv and docs/figures/yehPetroff.png, of all finished runs.

When the gate opened is not known. So time is shifted for the computed force, mean of 10 ms, to pass 5 N first when the
measured one does; the velocity counts from the arrival of the bore. Reference values are those of two digitisations of
the measurement. Not judged: the noise, which is what a mean of 20 ms takes away while the force is steady; and the
twins on walls that slip (twin.py)."""
from pathlib import Path
from typing import Dict, List, NamedTuple

import numpy as np

from plunge.results import cpu_seconds, even_running_mean
from plunge.studies.foamFields import numbers
from plunge.studies.meshTwins import SOLVER
from plunge.studies.particleRuns import isComplete, runs, table
from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row, judge, show, write

FOLDER = Path(__file__).resolve().parent
FIGURE = FOLDER.parents[1] / "docs/figures/yehPetroff.png"
STEP = 1e-3  # [s]
RISE = 5     # [N]
PLATEAU = (0.55, 0.75)
IMPULSE = (0.33, 1.30)

# What was measured, and the share of it by which the computed may differ
PEAK, STEADY, TOTAL = (33.0, 0.2), (17.8, 0.1), (12.57, 0.1)


class Series(NamedTuple):
    time: np.ndarray
    value: np.ndarray

    def mean(self, period: float) -> np.ndarray:
        """Running mean, centred."""
        return even_running_mean(self.value, period/STEP)

    def during(self, interval) -> np.ndarray:
        return (self.time >= interval[0]) & (self.time <= interval[1])


def evenly(time: np.ndarray, value: np.ndarray) -> Series:
    even = np.arange(time[0], time[-1], STEP)
    return Series(even, np.interp(even, time, value))


def reference(name: str, column: str) -> Series:
    """A digitised record: in order of time, and where it has several points at a time their mean."""
    data = np.genfromtxt(FOLDER / "reference" / f"{name}.csv", delimiter=",", skip_header=2, names=True)
    time, index = np.unique(data["time_s"], return_inverse=True)
    return evenly(time, np.bincount(index, data[column])/np.bincount(index))


def rise(force: Series) -> float:
    """When the force, mean of 10 ms, first passes 5 N [s]."""
    return float(force.time[np.argmax(force.mean(0.01) > RISE)])


def aligned(force: Series, velocity: Series) -> Dict[str, Series]:
    """Force in the time of the measurement, and the velocity from the bore's arrival, when half its highest speed is there."""
    arrival = velocity.time[np.argmax(velocity.value > 0.5*velocity.value.max())]
    return {"force": Series(force.time + rise(reference("force", "Fx_N")) - rise(force), force.value),
            "velocity": Series(velocity.time - arrival, velocity.value)}


def computed(run: Path) -> Dict[str, Series]:
    walls, probes = table(run, "walls"), table(run, "probes")
    return aligned(evenly(walls["time_s"], walls["column_Fx_N"]), evenly(probes["time_s"], probes["upstream_Ux_m_s"]))


def twins() -> Dict[str, Dict[str, Series]]:
    """Those that have been run."""
    result = {}
    slipping, mesh = FOLDER / "run/slipParticles", FOLDER / "run/slip"
    if isComplete(slipping):
        result["spacing 15 mm, walls that slip"] = computed(slipping)
    if isComplete(mesh, SOLVER):
        force, velocity = (numbers(mesh / "postProcessing" / file) for file in ("force/0/force.dat", "upstream/0/U"))
        result["plungeFoam, cells of 20 mm, walls that slip"] = aligned(evenly(force[:, 0], force[:, 1]),
                                                                        evenly(velocity[:, 0], velocity[:, 1]))
    return result


def figures(force: Series) -> Dict[str, float]:
    """Peak, plateau [N], impulse [N s] and noise [N]."""
    plateau, impulse = force.during(PLATEAU), force.during(IMPULSE)
    return {"peak": float(force.mean(0.05).max()),
            "plateau": float(force.value[plateau].mean()),
            "impulse": float(np.trapz(force.value[impulse], force.time[impulse])),
            "noise": float((force.value - force.mean(0.02))[plateau].std())}


def short(measured: Series, velocity: Series) -> float:
    """Computed less measured velocity, mean of 0.05 to 0.5 s after arrival [m/s]."""
    difference = np.interp(measured.time, velocity.time, velocity.mean(0.01)) - measured.value
    return float(difference[measured.during((0.05, 0.5))].mean())


def draw(results: Dict[str, Dict[str, Series]]) -> None:
    picture, axes = pyplot.subplots(2, 1, figsize=(8, 8))
    for axis, name, column, label in ((axes[0], "force", "Fx_N", "force on the column [N]"),
                                      (axes[1], "velocity", "Ux_m_s", "velocity at (0.814, 0.31, 0.026) m [m/s]")):
        data = np.genfromtxt(FOLDER / "reference" / f"{name}.csv", delimiter=",", skip_header=2, names=True)
        axis.plot(data["time_s"], data[column], ".", color="0.5", label="Yeh and Petroff")
        for run, result in results.items():
            series = result[name]
            axis.plot(series.time, series.mean(0.01), label=run + ", mean of 10 ms")
        axis.set(ylabel=label, xlim=(0, 1.5))
        axis.legend()
    axes[0].set(xlabel="time [s], aligned on the rise through 5 N", ylim=(-10, 60))
    axes[1].set(xlabel="time from the arrival of the bore [s]", ylim=(0, 2.6))
    picture.tight_layout()
    picture.savefig(FIGURE, dpi=110)


def main() -> None:
    rows: List[Row] = []
    results, found = {}, {}
    measured = reference("velocity", "Ux_m_s")
    for spacing, run in runs(FOLDER):
        name = f"spacing {1000*spacing:.4g} mm"
        result = results[name] = computed(run)
        of = found[spacing] = figures(result["force"])
        cpu = cpu_seconds(run)
        for what, key, unit, (value, share) in (("peak of the force, mean of 50 ms", "peak", "N", PEAK),
                                                ("force, mean of 0.55 to 0.75 s", "plateau", "N", STEADY),
                                                ("impulse, 0.33 to 1.30 s", "impulse", "N s", TOTAL)):
            rows.append(judge(f"{name}: {what}", of[key], unit, value, share*value, cpu))
        rows.append(Row(name + ": velocity upstream, 0.05 to 0.5 s after arrival: computed less measured, mean",
                        short(measured, result["velocity"]), "m/s", cpu_s=cpu))
        rows.append(Row(name + ": noise of the force, 0.55 to 0.75 s, rms of periods below 20 ms", of["noise"], "N", cpu_s=cpu))
    spacings = list(found)
    for coarse, fine in zip(spacings, spacings[1:]):
        for key in ("peak", "plateau", "impulse"):
            rows.append(Row(f"change of the {key} from spacing {1000*coarse:.4g} to {1000*fine:.4g} mm",
                            100*(found[fine][key]/found[coarse][key] - 1), "%"))
    for name, result in twins().items():
        results[name] = result
        of = figures(result["force"])
        rows += [Row(f"{name}: {what}", of[key], unit) for what, key, unit in (
            ("peak of the force, mean of 50 ms", "peak", "N"), ("force, mean of 0.55 to 0.75 s", "plateau", "N"),
            ("impulse, 0.33 to 1.30 s", "impulse", "N s"))]
        rows.append(Row(name + ": velocity upstream, 0.05 to 0.5 s after arrival: computed less measured, mean",
                        short(measured, result["velocity"]), "m/s"))
    write(FOLDER / "result.csv", rows)
    show(rows)
    draw(results)


if __name__ == "__main__":
    main()
