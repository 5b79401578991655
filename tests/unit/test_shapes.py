# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes of bodies, the meshes along their meridians, and scenes of them."""

from pathlib import Path

import numpy as np
import pytest

from plunge import case as cases, meridianMesh, scene as scenes
from plunge.checks import ParameterError
from plunge.methods import meshes, tiers
from plunge.shapes import ShapeError, read_shape
from plunge.studies.idealFlow import pressure as idealPressure
from plunge.studies.references import REFERENCES

PI = np.pi
CONE = {"type": "coneCylinder", "halfAngle": 30, "radius": 0.1, "length": 0.5}
HEIGHT = 0.1 / np.tan(PI / 6)
IN_SPACE = {
    "NACA": {"type": "NACA", "length": 1, "thicknessRatio": 0.15},
    "slender cone": {**CONE, "halfAngle": 12, "length": 0.8},
    "cone": CONE,
    "cone of no cylinder": {**CONE, "length": HEIGHT},
    "flat cone": {**CONE, "halfAngle": 80},
    "ogive": {"type": "ogiveCylinder", "radius": 0.1, "noseLength": 0.3, "length": 0.8},
    "hemisphere": {"type": "hemisphereCylinder", "radius": 0.1, "length": 0.4},
    "flat": {"type": "flatCylinder", "radius": 0.1, "length": 0.4},
    "sphere": {"type": "sphere", "radius": 0.5},
    "spheroid": {"type": "spheroid", "length": 4, "diameter": 1},
    "oblate": {"type": "spheroid", "length": 1, "diameter": 2},
}
IN_THE_PLANE = {
    "circle": {"type": "circle", "radius": 0.5},
    "ellipse": {"type": "ellipse", "length": 3, "width": 1},
    "wedge": {"type": "wedge", "halfAngle": 60, "halfWidth": 0.3},
    "wedge and block": {"type": "wedge", "halfAngle": 45, "halfWidth": 0.3, "length": 0.6},
}


def shape(entries: dict, folder: Path = Path(".")):
    return read_shape(entries, folder, "scene")


@pytest.mark.parametrize("entries, volume, centre, pitch", [
    (IN_SPACE["sphere"], PI / 6, 0.5, PI / 60),
    (IN_SPACE["spheroid"], 2 * PI / 3, 2, 2 * PI / 3 * (4 + 0.25) / 5),
    (IN_SPACE["flat"], PI * 0.01 * 0.4, 0.2, PI * 0.01 * 0.4 * (0.03 + 0.16) / 12),
    (IN_SPACE["cone of no cylinder"], PI * 0.01 * HEIGHT / 3, 0.75 * HEIGHT, PI * 0.01 * HEIGHT / 3 * 3 / 80 * (4 * 0.01 + HEIGHT**2)),
    (CONE, PI * 0.01 * (0.5 - 2 * HEIGHT / 3), None, None),
    ({**IN_SPACE["hemisphere"], "length": 0.1}, 2 * PI / 3 * 1e-3, 0.0625, 2 * PI / 3 * 1e-3 * 83 / 320 * 0.01),
    (IN_THE_PLANE["circle"], PI / 4, 0.5, PI / 32),
    (IN_THE_PLANE["ellipse"], 3 * PI / 4, 1.5, 3 * PI / 4 * (2.25 + 0.25) / 4),
    (IN_THE_PLANE["wedge"], 0.3**2 / np.tan(PI / 3), 2 / 3 * 0.3 / np.tan(PI / 3), None),
])
def test_mass_properties(entries: dict, volume: float, centre: "float | None", pitch: "float | None") -> None:
    body = shape(entries)
    assert body.volume == pytest.approx(volume, rel=1e-6)
    if centre is not None:
        assert body.centre == pytest.approx([centre, 0, 0], rel=1e-6, abs=1e-9)
    if pitch is not None:
        assert body.inertia[1, 1] == pytest.approx(pitch, rel=1e-5)


@pytest.mark.parametrize("entries", [*IN_SPACE.values(), *IN_THE_PLANE.values()], ids=[*IN_SPACE, *IN_THE_PLANE])
def test_surface_is_closed_and_has_the_volume(entries: dict) -> None:
    body = shape(entries)
    points, triangles = body.surface()
    edges = np.vstack([triangles[:, [a, (a + 1) % 3]] for a in range(3)])
    assert len(np.unique(edges, axis=0)) == len(edges)
    assert {tuple(edge) for edge in edges} == {tuple(edge) for edge in edges[:, ::-1]}
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    assert np.einsum("ij,ij->", a, np.cross(b, c)) / 6 == pytest.approx(body.volume, rel=2e-3)


def test_added_mass_is_lambs() -> None:
    translation, rotation = shape(IN_SPACE["spheroid"]).added_mass_coefficients()
    assert translation == pytest.approx([0.082, 0.860, 0.860], abs=1e-3)    # Lamb 1932, art. 115: his table for 4:1
    assert rotation == pytest.approx([0, 0.608, 0.608], abs=1e-3)
    zeta = 1 / np.sqrt(3)   # of planetary spheroids, art. 108: here the axis is half as long as the diameter
    alpha = 2 * (zeta**2 + 1) * (1 - zeta * np.arctan(1 / zeta))
    beta = zeta * (zeta**2 + 1) * np.arctan(1 / zeta) - zeta**2
    assert shape(IN_SPACE["oblate"]).added_mass_coefficients()[0] == pytest.approx([alpha / (2 - alpha), *[beta / (2 - beta)] * 2])
    translation, rotation = shape(IN_THE_PLANE["ellipse"]).added_mass_coefficients()
    assert (translation[0], translation[2]) == pytest.approx((1 / 3, 3))
    body = shape(IN_THE_PLANE["ellipse"])
    assert rotation[1] * body.inertia[1, 1] == pytest.approx(PI / 8 * (2.25 - 0.25) ** 2)


def of_model(entries: dict, model: str, resolution: float = 1) -> tuple:
    body = shape(entries)

    class Scene:    # what sizes depend on
        shape, scale = body, body.length * (10 * body.slenderness) ** (1 / 3)

    size = meshes.Meshes(Scene, tiers.read("fast", {}), resolution, 1, model, "single" if model in ("plane", "axisymmetric") else "overset").size()
    return body, size, meridianMesh.build(body, size, model)


@pytest.mark.parametrize("model", ["half", "axisymmetric"])
@pytest.mark.parametrize("name", IN_SPACE)
def test_meshes_keep_the_body_and_its_corners(name: str, model: str) -> None:
    """No cell is folded (build refuses that), the wall has the body's volume, and nodes lie on its corners."""
    body, size, mesh = of_model(IN_SPACE[name], model)
    wall = mesh.nodes[mesh.wall]
    middle = wall.mean(axis=1, keepdims=True)
    areas = 0.5 * np.cross(wall - middle, np.roll(wall, -1, axis=1) - middle).sum(axis=1)
    along = abs(float(np.sum(areas[:, 0] * middle[:, 0, 0])))   # of the volume, by the flux of x along x
    share = 0.5 if model == "half" else np.sin(np.radians(5)) / (2 * PI)
    assert along / share == pytest.approx(body.volume, rel=0.02)
    radius = np.hypot(mesh.nodes[:, 1], mesh.nodes[:, 2])
    for corner in body.curve.breaks[1:-1]:
        x, r = (float(v) for v in body.curve.point(np.array(corner)))
        assert np.hypot(mesh.nodes[:, 0] - x, radius - r).min() < 1e-9 * body.length


@pytest.mark.parametrize("name", IN_THE_PLANE)
def test_meshes_in_the_plane(name: str) -> None:
    body, size, mesh = of_model(IN_THE_PLANE[name], "plane")
    assert len(mesh.hexahedra) == meshes.body_cells(size, "plane")
    outline = mesh.nodes[np.unique(mesh.wall)]
    assert set(outline[:, 1]) == {-0.5, 0.5}
    for corner in body.upper.breaks[1:-1]:
        x, z = (float(v) for v in body.upper.point(np.array(corner)))
        for side in (z, -z):
            assert np.hypot(outline[:, 0] - x, outline[:, 2] - side).min() < 1e-9


def csv(folder: Path, text: str) -> dict:
    (folder / "points.csv").write_text(text)
    return {"type": "meridian", "file": "points.csv"}


def test_the_mesh_about_a_hollow_stern_reaches_far() -> None:
    """SUBOFF's hull, whose stern is hollow, in 3.2 of its lengths: lines along its normals would cross."""
    of_model({"type": "meridian", "file": str(REFERENCES / "Suboff/profile.csv")}, "axisymmetric")


def test_sources_on_a_sphere_are_its_ideal_flow() -> None:
    """Lamb 1932, art. 96: 3/2 of the stream's speed at the equator."""
    found = idealPressure(shape({"type": "sphere", "radius": 0.5}).curve)
    assert np.abs(found.value - (1 - 9 / 4 * (1 - (2 * found.time - 1) ** 2))).max() < 0.005


def test_meridian_from_points_is_that_of_the_shape(tmp_path: Path) -> None:
    phi = np.linspace(PI, 0, 61)
    sphere = shape(csv(tmp_path, "x,r\n" + "\n".join(f"{0.5 + 0.5 * np.cos(a):.9f},{0.5 * np.sin(a):.9f}" for a in phi)), tmp_path)
    assert sphere.volume == pytest.approx(PI / 6, rel=1e-4) and sphere.nose_radius == pytest.approx(0.5, rel=0.02)
    assert len(sphere.curve.breaks) == 2    # no corner
    # In millimetres, from the tail to the nose, base left open
    cone = shape({**csv(tmp_path, f"500 100\n{1000 * HEIGHT:.9f} 100\n0 0\n"), "scale": 0.001}, tmp_path)
    assert cone.volume == pytest.approx(shape(CONE).volume, rel=1e-6)
    assert len(cone.curve.breaks) == 4 and cone.nose_radius == 0


def test_outline_from_points(tmp_path: Path) -> None:
    (tmp_path / "o.csv").write_text("# a box with a keel\n0 -0.2\n1 -0.2\n1 0.2\n0 0.2\n")
    box = shape({"type": "outline", "file": "o.csv"}, tmp_path)
    assert box.volume == pytest.approx(0.4) and box.inertia[1, 1] == pytest.approx(0.4 * (1 + 0.16) / 12)
    (tmp_path / "o.csv").write_text("0 0\n0.6 0.1\n1 0\n0.5 -0.3\n")
    lopsided = shape({"type": "outline", "file": "o.csv"}, tmp_path)
    assert not lopsided.mirrored and lopsided.volume == pytest.approx(0.5 * 0.4)
    assert lopsided.centre[2] < 0


@pytest.mark.parametrize("text, expected", [
    ("0 0\n1 0.1\n2 x\n", "line 3: '2 x'; expected two numbers"),
    ("0 0\n1 0\n", "2 points; expected three or more"),
    ("0 0\n1 0.2\n1 0.2\n2 0\n", "are the same"),
    ("0 0\n1 -0.2\n2 0\n", "a radius of -0.2; expected none below 0"),
    ("0 0\n1 0.2\n0.5 0.3\n0.6 0.1\n2 0\n", "crosses"),
])
def test_bad_points_are_named(tmp_path: Path, text: str, expected: str) -> None:
    with pytest.raises((ShapeError, ParameterError), match=expected.replace("(", r"\(")):
        shape(csv(tmp_path, text), tmp_path)


@pytest.mark.parametrize("entries, expected", [
    ({"type": "sphere"}, "entry 'radius' is missing; expected a number above 0"),
    ({**CONE, "halfAngle": 95}, "entry 'halfAngle' is 95; expected degrees from the axis, from 2 to 88"),
    ({**CONE, "length": 0.1}, "entry 'length' is 0.1; expected at least that of the cone"),
    ({"type": "ogiveCylinder", "radius": 1, "noseLength": 0.5, "length": 3}, "entry 'noseLength' is 0.5; expected at least the radius"),
    ({"type": "meridian", "file": "none.csv"}, "none.csv cannot be read"),
    (None, "entry 'shape' has no type"),
])
def test_bad_shapes_are_named(entries: dict, expected: str) -> None:
    with pytest.raises((ShapeError, ParameterError), match=expected):
        shape(entries)


def write(path: Path, text: str) -> Path:
    path.write_text(text)
    return path


WATER = "fluids water;"


def test_scene_by_itself(tmp_path: Path) -> None:
    """A scene file needs no case about it; a fall gives the speed, and the lowest point the gap."""
    file = write(tmp_path / "cone", f"body {{ shape {{ type coneCylinder; halfAngle 45; radius 0.026; length 0.29; }} mass 0.59; "
                                    f"freedom axial; }} {WATER} entry {{ drop 1; }} duration 0.01;")
    made = cases.derive(file)
    assert made.scene.speed == pytest.approx(np.sqrt(2 * 9.81)) and made.flat["model"] == "axisymmetric"
    assert made.scene.lowest == pytest.approx(0.01 * made.scene.scale) and made.scene.folder == tmp_path
    tilted = scenes.read(file, {"entry.attitude": 60, "body.freedom": "free"})
    assert tilted.lowest == pytest.approx(0.01 * tilted.scale) and tilted.nose[2] >= tilted.lowest


def test_thrust_is_of_the_models_part(tmp_path: Path) -> None:
    file = write(tmp_path / "rising", f"body {{ shape {{ type sphere; radius 0.1; }} density 1000; freedom axial; thrust {{ force 72; end 0.2; }} }} {WATER} "
                                      "entry { speed 1; angle -90; depth 2; } duration 0.5;")
    flat = cases.derive(file).flat
    assert flat["thrustForce"] / 72 == pytest.approx(flat["modelledMass"] / flat["bodyMass"])
    assert (flat["thrustStart"], flat["thrustEnd"]) == (0, 0.2) and flat["thrustAt"] == pytest.approx([0, 0, -1.9])
    # Its mesh reaches as far as the thrust takes the body: at 72/(1.5 m) for 0.2 s
    still = cases.derive(file, {"body.thrust.force": 1e-3}).scene
    rise = 72 / (1.5 * flat["bodyMass"]) * 0.2 * 0.4
    assert cases.derive(file).scene.heights[1] - still.heights[1] == pytest.approx(rise, rel=0.1)
    assert cases.derive(file, {"method": "particles"}).flat["thrust"] == "yes"
    for entries, expected in (({"method": "slenderBody"}, "entry thrust, which it leaves out"), ({"body.freedom": "prescribed"}, "freedom is prescribed"),
                              ({"body.thrust.start": 0.3}, "the thrust ends at 0.2 s; expected less")):
        with pytest.raises(ParameterError, match=expected):
            cases.derive(file, entries)


def test_inertia_about_principal_axes(tmp_path: Path) -> None:
    """Of a lopsided body the axes that it turns about are not the geometry's."""
    (tmp_path / "o.csv").write_text("0 0\n0.6 0.1\n1 0\n0.9 -0.3\n")
    file = write(tmp_path / "keel", f"body {{ shape {{ type outline; file o.csv; }} density 500; freedom planar; }} {WATER} "
                                    "entry { speed 2; } travel 1;")
    read = scenes.read(file)
    inertia, axes = read.principal
    tensor = np.diag([-1, 1, 1]) @ read.shape.inertia @ np.diag([-1, 1, 1]) * 500
    assert axes.T @ tensor @ axes == pytest.approx(np.diag(inertia), abs=1e-9)
    assert np.linalg.det(read.orientation) == pytest.approx(1)


@pytest.mark.parametrize("entry, expected", [
    ("entry { speed 0; depth 2; } travel 1;", "entry 'travel' is given, but the speed is 0; expected duration"),
    ("entry { speed 1; gap 0.1; depth 2; } travel 1;", "entries 'entry.gap' and 'entry.depth' are both given"),
    ("entry { speed 1; }", "entry 'duration' is missing; expected duration"),
    ("entry { speed 1; } duration 1; travel 1;", "entries 'duration' and 'travel' are both given"),
])
def test_bad_scenes_are_named(tmp_path: Path, entry: str, expected: str) -> None:
    file = write(tmp_path / "ball", f"body {{ shape {{ type sphere; radius 0.1; }} density 500; freedom free; }} {WATER} {entry}")
    with pytest.raises(ParameterError, match=expected):
        scenes.read(file)
