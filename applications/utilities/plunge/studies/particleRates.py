# SPDX-License-Identifier: GPL-3.0-or-later
"""How fast particles are computed: plungeSPH, PySPH on the same particles, and the inner loops beside the processor's limits.

Cost is the time for a particle of the fluid and an acoustic time dp/c0, so that a longer time step counts. Pairs are directed,
inside the support, of the fluid with all; each counts once in a step, though density and momentum have a loop each.
Rates are medians of a run's progress lines, a second each, and the better of two runs, for other work on a machine only slows down."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Mapping, NamedTuple

import numpy as np

from plunge.studies.particleRuns import LOG, particles, series
from plunge.studies.scenes import prepareCase, solve
from plunge.studies.study import STUDIES

FOLDER = STUDIES / "particleSpeed"
C0, RHO0, ALPHA, DELTA = 46.0, 1000.0, 0.02, 0.1
SKIN = 0.3                  # search radius beyond the support over the spacing, of particleFlow.C
PYSPH_STEPS = 7
RATES, LIMITS = "rates.json", "limits.json"


class Rates(NamedTuple):
    """Of a run, in all threads together."""
    steps: float    # particle steps [1/s]
    pairs: float    # [1/s]
    deltaT: float   # [s]

    def cost(self, spacing: float) -> float:
        """Seconds for a particle and an acoustic time."""
        return spacing/C0/self.deltaT/self.steps


def timed(run: Path, changes: Mapping[str, str], threads: int) -> None:
    """The better of two runs, in run/0 and run/1."""
    found = []
    for part in (run / "0", run / "1"):
        prepareCase("kleefsman", part, ["-method", "particles", "-np", str(threads)], changes)
        solve(part)
        lines = re.findall(r"dt (\S+) s,.*\| (\S+) million particle steps/s, (\S+) million pairs/s", (part / LOG).read_text())
        # The first has the start in it, the last may be short
        middle = np.median(np.array(lines[1:-1] or lines, float), axis=0)
        found.append(Rates(1e6*middle[1], 1e6*middle[2], middle[0]))
    (run / RATES).write_text(json.dumps(max(found)))


def rates(run: Path) -> Rates:
    return Rates(*json.loads((run / RATES).read_text()))


def start(run: Path) -> dict[str, np.ndarray]:
    """Particles that a timed run began with."""
    return particles(series(run / "0")[0][1])


def memory(run: Path) -> float:
    """Bytes for each particle, of fluid and walls."""
    log = (run / "0" / LOG).read_text()
    fluid, walls = map(int, re.search(r"Start: (\d+) of the fluid, (\d+) of walls", log).groups())
    return float(re.search(r", (\S+) MiB", log).group(1))*2**20/(fluid + walls)


def measureLimits(run: Path, reference: Path, spacing: float) -> None:
    """The loops alone and the processor: loopLimits.C, on the start of a timed run."""
    shutil.rmtree(run, ignore_errors=True)
    run.mkdir(parents=True)
    of = start(reference)
    np.column_stack([of["x"], of["rho"] - RHO0, of["wall"] < 0]).astype("<f8").tofile(run / "particles")
    wide = ["-mavx2", "-mfma"] if " avx2 " in Path("/proc/cpuinfo").read_text() else []
    subprocess.run(["g++", "-std=c++14", "-O3", "-Wno-psabi", *wide, f"-I{os.environ['PLUNGE_DIR']}/src/smoothedParticles/lnInclude",
                    str(FOLDER / "loopLimits.C"), "-o", str(run / "loopLimits"), f"-L{os.environ['PLUNGE_LIBBIN']}", "-lsmoothedParticles",
                    "-Wl,--unresolved-symbols=ignore-in-shared-libs"], check=True)
    output = subprocess.run([str(run / "loopLimits"), str(run / "particles"), *map(str, (spacing, 1.5*spacing, C0, RHO0, ALPHA, DELTA, SKIN))],
                            check=True, stdout=subprocess.PIPE, text=True).stdout
    words = dict(line.split() for line in output.splitlines())
    words.pop("instructions")
    (run / LIMITS).write_text(json.dumps({name: float(value) for name, value in words.items()}))


def limits(run: Path) -> dict[str, float]:
    return json.loads((run / LIMITS).read_text())


def pysph(run: Path, reference: Path, pairs: float, spacing: float) -> None:
    """PySPH on the start of a timed run; pairs: in a step."""
    of = start(reference)
    run.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "particles.npz"
        np.savez(file, h=1.5*spacing, spacing=spacing, c0=C0, rho0=RHO0, alpha=ALPHA, **{name: of[name] for name in ("x", "rho", "wall")})
        done = subprocess.run([str(FOLDER / "pysphDamBreak.py"), str(file), str(PYSPH_STEPS)], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"PySPH failed; expected Debian's python3-pysph and python3-dev:\n{done.stderr[-3000:]}")
    step, seconds = map(float, re.search(r"^step (\S+) seconds (\S+)$", done.stdout, re.MULTILINE).groups())
    (run / RATES).write_text(json.dumps(Rates(float(np.sum(of["wall"] < 0))/seconds, pairs/seconds, step)))
