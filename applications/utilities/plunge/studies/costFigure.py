# SPDX-License-Identifier: GPL-3.0-or-later
"""Error against CPU time: what a study's accuracy costs."""

from __future__ import annotations

from pathlib import Path
from typing import Sequence

from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row


def errorAgainstCost(title: str, rows: Sequence[Row], file: Path) -> None:
    """Of judged figures whose reference is a number: how far they are off it, over its value where it has one; none, no figure."""
    points: dict[tuple[str, ...], list[tuple[float, float]]] = {}
    for row in rows:
        if isinstance(row.reference, (int, float)) and row.cpu_s and row.verdict in ("", "yes", "no"):
            error = abs(row.value - row.reference)/(abs(row.reference) or 1)
            points.setdefault((row.quantity, row.method, row.variant), []).append((float(row.cpu_s), error))
    points = {name: sorted(of) for name, of in points.items() if len(of) > 1}
    if not points:
        return
    picture, axes = pyplot.subplots(figsize=(9, 5), layout="constrained")
    for name, of in points.items():
        axes.loglog(*zip(*of), "o-", label=", ".join(filter(None, name)))
    axes.set(xlabel="CPU time [s]", ylabel="error over the reference", title=title)
    axes.grid(alpha=0.3)
    axes.legend(fontsize="x-small", loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False)
    picture.savefig(file, dpi=90)
    pyplot.close(picture)
