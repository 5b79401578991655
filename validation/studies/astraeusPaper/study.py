# SPDX-License-Identifier: GPL-3.0-or-later
"""The dive of IAC-20-E2.1.9 by its own formulation, and what becomes of its claims with other choices and on the mesh.

cases/astraeusPaper: eqs. 2 to 6 and 8, 500 neighbours, Q1 = 0.1, springs of contact, a closed tank; neither the paper's tank nor its spacing is known, here
1 m, the depth of its k0, and 50 mm, 8,000 particles in the whole tank, for its licence had 10,000 nodes; finer ones say what that does. Variants change one choice each; "absorbing" has a
boundary that lets sound leave, the twin that tells what is reflected. Accelerations are means of 0.5 ms. Judged is what physics asks for: decelerations of
one body in two liquids whose forces go with their densities, single as double. damBreak stands for the paper's rig, in the plane, at equal Froude
number: times go with g^-1/2, forces with rho g, and their history over time is the same, to 5 %."""
import math
import re
from pathlib import Path

import numpy as np

from plunge.results import fluid_force, parameters
from plunge.studies.particleRuns import PROPERTIES, table
from plunge.studies.pictures import draw
from plunge.studies.scenes import prepare, solve
from plunge.studies.signals import Signal, rms
from plunge.studies.study import Done, Quantity, Run, Study

CASE, SPACING, FINER, END = "astraeusPaper", 0.05, (0.035, 0.025), 0.01    # [m], [s]
WINDOW, APART, ARRIVED = 5e-4, 0.1, 0.02    # [s], of the largest deceleration, of that
DENSITIES, NEAREST = {"titan": 664.0, "water": 998.207}, 0.5    # [kg/m3]; from the point of contact to the tank's sides [m]
RIG, GRAVITY = "damBreak", {"titan": 1.35, "water": 9.81}     # [m/s2]
SLOWER = {"water": 1.0, "titan": math.sqrt(GRAVITY["water"]/GRAVITY["titan"])}
TWINS = {**{f"titan, {how}": "titan, as in the paper" for how in ("double precision", "eq. 1", "eq. 7")},
         "titan, as in the paper": "titan, absorbing", "titan, eq. 5": "titan, eq. 5, absorbing"}
ABSORBING = "absorption { min (-0.5 0 -1); max (0.5 0.5 0); thickness 0.15; surface 0; faces (left right back bottom); }"
SOFT = "#remove speedOfSound\nspeedOfSound { c0 %s; }\nCourant 0.5;"


def dives(variant: str, changes: str = "", liquids: tuple[str, ...] = ("titan", "water"), spacing: float = SPACING, tiers: tuple[str, ...] = ("full",),
          options: tuple[str, ...] = ()) -> list[Run]:
    return [Run(CASE, "particles", f"{liquid}, {variant}", f"{spacing:g} m", tiers, given={"options": ["-fluids", liquid, *options],
            "changes": {PROPERTIES: f"geometry {{ spacing {spacing:g}; }}\n{changes}"}}) for liquid in liquids]


def solveDive(run: Run, path: Path) -> None:
    prepare(run, path)
    solve(path)


RUNS = [
    *dives("as in the paper", tiers=("quick", "full")), *(run for spacing in FINER for run in dives("as in the paper", spacing=spacing)),
    *dives("double precision", "precision double;", ("titan",)), *dives("eq. 1", "momentum solid;", ("titan",)),
    *dives("eq. 7", "contact { stiffness segment; factor 0.1; bulkModulus 1e9; thickness 0.05; }", ("titan",)),
    *dives("absorbing", ABSORBING, ("titan",)),
    *dives("eq. 5", SOFT % 250), *dives("eq. 5, absorbing", SOFT % 250 + "\n" + ABSORBING, ("titan",)),
    *dives("real sound", SOFT % 1983, ("titan",), options=("-set", "duration=0.005")),
    *(Run(RIG, "particles", liquid, "fast 0.5", given={"options": ["-fluids", liquid, "-set", f"duration={0.8*slower:.8g}", "-set", f"maxSpeed={3.4/slower:.8g}",
                                                                    "-set", f"interval={0.002*slower:.8g}"]}) for liquid, slower in SLOWER.items()),
    *(Run(CASE, "meshes", f"{liquid}, mesh", "fast 0.5", given={"options": ["-fluids", liquid]}) for liquid in DENSITIES)]


def deceleration(done: Done, window: float = WINDOW) -> Signal:
    of = done.track
    return Signal(of["time_s"][1:], of["deceleration_m_s2"][1:]).mean(window)


def across(done: Done) -> Signal:
    """Acceleration along the dorsal axis, less its straight line."""
    of = done.track
    time = np.linspace(of["time_s"][1], of["time_s"][-1], 2001)
    value = np.interp(time, of["time_s"][1:], of["a3_m_s2"][1:])
    return Signal(time, value - np.polyval(np.polyfit(time, value, 1), time))


def frequency(done: Done) -> float:
    """Of the largest oscillation across the axis of which the record has two periods."""
    signal = across(done)
    size = 1 << 17
    spectrum = np.abs(np.fft.rfft(signal.value*np.hanning(len(signal.value)), size))
    of = np.fft.rfftfreq(size, signal.time[1] - signal.time[0])
    seen = of >= 2/(signal.time[-1] - signal.time[0])
    return float(of[seen][spectrum[seen].argmax()])


def in_water(done: Done) -> Done | None:
    """The same in water, of a dive into Titan's liquid."""
    return done.beside(variant=done.run.variant.replace("titan", "water")) if done.run.variant.startswith("titan") else None


def with_water(value):
    return of_dive(lambda done: value(done, in_water(done)) if in_water(done) else None)


def apart(done: Done, water: Done) -> float:
    """When decelerations begin to differ [ms]."""
    a, b = deceleration(done), deceleration(water)
    far = np.abs(b.at(a.time) - a.value) > APART*max(a.value.max(), b.value.max())
    return 1e3*float(a.time[far.argmax()]) if far.any() else math.nan


def impulse(done: Done, end: float = END) -> float:
    """Of the fluids on the body until then, over its mass: gravity has no part in it [m/s]."""
    of = done.track
    during = of["time_s"][1:] <= end
    total = (fluid_force(of)[:, 1:]*np.diff(of["time_s"])*during).sum(axis=1)
    return float(np.linalg.norm(total))/float(parameters(done.path)["bodyMass"])


def of_twin(value):
    """A figure of a run that has a twin and of that."""
    def of(done: Done):
        twin = done.beside(variant=TWINS.get(done.run.variant, ""))
        return value(done, twin) if twin else None
    return of


def difference(done: Done, twin: Done) -> float:
    """Of the decelerations, largest, over the twin's largest [%]."""
    a, b = deceleration(done), deceleration(twin)
    return 100*float(np.nanmax(np.abs(b.at(a.time) - a.value)))/float(b.value.max())


def reflected(done: Done, absorbing: Done) -> float | None:
    """When the deceleration begins to differ from that in a tank that absorbs [ms], if it does."""
    a, b = deceleration(done), deceleration(absorbing)
    far = np.abs(b.at(a.time) - a.value) > ARRIVED*b.value.max()
    return 1e3*float(a.time[far.argmax()]) if far.any() else None


def wall(done: Done) -> Signal:
    """Force along the tank on its walls, mean of a fiftieth of its peak's time in water [N/m]."""
    of = table(done.path, "walls")
    return Signal(of["time_s"], of["tank_Fx_N_m"]).mean(0.01*SLOWER[done.run.variant])


def at_peak(done: Done) -> tuple[float, float, float]:
    """Time and force of the peak at the end wall, and that force over the mean of what follows, as long as until then."""
    force = wall(done)
    # The reservoir's thrust on the wall behind it comes first, and the other way
    i = int(force.value.argmax())
    after = force.during(force.time[i], 2*force.time[i])
    return float(force.time[i]), float(force.value[i]), float(force.value[i]/after.value.mean())


def of_rig(i: int):
    def of(done: Done):
        return at_peak(done)[i]/at_peak(done.beside(variant="water"))[i] if done.run.scene == RIG and done.run.variant == "titan" else None
    return of


def of_dive(value):
    return lambda done: value(done) if done.run.scene == CASE else None


def said(of: str):
    """A number that the log of plungeSPH says."""
    def found(done: Done):
        return float(re.search(of, (done.path/"log.plungeSPH").read_text())[1]) if done.run.method == "particles" and done.run.scene == CASE else None
    return found


def mesh(done: Done) -> Done | None:
    return next((each for each in done.others.values() if each.run.variant == f"{done.run.variant.split(',')[0]}, mesh"), None)


def over_mesh(value):
    return lambda done: value(done)/value(mesh(done)) if done.run.scene == CASE and done.run.method == "particles" and mesh(done) else None


def figure(done: list[Done], file: Path) -> None:
    curves = {each.run.variant: deceleration(each) for each in done if each.run.scene == CASE and each.run.resolution in (f"{SPACING:g} m", "fast 0.5")}
    draw(file, [({"title": title, "xlabel": "time [s]", "ylabel": "deceleration [m/s2]"}, {}, {name: curves[name] for name in names if name in curves})
                for title, names in (
                    ("the paper's formulation, and the mesh", [f"{liquid}, {how}" for how in ("as in the paper", "mesh") for liquid in DENSITIES]),
                    ("c0 of ten times the speed", ["titan, eq. 5", "water, eq. 5", "titan, eq. 5, absorbing", "titan, mesh"]),
                    ("one choice changed", ["titan, as in the paper", *(f"titan, {how}" for how in ("double precision", "eq. 1", "eq. 7"))]),
                    ("sound", ["titan, as in the paper", "titan, eq. 5", "titan, real sound", "titan, mesh"]))], 2)


LOST = "velocity lost at 10 ms"
study = Study(
    title="The paper's dive by its own formulation: what is physics and what is method",
    runs=RUNS, solve=solveDive, sources=("src/smoothedParticles", "src/freeSurfaceFlow", "applications/solvers"),
    quantities=[
        Quantity("k0", "Pa", said(r"k0 = rho c0\^2/gamma = (\S+) Pa")),
        Quantity("permitted v_max, c0/10", "m/s", said(r"a tenth of c0 is (\S+) m/s")),
        Quantity("Mach number of the impact", "1", said(r"Mach number: (\S+),"), most=0.1),
        Quantity("time step", "ms", of_dive(lambda done: 1e3*float(np.median(np.diff(done.track["time_s"]))))),
        Quantity("peak deceleration, mean of 0.5 ms", "m/s2", of_dive(lambda done: float(deceleration(done).value.max()))),
        Quantity("impulse per mass to the end", "m/s", of_dive(impulse)),
        Quantity("impulse over the mesh's", "1", over_mesh(lambda done: impulse(done, 0.005)), 1, tolerance=0.1),
        Quantity("time at which water and Titan's liquid differ by a tenth of the peak", "ms", with_water(apart)),
        Quantity("impulse in water over that in Titan's liquid", "1", with_water(lambda done, water: impulse(water)/impulse(done)),
                 DENSITIES["water"]/DENSITIES["titan"], tolerance=0.1*DENSITIES["water"]/DENSITIES["titan"]),
        Quantity("frequency of the largest oscillation across the axis", "Hz", of_dive(frequency)),
        Quantity("oscillation across the axis, rms over the peak deceleration", "%",
                 of_dive(lambda done: 100*rms(across(done).value)/float(deceleration(done).value.max()))),
        Quantity("difference of the decelerations, largest, over the twin's peak", "%", of_twin(difference), 0, tolerance=1,
                 judged=lambda run: "double" in run.variant),
        Quantity("time of the reflected wave", "ms", of_twin(lambda done, twin: reflected(done, twin) if "absorbing" in twin.run.variant else None)),
        Quantity("way of sound to the nearest wall and back, over c0", "ms", lambda done: (c0 := said(r"c0 = (\S+) m/s, k0")(done)) and 1e3*2*NEAREST/c0),
        *(Quantity(name, "1", of_rig(i), reference, tolerance=0.05*reference) for i, (name, reference) in enumerate((
            ("time of the wall force's peak, over that in water", SLOWER["titan"]),
            ("peak of the wall force, over that in water", DENSITIES["titan"]*GRAVITY["titan"]/(1000*GRAVITY["water"])),
            ("sharpness of the wall force's peak, over that in water", 1.0))))],
    headlines=["impulse over the mesh's", "impulse in water over that in Titan's liquid"], figure=figure)
