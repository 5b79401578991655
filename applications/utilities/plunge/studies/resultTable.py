# SPDX-License-Identifier: GPL-3.0-or-later
"""The table that every validation leaves: result.csv, one row for each figure."""
import csv
import subprocess
from datetime import date
from pathlib import Path
from typing import Callable, Dict, List, NamedTuple, Sequence, Union

COLUMNS = ("quantity", "value", "unit", "reference", "tolerance", "holds", "cpu_s", "version", "date")


class Row(NamedTuple):
    """A figure; reference, tolerance and holds (yes or no) are empty where it is not judged."""
    quantity: str
    value: Union[str, float]
    unit: str
    reference: Union[str, float] = ""
    tolerance: Union[str, float] = ""
    holds: str = ""
    cpu_s: Union[str, float] = ""


def judge(quantity: str, value: float, unit: str, reference: float, tolerance: float, cpu_s: Union[str, float] = "") -> Row:
    """A figure that should differ from its reference by the tolerance at most."""
    return Row(quantity, value, unit, reference, tolerance, "yes" if abs(value - reference) <= tolerance else "no", cpu_s)


def limit(quantity: str, value: float, unit: str, most: float, cpu_s: Union[str, float] = "") -> Row:
    """A figure that should not exceed a limit."""
    return Row(quantity, value, unit, f"at most {most:g}", 0, "yes" if value <= most else "no", cpu_s)


def least(quantity: str, value: float, unit: str, fewest: float, cpu_s: Union[str, float] = "") -> Row:
    """A figure that should reach a limit."""
    return Row(quantity, value, unit, f"at least {fewest:g}", 0, "yes" if value >= fewest else "no", cpu_s)


def software_version(folder: Path) -> str:
    """git's name of what was run."""
    return subprocess.run(["git", "describe", "--always", "--dirty"], cwd=folder, check=True, capture_output=True,
                          text=True).stdout.strip()


def text(value: Union[str, float]) -> str:
    """A cell of the table: floats in four digits."""
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def read(path: Path) -> List[Dict[str, str]]:
    """Rows of a .csv file; lines that begin with # are comments."""
    with path.open(newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def markdown(header: Sequence[str], rows: Sequence[Sequence[str]]) -> List[str]:
    """A table for a document."""
    return ["| " + " | ".join(cells) + " |" for cells in (header, ["---"]*len(header), *rows)]


def write(path: Path, rows: List[Row], keep: Callable[[str], bool] = lambda quantity: False) -> None:
    """Write the table; rows of an earlier one are kept where keep(quantity) says so."""
    stamp = [software_version(path.resolve().parent), date.today().isoformat()]
    kept = [list(row.values()) for row in read(path) if keep(row["quantity"])] if path.exists() else []
    with path.open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(COLUMNS)
        out.writerows(kept)
        out.writerows([text(cell) for cell in row] + stamp for row in rows)


def show(rows: List[Row]) -> None:
    """Print the figures for a reader."""
    for row in rows:
        verdict = f"  expected {text(row.reference)}" + (f" +- {text(row.tolerance)}" if row.tolerance not in ("", 0) else "") \
            + f": {'holds' if row.holds == 'yes' else 'FALLS SHORT'}" if row.holds else ""
        print(f"{row.quantity:90s} {text(row.value):>11s} {row.unit}{verdict}")
