# SPDX-License-Identifier: GPL-3.0-or-later
"""Flows of particles whose solution is known: vortices of Taylor and Green, a drop that is drawn out (Monaghan, J. Comput. Phys. 110
(1994) 399), a standing wave. They start from states that are written here, since a dictionary has no fields."""
from pathlib import Path
from typing import Dict, Tuple

import numpy as np
from scipy.integrate import solve_ivp

from plunge.studies import particleRuns
from plunge.studies.scenes import prepareCase

DROP_END = 0.8                  # [s]
DEPTH, WAVE_SPEED = 0.5, 0.2    # of the wave [m, m/s]
RHO, GRAVITY = 1000, 9.81
FREQUENCY = np.sqrt(GRAVITY*np.pi*np.tanh(np.pi*DEPTH))     # of the wave, exactly [rad/s]


def density(p: np.ndarray, c0: float) -> np.ndarray:
    """Above that of no pressure, by Murnaghan's equation with gamma 7 [kg/m3]."""
    return RHO*np.expm1(np.log1p(7*p/(RHO*c0**2))/7)


def lattice(low: Tuple[float, float], n: Tuple[int, int], spacing: float) -> np.ndarray:
    """Middles of the cells of a block."""
    i, j = np.meshgrid(np.arange(n[0]) + 0.5, np.arange(n[1]) + 0.5, indexing="ij")
    return np.array(low) + spacing*np.stack([i.ravel(), j.ravel()], axis=1)


def solve(run: Path, spacing: float, c0: float, fluid: np.ndarray, velocity: np.ndarray, excess: np.ndarray, entries: Dict[str, object],
          endTime: float, interval: float, gravity: float = 0, floor: np.ndarray = np.empty((0, 2))) -> None:
    """Runs from particles of fluid and of a floor, with neither artificial viscosity nor density diffusion unless entries say so."""
    x = np.concatenate([fluid, floor])
    still = np.zeros((len(floor), 2))
    mass = np.concatenate([RHO + excess, np.full(len(floor), RHO)])*spacing**2*(2*np.pi*x[:, 0] if "axisymmetric" in entries else 1)
    wall = np.concatenate([np.full(len(fluid), -1), np.zeros(len(floor))]).astype("<i4")
    given = {"smoothingLength": 2, "viscosity": "none", "densityDiffusion": "none", **entries}
    unused = "alpha" if "delta" in entries else "(alpha delta)"
    prepareCase("stillTank", run, ["-method", "particles", "-np", "1"], {
        particleRuns.PROPERTIES: f"geometry {{ spacing {spacing!r}; }}\n#remove {unused}\n#remove speedOfSound\n#remove outputs\nspeedOfSound {{ c0 {c0}; }}\n"
                                 + "\n".join(f"{key} {value}{'' if str(value).startswith('{') else ';'}" for key, value in given.items()),
        particleRuns.CONTROL: f"endTime {endTime}; writeInterval {interval};", "constant/g": f"value (0 {-gravity} 0);"})
    header = f"\ndimensions 2\nparticles {len(x)}\nenergies 0\nbodies 0\nfelt 0\nspacing {spacing!r}\nrho0 {RHO}\ntime 0\n\n"
    (run / "0").mkdir(exist_ok=True)
    with (run / "0/particles").open("wb") as file:
        file.write(b"plungeSPH particles" + header.encode())
        for array in (x, np.concatenate([velocity, still]), np.zeros_like(x), np.concatenate([excess, np.zeros(len(floor))]),
                      mass, np.zeros(len(x))):
            file.write(array.astype("<f8").tobytes())
        file.write(wall.tobytes())
    if not particleRuns.isComplete(run):
        particleRuns.call(run, "plungeSPH", mode="a")


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


def TaylorGreen(run: Path, n: int, ratio: float, Re: float) -> None:
    """u = sin(pi x) cos(pi y), v = -cos(pi x) sin(pi y) in a box of 1 m, n particles along its side."""
    c0, spacing, rate = 15, 1/n, 4*np.pi**2/Re
    x = lattice((0, 0), (n, n), spacing)
    X, Y = np.pi*x.T
    velocity = np.stack([np.sin(X)*np.cos(Y), -np.cos(X)*np.sin(Y)], axis=1)
    # The box is closed: what is added to the pressure stays, and nothing is under tension
    excess = density(RHO*(1 + 0.25*(np.cos(2*X) + np.cos(2*Y))), c0)
    solve(run, spacing, c0, x, velocity, excess,
          {"smoothingLength": ratio, "viscosity": "laminar", "liquid": f"{{ mu {RHO/Re}; }}", "densityDiffusion": "Molteni", "delta": 0.1,
           "symmetry": planes((0, 0), (1, 1), "xy"), "outputs": f"{{ interval {0.02/rate}; }}"}, 1.5/rate, 1.5/rate)


def decay(run: Path, Re: float) -> float:
    """Of the vortices' energy, over 4 pi^2 nu."""
    energy = particleRuns.table(run, "energy")
    return -float(np.polyfit(energy["time_s"], np.log(energy["kinetic_J"]), 1)[0])/(4*np.pi**2/Re)


def disc(n: int) -> np.ndarray:
    """Of radius 1 m on a lattice, n particles along the radius: it is not quite round."""
    x = lattice((-1, -1), (2*n, 2*n), 1/n)
    return x[np.hypot(*x.T) < 1]


def drop(run: Path, n: int) -> None:
    """A disc with the velocity (-x, y)."""
    x = disc(n)
    solve(run, 1/n, 14, x, x*[-1, 1], np.zeros(len(x)), {"outputs": "{ interval 0.1; }"}, DROP_END, DROP_END)


def semiAxes(run: Path, n: int) -> np.ndarray:
    """Of the disc at the end, shorter and longer, over the exact ones."""
    last = particleRuns.particles(particleRuns.series(run)[-1][1])
    x = last["x"][last["wall"] < 0]
    # a' = -s a, s' = s^2 (a^4 - 1)/(a^4 + 1), from p = p0 (1 - (x/a)^2 - (y/b)^2) and a b = 1
    exact = solve_ivp(lambda t, u: (-u[1]*u[0], u[1]**2*(u[0]**4 - 1)/(u[0]**4 + 1)), (0, DROP_END), (1, 1), rtol=1e-10).y[0, -1]
    return np.sqrt((x[:, :2]**2).mean(0)/(disc(n)**2).mean(0))*[1/exact, exact]


def ball(n: int) -> np.ndarray:
    """The rings of a ball of radius 1 m on a lattice, n along the radius."""
    x = disc(n)
    return x[x[:, 0] > 0]


def spheroid(run: Path, n: int, rate: float) -> None:
    """A ball with the velocity (-x/2, y) times the rate [1/s]: it becomes a column along the axis, or is pressed flat."""
    x = ball(n)
    solve(run, 1/n, 14, x, rate*x*[-0.5, 1], np.zeros(len(x)), {
        "axisymmetric": "yes", "densityDiffusion": "Molteni", "delta": 0.1, "outputs": "{ interval 0.1; }"}, DROP_END, DROP_END)


def radiusAndHeight(run: Path, n: int, rate: float) -> np.ndarray:
    """Of the spheroid at the end, over the exact ones."""
    last = particleRuns.particles(particleRuns.series(run)[-1][1])["x"][:, :2]

    def moments(x: np.ndarray) -> np.ndarray:
        # Each has the mass that it starts with
        return np.sqrt((ball(n)[:, :1]*x**2).sum(0)/ball(n)[:, 0].sum())

    # Euler's equations along x and y with p = p0 (1 - (x/a)^2 - (y/b)^2)
    exact = solve_ivp(lambda t, u: (u[0]**2*(u[1]**2/4 - u[2]**2)/(u[2]**2 + u[1]**2/2), -u[0]*u[1]/2, u[0]*u[2]),
                      (0, DROP_END), (rate, 1, 1), rtol=1e-10).y[1:, -1]
    return moments(last)/moments(ball(n))/exact


def energyChange(run: Path, *parts: str) -> np.ndarray:
    """Of the sum of some parts since the start [J]."""
    energy = particleRuns.table(run, "energy")
    total = sum(energy[f"{part}_J"] for part in parts)
    return total - total[0]


def mode(x: np.ndarray) -> np.ndarray:
    """Velocity of the lowest wave in 1 m by DEPTH, over its amplitude."""
    return np.stack([-np.sin(np.pi*x[:, 0])*np.cosh(np.pi*x[:, 1]), np.cos(np.pi*x[:, 0])*np.sinh(np.pi*x[:, 1])], axis=1)/np.sinh(np.pi*DEPTH)


def wave(run: Path, n: int, nu: float) -> None:
    """The lowest standing wave, n particles deep; kinematic viscosity nu [m2/s]."""
    c0, spacing = 22, DEPTH/n
    x = lattice((0, 0), (2*n, n), spacing)
    entries: Dict[str, object] = {"symmetry": planes((0, 0), (1, 1), "x"), "outputs": "{ interval 0.02; }"}
    if nu:
        entries.update({"viscosity": "laminar", "liquid": f"{{ mu {RHO*nu}; }}"})
    solve(run, spacing, c0, x, WAVE_SPEED*mode(x), density(RHO*GRAVITY*(DEPTH - x[:, 1]), c0), entries,
          4.25*2*np.pi/FREQUENCY, 0.04*2*np.pi/FREQUENCY, GRAVITY, lattice((0, -5*spacing), (2*n, 5), spacing))


def oscillation(run: Path) -> Tuple[float, float]:
    """Of the wave: frequency over the exact one, and decay [1/s]."""
    times, shares = [], []
    for time, file in particleRuns.series(run):
        now = particleRuns.particles(file)
        fluid = now["wall"] < 0
        own = mode(now["x"][fluid, :2])
        times.append(time)
        shares.append((own*now["U"][fluid, :2]).sum()/(own**2).sum()/WAVE_SPEED)
    t, share = np.array(times), np.array(shares)
    crossing = np.nonzero(share[:-1]*share[1:] <= 0)[0]
    zeros = t[crossing] + (t[crossing + 1] - t[crossing])*share[crossing]/(share[crossing] - share[crossing + 1])
    peaks = [np.abs(share[a:b]).max() for a, b in zip(crossing[:-1] + 1, crossing[1:] + 1)]
    return (float(np.pi/np.polyfit(range(len(zeros)), zeros, 1)[0]/FREQUENCY),
            -float(np.polyfit(0.5*(zeros[1:] + zeros[:-1]), np.log(peaks), 1)[0]))
