# SPDX-License-Identifier: GPL-3.0-or-later
"""Only what a scene requires: ten scenes as plungeCase decides them, and each with one decision overruled: what the physics that is left out would cost, and
what error leaving it out makes, or the other way round.

Variants are a scene and, after the colon, what is overruled. The answer is the deceleration of the body, as a mean over a fiftieth of the time, or the height of
the liquid at a gauge of a tank; its difference to that of the scene as decided, rms, is given over the largest value. Nothing is judged: that a decision is right shows
where what was left out costs time and changes little, and what was kept changes much. Meshes are coarse, as the question is a difference. Compressibility cannot be had;
its Mach numbers stand in the decisions."""
from __future__ import annotations

import numpy as np

from plunge import tankTables
from plunge.results import running_mean
from plunge.studies.pictures import pyplot
from plunge.studies.scenes import solveScene
from plunge.studies.signals import Signal, rms
from plunge.studies.study import Done, Quantity, Run, Study

SHARE = 1/50    # of the time: window of the mean


def entries(**of: object) -> list[str]:
    return [word for name, value in of.items() for word in ("-set", f"{name.replace('__', '.')}={value}")]


FULL, HALF = ("full model", ("-model", "full")), ("half model", ("-model", "half"))
TENSION, NO_TENSION = ("surface tension", ("-surfaceTension", "on")), ("no surface tension", ("-surfaceTension", "off"))
NO_LAYER, RESOLVED = ("no boundary layer", ("-boundaryLayer", "none")), ("wall functions", ("-boundaryLayer", "wallFunction"))
STANDING, SINGLE = ("background that stands", ("-mesh", "overset")), ("single mesh", ("-mesh", "single"))
SPHERE = entries(body__shape="{ type sphere; radius 0.0025; }", body__mass=2e-4, entry="{ speed 1; gap 1e-3; }", duration=0.015)
# Name, case, resolution, options of the scene, what is overruled
SCENES = (
    ("dive, Titan", "gannetPlunge", "fast 0.5", entries(frames=1), (TENSION, FULL, NO_LAYER, RESOLVED, STANDING, SINGLE)),
    ("dive, water", "gannetPlunge", "fast 0.5", [*entries(frames=1), "-fluids", "water"], (TENSION, NO_LAYER)),
    ("dive at 1 m/s", "gannetPlunge", "fast 0.5", entries(frames=1, entry__speed=1, travel=0.6), (NO_TENSION, NO_LAYER)),
    ("dive along the vertical", "gannetPlunge", "fast 0.5", entries(frames=1, entry__angle=90, body__freedom="axial", travel=0.6), (HALF,)),
    ("cone of 45 degrees", "fallingCone", "fast 0.5", [], (HALF, NO_TENSION, NO_LAYER)),
    ("cone of 25 degrees, 20 m/s", "fallingCone", "fast 0.5", entries(body__shape__halfAngle=25, entry="{ speed 20; gap 1e-3; }", duration=0.006), (TENSION, NO_LAYER)),
    ("sphere of 5 mm at 1 m/s", "fallingCone", "fast", SPHERE, (NO_TENSION, NO_LAYER)),
    ("cylinder", "fallingCylinder", "fast 0.5", [], (NO_TENSION, NO_LAYER)),
    ("column of water", "damBreak", "fast", entries(duration=0.6), (FULL, NO_TENSION)),
    ("column of 3 cm", "damBreak", "fast", entries(tank="{ size (0.06 0.015 0.06); walls noSlip; }", liquid="{ column { max (0.015 0.015 0.03); } }", maxSpeed=1.1,
                                                   gauges="{ H1 (0.0075 0.0075 0); H2 (0.045 0.0075 0); }", probes="{ P1 (0.06 0.0075 0.002); }", duration=0.19),
     (NO_TENSION,)),
)
QUICK = ("cone of 45 degrees",)


def runs() -> list[Run]:
    found = []
    for name, scene, resolution, options, overruled in SCENES:
        for what, more in ((None, ()), *overruled):
            tiers = ("full", "quick") if name in QUICK and what in (None, NO_TENSION[0]) else ("full",)
            found.append(Run(scene, "meshes", name if what is None else f"{name}: {what}", resolution, tiers, given={"options": [*options, *more]}))
    return found


def answer(done: Done) -> Signal:
    if done.run.scene == "damBreak":
        of = tankTables.tables(done.path)["gauges"]
        return Signal(of["time_s"], of[next(name for name in of if name.startswith("H2"))])
    of = done.track
    return Signal(of["time_s"], running_mean(of["time_s"], of["deceleration_m_s2"], SHARE*of["time_s"][-1]))


def decided(done: Done) -> Done | None:
    return done.beside(variant=done.run.variant.split(":")[0]) if ":" in done.run.variant else None


def off(done: Done) -> float | None:
    other = decided(done)
    if other is None:
        return None
    theirs = answer(other)
    return float(100*rms(answer(done).less(theirs.during(theirs.time[0] + 2*SHARE*theirs.time[-1], theirs.time[-1])))/np.abs(theirs.value).max())


def cost(done: Done) -> float | None:
    other = decided(done)
    return done.cpu/other.cpu if other and other.cpu else None


def draw(done, file) -> None:
    shown = [(each.run.variant, off(each), cost(each)) for each in done if decided(each)]
    picture, axes = pyplot.subplots(1, 2, figsize=(11, 0.32*len(shown) + 1.2), layout="constrained", sharey=True)
    for axis, values, label in ((axes[0], [x for _, x, _ in shown], "difference of the answer [%]"), (axes[1], [x for *_, x in shown], "CPU time over that as decided")):
        axis.barh(range(len(shown)), values, color="C0")
        axis.set(xlabel=label, xscale="log", yticks=range(len(shown)), yticklabels=[name for name, *_ in shown])
        axis.grid(axis="x", alpha=0.3)
    axes[1].axvline(1, color="0.3")
    axes[0].invert_yaxis()
    picture.savefig(file, dpi=90)
    pyplot.close(picture)


study = Study(
    title="Only what a scene requires: what the decisions of plungeCase save, and what they cost", runs=runs(), solve=solveScene,
    sources=("src/freeSurfaceFlow", "src/oversetMethods", "src/rigidBody", "applications/solvers/plungeFoam", "applications/utilities/plunge/decisions.py"),
    quantities=[Quantity("difference of the answer, rms over its largest value", "%", off), Quantity("CPU time over that as decided", "1", cost)],
    headlines=["difference of the answer, rms over its largest value"], figure=draw)
