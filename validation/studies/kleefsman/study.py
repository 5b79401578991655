# SPDX-License-Identifier: GPL-3.0-or-later
"""A dam break with a box in the way, of particles and on meshes, against Kleefsman et al. 2005. Time is that of the gate in both, not shifted.

Judged: the peak at P1, of meshes at P2, too, mean of 10 ms, for the record has a value each 5 ms, within 15 %; the arrival, when P1 first
passes 1 kPa, within 3 %; and the heights, whose difference is a share of the depth at the start, rms over the first 2 s, at most 5 %. The
publication has no uncertainties: the tolerances are what repeated dam breaks of others scatter by. The tier `meshes` leaves out the particles,
which take most of the time."""
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.scenes import solveScene, spacings
from plunge.studies.signals import Signal, rms
from plunge.studies.study import Quantity, Run, Study
from plunge.tankTables import tables

MEAN, END, DEPTH, ARRIVAL = 0.01, 2.0, 0.55, 1e3    # [s], [s], [m], [Pa]
PRESSURES, HEIGHTS = ("P1", "P2", "P4"), ("H2", "H4")
RECORD = reference("Kleefsman2005", "record")
MEASURED = {name: Signal(RECORD["time_s"], RECORD[f"{name}_{'Pa' if name in PRESSURES else 'm'}"]).during(0, END)
            for name in PRESSURES + HEIGHTS}


def computed(done, name: str) -> Signal:
    table, column = ("probes", f"{name}_p_Pa") if name in PRESSURES else ("gauges", f"{name}_m")
    found = tables(done.path)[table]
    return Signal(found["time_s"], found[column]).during(0, END)


def peak(signal: Signal) -> float:
    return float(signal.mean(MEAN).value.max())


def panel(done, name: str):
    of = {f"{each.run.method}, {each.run.resolution}": computed(each, name) for each in done}
    settings = ({"ylabel": "pressure [Pa]", "ylim": (-1000, 14000)} if name in PRESSURES else {"ylabel": "height [m]", "ylim": (0, 0.7)})
    return ({"title": name, "xlabel": "time [s]", **settings}, {"measured": MEASURED[name]},
            {f"{label}, mean of 10 ms": signal.mean(MEAN) for label, signal in of.items()})


study = Study(
    title="A dam break onto a box has the measured arrival, peak pressure and heights",
    runs=spacings("kleefsman", {0.0275: ("full",), 0.55/30: ("full",)})
    + spacings("kleefsman", {0.055: ("quick",)}, {"system/controlDict": "endTime 0.6;"})
    + [Run("kleefsman", "meshes", "", level, tiers) for level, tiers in (
        ("fast 0.5", ("quick", "full", "meshes")), ("fast 0.7", ("full", "meshes")), ("fast", ("full", "meshes")))],
    solve=solveScene, sources=("src/smoothedParticles", "src/freeSurfaceFlow", "applications/solvers"),
    quantities=[
        *(Quantity(f"peak pressure at {name}, mean of 10 ms", "Pa", lambda done, n=name: peak(computed(done, n)), peak(MEASURED[name]),
                   tolerance=0.15*peak(MEASURED[name]), converges=True,
                   judged=lambda run, n=name: n == "P1" or (n, run.method) == ("P2", "meshes")) for name in PRESSURES),
        Quantity("arrival at P1", "s", lambda done: computed(done, "P1").rise(ARRIVAL), MEASURED["P1"].rise(ARRIVAL),
                 tolerance=0.03*MEASURED["P1"].rise(ARRIVAL), converges=True),
        *(Quantity(f"height {name} less measured, rms over the first depth", "%",
                   lambda done, n=name: 100*rms(computed(done, n).less(MEASURED[n]))/DEPTH, 0, tolerance=5) for name in HEIGHTS),
        *(Quantity(f"height {name} less measured, mean over the first depth", "%",
                   lambda done, n=name: 100*float(computed(done, n).less(MEASURED[n]).mean())/DEPTH) for name in HEIGHTS)],
    headlines=["peak pressure at P1, mean of 10 ms", "arrival at P1"],
    figure=lambda done, file: draw(file, [panel(done, name) for name in PRESSURES + HEIGHTS], 2))
