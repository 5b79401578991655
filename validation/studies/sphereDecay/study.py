# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere released above its equilibrium on the surface of deep water. Variants are cAlpha.

Test 1 of IEA OES Task 10: radius 5 m, half immersed at rest, released 1 m up. Judged against the mean of the reference's codes, within
1 % of the period and 5 % of the decrement, which they differ by: the mean time between the extremes of one sign, and the logarithmic
decrement per period, from heights between successive extremes, which an offset of the level does not touch. The compression of the
interface (cAlpha) feeds on waves that are not steep; so the sphere heaves with it and without."""
import numpy as np

from plunge.studies.heavingSphere import RADIUS, height, oscillation, solve
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.signals import Signal
from plunge.studies.study import Quantity, Run, Study

TABLE = reference("OES2017", "decay")
TIME, *CODES = TABLE.dtype.names
MEASURED = {code: Signal(TABLE[TIME], TABLE[code]) for code in CODES}
PERIOD, DECREMENT = np.array([oscillation(signal) for signal in MEASURED.values()]).T


def over(i: int, of: np.ndarray):
    """The sphere's over the codes' mean."""
    return lambda done: oscillation(height(done.path))[i]/float(of.mean())


study = Study(
    title="A sphere heaves on the surface with the period and the damping that other codes agree on",
    runs=[Run("heavingSphere", "meshes", f"cAlpha {compression}", f"{RADIUS/cells:g} m", tiers, given={"cells": cells, "compression": compression})
          for cells, tiers in ((50, ("full",)), (100, ("full",)), (12, ("quick",))) for compression in (0, 1)],
    solve=lambda run, path: solve(path, **run.given),
    sources=("src/freeSurfaceFlow", "src/rigidBody", "applications/solvers/plungeFoam", "validation/studies/sphereDecay/case"),
    quantities=[Quantity(name, "1", over(i, of), 1, tolerance=tolerance) for i, (name, of, tolerance) in enumerate((
        ("period over the codes' mean", PERIOD, 0.01), ("logarithmic decrement over the codes' mean", DECREMENT, 0.05)))],
    headlines=["period over the codes' mean", "logarithmic decrement over the codes' mean"],
    figure=lambda done, file: draw(file, [({"xlabel": "time [s]", "ylabel": "height over that of the release"}, {
        code: signal.during(0, 16) for code, signal in MEASURED.items()}, {each.run.name: height(each.path) for each in done})]))
