# SPDX-License-Identifier: GPL-3.0-or-later
"""What the body mesh's butterfly gains in time step over cells that are collapsed on the axis.

Both meshes are built with the same spacings, layers and cells around the body, in memory. For each, the largest 0.5*sum|phi|/V over the
cells gives the time step at Courant number 1 in flows past the body: uniform at several angles to the axis, and, over the fore body,
the potential flow of the dive (point sources on the axis, which do not represent the tip of the tail). The butterfly should be no worse
where the flow crosses the axis."""
import json
from pathlib import Path

from plunge import meridianMesh, scene
from plunge.methods import meshes, tiers
from plunge.studies import REPOSITORY
from plunge.studies.meshTimeStep import inverse_time_step, polar_surface, potential_flow, uniform_flow
from plunge.studies.study import Done, Quantity, Run, Study, twin

SPEED = 25.0    # [m/s]
FLOWS = {"along the axis": 0, "5 deg to the axis": 5, "15 deg to the axis": 15, "of the dive over the fore body": None}
BUTTERFLY, COLLAPSED = "butterfly", "collapsed"


def solve(run: Run, path: Path) -> None:
    tier, resolution = run.grade[0], int(run.grade[1])
    dive = scene.read(REPOSITORY / "cases/gannetPlunge")
    body, size = dive.shape, meshes.Meshes(dive, tiers.read(tier, {}), resolution, 1, "half", "overset").size()
    mesh = meridianMesh.extrude((meridianMesh.butterfly_surface if run.variant == BUTTERFLY else polar_surface)(size), body, size)
    found = {"cells": len(mesh.hexahedra)}
    for name, angle in FLOWS.items():
        rate = inverse_time_step(mesh, potential_flow(body, SPEED) if angle is None else uniform_flow(angle, SPEED))
        if angle is None:
            rate = rate[mesh.nodes[mesh.hexahedra].mean(axis=1)[:, 0] < body.length/2]
        found[name] = 1e6/rate.max()
    path.mkdir(parents=True, exist_ok=True)
    (path / "steps.json").write_text(json.dumps(found))


def step(done: Done, flow: str) -> float:
    return json.loads((done.path / "steps.json").read_text())[flow]


study = Study(
    title="The body mesh allows longer time steps than one with cells collapsed on the axis",
    runs=[Run("gannetPlunge", "meshes", variant, resolution, ("quick", "full") if resolution == "fast" else ("full",))
          for resolution in ("fast", "fast 2", "standard") for variant in (BUTTERFLY, COLLAPSED)],
    solve=solve, sources=("applications/utilities/plunge/meridianMesh.py",),
    quantities=[Quantity("cells", "1", lambda done: step(done, "cells")),
                *(Quantity(f"time step at Courant number 1, flow {flow}", "us", lambda done, f=flow: step(done, f)) for flow in FLOWS),
                *(Quantity(f"time step gained, flow {flow}", "1", twin(lambda ours, other, f=flow: step(ours, f)/step(other, f), variant=COLLAPSED),
                           least=1 if angle else None) for flow, angle in FLOWS.items())],
    headlines=["time step gained, flow 5 deg to the axis"])
