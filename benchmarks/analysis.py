"""What derivatives and their answers cost: Jacobians, linear models, trims, fits.

Times are of this project alone, medians of a few runs after the first; `derivatives.py`
compares with others. Counts are operations at every call.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from functools import partial
from statistics import median
from typing import Any

import numpy as np
from harness import frozen
from harness.program import assembly_of, compiled_jacobian
from harness.report import table

from pydy import System
from pydy._assembly.programs import block_program
from pydy._backends.llvm.native import LLVMBackend
from pydy.analysis import Trial
from pydy.examples import whipple_bicycle
from pydy.models import n_link_pendulum_on_cart

RUNS = 7


def timed(call: Callable[[], Any], runs: int = RUNS) -> float:
    """The median time of a call after the first, in s."""
    call()
    found = []
    for _ in range(runs):
        start = time.perf_counter()
        call()
        found.append(time.perf_counter() - start)
    return median(found)


def jacobians() -> list[list[str]]:
    """Jacobians beside their functions: counts, building, running, as ratios.

    Building is from the equations in the graph to machine code, without any cache.
    """
    rows = []
    # The routines that all share.
    compiled_jacobian(assembly_of(frozen.read("pendulum-5")), "rates", "x").link()
    for name in ("pendulum-5", "pendulum-10", "pendulum-20", "rods-3", "bicycle", "rider-bicycle"):
        assembly = assembly_of(frozen.read(name))
        times = [time.process_time()]
        kernels = []
        for make in (
            lambda made=assembly: LLVMBackend().compile(block_program(made, "rates")),
            lambda made=assembly: compiled_jacobian(made, "rates", "x"),
        ):
            kernels.append(make())
            kernels[-1].link()
            times.append(time.process_time())
        counts = [sum(k.program.operation_count["run"].values()) for k in kernels]
        rng = np.random.default_rng(0)
        n, s, c = assembly.sizes
        sample = (
            np.zeros(64), rng.normal(0.3, 0.1, (64, n)), np.zeros((1, s)), rng.uniform(1, 2, c)
        )  # fmt: skip
        runs = [timed(partial(k.evaluate, *sample), 50) for k in kernels]
        built = np.diff(times)
        rows.append(
            [
                name, str(counts[0]), f"{counts[1] / counts[0]:.1f}",
                f"{built[1] / built[0]:.1f}", f"{runs[1] / runs[0]:.1f}",
            ]
        )  # fmt: skip
    return rows


def answers() -> list[list[str]]:
    """Times of linear models, a trim and a fit."""
    made = whipple_bicycle.derive()
    bicycle = System(made.definition, constants=whipple_bicycle.benchmark_parameters(made))
    speeds = np.linspace(0.0, 10.0, num=1000)
    rows = [whipple_bicycle.equilibrium(made, v) for v in speeds]
    states = np.array([[row[s] for s in bicycle.states] for row in rows])
    moving = ["x", "theta_R", "theta_F"]
    found = [
        ("1,000 linear models of the bicycle", lambda: bicycle.linearize(states, np.zeros(1000))),
        ("their eigenvalues, equilibria found and branches followed",
         lambda: bicycle.eigenvalues({"u_x": speeds}, moving=moving)),
        ("a trim of the bicycle",
         lambda: bicycle.find_equilibrium(given={"u_x": 5.0}, moving=moving)),
    ]  # fmt: skip
    pendulum = n_link_pendulum_on_cart(2, cart_force=False)
    pendulum.ode_solver, pendulum.times = "dop853", np.linspace(0.0, 3.0, num=500)
    truth = {"m0": 2.0, "m1": 0.6, "m2": 0.4, "l0": 0.9, "l1": 0.7, "g": 9.81}
    rng = np.random.default_rng(0)
    trials = []
    for k in range(3):
        start = {"q1": np.pi + 0.2 * k + 0.3, "q2": np.pi - 0.2 * k}
        pendulum.constants, pendulum.initial_conditions = truth, start
        ride = pendulum.simulate(rtol=1e-10, atol=1e-10)
        seen = {q: ride[q] + rng.normal(0.0, 1e-3, 500) for q in ("q0", "q1", "q2")}
        trials.append(Trial(pendulum.times, seen, start, noise=1e-3))
    pendulum.constants = {**truth, "m1": 0.65, "m2": 0.37, "l0": 0.92, "l1": 0.68}
    pendulum.initial_conditions = {}
    parameters = ["m1", "m2", "l0", "l1", "q0", "u0"]
    found.append(
        ("a fit of 6 parameters to 3 × 500 samples", lambda: pendulum.fit(parameters, trials))
    )
    return [[name, f"{1e3 * timed(call):.1f} ms"] for name, call in found]


def main() -> None:
    """Print both tables."""
    os.environ["PYDY_CACHE_DIR"] = "off"
    head = ["model", "operations", "Jacobian's", "building it", "running it"]
    table("Jacobians by the states, over the function itself", head, jacobians())
    table("Answers, after the first", ["", "time"], answers())


if __name__ == "__main__":
    main()
