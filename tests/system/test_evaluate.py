"""evaluate_ode and its sisters: states, times, shapes and overrides."""

import os
import sys

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from oracles.oracle import oracle
from pydy import System
from pydy.errors import PyDyUserWarning, SingularMatrixError
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper
from zoo import inertial_frame
from zoo.cases import close, system_of, wide

GENERATORS = ["llvm", "lambdify"]
A = sm.Symbol("a")


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("name", zoo.MODELS)
def test_evaluate_ode_agrees_with_sympy(name, generator):
    model = zoo.MODELS[name]()
    system = system_of(model)
    system.generate_ode_function(generator=generator)
    n = len(model.states)
    for seed in range(3):
        x, t = model.sample(seed)
        got = system.evaluate_ode(wide(system, x), t)
        close(got[:n], oracle(model).xdot(x, t))


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("name", zoo.MODELS)
def test_a_sweep_equals_its_rows(name, generator):
    model = zoo.MODELS[name]()
    system = system_of(model)
    system.generate_ode_function(generator=generator)
    xs, ts = model.sample(1, 11)
    xs = wide(system, xs)
    rows = [system.evaluate_ode(x, t) for x, t in zip(xs, ts, strict=True)]
    close(system.evaluate_ode(xs, ts), rows, 1e-12)


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("m", [1, 2, 7, 8, 9, 100])
def test_a_sweep_of_any_length_equals_its_rows(m, generator):
    model = zoo.track()
    system = system_of(model, outputs={A: model.states[0] * model.states[3]})
    system.generate_ode_function(generator=generator)
    xs, ts = model.sample(2, m)
    for method in ("evaluate_ode", "evaluate_outputs"):
        rows = [getattr(system, method)(x, t) for x, t in zip(xs, ts, strict=True)]
        close(getattr(system, method)(xs, ts), rows, 1e-12)


@pytest.mark.parametrize("method", ["evaluate_ode", "evaluate_outputs"])
def test_a_sweep_calls_specified_functions_at_every_row(method):
    model = zoo.pendulum()
    force = me.dynamicsymbols("F")
    seen = []

    def push(x, t):
        seen.append((np.array(x), float(t)))
        return t * x[1]

    system = system_of(model, specifieds={force: push}, outputs={A: force**2})
    xs, ts = model.sample(3, 5)
    rows = [getattr(system, method)(x, t) for x, t in zip(xs, ts, strict=True)]
    seen.clear()
    close(getattr(system, method)(xs, ts), rows, 1e-12)
    close([t for _, t in seen], ts)
    close([x for x, _ in seen], xs)


def test_a_sweep_may_have_no_rows():
    assert system_of(zoo.timed()).evaluate_ode(np.zeros((0, 2)), []).shape == (0, 2)


@pytest.mark.parametrize(
    "kind",
    [
        lambda x: x.tolist(),
        lambda x: tuple(x),
        lambda x: np.repeat(x, 2)[::2],
        lambda x: np.asarray(x, dtype=object),
    ],
    ids=["list", "tuple", "strided", "objects"],
)
def test_a_state_may_be_any_array_like(kind):
    model = zoo.timed()
    x, t = model.sample()
    close(system_of(model).evaluate_ode(kind(x), t), oracle(model).xdot(x, t))


@pytest.mark.parametrize("dtype", [np.int64, np.int8, np.float32])
def test_a_state_may_have_another_type(dtype):
    model = zoo.timed()
    x = np.array([2, 3], dtype=dtype)
    close(system_of(model).evaluate_ode(x, 1), oracle(model).xdot([2.0, 3.0], 1.0))


def test_a_series_may_be_in_fortran_order():
    model = zoo.pendulum()
    xs, ts = model.sample(4, 6)
    system = system_of(model)
    close(system.evaluate_ode(np.asfortranarray(xs), ts), system.evaluate_ode(xs, ts), 1e-15)
    close(system.evaluate_ode(xs[::-2], ts[::-2]), system.evaluate_ode(xs, ts)[::-2], 1e-15)


def test_the_arguments_are_left_alone():
    model = zoo.pendulum()
    xs, ts = model.sample(4, 6)
    kept = xs.copy(), ts.copy()
    system_of(model).evaluate_ode(xs, ts)
    np.testing.assert_array_equal(xs, kept[0])
    np.testing.assert_array_equal(ts, kept[1])


def test_results_are_fresh_arrays():
    model = zoo.timed()
    system = system_of(model)
    first = system.evaluate_ode([0.1, 0.2], 0.3)
    kept = first.copy()
    second = system.evaluate_ode([0.7, 0.2], 0.4)
    assert not np.shares_memory(first, second)
    np.testing.assert_array_equal(first, kept)


# defaults


def test_the_default_state_is_the_initial_condition():
    model = zoo.timed()
    x, v = model.states
    system = system_of(model, initial_conditions={v: 0.7, x: 0.4})
    close(system.evaluate_ode(), oracle(model).xdot([0.4, 0.7], 0.0))


def test_the_default_time_is_the_first_of_times():
    model = zoo.timed()
    system = system_of(model, times=[1.5, 2.0], initial_conditions={model.states[0]: 0.4})
    close(system.evaluate_ode(), oracle(model).xdot([0.4, 0.0], 1.5))
    close(system.evaluate_ode([0.1, 0.2]), oracle(model).xdot([0.1, 0.2], 1.5))
    close(system.evaluate_ode(t=0.3), oracle(model).xdot([0.4, 0.0], 0.3))


def test_the_default_time_is_zero_without_times():
    model = zoo.timed()
    close(system_of(model).evaluate_ode([0.1, 0.2]), oracle(model).xdot([0.1, 0.2], 0.0))


def test_the_default_times_of_a_series_are_times():
    model = zoo.timed()
    xs, ts = model.sample(5, 4)
    system = system_of(model, times=ts)
    close(system.evaluate_ode(xs), system.evaluate_ode(xs, ts), 1e-15)


def test_the_default_times_of_a_series_are_zeros_without_times():
    model = zoo.timed()
    xs, _ = model.sample(5, 4)
    system = system_of(model)
    close(system.evaluate_ode(xs), system.evaluate_ode(xs, np.zeros(4)), 1e-15)


# shapes

METHODS = [
    "evaluate_ode",
    "evaluate_outputs",
    "evaluate_constraints",
    "evaluate_holonomic_constraints",
    "evaluate_velocity_constraints",
]


@pytest.mark.parametrize("method", METHODS)
def test_a_repeated_evaluation_builds_nothing_of_sympy(method):
    """`evaluate_constraints` made a Matrix to count its rows, two thirds of a call."""
    model = zoo.track()
    system = system_of(model)
    if method == "evaluate_outputs":
        system.outputs = {"twice": 2 * system.states[0]}
    x = model.sample(5, 10)[0]
    getattr(system, method)(x)
    entered = []
    sys.setprofile(lambda frame, *_: entered.append(frame.f_code.co_filename))
    try:
        getattr(system, method)(x)
    finally:
        sys.setprofile(None)
    names = {name for name in entered if f"{os.sep}sympy{os.sep}matrices" in name}
    assert not names


def test_a_series_of_another_length_than_times_is_refused():
    system = system_of(zoo.track(), times=[0.0, 1.0, 2.0])
    with pytest.raises(ValueError, match=r"\(4, 6\).*\(3,\)|\(3,\).*\(4, 6\)"):
        system.evaluate_ode(np.zeros((4, 6)))


# overrides


@pytest.mark.parametrize("kind", [dict, list, np.array, tuple])
def test_p_overrides_the_constants_for_this_call(kind):
    model = zoo.timed()
    x, t = model.sample()
    system = system_of(model)
    other = {s: 2 * v for s, v in model.constants.items()}
    values = other if kind is dict else kind([other[s] for s in system.constants_symbols])
    close(system.evaluate_ode(x, t, p=values), oracle(model).xdot(x, t, other))
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t))
    assert system.constants == model.constants


@pytest.mark.parametrize("kind", [dict, list, np.array, "function"])
def test_r_overrides_the_specifieds_for_this_call(kind):
    model = zoo.pendulum()
    x, t = model.sample()
    system = system_of(model)
    other = {s: 2 * v for s, v in model.specifieds.items()}
    values = [other[s] for s in system.specifieds_symbols]
    if kind is dict:
        values = other
    elif kind == "function":
        values = (lambda v: lambda x, t: np.array(v))(values)
    else:
        values = kind(values)
    close(system.evaluate_ode(x, t, r=values), oracle(model).xdot(x, t, other))
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t))


@pytest.mark.parametrize("method", METHODS)
def test_the_overrides_reach_every_evaluation(method):
    model = zoo.lifted()
    x, t = model.sample()
    twice = {s: 2 * v for s, v in model.constants.items()}
    thrice = {s: 3 * v for s, v in model.specifieds.items()}
    outputs = {A: sm.Symbol("m") * me.dynamicsymbols("s")}
    system = system_of(model, outputs=outputs)
    got = getattr(system, method)(x, t, r=thrice, p=twice)
    reference = system_of(model, constants=twice, specifieds=thrice, outputs=outputs)
    close(got, getattr(reference, method)(x, t), 1e-13)
    assert np.any(got != getattr(system, method)(x, t))


def test_names_for_messages_are_not_printed_before_there_is_one(monkeypatch):
    """SymPy takes longer to print them than the values take."""

    def never(*_):
        raise AssertionError

    monkeypatch.setattr("pydy._assembly.definition.Definition.row_names", never)
    model = zoo.timed()
    x, t = model.sample()
    close(system_of(model).evaluate_ode(x, t), oracle(model).xdot(x, t))


def test_a_table_with_its_labels_in_another_order_is_refused():
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    system = multi_mass_spring_damper(1, True)
    names, x = ["x0", "v0"], np.array([[0.5, 2.0]])
    right = system.evaluate_ode(x, np.zeros(1))
    for table in (
        pandas.DataFrame(x, columns=names),
        pandas.DataFrame(x, columns=["position", "speed"]),
        pandas.DataFrame(x),
        xarray.DataArray(x, dims=("time", "state"), coords={"state": names}),
    ):
        np.testing.assert_array_equal(system.evaluate_ode(table, np.zeros(1)), right)
    turned = x[:, ::-1]
    for table in (
        pandas.DataFrame(turned, columns=names[::-1]),
        pandas.DataFrame(turned, columns=system.states[::-1]),
        xarray.DataArray(turned, dims=("time", "state"), coords={"state": names[::-1]}),
        pandas.Series(turned[0], index=names[::-1]),
    ):
        at = 0.0 if np.ndim(table) == 1 else np.zeros(1)
        with pytest.raises(ValueError, match=r"`x` has the labels v0.*x0.* in the order x0.*v0"):
            system.evaluate_ode(table, at)
    constants = system.constants_symbols
    p = pandas.Series(1.0, index=[*reversed([*constants])])
    with pytest.raises(ValueError, match="`p` has the labels"):
        system.evaluate_ode(x[0], 0.0, p=p)


def cloud(n):
    """Particles on a line that 1/q pushes away from a wall; each reciprocal is an output."""
    q, m = me.dynamicsymbols(f"q:{n}"), sm.Symbol("m")
    N, O = inertial_frame()
    places = [O.locatenew(f"P{k}", s * N.x) for k, s in enumerate(q)]
    bodies = [me.Particle(f"b{k}", place, m) for k, place in enumerate(places)]
    loads = [(place, N.x / s) for place, s in zip(places, q, strict=True)]
    system = System(Definition(N, q, bodies=bodies, loads=loads), constants={m: 1.0})
    system.outputs = {f"y{k}": 1 / s for k, s in enumerate(q)}
    return system


def test_messages_show_a_few_of_many_states_and_names():
    system, told = cloud(40), []
    for values in (
        system.evaluate_ode,
        system.evaluate_outputs,
        system.evaluate_energy,
        lambda: system.evaluate_jacobian(of="outputs"),
    ):
        with pytest.warns(PyDyUserWarning, match="These values are not finite") as warned:
            values()
        told += [str(one.message) for one in warned]
    assert len(told) == 4
    system.constants, system.initial_conditions = {"m": 0.0}, dict.fromkeys(system.coordinates, 1.0)
    for values in (system.evaluate_ode, system.linearize):
        with pytest.raises(SingularMatrixError) as caught:
            values()
        told.append(str(caught.value))
    assert ["q11(t) = " in text and "and 68 more" in text for text in told] == [True] * 6
    system.constants, system.times = {"m": 1.0}, [0.0, 0.1]
    motion = system.simulate()
    with pytest.raises(KeyError, match="and 108 more") as missing:
        motion["z"]
    assert max(map(len, [*told, str(missing.value)])) < 600
