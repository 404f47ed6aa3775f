"""The functions of a Problem that a Layer offers to its library."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from pydy._judges import warn_of_missing_derivatives
from pydy._problem import Problem
from pydy.layers.layer import KINDS, ArgumentPart, LayerFunction
from pydy.layers.motions import MotionFunction
from pydy.layers.values import BlockFunction
from pydy.solvers import Solver

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, SymbolOrName

_BLOCKS = {"ode": "rates", "outputs": "outputs"}


class LayerFunctions:
    """Creates and caches the functions of a Problem: its equations, and motions by a solver."""

    def __init__(self, problem: Problem, solver: Solver, options: dict[str, object]) -> None:
        warn_of_missing_derivatives(problem)
        self.problem, self._solver, self._options = problem, solver, options
        self._functions: dict[tuple[str, tuple[ArgumentPart, ...]], LayerFunction] = {}

    def __getstate__(self) -> dict[str, object]:
        return {
            **self.__dict__,
            "_functions": {},
        }  # functions contain locks; they are created again

    def symbols(self, group: str) -> tuple[AnySymbol, ...]:
        """Return the symbols of x, r or p."""
        symbols: tuple[AnySymbol, ...] = self.problem.definition.places[KINDS[group]].symbols
        return symbols

    def columns(self, group: str, keys: Iterable[SymbolOrName]) -> tuple[int, ...]:
        """Return the columns of x, r or p that symbols or names denote."""
        return tuple(self.problem.definition.places[KINDS[group]].columns(keys, group).tolist())

    def counts(self, kind: str, group: str, indices: tuple[int, ...]) -> tuple[int, ...]:
        """Return the number of numbers per entry: a motion's sampled input has several."""
        numbers = dict.fromkeys(indices, 1)
        if group == "r" and kind in ("simulate", "final"):
            for columns, samples in self.problem.inputs.sampled:
                numbers |= {k: len(samples.times) for k in columns.tolist() if k in numbers}
        return tuple(numbers[k] for k in indices)

    def start(self) -> np.ndarray:
        """Return the initial state."""
        x: np.ndarray = self.problem.x
        return x

    def function(self, kind: str, parts: tuple[ArgumentPart, ...]) -> LayerFunction:
        """Return the function of a Layer's method, from the cache if possible."""
        function = self._functions.get((kind, parts))
        if function is None:
            function = self._functions[kind, parts] = self._make(kind, parts)
        return function

    def _make(self, kind: str, parts: tuple[ArgumentPart, ...]) -> LayerFunction:
        problem = self.problem
        if kind == "outputs" and not problem.definition.outputs.symbols:
            raise ValueError("The system has no outputs to evaluate. Set `system.outputs`.")
        if kind in _BLOCKS:
            return BlockFunction(problem, _BLOCKS[kind], parts)
        if len(problem.settings.times) < 2:
            raise ValueError(
                f"`times` must have at least two values before `{kind}` can be called, got "
                f"{len(problem.settings.times)}. Set `system.times`, and make the layer after that."
            )
        return MotionFunction(problem, self._solver, kind == "final", parts, self._options)
