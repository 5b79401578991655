# SPDX-License-Identifier: GPL-3.0-or-later
"""A neutrally buoyant cylinder that falls into water, with particles and with meshes in the plane, against Greenhow and Lin's experiment, and
against boundary elements (BEM).
Penetration is that of the lowest point, over the diameter; T is time over sqrt(D/g).

Judged: the distance from the BEM, rms over its points, which another SPH's distance from it limits; and the distance from the
experiment's six points, which the BEM's own limits, for these scatter: the second and third are deeper than in free fall."""
import numpy as np

from plunge.results import gather
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.scenes import solveScene, spacings
from plunge.studies.signals import Signal, rms
from plunge.studies.study import Quantity, Run, Study

D, GRAVITY, SPEED = 0.11, 9.81, 2.955
TABLE = reference("GreenhowLin1983", "penetration")
PUBLISHED = {kind: Signal(TABLE["T"][TABLE["kind"] == kind], TABLE["penetration"][TABLE["kind"] == kind])
             for kind in ("experiment", "BEM", "SPH")}
EXPERIMENT, BEM, SPH = PUBLISHED.values()
FALL = np.linspace(0, 0.6)
FREE = Signal(FALL, SPEED/np.sqrt(GRAVITY*D)*FALL + FALL**2/2)


def computed(done) -> Signal:
    track = gather(done.path)["trajectory"]
    height = track["y_m" if done.run.method == "particles" else "z_m"]
    return Signal(track["time_s"]*np.sqrt(GRAVITY/D), (height[0] - height)/D)


study = Study(
    title="A cylinder sinks into water as boundary elements and the experiment have it",
    runs=spacings("fallingCylinder", {0.0055: ("full",), 0.00275: ("full",)})
    + spacings("fallingCylinder", {0.011: ("quick",)}, {"system/controlDict": "endTime 0.17;"})
    + [Run("fallingCylinder", "meshes", "", level) for level in ("fast 0.7", "fast", "fast 1.4")]
    + [Run("fallingCylinder", "meshes", "", "fast 0.5", ("quick",), given={"options": ["-set", "duration=0.06"]})],
    solve=solveScene, sources=("src/smoothedParticles", "src/freeSurfaceFlow", "src/rigidBody", "applications/solvers"),
    quantities=[
        Quantity("penetration less that of the BEM, rms over D", "1", lambda done: rms(computed(done).less(BEM)), 0, tolerance=rms(SPH.less(BEM))),
        Quantity("penetration less the measured, rms over D", "1", lambda done: rms(computed(done).less(EXPERIMENT)), 0,
                 tolerance=rms(BEM.less(EXPERIMENT))),
        *(Quantity(f"penetration over D at T = {T:g}", "1", lambda done, T=T: float(computed(done).at(T)), float(BEM.at(T)),
                   judged=lambda run: False, converges=True) for T in (0.5, 1.0, 1.5))],
    headlines=["penetration less that of the BEM, rms over D"],
    figure=lambda done, file: draw(file, [({"xlabel": "T = t sqrt(g/D)", "ylabel": "penetration/D", "xlim": (0, 2.1), "ylim": (0, 3)}, {
        "Greenhow and Lin 1983": EXPERIMENT, "boundary elements": BEM, "SPH of Sun et al. 2018": SPH, "free fall": FREE},
        {f"{each.run.method}, {each.run.resolution}": computed(each) for each in done})]))
