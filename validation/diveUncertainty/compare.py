#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How sure the headline numbers of cases/gannetPlunge are, tier fast: result.csv, cases/gannetPlunge/constant/uncertainty.csv.

The uncertainty is that of the default dive, at resolution 1, in the number's own unit; its parts are

- mesh: three meshes, in which all cells and the longest time step change by 1.5; the grid convergence index of Celik et al. (2008,
  plunge.studies.gridConvergence) of the middle one, with the observed order held in [1, 2], between the order of the interface and
  that of the schemes. Where oscillation or a held order part the two pairs of meshes, the larger of what they say;
- time step: twice the change when all limits of the time step are halved, Richardson's error of a scheme of first order;
- boundary layer: half the range over a friction line that is turbulent from the nose, from Re = 5e5 and from 3e6 on, and wall functions,
  which have the thin first layer of cells that suits them.

Their root of the sum of squares is the total. A finer mesh has shorter steps too: the mesh's part holds some of the time step's.

A doubling of the resolution may change the velocity lost at full immersion by less than 10 %; the change is estimated from the two
finer meshes for first order.
"""
import argparse
import csv
import sys
from concurrent.futures import ThreadPoolExecutor
from datetime import date
from math import hypot, isfinite, nan
from pathlib import Path
from typing import Dict, List, NamedTuple, Sequence, Tuple

from plunge.foamDictionary import read
from plunge.results import CaseError, Quantities, cell_count, cpu_seconds, read_numbers
from plunge.studies.dives import CASE, finish, setUp, start
from plunge.studies.gridConvergence import gridConvergence
from plunge.studies.particleRuns import CONTROL, override
from plunge.studies.resultTable import Row, judge, show, software_version, write
from plunge.uncertainty import CAUSES, COLUMNS, HEADLINES, TABLE, conditions, read_rows

HERE = Path(__file__).resolve().parent
RUNS = HERE / "run"
AT_ONCE = 2
RATIO = 1.5     # of cell sizes from mesh to mesh
DEFAULT, HALF_STEPS = "default", "half-steps"
# The longest first
OPTIONS: Dict[str, Sequence[str]] = {
    "fine": ("-resolution", f"{RATIO:g}"),
    HALF_STEPS: (),
    "wallFunction": ("-boundaryLayer", "wallFunction"),
    "transition-0": ("-set", "transitionReynolds=0"),
    "transition-3e6": ("-set", "transitionReynolds=3e6"),
    DEFAULT: (),
    "coarse": ("-resolution", f"{1/RATIO:.6f}"),
}
SIZES = {"fine": 1/RATIO, DEFAULT: 1.0, "coarse": RATIO}  # of cells, over those of the default mesh
BOUNDARY_LAYERS = ("transition-0", DEFAULT, "transition-3e6", "wallFunction")
STEP_LIMITS = {"maxCo": "courantLimit", "maxAlphaCo": "interfaceCourantLimit", "maxDeltaT": "deltaTLimit"}
ORDERS = (1, 2)
JUDGED = "velocity lost at full immersion"
ALLOWED_CHANGE = 10.0  # % per doubling


class Parts(NamedTuple):
    """Of a number's uncertainty, in the order of CAUSES."""
    mesh: float
    time: float
    boundaryLayer: float

    @property
    def total(self) -> float:
        return hypot(*self)


def solve(run: Path, fluids: str) -> None:
    options = ("-fluids", fluids, "-tier", "fast", "-np", "1", *OPTIONS[run.name])
    if setUp(run, options) and run.name == HALF_STEPS:
        given = read(run / "system/plungeGenerated")
        override(run, CONTROL, " ".join(f"{entry} {given[name]/2:g};" for entry, name in STEP_LIMITS.items()))
    finish(start(run, options))


def solveAll(runs: Dict[str, Path], fluids: str) -> bool:
    """Runs the dives that are not finished. Have all of them come to their end?"""
    with ThreadPoolExecutor(AT_ONCE) as pool:
        begun = [pool.submit(solve, run, fluids) for run in runs.values()]
    failures = [failure for failure in (dive.exception() for dive in begun) if failure]
    for failure in failures:
        print(f"compare.py: {failure}", file=sys.stderr)
    return not failures


def numbersOf(run: Path) -> Quantities:
    """The headline numbers of a dive; nan where it has none, which is said."""
    try:
        found = read_numbers(run / "results/summary.csv")
    except CaseError as error:
        print(f"compare.py: {error}", file=sys.stderr)
        return {name: (nan, "") for name in HEADLINES}
    for name in HEADLINES:
        if not isfinite(found[name][0]):
            print(f"compare.py: {run}/results/summary.csv, {name}: {found[name][0]}; expected a finite number", file=sys.stderr)
    return {name: found[name] for name in HEADLINES}


def meshUncertainty(what: str, unit: str, values: Dict[str, float]) -> Tuple[float, List[Row]]:
    """Of the default mesh, and how it was found; nan where a dive has no number."""
    ours = [values[name] for name in SIZES]
    if not all(map(isfinite, ours)):
        return nan, []
    found = gridConvergence(list(SIZES.values()), ours, *ORDERS)
    held = "" if found.order == found.observedOrder else f", held in [{ORDERS[0]}, {ORDERS[1]}]"
    return found.middleUncertainty, [
        Row(f"{what}, observed order, {found.convergence}", found.observedOrder, "1"),
        Row(f"{what}, order of the indices{held}", float(found.order), "1"),
        Row(f"{what}, extrapolated", f"{found.extrapolated:.6g}", unit),
        Row(f"{what}, grid convergence index of the fine mesh", 100*found.fineIndex, "%"),
        Row(f"{what}, grid convergence index of the default mesh", 100*found.coarseIndex, "%"),
        Row(f"{what}, ratio of the indices in the asymptotic range", found.asymptoticRatio, "1"),
    ]


def uncertainty(what: str, unit: str, values: Dict[str, float]) -> Tuple[Parts, List[Row]]:
    """Of a number of the default dive."""
    mesh, rows = meshUncertainty(what, unit, values)
    layers = [values[name] for name in BOUNDARY_LAYERS]
    # min and max do not tell a nan
    spread = 0.5*(max(layers) - min(layers)) if all(map(isfinite, layers)) else nan
    parts = Parts(mesh, 2*abs(values[DEFAULT] - values[HALF_STEPS]), spread)
    rows += [Row(f"{what}, uncertainty by the {cause}", part, unit) for cause, part in zip(CAUSES, parts)]
    rows += [Row(f"{what}, uncertainty", parts.total, unit),
             Row(f"{what}, uncertainty over the number", 100*parts.total/abs(values[DEFAULT]), "%")]
    return parts, rows


def writeTable(path: Path, fluids: str, given: Dict[str, str], numbers: Quantities, parts: Dict[str, Parts],
               version: str) -> None:
    """The case's table: rows of these fluids anew, others as they are. What could not be measured has no row."""
    rows = [row for row in read_rows(path) if row["fluids"] != fluids]
    for name, part in parts.items():
        if not isfinite(part.total):
            print(f"compare.py: {fluids}: {name}: no uncertainty; expected finite numbers of all dives", file=sys.stderr)
            continue
        value, unit = numbers[name]
        rows.append({**given, "quantity": name, "value": f"{value:.6g}", "unit": unit, "total_uncertainty": f"{part.total:.4g}",
                     **{column: f"{each:.4g}" for column, each in zip(CAUSES.values(), part)},
                     "version": version, "date": date.today().isoformat()})
    with path.open("w", newline="") as file:
        out = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        out.writeheader()
        out.writerows(rows)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-fluids", default="titan", choices=list(read(CASE / "constant/plungeFluids")),
                        help="of cases/gannetPlunge/constant/plungeFluids (default: titan)")
    fluids = parser.parse_args().fluids
    runs = {name: RUNS / fluids / name for name in OPTIONS}
    complete = solveAll(runs, fluids)

    rows: List[Row] = []
    numbers = {name: numbersOf(run) for name, run in runs.items()}
    for name, run in runs.items():
        try:
            rows.append(Row(f"{fluids}: cells, {name}", str(cell_count(run)), "1", cpu_s=f"{cpu_seconds(run):.0f}"))
        except CaseError as error:
            print(f"compare.py: {error}", file=sys.stderr)

    parts: Dict[str, Parts] = {}
    for quantity in HEADLINES:
        values = {name: found[quantity][0] for name, found in numbers.items()}
        unit = numbers[DEFAULT][quantity][1]
        what = f"{fluids}: {quantity}"
        rows += [Row(f"{what}, {name}", f"{value:.6g}", unit) for name, value in values.items()]
        parts[quantity], more = uncertainty(what, unit, values)
        rows += more
        if quantity == JUDGED and isfinite(values["fine"]) and isfinite(values[DEFAULT]):
            change = 100*(values["fine"]/values[DEFAULT] - 1)*0.5/(1 - 1/RATIO)
            rows.append(judge(f"{fluids}: change of {JUDGED} by doubling, estimated from 1 and {RATIO:g}", change, "%", 0, ALLOWED_CHANGE))

    # Before the tables change what is under version control
    version = software_version(HERE)
    write(HERE / "result.csv", rows, keep=lambda quantity: not quantity.startswith(f"{fluids}: "))
    writeTable(CASE / TABLE, fluids, conditions(runs[DEFAULT]), numbers[DEFAULT], parts, version)
    show(rows)
    return 0 if complete else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except CaseError as error:
        sys.exit(f"compare.py: {error}")
