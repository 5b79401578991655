#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare titanThermophysicalModels with other codes, published tables and public timings: writes result.csv.

    compare.py RUN      RUN holds speed.csv (titanSpeed); pictures and the compared states go there too

Reference figures (reference/, each row with its source):
    properties.csv  CoolProp 7.2.0 (the same formulation), AGA8's GERG-2008 (shorter pure fluids), TITANPOOL, PC-SAFT,
                    tables of the publications
    titanpool.csv   TITANPOOL's table, thinned out
Tolerances are those of the references: the same formulation must agree to round-off of the printed digits (1e-5; 1e-4 for
heat capacity), AGA8's other pure fluids to 0.15 %, TITANPOOL to 0.1 % in density and 6 % in viscosity.
"""
import argparse
import csv
import subprocess
import sys
from pathlib import Path
from typing import Callable, Dict, List, Optional, Tuple

from plunge.studies.pictures import pyplot
from plunge.studies.resultTable import Row, judge, limit, read, show, write
from plunge.titanProperties import titanProperties

HERE = Path(__file__).resolve().parent

STATE = ("x_N2", "x_CH4", "x_C2H6", "x_C3H8", "phase", "T_K", "p_Pa")
TITANPOOL_PRESSURE = 147000  # Pa
GERG_SOLUBILITY = 0.0388     # of nitrogen in ethane at 92 K and 150 kPa

# Public timings [us]: AGA8's GERG-2008 (C++, 3bdb9ab8) for density and properties of a ternary, CoolProp 7.2.0 for a
# mixture at (T, p) and for a bubble point
AGA8_WARM, AGA8_COLD, COOLPROP_STATE, COOLPROP_BUBBLE = 3.4, 6.2, 164.0, 5000.0


def evaluate(states: List[Dict[str, str]], run: Path, name: str) -> List[Dict[str, str]]:
    """What titanProperties says of the states, in their order."""
    path = run / f"{name}.csv"
    with path.open("w", newline="") as file:
        out = csv.DictWriter(file, STATE, extrasaction="ignore", lineterminator="\n")
        out.writeheader()
        out.writerows(states)
    answer = subprocess.run(["titanProperties", "-states", path, "-format", "csv"], check=True, stdout=subprocess.PIPE,
                            text=True).stdout
    (run / f"{name}.evaluated.csv").write_text(answer)
    return list(csv.DictReader(answer.splitlines()))


def worst(reference: List[Dict[str, str]], answers: List[Dict[str, str]], column: str,
          chosen: Callable[[Dict[str, str]], bool]) -> Optional[Tuple[float, int]]:
    """Largest relative difference in a column over the chosen rows, and their number; a refusal counts as infinite."""
    found = [abs(float(ours[column]) / float(row[column]) - 1) if ours[column] else float("inf")
             for row, ours in zip(reference, answers) if chosen(row) and row[column] and row["p_Pa"]]
    return (max(found), len(found)) if found else None


def properties_rows(run: Path) -> List[Row]:
    """Comparison with reference/properties.csv, code by code."""
    reference = [row for row in read(HERE / "reference/properties.csv") if row["p_Pa"]]
    answers = evaluate(reference, run, "properties")
    codes = (
        ("CoolProp", {"density_kg_m3": 1e-5, "speed_of_sound_m_s": 1e-5, "cp_J_kgK": 1e-4}),
        ("AGA8", {"density_kg_m3": 1.5e-3, "speed_of_sound_m_s": None, "cp_J_kgK": None}),
        ("TITANPOOL", {"density_kg_m3": 1e-3, "viscosity_Pa_s": 6e-2, "surface_tension_N_m": None}),
        ("dcordier", {"density_kg_m3": None}),
    )
    names = {"dcordier": "PC-SAFT (Tan 2013)", "AGA8": "AGA8 GERG-2008", "CoolProp": "CoolProp", "TITANPOOL": "TITANPOOL"}
    rows = []
    for code, tolerances in codes:
        for column, tolerance in tolerances.items():
            found = worst(reference, answers, column, lambda row, code=code: row["source"].startswith(code))
            if not found:
                continue
            quantity = f"{names[code]}: largest relative difference in {column}, {found[1]} states"
            rows.append(judge(quantity, found[0], "1", 0, tolerance) if tolerance else Row(quantity, found[0], "1"))
    # The same correlations for the pure fluids; ethane's viscosity is a newer one than CoolProp's
    for column in ("viscosity_Pa_s", "conductivity_W_mK", "surface_tension_N_m"):
        for label, chosen in (("", lambda row: not row["label"].startswith("Ethane")),
                              (", ethane", lambda row: row["label"].startswith("Ethane"))):
            found = worst(reference, answers, column,
                          lambda row, chosen=chosen: row["source"].startswith("CoolProp") and chosen(row))
            if found:
                rows.append(Row(f"CoolProp, pure fluids{label}: largest relative difference in {column}, {found[1]} states",
                                found[0], "1"))
    return rows


def titanpool_rows(run: Path) -> List[Row]:
    """Comparison with TITANPOOL's table: the states at its compositions, and the dissolved nitrogen."""
    reference = [dict(row, x_C3H8="0", phase="liquid", p_Pa=str(TITANPOOL_PRESSURE))
                 for row in read(HERE / "reference/titanpool.csv")]
    answers = evaluate(reference, run, "titanpool")
    rows = []
    for column, tolerance in (("density_kg_m3", 1e-3), ("viscosity_Pa_s", 6e-2)):
        found = worst(reference, answers, column, lambda row: True)
        assert found
        rows.append(judge(f"TITANPOOL's table: largest relative difference in {column}, {found[1]} states", found[0], "1", 0,
                          tolerance))
    dissolved = {}
    for share in sorted({float(row["methane_share"]) for row in reference}):
        dissolved[share] = nitrogen(f"CH4 {share:g} C2H6 {1 - share:g}", "(90 100 1)", TITANPOOL_PRESSURE)
    differences = [abs(dissolved[float(row["methane_share"])][float(row["T_K"])] - float(row["x_N2"])) for row in reference]
    rows.append(judge(f"TITANPOOL's table: largest difference in dissolved nitrogen, {len(differences)} states",
                      max(differences), "mole fraction", 0, 1e-3))
    return rows


def nitrogen(alkanes: str, T: str, p: float) -> Dict[float, float]:
    """Mole fraction of nitrogen that titanProperties dissolves in alkanes at p [Pa], by temperature [K]; T: one or a range."""
    return {float(row["T_K"]): float(row["x_N2"]) for row in titanProperties("-saturate", alkanes, "-T", T, "-p", f"{p:g}")}


def speed_rows(run: Path) -> List[Row]:
    """Timings of this run over the public ones."""
    speed = {row["evaluation"]: float(row["time_us"]) for row in read(run / "speed.csv")}
    table = max(time for name, time in speed.items() if name.startswith("table"))

    def ratio(what: str, name: str, against: float, code: str) -> Row:
        return limit(f"{what}: {speed[name]:.3g} us here, over {code}'s {against:g} us", speed[name] / against, "1", 1)

    return [
        ratio("Density and properties of a ternary, warm start", "density and properties, warm start, ternary", AGA8_WARM,
              "AGA8"),
        ratio("Density and properties of a ternary, cold start", "density and properties, cold start, ternary", AGA8_COLD,
              "AGA8"),
        ratio("The same, cold start", "density and properties, cold start, ternary", COOLPROP_STATE, "CoolProp"),
        ratio("Bubble point of a ternary", "bubble point, ternary", COOLPROP_BUBBLE, "CoolProp"),
        limit("Bubble point of a ternary", speed["bubble point, ternary"], "us", 100),
        limit("Slowest table, one property of one cell", 1000 * table, "ns", 50),
    ]


def speed_picture(run: Path, aga8_difference: float) -> None:
    """Error against time of one evaluation; AGA8's density differs by aga8_difference [-] from the direct model's."""
    rows = read(run / "speed.csv")
    figure, axes = pyplot.subplots(figsize=(8, 5), layout="constrained")
    for quantity, marker in (("density", "o"), ("viscosity", "s")):
        chosen = [row for row in rows if row["evaluation"].endswith(f"field of {quantity}")]
        for kind, colour in (("constant", "tab:green"), ("table", "tab:blue"), ("direct", "tab:red")):
            points = [(1000 * float(row["time_us"]), max(float(row["relative_error"]), 1e-12))
                      for row in chosen if row["evaluation"].startswith(kind)]
            axes.loglog(*zip(*points), marker, color=colour, label=f"{kind}, {quantity}", markersize=7,
                        markerfacecolor="none" if quantity == "viscosity" else colour)
    axes.plot(1000 * AGA8_WARM, aga8_difference, "k*", markersize=11, label="AGA8's GERG-2008, density\nand properties, warm start")
    axes.set_xlabel("time of one property of one cell [ns]")
    axes.set_ylabel("largest relative error against the direct model")
    axes.set_title("Three speeds of one liquid: 0.05 N$_2$, 0.25 CH$_4$, 0.70 C$_2$H$_6$ at 90-98 K and 0.1-2 MPa",
                   fontsize=11)
    axes.grid(alpha=0.3)
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False)
    figure.savefig(run / "speed.png", dpi=150)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", type=Path, help="directory with speed.csv, for all that is written")
    run = parser.parse_args().run

    solubility = nitrogen("C2H6 1", "92", 150000)[92]
    rows = properties_rows(run) + titanpool_rows(run)
    rows.append(judge("Nitrogen dissolved in ethane at 92 K and 150 kPa, against AGA8's GERG-2008", solubility,
                      "mole fraction", GERG_SOLUBILITY, 1e-3))
    rows += speed_rows(run)
    aga8 = next(row for row in rows if row.quantity.startswith("AGA8 GERG-2008: largest relative difference in density"))
    speed_picture(run, float(aga8.value))
    write(HERE / "result.csv", rows)
    show(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
