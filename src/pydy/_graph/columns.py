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

from pydy._graph.derivative import Rows
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.passes.factor import factor_sums
from pydy._graph.program import Program
from pydy._graph.simplify import simplify
from pydy._graph.switches import Passes
from pydy._graph.tangent import Along, Tangent, tangent

__all__ = ["Columns"]


@dataclass(frozen=True)
class Columns:
    """The state with columns of sensitivities after it: x, then S row after row.

    Attributes
    ----------
    states : int
        Number of states, n.
    directions : tuple
        For each column what the equations are differentiated by: None, where the parameter is an
        initial condition alone; (group, index) of an input; or ('r', index, weight), where the
        input's derivative by the parameter is the input `weight` of r.
    weights : int
        How many such further inputs r has at its end.
    """

    states: int
    directions: tuple[tuple[str, int] | tuple[str, int, int] | None, ...]
    weights: int = 0

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

    def apart(self, whole: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return states (..., n) and sensitivities (..., n, k) of (..., n (1 + k))."""
        n = self.states
        return whole[..., :n], whole[..., n:].reshape(*whole.shape[:-1], n, self.count)

    def rows(self, graph: Graph) -> Rows:
        """Return the derivatives of any nodes along the columns."""
        n, k = self.states, self.count
        given: dict[int, dict[int, int]] = {}
        for i in range(n):
            own = {j: graph.input("x", n + i * k + j) for j in range(k)}
            given[graph.input("x", i)] = own
        for j, direction in enumerate(self.directions):
            if direction is not None:
                weight = graph.input("r", direction[2]) if len(direction) == 3 else graph.one
                given.setdefault(graph.input(*direction[:2]), {})[j] = weight
        return Rows(graph, given)

    def tangent(
        self,
        graph: Graph,
        nodes: Sequence[int],
        sizes: tuple[int, int, int],
        passes: Passes,
        values: str = "",
    ) -> Tangent:
        """Return the derivatives of some nodes along the columns.

        Parameters
        ----------
        graph : Graph
            Gets the new nodes.
        nodes : sequence of nodes
            Simplified ones.
        sizes : (int, int, int)
            Numbers of states, specifieds and constants.
        passes : Passes
        values : str, optional
            What to call the values of the nodes, if they are to come before their derivatives.
        """
        n, (_, s, c) = self.states, sizes
        inputs = [*dict.fromkeys(d for d in self.directions if d)]
        terms: dict[int, list[tuple[int, float]]] = {}
        for k, direction in enumerate(inputs):
            size = graph.input("p", c + k)
            if len(direction) == 3:
                size = graph.mul(size, graph.input("r", direction[2]))
            terms.setdefault(graph.input(*direction[:2]), []).append((size, 1.0))
        along = {node: graph.sum(parts) for node, parts in terms.items()}
        along.update({graph.input("x", i): graph.input("x", n + i) for i in range(n)})
        own = {("x", n + i): i for i in range(n)}
        own.update({("p", c + k): k for k in range(len(inputs))})
        part = Along(0, self.count, along, own, (n, len(inputs)))
        rows = [[float(d == one) for d in self.directions] for one in inputs]
        table = np.array(rows, dtype=float).reshape(len(inputs), self.count)
        whole = (2 * n, s + self.weights, c + len(inputs))
        return tangent(graph, nodes, [part], (sizes, whole), passes, self.count, table, values)

    def jump_program(
        self,
        graph: Graph,
        crossing: int,
        after: Sequence[int],
        rates: Sequence[int],
        sizes: tuple[int, int, int],
        passes: Passes,
    ) -> Program:
        """Return the Program of what moves columns through an event; see `solvers.sensitivities`.

        The inputs r end with the derivatives of the specifieds by time.

        Parameters
        ----------
        graph : Graph
            Gets the new nodes.
        crossing : node
            What is zero at the event.
        after : sequence of nodes
            The states after it.
        rates : sequence of nodes
            The derivatives of the states before it.
        sizes, passes
            As for `tangent`.
        """
        crossing, *rest = simplify(graph, [crossing, *after, *rates], passes)
        after, rates = rest[: len(after)], rest[len(after) :]
        along: dict[int, dict[int, int]] = {graph.input("t", 0): {0: graph.one}}
        states = [graph.input("x", i) for i in range(self.states)]
        along.update((x, {0: rate}) for x, rate in zip(states, rates, strict=True))
        s, last = sizes[1], sizes[1] + self.weights
        along.update((graph.input("r", i), {0: graph.input("r", last + i)}) for i in range(s))
        columns, motion = self.rows(graph), Rows(graph, along)
        gradient = Rows(graph, {x: {i: graph.one} for i, x in enumerate(states)})
        first = motion(crossing).get(0, graph.zero)
        k, zero = range(self.count), graph.zero
        parts = {
            "rate": [first],
            "curvature": [motion(first).get(0, zero)],
            "gradient": [gradient(crossing).get(i, zero) for i in range(self.states)],
            "moved": [columns(crossing).get(j, zero) for j in k],
            "after_rates": [motion(node).get(0, zero) for node in after],
            "after": [columns(node).get(j, zero) for node in after for j in k],
        }
        cells = iter(factor_sums(graph, [node for part in parts.values() for node in part]))
        blocks = [(name, (len(part),), [next(cells) for _ in part]) for name, part in parts.items()]
        whole = (self.size, last + s, sizes[2])
        return lower(graph, whole, blocks, passes=passes, own=sizes)
