"""A simulation is made ready once: whatever changes before the next call is seen all the same."""

import copy
import threading

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.errors import IntegrationError, PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event, dop853
from zoo.cases import system_of

TIMES = np.linspace(0.0, 2.0, num=5)
K, W, CUT = sm.symbols("k0 w cut")
F = me.dynamicsymbols("f0")
X, V = multi_mass_spring_damper().states
EDITED = np.array([0.3])
STOP = Event(X, direction=-1, reset={V: V}, name="zero")


def forced(force=0.25, solver="dop853"):
    system = multi_mass_spring_damper(apply_external_forces=True)
    system.constants = {"k0": 4.0, "c0": 0.1}
    system.initial_conditions = {"x0": 0.5}
    system.specifieds = {F: force}
    system.times, system.ode_solver = TIMES.copy(), solver
    return system


def fourbar(solver="dop853"):
    return system_of(zoo.fourbar(), times=0.2 * TIMES, ode_solver=solver)


def edit(name, key, value):
    return lambda system: getattr(system, name).__setitem__(key, value)


def put(name, value):
    return lambda system: setattr(system, name, value)


def give(value):
    return put("specifieds", {F: value})


CHANGES = {
    "a constant": edit("constants", "k0", 5.0),
    "another constant": edit("constants", "m0", 2.0),
    "fewer constants": lambda system: system.constants.pop("c0"),
    "an integer": edit("constants", "k0", 5),
    "an initial condition": edit("initial_conditions", "x0", -0.25),
    "another initial condition": edit("initial_conditions", "v0", 1.0),
    "a specified": edit("specifieds", F, -1.0),
    "no specified": lambda system: system.specifieds.clear(),
    "a function": give(lambda x, t: np.sin(t)),
    "an expression": give(sm.sin(W * sm.Symbol("t")).subs(sm.Symbol("t"), X.args[0])),
    "samples": give(SampledInput([0.0, 2.0], [0.0, 1.0])),
    "an array": give(np.array([0.7])),
    "other times": put("times", TIMES + 1.0),
    "more times": put("times", np.linspace(0.0, 2.0, num=9)),
    "fewer times": put("times", np.array([0.0, 1.5])),
    "times edited in place": lambda system: system.times.__setitem__(2, 0.75),
    "another solver": put("ode_solver", "tsit5"),
    "an implicit one": put("ode_solver", "radau"),
    "odeint": put("ode_solver", None),
    "outputs": edit("outputs", sm.Symbol("twice"), 2 * X),
}  # fmt: skip


def results(system, **options):
    trajectory = system.simulate(**options)
    between = trajectory.at(0.5 * (trajectory.times[1:] + trajectory.times[:-1]))
    found = [trajectory.states, trajectory.outputs, trajectory.specifieds, between.states]
    return [system.integrate(**options), *found], trajectory


def alike(first, second):
    for one, other in zip(first, second, strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("solver", ["dop853", "radau", None])
@pytest.mark.parametrize("change", CHANGES)
def test_what_changes_between_two_calls_is_seen(change, solver):
    system, other = forced(solver=solver), forced(solver=solver)
    before, trajectory = results(system)
    kept = [part.copy() for part in before]
    CHANGES[change](system)
    CHANGES[change](other)
    alike(results(system)[0], results(other)[0])
    alike(before, kept)  # nothing lies in memory that the next call uses
    half = 0.5 * (trajectory.times[1:] + trajectory.times[:-1])
    np.testing.assert_array_equal(trajectory.at(half).states, kept[-1])


@pytest.mark.parametrize("solver", ["dop853", "radau", "rk4"])
def test_other_numbers_take_the_memory_of_the_call_before(solver, monkeypatch):
    system, made = forced(solver=solver), []
    prepare = type(system.ode_solver).prepare
    monkeypatch.setattr(
        type(system.ode_solver), "prepare", lambda *a, **k: made.append(1) or prepare(*a, **k)
    )
    options = {"step": 0.01} if solver == "rk4" else {"rtol": 1e-8}
    for count in (5, 9, 2, 700, 5):
        for change in (0.9, 1.1):
            system.times = np.linspace(0.0, 2.0, num=count)
            system.constants["k0"] = 4.0 * change
            options = {name: value * change for name, value in options.items()}
            alike([system.integrate(**options)], [fresh(system).integrate(**options)])
            made.pop()  # that of the fresh System
    assert len(made) == 1


def fresh(system):
    other = forced(solver=system.ode_solver)
    other.times, other.constants = system.times, dict(system.constants)
    return other


@pytest.mark.parametrize(
    "given",
    [lambda x, t: 0.1 * x[0], SampledInput([0.0, 1.0, 2.0], [0.0, 1.0, 0.0]), 0.5 * X, EDITED],
    ids=["function", "samples", "expression", "array"],
)
def test_numbers_change_beside_specifieds_of_any_kind(given):
    system, other = forced(given), forced(given)
    results(system)
    for one in (system, other):
        one.constants["k0"], one.initial_conditions["v0"] = 3.0, 0.5
    alike(results(system)[0], results(other)[0])


def test_what_a_functions_closure_and_an_array_hold_is_read_anew():
    held = {"size": 1.0}
    system = forced(lambda x, t: held["size"])
    system.integrate()
    held["size"] = 2.0
    alike([system.integrate()], [forced(2.0).integrate()])
    array = np.array([0.3])
    system.specifieds = {F: array}
    system.integrate()
    array[0] = 0.9
    alike([system.integrate()], [forced(0.9).integrate()])


OPTIONS = [
    {"rtol": 1e-4},
    {"rtol": 1e-4, "atol": 1e-4},
    {"atol": np.array([1e-3, 1e-9])},
    {"max_step": 0.01},
    {"events": [Event(X, name="zero")]},
    {"events": Event(X, direction=-1, terminal=True)},
    {"events": iter([Event(X, direction=-1, terminal=True)])},
    {"dense_output": False},
]


@pytest.mark.parametrize("options", OPTIONS, ids=lambda options: ", ".join(options))
def test_other_options_are_seen(options):
    again = {**options}
    if "events" in again and not isinstance(again["events"], (list, Event)):
        options = {"events": [Event(X, direction=-1, terminal=True)]}
    system = forced()
    system.simulate(rtol=1e-8)
    found = system.simulate(**again)
    alike([found.states], [forced().simulate(**options).states])
    alike([system.simulate(rtol=1e-8).states], [forced().simulate(rtol=1e-8).states])


def test_events_and_the_constants_in_them_are_seen():
    reset = {V: -0.9 * V}
    bounce = Event(X - CUT, reset=reset)
    system, other = forced(), forced()
    for one in (system, other):
        one.constants["cut"] = 0.1
    first = system.simulate(events=[bounce])
    alike([system.simulate(events=[bounce]).states], [first.states])
    system.constants["cut"] = other.constants["cut"] = 0.2
    moved = system.simulate(events=[bounce])
    alike([moved.states], [other.simulate(events=[bounce]).states])
    reset[V] = -0.75 * V
    edited = system.simulate(events=[bounce])
    alike([edited.states], [forced_with(0.2).simulate(events=[bounce]).states])
    assert not np.array_equal(edited.states, moved.states)


def forced_with(cut):
    system = forced()
    system.constants["cut"] = cut
    return system


@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_projected_motions_are_the_same_again(solver):
    options = {"constraints": "project", "rtol": 1e-8}
    event = {"events": [Event(fourbar().states[0] - 0.1, name="passes")]}
    for more in ({}, event):
        system, expected = fourbar(solver), results(fourbar(solver), **options, **more)
        for _ in range(3):
            found = results(system, **options, **more)
            alike(found[0], expected[0])
            assert found[1].statistics == expected[1].statistics
            assert [e.time for e in found[1].events] == [e.time for e in expected[1].events]
        name = next(s for s in system.constants if s.name.startswith("m"))
        other = fourbar(solver)
        system.constants[name] = other.constants[name] = 3.0
        alike(results(system, **options, **more)[0], results(other, **options, **more)[0])


def test_a_start_that_leaves_the_constraints_is_told_of_at_each_call():
    system = fourbar()
    for _ in range(100):  # until what is checked has been compiled
        system.integrate()
    system.initial_conditions[system.states[1]] += 0.1
    with pytest.warns(PyDyUserWarning, match=r"at t = 0.0 are .* in the holonomic constraint \d"):
        system.integrate()
    system.set_dependent_initial_conditions()
    system.integrate()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (edit("constants", "k0", np.nan), "`constants.k0.` must be finite"),
        (edit("constants", "k0", "5"), "`constants.k0.` must be a real number"),
        (edit("constants", "kk", 1.0), "`constants` has the key `kk`, which is not one of the"),
        (edit("initial_conditions", "x0", np.inf), "`initial_conditions.x0.` must be finite"),
        (edit("initial_conditions", X, 1.0), None),
        (edit("specifieds", F, np.nan), "`specifieds` for .* must be finite"),
        (edit("specifieds", "f9", 1.0), "`specifieds` has the key `f9`, which is not one of the"),
        (lambda s: s.times.__setitem__(1, np.nan), "`times` must be finite"),
        (lambda s: s.times.__setitem__(1, 9.0), "`times` must be ascending or descending, got"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("solver", ["dop853", None])
def test_values_are_checked_at_each_call(change, message, solver):
    system = forced(solver=solver)
    system.integrate()
    good = system.integrate()
    change(system)
    for _ in range(2):
        if message is None:
            assert not np.array_equal(system.integrate(), good)
            continue
        with pytest.raises(ValueError, match=message):
            system.integrate()


def test_times_beyond_samples_are_refused_at_each_call():
    system = forced(SampledInput([0.0, 2.0], [0.0, 1.0]))
    system.integrate()
    system.times[-1] = 3.0
    with pytest.raises(ValueError, match="must lie within the times of the SampledInput"):
        system.integrate()


def test_a_failure_leaves_the_next_call_as_it_was():
    system = forced()
    good = system.integrate()
    system.constants["m0"] = 0.0
    with pytest.raises((IntegrationError, np.linalg.LinAlgError)):
        system.integrate()
    system.constants["m0"] = 1.0
    alike([system.integrate()], [good])


def test_a_solver_of_the_users_may_write_into_what_it_gets():
    def spoiling(f, x0, t, args, **options):
        states = dop853(f, x0, t, args=args, **options)
        for array in (x0, t, *args):
            array[:] = 7.0
        return states

    system = forced(solver=spoiling)
    alike([system.integrate() for _ in range(3)], [forced().integrate()] * 3)


def test_copies_and_threads_share_nothing_that_counts():
    system = forced()
    system.integrate()
    twins = [copy.deepcopy(system) for _ in range(4)]
    expected = []
    for k, twin in enumerate(twins):
        twin.constants["k0"] = 1.0 + k
        alone = forced()
        alone.constants["k0"] = 1.0 + k
        expected.append(alone.integrate())
    found = [[] for _ in twins]

    def work(k):
        for _ in range(20):
            found[k].append(twins[k].integrate())

    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for k in range(4):
        alike(found[k], [expected[k]] * 20)


@pytest.mark.parametrize(
    "options",
    [
        [{"rtol": 1e-4}, {"rtol": 1e-9}, {}, {"rtol": 1e-9, "max_step": 0.01}],
        [{"atol": np.array([1e-3, 1e-9])}, {"atol": 1e-9}, {"first_step": 1e-6}],
        [{"rtol": 1e-12, "atol": 1e-12}, {"rtol": 1e-6}, {"max_steps": 10**6}],
    ],
)
@pytest.mark.parametrize("solver", ["dop853", "radau", "odeint"])
def test_other_tolerances_give_what_a_new_system_gives(solver, options):
    system = forced(solver=solver)
    if solver == "odeint":
        options = [{k: v for k, v in o.items() if k != "max_steps"} for o in options]
    for given in [*options, *reversed(options)]:
        found = system.integrate(full_output=True, **given)
        expected = forced(solver=solver).integrate(full_output=True, **given)
        np.testing.assert_array_equal(found[0], expected[0])
        for count in ("steps", "evaluations", "nst"):
            assert np.array_equal(found[1].get(count), expected[1].get(count))


@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_wrong_tolerances_are_refused_after_right_ones(solver):
    system = forced(solver=solver)
    good = system.integrate(rtol=1e-6)
    for wrong, match in (({"rtol": -1.0}, "`rtol`"), ({"atol": np.ones(5)}, r"shape \(2,\)")):
        for _ in range(2):
            with pytest.raises(ValueError, match=match):
                system.integrate(**wrong)
    with pytest.raises(TypeError, match="has no option `hmax`"):
        system.integrate(hmax=0.1)
    np.testing.assert_array_equal(system.integrate(rtol=1e-6), good)


def test_other_tolerances_reserve_no_memory_again():
    system = forced(solver="dop853")
    system.integrate(rtol=1e-6)
    (prepared, _) = system.model.latest["simulation"].free[0]
    system.integrate(rtol=1e-9)
    assert system.model.latest["simulation"].free[0][0] is prepared
