# SPDX-License-Identifier: GPL-3.0-or-later
"""Added mass of ellipsoids in unbounded fluid."""

from __future__ import annotations

import numpy as np
from scipy.special import elliprd


def ellipsoid_added_mass(a: float, b: float, c: float) -> tuple[np.ndarray, np.ndarray]:
    """Added mass along the axes of an ellipsoid of semi-axes a, b, c in unbounded ideal fluid over the displaced mass, and
    added inertia about them over the displaced fluid's [-] (Lamb 1932, arts. 114, 115 and 373).

    alpha_i = abc int_0^inf dl/((s_i^2 + l) sqrt((a^2 + l)(b^2 + l)(c^2 + l))), which is 2/3 abc R_D of Carlson.
    """
    squares = np.array([a, b, c], dtype=float) ** 2
    following, last = np.roll(squares, -1), np.roll(squares, -2)
    alpha = 2 / 3 * a * b * c * elliprd(following, last, squares)
    difference, total = following - last, following + last
    change = np.roll(alpha, -2) - np.roll(alpha, -1)
    # About the axis of a body of revolution: 0/0, and no fluid moves
    turns = np.abs(difference) > 1e-9 * total
    safe = np.where(turns, difference, 1)
    rotary = np.where(turns, safe**2 * change / (total * (2 * safe - total * change)), 0)
    return alpha / (2 - alpha), rotary
