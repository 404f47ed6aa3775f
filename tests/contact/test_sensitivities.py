"""Derivatives of motions with contacts, against closed forms and central differences."""

import math
from contextlib import nullcontext

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.errors import ContactError, PyDyUserWarning
from pydy.mechanics import Definition
from zoo.touching import (
    TIGHT,
    J,
    N,
    O,
    a,
    ball,
    billiard_ball,
    e,
    falling_body,
    g,
    k,
    m,
    mu,
    pulled,
    r,
    vx,
    vy,
    x,
    y,
)


def test_when_a_billiard_ball_rolls():
    motion = billiard_ball().simulate(sensitivities=[mu, vx, g], **TIGHT)
    (rolls,) = motion.events
    time = 2 * 2.0 / (7 * 0.2 * 9.81)
    wanted = [-time / 0.2, time / 2.0, -time / 9.81]
    assert rolls.time_sensitivity == pytest.approx(wanted, abs=1e-9)
    # x = v₀ t − μ g t²/2 up to then, and goes on with 5/7 v₀: the time itself does not matter.
    assert motion.sensitivity["x", mu][-1] == pytest.approx(-9.81 * time**2 / 2, abs=1e-9)
    assert motion.sensitivity["v_x"][-1] == pytest.approx([0.0, 5 / 7, 0.0], abs=1e-10)
    assert motion.sensitivity["table_friction", mu][0] == pytest.approx(-9.81)
    assert motion.sensitivity["table_friction", mu][-1] == pytest.approx(0.0, abs=1e-10)
    assert motion.at([0.4]).sensitivity["v_x", vx][0] == pytest.approx(5 / 7, abs=1e-9)


def test_where_an_oscillator_with_coulombs_friction_stops_dead():
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, vx * N.x)
    system = System(
        Definition(N, [x], [vx], bodies=[me.Particle("P", P, m)], loads=[(P, -k * x * N.x)]),
        {k: 100.0}, ode_solver="dop853", initial_conditions={x: 1.0}, times=[0.0, 20.0],
    )  # fmt: skip
    rub = Stick(vx, mu=mu, normal=m * g, name="rub")
    contacts = Contacts(system, [rub], {mu: 0.9, g: 9.81})
    motion = contacts.simulate(sensitivities=[mu, k, x], **TIGHT)
    # x = 1 − 6 · 2 μ g / k at the end, and each half of a cycle takes π/√k.
    lost = 2 * 9.81 / 100
    wanted = [-6 * lost, 6 * lost * 0.9 / 100, 1.0]
    assert motion.sensitivity["x"][-1] == pytest.approx(wanted, abs=1e-9)
    last = motion.events[-1].time_sensitivity
    assert last == pytest.approx([0.0, -6 * math.pi / 2 / 1000, 0.0], abs=1e-10)
    assert abs(motion.sensitivity["v_x"][-1]).max() < 1e-12


def test_how_high_a_ball_bounces():
    system, floor = ball(restitution=e)
    system.initial_conditions, system.times = {y: 1.0}, [0.0, 1.0]
    contacts = Contacts(system, [floor], {e: 0.8})
    motion = contacts.simulate(sensitivities=[e, g, y], **TIGHT)

    def height(e, g, h):
        falls = sm.sqrt(2 * h / g)
        return e * sm.sqrt(2 * g * h) * (1 - falls) - g * (1 - falls) ** 2 / 2

    values = sm.symbols("e g h", positive=True)
    numbers = dict(zip(values, (0.8, 9.81, 1.0), strict=True))
    wanted = [float(height(*values).diff(s).subs(numbers)) for s in values]
    assert motion["y"][-1] == pytest.approx(float(height(*values).subs(numbers)))
    assert motion.sensitivity["y"][-1] == pytest.approx(wanted, abs=1e-9)
    bounce = motion.events[0]
    assert bounce.time_sensitivity[2] == pytest.approx(0.5 * math.sqrt(2 / 9.81), abs=1e-10)


def compared(contacts, parameters, names, steps=1e-5, **options):
    """Sensitivities at the end, and central differences."""
    system = contacts.system
    exact = contacts.simulate(sensitivities=parameters, **options)
    for p in parameters:
        own = system.constants if p in system.constants else None
        start = system.initial_conditions.get(p, 0.0) if own is None else own[p]
        found = []
        for step in (steps, -steps):
            if own is None:
                system.initial_conditions = {**system.initial_conditions, p: start + step}
            else:
                own[p] = start + step
            motion = contacts.simulate(**options)
            found.append(np.array([motion[name][-1] for name in names]))
        if own is None:
            system.initial_conditions = {**system.initial_conditions, p: start}
        else:
            own[p] = start
        slope = (found[0] - found[1]) / (2 * steps)
        own_slope = np.array([exact.sensitivity[name, p][-1] for name in names])
        assert own_slope == pytest.approx(slope, abs=1e-6 * max(1.0, abs(slope).max())), p
    return exact


@pytest.mark.parametrize("hypothesis", ["newton", "poisson"])
@pytest.mark.parametrize(("friction", "end"), [(0.3, 0.8), (2.0, 0.6)])
def test_a_body_that_tumbles_on_two_feet(friction, end, hypothesis):
    system, feet = falling_body([(-1, -0.2), (1, -0.2)], restitution=e, mu=mu)
    system.constants.update({J: 0.4, e: 0.3})
    system.initial_conditions = {y: 1.0, a: 0.4, vx: 1.0}
    system.times = [0.0, end]
    contacts = Contacts(system, feet, {mu: friction}, hypothesis=hypothesis)
    names = ["x", "y", "a", "v_x", "v_y", "w", "foot0_normal"]
    exact = compared(contacts, [mu, e, J, a, vx], names, **TIGHT)
    assert len(exact.impacts) >= 2


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
@pytest.mark.parametrize("right", [1.0, 1.3])
@pytest.mark.parametrize("hypothesis", ["newton", "poisson"])
def test_a_rod_that_comes_down_on_both_ends_until_it_rests(hypothesis, right, tolerance):
    system, ends = falling_body([(-1, 0), (right, 0)], restitution=e, mu=mu)
    system.constants.update({J: 1 / 3, e: 0.5})
    system.initial_conditions, system.times = {y: 0.5, vx: 0.4}, [0.0, 1.2]
    contacts = Contacts(system, ends, {mu: 0.05}, hypothesis=hypothesis)
    motion = contacts.simulate(sensitivities=[e, mu, vx], rtol=tolerance, atol=tolerance)
    assert set(motion.modes[-1][2].values()) == {"sticks"}
    # The first two blows brake it by μ (1 + e) v each; at the third it stops.
    v = math.sqrt(9.81)
    first, second = sm.symbols("first second")
    slower = vx - mu * (1 + e) * first
    reach = vx * first / g + slower * 2 * e * first / g
    reach += (slower - mu * (1 + e) * second) * 2 * e**2 * first / g
    reach = reach.subs(second, e * first)
    at = {vx: 0.4, mu: 0.05, e: 0.5, first: v, g: 9.81}
    assert motion["x"][-1] == pytest.approx(float(reach.subs(at)), rel=1e-9)
    for parameter in (e, mu, vx):
        slope = float(reach.diff(parameter).subs(at))
        assert motion.sensitivity["x", parameter][-1] == pytest.approx(slope, rel=1e-9)
    with pytest.raises(ContactError, match="closes at the instant of another transition"):
        contacts.simulate(sensitivities=[a])  # one end comes down first, or the other


@pytest.mark.parametrize("ratio", [0.2, 0.9])
def test_a_blow_through_bodies_that_touch(ratio):
    """By Poisson's hypothesis one of them gives back more if the other presses it."""
    places, rates = me.dynamicsymbols("x1:4"), me.dynamicsymbols("v1:4")
    masses, ratios = sm.symbols("m1:4"), sm.symbols("e1:3")
    points = [O.locatenew(f"P{k}", place * N.x) for k, place in enumerate(places)]
    for point, rate in zip(points, rates, strict=True):
        point.set_vel(N, rate * N.x)
    bodies = [me.Particle(f"b{k}", *one) for k, one in enumerate(zip(points, masses, strict=True))]
    loads = [(one, -mass * k * N.x) for one, mass in zip(points, masses, strict=True)]
    system = System(
        Definition(N, places, rates, bodies=bodies, loads=loads),
        dict(zip(masses, (1.0, 1.5, 0.8), strict=True)) | {k: 0.1}, {}, "dop853",
        dict(zip([*places, rates[0]], (0.0, 0.5, 1.0, 1.0), strict=True)), [0.0, 1.0],
    )  # fmt: skip
    gaps = [places[1] - places[0], places[2] - places[1] - 0.5]
    touching = [
        Unilateral(gap, restitution=own, name=str(own))
        for gap, own in zip(gaps, ratios, strict=True)
    ]
    values = dict(zip(ratios, (0.7, ratio), strict=True))
    contacts = Contacts(system, touching, values, hypothesis="poisson")
    names = ["x1", "x2", "x3", "v1", "v2", "v3"]
    exact = compared(contacts, [*masses, *ratios, rates[0]], names, **TIGHT)
    assert len(exact.impacts) == 1


def test_rebounds_that_accumulate_have_the_derivatives_of_their_limit():
    system, floor = ball(restitution=e)
    system.initial_conditions, system.times = {y: 1.0}, [0.0, 5.0]
    contacts = Contacts(system, [floor], {e: 0.8})
    rests = contacts.simulate(sensitivities=[e, g, y], rtol=1e-9, atol=1e-12).events[-1]
    assert rests.name == "floor rests"
    # t = √(2 h/g) (1 + e)/(1 − e); the last height counts for what is left of the series
    falls = math.sqrt(2 / 9.81)
    wanted = [2 * falls / 0.04, -9 * falls / 2 / 9.81, 9 * falls / 2]
    assert rests.time_sensitivity == pytest.approx(wanted, rel=1e-9)


def test_a_body_that_comes_to_rest_by_rebounds_ever_faster():
    # The solver took the last of them for grazing: its gap is less exact than that at the origin.
    system, feet = falling_body([(-1, -0.2), (1, -0.2)], restitution=e, mu=mu)
    system.constants.update({J: 0.4, e: 0.3})
    system.initial_conditions, system.times = {y: 1.0, a: 0.4, vx: 1.0}, [0.0, 1.0]
    contacts = Contacts(system, feet, {mu: 0.5})
    exact = compared(contacts, [e, vx], ["x", "y", "a"], rtol=1e-10, atol=1e-12)
    assert set(exact.modes[-1][2].values()) == {"sticks"}


@pytest.mark.parametrize("mass", [1e-15, 1e12, 1e30])
@pytest.mark.parametrize("friction", [0.1, 2.0])
def test_derivatives_through_an_impact_are_the_same_in_any_unit_of_mass(mass, friction):
    system, feet = falling_body([(-1, 0), (1, 0)], restitution=e, mu=mu)
    system.initial_conditions = {y: 0.6, a: 0.6, vx: 0.3, vy: -1.0}
    system.times = [0.0, 0.1]
    found = []
    for unit in (1.0, mass):
        system.constants.update({m: unit, J: unit / 3, e: 0.5})
        motion = Contacts(system, feet, {mu: friction}).simulate(sensitivities=[e, mu, m], **TIGHT)
        assert [event.name for event in motion.events] == ["foot0 closes"]
        found.append(motion.sensitivity.values[-1][:6] * [1.0, 1.0, unit])
    assert abs(found[0]).max() > 0.5
    assert found[1] == pytest.approx(found[0], rel=1e-9, abs=1e-9)


def test_a_particle_that_is_thrown_on_the_ice_and_slides_to_a_stop():
    z, vz = me.dynamicsymbols("z v_z")
    P = O.locatenew("P", x * N.x + y * N.y + z * N.z)
    P.set_vel(N, vx * N.x + vy * N.y + vz * N.z)
    pull = m * g * (sm.sin(0.1) * N.x - sm.cos(0.1) * N.z)
    system = System(
        Definition(
            N, [x, y, z], [vx, vy, vz], bodies=[me.Particle("puck", P, m)], loads=[(P, pull)]
        ),
        {g: 9.81}, {}, "dop853", {z: 0.1, vx: 0.6, vy: 0.8}, [0.0, 1.0],
    )  # fmt: skip
    ice = Unilateral(z, name="ice")
    contacts = Contacts(system, [Stick(P, on=ice, mu=mu, along=(N.x, N.y))], {mu: 0.25})
    exact = compared(contacts, [mu, g, z, vx, vy], ["x", "y", "v_x"], **TIGHT)
    assert [event.name for event in exact.events] == ["ice closes", "ice stops"]
    for speed in np.linspace(0.6, 0.74, 8):  # whatever roundings are left at the stop
        system.initial_conditions[vx] = speed
        motion = contacts.simulate(sensitivities=[mu], **TIGHT)
        assert [event.name for event in motion.events] == ["ice closes", "ice stops"]


@pytest.mark.parametrize("solver", ["dop853", "radau"])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-9, 1e-12])
def test_a_block_that_begins_to_slide_in_a_plane(tolerance, solver):
    contacts = pulled((k, r), {}, {k: 3.0, r: -4.0})
    contacts.system.ode_solver = solver
    motion = contacts.simulate(sensitivities=[k, r, mu], rtol=tolerance, atol=tolerance)
    # x = F/|F| (|F| − μ m g) t²/2
    along = np.array([0.6, -0.8])
    wanted = 4.5 * (np.outer(along, along) * 3.0 / 5.0 + np.eye(2) * 2.0 / 5.0)
    found = motion.sensitivity.values[-1][:2]
    assert found[:, :2] == pytest.approx(wanted, abs=1e-6)
    assert found[:, 2] == pytest.approx(-45.0 * along, abs=1e-6)


def test_a_block_slips_at_a_time_that_moves_and_its_pull_turns():
    t = me.dynamicsymbols._t
    contacts = pulled((k * t, r), {}, {k: 3.0, r: -0.9}, mu_static=0.5)
    compared(contacts, [k, r], ["x", "y", "v_x", "v_y"], 1e-4, rtol=1e-9, atol=1e-9)
    contacts = pulled((k * t, r), {}, {k: 3.0, r: -0.9})
    with pytest.raises(NotImplementedError, match="begins to slide in a plane without an accel"):
        contacts.simulate(sensitivities=[k])


def test_the_time_of_a_stop_in_a_plane_is_right_or_not_known():
    straight = pulled((0, 0), {vx: 0.7, vy: 0.7}, {})
    (stops,) = straight.simulate(sensitivities=[mu]).events
    assert stops.time_sensitivity == pytest.approx(-0.7 * math.sqrt(2) / 0.9, rel=1e-7)
    # A pull across it bends the slide ever faster, which the motion itself does not show.
    across = pulled((k, r), {vx: 1.0, vy: 0.5}, {k: 0.0, r: 0.0})
    compared(across, [k, r, mu], ["x", "y"], rtol=1e-10, atol=1e-10)
    contacts = pulled((k, r), {vx: 0.3, vy: 0.4}, {k: 0.3, r: 0.4})  # a pull along the slide
    compared(contacts, [mu, k, vx], ["x", "y"], rtol=1e-10, atol=1e-10)
    curved = pulled((0, k), {vx: 1.2, vy: 0.9}, {k: 0.8}, 0.2)
    compared(curved, [mu, k, vx], ["x", "y"], 1e-4, **TIGHT)


@pytest.mark.parametrize("tolerance", [1e-7, 1e-9, 1e-12])
def test_a_pull_turns_a_slide_until_it_stops(tolerance):
    # With the speed v at the angle φ from a pull F: v' = F cos φ − μ g, v φ' = −F sin φ, so that
    # v (μ g + F cos φ) falls at the constant rate (μ g)² − F².
    curved = pulled((0, k), {vx: 1.2, vy: 0.9}, {k: 0.8}, 0.2)
    motion = curved.simulate(sensitivities=[mu, k], rtol=tolerance, atol=tolerance)
    (stops,) = motion.events
    held, pull, rises = 0.2 * 10.0, 0.8, 1.5 * 0.6  # μ g, F, and v₀ cos φ₀
    below, above = held**2 - pull**2, 1.5 * held + pull * rises
    assert stops.time == pytest.approx(above / below, rel=20 * tolerance)
    by_held = 1.5 / below - above * 2 * held / below**2
    by_pull = rises / below + above * 2 * pull / below**2
    within = 100 * tolerance + 1e-7
    assert stops.time_sensitivity == pytest.approx([10.0 * by_held, by_pull], rel=within)
    gradient = curved.system.adjoint_gradient(
        [mu, k], final=x, contacts=curved, rtol=tolerance, atol=tolerance
    )
    assert gradient.values == pytest.approx(motion.sensitivity["x"][-1], rel=within)


@pytest.mark.parametrize(("angle", "value"), [(1.3, 0.25), (1.45, 0.1), (1.5, 0.2)])
def test_the_foot_of_a_rod_that_falls_slips_where_friction_reaches_its_limit(angle, value):
    # Its acceleration grows from zero, or from a rounding of either sign.
    q, u = me.dynamicsymbols("q u")
    A = me.ReferenceFrame("A")
    A.orient_axis(N, N.z, q)
    A.set_ang_vel(N, u * N.z)
    G = O.locatenew("G", x * N.x + y * N.y)
    G.set_vel(N, vx * N.x + vy * N.y)
    rod = me.RigidBody("rod", G, A, 1.0, (me.inertia(A, 0, 0, sm.Rational(1, 3)), G))
    foot = G.locatenew("foot", -A.x)
    foot.v2pt_theory(G, N, A)
    system = System(
        Definition(N, [x, y, q], [vx, vy, u], bodies=[rod], loads=[(G, -g * N.y)]),
        {g: 9.81}, {}, "dop853", {q: angle, x: math.cos(angle), y: math.sin(angle)}, [0.0, 1.0],
    )  # fmt: skip
    floor = Unilateral(y - sm.sin(q), name="floor")
    contacts = Contacts(system, [Stick(foot, on=floor, mu=mu, along=N.x)], {mu: value})
    exact = compared(contacts, [g, mu], ["x", "q", "u"], 2e-5, rtol=1e-12, atol=1e-12)
    names = [event.name for event in exact.events]
    assert names[0] == "floor slips"
    assert names.count("floor slips") == 1


def two_balls():
    """Balls that fall side by side from the same height."""
    z, vz = me.dynamicsymbols("z v_z")
    points = [O.locatenew(name, place * N.y) for name, place in (("A", y), ("B", z))]
    for point, rate in zip(points, (vy, vz), strict=True):
        point.set_vel(N, rate * N.y)
    bodies = [me.Particle(f"ball{k}", one, m) for k, one in enumerate(points)]
    system = System(
        Definition(N, [y, z], [vy, vz], bodies=bodies, loads=[(p, -m * g * N.y) for p in points]),
        {g: 9.81}, {}, "dop853", {y: 1.0, z: 1.0}, [0.0, 0.6],
    )  # fmt: skip
    floors = [Unilateral(gap, restitution=e, name=f"floor{k}") for k, gap in enumerate((y, z))]
    return Contacts(system, floors, {e: 0.5}), z


def test_what_happens_at_one_instant_has_no_derivative_by_what_parts_it():
    # It had the derivatives as if both closed where the first one does: −1 and 1.
    contacts, z = two_balls()
    find = contacts.system.adjoint_gradient
    for symbol in (y, z):
        with pytest.raises(ContactError, match=rf"'floor.' closes .* with another {symbol.name} "):
            contacts.simulate(sensitivities=[symbol])
        with pytest.raises(ContactError, match=rf"'floor.' closes .* with another {symbol.name} "):
            find([symbol], final=z, contacts=contacts)
    exact = compared(contacts, [g, e], ["y", "z", "v_z"], **TIGHT)
    found = find([g, e], final=z, contacts=contacts, **TIGHT)
    assert found.values == pytest.approx(exact.sensitivity["z"][-1], abs=1e-12)
    assert np.isnan(found.by_state).all()


def test_at_an_impact_at_the_last_time_derivatives_are_those_of_the_state_after_it():
    system, floor = ball(restitution=e)
    fall = math.sqrt(2.0 / 9.81)
    system.initial_conditions, system.times = {y: 1.0}, [0.0, fall / 2, fall]
    motion = Contacts(system, [floor], {e: 0.8}).simulate(sensitivities=[e, y], **TIGHT)
    v = 9.81 * fall
    assert motion["v_y"][-1] == pytest.approx(0.8 * v, abs=1e-9)
    # y = e v s − g s²/2 after it, with s' = −1/v and v' = g/v by the height
    assert motion.sensitivity["v_y"][-1] == pytest.approx([v, 0.8 * 9.81 / v + 9.81 / v], abs=1e-9)
    assert motion.sensitivity["y"][-1] == pytest.approx([0.0, -0.8], abs=1e-9)
    (impact,) = motion.events
    assert impact.time_sensitivity == pytest.approx([0.0, 1.0 / v], abs=1e-9)
    assert impact.sensitivity_after[1] == pytest.approx(motion.sensitivity["v_y"][-1])


@pytest.mark.parametrize("height", [0.4, -0.4])
def test_a_load_that_jumps_on_the_way_is_warned_of(height):
    P = O.locatenew("P", y * N.y)
    P.set_vel(N, vy * N.y)
    pull = -m * g + sm.Piecewise((2.0, y > height), (0.0, True))
    system = System(
        Definition(N, [y], [vy], bodies=[me.Particle("ball", P, m)], loads=[(P, pull * N.y)]),
        {g: 9.81}, {}, "dop853", {y: 1.0}, np.linspace(0.0, 1.0, 11),
    )  # fmt: skip
    contacts = Contacts(system, [Unilateral(y, name="floor", restitution=0.5)])
    told = pytest.warns(PyDyUserWarning, match=r"the load on v_y\(t\) jumps by 2")
    with told if height > 0.0 else nullcontext():
        contacts.simulate(sensitivities=[g], **TIGHT)
