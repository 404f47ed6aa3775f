"""Explicit methods of the user's own: a tableau is all that they are."""

import pickle

import numpy as np
import pytest

from pydy.solvers import Solver, Tableau, dop853, rk4
from pydy.solvers.tableaus import tableau_of

HEUN = {
    "name": "heun",
    "order": 2,
    "error_order": 1,
    "nodes": (0.0, 1.0, 1.0),
    "stages": ({}, {0: 1.0}),
    "weights": {0: 0.5, 1: 0.5},
    "errors": ({0: -0.5, 1: 0.5},),
}


def decay(x, t):
    return [-x[0]]


def test_a_tableau_makes_a_solver_that_controls_its_error():
    heun = Solver.from_tableau(Tableau(**HEUN))
    x, info = heun(decay, [1.0], [0.0, 1.0], rtol=1e-7, atol=1e-7, full_output=True)
    assert abs(x[-1, 0] - np.exp(-1.0)) < 1e-5
    assert info["evaluations"] > info["steps"] > 100


def test_without_an_error_estimate_steps_have_a_fixed_size():
    own = {**HEUN, "name": "heun_fixed", "errors": (), "error_order": None}
    x, info = Solver.from_tableau(Tableau(**own))(
        decay, [1.0], [0.0, 1.0], step=0.125, full_output=True
    )
    assert info["steps"] == 8
    assert x[-1, 0] == pytest.approx((1 - 0.125 + 0.125**2 / 2) ** 8, rel=1e-14)


def test_the_same_numbers_under_another_name_give_the_same_bits():
    kutta = tableau_of("rk4")
    own = Solver.from_tableau(Tableau(**{**vars(kutta), "name": "kutta"}))
    times = np.linspace(0.0, 1.0, 7)
    found, expected = (s(decay, [1.0], times, step=0.1) for s in (own, rk4))
    np.testing.assert_array_equal(found, expected)


def test_solvers_are_pickled_with_their_tableau():
    heun = pickle.loads(pickle.dumps(Solver.from_tableau(Tableau(**HEUN))))
    assert heun.name == "heun"
    assert heun.adaptive
    assert pickle.loads(pickle.dumps(dop853)) is dop853


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"name": "dop853"}, "'dop853', which is that of a solver of the package"),
        ({"nodes": (0.0, 1.0)}, "`nodes` must have 3 entries.*got 2"),
        ({"nodes": (0.0, 0.5, 1.0)}, "row 1 sums to 1.0 and the node is 0.5"),
        ({"stages": ({}, {1: 1.0})}, "earlier stages, but row 1"),
        ({"weights": {0: 0.5, 1: 0.4}}, "`weights` must sum to 1, got 0.9"),
        ({"errors": ({0: 0.5, 1: 0.5},)}, "`errors` are differences.*sums to 1.0"),
        ({"errors": ()}, "`errors` and `error_order` belong together"),
        ({"errors": ({0: 1.0, 1: -1.0},) * 3}, "one row or two, got 3"),
    ],
)
def test_a_tableau_that_is_not_consistent_is_refused(change, message):
    own = {**HEUN, "name": "broken", **change}
    with pytest.raises(ValueError, match=message):
        Solver.from_tableau(Tableau(**own))


def test_two_tableaus_do_not_share_a_name():
    Solver.from_tableau(Tableau(**{**HEUN, "name": "twice"}))
    with pytest.raises(ValueError, match="'twice', which another one has already"):
        Solver.from_tableau(Tableau(**{**HEUN, "name": "twice", "order": 3}))
