# SPDX-License-Identifier: GPL-3.0-or-later
"""Methods: from a scene to the numbers that their dictionaries in etc/methods need."""
