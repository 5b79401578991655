#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare dives on an overset mesh with those on one mesh that moves with the body: result.csv, docs/figures/singleMeshTwin.png.

Nothing is interpolated on the single mesh, and nothing but the cells far from the body differs: the first layers about the
body are as thick, around it the cells are the same. Where the two part by more than the overset mesh should cost, the figure
tells of its fringe or of the coarser background. Loads are compared as their running means over WINDOW; along the
body's axis and across it, in its plane of symmetry, for the whole body. What is left of a load after its mean is its noise.

The largest difference of the axial load is that of its rise, in the first half millisecond: the gas between nose and surface, and with it
the contact, depend on the cells around it, those of the background too.

The first steps: the potential flow that is set up at the start leaves the body no impulse but that of its weight and of
the gas, which both meshes give alike.
"""
import argparse
import sys
from pathlib import Path
from typing import Dict, List

from plunge.results import CaseError, cell_count, cpu_seconds
from plunge.studies.dives import WINDOW, Difference, Dive
from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row, limit, show, write

HERE = Path(__file__).resolve().parent
FIGURE = HERE.parents[1] / "docs/figures/singleMeshTwin.png"


def compare(overset: Dive, single: Dive) -> List[Row]:
    apart = Difference(overset, single)
    at = f"resolution {overset.resolution:g}: "
    mean = f", means over {1e3*WINDOW:g} ms"
    rows = [
        Row(at + f"axial load, largest, single mesh{mean}", apart.peak, "N"),
        limit(at + "speed, largest difference to the single mesh over the impact speed", float(apart.speed.max()), "%", 0.5),
        limit(at + f"axial acceleration, largest difference over the largest{mean}", float(apart.axial.max()), "%", 2),
        Row(at + f"the same, after {1e3*WINDOW:g} ms", float(apart.axial[apart.time > WINDOW].max()), "%"),
        limit(at + f"lateral load, largest difference over the largest axial load{mean}", float(apart.lateral.max()), "%", 2),
        Row(at + "the same, to 20 ms", float(apart.lateral[apart.time <= 0.02].max()), "%"),
        Row(at + "the same, mean over the dive", float(apart.lateral.mean()), "%"),
        limit(at + "impulse of the first 0.1 ms, difference to the single mesh over mass times impact speed",
              100*abs(overset.impulse() - single.impulse())/(overset.mass*overset.impact), "%", 0.01),
    ]
    for dive in (overset, single):
        which = f"{at}{dive.mesh} mesh, "
        volume = which + "largest error of the liquid's volume over the body's"
        rows += [
            Row(which + "cells", str(cell_count(dive.run)), "1", cpu_s=f"{cpu_seconds(dive.run):.0f}"),
            limit(volume, dive.ledger(), "% of body volume", 0.01) if dive is overset
            else Row(volume, dive.ledger(), "% of body volume"),
        ]
        rows += [Row(which + f"{name} load, rms about its mean over {1e3*WINDOW:g} ms, over the largest axial load",
                     100*dive.noise(name)/apart.peak, "%") for name in ("lateral", "axial")]
    return rows


def draw(dives: List[Dive]) -> None:
    picture, axes = pyplot.subplots(1, 2, figsize=(12, 4.5))
    for number, dive in enumerate(dives):
        for axis, name in zip(axes, ("axial", "lateral")):
            axis.plot(1e3*dive.time[2:], dive.load[name][2:], color=f"C{number}", linewidth=0.5, alpha=0.6)
            axis.plot(1e3*dive.time, dive.mean[name], color=f"C{number}", label=f"{dive.mesh}, resolution {dive.resolution:g}")
    for axis, name in zip(axes, ("axial", "lateral")):
        axis.set(xlabel="time [ms]", ylabel=f"{name} load on the body [N]")
        axis.legend(fontsize="small")
    axes[0].set_title(f"Thin: as computed; thick: means over {1e3*WINDOW:g} ms")
    picture.tight_layout()
    picture.savefig(FIGURE, dpi=90)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", type=Path, nargs="+", help="run directories of cases/gannetPlunge, finished, of both meshes")
    try:
        dives = [Dive(run) for run in parser.parse_args().runs]
        found: Dict[str, Dict[float, Dive]] = {mesh: {dive.resolution: dive for dive in dives if dive.mesh == mesh}
                                               for mesh in ("overset", "single")}
        rows = [row for resolution, dive in found["overset"].items() for row in compare(dive, found["single"][resolution])]
        singles = sorted(found["single"].items())
        for (_, coarse), (fine, other) in zip(singles, singles[1:]):
            finer = [row for row in compare(coarse, other) if "difference" in row.quantity]
            rows += [Row(row.quantity.replace("to the single mesh", f"of the single meshes at {fine:g}")
                         .replace("difference over", f"difference of the single meshes at {fine:g} over"), row.value, row.unit)
                     for row in finer]
    except CaseError as error:
        print(f"compare.py: {error}", file=sys.stderr)
        return 1
    write(HERE / "result.csv", rows)
    show(rows)
    draw(dives)
    return 0


if __name__ == "__main__":
    sys.exit(main())
