# SPDX-License-Identifier: GPL-3.0-or-later
"""How sure the headline numbers of a dive are, from dives on three meshes, with half the time steps and with other boundary layers.

The uncertainty is that of the default dive, at resolution 1, in the number's own unit; its parts are

- mesh: three meshes, in which all cells and the longest time step change by RATIO; the grid convergence index of Celik et al. (2008,
  plunge.studies.gridConvergence) of the middle one, with the observed order held in ORDERS, between the order of the interface and
  that of the schemes. Where oscillation or a held order part the two pairs of meshes, the larger of what they say;
- time step: twice the change when all limits of the time step are halved, Richardson's error of a scheme of first order;
- boundary layer: half the range over a friction line that is turbulent from the nose, from Re = 5e5 and from 3e6 on, and wall functions,
  which have the thin first layer of cells that suits them.

Their root of the sum of squares is the total. A finer mesh has shorter steps too: the mesh's part holds some of the time step's."""

from __future__ import annotations

import csv
import sys
from datetime import date
from math import hypot, isfinite, nan
from pathlib import Path
from typing import Mapping, NamedTuple

from plunge.studies.gridConvergence import gridConvergence
from plunge.uncertainty import CAUSES, COLUMNS, read_rows

RATIO, ORDERS = 1.5, (1, 2)
DEFAULT, FINE, COARSE, HALF_STEPS = "default", "fine", "coarse", "half steps"
SIZES = {FINE: 1/RATIO, DEFAULT: 1.0, COARSE: RATIO}  # of cells, over those of the default mesh
BOUNDARY_LAYERS = {"transition 0": ("-set", "transitionReynolds=0"), "transition 3e6": ("-set", "transitionReynolds=3e6"),
                   "wallFunction": ("-boundaryLayer", "wallFunction")}


class Parts(NamedTuple):
    """Of a number's uncertainty, in the order of CAUSES."""
    mesh: float
    time: float
    boundaryLayer: float

    @property
    def total(self) -> float:
        return hypot(*self)


def uncertainty(values: Mapping[str, float]) -> Parts:
    """Of a number of the default dive, from that of all of them; a part is nan where a dive has no number."""
    ours = [values[name] for name in SIZES]
    mesh = gridConvergence(list(SIZES.values()), ours, *ORDERS).middleUncertainty if all(map(isfinite, ours)) else nan
    layers = [values[name] for name in (DEFAULT, *BOUNDARY_LAYERS)]
    # min and max do not tell a nan
    spread = 0.5*(max(layers) - min(layers)) if all(map(isfinite, layers)) else nan
    return Parts(mesh, 2*abs(values[DEFAULT] - values[HALF_STEPS]), spread)


def writeTable(path: Path, given: Mapping[str, str], numbers: Mapping[str, tuple[float, str]], parts: Mapping[str, Parts], version: str) -> None:
    """The case's table: rows of these fluids anew, others as they are. What could not be measured has no row."""
    rows = [row for row in read_rows(path) if row["fluids"] != given["fluids"]]
    for name, part in parts.items():
        if not isfinite(part.total):
            print(f"{given['fluids']}: {name}: no uncertainty; expected finite numbers of all dives", file=sys.stderr)
            continue
        value, unit = numbers[name]
        rows.append({**given, "quantity": name, "value": f"{value:.6g}", "unit": unit, "total_uncertainty": f"{part.total:.4g}",
                     **{column: f"{each:.4g}" for column, each in zip(CAUSES.values(), part)},
                     "version": version, "date": date.today().isoformat()})
    with path.open("w", newline="") as file:
        out = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        out.writeheader()
        out.writerows(rows)
