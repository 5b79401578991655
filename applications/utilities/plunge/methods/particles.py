# SPDX-License-Identifier: GPL-3.0-or-later
"""plungeSPH: the tank of liquid about the path, the particles' spacing and speed of sound."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, sqrt
from typing import Any

import numpy as np

from plunge import decisions
from plunge.decisions import Decision
from plunge.methods import Asked
from plunge.methods.meshes import vector

# Least half width of the particles' liquid about the path and its depth below it, the part of these that absorbs, and the height
# of the tank above the surface, in body scales.
_REACH, _ABSORBING, _FREEBOARD = 0.35, 0.1, 0.1
# Least half width and depth over the body's largest radius
_LEAST_REACH = 3.5
# Half width over how deep the body goes, but for what is beyond its length: in a narrow tank the liquid has to rise past the body, which
# brakes it. Within 3 % of the speed lost in a wide one (study crossCheck); the depth below the path matters less
_WIDTH_OVER_DEPTH = 1.05
# Widths over the least, where they are cheap or, in the plane, what a body sets in motion reaches further: there the depth, too
_FLAT_REACH = 4
# c0 over the highest speed that the body could fall at, or that of long waves, unless given: eq. 5 of IAC-20-E2.1.9
_SOUND_OVER_SPEED = 10
# Its steps, for the estimate: plungeSPH's Courant number, over h/(c0 + speed), and h over the spacing
_COURANT, _SMOOTHING_LENGTH = 0.5, 1.5
# Liquid starts with the pressure of rest where gravity counts: speed^2 over g and the body's length
_HIGHEST_FROUDE = 10
# Rows of the tables
_TABLE_ROWS = 450


@dataclass(frozen=True)
class Particles(Asked):
    """What is asked for of the particles of a scene."""

    sound_speed: "float | None" = None

    @property
    def spacing(self) -> float:
        """[m]"""
        return self.tier["particleSpacing"] * self.scene.scale / self.resolution


def sections(particles: Particles) -> list[tuple[str, dict[str, Any]]]:
    """A box of liquid about the path, a whole number of spacings in each direction."""
    scene, spacing, model = particles.scene, particles.spacing, particles.model
    scale, full, flat, onAxis = scene.scale, model == "full", model in ("plane", "axisymmetric"), model in ("quarter", "axisymmetric")

    def spacings(distance: float) -> int:
        return ceil(distance / spacing - 1e-9)

    reach = max(_REACH * scale, _LEAST_REACH * scene.shape.max_diameter / 2)
    start, end = scene.nose - scene.shape.length * scene.forward, scene.end
    deepest = max(0.0, -min(end[2], start[2] if scene.immersed else end[2], scene.nose[2]))
    width = max(reach, _FLAT_REACH * reach if flat else _WIDTH_OVER_DEPTH * min(deepest, scene.shape.length))
    below = _FLAT_REACH * reach if model == "plane" else reach
    # The nose enters at x = 0; what of the body is above the surface meets no liquid.
    x_low = min(0.0, end[0], start[0] if scene.immersed else 0.0)
    low = [0 if onAxis else -spacings(width - x_low), -spacings(width) if full else 0, -spacings(below + deepest)]
    high = [spacings(width + max(end[0], start[0] if scene.immersed else end[0], 0.0)), spacings(width), 0]
    count = int(np.prod([h - l for axis, (l, h) in enumerate(zip(low, high)) if not (flat and axis == 1)]))
    fall = max(0.0, scene.nose[2] - end[2])
    gravity = scene.fluids["gravity"]
    fastest = max(sqrt(scene.speed**2 + 2 * gravity * fall), sqrt(gravity * spacing * -low[2]))
    hydrostatic = scene.immersed or scene.speed**2 < _HIGHEST_FROUDE * gravity * scene.shape.length
    c0 = float(particles.sound_speed or _SOUND_OVER_SPEED * fastest)
    top = spacings(_FREEBOARD * scale)

    translation, rotation = scene.shape.added_mass_coefficients()
    displaced = decisions.share(model, "particles") * scene.fluids["liquidDensity"]

    box = {"liquidMin": low, "liquidMax": high, "tankMax": [*high[:2], top]}
    if flat:  # plungeSPH's plane is x and y
        box = {name: [corner[0], corner[2], 0] for name, corner in box.items()}
    absorbing = {"full": ["left", "right", "front", "back", "bottom"], "half": ["left", "right", "back", "bottom"],
                 "quarter": ["right", "back", "bottom"], "plane": ["left", "right", "bottom"], "axisymmetric": ["right", "bottom"]}[model]
    return [
        # plungeFoam computes it from the flow
        ("What the liquid adds to the immersed body: an estimate for the coupling, which does not change its result", {
            "addedMassEstimate": vector(displaced * scene.shape.volume * translation),
            "addedInertiaEstimate": vector(displaced * np.diag(scene.shape.inertia) * rotation),
        }),
        ("Particles", {
            "particleSpacing": spacing,
            **{name: vector(np.multiply(corner, spacing)) for name, corner in box.items()},
            "hydrostatic": "yes" if hydrostatic else "no",
            "tankOpen": {"half": ["front", "top"], "quarter": ["left", "front", "top"], "axisymmetric": ["left", "top"]}.get(model, ["top"]),
            "absorbingFaces": absorbing,
            "absorbingThickness": _ABSORBING * scale,
            "particleSoundSpeed": c0,
        }),
        ("Run", {
            "cores": particles.cores, "fluidParticles": count,
            "estimatedSteps": round(scene.duration * (c0 + scene.reference_speed) / (_COURANT * _SMOOTHING_LENGTH * spacing), -1),
            "diveDuration": scene.duration, "frameInterval": scene.duration / scene.frames,
            "tableInterval": scene.duration / _TABLE_ROWS,
        }),
    ]


def decide(particles: Particles, c0: float, boundary_layer: str, surface_tension: str) -> dict[str, Decision]:
    """What the flow holds; c0: the speed of sound that came out [m/s]."""
    scene = particles.scene
    reach = 2 * _SMOOTHING_LENGTH * particles.spacing
    if not scene.immersed and scene.lowest < reach:
        scene.notes.append(f"gap: the body is {scene.lowest:.3g} m above the surface, but particles reach {reach:.3g} m: it is loaded before contact")
    mach = scene.reference_speed / c0
    return {
        "boundary_layer": decisions.boundary_layer(scene, "particles", boundary_layer, 0.0, False),
        "surface_tension": decisions.surface_tension(scene, "particles", surface_tension),
        "compressibility": Decision("artificial", f"c0 = {c0:.3g} m/s, Ma = {mach:.3g}" + (": above 0.1 the density changes visibly" if mach > 0.11 else "")),
    }
