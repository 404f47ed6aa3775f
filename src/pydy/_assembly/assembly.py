"""A whole system as nodes of one graph, in named blocks."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from pydy._collector import collector_paused
from pydy._graph import Graph, SymPyReader, simplify, substitute
from pydy._mechanics import Equations, find_symbols


@dataclass(frozen=True)
class EquationBlocks:
    """The equations and outputs of a system, as nodes by name."""

    rates: list[int]  # derivatives of the states
    ordinary: list[int]  # the outputs that come back beside the derivatives
    outputs: list[int]  # all outputs, in the user's order
    holonomic: list[int] = field(default_factory=list)  # residuals of constraints
    velocity: list[int] = field(default_factory=list)
    nonholonomic: list[int] = field(default_factory=list)
    # The linear system for the accelerations; empty where the form has none.
    mass_matrix: list[int] = field(default_factory=list)
    forcing: list[int] = field(default_factory=list)

    @property
    def of_function(self) -> tuple[str, ...]:
        """The names of the blocks that a generated function returns."""
        return ("rates", "ordinary") if self.ordinary else ("rates",)

    @property
    def constraints(self) -> list[int]:
        """Residuals of the holonomic, then the nonholonomic constraints."""
        return [*self.holonomic, *self.nonholonomic]

    def summary(self) -> str:
        """Return the blocks that are not empty, with their lengths."""
        return ", ".join(f"{name} ({len(part)})" for name, part in vars(self).items() if part)


@dataclass(repr=False)
class Assembly:
    """A system as nodes of one graph."""

    graph: Graph
    sizes: tuple[int, int, int]  # numbers of states, specifieds and constants
    blocks: EquationBlocks
    # What further expressions may hold; see `read`.
    atoms: Mapping[Any, int] = field(default_factory=dict)
    speeds: list[int] = field(default_factory=list)
    equations: Equations | None = None  # of a mechanical system
    # The blocks that depend on accelerations, with these as inputs of the group 'a': for a
    # linear solver of the user's. Empty where there is none.
    open: Mapping[str, list[int]] = field(default_factory=dict)
    # What `substituted` put in place of inputs.
    given: Mapping[int, int] = field(default_factory=dict)
    # These rates after simplification, in a graph of their own, where that is known already.
    ready: tuple[list[int], Graph, list[int]] | None = None
    _simplified: dict[str, tuple[Graph, list[int]]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_simplified": {}}

    def __repr__(self) -> str:
        n, s, c = self.sizes
        return (
            f"Assembly: {n} states, {s} specifieds, {c} constants; a graph of {len(self.graph)} "
            f"nodes\n  blocks: {self.blocks.summary()}"
        )

    def fork(self) -> Assembly:
        """Return a copy with its own graph: reading into it does not change this one."""
        return replace(self, graph=self.graph.copy())

    def read(self, expressions: Iterable[Any], what: str, *, sizes: bool = False) -> list[int]:
        """Return expressions as nodes; with `sizes`, symbols that the equations lack are zero.

        They may hold q' and u'.
        """
        expressions = [*expressions]
        reader = self.reader(what, expressions if sizes else ())
        return substitute(self.graph, reader.all(expressions), self.given)

    def reader(self, what: str, sized: Sequence[Any] = ()) -> SymPyReader:
        """Return a reader into this graph; symbols of `sized` that the equations lack are zero."""
        absent = (s for s in (find_symbols(sized) if sized else ()) if s not in self.atoms)
        more = dict.fromkeys(absent, self.graph.zero)
        return SymPyReader(self.graph, {**self.atoms, **more} if more else self.atoms, what)

    def simplified(self, name: str) -> tuple[Graph, list[int]]:
        """Return a block's nodes after simplification, in a graph of their own; found once."""
        known = self._simplified.get(name)
        if known is None and name == "rates" and self.ready and self.ready[0] == self.blocks.rates:
            known = self.ready[1:]
        if known is None:
            own = self.fork()
            with collector_paused():
                nodes = simplify(own.graph, getattr(own.blocks, name))
            known = self._simplified[name] = (own.graph, nodes)
        return known[0].copy(), known[1]

    def substituted(self, mapping: Mapping[int, int]) -> Assembly:
        """Return the Assembly with other nodes in place of some inputs, in every block."""
        closed = vars(self.blocks)
        parts = [*closed.values(), *self.open.values()]
        with collector_paused():
            nodes = iter(substitute(self.graph, [n for part in parts for n in part], mapping))
        new = {name: [next(nodes) for _ in part] for name, part in closed.items()}
        opened = {name: [next(nodes) for _ in part] for name, part in self.open.items()}
        return replace(self, blocks=EquationBlocks(**new), given=dict(mapping), open=opened)
