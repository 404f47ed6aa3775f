"""Noncontributing forces that cancel in the equations of a method without being simplified away."""

import numpy as np
import pytest
import sympy as sm

from cases import close
from oracle import Oracle
from pydy._mechanics.idle import without_idle
from pydy.system import System
from rolling import ball_on_a_turntable
from zoo import T


def test_what_cancels_is_left_out_and_what_contributes_is_not():
    r, k = sm.symbols("r k")
    u, first, second = (sm.Function(name)(T) for name in ("u", "F", "G"))
    forcing = [r * (first - k * u) - r * first, second * u]
    kept = without_idle(forcing, [first + second - u], {u})
    assert sm.simplify(sm.Matrix(kept) - sm.Matrix([-r * k * u, second * u])) == sm.zeros(2, 1)
    assert first not in kept[0].atoms(sm.Function)


@pytest.mark.parametrize("equations", [None, "graph", "method"])
def test_the_forces_in_a_rolling_contact_are_outputs_whatever_the_source(equations):
    model = ball_on_a_turntable()
    system = System(
        model.kane, dict(model.constants), noncontributing_forces=model.forces, equations=equations
    )
    assert not set(model.forces) & set(system.specifieds_symbols)
    system.specifieds = {s: model.specifieds[s] for s in system.specifieds_symbols}
    x = np.random.default_rng(4).uniform(0.2, 0.9, len(model.states))
    oracle = Oracle(model)
    wide = np.append(x, np.zeros(3))  # forces that depend on accelerations have integrals
    close(system.evaluate_ode(wide, 0.7)[: len(x)], oracle.xdot(x, 0.7), 1e-12)
    close(system.evaluate_outputs(wide, 0.7)[-3:], oracle.forces(x, 0.7), 1e-12)
