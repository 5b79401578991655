# SPDX-License-Identifier: GPL-3.0-or-later
"""The table that every study leaves, result.csv: a row for each figure, its verdict, and whether it still holds for this checkout."""

from __future__ import annotations

import csv
import subprocess
from dataclasses import asdict, dataclass, fields
from functools import lru_cache
from math import isfinite
from pathlib import Path
from typing import Iterable, Sequence, Union

from plunge.studies import REPOSITORY

# What a study writes itself does not make a checkout another version
WRITTEN = (":!docs", ":!*/result.csv", ":!*/uncertainty.csv")
Cell = Union[str, int, float, None]
# Verdicts: of numbers yes and no, of runs that may end in any way the others (outcomes.py)
HOLD, FAIL = ("yes", "right", "degraded", "refused"), ("no", "silent", "crash", "hang")


@dataclass
class Row:
    """A figure. reference is a number, or a bound: "<= 4", ">= 100". Empty cells are None."""

    study: str
    scene: str
    method: str
    variant: str
    resolution: str
    cells: Cell
    steps: Cell
    quantity: str
    value: float
    unit: str
    reference: Cell = None
    reference_uncertainty: Cell = None
    numerical_uncertainty: Cell = None
    tolerance: Cell = None
    verdict: str = ""       # of HOLD or FAIL, or empty where nothing is judged
    cpu_s: Cell = None
    cores: Cell = None
    version: str = ""
    date: str = ""

    @property
    def key(self) -> tuple[str, ...]:
        return self.scene, self.method, self.variant, self.resolution, self.quantity


COLUMNS = tuple(field.name for field in fields(Row))


def verdict(value: float, reference: Cell, reference_uncertainty: Cell = None, numerical_uncertainty: Cell = None,
            tolerance: Cell = None) -> str:
    """Of a figure: yes where it is off by no more than the reference's uncertainty and the tolerance, and known as well as that.

    The mesh's uncertainty excuses nothing: a figure that is less sure than what is allowed is not shown to hold."""
    if reference is None or not isinstance(reference, str) and reference_uncertainty is None and tolerance is None:
        return ""
    if isinstance(reference, str):
        sign, bound = reference.split()
        return "yes" if (value <= float(bound) if sign == "<=" else value >= float(bound)) else "no"
    allowed = float(reference_uncertainty or 0) + float(tolerance or 0)
    return "yes" if isfinite(value) and abs(value - float(reference)) <= allowed and float(numerical_uncertainty or 0) <= allowed else "no"


def count(verdicts: Iterable[str]) -> tuple[int, int]:
    """How many hold of how many that are judged."""
    judged = [verdict for verdict in verdicts if verdict]
    return sum(verdict in HOLD for verdict in judged), len(judged)


def text(cell: Cell) -> str:
    """Floats in six digits."""
    return "" if cell is None else f"{cell:.6g}" if isinstance(cell, float) else str(cell)


def read(path: Path) -> list[dict[str, str]]:
    """Rows of a .csv file; lines that begin with # are comments."""
    with path.open(newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def write(path: Path, rows: Iterable[Row], keep: Iterable[tuple[str, ...]] = ()) -> None:
    """Writes the rows, in place of those with their keys; of the others, those of the runs in `keep` (keys without the quantity) stay."""
    found = [{name: text(cell) for name, cell in asdict(row).items()} for row in rows]
    made = {(*(row[name] for name in ("scene", "method", "variant", "resolution")),) for row in found}
    kept = [row for row in (read(path) if path.exists() else [])
            if (run := (row["scene"], row["method"], row["variant"], row["resolution"])) in set(keep) and run not in made]
    with path.open("w", newline="") as file:
        out = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        out.writeheader()
        out.writerows(kept + found)


def markdown(header: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """A table for a document."""
    return ["| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |" for cells in (header, ["---"]*len(header), *rows)]


def git(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["git", *words], cwd=REPOSITORY, capture_output=True, text=True)


def software_version() -> str:
    """git's name of what is run, with -dirty where the checkout has been changed."""
    name = git("describe", "--always").stdout.strip() or "unknown"
    return name + ("-dirty" if git("diff", "--quiet", "HEAD", "--", ".", *WRITTEN).returncode else "")


@lru_cache(maxsize=None)
def state(version: str, paths: tuple[str, ...]) -> str:
    """Of a row: empty where it holds for this checkout, else why it may not: stale | changed checkout | unknown version."""
    if version.endswith("-dirty"):
        return "changed checkout"
    if not version or git("cat-file", "-e", f"{version}^{{commit}}").returncode:
        return "unknown version"
    return "stale" if git("diff", "--quiet", version, "--", *paths).returncode else ""


def line(row: Row) -> str:
    """For a reader."""
    where = " ".join(part for part in (row.scene, row.method, row.variant, row.resolution) if part)
    said = f"  {text(row.value)} {row.unit}".ljust(24)
    if row.verdict:
        off = [f"+- {text(cell)}" for cell in (row.reference_uncertainty, row.tolerance) if cell]
        said += f"  expected {text(row.reference)} {' '.join(off)}: {'holds' if row.verdict in HOLD else 'FALLS SHORT'}"
        said += f" ({row.verdict})" if row.verdict not in ("yes", "no") else ""
    if row.numerical_uncertainty is not None:
        said += f"  (numerical +- {text(row.numerical_uncertainty)})"
    return f"    {where:50s} {row.quantity:60s}{said}"
