#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare dives of plungeSPH with those of plungeFoam into the same fluids: writes result.csv, prints it, draws the curves.

Nothing is judged: neither is the reference of the other. The particles slip over the body, so they are compared with plungeFoam's
dives without a boundary layer. Decelerations are given as computed and as their running mean
over the time in which the body moves by one spacing of the coarsest particles: these resolve nothing that is shorter, but a
weakly compressible liquid rings. The same mean is taken of all runs.
"""
import argparse
import re
import subprocess
import sys
from pathlib import Path
from typing import Dict, List, Tuple

import numpy as np

from plunge.foamDictionary import read
from plunge.results import (TRAJECTORY_COLUMNS, CaseError, cell_count, cpu_seconds, particle_counts,
                           read_numbers, read_table, running_mean, solver_log)
from plunge.studies.resultTable import Row, show, write

HERE = Path(__file__).resolve().parent
FIGURE = HERE.parents[1] / "docs/figures/crossCheck.png"


def figures(run: Path, window: float) -> Dict[str, Tuple[float, str]]:
    """Name -> value and unit of what is compared of a dive."""
    numbers = read_numbers(run / "results/summary.csv")
    contact, immersion = numbers["contact time"][0], numbers["full immersion time"][0]
    if not immersion > 0:
        raise CaseError(f"{run}: the body is not fully immersed at the end; expected a longer dive.travel")
    table = read_table(run / "results/trajectory.csv", TRAJECTORY_COLUMNS)
    time = table["time_s"]
    mean = running_mean(time, table["deceleration_m_s2"], window)
    wet = time >= contact
    peak = int(np.argmax(np.where(wet, mean, -np.inf)))
    noise = (table["deceleration_m_s2"] - mean)[wet & (time <= immersion)]
    over = f", mean over {1e3 * window:.2g} ms"
    return {
        "velocity lost at full immersion": numbers["velocity lost at full immersion"],
        "peak deceleration as computed": numbers["peak deceleration"],
        f"peak deceleration{over}": (float(mean[peak]), "m/s2"),
        f"time from contact to peak{over}": (float(time[peak] - contact), "s"),
        f"deceleration, rms about its mean over {1e3 * window:.2g} ms": (float(np.sqrt(np.mean(noise**2))), "m/s2"),
        "full immersion time": numbers["full immersion time"],
        "pitch change at full immersion": numbers["pitch change at full immersion"],
    }


def memory(run: Path) -> List[Row]:
    """Of a short run with many particles."""
    particles = sum(particle_counts(run))
    peak = 1024 * float((run / "log.memory").read_text().split()[0])
    arrays = float(re.search(r"^Computation: .*, (\S+) MiB", solver_log(run), re.M)[1]) * 2**20
    tier = read(run / "system/plungeGenerated")["tier"]
    return [
        Row(f"tier {tier}: particles of the liquid", str(particle_counts(run)[0]), "1"),
        Row(f"tier {tier}: particles with walls and body", str(particles), "1"),
        Row(f"tier {tier}: bytes per particle of the computation", f"{arrays / particles:.0f}", "1"),
        Row(f"tier {tier}: peak memory of the process", peak / 2**30, "GiB"),
        Row(f"tier {tier}: peak memory of the process per particle", f"{peak / particles:.0f}", "byte"),
    ]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("million", type=Path, help="short run with a million particles, by peakMemory")
    parser.add_argument("runs", type=Path, nargs="+", help="finished run directories of cases/gannetPlunge, of both solvers")
    arguments = parser.parse_args()

    rows: List[Row] = []
    try:
        dives = {run: read(run / "system/plungeGenerated") for run in arguments.runs}
        window = max(given["particleSpacing"] / given["speed"] for given in dives.values() if "particleSpacing" in given)
        on_meshes: Dict[str, Dict[str, Tuple[float, str]]] = {}
        for run, given in sorted(dives.items(), key=lambda item: item[1]["application"]):
            fluids, meshes = given["fluids"], given["application"] == "plungeFoam"
            found = figures(run, window)
            layer = given["boundaryLayer"] if meshes else ""
            name = f"{fluids}, {given['application']} {given['tier']}" + (f", boundary layer {layer}" if meshes else "")
            cpu = f"{cpu_seconds(run):.0f}"
            rows.append(Row(f"{name}: {'cells' if meshes else 'particles of the liquid'}",
                            str(cell_count(run) if meshes else particle_counts(run)[0]), "1", cpu_s=cpu))
            for quantity, (value, unit) in found.items():
                rows.append(Row(f"{name}: {quantity}", value, unit, cpu_s=cpu))
                if not meshes:
                    other = on_meshes[fluids][quantity][0]
                    rows.append(Row(f"{name}: {quantity}, less that of plungeFoam without one", value - other, unit, cpu_s=cpu))
                    rows.append(Row(f"{name}: {quantity}, over that of plungeFoam without one", value / other, "1", cpu_s=cpu))
            if layer == "none":
                on_meshes[fluids] = found
        rows += memory(arguments.million)
    except CaseError as error:
        print(f"compare.py: {error}", file=sys.stderr)
        return 1

    write(HERE / "result.csv", rows)
    show(rows)
    subprocess.run(["plungeOverlay", *arguments.runs, "-mean", str(window), "-o", FIGURE], check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
