# SPDX-License-Identifier: GPL-3.0-or-later
"""The fluids of a scene: from their names to their properties."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path
from typing import Any

from plunge import foamDictionary
from plunge.checks import Check, ParameterError, checked, not_negative, positive

PAIRS = Path(__file__).resolve().parents[3] / "etc/fluids"

_PROPERTIES: dict[str, Check] = {
    "liquidDensity": positive,
    "liquidViscosity": positive,
    "gasDensity": positive,
    "gasViscosity": positive,
    "surfaceTension": not_negative,
    "surfacePressure": positive,
    "liquidVapourPressure": positive,
    "liquidSoundSpeed": positive,
    "gasSoundSpeed": positive,
    "gravity": not_negative,
}
# Entries that a fluid of titanProperties gives where they are not typed: whose fluid, and under which name
_FROM_FLUID = {
    "liquidDensity": ("liquid", "rho"),
    "liquidViscosity": ("liquid", "mu"),
    "gasDensity": ("gas", "rho"),
    "gasViscosity": ("gas", "mu"),
    "surfaceTension": ("liquid", "sigma"),
    "liquidVapourPressure": ("liquid", "vapourPressure"),
    "liquidSoundSpeed": ("liquid", "soundSpeed"),
    "gasSoundSpeed": ("gas", "soundSpeed"),
}


def fluid_properties(name: str, temperature: float | None, source: str) -> tuple[dict[str, Any], list[str]]:
    """What titanProperties says of a fluid, by OpenFOAM's names (SI units), at its own or a given temperature [K]; and its warnings."""
    command = ["titanProperties", name, "-format", "foam"]
    if temperature is not None:
        command += ["-T", f"{temperature:.12g}"]
    try:
        # OpenFOAM's programs do not start in a directory whose path has spaces
        done = subprocess.run(command, capture_output=True, text=True, cwd="/", env={**os.environ, "PWD": "/"})
    except FileNotFoundError:
        raise ParameterError("titanProperties is not on the PATH; expected ./Allwmake and . etc/bashrc before") from None
    if done.returncode:
        raise ParameterError(f"{source}: {done.stderr.strip()}")
    return foamDictionary.parse(done.stdout, " ".join(command)), re.findall(r"^titanProperties: warning: (.+)", done.stderr, re.M)


def _resolved(entries: dict[str, Any], source: str) -> tuple[dict[str, Any], list[str]]:
    """The numbers of a pair of fluids: those typed, and those of the fluids named by `liquid` and `gas`; and what is doubtful of these."""
    given, notes = dict(entries), []
    names = {role: given.pop(role, None) for role in ("liquid", "gas")}
    temperature = given.pop("temperature", None)
    if temperature is not None and not positive[1](temperature):
        raise ParameterError(f"{source}: entry 'temperature' is {temperature}; expected kelvins, above 0")
    for role, name in names.items():
        wanted = {entry: key for entry, (whose, key) in _FROM_FLUID.items() if whose == role and entry not in given}
        if name is None or not wanted:
            continue
        if not isinstance(name, str):
            raise ParameterError(f"{source}: entry '{role}' is {name}; expected a fluid of titanProperties -list")
        known, doubts = fluid_properties(name, temperature, source)
        notes += [f"{role} {name}: {doubt}" for doubt in doubts]
        given.update({entry: known[key] for entry, key in wanted.items() if key in known})
        missing = [entry for entry, key in wanted.items() if key not in known]
        if missing:
            raise ParameterError(f"{source}: entry '{missing[0]}' is missing, and {role} {name} does not give it; "
                                 f"expected {_PROPERTIES[missing[0]][0]}")
    return checked(given, source, _PROPERTIES), notes


def resolve(entry: Any, source: str) -> tuple[str, dict[str, Any], list[str]]:
    """A name, the properties (SI units) and what is doubtful of a scene's entry `fluids`: the name of a pair of etc/fluids, or a dictionary
    { liquid water; gas earthAir; } with any property in place of the fluid's. What a pair of the same two fluids says of them
    holds for these, too: surface pressure, gravity."""
    pairs = foamDictionary.read(PAIRS)
    if isinstance(entry, str):
        if entry not in pairs:
            raise ParameterError(f"{source}: entry 'fluids' is {entry}; expected one of: {' '.join(pairs)}, or a dictionary "
                                 "{ liquid ...; gas ...; }")
        return entry, *_resolved(pairs[entry], f"{PAIRS}, {entry}")
    if not isinstance(entry, dict):
        raise ParameterError(f"{source}: entry 'fluids' is {foamDictionary.format_value(entry)}; expected one of: {' '.join(pairs)}, "
                             "or a dictionary { liquid ...; gas ...; }")
    alike = next((pair for pair in pairs.values() if all(pair.get(role) == entry.get(role) for role in ("liquid", "gas"))), None)
    place = next((pair for pair in pairs.values() if pair.get("gas") == entry.get("gas")), {})
    known = dict(alike) if alike else {key: place[key] for key in ("surfacePressure", "gravity") if key in place}
    name = str(entry.get("liquid", "fluids"))
    return name, *_resolved({**known, **entry}, f"{source}, fluids")
