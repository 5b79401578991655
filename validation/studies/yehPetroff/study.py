# SPDX-License-Identifier: GPL-3.0-or-later
"""The force of a bore on a column against Yeh and Petroff, whose records are two digitisations.

When the gate opened is not known. So time is shifted for the computed force, mean of 10 ms, to pass 5 N first when the measured one does;
the velocity counts from the arrival of the bore, when half its highest speed is there. The peak is the highest mean of 50 ms, within 20 %;
the plateau the mean of 0.55 to 0.75 s and the impulse that of 0.33 to 1.30 s, within 10 %, as the digitisations differ. Not judged: the
noise, which is what a mean of 20 ms takes away while the force is steady; and the twins on walls that slip."""
import numpy as np

from plunge.results import gather
from plunge.studies.foamFields import numbers
from plunge.studies.meshTwins import column
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.scenes import solveScene, spacings
from plunge.studies.signals import Signal, rms
from plunge.studies.study import Quantity, Run, Study

PLATEAU, IMPULSE, SLIP = (0.55, 0.75), (0.33, 1.30), "walls slip"
MEASURED = {}
for name, table in (("force", reference("YehPetroff", "force")), ("velocity", reference("YehPetroff", "velocity"))):
    # In order of time, and where there are several points at a time their mean
    at, index = np.unique(table["time_s"], return_inverse=True)
    MEASURED[name] = Signal(at, np.bincount(index, table[table.dtype.names[1]])/np.bincount(index))


def force(done) -> Signal:
    if done.run.method == "particles":
        table = gather(done.path)["walls"]
        found = Signal(table["time_s"], table["column_Fx_N"])
    else:
        found = Signal(*numbers(done.path / "postProcessing/force/0/force.dat")[:, :2].T)
    return found.later(MEASURED["force"].mean(0.01).rise(5) - found.mean(0.01).rise(5))


def velocity(done) -> Signal:
    if done.run.method == "particles":
        table = gather(done.path)["probes"]
        found = Signal(table["time_s"], table["upstream_Ux_m_s"])
    else:
        found = Signal(*numbers(done.path / "postProcessing/upstream/0/U")[:, :2].T)
    return found.later(-found.rise(0.5*found.value.max()))


def plateau(signal: Signal) -> float:
    steady = signal.during(*PLATEAU)
    return steady.integral()/float(np.ptp(steady.time))


FORCE = {"peak of the force, mean of 50 ms": ("N", lambda s: float(s.mean(0.05).value.max()), 33.0, 0.2),
         "force on the plateau": ("N", plateau, 17.8, 0.1), "impulse": ("N s", lambda s: s.during(*IMPULSE).integral(), 12.57, 0.1)}
study = Study(
    title="A bore has the measured force on a column",
    runs=[*spacings("yehPetroff", {spacing: ("full",) for spacing in (0.02, 0.015, 0.01, 0.0075)}), Run("yehPetroff", "meshes", SLIP, "0.02 m"),
          # Without the layer on the floor, which has no coarser particles
          *spacings("yehPetroff", {0.04: ("quick",)}, {"constant/particleProperties": "geometry { fluid ({ type box; min (0 0 0); "
                                                       "max (0.4 0.61 0.3); hydrostatic yes; }); }"}, "dry floor"),
          *spacings("yehPetroff", {0.015: ("full",)}, {"constant/particleProperties": "walls slip;"}, SLIP)],
    solve=lambda run, path: solveScene(run, path) if run.method == "particles" else column(path, run.size),
    sources=("src/smoothedParticles", "applications/solvers/plungeSPH"),
    quantities=[
        *(Quantity(name, unit, lambda done, of=of: of(force(done)), value, tolerance=share*value, judged=lambda run: not run.variant, converges=True)
          for name, (unit, of, value, share) in FORCE.items()),
        Quantity("velocity upstream less measured, mean of 0.05 to 0.5 s after arrival", "m/s", lambda done: float(
            velocity(done).mean(0.01).less(MEASURED["velocity"].during(0.05, 0.5)).mean())),
        Quantity("noise of the force on the plateau, rms of periods below 20 ms", "N", lambda done: rms(
            Signal(force(done).time, force(done).value - force(done).mean(0.02).value).during(*PLATEAU).value))],
    headlines=[*FORCE],
    figure=lambda done, file: draw(file, [
        ({"xlabel": "time, aligned on the rise through 5 N [s]", "ylabel": "force on the column [N]", "xlim": (0, 1.5), "ylim": (-10, 60)},
         {"Yeh and Petroff": MEASURED["force"]}, {each.run.name: force(each).mean(0.01) for each in done}),
        ({"xlabel": "time from the arrival of the bore [s]", "ylabel": "velocity upstream [m/s]", "xlim": (0, 1.5), "ylim": (0, 2.6)},
         {"Yeh and Petroff": MEASURED["velocity"]}, {each.run.name: velocity(each).mean(0.01) for each in done})]))
