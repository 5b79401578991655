# SPDX-License-Identifier: GPL-3.0-or-later
"""Added mass of ellipsoids in unbounded fluid."""

from __future__ import annotations

import numpy as np


def added_mass_of_spheroid(diameter_ratio: float) -> tuple[float, float, float]:
    """Added mass along the axis, across it and added inertia about a transverse axis, of the spheroid whose diameter is this share
    of its length, over the displaced fluid's (Lamb 1932, arts. 114-115) [-]."""
    square = 1 - diameter_ratio**2  # of the eccentricity; negative where it is oblate
    if abs(square) < 1e-6:
        return 0.5, 0.5, 0.0
    if square > 0:
        e = np.sqrt(square)
        log = np.log((1 + e) / (1 - e))
        alpha = 2 * (1 - e**2) / e**3 * (log / 2 - e)
        beta = 1 / e**2 - (1 - e**2) / (2 * e**3) * log
    else:
        # Lamb's zeta of planetary spheroids, art. 108
        zeta = 1 / np.sqrt(diameter_ratio**2 - 1)
        alpha = 2 * (zeta**2 + 1) * (1 - zeta * np.arctan(1 / zeta))
        beta = zeta * (zeta**2 + 1) * np.arctan(1 / zeta) - zeta**2
    rotary = square**2 * (beta - alpha) / ((2 - square) * (2 * square - (2 - square) * (beta - alpha)))
    return float(alpha / (2 - alpha)), float(beta / (2 - beta)), float(rotary)
