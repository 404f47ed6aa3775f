"""The same function, integrated again: what an earlier call reserved and checked is used anew."""

import sys
import threading

import numpy as np
import pytest

from pydy._errors import IntegrationError
from pydy.models import multi_mass_spring_damper
from pydy.solvers import dop853, radau, rk4, tsit5
from registry import has_fixed_step

X0, T = np.array([1.0, 0.0]), np.linspace(0.0, 1.0, 5)
R, P = np.array([0.5]), np.array([0.2, 3.0, 2.0])
OPTIONS = {"rtol": 1e-9, "atol": 1e-9}


def right_hand_side():
    return multi_mass_spring_damper(apply_external_forces=True).generate_ode_function()


def calls_of(function):
    """How many Python functions a call of another runs."""
    count = 0

    def note(frame, event, argument):
        nonlocal count
        count += event == "call"

    sys.setprofile(note)
    try:
        function()
    finally:
        sys.setprofile(None)
    return count


def test_a_repeated_call_runs_a_half_of_the_python():
    rhs = right_hand_side()

    def call():
        dop853(rhs, X0, T, args=(R, P), **OPTIONS)

    call()
    prepared = calls_of(lambda: dop853.prepare(rhs, X0, T, args=(R, P), **OPTIONS))
    assert calls_of(call) <= 44
    assert prepared > 2 * 44


@pytest.mark.parametrize("solver", [dop853, tsit5, rk4, radau])
@pytest.mark.parametrize(
    "changed",
    [
        {"x0": np.array([-0.3, 2.0])},
        {"t": np.linspace(2.0, 5.0, 5)},
        {"t": np.linspace(0.0, 1.0, 9)},
        {"args": (np.array([-2.0]), P)},
        {"args": (R, np.array([0.0, 1.0, 7.0]))},
        {"args": ({"f0": -2.0}, {"m0": 1.0, "c0": 0.3, "k0": 2.0})},
        {"x0": [2.0, 1.0]},
        {"full_output": True},
    ],
    ids=str,
)
def test_other_arguments_give_what_a_first_call_gives(solver, changed):
    options = {"step": 0.01} if has_fixed_step(solver) else OPTIONS
    given = {"x0": X0, "t": T, "args": (R, P), **options}
    rhs = right_hand_side()
    before = solver(rhs, **given)
    kept = before.copy()
    again = solver(rhs, **{**given, **changed})
    first = solver(right_hand_side(), **{**given, **changed})
    if "full_output" in changed:
        assert again[1] == first[1]
        again, first = again[0], first[0]
    np.testing.assert_array_equal(again, first)
    np.testing.assert_array_equal(before, kept)
    np.testing.assert_array_equal(solver(rhs, **given), kept)


def test_a_tolerance_that_is_edited_in_place_counts():
    rhs, atol = right_hand_side(), np.array([1e-3, 1e-3])
    coarse = dop853(rhs, X0, T, args=(R, P), rtol=0.0, atol=atol)
    atol[:] = 1e-12
    fine = dop853(rhs, X0, T, args=(R, P), rtol=0.0, atol=atol)
    assert not np.array_equal(coarse, fine)


def test_times_that_are_edited_in_place_count():
    rhs, times = right_hand_side(), T.copy()
    dop853(rhs, X0, times, args=(R, P), **OPTIONS)
    times[2] = np.nan
    with pytest.raises(ValueError, match="`t` must be finite"):
        dop853(rhs, X0, times, args=(R, P), **OPTIONS)
    times[2] = 5.0
    with pytest.raises(
        ValueError, match=r"`t` must be ascending or descending, got 0.75 after 5.0 at index 3"
    ):
        dop853(rhs, X0, times, args=(R, P), **OPTIONS)


def test_a_failure_leaves_the_function_as_it_was():
    rhs = right_hand_side()
    good = dop853(rhs, X0, T, args=(R, P), **OPTIONS)
    with pytest.raises(ValueError, match="`x0` must be finite"):
        dop853(rhs, np.array([np.nan, 0.0]), T, args=(R, P), **OPTIONS)
    with pytest.raises(IntegrationError):
        dop853(rhs, X0, T, args=(R, np.array([0.2, 3.0, 0.0])), **OPTIONS)
    np.testing.assert_array_equal(dop853(rhs, X0, T, args=(R, P), **OPTIONS), good)


def test_threads_do_not_share_an_integration():
    rhs = right_hand_side()
    times = np.linspace(0.0, 200.0, 5)
    starts = [np.array([float(k), 1.0]) for k in range(8)]
    first = [dop853(right_hand_side(), x, times, args=(R, P), **OPTIONS) for x in starts]
    found = [None] * 8

    def work(k):
        for _ in range(20):
            found[k] = dop853(rhs, starts[k], times, args=(R, P), **OPTIONS)
            assert np.array_equal(found[k], first[k])

    threads = [threading.Thread(target=work, args=(k,)) for k in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    np.testing.assert_array_equal(found, first)
