"""Adjoint gradients, against closed forms, forward sensitivities and integrations elsewhere."""

import re

import mpmath
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.linalg import expm

import zoo
from pydy import System
from pydy._interrupts import Interrupts
from pydy.contact import Contacts, Unilateral
from pydy.errors import IntegrationError, IntegrationInterrupted, PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.solvers import Event
from pydy.solvers.run import workspace
from pydy.solvers.run.backward import DiscreteAdjoint
from registry import ADAPTIVE_NAMES, EXPLICIT_NAMES, step_options
from zoo.ball import bouncing_ball
from zoo.cases import system_of, uncoupled

TIGHT = {"rtol": 1e-12, "atol": 1e-12}
NUMBERS = {"m0": 1.3, "k0": 2.0, "c0": 0.2, "x0": 1.0, "v0": 0.3}
EXPLICIT = {name: step_options(name, 1e-12) for name in EXPLICIT_NAMES}


def oscillator(solver="dop853", end=5.0):
    system = multi_mass_spring_damper(1)
    system.constants = {name: NUMBERS[name] for name in ("m0", "k0", "c0")}
    system.initial_conditions = {name: NUMBERS[name] for name in ("x0", "v0")}
    system.times = [0.0, end]
    system.ode_solver = solver
    return system


def exact_oscillator(end):
    """Position at the end, and ∫x² dt, with their derivatives by all five numbers."""
    found = []
    for k in range(5):
        m, stiffness, c, x, v = [
            value + 1e-30j * (j == k) for j, value in enumerate(NUMBERS.values())
        ]
        A = np.array([[0.0, 1.0], [-stiffness / m, -c / m]])
        # d/dt of the products x x, x v, v v is linear in them, and so is the integral of the first.
        (_, b), (d, e) = A
        products = np.array(
            [[0, 2 * b, 0, 0], [d, e, b, 0], [0, 2 * d, 2 * e, 0], [1.0, 0, 0, 0]], dtype=complex
        )
        position = (expm(A * end) @ [x, v])[0]
        square = (expm(products * end) @ [x * x, x * v, v * v, 0.0])[3]
        found.append((position, square))
    values = np.array(found)
    return values[0].real, values.imag.T / 1e-30


@pytest.mark.parametrize(("solver", "options"), EXPLICIT.items())
def test_a_linear_system_follows_the_matrix_exponential(solver, options):
    system = oscillator(solver)
    values, slopes = exact_oscillator(5.0)
    names = list(NUMBERS)
    terms = ({"final": "x0"}, {"integral": system.states[0] ** 2})
    for value, slope, term in zip(values, slopes, terms, strict=True):
        found = system.adjoint_gradient(names, **term, **options)
        np.testing.assert_allclose(found.value, value, rtol=1e-9)
        np.testing.assert_allclose(found.values, slope, rtol=0, atol=1e-9 * np.abs(slope).max())


def test_a_pendulum_follows_elliptic_functions():
    """A pendulum let go at rest: sin(θ/2) = k sn(K(k) − ω t, k) with k = sin(θ0/2)."""
    system = n_link_pendulum_on_cart(1, cart_force=False)
    q, u = me.dynamicsymbols("q, u")
    l, g = sm.symbols("l, g")
    N = me.ReferenceFrame("N")
    rod = N.orientnew("rod", "Axis", (q, N.z))
    rod.set_ang_vel(N, u * N.z)
    pivot = me.Point("pivot")
    pivot.set_vel(N, 0)
    bob = pivot.locatenew("bob", -l * rod.y)
    bob.v2pt_theory(pivot, N, rod)
    kane = me.KanesMethod(
        N, [q], [u], [q.diff() - u],
        forcelist=[(bob, -g * N.y)], bodies=[me.Particle("weight", bob, 1)],
    )  # fmt: skip
    system = System(kane, {l: 1.3, g: 9.81}, initial_conditions={q: 1.2}, times=[0.0, 3.0])

    def angle(values):
        length, gravity, start = values
        k = mpmath.sin(start / 2)
        phase = mpmath.ellipk(k**2) - mpmath.sqrt(gravity / length) * 3
        return 2 * mpmath.asin(k * mpmath.ellipfun("sn", phase, m=k**2))

    found = system.adjoint_gradient([l, g, q], final=q, **TIGHT)
    with mpmath.workdps(30):
        point = [mpmath.mpf("1.3"), mpmath.mpf("9.81"), mpmath.mpf("1.2")]
        value = angle(point)
        slopes = [
            mpmath.diff(lambda z, k=k: angle([z if j == k else p for j, p in enumerate(point)]), p)
            for k, p in enumerate(point)
        ]
    assert found.value == pytest.approx(float(value), rel=1e-10)
    np.testing.assert_allclose(found.values, np.array(slopes, dtype=float), rtol=1e-9)


def forward(system, wrt, gradient, **options):
    """Return φ_x S at the end from forward sensitivities."""
    trajectory = system.simulate(sensitivities=wrt, **options)
    return gradient @ trajectory.sensitivity.values[-1]


def agree(found, expected, accuracy=1e-8):
    np.testing.assert_allclose(found, expected, rtol=0, atol=accuracy * np.abs(expected).max())


def cart(n=3):
    system = n_link_pendulum_on_cart(n)
    system.constants = {"g": 9.81, "m1": 0.5}
    system.initial_conditions = {"q1": 3.3, f"u{n}": 1.0}
    system.times = np.linspace(0.0, 1.5, 4)
    system.ode_solver = "dop853"
    return system


def test_backward_is_forward_to_rounding_in_the_same_steps():
    system = cart()
    wrt = [*system.constants_symbols, *system.states, "F"]
    weights = np.arange(1.0, len(system.states) + 1)
    expression = sum(w * s for w, s in zip(weights, system.states, strict=True))
    # Where the error decides, steps of the two runs are the same to rounding only: an estimate of
    # 1e-5 is known to 1e-11 of itself, and step by step the difference grows to 1e-6.
    decided = {"rtol": 1e-5, "atol": 1e-5}
    given = {"rtol": 1e-2, "atol": 1e-2, "first_step": 0.01, "max_step": 0.01}
    for solver in ("dop853", "tsit5", "vern9"):
        system.ode_solver = solver
        for options, accuracy in ((given, 1e-12), (decided, 1e-8)):
            found = system.adjoint_gradient(wrt, final=expression, **options)
            agree(found.values, forward(system, wrt, weights, **options), accuracy)
            assert found["q1"] == found.by_state[1]
            assert found.trajectory.states.shape == (4, 8)


def test_all_steps_are_kept_however_many(monkeypatch):
    system = cart()
    kept = system.adjoint_gradient("constants", final="q3", **TIGHT)
    monkeypatch.setattr(workspace, "STEPS_MEMORY", 1)
    monkeypatch.setattr(workspace, "_STEPS", 50)
    again = system.adjoint_gradient("constants", final="q3", **TIGHT)
    agree(again.values, kept.values, 1e-12)


def test_other_back_ends_go_back_too():
    system = cart(1)
    expected = system.adjoint_gradient("constants", final="q1", rtol=1e-6, atol=1e-6).values
    system.generate_ode_function(generator="lambdify")
    found = system.adjoint_gradient("constants", final="q1", rtol=1e-6, atol=1e-6).values
    agree(found, expected)


@pytest.mark.parametrize("interpolation", ["linear", "previous"])
def test_samples_of_an_input(interpolation):
    system = cart(1)
    knots = np.linspace(0.0, 1.5, 7)
    system.specifieds = {"F": SampledInput(knots, np.sin(knots), interpolation)}
    wrt = ["F", "m0"]
    found = system.adjoint_gradient(wrt, final="q0", max_step=0.01, **TIGHT)
    weights = np.array([1.0, 0.0, 0.0, 0.0])
    agree(found.values, forward(system, wrt, weights, max_step=0.01, **TIGHT))
    assert found["F"].shape == (7,)
    assert found.names[-2:] == ("F[6]", "m0")


@pytest.mark.parametrize("interpolation", ["linear", "previous"])
def test_samples_in_a_line_have_the_derivatives_of_the_motion(interpolation):
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    system.ode_solver, system.constants = "dop853", {"k0": 4.0, "c0": 0.0}
    system.times, knots, w = [0.0, 2.0], np.linspace(0.0, 2.0, 41), 2.0
    system.specifieds = {"f0": SampledInput(knots, np.zeros(41), interpolation)}
    # x(2) by a force at s is sin(w (2 − s)) / w; by a sample, its mean under the hat or the step.
    rest, h = 2.0 - knots, knots[1]
    if interpolation == "linear":
        at, before, after = (np.sin(w * (rest + d)) for d in (0.0, h, -h))
        exact = (2.0 * at - before - after) / (w**3 * h)
        exact[0] = (at[0] - after[0]) / (w**3 * h) - np.cos(2.0 * w) / w**2
        exact[-1] = (w * h - np.sin(w * h)) / (w**3 * h)
    else:
        exact = np.append(np.cos(w * rest[1:]) - np.cos(w * rest[:-1]), 0.0) / w**2
    gradient = system.adjoint_gradient("f0", final="x0", rtol=1e-10, atol=1e-10)
    forward = system.simulate(sensitivities=["f0"], rtol=1e-10, atol=1e-10).sensitivity
    for found in (gradient["f0"], forward["x0", "f0"][-1]):
        assert np.abs(found - exact).max() < 1e-4 * np.abs(exact).max()
    assert gradient["f0[3]"] == gradient["f0"][3]


def test_constants_in_expressions_for_specifieds():
    system = cart(1)
    a, w = sm.symbols("a, w")
    system.specifieds = {"F": a * sm.sin(w * me.dynamicsymbols._t)}
    system.constants.update({"g": 9.81, a: 1.5, w: 2.0, "m1": 1.0})
    found = system.adjoint_gradient([a, w], final="q0", **TIGHT)
    agree(found.values, forward(system, [a, w], np.array([1.0, 0.0, 0.0, 0.0]), **TIGHT))


def test_groups_may_stand_in_lists():
    system = oscillator()
    found = system.adjoint_gradient(["constants", "x0"], final="x0", **TIGHT)
    assert found.names == ("c0", "k0", "m0", "x0")
    assert found["x0"] == system.adjoint_gradient("x0", final="x0", **TIGHT)["x0"]


# -- events ---------------------------------------------------------------------------------------


def ball():
    """A ball that falls from a height, and what bounces off with a share of its speed."""
    y, v = me.dynamicsymbols("y, v")
    m, g, e, drag = sm.symbols("m, g, e, drag")
    N = me.ReferenceFrame("N")
    ground = me.Point("ground")
    ground.set_vel(N, 0)
    centre = ground.locatenew("centre", y * N.y)
    centre.set_vel(N, v * N.y)
    kane = me.KanesMethod(
        N, [y], [v], [y.diff() - v],
        forcelist=[(centre, (-m * g - drag * v) * N.y)], bodies=[me.Particle("ball", centre, m)],
    )  # fmt: skip
    system = System(kane)
    system.outputs = {"rebound": e * v}
    system.constants = {m: 1.0, g: 10.0, drag: 0.0, e: 0.8}
    system.initial_conditions = {y: 5.0}
    system.ode_solver = "dop853"
    return system, (y, v), (g, e, drag)


def test_a_ball_that_bounces():
    """Thrown up at e sqrt(2 g h) after sqrt(2 h / g), where its height at the end is by hand."""
    system, (y, v), (g, e, drag) = ball()
    bounce = Event(y, direction=-1, reset={v: -e * v}, name="bounce")
    system.times = [0.0, 1.5]
    found = system.adjoint_gradient([g, e, y, drag], final=y, events=bounce, **TIGHT)
    G, E, h, t = sm.symbols("G, E, h, t")
    fall = sm.sqrt(2 * h / G)
    height = E * sm.sqrt(2 * G * h) * (t - fall) - G * (t - fall) ** 2 / 2
    at = {G: 10.0, E: 0.8, h: 5.0, t: 1.5}
    expected = [float(height.diff(s).subs(at)) for s in (G, E, h)]
    np.testing.assert_allclose(found.value, float(height.subs(at)), rtol=1e-11)
    np.testing.assert_allclose(found.values[:3], expected, rtol=1e-9)
    both = forward(system, [g, e, y, drag], np.array([1.0, 0.0]), events=bounce, **TIGHT)
    agree(found.values, both)


def test_an_integral_through_events_that_a_parameter_moves():
    system, (y, v), (g, e, _) = ball()
    bounce = Event(y, direction=-1, reset={v: -e * v}, name="bounce")
    system.times = [0.0, 1.5]
    found = system.adjoint_gradient([g, e, y], integral=v**2 + y, events=bounce, **TIGHT)
    G, E, h, t = sm.symbols("G, E, h, t", positive=True)
    fall = sm.sqrt(2 * h / G)
    up = E * sm.sqrt(2 * G * h)
    first = sm.integrate((G * t) ** 2 + h - G * t**2 / 2, (t, 0, fall))
    then = sm.integrate((up - G * t) ** 2 + up * t - G * t**2 / 2, (t, 0, 1.5 - fall))
    at = {G: 10.0, E: 0.8, h: 5.0}
    np.testing.assert_allclose(found.value, float((first + then).subs(at)), rtol=1e-10)
    expected = [float((first + then).diff(s).subs(at)) for s in (G, E, h)]
    np.testing.assert_allclose(found.values, expected, rtol=1e-9)


@pytest.mark.parametrize("integrated", [False, True])
def test_a_motion_that_ends_roundings_after_an_event(integrated):
    """Where a step of few roundings finds the event again, this is undone."""
    system, (y, v), (g, e, _) = ball()
    bounce = Event(y, direction=-1, reset={v: -e * v}, name="bounce")
    system.times = [0.0, 4.0]
    first = system.simulate(events=bounce).events[0].time
    terms = {"final": y, "integral": y} if integrated else {"final": y}
    for k in range(-16, 17):
        end = first + k * np.spacing(first)
        system.times = [0.0, end]
        found = system.adjoint_gradient([g], events=bounce, **terms)
        assert found.time == end
        assert found.value == pytest.approx(10.0 / 3.0 if integrated else 0.0, abs=1e-6)


def test_the_time_and_speed_at_which_a_terminal_event_ends():
    system, (y, v), (g, e, _) = ball()
    ground = Event(y, direction=-1, terminal=True, reset={v: -e * v}, name="ground")
    system.times = [0.0, 5.0]
    t = me.dynamicsymbols._t
    G, E, h = 10.0, 0.8, 5.0
    fall, speed = np.sqrt(2 * h / G), np.sqrt(2 * G * h)
    for term in ({"final": t}, {"integral": 1}):
        found = system.adjoint_gradient([g, e, y], **term, events=ground, **TIGHT)
        np.testing.assert_allclose(found.value, fall, rtol=1e-10)
        np.testing.assert_allclose(found.values, [-fall / G / 2, 0.0, fall / h / 2], atol=1e-9)
        assert found.time == pytest.approx(fall)
    found = system.adjoint_gradient([g, e, y], final=v, events=ground, **TIGHT)
    np.testing.assert_allclose(found.value, E * speed, rtol=1e-10)
    np.testing.assert_allclose(
        found.values, [E * speed / G / 2, speed, E * speed / h / 2], rtol=1e-9
    )


def test_an_event_that_a_jump_of_an_input_makes_happen_has_a_time_of_its_own():
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    system.ode_solver, system.times = "dop853", [0.0, 0.5, 1.5]
    (x0, v0), (force,) = system.states, system.specifieds_symbols
    system.constants, system.initial_conditions = {"k0": 2.0, "c0": 0.3}, {"x0": 0.1}
    push = SampledInput([0.0, 0.6, 1.5], [1.0, -2.0, -2.0], "previous")
    system.specifieds = {force: push}
    for ends, value in ((False, x0), (True, x0 + me.dynamicsymbols._t)):
        kick = Event(force + 0.5, terminal=ends, reset={v0: -0.5 * v0}, name="kick")
        found = system.adjoint_gradient(
            ["constants", "x0"], final=value, integral=v0**2, events=kick, **TIGHT
        )
        for k, symbol in enumerate([*system.constants_symbols, x0]):
            ahead, behind = (_moved(system, symbol, h, value, v0**2, kick) for h in (1e-4, -1e-4))
            assert found.values[k] == pytest.approx((ahead - behind) / 2e-4, abs=1e-7)


def _moved(system, symbol, change, final, integral, event):
    """The scalar at a slightly changed number."""
    kind = "initial_conditions" if symbol in system.states else "constants"
    before = getattr(system, kind)
    named = {str(key).removesuffix("(t)"): value for key, value in before.items()}
    name = symbol.name
    setattr(system, kind, {**named, name: named.get(name, 1.0) + change})
    found = system.adjoint_gradient([symbol], final=final, integral=integral, events=event, **TIGHT)
    setattr(system, kind, {})  # without a word of what is dropped
    setattr(system, kind, before)
    return found.value


def test_an_event_that_is_only_grazed_is_refused():
    system, (y, v), (g, *_) = ball()
    system.initial_conditions = {y: 0.0, v: 10.0}
    top = Event(y - 5.0 + 1e-6, terminal=True, name="top")
    system.times, loose = [0.0, 1.5], {"rtol": 1e-4, "atol": 1e-4, "max_step": 1e-3}
    with pytest.raises(IntegrationError, match="`top`, which the motion only grazes: by 1e-06"):
        system.adjoint_gradient([g], final=y, events=top, **loose)


def test_bounces_that_accumulate_are_told_by_gradients_too():
    system, bounce = bouncing_ball(e=0.5)
    asked = {"final": system.coordinates[0], "events": bounce, "rtol": 1e-5}
    system.times = [0.0, 1.5]  # they accumulate at 1.345
    with pytest.raises(IntegrationError, match="follow each other at ever shorter"):
        system.adjoint_gradient(["e"], atol=1e-4, **asked)
    system.times = [0.0, 1.34]  # a few, which a tolerance resolves
    with pytest.raises(
        IntegrationError, match=r"lower `atol` from 0\.0001 to less than"
    ) as refused:
        system.adjoint_gradient(["e"], atol=1e-4, **asked)
    enough = float(re.search(r"less than (\S+)\. Otherwise", str(refused.value))[1])
    landing = np.sqrt(0.25 + 1.8 * 9.81)

    def height(e):
        time, speed = (0.5 + landing) / 9.81, e * landing
        while time + 2.0 * speed / 9.81 < 1.34:
            time, speed = time + 2.0 * speed / 9.81, e * speed
        return 0.1 + speed * (1.34 - time) - 9.81 * (1.34 - time) ** 2 / 2.0

    found = system.adjoint_gradient(["e"], atol=0.99 * enough, **asked)
    slope = (height(0.5 + 1e-6) - height(0.5 - 1e-6)) / 2e-6
    assert found["e"] == pytest.approx(slope, rel=1e-2)


# -- constraints ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "holding", [{"constraints": "project"}, {"constraints": "baumgarte", "gain": 5.0}]
)
def test_a_closed_loop(holding):
    system = system_of(zoo.fourbar())
    system.ode_solver = "dop853"
    system.times = np.linspace(0.0, 1.0, 3)
    system.set_dependent_initial_conditions()
    wrt = [*system.constants_symbols]
    weights = np.linspace(1.0, 2.0, len(system.states))
    expression = sum(w * s for w, s in zip(weights, system.states, strict=True))
    found = system.adjoint_gradient(wrt, final=expression, **holding, **TIGHT)
    agree(found.values, forward(system, wrt, weights, **holding, **TIGHT))


# -- what the motion does not excite --------------------------------------------------------------

CONTROLLED = [name for name in EXPLICIT_NAMES if name in ADAPTIVE_NAMES]
LOOSE, RATIO = {"rtol": 1e-8, "atol": 1e-8}, 50.0


def allowed(found, rtol=1e-8):
    """Return the error of a fast direction, in units of its size.

    Each step may add a thousand tolerances, as a root mean square of four components.
    """
    bound = 2.0 * 1e3 * rtol * found.statistics["steps"]
    assert bound < 0.1
    return bound


@pytest.mark.parametrize("solver", CONTROLLED)
@pytest.mark.parametrize(
    ("ratio", "damping"), [(5.0, 0.0), (10.0, 0.0), (RATIO, 0.0), (10.0, 0.2), (10.0, -0.2)]
)
def test_a_direction_that_the_motion_does_not_excite_is_resolved(solver, ratio, damping):
    """No error of the states shows it: at ten times the motion's frequency 0.5 was 1e16."""
    system = uncoupled(solver, ratio, damping)
    y, v = system.states[1::2]
    found = system.adjoint_gradient([y], final=y, integral=v, **LOOSE)
    rate, decay = np.sqrt(ratio**2 - damping**2 / 4.0), damping / 2.0
    phase, size = rate * 20.0, np.exp(-decay * 20.0)
    of_y = size * (np.cos(phase) + decay / rate * np.sin(phase))
    of_v = size * np.sin(phase) / rate
    bound = allowed(found) * (1.0 + size)
    # What is integrated is the speed: y once more, without its start.
    assert found["y"] == pytest.approx(2.0 * of_y - 1.0, abs=2.0 * bound)
    expected = [0.0, 2.0 * of_y - 1.0, 0.0, 2.0 * of_v]
    np.testing.assert_allclose(found.by_state, expected, rtol=0, atol=2.0 * bound)


@pytest.mark.parametrize("solver", CONTROLLED)
def test_a_load_that_is_zero_on_what_does_not_move(solver):
    system = uncoupled(solver, RATIO, load=sm.cos(7 * me.dynamicsymbols._t))
    found = system.adjoint_gradient(["P"], final=system.states[1], **LOOSE)
    expected = (np.cos(140.0) - np.cos(20.0 * RATIO)) / (RATIO**2 - 49.0)
    assert found["P"] == pytest.approx(expected, abs=2.0 * allowed(found) / RATIO**2)


def test_samples_of_a_load_that_are_zero_on_what_does_not_move():
    """By Duhamel's integral of each hat function, in closed form."""
    F, T = me.dynamicsymbols("F"), 6.0
    system = uncoupled("dop853", RATIO, end=T, load=F)
    system.constants["P"], times = 1.0, np.linspace(0.0, T, 7)
    system.specifieds = {F: SampledInput(times, np.zeros(7))}
    found = system.adjoint_gradient([F], final=system.states[1], **LOOSE)
    s = sm.Symbol("s")

    def piece(start, rising):
        hat = (s - start) if rising else (start + 1 - s)
        return float(sm.integrate(hat * sm.sin(RATIO * (T - s)) / RATIO, (s, start, start + 1)))

    up, down = ([piece(k, rising) for k in range(6)] for rising in (True, False))
    expected = np.add([0.0, *up], [*down, 0.0])
    np.testing.assert_allclose(found["F"], expected, rtol=0, atol=2.0 * allowed(found) / RATIO**2)


@pytest.mark.parametrize("terms", [{}, {"integral": 1}])
def test_what_the_motion_does_not_excite_goes_on_through_events(terms):
    """The first oscillator is thrown back where it passes zero; the other one stays at rest."""
    system = uncoupled("dop853", RATIO)
    x, y, u, _ = system.states
    back = Event(x, direction=-1, reset={u: -u}, name="back")
    found = system.adjoint_gradient([x, y], final=x + y, events=back, **terms, **LOOSE)
    assert len(found.trajectory.events) == 6
    assert found["y"] == pytest.approx(np.cos(20.0 * RATIO), abs=2.0 * allowed(found))
    # Reflected, it is |cos t|.
    assert found["x"] == pytest.approx(abs(np.cos(20.0)), abs=2.0 * allowed(found))
    plain = system.simulate(events=back, **LOOSE)
    assert found.trajectory.events[-1].time == pytest.approx(plain.events[-1].time, abs=1e-6)


@pytest.mark.parametrize(
    "holding", [{"constraints": "project"}, {"constraints": "baumgarte", "gain": 5.0}]
)
def test_what_constrained_motions_do_not_excite(holding):
    """A point swings on a circle, as a pendulum; a spring holds it in the plane of the circle."""
    x, y, z, u, v, w = me.dynamicsymbols("x y z u v w")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", x * frame.x + y * frame.y + z * frame.z)
    bodies = [me.Particle("bob", place, 1)]
    loads = [(place, -frame.y - RATIO**2 * z * frame.z)]
    definition = Definition(
        frame,
        [x, y, z],
        [u, v, w],
        bodies=bodies,
        loads=loads,
        holonomic_constraints=[x**2 + y**2 - 1],
    )
    system = System(definition, ode_solver="dop853", times=[0.0, 20.0])
    system.initial_conditions = {x: 0.6, y: -0.8}
    system.set_dependent_initial_conditions(dep_vars=[y, v])
    found = system.adjoint_gradient([z, w], final=z, **holding, **LOOSE)
    expected = [np.cos(20.0 * RATIO), np.sin(20.0 * RATIO) / RATIO]
    np.testing.assert_allclose(found.values, expected, rtol=0, atol=2.0 * allowed(found))


def test_what_motions_with_contacts_do_not_excite():
    """The first oscillator bounces where it passes zero; the other one stays at rest."""
    system = uncoupled("dop853", RATIO)
    x, y = system.states[:2]
    contacts = Contacts(system, [Unilateral(x, restitution=1.0, name="wall")])
    found = system.adjoint_gradient([x, y], final=x + y, contacts=contacts, **LOOSE)
    assert len(found.trajectory.events) == 6
    assert found["y"] == pytest.approx(np.cos(20.0 * RATIO), abs=2.0 * allowed(found))
    assert found["x"] == pytest.approx(abs(np.cos(20.0)), abs=2.0 * allowed(found))


@pytest.mark.parametrize("solver", CONTROLLED)
def test_ordinary_motions_have_their_steps(solver):
    """Each of the masses moves in all modes."""
    system = multi_mass_spring_damper(4, apply_gravity=True)
    system.initial_conditions = {system.states[0]: 1.0}
    system.times, system.ode_solver = np.linspace(0.0, 10.0, 5), solver
    for tolerance in (1e-5, 1e-8, 1e-11):
        own = {"rtol": tolerance, "atol": tolerance}
        steps = system.simulate(**own).statistics["steps"]
        found = system.adjoint_gradient("constants", final="x3", **own)
        assert found.statistics["steps"] == pytest.approx(steps, rel=0.01)


def test_steps_that_no_derivatives_bound_are_told():
    system = uncoupled("dop853", RATIO)
    y = system.states[1]
    with pytest.warns(PyDyUserWarning, match="beside them `dop853` took 100 steps, `max_steps` at"):
        found = system.adjoint_gradient([y], final=y, max_steps=100, **LOOSE)
    assert found.statistics["steps"] == system.simulate(**LOOSE).statistics["steps"]


def test_a_derivative_that_is_not_finite_matters_only_where_the_scalar_depends_on_it():
    """A body stays where the root in its force has no derivative, beside an oscillator."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    force = -x * frame.x - sm.sqrt(sm.Abs(y)) * frame.y
    bodies, loads = [me.Particle("body", place, 1)], [(place, force)]
    system = System(Definition(frame, [x, y], [u, v], bodies=bodies, loads=loads))
    system.initial_conditions, system.times = {x: 1.0}, [0.0, 3.0]
    found = system.adjoint_gradient([x, u], final=x, **TIGHT)
    np.testing.assert_allclose(found.values, [np.cos(3.0), np.sin(3.0)], rtol=1e-9)
    with pytest.raises(ValueError, match="The derivatives of the equations are not finite between"):
        system.adjoint_gradient([x, u], final=x + y, **TIGHT)


# -- what goes wrong ------------------------------------------------------------------------------


def test_what_cannot_be_done_is_said():
    system = oscillator()
    with pytest.raises(ValueError, match="`final` or `integral` must be given"):
        system.adjoint_gradient(["m0"])
    with pytest.raises(ValueError, match="`wrt` has the key `M`"):
        system.adjoint_gradient(["M"], final="x0")
    with pytest.raises(ValueError, match="`final` must be an output of the system"):
        system.adjoint_gradient(["m0"], final="nothing")
    with pytest.raises(ValueError, match="`z` occurs in `integral`"):
        system.adjoint_gradient(["m0"], integral=sm.Symbol("z"))
    system.ode_solver = "radau"
    with pytest.raises(ValueError, match="simulate\\(sensitivities"):
        system.adjoint_gradient(["m0"], final="x0")
    pendulum = cart(1)
    pendulum.specifieds = {"F": SampledInput([0, 1, 2], [0, 1, 0], "pchip")}
    with pytest.raises(ValueError, match=r"`wrt` has `F.t.`, whose samples are .* 'pchip'"):
        pendulum.adjoint_gradient(["F"], final="q0", max_steps=1)  # said before a step is taken
    pendulum.specifieds = {"F": lambda x, t: 0.0}
    with pytest.raises(ValueError, match="`wrt` needs the derivatives of the specifieds"):
        pendulum.adjoint_gradient(["m0"], final="q0")


def test_a_gradient_is_read_by_symbol_and_name():
    system = oscillator()
    found = system.adjoint_gradient(["k0", "x0"], final="x0", rtol=1e-8, atol=1e-8)
    (k0,) = [s for s in system.constants_symbols if s.name == "k0"]
    assert found["k0"] == found[k0] == found.values[0]
    assert str(found).startswith("Gradient of ")
    with pytest.raises(KeyError, match="k0, x0"):
        found["c0"]


def test_arrays_of_tolerances_hold_for_the_integral_too():
    system = oscillator()
    found = system.adjoint_gradient(["k0"], integral="x0", rtol=[1e-10, 1e-11], atol=[1e-10, 1e-12])
    exact = system.adjoint_gradient(["k0"], integral="x0", **TIGHT)
    assert found["k0"] == pytest.approx(exact["k0"], rel=1e-8)


def test_arrays_of_tolerances_hold_for_an_integral_beside_samples_too():
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    system.ode_solver, system.times = "dop853", [0.0, 2.0]
    system.specifieds = {"f0": SampledInput([0.0, 1.0, 2.0], [0.0, 1.0, 0.5])}
    arrays = {"rtol": [1e-10, 1e-11], "atol": [1e-10, 1e-12]}
    found = system.adjoint_gradient("f0", integral="x0", **arrays)
    exact = system.adjoint_gradient("f0", integral="x0", **TIGHT)
    agree(found["f0"], exact["f0"], 1e-8)


def test_ctrl_c_hands_over_the_motion(monkeypatch, capsys):
    system = oscillator()
    system.times = np.linspace(0.0, 1e4, 100_001)
    run = {"final": "x0", "integral": "x0", "rtol": 1e-8, "atol": 1e-8}
    system.adjoint_gradient("k0", progress=True, **run)
    shown = capsys.readouterr().err
    assert "dop853: 100%" in shown
    assert "steps back" in shown
    states = system.simulate(rtol=1e-8, atol=1e-8).states

    def interrupted(*arguments):
        raise KeyboardInterrupt

    monkeypatch.setattr(DiscreteAdjoint, "sweep_back", interrupted)
    with pytest.raises(IntegrationInterrupted, match="way back through the motion") as caught:
        system.adjoint_gradient("k0", **run)
    assert caught.value.time == 1e4
    assert caught.value.state.shape == (2,)
    np.testing.assert_array_equal(caught.value.times, system.times)
    np.testing.assert_allclose(caught.value.states, states, atol=1e-5)
    monkeypatch.setattr(Interrupts, "check", interrupted)
    with pytest.raises(IntegrationInterrupted, match="was interrupted at t") as caught:
        system.adjoint_gradient("k0", **run)
    assert caught.value.states.shape == (len(caught.value.times), 2)
    assert caught.value.state.shape == (2,)
