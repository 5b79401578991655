# SPDX-License-Identifier: GPL-3.0-or-later
"""The boundary layer's models on a flat plate against friction lines. Variants are models.

Laminar at Re 1e5 on a mesh with the coarsest first layer that plungeFoam takes for it, and one that it must refuse; the friction line on a
coarse mesh at Re 1e5, both within 5 % of Blasius; at the Reynolds number of the dive, with several transitions, and wall functions: within
a tenth, which is what the lines differ by."""
from math import sqrt
from pathlib import Path

from plunge.studies.friction import blasius, coefficient, isRefused, line, plateFriction, solvePlate
from plunge.studies.study import Quantity, Run, Study

AT_DIVE, LAMINAR = 1.637e7, 1e5     # Reynolds numbers
THICKNESS = 2.5/sqrt(LAMINAR/2)     # of the laminar layer at half length, over the length: 5 sqrt(nu x/U)
REFUSED, QUICK = "laminar, unresolved", "frictionLine, transition 500000"
# Reynolds number, its friction, first layer over the length, layers, other entries of the plate
PLATES = {
    "laminar": (LAMINAR, blasius(LAMINAR), THICKNESS/10.01, 30, {"boundaryLayer": "laminar", "cells": 80}),
    REFUSED: (LAMINAR, blasius(LAMINAR), THICKNESS/2, 20, {"boundaryLayer": "laminar"}),
    "frictionLine, laminar": (LAMINAR, blasius(LAMINAR), THICKNESS/2, 20, {}),
    **{f"frictionLine, transition {at:g}": (AT_DIVE, plateFriction(AT_DIVE, at), 2.4e-3, 20, {"transitionReynolds": at})
       for at in (0.0, 5e5, 1e6, 3e6)},
    "wallFunction": (AT_DIVE, line("PrandtlSchlichting", AT_DIVE), 1.7e-4, 40, {"boundaryLayer": "wallFunction", "simulationType": "RAS", "cells": 80}),
}


def solve(run: Run, path: Path) -> None:
    reynolds, _, first, layers, entries = PLATES[run.variant]
    solvePlate(path, reynolds, first, layers, **entries)


def coefficientOf(laminar: bool, value):
    """A figure of the plates that are not refused, in laminar or turbulent flow."""
    return lambda done: value(coefficient(done.path), PLATES[done.run.variant][1]) if (
        done.run.variant != REFUSED and laminar == (PLATES[done.run.variant][0] == LAMINAR)) else None


study = Study(
    title="The friction of a flat plate is that of the friction lines",
    runs=[Run("plate", "meshes", name, tiers=("quick", "full") if name in (REFUSED, QUICK) else ("full",)) for name in PLATES],
    solve=solve, sources=("src/boundaryLayer", "src/freeSurfaceFlow", "applications/solvers/plungeFoam", "validation/studies/flatPlate/plate"),
    quantities=[
        Quantity("friction over Blasius'", "1", coefficientOf(True, lambda found, exact: found/exact), 1, tolerance=0.05),
        Quantity("friction coefficient", "1e-3", coefficientOf(False, lambda found, _: 1e3*found), lambda done: 1e3*PLATES[done.run.variant][1],
                 tolerance=lambda done: 100*PLATES[done.run.variant][1]),
        Quantity("a mesh that does not resolve the layer is refused", "1",
                 lambda done: float(isRefused(done.path)) if done.run.variant == REFUSED else None, 1, tolerance=0)],
    headlines=["friction coefficient"])
