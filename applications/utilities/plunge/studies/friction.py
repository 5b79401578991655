# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction lines, and a flat plate in plungeFoam that should have their friction."""

from __future__ import annotations

import shutil
from math import log10, sqrt
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

from plunge.boundaryLayer import turbulent_friction
from plunge.studies.fixedBody import SOLVER, forces
from plunge.studies.particleRuns import call, override
from plunge.studies.references import reference
from plunge.studies.scenes import once
from plunge.studies.study import STUDIES

PLATE = STUDIES / "flatPlate/plate"
DENSITY, SPEED, WIDTH, HEIGHT = 664, 25, 0.1, 0.6   # of the liquid [kg/m3], its stream [m/s], of the plate and its domain, over its length


def line(name: str, reynolds: float) -> float:
    """Mean friction coefficient of one of the reference's lines, between its rows."""
    table = reference("frictionLines", "lines")
    return float(10**np.interp(log10(reynolds), np.log10(table["Re"]), np.log10(table[name])))


def blasius(reynolds: float) -> float:
    return 1.328/sqrt(reynolds)


def plateFriction(reynolds: float, transition: float) -> float:
    """Mean coefficient of Prandtl and Schlichting's line, less what a laminar run to the transition saves."""
    saved = transition*(turbulent_friction(transition) - blasius(transition)) if transition else 0.0
    return turbulent_friction(reynolds) - saved/reynolds


def grading(first: float, layers: int) -> float:
    """The last layer over the first, of a geometric series from `first` that fills the domain of unit length."""
    ratio = brentq(lambda r: first*(r**layers - 1)/(r - 1) - HEIGHT, 1 + 1e-6, 3)
    return float(ratio**(layers - 1))


def makePlate(run: Path, **entries: object) -> None:
    """A mesh and fields of the plate with other parameters."""
    shutil.copytree(PLATE, run)
    shutil.copytree(run / "0.orig", run / "0")
    override(run, "system/plateParameters", "\n".join(f"{key} {value};" for key, value in entries.items()))
    call(run, "blockMesh")


def solvePlate(run: Path, reynolds: float, first: float, layers: int, **entries: object) -> None:
    """Runs it; `first` layer over its length. It may be refused."""
    once(run, lambda: makePlate(run, speed=SPEED, viscosity=SPEED/reynolds, layers=layers, stretching=grading(first, layers), **entries))
    call(run, SOLVER, check=False)


def coefficient(run: Path) -> float:
    """Mean friction coefficient of a plate, at the end."""
    return float(forces(run)[2][-1, 0]/(DENSITY/2*SPEED**2*WIDTH))


def isRefused(run: Path) -> bool:
    """Did it say that its mesh does not resolve a laminar layer?"""
    return "does not resolve a laminar layer" in (run / f"log.{SOLVER}").read_text()
