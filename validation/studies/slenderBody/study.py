# SPDX-License-Identifier: GPL-3.0-or-later
"""The lowest rung, strips with an entry force by the generalised Wagner model, nothing tuned. Cones: Boom et al., arXiv:2403.13262; the peak of
C = 2 F/(rho pi R^2 U0^2), F = m (a + g), mean of 0.25 ms, until U0 t/h = 2 (at 12 degrees the largest, at the end): two standard deviations
of the trials and 10 %. The dive: the 3D solver's figures (crossCheck, tier fast), with diveUncertainty's for Titan, in per cent, and 10 %."""
import numpy as np

from plunge.results import crossing, read_numbers
from plunge.studies import REPOSITORY
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.resultTable import read
from plunge.studies.scenes import solveScene
from plunge.studies.signals import Signal
from plunge.studies.study import STUDIES, Quantity, Run, Study, only

RADIUS, RHO, GRAVITY, CYLINDER, END, INTERVAL, ALLOWED = 0.026, 997, 9.81, 0.265, 2.0, 0.25e-3, 0.1
CONE, DIVE, SHOWN = "fallingCone", "gannetPlunge", ("12 deg 1.5 m", "25 deg 1 m", "45 deg 0.5 m", "80 deg 0.5 m")
TRIALS = {f"{row['half_angle_deg']} deg {row['drop_height_m']:g} m": row for row in reference("Boom2024", "peaks")}
UNITS = {"velocity lost at full immersion": "m/s", "peak deceleration": "m/s2", "full immersion time": "s", "pitch change at full immersion": "deg"}
MESHES = {(row["variant"], row["quantity"]): float(row["value"]) for row in read(STUDIES/"crossCheck/result.csv")
          if row["method"] == "meshes" and row["resolution"] == "fast"}
SURE = {row["quantity"]: float(row["total_uncertainty"])/float(row["value"]) for row in read(REPOSITORY/"cases/gannetPlunge/constant/uncertainty.csv")}
HEIGHT = {name: float(RADIUS/np.tan(np.radians(row["half_angle_deg"]))) for name, row in TRIALS.items()}


def cone(name: str, row) -> Run:
    entries = {"body.shape.halfAngle": row["half_angle_deg"], "body.shape.length": CYLINDER + HEIGHT[name], "body.mass": row["mass_kg"],
               "entry.drop": row["drop_height_m"], "duration": 1.1*END*HEIGHT[name]/row["U0_m_s"]}
    return Run(CONE, "slenderBody", name, tiers=("quick", "full") if name in SHOWN else ("full",),
               given={"options": [word for entry, value in entries.items() for word in ("-set", f"{entry}={value:.8g}")]})


def history(done) -> Signal:
    """C over U0 t/h."""
    row, table = TRIALS[done.run.variant], done.track
    C = 2*row["mass_kg"]*(table["az_m_s2"] + GRAVITY)/(RHO*np.pi*RADIUS**2*row["U0_m_s"]**2)
    signal = Signal(table["time_s"] - crossing(table["time_s"], table["penetration_m"]), C).mean(INTERVAL)
    return Signal(signal.time*row["U0_m_s"]/HEIGHT[done.run.variant], signal.value).during(0, END)


def measured(name: str) -> Signal:
    table = reference("Boom2024", f"history{TRIALS[name]['half_angle_deg']}")
    table = table[table["drop_m"] == TRIALS[name]["drop_height_m"]]
    return Signal(table["Ut_over_h"], table["Cf_mean"]).during(0, END)


study = Study(
    title="The lowest rung: cones and the dive by strips, in a fraction of a second",
    runs=[*(cone(*trial) for trial in TRIALS.items()),
          *(Run(DIVE, "slenderBody", f"{fluids}, boundary layer {layer}", tiers=("quick", "full"), given={"options": ["-fluids", fluids, "-boundaryLayer", layer]})
            for fluids in ("titan", "water") for layer in ("auto", "none"))],
    solve=solveScene, sources=("src/slenderBody", "src/boundaryLayer/frictionLaw", "applications/solvers/slenderBody"),
    quantities=[
        Quantity("peak of C", "1", only(lambda done: history(done).value.max(), lambda run: run.scene == CONE), lambda done: TRIALS[done.run.variant]["Cpeak_mean"],
                 lambda done: 2*TRIALS[done.run.variant]["Cpeak_std"], lambda done: ALLOWED*TRIALS[done.run.variant]["Cpeak_mean"]),
        *(Quantity(name, unit, only(lambda done, n=name: read_numbers(done.path/"results/summary.csv")[n][0], lambda run: run.scene == DIVE),
                   lambda done, n=name: MESHES[done.run.variant, n], lambda done, n=name: SURE[n]*MESHES[done.run.variant, n],
                   lambda done, n=name: ALLOWED*MESHES[done.run.variant, n]) for name, unit in UNITS.items()),
        Quantity("CPU time", "s", lambda done: done.cpu, most=1, judged=lambda run: run.scene == DIVE)],
    headlines=["peak of C", "velocity lost at full immersion"],
    figure=lambda done, file: draw(file, [({"title": name, "xlabel": "U0 t/h", "ylabel": "C"}, {"measured": measured(name)}, {
        "strips": history(each) for each in done if each.run.variant == name}) for name in SHOWN], 2))
