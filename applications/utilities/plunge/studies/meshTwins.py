# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam breaks of plungeSPH in plungeFoam: the tutorial damBreak of OpenFOAM with another tank, mesh, water and walls. They tell what
is the method's from what is the walls' or the scene's.

limitedLinear takes no gradient from the wall, as linearUpwind does, which would rub like one on cells that are thicker than
the boundary layer."""
import subprocess
from pathlib import Path
from typing import Sequence, Tuple

from plunge.studies import REPOSITORY
from plunge.studies.particleRuns import CONTROL, call, isComplete, setEntry

SOLVER = "plungeFoam"
Box = Tuple[str, str, float]  # its least and its largest corner, and the share of water in its cells


def solve(run: Path, blocks: str, friction: str, water: Sequence[Box], gravity: str, functions: str,
          endTime: float) -> None:
    """Meshes and runs it, unless it is complete.

    blocks: vertices, blocks and boundary of blockMeshDict: patches whose names end with Wall, and atmosphere; friction: slip or
    noSlip; functions: function objects; endTime [s]."""
    if isComplete(run, SOLVER):
        return
    print(f"Running in {run}", flush=True)
    if not run.exists():
        subprocess.run([str(REPOSITORY / "validation/stockTutorials/setUp"), "-application", SOLVER, "-endTime", str(endTime),
                        "damBreak", str(run)], check=True, stdout=subprocess.DEVNULL)
        (run / "system/blockMeshDict").write_text("FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }\n"
                                                  + blocks)
        (run / "0/alpha.water").write_text((run / "0/alpha.water.orig").read_text())
        for field, wall, above in (("U", friction, "pressureInletOutletVelocity; value uniform (0 0 0)"),
                                   ("p_rgh", "fixedFluxPressure; value uniform 0", "totalPressure; p0 uniform 0"),
                                   ("alpha.water", "zeroGradient", "inletOutlet; inletValue uniform 0; value uniform 0")):
            setEntry(run, f"0/{field}", "boundaryField",
                     f'{{ ".*Wall" {{ type {wall}; }} atmosphere {{ type {above}; }} defaultFaces {{ type empty; }} }}')
        setEntry(run, "constant/g", "value", gravity)
        setEntry(run, "system/fvSchemes", "divSchemes/div(rhoPhi,U)", "Gauss limitedLinear 1")
        setEntry(run, "system/setFieldsDict", "regions", "( " + " ".join(
            f"boxToCell {{ box {low} {high}; fieldValues ( volScalarFieldValue alpha.water {share} ); }}" for low, high, share in water) + " )")
        for entry, value in (("maxCo", 0.5), ("maxAlphaCo", 0.5), ("functions", f"{{ {functions} }}")):
            setEntry(run, CONTROL, entry, value)
        call(run, "blockMesh")
        call(run, "setFields")
    call(run, SOLVER)
