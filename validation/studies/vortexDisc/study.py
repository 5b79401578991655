# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc that a vortex draws out into a spiral and winds back: what the advection of the interface costs in accuracy.

OpenFOAM's tutorial discInReversedVortexFlow (Rider and Kothe 1998) on a uniform mesh, with steps of Courant number 0.4. After 8 s the disc
should be what it was: the error is the area between the two, in the unit of the square's side. The flow is given, so that nothing but the
interface scheme is at work. plicRDF (Scheufler and Roenby 2019) is there where OpenFOAM has it, from v2006 on."""
import os
import shutil
from pathlib import Path

import numpy as np

from plunge.studies.foamFields import readCells, times
from plunge.studies.particleRuns import CONTROL, call, override
from plunge.studies.scenes import once
from plunge.studies.stockCases import coarsen
from plunge.studies.study import Done, Quantity, Run, Study
from plunge.studies.tutorials import installed

TUTORIAL = "interIsoFoam/discInReversedVortexFlow"
ALPHA = "alpha.water"
END, COURANT = 8, 0.4
TUTORIAL_CELLS = 100
# Of the scene and of the volume fraction
SCHEMES = {"MULES": ("MULES", "nAlphaCorr 2; cAlpha 1;"), "isoAdvector": ("isoAdvector", "")}
if int(os.environ.get("FOAM_API", 0)) >= 2006:
    SCHEMES["isoAdvector plicRDF"] = ("isoAdvector", "reconstructionScheme plicRDF;")


def solve(run: Run, path: Path) -> None:
    cells = run.given["cells"]
    interface, controls = SCHEMES[run.variant]

    def make() -> None:
        folder = path.with_name(f"{path.name}.tutorial")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(installed() / TUTORIAL, folder)
        for file in (folder, *folder.rglob("*")):
            file.chmod(file.stat().st_mode | 0o200)
        shutil.copytree(folder / "0.orig", folder / "0")
        coarsen(folder / "system/blockMeshDict", TUTORIAL_CELLS/cells)
        (folder / "constant/sceneProperties").write_text(
            f"FoamFile {{ version 2.0; format ascii; class dictionary; object sceneProperties; }}\ninterface {interface};\n")
        override(folder, "system/fvSolution", f'solvers {{ "alpha.*" {{ {controls} }} }}')
        override(folder, CONTROL, f"application plungeFoam; deltaT {COURANT/cells!r}; endTime {END}; writeInterval {END}; writeFormat ascii;")
        for program in ("blockMesh", "setAlphaField"):
            call(folder, program)
        shutil.copy(folder / "0" / ALPHA, folder / "start")
        folder.rename(path)

    once(path, make)
    call(path, "plungeFoam")


def error(done: Done) -> float:
    start, end = (readCells(file).ravel() for file in (done.path / "start", done.path / times(done.path)[-1] / ALPHA))
    return float(np.sum(np.abs(end - start))/done.run.given["cells"]**2)


study = Study(
    title="The area by which a disc differs after a vortex has drawn it out and wound it back",
    runs=[Run("vortexDisc", "meshes", scheme, f"{1/cells:g} m", ("quick", "full") if cells == 32 else ("full",), given={"cells": cells})
          for scheme in SCHEMES for cells in (32, 64, 128)],
    solve=solve, sources=("src/freeSurfaceFlow/interfaceScheme",),
    quantities=[Quantity("area between the discs at the start and at the end", "m2", error, converges=True)],
    headlines=["area between the discs at the start and at the end"])
