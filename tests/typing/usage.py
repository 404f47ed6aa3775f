"""What a user's typed script does; checked by mypy (strict) and pyright, and run."""

from __future__ import annotations

from typing import assert_type

import numpy as np
from sympy.physics.mechanics.models import n_link_pendulum_on_cart

from pydy.analysis import SpecialPoint
from pydy.inputs import SampledInput
from pydy.solvers import Event, StepOptions, dop853, rk4
from pydy.system import System
from pydy.trajectory import Trajectory


def by_constructor() -> System:
    """Everything that the constructor takes, in the forms that it takes."""
    kane = n_link_pendulum_on_cart(1)
    system = System(kane)
    return System(
        kane,
        constants=dict.fromkeys(system.constants_symbols, 2),
        specifieds={},
        ode_solver="dop853",
        initial_conditions={system.states[1]: 0.5},
        times=[0, 0.5, 1],
        outputs=None,
        noncontributing_forces=[],
    )


def by_attributes(system: System) -> None:
    """Attributes read narrow types and take wide ones."""
    system.times = [0, 0.5, 1]
    system.times = range(3)
    assert_type(system.times, np.ndarray)
    system.ode_solver = "dop853"
    system.ode_solver = dop853
    system.ode_solver = None
    system.constants = None
    system.constants[system.states[0]] = 1.0
    system.constants = {}
    force = next(iter(system.specifieds_symbols))
    system.specifieds = {force: SampledInput([0.0, 1.0], [0.0, 1.0])}
    system.specifieds = {force: lambda x, t: -x[0] * t}
    system.specifieds = {"symbols": (force,), "values": np.zeros(1)}
    system.specifieds = None
    system.outputs = {}
    system.noncontributing_forces = None
    number: int = system.num_states
    assert number == 4


def evaluations(system: System) -> None:
    """Evaluations return arrays of floats."""
    assert_type(system.evaluate_ode(), np.ndarray)
    assert_type(system.evaluate_ode([0, 1, 2, 3], 1), np.ndarray)
    assert_type(system.evaluate_ode(np.zeros((3, 4)), np.zeros(3), r=[1.0], p={}), np.ndarray)
    assert_type(system.evaluate_jacobian(wrt="constants", of="ode"), np.ndarray)
    assert_type(system.evaluate_jacobian_vector(np.ones(4)), np.ndarray)
    assert_type(system.evaluate_vector_jacobian(np.ones(4)), np.ndarray)
    assert_type(system.eigenvalues({"m0": [1.0, 2.0]}).eigenvalues, np.ndarray)
    assert_type(system.follow_equilibria({"m0": [1.0, 2.0]}).special, tuple[SpecialPoint, ...])
    assert system.evaluate_energy().total <= 100.0


def integrations(system: System) -> None:
    """Results follow from the options."""
    system.ode_solver = "dop853"
    tolerances = {"rtol": 1e-9, "atol": 1e-9}
    assert_type(system.integrate(**tolerances), np.ndarray)
    x = system.integrate(rtol=1e-9, atol=[1e-9, 1e-9, 1e-9, 1e-9], max_step=0.1)
    assert_type(x, np.ndarray)
    y, info = system.integrate(full_output=True)
    assert_type(y, np.ndarray)
    steps: int = info["steps"]
    assert steps > 0
    event = Event(system.states[1] - 0.4, direction=-1, terminal=True)
    trajectory = system.simulate(events=[event])
    assert_type(trajectory, Trajectory)
    assert_type(trajectory.states, np.ndarray)
    assert_type(trajectory[system.states[0]], np.ndarray)
    system.ode_solver = "odeint"
    system.integrate(mxstep=10_000)
    results = system.integrate_ensemble(
        initial_conditions={system.states[1]: [0.1, 0.2]}, rtol=1e-6, events=[event], chunks=None
    )
    assert results.sizes["sample"] == 2


def solvers() -> None:
    """Solvers can be called on their own."""

    def spring(x: np.ndarray, t: float) -> list[float]:
        return [x[1], -x[0]]

    assert_type(dop853(spring, [1, 0], [0, 1], rtol=1e-6), np.ndarray)
    states, info = dop853(spring, [1, 0], [0, 1], full_output=True)
    assert_type(states, np.ndarray)
    assert info["status"] == "finished", info
    assert_type(rk4(spring, np.array([1.0, 0.0]), [0, 1], step=0.1), np.ndarray)
    options: StepOptions = {"rtol": 1e-9, "atol": [1e-9, 1e-6], "max_step": 0.1}
    prepared = dop853.prepare(spring, [1.0, 0.0], [0.0, 1.0], **options)
    assert_type(prepared([2.0, 0.0]), np.ndarray)


def main() -> None:
    """Run it all: types that hold only on paper help nobody."""
    system = by_constructor()
    by_attributes(system)
    evaluations(system)
    integrations(system)
    solvers()


if __name__ == "__main__":
    main()
