# SPDX-License-Identifier: GPL-3.0-or-later
"""From a scene and a method to an ordinary OpenFOAM case."""

from __future__ import annotations

import fcntl
import re
import shlex
import shutil
from dataclasses import dataclass
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np

from plunge import decisions, foamDictionary
from plunge import scene as scenes
from plunge import tank as tank_scenes
from plunge.checks import ParameterError, count, number, word
from plunge.decisions import Decision
from plunge.methods import meshes, particles, slender, tanks, tiers
from plunge.methods.meshes import vector
from plunge.methods.tiers import TEMPLATES
from plunge.scene import Scene
from plunge.tank import Tank

NOTE = "Written by plungeCase from constant/scene; SI units."
GENERATED = "system/plungeGenerated"
JOB = "plunge.sbatch"
_TURBULENCE = ("k", "omega", "nut")  # fields of wall functions alone
_OVERSET = ("zoneID", "setFieldsDict", "background")
_SHAPE_FILES = "constant/geometry"
_SHOWN = 8  # of the entries that differ
_BEGUN = ".plungeCase"  # of a set-up that was interrupted
_MOST = 2e8     # cells or particles
_LONGEST_JOB = 8760.0   # [h]
_MOST_STEPS = 1e8   # of time: months, also of the smallest meshes

OPTIONS = {
    "method": word(*decisions.METHODS),
    "model": word("auto", *decisions.MODELS),
    "mesh": word("auto", *decisions.MESHES),
    "resolution": number("a number from 0.25 to 16", lambda v: 0.25 <= v <= 16),
    "cores": count(1),
    "boundaryLayer": word("auto", "laminar", "wallFunction", "frictionLine", "none"),
    "surfaceTension": word("auto", "on", "off"),
    "soundSpeed": number("metres per second, above 0", lambda v: v > 0),
    "flow": word("auto", "attached", "cavity"),
}
DEFAULTS: dict[str, Any] = {"method": "meshes", "model": "auto", "mesh": "auto", "tier": "fast", "resolution": 1, "cores": 2,
                            "boundaryLayer": "auto", "surfaceTension": "auto", "soundSpeed": None, "flow": "auto"}
APPLICATIONS = {"meshes": "plungeFoam", "particles": "plungeSPH", "slenderBody": "slenderBody"}
_UNITS = {"meshes": ("cells", "estimatedCells"), "particles": ("particles", "fluidParticles"), "slenderBody": ("steps", "estimatedSteps")}


@dataclass(frozen=True)
class Case:
    """A scene by a method: what plungeGenerated holds."""

    scene: "Scene | Tank"
    options: dict[str, Any]
    decided: dict[str, Decision]
    sections: list[tuple[str, dict[str, Any]]]

    @property
    def flat(self) -> dict[str, Any]:
        return {k: v for _, entries in self.sections for k, v in entries.items()}

    @property
    def unit(self) -> str:
        """What its resolution is counted in"""
        return _UNITS[self.options["method"]][0]

    @property
    def count(self) -> float:
        """Of them, estimated"""
        return float(self.flat[_UNITS[self.options["method"]][1]])

    @property
    def name(self) -> str:
        """Of the run directory, unless one is given."""
        o, flat = self.options, self.flat
        asked = [o[key] for key in ("model", "mesh", "boundaryLayer") if o[key] != "auto"]
        finer = [f"r{o['resolution']:g}"] if o["resolution"] != 1 else []
        other = [o["method"]] if o["method"] != "meshes" else []
        return "-".join([flat["fluids"], o["tier"], *asked[:1], *finer, *asked[1:], *other])

    @property
    def summary(self) -> list[str]:
        """What was decided and why, for the user."""
        scene, flat = self.scene, self.flat
        if isinstance(scene, Tank):
            return [scene.headline, self._how, *scene.notes, *flat["decisions"]]
        way = f"at {scene.speed:g} m/s and {scene.angle:g} deg" if scene.speed else "from rest"
        return [
            f"{scene.given['body.shape']['type']} of {scene.shape.length:.4g} m and {scene.shape.max_diameter:.4g} m across, "
            f"{scene.mass:.4g} kg{'/m' if scene.shape.dimensions == 2 else ''}, {scene.freedom}, {way}; fluids {scene.fluids_name}",
            self._how,
            *scene.notes,
            *flat["decisions"],
        ]

    @property
    def _how(self) -> str:
        return f"{self.flat['application']}, tier {self.options['tier']}, resolution {self.options['resolution']:g}, " \
               f"{float(self.flat.get('diveDuration', self.scene.duration)) * 1e3:.4g} ms on {self.flat.get('cores', self.options['cores'])} core(s)"


def parameters(given: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any]]:
    """Splits the command line's entries: options of the method, entries of the tier, entries of the scene."""
    options = {k: v for k, v in given.items() if k in DEFAULTS}
    tier = {k[len("tier."):]: v for k, v in given.items() if k.startswith("tier.")}
    rest = {k: v for k, v in given.items() if k not in options and not k.startswith("tier.")}
    for name, value in options.items():
        if name in OPTIONS and not OPTIONS[name][1](value):
            raise ParameterError(f"-{'np' if name == 'cores' else name} {value}: expected {OPTIONS[name][0]}")
    return {**DEFAULTS, **options}, tier, rest


def derive(path: Path, given: dict[str, Any] = {}) -> Case:
    """A scene's file or case directory, and what the command line asks for (flat names), to all numbers of the dictionaries."""
    case = _derived(path, given)
    if case.count > _MOST:
        raise ParameterError(f"{case.scene.file}: {case.count:.3g} {case.unit}; expected {_MOST:g} at most: a coarser tier or resolution, or a shape without such thin parts")
    if not float(case.flat["estimatedSteps"]) <= _MOST_STEPS:
        raise ParameterError(f"{case.scene.file}: {case.scene.duration:.3g} s are {float(case.flat['estimatedSteps']):.3g} time steps; expected "
                             f"{_MOST_STEPS:g} at most: a shorter duration or travel, or an event, until")
    return case


def _derived(path: Path, given: dict[str, Any]) -> Case:
    options, tier_entries, entries = parameters(given)
    if options["soundSpeed"] is not None and options["method"] != "particles":
        raise ParameterError("-soundSpeed is of particles; expected -method particles with it")
    if options["flow"] != "auto" and options["method"] != "slenderBody":
        raise ParameterError(f"-flow {options['flow']} is of slenderBody; expected -method slenderBody with it")
    if tank_scenes.is_tank(path, entries):
        if options["method"] == "slenderBody":
            raise ParameterError(f"{path}: -method slenderBody, but there is no body; expected -method meshes or particles")
        return _of_tank(tank_scenes.read(path, entries), options, tier_entries)
    scene = scenes.read(path, entries)
    tier = tiers.read(options["tier"], tier_entries)
    method = options["method"]
    if method == "slenderBody":
        slender.check(scene)
    elif any(name.startswith("body.tail.") for name in scene.given):
        scene.notes.append(f"tail: -method slenderBody has it; {APPLICATIONS[method]} leaves it out")
    model = decisions.model(scene, method, options["model"])
    mesh = decisions.mesh(scene, method, model.choice, options["mesh"])
    decided = {"model": model, **({"mesh": mesh} if method == "meshes" else {})}
    if method == "meshes":
        asked = meshes.Meshes(scene, tier, options["resolution"], options["cores"], model.choice, mesh.choice)
        decided |= meshes.decide(asked, options["boundaryLayer"], options["surfaceTension"])
        of_method = meshes.sections(asked, decided)
        turn = np.eye(3)
    elif method == "slenderBody":
        body = slender.Slender(scene, tier, options["resolution"], 1, model.choice, options["flow"])
        decided |= slender.decide(body, options["boundaryLayer"], options["surfaceTension"])
        of_method = slender.sections(body)
        turn = np.eye(3)
    else:
        asked = particles.Particles(scene, tier, options["resolution"], options["cores"], model.choice, options["soundSpeed"])
        of_method = particles.sections(asked)
        c0 = next(entries["particleSoundSpeed"] for _, entries in of_method if "particleSoundSpeed" in entries)
        decided |= particles.decide(asked, c0, options["boundaryLayer"], options["surfaceTension"])
        # plungeSPH's plane is x and y
        turn = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]) if model.choice in ("plane", "axisymmetric") else np.eye(3)
    return Case(scene, options, decided, [*_common(scene, options, decided, turn), *of_method])


def _of_tank(tank: Tank, options: dict[str, Any], tier_entries: dict[str, Any]) -> Case:
    """A scene without a body."""
    if options["mesh"] not in ("auto", "single"):
        raise ParameterError(f"{tank.source}: -mesh {options['mesh']}, but there is no body; expected auto or single")
    tier = tiers.read(options["tier"], tier_entries, tanks.TIERS, tanks.TIER_ENTRIES)
    model = tank_scenes.model(tank, options["model"])
    cell = tanks.spacing(tank, tier, options["method"], model.choice, options["resolution"])
    decided = {"model": model, **tank_scenes.decide(tank, options["method"], options, cell)}
    return Case(tank, options, decided, tanks.sections(tank, tier, options, decided))


def _common(scene: Scene, options: dict[str, Any], decided: dict[str, Decision], turn: np.ndarray) -> list[tuple[str, dict[str, Any]]]:
    """Sections that every method has; `turn` takes the scene's axes to the method's."""
    fluids, shape = scene.fluids, scene.shape
    inertia, _ = scene.principal
    nose = scene.nose
    share = decisions.share(decided["model"].choice, options["method"])
    motion = "prescribed" if scene.freedom == "fixed" else scene.freedom
    if motion == "free" and decided["model"].choice in ("half", "plane"):
        motion = "planar"

    def turned(values: Any) -> list[float]:
        return vector(turn @ np.asarray(values, float))

    return [
        ("The scene", {
            "application": APPLICATIONS[options["method"]],
            "fluids": scene.fluids_name, "model": decided["model"].choice, "mesh": decided["mesh"].choice if "mesh" in decided else "none",
            "tier": options["tier"], "resolution": options["resolution"],
            "shape": scene.given["body.shape"]["type"], "bodyLength": shape.length, "thicknessRatio": shape.slenderness,
            "bodyScale": scene.scale, "freedom": scene.freedom, "motion": motion,
            "dimensions": 2 if decided["model"].choice in ("plane", "axisymmetric") else 3,
            "speed": scene.speed, "referenceSpeed": scene.reference_speed, "pathAngle": scene.angle, "gap": float(nose[2]),
            "event": scene.given.get("until", "none"),
        }),
        ("Fluids", {
            **fluids,
            "liquidKinematicViscosity": fluids["liquidViscosity"] / fluids["liquidDensity"],
            "gasKinematicViscosity": fluids["gasViscosity"] / fluids["gasDensity"],
            "gravityVector": turned([0, 0, -fluids["gravity"]]),
        }),
        ("What is modelled, and why", decisions.sections(decided, scene, options["method"])),
        ("The whole body, at t = 0", {
            "bodyVolume": shape.volume, "bodyMass": scene.mass, "bodyMomentOfInertia": vector(inertia),
            "noseRadius": shape.nose_radius, "centreOfMassFromNose": float(scene.centre[0]),
            "nosePosition": turned(nose), "centreOfMass": turned(nose + scene.centre @ scene.place),
            "forward": turned(scene.forward), "dorsal": turned(scene.dorsal), "side": turned([0, 1, 0]),
            "orientation": vector((turn @ scene.orientation).ravel()),
            "initialVelocity": turned(scene.speed * scene.heading), "heading": turned(scene.heading if scene.speed else [0, 0, -1]),
            "angularMomentum": vector(share * scene.angular_momentum),
        }),
        ("What the model holds of it", {
            "modelledMass": share * scene.mass,
            "modelledMomentOfInertia": vector(share * inertia),
            "modelledVolume": share * shape.volume,
            **_thrust(scene, share, nose @ turn.T),
        }),
    ]


def _thrust(scene: Scene, share: float, nose: np.ndarray) -> dict[str, Any]:
    """Of the model's part, along the axis, in the body's own axes."""
    force, start, end = scene.thrust
    if force == 0:
        return {"thrust": "no"}
    return {"thrust": "yes", "thrustForce": share * force, "thrustDirection": vector(scene.principal[1].T @ [1.0, 0.0, 0.0]),
            "thrustAt": vector(nose), "thrustStart": start, "thrustEnd": end}


def _copy(source: Path, target: Path, without: tuple[str, ...] = ()) -> None:
    if source.is_dir():
        shutil.copytree(source, target, dirs_exist_ok=True, ignore=shutil.ignore_patterns(*without))


def _copy_case(case: Case, run: Path) -> None:
    """The method's dictionaries; over them, those of the scene's own case."""
    method, flat = case.options["method"], case.flat
    without: list[str] = []
    if isinstance(case.scene, Tank):
        tanks.copy(case.scene, flat, run, NOTE)
    else:
        if method == "meshes":
            without += [] if flat["boundaryLayer"] == "wallFunction" else _TURBULENCE
            without += [] if flat["mesh"] != "single" else _OVERSET
            without += ["snapped"]
        if method == "slenderBody":
            without += ["bodyMotion"]
        for source in (TEMPLATES / "common", TEMPLATES / method):
            _copy(source, run, tuple(without))
        if flat.get("bodyMesh") == "snapped":
            _copy(TEMPLATES / method / "snapped", run)
    own = case.scene.folder
    if case.scene.file.parent.name == "constant":
        for part in ("0.orig", "constant", "system", "background"):
            _copy(own / part, run / part, ("scene", "scene.*", "polyMesh", *without))


def _write_scene(case: Case, run: Path, overrides: dict[str, Any]) -> None:
    """The effective scene; the shape's file goes with it."""
    scene = case.scene
    entries: dict[str, Any] = scenes.read_entries(scene.file, overrides)
    shape = entries["body"]["shape"] if "body" in entries else {}
    if "file" in shape:
        source = scene.folder / shape["file"]
        target = run / _SHAPE_FILES / source.name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, target)
        shape["file"] = f"{_SHAPE_FILES}/{source.name}"
    foamDictionary.write_nested(run / "constant" / "scene", NOTE.replace("constant/scene", str(scene.file.name)), entries)


def write_job(case: Case, run: Path, memory: float, hours: float) -> Path:
    """A batch script for Slurm in the run directory, which asks for this memory [MB] and time [h]."""
    if hours > _LONGEST_JOB:
        raise ParameterError(f"-batch: {hours:.3g} hours with room to spare; expected a year at most: a coarser tier, more cores or a shorter run")
    cores = case.options["cores"]
    tasks, threads = (1, cores) if case.options["method"] == "particles" else (cores, 1)
    text = (TEMPLATES / JOB).read_text()
    for name, value in {"name": run.name, "tasks": tasks, "threads": threads, "run": shlex.quote(str(run.resolve())),
                        "memoryPerCore": ceil(memory / cores), "hours": ceil(hours)}.items():
        text = text.replace(f"@{name}@", str(value))
    (run / JOB).write_text(text)
    return run / JOB


def write(case: Case, run: Path, given: dict[str, Any]) -> bool:
    """Make the run directory, unless it is there for the same scene. Was it made?"""
    if re.search(r"[^\w./+,=@%~:-]", str(run.absolute())):
        raise ParameterError(f"run directory '{run}': expected a path of letters, digits and ._-+,=@%~: without spaces, quotes and brackets, "
                             "which OpenFOAM does not take")
    if run.exists() and not run.is_dir():
        raise ParameterError(f"run directory '{run}': there is a file of this name; expected a directory, or none yet")
    generated = run / GENERATED
    flat = case.flat
    if generated.exists():
        here = foamDictionary.read(generated)
        differing = [k for k, v in flat.items()
                     if k != "decisions" and foamDictionary.format_value(here.get(k, "")) != foamDictionary.format_value(v)]
        if differing:
            raise ParameterError(
                f"{run} holds another scene: {' '.join(differing[:_SHOWN])}{' ...' if len(differing) > _SHOWN else ''} differ in "
                f"{generated}; choose another directory with -run, or remove this one")
        return False
    if run.exists() and any(run.iterdir()) and not (run / _BEGUN).exists():
        raise ParameterError(f"{run} holds other files; expected a new directory, or one that plungeCase has made")
    run.mkdir(parents=True, exist_ok=True)
    with (run / _BEGUN).open("a") as begun:
        # One at a time: another plungeCase may make the same directory
        fcntl.flock(begun, fcntl.LOCK_EX)
        if generated.exists():
            (run / _BEGUN).unlink(missing_ok=True)
            return write(case, run, given)
        _make(case, run, given)
        (run / _BEGUN).unlink()
    return True


def _make(case: Case, run: Path, given: dict[str, Any]) -> None:
    """The files of the run directory."""
    _copy_case(case, run)
    _write_scene(case, run, parameters(given)[2])
    if case.options["method"] == "slenderBody":
        slender.write_meridian(case.scene.shape, run / slender.MERIDIAN)
    allrun = run / "Allrun"
    allrun.write_text(allrun.read_text().replace("@plungeDir@", str(TEMPLATES.parents[1])))
    allrun.chmod(0o755)
    # Its presence says that the set-up is complete, so it comes last.
    foamDictionary.write(run / GENERATED, NOTE, case.sections)
