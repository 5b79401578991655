# SPDX-License-Identifier: GPL-3.0-or-later
"""titanThermophysicalModels against other codes, published tables and public timings. Variants are their names.

Tolerances are those of the references: the same formulation must agree to round-off of the printed digits (1e-5; 1e-4 for
heat capacity), AGA8's other pure fluids to 0.15 %, TITANPOOL to 0.1 % in density and 6 % in viscosity."""
from pathlib import Path

from plunge.studies.liquids import TIMINGS, drawSpeed, evaluate, evaluated, nitrogen, published, time_us, timeEvaluations, worst
from plunge.studies.study import Done, Quantity, Run, Study

STATES = {name: (name, "states", "") for name in ("CoolProp", "AGA8", "TITANPOOL", "PC-SAFT", "publishedTables")}
STATES["TITANPOOL saturated"] = ("TITANPOOL", "saturated", "147000")    # [Pa]
COLUMNS = ("density_kg_m3", "speed_of_sound_m_s", "cp_J_kgK", "viscosity_Pa_s", "conductivity_W_mK", "surface_tension_N_m")
TOLERANCES = {("CoolProp", "density_kg_m3"): 1e-5, ("CoolProp", "speed_of_sound_m_s"): 1e-5, ("CoolProp", "cp_J_kgK"): 1e-4,
              ("AGA8", "density_kg_m3"): 1.5e-3, ("TITANPOOL", "density_kg_m3"): 1e-3, ("TITANPOOL", "viscosity_Pa_s"): 6e-2,
              ("TITANPOOL saturated", "density_kg_m3"): 1e-3, ("TITANPOOL saturated", "viscosity_Pa_s"): 6e-2}
GERG_SOLUBILITY = 0.0388    # of nitrogen in ethane at 92 K and 150 kPa, mole fraction, by AGA8's GERG-2008
# Public timings [us]: AGA8's GERG-2008 (C++, 3bdb9ab8), CoolProp 7.2.0 at (T, p)
TERNARY = "density and properties, {} start, ternary"
PUBLIC = {("AGA8", TERNARY.format("warm")): 3.4, ("AGA8", TERNARY.format("cold")): 6.2,
          ("CoolProp", TERNARY.format("cold")): 164, ("CoolProp", "bubble point, ternary"): 5000}


def solve(run: Run, path: Path) -> None:
    if run.variant == TIMINGS:
        timeEvaluations(path)
    else:
        evaluate(published(*STATES[run.variant]), path)


def difference(column: str, ethane: bool):
    """Ethane's transport properties are newer ones than CoolProp's, and stand apart."""
    def of(done: Done):
        apart = done.run.variant == "CoolProp" and column in COLUMNS[3:]
        if done.run.variant == TIMINGS or ethane and not apart:
            return None
        return worst(published(*STATES[done.run.variant]), evaluated(done.path), column,
                     lambda row: not apart or row["label"].startswith("Ethane") == ethane)
    return of


def dissolved(done: Done):
    if done.run.variant != "TITANPOOL saturated":
        return None
    states = published(*STATES[done.run.variant])
    return max(abs(nitrogen(f"CH4 {row['methane_share']} C2H6 {1 - float(row['methane_share']):g}", "(90 100 1)", row["p_Pa"])[float(row["T_K"])]
                   - float(row["x_N2"])) for row in states)


study = Study(
    title="Titan's liquids agree with other codes and published tables, and are evaluated faster",
    runs=[*(Run(variant=name, tiers=("quick", "full")) for name in STATES), Run(variant=TIMINGS)],
    solve=solve, sources=("src/titanThermophysicalModels", "applications/utilities/titanProperties", "applications/utilities/titanSpeed"),
    quantities=[
        *(Quantity(f"largest relative difference in {column}{' of ethane' if ethane else ''}", "1", difference(column, ethane), reference=0,
                   tolerance=lambda done, c=column: TOLERANCES[done.run.variant, c],
                   judged=lambda run, c=column, e=ethane: (run.variant, c) in TOLERANCES and not e)
          for ethane in (False, True) for column in (COLUMNS[3:] if ethane else COLUMNS)),
        Quantity("largest difference in dissolved nitrogen", "mole fraction", dissolved, reference=0, tolerance=1e-3),
        Quantity("nitrogen dissolved in ethane", "mole fraction", lambda done: nitrogen("C2H6 1", "92", "150000")[92]
                 if done.run.variant == "AGA8" else None, reference=GERG_SOLUBILITY, tolerance=1e-3),
        *(Quantity(f"time of {what} over {code}'s", "1", lambda done, w=what, us=us: time_us(done, w, over=us), most=1)
          for (code, what), us in PUBLIC.items()),
        Quantity("time of bubble point, ternary", "us", lambda done: time_us(done, "bubble point, ternary"), most=100),
        Quantity("time of a table's property of a cell", "ns", lambda done: time_us(done, "table", over=1e-3), most=50)],
    headlines=["largest relative difference in density_kg_m3"], figure=drawSpeed)
