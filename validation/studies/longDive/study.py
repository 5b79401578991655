# SPDX-License-Identifier: GPL-3.0-or-later
"""Dives of ten body lengths, on a background that follows the body, and on one that is refined along the whole path.

Along its axis the body stays on its path, and both backgrounds can hold it: the speed should be the same within 1 % of that of the impact, and with the
background that follows each length should cost as much as the one before. Free, without a tail, the body turns across its path; its depth and pitch at the end
stand beside those that slenderBody has for the same dive. Along walls that slip, as under a friction line, the flow across the body does not separate, so these
dives are made with wall functions, too."""
import numpy as np

from plunge.results import parameters
from plunge.studies.dives import Dive, Difference
from plunge.studies.pictures import draw
from plunge.studies.scenes import solveScene
from plunge.studies.signals import Signal
from plunge.studies.solverLogs import readLog
from plunge.studies.study import Quantity, Run, Study, only, twin

FOLLOWING, STANDING = "along the axis, following", "along the axis, corridor"
AXIAL = ["-set", "body.freedom=axial", "-set", "frames=2"]
LENGTHS, SHORT = 10.2, 1.6


def axial(variant: str, mesh: str, resolution: str, tier: str, travel: float) -> Run:
    return Run("gannetPlunge", "meshes", variant, resolution, (tier,),
               given={"options": [*AXIAL, "-mesh", mesh, "-set", f"travel={travel}"]})


def free(method: str, fluids: str, layer: str = "", resolution: str = "") -> Run:
    return Run("gannetPlunge", method, f"{fluids}, free" + (f", {layer}" if layer else ""), resolution, ("full",),
               given={"options": ["-fluids", fluids, *(("-boundaryLayer", layer) if layer else ()), "-set", f"travel={LENGTHS}", "-set", "frames=20"]})


def isAxial(run: Run) -> bool:
    return run.variant in (FOLLOWING, STANDING)


def atEnd(column: str):
    return lambda done: float(done.track[column][-1])


def turned(done, angle: float) -> float:
    pitch = done.track["pitch_deg"]
    found = np.flatnonzero(np.abs(pitch - pitch[0]) > angle)
    return float(done.track["time_s"][found[0]]) if found.size else float("nan")


def cost(done) -> float | None:
    """CPU time of the last length that the nose travels in the liquid over that of the third, or of the last but one where there are fewer."""
    table, steps = done.track, readLog(done.path / "log.plungeFoam")
    used = np.array([step.cpu for step in steps])
    travelled = np.interp([step.time for step in steps], table["time_s"], table["penetration_m"])/float(parameters(done.path)["bodyLength"])
    last = np.floor(travelled[-1])
    if last < 4:
        return None
    of = [float(np.interp(length, travelled, used) - np.interp(length - 1, travelled, used)) for length in (3, last)]
    return of[1]/of[0]


study = Study(
    title="A background that follows the body costs the same at any depth, and gives the same dive",
    runs=[*(axial(variant, mesh, *of) for of in (("fast 0.5", "full", LENGTHS), ("fast 0.4", "quick", SHORT))
            for variant, mesh in ((FOLLOWING, "following"), (STANDING, "overset"))),
          axial(FOLLOWING, "following", "fast", "full", LENGTHS),
          *(free("slenderBody", fluids) for fluids in ("titan", "water")), free("meshes", "titan", "", "fast"),
          *(free("meshes", fluids, "wallFunction", "fast 0.5") for fluids in ("titan", "water"))],
    solve=solveScene, sources=("src/freeSurfaceFlow", "src/oversetMethods", "src/rigidBody", "applications/solvers/plungeFoam"),
    quantities=[
        Quantity("speed, largest difference over the impact speed", "%",
                 twin(lambda done, other: float(Difference(Dive(done.path), Dive(other.path)).speed.max()), lambda run: run.variant == FOLLOWING, variant=STANDING),
                 0, tolerance=1),
        Quantity("CPU time over that on the corridor", "1", twin(lambda done, other: done.cpu/other.cpu, lambda run: run.variant == FOLLOWING, variant=STANDING)),
        Quantity("CPU time of the last body length over that of the third", "1", only(cost, lambda run: run.variant == FOLLOWING)),
        Quantity("liquid's volume, largest error over the body's", "%", only(lambda done: Dive(done.path).ledger(), lambda run: run.method == "meshes"), 0,
                 tolerance=0.01, judged=lambda run: run.resolution == "fast"),
        *(Quantity(f"time until the axis has turned by {angle} deg", "s", only(lambda done, a=angle: turned(done, a), lambda run: not isAxial(run))) for angle in (10, 45)),
        Quantity("deepest point", "m", only(lambda done: float(done.track["penetration_m"].max()), lambda run: not isAxial(run))),
        Quantity("penetration at the end", "m", atEnd("penetration_m")), Quantity("speed at the end", "m/s", atEnd("speed_m_s")),
        Quantity("pitch at the end", "deg", only(atEnd("pitch_deg"), lambda run: not isAxial(run)))],
    headlines=["speed, largest difference over the impact speed", "CPU time of the last body length over that of the third"],
    figure=lambda done, file: draw(file, [({"xlabel": "time [ms]", "ylabel": label}, {}, {
        f"{each.run.variant}, {each.run.method}": Signal(1e3*each.track["time_s"], each.track[column])
        for each in done}) for column, label in (("speed_m_s", "speed [m/s]"), ("pitch_deg", "pitch [deg]"))], 2))
