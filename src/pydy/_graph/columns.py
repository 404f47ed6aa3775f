"""Sensitivities beside a state: directional derivatives along several columns at once.

With S = ∂x/∂θ for parameters θ of the right-hand side f(x, r, p, t), or of the initial conditions,
each column obeys S' = (∂f/∂x) S + ∂f/∂θ (Hairer, Nørsett, Wanner, Solving ODEs I, I.14). The right
side is the derivative of f along the direction (S, dθ): one walk over the graph of f, which shares
all values with f itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pydy._graph.derivative import directional
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._graph.passes.factor import factor_sums
from pydy._graph.tangent import Seeds, tangent
from pydy._program import Program, Tangent


@dataclass(frozen=True)
class SensitivityColumns:
    """The state with columns of sensitivities after it: x, then S row after row."""

    states: int  # number of states, n
    # For each column what the equations are differentiated by: None, where the parameter is an
    # initial condition alone; (group, index) of an input; or ('r', index, weight), where the
    # input's derivative by the parameter is the input `weight` of r.
    directions: tuple[tuple[str, int] | tuple[str, int, int] | None, ...]
    weights: int = 0  # how many such further inputs r has at its end

    @property
    def count(self) -> int:
        """Number of columns, k."""
        return len(self.directions)

    @property
    def size(self) -> int:
        """Number of states and sensitivities, n (1 + k)."""
        return self.states * (1 + self.count)

    def together(self, states: np.ndarray, columns: np.ndarray) -> np.ndarray:
        """Return states (..., n) and sensitivities (..., n, k) as (..., n (1 + k))."""
        flat = columns.reshape(*columns.shape[:-2], self.states * self.count)
        return np.concatenate([states, flat], axis=-1)

    def split(self, augmented: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return states (..., n) and sensitivities (..., n, k) of (..., n (1 + k))."""
        n = self.states
        return augmented[..., :n], augmented[..., n:].reshape(*augmented.shape[:-1], n, self.count)

    @property
    def wanted(self) -> tuple[tuple[str, int], ...]:
        """The inputs that the equations are differentiated by, each once."""
        return tuple(dict.fromkeys((d[0], d[1]) for d in self.directions if d))

    @property
    def sources(self) -> np.ndarray:
        """For each column the places of its input in `wanted`, and of its weight in r, or -1."""
        positions = {source: k for k, source in enumerate(self.wanted)}
        rows = [(positions[d[0], d[1]], *d[2:], -1)[:2] if d else (-1, -1) for d in self.directions]
        return np.array(rows, dtype=np.int64).reshape(-1, 2)

    def tangent(
        self,
        graph: Graph,
        nodes: Sequence[int],
        sizes: tuple[int, int, int],
        values: str = "",
    ) -> Tangent:
        """Return the derivatives of simplified nodes along the columns.

        With a name for the `values` of the nodes these come before their derivatives.
        """
        n, (_, s, c) = self.states, sizes
        inputs = [*dict.fromkeys(d for d in self.directions if d)]
        terms: dict[int, list[tuple[int, float]]] = {}
        for k, direction in enumerate(inputs):
            size = graph.input("p", c + k)
            if len(direction) == 3:
                size = graph.mul(size, graph.input("r", direction[2]))
            terms.setdefault(graph.input(*direction[:2]), []).append((size, 1.0))
        derivatives = {node: graph.sum(parts) for node, parts in terms.items()}
        derivatives.update({graph.input("x", i): graph.input("x", n + i) for i in range(n)})
        part_inputs = {("x", n + i): i for i in range(n)}
        part_inputs.update({("p", c + k): k for k in range(len(inputs))})
        part = Seeds(0, self.count, derivatives, part_inputs, (n, len(inputs)))
        rows = [[float(d == source) for d in self.directions] for source in inputs]
        table = np.array(rows, dtype=float).reshape(len(inputs), self.count)
        sizes_with_seeds = (2 * n, s + self.weights, c + len(inputs))
        return tangent(graph, nodes, [part], (sizes, sizes_with_seeds), self.count, table, values)


@dataclass(frozen=True)
class SensitivityDirection:
    """The state with one column after it, which is the derivative along one direction of all.

    That has components of the initial conditions, the column at the start, and of the inputs `by`,
    pairs (group, index): these components are further inputs at the end of r.
    """

    states: int  # number of states, n
    by: tuple[tuple[str, int], ...]

    def program(
        self, graph: Graph, nodes: Sequence[int], sizes: tuple[int, int, int], values: str = ""
    ) -> Program:
        """Return the Program of the derivatives of simplified nodes along the direction.

        With a name for the `values` of the nodes these come before their derivatives.
        """
        n, (_, s, c) = self.states, sizes
        seeds = {graph.input("x", i): {0: graph.input("x", n + i)} for i in range(n)}
        seeds.update(
            (graph.input(*at), {0: graph.input("r", s + k)}) for k, at in enumerate(self.by)
        )
        cells = [row.get(0, graph.zero) for row in directional(graph, nodes, seeds)]
        cells = cells if "factor" in graph.off else factor_sums(graph, cells)
        column = ("column", (len(nodes), 1), cells)
        before = [(values, (len(nodes),), list(nodes))] if values else []
        return lower(graph, (2 * n, s + len(self.by), c), [*before, column])
