# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads and writes the plain part of OpenFOAM's dictionary format: entries, sub-dictionaries, lists, comments."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any


class DictionaryError(Exception):
    """A dictionary that cannot be read; the message names the file and the place."""


_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[{}();]|[^\s{}();"]+')


def _strip_comments(text: str) -> str:
    """Blank out comments, keeping the line numbers."""
    text = re.sub(r"/\*.*?\*/", lambda m: "\n" * m.group().count("\n"), text, flags=re.S)
    return re.sub(r"//[^\n]*", "", text)


def _value(token: str) -> Any:
    if "_" in token:    # Python's own way to write a number
        return token.strip('"')
    for kind in (int, float):
        try:
            return kind(token)
        except ValueError:
            pass
    return token.strip('"')


def read(path: Path) -> dict[str, Any]:
    """Return the entries of a dictionary file; numbers become int or float, lists become Python lists."""
    try:
        return parse(path.read_text(encoding="utf-8-sig", errors="replace"), str(path))
    except OSError as error:
        raise DictionaryError(f"{path}: cannot be read: {error.strerror}") from None
    except RecursionError:
        raise DictionaryError(f"{path}: brackets nested too deep; expected a scene's few levels") from None


def parse(text: str, source: str) -> dict[str, Any]:
    """Return the entries of a dictionary's text, as `read` does; errors name the source."""
    text = _strip_comments(text)
    tokens = [(m.group(), text.count("\n", 0, m.start()) + 1) for m in _TOKEN.finditer(text)]
    position = 0

    def fail(line: int, message: str) -> None:
        raise DictionaryError(f"{source}, line {line}: {message}")

    def parse_list(line: int) -> list[Any]:
        nonlocal position
        values: list[Any] = []
        while position < len(tokens):
            token, here = tokens[position]
            position += 1
            if token == ")":
                return values
            if token in "};":
                fail(here, f"'{token}' inside a list")
            values.append(parse_list(here) if token == "(" else parse_entries(here) if token == "{" else _value(token))
        fail(line, "list without its closing ')'")
        return values

    def parse_entries(opened: int | None) -> dict[str, Any]:
        nonlocal position
        entries: dict[str, Any] = {}
        while position < len(tokens):
            token, line = tokens[position]
            position += 1
            if token == "}":
                if opened is None:
                    fail(line, "'}' without its '{'")
                return entries
            if token in "{();":
                fail(line, f"expected the name of an entry, found '{token}'")
            key = token.strip('"')
            if key.startswith("#") or key.startswith("$"):
                fail(line, f"'{key}': this file takes plain values only, no directives and no variables")
            if key in entries:
                fail(line, f"entry '{key}' is given twice")
            if position < len(tokens) and tokens[position][0] == "{":
                position += 1
                entries[key] = parse_entries(line)
                continue
            values: list[Any] = []
            while True:
                if position >= len(tokens) or tokens[position][0] in "{}":
                    fail(line, f"entry '{key}' has no closing ';'")
                token, here = tokens[position]
                position += 1
                if token == ";":
                    break
                values.append(parse_list(here) if token == "(" else _value(token))
            if not values:
                fail(line, f"entry '{key}' has no value")
            entries[key] = values[0] if len(values) == 1 else values
        if opened is not None:
            fail(opened, "'{' without its '}'")
        return entries

    entries = parse_entries(None)
    entries.pop("FoamFile", None)
    return entries


def format_value(value: Any) -> str:
    """Write a number, a word, a text, a list or a dictionary the way OpenFOAM reads it back without loss."""
    if isinstance(value, dict):
        return "{ " + "".join(f"{key} {format_value(v)}{'' if isinstance(v, dict) else ';'} " for key, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "(" + " ".join(format_value(v) for v in value) + ")"
    if isinstance(value, float):
        return f"{value:.12g}"
    text = str(value)
    return f'"{text}"' if re.search(r"[\s{}();]", text) else text


def header(path: Path, note: str) -> list[str]:
    """Lines that a dictionary begins with."""
    return [
        "FoamFile",
        "{",
        "    version     2.0;",
        "    format      ascii;",
        "    class       dictionary;",
        f"    object      {path.name};",
        "}",
        "",
        *(f"// {line}" for line in note.splitlines()),
    ]


def _write_lines(path: Path, lines: list[str]) -> None:
    """The file appears complete or not at all."""
    part = path.with_name(path.name + ".part")
    part.write_text("\n".join(lines) + "\n")
    part.replace(path)


def write(path: Path, note: str, sections: list[tuple[str, dict[str, Any]]]) -> None:
    """Write sections of entries; each section is introduced by a comment."""
    lines = header(path, note)
    for title, entries in sections:
        lines += ["", f"// {title}"]
        lines += [f"{key:<23} {format_value(value)}{'' if isinstance(value, dict) else ';'}" for key, value in entries.items()]
    _write_lines(path, lines)


def write_nested(path: Path, note: str, entries: dict[str, Any]) -> None:
    """Write entries with their sub-dictionaries."""
    def text(entries: dict[str, Any], indent: str) -> list[str]:
        lines = []
        for key, value in entries.items():
            if isinstance(value, dict):
                lines += [f"{indent}{key}", f"{indent}{{", *text(value, indent + "    "), f"{indent}}}"]
            else:
                lines.append(f"{indent}{key:<15} {format_value(value)};")
        return lines

    path.parent.mkdir(parents=True, exist_ok=True)
    _write_lines(path, [*header(path, note), "", *text(entries, "")])
