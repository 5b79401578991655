# SPDX-License-Identifier: GPL-3.0-or-later
"""gridConvergence: the worked example of its source, and values whose order and limit are known; validation/diveUncertainty with it."""

import csv
from math import inf, nan, sqrt
from pathlib import Path

import pytest

from conftest import REPOSITORY
from tutorials import comparison
from plunge.studies.gridConvergence import gridConvergence, representativeSize
from plunge.uncertainty import COLUMNS, HEADLINES, read_rows

study = comparison(REPOSITORY / "validation/diveUncertainty")


def test_the_worked_example():
    """Celik et al. (2008), table 1, first column; index 32 and the ratio as pyGCS has them."""
    sizes = [representativeSize(cells, 76, 2) for cells in (18000, 8000, 4500)]
    found = gridConvergence(sizes, (6.063, 5.972, 5.863))
    assert found.fineRatio == pytest.approx(1.5) and found.coarseRatio == pytest.approx(4 / 3)
    assert found.observedOrder == found.order == pytest.approx(1.53, abs=0.005)
    assert found.extrapolated == pytest.approx(6.1685, abs=5e-4)
    assert 100 * found.fineError == pytest.approx(1.5, abs=0.05)
    assert 100 * found.fineIndex == pytest.approx(2.17, abs=0.01)
    assert 100 * found.coarseIndex == pytest.approx(4.11, abs=0.01)
    assert found.asymptoticRatio == pytest.approx(1.015, abs=0.001)
    assert found.convergence == "monotone"


@pytest.mark.parametrize("order", [0.7, 1, 2, 3.1])
@pytest.mark.parametrize("sizes", [(1, 1.5, 2.25), (1, 1.3, 2.6), (1, 2, 2.7)])
@pytest.mark.parametrize("slope", [0.02, -0.02])
def test_order_and_limit_are_recovered(order, sizes, slope):
    found = gridConvergence(sizes, [3 + slope * h**order for h in sizes])
    assert found.observedOrder == pytest.approx(order, rel=1e-6)
    assert found.extrapolated == pytest.approx(3)
    assert found.convergence == "monotone"
    # Both pairs then say the same of the middle mesh: SAFETY times its true error
    assert found.middleUncertainty == pytest.approx(1.25 * 0.02 * sizes[1] ** order)
    assert found.middleUncertainty == pytest.approx(found.coarseIndex * abs(3 + slope * sizes[1] ** order))


def test_an_order_above_the_formal_one_is_held():
    sizes = (1, 1.5, 2.25)
    found = gridConvergence(sizes, [3 + 0.02 * h**4 for h in sizes], least=1, most=2)
    assert found.observedOrder == pytest.approx(4) and found.order == 2
    coarse = 0.02 * (2.25**4 - 1.5**4)
    assert found.middleUncertainty == pytest.approx(1.25 * coarse / (1.5**2 - 1))  # the coarse pair says more
    assert found.middleUncertainty > 1.25 * 0.02 * 1.5**4


def test_an_order_below_the_least_is_held():
    sizes = (1, 1.5, 2.25)
    found = gridConvergence(sizes, [3 + 0.02 * h**0.5 for h in sizes], least=1, most=2)
    assert found.observedOrder == pytest.approx(0.5) and found.order == 1
    assert found.middleUncertainty == pytest.approx(1.25 * 0.02 * (1.5**0.5 - 1) * 1.5 / 0.5)  # the fine pair says more


def test_oscillation_is_flagged_and_its_uncertainty_covers_all_three():
    found = gridConvergence((1, 1.5, 2.25), (1.0, 1.1, 1.06), least=1, most=2)
    assert found.convergence == "oscillatory" and 1 <= found.order <= 2
    assert found.middleUncertainty > 0.1
    unequal = gridConvergence((1, 1.5, 2), (1.0, 1.1, 0.9))
    sign = (1.5**unequal.observedOrder + 1) / (2 ** unequal.observedOrder / 1.5**unequal.observedOrder + 1)
    assert 1.5**unequal.observedOrder == pytest.approx(2 * sign)  # eq. 3 with s = -1


def test_values_that_part_are_flagged():
    """The magnitude of the order, as eq. 3 has it, would take this for convergence."""
    found = gridConvergence((1, 1.5, 2.25), (1.0, 1.2, 1.3), least=1, most=2)
    assert found.convergence == "divergent" and found.order == 1
    assert 1.5**found.observedOrder == pytest.approx(0.5)
    assert found.middleUncertainty >= 1.25 * 0.2


@pytest.mark.parametrize("values, uncertainty", [((2, 2, 2), 0), ((2, 2, 2.1), 0.25), ((2, 2.1, 2.1), 0.375)])
def test_equal_values_have_no_order(values, uncertainty):
    found = gridConvergence((1, 1.5, 2.25), values, least=1, most=2)
    assert found.convergence == "undetermined" and found.observedOrder != found.observedOrder
    assert found.middleUncertainty == pytest.approx(uncertainty)
    assert found.fineIndex == pytest.approx(0 if values[0] == values[1] else 1.25 * 0.05 / 0.5)


def test_equal_values_without_a_least_order():
    assert gridConvergence((1, 2, 4), (2, 2, 2)).middleUncertainty == 0
    assert gridConvergence((1, 2, 4), (2, 2, 3)).middleUncertainty == inf


@pytest.mark.parametrize("sizes, values", [((2, 1, 3), (1, 2, 3)), ((1, 2), (1, 2)), ((1, 2, 3), (1, nan, 3)), ((0, 1, 2), (1, 2, 3))])
def test_bad_input_is_refused(sizes, values):
    with pytest.raises(ValueError, match="expected"):
        gridConvergence(sizes, values)


# --- the study of the dive ---------------------------------------------------------

# Of second order in the mesh, of first in the time step: 10 where both are 0
DIVES = {"fine": 10 + 0.9 / 1.5**2, "default": 10.9, "coarse": 10 + 0.9 * 1.5**2, "half-steps": 10.7,
         "wallFunction": 10.4, "transition-0": 11.2, "transition-3e6": 10.8}


def test_the_parts_of_an_uncertainty():
    parts, rows = study.uncertainty("titan: it", "m/s", DIVES)
    assert parts == pytest.approx((1.25 * 0.9, 2 * 0.2, 0.5 * 0.8))
    assert parts.total == pytest.approx(sqrt(1.125**2 + 0.4**2 + 0.4**2))
    found = {row.quantity: row.value for row in rows}
    assert found["titan: it, observed order, monotone"] == pytest.approx(2)
    assert found["titan: it, extrapolated"] == "10"
    assert found["titan: it, grid convergence index of the default mesh"] == pytest.approx(100 * 1.125 / 10.9)
    assert found["titan: it, uncertainty by the time step"] == pytest.approx(0.4)


def test_an_order_that_is_held_says_so():
    _, rows = study.uncertainty("it", "m", {**DIVES, "fine": 11.0})
    assert rows[0].quantity == "it, observed order, oscillatory"
    _, rows = study.uncertainty("it", "m", {**DIVES, "fine": 10.89})
    assert rows[0].quantity == "it, observed order, monotone" and rows[0].value > 2
    assert rows[1].quantity == "it, order of the indices, held in [1, 2]" and rows[1].value == 2


@pytest.mark.parametrize("name, part", [("coarse", 0), ("half-steps", 1), ("transition-0", 2), ("wallFunction", 2)])
def test_a_dive_without_a_number_leaves_its_part_unknown(name, part):
    parts, _ = study.uncertainty("it", "m", {**DIVES, name: nan})
    assert [i for i, value in enumerate(parts) if value != value] == [part]
    assert parts.total != parts.total


def test_the_table_keeps_other_fluids_and_leaves_out_what_is_unknown(tmp_path: Path, capsys):
    path = tmp_path / "uncertainty.csv"
    numbers = {name: (1.5, "m/s") for name in HEADLINES}
    for fluids, mesh in (("titan", 3.0), ("water", 6.0), ("titan", 5.0)):
        parts = {name: study.Parts(mesh, 4.0, 0.0) for name in HEADLINES[:2]}
        parts[HEADLINES[2]] = study.Parts(nan, 1.0, 1.0)
        study.writeTable(path, fluids, {name: fluids if name == "fluids" else "x" for name in study.conditions(tmp_path)}, numbers, parts,
                         "abc123")
    rows = read_rows(path)
    assert list(rows[0]) == list(COLUMNS)
    assert [(row["fluids"], row["quantity"], row["mesh_uncertainty"]) for row in rows] == [
        (fluids, name, mesh) for fluids, mesh in (("water", "6"), ("titan", "5")) for name in HEADLINES[:2]]
    assert rows[0]["total_uncertainty"] == "7.211" and rows[0]["value"] == "1.5"
    assert f"titan: {HEADLINES[2]}: no uncertainty" in capsys.readouterr().err


def test_the_study_from_finished_dives(tmp_path: Path, monkeypatch, capsys):
    """Without the dives themselves: their summaries are there, one without full immersion."""
    case = tmp_path / "case"
    (case / "constant").mkdir(parents=True)
    (case / "constant/plungeFluids").write_text("titan { gravity 1.35; }\n")
    for name in study.OPTIONS:
        run = tmp_path / "run/titan" / name
        for folder in ("results", "system", "constant/polyMesh"):
            (run / folder).mkdir(parents=True)
        (run / "system/plungeGenerated").write_text("FoamFile { object x; }\nfluids titan;\ntier fast;\n")
        (run / "system/controlDict").write_text("FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }\n"
                                                "application plungeFoam;\n")
        (run / "log.plungeFoam").write_text("ExecutionTime = 12 s  ClockTime = 13 s\n")
        (run / "constant/polyMesh/boundary").write_text("")
        (run / "constant/polyMesh/owner").write_text('note "nPoints:8  nCells:27";')
        lost = nan if name == "coarse" else DIVES[name]
        (run / "results/summary.csv").write_text("quantity,value,unit\n" + "".join(
            f"{quantity},{lost if 'pitch' in quantity else DIVES[name]},m\n" for quantity in HEADLINES))
    monkeypatch.setattr(study, "HERE", tmp_path)
    monkeypatch.setattr(study, "RUNS", tmp_path / "run")
    monkeypatch.setattr(study, "CASE", case)
    monkeypatch.setattr(study, "solve", lambda run, fluids: None)
    monkeypatch.setattr(study, "software_version", lambda folder: "abc123")
    monkeypatch.setattr("plunge.studies.resultTable.software_version", lambda folder: "abc123")
    monkeypatch.setattr("sys.argv", ["compare.py", "-fluids", "titan"])
    assert study.main() == 0

    said = capsys.readouterr().err
    assert "coarse/results/summary.csv, pitch change at full immersion: nan; expected a finite number" in said
    rows = read_rows(case / "constant/uncertainty.csv")
    assert [row["quantity"] for row in rows] == [name for name in HEADLINES if "pitch" not in name]
    assert {(row["fluids"], row["tier"], row["unit"], row["version"]) for row in rows} == {("titan", "fast", "m", "abc123")}
    with (tmp_path / "result.csv").open(newline="") as file:
        result = {row["quantity"]: row for row in csv.DictReader(file)}
    assert result["titan: cells, fine"]["value"] == "27" and result["titan: cells, fine"]["cpu_s"] == "12"
    assert result["titan: peak deceleration, default"]["value"] == "10.9"
    assert result["titan: change of velocity lost at full immersion by doubling, estimated from 1 and 1.5"]["holds"] == "yes"
