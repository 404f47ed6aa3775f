"""set_dependent_initial_conditions: states that satisfy the constraints."""

import re
import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy._errors import PyDyUserWarning, SingularMatrixError
from pydy._names import name_of
from pydy.examples import whipple_bicycle
from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame, loops
from zoo.cases import close, system_of

SOLVABLE = ["disc", "disc_contact", "sleigh", "skate", "fourbar", "track", "track_reversed", "gyro"]
SOLVABLE += ["lifted"]


def near(model):
    """Start of the model with the dependent states a little off."""
    kane, start = model.kane, dict(model.start)
    for s in kane._qdep:
        start[s] = start.get(s, 0.0) + 0.1
    for s in kane._udep:
        start[s] = 0.0
    return start


def residuals(system):
    values = []
    if system.num_holonomic_constraints:
        values.extend(system.evaluate_holonomic_constraints())
    if system.num_velocity_constraints:
        values.extend(system.evaluate_velocity_constraints())
    return np.array(values)


@pytest.mark.parametrize("use_jac", [False, True])
@pytest.mark.parametrize("name", SOLVABLE)
def test_the_constraints_hold_afterwards(name, use_jac):
    model = zoo.MODELS[name]()
    system = system_of(model, initial_conditions=near(model))
    assert np.max(np.abs(residuals(system))) > 1e-3
    system.set_dependent_initial_conditions(use_jac=use_jac)
    close(residuals(system), np.zeros_like(residuals(system)), 1e-9)


@pytest.mark.parametrize("name", ["disc", "sleigh", "fourbar", "track", "track_reversed", "gyro"])
def test_the_solution_near_by_is_found(name):
    model = zoo.MODELS[name]()
    system = system_of(model, initial_conditions=near(model))
    system.set_dependent_initial_conditions()
    close([system.initial_conditions.get(s, 0.0) for s in system.states], model.x0, 1e-8)


@pytest.mark.parametrize("name", ["fourbar", "track", "disc"])
def test_independent_states_are_left_alone(name):
    model = zoo.MODELS[name]()
    start = near(model)
    system = system_of(model, initial_conditions=start)
    system.set_dependent_initial_conditions()
    dependent = {*model.kane._qdep, *model.kane._udep}
    for s in set(start) - dependent:
        assert system.initial_conditions[s] == start[s]


def test_results_are_floats_in_the_initial_conditions():
    model = zoo.fourbar()
    system = system_of(model, initial_conditions=near(model))
    system.set_dependent_initial_conditions()
    assert all(isinstance(v, float) for v in system.initial_conditions.values())


@pytest.mark.parametrize("use_jac", [False, True])
def test_other_dependent_states_can_be_named(use_jac):
    model = zoo.fourbar()
    q1, q2, q3, u1, u2, u3 = model.states
    start = {**model.start, q1: model.start[q1] + 0.1, q2: model.start[q2] - 0.1, u1: 0.0, u3: 0.0}
    system = system_of(model, initial_conditions=start)
    system.set_dependent_initial_conditions(dep_vars=[q1, q2, u1, u3], use_jac=use_jac)
    close(residuals(system), np.zeros(4), 1e-9)
    assert system.initial_conditions[q3] == model.start[q3]
    assert system.initial_conditions[u2] == model.start[u2]


def test_the_order_of_dep_vars_does_not_matter():
    model = zoo.fourbar()
    _, q2, q3, _, u2, u3 = model.states
    system = system_of(model, initial_conditions=near(model))
    system.set_dependent_initial_conditions(dep_vars=(u3, q3, u2, q2))
    close([system.initial_conditions[s] for s in system.states], model.x0, 1e-8)


def test_constants_are_honoured():
    model = zoo.track()
    k = sm.Symbol("k")
    system = system_of(model, constants={**model.constants, k: 1.6})
    system.set_dependent_initial_conditions()
    close(system.initial_conditions[system.states[2]], 2 * model.start[system.states[2]])


@pytest.mark.parametrize("use_jac", [False, True])
def test_specifieds_and_explicit_time_are_honoured(use_jac):
    model = zoo.lifted()
    x, y, vx, vy = model.states
    s = me.dynamicsymbols("s")
    system = system_of(
        model,
        specifieds={
            s: lambda x, t: np.cos(t),
            s.diff(zoo.T): lambda x, t: -np.sin(t),
            s.diff(zoo.T, 2): lambda x, t: -np.cos(t),
        },
        initial_conditions={x: 0.5, vx: 0.3},
        times=[1.25, 2.0],
    )
    system.set_dependent_initial_conditions(use_jac=use_jac)
    a, t = model.constants[sm.Symbol("slope")], 1.25
    close(system.initial_conditions[y], np.cos(t) + a * 0.5 * np.sin(t), 1e-9)
    rate = -np.sin(t) + a * 0.3 * np.sin(t) + a * 0.5 * np.cos(t)
    close(system.initial_conditions[vy], rate, 1e-9)


@pytest.mark.parametrize("method", ["hybr", "lm", "df-sane"])
def test_the_method_of_root_passes_through(method):
    model = zoo.fourbar()
    system = system_of(model, initial_conditions=near(model))
    system.set_dependent_initial_conditions(method=method, tol=1e-12)
    close(residuals(system), np.zeros(4), 1e-9)


def test_an_unknown_method_is_the_error_of_root():
    model = zoo.fourbar()
    system = system_of(model, initial_conditions=near(model))
    with pytest.raises(ValueError, match="nope"):
        system.set_dependent_initial_conditions(method="nope")


def test_the_options_of_root_pass_through():
    model = zoo.fourbar()
    system = system_of(model, initial_conditions=near(model))
    with pytest.warns(PyDyUserWarning, match="residual"):
        system.set_dependent_initial_conditions(options={"maxfev": 1})


def test_a_keyword_unknown_to_root_is_refused():
    model = zoo.fourbar()
    system = system_of(model, initial_conditions=near(model))
    with pytest.raises(TypeError, match="wrong_word"):
        system.set_dependent_initial_conditions(wrong_word=1)


@pytest.mark.parametrize("use_jac", [False, True])
def test_no_convergence_warns_with_the_residual_and_still_writes(use_jac):
    model = zoo.fourbar()
    system = system_of(model, constants={**model.constants, sm.Symbol("ln"): 50.0})
    before = system.initial_conditions[model.states[1]]
    with pytest.warns(PyDyUserWarning, match="residual"):
        system.set_dependent_initial_conditions(use_jac=use_jac)
    assert system.initial_conditions[model.states[1]] != before


def test_an_unconstrained_system_is_a_value_error():
    with pytest.raises(ValueError, match="constrain"):
        system_of(zoo.chain()).set_dependent_initial_conditions()


@pytest.mark.parametrize(
    ("name", "count"), [("fourbar", 3), ("fourbar", 5), ("disc", 1), ("gyro", 2)]
)
def test_a_wrong_number_of_dep_vars_is_a_value_error(name, count):
    model = zoo.MODELS[name]()
    with pytest.raises(ValueError, match="dep_vars"):
        system_of(model).set_dependent_initial_conditions(dep_vars=model.states[-count:])


def test_a_wrong_split_of_dep_vars_is_a_value_error():
    model = zoo.fourbar()
    with pytest.raises(ValueError, match=r"coordinate|speed"):
        system_of(model).set_dependent_initial_conditions(dep_vars=model.states[:4])


def test_a_dep_var_given_twice_is_named():
    model = zoo.fourbar()
    _, q2, _, _, u2, u3 = model.states
    with pytest.raises(ValueError, match=r"q2\(t\)"):
        system_of(model).set_dependent_initial_conditions(dep_vars=[q2, q2, u2, u3])


def test_the_function_generated_before_still_serves():
    model = zoo.fourbar()
    system = system_of(model, initial_conditions=near(model), times=[0.0, 0.1])
    system.generate_ode_function(generator="lambdify")
    system.set_dependent_initial_conditions()
    close(system.integrate()[0], model.x0, 1e-8)


def test_velocity_constraints_of_any_size_are_solved():
    """With the second row as a pivot, the first speed would be a rounding error of the others."""
    q, u = me.dynamicsymbols("q1:5"), me.dynamicsymbols("u1:5")
    small, N, O = sm.Symbol("small"), me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    bodies = [
        me.Particle(f"P{k}", O.locatenew(f"P{k}", place * N.x), sm.Integer(1))
        for k, place in enumerate(q)
    ]
    rows = [small * u[0] - u[2], 3 * u[0] + u[1] - u[3]]
    four = Definition(N, q, u, bodies=bodies, nonholonomic_constraints=rows, dependent_speeds=u[:2])
    system = System(four, {small: 1e-10}, initial_conditions={u[2]: 1e-30, u[3]: 0.7})
    system.set_dependent_initial_conditions()
    assert system.initial_conditions[u[0]] == pytest.approx(1e-20, rel=1e-12, abs=0.0)
    assert system.initial_conditions[u[1]] == pytest.approx(0.7, rel=1e-12)


def test_the_rounding_of_terms_that_cancel_is_no_failure():
    # Rolling straight ahead, the terms of the wheels' sideways slip cancel to 3e-17.
    bicycle = whipple_bicycle.derive()
    system = System(bicycle.definition, constants=whipple_bicycle.benchmark_parameters(bicycle))
    start = whipple_bicycle.equilibrium(bicycle, 4.0)
    system.initial_conditions = {**start, bicycle["u_phi"]: 0.02}
    system.set_dependent_initial_conditions()  # warnings are errors here
    assert np.abs(system.evaluate_velocity_constraints()).max() < 1e-15


@pytest.mark.parametrize("known", [("q1", "u1"), ("q2", "u2"), ("q1", "u2")])
def test_what_was_given_is_kept_where_nobody_chose_the_dependent_states(known):
    system = System(loops.engine(crank=0.25, rod=1.0))
    system.initial_conditions = dict(zip(known, (0.1, 2.0), strict=True))
    system.set_dependent_initial_conditions()
    for value in (0.1, 0.12):  # what was solved for is not what was given
        system.initial_conditions = {**system.initial_conditions, known[0]: value}
        system.set_dependent_initial_conditions()
        found = {name_of(s): v for s, v in system.initial_conditions.items()}
        assert [found[name] for name in known] == [value, 2.0]
        assert abs(np.sin(found["q1"]) / 4 - np.sin(found["q2"])) < 1e-12
        slopes = np.cos(found["q1"]) * found["u1"] / 4 - np.cos(found["q2"]) * found["u2"]
        assert abs(slopes) < 1e-12
    system.initial_conditions = dict.fromkeys(["q1", "q2", "u1", "u2"], 0.1)
    system.set_dependent_initial_conditions()  # all given: those that the System chose
    close(residuals(system), np.zeros(2), 1e-12)


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_a_speed_that_the_user_gave_is_kept(unit):
    """The bicycle's forward speed depends on the rear wheel's; a user gives the former."""
    model = whipple_bicycle.derive()
    constants = whipple_bicycle.benchmark_parameters(model)
    for s in constants:
        if s.name in ("w", "c", "g") or s.name[:2] in ("r_", "x_", "z_"):
            constants[s] *= unit
    system = System(model.definition, constants, initial_conditions={"u_x": 5.0 * unit})
    system.set_dependent_initial_conditions()
    found = {name_of(s): v for s, v in system.initial_conditions.items()}
    assert found["u_x"] == 5.0 * unit
    close(found["omega_R"], -5.0 / 0.3, 1e-12)  # rolling, with the radii of the benchmark
    close(found["omega_F"], -5.0 / 0.35, 1e-12)
    system.initial_conditions = {"u_x": 5.0 * unit, "omega_R": -10.0}
    message = f"`u_x(t)` is {3.0 * unit:.6g} in place of {5.0 * unit:.6g}. "
    with pytest.warns(PyDyUserWarning, match=re.escape(message)) as told:
        system.set_dependent_initial_conditions()
    assert len(told) == 1
    # Whoever says what is to change is not told of it.
    system.initial_conditions = {"u_x": 5.0 * unit, "omega_R": -10.0}
    dependent = [model["theta"], *model.definition.dependent_speeds]
    system.set_dependent_initial_conditions(dep_vars=dependent)


@pytest.mark.parametrize(
    "how",
    [{}, {"use_jac": True}, {"jac": lambda z: [[2.0 * z[0], 2.0 * z[1]], [0.0, 1.0]]}],
    ids=["differences", "exact", "own"],
)
@pytest.mark.parametrize("metre", [1.0, 1e-3, 1e-6, 1e-9, 1e9])
def test_an_area_and_a_length_are_solved_in_any_unit(metre, how):
    """A bead on a sphere and a plane: in nanometres the sphere was missed by a thousandth."""
    N, O = inertial_frame()
    R, l = sm.symbols("R l")
    x, y, z, ux, uy, uz = me.dynamicsymbols("x y z ux uy uz")
    bead = me.Particle("p", O.locatenew("P", x * N.x + y * N.y + z * N.z), sm.Integer(1))
    system = System(
        Definition(
            N,
            [x, y, z],
            [ux, uy, uz],
            bodies=[bead],
            holonomic_constraints=[x**2 + y**2 + z**2 - l**2, z - x - R],
        ),
        {l: metre, R: 0.3 * metre},
        initial_conditions={x: 0.3 * metre, y: 0.5 * metre, z: 0.5 * metre, ux: metre},
    )
    system.set_dependent_initial_conditions([y, z, uy, uz], **how)
    found = [system.initial_conditions[s] / metre for s in (y, z, uy, uz)]
    root = np.sqrt(0.55)
    np.testing.assert_allclose(found, [root, 0.6, -0.9 / root, 1.0], rtol=1e-14)


@pytest.mark.parametrize("metre", [1e-18, 1.0, 1e9, 1e13])
def test_searches_begin_at_zero_in_any_unit(metre):
    """SciPy steps by 1e-8 from zero: beside 1e9 metres this was rounding."""
    x, y, angle = me.dynamicsymbols("x y theta")
    m, a, b = sm.symbols("m a b")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    point.set_vel(frame, x.diff() * frame.x + y.diff() * frame.y)
    made = Definition(
        frame, [angle, x, y], bodies=[me.Particle("b", point, m)], dependent_coordinates=[x, y],
        holonomic_constraints=[x - a * sm.sin(angle), y + y**3 / b**2 - a * sm.cos(angle)],
    )  # fmt: skip
    system = System(made, constants={m: 1.0, a: 0.6 * metre, b: 0.5 * metre})
    system.initial_conditions = {angle: 0.7}
    system.set_dependent_initial_conditions()
    height = np.roots([4.0, 0.0, 1.0, -0.6 * np.cos(0.7)])
    found = [system.initial_conditions[s] / metre for s in (x, y)]
    assert found == pytest.approx([0.6 * np.sin(0.7), height[height.imag == 0.0].real[0]], rel=1e-9)


@pytest.mark.parametrize("use_jac", [False, True])
@pytest.mark.parametrize("metre", [1e-9, 1.0, 1e9])
def test_a_linkage_that_is_closed_from_bars_in_line_has_angles_near_the_guess(metre, use_jac):
    """Steps from there are long: the bars turned 16 and 35 times before they closed."""
    q = me.dynamicsymbols("q1:4")
    frame, origin = inertial_frame()
    bodies, end, bar = [], origin, frame
    for k, length in enumerate((1.0, 3.0, 2.5)):
        bar = bar.orientnew(f"A{k}", "Axis", (q[k], frame.z))
        end = end.locatenew(f"P{k}", length * metre * bar.x)
        bodies.append(me.Particle(f"b{k}", end, sm.Integer(1)))
    gap = end.pos_from(origin) - 3.0 * metre * frame.x
    made = Definition(
        frame, q, bodies=bodies, dependent_coordinates=q[1:],
        holonomic_constraints=[gap.dot(frame.x), gap.dot(frame.y)],
    )  # fmt: skip
    system = System(made, initial_conditions={q[0]: 0.5})
    system.set_dependent_initial_conditions(use_jac=use_jac)
    angles = np.cumsum([system.initial_conditions[s] for s in q])
    assert np.abs(np.diff(angles)).max() <= np.pi
    closed = np.exp(1j * angles) @ [1.0, 3.0, 2.5]
    assert closed == pytest.approx(3.0, rel=1e-14)


def test_revolutions_of_a_gear_remain():
    a, b, x = me.dynamicsymbols("a b x")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + sm.Symbol("r") * (sm.cos(a) + b) * frame.y)
    made = Definition(
        frame, [a, b, x], bodies=[me.Particle("p", point, sm.Symbol("m"))],
        holonomic_constraints=[b - 3 * a, x - 2 * b], dependent_coordinates=[b, x],
    )  # fmt: skip
    system = System(made, initial_conditions={a: 5.0})
    system.set_dependent_initial_conditions()
    assert system.initial_conditions[b] == pytest.approx(15.0, rel=1e-15)
    assert system.initial_conditions[x] == pytest.approx(30.0, rel=1e-15)


def test_constraints_whose_derivatives_are_not_finite_are_named():
    x, y = me.dynamicsymbols("x y")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    point.set_vel(frame, x.diff() * frame.x + y.diff() * frame.y)
    made = Definition(
        frame, [x, y], bodies=[me.Particle("b", point, sm.Symbol("m"))],
        nonholonomic_constraints=[x.diff() - y.diff() / x], dependent_speeds=[y.diff()],
    )  # fmt: skip
    system = System(made, initial_conditions={x.diff(): 1.0})
    with pytest.raises(SingularMatrixError, match="cannot be solved for Derivative"):
        system.set_dependent_initial_conditions()


def test_which_states_can_be_solved_for_takes_no_derivatives_of_accelerations():
    # Those of a quadruped from a file took most of the twelve seconds to a rotation of unit size.
    model = zoo.MODELS["fourbar"]()
    start = {**near(model), model.kane._udep[0]: 0.2}  # a dependent one is given, others are not
    for speed in {*model.kane.u} - {model.kane._udep[0]}:
        start.pop(speed, None)
    system = system_of(model, initial_conditions=start)
    system.set_dependent_initial_conditions()
    derivatives = {key[0] for key in system.model._kernels if key[1:2] == ("by",)}
    assert "velocity" in derivatives
    assert "rates" not in derivatives


@pytest.mark.parametrize("metre", [1.0, 1e3, 1e-9])
@pytest.mark.parametrize("use_jac", [False, True])
@pytest.mark.parametrize("guess", [0.0, 0.1])
def test_a_crank_that_is_driven_from_zero_is_there(metre, use_jac, guess):
    frame, origin = inertial_frame()
    angles, lengths = me.dynamicsymbols("a b c"), np.array([0.3, 0.8, 0.6]) * metre
    omega, ends, bodies = sm.Symbol("omega"), [], []
    for k, (angle, length) in enumerate(zip(angles, lengths.tolist(), strict=True)):
        bar = me.ReferenceFrame(f"bar{k}")
        bar.orient_axis(frame, frame.z, sum(angles[: k + 1]) if k < 2 else angle)
        start = (origin, *ends)[k] if k < 2 else origin.locatenew("D", 0.9 * metre * frame.x)
        ends.append(start.locatenew(f"P{k}", length * bar.x))
        bodies.append(me.Particle(f"end {k}", ends[-1], 1))
    gap = ends[1].pos_from(ends[2])
    constraints = [gap.dot(frame.x), gap.dot(frame.y), angles[0] - omega * me.dynamicsymbols._t]
    linkage = Definition(frame, angles, bodies=bodies, holonomic_constraints=constraints)
    system = System(linkage, {omega: 6.0}, times=[0.0, 1.0])
    system.initial_conditions = dict(zip(angles, (guess, 1.0, 1.5), strict=True))
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "The constraints do not allow", PyDyUserWarning)
        system.set_dependent_initial_conditions(use_jac=use_jac)
    a, b, c = (system.initial_conditions[angle] for angle in angles)
    # Triangle of the ground less the crank (0.6), the coupler and the rocker: the law of cosines.
    close([a, b, c], [0.0, np.arccos(2 / 3), 2 * np.arccos(2 / 3)], 1e-12)
    assert a == 0.0
