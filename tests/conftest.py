# SPDX-License-Identifier: GPL-3.0-or-later
"""What all tests share: the repository, the environment of etc/bashrc, and the closing count."""
import os
import subprocess
from pathlib import Path
from typing import Dict

import pytest

REPOSITORY = Path(__file__).resolve().parent.parent


def sourcedEnvironment(**variables: str) -> Dict[str, str]:
    """The environment after `source etc/bashrc`, started from this one with some variables replaced."""
    command = 'set -eu; . "$0"; env -0'
    done = subprocess.run(["bash", "-c", command, str(REPOSITORY / "etc/bashrc")],
                          env={**os.environ, **variables}, capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"etc/bashrc failed:\n{done.stderr}")
    return dict(pair.split("=", 1) for pair in done.stdout.split("\0") if "=" in pair)


def pytest_configure() -> None:
    """Tests run in the environment of etc/bashrc, also when pytest is started by hand."""
    os.environ.update(sourcedEnvironment())


@pytest.fixture(scope="session")
def repository() -> Path:
    """Root directory of plungeFoam."""
    return REPOSITORY


def pytest_terminal_summary(terminalreporter) -> None:
    """Count both, so that a log shows a zero where nothing failed."""
    counts = {key: len(terminalreporter.getreports(key)) for key in ("passed", "failed", "error")}
    terminalreporter.write_line("")
    terminalreporter.write_line(f"plungeFoam: {counts['passed']} passed, {counts['failed'] + counts['error']} failed")
