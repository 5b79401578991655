# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of a dictionary's entries, with errors that name the file, the entry and what was expected."""

from __future__ import annotations

import shutil
from typing import Any, Callable, Collection

from plunge import foamDictionary


class ParameterError(Exception):
    """A value that cannot be used; the message names file, entry and what is expected."""


def unwritten(error: OSError) -> str:
    """What could not be read or written, why, and what was expected."""
    if isinstance(error, shutil.Error) and isinstance(error.args[0], list):    # of all files of a directory
        _, target, why = error.args[0][0]
    else:
        target, why = error.filename, error.strerror or str(error)
    return f"{f'{target}: ' if target else ''}{why}; expected a directory that can be written, on a disk with room"


# Sizes of numbers that are not 0, beyond which products of them leave what a computer can hold
_SIZES = 1e-20, 1e20

Check = "tuple[str, Callable[[Any], bool]]"  # what is expected, and whether a value is that


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _is_sized(value: float) -> bool:
    """Is it finite, and 0 or of a size that there is?"""
    return value == 0 or _SIZES[0] <= abs(value) <= _SIZES[1]


def number(expectation: str, holds: Callable[[float], bool] = lambda v: True) -> Check:
    return (expectation, lambda v: _is_number(v) and _is_sized(v) and holds(v))


def triple(expectation: str, holds: Callable[[list], bool] = lambda v: True) -> Check:
    each = number("")[1]
    return (expectation, lambda v: isinstance(v, list) and len(v) == 3 and all(each(x) for x in v) and holds(v))


def count(least: int) -> Check:
    return (f"a whole number, at least {least}", lambda v: type(v) is int and v >= least)


def word(*words: str) -> Check:
    return ("one of: " + " ".join(words), lambda v: v in words)


text: Check = ("a text", lambda v: isinstance(v, str))
positive: Check = number("a number above 0", lambda v: v > 0)
not_negative: Check = number("a number, 0 or above", lambda v: v >= 0)


def flat(entries: dict[str, Any], prefix: str = "", keep: tuple[str, ...] = ()) -> dict[str, Any]:
    """Entries of sub-dictionaries under names with dots; those in `keep` stay dictionaries."""
    found: dict[str, Any] = {}
    for key, value in entries.items():
        if isinstance(value, dict) and prefix + key not in keep:
            found.update(flat(value, f"{prefix}{key}.", keep))
        else:
            found[prefix + key] = value
    return found


def refuse_unknown(entries: dict[str, Any], source: str, known: Collection[str]) -> None:
    """An error that names the first entry which is not known."""
    for key in entries:
        if key not in known:
            raise ParameterError(f"{source}: unknown entry '{key}'; expected: {' '.join(known)}")


def checked(entries: dict[str, Any], source: str, required: dict[str, Check], optional: dict[str, Check] = {}) -> dict[str, Any]:
    """The entries, each of which is known and what is expected."""
    known = {**required, **optional}
    refuse_unknown(entries, source, known)
    for key, (expectation, holds) in known.items():
        if key not in entries:
            if key in required:
                raise ParameterError(f"{source}: entry '{key}' is missing; expected {expectation}")
        elif not holds(entries[key]):
            found = foamDictionary.format_value(entries[key])
            if _is_number(entries[key]) and not _is_sized(entries[key]):
                expectation += f", of a size from {_SIZES[0]:g} to {_SIZES[1]:g}"
            raise ParameterError(f"{source}: entry '{key}' is {found}; expected {expectation}")
    return entries
