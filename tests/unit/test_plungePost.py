# SPDX-License-Identifier: GPL-3.0-or-later
"""plungePost: tables over restarts, key numbers and their uncertainty, the scene's notes, free surface of a composite mesh, pictures."""

import csv
import json
import os
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

from plunge.results import (
    TRAJECTORY_COLUMNS,
    Body,
    CaseError,
    Scene,
    cell_count,
    cpu_seconds,
    crossing,
    describe,
    even_running_mean,
    gather,
    key_numbers,
    patch_types,
    read_body,
    read_notes,
    read_numbers,
    read_scene,
    read_table,
    running_mean,
    write_numbers,
    write_table,
)
from plunge.uncertainty import COLUMNS, CONDITIONS, HEADLINES, Uncertainty, read_uncertainties, two_digits

TOOLS = Path(__file__).resolve().parents[2] / "applications/utilities/plungePost"


# --- tables over restarts ------------------------------------------------------


def write_part(case: Path, start: str, times: list[float], value: float, name: str = "trajectory") -> Path:
    folder = case / "postProcessing" / name / start
    folder.mkdir(parents=True)
    rows = "".join(f"{t},{value}\n" for t in times)
    (folder / f"{name}.csv").write_text("time_s,speed_m_s\n" + rows)
    return folder / f"{name}.csv"


def test_a_later_start_overrides_the_overlap(tmp_path):
    write_part(tmp_path, "0", [0.001, 0.002, 0.0022, 0.003, 0.004], 1)
    write_part(tmp_path, "0.002", [0.0025, 0.003], 2)
    write_part(tmp_path, "0.01", [], 4)  # stopped before its first step
    table = gather(tmp_path)["trajectory"]
    assert table["time_s"].tolist() == [0.001, 0.002, 0.0025, 0.003]
    assert table["speed_m_s"].tolist() == [1, 1, 2, 2]


def test_the_first_line_of_a_restart_does_not_replace_that_of_the_run_before(tmp_path):
    write_part(tmp_path, "0", [0.001, 0.002, 0.003], 1)
    write_part(tmp_path, "0.002", [0.002, 0.003], 2)
    table = gather(tmp_path)["trajectory"]
    assert table["time_s"].tolist() == [0.001, 0.002, 0.003]
    assert table["speed_m_s"].tolist() == [1, 1, 2]


def test_start_times_are_ordered_as_numbers(tmp_path):
    write_part(tmp_path, "10", [11.0], 3)
    write_part(tmp_path, "9", [10.0], 2)
    assert gather(tmp_path)["trajectory"]["time_s"].tolist() == [10, 11]


def test_a_restart_time_rounded_in_the_folder_name_loses_no_row(tmp_path):
    write_part(tmp_path, "0", [0.1, 0.20000000001], 1)
    write_part(tmp_path, "0.2", [0.3], 2)
    assert gather(tmp_path)["trajectory"]["time_s"].size == 3


def test_tables_are_gathered_by_name_and_units_stay_in_the_header(tmp_path):
    write_part(tmp_path, "0", [1.0], 1)
    write_part(tmp_path, "0", [1.0], 7, name="volumeLedger")
    tables = gather(tmp_path)
    assert set(tables) == {"trajectory", "volumeLedger"}
    write_table(tmp_path / "out.csv", tables["volumeLedger"])
    assert (tmp_path / "out.csv").read_text() == "time_s,speed_m_s\n1,7\n"


def test_two_function_objects_with_one_table_name_are_refused(tmp_path):
    write_part(tmp_path, "0", [1.0], 1)
    other = tmp_path / "postProcessing/second/0"
    other.mkdir(parents=True)
    (other / "trajectory.csv").write_text("time_s,speed_m_s\n")
    with pytest.raises(CaseError, match="two function objects write trajectory.csv"):
        gather(tmp_path)


def test_a_missing_column_is_named_with_its_file(tmp_path):
    path = write_part(tmp_path, "0", [1.0], 1)
    with pytest.raises(CaseError) as error:
        read_table(path, ["time_s", "pitch_deg"])
    assert str(path) in str(error.value) and "no column pitch_deg;" in str(error.value)


def test_half_a_line_of_a_killed_run_is_left_out(tmp_path):
    path = write_part(tmp_path, "0", [1.0, 2.0], 1)
    path.write_text(path.read_text() + "3.0,1")
    assert read_table(path)["time_s"].tolist() == [1, 2]


def test_a_damaged_line_is_named(tmp_path):
    path = write_part(tmp_path, "0", [1.0, 2.0], 1)
    path.write_text(path.read_text().replace("2.0,1", "2.0"))
    with pytest.raises(CaseError, match="line 3: 1 values for 2 columns"):
        read_table(path)


# --- numbers -------------------------------------------------------------------


def constant_deceleration() -> dict[str, np.ndarray]:
    """25 m/s straight down, 50 m/s2 from the nose's contact at t = 1 ms on, a start-up spike before."""
    t = np.linspace(0, 0.05, 501)
    wet = np.maximum(t - 1e-3, 0)
    table = {name: np.zeros_like(t) for name in TRAJECTORY_COLUMNS}
    table["time_s"] = t
    table["speed_m_s"] = 25 - 50 * wet
    table["penetration_m"] = 25 * (t - 1e-3) - 25 * wet**2
    table["deceleration_m_s2"] = np.where(t >= 1e-3, 50 + t, 0)
    table["deceleration_m_s2"][2] = -400
    table["pitch_deg"] = -90 + 100 * t
    return table


def test_key_numbers_of_a_known_dive(tmp_path):
    table = constant_deceleration()
    tail = {"time_s": table["time_s"][::50], "high_m": 1 - table["penetration_m"][::50], "low_m": -table["penetration_m"][::50]}
    ledger = {"time_s": np.array([0, 1.0]), "error_percent_of_body_volume": np.array([-0.3, 0.2])}
    numbers = key_numbers(table, ledger, tail)
    value = {name: v for name, (v, _) in numbers.items()}
    wet = (25 - np.sqrt(25**2 - 4 * 25 * 1)) / (2 * 25)  # 25 w - 25 w^2 = 1
    assert value["contact time"] == pytest.approx(1e-3, abs=1e-9)
    assert value["full immersion time"] == pytest.approx(1e-3 + wet, abs=2e-5)
    assert value["velocity lost at full immersion"] == pytest.approx(50 * wet, rel=1e-3)
    assert value["peak deceleration"] == pytest.approx(50.05)
    # Until a quarter of the metre is in, at about 11 ms
    assert value["impact deceleration"] == pytest.approx(50.0112, abs=2e-4)
    assert value["time of peak deceleration"] == pytest.approx(0.05)
    assert value["largest |deceleration| before contact"] == 400
    assert value["pitch change at end"] == pytest.approx(5)
    assert value["max |volume ledger error|"] == 0.3
    assert value["volume ledger error at end"] == 0.2

    write_numbers(tmp_path / "summary.csv", numbers)
    again = read_numbers(tmp_path / "summary.csv")
    assert again["peak deceleration in g"] == (pytest.approx(50.05 / 9.80665, rel=1e-5), "g")


def extent_of(table: dict[str, np.ndarray], height: float) -> dict[str, np.ndarray]:
    return {"time_s": table["time_s"], "high_m": height - table["penetration_m"], "low_m": -table["penetration_m"]}


DIVE_ONLY = {"contact time", "impact deceleration", "time of impact deceleration", "largest |deceleration| before contact"}
IMMERSION = {"full immersion time", "velocity lost at full immersion", "pitch change at full immersion"}
SPEED = {"peak deceleration", "peak deceleration in g", "time of peak deceleration", "velocity lost at end"}


@pytest.mark.parametrize("freedom, lacks", [
    ("free", set()), ("planar", set()), ("axial", {"pitch change at end", "pitch change at full immersion"}),
    ("prescribed", SPEED | IMMERSION - {"full immersion time"} | DIVE_ONLY - {"contact time"} | {"pitch change at end"})])
def test_what_a_body_cannot_do_is_not_reported(freedom, lacks):
    table = constant_deceleration()
    everything = set(key_numbers(table, None, extent_of(table, 1)))
    assert everything > DIVE_ONLY | IMMERSION | SPEED
    assert set(key_numbers(table, None, extent_of(table, 1), Body(freedom))) == everything - lacks


def test_a_body_that_starts_in_the_liquid_has_no_contact():
    table = constant_deceleration()
    table["penetration_m"] += 0.5
    half_in, under = (set(key_numbers(table, None, extent_of(table, height))) for height in (1, 0.4))
    assert not half_in & DIVE_ONLY and half_in > IMMERSION | SPEED
    assert not under & (DIVE_ONLY | IMMERSION) and under > SPEED


def test_the_peak_force_is_that_of_pressure_and_friction_from_contact_on():
    table = constant_deceleration()
    table["Fpx_N"] = np.where(table["time_s"] > 0.01, 30.0, 0)
    table["Fvz_N"] = np.where(table["time_s"] > 0.02, 40.0, 0)
    table["Fpz_N"][1] = 1e4  # before contact, which is at 1 ms
    table["Fgz_N"][:] = -1e5
    numbers = key_numbers(table, None, extent_of(table, 1), Body("axial", inPlane=True, width=0.2, area=0.2, pressure=500))
    assert numbers["peak force"] == (50, "N/m") and numbers["peak force coefficient"] == (pytest.approx(0.5), "-")
    assert numbers["time of peak force"][0] == pytest.approx(0.0201)
    assert "peak force coefficient" not in key_numbers(table, None, extent_of(table, 1))


def test_an_event_that_does_not_happen_is_nan():
    assert np.isnan(crossing(np.array([0.0, 1.0]), np.array([-2.0, -1.0])))
    assert crossing(np.array([0.0, 1.0]), np.array([-1.0, 3.0])) == 0.25
    assert crossing(np.array([0.0, 1.0]), np.array([3.0, -1.0]), falling=True) == 0.75


def test_a_running_mean_is_the_change_of_speed_over_its_window():
    """Uneven steps, each row the acceleration of the step that ends there."""
    time = np.concatenate(([0.0], np.cumsum(np.tile([1e-3, 3e-3], 50))))
    speed = 25 - 40 * time - 300 * time**2
    value = np.concatenate(([0.0], -np.diff(speed) / np.diff(time)))
    mean = running_mean(time, value, 8e-3)
    inside = (time > 4e-3) & (time < time[-1] - 4e-3)
    expected = (np.interp(time - 4e-3, time, speed) - np.interp(time + 4e-3, time, speed)) / 8e-3
    assert mean[inside] == pytest.approx(expected[inside])
    ringing = running_mean(time, value + 1e3 * np.sin(2 * np.pi * time / 8e-3 + 1), 8e-3)
    assert np.abs(ringing - mean)[inside].max() < 1e3 * 0.3
    assert np.isfinite(mean).all()


def test_a_running_mean_of_even_rows():
    value = np.arange(20.0) ** 2
    assert even_running_mean(value, 4.9)[2:-2] == pytest.approx(value[2:-2] + 2)
    assert even_running_mean(value, 0.2) == pytest.approx(value)


def test_force_along_the_path_is_positive_when_it_slows():
    from plunge.figures import along_path

    table = {"vx_m_s": [3.0], "vy_m_s": [0.0], "vz_m_s": [-4.0], "Fpx_N": [0.0], "Fpy_N": [9.0], "Fpz_N": [10.0]}
    assert along_path({k: np.array(v) for k, v in table.items()}, "p") == pytest.approx([8.0])


# --- what is modelled, and what is not -------------------------------------------

SCENE = """
Scene
    models      : body sixDoF, mesh motion overset, {models}
    reference   : length 1 m, speed 25 m/s (from constant/sceneProperties)
    Re          : 1.637e+07 in liquid, 5.9e+07 in gas
    Note: {note}.
    Note: Ma = 0.02, in "gas", but compressibility is off.

PIMPLE: no residual control data found. Calculations will employ 2 corrector loops
    Note: no part of the scene.
"""


def write_log(case: Path, text: str, solver: str = "plungeFoam") -> None:
    (case / "system").mkdir(parents=True, exist_ok=True)
    (case / "system/controlDict").write_text(
        f"FoamFile {{ version 2.0; format ascii; class dictionary; object controlDict; }}\napplication {solver};\n")
    (case / f"log.{solver}").write_text(text)


def test_the_scene_is_that_of_the_latest_start(tmp_path):
    write_log(tmp_path, "Create time\n" + SCENE.format(models="surface tension on", note="an old remark")
              + SCENE.format(models="surface tension off", note="the cavity is not modelled"))
    scene = read_scene(tmp_path)
    assert scene.models == "body sixDoF, mesh motion overset, surface tension off"
    assert scene.notes == ("the cavity is not modelled.", 'Ma = 0.02, in "gas", but compressibility is off.')


def test_a_log_without_scene_and_no_log_have_no_notes(tmp_path):
    write_log(tmp_path, "Start: 1 of the fluid, 1 of walls\n", "plungeSPH")
    assert read_scene(tmp_path) == Scene()
    (tmp_path / "log.plungeSPH").unlink()
    assert read_scene(tmp_path) == Scene()


def test_the_cpu_time_is_that_of_all_starts(tmp_path):
    """Also where a start takes longer to its first step than the one before it took in all."""
    steps = "Build  : OPENFOAM=1912\n" + "ExecutionTime = {} s  ClockTime = 9 s\n" * 2
    for solver in ("plungeFoam", "plungeSPH"):
        write_log(tmp_path, steps.format(1, 2) + steps.format(3, 4.5) + "Build  : OPENFOAM=1912\n" + steps.format(0.5, 1), solver)
        assert cpu_seconds(tmp_path) == 2 + 4.5 + 1


def test_the_summary_holds_notes_beside_numbers(tmp_path):
    path, notes = tmp_path / "summary.csv", ['Ma = 0.02, in "gas".', "none; of it."]
    write_numbers(path, {"contact time": (0.5, "s")}, "body sixDoF, gravity on", notes)
    assert path.read_text().splitlines()[2:4] == ['models,"body sixDoF, gravity on",', 'note,"Ma = 0.02, in ""gas"".",']
    assert read_numbers(path) == {"contact time": (0.5, "s")}
    assert read_notes(path) == notes


# --- uncertainty -----------------------------------------------------------------

DIVE = {"shape": "NACA", "fluids": "titan", "tier": "fast", "model": "half", "mesh": "overset", "resolution": "1", "boundaryLayer": "frictionLine",
        "transitionReynolds": "500000", "bodyLength": "1", "thicknessRatio": "0.1", "bodyMass": "2.85714285714", "speed": "25",
        "pathAngle": "75", "application": "plungeFoam", "bodyMomentOfInertia": "(0.0027 0.11 0.11)", "centreOfMassFromNose": "0.38",
        "gap": "0.01", "diveDuration": "0.045", "liquidDensity": "664", "liquidViscosity": "0.001014", "gasDensity": "5.353", "gravity": "1.35"}
MEASURED = {"peak deceleration": ("50.05", "m/s2", "0.3", "0.4", "1.2", "1.3"),
            "velocity lost at full immersion": ("1.78", "m/s", "0.03", "0.01", "0.04", "0.051"),
            "full immersion time": ("0.036", "s", "3e-6", "4e-6", "0", "5e-6")}  # not the pitch: as where the study failed to measure it


def write_dive_parameters(case: Path, **changes: str) -> None:
    (case / "system").mkdir(parents=True, exist_ok=True)
    text = "".join(f"{name:<23} {value};\n" for name, value in {**DIVE, **changes}.items())
    (case / "system/plungeGenerated").write_text("FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       dictionary;\n"
                                                 "    object      plungeGenerated;\n}\n// The dive\n" + text)


def write_uncertainties(case: Path, *fluids: str) -> Path:
    path = case / "constant/uncertainty.csv"
    path.parent.mkdir(exist_ok=True)
    with path.open("w", newline="") as file:
        out = csv.writer(file)
        out.writerow(COLUMNS)
        for name in fluids:
            out.writerows([*({**DIVE, "fluids": name}[condition] for condition in CONDITIONS), quantity, *numbers, "abc123", "2026-11-30"]
                          for quantity, numbers in MEASURED.items())
    return path


def test_the_uncertainty_of_the_same_dive_is_found(tmp_path):
    write_dive_parameters(tmp_path, resolution="1.0")
    write_uncertainties(tmp_path, "water", "titan")
    found, sentence = read_uncertainties(tmp_path)
    assert set(found) == set(MEASURED)
    assert found["peak deceleration"].total == 1.3
    assert found["peak deceleration"].parts == {"mesh": 0.3, "time step": 0.4, "boundary layer": 1.2}
    assert "the study diveUncertainty" in sentence and "version abc123 of 2026-11-30" in sentence


def test_no_uncertainty_is_taken_from_another_dive(tmp_path):
    write_uncertainties(tmp_path, "water", "titan")
    only = ("Uncertainty: measured for the default dive, fluids water or titan, tier fast, model half, mesh overset, resolution 1, "
            "boundaryLayer frictionLine only, not for ")
    for change, ends in (({"tier": "fine"}, "tier fine."), ({"speed": "10", "bodyMass": "3"}, "bodyMass 3, speed 10."),
                         ({"fluids": "kraken"}, "fluids kraken; validation/run diveUncertainty -tier kraken measures it."),
                         ({"freedom": "axial"}, "freedom axial."),
                         ({"application": "plungeSPH", "mesh": "none"}, "application plungeSPH."),
                         ({"shape": "spheroid"}, "shape spheroid."),
                         ({"forward": "(0 0 -1)", "heading": "(0.6 0 -0.8)"}, "heading (0.6 0 -0.8)."),
                         ({"angularMomentum": "(0 1 0)"}, "angularMomentum (0 1 0).")):
        write_dive_parameters(tmp_path, **change)
        assert read_uncertainties(tmp_path) == ({}, only + ends)


def test_without_a_table_it_is_not_measured(tmp_path):
    """A scene that is not the default dive is not sent to the study of the default dive."""
    write_dive_parameters(tmp_path)
    sentence = read_uncertainties(tmp_path)[1]
    assert sentence.startswith("Uncertainty: not measured.") and "-resolution 2" in sentence and "diveUncertainty" not in sentence


def test_a_damaged_table_is_named(tmp_path):
    write_dive_parameters(tmp_path)
    path = write_uncertainties(tmp_path, "titan")
    path.write_text(path.read_text().replace("1.2,1.3", "1.2,much"))
    with pytest.raises(CaseError, match="uncertainty.csv, peak deceleration: expected a number"):
        read_uncertainties(tmp_path)
    path.write_text("fluids,tier\n")
    with pytest.raises(CaseError, match="uncertainty.csv: no column model, mesh"):
        read_uncertainties(tmp_path)


def test_a_number_has_as_many_decimals_as_its_uncertainty():
    parts = {"mesh": 0.1, "time step": 0.05, "boundary layer": 0.2}
    assert Uncertainty(0.2291, parts).text(25.0143, "m/s") == "25.01 m/s +- 0.23 (mesh 0.10, time step 0.050, boundary layer 0.20)"
    assert Uncertainty(5e-6, {"mesh": 0.0}).text(0.036, "ms", 1e3) == "36.0000 ms +- 0.0050 (mesh 0)"
    assert [two_digits(u) for u in (0.0996, 1.25, 12.4, 1234.0, 0.0)] == [("0.10", 2), ("1.2", 1), ("12", 0), ("1200", 0), ("0", 3)]


# --- any body and model ----------------------------------------------------------


def write_body_parameters(case: Path, **changes: str) -> None:
    """As plungeCase does for a wedge in the plane."""
    write_dive_parameters(case, **{"application": "plungeSPH", "fluids": "water", "model": "plane", "shape": "wedge", "freedom": "free",
                                   "bodyLength": "0.25", "thicknessRatio": "0.8", "speed": "4", "referenceSpeed": "4", "pathAngle": "90",
                                   "liquidDensity": "1000", **changes})


@pytest.mark.parametrize("changes, says", [
    ({}, "wedge of 0.25 m at 4 m/s and 90 deg, fluids water, plane model, tier fast"),
    ({"speed": "3.13209195267", "freedom": "prescribed"}, "wedge of 0.25 m at 3.132 m/s and 90 deg, prescribed, fluids water"),
    ({"speed": "0", "freedom": "axial"}, "wedge of 0.25 m from rest, fluids water"),
    ({"speed": "0", "freedom": "fixed", "shape": "circle"}, "circle of 0.25 m fixed, fluids water")])
def test_the_title_says_which_body_and_how_it_moves(tmp_path, changes, says):
    write_log(tmp_path, "Start: 10 of the fluid, 5 of walls\n", "plungeSPH")
    write_body_parameters(tmp_path, **changes)
    assert f"{tmp_path.name}, {says}" in describe(tmp_path)


def test_a_body_from_rest_has_peaks_after_the_start_and_no_coefficient(tmp_path):
    """The first line has the loads on a body that is held."""
    table = constant_deceleration()
    table["penetration_m"] += 2
    table["Fpz_N"][:] = 4.0
    table["Fpz_N"][0] = 5.0
    numbers = key_numbers(table, None, extent_of(table, 1))
    assert numbers["peak force"] == (4.0, "N") and numbers["time of peak force"][0] > 0
    write_body_parameters(tmp_path, speed="0", referenceSpeed="1.4")
    assert read_body(tmp_path).pressure == 0


def test_the_body_is_that_of_the_scene(tmp_path):
    assert read_body(tmp_path) == Body("free")
    write_body_parameters(tmp_path)
    assert read_body(tmp_path) == Body("free", True, "y", pytest.approx(0.2), pytest.approx(0.2), 8000)
    write_body_parameters(tmp_path, model="half", application="plungeFoam", freedom="axial", shape="sphere")
    assert read_body(tmp_path) == Body("axial", False, "z", pytest.approx(0.2), pytest.approx(np.pi / 100), 8000)
    write_body_parameters(tmp_path, model="full", shape="surface")
    assert read_body(tmp_path).area == 0  # not known


# --- the case's mesh -------------------------------------------------------------


def test_patches_and_cells_are_read_from_the_mesh(tmp_path):
    mesh = tmp_path / "constant/polyMesh"
    mesh.mkdir(parents=True)
    (mesh / "boundary").write_text(
        "FoamFile\n{\n version 2.0;\n class polyBoundaryMesh;\n}\n2\n(\n"
        " body\n {\n  type wall;\n  nFaces 3;\n }\n sides\n {\n  inGroups 1(overset);\n  type overset;\n }\n)\n"
    )
    (mesh / "owner").write_bytes(b'FoamFile\n{\n note "nPoints:8  nCells:27  nFaces:6";\n}\n\x00\xff')
    assert patch_types(tmp_path) == {"body": "wall", "sides": "overset"}
    assert cell_count(tmp_path) == 27


# --- free surface of a composite mesh ----------------------------------------------

TILT = np.radians(30)


def block(low, high, cells, angle=0.0):
    """Hexahedra that fill a box, turned about the y axis."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkFiltersCore import vtkAppendFilter

    image = vtkImageData()
    image.SetDimensions(*(n + 1 for n in cells))
    image.SetOrigin(low)
    image.SetSpacing([(h - l) / n for l, h, n in zip(low, high, cells)])
    grid = vtkAppendFilter()
    grid.AddInputData(image)
    grid.Update()
    mesh = grid.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    c, s = np.cos(angle), np.sin(angle)
    points[:] = points @ np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])
    return mesh


def sides_of(mesh):
    """Outer boundary of a block without its faces on y = 0, if it has any."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkPlane
    from vtkmodules.vtkFiltersExtraction import vtkExtractPolyDataGeometry
    from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

    faces = vtkGeometryFilter()
    faces.SetInputData(mesh)
    faces.Update()
    surface = faces.GetOutput()
    if abs(vtk_to_numpy(surface.GetPoints().GetData())[:, 1].min()) > 1e-9:
        return surface
    plane = vtkPlane()
    plane.SetOrigin(0, 1e-6, 0)
    plane.SetNormal(0, -1, 0)
    cut = vtkExtractPolyDataGeometry()
    cut.SetInputData(surface)
    cut.SetImplicitFunction(plane)
    cut.ExtractInsideOn()
    cut.ExtractBoundaryCellsOn()
    cut.Update()
    return cut.GetOutput()


def composite(half: bool):
    """Background and turned body mesh in still liquid that fills z < 0.1 x; garbage in the holes."""
    from vtkmodules.numpy_interface import dataset_adapter as dsa
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkCellCenters

    y = 0.0 if half else -1.0
    n = 10 if half else 20
    background = block((-1, y, -1), (1, 1, 1), (20, n, 20))
    body = block((-0.45, 0.4 * y, -0.6), (0.45, 0.4, 0.6), (15, n // 2, 19), TILT)
    together = vtkAppendFilter()
    together.AddInputData(background)
    together.AddInputData(body)
    together.Update()
    mesh = together.GetOutput()
    centres = vtkCellCenters()
    centres.SetInputData(mesh)
    centres.Update()
    c = vtk_to_numpy(centres.GetOutput().GetPoints().GetData())
    zone = np.repeat([0.0, 1.0], [background.GetNumberOfCells(), body.GetNumberOfCells()])
    hole = (zone == 0) & (np.linalg.norm(c, axis=1) < 0.3)
    alpha = np.clip(0.5 - 2 * (c[:, 2] - 0.1 * c[:, 0]), 0, 1)
    alpha[hole] = np.random.default_rng(1).random(hole.sum())
    cells = dsa.WrapDataObject(mesh).CellData
    cells.append(alpha, "alpha.liquid")
    cells.append(np.where(hole, 2.0, 0.0), "cellTypes")
    cells.append(zone, "zoneID")
    cells.append(np.where(hole, np.nan, c[:, 0]), "p")
    cells.append(np.column_stack((c[:, 0], c[:, 1], c[:, 2])), "U")
    return mesh, sides_of(body)


def area(surface) -> float:
    from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter

    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    mass = vtkMassProperties()
    mass.SetInputConnection(triangles.GetOutputPort())
    return mass.GetSurfaceArea()


@pytest.mark.parametrize("half", [False, True])
def test_the_free_surface_is_there_exactly_once(half):
    from plunge.surfaces import free_surface
    from vtkmodules.util.numpy_support import vtk_to_numpy

    mesh, sides = composite(half)
    surface = free_surface(mesh, "alpha.liquid", [sides], half, ["p", "U"])
    points = vtk_to_numpy(surface.GetPoints().GetData())
    # 2 m by 2 m, tilted: counted once. The body mesh's share of it is 0.8 m by more than 0.9 m.
    assert area(surface) == pytest.approx(4 * np.sqrt(1.01), rel=0.005)
    assert np.abs(points[:, 2] - 0.1 * points[:, 0]).max() < 0.01  # no garbage from the holes
    pressure = vtk_to_numpy(surface.GetPointData().GetArray("p"))
    assert np.abs(pressure - points[:, 0]).max() < 0.06  # one-sided at the domain's edge
    velocity = vtk_to_numpy(surface.GetPointData().GetArray("U"))
    if half:  # mirrored, vectors too; the symmetry plane itself is one-sided
        assert points[:, 1].min() == pytest.approx(-1)
        assert velocity[points[:, 1] < -0.1, 1].max() < 0
    assert surface.GetPointData().GetNumberOfArrays() == 2


def test_a_single_mesh_needs_no_overset_fields():
    from plunge.surfaces import free_surface

    mesh, _ = composite(False)
    for name in ("cellTypes", "zoneID"):
        mesh.GetCellData().RemoveArray(name)
    free_surface(mesh, "alpha.liquid", [], False, ["p"])
    with pytest.raises(CaseError, match="field zoneID is not among"):
        free_surface(mesh, "alpha.liquid", [mesh], False, ["p"])


def test_hanging_nodes_do_not_move_the_surface():
    """One large cell of gas on eight small ones of liquid: the surface is the plane between them."""
    from plunge.surfaces import free_surface
    from vtkmodules.numpy_interface import dataset_adapter as dsa
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkIdList
    from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON

    mesh = block((0, 0, -2), (2, 2, 0), (2, 2, 2))
    places = [tuple(p) for p in vtk_to_numpy(mesh.GetPoints().GetData())]
    top = [mesh.GetPoints().InsertNextPoint(*p) for p in ((0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2))]
    n = {p: places.index((*p, 0)) for p in ((x, y) for x in range(3) for y in range(3))}
    around = [n[p] for p in ((0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1))]
    faces = [top] + [[n[x, y], n[x + 1, y], n[x + 1, y + 1], n[x, y + 1]] for x in (0, 1) for y in (0, 1)]
    faces[1].reverse()  # faces come wound either way
    for side in range(4):
        low = [around[(2 * side + i) % 8] for i in range(3)]
        faces.append([*low, top[(side + 1) % 4], top[side]])
    stream = vtkIdList()
    for value in [len(faces)] + [v for face in faces for v in (len(face), *face)]:
        stream.InsertNextId(value)
    mesh.InsertNextCell(VTK_POLYHEDRON, stream)
    cells = dsa.WrapDataObject(mesh).CellData
    cells.append(np.array([1.0] * 8 + [0.0]), "alpha.liquid")

    surface = free_surface(mesh, "alpha.liquid", [], False, [])
    assert np.abs(vtk_to_numpy(surface.GetPoints().GetData())[:, 2]).max() < 1e-6
    assert area(surface) == pytest.approx(4)
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (vtk_to_numpy(surface.GetPoints().GetData())[corners[:, i]] for i in range(3))
    assert np.cross(b - a, c - a)[:, 2].min() >= 0  # all of it faces the gas


# --- VTK series and pictures -------------------------------------------------------


def write_dive(folder: Path, pressure: float | None = None) -> None:
    """Flat liquid and a sphere that sinks into it, with that pressure on it."""
    from plunge.surfaces import Series, free_surface
    from vtkmodules.numpy_interface import dataset_adapter as dsa
    from vtkmodules.vtkFiltersSources import vtkSphereSource

    mesh, sides = composite(False)
    liquid, body = Series(folder, "freeSurface"), Series(folder, "body")
    for time, z in ((0.0, 0.5), (0.01, 0.2), (0.02, -0.3)):
        sphere = vtkSphereSource()
        sphere.SetCenter(0, 0, z)
        sphere.SetRadius(0.2)
        sphere.Update()
        hull = sphere.GetOutput()
        if pressure is not None:
            dsa.WrapDataObject(hull).CellData.append(np.full(hull.GetNumberOfCells(), pressure), "p")
        liquid.add(time, free_surface(mesh, "alpha.liquid", [sides], False, ["p", "U"]))
        body.add(time, hull)


def test_the_series_is_what_paraview_expects(tmp_path):
    from plunge.surfaces import read_series, read_surface

    write_dive(tmp_path)
    series = json.loads((tmp_path / "body.vtp.series").read_text())
    assert series["file-series-version"] == "1.0"
    assert [f["time"] for f in series["files"]] == [0.0, 0.01, 0.02]
    heights = [read_surface(path).GetBounds()[4] for _, path in read_series(tmp_path, "body")]
    assert heights == pytest.approx([0.3, 0.0, -0.5], abs=1e-6)


def without_display(*command: object) -> None:
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    subprocess.run(list(map(str, command)), check=True, env=environment)


def test_pictures_are_drawn_without_a_display(tmp_path):
    import matplotlib.image

    write_dive(tmp_path / "results/VTK")
    without_display(TOOLS / "plungePictures", tmp_path, "-panels", 2, "-width", 160)
    sheet = matplotlib.image.imread(tmp_path / "results/dive.png")
    assert sheet.shape[:2] == (200, 2 * 160 + 8)
    first, second = sheet[:, :160, :3], sheet[:, 168:, :3]
    body = [picture[..., 0] > picture[..., 2] + 0.25 for picture in (first, second)]  # orange in blue
    height = [np.mean(np.nonzero(seen)[0]) for seen in body if seen.sum() > 50]
    assert len(height) == 2 and height[1] > height[0] + 20  # rows count downwards: it sinks
    assert sorted(p.name for p in (tmp_path / "results/dive").iterdir()) == ["dive_0.png", "dive_1.png"]


@pytest.mark.parametrize("pressure", [-600.0, 600.0])
def test_the_movie_shows_the_pressure_on_the_body(tmp_path, pressure):
    write_dive(tmp_path / "results/VTK", pressure)
    without_display(TOOLS / "plungePictures", tmp_path, "-movie", "-width", 160)
    made = sorted(path for path in (tmp_path / "results").iterdir() if path.is_file())
    assert [path.suffix for path in made] in ([".gif"], [".mp4"])
    if made[0].suffix == ".gif":
        frames = gif_frames(made[0])
        assert len(frames) == 3
        air = frames[0][: 200 // 2].astype(float)  # there it still is
        redness = air[..., 0] - air[..., 2]
        assert (np.sign(pressure) * redness > 60).sum() > 100 and not (np.sign(pressure) * redness < -60).any()


def test_the_tank_is_about_the_path_of_the_body():
    """Of a slender dive as of a short cone that only just wets its nose."""
    import importlib.machinery
    import importlib.util

    loader = importlib.machinery.SourceFileLoader("plungePictures", str(TOOLS / "plungePictures"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("plungePictures", loader))
    loader.exec_module(module)
    for size in (1.0, 0.01):
        dive = size * np.array([[-0.27, 0.0, -0.05, 0.05, 0.01, 0.98], [0.0, 0.27, -0.05, 0.05, -1.0, -0.03]])
        (low, high, side, bottom), top = module.box_around(dive)
        assert low < dive[:, 0].min() and high > dive[:, 1].max() and side > 3 * 0.05 * size
        assert -1.2 * size < bottom < -1.05 * size and top == 0.98 * size
    cone = np.array([[-0.026, 0.026, -0.026, 0.026, 0.001, 0.292], [-0.026, 0.026, -0.026, 0.026, -0.014, 0.277]])
    (low, high, _, bottom), top = module.box_around(cone)
    assert top == 0.292 and -0.2 < bottom < -0.05 and 0.15 < high - low < 0.6
    high_drop = cone + [0, 0, 0, 0, 2.0, 2.0]
    assert module.box_around(np.array([high_drop[0], cone[1]]))[1] < 0.5  # not all of the fall


def gif_frames(path: Path) -> list[np.ndarray]:
    from PIL import Image, ImageSequence

    with Image.open(path) as image:
        return [np.array(frame.convert("RGB")) for frame in ImageSequence.Iterator(image)]


def test_a_movie_without_ffmpeg_is_a_gif(tmp_path, monkeypatch, capsys):
    from PIL import Image
    from plunge import movie

    monkeypatch.setattr(movie.shutil, "which", lambda name: None)
    (tmp_path / "dive.mp4").write_bytes(b"of an earlier call")
    grey = [np.full((31, 41, 3), 8 * i, np.uint8) for i in range(30)]
    path = movie.write(iter(grey), len(grey), tmp_path / "dive")
    assert path == tmp_path / "dive.gif" and not (tmp_path / "dive.mp4").exists()
    assert [int(frame[0, 0, 0]) for frame in gif_frames(path)] == [8 * i for i in range(30)]
    with Image.open(path) as image:
        assert image.info["duration"] == 200  # 30 frames in 6 s
    said = capsys.readouterr().err.splitlines()
    assert said[0].startswith("movie: 1 of 30 frames, left ") and said[-1] == "movie: 30 of 30 frames, left 0:00"


def fake_ffmpeg(folder: Path, ends: str) -> str:
    script = folder / "ffmpeg"
    script.write_text(f'#!/bin/bash\necho "$@" > {folder}/arguments\ncat > {folder}/frames\n{ends}\n')
    script.chmod(0o755)
    return str(script)


def test_a_movie_by_ffmpeg_is_an_mp4_with_even_sides(tmp_path, monkeypatch):
    from plunge import movie

    ffmpeg = fake_ffmpeg(tmp_path, 'touch "${@: -1}"')
    monkeypatch.setattr(movie.shutil, "which", lambda name: ffmpeg)
    (tmp_path / "dive.gif").write_bytes(b"of an earlier call")
    pictures = [np.arange(31 * 41 * 3).reshape(31, 41, 3).astype(np.uint8) + np.uint8(i) for i in range(3)]
    assert movie.write(iter(pictures), 3, tmp_path / "dive") == tmp_path / "dive.mp4"
    assert not (tmp_path / "dive.gif").exists()
    assert "-s 40x30 -r 2 " in (tmp_path / "arguments").read_text()
    frames = np.frombuffer((tmp_path / "frames").read_bytes(), np.uint8).reshape(3, 30, 40, 3)
    assert (frames == np.array(pictures)[:, :30, :40]).all()

    fake_ffmpeg(tmp_path, "exit 3")
    with pytest.raises(CaseError, match="dive.mp4: ffmpeg failed"):
        movie.write(iter(pictures), 3, tmp_path / "dive")


# --- the flow in a plane -------------------------------------------------------------

R, Z = 8, 20  # cells


def sector(case: Path, wedge: bool) -> Path:
    """A mesh from 0.2 to 1 m in x or r and from -1 to 1 m in z, liquid below 0.05 m; the body is its inner side. p = r - 100 z."""
    header = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
    y = np.tan(np.radians(2.5)) if wedge else 0.3
    vertices = [(x, s * (x * y if wedge else y), z) for z in (-1, 1) for x, s in ((0.2, -1), (1, -1), (1, 1), (0.2, 1))]
    kind = "wedge" if wedge else "empty"
    (case / "system").mkdir(parents=True)
    (case / "constant").mkdir()
    (case / "system/controlDict").write_text(header.format("dictionary", "controlDict") + "application plungeFoam; deltaT 1; endTime 1;"
                                             " writeInterval 1;")
    (case / "system/blockMeshDict").write_text(header.format("dictionary", "blockMeshDict") + "vertices (" + " ".join(
        f"({a} {b} {c})" for a, b, c in vertices) + f"""); blocks (hex (0 1 2 3 4 5 6 7) ({R} 1 {Z}) simpleGrading (1 1 1)); edges ();
        boundary (body {{ type wall; faces ((0 4 7 3)); }} far {{ type patch; faces ((1 2 6 5) (0 3 2 1) (4 5 6 7)); }}
        front {{ type {kind}; faces ((0 1 5 4)); }} back {{ type {kind}; faces ((3 7 6 2)); }});""")
    subprocess.run(["blockMesh", "-case", case], check=True, capture_output=True)
    z, r = np.meshgrid((np.arange(Z) + 0.5) / (Z / 2) - 1, 0.2 + 0.8 * (np.arange(R) + 0.5) / R, indexing="ij")
    fields = {"alpha.liquid": np.clip(0.5 - 5 * (z - 0.05), 0, 1), "p": r - 100 * z}
    for time in ("0", "0.5"):
        (case / time).mkdir()
        for name, values in fields.items():
            if time == "0" and name == "p":
                continue
            patches = " ".join(f"{patch} {{ type {kind if patch in ('front', 'back') else 'zeroGradient'}; }}"
                               for patch in ("body", "far", "front", "back"))
            (case / time / name).write_text(
                header.format("volScalarField", name) + "dimensions [0 0 0 0 0 0 0]; internalField nonuniform List<scalar> "
                f"{values.size} ({' '.join(f'{v:.9g}' for v in values.ravel())}); boundaryField {{ {patches} }}")
        (case / time / "U").write_text(
            header.format("volVectorField", "U") + "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 -3); boundaryField { "
            f"\".*\" {{ type {kind}; }} }}")
    return case


@pytest.mark.parametrize("wedge", [False, True])
def test_the_flow_of_a_plane_or_axisymmetric_model_is_seen_in_its_plane(tmp_path, wedge):
    from plunge.surfaces import Case

    case = Case(sector(tmp_path, wedge), "alpha.liquid", "body")
    assert case.in_plane and case.mirrored == wedge and case.times == [0, 0.5]
    flow = case.section(1)
    x, z = flow.points.T
    assert len(x) == (R + 1) * (Z + 1) and x.min() == pytest.approx(0.2, rel=2e-3) and np.abs(z).max() == pytest.approx(1)
    inside = (np.abs(z) < 0.99) & (x > 0.21) & (x < 0.99)  # an average over cells is one-sided on a boundary
    assert np.abs(flow.pressure - (x - 100 * z))[inside].max() < 0.02 and flow.speed == pytest.approx(3)
    a, b, c = (flow.points[flow.triangles[:, i]] for i in range(3))
    area = np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]).sum() / 2
    assert area == pytest.approx(1.6, rel=2e-3)
    line, = flow.body
    assert np.abs(line[:, 0]) == pytest.approx(0.2, rel=2e-3) and np.ptp(line[:, 1]) == pytest.approx(2)
    assert ((line[:, 0] < 0).sum() == len(line) / 2) if wedge else (line[:, 0] > 0).all()
    assert len(flow.onBody[0]) == len(line)
    assert case.section(0).pressure is None and case.section(0).onBody is None


def test_the_picture_of_an_axisymmetric_model_shows_pressure_on_the_left_and_speed_on_the_right(tmp_path):
    import matplotlib.image
    from plunge import sections
    from plunge.surfaces import Case

    case = Case(sector(tmp_path / "case", True), "alpha.liquid", "body")
    look = sections.Look.of(case)
    assert look.labels == ("pressure [kPa]", "speed [m/s]") and look.speed.norm.vmax == 3
    assert -look.pressure.norm.vmin == look.pressure.norm.vmax == 0.1
    sections.save_pictures("a title", case, look, tmp_path)
    assert [path.name for path in sorted((tmp_path / "dive").iterdir())] == ["dive_0.png", "dive_1.png"]
    picture = matplotlib.image.imread(tmp_path / "dive/dive_1.png")[..., :3]

    def columns(colour: tuple[float, ...]) -> np.ndarray:
        """Those of the pixels of a colour; right of them are the bars."""
        found = np.argwhere(np.abs(picture - colour[:3]).max(axis=2) < 0.06)[:, 1]
        return found[found < 0.6 * picture.shape[1]]

    fast, high = columns(look.speed.cmap(1.0)), columns(look.pressure.cmap(0.9))
    assert len(fast) > 5000 and len(high) > 1000 and high.max() < fast.min()

    write_body_parameters(tmp_path / "case", model="axisymmetric", application="plungeFoam")
    assert sections.scales(tmp_path / "case")[:2] == (8000, 4)


@pytest.mark.parametrize("level", [-2.0, 0.0, 2.0])
def test_a_frame_without_a_surface_is_drawn_without_complaint(level, recwarn):
    """All gas, both, all liquid."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize
    from plunge import sections
    from plunge.figures import plt

    points = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    zero = np.zeros(4)
    section = sections.Section(0.0, points, zero, zero, [], [], points[:, 1] + 0.5 + level, np.array([(0, 1, 2), (0, 2, 3)]))
    look = sections.Look((-1, 1, -1, 1), *(ScalarMappable(Normalize(-1, 1)) for _ in range(2)), 1.0, 1.0, ("", ""))

    class Film:
        mirrored = False

    figure, axes = plt.subplots()
    sections.draw(axes, Film(), section, look)
    assert not recwarn
    filled = sum(len(c.get_paths()) > 0 for c in axes.collections[1:])
    assert filled == {-2.0: 1, 0.0: 2, 2.0: 0}[level]  # the gas; the gas and the line; neither
    plt.close(figure)


def test_the_frame_is_about_the_body_and_the_surface():
    from plunge.sections import frame

    def box(x: float, z: float, width: float, height: float) -> np.ndarray:
        return np.array([(x, z), (x + width, z), (x + width, z + height), (x, z + height)])

    def slender(z: float) -> np.ndarray:
        return np.column_stack((np.repeat((-0.02, 0.02), 50), np.tile(np.linspace(z, z + 1, 50), 2)))

    left, right, bottom, top = frame([box(-0.05, 0.01, 0.1, 0.1), box(-0.05, -0.1, 0.1, 0.1)])  # a sphere, say
    assert -0.2 < bottom < -0.11 and 0.03 < top < 0.2 and left == pytest.approx(-right) and 0.1 < right < 0.3
    left, right, bottom, top = frame([slender(0.01), slender(-0.2)])
    assert top < 0.5 and bottom < -0.25 and right - left > 0.4 * (top - bottom)  # most of it is not seen
    left, right, bottom, top = frame([box(0, -5, 0.1, 0.1), box(0, -5.2, 0.1, 0.1)])  # far below the surface
    assert top < -4.5 and bottom > -5.5
    left, right, bottom, top = frame([box(0, -0.3, 0.1, 0.1), box(0, -0.15, 0.1, 0.1)])  # rises
    assert bottom < -0.33 and top > -0.03


# --- a dive of plungeSPH -------------------------------------------------------------

SPACING = 0.05


def particle_dive(case: Path, flat: bool = False) -> Path:
    """A case as plungeSPH leaves it: a sphere that falls into particles below z = 0, which gain speed with time. Flat: y is up, and
    the sphere is as good as a cylinder."""
    from plunge.surfaces import Series
    from vtkmodules.numpy_interface import dataset_adapter as dsa
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource, vtkSphereSource

    header = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"
    for path, text in {
            "system/controlDict": "application plungeSPH;\n",
            "constant/particleProperties": f"dimensions {2 if flat else 3}; geometry {{ spacing {SPACING}; }}\n",
    }.items():
        (case / path).parent.mkdir(parents=True)
        (case / path).write_text(header.format(Path(path).name) + text)
    (case / "log.plungeSPH").write_text("Start: 1234 of the fluid, 56 of walls, from the geometry\n")
    write_table(case / "postProcessing/trajectory/0/trajectory.csv", constant_deceleration())
    write_table(case / "postProcessing/energy/0/energy.csv", {"time_s": np.array([0.0, 0.05])})

    def placed(points: np.ndarray) -> np.ndarray:
        return points[..., [0, 2, 1]] if flat else points

    line = np.arange(-0.975, 1, SPACING)
    places = np.stack(np.meshgrid(line, [0.0] if flat else [0.025, 0.075], line - 1, indexing="ij"), axis=-1).reshape(-1, 3)
    liquid, body = Series(case / "VTK", "particles"), Series(case / "VTK", "body")
    for time, z in ((0.0, 1.0), (0.02, 0.5), (0.04, -0.5)):
        data = vtkPolyData()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(placed(places), deep=True))
        data.SetPoints(points)
        arrays = dsa.WrapDataObject(data).PointData
        arrays.append(np.where(places[:, 2] < -1.95, 0, -1), "wall")
        arrays.append(np.full_like(places, 100 * time), "U")
        arrays.append(-1e4 * places[:, 2], "p")
        liquid.add(time, data)
        if flat:    # plungeSPH writes the section's outline
            shape = vtkRegularPolygonSource()
            shape.SetNumberOfSides(80)
            shape.GeneratePolylineOff()
        else:
            shape = vtkSphereSource()
            shape.SetThetaResolution(40)
            shape.SetPhiResolution(40)
        shape.SetCenter(*placed(np.array([0, 0, z])))
        shape.SetRadius(0.3)
        shape.Update()
        body.add(time, shape.GetOutput())
    return case


@pytest.mark.parametrize("flat", [False, True])
def test_the_slice_is_the_liquid_near_the_plane(tmp_path, flat):
    from plunge.particles import Case

    dive = Case(particle_dive(tmp_path, flat), "body")
    assert dive.axes == ("x", "y" if flat else "z") and not dive.mirrored
    slice_ = dive.section(1)
    assert len(slice_.points) == 40 * 39  # of two layers in y the first; its lowest particles are of the wall
    assert slice_.points[:, 1].min() == pytest.approx(-1.925) and slice_.speed == pytest.approx(2 * np.sqrt(3))
    assert slice_.pressure == pytest.approx(-1e4 * slice_.points[:, 1]) and slice_.triangles is None
    assert dive.extent()["high_m"] == pytest.approx([1.3, 0.8, -0.2], abs=1e-3)
    loop, = dive.section(0).body
    assert np.hypot(loop[:, 0], loop[:, 1] - 1) == pytest.approx(0.3, abs=0.005)
    assert np.abs(np.ptp(loop, axis=0) - 0.6).max() < 0.01 and loop[0] == pytest.approx(loop[-1])
    assert not np.any(dive.section(0).onBody[0])  # nothing is near
    deep = dive.section(2)
    assert deep.onBody[0] == pytest.approx(-1e4 * deep.body[0][:, 1], abs=300)


def test_a_quarter_is_mirrored_the_body_is_not(tmp_path):
    from plunge.particles import Case

    write_dive_parameters(particle_dive(tmp_path), model="quarter")
    dive = Case(tmp_path, "body")
    assert dive.mirrored and dive.axes == ("r", "z")
    loop, = dive.section(2).body
    on_body, = dive.section(2).onBody
    assert loop[:, 0].min() == pytest.approx(-0.3, abs=0.005)
    left, right = loop[:, 0] < -0.1, loop[:, 0] > 0.1
    assert on_body[left].mean() == pytest.approx(on_body[right].mean(), rel=0.02)


def test_the_picture_says_what_the_band_in_the_body_is(tmp_path):
    from plunge.figures import plt
    from plunge.particles import Case
    from plunge.sections import Look, sheet

    dive = Case(particle_dive(tmp_path), "body")
    figure = sheet("A dive", dive, Look.of(dive))
    assert figure._suptitle.get_text().splitlines() == ["A dive", "liquid within a spacing of y = 0; the band inside the body is the pressure on it"]
    plt.close(figure)


def test_a_dive_of_particles_is_reported_without_a_mesh(tmp_path):
    import matplotlib.image

    case = particle_dive(tmp_path)
    done = subprocess.run([TOOLS / "plungePost", case], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "1,234 particles of liquid" in done.stdout and "ledger" not in done.stdout
    numbers = read_numbers(case / "results/summary.csv")
    assert not any("ledger" in name for name in numbers)
    assert numbers["full immersion time"][0] == pytest.approx(0.036)
    assert sorted(p.name for p in (case / "results").iterdir()) == [
        "dive", "dive.png", "energy.csv", "summary.csv", "trajectory.csv", "trajectory.pdf", "trajectory.png"]
    picture = matplotlib.image.imread(case / "results/dive.png")[..., :3]
    assert (np.abs(picture - 0.45).max(axis=2) < 0.02).sum() > 1000  # the body

    done = subprocess.run([TOOLS / "plungePost", case, "-movie", "-noPictures"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    movie, = (case / "results").glob("dive.[gm][ip][f4]")
    assert str(movie) in done.stdout and "3 written times; plungeCase -set frames=60" in done.stdout
    assert "movie: 3 of 3 frames, left 0:00" in done.stderr

    (case / "VTK/body.vtp.series").unlink()
    done = subprocess.run([TOOLS / "plungePost", case], capture_output=True, text=True)
    assert done.returncode != 0 and "body.vtp.series: not found; plungePost writes it for meshes, plungeSPH" in done.stderr


def test_the_report_ends_with_the_answer_how_sure_it_is_and_what_was_left_out(tmp_path):
    case = particle_dive(tmp_path)
    note = "the wake's cavity is filled with gas that cannot be compressed, which costs the closure of the cavity " + "and more " * 9
    with (case / "log.plungeSPH").open("a") as log:
        log.write(SCENE.format(models="surface tension off, turbulence off, initial flow potential, fringe conserved, both fluids "
                               "incompressible", note=note.strip()))
    write_dive_parameters(case)
    write_uncertainties(case, "titan")
    done = subprocess.run([TOOLS / "plungePost", case], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[1] == "Files:"
    last = lines[-21:]
    assert last[next(i for i, line in enumerate(last) if line == "Modelled:"):] == [
        "Modelled:",
        "  body sixDoF, mesh motion overset, surface tension off, turbulence off, initial flow potential,",
        "    fringe conserved, both fluids incompressible.",
        f"{case.name}, NACA of 1 m at 25 m/s and 75 deg, fluids titan, half model, tier fast, 1,234 particles of liquid:",
        "  impact deceleration              50.01 m/s2, at 7.00 ms",
        "  peak deceleration                50.0 m/s2 +- 1.3 (mesh 0.30, time step 0.40, boundary layer 1.2), 5.104 g, at 50.00 ms, where the run ends",
        "  peak force of the fluids         0 N, at 1.00 ms",
        "  full immersion                   36.0000 ms +- 0.0050 (mesh 0.0030, time step 0.0040, boundary layer 0)",
        "  velocity lost at full immersion  1.750 m/s +- 0.051 (mesh 0.030, time step 0.010, boundary layer 0.040) of 25 m/s",
        "  pitch change at full immersion   3.6 deg",
        "  +-: root of the sum of the squares of its parts; the study diveUncertainty, version abc123 of",
        "    2026-11-30.",
        "Not modelled, and what that costs:",
        "  the wake's cavity is filled with gas that cannot be compressed, which costs the closure of the",
        "    cavity and more and more and more and more and more and more and more and more and more.",
        '  Ma = 0.02, in "gas", but compressibility is off.',
    ]
    numbers = read_numbers(case / "results/summary.csv")
    assert list(numbers)[list(numbers).index("peak deceleration") + 1] == "peak deceleration: uncertainty"
    assert numbers["full immersion time: uncertainty"] == (5e-6, "s")
    assert "pitch change at full immersion: uncertainty" not in numbers
    assert read_notes(case / "results/summary.csv") == [f"{note.strip()}.", 'Ma = 0.02, in "gas", but compressibility is off.']


def test_notes_on_the_figure_are_below_its_panels():
    from plunge.figures import plt, trajectory_figure

    table = constant_deceleration()
    tail = {"time_s": table["time_s"], "high_m": 1 - table["penetration_m"], "low_m": -table["penetration_m"]}
    numbers = key_numbers(table, None, tail)
    sure = {name: Uncertainty(0.02 * abs(numbers[name][0]), {"mesh": 0.0}) for name in HEADLINES}
    for count in (1, 12):
        figure = trajectory_figure("A dive", table, None, numbers, sure, ["a note of some length " * 9] * count)
        figure.canvas.draw()
        pixels = figure.canvas.get_renderer()
        block, = (text for text in figure.texts if "a note" in text.get_text())
        box = block.get_window_extent(pixels)
        assert box.y0 >= 0 and box.x1 <= figure.bbox.x1
        panels = [ax.get_tightbbox(pixels) for ax in figure.axes if ax.get_visible() and ax.axison]
        assert min(panel.y0 for panel in panels) >= box.y1
        assert sum("\\pm" in text.get_text() for ax in figure.axes for text in ax.texts) == len(HEADLINES)
        plt.close(figure)


@pytest.mark.parametrize("late", [0.0, 1.0])
def test_the_names_of_the_forces_are_not_on_their_curves(late):
    from plunge.figures import plt, trajectory_figure

    table = constant_deceleration()
    table["v3_m_s"], table["vz_m_s"] = 0 * table["time_s"], -table["speed_m_s"]
    table["Fpz_N"] = np.where(table["time_s"] > 0.025, 10 * late, 10 * (1 - late))
    table["Fgz_N"][:] = -10.0
    figure = trajectory_figure("A dive", table, None, key_numbers(table, None, extent_of(table, 1)), {}, ["a note"], Body("axial"))
    figure.canvas.draw()
    forces, = (ax for ax in figure.axes if "Force against" in ax.get_title("left"))
    names = forces.get_legend().get_window_extent(figure.canvas.get_renderer())
    for line in forces.lines[:3]:
        assert not names.count_contains(forces.transData.transform(line.get_xydata()))
    plt.close(figure)


FORCE, REST = "Force against the motion, ", {"Penetration depth"}
MOVED = REST | {"Speed of the centre of mass", "Axial deceleration"}
TURNED = MOVED | {"Lateral acceleration, body axes", "Pitch"}


@pytest.mark.parametrize("body, straight, shows", [
    (Body("free"), False, TURNED | {"Path of the centre of mass", FORCE + "whole body"}),
    (Body("free", False, "z", 0.1, 0.01, 500), False, TURNED | {"Path of the centre of mass", FORCE + "whole body", "coefficient"}),
    (Body("planar", True, "z", 0.1, 0.1, 500), True, TURNED | {FORCE + "per metre", "coefficient"}),
    (Body("axial", False, "z", 0.1, 0.01, 500), True, MOVED | {FORCE + "whole body", "coefficient"}),
    (Body("axial"), True, MOVED | {FORCE + "whole body"}),
    (Body("prescribed", False, "z", 0.1, 0.01, 500), True, REST | {FORCE + "whole body", "coefficient"}),
    (Body("fixed", True, "z", 0.1, 0.1, 500), True, {"Force of the fluids, per metre"})])
def test_no_panel_is_wasted_on_what_the_body_cannot_do(body, straight, shows):
    from plunge.figures import plt, trajectory_figure

    table = constant_deceleration()
    table["z_m"] = -table["penetration_m"]
    table["x_m"] = table["penetration_m"] * (0.001 if straight else 0.3)
    table["Fpx_N"][:] = 5.0
    numbers = key_numbers(table, None, extent_of(table, 1), body)
    figure = trajectory_figure("A body", table, None, numbers, {}, ["a note"], body)
    titles = {"coefficient" if "rho" in ax.get_title("left") else ax.get_title("left") for ax in figure.axes if ax.axison}
    assert titles == shows
    forces, = (ax for ax in figure.axes if "Force" in ax.get_title("left") and "rho" not in ax.get_title("left"))
    assert forces.get_ylabel() == ("force [N/m]" if body.inPlane else "force [N]")
    if body.freedom == "fixed":  # the force itself, since there is no motion
        line, = forces.lines[:1]
        assert line.get_label() == "x" and (line.get_ydata() == 5).all()
    plt.close(figure)


def test_a_body_that_moves_as_prescribed_is_reported_by_its_forces(tmp_path):
    case = particle_dive(tmp_path)
    write_body_parameters(case, model="quarter", shape="sphere", freedom="prescribed")
    done = subprocess.run([TOOLS / "plungePost", case, "-noPictures"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "sphere of 0.25 m at 4 m/s and 90 deg, prescribed, fluids water, quarter model" in done.stdout
    assert "peak force of the fluids" in done.stdout and "contact  " in done.stdout
    for word in ("velocity", "deceleration", "pitch"):
        assert word not in done.stdout and not any(word in name for name in read_numbers(case / "results/summary.csv"))


@pytest.mark.parametrize("freedoms, panels", [
    (("free", "axial"), {"Axial deceleration", "Speed lost", "Penetration depth", "Pitch"}),
    (("axial", "prescribed"), {"Axial deceleration", "Speed lost", "Penetration depth", "Force of the fluids"}),
    (("prescribed", "fixed"), {"Penetration depth", "Force of the fluids"})])
def test_an_overlay_has_the_panels_that_any_of_its_runs_fills(freedoms, panels):
    from plunge.figures import overlay_figure, plt

    table = constant_deceleration()
    table["Fpz_N"][:] = 7.0
    runs = []
    for freedom in freedoms:
        body = Body(freedom, inPlane=freedom == "fixed")
        runs.append((freedom, table, key_numbers(table, None, extent_of(table, 1), body), body))
    figure = overlay_figure(runs)
    assert {ax.get_title("left") for ax in figure.axes} == panels
    for ax in figure.axes:
        curves = sum(len(line.get_xdata()) == len(table["time_s"]) for line in ax.lines)
        driven = sum(freedom in ("prescribed", "fixed") for freedom in freedoms)
        turning = sum(freedom == "free" for freedom in freedoms)
        assert curves == {"Axial deceleration": 2 - driven, "Speed lost": 2 - driven, "Pitch": turning}.get(ax.get_title("left"), 2)
        if freedoms == ("prescribed", "fixed") and "Force" in ax.get_title("left"):
            assert ax.get_ylabel() == "force [N or N/m]"
    plt.close(figure)


def test_runs_of_any_body_are_laid_over_each_other(tmp_path):
    for name, freedom in (("one", "free"), ("other", "prescribed")):
        case = particle_dive(tmp_path / name)
        write_body_parameters(case, model="quarter", shape="sphere", freedom=freedom)
        subprocess.run([TOOLS / "plungePost", case, "-noPictures"], check=True, capture_output=True)
    figure = tmp_path / "both.png"
    subprocess.run([TOOLS / "plungeOverlay", tmp_path / "one", tmp_path / "other", "-mean", "1e-3", "-o", figure], check=True,
                   capture_output=True)
    assert figure.stat().st_size > 10000
    with figure.with_suffix(".csv").open() as file:
        rows = {row[0]: row[2:] for row in csv.reader(file)}
    assert rows["contact time"] == ["0.001", "0.001"]
    assert rows["velocity lost at end"][0] == "2.45" and rows["velocity lost at end"][1] == ""
    assert "sphere of 0.25 m" in rows["quantity"][0] and "prescribed" in rows["quantity"][1]

    # Of a body in the plane forces are per metre
    summary = tmp_path / "other/results/summary.csv"
    summary.write_text(re.sub(r"(?m)^(peak force,.*),N$", r"\1,N/m", summary.read_text()))
    subprocess.run([TOOLS / "plungeOverlay", tmp_path / "one", tmp_path / "other", "-o", figure], check=True, capture_output=True)
    with figure.with_suffix(".csv").open() as file:
        forces = [[unit, bool(one), bool(other)] for name, unit, one, other in csv.reader(file) if name == "peak force"]
    assert forces == [["N", True, False], ["N/m", False, True]]
