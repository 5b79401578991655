# SPDX-License-Identifier: GPL-3.0-or-later
"""A small standing wave between two viscous fluids of any densities, whose kinematic viscosities are one: what has an exact solution
(Prosperetti, Phys. Fluids 24 (1981) 1217; of deep fluids, that start from rest)."""
import shutil
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.special import erfc, wofz

from plunge.studies import REPOSITORY
from plunge.studies.foamFields import numbers
from plunge.studies.particleRuns import CONTROL, call
from plunge.studies.scenes import prepare, quietly, solve as solveRun
from plunge.studies.signals import Signal
from plunge.studies.study import Run

STEEPNESS = 0.01        # first amplitude over the length
COURANT = 0.5           # of the wave, and of the shortest ripple that the mesh holds (Brackbill, Kothe and Zemach 1992)
SAMPLES = 50            # in a period
SCENE = REPOSITORY / "cases/stillTank"


@dataclass(frozen=True)
class Wave:
    """SI units; nu is that of both fluids. As long as the tank's liquid and gas are deep each, half of it in the tank."""

    length: float
    liquidDensity: float
    gasDensity: float
    nu: float
    surfaceTension: float
    gravity: float
    periods: float      # that are computed

    @property
    def k(self) -> float:
        return 2*np.pi/self.length

    def inviscid(self, k: float) -> float:
        """Angular frequency of a wave without viscosity (Lamb 1932, art. 267)."""
        return float(np.sqrt(((self.liquidDensity - self.gasDensity)*self.gravity*k + self.surfaceTension*k**3)
                             / (self.liquidDensity + self.gasDensity)))

    @property
    def duration(self) -> float:
        return self.periods*2*np.pi/self.inviscid(self.k)

    def amplitude(self, time: np.ndarray) -> np.ndarray:
        """Over the first one, as Prosperetti has it for one kinematic viscosity."""
        beta = self.liquidDensity*self.gasDensity/(self.liquidDensity + self.gasDensity)**2
        rate, square = self.nu*self.k**2, self.inviscid(self.k)**2
        roots = np.roots([1, -4*beta*rate**0.5, 2*(1 - 6*beta)*rate, 4*(1 - 3*beta)*rate**1.5, (1 - 4*beta)*rate**2 + square])
        found = 4*(1 - 4*beta)*rate**2/(8*(1 - 4*beta)*rate**2 + square)*erfc(np.sqrt(rate*time)) + 0j
        for i, z in enumerate(roots):
            others = np.prod(np.delete(roots, i) - z)
            # wofz(i x) = exp(x^2) erfc(x)
            found += z/others*square/(z*z - rate)*np.exp(-rate*time)*wofz(1j*z*np.sqrt(time))
        return found.real

    def step(self, cell: float) -> float:
        """The longest [s]."""
        return COURANT*cell/max(self.inviscid(k)/k for k in (self.k, np.pi/cell))


def solve(run: Run, path: Path, wave: Wave, cells: int) -> None:
    """cells along the length."""
    a, L = STEEPNESS*wave.length, wave.length
    of = {"liquidDensity": wave.liquidDensity, "liquidViscosity": wave.nu*wave.liquidDensity, "gasDensity": wave.gasDensity,
          "gasViscosity": wave.nu*wave.gasDensity, "surfaceTension": wave.surfaceTension, "gravity": wave.gravity}
    fluids = f"{{ {run.given['fluids']} {' '.join(f'{name} {value!r};' for name, value in of.items())} }}"
    entries = {"tank.size": f"({L/2!r} {2*L!r})", "liquid.water.max": f"({L/2!r} {L!r})", "fluids": fluids, "maxSpeed": wave.inviscid(wave.k)/wave.k,
               "gauges": f"{{ left ({0.1*L/cells!r} 0); right ({L/2 - 0.1*L/cells!r} 0); }}", "probes": f"{{ middle ({L/4!r} {L/2!r}); }}",
               "duration": wave.duration, "interval": wave.duration/wave.periods/SAMPLES, "frames": 1,
               # A plane tank's cells are a third of that
               "tier.cellSpacing": 3/cells}
    prepare(run, path, [word for entry, value in entries.items() for word in ("-set", f"{entry}={value}")],
            {CONTROL: f"maxDeltaT {wave.step(L/cells)!r};"}, SCENE)
    if not (path / "log.plungeFoam").exists():
        quietly(str(path / "Allrun"), "-setUp")
        (path / "system/setAlphaFieldDict").write_text(
            "FoamFile { version 2.0; format ascii; class dictionary; object setAlphaFieldDict; }\nfield alpha.liquid; type sin; direction (1 0 0); "
            f"up (0 0 1); origin ({-L/4!r} 0 {L!r}); period {L!r}; amplitude {a!r};\n")
        # It fills cells and empties none
        shutil.copy(path / "0.orig/alpha.liquid", path / "0/alpha.liquid")
        call(path, "setAlphaField")
    solveRun(path)


def history(path: Path, wave: Wave, cells: int) -> Signal:
    """Amplitude over the first one: half the difference of the heights at the two ends, in which the second harmonic drops out; of the
    liquid in columns of cells, whose mean is that of the cosine over a cell."""
    ends = [numbers(path / f"postProcessing/gauge_{end}/0/alpha.liquid") for end in ("left", "right")]
    heights = [2*wave.length*of[:, 1:].mean(axis=1) for of in ends]
    angle = 2*np.pi/cells
    return Signal(ends[0][:, 0], (heights[0] - heights[1])/2/(STEEPNESS*wave.length*np.sin(angle)/angle))


def frequency(of: Signal) -> float:
    """Mean angular frequency between the first zero and the last [rad/s]."""
    time, value = of
    at = np.nonzero(value[:-1]*value[1:] <= 0)[0]
    zeros = time[at] + (time[at + 1] - time[at])*value[at]/(value[at] - value[at + 1])
    return float(np.pi/np.polyfit(range(len(zeros)), zeros, 1)[0])


def decay(of: Signal) -> float:
    """Of the extremes between zeros [1/s]."""
    time, value = of
    at = np.nonzero(value[:-1]*value[1:] <= 0)[0] + 1
    most = [a + int(np.abs(value[a:b]).argmax()) for a, b in zip(at[:-1], at[1:])]
    return -float(np.polyfit(time[most], np.log(np.abs(value[most])), 1)[0])
