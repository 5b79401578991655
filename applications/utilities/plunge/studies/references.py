# SPDX-License-Identifier: GPL-3.0-or-later
"""Published data: validation/references/<source>/*.csv, whose first lines, with #, say where they are from and how sure they are."""

from __future__ import annotations

from typing import Any

import numpy as np

from plunge.studies import REPOSITORY

REFERENCES = REPOSITORY / "validation/references"


def reference(source: str, table: str) -> Any:
    """The columns of a table by their names."""
    path = REFERENCES / source / f"{table}.csv"
    with path.open() as file:
        lines = [line for line in file if not line.startswith("#")]
    return np.genfromtxt(lines, delimiter=",", names=True, dtype=None, encoding="utf-8", deletechars="")
