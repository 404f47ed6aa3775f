"""Measures whichever pydy its environment has: the released 0.9.4, or this project's."""

from __future__ import annotations

import os
import tempfile
import time
import warnings
from typing import Any

import numpy as np
from harness.problems import Problem, drop_auxiliary_speeds, problem
from harness.serve import Repeated, in_child, serve, time_of
from harness.ways import order_of_constants, way_of

import pydy
from pydy.system import System

RELEASED = pydy.__version__ == "0.9.4"


class Session:
    """One model, and what was generated for it."""

    def __init__(self) -> None:
        self.problem: Problem
        self.rhs: Repeated

    def load(self, name: str) -> str:
        """Derive the equations; returns what had to be changed for this pydy to take them."""
        self.problem = problem(name)
        if RELEASED and self.problem.kane._uaux:
            try:
                in_child(lambda: self.system().generate_ode_function())
            except RuntimeError as error:
                drop_auxiliary_speeds(self.problem.kane)
                return f"fails as it is ({error}); run with its auxiliary speeds set to zero"
        return ""

    def system(self) -> System:
        """Return a System that has generated nothing yet."""
        return System(
            self.problem.kane,
            constants=self.problem.constants,
            initial_conditions=self.problem.initial_conditions,
            times=np.linspace(0.0, 10.0, 1001),
        )

    def integrate(self, state: str) -> dict[str, float]:
        """Time the first and the second `integrate()` of a fresh System.

        Parameters
        ----------
        state : {"warm", "process", "machine"}
            Whether another model was simulated before in the same process, before in another
            process that left its cache on disk, or never.
        """

        def measure() -> dict[str, float]:
            if state == "warm":
                _warm_up()
            result: dict[str, Any] = {}

            def first() -> None:
                result["system"] = self.system()
                result["system"].integrate()

            times = {"first": time_of(first)}
            if state == "warm":
                times["second"] = time_of(result["system"].integrate)
            return times

        if state != "process":
            return in_child(measure)
        with tempfile.TemporaryDirectory() as cache:
            in_child(lambda: _warm_up(cache))
            return in_child(measure, cache)

    def prepare_integration(self, solver: str | None, tolerance: float) -> list[float]:
        """Integrate once by a solver, None for the default; returns the states at 0.1 s."""
        system = self.system()
        if RELEASED:
            system.generate_ode_function(generator="cython")
        if solver is not None:
            system.ode_solver = solver
        self.again = Repeated(lambda: system.integrate(rtol=tolerance, atol=tolerance))
        return list(system.integrate(rtol=tolerance, atol=tolerance)[10])

    def integrate_again(self) -> float:
        """Return the seconds of one `integrate()` as it was prepared."""
        return self.again()

    def generate(self, generator: str) -> float:
        """Time the generation of the right-hand side."""

        def measure() -> float:
            _warm_up()
            system = self.system()
            return time_of(lambda: system.generate_ode_function(generator=generator))

        return in_child(measure)

    def prepare(self, generator: str) -> list[float]:
        """Generate the right-hand side; returns the derivatives of one state."""
        system = self.system()
        rhs = system.generate_ode_function(generator=generator)
        if not RELEASED:
            system.model.compiled("rates").link()
        values = {s.name: v for s, v in system.constants.items()}
        p = np.array([values[name] for name in order_of_constants(rhs)])
        r = np.zeros(len(system.specifieds_symbols))
        x = np.array([0.1 + 0.02 * k for k in range(len(system.states))])
        self.rhs = Repeated(lambda: rhs(x, 0.0, r, p))
        value = rhs(x, 0.0, r, p)
        return list(value[0] if isinstance(value, tuple) else value)

    def call(self) -> float:
        """Return the seconds of one call of the right-hand side."""
        return self.rhs()

    def prepare_way(self, way: str, generator: str) -> list[float]:
        """Prepare one of `harness.ways.WAYS`; returns numbers to compare."""
        system = self.system()
        measured, compared = way_of(way, self.problem, system, generator)
        values = compared()
        if not RELEASED:
            time.sleep(1.0)  # what is measured is the best code, which is made in a quiet moment
        self.way = Repeated(measured)
        return list(np.ravel(values[0] if isinstance(values, tuple) else values))

    def call_way(self) -> float:
        """Return the seconds of one call as it was prepared."""
        return self.way()


def _warm_up(cache: str | None = None) -> None:
    """Load and initialise whatever a first use does, on another model than the one measured."""
    if cache is not None:
        os.environ["PYDY_CACHE_DIR"] = cache
    small = problem("2")
    system = System(small.kane, times=np.linspace(0.0, 0.1, 3))
    system.integrate()


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    session = Session()
    names = (
        *("load", "integrate", "generate", "prepare", "call"),
        *("prepare_integration", "integrate_again", "prepare_way", "call_way"),
    )
    serve({name: getattr(session, name) for name in names})
