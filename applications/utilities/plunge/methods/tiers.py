# SPDX-License-Identifier: GPL-3.0-or-later
"""Resolution of each tier: etc/methods/tiers, in body scales."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from plunge import foamDictionary
from plunge.checks import Check, ParameterError, checked, count, number, positive, triple

TEMPLATES = Path(__file__).resolve().parents[4] / "etc/methods"
TIERS = TEMPLATES / "tiers"
_THREE = triple("three numbers above 0: (nose middle tail)", lambda v: all(x > 0 for x in v))
ENTRIES: dict[str, Check] = {
    "capCells": count(2),
    "ringCells": count(1),
    "layers": count(4),
    "noseSpacing": positive,
    "bodySpacing": positive,
    "tailSpacing": positive,
    "growth": positive,
    "offset": _THREE,
    "stretching": _THREE,
    "backgroundSpacing": positive,
    "refinementLevels": count(1),
    "maxCo": positive,
    "maxAlphaCo": positive,
    "bluntCourant": positive,
    "maxDeltaT": positive,
    "particleSpacing": number("a number from 0.001 to 0.05", lambda v: 0.001 <= v <= 0.05),
}


def read(name: str, overrides: dict[str, Any], file: Path = TIERS, entries: dict[str, Check] = ENTRIES) -> dict[str, Any]:
    """A tier's entries, with those of the command line in place of the file's."""
    tiers = foamDictionary.read(file)
    if not isinstance(tiers.get(name), dict):
        raise ParameterError(f"-tier {name}: expected one of {file}'s: {' '.join(tiers)}")
    return checked({**tiers[name], **overrides}, f"{file}, {name}" + (" (or the command line)" if overrides else ""), entries)
