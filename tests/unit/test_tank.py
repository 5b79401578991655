# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of tanks: what is refused, what is decided, the mesh, the tables."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

from conftest import REPOSITORY
from plunge import case, foamDictionary, tank
from plunge.methods.tanks import Blocks
from plunge.tankTables import tables

CASES = REPOSITORY / "cases"


def plungeCase(scene: Path, *arguments: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(["plungeCase", str(scene), *arguments], capture_output=True, text=True)


# Case, options, words of the message
MISTAKES = {
    "column outside the tank": ("damBreak", ("-set", "liquid.column.max=(0.15 0.15 0.7)"), ("liquid.column", "out of the tank", "(0.6 0.15 0.6)")),
    "column without height": ("damBreak", ("-set", "liquid.column.max=(0.15 0.15 0)"), ("liquid.column.max", "more than min")),
    "columns that overlap": ("yehPetroff", ("-set", "liquid.film.min=(0.3 0 0)"), ("liquid.film", "overlaps liquid.reservoir")),
    "obstacles that overlap": ("kleefsman", ("-set", "obstacles.crate.min=(2.5 0.5 0)", "-set", "obstacles.crate.max=(2.6 0.8 0.3)"),
                               ("obstacles.crate", "overlaps obstacles.container")),
    "obstacle outside the tank": ("kleefsman", ("-set", "obstacles.container.max=(2.5565 0.698 1.2)"), ("obstacles.container", "out of the tank")),
    "obstacle with a name that is taken": ("kleefsman", ("-set", "obstacles.tank.max=(0.1 0.1 0.1)"), ("obstacles.tank", "another name")),
    "nothing liquid": ("kleefsman", ("-set", "obstacles.container.min=(0 0 0)", "-set", "obstacles.container.max=(3 1 1)",),
                       ("liquid", "nothing liquid")),
    "gauge outside the tank": ("damBreak", ("-set", "gauges.H2=(0.7 0.075 0)"), ("gauges.H2", "outside the tank")),
    "probe outside the tank": ("damBreak", ("-set", "probes.P1=(0.6 0.2 0.02)"), ("probes.P1", "outside the tank")),
    "probe in an obstacle": ("kleefsman", ("-set", "probes.P1=(2.5 0.5 0.1)"), ("probes.P1", "inside obstacles.container")),
    "place in space of a tank in the plane": ("stillTank", ("-set", "gauges.middle=(0.5 0 0)"), ("gauges.middle", "(x z)")),
    "unknown entry": ("damBreak", ("-set", "liquids=3"), ("unknown entry 'liquids'", "liquid")),
    "unknown entry of the tank": ("damBreak", ("-set", "tank.depth=1"), ("tank", "unknown entry 'depth'", "size open walls")),
    "unknown entry of a column": ("damBreak", ("-set", "liquid.column.speed=1"), ("liquid.column", "unknown entry 'speed'")),
    "entry of a body": ("damBreak", ("-set", "entry.speed=3"), ("unknown entry 'entry'",)),
    "tank and body": ("damBreak", ("-set", "body.freedom=free"), ("'body' and 'tank' are both given", "obstacle")),
    "size of one number": ("damBreak", ("-set", "tank.size=(1)"), ("size", "(x y z)")),
    "size below zero": ("damBreak", ("-set", "tank.size=(1 1 -1)"), ("size", "above 0")),
    "unknown face": ("damBreak", ("-set", "tank.open=(roof)"), ("open", "roof", "top")),
    "list in the list of faces": ("damBreak", ("-set", "tank.open=((top))"), ("open", "((top))", "a list of faces")),
    "face that the plane does not have": ("stillTank", ("-set", "tank.open=(front top)"), ("tank.open", "front")),
    "unknown walls": ("damBreak", ("-set", "tank.walls=rough"), ("walls", "rough", "noSlip slip")),
    "no time": ("damBreak", ("-set", "duration=0"), ("duration", "above 0")),
    "no gravity": ("damBreak", ("-set", "fluids.gravity=0"), ("fluids", "gravity above 0")),
    "model of a body": ("damBreak", ("-model", "half"), ("-model half", "no body")),
    "plane with an obstacle": ("kleefsman", ("-model", "plane"), ("-model plane", "obstacles.container", "front to back")),
    "full in the plane": ("stillTank", ("-model", "full"), ("-model full", "two numbers")),
    "overset": ("damBreak", ("-mesh", "overset"), ("-mesh overset", "no body")),
    "laminar layer that is not resolved": ("damBreak", ("-boundaryLayer", "laminar"), ("-boundaryLayer laminar", "needs cells of")),
    "laminar layer on walls that slip": ("stillTank", ("-boundaryLayer", "laminar"), ("laminar", "slip")),
    "friction line": ("damBreak", ("-boundaryLayer", "frictionLine"), ("frictionLine", "laminar or none")),
    "speed of sound of meshes": ("damBreak", ("-soundSpeed", "30"), ("-soundSpeed", "particles")),
    "unknown entry of the tier": ("damBreak", ("-set", "tier.layers=4"), ("tank/tiers", "layers", "cellSpacing")),
    "closed tank of meshes": ("damBreak", ("-set", "tank.open=()"), ("tank.open", "face at least")),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_refused(name: str, tmp_path: Path) -> None:
    """With file, entry and what was expected; nothing is made."""
    scene, options, words = MISTAKES[name]
    done = plungeCase(CASES / scene, "-run", str(tmp_path / "run"), *options)
    assert done.returncode == 1 and done.stderr.startswith("plungeCase: ") and "expected" in done.stderr, done.stderr
    missing = [word for word in words if word not in done.stderr]
    assert not missing, f"{missing} not in {done.stderr}"
    assert not (tmp_path / "run").exists()


@pytest.mark.parametrize("text, words", [
    ("duration 1;", ("'body' and 'tank' are missing",)),
    ("tank { size (1 1); } fluids water; duration 1;", ("'liquid' is missing",)),
    ("tank { size (1 1); } liquid { } fluids water; duration 1;", ("'liquid'", "NAME")),
    ("tank { size (1 1); } liquid { pool { max (1 1); } } duration 1;", ("'fluids' is missing",)),
    ("tank { size (1 1); } liquid { pool { max (1 1); } } fluids water;", ("'duration' is missing",)),
    ("tank 3; liquid { pool { max (1 1); } } fluids water;", ("'tank' is 3", "size")),
])
def test_incomplete(text: str, words: "tuple[str, ...]", tmp_path: Path) -> None:
    (tmp_path / "scene").write_text(text)
    done = plungeCase(tmp_path / "scene", "-run", str(tmp_path / "run"))
    assert done.returncode == 1 and "expected" in done.stderr
    assert all(word in done.stderr for word in words), done.stderr


@pytest.mark.parametrize("method, of, count", [("meshes", "cells", 15*15*4), ("particles", "particles", None)])
def test_estimate(method: str, of: str, count: "int | None") -> None:
    """A probe that is as short as the scene; of a plane mesh, the number of cells is exact."""
    done = plungeCase(CASES / "damBreak", "-method", method, "-resolution", "0.5", "-set", "duration=0.2", "-np", "1", "-estimate")
    found = dict(line.split(None, 1) for line in done.stdout.splitlines())
    assert {of, "steps", "memory", "disk"} <= set(found) and "CPU" in found, done.stderr
    assert float(found["steps"].replace(",", "")) > 10
    if count:
        assert int(found[of].replace(",", "")) == count


def test_decisions() -> None:
    """Dimension, speed and method settings follow from the tank."""
    still, dam, box = (tank.read(CASES / name) for name in ("stillTank", "damBreak", "kleefsman"))
    assert [tank.model(scene, "auto").choice for scene in (still, dam, box)] == ["plane", "plane", "full"]
    assert still.still and not dam.still and not box.still
    # Without the entry that keeps the round number of the experiment: long waves, and Ritter's front
    assert tank.read(CASES / "damBreak", {"maxSpeed": 7}).max_speed == 7
    for scene, factor in ((still, 1), (dam, 2)):
        scene.given.pop("maxSpeed")
        assert scene.max_speed == pytest.approx(factor*np.sqrt(9.81*scene.depth))
    full = case.derive(CASES / "damBreak", {"method": "particles", "model": "full"}).flat
    plane = case.derive(CASES / "damBreak", {"method": "particles"}).flat
    assert (plane["particleSpacing"], full["particleSpacing"]) == pytest.approx((0.3/60, 0.3/20))
    assert plane["gravityVector"] == [0, -9.81, 0] and full["gravityVector"] == [0, 0, -9.81]
    assert plane["gaugePoints"]["H1"] == [0.075, 0, 0] and plane["probePoints"]["P1"] == [0.6, 0.02, 0]
    assert case.derive(CASES / "stillTank", {"method": "particles"}).flat["still"] == "yes"


def test_blocks() -> None:
    """Whole cells between all faces; none in the obstacle; places on faces are moved into the fluids."""
    scene = tank.read(CASES / "kleefsman")
    mesh = Blocks(scene, 0.055, False)
    assert mesh.faces[0] == pytest.approx([0, 1.228, 2.3955, 2.5565, 3.22]) and list(mesh.counts[0]) == [22, 21, 3, 12]
    assert mesh.cells == int(np.prod([counts.sum() for counts in mesh.counts])) - 3*7*3
    assert mesh.smallest == pytest.approx(0.161/3)
    x, y, z = mesh.inside(np.array([2.3955, 0.471, 0.021]))
    assert 2.3955 - 1e-3 < x < 2.3955 and (y, z) == (0.471, 0.021)
    x, y, z = mesh.inside(np.array([3.22, 0.0, 1.0]))
    assert x < 3.22 and y > 0 and z < 1
    column = mesh.column(np.array([0.582, 0.5, 0.0]))
    assert len(column) == mesh.counts[2].sum() and (np.diff(column[:, 2]) > 0).all()


def test_heights(tmp_path: Path) -> None:
    """Gauges of meshes: the highest surface in a column of cells, over a restart."""
    run = tmp_path / "run"
    case.write(case.derive(CASES / "damBreak"), run, {})
    heights = [0.05, 0.15, 0.25]
    header = "".join(f"# Probe {i} (0.1 0.1 {z})\n" for i, z in enumerate(heights)) + "# Probe 0 1 2\n# Time\n"
    for gauge, starts in (("H1", {"0": "0.1 1 1 0\n0.2 1 0.75 0.25\n", "0.2": "0.3 0 0 0\n"}), ("H2", {"0": "0.1 0 1 1\n0.2 1 0 0\n", "0.2": "0.3 1 0.6 0\n"})):
        for start, rows in starts.items():
            folder = run / "postProcessing" / f"gauge_{gauge}" / start
            folder.mkdir(parents=True)
            (folder / "alpha.liquid").write_text(header + rows)
    for name, values in (("p", "9"), ("U", "(1 2 3)"), ("alpha.liquid", "0.5")):
        (run / "postProcessing/probes/0").mkdir(parents=True, exist_ok=True)
        (run / "postProcessing/probes/0" / name).write_text(f"# Probe 0 (0.6 0 0.02)\n0.1 {values}\n")
    (run / "postProcessing/walls_tank/0").mkdir(parents=True)
    (run / "postProcessing/walls_tank/0/force.dat").write_text("# Force\n0.1 (1 0 -2) (1 0 -2) (0 0 0)\n0.2 (3 0")
    found = tables(run)
    assert found["gauges"]["time_s"] == pytest.approx([0.1, 0.2, 0.3])
    assert found["gauges"]["H1_m"] == pytest.approx([0.2, 0.2, 0]) and found["gauges"]["H2_m"] == pytest.approx([0.25, 0.1, 0.15 + 0.1/6])
    assert {key: list(values) for key, values in found["probes"].items()} == {
        "time_s": [0.1], "P1_p_Pa": [9], "P1_Ux_m_s": [1], "P1_Uz_m_s": [3], "P1_share": [0.5]}
    # A metre of it; the half line goes
    cell = foamDictionary.read(run / "system/plungeGenerated")["cellSpacing"]
    assert found["walls"]["tank_Fx_N_m"] == pytest.approx([1/cell]) and found["walls"]["tank_Fz_N_m"] == pytest.approx([-2/cell])


def test_dictionaries_in_lists() -> None:
    """Are written as they are read."""
    entries = {"boxes": [{"type": "box", "min": [0, 0.5], "open": ["top"]}, {"type": "box", "inner": {"a": 1}}], "points": {"H1": [1, 2]}}
    text = "".join(f"{key} {foamDictionary.format_value(value)}{'' if isinstance(value, dict) else ';'}\n" for key, value in entries.items())
    assert foamDictionary.parse(text, "text") == entries
