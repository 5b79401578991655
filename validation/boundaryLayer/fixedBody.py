#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The dive's body, fixed in a stream of the liquid without a surface: its drag in plungeFoam.

    ./fixedBody.py RUN [OPTION OF plungeCase...]        e.g. run/thick -fluids water -set body.thicknessRatio=0.2
"""
import sys
from pathlib import Path

from plunge.bodyGeometry import Body
from plunge.foamDictionary import read
from plunge.studies.fixedBody import solve


def main() -> None:
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    run = Path(sys.argv[1]).resolve()
    found = solve(run, sys.argv[2:])
    given = read(run / "system/plungeGenerated")
    body = Body(given["bodyLength"], given["thicknessRatio"])
    pressure = given["liquidDensity"]/2*given["speed"]**2
    print(f"friction {found.friction:.4g} N, pressure drag {found.form:.4g} N, together {found.friction + found.form:.4g} N "
          f"({found.drift:+.2f} % over the last quarter length); over rho/2 U^2 S with S = {body.wetted_area:.4g} m2: "
          f"{found.friction/pressure/body.wetted_area:.4g} and {found.form/pressure/body.wetted_area:.4g}")


if __name__ == "__main__":
    main()
