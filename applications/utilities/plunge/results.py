# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of a case of plungeFoam or plungeSPH: gathered over restarts, and the numbers drawn from them."""

from __future__ import annotations

import csv
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Mapping, Sequence

import numpy as np

from plunge import foamDictionary

Table = dict[str, np.ndarray]  # column name (with unit) -> values
Quantities = dict[str, tuple[float, str]]  # name -> (value, unit)

G0 = 9.80665  # standard gravity, m/s2
STARTING = 3  # time steps of a start in the liquid whose loads are the start's
TURNED = 10  # [deg] from which a body counts as turned away from its path
IMPACT = 0.25  # of the body's height at the start: the immersed part until which a peak is the impact's

TRAJECTORY_COLUMNS = (
    "time_s penetration_m speed_m_s deceleration_m_s2 deceleration_g x_m y_m z_m "
    "vx_m_s vy_m_s vz_m_s a2_m_s2 a3_m_s2 pitch_deg Fpx_N Fpy_N Fpz_N Fvx_N Fvy_N Fvz_N Fgx_N Fgy_N Fgz_N"
).split()
LEDGER_COLUMNS = ["time_s", "error_percent_of_body_volume"]


class CaseError(Exception):
    """A case that cannot be reported on; the message says which file and why."""


# --- tables ------------------------------------------------------------------


def read_table(path: Path, required: list[str] | tuple[str, ...] = ("time_s",)) -> Table:
    """Columns of a .csv whose first line names them, units included."""
    if not path.is_file():
        raise CaseError(f"{path}: not found")
    text = path.read_text()
    lines = text.splitlines()
    if not lines:
        raise CaseError(f"{path}: empty; expected a header line of column names")
    names = [name.strip() for name in lines[0].lstrip("# ").split(",")]
    missing = [name for name in required if name not in names]
    if missing:
        raise CaseError(
            f"{path}: no column {', '.join(missing)}; the header has {', '.join(names)}"
        )
    if not text.endswith("\n"):
        lines.pop()  # a run that was killed can leave half a line
    rows = []
    for number, line in enumerate(lines[1:], start=2):
        try:
            row = [float(value) for value in line.split(",")]
        except ValueError:
            raise CaseError(f"{path}, line {number}: expected numbers, found '{line}'") from None
        if len(row) != len(names):
            raise CaseError(f"{path}, line {number}: {len(row)} values for {len(names)} columns")
        rows.append(row)
    return dict(zip(names, np.array(rows).reshape(-1, len(names)).T))


def write_table(path: Path, table: Table) -> None:
    """Write columns as .csv, names (with units) in the first line."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(table)
        out.writerows([f"{value:.10g}" for value in row] for row in zip(*table.values()))


def merge_restarts(parts: list[tuple[float, Table, Path]]) -> Table:
    """One table from the parts (start time in s, table, file) of a restarted run.

    A later start overrides what an earlier part holds after that time. Its own line
    for that time, which has no acceleration yet, counts only if no other part has one.
    """
    merged: Table = {}
    for start, table, path in sorted(parts, key=lambda part: part[0]):
        if not merged:
            merged = table
            continue
        if list(table) != list(merged):
            raise CaseError(f"{path}: its columns differ from those of the earlier start times")
        if not table["time_s"].size:
            continue
        # directory names are rounded to timePrecision, hence the tolerance
        keep = merged["time_s"] <= start * (1 + 1e-6)
        later = table["time_s"] > np.max(merged["time_s"][keep], initial=-np.inf) + 1e-6 * abs(start)
        merged = {name: np.concatenate((merged[name][keep], table[name][later])) for name in merged}
    return merged


def gather(case: Path) -> dict[str, Table]:
    """The tables postProcessing/<functionObject>/<startTime>/<name>.csv, by name."""
    found: dict[str, list[tuple[float, Table, Path]]] = {}
    for path in sorted(case.glob("postProcessing/*/*/*.csv")):
        try:
            start = float(path.parent.name)
        except ValueError:
            continue
        table = read_table(path)
        if path.stem in found and found[path.stem][0][2].parents[1] != path.parents[1]:
            raise CaseError(
                f"{path} and {found[path.stem][0][2]}: two function objects write {path.name}; "
                "expected one"
            )
        found.setdefault(path.stem, []).append((start, table, path))
    return {name: merge_restarts(parts) for name, parts in found.items()}


# --- numbers -----------------------------------------------------------------


def crossing(time: np.ndarray, value: np.ndarray, level: float = 0.0, falling: bool = False) -> float:
    """First time (s) at which value passes level, by linear interpolation; nan if it never does."""
    side = (value - level) * (-1 if falling else 1)
    if side.size and side[0] >= 0:
        return float(time[0])
    after = np.flatnonzero(side >= 0)
    if not after.size:
        return float("nan")
    i = after[0]
    return float(time[i - 1] + (time[i] - time[i - 1]) * side[i - 1] / (side[i - 1] - side[i]))


def running_mean(time: np.ndarray, value: np.ndarray, window: float) -> np.ndarray:
    """Mean of the value over a window [s] about each time; shorter where the table begins and ends.

    A row holds the value of the step that ends at its time, as accelerations of trajectory.csv do.
    """
    total = np.concatenate(([0.0], np.cumsum(value[1:] * np.diff(time))))
    low, high = (np.clip(time + shift, time[0], time[-1]) for shift in (-window / 2, window / 2))
    return (np.interp(high, time, total) - np.interp(low, time, total)) / (high - low)


def even_running_mean(value: np.ndarray, rows: float) -> np.ndarray:
    """Centred mean over a number of rows, of a table with even steps; zeros stand before and after it."""
    n = max(1, int(round(rows)))
    return np.convolve(value, np.ones(n) / n, "same")


@dataclass(frozen=True)
class Body:
    """What decides which numbers of a body say something."""

    freedom: str = "free"       # of the scene
    inPlane: bool = False       # forces, masses and volumes are per metre
    up: str = "z"               # of the tables' axes; y in the plane of particles
    width: float = 0.0          # largest, across the axis [m]
    area: float = 0.0           # frontal [m2], in the plane [m2/m]; 0: not known
    pressure: float = 0.0       # of the stream at the start, rho U2/2 [Pa]; 0: not known, or from rest

    @property
    def driven(self) -> bool:
        """Does it move as prescribed, or not at all, whatever the fluids do?"""
        return self.freedom in ("fixed", "prescribed")

    @property
    def turns(self) -> bool:
        return self.freedom in ("planar", "free")

    @property
    def force(self) -> str:
        """Unit of its forces"""
        return "N/m" if self.inPlane else "N"


def read_body(case: Path) -> Body:
    """The body that plungeCase has set up; without that, one that is free, in space."""
    given = parameters(case)
    if "freedom" not in given:
        return Body()
    width = float(given["bodyLength"]) * float(given["thicknessRatio"])
    plane = given["model"] == "plane"
    area = width if plane else 0.0 if given["shape"] == "surface" else np.pi / 4 * width**2
    up = "y" if given["model"] in ("plane", "axisymmetric") and given["application"] == "plungeSPH" else "z"
    return Body(given["freedom"], plane, up, width, area, 0.5 * float(given["liquidDensity"]) * float(given["speed"]) ** 2)


def fluid_force(trajectory: Table) -> np.ndarray:
    """What the fluids do to the whole body (3, n): pressure and friction, in N, in the plane N/m."""
    return np.array([trajectory[f"Fp{c}_N"] + trajectory[f"Fv{c}_N"] for c in "xyz"])


def incidence(trajectory: Mapping[str, np.ndarray]) -> np.ndarray:
    """Angle between the body's axis and its path [deg], whichever end leads; 0 above the surface and where the body is slower than a
    twentieth of its highest speed."""
    speed = trajectory["speed_m_s"]
    if "v1_m_s" not in trajectory:
        return np.zeros(speed.size)
    counts = (trajectory["penetration_m"] > 0) & (speed > 0.05 * speed.max())
    across = np.hypot(trajectory["v2_m_s"], trajectory["v3_m_s"])
    return np.where(counts, np.degrees(np.arctan2(across, np.abs(trajectory["v1_m_s"]))), 0.0)


def attitude_notes(trajectory: Mapping[str, np.ndarray]) -> list[str]:
    """What is to be said of a body that has turned far: its decelerations are along its axis, and its pitch is an elevation."""
    notes, most, pitch = [], float(incidence(trajectory).max()), trajectory["pitch_deg"]
    if most > TURNED:
        notes.append(f"Decelerations are those along the body's axis, which stood at up to {most:.0f} deg to its path: accelerations are in trajectory.csv (ax, ay, az)")
    if np.abs(pitch).max() > 85 and np.ptp(pitch) > TURNED:
        notes.append("The pitch is the elevation of the axis, -90 to 90 deg, and has come to its end: its change is not the angle by which the body turned")
    return notes


def key_numbers(trajectory: Table, ledger: Table | None, extent: Table, body: Body = Body()) -> Quantities:
    """What the summary reports: of a body that starts in the liquid no contact, of one that is driven no loss of speed, of one that
    cannot turn no pitch.

    extent: time_s, low_m and high_m of the body, from its surface at the written times.
    """
    time, speed = trajectory["time_s"], trajectory["speed_m_s"]
    dry = trajectory["penetration_m"][0] < 0  # at the start
    emerged = extent["high_m"][0] > 0
    contact = crossing(time, trajectory["penetration_m"]) if dry else float("nan")
    # A start-up transient before contact is no impact; it is reported apart. In the liquid the first steps bring the start's flow into
    # that of the discrete equations: an impulse, whose force is the larger the shorter they are
    wet = time >= contact if np.isfinite(contact) else np.arange(time.size) > min(STARTING, time.size - 2)
    slow = trajectory["deceleration_m_s2"]
    peak = int(np.argmax(np.where(wet, slow, -np.inf)))
    force = np.linalg.norm(fluid_force(trajectory), axis=0)
    strongest = int(np.argmax(np.where(wet, force, -np.inf)))
    immersion = crossing(extent["time_s"], extent["high_m"], falling=True)
    # Later peaks are those of friction and form, which grow with the wetted part
    height = float(extent["high_m"][0] - extent["low_m"][0])
    early = wet & np.isfinite(contact) & (trajectory["penetration_m"] <= IMPACT * height)
    impact = int(np.argmax(np.where(early, slow, -np.inf)))

    def at(name: str, when: float) -> float:
        return float(np.interp(when, time, trajectory[name])) if np.isfinite(when) else float("nan")

    numbers: Quantities = {}
    if dry:
        numbers["contact time"] = (contact, "s")
    if emerged:
        numbers["full immersion time"] = (immersion, "s")
    numbers["end time"] = (float(time[-1]), "s")
    numbers["initial speed"] = (float(speed[0]), "m/s")
    if not body.driven:
        if dry:
            numbers["impact deceleration"] = (float(slow[impact]) if early.any() else float("nan"), "m/s2")
            numbers["time of impact deceleration"] = (float(time[impact]) if early.any() else float("nan"), "s")
        numbers["peak deceleration"] = (float(slow[peak]), "m/s2")
        numbers["peak deceleration in g"] = (float(slow[peak]) / G0, "g")
        numbers["time of peak deceleration"] = (float(time[peak]), "s")
        if dry:
            numbers["largest |deceleration| before contact"] = (float(np.max(np.abs(slow[~wet]), initial=0.0)), "m/s2")
    numbers["peak force"] = (float(force[strongest]), body.force)
    numbers["time of peak force"] = (float(time[strongest]), "s")
    if body.area and body.pressure:
        numbers["peak force coefficient"] = (float(force[strongest]) / (body.pressure * body.area), "-")
    if not body.driven:
        if emerged:
            numbers["velocity lost at full immersion"] = (float(speed[0]) - at("speed_m_s", immersion), "m/s")
        numbers["velocity lost at end"] = (float(speed[0] - speed[-1]), "m/s")
        if body.turns:
            if emerged:
                numbers["pitch change at full immersion"] = (at("pitch_deg", immersion) - float(trajectory["pitch_deg"][0]), "deg")
            numbers["pitch change at end"] = (float(trajectory["pitch_deg"][-1] - trajectory["pitch_deg"][0]), "deg")
    numbers["penetration at end"] = (float(trajectory["penetration_m"][-1]), "m")
    if ledger is not None and ledger["time_s"].size:
        error = ledger["error_percent_of_body_volume"]
        numbers["max |volume ledger error|"] = (float(np.max(np.abs(error))), "% of body volume")
        numbers["volume ledger error at end"] = (float(error[-1]), "% of body volume")
    return numbers


_ADDED_MASS = {  # by row and column of the tensor in body axes: forward, to the side, dorsal, then about them
    (0, 0): ("along the axis", "mass"), (1, 1): ("to the side", "mass"), (2, 2): ("across the axis", "mass"), (4, 4): ("in pitch", "inertia"),
}


def added_mass(case: Path) -> Quantities:
    """What the fluids added to the whole body's mass and inertia as plungeFoam has computed it last, where it has: uniform/addedMass
    of the latest time, of the motions that the body is free to make."""
    given = parameters(case)
    files = [path for part in (case, case / "processor0") for path in part.glob("*/uniform/addedMass")]
    if not files or "bodyMass" not in given:
        return {}
    latest = max(files, key=lambda path: float(path.parents[1].name))
    found = re.search(r"tensor\s+36\s*\(([^)]*)\)", latest.read_text(errors="replace"))
    if not found:
        return {}
    tensor = np.array(found[1].split(), float).reshape(6, 6) * float(given["bodyMass"]) / float(given["modelledMass"])
    displaced = float(given["liquidDensity"]) * float(given["bodyVolume"])
    per = "/m" if given["model"] == "plane" else ""
    numbers: Quantities = {}
    for (row, column), (direction, kind) in _ADDED_MASS.items():
        value = float(tensor[row, column])
        if value:
            numbers[f"added {kind} {direction} at end"] = (value, f"kg{per}" if kind == "mass" else f"kg m2{per}")
            if kind == "mass":
                numbers[f"added {kind} {direction} at end, over displaced mass"] = (value / displaced, "-")
    return numbers


NOTE = "note"
MODELS = "models"


def write_numbers(path: Path, numbers: Quantities, models: str = "", notes: Sequence[str] = ()) -> None:
    """Write quantity,value,unit lines; then the models and notes, if any, as models,<text>, and note,<text>,"""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(("quantity", "value", "unit"))
        out.writerows((name, f"{value:.6g}", unit) for name, (value, unit) in numbers.items())
        out.writerows((MODELS, text, "") for text in [models] if text)
        out.writerows((NOTE, text, "") for text in notes)


def _summary_rows(path: Path) -> list[dict[str, str]]:
    if not path.is_file():
        raise CaseError(f"{path}: not found; run plungePost on its case first")
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def read_numbers(path: Path) -> Quantities:
    """The numbers that write_numbers wrote."""
    return {row["quantity"]: (float(row["value"]), row["unit"]) for row in _summary_rows(path)
            if row["quantity"] not in (MODELS, NOTE)}


def read_notes(path: Path) -> list[str]:
    """The notes that write_numbers wrote."""
    return [row["value"] for row in _summary_rows(path) if row["quantity"] == NOTE]


# --- the case's own description ----------------------------------------------


def entry(case: Path, dictionary: str, keyword: str) -> str:
    """Value of an entry of one of the case's dictionaries, read by foamDictionary."""
    try:
        run = subprocess.run(
            ["foamDictionary", str(case / dictionary), "-entry", keyword, "-value"],
            capture_output=True, text=True,
        )
    except FileNotFoundError:
        raise CaseError("foamDictionary: not found; source the OpenFOAM environment (etc/bashrc)") from None
    if run.returncode:
        why = " ".join((run.stderr or run.stdout).split())
        if "mandatory etc entry" in why:
            why = "the OpenFOAM environment is not sourced (etc/bashrc)"
        raise CaseError(f"{case / dictionary}: cannot read entry '{keyword}': {why}")
    return run.stdout.strip()


def liquid_name(case: Path) -> str:
    """Name of the first of the two phases; its volume fraction is alpha.<name>."""
    return entry(case, "constant/transportProperties", "phases").strip("()").split()[0]


def _mesh_directories(case: Path) -> list[Path]:
    """polyMesh directories: the case's own or, where it has none, those of the processors."""
    own = case / "constant/polyMesh"
    parts = [own] if (own / "boundary").is_file() else sorted(case.glob("processor*/constant/polyMesh"))
    if not parts:
        raise CaseError(f"{own}: no mesh")
    return parts


def patch_types(case: Path) -> dict[str, str]:
    """Patch name -> type, in the mesh's order."""
    text = (_mesh_directories(case)[0] / "boundary").read_text(errors="replace")
    types = dict(re.findall(r'^\s*"?([^\s"{}();]+)"?\s*\{[^{}]*?\btype\s+(\w+);', text, re.MULTILINE))
    return {name: kind for name, kind in types.items() if name != "FoamFile" and kind != "processor"}


def cell_count(case: Path) -> int:
    """Number of cells of the composite mesh, holes and overlap included."""
    total = 0
    for mesh in _mesh_directories(case):
        with (mesh / "owner").open("rb") as file:
            note = re.search(rb"nCells:\s*(\d+)", file.read(2000))
        if not note:
            raise CaseError(f"{mesh / 'owner'}: its header does not say nCells")
        total += int(note.group(1))
    return total


PARAMETERS = "system/plungeGenerated"  # written by plungeCase


def parameters(case: Path) -> dict[str, str]:
    """Entries of plungeGenerated as they are written; none where plungeCase has not set the case up."""
    path = case / PARAMETERS
    return dict(re.findall(r"^(\w+)\s+(.+);$", path.read_text(), re.M)) if path.is_file() else {}


def solver_name(case: Path) -> str:
    """The solver that the case is for: plungeSPH has particles, slenderBody has strips, any other a mesh."""
    return entry(case, "system/controlDict", "application")


def solver_log(case: Path) -> str:
    """What the solver has printed, over restarts."""
    path = case / f"log.{solver_name(case)}"
    if not path.is_file():
        raise CaseError(f"{path}: not found; has the case's Allrun run?")
    return path.read_text(errors="replace")


@dataclass(frozen=True)
class Scene:
    """What the solver models, and notes: those of plungeCase on the scene, and the solver's on what it leaves out."""

    models: str = ""
    notes: tuple[str, ...] = ()


def read_scene(case: Path) -> Scene:
    """What the log says under Scene, at the latest start, with the notes of all runs on what they have shown (under Run, at a run's end);
    empty where it says nothing or is not kept."""
    if not (case / f"log.{solver_name(case)}").is_file():
        return Scene()
    log, generated = solver_log(case), case / PARAMETERS
    warned = foamDictionary.read(generated).get("notes", []) if generated.is_file() else []
    blocks = re.findall(r"^Scene\n((?:    .*\n)+)", log, re.M)
    if not blocks:
        return Scene(notes=tuple(warned))
    models = re.search(r"^    models +: (.+)", blocks[-1], re.M)
    # What a run has shown holds for all that went before, too
    shown = re.findall(r"^(?:Run\n +)?Note: (.*\S)", log, re.M)
    return Scene(models[1].strip() if models else "", tuple(dict.fromkeys([*shown, *warned, *re.findall(r"^    Note: (.*\S)", blocks[-1], re.M)])))


def particle_counts(case: Path) -> tuple[int, int]:
    """Particles of the fluid and of walls at the start."""
    found = re.search(r"^Start: (\d+) of the fluid, (\d+) of walls", solver_log(case), re.M)
    if not found:
        raise CaseError(f"{case}/log.plungeSPH: no line 'Start: ... of the fluid'; has the solver started?")
    return int(found[1]), int(found[2])


def cpu_seconds(run: Path) -> float:
    """CPU time of the solver [s], over restarts: of the master rank, or of all threads."""
    starts = (re.findall(r"^ExecutionTime = (\S+) s", log, re.M) for log in solver_log(run).split("Build  :"))
    return sum(float(times[-1]) for times in starts if times)


def rate(case: Path) -> str:
    """What a run on meshes took, in words: CPU time, time steps, cells, and how many of these pass through a step in a second on one core;
    empty where its log does not say."""
    try:
        cells, steps = cell_count(case), len(re.findall(r"^Time = ", solver_log(case), re.M))
        cpu = int(parameters(case).get("cores", 1)) * cpu_seconds(case)
    except CaseError:
        return ""
    if not steps or not cpu:
        return ""
    return f"{cpu / 60:.3g} min of CPU time, {steps:,} steps of {cells:,} cells: {cells * steps / cpu:,.0f} cells x steps per second and core"


def scene_name(case: Path) -> str:
    """The fluids (titan, water, ...), where plungeCase has set the case up; else empty."""
    return entry(case, PARAMETERS, "fluids") if (case / PARAMETERS).is_file() else ""


def describe(case: Path) -> str:
    """One line that names the case: directory, body and how it moves, fluids, model, tier and cells or particles."""
    words = [case.resolve().name]
    given = parameters(case)
    if given and "bodyLength" in given:
        length, speed, angle = (float(given[name]) for name in ("bodyLength", "speed", "pathAngle"))
        freedom = given.get("freedom", "free")
        way = f"at {speed:.4g} m/s and {angle:g} deg" if speed else "fixed" if freedom == "fixed" else "from rest"
        words += [f"{given.get('shape', 'body')} of {length:.4g} m {way}{', prescribed' if freedom == 'prescribed' else ''}",
                  f"fluids {given['fluids']}", f"{given['model']} model", f"tier {given['tier']}"]
        if float(given["resolution"]) != 1:
            words.append(f"resolution {given['resolution']}")
    if solver_name(case) == "plungeSPH":
        words.append(f"{particle_counts(case)[0]:,} particles of liquid")
    elif solver_name(case) == "slenderBody":
        words += ["slender body by strips", f"boundary layer {given.get('boundaryLayer')}"]
    else:
        layer = given.get("boundaryLayer")
        words += [*([f"boundary layer {layer}"] if layer else []), f"{cell_count(case):,} cells"]
    return ", ".join(words)
