"""Compiled code that a System keeps between calls: other expressions are never taken for it."""

from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event


def test_other_events_and_another_energy_are_compiled_anew():
    system = multi_mass_spring_damper()
    system.ode_solver, system.times = "dop853", [0.0, 3.0]
    system.initial_conditions = {"x0": 1.0}
    x = system.coordinates[0]
    for height in (0.5, 0.2, 0.5):
        (record,) = system.simulate(events=[Event(x - height)]).events
        assert abs(record.before[0] - height) < 1e-6
    for factor in (1.0, 3.0):
        system.potential_energy = factor * x**2
        assert system.evaluate_energy().potential == factor
