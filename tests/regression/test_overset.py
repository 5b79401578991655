# SPDX-License-Identifier: GPL-3.0-or-later
"""Overset meshes where they meet their limits: planes and wedges, domains that end, closed tanks, many processes."""
import re
from pathlib import Path
from typing import Dict, Tuple

import numpy as np
import pytest

import oversetCase
from tutorials import compare, foam, run, steps

LEDGER = "volumeLedger { type volumeLedger; libs (plungeFunctionObjects); bodyVolume 0.004; }"


def solveTo(case: Path) -> str:
    return foam("plungeFoam", case=case, log="log.solver")


@pytest.mark.parametrize("across", ["x", "y", "z", "wedge"])
def test_ledgerOfAMovingBox(across: str, tmp_path: Path) -> None:
    """At 4 m/s through a plane across any axis, or along a wedge, full of liquid or half full: what the zones cover is never counted
    wrong, so that fringe conserved acts on what the interpolation does alone."""
    case = oversetCase.write(tmp_path / "case", across=across, velocity=(4, 0.3 if across != "wedge" else 0), deltaT=0.002, endTime=0.06,
                             functions=LEDGER, scene="fringe conserved;", surface=10 if across == "wedge" else 0)
    solveTo(case)
    [path] = case.glob("postProcessing/volumeLedger/*/*.csv")
    table = np.genfromtxt(path, delimiter=",", names=True)
    assert np.abs(table["error_percent_of_body_volume"]).max() < 1


def stopped(case: Path, *words: str) -> str:
    """The run stops with a message that holds these words, a time that is written, and no complete end."""
    done = run("plungeFoam", case=case, log="log.solver")
    assert done.returncode != 0 and "FOAM FATAL ERROR" in done.stdout and not re.search("^End$", done.stdout, re.M), done.stdout[-2000:]
    message = done.stdout[done.stdout.index("FOAM FATAL ERROR"):]
    for word in words:
        assert word in message, message[:2000]
    time = re.search(r"^Time: (\S+) s", message, re.M)
    assert time, message[:2000]
    assert (case / time[1] / "U").exists() and (case / time[1] / "polyMesh/points").exists(), time[1]
    return message


@pytest.mark.parametrize("method", ["rigidZones", "inverseDistance; searchBox (-1 -1 -1)(1 1 1); searchBoxDivisions (40 1 40)"])
@pytest.mark.parametrize("velocity", [(0, -4), (4, 1)])
def test_leavingTheBackground(velocity: Tuple[float, float], method: str, tmp_path: Path) -> None:
    case = oversetCase.write(tmp_path / "case", velocity=velocity, deltaT=0.01, endTime=0.6, method=method)
    message = stopped(case, "zone 1", "leaves the background", "larger")
    # When its mesh reaches the boundary, 0.6 m away
    time = float(re.search(r"^Time: (\S+) s", message, re.M)[1])
    assert time == pytest.approx(0.6/4, abs=0.03)
    # A restart from there goes no further
    if method == "rigidZones":
        again = run("plungeFoam", case=case, log="log.again")
        assert again.returncode != 0 and "leaves the background" in again.stdout and not steps(again.stdout)


def test_meetingAnotherZone(tmp_path: Path) -> None:
    case = oversetCase.write(tmp_path / "case", bodies=((0, 0), (-0.85, 0)), background=(-1.5, 1, -1, 1), velocity=(-4, 0), deltaT=0.005, endTime=0.6)
    message = stopped(case, "zones 1 and 2", "overlap", "rigidZones")
    time = float(re.search(r"^Time: (\S+) s", message, re.M)[1])
    assert time < 0.05


def test_zonesThatOverlap(tmp_path: Path) -> None:
    """At the start: refused."""
    case = oversetCase.write(tmp_path / "case", bodies=((0, 0), (-0.7, 0)), background=(-1.5, 1, -1, 1), deltaT=0.005, endTime=0.6)
    done = run("plungeFoam", case=case, log="log.solver")
    assert done.returncode != 0 and "overlap" in done.stdout and not steps(done.stdout)


REFERENCES = {
    "cell of the overset boundary": "pRefCell 0;",
    "liquid": "pRefPoint (-0.75 0 -0.75);",
    "gas": "pRefPoint (0.7 0 0.8);",
    "where cells meet": "pRefPoint (-0.7 0 0.8);",
    "covered by the body's mesh": "pRefPoint (0.32 0 0.01);",
    "where the body comes": "pRefPoint (0.01 0 -0.13);",
}


@pytest.mark.parametrize("bodyFirst", [True, False])
@pytest.mark.parametrize("name", REFERENCES)
def test_closedTank(name: str, bodyFirst: bool, tmp_path: Path) -> None:
    """Walls all round, two fluids: a body that sinks does the same wherever the pressure has its reference."""
    if not bodyFirst and name == "cell of the overset boundary":
        pytest.skip("a corner of the background")
    case = oversetCase.write(tmp_path / "case", sides="closed", mass=60, velocity=(0, -0.5), pimple=REFERENCES[name] + " pRefValue 0;", deltaT=0.004,
                             endTime=0.08, bodySpacing=0.1, reach=0.5, bodyFirst=bodyFirst, functions=oversetCase.TRAJECTORY)
    log = solveTo(case)
    assert len(steps(log)) == 20
    [path] = case.glob("postProcessing/**/trajectory.csv")
    table = np.genfromtxt(path, delimiter=",", names=True)
    # Up is x. What the interpolation makes of fluid is spread over the tank, not put where the reference is
    assert table["vx_m_s"][-1] == pytest.approx(FALL[0], rel=2e-4) and table["ax_m_s2"][-1] == pytest.approx(FALL[1], rel=2e-3)


# Speed and acceleration at the end [m/s, m/s2], of the reference in the gas
FALL = -0.631025, -2.73357


@pytest.mark.parametrize("reference, named", [("pRefPoint (0.01 0 0.02);", "pRefPoint"), ("pRefPoint (3 0 0);", "pRefPoint"),
                                              ("pRefCell 100000;", "pRefCell")])
def test_referenceWhereThereIsNoFluid(reference: str, named: str, tmp_path: Path) -> None:
    case = oversetCase.write(tmp_path / "case", sides="closed", mass=60, pimple=reference + " pRefValue 0;", deltaT=0.004, endTime=0.08,
                             bodySpacing=0.1, reach=0.5)
    done = run("plungeFoam", case=case, log="log.solver")
    assert done.returncode != 0 and not steps(done.stdout)
    assert f"Entry {named}" in done.stdout and "Expected" in done.stdout, done.stdout[-2000:]


def test_thinOverlap(tmp_path: Path) -> None:
    """Zones that overlap by two cells, about a body that is held: acceptors that take from others have what those were given, and not what
    their own equations made of the holes beside them (0.75 m/s in calculated cells then)."""
    case = oversetCase.write(tmp_path / "case", spacing=0.05, bodySpacing=0.05, reach=0.2, deltaT=0.005, endTime=0.02, control="writeInterval 4;",
                             method="inverseDistance; searchBox (-1 -1 -1)(1 1 1); searchBoxDivisions (20 1 20)")
    solveTo(case)
    assert np.linalg.norm(compare.readCells(case / "0.02/U"), axis=1).max() < 0.2


@pytest.mark.parametrize("method, reach, cells", [("rigidZones", 0.2, 2), ("rigidZones", 0.25, 3), ("rigidZones", 0.3, 0),
                                                  ("inverseDistance; searchBox (-1 -1 -1)(1 1 1); searchBoxDivisions (20 1 20)", 0.3, 4),
                                                  ("inverseDistance; searchBox (-1 -1 -1)(1 1 1); searchBoxDivisions (20 1 20)", 0.35, 0)])
def test_cellsOfTheBackgroundAboutABody(method: str, reach: float, cells: int, tmp_path: Path) -> None:
    """With three cells of rigidZones a sinking box had half of its acceleration, with four of inverseDistance the tank diverged: it is told."""
    case = oversetCase.write(tmp_path / "case", sides="closed", mass=60, velocity=(0, -0.5), spacing=0.05, bodySpacing=0.05, reach=reach, deltaT=0.004,
                             endTime=0.004, pimple="pRefPoint (-0.73 0.001 0.41); pRefValue 0;", method=method)
    log = solveTo(case)
    note = re.findall(r"^Note: Between the body of overset zone 1 and the outer boundary of its mesh there are (\S+) cells", log, re.M)
    assert [float(count) for count in note] == ([pytest.approx(cells)] if cells else [])


def decomposed(case: Path, n: Tuple[int, int, int], target: Path) -> Path:
    """A copy of the case that has been run on so many processes in x, y and z."""
    foam("cp", "-r", case, target, case=case)
    ranks = int(np.prod(n))
    if ranks == 1:
        solveTo(target)
        return target
    (target / "system/decomposeParDict").write_text(
        oversetCase.HEADER.format("dictionary", "decomposeParDict") +
        f"numberOfSubdomains {ranks}; method simple; simpleCoeffs {{ n ({n[0]} {n[1]} {n[2]}); delta 0.001; }}")
    foam("decomposePar", case=target, log="log.decompose")
    foam("mpirun", "-np", ranks, "plungeFoam", "-parallel", case=target, log="log.solver")
    foam("reconstructPar", "-latestTime", case=target, log="log.reconstruct")
    return target


@pytest.mark.parametrize("across", ["y", "space"])
def test_anyDecomposition(across: str, tmp_path: Path) -> None:
    """Meshes that are aligned, so that centres lie on faces and corners of other cells, on 1 to 16 processes: the same cells are donors,
    and the flow is that of one process. Some processes have few faces of the boundary, or acceptors for others alone."""
    size = {"y": dict(velocity=(1, 0.5), deltaT=0.02, endTime=0.08),
            "space": dict(velocity=(1, 0.5), deltaT=0.025, endTime=0.05, spacing=0.25, bodySpacing=0.125, size=0.25, reach=0.5)}[across]
    case = oversetCase.write(tmp_path / "case", across=across, **size, control="writeControl runTime; writeInterval 0.01;")
    splits = ((1, 1, 1), (2, 1, 1), (4, 1, 2), *(((4, 1, 1), (4, 1, 4)) if across == "y" else ()))
    runs = {n: decomposed(case, n, tmp_path / "x".join(map(str, n))) for n in splits}
    of: Dict[str, np.ndarray] = {}
    for n, directory in runs.items():
        # The linear solvers stop elsewhere
        for field, tolerance in (("cellTypes", 0), ("U", 3e-6), ("alpha.water", 1e-7)):
            values = compare.readCells(directory / f"{size['endTime']:g}" / field)
            reference = of.setdefault(field, values)
            assert np.abs(values - reference).max() <= tolerance, (field, n)
