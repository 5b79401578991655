# SPDX-License-Identifier: GPL-3.0-or-later
"""The dive on overset meshes, whose background stands or follows the body, beside that on one mesh that moves with the body.

Nothing is interpolated on the single mesh, and nothing but the cells far from the body differs: the first layers about the body are as
thick, around it the cells are the same. Where the two part by more than the overset mesh should cost (2 % of a load, 0.5 % of the speed,
1e-4 of an impulse or volume), the figure tells of its fringe or of the coarser background. Loads are compared as their running means
over WINDOW; along the body's axis and across it, in its plane of symmetry, for the whole body. What is left of a load after its mean
is its noise.

The largest difference of the axial load is that of its rise, in the first half millisecond: the gas between nose and surface, and with it
the contact, depend on the cells around it, those of the background too. The first steps: the potential flow that is set up at the start
leaves the body no impulse but that of its weight and of the gas, which both meshes give alike."""
from functools import lru_cache

from plunge.studies.dives import WINDOW, Difference, Dive
from plunge.studies.pictures import draw
from plunge.studies.scenes import solveScene
from plunge.studies.signals import Signal
from plunge.studies.study import Quantity, Run, Study, twin

OVERSET, FOLLOWING, SINGLE = "overset", "following", "single"
dive = lru_cache(maxsize=None)(Dive)


def apart(of):
    """A figure of the difference of an overset mesh's dive to the single mesh's."""
    return twin(lambda done, single: float(of(Difference(dive(done.path), dive(single.path)), dive(done.path), dive(single.path))), variant=SINGLE)


def own(of):
    """A figure of a dive, over the largest axial load of the single mesh's [%]."""
    return lambda done: 100*of(dive(done.path))/float(dive(done.beside(variant=SINGLE).path).mean["axial"].max())


study = Study(
    title="The dive on an overset mesh is that on a single mesh",
    runs=[Run("gannetPlunge", "meshes", mesh, resolution, (tier,), given={"options": ["-mesh", mesh, *options]}) for mesh in (OVERSET, FOLLOWING, SINGLE)
          for resolution, tier, options in (("fast", "full", []), ("fast 2", "fine", []), ("fast 0.5", "quick", ["-set", "travel=0.3"]))],
    solve=solveScene, sources=("src/oversetMethods", "src/freeSurfaceFlow", "src/rigidBody", "applications/solvers/plungeFoam"),
    quantities=[
        Quantity("largest axial load, running mean", "N", lambda done: float(dive(done.path).mean["axial"].max())),
        Quantity("speed, largest difference over the impact speed", "%", apart(lambda d, a, b: d.speed.max()), 0, tolerance=0.5),
        Quantity("axial load, largest difference over the largest", "%", apart(lambda d, a, b: d.axial.max()), 0, tolerance=2),
        Quantity("axial load, largest difference after the first window", "%", apart(lambda d, a, b: d.axial[d.time > WINDOW].max())),
        Quantity("lateral load, largest difference over the largest axial", "%", apart(lambda d, a, b: d.lateral.max()), 0, tolerance=2),
        Quantity("lateral load, largest difference in the first 20 ms", "%", apart(lambda d, a, b: d.lateral[d.time <= 0.02].max())),
        Quantity("lateral load, mean difference", "%", apart(lambda d, a, b: d.lateral.mean())),
        Quantity("impulse of the start, difference over mass times impact speed", "%", apart(
            lambda d, a, b: 100*abs(a.impulse() - b.impulse())/(a.mass*a.impact)), 0, tolerance=0.01),
        Quantity("liquid's volume, largest error over the body's", "%", lambda done: dive(done.path).ledger(), 0, tolerance=0.01,
                 judged=lambda run: run.variant != SINGLE),
        *(Quantity(f"{load} load, rms about its mean over the largest axial", "%", own(lambda of, n=load: of.noise(n)))
          for load in ("lateral", "axial"))],
    headlines=["speed, largest difference over the impact speed", "axial load, largest difference over the largest"],
    figure=lambda done, file: draw(file, [({"xlabel": "time [ms]", "ylabel": f"{load} load on the body [N]", "title": "running means"}, {
        f"{each.run.variant}, as computed": Signal(1e3*dive(each.path).time[2:], dive(each.path).load[load][2:]) for each in done}, {
        each.run.variant: Signal(1e3*dive(each.path).time, dive(each.path).mean[load]) for each in done}) for load in ("axial", "lateral")], 2))
