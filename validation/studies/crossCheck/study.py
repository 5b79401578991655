# SPDX-License-Identifier: GPL-3.0-or-later
"""The same dive on meshes and with particles, into Titan's liquid and into water; variants are fluids and boundary layer.

Nothing is judged: neither is the reference of the other. The particles slip over the body, so they are compared with dives on meshes without
a boundary layer. Decelerations are given as computed and as their running mean over the time in which the body moves by one spacing of
the particles: these resolve nothing that is shorter, but a weakly compressible liquid rings. The same mean is taken of all runs.
The first steps of a million particles tell what memory they need."""
import re
import subprocess
from pathlib import Path

import numpy as np

from plunge.results import TRAJECTORY_COLUMNS, particle_counts, read_numbers, read_table, solver_log
from plunge.studies.memory import peakMemory
from plunge.studies.particleRuns import CONTROL
from plunge.studies.scenes import prepare, solveScene
from plunge.studies.signals import Signal, rms
from plunge.studies.study import Done, Quantity, Run, Study, twin

WINDOW = 0.0145/25  # spacing of the particles over the speed [s]
MILLION = "first steps"


def solve(run: Run, path: Path) -> None:
    if run.variant != MILLION:
        return solveScene(run, path)
    prepare(run, path, changes={CONTROL: "endTime 5e-5; writeInterval 5e-5;"})
    subprocess.run(["plungeBodySurface", "-case", path], check=True)
    peakMemory(path, "plungeSPH", "-threads", "2")


def figures(done: Done) -> dict:
    if done.run.variant == MILLION:
        particles, log = sum(particle_counts(done.path)), solver_log(done.path)
        peak = 1024*float((done.path / "log.memory").read_text().split()[0])
        return {"particles with walls and body": particles, "peak memory": peak/2**30, "peak memory per particle": peak/particles,
                "computation's memory per particle": float(re.search(r"^Computation: .*, (\S+) MiB", log, re.M)[1])*2**20/particles}
    numbers = {name: value for name, (value, _) in read_numbers(done.path / "results/summary.csv").items()}
    table = read_table(done.path / "results/trajectory.csv", TRAJECTORY_COLUMNS)
    raw = Signal(table["time_s"], table["deceleration_m_s2"])
    mean, contact = raw.mean(WINDOW), numbers["contact time"]
    wet = mean.during(contact, np.inf)
    ringing = Signal(raw.time, raw.value - mean.value).during(contact, np.nan_to_num(numbers["full immersion time"], nan=np.inf))
    return {**numbers, "peak deceleration, running mean": float(wet.value.max()), "deceleration, rms about its mean": rms(ringing.value),
            "time from contact to peak, running mean": float(wet.time[wet.value.argmax()] - contact)}


def overlay(done, file: Path) -> None:
    dives = [each.path for each in done if each.run.variant != MILLION]
    subprocess.run(["plungeOverlay", *dives, "-mean", str(WINDOW), "-o", file], check=True)


UNITS = {"velocity lost at full immersion": "m/s", "peak deceleration": "m/s2", "peak deceleration, running mean": "m/s2",
         "time from contact to peak, running mean": "s", "deceleration, rms about its mean": "m/s2", "full immersion time": "s",
         "pitch change at full immersion": "deg"}
MEMORY = {"particles with walls and body": "1", "computation's memory per particle": "byte", "peak memory": "GiB", "peak memory per particle": "byte"}
study = Study(
    title="Meshes and particles side by side in the same dive",
    runs=[*(Run("gannetPlunge", method, f"{fluids}, boundary layer {layer}", resolution, (tier,), given={
              "options": ["-fluids", fluids, "-boundaryLayer", layer, *options]})
            for fluids in ("titan", "water") for method, layer in (("meshes", "auto"), ("meshes", "none"), ("particles", "none"))
            for resolution, tier, options in (("fast", "full", []), ("fast 0.5", "quick", ["-set", "travel=0.3"])) if tier == "full" or (fluids, layer) == ("titan", "none")),
          Run("gannetPlunge", "particles", MILLION, "fine", cores=2)],
    solve=solve, sources=("src/freeSurfaceFlow", "src/oversetMethods", "src/rigidBody", "src/smoothedParticles", "applications/solvers"),
    quantities=[*(Quantity(name, unit, lambda done, n=name: figures(done).get(n)) for name, unit in {**UNITS, **MEMORY}.items()),
                *(Quantity(f"{name}, over that of the mesh", "1", twin(lambda ours, mesh, n=name: figures(ours)[n]/figures(mesh)[n], method="meshes")) for name in UNITS)],
    headlines=["velocity lost at full immersion, over that of the mesh"], figure=overlay)
