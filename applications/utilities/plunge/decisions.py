# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a scene is computed, and why: dimension and symmetry, mesh, boundary layer, surface tension, compressibility."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, radians, sin
from typing import Any

import numpy as np

from plunge import boundaryLayer
from plunge.checks import ParameterError
from plunge.meridianMesh import SECTOR
from plunge.scene import Scene

METHODS = ("meshes", "particles", "slenderBody")
MODELS = ("plane", "axisymmetric", "quarter", "half", "full")
MESHES = ("overset", "following", "single")
# Of the body that a model holds; elsewhere all of it. Between plane wedges a sector has the volume of a polygon's.
_SHARES = {"half": 0.5, "quarter": 0.25, "axisymmetric": sin(radians(SECTOR)) / (2 * pi)}

# Weber number above which surface tension acts on less than a millionth of the length, which no mesh resolves
_HIGHEST_WEBER = 1e6
# A layer is called laminar up to this many times the Reynolds number of transition: over half the length, and more
_MOSTLY_LAMINAR = 2.0
# Travel from rest over the body's length above which the background follows: a corridor of fine cells would have more than those about the body
_FAR = 1.0
# Width over length above which the flow about a smooth body separates where that along walls that slip does not
_BLUNT = 0.5
# Mach number above which a flow's density changes by more than a twentieth
_COMPRESSIBLE = 0.3


@dataclass(frozen=True)
class Decision:
    """A choice and its reason."""

    choice: str
    reason: str


def _is_vertical(scene: Scene) -> bool:
    """Does a body of revolution move along its own, vertical axis?"""
    return (abs(scene.angle) == 90 or scene.speed == 0) and abs(scene.forward[2]) > 1 - 1e-12 and "entry.sideslip" not in scene.given \
        and np.hypot(*scene.centre[1:]) < 1e-9 * scene.shape.length


def _breaks_half(scene: Scene) -> str:
    """Why half of the body does not do; empty where it does."""
    if not scene.shape.isSymmetric:
        return "the body is not symmetric about its plane y = 0"
    if "entry.sideslip" in scene.given and scene.given["entry.sideslip"] != 0:
        return "sideslip"
    if scene.spin[[0, 2]].any():
        return "roll or yaw"
    if abs(scene.centre[1]) > 1e-9 * scene.shape.length:
        return "the centre of mass is off the plane y = 0"
    return ""


def model(scene: Scene, method: str, asked: str) -> Decision:
    """Dimension and symmetry."""
    plane = scene.shape.dimensions == 2
    vertical = scene.shape.isRevolution and _is_vertical(scene) and not scene.spin.any()
    straight = scene.freedom in ("fixed", "prescribed", "axial")
    why_not_half = _breaks_half(scene)
    source = f"{scene.source}: -model {asked}"
    if asked != "auto":
        if plane != (asked == "plane"):
            raise ParameterError(f"{source}, but the shape {scene.given['body.shape']['type']} {'lies in a plane' if plane else 'is a body in space'}; "
                                 f"expected {'auto or plane' if plane else 'auto, axisymmetric, half or full'}")
        if asked in ("axisymmetric", "quarter") and not (vertical and straight):
            reason = "the shape is none of revolution" if not scene.shape.isRevolution else \
                "the body may leave its axis" if vertical else "the body does not move along its own, vertical axis"
            raise ParameterError(f"{source}, but {reason}; expected half or full" + (", or freedom axial" if vertical else ""))
        if asked == "quarter" and method == "meshes":
            raise ParameterError(f"{source}, but that is for particles; expected auto, axisymmetric, half or full")
        if method == "slenderBody" and asked != "full":
            raise ParameterError(f"{source}, but slenderBody takes the whole body; expected auto or full")
        if asked == "half" and why_not_half:
            raise ParameterError(f"{source}, but {why_not_half}; expected full")
        return Decision(asked, "as asked")
    if method == "slenderBody":
        return Decision("full", "strips of the whole body")
    if plane:
        return Decision("plane", "the shape lies in a plane")
    if vertical and straight:
        return Decision("axisymmetric", "a body of revolution moves along its own, vertical axis")
    if not why_not_half:
        return Decision("half", "nothing drives the body out of its plane of symmetry")
    return Decision("full", why_not_half)


def share(modelled: str, method: str) -> float:
    """Of the body that a model holds; axisymmetric particles are whole rings."""
    return 1.0 if (modelled, method) == ("axisymmetric", "particles") else _SHARES.get(modelled, 1.0)


def mesh(scene: Scene, method: str, modelled: str, asked: str) -> Decision:
    """One mesh that moves with the body, or one about the body on a background that stands or travels with it."""
    if method == "particles":
        if asked not in ("auto", *MESHES):
            raise ParameterError(f"-mesh {asked}: expected one of: auto {' '.join(MESHES)}")
        return Decision("none", "particles have none")
    if method == "slenderBody":
        if asked != "auto":
            raise ParameterError(f"-mesh {asked}, but slenderBody has no mesh; expected auto")
        return Decision("none", "strips need none")
    if modelled in ("plane", "axisymmetric"):
        if asked in ("overset", "following"):
            raise ParameterError(f"{scene.source}: -mesh {asked}, but the model is {modelled}, whose mesh moves with the body; expected "
                                 "auto or single" + ("" if modelled == "plane" else ", or -model half or full"))
        return Decision("single", f"of the {modelled} model: it moves with the body")
    if asked != "auto":
        return Decision(asked, "as asked")
    if scene.freedom == "fixed":
        return Decision("single", "the body does not move")
    travel = float(np.linalg.norm(scene.end - scene.nose)) / scene.shape.length
    if scene.speed or travel > _FAR:
        return Decision("following", f"the body travels {travel:.3g} of its lengths, and the background with it")
    return Decision("overset", "from rest, the body moves by less than its length on a background that stands")


def boundary_layer(scene: Scene, method: str, asked: str, first_layer: float, affordable: bool) -> Decision:
    """What is made of the boundary layer; `first_layer`: thickness of the mesh's first cells [m] unless they are made thinner, which is
    `affordable` or not."""
    transition = scene.transition
    if method == "particles":
        if asked not in ("auto", "none"):
            raise ParameterError(f"-boundaryLayer {asked}: expected auto or none: plungeSPH has no boundary layer")
        return Decision("none", "plungeSPH has none")
    if method == "slenderBody":
        if asked not in ("auto", "frictionLine", "none"):
            raise ParameterError(f"-boundaryLayer {asked}: expected auto, frictionLine or none: slenderBody has no other")
        transition = f"transition at {transition:.3g} of the wetted length"
        return Decision("none", "as asked") if asked == "none" else Decision("frictionLine", f"Re = {scene.wetted_reynolds:.3g}, {transition}")
    of = f"Re = {scene.wetted_reynolds:.3g}" + (" of the length that is wetted" if scene.wetted_length < scene.shape.length else "")
    needed = boundaryLayer.resolving_layer(scene.wetted_reynolds, scene.wetted_length)
    resolved = affordable or first_layer <= needed
    if asked == "laminar" and not resolved:
        raise ParameterError(f"-boundaryLayer laminar, but the mesh's first layer is {first_layer:.3g} m and a laminar layer at {of} needs "
                             f"{needed:.3g} m; expected frictionLine, or a finer mesh")
    if asked != "auto":
        return Decision(asked, f"as asked; {of}")
    if scene.wetted_reynolds > _MOSTLY_LAMINAR * transition:
        return Decision("frictionLine", f"{of}, above transition at {transition:.3g}")
    below = f"{of}, transition at {transition:.3g}"
    if not resolved:
        return Decision("frictionLine", f"{below}, but the mesh's first layer is {first_layer:.3g} m and a laminar layer needs {needed:.3g} m")
    return Decision("laminar", f"{below}: the mesh resolves the layer")


def surface_tension(scene: Scene, method: str, asked: str) -> Decision:
    """Whether it acts: on or off."""
    if method == "particles":
        if asked == "on":
            raise ParameterError("-surfaceTension on: expected auto or off: plungeSPH has none")
        return Decision("off", "plungeSPH has none")
    if method == "slenderBody":
        if asked == "on":
            raise ParameterError("-surfaceTension on: expected auto or off: slenderBody has none")
        return Decision("off", "slenderBody has none; whether a smooth body draws a cavity depends on it")
    sigma = scene.fluids["surfaceTension"]
    if sigma == 0:
        if asked == "on":
            raise ParameterError("-surfaceTension on, but the liquid has none; expected an entry surfaceTension of the fluids")
        return Decision("off", "the liquid has none")
    weber = scene.weber
    if asked != "auto":
        return Decision(asked, f"as asked; We = {weber:.3g}")
    return Decision("off" if weber > _HIGHEST_WEBER else "on", f"We = {weber:.3g}")


def compressibility(scene: Scene, method: str) -> Decision:
    """Of the real fluids: none can be had yet."""
    liquid, gas = (scene.reference_speed / scene.fluids[name] for name in ("liquidSoundSpeed", "gasSoundSpeed"))
    numbers = f"Ma = {liquid:.3g} in the liquid, {gas:.3g} in the gas"
    if max(liquid, gas) > _COMPRESSIBLE:
        numbers += f": above {_COMPRESSIBLE:g} it matters, and cannot be had yet"
    return Decision("artificial" if method == "particles" else "none", numbers)


def described(**decisions: Decision) -> list[str]:
    """A line for each."""
    return [f"{name.replace('_', ' ')}: {decision.choice} ({decision.reason})" for name, decision in decisions.items()]


def sections(decided: dict[str, Decision], scene: Scene, method: str) -> dict[str, Any]:
    """Entries of plungeGenerated."""
    notes = list(scene.notes)
    layer = decided["boundary_layer"].choice
    if method == "meshes" and layer in ("frictionLine", "none") and scene.shape.slenderness > _BLUNT:
        notes.append(f"With boundary layer {layer} the walls slip: where a body as blunt as this one (width over length {scene.shape.slenderness:.3g}) is "
                     "smooth, the flow stays attached to its rear, and a real one separates; -boundaryLayer wallFunction lets it")
    return {
        "boundaryLayer": decided["boundary_layer"].choice,
        **({"transitionReynolds": scene.transition} if method != "particles" else {}),
        "surfaceTensionModelled": decided["surface_tension"].choice,
        "decisions": described(**decided),
        **({"notes": notes} if notes else {}),
    }
