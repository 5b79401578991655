# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies on which nothing but their weight acts, with the integrator addedMass and those of OpenFOAM.

Tops without torque against their exact motion: the largest difference of the angular velocity in body axes, over its largest value,
and of the orientation's nine numbers; the time step is that of a dive. The asymmetric top spins about its axis of the middle moment of
inertia, which is unstable. A body that is thrown against g t^2/2 and its velocity. The tolerance is ten times the reference's round-off."""
import subprocess
from pathlib import Path

import numpy as np

from plunge.studies.references import reference
from plunge.studies.study import Done, Quantity, Run, Study

INTEGRATORS = {"addedMass": "type addedMass; addedMass (0 0 0); addedInertia (0 0 0);", "symplectic": "type symplectic;",
               "Newmark": "type Newmark;", "CrankNicolson": "type CrankNicolson;"}
TOPS = {"asymmetricTop": (1, 2, 3), "symmetricTop": (1, 1, 0.1)}
STEP = 1e-4     # [s], of a dive
GRAVITY, VELOCITY = np.array([0, 0, -9.81]), np.array([3.0, -1, 2])


def vector(values) -> str:
    return "(" + " ".join(f"{value:.17g}" for value in values) + ")"


def solve(run: Run, path: Path) -> None:
    if run.scene in TOPS:
        exact, inertia = reference("spinningTops", run.scene), TOPS[run.scene]
        spin = [i*exact[f"w{c}_body"][0] for i, c in zip(inertia, "xyz")]
        entries, times = f"momentOfInertia {vector(inertia)}; angularMomentum {vector(spin)};", (STEP, exact["t"][1], exact["t"][-1])
    else:
        entries, times = f"momentOfInertia (1 1 1); velocity {vector(VELOCITY)}; g {vector(GRAVITY)};", (0.01, 0.1, 1.0)
    path.mkdir(parents=True, exist_ok=True)
    (path / "body").write_text(f"mass 2; centreOfMass (0 0 0); solver {{ {INTEGRATORS[run.variant]} }} {entries}\n")
    output = subprocess.run(["freeFlight", path / "body", *map(str, times)], check=True, stdout=subprocess.PIPE, text=True).stdout
    np.savetxt(path / "flight", np.array([line.split() for line in output.splitlines() if line[:1].isdigit()], dtype=float))


def rotation(q: np.ndarray) -> np.ndarray:
    """Matrices, row by row, of quaternions with the scalar first."""
    w, x, y, z = q.T
    return np.stack([1 - 2*(y*y + z*z), 2*(x*y - w*z), 2*(x*z + w*y), 2*(x*y + w*z), 1 - 2*(x*x + z*z), 2*(y*z - w*x),
                     2*(x*z - w*y), 2*(y*z + w*x), 1 - 2*(x*x + y*y)], axis=1)


def figures(done: Done) -> dict:
    flight = np.loadtxt(done.path / "flight")
    if done.run.scene == "thrown":
        t = flight[:, :1]
        return {"position": float(np.abs(flight[:, 13:16] - (VELOCITY*t + 0.5*GRAVITY*t*t)).max()/np.linalg.norm(0.5*GRAVITY))}
    exact = reference("spinningTops", done.run.scene)
    omega = np.stack([exact[f"w{c}_body"] for c in "xyz"], axis=1)
    found = {"spin": float(np.abs(flight[:, 1:4] - omega).max()/np.abs(omega).max()),
             "energy": float(np.abs(flight[:, 16]).max()), "momentum": float(flight[:, 17].max())}
    if "q0" in exact.dtype.names:
        found["orientation"] = float(np.abs(flight[:, 4:13] - rotation(np.stack([exact[f"q{i}"] for i in range(4)], axis=1))).max())
    return found


study = Study(
    title="A free body keeps its spin, energy and path to round-off with the integrator addedMass",
    runs=[Run(scene, variant=integrator, resolution="0.01 s" if scene == "thrown" else f"{STEP:g} s",
              tiers=("quick", "full") if integrator == "addedMass" else ("full",))
          for integrator in INTEGRATORS for scene in (*TOPS, "thrown")],
    solve=solve, sources=("src/rigidBody", "applications/utilities/freeFlight"),
    quantities=[Quantity(name, "1", lambda done, of=of: figures(done).get(of), reference=0, tolerance=1e-8,
                         judged=lambda run: run.variant == "addedMass")
                for name, of in (("error of the angular velocity over its largest value", "spin"), ("error of the orientation", "orientation"),
                                 ("change of the kinetic energy", "energy"), ("change of the angular momentum", "momentum"),
                                 ("error of the position over g t^2/2", "position"))],
    headlines=["error of the angular velocity over its largest value"])
