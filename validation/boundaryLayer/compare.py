#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The boundary layer's models against friction lines: a flat plate, and the dive's body fixed in a stream. Writes result.csv.

plate: laminar at Re 1e5 on a mesh with the coarsest first layer that plungeFoam takes for it, and one that it must refuse; the
friction line on a coarse mesh at Re 1e5 and, with several transitions, at that of the dive; wall functions there.

body: friction within a tenth of the line's, friction and form drag within a tenth of the line's times Hoerner's form factor of a
slender body of revolution, 1 + 1.5 (d/l)^1.5 + 7 (d/l)^3 (Hoerner, Fluid-Dynamic Drag, 1965).

cost: CPU time of a step of the dive's beginning over that of one without a boundary layer on the same mesh.
"""
import argparse
import shutil
from concurrent.futures import ThreadPoolExecutor
from math import log10, sqrt
from pathlib import Path
from typing import Dict, List, Tuple

import numpy as np
from scipy.optimize import brentq

from plunge.bodyGeometry import Body
from plunge.boundaryLayer import turbulent_friction
from plunge.foamDictionary import read
from plunge.results import cell_count
from plunge.studies.dives import finish, start
from plunge.studies.fixedBody import SOLVER, Drag, forces, solve
from plunge.studies.particleRuns import call, isComplete, override
from plunge.studies.resultTable import Row, judge, limit, show, write
from plunge.studies.resultTable import read as readRows
from plunge.studies.solverLogs import perStep, readLog

FOLDER = Path(__file__).resolve().parent

DENSITY, WIDTH, HEIGHT = 664, 0.1, 0.6      # of the plate's liquid [kg/m3], of the plate and of its domain, over its length
AT_DIVE, LAMINAR = 1.637e7, 1e5             # Reynolds numbers
TRANSITIONS = (0.0, 5e5, 1e6, 3e6)
TURNS = 3                                   # of what is timed: the median counts


def lines(reynolds: float) -> Dict[str, float]:
    """Mean friction coefficients of the reference's lines at a Reynolds number between its rows."""
    table = readRows(FOLDER / "reference/frictionLines.csv")
    x = [log10(float(row["Re"])) for row in table]
    return {name: float(10**np.interp(log10(reynolds), x, [log10(float(row[name])) for row in table]))
            for name in table[0] if name != "Re"}


def plate_friction(reynolds: float, transition: float) -> float:
    """Mean coefficient of Prandtl and Schlichting's line, less what a laminar run to the transition saves."""
    saved = transition*(turbulent_friction(transition) - 1.328/sqrt(transition)) if transition else 0.0
    return turbulent_friction(reynolds) - saved/reynolds


def grading(first: float, layers: int) -> float:
    """The last layer over the first, of a geometric series from `first` that fills the domain of unit length."""
    ratio = brentq(lambda r: first*(r**layers - 1)/(r - 1) - HEIGHT, 1 + 1e-6, 3)
    return float(ratio**(layers - 1))


def plate(name: str, reynolds: float, first: float, layers: int, **entries: object) -> Path:
    """Runs a plate, unless it is complete; `first` layer over its length."""
    run = FOLDER / "run" / f"plate-{name}"
    if isComplete(run, SOLVER):
        return run
    shutil.rmtree(run, ignore_errors=True)
    shutil.copytree(FOLDER / "plate", run)
    shutil.copytree(run / "0.orig", run / "0")
    given = {"speed": 25, "viscosity": 25/reynolds, "layers": layers, "stretching": grading(first, layers), **entries}
    override(run, "system/plateParameters", "\n".join(f"{key} {value};" for key, value in given.items()))
    call(run, "blockMesh")
    call(run, SOLVER, check=False)
    return run


def coefficient(run: Path) -> float:
    """Mean friction coefficient of a plate, at the end."""
    _, _, viscous = forces(run)
    return float(viscous[-1, 0]/(DENSITY/2*25**2*WIDTH))


def plates() -> List[Row]:
    # 5 sqrt(nu x/U) at half length
    layer = 2.5/sqrt(LAMINAR/2)
    rows = []
    run = plate("laminar", LAMINAR, layer/10.01, 30, boundaryLayer="laminar", cells=80)
    rows.append(judge("plate, Re 1e5: laminar, ten first layers in the layer, friction over Blasius'", coefficient(run)/(1.328/sqrt(LAMINAR)), "1", 1, 0.05))
    run = plate("unresolved", LAMINAR, layer/2, 20, boundaryLayer="laminar")
    refused = "does not resolve a laminar layer" in (run / f"log.{SOLVER}").read_text()
    rows.append(judge("plate, Re 1e5: laminar, two first layers in the layer, refused", float(refused), "1", 1, 0))
    run = plate("coarse", LAMINAR, layer/2, 20)
    rows.append(judge("plate, Re 1e5: friction line, two first layers in the layer, friction over Blasius'",
                      coefficient(run)/(1.328/sqrt(LAMINAR)), "1", 1, 0.05))
    for transition in TRANSITIONS:
        run = plate(f"transition{transition:.0e}", AT_DIVE, 2.4e-3, 20, transitionReynolds=transition)
        asked = plate_friction(AT_DIVE, transition)
        rows.append(judge(f"plate, Re {AT_DIVE:g}: friction line, transition at Re_x {transition:g}, friction", 1e3*coefficient(run), "1e-3", 1e3*asked, 1e2*asked))
    run = plate("wallFunction", AT_DIVE, 1.7e-4, 40, boundaryLayer="wallFunction", simulationType="RAS", cells=80)
    asked = lines(AT_DIVE)["PrandtlSchlichting"]
    rows.append(judge(f"plate, Re {AT_DIVE:g}: wall functions of kOmegaSST, friction", 1e3*coefficient(run), "1e-3", 1e3*asked, 1e2*asked))
    return rows


# Fluids, tier, boundary layer, and a transition where it is not the default
BODIES: Tuple[Tuple[str, str, str, float], ...] = (
    *((fluids, "standard", "frictionLine", 5e5) for fluids in ("titan", "water")),
    *((fluids, "fast", layer, 5e5) for layer in ("wallFunction", "frictionLine") for fluids in ("titan", "water")),
    ("titan", "fast", "frictionLine", 1e6), ("titan", "fast", "frictionLine", 3e6), ("titan", "fast", "none", 5e5),
)


def options_of(fluids: str, tier: str, layer: str, transition: float) -> List[str]:
    return ["-fluids", fluids, "-tier", tier, "-boundaryLayer", layer, "-set", f"transitionReynolds={transition:g}"]


def body_run(fluids: str, tier: str, layer: str, transition: float) -> Path:
    return FOLDER / "run" / f"{fluids}-{tier}-{layer}-{transition:g}"


def bodies(results: Dict[Tuple[str, str, str, float], Drag]) -> List[Row]:
    rows = []
    for which, drag in results.items():
        fluids, tier, layer, transition = which
        given = read(body_run(*which) / "system/plungeGenerated")
        body = Body(given["bodyLength"], given["thicknessRatio"])
        reynolds = given["liquidDensity"]*given["speed"]*body.length/given["liquidViscosity"]
        unit = given["liquidDensity"]/2*given["speed"]**2*body.wetted_area
        name = f"body, {fluids}, tier {tier}, {layer}" + (f", transition at Re_x {transition:g}" if transition != 5e5 else "")
        rows.append(Row(f"{name}: cells", cell_count(body_run(*which)), "1"))
        if layer == "none":
            rows.append(Row(f"{name}: pressure drag", drag.form, "N"))
            continue
        # ITTC's line, of ships, where the layer is turbulent almost throughout, else the one that knows a laminar run
        line = unit*(lines(reynolds)["ITTC57"] if transition == 5e5 else plate_friction(reynolds, transition))
        slender = body.thickness_ratio
        form = 1 + 1.5*slender**1.5 + 7*slender**3
        rows.append(judge(f"{name}: friction", drag.friction, "N", line, 0.1*line))
        rows.append(judge(f"{name}: friction and pressure drag", drag.friction + drag.form, "N", form*line, 0.1*form*line)
                    if transition == 5e5 else Row(f"{name}: pressure drag", drag.form, "N"))
        rows.append(Row(f"{name}: change of the drag over the last quarter length of the stream", drag.drift, "%"))
    return rows


def costs() -> List[Row]:
    """Of the steps of a dive's beginning, in turns so that what else the machine does meets all alike."""
    rows = []
    slip = {"constant/sceneProperties": "boundaryLayer none;", "constant/turbulenceProperties": "simulationType laminar;"}
    for layer, most in (("frictionLine", 1.03), ("wallFunction", 1.35)):
        ratios = []
        for turn in range(TURNS):
            seconds = []
            for name, changes in ((layer, {}), ("none", slip)):
                run = FOLDER / "run" / f"cost-{layer}-{turn}-{name}"
                finish(start(run, ["-np", "1", "-boundaryLayer", layer, "-set", "dive.travel=0.1", "-set", "output.frames=1"], changes))
                steps = readLog(run / f"log.{SOLVER}")
                seconds.append(perStep(steps, len(steps)//3 + 1))
            ratios.append(seconds[0]/seconds[1])
        rows.append(limit(f"dive, {layer}: CPU time of a step over that without a boundary layer on the same mesh", float(np.median(ratios)), "1", most))
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tiers", nargs="*", default=["fast", "standard"], help="of the body (default: fast standard)")
    tiers = parser.parse_args().tiers

    chosen = [which for which in BODIES if which[1] in tiers]
    with ThreadPoolExecutor(2) as pool:
        drags = list(pool.map(lambda which: solve(body_run(*which), options_of(*which)), chosen))
    rows = plates() + bodies(dict(zip(chosen, drags))) + costs()
    write(FOLDER / "result.csv", rows)
    show(rows)


if __name__ == "__main__":
    main()
