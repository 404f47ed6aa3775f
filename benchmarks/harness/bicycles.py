"""An ensemble of bicycles with constraints and events, and a model of its time on a cluster."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil
from typing import Any

import numpy as np
import sympy as sm

from pydy.examples import whipple_bicycle
from pydy.solvers import Event
from pydy.system import System

TIMES = np.linspace(0.0, 3.0, num=13)
FALLEN = 1.0  # rad of lean


class Bicycles:
    """Carvallo-Whipple bicycles with random speeds, roll rates and riders, hands off.

    All motions are projected onto the holonomic and the five velocity constraints. The bicycle
    passes upright (counted) and falls (terminal).
    """

    def __init__(self) -> None:
        self.bicycle = bicycle = whipple_bicycle.derive()
        self.system = System(
            bicycle.definition,
            constants=whipple_bicycle.benchmark_parameters(bicycle),
            times=TIMES,
            ode_solver="dop853",
            initial_conditions=whipple_bicycle.equilibrium(bicycle, 5.0),
            outputs={sm.Symbol("offset"): sm.Abs(bicycle["y"])},
        )
        lean = bicycle["phi"]
        upright = Event(lean, name="upright")
        fallen = Event(lean**2 - FALLEN**2, terminal=True, name="fallen")
        self.options: dict[str, Any] = {
            "constraints": "project",
            "events": [upright, fallen],
            "reduce": [("max", lean), ("max", "offset"), ("events", 1)],
            "rtol": 1e-6,
            "atol": 1e-8,
        }

    def values(self, count: int) -> dict[str, Any]:
        """Return the values of so many samples; their dependent speeds satisfy the constraints."""
        rng, bicycle = np.random.default_rng(0), self.bicycle
        speeds, radii = rng.uniform(3.0, 7.0, count), whipple_bicycle.BENCHMARK
        return {
            "initial_conditions": {
                bicycle["u_x"]: speeds,
                bicycle["omega_R"]: -speeds / radii["r_R"],
                bicycle["omega_F"]: -speeds / radii["r_F"],
                bicycle["u_phi"]: rng.normal(0.0, 0.6, count),
            },
            "constants": {bicycle["m_B"]: rng.uniform(60.0, 110.0, count)},
        }

    def run(self, count: int, **how: Any) -> Any:
        """Return the Dataset of the first samples."""
        return self.system.integrate_ensemble(**self.values(count), **self.options, **how)

    def compute(self, count: int, **how: Any) -> dict[str, float]:
        """Return what is asked of the first samples."""
        return computed(self.run(count, **how))


def computed(dataset: Any) -> dict[str, float]:
    """Return what is asked of all samples, computed at once where it is lazy."""
    import dask

    return {name: float(value) for name, value in dask.compute(reduced(dataset))[0].items()}


def reduced(dataset: Any) -> dict[str, Any]:
    """Return what is asked of all samples: means, maxima and counts, lazy if the Dataset is."""
    return {
        "mean_lean": dataset.phi_max.mean(),
        "most_offset": dataset.offset_max.max(),
        "finished": (dataset.status == 0).sum(),
        "fallen": dataset.fallen_count.sum(),
        "upright": dataset.upright_count.sum(),
        "steps": dataset.steps.mean(),
    }


@dataclass(frozen=True)
class Costs:
    """Measured costs of an ensemble on a cluster, in seconds of processor time."""

    trajectory: float  # on a worker
    serial: float  # on the client, for each trajectory: values read, checked, and cut into blocks
    block: float  # on the client and the scheduler, for each block
    task: float  # on a worker, for each block
    start: float  # of each worker: imports, and the code that it compiles or loads

    def seconds(self, count: int, block: int, cores: int) -> float:
        """Return the time of `count` trajectories.

        T = start + count serial + blocks overhead + ⌈blocks / cores⌉ (block trajectory + task): the
        client works while no worker does, which is an upper bound, and the last blocks end
        together.
        """
        blocks = ceil(count / block)
        rounds = ceil(blocks / cores)
        own = count / blocks * self.trajectory + self.task
        return self.start + count * self.serial + blocks * self.block + rounds * own

    def efficiency(self, count: int, block: int, cores: int) -> float:
        """Return the share of the cores' time that integrates."""
        return count * self.trajectory / (cores * self.seconds(count, block, cores))

    def most_cores(self, block: int) -> float:
        """Return how many cores the client and the scheduler keep busy with such blocks."""
        return (block * self.trajectory + self.task) / (block * self.serial + self.block)
