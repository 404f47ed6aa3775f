"""Nothing depends on the order of sets or dicts."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import sympy as sm

import zoo
from cases import system_of

SCRIPT = """
import numpy as np, sympy as sm, zoo
from cases import system_of
for name in ("pendulum", "shaken", "disc_contact", "track"):
    model = zoo.MODELS[name]()
    system = system_of(model, times=[0.0, 0.3], outputs={sm.Symbol("a"): model.states[0] ** 2})
    x = system.integrate()
    print(system.constants_symbols, system.specifieds_symbols, system.states, system.constraints)
    print(system.evaluate_ode_function.__doc__)
    print([v.hex() for v in x.ravel()], [v.hex() for v in system.evaluate_outputs(x).ravel()])
"""


def test_another_hash_seed_changes_no_bit():
    paths = [p for p in sys.path if p] + [str(Path(zoo.__file__).parent)]
    said = []
    for seed in ("1", "2"):
        env = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(paths)}
        run = subprocess.run(
            [sys.executable, "-c", SCRIPT], env=env, capture_output=True, text=True, check=False
        )
        assert run.returncode == 0, run.stderr
        said.append(run.stdout)
    assert said[0] == said[1]


@pytest.mark.filterwarnings("ignore:The initial conditions do not satisfy the constraints")
@pytest.mark.parametrize("name", ["pendulum", "disc_contact"])
def test_the_order_of_dict_entries_changes_nothing(name):
    model = zoo.MODELS[name]()

    def trajectory(order):
        return system_of(
            model,
            times=np.linspace(0.0, 0.5, 4),
            constants=dict(order(list(model.constants.items()))),
            specifieds=dict(order(list(model.specifieds.items()))),
            initial_conditions=dict(order([(s, 0.1 * i) for i, s in enumerate(model.states)])),
            outputs={sm.Symbol("a"): model.states[0]},
        ).integrate()

    np.testing.assert_array_equal(trajectory(list), trajectory(lambda items: items[::-1]))
