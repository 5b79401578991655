#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A neutrally buoyant cylinder that falls into water against Greenhow and Lin's experiment, and against boundary elements (BEM):
result.csv and docs/figures/fallingCylinder.png, of all finished runs. Penetration is that of the lowest point, over the diameter;
T is time over sqrt(D/g).

Judged: the distance from the BEM, rms over its points, which another SPH's distance from it limits; and the distance from the
experiment's six points, which the BEM's own limits, for these scatter: the second and third are deeper than in free fall."""
from pathlib import Path
from typing import Dict, List, NamedTuple

import numpy as np

from plunge.results import cpu_seconds
from plunge.studies.particleRuns import runs, table
from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row, limit, show, write

FOLDER = Path(__file__).resolve().parent
FIGURE = FOLDER.parents[1] / "docs/figures/fallingCylinder.png"
D, GRAVITY, SPEED = 0.11, 9.81, 2.955


class Path2D(NamedTuple):
    """Penetration over D against T."""
    T: np.ndarray
    depth: np.ndarray

    def distance(self, other: "Path2D") -> float:
        """From the points of another path that this one spans, rms."""
        here = (other.T >= self.T[0]) & (other.T <= self.T[-1])
        return float(np.sqrt(np.mean((np.interp(other.T[here], self.T, self.depth) - other.depth[here])**2)))


def published() -> Dict[str, Path2D]:
    """By kind: experiment, BEM, SPH."""
    data = np.genfromtxt(FOLDER / "reference/penetration.csv", delimiter=",", skip_header=3, names=True, dtype=None, encoding="utf-8")
    return {kind: Path2D(data["T"][data["kind"] == kind], data["penetration"][data["kind"] == kind])
            for kind in np.unique(data["kind"])}


def computed(run: Path) -> Path2D:
    trajectory = table(run, "trajectory")
    return Path2D(trajectory["time_s"]*np.sqrt(GRAVITY/D), (trajectory["y_m"][0] - trajectory["y_m"])/D)


def draw(references: Dict[str, Path2D], results: Dict[float, Path2D]) -> None:
    picture, axis = pyplot.subplots(figsize=(8, 5))
    for (name, path), style in zip(references.items(), ("k-", "0.6", "k--")):
        axis.plot(path.T, path.depth, *(("ko",) if name == "experiment" else (style,)), label={
            "experiment": "Greenhow and Lin 1983", "BEM": "boundary elements", "SPH": "SPH of Sun et al. 2018"}[name])
    for spacing, path in results.items():
        axis.plot(path.T, path.depth, label=f"spacing {1000*spacing:.4g} mm")
    T = np.linspace(0, 0.6)
    axis.plot(T, SPEED/np.sqrt(GRAVITY*D)*T + T**2/2, ":", color="0.5", label="free fall")
    axis.set(xlabel="T = t sqrt(g/D)", ylabel="penetration/D", xlim=(0, 2.1), ylim=(0, 3))
    axis.legend(fontsize="small")
    picture.tight_layout()
    picture.savefig(FIGURE, dpi=90)


def main() -> None:
    rows: List[Row] = []
    results: Dict[float, Path2D] = {}
    references = published()
    BEM, experiment = references["BEM"], references["experiment"]
    for spacing, run in runs(FOLDER):
        result = results[spacing] = computed(run)
        cpu = cpu_seconds(run)
        name = f"spacing {1000*spacing:.4g} mm: "
        rows.append(limit(name + "penetration over D less that of the BEM, rms", result.distance(BEM), "-",
                          references["SPH"].distance(BEM), cpu))
        rows.append(limit(name + "penetration over D less the measured, rms", result.distance(experiment), "-",
                          BEM.distance(experiment), cpu))
        for T in (0.5, 1.0, 1.5):
            rows.append(Row(name + f"penetration over D at T = {T:g}; BEM {np.interp(T, *BEM):.4g}",
                            float(np.interp(T, *result)), "-", cpu_s=cpu))
    write(FOLDER / "result.csv", rows)
    show(rows)
    draw(references, results)


if __name__ == "__main__":
    main()
