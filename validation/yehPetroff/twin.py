#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same bore on walls that slip: run/slip in plungeFoam, on cells of 20 mm; run/slipParticles, at a spacing of 15 mm."""
from pathlib import Path

from plunge.studies.meshTwins import solve
from plunge.studies.particleRuns import solveCase

FOLDER = Path(__file__).resolve().parent
CELL = 0.02
X, Y, Z = (0, 0.9, 1.02, 1.6), (0, 0.25, 0.37, 0.61), (0, 0.76)


def vertex(i: int, j: int, k: int) -> int:
    return i + 4*(j + 4*k)


def face(corners) -> str:
    return "(" + " ".join(str(vertex(*corner)) for corner in corners) + ")"


def blocks(cell: float) -> str:
    """Eight blocks about the column."""
    def n(a: float, b: float) -> int:
        return round((b - a)/cell)

    hexes, floor, top = [], [], []
    for i in range(3):
        for j in range(3):
            if (i, j) == (1, 1):
                continue
            ring = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
            hexes.append(f"hex ({' '.join(str(vertex(*at, k)) for k in (0, 1) for at in ring)}) "
                         f"({n(X[i], X[i + 1])} {n(Y[j], Y[j + 1])} {n(*Z)}) simpleGrading (1 1 1)")
            floor.append(face([(*at, 0) for at in ring]))
            top.append(face([(*at, 1) for at in ring]))

    def side(a, b) -> str:
        return face([(*a, 0), (*b, 0), (*b, 1), (*a, 1)])

    ends = [side((i, j), (i, j + 1)) for i in (0, 3) for j in range(3)] + [side((i, j), (i + 1, j)) for j in (0, 3) for i in range(3)]
    column = [side((i, 1), (i, 2)) for i in (1, 2)] + [side((1, j), (2, j)) for j in (1, 2)]
    return (f"vertices ( {' '.join(f'({x} {y} {z})' for z in Z for y in Y for x in X)} );\nblocks ( {' '.join(hexes)} );\n"
            f"boundary ( columnWall {{ type wall; faces ( {' '.join(column)} ); }} "
            f"tankWall {{ type wall; faces ( {' '.join(ends + floor)} ); }} atmosphere {{ type patch; faces ( {' '.join(top)} ); }} );\n")


if __name__ == "__main__":
    # The layer on the floor is half a cell deep
    water = [("(0 0 0)", "(1.6 0.61 0.02)", 0.5), ("(0 0 0)", "(0.4 0.61 0.3)", 1)]
    solve(FOLDER / "run/slip", blocks(CELL), "slip", water, "(0 0 -9.81)",
          "force { type forces; libs (forces); patches (columnWall); CofR (0 0 0); writeControl timeStep; writeInterval 1; } "
          "upstream { type probes; libs (sampling); fields (U); writeControl timeStep; writeInterval 1;"
          " probeLocations ((0.814 0.31 0.026)); }", 1.5)
    solveCase("yehPetroff", FOLDER / "run/slipParticles", {"geometry/spacing": 0.015, "walls": "slip"})
