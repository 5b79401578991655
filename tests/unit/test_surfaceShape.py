# SPDX-License-Identifier: GPL-3.0-or-later
"""The shape `surface`: reading, cleaning, refusals, axes, and what it says of bodies whose properties are known."""
from __future__ import annotations

import time
from pathlib import Path

import numpy as np
import pytest

from plunge import snappedMesh
from plunge.checks import ParameterError
from plunge.shapes import NACA, ShapeError, read_shape
from plunge.shapes.ellipsoid import ellipsoid_added_mass
from plunge.shapes.surface import Surface, SurfaceError
from plunge.stl import write_stl

CUBE_FACES = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
CUBE_TRIANGLES = np.vstack((CUBE_FACES[:, [0, 1, 2]], CUBE_FACES[:, [0, 2, 3]]))


def box(low, high) -> tuple[np.ndarray, np.ndarray]:
    """Points and outward triangles of a box."""
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)])
    return np.asarray(low) + corners * np.subtract(high, low), CUBE_TRIANGLES


def joined(*parts) -> tuple[np.ndarray, np.ndarray]:
    starts = np.cumsum([0, *(len(points) for points, _ in parts)])
    return np.vstack([p for p, _ in parts]), np.vstack([t + start for (_, t), start in zip(parts, starts)])


def ellipsoid(a: float, b: float, c: float, rings: int = 120) -> tuple[np.ndarray, np.ndarray]:
    """Points and outward triangles of an ellipsoid, of a sphere's that are scaled."""
    theta, phi = np.pi * np.arange(1, rings) / rings, 2 * np.pi * np.arange(rings) / rings
    circles = np.stack(np.broadcast_arrays(np.cos(theta)[:, None], np.sin(theta)[:, None] * np.cos(phi), np.sin(theta)[:, None] * np.sin(phi)), axis=-1)
    points = np.vstack(([[1, 0, 0]], circles.reshape(-1, 3), [[-1, 0, 0]])) * [a, b, c]
    number = 1 + np.arange((rings - 1) * rings).reshape(rings - 1, rings)
    ahead = np.roll(number, -1, axis=1)
    p, q, r, s = number[:-1].ravel(), ahead[:-1].ravel(), ahead[1:].ravel(), number[1:].ravel()
    front, back = np.zeros(rings, int), np.full(rings, len(points) - 1)
    return points, np.vstack((
        np.column_stack((front, number[0], ahead[0])), np.column_stack((p, s, r)), np.column_stack((p, r, q)),
        np.column_stack((back, ahead[-1], number[-1]))))


def stl(folder: Path, points: np.ndarray, triangles: np.ndarray) -> Path:
    path = folder / "shape.stl"
    write_stl(path, points, triangles)
    return path


def ascii_stl(path: Path, *solids) -> Path:
    text = ""
    for number, (points, triangles) in enumerate(solids):
        facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in points[t])
                         + "endloop\nendfacet\n" for t in triangles)
        text += f"solid part{number}\n{facets}endsolid part{number}\n"
    path.write_text(text)
    return path


def test_box_has_the_properties_of_a_box_in_the_bodys_frame(tmp_path):
    # 4 by 2 by 1, far from the file's origin; nose along the file's -y, dorsal along x
    shape = Surface(stl(tmp_path, *box([100, 50, -3], [101, 54, -1])), nose=(0, -1, 0), dorsal=(2, 0, 0))
    assert (shape.length, shape.volume, shape.wetted_area) == pytest.approx((4, 8, 28), rel=1e-6)
    assert shape.centre == pytest.approx([2, 0, 0], abs=1e-6)
    assert np.array(shape.bounds) == pytest.approx(np.array([[0, -1, -0.5], [4, 1, 0.5]]), abs=1e-6)
    assert shape.inertia == pytest.approx(8 / 12 * np.diag([2**2 + 1, 4**2 + 1, 4**2 + 2**2]), rel=1e-6, abs=1e-9)
    assert shape.isSymmetric and not shape.isRevolution
    assert shape.notes == []


def test_surface_is_wound_outwards_with_the_nose_first(tmp_path):
    points, triangles = ellipsoid(2, 1, 0.5)
    shape = Surface(stl(tmp_path, points + [7, 8, 9], triangles), nose=(-1, 0, 0), dorsal=(0, 0, 1))
    points, triangles = shape.surface()
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    assert np.einsum("ij,ij->", a, np.cross(b, c)) / 6 == pytest.approx(shape.volume, rel=1e-9)
    assert points[points[:, 0].argmin()] == pytest.approx([0, 0, 0], abs=1e-6)
    assert shape.volume == pytest.approx(4 / 3 * np.pi * 2 * 1 * 0.5, rel=2e-3)


def test_side_points_so_that_forward_side_dorsal_are_right_handed(tmp_path):
    # A lump on the file's +y: with the nose along x and z dorsal, y is to the same side
    points, triangles = box([0, 0, 0], [4, 1, 1])
    points[(points[:, 0] > 3) & (points[:, 1] > 0.5), 1] = 2
    shape = Surface(stl(tmp_path, points, triangles), nose=(1, 0, 0), dorsal=(0, 0, 1))
    low, high = shape.bounds
    assert high[1] > -low[1]
    assert not shape.isSymmetric


def test_body_of_revolution_as_from_its_formula(tmp_path):
    body = NACA(1.0, 0.1)
    points, triangles = body.surface()
    shape = Surface(stl(tmp_path, points * [-1, 1, 1], triangles[:, ::-1]))
    assert "(1 0 0)" in shape.notes[0] and "fuller end is in front" in shape.notes[0]
    assert shape.volume == pytest.approx(body.volume, rel=1e-3)
    assert shape.centre == pytest.approx([body.centroid, 0, 0], abs=1e-5)
    assert shape.wetted_area == pytest.approx(body.wetted_area, rel=1e-3)
    assert np.diag(shape.inertia)[:2] == pytest.approx(body.unit_inertia(), rel=1e-3)
    assert shape.max_diameter == pytest.approx(0.1, rel=2e-3)
    assert shape.nose_radius == pytest.approx(body.nose_radius, rel=0.1)


@pytest.mark.parametrize("inverted", ["all", "some"])
def test_inverted_triangles_are_turned(tmp_path, inverted):
    points, triangles = ellipsoid(2, 1, 1, rings=24)
    turned = triangles.copy()
    chosen = slice(None) if inverted == "all" else slice(None, None, 3)
    turned[chosen] = turned[chosen, ::-1]
    right = Surface(stl(tmp_path, points, triangles), nose=(1, 0, 0), dorsal=(0, 0, 1))
    shape = Surface(stl(tmp_path, points, turned), nose=(1, 0, 0), dorsal=(0, 0, 1))
    assert shape.volume == pytest.approx(right.volume, rel=1e-9) and shape.volume > 0
    assert right.notes == [] and f"{len(turned[chosen])} of {len(triangles)} triangles turned" in shape.notes[0]
    named = f"the triangles 0-{len(triangles) - 1}" if inverted == "all" else "the triangles 0 3 6 9 12 15 18 21 ..."
    assert shape.notes[0].endswith(named)


def test_a_part_inside_out_is_turned_and_named(tmp_path):
    points, triangles = box([0.8, 0.2, 0.2], [3, 0.8, 0.8])
    shape = Surface(stl(tmp_path, *joined(box([0, 0, 0], [1, 1, 1]), (points, triangles[:, ::-1]))))
    assert shape.volume == pytest.approx(1 + 2 * 0.36, rel=1e-6)
    assert shape.notes[0].startswith("12 of 24 triangles turned") and shape.notes[0].endswith("from 0 the triangles 12-23")


def test_a_surface_that_passes_through_itself_is_refused_with_its_triangles(tmp_path):
    # A corner of a box drawn through the face opposite: the three faces at it pass through others
    points, triangles = box([0, 0, 0], [1, 1, 1])
    points = points.copy()
    points[7] = [0.3, 0.4, -2]
    with pytest.raises(SurfaceError, match=r"passes through itself: \d+ of its 12 triangles do, from 0 the triangles .*expected one closed"):
        Surface(stl(tmp_path, points, triangles))


def test_parts_that_lie_on_each_other_are_refused(tmp_path):
    one = box([0, 0, 0], [1, 1, 1])
    with pytest.raises(SurfaceError, match="lie on each other in pairs"):
        Surface(stl(tmp_path, *joined(one, one)))


def test_parts_whose_faces_lie_in_each_other_are_united(tmp_path):
    shape = Surface(stl(tmp_path, *joined(box([0, 0, 0], [1, 1, 1]), box([0.5, 0, 0], [1.5, 1, 1]))))
    assert shape.notes[0] == "2 closed parts that overlap united"
    assert shape.volume == pytest.approx(1.5, rel=1e-4)


@pytest.mark.parametrize("header", [b"solid body", b"solid body\n facet normal 1 0 0\n"])
def test_a_binary_file_that_starts_with_solid(tmp_path, header):
    path = stl(tmp_path, *box([0, 0, 0], [3, 1, 1]))
    path.write_bytes(header.ljust(80) + path.read_bytes()[80:])
    assert Surface(path).volume == pytest.approx(3)


def test_leak_is_refused_with_its_place(tmp_path):
    points, triangles = ellipsoid(200, 50, 50, rings=24)
    a, b, c = points[triangles[100]]
    with pytest.raises(SurfaceError) as error:
        Surface(stl(tmp_path, points, np.delete(triangles, 100, axis=0)), scale=0.001)
    low, high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
    place = "(" + " ".join(f"{x:.4g}" for x in (low + high) / 2)
    assert "shape.stl: is not watertight: 3 open edges, in 1 place(s)" in str(error.value)
    assert place[:5] in str(error.value) and "file's units" in str(error.value)


def test_plate_inside_is_refused(tmp_path):
    points, triangles = box([0, 0, 0], [1, 1, 1])
    with pytest.raises(SurfaceError, match="edges with more than two triangles"):
        Surface(stl(tmp_path, points, np.vstack((triangles, [[0, 3, 7]]))))


def test_millimetres_need_a_scale(tmp_path):
    path = stl(tmp_path, *ellipsoid(500, 50, 50, rings=24))
    with pytest.raises(SurfaceError, match=r"1000 m long with a scale of 1; expected .* 'scale'.*0.001 for millimetres"):
        Surface(path)
    assert Surface(path, scale=0.001).length == pytest.approx(1)


def test_metres_taken_for_millimetres_are_refused(tmp_path):
    with pytest.raises(SurfaceError, match="expected 0.001 to 100 m"):
        Surface(stl(tmp_path, *box([0, 0, 0], [0.9, 0.2, 0.2])), scale=0.001)


def test_quadrilaterals_of_an_obj(tmp_path):
    points, _ = box([0, 0, 0], [3, 1, 1])
    path = tmp_path / "shape.OBJ"
    # Each face with points of its own
    path.write_text("# a box\no box\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in points[CUBE_FACES].reshape(-1, 3))
                    + "".join("f " + " ".join(str(4 * k + i) for i in (1, 2, 3, 4)) + "\n" for k in range(6)))
    shape = Surface(path)
    assert (shape.volume, shape.length, len(shape.surface()[0])) == (pytest.approx(3), pytest.approx(3), 8)


def test_solids_of_an_ascii_file_are_one_body_where_they_close_it(tmp_path):
    points, triangles = box([0, 0, 0], [3, 1, 1])
    shape = Surface(ascii_stl(tmp_path / "two.stl", (points, triangles[:5]), (points, triangles[5:])))
    assert shape.volume == pytest.approx(3)


def test_two_bodies_are_refused(tmp_path):
    with pytest.raises(SurfaceError, match="2 closed parts that do not touch.* from 0 the triangles 12-23"):
        Surface(stl(tmp_path, *joined(box([0, 0, 0], [1, 1, 1]), box([2, 0, 0], [3, 1, 1]))))


def test_cavity_is_dropped(tmp_path):
    shape = Surface(stl(tmp_path, *joined(box([0, 0, 0], [3, 1, 1]), box([1, 0.2, 0.2], [2, 0.8, 0.8]))))
    assert shape.volume == pytest.approx(3)
    assert "1 closed part(s) inside the body dropped" in shape.notes[0]


def test_parts_that_overlap_are_united(tmp_path):
    shape = Surface(stl(tmp_path, *joined(ellipsoid(2, 0.5, 0.5, 24), box([-0.31, 0.1, -0.043], [0.31, 1.5, 0.047]))))
    assert shape.notes[0] == "2 closed parts that overlap united"
    sphere = Surface(stl(tmp_path, *ellipsoid(2, 0.5, 0.5, 24))).volume
    assert sphere + 0.62 * 0.09 * 1.0 < shape.volume < sphere + 0.62 * 0.09 * 1.4


def fin(top: float) -> tuple[np.ndarray, np.ndarray]:
    """Points and outward triangles of a fin of 24 sides, with its leading edge in the plane of symmetry."""
    angle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    rim = np.column_stack((-0.3 * np.cos(angle), -0.06 * np.sin(angle)))
    a, cap = np.arange(24), np.column_stack((np.zeros(22, int), np.arange(1, 23), np.arange(2, 24)))
    b = np.roll(a, -1)
    points = np.vstack([np.column_stack((rim, np.full(24, z))) for z in (0.1, top)])
    return points, np.vstack((np.column_stack((a, b, b + 24)), np.column_stack((a, b + 24, a + 24)), cap[:, ::-1], cap + 24))


def test_a_fin_in_the_plane_of_symmetry_is_united(tmp_path):
    """Its edge meets one of the hull's exactly."""
    hull = ellipsoid(2, 0.5, 0.5, 32)
    shape = Surface(stl(tmp_path, *joined(hull, fin(1.0))))
    assert "2 closed parts that overlap united" in shape.notes
    outside = 12 * np.sin(2 * np.pi / 24) * 0.3 * 0.06 * (1.0 - 0.495)  # above the hull
    assert shape.volume == pytest.approx(Surface(stl(tmp_path, *hull)).volume + outside, rel=1e-3)
    assert shape.isSymmetric
    assert any(note.startswith("dorsal: found as (0 0 1)") for note in shape.notes)


def test_parts_whose_union_does_not_end_are_refused(tmp_path, monkeypatch):
    monkeypatch.setattr("plunge.shapes.surface._MOVED", (0.0,))
    monkeypatch.setattr("plunge.shapes.surface._UNITING", 0.0)
    monkeypatch.setattr("plunge.shapes.surface._unite", lambda *_: time.sleep(60))
    with pytest.raises(SurfaceError, match="overlap, and they could not be united, one of them.*expected one closed surface"):
        Surface(stl(tmp_path, *joined(ellipsoid(2, 0.5, 0.5, 32), fin(1.0))))


@pytest.mark.parametrize("content, name, message", [
    (b"solid x\nendsolid x\n", "a.stl", "no triangles"),
    (b"nothing", "a.obj", "no triangles"),
    (b"", "a.step", "ends in .stl or .obj"),
    (None, "a.stl", "cannot be read"),
])
def test_files_that_are_no_surface(tmp_path, content, name, message):
    if content is not None:
        (tmp_path / name).write_bytes(content)
    with pytest.raises(SurfaceError, match=message):
        Surface(tmp_path / name)


def test_flat_end_is_behind_and_the_fin_is_dorsal(tmp_path):
    # A pyramid whose tip is along the file's -y, with a corner of its base drawn out to -x
    points = np.array([[0, -6, 0], [1, 0, 1], [-1.6, 0, 1], [-1.6, 0, -1], [1, 0, -1]], dtype=float)
    triangles = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [1, 3, 2], [1, 4, 3]])
    shape = Surface(stl(tmp_path, points, triangles))
    assert "nose: found as (0 -1 0)" in shape.notes[0] and "flat end is behind" in shape.notes[0]
    assert "dorsal: found as (-1 0 0)" in shape.notes[1] and shape.isSymmetric


def test_nose_radius_of_a_point_and_of_a_flat_nose(tmp_path):
    points = np.array([[0, -6, 0], [1, 0, 1], [-1, 0, 1], [-1, 0, -1], [1, 0, -1]], dtype=float)
    triangles = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [1, 3, 2], [1, 4, 3]])
    path = stl(tmp_path, points, triangles)
    assert Surface(path, nose=(0, -1, 0), dorsal=(0, 0, 1)).nose_radius == pytest.approx(0, abs=1e-6)
    flat = Surface(path, nose=(0, 1, 0), dorsal=(0, 0, 1))
    assert flat.nose_radius == flat.max_diameter / 2
    assert Surface(stl(tmp_path, *ellipsoid(0.5, 0.5, 0.5))).nose_radius == pytest.approx(0.5, rel=0.01)


def test_added_mass_of_a_sphere_a_spheroid_and_long_cylinders():
    translation, rotation = ellipsoid_added_mass(1, 1, 1)
    assert translation == pytest.approx([0.5] * 3) and rotation == pytest.approx([0] * 3)
    translation, rotation = ellipsoid_added_mass(4, 1, 1)
    # Lamb's table, art. 115: k1 0.082, k2 0.860, k' 0.608 at 3.99:1
    assert [translation[0], translation[1], rotation[1]] == pytest.approx([0.082, 0.860, 0.608], abs=1e-3)
    # Of an elliptic cylinder: c/b across b, and (b^2 - c^2)^2/(2 b c (b^2 + c^2)) about its axis
    translation, rotation = ellipsoid_added_mass(1e4, 2, 1)
    assert translation == pytest.approx([0, 0.5, 2], abs=1e-4)
    assert rotation[0] == pytest.approx(9 / 20, rel=1e-4)


def test_added_mass_follows_the_bodys_axes(tmp_path):
    shape = Surface(stl(tmp_path, *ellipsoid(0.5, 2, 1)), nose=(0, 1, 0), dorsal=(1, 0, 0))
    translation, rotation = shape.added_mass_coefficients()
    expected = ellipsoid_added_mass(2, 1, 0.5)
    assert translation == pytest.approx(expected[0], rel=1e-2) and rotation == pytest.approx(expected[1], rel=2e-2)


@pytest.mark.parametrize("change, message", [
    ({"colour": "red"}, "unknown entry 'colour'"),
    ({"file": 3}, "entry 'file' is 3; expected a text"),
    ({"scale": "mm"}, "entry 'scale' is mm; expected a number above 0"),
    ({"scale": -1}, "entry 'scale' is -1; expected a number above 0"),
    ({"nose": [1, 0]}, "entry 'nose' is .* expected three numbers"),
    ({"nose": [0, 0, 0]}, "entry 'nose' is .* expected three numbers, not all of them 0"),
    ({"nose": [1, 0, 0], "dorsal": [2, 0, 0]}, "entry 'dorsal' is .* across the nose's"),
])
def test_entries_that_are_refused(tmp_path, change, message):
    stl(tmp_path, *box([0, 0, 0], [3, 1, 1]))
    entry = {"type": "surface", "file": "shape.stl"}
    assert read_shape(entry, tmp_path, "scene").length == pytest.approx(3)
    with pytest.raises((ShapeError, ParameterError), match=message):
        read_shape({**entry, **change}, tmp_path, "scene")


def blocks(x, y, z, filled) -> tuple[np.ndarray, np.ndarray]:
    """Points and outward triangles of filled cells of a grid of planes."""
    points = np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1).reshape(-1, 3).astype(float)
    number = np.arange(len(points)).reshape(len(x), len(y), len(z))
    filled, triangles = {tuple(cell) for cell in filled}, []
    for cell in filled:
        corner = [number[tuple(np.add(cell, (k & 1, k >> 1 & 1, k >> 2)))] for k in range(8)]
        for face, way in zip(CUBE_FACES, ((0, 0, -1), (0, 0, 1), (0, -1, 0), (0, 1, 0), (-1, 0, 0), (1, 0, 0))):
            if tuple(np.add(cell, way)) not in filled:
                a, b, c, d = (corner[k] for k in face)
                triangles += [(a, b, c), (a, c, d)]
    return points, np.array(triangles)


def test_a_snapped_mesh_that_lost_a_wing_is_refused(tmp_path):
    hull = [(0, 1, 0), (0, 1, 1), (0, 1, 2)]
    grid = [-2, 2], [-3, -0.5, 0.5, 3], [-0.5, -0.02, 0.02, 0.5]
    shape = Surface(stl(tmp_path, *blocks(*grid, [*hull, (0, 0, 1), (0, 2, 1)])), nose=(1, 0, 0), dorsal=(0, 0, 1))
    points, triangles = shape.surface()
    (tmp_path / "body").mkdir()
    write_stl(tmp_path / "body/meshed.stl", points * [-1, 1, 1], triangles[:, ::-1])
    assert "100 % of the body's volume and 100 % of its area" in snappedMesh.check_meshed(shape, tmp_path, True, 0.2)
    write_stl(tmp_path / "body/meshed.stl", *blocks(*grid, hull))
    with pytest.raises(SurfaceError, match=r"has 83.33 % of the body's volume and 30.* % of its area.*too thin for cells of 0.2 m"):
        snappedMesh.check_meshed(shape, tmp_path, True, 0.2)
