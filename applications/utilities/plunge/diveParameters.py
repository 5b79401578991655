# SPDX-License-Identifier: GPL-3.0-or-later
"""From a case's parameter file to every number that its dictionaries need."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass, replace
from math import ceil, cos, isfinite, radians, sin, sqrt
from pathlib import Path
from typing import Any, Callable

import numpy as np

from plunge import boundaryLayer, foamDictionary
from plunge.bodyGeometry import Body
from plunge.bodyMesh import MeshSize, axial_cell_count, first_layers, with_first_layer


class ParameterError(Exception):
    """A value that cannot be used; the message names file, entry and what is expected."""


Check = tuple[str, Callable[[Any], bool]]


def _number(expectation: str, holds: Callable[[float], bool]) -> Check:
    return (expectation, lambda v: isinstance(v, (int, float)) and not isinstance(v, bool) and isfinite(v) and holds(v))


def _triple(expectation: str, holds: Callable[[float], bool]) -> Check:
    number = _number("", holds)[1]
    return (expectation, lambda v: isinstance(v, list) and len(v) == 3 and all(number(x) for x in v))


def _count(least: int) -> Check:
    return (f"a whole number, at least {least}", lambda v: type(v) is int and v >= least)


def _word(*words: str) -> Check:
    return ("one of: " + " ".join(words), lambda v: v in words)


_POSITIVE = _number("a number above 0", lambda v: v > 0)

SOLVERS = ("plungeFoam", "plungeSPH")

_PARAMETERS: dict[str, Check] = {
    "solver": _word(*SOLVERS),
    "model": _word("half", "full"),
    "mesh": _word("overset", "single"),
    "resolution": _number("a number from 0.5 to 16", lambda v: 0.5 <= v <= 16),
    "cores": _count(1),
    "boundaryLayer": _word("auto", *boundaryLayer.TREATMENTS),
    "transitionReynolds": _number("a number, 0 or above", lambda v: v >= 0),
    "body.length": _POSITIVE,
    "body.thicknessRatio": _number("a number from 0.05 to 0.5", lambda v: 0.05 <= v <= 0.5),
    "body.density": _POSITIVE,
    "dive.speed": _POSITIVE,
    "dive.angle": _number("degrees to the surface, from 20 to 90", lambda v: 20 <= v <= 90),
    "dive.gap": _POSITIVE,
    "dive.travel": _POSITIVE,
    "output.frames": _count(1),
}
_OPTIONAL: dict[str, Check] = {
    "body.mass": _POSITIVE,
    "body.centreOfMass": _POSITIVE,
    "body.momentOfInertia": _triple("three numbers above 0: (roll pitch yaw)", lambda v: v > 0),
    "particles.c0": _POSITIVE,
}
_FLUIDS: dict[str, Check] = {
    "liquidDensity": _POSITIVE,
    "liquidViscosity": _POSITIVE,
    "gasDensity": _POSITIVE,
    "gasViscosity": _POSITIVE,
    "surfaceTension": _number("a number, 0 or above", lambda v: v >= 0),
    "surfacePressure": _POSITIVE,
    "liquidVapourPressure": _POSITIVE,
    "liquidSoundSpeed": _POSITIVE,
    "gasSoundSpeed": _POSITIVE,
    "gravity": _number("a number, 0 or above", lambda v: v >= 0),
}
# Entries of plungeFluids that a fluid of titanProperties gives where they are not typed: whose fluid, and under which name
_FROM_FLUID = {
    "liquidDensity": ("liquid", "rho"),
    "liquidViscosity": ("liquid", "mu"),
    "gasDensity": ("gas", "rho"),
    "gasViscosity": ("gas", "mu"),
    "surfaceTension": ("liquid", "sigma"),
    "liquidVapourPressure": ("liquid", "vapourPressure"),
    "liquidSoundSpeed": ("liquid", "soundSpeed"),
    "gasSoundSpeed": ("gas", "soundSpeed"),
}
_TIER: dict[str, Check] = {
    "capCells": _count(2),
    "ringCells": _count(1),
    "layers": _count(4),
    "noseSpacing": _POSITIVE,
    "bodySpacing": _POSITIVE,
    "tailSpacing": _POSITIVE,
    "growth": _POSITIVE,
    "offset": _triple("three numbers above 0: (nose middle tail)", lambda v: v > 0),
    "stretching": _triple("three numbers above 0: (nose middle tail)", lambda v: v > 0),
    "backgroundSpacing": _POSITIVE,
    "refinementLevels": _count(1),
    "maxCo": _POSITIVE,
    "maxAlphaCo": _POSITIVE,
    "maxDeltaT": _POSITIVE,
    "particleSpacing": _number("a number from 0.001 to 0.05", lambda v: 0.001 <= v <= 0.05),
}

# Half width of the particles' liquid about the path and its depth below it, the part of these that absorbs, and the height
# of the tank above the surface, in body lengths.
_REACH, _ABSORBING, _FREEBOARD = 0.35, 0.1, 0.1
# c0 over the highest speed that the body could fall at, unless given: eq. 5 of IAC-20-E2.1.9
_SOUND_OVER_SPEED = 10
# Its steps, for the estimate: plungeSPH's Courant number, over h/(c0 + speed), and h over the spacing
_PARTICLE_COURANT, _SMOOTHING_LENGTH = 0.5, 1.5

# Weber number above which surface tension acts on less than a millionth of the length, which no mesh resolves
_HIGHEST_WEBER = 1e6


def _flat(entries: dict[str, Any], prefix: str = "") -> dict[str, Any]:
    flat: dict[str, Any] = {}
    for key, value in entries.items():
        if isinstance(value, dict):
            flat.update(_flat(value, f"{prefix}{key}."))
        else:
            flat[prefix + key] = value
    return flat


def _checked(entries: dict[str, Any], source: str, required: dict[str, Check],
             optional: dict[str, Check] = {}) -> dict[str, Any]:
    known = {**required, **optional}
    for key in entries:
        if key not in known:
            raise ParameterError(f"{source}: unknown entry '{key}'; expected: {' '.join(known)}")
    for key, (expectation, holds) in known.items():
        if key not in entries:
            if key in required:
                raise ParameterError(f"{source}: entry '{key}' is missing; expected {expectation}")
        elif not holds(entries[key]):
            found = foamDictionary.format_value(entries[key])
            raise ParameterError(f"{source}: entry '{key}' is {found}; expected {expectation}")
    return entries


def _choice(path: Path, name: Any, entry: str, source: str) -> tuple[dict[str, Any], str]:
    """The sub-dictionary of a file that an entry chooses, and its name for messages."""
    table = foamDictionary.read(path)
    if not isinstance(table.get(name), dict):
        raise ParameterError(f"{source}: entry '{entry}' is {name}; expected one of {path}'s: {' '.join(table)}")
    return table[name], f"{path}, {name}"


def fluid_properties(name: str, temperature: float | None, source: str) -> dict[str, Any]:
    """What titanProperties says of a fluid, by OpenFOAM's names (SI units), at its own or a given temperature [K]."""
    command = ["titanProperties", name, "-format", "foam"]
    if temperature is not None:
        command += ["-T", f"{temperature:.12g}"]
    try:
        done = subprocess.run(command, capture_output=True, text=True)
    except FileNotFoundError:
        raise ParameterError("titanProperties is not on the PATH; expected ./Allwmake and . etc/bashrc before") from None
    if done.returncode:
        raise ParameterError(f"{source}: {done.stderr.strip()}")
    return foamDictionary.parse(done.stdout, " ".join(command))


def resolved_fluids(entries: dict[str, Any], source: str) -> dict[str, Any]:
    """The numbers of a pair of fluids: those typed, and those of the fluids named by `liquid` and `gas`."""
    given = dict(entries)
    names = {role: given.pop(role, None) for role in ("liquid", "gas")}
    temperature = given.pop("temperature", None)
    if temperature is not None and not _POSITIVE[1](temperature):
        raise ParameterError(f"{source}: entry 'temperature' is {temperature}; expected kelvins, above 0")
    for role, name in names.items():
        wanted = {entry: key for entry, (whose, key) in _FROM_FLUID.items() if whose == role and entry not in given}
        if name is None or not wanted:
            continue
        if not isinstance(name, str):
            raise ParameterError(f"{source}: entry '{role}' is {name}; expected a fluid of titanProperties -list")
        known = fluid_properties(name, temperature, source)
        given.update({entry: known[key] for entry, key in wanted.items() if key in known})
        missing = [entry for entry, key in wanted.items() if key not in known]
        if missing:
            raise ParameterError(f"{source}: entry '{missing[0]}' is missing, and {role} {name} does not give it; "
                                 f"expected {_FLUIDS[missing[0]][0]}")
    return _checked(given, source, _FLUIDS)


@dataclass(frozen=True)
class Dive:
    """The checked parameters of one dive."""

    given: dict[str, Any]   # plungeParameters with the command line's values, flat
    fluids: dict[str, Any]
    tier: dict[str, Any]
    source: str             # of `given`, for messages

    @property
    def reynolds(self) -> float:
        """Of the liquid, the body's length and the initial speed."""
        return self.fluids["liquidDensity"] * self.given["dive.speed"] * self.given["body.length"] / self.fluids["liquidViscosity"]

    @property
    def name(self) -> str:
        """The run directory's name, unless one is given."""
        full = "-full" if self.given["model"] == "full" else ""
        resolution = self.given["resolution"]
        finer = f"-r{resolution:g}" if resolution != 1 else ""
        single = "-single" if self.given["mesh"] == "single" else ""
        layer = f"-{self.given['boundaryLayer']}" if self.given["boundaryLayer"] != "auto" else ""
        other = f"-{self.given['solver']}" if self.given["solver"] != SOLVERS[0] else ""
        return f"{self.given['fluids']}-{self.given['tier']}{full}{finer}{single}{layer}{other}"


def read(case: Path, overrides: dict[str, Any]) -> Dive:
    """Read and check a case's parameter files; `overrides` (flat names) take the place of file entries."""
    path = case / "system" / "plungeParameters"
    given = {**_flat(foamDictionary.read(path)), **overrides}
    source = f"{path} (or the command line)" if overrides else str(path)
    any_word: Check = ("a word", lambda v: isinstance(v, str))
    _checked(given, source, {"fluids": any_word, "tier": any_word, **_PARAMETERS}, _OPTIONAL)
    if given.get("body.centreOfMass", 0) > given["body.length"]:
        raise ParameterError(f"{source}: entry 'body.centreOfMass' is {given['body.centreOfMass']}; "
                             "expected metres aft of the nose, at most body.length")
    return Dive(
        given,
        resolved_fluids(*_choice(case / "constant" / "plungeFluids", given["fluids"], "fluids", source)),
        _checked(*_choice(case / "system" / "plungeTiers", given["tier"], "tier", source), _TIER),
        source,
    )


def mesh_size(body: Body, tier: dict[str, Any], resolution: float) -> MeshSize:
    """The body mesh's size [m]; counts grow with the resolution, spacings shrink, the shape stays."""
    unit = body.length / resolution
    size = MeshSize(
        cap_cells=round(tier["capCells"] * resolution),
        ring_cells=max(1, round(tier["ringCells"] * resolution)),
        axial_cells=0,
        layers=round(tier["layers"] * resolution), outer_layers=0,
        nose_spacing=tier["noseSpacing"] * unit, body_spacing=tier["bodySpacing"] * unit,
        tail_spacing=tier["tailSpacing"] * unit, growth=tier["growth"] / resolution,
        offset=tuple(body.length * d for d in tier["offset"]), stretching=tuple(tier["stretching"]), reach=0.0,
    )
    return replace(size, axial_cells=round(axial_cell_count(body, size)))


# Of a body mesh without a background: how far it reaches, in body lengths, and its outer layers over the tier's layers.
_SINGLE_REACH, _SINGLE_OUTER_LAYERS = 1.6, 1.5


def single_mesh_size(size: MeshSize, length: float) -> MeshSize:
    """The body mesh, unchanged, with further layers about it that reach the far boundary."""
    return replace(size, outer_layers=round(_SINGLE_OUTER_LAYERS * size.layers), reach=_SINGLE_REACH * length)


def cores_split(cores: int) -> list[int]:
    """Ranks in x, y and z: cut across the path, z, first, since the cuts there are the smallest."""
    area = (0.5, 1.2, 0.15)  # of a cut across x, y, z in the region of fine cells, relative
    splits = [[i, j, cores // i // j] for i in range(1, cores + 1) if cores % i == 0
              for j in range(1, cores // i + 1) if cores // i % j == 0]
    return min(splits, key=lambda split: sum(n * a for n, a in zip(split, area)))


@dataclass(frozen=True)
class StraightPath:
    """The dive's straight path, of the undisturbed body [m]."""

    body: Body
    speed: float
    start: np.ndarray   # of the tail, at t = 0
    nose: np.ndarray    # at t = 0
    end: np.ndarray     # of the nose

    @property
    def duration(self) -> float:
        """[s] at the initial speed"""
        return float(np.linalg.norm(self.end - self.nose)) / self.speed


def _vector(values: Any) -> list[float]:
    return [float(x) + 0.0 for x in values]  # no -0


def decided_boundary_layer(dive: Dive, body: Body) -> tuple[str, str]:
    """What is made of the boundary layer, and why."""
    asked, transition, reynolds = dive.given["boundaryLayer"], dive.given["transitionReynolds"], dive.reynolds
    if dive.given["solver"] == "plungeSPH":
        if asked not in ("auto", "none"):
            raise ParameterError(f"{dive.source}: entry 'boundaryLayer' is {asked}; expected auto or none: plungeSPH has no boundary layer")
        return "none", "plungeSPH has none"

    first = first_layers(mesh_size(body, dive.tier, dive.given["resolution"]))[1]
    needed = boundaryLayer.resolving_layer(reynolds, body.length)
    if asked == "laminar" and first > needed:
        raise ParameterError(
            f"{dive.source}: entry 'boundaryLayer' is laminar, but the mesh's first layer is {first:.3g} m and a laminar layer at "
            f"Re = {reynolds:.3g} needs {needed:.3g} m; expected frictionLine, or a finer mesh")
    if asked != "auto":
        return asked, f"as asked; Re = {reynolds:.3g}"
    if reynolds > transition:
        return "frictionLine", f"Re = {reynolds:.3g}, above transition at {transition:.3g}"
    below = f"Re = {reynolds:.3g}, not above transition at {transition:.3g}"
    if first > needed:
        return "frictionLine", f"{below}, but the mesh's first layer is {first:.3g} m and a laminar layer needs {needed:.3g} m"
    return "laminar", f"{below}, and the mesh resolves the layer"


def decided_surface_tension(dive: Dive) -> tuple[str, str]:
    """Whether surface tension acts, on or off, and why."""
    if dive.given["solver"] == "plungeSPH":
        return "off", "plungeSPH has none"
    fluids, sigma = dive.fluids, dive.fluids["surfaceTension"]
    if sigma == 0:
        return "off", "the liquid has none"
    weber = fluids["liquidDensity"] * dive.given["dive.speed"] ** 2 * dive.given["body.length"] / sigma
    return ("off" if weber > _HIGHEST_WEBER else "on"), f"We = {weber:.3g}"


def modelled(dive: Dive, body: Body) -> dict[str, Any]:
    """What follows from the dive of what its flow holds, with the reasons."""
    layer, layer_reason = decided_boundary_layer(dive, body)
    tension, tension_reason = decided_surface_tension(dive)
    return {
        "boundaryLayer": layer,
        **({"transitionReynolds": float(dive.given["transitionReynolds"])} if dive.given["solver"] == "plungeFoam" else {}),
        "surfaceTensionModelled": tension,
        "decisions": [f"boundary layer: {layer} ({layer_reason})", f"surface tension: {tension} ({tension_reason})"],
    }


def mesh_sections(dive: Dive, path: StraightPath, layer: str) -> list[tuple[str, dict[str, Any]]]:
    """What the meshes of plungeFoam and its time steps need; `layer`: what is made of the boundary layer."""
    p, tier, body = dive.given, dive.tier, path.body
    length, full, resolution = body.length, p["model"] == "full", p["resolution"]
    size = mesh_size(body, tier, resolution)

    # The domain is a whole number of unrefined cells, with a cell face on z = 0.
    cell = tier["backgroundSpacing"] * length
    def cells(distance: float) -> int:
        return ceil(distance / cell - 1e-9)
    x_low, x_high = -cells(1.5 * length - path.start[0]), cells(1.5 * length + path.end[0])
    y_high = cells(1.5 * length)
    z_low, z_high = -cells(1.5 * length - path.end[2]), cells(path.start[2] + 0.5 * length)
    def refined(count: int) -> int:
        return max(1, round(count * resolution))

    counts = [refined(x_high - x_low), refined(y_high) * (2 if full else 1), refined(-z_low) + refined(z_high)]

    # Shells about the path, finest innermost; each coarser one is four of its cells wide.
    radius = body.thickness_ratio * length / 2 + max(size.offset) + 0.05 * length
    shells = []
    for level in range(tier["refinementLevels"], 0, -1):
        shells.append([radius, level])
        radius += 4 * cell / 2 ** (level - 1)

    finest = cell / 2 ** tier["refinementLevels"] / resolution

    # An estimate, for the scheduler: cells from the shells' volumes, the rest from runs of the fast tier.
    quads = 4 * size.cap_cells * (size.axial_cells - 2 * (size.cap_cells + size.ring_cells)) \
        + 2 * (2 * size.cap_cells**2 + 4 * size.cap_cells * size.ring_cells)
    share_of_shell = 1 if full else 0.5
    path_length = (1 + p["dive.travel"]) * length
    background = (x_high - x_low) * y_high * (2 if full else 1) * (z_high - z_low) * resolution**3
    for reach, level in shells:
        volume = share_of_shell * np.pi * reach**2 * (path_length + 4 / 3 * reach)
        background += 7 / 8 * volume / (cell / 2**level / resolution) ** 3
    single = p["mesh"] == "single"
    if single:
        size, background = single_mesh_size(size, length), 0
    turbulence = []
    if layer == "wallFunction":
        wanted = boundaryLayer.wall_function_layer(dive.reynolds, length)
        size = with_first_layer(size, wanted)
        low, high = boundaryLayer.WALL_DISTANCES
        y_plus = boundaryLayer.WALL_DISTANCE * first_layers(size)[1] / wanted
        if not low <= y_plus <= high:
            raise ParameterError(
                f"{dive.source}: entry 'boundaryLayer' is wallFunction, but first cells would be at y+ = {y_plus:.3g} at "
                f"Re = {dive.reynolds:.3g}; expected {low} to {high}, or frictionLine")
        k, omega = boundaryLayer.free_stream(path.speed, length)
        turbulence = [("Turbulence of the undisturbed fluids, too weak to act on the flow: intensity 0.033 %, "
                       "eddy viscosity 4e-7 speed length", {"freeStreamK": k, "freeStreamOmega": omega})]
    all_cells = background + quads * (size.layers + size.outer_layers) * (2 if full else 1)
    # By the flow about the nose: what dives of the fast tier take on average
    time_step = min(0.45 * tier["maxCo"] * size.nose_spacing / path.speed, tier["maxDeltaT"] / resolution)

    return [
        ("Body mesh", {
            "capCells": size.cap_cells, "ringCells": size.ring_cells, "axialCells": size.axial_cells,
            "layers": size.layers, "outerLayers": size.outer_layers,
            "noseSpacing": size.nose_spacing, "bodySpacing": size.body_spacing,
            "tailSpacing": size.tail_spacing, "spacingGrowth": size.growth, "offset": list(size.offset),
            "stretching": list(size.stretching), "reach": size.reach,
        }),
        *([] if single else [("Background mesh", {
            "xMin": x_low * cell, "xMax": x_high * cell, "yMin": -y_high * cell if full else 0.0,
            "yMax": y_high * cell, "zMin": z_low * cell, "zMax": z_high * cell,
            "xCells": counts[0], "yCells": counts[1],
            "zCellsLiquid": refined(-z_low), "zCellsGas": refined(z_high),
            "pathStart": _vector(path.start), "pathEnd": _vector(path.end),
            "finestSpacing": finest,
            "refinementShells": shells,
        })]),
        *turbulence,
        ("Run", {
            "cores": p["cores"], "estimatedCells": round(all_cells, -3),
            "estimatedSteps": round(path.duration / time_step, -1), "coresSplit": cores_split(p["cores"]),
            "diveDuration": path.duration, "frameInterval": path.duration / p["output.frames"],
            "initialDeltaT": min(0.05 * size.nose_spacing / path.speed, tier["maxDeltaT"] / resolution, 0.1 * path.duration),
            "deltaTLimit": tier["maxDeltaT"] / resolution, "courantLimit": tier["maxCo"],
            "interfaceCourantLimit": tier["maxAlphaCo"],
        }),
    ]


def particle_sections(dive: Dive, path: StraightPath) -> list[tuple[str, dict[str, Any]]]:
    """What the particles of plungeSPH need: a box of liquid about the path, a whole number of spacings in each direction."""
    p, length, full = dive.given, path.body.length, dive.given["model"] == "full"
    spacing = dive.tier["particleSpacing"] * length / p["resolution"]
    def spacings(distance: float) -> int:
        return ceil(distance / spacing - 1e-9)
    reach = _REACH * length
    # The nose enters at x = 0; what of the body is above the surface meets no liquid.
    low = [-spacings(reach), -spacings(reach) if full else 0, -spacings(reach + max(0.0, -path.end[2]))]
    high = [spacings(reach + path.end[0]), spacings(reach), 0]
    count = int(np.prod(np.subtract(high, low)))
    fastest = sqrt(path.speed**2 + 2 * dive.fluids["gravity"] * (path.nose[2] - path.end[2]))
    c0 = float(p.get("particles.c0", _SOUND_OVER_SPEED * fastest))

    axial, transverse, rotary = path.body.added_mass_coefficients()
    displaced = (1.0 if full else 0.5) * dive.fluids["liquidDensity"]
    mass, inertia = displaced * path.body.volume, displaced * path.body.unit_inertia()[1]

    return [
        # plungeFoam computes it from the flow
        ("What the liquid adds to the immersed body: an estimate for the coupling, which does not change its result", {
            "addedMassEstimate": [axial * mass, transverse * mass, transverse * mass],
            "addedInertiaEstimate": [0.0, rotary * inertia, rotary * inertia],
        }),
        ("Particles", {
            "particleSpacing": spacing,
            "liquidMin": _vector(np.multiply(low, spacing)), "liquidMax": _vector(np.multiply(high, spacing)),
            "tankMax": _vector(np.multiply([*high[:2], spacings(_FREEBOARD * length)], spacing)),
            "tankOpen": ["top"] if full else ["front", "top"],
            "absorbingFaces": ["left", "right", *(["front"] if full else []), "back", "bottom"],
            "absorbingThickness": _ABSORBING * length,
            "particleSoundSpeed": c0,
        }),
        ("Run", {
            "cores": p["cores"], "fluidParticles": count,
            "estimatedSteps": round(path.duration * (c0 + path.speed) / (_PARTICLE_COURANT * _SMOOTHING_LENGTH * spacing), -1),
            "diveDuration": path.duration, "frameInterval": path.duration / p["output.frames"],
        }),
    ]


def derive(dive: Dive) -> list[tuple[str, dict[str, Any]]]:
    """All numbers that the case's dictionaries include, in titled sections (SI units)."""
    p, fluids = dive.given, dive.fluids
    body = Body(float(p["body.length"]), float(p["body.thicknessRatio"]))
    length, full = body.length, p["model"] == "full"
    angle = radians(p["dive.angle"])
    forward = np.array([cos(angle), 0.0, -sin(angle)])
    dorsal = np.array([sin(angle), 0.0, cos(angle)])
    nose = np.array([0.0, 0.0, p["dive.gap"]])
    path = StraightPath(body, float(p["dive.speed"]), nose - length * forward, nose, nose + p["dive.travel"] * length * forward)

    mass = p.get("body.mass", p["body.density"] * body.volume)
    centre = p.get("body.centreOfMass", body.centroid)
    roll, pitch = (mass / body.volume * i for i in body.unit_inertia())
    inertia = p.get("body.momentOfInertia", [roll, pitch, pitch])
    share = 1.0 if full else 0.5
    model = modelled(dive, body)
    sections = mesh_sections(dive, path, model["boundaryLayer"]) if p["solver"] == "plungeFoam" else particle_sections(dive, path)

    return [
        ("The dive", {
            "application": p["solver"],
            "fluids": p["fluids"], "model": p["model"], "mesh": p["mesh"], "tier": p["tier"], "resolution": p["resolution"],
            "bodyLength": length, "thicknessRatio": body.thickness_ratio,
            "speed": path.speed, "pathAngle": float(p["dive.angle"]), "gap": float(p["dive.gap"]),
        }),
        ("Fluids", {
            **fluids,
            "liquidKinematicViscosity": fluids["liquidViscosity"] / fluids["liquidDensity"],
            "gasKinematicViscosity": fluids["gasViscosity"] / fluids["gasDensity"],
            "gravityVector": [0, 0, -fluids["gravity"]],
        }),
        ("What is modelled, and why", model),
        ("The whole body, at t = 0", {
            "bodyVolume": body.volume, "bodyMass": mass, "bodyMomentOfInertia": _vector(inertia),
            "noseRadius": body.nose_radius, "centreOfMassFromNose": float(centre),
            "nosePosition": _vector(nose), "centreOfMass": _vector(nose - centre * forward),
            "forward": _vector(forward), "dorsal": _vector(dorsal),
            "orientation": _vector(np.column_stack((forward, [0, 1, 0], dorsal)).ravel()),
            "initialVelocity": _vector(path.speed * forward),
        }),
        ("What the model holds of it", {
            "modelledMass": share * mass,
            "modelledMomentOfInertia": _vector(share * np.asarray(inertia)),
            "modelledVolume": share * body.volume,
        }),
        *sections,
    ]
