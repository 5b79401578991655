# SPDX-License-Identifier: GPL-3.0-or-later
"""How fast is plungeSPH? The same dam break in plungeSPH and in PySPH, and the inner loops beside the processor's limits. Variants are
precision and threads. What cost is: plunge.studies.particleRates. Needs Debian's python3-pysph and python3-dev.

Allowed are 4 us for a particle and acoustic time, a tenth of what the paper's code took; two threads are to be 1.9 times as fast as one."""
from pathlib import Path

import numpy as np

from plunge.studies.particleRates import limits, measureLimits, memory, pysph, rates, start, timed
from plunge.studies.study import Done, Quantity, Run, Study, only, twin

SPACING = 0.022     # 63000 particles of fluid
# Operations for a candidate pair in three dimensions with WendlandC2, counted in interactionLoop.H; a multiplication, addition,
# comparison, root or quotient each. Both loops: r 3, r.r 5, q 3, f(q) 5, its volume 1. Density with Fourtakas' diffusion: velocity
# difference 3, its product with r 5, sum 2, hydrostatic difference 5, density difference 1, its correction 5, sum 2. Momentum
# with artificial viscosity: p + p 1, velocity difference 3, product 5, closing 1, mean density 3, 1/(r2 + eta2) 2, viscous 6, push 2, sums 6.
FLOPS = {"density": 17 + 23, "momentum": 17 + 29}
# Numbers of four bytes that it reads: position, velocity, density and volume; for the momentum also the pressure
BYTES = {"density": 4*8, "momentum": 4*9}
FLOAT, DOUBLE, NONE, LOOPS, PYSPH = "float", "double", "no density diffusion", "inner loops", "PySPH"


def solve(run: Run, path: Path) -> None:
    reference = path.parent / Run(run.scene, run.method, FLOAT, run.resolution).name
    if run.variant == LOOPS:
        return measureLimits(path, reference, run.size)
    if run.variant == PYSPH:
        loops = path.parent / Run(run.scene, run.method, LOOPS, run.resolution).name
        return pysph(path, reference, limits(loops)["pairs"], run.size)
    changes = f"geometry {{ spacing {run.size}; }} #remove speedOfSound\nspeedOfSound {{ c0 46; }} outputs {{ interval 1; }}"
    changes += " precision double;" if DOUBLE in run.variant else ""
    changes += " densityDiffusion none;\n#remove delta\n" if NONE in run.variant else ""
    timed(path, {"constant/particleProperties": changes, "system/controlDict":
                 f"endTime {100*run.size/46}; writeInterval 1; writeControl runTime;"}, run.cores)


def of(value, *variants: str):
    return only(value, lambda run: run.variant in variants)


def beside(value, variant: str, *variants: str):
    """A figure of runs of some variants and that of another one."""
    return twin(value, lambda run: run.variant in variants, variant=variant)


def cost(done: Done) -> float:
    return 1e6*rates(done.path).cost(done.run.size)


TIMED = [FLOAT, DOUBLE, *(f"{name}, 2 threads" for name in (FLOAT, DOUBLE)), *(f"{name}, {NONE}" for name in (FLOAT, DOUBLE))]
FASTEST = {"judged": lambda run: run.variant == FLOAT}
study = Study(
    title="plungeSPH is fast: beside PySPH, on two threads, and beside what the processor could do", alone=True,
    runs=[*(Run("kleefsman", "particles", variant, f"{SPACING} m", cores=1 + ("2 threads" in variant)) for variant in TIMED),
          Run("kleefsman", "particles", LOOPS, f"{SPACING} m", needs=FLOAT), Run("kleefsman", "particles", PYSPH, f"{SPACING} m", needs=LOOPS),
          Run("kleefsman", "particles", FLOAT, "0.028 m", ("quick",))],
    solve=solve, sources=("src/smoothedParticles", "applications/solvers/plungeSPH"),
    quantities=[
        Quantity("particles of the fluid", "1", of(lambda done: float(np.sum(start(done.path)["wall"] < 0)), FLOAT)),
        Quantity("time for a particle and acoustic time dp/c0", "us", of(cost, *TIMED, PYSPH), most=4, **FASTEST),
        Quantity("directed pairs inside the support", "million/s", of(lambda done: 1e-6*rates(done.path).pairs, *TIMED, PYSPH), least=100, **FASTEST),
        Quantity("time step over the acoustic time", "1", of(lambda done: rates(done.path).deltaT*46/done.run.size, *TIMED)),
        Quantity("memory for a particle, of fluid or walls", "byte", of(lambda done: memory(done.path), *TIMED)),
        *(Quantity("speed over that on one thread", "1", beside(lambda two, one: rates(two.path).steps/rates(one.path).steps, name,
                                                              f"{name}, 2 threads"), least=1.9) for name in (FLOAT, DOUBLE)),
        Quantity("PySPH's time for a particle and acoustic time over ours", "1", beside(
            lambda ours, theirs: cost(theirs)/cost(ours), PYSPH, *TIMED[-2:])),
        Quantity("pairs a second over PySPH's", "1", beside(lambda ours, theirs: rates(ours.path).pairs/rates(theirs.path).pairs, PYSPH, *TIMED[-2:])),
        Quantity("candidate pairs inside the support", "%", of(lambda d: 100*limits(d.path)["pairs"]/limits(d.path)["lanes"], LOOPS)),
        *(Quantity(f"processor, a core: {name}", unit, of(lambda d, k=key: 1e-9*limits(d.path)[k], LOOPS)) for name, key, unit in (
            ("multiplications and additions at most, as wide as the loops", "peak", "Gflop/s"), ("reading from L1", "L1", "GB/s"),
            ("reading from L2", "L2", "GB/s"), ("memory, triad of STREAM", "memory", "GB/s"))),
        *(Quantity(f"inner loop of {loop}, operations over the most possible", "%", of(lambda d, n=loop: 100*FLOPS[n]*limits(
            d.path)["lanes"]/limits(d.path)[n]/limits(d.path)["peak"], LOOPS)) for loop in FLOPS),
        *(Quantity(f"inner loop of {loop}, bytes over reading from L2", "%", of(lambda d, n=loop: 100*BYTES[n]*limits(
            d.path)["lanes"]/limits(d.path)[n]/limits(d.path)["L2"], LOOPS)) for loop in BYTES),
        Quantity("share of the two loops in a step", "%", beside(lambda loops, run: 100*sum(limits(loops.path)[n] for n in FLOPS)*rates(
            run.path).steps/np.sum(start(run.path)["wall"] < 0), FLOAT, LOOPS))],
    headlines=["time for a particle and acoustic time dp/c0", "PySPH's time for a particle and acoustic time over ours"])
