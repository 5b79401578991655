# SPDX-License-Identifier: GPL-3.0-or-later
"""What titanProperties says of liquids and gases."""

from __future__ import annotations

import csv
import subprocess
import sys
from pathlib import Path


def titanProperties(*arguments: str) -> list[dict[str, str]]:
    """The rows of its table, one for each state; a program that cannot have them ends."""
    command = ["titanProperties", *arguments, "-format", "csv", "-noWarnings"]
    program = Path(sys.argv[0]).name
    try:
        done = subprocess.run(command, capture_output=True, text=True)
    except OSError as error:
        sys.exit(f"{program}: titanProperties does not start ({error}): run ./Allwmake and source etc/bashrc first")
    if done.returncode:
        sys.exit(f"{program}: {' '.join(command)} failed:\n{done.stderr}")
    return list(csv.DictReader(done.stdout.splitlines()))
