# SPDX-License-Identifier: GPL-3.0-or-later
"""The boundary layer on the body: what is made of it, and the mesh that this asks for."""

from __future__ import annotations

from math import log, log10, sqrt
from typing import Mapping

import numpy as np

from plunge.results import incidence

TREATMENTS = ("laminar", "wallFunction", "frictionLine", "none")

# The first cell's share of a laminar layer's thickness: plungeFoam refuses more than a tenth, of all first cells' mean, which is
# larger by less than a tenth than that at the thickest section.
_RESOLVED_SHARE = 0.09
# Wall distance y+ of the first cells' centres under wall functions: in the logarithmic layer, with room to either side.
WALL_DISTANCE = 60
# Where wall functions hold.
WALL_DISTANCES = (30, 300)
# Below this Reynolds number no layer is turbulent, and the friction line does not reach.
_LEAST_REYNOLDS = 1e4
# Incidence [deg] from which the flow across a slender body separates along it (Allen and Perkins, NACA Report 1048, 1951).
_SEPARATING_INCIDENCE = 10


def separation_note(layer: str, trajectory: Mapping[str, np.ndarray]) -> str:
    """What is to be said of a body on walls that slip which has stood across its path; empty where it has not."""
    angle = incidence(trajectory)
    if layer not in ("frictionLine", "none") or angle.max() < _SEPARATING_INCIDENCE:
        return ""
    since = trajectory["time_s"][np.argmax(angle > _SEPARATING_INCIDENCE)]
    return (f"The axis stood at up to {angle.max():.0f} deg to the body's path, from t = {since:.4g} s on at more than {_SEPARATING_INCIDENCE} deg: there the flow across a "
            f"slender body separates (Allen and Perkins 1951), and along walls that slip (boundary layer {layer}) it does not. The motion after that is not to be relied upon; "
            "expected -boundaryLayer wallFunction")


def resolving_layer(reynolds: float, length: float) -> float:
    """Thickest first layer [m] that resolves a laminar boundary layer, 5 sqrt(nu x/U) thick, at half the length."""
    return _RESOLVED_SHARE * 5 * length * sqrt(0.5 / reynolds)


def turbulent_friction(reynolds: float) -> float:
    """Mean friction coefficient of a flat plate, turbulent throughout: the line of Prandtl and Schlichting
    (Schlichting, Boundary-Layer Theory, 7th ed. 1979, eq. 21.16a)."""
    return 0.455 / log10(reynolds) ** 2.58


def wall_function_layer(reynolds: float, length: float) -> float:
    """First layer [m] for wall functions; friction at half the length by the line of Prandtl and Schlichting."""
    half = max(reynolds / 2, _LEAST_REYNOLDS)
    local = turbulent_friction(half) * (1 - 2.58 / log(half))
    return 2 * WALL_DISTANCE * length / (reynolds * sqrt(local / 2))


# Turbulence intensity and omega length/speed of the undisturbed fluids. In the default dive k is 1e-4 m2/s2 and omega 10 1/s:
# an eddy viscosity of 4e-7 speed length, seven times that of the liquid and without effect on the flow about the body, while
# omega is low enough for k not to decay before the body arrives (by 4 % in the dive).
_INTENSITY, _OMEGA = 3.3e-4, 0.4


def free_stream(speed: float, length: float) -> tuple[float, float]:
    """k [m2/s2] and omega [1/s] of the undisturbed fluids."""
    return 1.5 * (_INTENSITY * speed) ** 2, _OMEGA * speed / length
