#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A dam break in PySPH from particles of plungeSPH: ./pysphDamBreak.py PARTICLES.npz STEPS

Ramachandran et al., ACM Trans. Math. Softw. 47 (2021) 34. Its weakly compressible scheme with the same kernel, artificial
viscosity and no density diffusion; one evaluation in a step, steps as long as in its own example of this dam break, on one
thread. Prints the step [s] and the seconds for each; the first step, with which PySPH warms up, does not count."""
import os
import sys
import tempfile
import time
from typing import List

os.environ["OMP_NUM_THREADS"] = "1"

import numpy as np  # noqa: E402
from pysph.base.kernels import WendlandQuintic  # noqa: E402
from pysph.base.utils import get_particle_array  # noqa: E402
from pysph.solver.application import Application  # noqa: E402
from pysph.sph.integrator import PECIntegrator  # noqa: E402
from pysph.sph.scheme import WCSPHScheme  # noqa: E402


class DamBreak(Application):
    def __init__(self, state: np.lib.npyio.NpzFile, steps: int, folder: str) -> None:
        self.state = state
        self.steps = steps
        self.clock: List[float] = []
        super().__init__(output_dir=folder)

    def create_scheme(self) -> WCSPHScheme:
        s = self.state
        return WCSPHScheme(["fluid"], ["wall"], dim=3, rho0=float(s["rho0"]), c0=float(s["c0"]), h0=float(s["h"]),
                           hdx=float(s["h"]/s["spacing"]), gz=-9.81, alpha=float(s["alpha"]), gamma=7)

    def configure_scheme(self) -> None:
        self.step = 0.25*float(self.state["h"])/(1.1*float(self.state["c0"]))
        self.scheme.configure_solver(kernel=WendlandQuintic(dim=3), integrator_cls=PECIntegrator, dt=self.step,
                                     tf=self.step*(self.steps + 0.5), adaptive_timestep=False)

    def create_particles(self) -> list:
        s = self.state
        arrays = []
        for name, chosen in (("fluid", s["wall"] < 0), ("wall", s["wall"] >= 0)):
            x = s["x"][chosen].astype(float)
            rho = s["rho"][chosen].astype(float)
            arrays.append(get_particle_array(name=name, x=x[:, 0], y=x[:, 1], z=x[:, 2], rho=rho,
                                             m=rho*float(s["spacing"])**3, h=np.full(len(x), float(s["h"]))))
        self.scheme.setup_properties(arrays)
        return arrays

    def post_step(self, solver) -> None:
        self.clock.append(time.perf_counter())


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        run = DamBreak(np.load(sys.argv[1]), int(sys.argv[2]), folder)
        run.run(["--disable-output", "--no-openmp"])
    print("step", run.step, "seconds", (run.clock[-1] - run.clock[0])/(len(run.clock) - 1))
