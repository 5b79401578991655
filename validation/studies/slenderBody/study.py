# SPDX-License-Identifier: GPL-3.0-or-later
"""The lowest rung, strips with an entry force by the generalised Wagner model and a friction line, nothing in it tuned, against what it
can be judged by. Cones that fall into water: Boom et al., arXiv:2403.13262; the peak of C = 2 F/(rho pi R^2 U0^2), F = m (a + g), as mean of
0.25 ms, the accelerometer's interval, until U0 t/h = 2; judged within two standard deviations of the trials and 10 %. At 12 degrees
there is no peak: C at the end. The dive: the 3D solver's figures of study crossCheck (its tier fast), with the uncertainty that study
diveUncertainty has measured for Titan, in per cent for the other dives, and 10 %. How long a whole dive takes is the solver's CPU time,
of which most is the table of the entry's force."""
import csv

import numpy as np

from plunge.results import crossing, gather, read_numbers
from plunge.studies import REPOSITORY
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.resultTable import read
from plunge.studies.scenes import solveScene
from plunge.studies.signals import Signal
from plunge.studies.study import STUDIES, Quantity, Run, Study, only

RADIUS, RHO, GRAVITY, CYLINDER, END, INTERVAL, ALLOWED = 0.026, 997, 9.81, 0.265, 2.0, 0.25e-3, 0.1
CONE, DIVE, LAYERS = "fallingCone", "gannetPlunge", {"boundary layer auto": "auto", "boundary layer none": "none"}
TRIALS = {f"{row['half_angle_deg']} deg {row['drop_height_m']:g} m": row for row in reference("Boom2024", "peaks")}
QUICK = ("25 deg 1 m", "45 deg 0.5 m", "80 deg 0.5 m")
MESHES = {(row["variant"], row["quantity"]): float(row["value"]) for row in read(STUDIES/"crossCheck/result.csv")
          if row["method"] == "meshes" and row["resolution"] == "fast"}
with (REPOSITORY/"cases/gannetPlunge/constant/uncertainty.csv").open(newline="") as file:
    SURE = {row["quantity"]: float(row["total_uncertainty"])/float(row["value"]) for row in csv.DictReader(file) if row["fluids"] == "titan"}
DIVES = [f"{fluids}, {layer}" for fluids in ("titan", "water") for layer in LAYERS]


def options(name: str) -> list[str]:
    row = TRIALS[name]
    height, speed = RADIUS/np.tan(np.radians(row["half_angle_deg"])), row["U0_m_s"]
    return [word for entry, value in {
        "body.shape.halfAngle": row["half_angle_deg"], "body.shape.length": CYLINDER + height, "body.mass": row["mass_kg"],
        "entry.drop": row["drop_height_m"], "duration": 1.1*END*height/speed}.items() for word in ("-set", f"{entry}={value:.8g}")]


def history(done) -> Signal:
    """C over U0 t/h."""
    row, table = TRIALS[done.run.variant], gather(done.path)["trajectory"]
    U, height = row["U0_m_s"], RADIUS/np.tan(np.radians(row["half_angle_deg"]))
    C = 2*row["mass_kg"]*(table["az_m_s2"] + GRAVITY)/(RHO*np.pi*RADIUS**2*U**2)
    even = np.linspace(0, table["time_s"][-1], 4000)
    signal = Signal(even - crossing(table["time_s"], table["penetration_m"]), np.interp(even, table["time_s"], C)).mean(INTERVAL)
    return Signal(signal.time*U/height, signal.value).during(0, END)


def ofDive(name: str) -> Quantity:
    known = lambda done: MESHES.get((done.run.variant, name))
    return Quantity(name, {"velocity": "m/s", "peak": "m/s2", "full": "s", "pitch": "deg"}[name.split()[0]],
                    lambda done: read_numbers(done.path/"results/summary.csv")[name][0] if done.run.scene == DIVE else None, known,
                    lambda done: SURE[name]*abs(known(done)), lambda done: ALLOWED*abs(known(done)))


IS_CONE = lambda run: run.scene == CONE
study = Study(
    title="The lowest rung: cones and the dive by strips, in a fraction of a second",
    runs=[*(Run(CONE, "slenderBody", name, tiers=("quick", "full") if name in QUICK else ("full",), given={"options": options(name)}) for name in TRIALS),
          *(Run(DIVE, "slenderBody", name, tiers=("quick", "full"), given={"options": ["-fluids", name.split(",")[0], "-boundaryLayer", LAYERS[name.split(", ")[1]]]})
            for name in DIVES)],
    solve=solveScene, sources=("src/slenderBody", "src/boundaryLayer/frictionLaw", "applications/solvers/slenderBody"),
    quantities=[
        Quantity("peak of C", "1", only(lambda done: history(done).value.max(), IS_CONE), lambda done: TRIALS[done.run.variant]["Cpeak_mean"],
                 lambda done: 2*TRIALS[done.run.variant]["Cpeak_std"], lambda done: ALLOWED*TRIALS[done.run.variant]["Cpeak_mean"]),
        Quantity("U0 t/h of the peak of C", "1", only(lambda done: history(done).time[history(done).value.argmax()], IS_CONE),
                 lambda done: TRIALS[done.run.variant]["Ut_over_h_at_peak_mean"]),
        *map(ofDive, ("velocity lost at full immersion", "peak deceleration", "full immersion time", "pitch change at full immersion")),
        Quantity("CPU time", "s", lambda done: done.cpu, most=1, judged=lambda run: run.scene == DIVE)],
    headlines=["peak of C", "velocity lost at full immersion"],
    figure=lambda done, file: draw(file, [({"title": f"{angle} deg", "xlabel": "drop [m]", "ylabel": "peak of C"}, {"measured": Signal(
        *map(np.array, zip(*((row["drop_height_m"], row["Cpeak_mean"]) for row in TRIALS.values() if row["half_angle_deg"] == angle))))}, {
            "strips": Signal(*map(np.array, zip(*((TRIALS[each.run.variant]["drop_height_m"], history(each).value.max()) for each in done
                             if each.run.scene == CONE and TRIALS[each.run.variant]["half_angle_deg"] == angle))))}) for angle in (12, 45, 80)], 3))
