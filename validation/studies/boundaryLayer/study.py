# SPDX-License-Identifier: GPL-3.0-or-later
"""The boundary layer's models on the dive's body against friction lines. Variants are fluids and models, with the Reynolds number of
transition where it is not the default, 5e5.

The body, fixed in a stream: friction within a tenth of the line's, friction and form drag within a tenth of the line's times Hoerner's form
factor of a slender body of revolution, 1 + 1.5 (d/l)^1.5 + 7 (d/l)^3 (Hoerner, Fluid-Dynamic Drag, 1965). A tenth is what the lines differ
by, and such factors. Cost: CPU time of a step of the dive's beginning over that of one without a boundary layer on the same mesh."""
from pathlib import Path

from plunge.foamDictionary import read
from plunge.shapes import NACA
from plunge.studies.fixedBody import drag, solve as solveBody
from plunge.studies.friction import line, plateFriction
from plunge.studies.scenes import solveScene
from plunge.studies.solverLogs import perStep, readLog
from plunge.studies.study import Done, Quantity, Run, Study, only, twin

LINE, WALL, NONE, OFF = "frictionLine", "wallFunction", "none", ", switched off"
SLIP = {"constant/sceneProperties": "boundaryLayer none;", "constant/turbulenceProperties": "simulationType laminar;"}
# Model and transition, of the bodies in a stream
BODIES = {f"{fluids}, {layer}" + (f", transition {at:g}" if at != 5e5 else ""): (fluids, layer, at) for fluids, layer, at in (
    *((fluids, layer, 5e5) for layer in (WALL, LINE) for fluids in ("titan", "water")),
    ("titan", LINE, 1e6), ("titan", LINE, 3e6), ("titan", NONE, 5e5))}


def solve(run: Run, path: Path) -> None:
    if run.variant not in BODIES:
        return solveScene(run, path)
    fluids, layer, transition = BODIES[run.variant]
    tier, factor = run.grade
    solveBody(path, ["-fluids", fluids, "-tier", tier, "-resolution", factor, "-boundaryLayer", layer, "-set", f"transitionReynolds={transition:g}"])


def hasLayer(run: Run) -> bool:
    return run.variant in BODIES and BODIES[run.variant][1] != NONE


def expected(done: Done, form: bool) -> float:
    """Friction that the line gives, ITTC's, of ships, where the layer is turbulent almost throughout, else the one that knows a laminar
    run; or that with the form factor."""
    given, transition = read(done.path / "system/plungeGenerated"), BODIES[done.run.variant][2]
    of = NACA(given["bodyLength"], given["thicknessRatio"])
    reynolds = given["liquidDensity"]*given["speed"]*of.length/given["liquidViscosity"]
    unit = given["liquidDensity"]/2*given["speed"]**2*of.wetted_area
    slender = of.slenderness if form else 0
    return (1 + 1.5*slender**1.5 + 7*slender**3)*unit*(line("ITTC57", reynolds) if transition == 5e5 else plateFriction(reynolds, transition))


def cost(done: Done) -> float:
    steps = readLog(done.path / "log.plungeFoam")
    return perStep(steps, len(steps)//3 + 1)


study = Study(
    title="Friction and drag of the dive's body are those of the friction lines",
    runs=[*(Run("gannetPlunge", "meshes", name, "fast") for name in BODIES), Run("gannetPlunge", "meshes", f"titan, {LINE}", "fast 0.5", ("quick",)),
          *(Run("gannetPlunge", "meshes", f"{fluids}, {LINE}", "standard") for fluids in ("titan", "water")),
          *(Run("gannetPlunge", "meshes", f"first steps, {layer}{off}", "fast", given={"changes": changes, "options": [
              "-boundaryLayer", layer, "-set", "travel=0.1", "-set", "frames=1"]})
            for layer in (LINE, WALL) for off, changes in (("", {}), (OFF, SLIP)))],
    solve=solve, sources=("src/boundaryLayer", "src/freeSurfaceFlow", "applications/solvers/plungeFoam"),
    quantities=[
        *(Quantity(name, "N", only(of, hasLayer), lambda done, f=form: expected(done, f), tolerance=lambda done, f=form: 0.1*expected(done, f),
                   judged=lambda run, f=form: not (f and "transition" in run.variant))
          for name, form, of in (("friction", False, lambda done: drag(done.path).friction),
                                 ("friction and pressure drag", True, lambda done: drag(done.path).friction + drag(done.path).form))),
        Quantity("pressure drag", "N", only(lambda done: drag(done.path).form, lambda run: run.variant in BODIES)),
        Quantity("change of the drag over the last quarter length of the stream", "%", only(lambda done: drag(done.path).drift, hasLayer)),
        *(Quantity("CPU time of a step over that without a boundary layer", "1", twin(
            lambda done, slip: cost(done)/cost(slip), lambda run, v=f"first steps, {layer}": run.variant == v, variant=f"first steps, {layer}{OFF}"),
            most=most) for layer, most in ((LINE, 1.03), (WALL, 1.35)))],
    headlines=["friction"])
