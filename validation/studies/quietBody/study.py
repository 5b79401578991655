# SPDX-License-Identifier: GPL-3.0-or-later
"""A body that should feel nothing: noise of the overset mesh.

The meshes and the body of the dive in the liquid alone, which flows everywhere with the body's velocity. In STEPS time steps the body and
its mesh cross six cells of the background. Without gravity there is no force; with gravity there is the buoyancy. What differs is given
over rho U^2 A/2 with the largest section A, for plungeFoam's stencil and for that of OpenFOAM that is the fastest. Allowed is a
thousandth, a hundredth of the friction."""
import math
from pathlib import Path

import numpy as np

from plunge.foamDictionary import read
from plunge.studies.dives import STOCK_STENCIL, mesh
from plunge.studies.particleRuns import CONTROL, call, isComplete, override, setEntry
from plunge.studies.scenes import prepare
from plunge.studies.study import Done, Quantity, Run, Study

STEPS, STEP = 60, 1e-4  # [-], [s]
STENCILS = {"rigidZones": "method rigidZones;", "trackingInverseDistance": STOCK_STENCIL}
GRAVITY = {"no gravity": "(0 0 0)", "gravity": "(0 0 -1.35)"}


def field(run: Path, name: str, internal: object, others: str, **patches: str) -> None:
    """Sets a field of the start and what its patches are that no mesh makes so."""
    setEntry(run, f"0/{name}", "internalField", f"uniform {internal}")
    entries = {"sides": "type overset;", "symmetry": "type symmetryPlane;", **patches, '".*"': others}
    setEntry(run, f"0/{name}", "boundaryField", "{ " + " ".join(f"{patch} {{ {text} }}" for patch, text in entries.items()) + " }")


def solve(run: Run, path: Path) -> None:
    stencil, gravity = run.variant.split(", ")
    if prepare(run, path, ["-mesh", "overset"]):
        mesh(path)
        velocity = "(" + " ".join(map(repr, read(path / "system/plungeGenerated")["initialVelocity"])) + ")"
        field(path, "U", velocity, f"type fixedValue; value uniform {velocity};", farLiquid="type zeroGradient;",
              body=f"type movingWallVelocity; value uniform {velocity};")
        field(path, "alpha.liquid", 1, "type zeroGradient;")
        field(path, "p_rgh", 0, "type fixedFluxPressure; value uniform 0;", farLiquid="type fixedValue; value uniform 0;")
        call(path, "setFields")
        override(path, "constant/g", f"value {GRAVITY[gravity]};")
        override(path, "constant/bodyMotion", "mass 1e12; momentOfInertia (1e12 1e12 1e12); g (0 0 0);")
        override(path, "constant/sceneProperties", "initialFlow fields; fringe interpolated;")
        override(path, "system/fvSchemes", f"oversetInterpolation {{ {STENCILS[stencil]} }}")
        # A fraction that is 1 everywhere has no residual to be measured by
        override(path, "system/fvSolution", 'solvers { "alpha.liquid.*" { maxIter 2; } }')
        override(path, CONTROL, f"deltaT {STEP}; endTime {STEPS*STEP}; adjustTimeStep no; writeControl timeStep; writeInterval {STEPS};")
    if not isComplete(path, "plungeFoam"):
        call(path, "plungeFoam")


def noise(done: Done) -> np.ndarray:
    """Force beside its median, which is the buoyancy, over rho U^2 A/2, at the end of each step [%]."""
    given, track = read(done.path / "system/plungeGenerated"), done.track
    force = np.stack([track[f"Fp{c}_N"] + track[f"Fv{c}_N"] for c in "xyz"])[:, 1:]
    scale = 0.5*given["liquidDensity"]*given["speed"]**2*math.pi*(0.5*given["thicknessRatio"]*given["bodyLength"])**2
    return 100*np.linalg.norm(force - np.median(force, axis=1)[:, None], axis=0)/scale


study = Study(
    title="A body that moves with the liquid feels nothing of the overset mesh",
    runs=[Run("gannetPlunge", "meshes", f"{stencil}, {gravity}", resolution, tiers) for stencil in STENCILS for gravity in GRAVITY
          for resolution, tiers in (("fast", ("full",)), ("fast 0.5", ("quick",))) if tiers == ("full",) or stencil == "rigidZones"],
    solve=solve, sources=("src/oversetMethods", "src/freeSurfaceFlow", "applications/solvers/plungeFoam"),
    quantities=[Quantity(f"force noise over rho U^2 A/2, {when}", "%", lambda done, of=of: float(of(noise(done))), 0, tolerance=0.1,
                         judged=lambda run: run.variant.startswith("rigidZones"))
                for when, of in (("first step", lambda n: n[0]), ("after it", lambda n: n[1:].max()))],
    headlines=["force noise over rho U^2 A/2, after it"])
