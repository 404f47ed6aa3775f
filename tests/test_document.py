"""The examples of the document that is this package's contract, to the digits it prints."""

import inspect
import pydoc

import numpy as np
import pytest
import sympy as sm
from scipy.integrate import odeint, solve_ivp
from sympy.physics.mechanics.models import n_link_pendulum_on_cart

import pydy.models
from pages import ROOT
from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.system import System

TIMES = np.linspace(0.0, 5.0, num=3)

HELP = """\
Help on function rhs in module pydy.codegen.ode_function_generators:

rhs(*args)
    Returns the derivatives of the states, i.e. numerically evaluates the right
    hand side of the first order differential equation.

    x' = f(x, t, r, p)

    Parameters
    ==========
    x : ndarray, shape(4,)
        The state vector is ordered as such:
            - q0(t)
            - q1(t)
            - u0(t)
            - u1(t)
    t : float
        The current time.
    r : dictionary; ndarray, shape(1,); function

        There are three options for this argument. (1) is more flexible but
        (2) and (3) are much more efficient.

        (1) A dictionary that maps the specified functions of time to floats,
        ndarrays, or functions that produce ndarrays. The keys can be a single
        specified symbolic function of time or a tuple of symbols. The total
        number of symbols must be equal to 1. If the value is a
        function it must be of the form g(x, t), where x is the current state
        vector ndarray and t is the current time float and it must return an
        ndarray of the correct shape. For example::

          r = {a: 1.0,
               (d, b) : np.array([1.0, 2.0]),
               (e, f) : lambda x, t: np.array(x[0], x[1]),
               c: lambda x, t: np.array(x[2])}

        (2) A ndarray with the specified values in the correct order and of the
        correct shape.

        (3) A function that must be of the form g(x, t), where x is the current
        state vector and t is the current time and it must return an ndarray of
        the correct shape.

        The specified inputs are, in order:
            - F(t)
    p : dictionary len(4) or ndarray shape(4,)
        Either a dictionary that maps the constants symbols to their numerical
        values or an array with the constants in the following order:
            - g
            - l0
            - m0
            - m1

    Returns
    =======
    dx : ndarray, shape(4,)
        The derivative of the state vector.
    y : ndarray, shape(1,)
        Values of the provided outputs.
            - y0(t)
"""


def help_text(function):
    """What help() prints, without the bold letters of a terminal."""
    text = pydoc.plain(pydoc.render_doc(function, title="Help on %s:"))
    return [line.rstrip() for line in text.rstrip().splitlines()]


def printed(actual, desired, unit=1e-8):
    """Equal to the printed digits, the last of which is worth `unit`."""
    np.testing.assert_allclose(actual, desired, rtol=0, atol=0.51 * unit)


@pytest.fixture(scope="module")
def kane():
    return n_link_pendulum_on_cart()


def with_outputs(kane):
    m0 = sm.Symbol("m0")
    return System(
        kane,
        initial_conditions={kane.q[1]: 0.5},
        times=TIMES,
        outputs={sm.Symbol("k0"): m0 * kane.u[0] ** 2 / 2},
    )


def test_the_simplest_usage_integrates_the_defaults_to_zeros(kane):
    sys = System(kane, times=TIMES)
    assert repr(sys.integrate()) == (
        "array([[0., 0., 0., 0.],\n       [0., 0., 0., 0.],\n       [0., 0., 0., 0.]])"
    )


def test_constants_and_initial_conditions_give_the_printed_trajectory(kane):
    sys = System(kane, initial_conditions={kane.q[1]: 0.5}, times=TIMES)
    _, _, _, m1 = list(sm.ordered(sys.constants_symbols))
    sys.constants = {m1: 5.0}
    expected = [
        [0.0, 0.5, 0.0, 0.0],
        [-1.12276473, 4.19253522, -0.77003647, 1.86016638],
        [-1.00443253, 5.47085374, -0.4536987, -0.7915558],
    ]
    printed(sys.integrate(), expected)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("coordinates", "[q0(t), q1(t)]"),
        ("speeds", "[u0(t), u1(t)]"),
        ("states", "[q0(t), q1(t), u0(t), u1(t)]"),
        ("constants_symbols", "{g, l0, m0, m1}"),
        ("specifieds_symbols", "{F(t)}"),
        ("times", "array([0. , 2.5, 5. ])"),
    ],
)
def test_a_property_prints_as_in_the_document(kane, name, text):
    assert repr(getattr(System(kane, times=TIMES), name)) == text


def test_outputs_give_the_printed_values_along_the_trajectory(kane):
    sys = with_outputs(kane)
    x = sys.integrate()
    assert repr(sys.outputs_symbols) == "[k0]"
    y = sys.evaluate_outputs(x=x)
    assert y.shape == (3, 1)
    printed(y[:2, 0], [0.0, 0.892619991], unit=1e-9)
    printed(y[2, 0], 7.01894807e-04, unit=1e-12)


@pytest.fixture(scope="module")
def cython(kane):
    """The document's system after `generate_ode_function(generator='cython')`, and the function."""
    sys = with_outputs(kane)
    return sys, sys.generate_ode_function(generator="cython")


def test_generate_ode_function_returns_the_function_it_sets(cython):
    sys, rhs = cython
    assert (sys.evaluate_ode_function == rhs) is True


def test_the_cython_generator_gives_the_printed_trajectory(cython):
    expected = [
        [0.0, 0.5, 0.0, 0.0],
        [-0.31425675, 3.29123866, -1.33612873, 2.70246056],
        [-0.48148282, 5.77849021, -0.03746718, -0.08560791],
    ]
    printed(cython[0].integrate(), expected)


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
def test_help_of_the_generated_function_reads_as_in_the_document(kane, generator):
    sys = with_outputs(kane)
    sys.generate_ode_function(generator=generator)
    assert help_text(sys.evaluate_ode_function) == HELP.rstrip().splitlines()


def test_help_of_the_cython_function_reads_as_in_the_document(cython):
    assert help_text(cython[0].evaluate_ode_function) == HELP.rstrip().splitlines()


def test_help_of_a_function_without_outputs_and_specifieds_leaves_them_out():
    sys = pydy.models.multi_mass_spring_damper()
    text = "\n".join(help_text(sys.generate_ode_function()))
    assert "x' = f(x, t, p)" in text
    assert "dx : ndarray, shape(2,)" in text
    assert "    r : " not in text
    assert "    y : " not in text


def solve_ivp_solver(f, x0, ts, args=(), **kwargs):
    """The document's custom solver."""
    return solve_ivp(lambda t, x: f(x, t, *args), ts[[0, -1]], x0, t_eval=ts, **kwargs).y.T


@pytest.fixture
def oscillator():
    sys = pydy.models.multi_mass_spring_damper()
    sys.initial_conditions[sys.coordinates[0]] = 1.0
    sys.times = [1.0, 2.0, 3.0]
    sys.ode_solver = solve_ivp_solver
    return sys


def test_solve_ivp_with_lsoda_gives_the_printed_numbers(oscillator):
    expected = [[1.0, 0.0], [0.659700039, -0.533506568], [0.150574778, -0.41927993]]
    printed(oscillator.integrate(method="LSODA", rtol=1e-10), expected, unit=1e-9)


def test_solve_ivp_with_rk23_gives_the_numbers_of_fresh_arrays(oscillator):
    # API.md: the document's own last digits came from stages that were overwritten.
    expected = [[1.0, 0.0], [0.65970127, -0.53350689], [0.15057662, -0.41928102]]
    x = oscillator.integrate(method="RK23", rtol=1e-12)
    printed(x, expected)
    np.testing.assert_allclose(
        x[1:], [[0.65970115, -0.53350624], [0.15057689, -0.41928088]], rtol=0, atol=1e-6
    )


def parameters(function):
    return list(inspect.signature(function).parameters)


def test_the_constructor_takes_its_arguments_in_the_documented_order():
    assert parameters(System)[:10] == [
        "eom_method",
        "constants",
        "specifieds",
        "ode_solver",
        "initial_conditions",
        "times",
        "outputs",
        "noncontributing_forces",
        "constants_symbols",
        "specifieds_symbols",
    ]
    rest = list(inspect.signature(System).parameters.values())[1:10]
    assert all(p.default is None for p in rest)


@pytest.mark.parametrize(
    "name",
    [
        "evaluate_ode",
        "evaluate_outputs",
        "evaluate_constraints",
        "evaluate_holonomic_constraints",
        "evaluate_velocity_constraints",
    ],
)
def test_the_evaluate_methods_take_x_then_t_and_the_extras_by_keyword_only(name):
    got = inspect.signature(getattr(System, name)).parameters
    assert list(got)[:3] == ["self", "x", "t"]
    assert got["x"].default is None
    assert got["t"].default is None
    assert got["r"].kind is inspect.Parameter.KEYWORD_ONLY
    assert got["p"].kind is inspect.Parameter.KEYWORD_ONLY


def test_set_dependent_initial_conditions_has_the_documented_signature():
    got = inspect.signature(System.set_dependent_initial_conditions)
    assert list(got.parameters)[:3] == ["self", "dep_vars", "use_jac"]
    assert got.parameters["dep_vars"].default is None
    assert got.parameters["use_jac"].default is False


def test_generate_ode_function_takes_its_arguments_in_the_documented_order():
    assert parameters(generate_ode_function)[:13] == [
        "right_hand_side",
        "coordinates",
        "speeds",
        "constants",
        "mass_matrix",
        "coordinate_derivatives",
        "specifieds",
        "outputs",
        "linear_sys_solver",
        "constants_arg_type",
        "specifieds_arg_type",
        "time_first",
        "generator",
    ]


@pytest.mark.parametrize(
    ("name", "arguments"),
    [
        (
            "multi_mass_spring_damper",
            ["n", "apply_gravity", "apply_external_forces", "external_force_as_sin_of_t"],
        ),
        ("n_link_pendulum_on_cart", ["n", "cart_force", "joint_torques"]),
    ],
)
def test_a_model_takes_its_arguments_in_the_documented_order(name, arguments):
    assert parameters(getattr(pydy.models, name)) == arguments


def test_the_defaults_are_those_of_the_document(kane):
    sys = System(kane)
    assert sys.constants == {}
    assert sys.ode_solver is odeint
    assert sys.times.shape == (0,)
    assert sys.evaluate_ode_function is None


DOCUMENTED = [
    "auxiliaries",
    "constants",
    "constants_symbols",
    "constraints",
    "coordinates",
    "eom_method",
    "evaluate_constraints",
    "evaluate_holonomic_constraints",
    "evaluate_ode",
    "evaluate_ode_function",
    "evaluate_outputs",
    "evaluate_velocity_constraints",
    "generate_ode_function",
    "initial_conditions",
    "integrate",
    "noncontributing_forces",
    "num_auxiliaries",
    "num_constants",
    "num_constraints",
    "num_coordinates",
    "num_holonomic_constraints",
    "num_nonholonomic_constraints",
    "num_outputs",
    "num_specifieds",
    "num_speeds",
    "num_states",
    "num_velocity_constraints",
    "ode_solver",
    "outputs",
    "outputs_symbols",
    "set_dependent_initial_conditions",
    "specifieds",
    "specifieds_symbols",
    "speeds",
    "states",
    "times",
]


@pytest.mark.parametrize("name", DOCUMENTED)
def test_every_documented_name_exists_and_says_what_it_is(name):
    assert getattr(System, name).__doc__.strip()


@pytest.mark.parametrize(
    "name",
    [
        *("CythonODEFunctionGenerator", "LambdifyODEFunctionGenerator", "ODEFunctionGenerator"),
        *("TheanoODEFunctionGenerator", "pydy.codegen.c_code", ".cython_code", ".octave_code"),
        *(".matrix_generator", "pydy.utils", "pydy.viz.server", "Scene.create_static_html"),
    ],
)
def test_what_has_no_counterpart_is_told(name):
    text = (ROOT / "docs" / "howto" / "from-0.9.md").read_text(encoding="utf-8")
    table = text.split("## Without a counterpart")[1].split("\n## ")[0]
    assert f"`{name}`" in table
