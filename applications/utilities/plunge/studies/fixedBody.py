# SPDX-License-Identifier: GPL-3.0-or-later
"""The body of a scene, fixed in a stream of the liquid without a surface: its drag and its pressures in plungeFoam."""
from __future__ import annotations

import shutil
from pathlib import Path
from typing import NamedTuple, Sequence, Tuple

import numpy as np

from plunge import decisions
from plunge.foamDictionary import read
from plunge.studies.foamFields import numbers
from plunge.studies.particleRuns import CONTROL, call, isComplete, override
from plunge.studies.scenes import once, prepareCase
from plunge.studies.signals import Signal

SOLVER = "plungeFoam"
TRAVEL = 2      # of the stream, in body lengths: the layer is as long as the body after one
MEAN = 0.25     # of these, the last over which forces are averaged


class Drag(NamedTuple):
    """Forces on the whole body along its axis [N]: of friction and of pressure, means over the end of the run; and the change of
    their sum from the same time before it [%]."""
    friction: float
    form: float
    drift: float


def make(run: Path, options: Sequence[str], scene: str | Path) -> None:
    """Meshes and boundary conditions of a run of one body mesh."""
    prepareCase(scene, run, ["-mesh", "single", "-np", "1", *options])
    given = read(run / "system/plungeGenerated")
    stream = np.negative(given["forward"])*given["speed"]
    inflow = "({:.12g} {:.12g} {:.12g})".format(*stream)
    override(run, "constant/dynamicMeshDict", "dynamicFvMesh staticFvMesh;")
    override(run, "constant/sceneProperties",
             "gravity off; surfaceTension off; initialFlow fields;")
    length = given["bodyLength"]/given["speed"]
    override(run, CONTROL, f"endTime {TRAVEL*length}; writeInterval {TRAVEL*length}; maxCo 2; maxAlphaCo 2; "
             "#remove functions\nfunctions { forces { type forces; libs (forces); patches (body); rho rho; CofR (0 0 0); } "
             "wall { type surfaces; libs (sampling); writeControl writeTime; surfaceFormat raw; fields (p_rgh); "
             "surfaces ( body { type patch; patches (body); interpolate false; triangulate false; } ); } }")
    # One phase has no interface to solve for; a mesh that does not move suits GAMG
    override(run, "system/fvSolution", 'PIMPLE { nCorrectors 2; } solvers { "alpha.liquid.*" { MULESCorr no; nAlphaCorr 1; cAlpha 0; } '
             "p_rgh { solver GAMG; smoother DICGaussSeidel; } p_rghFinal { solver GAMG; smoother DICGaussSeidel; } }")
    override(run, "0.orig/alpha.liquid", "internalField uniform 1; boundaryField { far { type fixedValue; value uniform 1; } }")
    override(run, "0.orig/U", f"internalField uniform {inflow}; boundaryField {{ far {{ type freestreamVelocity; "
             f"freestreamValue uniform {inflow}; value uniform {inflow}; }} }}")
    override(run, "0.orig/p_rgh", "boundaryField { far { type freestreamPressure; freestreamValue uniform 0; value uniform 0; } }")
    call(run, "plungeBodyMesh")
    call(run, "gmshToFoam", "-keepOrientation", "body.msh")
    call(run, "createPatch", "-overwrite")
    shutil.copytree(run / "0.orig", run / "0")


def forces(run: Path) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times [s], and the forces of pressure and of friction at each [N]: the log of OpenFOAM's forces."""
    table = numbers(run / "postProcessing/forces/0/force.dat")
    return table[:, 0], table[:, 4:7], table[:, 7:10]


def drag(run: Path) -> Drag:
    """Of a finished run."""
    given = read(run / "system/plungeGenerated")
    time, pressure, viscous = forces(run)
    axis, share = np.negative(given["forward"]), 1/decisions.share(given["model"], "meshes")
    late = time > time[-1]*(1 - MEAN/TRAVEL)
    before = (time > time[-1]*(1 - 2*MEAN/TRAVEL)) & ~late
    friction, form = share*viscous @ axis, share*pressure @ axis
    total = friction + form
    return Drag(float(np.mean(friction[late])), float(np.mean(form[late])),
                float(100*(np.mean(total[late])/np.mean(total[before]) - 1)))


def pressure(run: Path) -> Signal:
    """Pressure coefficient over the distance from the nose along the axis, in body lengths, at the end of a finished run."""
    given = read(run / "system/plungeGenerated")
    x, y, z, value = numbers(max(run.glob("postProcessing/wall/*/p_rgh_body.raw"), key=lambda file: float(file.parent.name))).T
    along = (np.array([x, y, z]).T - given["nosePosition"]) @ np.negative(given["forward"])/given["bodyLength"]
    order = np.argsort(along)
    return Signal(along[order], value[order]/(given["liquidDensity"]/2*given["speed"]**2))


def solve(run: Path, options: Sequence[str], scene: str | Path = "gannetPlunge") -> None:
    """Runs it to its end, by the options of plungeCase."""
    once(run, lambda: make(run, options, scene), "ready")
    if not isComplete(run, SOLVER):
        # A run that was killed begins anew, and would leave its forces in another file beside
        shutil.rmtree(run / "postProcessing", ignore_errors=True)
        call(run, SOLVER)
