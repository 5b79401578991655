#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressures at the end of a tank in a dam break against Lobovsky et al. 2014: result.csv and docs/figures/lobovsky.png, of all
finished runs. Units: T = t sqrt(g/H), pressure over rho g H.

At sensor 2 a hundred runs were made: 95 of a hundred are inside the band between the percentiles 2.5 and 97.5 at any time, and so
should the computed pressure be, from the impact on. Their gate takes time to open and their wave is later: time is shifted
for the computed pressure to pass 0.5 first when the measured median does. A sensor is 4.2 mm wide and its signal has a
rate of 20 kHz; the computed pressure is that of particles in the support of the kernel at an instant.

Sound in the computed liquid is slower than in water by a factor of 44, and rings: the longest wave that stands in the depth H has a
period of 4H/c0. So each figure is also given of the pressure's mean over that period. Of the twins (twin.py), which are not judged,
the pressure is as it comes."""
from pathlib import Path
from typing import Dict, List, NamedTuple

import numpy as np

from plunge.results import cpu_seconds, even_running_mean
from plunge.studies.foamFields import numbers
from plunge.studies.meshTwins import SOLVER
from plunge.studies.particleRuns import isComplete, runs, table
from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row, judge, least, show, write

FOLDER = Path(__file__).resolve().parent
FIGURE = FOLDER.parents[1] / "docs/figures/lobovsky.png"
DEPTH, RHO, GRAVITY = 0.3, 1000, 9.81
SENSORS = {"P1": "sensor 1, 3 mm", "P2": "sensor 2, 15 mm", "P3": "sensor 3, 30 mm", "P4": "sensor 4, 80 mm"}
ARRIVAL = 0.5       # pressure at which the wave is there
BEFORE_RETURN = 5.5  # the wave that comes back falls on the sensor later
C0 = 34              # [m/s], of cases/damBreakParticles
RINGING = 4*DEPTH/C0*np.sqrt(GRAVITY/DEPTH)
TWINS = {"slip": "plungeFoam, walls that slip", "boundaryLayer": "plungeFoam, boundary layer resolved"}


class Pressures(NamedTuple):
    T: np.ndarray
    P: Dict[str, np.ndarray]
    delay: float


def reference(sensor: str) -> np.ndarray:
    return np.genfromtxt(FOLDER / "reference" / f"sensor{sensor[1]}.csv", delimiter=",", skip_header=2, names=True)


def arrival(T: np.ndarray, P: np.ndarray) -> float:
    return float(T[np.argmax(P > ARRIVAL)])


def aligned(time: np.ndarray, pressures: Dict[str, np.ndarray]) -> Pressures:
    """Seconds and pascals in the time of the measurement and its units, and by how much that is later."""
    T = time*np.sqrt(GRAVITY/DEPTH)
    P = {sensor: values/(RHO*GRAVITY*DEPTH) for sensor, values in pressures.items()}
    measured = reference("P2")
    delay = arrival(measured["T"], measured["median"]) - arrival(T, P["P2"])
    return Pressures(T + delay, P, delay)


def computed(run: Path) -> Pressures:
    probes = table(run, "probes")
    return aligned(probes["time_s"], {sensor: probes[f"{sensor}_p_Pa"] for sensor in SENSORS})


def twins() -> Dict[str, Pressures]:
    """Those that have been run, with even steps of 1 ms."""
    result = {}
    slipping = FOLDER / "run/slipParticles"
    if isComplete(slipping):
        result["spacing 5 mm, walls that slip"] = computed(slipping)
    for name, label in TWINS.items():
        if isComplete(FOLDER / "run" / name, SOLVER):
            data = numbers(FOLDER / "run" / name / "postProcessing/probes/0/p")
            even = np.arange(data[0, 0], data[-1, 0], 1e-3)
            result[label] = aligned(even, {sensor: np.interp(even, data[:, 0], data[:, i + 1]) for i, sensor in enumerate(SENSORS)})
    return result


def quiet(result: Pressures) -> np.ndarray:
    """Pressure at sensor 2, mean over the time that it rings with."""
    return even_running_mean(result.P["P2"], RINGING/(result.T[1] - result.T[0]))


def noise(T: np.ndarray, P: np.ndarray) -> float:
    """What a parabola does not follow, rms."""
    return float((P - np.polyval(np.polyfit(T, P, 2), T)).std())


def draw(results: Dict[str, Pressures], meshes: Dict[str, Pressures]) -> None:
    picture, axes = pyplot.subplots(2, 2, figsize=(12, 8))
    for axis, (sensor, label) in zip(axes.flat, SENSORS.items()):
        data = reference(sensor)
        if "median" in data.dtype.names:
            axis.fill_between(data["T"], data["low"], data["high"], color="0.8", label="measured, percentiles 2.5 to 97.5")
            axis.plot(data["T"], data["median"], color="0.4", label="measured, median")
        else:
            axis.plot(data["T"], data["P"], ".", color="0.4", label="measured, one run")
        for run, result in results.items():
            axis.plot(result.T, result.P[sensor], linewidth=0.8, label=run)
        for (run, result), style in zip(meshes.items(), ("k:", "k--")):
            axis.plot(result.T, result.P[sensor], style, linewidth=1, label=run)
        axis.set(title=label, xlim=(2, 7.2), ylim=(-0.3, 3.5), xlabel="t sqrt(g/H), aligned on the arrival at sensor 2", ylabel="p/(rho g H)")
        axis.legend(fontsize="small")
    picture.tight_layout()
    picture.savefig(FIGURE, dpi=90)


def main() -> None:
    rows: List[Row] = []
    results: Dict[str, Pressures] = {}
    band = reference("P2")
    T = band["T"]
    start = arrival(T, band["median"])
    peak = [float(band[column].max()) for column in ("low", "median", "high")]
    steady = (T > 3.5) & (T < BEFORE_RETURN)

    def inside(P: np.ndarray, until: float) -> float:
        during = (T > start) & (T < until)
        return 100*float(((P >= band["low"]) & (P <= band["high"]))[during].mean())

    for spacing, run in runs(FOLDER):
        name = f"spacing {1000*spacing:g} mm"
        result = results[name] = computed(run)
        P = np.interp(T, result.T, result.P["P2"])
        mean = np.interp(T, result.T, quiet(result))
        cpu = cpu_seconds(run)
        name += ", sensor 2: "
        for until in (BEFORE_RETURN, 7.0):
            within = f"time inside the band of repeated runs, from the arrival to T = {until:g}"
            rows.append(least(name + within, inside(P, until), "%", 95, cpu))
            rows.append(least(f"{name}{within}, mean over T = {RINGING:.2g}", inside(mean, until), "%", 95, cpu))
        rows.append(judge(name + "peak", float(P.max()), "rho g H", peak[1], 0.5*(peak[2] - peak[0]), cpu))
        rows.append(judge(f"{name}peak, mean over T = {RINGING:.2g}", float(mean.max()), "rho g H", peak[1], 0.5*(peak[2] - peak[0]), cpu))
        rows.append(Row(name + f"mean from T = 3.5 to 5.5; measured, median, {float(band['median'][steady].mean()):.3g}",
                        float(P[steady].mean()), "rho g H", cpu_s=cpu))
        rows.append(Row(name + "noise from T = 3.5 to 5.5: rms off a parabola", noise(T[steady], P[steady]), "rho g H", cpu_s=cpu))
        rows.append(Row(name + "the measured wave is later by, T", result.delay, "-", cpu_s=cpu))
        for sensor in ("P1", "P3", "P4"):
            data = reference(sensor)
            P = np.interp(data["T"], result.T, result.P[sensor])
            during = (data["T"] > 3) & (data["T"] < BEFORE_RETURN)
            rows.append(Row(f"spacing {1000*spacing:g} mm, {SENSORS[sensor]}: mean from T = 3 to 5.5, computed less one measured run",
                            float((P - data["P"])[during].mean()), "rho g H", cpu_s=cpu))
    others = twins()
    for name, result in others.items():
        P = np.interp(T, result.T, result.P["P2"])
        rows.append(Row(name + f", sensor 2: mean from T = 3.5 to 5.5; measured, median, {float(band['median'][steady].mean()):.3g}",
                        float(P[steady].mean()), "rho g H"))
        rows.append(Row(f"{name}, sensor 2: time inside the band of repeated runs, from the arrival to T = {BEFORE_RETURN:g}",
                        inside(P, BEFORE_RETURN), "%"))
        rows.append(Row(name + ", sensor 2: peak", float(P.max()), "rho g H"))
    write(FOLDER / "result.csv", rows)
    show(rows)
    draw(results, {name: result for name, result in others.items() if name in TWINS.values()})


if __name__ == "__main__":
    main()
