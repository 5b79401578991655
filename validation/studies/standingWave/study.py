# SPDX-License-Identifier: GPL-3.0-or-later
"""A small standing wave on meshes against the exact solution of Prosperetti 1981, which holds for fluids of any densities that have one
kinematic viscosity: water and air, and the same a hundred times as viscous; the paper's liquid and air of Titan, whose gas has 0.8 of the
liquid's kinematic viscosity anyway, air has fifteen times water's; and a wave of surface tension alone. The last is that of TwoPhaseFlow's
test suite, beside whose errors ours stand, with the curvature from the gradient of the volume fraction, which is plungeFoam's, too.

The amplitude is a hundredth of the length; what the linear solution leaves out is (k a)^2 = 0.4 %. Frequency and decay may be off as those of
the particles' wave in study particleExact, 2 and 10 %; the other two waves lose a few per cent in three periods, less than the
error."""
import numpy as np

from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.signals import Signal, rms
from plunge.studies.standingWave import Wave, decay, frequency, history, solve
from plunge.studies.study import Quantity, Run, Study, only, twin

WATER = {"length": 0.1, "liquidDensity": 1000, "gasDensity": 1.2, "surfaceTension": 0.072, "gravity": 9.81, "periods": 3}
# omega t = 25; gravity does nothing between fluids as heavy as each other
CAPILLARY, VISCOUS = "capillary", "water, viscous"
WAVES = {"water": Wave(**WATER, nu=1e-6), VISCOUS: Wave(**WATER, nu=1e-4),
         "Titan": Wave(0.1, 664, 5.353, 0.001014/664, 0.0311, 1.35, 3),
         CAPILLARY: Wave(3e-3, 1, 1, 1e-3, 1, 9.81, 25/(2*np.pi))}
FLUIDS = {"Titan": "liquid astraeusPaper; gas titanAir;"}
CELLS = {"water": (32, 64, 128), VISCOUS: (16, 32, 64), "Titan": (16, 32, 64), CAPILLARY: (16, 32, 64)}
PEER = reference("TwoPhaseFlow", "sinWave")


def computed(done) -> Signal:
    return history(done.path, WAVES[done.run.variant], done.run.given["cells"])


def exact(done) -> Signal:
    time = computed(done).time
    return Signal(time, WAVES[done.run.variant].amplitude(time))


def error(done) -> float:
    """Of the amplitude, rms over the first [%]."""
    return 100*rms(computed(done).value - exact(done).value)


def order(done):
    """Of the error, from the mesh of half as many cells."""
    length = WAVES[done.run.variant].length
    return twin(lambda fine, coarse: float(np.log2(error(coarse)/error(fine))), resolution=f"{2*length/done.run.given['cells']:g} m")(done)


def overPeer(done):
    """Error over that of the peer with the same cells."""
    row = PEER[(PEER["cells"] == done.run.given["cells"]) & (PEER["curvature"] == "gradAlpha")]
    wave = WAVES[done.run.variant]
    return error(done)/(100*float(row["err"][0])*wave.length/np.sqrt(0.01*wave.length)) if row.size else None


def panel(variant: str, done):
    of = [each for each in done if each.run.variant == variant]
    return ({"title": variant, "xlabel": "time [s]", "ylabel": "amplitude over the first"}, {"exact": exact(of[-1])},
            {f"{each.run.given['cells']} cells": computed(each) for each in of})


study = Study(
    title="A small standing wave has the exact frequency and decay",
    runs=[Run("standingWave", "meshes", variant, f"{WAVES[variant].length/cells:g} m", ("quick", "full") if cells == CELLS[variant][0] else ("full",),
              given={"cells": cells, "fluids": FLUIDS.get(variant, "liquid water; gas earthAir;")}) for variant in WAVES for cells in CELLS[variant]],
    solve=lambda run, path: solve(run, path, WAVES[run.variant], run.given["cells"]),
    sources=("src/freeSurfaceFlow", "applications/solvers/plungeFoam", "cases/stillTank"),
    quantities=[
        Quantity("amplitude less the exact, rms over the first", "%", error),
        Quantity("order of that error", "1", order),
        Quantity("frequency over the exact", "1", lambda done: frequency(computed(done))/frequency(exact(done)), 1, tolerance=0.02, converges=True),
        Quantity("decay over the exact", "1", only(lambda done: decay(computed(done))/decay(exact(done)), lambda run: run.variant in (VISCOUS, CAPILLARY)), 1,
                 tolerance=0.1, converges=True),
        Quantity("decay less the exact, over the frequency", "1", lambda done: (decay(computed(done)) - decay(exact(done)))/frequency(exact(done))),
        Quantity("rms error over that of TwoPhaseFlow with gradAlpha", "1", only(overPeer, lambda run: run.variant == CAPILLARY), most=1)],
    headlines=["amplitude less the exact, rms over the first", "frequency over the exact"],
    figure=lambda done, file: draw(file, [panel(variant, done) for variant in WAVES if any(each.run.variant == variant for each in done)], 2))
