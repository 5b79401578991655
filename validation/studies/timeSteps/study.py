# SPDX-License-Identifier: GPL-3.0-or-later
"""How much of a result is the time step: a sphere that heaves on the surface, on a mesh that deforms, and the dive on its overset mesh, which follows the body, with
steps of which each is half the one before. Variants are ddtSchemes. The sphere's height, over that of its release, until 8 s; the dive's speed lost and its load along the
axis, a mean of 1 ms, until 15 ms, over their largest. Values are differences to the run with half the step, rms; their order is that of the scheme while these are
more than what the interpolation between the meshes leaves.

Judged: half the step may change the load by 1 % of its peak; at 8e-5 s, at which the Courant number is 0.8, and below."""
import math

import numpy as np

from plunge.studies import heavingSphere
from plunge.studies.particleRuns import CONTROL
from plunge.studies.pictures import draw
from plunge.studies.scenes import solveScene
from plunge.studies.signals import Signal
from plunge.studies.study import Done, Quantity, Run, Study

SPHERE, DIVE, CELLS, SCHEMES = "heavingSphere", "gannetPlunge", 12, ("backward", "Euler")
STEPS = {SPHERE: [0.04/2**i for i in range(4)], DIVE: [1.6e-4/2**i for i in range(4)]}
TIMES = {SPHERE: np.linspace(0.5, 8, 200), DIVE: np.linspace(1e-3, 0.015, 200)}
WINDOW, TRAVEL = 1e-3, 0.39     # [s], [m]


def solve(run: Run, path) -> None:
    if run.scene == SPHERE:
        return heavingSphere.solve(path, CELLS, 0, end=8.5, step=run.size*CELLS/0.5, scheme=run.variant)
    solveScene(run, path, ["-set", f"travel={TRAVEL}", "-set", "frames=1"],
               {CONTROL: f"adjustTimeStep no; deltaT {run.size:g};", "system/fvSchemes": f"ddtSchemes {{ default {run.variant}; }}"})


def history(done: Done, column: str) -> np.ndarray:
    table, times = done.track, TIMES[done.run.scene]
    values = table["speed_m_s"][0] - table["speed_m_s"] if column == "lost" else table[column]
    signal = Signal(table["time_s"], values)
    return np.interp(times, *(signal.mean(WINDOW) if column == "a1_m_s2" else signal))


def finer(done: Done) -> Done | None:
    return done.beside(resolution=f"{done.run.size/2:g} s")


def change(scene: str, column: str):
    """By half the step, rms, over the largest value [%]."""
    def of(done: Done):
        half = finer(done) if done.run.scene == scene else None
        if half is None:
            return None
        this, other = history(done, column), history(half, column)
        return 100*float(np.sqrt(np.mean((this - other)**2))/np.abs(other).max())
    return of


def order(of):
    def observed(done: Done):
        values = of(done), of(half) if (half := finer(done)) else None
        return math.log2(values[0]/values[1]) if all(values) else None
    return observed


HEIGHT, LOST, LOAD = change(SPHERE, "z_m"), change(DIVE, "lost"), change(DIVE, "a1_m_s2")
study = Study(
    title="Half the time step hardly changes a dive or a float", solve=solve,
    runs=[Run(scene, "meshes", scheme, f"{step:g} s", ("full", "quick") if scene == SPHERE and i < 2 else ("full",))
          for scene, steps in STEPS.items() for scheme in SCHEMES for i, step in enumerate(steps)],
    sources=("src/freeSurfaceFlow", "src/rigidBody", "src/oversetMethods", "etc/methods", "validation/studies/sphereDecay/case"),
    quantities=[Quantity("change of the height by half the step", "%", HEIGHT), Quantity("order of the height", "1", order(HEIGHT)),
                Quantity("change of the speed lost by half the step", "%", LOST), Quantity("order of the speed lost", "1", order(LOST)),
                Quantity("change of the load by half the step", "%", LOAD, most=1, judged=lambda run: run.variant == "backward" and run.size <= 8e-5)],
    headlines=["change of the load by half the step"],
    figure=lambda done, file: draw(file, [({"xlabel": "time step [s]", "ylabel": f"{name} [%]", "xscale": "log", "yscale": "log"}, {}, {
        scheme: Signal(*map(np.array, zip(*sorted((each.run.size, of(each)) for each in done if each.run.variant == scheme and of(each)))))
        for scheme in SCHEMES}) for name, of in (("height", HEIGHT), ("speed lost", LOST))]))
