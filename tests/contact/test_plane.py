"""Friction in a plane in space, against closed forms."""

import math

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import solve_ivp

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.contact.complementarity import (
    SLIDING,
    STARTING,
    STICKS,
    ComplementarityProblem,
    select_modes,
)
from pydy.mechanics import Definition
from zoo.touching import TIGHT, N, O, g, m, mu, slope

x, y, z = me.dynamicsymbols("x y z")
vx, vy, vz = me.dynamicsymbols("v_x v_y v_z")
P = O.locatenew("P", x * N.x + y * N.y + z * N.z)
P.set_vel(N, vx * N.x + vy * N.y + vz * N.z)


def puck():
    """A particle on a plane that falls towards +x; speeds are given at the first time."""
    pull = m * g * (sm.sin(slope) * N.x - sm.cos(slope) * N.z)
    system = System(
        Definition(
            N, [x, y, z], [vx, vy, vz], bodies=[me.Particle("puck", P, m)], loads=[(P, pull)]
        ),
        {g: 9.81}, {}, "dop853", {}, np.linspace(0.0, 2.0, 21),
    )  # fmt: skip
    ice = Unilateral(z, name="ice")
    return Contacts(system, [Stick(P, on=ice, mu=mu, along=(N.x, N.y))])


def test_a_puck_stops_where_it_should():
    contacts = puck()
    contacts.system.constants.update({slope: 0.0, mu: 0.3})
    contacts.system.initial_conditions = {vx: 0.6, vy: 0.8}
    motion = contacts.simulate(**TIGHT)
    (stops,) = motion.events
    assert stops.name == "ice stops"
    assert stops.time == pytest.approx(1 / (0.3 * 9.81), abs=1e-10)
    assert motion.states[-1, :2] == pytest.approx(
        np.array([0.6, 0.8]) / (2 * 0.3 * 9.81), abs=1e-10
    )
    assert motion["ice_friction_2"][0] == pytest.approx(-0.8 * 0.3 * 9.81)
    assert [modes["ice"] for *_, modes in motion.modes] == ["slides", "sticks"]
    total = motion.energy[:, 2]
    assert total - total[0] == pytest.approx(motion.contact_work, abs=1e-9)


def test_directions_that_were_computed_are_orthogonal_to_rounding():
    across = np.cross([0.3, -0.8, 0.1], [1.0, 0.2, 0.7])
    rest = np.cross([0.3, -0.8, 0.1], across)
    axes = [v / np.linalg.norm(v) for v in (across, rest)]
    first, second = (float(v[0]) * N.x + float(v[1]) * N.y + float(v[2]) * N.z for v in axes)
    assert first.dot(second) != 0
    Stick(P, mu=0.3, normal=1.0, along=(first, second))
    with pytest.raises(ValueError, match="`along` must be orthogonal vectors"):
        Stick(P, mu=0.3, normal=1.0, along=(N.x, 0.8 * N.y + 0.6 * N.x))


def test_a_puck_that_crosses_a_slope_turns_downhill():
    # With μ = tan θ, v + v_x is constant: pushed across, it ends with half of its speed.
    contacts = puck()
    contacts.system.constants.update({slope: 0.4, mu: math.tan(0.4)})
    contacts.system.initial_conditions = {vy: 1.0}
    motion = contacts.simulate(**TIGHT)
    speed = np.hypot(motion["v_x"], motion["v_y"])
    assert speed + motion["v_x"] == pytest.approx(np.ones(21), abs=1e-9)
    assert speed[-1] == pytest.approx(0.5, abs=1e-3)
    assert not motion.events
    # With more friction it stops, and stays.
    contacts.system.constants[mu] = 1.5 * math.tan(0.4)
    motion = contacts.simulate(**TIGHT)
    (stops,) = motion.events
    # σ' = −μ g cos θ + g sin θ cos φ, σ φ' = −g sin θ sin φ: both are integrated from φ = π/2.
    k = 1.5
    pull = 9.81 * math.sin(0.4)
    time = k / (pull * (k**2 - 1))
    assert stops.time == pytest.approx(time, abs=1e-8)
    after = motion.times > stops.time
    assert np.ptp(motion["x"][after]) <= 1e-12


def test_a_ball_with_spin_rolls_after_a_parabola():
    r = 0.03
    w1, w2 = me.dynamicsymbols("w1 w2")
    a1, a2 = me.dynamicsymbols("a1 a2")
    # Rotations of a sphere only matter by their rates: two rotors stand for it.
    C = O.locatenew("C", x * N.x + y * N.y + z * N.z)
    C.set_vel(N, vx * N.x + vy * N.y + vz * N.z)
    one, two = me.ReferenceFrame("one"), me.ReferenceFrame("two")
    one.orient_axis(N, N.x, a1)
    two.orient_axis(N, N.y, a2)
    one.set_ang_vel(N, w1 * N.x)
    two.set_ang_vel(N, w2 * N.y)
    inertia = sm.Rational(2, 5) * m * r**2
    bodies = [
        me.RigidBody("one", C, one, m / 2, (me.inertia(one, inertia, 0, 0), C)),
        me.RigidBody("two", C, two, m / 2, (me.inertia(two, 0, inertia, 0), C)),
    ]
    system = System(
        Definition(
            N, [x, y, z, a1, a2], [vx, vy, vz, w1, w2], bodies=bodies, loads=[(C, -m * g * N.z)]
        ),
        {g: 9.81}, {}, "dop853", {z: r, vx: 1.0, w1: -40.0}, np.linspace(0.0, 0.6, 7),
    )  # fmt: skip
    table = Unilateral(z - r, name="table")
    stick = Stick((vx - r * w2, vy + r * w1), on=table, mu=0.2)
    motion = Contacts(system, [stick]).simulate(**TIGHT)
    slip = np.array([1.0, -40.0 * r])
    size = np.linalg.norm(slip)
    (rolls,) = motion.events
    assert rolls.time == pytest.approx(2 * size / (7 * 0.2 * 9.81), abs=1e-10)
    ends = np.array([1.0, 0.0]) - 2 / 7 * slip
    assert motion[["v_x", "v_y"]][-1] == pytest.approx(ends, abs=1e-10)


def test_sliding_begins_along_the_acceleration_whatever_the_mobility():
    square = np.array([[1.0, 0.1, 0.2], [0.1, 3.0, 0.5], [0.2, 0.5, 1.0]])
    problem = ComplementarityProblem(
        np.array([-9.81, 4.0, 3.0]), square, [0], [[1, 2]], np.array([0.1]), np.array([0.1]),
        np.zeros(1), frozenset([0]), frozenset([0]),
    )  # fmt: skip
    found = select_modes(problem, [[STICKS, STARTING]])
    assert found.modes == (STARTING,)
    rate = found.rates[1:]
    assert found.forces[1:] == pytest.approx(-0.1 * found.forces[0] * rate / np.linalg.norm(rate))
    assert found.rates[0] == pytest.approx(0.0, abs=1e-12)


def test_many_bodies_begin_to_slide_beside_one_that_slides_already():
    # 2^30 combinations: forces tell which, and count on the friction of the one that slides.
    number, mu = 31, np.full(31, 0.3)
    free = np.tile([-9.81, 7.0, 0.0], number)
    rows = [[k, k + 1, k + 2] for k in range(0, 3 * number, 3)]
    problem = ComplementarityProblem(
        free, np.eye(len(free)) + 0.01, [row[0] for row in rows], [row[1:] for row in rows], mu, mu,
        np.zeros(number), frozenset(range(1, number)), frozenset(), {0: np.array([0.0, 1.0])},
    )  # fmt: skip
    found = select_modes(problem, [[SLIDING], *[[STICKS, STARTING]] * (number - 1)])
    assert found.modes == (SLIDING, *[STARTING] * (number - 1))
    forces, rates = (np.reshape(part, (number, 3)) for part in (found.forces, found.rates))
    assert rates[:, 0] == pytest.approx(0.0, abs=1e-12)
    assert forces[0, 1:] == pytest.approx([0.0, -0.3 * forces[0, 0]], abs=1e-12)
    along = rates[1:, 1:] / np.linalg.norm(rates[1:, 1:], axis=1)[:, None]
    assert forces[1:, 1:] == pytest.approx(-0.3 * forces[1:, :1] * along)


def test_a_particle_that_is_thrown_on_the_ice_sticks_or_slides_by_the_cone():
    contacts = puck()
    contacts.system.constants.update({slope: 0.0, mu: 0.5})
    contacts.system.initial_conditions = {z: 0.1, vx: 0.6, vy: 0.8}
    contacts.system.times = [0.0, 1.0]
    motion = contacts.simulate(**TIGHT)
    hits = math.sqrt(2 * 9.81 * 0.1)
    (time, impulses), *_ = motion.impacts
    assert time == pytest.approx(hits / 9.81, abs=1e-10)
    assert impulses["ice"] == pytest.approx((hits, -0.5 * hits * 0.6, -0.5 * hits * 0.8), abs=1e-9)
    contacts.system.constants[mu] = 0.8
    (_, impulses), *_ = contacts.simulate(**TIGHT).impacts
    assert impulses["ice"] == pytest.approx((hits, -0.6, -0.8), abs=1e-9)


def test_a_bead_on_a_slanted_wire_rebounds_though_its_contact_rubs():
    # One freedom: it slides back along the wire, opposite to how it came.
    s, v = me.dynamicsymbols("s v")
    bead = O.locatenew("bead", s * (0.48 * N.x - 0.64 * N.y + 0.6 * N.z))
    bead.set_vel(N, v * (0.48 * N.x - 0.64 * N.y + 0.6 * N.z))
    wire = Definition(N, [s], [v], bodies=[me.Particle("bead", bead, 2)])
    system = System(wire, {}, {}, "dop853", {s: 1.0, v: -3.0}, [0.0, 1.0])
    floor = Unilateral(0.6 * s, restitution=0.5, name="floor")
    contacts = Contacts(system, [Stick(bead, on=floor, mu=0.3, along=(N.x, N.y))])
    motion = contacts.simulate(**TIGHT)
    assert motion["v"][-1] == pytest.approx(1.5, abs=1e-12)
    ((time, impulses),) = [(t, told["floor"]) for t, told in motion.impacts]
    assert time == pytest.approx(1 / 3, abs=1e-12)
    pushes = impulses[0] * (0.6 - 0.3 * 0.8)  # friction along the wire: 0.8 of μ times the normal
    assert pushes == pytest.approx(2 * 4.5, abs=1e-9)
    assert impulses[1:] == pytest.approx(0.3 * impulses[0] * np.array([-0.6, 0.8]), abs=1e-9)


def pulled(static, tolerance):
    """A block under a pull that grows and turns."""
    F, t = sm.Symbol("F"), me.dynamicsymbols._t
    pull = -m * g * N.z + F * t * N.x + F * t**2 * N.y
    system = System(
        Definition(
            N, [x, y, z], [vx, vy, vz], bodies=[me.Particle("block", P, m)], loads=[(P, pull)]
        ),
        {g: 9.81, F: 1.0}, {}, "dop853", {}, np.linspace(0.0, 3.0, 4),
    )  # fmt: skip
    floor = Unilateral(z, name="floor")
    stick = Stick(P, on=floor, mu=0.2, mu_static=static, along=(N.x, N.y))
    return Contacts(system, [stick]).simulate(rtol=tolerance, atol=1e-2 * tolerance)


def test_a_block_that_is_pulled_slips_where_the_pull_reaches_the_cone():
    motion = pulled(0.3, 1e-8)
    (slips,) = motion.events
    # t² + t⁴ = (0.3 · 9.81)²
    whole = (0.3 * 9.81) ** 2
    assert slips.time == pytest.approx(math.sqrt((math.sqrt(1 + 4 * whole) - 1) / 2), abs=1e-10)
    assert motion["v_y"][-1] > motion["v_x"][-1] > 0.0
    total = motion["floor_friction_1"] ** 2 + motion["floor_friction_2"] ** 2
    assert math.sqrt(total[-1]) == pytest.approx(0.2 * 9.81)


@pytest.mark.parametrize("static", [0.2, 0.21])
def test_how_a_block_begins_to_slide_is_found_to_tolerance(static):
    # Long first steps of an implicit method would hide errors of 1e-5 at any tolerance.
    coarse, fine = pulled(static, 1e-6), pulled(static, 1e-8)
    assert coarse.states[-1] == pytest.approx(fine.states[-1], abs=5e-6)
    assert [event.name for event in fine.events] == ["floor slips"]


@pytest.mark.parametrize("tolerance", [1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_a_block_that_is_pulled_from_rest_goes_along_the_pull(tolerance, solver):
    # Errors of the direction at the least speeds are kept: they were 1e-5 at 1e-12.
    body = me.Particle("body", P, 1)
    system = System(
        Definition(N, [x, y, z], [vx, vy, vz], bodies=[body], loads=[(P, 10 * N.x + N.y / 10)]),
        times=[0.0, 3.0], ode_solver=solver,
    )  # fmt: skip
    rubs = Stick((vx, vy), mu=0.3, normal=10.0, name="rubs")
    motion = Contacts(system, [rubs]).simulate(rtol=tolerance, atol=tolerance)
    pull = np.array([10.0, 0.1])
    wanted = pull * (1.0 - 3.0 / np.linalg.norm(pull)) * 4.5
    assert motion.states[-1, :2] == pytest.approx(wanted, abs=1e-9)


@pytest.mark.parametrize(("turns", "most"), [(30.0, 1.3), (40.0, 1.5)])
def test_a_body_that_turns_as_it_begins_to_slide_does_not_stop_there(turns, most):
    # A pull that turns and dies out. Over 20 s, its speeds are those of a body that only begins.
    t = me.dynamicsymbols._t
    pull = most * sm.exp(-((10 * t - 5) ** 2)) * (sm.cos(turns * t) * N.x + sm.sin(turns * t) * N.y)
    body = me.Particle("body", P, 1)
    system = System(
        Definition(N, [x, y, z], [vx, vy, vz], bodies=[body], loads=[(P, pull)]),
        times=[0.0, 20.0],
        ode_solver="dop853",
    )
    rubs = Stick((vx, vy), mu=1.0, normal=1.0, name="rubs")
    motion = Contacts(system, [rubs]).simulate(rtol=1e-10, atol=1e-10, max_step=0.02)

    def rates(t, state):
        speed, force = np.hypot(*state[2:]), most * np.exp(-((10 * t - 5) ** 2))
        along = np.array([np.cos(turns * t), np.sin(turns * t)])
        return [*state[2:], *(force * along - state[2:] / speed)]

    begins = 0.5 - np.sqrt(np.log(most)) / 10
    rest = lambda t, state: np.hypot(*state[2:]) - 1e-9 if t > begins + 0.05 else 1.0  # noqa: E731
    rest.terminal = True
    start = [0, 0, 1e-9 * np.cos(turns * begins), 1e-9 * np.sin(turns * begins)]
    options = {"method": "Radau", "rtol": 1e-9, "atol": 1e-13, "max_step": 2e-3, "events": rest}
    truth = solve_ivp(rates, (begins, 1.0), start, **options)
    assert motion.events[-1].time == pytest.approx(truth.t[-1], abs=1e-6)
    assert motion.states[-1, :2] == pytest.approx(truth.y[:2, -1], abs=1e-7)


@pytest.mark.parametrize(
    ("number", "spin", "speed"), [(3, 2.0, 0.5), (3, -4.0, 0.2), (4, 2.0, 0.5)]
)
def test_a_body_on_several_feet_comes_to_rest_on_all_of_them_at_once(number, spin, speed):
    turn, rate, inertia = *me.dynamicsymbols("turn rate"), sm.Symbol("J")
    B = me.ReferenceFrame("B")
    B.orient_axis(N, N.z, turn)
    B.set_ang_vel(N, rate * N.z)
    C = O.locatenew("C", x * N.x + y * N.y)
    C.set_vel(N, vx * N.x + vy * N.y)
    feet = []
    for j in range(number):
        angle = 2 * math.pi * j / number
        feet.append(C.locatenew(f"F{j}", math.cos(angle) * B.x + math.sin(angle) * B.y))
        feet[-1].v2pt_theory(C, N, B)
    body = me.RigidBody("tripod", C, B, m, (me.inertia(B, 0, 0, inertia), C))
    system = System(
        Definition(N, [x, y, turn], [vx, vy, rate], bodies=[body]),
        {inertia: 0.4}, {}, "dop853", {vx: speed, rate: spin}, np.linspace(0.0, 3.0, 31),
    )  # fmt: skip
    sticks = [
        Stick(foot, normal=m * g / number, mu=mu, along=(N.x, N.y), name=foot.name) for foot in feet
    ]
    motion = Contacts(system, sticks, {mu: 0.2, g: 9.81}).simulate(rtol=1e-9, atol=1e-10)
    assert {event.name for event in motion.events} == {f"F{j} stops" for j in range(number)}
    assert set(motion.modes[-1][2].values()) == {"sticks"}
    total = motion.energy[:, 2]
    assert total - total[0] == pytest.approx(motion.contact_work, abs=1e-8)
    assert abs(motion.states[-1, 3:]).max() < 1e-12
