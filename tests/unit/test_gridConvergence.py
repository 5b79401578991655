# SPDX-License-Identifier: GPL-3.0-or-later
"""gridConvergence: the worked example of its source, and values whose order and limit are known; the uncertainty of a dive with it."""

from math import inf, nan, sqrt
from pathlib import Path

import pytest

from plunge.studies.gridConvergence import gridConvergence, levels, representativeSize
from plunge.studies.headlineUncertainty import Parts, uncertainty, writeTable
from plunge.uncertainty import COLUMNS, CONDITIONS, HEADLINES, read_rows


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


def test_levels():
    """Of four meshes: each but the coarsest has an uncertainty, of three of second order 1.25 times its error."""
    sizes = (1, 2, 3, 6)
    found = levels(sizes, [5 + 0.1*h**2 for h in sizes], 1, 2)
    assert found[:3] == pytest.approx([1.25*0.1*h**2 for h in sizes[:3]]) and found[3] is None
    assert levels(sizes[:2], (1, 2)) == [None, None]
    assert levels((1, 2, 4), (1, nan, 2)) == [None, None, None]


# --- the uncertainty of a dive -----------------------------------------------------

# Of second order in the mesh, of first in the time step: 10 where both are 0
DIVES = {"fine": 10 + 0.9 / 1.5**2, "default": 10.9, "coarse": 10 + 0.9 * 1.5**2, "half steps": 10.7,
         "wallFunction": 10.4, "transition 0": 11.2, "transition 3e6": 10.8}


def test_the_parts_of_an_uncertainty():
    parts = uncertainty(DIVES)
    assert parts == pytest.approx((1.25 * 0.9, 2 * 0.2, 0.5 * 0.8))
    assert parts.total == pytest.approx(sqrt(1.125**2 + 0.4**2 + 0.4**2))


@pytest.mark.parametrize("name, part", [("coarse", 0), ("half steps", 1), ("transition 0", 2), ("wallFunction", 2)])
def test_a_dive_without_a_number_leaves_its_part_unknown(name, part):
    parts = uncertainty({**DIVES, name: nan})
    assert [i for i, value in enumerate(parts) if value != value] == [part]
    assert parts.total != parts.total


def test_the_table_keeps_other_fluids_and_leaves_out_what_is_unknown(tmp_path: Path, capsys):
    path = tmp_path / "uncertainty.csv"
    numbers = {name: (1.5, "m/s") for name in HEADLINES}
    for fluids, mesh in (("titan", 3.0), ("water", 6.0), ("titan", 5.0)):
        parts = {name: Parts(mesh, 4.0, 0.0) for name in HEADLINES[:2]}
        parts[HEADLINES[2]] = Parts(nan, 1.0, 1.0)
        writeTable(path, {name: fluids if name == "fluids" else "x" for name in CONDITIONS}, numbers, parts, "abc123")
    rows = read_rows(path)
    assert list(rows[0]) == list(COLUMNS)
    assert [(row["fluids"], row["quantity"], row["mesh_uncertainty"]) for row in rows] == [
        (fluids, name, mesh) for fluids, mesh in (("water", "6"), ("titan", "5")) for name in HEADLINES[:2]]
    assert rows[0]["total_uncertainty"] == "7.211" and rows[0]["value"] == "1.5"
    assert f"titan: {HEADLINES[2]}: no uncertainty" in capsys.readouterr().err
