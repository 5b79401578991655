#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies in an unbounded ideal fluid of density 1, in the plane: result.csv and docs/figures/addedMass.png.

A circle of radius 0.5 m is released from rest under a gravity of 1 m/s2, at ratios r of its density to the fluid's from 0.01 to
10; its acceleration is (r - 1)/(r + 1) (Lamb 1932, art. 68), however long it moves. A free ellipse starts with a velocity and a spin,
against Kirchhoff and Kelvin's equations (reference/ellipse.csv). One mesh moves with the body. plungeFoam with the
integrator addedMass and OpenFOAM's interFoam with Newmark, no relaxation: the same cases, meshes and time steps, one pass for each."""
import math
import re
import shutil
from pathlib import Path
from typing import Dict, List, Tuple

import numpy as np

from plunge.studies.particleRuns import call
from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row, judge, show, write

FOLDER = Path(__file__).resolve().parent
FIGURE = FOLDER.parents[1] / "docs/figures/addedMass.png"
RATIOS = (0.01, 0.1, 1.0, 10.0)
SOLVERS = {"plungeFoam": "addedMass", "interFoam": "Newmark"}
RADIUS, RELEASE_END, STEP = 0.5, 0.5, 0.01
A, B, ELLIPSE_END = 1.5, 0.5, 5.0
EARLY = 1.0     # [s]; later its wake, which an ideal fluid does not have, acts on the ellipse
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


def run(directory: Path, solver: str, axes: Tuple[float, float], cells: Tuple[int, int], entries: Dict[str, object]) -> np.ndarray:
    """The body's trajectory, which may end before its time: then it has diverged. A run that is there is not made again."""
    if not directory.exists():
        shutil.copytree(FOLDER / "case", directory)
        shutil.copytree(directory / "0.orig", directory / "0")
        (directory / "system/blockMeshDict").write_text(blocks(*axes, *cells))
        (directory / "system/parameters").write_text("".join(f"{key} {value};\n" for key, value in {
            **entries, "integrator": SOLVERS[solver], "step": STEP}.items()))
        if entries.get("velocity") != "(0 0 0)" and solver == "plungeFoam":
            (directory / "constant/sceneProperties").write_text(
                "FoamFile { version 2.0; format ascii; class dictionary; object sceneProperties; }\ninitialFlow potential;\n")
        print(f"Running in {directory}", flush=True)
        call(directory, "blockMesh")
        call(directory, solver, check=False)
    return np.atleast_1d(np.genfromtxt(directory / "postProcessing/trajectory/0/trajectory.csv", delimiter=",", names=True))


def tensor(directory: Path, time: float) -> np.ndarray:
    """The added mass that plungeFoam computed last, as it stands at a time that it wrote, 6 x 6."""
    text = (directory / f"{time:g}/uniform/addedMass").read_text()
    return np.array(re.search(r"tensor +36 \(([^)]*)\)", text).group(1).split(), float).reshape(6, 6)


def isWhole(track: np.ndarray, end: float) -> bool:
    """Did it come to its end?"""
    return track.size > 0 and track["time_s"][-1] > end - 0.5*STEP


def release(directory: Path, solver: str, ratio: float, cells: Tuple[int, int], end: float) -> np.ndarray:
    displaced = math.pi*RADIUS**2
    return run(directory, solver, (RADIUS, RADIUS), cells, {
        "mass": ratio*displaced, "momentOfInertia": "(1 1 1)", "velocity": "(0 0 0)", "angularMomentum": "(0 0 0)",
        "gravity": "(0 -1 0)", "end": end})


def ellipse(solver: str) -> np.ndarray:
    mass, inertia = math.pi*A*B, math.pi*A*B*(A*A + B*B)/4
    return run(FOLDER / f"run/ellipse_{solver}", solver, (A, B), CELLS, {
        "mass": mass, "momentOfInertia": f"(1 1 {inertia})", "velocity": "(0.5 0.5 0)", "angularMomentum": f"(0 0 {0.5*inertia})",
        "gravity": "(0 0 0)", "end": ELLIPSE_END})


def draw(releases: Dict[Tuple[str, float], np.ndarray], ellipses: Dict[str, np.ndarray], exact: np.ndarray) -> None:
    picture, (left, right) = pyplot.subplots(1, 2, figsize=(12, 4.5))
    for number, ratio in enumerate(RATIOS):
        for solver, style in zip(SOLVERS, ("-", ":")):
            track = releases[solver, ratio]
            left.plot(track["time_s"], track["vy_m_s"], style, color=f"C{number}", label=f"density ratio {ratio:g}, {solver}")
        left.plot((0, RELEASE_END), (0, (1 - ratio)/(1 + ratio)*RELEASE_END), "--", color="0.5", linewidth=0.8)
    left.set(xlabel="time [s]", ylabel="velocity [m/s]", ylim=(-0.5, 0.6), title="Circle released from rest; dashed: exact")
    for number, (column, name) in enumerate((("v1_m_s", "u_body"), ("v2_m_s", "v_body"), ("omega3_rad_s", "omega"))):
        for solver, style in zip(SOLVERS, ("-", ":")):
            track = ellipses[solver]
            right.plot(track["time_s"], track[column], style, color=f"C{number}", label=f"{name}, {solver}")
        right.plot(exact["t"], exact[name], "--", color="0.5", linewidth=0.8)
    right.set(xlabel="time [s]", xlim=(0, ELLIPSE_END), ylim=(-1, 1.5), title="Free ellipse [m/s, rad/s]; dashed: exact")
    for axis in (left, right):
        axis.legend(fontsize="small")
    picture.tight_layout()
    picture.savefig(FIGURE, dpi=90)


def main() -> None:
    rows: List[Row] = []
    releases = {(solver, ratio): release(FOLDER / f"run/release_{ratio:g}_{solver}", solver, ratio, CELLS, RELEASE_END)
                for solver in SOLVERS for ratio in RATIOS}
    for (solver, ratio), track in releases.items():
        name = f"{solver}, circle released at density ratio {ratio:g}: velocity at {RELEASE_END:g} s over g t"
        if not isWhole(track, RELEASE_END):
            rows.append(Row(name, "diverged", "-"))
            continue
        exact = (1 - ratio)/(1 + ratio)
        value = float(track["vy_m_s"][-1]/RELEASE_END)
        # What is 0 is within 1 % of g
        rows.append(judge(name, value, "-", exact, 0.01*(abs(exact) or 1)) if solver == "plungeFoam" else Row(name, value, "-", exact))
    exact = np.genfromtxt(FOLDER / "reference/ellipse.csv", delimiter=",", skip_header=2, names=True)
    ellipses = {solver: ellipse(solver) for solver in SOLVERS}
    for solver, track in ellipses.items():
        for end in (EARLY, ELLIPSE_END):
            for column, name in (("v1_m_s", "u_body"), ("v2_m_s", "v_body"), ("omega3_rad_s", "omega")):
                what = f"{solver}, free ellipse: {name} less exact, largest to {end:g} s, over the largest exact"
                if not isWhole(track, end):
                    rows.append(Row(what, "diverged", "%"))
                    continue
                during = track["time_s"] <= end
                true = np.interp(track["time_s"][during], exact["t"], exact[name])
                value = 100*float(np.abs(track[column][during] - true).max()/np.abs(true).max())
                rows.append(judge(what, value, "%", 0, 1) if solver == "plungeFoam" else Row(what, value, "%"))
    squares = A*A - B*B
    for name, of, time, lamb in (
            ("circle, along x", ("release_1", 0), RELEASE_END, math.pi*RADIUS**2), ("ellipse, along its longer axis", ("ellipse", 0),
             ELLIPSE_END, math.pi*B*B), ("ellipse, along its shorter axis", ("ellipse", 1), ELLIPSE_END, math.pi*A*A),
            ("ellipse, in rotation", ("ellipse", 5), ELLIPSE_END, math.pi*squares**2/8)):
        value = float(tensor(FOLDER / f"run/{of[0]}_plungeFoam", time)[of[1], of[1]])
        rows.append(judge(f"plungeFoam, computed added mass: {name}, over the exact one", value/lamb, "-", 1, 0.01))
    write(FOLDER / "result.csv", rows)
    show(rows)
    draw(releases, ellipses, exact)


if __name__ == "__main__":
    main()
