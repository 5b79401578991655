# SPDX-License-Identifier: GPL-3.0-or-later
"""Dives of cases/gannetPlunge and their loads, for studies that compare them."""
from pathlib import Path

import numpy as np

from plunge.foamDictionary import read
from plunge.results import TRAJECTORY_COLUMNS, read_numbers, read_table, running_mean
from plunge.studies.particleRuns import call

# OpenFOAM's fastest on these meshes, tier fast: voxels of two cells in the background and half a cell in the body's mesh
STOCK_STENCIL = ("method trackingInverseDistance; searchBox (-0.61 0 -1.43) (0.65 0.35 1.33); "
                 "searchBoxDivisions ((25 7 56) (100 28 221));")
# What makes plungeFoam's scene that of a stock solver, which has the added mass given: Lamb's spheroid, half of it
AS_STOCK = {
    "constant/sceneProperties": "#remove boundaryLayer\n#remove frictionLineCoeffs\nsurfaceTension on;",
    "constant/bodyMotion": "solver { addedMass (0.0295806 1.3718 1.3718); addedInertia (0 0.0505216 0.0505216); }",
}
WINDOW = 1e-3   # [s], of running means: the body moves by a quarter of its diameter
FIRST = 1e-4    # [s], of the start


def mesh(run: Path) -> None:
    """The composite mesh of a prepared dive, and its fields as they are in the case."""
    for program in ("plungeBodyMesh", "gmshToFoam -keepOrientation body.msh", "createPatch -overwrite", "blockMesh -case background",
                    "snappyHexMesh -case background -overwrite", "mergeMeshes . background -overwrite"):
        call(run, *program.split())
    (run / "0.orig").rename(run / "0")


class Dive:
    """Loads of one dive over time: along the axis (against the motion positive) and across it, of the whole body [N]."""

    def __init__(self, run: Path) -> None:
        given = read(run / "system/plungeGenerated")
        table = read_table(run / "results/trajectory.csv", TRAJECTORY_COLUMNS)
        self.run, self.mesh, self.resolution = run, given["mesh"], float(given["resolution"])
        self.impact, self.mass = float(given["speed"]), float(given["bodyMass"])
        self.time, self.speed = table["time_s"], table["speed_m_s"]
        force = np.stack([table[f"Fp{c}_N"] + table[f"Fv{c}_N"] for c in "xyz"])
        pitch = np.radians(table["pitch_deg"])
        forward = np.stack((np.cos(pitch), 0*pitch, np.sin(pitch)))
        dorsal = np.stack((-np.sin(pitch), 0*pitch, np.cos(pitch)))
        self.load = {"axial": -np.sum(force*forward, axis=0), "lateral": np.sum(force*dorsal, axis=0)}
        self.mean = {name: running_mean(self.time, load, WINDOW) for name, load in self.load.items()}

    def noise(self, name: str) -> float:
        """Rms of a load about its running mean after the first WINDOW [N]."""
        return float(np.sqrt(np.mean((self.load[name] - self.mean[name])[self.time > WINDOW]**2)))

    def impulse(self) -> float:
        """Of the fluids on the body in the first steps [N s]."""
        first = (self.time > 0) & (self.time <= FIRST)
        return float(np.sum((self.load["axial"][1:]*np.diff(self.time))[first[1:]]))

    def ledger(self) -> float:
        """Largest error of the liquid's volume over the body's [%]."""
        return read_numbers(self.run / "results/summary.csv")["max |volume ledger error|"][0]


class Difference:
    """Of a dive to another one, over time [s]: of the speed over the impact speed, and of the running means of the loads over
    the largest axial load of the other one, `peak` [N]; in percent."""

    def __init__(self, dive: Dive, other: Dive) -> None:
        self.time = np.linspace(0, min(dive.time[-1], other.time[-1]), 2001)
        self.peak = float(other.mean["axial"].max())

        def apart(ours: np.ndarray, theirs: np.ndarray, scale: float) -> np.ndarray:
            return 100*np.abs(np.interp(self.time, dive.time, ours) - np.interp(self.time, other.time, theirs))/scale

        self.speed = apart(dive.speed, other.speed, other.impact)
        self.axial, self.lateral = (apart(dive.mean[name], other.mean[name], self.peak) for name in ("axial", "lateral"))
