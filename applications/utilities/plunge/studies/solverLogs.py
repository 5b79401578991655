# SPDX-License-Identifier: GPL-3.0-or-later
"""What solvers print."""
import re
from pathlib import Path
from typing import List, NamedTuple, Optional, Sequence

import numpy as np

from plunge.results import CaseError


class Step(NamedTuple):
    """What a solver prints in one time step."""
    time: float                             # [s]
    centre: Optional[np.ndarray]            # centre of rotation of the body [m]
    orientation: Optional[np.ndarray]       # row by row
    cpu: float                              # since the start of the run [s]


def readLog(path: Path) -> List[Step]:
    """The completed time steps of a log; of several motion reports in a step, the last one counts."""
    steps: List[Step] = []
    time: Optional[float] = None
    centre = orientation = None
    vector = r"\s*\(([^)]*)\)"
    for line in path.read_text().splitlines():
        if match := re.match(r"Time = (\S+)", line):
            time, centre, orientation = float(match.group(1)), None, None
        elif match := re.match(r"\s*Centre of rotation:" + vector, line):
            centre = np.array(match.group(1).split(), dtype=float)
        elif match := re.match(r"\s*Orientation:" + vector, line):
            orientation = np.array(match.group(1).split(), dtype=float)
        elif (match := re.match(r"ExecutionTime = (\S+) s", line)) and time is not None:
            steps.append(Step(time, centre, orientation, float(match.group(1))))
            time = None
    if not steps:
        raise CaseError(f"{path}: expected the output of a solver with at least one complete time step")
    return steps


def perStep(steps: Sequence[Step], first: int) -> float:
    """CPU time of a time step [s], without the first ones, which pay for what is constructed once."""
    if len(steps) <= first:
        raise CaseError(f"{len(steps)} time steps: expected more than {first}")
    return (steps[-1].cpu - steps[first - 1].cpu)/(len(steps) - first)
