# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies in an unbounded ideal fluid of density 1, in the plane, on one mesh that moves with them: a circle that is released from rest under a
gravity of 1 m/s2, and a free ellipse that starts with a velocity and a spin."""
import math
import re
import shutil
from pathlib import Path
from typing import Mapping, Tuple

import numpy as np

from plunge.studies.particleRuns import call, override
from plunge.studies.scenes import once
from plunge.studies.study import STUDIES

CASE = STUDIES / "addedMass/case"
INTEGRATORS = {"plungeFoam": "addedMass", "interFoam": "Newmark"}
RADIUS, RELEASE_END, STEP = 0.5, 0.5, 0.01  # [m], [s], [s]
A, B, ELLIPSE_END = 1.5, 0.5, 5.0           # semi-axes [m], [s]
FAR = 40        # radius of the mesh over the body's longer semi-axis: it takes 2/FAR^2 off the added mass
CELLS = 32, 96  # along a quarter of the body, and from it to the far boundary


def blocks(a: float, b: float, around: int, across: int) -> str:
    """blockMeshDict of four blocks about an ellipse, whose cells grow with the distance from it."""
    far = FAR*max(a, b)
    corners, edges = [], []
    for z in (0, 1):
        for ring, (x, y) in enumerate(((a, b), (far, far))):
            for quarter in range(4):
                angles = np.radians(45 + 90*quarter + np.linspace(0, 90, 41))
                points = [f"({x*math.cos(t):.12g} {y*math.sin(t):.12g} {z})" for t in angles]
                corners.append(points[0])
                first = 8*z + 4*ring
                edges.append(f"polyLine {first + quarter} {first + (quarter + 1) % 4} ( {' '.join(points[1:-1])} )")

    def at(z: int, ring: int, quarter: int) -> int:
        return 8*z + 4*ring + quarter % 4

    hexes = [f"hex ({' '.join(str(at(z, ring, q + on)) for z in (0, 1) for ring, on in ((0, 1), (0, 0), (1, 0), (1, 1)))}) "
             f"({around} {across} 1) simpleGrading (1 {far/min(a, b):g} 1)" for q in range(4)]

    def ring(number: int) -> str:
        return " ".join(f"({at(0, number, q)} {at(0, number, q + 1)} {at(1, number, q + 1)} {at(1, number, q)})" for q in range(4))

    sides = " ".join(f"({at(z, 0, q)} {at(z, 1, q)} {at(z, 1, q + 1)} {at(z, 0, q + 1)})" for q in range(4) for z in (0, 1))
    return ("FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }\n"
            f"vertices ( {' '.join(corners)} );\nedges ( {' '.join(edges)} );\nblocks ( {' '.join(hexes)} );\n"
            f"boundary ( body {{ type wall; faces ({ring(0)}); }} far {{ type patch; faces ({ring(1)}); }} "
            f"sides {{ type empty; faces ({sides}); }} );\n")


def solve(run: Path, solver: str, axes: Tuple[float, float], cells: Tuple[int, int], changes: Mapping[str, str] = {}, **entries: object) -> None:
    """Runs it to its end, or until it diverges. changes: text that takes the place of entries, by file."""
    def make() -> None:
        shutil.copytree(CASE, run)
        shutil.copytree(run / "0.orig", run / "0")
        (run / "system/blockMeshDict").write_text(blocks(*axes, *cells))
        (run / "system/parameters").write_text("".join(f"{key} {value};\n" for key, value in {
            **entries, "integrator": INTEGRATORS[solver], "step": STEP}.items()))
        if entries["velocity"] != "(0 0 0)" and solver == "plungeFoam":
            (run / "constant/sceneProperties").write_text(
                "FoamFile { version 2.0; format ascii; class dictionary; object sceneProperties; }\ninitialFlow potential;\n")
        for file, text in changes.items():
            override(run, file, text)
        call(run, "blockMesh")

    once(run, make)
    call(run, solver, check=False)


def release(run: Path, solver: str, ratio: float, cells: Tuple[int, int] = CELLS, end: float = RELEASE_END,
            changes: Mapping[str, str] = {}) -> None:
    """The circle, at a ratio of its density to the fluid's."""
    solve(run, solver, (RADIUS, RADIUS), cells, changes, mass=ratio*math.pi*RADIUS**2, momentOfInertia="(1 1 1)", velocity="(0 0 0)",
          angularMomentum="(0 0 0)", gravity="(0 -1 0)", end=end)


def ellipse(run: Path, solver: str) -> None:
    mass, inertia = math.pi*A*B, math.pi*A*B*(A*A + B*B)/4
    solve(run, solver, (A, B), CELLS, mass=mass, momentOfInertia=f"(1 1 {inertia})", velocity="(0.5 0.5 0)",
          angularMomentum=f"(0 0 {0.5*inertia})", gravity="(0 0 0)", end=ELLIPSE_END)


def track(run: Path) -> np.ndarray:
    """The body's trajectory, which may end before its time: then it has diverged."""
    return np.atleast_1d(np.genfromtxt(run / "postProcessing/trajectory/0/trajectory.csv", delimiter=",", names=True))


def isWhole(of: np.ndarray, end: float) -> bool:
    """Did it come to its end?"""
    return of.size > 0 and of["time_s"][-1] > end - 0.5*STEP


def tensor(directory: Path, time: float) -> np.ndarray:
    """The added mass that plungeFoam computed last, as it stands at a time that it wrote, 6 x 6."""
    text = (directory / f"{time:g}/uniform/addedMass").read_text()
    return np.array(re.search(r"tensor +36 \(([^)]*)\)", text).group(1).split(), float).reshape(6, 6)
