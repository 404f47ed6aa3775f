"""Samples in blocks on threads, also where the system starts few of them, or none."""

from threading import Thread

import numpy as np
import pytest

from pydy.ensemble import engine
from pydy.ensemble.model import EnsembleModel
from pydy.ensemble.work import Work
from pydy.models import multi_mass_spring_damper
from zoo.ensemble_cases import runaway


@pytest.fixture
def few_threads(monkeypatch):
    """Let the named number of threads be alive at once."""

    def limit(number):
        start, alive = Thread.start, []

        def limited(thread):
            alive[:] = [other for other in alive if other.is_alive()]
            if len(alive) >= number:
                raise RuntimeError("can't start new thread")
            start(thread)
            alive.append(thread)

        monkeypatch.setattr(Thread, "start", limited)

    return limit


@pytest.mark.parametrize("number", [0, 1])
def test_an_ensemble_runs_on_the_threads_that_there_are(few_threads, number):
    system, x, v, _ = runaway()
    start = {x: 0.0, v: np.linspace(0.1, 0.2, num=200)}
    expected = system.integrate_ensemble(initial_conditions=start, max_steps=1000)
    few_threads(number)
    found = system.integrate_ensemble(initial_conditions=start, max_steps=1000, workers=3)
    np.testing.assert_array_equal(found[str(x.func.__name__)], expected[str(x.func.__name__)])


@pytest.mark.parametrize(("brief", "blocks"), [(0.0, 25), (np.inf, 9)])
def test_quick_samples_that_come_one_by_one_come_in_larger_blocks(monkeypatch, brief, blocks):
    called = []
    own = Work.__call__
    monkeypatch.setattr(Work, "__call__", lambda *a: called.append(1) or own(*a))
    monkeypatch.setattr(engine, "BRIEF", brief)
    monkeypatch.setattr(engine, "_processors", lambda: 2)
    monkeypatch.setattr(EnsembleModel, "in_lanes", False)
    system = multi_mass_spring_damper(1)
    system.ode_solver, system.times = "radau", [0.0, 1.0]
    x = np.linspace(0.1, 0.2, 200)
    found = system.integrate_ensemble(initial_conditions={system.coordinates[0]: x})
    assert len(called) == blocks
    first = system.states[0]
    system.initial_conditions = {first: x[7]}
    np.testing.assert_array_equal(found["x0"].values[7], system.integrate()[:, 0])
