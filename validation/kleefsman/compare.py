#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A dam break with a box in the way against Kleefsman et al. 2005: result.csv and docs/figures/kleefsman.png, of all finished
runs. Time is that of the gate in both, not shifted.

Judged: the peak at P1, mean of 10 ms, for the record has a value each 5 ms; the arrival, when P1 first passes 1 kPa; and the
heights, whose difference is a share of the depth at the start, rms over the first 2 s."""
from pathlib import Path
from typing import Dict, List

import numpy as np

from plunge.results import cpu_seconds, even_running_mean
from plunge.studies.particleRuns import runs, table
from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row, judge, limit, show, write

FOLDER = Path(__file__).resolve().parent
FIGURE = FOLDER.parents[1] / "docs/figures/kleefsman.png"
STEP, MEAN = 1e-3, 0.01  # of rows, and the time of means [s]
END = 2.0     # [s]
DEPTH = 0.55  # [m]
ARRIVAL = 1e3  # [Pa]
PRESSURES, HEIGHTS = ("P1", "P2", "P4"), ("H2", "H4")

Record = Dict[str, np.ndarray]


def evenly(time: np.ndarray, columns: Record) -> Record:
    even = np.arange(0, min(time[-1], END), STEP)
    return {"time": even, **{name: np.interp(even, time, value) for name, value in columns.items()}}


def measured() -> Record:
    data = np.genfromtxt(FOLDER / "reference/record.csv", delimiter=",", skip_header=1, names=True)
    return evenly(data["time_s"], {**{name: data[f"{name}_Pa"] for name in PRESSURES}, **{name: data[f"{name}_m"] for name in HEIGHTS}})


def computed(run: Path) -> Record:
    probes, gauges = table(run, "probes"), table(run, "gauges")
    return evenly(probes["time_s"], {**{name: probes[f"{name}_p_Pa"] for name in PRESSURES},
                                     **{name: gauges[f"{name}_m"] for name in HEIGHTS}})


def mean(value: np.ndarray) -> np.ndarray:
    """Running mean over MEAN, centred."""
    return even_running_mean(value, MEAN/STEP)


def peak(record: Record, name: str) -> float:
    return float(mean(record[name]).max())


def arrival(record: Record) -> float:
    return float(record["time"][np.argmax(record["P1"] > ARRIVAL)])


def draw(experiment: Record, results: Dict[float, Record]) -> None:
    picture, axes = pyplot.subplots(3, 2, figsize=(12, 11))
    for axis, name in zip(axes.flat, PRESSURES + HEIGHTS):
        axis.plot(experiment["time"], experiment[name], color="0.4", label="measured")
        for spacing, result in results.items():
            axis.plot(result["time"], mean(result[name]), linewidth=0.8, label=f"spacing {1000*spacing:.4g} mm, mean of 10 ms")
        axis.set(title=name, xlabel="time [s]", ylabel="pressure [Pa]" if name in PRESSURES else "height [m]",
                 ylim=(-1000, 14000) if name in PRESSURES else (0, 0.7))
        axis.legend(fontsize="small")
    axes.flat[-1].axis("off")
    picture.tight_layout()
    picture.savefig(FIGURE, dpi=90)


def main() -> None:
    rows: List[Row] = []
    results: Dict[float, Record] = {}
    experiment = measured()
    for spacing, run in runs(FOLDER):
        result = results[spacing] = computed(run)
        cpu = cpu_seconds(run)
        name = f"spacing {1000*spacing:.4g} mm: "
        for sensor in PRESSURES:
            value = peak(experiment, sensor)
            what = name + f"peak at {sensor}, mean of 10 ms"
            rows.append(judge(what, peak(result, sensor), "Pa", value, 0.15*value, cpu) if sensor == "P1" else
                        Row(f"{what}; measured {value:.4g}", peak(result, sensor), "Pa", cpu_s=cpu))
        value = arrival(experiment)
        rows.append(judge(name + "arrival at P1", arrival(result), "s", value, 0.03*value, cpu))
        for gauge in HEIGHTS:
            difference = result[gauge] - experiment[gauge][:len(result[gauge])]
            rows.append(limit(name + f"height {gauge} less measured, rms to {result['time'][-1]:.2g} s, over the first depth",
                              100*float(np.sqrt(np.mean(difference**2)))/DEPTH, "%", 5, cpu))
            rows.append(Row(name + f"height {gauge} less measured, mean, over the first depth", 100*float(difference.mean())/DEPTH, "%",
                            cpu_s=cpu))
    write(FOLDER / "result.csv", rows)
    show(rows)
    draw(experiment, results)


if __name__ == "__main__":
    main()
