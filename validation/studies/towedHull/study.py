# SPDX-License-Identifier: GPL-3.0-or-later
"""SUBOFF's bare hull in a stream without a surface, axisymmetric: its drag and its pressures. Variants are models of the boundary layer and speeds.

Drag: Liu and Huang 1998, five speeds, whose scatter they do not give; 5 % with wall functions, 10 % with the friction line, which knows no form.
Pressure coefficients: Huang et al. 1992, means of the lower, port and starboard meridians, away from the sail and ahead of the planes, within
two standard deviations of a tap, pooled over the stations. That hull has a sail, and the tunnel has walls: beside them stands the ideal
flow about the bare hull, which ahead of the stern is that of a thin layer, too, within the same."""
import numpy as np

from plunge.scene import read as readScene
from plunge.studies.fixedBody import drag, pressure, solve
from plunge.studies.idealFlow import pressure as idealPressure
from plunge.studies.pictures import draw
from plunge.studies.references import reference
from plunge.studies.signals import Signal
from plunge.studies.study import STUDIES, Quantity, Run, Study

HULL = STUDIES / "towedHull/hull"
TOWED = {f"{row['V_m_s']:.4g} m/s": (float(row["V_m_s"]), float(row["R_N"])) for row in reference("Suboff", "resistance")}
ALLOWED = {"wallFunction": 0.05, "frictionLine": 0.1}
FIRST = next(iter(TOWED))                       # its Reynolds number is that of the tunnel within a tenth
# Along a round nose the cells are those of the tier standard, across the layer those of fast
MESH = ["-tier", "standard", "-set", "tier.layers=18", "-set", "tier.maxDeltaT=0.005"]
LEVELS = {"standard 0.7": ("full",), "standard": ("full",), "standard 1.4": ("full",)}

TAPS = reference("Suboff", "pressure")
TAPS = TAPS[(TAPS["x_over_L"] < 0.85) & (TAPS["meridian"] != "upper")]
STATIONS = {float(x): TAPS["Cp"][TAPS["x_over_L"] == x] for x in np.unique(TAPS["x_over_L"])}
SCATTER = 2*float(np.sqrt(np.mean([np.var(taps, ddof=1) for taps in STATIONS.values()])))
AHEAD = 0.6                                     # x/L, of the stern
IDEAL = idealPressure(readScene(HULL).shape.curve)


def run(layer: str, speed: str, level: str, tiers: tuple[str, ...] = ("full",)) -> Run:
    return Run("hull", "meshes", f"{layer}, {speed}", level, tiers)


def towed(done) -> tuple[float, float]:
    """Speed [m/s] and resistance [N]."""
    return TOWED[done.run.variant.split(", ")[1]]


def make(run: Run, path) -> None:
    layer, speed = run.variant.split(", ")
    solve(path, ["-boundaryLayer", layer, *MESH, "-resolution", run.grade[1], "-set", f"entry.speed={TOWED[speed][0]}"], HULL)


def force(done) -> float:
    return drag(done.path).friction + drag(done.path).form


def coefficient(x: float):
    """Of the pressure there, at the first speed."""
    return lambda done: float(pressure(done.path).at(np.array([x]))[0]) if done.run.variant.endswith(FIRST) else None


def ofFirst(done, file) -> None:
    """The drag at all speeds, and the pressures at the first one, at the middle resolution."""
    shown = [each for each in done if each.run.resolution == "standard"]
    drags = {layer: Signal(*np.array(sorted((towed(each)[0], force(each)) for each in shown if each.run.variant.startswith(layer))).T) for layer in ALLOWED}
    draw(file, [({"xlabel": "speed [m/s]", "ylabel": "drag [N]"}, {"measured": Signal(*np.array(list(TOWED.values())).T)}, drags),
                ({"xlabel": "x/L", "ylabel": "pressure coefficient", "ylim": (-0.35, 0.35)},
                 {"measured, away from the sail": Signal(TAPS["x_over_L"], TAPS["Cp"]), "ideal flow": IDEAL},
                 {each.run.variant: pressure(each.path) for each in shown if each.run.variant.endswith(FIRST)})], 2)


study = Study(
    title="The drag of a towed hull, SUBOFF's, and its pressures are the measured ones",
    runs=[*(run(layer, FIRST, level, tiers) for layer in ALLOWED for level, tiers in LEVELS.items()),
          *(run(layer, speed, "standard") for layer in ALLOWED for speed in TOWED if speed != FIRST),
          *(run(layer, FIRST, "standard 0.5", ("quick",)) for layer in ALLOWED)],
    solve=make, sources=("src/boundaryLayer", "src/freeSurfaceFlow", "applications/solvers/plungeFoam", "validation/studies/towedHull/hull"),
    quantities=[
        Quantity("drag", "N", force, lambda done: towed(done)[1], tolerance=lambda done: ALLOWED[done.run.variant.split(",")[0]]*towed(done)[1], converges=True),
        Quantity("drag over the measured", "1", lambda done: force(done)/towed(done)[1]),
        Quantity("friction", "N", lambda done: drag(done.path).friction),
        Quantity("pressure drag", "N", lambda done: drag(done.path).form, converges=True),
        Quantity("change of the drag over the last quarter length of the stream", "%", lambda done: drag(done.path).drift),
        *(Quantity(f"pressure coefficient at x/L = {x:.2g}", "1", coefficient(x), float(taps.mean()), SCATTER) for x, taps in STATIONS.items()),
        *(Quantity(f"pressure coefficient at x/L = {x:.2g}, of ideal flow", "1", coefficient(x), float(IDEAL.at(np.array([x]))[0]), tolerance=SCATTER)
          for x in STATIONS if x < AHEAD)],
    headlines=["drag"], figure=ofFirst)
