#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare dives into variants of a liquid with that into the paper's: writes result.csv and prints it.

Nothing is judged. How far the changes for 5 % more and less density are from being opposite says how linear the dive is
in the density, and bounds the noise of the runs.

A fast dive does not resolve the boundary layer, and takes its friction from a line: beside its viscous deceleration at
full immersion stand those of a flat plate of the body's wetted area and length at the speed of entry, laminar (Blasius,
1.328/sqrt(Re)) and turbulent (ITTC 1957, 0.075/(log10 Re - 2)^2).
"""
import argparse
import sys
from math import log10, sqrt
from pathlib import Path
from typing import Dict, List

import numpy as np

from plunge.bodyGeometry import Body
from plunge.foamDictionary import read
from plunge.results import CaseError, cpu_seconds, gather, read_numbers
from plunge.studies.resultTable import Row, show, write
from makeCase import FACTORS, KRAKEN, PAPER

HERE = Path(__file__).resolve().parent
REPORTED = ("impact deceleration", "peak deceleration", "velocity lost at full immersion")


def flat_plates(given: Dict[str, float]) -> Dict[str, float]:
    """Viscous deceleration [m/s2] by either law."""
    body = Body(given["bodyLength"], given["thicknessRatio"])
    reynolds = given["liquidDensity"] * given["speed"] * body.length / given["liquidViscosity"]
    unit = given["liquidDensity"] / 2 * given["speed"] ** 2 * body.wetted_area / given["bodyMass"]
    return {"laminar": 1.328 / sqrt(reynolds) * unit, "turbulent": 0.075 / (log10(reynolds) - 2) ** 2 * unit}


def viscous_deceleration(run: Path, given: Dict[str, float], time: float) -> float:
    """[m/s2] along the path, at a time. The tables hold the forces on the whole body, in the half model too."""
    trajectory = gather(run)["trajectory"]
    along = sum(trajectory[f"Fv{axis}_N"] * trajectory[f"v{axis}_m_s"] for axis in "xyz") / trajectory["speed_m_s"]
    return -float(np.interp(time, trajectory["time_s"], along)) / given["bodyMass"]


def figures(run: Path) -> Dict[str, float]:
    """What is reported of a dive, with units in the names."""
    numbers = read_numbers(run / "results/summary.csv")
    immersion = numbers["full immersion time"][0]
    if not immersion > 0:
        raise CaseError(f"{run}: the body is not fully immersed at the end; expected a longer dive.travel")
    given = read(run / "system/plungeGenerated")
    found = {quantity: numbers[quantity][0] for quantity in REPORTED}
    found["viscous deceleration at full immersion"] = viscous_deceleration(run, given, immersion)
    for name, value in flat_plates(given).items():
        found[f"viscous deceleration of a {name} flat plate"] = value
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", type=Path, help="directory of the dives' run directories")
    runs = parser.parse_args().runs

    rows: List[Row] = []
    try:
        paper = figures(runs / PAPER)
        for name in (*FACTORS, KRAKEN):
            run = runs / name
            given = read(run / "system/plungeGenerated")
            rows.append(Row(f"{name}: liquid density", float(given["liquidDensity"]), "kg/m3"))
            rows.append(Row(f"{name}: liquid viscosity", float(given["liquidViscosity"]), "Pa s"))
            cpu = f"{cpu_seconds(run):.0f}"
            for quantity, value in figures(run).items():
                unit = "m/s" if quantity.startswith("velocity") else "m/s2"
                rows.append(Row(f"{name}: {quantity}", value, unit, cpu_s=cpu))
                if name != PAPER:
                    change = 100 * (value / paper[quantity] - 1)
                    rows.append(Row(f"{name}: change of {quantity}", f"{change:.2f}", "%", cpu_s=cpu))
    except CaseError as error:
        print(f"compare.py: {error}", file=sys.stderr)
        return 1

    write(HERE / "result.csv", rows)
    show(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
