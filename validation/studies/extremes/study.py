# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes at the extremes, each run and classified by a rule (plunge.studies.outcomes).

right: the figure agrees with the formula, limit or twin that its name says; degraded: it does not, and the run's own summary or log says so, in words
that the scene declares; refused: an error says what was expected; silent, crash and hang are failures. What has not finished has its exit
status as its figure. Twins differ by less than 1 %, what the Reynolds number does at the lowest speed; bodies in a domain that ends somewhere and
particles are within 3 % of formulas for one without end, a slap on gas within 10 % of that without."""
import re
import subprocess
from pathlib import Path

import numpy as np

from plunge.results import fluid_force, parameters, solver_log
from plunge.studies.outcomes import FINISHED, command, ending, exit_status, keep, of_finished, word
from plunge.studies.particleRuns import CONTROL, PROPERTIES, override, table
from plunge.studies.scenes import kill
from plunge.studies.study import STUDIES, Done, Quantity, Run, Study

SCENES = STUDIES/"extremes/scenes"
MESHES, PARTICLES, STRIPS = "meshes", "particles", "slenderBody"
IDEAL = {MESHES: "-boundaryLayer none -surfaceTension off", STRIPS: "-boundaryLayer none", PARTICLES: ""}  # forces go with the speed squared
TWIN, RELEASE, SLAP, TANK, FALL, CREEP, SKIP = (
    "impulse over rho U L3, over the twin's", "velocity over g t (1 - r)/(r + added mass)", "speed after the slap over that of von Karman's momentum",
    "force on the floor over the liquid's weight", "speed over that of free fall", "force over viscosity and speed, over the twin's of equal Reynolds number",
    "largest upward velocity of a sphere below the critical angle of ricochet")
BOUNDS = "largest volume fraction out of 0 to 1, by how much"
SINK = "least downward velocity of a sphere above the critical angle of ricochet"
STOKES, BUDGET, PASSIVE = "drag over that of Stokes flow about a spheroid", "largest gap of the energy budget over the energy at the start", "impulse over the twin's deep in one fluid"
PAPER = "eq. 5|outran|Mach number|soft|compress"
G = 9.81

runs: list[Run] = []


def row(scene: str, method: str, variant: str, figure: str = "", sets: str = "", twin: str = "", says: str = "", error: str = "", options: str = "",
        changes: str = "", trouble: str = "", resolution: float = 0.5, quick: bool = False) -> None:
    """A run: what its figure is, beside which twin; entries that are set, "name=value|name=value", words that it says where it is degraded, or its error where
    it is refused; text that is added to particleProperties, trouble that is made for it."""
    runs.append(Run(scene, method, variant, f"fast {resolution:g}", ("quick", "full") if quick else ("full",), given={
        "figure": figure, "sets": sets, "twin": twin, "says": says, "error": error, "options": f"{IDEAL[method]} {options}", "changes": changes, "trouble": trouble}))


# Speeds: the force goes with their square
for method, scene, resolution in ((MESHES, "cone", 0.5), (STRIPS, "cone", 1), (PARTICLES, "wedge", 0.5)):
    row(scene, method, "25 m/s", resolution=resolution, quick=True)
    for speed in (0.1, 300):
        # At equal cavitation number, too: walls of particles hold the liquid up to the surface's pressure
        row(scene, method, f"{speed:g} m/s", TWIN, f"entry.speed={speed}|fluids.surfacePressure={101325*(speed/25)**2:.12g}", "25 m/s", resolution=resolution, quick=method != MESHES)
# Sizes: twins in everything but the Reynolds number
for method, scene, resolution in ((MESHES, "cone", 0.5), (STRIPS, "cone", 1), (PARTICLES, "wedge", 0.5)):
    for length in (0.01, 100):
        shape = (f"{{ type coneCylinder; halfAngle 45; radius {0.026/0.29*length:.12g}; length {length}; }}" if scene == "cone" else
                 f"{{ type wedge; halfAngle 45; halfWidth {0.25*length:.12g}; length {length}; }}")
        row(scene, method, f"{length:g} m long", TWIN, f"body.shape={shape}", "25 m/s", resolution=resolution, quick=method == STRIPS)
# Densities of released bodies: added mass of a sphere 1/2, of a circle 1 (Lamb 1932)
for method, scene in ((MESHES, "sphere"), (MESHES, "circle"), (STRIPS, "sphere"), (PARTICLES, "circle")):
    for ratio in (1e-6, 0.0015, 20, 1e4):
        row(scene, method, f"density ratio {ratio:g}", RELEASE, f"body.density={ratio*998.2:.8g}", quick=ratio == 20 and method == STRIPS or ratio == 0.0015 and (method, scene) == (MESHES, "sphere"),
            says="change of its momentum|change of momentum|slender ones" if method != PARTICLES else "coarse|spacings")
# Gravity: none, and 10 g at equal Froude number
for method, scene, resolution in ((MESHES, "cone", 0.5), (STRIPS, "cone", 1), (PARTICLES, "wedge", 0.5)):
    row(scene, method, "1 g, 2 m/s", "", "entry.speed=2|fluids.gravity=9.81", resolution=resolution)
    row(scene, method, "10 g, equal Froude number", TWIN, f"entry.speed={2*10**0.5:.12g}|fluids.gravity=98.1|fluids.surfacePressure=1013250", "1 g, 2 m/s", resolution=resolution)
# The gas: none to speak of, and nearly the liquid, through whose surface a body feels no more than deep in one fluid
row("cone", MESHES, "gas of a millionth", TWIN, "fluids.gasDensity=0.001|fluids.gasViscosity=1e-8", "25 m/s", says="of the liquid's density")
row("cone", MESHES, "gas as dense", "", "fluids.gasDensity=998.3", error="no lighter than the liquid", quick=True)
DEEP = "entry.speed=5|body.freedom=prescribed|fluids.gravity=0|duration=0.02"
row("sphere", MESHES, "downwards", "", DEEP)
row("sphere", MESHES, "upwards", TWIN, f"{DEEP}|entry.angle=-90", "downwards")
row("sphere", MESHES, "gas nearly as dense", PASSIVE, "entry={ speed 5; gap 0.01; }|body.freedom=prescribed|fluids.gravity=0|duration=0.02|fluids.gasDensity=998.2|fluids.gasViscosity=1.0016e-3", "downwards")
# Viscosity: a million times water's, where the force goes with it (Stokes); next to none
for viscosity, twin in ((100, ""), (1000, "100 Pa s")):
    row("sphere", MESHES, f"{viscosity} Pa s", CREEP if twin else "", f"entry.speed={1e-4*viscosity:g}|body.freedom=prescribed|fluids.gravity=0|fluids.liquidViscosity={viscosity}|"
        f"fluids.gasViscosity={1e-7*viscosity:g}|duration={100/viscosity:g}|tier.maxDeltaT=0.0005", twin, options="-boundaryLayer laminar", says="diffusion number")
row("cone", MESHES, "ideal", TWIN, "fluids.liquidViscosity=1e-12|fluids.gasViscosity=1e-12", "25 m/s")
row("cone", MESHES, "no viscosity", "", "fluids.liquidViscosity=0", error="entry 'liquidViscosity' is 0; expected", quick=True)
row("spheroid", STRIPS, "a million times more viscous", STOKES, "fluids.liquidViscosity=1000|body.freedom=prescribed|fluids.gravity=0|entry={ speed 1; angle 90; depth 3; }|duration=0.01",
    options="-boundaryLayer frictionLine", says="Reynolds number", resolution=1, quick=True)
# Courant numbers, cells
for factor in (4, 10):
    row("cone", MESHES, f"Courant numbers times {factor}", TWIN, f"tier.maxCo={factor}|tier.maxAlphaCo={factor/2:g}|tier.maxDeltaT={0.005*factor:g}", "25 m/s", says="Courant numbers")
row("vehicle", MESHES, "five cells over the nose")
row("vehicle", MESHES, "half a cell over the nose", TWIN, "tier.noseSpacing=0.022", "five cells over the nose", says="cells along")
row("cone", MESHES, "resolution 0.05", resolution=0.05, error="from 0.25", quick=True)
row("wedge", PARTICLES, "a particle over the half width", TWIN, "tier.particleSpacing=0.07", "25 m/s", error="expected", says="coarse|spacings")
# Attitudes
for method, freedom, resolution in ((STRIPS, "free", 1), (MESHES, "axial", 0.5)):
    for name, sets in (("forwards", ""), ("backwards", "entry.attitude=-90"), *((("rolling", "entry.spin=(500 0 0)"),) if freedom == "free" else ())):
        row("spheroid", method, name, TWIN if sets else "", f"body.freedom={freedom}|entry.angle=90|travel=0.5|{sets}", "forwards" if sets else "", "tail that enters first",
            resolution=resolution, quick=method == STRIPS)
row("spheroid", STRIPS, "to the left", "", "entry.sideslip=20", resolution=1)
row("spheroid", STRIPS, "to the right", TWIN, "entry.sideslip=-20", "to the left", resolution=1)
row("spheroid", STRIPS, "tumbling", BUDGET, "entry.spin=(0 200 0)", resolution=1)
# Angles
for angle in (0, -5):
    row("spheroid", STRIPS, f"{angle} deg from the air", "", f"entry.angle={angle}", error="does not come down", quick=angle == 0)
for angle in (1, 15, 30, 45, 60, 75, 90):
    row("spheroid", STRIPS, f"{angle} deg", BUDGET, f"entry.angle={angle}", resolution=1, quick=angle == 1)
# Deep and without gravity no direction is another: the body's mesh and the background's meet at all of these
for angle in (90, 70, 45, 20, 0):
    row("sphere", MESHES, f"{angle} deg, 100 Pa s", CREEP if angle != 90 else "", f"entry.speed=0.01|entry.angle={angle}|body.freedom=prescribed|fluids.gravity=0|fluids.liquidViscosity=100|"
        "fluids.gasViscosity=1e-5|duration=0.2|tier.maxDeltaT=0.0005", "90 deg, 100 Pa s" if angle != 90 else "", options="-boundaryLayer laminar -model half", says="cells of the background", resolution=0.4)
# Of spheres of the density ratio 2.7 the critical angle is 11 degrees (Johnson and Reid 1975)
row("ball", STRIPS, "ricochet, below the critical angle", SKIP, "", says="ricochet", quick=True)
for variant, layer, says in ((", separated", "wallFunction", ""), (", walls slip", "none", "stays attached")):
    row("ball", MESHES, f"ricochet, below the critical angle{variant}", SKIP, "entry.angle=5|travel=14", says=says, resolution=0.4, options=f"-boundaryLayer {layer}")
row("ball", MESHES, "ricochet, above the critical angle", SINK, "entry.angle=20", resolution=0.4, options="-boundaryLayer wallFunction")
row("ball", MESHES, "grazes the surface", BOUNDS, "entry.angle=5|travel=3", resolution=0.4, quick=True)
row("slap", MESHES, "flat", SLAP)
row("slap", STRIPS, "flat", SLAP, resolution=1, quick=True)
# Out of the liquid, and through the floor
row("sphere", MESHES, "thrown up out of the liquid", FALL, "entry.speed=4|entry.angle=-90|entry.depth=0.25|body.density=8000|duration=0.15", resolution=0.4)
row("sphere", MESHES, "thrown up into a gas of a millionth", FALL, "entry.speed=4|entry.angle=-90|entry.depth=0.25|body.density=8000|duration=0.15|fluids.gasDensity=0.001|fluids.gasViscosity=1e-8",
    error="The flow diverges", says="of the liquid's density", resolution=0.4)
row("sphere", STRIPS, "falls in the air", FALL, "entry={ speed 0; gap 0.5; }|duration=0.2", resolution=1, quick=True)
row("circle", PARTICLES, "falls in the air", FALL, "entry={ speed 0; gap 0.3; }|duration=0.1")
row("sphere", MESHES, "leaves the background", "", "entry={ speed 2; depth 0.5; }|body.density=8000|duration=0.1", error="leaves the background", options="-model half -mesh overset", trouble="runs on", resolution=0.4)
row("circle", PARTICLES, "falls on the floor", "", "entry={ speed 2; depth 0.5; }|body.density=8000|duration=0.1", error="no contact", trouble="runs on", resolution=0.4)
# Liquids at the ends of what they are
for temperature, error in ((60, "expected 63"), (130, "to 125 K")):
    row("lake", STRIPS, f"Kraken at {temperature} K", "", f"fluids.temperature={temperature}", error=error, resolution=1, quick=temperature == 60)
row("lake", STRIPS, "Kraken at 66 K, which may freeze", sets="fluids.temperature=66", error="expected", says="may freeze", resolution=1, quick=True)
row("lake", STRIPS, "Kraken at 100 K, above its bubble point", sets="fluids.temperature=100", error="expected", says="superheated", resolution=1, quick=True)
# Particles: sound slower than the body, neighbours, float far away
row("wedge", PARTICLES, "sound at 0.4 of the speed", TWIN, "", "25 m/s", says=PAPER, options="-soundSpeed 10")
for neighbours, error in ((10, "neighbours"), (12, ""), (500, "")):
    row("stillTank", PARTICLES, f"{neighbours} neighbours", TANK, "", error=error, resolution=0.4, quick=neighbours == 10,
        changes=f"#remove (smoothingLength)\nneighbours {neighbours};")
for precision in ("single", "double"):
    row("stillTank", PARTICLES, f"{precision}, 1e6 m away", TANK, resolution=0.4, changes=f"precision {precision};\ngeometry {{ fluid ({{ type box; min (1e6 0 0); max (1000001 0.5 0); hydrostatic yes; }}); "
        "walls ({ name tank; type box; min (1e6 0 0); max (1000001 0.7 0); open (top); }); }\n#remove outputs\noutputs { interval 0.01; }")
# Trouble
for method, scene, resolution in ((MESHES, "cone", 0.5), (STRIPS, "cone", 1), (PARTICLES, "wedge", 0.5)):
    row(scene, method, "read-only directory", trouble="read-only", resolution=resolution, quick=True)
    row(scene, method, "full disk", trouble="full disk", error="written|room|File too large|IOstream|not be", resolution=resolution)
    row(scene, method, "two runs in one directory", trouble="two", error="expected to be alone", resolution=resolution, quick=method == STRIPS)
    row(scene, method, "killed", TWIN, twin="25 m/s", trouble="killed", resolution=resolution)


def solve(run: Run, path: Path) -> None:
    given, error = run.given, run.given["error"] or "expected"
    tier, factor = run.grade
    words = ["plungeCase", SCENES/run.scene if (SCENES/run.scene).exists() else STUDIES.parents[1]/"cases"/run.scene, "-method", run.method, "-tier", tier,
             "-resolution", factor, "-np", "1", *given["options"].split()]
    if run.scene == "stillTank":
        words = [word for word in words if word not in IDEAL[run.method].split()]
    words += [part for each in given["sets"].split("|") if each for part in ("-set", each)]
    subprocess.run(["rm", "-rf", path])
    status, said = command(*words, "-run", "/sys/kernel/run" if given["trouble"] == "read-only" else path)
    if keep(path, status, said, error) != FINISHED:
        return
    if given["changes"]:
        override(path, PROPERTIES, given["changes"])
    # Allrun's own line for a step that is done: no pictures
    (path/"log.plungePost").write_text("No pictures\n# Allrun: finished\n")
    if given["trouble"] == "runs on":
        override(path, CONTROL, "endTime 1;")
    if given["trouble"] == "killed":
        for _ in range(3):
            kill(path, 1.5)
    if given["trouble"] == "two":
        with subprocess.Popen([path/"Allrun"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as first:
            while not (path/"lock").exists():
                pass
            keep(path, *command(path/"Allrun"), error)
            first.wait()
        return
    limit = ["bash", "-c", "trap '' XFSZ; ulimit -f 40; exec \"$0\""] if given["trouble"] == "full disk" else []
    keep(path, *command(*limit, path/"Allrun"), error)


def scales(done: Done) -> tuple[float, float, float, int]:
    """Density, speed, length, and the dimensions of the body."""
    given = parameters(done.path)
    return *(float(given[name]) for name in ("liquidDensity", "speed", "bodyLength")), 2 if given["model"] == "plane" else 3


def peak(done: Done) -> float:
    """Of the fluids' force over rho U^2 L^2, in the plane per metre over rho U^2 L; the start has no acceleration yet."""
    density, speed, length, dimensions = scales(done)
    load = np.linalg.norm(fluid_force(done.track), axis=0)[1:].max()
    return float(load/(density*speed**2*length**(dimensions - 1)))


def impulse(done: Done) -> float:
    """Of the fluids on the body over rho U L^3, in the plane per metre over rho U L^2."""
    density, speed, length, dimensions = scales(done)
    of = done.track
    total = np.linalg.norm((fluid_force(of)[:, 1:]*np.diff(of["time_s"])).sum(axis=1))
    return float(total/(density*speed*length**dimensions))


def over_twin(value):
    return lambda done: value(done)/value(done.beside(variant=done.run.given["twin"]))


def release(done: Done) -> float:
    of, given = done.track, parameters(done.path)
    ratio = float(given["bodyMass"])/(float(given["liquidDensity"])*float(given["bodyVolume"]))
    added = 1.0 if given["model"] == "plane" else 0.5
    up = of["vy_m_s" if given["application"] == "plungeSPH" else "vz_m_s"][-1]
    return float(up/(G*of["time_s"][-1]*(1 - ratio)/(ratio + added)))


def slap(done: Done) -> float:
    """A disc that hits a surface flat shares its momentum with half of the liquid that it has about it deep inside, 8/3 rho R^3 (Lamb 1932)."""
    of, given = done.track, parameters(done.path)
    mass, radius = float(given["bodyMass"]), 0.5*float(given["bodyLength"])*float(given["thicknessRatio"])
    contact = of["time_s"][np.argmax(of["penetration_m"] >= 0)]
    after = float(np.interp(contact + 1e-4, of["time_s"], of["speed_m_s"]))
    return after/of["speed_m_s"][0]*(1 + 4/3*float(given["liquidDensity"])*radius**3/mass)


def tank(done: Done) -> float:
    of = table(done.path, "walls")
    return -float(of["tank_Fy_N_m"][of["time_s"] > 0.5*of["time_s"][-1]].mean())/(1000*G*1*0.5)


def fall(done: Done) -> float:
    """Of a body that is above the surface: from its first row there to the last."""
    of, up = done.track, "vy_m_s" if parameters(done.path)["application"] == "plungeSPH" else "vz_m_s"
    dry = np.flatnonzero(of["penetration_m"] < -0.01)
    first, last = dry[0], dry[-1]
    return float((of[up][first] - of[up][last])/(G*(of["time_s"][last] - of["time_s"][first])))


def creep(done: Done) -> float:
    given = parameters(done.path)
    return float(np.linalg.norm(fluid_force(done.track)[:, -1])/(float(given["liquidViscosity"])*float(given["speed"])))


def stokes(done: Done) -> float:
    """Along the axis of a prolate one (Happel and Brenner 1965)."""
    of, given = done.track, {name: float(parameters(done.path)[name]) for name in ("liquidViscosity", "bodyLength", "thicknessRatio", "speed")}
    e = float(np.sqrt(1 - given["thicknessRatio"]**2))
    drag = 8*np.pi*given["liquidViscosity"]*given["bodyLength"]*given["speed"]*e**3/((1 + e*e)*np.log((1 + e)/(1 - e)) - 2*e)
    return float((of["Fpz_N"][-1] + of["Fvz_N"][-1])/drag)


def skip(done: Done) -> float:
    """Over the speed at the start."""
    of = done.track
    return float(of["vz_m_s"].max()/of["speed_m_s"][0])


def unbounded(done: Done) -> float:
    found = np.array(re.findall(r"Min\(alpha.liquid\) = (\S+)  Max\(alpha.liquid\) = (\S+)", solver_log(done.path)), dtype=float)
    return float(max(-found[:, 0].min(), found[:, 1].max() - 1))


def budget(done: Done) -> float:
    of = table(done.path, "energy")
    return float(np.abs(of["imbalance_J"]).max()/of["kinetic_J"][0])


def no_figure(done: Done) -> float | None:
    """Exit status of a run that has not finished, or should have been refused."""
    status = exit_status(done)
    return 0.0 if status is None and done.run.given["error"] and not done.run.given["figure"] and not done.run.given["trouble"] else status


def finished(name: str, value, reference: float, tolerance: float) -> Quantity:
    return Quantity(name, "1", of_finished(value, name), reference, tolerance=tolerance, word=word)


study = Study(
    title="At the extremes a run is right, degraded and says so, or refused; never silently wrong",
    runs=runs, solve=solve, sources=("src/freeSurfaceFlow", "src/smoothedParticles", "src/slenderBody", "src/rigidBody", "applications/solvers", "etc/methods", "validation/studies/extremes/scenes"),
    quantities=[
        finished(TWIN, over_twin(impulse), 1, 0.01), finished(RELEASE, release, 1, 0.03), finished(SLAP, slap, 1, 0.1), finished(TANK, tank, 1, 0.01),
        finished(FALL, fall, 1, 0.01), finished(CREEP, over_twin(creep), 1, 0.01),
        finished(STOKES, stokes, 1, 0.03), finished(BUDGET, budget, 0, 0.001), Quantity(SKIP, "1", of_finished(skip, SKIP), least=0, word=word),
        Quantity(SINK, "1", of_finished(lambda done: -skip(done), SINK), least=0, word=word),
        Quantity(BOUNDS, "1", of_finished(unbounded, BOUNDS), most=0.01, word=word),
        finished(PASSIVE, over_twin(impulse), 1, 0.01),
        Quantity("peak of the force over rho U2 L2, over the twin's", "1", of_finished(over_twin(peak), TWIN)),
        Quantity("exit status", "1", no_figure, word=ending)],
    headlines=["exit status"])
