#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""cases/yehPetroff at several spacings: ./run.py [SPACING...] [OPTION OF plungeSPH...]"""
from pathlib import Path

from plunge.studies.particleRuns import resolutions

if __name__ == "__main__":
    resolutions("yehPetroff", Path(__file__).resolve().parent, default=(0.02, 0.015, 0.01, 0.0075))
