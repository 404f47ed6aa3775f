"""Integrations and evaluations that go wrong say so, and why."""

import copy
import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import ODEintWarning, odeint, solve_ivp

import zoo
from pydy._errors import IntegrationError, PyDyUserWarning, SingularMatrixError
from pydy._judges.diagnostics import diagnosis_of
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from registry import step_options

T = me.dynamicsymbols._t
X, Y, VX, VY, PUSH = me.dynamicsymbols("x y vx vy F")
M, G, L = sm.symbols("m g l")


def swinging(times=(0.0, 5e5, 1e6)):
    system = n_link_pendulum_on_cart(2)
    system.initial_conditions = {system.coordinates[1]: 0.5}
    system.times = times
    return system


def on_a_circle(**options):
    """A pendulum in Cartesian coordinates: y cannot be the dependent one where y = 0."""
    frame, bob = me.ReferenceFrame("N"), me.Point("P")
    bob.set_vel(frame, VX * frame.x + VY * frame.y)
    kane = me.KanesMethod(
        frame,
        [X],
        [VX],
        kd_eqs=[X.diff(T) - VX, Y.diff(T) - VY],
        q_dependent=[Y],
        configuration_constraints=[X**2 + Y**2 - L**2],
        u_dependent=[VY],
        velocity_constraints=[X * VX + Y * VY],
    )
    kane.kanes_equations([me.Particle("B", bob, M)], [(bob, (PUSH - M * G) * frame.y)])
    start = {"initial_conditions": {X: 1.0, Y: 0.0}, "times": np.linspace(0.0, 1.0, 5)}
    return System(kane, **{**start, **options})


# -- odeint ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["integrate", "simulate"])
def test_odeint_that_gives_up_is_an_error_with_what_was_computed(method):
    system = swinging()
    with pytest.raises(IntegrationError, match=r"`odeint` gave up \(Excess work .* `mxstep`") as e:
        getattr(system, method)()
    error = e.value
    np.testing.assert_array_equal(error.times, [0.0])
    np.testing.assert_array_equal(error.states, [[0.0, 0.5, 0.0, 0.0, 0.0, 0.0]])
    assert f"at t = {error.time!r} in the state q0(t) = {error.state[0]:.6g}, " in str(error)
    assert (error.info["method"], error.info["reached"]) == ("odeint", 1)
    assert error.info["message"].startswith("Excess work")
    # It came to that time and no further.
    system.times = [0.0, error.time]
    np.testing.assert_allclose(system.integrate(mxstep=5000)[1], error.state, atol=1e-4)


def test_rows_before_odeint_gave_up_are_kept():
    whole = swinging([0.0, 1.0, 2.0]).integrate()
    with pytest.raises(IntegrationError) as caught:
        swinging([0.0, 1.0, 2.0, 1e5, 2e5]).integrate()
    np.testing.assert_array_equal(caught.value.times, [0.0, 1.0, 2.0])
    np.testing.assert_allclose(caught.value.states, whole, atol=1e-6)
    assert caught.value.info["nst"].shape == (3,)


def test_full_output_returns_what_odeint_does():
    with pytest.warns(ODEintWarning, match="Excess work"):
        x, info = swinging().integrate(full_output=True)
    assert x.shape == (3, 6)
    assert info["message"].startswith("Excess work")


def test_a_trajectory_is_never_made_of_garbage():
    with pytest.raises(IntegrationError, match="gave up"):
        swinging().simulate(full_output=True)


def test_odeint_asked_to_speak_speaks():
    with pytest.warns(ODEintWarning, match="Integration successful"):
        swinging([0.0, 1.0]).integrate(printmessg=True)


def test_a_wrapped_odeint_is_the_users_own_affair():
    system = swinging()
    system.ode_solver = lambda *args, **options: odeint(*args, **options)
    with pytest.warns(ODEintWarning, match="Excess work"):
        assert system.integrate().shape == (3, 6)


def test_the_same_rows_come_back_with_and_without_full_output():
    system = swinging(np.linspace(0.0, 2.0, 5))
    np.testing.assert_array_equal(system.integrate(), system.integrate(full_output=True)[0])


def test_a_thread_beside_the_main_one_gets_the_error_too():
    from concurrent.futures import ThreadPoolExecutor

    system = swinging()
    with ThreadPoolExecutor(1) as pool, warnings.catch_warnings():
        warnings.simplefilter("ignore", ODEintWarning)
        error = pool.submit(system.integrate).exception()
    assert isinstance(error, IntegrationError)


# -- what is not finite ---------------------------------------------------------------------------


@pytest.mark.parametrize("solver", ["odeint", "dop853", "radau"])
def test_a_bad_choice_of_dependents_is_named(solver):
    system = on_a_circle(ode_solver=solver, equations="method")
    with pytest.raises(
        IntegrationError, match="derivatives or errors that are not finite"
    ) as caught:
        system.integrate()
    message = str(caught.value)
    assert "cannot be solved there for the dependent speeds vy(t)" in message
    assert "Choose others, such as vx(t), as `u_dependent`" in message
    assert "loads" not in message
    np.testing.assert_array_equal(caught.value.states, [[1.0, 0.0, 0.0, 0.0]])


@pytest.mark.parametrize("solver", ["dop853", "rk4"])
def test_dependents_that_are_a_bad_choice_are_integrated_nevertheless(solver):
    system = on_a_circle(ode_solver=solver, times=np.linspace(0.0, 9.0, 10))
    assert system._equations.formed is not None
    options = step_options(solver, 1e-11, 1e-3)
    x = system.integrate(constraints="project", **options)
    # The angle from the horizontal, of a pendulum of unit length, mass and gravity.
    angle = solve_ivp(
        lambda t, a: [a[1], -np.cos(a[0])], (0, 9), [0.0, 0.0], "DOP853", system.times,
        rtol=1e-12, atol=1e-12,
    ).y  # fmt: skip
    np.testing.assert_allclose(x[:, 0], np.cos(angle[0]), rtol=0, atol=1e-7)
    np.testing.assert_allclose(x[:, 1], np.sin(angle[0]), rtol=0, atol=1e-7)


def test_an_evaluation_that_is_not_finite_warns_with_the_rows_names():
    system = on_a_circle(equations="method")
    with pytest.warns(PyDyUserWarning, match=r"not finite: the .* of vx\(t\), .*vy") as told:
        x = system.evaluate_ode()
    assert not np.isfinite(x[2:]).any()
    assert "dependent speeds vy(t)" in str(told[0].message)
    assert told[0].filename == __file__


def test_outputs_that_are_not_finite_are_named():
    system = on_a_circle(outputs={sm.Symbol("ratio"): X / Y, sm.Symbol("fine"): X})
    with pytest.warns(PyDyUserWarning, match="not finite: ratio at t = 0.5 in the state x.* = 1"):
        system.evaluate_outputs([[0.6, 0.8, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]], [0.0, 0.5])


def test_energies_that_are_not_finite_are_named():
    system = on_a_circle()
    system.potential_energy = 1 / Y
    with pytest.warns(PyDyUserWarning, match="not finite: the potential energy, the total energy"):
        system.evaluate_energy()


def test_what_comes_from_numbers_that_are_not_finite_is_no_surprise():
    system = on_a_circle()
    assert np.isnan(system.evaluate_ode([0.6, 0.8, np.nan, 0.0])).any()


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_specified_that_is_not_finite_is_named(value):
    system = on_a_circle(
        specifieds={PUSH: lambda x, t: value if t > 0.5 else 0.0},
        initial_conditions={X: 0.6, Y: 0.8},
    )
    with pytest.raises(IntegrationError, match="derivatives or errors that are not finite"):
        system.integrate()
    with pytest.raises(IntegrationError, match=rf"The specified `F\(t\)` is {value} there"):
        on_a_circle(specifieds={PUSH: lambda x, t: value}, ode_solver="dop853").integrate()


def test_a_pivot_of_sympys_that_is_zero_is_named():
    # The determinant is 2 q² − 1, but the first pivot is q.
    q, a, b, w, u, v = me.dynamicsymbols("q a b w u v")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, w * frame.x + u * frame.y + v * frame.z)
    options = {
        "kd_eqs": [q.diff(T) - w, a.diff(T) - u, b.diff(T) - v],
        "u_dependent": [u, v],
        "velocity_constraints": [q * u + (1 + q) * v - w, (1 - q) * u + q * v - w],
    }
    bodies, loads = [me.Particle("B", point, M)], [(point, -M * G * frame.z)]
    kane = me.KanesMethod(frame, [q, a, b], [w], **options)
    kane.kanes_equations(bodies, loads)
    with pytest.warns(PyDyUserWarning, match="`constraint_solver='CRAMER'` to KanesMethod"):
        System(kane, equations="method").evaluate_ode()
    # Formed from the bodies, they divide by the determinant.
    assert np.isfinite(System(kane).evaluate_ode()).all()
    kane = me.KanesMethod(frame, [q, a, b], [w], constraint_solver="CRAMER", **options)
    kane.kanes_equations(bodies, loads)
    assert np.isfinite(System(kane).evaluate_ode()).all()


def tumbling():
    angles, rates = me.dynamicsymbols("a b c"), me.dynamicsymbols("wx wy wz")
    frame, body, centre = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    body.orient_body_fixed(frame, angles, "ZXZ")
    written_out = body.ang_vel_in(frame)
    body.set_ang_vel(frame, sum(w * axis for w, axis in zip(rates, body, strict=True)))
    centre.set_vel(frame, 0)
    kd = [(written_out - body.ang_vel_in(frame)).dot(axis) for axis in body]
    kane = me.KanesMethod(frame, angles, rates, kd_eqs=kd)
    inertia = me.inertia(body, *sm.symbols("A B C"))
    kane.kanes_equations([me.RigidBody("R", centre, body, M, (inertia, centre))])
    return kane


def test_gimbal_lock_is_named():
    kane = tumbling()
    system = System(kane, initial_conditions={kane.u[0]: 1.0}, times=[0.0, 1.0])
    named = r"`kd_eqs` are singular there.*gimbal lock: the derivatives of a\(t\), .*c\(t\)"
    with pytest.warns(PyDyUserWarning, match=named):
        system.evaluate_ode()
    system.ode_solver = "dop853"
    with pytest.raises(IntegrationError, match=named):
        system.integrate()


@pytest.mark.parametrize("metre", [1e-9, 1.0, 1e9])
def test_a_length_in_nanometres_is_no_gimbal_lock(metre):
    """x' = r u is 3e8 times as large as a' = w there, which is no division by zero."""
    (x, a), (u, w), r = me.dynamicsymbols("x a"), me.dynamicsymbols("u w"), sm.Symbol("r")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, r * u * frame.x)
    hidden = me.ReferenceFrame("B")
    hidden.orient_axis(frame, frame.z, a)
    hidden.set_ang_vel(frame, w * frame.z)
    centre, inertia = me.Point("C"), sm.Symbol("I")
    centre.set_vel(frame, 0)
    body = me.RigidBody("B", centre, hidden, 1, (me.inertia(hidden, 0, 0, inertia), centre))
    kane = me.KanesMethod(frame, [x, a], [u, w], kd_eqs=[x.diff(T) - r * u, a.diff(T) - w])
    kane.kanes_equations([me.Particle("P", point, 1), body], [])
    system = System(kane, constants={r: 0.3 * metre, inertia: 0.0})
    now = system._now()
    told = diagnosis_of(now.at(np.zeros(1), now.x[None]))
    assert "The cause is the constant `I`, which is zero" in told


def test_bars_in_line_have_the_accelerations_of_least_multipliers():
    """The row along the bars vanishes; masses A and B fall freely, the last bar turns with B."""
    model = zoo.fourbar()
    q1, q2, q3 = model.states[:3]
    system = System(model.kane, constants={**model.constants, sm.Symbol("ln"): 4.8})
    system.initial_conditions = {q1: 0.0, q2: 0.0, q3: 0.0}
    first, third = -9.7 / 0.8, 9.7 / 1.9
    np.testing.assert_allclose(system.evaluate_ode()[3:], [first, -first, third], rtol=1e-14)


def test_loads_are_blamed_where_nothing_else_is_to_blame():
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, VX * frame.x)
    kane = me.KanesMethod(frame, [X], [VX], kd_eqs=[X.diff(T) - VX])
    kane.kanes_equations([me.Particle("B", point, M)], [(point, frame.x / X)])
    with pytest.warns(PyDyUserWarning, match=r"not finite is `1/x\(t\)` = 1/0, at x\(t\) = 0\."):
        System(kane).evaluate_ode()


def test_an_error_of_the_users_own_solver_comes_out_as_it_is():
    def solver(f, x0, t, args=()):
        raise IntegrationError("my own", t[:0], None, 0.0, None, {})

    with pytest.raises(IntegrationError, match=r"^my own$"):
        on_a_circle(ode_solver=solver).integrate()


def test_a_length_of_zero_that_leaves_a_pendulum_without_inertia_is_named():
    system = n_link_pendulum_on_cart(1, cart_force=False, joint_torques=False)
    system.constants = {"l0": 0.0}
    system.times = np.linspace(0.0, 1.0, 3)
    with pytest.raises(SingularMatrixError, match=r"The cause is the constant `l0`, which is zero"):
        system.integrate()


@pytest.mark.parametrize("solver", ["odeint", "dop853", "radau"])
def test_numbers_out_of_the_range_of_step_control_are_told_with_the_remedy(solver):
    system = multi_mass_spring_damper()
    system.constants = {"m0": 1.0, "k0": 1.0, "c0": 0.0}
    position, _ = system.states
    system.initial_conditions, system.times = {position: 1e300}, np.linspace(0.0, 1.0, num=3)
    if solver != "odeint":
        system.ode_solver = solver
    with pytest.raises(IntegrationError, match=r"`v0\(t\)` is -1e\+300 there.* raise `atol`"):
        system.integrate()
    states = system.integrate(rtol=1e-9, atol=1e290)
    np.testing.assert_allclose(states[:, 0] / 1e300, np.cos(system.times), atol=1e-7)


@pytest.mark.parametrize(
    ("solver", "options"),
    [("dop853", {"max_steps": 5}), ("radau", {"max_steps": 8}), ("odeint", {"mxstep": 100})],
)
def test_the_motion_so_far_has_names_and_energies(solver, options):
    system = multi_mass_spring_damper()
    system.constants = {"c0": 0.0}
    position, _ = system.states
    system.initial_conditions, system.times = {position: 1.0}, np.linspace(0.0, 20.0, num=81)
    system.ode_solver = solver
    if solver == "odeint":  # which takes steps between two times: these have to be far apart
        system.times = np.array([0.0, 0.5, 1.0, 2e3])
    calls = [lambda: system.simulate(**options), lambda: system.integrate(**options)]
    if solver == "dop853":
        calls.append(lambda: system.simulate(sensitivities=["k0"], **options))
        calls.append(lambda: system.adjoint_gradient("constants", final=position, **options))
    for call in calls:
        with pytest.raises(IntegrationError) as caught:
            call()
        trajectory = caught.value.trajectory
        assert 1 < len(trajectory.times) < len(system.times)
        np.testing.assert_allclose(trajectory[position], np.cos(trajectory.times), atol=1e-6)
        np.testing.assert_allclose(trajectory.energy[:, 2], 0.5, atol=1e-6)
        with pytest.raises(ValueError, match="failed where this motion ends"):
            trajectory.continue_to(3e3)
        assert copy.deepcopy(caught.value).trajectory is None
