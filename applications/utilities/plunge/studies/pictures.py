# SPDX-License-Identifier: GPL-3.0-or-later
"""matplotlib's pyplot, which needs no display here."""
import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot  # noqa: E402,F401
