# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input: plungeFoam stops before the first time step and names the file, the entry and what it expected."""
import os
import re
import shutil
import struct
from pathlib import Path
from typing import Callable, Dict, NamedTuple, Tuple

import pytest

from tutorials import checkRefused, copy, foam, run, setEntry, setUp, steps
from plunge.studies.particleRuns import override

MOTION = "constant/dynamicMeshDict"
COEFFS = "sixDoFRigidBodyMotionCoeffs"


@pytest.fixture(scope="module")
def cases(tmp_path_factory: pytest.TempPathFactory) -> Dict[str, Path]:
    """A single static mesh, and a body on an overset mesh; both coarse, about 600 and 8000 cells."""
    directory = tmp_path_factory.mktemp("badInput")
    return {
        "damBreak": setUp("damBreak", directory / "damBreak", "-coarser", 2, "-application", "plungeFoam", "-endTime", 0.002),
        "floatingBody": setUp("floatingBody", directory / "floatingBody",
                              "-coarser", 4, "-application", "plungeFoam", "-endTime", 0.001, "-deltaT", 0.001),
    }


def scene(*lines: str) -> Callable[[Path], None]:
    """Writes constant/sceneProperties."""
    header = "FoamFile { version 2.0; format ascii; class dictionary; object sceneProperties; }\n"
    return lambda case: (case / "constant/sceneProperties").write_text(header + "\n".join(lines) + "\n") and None


def both(*edits: Callable[[Path], None]) -> Callable[[Path], None]:
    """Makes several changes."""
    def edit(case: Path) -> None:
        for each in edits:
            each(case)
    return edit


def entry(file: str, name: str, value: object) -> Callable[[Path], None]:
    """Sets an entry of a dictionary."""
    return lambda case: setEntry(case, file, name, value)


def alphaControl(line: str) -> Callable[[Path], None]:
    """Adds a line to the controls of the volume fraction."""
    def edit(case: Path) -> None:
        path = case / "system/fvSolution"
        path.write_text(path.read_text().replace("nAlphaSubCycles", f"{line} nAlphaSubCycles", 1))
    return edit


def shifted(vector: str) -> Callable[[Path], None]:
    """Moves the mesh of the body, and the body with it, before both meshes are merged."""
    def edit(case: Path) -> None:
        body = case / "body"
        shutil.copytree(case.parent / "floatingBody", body)
        foam("transformPoints", "-translate", vector, "-case", body, case=case)
        shutil.rmtree(case / "constant/polyMesh")
        shutil.rmtree(case / "0")
        shutil.copytree(case / "0.orig", case / "0")
        for command in (("blockMesh",), ("mergeMeshes", ".", "body", "-overwrite"), ("topoSet",), ("setFields",)):
            foam(*command, case=case)
    return edit


def notANumber(field: str) -> Callable[[Path], None]:
    """Puts one into a field in binary format, where no reader stumbles over it."""
    def edit(case: Path) -> None:
        if field != "alpha.water":     # which setFields has made a list of
            setEntry(case, f"0/{field}", "internalField", f"nonuniform List<vector> {cells(case)}{{(0 0 0)}}")
        setEntry(case, "system/controlDict", "writeFormat", "binary")
        setEntry(case, "system/controlDict", "startFrom", "startTime")
        foam("foamFormatConvert", case=case)
        path = case / "0" / field
        data = path.read_bytes()
        begin = data.index(b"(", data.index(b"nonuniform")) + 1
        path.write_bytes(data[:begin] + struct.pack("d", float("nan")) + data[begin + 8:])
    return edit


def cells(case: Path) -> int:
    return int(re.search(r"nCells:\s*(\d+)", (case / "constant/polyMesh/owner").read_text(errors="replace"))[1])


class Mistake(NamedTuple):
    """What is wrong, in which case, and what the message has to name."""
    case: str
    edit: Callable[[Path], None]
    named: Tuple[str, ...]


MISTAKES = {
    "time step that has collapsed": Mistake(
        "damBreak", entry("system/controlDict", "minDeltaT", 1), ("controlDict", "minDeltaT")),
    "patch that is missing": Mistake(
        "floatingBody", entry(MOTION, f"{COEFFS}/patches", "(keel)"), ("dynamicMeshDict", "patches", "keel", "floatingObject")),
    "body outside the domain": Mistake(
        "floatingBody", shifted("(0.7 0 0)"), ("dynamicMeshDict", "outside the domain", "(1.2 1.2 1)")),
    "centre of mass outside the domain": Mistake(
        "floatingBody", entry(MOTION, f"{COEFFS}/centreOfMass", "(0.5 0.5 7)"), ("dynamicMeshDict", "centreOfMass", "(0.5 0.5 7)", "inside")),
    "mass of zero": Mistake(
        "floatingBody", entry(MOTION, f"{COEFFS}/mass", "0"), ("dynamicMeshDict", "mass", "positive mass")),
    "moment of inertia of zero": Mistake(
        "floatingBody", entry(MOTION, f"{COEFFS}/momentOfInertia", "(1 0 1)"), ("dynamicMeshDict", "momentOfInertia", "positive")),
    "overset zone without a donor": Mistake(
        "floatingBody", shifted("(5 0 0)"), ("zone 1", "zoneID", "donor", "Expected")),
    "unknown keyword": Mistake(
        "damBreak", scene("surfaceTention on;"), ("sceneProperties", "surfaceTention", "surfaceTension")),
    "unknown interface scheme": Mistake(
        "damBreak", scene("interface levelSet;"), ("sceneProperties", "interface", "levelSet", "MULES", "isoAdvector")),
    "scene that repeats the mesh's motion": Mistake(
        "floatingBody", scene("meshMotion overset;"), ("sceneProperties", "meshMotion", "follow from", "dynamicMeshDict")),
    "scene that repeats the body": Mistake(
        "damBreak", scene("body none;"), ("sceneProperties", "body", "follow from", "dynamicMeshDict")),
    "wall functions in a laminar case": Mistake(
        "damBreak", scene("boundaryLayer wallFunction;"), ("sceneProperties", "boundaryLayer", "wallFunction", "simulationType", "RAS")),
    "friction line in a turbulent case": Mistake(
        "floatingBody", scene("boundaryLayer frictionLine;"), ("sceneProperties", "boundaryLayer", "frictionLine", "simulationType")),
    "unknown boundary layer": Mistake(
        "damBreak", scene("boundaryLayer turbulent;"), ("sceneProperties", "boundaryLayer", "turbulent", "frictionLine", "wallFunction")),
    "laminar layer that the mesh does not resolve": Mistake(
        "damBreak", scene("boundaryLayer laminar;", "reference { length 0.5; speed 25; }"),
        ("sceneProperties", "does not resolve", "frictionLine")),
    "transition below zero": Mistake(
        "damBreak", scene("boundaryLayer frictionLine;", "frictionLineCoeffs { transitionReynolds -1; }"),
        ("frictionLineCoeffs", "transitionReynolds", "-1", "positive")),
    "unknown entry of the friction line": Mistake(
        "damBreak", scene("boundaryLayer frictionLine;", "frictionLineCoeffs { transition 1; }"),
        ("frictionLineCoeffs", "transition", "transitionReynolds", "patches")),
    "friction line on a patch that is missing": Mistake(
        "damBreak", scene("boundaryLayer frictionLine;", "frictionLineCoeffs { patches (hull); }"),
        ("frictionLineCoeffs", "patches", "hull", "leftWall")),
    "friction line on an open boundary": Mistake(
        "damBreak", scene("boundaryLayer frictionLine;", "frictionLineCoeffs { patches (leftWall atmosphere); }"),
        ("frictionLineCoeffs", "atmosphere", "patch", "type wall")),
    "friction line that is no word": Mistake(
        "damBreak", scene("boundaryLayer { type frictionLine; }"), ("sceneProperties", "boundaryLayer", "dictionary", "frictionLineCoeffs")),
    "friction line's entries that are no dictionary": Mistake(
        "damBreak", scene("boundaryLayer frictionLine;", "frictionLineCoeffs 5;"), ("frictionLineCoeffs", "dictionary", "transitionReynolds")),
    "friction line of the lighter fluid": Mistake(
        "damBreak", both(scene("boundaryLayer frictionLine;"), entry("constant/transportProperties", "water/rho", 0.5)),
        ("transportProperties", "phases", "heavier", "liquid first")),
    "friction line without viscosity": Mistake(
        "damBreak", both(scene("boundaryLayer frictionLine;"), entry("constant/transportProperties", "water/nu", 0)),
        ("sceneProperties", "frictionLine", "viscosity", "none")),
    "friction line on a wall that moves by itself": Mistake(
        "damBreak", both(scene("boundaryLayer frictionLine;"),
                         entry("0/U", "boundaryField/leftWall", "{ type fixedValue; value uniform (0 1 0); }")),
        ("sceneProperties", "leftWall", "moves", "at rest")),
    "laminar layer on a wall that slips": Mistake(
        "damBreak", both(scene("boundaryLayer laminar;"), entry("0/U", "boundaryField/leftWall", "{ type slip; }")),
        ("sceneProperties", "laminar", "leftWall", "slip", "noSlip")),
    "wall functions on a wall that slips": Mistake(
        "floatingBody", both(scene("boundaryLayer wallFunction;"), entry("0/U", "boundaryField/floatingObject", "{ type slip; }")),
        ("sceneProperties", "wallFunction", "floatingObject", "slip", "movingWallVelocity")),
    "turbulence in the scene": Mistake(
        "damBreak", scene("turbulence on;"), ("sceneProperties", "turbulence", "boundaryLayer")),
    "compressibility": Mistake(
        "damBreak", scene("compressibility none;"), ("sceneProperties", "compressibility", "incompressible")),
    "isoAdvector on an overset mesh": Mistake(
        "floatingBody", scene("interface isoAdvector;"), ("sceneProperties", "interface", "isoAdvector", "overset", "MULES")),
    "local time steps on a mesh that moves": Mistake(
        "floatingBody", entry("system/fvSchemes", "ddtSchemes/default", "localEuler"), ("fvSchemes", "localEuler", "mesh", "Expected")),
    "local time steps of isoAdvector": Mistake(
        "damBreak", both(scene("interface isoAdvector;"), entry("system/fvSchemes", "ddtSchemes/default", "localEuler")),
        ("fvSchemes", "localEuler", "isoAdvector", "MULES")),
    "interface Courant number of zero": Mistake(
        "damBreak", entry("system/controlDict", "maxAlphaCo", "0"), ("controlDict", "maxAlphaCo", "positive")),
    "no pressure correction": Mistake(
        "damBreak", entry("system/fvSolution", "PIMPLE/nCorrectors", 0), ("fvSolution", "nCorrectors", "is 0", "at least 1")),
    "no pass": Mistake(
        "floatingBody", entry("system/fvSolution", "PIMPLE/nOuterCorrectors", 0), ("fvSolution", "nOuterCorrectors", "is 0", "at least 1")),
    "fewer than no corrections of oblique meshes": Mistake(
        "damBreak", entry("system/fvSolution", "PIMPLE/nNonOrthogonalCorrectors", -1), ("fvSolution", "nNonOrthogonalCorrectors", "is -1")),
    "interface that is not advanced": Mistake(
        "damBreak", entry("system/fvSolution", 'solvers/"alpha.water.*"/nAlphaCorr', 0), ("fvSolution", "nAlphaCorr", "is 0", "at least 1")),
    "one correction at a Courant number of five": Mistake(
        "damBreak", both(entry("system/fvSolution", "PIMPLE/nCorrectors", 1), entry("system/controlDict", "maxCo", 5)),
        ("controlDict", "maxCo", "is 5", "one pressure correction", "nCorrectors 2")),
    "density below zero": Mistake(
        "damBreak", entry("constant/transportProperties", "water/rho", -1000), ("transportProperties", "water", "rho", "-1000", "positive")),
    "density of zero": Mistake(
        "floatingBody", entry("constant/transportProperties", "air/rho", 0), ("transportProperties", "air", "rho", "is 0", "positive")),
    "viscosity below zero": Mistake(
        "damBreak", entry("constant/transportProperties", "air/nu", -1e-5), ("transportProperties", "air", "nu", "-1e-05", "positive")),
    "surface tension below zero": Mistake(
        "damBreak", entry("constant/transportProperties", "sigma", -0.07), ("transportProperties", "sigma", "-0.07", "positive")),
    "fraction of two": Mistake(
        "damBreak", entry("0/alpha.water", "internalField", "uniform 2"), ("alpha.water", "internalField", "holds 2", "from 0 to 1")),
    "fraction below zero that flows in": Mistake(
        "damBreak", entry("0/alpha.water", "boundaryField/atmosphere/inletValue", "uniform -1"),
        ("alpha.water", "atmosphere", "inletValue", "holds -1", "from 0 to 1")),
    "no number in a binary field": Mistake("damBreak", notANumber("U"), ("0/U", "internalField", "no number", "finite")),
    "no number in the liquid": Mistake("floatingBody", notANumber("alpha.water"), ("0/alpha.water", "internalField", "no number", "finite")),
    "step of zero": Mistake("damBreak", entry("system/controlDict", "deltaT", 0), ("controlDict", "deltaT", "is 0", "positive")),
    "longest step of zero": Mistake("damBreak", entry("system/controlDict", "maxDeltaT", 0), ("controlDict", "maxDeltaT", "is 0", "positive")),
    "end before the start": Mistake("damBreak", entry("system/controlDict", "endTime", -1), ("controlDict", "endTime", "is -1", "after the start")),
    "library of a function object that is misspelt": Mistake(
        "damBreak", entry("system/controlDict", "functions/bodyForces", "{ type plungeEvent; libs (plungeFunctionObjekts); event immersed; }"),
        ("controlDict", "function object", "bodyForces", "libs")),
}

if int(os.environ["FOAM_API"]) < 2006:
    # From v2006 on OpenFOAM has it
    MISTAKES["reconstruction of a later OpenFOAM"] = Mistake(
        "damBreak", both(scene("interface isoAdvector;"), alphaControl("reconstructionScheme plicRDF;")),
        ("fvSolution", "reconstructionScheme", "plicRDF", "isoAlpha", "v2006"))


@pytest.mark.parametrize("name", MISTAKES)
def test_badInput(name: str, cases: Dict[str, Path]) -> None:
    mistake = MISTAKES[name]
    case = copy(cases[mistake.case], re.sub(r"\W+", "_", name))
    mistake.edit(case)
    checkRefused("plungeFoam", case, mistake.named)


@pytest.mark.parametrize("case", ["damBreak", "floatingBody"])
def test_goodInput(case: str, cases: Dict[str, Path]) -> None:
    """Without a mistake the same cases run, with a scene that says what they are."""
    good = copy(cases[case], f"good-{case}")
    scene(f"boundaryLayer {'frictionLine' if case == 'damBreak' else 'wallFunction'};")(good)
    assert steps(foam("plungeFoam", case=good, log="log.solver"))


# --- restarts ------------------------------------------------------------------


def writes(cases: Dict[str, Path], name: str, scheme: str) -> Path:
    """A run of a body on an overset mesh that has written a time."""
    case = copy(cases["floatingBody"], name)
    setEntry(case, "system/fvSchemes", "ddtSchemes/default", scheme)
    setEntry(case, "system/controlDict", "writeControl", "timeStep")
    setEntry(case, "system/controlDict", "writeInterval", 1)
    foam("plungeFoam", case=case, log="log.solver")
    setEntry(case, "system/controlDict", "startFrom", "latestTime")
    setEntry(case, "system/controlDict", "endTime", 0.002)
    return case


@pytest.fixture(scope="module")
def written(cases: Dict[str, Path]) -> Path:
    return writes(cases, "written", "Euler")


@pytest.fixture(scope="module")
def writtenBackward(cases: Dict[str, Path]) -> Path:
    return writes(cases, "writtenBackward", "backward")


@pytest.mark.parametrize("lost", ["U_0", "phi_0", "Uf_0", "ddtSteady"])
def test_restartOfSecondOrderWithoutAFile(lost: str, writtenBackward: Path) -> None:
    case = copy(writtenBackward, f"without-{lost}")
    (case / "0.001" / lost).unlink()
    checkRefused("plungeFoam", case, ("0.001", "lacks", lost, "Expected"))


def test_restartOfSecondOrder(writtenBackward: Path, written: Path) -> None:
    """With all files, and with none, as after a run with Euler's steps."""
    assert steps(foam("plungeFoam", case=copy(writtenBackward, "wholeBackward"), log="log.solver")) == ["0.002"]
    case = copy(written, "fromEuler")
    setEntry(case, "system/fvSchemes", "ddtSchemes/default", "backward")
    assert steps(foam("plungeFoam", case=case, log="log.solver")) == ["0.002"]


@pytest.mark.parametrize("lost", ["polyMesh", "uniform", "uniform/sixDoFRigidBodyMotionState", "uniform/time", "phi", "Uf"])
def test_restartWithoutAFile(lost: str, written: Path) -> None:
    case = copy(written, "without-" + lost.replace("/", "-"))
    for path in (case / "0.001").glob(f"{lost}*"):
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    named = "uniform/time" if lost == "uniform" else lost
    checkRefused("plungeFoam", case, ("0.001", "lacks", named, "Expected"))


def test_restart(written: Path) -> None:
    """With all files it goes on; without any that only a run writes the fields are those of a first start."""
    assert steps(foam("plungeFoam", case=copy(written, "whole"), log="log.solver")) == ["0.002"]
    anew = copy(written, "anew")
    for name in ("phi", "Uf", "uniform", "polyMesh"):
        for path in (anew / "0.001").glob(f"{name}*"):
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    assert steps(foam("plungeFoam", case=anew, log="log.solver")) == ["0.002"]


def test_restraintsThatLag(cases: Dict[str, Path]) -> None:
    """A spring with an integrator that takes it a step late is allowed, as in the tutorials, and noted."""
    case = copy(cases["floatingBody"], "lagging")
    spring = "{ sixDoFRigidBodyMotionRestraint linearSpring; anchor (0.5 0.5 0); refAttachmentPt (0.5 0.45 0.1); stiffness 10; damping 0; restLength 0.1; }"
    for coefficients in ("solver { type Newmark; }", f"restraints {{ spring {spring} }}"):
        with (case / "constant/dynamicMeshDict").open("a") as file:
            file.write(f"sixDoFRigidBodyMotionCoeffs {{ {coefficients} }}\n")
    assert "    Note: The integrator Newmark takes the body's restraints as they stood" in foam("plungeFoam", case=case, log="log.solver")


# --- while it runs -------------------------------------------------------------


def test_pressureThatIsNotSolved(cases: Dict[str, Path]) -> None:
    """It is told once; where nothing of it is solved the run stops, with its fields."""
    case = copy(cases["damBreak"], "unsolved")
    setEntry(case, "system/controlDict", "endTime", 0.02)
    setEntry(case, "system/fvSolution", "solvers/p_rghFinal/maxIter", 2)
    log = foam("plungeFoam", case=case, log="log.solver")
    assert log.count("    Note: p_rgh was not solved: its solver DICPCG stopped after 2 iterations") == 1 and log.rstrip().endswith("End")


def test_fractionsOfWarpedCellsAreCutOff(cases: Dict[str, Path]) -> None:
    """setAlphaField leaves up to some per cent too much in them."""
    case = copy(cases["damBreak"], "warped")
    field = case / "0/alpha.water"
    text = field.read_text()
    assert "\n1\n" in text
    field.write_text(text.replace("\n1\n", "\n1.005\n", 1))
    log = foam("plungeFoam", case=case, log="log.solver")
    assert "out of 0 to 1 by up to 0.005" in log and "Max(alpha.water) = 1.005" not in log


def test_aLiquidWithoutASurfaceIsSolved(tmp_path: Path) -> None:
    """A sphere that is released far below: its mesh holds nothing but liquid, whose uniform volume fraction has no residual."""
    (tmp_path / "deep").write_text("body { shape { type sphere; radius 0.05; } density 500; freedom axial; } fluids water; "
                                   "entry { speed 0; depth 1; } duration 0.002; frames 1;\n")
    run = tmp_path / "run"
    foam("plungeCase", "deep", "-np", 1, "-run", run, case=tmp_path)
    foam("./Allrun", "-setUp", case=run)
    log = foam("plungeFoam", case=run, log="log.plungeFoam")
    assert "was not solved" not in log and "mesh motion on" in log


CIRCLE = """body { shape { type circle; radius 0.05; } density 500; freedom planar; }
fluids { liquid water; gas earthAir; liquidViscosity 100; gasViscosity 1.8; }
entry { speed 3; angle 90; } duration 0.02; frames 1;
"""


def test_diffusionNumber(tmp_path: Path) -> None:
    """A body in a fluid 1e5 times as viscous as water: three pressure corrections, which plungeCase takes, follow; two do not, and are
    refused, or, where the step is short at first only, told, in the summary too."""
    (tmp_path / "circle").write_text(CIRCLE)
    circle = tmp_path / "run"
    foam("plungeCase", "circle", "-np", 1, "-resolution", 0.5, "-run", circle, case=tmp_path)
    foam(circle / "Allrun", "-setUp", case=circle)
    log = foam("plungeFoam", case=copy(circle, "three"), log="log.plungeFoam")
    assert log.rstrip().endswith("End") and "\nRun\n" not in log
    two = copy(circle, "two")
    override(two, "system/fvSolution", "PIMPLE { nCorrectors 2; }")
    refused = copy(two, "refused")
    override(refused, "system/controlDict", "deltaT 1e-3;")
    checkRefused("plungeFoam", refused, ("fvSolution", "nCorrectors", "is 2", "diffusion number"))
    override(two, "system/controlDict", "deltaT 1e-6;")
    done = run("plungeFoam", case=two, log="log.plungeFoam")
    assert done.stdout.count("    Note: The diffusion number is") == 1
    # The load does not follow the body either
    assert re.search(r"^Note: In \d+ of \d+ steps the force on the body and the change of its momentum differ", done.stdout, re.M)
    # Lost or not within so short a time, it is in the summary
    foam("plungePost", "-noPictures", case=two)
    summary = (two / "results/summary.csv").read_text()
    assert "the change of its momentum differ" in summary and "The diffusion number is" in summary


def test_diskThatIsFull(cases: Dict[str, Path]) -> None:
    case = copy(cases["damBreak"], "full")
    setEntry(case, "system/controlDict", "writeControl", "timeStep")
    setEntry(case, "system/controlDict", "writeInterval", 1)
    done = run("bash", "-c", "trap '' XFSZ; ulimit -f 4; exec plungeFoam", case=case)
    # OpenFOAM's message, or ours, where it has none
    assert done.returncode != 0 and "FOAM FATAL" in done.stdout and re.search(r"error in IOstream .*/0\.\d+/|could not be written", done.stdout)


def test_heavierFluidAbove(cases: Dict[str, Path]) -> None:
    """Allowed, and noted."""
    case = copy(cases["damBreak"], "above")
    assert "lies above" not in foam("plungeFoam", case=case, log="log.solver")
    setEntry(case, "constant/g", "value", "(0 9.81 0)")
    assert "Note: The heavier fluid, water, lies above the lighter one at the start" in foam("plungeFoam", case=case, log="log.solver")
