#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies on which nothing but their weight acts, with the integrator addedMass and those of OpenFOAM: result.csv.

Tops without torque against reference/*.csv: the largest difference of the angular velocity in body axes, over its largest value,
and of the orientation's nine numbers, over the whole table; the time step is that of a dive. The asymmetric top spins about its axis
of the middle moment of inertia, which is unstable. A body that is thrown against g t^2/2 and its velocity.
"""
import subprocess
import tempfile
from pathlib import Path
from typing import List

import numpy as np

from plunge.studies.resultTable import Row, limit, show, write

FOLDER = Path(__file__).resolve().parent
INTEGRATORS = {"addedMass": "type addedMass; addedMass (0 0 0); addedInertia (0 0 0);", "symplectic": "type symplectic;",
               "Newmark": "type Newmark;", "CrankNicolson": "type CrankNicolson;"}
STEP = 1e-4         # [s], of a dive
MOST = 1e-8
TOPS = {"asymmetricTop": (1, 2, 3), "symmetricTop": (1, 1, 0.1)}


def fly(integrator: str, entries: str, interval: float, end: float, step: float = STEP) -> np.ndarray:
    """The rows that program/freeFlight prints."""
    with tempfile.NamedTemporaryFile("w") as file:
        file.write(f"mass 2; centreOfMass (0 0 0); solver {{ {INTEGRATORS[integrator]} }} {entries}\n")
        file.flush()
        output = subprocess.run(["freeFlight", file.name, str(step), str(interval), str(end)], check=True, stdout=subprocess.PIPE,
                                text=True).stdout
    return np.array([line.split() for line in output.splitlines() if line[:1].isdigit()], dtype=float)


def rotation(q: np.ndarray) -> np.ndarray:
    """Matrices, row by row, of quaternions with the scalar first."""
    w, x, y, z = q.T
    return np.stack([1 - 2*(y*y + z*z), 2*(x*y - w*z), 2*(x*z + w*y), 2*(x*y + w*z), 1 - 2*(x*x + z*z), 2*(y*z - w*x),
                     2*(x*z - w*y), 2*(y*z + w*x), 1 - 2*(x*x + y*y)], axis=1)


def top(name: str, integrator: str) -> List[Row]:
    exact = np.genfromtxt(FOLDER / f"reference/{name}.csv", delimiter=",", skip_header=1, names=True)
    omega = np.stack([exact[f"w{c}_body"] for c in "xyz"], axis=1)
    inertia = TOPS[name]
    momentum = " ".join(f"{i*w:.17g}" for i, w in zip(inertia, omega[0]))
    path = fly(integrator, f"momentOfInertia ({' '.join(map(str, inertia))}); angularMomentum ({momentum});", exact["t"][1],
               exact["t"][-1])
    what = f"{integrator}, {name}, {exact['t'][-1]:g} s: "
    figures = {"angular velocity, over its largest value": float(np.abs(path[:, 1:4] - omega).max()/np.abs(omega).max())}
    if "q0" in exact.dtype.names:
        q = np.stack([exact[f"q{i}"] for i in range(4)], axis=1)
        figures["orientation"] = float(np.abs(path[:, 4:13] - rotation(q)).max())
    figures["kinetic energy, change"] = float(np.abs(path[:, 16]).max())
    figures["angular momentum, change"] = float(path[:, 17].max())
    return [limit(what + key, value, "1", MOST) if integrator == "addedMass" else Row(what + key, value, "1")
            for key, value in figures.items()]


def thrown(integrator: str) -> Row:
    gravity, velocity, end = np.array([0, 0, -9.81]), np.array([3.0, -1, 2]), 1.0
    path = fly(integrator, f"momentOfInertia (1 1 1); velocity ({' '.join(map(str, velocity))}); g ({' '.join(map(str, gravity))});",
               0.1, end, 0.01)
    t = path[:, :1]
    value = float(np.abs(path[:, 13:16] - (velocity*t + 0.5*gravity*t*t)).max()/np.linalg.norm(0.5*gravity))
    what = f"{integrator}, thrown, time step 0.01 s: position after 1 s, over g t^2/2"
    return limit(what, value, "1", MOST) if integrator == "addedMass" else Row(what, value, "1")


def main() -> None:
    rows = [row for integrator in INTEGRATORS for name in TOPS for row in top(name, integrator)]
    rows += [thrown(integrator) for integrator in INTEGRATORS]
    write(FOLDER / "result.csv", rows)
    show(rows)


if __name__ == "__main__":
    main()
