# SPDX-License-Identifier: GPL-3.0-or-later
"""The GoogleTest programs of applications/test, one pytest test for each of their cases."""
import os
import re
import subprocess
from pathlib import Path
from typing import Iterator, List, Optional, Tuple

import pytest

SOURCES = Path(__file__).resolve().parents[2] / "applications/test"


def programs() -> Iterator[Path]:
    """Where the programs named in applications/test/*/Make/files are built."""
    for files in sorted(SOURCES.glob("*/Make/files")):
        match = re.search(r"^\s*EXE\s*=\s*\$\(PLUNGE_APPBIN\)/(\S+)", files.read_text(), re.MULTILINE)
        if not match:
            raise RuntimeError(f"{files}: entry EXE: expected EXE = $(PLUNGE_APPBIN)/Test-<library>")
        yield Path(os.environ["PLUNGE_APPBIN"]) / match.group(1)


def caseNames(listing: str) -> List[str]:
    """Names Suite.Case from the output of --gtest_list_tests."""
    names: List[str] = []
    suite = ""
    for line in listing.splitlines():
        name = line.split("#")[0].rstrip()
        if name.startswith("  "):
            names.append(suite + name.strip())
        elif re.fullmatch(r"\S+\.", name):
            suite = name
    return names


def cases() -> List[Tuple[Path, Optional[str]]]:
    """Program and case; a program that cannot list its cases stands for itself, and fails."""
    found: List[Tuple[Path, Optional[str]]] = []
    for program in programs():
        listing = program.exists() and subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True)
        names = caseNames(listing.stdout) if listing and listing.returncode == 0 else []
        found += [(program, name) for name in names] or [(program, None)]
    return found


@pytest.mark.parametrize("program, case", cases(), ids=lambda value: getattr(value, "name", value))
def test_gtest(program: Path, case: Optional[str], tmp_path: Path) -> None:
    assert program.exists(), f"{program} has not been built: ./Allwmake"
    assert case, f"{program} lists no test cases"
    done = subprocess.run([program, f"--gtest_filter={case}"], cwd=tmp_path, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode or "[  PASSED  ] 1 test." not in done.stdout:
        pytest.fail(done.stdout, pytrace=False)


def test_caseNames() -> None:
    listing = "Running main() from gtest_main.cc\nBody.\n  mass\n  inertia  # GetParam() = 3\nGrid/Donor.\n  found/0\n"
    assert caseNames(listing) == ["Body.mass", "Body.inertia", "Grid/Donor.found/0"]
