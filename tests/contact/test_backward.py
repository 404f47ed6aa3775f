"""Adjoint gradients through transitions: closed forms, forward sensitivities, differences."""

import math
import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import solve_ivp

from pydy import System
from pydy.contact import Contacts, Roll, Stick, Unilateral
from pydy.errors import ContactError
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
    body_in_plane,
    e,
    falling_body,
    g,
    k,
    m,
    mu,
    pulled,
    r,
    slope,
    vx,
    vy,
    w,
    x,
    y,
)

t = me.dynamicsymbols._t


def bouncing(**options):
    system, floor = ball(restitution=e, **options)
    system.initial_conditions, system.times = {y: 1.0}, [0.0, 1.0]
    return Contacts(system, [floor], {e: 0.8})


def test_a_ball_that_bounces_and_what_is_integrated_along_its_way():
    contacts = bouncing()
    values = G, E, h = sm.symbols("G E h", positive=True)
    fall = sm.sqrt(2 * h / G)
    up, s = E * sm.sqrt(2 * G * h), sm.Symbol("s", positive=True)
    height = up * (1 - fall) - G * (1 - fall) ** 2 / 2
    area = sm.integrate((G * s) ** 2 + h - G * s**2 / 2, (s, 0, fall))
    area += sm.integrate((up - G * s) ** 2 + up * s - G * s**2 / 2, (s, 0, 1 - fall))
    numbers = dict(zip(values, (9.81, 0.8, 1.0), strict=True))
    for exact, terms in ((height, {"final": y}), (area, {"integral": vy**2 + y})):
        found = contacts.system.adjoint_gradient([g, e, y], contacts=contacts, **terms, **TIGHT)
        assert found.value == pytest.approx(float(exact.subs(numbers)), rel=1e-11)
        wanted = [float(exact.diff(one).subs(numbers)) for one in values]
        assert found.values == pytest.approx(wanted, rel=1e-9)
    assert found.by_state[0] == found["y"]
    assert [event.name for event in found.trajectory.events] == ["floor closes"]
    assert pickle.loads(pickle.dumps(found)).trajectory.modes == found.trajectory.modes


def test_the_time_and_the_place_at_which_an_event_of_ones_own_ends_the_motion():
    contacts = bouncing()
    top = Event(vy, direction=-1, terminal=True, name="top")
    contacts.system.initial_conditions = {y: 1.0, vy: -0.1}
    contacts.system.times = [0.0, 3.0]
    values = G, E, h = sm.symbols("G E h", positive=True)
    hits = sm.sqrt(0.01 + 2 * G * h)
    numbers = dict(zip(values, (9.81, 0.8, 1.0), strict=True))
    when, where = (hits - 0.1) / G + E * hits / G, (E * hits) ** 2 / 2 / G
    for exact, terms in ((when, {"final": t}), (when, {"integral": 1}), (where, {"final": y})):
        found = contacts.system.adjoint_gradient(
            [g, e, y], contacts=contacts, events=[top], **terms, **TIGHT
        )
        assert found.value == pytest.approx(float(exact.subs(numbers)), rel=1e-11)
        wanted = [float(exact.diff(one).subs(numbers)) for one in values]
        assert found.values == pytest.approx(wanted, rel=1e-9)


def oscillator():
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, vx * N.x)
    system = System(
        Definition(N, [x], [vx], bodies=[me.Particle("P", P, m)], loads=[(P, -k * x * N.x)]),
        {k: 100.0}, ode_solver="dop853", initial_conditions={x: 1.0}, times=[0.0, 1.0],
    )  # fmt: skip
    return Contacts(system, [Stick(vx, mu=mu, normal=m * g, name="rub")], {mu: 0.9, g: 9.81})


def on_a_belt():
    belt, static = sm.symbols("belt static")
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, vx * N.x)
    system = System(
        Definition(N, [x], [vx], bodies=[me.Particle("P", P, m)], loads=[(P, -k * x * N.x)]),
        {k: 20.0}, {}, "dop853", {vx: 0.1}, [0.0, 9.2],
    )  # fmt: skip
    rub = Stick(vx - belt, mu=mu, mu_static=static, normal=9.81, name="belt")
    return Contacts(system, [rub], {belt: 0.1, mu: 0.3, static: 0.6})


def tumbling(friction, start, hypothesis="newton"):
    system, feet = falling_body([(-1, -0.2), (1, -0.2)], restitution=e, mu=mu)
    system.constants.update({J: 0.4, e: 0.3})
    system.initial_conditions, system.times = start, [0.0, 0.6]
    return Contacts(system, feet, {mu: friction}, hypothesis=hypothesis)


def rimless():
    spokes = [(math.sin(math.pi / 4 * j), -math.cos(math.pi / 4 * j)) for j in range(2)]
    system, feet = falling_body(spokes, tilt=slope, mu=mu)
    system.constants[J], system.constants[slope] = 0.3, -0.08
    system.initial_conditions, system.times = {y: 1.0, w: -0.7, vx: 0.7}, [0.0, 1.0]
    return Contacts(system, feet, {mu: 5.0})


def on_a_circle():
    """A particle on a circle, by a constraint, that strikes a wall."""
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, vx * N.x + vy * N.y)
    system = System(
        Definition(
            N, [x, y], [vx, vy], bodies=[me.Particle("P", P, m)], loads=[(P, -m * g * N.y)],
            holonomic_constraints=[x**2 + y**2 - r**2],
        ),
        {g: 9.81, r: 1.0}, {}, "dop853", {x: 0.6, y: -0.8}, [0.0, 2.0],
    )  # fmt: skip
    system.set_dependent_initial_conditions(dep_vars=[y, vy])
    wall = Unilateral(x - k, name="wall", restitution=e)
    return Contacts(system, [wall], {e: 0.7, k: 0.01})


def rolls():
    C, body, _ = body_in_plane()
    system = System(
        Definition(N, [x, y, a], [vx, vy, w], bodies=[body], loads=[(C, -m * g * N.y)]),
        {g: 9.81, J: 0.4 * 0.01}, {}, "dop853", {y: 0.1, vx: 2.0}, [0.0, 0.5],
    )  # fmt: skip
    roll = Roll(body, r, on=O, normal=N.y, along=N.x, mu=mu, name="table")
    return Contacts(system, [roll], {mu: 0.2, r: 0.1})


CASES = {
    "a billiard ball": (billiard_ball, [mu, vx, g, r, J], ["x", "v_x", "table_friction"]),
    "a ball that rolls": (rolls, [mu, vx, g, r, J], ["x", "v_x"]),
    "Coulomb's friction": (oscillator, [mu, k, x, m, g], ["x", "v_x"]),
    "stick and slip": (on_a_belt, [k, mu, "belt", "static", x], ["x", "v_x", "belt_friction"]),
    "feet that stick": (
        lambda: tumbling(2.0, {y: 1.0, a: 0.4, vx: 1.0}), [mu, e, J, a, vx], ["x", "a", "w"],
    ),
    "feet that slide": (
        lambda: tumbling(0.3, {y: 1.0, a: 0.4, vx: 1.0}), [mu, e, J, a, vx], ["x", "a", "w"],
    ),
    "Poisson's hypothesis": (
        lambda: tumbling(2.0, {y: 1.0, a: 0.4, vx: 1.0}, "poisson"), [mu, e, J, a], ["x", "w"],
    ),
    "two feet at one instant": (
        lambda: tumbling(0.3, {y: 1.0, vx: 1.0}), [mu, e, J, y, vx], ["x", "y", "v_x"],
    ),
    "a rimless wheel": (rimless, [slope, J, g, w], ["x", "a", "w"]),
    "a closed loop": (on_a_circle, [g, r, e, k, x, m], ["x", "y", "v_x"]),
    "a slide that begins in a plane": (
        lambda: pulled((k, r), {}, {k: 3.0, r: -4.0}), [k, r, mu], ["x", "y"],
    ),
    "a pull that grows": (
        lambda: pulled((k * t, r), {}, {k: 3.0, r: -0.9}, mu_static=0.5), [k, r, mu], ["x", "v_y"],
    ),
    # The motion itself shows nothing of how quickly friction turns what is across it.
    "a slide in a plane": (
        lambda: pulled((k, r), {vx: 1.0, vy: 0.5}, {k: 0.0, r: 0.0}), [k, r, mu, vx], ["x", "y"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_backward_is_forward(case):
    make, wrt, names = CASES[case]
    contacts = make()
    forward = contacts.simulate(sensitivities=wrt, rtol=1e-11, atol=1e-12)
    assert len(forward.modes) > 1 or len(forward.impacts) > 0
    for name in names:
        found = contacts.system.adjoint_gradient(
            wrt, final=name, contacts=contacts, rtol=1e-11, atol=1e-12
        )
        wanted = np.array([forward.sensitivity[name, one][-1] for one in wrt])
        assert found.value == pytest.approx(forward[name][-1], abs=1e-10)
        assert found.values == pytest.approx(wanted, abs=1e-8 * max(1.0, abs(wanted).max()))


def ball_on_a_turntable():
    """A ball that slips along a curve on a turntable until it rolls, and the table's rate."""
    x, y, z, a, b, c, vx, vy, vz, w1, w2, w3 = me.dynamicsymbols(
        "x y z a b c v_x v_y v_z w_1 w_2 w_3"
    )
    rate = sm.Symbol("Omega")
    B, T = me.ReferenceFrame("B"), me.ReferenceFrame("T")
    T.orient_axis(N, N.z, rate * me.dynamicsymbols._t)
    C = O.locatenew("C", x * N.x + y * N.y + z * N.z)
    C.set_vel(N, vx * N.x + vy * N.y + vz * N.z)
    B.orient_body_fixed(N, (a, b, c), "ZXY")
    turning = w1 * N.x + w2 * N.y + w3 * N.z
    kinematics = [(B.ang_vel_in(N) - turning).dot(axis) for axis in N]
    kinematics += [x.diff() - vx, y.diff() - vy, z.diff() - vz]
    B.set_ang_vel(N, turning)
    inertia = sm.Rational(2, 5) * m * r**2
    body = me.RigidBody("ball", C, B, m, (me.inertia(B, inertia, inertia, inertia), C))
    system = System(
        Definition(
            N, [x, y, z, a, b, c], [vx, vy, vz, w1, w2, w3], bodies=[body],
            loads=[(C, -m * g * N.z)], kinematic_equations=kinematics,
        ),
        {g: 9.81, m: 1.3, r: 0.05}, ode_solver="dop853", times=[0.0, 1.0],
        initial_conditions=dict(zip([x, y, vx, vy, w1, w2, z, b], [*BALL, 0.05, 0.3], strict=True)),
    )  # fmt: skip
    roll = Roll(body, r, on=O, normal=T.z, along=(N.x, N.y), mu=mu, name="table")
    return Contacts(system, [roll], {mu: 0.18, rate: 3.6}), {mu: 0, rate: 1, x: 2, y: 3, vx: 4}


BALL = [0.3, -0.1, 0.9, 0.4, 12.0, -6.0]


def place_on_a_turntable(change):
    """Return x of this ball after a second, by SciPy from textbook equations."""
    friction, rate, *start = np.add([0.18, 3.6, *BALL], np.append(change, np.zeros(3)))

    def slip(s):
        return np.array([s[2] - 0.05 * s[5] + rate * s[1], s[3] + 0.05 * s[4] - rate * s[0]])

    def rates(force, s):  # of a unit of mass, with the inertia 2 r²/5
        return [s[2], s[3], *force, 50.0 * force[1], -50.0 * force[0]]

    def sliding(t, s):
        return rates(-friction * 9.81 * slip(s) / np.linalg.norm(slip(s)), s)

    def rolling(t, s):
        return rates(np.array([-s[3], s[2]]) * rate * 2.0 / 7.0, s)

    def stops(t, s):
        return np.linalg.norm(slip(s)) - 1e-9

    stops.terminal = True
    tight = {"rtol": 1e-12, "atol": 1e-13, "method": "DOP853"}
    slides = solve_ivp(sliding, (0.0, 1.0), start, events=stops, **tight)
    assert slides.status == 1
    return solve_ivp(rolling, (slides.t[-1], 1.0), slides.y[:, -1], **tight).y[0, -1]


def test_a_ball_slips_on_a_turntable_until_it_rolls():
    contacts, positions = ball_on_a_turntable()
    found = contacts.system.adjoint_gradient(
        list(positions), final="x", contacts=contacts, rtol=1e-10, atol=1e-11
    )
    steps = 1e-4 * np.eye(5)
    slopes = [(place_on_a_turntable(s) - place_on_a_turntable(-s)) / 2e-4 for s in steps]
    assert found.value == pytest.approx(place_on_a_turntable(np.zeros(5)), abs=1e-8)
    assert found.values == pytest.approx(slopes, abs=1e-6)


def moved(contacts, symbol, change, **terms):
    system = contacts.system
    kind = "initial_conditions" if symbol in system.states else "constants"
    before = dict(getattr(system, kind))
    setattr(system, kind, {**before, symbol: before.get(symbol, 0.0) + change})
    found = system.adjoint_gradient([symbol], contacts=contacts, **terms).value
    setattr(system, kind, before)
    return found


@pytest.mark.parametrize(
    ("make", "wrt", "term"),
    [
        (lambda: tumbling(0.3, {y: 1.0, a: 0.4, vx: 1.0}), [mu, e, vx], w**2 + x),
        (on_a_belt, [mu, k], "belt_friction"),  # it jumps where the belt slips
        (lambda: pulled((k, r), {vx: 1.0, vy: 0.5}, {k: 0.3, r: -0.2}), [mu, k, vx], x * y + vx),
    ],
)
def test_integrals_have_the_derivatives_of_differences(make, wrt, term):
    contacts, options = make(), {"rtol": 1e-11, "atol": 1e-12}
    exact = contacts.system.adjoint_gradient(wrt, integral=term, contacts=contacts, **options)
    for symbol in wrt:
        ahead, behind = (
            moved(contacts, symbol, step, integral=term, **options) for step in (1e-5, -1e-5)
        )
        slope = (ahead - behind) / 2e-5
        assert exact[symbol] == pytest.approx(slope, abs=1e-6 * max(1.0, abs(slope))), symbol


@pytest.mark.parametrize("between", ["linear", "previous"])
def test_samples_and_numbers_of_specifieds(between):
    F, H = me.dynamicsymbols("F H")
    P = O.locatenew("P", y * N.y)
    P.set_vel(N, vy * N.y)
    knots, values = np.linspace(0.0, 1.0, 6), np.array([0.5, -1.0, -2.0, -1.0, 0.5, 1.0])
    system = System(
        Definition(N, [y], [vy], bodies=[me.Particle("P", P, m)], loads=[(P, (F + H) * N.y)]),
        {}, {F: SampledInput(knots, values, between), H: -8.0}, "dop853", {y: 0.5}, [0.0, 1.0],
    )  # fmt: skip
    contacts = Contacts(system, [Unilateral(y, restitution=e, name="floor")], {e: 0.7})
    options = {"final": y, "contacts": contacts, "rtol": 1e-11, "atol": 1e-12}
    exact = system.adjoint_gradient([F, H, e], **options)
    forward = contacts.simulate(sensitivities=[F, H, e], rtol=1e-11, atol=1e-12)
    assert exact.values == pytest.approx(forward.sensitivity["y"][-1], abs=1e-9)
    assert forward.events[0].time_sensitivity.shape == (8,)
    assert len(exact.trajectory.impacts) > 1
    for name, number in (("F", 0), ("F", 3), ("H", 0)):
        found = []
        for step in (1e-4, -1e-4):
            sampled = values + step * (np.arange(6) == number) * (name == "F")
            system.specifieds = {
                F: SampledInput(knots, sampled, between),
                H: -8.0 + step * (name == "H"),
            }
            found.append(system.adjoint_gradient([e], **options).value)
        slope = (found[0] - found[1]) / 2e-4
        assert np.atleast_1d(exact[name])[number] == pytest.approx(slope, abs=1e-6)


def test_tolerances_of_each_state_and_a_bar_of_progress(capsys):
    contacts = bouncing()
    options = {"contacts": contacts, "integral": y, "rtol": 1e-10}
    found = contacts.system.adjoint_gradient([e], progress=True, atol=[1e-12, 1e-11], **options)
    assert "steps back" in capsys.readouterr().err
    exact = contacts.system.adjoint_gradient([e], atol=1e-12, **options)
    assert found["e"] == pytest.approx(exact["e"], rel=1e-8)


def test_what_has_no_derivative_is_said():
    contacts = bouncing()
    system = contacts.system
    with pytest.raises(ValueError, match="`final` must be an output of the system"):
        system.adjoint_gradient([e], final="nothing", contacts=contacts)
    with pytest.raises(TypeError, match="`contacts` must be Contacts of this System, got"):
        system.adjoint_gradient([e], final=y, contacts=3)
    with pytest.raises(NotImplementedError, match="`events` with resets"):
        system.adjoint_gradient([e], final=y, contacts=contacts, events=[Event(y, reset={vy: 0})])
    with pytest.raises(AttributeError, match=r"Call system.adjoint_gradient\(contacts=…\)"):
        contacts.adjoint_gradient
    hit = contacts.simulate(**TIGHT).events[0].time
    system.times = [0.0, hit]
    with pytest.raises(ContactError, match="The motion ends at an impact"):
        system.adjoint_gradient([e], final=y, contacts=contacts, **TIGHT)
    system.ode_solver = "radau"
    with pytest.raises(ValueError, match="explicit method, but `ode_solver` is 'radau'"):
        system.adjoint_gradient([e], final=y, contacts=contacts)


def test_a_contact_that_is_only_grazed_is_refused():
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, vx * N.x + vy * N.y)
    system = System(
        Definition(N, [x, y], [vx, vy], bodies=[me.Particle("P", P, m)], loads=[(P, -x * N.x)]),
        {}, {}, "dop853", {x: 1.0, y: 1.0}, [0.0, 4.0],
    )  # fmt: skip
    wall = Contacts(system, [Unilateral(1.0 - 1e-9 + x, restitution=0.5, name="wall")])
    loose = {"rtol": 1e-5, "atol": 1e-5, "max_step": 0.05}
    for run in (
        lambda: wall.simulate(sensitivities=[x], **loose),
        lambda: system.adjoint_gradient([x], final=y, contacts=wall, **loose),
    ):
        with pytest.raises(ContactError, match="only grazes"):
            run()


def test_an_integral_that_jumps_where_a_body_stops_in_a_plane():
    contacts = pulled((0, 0), {vx: 0.7, vy: 0.7}, {})
    find = contacts.system.adjoint_gradient
    wanted = find([mu], integral=vx, contacts=contacts)["mu"]
    assert wanted == pytest.approx(find([mu], final=x, contacts=contacts)["mu"], rel=1e-7)
    # The friction along x, which jumps at the stop, has the integral −m v_x of the momentum.
    found = find([mu, vx, vy], integral="floor_friction_1", contacts=contacts)
    assert found.values == pytest.approx([0.0, -1.0, 0.0], abs=1e-6)
