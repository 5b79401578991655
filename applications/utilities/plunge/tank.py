# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene without a body: liquid in a tank, at rest or about to fall. Read from constant/scene of a case."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from math import sqrt
from pathlib import Path
from typing import Any

import numpy as np

from plunge import boundaryLayer, decisions, foamDictionary
from plunge import fluids as fluid_pairs
from plunge.checks import Check, ParameterError, checked, count, number, positive, refuse_unknown, word
from plunge.decisions import Decision
from plunge.scene import find, folder_of, read_entries

FACES = ("left", "right", "front", "back", "bottom", "top")     # of x, y and z
OUTSIDE, OPEN, SIDES = "tank", "atmosphere", "frontAndBack"     # names of walls and patches
WALLS = ("noSlip", "slip")
_TOP = ("tank", "liquid", "obstacles", "fluids", "gauges", "probes", "duration", "interval", "frames", "maxSpeed")
_NUMBERS: dict[str, Check] = {"interval": positive, "frames": count(1), "maxSpeed": positive}
_FRAMES, _ROWS = 20, 1000
# Of a length, below which two places are one
_ROUND = 1e-9


@dataclass(frozen=True)
class Box:
    """Between two corners (x, y, z) [m]"""

    low: np.ndarray
    high: np.ndarray
    hydrostatic: bool = True

    @property
    def volume(self) -> float:
        return float(np.prod(self.high - self.low))

    def overlaps(self, other: "Box", least: float) -> bool:
        return bool((np.minimum(self.high, other.high) - np.maximum(self.low, other.low) > least).all())


@dataclass(frozen=True)
class Tank:
    """The checked entries of a tank (SI units): z up from its floor, x from its left and y from its front face. A tank of two numbers
    lies in x and z and is 1 m wide."""

    given: dict[str, Any]
    file: Path
    source: str             # for messages
    size: np.ndarray
    flat: bool              # given in the plane
    open: tuple[str, ...]
    walls: str
    liquid: dict[str, Box]
    obstacles: dict[str, Box]
    gauges: dict[str, np.ndarray]
    probes: dict[str, np.ndarray]
    fluids: dict[str, Any]
    fluids_name: str
    notes: list[str] = field(default_factory=list)

    @property
    def folder(self) -> Path:
        return folder_of(self.file)

    @cached_property
    def depth(self) -> float:
        """Of the liquid, at its highest [m]"""
        return float(max(box.high[2] for box in self.liquid.values()))

    @cached_property
    def still(self) -> bool:
        """Does one box of liquid reach from wall to wall?"""
        first, *others = self.liquid.values()
        wide = (first.low[:2] <= _ROUND * self.size[:2]).all() and (first.high[:2] >= (1 - _ROUND) * self.size[:2]).all()
        return not others and bool(wide) and bool(first.low[2] <= _ROUND * self.size[2])

    @property
    def reference_speed(self) -> float:
        """For dimensionless numbers: that of long waves [m/s]"""
        return sqrt(self.fluids["gravity"] * self.depth)

    @property
    def max_speed(self) -> float:
        """Highest that is expected [m/s]: that of a front on a dry bed (Ritter 1892), or of long waves in liquid at rest."""
        return float(self.given.get("maxSpeed", (1 if self.still else 2) * self.reference_speed))

    @property
    def reynolds(self) -> float:
        return self.fluids["liquidDensity"] * self.reference_speed * self.depth / self.fluids["liquidViscosity"]

    @property
    def weber(self) -> float:
        return self.fluids["liquidDensity"] * self.reference_speed**2 * self.depth / self.fluids["surfaceTension"]

    @property
    def duration(self) -> float:
        return float(self.given["duration"])

    @property
    def frames(self) -> int:
        """Times at which fields are written"""
        return self.given.get("frames", _FRAMES)

    @property
    def interval(self) -> float:
        """Of the tables [s]"""
        return float(self.given.get("interval", self.duration / _ROWS))

    @property
    def headline(self) -> str:
        size = " x ".join(f"{s:.4g}" for s in (self.size[[0, 2]] if self.flat else self.size))
        return f"tank of {size} m, liquid {self.depth:.4g} m high, {'at rest' if self.still else 'falls'}" + \
            (f", {len(self.obstacles)} obstacle(s)" if self.obstacles else "") + f"; fluids {self.fluids_name}"


def is_tank(path: Path, overrides: dict[str, Any]) -> bool:
    """Is a scene one without a body? One that has neither or both is refused."""
    file = find(path)
    entries = read_entries(file, overrides)
    there = [name for name in ("body", "tank") if name in entries]
    if not there:
        raise ParameterError(f"{file}: entries 'body' and 'tank' are missing; expected body {{ shape {{ ... }} ... }}, which enters a liquid, "
                             "or tank { size (...); }, which holds one")
    if len(there) == 2:
        raise ParameterError(f"{file}: entries 'body' and 'tank' are both given; expected one of them: a body falls into a liquid without "
                             "walls, and a fixed one in a tank is an obstacle")
    return there[0] == "tank"


def _points(entries: Any, name: str, source: str, numbers: int, inside: Any) -> dict[str, np.ndarray]:
    """Named places."""
    if not isinstance(entries, dict):
        raise ParameterError(f"{source}: entry '{name}' is {foamDictionary.format_value(entries)}; expected {{ NAME ({_axes(numbers)}); ... }}")
    found = {}
    for key, value in entries.items():
        place = _vector(value, f"{name}.{key}", source, numbers)
        why_not = inside(place)
        if why_not:
            raise ParameterError(f"{source}: entry '{name}.{key}' is {foamDictionary.format_value(value)}, {why_not}")
        found[key] = place
    return found


def _axes(numbers: int) -> str:
    return "x z" if numbers == 2 else "x y z"


def _vector(value: Any, name: str, source: str, numbers: int) -> np.ndarray:
    """A place or size with its three components; in the plane, the second is 0."""
    each = number("")[1]
    if not (isinstance(value, list) and len(value) == numbers and all(each(v) for v in value)):
        raise ParameterError(f"{source}: entry '{name}' is {foamDictionary.format_value(value)}; expected metres ({_axes(numbers)}), as many "
                             "as tank.size has")
    return np.array([value[0], 0.0, value[1]] if numbers == 2 else value, float)


def _boxes(entries: Any, name: str, source: str, size: np.ndarray, numbers: int, hydrostatic: bool) -> dict[str, Box]:
    """Named boxes in the tank."""
    expected = f"{{ NAME {{ min ({_axes(numbers)}); max ({_axes(numbers)}); }} ... }}"
    if not isinstance(entries, dict) or not entries or not all(isinstance(box, dict) for box in entries.values()):
        raise ParameterError(f"{source}: entry '{name}' is {foamDictionary.format_value(entries)}; expected {expected}")
    known: dict[str, Check] = {"min": ("a place", lambda v: True), **({"hydrostatic": word("yes", "no")} if hydrostatic else {})}
    found: dict[str, Box] = {}
    for key, box in entries.items():
        place = f"{name}.{key}"
        checked(box, f"{source}, {place}", {"max": ("a place", lambda v: True)}, known)
        low = _vector(box["min"], f"{place}.min", source, numbers) if "min" in box else np.zeros(3)
        high = _vector(box["max"], f"{place}.max", source, numbers)
        if numbers == 2:
            high[1] = size[1]
        if not (high - low > _ROUND * size).all():
            raise ParameterError(f"{source}: entry '{place}.max' is {foamDictionary.format_value(box['max'])}; expected more than min in "
                                 "every direction")
        if (low < -_ROUND * size).any() or (high > (1 + _ROUND) * size).any():
            raise ParameterError(f"{source}: entry '{place}' reaches out of the tank; expected corners from 0 to tank.size, "
                                 f"{_shown(size, numbers)}")
        made = Box(low, high, box.get("hydrostatic", "yes") == "yes")
        for other, there in found.items():
            if made.overlaps(there, _ROUND * float(size.max())):
                raise ParameterError(f"{source}: entry '{place}' overlaps {name}.{other}; expected boxes that touch at most")
        found[key] = made
    return found


def _shown(values: np.ndarray, numbers: int) -> str:
    return foamDictionary.format_value([float(v) for v in (values[[0, 2]] if numbers == 2 else values)])


def read(path: Path, overrides: dict[str, Any] = {}) -> Tank:
    """Read and check a scene without a body. Errors name the file, the entry and what was expected."""
    file = find(path)
    entries = read_entries(file, overrides)
    source = f"{file} (or the command line)" if overrides else str(file)
    refuse_unknown(entries, source, _TOP)
    tank = entries["tank"]
    if not isinstance(tank, dict):
        raise ParameterError(f"{source}: entry 'tank' is {foamDictionary.format_value(tank)}; expected {{ size (x y z); open (top); walls noSlip; }}")
    for key, wanted in (("liquid", "{ NAME { min (...); max (...); } ... }, boxes of liquid"),
                        ("fluids", "a pair such as water or titan, or { liquid water; gas earthAir; gravity 9.81; }")):
        if key not in entries:
            raise ParameterError(f"{source}: entry '{key}' is missing; expected {wanted}")
    numbers_only = {key: entries[key] for key in ("duration", *_NUMBERS) if key in entries}
    checked(numbers_only, source, {"duration": positive}, _NUMBERS)
    checked(tank, f"{source}, tank",
            {"size": ("metres above 0: (x y z), or in the plane (x z)",
                      lambda v: isinstance(v, list) and len(v) in (2, 3) and all(positive[1](x) for x in v))},
            {"open": ("a list of faces: " + " ".join(FACES), lambda v: isinstance(v, list) and all(face in FACES for face in v)),
             "walls": word(*WALLS)})
    numbers = len(tank["size"])
    size = np.array([tank["size"][0], 1.0, tank["size"][1]] if numbers == 2 else tank["size"], float)
    open_ = tuple(tank.get("open", ["top"]))
    if numbers == 2 and {"front", "back"} & set(open_):
        raise ParameterError(f"{source}: entry 'tank.open' names front or back, which a tank in the plane does not have; expected left, "
                             "right, bottom or top")

    obstacles = _boxes(entries["obstacles"], "obstacles", source, size, numbers, False) if "obstacles" in entries else {}
    for name in obstacles:
        if name in (OUTSIDE, OPEN, SIDES):
            raise ParameterError(f"{source}: entry 'obstacles.{name}': expected another name: {OUTSIDE}, {OPEN} and {SIDES} are taken")
    liquid = _boxes(entries["liquid"], "liquid", source, size, numbers, True)
    if sum(box.volume for box in liquid.values()) <= sum(_common(box, other) for box in liquid.values() for other in obstacles.values()) \
            + _ROUND * float(np.prod(size)):
        raise ParameterError(f"{source}: entry 'liquid' lies in obstacles, which leave nothing liquid; expected a box in the open tank")

    def outside(place: np.ndarray, axes: slice) -> str:
        if (place[axes] < -_ROUND * size[axes]).any() or (place[axes] > (1 + _ROUND) * size[axes]).any():
            return f"outside the tank; expected a place from 0 to tank.size, {_shown(size, numbers)}"
        return ""

    def in_obstacle(place: np.ndarray) -> str:
        name = next((name for name, box in obstacles.items() if ((place > box.low) & (place < box.high)).all()), None)
        return outside(place, slice(0, 3)) or (f"inside obstacles.{name}; expected a place in the fluids or on a wall" if name else "")

    gauges = _points(entries.get("gauges", {}), "gauges", source, numbers, lambda place: outside(place, slice(0, 3)))
    probes = _points(entries.get("probes", {}), "probes", source, numbers, in_obstacle)
    name, fluids, doubts = fluid_pairs.resolve(entries["fluids"], source)
    if fluids["gravity"] == 0:
        raise ParameterError(f"{source}: entry 'fluids' has no gravity; expected gravity above 0, by which a tank holds its liquid")
    return Tank({**numbers_only, "tank": tank}, file, source, size, numbers == 2, open_, tank.get("walls", WALLS[0]), liquid, obstacles,
                gauges, probes, fluids, name, doubts)


def _common(one: Box, other: Box) -> float:
    """Volume of what two boxes share [m3]"""
    return float(np.prod(np.clip(np.minimum(one.high, other.high) - np.maximum(one.low, other.low), 0.0, None)))


# --- what is computed, and why


def _breaks_plane(tank: Tank) -> str:
    """Why the plane does not do; empty where it does."""
    across = {**{f"liquid.{name}": box for name, box in tank.liquid.items()},
              **{f"obstacles.{name}": box for name, box in tank.obstacles.items()}}
    for name, box in across.items():
        if box.low[1] > _ROUND * tank.size[1] or box.high[1] < (1 - _ROUND) * tank.size[1]:
            return f"{name} does not reach from front to back"
    open_ = {"front", "back"} & set(tank.open)
    return f"{sorted(open_)[0]} is open" if open_ else ""


def model(tank: Tank, asked: str) -> Decision:
    """Plane, or full: in space."""
    why_not = _breaks_plane(tank)
    if asked == "plane" and why_not:
        raise ParameterError(f"{tank.source}: -model plane, but {why_not}; expected auto or full")
    if asked == "full" and tank.flat:
        raise ParameterError(f"{tank.source}: -model full, but tank.size has two numbers; expected three, or auto or plane")
    if asked not in ("auto", "plane", "full"):
        raise ParameterError(f"{tank.source}: -model {asked}, but there is no body; expected auto, plane or full")
    if asked != "auto":
        return Decision(asked, "as asked")
    if tank.flat:
        return Decision("plane", "the tank lies in a plane")
    if not why_not:
        return Decision("plane", "nothing varies from front to back; the friction of these two walls is left out")
    return Decision("full", why_not)


def boundary_layer(tank: Tank, method: str, asked: str, cell: float) -> Decision:
    """What is made of the layer on the walls; `cell`: the size of the mesh's cells [m]."""
    if asked not in ("auto", "none", *(["laminar"] if method == "meshes" else [])):
        raise ParameterError(f"-boundaryLayer {asked}: expected auto{', laminar' if method == 'meshes' else ''} or none for a tank")
    if tank.walls == "slip":
        if asked == "laminar":
            raise ParameterError(f"{tank.source}: -boundaryLayer laminar, but entry 'tank.walls' is slip; expected noSlip")
        return Decision("none", "the walls slip")
    if method == "particles":
        return Decision("none", "the walls hold what touches them; plungeSPH has none else")
    needed = boundaryLayer.resolving_layer(tank.reynolds, tank.depth)
    what = f"Re = {tank.reynolds:.3g}: a laminar layer needs cells of {needed:.3g} m, these are {cell:.3g} m"
    if cell <= needed:
        return Decision("none" if asked == "none" else "laminar", what)
    if asked == "laminar":
        raise ParameterError(f"{tank.source}: -boundaryLayer laminar, but {what}; expected none, or a higher -resolution")
    return Decision("none", f"{what}; the walls' friction is that of their first cells")


def decide(tank: Tank, method: str, options: dict[str, Any], cell: float) -> dict[str, Decision]:
    """What the flow holds."""
    decided = {"boundary_layer": boundary_layer(tank, method, options["boundaryLayer"], cell),
               "surface_tension": decisions.surface_tension(tank, method, options["surfaceTension"])}
    if method == "meshes":
        decided["compressibility"] = decisions.compressibility(tank, method)
    return decided
