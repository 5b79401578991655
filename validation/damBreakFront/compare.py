#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The front of a collapsing column against Martin and Moyce 1952, in their units: Z = front/a, T = t sqrt(2 g/a).

They saw the front from some width on, and their gate took time to open: so the speed is judged between Z = 1.5 and 3.5, in
which neither shows, and the arrival at Z = 3, in which both do. Reference and tolerance are the mean and the difference of
the two widths of the experiment."""
from pathlib import Path
from typing import List, NamedTuple

import numpy as np

from plunge.results import cpu_seconds
from plunge.studies.particleRuns import particles, runs, series
from plunge.studies.resultTable import Row, judge, show, write

FOLDER = Path(__file__).resolve().parent
WIDTH, GRAVITY = 0.15, 9.81


class Front(NamedTuple):
    T: np.ndarray
    Z: np.ndarray

    def arrival(self, Z: float) -> float:
        return float(np.interp(Z, self.Z, self.T))

    def speed(self) -> float:
        return 2/(self.arrival(3.5) - self.arrival(1.5))


def measured() -> List[Front]:
    """The two widths."""
    table = np.genfromtxt(FOLDER / "reference/martinMoyce1952.csv", delimiter=",", skip_header=3, names=True)
    return [Front(table["T"][rows], table["Z"][rows]) for rows in (table["a_in"] == a for a in np.unique(table["a_in"]))]


def computed(run: Path, spacing: float) -> Front:
    """Until the front meets the wall, at 4 a."""
    T, Z = [], []
    for time, file in series(run):
        fields = particles(file)
        T.append(time*np.sqrt(2*GRAVITY/WIDTH))
        Z.append((fields["x"][fields["wall"] < 0, 0].max() + spacing/2)/WIDTH)
    free = np.array(Z) < 3.95
    return Front(np.array(T)[free], np.array(Z)[free])


def main() -> None:
    rows: List[Row] = []
    experiments = measured()
    for spacing, run in runs(FOLDER):
        front = computed(run, spacing)
        cpu = cpu_seconds(run)
        name = f"spacing {1000*spacing:g} mm: "
        for what, value, references in (
                ("speed of the front over sqrt(2 g a), Z from 1.5 to 3.5", front.speed(), [e.speed() for e in experiments]),
                ("arrival at Z = 3, T", front.arrival(3), [e.arrival(3) for e in experiments])):
            reference = float(np.mean(references))
            rows.append(judge(name + what, value, "-", reference, float(np.ptp(references)), cpu))
    write(FOLDER / "result.csv", rows)
    show(rows)


if __name__ == "__main__":
    main()
