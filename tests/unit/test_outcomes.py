# SPDX-License-Identifier: GPL-3.0-or-later
"""The rule that classifies runs which may end in any way."""
from pathlib import Path
from types import SimpleNamespace

import pytest

from plunge.studies import driver, outcomes
from plunge.studies.outcomes import command, end_of
from plunge.studies.resultTable import FAIL, HOLD, count
from plunge.studies.study import Quantity, Run, Study

REFUSAL = "--> FOAM FATAL IO ERROR: \nEntry mass is 0\nExpected: a mass above 0"
HEADER = "trapFpe: Floating point exception trapping enabled (FOAM_SIGFPE).\n"


@pytest.mark.parametrize("status, said, error, end", [
    (0, "", outcomes.ERROR, "finished"), (None, REFUSAL, outcomes.ERROR, "hang"), (1, HEADER + REFUSAL, outcomes.ERROR, "refused"),
    (1, REFUSAL, "Entry speed", "crash"), (1, "no such thing", outcomes.ERROR, "crash"), (1, "Traceback (most recent call last):\nexpected", outcomes.ERROR, "crash"),
    (139, REFUSAL, outcomes.ERROR, "crash"), (-11, REFUSAL, outcomes.ERROR, "crash"), (1, "#1  Foam::sigFpe::sigHandler(int)\nexpected", outcomes.ERROR, "crash")])
def test_ends(status, said, error, end) -> None:
    assert end_of(status, said, error) == end


def test_a_command_that_hangs_is_stopped() -> None:
    assert command("bash", "-c", "echo begun; sleep 60", limit=0.5) == (None, "begun\n")
    assert command("bash", "-c", "echo said >&2; exit 3") == (3, "said\n")


@pytest.mark.parametrize("verdict, says, word", [
    ("yes", "", "right"), ("no", "too coarse", "degraded"), ("no", "too fine", "silent"), ("no", "", "silent")])
def test_words(verdict: str, says: str, word: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(outcomes, "told", lambda path: "nose: too coarse")
    assert outcomes.word(SimpleNamespace(path=Path(), run=Run(given={"says": says})), verdict) == word


def test_what_is_silent_fails_every_tier(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And so does what should have been refused, and was not."""
    monkeypatch.setattr(driver, "software_version", lambda: "abc123")
    monkeypatch.setattr(outcomes, "told", lambda path: "")
    monkeypatch.setattr(Study, "folder", property(lambda study: tmp_path))
    (tmp_path/"expected.csv").write_text(",".join(driver.EXPECTED) + "\n")

    def solve(run: Run, path: Path) -> None:
        outcomes.keep(path, run.given["status"], "expected")

    study = Study(title="toy", name="toy", sources=("src",), solve=solve,
                  runs=[Run("toy", "", name, tiers=("quick",), given={"status": status, "figure": figure})
                        for name, status, figure in (("wrong", 0, "two"), ("refused", 1, "two"), ("let through", 0, ""))],
                  quantities=[Quantity("two", "1", outcomes.of_finished(lambda done: 2.1, "two"), 2, tolerance=0, word=outcomes.word),
                              Quantity("exit status", "1", lambda done: outcomes.exit_status(done) or (None if done.run.given["figure"] else 0), word=outcomes.ending)])
    failures, results = driver.run([study], "quick", 1, tmp_path)
    assert {(row.variant, row.verdict) for row in results["toy"]} == {("wrong", "silent"), ("refused", "refused"), ("let through", "silent")}
    assert sorted(failures) == ["toy: toy  let through  exit status: silent", "toy: toy  wrong  two: silent"]


def test_verdicts_are_counted() -> None:
    assert count([*HOLD, *FAIL, ""]) == (4, 8)
