"""Sensitivities of trajectories, against closed forms and integrations at other numbers."""

import re

import mpmath
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import odeint
from scipy.linalg import expm

import zoo
from pydy import System
from pydy._integration.step_control import least_sizes
from pydy.errors import IntegrationError, IntegrationInterrupted, PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.solvers import Event
from pydy.solvers.run.integration import Integration
from pydy.solvers.sensitivities import CompiledSensitivities
from registry import ADAPTIVE_NAMES
from zoo import inertial_frame
from zoo.ball import bouncing_ball
from zoo.cases import system_of, uncoupled
from zoo.circle import on_a_circle

TIGHT = {"rtol": 1e-12, "atol": 1e-12}
NUMBERS = {"m0": 1.3, "k0": 2.0, "c0": 0.2, "x0": 1.0, "v0": 0.3}


def oscillator(number=11):
    system = multi_mass_spring_damper(1)
    system.constants = {name: NUMBERS[name] for name in ("m0", "k0", "c0")}
    system.initial_conditions = {name: NUMBERS[name] for name in ("x0", "v0")}
    system.times = np.linspace(0.0, 5.0, number)
    return system


def exact_oscillator(times):
    """Derivatives of exp(A t) x0 by all five numbers, by complex steps: (m, 2, 5)."""
    columns = []
    for k in range(5):
        m, stiffness, c, x, v = [
            value + 1e-30j * (j == k) for j, value in enumerate(NUMBERS.values())
        ]
        matrix = np.array([[0.0, 1.0], [-stiffness / m, -c / m]])
        columns.append([(expm(matrix * t) @ [x, v]).imag / 1e-30 for t in times])
    return np.moveaxis(columns, 0, -1)


def relative(found, expected):
    return np.abs(found - expected).max() / np.abs(expected).max()


def test_a_matrix_of_parameters_is_a_list_of_them():
    system = oscillator()
    states = sm.Matrix(system.states)
    found = system.simulate(sensitivities=states).sensitivity
    expected = system.simulate(sensitivities=list(states)).sensitivity
    np.testing.assert_array_equal(found.values, expected.values)


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_a_linear_system_follows_the_matrix_exponential(solver):
    system = oscillator()
    system.ode_solver = solver
    trajectory = system.simulate(sensitivities=list(NUMBERS), **TIGHT)
    assert relative(trajectory.sensitivity.values, exact_oscillator(system.times)) < 1e-9


def test_a_solver_of_the_users_integrates_sensitivities():
    system = oscillator()
    found = system.simulate(sensitivities=list(NUMBERS), **TIGHT).sensitivity.values
    system.ode_solver = lambda f, x0, t, args, **options: odeint(f, x0, t, args=args, **options)
    again = system.simulate(sensitivities=list(NUMBERS), rtol=[1e-12, 1e-12], atol=1e-12)
    expected = exact_oscillator(system.times)
    assert max(relative(found, expected), relative(again.sensitivity.values, expected)) < 1e-9


def test_fixed_steps_carry_sensitivities():
    system = oscillator()
    system.ode_solver = "rk4"
    trajectory = system.simulate(sensitivities=["k0"], step=1e-3)
    expected = exact_oscillator(system.times)[:, :, 1]
    assert relative(trajectory.sensitivity.values[:, :, 0], expected) < 1e-9


def test_a_pendulum_follows_elliptic_functions():
    q, u = me.dynamicsymbols("q, u")
    m, length, g = sm.symbols("m, l, g")
    frame, origin = inertial_frame()
    arm = frame.orientnew("A", "Axis", (q, frame.z))
    arm.set_ang_vel(frame, u * frame.z)
    bob = origin.locatenew("P", -length * arm.y)
    bob.v2pt_theory(origin, frame, arm)
    kane = me.KanesMethod(frame, q_ind=[q], u_ind=[u], kd_eqs=[q.diff() - u])
    kane.kanes_equations([me.Particle("bob", bob, m)], [(bob, -m * g * frame.y)])
    system = System(kane, constants={m: 1.2, length: 0.7, g: 9.81}, ode_solver="dop853")
    system.initial_conditions, system.times = {q: 1.1}, np.linspace(0.0, 3.0, 7)
    found = system.simulate(sensitivities=[q, length, g, m], **TIGHT).sensitivity

    def angle(q0, length, g, t):
        k = mpmath.sin(q0 / 2)
        wave = mpmath.ellipfun("cd", mpmath.sqrt(g / length) * t, m=k * k)
        return 2 * mpmath.asin(k * wave)

    with mpmath.workdps(40):
        numbers = [mpmath.mpf("1.1"), mpmath.mpf("0.7"), mpmath.mpf("9.81")]
        orders = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
        expected = [
            [float(mpmath.diff(lambda *v, t=t: angle(*v, t), numbers, order)) for order in orders]
            for t in system.times.tolist()
        ]
    assert relative(found[q][:, :3], np.array(expected)) < 1e-9
    assert np.abs(found[q, m]).max() < 1e-13


def test_steps_are_those_without_sensitivities_unless_they_are_asked_for():
    system = n_link_pendulum_on_cart(2)
    system.initial_conditions = {"q1": 0.4}
    system.times, system.ode_solver = np.linspace(0.0, 2.0, 5), "dop853"
    plain = system.simulate(rtol=1e-8, atol=1e-8)
    beside = system.simulate(sensitivities=["m1", "q1"], rtol=1e-8, atol=1e-8)
    controlled = system.simulate(
        sensitivities=["m1", "q1"], control_sensitivities=True, rtol=1e-8, atol=1e-8
    )
    assert beside.statistics["steps"] == plain.statistics["steps"]
    assert beside.statistics["evaluations"] == plain.statistics["evaluations"]
    assert controlled.statistics["steps"] > plain.statistics["steps"]
    assert np.allclose(beside.states, plain.states, rtol=0.0, atol=1e-9)


def test_sensitivities_agree_with_the_variational_equations_integrated_apart():
    system = n_link_pendulum_on_cart(2)
    system.initial_conditions = {"q1": 0.4, "u2": -0.3}
    system.times, system.ode_solver = np.linspace(0.0, 2.0, 5), "vern9"
    found = system.simulate(sensitivities=["m1", "u2"], **TIGHT).sensitivity.values
    n, places = len(system.states), [str(s) for s in system.states].index("u2(t)")
    place = [str(s) for s in sorted(system.constants_symbols, key=str)].index("m1")

    def variational(y, t):
        x, columns = y[:n], y[n:].reshape(n, 2)
        slope = system.evaluate_jacobian(x, t) @ columns
        slope[:, 0] += system.evaluate_jacobian(x, t, wrt="constants")[:, place]
        return np.concatenate([system.evaluate_ode(x, t), slope.ravel()])

    start = np.zeros((n, 2))
    start[places, 1] = 1.0
    x0 = system.evaluate_ode() * 0.0
    x0[[str(s) for s in system.states].index("q1(t)")] = 0.4
    x0[places] = -0.3
    whole = odeint(variational, np.concatenate([x0, start.ravel()]), system.times, **TIGHT)
    assert relative(found, whole[:, n:].reshape(-1, n, 2)) < 1e-9


def test_the_implicit_method_factorises_no_more_for_sensitivities():
    system = n_link_pendulum_on_cart(3)
    system.initial_conditions = {"q1": 0.4, "u2": -0.3}
    system.times, names = np.linspace(0.0, 2.0, 5), ["m1", "g", "q2", "u3"]
    system.ode_solver = "vern9"
    expected = system.simulate(sensitivities=names, **TIGHT).sensitivity.values
    system.ode_solver = "radau"
    plain = system.simulate(rtol=1e-9, atol=1e-9).statistics
    beside = system.simulate(sensitivities=names, rtol=1e-9, atol=1e-9)
    assert beside.statistics["factorisations"] <= 1.1 * plain["factorisations"]
    assert beside.statistics["steps"] <= 1.1 * plain["steps"]
    assert beside.statistics["evaluations"] < 2.5 * plain["evaluations"]
    assert relative(beside.sensitivity.values, expected) < 1e-8


def driven_mass(**specifieds):
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    system.constants = {"m0": 1.3, "k0": 2.0, "c0": 0.2}
    system.specifieds = {"f0": specifieds["f0"]}
    system.times, system.ode_solver = np.linspace(0.0, 4.0, 9), "dop853"
    return system


def difference(change, size=1e-4):
    """Return the central difference of the results of a function of a small number."""
    ahead, behind = change(size), change(-size)
    return (ahead - behind) / (2.0 * size)


def test_the_parameters_of_an_expression_for_an_input_are_parameters():
    amplitude, t = sm.symbols("A"), me.dynamicsymbols._t

    def states(change):
        system = driven_mass(f0=amplitude * sm.sin(3 * t))
        system.constants = {**system.constants, amplitude: 0.8 + change}
        return system.simulate(sensitivities=[amplitude], **TIGHT)

    found = states(0.0).sensitivity.values[:, :, 0]
    assert relative(found, difference(lambda h: states(h).states)) < 1e-9  # linear in A


def test_an_input_that_is_a_number_is_a_parameter():
    found = driven_mass(f0=0.8).simulate(sensitivities=["f0"], **TIGHT).sensitivity.values[:, :, 0]
    expected = difference(lambda h: driven_mass(f0=0.8 + h).simulate(**TIGHT).states)
    assert relative(found, expected) < 1e-9


@pytest.mark.parametrize("interpolation", ["linear", "previous"])
def test_each_sample_of_an_input_is_a_parameter(interpolation):
    times, values = np.array([0.0, 0.7, 2.0, 4.0]), np.array([0.5, -1.0, 2.0, 0.3])

    def states(*, by=None, **options):
        changed = values if by is None else values + by
        system = driven_mass(f0=SampledInput(times, changed, interpolation))
        return system.simulate(max_step=0.05, rtol=1e-9, atol=1e-9, **options)

    found = states(sensitivities=["f0", "m0", "v0"]).sensitivity
    assert found.names == ("f0[0]", "f0[1]", "f0[2]", "f0[3]", "m0", "v0")
    initial = np.zeros((2, 6))
    initial[1, 5] = 1.0  # of v0, whose column follows those of all samples
    np.testing.assert_array_equal(found.values[0], initial)
    assert found["x0", "f0"].shape == (9, 4)
    for k in range(4):
        # The equations are linear in the samples: any difference is exact.
        expected = (states(by=np.eye(4)[k]).states - states(by=-np.eye(4)[k]).states) / 2.0
        assert np.abs(found.values[:, :, k] - expected).max() < 1e-6


def test_odeint_that_gives_up_says_so_with_sensitivities():
    with pytest.raises(IntegrationError, match=r"in the state x0\(t\) = 1, v0\(t\) = 0.3"):
        oscillator().simulate(sensitivities=["k0", "x0"], rtol=1e-13, atol=1e-13, mxstep=1)


def test_outputs_have_sensitivities_too():
    system = oscillator()
    power, x0, k0 = sm.Symbol("P"), system.coordinates[0], sm.Symbol("k0")
    system.outputs = {power: k0 * x0 * system.speeds[0]}
    system.ode_solver = "dop853"
    trajectory = system.simulate(sensitivities=["k0", "x0"], **TIGHT)
    values, x, v = trajectory.sensitivity, trajectory["x0"], trajectory["v0"]
    expected = x * v + 2.0 * (values[x0, k0] * v + x * values["v0", "k0"])
    assert relative(values[power, k0], expected) < 1e-12


def test_outputs_that_are_nan_have_no_finite_sensitivities():
    system = multi_mass_spring_damper()
    x, m0 = system.coordinates[0], sm.Symbol("m0")
    system.outputs = {
        "never": sm.Piecewise((m0 * x, x > 10)),
        "often": sm.Piecewise((m0 * x, x > 0.5)),
        "root": m0 * sm.sqrt(x - 10),
        "always": m0 * x,
    }
    system.times, system.initial_conditions = np.linspace(0.0, 3.0, 7), {x: 1.0}
    with pytest.warns(PyDyUserWarning, match="not finite"):
        trajectory = system.simulate(sensitivities=["m0", "k0"])
    for name in ("never", "often", "root", "always"):
        nan = np.isnan(trajectory[name])
        assert nan.sum() == {"never": 7, "often": 4, "root": 7, "always": 0}[name]
        for parameter in ("m0", "k0"):
            found = np.isnan(trajectory.sensitivity[name, parameter])
            np.testing.assert_array_equal(found, nan, f"{name} by {parameter}")
    late = trajectory.at([0.25, 2.25])
    np.testing.assert_array_equal(np.isnan(late.sensitivity["often", "m0"]), [False, True])


def test_sensitivities_have_names():
    system = oscillator()
    trajectory = system.simulate(sensitivities=["m0", system.coordinates[0]])
    found = trajectory.sensitivity
    assert repr(found) == "Sensitivity of 2 states to m0, x0 at 11 times"
    assert found["x0"].shape == (11, 2)
    assert np.array_equal(found["x0", sm.Symbol("m0")], found.values[:, 0, 0])
    with pytest.raises(
        KeyError, match="`k0` is not one of the parameters of the sensitivities: m0, x0"
    ):
        found["x0", "k0"]
    with pytest.raises(KeyError, match="`y` is not one of the states and outputs"):
        found["y", "m0"]


def test_at_other_times_sensitivities_are_interpolated():
    system = oscillator(501)
    system.ode_solver = "dop853"
    trajectory = system.simulate(sensitivities=list(NUMBERS), **TIGHT)
    between = [0.015, 2.222, 4.99]
    found = trajectory.at(between).sensitivity
    assert relative(found.values, exact_oscillator(between)) < 1e-8


def test_xarray_has_sensitivities_by_name(tmp_path):
    pytest.importorskip("xarray")
    system = oscillator()
    trajectory = system.simulate(sensitivities=["m0", "x0"])
    dataset = trajectory.to_xarray()
    labelled = dataset["sensitivity"].sel(quantity="v0", parameter="m0")
    assert np.array_equal(labelled, trajectory.sensitivity["v0", "m0"])
    trajectory.save(tmp_path / "run.nc")
    loaded = type(trajectory).load(tmp_path / "run.nc")
    assert np.array_equal(loaded.sensitivity["v0", "m0"], trajectory.sensitivity["v0", "m0"])


def test_a_trajectory_without_sensitivities_says_how_to_get_them():
    with pytest.raises(ValueError, match=r"no sensitivities\. Name the parameters"):
        oscillator().simulate().sensitivity


@pytest.mark.parametrize(
    ("force", "wanted", "message"),
    [
        (
            lambda x, t: 1.0,
            "m0",
            r"f0\(t\) is a Python function, which has none\. Give it as a SymPy",
        ),
        (sm.sin(me.dynamicsymbols._t), "f0", "`f0.t.`, which is given as the expression"),
        (SampledInput([0, 2, 4], [0, 1, 0], "pchip"), "f0", "interpolated by 'pchip'"),
    ],
)
def test_inputs_without_derivatives_are_refused(force, wanted, message):
    with pytest.raises(ValueError, match=message):
        driven_mass(f0=force).simulate(sensitivities=[wanted])


def test_groups_stand_for_their_symbols():
    system = oscillator()
    found = system.simulate(sensitivities=["constants", "v0"], **TIGHT).sensitivity
    assert found.names == ("c0", "k0", "m0", "v0")
    assert system.simulate(sensitivities="states", **TIGHT).sensitivity.names == ("x0", "v0")
    with pytest.raises(ValueError, match="`sensitivities` must name at least one"):
        system.simulate(sensitivities="specifieds")
    sampled = driven_mass(f0=0.8).simulate(sensitivities=["states", "specifieds"]).sensitivity
    assert sampled.names == ("x0", "v0", "f0")


def test_integrate_says_where_sensitivities_are_found():
    system = oscillator()
    system.ode_solver = "dop853"
    with pytest.raises(TypeError, match=r"`sensitivities` cannot .* Call system\.simulate"):
        system.integrate(sensitivities=["m0"])


# -- events ---------------------------------------------------------------------------------------


BALL = {"g": 9.81, "e": 0.8, "d": 0.1, "q": 1.0, "u": 0.5}


def exact_ball(g, e, d, q, u, t):
    """Return height and velocity at t, and the times of the bounces before."""
    times = [mpmath.mpf(0)]
    while True:
        fall = (u + mpmath.sqrt(u * u + 2 * g * (q - d))) / g
        if times[-1] + fall > t:
            left = t - times[-1]
            return [q + u * left - g * left**2 / 2, u - g * left], times[1:]
        times.append(times[-1] + fall)
        q, u = d, -e * (u - g * fall)


def exact_derivatives(function):
    with mpmath.workdps(40):
        numbers = [mpmath.mpf(str(value)) for value in BALL.values()]
        orders = np.eye(len(numbers), dtype=int).tolist()
        return np.array([float(mpmath.diff(function, numbers, tuple(o))) for o in orders])


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_a_bouncing_ball_has_exact_sensitivities(solver):
    system, bounce = bouncing_ball()
    system.ode_solver = solver
    trajectory = system.simulate(sensitivities=list(BALL), events=[bounce], **TIGHT)
    found = trajectory.sensitivity.values
    expected = np.array(
        [
            [exact_derivatives(lambda *v, t=t, i=i: exact_ball(*v, t)[0][i]) for i in range(2)]
            for t in system.times.tolist()
        ]
    )
    assert relative(found, expected) < 1e-9
    assert len(trajectory.events) == 3
    for k, event in enumerate(trajectory.events):
        exact = exact_derivatives(lambda *v, k=k: exact_ball(*v, 2.0)[1][k])
        assert relative(event.time_sensitivity, exact) < 1e-9


def test_sensitivities_are_interpolated_on_each_side_of_an_event():
    system, bounce = bouncing_ball()
    trajectory = system.simulate(sensitivities=["e", "g"], events=[bounce], **TIGHT)
    moment = trajectory.events[0].time
    between = trajectory.at([moment - 1e-3, moment + 1e-3])
    for row, t in zip(between.sensitivity.values, between.times.tolist(), strict=True):
        exact = exact_derivatives(lambda *v, t=t: exact_ball(*v, t)[0][1])
        assert np.abs(row[1] - exact[[1, 0]]).max() < 1e-9


def test_an_event_without_reset_has_the_sensitivity_of_its_time():
    system, _ = bouncing_ball()
    q, u = system.states
    system.times = np.linspace(0.0, 0.4, 3)
    top, high = Event(u, name="top"), Event(q - 1.01, terminal=True, direction=-1, name="high")
    events = system.simulate(sensitivities=["u", "g"], events=[top, high], **TIGHT).events
    assert [event.name for event in events] == ["top", "high"]
    assert relative(events[0].time_sensitivity, np.array([1.0 / 9.81, -0.5 / 9.81**2])) < 1e-9
    # At the second, q = u0 t − g t² / 2 has a fixed value.
    t = events[1].time
    exact = -np.array([t, -(t**2) / 2.0]) / (0.5 - 9.81 * t)
    assert relative(events[1].time_sensitivity, exact) < 1e-9
    assert np.array_equal(events[1].sensitivity_before, events[1].sensitivity_after)


def test_events_that_depend_on_time_and_on_inputs_have_sensitivities():
    q, u = me.dynamicsymbols("q, u")
    level, start, t = me.dynamicsymbols("h"), sm.Symbol("start"), me.dynamicsymbols._t
    system, bounce = bouncing_ball(reset={u: -0.5 * u + start * t * level})
    system.outputs = {sm.Symbol("used"): start * level}
    bounce = Event(q - level, direction=-1, reset=bounce.reset)

    def simulate(lift=0.0, **numbers):
        system.specifieds = {level: SampledInput([0.0, 1.0, 2.0], [0.1, 0.3 + lift, 0.2])}
        system.constants = {}
        system.constants = {"start": 0.4, "g": 9.81, **numbers}
        return system.simulate(sensitivities=["start", level, "g"], events=[bounce], **TIGHT)

    found = simulate().sensitivity
    by_start = difference(lambda h: simulate(start=0.4 + h).states, 1e-5)
    by_sample = difference(lambda h: simulate(lift=h).states, 1e-5)
    by_gravity = difference(lambda h: simulate(g=9.81 + h).states, 1e-5)
    assert relative(found.values[:, :, 0], by_start) < 1e-7
    assert relative(found.values[:, :, 2], by_sample) < 1e-7
    assert relative(found.values[:, :, 4], by_gravity) < 1e-7


def test_events_that_differ_in_their_reset_alone_have_derivatives_of_their_own():
    """A ball from h = 1 m bounces once: q = e v τ − g τ²/2, v = √(2 g h), τ = t − √(2 h/g)."""
    q, u = me.dynamicsymbols("q, u")
    system, _ = bouncing_ball(reset={u: -0.5 * u})
    system.times, system.initial_conditions, g = [0.0, 0.6], {"q": 1.0, "u": 0.0}, 9.81
    fall = np.sqrt(2.0 / g)
    v, tau, slope = g * fall, 0.6 - fall, fall / (2.0 * g)  # ∂τ/∂g, and ∂v/∂g = fall / 2
    for e in (0.5, 0.8):
        bounce = Event(q, direction=-1, reset={u: -e * u})
        found = system.simulate(sensitivities=["g"], events=[bounce], **TIGHT)
        assert found["q"][-1] == pytest.approx(e * v * tau - g * tau**2 / 2, abs=1e-11)
        expected = e * (fall / 2 * tau + v * slope) - tau**2 / 2 - g * tau * slope
        assert found.sensitivity["q", "g"][-1] == pytest.approx(expected, abs=1e-11)


def test_states_with_tolerances_of_their_own_are_compared_with_sizes_that_these_resolve():
    """The error rtol · size + atol is as large by both terms at the size atol / rtol."""
    sizes = least_sizes({"rtol": 1e-6, "atol": [1e-9, 1e-3]}, 2)
    np.testing.assert_allclose(sizes, [1e-3, 1e3], rtol=1e-14)
    sizes = least_sizes({"rtol": [1e-6, 1e-2], "atol": [1e-9, 1e-3]}, 2)
    np.testing.assert_allclose(sizes, [1e-3, 1e-1], rtol=1e-14)
    for atol in (1e-9, [0.0, 1e-3]):
        np.testing.assert_array_equal(least_sizes({"rtol": 1e-6, "atol": atol}, 2), [1.0, 1.0])


def test_an_event_that_a_jump_of_an_input_makes_happen_has_a_time_of_its_own():
    q, u = me.dynamicsymbols("q, u")
    level, e = me.dynamicsymbols("h"), sm.Symbol("e")
    system, _ = bouncing_ball(reset={u: -0.5 * u + level})
    system.outputs = {sm.Symbol("used"): e * level}
    # The floor leaps up to the ball at t = 0.3, and knocks it upwards.
    knock = Event(q - level, direction=-1, reset={u: e * level}, name="knock")
    floor = SampledInput([0.0, 0.3, 2.0], [0.0, 2.0, 2.0], "previous")
    system.times = np.linspace(0.0, 0.6, 4)

    def simulate(**numbers):
        system.specifieds = {level: floor}
        system.constants = {}
        system.constants = {"g": 9.81, "e": 1.5, **numbers}
        return system.simulate(sensitivities=["g", "e"], events=[knock], **TIGHT)

    trajectory = simulate()
    (event,) = trajectory.events
    assert event.time == 0.3
    assert np.array_equal(event.time_sensitivity, [0.0, 0.0])
    # Up at 3 m/s from q(0.3) = 1 + 0.15 − g 0.045, at t = 0.6: by g, −0.045 − 0.045.
    found = trajectory.sensitivity.values[-1]
    np.testing.assert_allclose(found, [[-0.09, 0.6], [-0.3, 2.0]], atol=1e-11)


def test_an_event_that_grazes_is_named():
    system, _ = bouncing_ball()
    system.initial_conditions = {"q": 0.1, "u": 1.0}
    q = system.coordinates[0]
    apex = 0.1 + 1.0 / (2.0 * 9.81)
    touch = Event(q - apex + 1e-6, terminal=True, name="touch")
    system.times, loose = [0.0, 0.15], {"rtol": 1e-4, "atol": 1e-4, "max_step": 1e-3}
    with pytest.raises(IntegrationError, match=r"`touch`, which the motion only grazes: by 1e-06"):
        system.simulate(sensitivities=["g"], events=[touch], **loose)
    assert system.simulate(events=[touch], **loose).events


@pytest.mark.parametrize(
    ("size", "name", "tolerances"),
    [(1e-9, "atol", {"atol": 1e-6, "rtol": 1e-6}), (1e7, "rtol", {"atol": 1e-6, "rtol": 0.2})],
)
def test_an_event_that_seems_to_graze_names_the_tolerance_to_lower(size, name, tolerances):
    """A ball that rises by a size, and 0.9 of that height."""
    system, _ = bouncing_ball()
    system.constants["g"] = 2.0 * size
    system.initial_conditions = {"q": 0.0, "u": 2.0 * size}
    system.times = [0.0, 1.0]
    touch = Event(system.coordinates[0] - 0.9 * size, terminal=True, name="touch")
    with pytest.raises(IntegrationError, match="only grazes") as refused:
        system.simulate(sensitivities=["g"], events=[touch], **tolerances)
    change = re.search(r"lower `(.*)` from (.*) to less than (.*)\. Otherwise", str(refused.value))
    assert change[1] == name
    assert float(change[2]) == tolerances[name]
    tolerances[name] = 0.99 * float(change[3])
    (moved,) = system.simulate(sensitivities=["g"], events=[touch], **tolerances).events
    assert moved.time == pytest.approx(1.0 - np.sqrt(0.1), abs=1e-3)  # t − t² / 2 = 0.45


@pytest.mark.parametrize("tolerance", [1e-7, 1e-12])
def test_bounces_that_accumulate_name_other_remedies_than_a_tolerance(tolerance):
    system, bounce = bouncing_ball(e=0.5)
    options = {"events": [bounce], "rtol": tolerance, "atol": tolerance}
    with pytest.raises(IntegrationError, match="follow each other at ever shorter") as refused:
        system.simulate(sensitivities=["e"], **options)
    assert "lower `" not in str(refused.value)
    # The flight between the first bounces takes 2 e u / g, where u² = 0.5² + 2 g 0.9.
    landing = np.sqrt(0.25 + 1.8 * 9.81)
    zeno = (0.5 + landing) / 9.81 + 2.0 * landing / 9.81
    assert refused.value.time < zeno
    # Each flight is half as long as the last one, and as long as all that follow.
    halvings = np.log2(2.0 * landing / 9.81 / (zeno - refused.value.time))
    assert halvings == pytest.approx(round(halvings), abs=0.05)
    assert f"It is the number {round(halvings) + 1} of these events" in str(refused.value)
    system.times = [0.0, refused.value.time - 1e-9]  # the first remedy
    system.simulate(sensitivities=["e"], **options)


def test_events_with_sensitivities_are_saved(tmp_path):
    pytest.importorskip("xarray")
    system, bounce = bouncing_ball()
    trajectory = system.simulate(sensitivities=["e", "g"], events=[bounce])
    trajectory.save(tmp_path / "ball.nc")
    loaded = type(trajectory).load(tmp_path / "ball.nc").events[0]
    assert np.array_equal(loaded.time_sensitivity, trajectory.events[0].time_sensitivity)
    assert loaded.sensitivity_after.shape == (2, 2)


# -- constraints ----------------------------------------------------------------------------------


FOURBAR = ["la", "ln", "m1", "q1", "u1"]
HELD = [{}, {"constraints": "project"}, {"constraints": "baumgarte", "gain": 5.0}]


def linkage(solver="vern9", dep_vars=None, **changes):
    """A four-bar linkage with changed numbers, assembled anew."""
    model = zoo.fourbar()
    system = system_of(model, times=np.linspace(0.0, 2.0, 5), ode_solver=solver)
    constants, start = (
        {key.name: value + changes.get(key.name, 0.0) for key, value in numbers.items()}
        for numbers in (model.constants, model.start)
    )
    system.constants, system.initial_conditions = constants, start
    system.set_dependent_initial_conditions(dep_vars, use_jac=True, tol=1e-15)
    return system


def derivative(function, size):
    """Return the central difference of sixth order at zero."""
    values = [function(k * size) - function(-k * size) for k in (1, 2, 3)]
    return (45.0 * values[0] - 9.0 * values[1] + values[2]) / (60.0 * size)


@pytest.mark.parametrize("held", HELD, ids=["free", "project", "baumgarte"])
def test_dependent_initial_conditions_and_constraints_are_differentiated(held):
    found = linkage().simulate(sensitivities=FOURBAR, **held, **TIGHT).sensitivity
    for name in FOURBAR:
        expected = derivative(
            lambda h, name=name: linkage(**{name: h}).simulate(**held, **TIGHT).states, 2e-3
        )
        assert relative(np.array([found[s, name] for s in found.quantities[:6]]).T, expected) < 1e-9


@pytest.mark.parametrize("held", HELD[1:], ids=["project", "baumgarte"])
def test_events_that_turn_a_closed_loop_round_are_differentiated(held):
    """All speeds are scaled by one number, so that they still satisfy the constraints."""
    names, size = ["la", "m1", "q1", "u1"], 1e-3

    def swing(solver, h=0.0, name="la", **options):
        system = linkage(solver, **{name: h})
        turned = {u: -0.8 * u for u in system.speeds}
        stop = Event(system.coordinates[0] + 1.06, reset=turned)
        return system.simulate(events=stop, **held, **TIGHT, **options)

    expected = []
    for name in names:
        runs = {k: swing("vern9", k * size, name) for k in range(-3, 4)}
        states = derivative(lambda h, runs=runs: runs[round(h / size)].states, size)
        times = derivative(lambda h, runs=runs: runs[round(h / size)].events[0].time, size)
        expected.append((states, times))
    for solver in ("vern9", "radau"):
        found = swing(solver, sensitivities=names)
        assert len(found.events) == 2
        for k, (states, _) in enumerate(expected):
            assert relative(found.sensitivity.values[:, :, k], states) < 1e-9
        moments = [time for _, time in expected]
        assert relative(found.events[0].time_sensitivity, np.array(moments)) < 1e-9


def off_the_constraints(system, trajectory, names):
    """The largest residual of the linear constraints that sensitivities satisfy."""
    largest = 0.0
    for of in ("holonomic", "velocity"):
        by_state = system.evaluate_jacobian(trajectory.states, trajectory.times, of=of)
        columns = [k for k, s in enumerate(system.constants_symbols) if s.name in names]
        by_constant = system.evaluate_jacobian(
            trajectory.states, trajectory.times, of=of, wrt="constants"
        )[:, :, columns]
        residual = by_state @ trajectory.sensitivity.values + by_constant
        largest = max(largest, np.abs(residual).max(initial=0.0))
    return largest


@pytest.mark.parametrize("solver", ["dop853", "tsit5", "radau"])
def test_projection_holds_the_constraints_of_sensitivities(solver):
    system = linkage(solver)
    loose, names = {"rtol": 1e-5, "atol": 1e-5}, ["la", "lb", "m1"]
    free = system.simulate(sensitivities=names, **loose)
    held = system.simulate(sensitivities=names, constraints="project", **loose)
    assert off_the_constraints(system, free, names) > 1e-8
    assert off_the_constraints(system, held, names) < 1e-12


def test_the_norm_of_a_quaternion_is_held_in_sensitivities():
    system = system_of(zoo.gyro(), times=np.linspace(0.0, 2.0, 5), ode_solver="dop853")
    names = [str(next(iter(system.constants_symbols)))]
    held = system.simulate(sensitivities=names, constraints="project", rtol=1e-5, atol=1e-5)
    assert off_the_constraints(system, held, names) < 1e-12
    # No speed changes the norm: its row is rounding, which an adjoint must not take for one.
    system.initial_conditions = {"e0": 1.0, "w1": 1.0, "w2": 2.0, "w3": 0.3}
    options = {"constraints": "project", "rtol": 1e-9, "atol": 1e-9}
    forward = system.simulate(sensitivities=["w1"], **options).sensitivity["e1", "w1"][-1]
    backward = system.adjoint_gradient(["w1"], final="e1", **options)["w1"]
    assert backward == pytest.approx(forward, rel=1e-6)


@pytest.mark.parametrize("speed", [1e-9, 1.0, 1e9])
def test_dependent_conditions_follow_in_any_unit_of_time(speed):
    """y = √(1 - x²), v = -x u/y; the least singular value is 1e-18 of the largest at 1e9 m/s."""
    found = on_a_circle(0.7, speed).simulate(sensitivities=["x", "u"]).sensitivity
    x, y = np.cos(0.7), np.sin(0.7)
    ratios = (
        found["y", "x"][0] * y / x,
        found["v", "x"][0] * y**2 / speed,
        found["v", "u"][0] * y / x,
    )
    assert ratios == pytest.approx((-1.0, 1.0, -1.0), rel=1e-12)


def test_the_states_as_a_group_leave_out_dependent_ones():
    assert linkage().simulate(sensitivities="states").sensitivity.names == ("q1", "u1")


def test_a_dependent_initial_condition_is_no_parameter():
    with pytest.raises(ValueError, match=r"initial condition of `q2.t.`, which follows from"):
        linkage().simulate(sensitivities=["q2"])
    chosen = linkage(dep_vars=["q1", "q3", "u1", "u3"])
    assert chosen.simulate(sensitivities=["q2"]).sensitivity["q1", "q2"][0] != 0.0


@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_ctrl_c_hands_over_the_states_alone(solver, monkeypatch):
    system = oscillator()
    system.times, system.ode_solver = np.linspace(0.0, 1e4, 100_001), solver
    expected = system.simulate().states

    def interrupted(self, budget):
        raise KeyboardInterrupt

    monkeypatch.setattr(Integration, "_slice", interrupted)  # after a first slice of some steps
    with pytest.raises(IntegrationInterrupted) as caught:
        system.simulate(sensitivities=["k0", "x0"])
    stop = caught.value
    assert 0 < len(stop.times) < len(system.times)
    assert stop.state.shape == (2,)
    np.testing.assert_allclose(stop.states, expected[: len(stop.times)], atol=1e-6)


X, K, L, T = me.dynamicsymbols("x"), *sm.symbols("K L"), me.dynamicsymbols._t
SLIDING = me.dynamicsymbols("x", 1)


def pushed(force):
    """A unit mass that is thrown against a force, which turns it back at 1.5 s or so."""
    frame, origin = inertial_frame()
    place = origin.locatenew("P", X * frame.x)
    bodies, loads = [me.Particle("b", place, 1)], [(place, force * frame.x)]
    system = System(Definition(frame, [X], bodies=bodies, loads=loads), ode_solver="dop853")
    system.constants = {s: 1.0 if s == K else 0.3 for s in system.constants_symbols}
    system.initial_conditions = {X: 1.0, system.speeds[0]: 0.5}
    system.times = np.linspace(0.0, 3.5, 36)
    return system


@pytest.mark.parametrize(
    "force",
    [
        -K * sm.sign(X),
        -1 - K * sm.Heaviside(X - L),
        sm.Piecewise((-K, T < 5 * L), (K, True)),
        -K * (2 + sm.floor(X)),
        -K * (1 + sm.ceiling(X)),
        -K * (sm.ceiling(X) + 1) * sm.ceiling(X) / 2,  # 1 above zero, nothing below
        -K * (2 - sm.Mod(X, 1)),
    ],
)
def test_a_motion_that_passes_a_jump_of_a_load_warns_of_its_derivatives(force):
    system = pushed(force)
    wanted = system.constants_symbols
    with pytest.warns(
        PyDyUserWarning, match=r"At t = [012]\S* the load on .* jumps by [12],"
    ) as told:
        system.simulate(sensitivities=wanted)
    assert len(told) == 1
    if force.has(X):
        with pytest.warns(PyDyUserWarning, match="jumps by"):
            system.adjoint_gradient(wanted, final=X)
    with pytest.warns(PyDyUserWarning, match=r"t = [012]\S* the load on .* jumps by [12],") as told:
        system.integrate_ensemble(constants={K: np.full(9, 1.0)}, sensitivities=wanted)
    assert len(told) == 1


def test_jumps_of_angles_and_masses_are_told():
    system = pushed(-K * sm.atan2(X, -2) / sm.pi)
    with pytest.warns(PyDyUserWarning, match="jumps by 2,"):
        system.simulate(sensitivities=[K])
    frame = me.ReferenceFrame("N")
    speed = X.diff(T)
    place = me.Point("P")
    place.set_vel(frame, speed * frame.x)
    body = me.Particle("b", place, K * (2 + sm.sign(X)))
    definition = Definition(frame, [X], bodies=[body], loads=[(place, -3 * frame.x)])
    system = System(definition, {K: 1.0}, ode_solver="dop853", times=system.times)
    system.initial_conditions = {X: 1.0}
    with pytest.warns(PyDyUserWarning, match="jumps by 2,"):
        system.simulate(sensitivities=[K])


@pytest.mark.parametrize(
    "force",
    [
        -K * X * sm.Abs(X),
        -K * sm.atan2(X, 2),
        -K * sm.Abs(sm.atan2(X, -2)),
        -K * sm.sin(sm.atan2(X, -2)) - X,
        -K * sm.Max(0, X),
        sm.Piecewise((-3 * K * X, X < 0), (-K * X, True)),
        -X - K * SLIDING * sm.Abs(SLIDING),
        -X + sm.Piecewise((-K, T < 1), (0, True)),
        -K * sm.sign(X + 99),
        -K * (1 + sm.frac(X) * (1 - sm.frac(X))),
        -K * sm.floor(X / 99 + 1.5),
    ],
)
def test_a_motion_without_a_jump_does_not(force):
    system = pushed(force)
    system.simulate(sensitivities=[K])  # a warning would be an error
    system.adjoint_gradient([K], final=X)
    system.integrate_ensemble(constants={K: [1.0, 1.1]}, sensitivities=[K])


def test_jumps_of_all_that_is_integrated_are_told():
    lag, press, start = me.dynamicsymbols("z F t_0")
    for force, equations, inputs, what in [
        (-X - lag, [lag.diff(T) - K * sm.sign(X)], {}, "the rate of z"),
        (-X - press * sm.Heaviside(T - start), [], {start: 1.0, press: K}, "the load on"),
    ]:
        system = pushed(force)
        if equations:
            definition = system.eom_method
            kinematic = [X.diff(T) - system.speeds[0], *equations]
            definition = Definition(
                definition.frame, [X, lag], system.speeds, bodies=definition.bodies,
                loads=definition.loads, kinematic_equations=kinematic,
            )  # fmt: skip
            system = System(
                definition, {K: 1.0}, initial_conditions={X: 1.0}, ode_solver="dop853",
                times=system.times,
            )  # fmt: skip
        system.specifieds = inputs
        with pytest.warns(PyDyUserWarning, match=what):
            system.simulate(sensitivities=[start] if inputs else [K])
    with pytest.warns(PyDyUserWarning, match="what is integrated jumps by 1,"):
        pushed(-K * X).adjoint_gradient([K], integral=sm.Heaviside(X))


def test_jumps_between_the_outputs_are_told():
    """There and back between two outputs; the solver's steps tell."""
    system = pushed(-K * X - sm.sign(X) / 9)
    system.times = [0.0, 5.0]
    with pytest.warns(PyDyUserWarning, match="jumps by 0.222,"):
        system.simulate(sensitivities=[K])
    with pytest.warns(PyDyUserWarning, match="jumps by 0.222,"):
        system.adjoint_gradient([K], final=X)
    for options in ({}, {"reduce": "final"}, {"ode_solver": "radau"}):
        with pytest.warns(PyDyUserWarning, match="jumps by 0.222,"):
            system.integrate_ensemble(sensitivities=[K], **options)


def test_a_jump_that_an_event_makes_is_known():
    system = pushed(-K * sm.sign(X))
    speed = system.speeds[0]
    events = [Event(X, reset={speed: 0.5 * speed})]
    system.simulate(sensitivities=[K], events=events)
    system.integrate_ensemble(sensitivities=[K], events=events)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("solver", ["RK45", "DOP853"])
def test_what_grows_beyond_floats_is_named_and_no_load_is_blamed(solver):
    """Where an unstable rest is kept, the derivatives by its start grow alone."""
    x = me.dynamicsymbols("x")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, x.diff() * frame.x)
    push = [(point, 1e4 * x * frame.x)]
    mass = me.Particle("P", point, 1)
    method = me.LagrangesMethod(me.Lagrangian(frame, mass), [x], forcelist=push, frame=frame)
    system = System(method, times=np.linspace(0.0, 7.5, num=11), ode_solver=solver)
    with pytest.raises(IntegrationError, match=r"The sensitivities grow to .*(e\+|inf)") as error:
        system.simulate(sensitivities=[x])
    assert "loads" not in str(error.value)
    assert error.value.state == pytest.approx([0.0, 0.0])


@pytest.mark.parametrize(
    "expression", [sm.Piecewise((X, X > L), (X - 2, True)), X - 1 + sm.Heaviside(X - L)], ids=str
)
def test_the_time_of_an_event_whose_expression_jumps_has_no_derivative(expression):
    system = pushed(-K * X)
    speed = system.speeds[0]
    for acts, events in [(True, [Event(expression, reset={speed: 2 * speed}, name="e")]),
                         (False, [Event(expression, name="e")])]:  # fmt: skip
        system.constants = {}
        system.constants = {K: 1.0}
        system.constants[L] = 0.3
        if acts:
            with pytest.raises(IntegrationError, match="whose expression jumps there, to"):
                system.simulate(events=events, sensitivities=[K])
            with pytest.raises(IntegrationError, match="whose expression jumps there, to"):
                system.adjoint_gradient([K], final=X, events=events)
            continue
        (told, *_) = system.simulate(events=events, sensitivities=[K]).events
        assert np.isnan(told.time_sensitivity).all()


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
@pytest.mark.parametrize(("sign", "function"), [(1.0, np.cosh), (-1.0, np.cos)])
@pytest.mark.parametrize("start", [0.0, 1e-12])
def test_what_grows_or_swings_beside_a_rest_is_resolved(solver, sign, function, start):
    """No error of a state at rest shows: steps grew, and sensitivities were off by half."""
    system = pushed(K * sign * sm.sin(X))
    system.constants, system.ode_solver, system.times = {K: 9.0}, solver, [0.0, 1.0, 4.0]
    system.initial_conditions = {X: start}
    expected = function(3.0 * np.array(system.times))
    found = [
        system.simulate(sensitivities=[X], control_sensitivities=c).sensitivity.values[:, 0, 0]
        for c in (False, True)
    ]
    many = system.integrate_ensemble(constants={K: [9.0, 9.0]}, sensitivities=[X])
    found.append(many.sensitivity.values[1, :, 0, 0])
    if solver != "radau":
        found.append([1.0, expected[1], system.adjoint_gradient([X], final=X)[X]])
    for one in found:
        np.testing.assert_allclose(one, expected, rtol=2e-6, atol=2e-6)
    with pytest.raises(ValueError, match="`rtol` must"):
        system.simulate(sensitivities=[X], rtol="a")
    system.simulate(sensitivities=[X], rtol=0.0)


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
@pytest.mark.parametrize(
    ("ratio", "damping"), [(5.0, 0.0), (10.0, 0.0), (50.0, 0.0), (10.0, 0.2), (10.0, -0.2)]
)
def test_a_direction_that_the_motion_does_not_excite_is_resolved(solver, ratio, damping):
    """No error of the states shows it: at ten times the motion's frequency 0.5 was 1e23."""
    system, rtol = uncoupled(solver, ratio, damping), 1e-8
    y = system.states[1]
    motion = system.simulate(sensitivities=[y], rtol=rtol, atol=rtol)
    rate, decay = np.sqrt(ratio**2 - damping**2 / 4.0), damping / 2.0
    phase, size = rate * system.times, np.exp(-decay * np.array(system.times))
    expected = size * (np.cos(phase) + decay / rate * np.sin(phase))
    # Each step may add a thousand tolerances, as a root mean square of four components.
    bound = 2.0 * 1e3 * rtol * (1.0 + size.max()) * motion.statistics["steps"]
    assert bound < 0.2 * (1.0 + size.max())
    assert np.abs(motion.sensitivity[y, y] - expected).max() < bound


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_such_a_direction_has_the_same_bits_in_an_ensemble(solver):
    """The lanes' parameters have sizes of their own, and so have the tolerances."""
    system, ratios = (
        uncoupled(solver, 1.0),
        np.array([1.0, 5.0, 10.0, 20.0, 2.0, 3.0, 4.0, 6.0, 30.0]),
    )
    y = system.states[1]
    many = system.integrate_ensemble(constants={K: ratios**2}, sensitivities=[y, K])
    for k, ratio in enumerate(ratios.tolist()):
        system.constants = {**system.constants, K: ratio**2}
        one = system.simulate(sensitivities=[y, K])
        found = many.isel(sample=k)
        assert found.steps == one.statistics["steps"]
        values = found.sensitivity.transpose("time", "quantity", "parameter").values
        np.testing.assert_array_equal(values, one.sensitivity.values)
    assert many.steps[-1] > 5 * many.steps[0]


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_an_ordinary_motion_is_integrated_as_without_sensitivities(solver):
    system = multi_mass_spring_damper(4, apply_gravity=True)
    system.initial_conditions = {system.states[0]: 1.0}
    system.times, system.ode_solver = np.linspace(0.0, 10.0, 5), solver
    for tolerance in (1e-5, 1e-8, 1e-11):
        own = {"rtol": tolerance, "atol": tolerance}
        plain, beside = system.simulate(**own), system.simulate(sensitivities="constants", **own)
        assert beside.statistics["steps"] == pytest.approx(plain.statistics["steps"], rel=0.01)
        if solver != "radau":  # which iterates further for the columns
            np.testing.assert_array_equal(beside.states, plain.states)


def test_columns_have_errors_of_radau_that_are_small_in_stiff_motions():
    """They were not solved for with the factors: twenty times as many steps, and an underflow."""
    x, u = me.dynamicsymbols("x u")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    point = origin.locatenew("P", x * frame.x)
    loads = [(point, (K * (1 - x**2) * u - x) * frame.x)]
    bodies = [me.Particle("P", point, 1)]
    system = System(Definition(frame, [x], [u], bodies=bodies, loads=loads), {K: 100.0})
    system.initial_conditions, system.times = {x: 2.0}, [0.0, 162.0]
    system.ode_solver, own = "radau", {"rtol": 1e-9, "atol": 1e-9}
    plain = system.simulate(**own).statistics["steps"]
    bounded = system.simulate(sensitivities=[x, u], **own)
    controlled = system.simulate(sensitivities=[x, u], control_sensitivities=True, **own)
    assert bounded.statistics["steps"] < 1.1 * plain
    assert controlled.statistics["steps"] < 4 * plain
    np.testing.assert_allclose(
        bounded.sensitivity.values, controlled.sensitivity.values, rtol=1e-6, atol=1e-6
    )


def test_tolerances_of_columns_that_only_bound_the_step():
    rtol, atol = np.array([1e-8, 1e-3, 0.2, 0.0]), np.array([1e-8, 0.0, 0.0, 1e-8])
    start, scales = np.array([0.0, 3.0, 0.0, 0.0]), np.array([1.0, 10.0])
    relative, absolute = CompiledSensitivities.bounding_tolerances(rtol, atol, start, scales)
    assert relative[::2].tolist() == pytest.approx([1e-5, 0.1, 0.2, 1e3 * np.finfo(float).eps])
    assert absolute[::2] == pytest.approx([1e-5, 3e-3, np.inf, 1e-5])
    assert absolute[1::2] == pytest.approx([1e-6, 3e-4, np.inf, 1e-6])
    assert [
        a.shape
        for a in CompiledSensitivities.bounding_tolerances(rtol, atol, start[None], scales[None])
    ] == [(8,), (1, 8)]
