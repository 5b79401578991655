# SPDX-License-Identifier: GPL-3.0-or-later
"""ddtSchemes { default backward; }: flow, interface and body of second order in time."""
import math
from pathlib import Path

import numpy as np
import pytest

from plunge.results import gather
from plunge.studies import heavingSphere, planeBody
from tutorials import foam


def order(coarse: np.ndarray, middle: np.ndarray, fine: np.ndarray) -> float:
    """Observed, of histories whose steps halve."""
    return math.log2(np.linalg.norm(coarse - middle)/np.linalg.norm(middle - fine))


def test_heavingSphere(tmp_path: Path) -> None:
    """A body on the surface, on a mesh that deforms, with steps that vary: the height hardly depends on the step. With Euler's steps half
    the step changes it thirty times as much."""
    time = np.linspace(0.5, 8, 200)
    heights = []
    for step in (1, 0.5):
        heavingSphere.solve(tmp_path / f"{step}", 12, 0, end=8.5, step=step)
        heights.append(np.interp(time, *heavingSphere.height(tmp_path / f"{step}")))
    assert np.sqrt(np.mean((heights[0] - heights[1])**2)) < 1.5e-3


@pytest.mark.parametrize("ratio", (0.1, 1.0, 10.0))
def test_fromRest(ratio: float, tmp_path: Path) -> None:
    """A circle released from rest has its acceleration from the first step on, lighter and heavier than the fluid."""
    run = tmp_path / "run"
    planeBody.release(run, "plungeFoam", ratio, (12, 32), 0.1, {"system/fvSchemes": "ddtSchemes { default backward; }"})
    track = planeBody.track(run)
    acceleration = track["ay_m_s2"][1:]
    assert acceleration == pytest.approx(acceleration[-1], rel=0.01, abs=0.002)


def test_restart(tmp_path: Path) -> None:
    """A run that is stopped and started again repeats the one that went through."""
    whole, run = tmp_path / "whole", tmp_path / "parts"
    heavingSphere.solve(whole, 8, 0, end=3)
    heavingSphere.solve(run, 8, 0, end=2)
    parameters = run / "system/parameters"
    parameters.write_text(parameters.read_text().replace("end 2;", "end 3;"))
    control = run / "system/controlDict"
    control.write_text(control.read_text().replace("startFrom       startTime", "startFrom       latestTime"))
    foam("plungeFoam", case=run)
    once, again = (gather(path)["trajectory"] for path in (whole, run))
    assert len(once) == len(again)
    for column in ("z_m", "vz_m_s", "az_m_s2", "Fpz_N"):
        # Of twelve digits that are written
        np.testing.assert_allclose(again[column], once[column], rtol=1e-6, atol=1e-6*abs(once[column]).max())


def test_standingWave(tmp_path: Path) -> None:
    """The pressure under a standing wave of small amplitude, at the order of the scheme until the interface's own errors show."""
    time = np.linspace(0.2, 1.15, 200)
    pressures = []
    for steps in (100, 200, 400):
        run = tmp_path / f"{steps}"
        standingWave(run, steps)
        pressures.append(np.interp(time, *np.loadtxt(run / "postProcessing/probes/0/p").T))
    assert np.sqrt(np.mean((pressures[0] - pressures[1])**2)) < 0.006*np.ptp(pressures[2])
    assert order(*pressures) > 1.4


HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
END, CELLS = 1.2, 100       # [s], over half a wave of 1 m


def standingWave(run: Path, steps: int) -> None:
    """Half a wave of 1 m in water without viscosity, 0.5 m deep, of amplitude 0.02 m."""
    def write(file: str, kind: str, text: str) -> None:
        (run / file).parent.mkdir(parents=True, exist_ok=True)
        (run / file).write_text(HEADER.format(kind, Path(file).name) + text)

    def field(name: str, kind: str, dimensions: str, value: str, walls: str, top: str) -> None:
        write(f"0/{name}", f"vol{kind}Field", f"dimensions [{dimensions}]; internalField uniform {value};\n"
              f"boundaryField {{ walls {{ type {walls}; }} top {{ type {top}; }} sides {{ type empty; }} }}\n")

    corners = [f"({x} {y} {z})" for z in (-0.5, 0.25) for x, y in ((0, 0), (0.5, 0), (0.5, 0.02), (0, 0.02))]
    write("system/blockMeshDict", "dictionary", f"""vertices ({" ".join(corners)});
blocks (hex (0 1 2 3 4 5 6 7) ({CELLS} 1 {3*CELLS//2}) simpleGrading (1 1 1)); edges ();
boundary (walls {{ type wall; faces ((0 1 2 3) (0 4 7 3) (1 2 6 5)); }} top {{ type patch; faces ((4 5 6 7)); }}
sides {{ type empty; faces ((0 1 5 4) (3 2 6 7)); }});
""")
    field("U", "Vector", "0 1 -1 0 0 0 0", "(0 0 0)", "slip", "pressureInletOutletVelocity; value uniform (0 0 0)")
    field("p_rgh", "Scalar", "1 -1 -2 0 0 0 0", "0", "fixedFluxPressure", "totalPressure; p0 uniform 0")
    field("alpha.water", "Scalar", "0 0 0 0 0 0 0", "0", "zeroGradient", "inletOutlet; inletValue uniform 0; value uniform 0")
    write("constant/transportProperties", "dictionary", "phases (water air); sigma 0;\n" + "".join(
        f"{name} {{ transportModel Newtonian; nu 0; rho {rho}; }}\n" for name, rho in (("water", 1000), ("air", 1))))
    write("constant/turbulenceProperties", "dictionary", "simulationType laminar;\n")
    write("constant/g", "uniformDimensionedVectorField", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n")
    for name in ("fvSchemes", "fvSolution"):
        write(f"system/{name}", "dictionary", (heavingSphere.CASE / "system" / name).read_text().split("// *")[0])
    write("system/parameters", "dictionary", "cAlpha 0;\n")
    write("system/controlDict", "dictionary", f"""startFrom startTime; startTime 0; stopAt endTime; endTime {END}; deltaT {END/steps};
writeControl timeStep; writeInterval {steps}; timePrecision 12;
functions {{ probes {{ type probes; libs (sampling); fields (p); probeLocations ((0.0051 0.01 -0.2)); writeInterval 1; }} }}
""")
    write("system/setAlphaFieldDict", "dictionary", "field alpha.water; type sin; origin (0 0 0); period 1; phase -1.5707963267948966;"
          " amplitude 0.02; up (0 0 1); direction (1 0 0);\n")
    for command in ("blockMesh", "setAlphaField", "plungeFoam"):
        foam(command, case=run)
