# SPDX-License-Identifier: GPL-3.0-or-later
"""plungeCase: the dive's body and meshes, checks of scene and options, run directories. Other shapes: test_shapes.py."""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from plunge import boundaryLayer, case as cases, estimate, fluids as pairs, foamDictionary, meridianMesh
from plunge import scene as scenes
from plunge.checks import ParameterError
from plunge.methods import meshes, tiers
from plunge.results import attitude_notes, read_scene
from plunge.shapes import NACA

ROOT = Path(__file__).resolve().parents[2]
TOOLS = ROOT / "applications/utilities/plungeCase"
CASE = ROOT / "cases/gannetPlunge"


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """A copy of the case, without its runs."""
    return Path(shutil.copytree(CASE, tmp_path / "case", ignore=shutil.ignore_patterns("run")))


def plungeCase(case: Path, *arguments: str) -> subprocess.CompletedProcess:
    run = [str(case / word) if word.startswith("run/") else word for word in arguments]
    return subprocess.run([str(TOOLS / "plungeCase"), str(case), *run], capture_output=True, text=True)


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert text.count(old) == 1
    path.write_text(text.replace(old, new))


# --- geometry ----------------------------------------------------------------


def test_body_integrals_agree_with_quadrature() -> None:
    length, ratio = 2.0, 0.1
    x = length * (1 - np.cos(np.linspace(0, np.pi, 20001))) / 2
    s = x / length
    r = 5 * ratio * length * (
        0.2969 * np.sqrt(s) - 0.1260 * s - 0.3516 * s**2 + 0.2843 * s**3 - 0.1036 * s**4)
    volume = np.trapz(np.pi * r**2, x)
    centroid = np.trapz(np.pi * r**2 * x, x) / volume
    body = NACA(length, ratio)
    assert body.volume == pytest.approx(volume, rel=1e-6)
    assert body.wetted_area == pytest.approx(np.trapz(2 * np.pi * r * np.sqrt(1 + np.gradient(r, x) ** 2), x), rel=1e-3)
    assert body.centroid == pytest.approx(centroid, rel=1e-6)
    roll, pitch = body.unit_inertia()
    assert roll == pytest.approx(np.trapz(np.pi * r**4 / 2, x), rel=1e-6)
    assert pitch == pytest.approx(np.trapz(np.pi * r**2 * (r**2 / 4 + (x - centroid) ** 2), x), rel=1e-6)
    assert body.nose_radius == pytest.approx(1.1019 * ratio**2 * length, rel=1e-4)


# --- body mesh ---------------------------------------------------------------


def fast_size(resolution: float = 1) -> meridianMesh.MeshSize:
    return meshes.Meshes(scenes.read(CASE), tiers.read("fast", {}), resolution, 1, "half", "overset").size()


def fast_mesh(resolution: float = 1, full: bool = False) -> tuple[NACA, meridianMesh.VolumeMesh]:
    return NACA(1.0, 0.1), meridianMesh.build(NACA(1.0, 0.1), fast_size(resolution), "full" if full else "half")


def enclosed(nodes: np.ndarray, quads: np.ndarray) -> float:
    """Volume between a surface and the origin, by the divergence theorem."""
    points = nodes[quads]
    middle = points.mean(axis=1, keepdims=True)
    areas = 0.5 * np.cross(points - middle, np.roll(points, -1, axis=1) - middle)
    return float(np.einsum("ijk,ijk->", areas, np.broadcast_to(middle, points.shape)) / 3)


def hexahedron_volumes(mesh: meridianMesh.VolumeMesh) -> np.ndarray:
    faces = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    corners = mesh.nodes[mesh.hexahedra]
    centre = corners.mean(axis=1, keepdims=True)
    volume = np.zeros(len(corners))
    for face in faces:
        points = corners[:, face]
        middle = points.mean(axis=1, keepdims=True)
        areas = 0.5 * np.cross(points - middle, np.roll(points, -1, axis=1) - middle)
        volume += np.einsum("ijk,ijk->i", areas, np.broadcast_to(middle - centre, points.shape)) / 3
    return volume


def test_mesh_fills_the_space_between_wall_and_outer_surface() -> None:
    _, mesh = fast_mesh(full=True)
    volumes = hexahedron_volumes(mesh)
    assert (volumes < 0).all() or (volumes > 0).all()
    between = abs(enclosed(mesh.nodes, mesh.outer)) - abs(enclosed(mesh.nodes, mesh.wall))
    assert abs(volumes).sum() == pytest.approx(between, rel=1e-9)


def test_wall_encloses_the_body_and_converges() -> None:
    error = []
    for resolution in (1, 2):
        body, mesh = fast_mesh(resolution)
        error.append(abs(2 * abs(enclosed(mesh.nodes, mesh.wall)) / body.volume - 1))
    assert error[0] < 0.02
    assert error[1] < error[0] / 3.5  # second order


def test_half_model_lies_on_its_plane_and_the_full_one_is_its_double() -> None:
    _, half = fast_mesh()
    _, full = fast_mesh(full=True)
    assert (half.nodes[:, 1] >= 0).all()
    assert (half.nodes[np.unique(half.symmetry), 1] == 0).all()
    assert len(full.hexahedra) == 2 * len(half.hexahedra)
    assert abs(hexahedron_volumes(full)).sum() == pytest.approx(2 * abs(hexahedron_volumes(half)).sum(), rel=1e-12)


def test_no_cell_is_collapsed() -> None:
    _, mesh = fast_mesh()
    corners = mesh.nodes[mesh.hexahedra]
    gaps = np.linalg.norm(corners[:, :, None] - corners[:, None], axis=-1) + np.eye(8)
    assert gaps.min() > 1e-4


# --- body surface ------------------------------------------------------------


def test_surface_is_closed_wound_outwards_and_has_the_bodys_volume() -> None:
    body = NACA(2.0, 0.1)
    points, triangles = body.surface()
    edges = np.vstack([triangles[:, [a, (a + 1) % 3]] for a in range(3)])
    assert len(np.unique(edges, axis=0)) == len(edges)  # each edge once in its direction
    assert {tuple(edge) for edge in edges} == {tuple(edge) for edge in edges[:, ::-1]}  # and once against it
    assert len(points) - len(edges) // 2 + len(triangles) == 2  # one sphere
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    # (x aft, y, z dorsal) is left-handed: outwards there is inwards to the eye of a right-handed system
    normal = np.cross(b - a, c - a)
    assert abs(np.einsum("ij,ij->", a, normal)) / 6 == pytest.approx(body.volume, rel=1e-3)
    away = (a + b + c) / 3 - np.array([1.0, 0, 0]) * np.mean([a[:, 0], b[:, 0], c[:, 0]], axis=0)[:, None]
    sides = np.einsum("ij,ij->i", normal, away)
    assert (sides > 0).all() or (sides < 0).all()
    # Fine at the nose: at most a fifth of its radius
    near = a[:, 0] < body.nose_radius
    assert max(np.linalg.norm(e[near], axis=1).max() for e in (b - a, c - b, a - c)) < 0.2 * body.nose_radius


def test_surface_lies_where_the_dive_starts(case: Path) -> None:
    assert plungeCase(case, "-method", "particles", "-run", "run/a", "-set", "body.shape.length=2").returncode == 0
    run = case / "run/a"
    subprocess.run([TOOLS / "plungeBodySurface", "-case", run], check=True)
    data = (run / "constant/triSurface/body.stl").read_bytes()
    facets = np.frombuffer(data, np.dtype([("normal", "<f4", 3), ("x", "<f4", (3, 3)), ("attribute", "<u2")]), offset=84)
    given = foamDictionary.read(run / "system/plungeGenerated")
    corners = facets["x"].astype(float)
    along = (corners - given["nosePosition"]) @ given["forward"]
    # The lowest point of a slanting body lies behind its nose
    assert given["nosePosition"][:2] == [0, 0]
    assert corners[..., 2].min() == pytest.approx(0.00962466, abs=1e-7)
    assert (along.max(), along.min()) == pytest.approx((0, -2), abs=1e-6)
    volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    assert volume == pytest.approx(given["bodyVolume"], rel=1e-3)  # wound outwards: positive
    centroid = np.einsum("ij,ik->k", np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))[:, None],
                         corners.sum(axis=1)) / 24 / volume
    assert centroid == pytest.approx(given["centreOfMass"], abs=1e-3)


# --- parameters --------------------------------------------------------------


@pytest.mark.parametrize("arguments, expected", [
    (["-fluids", "oil"], "entry 'fluids' is oil; expected one of: titan"),
    (["-model", "eighth"], "-model eighth: expected one of: auto plane axisymmetric quarter half full"),
    (["-model", "axisymmetric"], "-model axisymmetric, but the body does not move along its own, vertical axis; expected half or full"),
    (["-model", "plane"], "-model plane, but the shape NACA is a body in space; expected auto, axisymmetric, half or full"),
    (["-model", "half", "-set", "entry.sideslip=5"], "-model half, but sideslip; expected full"),
    (["-mesh", "moving"], "-mesh moving: expected one of: auto overset following single"),
    (["-tier", "coarse"], "-tier coarse: expected one of"),
    (["-np", "0"], "-np 0: expected a whole number, at least 1"),
    (["-resolution", "fine"], "-resolution fine: expected a number from 0.25 to 16"),
    (["-method", "interFoam"], "-method interFoam: expected one of: meshes particles"),
    (["-boundaryLayer", "turbulent"], "-boundaryLayer turbulent: expected one of: auto laminar wallFunction frictionLine none"),
    (["-boundaryLayer", "laminar"], "-boundaryLayer laminar, but the mesh's first layer is 0.00288 m and a laminar layer "
                                    "at Re = 1.64e+07 needs 7.86e-05 m; expected frictionLine, or a finer mesh"),
    (["-method", "particles", "-boundaryLayer", "frictionLine"],
     "-boundaryLayer frictionLine: expected auto or none: plungeSPH has no boundary layer"),
    (["-method", "particles", "-surfaceTension", "on"], "-surfaceTension on: expected auto or off: plungeSPH has none"),
    (["-method", "particles", "-soundSpeed", "0"], "-soundSpeed 0: expected metres per second, above 0"),
    (["-soundSpeed", "100"], "-soundSpeed is of particles; expected -method particles with it"),
    (["-set", "transitionReynolds=-1"], "entry 'transitionReynolds' is -1; expected a number, 0 or above"),
    (["-set", "body.mass=-1"], "entry 'body.mass' is -1; expected a number above 0"),
    (["-set", "entry.angel=60"], "unknown entry 'entry.angel'"),
    (["-set", "entry.angle=-60"], "entry 'entry.angle' is -60, so that the body does not come down"),
    (["-set", "entry.gap=0"], "entry 'entry.gap' is 0; expected a number above 0"),
    (["-set", "body.freedom=planar", "-set", "entry.sideslip=20"], "entry 'entry.sideslip' moves the body in a way that freedom planar does not"),
    (["-set", "body.freedom=planar", "-set", "entry.spin=(1 0 0)"], "entry 'entry.spin' moves the body in a way that freedom planar does not"),
    (["-set", "body.momentOfInertia=(1e-9 1e-9 1)"], "expected moments of which none exceeds the sum of the others"),
    (["-set", "body.shape.length=300"], "the body is 300 m long; expected 0.001 to 100 m"),
    (["-set", "body.mass=0_59"], "entry 'body.mass' is 0_59; expected a number above 0"),
    (["-resolution", "16", "-tier", "fine"], "cells; expected 2e+08 at most"),
    (["-run", "run/it's"], "expected a path of letters, digits and"),
    (["-run", "run x/a"], "expected a path of letters, digits and"),
    (["-set", "entry.speed=inf"], "entry 'entry.speed' is inf; expected a number, 0 or above"),
    (["-set", "entry.speed=nan"], "entry 'entry.speed' is nan; expected a number, 0 or above"),
    (["-set", "entry.speed=1_0"], "entry 'entry.speed' is 1_0; expected a number, 0 or above"),
    (["-set", "entry.speed=1e300"], "entry 'entry.speed' is 1e+300; expected a number, 0 or above, of a size from 1e-20 to 1e+20"),
    (["-set", "travel=1e300"], "entry 'travel' is 1e+300; expected a number above 0, of a size from 1e-20 to 1e+20"),
    (["-set", "body.shape.length=1e-300"], "entry 'length' is 1e-300; expected a number above 0, of a size from 1e-20 to 1e+20"),
    (["-set", "entry.spin=(0 inf 0)"], "entry 'entry.spin' is (0 inf 0); expected three numbers"),
    (["-set", "entry.speed=10; until immersed"], "entry 'entry.speed' is"),
    (["-set", "travel=1e9", "-mesh", "single"], "time steps; expected 1e+08 at most"),
    (["-set", "travel=1e9", "-method", "particles"], "at most"),
    (["-set", "body.freedom=fixed"], "entry 'body.freedom' is fixed, but the body has a speed or a spin"),
    (["-set", "body.centreOfMass=1.2"], "entry 'body.centreOfMass' is 1.2; expected metres aft of the nose, inside the body"),
    (["-set", "body.shape.type=cube"], "entry 'shape.type' is cube; expected one of: NACA"),
    (["-set", "body.shape.width=1"], "shape NACA: unknown entry 'width'; expected: length thicknessRatio"),
    (["-set", "tier.layers=2"], "entry 'layers' is 2; expected a whole number, at least 4"),
    (["-set", "until=sunk"], "entry 'until' is sunk; expected one of: immersed atRest leftTheLiquid"),
    (["-set", "tier=fine"], "-set tier=fine: expected the option -tier"),
])
def test_bad_values_are_named(case: Path, arguments: list[str], expected: str) -> None:
    done = plungeCase(case, *arguments)
    assert done.returncode != 0
    assert expected in done.stderr
    assert not (case / "run").exists()


def test_missing_entry_and_broken_syntax_are_named(case: Path) -> None:
    path = case / "constant/scene"
    edit(path, "    speed       25;", "    // speed")
    missing = plungeCase(case).stderr
    assert f"{path}: entry 'entry.speed' is missing; expected the speed at the start [m/s], or drop" in missing
    edit(path, "entry\n{", "entry\n")
    assert f"{path}, line" in plungeCase(case).stderr


def test_several_bodies_and_no_scene_are_refused(case: Path) -> None:
    path = case / "constant/scene"
    edit(path, "body\n{\n", "body\n{\n first {\n")
    edit(path, "freedom     free;", "freedom     free; }")
    assert "entry 'body' holds several bodies, first; expected one" in plungeCase(case).stderr
    assert "expected a scene: a case directory with constant/scene, or a scene file" in plungeCase(case / "constant").stderr


def test_fluids_are_those_of_titanProperties_unless_typed(case: Path) -> None:
    fluids = pairs.resolve("kraken", "here")[1]
    lake = pairs.fluid_properties("Kraken", 92, "here")[0]
    assert (fluids["liquidDensity"], fluids["liquidViscosity"], fluids["surfaceTension"]) == \
        (lake["rho"], lake["mu"], lake["sigma"])
    # A colder lake, under colder air, is denser; the surface's pressure and gravity are the place's
    colder = pairs.resolve({"liquid": "Kraken", "gas": "titanAir", "temperature": 91, "gasDensity": 5}, "here")[1]
    assert colder["liquidDensity"] > fluids["liquidDensity"] and colder["gasDensity"] == 5
    assert (colder["surfacePressure"], colder["gravity"]) == (1.467e5, 1.35)

    path = case / "constant/scene"
    text = path.read_text()
    for entries, expected in (
            ("liquid Kraken;", "entry 'gasDensity' is missing; expected a number above 0"),
            ("liquid krakne; gas titanAir;", "krakne"),
            ("liquid water; gas earthAir; liquidDensty 3;", "unknown entry 'liquidDensty'"),
            ("liquid astraeusPaper; gas titanAir; temperature 300;", "-T does not go with astraeusPaper")):
        path.write_text(text.replace("fluids          titan;", f"fluids {{ {entries} }}", 1))
        refused = plungeCase(case, "-run", "run/refused")
        assert refused.returncode != 0 and expected in refused.stderr and f"{path}, fluids" in refused.stderr
        assert not (case / "run").exists()


def test_half_model_has_half_the_mass_and_the_path_the_angle(case: Path) -> None:
    values = {}
    for model in ("half", "full"):
        assert plungeCase(case, "-model", model, "-run", f"run/{model}").returncode == 0
        values[model] = foamDictionary.read(case / f"run/{model}/system/plungeGenerated")
    half, full = values["half"], values["full"]
    assert full["modelledMass"] == pytest.approx(full["bodyMass"]) == pytest.approx(664 * NACA(1, 0.1).volume)
    assert half["modelledMass"] == pytest.approx(full["bodyMass"] / 2)
    assert half["modelledMomentOfInertia"] == pytest.approx([i / 2 for i in full["bodyMomentOfInertia"]])
    assert np.degrees(np.arctan2(-half["initialVelocity"][2], half["initialVelocity"][0])) == pytest.approx(75)
    axes = np.reshape(half["orientation"], (3, 3))
    assert axes @ axes.T == pytest.approx(np.eye(3), abs=1e-9) and np.linalg.det(axes) == pytest.approx(1)


def particles(case: Path, *arguments: str) -> dict:
    """What plungeSPH's dive is generated from."""
    done = plungeCase(case, "-method", "particles", *arguments)
    assert done.returncode == 0, done.stderr
    return foamDictionary.read(Path(done.stdout.splitlines()[-1]) / "system/plungeGenerated")


def test_both_solvers_dive_from_the_same_scene(case: Path) -> None:
    """The same dive, fluids and body, in run directories of their own, each with its solver's files alone."""
    assert plungeCase(case, "-fluids", "water").returncode == 0
    mesh, liquid = foamDictionary.read(case / "run/water-fast/system/plungeGenerated"), particles(case, "-fluids", "water")
    of_meshes = set(mesh) - set(liquid)
    assert {"noseSpacing", "xCells", "courantLimit", "transitionReynolds"} <= of_meshes
    assert {"particleSpacing", "addedMassEstimate"} <= set(liquid) - set(mesh)
    assert {key for key in set(mesh) & set(liquid) if mesh[key] != liquid[key]} == \
        {"application", "estimatedSteps", "boundaryLayer", "decisions", "mesh"}
    run = case / "run/water-fast-particles"
    files = {str(path.relative_to(run)) for path in run.rglob("*") if path.is_file()}
    assert files == {"Allrun", "constant/g", "constant/bodyMotion", "constant/particleProperties", "constant/scene",
                     "constant/uncertainty.csv", "system/controlDict", "system/plungeGenerated"}
    assert not (case / "run/water-fast/constant/particleProperties").exists()


def expanded(run: Path, dictionary: str, entry: str) -> dict:
    """A sub-dictionary as OpenFOAM reads it."""
    done = subprocess.run(["foamDictionary", "-entry", entry, run / dictionary],
                          check=True, capture_output=True, text=True)
    return foamDictionary.parse(done.stdout, dictionary)[entry.split("/")[-1]]


@pytest.mark.parametrize("model", ["half", "full"])
def test_both_solvers_move_the_same_body(case: Path, model: str) -> None:
    for method, solver in (("meshes", "plungeFoam"), ("particles", "plungeSPH")):
        assert plungeCase(case, "-method", method, "-model", model, "-run", f"run/{solver}").returncode == 0
    motion = expanded(case / "run/plungeFoam", "constant/dynamicMeshDict", "sixDoFRigidBodyMotionCoeffs")
    body = expanded(case / "run/plungeSPH", "constant/particleProperties", "bodies/body")
    # plungeFoam computes the added mass
    assert motion.pop("solver") == {"type": "addedMass"}
    assert set(body.pop("solver")) == {"type", "addedMass", "addedInertia"}
    # Apart from what says which mesh moves
    assert body == {key: value for key, value in motion.items()
                    if key not in ("patches", "innerDistance", "outerDistance", "rho", "report")}
    assert body["mass"] > 0 and set(body["constraints"]) == ({"plane", "axis"} if model == "half" else set())
    entries = subprocess.run(["foamDictionary", "-keywords", case / "run/plungeSPH/constant/particleProperties"],
                             check=True, capture_output=True, text=True).stdout.split()
    assert ("symmetry" in entries) == (model == "half") and "dive" not in entries and "geometry" in entries


def test_particles_fill_whole_spacings_about_the_path(case: Path) -> None:
    for model, resolution in (("half", 1), ("full", 1), ("half", 1.3)):
        g = particles(case, "-model", model, "-resolution", str(resolution), "-run", f"run/{model}{resolution}")
        spacing = g["particleSpacing"]
        assert spacing == pytest.approx(0.0145 / resolution)
        low, high, top = (np.array(g[name]) / spacing for name in ("liquidMin", "liquidMax", "tankMax"))
        for corner in (low, high, top):
            assert corner == pytest.approx(np.round(corner), abs=1e-6)
        assert g["fluidParticles"] == np.prod(np.round(high - low))
        assert g["liquidMax"][2] == 0 < g["tankMax"][2]
        assert g["liquidMin"][1] == (0 if model == "half" else -g["liquidMax"][1])
        assert ("front" in g["tankOpen"]) == (model == "half") != ("front" in g["absorbingFaces"])
        # The path of the nose, a third of a length below it, and about it as far as the body goes deep, or is long
        end = np.array([0.0, 0, 0.01]) + 1.125 * np.array(g["forward"])
        assert (np.array(g["liquidMin"])[[0, 2]] <= np.minimum(0, end[[0, 2]]) - [1, 0.35]).all()
        assert g["liquidMax"][0] >= end[0] + 1 and g["liquidMax"][1] >= 1
    for tier, least, most in (("fast", 1.1e6, 1.3e6), ("standard", 2.7e6, 3.1e6), ("fine", 8.8e6, 1e7)):
        assert least < particles(case, "-tier", tier)["fluidParticles"] < most


def test_speed_of_sound_is_ten_times_that_of_free_fall_unless_given(case: Path) -> None:
    g = particles(case, "-run", "run/a", "-set", "entry.speed=20", "-fluids", "water")
    height = 1.125 * np.sin(np.radians(75))
    assert g["particleSoundSpeed"] == pytest.approx(10 * np.sqrt(20**2 + 2 * 9.81 * height))
    assert particles(case, "-run", "run/b", "-soundSpeed", "11.6")["particleSoundSpeed"] == 11.6


def test_particles_take_steps_of_half_the_smoothing_length_over_the_speed_of_sound(case: Path) -> None:
    g = particles(case)
    step = 0.5 * 1.5 * g["particleSpacing"] / (g["particleSoundSpeed"] + 25)
    assert g["estimatedSteps"] == pytest.approx(g["diveDuration"] / step, abs=5.1)


@pytest.mark.parametrize("angle, ratio", [(75, 0.1), (20, 0.1), (30, 0.4), (90, 0.1)])
def test_gap_is_that_of_the_lowest_point(angle: float, ratio: float) -> None:
    """At a flat angle, or of a thick body, that is far from the nose."""
    found = generated(entry__angle=angle, entry__gap=0.01, body__shape__thicknessRatio=ratio)
    points, _ = NACA(1.0, ratio).surface()
    aft, side, dorsal = points.T
    heights = found["nosePosition"][2] - aft * found["forward"][2] + dorsal * found["dorsal"][2]
    assert heights.min() == pytest.approx(0.01, abs=1e-9)
    # So far above the nose that a gap of the nose would have put it into the liquid
    assert (heights[0] > 0.02) == (angle < 75)


# --- what is modelled --------------------------------------------------------


def generated(**overrides: object) -> dict:
    """The entries of plungeGenerated; __ stands for a point."""
    return cases.derive(CASE, {name.replace("__", "."): value for name, value in overrides.items()}).flat


def decision(found: dict, what: str) -> str:
    return next(line for line in found["decisions"] if line.startswith(f"{what}: "))


# The liquid's viscosity over its density is 1.5e-6 m2/s: Re is 6.5e5 times the speed
SLOW = {"entry__speed": 0.01}    # the tier fast resolves its laminar layer
MEDIUM = {"entry__speed": 0.5}   # and this one's not

VERTICAL = {"entry__angle": 90, "body__freedom": "axial"}


@pytest.mark.parametrize("overrides, layer, reason", [
    ({}, "frictionLine", "Re = 1.64e+07, above transition at 5e+05"),
    ({"transitionReynolds": 2e7}, "frictionLine", "Re = 1.64e+07, transition at 2e+07, but the mesh's first layer is 0.00288 m "
                                                  "and a laminar layer needs 7.86e-05 m"),
    (MEDIUM, "frictionLine", "Re = 3.27e+05, transition at 5e+05, but the mesh's first layer"),
    (SLOW, "laminar", "Re = 6.55e+03, transition at 5e+05: the mesh resolves the layer"),
    ({**SLOW, "transitionReynolds": 0}, "frictionLine", "Re = 6.55e+03, above transition at 0"),
    ({**SLOW, "resolution": 0.5}, "frictionLine", "but the mesh's first layer"),
    # A mesh in two dimensions can pay for thin layers
    ({**MEDIUM, **VERTICAL}, "laminar", "Re = 3.27e+05, transition at 5e+05: the mesh resolves the layer"),
    ({**MEDIUM, **VERTICAL, "travel": 0.26}, "laminar", "Re = 1.35e+05 of the length that is wetted"),
    (VERTICAL, "frictionLine", "Re = 1.64e+07, above transition at 5e+05"),
    ({**SLOW, "boundaryLayer": "laminar"}, "laminar", "as asked; Re = 6.55e+03"),
    ({"boundaryLayer": "none"}, "none", "as asked; Re = 1.64e+07"),
    ({"boundaryLayer": "frictionLine"}, "frictionLine", "as asked"),
    ({"boundaryLayer": "wallFunction"}, "wallFunction", "as asked"),
    ({"method": "particles"}, "none", "plungeSPH has none"),
    ({"method": "particles", "boundaryLayer": "none"}, "none", "plungeSPH has none"),
])
def test_boundary_layer_follows_from_reynolds_number_and_mesh(overrides: dict, layer: str, reason: str) -> None:
    found = generated(**overrides)
    assert found["boundaryLayer"] == layer
    line = decision(found, "boundary layer")
    assert line.startswith(f"boundary layer: {layer} (") and reason in line
    assert ("transitionReynolds" in found) == (found["application"] == "plungeFoam")


@pytest.mark.parametrize("overrides, tension, reason", [
    ({}, "off", "We = 1.33e+07"),
    ({"entry__speed": 6}, "on", "We = 7.69e+05"),
    ({"entry__speed": 6, "body__shape__length": 2}, "off", "We = 1.54e+06"),
    ({"entry__speed": 6, "method": "particles"}, "off", "plungeSPH has none"),
])
def test_surface_tension_follows_from_weber_number(overrides: dict, tension: str, reason: str) -> None:
    found = generated(**overrides)
    assert found["surfaceTensionModelled"] == tension
    assert decision(found, "surface tension") == f"surface tension: {tension} ({reason})"


def test_liquid_without_surface_tension(case: Path) -> None:
    done = plungeCase(case, "-set", "entry.speed=1", "-set", "fluids={ }")
    assert done.returncode != 0
    edit(case / "constant/scene", "fluids          titan;", "fluids { liquid water; gas earthAir; surfaceTension 0; }")
    assert "\nsurface tension: off (the liquid has none)\n" in plungeCase(case, "-set", "entry.speed=1").stderr
    assert "-surfaceTension on, but the liquid has none" in plungeCase(case, "-surfaceTension", "on").stderr


def test_decisions_are_printed_and_written(case: Path) -> None:
    done = plungeCase(case)
    given = foamDictionary.read(case / "run/titan-fast/system/plungeGenerated")
    assert done.stderr.splitlines()[-5:] == given["decisions"] == [
        "model: half (nothing drives the body out of its plane of symmetry)", "mesh: following (the body travels 1.12 of its lengths, and the background with it)",
        "boundary layer: frictionLine (Re = 1.64e+07, above transition at 5e+05)", "surface tension: off (We = 1.33e+07)",
        "compressibility: none (Ma = 0.0126 in the liquid, 0.128 in the gas)"]
    assert plungeCase(case, "-boundaryLayer", "none").stdout.strip() == str(case / "run/titan-fast-none")


@pytest.mark.parametrize("options, note", [
    ((), ""), (("-set", "tier.noseSpacing=0.02"), "nose: its diameter, 0.022 m, has 1.1 cells along it"), (("-set", "tier.maxAlphaCo=2"), "steps: Courant numbers up to 2, at the interface 2"),
    (("-set", "fluids={ liquid water; gas earthAir; gasDensity 0.01; }"), "gas: 1e-05 of the liquid's density"),
    (("-set", "fluids={ liquid Kraken; gas titanAir; temperature 100; }"), "liquid Kraken: The liquid is superheated"),
    (("-set", "fluids={ liquid Kraken; gas titanAir; temperature 66; }"), "liquid Kraken: The liquid may freeze"),
    (("-set", "body.tail={ volumeCoefficient 1; }"), "tail: -method slenderBody has it")])
def test_notes_on_the_scene_go_into_the_report(case: Path, options: tuple, note: str) -> None:
    """What plungeCase doubts is told with the results, too."""
    said = plungeCase(case, *options, "-run", "run/a").stderr
    (case / "run/a/log.plungeFoam").write_text("Scene\n    models      : body\n    Note: Gravity is off.\n")
    notes = read_scene(case / "run/a").notes
    assert (len(notes) > 1) == bool(note) and notes[-1] == "Gravity is off."
    assert not note or notes[0].startswith(note) and notes[0] in said.splitlines()


@pytest.mark.parametrize("overrides, model, mesh", [
    ({}, "half", "following"),
    ({"entry__angle": 90}, "half", "following"),                              # free: it may leave its axis
    ({"entry__angle": 90, "body__freedom": "axial"}, "axisymmetric", "single"),
    ({"entry__angle": 90, "body__freedom": "axial", "method": "particles"}, "axisymmetric", "none"),
    ({"entry__angle": 90, "body__freedom": "axial", "entry__attitude": 80}, "half", "following"),
    ({"entry__angle": 90, "body__freedom": "prescribed"}, "axisymmetric", "single"),
    ({"entry__sideslip": 3}, "full", "following"),
    ({"entry__spin": [0, 1, 0]}, "half", "following"),
    ({"entry__spin": [1, 0, 0]}, "full", "following"),
    ({"body__centreOfMass": [0.4, 0.01, 0]}, "full", "following"),
    ({"model": "full", "mesh": "single"}, "full", "single"),
    ({"entry__speed": 0, "duration": 0.1}, "half", "overset"),
    ({"entry__speed": 0, "duration": 5}, "half", "following"),
])
def test_dimension_and_symmetry_follow_from_shape_path_and_freedom(overrides: dict, model: str, mesh: str) -> None:
    found = generated(**overrides)
    assert (found["model"], found["mesh"]) == (model, mesh)
    rings = overrides.get("method") == "particles"
    share = {"half": 0.5, "axisymmetric": 1 if rings else np.sin(np.radians(5)) / (2 * np.pi), "full": 1}[model]
    assert found["modelledMass"] == pytest.approx(share * found["bodyMass"])


def keywords(run: Path, dictionary: str, entry: str = "") -> list:
    """The names of entries as OpenFOAM reads them."""
    command = ["foamDictionary", *(["-entry", entry] if entry else []), "-keywords", run / dictionary]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()


@pytest.mark.parametrize("layer", ["frictionLine", "wallFunction", "none"])
def test_only_what_the_boundary_layer_needs_is_in_the_case(case: Path, layer: str) -> None:
    assert plungeCase(case, "-boundaryLayer", layer, "-run", "run/a", "-set", "transitionReynolds=3e5").returncode == 0
    run = case / "run/a"
    scene = foamDictionary.parse(subprocess.run(["foamDictionary", "-expand", run / "constant/sceneProperties"], check=True,
                                                capture_output=True, text=True).stdout, "sceneProperties")
    assert scene["boundaryLayer"] == layer and scene["surfaceTension"] == "off" and "turbulence" not in scene
    assert scene.get("frictionLineCoeffs") == \
        ({"transitionReynolds": 300000, "patches": ["body"]} if layer == "frictionLine" else None)

    turbulent = layer == "wallFunction"
    assert ("RAS" in keywords(run, "constant/turbulenceProperties")) == turbulent
    assert ("wallDist" in keywords(run, "system/fvSchemes")) == turbulent
    assert {"div(phi,k)", "div(phi,omega)"} & set(keywords(run, "system/fvSchemes", "divSchemes")) == \
        ({"div(phi,k)", "div(phi,omega)"} if turbulent else set())
    assert ('"(k|omega).*"' in keywords(run, "system/fvSolution", "solvers")) == turbulent
    assert {"k", "omega", "nut"} & {path.name for path in (run / "0.orig").iterdir()} == \
        ({"k", "omega", "nut"} if turbulent else set())
    assert ("freeStreamK" in foamDictionary.read(run / "system/plungeGenerated")) == turbulent


def firstLayers(given: dict) -> list:
    """[m] at the nose, the thickest section and the tail, as plungeGenerated has them."""
    return [offset * np.expm1(stretching / given["layers"]) / np.expm1(stretching)
            for offset, stretching in zip(given["offset"], given["stretching"])]


@pytest.mark.parametrize("mesh", ["overset", "single"])
@pytest.mark.parametrize("fluids", ["titan", "water"])
def test_first_cells_of_wall_functions_are_in_the_logarithmic_layer(fluids: str, mesh: str) -> None:
    plain, found = (generated(fluids=fluids, mesh=mesh, boundaryLayer=layer) for layer in ("none", "wallFunction"))
    nu = found["liquidKinematicViscosity"]

    def drag(x: float) -> float:
        """Of a plate of length x, over rho U^2/2."""
        return x * 0.455 / np.log10(25 * x / nu) ** 2.58

    friction = (drag(0.5001) - drag(0.4999)) / 0.0002
    for first in firstLayers(found):
        assert 25 * np.sqrt(friction / 2) * first / 2 / nu == pytest.approx(60, rel=1e-4)
    assert found["offset"] == plain["offset"] and found["outerLayers"] == plain["outerLayers"]

    def lastLayers(given: dict) -> list:
        return [first * np.exp(s * (1 - 1 / given["layers"])) for first, s in zip(firstLayers(given), given["stretching"])]

    # One layer fewer, and the outermost would be thicker
    assert 0.95 * max(lastLayers(plain)) < max(lastLayers(found)) <= max(lastLayers(plain))


def test_mesh_that_is_fine_enough_for_wall_functions_stays() -> None:
    size = fast_size()
    own = meridianMesh.first_layers(size)
    assert meridianMesh.with_first_layer(size, max(own)) == size
    # Or stays where it is
    thinner = meridianMesh.with_first_layer(size, 1.1 * min(own))
    assert meridianMesh.first_layers(thinner) == pytest.approx([min(1.1 * min(own), first) for first in own])
    assert thinner.layers >= size.layers


def test_mesh_of_wall_functions_fills_the_same_space() -> None:
    body, plain = fast_mesh()
    mesh = meridianMesh.build(body, meridianMesh.with_first_layer(fast_size(), 2e-4), "half")
    volumes = hexahedron_volumes(mesh)
    assert (volumes < 0).all() or (volumes > 0).all()
    assert abs(volumes).sum() == pytest.approx(abs(hexahedron_volumes(plain)).sum(), rel=1e-3)
    wall = lambda mesh: mesh.nodes[np.unique(mesh.wall)]
    assert wall(mesh) == pytest.approx(wall(plain))


def test_free_stream_is_quiet_and_goes_with_speed_and_length() -> None:
    found = generated(boundaryLayer="wallFunction")
    assert (found["freeStreamK"], found["freeStreamOmega"]) == pytest.approx((1e-4, 10), rel=0.05)
    k, omega = boundaryLayer.free_stream(50, 4)
    assert (k / found["freeStreamK"], omega / found["freeStreamOmega"]) == pytest.approx((4, 0.5))


def test_any_entry_can_be_set(case: Path) -> None:
    """Lists and dictionaries, too."""
    done = plungeCase(case, "-run", "run/a", "-set", "entry.spin=(0 1 0)", "-set", "body.centreOfMass=(0.08 0 0)",
                      "-set", "body.shape={ type sphere; radius 0.1; }", "-set", "fluids={ liquid water; gas earthAir; }")
    assert done.returncode == 0 and "sphere of 0.2 m" in done.stderr, done.stderr
    scene = foamDictionary.read(case / "run/a/constant/scene")
    assert scene["body"]["shape"] == {"type": "sphere", "radius": 0.1} and scene["entry"]["spin"] == [0, 1, 0]


@pytest.mark.parametrize("overrides, corrections", [
    ({}, 2), ({"tier__maxCo": 1}, 1), ({"model": "full", "tier__maxCo": 0.8}, 1),
    ({"fluids": {"liquid": "water", "gas": "earthAir", "liquidViscosity": 1000}}, 3),
])
def test_pressure_corrections_follow_from_courant_and_diffusion_number(overrides: dict, corrections: int) -> None:
    assert generated(**overrides)["pressureCorrections"] == corrections


# --- run directories ---------------------------------------------------------


def test_two_at_once_make_one_run_directory(case: Path) -> None:
    """Of two that start together one makes it, and the other finds it made."""
    both = [subprocess.Popen([TOOLS / "plungeCase", case, "-run", case / "run/a"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            for _ in range(2)]
    said = [process.communicate() for process in both]
    assert [process.returncode for process in both] == [0, 0], said
    assert {out.strip() for out, _ in said} == {str(case / "run/a")}
    assert sorted(path.name for path in (case / "run/a").iterdir() if path.name.startswith(".")) == []


def test_full_disk_and_path_with_spaces_are_told_in_one_line(tmp_path: Path) -> None:
    (tmp_path / "a b").mkdir()
    scene = Path(shutil.copy(CASE / "constant/scene", tmp_path / "a b/dive"))
    run = tmp_path / "run"
    # What follows from the path of the scene is refused, and of another one it is not in the way
    refused = subprocess.run([TOOLS / "plungeCase", "dive"], cwd=tmp_path / "a b", capture_output=True, text=True)
    assert refused.returncode != 0 and refused.stderr.splitlines()[-1].startswith("plungeCase: run directory '") and "without spaces" in refused.stderr

    def limited(blocks: int, *command: object) -> str:
        """The last line of a command that cannot write files that are longer, of which there must be no more from it."""
        done = subprocess.run(["bash", "-c", f"trap '' XFSZ; ulimit -f {blocks}; exec \"$@\"", "-", *map(str, command)], cwd=run if run.exists() else tmp_path,
                              capture_output=True, text=True)
        assert done.returncode == 1 and "Traceback" not in done.stderr, done.stderr
        return done.stderr.splitlines()[-1]

    last = limited(1, TOOLS / "plungeCase", scene, "-run", run)
    assert last.startswith(f"plungeCase: {run}/") and "File too large" in last and last.endswith("on a disk with room")
    made = subprocess.run([TOOLS / "plungeCase", "dive", "-run", run], cwd=tmp_path / "a b", capture_output=True, text=True)
    assert made.stdout.strip() == str(run), made.stderr
    assert limited(20, TOOLS / "plungeBodyMesh") == "plungeBodyMesh: body.msh could not be written whole; expected a disk with room"
    assert "File too large" in limited(20, TOOLS / "plungeBodySurface")
    moved = Path(shutil.copytree(run, tmp_path / "a b/moved"))
    refused = subprocess.run([moved / "Allrun"], capture_output=True, text=True)
    assert refused.returncode == 1 and f"Allrun: {moved}: expected a path without spaces" in refused.stderr


def test_run_directory_is_kept_for_the_same_dive_and_refused_for_another(case: Path) -> None:
    first = plungeCase(case, "-run", "run/a")
    assert first.stdout.strip() == str(case / "run/a")
    kept = case / "run/a/system/controlDict"
    kept.write_text(kept.read_text() + "// edited by hand\n")
    assert plungeCase(case, "-run", "run/a").returncode == 0
    assert kept.read_text().endswith("// edited by hand\n")
    refused = plungeCase(case, "-run", "run/a", "-fluids", "water")
    assert refused.returncode != 0 and "holds another scene" in refused.stderr
    refused = plungeCase(case, "-run", "run/a", "-method", "particles")
    assert refused.returncode != 0 and "holds another scene" in refused.stderr and "application" in refused.stderr


@pytest.mark.parametrize("cores", [1, 2, 6, 7, 64])
def test_ranks_are_all_used(cores: int) -> None:
    assert np.prod(meshes.cores_split(cores, flat=False)) == cores
    assert np.prod(meshes.cores_split(cores, flat=True)) == cores and meshes.cores_split(cores, flat=True)[1] == 1


def test_wall_functions_are_refused_where_their_layer_is_thinner_than_the_mesh_is_made_for() -> None:
    with pytest.raises(ParameterError, match=r"-boundaryLayer wallFunction, but first cells would be at y\+ = 2.*expected 30 to 300"):
        generated(boundaryLayer="wallFunction", **MEDIUM)


def test_numbers_are_finite() -> None:
    with pytest.raises(ParameterError, match="'entry.speed' is inf; expected a number, 0 or above"):
        generated(**{"entry.speed": float("inf")})


@pytest.mark.parametrize("density, speed, deepest", [
    (13280, 0.5, -0.3456),  # falls on, and faster
    (1000, 5.0, -0.1115),   # as heavy as the water
    (6.64, 0.5, -0.0281),   # turns round: the room of the straight path is enough
])
def test_roomForTheFall(density: float, speed: float, deepest: float) -> None:
    """The background holds the way that gravity makes of it, and room about the body at its end."""
    flat = generated(fluids="water", entry__speed=speed, body__shape__length=0.1, entry__gap=0.001, body__density=density,
                     mesh="overset")
    assert flat["zMin"] < min(deepest, flat["pathEnd"][2]) - 0.1
    assert flat["pathEnd"][2] <= deepest + 0.005


def test_roomForARise() -> None:
    """A light body that is let go in the liquid leaves it through the surface: up there is room, too."""
    flat = generated(fluids="water", entry__speed=0.0, entry__depth=0.5, body__density=300, body__shape__length=0.1, duration=0.5,
                   entry__angle=-90, mesh="overset")
    assert flat["pathEnd"][2] > 0.05 and flat["zMax"] > flat["pathEnd"][2] + 0.03


def test_backgroundThatFollows() -> None:
    """Holds the body and as much about it on all sides, however far it goes, and its far boundary passes through the surface."""
    near, far = (generated(travel=travel) for travel in (1, 25))
    assert near["mesh"] == far["mesh"] == "following"
    assert all(near[name] == far[name] for name in ("xMin", "xMax", "yMax", "zMin", "zMax", "pathStart", "pathEnd", "estimatedCells"))
    assert near["zMax"] - near["pathStart"][2] >= 1.5 and near["pathEnd"][2] - near["zMin"] >= 1.5
    standing = generated(travel=25, mesh="overset")
    assert standing["estimatedCells"] > 10*far["estimatedCells"] and standing["pathEnd"][2] < -23


def test_an_estimate_probes_finer_where_the_coarse_body_is_refused(case: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As a wing is that is thinner than coarse particles, or than coarse cells."""
    tried = []

    def probe(scene: Path, entries: dict, resolution: float, run: Path) -> tuple:
        tried.append(resolution)
        if resolution < 0.8:
            raise ParameterError("too coarse")
        return estimate.Probe(1000, 10, 1e-6, 1e-3, 1, 1), cases.derive(scene, {**entries, "resolution": resolution})

    monkeypatch.setattr(estimate, "_probe", probe)
    assert estimate.of(case, {}, cases.derive(case)).steps > 5
    assert len(tried) > 1 and tried == sorted(tried) and tried[-1] <= 1
    monkeypatch.setattr(estimate, "_probe", lambda *_: probe(*_[:2], 0.1, _[3]))
    with pytest.raises(ParameterError, match="too coarse"):
        estimate.of(case, {}, cases.derive(case))


def test_separationNote() -> None:
    """A body that stands across its path on walls that slip is told of; one that turns when it has all but stopped, or above the surface, or with wall functions, is not."""
    t = np.linspace(0, 1, 101)
    across = {"time_s": t, "penetration_m": np.ones(101), "speed_m_s": np.full(101, 10.0), "v1_m_s": 10*np.cos(t), "v2_m_s": np.zeros(101), "v3_m_s": 10*np.sin(t)}
    said = boundaryLayer.separation_note("frictionLine", across)
    assert "up to 57 deg" in said and "t = 0.18 s" in said
    assert boundaryLayer.separation_note("none", across)
    assert not boundaryLayer.separation_note("wallFunction", across)
    assert not boundaryLayer.separation_note("frictionLine", {**across, "penetration_m": -np.ones(101)})
    assert not boundaryLayer.separation_note("frictionLine", {**across, "v3_m_s": np.zeros(101)})
    assert not boundaryLayer.separation_note("frictionLine", {**across, "speed_m_s": np.where(t > 0.1, 0.1, 10)})


def test_attitudeNotes() -> None:
    t = np.linspace(0, 1, 101)
    straight = {"penetration_m": np.ones(101), "speed_m_s": np.full(101, 10.0), "v1_m_s": np.full(101, -10.0), "v2_m_s": np.zeros(101), "v3_m_s": np.zeros(101),
                "pitch_deg": np.full(101, -90.0)}
    assert attitude_notes(straight) == []
    [said] = attitude_notes({**straight, "v3_m_s": 10*np.tan(np.radians(30*t))})
    assert "up to 30 deg" in said
    [said] = attitude_notes({**straight, "pitch_deg": -90 + 40*t})
    assert "elevation" in said
    assert attitude_notes({name: value for name, value in straight.items() if name[0] != "v"}) == []
