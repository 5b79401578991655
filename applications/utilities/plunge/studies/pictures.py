# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of studies; matplotlib's pyplot, which needs no display here."""

from __future__ import annotations

from math import ceil
from pathlib import Path
from typing import Any, Mapping, Sequence

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot  # noqa: E402

from plunge.studies.signals import Signal  # noqa: E402

Curves = Mapping[str, Signal]


def draw(file: Path, panels: Sequence[tuple[Mapping[str, Any], Curves, Curves]], columns: int = 1) -> None:
    """Panels side by side, each of what its axes are set to, the measured curves, in grey, and the computed ones."""
    rows = ceil(len(panels)/columns)
    picture, axes = pyplot.subplots(rows, columns, figsize=(8 if columns == 1 else 6*columns, 4.5*rows), layout="constrained", squeeze=False)
    for axis, (settings, measured, computed) in zip(axes.flat, panels):
        for (name, signal), style in zip(measured.items(), ("o", "-", "--", "-.", ":", "s")):
            axis.plot(*signal, style, color="0.5", markersize=3, label=name)
        for name, signal in computed.items():
            axis.plot(*signal, linewidth=0.9, label=name)
        axis.set(**settings)
        axis.legend(fontsize="small")
    for axis in axes.flat[len(panels):]:
        axis.axis("off")
    picture.savefig(file, dpi=90)
    pyplot.close(picture)
