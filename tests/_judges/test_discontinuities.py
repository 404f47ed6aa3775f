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
