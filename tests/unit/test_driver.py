# SPDX-License-Identifier: GPL-3.0-or-later
"""The driver of studies: what it runs, judges and keeps, with studies that cost nothing."""
import subprocess
from pathlib import Path
from typing import List

import pytest

from plunge.studies import driver, references, resultTable
from plunge.studies.resultTable import COLUMNS, Row, read, state, verdict
from plunge.studies.study import STUDIES, Quantity, Run, Study, load, names


@pytest.mark.parametrize("value, reference, uncertainty, numerical, tolerance, said", [
    (1.2, None, None, None, None, ""), (1.2, 1.0, None, None, None, ""), (1.2, 1.0, 0.1, None, None, "no"), (1.2, 1.0, 0.1, None, 0.15, "yes"),
    (1.2, 1.0, 0.2001, 0.2, None, "yes"), (1.2, 1.0, 0.2001, 0.21, None, "no"), (1.0, 1.0, None, None, 0, "yes"),
    (float("nan"), 1.0, None, None, 5, "no"), (4.0, "<= 4", None, None, None, "yes"), (4.1, "<= 4", None, None, None, "no"),
    (3.9, ">= 4", None, None, None, "no"), (float("nan"), ">= 4", None, None, None, "no")])
def test_verdict(value, reference, uncertainty, numerical, tolerance, said) -> None:
    """Off by no more than reference's uncertainty and tolerance, and known as well as that."""
    assert verdict(value, reference, uncertainty, numerical, tolerance) == said


class Toy:
    """A study of x^2 at three cell sizes, whose runs are files; a run needs another one, and one can fail."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.made: List[str] = []
        self.fails = ""
        sizes = {"0.1 m": 0.1, "0.2 m": 0.2, "0.4 m": 0.4}
        self.study = Study(
            title="toy", name="toy", sources=("src",), solve=self.solve,
            runs=[*(Run("square", "meshes", "", size, ("quick", "full")) for size in sizes), Run("square", "meshes", "after", "0.1 m", needs="")],
            quantities=[Quantity("value", "1", lambda done: 3 + float((done.path / "h").read_text())**2, 3, tolerance=0.045, converges=True),
                        Quantity("twin", "1", lambda done: (other := done.beside(variant="")) and other.run.size if done.run.variant else None)])
        monkeypatch.setattr(Study, "folder", property(lambda study: folder / study.name))
        monkeypatch.setattr(driver, "FIGURES", folder)
        (folder / "toy").mkdir()
        (folder / "toy/expected.csv").write_text(",".join(driver.EXPECTED) + "\n")

    def solve(self, run: Run, path: Path) -> None:
        self.made.append(run.name)
        if run.name == self.fails:
            raise RuntimeError("has failed")
        path.mkdir(exist_ok=True)
        (path / "h").write_text(str(run.size))


@pytest.fixture
def toy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Toy:
    monkeypatch.setattr(driver, "software_version", lambda: "abc123")
    return Toy(tmp_path, monkeypatch)


def test_rows_verdicts_and_uncertainties(toy: Toy) -> None:
    failures, results = driver.run([toy.study], "full", 2)
    assert not failures
    rows = {(row.variant, row.resolution, row.quantity): row for row in results["toy"]}
    assert rows["", "0.1 m", "value"].value == pytest.approx(3.01)
    # Second order: 1.25 times the error; the coarsest has none
    assert rows["", "0.1 m", "value"].numerical_uncertainty == pytest.approx(0.0125)
    assert rows["", "0.2 m", "value"].numerical_uncertainty == pytest.approx(0.05)
    assert rows["", "0.4 m", "value"].numerical_uncertainty is None
    # Off by 0.04, but known only to 0.05; off by 0.16
    assert [rows["", f"{h} m", "value"].verdict for h in (0.1, 0.2, 0.4)] == ["yes", "no", "no"]
    assert rows["after", "0.1 m", "twin"].value == 0.1 and ("", "0.1 m", "twin") not in rows
    table = read(toy.study.folder / "result.csv")
    assert tuple(table[0]) == COLUMNS and len(table) == 5
    assert {row["version"] for row in table} == {"abc123"}


def test_what_another_run_makes_unsure_is_added(toy: Toy) -> None:
    toy.study.quantities = [Quantity("share", "1", lambda done: 3 + float((done.path / "h").read_text())**2, converges=True,
                                     unsure=lambda done: None if done.run.size == 0.2 else 0.03)]
    rows = {(row.variant, row.resolution): row.numerical_uncertainty for row in driver.run([toy.study], "full", 2)[1]["toy"]}
    assert [rows["", f"{h} m"] for h in (0.1, 0.2, 0.4)] == pytest.approx([(0.0125**2 + 0.03**2)**0.5, 0.05, 0.03])


def test_only_what_is_missing_is_made(toy: Toy) -> None:
    driver.run([toy.study], "quick", 1)
    assert len(toy.made) == 3
    driver.run([toy.study], "full", 1)
    assert len(toy.made) == 4 and toy.made[-1].endswith("after-0.1_m")
    # One that is declared otherwise is another run
    changed = Run("square", "meshes", "", "0.1 m", ("quick", "full"), given={"x": 1})
    toy.study.runs = [changed, *toy.study.runs[1:]]
    driver.run([toy.study], "full", 1)
    assert len(toy.made) == 5


def test_a_run_that_fails_is_told_and_others_go_on(toy: Toy) -> None:
    toy.fails = toy.study.runs[1].name
    (toy.study.folder / "expected.csv").write_text(",".join(driver.EXPECTED) + "\nsquare,meshes,,0.2 m,value,3.04,0.001\n")
    failures, results = driver.run([toy.study], "quick", 2)
    assert failures == [f"toy: {toy.fails}: has failed", "toy: square meshes  0.2 m value: no such figure; expected 3.04 +- 0.001"]
    assert len(results["toy"]) == 2
    toy.fails = ""
    assert driver.run([toy.study], "quick", 2)[0] == []


def test_an_unexpected_number_is_told(toy: Toy) -> None:
    (toy.study.folder / "expected.csv").write_text(",".join(driver.EXPECTED) + "\nsquare,meshes,,0.2 m,value,3.05,0.001\n")
    assert driver.run([toy.study], "quick", 2)[0] == ["toy: square meshes  0.2 m value: 3.04; expected 3.05 +- 0.001"]


def test_numbers_are_accepted(toy: Toy) -> None:
    """Those that are off, and only the numbers."""
    head, right, wrong = ",".join(driver.EXPECTED), "square,meshes,,0.1 m,value,3.0104,0.001", "square,meshes,,0.2 m,value,3.05,0.001"
    (toy.study.folder / "expected.csv").write_text("\n".join((head, right, wrong)) + "\n")
    failures, results = driver.run([toy.study], "quick", 2)
    assert len(failures) == 1
    driver.accept(toy.study, results["toy"])
    assert (toy.study.folder / "expected.csv").read_text().splitlines() == [head, right, wrong.replace("3.05", "3.04")]


def test_a_quantity_that_cannot_be_had_is_told(toy: Toy) -> None:
    toy.study.quantities = [Quantity("value", "1", lambda done: 1/0)]
    failures, _ = driver.run([toy.study], "quick", 2)
    assert len(failures) == 3 and "value: ZeroDivisionError" in failures[0]


def test_a_changed_checkout_does_not_write_results(toy: Toy, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture) -> None:
    monkeypatch.setattr(driver, "software_version", lambda: "abc123-dirty")
    driver.run([toy.study], "full", 2)
    assert not (toy.study.folder / "result.csv").exists() and (toy.study.folder / "run/result.csv").exists()
    assert "made by a changed checkout" in capsys.readouterr().out


def test_runs_of_other_sources_are_made_again_where_asked(toy: Toy, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(driver, "state", lambda version, paths: "stale" if version == "abc123" else "")
    driver.run([toy.study], "quick", 2)
    monkeypatch.setattr(driver, "software_version", lambda: "def456")
    driver.run([toy.study], "quick", 2)
    assert len(toy.made) == 3
    for _ in range(2):
        driver.run([toy.study], "quick", 2, again=True)
    assert len(toy.made) == 6


def test_rows_of_runs_that_are_declared_no_more_go(toy: Toy) -> None:
    row = Row("toy", "square", "meshes", "gone", "0.1 m", None, None, "value", 1.0, "1")
    resultTable.write(toy.study.folder / "result.csv", [row])
    driver.run([toy.study], "quick", 2)
    driver.run([toy.study], "full", 2, make=False)
    assert "gone" not in (toy.study.folder / "result.csv").read_text()


def test_needs_and_cores(tmp_path: Path) -> None:
    """A run begins when that which it needs is finished, however many cores there are."""
    order: List[str] = []
    runs = [Run("s", variant="second", needs="first", cores=2), Run("s", variant="first")]
    study = Study("t", runs, lambda run, path: order.append(run.variant), [], (), name="t")
    assert driver.run([study], "full", 2, tmp_path)[0] == [] and order == ["first", "second"]


def test_stale_rows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A change of a source makes a row stale; one elsewhere does not."""
    def git(*words: str) -> str:
        return subprocess.run(["git", "-c", "user.name=x", "-c", "user.email=x", *words], cwd=tmp_path, check=True, capture_output=True,
                              text=True).stdout.strip()

    monkeypatch.setattr(resultTable, "REPOSITORY", tmp_path)
    git("init", "-q")
    (tmp_path / "source").write_text("1")
    (tmp_path / "other").write_text("1")
    git("add", ".")
    git("commit", "-qm", "one")
    version = git("rev-parse", "--short", "HEAD")
    assert state(version, ("source",)) == "" and resultTable.software_version() == version
    (tmp_path / "other").write_text("2")
    assert resultTable.software_version() == f"{version}-dirty"
    state.cache_clear()
    assert state(version, ("source",)) == ""
    (tmp_path / "source").write_text("2")
    state.cache_clear()
    assert state(version, ("source",)) == "stale"
    assert state(f"{version}-dirty", ("source",)) == "changed checkout" and state("1234567", ("source",)) == "unknown version"
    git("commit", "-qam", "two")
    (tmp_path / "study").mkdir()
    (tmp_path / "study/result.csv").write_text("a result")
    git("add", ".")
    assert not resultTable.software_version().endswith("-dirty")


@pytest.mark.parametrize("name", names())
def test_declarations(name: str) -> None:
    """Each study has runs of both tiers, sources that exist, headlines among its quantities, and a table with the columns."""
    study = load(name)
    assert study.of_tier("quick") and study.of_tier("full")
    assert not [path for path in study.paths() if not (STUDIES.parents[1] / path).exists()]
    quantities = [quantity.name for quantity in study.quantities]
    assert set(study.headlines) <= set(quantities) and study.headlines
    assert all(run.size > 0 for run in study.runs)
    assert tuple(read(STUDIES / name / "result.csv")[0]) == COLUMNS


@pytest.mark.parametrize("path", sorted(references.REFERENCES.glob("*/*.csv")), ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_references_have_a_source_and_an_uncertainty(path: Path) -> None:
    head = [line for line in path.read_text().splitlines() if line.startswith("#")]
    assert len(head) >= 2 and head[-1].startswith("# Uncertainty: ") and len(head[0]) > 40
