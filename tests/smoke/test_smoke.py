# SPDX-License-Identifier: GPL-3.0-or-later
"""Every case and the stock tutorials, a few steps: they run, and the result is a flow."""
import re
from pathlib import Path
from typing import Tuple

import numpy as np
import pytest

from conftest import REPOSITORY
from tutorials import cellVolumes, compare, foam, setEntry, setUp, solve, steps

# Scenes without a body: method, options of the run.
TANKS = [
    ("stillTank", "particles", ("-resolution", 0.4)), ("stillTank", "meshes", ()),
    ("damBreak", "particles", ("-resolution", 0.5)), ("damBreak", "particles", ("-resolution", 0.5, "-np", 2)),
    ("damBreak", "meshes", ()), ("damBreak", "meshes", ("-np", 2)),
    ("damBreak", "particles", ("-model", "full")), ("damBreak", "meshes", ("-model", "full")),
    ("yehPetroff", "particles", ("-resolution", 0.75)), ("yehPetroff", "meshes", ()),
    ("kleefsman", "particles", ("-resolution", 0.5)), ("kleefsman", "meshes", ("-resolution", 0.5)),
]

CONE_25 = ("-set", "body.shape.halfAngle=25", "-set", "body.shape.length=0.3208", "-set", "body.mass=0.59078", "-set", "entry.drop=1")
# Those with a body that falls into the liquid: the diameter over the speed at contact [s].
FALLING = [
    ("fallingCylinder", "particles", ("-resolution", 0.4), 0.11/2.955), ("fallingCylinder", "meshes", ("-resolution", 0.5), 0.11/2.955),
    ("fallingCone", "particles", ("-resolution", 0.8), 0.052/3.132), ("fallingCone", "meshes", ("-resolution", 0.5), 0.052/3.132),
    ("fallingCone", "particles", ("-resolution", 0.8, *CONE_25), 0.052/4.429),
]

# Those with a body that is released in the liquid: how fast it falls over gravity, at first, and how near that comes so coarsely.
RELEASED = [
    ("addedMass", "meshes", ("-resolution", 0.5), 0.5, 9/11, 0.02), ("addedMass", "particles", ("-resolution", 0.25, "-set", "entry.depth=6"), 0.1, 9/11, 0.02),
    ("sphereDecay", "meshes", ("-resolution", 0.5), 0.3, None, None), ("sphereDecay", "particles", ("-resolution", 0.3), 0.3, None, None),
]


def runScene(case: str, run: Path, *options: object) -> str:
    """plungeCase and the Allrun that it makes; what both say."""
    said = foam("plungeCase", REPOSITORY / "cases" / case, "-np", 1, "-run", run, *options, case=run.parent, log="log.plungeCase")
    return said + foam(run / "Allrun", case=run.parent, log="log.Allrun")


def table(run: Path, name: str) -> np.ndarray:
    return np.genfromtxt(run / "results" / f"{name}.csv", delimiter=",", names=True)


def test_all_cases_run() -> None:
    """And a scene is all that a case has to have."""
    assert {path.parents[1].name for path in REPOSITORY.glob("cases/*/constant/scene")} == {
        "gannetPlunge", "astraeusPaper", *(case for case, *_ in TANKS + FALLING + RELEASED)}    # the paper's is run by its study's quick tier
    assert not list(REPOSITORY.glob("cases/*/All*"))


@pytest.mark.parametrize("case, method, options", TANKS)
def test_tanks(case: str, method: str, options: Tuple[object, ...], tmp_path: Path) -> None:
    """A few steps, in which little moves; by both methods the same tables."""
    run = tmp_path / "run"
    runScene(case, run, "-method", method, "-set", "duration=0.02", "-set", "interval=0.002", "-set", "frames=1", *options)
    if method == "particles":
        assert re.search(r"^End$", (run / "log.plungeSPH").read_text(), re.MULTILINE)
        energy = table(run, "energy")
        assert energy["time_s"][-1] > 0.015 and 1e-4 < energy["max_speed_m_s"][-1] < 1
        assert (run / "VTK/particles.vtp.series").exists()
    else:
        log = (run / "log.plungeFoam").read_text()
        assert re.search(r"^End$", log, re.MULTILINE) and "Mesh OK" in (run / "log.checkMesh").read_text()
        volumes = np.array(re.findall(r"^Phase-1 volume fraction = (\S+)  Min\(\S+\) = (\S+)  Max\(\S+\) = (\S+)", log, re.MULTILINE), float)
        assert np.ptp(volumes[:, 0]) < 1e-6 and volumes[:, 1].min() > -1e-3 and volumes[:, 2].max() < 1.001
    gauge, height = {"stillTank": ("middle_m", 0.5), "damBreak": ("H1_m", 0.3), "yehPetroff": ("reservoir_m", 0.3),
                     "kleefsman": ("H4_m", 0.55)}[case]
    assert table(run, "gauges")[gauge] == pytest.approx(height, rel=0.02)
    assert {"probes", "walls"} <= {path.stem for path in (run / "results").glob("*.csv")}


def test_weight(tmp_path: Path) -> None:
    """Liquid at rest in a tank of meshes: pressure and the force on the floor are those of its weight."""
    run = tmp_path / "run"
    runScene("stillTank", run, "-set", "duration=0.05")
    weight = 1000*9.81*0.5
    assert table(run, "walls")["tank_Fz_N_m"][-1] == pytest.approx(-weight, rel=1e-3)
    assert table(run, "walls")["tank_Fx_N_m"][-1] == pytest.approx(0, abs=1e-3*weight)
    # Of the middle of the cell that the probe is in
    assert table(run, "probes")["half_p_Pa"][-1] == pytest.approx(0.5*weight, rel=0.04)
    assert table(run, "probes")["half_share"][-1] == pytest.approx(1)


@pytest.mark.parametrize("case, method, options, time", FALLING)
def test_fallingBodies(case: str, method: str, options: Tuple[object, ...], time: float, tmp_path: Path) -> None:
    """Coarse: the body meets the liquid at once, and falls slower than freely from there on."""
    run = tmp_path / "run"
    runScene(case, run, "-method", method, "-set", f"duration={0.5*time:.4g}", "-set", "frames=2", *options)
    fall = table(run, "trajectory")
    assert abs(fall["penetration_m"][0]) < 0.005 and fall["penetration_m"][-1] > 0.3*fall["speed_m_s"][0]*time
    assert 0.5*fall["speed_m_s"][0] < fall["speed_m_s"][-1] < fall["speed_m_s"][0] + 0.8*9.81*fall["time_s"][-1]


@pytest.mark.parametrize("case, method, options, duration, share, tolerance", RELEASED)
def test_releasedBodies(case: str, method: str, options: Tuple[object, ...], duration: float, share: float, tolerance: float,
                        tmp_path: Path) -> None:
    """From rest: the body is as heavy as its weight less buoyancy, and as inert as its mass and what it sets in motion."""
    run = tmp_path / "run"
    runScene(case, run, "-method", method, "-set", f"duration={duration}", "-set", "frames=2", *options)
    fall = table(run, "trajectory")
    assert fall["speed_m_s"][0] == 0
    up = "y" if method == "particles" and case in ("addedMass", "sphereDecay") else "z"   # plungeSPH's plane, and that of its rings, is x and y
    acceleration = -fall[f"v{up}_m_s"][-1]/fall["time_s"][-1]
    if share is not None:
        assert acceleration == pytest.approx(share, rel=tolerance)
    else:
        # Lighter than in air by what it displaces, less of it than half a sphere; with an added mass of some half of that
        assert 0.1*9.81 < acceleration < 0.4*9.81


@pytest.mark.parametrize("ranks", [1, 2])
def test_dive(ranks: int, tmp_path: Path) -> None:
    run = tmp_path / "run"
    runScene("gannetPlunge", run, "-resolution", 0.7, "-set", "travel=0.02", "-set", "frames=1", "-np", ranks)
    log = (run / "log.plungeFoam").read_text()
    assert len(steps(log)) >= 3 and re.search(r"^End$", log, re.MULTILINE)
    assert (ranks == 1) == (not list(run.glob("processor*")))
    checkDive(run, len(steps(log)))


@pytest.mark.parametrize("model", ["half", "full"])
def test_diveOfParticles(model: str, tmp_path: Path) -> None:
    """The dive's scene in plungeSPH, very coarse: the body falls, meets the liquid and is slowed; the report needs no mesh."""
    run = tmp_path / "run"
    runScene("gannetPlunge", run, "-method", "particles", "-model", model, "-resolution", 0.5, "-np", 2, "-set", "travel=0.05",
             "-set", "frames=2")
    assert re.search(r"^End$", (run / "log.plungeSPH").read_text(), re.MULTILINE)
    dive = table(run, "trajectory")
    assert dive["speed_m_s"][0] == pytest.approx(25) and dive["penetration_m"][0] == pytest.approx(-0.01, abs=1e-3)
    assert dive["penetration_m"][-1] == pytest.approx(0.04, abs=2e-3)
    assert 0 < dive["speed_m_s"][0] - dive["speed_m_s"][-1] < 1
    # The weight of the whole body, also in the half model
    assert dive["Fgz_N"] == pytest.approx(-2.857*1.35, rel=1e-3)
    if model == "half":
        assert dive["vy_m_s"] == pytest.approx(0, abs=1e-12)
    assert not (run / "results/volumeLedger.csv").exists() and (run / "results/dive.png").exists()


def checkDive(run: Path, nSteps: int) -> None:
    """The tables of a dive's first steps: a line each, the motion consistent, the body still at speed, the ledger small."""
    read = lambda name: np.genfromtxt(run / "postProcessing" / name / "0" / f"{name}.csv", delimiter=",", names=True)
    dive, ledger = read("trajectory"), read("volumeLedger")
    assert len(dive) == len(ledger) == nSteps + 1
    time = dive["time_s"]
    step = np.diff(time)
    weight = step[1:]/(step[1:] + step[:-1])

    def derivative(values: np.ndarray) -> np.ndarray:
        """Of second order at the end of a step, but of the first one."""
        slope = np.diff(values)/step
        return slope[1:] + weight*(slope[1:] - slope[:-1])

    for axis in "xyz":
        velocity, acceleration = dive[f"v{axis}_m_s"], dive[f"a{axis}_m_s2"]
        assert acceleration[1]*step[0] == pytest.approx(velocity[1] - velocity[0], abs=1e-8)
        np.testing.assert_allclose(derivative(velocity), acceleration[2:], atol=1e-9*np.ptp(velocity)/step.min() + 1e-4)
        np.testing.assert_allclose(derivative(dive[f"{axis}_m"]), velocity[2:], atol=1e-6)
    np.testing.assert_allclose(np.hypot(np.hypot(dive["v1_m_s"], dive["v2_m_s"]), dive["v3_m_s"]), dive["speed_m_s"], rtol=1e-9)
    assert abs(dive["speed_m_s"][0] - 25) < 1e-9
    # Before contact only gravity and the gas act: no impulse at the start
    assert np.abs(dive["deceleration_m_s2"][time < 3e-4]).max() < 5
    assert np.abs(ledger["error_percent_of_body_volume"]).max() < 1e-6


def checkFlow(case: Path) -> None:
    """The liquid is bounded and something moves."""
    time = compare.times(case)[-1]
    liquid = compare.readCells(case / time / "alpha.water")
    assert -1e-3 < liquid.min() and liquid.max() < 1 + 1e-2 and liquid.max() > 0.9
    speed = np.linalg.norm(compare.readCells(case / time / "U"), axis=1)
    assert 1e-4 < speed.max() < 20, f"largest speed {speed.max()} m/s"


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("tutorial, endTime", [("damBreak", 0.02), ("floatingObject", 0.04), ("floatingBody", 0.004)])
def test_tutorial(tutorial: str, endTime: float, ranks: int, tmp_path: Path) -> None:
    case = setUp(tutorial, tmp_path / tutorial, "-application", "plungeFoam", "-coarser", 4 if tutorial == "floatingBody" else 2,
                 "-endTime", endTime, "-writeInterval", endTime)
    output = solve(case, "plungeFoam", ranks)
    assert len(steps(output)) >= 3
    checkFlow(case)


def test_isoAdvector(tmp_path: Path) -> None:
    """The geometric scheme keeps the interface between the fluids within a cell or two, and the volume exactly."""
    case = setUp("damBreak", tmp_path / "damBreak", "-application", "plungeFoam", "-coarser", 2, "-endTime", 0.1, "-writeInterval", 0.05)
    (case / "constant/sceneProperties").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object sceneProperties; }\ninterface isoAdvector;\n")
    assert "interface isoAdvector" in solve(case, "plungeFoam")
    cellVolumes(case)
    checkFlow(case)
    volumes, smeared = zip(*((np.sum(liquid*volume), np.mean((liquid > 0.01) & (liquid < 0.99)))
                             for time in compare.times(case)
                             for liquid, volume in [(compare.readCells(case / time / "alpha.water"), compare.readCells(case / time / "V"))]))
    initial = compare.readCells(case / "0/alpha.water")
    expected = np.sum(initial*compare.readCells(case / compare.times(case)[0] / "V"))
    assert max(abs(volume/expected - 1) for volume in volumes) < 1e-6
    assert max(smeared) < 0.15


def test_profile(tmp_path: Path) -> None:
    """The table of `profiling { active true; }`: stages by their time, whose sum is that of the run."""
    case = setUp("damBreak", tmp_path / "damBreak", "-coarser", 2, "-application", "plungeFoam", "-endTime", 0.02)
    setEntry(case, "system/controlDict", "profiling", "{ active true; }")
    log = solve(case, "plungeFoam")
    table = log[log.index("Profile over"):]
    assert table.startswith(f"Profile over {len(steps(log))} time steps")
    rows = re.findall(r"^ *\d+ +(\S+) +\d+ +\S+ +\S+   (.+)$", table, re.MULTILINE)
    time = {name: float(value) for value, name in rows}
    total = time.pop("total")
    assert {"pressure", "interface", "momentum"} <= set(time) and "overset stencil" not in time
    assert sum(time.values()) == pytest.approx(total, rel=0.01)
    listed = list(time.values())[:-1]    # then all others
    assert listed == sorted(listed, reverse=True)
