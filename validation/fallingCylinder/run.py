#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""cases/fallingCylinder at several spacings: ./run.py [SPACING...] [OPTION OF plungeSPH...]"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from particleRuns import resolutions  # noqa: E402

if __name__ == "__main__":
    resolutions("fallingCylinder", Path(__file__).resolve().parent, default=(0.0055, 0.00275))
