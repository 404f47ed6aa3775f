"""Constraints: which there are, in which order, and what they are worth at a state."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from oracles.oracle import oracle
from pydy.system import System
from zoo.cases import close, system_of, wide

CONSTRAINED = ["disc", "disc_contact", "sleigh", "skate", "fourbar", "track", "track_reversed"]
CONSTRAINED += ["gyro", "lifted"]
HOLONOMIC = ["fourbar", "track", "track_reversed", "gyro", "lifted"]
MOVING = [n for n in CONSTRAINED if n != "gyro"]

# Which of the velocity rows are genuinely nonholonomic.
GENUINE = {"disc": [0, 1], "disc_contact": [0, 1], "sleigh": [0], "skate": [0], "fourbar": []}
GENUINE |= {"track": [1], "track_reversed": [0], "gyro": [], "lifted": []}


def expected(name, x, t, numbers=None):
    """Holonomic residuals, then the genuinely nonholonomic ones."""
    model = zoo.MODELS[name]()
    values = [oracle(model).holonomic(x, t, numbers)]
    if GENUINE[name]:
        values.append(oracle(model).velocity(x, t, numbers)[GENUINE[name]])
    return np.concatenate(values)


def test_an_unconstrained_system_has_an_empty_matrix():
    constraints = System(zoo.chain().kane).constraints
    assert isinstance(constraints, sm.MatrixBase)
    assert len(constraints) == 0


@pytest.mark.parametrize("name", CONSTRAINED)
def test_the_constraints_are_a_column_of_holonomic_then_nonholonomic(name):
    model = zoo.MODELS[name]()
    system = system_of(model)
    x, t = model.sample(4)
    assert isinstance(system.constraints, sm.MatrixBase)
    assert system.constraints.shape == (system.num_constraints, 1)
    close(oracle(model).evaluate(list(system.constraints), x, t), expected(name, x, t))


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
@pytest.mark.parametrize("name", CONSTRAINED)
def test_evaluate_constraints_agrees_with_sympy(name, generator):
    model = zoo.MODELS[name]()
    system = system_of(model)
    system.generate_ode_function(generator=generator)
    x, t = model.sample(4)
    close(system.evaluate_constraints(wide(system, x), t), expected(name, x, t))


@pytest.mark.parametrize("name", HOLONOMIC)
def test_evaluate_holonomic_constraints_agrees_with_sympy(name):
    model = zoo.MODELS[name]()
    x, t = model.sample(5)
    close(system_of(model).evaluate_holonomic_constraints(x, t), oracle(model).holonomic(x, t))


@pytest.mark.parametrize("name", MOVING)
def test_evaluate_velocity_constraints_gives_all_rows_of_the_method(name):
    model = zoo.MODELS[name]()
    x, t = model.sample(6)
    system = system_of(model)
    got = system.evaluate_velocity_constraints(wide(system, x), t)
    close(got, oracle(model).velocity(x, t))


@pytest.mark.parametrize(
    "method",
    ["evaluate_constraints", "evaluate_holonomic_constraints", "evaluate_velocity_constraints"],
)
def test_a_series_of_states_gives_the_same_rows(method):
    model = zoo.track()
    system = system_of(model)
    xs, ts = model.sample(7, 5)
    rows = [getattr(system, method)(x, t) for x, t in zip(xs, ts, strict=True)]
    close(getattr(system, method)(xs, ts), rows, 1e-13)


@pytest.mark.parametrize("name", CONSTRAINED)
def test_the_default_is_the_initial_condition(name):
    model = zoo.MODELS[name]()
    system = system_of(model, times=[0.7, 1.0])
    close(system.evaluate_constraints(), expected(name, model.x0, 0.7))


def test_constants_count_in_the_constraints():
    model = zoo.fourbar()
    x, t = model.sample(8)
    system = system_of(model)
    system.constants[sm.Symbol("ln")] = 5.0
    numbers = {sm.Symbol("ln"): 5.0}
    close(system.evaluate_constraints(x, t), expected("fourbar", x, t, numbers))


@pytest.mark.parametrize(
    ("name", "method"),
    [
        ("chain", "evaluate_constraints"),
        ("chain", "evaluate_holonomic_constraints"),
        ("chain", "evaluate_velocity_constraints"),
        ("sleigh", "evaluate_holonomic_constraints"),
        ("gyro", "evaluate_velocity_constraints"),
    ],
)
def test_asking_for_constraints_that_are_not_there_is_a_value_error(name, method):
    kind = method.split("_")[1]
    with pytest.raises(ValueError, match=kind if kind != "constraints" else "constraint"):
        getattr(system_of(zoo.MODELS[name]()), method)()


def test_a_system_with_both_moves_on_them():
    system = system_of(zoo.track(), times=np.linspace(0.0, 0.5, 5))
    x = system.integrate(rtol=1e-11, atol=1e-11)
    close(system.evaluate_constraints(x), np.zeros((5, 2)), 1e-8)


def rolling_disc(axes):
    """A disc whose centre has three coordinates: its contact does not slip and does not lift."""
    psi, lean, roll, x, y, z = me.dynamicsymbols("psi lean roll x y z")
    u = me.dynamicsymbols("u:6")
    m, r, g = sm.symbols("m r g")
    ground, turned, leaned, disc = (me.ReferenceFrame(f) for f in "NALD")
    turned.orient_axis(ground, ground.z, psi)
    leaned.orient_axis(turned, turned.x, lean)
    disc.orient_axis(leaned, leaned.y, roll)
    disc.set_ang_vel(ground, u[0] * leaned.x + u[1] * leaned.y + u[2] * leaned.z)
    origin = me.Point("O")
    origin.set_vel(ground, 0)
    centre = origin.locatenew("C", x * ground.x + y * ground.y + z * ground.z)
    centre.set_vel(ground, u[3] * ground.x + u[4] * ground.y + u[5] * ground.z)
    slip = centre.vel(ground) + disc.ang_vel_in(ground).cross(-r * leaned.z)
    axes = leaned if axes == "leaned" else ground
    inertia = me.inertia(leaned, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4)
    rates = leaned.ang_vel_in(ground) + roll.diff(zoo.T) * leaned.y - disc.ang_vel_in(ground)
    kane = me.KanesMethod(
        ground,
        [psi, lean, roll, x, y],
        u[:3],
        kd_eqs=[
            *(rates.dot(axis) for axis in leaned),
            *(s.diff(zoo.T) - v for s, v in zip((x, y, z), u[3:], strict=True)),
        ],
        q_dependent=[z],
        configuration_constraints=[z - r * sm.cos(lean)],
        u_dependent=u[3:],
        velocity_constraints=[slip.dot(axis) for axis in axes],
    )
    body = me.RigidBody("disc", centre, disc, m, (inertia, centre))
    kane.kanes_equations([body], [(centre, -m * g * ground.z)])
    return System(kane)


@pytest.mark.parametrize("axes", ["ground", "leaned"])
def test_a_disc_rolls_nonholonomically_in_two_ways_whatever_axes_resolve_its_contact(axes):
    system = rolling_disc(axes)
    assert system.num_holonomic_constraints == 1
    assert system.num_velocity_constraints == 3
    assert system.num_nonholonomic_constraints == 2
    assert system.num_constraints == 3


def test_rows_that_mix_both_kinds_of_constraint_count_once():
    mixed = zoo.track_with(lambda rate, blade: [rate + blade, rate - 2 * blade])
    system = System(mixed.kane)
    assert system.num_velocity_constraints == 2
    assert system.num_nonholonomic_constraints == 1
