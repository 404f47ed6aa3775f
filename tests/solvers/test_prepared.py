"""Integrations that are prepared once and run many times."""

import copy

import numpy as np
import pytest

from pydy.errors import IntegrationError
from pydy.models import n_link_pendulum_on_cart
from pydy.solvers import dop853, vern9
from pydy.solvers.layout import rows_of
from pydy.solvers.options import Options
from pydy.solvers.run.workspace import Workspace
from pydy.solvers.tableaus import method_arrays
from registry import ADAPTIVE

TIMES = np.linspace(0.0, 2.0, num=9)


@pytest.fixture(scope="module")
def pendulum():
    system = n_link_pendulum_on_cart(2)
    system.generate_ode_function()
    return system


def arguments(system):
    start = np.array([0.1, 0.4, -0.3, 0.0, 0.2, 0.0])
    r = np.zeros(len(system.specifieds_symbols))
    p = np.ones(len(system.constants_symbols))
    return system.evaluate_ode_function, start, TIMES, (r, p)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_runs_give_the_bits_of_calls_in_any_order(pendulum, solver):
    f, start, times, args = arguments(pendulum)
    options = {"rtol": 1e-8, "atol": 1e-8}
    prepared = solver.prepare(f, start, times, args, **options)
    others = [start, 2.0 * start, -start, start]
    for x0 in others:
        expected, info = solver(f, x0, times, args=args, full_output=True, **options)
        np.testing.assert_array_equal(prepared(x0), expected)
        assert prepared.info == info


def test_what_has_not_run_says_so(pendulum):
    info = dop853.prepare(*arguments(pendulum)).info
    assert (info["status"], info["steps"], info["events"]) == ("not run", 0, [])


def test_results_are_arrays_of_their_own(pendulum):
    prepared = dop853.prepare(*arguments(pendulum))
    first = prepared(prepared.x0)
    kept = first.copy()
    prepared(2.0 * prepared.x0)
    np.testing.assert_array_equal(first, kept)


def test_a_python_function_is_prepared_too():
    prepared = vern9.prepare(lambda x, t: -x, [1.0], [0.0, 1.0], rtol=1e-10, atol=1e-12)
    for start in (1.0, -3.0):
        np.testing.assert_allclose(prepared([start])[-1], start * np.exp(-1.0), rtol=1e-9)


def test_a_prepared_integration_takes_a_number_as_the_call_does():
    decay = dop853.prepare(lambda x, t: -x, 1.0, [0.0, 1.0])
    np.testing.assert_array_equal(decay(1.0), decay([1.0]))


def test_a_copy_has_the_tolerances_but_never_other_numbers(pendulum):
    f, x0, times, (r, p) = arguments(pendulum)
    prepared = dop853.prepare(f, x0, times, (r, p))
    assert prepared.retune(dop853, {"rtol": 1e-3, "atol": 1e-3})
    np.testing.assert_array_equal(copy.copy(prepared)(x0), prepared(x0))
    assert prepared.renumber(2.0 * p, r, times)
    with pytest.raises(TypeError, match="numbers were changed cannot be pickled"):
        copy.copy(prepared)


def test_what_does_not_fit_is_refused_at_each_run(pendulum):
    prepared = dop853.prepare(*arguments(pendulum))
    with pytest.raises(ValueError, match=r"`x0` must have the shape \(6,\), got \(5,\)"):
        prepared(np.zeros(5))
    with pytest.raises(ValueError, match="`x0` must be finite"):
        prepared([np.nan, 0.0, 0.0, 0.0, 0.0, 0.0])
    huge = np.array([0.1, 0.4, -0.3, 0.0, 1e200, 0.0])  # finite, though its square is not
    with pytest.raises(IntegrationError):
        dop853.prepare(*arguments(pendulum), max_steps=50)(huge)
    assert np.isfinite(prepared(prepared.x0)).all()


def test_the_end_of_the_last_step_needs_no_interpolant(pendulum):
    f, start, times, args = arguments(pendulum)
    counts = []
    for wanted in (times[[0, -1]], [0.0, 1.999, 2.0]):
        info = dop853(f, start, wanted, args=args, full_output=True)[1]
        counts.append(info["evaluations"] - 12 * (info["steps"] + info["rejected"]))
    assert counts[1] == counts[0] + 3  # the stages of dop853's interpolant


def test_a_table_names_the_arrays_that_its_workspace_keeps():
    """Of two threads that first use a method at once, one has arrays that no cache keeps.

    Its rows were kept all the same: the next integrations then read memory that was free.
    """
    for _ in range(2):
        work = Workspace("tsit5", lambda x, t: -x, 97, TIMES, (), Options())
        rows = rows_of(work.method)
        assert work._table[: len(rows)].tolist() == rows
        method_arrays.cache_clear()  # as if the cache had kept the other thread's
