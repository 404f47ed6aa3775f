"""Laws of contact and friction against their papers' formulas and closed forms."""

import math

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import (
    CompliantContact,
    brown_mcphee,
    hunt_crossley,
    joint_friction,
    kelvin_voigt,
    rolling_resistance,
    stribeck,
)
from pydy.mechanics import Definition
from zoo import inertial_frame

x, v = me.dynamicsymbols("x v")
N, O = inertial_frame()
P = O.locatenew("P", x * N.x)
m = sm.Symbol("m")


def left_over(v):
    """What a mass that hits at a speed and with λ = 0.3 keeps, by bisection of the closed form."""
    rate = 0.3
    goal = v / rate - math.log1p(rate * v) / rate**2
    low, high = 0.0, v
    for _ in range(200):
        middle = (low + high) / 2
        value = -middle / rate - math.log1p(-rate * middle) / rate**2
        low, high = (middle, high) if value < goal else (low, middle)
    return low


@pytest.mark.parametrize(("hits", "leaves"), [(0.1, 0.0980391403), (1.0, 0.8328697923)])
def test_hunt_and_crossley_leave_the_speed_of_the_closed_form(hits, leaves):
    assert left_over(hits) == pytest.approx(leaves, abs=1e-10)
    wall = CompliantContact(P, O, N.x, N, lambda gap, rate: hunt_crossley(gap, rate, 1e4, 0.3))
    system = System(Definition(N, [x], [v], bodies=[me.Particle("P", P, m)], loads=wall.loads))
    system.initial_conditions = {x: 0.01, v: -hits}
    system.ode_solver, system.times = "dop853", np.linspace(0.0, 0.4, 2)
    out = system.simulate(events=wall.events, rtol=1e-13, atol=1e-16)
    assert len(out.events) == 2
    assert out["v"][-1] == pytest.approx(leaves, abs=1e-9)


def test_a_contact_does_not_pull():
    gap, rate = sm.symbols("gap rate")
    inside = {gap: -0.1, rate: 100.0}
    assert hunt_crossley(gap, rate, 100.0, 0.3).subs(inside) == 0
    assert kelvin_voigt(gap, rate, 100.0, 0.3).subs(inside) == 0
    assert kelvin_voigt(gap, rate, 100.0, 0.3, pulls=True).subs(inside) == pytest.approx(-20.0)
    assert kelvin_voigt(gap, rate, 100.0, 0.3, pulls=True).subs({gap: 0.1, rate: 1.0}) == 0


def test_a_normal_force_starts_and_ends_smoothly_where_it_says_so():
    gap, rate = sm.symbols("gap rate")
    slope = sm.diff(hunt_crossley(gap, rate, 100.0, 0.3), gap)
    assert abs(slope.subs({gap: -1e-12, rate: 1.0}).doit()) < 1e-3


def test_kelvin_and_voigt_are_a_damped_oscillator_for_half_a_period():
    # Without clipping, x = e^(−δt) sin(ωt)/ω · v until x crosses zero again: e = exp(−δπ/ω).
    k, c = 100.0, 2.0
    wall = CompliantContact(P, O, N.x, N, lambda g, r: kelvin_voigt(g, r, k, c, pulls=True))
    system = System(Definition(N, [x], [v], bodies=[me.Particle("P", P, m)], loads=wall.loads))
    system.initial_conditions = {x: 0.1, v: -1.0}
    system.ode_solver, system.times = "dop853", [0.0, 1.0]
    out = system.simulate(events=wall.events, rtol=1e-12, atol=1e-14)
    decay = c / 2
    omega = math.sqrt(k - decay**2)
    assert out["v"][-1] == pytest.approx(math.exp(-decay * math.pi / omega), abs=1e-8)


def test_brown_and_mcphee_have_their_peak_at_the_transition_speed():
    s = sm.Symbol("s")
    friction = brown_mcphee(s, 10.0, 0.2, 0.1, mu_static=0.3)
    values = -np.array([float(friction.subs(s, 0.1 * k / 100)) for k in range(80, 121)])
    assert 95 <= 80 + values.argmax() <= 105
    assert values.max() == pytest.approx(3.0, rel=1e-3)
    assert float(friction.subs(s, 100.0)) == pytest.approx(-2.0, rel=1e-5)
    assert float(sm.diff(friction, s).subs(s, 0)) == pytest.approx(-10 * (8.0 + 16.0 / 9.0))
    sliding = brown_mcphee(0.3, 10.0, 0.2, 0.1, viscous=2.0, normal_transition=5.0)
    assert float(sliding) == pytest.approx(-2.0 * math.tanh(12) - 0.6 * math.tanh(8.0))


def test_stribecks_friction_falls_from_static_to_kinetic():
    s = sm.Symbol("s")
    tustin = stribeck(s, 10.0, 0.2, 0.4, 0.01, exponent=1, viscous=3.0)
    value = -10 * (0.2 + 0.2 * math.exp(-2.0)) - 3.0 * 0.02
    assert float(tustin.subs(s, 0.02)) == pytest.approx(value)
    assert float(tustin.subs(s, -0.02)) == pytest.approx(-value)
    smooth = stribeck(s, 10.0, 0.2, 0.4, 0.01, transition=0.001)
    assert float(sm.diff(smooth, s).subs(s, 0)) == pytest.approx(-4000.0)


def test_torques_against_rolling_and_in_a_joint():
    assert float(rolling_resistance(-5.0, 10.0, 0.002, 0.1)) == pytest.approx(0.02)
    # tan φ = 0.75: the friction circle has the radius r sin φ = 0.6 r.
    assert float(joint_friction(10.0, 100.0, 0.75, 0.02, 1e-3)) == pytest.approx(-1.2)


def test_loads_push_two_bodies_apart_and_rub_in_a_plane():
    z, w = me.dynamicsymbols("z w")
    Q = O.locatenew("Q", x * N.x + z * N.y)
    Q.set_vel(N, v * N.x + w * N.y)
    contact = CompliantContact(
        Q, O, N.y, N, lambda g, r: -1000 * g, lambda s, n: -0.5 * n, along=N.x, reaction=True
    )
    (first, push), (second, pull) = contact.loads
    assert (first, second) == (Q, O)
    assert push + pull == 0
    assert contact.friction_forces[0].subs(z, -0.01) == pytest.approx(-5.0)
    space = CompliantContact(
        Q, O, N.y, N, lambda g, r: 10, lambda s, n: -0.5 * n, along=(N.x, N.z), smoothing=1e-6
    )
    assert float(space.friction_forces[0].subs(v, 2.0)) == pytest.approx(-5.0)
    assert float(space.friction_forces[0].subs(v, 0.0)) == 0.0


def test_wrong_arguments_are_named():
    with pytest.raises(TypeError, match="`stiffness` must be an expression or a number"):
        hunt_crossley(x, v, "k", 0.3)
    with pytest.raises(TypeError, match="`pulls` must be True or False"):
        kelvin_voigt(x, v, 1.0, 1.0, pulls=2)
    with pytest.raises(TypeError, match="`point` must be a Point"):
        CompliantContact(x, O, N.x, N, lambda g, r: 1)
    with pytest.raises(ValueError, match="`friction` and `along` belong together"):
        CompliantContact(P, O, N.x, N, lambda g, r: 1, lambda s, n: -n)
    with pytest.raises(ValueError, match="`smoothing` must be given with two vectors"):
        CompliantContact(P, O, N.x, N, lambda g, r: 1, lambda s, n: -n, along=(N.y, N.z))
    with pytest.raises(TypeError, match="`force` must be a function"):
        CompliantContact(P, O, N.x, N, 3.0)
    with pytest.raises(ValueError, match=r"`normal` must be of unit length, got 2\*N.x"):
        CompliantContact(P, O, 2 * N.x, N, lambda g, r: 1)
    with pytest.raises(ValueError, match=r"`along` must be of unit length, got N.y \+ N.z"):
        CompliantContact(P, O, N.x, N, lambda g, r: 1, lambda s, n: -n, along=N.y + N.z)
    with pytest.raises(TypeError, match="`along` must be one Vector or two"):
        CompliantContact(P, O, N.x, N, lambda g, r: 1, lambda s, n: -n, along=3)
    slope = sm.cos(0.1) * N.y + sm.sin(0.1) * N.x
    with pytest.raises(ValueError, match="`along` must lie in the plane, orthogonal to the normal"):
        CompliantContact(P, O, N.x, N, lambda g, r: 1, lambda s, n: -n, along=slope)


@pytest.mark.parametrize(
    ("argument", "law"),
    [
        ("stiffness", lambda value: hunt_crossley(x, v, value, 0.3)),
        ("damping", lambda value: hunt_crossley(x, v, 1e3, value)),
        ("exponent", lambda value: hunt_crossley(x, v, 1e3, 0.3, value)),
        ("stiffness", lambda value: kelvin_voigt(x, v, value, 0.3)),
        ("damping", lambda value: kelvin_voigt(x, v, 1e3, value)),
        ("normal", lambda value: brown_mcphee(v, value, 0.3, 0.01)),
        ("normal", lambda value: stribeck(v, value, 0.3, 0.4, 0.1)),
        ("normal", lambda value: rolling_resistance(v, value, 0.01, 0.01)),
        ("normal", lambda value: joint_friction(v, value, 0.3, 0.1, 0.01)),
        ("mu", lambda value: brown_mcphee(v, 1.0, value, 0.01)),
        ("mu_static", lambda value: brown_mcphee(v, 1.0, 0.3, 0.01, mu_static=value)),
        ("viscous", lambda value: brown_mcphee(v, 1.0, 0.3, 0.01, viscous=value)),
        ("mu", lambda value: stribeck(v, 1.0, value, 0.4, 0.1)),
        ("mu_static", lambda value: stribeck(v, 1.0, 0.3, value, 0.1)),
        ("arm", lambda value: rolling_resistance(v, 1.0, value, 0.01)),
        ("mu", lambda value: joint_friction(v, 1.0, value, 0.1, 0.01)),
        ("radius", lambda value: joint_friction(v, 1.0, 0.3, value, 0.01)),
    ],
)
def test_negative_numbers_of_a_law_are_refused_by_name(argument, law):
    for value in (-0.1, sm.Rational(-1, 10), np.float64(-0.1)):
        with pytest.raises(ValueError, match=rf"`{argument}` must (not be negative|be positive)"):
            law(value)
    law(sm.Symbol("k"))  # its value is that of a constant
    law(0.2)
