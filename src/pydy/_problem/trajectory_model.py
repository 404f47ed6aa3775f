"""What labelled motions take from a Problem: the `model` of a Trajectory."""

from __future__ import annotations

from functools import partial
from operator import attrgetter
from typing import Any

import numpy as np

from pydy._problem.assumption_checks import AssumptionChecks
from pydy._problem.problem import Problem, evaluate_specifieds
from pydy.inputs import jumps_of
from pydy.trajectory import Columns, Trajectory


class TrajectoryModel:
    """The values of a Problem's equations at times (m,) and states (m, n) of a motion."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem

    def specifieds(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the specifieds, shape (m, s)."""
        return evaluate_specifieds(self.problem, times, states)

    def derivatives(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the derivatives of the states, shape (m, n)."""
        return self.problem.at(times, states).rates()

    def outputs(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the outputs, shape (m, o)."""
        return self.problem.at(times, states).outputs()

    def energy(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return kinetic, potential and total energy, shape (m, 3)."""
        problem = self.problem
        return problem.at(times, states).evaluate(problem.model.energies.kernel(problem.code))

    def jumps(self) -> np.ndarray:
        """Return the times at which sampled inputs jump."""
        return jumps_of(self.problem.inputs.sampled)[:, 0]

    def scene(self, *visuals: Any, **options: Any) -> Any:
        """Return a scene that shows the bodies, or some visuals; see `System.scene`."""
        from pydy._problem.scene import make_scene

        problem = self.problem
        assembly = partial(attrgetter("model.code.assembly"), problem)
        return make_scene(problem.definition, problem.constants, assembly, visuals, options)

    def label(self, times: np.ndarray, states: np.ndarray, **more: Any) -> Trajectory:
        """Return states at some times with their names, outputs and specifieds."""
        problem = self.problem
        if problem.definition.assumes_motions:
            AssumptionChecks(problem).motion(times, states)
        latest = problem.model.code.latest
        columns = latest.get("columns")
        if columns is None:
            columns = latest["columns"] = Columns(problem.definition.symbols_by_kind)
        return Trajectory(
            times,
            states,
            columns,
            outputs=self.outputs(times, states),
            specifieds=self.specifieds(times, states),
            constants=problem.constants,
            model=self,
            **more,
        )
