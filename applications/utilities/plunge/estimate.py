# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scene costs on this machine, by a short probe."""
