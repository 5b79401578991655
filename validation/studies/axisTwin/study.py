# SPDX-License-Identifier: GPL-3.0-or-later
"""The dive along the vertical, held on its axis: of a sector of 5 degrees, of half of the body and of the whole of it.

The meshes have the same cells along the body and across its layers; in space they have a butterfly about the axis, in the sector wedges. All
are single meshes that move with the body, so that the dimension alone differs. The reference is the sector at the same resolution: each figure
of the half may be off it by the numerical uncertainties (GCI) of the two, which a coarsest mesh does not have. The whole body, on the half's
mesh and its image, may be off the half by what the pressure's equation is solved to, 1e-4; once, on the coarsest mesh."""
from functools import lru_cache

from plunge.results import read_numbers
from plunge.studies.dives import Dive
from plunge.studies.gridConvergence import levels
from plunge.studies.pictures import draw
from plunge.studies.scenes import solveScene
from plunge.studies.signals import Signal
from plunge.studies.study import Quantity, Run, Study, twin

SECTOR, HALF, WHOLE = "axisymmetric", "half", "full"
LEVELS = {"fast 0.5": ("quick", "full"), "fast 0.7": ("full",), "fast": ("full",)}
COARSEST, *_ = LEVELS
ORDERS, SOLVED = (1, 2), 0.01   # [%]
LOST = "velocity lost at full immersion"
dive = lru_cache(maxsize=None)(Dive)


def largest(done) -> float:
    return float(dive(done.path).mean["axial"].max())


def lost(done) -> float:
    return read_numbers(done.path / "results/summary.csv")[LOST][0]


def sector(of):
    """That figure of the sector at the same resolution."""
    return twin(lambda done, other: of(other), variant=SECTOR)


def uncertainty(of):
    """Of that figure, by the meshes of a model; none of the coarsest."""
    def found(done):
        runs = sorted((each for each in done.others.values() if each.run.variant == done.run.variant), key=lambda each: each.run.size)
        return levels([each.run.size for each in runs], [of(each) for each in runs], *ORDERS)[runs.index(done)]
    return found


def asSector(name: str, unit: str, of) -> Quantity:
    return Quantity(name, unit, of, sector(of), sector(uncertainty(of)), uncertainty(of), judged=lambda run: run.variant != SECTOR, converges=True)


def lessHalf(of):
    """A figure of the whole body less the half's, over it [%]."""
    return twin(lambda done, half: 100*(of(done)/of(half) - 1), lambda run: run.variant == WHOLE, variant=HALF)


study = Study(
    title="A dive along its axis is the same of a sector, of half of the body and of the whole",
    runs=[Run("gannetPlunge", "meshes", model, level, tiers,
              given={"options": ["-model", model, "-mesh", "single", "-set", "entry.angle=90", "-set", "body.freedom=axial"]})
          for model in (SECTOR, HALF, WHOLE) for level, tiers in LEVELS.items() if model != WHOLE or level == COARSEST],
    solve=solveScene, orders=ORDERS, sources=("src/freeSurfaceFlow", "src/rigidBody", "src/boundaryLayer", "applications/solvers/plungeFoam"),
    quantities=[
        asSector("largest axial load, running mean", "N", largest),
        asSector(LOST, "m/s", lost),
        *(Quantity(f"{name}: the whole body's less the half's, over it", "%", lessHalf(of), 0, tolerance=SOLVED)
          for name, of in (("largest axial load", largest), (LOST, lost)))],
    headlines=["largest axial load, running mean", LOST],
    figure=lambda done, file: draw(file, [({"xlabel": "time [ms]", "ylabel": "axial load on the body [N]", "title": level}, {}, {
        each.run.variant: Signal(1e3*dive(each.path).time, dive(each.path).mean["axial"]) for each in done if each.run.resolution == level})
        for level in LEVELS], 3))
