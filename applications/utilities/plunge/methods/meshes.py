# SPDX-License-Identifier: GPL-3.0-or-later
"""plungeFoam: sizes of the meshes, time steps, and an estimate of both."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil
from typing import Any

import numpy as np

from plunge import boundaryLayer, decisions, snappedMesh
from plunge.checks import ParameterError
from plunge.decisions import Decision
from plunge.meridianMesh import MeshSize, axial_cell_counts, first_layers, with_first_layer
from plunge.methods import Asked
from plunge.shapes import Curve

# Nose radius over the scale of the body that the tiers' noseSpacing is for: NACA-0010
_NOSE_RADIUS = 0.01102
# Of a body mesh without a background: how far it reaches, in body scales, and its outer layers over the tier's layers. What a body
# in the plane sets in motion reaches furthest.
_SINGLE_REACH = {"half": 1.6, "full": 1.6, "axisymmetric": 3.2, "plane": 6.0}
_SINGLE_OUTER_LAYERS = {"half": 1.5, "full": 1.5, "axisymmetric": 1.5, "plane": 2.0}
# Length of the forebody over the body's largest radius below which a body is blunt: the liquid climbs it faster than the body sinks
_SLENDER = 5.0
# Spacing at the nose of a blunt body at most, over its largest radius: all of the forebody meets the liquid at once
_BLUNT_SPACING = 0.125
# Radius of a round nose over the cells along it, at least: with half of that the force of its contact is four times what it is
_NOSE_CELLS = 1.0
# Courant numbers of all tiers, in the flow and at the interface: beyond them the error grows unseen
_TIER_COURANT = {"maxCo": 2.0, "maxAlphaCo": 1.0}
# Gas over liquid density below which single steps of the force are not to be trusted
_THIN_GAS = 1e-4
# Pressure corrections: the flow at the corners of blunt bodies wants a second one, and larger Courant numbers do; larger diffusion
# numbers, for which the solver asks, a third
_CORRECTIONS = {"half": 1, "full": 1, "axisymmetric": 2, "plane": 2}
_COURANT = 1.0
# Courant number of the interface in a sub-cycle, at most: with larger ones more gas goes down along the body
_SUBCYCLE_COURANT = 0.5
_DIFFUSION = 0.3


@dataclass(frozen=True)
class Meshes(Asked):
    """What is asked for of the meshes of a scene."""

    mesh: str

    @property
    def curve(self) -> "Curve | None":
        """That the body mesh follows; none where it is snapped to a surface."""
        shape = self.scene.shape
        return shape.upper if shape.dimensions == 2 else shape.curve if shape.isRevolution else None

    @property
    def blunt(self) -> bool:
        """Has the body a short forebody? A surface counts as blunt."""
        curve, radius = self.curve, self.scene.shape.max_diameter / 2
        return curve is None or float(curve.point(np.array([curve.widest]))[0][0]) < _SLENDER * radius

    @property
    def courant(self) -> float:
        """Of the tier's Courant numbers; the impact of a blunt body is over in few steps."""
        return self.tier["bluntCourant"] if self.blunt else 1.0

    def size(self) -> MeshSize:
        """The body mesh's [m]; counts grow with the resolution, spacings shrink, the outer surface stays."""
        scale, tier, resolution = self.scene.scale, self.tier, self.resolution
        unit = scale / resolution
        rounder = max(1.0, self.scene.shape.nose_radius / (_NOSE_RADIUS * scale))
        nose = min(tier["noseSpacing"] * rounder, tier["bodySpacing"]) * unit
        if self.blunt:
            nose = min(nose, _BLUNT_SPACING * self.scene.shape.max_diameter / 2 / resolution)
        size = MeshSize(
            cap_cells=round(tier["capCells"] * resolution),
            ring_cells=max(1, round(tier["ringCells"] * resolution)),
            axial_cells=(),
            layers=round(tier["layers"] * resolution), outer_layers=0,
            nose_spacing=nose, body_spacing=tier["bodySpacing"] * unit,
            tail_spacing=tier["tailSpacing"] * unit, corner_spacing=tier["noseSpacing"] * unit, growth=tier["growth"] / resolution,
            offset=tuple(scale * d for d in tier["offset"]), stretching=tuple(tier["stretching"]), reach=0.0,
        )
        size = replace(size, axial_cells=axial_cell_counts(self.curve, size))
        if self.mesh == "single":
            size = replace(size, outer_layers=round(_SINGLE_OUTER_LAYERS[self.model] * size.layers),
                           reach=_SINGLE_REACH[self.model] * scale)
        return size


def cores_split(cores: int, flat: bool) -> list[int]:
    """Ranks in x, y and z: cut across the path, z, first, since the cuts there are the smallest; a flat model is not cut across y."""
    area = (0.5, 1.2, 0.15)  # of a cut across x, y, z in the region of fine cells, relative
    splits = [[i, j, cores // i // j] for i in range(1, cores + 1) if cores % i == 0
              for j in range(1, cores // i + 1) if cores // i % j == 0 and (j == 1 or not flat)]
    return min(splits, key=lambda split: sum(n * a for n, a in zip(split, area)))


def vector(values: Any) -> list[float]:
    """A list of floats, without -0 and without the cosine of a right angle."""
    return [float(x) + 0.0 if abs(x) > 1e-15 else 0.0 for x in values]


@dataclass(frozen=True)
class _Background:
    """The background mesh of an overset one, and the number of its cells."""

    entries: dict[str, Any]
    cells: float


def _background(meshes: Meshes, offset: float) -> _Background:
    scene, tier, resolution = meshes.scene, meshes.tier, meshes.resolution
    scale, full, follows = scene.scale, meshes.model == "full", meshes.mesh == "following"
    tail = -scene.shape.length * scene.forward
    start, end = scene.nose + tail, scene.nose if follows else scene.end
    ends = np.array([start, scene.nose, end, end + tail])

    # The domain is a whole number of unrefined cells, with a cell face on z = 0.
    cell = tier["backgroundSpacing"] * scale

    def cells(distance: float) -> int:
        return ceil(distance / cell - 1e-9)

    def refined(count: float) -> int:
        return max(1, round(count * resolution))

    # Above what rises from the surface there is the gas; a background that follows takes the liquid with it there
    above = 1.5 if follows else 0.5
    x_low, x_high = -cells(1.5 * scale - ends[:, 0].min()), cells(1.5 * scale + ends[:, 0].max())
    y_high = cells(1.5 * scale + np.abs(ends[:, 1]).max())
    z_low, z_high = -cells(1.5 * scale - min(0.0, ends[:, 2].min())), cells(max(0.0, ends[:, 2].max()) + above * scale)
    counts = [refined(x_high - x_low), refined(y_high) * (2 if full else 1), refined(-z_low) + refined(z_high)]

    # Shells about the path, finest innermost; each coarser one is four of its cells wide.
    radius = scene.shape.max_diameter / 2 + offset + 0.05 * scale
    shells = []
    for level in range(tier["refinementLevels"], 0, -1):
        shells.append([radius, level])
        radius += 4 * cell / 2 ** (level - 1)

    share_of_shell = 1 if full else 0.5
    path_length = float(np.linalg.norm(end - start))
    count = (x_high - x_low) * y_high * (2 if full else 1) * (z_high - z_low) * resolution**3
    for reach, level in shells:
        volume = share_of_shell * np.pi * reach**2 * (path_length + 4 / 3 * reach)
        count += 7 / 8 * volume / (cell / 2**level / resolution) ** 3
    return _Background({
        "xMin": x_low * cell, "xMax": x_high * cell, "yMin": -y_high * cell if full else 0.0,
        "yMax": y_high * cell, "zMin": z_low * cell, "zMax": z_high * cell,
        "xCells": counts[0], "yCells": counts[1],
        "zCellsLiquid": refined(-z_low), "zCellsGas": refined(z_high),
        "pathStart": vector(start), "pathEnd": vector(end),
        "finestSpacing": cell / 2 ** tier["refinementLevels"] / resolution,
        "refinementShells": shells,
    }, float(count))


@dataclass(frozen=True)
class _Body:
    """The mesh about the body."""

    entries: dict[str, Any]
    cells: float
    first_layer: float  # of cells, at the thickest section [m]
    finest: float       # spacing along the wall [m]
    reach: float        # of an overset mesh from the wall [m]


def body_mesh(meshes: Meshes, first_layer: "float | None") -> _Body:
    """By one of two roads: along a meridian, or snapped to a surface; `first_layer`: wanted at the wall at most [m]."""
    scene = meshes.scene
    if meshes.curve is None:
        [(_, entries)] = snappedMesh.sections(scene.shape, meshes.tier, scene.scale, meshes.resolution, meshes.model == "full",
                                              meshes.mesh == "single", first_layer)
        reach = entries["snappedReach"] - scene.shape.max_diameter / 2
        return _Body({"bodyMesh": "snapped", **entries, **snappedMesh.place(scene.forward, scene.dorsal, scene.nose)},
                     entries["snappedEstimatedCells"], entries["snappedFirstLayer"] * entries["snappedWallSpacing"],
                     entries["snappedNoseSpacing"], reach)
    size = meshes.size()
    if first_layer is not None:
        size = with_first_layer(size, first_layer)
    return _Body({
        "bodyMesh": "revolved",
        "capCells": size.cap_cells, "ringCells": size.ring_cells, "axialCells": list(size.axial_cells),
        "layers": size.layers, "outerLayers": size.outer_layers,
        "noseSpacing": size.nose_spacing, "bodySpacing": size.body_spacing,
        "tailSpacing": size.tail_spacing, "cornerSpacing": size.corner_spacing, "spacingGrowth": size.growth,
        "offset": list(size.offset), "stretching": list(size.stretching), "reach": size.reach,
    }, body_cells(size, meshes.model), first_layers(size)[1], size.nose_spacing, max(size.offset))


def body_cells(size: MeshSize, model: str) -> int:
    """Of a body mesh that follows a meridian."""
    layers, along = size.layers + size.outer_layers, sum(size.axial_cells)
    if model in ("axisymmetric", "plane"):
        return along * layers * (2 if model == "plane" else 1)
    quads = 4 * size.cap_cells * (along - 2 * (size.cap_cells + size.ring_cells)) \
        + 2 * (2 * size.cap_cells**2 + 4 * size.cap_cells * size.ring_cells)
    return quads * layers * (2 if model == "full" else 1)


def sections(meshes: Meshes, decided: dict[str, Decision]) -> list[tuple[str, dict[str, Any]]]:
    """What the meshes and time steps need."""
    scene, tier, resolution = meshes.scene, meshes.tier, meshes.resolution
    length, speed = scene.shape.length, scene.reference_speed
    turbulence, wanted = [], None
    if decided["boundary_layer"].choice == "wallFunction":
        wanted = boundaryLayer.wall_function_layer(scene.reynolds, length)
    elif decided["boundary_layer"].choice == "laminar":
        wanted = boundaryLayer.resolving_layer(scene.wetted_reynolds, scene.wetted_length)
    body = body_mesh(meshes, wanted)
    if decided["boundary_layer"].choice == "wallFunction":
        low, high = boundaryLayer.WALL_DISTANCES
        y_plus = boundaryLayer.WALL_DISTANCE * body.first_layer / wanted
        if not low <= y_plus <= high:
            raise ParameterError(
                f"-boundaryLayer wallFunction, but first cells would be at y+ = {y_plus:.3g} at Re = {scene.reynolds:.3g}; expected "
                f"{low} to {high}, or frictionLine")
        k, omega = boundaryLayer.free_stream(speed, length)
        turbulence = [("Turbulence of the undisturbed fluids, too weak to act on the flow: intensity 0.033 %, "
                       "eddy viscosity 4e-7 speed length", {"freeStreamK": k, "freeStreamOmega": omega})]

    nose = scene.shape.nose_radius
    if 0 < nose < _NOSE_CELLS * body.finest:
        scene.notes.append(f"nose: its diameter, {2 * nose:.3g} m, has {2 * nose / body.finest:.2g} cells along it: the force of its contact comes out far "
                           f"too large; expected {2 * _NOSE_CELLS:g} at least, of a finer tier or -resolution")
    if any(tier[name] > most for name, most in _TIER_COURANT.items()):
        scene.notes.append(f"steps: Courant numbers up to {tier['maxCo']:g}, at the interface {tier['maxAlphaCo']:g}; those of the tiers are "
                           f"{' and '.join(f'{most:g}' for most in _TIER_COURANT.values())}, with larger ones forces are some per cent off")
    thin = scene.fluids["gasDensity"] / scene.fluids["liquidDensity"]
    if thin < _THIN_GAS:
        scene.notes.append(f"gas: {thin:.2g} of the liquid's density: the force has peaks of single steps, and the flow about the surface may diverge; "
                           "a gas of a thousandth does as little to the body")
    background = _background(meshes, body.reach) if meshes.mesh != "single" else None
    cells = body.cells + (background.cells if background else 0)
    # By the flow about the nose: what dives of the fast tier take on average
    limit = tier["maxDeltaT"] * scene.scale / speed / resolution
    time_step = min(0.45 * meshes.courant * tier["maxCo"] * body.finest / speed, limit)

    viscosity = max(scene.fluids["liquidViscosity"], scene.fluids["gasViscosity"]) / scene.fluids["liquidDensity"]
    corrections = max(_CORRECTIONS[meshes.model], 2 if meshes.courant * tier["maxCo"] > _COURANT else 1,
                      3 if viscosity * limit > _DIFFUSION * body.first_layer * body.finest else 1)

    return [
        ("Body mesh", body.entries),
        *([("Background mesh", background.entries)] if background else []),
        *turbulence,
        ("Run", {
            "cores": meshes.cores, "estimatedCells": round(cells, -3) if cells > 1e4 else round(cells),
            "estimatedSteps": round(scene.duration / time_step, -1),
            "coresSplit": cores_split(meshes.cores, meshes.model in ("axisymmetric", "plane")),
            "pressureCorrections": corrections,
            # Without one the added mass on a snapped mesh is 3 % too large
            "nonOrthogonalCorrections": int(meshes.curve is None),
            "diveDuration": scene.duration, "frameInterval": scene.duration / scene.frames,
            "initialDeltaT": min(0.05 * body.finest / speed, limit, 0.1 * scene.duration),
            "deltaTLimit": limit, "courantLimit": meshes.courant * tier["maxCo"],
            "interfaceCourantLimit": meshes.courant * tier["maxAlphaCo"],
            "interfaceSubCycles": ceil(meshes.courant * tier["maxAlphaCo"] / _SUBCYCLE_COURANT - 1e-9),
        }),
    ]


def decide(meshes: Meshes, boundary_layer: str, surface_tension: str) -> dict[str, Decision]:
    """What the flow holds."""
    scene = meshes.scene
    return {
        "boundary_layer": decisions.boundary_layer(scene, "meshes", boundary_layer, body_mesh(meshes, None).first_layer,
                                                   meshes.model in ("axisymmetric", "plane")),
        "surface_tension": decisions.surface_tension(scene, "meshes", surface_tension),
        "compressibility": decisions.compressibility(scene, "meshes"),
    }
