"""Outputs: the four kinds, their order, and what they do to states and the generated function."""

import re

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from oracles.oracle import oracle
from pydy.analysis import Trial
from pydy.errors import PyDyUserWarning
from pydy.models import multi_mass_spring_damper
from zoo.cases import close, system_of

A, B, K = sm.symbols("a b K")
T = zoo.T
GENERATORS = ["llvm", "lambdify"]


def chain_system(outputs, **options):
    return system_of(zoo.chain(), outputs=outputs, **options)


def states():
    return zoo.chain().states


def derivative(i=0):
    return zoo.chain().kane.u[i].diff(T)


# ordinary


@pytest.mark.parametrize("generator", GENERATORS)
def test_an_ordinary_output_is_evaluated(generator):
    model = zoo.chain()
    x, t = model.sample()
    m0, v0 = sm.Symbol("m0"), states()[3]
    f0 = me.dynamicsymbols("f0")
    system = chain_system({K: m0 * v0**2 / 2 + f0 * sm.cos(T)})
    system.generate_ode_function(generator=generator)
    expected = oracle(model).evaluate([m0 * v0**2 / 2 + f0 * sm.cos(T)], x, t)
    close(system.evaluate_outputs(x, t), expected)
    assert system.auxiliaries == []


@pytest.mark.parametrize("kind", [tuple, list, sm.Matrix])
def test_a_tuple_of_names_takes_a_tuple_a_list_or_a_matrix(kind):
    x0, x1 = states()[:2]
    system = chain_system({(A, B): kind([x0 + x1, x0 * x1])})
    x, t = zoo.chain().sample()
    close(system.evaluate_outputs(x, t), [x[0] + x[1], x[0] * x[1]])
    assert system.outputs_symbols == [A, B]


def test_a_function_of_time_can_be_a_name():
    p = me.dynamicsymbols("p")
    x, t = zoo.chain().sample()
    system = chain_system({p: 3 * states()[0]})
    assert system.outputs_symbols == [p]
    close(system.evaluate_outputs(x, t), [3 * x[0]])
    assert p not in system.specifieds_symbols


def test_a_number_can_be_an_output():
    system = chain_system({A: 3, B: sm.pi})
    close(system.evaluate_outputs(*zoo.chain().sample()), [3.0, np.pi])


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("name", ["chain", "pendulum", "added_mass", "disc", "fourbar", "timed"])
def test_accelerations_without_own_names_are_evaluated_linear_or_not(name, generator):
    model = zoo.MODELS[name]()
    u = model.kane.u
    expressions = [u[0].diff(T), u[-1].diff(T) ** 2 + sm.sin(u[0].diff(T)) * u[0]]
    system = system_of(model, outputs={A: expressions[0], B: expressions[1]})
    system.generate_ode_function(generator=generator)
    x, t = model.sample()
    assert system.auxiliaries == []
    close(system.evaluate_outputs(x, t)[:2], oracle(model).evaluate(expressions, x, t))


@pytest.mark.parametrize("name", ["free_body", "disc", "gyro"])
def test_rates_of_coordinates_go_through_the_kinematic_equations(name):
    model = zoo.MODELS[name]()
    rates = [s.diff(T) for s in model.kane.q]
    system = system_of(model, outputs={tuple(sm.symbols(f"r:{len(rates)}")): rates})
    x, t = model.sample()
    close(system.evaluate_outputs(x, t)[: len(rates)], oracle(model).evaluate(rates, x, t))


# order, copies, residuals


def test_a_second_derivative_is_refused_with_what_to_write():
    kane = zoo.chain().kane
    q, u = kane.q[0], kane.u[0]
    remedy = f"`{q.diff(T)}` is the speed `{u}`: write `{u.diff(T)}`."
    with pytest.raises(ValueError, match=re.escape(remedy)):
        chain_system({A: 2 * q.diff(T, 2)})
    with pytest.raises(ValueError, match=r"first derivatives are available\. Rewrite it in terms"):
        chain_system({A: u.diff(T, 2)})


@pytest.mark.parametrize("generator", GENERATORS)
def test_the_order_is_the_users_then_residuals_then_forces(generator):
    model = zoo.disc_contact()
    q, u = model.kane.q, model.kane.u
    n = sm.symbols("n:5")
    outputs = {n[4]: u[0] ** 2, (n[0], n[3]): (n[0] - u[1].diff(T), n[3] + n[0]), n[1]: q[1]}
    system = system_of(model, outputs=outputs)
    system.generate_ode_function(generator=generator)
    symbols = system.outputs_symbols
    assert symbols[:4] == [n[4], n[0], n[3], n[1]]
    assert [s.name for s in symbols[4:6]] == ["c0", "c1"]
    assert all(isinstance(s, sm.Dummy) for s in symbols[4:6])
    assert symbols[6:] == list(model.forces)
    assert system.num_outputs == 8
    x, t = model.sample()
    acceleration = oracle(model).xdot(x, t)[6]
    expected = [x[5] ** 2, acceleration, -acceleration, x[1]]
    expected += [*oracle(model).velocity(x, t), *oracle(model).forces(x, t)]
    close(system.evaluate_outputs([*x, *[0.1] * system.num_auxiliaries], t), expected)


def test_the_auxiliaries_follow_the_order_of_the_outputs():
    model = zoo.disc_contact()
    u = model.kane.u
    system = system_of(model, outputs={B: B - u[1].diff(T), K: u[0], A: A - u[0].diff(T)})
    assert system.auxiliaries[:2] == [sm.Symbol("∫ b dt"), sm.Symbol("∫ a dt")]
    assert system.num_auxiliaries == 4
    x, t = model.sample()
    rates = oracle(model).xdot(x, t)
    expected = [*rates, rates[6], rates[5], *oracle(model).forces(x, t)]
    close(system.evaluate_ode([*x, 0.1, 0.2, 0.3, 0.4], t), expected)


def test_constraint_residuals_are_outputs_by_themselves():
    model = zoo.track()
    system = system_of(model)
    x, t = model.sample()
    assert [s.name for s in system.outputs_symbols] == ["c0", "c1"]
    close(system.evaluate_outputs(x, t), system.evaluate_constraints(x, t), 1e-14)


def test_an_own_symbol_named_like_a_residual_is_another_one():
    system = system_of(zoo.track(), outputs={sm.Symbol("c0"): 3 * zoo.track().states[0]})
    x, t = zoo.track().sample()
    y = system.evaluate_outputs(x, t)
    close(y, [3 * x[0], *system.evaluate_constraints(x, t)])


def test_the_users_dict_is_copied_and_never_changed():
    mine = {A: zoo.track().states[0]}
    system = system_of(zoo.track(), outputs=mine)
    system.evaluate_outputs()
    assert mine == {A: zoo.track().states[0]}
    mine[B] = zoo.track().states[1]
    assert B not in system.outputs_symbols


def test_the_property_shows_residuals_and_forces_with_the_users():
    model = zoo.disc_contact()
    system = system_of(model, outputs={A: model.states[0]})
    names = [n for key in system.outputs for n in (key if isinstance(key, tuple) else (key,))]
    assert names == system.outputs_symbols
    assert system.outputs[A] == model.states[0]


def test_setting_outputs_again_keeps_residuals_and_forces():
    model = zoo.disc_contact()
    system = system_of(model, outputs={A: model.states[0]})
    system.outputs = {B: 2 * model.states[0]}
    symbols = system.outputs_symbols
    assert symbols[0] == B
    assert [getattr(s, "name", None) for s in symbols[1:3]] == ["c0", "c1"]
    assert symbols[3:] == list(model.forces)


def test_new_outputs_are_noticed_without_generating_again():
    model = zoo.chain()
    x, t = model.sample()
    system = chain_system({A: states()[0]})
    close(system.evaluate_outputs(x, t), [x[0]])
    system.outputs = {A: 5 * states()[0], B: states()[1]}
    close(system.evaluate_outputs(x, t), [5 * x[0], x[1]])


@pytest.mark.parametrize(
    "outputs",
    [{A: 1, (B, A): (1, 2)}, {(A, A): (1, 2)}],
    ids=["two keys", "one key"],
)
def test_a_repeated_name_is_refused(outputs):
    with pytest.raises(ValueError, match=r"\ba\b"):
        chain_system(outputs)


@pytest.mark.parametrize(
    "outputs", [{(A, B): (1, 2, 3)}, {(A, B): 1}, {A: (1, 2)}], ids=["more", "one", "two"]
)
def test_a_wrong_number_of_expressions_is_refused(outputs):
    with pytest.raises(ValueError, match=r"\ba\b"):
        chain_system(outputs)


def test_wrong_outputs_leave_the_old_ones():
    system = chain_system({A: states()[0]})
    with pytest.raises(ValueError, match=r"\bb\b"):
        system.outputs = {(B, B): (1, 2)}
    assert system.outputs_symbols == [A]


def test_an_unknown_function_in_an_output_is_named():
    with pytest.raises((ValueError, NotImplementedError), match="stieltjes"):
        chain_system({A: sm.stieltjes(states()[0])}).evaluate_outputs()


def test_a_singular_group_is_a_linear_algebra_error():
    x, c = states()[0], sm.Symbol("c")
    for group in ((A + B - 1, A + B - x), (A * c + B * x, A * c + 2 * B * x)):
        system = chain_system({(A, B): group})
        system.constants |= dict.fromkeys({*system.constants_symbols} & {c}, 0.0)
        with pytest.raises(np.linalg.LinAlgError):
            system.evaluate_outputs(*zoo.chain().sample())


@pytest.mark.parametrize("solver", [None, "dop853"])
def test_a_simulation_warns_once_of_outputs_that_are_not_finite(solver):
    system = multi_mass_spring_damper()
    x, v = system.states
    system.outputs = {"time": 1 / v, "energy": v**2}
    system.initial_conditions, system.times = {x: 1.0}, np.linspace(0.0, 1.0, num=5)
    if solver is not None:
        system.ode_solver = solver
    with pytest.warns(PyDyUserWarning, match="not finite: time at t = 0.0 in the state") as caught:
        motion = system.simulate()
    assert len(caught) == 1
    assert caught[0].filename == __file__
    assert np.isinf(motion["time"]).tolist() == [True, False, False, False, False]
    assert np.isfinite(motion.at([0.5])["time"]).all()
    system.times = [0.0, 0.5, 1.0]
    system.initial_conditions = {x: 1.0, v: 1.0}
    assert np.isfinite(system.simulate()["time"]).all()
    system.initial_conditions, system.times = {}, [0.0, 0.5]  # at rest, where it stays
    with pytest.warns(PyDyUserWarning, match=r"the same at 1 other sample\.") as caught:
        system.simulate()
    assert len(caught) == 1


def test_a_fit_and_a_search_do_not_warn_of_what_they_try():
    system = multi_mass_spring_damper()
    x, v = system.states
    system.outputs = {"time": 1 / v}
    system.initial_conditions, system.times = {x: 1.0}, np.linspace(0.0, 2.0, num=9)
    system.ode_solver = "dop853"
    measured = Trial(system.times, {x: system.integrate()[:, 0]})
    assert system.fit(["k0"], measured)["k0"] == pytest.approx(1.0)


def test_outputs_may_be_named_like_states_constants_and_specifieds():
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    x0, v0 = system.states
    (f0,), m0 = system.specifieds_symbols, sm.Symbol("m0")
    system.outputs = {x0: 3 * x0, (v0, m0): (v0 + m0, -m0), "f0": f0 + v0.diff()}
    system.constants, system.specifieds = {m0: 2.0}, {f0: 5.0}
    values = system.evaluate_outputs([1.0, 4.0])  # v' = (5 - 1 - 4) / 2
    np.testing.assert_array_equal(values, [3.0, 6.0, -2.0, 5.0])
    np.testing.assert_array_equal(system.evaluate_ode([1.0, 4.0]), [4.0, 0.0])
    np.testing.assert_array_equal(system.evaluate_jacobian([1.0, 4.0], of=[x0]), [[1.0, 0.0]])
    found = system.evaluate_jacobian([1.0, 4.0], of=["x0_output"])
    np.testing.assert_array_equal(found, [[3.0, 0.0]])
    system.outputs[x0] = 4 * x0
    assert system.evaluate_outputs([1.0, 4.0])[0] == 4.0
    with pytest.raises(ValueError, match=r"`outputs` has the name `t`, which is the time"):
        system.outputs = {me.dynamicsymbols._t: x0}


def test_samples_have_labels_of_outputs_that_are_named_like_states():
    system = multi_mass_spring_damper(1)
    system.outputs, system.times = {system.states[0]: 2 * system.states[0]}, [0.0, 1.0]
    results = system.integrate_ensemble(initial_conditions={"x0": [1.0, 2.0]}, ode_solver="dop853")
    np.testing.assert_array_equal(results.x0_output, 2 * results.x0)
