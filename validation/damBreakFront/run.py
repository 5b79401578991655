#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""cases/damBreakParticles at several spacings: ./run.py [SPACING...] [OPTION OF plungeSPH...]"""
from pathlib import Path

from plunge.studies.particleRuns import resolutions

if __name__ == "__main__":
    resolutions("damBreakParticles", Path(__file__).resolve().parent, default=(0.01, 0.005), endTime=0.28)
