"""Sensitivities of an ensemble: Programs and numbers, which travel to wherever it is integrated."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pydy._graph.program import Program
from pydy._graph.split import SplitProgram
from pydy._kernel import Inputs, Kernel
from pydy.analysis.dependence import follow
from pydy.solvers.outcome import DEPENDENTS_NOT_GIVEN, FINISHED
from pydy.solvers.sensitivities import CompiledSensitivities, Sized, scales_of

__all__ = ["EnsembleSensitivities"]


@dataclass(frozen=True, eq=False)
class EnsembleSensitivities:
    """Derivatives of all trajectories by the same parameters.

    Attributes
    ----------
    names : tuple of str
        Of the columns that are wanted, k; the others, up to K, are zero.
    rates : SplitProgram
        The derivatives of states and columns by time.
    outputs : Program or None
        The derivatives of the outputs, shape (o, K).
    start : ndarray, shape (n, K)
        Those of the initial states; zero for the dependent ones.
    dependent : tuple of int
        The places of the initial conditions that follow from the others.
    gradients : tuple of Program
        The derivatives of the constraints by the states.
    residuals : Program or None
        The derivatives of the constraints, shape (c, K).
    unsolved : str
        What to say where the dependent ones do not follow.
    sampled : tuple of (places, SampledInput)
        The derivatives of sampled inputs by their samples, at the end of r.
    sized : tuple of Sized or None
        The parameters, where the step control looks at the sensitivities.
    jumps : tuple of Program
        What each event does.
    """

    names: tuple[str, ...]
    rates: SplitProgram
    outputs: Program | None
    start: np.ndarray
    dependent: tuple[int, ...]
    gradients: tuple[Program, ...]
    residuals: Program | None
    unsolved: str
    sampled: tuple[tuple[np.ndarray, Any], ...]
    sized: tuple[Sized, ...] | None
    jumps: tuple[Program, ...]

    @property
    def programs(self) -> list[Any]:
        """All Programs."""
        return [self.rates, self.outputs, self.residuals, *self.gradients, *self.jumps]

    @property
    def lanes(self) -> SplitProgram:
        """The derivatives by time, of the wanted columns alone."""
        rates = self.rates
        return replace(rates, directions=rates.directions[:, : len(self.names)])

    @property
    def identity(self) -> Any:
        """What tells it from others, beside the Programs."""
        samples = [(c, s.breaks, s.values, s.interpolation) for c, s in self.sampled]
        return self.names, self.start, self.dependent, samples, self.sized

    @property
    def further(self) -> int:
        """How many inputs r has at its end."""
        return sum(len(places) for places, _ in self.sampled)

    def beginning(
        self,
        x: np.ndarray,
        t: float,
        inputs: Inputs,
        p: np.ndarray,
        kernel: Callable[[Program], Kernel],
    ) -> tuple[int, np.ndarray]:
        """Return the sensitivities of one sample at the beginning, shape (n, K).

        Before them comes a code of `outcome`: whether there are any.
        """
        values = self.start.copy()
        if self.gradients:
            assert self.residuals is not None
            r, at, p = inputs(x, t)[None], np.array([t]), np.ascontiguousarray(p)
            s = self.gradients[0].num_specifieds
            rows = [kernel(g).evaluate(at, x[None], r[:, :s], p)[0][0] for g in self.gradients]
            gradient = np.concatenate(rows).reshape(-1, len(x))
            whole = np.concatenate([x, values.ravel()])
            moved = kernel(self.residuals).evaluate(at, whole[None], r, p)[0][0]
            if not follow(values, gradient, moved.reshape(len(gradient), -1), self.dependent):
                return DEPENDENTS_NOT_GIVEN, values
        return FINISHED, values

    def compiled(
        self, x: np.ndarray, r: np.ndarray, p: np.ndarray, kernel: Callable[[Program], Kernel]
    ) -> CompiledSensitivities:
        """Return what the solver needs to know of one sample."""
        n, columns = self.start.shape
        scales = None if self.sized is None else scales_of(self.sized, x, r, p, columns)

        def constraints() -> Kernel:
            assert self.residuals is not None
            return kernel(self.residuals)

        return CompiledSensitivities(
            n, columns, len(self.names), scales, lambda k: kernel(self.jumps[k]), constraints
        )
