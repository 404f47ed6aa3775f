"""Exact contacts against closed forms."""

import math

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System, solvers
from pydy.contact import Contacts, Stick, Unilateral
from pydy.errors import ContactError, PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.solvers import Event
from zoo.touching import (
    TIGHT,
    J,
    N,
    O,
    a,
    ball,
    billiard_ball,
    block,
    e,
    falling_body,
    g,
    k,
    m,
    mu,
    r,
    slope,
    vx,
    vy,
    w,
    x,
    y,
)

T = me.dynamicsymbols._t


def balance(trajectory):
    """The change of energy beyond the work of contacts, and whether energy falls all the time."""
    total = trajectory.energy[:, 2]
    size = abs(total).max()
    assert (np.diff(total) <= 1e-9 * size).all()
    return abs(total - total[0] - trajectory.contact_work).max() / size


def test_a_billiard_ball_slides_then_rolls():
    trajectory = billiard_ball().simulate(**TIGHT)
    (rolls,) = trajectory.events
    assert rolls.name == "table stops"
    assert rolls.time == pytest.approx(0.291247997670, abs=1e-10)
    assert rolls.after[0] == pytest.approx(0.499282281720, abs=1e-10)
    assert trajectory["v_x"][-1] == pytest.approx(10 / 7, abs=1e-10)
    assert [modes["table"] for *_, modes in trajectory.modes] == ["slides +", "sticks"]
    assert trajectory["table_friction"][[0, -1]] == pytest.approx([-0.2 * 9.81, 0.0], abs=1e-12)
    assert balance(trajectory) < 1e-9


@pytest.mark.parametrize("size", [1.0, 1e-9, 1.5e11])
@pytest.mark.parametrize("squared", [False, True])
def test_a_particle_leaves_a_dome_at_two_thirds_of_its_height(size, squared):
    # Its weight and its centripetal acceleration cancel there: neither is small.
    P = O.locatenew("P", x * N.x + y * N.y)
    system = System(
        Definition(N, [x, y], [vx, vy], bodies=[me.Particle("P", P, m)], loads=[(P, -m * g * N.y)]),
        {m: 0.1, g: 9.81 * size}, ode_solver="dop853", times=np.linspace(0.0, 3.0, 11),
        initial_conditions={x: 2.0 * size * math.sin(0.1), y: 2.0 * size * math.cos(0.1)},
    )  # fmt: skip
    gap = (x**2 + y**2 - r**2) / (2 * r) if squared else sm.sqrt(x**2 + y**2) - r
    contacts = Contacts(system, [Unilateral(gap, name="dome")], {r: 2.0 * size})
    trajectory = contacts.simulate(rtol=1e-11, atol=1e-11 * size)
    (leaves,) = trajectory.events
    assert leaves.name == "dome opens"
    assert leaves.after[1] / (2.0 * size) == pytest.approx(2 / 3 * math.cos(0.1), abs=1e-10)
    assert trajectory.modes[-1][2] == {"dome": "open"}


def test_an_oscillator_with_coulombs_friction_stops_dead():
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, vx * N.x)
    system = System(
        Definition(N, [x], [vx], bodies=[me.Particle("P", P, m)], loads=[(P, -k * x * N.x)]),
        {k: 100.0}, ode_solver="dop853",
        initial_conditions={x: 1.0}, times=np.linspace(0.0, 20.0, 201),
    )  # fmt: skip
    rub = Stick(vx, mu=mu, normal=m * g, name="rub")
    trajectory = Contacts(system, [rub], {mu: 0.9, g: 9.81}).simulate(**TIGHT)
    lost = 2 * 0.9 * 9.81 / 100
    turns = [event.after[0] for event in trajectory.events]
    # It turns as long as the spring is stronger than friction, and then stands for good.
    assert len(turns) == 6
    assert turns == pytest.approx([(-1) ** j * (1 - j * lost) for j in range(1, 7)], abs=1e-10)
    times = [event.time for event in trajectory.events]
    assert times == pytest.approx([math.pi / 10 * j for j in range(1, 7)], abs=1e-10)
    assert abs(turns[-2]) > lost / 2 > abs(turns[-1])
    after = trajectory.times > times[-1]
    assert set(trajectory["x"][after]) == {turns[-1]}
    assert balance(trajectory) < 1e-9


def test_impacts_that_accumulate_end_in_contact():
    system, floor = ball(restitution=e)
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 5.0, 51)
    trajectory = Contacts(system, [floor], {e: 0.8}).simulate(rtol=1e-11, atol=1e-13)
    *bounces, rests = trajectory.events
    assert {event.name for event in bounces} == {"floor closes"}
    assert rests.name == "floor rests"
    assert rests.time == pytest.approx(math.sqrt(2 / 9.81) * (1 + 2 * 0.8 / 0.2), abs=1e-10)
    assert trajectory.modes[-1][2] == {"floor": "closed"}
    assert trajectory["floor_normal"][-1] == pytest.approx(9.81)
    assert not trajectory["y"][-5:].any()
    assert trajectory.at(np.linspace(0.0, 5.0, 999))["floor_gap"].min() > -1e-10
    assert balance(trajectory) < 1e-9


@pytest.mark.parametrize("inertia", [0.3, 1e-6])
def test_a_rimless_wheel_keeps_its_gait(inertia):
    half, tilt = math.pi / 8, 0.08
    spokes = [(math.sin(2 * half * j), -math.cos(2 * half * j)) for j in range(-1, 4)]
    system, feet = falling_body(spokes, tilt=slope, mu=mu)

    def gait(inertia):
        ratio = (inertia + math.cos(2 * half)) / (inertia + 1)
        gain = 4 * 9.81 * math.sin(half) * math.sin(tilt) / (inertia + 1)
        return math.sqrt(ratio**2 * gain / (1 - ratio**2))

    assert gait(0.0) == pytest.approx(1.0954628396, abs=1e-10)
    rate = gait(inertia)
    system.constants[J], system.constants[slope] = inertia, -tilt
    system.initial_conditions = {
        a: half, x: -math.sin(half), y: math.cos(half),
        w: -rate, vx: rate * math.cos(half), vy: rate * math.sin(half),
    }  # fmt: skip
    system.times = np.linspace(0.0, 2.2, 12)
    trajectory = Contacts(system, feet, {mu: 5.0}).simulate(**TIGHT)
    impacts = [event for event in trajectory.events if event.name.endswith("closes")]
    assert len(impacts) == 2
    assert [-event.after[5] for event in impacts] == pytest.approx([rate] * 2, abs=1e-9)
    assert balance(trajectory) < 1e-9


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_two_feet_that_touch_down_at_the_same_instant(restitution):
    system, feet = falling_body([(-1, -0.2), (1, -0.2)], restitution=restitution, mu=mu)
    system.initial_conditions = {y: 1.0, vx: 0.5}
    system.times = np.linspace(0.0, 3.0, 31)
    system.constants[J] = 0.4
    trajectory = Contacts(system, feet, {mu: 0.3}).simulate(rtol=1e-10, atol=1e-12)
    first, second = trajectory.events[:2]
    assert first.time == second.time == pytest.approx(math.sqrt(2 * 0.8 / 9.81), abs=1e-10)
    assert abs(trajectory["a"]).max() < 1e-12
    assert trajectory.modes[-1][2] == {"foot0": "sticks", "foot1": "sticks"}
    assert trajectory["foot0_normal"][-1] == pytest.approx(9.81 / 2)
    assert balance(trajectory) < 1e-9


def test_a_block_on_a_slope_does_not_creep():
    system, P = block(slope)
    system.times, system.constants[slope] = np.linspace(0.0, 60.0, 61), 0.3
    ground = Unilateral(y, name="ground")
    stick = Stick(P, on=ground, mu=mu, along=N.x)
    trajectory = Contacts(system, [ground, stick], {mu: 0.4}).simulate()
    assert abs(trajectory.states).max() <= 1e-12
    assert not trajectory.events


def test_a_block_in_a_grip_does_not_creep_and_its_fingers_share_the_weight():
    q = me.dynamicsymbols("x_b y_b x_l x_r")
    u = me.dynamicsymbols("u_x u_y u_l u_r")
    F = sm.Symbol("F")
    points = []
    for name, place, speed in (
        ("B", q[0] * N.x + q[1] * N.y, u[0] * N.x + u[1] * N.y),
        ("L", q[2] * N.x, u[2] * N.x),
        ("R", q[3] * N.x, u[3] * N.x),
    ):
        points.append(O.locatenew(name, place))
        points[-1].set_vel(N, speed)
    B, L, R = points
    system = System(
        Definition(
            N, q, u, bodies=[me.Particle(P.name, P, m) for P in points],
            loads=[(B, -m * g * N.y), (L, F * N.x), (R, -F * N.x)],
        ),
        {g: 9.81, F: 20.0}, ode_solver="dop853",
        initial_conditions={q[2]: -0.05, q[3]: 0.05}, times=np.linspace(0.0, 60.0, 61),
    )  # fmt: skip
    left = Unilateral(q[0] - q[2] - 0.05, name="left")
    right = Unilateral(q[3] - q[0] - 0.05, name="right")
    sticks = [Stick(B, on=gap, mu=mu, along=N.y) for gap in (left, right)]
    trajectory = Contacts(system, [left, right, *sticks], {mu: 0.5}).simulate()
    assert abs(trajectory["y_b"]).max() <= 1e-12
    assert trajectory["left_normal"] == pytest.approx(20.0)
    # The two rows that hold it say the same: the forces are the least ones.
    assert trajectory["left_friction"] == pytest.approx(9.81 / 2)
    assert trajectory["right_friction"] == pytest.approx(9.81 / 2)
    # Held too loosely, it falls at a constant acceleration.
    system.constants[F] = 5.0
    falls = Contacts(system, sticks).simulate()
    assert set(falls.modes[0][2].values()) == {"slides -"}
    assert falls["y_b"][-1] == pytest.approx(-0.5 * (9.81 - 5.0) * 3600.0, rel=1e-8)


def test_painleves_paradox_is_named():
    system, feet = falling_body([(-1.0, 0.0)], mu=mu)
    lean = 0.9
    system.constants[J], system.times = 1 / 3, [0.0, 0.3]
    system.initial_conditions = {a: lean, x: math.cos(lean), y: math.sin(lean), vx: -1.0}
    contacts = Contacts(system, feet, {mu: 0.5})
    contacts.simulate()
    # J + 1 cos a (cos a − μ sin a) < 0
    system.constants[mu] = 1.1 * (1 / 3 + math.cos(lean) ** 2) / (math.cos(lean) * math.sin(lean))
    with pytest.raises(ContactError, match=r"Painlevé's paradox.*'foot0'.*state x\(t\) = 0.62"):
        contacts.simulate()


def test_a_contact_in_a_mechanism_with_constraints():
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, vx * N.x + vy * N.y)
    bob = me.Particle("P", P, m)
    bound = System(
        Definition(
            N, [x, y], [vx, vy], bodies=[bob], loads=[(P, -m * g * N.y)],
            holonomic_constraints=[x**2 + y**2 - 1],
        ),
        {g: 9.81}, ode_solver="dop853",
        initial_conditions={x: 0.6, y: -0.8}, times=np.linspace(0.0, 3.0, 31),
    )  # fmt: skip
    wall = {"name": "wall", "restitution": 0.7}
    one = Contacts(bound, [Unilateral(x, **wall)])
    one = one.simulate(constraints="project", rtol=1e-11, atol=1e-12)
    B = me.ReferenceFrame("B")
    B.orient_axis(N, N.z, a)
    B.set_ang_vel(N, w * N.z)
    Q = O.locatenew("Q", -B.y)
    Q.v2pt_theory(O, N, B)
    free = System(
        Definition(N, [a], [w], bodies=[me.Particle("P", Q, m)], loads=[(Q, -m * g * N.y)]),
        {g: 9.81}, ode_solver="dop853",
        initial_conditions={a: math.asin(0.6)}, times=np.linspace(0.0, 3.0, 31),
    )  # fmt: skip
    two = Contacts(free, [Unilateral(sm.sin(a), **wall)]).simulate(rtol=1e-11, atol=1e-12)
    assert one["x"] == pytest.approx(np.sin(two["a"]), abs=1e-9)
    assert len(one.events) == len(two.events) == 3
    assert abs(one.constraints).max() < 1e-12
    assert one.outputs_symbols[-1] in one.constraints_symbols


def test_constraints_of_the_system_do_not_drift_from_impact_to_impact(recwarn):
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, vx * N.x + vy * N.y)
    bound = System(
        Definition(
            N, [x, y], [vx, vy], bodies=[me.Particle("P", P, m)], loads=[(P, -m * g * N.y)],
            holonomic_constraints=[x**2 + y**2 - 1],
        ),
        {g: 9.81}, ode_solver="dop853",
        initial_conditions={x: -0.6, y: -0.8}, times=np.linspace(0.0, 20.0, 31),
    )  # fmt: skip
    motion = Contacts(bound, [Unilateral(0.3 - x, restitution=0.95)]).simulate()
    assert len(motion.events) > 5
    assert abs(motion.constraints).max() < 1e-12
    assert not recwarn.list


def test_a_belt_lets_a_block_stick_and_slip():
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, vx * N.x)
    system = System(
        Definition(N, [x], [vx], bodies=[me.Particle("P", P, m)], loads=[(P, -k * x * N.x)]),
        {k: 1.0}, {}, "dop853", {vx: 0.1}, np.linspace(0.0, 60.0, 601),
    )  # fmt: skip
    belt, static = sm.symbols("belt static")
    rub = Stick(vx - belt, mu=mu, mu_static=static, normal=1, name="belt")
    contacts = Contacts(system, [rub], {belt: 0.1, mu: 0.5, static: 1.0})
    trajectory = contacts.simulate(**TIGHT)
    slips = [event.time for event in trajectory.events if event.name == "belt slips"]
    # It sticks for 1 m at 0.1 m/s, and slides on an ellipse about x = 0.5.
    period = 10.0 + math.pi + 2 * math.atan(0.2)
    assert slips[0] == pytest.approx(10.0, abs=1e-10)
    assert np.diff(slips) == pytest.approx(np.full(len(slips) - 1, period), abs=1e-10)
    assert contacts.compiled_modes == [{"belt": "sticks"}, {"belt": "slides -"}]


@pytest.mark.parametrize("units", [(1.0, 1.0, 1.0), (1e-9, 1.0, 1.0), (1.5e11, 1e30, 3e7)])
def test_a_floor_and_a_stop_for_an_angle_hold_in_any_units(units):
    length, mass, time = units
    P, Q, B = O.locatenew("P", y * N.y), me.Point("Q"), me.ReferenceFrame("B")
    P.set_vel(N, vy * N.y)
    B.orient_axis(N, N.z, a)
    Q.set_pos(O, 5 * r * N.x + r * B.x)
    Q.set_vel(N, r * w * B.y)
    bodies = [me.Particle("weight", P, m), me.Particle("arm", Q, m)]
    system = System(
        Definition(N, [y, a], [vy, w], bodies=bodies, loads=[(p, -m * g * N.y) for p in (P, Q)]),
        {m: mass, g: 9.81 * length / time**2, r: length}, ode_solver="dop853",
        initial_conditions={y: 0.5 * length, a: 0.5}, times=np.linspace(0.0, time, 3),
    )  # fmt: skip
    contacts = Contacts(system, [Unilateral(y, name="floor"), Unilateral(a, name="stop")])
    atol = 1e-12 * np.array([length, 1.0, length / time, 1.0 / time])
    motion = contacts.simulate(rtol=1e-10, atol=atol)
    assert [event.time / time for event in motion.events] == pytest.approx(
        [0.31927542840705, 0.3348094220717], abs=1e-10
    )
    weight = mass * system.constants[g]
    assert motion["floor_normal"][-1] == pytest.approx(weight)
    assert motion["stop_normal"][-1] == pytest.approx(weight * length)


@pytest.mark.parametrize("pebble", [1e-6, 1e-18])
@pytest.mark.parametrize("order", [1, -1])
def test_a_truck_slips_though_a_pebble_beside_it_holds(pebble, order):
    # 2.9e6 N hold the truck; the pebble's forces are nothing beside them, but its own.
    X, Y = me.dynamicsymbols("X Y")
    u = me.dynamicsymbols("u_x u_y U_x U_y")
    P, Q = O.locatenew("P", x * N.x + y * N.y), O.locatenew("Q", X * N.x + Y * N.y)
    P.set_vel(N, u[0] * N.x + u[1] * N.y)
    Q.set_vel(N, u[2] * N.x + u[3] * N.y)
    pull = 4e6 * me.dynamicsymbols._t * N.x - 9.81e6 * N.y
    tilted = -9.81 * pebble * (math.cos(0.1) * N.y + math.sin(0.1) * N.x)
    bodies = [me.Particle("truck", P, 1e6), me.Particle("pebble", Q, pebble)]
    system = System(
        Definition(N, [x, y, X, Y], u, bodies=bodies, loads=[(P, pull), (Q, tilted)]),
        ode_solver="dop853", times=np.linspace(0.0, 2.0, 3),
    )  # fmt: skip
    floors = [Unilateral(y, name="road"), Unilateral(Y, name="slope")][::order]
    sticks = [
        Stick(p, on=f, mu=0.3, along=N.x) for p, f in zip([P, Q][::order], floors, strict=True)
    ]
    motion = Contacts(system, [*floors, *sticks]).simulate(rtol=1e-10, atol=1e-12)
    slips = 0.3 * 9.81 / 4
    assert [(r.name, r.time) for r in motion.events] == [("road slips", pytest.approx(slips))]
    assert motion["x"][-1] == pytest.approx(4 / 6 * (2 - slips) ** 3, rel=1e-9)
    assert abs(motion["X"][-1]) < 1e-12


def test_the_result_is_a_trajectory(tmp_path):
    system, floor = ball(restitution=0.5)
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 2.0, 21)
    system.outputs[sm.Symbol("height")] = 2 * y
    apex = solvers.Event(vy, direction=-1, name="apex")
    contacts = Contacts(system, [floor])
    trajectory = contacts.simulate(events=[apex])
    assert [event.name for event in trajectory.events[:4]] == [
        *("apex", "floor closes", "apex", "floor closes")
    ]
    assert trajectory["height"] == pytest.approx(2 * trajectory["y"])
    assert trajectory.derivatives.shape == (21, 2)
    middle = trajectory.at([0.31, 0.47, 1.5])
    assert middle["height"] == pytest.approx(2 * middle["y"])
    assert trajectory.to_dataframe().shape[0] == 21
    trajectory.plot(["y", "floor_normal"])
    low = solvers.Event(y - 0.5, direction=-1, terminal=True)
    ended = contacts.simulate(events=[low])
    assert ended.times[-1] <= math.sqrt(1 / 9.81) < ended.times[-1] + 0.1
    assert contacts.compiled_modes == [{"floor": "open"}, {"floor": "closed"}]


def test_bad_input_is_named():
    with pytest.raises(ValueError, match=r"`restitution` must be from 0 to 1, got 1.5"):
        Unilateral(y, restitution=1.5)
    with pytest.raises(ValueError, match=r"`mu` must not be negative, got -0.1"):
        Stick(vx, mu=-0.1, normal=1)
    with pytest.raises(ValueError, match="`mu_static` must not be below `mu`"):
        Stick(vx, mu=0.5, mu_static=0.4, normal=1)
    with pytest.raises(ValueError, match="`on` or `normal` must say what presses"):
        Stick(vx, mu=0.5)
    with pytest.raises(TypeError, match="`along` must be one Vector or two if `point` is a Point"):
        Stick(O, mu=0.5, normal=1)
    with pytest.raises(ValueError, match="`along` must be orthogonal"):
        Stick(O, mu=0.5, normal=1, along=(N.x, N.x + N.y))
    with pytest.raises(ValueError, match=r"`along` must be of unit length, got 2\*N.x"):
        Stick(O, mu=0.5, normal=1, along=2 * N.x)
    with pytest.raises(TypeError, match="must be a speed or a pair of them"):
        Stick((vx, vy, w), mu=0.5, normal=1)
    with pytest.raises(ValueError, match="`gap` must depend on coordinates"):
        Unilateral(-1.0)
    system, floor = ball(restitution=e)
    with pytest.raises(ValueError, match="must have different names, got 'floor' twice"):
        Contacts(system, [floor, Unilateral(y + 1, name="floor")])
    with pytest.raises(ValueError, match="must depend on coordinates, got v_y"):
        Contacts(system, [Unilateral(vy)])
    with pytest.raises(ValueError, match="moves with no speed"):
        Contacts(system, [Unilateral(m)])
    with pytest.raises(ValueError, match="must be linear in the speeds"):
        Contacts(system, [Stick(vy**2, mu=1, normal=1)])
    contacts = Contacts(system, [floor])
    system.times, system.initial_conditions = [0.0, 1.0], {y: -0.5}
    with pytest.raises(ValueError, match=r"gap of 'floor' must not be negative .*, got -0.5"):
        contacts.simulate()
    system.initial_conditions = {y: 0.5}
    system.constants[e] = 1.5
    with pytest.raises(ValueError, match=r"`restitution` of 'floor' must be from 0 to 1, got 1.5"):
        contacts.simulate()
    system.constants[e] = 0.5
    with pytest.raises(NotImplementedError, match="resets are not supported"):
        contacts.simulate(events=[solvers.Event(vy, reset={vy: 0})])
    system.ode_solver = None
    with pytest.raises(ValueError, match="native solver"):
        contacts.simulate()


def test_contacts_that_exclude_each_other_are_named():
    system, floor = ball()
    ceiling = Unilateral(-y - 1, name="ceiling")
    system.times = [0.0, 1.0]
    with pytest.raises(ValueError, match=r"gap of 'ceiling' must not be negative"):
        Contacts(system, [floor, ceiling]).simulate()
    # A ceiling that comes down on a ball that stands on the floor.
    t = me.dynamicsymbols._t
    press = Unilateral(1 - t - y, name="press")
    system.times = [0.0, 2.0]
    system.times = [0.0, 0.5, 2.0]
    with pytest.raises(ContactError, match=r"Jamming: .*At t = 1\.0") as caught:
        Contacts(system, [floor, press]).simulate()
    trajectory = caught.value.trajectory
    assert trajectory.times.tolist() == [0.0, 0.5]
    assert trajectory.modes[-1][2]["press"] == "open"
    with pytest.raises(ValueError, match="failed where this motion ends"):
        trajectory.continue_to(3.0)


def over_a_bump(unit, height, gap=None):
    """A particle that flies level over a narrow bump at x = 5, with one step for the whole way."""
    far = x / unit - 5
    gap = y - unit * sm.exp(-100 * far**2) if gap is None else gap
    point = O.locatenew("P", x * N.x + y * N.y)
    system = System(
        Definition(N, [x, y], [vx, vy], bodies=[me.Particle("P", point, 1)]),
        initial_conditions={x: 0.0, y: height * unit, vx: unit},
        times=[0.0, 10.0],
        ode_solver="dop853",
    )
    contacts = Contacts(system, [Unilateral(gap, restitution=1, name="bump")])
    return contacts.simulate(rtol=1e-10, atol=1e-10 * unit)


@pytest.mark.parametrize("unit", [1.0, 1e-9, 1e9])
@pytest.mark.parametrize("height", [0.1, 0.9, 0.999])
def test_a_gap_that_closes_and_would_open_within_a_step_is_seen(unit, height):
    motion = over_a_bump(unit, height)
    before = math.sqrt(-math.log(height) / 100)
    (closes,) = motion.events
    assert closes.time == pytest.approx(5 - before, rel=1e-12)
    normal = np.array([-200 * before * height, 1.0])
    normal /= np.linalg.norm(normal)
    bounced = np.array([1.0, 0.0]) - 2 * normal[0] * normal
    end = motion.states[-1] / unit
    np.testing.assert_allclose(end[2:], bounced, atol=1e-9)
    way = [5 - before, height] + (5 + before) * bounced
    np.testing.assert_allclose(end[:2], way, atol=1e-8)


def test_a_gap_that_nearly_closes_within_a_step_is_none():
    motion = over_a_bump(1.0, 1.0 + 1e-9)
    assert not motion.events
    np.testing.assert_allclose(motion.states[-1], [10.0, 1.0 + 1e-9, 1.0, 0.0], rtol=1e-12)


def test_a_gap_that_is_no_number_is_named():
    with pytest.raises(ValueError, match=r"The gap of 'bump' must be a number at .* got nan"):
        over_a_bump(1.0, 1.0, sm.sqrt(x - 2) + y)
    with pytest.raises(ContactError, match=r"the event `\d: speed of the gap of bump`, whose"):
        over_a_bump(1.0, 1.0, sm.sqrt(2 - x) + y)


def test_outputs_that_are_not_finite_are_told_once_over_all_modes():
    system, floor = ball(restitution=0.5)
    system.outputs = {"pace": 1 / vy}
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 3.0, 31)
    with pytest.warns(
        PyDyUserWarning, match="not finite: pace at t = 0.0 .* other samples"
    ) as told:
        trajectory = Contacts(system, [floor]).simulate()
    assert len(told) == 1
    assert len(trajectory.modes) > 1
    assert not np.isfinite(trajectory["pace"][-1])


@pytest.mark.parametrize("depth", [1e-3, 1e-6])
def test_a_swing_that_only_just_reaches_a_wall_hits_it(depth):
    point = O.locatenew("P", x * N.x)
    swing = Definition(N, [x], [vx], bodies=[me.Particle("P", point, 1)], loads=[(point, -x * N.x)])
    system = System(swing, initial_conditions={x: 1.0}, times=[0.0, 4.0], ode_solver="dop853")
    wall = Unilateral(x + 1 - depth, restitution=0.5, name="wall")
    motion = Contacts(system, [wall]).simulate(rtol=1e-11, atol=1e-11)
    hit = math.acos(depth - 1)
    (closes,) = motion.events
    assert closes.time == pytest.approx(hit, abs=1e-7)
    assert closes.after[1] == pytest.approx(0.5 * math.sin(hit), rel=1e-4)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8, 1e-10])
def test_a_swing_that_only_just_reaches_two_walls_hits_both(tolerance):
    point = O.locatenew("P", x * N.x)
    swing = Definition(N, [x], [vx], bodies=[me.Particle("P", point, 1)], loads=[(point, -x * N.x)])
    system = System(swing, initial_conditions={vx: 1.001}, times=[0.0, 20.0], ode_solver="dop853")
    walls = [Unilateral(1 + way * x, restitution=1, name=str(way)) for way in (-1, 1)]
    motion = Contacts(system, walls).simulate(rtol=tolerance, atol=tolerance)
    expected = math.asin(1 / 1.001) * np.arange(1, 14, 2)
    assert [event.time for event in motion.events] == pytest.approx(expected, abs=1e4 * tolerance)


@pytest.mark.parametrize("solver", ["dop853", "radau"])
@pytest.mark.parametrize(("rate", "excess"), [(7.0, 1e-2), (33.0, 1e-4), (61.0, 1e-6)])
def test_a_block_that_a_load_holds_until_it_exceeds_friction(solver, rate, excess):
    """Its states do not change before: only the load tells how long a step may be."""
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, vx * N.x)
    push = (1 + excess) * sm.sin(rate * me.dynamicsymbols._t)
    system = System(
        Definition(N, [x], [vx], bodies=[me.Particle("P", P, 1)], loads=[(P, push * N.x)]),
        ode_solver=solver, times=[0.0, 1.5],
    )  # fmt: skip
    motion = Contacts(system, [Stick(vx, mu=1, normal=1)]).simulate()
    first = math.asin(1 / (1 + excess)) / rate
    assert motion.events[0].name == "friction slips"
    assert abs(motion.events[0].time - first) < 1e-9


@pytest.mark.parametrize("rate", [5.0, 14.93, 36.5, 59.0])
@pytest.mark.parametrize("unit", [1.0, 1e-9, 1e9])
def test_a_wall_that_moves_by_time_alone_is_hit(rate, unit):
    """Free flight has no error: the wall alone tells how long a step may be."""
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, vx * N.x)
    wall = sm.Float(0.05 * unit) * sm.sin(rate * me.dynamicsymbols._t)
    system = System(
        Definition(N, [x], [vx], bodies=[me.Particle("P", P, 1)]),
        ode_solver="dop853", times=[0.0, 6.0],
        initial_conditions={x: 0.4 * unit, vx: -0.3 * unit},
    )  # fmt: skip
    tight = {"rtol": 1e-10, "atol": 1e-10 * unit}
    motion = Contacts(system, [Unilateral(x - wall, restitution=0.5)]).simulate(**tight)
    # On a grid that is fine enough, the first place where the wall has come past the particle.
    times = np.linspace(0.0, 6.0, num=600001)
    passed = times[np.argmax(0.4 - 0.3 * times < 0.05 * np.sin(rate * times))]
    assert 0 <= passed - motion.events[0].time <= 1e-5
    assert motion.statistics["steps"] < 300


@pytest.mark.parametrize("solver", ["dop853", "radau"])
@pytest.mark.parametrize("rate", [7.0, 23.0, 57.0])
def test_a_floor_with_bumps_is_hit_where_a_flight_first_meets_it(solver, rate):
    """Its height over the floor changes where the states are polynomials."""
    system, P = block()
    del P
    system.ode_solver, system.times = solver, [0.0, 4.0]
    system.initial_conditions = {y: 0.7, vx: 1.3, vy: 0.4}
    floor = Unilateral(y - sm.Float(0.05) * sm.sin(rate * x), restitution=0.5)
    motion = Contacts(system, [floor], {g: 1.0}).simulate(rtol=1e-10, atol=1e-10)
    times = np.linspace(0.0, 4.0, num=400001)
    height = 0.7 + 0.4 * times - times**2 / 2 - 0.05 * np.sin(rate * 1.3 * times)
    assert abs(motion.events[0].time - times[np.argmax(height < 0)]) <= 1e-5


@pytest.mark.parametrize("solver", ["dop853", "radau"])
@pytest.mark.parametrize("kind", ["later", "earlier", "middle", "samples"])
@pytest.mark.parametrize("options", [{}, {"max_step": 1e-2}])
def test_a_load_that_jumps_beyond_friction_sets_a_block_going(solver, kind, options):
    push, t = me.dynamicsymbols("push"), me.dynamicsymbols._t
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, vx * N.x)
    system = System(
        Definition(N, [x], [vx], bodies=[me.Particle("P", P, 1)], loads=[(P, push * N.x)]),
        ode_solver=solver, times=np.linspace(0.0, 4.0, 81),
    )  # fmt: skip
    samples = SampledInput([0.0, 1.013, 5.0], [0.0, 4.0, 4.0], interpolation="previous")
    pushes = {  # by the value at the instant of the jump
        "later": sm.Piecewise((0, t < 1.013), (4, True)),
        "earlier": sm.Piecewise((0, t <= 1.013), (4, True)),
        "middle": 4 * sm.Heaviside(t - 1.013),
        "samples": samples,
    }
    system.specifieds = {push: pushes[kind]}
    motion = Contacts(system, [Stick(vx, mu=0.3, normal=10)]).simulate(**options)
    assert [event.name for event in motion.events] == ["friction slips"]
    assert motion.events[0].time == pytest.approx(1.013, abs=1e-12)
    assert motion["v_x"][-1] == pytest.approx(4.0 - 1.013, abs=1e-9)


@pytest.mark.parametrize("across", [None, 0.0, 0.6])
def test_a_belt_that_slows_down_too_fast_leaves_a_block_behind(across):
    # It runs at 1 m/s, and from 1 s to 1.5 s slows down by 4 m/s² to −1 m/s: the block slides from
    # its 1 m/s to −1 m/s at 3 m/s².
    t = me.dynamicsymbols._t
    belt = sm.Min(1, 2 * t) - sm.Max(0, sm.Min(2, 4 * (t - 1)))
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, vx * N.x + vy * N.y)
    system = System(
        Definition(N, [x, y], [vx, vy], bodies=[me.Particle("P", P, 1)]),
        ode_solver="dop853", initial_conditions={vy: across or 0.0}, times=np.linspace(0, 2, 21),
    )  # fmt: skip
    sliding = vx - belt if across is None else (vx - belt, vy)
    contacts = Contacts(system, [Stick(sliding, mu=mu, normal=10, name="belt")], {mu: 0.3})
    motion = contacts.simulate(sensitivities=[mu], **TIGHT)
    stops = ["belt stops"] if across else []
    assert [event.name for event in motion.events] == [*stops, "belt slips", "belt stops"]
    slips, stops = motion.events[-2:]
    assert slips.time == pytest.approx(1.0, abs=1e-12)
    assert stops.time == pytest.approx(1.0 + 2.0 / 3.0, abs=1e-9)
    assert stops.time_sensitivity == pytest.approx(-2.0 / 0.3 / 3.0, abs=1e-7)
    carried = motion["x"][-1] - motion.at([1.0])["x"][0]
    assert carried == pytest.approx(-1.0 / 3.0, abs=1e-9)  # symmetric, then 1/3 s at −1 m/s


@pytest.mark.parametrize(("number", "height"), [(2, 0.1), (3, 0.01), (3, 0.2), (3, 0.3)])
def test_feet_in_a_row_hold_together_until_all_slip(number, height):
    """The forces that the feet share are not determined: the least ones leave a cone before."""
    B, t = me.ReferenceFrame("B"), me.dynamicsymbols._t
    B.orient_axis(N, N.z, a)
    B.set_ang_vel(N, w * N.z)
    G = O.locatenew("G", x * N.x + y * N.y)
    G.set_vel(N, vx * N.x + vy * N.y)
    H = G.locatenew("H", sm.Float(height - 0.2) * B.y)
    H.v2pt_theory(G, N, B)
    feet = []
    for i, place in enumerate(np.linspace(-0.2, 0.2, number)):
        P = G.locatenew(f"P{i}", sm.Float(place) * B.x - sm.Float(0.2) * B.y)
        P.v2pt_theory(G, N, B)
        floor = Unilateral(P.pos_from(O).dot(N.y), name=f"foot{i}")
        feet.append(Stick(P, on=floor, mu=0.3, along=N.x))
    box = me.RigidBody("box", G, B, 2, (me.inertia(B, 0, 0, sm.Float(0.1)), G))
    loads = [(G, -2 * sm.Float(9.81) * N.y), (H, 4 * t * N.x)]
    system = System(
        Definition(N, [x, y, a], [vx, vy, w], bodies=[box], loads=loads),
        ode_solver="dop853", initial_conditions={y: 0.2}, times=np.linspace(0.0, 3.0, 31),
    )  # fmt: skip
    motion = Contacts(system, feet).simulate()
    slips = 0.3 * 9.81 / 2  # 4 t = mu m g; then x'' = 2 (t - slips)
    assert motion.modes[-1][0] == pytest.approx(slips, abs=1e-9)
    assert motion["x"][-1] == pytest.approx((3.0 - slips) ** 3 / 3, abs=1e-9)


@pytest.mark.parametrize("load", [6, -6])
@pytest.mark.parametrize("floor", [False, True])
def test_a_block_whose_forces_all_begin_with_zero_goes_where_the_load_pulls(load, floor):
    """Which way it slides is told by no force and no acceleration at the first time."""
    system, P = block()
    t = me.dynamicsymbols._t
    pressed = Unilateral(y, name="floor")
    system = System(
        Definition(
            N, [x, y], [vx, vy], bodies=[me.Particle("P", P, 1)],
            loads=[(P, load * t * N.x - 5 * t * N.y)],
        ),
        ode_solver="dop853", times=np.linspace(0.0, 2.0, 5),
    )  # fmt: skip
    press = {"on": pressed} if floor else {"normal": 5 * t}
    contacts = [Stick(P, mu=0.5, along=N.x, **press), *([] if floor else [pressed])]
    motion = Contacts(system, contacts).simulate()
    assert [event.time for event in motion.events] == [0.0]
    assert motion["v_x"] == pytest.approx(np.sign(load) * 3.5 * motion.times**2 / 2, abs=1e-9)


@pytest.mark.parametrize(("press", "load", "slips"), [
    (sm.Max(0, T - 1), 4 * sm.Max(0, T - sm.Rational(3, 2)), 11 / 7), (sm.Max(0, T - 1), 0, None),
    (5 * T, 2 * T, None),
])  # fmt: skip
def test_forces_that_are_zero_for_a_while_tell_nothing(press, load, slips):
    """Margins of friction that rest at zero are no events that are missed: nothing warns."""
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, vx * N.x)
    system = System(
        Definition(N, [x], [vx], bodies=[me.Particle("P", P, 1)], loads=[(P, load * N.x)]),
        ode_solver="dop853", times=np.linspace(0.0, 2.0, 9),
    )  # fmt: skip
    motion = Contacts(system, [Stick(vx, mu=0.5, normal=press)]).simulate()
    found = [event.time for event in motion.events]
    assert found == ([] if slips is None else pytest.approx([slips], abs=1e-9))


@pytest.mark.parametrize("speed", [0.0, 1.0])
def test_a_gap_of_rounding_at_the_start_is_closed(speed):
    system, floor = ball()
    system.initial_conditions, system.times = {y: -2.8e-17, vy: speed}, [0.0, 1.0]
    motion = Contacts(system, [floor]).simulate()
    assert motion["y"][-1] == pytest.approx(0.0, abs=1e-15)
    assert motion.modes[-1][2] == {"floor": "closed"}
    assert motion.modes[-1][0] == pytest.approx(2.0 * speed / 9.81)
    system.initial_conditions = {y: -1e-3}
    with pytest.raises(ValueError, match=r"must not be negative at the first time, got -0\.001"):
        Contacts(system, [floor]).simulate()


def test_times_that_are_all_equal_are_refused():
    system, floor = ball()
    system.times = [0.5, 0.5]
    contacts = Contacts(system, [floor])
    with pytest.raises(ValueError, match=r"two values that differ, got \[0\.5, 0\.5\]"):
        contacts.simulate()


def test_contacts_at_times_that_begin_late():
    # At 1e8 s a rounding of the time moves the ball by 7e-8 m at its impact.
    system, floor = ball(restitution=0.5)
    system.initial_conditions = {y: 1.0}
    heights = []
    for start in (0.0, 1e8):
        system.times = start + np.array([0.0, 0.5, 1.0])
        heights.append(Contacts(system, [floor]).simulate(rtol=1e-8, atol=1e-8)["y"])
    assert heights[1] == pytest.approx(heights[0], abs=1e-6)


def test_symbols_of_events_alone_are_constants_too():
    system, floor = ball(restitution=0.5)
    level = sm.Symbol("level")
    system.initial_conditions, system.times = {y: 1.0}, [0.0, 0.4]
    contacts = Contacts(system, [floor])
    events = [Event(y - level, name="passes")]
    contacts.simulate(events=events)
    system.constants[level] = 0.5
    motion = contacts.simulate(events=events, **TIGHT)
    assert motion.events[0].time == pytest.approx((1.0 / 9.81) ** 0.5)
    made, contacts = contacts._compiled_modes, Contacts(system, [floor])
    contacts.simulate(events=events, **TIGHT)
    assert made.constants == contacts._compiled_modes.constants
    several = system.integrate_ensemble(
        contacts=contacts, events=events, constants={level: [0.5, 0.3]}, reduce="events"
    )
    wanted = [[0.5], [0.7]]
    assert several["passes_times"].values[:, :1] ** 2 * 9.81 / 2 == pytest.approx(np.array(wanted))


@pytest.mark.parametrize("ratio", [0.0, 0.5])
@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_a_gap_without_a_slope_where_it_closes_is_refused(unit, ratio):
    system, _ = ball()
    crank = y / unit  # as an angle
    dead = 4.0 - sm.cos(crank) - sm.sqrt(9.0 - sm.sin(crank) ** 2)  # a slider's way to its end
    for gap, start in ((y**3, 0.5), (y**3, 0.0), (dead, 0.0), (dead - 1e-15, 1.0)):
        system.constants[g], system.times = 9.81 * unit, [0.0, 1.0]
        system.initial_conditions = {y: start * unit, vy: -unit}
        with pytest.raises(ContactError, match=r"has no slope where it closes: .* Write a gap"):
            Contacts(system, [Unilateral(gap, restitution=ratio, name="stop")]).simulate()
    # Shortly before it, the stop is where it was put.
    system.constants[g] = 0.0
    near = 4.0 - sm.cos(0.01) - sm.sqrt(9.0 - sm.sin(0.01) ** 2)
    stop = Unilateral(dead - float(near), restitution=ratio, name="stop")
    system.initial_conditions = {y: unit, vy: -unit}
    (hit,) = Contacts(system, [stop]).simulate(rtol=1e-10, atol=1e-12 * unit).events[:1]
    assert hit.time == pytest.approx(0.99, rel=1e-9)
    assert hit.after[1] == pytest.approx(ratio * unit, abs=1e-9 * unit)


def angle_to_a_wall(gap, **start):
    """A particle without loads, and a wall through the origin, given by the angle to it."""
    system, _ = block()
    system.constants[g], given = 0.0, {k: 0.2} if gap.has(k) else {}
    system.initial_conditions, system.times = start, [0.0, 2.0]
    return Contacts(system, [Unilateral(gap, restitution=0.5, name="wall")], given)


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_an_angle_to_a_wall_is_a_gap(unit):
    angle, start = sm.atan2(y, x), {"x": unit, "y": unit, "v_y": -unit}
    for gap in (angle - k, x * (angle - k), sm.atan2(-y, -x) + sm.pi - k):
        contacts = angle_to_a_wall(gap, **start)
        motion = contacts.simulate(sensitivities=[k], rtol=1e-11, atol=1e-12 * unit)
        (hit,) = motion.events
        assert hit.time == pytest.approx(1.0 - math.tan(0.2), rel=1e-10)
        assert hit.time_sensitivity == pytest.approx([-1.0 / math.cos(0.2) ** 2], rel=1e-9)
        blow = 1.5 * math.cos(0.2)  # along the normal (−sin, cos) of the wall
        speeds = np.array([-math.sin(0.2) * blow, math.cos(0.2) * blow - 1.0]) * unit
        assert hit.after[2:] == pytest.approx(speeds, rel=1e-9)


def test_an_angle_that_jumps_on_the_way_is_refused_but_not_what_is_made_of_it():
    angle, start = sm.atan2(y, x), {"x": -1.0, "y": -0.3, "v_y": 0.5}
    # At −3.3, where the wall is, atan2 is at 2π − 3.3: the wall would be missed.
    with pytest.raises(ContactError, match=r"jumped to 6\.4.* on to 0\.1.*: `atan2\(y\(t\)"):
        angle_to_a_wall(angle + 3.3, **start).simulate()
    away = sm.sqrt(x**2 + y**2) * sm.sin(3.3 + angle)
    (hit,) = angle_to_a_wall(away, **start).simulate(**TIGHT).events
    assert hit.time == pytest.approx((0.3 + math.tan(3.3 - math.pi)) / 0.5, rel=1e-9)


@pytest.mark.parametrize("ratio", [1e-6, 1.0, 1e6])
def test_a_block_on_a_block_that_is_pulled_slips_where_its_friction_ends(ratio):
    xs, ys = me.dynamicsymbols("x:2"), me.dynamicsymbols("y:2")
    us, ws = me.dynamicsymbols("u:2"), me.dynamicsymbols("w:2")
    masses, whole = (1.0, ratio), 1.0 + ratio
    bodies, loads = [], []
    for i, mass in enumerate(masses):
        P = O.locatenew(f"P{i}", xs[i] * N.x + ys[i] * N.y)
        P.set_vel(N, us[i] * N.x + ws[i] * N.y)
        bodies.append(me.Particle(f"block{i}", P, sm.Float(mass)))
        loads.append((P, 10.0 * whole * T * (1 - i) * N.x - 9.81 * mass * N.y))
    system = System(
        Definition(N, [*xs, *ys], [*us, *ws], bodies=bodies, loads=loads),
        ode_solver="dop853", times=[0.0, 1.0],
    )  # fmt: skip
    floor, top = Unilateral(ys[0], name="floor"), Unilateral(ys[1] - ys[0], name="top")
    pairs = [Stick(us[0], on=floor, mu=0.05), Stick(us[1] - us[0], on=top, mu=0.3)]
    motion = Contacts(system, [floor, top, *pairs]).simulate(**TIGHT)
    assert [event.name for event in motion.events] == ["floor slips", "top slips"]
    times = [event.time for event in motion.events]
    assert times == pytest.approx([0.05 * 0.981, 0.35 * 0.981], rel=1e-9)


@pytest.mark.parametrize("begin", [0.0, 1e3, 1e6, 1e9])
def test_a_ball_bounces_at_any_time(begin):
    system, floor = ball(restitution=0.5)
    system.initial_conditions, system.times = {y: 1.0}, begin + np.linspace(0.0, 1.2, 13)
    motion = Contacts(system, [floor]).simulate(rtol=1e-10, atol=1e-12)
    fall = math.sqrt(2.0 / 9.81)
    times = [begin + part * fall for part in (1.0, 2.0, 2.5)]
    assert [event.time for event in motion.events] == pytest.approx(times, rel=1e-15, abs=1e-14)
