# SPDX-License-Identifier: GPL-3.0-or-later
"""python3 -m plunge.studies: validation/run."""
import sys

from plunge.studies.driver import main

sys.exit(main())
