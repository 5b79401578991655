#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare dives of one case at several resolutions: writes result.csv and prints it.

A doubling of the resolution may change the velocity lost at full immersion by less than 10 %. Where the runs given are
not a factor of two apart, the change that a doubling would make is estimated from them for first order, the order of
the time scheme and of the interface: (1 - 1/2)/(1 - 1/ratio) times the change between them. An estimate says so.
"""
import argparse
import sys
from itertools import combinations
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "applications/utilities/plungePost"))
sys.path.insert(0, str(HERE.parent))
from plungeResults import CaseError, cell_count, cpu_seconds, entry, read_numbers  # noqa: E402
from resultTable import Row, judge, show, write  # noqa: E402

JUDGED = "velocity lost at full immersion"
REPORTED = (JUDGED, "peak deceleration", "full immersion time", "pitch change at full immersion",
            "max |volume ledger error|")
ALLOWED_CHANGE = 10.0  # % per doubling


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", type=Path, nargs="+", help="run directories of cases/gannetPlunge, finished")
    arguments = parser.parse_args()

    rows = []
    try:
        dives = sorted((float(entry(run, "system/plungeGenerated", "resolution")), run) for run in arguments.runs)
        found = {}
        for resolution, run in dives:
            numbers = found[resolution] = read_numbers(run / "results/summary.csv")
            cpu = f"{cpu_seconds(run):.0f}"
            rows.append(Row(f"resolution {resolution:g}: cells", str(cell_count(run)), "1", cpu_s=cpu))
            rows += [Row(f"resolution {resolution:g}: {name}", f"{numbers[name][0]:.5g}", numbers[name][1], cpu_s=cpu)
                     for name in REPORTED]
    except CaseError as error:
        print(f"compare.py: {error}", file=sys.stderr)
        return 1

    for coarse, fine in combinations(sorted(found), 2):
        change = 100 * (found[fine][JUDGED][0] / found[coarse][JUDGED][0] - 1)
        estimated = abs(fine / coarse - 2) > 1e-6
        if estimated:
            change *= 0.5 / (1 - coarse / fine)
        how = f"estimated from {coarse:g} and {fine:g}" if estimated else f"from {coarse:g} to {fine:g}"
        rows.append(judge(f"change of {JUDGED} by doubling, {how}", change, "%", 0, ALLOWED_CHANGE))

    write(HERE / "result.csv", rows)
    show(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
