"""What is not finite first is named, with what it is made of."""

import functools

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.errors import IntegrationError, PyDyUserWarning
from pydy.mechanics import Definition
from pydy.system import System

X, ANGLE, V, W = me.dynamicsymbols("x theta v omega")
R, B, D = sm.symbols("r B D")
SLIP = r"`.*/v\(t\)` = 0/0, at .*v\(t\) = 0.*omega\(t\) = 0.*r = 0\.3.*sqrt\(v\*\*2 \+ eps"


@functools.cache
def wheel(force):
    """A driven wheel on a road; its force follows from the slip, with v in its denominator."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    turning = N.orientnew("W", "Axis", (ANGLE, N.z))
    turning.set_ang_vel(N, W * N.z)
    centre = O.locatenew("C", X * N.x)
    centre.set_vel(N, V * N.x)
    inertia = me.inertia(turning, 0, 0, sm.Rational(1, 10))
    body = me.RigidBody("wheel", centre, turning, 10, (inertia, centre))
    loads = [(centre, force * N.x), (turning, (10 - R * force) * N.z)]
    return Definition(N, [X, ANGLE], [V, W], bodies=[body], loads=loads)


def system_of(force, **options):
    system = System(wheel(force), times=np.linspace(0.0, 0.1, 3), **options)
    numbers = {R: 0.3, B: 10.0, D: 100.0}
    system.constants = {k: v for k, v in numbers.items() if k in system.constants_symbols}
    return system


FORCE = D * sm.atan(B * (R * W - V) / V)


@pytest.mark.parametrize("solver", [None, "dop853", "radau"])
def test_a_slip_at_rest_is_named_with_its_inputs(solver):
    system = system_of(FORCE, ode_solver=solver)
    with pytest.raises(IntegrationError, match=SLIP):
        system.integrate()


def test_derivatives_at_rest_name_it_too():
    with pytest.warns(PyDyUserWarning, match=SLIP):
        system_of(FORCE).evaluate_ode()


def test_a_function_outside_its_domain_is_named():
    with pytest.warns(PyDyUserWarning, match=r"is `log\(-?D.*\)` = nan, at .*v\(t\) = 0"):
        system_of(sm.log(V - D)).evaluate_ode()


def test_an_output_that_is_not_finite_is_named_where_the_motion_is_sound():
    system = system_of(sm.S.Zero, outputs={sm.Symbol("slip"): (0.3 * W - V) / V})
    assert np.isfinite(system.evaluate_ode()).all()
    with pytest.warns(PyDyUserWarning, match=r"`.*/v\(t\)` = 0/0, at"):
        system.evaluate_outputs()
