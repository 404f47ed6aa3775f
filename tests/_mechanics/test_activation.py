"""Activations of musculotendons are states of a System of SymPy, or told where they are not."""

import functools
import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.biomechanics import (
    FirstOrderActivationDeGroote2016,
    MusculotendonDeGroote2016,
)

from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.system import System

Q, U = me.dynamicsymbols("q u", real=True)
T = me.dynamicsymbols._t
MISSING = r"`a_b\(t\)` is a state of a musculotendon.*its derivative.*`specifieds`"


class Elbow:
    def __init__(self):
        N, O = self.N, self.O = me.ReferenceFrame("N"), me.Point("O")
        O.set_vel(N, 0)
        A = N.orientnew("A", "Axis", (Q, N.z))
        A.set_ang_vel(N, U * N.z)
        centre, wrist = O.locatenew("C", 0.15 * A.x), O.locatenew("W", 0.05 * A.x)
        shoulder = O.locatenew("S", 0.3 * N.y)
        shoulder.set_vel(N, 0)
        for point in (centre, wrist):
            point.v2pt_theory(O, N, A)
        self.muscle = MusculotendonDeGroote2016.with_defaults(
            "b", me.LinearPathway(shoulder, wrist),
            FirstOrderActivationDeGroote2016.with_defaults("b"),
            peak_isometric_force=sm.Integer(500),
            optimal_fiber_length=sm.Rational(1, 4), tendon_slack_length=sm.Rational(1, 20),
        )  # fmt: skip
        self.body = me.RigidBody("arm", centre, A, 1, (me.inertia(A, 0, 0, 0.0075), centre))

    def system(self, formed):
        system = me.System(frame=self.N, fixed_point=self.O)
        system.q_ind, system.u_ind, system.kdes = [Q], [U], [Q.diff(T) - U]
        system.add_bodies(self.body)
        system.add_actuators(self.muscle)
        if formed:
            system.form_eoms()
        return system

    def definition(self):
        return Definition(self.N, [Q], [U], bodies=[self.body], loads=[self.muscle])

    def kane(self):
        return me.KanesMethod(
            self.N, [Q], [U], kd_eqs=[Q.diff(T) - U], bodies=[self.body], forcelist=[self.muscle]
        )


@functools.cache
def by_hand():
    """The derivatives of q, a, u at a state, by SymPy's own method and `rhs()` of the muscle."""
    elbow = Elbow()
    kane = me.KanesMethod(elbow.N, [Q], [U], kd_eqs=[Q.diff(T) - U])
    kane.kanes_equations([elbow.body], elbow.muscle.to_loads())
    (a,), (e,) = elbow.muscle.x, elbow.muscle.r
    rates = sm.Matrix([U, *elbow.muscle.rhs(), *kane.mass_matrix.LUsolve(kane.forcing)])
    return np.ravel(sm.lambdify((Q, a, U, e), rates)(0.2, 0.3, 0.4, 0.6))


@pytest.mark.parametrize("formed", [False, True], ids=["System", "form_eoms"])
def test_activation_dynamics_are_states_of_a_system(formed):
    elbow = Elbow()
    system = System(elbow.system(formed), specifieds={elbow.muscle.r[0]: 0.6})
    assert system.states == [Q, elbow.muscle.x[0], U]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = system.evaluate_ode([0.2, 0.3, 0.4])
    np.testing.assert_allclose(found, by_hand(), rtol=1e-10)


WITHOUT = {
    "Definition": lambda: (Elbow().definition(), {}),
    "KanesMethod": lambda: (Elbow().kane(), {}),
    "the method of a System": lambda: (Elbow().system(formed=True), {"equations": "method"}),
}


@pytest.mark.parametrize("way", WITHOUT)
def test_an_activation_without_a_value_and_without_an_equation_is_told_once(way):
    method, options = WITHOUT[way]()
    system = System(method, **options)
    with pytest.warns(PyDyUserWarning, match=MISSING):
        system.evaluate_ode([0.2, 0.4])
    system.evaluate_ode([0.3, 0.4])


def test_an_activation_that_is_given_is_not_told():
    elbow = Elbow()
    system = System(elbow.definition(), specifieds={elbow.muscle.x[0]: 0.3})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = system.evaluate_ode([0.2, 0.4])
    np.testing.assert_allclose(found, by_hand()[[0, 2]], rtol=1e-10)
