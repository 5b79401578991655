# SPDX-License-Identifier: GPL-3.0-or-later
"""The flow of an ideal fluid along the axis of a body of revolution, by sources on its surface (Hess and Smith, J. Ship Res. 8 (1964) 22):
rings of constant strength on straight panels, whose normal velocity takes the stream's away."""

from __future__ import annotations

import numpy as np
from scipy.special import ellipe, ellipkm1

from plunge.shapes import Curve
from plunge.studies.signals import Signal

PANELS = 300
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(16)
HALVINGS = 14   # of a panel towards its middle, where its own velocity is


def _ring(x: np.ndarray, r: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Velocity along x and r at (x, r) of a unit source for each length of the ring of radius b at a."""
    far, near = (r + b)**2 + (x - a)**2, (r - b)**2 + (x - a)**2
    root, first, second = np.sqrt(far), ellipkm1(near/far), ellipe(1 - near/far)
    return np.array([b*(x - a)*second/(np.pi*near*root), b/(2*np.pi*r*root)*(first - (b**2 - r**2 + (x - a)**2)/near*second)])


def pressure(curve: Curve) -> Signal:
    """Pressure coefficient over the distance from the nose along the axis, in body lengths."""
    c = np.linspace(0, 1, 100*PANELS + 1)
    s = curve.arc_length(c)
    x, r = curve.point(np.interp(s[-1]/2*(1 - np.cos(np.linspace(0, np.pi, PANELS + 1))), s, c))
    length = x[-1]
    x, r, dx, dr = (x[1:] + x[:-1])/2, (r[1:] + r[:-1])/2, np.diff(x), np.diff(r)
    ds = np.hypot(dx, dr)
    along, normal = np.array([dx, dr])/ds, np.array([-dr, dx])/ds

    velocity = np.zeros((2, PANELS, PANELS))    # of each panel's unit source, the second index, at each panel's middle
    for q, weight in zip(POINTS/2, WEIGHTS/2):
        velocity += weight*ds*_ring(x[:, None], r[:, None], x + q*dx, r + q*dr)
    own = normal/2                              # of the panel as a plane; beside it what the ring's curvature makes
    edges = 0.5**np.arange(1, HALVINGS + 2)
    for high, low in zip(edges, edges[1:]):
        for q, weight in zip(POINTS, WEIGHTS):
            at = (high + low)/2 + q*(high - low)/2
            own = own + weight/2*(high - low)*ds*(_ring(x, r, x + at*dx, r + at*dr) + _ring(x, r, x - at*dx, r - at*dr))
    velocity[:, range(PANELS), range(PANELS)] = own

    strength = np.linalg.solve(np.einsum("ki,kij->ij", normal, velocity), -normal[0])
    speed = along[0] + np.einsum("ki,kij,j->i", along, velocity, strength)
    return Signal(x/length, 1 - speed**2)
