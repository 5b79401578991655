#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""cases/fallingCone, half-angles and spacings: ./run.py [ANGLE:SPACING...] [OPTION OF plungeSPH...]"""
import subprocess
from pathlib import Path

from plunge.studies import REPOSITORY
from plunge.studies.particleRuns import commandLine, solve

FOLDER = Path(__file__).resolve().parent
DEFAULT = ("45:0.003", "45:0.002", "45:0.0013", "12:0.003")


def main() -> None:
    words, options = commandLine()
    for angle, spacing in (word.split(":") for word in words or DEFAULT):
        run = FOLDER / "run" / angle / "run" / f"{float(spacing):g}"
        if not run.exists():
            subprocess.run([REPOSITORY / "cases/fallingCone/makeCone", "-angle", angle, "-spacing", spacing, run], check=True)
        print(f"Running in {run}", flush=True)
        solve(run, *options)


if __name__ == "__main__":
    main()
