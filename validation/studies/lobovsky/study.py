# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressures at the end of a tank in a dam break, of particles and on meshes, against Lobovsky et al. 2014. Units: T = t sqrt(g/H), pressure
over rho g H.

At sensor 2 a hundred runs were made: 95 of a hundred are inside the band between the percentiles 2.5 and 97.5 at any time, and so
should the computed pressure be, from the impact on; the peak within that band's half width. Their gate takes time to open and their wave is
later: time is shifted for the computed pressure to pass 0.5 first when the measured median does. A sensor is 4.2 mm wide and its signal
has a rate of 20 kHz; the computed pressure is that of particles in the support of the kernel at an instant, or of the cell.

Sound in the computed liquid is slower than in water by a factor of 44, and rings: the longest wave that stands in the depth H has a
period of 4H/c0. So each figure of particles is also given of the pressure's mean over that period. Variants with other walls are not judged:
they tell what of the pressure is friction's, on meshes with the boundary layer resolved by cells of 0.5 mm, or with walls that slip. The tier
`meshes` leaves out the particles and these."""
import numpy as np

from plunge.studies.foamFields import numbers
from plunge.studies.meshTwins import END_WALLS, LENGTH, SENSORS, TOP, endWall
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.scenes import solveScene, spacings
from plunge.studies.signals import Signal, rms
from plunge.studies.study import Quantity, Run, Study, only
from plunge.tankTables import tables

DEPTH, GRAVITY, C0 = 0.3, 9.81, 34
RETURN, RINGING = 5.5, 4*DEPTH/C0*np.sqrt(GRAVITY/DEPTH)    # the wave that comes back falls on the sensor later
PROPERTIES = ("geometry { fluid ({ type box; min (0 0 0); max (0.6 0.3 0); }); walls ({ name tank; type box; min (0 0 0); "
              f"max ({LENGTH} {TOP} 0); open (top); }}); }} outputs {{ interval 0.001; gauges {{ front (1.5 0 0); }} probes {{ "
              + " ".join(f"{name} ({LENGTH} {height} 0);" for name, height in SENSORS.items()) + " } }")
CHANGES = {"constant/particleProperties": PROPERTIES, "system/controlDict": "endTime 1.25; writeInterval 0.05;"}
TANK = [word for entry, value in (("tank.size", f"({LENGTH} {TOP})"), ("liquid.column.max", "(0.6 0.3)"), ("gauges", "{ front (1.5 0); }"), (
    "probes", "{ " + " ".join(f"{name} ({LENGTH} {height});" for name, height in SENSORS.items()) + " }"), ("duration", 1.25), ("interval", 0.001))
    for word in ("-set", f"{entry}={value}")]
SLIP = {**CHANGES, "constant/particleProperties": PROPERTIES + " walls slip;"}
BAND = reference("Lobovsky2014", "sensor2")
LOW, MEDIAN, HIGH = (Signal(BAND["T"], BAND[column]) for column in ("low", "median", "high"))
MEASURED = {name: MEDIAN if name == "P2" else Signal(*(reference("Lobovsky2014", f"sensor{name[1]}")[c] for c in "TP")) for name in SENSORS}


def delay(done) -> float:
    return MEDIAN.rise(0.5) - pressure(done, "P2", 0).rise(0.5)


def pressure(done, sensor: str, later=None) -> Signal:
    """In the time of the measurement and its units."""
    if done.run.method == "particles" or not done.run.variant:
        table = tables(done.path)["probes"]
        time, p = table["time_s"], table[f"{sensor}_p_Pa"]
    else:
        time, p = numbers(done.path / "postProcessing/probes/0/p")[:, [0, 1 + list(SENSORS).index(sensor)]].T
    return Signal(time*np.sqrt(GRAVITY/DEPTH), p/(1000*GRAVITY*DEPTH)).later(delay(done) if later is None else later)


def inside(done, until: float, window: float) -> float:
    band = MEDIAN.during(MEDIAN.rise(0.5), until).time
    P = pressure(done, "P2").mean(window).at(band)
    return 100*float(((P >= LOW.at(band)) & (P <= HIGH.at(band))).mean())


def noise(done) -> float:
    """What a parabola does not follow, rms."""
    steady = Signal(BAND["T"], pressure(done, "P2").at(BAND["T"])).during(3.5, RETURN)
    return rms(steady.value - np.polyval(np.polyfit(*steady, 2), steady.time))


JUDGED = {"judged": lambda run: not run.variant}


def ofBoth(window: float, value):
    """Means over the ringing are those of particles: nothing rings on meshes."""
    return only(value, lambda run: not window or run.method == "particles")


study = Study(
    title="The pressure of a dam break on a wall is inside the band of a hundred runs",
    runs=[*spacings("damBreak", {0.01: ("full",), 0.005: ("full",), 0.0025: ("full",)}, CHANGES),
          *spacings("damBreak", {0.005: ("full",)}, SLIP, "walls slip"), *spacings("damBreak", {0.02: ("quick",)}, CHANGES),
          *(Run("damBreak", "meshes", "", level, tiers, given={"options": TANK})
            for level, tiers in (("fast 0.5", ("quick", "full", "meshes")), ("fast 0.7", ("full", "meshes")), ("fast", ("full", "meshes")))),
          *(Run("damBreak", "meshes", variant, resolution) for variant, resolution in zip(END_WALLS, ("0.01 m", "0.0005 m")))],
    solve=lambda run, path: endWall(path, run.variant) if run.method == "meshes" and run.variant else solveScene(run, path),
    sources=("src/smoothedParticles", "src/freeSurfaceFlow", "applications/solvers"),
    quantities=[
        *(Quantity(f"time inside the band of repeated runs, {until}{of}", "%", ofBoth(w, lambda done, to=to, w=w: inside(done, to, w)), 100, tolerance=5,
                   **JUDGED) for to, until in ((RETURN, "to the returning wave"), (7.0, "with the returning wave"))
          for w, of in ((0, ""), (RINGING, ", mean over the ringing"))),
        *(Quantity(f"peak at sensor 2{of}", "rho g H", ofBoth(w, lambda done, w=w: float(
            np.nanmax(pressure(done, "P2").mean(w).at(BAND["T"])))), float(MEDIAN.value.max()),
            0.5*float(HIGH.value.max() - LOW.value.max()), converges=True, **JUDGED) for w, of in ((0, ""), (RINGING, ", mean over the ringing"))),
        Quantity("mean at sensor 2, T from 3.5 to 5.5", "rho g H", lambda done: float(pressure(done, "P2").during(3.5, RETURN).value.mean()),
                 float(MEDIAN.during(3.5, RETURN).value.mean()), judged=lambda run: False),
        Quantity("noise at sensor 2, rms off a parabola", "rho g H", noise),
        Quantity("delay of the measured wave, T", "1", delay),
        *(Quantity(f"mean at sensor {name[1]} less one measured run, T from 3 to 5.5", "rho g H", lambda done, n=name: float(
            np.mean(pressure(done, n).less(MEASURED[n].during(3, RETURN))))) for name in SENSORS if name != "P2")],
    headlines=["time inside the band of repeated runs, to the returning wave, mean over the ringing"],
    figure=lambda done, file: draw(file, [({"title": f"sensor {name[1]}, {1000*height:g} mm", "xlim": (2, 7.2), "ylim": (-0.3, 3.5),
        "xlabel": "t sqrt(g/H), aligned on the arrival at sensor 2", "ylabel": "p/(rho g H)"}, {"measured": MEASURED[name]} | (
            {"percentile 2.5": LOW, "percentile 97.5": HIGH} if name == "P2" else {}),
        {each.run.name: pressure(each, name) for each in done}) for name, height in SENSORS.items()], 2))
