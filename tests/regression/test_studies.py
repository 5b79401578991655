# SPDX-License-Identifier: GPL-3.0-or-later
"""Every study of validation/studies: its quick tier says what its expected.csv asserts; marked validation, its full tier."""
import os
from pathlib import Path

import pytest

from plunge.studies import driver
from plunge.studies.resultTable import FAIL, HOLD, read
from plunge.studies.study import load, names

CORES = min(2, len(os.sched_getaffinity(0)))


@pytest.mark.parametrize("name", names())
def test_quick(name: str, tmp_path: Path) -> None:
    study = load(name)
    assert read(study.folder / "expected.csv"), f"{study.folder}/expected.csv: expected a figure at least"
    failures, _ = driver.run([study], "quick", CORES, tmp_path)
    assert not failures


@pytest.mark.validation
@pytest.mark.parametrize("name", names())
def test_full(name: str) -> None:
    """All runs come to their end, and what has held still holds."""
    study = load(name)
    held = [tuple(row[column] for column in ("scene", "method", "variant", "resolution", "quantity"))
            for row in read(study.folder / "result.csv") if row["verdict"] in HOLD]
    failures, results = driver.run([study], "full", CORES)
    assert not failures
    assert not [row.key for row in results[name] if row.key in held and row.verdict in FAIL]
