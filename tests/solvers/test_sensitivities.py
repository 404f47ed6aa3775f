"""What sensitivities say of events that have no derivatives."""

import numpy as np
import pytest

from pydy.solvers.sensitivities import CompiledSensitivities
from pydy.trajectory import EventRecord

LOWER = "If it is to cross there, lower the tolerance. Otherwise omit"


def remedy(times, end):
    state = np.zeros(2)
    records = [EventRecord(float(time), "touch", 0, state, state) for time in times]
    return CompiledSensitivities.grazing_remedy(LOWER, records, end)


@pytest.mark.parametrize("seed", range(20))
def test_a_periodic_event_that_grazes_names_the_tolerance(seed):
    """Its intervals differ by errors of the solver: one in a few shrinks three times."""
    noise = np.random.default_rng(seed).uniform(-1e-6, 1e-6, size=8)
    assert remedy(np.arange(1.0, 9.0) + noise, 100.0) == LOWER
    assert remedy(-np.arange(1.0, 9.0) + noise, -100.0) == LOWER  # backwards in time


@pytest.mark.parametrize("ratio", [0.3, 0.5, 0.9, 0.99])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_intervals_that_shrink_by_a_ratio_accumulate_where_their_sum_is_within_the_times(
    ratio, sign
):
    times = sign * np.cumsum(ratio ** np.arange(7))
    left = sign / (1.0 - ratio) - times[-1]
    assert "It is the number 7 of these events" in remedy(times, times[-1] + 1.001 * left)
    assert remedy(times, times[-1] + 0.999 * left) == LOWER
    assert remedy(times[:3], sign * 1e3) == LOWER  # too few to tell
