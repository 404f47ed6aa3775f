"""Contacts that are told by a geometry: rolling bodies, and joints with play."""

import math

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Clearance, Contacts, Roll
from pydy.mechanics import Definition
from zoo.touching import TIGHT, J, N, O, a, body_in_plane, g, m, mu, r, slope, vx, vy, w, x, y

G = 9.81


def rolling(size=1.0, tilt=0, **options):
    """A ball of radius r in plane motion above a table, and its contact."""
    C, body, _ = body_in_plane()
    pull = -m * g * (sm.sin(tilt) * N.x + sm.cos(tilt) * N.y)
    system = System(
        Definition(N, [x, y, a], [vx, vy, w], bodies=[body], loads=[(C, pull)]),
        {g: G * size, J: 0.4 * (0.1 * size) ** 2}, ode_solver="dop853",
        initial_conditions={y: 0.1 * size}, times=np.linspace(0.0, 0.5, 6),
    )  # fmt: skip
    return system, Roll(body, r, on=O, normal=N.y, along=N.x, mu=mu, name="table", **options)


@pytest.mark.parametrize("size", [1.0, 1e-9, 1.5e11])
def test_a_billiard_ball_slides_then_rolls(size):
    system, ball = rolling(size)
    system.initial_conditions[vx] = 2.0 * size
    contacts = Contacts(system, [ball], {mu: 0.2, r: 0.1 * size})
    motion = contacts.simulate(rtol=1e-12, atol=1e-13 * np.tile([size, size, 1.0], 2))
    (rolls,) = motion.events
    assert rolls.name == "table stops"
    assert rolls.time == pytest.approx(0.291247997670, abs=1e-10)
    assert rolls.after[0] / size == pytest.approx(0.499282281720, abs=1e-10)
    assert motion["v_x"][-1] / size == pytest.approx(10 / 7, abs=1e-10)


@pytest.mark.parametrize("friction", [0.1, 0.3])
def test_a_ball_on_a_slope_rolls_if_friction_holds(friction):
    tilt = 0.5  # holds if μ >= 2/7 tan(tilt) = 0.156
    system, ball = rolling(tilt=slope)
    system.constants[slope] = tilt
    motion = Contacts(system, [ball], {mu: friction, r: 0.1}).simulate(**TIGHT)
    rolls = -5 / 7 * G * math.sin(tilt)
    slides = -G * (math.sin(tilt) - friction * math.cos(tilt))
    assert motion["v_x"][-1] == pytest.approx(0.5 * (slides if friction < 0.156 else rolls))
    assert motion.modes[0][2]["table"] == ("slides -" if friction < 0.156 else "sticks")


def disc_in_space(axis):
    """A body with a centre on x, y, z that turns about two axes, above the plane z = 0."""
    z, vz, turn, lean, w1, w2 = me.dynamicsymbols("z v_z turn lean w1 w2")
    A, B = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    A.orient_axis(N, N.x, lean)
    A.set_ang_vel(N, w2 * N.x)
    B.orient_axis(A, A.y, turn)
    B.set_ang_vel(A, w1 * A.y)
    C = O.locatenew("C", x * N.x + y * N.y + z * N.z)
    C.set_vel(N, vx * N.x + vy * N.y + vz * N.z)
    body = me.RigidBody("disc", C, B, m, (me.inertia(B, J, 2 * J, J), C))
    roll = Roll(body, r, on=O, normal=N.z, along=(N.x, N.y), axis=A.y if axis else None, mu=mu)
    return roll, {z: 1.0, turn: 0.3, lean: 0.4, w1: 2.0, w2: 0.7, vx: 0.0, vy: 0.0, vz: 0.0, r: 0.5}


def test_the_rim_of_a_disc_that_leans_touches_where_it_is_lowest():
    roll, values = disc_in_space(axis=True)
    assert float(roll.on.gap.subs(values)) == pytest.approx(1.0 - 0.5 * math.cos(0.4))
    # The lowest point of the rim is (0, sin, −cos) r from the centre; ω = (w2, w1 cos, w1 sin).
    arm = 0.5 * np.array([0.0, math.sin(0.4), -math.cos(0.4)])
    omega = np.array([0.7, 2.0 * math.cos(0.4), 2.0 * math.sin(0.4)])
    speeds = [float(part.subs(values)) for part in roll.speeds(N)]
    assert speeds == pytest.approx(np.cross(omega, arm)[:2])
    ball, values = disc_in_space(axis=False)
    assert float(ball.on.gap.subs(values)) == pytest.approx(0.5)
    speeds = [float(part.subs(values)) for part in ball.speeds(N)]
    assert speeds == pytest.approx(np.cross(omega, [0.0, 0.0, -0.5])[:2])


def test_a_plane_that_moves_takes_the_ball_along():
    # A ball on a belt that is accelerated by a moves at 2/7 of its acceleration.
    C, body, _ = body_in_plane()
    belt = O.locatenew("belt", 0.5 * me.dynamicsymbols._t**2 * N.x)
    belt.set_vel(N, me.dynamicsymbols._t * N.x)
    system = System(
        Definition(N, [x, y, a], [vx, vy, w], bodies=[body], loads=[(C, -m * g * N.y)]),
        {g: G, J: 0.4 * 0.01}, ode_solver="dop853",
        initial_conditions={y: 0.1}, times=[0.0, 1.0],
    )  # fmt: skip
    roll = Roll(body, 0.1, on=belt, normal=N.y, along=N.x, mu=0.5)
    motion = Contacts(system, [roll]).simulate(**TIGHT)
    assert motion["v_x"][-1] == pytest.approx(2 / 7)


def pin(friction, restitution=0):
    """A pin of radius r in a bush about the origin, with gravity, and its contact."""
    c = sm.Symbol("c")
    C, body, _ = body_in_plane()
    system = System(
        Definition(N, [x, y, a], [vx, vy, w], bodies=[body], loads=[(C, -m * g * N.y)]),
        {g: G, J: 0.5 * 0.01**2}, ode_solver="dop853",
    )  # fmt: skip
    joint = Clearance(
        C, O, radius=r, play=c, axis=N.z, frames=(body.frame, N), mu=friction,
        restitution=restitution, name="pin",
    )  # fmt: skip
    return system, joint, {r: 0.01, c: 0.002}


def test_a_pin_falls_through_its_play_and_rebounds():
    system, joint, values = pin(0, restitution=0.6)
    fall = math.sqrt(2 * 0.002 / G)
    system.times = [0.0, 1.5 * fall]
    closes = Contacts(system, [joint], values).simulate(**TIGHT).events[0]
    assert closes.time == pytest.approx(fall, rel=1e-10)
    assert closes.after[4] == pytest.approx(0.6 * G * fall, rel=1e-9)


def test_a_pin_rolls_in_its_bush_as_a_longer_pendulum():
    system, joint, values = pin(1.0)
    angle = 0.1
    system.initial_conditions = {x: 0.002 * math.sin(angle), y: -0.002 * math.cos(angle)}
    # A disc that rolls in a bush: 3/2 c φ'' = −g sin φ.
    period = 2 * math.pi * math.sqrt(1.5 * 0.002 / G) * (1 + angle**2 / 16 + 11 * angle**4 / 3072)
    system.times = np.linspace(0.0, period, 5)
    motion = Contacts(system, [joint], values).simulate(rtol=1e-11, atol=1e-13)
    assert motion.modes[-1][2] == {"pin": "sticks"}
    assert motion["x"] / 0.002 == pytest.approx(
        math.sin(angle) * np.array([1, 0, -1, 0, 1]), abs=1e-5
    )
    # It turns against the way it goes: r a = −(c φ), measured at the pin.
    assert motion["a"][2] == pytest.approx(2 * angle * 0.002 / 0.01, rel=1e-5)
    total = motion.energy[:, 2]
    assert abs(total - total[0]).max() < 1e-9 * abs(total).max()


def test_a_pin_rebounds_in_large_units_as_in_small_ones():
    # Where the relative tolerance alone counts, it tells more of the gap than the absolute one.
    heights = []
    for size in (1.0, 1e9):
        system, joint, values = pin(0.1, restitution=0.6)
        system.constants = {g: 0.0, J: 0.5 * (0.01 * size) ** 2}
        system.initial_conditions = {x: 6e-4 * size, vx: 0.1 * size, vy: 0.07 * size, w: -30.0}
        system.times = np.linspace(0.0, 0.2, 5)
        contacts = Contacts(system, [joint], {k: v * size for k, v in values.items()})
        heights.append(contacts.simulate(rtol=1e-11, atol=1e-14)["y"] / size)
    assert heights[1] == pytest.approx(heights[0], abs=1e-8)


def test_a_pin_does_not_slide_in_a_bush_that_turns_with_it_though_their_centres_are_apart():
    # Links side by side on a turntable: the whole joint turns about x, across its own axis.
    lean, tilt_rate, spin = me.dynamicsymbols("lean, tilt_rate, spin")
    table, own = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    table.orient_axis(N, N.x, lean)
    table.set_ang_vel(N, tilt_rate * N.x)
    own.orient_axis(table, table.z, a)
    own.set_ang_vel(table, spin * table.z)
    P = O.locatenew("P", x * table.x + y * table.y + 0.5 * table.z)
    P.set_vel(table, vx * table.x + vy * table.y)
    P.v1pt_theory(O, N, table)
    joint = Clearance(P, O, radius=1, play=0.1, axis=table.z, frames=(own, table), mu=0.1)
    (speed,) = joint.speeds(N)
    values = {x: 0.08, y: 0.06, lean: 0.3, a: 0.2, vx: 0.3, vy: 0.7, tilt_rate: 2.0, spin: 0.4}
    assert float(speed.subs(values)) == pytest.approx(-0.6 * 0.3 + 0.8 * 0.7 + 0.4)


def linkage_with_play():
    """A four-bar whose pin between coupler and rocker is loose, which starts amid its bush."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    lengths, base = np.array([0.1, 0.25, 0.2]), 0.28
    ends, bodies = [], []
    for k, (length, mass) in enumerate(zip(lengths, (0.4, 0.3, 0.25), strict=True)):
        start = ends[-1] if k == 1 else O.locatenew(f"S{k}", base * (k // 2) * N.x)
        own = N.orientnew(f"B{k}", "Axis", (q[k], N.z))
        own.set_ang_vel(N, u[k] * N.z)
        centre = start.locatenew(f"C{k}", length / 2 * own.x)
        inertia = (me.inertia(own, 0, 0, mass * length**2 / 12), centre)
        bodies.append(me.RigidBody(f"rod{k}", centre, own, mass, inertia))
        ends.append(start.locatenew(f"E{k}", length * own.x))
    angles, signs = np.array([0.5, 0.7, 1.8]), np.array([1, 1, -1])
    for _ in range(20):
        slopes = lengths * signs * np.array([-np.sin(angles), np.cos(angles)])
        off = [lengths * signs @ np.cos(angles) - base, lengths * signs @ np.sin(angles)]
        angles[1:] -= np.linalg.solve(slopes[:, 1:], off)
    rates = [12.0, *np.linalg.solve(slopes[:, 1:], -slopes[:, 0] * 12.0)]
    system = System(
        Definition(N, q, u, bodies=bodies),
        initial_conditions=dict(zip([*q, *u], [*angles, *rates], strict=True)),
        times=np.linspace(0.0, 0.5, 1001),
        ode_solver="dop853",
    )
    frames = (bodies[1].frame, bodies[2].frame)
    return system, Clearance(
        ends[1], ends[2], radius=5e-3, play=1e-4, axis=N.z, frames=frames, mu=0, restitution=0,
        name="pin",
    )  # fmt: skip


def test_a_pin_that_leaves_its_bush_without_acceleration_is_seen_to_return():
    # Pressed by no more than nothing it begins to leave, with a speed that is a rounding of either
    # sign, and comes back within a quarter of a step.
    system, joint = linkage_with_play()
    contacts = Contacts(system, [joint])
    motion = contacts.simulate(rtol=1e-11, atol=1e-13)
    assert motion["pin_gap"].min() > -1e-10
    total = motion.energy[:, 2]
    assert np.abs(total - total[0] - motion.contact_work).max() < 1e-9 * total[0]
    fine = contacts.simulate(rtol=1e-11, atol=1e-13, max_step=2e-4)
    names = [[event.name for event in one.events] for one in (motion, fine)]
    assert names[0] == names[1]
    times = [[event.time for event in one.events] for one in (motion, fine)]
    np.testing.assert_allclose(times[0], times[1], atol=1e-6)


def test_arguments_of_geometries_are_named():
    C, body, _ = body_in_plane()
    given = {"on": O, "normal": N.y, "along": N.x, "mu": 0.2}
    with pytest.raises(TypeError, match="`body` must be a RigidBody"):
        Roll(C, r, **given)
    with pytest.raises(ValueError, match="`radius` must be positive, got 0"):
        Roll(body, 0, **given)
    with pytest.raises(ValueError, match="`normal` must be of unit length"):
        Roll(body, r, **{**given, "normal": 2 * N.y})
    with pytest.raises(ValueError, match="`normal` must be written in one frame"):
        Roll(body, r, **{**given, "normal": 0.6 * N.y + 0.8 * body.frame.x})
    with pytest.raises(TypeError, match="`along` must be one Vector or two"):
        Roll(body, r, **{**given, "along": None})
    given = {"radius": r, "play": 0.1, "axis": N.z, "frames": (body.frame, N), "mu": 0}
    with pytest.raises(ValueError, match=r"`play` must be positive, got -0\.1"):
        Clearance(C, O, **{**given, "play": -0.1})
    with pytest.raises(TypeError, match="`frames` must be a pair of ReferenceFrames"):
        Clearance(C, O, **{**given, "frames": N})
    with pytest.raises(TypeError, match="`bush` must be a Point"):
        Clearance(C, N, **given)
