# SPDX-License-Identifier: GPL-3.0-or-later
"""A cone of 75 degrees and a hemisphere that enter water at 4 m/s, axisymmetric, against the records of the IMpack impactor (references/IMpack).

Its mass is not published, so ratios are compared. Computed bodies keep their speed; the measured ones lose some, which the records themselves
give: their forces are compared over the square of the speed. Forces as means of 0.05 ms, the sensor's interval. Judged: within 10 %."""
import numpy as np

from plunge.results import crossing
from plunge.studies import REPOSITORY
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.scenes import prepare, solve
from plunge.studies.signals import Signal
from plunge.studies.study import Quantity, Run, Study, only

SPEED, RADIUS, GRAVITY, INTERVAL, LATE = 4, 0.022225, 9.80665, 0.05e-3, 10e-3   # LATE: when the cone's cavity stands [s]
TABLE = reference("IMpack", "entry4")
FOLDER = REPOSITORY / "validation/studies/bluntNose"


def measured(nose: str) -> Signal:
    """Force over mass and the square of the speed, over that at its largest speed [m/s2]."""
    of = TABLE[TABLE["nose"] == nose]
    time, acceleration = 1e-3*of["t_ms"], GRAVITY*of["a_mean_g"]
    lost = np.concatenate(([0], np.cumsum(np.diff(time)*(0.5*(acceleration[1:] + acceleration[:-1]) - GRAVITY))))
    lost -= np.interp(0, time, lost)
    return Signal(time, acceleration*(SPEED/(SPEED - lost))**2)


def computed(done) -> Signal:
    """Force [N]."""
    of = done.track
    contact = crossing(of["time_s"], of["penetration_m"])
    return Signal(of["time_s"][1:] - contact, (of["Fpz_N"] + of["Fvz_N"])[1:]).mean(INTERVAL)


PEAK = {nose: float(measured(nose).value.max()) for nose in ("cone", "hemisphere")}


def peak(done) -> float:
    return float(computed(done).value.max())


def ratio(done) -> float:
    other = done.beside(variant="hemisphere")
    return peak(done)/peak(other) if other else float("nan")


def of(nose: str, quantity):
    return only(quantity, lambda run: run.variant == nose)


study = Study(
    title="Blunt noses meet water with the measured ratios of forces",
    runs=[Run("bluntNose", "meshes", nose, level, ("full", level)) for level in ("fast", "fast 1.4", "fast 2") for nose in PEAK]
    + [Run("bluntNose", "meshes", nose, "fast 0.5", ("quick",)) for nose in PEAK],
    solve=lambda run, path: (prepare(run, path, scene=FOLDER / run.variant), solve(path)),
    sources=("src/freeSurfaceFlow", "src/rigidBody", "applications/solvers/plungeFoam", "validation/studies/bluntNose"),
    quantities=[
        Quantity("peak of the cone over that of the hemisphere", "1", of("cone", ratio), PEAK["cone"]/PEAK["hemisphere"],
                 tolerance=0.1*PEAK["cone"]/PEAK["hemisphere"], converges=True),
        Quantity("peak of the cone over its value at 10 ms", "1", of("cone", lambda done: peak(done)/float(computed(done).at(LATE))),
                 PEAK["cone"]/float(measured("cone").at(LATE)), tolerance=0.1*PEAK["cone"]/float(measured("cone").at(LATE)), converges=True),
        Quantity("U t/R at the hemisphere's peak", "1", of("hemisphere", lambda done: SPEED/RADIUS*float(computed(done).time[computed(done).value.argmax()])),
                 0.1248, tolerance=0.0125, converges=True),
        Quantity("peak of 2 F/(rho pi R^2 U^2)", "1", lambda done: peak(done)/(0.5*998*np.pi*RADIUS**2*SPEED**2), converges=True)],
    headlines=["peak of the cone over that of the hemisphere"],
    figure=lambda done, file: draw(file, [({"title": nose, "xlabel": "U t/R", "ylabel": "force over its peak", "xlim": (0, 1)}, {"measured": Signal(
        measured(nose).time*SPEED/RADIUS, measured(nose).value/PEAK[nose])}, {each.run.resolution: Signal(
            computed(each).time*SPEED/RADIUS, computed(each).value/peak(each)) for each in done if each.run.variant == nose}) for nose in PEAK], 2))
