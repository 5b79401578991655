# SPDX-License-Identifier: GPL-3.0-or-later
"""What accuracy costs: one question over the whole ladder of methods, tiers and settings, with the error and the CPU time of each rung, and those
rungs beside which no other is both cheaper and better.

The dive into the paper's liquid, to full immersion: largest load along the axis (mean of 1 ms), velocity lost, pitch. Its reference is what three
resolutions of the default method at the Courant number 1 extrapolate to; its uncertainty is the grid convergence index of the finest. The cone of 45 degrees that
falls from 0.5 m: its reference is the mean of the trials, with two standard deviations. The bore on Yeh and Petroff's column: impulse and plateau of the force,
against the measured ones, whose digitisations differ by 10 %. The first second of the dive, in which the body turns: depth, against what three
resolutions of the default method extrapolate to. Errors are in percent of the reference; nothing is judged. A
rung that differs by one setting is named by it; what is left out (boundary layer) is such a setting, too. The fluids are isothermal: their properties are
found once, before the first step, and cost the same by table and by equation. The rungs of the full tier take half an hour of one core, those of the tier
`night` (finer meshes, wall functions, particles at their own spacing and in double precision, two ranks) some hours more; killed, the study goes on where it was."""
from __future__ import annotations

import csv
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from plunge.estimate import ERRORS
from plunge.results import read_numbers
from plunge.studies.dives import Dive
from plunge.studies.gridConvergence import SAFETY, gridConvergence
from plunge.studies.particleRuns import CONTROL
from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import markdown
from plunge.studies.scenes import solveScene
from plunge.studies.study import Done, Quantity, Run, Study, module

CONES = module("coneEntry")
CONE = "45 deg 0.5 m"
BORE = module("yehPetroff")
DEEP, DEEP_SERIES = "one second", ("fast 0.7", "fast 0.5", "fast 0.35")
SOLUTION, SCHEMES = "system/fvSolution", "system/fvSchemes"
SMALL_STEPS = {CONTROL: "maxCo 1; maxAlphaCo 0.5; maxDeltaT 2e-4;"}
REFERENCE, SERIES = "following, Courant 1", ("fast", "fast 0.7", "fast 0.5")
# Of the dive by meshes at the tier fast: options of plungeCase, and what differs in the case
SETTINGS = {
    "following": ((), {}),
    "single": (("-mesh", "single"), {}),
    "overset": (("-mesh", "overset"), {}),
    REFERENCE: ((), SMALL_STEPS),
    "following, Courant 1, one correction": ((), {**SMALL_STEPS, SOLUTION: "PIMPLE { nCorrectors 1; }"}),
    "following, Courant 4": ((), {CONTROL: "maxCo 4; maxAlphaCo 2; maxDeltaT 8e-4;", SOLUTION: 'solvers { "alpha.liquid.*" { nAlphaSubCycles 4; } }'}),
    "following, three corrections": ((), {SOLUTION: "PIMPLE { nCorrectors 3; }"}),
    "following, Euler": ((), {SCHEMES: "ddtSchemes { default Euler; }"}),
    "following, no boundary layer": (("-boundaryLayer", "none"), {}),
    "following, wall functions": (("-boundaryLayer", "wallFunction"), {}),
    "single, isoAdvector": (("-mesh", "single"), {"constant/sceneProperties": "interface isoAdvector;"}),
    "following, two ranks": (("-np", "2"), {}),
}
LEVELS = {"following": ("fast 0.5", "fast 0.7", "fast"), "single": ("fast 0.5", "fast 0.7", "fast"), REFERENCE: SERIES,
          **{variant: () for variant in ("following, wall functions", "following, two ranks")}}
NIGHT = {"following": ("fast 1.4", "standard"), "single": ("fast 1.4", "standard"), "following, wall functions": ("fast",), "following, two ranks": ("fast",)}
dive = lru_cache(maxsize=None)(Dive)


def rungs() -> list[Run]:
    cone = CONES.scene(CONE)
    found = [Run("fallingCone", "slenderBody", CONE, "", ("full", "quick"), given={"options": cone})]
    found += [Run("fallingCone", "meshes", CONE, level, ("full", "quick") if level == "fast 0.5" else ("full",), given={"options": cone})
              for level in ("fast 0.5", "fast 0.7", "fast", "fast 1.4")]
    found += [Run("gannetPlunge", "slenderBody", "strips", "", ("full", "quick"))]
    # At 25 m/s it would travel 25 of its lengths
    second = {"options": ["-set", "travel=25.1", "-set", "frames=1"]}
    found += [Run("gannetPlunge", "slenderBody", DEEP, given=second), *(Run("gannetPlunge", "meshes", DEEP, level, given=second) for level in DEEP_SERIES)]
    for variant, (options, changes) in SETTINGS.items():
        given = {"options": [*options, "-set", "frames=1"], "changes": changes}
        for tier, levels in (("full", LEVELS.get(variant, ("fast",))), ("night", NIGHT.get(variant, ()))):
            found += [Run("gannetPlunge", "meshes", variant, level, (tier,), 1 + ("-np" in options), given) for level in levels]
    found += [Run("gannetPlunge", "particles", precision, level, (tier,), 1, {
        "options": ["-set", "frames=1"], "changes": {"constant/particleProperties": f"precision {precision};"}})
        for precision, level, tier in (("single", "fast 0.7", "full"), ("single", "fast", "night"), ("double", "fast", "night"))]
    found += [Run("fallingCone", "particles", CONE, level, ("full",), given={"options": cone}) for level in ("fast", "fast 1.4")]
    found += [replace(run, tiers=(tier,)) for level, tier in (("0.02 m", "full"), ("0.015 m", "full"), ("0.01 m", "night"))
              for run in BORE.study.runs if (run.method, run.variant, run.resolution) == ("particles", "", level)]
    return [*found, *(Run("yehPetroff", "meshes", BORE.SLIP, level, (tier,)) for level, tier in (("0.04 m", "full"), ("0.03 m", "full"), ("0.02 m", "night")))]


def solve(run: Run, path: Path) -> None:
    (BORE.study.solve if run.scene == "yehPetroff" else solveScene)(run, path)


def summary(name: str):
    return lambda done: read_numbers(done.path/"results/summary.csv")[name][0]


def question(run: Run) -> str:
    """That a run answers."""
    return DEEP if run.variant == DEEP else run.scene


ANSWERS = {
    "largest axial load": ("N", "gannetPlunge", lambda done: float(dive(done.path).mean["axial"].max())),
    "velocity lost at full immersion": ("m/s", "gannetPlunge", summary("velocity lost at full immersion")),
    "pitch change at full immersion": ("deg", "gannetPlunge", summary("pitch change at full immersion")),
    "depth after one second": ("m", DEEP, lambda done: float(np.interp(1, done.track["time_s"] - done.track["time_s"][np.argmax(done.track["penetration_m"] >= 0)],
                                                                       done.track["penetration_m"]))),
    "peak of C": ("1", "fallingCone", lambda done: float(CONES.peak(done)[1])),
    **{name: (BORE.FORCE[name][0], "yehPetroff", lambda done, of=BORE.FORCE[name][1]: float(of(BORE.force(done)))) for name in ("force on the plateau", "impulse")},
}


def reference(done: Done, name: str) -> tuple[float, float] | None:
    """And its uncertainty."""
    if done.run.scene == "fallingCone":
        return float(CONES.TRIALS[CONE]["Cpeak_mean"]), 2*float(CONES.TRIALS[CONE]["Cpeak_std"])
    if done.run.scene == "yehPetroff":
        _, _, value, share = BORE.FORCE[name]
        return value, share*value
    variant, levels = (DEEP, DEEP_SERIES) if done.run.variant == DEEP else (REFERENCE, SERIES)
    series = [other for run in (Run("gannetPlunge", "meshes", variant, level) for level in levels) if (other := done.others.get(run.key))]
    if len(series) < len(levels):
        return None
    found = gridConvergence([each.run.size for each in series], [ANSWERS[name][2](each) for each in series], 1, 2)
    value = ANSWERS[name][2](series[0])
    return found.extrapolated, SAFETY*abs(value - found.extrapolated)


def error(name: str):
    def of(done: Done) -> float | None:
        _, asked, value = ANSWERS[name]
        known = reference(done, name) if question(done.run) == asked else None
        return 100*abs(value(done)/known[0] - 1) if known else None
    return of


def sure(done: Done, name: str) -> float:
    """The reference's uncertainty over it."""
    value, uncertainty = reference(done, name)
    return uncertainty/abs(value)


def front(points: list[tuple[float, float, str]]) -> list[tuple[float, float, str]]:
    """Those (cost, error, name) beside which no other is both cheaper and better."""
    return [each for each in sorted(points) if not any(other[0] <= each[0] and other[1] < each[1] for other in points)]


def points(done, name: str) -> list[tuple[float, float, str]]:
    return [(each.cpu, value, " ".join(filter(None, (each.run.method if each.run.method != "meshes" else "",
                                                     each.run.variant if each.run.scene != "fallingCone" and each.run.variant != DEEP else "", each.run.resolution))))
            for each in done if each.cpu and (value := error(name)(each)) is not None]


def draw(done, file) -> None:
    known = {name: found for name in ANSWERS if (found := points(done, name))}
    picture, axes = pyplot.subplots(len(known), 1, figsize=(9, 4.6*len(known)), layout="constrained", squeeze=False)
    for axis, (name, of) in zip(axes.flat, known.items()):
        best = front(of)
        axis.loglog([cost for cost, *_ in of], [off for _, off, _ in of], "o", color="0.6")
        axis.loglog([cost for cost, *_ in best], [off for _, off, _ in best], "o-", color="C3", label="front")
        for cost, off, label in of:
            axis.annotate(label, (cost, off), fontsize=6, xytext=(3, 3), textcoords="offset points")
        axis.axhline(next(100*sure(each, name) for each in done if question(each.run) == ANSWERS[name][1] and reference(each, name)), color="0.5", linestyle=":", label="uncertainty of the reference")
        axis.set(xlabel="CPU time [s]", ylabel="error [%]", title=f"{ANSWERS[name][1]}: {name}")
        axis.legend(fontsize="small")
    picture.savefig(file, dpi=90)
    pyplot.close(picture)


def answers(rows: list[dict[str, str]]) -> list[str]:
    """If so much CPU time is to be had: which rung, and what error; as Markdown."""
    lines = []
    for name, (_, asked, _) in ANSWERS.items():
        of = [(float(row["cpu_s"]), float(row["value"]), ", ".join(filter(None, (row["method"], row["variant"] if asked not in ("fallingCone", DEEP) else "", row["resolution"]))))
              for row in rows if row["quantity"] == f"error of {name}" and row["cpu_s"]]
        lines += [[f"{asked if asked != DEEP else 'gannetPlunge'}: {name}", f"{cost:.2g} s" if cost < 60 else f"{cost/60:.2g} min", rung, f"{off:.2g} %"] for cost, off, rung in front(of)]
    return ["The front: with so much CPU time, this rung, and this error.", "", *markdown(["question", "CPU time", "rung", "error"], lines)]


def writeErrors(done, rows, clean: bool) -> None:
    """What plungeCase -estimate quotes."""
    if not clean:
        return
    with ERRORS.open("w", newline="") as file:
        file.write("# Written by validation/run tradeoff, which says what they are: errors in %, or the reference's uncertainty where that is larger\n")
        out = csv.writer(file, lineterminator="\n")
        out.writerow(("scene", "method", "variant", "resolution", "quantity", "error_percent"))
        for each in done:
            for name in ANSWERS:
                if (value := error(name)(each)) is not None:
                    most = max(value, 100*sure(each, name))
                    out.writerow((each.run.scene, each.run.method, each.run.variant if each.run.scene == "gannetPlunge" else "", each.run.resolution, name, f"{most:.3g}"))


study = Study(
    title="What accuracy costs: the whole ladder, from strips to fine meshes", runs=rungs(), solve=solve, after=writeErrors,
    sources=("src/freeSurfaceFlow", "src/oversetMethods", "src/rigidBody", "src/smoothedParticles", "src/slenderBody", "applications/solvers", "etc/methods/tiers"),
    quantities=[
        *(Quantity(name, unit, lambda done, a=asked, of=of: of(done) if question(done.run) == a else None) for name, (unit, asked, of) in ANSWERS.items()),
        *(Quantity(f"error of {name}", "%", error(name)) for name in ANSWERS),
        *(Quantity(f"uncertainty of the reference of {name}", "%", lambda done, n=name, of=of: (
            100*sure(done, n) if (done.run.variant, done.run.resolution) == of and reference(done, n) else None))
          for name, (_, asked, _) in ANSWERS.items() for of in [(REFERENCE, SERIES[0]) if asked != DEEP else (DEEP, DEEP_SERIES[0])] if asked in ("gannetPlunge", DEEP))],
    headlines=["error of velocity lost at full immersion", "error of peak of C"], figure=draw)
