# SPDX-License-Identifier: GPL-3.0-or-later
"""How sure the headline numbers of the dive are: on three meshes, with half the time steps and with other boundary layers. Variants are fluids,
and what differs from the default dive; plunge.studies.headlineUncertainty says how the parts are found. Writes the case's uncertainty.csv, too,
from which plungePost says how sure the numbers of the same dive are.

A doubling of the resolution may change the velocity lost at full immersion by less than 10 %; the change is estimated from the two finer
meshes for first order."""
from functools import lru_cache
from pathlib import Path

from plunge.fluids import PAIRS
from plunge.foamDictionary import read
from plunge.results import read_numbers
from plunge.studies import REPOSITORY
from plunge.studies.headlineUncertainty import BOUNDARY_LAYERS, COARSE, DEFAULT, FINE, HALF_STEPS, ORDERS, RATIO, uncertainty, writeTable
from plunge.studies.particleRuns import CONTROL, override
from plunge.studies.scenes import prepare, solve as solveRun
from plunge.studies.study import Done, Quantity, Run, Study
from plunge.uncertainty import CAUSES, HEADLINES, TABLE, conditions

FACTORS = {FINE: RATIO, DEFAULT: 1, COARSE: 1/RATIO}
STEP_LIMITS = {"maxCo": "courantLimit", "maxAlphaCo": "interfaceCourantLimit", "maxDeltaT": "deltaTLimit"}
JUDGED, CASE = "velocity lost at full immersion", REPOSITORY / "cases/gannetPlunge"
numbers = lru_cache(maxsize=None)(lambda path: read_numbers(path / "results/summary.csv"))


def solve(run: Run, path: Path) -> None:
    if prepare(run, path, ["-fluids", run.given["fluids"]]) and HALF_STEPS in run.variant:
        given = read(path / "system/plungeGenerated")
        override(path, CONTROL, " ".join(f"{entry} {given[name]/2:g};" for entry, name in STEP_LIMITS.items()))
    solveRun(path)


def point(fluids: str, what: str) -> tuple:
    """Variant and resolution."""
    return fluids if what in FACTORS else f"{fluids}, {what}", f"fast {FACTORS[what]:g}" if what in (FINE, COARSE) else "fast"


def values(done: Done, name: str):
    """Of all dives into the fluids of the default one, this; None where one is missing."""
    fluids = done.run.given["fluids"]
    if (done.run.variant, done.run.resolution) != (fluids, "fast"):
        return None
    dives = {what: done.beside(**dict(zip(("variant", "resolution"), point(fluids, what)))) for what in (*FACTORS, HALF_STEPS, *BOUNDARY_LAYERS)}
    return {what: numbers(dive.path)[name][0] for what, dive in dives.items()} if all(dives.values()) else None


def part(name: str, of):
    return lambda done: (found := values(done, name)) and of(uncertainty(found), found)


def writeUncertainties(done, rows, clean: bool) -> None:
    for each in done:
        found = {name: uncertainty(of) for name in HEADLINES if (of := values(each, name))}
        if found and clean:
            writeTable(CASE / TABLE, conditions(each.path), numbers(each.path), found, each.record["version"])


study = Study(
    title="The dive's headline numbers hardly change on a finer mesh",
    runs=[*(Run("gannetPlunge", "meshes", *point(fluids, what), ("full", fluids) if fluids == "titan" else (fluids,),
                given={"fluids": fluids, "options": BOUNDARY_LAYERS.get(what, ())})
            for fluids in read(PAIRS)
            for what in (FINE, HALF_STEPS, *reversed(BOUNDARY_LAYERS), DEFAULT, COARSE)),
          *(Run("gannetPlunge", "meshes", "titan", f"fast {factor:g}", ("quick",), given={"fluids": "titan", "options": ("-set", "travel=0.08")})
            for factor in (0.5, 0.6, 0.75))],
    solve=solve, orders=ORDERS, after=writeUncertainties,
    sources=("src/freeSurfaceFlow", "src/oversetMethods", "src/rigidBody", "src/boundaryLayer", "applications/solvers/plungeFoam"),
    quantities=[
        *(Quantity(name, unit, lambda done, n=name: numbers(done.path)[n][0], converges=True)
          for name, unit in zip(HEADLINES, ("m/s2", "m/s2", "m/s", "s", "deg"))),
        *(Quantity(f"{name}: uncertainty by the {cause}", unit, part(name, lambda parts, _, i=i: parts[i]))
          for name, unit in zip(HEADLINES, ("m/s2", "m/s2", "m/s", "s", "deg")) for i, cause in enumerate(CAUSES)),
        *(Quantity(f"{name}: uncertainty over the number", "%", part(name, lambda parts, of: 100*parts.total/abs(of[DEFAULT]))) for name in HEADLINES),
        Quantity(f"{JUDGED}: change by doubling the resolution", "%", part(JUDGED, lambda _, of: 100*(of[FINE]/of[DEFAULT] - 1)*0.5/(1 - 1/RATIO)), 0,
                 tolerance=10)],
    headlines=[JUDGED, f"{JUDGED}: change by doubling the resolution"])
