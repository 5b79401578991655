# SPDX-License-Identifier: GPL-3.0-or-later
"""The liquids agree with other codes and published tables: the comparison of validation/titanLiquids, without its timings."""
from pathlib import Path
from types import ModuleType

import pytest

from tutorials import comparison

FOLDER = Path(__file__).resolve().parents[2] / "validation/titanLiquids"


@pytest.fixture(scope="module")
def compare() -> ModuleType:
    return comparison(FOLDER)


@pytest.mark.parametrize("rows", ["properties_rows", "titanpool_rows"])
def test_judged_figures_hold(compare: ModuleType, rows: str, tmp_path: Path) -> None:
    found = [row for row in getattr(compare, rows)(tmp_path) if row.holds]
    assert len(found) >= 3
    assert not [row for row in found if row.holds != "yes"]


def test_an_error_would_be_seen(compare: ModuleType, tmp_path: Path) -> None:
    """A density that is off by one part in ten thousand, or refused."""
    reference = compare.read(FOLDER / "reference/properties.csv")[:1]
    answers = compare.evaluate(reference, tmp_path, "one")
    answers[0]["density_kg_m3"] = str(1.0001 * float(answers[0]["density_kg_m3"]))
    largest, count = compare.worst(reference, answers, "density_kg_m3", lambda row: True)
    assert count == 1 and largest == pytest.approx(1e-4, rel=1e-3)
    answers[0]["density_kg_m3"] = ""
    assert compare.worst(reference, answers, "density_kg_m3", lambda row: True)[0] == float("inf")
