# SPDX-License-Identifier: GPL-3.0-or-later
"""Every tutorial of interFoam, interIsoFoam and overInterDyMFoam in plungeFoam: it runs after changing the application alone, and gives what
the stock solver gives, compiled without the defect of src/compilerOptions. docs/tutorials.md has the table."""
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from plunge.results import CaseError
from plunge.studies import stockCases
from plunge.studies.foamFields import readCells
from tutorials import foam, run, setEntry


@pytest.fixture(scope="session")
def stock(repository: Path) -> Path:
    """The folder of the stock solvers; they are compiled once for a checkout."""
    try:
        return stockCases.build(repository / "platforms" / os.environ["WM_OPTIONS"] / "stockSolvers")
    except CaseError as error:
        pytest.skip(str(error))


@pytest.mark.parametrize("tutorial", [pytest.param(name, marks=[pytest.mark.validation] if name in stockCases.SLOW else [])
                                      for name in stockCases.tutorials()])
def test_tutorial(tutorial: str, stock: Path, tmp_path: Path) -> None:
    outcome = stockCases.runBoth(tutorial, tmp_path, stock)
    assert outcome.difference < stockCases.AGREE, outcome


def test_tableIsComplete(repository: Path) -> None:
    """The table in the documents has a row for each tutorial, and none that failed."""
    rows = re.findall(r"^\| `([^`]+)` \|.*$", (repository / "docs/tutorials.md").read_text(), re.M)
    assert rows == stockCases.tutorials()


def test_scalarGoesWithTheLiquid(tmp_path: Path) -> None:
    """angledDuct's residence time: new at the inlet, where OpenFOAM v1912's solver, whose alphaPhiUn is zero, lets all of it age alike."""
    case = stockCases.setUp("interFoam/RAS/angledDuct", tmp_path / "case")
    for name, value in (("alpha.water", "1"), ("U", "(0.1 0 0)")):
        field = case / "0" / name
        field.write_text(re.sub(r"internalField\s+uniform\s+[^;]+;", f"internalField uniform {value};", field.read_text()))
    setEntry(case, "system/fvSolution", "PIMPLE/frozenFlow", "yes")
    for name, value in (("deltaT", 1), ("maxCo", 0.5)):
        setEntry(case, "system/controlDict", name, value)
    foam("plungeFoam", case=case)
    time = stockCases.times(case)[-1]
    ages = readCells(case / time / "s").ravel()/float(time)
    assert 0 <= ages.min() < 0.6 and ages.max() < 1 + 1e-4


def test_postProcess(tmp_path: Path) -> None:
    """The option -postProcess gives what the stock solver's gives: a velocity field by setFlow, and fields of a time that was written."""
    case = stockCases.setUp("interIsoFoam/notchedDiscInSolidBodyRotation", tmp_path / "plungeFoam")
    shutil.rmtree(case / "0")
    shutil.copytree(case / "0.orig", case / "0")
    shutil.copytree(case, tmp_path / "stock")
    foam("plungeFoam", "-postProcess", "-time", "0", case=case)
    foam("interIsoFoam", "-postProcess", "-time", "0", case=tmp_path / "stock")
    ours, theirs = (readCells(folder / "0/U") for folder in (case, tmp_path / "stock"))
    assert ours.shape == theirs.shape and abs(ours).max() > 1 and abs(ours - theirs).max() < 1e-12
    assert "Time = 0\n" in subprocess.run(["plungeFoam", "-postProcess", "-func", "mag(U)"], cwd=case, text=True, stdout=subprocess.PIPE,
                                          env={**os.environ, "PWD": str(case)}).stdout
    assert readCells(case / "0/mag(U)").max() > 1


def test_tablesOfARunAreKept(tmp_path: Path) -> None:
    """Function objects that go with the steps of a run refuse -postProcess, which would write over their tables."""
    case = stockCases.setUp("interFoam/laminar/damBreak/damBreak", tmp_path / "case")
    stockCases.override(case, "system/controlDict",
                        "functions { ledger { type volumeLedger; libs (plungeFunctionObjects); bodyVolume 1; } }")
    foam("plungeFoam", case=case)
    table = next(case.glob("postProcessing/ledger/*/volumeLedger.csv"))
    before = table.read_text()
    done = run("plungeFoam", "-postProcess", case=case)
    assert done.returncode and "goes with the steps of a run" in done.stdout, done.stdout[-2000:]
    assert table.read_text() == before


def test_localTimeSteps(stock: Path, tmp_path: Path) -> None:
    """Local time steps, as DTCHull has them, on a mesh without a hull and with sub-cycles."""
    theirs = stockCases.setUp("interFoam/RAS/weirOverflow", tmp_path / "stock")
    schemes, solution = theirs / "system/fvSchemes", theirs / "system/fvSolution"
    schemes.write_text(re.sub(r"default\s+Euler;", "default localEuler;", schemes.read_text()))
    solution.write_text(solution.read_text().replace("PIMPLE\n{", "PIMPLE\n{ maxCo 10; maxAlphaCo 5; rDeltaTSmoothingCoeff 0.05; "
                                                     "rDeltaTDampingCoeff 0.5; nAlphaSpreadIter 1; nAlphaSweepIter 1; maxDeltaT 1;"))
    solution.write_text(re.sub(r"nAlphaSubCycles\s+1;", "nAlphaSubCycles 2;", solution.read_text()))
    setEntry(theirs, "system/controlDict", "adjustTimeStep", "no")
    setEntry(theirs, "system/controlDict", "deltaT", "1")
    ours = tmp_path / "ours"
    shutil.copytree(theirs, ours)
    stockCases.solve("weirOverflow", theirs, stock / "interFoam")
    stockCases.solve("weirOverflow", ours, Path(shutil.which("plungeFoam")))
    outcome = stockCases.compare("weirOverflow", ours, theirs)
    assert outcome.difference < stockCases.AGREE, outcome
    steps = 1/readCells(ours / stockCases.times(ours)[-1] / "rDeltaT")
    assert steps.max() > 2*steps.min()
