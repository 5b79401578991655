#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""cases/fallingCone, half-angles and spacings: ./run.py [ANGLE:SPACING...] [OPTION OF plungeSPH...]"""
import subprocess
import sys
from pathlib import Path

from plunge.studies import REPOSITORY
from plunge.studies.particleRuns import solve

FOLDER = Path(__file__).resolve().parent
DEFAULT = ("45:0.003", "45:0.002", "45:0.0013", "12:0.003")


def main() -> None:
    words = sys.argv[1:]
    n = next((i for i, word in enumerate(words) if word.startswith("-")), len(words))
    for angle, spacing in (word.split(":") for word in words[:n] or DEFAULT):
        run = FOLDER / "run" / angle / "run" / f"{float(spacing):g}"
        if not run.exists():
            subprocess.run([REPOSITORY / "cases/fallingCone/makeCone", "-angle", angle, "-spacing", spacing, run], check=True)
        print(f"Running in {run}", flush=True)
        solve(run, *words[n:])


if __name__ == "__main__":
    main()
