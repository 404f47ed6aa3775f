"""Values for the prescribed functions: two formats, switched and edited at will."""

import numpy as np
import pytest
import sympy.physics.mechanics as me

import zoo
from oracles.oracle import oracle
from pydy.errors import PyDyUserWarning
from pydy.models import n_link_pendulum_on_cart
from zoo.cases import close, system_of

F, T1, T2 = me.dynamicsymbols("F T1 T2")
VALUES = {F: 0.3, T1: -0.7, T2: 1.1}


def expected(x, values=None, t=0.0):
    return oracle(zoo.pendulum()).xdot(x, t, VALUES | (values or {}))


@pytest.fixture
def x():
    return zoo.pendulum().sample(3)[0]


FORMATS = {
    "floats": VALUES,
    "integer and float": {F: 0.3, T1: np.float64(-0.7), T2: np.array(1.1)},
    "tuple to array": {(T2, F): np.array([1.1, 0.3]), T1: -0.7},
    "tuple to tuple": {(T2, F, T1): (1.1, 0.3, -0.7)},
    "tuple to list": {(T2, F, T1): [1.1, 0.3, -0.7]},
    "a function": {F: 0.3, T1: -0.7, T2: lambda x, t: 1.1},
    "a function giving an array": {F: 0.3, T1: -0.7, T2: lambda x, t: np.array(1.1)},
    "a function giving one item": {F: 0.3, T1: -0.7, T2: lambda x, t: np.array([1.1])},
    "tuple to function": {(T2, F): lambda x, t: np.array([1.1, 0.3]), T1: -0.7},
    "tuple to function giving a list": {(T2, F): lambda x, t: [1.1, 0.3], T1: -0.7},
    "format 2, array": {"symbols": (T1, T2, F), "values": np.array([-0.7, 1.1, 0.3])},
    "format 2, list": {"symbols": [T1, F, T2], "values": [-0.7, 0.3, 1.1]},
    "format 2, function": {
        "symbols": (T1, T2, F),
        "values": lambda x, t: np.array([-0.7, 1.1, 0.3]),
    },
    "format 2, function giving a list": {
        "symbols": (F, T2, T1),
        "values": lambda x, t: [0.3, 1.1, -0.7],
    },
}


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
@pytest.mark.parametrize("name", FORMATS)
def test_every_format_gives_the_same_derivatives(name, generator, x):
    system = system_of(zoo.pendulum(), specifieds=FORMATS[name])
    system.generate_ode_function(generator=generator)
    close(system.evaluate_ode(x), expected(x))


@pytest.mark.parametrize("name", FORMATS)
def test_every_format_integrates_alike(name):
    times = [0.0, 0.2, 0.4]
    system = system_of(zoo.pendulum(), specifieds=VALUES, times=times)
    reference = system.integrate(rtol=1e-10, atol=1e-10)
    system.specifieds = FORMATS[name]
    close(system.integrate(rtol=1e-10, atol=1e-10), reference, 1e-8)


def test_every_format_can_follow_every_other(x):
    system = system_of(zoo.pendulum())
    for name in [*FORMATS, *reversed(FORMATS)]:
        system.specifieds = FORMATS[name]
        close(system.evaluate_ode(x), expected(x))


def test_another_order_of_the_symbols_is_noticed_in_place(x):
    system = system_of(
        zoo.pendulum(), specifieds={"symbols": (T1, T2, F), "values": [-0.7, 1.1, 0.3]}
    )
    system.evaluate_ode(x)
    system.specifieds["symbols"] = (F, T1, T2)
    system.specifieds["values"] = [0.3, -0.7, 1.1]
    close(system.evaluate_ode(x), expected(x))


def test_a_value_edited_in_place_counts(x):
    system = system_of(zoo.pendulum(), specifieds=dict(VALUES))
    system.evaluate_ode(x)
    system.specifieds[F] = 9.0
    close(system.evaluate_ode(x), expected(x, {F: 9.0}))


def test_an_array_edited_in_place_counts(x):
    values = np.array([-0.7, 1.1, 0.3])
    system = system_of(zoo.pendulum(), specifieds={"symbols": (T1, T2, F), "values": values})
    system.evaluate_ode(x)
    system.specifieds["values"][2] = 9.0
    close(system.evaluate_ode(x), expected(x, {F: 9.0}))


def test_specifieds_default_to_zero(x):
    system = system_of(zoo.pendulum(), specifieds={T1: -0.7})
    close(system.evaluate_ode(x), expected(x, {F: 0.0, T2: 0.0}))


def test_no_specifieds_at_all_are_zeros(x):
    system = system_of(zoo.pendulum(), specifieds=None)
    close(system.evaluate_ode(x), expected(x, dict.fromkeys(VALUES, 0.0)))


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
def test_a_function_receives_state_and_time(generator, x):
    specifieds = {F: lambda x, t: -3 * x[0] * t, (T2, T1): lambda x, t: np.array([x[4], t**2])}
    system = system_of(zoo.pendulum(), specifieds=specifieds)
    system.generate_ode_function(generator=generator)
    values = {F: -3 * x[0] * 0.8, T2: x[4], T1: 0.64}
    close(system.evaluate_ode(x, 0.8), expected(x, values, 0.8))


def test_a_function_of_all_specifieds_receives_state_and_time(x):
    specifieds = {"symbols": (T2, F, T1), "values": lambda x, t: np.array([x[4], t, x[0]])}
    system = system_of(zoo.pendulum(), specifieds=specifieds)
    values = {T2: x[4], F: 0.8, T1: x[0]}
    close(system.evaluate_ode(x, 0.8), expected(x, values, 0.8))


def test_derivatives_of_a_prescribed_motion_have_their_own_values():
    model = zoo.shaken()
    y = me.dynamicsymbols("y")
    x, t = model.sample(2)
    specifieds = {
        y: lambda x, t: np.sin(3 * t),
        y.diff(zoo.T): lambda x, t: 3 * np.cos(3 * t),
        y.diff(zoo.T, 2): lambda x, t: -9 * np.sin(3 * t),
    }
    numbers = {k: float(v(x, t)) for k, v in specifieds.items()}
    system = system_of(model, specifieds=specifieds)
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t, numbers))


def test_switching_the_format_between_two_integrations_needs_no_call():
    times = np.linspace(0.0, 0.5, 4)
    system = system_of(zoo.pendulum(), specifieds={F: lambda x, t: np.sin(t), T1: 0.2}, times=times)
    first = system.integrate()
    system.specifieds = {
        "symbols": (T2, T1, F),
        "values": lambda x, t: np.array([0.0, 0.2, np.sin(t)]),
    }
    close(system.integrate(), first, 1e-12)
    system.specifieds = {(F, T1): lambda x, t: [np.sin(t), 0.2]}
    close(system.integrate(), first, 1e-12)


# what is refused

REFUSED = {
    "an unknown symbol": ({me.dynamicsymbols("nope"): 1.0}, "nope"),
    "an unknown symbol in a tuple": ({(F, me.dynamicsymbols("nope")): [1.0, 2.0]}, "nope"),
    "a symbol twice": ({F: 1.0, (T1, F): [1.0, 2.0]}, r"F\(t\)"),
    "a symbol twice in a tuple": ({(F, F): [1.0, 2.0]}, r"F\(t\)"),
    "a missing symbol in format 2": ({"symbols": (F, T1), "values": [1.0, 2.0]}, r"T2\(t\)"),
    "an unknown symbol in format 2": (
        {"symbols": (F, T1, T2, me.dynamicsymbols("nope")), "values": np.ones(4)},
        "nope",
    ),
    "a symbol twice in format 2": ({"symbols": (F, T1, T2, T1), "values": np.ones(4)}, r"T1\(t\)"),
    "a wrong length": ({(F, T1): np.ones(3)}, r"F\(t\).*3|3.*F\(t\)"),
    "an array for one symbol": ({F: np.ones(2)}, r"F\(t\)"),
    "a wrong length in format 2": (
        {"symbols": (F, T1, T2), "values": np.ones(2)},
        r"specifieds.*\(3,\).*\(2,\)",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_the_next_evaluation_refuses_what_was_put_in_place(name):
    specifieds, message = REFUSED[name]
    system = system_of(zoo.pendulum(), specifieds={})
    system.evaluate_ode()
    system.specifieds.update(specifieds)
    with pytest.raises(ValueError, match=message):
        system.evaluate_ode()


@pytest.mark.parametrize(
    "specifieds",
    [{"symbols": (F, T1, T2)}, {"values": np.ones(3)}],
    ids=["no values", "no symbols"],
)
def test_half_of_format_2_is_refused(specifieds):
    with pytest.raises(ValueError, match=r"symbols|values"):
        system_of(zoo.pendulum(), specifieds=specifieds)


def test_a_function_with_the_time_first_is_told_how_it_is_called():
    told = r"F\(t\) has the arguments \(t, x\), but it is called as g\(x, t\), with the state first"
    for function, error in (
        (lambda t, x: -2.0 * x[0], TypeError),
        (lambda t, x: np.sin(t), ValueError),
    ):
        with pytest.warns(PyDyUserWarning, match=told):
            system = system_of(zoo.pendulum(), specifieds={F: function})
        with pytest.raises(error, match=told):
            system.evaluate_ode()

    def own(t, x):
        raise OwnError("mine")

    with pytest.warns(PyDyUserWarning, match=told):
        system = system_of(zoo.pendulum(), specifieds={F: own})
    with pytest.raises(OwnError, match="mine"):
        system.evaluate_ode()
    system.specifieds = {F: lambda state, time: -2.0 * state[0]}
    assert np.isfinite(system.evaluate_ode()).all()


class OwnError(Exception):
    pass


def failing(x, t):
    raise OwnError("mine")


def text_of(info):
    return "\n".join([str(info.value), *getattr(info.value, "__notes__", [])])


@pytest.mark.parametrize(
    "specifieds",
    [{F: failing}, {(F, T1): failing}, {"symbols": (T1, F, T2), "values": failing}],
    ids=["one", "tuple", "format 2"],
)
def test_the_error_of_a_specified_function_shows_with_its_name_and_time(specifieds):
    system = system_of(zoo.pendulum(), specifieds=specifieds)
    with pytest.raises(OwnError, match="mine") as info:
        system.evaluate_ode(np.zeros(6), 1.375)
    assert "F(t)" in text_of(info)
    assert "1.375" in text_of(info)


def test_the_error_of_a_specified_function_comes_out_of_integrate():
    def late(x, t):
        if t > 0.5:
            raise OwnError("mine")
        return 0.0

    system = system_of(zoo.pendulum(), specifieds={F: late}, times=[0.0, 1.0])
    with pytest.raises(OwnError, match="mine") as info:
        system.integrate()
    assert "F(t)" in text_of(info)


@pytest.mark.parametrize(
    "specifieds",
    [
        {F: lambda x, t: np.ones(2)},
        {(F, T1): lambda x, t: np.ones(3)},
        {(F, T1): lambda x, t: 1.0},
        {"symbols": (T1, F, T2), "values": lambda x, t: np.ones(2)},
        {F: lambda x, t: None},
        {F: lambda x, t: "a"},
    ],
    ids=["two for one", "three for two", "one for two", "format 2", "None", "text"],
)
def test_a_specified_function_of_the_wrong_shape_is_named(specifieds):
    system = system_of(zoo.pendulum(), specifieds=specifieds)
    with pytest.raises((ValueError, TypeError), match=r"F\(t\)"):
        system.evaluate_ode(np.zeros(6), 1.375)


@pytest.mark.parametrize("solver", ["odeint", "dop853"])
def test_a_specified_function_that_writes_into_its_state_changes_nothing_else(solver, x):
    def writes(x, t):
        x[0] -= 1.5
        return -x[0]

    times, first = np.linspace(0.0, 0.5, 3), zoo.pendulum().states[0]
    right = system_of(zoo.pendulum(), specifieds={F: 1.5 - first}, times=times, ode_solver=solver)
    system = system_of(zoo.pendulum(), specifieds={F: writes}, times=times, ode_solver=solver)
    close(system.integrate(), right.integrate(), 1e-6)
    given = x.copy()
    system.evaluate_ode(given)
    np.testing.assert_array_equal(given, x)


def test_an_array_over_time_is_refused_with_the_way_to_give_it():
    from pydy.models import n_link_pendulum_on_cart

    system = n_link_pendulum_on_cart(1)
    with pytest.raises(ValueError, match=r"F.t. must be a real number, .*\(11,\).*SampledInput"):
        system.specifieds = {"F": np.zeros(11)}
    with pytest.raises(ValueError, match=r"F.t. must be a real number, .*\(3,\).*SampledInput"):
        system.specifieds = {"F": _Table()}


class _Table:
    """Converts to an array, as tables of pandas do."""

    def __array__(self, dtype=None, copy=None):
        return np.zeros(3)


@pytest.mark.parametrize("value", ["sin(t)", None, 2.0 + 0.0j])
def test_what_is_no_number_is_refused_with_what_else_is_taken(value):
    from pydy.models import n_link_pendulum_on_cart

    system = n_link_pendulum_on_cart(1)
    message = r"F.t. must be a real number, .* functions g\(x, t\), SymPy expressions and Sampled"
    with pytest.raises(ValueError, match=message):
        system.specifieds = {"F": value}


@pytest.mark.parametrize("deeper", [False, True])
def test_a_function_that_evaluates_its_own_system_is_one_short_error(deeper):
    system = n_link_pendulum_on_cart(1)
    system.times = np.linspace(0.0, 1.0, 3)

    def control(x, t):
        return system.evaluate_ode(x, t)[0] if deeper else system.bias(x[:2], x[2:])[1]

    system.specifieds = {"F": control}
    with pytest.raises(
        RecursionError, match=r"evaluates its own System.*a second System"
    ) as caught:
        system.simulate()
    assert len(caught.traceback) < 50


def test_a_function_that_recurses_by_itself_is_not_blamed_on_the_system():
    def endless(x, t):
        return endless(x, t)

    system = n_link_pendulum_on_cart(1)
    system.specifieds = {"F": endless}
    with pytest.raises(RecursionError, match="maximum recursion depth"):
        system.evaluate_ode()
