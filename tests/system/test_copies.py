"""Copies and pickles of a System and of its function."""

import copy
import pickle
import subprocess
import sys

import numpy as np
import pytest
import sympy as sm

import zoo
from oracles.oracle import oracle
from zoo.cases import close, system_of

GENERATORS = ["llvm", "lambdify"]
NAMES = ["pendulum", "track", "disc_contact", "timed", "shaken"]
WAYS = {
    "deepcopy": copy.deepcopy,
    "pickle": lambda s: pickle.loads(pickle.dumps(s)),
    "old pickle": lambda s: pickle.loads(pickle.dumps(s, protocol=2)),
}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", NAMES)
def test_a_system_survives(name, way):
    model = zoo.MODELS[name]()
    system = system_of(model, times=[0.0, 0.1])
    twin = WAYS[way](system)
    x, t = model.sample()
    wide = [*x, *[0.1] * system.num_auxiliaries]
    close(twin.evaluate_ode(wide, t), system.evaluate_ode(wide, t), 1e-14)
    close(twin.integrate(), system.integrate(), 1e-14)


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("way", WAYS)
def test_a_system_survives_after_it_has_generated(way, generator):
    model = zoo.track()
    system = system_of(model, times=[0.0, 0.1], outputs={sm.Symbol("a"): model.states[0] ** 2})
    system.generate_ode_function(generator=generator)
    expected = system.integrate(), system.evaluate_outputs()
    twin = WAYS[way](system)
    close(twin.integrate(), expected[0], 1e-14)
    close(twin.evaluate_outputs(), expected[1], 1e-14)
    assert [str(s) for s in twin.outputs_symbols] == [str(s) for s in system.outputs_symbols]


@pytest.mark.parametrize("way", [*WAYS, "copy"])
def test_a_copy_is_independent(way):
    model = zoo.timed()
    system = system_of(model, times=[0.0, 0.1])
    twin = {**WAYS, "copy": copy.copy}[way](system)
    twin.times[1] = 0.2
    assert system.times[1] == 0.1
    twin.constants[sm.Symbol("k")] = 9.0
    twin.initial_conditions[system.states[0]] = 0.5
    assert system.constants == model.constants
    assert system.initial_conditions == {}
    x, t = model.sample()
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t))
    close(twin.evaluate_ode(x, t), oracle(model).xdot(x, t, {sm.Symbol("k"): 9.0}))


def test_a_shallow_copy_evaluates_alike():
    model = zoo.timed()
    system = system_of(model)
    x, t = model.sample()
    close(copy.copy(system).evaluate_ode(x, t), oracle(model).xdot(x, t))


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("way", [*WAYS, "copy"])
def test_the_generated_function_survives(way, generator):
    model = zoo.timed()
    x, t = model.sample()
    rhs = system_of(model).generate_ode_function(generator=generator)
    twin = {**WAYS, "copy": copy.copy}[way](rhs)
    close(twin(x, t, model.constants), oracle(model).xdot(x, t))
    assert twin.__name__ == "rhs"
    assert twin.__doc__ == rhs.__doc__


SCRIPT = """
import pickle, sys
import numpy as np
with open(sys.argv[1], "rb") as f:
    thing, arguments, expected = pickle.load(f)
got = thing.evaluate_ode(*arguments) if hasattr(thing, "evaluate_ode") else thing(*arguments)
np.testing.assert_allclose(got, expected, rtol=1e-13)
print("as expected")
"""


@pytest.mark.parametrize("kind", ["system", "function"])
def test_a_pickle_lands_in_another_process(kind, tmp_path):
    model = zoo.timed()
    x, t = model.sample()
    system = system_of(model)
    rhs = system.generate_ode_function()
    p = np.array([model.constants[s] for s in system.constants_symbols])
    thing, arguments = (system, (x, t)) if kind == "system" else (rhs, (x, t, p))
    path = tmp_path / "thing.pickle"
    path.write_bytes(pickle.dumps((thing, arguments, oracle(model).xdot(x, t))))
    run = subprocess.run(
        [sys.executable, "-c", SCRIPT, str(path)], capture_output=True, text=True, check=False
    )
    assert run.stdout.strip() == "as expected", run.stderr


def test_a_callable_of_the_users_is_kept_by_deepcopy():
    system = system_of(
        zoo.pendulum(), specifieds={next(iter(zoo.pendulum().specifieds)): lambda x, t: 2.0}
    )
    x, t = zoo.pendulum().sample()
    close(copy.deepcopy(system).evaluate_ode(x, t), system.evaluate_ode(x, t), 1e-14)
