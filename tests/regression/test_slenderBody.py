# SPDX-License-Identifier: GPL-3.0-or-later
"""slenderBody: Kirchhoff's equations, the dive beside what the 3D solver found, cones beside their trials, tails, lakes, samples, and
input that is wrong."""
import csv
import re
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from conftest import REPOSITORY
from tutorials import checkRefused, foam, run as runProgram, runScene
from plunge.results import gather, read_notes, read_numbers
from plunge.shapes.ellipsoid import ellipsoid_added_mass

DIVE = REPOSITORY / "cases/gannetPlunge"
METHOD = ("-method", "slenderBody")
IDEAL = """body { shape { type spheroid; length 2; diameter 0.4; } density 1000; freedom free; }
fluids { liquid water; gas earthAir; liquidDensity 1000; gravity 9.81; }
entry { speed 3; angle 5; attitude 9; depth 50; spin (0.4 0.1 -0.2); }
duration 4;
"""


def solved(run: Path, scene: object, *options: object) -> Path:
    """A run without its report."""
    foam("plungeCase", scene, *METHOD, "-run", run, *options, case=run.parent, log="log.plungeCase")
    foam("slenderBody", case=run, log="log.slenderBody")
    return run


def settings(run: Path, text: str) -> None:
    """Entries that take the place of the case's."""
    (run / "constant/slenderBodySettings").write_text(text)


def test_aNeutralSpheroidFollowsKirchhoffsEquations(tmp_path: Path) -> None:
    """In an ideal liquid, with gravity, which its buoyancy balances, against scipy's integration with Lamb's added masses."""
    scene = tmp_path / "scene"
    scene.write_text(IDEAL)
    run = tmp_path / "run"
    foam("plungeCase", scene, *METHOD, "-run", run, "-boundaryLayer", "none", case=tmp_path, log="log.plungeCase")
    settings(run, "crossFlow off; tolerance 1e-11;")
    foam("slenderBody", case=run)
    found = gather(run)["trajectory"]

    a, b = 1.0, 0.2
    displaced = 1000*4/3*np.pi*a*b*b
    translation, rotation = ellipsoid_added_mass(a, b, b)
    inertia = displaced/5*np.array([2*b*b, a*a + b*b, a*a + b*b])
    M, I = displaced*(1 + translation), inertia*(1 + rotation)

    def rate(_: float, y: np.ndarray) -> np.ndarray:
        v, w = y[:3], y[3:]
        return np.concatenate((-np.cross(w, M*v)/M, (-np.cross(w, I*w) - np.cross(v, M*v))/I))

    start = [found[f"v{i}_m_s"][0] for i in (1, 2, 3)] + [found[f"omega{i}_rad_s"][0] for i in (1, 2, 3)]
    exact = solve_ivp(rate, (0, 4), start, t_eval=found["time_s"], rtol=1e-11, atol=1e-12).y
    for i, name in enumerate(("v1_m_s", "v2_m_s", "v3_m_s", "omega1_rad_s", "omega2_rad_s", "omega3_rad_s")):
        assert np.abs(found[name] - exact[i]).max() < 2e-3*np.abs(exact[i]).max() + 1e-9, name
    assert np.ptp(found["v3_m_s"]) > 1, "it has not turned"


def test_theTitanDiveIsThatOfThe3DSolver(tmp_path: Path) -> None:
    """Within the uncertainty that was measured for it (cases/gannetPlunge/constant/uncertainty.csv), or half as much again, nothing tuned; the pitch is not."""
    run = tmp_path / "run"
    output = runScene(DIVE, run, *METHOD)
    numbers = read_numbers(run / "results/summary.csv")
    with (DIVE / "constant/uncertainty.csv").open(newline="") as file:
        rows = {row["quantity"]: (float(row["value"]), float(row["total_uncertainty"])) for row in csv.DictReader(file)
                if row["fluids"] == "titan"}
    for name, allowed in (("impact deceleration", 1.5), ("peak deceleration", 1), ("full immersion time", 1),
                          ("velocity lost at full immersion", 1.5)):
        value, uncertainty = rows[name]
        assert abs(numbers[name][0] - value) < allowed*uncertainty, name
    assert any("taken to be attached" in note for note in read_notes(run / "results/summary.csv"))
    assert (run / "results/trajectory.png").exists() and "Not modelled" in output
    energy = gather(run)["energy"]
    assert np.abs(energy["imbalance_J"]).max() < 1e-6*energy["kinetic_J"][0]
    assert "done: slenderBody" in foam(run / "Allrun", case=tmp_path)


@pytest.mark.parametrize("angle, drop, length, mass, measured, allowed", [
    (25, 1.0, 0.3208, 0.59078, 0.4021, 0.05), (45, 0.5, 0.2910, 0.58968, 1.2591, 0.06)])
def test_conesHaveTheMeasuredPeak(tmp_path: Path, angle: float, drop: float, length: float, mass: float, measured: float,
                                  allowed: float) -> None:
    speed = np.sqrt(2*9.81*drop)
    run = solved(tmp_path/"run", REPOSITORY/"cases/fallingCone", *(word for entry in (
        f"body.shape.halfAngle={angle}", f"body.shape.length={length}", f"body.mass={mass}", f"entry.drop={drop}",
        f"duration={1.5*0.026/np.tan(np.radians(angle))/speed}") for word in ("-set", entry)))
    C = 2*mass*(gather(run)["trajectory"]["az_m_s2"] + 9.81)/(997*np.pi*0.026**2*speed**2)
    assert C.max() == pytest.approx(measured, rel=allowed)
    assert "a cavity, from" in (run/"log.slenderBody").read_text()


def test_aTailHoldsTheAxisToThePath(tmp_path: Path) -> None:
    options = ("-set", "entry.attitude=73", "-set", "duration=1")
    turned = {}
    for name, tail in (("none", ()), ("tail", ("-set", "body.tail={ volumeCoefficient 1.5; }"))):
        table = gather(solved(tmp_path/name, DIVE, *options, *tail))["trajectory"]
        path = np.degrees(np.arctan2(table["vz_m_s"], table["vx_m_s"]))
        turned[name] = abs(table["pitch_deg"][-1] - path[-1])
    assert turned["none"] > 20 and turned["tail"] < 1
    # Neither a mesh nor particles have it
    done = runProgram("plungeCase", DIVE, "-run", tmp_path/"meshes", "-set", "body.tail={ volumeCoefficient 1; }", case=tmp_path)
    assert done.returncode == 0 and "plungeFoam leaves it out" in done.stdout


def test_floatsBackToTheSurface(tmp_path: Path) -> None:
    """A light body on its way down and up again; the event is that of its rise."""
    run = solved(tmp_path/"run", DIVE, "-set", "body.density=300", "-set", "until=surfaced", "-set", "entry.angle=90", "-set", "body.freedom=axial")
    table, extent = gather(run)["trajectory"], gather(run)["extent"]
    assert "Event surfaced" in (run/"log.slenderBody").read_text()
    assert abs(extent["high_m"][-1]) < 1e-4 and table["vz_m_s"][-1] > 0 and table["penetration_m"].max() > 5


@pytest.mark.parametrize("entries, note", [
    ({}, "there is no ricochet, which spheres of this density have below"), ({"entry.angle": 90}, ""), ({"body.freedom": "axial"}, ""),
    ({"entry.depth": 2}, ""), ({"entry.angle": 90, "entry.attitude": -90}, "a tail that enters first has none"),
    ({"entry.angle": 90, "fluids.liquidViscosity": 100}, "below 1000 there is no boundary layer")])
def test_whatAnEntryLacksIsSaid(entries: dict, note: str, tmp_path: Path) -> None:
    """Each where it applies, and only there."""
    (tmp_path/"scene").write_text("body { shape { type spheroid; length 1; diameter 0.2; } density 900; freedom free; }\n"
                                  "fluids { liquid water; gas earthAir; }\nentry { speed 5; angle 30; }\nduration 0.001;\n")
    run = solved(tmp_path/"run", tmp_path/"scene", *(word for name, value in entries.items() for word in ("-set", f"{name}={value}")))
    said = (run/"log.slenderBody").read_text()
    found = [each for each in ("no ricochet", "enters first", "no boundary layer") if each in said]
    assert len(found) == bool(note) and note in said


def test_stratifiedLakesBearBodiesAtTheirDepth(tmp_path: Path) -> None:
    """A body that is as heavy as the liquid at some depth comes to rest there."""
    scene = tmp_path/"scene"
    scene.write_text("""body { shape { type spheroid; length 1; diameter 0.2; } density 580; freedom axial; }
fluids { liquid Kraken; gas titanAir; temperature 92; surfacePressure 1.467e5; gravity 1.35; }
entry { speed 2; angle 90; gap 0.01; } duration 400;
""")
    run = tmp_path/"run"
    foam("plungeCase", scene, *METHOD, "-run", run, case=tmp_path)
    settings(run, """#remove liquid
liquid { stratification { surfaceLevel 0; p 1.467e5; layers {
    surface { depth 0; T 92; composition { CH4 7; C2H6 3; saturated true; } }
    floor   { depth 40; T 91; composition { CH4 3; C2H6 7; saturated true; } } } } }
""")
    foam("slenderBody", case=run)
    table = gather(run)["trajectory"]
    assert abs(table["speed_m_s"][-1]) < 0.05 and 1 < -table["z_m"][-1] < 39
    # Past the last layer nothing is known
    settings(run, (run/"constant/slenderBodySettings").read_text().replace("depth 40", "depth 3"))
    done = runProgram("slenderBody", case=run)
    assert done.returncode != 0 and "layers as deep as the dive" in done.stdout


def test_samplesAreTheirDives(tmp_path: Path) -> None:
    """A line of a table is the dive of its entries."""
    run = solved(tmp_path/"run", DIVE, "-set", "duration=0.1")
    (run/"sample.csv").write_text("body/mass,liquid/rho,body/momentOfInertia\n2.857,664,(0.0029 0.13 0.13)\n5,500,(0.0051 0.129 0.129)\n")
    foam("slenderBody", "-sample", "sample.csv", case=run)
    sample = np.genfromtxt(run/"results/sample.csv", delimiter=",", names=True)
    other = gather(solved(tmp_path/"other", DIVE, "-set", "duration=0.1", "-set", "body={ shape { type NACA; length 1; thicknessRatio 0.1; } "
                          "mass 5; momentOfInertia (0.0051 0.129 0.129); freedom free; }", "-set",
                          "fluids={ liquid astraeusPaper; gas titanAir; liquidDensity 500; surfaceTension 0.0311; gravity 1.35; "
                          "liquidSoundSpeed 1900; liquidVapourPressure 1e5; }"))["trajectory"]
    assert sample["end_s"] == pytest.approx(0.1)
    assert sample["end_speed_m_s"][1] == pytest.approx(other["speed_m_s"][-1], rel=1e-6)
    assert sample["peak_m_s2"][1] == pytest.approx(other["deceleration_m_s2"].max(), rel=1e-2)
    (run/"sample.csv").write_text("body/mass,liquid/rho\n2.857\n")
    done = runProgram("slenderBody", "-sample", "sample.csv", case=run)
    assert done.returncode != 0 and "line 2: 1 values" in done.stdout


def test_refusals(tmp_path: Path) -> None:
    def refused(*options: str) -> str:
        done = runProgram("plungeCase", DIVE, *METHOD, "-run", tmp_path/"none", *options, case=tmp_path)
        assert done.returncode != 0 and not (tmp_path/"none").exists()
        return done.stdout

    assert "none of revolution" in refused("-set", "body.shape={ type wedge; halfAngle 20; halfWidth 0.1; }")
    assert "has no mesh" in refused("-mesh", "single")
    assert "takes the whole body" in refused("-model", "half")
    assert "expected auto, frictionLine or none" in refused("-boundaryLayer", "laminar")
    assert "-flow" in refused("-flow", "loose")
    assert "entry 'body.tail.volumeCoefficient' is -1" in refused("-set", "body.tail={ volumeCoefficient -1; }")
    run = solved(tmp_path/"run", DIVE)
    for entries, named in (("body { mass 0; }", ["Entry mass is 0", "slenderBodyProperties"]), ("nonsense 1;", ["Unknown entry nonsense"]),
                           ("until never;", ["Entry until is never", "atRest"])):
        settings(run, entries)
        checkRefused("slenderBody", run, named)
    settings(run, "")
    (run/"constant/meridian.csv").write_text("x_m,r_m\n0,0\n1,nothing\n")
    checkRefused("slenderBody", run, ["Entry meridian", "line 3", "two numbers"])


def test_estimate(tmp_path: Path) -> None:
    said = foam("plungeCase", DIVE, *METHOD, "-estimate", case=tmp_path)
    assert re.search(r"^steps +\d+", said, re.M) and re.search(r"^CPU time +0\.\d+ s", said, re.M)
