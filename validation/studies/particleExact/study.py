# SPDX-License-Identifier: GPL-3.0-or-later
"""plungeSPH against exact solutions, each at two spacings. Variants are Reynolds numbers and ratios h of smoothing length to spacing, and
viscosities of the wave, and of the spheroid whether it is drawn out along its axis or pressed flat. Tolerances are what a method of second order should reach on some twenty particles."""
from pathlib import Path

import numpy as np

from plunge.studies.exactFlows import DEPTH, TaylorGreen, decay, drop, energyChange, oscillation, radiusAndHeight, semiAxes, spheroid, wave
from plunge.studies.particleRuns import table
from plunge.studies.study import Done, Quantity, Run, Study

VORTICES, DROP, WAVE, SPHEROID = "TaylorGreen", "drop", "standingWave", "spheroid"
RATES = {"drawn out": 1, "pressed flat": -1}    # [1/s]
NU = 0.01   # of the viscous wave [m2/s]


def count(run: Run) -> int:
    """Particles along a side, the radius, the depth."""
    return round((DEPTH if run.scene == WAVE else 1)/run.size)


def solve(run: Run, path: Path) -> None:
    if run.scene == VORTICES:
        TaylorGreen(path, count(run), run.given["h"], run.given["Re"])
    elif run.scene == DROP:
        drop(path, count(run))
    elif run.scene == SPHEROID:
        spheroid(path, count(run), RATES[run.variant])
    else:
        wave(path, count(run), run.given["nu"])


def of(scene: str, value, viscous=None):
    """A value of that scene's runs, or of those whose viscosity is so."""
    return lambda done: value(done) if done.run.scene == scene and viscous in (None, bool(done.run.given.get("nu"))) else None


def energyOfDrop(done: Done) -> float:
    energy = table(done.path, "energy")
    return float(np.abs(energyChange(done.path, "kinetic", "internal")).max()/(energy["kinetic_J"] + energy["internal_J"])[0])


def gainOfWave(done: Done) -> float:
    return float(energyChange(done.path, "kinetic", "potential", "internal").max()/table(done.path, "energy")["kinetic_J"][0])


study = Study(
    title="Particles follow exact solutions: vortices, a drop, a spheroid of rings, a standing wave",
    runs=[*(Run(VORTICES, "particles", f"Re {Re}, h {h}", f"{1/n:g} m", ("quick", "full") if n == 20 else ("full",), given={"Re": Re, "h": h})
            for Re, h in ((10, 2), (100, 2), (100, 3)) for n in (20, 40)),
          *(Run(DROP, "particles", "", f"{1/n:g} m", ("quick", "full") if n == 20 else ("full",)) for n in (20, 40)),
          *(Run(SPHEROID, "particles", variant, f"{1/n:g} m", ("quick", "full") if n == 20 else ("full",)) for variant in RATES for n in (20, 40)),
          *(Run(WAVE, "particles", f"nu {nu:g}" if nu else "inviscid", f"{DEPTH/n:g} m", ("quick", "full") if n == 10 else ("full",),
                given={"nu": nu}) for nu in (0, NU) for n in (10, 20))],
    solve=solve, sources=("src/smoothedParticles", "applications/solvers/plungeSPH", "cases/stillTank"),
    quantities=[
        Quantity("decay of the energy over 4 pi^2 nu", "1", of(VORTICES, lambda done: decay(done.path, done.run.given["Re"])), 1, tolerance=0.05),
        *(Quantity(f"{which} semi-axis over the exact one", "1", of(DROP, lambda done, i=i: float(semiAxes(done.path, count(done.run))[i])), 1,
                   tolerance=0.02) for i, which in enumerate(("shorter", "longer"))),
        *(Quantity(f"{which} of the spheroid over the exact one", "1", of(SPHEROID, lambda done, i=i: float(
            radiusAndHeight(done.path, count(done.run), RATES[done.run.variant])[i])), 1, tolerance=0.02) for i, which in enumerate(("radius", "height"))),
        Quantity("change of the energy over the energy", "1", of(DROP, energyOfDrop), 0, tolerance=1e-4),
        Quantity("frequency over sqrt(g k tanh(k d))", "1", of(WAVE, lambda done: oscillation(done.path)[0], False), 1, tolerance=0.02),
        Quantity("largest gain of energy over the wave's", "1", of(WAVE, gainOfWave, False), 0, tolerance=0.05),
        Quantity("decay over 2 nu k^2", "1", of(WAVE, lambda done: oscillation(done.path)[1]/(2*NU*np.pi**2), True), 1, tolerance=0.1)],
    headlines=["decay of the energy over 4 pi^2 nu", "frequency over sqrt(g k tanh(k d))"])
