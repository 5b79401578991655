# SPDX-License-Identifier: GPL-3.0-or-later
"""The exact standing wave of plunge.studies.standingWave at its limits."""
import numpy as np
import pytest

from plunge.studies.signals import Signal
from plunge.studies.standingWave import Wave, decay, frequency


@pytest.mark.parametrize("gas", (1e-6, 1.2, 900))
def test_starts_from_rest(gas: float) -> None:
    wave = Wave(0.1, 1000, gas, 1e-5, 0.07, 9.81, 3)
    start = wave.amplitude(np.array([0, 1e-6]))
    assert start == pytest.approx(1, abs=1e-8)


def test_a_free_surface_decays_as_Lamb_has_it() -> None:
    """With the frequency of an ideal fluid and 2 nu k^2 (art. 348), where the viscosity is small."""
    wave = Wave(0.1, 1000, 1e-9, 1e-6, 0.07, 9.81, 40)
    time = np.linspace(0, wave.duration, 20001)
    of = Signal(time, wave.amplitude(time))
    assert frequency(of) == pytest.approx(wave.inviscid(wave.k), rel=1e-4)
    assert decay(of) == pytest.approx(2*wave.nu*wave.k**2, rel=0.02)


def test_a_very_viscous_one_creeps_back() -> None:
    """With g/(2 nu k) (Lamb art. 349), which no inertia holds up."""
    wave = Wave(0.1, 1000, 1e-9, 0.1, 0, 9.81, 1)
    time = np.array([0.4, 0.5])
    a, b = wave.amplitude(time)
    assert np.log(a/b)/0.1 == pytest.approx(9.81/(2*0.1*wave.k), rel=0.05)
