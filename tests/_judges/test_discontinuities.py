"""Prescribed motions that jump, or their derivatives: the equations lose the impulse."""

from contextlib import suppress

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.errors import IntegrationError, PyDyUserWarning
from pydy.mechanics import Definition
from zoo import inertial_frame

T = me.dynamicsymbols._t
X, V, Z = me.dynamicsymbols("x v z")
K, A, B = sm.symbols("K a b")


def carried(motion, damper=False):
    """A mass on a spring to the ground, at x in a frame that moves by z: (x + z)" = -(x + z)."""
    frame, origin = inertial_frame()
    place = origin.locatenew("P", (X if damper else X + Z) * frame.x)
    place.set_vel(frame, (V if damper else V + Z.diff(T)) * frame.x)
    force = -K * (V - Z.diff(T)) if damper else -K * (X + Z)
    loads, bodies = [(place, force * frame.x)], [me.Particle("b", place, 1)]
    system = System(Definition(frame, [X], [V], bodies=bodies, loads=loads), ode_solver="dop853")
    system.times = [0.0, 1.0]
    system.specifieds = {Z: motion}
    system.constants = dict.fromkeys(system.constants_symbols, 1.0)
    return system


KINKS = [
    (sm.Max(0, T - A / 2), r"a derivative of `specifieds\[z\(t\)\]` jumps by 1"),
    (sm.Abs(2 * T - A), r"a derivative of `specifieds\[z\(t\)\]` jumps by 4"),
    (
        sm.Piecewise((0, T < A / 2), (T - B / 2, True)),
        r"a derivative of `specifieds\[z\(t\)\]` jumps by 1",
    ),
    (sm.Heaviside(T - A / 2), r"`specifieds\[z\(t\)\]` jumps by 1"),
    (sm.floor(2 * T) / 3, r"`specifieds\[z\(t\)\]` jumps by 0.333"),
]


@pytest.mark.parametrize(("motion", "what"), KINKS)
def test_an_impulse_that_is_lost_is_told(motion, what):
    system = carried(motion)
    with pytest.warns(PyDyUserWarning, match=rf"At t = 0.\S* {what}\. The equations") as told:
        system.integrate()
    assert len(told) == 1


@pytest.mark.parametrize(
    ("motion", "damper"),
    [
        (sm.Max(0, T - A / 2) ** 2, False),
        (T**3 * sm.Piecewise((1, T < 2), (0, True)), False),
        (sm.Piecewise((0, T < A / 2), ((T - B / 2) ** 2, True)), False),
        (sm.sin(3 * T) * sm.Abs(K), False),
        (sm.Max(0, T - A / 2), True),  # its rate alone is in the equations
    ],
)
def test_what_is_lost_nowhere_is_not(motion, damper):
    system = carried(motion, damper)
    states = system.integrate()  # a warning would be an error
    if not damper:  # x + z oscillates as if nothing moved
        z, rate = (
            sm.lambdify(T, e.subs({A: 1, B: 1, K: 1}).doit(), "numpy")
            for e in (motion, motion.diff(T))
        )
        start, slope = float(z(0.0)), float(rate(1e-12))
        expected = start * np.cos(1.0) + slope * np.sin(1.0)
        assert states[-1, 0] + float(z(1.0)) == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("inertia", [0.0, 0.5])
def test_steering_is_told_of_an_impulse_only_where_its_acceleration_acts(inertia):
    """A car's wheel that a ramp turns: its δ'' moves the car by the wheel's own inertia alone."""
    psi, r, steer, I = *me.dynamicsymbols("psi r delta"), sm.Symbol("I")
    frame, origin = inertial_frame()
    car = frame.orientnew("C", "Axis", (psi, frame.z))
    wheel = car.orientnew("W", "Axis", (steer, car.z))
    axle = origin.locatenew("F", 1.2 * car.x)
    bodies = [
        me.RigidBody("car", origin, car, 1, (me.inertia(car, 0, 0, 2), origin)),
        me.RigidBody("wheel", axle, wheel, 1, (me.inertia(wheel, 0, 0, I), axle)),
    ]
    method = Definition(frame, [psi], [r], bodies=bodies, loads=[(axle, wheel.y)])
    ramp = sm.Max(0, T - A / 2)
    system = System(method, {I: inertia, A: 1.0}, {steer: ramp}, "dop853", times=[0.0, 1.0])
    if not inertia:
        (_, (angle, _)) = system.integrate()  # a warning would be an error
        # r' = 1.2 cos δ / (2 + 1.2²), with δ = 0 in the first half second
        expected = 1.2 / (2.0 + 1.2**2) * (0.5**2 / 2 + 0.5**2 + 1 - np.cos(0.5))
        assert angle == pytest.approx(expected, rel=1e-6)
        return
    with pytest.warns(PyDyUserWarning, match=r"a derivative of `specifieds\[delta\(t\)\]` jumps"):
        system.integrate()


@pytest.mark.parametrize(
    ("row", "what"),
    [
        (V - sm.Heaviside(T - A / 2), "the velocity constraint 0 jumps by 1"),
        (X - 1 - sm.floor(2 * T), "the holonomic constraint 0 jumps by 1"),
        (V - sm.Max(0, T - A / 2), None),
        (V - sm.Piecewise((0, X < 3), (1, True)), None),
    ],
)
def test_constraints_that_jump_in_time_are_told(row, what):
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    y, w = me.dynamicsymbols("y w")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", X * frame.x + y * frame.y)
    kind = "nonholonomic_constraints" if row.has(V) else "holonomic_constraints"
    system = System(
        Definition(frame, [X, y], [V, w], bodies=[me.Particle("b", place, 1)], **{kind: [row]}),
        initial_conditions={X: 1.0}, ode_solver="dop853", times=[0.0, 0.9],
    )  # fmt: skip
    if what is None:
        system.simulate(constraints="project")  # a warning would be an error
        return
    with pytest.warns(PyDyUserWarning, match=what), suppress(IntegrationError):
        system.simulate(constraints="project")


@pytest.mark.parametrize(
    "drag",
    [
        lambda v: -sm.Max(v, 0) - sm.Min(v, 0),
        lambda v: -sm.Abs(v) * sm.sign(v),
        lambda v: -sm.Symbol("c1") * sm.Max(v, 0) - sm.Symbol("c2") * sm.Min(v, 0),
        lambda v: -sm.Max(v, 0) - sm.Min(sm.sin(v), 0),
        lambda v: -sm.Abs(sm.exp(-v) - 1) * sm.sign(v),
        lambda v: -sm.sign(v) * sm.Max(sm.Abs(v), v**2),
        lambda v: -sm.Max(v - (sm.Symbol("c1") - 1), 0) - sm.Min(v + (sm.Symbol("c1") - 1), 0),
    ],
    ids=[
        "max and min",
        "abs and sign",
        "two dampers",
        "sine",
        "exponential",
        "squared",
        "no backlash",
    ],
)
def test_a_slope_that_both_sides_have_is_that_of_the_linear_model(drag):
    system = particle_with(drag(V))
    system.constants = dict.fromkeys(system.constants_symbols, 1.0)
    assert system.linearize(at={}).A[1, 1] == -1.0  # a warning would be an error
    sweep = system.eigenvalues({sm.Symbol("m"): [1.0, 2.0]}, at={})
    np.testing.assert_allclose(sweep.A[:, 1, 1], [-1.0, -0.5])


@pytest.mark.parametrize(
    "drag",
    [
        -sm.Abs(V) - sm.Max(sm.sin(V), 0),
        -sm.Max(V, 0) - 3 * sm.Min(sm.tan(V), 0),
        -sm.Max(sm.Abs((X - 1) * V), sm.Abs((sm.cos(X) - 2) * V)),
    ],
)
def test_a_kink_where_several_terms_switch_is_told(drag):
    with pytest.warns(PyDyUserWarning, match="There is no linear model for both sides") as told:
        particle_with(drag).linearize(at={})
    assert len(told) == 1


def particle_with(force, *more, directions=(X,), speeds=(V,)):
    """A particle of mass m with a force along x, and others along y."""
    frame, origin = inertial_frame()
    axes = list(frame)[: len(directions)]
    position = sum(q * axis for q, axis in zip(directions, axes, strict=True))
    velocity = sum(u * axis for u, axis in zip(speeds, axes, strict=True))
    point = origin.locatenew("P", position)
    point.set_vel(frame, velocity)
    load = sum(f * axis for f, axis in zip((force, *more), axes, strict=True))
    body = me.Particle("b", point, sm.Symbol("m"))
    definition = Definition(frame, directions, speeds, bodies=[body], loads=[(point, load)])
    return System(definition, constants={sm.Symbol("m"): 1.0})


Y, W = me.dynamicsymbols("y w")


@pytest.mark.parametrize("slope", [1e-9, 10.0, 1e12])
def test_a_slope_that_a_protected_division_hides_is_told(slope):
    sliding = sm.sqrt(V**2 + W**2)
    friction = sm.Piecewise((0, sm.Eq(sliding, 0)), (-sm.tanh(slope * sliding) / sliding, True))
    system = particle_with(friction * V, friction * W, directions=(X, Y), speeds=(V, W))
    message = rf"slope {-slope:.3g} by v\(t\) on both sides, but 0 is returned".replace("+", r"\+")
    with pytest.warns(PyDyUserWarning, match=message) as told:
        system.linearize(at={})
    assert len(told) == 1
    with pytest.warns(PyDyUserWarning, match=message):
        system.eigenvalues({sm.Symbol("m"): [1.0, 2.0]}, at={})
    system.linearize(at={V: 1e-6 / slope})  # a warning would be an error


def test_a_protected_division_whose_branch_is_right_is_not_told():
    ratio = sm.Piecewise((1, sm.Eq(V, 0)), (sm.sin(V) / V, True))
    assert particle_with(-X * ratio).linearize(at={}).A[1].tolist() == [-1.0, 0.0]
