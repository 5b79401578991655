#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times plungeSPH on cases/kleefsman, and PySPH on the same particles, and the inner loops beside the processor: result.csv.

Cost is the time for a particle of the fluid and an acoustic time dp/c0, so that a longer time step counts. Pairs are directed,
inside the support, of the fluid with all; each counts once in a step, though density and momentum have a loop each.
Rates are medians of a run's progress lines, a second each, and the better of two runs, for other work on a machine only slows down."""
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Dict, List, NamedTuple

import numpy as np

from plunge.results import cpu_seconds
from plunge.studies.particleRuns import LOG, particles, series, setUp, solve
from plunge.studies.resultTable import Row, least, limit, show, write

FOLDER = Path(__file__).resolve().parent
RUNS = FOLDER / "run"
SPACING = 0.022             # 63000 particles of fluid
H = 1.5*SPACING
C0, RHO0, ALPHA, DELTA = 46.0, 1000.0, 0.02, 0.1
SKIN = 0.3                  # search radius beyond the support over the spacing, of particleFlow.C
ACOUSTIC = SPACING/C0       # [s]
DURATION = 100*ACOUSTIC
PYSPH_STEPS = 7

# Operations for a candidate pair in three dimensions with WendlandC2, counted in interactionLoop.H; a multiplication, addition,
# comparison, root or quotient each. Both loops: r 3, r.r 5, q 3, f(q) 5, its volume 1. Density with Fourtakas' diffusion: velocity
# difference 3, its product with r 5, sum 2, hydrostatic difference 5, density difference 1, its correction 5, sum 2. Momentum
# with artificial viscosity: p + p 1, velocity difference 3, product 5, closing 1, mean density 3, 1/(r2 + eta2) 2, viscous 6, push 2,
# sums 6.
FLOPS = {"density": 17 + 23, "momentum": 17 + 29}
# Numbers of four bytes that it reads: position, velocity, density and volume; for the momentum also the pressure
BYTES = {"density": 4*8, "momentum": 4*9}

VARIANTS = {
    "float": {},
    "double": {"precision": "double"},
    "float, no density diffusion": {"densityDiffusion": "none"},
    "double, no density diffusion": {"densityDiffusion": "none", "precision": "double"},
}


class Rates(NamedTuple):
    """Of a run, in all threads together."""
    steps: float    # particle steps [1/s]
    pairs: float    # [1/s]
    deltaT: float   # [s]

    def cost(self) -> float:
        """Seconds for a particle and an acoustic time."""
        return ACOUSTIC/self.deltaT/self.steps


def prepare(run: Path, changes: Dict[str, str]) -> None:
    """The case, with entries that can also be left out."""
    setUp("kleefsman", run, {"geometry/spacing": SPACING, "speedOfSound": f"{{ c0 {C0}; }}", "outputs/interval": 1, **changes},
          endTime=DURATION, writeInterval=1, writeControl="runTime")
    if changes.get("densityDiffusion") == "none":
        path = run / "constant/particleProperties"
        path.write_text(re.sub(r"\ndelta .*", "", path.read_text()))


def timed(name: str, threads: int) -> Rates:
    """The better of two runs."""
    found: List[Rates] = []
    for repetition in range(2):
        run = RUNS / f"{name.replace(', ', '_').replace(' ', '_')}_{threads}_{repetition}"
        prepare(run, VARIANTS[name])
        solve(run, "-threads", threads)
        lines = re.findall(r"dt (\S+) s,.*\| (\S+) million particle steps/s, (\S+) million pairs/s", (run / LOG).read_text())
        # The first has the start in it, the last may be short
        middle = np.median(np.array(lines[1:-1] or lines, float), axis=0)
        found.append(Rates(1e6*middle[1], 1e6*middle[2], middle[0]))
    return min(found, key=Rates.cost)


def memory(run: Path) -> float:
    """Bytes for each particle, of fluid and walls."""
    log = (run / LOG).read_text()
    fluid, walls = map(int, re.search(r"Start: (\d+) of the fluid, (\d+) of walls", log).groups())
    return float(re.search(r", (\S+) MiB", log).group(1))*2**20/(fluid + walls)


def pysph(start: Dict[str, np.ndarray], pairsOfSum: float) -> Rates:
    """PySPH on the same particles."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "particles.npz"
        np.savez(file, h=H, spacing=SPACING, c0=C0, rho0=RHO0, alpha=ALPHA, **{name: start[name] for name in ("x", "rho", "wall")})
        done = subprocess.run([str(FOLDER / "pysphDamBreak.py"), str(file), str(PYSPH_STEPS)], cwd=folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise SystemExit(f"measure.py: PySPH failed:\n{done.stderr[-3000:]}")
    step, seconds = map(float, re.search(r"^step (\S+) seconds (\S+)$", done.stdout, re.MULTILINE).groups())
    return Rates(np.sum(start["wall"] < 0)/seconds, pairsOfSum/seconds, step)


def limits(start: Dict[str, np.ndarray]) -> Dict[str, float]:
    """The loops alone and the processor: loopLimits.C."""
    with tempfile.TemporaryDirectory() as folder:
        file, program = Path(folder) / "particles", Path(folder) / "loopLimits"
        np.column_stack([start["x"], start["rho"] - RHO0, start["wall"] < 0]).astype("<f8").tofile(file)
        wide = ["-mavx2", "-mfma"] if " avx2 " in Path("/proc/cpuinfo").read_text() else []
        subprocess.run(["g++", "-std=c++14", "-O3", "-Wno-psabi", *wide, f"-I{os.environ['PLUNGE_DIR']}/src/smoothedParticles/lnInclude",
                        str(FOLDER / "loopLimits.C"), "-o", str(program), f"-L{os.environ['PLUNGE_LIBBIN']}", "-lsmoothedParticles",
                        "-Wl,--unresolved-symbols=ignore-in-shared-libs"], check=True)
        output = subprocess.run([str(program), str(file), *map(str, (SPACING, H, C0, RHO0, ALPHA, DELTA, SKIN))], check=True,
                                stdout=subprocess.PIPE, text=True).stdout
    words = dict(line.split() for line in output.splitlines())
    print("Loops:", words.pop("instructions"))
    return {name: float(value) for name, value in words.items()}


def main() -> None:
    cores = len(os.sched_getaffinity(0))
    shutil.rmtree(RUNS, ignore_errors=True)
    rates = {}
    for name in ("float", "double"):
        for threads in (1, 2)[:cores]:
            rates[name, threads] = timed(name, threads)
    for name in ("float, no density diffusion", "double, no density diffusion"):
        rates[name, 1] = timed(name, 1)
    first = RUNS / "float_1_0"
    start = particles(series(first)[0][1])
    machine = limits(start)
    peer = pysph(start, machine["pairs"])
    rows: List[Row] = []
    cpu = cpu_seconds(first)

    def us(name: str, threads: int) -> float:
        return 1e6*rates[name, threads].cost()

    fast = rates["float", 1]
    rows.append(Row("particles of the fluid", float(np.sum(start["wall"] < 0)), "-"))
    rows.append(limit("float, 1 thread: time for a particle and acoustic time dp/c0", us("float", 1), "us", 4, cpu))
    rows.append(least("float, 1 thread: directed pairs inside the support", 1e-6*fast.pairs, "million/s", 100, cpu))
    rows.append(Row("float, 1 thread: time step over the acoustic time", fast.deltaT/ACOUSTIC, "-", cpu_s=cpu))
    rows.append(Row("float: memory for a particle, of fluid or walls", memory(first), "bytes"))
    rows.append(Row("double, 1 thread: time for a particle and acoustic time dp/c0", us("double", 1), "us"))
    rows.append(Row("double, 1 thread: directed pairs inside the support", 1e-6*rates["double", 1].pairs, "million/s"))
    for name in ("float", "double"):
        if cores < 2:
            continue
        two = rates[name, 2]
        rows.append(Row(f"{name}, 2 threads: time for a particle and acoustic time dp/c0", us(name, 2), "us"))
        rows.append(Row(f"{name}, 2 threads: directed pairs inside the support, for each thread", 0.5e-6*two.pairs, "million/s"))
        rows.append(least(f"{name}: speed on 2 threads over that on 1", two.steps/rates[name, 1].steps, "-", 1.9))
    rows.append(Row("PySPH, double, 1 thread: time for a particle and acoustic time dp/c0", 1e6*peer.cost(), "us"))
    rows.append(Row("PySPH, double, 1 thread: directed pairs inside the support", 1e-6*peer.pairs, "million/s"))
    for name in ("double", "float"):
        same = rates[f"{name}, no density diffusion", 1]
        rows.append(Row(f"{name}, no density diffusion, 1 thread: PySPH's time over plungeSPH's, for a particle and acoustic time",
                        peer.cost()/same.cost(), "-"))
        rows.append(Row(f"{name}, no density diffusion, 1 thread: plungeSPH's pairs a second over PySPH's", same.pairs/peer.pairs, "-"))

    rows.append(Row("inner loops: candidate pairs inside the support", 100*machine["pairs"]/machine["lanes"], "%"))
    rows.append(Row("processor: multiplications and additions at most, a core, as wide as the loops", 1e-9*machine["peak"], "Gflop/s"))
    rows += [Row(f"processor: reading from {level}, a core", 1e-9*machine[level], "GB/s") for level in ("L1", "L2")]
    rows.append(Row("processor: memory, a core, triad of STREAM", 1e-9*machine["memory"], "GB/s"))
    for name in ("density", "momentum"):
        seconds = machine[name]
        rows.append(Row(f"inner loop of {name}: {FLOPS[name]} operations for a candidate pair, of the most possible",
                        100*FLOPS[name]*machine["lanes"]/seconds/machine["peak"], "%"))
        rows.append(Row(f"inner loop of {name}: {BYTES[name]} bytes for a candidate pair, of reading from L2",
                        100*BYTES[name]*machine["lanes"]/seconds/machine["L2"], "%"))
    step = 1/fast.steps*np.sum(start["wall"] < 0)
    rows.append(Row("share of the two loops in a step", 100*(machine["density"] + machine["momentum"])/step, "%"))
    write(FOLDER / "result.csv", rows)
    show(rows)


if __name__ == "__main__":
    main()
