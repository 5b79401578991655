# SPDX-License-Identifier: GPL-3.0-or-later
"""plungeSPH: rest, collapse, twins, restart, and input that is wrong."""
import json
import os
import re
import shutil
import signal
import subprocess
import time
from pathlib import Path
from typing import Dict, Tuple

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from conftest import REPOSITORY
from tutorials import checkRefused, copy, foam, setEntry
from tutorials import run as runProgram
from plunge.studies.particleRuns import CONTROL, PROPERTIES, series, setUp
from plunge.studies.particleRuns import particles as readParticles
from plunge.stl import write_stl
from plunge.studies.references import reference as published

WATER, GRAVITY = 1000, 9.81


def case(name: str, run: Path, entries: Dict[str, object] = {}, **control: object) -> Path:
    """A scene with other entries, coarse: the still tank on 50 by 25 particles."""
    return setUp(name, run, {**({"geometry/spacing": 0.02} if name == "stillTank" else {}), **entries}, **control)


def table(run: Path, name: str, start: str = "0") -> np.ndarray:
    return np.genfromtxt(run / "postProcessing" / name / start / f"{name}.csv", delimiter=",", names=True)


def checkpoint(run: Path, name: str, dimensions: int = 2) -> Tuple[np.ndarray, np.ndarray]:
    """Numbers (position, velocity, acceleration, density, mass, pressure) and walls of a state."""
    header, _, data = (run / name / "particles").read_bytes().partition(b"\n\n")
    n = int(re.search(rb"^particles (\d+)", header, re.MULTILINE).group(1))
    nNumbers = n*(3*dimensions + 3)
    return np.frombuffer(data, "<f8", nNumbers), np.frombuffer(data, "<i4", n, 8*nNumbers)


def polyData(run: Path, name: str, index: int) -> vtk.vtkPolyData:
    """A time of a series, as ParaView reads it."""
    files = json.loads((run / f"VTK/{name}.vtp.series").read_text())["files"]
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(run / "VTK" / files[index]["name"]))
    reader.Update()
    output = reader.GetOutput()
    assert output.GetFieldData().GetArray("TimeValue").GetValue(0) == pytest.approx(files[index]["time"])
    return output


def particles(run: Path, index: int = -1) -> Dict[str, np.ndarray]:
    """What ParaView shows of a time of the series."""
    time, file = series(run)[index]
    fields = readParticles(file)
    assert fields["time"] == pytest.approx(time)
    return fields


def pressureAtRest(depth: np.ndarray, c0: float) -> np.ndarray:
    """Of the liquid as it is compressed by its weight: dp/dz = rho g with Murnaghan's rho(p), gamma 7 [Pa]."""
    k0 = WATER*c0**2/7
    return k0*((1 + 6/7*WATER*GRAVITY*depth/k0)**(7/6) - 1)


def test_stillTank(tmp_path: Path) -> None:
    """Below the surface layer (a support) hydrostatic pressure to 1 %; next to no motion; no energy from nothing."""
    run = case("stillTank", tmp_path / "run", endTime=0.5, writeInterval=0.25)
    foam("plungeSPH", "-threads", 1, case=run)
    C0 = 22
    now = particles(run)
    deep = (now["wall"] < 0) & (now["x"][:, 1] < 0.5 - 0.06)
    hydrostatic = pressureAtRest(0.5 - now["x"][deep, 1], C0)
    assert deep.sum() > 1000
    assert np.abs(now["p"][deep] - hydrostatic).max() < 0.01*WATER*GRAVITY*0.5
    energy = table(run, "energy")
    assert len(energy) == 51
    # The surface settles by a fraction of a spacing first
    assert energy["max_speed_m_s"][25:].max() < 0.01*np.sqrt(GRAVITY*0.5)
    assert energy["c0_at_least_10_max_speed_so_far"].all()
    total = energy["kinetic_J"] + energy["potential_J"] + energy["internal_J"]
    assert total.max() < total[0] + 1e-4*energy["potential_J"][0]
    assert table(run, "walls")["tank_Fy_N_m"][-1] == pytest.approx(-WATER*GRAVITY*0.5, rel=0.01)
    assert np.abs(table(run, "gauges")["middle_m"] - 0.5).max() < 0.01
    assert table(run, "probes")["half_p_Pa"][-1] == pytest.approx(WATER*GRAVITY*0.25, rel=0.01)


@pytest.fixture(scope="module")
def dam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A coarse dam break in double precision, to 0.2 s on one thread; its walls slip, as contact's do."""
    run = case("damBreak", tmp_path_factory.mktemp("dam") / "whole",
               {"geometry/spacing": 0.01, "precision": "double", "walls": "slip"}, endTime=0.2, writeInterval=0.1, purgeWrite=0)
    foam("plungeSPH", "-threads", 1, case=run)
    return run


def test_threads(dam: Path) -> None:
    """Two threads give the state of one, bit for bit."""
    twin = case("damBreak", dam.parent / "threads",
                {"geometry/spacing": 0.01, "precision": "double", "walls": "slip"}, endTime=0.1, writeInterval=0.1)
    foam("plungeSPH", "-threads", 2, case=twin)
    np.testing.assert_array_equal(checkpoint(twin, "0.1")[0], checkpoint(dam, "0.1")[0])


def test_restart(dam: Path) -> None:
    """From the state at 0.1 s, the state at 0.2 s and the tables between."""
    twin = copy(dam, "restarted")
    for old in ("0.2", "postProcessing"):
        shutil.rmtree(twin / old)
    foam("plungeSPH", "-threads", 1, case=twin)
    whole, again = (checkpoint(run, "0.2") for run in (dam, twin))
    np.testing.assert_array_equal(whole[1], again[1])
    np.testing.assert_allclose(again[0], whole[0], rtol=1e-10, atol=1e-10*np.abs(whole[0]).max())
    for name in ("energy", "walls", "gauges", "probes"):
        after = table(dam, name)[-len(table(twin, name, "0.1")) + 1:]
        for column in after.dtype.names:
            np.testing.assert_allclose(table(twin, name, "0.1")[column][1:], after[column], rtol=1e-8, atol=1e-9)
    assert [time for time, _ in series(twin)] == [0, 0.1, 0.2]


def test_front(dam: Path) -> None:
    """The front is ahead of Martin and Moyce's, whose gate took time, and behind Ritter's, which has no friction; the column
    falls; energy only falls. How far off the front is, validation/studies/damBreakFront judges."""
    energy = table(dam, "energy")
    total = energy["kinetic_J"] + energy["potential_J"] + energy["internal_J"]
    assert np.diff(total).max() < 1e-4*energy["potential_J"][0]
    last = particles(dam)
    fluid = last["x"][last["wall"] < 0]
    reference = published("MartinMoyce1952", "front")
    wide = reference["a_in"] == 2.25
    expected = np.interp(0.2*np.sqrt(2*GRAVITY/0.15), reference["T"][wide], reference["Z"][wide])
    ritter = 1 + 2*np.sqrt(GRAVITY*0.3)*0.2/0.15
    assert expected < (fluid[:, 0].max() + 0.005)/0.15 < ritter
    heights = table(dam, "gauges")["H1_m"]
    assert heights[0] == pytest.approx(0.3) and heights[-1] < 0.25
    # Nothing leaks
    assert (fluid[:, :2] > 0).all()


def test_kill(tmp_path: Path) -> None:
    """Killed while it writes after every step, it goes on from a state that is whole."""
    run = case("stillTank", tmp_path / "run", endTime=100, writeControl="timeStep", writeInterval=1)
    setEntry(run, CONTROL, "purgeWrite", 3)
    for _ in range(3):
        with subprocess.Popen(["plungeSPH", "-threads", "1"], cwd=run, env={**os.environ, "PWD": str(run)},
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as solver:
            time.sleep(1.5)
            assert solver.poll() is None, solver.stderr.read()
            solver.send_signal(signal.SIGKILL)
    last = max((path for path in run.iterdir() if re.fullmatch(r"[0-9.e+-]+", path.name)), key=lambda path: float(path.name))
    setEntry(run, CONTROL, "endTime", float(last.name) + 0.001)
    output = foam("plungeSPH", "-threads", 1, case=run)
    assert f"from {last}/particles" in output.replace('"', "") and re.search(r"^End$", output, re.MULTILINE)


def test_outrun(tmp_path: Path) -> None:
    """A speed of sound that the flow outruns is allowed, warned of once, and marked."""
    run = case("damBreak", tmp_path / "run", {"geometry/spacing": 0.015, "speedOfSound/maxSpeed": 0.5},
               endTime=0.2, writeInterval=0.2)
    output = foam("plungeSPH", "-threads", 1, case=run)
    assert output.count("c0 >= 10 v_max does not hold") == 1
    marked = table(run, "energy")["c0_at_least_10_max_speed_so_far"]
    assert marked[0] == 1 and marked[-1] == 0 and (np.diff(marked) <= 0).all()


def test_notFinite(tmp_path: Path) -> None:
    """A number that is not finite: stops, and says where to go on from."""
    run = case("damBreak", tmp_path / "run", {"geometry/spacing": 0.015, "Courant": 20}, endTime=1, writeInterval=0.001)
    with pytest.raises(AssertionError, match="last good state"):
        foam("plungeSPH", "-threads", 1, case=run)


def volume(shape: vtk.vtkPolyData) -> float:
    triangles, properties = vtk.vtkTriangleFilter(), vtk.vtkMassProperties()
    triangles.SetInputData(shape)
    properties.SetInputConnection(triangles.GetOutputPort())
    return properties.GetVolume()


# Springs at walls, which slip
SPRINGS = {"contact": "{ stiffness node; factor 0.1; }", "walls": "slip"}


def bodyCase(directory: Path, entries: Dict[str, object] = {}, **control: object) -> Path:
    """A tank with a box that floats, and a surface and a sphere that fall, in three dimensions."""
    run = case("damBreak", directory, {
        "dimensions": 3, "geometry/spacing": 0.05, "outputs": "{ interval 0.01; }",
        "geometry/fluid": "( { type box; min (0 0 0); max (1 0.5 0.3); } )",
        "geometry/walls": "( { name tank; type box; min (0 0 0); max (1 0.5 1); open (top); }"
                          " { name float; type box; solid yes; min (0.1 0.15 0.3); max (0.3 0.35 0.5); }"
                          " { name wedge_1; type surface; file wedge.stl; }"
                          " { name ball; type sphere; centre (0.45 0.25 0.6); radius 0.1; } )",
        "bodies": "{ float { mass 4; momentOfInertia (0.03 0.03 0.03); centreOfMass (0.2 0.25 0.4);"
                  " solver { type symplectic; } }"
                  " wedge_1 { mass 6; momentOfInertia (0.05 0.05 0.05); centreOfMass (0.7 0.25 0.6);"
                  " angularMomentum (0 0.02 0); solver { type symplectic; } }"
                  " ball { mass 4; momentOfInertia (0.02 0.02 0.02); centreOfMass (0.45 0.25 0.6);"
                  " solver { type symplectic; } } }",
        **entries}, **{"endTime": 0.04, "writeInterval": 0.02, **control})
    setEntry(run, "constant/g", "value", "(0 0 -9.81)")
    corners = np.array([(0.6, 0.15, 0.7), (0.8, 0.15, 0.7), (0.7, 0.15, 0.5), (0.6, 0.35, 0.7), (0.8, 0.35, 0.7), (0.7, 0.35, 0.5)])
    triangles = [(0, 1, 2), (3, 5, 4), (0, 3, 4), (0, 4, 1), (1, 4, 5), (1, 5, 2), (2, 5, 3), (2, 3, 0)]
    (run / "wedge.stl").write_text("solid wedge\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in corners[list(triangle)])
        + "endloop\nendfacet\n" for triangle in triangles) + "endsolid wedge\n")
    return run


def test_bodies(tmp_path: Path) -> None:
    """Each body has its trajectory, and its surface where the trajectory says it is, before and after a restart."""
    run = bodyCase(tmp_path / "run", endTime=0.02)
    foam("plungeSPH", "-threads", 1, case=run)
    setEntry(run, CONTROL, "endTime", 0.04)
    foam("plungeSPH", "-threads", 1, case=run)
    for name, cells in (("float", 6), ("wedge_1", 8), ("ball", 2208)):
        path = np.concatenate([np.genfromtxt(run / "postProcessing" / f"trajectory_{name}" / start / "trajectory.csv",
                                             delimiter=",", names=True) for start in ("0", "0.02")])
        assert [entry["time"] for entry in json.loads((run / f"VTK/{name}.vtp.series").read_text())["files"]] == [0, 0.02, 0.04]
        shapes = [polyData(run, name, index) for index in range(3)]
        assert all(shape.GetNumberOfPolys() == cells for shape in shapes)
        volumes = {"float": 0.2**3, "wedge_1": 0.2**3/2, "ball": 4/3*np.pi*0.1**3}
        assert all(volume(shape) == pytest.approx(volumes[name], rel=0.01) for shape in shapes)
        corners = [vtk_to_numpy(shape.GetPoints().GetData()).astype(float) for shape in shapes]
        for index, time_ in enumerate((0, 0.02, 0.04)):
            line = path[np.argmin(np.abs(path["time_s"] - time_))]
            centre = np.array([line[f"{c}_m"] for c in "xyz"])
            # Rigid, about the centre of mass
            np.testing.assert_allclose(np.linalg.norm(corners[index] - centre, axis=1),
                                       np.linalg.norm(corners[0] - [path[0][f"{c}_m"] for c in "xyz"], axis=1), atol=1e-6)
        fallen = corners[2].mean(axis=0) - corners[0].mean(axis=0)
        assert fallen[2] < -0.25*GRAVITY*0.04**2 and np.abs(fallen[:2]).max() < 1e-3
        if name == "wedge_1":
            assert np.ptp(np.sort(corners[2][:, 2])[-4:]) > 1e-3, "the wedge does not turn"


@pytest.mark.parametrize("contact", [False, True], ids=["particles", "contact"])
def test_circle(contact: bool, tmp_path: Path) -> None:
    """In two dimensions a circle half as heavy as the liquid falls in, and stays in the liquid's plane."""
    run = case("stillTank", tmp_path / "run", {
        "geometry/walls": "( { name tank; type box; min (0 0 0); max (1 0.7 0); open (top); }"
                          " { name log; type sphere; centre (0.5 0.6 0); radius 0.08; } )",
        "bodies": f"{{ log {{ mass {0.5*WATER*np.pi*0.08**2}; momentOfInertia (0.1 0.1 0.1); centreOfMass (0.5 0.6 0);"
                  " solver { type symplectic; } } }",
        **(SPRINGS if contact else {})}, endTime=0.3, writeInterval=0.1)
    foam("plungeSPH", "-threads", 1, case=run)
    shape = polyData(run, "log", 3)
    points = vtk_to_numpy(shape.GetPoints().GetData())
    assert shape.GetNumberOfPolys() == 1 and len(points) == 48 and (points[:, 2] == 0).all()
    path = table(run, "trajectory")
    np.testing.assert_allclose(points.mean(axis=0)[1], path["y_m"][-1], atol=1e-5)
    # It is under water by a part, and bears less than its weight only while it falls
    assert 0.42 < path["y_m"][-1] < 0.58 and path["Fpy_N"].max() > 0.5*WATER*np.pi*0.08**2*GRAVITY


def formulation(run: Path, neighbours: int) -> None:
    """What docs/particles.md says of the paper's formulation, at the end of a case, with other than 500 neighbours."""
    text = (REPOSITORY / "docs/particles.md").read_text().split("## The paper's formulation")[1].split("```")[1]
    path = run / PROPERTIES
    assert "neighbours          500;" in text
    path.write_text(path.read_text() + text.replace("500", str(neighbours)))


def test_paperFormulation(tmp_path: Path) -> None:
    """The formulation of IAC-20-E2.1.9 on Titan: its k0; the energy budget holds, also over a restart, and eq. 2 follows the
    equation of state."""
    run = case("damBreak", tmp_path / "run", {"geometry/spacing": 0.01}, endTime=0.4, writeInterval=0.2, purgeWrite=0)
    # 500 reach as far as the column is wide
    formulation(run, 60)
    setEntry(run, "constant/g", "value", "(0 -1.35 0)")
    output = foam("plungeSPH", "-threads", 1, case=run)
    k0, c0 = (float(re.search(rf"{name} = (\S+) ", output).group(1)) for name in ("c0\\^2/gamma", "c0"))
    assert k0 == pytest.approx(100*1.35*664/7, rel=1e-4) and c0 == pytest.approx(10*np.sqrt(1.35), rel=1e-4)
    assert "momentum fluid" in output and "Mach number: 0," in output
    energy = table(run, "energy")
    assert energy["internal_eq2_J"][0] == pytest.approx(energy["internal_J"][0])
    kinetic = energy["kinetic_J"][-1]
    assert np.ptp(energy["budget_J"]) < 1e-3*kinetic
    # Without density diffusion eq. 2 is the equation of state's energy
    assert np.abs(energy["internal_eq2_J"] - energy["internal_J"]).max() < 1e-3*kinetic
    assert (np.diff(energy["dissipated_J"]) >= 0).all() and energy["dissipated_J"][-1] > 0
    twin = copy(run, "restarted")
    for old in ("0.4", "postProcessing"):
        shutil.rmtree(twin / old)
    foam("plungeSPH", "-threads", 1, case=twin)
    again = table(twin, "energy", "0.2")
    for column in ("internal_eq2_J", "dissipated_J", "budget_J"):
        np.testing.assert_allclose(again[column][1:], energy[column][-len(again) + 1:], rtol=1e-5)
    assert vtk_to_numpy(polyData(run, "particles", -1).GetPointData().GetArray("heat")).max() > 0


SPEEDS = {
    "depth": ({}, "{ depth 0.5; }", 10*np.sqrt(GRAVITY*0.5)),
    "bulkModulus": ({}, "{ bulkModulus 2.25e9; }", 1500),
    "liquid": ({"liquid": "{ fluid Kraken; }"}, "{ liquid yes; }", None),
}


@pytest.mark.parametrize("name", SPEEDS)
def test_speedOfSound(name: str, tmp_path: Path) -> None:
    """Each way to say the speed of sound; that of a liquid of the library is the one that the log says of it."""
    entries, speed, expected = SPEEDS[name]
    run = case("stillTank", tmp_path / "run", {**entries, "speedOfSound": speed}, endTime=1e-6, writeInterval=1e-6)
    output = foam("plungeSPH", "-threads", 1, case=run)
    expected = expected or float(re.search(r"soundSpeed (\S+) ", output).group(1))
    assert float(re.search(r"c0 = (\S+) m/s", output).group(1)) == pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize("entries", ({"densityDiffusion": "Antuono"}, {"shifting": "{}"}))
def test_stillTankBy(entries: Dict[str, str], tmp_path: Path) -> None:
    """Hydrostatic pressure and next to no motion by the other choices too."""
    run = case("stillTank", tmp_path / "run", entries, endTime=0.5, writeInterval=0.5)
    foam("plungeSPH", "-threads", 1, case=run)
    now = particles(run)
    deep = (now["wall"] < 0) & (now["x"][:, 1] < 0.5 - 0.06)
    assert np.abs(now["p"][deep] - pressureAtRest(0.5 - now["x"][deep, 1], 22)).max() < 0.01*WATER*GRAVITY*0.5
    assert table(run, "energy")["max_speed_m_s"][25:].max() < 0.01*np.sqrt(GRAVITY*0.5)


def test_contact(dam: Path) -> None:
    """Springs at the walls in place of particles: the front of the dam break is that with particles to 3 %, nothing leaks in
    0.5 s, energy only falls."""
    run = case("damBreak", dam.parent / "contact",
               {"geometry/spacing": 0.01, "precision": "double", **SPRINGS},
               endTime=0.5, writeInterval=0.1, purgeWrite=0)
    output = foam("plungeSPH", "-threads", 1, case=run)
    assert "450 of the fluid, 0 of walls" in output
    for index in (1, 2):
        front, expected = (shown["x"][shown["wall"] < 0, 0].max() for shown in (particles(run, index), particles(dam, index)))
        assert front == pytest.approx(expected, rel=0.03)
    for index in range(6):
        x, y = particles(run, index)["x"][:, :2].T
        assert len(x) == 450 and x.min() > 0 and x.max() < 0.6 and y.min() > 0
    energy = table(run, "energy")
    assert energy["contact_J"].max() > 0
    total = energy["kinetic_J"] + energy["potential_J"] + energy["internal_J"] + energy["contact_J"]
    assert np.diff(total).max() < 1e-3*energy["potential_J"][0]
    assert "contact_J" not in table(dam, "energy").dtype.names
    # The weight, but for what still falls
    assert table(run, "walls")["tank_Fy_N_m"][0] == 0
    assert -table(run, "walls")["tank_Fy_N_m"].mean() == pytest.approx(WATER*GRAVITY*0.15*0.3, rel=0.3)


def test_contactRestart(tmp_path: Path) -> None:
    """With bodies, stopped and restarted is not stopped; both bodies feel the liquid, and what they feel is in both tables."""
    entries = {**SPRINGS, "contact/maxDepth": 2, "precision": "double", "bodies/wedge_1/velocity": "(0 0 -1.5)"}
    run = bodyCase(tmp_path / "whole", entries, endTime=0.16, writeInterval=0.08, purgeWrite=0)
    foam("plungeSPH", "-threads", 1, case=run)
    twin = copy(run, "restarted")
    for old in ("0.16", "postProcessing"):
        shutil.rmtree(twin / old)
    foam("plungeSPH", "-threads", 2, case=twin)
    whole, again = (checkpoint(directory, "0.16", 3) for directory in (run, twin))
    np.testing.assert_array_equal(whole[0], again[0])
    for name in ("float", "wedge_1"):
        path = np.genfromtxt(run / "postProcessing" / f"trajectory_{name}" / "0" / "trajectory.csv", delimiter=",", names=True)
        after = np.genfromtxt(twin / "postProcessing" / f"trajectory_{name}" / "0.08" / "trajectory.csv", delimiter=",", names=True)
        assert after[-1] == path[-1]
        walls = table(run, "walls")
        assert path["Fpz_N"].max() > 1, name
        assert walls[f"{name}_Fz_N"][-1] == pytest.approx(path["Fpz_N"][-1])
        assert (path["Fvz_N"] == 0).all()


MISTAKES = {
    "unknown entry": (("smothingLength", "1.5"), ("smothingLength", "smoothingLength")),
    "dimensions": (("dimensions", "4"), ("dimensions", "4", "2 or 3")),
    "unknown kernel": (("kernel", "gauss"), ("kernel", "gauss", "WendlandC2")),
    "alpha that is not used": (("viscosity", "none"), ("alpha", "artificial")),
    "negative density": (("liquid/rho", "-1"), ("rho", "positive")),
    "spacing of zero": (("geometry/spacing", "0"), ("spacing",)),
    "c0 and maxSpeed": (("speedOfSound/c0", "30"), ("c0", "maxSpeed", "one of them")),
    "smoothing length": (("smoothingLength", "0.5"), ("spacing",)),
    "neighbours and smoothing length": (("neighbours", "30"), ("neighbours", "smoothingLength", "one of them")),
    "depth and maxSpeed": (("speedOfSound/depth", "0.5"), ("maxSpeed", "depth", "one of them")),
    "speed of sound of an unknown liquid": (("speedOfSound", "{ liquid yes; }"), ("liquid", "composition")),
    "unknown entry of shifting": (("shifting", "{ strength 2; }"), ("strength", "coefficient")),
    "a gas": (("liquid", "{ fluid titanAir; }"), ("titanAir", "liquid")),
    "contact with an unknown wall": (("geometry/walls", "( { name tank; type cone; } )"), ("type", "cone", "sphere"),
                                     {"contact": "{ stiffness node; factor 0.1; }"}),
    "friction in contact": (("walls", "noSlip"), ("walls", "noSlip", "slip"), {"contact": "{ stiffness node; factor 0.1; }"}),
    "contact without stiffness": (("contact", "{ factor 0.1; }"), ("contact", "stiffness")),
    "contact of unknown stiffness": (("contact", "{ stiffness soft; factor 0.1; }"), ("soft", "node")),
    "contact without factor": (("contact", "{ stiffness node; }"), ("contact", "factor")),
    "contact of a segment without material": (("contact", "{ stiffness segment; factor 0.1; }"), ("contact", "bulkModulus")),
    "material without segments": (("contact", "{ stiffness node; factor 0.1; thickness 1; }"), ("thickness", "segment")),
    "negative depth": (("contact", "{ stiffness node; factor 0.1; maxDepth -1; }"), ("maxDepth", "positive")),
    "probe off the plane": (("outputs/probes/half", "(0 0 1)"), ("half", "z = 0")),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_badInput(name: str, tmp_path: Path) -> None:
    entry, named, *others = MISTAKES[name]
    checkRefused("plungeSPH", case("stillTank", tmp_path / "run", dict([entry], **others[0] if others else {})),
                 ("particleProperties",) + named)


BODY = "mass 4; momentOfInertia (1 1 1); centreOfMass (0.2 0.25 0.4); solver { type symplectic; }"
BODY_MISTAKES = {
    "body that is no wall": ("bodies/rudder", "{ " + BODY + " }", ("rudder", "no wall", "wedge_1")),
    "tank that moves": ("bodies/tank", "{ " + BODY + " }", ("tank", "cannot move", "solid")),
    "mass of zero": ("bodies/float/mass", "0", ("float", "mass", "positive")),
    "mass that is missing": ("bodies/float", "{ " + BODY.replace("mass 4;", "") + " }", ("float", "mass")),
    "inertia of zero": ("bodies/float/momentOfInertia", "(0 1 1)", ("float", "momentOfInertia", "positive")),
    "unknown entry of a body": ("bodies/float/weight", "3", ("float", "weight")),
}


@pytest.mark.parametrize("name", BODY_MISTAKES)
def test_badBody(name: str, tmp_path: Path) -> None:
    entry, value, named = BODY_MISTAKES[name]
    checkRefused("plungeSPH", bodyCase(tmp_path / "run", {entry: value}), ("particleProperties",) + named)


def leak(run: Path) -> None:
    """Takes the last triangle away."""
    text = (run / "wedge.stl").read_text()
    (run / "wedge.stl").write_text(text[:text.rindex("facet normal")] + "endsolid wedge\n")


@pytest.mark.parametrize("contact", [False, True], ids=["particles", "contact"])
def test_badSurface(contact: bool, tmp_path: Path) -> None:
    """A surface of a body that leaks, or is not there."""
    entries = SPRINGS if contact else {}
    run = bodyCase(tmp_path / "leaks", entries)
    leak(run)
    checkRefused("plungeSPH", run, ("particleProperties", "wedge.stl", "leaks", "watertight"))
    run = bodyCase(tmp_path / "missing", entries)
    (run / "wedge.stl").unlink()
    checkRefused("plungeSPH", run, ("particleProperties", "file", "wedge.stl", "Expected"))


@pytest.mark.parametrize("contact", [False, True], ids=["particles", "contact"])
def test_bodyInFluid(contact: bool, tmp_path: Path) -> None:
    """Fluid where a body is is left out, and counted in the log."""
    run = bodyCase(tmp_path / "run", {
        "geometry/fluid": "( { type box; min (0 0 0); max (1 0.5 0.5); } )",
        **(SPRINGS if contact else {})}, endTime=0.001, writeInterval=0.001)
    output = foam("plungeSPH", "-threads", 1, case=run)
    # The box takes 4 cells in each direction; the wedge's tip is at the surface, and so is the ball's lowest point
    assert "fluid: 1936, removed 64 in or near walls" in output


@pytest.mark.parametrize("contact", [False, True], ids=["particles", "contact"])
def test_fastBody(contact: bool, tmp_path: Path) -> None:
    """A body that is faster than the speed of sound bears is warned of at the start, and marked."""
    entries = SPRINGS if contact else {}
    run = bodyCase(tmp_path / "run", {"bodies/wedge_1/velocity": "(0 0 -10)", **entries}, endTime=0.002, writeInterval=0.002)
    output = foam("plungeSPH", "-threads", 1, case=run)
    assert output.index("c0 >= 10 v_max does not hold") < output.index("Starting time loop")
    assert (table(run, "energy")["c0_at_least_10_max_speed_so_far"] == 0).all()


def test_brokenState(dam: Path) -> None:
    """A truncated state is not gone on from."""
    run = copy(dam, "truncated")
    file = run / "0.2/particles"
    file.write_bytes(file.read_bytes()[:-100])
    setEntry(run, CONTROL, "endTime", 0.3)
    checkRefused("plungeSPH", run, ("0.2/particles", "expected"))


def test_lake(tmp_path: Path) -> None:
    """A liquid by its name."""
    run = case("stillTank", tmp_path / "run", {"liquid": "{ fluid Kraken; }", "viscosity": "laminar", "walls": "noSlip"},
               endTime=0.002, writeInterval=0.002)
    path = run / PROPERTIES
    path.write_text(re.sub(r"\nalpha .*", "", path.read_text()))
    output = foam("plungeSPH", "-threads", 1, case=run)
    density, viscosity = map(float, re.search(r"Liquid: density (\S+) kg/m3, viscosity (\S+) Pa s", output).groups())
    assert 450 < density < 680 and 1e-4 < viscosity < 2e-3


def test_surfacesThatAreNone(tmp_path: Path) -> None:
    """Two cubes through each other are refused with their triangles; a part inside out is turned, and the log says which; a
    binary file may start with "solid"."""
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
    faces = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
    cube = np.vstack((faces[:, [0, 1, 2]], faces[:, [0, 2, 3]]))

    def body(name: str, second: np.ndarray, wound: slice) -> Path:
        run = case("stillTank", tmp_path / name, {
            "dimensions": 3, "geometry/spacing": 0.05, "outputs": "{ interval 0.01; }",
            "geometry/fluid": "( { type box; min (0 0 0); max (1 0.5 0.2); } )",
            "geometry/walls": "( { name log; type surface; file log.stl; } )"}, endTime=1e-6, writeInterval=1e-6)
        setEntry(run, "constant/g", "value", "(0 0 -9.81)")
        write_stl(run / "log.stl", np.vstack((0.2*corners + [0.2, 0.15, 0.3], second)), np.vstack((cube, 8 + cube[:, wound])))
        data = (run / "log.stl").read_bytes()
        (run / "log.stl").write_bytes(b"solid log".ljust(80) + data[80:])
        return run

    forwards, backwards = slice(None), slice(None, None, -1)
    apart, through, flush = ([shift, 0.15, 0.3] + 0.2*corners for shift in (0.6, 0.3, 0.3))
    through = through + [0, 0.05, 0.05]
    for name, second in (("through", through), ("flush", flush)):
        run = body(name, second, forwards)
        checkRefused("plungeSPH", run, ["log.stl", "passes through itself", "of its 24 triangles", "from 0 the triangles"])
    output = foam("plungeSPH", "-threads", 1, case=body("turned", apart, backwards))
    assert "12 of 24 triangles turned" in output and "from 0 the triangles 12-23" in output
    assert float(re.search(r"of the shape (\S+) m3", output).group(1)) == pytest.approx(2*0.2**3, rel=1e-5)


@pytest.mark.parametrize("contact", [False, True], ids=["particles", "contact"])
def test_bodyThroughTheFloor(contact: bool, tmp_path: Path) -> None:
    """A heavy circle sinks to the floor: the run writes its state there and stops with what met, where and when."""
    run = case("stillTank", tmp_path / "run", {
        "geometry/walls": "( { name tank; type box; min (0 0 0); max (1 0.7 0); open (top); }"
                          " { name log; type sphere; centre (0.5 0.2 0); radius 0.08; } )",
        "bodies": f"{{ log {{ mass {20*WATER*np.pi*0.08**2}; momentOfInertia (9 9 9); centreOfMass (0.5 0.2 0); velocity (0 -1 0);"
                  " solver { type symplectic; } } }",
        **(SPRINGS if contact else {})}, endTime=0.3, writeInterval=0.3)
    done = runProgram("plungeSPH", "-threads", 1, case=run)
    assert done.returncode != 0 and "End\n" not in done.stdout
    found = re.search(r"The body log meets the wall tank at \((\S+) (\S+) 0\) m, at (\S+) s", done.stdout)
    # Not before it would fall through an ideal fluid without bounds, (20 - 1)/(20 + 1) g, the 0.12 m to the floor
    assert found and abs(float(found.group(2))) < 0.005 and 0.0866 < float(found.group(3)) < 0.1
    path = table(run, "trajectory")
    assert 0.075 < path["y_m"][-1] < 0.08
    written = [p for p in run.iterdir() if (p / "particles").is_file()]
    assert [float(p.name) for p in written] == [pytest.approx(path["time_s"][-1], rel=1e-5)]


def test_newtonsLaw(tmp_path: Path) -> None:
    """A circle of a hundredth of the liquid's density, in single precision: m a is the force of each line of its table, and it
    rises as in an ideal fluid."""
    mass, radius = 0.01*WATER*np.pi*0.12**2, 0.12
    run = case("stillTank", tmp_path / "run", {
        "geometry/spacing": 0.02, "speedOfSound": "{ c0 28; }",
        "geometry/fluid": "( { type box; min (0 0 0); max (2.4 1.6 0); } )",
        "geometry/walls": "( { name tank; type box; min (0 0 0); max (2.4 1.7 0); open (top); }"
                          f" {{ name log; type sphere; centre (1.2 0.8 0); radius {radius}; }} )",
        "outputs": "{ interval 0.05; }",
        "bodies": f"{{ log {{ mass {mass}; momentOfInertia (1 1 1); centreOfMass (1.2 0.8 0); solver {{ type symplectic; }} }} }}"},
        endTime=0.1, writeInterval=0.1)
    foam("plungeSPH", "-threads", 1, case=run)
    path = table(run, "trajectory")
    force = path["Fpy_N"] + path["Fvy_N"] - mass*GRAVITY
    np.testing.assert_allclose(mass*path["ay_m_s2"], force, atol=1e-4*mass*GRAVITY)
    ideal = 0.99/1.01*GRAVITY
    assert np.interp(0.05, path["time_s"], path["vy_m_s"]) == pytest.approx(ideal*0.05, rel=0.06)
    # It falls behind: docs/particles.md
    assert path["vy_m_s"][-1] == pytest.approx(ideal*0.1, rel=0.12)
