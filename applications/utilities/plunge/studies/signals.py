# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals over time: where they begin, their difference and its mean square, their running mean (plunge.results.running_mean)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from plunge.results import crossing, running_mean


class Signal(NamedTuple):
    """Values at times, in whatever units."""

    time: np.ndarray
    value: np.ndarray

    def at(self, time: np.ndarray) -> np.ndarray:
        """At other times; nan before its start and after its end."""
        return np.interp(time, self.time, self.value, left=np.nan, right=np.nan)

    def mean(self, window: float) -> Signal:
        """Running mean; the signal itself, of no window."""
        return Signal(self.time, running_mean(self.time, self.value, window)) if window else self

    def rise(self, level: float) -> float:
        """When it first passes a level; nan if it never does."""
        return crossing(self.time, self.value, level)

    def later(self, delay: float) -> Signal:
        return Signal(self.time + delay, self.value)

    def during(self, start: float, end: float) -> Signal:
        inside = (self.time >= start) & (self.time <= end)
        return Signal(self.time[inside], self.value[inside])

    def integral(self) -> float:
        return float(np.trapz(self.value, self.time))

    def less(self, other: Signal) -> np.ndarray:
        """Its difference from another one at those of the other's times that it spans."""
        inside = other.during(self.time[0], self.time[-1])
        return self.at(inside.time) - inside.value


def rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))
