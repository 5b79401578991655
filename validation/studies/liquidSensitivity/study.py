# SPDX-License-Identifier: GPL-3.0-or-later
"""What an error in the liquid's density or viscosity does to the dive: with the constants of the paper, with 5 % more and less density, half
and twice the viscosity, and the real Kraken; the vehicle stays the same. Variants are the liquids.

Nothing is judged. How far the changes for 5 % more and less density are from being opposite says how linear the dive is in the density,
and bounds the noise of the runs. Beside the viscous deceleration at full immersion stand those of a flat plate of the body's wetted area and
length at the speed of entry, laminar (Blasius, 1.328/sqrt(Re)) and turbulent (ITTC 1957, 0.075/(log10 Re - 2)^2)."""
from math import log10, sqrt
from pathlib import Path

import numpy as np

from plunge import fluids as pairs
from plunge.foamDictionary import read, write_nested
from plunge.results import read_numbers
from plunge.shapes import NACA
from plunge.studies import REPOSITORY
from plunge.studies.scenes import prepare, solve as solveRun
from plunge.studies.study import Done, Quantity, Run, Study, twin

DIVE, PAPER, KRAKEN = REPOSITORY / "cases/gannetPlunge", "titan", "kraken"
FACTORS = {PAPER: {}, "density 95 %": {"liquidDensity": 0.95}, "density 105 %": {"liquidDensity": 1.05},
           "viscosity 50 %": {"liquidViscosity": 0.5}, "viscosity 200 %": {"liquidViscosity": 2}}


def solve(run: Run, path: Path) -> None:
    """From the dive's scene with these fluids."""
    name = KRAKEN if run.variant == KRAKEN else PAPER
    given = {entry: value*FACTORS.get(run.variant, {}).get(entry, 1) for entry, value in pairs.resolve(name, "the study")[1].items()}
    scene = path.with_name(f"{path.name}.scene")
    scene.parent.mkdir(parents=True, exist_ok=True)
    write_nested(scene, "The dive with other fluids", {**read(DIVE / "constant/scene"), "fluids": given})
    prepare(run, path, scene=scene)
    solveRun(path)


def figures(done: Done) -> dict:
    """Accelerations are [m/s2], of the whole body."""
    given, track = read(done.path / "system/plungeGenerated"), done.track
    found = {name: value for name, (value, _) in read_numbers(done.path / "results/summary.csv").items()}
    along = sum(track[f"Fv{axis}_N"]*track[f"v{axis}_m_s"] for axis in "xyz")/track["speed_m_s"]
    body = NACA(given["bodyLength"], given["thicknessRatio"])
    reynolds = given["liquidDensity"]*given["speed"]*body.length/given["liquidViscosity"]
    unit = given["liquidDensity"]/2*given["speed"]**2*body.wetted_area/given["bodyMass"]
    immersed = -float(np.interp(found["full immersion time"], track["time_s"], along))/given["bodyMass"]
    return {**given, **found, "viscous deceleration at full immersion": immersed,
            "viscous deceleration of a laminar flat plate": 1.328/sqrt(reynolds)*unit,
            "viscous deceleration of a turbulent flat plate": 0.075/(log10(reynolds) - 2)**2*unit}


REPORTED = {"impact deceleration": "m/s2", "peak deceleration": "m/s2", "velocity lost at full immersion": "m/s", **{
    f"viscous deceleration {of}": "m/s2" for of in ("at full immersion", "of a laminar flat plate", "of a turbulent flat plate")}}
study = Study(
    title="What an error of the liquid's density or viscosity does to the dive",
    runs=[Run("gannetPlunge", "meshes", name, resolution, (tier,), given={"options": options}) for name in (*FACTORS, KRAKEN)
          for resolution, tier, options in (("fast", "full", []), ("fast 0.5", "quick", ["-set", "travel=0.3"])) if tier == "full" or name in (PAPER, "density 105 %")],
    solve=solve, sources=("src/freeSurfaceFlow", "src/oversetMethods", "src/rigidBody", "src/boundaryLayer", "applications/solvers/plungeFoam"),
    quantities=[Quantity("liquid density", "kg/m3", lambda done: figures(done)["liquidDensity"]),
                Quantity("liquid viscosity", "Pa s", lambda done: figures(done)["liquidViscosity"]),
                *(Quantity(name, unit, lambda done, n=name: figures(done)[n]) for name, unit in REPORTED.items()),
                *(Quantity(f"change of {name}", "%", twin(lambda dive, paper, n=name: 100*(figures(dive)[n]/figures(paper)[n] - 1), variant=PAPER))
                  for name in REPORTED)],
    headlines=["change of velocity lost at full immersion"])
