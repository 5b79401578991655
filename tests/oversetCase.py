# SPDX-License-Identifier: GPL-3.0-or-later
"""Small overset cases: boxes that move in a background of boxes, in a plane across any axis, in a wedge about the x axis, or in space."""
from itertools import product
from math import radians, tan
from pathlib import Path
from typing import Dict, List, Sequence, Tuple

import numpy as np

from tutorials import foam

# Axes of a case are along, up and across. Along, up and across of a plane is an order of x, y and z that keeps their handedness.
PLANES = {"z": (0, 1, 2), "x": (1, 2, 0), "y": (2, 0, 1)}   # by the empty direction
HALF_WEDGE = tan(radians(2.5))

TRAJECTORY = "plungeTrajectory { type plungeTrajectory; libs (plungeFunctionObjects); surfaceLevel 0; }"
HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"


class Axes:
    """From (along, up, across) to x, y, z; across: the empty direction of a plane, `wedge`, or `space`."""

    def __init__(self, across: str = "y"):
        self.across = across
        self.order = PLANES.get(across, PLANES["z"] if across == "wedge" else PLANES["y"])
        self.sides = {"wedge": "wedge", "space": "patch"}.get(across, "empty")

    def place(self, values: Sequence[float]) -> str:
        xyz = [0.0, 0.0, 0.0]
        for axis, value in zip(self.order, values):
            xyz[axis] = float(value)
        return f"({xyz[0]:.12g} {xyz[1]:.12g} {xyz[2]:.12g})"


def lines(low: float, high: float, step: float) -> np.ndarray:
    return np.linspace(low, high, max(1, round((high - low)/step)) + 1)


def blockMesh(axes: Axes, along: Sequence[float], up: Sequence[float], across: Sequence[float], spacing: float, hollow: bool,
              outer: Dict[str, Sequence[int]], inner: str, depthCells: int) -> str:
    """A blockMeshDict of the boxes between lines; hollow: without the one in the middle. outer: patches of the sides, 0 to 5 in the
    order -along +along -up +up -across +across; inner: the patch of the hole."""
    index: Dict[Tuple[float, ...], int] = {}

    def vertex(i: int, j: int, k: int) -> int:
        p = (along[i], up[j], up[j]*HALF_WEDGE*(2*k - 1) if axes.across == "wedge" else across[k])
        return index.setdefault(tuple(float(v) + 0.0 for v in p), len(index))

    sides = {name: [] for name in (*outer, inner)}  # type: Dict[str, List[str]]
    of = {side: name for name, numbers in outer.items() for side in numbers}
    n = (len(along) - 1, len(up) - 1, len(across) - 1)
    hole = (n[0]//2, 0 if axes.across == "wedge" else n[1]//2, n[2]//2) if hollow else None
    blocks = []
    for place in product(*map(range, n)):
        if place == hole:
            continue
        corners = [vertex(*(np.array(place) + d)) for d in
                   ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
        counts = [max(1, round((line[p + 1] - line[p])/spacing)) for line, p in zip((along, up), place)]
        counts.append(depthCells if axes.sides != "patch" else max(1, round((across[place[2] + 1] - across[place[2]])/spacing)))
        blocks.append(f"hex ({' '.join(map(str, corners))}) ({' '.join(map(str, counts))}) simpleGrading (1 1 1)")
        faces = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
        for side, face in enumerate(faces):
            next_ = list(place)
            next_[side//2] += 1 if side % 2 else -1
            name = inner if tuple(next_) == hole else of[side] if not 0 <= next_[side//2] < n[side//2] else None
            if name:
                sides[name].append("(" + " ".join(str(corners[c]) for c in face) + ")")
    points = [""]*len(index)
    for p, number in index.items():
        points[number] = axes.place(p)
    kinds = {"front": axes.sides, "back": axes.sides, "overset": "overset", "body": "wall", "body2": "wall", "axis": "empty",
             "walls": "wall"}
    return (HEADER.format("dictionary", "blockMeshDict") + "scale 1;\nvertices (" + " ".join(points) + ");\nblocks (" + "\n".join(blocks)
            + ");\nboundary (" + "\n".join(f"{name} {{ type {kinds.get(name, 'patch')}; faces ({' '.join(faces)}); }}"
                                           for name, faces in sides.items() if faces or name == "overset") + ");\n")


def write(case: Path, across: str = "y", background: Sequence[float] = (-1, 1, -1, 1), spacing: float = 0.1,
          bodies: Sequence[Tuple[float, float]] = ((0, 0),), size: float = 0.2, reach: float = 0.4, bodySpacing: float = 0.05,
          velocity: Tuple[float, float] = (0, 0), mass: float = 0, surface: float = 0, sides: str = "open", bodyFirst: bool = True,
          gravity: float = 9.81, deltaT: float = 0.005, endTime: float = 0.05, scene: str = "", method: str = "rigidZones",
          pimple: str = "", integrator: str = "", functions: str = "", control: str = "") -> Path:
    """The case, meshed. background: its extent along and up; bodies: centres of square ones of this size, whose meshes reach so far
    from their middles; the first moves: as given, or with its mass [kg per metre of depth]; sides: open, or closed walls."""
    axes = Axes(across)
    depth = (-0.5*spacing, 0.5*spacing)
    along0, along1, up0, up1 = background
    if across == "wedge":
        up0, gravity = 0.0, 0.0
    (case / "constant").mkdir(parents=True)
    (case / "system").mkdir()
    far = "walls" if sides == "closed" else "far"
    bottom = "axis" if across == "wedge" else far
    meshes = {"background": blockMesh(axes, (along0, along1), (up0, up1), (-1, 1) if across == "space" else depth, spacing, False,
                                      {"overset": (), far: (0, 1, 3) if across == "wedge" else (0, 1, 2, 3, *((4, 5) if across == "space" else ())),
                                       **({} if across == "space" else {"front": (4,), "back": (5,)}),
                                       **({"axis": (2,)} if across == "wedge" else {})}, "none", 1)}
    h = 0.5*size
    for number, (a, u) in enumerate(bodies):
        ring = [-reach, -h, h, reach]
        up = [0, h, reach] if across == "wedge" else [u + r for r in ring]
        meshes[f"body{number + 1}"] = blockMesh(
            axes, [a + r for r in ring], up, ring if across == "space" else depth, bodySpacing, True,
            {"overset": (0, 1, 3) if across == "wedge" else (0, 1, 2, 3, *((4, 5) if across == "space" else ())),
             **({} if across == "space" else {"front": (4,), "back": (5,)}), **({"axis": (2,)} if across == "wedge" else {})},
            "body" if number == 0 else "body2", 1)
    control_ = (HEADER.format("dictionary", "controlDict") +
                f"""application plungeFoam; libs (rigidBody plungeFunctionObjects); startFrom latestTime; startTime 0; stopAt endTime;
endTime {endTime}; deltaT {deltaT}; adjustTimeStep no; maxCo 0.5; maxAlphaCo 0.5; writeControl timeStep; writeInterval 1000;
writePrecision 17; timePrecision 8; runTimeModifiable no; {control}
functions {{ {functions} }}
""")
    schemes = HEADER.format("dictionary", "fvSchemes") + f"""
ddtSchemes {{ default Euler; }} gradSchemes {{ default Gauss linear; }}
divSchemes {{ div(rhoPhi,U) Gauss linearUpwind grad(U); div(U) Gauss linear; div(phi,alpha) Gauss vanLeer; div(phirb,alpha) Gauss linear;
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear; }}
laplacianSchemes {{ default Gauss linear corrected; }} interpolationSchemes {{ default linear; }} snGradSchemes {{ default corrected; }}
oversetInterpolation {{ method {method}; }}
oversetInterpolationSuppressed {{ grad(p_rgh); surfaceIntegrate(phiHbyA); }}
fluxRequired {{ default no; p_rgh; pcorr; alpha.water; }}
"""
    solution = HEADER.format("dictionary", "fvSolution") + f"""
solvers
{{
    "alpha.water.*" {{ nAlphaCorr 2; nAlphaSubCycles 1; cAlpha 1; icAlpha 0; MULESCorr yes; nLimiterIter 3; alphaApplyPrevCorr no;
        solver smoothSolver; smoother symGaussSeidel; tolerance 1e-12; relTol 0; }}
    "pcorr.*" {{ solver PCG; preconditioner DIC; tolerance 1e-12; relTol 0; }}
    "p_rgh.*" {{ solver PBiCGStab; preconditioner aggregationMultigrid; tolerance 1e-11; relTol 0; }}
    "U.*" {{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-12; relTol 0; }}
    cellDisplacement {{ solver PCG; preconditioner DIC; tolerance 1e-6; relTol 0; }}
}}
PIMPLE {{ momentumPredictor yes; nOuterCorrectors 1; nCorrectors 2; nNonOrthogonalCorrectors 0; ddtCorr yes; correctPhi no;
    oversetAdjustPhi no; {pimple} }}
"""
    for part in ("", *meshes):
        system = case / part / "system"
        system.mkdir(parents=True, exist_ok=True)
        (system / "controlDict").write_text(control_ if not part else HEADER.format("dictionary", "controlDict") +
                                            "application blockMesh; startTime 0; endTime 1; deltaT 1; writeInterval 1; writePrecision 17;")
        (system / "fvSchemes").write_text(schemes)
        (system / "fvSolution").write_text(solution)
    order = sorted(meshes, reverse=bodyFirst)
    counts = []
    for name in order:
        (case / name / "system/blockMeshDict").write_text(meshes[name])
        output = foam("blockMesh", "-case", case / name, case=case)
        counts.append(int(output.split("nCells:")[1].split()[0]))
    first = case / order[0]
    (first / "constant/polyMesh").rename(case / "constant/polyMesh")
    for name in order[1:]:
        foam("mergeMeshes", ".", name, "-overwrite", case=case)

    zones = [int(name[-1]) if name.startswith("body") else 0 for name in order]
    fields(case, axes, zones, counts, sides, surface, across, len(bodies) > 1)
    motion = " ".join((
        f"type {'prescribed' if not mass else 'addedMass'}; {integrator}",))
    weight = mass or 1.0
    thickness = 1 if across in ("wedge", "space") else spacing
    moments = max(1e-6, weight*thickness*size**2/6)
    bodyDict = f"""
motionSolverLibs (sixDoFRigidBodyMotion);
    body {{ motionSolver sixDoFRigidBodyMotion; sixDoFRigidBodyMotionCoeffs {{
    patches (body); innerDistance 1e3; outerDistance 1e4; rho rho; rhoInf 1;
    mass {weight*thickness:.12g}; momentOfInertia ({moments:.6g} {moments:.6g} {moments:.6g}); centreOfMass {axes.place((*bodies[0], 0))};
    velocity {axes.place((*velocity, 0))}; accelerationRelaxation 1; accelerationDamping 1; report off;
    g {axes.place((0, -gravity, 0))};
    solver {{ {motion} }}
    {'constraints { turn { sixDoFRigidBodyMotionConstraint orientation; } }' if mass else ''} }} }}
"""
    (case / "constant/dynamicMeshDict").write_text(HEADER.format("dictionary", "dynamicMeshDict") +
                                                   f"dynamicFvMesh dynamicOversetFvMesh;\nsolvers {{ {bodyDict} }}\n")
    (case / "constant/g").write_text(HEADER.format("uniformDimensionedVectorField", "g") +
                                     f"dimensions [0 1 -2 0 0 0 0]; value {axes.place((0, -gravity, 0))};")
    (case / "constant/transportProperties").write_text(
        HEADER.format("dictionary", "transportProperties") + "phases (water air); sigma 0;"
        "water { transportModel Newtonian; nu 1e-6; rho 1000; } air { transportModel Newtonian; nu 1.5e-5; rho 1; }")
    (case / "constant/turbulenceProperties").write_text(HEADER.format("dictionary", "turbulenceProperties") + "simulationType laminar;")
    (case / "constant/sceneProperties").write_text(HEADER.format("dictionary", "sceneProperties") +
                                                   f"{'gravity off;' if not gravity else ''} surfaceTension off; {scene}")
    return case


def fields(case: Path, axes: Axes, zones: Sequence[int], counts: Sequence[int], sides: str, surface: float, across: str,
           second: bool) -> None:
    zero = case / "0"
    zero.mkdir()
    ids = " ".join(" ".join([str(zone)]*n) for zone, n in zip(zones, counts))
    closed = sides == "closed"
    patches = ["overset", "walls" if closed else "far", "body", *(["body2"] if second else []),
               *([] if across == "space" else ["front", "back"]), *(["axis"] if across == "wedge" else [])]

    def field(name: str, kind: str, dimensions: str, inside: str, of: Dict[str, str]) -> None:
        default = {"overset": "type overset; value $internalField;", "front": f"type {axes.sides};", "back": f"type {axes.sides};",
                   "axis": "type empty;"}
        if name == "pointDisplacement":
            default["overset"] = "type zeroGradient;"
        boundary = "\n".join(f"{patch} {{ {default.get(patch) or of.get(patch) or of['']} }}" for patch in patches)
        (zero / name).write_text(HEADER.format(kind, name) + f"dimensions {dimensions};\ninternalField {inside};\nboundaryField {{\n{boundary}\n}}\n")

    field("zoneID", "volScalarField", "[0 0 0 0 0 0 0]", f"nonuniform List<scalar> {sum(counts)} ({ids})", {"": "type zeroGradient;"})
    field("U", "volVectorField", "[0 1 -1 0 0 0 0]", "uniform (0 0 0)",
          {"body": "type movingWallVelocity; value uniform (0 0 0);", "body2": "type movingWallVelocity; value uniform (0 0 0);",
           "walls": "type slip;", "": "type pressureInletOutletVelocity; value uniform (0 0 0);"})
    field("p_rgh", "volScalarField", "[1 -1 -2 0 0 0 0]", "uniform 0",
          {"far": "type fixedValue; value uniform 0;", "": "type fixedFluxPressure; value uniform 0;"})
    field("pointDisplacement", "pointVectorField", "[0 1 0 0 0 0 0]", "uniform (0 0 0)",
          {"far": "type fixedValue; value uniform (0 0 0);", "walls": "type fixedValue; value uniform (0 0 0);", "": "type calculated;"})
    field("alpha.water", "volScalarField", "[0 0 0 0 0 0 0]", "uniform 0",
          {"far": "type inletOutlet; inletValue uniform 0; value uniform 0;", "": "type zeroGradient;"})
    low, high = [-10.0, -10.0, -10.0], [10.0, 10.0, 10.0]
    high[axes.order[1]] = surface
    (case / "system/setFieldsDict").write_text(
        HEADER.format("dictionary", "setFieldsDict") + "defaultFieldValues (volScalarFieldValue alpha.water 0); regions (boxToCell { box "
        f"({' '.join(map(str, low))}) ({' '.join(map(str, high))}); fieldValues (volScalarFieldValue alpha.water 1); }});")
    foam("setFields", case=case, log="log.setFields")
