# SPDX-License-Identifier: GPL-3.0-or-later
"""The snapped mesh of a cone-cylinder whose file is in millimetres: patches, zone, quality, layers, edges and place."""
import re
import shutil
from pathlib import Path
from typing import Dict, Tuple

import numpy as np
import pytest

from conftest import REPOSITORY
from tutorials import foam
from plunge import foamDictionary, snappedMesh
from plunge.shapes.surface import Surface
from plunge.stl import write_stl

RADIUS, CONE, LENGTH = 0.12, 0.3, 1.0
TIER = {"backgroundSpacing": 0.2, "refinementLevels": 2, "bodySpacing": 0.05, "noseSpacing": 0.02, "offset": [0.3, 0.3, 0.3]}
# Neither level nor in the plane: a heeled body in a sideslip
FORWARD = np.array([0.3, 0.2, -0.9]) / np.linalg.norm([0.3, 0.2, -0.9])
DORSAL = np.cross(FORWARD, [0.1, 0.9, 0.3])
DORSAL /= np.linalg.norm(DORSAL)
NOSE = np.array([0.5, -0.2, 0.1])
LEVEL = np.array([0.25881904510252074, 0, -0.9659258262890683])


def coneCylinder(path: Path, around: int = 48) -> Path:
    """An STL of the body [mm], its tip at the file's origin, flying along +z."""
    phi = 2*np.pi*np.arange(around)/around
    ring = np.column_stack((RADIUS*np.cos(phi), RADIUS*np.sin(phi), np.zeros(around)))
    points = np.vstack(([[0, 0, 0], [0, 0, -LENGTH]], ring - [0, 0, CONE], ring - [0, 0, LENGTH]))
    a = 2 + np.arange(around)
    b = 2 + (np.arange(around) + 1) % around
    tip, base = np.zeros(around, int), np.ones(around, int)
    triangles = np.vstack((
        np.column_stack((tip, a, b)), np.column_stack((a, a + around, b + around)), np.column_stack((a, b + around, b)),
        np.column_stack((base, b + around, a + around))))
    write_stl(path, 1000*points, triangles)
    return path


def meshed(run: Path, model: str, mesh: str, forward: np.ndarray, dorsal: np.ndarray) -> Tuple[Surface, Dict[str, str]]:
    """The body's mesh made in an otherwise empty case; what snappyHexMesh and checkMesh said."""
    shape = Surface(coneCylinder(run / "cone.stl"), 0.001, nose=(0, 0, 1), dorsal=(1, 0, 0))
    return shape, meshedShape(shape, TIER, run, model, mesh, forward, dorsal)


def meshedShape(shape: Surface, tier: Dict[str, object], run: Path, model: str, mesh: str, forward: np.ndarray,
                dorsal: np.ndarray) -> Dict[str, str]:
    shutil.copytree(REPOSITORY / "etc/methods/meshes/snapped", run, dirs_exist_ok=True)
    (run / "system").mkdir()
    shutil.copy(REPOSITORY / "etc/methods/meshes/system/createPatchDict", run / "system")
    sections = snappedMesh.sections(shape, tier, shape.length, 1, full=model == "full", single=mesh == "single")
    foamDictionary.write(run / "system/plungeGenerated", "A test's", [
        ("Choices", {"model": model, "mesh": mesh}), *sections, ("Place", snappedMesh.place(forward, dorsal, NOSE))])
    head = "FoamFile { version 2.0; format ascii; class dictionary; object x; }\n"
    (run / "system/controlDict").write_text(head + "libs (overset); deltaT 1; endTime 1; writeInterval 1; writeFormat ascii; writePrecision 12;\n")
    (run / "system/fvSchemes").write_text(head + "divSchemes {} gradSchemes {} laplacianSchemes {}\n")
    (run / "system/fvSolution").write_text(head)
    snappedMesh.write_surface(shape, run, sections[0][1]["snappedWallSpacing"])
    placed = {key: foamDictionary.format_value(value) for key, value in snappedMesh.place(forward, dorsal, NOSE).items()}
    foam("blockMesh", case=run / "body")
    foam("snappyHexMesh", "-dict", "system/refineDict", "-overwrite", case=run / "body")
    foam("surfaceFeatureExtract", case=run / "body")
    said = {"snappyHexMesh": foam("snappyHexMesh", "-overwrite", case=run / "body")}
    foam("surfaceMeshExtract", "-constant", "-patches", "(wall)", "meshed.stl", case=run / "body")
    said["lost"] = snappedMesh.check_meshed(shape, run, model == "full", sections[0][1]["snappedWallSpacing"])
    foam("transformPoints", "-translate", placed["snappedTranslation"], "-rollPitchYaw", placed["snappedRollPitchYaw"], case=run / "body")
    shutil.copytree(run / "body/constant/polyMesh", run / "constant/polyMesh")
    foam("createPatch", "-overwrite", case=run)
    said["checkMesh"] = foam("checkMesh", "-constant", case=run)
    return said


def number(pattern: str, text: str) -> float:
    """The last one that the pattern finds."""
    return float(re.findall(pattern, text)[-1])


def wall(run: Path, forward: np.ndarray, dorsal: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Points in the body's frame (aft, y, dorsal) and triangles of the patch body."""
    foam("surfaceMeshExtract", "-constant", "-patches", "(body)", "body.stl", case=run)
    points = np.array(re.findall(r"vertex +(\S+) +(\S+) +(\S+)", (run / "body.stl").read_text()), dtype=float)
    axes = np.column_stack((-forward, np.cross(dorsal, forward), dorsal))
    return (points - NOSE) @ axes, np.arange(len(points)).reshape(-1, 3)


def patches(run: Path) -> Dict[str, str]:
    """Type of each patch."""
    text = (run / "constant/polyMesh/boundary").read_text()
    return dict(re.findall(r"(\w+)\s*\{\s*type\s+(\w+);", text.split("FoamFile", 1)[1].split("}", 1)[1]))


def enclosed(points: np.ndarray, triangles: np.ndarray) -> float:
    """Volume between a surface and the plane y = 0, or within it, by the flux of (0, y, 0)."""
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    return abs(float((np.cross(b - a, c - a)[:, 1]/2) @ (a + b + c)[:, 1]/3))


@pytest.mark.parametrize("model, mesh, forward, dorsal, expected", [
    ("half", "overset", LEVEL, np.cross(LEVEL, [0, 1, 0]), {"sides": "overset", "body": "wall", "symmetry": "symmetryPlane"}),
    ("full", "single", FORWARD, DORSAL, {"far": "patch", "body": "wall"}),
])
def test_snappedMesh(tmp_path: Path, model: str, mesh: str, forward: np.ndarray, dorsal: np.ndarray, expected: Dict[str, str]) -> None:
    shape, said = meshed(tmp_path, model, mesh, forward, dorsal)
    check = said["checkMesh"]
    assert patches(tmp_path) == expected
    assert number(r"non-orthogonality Max: (\S+)", check) < 70
    assert "Mesh OK." in check, check[-3000:]
    cells = number(r"cells: +(\d+)", check)
    zones = (tmp_path / "constant/polyMesh/cellZones").read_text()
    assert number(r"bodyMesh\s*\{[^(]*?(\d+)\s*\(", zones) == cells
    assert number(r"Layer mesh : cells:(\d+)", said["snappyHexMesh"]) == cells
    faces, layers = re.findall(r"^wall +(\d+) +(\S+)", said["snappyHexMesh"], re.M)[-1]
    assert float(layers) > 0.9*int(foamDictionary.read(tmp_path / "system/plungeGenerated")["snappedLayers"])

    points, triangles = wall(tmp_path, forward, dorsal)
    share = 0.5 if model == "half" else 1
    assert enclosed(points, triangles) == pytest.approx(share*shape.volume, rel=0.02)
    # The tip, to 0.4 of the cells there (0.0125), which would cut off 0.02 to 0.035; the base
    assert 0 <= points[:, 0].min() + 1e-6 and points[:, 0].min() < 0.4*0.0125 and points[:, 0].max() == pytest.approx(LENGTH, abs=1e-3)
    # The edge between the cylinder and the flat base is kept, all round
    edge = points[(points[:, 0] > LENGTH - 2e-3) & (np.hypot(points[:, 1], points[:, 2]) > 0.98*RADIUS)]
    around = np.sort(np.arctan2(edge[:, 1], edge[:, 2]))
    assert np.diff(around).max() < 0.05*2*np.pi
    assert np.hypot(edge[:, 1], edge[:, 2]).max() < 1.001*RADIUS


def test_thinWings(tmp_path: Path) -> None:
    """A hull with wings a third as thick as the wall's cells: the mesh has them, with finer cells there."""
    x, y, z = (-0.5, -0.1, 0.1, 0.5), (-0.4, -0.07, 0.07, 0.4), (-0.07, -0.008, 0.008, 0.07)
    points = np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1).reshape(-1, 3)
    number = np.arange(64).reshape(4, 4, 4)
    filled = {(i, 1, k) for i in range(3) for k in range(3)} | {(1, 0, 1), (1, 2, 1)}
    faces = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    ways = ((0, 0, -1), (0, 0, 1), (0, -1, 0), (0, 1, 0), (-1, 0, 0), (1, 0, 0))
    triangles = []
    for cell in sorted(filled):
        corner = [number[cell[0] + (k & 1), cell[1] + (k >> 1 & 1), cell[2] + (k >> 2)] for k in range(8)]
        for (a, b, c, d), way in zip(faces, ways):
            if tuple(np.add(cell, way)) not in filled:
                triangles += [(corner[a], corner[b], corner[c]), (corner[a], corner[c], corner[d])]
    write_stl(tmp_path / "wings.stl", points, np.array(triangles))
    shape = Surface(tmp_path / "wings.stl", 1, nose=(1, 0, 0), dorsal=(0, 0, 1))
    said = meshedShape(shape, {**TIER, "bodySpacing": 0.1}, tmp_path, "half", "overset", LEVEL, np.cross(LEVEL, [0, 1, 0]))
    volume, area = map(float, re.findall(r"(\S+) %", said["lost"]))
    assert volume == pytest.approx(100, abs=0.5) and area == pytest.approx(100, abs=0.5)
    assert "Mesh OK" in said["checkMesh"] or "Failed" not in said["checkMesh"]
