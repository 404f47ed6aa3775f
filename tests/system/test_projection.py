"""constraints='project': what is held, how well, and what cannot be."""

import warnings
from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import odeint

import zoo
from gallery import definitions
from pydy._errors import IntegrationError, PyDyUserWarning
from pydy.examples import whipple_bicycle
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.system import System
from registry import ADAPTIVE_NAMES, SOLVER_NAMES, has_fixed_step, step_options
from zoo import inertial_frame
from zoo.cases import close, system_of, wide

andrews = definitions("andrews", before="mechanism = derive()")
ALL = SOLVER_NAMES
ADAPTIVE = ADAPTIVE_NAMES
CONSTRAINED = ["disc", "disc_contact", "sleigh", "fourbar", "track", "track_reversed", "gyro"]


def at_times(model, end, num=31, solver="dop853", **options):
    return system_of(model, times=np.linspace(0.0, end, num=num), ode_solver=solver, **options)


def options_of(solver, rtol=1e-9, step=2e-3):
    return step_options(solver, rtol, step)


def residuals(system, x):
    """The largest residual of positions and of velocities."""
    parts = []
    for count, evaluate in (
        (system.num_holonomic_constraints, system.evaluate_holonomic_constraints),
        (system.num_velocity_constraints, system.evaluate_velocity_constraints),
    ):
        parts.append(np.abs(evaluate(x, system.times)).max() if count else 0.0)
    return parts


def energy(model, x):
    f = sm.lambdify(model.states, model.energy.xreplace(model.constants))
    return f(*x[:, : len(model.states)].T)


# -- what is held ---------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", ALL)
def test_the_four_bar_stays_closed_for_thirty_seconds(solver):
    model = zoo.fourbar()
    system = at_times(model, 30.0, 301, solver)
    x, info = system.integrate(constraints="project", full_output=True, **options_of(solver))
    position, velocity = residuals(system, x)
    # Lengths are about 2 m, speeds up to 10 m/s.
    assert position < 1e-12
    assert velocity < 1e-10
    within = (
        0 if has_fixed_step(solver) else 299
    )  # outputs; one at a step's end is projected with it
    assert info["projections"] >= info["steps"] + within
    drift = np.abs(energy(model, x) - energy(model, x[:1])).max()
    assert drift < (1e-5 if has_fixed_step(solver) else 1e-6)


def test_without_projection_the_four_bar_comes_apart():
    system = at_times(zoo.fourbar(), 30.0, 301)
    position, velocity = residuals(system, system.integrate(rtol=1e-5, atol=1e-5))
    assert position > 1e-5
    assert velocity > 1e-5


@pytest.mark.parametrize("solver", ALL)
def test_projection_does_not_spoil_the_order(solver):
    system = at_times(zoo.fourbar(), 3.0, 7, solver)
    expected = at_times(zoo.fourbar(), 3.0, 7, odeint).integrate(rtol=1e-12, atol=1e-12)
    x = system.integrate(constraints="project", **options_of(solver, step=1e-3))
    close(x, expected, 1e-7)


@cache
def mechanism():
    return andrews.derive()


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_andrews_mechanism_ends_at_the_published_angles(solver):
    model = mechanism()
    system = System(
        model.kane,
        constants=model.constants,
        initial_conditions=model.initial_conditions,
        times=np.linspace(0.0, andrews.END, num=101),
        ode_solver=solver,
    )
    x = system.integrate(constraints="project", rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(x[-1, :7], andrews.FINAL, rtol=1e-8)
    position, velocity = residuals(system, x)
    # Lengths are about 0.04 m, angular velocities go up to 1e4 rad/s: 40 m/s.
    assert position < 0.04 * 1e-12
    assert velocity < 40.0 * 1e-10


@pytest.mark.parametrize("solver", ALL)
@pytest.mark.parametrize("name", CONSTRAINED)
def test_residuals_are_rounding_and_energy_is_kept(name, solver):
    model = zoo.MODELS[name]()
    system = at_times(model, 2.0, 21, solver)
    start = wide(system, model.x0)
    system.initial_conditions = dict(zip(system.states, start, strict=True))
    options = options_of(solver, 1e-10, 1e-3)
    x = system.integrate(constraints="project", **options)
    position, velocity = residuals(system, x)
    # Four rounding errors of the terms that cancel: lengths of metres times angles of a few turns.
    assert position < 5e-14
    assert velocity < 1e-13
    close(energy(model, x), np.full(21, energy(model, x[:1])[0]), 1e-7)
    close(x, system.integrate(**options), 1e-6)


def test_a_quaternion_keeps_its_norm():
    # Its residual is out of reach of any speed: it is mended by the least change of position.
    system = at_times(zoo.gyro(), 100.0)
    free = residuals(system, system.integrate(rtol=1e-5, atol=1e-5))[0]
    held = residuals(system, system.integrate(constraints="project", rtol=1e-5, atol=1e-5))[0]
    assert free > 1e-6
    assert held < 1e-15 * 4


def lifting(kind, solver):
    """A particle on a line that rises as s(t) = 0.31 − 0.42 t + 0.1 t²."""
    model = zoo.lifted()
    s = me.dynamicsymbols("s")
    t = zoo.T
    ds, dds = s.diff(t), s.diff(t, 2)
    motion = {
        "expressions": {s: 0.31 - 0.42 * t + t**2 / 10},
        "functions": {
            s: lambda x, t: 0.31 - 0.42 * t + 0.1 * t**2,
            ds: lambda x, t: -0.42 + 0.2 * t,
            dds: lambda x, t: 0.2,
        },
        "samples": {
            s: lambda x, t: 0.31 - 0.42 * t + 0.1 * t**2,
            ds: SampledInput([0.0, 4.0], [-0.42, 0.38]),
            dds: 0.2,
        },
    }[kind]
    system = at_times(model, 2.0, 11, solver, specifieds=motion)
    x, y, vx, vy = model.states
    system.initial_conditions = {x: 0.4, y: 0.0, vx: 0.3, vy: 0.0}
    system.set_dependent_initial_conditions()
    return system


@pytest.mark.parametrize("kind", ["expressions", "functions", "samples"])
@pytest.mark.parametrize("solver", ["dop853", "radau", "rk4"])
def test_constraints_that_move_with_time_and_specifieds_are_held(kind, solver):
    system = lifting(kind, solver)
    x = system.integrate(constraints="project", **options_of(solver, 1e-9))
    position, velocity = residuals(system, x)
    assert position < 1e-14
    assert velocity < 1e-14
    close(x, system.integrate(**options_of(solver, 1e-11)), 1e-6)


def test_projection_works_with_a_generator_that_makes_no_machine_code():
    expected = at_times(zoo.track(), 1.0, 5).integrate(constraints="project")
    system = at_times(zoo.track(), 1.0, 5)
    system.generate_ode_function(generator="lambdify")
    close(system.integrate(constraints="project"), expected, 1e-10)


@pytest.mark.parametrize("linear", ["numpy", "sympy"])
def test_projection_works_with_an_external_linear_solver(linear):
    expected = at_times(zoo.track(), 1.0, 5).integrate(constraints="project")
    system = at_times(zoo.track(), 1.0, 5)
    system.generate_ode_function(linear_sys_solver=linear)
    close(system.integrate(constraints="project"), expected, 1e-10)


def test_outputs_do_not_feed_back():
    system = at_times(zoo.fourbar(), 3.0, 2)
    few = system.integrate(constraints="project")
    system.times = np.linspace(0.0, 3.0, num=200)
    many = system.integrate(constraints="project")
    np.testing.assert_array_equal(many[-1], few[-1])


def test_the_correction_is_the_least_in_the_norm_of_the_mass_matrix():
    # A heavy and a light particle on one rod: mending its length moves the light one.
    q = me.dynamicsymbols("x1 x2")
    u = me.dynamicsymbols("v1 v2")
    m1, m2, n = sm.symbols("m1 m2 l")
    frame, a, b = me.ReferenceFrame("N"), me.Point("A"), me.Point("B")
    a.set_vel(frame, u[0] * frame.x)
    b.set_vel(frame, u[1] * frame.x)
    kane = me.KanesMethod(
        frame, q[:1], u[:1],
        kd_eqs=[x.diff(zoo.T) - v for x, v in zip(q, u, strict=True)],
        q_dependent=q[1:], configuration_constraints=[q[1] - q[0] - n],
        u_dependent=u[1:], velocity_constraints=[u[1] - u[0]],
    )  # fmt: skip
    kane.kanes_equations([me.Particle("A", a, m1), me.Particle("B", b, m2)], None)
    system = System(
        kane,
        constants={m1: 3.0, m2: 1.0, n: 2.0},
        initial_conditions={q[1]: 2.0004, u[1]: 0.0004},
        times=[0.0, 1e-9],
        ode_solver="dop853",
    )
    close(system.integrate(constraints="project")[0], [1e-4, 2.0001, 1e-4, 1e-4], 1e-15)


def test_events_and_projection_go_together():
    model = zoo.fourbar()
    q1, _, _, u1, u2, u3 = model.states
    system = at_times(model, 4.0)
    # Impacts of the crank; the speeds before them are scaled, which keeps the constraints.
    flip = {u: -0.9 * u for u in (u1, u2, u3)}
    x, info = system.integrate(
        events=[Event(q1 + 1.5, direction=-1, reset=flip, name="stop")],
        constraints="project",
        full_output=True,
    )
    position, velocity = residuals(system, x)
    assert position < 1e-13
    assert velocity < 1e-12
    assert len(info["events"]) >= 1
    for record in info["events"]:
        for state in (record.before, record.after):
            assert np.abs(system.evaluate_holonomic_constraints(state)).max() < 1e-13
            assert np.abs(system.evaluate_velocity_constraints(state)).max() < 1e-12


@cache
def bicycle():
    model = whipple_bicycle.derive()
    return model, whipple_bicycle.benchmark_parameters(model)


def test_the_bicycle_keeps_its_wheels_on_the_ground_and_its_energy():
    model, constants = bicycle()
    start = whipple_bicycle.equilibrium(model, 4.6)
    lean_rate = model.kane.u[0]
    system = System(
        model.kane,
        constants=constants,
        initial_conditions={**start, lean_rate: 0.5},
        times=np.linspace(0.0, 5.0, num=51),
        ode_solver="dop853",
    )
    system.set_dependent_initial_conditions()
    kinetic, potential = whipple_bicycle.energy(model)
    f = sm.lambdify(system.states[: len(model.kane.q) + len(model.kane.u)],
                    (kinetic + potential).xreplace(constants), cse=True)  # fmt: skip
    x = system.integrate(constraints="project", rtol=1e-9, atol=1e-9)
    total = f(*x.T)
    assert np.abs(total - total[0]).max() < 1e-6 * abs(total[0])
    position, velocity = residuals(system, x)
    assert position < 1e-13
    assert velocity < 1e-12
    close(x, system.integrate(rtol=1e-11, atol=1e-11), 1e-6)


# -- what cannot be held --------------------------------------------------------------------------


def test_initial_conditions_that_do_not_fit_are_an_integration_error():
    model = zoo.fourbar()
    system = at_times(model, 1.0)
    system.initial_conditions[model.states[1]] += 0.2
    with pytest.raises(IntegrationError, match="initial conditions that do not satisfy") as caught:
        system.integrate(constraints="project")
    message = str(caught.value)
    assert "`dop853`" in message
    assert "t = 0.0" in message
    assert "q2(t) from" in message
    assert "Call `system.set_dependent_initial_conditions()` first." in message
    assert len(caught.value.times) == 0


def test_small_errors_of_the_initial_conditions_are_mended():
    model = zoo.fourbar()
    system = at_times(model, 1.0)
    system.initial_conditions[model.states[1]] += 1e-7
    x = system.integrate(constraints="project")
    assert 1e-9 < np.abs(x[0] - wide(system, model.x0)).max() < 1e-6
    assert residuals(system, x)[0] < 1e-13


def pair(position, velocity):
    """A particle in a plane with two rows that hold it on a line, or nearly so."""
    x, y, z, vx, vy, vz = me.dynamicsymbols("x y z vx vy vz")
    rows = position(x, y, z)
    frame, p = me.ReferenceFrame("N"), me.Point("P")
    p.set_vel(frame, vx * frame.x + vy * frame.y + vz * frame.z)
    kane = me.KanesMethod(
        frame,
        [x, z][: 3 - len(rows)],
        [vx, vz],
        kd_eqs=[q.diff(zoo.T) - u for q, u in ((x, vx), (z, vz), (y, vy))],
        q_dependent=[y, z][: len(rows)],
        configuration_constraints=rows,
        u_dependent=[vy],
        velocity_constraints=velocity(vx, vy, vz),
    )
    kane.kanes_equations([me.Particle("P", p, sm.Integer(1))], [(p, -frame.y)])
    return kane


@cache
def redundant():
    return pair(lambda x, y, z: [y - x, 2 * y - 2 * x], lambda vx, vy, vz: [vy - vx])


def sliding(kane, **options):
    return System(kane, times=np.linspace(0.0, 1.0, num=5), ode_solver="dop853", **options)


def test_a_redundant_constraint_is_held_and_named_once():
    system = sliding(redundant())
    with pytest.warns(PyDyUserWarning, match="Redundant constraints at t = 0.0: ") as caught:
        x = system.integrate(constraints="project")
    assert len(caught) == 1
    assert "holonomic constraint 1: -2*x(t) + 2*y(t)" in str(caught[0].message)
    assert "constraint 0" not in str(caught[0].message)
    assert np.abs(x[:, 0] - x[:, 1]).max() < 1e-15
    close(x[:, 0], -(system.times**2) / 4, 1e-9)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system.integrate(constraints="project")


def test_of_many_redundant_constraints_two_are_named():
    q, p, u, v = (me.dynamicsymbols(f"{name}:6") for name in "qpuv")
    frame, origin = inertial_frame()
    bodies = []
    for k, (x, y, vx, vy) in enumerate(zip(q, p, u, v, strict=True)):
        point = origin.locatenew(f"P{k}", x * frame.x + y * frame.y)
        point.set_vel(frame, vx * frame.x + vy * frame.y)
        bodies.append(me.Particle(f"P{k}", point, sm.Integer(1)))
    rows = [x - y for x, y in zip(q[:3], p[:3], strict=True)]
    kane = me.KanesMethod(
        frame, q, u,
        kd_eqs=[x.diff(zoo.T) - vx for x, vx in zip((*q, *p), (*u, *v), strict=True)],
        q_dependent=p, configuration_constraints=[*rows, *(2 * row for row in rows)],
        u_dependent=v, velocity_constraints=[vx - vy for vx, vy in zip(u, v, strict=True)],
    )  # fmt: skip
    kane.kanes_equations(bodies, [])
    with pytest.warns(PyDyUserWarning, match="Redundant constraints .*; and 1 more") as caught:
        sliding(kane).integrate(constraints="project")
    assert len(caught) == 1
    assert str(caught[0].message).count("holonomic constraint") == 2


def test_constraints_that_are_independent_are_not_warned_of():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for name in CONSTRAINED:
            model = zoo.MODELS[name]()
            system = at_times(model, 0.1, 2)
            system.integrate(constraints="project")


def test_constraints_that_contradict_each_other_are_an_integration_error():
    kane = pair(lambda x, y, z: [y - x, y - x - 1], lambda vx, vy, vz: [vy - vx])
    with (
        pytest.warns(PyDyUserWarning, match="Redundant constraints"),
        pytest.raises(IntegrationError, match="the projection did not converge"),
    ):
        sliding(kane).integrate(constraints="project")


def test_constraints_that_can_no_longer_be_met_stop_the_integration():
    # y = √(1 − 2 t) x: after half a second there is no such line.
    t = zoo.T
    kane = pair(
        lambda x, y, z: [y - sm.sqrt(1 - 2 * t) * x],
        lambda vx, vy, vz: [vy - vx],
    )
    x = kane.q[0]
    system = sliding(kane, initial_conditions={x: 0.0})
    with pytest.raises(IntegrationError) as caught:
        system.integrate(constraints="project")
    message = str(caught.value)
    assert "could not bring the state back onto the constraints after a step of" in message
    assert "x(t) = " in message
    assert "limit `max_step`" in message
    assert 0.0 <= caught.value.time <= 0.5
    assert np.isfinite(caught.value.states).all()


def towed(row):
    """Two points on a line, one drawn to the other, which a row moves."""
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    x, y, v, w = me.dynamicsymbols("x, y, v, w")
    origin.set_vel(frame, 0)
    first, second = (origin.locatenew(n, q * frame.x) for n, q in (("P", x), ("Q", y)))
    bodies = [me.Particle("p", first, 1), me.Particle("q", second, 1)]
    kind = "nonholonomic_constraints" if row.has(v) else "holonomic_constraints"
    loads = [(second, (x - y) * frame.x)]
    definition = Definition(frame, [x, y], [v, w], bodies=bodies, loads=loads, **{kind: [row]})
    return System(definition, times=[0.0, 2.0], initial_conditions={})


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_motions_that_constraints_make_within_a_part_of_a_step_are_not_passed_over(solver):
    # Right to 3e-6, as of jumps: x = H(t − 1), y'' = x − y, and v = H(t − 1).
    start = (1 + sm.tanh(1000 * (zoo.T - 1))) / 2
    x, v = me.dynamicsymbols("x, v")
    for row, right in ((x - start, [1, 1 - np.cos(1)]), (v - start, [1, 1 - np.sin(1)])):
        system = towed(row)
        system.ode_solver = solver
        motion = system.simulate(constraints="project", rtol=1e-9, atol=1e-9)
        found = [motion[name][-1] for name in "xy"]
        np.testing.assert_allclose(found, right, atol=3e-6)
        if solver != "radau":
            many = system.integrate_ensemble(
                initial_conditions={"y": [0.0]}, constraints="project", rtol=1e-9, atol=1e-9
            )
            assert np.array_equal([many[name].values[0, -1] for name in "xy"], found)


def test_measured_motions_that_contradict_their_measured_rates_reject_no_steps():
    # Noise of the rates alone, which no step explains: as many steps as without projection.
    belt, v = me.dynamicsymbols("belt, v")
    times, noise = np.linspace(0.0, 6.0, 61), np.random.default_rng(0)
    rates = np.cos(times) + 1e-4 * noise.normal(size=61)
    system = towed(v - belt)
    system.specifieds = {
        belt: SampledInput(times, np.sin(times), interpolation="pchip"),
        belt.diff(zoo.T): SampledInput(times, rates, interpolation="pchip"),
    }
    system.ode_solver = "dop853"
    _, info = system.integrate(full_output=True, constraints="project", rtol=1e-9, atol=1e-9)
    assert info["steps"] < 100  # the samples have 20 knots on the way


@pytest.mark.filterwarnings("ignore:.*jumps by")
def test_constraints_that_jump_end_a_projected_motion():
    system = towed(me.dynamicsymbols("v") - sm.Heaviside(zoo.T - 1))
    system.ode_solver = "dop853"
    with pytest.raises(IntegrationError, match="satisfied there and do not jump") as caught:
        system.integrate(constraints="project")
    assert caught.value.time == pytest.approx(1.0)


@pytest.mark.parametrize("angle", [0.3, 0.5])
@pytest.mark.parametrize("mass", [1.7, 2.0, 3.0])
def test_coordinates_that_are_held_at_zero_need_not_be_zero_to_the_last_bit(angle, mass):
    # A block on a wedge that is held at the origin: corrections along the slope are felt there.
    N, O = inertial_frame()
    q, u = me.dynamicsymbols("x y X Y"), me.dynamicsymbols("v_x v_y V_x V_y")
    P, W = O.locatenew("P", q[0] * N.x + q[1] * N.y), O.locatenew("W", q[2] * N.x + q[3] * N.y)
    P.set_vel(N, u[0] * N.x + u[1] * N.y)
    W.set_vel(N, u[2] * N.x + u[3] * N.y)
    across = sm.Float(np.sin(angle)) * (q[0] - q[2]) + sm.Float(np.cos(angle)) * (q[1] - q[3])
    wedge = Definition(
        N, q, u, bodies=[me.Particle("block", P, 1), me.Particle("wedge", W, mass)],
        loads=[(P, -9.81 * N.y)], holonomic_constraints=[across, q[3], q[2]],
    )  # fmt: skip
    system = System(wedge, ode_solver="dop853", times=np.linspace(0.0, 1.0, 3))
    motion = system.simulate(constraints="project", rtol=1e-11, atol=1e-12)
    assert motion["x"][-1] == pytest.approx(9.81 / 4 * np.sin(2 * angle), rel=1e-12)
    assert motion.statistics["rejected"] == 0


@pytest.mark.parametrize("length", [1.0, 1e-9, 1.5e11])
def test_a_wall_and_a_floor_are_two_constraints_in_any_unit_of_length(length):
    # Beside the rod's length the angle's column hides those of the places.
    N, A, O = me.ReferenceFrame("N"), me.ReferenceFrame("A"), me.Point("O")
    x, y, a, vx, vy, w = me.dynamicsymbols("x y a v_x v_y w")
    m, half, g = sm.symbols("m l g")
    O.set_vel(N, 0)
    A.orient_axis(N, N.z, a)
    A.set_ang_vel(N, w * N.z)
    C = O.locatenew("C", x * N.x + y * N.y)
    C.set_vel(N, vx * N.x + vy * N.y)
    rod = me.RigidBody("rod", C, A, m, (me.inertia(A, 0, 0, m * half**2 / 3), C))
    held = [x - half * sm.cos(a), y - half * sm.sin(a)]
    ladder = Definition(
        N, [x, y, a], [vx, vy, w], bodies=[rod], loads=[(C, -m * g * N.y)],
        holonomic_constraints=held,
    )  # fmt: skip
    system = System(
        ladder, {half: length, g: 9.81 * length}, ode_solver="dop853",
        initial_conditions={x: 0.6 * length, y: 0.8 * length, a: np.arctan2(0.8, 0.6)},
        times=np.linspace(0.0, 0.5, 3),
    )  # fmt: skip
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        atol = 1e-12 * np.array([length, length, 1.0] * 2)
        motion = system.simulate(constraints="project", rtol=1e-10, atol=atol)
    assert np.ptp(motion.energy[:, 2]) < 1e-9 * 9.81 * length**2


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_a_step_that_ends_too_far_from_the_constraints_is_tried_again_with_a_shorter_one(solver):
    # Newton's method for atan(z) = 0 diverges from 1.4 on, which here is 1.4e-5 m off the curve.
    x = me.dynamicsymbols("x")
    kane = pair(
        lambda x, y, z: [sm.atan(10**5 * (y - sm.sin(4 * x)))],
        lambda vx, vy, vz: [vy - 4 * sm.cos(4 * x) * vx],
    )
    system = sliding(kane, initial_conditions={kane.u[0]: 1.0})
    system.ode_solver = solver
    system.set_dependent_initial_conditions()
    states, info = system.integrate(constraints="project", rtol=1e-3, atol=1e-3, full_output=True)
    assert info["rejected"] > 0
    at = {s: states[:, k] for k, s in enumerate(system.states)}
    y, vx, vy = (at[s] for s in (kane.q[2], kane.u[0], kane.u[2]))
    np.testing.assert_allclose(y, np.sin(4 * at[x]), rtol=0, atol=1e-13)
    energy = (vx**2 + vy**2) / 2 + y
    np.testing.assert_allclose(energy, energy[0], rtol=2e-3)


def test_a_reset_to_where_the_constraints_have_no_rates_is_an_integration_error():
    x = me.dynamicsymbols("x")
    root = sm.sqrt(1 - x)
    kane = pair(lambda x, y, z: [y - root], lambda vx, vy, vz: [vy + vx / (2 * root)])
    system = sliding(kane, initial_conditions={x: 0.0, kane.q[-1]: 1.0})
    jump = Event(zoo.T - 0.3, reset={x: 2.0})
    with pytest.raises(IntegrationError, match=r"at t = 0\.3"):
        system.integrate(constraints="project", events=[jump])


WRONG = [
    (
        {"constraints": "hold"},
        r"`constraints` must be one of None, 'project', 'baumgarte', got 'hold'",
    ),
    ({"constraints": "project", "gain": 1.0}, "`gain` and `constraints='baumgarte'` belong tog"),
]


@pytest.mark.parametrize(("options", "message"), WRONG)
def test_wrong_options_are_value_errors(options, message):
    with pytest.raises(ValueError, match=message):
        at_times(zoo.fourbar(), 1.0).integrate(**options)


def test_an_unconstrained_system_has_nothing_to_project():
    with pytest.raises(ValueError, match="but the system has none"):
        at_times(zoo.pendulum(), 1.0).integrate(constraints="project")


def test_projection_needs_a_native_solver():
    with pytest.raises(ValueError, match="`constraints='project'` needs a native solver"):
        at_times(zoo.fourbar(), 1.0, solver=odeint).integrate(constraints="project")


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_no_constraints_option_means_none(solver):
    system = at_times(zoo.fourbar(), 1.0, solver=solver)
    np.testing.assert_array_equal(system.integrate(constraints=None), system.integrate())


def test_constraints_are_printed_only_for_messages(monkeypatch):
    # Those of a Stewart platform take a second to print.
    system = at_times(zoo.fourbar(), 0.1)
    monkeypatch.setattr(
        "pydy._motion.events_and_constraints.constraint_names", lambda equations: 1 / 0
    )
    system.integrate(constraints="project")
