"""A start that does not satisfy the constraints is told of."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.errors import IntegrationError, PyDyUserWarning
from pydy.examples import whipple_bicycle
from pydy.mechanics import Definition
from pydy.solvers.outcome import Outcome
from pydy.system import System
from registry import has_fixed_step
from zoo import inertial_frame
from zoo.cases import system_of

TIMES = np.linspace(0.0, 0.1, 3)


def off(name="fourbar", by=0.0, place=1, **options):
    model = zoo.MODELS[name]()
    system = system_of(model, times=TIMES, **options)
    system.initial_conditions[model.states[place]] += by
    return system


@pytest.mark.parametrize("solver", ["odeint", "dop853", "rk4"])
@pytest.mark.parametrize("method", ["integrate", "simulate"])
def test_a_start_off_the_constraints_warns_with_residual_row_and_remedy(method, solver):
    system = off(by=0.1, ode_solver=solver)
    residual = np.abs(system.evaluate_holonomic_constraints()).max()
    message = rf"do not satisfy .* {residual:.3g} in the holonomic constraint \d: .*q1.*set_depen"
    options = {"step": 0.01} if has_fixed_step(solver) else {}
    with pytest.warns(PyDyUserWarning, match=message) as told:
        getattr(system, method)(**options)
    assert told[0].filename == __file__


def test_it_warns_at_every_integration():
    system = off(by=0.1)
    for _ in range(2):
        with pytest.warns(PyDyUserWarning, match="do not satisfy the constraints"):
            system.integrate()


def test_the_remedy_is_one():
    system = off(by=0.1)
    system.set_dependent_initial_conditions()
    system.integrate()


@pytest.mark.parametrize("name", ["disc", "sleigh"])
def test_velocity_constraints_count(name):
    with pytest.warns(PyDyUserWarning, match=r"in the velocity constraint \d"):
        off(name, by=0.01, place=-1).integrate()


@pytest.mark.parametrize("name", ["disc", "sleigh", "fourbar", "track", "gyro"])
def test_states_typed_with_six_digits_are_good_enough(name):
    system = off(name)
    typed = {s: float(f"{v:.6g}") for s, v in system.initial_conditions.items()}
    system.initial_conditions = typed
    system.integrate()
    system.initial_conditions = {s: float(f"{v:.3g}") for s, v in typed.items()}
    with pytest.warns(PyDyUserWarning, match="do not satisfy"):
        system.integrate()


def test_the_unit_of_length_does_not_matter():
    # The same linkage in nanometres, where every residual is small.
    model = zoo.fourbar()
    system = off(by=0.1)
    lengths = [s for s in system.constants if s.name[0] in "lg"]
    for s in lengths:
        system.constants[s] *= 1e-9
    with pytest.warns(PyDyUserWarning, match="e-1[01] in the holonomic"):
        system.integrate()
    system.initial_conditions = dict(model.start)
    system.integrate()


@pytest.mark.parametrize("options", [{"constraints": "baumgarte", "gain": 5.0}])
def test_what_will_be_brought_back_is_not_told_of(options):
    off(by=0.1).integrate(**options)


def test_a_system_without_constraints_compiles_nothing_for_it():
    system = system_of(zoo.chain(), times=TIMES)
    system.integrate()
    assert list(system.model._kernels) == [("rates",)]


def test_the_residuals_alone_are_compiled_where_they_are_small():
    system = off()
    system.set_dependent_initial_conditions()
    before = set(system.model._kernels)
    system.integrate()
    residuals = {("rates",), ("holonomic",), ("velocity",)}
    assert set(system.model._kernels) <= residuals | before


@pytest.mark.parametrize("linear", ["numpy", "sympy"])
def test_a_solver_of_ones_own_for_the_accelerations_does_not_matter(linear):
    system = off(by=0.1)
    system.generate_ode_function(linear_sys_solver=linear)
    with pytest.warns(PyDyUserWarning, match="do not satisfy the constraints"):
        system.integrate()


def test_a_residual_that_is_no_number_is_told_of():
    system = off()
    system.constants[sm.Symbol("la")] = 1e300
    system.constants[sm.Symbol("lb")] = -1e300
    with pytest.warns(PyDyUserWarning, match="do not satisfy the constraints"), np.errstate():
        system.integrate(full_output=True)


def test_a_sample_of_an_ensemble_that_is_off_is_named():
    pytest.importorskip("xarray")
    system = off()
    q2 = system.coordinates[1]
    start = system.initial_conditions[q2]
    angles = {q2: [start, start + 1e-9, start + 0.1, start + 0.2]}
    with pytest.warns(PyDyUserWarning, match="initial conditions of sample 3 do not satisfy"):
        system.integrate_ensemble(initial_conditions=angles)
    angles = {q2: [start, start + 1e-9]}
    system.integrate_ensemble(initial_conditions=angles)
    with pytest.warns(PyDyUserWarning, match="of sample 1 do not satisfy .* those of each sample"):
        system.integrate_ensemble(constants={sm.Symbol("la"): [0.8, 0.9, 0.8]})
    many = np.full(300, start)
    many[101] += 0.1
    with pytest.warns(PyDyUserWarning, match="initial conditions of sample 101 do not satisfy"):
        system.integrate_ensemble(initial_conditions={q2: many})


@pytest.mark.parametrize("length", [1.0, 1e-3, 1e-6, 7e6])
@pytest.mark.parametrize("constraints", [None, "project"])
def test_a_start_far_off_is_told_in_any_units(length, constraints):
    """Of a pendulum of a micrometre that is let go a quarter beside its circle nothing was said."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    N, O, P = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    O.set_vel(N, 0)
    P.set_pos(O, x * N.x + y * N.y)
    P.set_vel(N, u * N.x + v * N.y)
    kane = me.KanesMethod(
        N, [x], [u], [x.diff() - u, y.diff() - v], q_dependent=[y], u_dependent=[v],
        configuration_constraints=[x**2 + y**2 - length**2], velocity_constraints=[x * u + y * v],
    )  # fmt: skip
    kane.kanes_equations([me.Particle("b", P, 1)], [(P, -9.81 * N.y)])
    system = System(kane, ode_solver="dop853", times=np.linspace(0.0, 1.0, 3) * length**0.5)
    system.initial_conditions = {x: 0.5 * length, y: -0.6 * length}
    options = {"atol": 1e-9 * length, "constraints": constraints}
    if constraints:
        with pytest.raises(IntegrationError, match=r"moved y\(t\) from"):
            system.simulate(**options)
    else:
        with pytest.warns(PyDyUserWarning, match="do not satisfy the constraints"):
            system.simulate(**options)


UNITS = [1e-9, 1e-4, 1.0, 1e5, 1e9]


def sledge(metre, second):
    """A sledge with a blade, and a second one that is driven by it; a metre and a second a step."""
    x, y, a, z, u, v, w, s = me.dynamicsymbols("x y a z u v w s")
    N, O, P, Q = me.ReferenceFrame("N"), *map(me.Point, "OPQ")
    O.set_vel(N, 0)
    P.set_pos(O, x * N.x + y * N.y)
    Q.set_pos(O, z * N.x)
    B = N.orientnew("B", "Axis", (a, N.z))
    bodies = [me.RigidBody("sledge", P, B, 1, (me.inertia(B, 1, 1, 1), P)), me.Particle("b", Q, 1)]
    rates = [x.diff() - u, y.diff() - v, a.diff() - w, z.diff() - s]
    rows = [-u * sm.sin(a) + v * sm.cos(a), s - 2 * v]
    made = Definition(
        N, [x, y, a, z], [u, v, w, s], bodies=bodies, kinematic_equations=rates,
        nonholonomic_constraints=rows,
    )  # fmt: skip
    system = System(made, ode_solver="dop853", times=[0.0, 0.1 * second])
    system.initial_conditions = {u: metre / second}
    return system, (a, v, s)


@pytest.mark.parametrize("metre", UNITS)
@pytest.mark.parametrize("second", UNITS)
@pytest.mark.parametrize("speed", [0.0, 1.0])
def test_what_rounding_leaves_of_a_start_is_not_told_of(metre, second, speed):
    system, (a, v, s) = sledge(metre, second)
    rate = metre / second
    system.initial_conditions |= {a: 1e-17, v: 3e-19 * rate, s: -2e-19 * rate}
    system.integrate(atol=1e-9 * rate)
    x, u = system.states[0], next(iter(system.initial_conditions))
    system.initial_conditions |= {x: metre, u: speed * rate}  # at rest no speed is larger
    system.integrate(atol=1e-9 * rate, constraints="project")


@pytest.mark.parametrize("metre", UNITS)
@pytest.mark.parametrize("second", UNITS)
def test_speeds_that_are_off_are_told_in_any_units(metre, second):
    system, (a, v, s) = sledge(metre, second)
    rate = metre / second
    system.initial_conditions |= {a: 0.3, v: rate * np.tan(0.3), s: 2.001 * rate * np.tan(0.3)}
    with pytest.warns(PyDyUserWarning, match="do not satisfy the constraints"):
        system.integrate(atol=1e-9 * rate)
    system.initial_conditions[s] *= 1.1
    with pytest.raises(IntegrationError, match=r"projection moved [svw]\(t\) from"):
        system.integrate(atol=1e-9 * rate, constraints="project")


@pytest.mark.parametrize("unit", [1.0, 1e9, 1e-9])
def test_a_bicycle_that_stands_upright_to_rounding_is_not_told_of(unit):
    model = whipple_bicycle.derive()
    constants = whipple_bicycle.benchmark_parameters(model)
    for s in constants:
        if s.name in ("w", "c", "g") or s.name[:2] in ("r_", "x_", "z_"):
            constants[s] *= unit
    system = System(model.definition, constants, times=[0.0, 1e-3])
    system.initial_conditions = {"theta": 5e-17}
    assert system.evaluate_holonomic_constraints()[0] != 0.0
    system.integrate()
    system.initial_conditions = {"theta": 1e-4}
    with pytest.warns(PyDyUserWarning, match="in the holonomic constraint 0"):
        system.integrate()


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("far", [0.0, 1e9])
def test_a_coordinate_of_another_row_does_not_hide_that_one_is_off(far, unit):
    x, y, z = me.dynamicsymbols("x y z")
    N, O = inertial_frame()
    place = O.locatenew("P", x * N.x + y * N.y + z * N.z)
    definition = Definition(
        N, [x, y, z], bodies=[me.Particle("P", place, 1)], holonomic_constraints=[x - 2 * y]
    )
    start = {x: 0.2 * unit, y: 0.1 * unit * (1 + 2e-16), z: far * unit}
    system = System(definition, initial_conditions=start, times=[0.0, 1.0])
    system.integrate()
    system.initial_conditions[y] = 0.11 * unit
    with pytest.warns(PyDyUserWarning, match="in the holonomic constraint 0"):
        system.integrate()


def test_of_many_rows_that_do_not_hold_two_are_shown():
    n = 40
    q, p = me.dynamicsymbols(f"q:{n}"), me.dynamicsymbols(f"p:{n}")
    N, O = inertial_frame()
    bodies = [
        me.Particle(f"P{k}", O.locatenew(f"P{k}", a * N.x + b * N.y), 1)
        for k, (a, b) in enumerate(zip(q, p, strict=True))
    ]
    rows = [a - b for a, b in zip(q, p, strict=True)]
    definition = Definition(N, [*q, *p], bodies=bodies, holonomic_constraints=rows)
    system = System(definition, initial_conditions=dict.fromkeys(q, 1.0), times=[0.0, 1.0])
    with pytest.warns(PyDyUserWarning, match="and 38 more") as told:
        system.integrate()
    assert len(told) == 1
    assert str(told[0].message).count("in the holonomic constraint") == 2


@pytest.mark.parametrize("kind", ["holonomic_constraints", "velocity_constraints"])
def test_a_constraint_of_constants_alone_is_refused_unless_it_is_zero(kind):
    q, u = me.dynamicsymbols("q u")
    m, k = sm.symbols("m k")
    N, P = me.ReferenceFrame("N"), me.Point("P")
    P.set_vel(N, u * N.x)
    bodies = [me.Particle("p", P, m)]
    system = System(
        Definition(N, [q], [u], bodies=bodies, loads=[(P, -k * q * N.x)], **{kind: [m - k]})
    )
    system.ode_solver, system.times = "dop853", TIMES
    system.integrate()
    system.constants = {m: 1.0, k: 4.0}
    with pytest.raises(ValueError, match=r"No motion satisfies the .*-k \+ m.* alone: it is -3"):
        system.integrate()


def test_a_constraint_of_constants_alone_of_a_called_method_is_refused():
    q, p, u, v = me.dynamicsymbols("q p u v")
    m, k = sm.symbols("m k")
    N, O, P = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    P.set_pos(O, q * N.x + p * N.y)
    P.set_vel(N, u * N.x + v * N.y)
    kane = me.KanesMethod(
        N,
        [q],
        [u],
        [q.diff() - u, p.diff() - v],
        q_dependent=[p],
        configuration_constraints=[m - k],
        velocity_constraints=[u - v],
        u_dependent=[v],
    )
    kane.kanes_equations([me.Particle("p", P, m)], [(P, -k * q * N.x)])
    system = System(kane, {m: 1.0, k: 4.0}, times=TIMES)
    with pytest.raises(
        ValueError, match=r"No motion satisfies the holonomic constraint 0: -k \+ m"
    ):
        system.integrate()


def on_a_line(configuration, velocity, w=1.0):
    """A particle in a plane whose constraints are given as rows of x, y, and of u, v."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    point.set_vel(frame, u * frame.x + v * frame.y)
    method = me.KanesMethod(
        frame, [x], [u], [x.diff() - u, y.diff() - v], q_dependent=[y], u_dependent=[v],
        configuration_constraints=[configuration(x, y)], velocity_constraints=[velocity(u, v)],
    )  # fmt: skip
    method.kanes_equations([me.Particle("P", point, 2)], [(point, -x * frame.x)])
    system = System(method, {"w": w} if velocity(u, v).has(sm.Symbol("w")) else {})
    system.initial_conditions, system.ode_solver = {"x": 0.2}, "tsit5"
    system.times = np.linspace(0.0, 1.0, 11)
    system.set_dependent_initial_conditions()
    return system


def moving_line(x, y):
    return x + y - 1 - me.dynamicsymbols._t


@pytest.mark.parametrize("options", [{}, {"constraints": "project"}])
@pytest.mark.parametrize(
    "velocity", [lambda u, v: u + v - 2, lambda u, v: u + v, lambda u, v: u - v]
)
def test_velocity_constraints_that_contradict_a_holonomic_one_are_refused(velocity, options):
    with pytest.raises(ValueError, match=r"rate of the holonomic constraint 0: .* is -?1\."):
        on_a_line(moving_line, velocity).integrate(**options)


def test_a_motion_that_is_held_by_contradicting_rows_is_refused():
    system = on_a_line(lambda x, y: x + y - 1, lambda u, v: u - 2 * v)
    with pytest.raises(IntegrationError, match="cannot keep all constraints") as caught:
        system.integrate(constraints="project")
    assert caught.value.info["code"] == Outcome.LEFT_CONSTRAINTS
    assert caught.value.time > 0.0


def test_samples_that_are_held_by_contradicting_rows_are_lost():
    system = on_a_line(lambda x, y: x + y - 1, lambda u, v: u - 2 * v)
    start = {"x": [0.2, 0.0], "y": [0.8, 1.0]}  # without a force the second is at rest
    results = system.integrate_ensemble(initial_conditions=start, constraints="project")
    assert results.status.values.tolist() == [Outcome.LEFT_CONSTRAINTS, 0]
    assert np.isnan(results.x[0, -1])
    assert np.isfinite(results.x[1]).all()


@pytest.mark.parametrize("options", [{}, {"constraints": "project"}])
@pytest.mark.parametrize("unit", [1e-12, 1.0, 1e12])
def test_velocity_constraints_that_imply_a_holonomic_one_by_numbers_are_right(unit, options):
    w = sm.Symbol("w")
    on_a_line(moving_line, lambda u, v: unit * (u + v - w)).integrate(**options)
    on_a_line(moving_line, lambda u, v: unit * (u + v - 1)).integrate(**options)
    with pytest.raises(ValueError, match=r" is 0\.001\."):
        on_a_line(moving_line, lambda u, v: unit * (u + v - w), w=1.001).integrate(**options)
