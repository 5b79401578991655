# SPDX-License-Identifier: GPL-3.0-or-later
"""titanProperties: its formats, its batches, and what it refuses."""

import csv
import io
import os
import subprocess
from pathlib import Path

import pytest

STATE = ["x_N2", "x_CH4", "x_C2H6", "x_C3H8", "phase", "T_K", "p_Pa"]
ADDED = ["density_kg_m3", "speed_of_sound_m_s", "cp_J_kgK", "viscosity_Pa_s", "conductivity_W_mK",
         "surface_tension_N_m"]
HEADER = ",".join(STATE) + "\n"
LAKE = "0.05,0.25,0.70,0,liquid,94,146700"
LAKES = ["Kraken", "Ligeia", "Punga", "Ontario"]


def run(*arguments: str, stdin: str = "", **options) -> subprocess.CompletedProcess:
    return subprocess.run(["titanProperties", *arguments], input=stdin, text=True, capture_output=True, **options)


def answer(*arguments: str, stdin: str = "") -> str:
    done = run(*arguments, stdin=stdin)
    assert done.returncode == 0, done.stderr
    return done.stdout


def refusal(*arguments: str, stdin: str = "") -> str:
    """The error of a command that must fail, and must leave standard output empty."""
    done = run(*arguments, stdin=stdin)
    assert done.returncode == 1, done
    assert done.stdout == ""
    assert done.stderr.startswith("titanProperties: error: ")
    assert done.stderr.count("\n") == 1
    return done.stderr


def rows(text: str) -> list[dict]:
    return list(csv.DictReader(io.StringIO(text)))


def batch(content: str) -> list[dict]:
    return rows(answer("-states", "-", "-format", "csv", stdin=content))


def message(row: str) -> str:
    """Of a row that must be refused, between two that must not be."""
    before, refused, after = batch(HEADER + LAKE + "\n" + row + "\n" + LAKE + "\n")
    assert float(before["density_kg_m3"]) == float(after["density_kg_m3"]) > 0
    assert all(refused[name] == "" for name in ADDED), refused
    assert refused["message"]
    return refused["message"]


# --- batches -------------------------------------------------------------------


def test_batch_is_pure_csv_that_repeats_the_states():
    text = answer("-states", "-", "-format", "csv", stdin=HEADER + LAKE + "\n")
    lines = text.splitlines()
    assert lines[0].split(",") == STATE + ADDED + ["message"]
    assert lines[1].startswith(LAKE + ",")
    assert len(lines) == 2


def test_batch_of_a_file_into_a_file(tmp_path):
    (tmp_path / "in.csv").write_text(HEADER + LAKE + "\n")
    out = tmp_path / "out.csv"
    assert answer("-states", str(tmp_path / "in.csv"), "-output", str(out)) == ""
    assert rows(out.read_text())[0]["phase"] == "liquid"


# CoolProp 7.2.0 with the same pure equations and GERG-2008 mixing: density and sound speed must agree to 1e-5, heat
# capacity to 1e-4; its own conductivities are of other equations and left out. Viscosity where both use one equation.
COOLPROP = """\
x_N2,x_CH4,x_C2H6,x_C3H8,phase,T_K,p_Pa,density_kg_m3,speed_of_sound_m_s,cp_J_kgK,viscosity_Pa_s
0,1,0,0,liquid,91,150000,451.15904,1536.7738,3368.0357,0.0002041546
0,0,1,0,liquid,92,150000,649.78636,1997.3192,2314.7328,
0.331940,0.668060,0,0,liquid,88,150000,561.71454,1226.046,2679.9356,
0.043200,0.239200,0.717600,0,liquid,94,150000,618.10157,1856.5459,2459.3087,
0.030000,0.300000,0.470000,0.200000,liquid,95,1000000,630.1135,1901.9774,2378.736,
1,0,0,0,gas,88,150000,6.0056146,186.48227,1119.2423,6.196487e-06
0.943,0.057,0,0,gas,92,146700,5.4600862,192.97889,1159.5165,
"""


def test_batch_agrees_with_CoolProp():
    tolerances = {"density_kg_m3": 1e-5, "speed_of_sound_m_s": 1e-5, "cp_J_kgK": 1e-4, "viscosity_Pa_s": 2e-3}
    for found, reference in zip(batch(COOLPROP), rows(COOLPROP), strict=True):
        for name, tolerance in tolerances.items():
            if reference[name]:
                assert float(found[name]) == pytest.approx(float(reference[name]), rel=tolerance), (name, reference)


# Steckloff et al. 2020, tables of nitrogen-saturated lakes (TITANPOOL): density to 0.1 %, viscosity to 6 %
TITANPOOL = """\
x_N2,x_CH4,x_C2H6,x_C3H8,phase,T_K,p_Pa,density_kg_m3,viscosity_Pa_s
0.089595,0.4552,0.4552,0,liquid,90,147000,588.96,0.00046958
0.04269,0.23933,0.71798,0,liquid,94,147000,618.03,0.00065147
0.12682,0.87318,0,0,liquid,96,147000,483.51,0.00015287
"""


def test_batch_agrees_with_TITANPOOL():
    for found, reference in zip(batch(TITANPOOL), rows(TITANPOOL), strict=True):
        assert float(found["density_kg_m3"]) == pytest.approx(float(reference["density_kg_m3"]), rel=1e-3)
        assert float(found["viscosity_Pa_s"]) == pytest.approx(float(reference["viscosity_Pa_s"]), rel=0.06)


def test_columns_in_any_order_further_columns_quotes_and_line_ends():
    text = ('\ufeffT_K,label, p_Pa ,phase,x_C3H8,x_C2H6,x_CH4,x_N2\r\n'
            '94,"a lake, so ""called""\nKraken",146700,liquid,0,"0.70",0.25,0.05\r\n'
            '\r\n   \r\n'
            '94,plain,146700,liquid,0,0.70,0.25,0.05')
    first, second = batch(text)
    assert [first[name] for name in STATE] == LAKE.split(",")
    assert first == second
    assert first["density_kg_m3"] == batch(HEADER + LAKE)[0]["density_kg_m3"]


def test_cells_are_repeated_verbatim():
    row, = batch(HEADER + "5e-2,.25,0.700000, 0,liquid,+94.0,1.467e5\n")
    assert [row[name] for name in STATE] == ["5e-2", ".25", "0.700000", " 0", "liquid", "+94.0", "1.467e5"]
    assert row["density_kg_m3"]


def test_gas_has_no_surface_tension_and_no_message():
    row, = batch(HEADER + "0.943,0.057,0,0,gas,93.7,146700\n")
    assert row["surface_tension_N_m"] == ""
    assert all(row[name] for name in ADDED[:-1])
    assert row["message"] == ""


def test_a_metastable_state_has_values_and_a_message():
    row, = batch(HEADER + "0.20,0.20,0.60,0,liquid,94,146700\n")
    assert all(row[name] for name in ADDED)
    assert row["message"].endswith(".")


def test_ten_digits():
    row, = batch(HEADER + LAKE + "\n")
    assert len(row["density_kg_m3"].replace(".", "")) >= 9


@pytest.mark.parametrize("cells, column, word", [
    ("0.05,0.25,0.70,0,liquid,warm,146700", "T_K", "warm"),
    ("0.05,0.25,0.70,0,liquid,nan,146700", "T_K", "nan"),
    ("0.05,0.25,0.70,0,liquid,94,inf", "p_Pa", "inf"),
    ("0.05,0.25,0.70,0,liquid,94,", "p_Pa", "missing"),
    ("0.05,0.25,0.70,0,liquid,94", "p_Pa", "missing"),
    ("0.05,0.25,0.70,0,,94,146700", "phase", "missing"),
    ("0.05,0.25,,0,liquid,94,146700", "x_C2H6", "missing"),
    ('0.05,"0,25",0.70,0,liquid,94,146700', "x_CH4", "0,25"),
    ("0x1p-4,0.25,0.70,0,liquid,94,146700", "x_N2", "0x1p-4"),
    ("0.05 0.25,0.70,0,liquid,94,146700,", "x_N2", "0.05 0.25"),
])
def test_a_bad_cell_is_named_by_line_and_column(cells, column, word):
    text = message(cells)
    assert f"standard input, line 3, column {column}" in text
    assert word in text


@pytest.mark.parametrize("cells, word", [
    ("0.05,0.25,0.70,0,solid,94,146700", "solid"),
    ("0.05,0.25,0.70,0,liquid,20,146700", "20"),
    ("0.05,0.25,0.70,0,liquid,400,146700", "400"),
    ("0.05,0.25,0.70,0,liquid,94,-1", "-1"),
    ("0.05,0.25,0.702,0,liquid,94,146700", "1.002"),
    ("-0.05,0.35,0.70,0,liquid,94,146700", "-0.05"),
    ("0,0,0,0,liquid,94,146700", "0"),
    ("0,0,1,0,gas,94,1e7", "gas"),
    ("0.05,0.25,0.70,0,liquid,94,146700,146700", "8 cells"),
    ('0.05,0.25,0.70,0,"liquid,94,146700', "quotation mark"),
    (",,,,,,", "missing"),
])
def test_a_refused_state_says_why_and_the_others_come(cells, word):
    assert word in message(cells)


def test_sums_within_a_thousandth_are_normalised():
    exact, rounded = batch(HEADER + LAKE + "\n0.050025,0.250125,0.70035,0,liquid,94,146700\n")
    assert float(rounded["density_kg_m3"]) == pytest.approx(float(exact["density_kg_m3"]), rel=1e-9)


@pytest.mark.parametrize("content, words", [
    ("", ["empty"]),
    ("\n\n", ["empty"]),
    (HEADER.replace("x_C3H8,", "") + "\n", ["line 1", "x_C3H8", "missing"]),
    (HEADER.replace(",", ";"), ["line 1", "x_N2", "missing"]),
    ("T_K," + HEADER, ["line 1", "T_K", "two columns"]),
])
def test_a_bad_header_ends_the_batch(content, words):
    text = refusal("-states", "-", stdin=content)
    assert all(word in text for word in words), text


def test_a_file_that_is_not_there_and_a_directory(tmp_path):
    assert "none.csv" in refusal("-states", str(tmp_path / "none.csv"))
    assert str(tmp_path) in refusal("-states", str(tmp_path))


def test_many_rows():
    row, *others = batch(HEADER + (LAKE + "\n") * 2000)
    assert len(others) == 1999
    assert all(other == row for other in others)


# --- one state and ranges ------------------------------------------------------


@pytest.mark.parametrize("name", LAKES)
def test_a_lake_as_a_table(name):
    text = answer(name)
    for word in (name, "density", "kg/m3", "viscosity", "uPa s", "surface tension", "mN/m", "+-", "%", "Sources",
                 "Kunz and Wagner", "mole fractions"):
        assert word in text, word


def test_every_name_of_the_list_has_properties():
    names = [row["name"] for row in rows(answer("-list", "-format", "csv"))]
    assert set(LAKES) < set(names)
    for name in names:
        assert float(rows(answer(name, "-format", "csv"))[0]["density_kg_m3"]) > 0
        assert name in answer("-list")


def test_the_list_is_a_batch():
    """What -list writes can be read by -states; constants have no composition and are refused there."""
    listed = rows(answer("-list", "-format", "csv"))
    found = rows(answer("-states", "-", stdin=answer("-list", "-format", "csv")))
    assert [bool(row["x_N2"]) for row in listed] == [bool(row["density_kg_m3"]) for row in found]


def test_the_paper_is_constants():
    row, = rows(answer("astraeusPaper", "-format", "csv"))
    assert float(row["density_kg_m3"]) == 664
    assert float(row["viscosity_Pa_s"]) == pytest.approx(1014e-6, rel=1e-12)
    assert row["x_N2"] == ""
    assert "-T does not go with astraeusPaper" in refusal("astraeusPaper", "-T", "90")


def test_a_lake_is_the_same_as_its_composition():
    lake, = rows(answer("Kraken", "-format", "csv"))
    mixture, = rows(answer(
        "-composition", " ".join(f"{s} {lake['x_' + s]}" for s in ("N2", "CH4", "C2H6", "C3H8")),
        "-T", lake["T_K"], "-p", lake["p_Pa"], "-format", "csv"))
    for name in ADDED:
        assert float(mixture[name]) == pytest.approx(float(lake[name]), rel=1e-8)
        assert float(lake[f"u_{name_of(name)}_percent"]) > 0


def name_of(column: str) -> str:
    """density_kg_m3 -> density"""
    return {"density_kg_m3": "density", "speed_of_sound_m_s": "soundSpeed", "cp_J_kgK": "cp",
            "viscosity_Pa_s": "viscosity", "conductivity_W_mK": "conductivity",
            "surface_tension_N_m": "surfaceTension"}[column]


def test_ranges_have_temperature_outside_and_both_ends():
    found = rows(answer("-composition", "(C2H6 1)", "-T", "(91 91.3 0.1)", "-p", "( 1e5 3e5 1e5 )", "-format", "csv"))
    assert [float(row["T_K"]) for row in found[::3]] == pytest.approx([91 + 0.1 * i for i in range(4)])
    assert found[-1]["T_K"] == "91.3"
    assert [row["p_Pa"] for row in found[:3]] == ["100000", "200000", "300000"]
    assert float(found[0]["density_kg_m3"]) > float(found[-1]["density_kg_m3"])


def test_a_range_downwards_as_a_table():
    lines = answer("Kraken", "-T", "(96 92 -2)").splitlines()
    assert [line.split()[0] for line in lines if line.strip()[:2] in ("92", "94", "96")][:3] == ["96", "94", "92"]
    assert any("+- %" in line for line in lines)


def test_a_range_goes_on_where_a_state_is_refused():
    done = run("-composition", "C2H6 1", "-T", "(92 132 20)", "-format", "csv")
    found = rows(done.stdout)
    assert done.returncode == 0
    assert [bool(row["density_kg_m3"]) for row in found] == [True, True, False]
    assert found[2]["message"]
    assert "1 of 3 states refused" in done.stderr


@pytest.mark.parametrize("text", ["(90 96)", "(90 96 0)", "(90 96 -1)", "(90 96 1e-9)", "90 96 1 1", "", "()", "(90",
                                  "(90 96 one)", "nan", "(90 nan 1)"])
def test_bad_ranges(text):
    assert "-T" in refusal("-composition", "C2H6 1", "-T", text)


@pytest.mark.parametrize("alkanes, T, nitrogen", [("C2H6 2", "93", 0.037283), ("CH4 1 C2H6 3", "94", 0.04269)])
def test_saturation_dissolves_nitrogen(alkanes, T, nitrogen):
    """TITANPOOL's tables (Steckloff et al. 2020) at 147 kPa."""
    row, = rows(answer("-saturate", alkanes, "-T", T, "-p", "1.47e5", "-bubble", "-format", "csv"))
    assert float(row["x_N2"]) == pytest.approx(nitrogen, abs=0.001)
    assert float(row["bubble_pressure_Pa"]) == pytest.approx(1.47e5, rel=1e-6)
    assert float(row["dissolvable_x_N2"]) == pytest.approx(float(row["x_N2"]), rel=1e-6)


def test_resaturation_changes_the_composition():
    found = rows(answer("Kraken", "-T", "(91 95 2)", "-resaturate", "-format", "csv"))
    nitrogen = [float(row["x_N2"]) for row in found]
    assert nitrogen == sorted(nitrogen, reverse=True)
    assert nitrogen[0] > nitrogen[-1]
    assert "x N2" in answer("Kraken", "-T", "(91 95 2)", "-resaturate")
    assert "x N2" not in answer("Kraken", "-T", "(91 95 2)")
    ratio = [float(row["x_CH4"]) / float(row["x_C2H6"]) for row in found]
    assert ratio == pytest.approx([ratio[0]] * 3)


def test_a_lake_that_is_too_warm_is_warned_of():
    assert "Warnings" in answer("Kraken", "-T", "97")


def test_foam_is_read_by_OpenFOAM(tmp_path):
    (tmp_path / "constant").mkdir()
    (tmp_path / "system").mkdir()
    assert answer("Ligeia", "-format", "foam", "-output", str(tmp_path / "constant/liquidOfLigeia")) == ""
    assert answer("titanAir", "-format", "foam", "-output", str(tmp_path / "constant/air")) == ""
    dictionary = tmp_path / "constant/transportProperties"
    dictionary.write_text('FoamFile { version 2.0; format ascii; class dictionary; object transportProperties; }\n'
                          'phases (liquid gas);\nliquid { #include "liquidOfLigeia" }\ngas { #include "air" }\n'
                          'sigma $liquid.sigma;\n')

    def entry(keyword: str) -> str:
        return subprocess.run(["foamDictionary", "-entry", keyword, "-value", str(dictionary)], check=True, text=True,
                              capture_output=True).stdout.strip()

    lake, = rows(answer("Ligeia", "-format", "csv"))
    density, viscosity = float(lake["density_kg_m3"]), float(lake["viscosity_Pa_s"])
    six_digits = 5e-6  # of foamDictionary
    assert float(entry("liquid.rho")) == pytest.approx(density, rel=six_digits)
    assert float(entry("liquid.nu")) == pytest.approx(viscosity / density, rel=six_digits)
    assert float(entry("sigma")) == pytest.approx(float(lake["surface_tension_N_m"]), rel=six_digits)
    assert entry("gas.transportModel") == "Newtonian"
    assert 1 < float(entry("gas.rho")) < 10
    assert float(entry("liquid.vapourPressure")) == pytest.approx(float(lake["p_Pa"]), rel=six_digits)
    assert "vapourPressure" not in (tmp_path / "constant/air").read_text()


# --- what is refused -----------------------------------------------------------


def test_an_unknown_lake_lists_the_names():
    text = refusal("Krakn", "-T", "94")
    assert "Krakn" in text
    assert all(name in text for name in LAKES)


@pytest.mark.parametrize("arguments, word", [
    ((), "nothing is asked for"),
    (("Kraken", "Ligeia"), "Kraken and Ligeia"),
    (("Kraken", "-states", "-"), "Kraken and -states"),
    (("Kraken", "-colour", "blue"), "-colour"),
    (("Kraken", "-T"), "-T"),
    (("Kraken", "-T", "-p", "1e5"), "-T"),
    (("Kraken", "-format", "xml"), "xml"),
    (("Kraken", "-phase", "gas"), "-phase"),
    (("Kraken", "-T", "(90 96 1)", "-format", "foam"), "one state"),
    (("-states", "-", "-format", "table"), "csv"),
    (("-states", "-", "-T", "94"), "-T does not go with -states"),
    (("-list", "-format", "foam"), "foam"),
    (("-composition", "C2H6 1"), "-T is missing"),
    (("-composition", "C2H6 1", "-T", "94", "-phase", "solid"), "solid"),
    (("-composition", "C2H6 1", "-T", "nan"), "nan"),
    (("-composition", "C2H6 nan", "-T", "94"), "nan"),
    (("-composition", "C2H6", "-T", "94"), "C2H6"),
    (("-composition", "H2O 1", "-T", "94"), "H2O"),
    (("-composition", "C2H6 0.5 C2H6 0.5", "-T", "94"), "twice"),
    (("-composition", "CH4 0.5 C2H6 0.502", "-T", "94"), "1.002"),
    (("-composition", "CH4 -0.5 C2H6 1.5", "-T", "94"), "-0.5"),
    (("-composition", "C2H6 1", "-T", "20"), "20"),
    (("-composition", "C2H6 1", "-T", "94", "-p", "-5"), "-5"),
    (("-composition", "(C2H6 1", "-T", "94"), "parenthesis"),
    (("-composition", "N2 1", "-phase", "gas", "-T", "94", "-bubble"), "gas"),
    (("-saturate", "N2 0.1 C2H6 0.9", "-T", "94"), "nitrogen"),
    (("titanAir", "-resaturate"), "gas"),
])
def test_refusals(arguments, word):
    assert word in refusal(*arguments, stdin=HEADER)


def test_composition_off_by_half_a_thousandth_is_normalised():
    row, = rows(answer("-composition", "CH4 0.5 C2H6 0.5005", "-T", "94", "-format", "csv"))
    assert float(row["x_CH4"]) + float(row["x_C2H6"]) == pytest.approx(1, abs=1e-9)


def test_an_output_that_cannot_be_written(tmp_path):
    assert "nowhere" in refusal("Kraken", "-output", str(tmp_path / "nowhere/out.csv"))
    assert "/dev/full" in refusal("Kraken", "-output", "/dev/full")


def test_needs_no_case_and_leaves_nothing_behind(tmp_path):
    empty = tmp_path / "empty"
    empty.mkdir()
    empty.chmod(0o555)
    done = run("Kraken", cwd=empty)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("Kraken")
    assert done.stderr == ""
    assert not os.listdir(empty)


def test_help_shows_examples():
    text = answer("-help")
    for word in ("Usage: titanProperties", "-composition", "-states", "titanProperties Kraken"):
        assert word in text


# --- figures -------------------------------------------------------------------


def test_plots(tmp_path):
    subprocess.run(["titanPlots", "-quick", "-output", str(tmp_path)], check=True, capture_output=True)
    for name in ("titanOverTemperature", "titanOverComposition", "titanDensityViscosity"):
        assert (tmp_path / f"{name}.png").read_bytes()[:4] == b"\x89PNG"
