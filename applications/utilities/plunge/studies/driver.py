# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs studies, judges them and keeps their results: what validation/run does."""

from __future__ import annotations

import argparse
import csv
import json
import os
import shutil
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from datetime import date
from math import hypot, isfinite
from pathlib import Path
from typing import Any, Iterator, Sequence

from plunge.results import CaseError
from plunge.studies import REPOSITORY
from plunge.studies.costFigure import errorAgainstCost
from plunge.studies.gridConvergence import gridConvergence, levels
from plunge.studies.resultTable import FAIL, Row, count, line, read, software_version, state, verdict, write
from plunge.studies.study import Done, Quantity, Run, Study, load, names, value_of

FIGURES = REPOSITORY / "docs/figures"
EXPECTED = ("scene", "method", "variant", "resolution", "quantity", "value", "tolerance")


class Cores:
    """Those that runs share; a run waits until its number is free."""

    def __init__(self, count: int) -> None:
        self.count, self.free, self.changed = count, count, threading.Condition()

    @contextmanager
    def taken(self, wanted: int) -> Iterator[None]:
        wanted = min(wanted, self.count)
        with self.changed:
            self.changed.wait_for(lambda: self.free >= wanted)
            self.free -= wanted
        try:
            yield
        finally:
            with self.changed:
                self.free += wanted
                self.changed.notify_all()


def record_of(folder: Path, run: Run) -> dict[str, Any] | None:
    """What a finished run left beside its directory; none where it is not finished, or declared otherwise since."""
    path = folder / f"{run.name}.json"
    record = json.loads(path.read_text()) if path.exists() else None
    return record if record and record["declared"] == run.declared else None


def execute(study: Study, run: Run, folder: Path, version: str, cores: Cores) -> None:
    """Makes a run that is missing; one that was interrupted goes on."""
    directory, mark = folder / run.name, folder / f"{run.name}.json"
    started = folder / f"{run.name}.started"
    if mark.exists() or started.exists() and started.read_text() != run.declared:
        shutil.rmtree(directory, ignore_errors=True)
        mark.unlink(missing_ok=True)
    started.write_text(run.declared)
    with cores.taken(cores.count if study.alone else run.cores):
        print(f"{study.name}: {run.name} begins", flush=True)
        began = time.monotonic()
        try:
            study.solve(run, directory)
        except Exception as error:
            # What has failed, unlike what was killed, begins anew
            started.write_text(f"failed: {error}")
            raise
        wall = time.monotonic() - began
    started.unlink()
    mark.write_text(json.dumps({"declared": run.declared, "version": version, "date": date.today().isoformat(), "wall_s": wall}))
    print(f"{study.name}: {run.name} finished in {wall:.0f} s", flush=True)


def solve(studies: Sequence[Study], tier: str, folders: dict[str, Path], cores: int, again: bool) -> list[str]:
    """Makes what is missing, in parallel, and again what was made from other sources than this checkout's. What has failed."""
    shared, version, failures = Cores(cores), software_version(), []

    def is_missing(study: Study, run: Run) -> bool:
        record = record_of(folders[study.name], run)
        return not record or again and bool(state(record["version"], tuple(study.paths())))

    missing = [(study, run) for study in studies for run in study.of_tier(tier) if is_missing(study, run)]
    print(f"{sum(len(study.of_tier(tier)) for study in studies)} runs of {len(studies)} studies, {len(missing)} to be made", flush=True)

    ended = {(study.name, run.key): threading.Event() for study, run in missing}

    def attempt(study: Study, run: Run) -> None:
        try:
            needed = replace(run, variant=run.needs)
            if run.needs and (study.name, needed.key) in ended:
                ended[study.name, needed.key].wait()
            if run.needs and not record_of(folders[study.name], needed):
                raise CaseError(f"needs {needed.name}, which is not finished")
            execute(study, run, folders[study.name], version, shared)
        except (Exception, SystemExit) as error:
            failures.append(f"{study.name}: {run.name}: {error}")
        finally:
            ended[study.name, run.key].set()

    # Those that others need first, then those with more cores, which would wait for all others
    with ThreadPoolExecutor(cores) as pool:
        list(pool.map(lambda each: attempt(*each), sorted(missing, key=lambda each: (bool(each[1].needs), -each[1].cores))))
    return failures


def finished(study: Study, tier: str, folder: Path) -> list[Done]:
    others: dict[tuple, Done] = {}
    for run in study.of_tier(tier):
        record = record_of(folder, run)
        if record:
            others[run.key] = Done(run, folder / run.name, record, others)
    return list(others.values())


def figure(quantity: Quantity, done: Done, study: Study) -> Row | None:
    """A row without a verdict; none where the run has no such quantity."""
    value = quantity.of(done)
    if value is None:
        return None
    run = done.run
    row = Row(study.name, run.scene, run.method, run.variant, run.resolution, done.cells, done.steps, quantity.name, float(value),
              quantity.unit, cpu_s=done.cpu, cores=run.cores, version=done.record["version"], date=done.record["date"])
    row.reference, row.numerical_uncertainty = value_of(quantity.reference, done), value_of(quantity.unsure, done)
    if quantity.judged(run):
        row.reference_uncertainty, row.tolerance = (value_of(number, done) for number in (quantity.uncertainty, quantity.tolerance))
        if quantity.most is not None or quantity.least is not None:
            row.reference = f"<= {quantity.most:g}" if quantity.most is not None else f">= {quantity.least:g}"
    return row


def converge(study: Study, rows: Sequence[Row]) -> list[str]:
    """The grid convergence index of quantities at three resolutions and more, as numerical uncertainties, beside those that a row has
    already; and what order was observed."""
    sizes = {run.key: run.size for run in study.runs}
    said = []
    for name in (quantity.name for quantity in study.quantities if quantity.converges):
        of = [row for row in rows if row.quantity == name and row.key[:-1] in sizes]
        for group in sorted({row.key[:3] for row in of}):
            ordered = sorted((row for row in of if row.key[:3] == group), key=lambda row: sizes[row.key[:-1]])
            h, values = [sizes[row.key[:-1]] for row in ordered], [row.value for row in ordered]
            for row, uncertainty in zip(ordered, levels(h, values, *study.orders)):
                known = [float(each) for each in (uncertainty, row.numerical_uncertainty) if each is not None]
                row.numerical_uncertainty = hypot(*known) if known else None
            if len(values) > 2 and all(map(isfinite, values[:3])):
                finest = gridConvergence(h[:3], values[:3], *study.orders)
                said.append(f"    {' '.join(filter(None, group))}: {name}: {finest.convergence}, observed order {finest.observedOrder:.3g}, "
                            f"extrapolated {finest.extrapolated:.6g}")
    return said


def judge(study: Study, done: Sequence[Done]) -> tuple[list[Row], list[str]]:
    """All figures of the finished runs, with their verdicts, which are printed; and which could not be had."""
    rows, of, failures = [], [], []
    for each in done:
        for quantity in study.quantities:
            try:
                row = figure(quantity, each, study)
            except Exception as error:
                failures.append(f"{study.name}: {each.run.name}: {quantity.name}: {type(error).__name__}: {error}")
            else:
                rows += [row] if row else []
                of += [(quantity, each)] if row else []
    orders = converge(study, rows)
    for row, (quantity, each) in zip(rows, of):
        row.verdict = quantity.word(each, verdict(row.value, row.reference, row.reference_uncertainty, row.numerical_uncertainty, row.tolerance))
    print(f"\n{study.name}: {study.title}", *map(line, rows), *orders, sep="\n")
    return rows, failures


def unexpected(study: Study, rows: Sequence[Row]) -> list[str]:
    """What expected.csv asserts of the quick tier and the rows do not say."""
    path = study.folder / "expected.csv"
    if not path.exists():
        return [f"{path}: expected what the quick tier asserts, in the columns {', '.join(EXPECTED)}"]
    found = {row.key: row for row in rows}
    said = []
    for wanted in read(path):
        key = tuple(wanted[name] for name in EXPECTED[:5])
        value, tolerance = float(wanted["value"]), float(wanted["tolerance"])
        if key not in found:
            said.append(f"{study.name}: {' '.join(key)}: no such figure; expected {value:g} +- {tolerance:g}")
        elif not abs(found[key].value - value) <= tolerance:
            said.append(f"{study.name}: {' '.join(key)}: {found[key].value:g}; expected {value:g} +- {tolerance:g}")
    return said + [f"{study.name}: {' '.join(row.key)}: {row.verdict}" for row in rows if row.verdict in FAIL[1:]]


def accept(study: Study, rows: Sequence[Row]) -> None:
    """Writes what was found into expected.csv, in place of the numbers that its rows have; their tolerances stay."""
    path, found = study.folder / "expected.csv", {row.key: row for row in rows}
    wanted = read(path)
    for row in wanted:
        new = found.get(tuple(row[name] for name in EXPECTED[:5]))
        if new and abs(new.value - float(row["value"])) > float(row["tolerance"]):
            row["value"] = f"{new.value:.5g}"
    with path.open("w", newline="") as file:
        out = csv.DictWriter(file, EXPECTED, lineterminator="\n")
        out.writeheader()
        out.writerows(wanted)


def keep(study: Study, done: Sequence[Done], rows: Sequence[Row], folder: Path) -> None:
    """What a clean checkout has made goes into result.csv and docs/figures, else into the folder of the runs."""
    clean = [row for row in rows if not row.version.endswith("-dirty")]
    if len(clean) == len(rows):
        write(study.folder / "result.csv", clean, [run.key for run in study.runs if run.tiers != ("quick",)])
    else:
        write(folder / "result.csv", rows)
        print(f"{study.name}: made by a changed checkout, hence only in {folder}; a clean one makes it with -again")
    figures = FIGURES if len(clean) == len(rows) else folder
    errorAgainstCost(study.title, rows, figures / f"{study.name}-cost.png")
    if study.figure:
        study.figure(done, figures / f"{study.name}.png")
    if study.after:
        study.after(done, rows, len(clean) == len(rows))


def run(studies: Sequence[Study], tier: str, cores: int, root: Path | None = None, make: bool = True,
        again: bool = False) -> tuple[list[str], dict[str, list[Row]]]:
    """Makes the runs in root/<study>, or else in the studies' own folders, and judges them. What went wrong, and the rows."""
    folders = {study.name: (root / study.name if root else study.folder / "run") for study in studies}
    for folder in folders.values():
        folder.mkdir(parents=True, exist_ok=True)
    failures = solve(studies, tier, folders, cores, again) if make else []
    results = {}
    for study in studies:
        done = finished(study, tier, folders[study.name])
        rows, missing = judge(study, done)
        results[study.name] = rows
        failures += missing
        if tier == "quick":
            failures += unexpected(study, rows)
        elif rows:
            keep(study, done, rows, folders[study.name])
    return failures, results


def listing() -> Iterator[str]:
    """Studies, their runs, and their results."""
    for study in map(load, names()):
        path = study.folder / "result.csv"
        rows = read(path) if path.exists() else []
        held, judged = count(row["verdict"] for row in rows)
        old = sum(bool(state(row["version"], tuple(study.paths()))) for row in rows)
        yield (f"{study.name:20s} {len(study.of_tier('full')):3d} runs, {len(study.of_tier('quick'))} quick; {held} of {judged} hold"
               f"{f', {old} of {len(rows)} rows not of this checkout' if old else ''}; {study.title}")


def main() -> int:
    parser = argparse.ArgumentParser(prog="validation/run", description="Run studies of validation/studies, judge them, write their result.csv.")
    parser.add_argument("names", nargs="*", metavar="NAME", help="of studies (default: all)")
    parser.add_argument("-tier", default="full", help="quick: seconds each, against expected.csv | full | one of a study's own (default: full)")
    parser.add_argument("-cores", type=int, default=len(os.sched_getaffinity(0)), help="that the runs share (default: %(default)s)")
    parser.add_argument("-list", action="store_true", help="say what there is, and run nothing")
    parser.add_argument("-judge-only", action="store_true", help="make no run, judge those that are finished")
    parser.add_argument("-again", action="store_true", help="make anew, too, what other sources or a changed checkout have made")
    parser.add_argument("-accept", action="store_true", help="of the quick tier: write the numbers found into expected.csv; say why in the commit")
    asked = parser.parse_args()
    if asked.list:
        print(*listing(), sep="\n")
        return 0
    studies = [study for study in map(load, asked.names or names()) if study.of_tier(asked.tier)]
    if not studies:
        parser.error(f"-tier {asked.tier}: no run of these studies belongs to it")
    try:
        failures, results = run(studies, asked.tier, asked.cores, make=not asked.judge_only, again=asked.again)
    except CaseError as error:
        sys.exit(f"validation/run: {error}")
    for study in studies if asked.accept and asked.tier == "quick" else ():
        accept(study, results[study.name])
    print(*failures, sep="\n", file=sys.stderr)
    held, judged = count(row.verdict for rows in results.values() for row in rows)
    print(f"\n{held} of {judged} judged figures hold" + (f"; {len(failures)} failures" if failures else ""))
    return 2 if failures else 1 if held < judged and asked.tier != "quick" else 0
