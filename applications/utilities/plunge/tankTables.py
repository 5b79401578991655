# SPDX-License-Identifier: GPL-3.0-or-later
"""What is measured in a tank: the same tables of both methods, in the scene's axes (z up)."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from plunge import foamDictionary
from plunge.results import CaseError, Table, gather, merge_restarts

GENERATED = "system/plungeGenerated"
# A cell is of the liquid from this volume fraction on
_WET = 0.5
# Columns of plungeSPH in the plane, where it has y for z
_UPWARDS = re.compile(r"_(U|F)y_")


def tables(run: Path) -> dict[str, Table]:
    """gauges: heights of the surface; probes: pressure, velocity and the liquid's share; walls: forces on them, in the plane of a metre;
    of particles also energy."""
    given = foamDictionary.read(run / GENERATED)
    if given.get("scene") != "tank":
        raise CaseError(f"{run / GENERATED}: expected the case of a tank")
    if given["application"] == "plungeSPH":
        found = gather(run)
        if given["model"] == "plane":
            found = {name: {_UPWARDS.sub(r"_\1z_", column): values for column, values in table.items()} for name, table in found.items()}
        return found
    return _of_mesh(run, given)


def _numbers(path: Path, first: int) -> list[tuple[float, np.ndarray]]:
    """Rows of a table of OpenFOAM's, whose vectors are in brackets; half a line that a kill has left goes."""
    rows = []
    for line in path.read_text().splitlines():
        if not line.lstrip().startswith("#"):
            values = np.array(re.sub(r"[()]", " ", line).split(), float)
            if not rows or len(values) == len(rows[0][1]) + 1:
                rows.append((float(values[0]), values[1:]))
    return rows


def _merged(run: Path, name: str, file: str, columns: list[str]) -> Table:
    """A function object's file over restarts"""
    parts = []
    for path in (run / "postProcessing" / name).glob(f"*/{file}"):
        rows = _numbers(path, len(columns))
        values = np.array([row for _, row in rows]).reshape(len(rows), -1)[:, :len(columns)]
        table = {"time_s": np.array([time for time, _ in rows]), **dict(zip(columns, values.T))}
        parts.append((float(path.parent.name), table, path))
    if not parts:
        raise CaseError(f"{run / 'postProcessing' / name}: no {file}; has the solver run?")
    return merge_restarts(parts)


def _height(shares: np.ndarray, heights: np.ndarray, foot: float) -> float:
    """Of the highest surface in a column of cells, above a gauge at `foot` [m]; 0 where it is dry"""
    wet = np.flatnonzero(shares >= _WET)
    if not wet.size:
        return 0.0
    top = wet[-1]
    if top + 1 == len(shares):
        return float(heights[top] - foot)
    part = (shares[top] - _WET) / (shares[top] - shares[top + 1])
    return float(heights[top] + part * (heights[top + 1] - heights[top]) - foot)


def _locations(path: Path) -> np.ndarray:
    """Of probes, from the header of their file"""
    return np.array(re.findall(r"^# Probe \d+ \((\S+) (\S+) (\S+)\)", path.read_text(), re.M), float)


def _of_mesh(run: Path, given: dict) -> dict[str, Table]:
    scene = foamDictionary.read(run / "constant/scene")
    unit, per = ("N_m", given["cellSpacing"]) if given["model"] == "plane" else ("N", 1.0)
    found: dict[str, Table] = {}
    for name, place in scene.get("gauges", {}).items():
        folder = run / "postProcessing" / f"gauge_{name}"
        files = sorted(folder.glob("*/alpha.liquid"))
        if not files:
            raise CaseError(f"{folder}: no alpha.liquid; has the solver run?")
        heights = _locations(files[0])[:, 2]
        column = _merged(run, f"gauge_{name}", "alpha.liquid", [str(i) for i in range(len(heights))])
        shares = np.column_stack([values for key, values in column.items() if key != "time_s"])
        gauges = found.setdefault("gauges", {"time_s": column["time_s"]})
        gauges[f"{name}_m"] = np.array([_height(row, heights, place[-1]) for row in shares])
    if "probes" in scene:
        names = list(scene["probes"])
        pressure = _merged(run, "probes", "p", names)
        velocity = _merged(run, "probes", "U", [f"{name}_U{c}" for name in names for c in "xyz"])
        share = _merged(run, "probes", "alpha.liquid", names)
        probes = found["probes"] = {"time_s": pressure["time_s"]}
        axes = "xz" if given["model"] == "plane" else "xyz"
        for name in names:
            probes[f"{name}_p_Pa"] = pressure[name]
            probes.update({f"{name}_U{c}_m_s": velocity[f"{name}_U{c}"] for c in axes})
            probes[f"{name}_share"] = share[name]
    axes = "xz" if given["model"] == "plane" else "xyz"
    for name in (*scene.get("obstacles", {}), "tank"):
        force = _merged(run, f"walls_{name}", "force.dat", list("xyz"))
        walls = found.setdefault("walls", {"time_s": force["time_s"]})
        walls.update({f"{name}_F{c}_{unit}": force[c] / per for c in axes})
    return found
