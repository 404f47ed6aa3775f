"""radau where a load has an infinite slope: the motion is right, and never stands still."""

import mpmath
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.errors import IntegrationError
from pydy.solvers import dop853, radau, rk4
from pydy.system import System
from registry import has_fixed_step

q, v = me.dynamicsymbols("q v")


def pushed(force, x0, end):
    """A particle of mass 1 under a force, from a position and a velocity."""
    frame, point, m = me.ReferenceFrame("N"), me.Point("P"), sm.Symbol("m")
    point.set_vel(frame, v * frame.x)
    method = me.KanesMethod(frame, [q], [v], [q.diff() - v])
    method.kanes_equations([me.Particle("P", point, m)], [(point, force * frame.x)])
    system = System(method, constants={m: 1.0}, initial_conditions={q: x0[0], v: x0[1]})
    system.times, system.ode_solver = [0.0, end], radau
    return system


def time_to(speed, push, power):
    """When v' = push − v**power from rest comes to a speed, by quadrature of 20 digits."""
    with mpmath.workdps(20):
        return float(mpmath.quad(lambda w: 1 / (push - w ** mpmath.mpf(power)), [0, speed]))


@pytest.mark.parametrize("start", [0.0, 1e-300])
@pytest.mark.parametrize("power", [sm.Rational(1, 2), sm.Rational(1, 3), sm.Rational(1, 10)])
def test_drag_with_an_infinite_slope_at_rest(power, start):
    x = pushed(10 - v**power, (0.0, start), 2.0).integrate(rtol=1e-10, atol=1e-10)
    assert abs(time_to(x[-1, 1], 10, power) - 2.0) < 1e-8
    if power == sm.Rational(1, 2):
        assert abs(x[-1, 1] - 14.682934) < 1e-6


def test_a_slope_that_is_not_a_number_at_rest():
    drag = sm.sqrt(sm.Abs(v)) * sm.sign(v)
    x = pushed(10 - drag, (0.0, 0.0), 2.0).integrate(rtol=1e-10, atol=1e-10)
    assert abs(time_to(x[-1, 1], 10, 0.5) - 2.0) < 1e-8


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_a_spring_with_an_infinite_slope_keeps_the_energy(unit):
    x = pushed(unit * 10 - sm.sqrt(unit * q), (0.0, 0.0), 2.0)
    x = x.integrate(rtol=1e-10, atol=unit * 1e-10)[-1] / unit
    assert x[0] > 17.0
    assert abs(x[1] ** 2 / 2 - 10 * x[0] + 2 / 3 * x[0] ** 1.5) < 1e-7


@pytest.mark.parametrize("solver", [radau, dop853, rk4])
@pytest.mark.parametrize("mass", [1e-310, 5e-324])
def test_a_mass_whose_reciprocal_is_no_number_is_an_error(mass, solver):
    system = pushed(10 - v, (0.0, 1.0), 2.0)
    system.constants, system.ode_solver = {"m": mass}, solver
    options = {"step": 0.1} if has_fixed_step(solver) else {}
    with pytest.raises(IntegrationError, match=r"not finite .*at t = 0\.0 in the state q"):
        system.integrate(**options)


def test_a_tiny_mass_beside_a_load_of_its_size_moves_as_it_must():
    x = pushed(1e-300 * (10 - v), (0.0, 0.0), 2.0)
    x.constants = {"m": 1e-300}
    x = x.integrate(rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(x[-1, 1], -10.0 * np.expm1(-2.0), rtol=1e-8)
