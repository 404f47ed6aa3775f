"""Numbers and motions that contradict the assumptions of their symbols."""

import pickle
import warnings
from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import odeint, solve_ivp

import zoo
from pydy.analysis import Trial
from pydy.contact import Contacts, Unilateral
from pydy.errors import PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.system import System

TIME = me.dynamicsymbols._t
k = sm.Symbol("k", positive=True)


@cache
def definition(force, **assumption):
    """A particle of mass 1 on a line, pulled by a force; its coordinate carries an assumption."""
    q, u = me.dynamicsymbols("q", **assumption), me.dynamicsymbols("u")
    frame, origin = zoo.inertial_frame()
    point = origin.locatenew("P", q * frame.x)
    point.set_vel(frame, u * frame.x)
    loads = [(point, sm.sympify(force(q)) * frame.x)]
    return Definition(frame, [q], [u], bodies=[me.Particle("P", point, 1)], loads=loads)


def spring(q):
    return -q


def spring_at_rest_length_one(q):
    return k * (1 - q)


def pushed(q):
    return me.dynamicsymbols("F", positive=True)


def oscillator(solver="odeint", **assumption):
    system = System(definition(spring, **assumption), ode_solver=solver)
    system.times = [0.0, 2.0 * np.pi]  # back at the start: only steps between show the other side
    system.initial_conditions["q"] = -1.0 if "negative" in assumption else 1.0
    return system


def options_of(solver):
    return {"step": 0.05} if solver == "rk4" else {"rtol": 1e-6, "atol": 1e-6}


def warnings_of(call):
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        call()
    return [str(w.message) for w in told]


# -- given numbers ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("assumption", "value", "words"),
    [
        ("positive", -2.0, "cannot be negative"),
        ("nonnegative", -2.0, "cannot be negative"),
        ("negative", 2.0, "cannot be positive"),
        ("nonpositive", 2.0, "cannot be positive"),
        ("nonzero", 0.0, "cannot be zero"),
        ("integer", 0.5, "is an integer"),
        ("even", 1.0, "is an even number"),
        ("odd", 2.0, "is an odd number"),
        ("zero", 1.0, "is zero"),
    ],
)
def test_an_initial_condition_that_contradicts_its_assumption_is_told(assumption, value, words):
    system = System(definition(spring, **{assumption: True}))
    text = f"`initial_conditions` for `q\\(t\\)` is {value:g}, .* one that {words}.*may be wrong"
    with pytest.warns(PyDyUserWarning, match=text):
        system.initial_conditions = {"q": value}


def test_an_initial_condition_that_is_edited_in_place_is_told_once_by_the_first_call():
    system = System(definition(spring, positive=True))
    system.initial_conditions["q"] = -2.0
    (told,) = warnings_of(lambda: [system.evaluate_ode() for _ in range(3)])
    assert "`initial_conditions` for `q(t)` is -2" in told


def test_each_assignment_tells_anew():
    system = System(definition(spring, positive=True))
    for _ in range(2):
        with pytest.warns(PyDyUserWarning, match="cannot be negative"):
            system.initial_conditions = {"q": -1.0}


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (-2.0, "`specifieds` for `F\\(t\\)` is -2, "),
        (SampledInput([0.0, 1.0], [1.0, -3.0]), "`specifieds` for `F\\(t\\)` is -3 at t = 1,"),
    ],
)
def test_a_specified_that_contradicts_its_assumption_is_told_when_it_is_given(value, text):
    system = System(definition(pushed))
    with pytest.warns(PyDyUserWarning, match=text):
        system.specifieds = {"F": value}


@pytest.mark.parametrize("value", [lambda x, t: -2.0, sm.cos(TIME) - 3])
def test_a_specified_that_is_computed_is_told_where_it_is_evaluated(value):
    system = System(definition(pushed), specifieds={"F": value})
    with pytest.warns(PyDyUserWarning, match=r"specified `F\(t\)` is -2, .* negative"):
        system.evaluate_ode()


@pytest.mark.parametrize("value", [lambda x, t: np.cos(t), sm.cos(TIME)])
def test_a_specified_that_becomes_negative_along_a_motion_is_told_once(value):
    system = System(definition(pushed), specifieds={"F": value}, times=np.linspace(0.0, 3.0, 31))
    told = warnings_of(lambda: [system.integrate(), system.simulate()])
    assert [t[:15] for t in told] == ["`F(t)` is -0.98"]


@pytest.mark.parametrize("given", [{"x": [-1.0, 0.0]}, {"p": [-1.0]}, {"p": {"k": -1.0}}])
def test_numbers_of_one_evaluation_are_told(given):
    system = System(definition(spring_at_rest_length_one, positive=True))
    with pytest.warns(PyDyUserWarning, match=r"` for `(q\(t\)|k)` is -1, .*cannot be negative"):
        system.evaluate_ode(**given)


@pytest.mark.parametrize("r", [[-1.0], {"F": -1.0}, lambda x, t: [-1.0]])
def test_specifieds_of_one_evaluation_are_told(r):
    system = System(definition(pushed))
    with pytest.warns(PyDyUserWarning, match=r"`F\(t\)` is -1, .*cannot be negative"):
        system.evaluate_ode(r=r)


def test_zero_is_the_limit_of_what_is_positive():
    system = System(definition(pushed), specifieds={"F": lambda x, t: 0.0}, times=[0.0, 1.0])
    assert not warnings_of(system.integrate)
    system = System(definition(spring_at_rest_length_one, positive=True), constants={"k": 0.0})
    system.times = [0.0, 1.0]
    assert not warnings_of(system.integrate)


# -- motions ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", ["odeint", "dop853", "radau", "rk4", "RK45", "BDF"])
def test_a_state_that_leaves_its_assumption_between_two_times_is_told_once(solver):
    system = oscillator(solver, positive=True)
    options = options_of(solver)
    told = warnings_of(lambda: [system.integrate(**options), system.simulate(**options)])
    assert len(told) == 1
    assert told[0].startswith(("`q(t)` is -0.9", "`q(t)` is -1 at"))
    assert "of a motion, but its symbol was made as one that cannot be negative" in told[0]


@pytest.mark.parametrize(
    ("assumption", "words"),
    [
        ("negative", "cannot be positive"),
        ("nonzero", "cannot be zero"),
        ("integer", "is an integer"),
        ("odd", "is an odd number"),
    ],
)
def test_states_that_leave_other_assumptions_are_told(assumption, words):
    system = oscillator("dop853", **{assumption: True})
    with pytest.warns(PyDyUserWarning, match=words):
        system.integrate()


def test_information_is_as_it_was_asked_for():
    for solver in ("dop853", "RK45", "odeint"):
        system, other = oscillator(solver, nonnegative=True), oscillator(solver)
        system.initial_conditions["q"] = 0.0
        assert system.integrate(full_output=True)[1].keys() == (
            other.integrate(full_output=True)[1].keys()
        )


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("solver", ["odeint", "dop853", "radau", "RK45"])
def test_a_state_that_touches_zero_by_the_solvers_errors_is_not_told(solver, size):
    # q = size (1 - cos t)
    stretched = definition(spring_at_rest, positive=True)
    system = System(stretched, constants={"l": size}, ode_solver=solver)
    system.times = np.linspace(0.0, 20.0 * np.pi, 201)
    options = {"rtol": 1e-6, "atol": 1e-6 * size}
    assert not warnings_of(lambda: system.integrate(**options))
    system.initial_conditions["q"] = 2.2 * size  # the lowest is -0.2 size
    with pytest.warns(PyDyUserWarning, match=r"`q\(t\)` is -(2e-10|0\.2|2e\+08|\S*99\S*) at t"):
        system.integrate(**options, **({"max_step": 0.3} if solver != "odeint" else {"hmax": 0.3}))


def falling(q):
    return -1.0


def spring_at_rest(q):
    return sm.Symbol("l") - q


def drag(omega):
    return -sm.Rational(3, 10) * sm.sqrt(omega**2) * omega


def test_a_pendulum_whose_drag_lost_the_root_of_a_square_is_told_and_its_motion_is_another():
    theta, omega = me.dynamicsymbols("theta omega", positive=True)
    frame, origin = zoo.inertial_frame()
    arm = frame.orientnew("A", "Axis", (theta, frame.z))
    arm.set_ang_vel(frame, omega * frame.z)
    bob = origin.locatenew("B", -arm.y)
    bob.v2pt_theory(origin, frame, arm)
    loads = [(bob, -9.81 * frame.y), (arm, drag(omega) * frame.z)]
    system = System(
        Definition(frame, [theta], [omega], bodies=[me.Particle("B", bob, 1)], loads=loads),
        initial_conditions={theta: 1.0},
        times=[0.0, 5.0],
    )
    with pytest.warns(PyDyUserWarning, match=r"`(theta|omega)\(t\)` is -.*may be wrong"):
        wrong = system.integrate(rtol=1e-8, atol=1e-8)[-1, 0]
    right = solve_ivp(
        lambda t, x: [x[1], -9.81 * np.sin(x[0]) - 0.3 * abs(x[1]) * x[1]], (0.0, 5.0),
        [1.0, 0.0], rtol=1e-8, atol=1e-8,
    ).y[0, -1]  # fmt: skip
    assert right == pytest.approx(-0.29209, abs=1e-4)
    assert abs(wrong - right) > 1.0  # which is why it is told


def test_a_users_own_solver_is_judged_at_its_times():
    system = oscillator(nonnegative=True)
    system.ode_solver = lambda f, x0, t, args=(): odeint(f, x0, t, args=args)
    system.times = [0.0, 1.0, 3.0]
    with pytest.warns(PyDyUserWarning, match=r"`q\(t\)` is -0.98999"):
        system.integrate()


def test_a_motion_with_contacts_is_judged_once():
    system = System(definition(falling, positive=True), times=[0.0, 3.0], ode_solver="dop853")
    contacts = Contacts(system, [Unilateral(system.coordinates[0] + 2)])
    (told,) = warnings_of(lambda: [contacts.simulate() for _ in range(2)])
    assert told.startswith("`q(t)` is -2 at t = ")


# -- many motions, fits, sweeps --------------------------------------------------------------------


@pytest.mark.parametrize("reduce", [None, "final", ("max", "q")])
@pytest.mark.parametrize("assumption", ["positive", "nonzero"])
def test_samples_that_leave_their_assumption_are_told_once(assumption, reduce):
    system = oscillator("dop853", **{assumption: True})
    system.times = np.linspace(0.0, 2.0 * np.pi, 21)
    samples = {"initial_conditions": {"q": [1e-3, 1.0]}, "reduce": reduce}
    told = warnings_of(lambda: [system.integrate_ensemble(**samples) for _ in range(2)])
    assert len(told) == 1
    assert "in one sample or more" in told[0]


@pytest.mark.parametrize(
    ("made", "given"),
    [
        (spring_at_rest_length_one, {"constants": {"k": [1.0, -1.0]}}),
        (spring_at_rest_length_one, {"constants": {"k": -1.0}}),
        (pushed, {"specifieds": {"F": [0.0, -1.0]}}),
        (pushed, {"specifieds": {"F": -1.0}}),
    ],
)
def test_values_of_samples_are_told(made, given):
    system = System(definition(made), times=[0.0, 1.0])
    with pytest.warns(PyDyUserWarning, match="is -1.*cannot be negative"):
        system.integrate_ensemble(**given, ode_solver="dop853")


def test_an_estimate_that_contradicts_its_assumption_is_told_once_at_the_end():
    system = System(definition(lambda q: k * q), ode_solver="dop853")
    times = np.linspace(0.0, 3.0, 13)
    trial = Trial(times, {"q": np.cos(times)}, {"q": 1.0})
    (told,) = warnings_of(lambda: system.fit(["k"], trial))
    assert told.startswith("The estimate of `k` is -1, but")


def test_values_of_a_sweep_are_told():
    system = System(definition(spring_at_rest_length_one))
    with pytest.warns(PyDyUserWarning, match="`over` for `k` is -1, .* negative"):
        system.eigenvalues({"k": [-1.0, 2.0]})


# -- orientations ----------------------------------------------------------------------------------


def turning(**options):
    """A symmetric body that turns freely, oriented by a quaternion that no constraint holds."""
    q, u, t = me.dynamicsymbols("e0:4"), me.dynamicsymbols("w1:4"), me.dynamicsymbols._t
    frame, centre = me.ReferenceFrame("N"), me.Point("C")
    body = frame.orientnew("B", "Quaternion", q)
    body.set_ang_vel(frame, sum((w * axis for w, axis in zip(u, body, strict=True)), 0 * frame.x))
    centre.set_vel(frame, 0)
    x, y, z = u
    rates = [-q[1] * x - q[2] * y - q[3] * z, q[0] * x + q[2] * z - q[3] * y,
             q[0] * y + q[3] * x - q[1] * z, q[0] * z + q[1] * y - q[2] * x]  # fmt: skip
    solid = me.RigidBody("solid", centre, body, 1, (me.inertia(body, 1, 1, 1), centre))
    return System(
        Definition(
            frame, q, u, bodies=[solid],
            kinematic_equations=[2 * e.diff(t) - rate for e, rate in zip(q, rates, strict=True)],
        ),
        times=[0.0, 1.0], ode_solver="dop853", **options,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("start", "message"),
    [
        ({}, r"e0 = 0, e1 = 0, e2 = 0, e3 = 0 orient no frame.* by 1\..* Set e0 = 1 for a frame"),
        ({"e1": 2.0}, r"e0 = 0, e1 = 2, .* by 15\..* Scale them to unit length"),
    ],
)
def test_a_quaternion_that_is_not_of_unit_length_is_a_warning(start, message):
    system = turning(initial_conditions={"w1": 0.6, **start})
    with pytest.warns(PyDyUserWarning, match=message):
        system.simulate()
    with pytest.warns(PyDyUserWarning, match=message):
        system.integrate()


def test_linear_models_and_ensembles_warn_of_a_quaternion_that_is_not_of_unit_length():
    system = turning(initial_conditions={"e0": 1.0})
    with pytest.warns(PyDyUserWarning, match="In state 1 of `at`, e0 = 0, e1 = 0.9, .* no frame"):
        system.linearize(at=[[1.0, *[0.0] * 6], [0.0, 0.9, *[0.0] * 5]])
    with pytest.warns(PyDyUserWarning, match="conditions of sample 1, e0 = 1, e1 = 0.5, .* Scale"):
        system.integrate_ensemble(initial_conditions={"e1": [0.0, 0.5]})
    system.linearize()  # warnings are errors
    system.integrate_ensemble(initial_conditions={"w1": [0.0, 0.5]})


def leaning(**options):
    """A pendulum that a quaternion orients, under its weight."""
    system = turning()
    definition = system.eom_method
    (solid,) = definition.bodies
    origin, frame = me.Point("O"), definition.frame
    origin.set_vel(frame, 0)
    centre = origin.locatenew("G", 2 * solid.frame.x)
    centre.v2pt_theory(origin, frame, solid.frame)
    body = me.RigidBody("solid", centre, solid.frame, 1, (solid.central_inertia, centre))
    return System(
        Definition(
            frame, definition.coordinates, definition.speeds, bodies=[body],
            loads=[(centre, -9.81 * frame.z)],
            kinematic_equations=definition.kinematic_equations, **options,
        )
    )  # fmt: skip


def length_is_held(system):
    coordinates = system.eom_method.coordinates
    return {"holonomic_constraints": [sum(e**2 for e in coordinates) - 1]}


BAD, UNIT = [0.6, 0.0, 0.6, 0.0, 0.1, 0.2, 0.3], [0.6, 0.0, 0.8, 0.0, 0.1, 0.2, 0.3]
OF_EVALUATIONS = "e0 = 0.6, e1 = 0, e2 = 0.6, e3 = 0 orient no frame.* theirs is 0.848528"


@pytest.mark.parametrize("held", [False, True])
@pytest.mark.parametrize(
    "evaluate",
    [
        lambda system, x: system.evaluate_ode(x),
        lambda system, x: system.evaluate_jacobian(x=x),
        lambda system, x: system.evaluate_energy(x),
        lambda system, x: system.evaluate_gradient(system.potential_energy, x=x),
        lambda system, x: system.gravity(x[:4]),
        lambda system, x: system.frame_rotation("solid", x[:4]),
        lambda system, x: system.inverse_dynamics(x[:4], x[4:], [0.0, 0.0, 0.0]),
        lambda system, x: system.generate_ode_function()(x, 0.0, []),
        lambda system, x: system.generate_ode_function(time_first=True)(0.0, x, []),
    ],
)
def test_evaluations_warn_of_a_quaternion_that_is_not_of_unit_length(evaluate, held):
    system = leaning(**(length_is_held(turning()) if held else {}))
    evaluate(system, UNIT)  # warnings are errors
    system = leaning(**(length_is_held(turning()) if held else {}))
    with pytest.warns(PyDyUserWarning, match=f"In the state, {OF_EVALUATIONS}"):
        evaluate(system, BAD)


def test_evaluations_warn_once_and_name_the_row():
    system = leaning()
    with pytest.warns(PyDyUserWarning, match=f"In state 1 of those to evaluate, {OF_EVALUATIONS}"):
        system.evaluate_ode([UNIT, BAD])
    system.evaluate_ode(BAD)


def test_what_depends_on_no_quaternion_does_not_warn_of_it():
    system = leaning(**length_is_held(turning()))
    masses = np.diag([1.0, 1.0 + 4.0, 1.0 + 4.0])
    np.testing.assert_allclose(system.mass_matrix(BAD[:4]), masses, atol=1e-15)
    # The residual says that it is not of unit length.
    np.testing.assert_allclose(system.evaluate_holonomic_constraints(BAD), [2 * 0.6**2 - 1])


def test_a_generated_function_judges_its_first_state_alone():
    """Later states may be stages of an integrator, which leave the unit length."""
    rhs = leaning().generate_ode_function()
    rhs(np.array(UNIT), 0.0, np.zeros(0))
    np.testing.assert_allclose(rhs(np.array(BAD), 0.0, np.zeros(0))[0], -0.6 * 0.2 / 2)
    again = pickle.loads(pickle.dumps(rhs))
    with pytest.warns(PyDyUserWarning, match=OF_EVALUATIONS):
        again(np.array(BAD), 0.0, np.zeros(0))


def test_an_exported_start_warns_of_a_quaternion_that_is_not_of_unit_length(tmp_path):
    system = leaning()
    with pytest.warns(PyDyUserWarning, match="The initial conditions e0 = 0, .* Set e0 = 1"):
        system.export(tmp_path / "leaning.c")
    system.initial_conditions = {"e0": 1.0}
    system.export(tmp_path / "leaning.c")


def test_a_quaternion_that_the_matrix_normalises_may_have_any_length():
    """Its matrix is divided by the square of its length: a rotation at any length."""
    q, (u, *_) = me.dynamicsymbols("e0:4"), me.dynamicsymbols("w1:4")
    frame, centre = me.ReferenceFrame("N"), me.Point("C")
    other = me.ReferenceFrame("M")
    matrix = other.dcm(other.orientnew("A", "Quaternion", q)) / sum(e**2 for e in q)
    body = frame.orientnew("B", "DCM", matrix)
    body.set_ang_vel(frame, u * body.x)
    centre.set_vel(frame, 0)
    solid = me.RigidBody("solid", centre, body, 1, (me.inertia(body, 1, 1, 1), centre))
    rates = [-q[1] * u, q[0] * u, q[3] * u, -q[2] * u]
    system = System(
        Definition(
            frame, q, [u], bodies=[solid],
            kinematic_equations=[2 * e.diff(TIME) - rate for e, rate in zip(q, rates, strict=True)],
        )
    )  # fmt: skip
    np.testing.assert_allclose(
        system.frame_rotation("solid", [2.0, 2.0, 0.0, 0.0]),
        [[1, 0, 0], [0, 0, -1], [0, 1, 0]], atol=1e-15,
    )  # fmt: skip


def test_a_matrix_of_small_angles_is_no_quaternion():
    q, u = me.dynamicsymbols("a1:4"), me.dynamicsymbols("w1:4")
    frame, centre = me.ReferenceFrame("N"), me.Point("C")
    body = frame.orientnew(
        "B", "DCM", sm.Matrix([[1, q[2], -q[1]], [-q[2], 1, q[0]], [q[1], -q[0], 1]])
    )
    body.set_ang_vel(frame, sum((w * axis for w, axis in zip(u, body, strict=True)), 0 * frame.x))
    centre.set_vel(frame, 0)
    solid = me.RigidBody("solid", centre, body, 1, (me.inertia(body, 1, 1, 1), centre))
    rates = [angle.diff(TIME) - w for angle, w in zip(q, u, strict=True)]
    linear = Definition(frame, q, u, bodies=[solid], kinematic_equations=rates)
    system = System(linear, times=[0.0, 1.0], initial_conditions={"a1": 0.1, "w1": 0.2})
    np.testing.assert_allclose(system.simulate()["a1"], [0.1, 0.3], rtol=1e-6)


def test_a_unit_quaternion_is_none():
    system = turning(initial_conditions={"w1": 0.6, "e0": 0.7071, "e1": 0.7071})
    final = system.simulate(rtol=1e-10, atol=1e-10).states[-1]  # warnings are errors
    angle = np.pi / 4 + 0.3
    np.testing.assert_allclose(final[:2], [np.cos(angle), np.sin(angle)], atol=1e-4)
