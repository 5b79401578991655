# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam breaks of plungeSPH in plungeFoam: the tutorial damBreak of OpenFOAM with another tank, mesh, water and walls. They tell what
is the method's from what is the walls' or the scene's.

limitedLinear takes no gradient from the wall, as linearUpwind does, which would rub like one on cells that are thicker than
the boundary layer."""
from pathlib import Path
from typing import Sequence, Tuple

from plunge.studies.particleRuns import CONTROL, call, isComplete, setEntry
from plunge.studies.scenes import once
from plunge.studies.tutorials import setUp

SOLVER = "plungeFoam"
Box = Tuple[str, str, float]  # its least and its largest corner, and the share of water in its cells


def solve(run: Path, blocks: str, friction: str, water: Sequence[Box], gravity: str, functions: str,
          endTime: float) -> None:
    """Meshes and runs it, unless it is complete.

    blocks: vertices, blocks and boundary of blockMeshDict: patches whose names end with Wall, and atmosphere; friction: slip or
    noSlip; functions: function objects; endTime [s]."""
    if isComplete(run, SOLVER):
        return

    def make() -> None:
        setUp("damBreak", run, application=SOLVER, endTime=endTime)
        (run / "system/blockMeshDict").write_text("FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }\n"
                                                  + blocks)
        (run / "0/alpha.water").write_text((run / "0/alpha.water.orig").read_text())
        for field, wall, above in (("U", friction, "pressureInletOutletVelocity; value uniform (0 0 0)"),
                                   ("p_rgh", "fixedFluxPressure; value uniform 0", "totalPressure; p0 uniform 0"),
                                   ("alpha.water", "zeroGradient", "inletOutlet; inletValue uniform 0; value uniform 0")):
            setEntry(run, f"0/{field}", "boundaryField",
                     f'{{ ".*Wall" {{ type {wall}; }} atmosphere {{ type {above}; }} defaultFaces {{ type empty; }} }}')
        setEntry(run, "constant/g", "value", gravity)
        setEntry(run, "system/fvSchemes", "divSchemes/div(rhoPhi,U)", "Gauss limitedLinear 1")
        setEntry(run, "system/setFieldsDict", "regions", "( " + " ".join(
            f"boxToCell {{ box {low} {high}; fieldValues ( volScalarFieldValue alpha.water {share} ); }}" for low, high, share in water) + " )")
        for entry, value in (("maxCo", 0.5), ("maxAlphaCo", 0.5), ("functions", f"{{ {functions} }}")):
            setEntry(run, CONTROL, entry, value)
        call(run, "blockMesh")
        call(run, "setFields")

    once(run, make, "ready")
    call(run, SOLVER)


# Lobovsky's tank: length and height [m], heights of its sensors in the end wall; cells along and up, their grading, and the walls
LENGTH, TOP, SENSORS = 1.61, 0.9, {"P1": 0.003, "P2": 0.015, "P3": 0.03, "P4": 0.08}
END_WALLS = {"walls slip": ("161 90", "1 1", "slip"),
             "boundary layer resolved": ("200 90", "((0.7 0.6 1) (0.3 0.4 0.05)) ((0.3 0.6 20) (0.7 0.4 3))", "noSlip")}


def endWall(run: Path, variant: str) -> None:
    """Lobovsky's dam break, with probes as close to the end wall as the finer mesh has cells."""
    cells, grading, friction = END_WALLS[variant]
    corners = " ".join(f"({x} {y} {z})" for z in (0, 0.01) for x, y in ((0, 0), (LENGTH, 0), (LENGTH, TOP), (0, TOP)))
    blocks = (f"vertices ( {corners} );\nblocks ( hex (0 1 2 3 4 5 6 7) ({cells} 1) simpleGrading ({grading} 1) );\nboundary ( "
              "tankWall { type wall; faces ((0 4 7 3) (2 6 5 1) (1 5 4 0)); } atmosphere { type patch; faces ((3 7 6 2)); } );\n")
    probes = " ".join(f"({LENGTH - 1e-4} {height} 0.005)" for height in SENSORS.values())
    solve(run, blocks, friction, [("(0 0 -1)", "(0.6 0.3 1)", 1)], "(0 -9.81 0)", "probes { type probes; libs (sampling); fields (p); "
          f"writeControl timeStep; writeInterval 1; probeLocations ({probes}); }}", 1.25)


# Yeh and Petroff's tank about the column, whose sides are the middle coordinates [m]
X, Y, Z = (0, 0.9, 1.02, 1.6), (0, 0.25, 0.37, 0.61), (0, 0.76)


def vertex(i: int, j: int, k: int) -> int:
    return i + 4*(j + 4*k)


def face(corners) -> str:
    return "(" + " ".join(str(vertex(*corner)) for corner in corners) + ")"


def columnBlocks(cell: float) -> str:
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


def column(run: Path, cell: float) -> None:
    """Yeh and Petroff's bore on cells of a size [m], on walls that slip; the layer on the floor is 0.01 m deep."""
    solve(run, columnBlocks(cell), "slip", [("(0 0 0)", f"(1.6 0.61 {cell})", 0.01/cell), ("(0 0 0)", "(0.4 0.61 0.3)", 1)], "(0 0 -9.81)",
          "force { type forces; libs (forces); patches (columnWall); CofR (0 0 0); writeControl timeStep; writeInterval 1; } "
          "upstream { type probes; libs (sampling); fields (U); writeControl timeStep; writeInterval 1;"
          " probeLocations ((0.814 0.31 0.026)); }", 1.5)
