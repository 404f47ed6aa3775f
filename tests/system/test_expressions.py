"""Specifieds given as SymPy expressions, against functions, substitution and closed forms."""

import copy
import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from oracles.oracle import oracle
from pydy._errors import PyDyUserWarning, UnsupportedFunctionError
from pydy.system import System
from zoo.cases import OTHER_SOLVERS, Recorder, close, system_of

T = zoo.T
F, T1, T2 = me.dynamicsymbols("F T1 T2")
Q0, Q1, Q2, U0, U1, U2 = me.dynamicsymbols("q0:3 u0:3")
G = sm.Symbol("g")
KP, KD = sm.symbols("kp kd")
GAINS = {KP: 2.5, KD: 0.4}
GENERATORS = ["llvm", "lambdify"]
TIGHT = {"rtol": 1e-11, "atol": 1e-11}

# Expression, and the same as a function of the state and time; kp = 2.5, kd = 0.4, g of the model.
LAW = {
    F: -KP * Q0 - KD * U0 * sm.Abs(U0) + sm.sin(3 * T),
    T1: sm.Piecewise((G * sm.cos(Q1), T < 1), (sm.exp(-T), True)),
}


def law_f(x, t):
    return -2.5 * x[0] - 0.4 * x[3] * abs(x[3]) + np.sin(3 * t)


def law_t1(x, t):
    return zoo.pendulum().constants[G] * np.cos(x[1]) if t < 1 else np.exp(-t)


def controlled(specifieds=None, **options):
    """The pendulum on a cart with the law above; T2 is a number."""
    specifieds = {**LAW, T2: 0.3} if specifieds is None else specifieds
    gains = {s: v for s, v in GAINS.items() if str(s) in repr(specifieds)}
    numbers = {**zoo.pendulum().constants, **gains}
    return system_of(zoo.pendulum(), constants=numbers, specifieds=specifieds, **options)


def numbers_of(x, t):
    return {F: law_f(x, t), T1: law_t1(x, t), T2: 0.3}


# one mass, its equations with and without the expression


def mass(force):
    """A mass on a spring, pushed by `force`, which SymPy may already know."""
    x, v = me.dynamicsymbols("x v")
    m, k = sm.symbols("m k")
    frame, p = me.ReferenceFrame("N"), me.Point("P")
    p.set_vel(frame, v * frame.x)
    kane = me.KanesMethod(frame, [x], [v], kd_eqs=[x.diff(T) - v])
    kane.kanes_equations([me.Particle("A", p, m)], [(p, (force - k * x) * frame.x)])
    return kane


def shaken(height):
    """A pendulum whose pivot moves as `height`, which SymPy may already know."""
    q, u = me.dynamicsymbols("q u")
    g = sm.Symbol("g")
    frame, pivot, bob = me.ReferenceFrame("N"), me.Point("O"), me.Point("B")
    rate = height.diff(T)
    swing = sm.cos(q) * frame.x + sm.sin(q) * frame.y
    inward = -sm.sin(q) * frame.x + sm.cos(q) * frame.y
    pivot.set_vel(frame, rate * frame.y)
    bob.set_vel(frame, rate * frame.y + u * swing)
    bob.set_acc(frame, rate.diff(T) * frame.y + u.diff(T) * swing + u**2 * inward)
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff(T) - u])
    drag = -(height + rate) * frame.y  # so that all three orders occur
    kane.kanes_equations([me.Particle("P", bob, sm.Symbol("m"))], [(bob, drag - g * frame.y)])
    return kane


X, V = me.dynamicsymbols("x v")
PUSH = sm.Symbol("a") * sm.cos(2 * T) - sm.Symbol("c") * V * X**2


@pytest.mark.parametrize("generator", GENERATORS)
def test_an_expression_gives_what_the_function_gives(generator):
    system = controlled()
    system.generate_ode_function(generator=generator)
    for seed in range(4):
        x, t = zoo.pendulum().sample(seed)
        close(system.evaluate_ode(x, t), oracle(zoo.pendulum()).xdot(x, t, numbers_of(x, t)))


@pytest.mark.parametrize("solver", ["numpy", "sympy", np.linalg.solve])
def test_a_linear_solver_of_the_users_own_choice_takes_expressions(solver):
    system = System(mass(F), specifieds={F: PUSH}, constants={sm.Symbol("m"): 2.0})
    system.generate_ode_function(linear_sys_solver=solver)
    close(system.evaluate_ode([0.5, 2.0], 0.3), [2.0, (np.cos(0.6) - 0.5 - 0.5) / 2])


def test_expression_function_and_substitution_integrate_alike():
    times = np.linspace(0.0, 2.0, 9)
    start = {X: 0.7, V: -0.2}
    numbers = {sm.Symbol("m"): 1.7, sm.Symbol("k"): 5.0}
    more = {sm.Symbol("a"): 3.0, sm.Symbol("c"): 0.8}
    settings = {"times": times, "initial_conditions": start}
    given = System(mass(F), constants={**numbers, **more}, specifieds={F: PUSH}, **settings)
    known = System(mass(PUSH), constants={**numbers, **more}, **settings)
    called = System(
        mass(F),
        constants=numbers,
        specifieds={F: lambda x, t: 3.0 * np.cos(2 * t) - 0.8 * x[1] * x[0] ** 2},
        **settings,
    )
    close(given.integrate(**TIGHT), known.integrate(**TIGHT), 1e-9)
    close(given.integrate(**TIGHT), called.integrate(**TIGHT), 1e-9)
    close(given.evaluate_jacobian([0.3, 0.4], 0.5), known.evaluate_jacobian([0.3, 0.4], 0.5))
    assert given.constants_symbols == known.constants_symbols


def test_a_driven_mass_moves_as_its_closed_form():
    # m x'' = a cos(2t) from rest at the origin: x = a/(4m) (1 − cos 2t).
    times = np.linspace(0.0, 3.0, 7)
    a = sm.Symbol("a")
    system = System(mass(F), specifieds={F: sm.Symbol("k") * X + a * sm.cos(2 * T)}, times=times)
    system.constants = {a: 3.0, sm.Symbol("m"): 2.0, sm.Symbol("k"): 7.0}
    states = system.integrate(**TIGHT)
    close(states[:, 0], 3.0 / 8.0 * (1 - np.cos(2 * times)), 1e-8)


@pytest.mark.parametrize("solver", OTHER_SOLVERS)
def test_every_solver_takes_expressions(solver):
    times = np.linspace(0.0, 0.8, 5)
    system = controlled(times=times)
    expected = system.integrate(**TIGHT)
    system.ode_solver = solver
    close(system.integrate(), expected, 1e-6)


def test_expressions_alone_leave_the_solver_with_plain_arrays():
    system = controlled(times=[0.0, 0.1])
    system.ode_solver = recorder = Recorder()
    system.integrate()
    r, p = recorder.args
    np.testing.assert_array_equal(r, [0.0, 0.0, 0.3])
    assert p.shape == (system.num_constants,)


FORMATS = {
    "tuple": {(T2, F, T1): (0.3, LAW[F], LAW[T1])},
    "list": {(T1, F): [LAW[T1], LAW[F]], T2: 0.3},
    "matrix": {(F, T1): sm.Matrix([LAW[F], LAW[T1]]), T2: sm.Rational(3, 10)},
    "array of objects": {(F, T1): np.array([LAW[F], LAW[T1]]), T2: 0.3},
    "format 2": {"symbols": (T2, T1, F), "values": (0.3, LAW[T1], LAW[F])},
    "format 2, matrix": {"symbols": [F, T2, T1], "values": sm.Matrix([LAW[F], 0.3, LAW[T1]])},
}


@pytest.mark.parametrize("name", FORMATS)
def test_every_format_takes_expressions(name):
    x, t = zoo.pendulum().sample(2)
    system = controlled(specifieds=FORMATS[name])
    close(system.evaluate_ode(x, t), oracle(zoo.pendulum()).xdot(x, t, numbers_of(x, t)))


# symbols


def test_symbols_of_an_expression_become_constants_with_the_value_one():
    system = system_of(zoo.pendulum(), specifieds={F: KP * Q0})
    assert system.constants_symbols == {*zoo.pendulum().constants, KP}
    x, _ = zoo.pendulum().sample(1)
    close(system.evaluate_ode(x), oracle(zoo.pendulum()).xdot(x, 0, {F: x[0], T1: 0, T2: 0}))
    system.constants[KP] = 3.0
    close(system.evaluate_ode(x), oracle(zoo.pendulum()).xdot(x, 0, {F: 3 * x[0], T1: 0, T2: 0}))


def test_symbols_of_an_expression_leave_with_it():
    system = controlled()
    system.constants = {}
    system.specifieds = {F: Q0}
    assert KP not in system.constants_symbols


def test_a_function_of_time_in_an_expression_becomes_a_specified():
    command = me.dynamicsymbols("command")
    system = controlled(specifieds={F: KP * (command - Q0), command: lambda x, t: t})
    assert system.specifieds_symbols == {F, T1, T2, command}
    x, t = zoo.pendulum().sample(1)
    values = {F: 2.5 * (t - x[0]), T1: 0, T2: 0}
    close(system.evaluate_ode(x, t), oracle(zoo.pendulum()).xdot(x, t, values))


def test_specifieds_may_be_defined_through_each_other():
    x, t = zoo.pendulum().sample(1)
    system = controlled(specifieds={T1: F + T2, F: KP * T2, T2: sm.sin(T) + Q0})
    t2 = np.sin(t) + x[0]
    values = {T2: t2, F: 2.5 * t2, T1: 3.5 * t2}
    close(system.evaluate_ode(x, t), oracle(zoo.pendulum()).xdot(x, t, values))


def test_the_rate_of_a_coordinate_follows_the_kinematics():
    model, w = zoo.disc(), me.dynamicsymbols("w")
    x, t = model.sample(1)
    for k, q in enumerate(model.kane.q):
        system = system_of(model, outputs={sm.Symbol("rate"): w}, specifieds={w: q.diff(T)})
        close(system.evaluate_outputs(x, t)[:1], oracle(model).xdot(x, t)[[k]])


def test_outputs_and_forces_see_the_expression():
    system = controlled(outputs={sm.Symbol("push"): 2 * F, sm.Symbol("a"): U0.diff(T) * T1})
    x, t = zoo.pendulum().sample(1)
    f, t1 = law_f(x, t), law_t1(x, t)
    a = oracle(zoo.pendulum()).xdot(x, t, numbers_of(x, t))[3]
    close(system.evaluate_outputs(x, t), [2 * f, a * t1])


# derivatives of a prescribed motion

HEIGHT = sm.Symbol("a") * sm.sin(sm.Symbol("w") * T) + sm.Piecewise(
    (T**2, T < 1), (2 * T - 1, True)
)
Y = me.dynamicsymbols("y")


def test_derivatives_of_a_prescribed_motion_follow_its_expression():
    values = {sm.Symbol("a"): 0.3, sm.Symbol("w"): 4.0, sm.Symbol("g"): 9.7}
    given = System(shaken(Y), specifieds={Y: HEIGHT}, constants=values)
    known = System(shaken(HEIGHT), constants=values)
    assert given.specifieds_symbols == {Y, Y.diff(T), Y.diff(T, 2)}
    for t in (0.2, 0.9, 1.7):
        close(given.evaluate_ode([0.6, -1.2], t), known.evaluate_ode([0.6, -1.2], t), 1e-12)


@pytest.mark.parametrize("value", [5.0, sm.Integer(5)])
def test_a_derivative_given_explicitly_wins(value):
    # What lies above follows from the nearest value below, which is no expression here.
    x, t = np.array([0.6, -1.2]), 0.4
    system = System(shaken(Y), specifieds={Y: sm.sin(T), Y.diff(T): value})
    twin = System(shaken(Y), specifieds={Y: np.sin(t), Y.diff(T): 5.0})
    close(system.evaluate_ode(x, t), twin.evaluate_ode(x, t))


def test_a_derivative_given_as_a_function_wins_and_leaves_the_next_one_zero():
    x, t = np.array([0.6, -1.2]), 0.4
    with pytest.warns(PyDyUserWarning, match=r"Derivative\(y\(t\), \(t, 2\)\)`, which stays zero"):
        system = System(shaken(Y), specifieds={Y: sm.sin(T), Y.diff(T): lambda x, t: 5.0})
    twin = System(shaken(Y), specifieds={Y: np.sin(t), Y.diff(T): 5.0})
    close(system.evaluate_ode(x, t), twin.evaluate_ode(x, t))


def test_higher_derivatives_follow_the_nearest_expression_below():
    x, t = np.array([0.6, -1.2]), 0.4
    system = System(shaken(Y), specifieds={Y: sm.sin(T), Y.diff(T): 3 * sm.cos(T)})
    numbers = {Y: np.sin(t), Y.diff(T): 3 * np.cos(t), Y.diff(T, 2): -3 * np.sin(t)}
    close(system.evaluate_ode(x, t), System(shaken(Y), specifieds=numbers).evaluate_ode(x, t))


def test_derivatives_follow_a_chain_of_expressions():
    e = me.dynamicsymbols("e")
    x, t = np.array([0.6, -1.2]), 0.4
    system = System(shaken(Y), specifieds={Y: 2 * e, e: sm.sin(T)})
    numbers = {Y: 2 * np.sin(t), Y.diff(T): 2 * np.cos(t), Y.diff(T, 2): -2 * np.sin(t)}
    close(system.evaluate_ode(x, t), System(shaken(Y), specifieds=numbers).evaluate_ode(x, t))


@pytest.mark.parametrize(
    ("values", "what"),
    [
        ({Y: sm.sin(me.dynamicsymbols("q"))}, r"q\(t\)"),
        ({Y: 2 * me.dynamicsymbols("e")}, r"e\(t\)"),
    ],
)
def test_a_derivative_that_does_not_follow_is_asked_for(values, what):
    message = rf"no value for `Derivative\(y\(t\), t\)`.*`y\(t\)`, which depends on {what}.*Give"
    with pytest.raises(ValueError, match=message):
        System(shaken(Y), specifieds=values)


def test_a_derivative_of_motion_by_state_can_be_given():
    q, u = me.dynamicsymbols("q u")
    rates = {Y.diff(T): sm.cos(q) * u, Y.diff(T, 2): 0.0}
    system = System(shaken(Y), specifieds={Y: sm.sin(q), **rates})
    numbers = {Y: np.sin(0.6), Y.diff(T): -1.2 * np.cos(0.6)}
    expected = System(shaken(Y), specifieds=numbers).evaluate_ode([0.6, -1.2])
    close(system.evaluate_ode([0.6, -1.2]), expected)


def test_dependent_initial_conditions_honour_a_prescribed_motion():
    model = zoo.lifted()
    s = me.dynamicsymbols("s")
    x, y, vx, vy = model.states
    system = system_of(
        model,
        specifieds={s: 0.5 + sm.sin(2 * T)},
        initial_conditions={x: 0.4, vx: 0.3},
        times=[0.7, 1.0],
    )
    system.set_dependent_initial_conditions()
    slope = model.constants[sm.Symbol("slope")]
    found = system.initial_conditions
    height = 0.5 + np.sin(1.4) + slope * 0.4 * np.sin(0.7)
    close([found[y]], [height], 1e-9)
    rate = 2 * np.cos(1.4) + slope * (0.3 * np.sin(0.7) + 0.4 * np.cos(0.7))
    close([found[vy]], [rate], 1e-9)
    states = system.integrate(**TIGHT)
    assert abs(system.evaluate_constraints(states)).max() < 1e-9


# the documented function, and r for one call


def test_the_generated_function_keeps_all_specifieds_as_inputs():
    system = controlled()
    rhs = system.generate_ode_function()
    x, t = zoo.pendulum().sample(1)
    p = np.array([{**zoo.pendulum().constants, **GAINS}[s] for s in system.constants_symbols])
    expected = oracle(zoo.pendulum()).xdot(x, t, {F: 5.0, T1: 6.0, T2: 7.0})
    close(rhs(x, t, np.array([5.0, 6.0, 7.0]), p), expected)


def test_r_for_one_call_wins():
    system, x = controlled(), zoo.pendulum().sample(1)[0]
    t = 0.5
    whole = oracle(zoo.pendulum()).xdot(x, t, {F: 5.0, T1: 6.0, T2: 7.0})
    close(system.evaluate_ode(x, t, r=[5.0, 6.0, 7.0]), whole)
    close(system.evaluate_ode(x, t, r=lambda x, t: [5.0, 6.0, 7.0]), whole)
    close(system.evaluate_ode(x, t, r={F: 5.0, (T2, T1): (7.0, 6.0)}), whole)
    part = oracle(zoo.pendulum()).xdot(x, t, {**numbers_of(x, t), F: 5.0})
    close(system.evaluate_ode(x, t, r={F: 5.0}), part)
    part = oracle(zoo.pendulum()).xdot(x, t, {**numbers_of(x, t), T2: 2 * x[0]})
    close(system.evaluate_ode(x, t, r={T2: 2 * Q0}), part)
    close(system.evaluate_ode(x, t), oracle(zoo.pendulum()).xdot(x, t, numbers_of(x, t)))


def test_r_for_one_call_brings_no_new_symbols():
    with pytest.raises(ValueError, match=r"F\(t\).*`kz`.*states, specifieds, constants.*constant"):
        controlled().evaluate_ode(r={F: sm.Symbol("kz") * Q0})


def test_a_new_expression_keeps_the_generated_function():
    system = controlled()
    rhs = system.generate_ode_function()
    system.specifieds = {F: KP * KD * Q0**3}
    system.evaluate_ode()
    assert system.evaluate_ode_function is rhs


def test_an_expression_put_in_place_counts():
    system = system_of(zoo.pendulum(), specifieds={})
    x, t = zoo.pendulum().sample(1)
    system.evaluate_ode(x, t)
    system.specifieds[F] = KP * Q0
    values = {F: x[0], T1: 0, T2: 0}
    close(system.evaluate_ode(x, t), oracle(zoo.pendulum()).xdot(x, t, values))
    assert KP in system.constants_symbols
    system.specifieds[F] = 4.0
    close(system.evaluate_ode(x, t), oracle(zoo.pendulum()).xdot(x, t, {F: 4.0, T1: 0, T2: 0}))
    assert KP not in system.constants_symbols


def test_going_to_and_fro_between_kinds_of_values_gives_each_its_own():
    x, t = zoo.pendulum().sample(1)
    system = controlled()
    for _ in range(2):
        for value, number in ((LAW[F], law_f(x, t)), (law_f, law_f(x, t)), (2.0, 2.0), (T, t)):
            system.specifieds = {F: value, T1: Q0 * KP + KD}
            values = {F: number, T1: 2.5 * x[0] + 0.4, T2: 0.0}
            close(system.evaluate_ode(x, t), oracle(zoo.pendulum()).xdot(x, t, values))


@pytest.mark.parametrize("way", [copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))])
def test_copies_keep_the_expressions(way):
    system = controlled(times=[0.0, 0.1])
    x, t = zoo.pendulum().sample(1)
    expected = system.evaluate_ode(x, t)
    twin = way(system)
    close(twin.evaluate_ode(x, t), expected, 1e-14)
    close(twin.integrate(), system.integrate(), 1e-14)


# derivatives of it all


def differences(f, at, step=1e-6):
    at = np.array(at, dtype=float)
    columns = []
    for k in range(len(at)):
        e = np.zeros(len(at))
        e[k] = step
        columns.append((f(at + e) - f(at - e)) / (2 * step))
    return np.stack(columns, axis=1)


def test_the_jacobian_by_the_states_goes_through_the_expression():
    system = controlled()
    x, t = zoo.pendulum().sample(1)
    expected = differences(lambda z: system.evaluate_ode(z, t), x)
    close(system.evaluate_jacobian(x, t), expected, 1e-7)
    held = system.evaluate_jacobian(x, t, r=list(numbers_of(x, t).values()))
    assert not np.allclose(held, expected)


def test_the_jacobian_by_the_constants_goes_through_the_expression():
    system = controlled()
    x, t = zoo.pendulum().sample(1)
    p = [{**zoo.pendulum().constants, **GAINS}[s] for s in system.constants_symbols]
    expected = differences(lambda z: system.evaluate_ode(x, t, p=z), p)
    close(system.evaluate_jacobian(x, t, "constants"), expected, 1e-6)


def test_the_jacobian_by_the_specifieds_is_that_by_a_small_addition_to_each():
    x, t = zoo.pendulum().sample(1)
    law = {T1: F * Q0 + T2, F: KP * sm.sin(T)}
    system = controlled(specifieds={**law, T2: lambda x, t: t})

    def shifted(d):
        # The order of r is F, T1, T2; T1 sees what is added to F and T2.
        expressions = {F: law[F] + d[0], T1: law[T1] + d[1], T2: t + d[2]}
        return controlled(specifieds=expressions).evaluate_ode(x, t)

    expected = differences(shifted, [0.0, 0.0, 0.0])
    close(system.evaluate_jacobian(x, t, "specifieds"), expected, 1e-7)


# what is refused


def test_a_circle_is_named():
    with pytest.raises(
        ValueError,
        match=r"Circular definition in `specifieds`: (F\(t\) needs T1\(t\) needs T2\(t\) needs F)",
    ):
        controlled(specifieds={F: T1 + 1, T1: KP * T2, T2: Q0 * F})
    with pytest.raises(
        ValueError, match=r"Circular definition in `specifieds`: F\(t\) needs F\(t\)"
    ):
        controlled(specifieds={F: F + 1})


def test_only_the_circle_is_named_not_what_hangs_on_it():
    with pytest.raises(
        ValueError,
        match=r"Circular definition in `specifieds`: T1\(t\) needs T2\(t\) needs T1\(t\)\.",
    ):
        controlled(specifieds={F: T1 + 1, T1: KP * T2, T2: T1})


REFUSED = {
    "an acceleration": ({F: U0.diff(T)}, ValueError, r"F\(t\).*`Derivative\(u0.*KanesMethod"),
    "a second derivative": ({F: Q0.diff(T, 2)}, ValueError, r"F\(t\).*q0.*first derivatives"),
    "a function of something else": (
        {F: sm.Function("h")(Q0)},
        UnsupportedFunctionError,
        r"F\(t\).*`h\(q0\(t\)\)`.*not a function of time",
    ),
    "a delayed state": (
        {F: -Q0.subs(T, T - sm.Symbol("tau"))},
        UnsupportedFunctionError,
        r"F\(t\).*A delay of `q0` needs its past.*equation of its own",
    ),
    "a function without code": (
        {F: sm.stieltjes(Q0)},
        UnsupportedFunctionError,
        r"`stieltjes`.*F\(t\).*Rewrite",
    ),
    "the imaginary unit": ({F: sm.I * Q0}, ValueError, r"F\(t\).*`I`.*real"),
    "a truth value": ({F: Q0 > 0}, ValueError, r"F\(t\).*Piecewise"),
    "too few expressions": ({(F, T1): [Q0]}, ValueError, r"F\(t\), T1\(t\).*2 expr.*got 1"),
    "an unknown specified": ({me.dynamicsymbols("nope"): Q0}, ValueError, "nope"),
    "a specified left out of format 2": (
        {"symbols": (F, T1), "values": (Q0, Q1)},
        ValueError,
        r"T2\(t\)",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_compiled_is_refused_by_name_and_the_old_values_stay(name):
    values, kind, message = REFUSED[name]
    with pytest.raises(kind, match=message):
        controlled(specifieds=values)
    system = controlled()
    x, t = zoo.pendulum().sample(1)
    before = system.evaluate_ode(x, t)
    with pytest.raises(kind, match=message):
        system.specifieds = values
    np.testing.assert_array_equal(system.evaluate_ode(x, t), before)


def test_the_name_of_an_output_is_refused():
    system = controlled(outputs={sm.Symbol("power"): F * U0})
    with pytest.raises(ValueError, match=r"F\(t\) holds `power`, the name of an output"):
        system.specifieds = {F: sm.Symbol("power") * Q0}


def test_an_expression_that_shares_its_parts_is_never_walked_as_a_tree():
    # As a tree it has 2^60 leaves: whatever walks trees would never come back.
    expression = sm.sin(Q0)
    for _ in range(60):
        half = sm.Mul(sm.Rational(1, 2), expression, evaluate=False)
        expression = sm.Add(half, half, evaluate=False)
    x, t = zoo.pendulum().sample(1)
    system = system_of(zoo.pendulum(), specifieds={F: expression})
    values = {F: np.sin(x[0]), T1: 0, T2: 0}
    close(system.evaluate_ode(x, t), oracle(zoo.pendulum()).xdot(x, t, values))


def test_a_velocity_constraint_that_an_expression_makes_nonlinear_is_reported():
    model = zoo.lifted()
    s = me.dynamicsymbols("s")
    vy = model.states[3]
    rates = {s.diff(T): 1 + vy**2 / 8, s.diff(T, 2): 0.0}
    system = system_of(model, specifieds={s: 0.5, **rates}, times=[0.7, 1.0])
    with pytest.warns(PyDyUserWarning, match=r"velocity constraints do not hold for vy\(t\)"):
        system.set_dependent_initial_conditions()
    system.specifieds[s.diff(T)] = 1 + vy / 8
    system.set_dependent_initial_conditions()
    assert abs(system.evaluate_velocity_constraints()).max() < 1e-12
