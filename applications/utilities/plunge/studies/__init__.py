# SPDX-License-Identifier: GPL-3.0-or-later
"""What the studies in validation/ share, some of it with the tests."""
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[4]
