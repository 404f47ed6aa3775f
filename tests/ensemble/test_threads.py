"""Ensembles where the system starts few threads, or none."""

from threading import Thread

import numpy as np
import pytest

from ensemble_cases import runaway


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
