"""Wheels that leave the ground: the normal force pushes only, and the times of flights."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import BrushTire, WheelContact
from pydy.vehicles.wheel_arguments import normal_force_of
from zoo import inertial_frame
from zoo.wheels import planar_wheel

R, M, I, G, K = 0.3, 40.0, 1.2, 9.81, 1e5


def dropped(law, height, *, speed=0.0, spin=0.0, times, tire=None):
    wheel = planar_wheel(M, I)
    (x, z, q), (vx, vz, w) = wheel.q, wheel.u
    N, O, C, body = wheel.N, wheel.O, wheel.C, wheel.body
    contact = WheelContact(body, N.y, R, O, N.z, N, law)
    system = System(
        Definition(
            N, [x, z, q], [vx, vz, w], bodies=[body],
            loads=[(C, -M * G * N.z), *contact.loads(tire)],
        ),
        ode_solver="dop853",
        initial_conditions={z: R + height, vx: speed, w: spin},
        times=times,
    )  # fmt: skip
    system.outputs = {"gap": contact.gap, "load": contact.normal_force}
    return system.simulate(events=contact.events, rtol=1e-12, atol=1e-12)


def test_a_wheel_on_a_spring_bounces_at_the_times_of_the_closed_form():
    height = 0.05
    fall, rate, omega = np.sqrt(2 * height / G), np.sqrt(2 * height * G), np.sqrt(K / M)
    pressed = 2 / omega * (np.pi - np.arctan(rate * omega / G))
    times = np.linspace(0.0, 3 * fall + 2 * pressed + 0.05, 400)
    # The law is linear: without a limit it would pull the wheel down.
    motion = dropped(lambda gap, rate: -K * gap, height, times=times)
    expected = np.array([fall, fall + pressed, 3 * fall + pressed, 3 * fall + 2 * pressed])
    assert [e.time for e in motion.events] == pytest.approx(expected, rel=1e-9)
    assert motion["load"].min() == 0.0
    assert (motion["load"][motion["gap"] > 0] == 0.0).all()
    assert motion["load"].max() > M * G
    assert motion["z"].max() == pytest.approx(R + height, rel=1e-9)


def test_a_damper_neither_pulls_nor_acts_before_the_wheel_touches():
    motion = dropped(lambda gap, rate: -K * gap - 2e3 * rate, 0.2, times=np.linspace(0.0, 0.6, 601))
    assert motion["load"].min() == 0.0
    assert (motion["load"][motion["gap"] > 0] == 0.0).all()
    # It falls freely until it touches, at z' = −√(2 g h).
    first = motion.events[0]
    assert first.time == pytest.approx(np.sqrt(0.4 / G), rel=1e-9)


def test_a_wheel_in_the_air_keeps_its_spin_and_its_speed():
    times = np.linspace(0.0, 0.5, 501)
    tire = BrushTire(M * G, stiffness=4e3, friction=0.9)
    motion = dropped(
        lambda gap, rate: -K * gap - 200 * rate, 0.1, speed=5.0, spin=30.0, times=times, tire=tire
    )
    touches, lifts = motion.events[:2]
    before, flies = times < touches.time, (times > lifts.time) & (motion["gap"] > 0)
    assert flies.any()
    for name, value in (("vx", 5.0), ("w", 30.0)):
        np.testing.assert_allclose(motion[name][before], value, rtol=1e-12)
    flight = times[flies] < motion.events[2].time if len(motion.events) > 2 else slice(None)
    for name in ("vx", "w"):
        assert np.ptp(motion[name][flies][flight]) < 1e-11
    assert motion["vx"][-1] > 5.0


@pytest.mark.parametrize(
    ("law", "limited"),
    [
        (lambda gap, rate: sm.Max(-K * gap - 10 * rate, 0), False),
        (lambda gap, rate: -K * gap, True),
        (lambda gap, rate: 100.0, False),
    ],
)
def test_only_a_law_that_may_be_negative_is_limited(law, limited):
    N, O = inertial_frame()
    z, w = me.dynamicsymbols("z w")
    W = me.ReferenceFrame("W")
    W.orient_axis(N, N.y, w)
    C = O.locatenew("C", z * N.z)
    body = me.RigidBody("wheel", C, W, M, (me.inertia(W, 0, I, 0), C))
    force = WheelContact(body, N.y, R, O, N.z, N, law).normal_force
    assert force.has(sm.Piecewise) == limited


DEPTH = 0.002


@pytest.mark.parametrize(
    "soft",
    [
        lambda gap: K * DEPTH * sm.log(1 + sm.exp(-gap / DEPTH)),
        lambda gap: sm.Symbol("k") * (sm.sqrt(gap**2 + DEPTH**2) - gap) / 2,
        lambda gap: sm.Symbol("k") * DEPTH * sm.log(1 + sm.exp(-gap / DEPTH)),
    ],
    ids=["softplus", "hyperbola", "softplus with a constant"],
)
def test_a_smooth_law_stays_smooth_where_the_wheel_touches(soft):
    gap, rate, k = sm.symbols("gap rate k")
    force = normal_force_of(lambda gap, rate: soft(gap) * (1 - sm.tanh(rate)), gap, rate)
    given = {rate: -0.5, k: K}
    before, after = (float(force.subs({gap: g, **given})) for g in (1e-9, -1e-9))
    assert before == pytest.approx(after, rel=1e-5)
    assert before == pytest.approx(
        float((soft(gap) * (1 + sm.tanh(0.5))).subs({gap: 0, k: K})), rel=1e-5
    )


@pytest.mark.parametrize(
    "law",
    [
        lambda gap, rate: sm.Max(-K * gap, 0) - 10 * rate,
        lambda gap, rate: sm.Symbol("k") * (-gap) - sm.Symbol("c") * rate,
        lambda gap, rate: K * DEPTH * sm.log(1 + sm.exp(-gap / DEPTH)) - 10 * rate,
        lambda gap, rate: sm.Function("measured")(gap),
        lambda gap, rate: K * (-gap) ** 1.5,
        lambda gap, rate: K * gap**2,
        lambda gap, rate: sm.Symbol("k") * gap**2 * (1 - sm.tanh(rate)),
    ],
)
def test_a_law_that_may_pull_does_not_act_in_the_air(law):
    gap, rate = sm.symbols("gap rate")
    for speed in (-5.0, 5.0):
        assert normal_force_of(law, gap, rate).subs({gap: 0.01, rate: speed}) == 0


@pytest.mark.parametrize("lean", [0.2, -0.05, 0.0])
def test_a_cylinder_touches_at_the_time_at_which_its_lower_edge_does(lean):
    height, width = 0.05, 0.2
    N, O = inertial_frame()
    z, vz = me.dynamicsymbols("z vz")
    W = me.ReferenceFrame("W")
    W.orient_axis(N, N.x, lean)
    C = O.locatenew("C", z * N.z)
    C.set_vel(N, vz * N.z)
    body = me.RigidBody("wheel", C, W, M, (me.inertia(W, 0, I, 0), C))
    contact = WheelContact(body, W.y, R, O, N.z, N, lambda gap, rate: -K * gap, width=width)
    lowest = R * np.cos(lean) + width / 2 * abs(np.sin(lean))
    fall = np.sqrt(2 * height / G)
    system = System(
        Definition(N, [z], [vz], bodies=[body], loads=[(C, -M * G * N.z), *contact.loads()]),
        ode_solver="dop853",
        initial_conditions={z: lowest + height},
        times=np.linspace(0.0, 2 * fall, 50),
    )
    (event,) = contact.events
    motion = system.simulate(events=[event], rtol=1e-11, atol=1e-11)
    assert motion.events[0].time == pytest.approx(fall, rel=1e-9)
    # Its expression crosses zero with a slope, that of the height.
    step = 1e-4
    values = [float(event.expression.subs(z, lowest + side * step)) for side in (1, -1)]
    assert values == pytest.approx([step, -step], rel=1e-9)
    if lean:
        assert abs(float(contact.gap.subs(z, lowest - step))) < 0.1 * step
