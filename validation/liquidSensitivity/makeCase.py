#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A copy of cases/gannetPlunge whose fluids are variants of the paper's: density, viscosity, the real Kraken."""
import argparse
import shutil
from pathlib import Path
from typing import Dict

from plunge import diveParameters
from plunge.studies import REPOSITORY

DIVE = REPOSITORY / "cases/gannetPlunge"
PAPER = "titan"  # in constant/plungeFluids
KRAKEN = "kraken"

# Name, with the per cent of the paper's value: the factors
FACTORS: Dict[str, Dict[str, float]] = {
    PAPER: {},
    "density95": {"liquidDensity": 0.95},
    "density105": {"liquidDensity": 1.05},
    "viscosity50": {"liquidViscosity": 0.5},
    "viscosity200": {"liquidViscosity": 2},
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    asked = parser.add_mutually_exclusive_group(required=True)
    asked.add_argument("case", type=Path, nargs="?", help="where to")
    asked.add_argument("-names", action="store_true", help="the names of the fluids, and nothing else")
    arguments = parser.parse_args()
    if arguments.names:
        print(*FACTORS, KRAKEN)
        return

    paper = diveParameters.read(DIVE, {"fluids": PAPER}).fluids
    fluids = {name: {entry: value * factors.get(entry, 1) for entry, value in paper.items()}
              for name, factors in FACTORS.items()}
    fluids[KRAKEN] = diveParameters.read(DIVE, {"fluids": KRAKEN}).fluids

    shutil.copytree(DIVE, arguments.case, dirs_exist_ok=True, ignore=shutil.ignore_patterns("run", "Allrun", "Allclean"))
    with (arguments.case / "constant/plungeFluids").open("w") as file:
        file.write("FoamFile { version 2.0; format ascii; class dictionary; object plungeFluids; }\n")
        for name, entries in fluids.items():
            lines = "".join(f"    {entry:22s}{value:.8g};\n" for entry, value in entries.items())
            file.write(f"\n{name}\n{{\n{lines}}}\n")


if __name__ == "__main__":
    main()
