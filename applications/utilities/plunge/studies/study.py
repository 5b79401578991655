# SPDX-License-Identifier: GPL-3.0-or-later
"""What a study declares: the matrix of its runs, how one is made, what is measured of each and against what that is judged."""

from __future__ import annotations

import importlib.util
import re
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import isfinite
from pathlib import Path
from typing import Any, Callable, Iterator, Mapping, Sequence, Union

from plunge.results import CaseError, cell_count, cpu_seconds, gather, particle_counts, solver_name
from plunge.studies import REPOSITORY
from plunge.studies.foamFields import times

STUDIES = REPOSITORY / "validation/studies"


@dataclass(frozen=True)
class Run:
    """A point of the matrix; what is empty does not tell it from the others.

    resolution: a length or a time step, "0.005 m"; or [TIER] [FACTOR] of the counts in each direction, "fast 1.5"."""

    scene: str = ""                     # of cases/, or what stands in for one
    method: str = ""                    # meshes | particles
    variant: str = ""                   # solver where it is not ours, model, scheme, time step
    resolution: str = ""
    tiers: tuple[str, ...] = ("full",)  # that it belongs to: quick, full, or one of its study's own
    cores: int = 1
    given: Mapping[str, Any] = field(default_factory=dict, compare=False)  # what the study's solve needs beside
    needs: str = ""                     # variant of the run that must be finished before

    @property
    def key(self) -> tuple[str, str, str, str]:
        return self.scene, self.method, self.variant, self.resolution

    @property
    def name(self) -> str:
        """Of its directory."""
        words = "-".join(word for word in self.key if word) or "run"
        return "".join(c if c.isalnum() or c in "-.+=" else "_" for c in words)

    @property
    def declared(self) -> str:
        """What a run was made from: one that says something else is another run."""
        return repr((self.key, sorted(self.given.items())))

    @property
    def graded(self) -> bool:
        """Is its resolution a tier, not a length or a time step?"""
        return not self.resolution.endswith((" m", " s"))

    @property
    def grade(self) -> tuple[str, str]:
        """Tier and factor of the counts, where they have no length."""
        tier, factor, *_ = [*re.findall("[a-z]+", self.resolution), "fast"][:1] + [*re.findall(r"[\d.]+", self.resolution), "1"]
        return tier, factor

    @property
    def size(self) -> float:
        """Of a cell, a spacing or a time step, in a unit that the runs of a study share."""
        number, *unit = self.resolution.split() or [""]
        return float(number) if unit in (["m"], ["s"]) else 1/float(self.grade[1])


class Done:
    """A finished run, and the others of its study beside it."""

    def __init__(self, run: Run, path: Path, record: Mapping[str, Any], others: Mapping[tuple, Done]) -> None:
        self.run, self.path, self.record, self.others = run, path, record, others

    def beside(self, **changes: str) -> Done | None:
        """The finished run that differs in these; None where it was not made."""
        return self.others.get(replace(self.run, **changes).key)

    @cached_property
    def cells(self) -> int | None:
        """Of the mesh, or particles of the fluid."""
        try:
            return particle_counts(self.path)[0] if solver_name(self.path) == "plungeSPH" else cell_count(self.path)
        except CaseError:
            return None

    @cached_property
    def steps(self) -> int | None:
        """As the solver has counted them, over restarts."""
        try:
            last = self.path / (times(self.path) or ["0"])[-1] / "uniform/time"
        except OSError:
            return None
        found = re.search(r"^index\s+(\d+);", last.read_text(), re.M) if last.exists() else None
        return int(found[1]) if found else None

    @cached_property
    def cpu(self) -> float | None:
        """Of the solver [s]."""
        try:
            return cpu_seconds(self.path)
        except CaseError:
            return None

    @cached_property
    def track(self) -> Any:
        """The table of the body's motion, whole over restarts."""
        return gather(self.path)["trajectory"]


Number = Union[None, float, Callable[[Done], Union[None, float]]]


@dataclass(frozen=True)
class Quantity:
    """A figure of a run. It is judged where it has a reference or a bound, and `judged` says so of the run.

    of: its value; None where a run has none, nan where it should have one.
    uncertainty: of the reference, as the measurements scatter; tolerance: what is allowed beyond it; unsure: what the figure's numerical
    uncertainty has from another run, of which it is a share, beside that from its own resolutions."""

    name: str
    unit: str
    of: Callable[[Done], Union[None, float]]
    reference: Number = None
    uncertainty: Number = None
    tolerance: Number = None
    most: float | None = None
    least: float | None = None
    judged: Callable[[Run], bool] = lambda run: True
    word: Callable[[Done, str], str] = lambda done, verdict: verdict    # the verdict's, where a run may end in any way
    converges: bool = False         # three resolutions of it have an order and a grid convergence index
    unsure: Number = None


@dataclass
class Study:
    """title says what the judged figures show; sources are the paths of the repository, beside the scenes, on which they depend."""

    title: str
    runs: Sequence[Run]
    solve: Callable[[Run, Path], object]
    quantities: Sequence[Quantity]
    sources: Sequence[str]
    headlines: Sequence[str] = ()           # names of quantities that stand for the study
    figure: Callable[[Sequence[Done], Path], None] | None = None
    alone: bool = False                     # its runs are timed: nothing else runs beside them
    orders: tuple[float, float] = (1, 2)    # in which an observed order is held
    after: Callable[..., None] | None = None    # what the full tier leaves beside its rows: of runs, rows, and whether the checkout was clean
    name: str = ""

    @property
    def folder(self) -> Path:
        return STUDIES / self.name

    def of_tier(self, tier: str) -> list[Run]:
        return [run for run in self.runs if tier in run.tiers]

    def paths(self) -> list[str]:
        """What its rows depend on."""
        scenes = {f"cases/{run.scene}" for run in self.runs if (REPOSITORY / "cases" / run.scene).is_dir() and run.scene}
        return [*self.sources, *sorted(scenes)]


def names() -> list[str]:
    return sorted(path.parent.name for path in STUDIES.glob("*/study.py"))


def module(name: str) -> Any:
    """The module of validation/studies/<name>/study.py."""
    path = STUDIES / name / "study.py"
    if not path.is_file():
        raise SystemExit(f"no study '{name}': expected one of {' '.join(names())}")
    spec = importlib.util.spec_from_file_location(f"study_{name}", path)
    assert spec and spec.loader
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    loaded.study.name = name
    keys = [run.key for run in loaded.study.runs]
    if len(set(keys)) < len(keys):
        raise SystemExit(f"{path}: two runs alike in scene, method, variant and resolution; expected different ones")
    return loaded


def load(name: str) -> Study:
    return module(name).study


def only(value: Callable[[Done], Any], which: Callable[[Run], bool]) -> Callable[[Done], Any]:
    """A figure of some runs."""
    return lambda done: value(done) if which(done.run) else None


def twin(value: Callable[[Done, Done], Any], which: Callable[[Run], bool] = lambda run: True, **changes: str) -> Callable[[Done], Any]:
    """A figure of a run and of that beside it which differs in these; none where there is no such run, or it is the same."""
    def of(done: Done) -> Any:
        other = done.beside(**changes) if which(done.run) else None
        return value(done, other) if other and other is not done else None
    return of


def value_of(number: Number, done: Done) -> float | None:
    return number(done) if callable(number) else number


def finite(values: Sequence[Union[None, float]]) -> Iterator[float]:
    return (value for value in values if value is not None and isfinite(value))
