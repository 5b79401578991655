# SPDX-License-Identifier: GPL-3.0-or-later
"""The front of a collapsing column, of particles and on meshes, against Martin and Moyce 1952, in their units: Z = front/a, T = t sqrt(2 g/a).

They saw the front from some width on, and their gate took time to open: so the speed is judged between Z = 1.5 and 3.5, in
which neither shows, and the arrival at Z = 3, in which both do. Reference and its uncertainty are the mean and the difference of
the two widths of the experiment."""
from functools import lru_cache
from pathlib import Path

import numpy as np

from plunge.studies.foamFields import numbers
from plunge.studies.particleRuns import particles, series
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.scenes import solveScene, spacings
from plunge.studies.signals import Signal
from plunge.studies.study import Quantity, Run, Study

WIDTH, GRAVITY = 0.15, 9.81
TABLE = reference("MartinMoyce1952", "front")
MEASURED = {f"Martin and Moyce, a = {a} in": Signal(TABLE["T"][TABLE["a_in"] == a], TABLE["Z"][TABLE["a_in"] == a])
            for a in np.unique(TABLE["a_in"])}


def arrival(front: Signal) -> float:
    return float(np.interp(3, front.value, front.time))


def speed(front: Signal) -> float:
    return 2/float(np.diff(np.interp((1.5, 3.5), front.value, front.time))[0])


@lru_cache(maxsize=None)
def ofParticles(run: Path, spacing: float) -> Signal:
    times, fields = zip(*((time, particles(file)) for time, file in series(run)))
    return Signal(np.array(times), np.array([each["x"][each["wall"] < 0, 0].max() + spacing/2 for each in fields]))


@lru_cache(maxsize=None)
def ofMesh(run: Path) -> Signal:
    """The foremost point where half of the volume is liquid."""
    files = sorted((float(file.parent.name), file) for file in run.glob("postProcessing/front/*/alpha.liquid_surface.raw"))
    return Signal(np.array([time for time, _ in files]), np.array([numbers(file)[:, 0].max() for _, file in files]))


def computed(done) -> Signal:
    """Until the front meets the wall, at 4 a."""
    found = ofParticles(done.path, done.run.size) if done.run.method == "particles" else ofMesh(done.path)
    Z = found.value/WIDTH
    return Signal((found.time*np.sqrt(2*GRAVITY/WIDTH))[Z < 3.95], Z[Z < 3.95])


END = {"system/controlDict": "endTime 0.28;"}
SURFACE = {"system/controlDict": "endTime 0.28; functions { front { type surfaces; libs (sampling); writeControl adjustable; writeInterval 0.005; "
           "surfaceFormat raw; fields (alpha.liquid); surfaces ( surface { type isoSurface; isoField alpha.liquid; isoValue 0.5; interpolate true; } ); } }"}


study = Study(
    title="A collapsing column's front is as fast as Martin and Moyce's, and arrives when theirs does",
    runs=[*spacings("damBreak", {0.01: ("quick", "full"), 0.005: ("full",)}, END),
          *(Run("damBreak", "meshes", "", level, tiers, given={"changes": SURFACE})
            for level, tiers in (("fast", ("quick", "full")), ("fast 1.5", ("full",)), ("fast 2", ("full",))))],
    solve=solveScene, sources=("src/smoothedParticles", "src/freeSurfaceFlow", "applications/solvers"),
    quantities=[Quantity(name, "1", lambda done, of=of: of(computed(done)), converges=True,
                         reference=float(np.mean([*map(of, MEASURED.values())])), uncertainty=float(np.ptp([*map(of, MEASURED.values())])))
                for name, of in (("speed of the front over sqrt(2 g a)", speed), ("arrival of the front at 3 a, times sqrt(2 g/a)", arrival))],
    headlines=["speed of the front over sqrt(2 g a)"],
    figure=lambda done, file: draw(file, [({"xlabel": "t sqrt(2 g/a)", "ylabel": "front/a", "xlim": (0, 4), "ylim": (0, 5)}, MEASURED, {
        f"{each.run.method}, {each.run.resolution}": computed(each) for each in done})]))
