#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What of the pressure is friction's? The same dam break in plungeFoam, twice: run/slip, whose walls slip, on cells of 10 mm, and
run/boundaryLayer, with the true viscosity and cells of 0.5 mm at the floor and the end wall, which resolve the boundary layer;
and with particles, on walls that slip, at a spacing of 5 mm: run/slipParticles."""
from pathlib import Path

from plunge.studies.meshTwins import solve
from plunge.studies.particleRuns import solveCase
from run import CONTROL, ENTRIES, HEIGHTS

FOLDER = Path(__file__).resolve().parent
LENGTH, TOP = 1.61, 0.9

# Cells along and up, their grading, and the walls
TWINS = {
    "slip": ("161 90", "1 1", "slip"),
    "boundaryLayer": ("200 90", "((0.7 0.6 1) (0.3 0.4 0.05)) ((0.3 0.6 20) (0.7 0.4 3))", "noSlip"),
}


def blocks(cells: str, grading: str) -> str:
    corners = " ".join(f"({x} {y} {z})" for z in (0, 0.01) for x, y in ((0, 0), (LENGTH, 0), (LENGTH, TOP), (0, TOP)))
    return (f"vertices ( {corners} );\nblocks ( hex (0 1 2 3 4 5 6 7) ({cells} 1) simpleGrading ({grading} 1) );\n"
            "boundary ( tankWall { type wall; faces ((0 4 7 3) (2 6 5 1) (1 5 4 0)); } atmosphere { type patch; faces ((3 7 6 2)); } );\n")


if __name__ == "__main__":
    # As close to the wall as the finer mesh has cells
    probes = " ".join(f"({LENGTH - 1e-4} {height} 0.005)" for height in HEIGHTS.values())
    for twin, (number, graded, friction) in TWINS.items():
        solve(FOLDER / "run" / twin, blocks(number, graded), friction, [("(0 0 -1)", "(0.6 0.3 1)", 1)], "(0 -9.81 0)",
              "probes { type probes; libs (sampling); fields (p); writeControl timeStep; writeInterval 1;"
              f" probeLocations ({probes}); }}", 1.25)
    solveCase("damBreakParticles", FOLDER / "run/slipParticles", {**ENTRIES, "geometry/spacing": 0.005, "walls": "slip"}, **CONTROL)
