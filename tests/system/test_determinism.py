"""Nothing depends on chance: hash seeds, the order of dicts, fallbacks, the cache, memory."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import sympy as sm

import zoo
from pydy.solvers import Event
from zoo.cases import system_of

DIGESTS = Path(zoo.__file__).parents[1] / "digests.py"


def test_every_process_gives_the_same_programs_and_bits(tmp_path):
    paths = [p for p in sys.path if p] + [str(DIGESTS.parent)]
    ways = {
        # Fallbacks are compiled where a guard is not sound.
        ("short", "forward", str(10**9)): {"PYTHONHASHSEED": "1"},
        # A busy machine; memory that nobody set is not zero.
        ("complete", "backward", "1"): {
            "PYTHONHASHSEED": "2", "MALLOC_PERTURB_": "137", "OPENBLAS_NUM_THREADS": "1",
        },
    }  # fmt: skip
    said = []
    for arguments, own in ways.items():
        env = {"PYTHONPATH": os.pathsep.join(paths), "PYDY_CACHE_DIR": str(tmp_path / "cache")}
        run = subprocess.run(
            [sys.executable, str(DIGESTS), *arguments],
            env=os.environ | env | own, capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert run.returncode == 0, run.stderr
        said.append(run.stdout.splitlines())
    assert len(said[0]) > 20
    assert said[0] == said[1]


def test_what_was_tried_before_changes_no_program():
    model = zoo.chain()

    def digests(*before):
        system = system_of(model, times=[0.0, 0.1], ode_solver="vern9")
        q, u = system.states[:3], system.states[3:]
        terms = [sm.cos(q[0]) * u[0], sm.sin(q[1]) * u[1], sm.cos(q[2]) * u[2]]
        for k in before:  # terms of the event, which would be numbered in this order
            system.specifieds = model.specifieds | {next(iter(model.specifieds)): terms[k]}
            system.integrate()
        system.specifieds = model.specifieds
        system.integrate(events=[Event(sum(terms) - 0.1)])
        kernels = system._now().model.code._kernels
        return {str(k): kernel.program.digest for k, kernel in kernels.items()}

    assert digests(2, 1) == digests()


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
