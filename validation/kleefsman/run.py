#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""cases/kleefsman at several spacings: ./run.py [SPACING...] [OPTION OF plungeSPH...]"""
from pathlib import Path

from plunge.studies.particleRuns import resolutions

if __name__ == "__main__":
    resolutions("kleefsman", Path(__file__).resolve().parent, default=(0.0275, 0.55/30))
