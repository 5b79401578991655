#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plane dam break of Lobovsky et al. 2014 at several spacings: ./run.py [SPACING...] [OPTION OF plungeSPH...]

cases/damBreakParticles with their tank, 1.61 m long, and water 0.6 m long and 0.3 m deep. Probes at the height of their
sensors, in the middle of the end wall."""
from pathlib import Path

from plunge.studies.particleRuns import resolutions

HEIGHTS = {"P1": 0.003, "P2": 0.015, "P3": 0.03, "P4": 0.08}
ENTRIES = {
    "geometry/fluid": "({ type box; min (0 0 0); max (0.6 0.3 0); })",
    "geometry/walls": "({ name tank; type box; min (0 0 0); max (1.61 0.9 0); open (top); })",
    "outputs/interval": 0.001,
    "outputs/gauges": "{ front (1.5 0 0); }",
    "outputs/probes": "{ " + " ".join(f"{name} (1.61 {height} 0);" for name, height in HEIGHTS.items()) + " }",
}

# 7.1 of their units of time
CONTROL = {"endTime": 1.25, "writeInterval": 0.05}

if __name__ == "__main__":
    resolutions("damBreakParticles", Path(__file__).resolve().parent, ENTRIES, default=(0.01, 0.005, 0.0025), **CONTROL)
