# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene: what happens, whatever method computes it. Read from constant/scene of a case."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from math import ceil, cos, radians, sin, sqrt
from pathlib import Path
from typing import Any

import numpy as np

from plunge import fluids as fluid_pairs
from plunge import foamDictionary
from plunge.checks import Check, ParameterError, checked, flat, not_negative, number, positive, refuse_unknown, triple, word
from plunge.shapes import Shape, ShapeError, read_shape

FREEDOMS = ("fixed", "prescribed", "axial", "planar", "free")
EVENTS = ("immersed", "atRest", "leftTheLiquid", "surfaced")

_BODY: dict[str, Check] = {"freedom": word(*FREEDOMS)}
_BODY_OPTIONAL: dict[str, Check] = {
    "mass": positive,
    "density": positive,
    "centreOfMass": ("metres aft of the nose, or three numbers: (aft, to the side, dorsal)",
                     lambda v: number("")[1](v) or triple("")[1](v)),
    "momentOfInertia": triple("three numbers above 0: (roll pitch yaw)", lambda v: all(x > 0 for x in v)),
    # Fins like a cross, of slenderBody: area of a pair times its distance from the centre of mass, over frontal area times length
    "tail.volumeCoefficient": positive,
    "tail.aspectRatio": positive,
    "tail.position": positive,  # aft of the nose [m]
    # Along the body's axis, forward
    "thrust.force": positive,
    "thrust.start": not_negative,
    "thrust.end": positive,
}
_ENTRY: dict[str, Check] = {
    "speed": not_negative,
    "drop": positive,
    "angle": number("degrees to the surface, from -90 to 90; below 0 it rises", lambda v: -90 <= v <= 90),
    "gap": positive,
    "depth": number("metres of the body's middle below the surface; below 0 it is above, and the body reaches through the surface"),
    "attitude": number("degrees of the body's axis below the horizontal, from -180 to 180", lambda v: -180 <= v <= 180),
    "sideslip": number("degrees, from -90 to 90", lambda v: -90 < v < 90),
    "spin": triple("three numbers: (roll pitch yaw) [rad/s]"),
}
_END: dict[str, Check] = {"duration": positive, "travel": positive, "until": word(*EVENTS)}
_OTHER: dict[str, Check] = {"transitionReynolds": not_negative,
                           "frames": ("a whole number, 1 to 10000", lambda v: type(v) is int and 1 <= v <= 10000)}
# Of each pair a scene has one
_EXCLUSIVE = (("entry.speed", "entry.drop"), ("entry.gap", "entry.depth"), ("duration", "travel"), ("body.mass", "body.density"))
# What the command line's entries take the place of
_REPLACED = {**{name: pair for pair in _EXCLUSIVE for name in pair}, "until": ("duration", "travel")}
_TOP = ("body", "fluids", "entry", *_END, *_OTHER)

# Gap: height of the lowest point above the surface at the start, in body scales, unless given
_GAP = 0.01
# Until an event, at most: way in body lengths beyond the gap
_LONGEST = 4.0
# Body lengths off the straight path that the room about it has anyway
_STRAY = 0.15
# Steps of the path under gravity, at least, and in a radian of its heaving
_PATH_STEPS = 1000
_HEAVE_STEPS = 20
_FRAMES = 10
# Of the body, its longest [m]
_SIZES = 1e-3, 100.0
_TRANSITION = 5e5  # Reynolds number of a flat plate's transition in a stream that is not still


@dataclass(frozen=True)
class Scene:
    """The checked entries of a scene, and what follows from them (SI units). Earth axes: z up from the undisturbed surface; the path
    lies in x and z and enters the liquid at x = 0."""

    given: dict[str, Any]   # flat, e.g. entry.speed; body.shape stays a dictionary
    file: Path
    source: str             # for messages
    shape: Shape
    fluids: dict[str, Any]
    fluids_name: str
    notes: list[str] = field(default_factory=list)

    @property
    def folder(self) -> Path:
        """What the scene's file names are seen from: the case, or the directory of a scene file by itself."""
        return folder_of(self.file)

    @property
    def scale(self) -> float:
        """Length that meshes and domains go with [m]: that of a body of this shape's length and width that were as slender as 0.1. A
        flat body counts as long as it is wide."""
        slenderness = self.shape.slenderness
        return max(self.shape.length, slenderness * self.shape.length) * (10 * min(slenderness, 1.0)) ** (1 / 3)

    @cached_property
    def speed(self) -> float:
        """At the start [m/s]"""
        if "entry.drop" in self.given:
            return sqrt(2 * self.fluids["gravity"] * self.given["entry.drop"])
        return float(self.given.get("entry.speed", 0.0))

    @property
    def reference_speed(self) -> float:
        """For dimensionless numbers [m/s]: at the start, or what gravity gives over the body's length and the gap."""
        height = self.shape.length + max(0.0, self.lowest)
        return self.speed or sqrt(2 * max(self.fluids["gravity"], 1e-3) * height)

    @property
    def angle(self) -> float:
        """Of the path to the surface [deg]"""
        return float(self.given.get("entry.angle", 90.0))

    @property
    def freedom(self) -> str:
        return self.given["body.freedom"]

    @property
    def transition(self) -> float:
        """Reynolds number of the boundary layer's transition"""
        return float(self.given.get("transitionReynolds", _TRANSITION))

    @property
    def frames(self) -> int:
        """Times at which fields are written"""
        return self.given.get("frames", _FRAMES)

    @property
    def reynolds(self) -> float:
        """Of the liquid, the body's length and its speed."""
        return self.fluids["liquidDensity"] * self.reference_speed * self.shape.length / self.fluids["liquidViscosity"]

    @property
    def wetted_length(self) -> float:
        """Of the body, as far as it dips in, if nothing slowed it [m]"""
        depth = self.shape.length if self.immersed else -float(self.end[2])
        return min(depth, self.shape.length) if depth > 0 else self.shape.length

    @property
    def wetted_reynolds(self) -> float:
        """Of the length that is wetted."""
        return self.reynolds * self.wetted_length / self.shape.length

    @property
    def weber(self) -> float:
        return self.fluids["liquidDensity"] * self.reference_speed**2 * self.shape.length / self.fluids["surfaceTension"]

    @cached_property
    def forward(self) -> np.ndarray:
        angle = radians(self.given.get("entry.attitude", self.angle))
        return np.array([cos(angle), 0.0, -sin(angle)])

    @cached_property
    def dorsal(self) -> np.ndarray:
        angle = radians(self.given.get("entry.attitude", self.angle))
        return np.array([sin(angle), 0.0, cos(angle)])

    @property
    def place(self) -> np.ndarray:
        """Directions of the body frame's axes (aft, y, dorsal), as rows."""
        return np.array([-self.forward, [0.0, 1.0, 0.0], self.dorsal])

    @cached_property
    def heading(self) -> np.ndarray:
        """Direction of the velocity"""
        angle, slip = radians(self.angle), radians(self.given.get("entry.sideslip", 0.0))
        along = np.array([cos(angle), 0.0, -sin(angle)])
        return along if slip == 0 else cos(slip) * along + sin(slip) * np.array([0.0, 1.0, 0.0])

    @property
    def spin(self) -> np.ndarray:
        """About the forward axis, y and the dorsal axis [rad/s]"""
        return np.array(self.given.get("entry.spin", [0.0, 0.0, 0.0]), float)

    @cached_property
    def _below_nose(self) -> float:
        """How far the body reaches below its nose [m]"""
        points, _ = self.shape.surface()
        return float(max(0.0, -(points @ self.place)[:, 2].min()))

    @cached_property
    def nose(self) -> np.ndarray:
        """At the start [m]"""
        if "entry.depth" in self.given:
            centre = self.shape.centre @ self.place
            return np.array([0.0, 0.0, -self.given["entry.depth"]]) - centre
        return np.array([0.0, 0.0, self.given.get("entry.gap", _GAP * self.scale) + self._below_nose])

    @property
    def lowest(self) -> float:
        """Height of the body's lowest point at the start [m]"""
        return float(self.nose[2] - self._below_nose)

    @property
    def immersed(self) -> bool:
        """Does it start in the liquid?"""
        return "entry.depth" in self.given

    # --- mass properties of the whole body; in the plane, per metre

    @property
    def mass(self) -> float:
        return self.given["body.mass"] if "body.mass" in self.given else self.given["body.density"] * self.shape.volume

    @property
    def centre(self) -> np.ndarray:
        """Centre of mass in the body frame [m]"""
        given = self.given.get("body.centreOfMass")
        if given is None:
            return np.asarray(self.shape.centre)
        return np.array([given, 0.0, 0.0] if not isinstance(given, list) else given, float)

    @cached_property
    def principal(self) -> tuple[np.ndarray, np.ndarray]:
        """Moments of inertia about the centre of mass [kg m2], and their axes as columns in (forward, y, dorsal). They are those of
        a uniform body, unless given."""
        if "body.momentOfInertia" in self.given:
            return np.array(self.given["body.momentOfInertia"], float), np.eye(3)
        tensor = np.array(self.shape.inertia, float) * (self.mass / self.shape.volume)
        flip = np.diag([-1.0, 1.0, 1.0])  # aft to forward
        tensor = flip @ tensor @ flip
        off = np.abs(tensor - np.diag(np.diag(tensor))).max()
        if off <= 1e-6 * np.diag(tensor).max():
            return np.diag(tensor).copy(), np.eye(3)
        values, axes = np.linalg.eigh(tensor)
        # The axis nearest to forward first, to y second
        order = [int(np.argmax(np.abs(axes[0])))]
        order.append(max((k for k in range(3) if k not in order), key=lambda k: abs(axes[1, k])))
        order.append(3 - sum(order))
        axes = axes[:, order]
        axes *= np.sign(np.diag(axes))
        return values[order], axes

    @property
    def orientation(self) -> np.ndarray:
        """Principal axes as columns in earth axes"""
        return np.column_stack((self.forward, [0, 1, 0], self.dorsal)) @ self.principal[1]

    @property
    def angular_momentum(self) -> np.ndarray:
        """At the start, about the principal axes [kg m2/s]"""
        inertia, axes = self.principal
        return inertia * (axes.T @ self.spin)

    @property
    def thrust(self) -> tuple[float, float, float]:
        """Force along the body's axis [N], from when to when [s]; 0 where there is none"""
        given = self.given
        return given.get("body.thrust.force", 0.0), given.get("body.thrust.start", 0.0), given.get("body.thrust.end", self.duration)

    # --- how long

    @property
    def duration(self) -> float:
        """[s]; of a scene that ends with an event, the longest"""
        if "duration" in self.given:
            return float(self.given["duration"])
        if "travel" in self.given:
            return self.given["travel"] * self.shape.length / self.reference_speed
        way = max(0.0, self.lowest) + _LONGEST * self.shape.length
        return way / self.reference_speed

    @property
    def end(self) -> np.ndarray:
        """Of the nose, if nothing slowed the body [m]; where gravity takes it further than that, the furthest it comes to"""
        if self.speed == 0:
            # Falls by its weight, or rises by its buoyancy
            away = 0.5 * self.fluids["gravity"] * self.duration**2
            straight = self.nose - [0.0, 0.0, min(away, _LONGEST * self.shape.length + max(0.0, self.lowest))]
        elif "travel" in self.given:
            straight = self.nose + self.given["travel"] * self.shape.length * self.heading
        else:
            force, start, stop = self.thrust
            acts = max(0.0, min(stop, self.duration) - start)
            driven = force / self.mass * acts * (self.duration - start - acts / 2)
            straight = self.nose + self.speed * self.duration * self.heading + driven * self.forward * [1.0, 1.0, 0.0]
        deepest, highest = self.heights
        stray = _STRAY * self.shape.length
        if deepest < min(straight[2], self.nose[2]) - stray:
            return np.array([*straight[:2], deepest])
        if highest > max(straight[2], self.nose[2]) + stray:
            return np.array([*straight[:2], highest])
        return straight

    @cached_property
    def heights(self) -> tuple[float, float]:
        """Of the nose [m], the deepest and the highest, under the weight and the buoyancy of what is in the liquid, which is the share of
        the body's height; its added mass is about that of a spheroid along its axis or of an ellipse (Lamb 1932), and no drag slows it."""
        rise = float(self.speed * self.heading[2])
        nose = float(self.nose[2])
        if self.freedom in ("fixed", "prescribed"):
            return min(nose, nose + rise * self.duration), max(nose, nose + rise * self.duration)
        points, _ = self.shape.surface()
        z = (points @ self.place)[:, 2]
        low, height = float(z.min()), float(np.ptp(z))
        gravity, slenderness = self.fluids["gravity"], min(self.shape.slenderness, 1.0)
        displaced = self.fluids["liquidDensity"] * self.shape.volume / self.mass
        added = slenderness if self.shape.dimensions == 2 else 0.5 * slenderness**1.4
        heave = sqrt(gravity * max(displaced, 1.0) / height)
        force, start, stop = self.thrust
        driven = force / self.mass * float(self.forward[2])
        steps = ceil(min(1e5, max(_PATH_STEPS, _HEAVE_STEPS * heave * self.duration)))
        step = self.duration / steps
        deepest = highest = nose
        for i in range(steps):
            wet = min(1.0, max(0.0, -(nose + low) / height)) * displaced
            drive = driven if start <= i * step < stop else 0.0
            rise += (gravity * (wet - 1) + drive) / (1 + added * wet) * step
            nose += rise * step
            deepest, highest = min(deepest, nose), max(highest, nose)
            if self.given.get("until") == "immersed" and nose + low < -2 * height:
                break
        return deepest, highest


def folder_of(file: Path) -> Path:
    """CASE of CASE/constant/scene; the directory of any other file."""
    parent = file.resolve().parent
    return parent.parent if parent.name == "constant" else parent


def find(path: Path) -> Path:
    """The scene's file: a case directory's, or the file itself."""
    file = path / "constant" / "scene" if path.is_dir() else path
    if not file.is_file():
        raise ParameterError(f"{path}: expected a scene: a case directory with constant/scene, or a scene file")
    return file


def _nested(entries: dict[str, Any], name: str, value: Any) -> None:
    """Set an entry by its flat name."""
    *outer, last = name.split(".")
    for key in outer:
        entries = entries.setdefault(key, {})
        if not isinstance(entries, dict):
            raise ParameterError(f"-set {name}={value}: {key} is no dictionary")
    entries[last] = value


def _remove(entries: dict[str, Any], name: str) -> None:
    """Drop an entry by its flat name, where it is there."""
    *outer, last = name.split(".")
    for key in outer:
        entries = entries.get(key, {})
    if isinstance(entries, dict):
        entries.pop(last, None)


def read_entries(path: Path, overrides: dict[str, Any]) -> dict[str, Any]:
    """The entries of a scene's file; `overrides` (flat names) take the place of the file's."""
    entries = foamDictionary.read(path)
    for name in overrides:
        for other in _REPLACED.get(name, ()):
            _remove(entries, other)
    for name, value in overrides.items():
        _nested(entries, name, value)
    return entries


def read(path: Path, overrides: dict[str, Any] = {}) -> Scene:
    """Read and check a scene with a body. Errors name the file, the entry and what was expected."""
    file = find(path)
    entries = read_entries(file, overrides)
    source = f"{file} (or the command line)" if overrides else str(file)
    refuse_unknown(entries, source, _TOP)
    body = entries.get("body")
    if not isinstance(body, dict):
        raise ParameterError(f"{source}: entry 'body' is {'missing' if body is None else foamDictionary.format_value(body)}; expected "
                             "body { shape { type ...; } density ...; freedom free; }")
    if "shape" not in body and any(isinstance(value, dict) and "shape" in value for value in body.values()):
        raise ParameterError(f"{source}: entry 'body' holds several bodies, {' '.join(body)}; expected one: more than one is not "
                             "possible yet")
    if "fluids" not in entries:
        raise ParameterError(f"{source}: entry 'fluids' is missing; expected a pair such as water or titan, or "
                             "{ liquid water; gas earthAir; gravity 9.81; }")
    given = flat({k: v for k, v in entries.items() if k != "fluids"}, keep=("body.shape",))
    shape_entries = given.pop("body.shape", None)
    checked(given, source,
            {f"body.{k}": v for k, v in _BODY.items()},
            {**{f"body.{k}": v for k, v in _BODY_OPTIONAL.items()}, **{f"entry.{k}": v for k, v in _ENTRY.items()}, **_END, **_OTHER})

    def one_of(*names: str, wanted: str) -> None:
        if not any(name in given for name in names):
            raise ParameterError(f"{source}: entry '{names[0]}' is missing; expected {wanted}")

    for one, other in _EXCLUSIVE:
        if one in given and other in given:
            raise ParameterError(f"{source}: entries '{one}' and '{other}' are both given; expected one of them")
    one_of("entry.speed", "entry.drop", wanted="the speed at the start [m/s], or drop, the height of a fall to it [m]")
    one_of(*_END, wanted=f"duration [s], travel [body lengths at the initial speed] or until, one of: {' '.join(EVENTS)}")
    if given["body.freedom"] not in ("fixed", "prescribed"):
        one_of("body.mass", "body.density", wanted="mass [kg], or density, that of the body as a whole [kg/m3]")

    try:
        shape = read_shape(shape_entries, folder_of(file), source)
    except ShapeError as error:
        raise ParameterError(str(error)) from None
    name, fluids, doubts = fluid_pairs.resolve(entries["fluids"], source)
    if "body.mass" not in given and "body.density" not in given:
        given["body.density"] = fluids["liquidDensity"]  # moves as prescribed, whatever its mass
    scene = Scene({**given, "body.shape": shape_entries}, file, source, shape, fluids, name, [*shape.notes, *doubts])
    _check_consistency(scene)
    return scene


def _check_consistency(scene: Scene) -> None:
    given, source, shape = scene.given, scene.source, scene.shape
    centre = scene.centre
    points, _ = shape.surface()
    if not _SIZES[0] <= max(shape.length, shape.max_diameter) <= _SIZES[1]:
        raise ParameterError(f"{source}: the body is {max(shape.length, shape.max_diameter):.4g} m long; expected {_SIZES[0]:g} to {_SIZES[1]:g} m; "
                             "of a shape from a file, scale is metres per unit of the file")
    if "body.momentOfInertia" in given:
        moments = sorted(given["body.momentOfInertia"])
        largest = scene.mass * max(shape.length, shape.max_diameter) ** 2
        if moments[2] > moments[0] + moments[1] * (1 + 1e-9) or moments[2] > largest:
            raise ParameterError(f"{source}: entry 'body.momentOfInertia' is {foamDictionary.format_value(given['body.momentOfInertia'])}; expected "
                                 f"moments of which none exceeds the sum of the others, nor mass times length squared, {largest:.4g} kg m2")
    if scene.fluids["gasDensity"] >= scene.fluids["liquidDensity"]:
        raise ParameterError(f"{source}: the gas, {scene.fluids['gasDensity']:g} kg/m3, is no lighter than the liquid, "
                             f"{scene.fluids['liquidDensity']:g} kg/m3; expected a lighter one")
    if "entry.drop" in given and scene.fluids["gravity"] == 0:
        raise ParameterError(f"{source}: entry 'entry.drop' is given, but gravity is 0; expected speed")
    if (centre < points.min(axis=0) - 1e-9).any() or (centre > points.max(axis=0) + 1e-9).any():
        raise ParameterError(f"{source}: entry 'body.centreOfMass' is {foamDictionary.format_value(given['body.centreOfMass'])}; expected "
                             f"metres aft of the nose, inside the body, which spans {_span(points)}")
    if scene.freedom == "fixed" and (scene.speed > 0 or scene.spin.any()):
        raise ParameterError(f"{source}: entry 'body.freedom' is fixed, but the body has a speed or a spin; expected speed 0, or freedom "
                             "prescribed")
    if "body.thrust.start" in given or "body.thrust.end" in given or "body.thrust.force" in given:
        if scene.freedom in ("fixed", "prescribed"):
            raise ParameterError(f"{source}: entry 'body.thrust' is given, but freedom is {scene.freedom}; expected axial, planar or free")
        force, start, stop = scene.thrust
        if force == 0:
            raise ParameterError(f"{source}: entry 'body.thrust.force' is missing; expected the force along the body's axis [N]")
        if stop <= start:
            raise ParameterError(f"{source}: entry 'body.thrust.start' is {start:g}, but the thrust ends at {stop:g} s; expected less")
    if scene.speed == 0 and "travel" in given:
        raise ParameterError(f"{source}: entry 'travel' is given, but the speed is 0; expected duration")
    if scene.speed == 0 and scene.fluids["gravity"] == 0 and "duration" not in given and scene.freedom not in ("fixed",):
        raise ParameterError(f"{source}: the body is at rest without gravity; expected duration")
    for barred, freedoms, entry in ((scene.spin.any(), ("axial",), "spin"), (scene.spin[[0, 2]].any(), ("planar",), "spin"),
                                    (given.get("entry.sideslip", 0) != 0, ("planar",), "sideslip")):
        if barred and scene.freedom in freedoms:
            raise ParameterError(f"{source}: entry 'entry.{entry}' moves the body in a way that freedom {scene.freedom} does not allow; expected "
                                 f"{'planar or free' if scene.freedom == 'axial' else 'free'}")
    if shape.dimensions == 2 and scene.spin[[0, 2]].any():
        raise ParameterError(f"{source}: entry 'entry.spin' rolls or yaws a shape that lies in a plane; expected pitch alone: (0 1 0)")
    event = given.get("until")
    over = {"immersed": scene.immersed and _highest(scene) < 0, "atRest": scene.speed == 0 and scene.freedom in ("fixed", "prescribed"),
            "leftTheLiquid": scene.freedom == "fixed", "surfaced": scene.freedom == "fixed"}
    if event and (over[event] or (event == "atRest" and scene.freedom == "prescribed")):
        raise ParameterError(f"{source}: entry 'until' is {event}, which {'holds from the start' if over[event] and event not in ('leftTheLiquid', 'surfaced') else 'never comes'}; "
                             "expected another event, or duration")
    if scene.immersed and scene.lowest >= 0:
        raise ParameterError(f"{source}: entry 'entry.depth' is {given['entry.depth']:g}, which leaves the body above the surface; expected "
                             "more, or gap for a body that starts in the air")
    if not scene.immersed:
        if scene.speed > 0 and scene.heading[2] >= 0:
            raise ParameterError(f"{source}: entry 'entry.angle' is {scene.angle:g}, so that the body does not come down; expected an "
                                 "angle above 0, or depth for a body that starts in the liquid")
        if scene.freedom == "fixed":
            raise ParameterError(f"{source}: entry 'body.freedom' is fixed, but the body is above the liquid; expected depth")
        if scene.speed == 0 and scene.freedom == "prescribed":
            raise ParameterError(f"{source}: entry 'body.freedom' is prescribed and the speed is 0 above the liquid; expected a speed")
    if shape.dimensions == 2 and "entry.sideslip" in given:
        raise ParameterError(f"{source}: entry 'entry.sideslip' is given, but the shape lies in a plane; expected no such entry")


def _highest(scene: Scene) -> float:
    """Height of the body's highest point at the start [m]"""
    points, _ = scene.shape.surface()
    return float(scene.nose[2] + (points @ scene.place)[:, 2].max())


def _span(points: np.ndarray) -> str:
    low, high = points.min(axis=0), points.max(axis=0)
    return f"({' '.join(f'{v:.4g}' for v in low)}) to ({' '.join(f'{v:.4g}' for v in high)})"
