"""The squeezing mechanism of `examples/andrews.py` against its published numbers."""

import numpy as np
import pytest

from gallery import definitions
from pydy.system import System

andrews = definitions("andrews", before="mechanism = derive()")


@pytest.fixture(scope="module")
def closed():
    mechanism = andrews.derive()
    return System(
        mechanism.kane,
        constants=mechanism.constants,
        initial_conditions=mechanism.initial_conditions,
    )


def test_the_published_angles_close_the_loops(closed):
    assert np.abs(closed.evaluate_holonomic_constraints()).max() < 1e-16
    at_the_end = [*andrews.FINAL, *np.zeros(7)]
    assert np.abs(closed.evaluate_holonomic_constraints(x=at_the_end)).max() < 1e-15


def test_the_initial_accelerations_are_the_published_ones(closed):
    np.testing.assert_allclose(
        closed.evaluate_ode()[7:], andrews.INITIAL_ACCELERATIONS, rtol=1e-12, atol=1e-9
    )


def test_the_published_multipliers_hold_the_open_loops_together(closed):
    # With the loops open, M u' + Jᵀ λ = F must hold for the published u' and λ; here the mass
    # matrix comes from a derivation that knows of no constraint.
    mechanism = andrews.derive(constrained=False)
    values = {**mechanism.constants, **mechanism.initial_conditions}
    values |= dict.fromkeys(mechanism.kane.u, 0.0)
    mass = np.array(mechanism.kane.mass_matrix.xreplace(values), dtype=float)
    forcing = np.array(mechanism.kane.forcing.xreplace(values), dtype=float).ravel()
    jacobian = closed.evaluate_jacobian(of="holonomic")[:, :7]
    residual = mass @ andrews.INITIAL_ACCELERATIONS - forcing
    # Each row of the constraints: the joint through K1 and K2 minus the joint through the others.
    np.testing.assert_allclose(
        residual, -jacobian.T @ andrews.INITIAL_MULTIPLIERS, rtol=1e-9, atol=1e-12
    )
