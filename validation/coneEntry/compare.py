#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The force on cones that fall into water against Boom et al., arXiv:2403.13262: result.csv and docs/figures/coneEntry.png, of
all finished runs. C = 2 F/(rho pi R^2 U0^2), F = m (a + g); time is counted from contact, as U0 t/h. Both as means of 0.25 ms, the
interval in which the accelerometer was read.

Judged: at a half-angle of 45 degrees the peak and its time, within two standard deviations of the trials; at each the history up
to U0 t/h = 2, whose distance, rms, is a share of the largest mean that was measured until then."""
from pathlib import Path
from typing import List, NamedTuple

import numpy as np

from plunge.results import cpu_seconds
from plunge.studies.particleRuns import runs, table
from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row, judge, limit, show, write

FOLDER = Path(__file__).resolve().parent
FIGURE = FOLDER.parents[1] / "docs/figures/coneEntry.png"
RADIUS, RHO, GRAVITY, DROP = 0.026, 997, 9.81, 0.5
SPEED = np.sqrt(2*GRAVITY*DROP)
INTERVAL = 0.25e-3  # [s]
END = 2  # U0 t/h
SLAMS = 45  # [deg]; at 12 the force has no peak


class History(NamedTuple):
    """C against U0 t/h."""
    time: np.ndarray
    C: np.ndarray

    def mean(self, period: float) -> "History":
        """Running mean, over a period of U0 t/h."""
        even = np.arange(0, min(END, self.time[-1]), period/10)
        integral = np.concatenate([[0], np.cumsum(np.diff(self.time)*(self.C[1:] + self.C[:-1])/2)])
        return History(even, (np.interp(even + period/2, self.time, integral) - np.interp(even - period/2, self.time, integral))/period)

    def distance(self, other: "History") -> float:
        return float(np.sqrt(np.mean((self.C - np.interp(self.time, *other))**2)))


class Peak(NamedTuple):
    mass: float
    C: float
    deviation: float
    time: float
    timeDeviation: float


def peakOf(angle: int) -> Peak:
    rows = np.genfromtxt(FOLDER / "reference/peaks.csv", delimiter=",", skip_header=2, names=True)
    row = rows[(rows["half_angle_deg"] == angle) & (rows["drop_height_m"] == DROP)][0]
    return Peak(*(float(row[name]) for name in ("mass_kg", "Cpeak_mean", "Cpeak_std", "Ut_over_h_at_peak_mean",
                                                "Ut_over_h_at_peak_std")))


def measured(angle: int) -> History:
    data = np.genfromtxt(FOLDER / f"reference/history_{angle}.csv", delimiter=",", skip_header=2, names=True)
    return History(data["Ut_over_h"], data["Cf_mean"])


def computed(run: Path, angle: int, mass: float) -> History:
    trajectory = table(run, "trajectory")
    F = mass*(trajectory["az_m_s2"] + GRAVITY)
    return History(trajectory["time_s"]*SPEED/height(angle), 2*F/(RHO*np.pi*RADIUS**2*SPEED**2)).mean(INTERVAL*SPEED/height(angle))


def height(angle: int) -> float:
    return RADIUS/np.tan(np.radians(angle))


def main() -> None:
    rows: List[Row] = []
    angles = sorted((int(folder.name) for folder in (FOLDER / "run").iterdir()), reverse=True)
    picture, axes = pyplot.subplots(1, len(angles), figsize=(6*len(angles), 5), squeeze=False)
    for axis, angle in zip(axes.flat, angles):
        experiment, peak = measured(angle), peakOf(angle)
        axis.plot(*experiment, "k", label="measured")
        largest = float(experiment.C[(experiment.time > 0) & (experiment.time < END)].max())
        for spacing, run in runs(FOLDER / "run" / str(angle)):
            result = computed(run, angle, peak.mass)
            cpu = cpu_seconds(run)
            name = f"half-angle {angle} degrees, spacing {1000*spacing:.4g} mm: "
            axis.plot(*result, label=f"spacing {1000*spacing:.4g} mm")
            if angle == SLAMS:
                i = int(result.C.argmax())
                rows.append(judge(name + "peak of C", float(result.C[i]), "-", peak.C, 2*peak.deviation, cpu))
                rows.append(judge(name + "U0 t/h of the peak", float(result.time[i]), "-", peak.time, 2*peak.timeDeviation, cpu))
            rows.append(limit(name + f"C less measured, rms to U0 t/h = {END}, over the largest measured",
                              100*result.distance(experiment)/largest, "%", 10, cpu))
            impulse = float(np.trapz(result.C, result.time))/float(np.trapz(np.interp(result.time, *experiment), result.time))
            rows.append(Row(name + "integral of C over the measured", impulse, "-", cpu_s=cpu))
        axis.set(title=f"half-angle {angle} degrees", xlabel="U0 t/h", ylabel="C", xlim=(0, END), ylim=(-0.1, 1.3*largest))
        axis.legend(fontsize="small")
    picture.tight_layout()
    picture.savefig(FIGURE, dpi=90)
    write(FOLDER / "result.csv", rows)
    show(rows)


if __name__ == "__main__":
    main()
