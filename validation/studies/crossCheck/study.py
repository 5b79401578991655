# SPDX-License-Identifier: GPL-3.0-or-later
"""The same scenes on meshes and with particles, a verdict each: largest load and speed lost of the finest particles over those of the finest mesh.

Particles slip over bodies, so these have no boundary layer on meshes either. Loads are the liquid's force over the body's mass: in the dives,
which are fast, the deceleration; of cone and cylinder deceleration and gravity. They are running means over the same time in all runs of a scene:
the one in which the body moves by one spacing of the tier fast (dives) or of the finest particles (cylinder), for particles resolve nothing that is
shorter, but a weakly compressible liquid rings; of the cones the interval in which the trials' accelerometer was read. Speed lost is that at
contact, with what gravity has added to cone and cylinder since, less that at full immersion, or at the end of a run that ends before.

peakRatio within 10 % and speedLostRatio within 5 % of 1. Each is as unsure as the grid convergence indices of both, by three resolutions of each,
together. The peaks of the cones are also there over those of the trials; coneEntry judges these. One more series of the vertical dive has
tanks of other half widths [m]. The tier `night` has its finest particles; `tanks` has dam breaks on fixed obstacles, by the pressure at the obstacle or the force on it as means over
the finest spacing's time; `fluids` has the dives with friction and into water, `memory` the first steps of a million particles, which tell what
memory they need."""
import re
import subprocess
from functools import lru_cache
from pathlib import Path

import numpy as np

from plunge.results import TRAJECTORY_COLUMNS, particle_counts, read_numbers, read_table, solver_log
from plunge.studies.gridConvergence import levels
from plunge.studies.memory import peakMemory
from plunge.studies.particleRuns import CONTROL, PROPERTIES
from plunge.studies.pictures import draw
from plunge.studies.scenes import prepare, solveScene
from plunge.studies.signals import Signal, rms
from plunge.studies.study import Done, Quantity, Run, Study, module, only
from plunge.tankTables import tables

CONES = module("coneEntry")
DIVE, CONE, CYLINDER, KLEEFSMAN, BORE = "gannetPlunge", "fallingCone", "fallingCylinder", "kleefsman", "yehPetroff"
VERTICAL, SLANTED = "vertical, titan, boundary layer none", "titan, boundary layer none"
MILLION, TANK = "first steps", "vertical, titan, half width"
SPACING = 0.0145                            # of the dives' particles at the tier fast [m]
# Time of running means [s]: of the cylinder its finest spacing over its speed, of the dam breaks theirs over the flow's
WINDOWS = {DIVE: SPACING/25, CONE: CONES.INTERVAL, CYLINDER: 0.0049/2.955, KLEEFSMAN: 0.0275/4.6, BORE: 0.015/3.4}
WEIGHT = {DIVE: 0.0, CONE: 9.81, CYLINDER: 9.81}    # gravity, where it is added to the deceleration [m/s2]


def solve(run: Run, path: Path) -> None:
    if run.variant != MILLION:
        return solveScene(run, path)
    prepare(run, path, changes={CONTROL: "endTime 5e-5; writeInterval 5e-5;"})
    subprocess.run(["plungeBodySurface", "-case", path], check=True)
    peakMemory(path, "plungeSPH", "-threads", "2")


def summary(done: Done) -> dict:
    return {name: value for name, (value, _) in read_numbers(done.path / "results/summary.csv").items()}


def memory(done: Done) -> dict:
    particles, log = sum(particle_counts(done.path)), solver_log(done.path)
    peak = 1024*float((done.path / "log.memory").read_text().split()[0])
    return {"particles with walls and body": particles, "peak memory": peak/2**30, "peak memory per particle": peak/particles,
            "computation's memory per particle": float(re.search(r"^Computation: .*, (\S+) MiB", log, re.M)[1])*2**20/particles}


@lru_cache(maxsize=None)
def asComputed(done: Done) -> Signal:
    """Load over time from contact: of bodies over their mass, of the box the pressure at P1, of the column the force."""
    if done.run.scene in (KLEEFSMAN, BORE):
        table, column = ("probes", "P1_p_Pa") if done.run.scene == KLEEFSMAN else ("walls", "column_Fx_N")
        found = tables(done.path)[table]
        return Signal(found["time_s"], found[column])
    table = read_table(done.path / "results/trajectory.csv", TRAJECTORY_COLUMNS)
    return Signal(table["time_s"] - summary(done)["contact time"], table["deceleration_m_s2"] + WEIGHT[done.run.scene])


@lru_cache(maxsize=None)
def load(done: Done) -> Signal:
    return asComputed(done).mean(WINDOWS[done.run.scene]).during(0, np.inf)


def peakLoad(done: Done) -> float:
    return float(load(done).value.max())


def speedLost(done: Done) -> "float | None":
    if done.run.scene == DIVE:
        return summary(done)["velocity lost at full immersion"]
    if done.run.scene not in WEIGHT:
        return None
    table, numbers = read_table(done.path / "results/trajectory.csv", TRAJECTORY_COLUMNS), summary(done)
    contact, immersed = numbers["contact time"], numbers["full immersion time"]
    end = immersed if np.isfinite(immersed) else table["time_s"][-1]
    before, after = np.interp((contact, end), table["time_s"], table["speed_m_s"])
    return float(before + WEIGHT[done.run.scene]*(end - contact) - after)


def series(done: Done, method: str) -> list[Done]:
    """By that method the runs of the same scene, from the finest."""
    return sorted((each for each in done.others.values() if each.run.key[0::2][:2] == done.run.key[0::2][:2] and each.run.method == method),
                  key=lambda each: each.run.size)


def over(value):
    """That of particles over the finest mesh's."""
    def of(done: Done) -> "float | None":
        meshes = series(done, "meshes") if done.run.method == "particles" else []
        ours = value(done) if meshes else None
        return None if ours is None else ours/value(meshes[0])
    return of


def unsure(value):
    """What of it the mesh's grid convergence index makes unsure."""
    def of(done: Done) -> "float | None":
        meshes, ratio = series(done, "meshes"), over(value)(done)
        if ratio is None or len(meshes) < 3:
            return None
        values = [value(each) for each in meshes]
        index = levels([each.run.size for each in meshes], values, *study.orders)[0]
        return None if index is None else abs(ratio*index/values[0])
    return of


def overTrials(done: Done) -> "float | None":
    if done.run.scene != CONE:
        return None
    trial = CONES.TRIALS[CONES.trial(done.run)]
    return peakLoad(done)*2*trial["mass_kg"]/(CONES.RHO*np.pi*CONES.RADIUS**2*trial["U0_m_s"]**2)/trial["Cpeak_mean"]


def dive(name: str):
    """A figure of the dives' summaries, or of their loads."""
    def of(done: Done) -> "float | None":
        if done.run.scene != DIVE or done.run.variant == MILLION or done.run.variant.startswith(TANK):
            return None
        if name == "time from contact to peak, running mean":
            return float(load(done).time[load(done).value.argmax()])
        if name == "deceleration, rms about its mean":
            raw, end = asComputed(done), summary(done)["full immersion time"] - summary(done)["contact time"]
            return rms(Signal(raw.time, raw.value - raw.mean(WINDOWS[DIVE]).value).during(0, end).value)
        return summary(done).get(name)
    return of


def tank(width: float) -> str:
    """Entries of another half width [m] of the rings' tank at the tier fast."""
    wide, deep, top = (round(length/SPACING)*SPACING for length in (width, 1.479, 0.1015))
    box = f"min (0 {-deep!r} 0); max ({wide!r}"
    return (f"absorption {{ {box} 0 0); }} geometry {{ fluid ({{ type box; {box} 0 0); hydrostatic no; }}); walls ({{ name tank; type box; "
            f"{box} {top!r} 0); open (left top); }} {{ name body; type surface; file \"constant/triSurface/body.stl\"; }}); }}")


def finest(run: Run) -> bool:
    """Of the runs alike in the tier?"""
    return run.size == min(each.size for each in study.runs if each.key[:3] == run.key[:3] and each.tiers == run.tiers)


def both(scene: str, variant: str, options: list[str], meshes: tuple[str, ...], particles: tuple[str, ...], *tiers: str) -> list[Run]:
    """A scene on meshes and with particles, at three resolutions."""
    return [Run(scene, method, variant, resolution, tiers or ("full",), given={"options": options})
            for method, of in (("meshes", meshes), ("particles", particles)) for resolution in of]


def picture(done, file: Path) -> None:
    scenes = {each.run.key[0::2][:2]: each for each in done if over(peakLoad)(each) and each.run.size == series(each, "particles")[0].run.size}
    panels = []
    for (scene, variant), ours in scenes.items():
        shown = [*series(ours, "meshes")[:1], *series(ours, "particles")]
        end = max(each.time[-1] for each in map(load, shown))
        panels.append(({"title": ", ".join(filter(None, (scene, variant))), "xlabel": "time from contact [ms]" if scene in WEIGHT else "time [ms]",
                        "ylabel": {KLEEFSMAN: "pressure at P1 [Pa]", BORE: "force on the column [N]"}.get(scene, "load over mass [m/s2]"), "xlim": (0, 1e3*end)},
                       {}, {f"{each.run.method}, {each.run.resolution}": Signal(1e3*load(each).time, load(each).value) for each in shown}))
    draw(file, panels, 2)


UNITS = {"velocity lost at full immersion": "m/s", "peak deceleration": "m/s2", "time from contact to peak, running mean": "s",
         "deceleration, rms about its mean": "m/s2", "full immersion time": "s", "pitch change at full immersion": "deg"}
MEMORY = {"particles with walls and body": "1", "computation's memory per particle": "byte", "peak memory": "GiB", "peak memory per particle": "byte"}
DOWN = ["-set", "entry.angle=90", "-set", "body.freedom=axial", "-set", "frames=2", "-boundaryLayer", "none"]
RATIOS = {"peakRatio": (peakLoad, 0.1), "speedLostRatio": (speedLost, 0.05)}
study = Study(
    title="Particles and meshes give the same load and the same loss of speed",
    runs=[*(Run(DIVE, method, VERTICAL, "fast 0.7", ("quick",), given={"options": DOWN}) for method in ("meshes", "particles")),
          *both(DIVE, VERTICAL, DOWN, ("fast", "fast 1.4", "fast 2"), ("fast", "fast 1.4", "fast 2"), "full", "night"),
          Run(DIVE, "particles", VERTICAL, "fast 4", ("night",), given={"options": DOWN}),
          *(Run(DIVE, "particles", f"{TANK} {width:g} m", "fast", given={"options": DOWN, "changes": {PROPERTIES: tank(width)}})
            for width in (0.35, 0.7, 1.05, 2.1)),
          *(run for angle, drop in ((45, 0.5), (25, 1)) for run in both(
              CONE, f"{angle} deg {drop:g} m boundary layer none", [*CONES.scene(f"{angle} deg {drop:g} m"), "-boundaryLayer", "none", "-set", "frames=2"],
              ("fast", "fast 1.4", "fast 2"), ("fast 1.4", "fast 2", "fast 2.8"))),
          *both(CYLINDER, "boundary layer none", ["-set", "duration=0.06", "-boundaryLayer", "none", "-set", "frames=2"],
                ("fast 0.5", "fast 0.7", "fast"), ("fast 0.35", "fast 0.5", "fast 0.7")),
          *both(DIVE, SLANTED, ["-boundaryLayer", "none", "-set", "frames=2"], ("fast 0.5", "fast 0.7", "fast"), ("fast 0.5", "fast 0.6", "fast 0.7")),
          *both(KLEEFSMAN, "", [], ("fast", "fast 1.4", "fast 2"), ("fast 0.5", "fast 0.7", "fast"), "tanks"),
          *both(BORE, "", [], ("fast", "fast 1.4", "fast 2"), ("fast 0.5", "fast 0.7", "fast"), "tanks"),
          *(Run(DIVE, "meshes", f"{fluids}, boundary layer {layer}", "fast", ("fluids",), given={
              "options": ["-fluids", fluids, "-boundaryLayer", layer]}) for fluids, layer in (("titan", "auto"), ("water", "auto"), ("water", "none"))),
          Run(DIVE, "particles", MILLION, "fine", ("memory",), cores=2)],
    solve=solve, sources=("src/freeSurfaceFlow", "src/oversetMethods", "src/rigidBody", "src/smoothedParticles", "applications/solvers"),
    quantities=[
        *(Quantity(name, unit, only(peakLoad, lambda run, of=scenes: run.scene in of and run.variant != MILLION), converges=True) for name, unit, scenes in (
            ("peakLoad", "m/s2", WEIGHT), ("peakPressure", "Pa", (KLEEFSMAN,)), ("peakForce", "N", (BORE,)))),
        Quantity("speedLost", "m/s", only(speedLost, lambda run: run.variant != MILLION), converges=True),
        *(Quantity(name, "1", over(value), 1, tolerance=allowed, judged=finest, converges=True, unsure=unsure(value))
          for name, (value, allowed) in RATIOS.items()),
        Quantity("peak over that of the trials", "1", overTrials),
        *(Quantity(name, unit, dive(name)) for name, unit in UNITS.items()),
        *(Quantity(name, unit, only(lambda done, n=name: memory(done)[n], lambda run: run.variant == MILLION)) for name, unit in MEMORY.items())],
    headlines=list(RATIOS), figure=picture)
