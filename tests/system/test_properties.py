"""What a System says about its equations, and what its properties accept."""

import copy
from collections.abc import Set

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.system import System
from zoo.cases import close, system_of

T = zoo.T


@pytest.mark.parametrize("name", zoo.MODELS)
def test_the_states_are_lists_in_the_order_of_the_method(name):
    model = zoo.MODELS[name]()
    system = system_of(model, noncontributing_forces=None)
    assert system.coordinates == list(model.kane.q)
    assert system.speeds == list(model.kane.u)
    assert system.states == [*model.kane.q, *model.kane.u]


@pytest.mark.parametrize("name", zoo.MODELS)
def test_the_constants_and_specifieds_are_found(name):
    model = zoo.MODELS[name]()
    system = System(model.kane)
    assert system.constants_symbols == set(model.constants)
    assert system.specifieds_symbols == set(model.specifieds)
    assert system.num_constants == len(model.constants)
    assert system.num_specifieds == len(model.specifieds)


@pytest.mark.parametrize("name", zoo.MODELS)
def test_constants_and_specifieds_iterate_sorted(name):
    system = System(zoo.MODELS[name]().kane)
    for symbols in (system.constants_symbols, system.specifieds_symbols):
        assert list(symbols) == list(sm.ordered(symbols))


def test_the_symbols_behave_as_sets():
    system = System(zoo.pendulum().kane)
    assert isinstance(system.constants_symbols, Set)
    assert sm.Symbol("g") in system.constants_symbols
    assert system.constants_symbols - {sm.Symbol("g")} == set(sm.symbols("m:3 l:2"))
    assert {sm.Symbol("g")} <= system.constants_symbols


def test_sets_of_symbols_print_sorted():
    system = System(zoo.chain().kane)
    assert str(system.constants_symbols) == "{c0, c1, c2, g, k0, k1, k2, m0, m1, m2}"
    assert repr(system.specifieds_symbols) == "{f0(t), f1(t), f2(t)}"


def test_derivatives_of_a_prescribed_motion_are_specifieds():
    y = me.dynamicsymbols("y")
    assert System(zoo.shaken().kane).specifieds_symbols == {y, y.diff(T), y.diff(T, 2)}


def test_explicit_time_is_neither_constant_nor_specified():
    system = System(zoo.timed().kane)
    assert T not in system.constants_symbols
    assert system.specifieds_symbols == set()


def test_accelerations_in_the_loads_are_not_specifieds():
    assert System(zoo.added_mass().kane).specifieds_symbols == set()


def test_auxiliary_speeds_in_the_constraints_are_not_specifieds():
    assert System(zoo.skate().kane).specifieds_symbols == set()


def test_a_nonlinear_acceleration_in_the_loads_is_refused_with_its_term():
    with pytest.raises(ValueError, match=r"Derivative\(v\(t\), t\)\*\*2"):
        System(zoo.squared_acceleration().kane).evaluate_ode()


def test_given_symbols_replace_the_search():
    g, l0, m0, m1, spare = sm.symbols("g l0 m0 m1 spare")
    force, other = me.dynamicsymbols("F other")
    kane = zoo.sympy_models.n_link_pendulum_on_cart()
    system = System(
        kane, constants_symbols=[spare, m1, m0, l0, g], specifieds_symbols=[other, force]
    )
    assert system.constants_symbols == {g, l0, m0, m1, spare}
    assert system.specifieds_symbols == {force, other}
    assert list(system.constants_symbols) == [g, l0, m0, m1, spare]
    plain = System(kane)
    x = [0.1, 0.2, 0.3, 0.4]
    close(system.evaluate_ode(x), plain.evaluate_ode(x), 1e-14)


def test_symbols_of_outputs_join_the_given_symbols():
    model = zoo.timed()
    extra, r = sm.Symbol("extra"), me.dynamicsymbols("r")
    x = model.kane.q[0]
    system = system_of(
        model,
        constants_symbols=list(model.constants),
        specifieds_symbols=[],
        outputs={sm.Symbol("o"): extra * x + r},
    )
    assert system.constants_symbols == {*model.constants, extra}
    assert system.specifieds_symbols == {r}


def test_symbols_of_outputs_join_the_found_symbols():
    extra = sm.Symbol("extra")
    system = system_of(zoo.bare(), outputs={sm.Symbol("o"): extra**2})
    assert system.constants_symbols == {extra}
    system.constants = {extra: 3.0}
    close(system.evaluate_outputs(), [9.0])


def test_a_missing_given_symbol_is_named():
    kane = zoo.timed().kane
    m, k, p = sm.symbols("m k p")
    with pytest.raises(ValueError, match=r"\bw\b"):
        System(kane, constants_symbols=[m, k, p]).evaluate_ode()


@pytest.mark.parametrize(
    ("name", "coordinates", "speeds", "holonomic", "nonholonomic", "velocity"),
    [
        ("chain", 3, 3, 0, 0, 0),
        ("disc", 5, 5, 0, 2, 2),
        ("disc_contact", 5, 5, 0, 2, 2),
        ("sleigh", 3, 3, 0, 1, 1),
        ("skate", 3, 2, 0, 1, 1),
        ("fourbar", 3, 3, 2, 0, 2),
        ("track", 3, 3, 1, 1, 2),
        ("track_reversed", 3, 3, 1, 1, 2),
        ("gyro", 4, 3, 1, 0, 0),
        ("lifted", 2, 2, 1, 0, 1),
    ],
)
def test_the_counts_are_right(name, coordinates, speeds, holonomic, nonholonomic, velocity):
    system = System(zoo.MODELS[name]().kane)
    assert system.num_coordinates == coordinates
    assert system.num_speeds == speeds
    assert system.num_states == coordinates + speeds
    assert system.num_holonomic_constraints == holonomic
    assert system.num_nonholonomic_constraints == nonholonomic
    assert system.num_velocity_constraints == velocity
    assert system.num_constraints == holonomic + nonholonomic
    assert system.num_outputs == holonomic + nonholonomic
    assert system.num_auxiliaries == 0


def test_eom_method_is_read_only():
    kane = zoo.bare().kane
    system = System(kane)
    assert system.eom_method is kane
    with pytest.raises(AttributeError):
        system.eom_method = zoo.timed().kane
    assert system.eom_method is kane


def test_a_method_is_read_once():
    """What is made of it later comes from the same equations: none is read from it again."""
    x, v = me.dynamicsymbols("x v")
    m, k = sm.symbols("m k")
    N, P = me.ReferenceFrame("N"), me.Point("P")
    P.set_vel(N, v * N.x)
    kane, body = me.KanesMethod(N, [x], [v], kd_eqs=[x.diff(T) - v]), me.Particle("p", P, m)
    kane.kanes_equations([body], [(P, -k * x * N.x)])
    system = System(kane, {m: 1.0, k: 4.0})
    kane.kanes_equations([body], [(P, -100 * x * N.x)])
    np.testing.assert_allclose(system.evaluate_ode([1.0, 0.0]), [0.0, -4.0])
    system.generate_ode_function(generator="lambdify")
    np.testing.assert_allclose(system.evaluate_ode([1.0, 0.0]), [0.0, -4.0])
    assert system.potential_energy == k * x**2 / 2
    np.testing.assert_allclose(np.abs(system.linearize([0.0, 0.0]).eigenvalues), 2.0)
    np.testing.assert_allclose(copy.deepcopy(system).evaluate_ode([1.0, 0.0]), [0.0, -4.0])


def test_a_method_without_equations_is_refused():
    x, v = me.dynamicsymbols("x v")
    kane = me.KanesMethod(me.ReferenceFrame("N"), [x], [v], kd_eqs=[x.diff(T) - v])
    with pytest.raises((ValueError, TypeError, RuntimeError), match="kanes_equations"):
        System(kane)


def test_nothing_is_shared_between_two_systems():
    first, second = System(zoo.timed().kane), System(zoo.timed().kane)
    first.constants[sm.Symbol("m")] = 3.0
    first.initial_conditions[first.states[0]] = 1.0
    assert second.constants == {}
    assert second.initial_conditions == {}


# misspelt attributes


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("initial_condition", "Did you mean `initial_conditions`"),
        ("constant", "Did you mean `constants`"),
        ("ode_sovler", "Did you mean `ode_solver`"),
        ("masses", "There are constants, initial_conditions, .*times"),
    ],
)
def test_a_misspelt_attribute_is_refused_with_the_nearest_name(name, meant):
    system = System(zoo.timed().kane)
    with pytest.raises(AttributeError, match=f"no attribute `{name}`.*{meant}"):
        setattr(system, name, {})
    assert not hasattr(system, name)


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("evaluate_holonomic", "Use `evaluate_holonomic_constraints`"),
        ("evaluate_nonholonomic", "Use `evaluate_constraints`, whose last"),
        ("lqr", r"has no `lqr`. Use `system.linearize\(\).to_control\(\)`"),
        ("natural_frequencies", r"Use `abs\(system.linearize\(\).eigenvalues\)`"),
        ("energy", r"Use `evaluate_energy\(\)`"),
        ("integrat", "no attribute `integrat`. Did you mean `integrate`"),
        ("Times", "no attribute `Times`. Did you mean `times`"),
        ("qqqqqq", "no attribute 'qqqqqq'$"),
    ],
)
def test_a_name_that_there_is_not_is_refused_with_the_one_that_is_meant(name, meant):
    system = System(zoo.timed().kane)
    with pytest.raises(AttributeError, match=meant):
        getattr(system, name)
    assert not hasattr(system, name)


def test_a_class_of_the_users_has_attributes_of_its_own():
    class Mine(System):
        """With a name."""

    system = Mine(zoo.timed().kane)
    system.label = "mine"
    assert system.label == "mine"


def test_a_list_of_initial_conditions_is_refused_with_the_remedy():
    system = System(zoo.timed().kane)
    with pytest.raises(TypeError, match=r"got list. Use `dict\(zip\(system.states, values\)\)`"):
        system.initial_conditions = [0.0, 0.0]
    system.initial_conditions = dict(zip(system.states, [0.5, 0.1], strict=False))
