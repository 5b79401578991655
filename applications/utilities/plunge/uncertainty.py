# SPDX-License-Identifier: GPL-3.0-or-later
"""How sure the headline numbers of a dive are: the table that the study diveUncertainty measures."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from math import floor, isclose, isfinite, log10
from pathlib import Path

from plunge.results import CaseError, Quantities, parameters

TABLE = "constant/uncertainty.csv"  # plungeCase copies it from the case into its runs
STUDY = "validation/run diveUncertainty"
NOT_MEASURED = "Uncertainty: not measured. The same scene with -resolution 2 tells how much the mesh, or the spacing, matters."
HEADLINES = ("impact deceleration", "peak deceleration", "velocity lost at full immersion", "full immersion time",
             "pitch change at full immersion")
CAUSES = {"mesh": "mesh_uncertainty", "time step": "time_uncertainty", "boundary layer": "boundary_layer_uncertainty"}

# Entries of plungeGenerated. An uncertainty holds for dives that have all of them in common; the first ones name a dive.
NAMED = ("fluids", "tier", "model", "mesh", "resolution", "boundaryLayer")
FLUIDS = ("liquidDensity", "liquidViscosity", "gasDensity", "gravity")
CONDITIONS = NAMED + ("application", "transitionReynolds", "bodyLength", "thicknessRatio", "bodyMass", "bodyMomentOfInertia",
                      "centreOfMassFromNose", "speed", "pathAngle", "gap", "diveDuration", *FLUIDS)
# What else names the dive that was measured: entries that have no column, since all rows have them in common
IMPLIED = {"shape": "NACA", "freedom": "free", "angularMomentum": "(0 0 0)"}
COLUMNS = CONDITIONS + ("quantity", "value", "unit", *CAUSES.values(), "total_uncertainty", "version", "date")


@dataclass(frozen=True)
class Uncertainty:
    """Of a number, in its unit: what each of CAUSES gives, and the root of the sum of their squares."""

    total: float
    parts: dict[str, float]

    def text(self, value: float, unit: str, scale: float = 1) -> str:
        """The number, how sure it is and why, in a unit that is 1/scale of its own."""
        total, decimals = two_digits(scale * self.total)
        causes = ", ".join(f"{cause} {two_digits(scale * part)[0]}" for cause, part in self.parts.items())
        return f"{scale * value:.{decimals}f} {unit} +- {total} ({causes})"


def two_digits(uncertainty: float) -> tuple[str, int]:
    """An uncertainty in two significant digits, and how many decimals a number has that goes with it."""
    if not uncertainty > 0:
        return f"{uncertainty:g}", 3
    rounded = float(f"{uncertainty:.1e}")
    decimals = max(0, 1 - floor(log10(rounded)))
    return f"{rounded:.{decimals}f}", decimals


def conditions(case: Path) -> dict[str, str]:
    """What the uncertainty of a dive depends on; an entry that its case lacks is empty."""
    given = parameters(case)
    return {name: given.get(name, "") for name in CONDITIONS}


def read_rows(path: Path) -> list[dict[str, str]]:
    """The table's rows; none where there is no table."""
    if not path.is_file():
        return []
    try:
        with path.open(newline="") as file:
            table = csv.DictReader(file)
            missing = [name for name in COLUMNS if name not in (table.fieldnames or ())]
            rows = list(table)
    except UnicodeDecodeError:
        raise CaseError(f"{path}: no text; expected a table that {STUDY} has written") from None
    if missing:
        raise CaseError(f"{path}: no column {', '.join(missing)}; expected a table that {STUDY} has written")
    for number, row in enumerate(rows, start=2):
        if None in row or None in row.values():
            raise CaseError(f"{path}, line {number}: expected a value for each of its {len(COLUMNS)} columns")
    return rows


def same(one: str, other: str) -> bool:
    try:
        return isclose(float(one), float(other), rel_tol=1e-6)
    except ValueError:
        return one == other


def short(entry: str) -> str:
    """A number in as many digits as a reader needs."""
    try:
        return f"{float(entry):.6g}"
    except ValueError:
        return entry


def read_uncertainties(case: Path) -> tuple[dict[str, Uncertainty], str]:
    """Those that were measured for this dive, by the number's name, and a sentence on what they hold for."""
    here, rows, given = conditions(case), read_rows(case / TABLE), parameters(case)
    if not rows:
        return {}, NOT_MEASURED
    other = [name for name, value in IMPLIED.items() if given.get(name, value) != value]
    if given.get("forward") != given.get("heading"):
        other.append("heading")

    def differing(row: dict[str, str]) -> list[str]:
        return [name for name in CONDITIONS if not same(here[name], row[name])]

    nearest = min(map(differing, rows), key=len)
    if "fluids" in nearest:
        nearest = [name for name in nearest if name not in FLUIDS]
    nearest += other
    if "application" in nearest:  # the rest follows from it
        nearest = ["application"]
    if nearest:
        only = ", ".join(f"{name} {' or '.join(dict.fromkeys(row[name] for row in rows))}" for name in NAMED)
        ours = ", ".join(f"{name} {short({**given, **here}[name]) or 'unknown'}" for name in nearest)
        ends = f"; {STUDY} -tier {here['fluids']} measures it" if nearest == ["fluids"] else ""
        return {}, f"Uncertainty: measured for the default dive, {only} only, not for {ours}{ends}."

    found: dict[str, Uncertainty] = {}
    version = ""
    for row in (row for row in rows if not differing(row)):
        try:
            measured = Uncertainty(float(row["total_uncertainty"]), {cause: float(row[column]) for cause, column in CAUSES.items()})
        except ValueError:
            measured = Uncertainty(-1, {})
        if not all(isfinite(part) and part >= 0 for part in (measured.total, *measured.parts.values())):
            raise CaseError(f"{case / TABLE}, {row['quantity']}: expected a number, 0 or above, as each uncertainty")
        if row["quantity"] not in HEADLINES:
            raise CaseError(f"{case / TABLE}: quantity {row['quantity']}; expected one of {', '.join(HEADLINES)}")
        found[row["quantity"]] = measured
        version = f"{row['version']} of {row['date']}"
    return found, f"+-: root of the sum of the squares of its parts; the study diveUncertainty, version {version}."


def with_uncertainties(numbers: Quantities, uncertainties: dict[str, Uncertainty]) -> Quantities:
    """The numbers, each followed by its uncertainty where there is one."""
    found: Quantities = {}
    for name, (value, unit) in numbers.items():
        found[name] = (value, unit)
        if name in uncertainties:
            found[f"{name}: uncertainty"] = (uncertainties[name].total, unit)
    return found
