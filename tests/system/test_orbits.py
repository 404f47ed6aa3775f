"""Periodic orbits and their Floquet multipliers, against published numbers and closed forms."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import solve_ivp
from scipy.special import ellipk

import pydy.analysis.orbits
from gallery import definitions
from pydy import System
from pydy.errors import AnalysisInterrupted, PeriodicOrbitError, PyDyUserWarning
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.solvers import Event
from zoo import inertial_frame

t = me.dynamicsymbols._t


def simplest_walker():
    """The walker of the gallery before its gait is found, and its heel strike."""
    walker = definitions("walker", before="A shooting method")
    start = dict(zip((*walker.kane.q, *walker.kane.u), (0.2, 0.4, -0.2, -0.02), strict=True))
    constants = {walker.gamma: walker.SLOPE, walker.m: 1.0}
    return System(walker.kane, constants=constants, initial_conditions=start), walker.strike


def on_a_line(force):
    """A unit mass under a force of x, v and the constant mu."""
    x, v = me.dynamicsymbols("x v")
    mu = sm.Symbol("mu")
    N, P, O = me.ReferenceFrame("N"), me.Point("P"), me.Point("O")
    O.set_vel(N, 0)
    P.set_vel(N, v * N.x)
    kane = me.KanesMethod(N, [x], [v], [x.diff() - v])
    kane.kanes_equations([me.Particle("b", P, sm.Integer(1))], [(P, force(x, v, mu) * N.x)])
    return System(kane, initial_conditions={x: 2.0, v: 0.1})


def test_van_der_pols_limit_cycle_has_its_period():
    system = on_a_line(lambda x, v, mu: mu * (1 - x**2) * v - x)
    orbit = system.find_periodic_orbit(6.5)
    assert orbit.period == pytest.approx(6.66328685932313, rel=1e-10)
    assert orbit.autonomous
    assert orbit.stable
    first, second = orbit.multipliers
    assert first == pytest.approx(1.0, abs=1e-8)
    # Liouville: the determinant of the monodromy matrix is exp(∫ div f dt).
    x = orbit.trajectory["x"]
    h = orbit.trajectory.times[1]
    divergence = 1.0 - x**2
    integral = h * (divergence[:-1].sum())
    assert second == pytest.approx(np.exp(integral), rel=1e-6)
    np.testing.assert_allclose(orbit.trajectory.states[0], orbit.trajectory.states[-1], atol=1e-9)
    assert not orbit.equilibrium


def test_multipliers_are_exact_where_the_orbit_is_an_equilibrium():
    """The search ends at a state of 1e-317, which is no size of a parameter."""
    stiffness = 2.0 * (1.0 + 0.5 * sm.cos(2.1 * t))  # Mathieu's equation, damped
    system = on_a_line(lambda x, v, mu: -stiffness * x - 0.1 * v)
    system.initial_conditions = {"x": 1e-3}
    period = 2.0 * np.pi / 2.1
    orbit = system.find_periodic_orbit(period)

    def rates(time, z):
        push = 2.0 * (1.0 + 0.5 * np.cos(2.1 * time))
        return np.concatenate([z[2:], -push * z[:2] - 0.1 * z[2:]])

    flown = solve_ivp(rates, [0.0, period], np.eye(2).ravel(), "DOP853", rtol=1e-12, atol=1e-13)
    expected = flown.y[:, -1].reshape(2, 2)
    np.testing.assert_allclose(orbit.monodromy, expected, rtol=1e-8, atol=1e-8)
    assert orbit.equilibrium
    assert str(orbit).startswith("Equilibrium over 2.99")


def test_an_orbit_of_a_constrained_system_is_found_in_the_states_that_are_not_solved_for():
    """A driven bob on a string, which passes the lowest point, where x does not follow from y."""
    (x, y), (v, w) = me.dynamicsymbols("x y"), me.dynamicsymbols("v w")
    N, O = inertial_frame()
    P = O.locatenew("P", x * N.x + y * N.y)
    push = sm.cos(2 * t) - v / 2
    bob = Definition(
        N,
        [x, y],
        [v, w],
        bodies=[me.Particle("bob", P, sm.Integer(1))],
        loads=[(P, push * N.x + (-10 - w / 2) * N.y)],
        holonomic_constraints=[x**2 + y**2 - 1],
    )
    system = System(bob, initial_conditions={x: 0.05, y: -1.0})
    system.set_dependent_initial_conditions([y, w])
    orbit = system.find_periodic_orbit(np.pi)
    assert orbit.states == ("x", "v")
    # Liouville: the angle's damping is 1/2.
    assert np.prod(orbit.multipliers) == pytest.approx(np.exp(-np.pi / 2), rel=1e-8)
    # The same bob by its angle. The product alone would not show a wrong dependent speed.
    q, u = me.dynamicsymbols("q u")
    P = O.locatenew("P", sm.sin(q) * N.x - sm.cos(q) * N.y)
    loads = [(P, (sm.cos(2 * t) - u * sm.cos(q) / 2) * N.x - (10 + u * sm.sin(q) / 2) * N.y)]
    bob = Definition(N, [q], [u], bodies=[me.Particle("bob", P, sm.Integer(1))], loads=loads)
    angle = System(bob, initial_conditions={q: 0.05}).find_periodic_orbit(np.pi)
    assert orbit.multipliers == pytest.approx(angle.multipliers, rel=1e-7)


def test_a_pendulum_swings_with_the_period_of_the_elliptic_integral():
    system = n_link_pendulum_on_cart(1)
    system.constants = {"m0": 1e13, "g": 9.81, "l0": 0.7}
    system.initial_conditions = {"q1": np.pi - 1.2}
    orbit = system.find_periodic_orbit(1.7, moving=["q0"])
    amplitude = np.pi - orbit.initial_conditions[system.states[1]]
    assert amplitude == pytest.approx(1.2, abs=0.3)  # one of a family
    expected = 4.0 * ellipk(np.sin(amplitude / 2) ** 2) * np.sqrt(0.7 / 9.81)
    assert orbit.period == pytest.approx(expected, rel=1e-9)


def test_auxiliary_states_take_no_part_in_the_search():
    system = on_a_line(lambda x, v, mu: mu * (1 - x**2) * v - x)
    plain = system.find_periodic_orbit(6.5)
    push, pull = sm.symbols("push pull")
    rate = system.speeds[0].diff()
    system.outputs = {(push, pull): (push - 2 * pull - rate, push + pull)}
    assert len(system.states) == 4
    for until in (None, Event(system.speeds[0], direction=-1)):
        orbit = system.find_periodic_orbit(6.5, until=until)
        assert orbit.states == ("x", "v")
        assert orbit.period == pytest.approx(plain.period, rel=1e-9)
        # The outputs solve push − 2 pull = v', push + pull = 0.
        rates = orbit.trajectory.derivatives[:, 1]
        assert orbit.trajectory["push"] == pytest.approx(rates / 3, rel=1e-9, abs=1e-12)
    assert plain.multipliers == pytest.approx(system.find_periodic_orbit(6.5).multipliers, abs=1e-8)


def test_a_pendulum_that_turns_over_repeats_where_an_event_sets_it_back():
    q, u = me.dynamicsymbols("q u")
    N, O = inertial_frame()
    rod = N.orientnew("R", "Axis", (q, N.z))
    bob = O.locatenew("B", -rod.y / 2)
    loads = [(bob, -9.81 * N.y), (rod, (5 - 0.4 * u) * N.z)]
    body = me.Particle("bob", bob, sm.Integer(1))
    system = System(Definition(N, [q], [u], bodies=[body], loads=loads))
    system.initial_conditions = {u: 12.0}
    with pytest.raises(ValueError, match=r"got q, on which u depends: a motion .* does not repeat"):
        system.find_periodic_orbit(0.5, moving=[q])
    turned = Event(q - 2 * sm.pi, reset={q: q - 2 * sm.pi})
    orbit = system.find_periodic_orbit(0.5, moving=[q], until=turned)
    # Liouville: the angle's damping is 0.4 / (1/4).
    assert orbit.multipliers == pytest.approx(np.exp(-1.6 * orbit.period), rel=1e-8)


def test_events_on_the_way_act_beside_the_one_that_ends_the_period():
    # A clock: each swing of a damped oscillator is pushed in the middle. Its speeds after a push
    # repeat where U d + push = U, with the decay d = exp(-ζ ω T/2) over half a period.
    system = on_a_line(lambda x, v, mu: -2 * 0.1 * v - x)
    (x, v), push, root = system.states, 0.02, np.sqrt(1 - 0.1**2)
    decay = np.exp(-0.1 * np.pi / root)
    tick = Event(x, direction=1, reset={v: v + push}, name="tick")
    tock = Event(x, direction=-1, reset={v: v - push}, name="tock")
    system.initial_conditions = {x: 0.05}
    for events in (tock, [tock], iter([tick, tock])):
        orbit = system.find_periodic_orbit(6.0, until=tick, events=events)
        assert orbit.period == pytest.approx(2 * np.pi / root, rel=1e-10)
        assert orbit.initial_conditions[v] == pytest.approx(push / (1 - decay), rel=1e-10)
        assert orbit.trajectory.events[0].time == pytest.approx(np.pi / root, rel=1e-10)
        np.testing.assert_allclose(np.abs(orbit.multipliers), [decay**2, 0.0], atol=1e-9)


def shaken(rate, amplitude=0.01, length=0.2, gravity=9.81):
    m, l, g, a, w = sm.symbols("m l g a w")
    q, u = me.dynamicsymbols("q u")
    y = a * sm.cos(w * t)
    N = me.ReferenceFrame("N")
    rod = N.orientnew("R", "Axis", (q, N.z))
    rod.set_ang_vel(N, u * N.z)
    pivot, bob = me.Point("P"), me.Point("B")
    pivot.set_vel(N, y.diff(t) * N.y)
    bob.set_pos(pivot, l * rod.y)
    bob.v2pt_theory(pivot, N, rod)
    kane = me.KanesMethod(N, [q], [u], [q.diff(t) - u])
    kane.kanes_equations([me.Particle("bob", bob, m)], [(bob, -m * g * N.y)])
    return System(kane, constants={l: length, g: gravity, a: amplitude, w: rate})


@pytest.mark.parametrize("share", [0.8, 1.5, 3.0])
def test_kapitzas_pendulum_stands_where_its_multipliers_say_so(share):
    length, gravity, amplitude = 0.2, 9.81, 0.01
    rate = share * np.sqrt(2.0 * gravity * length) / amplitude
    orbit = shaken(rate).find_periodic_orbit(2.0 * np.pi / rate)
    assert not orbit.autonomous
    assert orbit.stable == (share > 1.0)

    def mathieu(instant, columns):
        a, b = columns.reshape(2, 2)
        stiffness = (gravity - amplitude * rate**2 * np.cos(rate * instant)) / length
        return np.concatenate([b, stiffness * a])

    whole = (
        solve_ivp(
            mathieu, (0.0, 2.0 * np.pi / rate), np.eye(2).ravel(), "DOP853", rtol=1e-12, atol=1e-14
        )
        .y[:, -1]
        .reshape(2, 2)
    )
    np.testing.assert_allclose(orbit.monodromy, whole, rtol=1e-8, atol=1e-8)
    assert np.prod(orbit.multipliers) == pytest.approx(1.0, abs=1e-8)  # no damping


def test_the_simplest_walker_walks_with_the_published_gait():
    """The long gait on a slope of 0.009 rad, from M. Garcia's program for the paper of 1998.

    Its swing leg has no state of its own after a strike: φ = 2 θ and φ' = (1 − cos 2 θ) θ'.
    """
    system, strike = simplest_walker()
    orbit = system.find_periodic_orbit(3.8, until=strike)
    found = [orbit.initial_conditions[s] for s in system.states]
    theta, omega = 0.20031090049483, -0.19983247291764
    expected = [theta, 2 * theta, omega, (1 - np.cos(2 * theta)) * omega]
    np.testing.assert_allclose(found, expected, atol=2e-9)
    assert np.abs(orbit.multipliers[:2]) == pytest.approx([0.5891] * 2, abs=1e-4)
    np.testing.assert_allclose(orbit.multipliers[2:], 0.0, atol=1e-7)
    assert orbit.stable
    assert not orbit.autonomous


def test_the_monodromy_matrix_is_that_of_differences():
    system, strike = simplest_walker()
    orbit = system.find_periodic_orbit(3.8, until=strike)
    system.ode_solver, system.times = "dop853", [0.0, 8.0]
    x = np.array([orbit.initial_conditions[s] for s in system.states])
    ending = Event(
        strike.expression, direction=1, terminal=True, reset=dict(strike.reset), name="strike"
    )

    def step(start):
        # It starts on the surface of the strike, which is past: without the event at first.
        tight = {"rtol": 1e-13, "atol": 1e-13}
        system.initial_conditions = dict(zip(system.states, start, strict=True))
        system.times = [0.0, 0.5]
        system.initial_conditions = dict(
            zip(system.states, system.simulate(**tight).states[-1], strict=True)
        )
        system.times = [0.5, 8.0]
        return system.simulate(events=ending, **tight).events[-1].after

    for k in (2, 3):
        h = np.zeros(4)
        h[k] = 2e-6
        change = (step(x + h) - step(x - h)) / 4e-6
        np.testing.assert_allclose(orbit.monodromy[:, k], change, atol=1e-6)


def test_a_forced_oscillator_has_the_multipliers_of_its_eigenvalues():
    system = multi_mass_spring_damper(apply_external_forces=True, external_force_as_sin_of_t=True)
    system.constants = {"c0": 0.2}
    orbit = system.find_periodic_orbit(2.0 * np.pi)
    roots = np.roots([1.0, 0.2, 1.0])
    np.testing.assert_allclose(
        np.sort_complex(orbit.multipliers), np.sort_complex(np.exp(2.0 * np.pi * roots)), atol=1e-9
    )
    # Resonance: x = −cos(t) / c.
    assert orbit.initial_conditions[system.states[0]] == pytest.approx(-5.0, abs=1e-8)


def test_an_orbit_of_micrometres_is_found_as_one_of_metres():
    """A driven spring that stiffens, once in units of its own and once in SI units."""
    orbits = []
    for length, second in ((1.0, 1.0), (1e-6, 1e-5)):
        rate = 1.01 / second

        def acceleration(x, v, mu, length=length, second=second, rate=rate):
            x, v = x / length, v * second / length
            return mu * (sm.cos(rate * t) - 10 * x - x**3 - v / 10) * length / second**2

        system = on_a_line(acceleration)
        system.constants = {"mu": 0.1}
        system.initial_conditions = {"x": 1.2 * length, "v": 0.0}
        orbit = system.find_periodic_orbit(2.0 * np.pi / rate)
        x, v = (orbit.initial_conditions[s] for s in system.states)
        orbits.append([x / length, v * second / length])
    np.testing.assert_allclose(*orbits, rtol=0.0, atol=1e-11)


@pytest.mark.parametrize(("metre", "second"), [(1e6, 1e3), (1e9, 1e-5), (1e-7, 1e-3)])
def test_the_period_of_a_free_oscillation_does_not_depend_on_units(metre, second):
    """In nanometres and at 1e5 rad/s the period was the guess, at 1e-3 rad/s all was at rest."""
    one, other = 1.0 / metre, 1.0 / second
    system = on_a_line(lambda x, v, mu: -(x + 0.3 * x**3 / one**2) * other**2)
    system.initial_conditions = {"x": one, "v": 0.0}
    orbit = system.find_periodic_orbit(6.0 / other)
    assert orbit.period * other == pytest.approx(5.70920503359, rel=1e-8)
    assert not orbit.equilibrium


@pytest.mark.parametrize(("metre", "second"), [(1.0, 1.0), (1e9, 1e-3)])
def test_a_pendulum_that_nearly_stands_is_fast_on_its_way(metre, second):
    """At both ends of its swing it hardly moves; its period is the elliptic integral."""
    system = on_a_line(lambda x, v, mu: -39.0 * metre / second**2 * sm.sin(x / metre))
    system.initial_conditions = {"x": 3.1415 * metre, "v": 0.0}
    orbit = system.find_periodic_orbit(7.2809 * second)
    amplitude = orbit.initial_conditions[system.states[0]] / metre
    expected = 4.0 * ellipk(np.sin(amplitude / 2) ** 2) / np.sqrt(39.0)
    assert orbit.period / second == pytest.approx(expected, rel=1e-5)


@pytest.mark.parametrize(("metre", "second"), [(1.0, 1.0), (1e9, 1e-3), (1e-7, 1e-5)])
def test_a_first_flight_that_runs_away_sets_no_sizes(metre, second):
    """x'' = w² x + cos t has one bounded motion, −cos t / (1 + w²), with the multiplier e²⁵."""
    rate = 25.0 / (2.0 * np.pi)
    system = on_a_line(lambda x, v, mu: (rate**2 * x + metre * sm.cos(t / second)) / second**2)
    system.initial_conditions = {"x": -0.05 * metre, "v": 0.0}
    orbit = system.find_periodic_orbit(2.0 * np.pi * second)
    x, v = (orbit.initial_conditions[s] for s in system.states)
    assert x / metre == pytest.approx(-1.0 / (1.0 + rate**2), rel=1e-10)
    assert v * second / metre == pytest.approx(0.0, abs=1e-10)


def truss(length, mass, time):
    """A particle between two springs, that hangs: it moves up and down, and not to a side."""
    x, y = me.dynamicsymbols("x y")
    N, O = inertial_frame()
    P = O.locatenew("P", x * N.x + y * N.y)
    loads = [(P, -0.1 * mass * length / time**2 * N.y)]
    for side in (-length, length):
        A = O.locatenew("A", side * N.x)
        A.set_vel(N, 0)
        spring = me.LinearSpring(10 * mass / time**2, me.LinearPathway(P, A), 1.25 * length)
        loads += spring.to_loads()
    made = Definition(N, [x, y], bodies=[me.Particle("p", P, mass)], loads=loads)
    return System(made, initial_conditions={y: 0.9 * length})


UNITS = [
    (1e12, 1.0, 1.0),
    (1e-9, 1e-9, 1.0),
    (1e9, 1e9, 1e9),
    (1.5e11, 1e30, 3e7),
    (1e6, 1.0, 1e-6),
]


@pytest.mark.parametrize("units", UNITS)
def test_a_state_that_nothing_moves_has_a_size_in_any_units(units):
    """Sideways there is rounding alone; in large units it was to close to a thousandth of 1."""
    expected = truss(1.0, 1.0, 1.0).find_periodic_orbit(2.4)
    orbit = truss(*units).find_periodic_orbit(2.4 * units[2])
    assert orbit.period / units[2] == pytest.approx(expected.period, rel=1e-7)
    found, wanted = (np.sort(found.multipliers.real) for found in (orbit, expected))
    np.testing.assert_allclose(found, wanted, rtol=0.0, atol=1e-4)
    assert orbit.residual < 1e-8 * units[0] / min(units[2], 1.0)


def rod_and_carriage(metre):
    """A carriage on a spring, on which a rod is hinged that turns as it is driven."""
    x, q, u, w = me.dynamicsymbols("x q u w")
    N, O = inertial_frame()
    hinge = O.locatenew("H", x * N.x)
    rod = N.orientnew("R", "Axis", (q, N.z))
    tip = hinge.locatenew("T", metre * rod.x)
    bodies = [me.Particle("carriage", hinge, 2.0), me.Particle("tip", tip, 1.0)]
    drive = (0.3 * sm.cos(t) - 0.2 * w) * metre**2
    loads = [(hinge, (-5 * x - u) * N.x), (rod, (drive - metre**2 * sm.sin(q)) * N.z)]
    return System(Definition(N, [x, q], [u, w], bodies=bodies, loads=loads))


@pytest.mark.parametrize("metre", [1e-9, 1e12])
def test_multipliers_of_lengths_beside_angles_are_the_same_in_any_units(metre):
    expected = rod_and_carriage(1.0).find_periodic_orbit(2.0 * np.pi)
    orbit = rod_and_carriage(metre).find_periodic_orbit(2.0 * np.pi)
    np.testing.assert_allclose(orbit.multipliers, expected.multipliers, rtol=0.0, atol=1e-9)
    sizes = np.array([metre, 1.0, metre, 1.0])
    scaled = orbit.monodromy / sizes[:, None] * sizes
    np.testing.assert_allclose(scaled, expected.monodromy, rtol=0.0, atol=1e-9)


def test_where_there_is_no_orbit_what_is_left_is_told():
    system = on_a_line(lambda x, v, mu: mu + 0 * x)
    with pytest.raises(PeriodicOrbitError, match=r"Nearest, at x = .*change over it"):
        system.find_periodic_orbit(1.0)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: s.find_periodic_orbit(-1.0), "`period` must be positive"),
        (lambda s: s.find_periodic_orbit(5e-324), "`period` must be long enough for 201 times"),
        (lambda s: s.find_periodic_orbit("long"), "`period`"),
        (lambda s: s.find_periodic_orbit(1.0, until="strike"), "`until` must be a pydy.solvers.Ev"),
        (lambda s: s.find_periodic_orbit(1.0, moving=["bogus"]), "bogus"),
        (lambda s: s.find_periodic_orbit(1.0, moving=s.speeds), "`moving` must hold coordinates"),
        (lambda s: s.find_periodic_orbit(1.0, until=Event(s.states[0] - 99)), "does not happen"),
    ],
)
def test_what_does_not_fit_is_named(call, message):
    with pytest.raises((ValueError, TypeError, PeriodicOrbitError), match=message):
        call(on_a_line(lambda x, v, mu: -mu * x))
    system = on_a_line(lambda x, v, mu: -mu * x)
    system.initial_conditions = {}
    with pytest.raises(ValueError, match="are an equilibrium, which is no orbit"):
        system.find_periodic_orbit(1.0)


def test_where_constraints_leave_nothing_to_search_for_it_says_so():
    x, v = me.dynamicsymbols("x v")
    N, O = inertial_frame()
    slider = me.Particle("slider", O.locatenew("P", x * N.x), 1)
    driven = Definition(N, [x], [v], bodies=[slider], holonomic_constraints=[x - sm.sin(t)])
    system = System(driven)
    system.set_dependent_initial_conditions()
    with pytest.raises(ValueError, match=r"no state to search for.*`simulate`"):
        system.find_periodic_orbit(2.0 * np.pi)


@pytest.mark.parametrize("stop", [KeyboardInterrupt, MemoryError])
def test_what_stops_a_search_hands_over_what_came_nearest(monkeypatch, capsys, stop):
    system = on_a_line(lambda x, v, mu: mu * (1 - x**2) * v - x)
    whole = system.find_periodic_orbit(6.5, progress=True)
    shown = capsys.readouterr().err
    assert "flights" in shown
    assert "gap=" in shown
    integrate, calls = pydy.analysis.orbits.integrate, []

    def interrupted(*given, **options):
        calls.append(1)
        if len(calls) > 3:
            raise stop
        return integrate(*given, **options)

    monkeypatch.setattr(pydy.analysis.orbits, "integrate", interrupted)
    with pytest.raises((AnalysisInterrupted, MemoryError)) as caught:
        system.find_periodic_orbit(6.5)
    assert isinstance(caught.value, MemoryError) == (stop is MemoryError)
    found = caught.value.results
    first = abs(6.5 - whole.period)
    assert 0.0 < abs(found["period"] - whole.period) < 0.2 * first
    assert list(found["initial_conditions"]) == list(whole.initial_conditions)
    monkeypatch.undo()
    system.initial_conditions = found["initial_conditions"]
    again = system.find_periodic_orbit(found["period"])
    assert again.period == pytest.approx(whole.period, rel=1e-10)


def test_an_early_ctrl_c_hands_over_where_it_began(monkeypatch):
    system = on_a_line(lambda x, v, mu: mu * (1 - x**2) * v - x)

    def interrupted(*given, **options):
        raise KeyboardInterrupt

    monkeypatch.setattr(pydy.analysis.orbits, "integrate", interrupted)
    with pytest.raises(AnalysisInterrupted) as caught:
        system.find_periodic_orbit(6.5)
    given = dict(system.initial_conditions)
    assert caught.value.results == {"period": 6.5, "initial_conditions": given}


def test_an_orbit_across_a_jump_of_the_load_warns_of_its_multipliers():
    system = on_a_line(lambda x, v, mu: -x - mu * sm.sign(x) - v / 10 + 2 * sm.cos(1.3 * t))
    system.constants = {"mu": 0.3}
    with pytest.warns(PyDyUserWarning, match="load on v.* jumps by 0.6, and the derivatives"):
        assert system.find_periodic_orbit(2 * np.pi / 1.3).residual < 1e-8


def test_a_period_that_the_forcing_does_not_have_is_named():
    x, v = me.dynamicsymbols("x v")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x)
    force = -x - x**3 - v / 10 + sm.cos(me.dynamicsymbols._t)
    bodies, loads = [me.Particle("b", place, 1)], [(place, force * frame.x)]
    system = System(Definition(frame, [x], [v], bodies=bodies, loads=loads), ode_solver="dop853")
    system.initial_conditions = {x: 1.0}
    with pytest.raises(PeriodicOrbitError, match="The equations do not have the `period` 6 s"):
        system.find_periodic_orbit(6.0)
    assert system.find_periodic_orbit(2 * np.pi).period == pytest.approx(2 * np.pi)


# With the stiff spring, the first Newton steps end where the rod does not reach.
@pytest.mark.parametrize(("foot", "stiffness"), [(0.2, 12), (0.5, 12), (1.0, 30), (1.5, 30)])
def test_multipliers_where_all_that_moves_is_what_the_constraint_drives(foot, stiffness):
    # A rod of length L(t) stands upright: a spring and a damper hold its foot, which rests. Small
    # motions x of the foot have m x'' = S x/L − k x − c x', with the force S = m_t (g + L'').
    x, y, vx, vy = me.dynamicsymbols("x y v_x v_y")
    frame, origin = inertial_frame()
    low, high = origin.locatenew("low", x * frame.x), origin.locatenew("high", y * frame.y)
    length = 2 + sm.sin(1.7 * t) / 2
    definition = Definition(
        frame, [x, y], [vx, vy],
        bodies=[me.Particle("foot", low, 1.2), me.Particle("top", high, 2.4)],
        loads=[(high, -10 * frame.y), (low, -(stiffness * x + 2 * vx) * frame.x)],
        holonomic_constraints=[x**2 + y**2 - length**2],
    )  # fmt: skip
    system = System(definition, ode_solver="dop853", initial_conditions={x: foot, y: 1.9, vx: 0.1})
    system.set_dependent_initial_conditions([y, vy])
    period = 2 * np.pi / 1.7
    orbit = system.find_periodic_orbit(period)
    assert orbit.equilibrium
    assert abs(orbit.initial_conditions[x]) < 1e-12 * foot

    def rates(time, state):
        force = 10 - 2.4 * 0.5 * 1.7**2 * np.sin(1.7 * time)
        pull = force / (2 + np.sin(1.7 * time) / 2) - stiffness
        return [state[1], (pull * state[0] - 2 * state[1]) / 1.2]

    monodromy = np.transpose(
        [
            solve_ivp(rates, (0, period), e, rtol=1e-11, atol=1e-13, method="DOP853").y[:, -1]
            for e in np.eye(2)
        ]
    )
    expected = np.linalg.eigvals(monodromy)
    np.testing.assert_allclose(
        np.sort_complex(orbit.multipliers), np.sort_complex(expected), atol=1e-8
    )


def test_flights_of_a_search_have_a_hundred_times_the_steps_of_the_best_one(monkeypatch):
    """One that runs away would take ten million."""
    flights, integrate = [], pydy.analysis.orbits.integrate

    def recorded(*args, max_steps=None, **options):
        limited = options if max_steps is None else {**options, "max_steps": max_steps}
        motion = integrate(*args, **limited)
        flights.append((max_steps, motion.statistics["steps"]))
        return motion

    monkeypatch.setattr(pydy.analysis.orbits, "integrate", recorded)
    on_a_line(lambda x, v, mu: mu * (1 - x**2) * v - x).find_periodic_orbit(6.5)
    most, steps = zip(*flights, strict=True)
    assert most[0] is None
    assert {limit for limit in most if limit is not None} <= {100 * count for count in steps}
    assert most[-1] is not None
