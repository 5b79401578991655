# SPDX-License-Identifier: GPL-3.0-or-later
"""A flat plate with each boundary layer, coarse: friction, what the liquid loses by it, and processors."""
import shutil
from pathlib import Path

import numpy as np
import pytest

from conftest import REPOSITORY
from tutorials import comparison, foam, solve
from plunge.studies.foamFields import readCells, times
from plunge.studies.particleRuns import override

STUDY = REPOSITORY / "validation/boundaryLayer"
study = comparison(STUDY)


def plate(run: Path, ranks: int = 1, **entries: object) -> Path:
    """The plate of validation/boundaryLayer with other parameters, run to its end."""
    shutil.copytree(STUDY / "plate", run)
    shutil.copytree(run / "0.orig", run / "0")
    override(run, "system/plateParameters", "\n".join(f"{key} {value};" for key, value in {"stretching": 20, **entries}.items()))
    foam("blockMesh", case=run)
    solve(run, "plungeFoam", ranks)
    return run


@pytest.fixture(scope="module")
def coarse(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return plate(tmp_path_factory.mktemp("plate") / "coarse")


def test_frictionOfTheLine(coarse: Path) -> None:
    """As the parameters have it: Re 1.637e7, transition at 5e5."""
    assert study.coefficient(coarse) == pytest.approx(study.plate_friction(1.637e7, 5e5), rel=0.02)


def test_liquidLosesWhatThePlateTakes(coarse: Path) -> None:
    """The momentum that the stream lacks behind the plate, across the domain, is the plate's friction."""
    for function in ("writeCellCentres", "writeCellVolumes"):
        foam("postProcess", "-func", function, "-latestTime", case=coarse)
    last = coarse / times(coarse)[-1]
    x, z, volume = (readCells(last / name)[:, 0] for name in ("Cx", "Cz", "V"))
    behind = np.isclose(x, x[x > 1].min())
    z, u = z[behind], readCells(last / "U")[behind, 0]
    area = study.WIDTH*0.6*volume[behind]/volume[behind].sum()
    # The layer is 0.02 m thick; further out the stream follows its displacement
    outside = np.mean(u[(z > 0.03) & (z < 0.07)])
    lost = study.DENSITY*np.sum((u*(outside - u)*area)[z < 0.03])
    friction = study.coefficient(coarse)*study.DENSITY/2*25**2*study.WIDTH
    assert lost == pytest.approx(friction, rel=0.05)
    # It is spread over a layer, not left in the first cells
    assert u.min() > 0.5*25


def test_transitionTakesFrictionAway(tmp_path: Path, coarse: Path) -> None:
    late = study.coefficient(plate(tmp_path / "late", transitionReynolds=3e6))
    assert 1 - late/study.coefficient(coarse) == pytest.approx(
        1 - study.plate_friction(1.637e7, 3e6)/study.plate_friction(1.637e7, 5e5), abs=0.02)


def test_processorsAgree(tmp_path: Path, coarse: Path) -> None:
    """Two processors, between which the plate is cut."""
    run = plate(tmp_path / "parallel", ranks=2)
    assert study.coefficient(run) == pytest.approx(study.coefficient(coarse), rel=1e-4)


def test_slipHasNone(tmp_path: Path) -> None:
    run = plate(tmp_path / "none", boundaryLayer="none")
    assert abs(study.coefficient(run)) < 1e-6
    assert "There is no boundary layer: the friction of a flat plate of its wetted area" in (run / "log.solver").read_text()


@pytest.mark.parametrize("reynolds, transition", [(1e5, 0), (1e5, 5e5), (1e4, 5e5)])
def test_thickLayers(tmp_path: Path, reynolds: float, transition: float) -> None:
    """Down to where a layer is no longer thin, 5 % of its length."""
    run = plate(tmp_path / "thick", viscosity=25/reynolds, transitionReynolds=transition, cells=80)
    line = study.plate_friction(reynolds, 0) if transition == 0 else 1.328/np.sqrt(reynolds)
    assert study.coefficient(run) == pytest.approx(line, rel=0.06)
