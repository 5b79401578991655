# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole dive of ASTrAEUS by slenderBody, from contact until it is at rest (a hundredth of its speed) or back at the surface, 60 s at most: in
Titan's lakes as measured, in the paper's constants and in water, the body's density that of the paper's liquid. Variants are the volume coefficients of a
tail of aspect ratio 2. Of each the dive at 25 m/s and 75 degrees, and a seeded sample of a thousand: boundary layer laminar, with transition or
turbulent (equal shares), the lake (Kraken, Ligeia, Punga, Ontario; equal shares), mass (standard deviation 10 %), speed (1 m/s), angle
(5 deg), and the angle between axis and path, down and to the side (1 deg each). Depths are the lowest point's. Nothing is judged."""
import math

import numpy as np

from plunge import fluids as pairs
from plunge.results import parameters
from plunge.shapes import NACA
from plunge.studies.particleRuns import call
from plunge.studies.pictures import draw
from plunge.studies.scenes import prepare, solve as finish
from plunge.studies.signals import Signal
from plunge.studies.study import Quantity, Run, Study

SEED, DURATION, MASS, SPEED, ANGLE, OFF, LAYERS = 20, 60.0, 0.1, 1.0, 5.0, 1.0, (0, 5e5, 1e12)
LIQUIDS = {"kraken": ("kraken", "ligeia", "punga", "ontario"), "titan": ("titan",), "water": ("water",)}
NAMES = {"kraken": "lakes as measured", "titan": "the paper's constants", "water": "water"}
TAILS = (0, 0.2, 0.4, 0.6, 1.0)


def sample(run: Run, given: dict[str, str]) -> str:
    """A table for slenderBody -sample."""
    random = np.random.default_rng(SEED)
    aft, mass = float(given["centreOfMassFromNose"]), float(given["bodyMass"])
    inertia = np.array(given["bodyMomentOfInertia"].strip("()").split(), float)
    liquids = [pairs.resolve(name, name)[1] for name in LIQUIDS[run.given["fluids"]]]
    vector = lambda values: "(" + " ".join(f"{value:.12g}" for value in np.ravel(values)) + ")"
    lines = ["body/mass,body/momentOfInertia,body/centreOfMass,body/orientation,body/velocity,liquid/rho,liquid/mu,transitionReynolds"]
    for _ in range(run.given["dives"]):
        heavier, angle = 1 + MASS*random.standard_normal(), math.radians(min(75 + ANGLE*random.standard_normal(), 89.9))
        speed, (down, aside) = 25 + SPEED*random.standard_normal(), np.radians(OFF)*random.standard_normal(2)
        liquid, layer = liquids[random.integers(len(liquids))], LAYERS[random.integers(len(LAYERS))]
        forward = np.array([math.cos(angle + down)*math.cos(aside), math.sin(aside), -math.sin(angle + down)*math.cos(aside)])
        side = np.cross([math.sin(angle + down), 0, math.cos(angle + down)], forward)
        side /= np.linalg.norm(side)
        centre = np.array([0, 0, float(given["gap"])]) - aft*forward
        lines.append(",".join([f"{heavier*mass:.12g}", vector(heavier*inertia), vector(centre), vector(np.array([forward, side, np.cross(forward, side)]).T),
                               vector(speed*np.array([math.cos(angle), 0, -math.sin(angle)])), f"{liquid['liquidDensity']:.12g}",
                               f"{liquid['liquidViscosity']:.12g}", f"{layer:g}"]))
    return "\n".join(lines) + "\n"


def solve(run: Run, path) -> None:
    tail = ["-set", f"body.tail={{ volumeCoefficient {run.given['tail']}; }}"] if run.given["tail"] else []
    prepare(run, path, ["-fluids", run.given["fluids"], "-set", f"duration={DURATION}", *tail])
    (path/"constant/slenderBodySettings").write_text("until (atRest surfaced leftTheLiquid);\n")
    finish(path)
    (path/"sample.csv").write_text(sample(run, parameters(path)))
    call(path, "slenderBody", "-sample", "sample.csv", mode="a")


def of(done) -> np.ndarray:
    return np.genfromtxt(done.path/"results/sample.csv", delimiter=",", names=True)


def balance(given: dict[str, str]) -> float:
    """2 (k2 - k1) V/(A L a), with Lamb's coefficients and Helmbold's slope a for an aspect ratio of 2, the tail at the body's end."""
    length, ratio, volume = (float(given[name]) for name in ("bodyLength", "thicknessRatio", "bodyVolume"))
    along, across, _ = NACA(length, ratio).added_mass_coefficients()[0]
    return float(2*(across - along)*volume/(np.pi/4*(ratio*length)**2*length*2*np.pi*2/(2 + np.sqrt(8))))


def spread(name: str, unit: str, column: str, what=lambda values: values) -> list[Quantity]:
    return [Quantity(f"{name}, {word}", unit, lambda done, share=share: float(np.nanpercentile(what(of(done)[column]), share)))
            for word, share in (("5 %", 5), ("median", 50), ("95 %", 95))]


def track(done, x: str, y: str) -> Signal:
    table = done.track
    return Signal(table[x], table[y])


def curves(done, tails, x: str, y: str) -> dict[str, Signal]:
    return {f"{NAMES[each.run.given['fluids']]}, {'no tail' if not each.run.given['tail'] else 'tail'}": track(each, x, y)
            for each in done if each.run.given["tail"] in tails}


def depths(done, tail: float) -> dict[str, Signal]:
    return {NAMES[each.run.given["fluids"]]: Signal(np.sort(of(each)["deepest_m"]), np.linspace(0, 100, len(of(each))))
            for each in done if each.run.given["tail"] == tail}


study = Study(
    title="The whole dive: how deep, how fast, and what tail it takes",
    runs=[Run("gannetPlunge", "slenderBody", f"{fluids}, tail {tail:g}" + (", few" if dives < 1000 else ""), tiers=(tier,), given={"fluids": fluids, "tail": tail, "dives": dives})
          for fluids in LIQUIDS for tail in TAILS for dives, tier in ((1000, "full"), (20, "quick")) if tier == "full" or fluids == "kraken" and tail in (0, 1)],
    solve=solve, sources=("src/slenderBody", "src/boundaryLayer/frictionLaw", "src/titanThermophysicalModels", "etc/fluids"),
    quantities=[
        *spread("deepest point", "m", "deepest_m"), *spread("time of the deepest point", "s", "deepest_s"), *spread("end", "s", "end_s"),
        *spread("depth after 1 s", "m", "depth_1s_m"), *spread("speed after 1 s", "m/s", "speed_1s_m_s"), *spread("depth at half the speed", "m", "half_m"),
        *spread("speed lost at full immersion", "m/s", "lost_m_s"), *spread("largest turn of the axis", "deg", "most_turned_deg"),
        *spread("peak deceleration", "m/s2", "peak_m_s2"),
        *(Quantity(f"dives that end {how}", "%", lambda done, code=code: 100*float(np.mean(of(done)["end"] == code)))
          for how, code in (("at rest", 2), ("back at the surface", 4), ("later than 60 s", 0))),
        Quantity("CPU time for a dive", "ms", lambda done: 1e3*done.cpu/(1 + done.run.given["dives"])),
        Quantity("tail coefficient that balances Munk's moment", "1", lambda done: balance(parameters(done.path)) if not done.run.given["tail"] else None)],
    headlines=["deepest point, median"],
    figure=lambda done, file: draw(file, [
        ({"title": "Speed over depth, 25 m/s at 75 deg", "xlabel": "depth [m]", "ylabel": "speed [m/s]", "xlim": (0, 30)}, {},
         curves(done, (0, 1.0), "penetration_m", "speed_m_s")),
        ({"title": "Pitch", "xlabel": "time [s]", "ylabel": "pitch [deg]", "xlim": (0, 3)}, {}, curves(done, (0, 1.0), "time_s", "pitch_deg")),
        ({"title": "A thousand dives without a tail", "xlabel": "deepest point [m]", "ylabel": "dives that come no deeper [%]"}, {}, depths(done, 0)),
        ({"title": "A thousand dives with a tail of coefficient 1", "xlabel": "deepest point [m]", "ylabel": "dives that come no deeper [%]"}, {}, depths(done, 1.0))], 2))
