"""The compiled functions of a program against NumPy, to the bit."""

import pickle
import sys

import numpy as np
import pytest
import sympy as sm

from oracles import optima
from oracles.optima import TF, T
from pydy.control import OptimalControl
from pydy.control.ipopt import library, solve
from pydy.control.nlp import SIGNATURES, Nlp, PointGroup, cubics_at, runs_of
from pydy.inputs import SampledInput


def points(nlp, k, y):
    group = nlp.groups[k]
    return y[group.at] * nlp.sizes[group.at]


def evaluated(nlp, name, y, data=None):
    """Return the results of each group, as the kernels give them."""
    found = []
    for k, group in enumerate(nlp.groups):
        f = group.functions
        if name in f.programs:
            own = group.data if data is None else data[k]
            found.append((group, f(name, points(nlp, k, y), own, group.constants)))
    return found


@pytest.mark.parametrize(
    ("method", "order", "mesh"),
    [("radau", 3, 70), ("radau", 2, 1), ("hermite-simpson", 1, 5), ("midpoint", 1, 200)],
)
def test_functions_of_a_program_have_the_bits_of_numpy(method, order, mesh):
    system, (q1, q2, u1, u2, F) = optima.cart_pole()
    problem = OptimalControl(
        system,
        sm.Integral(F**2 + q1 * TF, T) + u2.subs(T, TF) ** 2,
        TF,
        end={q1: 0.5},
        bounds={TF: (1.0, 3.0)},
        boundary=[sm.Eq(u1.subs(T, TF), q2.subs(T, TF))],
        mesh=mesh,
        method=method,
        order=order,
    )
    nlp, z, _ = problem._combined_program([problem._mesh], [{TF: 2.0}])
    rng = np.random.default_rng(1)
    y = z / nlp.sizes + rng.normal(size=len(z)) / 10
    multipliers, weight = rng.normal(size=nlp.rows), 0.7

    cost = sum(float(out.sum()) for _, out in evaluated(nlp, "cost", y)) / nlp.cost_size
    assert nlp.native("cost", y)[0][0] == cost
    slopes = np.zeros(nlp.size)
    for group, out in evaluated(nlp, "gradient", y):
        at = group.at[group.functions.gradient_at].ravel()
        slopes += np.bincount(at, out.ravel(), minlength=nlp.size)
    gradient, fine = nlp.native("gradient", y)
    assert fine
    np.testing.assert_array_equal(gradient, slopes * (nlp.sizes / nlp.cost_size))
    rows, fine = nlp.native("rows", y)
    assert fine
    plain = np.concatenate([out.ravel() for _, out in evaluated(nlp, "rows", y)])
    np.testing.assert_array_equal(rows, plain / nlp.row_sizes)
    J, fine = nlp.native("jacobian", y)
    assert fine
    plain = np.concatenate([out.ravel() for _, out in evaluated(nlp, "jacobian", y)])
    np.testing.assert_array_equal(J, plain * nlp.derivative_units[0])
    weighted, first = [], 0
    for group in nlp.groups:
        m, costs = group.functions.outputs
        own = (multipliers / nlp.row_sizes)[first : first + m * group.points]
        first += m * group.points
        last = np.full((costs, group.points), weight / nlp.cost_size)
        weighted.append(np.concatenate([group.data, own.reshape(m, group.points), last]))
    H, fine = nlp.native("hessian", y, weight, multipliers)
    assert fine
    plain = np.concatenate([out.ravel() for _, out in evaluated(nlp, "hessian", y, weighted)])
    np.testing.assert_array_equal(H, plain * nlp.derivative_units[1])


def test_what_is_not_finite_is_told():
    system, (x, _, F) = optima.double_integrator()
    problem = OptimalControl(system, sm.Integral(F**2 + sm.log(x), T), 1.0, end={x: 1.0}, mesh=9)
    nlp, z, _ = problem._combined_program([problem._mesh], [{x: np.linspace(1.0, 2.0, num=5)}])
    z[:] = -1.0
    assert np.isnan(nlp.native("cost", z / nlp.sizes)[0][0])
    z[:] = np.inf
    assert not nlp.native("rows", z)[1]


def test_a_search_calls_python_once_an_iteration_and_no_more():
    system, (x, v, F) = optima.double_integrator()
    problem = OptimalControl(
        system, TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1.0, 1.0), TF: (0.1, 10.0)}
    )
    nlp, z, _ = problem._combined_program([problem._mesh], [None])
    library()  # which is tried with functions in Python
    assert nlp.native.handle
    calls = []
    sys.setprofile(lambda frame, what, _: what == "call" and calls.append(frame.f_code.co_name))
    try:
        solution = solve(nlp, z)
    finally:
        sys.setprofile(None)
    assert len(solution.history) > 5
    assert calls.count("guarded") == len(solution.history)
    during = calls[calls.index("guarded") : -calls[::-1].index("guarded")]
    assert {*during} == {"guarded", "__init__", "<lambda>", "check"}


def test_a_program_is_pickled_without_its_addresses():
    system, (x, v, F) = optima.double_integrator()
    solution = system.optimize_trajectory(sm.Integral(F**2, T), 1.0, end={x: 1.0, v: 0.0})
    other = pickle.loads(pickle.dumps(solution._nlp))
    y = solution.solution.z / solution._nlp.sizes
    assert set(other.native.addresses) == set(SIGNATURES)
    assert other.native("cost", y) == solution._nlp.native("cost", y)


@pytest.mark.parametrize("interpolation", ["linear", "previous", "pchip"])
def test_cubics_at_times_have_the_values_of_the_samples(interpolation):
    """At a knot, too: 'previous' jumps there, and the time belongs to the sample that begins."""
    knots = np.array([0.0, 0.5, 2.0, 3.0])
    samples = SampledInput(knots, [[1.0, 7.0], [4.0, 5.0], [-2.0, 5.0], [3.0, 9.0]], interpolation)
    times = np.array([0.0, 0.25, 0.5, 1.9, 2.0, 2.5])
    rows = cubics_at([(np.array([0, 1]), samples)], times)
    assert len(rows) == 2 * 5
    for row, begin in enumerate((0, 5)):
        knot, *cubic = rows[begin : begin + 5]
        np.testing.assert_array_equal(knot, [0.0, 0.0, 0.5, 0.5, 2.0, 2.0])
        values = sum(c * (times - knot) ** k for k, c in enumerate(cubic))
        np.testing.assert_allclose(values, [samples(t)[row] for t in times], rtol=1e-14)


def test_places_that_follow_each_other_are_read_as_runs():
    k = np.arange(4)
    ends = np.array([k, k + 1, 20 + k])
    thrice = np.concatenate([ends + j * 5 for j in (0, 2, 1)], axis=1)
    shared = np.full((1, 12), 7)
    length, runs = runs_of(np.concatenate([thrice, shared]))
    assert length == 4
    assert runs.reshape(4, 3).tolist() == [[0, 10, 5], [1, 11, 6], [20, 30, 25], [-1, -1, -1]]
    assert runs_of(np.array([[3], [1]]))[1].tolist() == [3, 1]
    length, runs = runs_of(np.array([[5, 3, 4, 9]]))
    assert (length, runs.tolist()) == (1, [5, 3, 4, 9])
    length, runs = runs_of(shared)
    assert (length, runs.tolist()) == (12, [-1])


def test_a_second_search_makes_no_pieces_and_units_no_tables(monkeypatch):
    system, (x, v, F) = optima.double_integrator()
    problem = OptimalControl(system, sm.Integral(F**2, T), 1.0, end={x: 1.0, v: 0.0})
    problem.check()
    made = []
    own, start = PointGroup.__post_init__, Nlp.__post_init__
    monkeypatch.setattr(PointGroup, "__post_init__", lambda self: made.append("group") or own(self))
    monkeypatch.setattr(Nlp, "__post_init__", lambda self: made.append("program") or start(self))
    assert problem.solve().objective == pytest.approx(12.0)
    assert made == ["program"]
    assert problem._with([], [])._on(problem._mesh).problem is not problem._problem
    nlp, z, _ = problem._combined_program([problem._mesh], [None])
    assert nlp.native._tables is nlp.scaled_at(z).native._tables
