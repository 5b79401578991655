# SPDX-License-Identifier: GPL-3.0-or-later
"""Wedges that enter water, in the plane, on meshes: at constant speed without gravity against the similarity solution (references/ZhaoFaltinsen1993;
variants are deadrise angles), and falling freely with the two masses that its sources give (references/Yettou2006).

The force at constant speed is that of rho V^3 t: of its slope from a third to two thirds of the time at which the spray reaches the wedge's edge; the pressure
is the largest at that last time. Judged: 5 %, and for the falling wedge the distance of the boundary elements from the experiment, rms."""
import numpy as np

from plunge.studies import REPOSITORY
from plunge.studies.foamFields import readCells, times
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.scenes import prepare, solve
from plunge.studies.signals import Signal, rms
from plunge.studies.study import Quantity, Run, Study, only

FOLDER = REPOSITORY / "validation/studies/wedgeEntry"
SPEED, HALF_WIDTH, RHO = 10, 0.5, 998.2
EXACT = {f"deadrise {row['deadrise_deg']} deg": row for row in reference("ZhaoFaltinsen1993", "similarity")}
TABLE = reference("Yettou2006", "speed")
FALL = {kind: Signal(1e-3*TABLE["t_ms"][TABLE["kind"] == kind], TABLE["speed_m_s"][TABLE["kind"] == kind])
        for kind in ("experiment", "BEM", "SPH")}
MASSES = {"94 kg/m": 94, "78 kg/m": 78}
LEVELS = ("fast", "fast 1.4", "fast 2")


def wetted(variant: str) -> float:
    """When the spray's root reaches the edge by Wagner's pile-up, the earliest that it can [s]."""
    return float(HALF_WIDTH*np.tan(np.radians(EXACT[variant]["deadrise_deg"]))/(np.pi/2*SPEED))


def falls(run: Run) -> bool:
    return run.variant in MASSES


def options(run: Run) -> list[str]:
    if falls(run):
        return ["-set", f"body.mass={MASSES[run.variant]}"]
    return ["-set", f"body.shape.halfAngle={90 - EXACT[run.variant]['deadrise_deg']}", "-set", f"duration={0.67*wetted(run.variant):.6g}"]


def force(done) -> Signal:
    of = done.track
    return Signal(of["time_s"][1:], (of["Fpz_N"] + of["Fvz_N"])[1:]/(RHO*SPEED**3))


def slope(done) -> float:
    end = wetted(done.run.variant)
    return float(np.polyfit(*force(done).during(end/3, 2*end/3), 1)[0])


def pressure(done) -> float:
    return float(readCells(done.path / times(done.path)[-1] / "p").max()/(0.5*RHO*SPEED**2))


def speed(done) -> Signal:
    of = done.track
    return Signal(of["time_s"], -of["vz_m_s"])


study = Study(
    title="Wedges that enter water have the forces of the similarity solution and slow down as measured",
    runs=[Run("wedgeEntry", "meshes", variant, level, ("full", level)) for variant in (*EXACT, *MASSES) for level in LEVELS]
    + [Run("wedgeEntry", "meshes", variant, "fast 0.7", ("quick",)) for variant in ("deadrise 30 deg", "94 kg/m")],
    solve=lambda run, path: (prepare(run, path, options(run), {"system/controlDict": "writeFormat ascii;"},
                                     FOLDER / ("fallingWedge" if falls(run) else "wedge")), solve(path)),
    sources=("src/freeSurfaceFlow", "src/rigidBody", "applications/solvers/plungeFoam", "validation/studies/wedgeEntry"),
    quantities=[
        Quantity("force over rho V^3 t", "1", only(slope, lambda run: not falls(run)), lambda done: EXACT[done.run.variant]["force"],
                 tolerance=lambda done: 0.05*EXACT[done.run.variant]["force"], converges=True),
        Quantity("largest pressure over rho V^2/2", "1", only(pressure, lambda run: not falls(run)), lambda done: EXACT[done.run.variant]["Cp_max"],
                 tolerance=lambda done: 0.05*EXACT[done.run.variant]["Cp_max"], converges=True),
        Quantity("speed less the measured, rms", "m/s", only(lambda done: rms(speed(done).less(FALL["experiment"])), falls), 0,
                 tolerance=rms(FALL["BEM"].less(FALL["experiment"]))),
        Quantity("speed less that of the boundary elements, rms", "m/s", only(lambda done: rms(speed(done).less(FALL["BEM"])), falls), 0,
                 tolerance=rms(FALL["SPH"].less(FALL["BEM"])))],
    headlines=["force over rho V^3 t"],
    figure=lambda done, file: draw(file, [
        *(({"title": variant, "xlabel": "time [s]", "ylabel": "F/(rho V^3) [s]"}, {"similarity solution": Signal(
            np.array([0, wetted(variant)]), EXACT[variant]["force"]*np.array([0, wetted(variant)]))},
            {each.run.resolution: force(each) for each in done if each.run.variant == variant}) for variant in EXACT),
        ({"xlabel": "time [s]", "ylabel": "speed [m/s]"}, FALL, {f"{each.run.variant}, {each.run.resolution}": speed(each) for each in done
                                                                if falls(each.run)})], 2))
