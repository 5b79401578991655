# SPDX-License-Identifier: GPL-3.0-or-later
"""Every case and the stock tutorials, a few steps: they run, and the result is a flow."""
import re
from pathlib import Path
from typing import Tuple

import numpy as np
import pytest

from conftest import REPOSITORY
from tutorials import cellVolumes, compare, foam, setEntry, setUp, solve, steps

# How each case of plungeFoam runs a few steps.
CASES = {
    "gannetPlunge": ("-resolution", "0.7", "-set", "dive.travel=0.02", "-set", "output.frames=1"),
}

# Those of plungeSPH, with the options of each run.
PARTICLES = [("stillTank", ()), ("damBreakParticles", ()), ("damBreakParticles", ("-dimensions", 3)),
             ("yehPetroff", ("-spacing", 0.02)), ("kleefsman", ("-spacing", 0.055))]

# Those with a body that falls into the liquid: options, and the diameter over the speed at contact [s].
FALLING = [("fallingCylinder", ("-spacing", 0.011), 0.11/2.955), ("fallingCone", ("-spacing", 0.0065), 0.052/3.132),
           ("fallingCone", ("-spacing", 0.0065, "-angle", 25, "-drop", 1), 0.052/4.429)]


def test_all_cases_run() -> None:
    assert {path.parent.name for path in REPOSITORY.glob("cases/*/Allrun")} == {*CASES, *(case for case, *_ in PARTICLES + FALLING)}


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("case", sorted(CASES))
def test_case(case: str, ranks: int, tmp_path: Path) -> None:
    output = foam(REPOSITORY / "cases" / case / "Allrun", *CASES[case], "-np", ranks, "-run", tmp_path / "run", case=tmp_path)
    run = Path(re.search(r"^Running in (.*)$", output, re.MULTILINE).group(1))
    log = (run / "log.plungeFoam").read_text()
    assert len(steps(log)) >= 3 and re.search(r"^End$", log, re.MULTILINE)
    assert (ranks == 1) == (not list(run.glob("processor*")))
    checkDive(run, len(steps(log)))


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("case, options", PARTICLES)
def test_particles(case: str, options: Tuple[object, ...], threads: int, tmp_path: Path) -> None:
    """As its Allrun sets it up; a few hundred steps, in which little moves."""
    run = tmp_path / "run"
    allrun = REPOSITORY / "cases" / case / "Allrun"
    foam(allrun, *options, "-run", run, "-endTime", 0.02, "-threads", threads, case=tmp_path)
    assert re.search(r"^End$", (run / "log.plungeSPH").read_text(), re.MULTILINE)
    energy = np.genfromtxt(run / "postProcessing/energy/0/energy.csv", delimiter=",", names=True)
    assert energy["time_s"][-1] > 0.015 and 1e-4 < energy["max_speed_m_s"][-1] < 1
    assert (run / "VTK/particles.vtp.series").exists()


@pytest.mark.parametrize("case, options, time", FALLING)
def test_fallingBodies(case: str, options: Tuple[object, ...], time: float, tmp_path: Path) -> None:
    """As its Allrun sets it up, coarse: the body meets the liquid at time 0, and falls slower than freely from there on."""
    run = tmp_path / "run"
    foam(REPOSITORY / "cases" / case / "Allrun", *options, "-run", run, "-endTime", 0.5*time, "-threads", 1, case=tmp_path)
    assert re.search(r"^End$", (run / "log.plungeSPH").read_text(), re.MULTILINE)
    fall = np.genfromtxt(run / "postProcessing/trajectory/0/trajectory.csv", delimiter=",", names=True)
    assert abs(fall["penetration_m"][0]) < 0.005 and fall["penetration_m"][-1] > 0.3*fall["speed_m_s"][0]*time
    assert 0.5*fall["speed_m_s"][0] < fall["speed_m_s"][-1] < fall["speed_m_s"][0] + 0.8*9.81*fall["time_s"][-1]


@pytest.mark.parametrize("model", ["half", "full"])
def test_diveOfParticles(model: str, tmp_path: Path) -> None:
    """The dive's scene in plungeSPH, very coarse: the body falls, meets the liquid and is slowed; the report needs no mesh."""
    foam(REPOSITORY / "cases/gannetPlunge/Allrun", "-solver", "plungeSPH", "-model", model, "-resolution", "0.5", "-np", 2,
         "-set", "dive.travel=0.05", "-set", "output.frames=2", "-run", tmp_path / "run", case=tmp_path)
    run = tmp_path / "run"
    assert re.search(r"^End$", (run / "log.plungeSPH").read_text(), re.MULTILINE)
    dive = np.genfromtxt(run / "results/trajectory.csv", delimiter=",", names=True)
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
    for axis in "xyz":
        velocity = dive[f"v{axis}_m_s"]
        np.testing.assert_allclose(np.diff(velocity), dive[f"a{axis}_m_s2"][1:]*np.diff(time), atol=1e-8)
        # Semi-implicit Euler: each step with its new velocity
        np.testing.assert_allclose(np.diff(dive[f"{axis}_m"]), velocity[1:]*np.diff(time), atol=1e-8)
    np.testing.assert_allclose(np.hypot(np.hypot(dive["v1_m_s"], dive["v2_m_s"]), dive["v3_m_s"]), dive["speed_m_s"], rtol=1e-9)
    assert abs(dive["speed_m_s"][0] - 25) < 1e-9
    # Before contact only gravity and the gas act: no impulse at the start
    assert np.abs(dive["deceleration_m_s2"][time < 3e-4]).max() < 5
    assert np.abs(ledger["error_percent_of_body_volume"]).max() < 1


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
