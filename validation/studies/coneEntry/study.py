# SPDX-License-Identifier: GPL-3.0-or-later
"""The force on cones that fall into water from 0.5 m against Boom et al., arXiv:2403.13262. C = 2 F/(rho pi R^2 U0^2), F = m (a + g); time is
counted from contact, as U0 t/h. Both as means of 0.25 ms, the interval in which the accelerometer was read. Variants are half-angles.

Judged: at a half-angle of 45 degrees the peak and its time, within two standard deviations of the trials, for at 12 the force has no peak;
at each the history up to U0 t/h = 2, whose distance, rms, is a share of the largest mean that was measured until then: a tenth."""
import numpy as np

from plunge.results import gather
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.scenes import solveScene
from plunge.studies.signals import Signal, rms
from plunge.studies.study import Quantity, Run, Study

RADIUS, RHO, GRAVITY, DROP = 0.026, 997, 9.81, 0.5
SPEED = np.sqrt(2*GRAVITY*DROP)
INTERVAL, END = 0.25e-3, 2      # [s], U0 t/h
PEAKS = {f"{row['half_angle_deg']} deg": row for row in reference("Boom2024", "peaks") if row["drop_height_m"] == DROP}
HISTORIES = {f"{angle} deg": reference("Boom2024", f"history{angle}") for angle in (45, 12)}
MEASURED = {angle: Signal(table["Ut_over_h"], table["Cf_mean"]).during(0, END) for angle, table in HISTORIES.items()}
RUNS = {(45, 0.003): ("full",), (45, 0.002): ("full",), (45, 0.0013): ("full",), (12, 0.003): ("full",), (45, 0.006): ("quick",)}
CONES = {45: [], 12: ["-set", "body.shape.halfAngle=12", "-set", "body.shape.length=0.3873", "-set", "body.mass=0.60318", "-set", "duration=0.086"]}


def computed(done) -> Signal:
    table, row = gather(done.path)["trajectory"], PEAKS[done.run.variant]
    C = 2*row["mass_kg"]*(table["az_m_s2"] + GRAVITY)/(RHO*np.pi*RADIUS**2*SPEED**2)
    scale = SPEED*np.tan(np.radians(row["half_angle_deg"]))/RADIUS
    return Signal(table["time_s"]*scale, C).mean(INTERVAL*scale).during(0, END)


def peak(done) -> int:
    return int(computed(done).value.argmax())


study = Study(
    title="The force on a cone that falls into water is that of the trials",
    runs=[Run("fallingCone", "particles", f"{angle} deg", f"{spacing:g} m", tiers, given={
        "options": CONES[angle], "changes": {"constant/particleProperties": f"geometry {{ spacing {spacing}; }}"}})
          for (angle, spacing), tiers in RUNS.items()],
    solve=solveScene, sources=("src/smoothedParticles", "src/rigidBody", "applications/solvers/plungeSPH"),
    quantities=[
        *(Quantity(name, "1", lambda done, of=of: float(of(computed(done))[peak(done)]),
                   lambda done, c=column: PEAKS[done.run.variant][f"{c}_mean"], lambda done, c=column: 2*PEAKS[done.run.variant][f"{c}_std"],
                   judged=lambda run: run.variant == "45 deg", converges=True)
          for name, column, of in (("peak of C", "Cpeak", lambda s: s.value), ("U0 t/h of the peak of C", "Ut_over_h_at_peak", lambda s: s.time))),
        Quantity("C less measured, rms over the largest measured", "%", lambda done: 100*rms(
            computed(done).less(MEASURED[done.run.variant]))/float(MEASURED[done.run.variant].value.max()), 0, tolerance=10),
        Quantity("integral of C over the measured", "1", lambda done: computed(done).integral()/Signal(
            computed(done).time, MEASURED[done.run.variant].at(computed(done).time)).integral())],
    headlines=["peak of C"],
    figure=lambda done, file: draw(file, [({"title": angle, "xlabel": "U0 t/h", "ylabel": "C", "xlim": (0, END)}, {"measured": MEASURED[angle]}, {
        each.run.resolution: computed(each) for each in done if each.run.variant == angle}) for angle in MEASURED], 2))
