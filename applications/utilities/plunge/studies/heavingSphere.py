# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere that heaves on the surface: a wedge of WEDGE degrees about the axis; the mesh moves with the sphere near it and stands far from
it. One pass per time step, the added mass computed."""
import math
import shutil
from pathlib import Path
from typing import Dict, Tuple

import numpy as np

from plunge.results import gather
from plunge.studies.particleRuns import call, isComplete, override
from plunge.studies.scenes import once
from plunge.studies.signals import Signal
from plunge.studies.study import STUDIES

CASE = STUDIES / "sphereDecay/case"
RADIUS, MASS, HEIGHT = 5.0, 261.8e3, 1.0
WEDGE = 5.0             # [deg]
FAR = 70.0              # radius of the mesh [m]: waves are not back at the sphere within END
BAND = 0.3              # angle about the surface with fine cells [rad]
END = 16.0              # [s]
EXTREMES = 6            # that are used after the release


def blocks(cells: int) -> str:
    """blockMeshDict: three blocks from the sphere to the far boundary, below, at and above the surface, whose cells lie level."""
    half = math.radians(WEDGE)/2
    level = math.asin(RADIUS*math.sin(BAND)/FAR)
    angles = {RADIUS: (-math.pi/2, -BAND, BAND, math.pi/2), FAR: (-math.pi/2, -level, level, math.pi/2)}
    fine = round(2*BAND*cells)
    coarse = math.ceil(0.3*cells)
    size = 2*BAND/fine
    # The last of the coarse cells over the one next to the band
    growth = _ratio((math.pi/2 - BAND)/size, coarse)
    first = RADIUS*size
    radial = round(1.6*cells)
    outward = _ratio((FAR - RADIUS)/first, radial)

    def place(radius: float, angle: float, side: int) -> str:
        x = radius*math.cos(angle)
        return f"({x*math.cos(half):.12g} {side*x*math.sin(half):.12g} {HEIGHT + radius*math.sin(angle):.12g})"

    points, edges = [], []
    number: Dict[Tuple[int, int, int], int] = {}
    for ring, radius in enumerate((RADIUS, FAR)):
        for i, angle in enumerate(angles[radius]):
            onAxis = i in (0, 3)
            for side in (-1, 1):
                if onAxis and side == 1:
                    number[ring, i, side] = number[ring, i, -1]
                    continue
                number[ring, i, side] = len(points)
                points.append(place(radius, angle, side) if not onAxis else f"(0 0 {HEIGHT + radius*math.sin(angle):.12g})")
        for i in range(3):
            for side in (-1, 1):
                edges.append(f"arc {number[ring, i, side]} {number[ring, i + 1, side]} "
                             f"{place(radius, (angles[radius][i] + angles[radius][i + 1])/2, side)}")

    def hexahedron(i: int) -> str:
        corners = [number[0, i, -1], number[1, i, -1], number[1, i, 1], number[0, i, 1],
                   number[0, i + 1, -1], number[1, i + 1, -1], number[1, i + 1, 1], number[0, i + 1, 1]]
        count, grading = ((coarse, 1/growth), (fine, 1), (coarse, growth))[i]
        return f"hex ({' '.join(map(str, corners))}) ({radial} 1 {count}) simpleGrading ({outward:.8g} 1 {grading:.8g})"

    def faces(ring: int, which: Tuple[int, ...]) -> str:
        return " ".join(f"({number[ring, i, -1]} {number[ring, i, 1]} {number[ring, i + 1, 1]} {number[ring, i + 1, -1]})" for i in which)

    def sides(side: int) -> str:
        return " ".join(f"({number[0, i, side]} {number[1, i, side]} {number[1, i + 1, side]} {number[0, i + 1, side]})" for i in range(3))

    return ("FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }\n"
            f"vertices ( {' '.join(points)} );\nedges ( {' '.join(edges)} );\nblocks ( {' '.join(map(hexahedron, range(3)))} );\n"
            "defaultPatch { name axis; type empty; }\n"
            f"boundary ( body {{ type wall; faces ({faces(0, (0, 1, 2))}); }} bottom {{ type wall; faces ({faces(1, (0, 1))}); }} "
            f"atmosphere {{ type patch; faces ({faces(1, (2,))}); }} front {{ type wedge; faces ({sides(-1)}); }} "
            f"back {{ type wedge; faces ({sides(1)}); }} );\n")


def _ratio(length: float, cells: int) -> float:
    """Last over first of cells that grow geometrically, whose first is 1, and that fill the length."""
    low, high = 1.0, 10.0
    for _ in range(200):
        middle = (low + high)/2
        total = (middle**cells - 1)/(middle - 1) if middle > 1 else cells
        low, high = (middle, high) if total < length else (low, middle)
    return low**(cells - 1)


def solve(run: Path, cells: int, compression: int, end: float = END, step: float = 1, scheme: str = "backward") -> None:
    """cells per radius at the surface; compression: cAlpha; step: over the usual time step; scheme: ddtSchemes."""
    def make() -> None:
        shutil.copytree(CASE, run)
        shutil.copytree(run / "0.orig", run / "0")
        (run / "system/blockMeshDict").write_text(blocks(cells))
        (run / "system/parameters").write_text(f"mass {MASS*WEDGE/360};\nheight {HEIGHT};\nend {end};\nframeInterval 1;\nstep {0.5/cells*step};\n"
                                                f"cAlpha {compression};\n")
        override(run, "system/fvSchemes", f"ddtSchemes {{ default {scheme}; }}")
        call(run, "blockMesh")
        call(run, "setAlphaField")

    once(run, make)
    if not isComplete(run, "plungeFoam"):
        call(run, "plungeFoam")


def height(run: Path) -> Signal:
    """Over that of the release, over time [s]."""
    track = gather(run)["trajectory"]
    return Signal(track["time_s"], track["z_m"]/HEIGHT)


def oscillation(of: Signal) -> Tuple[float, float]:
    """Period [s] and logarithmic decrement per period."""
    time, height = of
    at = []
    for i, t in enumerate(time):
        near = height[np.abs(time - t) < 1]
        if 1 < t < time[-1] - 1 and height[i] in (near.min(), near.max()) and (not at or t - time[at[-1]] > 1):
            at.append(i)
    times, values = [], []
    for i in at[:EXTREMES]:
        near = np.abs(time - time[i]) < 0.3
        a, b, c = np.polyfit(time[near] - time[i], height[near], 2)
        times.append(time[i] - b/(2*a))
        values.append(c - b*b/(4*a))
    period = float(np.mean(np.array(times[2:]) - np.array(times[:-2])))
    swing = np.log(np.abs(np.diff(values)))
    return period, float(-2*np.polyfit(np.arange(len(swing)), swing, 1)[0])
