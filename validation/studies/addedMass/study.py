# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies whose added mass is known, in the plane, beside the stock solver. Variants are solvers and ratios r of densities.

A circle is released from rest at ratios of its density to the fluid's from 0.01 to 10; its acceleration is (r - 1)/(r + 1) (Lamb 1932, art. 68),
however long it moves. A free ellipse starts with a velocity and a spin, against Kirchhoff and Kelvin's equations; after a second its wake,
which an ideal fluid does not have, acts on it. plungeFoam with the integrator addedMass and OpenFOAM's interFoam with Newmark, no
relaxation: the same cases, meshes and time steps, one pass for each. A run that diverges has no number (nan). Allowed is 1 %, of g where
the circle does not move, as the mesh's far boundary and its cells make."""
import math
from pathlib import Path

import numpy as np

from plunge.studies.pictures import draw
from plunge.studies.planeBody import A, B, CELLS, ELLIPSE_END, RADIUS, RELEASE_END, ellipse, isWhole, release, tensor, track
from plunge.studies.references import reference
from plunge.studies.signals import Signal
from plunge.studies.study import Done, Quantity, Run, Study

CIRCLE, ELLIPSE, OURS, EARLY = "releasedCircle", "freeEllipse", "plungeFoam", 1.0
EXACT = reference("Lamb1932", "ellipse")
COLUMNS = {"u_body": "v1_m_s", "v_body": "v2_m_s", "omega": "omega3_rad_s"}
LAMB = {"circle, along x": (CIRCLE, 0, math.pi*RADIUS**2), "ellipse, along its longer axis": (ELLIPSE, 0, math.pi*B*B),
        "ellipse, along its shorter axis": (ELLIPSE, 1, math.pi*A*A), "ellipse, in rotation": (ELLIPSE, 5, math.pi*(A*A - B*B)**2/8)}


def solve(run: Run, path: Path) -> None:
    if run.scene == CIRCLE:
        release(path, run.given["solver"], run.given["ratio"], run.given["cells"])
    else:
        ellipse(path, run.given["solver"])


def velocity(done: Done):
    if done.run.scene == ELLIPSE:
        return None
    of = track(done.path)
    return float(of["vy_m_s"][-1]/RELEASE_END) if isWhole(of, RELEASE_END) else math.nan


def acceleration(done: Done) -> float:
    return (1 - done.run.given["ratio"])/(1 + done.run.given["ratio"])


def error(name: str, end: float):
    def of(done: Done):
        if done.run.scene == CIRCLE:
            return None
        found = track(done.path)
        during = found["time_s"] <= end
        true = np.interp(found["time_s"][during], EXACT["t"], EXACT[name])
        return 100*float(np.abs(found[COLUMNS[name]][during] - true).max()/np.abs(true).max()) if isWhole(found, ELLIPSE_END) else math.nan
    return of


def addedMass(scene: str, component: int, lamb: float):
    end = RELEASE_END if scene == CIRCLE else ELLIPSE_END
    return lambda done: float(tensor(done.path, end)[component, component])/lamb if (
        done.run.scene == scene and done.run.given["solver"] == OURS and done.run.given.get("ratio", 1) == 1) else None


OWN = {"judged": lambda run: run.given["solver"] == OURS}
study = Study(
    title="The added mass of circle and ellipse is Lamb's, and light bodies move as they should",
    runs=[*(Run(CIRCLE, "meshes", f"{solver}, r {ratio:g}", f"{cells[0]}", tiers, given={"solver": solver, "ratio": ratio, "cells": cells})
            for solver in (OURS, "interFoam") for ratio in (0.01, 0.1, 1.0, 10.0) for cells, tiers in ((CELLS, ("full",)), ((12, 32), ("quick",)))
            if tiers == ("full",) or solver == OURS and ratio in (0.1, 1)),
          *(Run(ELLIPSE, "meshes", solver, f"{CELLS[0]}", given={"solver": solver}) for solver in (OURS, "interFoam"))],
    solve=solve, sources=("src/rigidBody", "src/freeSurfaceFlow", "applications/solvers/plungeFoam", "validation/studies/addedMass/case"),
    quantities=[
        Quantity("velocity at the end over g t", "1", velocity, acceleration, tolerance=lambda done: 0.01*(abs(acceleration(done)) or 1), **OWN),
        *(Quantity(f"{name} less exact, largest to {when}, over the largest exact", "%", error(name, end), 0, tolerance=1, **OWN)
          for when, end in (("1 s", EARLY), ("the end", ELLIPSE_END)) for name in COLUMNS),
        *(Quantity(f"computed added mass over the exact one: {name}", "1", addedMass(*of), 1, tolerance=0.01) for name, of in LAMB.items())],
    headlines=["velocity at the end over g t", "computed added mass over the exact one: circle, along x"],
    figure=lambda done, file: draw(file, [
        ({"xlabel": "time [s]", "ylabel": "velocity of the released circle [m/s]", "ylim": (-0.5, 0.6)}, {}, {each.run.variant: Signal(
            track(each.path)["time_s"], track(each.path)["vy_m_s"]) for each in done if each.run.scene == CIRCLE}),
        ({"xlabel": "time [s]", "ylabel": "free ellipse [m/s, rad/s]", "ylim": (-1, 1.5)}, {f"{name}, exact": Signal(EXACT["t"], EXACT[name])
         for name in COLUMNS}, {f"{name}, {each.run.variant}": Signal(track(each.path)["time_s"], track(each.path)[column])
                                for each in done if each.run.scene == ELLIPSE for name, column in COLUMNS.items()})], 2))
