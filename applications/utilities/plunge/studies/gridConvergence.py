# SPDX-License-Identifier: GPL-3.0-or-later
"""What a number from three meshes is worth: Celik, Ghia, Roache, Freitas and Raad, J. Fluids Eng. 130, 078001 (2008)."""
from dataclasses import dataclass
from math import exp, expm1, inf, isfinite, log, nan
from typing import List, Optional, Sequence

SAFETY = 1.25           # of the index
LIMIT = 50.0            # of an order's magnitude
TOLERANCE = 1e-10       # of an order


@dataclass(frozen=True)
class GridConvergence:
    """Of a quantity on three meshes; 1 is the finest, 3 the coarsest. Errors and indices are relative, 0.01 is one per cent."""

    fineRatio: float        # h2/h1
    coarseRatio: float      # h3/h2
    convergence: str        # monotone | oscillatory | divergent | undetermined
    observedOrder: float    # nan where two values are equal
    order: float            # that the extrapolation and the indices use
    extrapolated: float     # value on a mesh of no size, from the fine pair
    fineError: float        # |value1 - value2|/|value1|
    coarseError: float      # |value2 - value3|/|value2|
    fineIndex: float        # GCI21, the uncertainty of value 1
    coarseIndex: float      # GCI32, that of value 2
    middleUncertainty: float    # of value 2, in its unit: the larger of what the two pairs say

    @property
    def asymptoticRatio(self) -> float:
        """GCI32/(r21^p GCI21): about 1 where the meshes are fine enough for the order to hold."""
        return self.coarseIndex/(self.fineRatio**self.order*self.fineIndex) if self.fineIndex else nan


def representativeSize(cells: int, extent: float, dimensions: int) -> float:
    """Edge of the mean cell (eqs. 1 and 2): extent is the area or the volume of the mesh."""
    return (extent/cells)**(1/dimensions)


def observedOrder(fineRatio: float, coarseRatio: float, differenceRatio: float) -> float:
    """The order p of eq. 3, by bisection; differenceRatio = (value3 - value2)/(value2 - value1).

    Eq. 3 takes p's magnitude. Here its sign stays: values that part have a negative order."""
    oscillates = differenceRatio < 0
    fine, coarse = log(fineRatio), log(coarseRatio)

    def logarithm(p: float) -> float:
        """Of |differenceRatio| at order p; it grows with p."""
        if oscillates:
            return p*fine + log((exp(p*coarse) + 1)/(exp(p*fine) + 1))
        return p*fine + log(expm1(p*coarse)/expm1(p*fine) if p else coarse/fine)

    low, high = -LIMIT, LIMIT
    while high - low > TOLERANCE:
        p = 0.5*(low + high)
        if logarithm(p) < log(abs(differenceRatio)):
            low = p
        else:
            high = p
    return 0.5*(low + high)


def relative(difference: float, value: float) -> float:
    return abs(difference/value) if value else (inf if difference else 0.0)


def gridConvergence(sizes: Sequence[float], values: Sequence[float], least: float = 0, most: float = inf) -> GridConvergence:
    """Eqs. 3 to 7, for cell sizes and values from the finest mesh to the coarsest; the order is held in [least, most].

    With an order that is held, the two pairs of meshes say different things of the middle mesh. So they do where the values
    oscillate or part. The middle mesh's uncertainty is then the larger: SAFETY times its distance to the value that either pair
    extrapolates to. Where the order is not determined, it is `least`."""
    if not (len(sizes) == len(values) == 3 and 0 < sizes[0] < sizes[1] < sizes[2]):
        raise ValueError(f"sizes {list(sizes)}, values {list(values)}: expected three of each, from the finest mesh to the coarsest")
    if not all(map(isfinite, values)):
        raise ValueError(f"values {list(values)}: expected finite ones")
    fineRatio, coarseRatio = sizes[1]/sizes[0], sizes[2]/sizes[1]
    fine, coarse = values[1] - values[0], values[2] - values[1]

    if fine == 0 or coarse == 0:
        observed, order, convergence = nan, least, "undetermined"
    else:
        observed = observedOrder(fineRatio, coarseRatio, coarse/fine)
        order = min(max(observed, least), most)
        convergence = "oscillatory" if coarse/fine < 0 else "monotone" if observed > 0 else "divergent"

    def share(ratio: float) -> float:
        """Of the error on the finer mesh of a pair, over the pair's difference."""
        return 1/(ratio**order - 1) if order > 0 else inf

    def error(difference: float, factor: float) -> float:
        return abs(difference)*factor if difference else 0.0

    fineError, coarseError = relative(fine, values[0]), relative(coarse, values[1])
    return GridConvergence(
        fineRatio, coarseRatio, convergence, observed, order,
        values[0] - (fine*share(fineRatio) if fine else 0.0), fineError, coarseError,
        SAFETY*error(fineError, share(fineRatio)), SAFETY*error(coarseError, share(coarseRatio)),
        SAFETY*max(error(coarse, share(coarseRatio)), error(fine, 1 + share(fineRatio))),
    )


def levels(sizes: Sequence[float], values: Sequence[float], least: float = 0, most: float = inf) -> List[Optional[float]]:
    """Uncertainty of each of three values and more, from the finest mesh to the coarsest, in their unit: of the finest its index, of
    those between two others middleUncertainty; None of the coarsest, and where there are fewer than three."""
    found: List[Optional[float]] = [None]*len(values)
    for i in range(len(values) - 2):
        if all(map(isfinite, values[i:i + 3])):
            three = gridConvergence(sizes[i:i + 3], values[i:i + 3], least, most)
            found[i + 1] = three.middleUncertainty
            if i == 0:
                found[0] = SAFETY*abs(values[0] - three.extrapolated)
    return found
