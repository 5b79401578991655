# SPDX-License-Identifier: GPL-3.0-or-later
"""What a program needs of memory."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path


def peakMemory(run: Path, *command: str) -> None:
    """Runs a program in a directory into log.<program>, and writes its peak resident memory to log.memory."""
    with (run / f"log.{command[0]}").open("w") as log:
        process = subprocess.Popen(command, cwd=run, env={**os.environ, "PWD": str(run)}, stdout=log, stderr=subprocess.STDOUT)
        _, status, used = os.wait4(process.pid, 0)
    if status:
        raise RuntimeError(f"{command[0]} failed in {run}")
    (run / "log.memory").write_text(f"{used.ru_maxrss} kB\n")
