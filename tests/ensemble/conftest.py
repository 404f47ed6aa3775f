"""What the tests of engines compare with."""

import pytest

from zoo.ensemble_cases import pendulum, random_values


@pytest.fixture(scope="module")
def reference():
    """A System, what varies, and the results of one thread."""
    system = pendulum()
    values = random_values(system, 100)
    return system, values, system.integrate_ensemble(**values, workers=1)
