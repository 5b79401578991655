#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""plungeSPH against exact solutions, each at two spacings: vortices of Taylor and Green, a drop that is drawn out (Monaghan, J.
Comput. Phys. 110 (1994) 399), a standing wave. They start from states that this script writes, since a dictionary has no fields.
"""
from pathlib import Path
from typing import Dict, List, Tuple

import numpy as np
from scipy.integrate import solve_ivp

from plunge.results import cpu_seconds
from plunge.studies import particleRuns
from plunge.studies.resultTable import Row, judge, show, write

FOLDER = Path(__file__).resolve().parent
RHO, GRAVITY = 1000, 9.81


def density(p: np.ndarray, c0: float) -> np.ndarray:
    """Above that of no pressure, by Murnaghan's equation with gamma 7 [kg/m3]."""
    return RHO*np.expm1(np.log1p(7*p/(RHO*c0**2))/7)


def lattice(low: Tuple[float, float], n: Tuple[int, int], spacing: float) -> np.ndarray:
    """Middles of the cells of a block."""
    i, j = np.meshgrid(np.arange(n[0]) + 0.5, np.arange(n[1]) + 0.5, indexing="ij")
    return np.array(low) + spacing*np.stack([i.ravel(), j.ravel()], axis=1)


def solve(name: str, spacing: float, c0: float, fluid: np.ndarray, velocity: np.ndarray, excess: np.ndarray,
          entries: Dict[str, object], endTime: float, interval: float, gravity: float = 0, floor: np.ndarray = np.empty((0, 2))) -> Path:
    """Runs from particles of fluid and of a floor, with neither artificial viscosity nor density diffusion."""
    x = np.concatenate([fluid, floor])
    still = np.zeros((len(floor), 2))
    mass = np.concatenate([RHO + excess, np.full(len(floor), RHO)])*spacing**2
    wall = np.concatenate([np.full(len(fluid), -1), np.zeros(len(floor))]).astype("<i4")
    run = particleRuns.setUp("stillTank", FOLDER / "run" / name,
                             {"geometry/spacing": spacing, "speedOfSound": f"{{ c0 {c0}; }}", "smoothingLength": 2,
                              "viscosity": "none", "densityDiffusion": "none", **entries},
                             endTime=endTime, writeInterval=interval)
    particleRuns.setEntry(run, "constant/g", "value", f"(0 {-gravity} 0)")
    properties = run / particleRuns.PROPERTIES
    unused = ["alpha"] if "delta" in entries else ["alpha", "delta"]
    properties.write_text("".join(line for line in properties.read_text().splitlines(True)
                                  if not line.split() or line.split()[0] not in unused))
    header = f"\ndimensions 2\nparticles {len(x)}\nenergies 0\nbodies 0\nfelt 0\nspacing {spacing!r}\nrho0 {RHO}\ntime 0\n\n"
    (run / "0").mkdir()
    with (run / "0/particles").open("wb") as file:
        file.write(b"plungeSPH particles" + header.encode())
        for array in (x, np.concatenate([velocity, still]), np.zeros_like(x), np.concatenate([excess, np.zeros(len(floor))]),
                      mass, np.zeros(len(x))):
            file.write(array.astype("<f8").tobytes())
        file.write(wall.tobytes())
    particleRuns.solve(run, "-threads", 1)
    return run


def planes(low: Tuple[float, float], high: Tuple[float, float], axes: str) -> str:
    """Of symmetry, on both sides."""
    text = ""
    for axis in axes:
        d = "xy".index(axis)
        for at, side in ((low[d], 1), (high[d], -1)):
            point, normal = [0.0, 0.0, 0.0], [0, 0, 0]
            point[d], normal[d] = at, side
            text += "{ point (%g %g %g); normal (%g %g %g); } " % (*point, *normal)
    return f"({text})"


def TaylorGreen(n: int, ratio: float, Re: float) -> Tuple[float, float]:
    """Decay of the kinetic energy of u = sin(pi x) cos(pi y), v = -cos(pi x) sin(pi y), over 4 pi^2 nu; CPU seconds."""
    c0, spacing, rate = 15, 1/n, 4*np.pi**2/Re
    x = lattice((0, 0), (n, n), spacing)
    X, Y = np.pi*x.T
    velocity = np.stack([np.sin(X)*np.cos(Y), -np.cos(X)*np.sin(Y)], axis=1)
    # The box is closed: what is added to the pressure stays, and nothing is under tension
    excess = density(RHO*(1 + 0.25*(np.cos(2*X) + np.cos(2*Y))), c0)
    run = solve(f"TaylorGreen_{n}_{ratio:g}_{Re:g}", spacing, c0, x, velocity, excess,
                {"smoothingLength": ratio, "viscosity": "laminar", "liquid/mu": RHO/Re, "densityDiffusion": "Molteni", "delta": 0.1,
                 "symmetry": planes((0, 0), (1, 1), "xy"), "outputs": f"{{ interval {0.02/rate}; }}"}, 1.5/rate, 1.5/rate)
    energy = particleRuns.table(run, "energy")
    return -np.polyfit(energy["time_s"], np.log(energy["kinetic_J"]), 1)[0]/rate, cpu_seconds(run)


def drop(n: int) -> Tuple[float, float, float, float]:
    """Semi-axes of a disc with the velocity (-x, y) at t = 0.8, over the exact ones; change of the energy; CPU seconds."""
    end, spacing = 0.8, 1/n
    x = lattice((-1, -1), (2*n, 2*n), spacing)
    x = x[np.hypot(*x.T) < 1]
    run = solve(f"drop_{n}", spacing, 14, x, x*[-1, 1], np.zeros(len(x)), {"outputs": "{ interval 0.1; }"}, end, end)
    last = particleRuns.particles(particleRuns.series(run)[-1][1])
    x = last["x"][last["wall"] < 0]
    # a' = -s a, s' = s^2 (a^4 - 1)/(a^4 + 1), from p = p0 (1 - (x/a)^2 - (y/b)^2) and a b = 1
    exact = solve_ivp(lambda t, u: (-u[1]*u[0], u[1]**2*(u[0]**4 - 1)/(u[0]**4 + 1)), (0, end), (1, 1), rtol=1e-10).y[0, -1]
    energy = particleRuns.table(run, "energy")
    total = energy["kinetic_J"] + energy["internal_J"]
    # The lattice's own disc is not quite round
    start = lattice((-1, -1), (2*n, 2*n), spacing)
    start = start[np.hypot(*start.T) < 1]
    axes = np.sqrt((x[:, :2]**2).mean(0)/(start**2).mean(0))
    return axes[0]/exact, axes[1]*exact, np.abs(total/total[0] - 1).max(), cpu_seconds(run)


def wave(n: int, nu: float) -> Tuple[float, float, float, float]:
    """Frequency over the exact one, decay [1/s], gain of energy over the wave's, CPU seconds: of the lowest wave in 1 m by 0.5 m."""
    depth, speed, c0 = 0.5, 0.2, 22
    spacing = depth/n
    exact = np.sqrt(GRAVITY*np.pi*np.tanh(np.pi*depth))

    def mode(x: np.ndarray) -> np.ndarray:
        return np.stack([-np.sin(np.pi*x[:, 0])*np.cosh(np.pi*x[:, 1]), np.cos(np.pi*x[:, 0])*np.sinh(np.pi*x[:, 1])],
                        axis=1)/np.sinh(np.pi*depth)

    x = lattice((0, 0), (2*n, n), spacing)
    entries: Dict[str, object] = {"symmetry": planes((0, 0), (1, 1), "x"), "outputs": "{ interval 0.02; }"}
    if nu:
        entries.update({"viscosity": "laminar", "liquid/mu": RHO*nu})
    run = solve(f"wave_{n}_{nu:g}", spacing, c0, x, speed*mode(x), density(RHO*GRAVITY*(depth - x[:, 1]), c0), entries,
                4.25*2*np.pi/exact, 0.04*2*np.pi/exact, GRAVITY, lattice((0, -5*spacing), (2*n, 5), spacing))
    times, shares = [], []
    for time, file in particleRuns.series(run):
        now = particleRuns.particles(file)
        fluid = now["wall"] < 0
        own = mode(now["x"][fluid, :2])
        times.append(time)
        shares.append((own*now["U"][fluid, :2]).sum()/(own**2).sum()/speed)
    t, share = np.array(times), np.array(shares)
    crossing = np.nonzero(share[:-1]*share[1:] <= 0)[0]
    zeros = t[crossing] + (t[crossing + 1] - t[crossing])*share[crossing]/(share[crossing] - share[crossing + 1])
    peaks = [np.abs(share[a:b]).max() for a, b in zip(crossing[:-1] + 1, crossing[1:] + 1)]
    energy = particleRuns.table(run, "energy")
    total = energy["kinetic_J"] + energy["potential_J"] + energy["internal_J"]
    return (np.pi/np.polyfit(range(len(zeros)), zeros, 1)[0]/exact, -np.polyfit(0.5*(zeros[1:] + zeros[:-1]), np.log(peaks), 1)[0],
            (total.max() - total[0])/energy["kinetic_J"][0], cpu_seconds(run))


def main() -> None:
    rows: List[Row] = []
    for Re, ratio in ((10, 2), (100, 2), (100, 3)):
        for n in (20, 40):
            value, cpu = TaylorGreen(n, ratio, Re)
            rows.append(judge(f"Taylor-Green, Re {Re}, {n} particles along a side, h/spacing {ratio}: decay of the energy over"
                              " 4 pi^2 nu", value, "-", 1, 0.05, cpu))
    for n in (20, 40):
        a, b, gain, cpu = drop(n)
        rows += [judge(f"drop, {n} particles along its radius: {which} semi-axis at t = 0.8 over the exact one", value, "-", 1, 0.02, cpu)
                 for which, value in (("shorter", a), ("longer", b))]
        rows.append(judge(f"drop, {n} particles along its radius: change of the energy over the energy", gain, "-", 0, 1e-4, cpu))
    for n in (10, 20):
        frequency, _, gain, cpu = wave(n, 0)
        rows.append(judge(f"standing wave without viscosity, {n} particles deep: frequency over sqrt(g k tanh(k d))", frequency, "-",
                          1, 0.02, cpu))
        rows.append(judge(f"standing wave without viscosity, {n} particles deep: largest gain of energy over the wave's", gain, "-",
                          0, 0.05, cpu))
    for n in (10, 20):
        nu = 0.01
        frequency, decay, _, cpu = wave(n, nu)
        rows.append(judge(f"standing wave, viscous, {n} particles deep: decay over 2 nu k^2", decay/(2*nu*np.pi**2), "-", 1, 0.1, cpu))
    write(FOLDER / "result.csv", rows)
    show(rows)


if __name__ == "__main__":
    main()
