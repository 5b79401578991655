# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that leave the liquid, axisymmetric: a sphere and a prolate spheroid of half the water's density, released at rest, in an ideal
fluid; and the dive's vehicle, upright, under thrust.

Half way to the surface the light bodies' speed is exact to the third power of their size over their depth:
(m + m_a) v^2/2 = (rho V - m) g s, with Lamb's added mass m_a = k rho V less rho (V (1 + k))^2/(16 pi h^3) at a depth h, that of the image of the
body's dipole in a surface whose pressure is constant (sphere: Lamb 1932, art. 138, 3/8 (R/h)^3): within 1 %. The vehicle's speed there: of
(m + m_a) dv/dt = T + (rho V - m) g - D, where D is the friction of Prandtl and Schlichting's line, less the laminar run's, times Hoerner's form
factor, within what a tenth of D changes. In the air bodies fall, or go by their thrust alone: the acceleration, less what water that still runs off weighs, within 2 % of
gravity or thrust. How fast they come out has no reference here but three resolutions."""
import numpy as np
from scipy.integrate import solve_ivp

from plunge.results import gather
from plunge.scene import Scene, read as readScene
from plunge.studies.friction import plateFriction
from plunge.studies.pictures import draw
from plunge.studies.scenes import prepare, solve
from plunge.studies.signals import Signal
from plunge.studies.study import STUDIES, Quantity, Run, Study

HERE = STUDIES / "exit"
SCENES = {name: readScene(HERE / name) for name in ("sphere", "spheroid", "vehicle")}
LIGHT = ("sphere", "spheroid")
ALLOWED, FALL, DRAG = 0.01, 0.02, 0.1
LEVELS = {"fast 0.5": ("quick", "full"), "fast 0.7": ("full",), "fast": ("full",)}


def make(run: Run, path) -> None:
    layer = "none" if run.scene in LIGHT else "frictionLine"
    prepare(run, path, ["-boundaryLayer", layer], scene=HERE / run.scene)
    solve(path)


def motion(done) -> dict[str, Signal]:
    """Height of the middle [m], its speed upwards [m/s] and acceleration [m/s2], over time; and how deep the lowest point is [m]."""
    table = done.track
    return {name: Signal(table["time_s"], table[column]) for name, column in (
        ("height", "z_m"), ("speed", "vz_m_s"), ("acceleration", "az_m_s2"), ("depth", "penetration_m"))}


def top(scene: Scene) -> float:
    """Of the body, at the start [m]."""
    points, _ = scene.shape.surface()
    return float(scene.nose[2] + (points @ scene.place)[:, 2].max())


def dragOf(scene: Scene, speed: float) -> float:
    shape, rho = scene.shape, scene.fluids["liquidDensity"]
    reynolds = rho*speed*shape.length/scene.fluids["liquidViscosity"]
    form = 1 + 1.5*shape.slenderness**1.5 + 7*shape.slenderness**3     # Hoerner, Fluid-Dynamic Drag, 1965
    return form*plateFriction(reynolds, min(scene.transition, reynolds))*rho/2*speed**2*shape.wetted_area


def exact(scene: Scene, rise: float, more: float = 1) -> float:
    """Speed after this rise of a body far enough below the surface; of the vehicle with `more` times the drag [m/s]."""
    rho, volume, g = scene.fluids["liquidDensity"], scene.shape.volume, scene.fluids["gravity"]
    added = rho*volume*float(scene.shape.added_mass_coefficients()[0][0])
    if not scene.thrust[0]:
        depth = scene.given["entry.depth"] - rise
        mass = scene.mass + added - (rho*volume + added)**2/rho/(16*np.pi*depth**3)
        return float(np.sqrt(2*(rho*volume - scene.mass)*g*rise/mass))

    def change(_, state):
        return state[1], (scene.thrust[0] + (rho*volume - scene.mass)*g - more*dragOf(scene, state[1]))/(scene.mass + added)

    def arrives(_, state):
        return state[0] - rise

    arrives.terminal = True
    return float(solve_ivp(change, (0, 10), (0, scene.speed), rtol=1e-9, atol=1e-12, events=arrives).y[1, -1])


def halfWay(done) -> float:
    """Speed after half of the way of the top to the surface, over the exact one."""
    scene, of = SCENES[done.run.scene], motion(done)
    rise = -top(scene)/2
    return float(np.interp(rise, of["height"].value - of["height"].value[0], of["speed"].value)/exact(scene, rise))


def tolerance(done) -> float:
    scene = SCENES[done.run.scene]
    rise = -top(scene)/2
    return ALLOWED if done.run.scene in LIGHT else abs(exact(scene, rise, 1 + DRAG)/exact(scene, rise) - 1)


def freeAcceleration(scene: Scene) -> float:
    """In the air [m/s2]"""
    return scene.thrust[0]/scene.mass - scene.fluids["gravity"]


def inTheAir(done) -> float:
    """Acceleration at the end over that in the air."""
    return float(motion(done)["acceleration"].value[-1]/freeAcceleration(SCENES[done.run.scene]))


def asItLeaves(done) -> float:
    """Speed as the lowest point passes the surface [m/s]"""
    of = motion(done)
    return float(np.interp(0, -of["depth"].value, of["speed"].value))


def curves(done, file) -> None:
    """Speed over height, and the exact one most of the way to the surface."""
    panels = []
    for name, scene in SCENES.items():
        runs = [each for each in done if each.run.scene == name]
        if not runs:
            continue
        start = float(motion(runs[0])["height"].value[0])
        rise = np.linspace(1e-4, -0.9*top(scene), 60)
        panels.append(({"title": name, "xlabel": "height of the middle above the surface [m]", "ylabel": "speed [m/s]"},
                       {"exact, deep in the liquid": Signal(start + rise, np.array([exact(scene, s) for s in rise]))},
                       {each.run.resolution: Signal(motion(each)["height"].value, motion(each)["speed"].value) for each in runs}))
    draw(file, panels, 3)


study = Study(
    title="Light bodies rise and leave the liquid, and the vehicle under thrust",
    runs=[Run(name, "meshes", "", level, tiers) for name in SCENES for level, tiers in LEVELS.items() if level == "fast" or name != "spheroid"],
    solve=make, sources=("src/freeSurfaceFlow", "src/rigidBody", "src/boundaryLayer", "applications/solvers/plungeFoam",
                         *(f"validation/studies/exit/{name}" for name in SCENES)),
    quantities=[
        Quantity("speed half way to the surface over the exact", "1", halfWay, 1, tolerance=tolerance, converges=True),
        Quantity("speed as it leaves the liquid", "m/s", asItLeaves, converges=True),
        Quantity("acceleration at the end over that in the air", "1", inTheAir, 1, tolerance=FALL),
        Quantity("error of the liquid's volume at the end over the body's", "%", lambda done: float(
            gather(done.path)["volumeLedger"]["error_percent_of_body_volume"][-1]))],
    headlines=["speed half way to the surface over the exact"],
    figure=curves)
