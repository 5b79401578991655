#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A body that should feel nothing: result.csv.

The meshes and the body of cases/gannetPlunge, tier fast, in the liquid alone, which flows everywhere with the body's velocity of
25 m/s. In STEPS time steps the body and its mesh cross six cells of the background. Without gravity there is no force; with gravity
there is the buoyancy. What differs is noise of the overset mesh. It is given over rho U^2 A/2 with the largest section A, for
plungeFoam's stencil and for that of OpenFOAM that is the fastest.
"""
import math
from pathlib import Path
from typing import List

import numpy as np

from plunge.foamDictionary import read
from plunge.results import gather
from plunge.studies.dives import STOCK_STENCIL, setUp
from plunge.studies.particleRuns import CONTROL, call, isComplete, override, setEntry
from plunge.studies.resultTable import Row, limit, show, write

FOLDER = Path(__file__).resolve().parent
STEPS, STEP = 60, 1e-4  # [-], [s]
STENCILS = {"rigidZones": "method rigidZones;", "trackingInverseDistance": STOCK_STENCIL}
SCENES = {"uniform flow": "(0 0 0)", "uniform flow under gravity": "(0 0 -1.35)"}


def field(run: Path, name: str, internal: object, others: str, **patches: str) -> None:
    """Sets a field of the start and what its patches are that no mesh makes so."""
    setEntry(run, f"0/{name}", "internalField", f"uniform {internal}")
    entries = {"sides": "type overset;", "symmetry": "type symmetryPlane;", **patches, '".*"': others}
    setEntry(run, f"0/{name}", "boundaryField", "{ " + " ".join(f"{patch} {{ {text} }}" for patch, text in entries.items()) + " }")


def solve(name: str, stencil: str, gravity: str) -> Path:
    run = FOLDER / "run" / name
    if setUp(run, ("-np", "1")):
        for program in ("plungeBodyMesh", "gmshToFoam -keepOrientation body.msh", "createPatch -overwrite", "blockMesh -case background",
                        "snappyHexMesh -case background -overwrite", "mergeMeshes . background -overwrite"):
            call(run, *program.split())
        (run / "0.orig").rename(run / "0")
        given = read(run / "system/plungeGenerated")
        velocity = "(" + " ".join(map(repr, given["initialVelocity"])) + ")"
        field(run, "U", velocity, f"type fixedValue; value uniform {velocity};", farLiquid="type zeroGradient;",
              body=f"type movingWallVelocity; value uniform {velocity};")
        field(run, "alpha.liquid", 1, "type zeroGradient;")
        field(run, "p_rgh", 0, "type fixedFluxPressure; value uniform 0;", farLiquid="type fixedValue; value uniform 0;")
        call(run, "setFields")
        override(run, "constant/g", f"value {gravity};")
        override(run, "constant/bodyMotion", "mass 1e12; momentOfInertia (1e12 1e12 1e12); g (0 0 0);")
        override(run, "constant/sceneProperties", "initialFlow fields; fringe interpolated;")
        override(run, "system/fvSchemes", f"oversetInterpolation {{ {stencil} }}")
        # A fraction that is 1 everywhere has no residual to be measured by
        override(run, "system/fvSolution", 'solvers { "alpha.liquid.*" { maxIter 2; } }')
        override(run, CONTROL, f"deltaT {STEP}; endTime {STEPS*STEP}; adjustTimeStep no; writeControl timeStep; writeInterval {STEPS};")
    if not isComplete(run, "plungeFoam"):
        call(run, "plungeFoam")
    return run


def noise(run: Path) -> List[float]:
    """Largest force beside its median, which is the buoyancy: in the first step and after it, over rho U^2 A/2."""
    given = read(run / "system/plungeGenerated")
    track = gather(run)["trajectory"]
    force = np.stack([track[f"Fp{c}_N"] + track[f"Fv{c}_N"] for c in "xyz"])[:, 1:]
    force = np.linalg.norm(force - np.median(force, axis=1)[:, None], axis=0)
    scale = 0.5*given["liquidDensity"]*given["speed"]**2*math.pi*(0.5*given["thicknessRatio"]*given["bodyLength"])**2
    return [float(force[0]/scale), float(force[1:].max()/scale)]


def main() -> None:
    rows: List[Row] = []
    for scene, gravity in SCENES.items():
        for stencil, text in STENCILS.items():
            first, later = noise(solve(f"{stencil}-{scene.replace(' ', '-')}", text, gravity))
            for when, value in (("first step", first), ("after it", later)):
                what = f"{stencil}, {scene}, force noise over rho U^2 A/2, {when}"
                rows.append(limit(what, 100*value, "%", 0.1) if stencil == "rigidZones" else Row(what, 100*value, "%"))
    write(FOLDER / "result.csv", rows)
    show(rows)


if __name__ == "__main__":
    main()
