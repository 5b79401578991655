# SPDX-License-Identifier: GPL-3.0-or-later
"""What the commands, studies and tests of plungeFoam share; etc/bashrc puts it on PYTHONPATH."""
