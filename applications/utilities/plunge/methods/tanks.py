# SPDX-License-Identifier: GPL-3.0-or-later
"""A tank of liquid by both methods: particles, or a mesh of whole cells between the faces of liquid and obstacles."""

from __future__ import annotations

import shutil
from itertools import product
from pathlib import Path
from typing import Any, Iterator

import numpy as np

from plunge import foamDictionary
from plunge.checks import Check, ParameterError, positive
from plunge.decisions import Decision
from plunge.methods.meshes import cores_split, vector
from plunge.methods.tiers import TEMPLATES
from plunge.tank import FACES, OPEN, OUTSIDE, SIDES, Box, Tank

TIERS = TEMPLATES / "tank/tiers"
TIER_ENTRIES: dict[str, Check] = {name: positive for name in ("particleSpacing", "cellSpacing", "planeRefinement", "maxCo", "maxAlphaCo")}
# What a tank has in common with the scene of a body
_SHARED = {"particles": ("common/constant/g",),
           "meshes": ("common/constant/g", *(f"meshes/{name}" for name in (
               "constant/transportProperties", "constant/turbulenceProperties", "system/fvSchemes", "system/fvSolution",
               "system/decomposeParDict")))}
# c0 over the highest speed: eq. 5 of IAC-20-E2.1.9
_SOUND_OVER_SPEED = 10
# plungeSPH's steps, for the estimate: Courant number over h/(c0 + speed), h over the spacing
_COURANT, _SMOOTHING_LENGTH = 0.5, 1.5
# Of artificial viscosity. Liquid at rest has no shear that it could slow, and settles sooner.
_VISCOSITY = {True: 0.02, False: 0.01}
# Place of a gauge or probe that lies on a face of the mesh: off it by this share of a cell
_OFF = 1e-3


def spacing(tank: Tank, tier: dict[str, Any], method: str, model: str, resolution: float) -> float:
    """Of particles or cells [m]"""
    share = tier["particleSpacing" if method == "particles" else "cellSpacing"]
    return share * tank.depth / resolution / (tier["planeRefinement"] if model == "plane" else 1)


def sections(tank: Tank, tier: dict[str, Any], options: dict[str, Any], decided: dict[str, Decision]) -> list[tuple[str, dict[str, Any]]]:
    """What plungeGenerated holds."""
    method, modelled = options["method"], decided["model"].choice
    plane, fluids = modelled == "plane", tank.fluids
    cell = spacing(tank, tier, method, modelled, options["resolution"])
    down = [0, -1, 0] if plane and method == "particles" else [0, 0, -1]    # plungeSPH's plane is x and y
    common = [
        ("The scene", {
            "application": "plungeSPH" if method == "particles" else "plungeFoam", "scene": "tank", "fluids": tank.fluids_name,
            "model": modelled, "mesh": "none" if method == "particles" else "single", "tier": options["tier"],
            "resolution": options["resolution"], "dimensions": 2 if plane else 3, "still": "yes" if tank.still else "no",
            "depth": tank.depth, "referenceSpeed": tank.reference_speed, "maxSpeed": tank.max_speed, "walls": tank.walls,
        }),
        ("Fluids", {
            **fluids, "liquidKinematicViscosity": fluids["liquidViscosity"] / fluids["liquidDensity"],
            "gasKinematicViscosity": fluids["gasViscosity"] / fluids["gasDensity"],
            "gravityVector": vector(np.multiply(down, fluids["gravity"])),
        }),
        ("What is modelled, and why", {
            "boundaryLayer": decided["boundary_layer"].choice, "surfaceTensionModelled": decided["surface_tension"].choice,
            "decisions": [f"{name.replace('_', ' ')}: {decision.choice} ({decision.reason})" for name, decision in decided.items()],
        }),
        ("Run", {
            "cores": options["cores"], "duration": tank.duration, "frameInterval": tank.duration / tank.frames,
            "tableInterval": tank.interval,
        }),
    ]
    return [*common, *(_particles if method == "particles" else _meshes)(tank, tier, options, cell, plane)]


# --- particles


def _flat(place: np.ndarray, plane: bool) -> list[float]:
    """In plungeSPH's axes"""
    return vector([place[0], place[2], 0.0] if plane else place)


def _particles(tank: Tank, tier: dict[str, Any], options: dict[str, Any], cell: float, plane: bool) -> list[tuple[str, dict[str, Any]]]:
    def corners(box: Box) -> dict[str, Any]:
        return {"min": _flat(box.low, plane), "max": _flat(box.high, plane)}

    liquid = [{"type": "box", **corners(box), **({"hydrostatic": "yes"} if box.hydrostatic else {})} for box in tank.liquid.values()]
    walls: list[dict[str, Any]] = [{"name": name, "type": "box", "solid": "yes", **corners(box)} for name, box in tank.obstacles.items()]
    walls.append({"name": OUTSIDE, "type": "box", **corners(Box(np.zeros(3), tank.size)), **({"open": list(tank.open)} if tank.open else {})})
    c0 = float(options["soundSpeed"] or _SOUND_OVER_SPEED * tank.max_speed)
    volume = sum(box.volume for box in tank.liquid.values()) / (tank.size[1] if plane else 1.0)
    return [("Particles", {
        "particleSpacing": cell, "fluidBoxes": liquid, "wallBoxes": walls, "artificialViscosity": _VISCOSITY[tank.still],
        "particleMaxSpeed": c0 / _SOUND_OVER_SPEED, "soundOverSpeed": _SOUND_OVER_SPEED,
        "gaugePoints": {name: _flat(place, plane) for name, place in tank.gauges.items()},
        "probePoints": {name: _flat(place, plane) for name, place in tank.probes.items()},
        "fluidParticles": round(volume / cell ** (2 if plane else 3)),
        "estimatedSteps": round(tank.duration * (c0 + tank.max_speed) / (_COURANT * _SMOOTHING_LENGTH * cell), -1),
    })]


# --- a mesh


class Blocks:
    """The tank's mesh: blocks of equal cells between all faces of liquid and obstacles, but for those in obstacles."""

    def __init__(self, tank: Tank, cell: float, plane: bool):
        self.tank, self.plane = tank, plane
        size = np.array([tank.size[0], cell, tank.size[2]]) if plane else tank.size
        boxes = [*tank.liquid.values(), *tank.obstacles.values()]
        self.faces: list[np.ndarray] = []
        for axis in range(3):
            places = [0.0, size[axis]]
            if not (plane and axis == 1):
                places += [float(box.low[axis]) for box in boxes] + [float(box.high[axis]) for box in boxes]
            ordered = np.unique(np.clip(places, 0.0, size[axis]))
            self.faces.append(ordered[np.concatenate(([True], np.diff(ordered) > 1e-9 * size[axis]))])
        self.counts = [np.maximum(1, np.round(np.diff(faces) / cell).astype(int)) for faces in self.faces]
        if plane:
            self.counts[1] = np.array([1])
        self.smallest = min(float((np.diff(faces) / counts).min())
                            for axis, (faces, counts) in enumerate(zip(self.faces, self.counts)) if not (plane and axis == 1))

    def _obstacle(self, block: tuple[int, ...]) -> "str | None":
        """The obstacle that a block lies in"""
        middle = [(self.faces[axis][i] + self.faces[axis][i + 1]) / 2 for axis, i in enumerate(block)]
        for name, box in self.tank.obstacles.items():
            if all(box.low[axis] < m < box.high[axis] for axis, m in enumerate(middle) if not (self.plane and axis == 1)):
                return name
        return None

    def blocks(self) -> Iterator[tuple[int, ...]]:
        """Those that hold fluids"""
        return (block for block in product(*(range(len(counts)) for counts in self.counts)) if self._obstacle(block) is None)

    @property
    def cells(self) -> int:
        return sum(int(np.prod([self.counts[axis][i] for axis, i in enumerate(block)])) for block in self.blocks())

    def _vertex(self, corner: "list[int] | tuple[int, ...]") -> int:
        nx, ny, _ = (len(faces) for faces in self.faces)
        return corner[0] + nx * (corner[1] + ny * corner[2])

    def _patch(self, block: tuple[int, ...], axis: int, side: int) -> "str | None":
        """That of a block's face; none between two blocks"""
        beyond = list(block)
        beyond[axis] += 2 * side - 1
        if 0 <= beyond[axis] < len(self.counts[axis]):
            return self._obstacle(tuple(beyond))
        if self.plane and axis == 1:
            return SIDES
        return OPEN if FACES[2 * axis + side] in self.tank.open else OUTSIDE

    def dictionary(self) -> list[str]:
        """Lines of blockMeshDict"""
        lines = ["vertices", "("]
        lines += [f"    ({x:.12g} {y:.12g} {z:.12g})" for z in self.faces[2] for y in self.faces[1] for x in self.faces[0]]
        lines += [");", "", "blocks", "("]
        patches: dict[str, list[str]] = {}
        for block in self.blocks():
            i, j, k = block
            corners = [(i + a, j + b, k + c) for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            counts = " ".join(str(self.counts[axis][n]) for axis, n in enumerate(block))
            lines.append(f"    hex ({' '.join(str(self._vertex(c)) for c in corners)}) ({counts}) simpleGrading (1 1 1)")
            for axis, side in product(range(3), (0, 1)):
                name = self._patch(block, axis, side)
                if name is None:
                    continue
                one, two = (n for n in range(3) if n != axis)
                face = []
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = list(block)
                    corner[axis] += side
                    corner[one] += a
                    corner[two] += b
                    face.append(self._vertex(corner))
                patches.setdefault(name, []).append(f"({' '.join(map(str, face))})")
        lines += [");", "", "boundary", "("]
        for name, faces in patches.items():
            kind = {OPEN: "patch", SIDES: "empty"}.get(name, "wall")
            lines += [f"    {name}", "    {", f"        type  {kind};", "        faces", "        ("]
            lines += [f"            {face}" for face in faces] + ["        );", "    }"]
        return [*lines, ");"]

    def inside(self, place: np.ndarray) -> np.ndarray:
        """A place off the faces of the mesh, towards the fluids"""
        moved = place.copy()
        if self.plane:
            moved[1] = self.faces[1][1] / 2
        for axis in range(3):
            if self.plane and axis == 1:
                continue
            faces, counts = self.faces[axis], self.counts[axis]
            near = int(np.argmin(np.abs(faces - moved[axis])))
            if abs(faces[near] - moved[axis]) > 1e-9 * faces[-1]:
                continue
            for side in (1, 0):     # upwards first
                block = near if side else near - 1
                if not 0 <= block < len(counts):
                    continue
                trial = moved.copy()
                trial[axis] += (2 * side - 1) * _OFF * (faces[block + 1] - faces[block]) / counts[block]
                if not any((trial >= box.low).all() and (trial <= box.high).all() for box in self.tank.obstacles.values()):
                    moved = trial
                    break
        return moved

    def column(self, place: np.ndarray) -> np.ndarray:
        """Middles of the cells above a place, from the floor to the top"""
        foot = self.inside(np.array([place[0], place[1], 0.5 * (self.faces[2][-2] + self.faces[2][-1])]))
        heights = np.concatenate([low + (np.arange(n) + 0.5) * (high - low) / n
                                  for low, high, n in zip(self.faces[2], self.faces[2][1:], self.counts[2])])
        return np.column_stack((np.full(len(heights), foot[0]), np.full(len(heights), foot[1]), heights))


def _meshes(tank: Tank, tier: dict[str, Any], options: dict[str, Any], cell: float, plane: bool) -> list[tuple[str, dict[str, Any]]]:
    if not tank.open:
        raise ParameterError(f"{tank.source}: entry 'tank.open' is (); expected a face at least, for the meshes' pressure")
    mesh = Blocks(tank, cell, plane)
    limit = tier["maxCo"] * mesh.smallest / tank.max_speed
    return [("Mesh and time steps", {
        "cellSpacing": cell, "noseSpacing": mesh.smallest, "estimatedCells": mesh.cells,
        "estimatedSteps": round(tank.duration / limit, -1), "pressureCorrections": 3, "nonOrthogonalCorrections": 0,
        "coresSplit": cores_split(options["cores"], plane),
        "initialDeltaT": min(0.1 * limit, 0.1 * tank.interval), "deltaTLimit": min(5 * limit, tank.duration / tank.frames),
        "courantLimit": tier["maxCo"], "interfaceCourantLimit": tier["maxAlphaCo"], "interfaceSubCycles": 1,
    })]


# --- the run directory


def _write(path: Path, lines: list[str], note: str) -> None:
    path.write_text("\n".join([*foamDictionary.header(path, note), "", *lines]) + "\n")


def _listed(points: "list[np.ndarray] | np.ndarray") -> str:
    return "(" + " ".join(f"({p[0]:.12g} {p[1]:.12g} {p[2]:.12g})" for p in points) + ")"


def copy(tank: Tank, flat: dict[str, Any], run: Path, note: str) -> None:
    """The method's dictionaries, and those that hold the tank's shape."""
    method = "particles" if flat["application"] == "plungeSPH" else "meshes"
    for name in _SHARED[method]:
        target = run / Path(*Path(name).parts[1:])
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(TEMPLATES / name, target)
    shutil.copytree(TEMPLATES / "tank" / method, run, dirs_exist_ok=True)
    if method == "particles":
        return
    mesh = Blocks(tank, flat["cellSpacing"], flat["model"] == "plane")
    _write(run / "system/blockMeshDict", mesh.dictionary(), f"{note}\nBlocks of cells between the faces of liquid and obstacles.")
    regions = []
    for box in tank.liquid.values():
        low, high = box.low.copy(), box.high.copy()
        if mesh.plane:
            low[1], high[1] = 0.0, mesh.faces[1][1]
        regions += ["    boxToCell", "    {", f"        box {_listed([low])[1:-1]} {_listed([high])[1:-1]};",
                    "        fieldValues ( volScalarFieldValue alpha.liquid 1 );", "    }"]
    _write(run / "system/setFieldsDict", ["defaultFieldValues ( volScalarFieldValue alpha.liquid 0 );", "", "regions", "(", *regions, ");"],
           f"{note}\nThe liquid: whole cells.")
    probed = "type probes; libs (sampling); writeControl runTime; writeInterval $:tableInterval;"
    lines = [f"gauge_{name} {{ {probed} fields (alpha.liquid); probeLocations {_listed(mesh.column(place))}; }}"
             for name, place in tank.gauges.items()]
    if tank.probes:
        lines.append(f"probes {{ {probed} fields (p U alpha.liquid); probeLocations "
                     f"{_listed([mesh.inside(place) for place in tank.probes.values()])}; }}")
    lines += [f"walls_{name} {{ type forces; libs (forces); executeControl runTime; executeInterval $:tableInterval; writeControl runTime; "
              f"writeInterval $:tableInterval; patches ({name}); rho rho; CofR (0 0 0); log no; }}" for name in (*tank.obstacles, OUTSIDE)]
    (run / "system/tankFunctions").write_text("\n".join(["// Of controlDict. Gauges: columns of cells; probes; forces on walls.", *lines]) + "\n")
