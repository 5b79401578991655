#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere released above its equilibrium on the surface of deep water: result.csv and docs/figures/sphereDecay.png.

Test 1 of IEA OES Task 10: radius 5 m, half immersed at rest, released 1 m up. A wedge of WEDGE degrees about the axis; the mesh moves
with the sphere near it and stands far from it. One pass per time step, the added mass computed. Judged against the mean of the
reference's codes: the mean time between the extremes of one sign, and the logarithmic decrement per period, from heights between
successive extremes, which an offset of the level does not touch. What the codes themselves differ by is given beside them. The
compression of the interface (cAlpha) feeds on waves that are not steep; so the sphere heaves with it and without.

    ./compare.py [CELLS...]     cells per radius at the surface, default 50 100
"""
import math
import shutil
import sys
from pathlib import Path
from typing import Dict, List, Tuple

import numpy as np

from plunge.studies.particleRuns import call, isComplete
from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row, judge, show, write

FOLDER = Path(__file__).resolve().parent
FIGURE = FOLDER.parents[1] / "docs/figures/sphereDecay.png"
RADIUS, MASS, HEIGHT = 5.0, 261.8e3, 1.0
WEDGE = 5.0             # [deg]
FAR = 70.0              # radius of the mesh [m]: waves are not back at the sphere within END
BAND = 0.3              # angle about the surface with fine cells [rad]
END = 16.0              # [s]
EXTREMES = 6            # that are used after the release
COMPRESSIONS = (0, 1)   # cAlpha


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


def solve(cells: int, compression: int) -> Tuple[np.ndarray, np.ndarray]:
    """Times [s] and height over the release's."""
    run = FOLDER / "run" / f"{cells}-{compression}"
    if not run.exists():
        shutil.copytree(FOLDER / "case", run)
        shutil.copytree(run / "0.orig", run / "0")
        (run / "system/blockMeshDict").write_text(blocks(cells))
        (run / "system/parameters").write_text(f"mass {MASS*WEDGE/360};\nheight {HEIGHT};\nend {END};\nframeInterval 1;\nstep {0.5/cells};\n"
                                                f"cAlpha {compression};\n")
        call(run, "blockMesh")
        call(run, "setAlphaField")
    if not isComplete(run, "plungeFoam"):
        print(f"Running in {run}", flush=True)
        call(run, "plungeFoam")
    track = np.genfromtxt(run / "postProcessing/trajectory/0/trajectory.csv", delimiter=",", names=True)
    return track["time_s"], track["z_m"]/HEIGHT


def figures(time: np.ndarray, height: np.ndarray) -> Tuple[float, float]:
    """Period [s] and logarithmic decrement per period."""
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


def main() -> None:
    table = np.genfromtxt(FOLDER / "reference/decay.csv", delimiter=",", skip_header=2)
    codes = (FOLDER / "reference/decay.csv").read_text().splitlines()[1].split(",")[1:]
    found = {code: figures(table[:, 0], table[:, i + 1]) for i, code in enumerate(codes)}
    period, decrement = np.array(list(found.values())).T
    rows: List[Row] = [Row("codes of the reference: period, least", float(period.min()), "s"),
                       Row("codes of the reference: period, largest", float(period.max()), "s"),
                       Row("codes of the reference: logarithmic decrement, least", float(decrement.min()), "1"),
                       Row("codes of the reference: logarithmic decrement, largest", float(decrement.max()), "1")]
    picture, axes = pyplot.subplots(figsize=(8, 4.5))
    for i, code in enumerate(codes):
        axes.plot(table[:, 0], table[:, i + 1], color="0.6", linewidth=0.8, label="six codes of IEA OES Task 10" if i == 0 else None)
    for cells in [int(word) for word in sys.argv[1:]] or [50, 100]:
        for compression in COMPRESSIONS:
            what = f"{cells} cells per radius, cAlpha {compression}"
            time, height = solve(cells, compression)
            axes.plot(time, height, label=what)
            T, delta = figures(time, height)
            rows += [judge(f"{what}: period over the codes' mean", T/period.mean(), "1", 1, 0.01),
                     judge(f"{what}: logarithmic decrement over the codes' mean", delta/decrement.mean(), "1", 1, 0.05)]
    axes.set(xlabel="time [s]", ylabel="height over that of the release", xlim=(0, END))
    axes.legend()
    picture.tight_layout()
    picture.savefig(FIGURE, dpi=90)
    write(FOLDER / "result.csv", rows)
    show(rows)


if __name__ == "__main__":
    main()
