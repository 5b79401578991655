# SPDX-License-Identifier: GPL-3.0-or-later
"""The models of titanThermophysicalModels in unmodified stock solvers and in plungeFoam: `libs` is all that a case needs."""
import re
from pathlib import Path
from typing import Dict, List, Tuple

import numpy as np
import pytest

from tutorials import checkRefused, compare, copy, foam, run, setEntry, setUp, steps

LIBRARY = "(titanThermophysicalModels)"
TRANSPORT = "constant/transportProperties"
LAKE = "composition {CH4 3; C2H6 7; saturated true;} T 94; p 1.467e5;"
MIXTURE = "composition {N2 0.05; CH4 0.25; C2H6 0.7;} p 1.467e5; phase liquid;"


def dictionary(case: Path, file: str, text: str, of: str = "dictionary") -> None:
    """Writes a dictionary or a field."""
    path = case / file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"FoamFile {{ version 2.0; format ascii; class {of}; object {path.name}; }}\n{text}\n")


def transport(case: Path, liquid: str = "transportModel titanFluid; fluid Kraken;",
              gas: str = "transportModel titanFluid; fluid titanAir;", sigma: str = "{ type titanFluid; fluid Kraken; }") -> None:
    """Writes the two phases of damBreak."""
    dictionary(case, TRANSPORT, f"phases (water air);\nwater {{ {liquid} }}\nair {{ {gas} }}\nsigma {sigma}{'' if sigma.endswith('}') else ';'}")


def scalars(path: Path) -> np.ndarray:
    """Cell values of a volScalarField."""
    return compare.readCells(path)[:, 0]


def inFull(output: str) -> List[Dict[str, str]]:
    """What the debug switch of titanFluid prints, one dictionary for each model."""
    return [dict(re.findall(r"(\w+) ([^ ;]+);", line)) for line in re.findall(r"In full:(.*)", output)]


def damBreak(directory: Path, *options: object) -> Path:
    """The tutorial, coarse, with the library and its debug output."""
    case = setUp("damBreak", directory, "-coarser", 2, *options)
    setEntry(case, "system/controlDict", "libs", LIBRARY)
    setEntry(case, "system/controlDict", "writePrecision", 17)
    setEntry(case, "system/controlDict", "DebugSwitches", "{ titanFluid 1; }")
    return case


@pytest.mark.parametrize("solver", ["interFoam", "plungeFoam"])
def test_sameAsConstants(solver: str, tmp_path: Path) -> None:
    """Bit for bit the fields of the same case with the constants typed in."""
    titan = damBreak(tmp_path / "damBreak", "-application", solver, "-endTime", 0.05, "-writeInterval", 0.05)
    typed = copy(titan, "typed")

    transport(titan)
    liquid, gas, sigma = inFull(foam(solver, case=titan, log="log.solver"))
    assert 500 < float(liquid["rho"]) < 700 and 4 < float(gas["rho"]) < 7 and 0.01 < float(sigma["sigma"]) < 0.04

    newtonian = "transportModel Newtonian; nu {nu}; rho {rho};"
    transport(typed, newtonian.format(**liquid), newtonian.format(**gas), sigma["sigma"])
    assert not inFull(foam(solver, case=typed, log="log.solver"))

    assert compare.times(titan) == compare.times(typed) == ["0.05"]
    for field in ("alpha.water", "U", "p_rgh", "p", "phi"):
        assert (titan / "0.05" / field).read_bytes() == (typed / "0.05" / field).read_bytes(), field


@pytest.mark.parametrize("evaluation", ["direct", "tabulated"])
def test_followsTemperature(evaluation: str, tmp_path: Path) -> None:
    """Each cell has the viscosity of its temperature; that the density is the selection's keeps the dynamic viscosity right."""
    case = damBreak(tmp_path / "damBreak", "-application", "interFoam", "-endTime", 0.001, "-deltaT", 0.001, "-writeInterval", 0.001)
    # A function object solves for the temperature, after the flow: in the first step it is the initial one
    temperatures = np.resize([91.5, 94, 95.5], len(scalars(case / "0/alpha.water")))
    dictionary(case, "0/T", "dimensions [0 0 0 1 0 0 0];\n"
               f"internalField nonuniform List<scalar> {len(temperatures)} ({' '.join(map(str, temperatures))});\n"
               'boundaryField { ".*" { type zeroGradient; } defaultFaces { type empty; } }', "volScalarField")
    setEntry(case, "system/controlDict", "functions",
             "{ T { type scalarTransport; libs (solverFunctionObjects); field T; D 1e-9; bounded01 no; }"
             "  nu { type writeObjects; libs (utilityFunctionObjects); objects (nu1); writeControl writeTime; } }")
    setEntry(case, "system/fvSchemes", "divSchemes/div(phi,T)", "Gauss upwind")
    setEntry(case, "system/fvSolution", "solvers/T", "{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-12; relTol 0; }")

    def solved(name: str, T: float, how: str) -> Tuple[np.ndarray, Dict[str, float]]:
        """The field nu, and the values at the temperature of the selection."""
        at = copy(case, name)
        model = f"{MIXTURE} T {T}; evaluation {how};{' TRange (91 96);' if how == 'tabulated' else ''}"
        transport(at, f"transportModel titanFluid; {model}", sigma=f"{{ type titanFluid; {model} }}")
        selected = inFull(foam("interFoam", case=at, log="log.solver"))[0]
        return scalars(at / "0.001/nu1"), {key: float(value) for key, value in selected.items()}

    mu = {}
    for T in set(temperatures):
        nu, selected = solved(f"at{T}", T, "constant")
        assert (nu == selected["nu"]).all()
        mu[T] = selected["nu"]*selected["rho"]
    assert mu[95.5] < 0.96*mu[91.5], "the viscosity does not depend on the temperature"

    nu, selected = solved(evaluation, 94, evaluation)
    np.testing.assert_allclose(nu, [mu[T]/selected["rho"] for T in temperatures], rtol={"direct": 1e-12, "tabulated": 1e-6}[evaluation])


# --- Weak compressibility in compressibleInterFoam ------------------------------

SCHEMES = """
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes
{
    default none;
    div(phi,alpha) Gauss vanLeer; div(phirb,alpha) Gauss linear;
    div(rhoPhi,U) Gauss linear; div(rhoPhi,T) Gauss upwind; div(rhoPhi,K) Gauss linear; div(phi,p) Gauss linear;
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear uncorrected; }
interpolationSchemes { default linear; }
snGradSchemes { default uncorrected; }
"""

SOLUTION = """
solvers
{
    "alpha.liquid.*"
    {
        nAlphaCorr 1; nAlphaSubCycles 2; cAlpha 1; MULESCorr no; nLimiterIter 5;
        solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0;
    }
    ".*(rho|rhoFinal)" { solver diagonal; }
    "(p_rgh|pcorr).*" { solver PCG; preconditioner DIC; tolerance 1e-10; relTol 0; }
    "(U|T).*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-10; relTol 0; }
}
PIMPLE { momentumPredictor no; transonic no; nOuterCorrectors 1; nCorrectors 2; nNonOrthogonalCorrectors 0; }
"""

AMBIENT = 1.467e5


def compressibleCase(case: Path, cells: Tuple[int, int], regions: str, law: str, coefficients: str,
                     energy: str = "sensibleInternalEnergy", thermo: str = "hConst", g: float = 0, **control: object) -> Path:
    """A closed box of 1 m with liquid at rest at 94 K and ambient pressure, but for the regions of setFields; gas is nitrogen."""
    control = {"writeControl": "timeStep", "adjustTimeStep": "no", "maxCo": 0.3, "maxAlphaCo": 0.3, "maxDeltaT": 1,
               "writePrecision": 12, "timePrecision": 12, **control}
    dictionary(case, "system/controlDict", "application compressibleInterFoam; startTime 0;\n"
               f"libs {LIBRARY};\n" + "".join(f"{name} {value};\n" for name, value in control.items()))
    dictionary(case, "system/fvSchemes", SCHEMES)
    dictionary(case, "system/fvSolution", SOLUTION)
    dictionary(case, "system/setFieldsDict", f"defaultFieldValues (); regions ({regions});")
    dictionary(case, "system/blockMeshDict", "vertices ((0 0 0)(1 0 0)(1 1 0)(0 1 0)(0 0 1)(1 0 1)(1 1 1)(0 1 1));\n"
               f"blocks (hex (0 1 2 3 4 5 6 7) ({cells[0]} {cells[1]} 1) simpleGrading (1 1 1));\n"
               "patches (wall walls ((0 4 7 3)(2 6 5 1)(3 7 6 2)(1 5 4 0)) empty sides ((0 3 2 1)(4 5 6 7)));")
    dictionary(case, "constant/g", f"dimensions [0 1 -2 0 0 0 0]; value (0 {-g} 0);", "uniformDimensionedVectorField")
    dictionary(case, "constant/turbulenceProperties", "simulationType laminar;")
    dictionary(case, "constant/thermophysicalProperties", "phases (liquid gas); pMin 1000; sigma { type titanFluid; fluid Kraken; }")
    package = "thermoType {{ type heRhoThermo; mixture pureMixture; transport const; thermo {}; equationOfState {}; specie specie; energy {}; }}\n"
    dictionary(case, "constant/thermophysicalProperties.liquid", package.format(thermo, law, energy) +
               f"mixture {{ specie {{ molWeight 25; }} equationOfState {{ {coefficients} }}"
               f" thermodynamics {{ {'Cv' if thermo == 'eConst' else 'Cp'} 2500; Hf 0; }} transport {{ mu 1e-3; Pr 10; }} }}")
    dictionary(case, "constant/thermophysicalProperties.gas", package.format("hConst", "perfectGas", energy) +
               "mixture { specie { molWeight 28; } thermodynamics { Cp 1040; Hf 0; } transport { mu 6e-6; Pr 0.7; } }")
    for name, dimensions, value, condition in (
            ("p", "[1 -1 -2 0 0 0 0]", AMBIENT, f"calculated; value uniform {AMBIENT}"), ("p_rgh", "[1 -1 -2 0 0 0 0]", AMBIENT, "fixedFluxPressure"),
            ("T", "[0 0 0 1 0 0 0]", 94, "zeroGradient"), ("alpha.liquid", "[0 0 0 0 0 0 0]", 1, "zeroGradient")):
        dictionary(case, f"0/{name}", f"dimensions {dimensions}; internalField uniform {value};\n"
                   f"boundaryField {{ walls {{ type {condition}; }} sides {{ type empty; }} }}", "volScalarField")
    dictionary(case, "0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);\n"
               "boundaryField { walls { type slip; } sides { type empty; } }", "volVectorField")
    foam("blockMesh", case=case)
    foam("setFields", case=case)
    return case


def region(source: str, where: str, **values: float) -> str:
    """A region of setFields."""
    return f"{source} {{ {where} fieldValues ({' '.join(f'volScalarFieldValue {name} {value}' for name, value in values.items())}); }}"


def front(case: Path, time: str, level: float) -> float:
    """Where, from the left, the pressure falls below a level last."""
    p = scalars(case / time / "p")
    i = np.nonzero((p[:-1] >= level) & (p[1:] < level))[0][-1]
    return (i + 0.5 + (p[i] - level)/(p[i] - p[i + 1]))/len(p)


@pytest.mark.parametrize("law, coefficients, energy, thermo", [
    ("Murnaghan", "fluid Kraken;", "sensibleInternalEnergy", "hConst"),
    ("Tait", f"{LAKE} along isothermal;", "sensibleEnthalpy", "eConst"),
    ("Murnaghan", "p0 1.467e5; rho0 664; stiffness MachNumber; U 25; Ma 0.1;", "sensibleEnthalpy", "hConst"),
    ("Tait", "fluid Kraken; stiffness waveTank; g 1.35; H 20; gamma 7;", "sensibleInternalEnergy", "eConst"),
], ids=["Murnaghan-fluid", "Tait-isothermal", "Murnaghan-MachNumber", "Tait-waveTank"])
def test_soundSpeed(law: str, coefficients: str, energy: str, thermo: str, tmp_path: Path) -> None:
    """A weak pressure step in a tube: two waves part with the speed of sound of the law, which is that of its choice."""
    # From the first run, a single step, the speed; then fronts that travel 0.4 m
    step = region("boxToCell", "box (-1 -1 -1) (0.5 2 2);", p=AMBIENT + 100, p_rgh=AMBIENT + 100)
    case = compressibleCase(tmp_path / "tube", (100, 1), step, law, coefficients, energy, thermo,
                            deltaT=1e-9, endTime=1e-9, writeInterval=1)
    output = foam("compressibleInterFoam", case=case, log="log.solver")
    c0 = float(re.search(r"Speed of sound at p0: (\S+) m/s", output).group(1))
    expected = {"MachNumber": 25/0.1, "waveTank": 10*np.sqrt(1.35*20)}
    for choice, speed in expected.items():
        assert choice not in coefficients or c0 == pytest.approx(speed, rel=1e-5)
    if "stiffness" not in coefficients:
        ofFluid = float(re.search(r"Reference: .*soundSpeed (\S+) ", output).group(1))
        assert (c0 < 0.9*ofFluid) if "isothermal" in coefficients else c0 == pytest.approx(ofFluid, rel=1e-5)

    nSteps = 200
    case = compressibleCase(tmp_path / "fronts", (100, 1), step, law, coefficients, energy, thermo,
                            deltaT=0.4/c0/nSteps, endTime=0.4/c0, writeInterval=nSteps//4)
    foam("compressibleInterFoam", case=case, log="log.solver")
    times = compare.times(case)
    assert len(times) == 4
    parted = [front(case, time, AMBIENT + 25) - front(case, time, AMBIENT + 75) for time in times]
    assert np.polyfit([float(time) for time in times], parted, 1)[0]/2 == pytest.approx(c0, rel=0.01)


def test_depthCharge(tmp_path: Path) -> None:
    """A bubble of ten bars in a real lake, as in the tutorial depthCharge2D: the liquid is pushed away, compressed by what p says."""
    bubble = region("cylinderToCell", "p1 (0.5 0.4 -1); p2 (0.5 0.4 2); radius 0.1;",
                    **{"alpha.liquid": 0, "p": 10*AMBIENT, "p_rgh": 10*AMBIENT, "T": 120})
    air = region("boxToCell", "box (-1 0.8 -1) (2 2 2);", **{"alpha.liquid": 0})
    case = compressibleCase(tmp_path / "depthCharge", (40, 40), bubble + air, "Murnaghan", "fluid Kraken;", g=1.35,
                            adjustTimeStep="yes", deltaT=1e-6, endTime=0.004, writeControl="adjustable", writeInterval=0.004)
    output = foam("compressibleInterFoam", case=case, log="log.solver")
    assert re.search(r"^End$", output, re.MULTILINE) and len(steps(output)) > 20
    time = compare.times(case)[-1]
    speed = np.linalg.norm(compare.readCells(case / time / "U"), axis=1)
    assert 1 < speed.max() < 300
    alpha, rho, p = (scalars(case / time / name) for name in ("alpha.liquid", "rho", "p"))
    assert np.isfinite(p).all() and p.max() > 1.2*AMBIENT
    liquid = alpha > 0.9999
    k0, gamma, rho0 = (float(re.search(rf"\b{name} (\S+);", output).group(1)) for name in ("k0", "gamma", "rho0"))
    np.testing.assert_allclose(rho[liquid], rho0*(1 + (p[liquid] - AMBIENT)/k0)**(1/gamma), rtol=2e-4)


# --- A stratified lake -----------------------------------------------------------

LEVEL = 0.3

STRATIFICATION = f"""
stratification
{{
    surfaceLevel {LEVEL}; p 1.467e5;
    layers
    {{
        surface {{ depth 0; T 93; composition {{ CH4 7; C2H6 3; saturated true; }} }}
        middle  {{ depth 0.15; T 92.5; composition {{ CH4 6; C2H6 4; saturated true; }} }}
        floor   {{ depth 0.3; T 92; composition {{ CH4 5; C2H6 5; saturated true; }} }}
    }}
}}"""


def lake(directory: Path, solver: str, *options: object) -> Path:
    """damBreak's box with a lake at rest in it."""
    case = damBreak(directory, "-application", solver, *options)
    transport(case, f"transportModel titanFluid; {STRATIFICATION}")
    dictionary(case, "constant/fvOptions", "lakeStratification { type lakeStratification; phase water; }")
    dictionary(case, "system/setFieldsDict", "defaultFieldValues (volScalarFieldValue alpha.water 0); regions (" +
               region("boxToCell", f"box (-1 -1 -1) (1 {LEVEL} 1);", **{"alpha.water": 1}) + ");")
    # On walls the pressure has to follow the force
    pressure = (case / "0/p_rgh").read_text()
    (case / "0/p_rgh").write_text(pressure.replace("fixedFluxPressure", "fixedFluxExtrapolatedPressure"))
    foam("setFields", case=case)
    foam("postProcess", "-func", "writeCellCentres", case=case)
    return case


@pytest.mark.parametrize("solver", ["interFoam", "plungeFoam"])
def test_stratifiedLake(solver: str, tmp_path: Path) -> None:
    """At rest: the pressure is that of the column above, the viscosity that of the depth, and the lake stays at rest."""
    case = lake(tmp_path / "lake", solver, "-endTime", 0.02, "-deltaT", 0.001, "-writeInterval", 0.02)
    setEntry(case, "system/controlDict", "functions",
             "{ nu { type writeObjects; libs (utilityFunctionObjects); objects (nu1); writeControl writeTime; } }")
    output = foam(solver, case=case, log="log.solver")
    layers = re.findall(r"^    (\S+) m: .*density (\S+) kg/m3, viscosity (\S+) Pa s$", output, re.MULTILINE)[:3]
    depths, densities, viscosities = np.array(layers, dtype=float).T
    assert (np.diff(densities) > 5).all() and (np.diff(viscosities) > 0).all()

    depth = LEVEL - scalars(case / "0/Cy")
    liquid = scalars(case / "0/alpha.water") == 1
    nu = scalars(case / "0.02/nu1")
    np.testing.assert_allclose(nu[liquid], np.interp(depth[liquid], depths, viscosities)/densities[0], rtol=0.01)
    assert (nu[~liquid] == nu[~liquid][0]).all()

    # p_rgh has the weight of the surface's density taken out; densities between the layers are all but linear
    fine = np.linspace(0, LEVEL, 301)
    excess = np.interp(fine, depths, densities) - densities[0]
    column = 9.81*np.concatenate(([0], np.cumsum(0.5*(excess[1:] + excess[:-1])*np.diff(fine))))
    p = scalars(case / "0.02/p_rgh")[liquid]
    top = np.argmin(depth[liquid])
    expected = np.interp(depth[liquid], fine, column)
    assert expected.max() > 10 and "fixedFluxExtrapolatedPressure" not in output
    np.testing.assert_allclose(p - p[top], expected - expected[top], atol=0.01*expected.max())
    speed = np.linalg.norm(compare.readCells(case / "0.02/U"), axis=1)[liquid]
    assert speed.max() < 0.001


def test_stratifiedLakeBetweenWalls(tmp_path: Path) -> None:
    """Where the pressure does not follow the force at walls, the log says so."""
    case = lake(tmp_path / "lake", "interFoam", "-endTime", 0.001, "-deltaT", 0.001)
    (case / "0/p_rgh").write_text((case / "0/p_rgh").read_text().replace("fixedFluxExtrapolatedPressure", "fixedFluxPressure"))
    output = foam("interFoam", case=case, log="log.solver")
    assert re.search(r"Warning.*leftWall.*lowerWall.*fixedFluxExtrapolatedPressure", output, re.DOTALL)


STRATIFICATION_MISTAKES = {
    "unstable": (("CH4 5; C2H6 5;", "CH4 9; C2H6 1;"), ("layers", "unstable", "density")),
    "shallower than the mesh": (("depth 0.3;", "depth 0.2;"), ("layers", "0.2", "as deep as the mesh")),
    "order": (("depth 0.15;", "depth 0.5;"), ("layers", "depth of layer 3")),
    "no surface": (("depth 0;", "depth 0.1;"), ("layers", "first layer")),
    "misspelt": (("surfaceLevel", "surfaceHeight"), ("stratification", "surfaceHeight", "surfaceLevel")),
    "fluid as well": (("stratification\n", "fluid Kraken; stratification\n"), ("water", "fluid", "stratification")),
    "temperature field as well": (("stratification\n", "evaluation direct; stratification\n"), ("water", "evaluation", "stratified")),
}


@pytest.mark.parametrize("name", STRATIFICATION_MISTAKES)
def test_badStratification(name: str, restingCase: Path) -> None:
    replaced, named = STRATIFICATION_MISTAKES[name]
    assert replaced[0] in STRATIFICATION
    case = copy(restingCase, re.sub(r"\W+", "_", name))
    transport(case, f"transportModel titanFluid; {STRATIFICATION.replace(*replaced)}")
    checkRefused("interFoam", case, ("transportProperties.water", *named))


# --- Bad input ------------------------------------------------------------------

MISTAKES = {
    "unknown lake": ("fluid Krakn;", ("transportProperties.water", "fluid", "Krakn", "Kraken", "Ligeia")),
    "not a number": ("fluid Kraken; T nan;", ("transportProperties.water", "T", "nan")),
    "too warm": ("fluid Kraken; T 300;", ("transportProperties.water", "T", "300")),
    "negative pressure": ("fluid Kraken; p -1e5;", ("transportProperties.water", "p", "-100000")),
    "negative fraction": ("composition {N2 -0.1; CH4 0.4; C2H6 0.7;} T 94; p 1.467e5; phase liquid;",
                          ("transportProperties.water", "composition", "-0.1")),
    "negative amount": ("composition {CH4 -3; C2H6 7; saturated true;} T 94; p 1.467e5;",
                        ("transportProperties.water", "composition", "-3")),
    "wrong sum": ("composition {N2 0.1; CH4 0.3; C2H6 0.7;} T 94; p 1.467e5; phase liquid;",
                  ("transportProperties.water", "composition", "1.1")),
    "unknown species": ("composition {N2 0.1; CH4 0.3; C2H6 0.6; H2 0.1;} T 94; p 1.467e5; phase liquid;",
                        ("composition", "H2", "C3H8")),
    "unknown phase": ("composition {CH4 0.3; C2H6 0.7;} T 94; p 1.467e5; phase solid;",
                      ("transportProperties.water", "phase", "solid", "liquid or gas")),
    "nitrogen twice": ("composition {N2 0.1; CH4 3; C2H6 7; saturated true;} T 94; p 1.467e5;", ("composition", "N2", "saturated")),
    "neither": ("T 94;", ("transportProperties.water", "fluid", "composition", "Kraken")),
    "no temperature": ("composition {CH4 3; C2H6 7; saturated true;} p 1.467e5;", ("transportProperties.water", "T")),
    "gas that is a lake": ("fluid Kraken; phase gas;", ("transportProperties.water", "phase", "gas", "liquid")),
    "constants elsewhere": ("fluid astraeusPaper; T 80;", ("transportProperties.water", "astraeusPaper", "80")),
    "another density": ("fluid Kraken; rho 1000;", ("transportProperties.water", "rho", "1000", "Kraken")),
    "another viscosity": ("fluid Kraken; nu 1;", ("transportProperties.water", "nu", "Kraken")),
    "unknown entry": ("fluid Kraken; temperature 93;", ("transportProperties.water", "temperature", "Expected")),
    "unknown evaluation": ("fluid Kraken; evaluation fast;", ("transportProperties.water", "fast", "tabulated")),
}


@pytest.fixture(scope="module")
def restingCase(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """damBreak for one time step."""
    return damBreak(tmp_path_factory.mktemp("titanModels") / "damBreak", "-application", "interFoam", "-endTime", 0.001, "-deltaT", 0.001)


@pytest.mark.parametrize("name", MISTAKES)
def test_badInput(name: str, restingCase: Path) -> None:
    entries, named = MISTAKES[name]
    case = copy(restingCase, re.sub(r"\W+", "_", name))
    transport(case, f"transportModel titanFluid; {entries}")
    checkRefused("interFoam", case, named)


@pytest.mark.parametrize("sigma, named", [
    ("{ type titanFluid; fluid titanAir; }", ("transportProperties.sigma", "surfaceTension", "titanAir", "gas")),
    ("{ type titanFluid; fluid Kraken; sigma 0.07; }", ("transportProperties.sigma", "sigma", "Expected")),
])
def test_badSurfaceTension(sigma: str, named: Tuple[str, ...], restingCase: Path) -> None:
    case = copy(restingCase, re.sub(r"\W+", "_", sigma))
    transport(case, sigma=sigma)
    checkRefused("interFoam", case, named)


def test_noTemperature(restingCase: Path) -> None:
    """A fluid that is to follow a temperature that nobody solves for is refused in the first time step."""
    case = copy(restingCase, "noTemperature")
    transport(case, "transportModel titanFluid; fluid Kraken; evaluation direct;")
    output = run("interFoam", case=case, log="log.solver").stdout
    assert "FOAM FATAL IO ERROR" in output and "there is no temperature field T" in output and len(steps(output)) == 1


LAWS = {
    "no reference": ("Murnaghan", "stiffness given; k0 1e4; gamma 7;", ("equationOfState", "p0")),
    "two references": ("Murnaghan", "fluid Kraken; rho0 664;", ("equationOfState", "rho0", "fluid")),
    "negative gamma": ("Murnaghan", "fluid Kraken; gamma -7;", ("equationOfState", "gamma", "-7", "positive")),
    "Mach number of zero": ("Tait", "fluid Kraken; stiffness MachNumber; U 25; Ma 0;", ("equationOfState", "Ma", "positive")),
    "depth of zero": ("Murnaghan", "fluid Kraken; stiffness waveTank; g 1.35; H 0;", ("equationOfState", "H", "positive")),
    "fluid that is not there": ("Tait", "p0 1e5; rho0 664; stiffness fluid;", ("equationOfState", "stiffness", "fluid")),
    "unknown stiffness": ("Tait", "fluid Kraken; stiffness soft;", ("equationOfState", "soft", "waveTank")),
    "entry of another choice": ("Murnaghan", "fluid Kraken; Ma 0.1;", ("equationOfState", "Ma", "Expected")),
    "entry of another law": ("Tait", "p0 1e5; rho0 664; stiffness given; k0 1e4; gamma 7;", ("equationOfState", "k0")),
    "in tension": ("Murnaghan", "p0 1e6; rho0 664; stiffness given; k0 1e4; gamma 7;", ("pressure", "146700", "990000", "pMin")),
}


@pytest.mark.parametrize("name", LAWS)
def test_badLaw(name: str, tmp_path: Path) -> None:
    law, coefficients, named = LAWS[name]
    case = compressibleCase(tmp_path / "tube", (4, 1), region("boxToCell", "box (-1 -1 -1) (0.5 2 2);", p=AMBIENT), law, coefficients,
                            deltaT=1e-6, endTime=1e-6, writeInterval=1)
    checkRefused("compressibleInterFoam", case, named)
