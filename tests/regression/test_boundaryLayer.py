# SPDX-License-Identifier: GPL-3.0-or-later
"""A flat plate with each boundary layer, coarse: friction, what the liquid loses by it, and processors."""
from pathlib import Path

import numpy as np
import pytest

from tutorials import foam, solve
from plunge.studies import friction
from plunge.studies.foamFields import readCells, times


def plate(run: Path, ranks: int = 1, **entries: object) -> Path:
    """The plate of validation/studies/flatPlate with other parameters, run to its end."""
    friction.makePlate(run, **{"stretching": 20, **entries})
    solve(run, "plungeFoam", ranks)
    return run


@pytest.fixture(scope="module")
def coarse(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return plate(tmp_path_factory.mktemp("plate") / "coarse")


def test_frictionOfTheLine(coarse: Path) -> None:
    """As the parameters have it: Re 1.637e7, transition at 5e5."""
    assert friction.coefficient(coarse) == pytest.approx(friction.plateFriction(1.637e7, 5e5), rel=0.02)


def test_liquidLosesWhatThePlateTakes(coarse: Path) -> None:
    """The momentum that the stream lacks behind the plate, across the domain, is the plate's friction."""
    for function in ("writeCellCentres", "writeCellVolumes"):
        foam("postProcess", "-func", function, "-latestTime", case=coarse)
    last = coarse / times(coarse)[-1]
    x, z, volume = (readCells(last / name)[:, 0] for name in ("Cx", "Cz", "V"))
    behind = np.isclose(x, x[x > 1].min())
    z, u = z[behind], readCells(last / "U")[behind, 0]
    area = friction.WIDTH*0.6*volume[behind]/volume[behind].sum()
    # The layer is 0.02 m thick; further out the stream follows its displacement
    outside = np.mean(u[(z > 0.03) & (z < 0.07)])
    lost = friction.DENSITY*np.sum((u*(outside - u)*area)[z < 0.03])
    taken = friction.coefficient(coarse)*friction.DENSITY/2*25**2*friction.WIDTH
    assert lost == pytest.approx(taken, rel=0.05)
    # It is spread over a layer, not left in the first cells
    assert u.min() > 0.5*25


def test_transitionTakesFrictionAway(tmp_path: Path, coarse: Path) -> None:
    late = friction.coefficient(plate(tmp_path / "late", transitionReynolds=3e6))
    assert 1 - late/friction.coefficient(coarse) == pytest.approx(
        1 - friction.plateFriction(1.637e7, 3e6)/friction.plateFriction(1.637e7, 5e5), abs=0.02)


def test_processorsAgree(tmp_path: Path, coarse: Path) -> None:
    """Two processors, between which the plate is cut."""
    run = plate(tmp_path / "parallel", ranks=2)
    assert friction.coefficient(run) == pytest.approx(friction.coefficient(coarse), rel=1e-4)


def test_slipHasNone(tmp_path: Path) -> None:
    run = plate(tmp_path / "none", boundaryLayer="none")
    assert abs(friction.coefficient(run)) < 1e-6
    assert "There is no boundary layer: the friction of a flat plate as large as the walls" in (run / "log.solver").read_text()


@pytest.mark.parametrize("reynolds, transition", [(1e5, 0), (1e5, 5e5), (1e4, 5e5)])
def test_thickLayers(tmp_path: Path, reynolds: float, transition: float) -> None:
    """Down to where a layer is no longer thin, 5 % of its length."""
    run = plate(tmp_path / "thick", viscosity=25/reynolds, transitionReynolds=transition, cells=80)
    line = friction.plateFriction(reynolds, 0) if transition == 0 else 1.328/np.sqrt(reynolds)
    assert friction.coefficient(run) == pytest.approx(line, rel=0.06)
