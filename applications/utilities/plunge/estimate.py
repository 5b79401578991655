# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scene costs on this machine, by a short probe: the same scene, coarse, on one core.

A probe runs to the scene's end, or for PROBE_SECONDS of CPU time. From it come the time of a cell (particle) and step, the steps,
which go with the cells' size, memory and disk of a cell, and what the formula for the number of cells leaves out. A slender body
runs to its end at once."""

from __future__ import annotations

import csv
import os
import re
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Sequence

from plunge import case as cases
from plunge.case import Case
from plunge.checks import ParameterError
from plunge.methods.tiers import TEMPLATES
from plunge.results import cell_count, cpu_seconds, particle_counts

PROBE_SECONDS = 45.0
# Cells or particles of a probe, at most; its resolution is no finer than the scene's, and no coarser than it can be
_PROBE_COUNT = {"meshes": 9e3, "particles": 2e4}
_COARSEST = 0.25
# Errors that were measured over the whole ladder of methods and tiers; validation/run tradeoff writes it
ERRORS = TEMPLATES / "errors.csv"
# A resolution is as right as a measured one of up to this ratio
_NEAR = 1.25
# Of a solver without a mesh [kB]
_BASE_MEMORY = 95e3
# CPU time of a cell and step goes with this power of the number of cells: iterations of the pressure grow as meshes do
_GROWTH = {"meshes": 0.1, "particles": 0.0}


@dataclass(frozen=True)
class Probe:
    """What a coarse run has taken."""

    count: int          # cells or particles
    steps: float        # of the whole scene
    solver: float       # CPU time of a cell and step [s]
    set_up: float       # of the meshing, CPU time of a cell [s]
    memory: float       # of a cell [kB]
    frame: float        # disk of a cell and written time [kB]


def _directory_size(path: Path) -> int:
    return sum(file.stat().st_size for file in path.rglob("*") if file.is_file())


def _run(command: Sequence[str], run: Path, log: Path, limit: float = 600.0) -> tuple[float, float]:
    """CPU time [s] and largest memory [kB] of a command; after `limit` seconds of CPU time it is stopped."""
    with log.open("w") as file:
        process = subprocess.Popen(command, cwd=run, stdout=file, stderr=subprocess.STDOUT, env={**os.environ, "PWD": str(run)})
        ticks = os.sysconf("SC_CLK_TCK")
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                process.returncode = os.waitstatus_to_exitcode(status)
                break
            fields = Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
            if (int(fields[11]) + int(fields[12])) / ticks > limit:
                process.terminate()
            time.sleep(0.1)
    if process.returncode not in (0, -15):
        said = log.read_text(errors="replace")
        raise ParameterError(f"the probe's {command[0]} failed:\n{said[max(said.rfind('--> FOAM'), len(said) - 1500):]}")
    return usage.ru_utime + usage.ru_stime, float(usage.ru_maxrss)


def _probe(scene: Path, entries: dict[str, Any], resolution: float, run: Path) -> tuple[Probe, Case]:
    asked = {**entries, "resolution": resolution, "cores": 1}
    coarse = cases.derive(scene, asked)
    cases.write(coarse, run, asked)
    method = coarse.options["method"]
    set_up, _ = _run([str(run / "Allrun"), "-setUp"], run, run / "log.Allrun")
    solver = coarse.flat["application"]
    used, memory = _run([solver, *(["-threads", "1"] if method == "particles" else [])], run, run / f"log.{solver}", PROBE_SECONDS)
    log = (run / f"log.{solver}").read_text(errors="replace")
    count = cell_count(run) if method == "meshes" else sum(particle_counts(run))
    if method == "particles":
        told = [(float(t), float(dt)) for t, dt in re.findall(r"^Time = (\S+)  dt (\S+) s", log, re.M)]
        reached = told[-1][0] if told else 0.0
        steps = reached * len(told) / sum(dt for _, dt in told) if told else 0.0
    else:
        times = re.findall(r"^Time = (\S+)", log, re.M)
        steps, reached = float(len(times)), float(times[-1]) if times else 0.0
    if steps < 5 or reached <= 0:
        raise ParameterError(f"the probe came no further than step {steps:.0f} in {PROBE_SECONDS:.0f} s; expected a coarser tier")
    whole = steps * coarse.scene.duration / reached
    frames = [path for path in run.iterdir() if re.fullmatch(r"[0-9][0-9.e+-]*", path.name) and path.name != "0"]
    disk = (_directory_size(frames[0]) if frames else _directory_size(run / "0")) if method == "meshes" else \
        _directory_size(run / "VTK") / max(1, len(list((run / "VTK").glob("particles*.vt*"))))
    # A log that was cut off may have no time yet
    return Probe(count, whole, (cpu_seconds(run) or used) / (count * steps), set_up / count, max(0.0, memory - _BASE_MEMORY) / count,
                 disk / 1000 / count), coarse


def _duration(seconds: float) -> str:
    return f"{seconds:.2g} s" if seconds < 1 else f"{seconds:.0f} s" if seconds < 120 else f"{seconds / 60:.0f} min" if seconds < 7200 else f"{seconds / 3600:.1f} h"


def _megabytes(value: float) -> str:
    return f"{value:.0f} MB" if value < 2e3 else f"{value / 1e3:.1f} GB"


@dataclass(frozen=True)
class Estimate:
    """Of a scene by a method."""

    unit: str           # cells or particles
    count: float
    steps: float
    set_up: float       # CPU time of the meshing [s]
    solver: float       # and of the solver [s]
    cores: int
    memory: float       # [MB]
    disk: float         # [MB]
    frames: int
    errors: str         # that such a run had where they were measured

    @property
    def elapsed(self) -> float:
        """With all cores at work [s]"""
        return self.set_up + self.solver / self.cores

    def __str__(self) -> str:
        return "\n".join([
            f"{self.unit:<12} {self.count:,.0f}",
            f"steps        {self.steps:,.0f}",
            f"CPU time     {_duration(self.set_up + self.solver)}, of which the solver {_duration(self.solver)}; on {self.cores} core(s) "
            f"at best {_duration(self.elapsed)}",
            f"memory       {_megabytes(self.memory)}",
            f"disk         {_megabytes(self.disk)}, {self.frames} written times",
            f"error        {self.errors}",
        ])


def of(scene: Path, entries: dict[str, Any], case: Case) -> Estimate:
    """By a probe in a temporary directory, which is announced on stderr."""
    method, resolution = case.options["method"], float(case.options["resolution"])
    if method == "slenderBody":
        return _run_at_once(scene, entries, case)
    ratio = _PROBE_COUNT[method] / case.count
    dimensions = 2 if case.flat["model"] in ("plane", "axisymmetric") else 3
    probed = max(_COARSEST, min(0.5 * resolution, resolution * ratio ** (1 / dimensions)))
    while True:
        print(f"Probing at resolution {probed:.2g} (up to {PROBE_SECONDS:.0f} s) ...", file=sys.stderr, flush=True)
        try:
            with tempfile.TemporaryDirectory(prefix="plungeEstimate") as folder:
                probe, coarse = _probe(scene, entries, probed, Path(folder).resolve() / "run")
            break
        except ParameterError:
            if probed >= resolution:
                raise
            # Too coarse for thin parts of the body
            probed = min(resolution, 2 * probed)

    count = case.count * probe.count / coarse.count
    steps = probe.steps * resolution / probed * _coarser(case, coarse)
    growth = (count / probe.count) ** _GROWTH[method]
    cores = case.options["cores"]
    processes = cores if method == "meshes" else 1
    return Estimate(case.unit, count, steps, probe.set_up * count, probe.solver * growth * count * steps, cores,
                    (processes * _BASE_MEMORY + probe.memory * count) / 1000,
                    probe.frame * count * (case.scene.frames + 1) / 1000, case.scene.frames, expected_errors(case))


def expected_errors(case: Case) -> str:
    """Of the scene that was measured and is most like this one: a slender body's dive or a cone's fall, by the same method, mesh and resolution."""
    options, flat = case.options, case.flat
    unknown = "not measured for such a run (docs/results/tradeoff.md)"
    if not ERRORS.is_file() or "bodyLength" not in flat:
        return unknown
    alike = "fallingCone" if flat["model"] in ("axisymmetric", "quarter") else "gannetPlunge"
    variant = {"meshes": flat["mesh"], "particles": "single", "slenderBody": "strips"}[options["method"]] if alike == "gannetPlunge" else ""
    found: dict[str, list[str]] = {}
    with ERRORS.open(newline="") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if (row["scene"], row["method"], row["variant"]) != (alike, options["method"], variant):
                continue
            tier, _, factor = row["resolution"].partition(" ")
            ratio = float(options["resolution"]) / float(factor or 1)
            if not tier or tier == options["tier"] and 1 / _NEAR < ratio < _NEAR:
                found.setdefault(row["resolution"], []).append(f"{row['quantity']} {float(row['error_percent']):.2g} %")
    if not found:
        return unknown
    level, errors = min(found.items(), key=lambda item: abs(float(item[0].partition(" ")[2] or 1) - float(options["resolution"])))
    return f"{', '.join(errors)} ({alike} at {level or 'any resolution'}; docs/results/tradeoff.md)"


def _run_at_once(scene: Path, entries: dict[str, Any], case: Case) -> Estimate:
    """Of a run that takes less than a second: by that run."""
    with tempfile.TemporaryDirectory(prefix="plungeEstimate") as folder:
        run = Path(folder).resolve() / "run"
        cases.write(case, run, entries)
        seconds, memory = _run(["slenderBody"], run, run / "log.slenderBody")
        steps = re.search(r"^(\d+) steps", (run / "log.slenderBody").read_text(), re.M)
        disk = _directory_size(run) / 1e6
    made = float(steps[1]) if steps else 0.0
    return Estimate(case.unit, made, made, 0.0, seconds, 1, memory / 1000, disk, 1, expected_errors(case))


def _coarser(case: Case, coarse: Case) -> float:
    """How much the smallest cells differ beyond the resolution: counts are whole numbers."""
    if "noseSpacing" not in case.flat:
        return 1.0
    finer = case.options["resolution"] / coarse.options["resolution"]
    return float(coarse.flat["noseSpacing"] / case.flat["noseSpacing"] / finer)
