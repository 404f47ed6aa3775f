"""A whole system as nodes of one graph: named blocks, of which any are lowered to Programs."""

from __future__ import annotations

import hashlib
import marshal
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

from pydy._collector import collector_paused
from pydy._graph import (
    Graph,
    SymPyReader,
    derivative_program,
    hessian,
    jacobian_tangent,
    lower,
    rounding_bounds,
    simplify,
    substitute,
)
from pydy._mechanics import Equations, find_symbols
from pydy._program import Program, Tangent

_BLOCKS = (
    "rates", "ordinary", "outputs", "holonomic", "velocity", "nonholonomic", "mass_matrix",
    "forcing",
)  # fmt: skip


@cache
def every_input(group: str, size: int) -> tuple[tuple[str, int], ...]:
    """Return all inputs of a group."""
    return tuple((group, k) for k in range(size))


@dataclass(repr=False)
class Assembly:
    """A system as nodes of one graph."""

    graph: Graph
    sizes: tuple[int, int, int]  # numbers of states, specifieds and constants
    rates: list[int]  # derivatives of the states
    ordinary: list[int]  # the outputs that come back beside the derivatives
    outputs: list[int]  # all outputs, in the user's order
    holonomic: list[int] = field(default_factory=list)  # Constraint residuals
    velocity: list[int] = field(default_factory=list)
    nonholonomic: list[int] = field(default_factory=list)
    # The linear system for the accelerations; empty where the form has none.
    mass_matrix: list[int] = field(default_factory=list)
    forcing: list[int] = field(default_factory=list)
    # What further expressions may hold; see `expression_program`.
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
            f"nodes\n  blocks: {self.summary()}"
        )

    def summary(self) -> str:
        """Return the blocks that are not empty, with their lengths."""
        lengths = {name: len(getattr(self, name)) for name in _BLOCKS}
        return ", ".join(f"{name} ({length})" for name, length in lengths.items() if length)

    @property
    def constraints(self) -> list[int]:
        """Residuals of the holonomic, then the nonholonomic constraints."""
        return [*self.holonomic, *self.nonholonomic]

    @property
    def following(self) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """The places of holonomic residuals, and of the coordinates that they alone give."""
        if self.equations is None:
            return (), ()
        residuals = self.equations.constraints.residuals
        return residuals.rows, residuals.columns

    def with_left_out(self) -> tuple[list[int], list[int]]:
        """Return the holonomic and velocity constraints, each with its redundant ones last."""
        assert self.equations is not None
        closed, redundant = self.equations.constraints.redundant
        holonomic = [*self.holonomic, *self.read(closed, "the holonomic constraints")]
        return holonomic, [*self.velocity, *self.read(redundant, "the velocity constraints")]

    @property
    def kinetic_hessian(self) -> list[int]:
        """The mass matrix of all speeds before any constraint reduces it, row by row."""
        mechanism = None if self.equations is None else self.equations.mechanism
        if mechanism is None or not mechanism.bodies:
            return []
        energy = mechanism.energy
        node = self.reader("the kinetic energy", [energy])(energy)
        cells = [c for row in hessian(self.graph, node, self.speeds)[1] for c in row]
        return substitute(self.graph, cells, self.given)

    def fork(self) -> Assembly:
        """Return a copy with its own graph: reading into it does not change this one."""
        return replace(self, graph=self.graph.copy())

    def read(self, expressions: Iterable[Any], what: str, *, sizes: bool = False) -> list[int]:
        """Return expressions as nodes; with `sizes`, symbols that the equations lack are zero."""
        expressions = [*expressions]
        reader = self.reader(what, expressions if sizes else ())
        return substitute(self.graph, reader.all(expressions), self.given)

    def reader(self, what: str, sized: Sequence[Any] = ()) -> SymPyReader:
        """Return a reader into this graph; symbols of `sized` that the equations lack are zero."""
        absent = (s for s in (find_symbols(sized) if sized else ()) if s not in self.atoms)
        more = dict.fromkeys(absent, self.graph.zero)
        return SymPyReader(self.graph, {**self.atoms, **more} if more else self.atoms, what)

    def program(self, *names: str, bounded: str | None = None) -> Program:
        """Return the Program of the named blocks; for `bounded` see `lowered`."""
        if names == ("rates",):
            graph, nodes = self.simplified("rates")
            with collector_paused():
                blocks = [("rates", (len(nodes),), nodes)]
                return lower(graph, self.sizes, blocks)
        own = self.fork()
        parts = {name: getattr(own, name) for name in names}
        squares = {"kinetic_hessian": len(self.speeds), "mass_matrix": len(self.forcing)}
        shapes = {name: (n, n) for name, n in squares.items() if parts.get(name)}
        return own.lowered(parts, shapes, bounded=bounded)

    def expression_program(self, name: str, shape: tuple[int, ...], expressions: Any) -> Program:
        """Return the Program of one block of further expressions, which may hold q' and u'."""
        own = self.fork()
        return own.lowered({name: own.read(expressions, name)}, {name: shape})

    def open_program(self, *names: str) -> Program:
        """Return the Program of blocks that takes the accelerations, at the end of its r."""
        own = self.fork()
        n, s, c = self.sizes
        count = len(self.forcing)
        places = {own.graph.input("a", k): own.graph.input("r", s + k) for k in range(count)}
        parts = {name: self.open.get(name) or getattr(own, name) for name in names}
        parts = {name: substitute(own.graph, nodes, places) for name, nodes in parts.items()}
        return own.lowered(parts, sizes=(n, s + count, c))

    def jacobian_program(self, name: str, by: str | Sequence[tuple[str, int]]) -> Program:
        """Return the Program of a block's Jacobian."""
        graph, nodes = self.simplified(name)
        places = self._places(by)
        return derivative_program(graph, nodes, places, "jacobian", self.sizes)

    def jacobian_in_parts(
        self, name: str, by: str | Sequence[tuple[str, int]]
    ) -> Program | Tangent:
        """Return the same in parts, where that is less work."""
        graph, nodes = self.simplified(name)
        places = self._places(by)
        tangent = jacobian_tangent(graph, nodes, places, self.sizes)
        return self.jacobian_program(name, by) if tangent is None else tangent

    def _places(self, by: str | Sequence[tuple[str, int]]) -> Sequence[tuple[str, int]]:
        if not isinstance(by, str):
            return by
        return every_input(by, self.sizes["xrp".index(by)])

    def simplified(self, name: str) -> tuple[Graph, list[int]]:
        """Return a block's nodes after simplification, in a graph of their own; found once."""
        known = self._simplified.get(name)
        if known is None and name == "rates" and self.ready and self.ready[0] == self.rates:
            known = self.ready[1:]
        if known is None:
            own = self.fork()
            with collector_paused():
                nodes = simplify(own.graph, getattr(own, name))
            known = self._simplified[name] = (own.graph, nodes)
        return known[0].copy(), known[1]

    def substituted(self, mapping: Mapping[int, int]) -> Assembly:
        """Return the Assembly with other nodes in place of some inputs, in every block."""
        closed = {name: getattr(self, name) for name in _BLOCKS}
        parts = [*closed.values(), *self.open.values()]
        with collector_paused():
            nodes = iter(substitute(self.graph, [n for part in parts for n in part], mapping))
        new: dict[str, Any] = {name: [next(nodes) for _ in part] for name, part in closed.items()}
        opened = {name: [next(nodes) for _ in part] for name, part in self.open.items()}
        return replace(self, given=dict(mapping), open=opened, **new)

    def lowered(
        self,
        parts: Mapping[str, Sequence[int]],
        shapes: Mapping[str, tuple[int, ...]] | None = None,
        *,
        sizes: tuple[int, int, int] | None = None,
        bounded: str | None = None,
        as_is: bool = False,
    ) -> Program:
        """Simplify, unless they stay `as_is`, and lower named nodes of this graph, that of a fork.

        The rounding bounds of the block `bounded`, as it is computed, follow as 'rounding'.
        """
        with collector_paused():
            whole = [n for part in parts.values() for n in part]
            nodes = iter(whole if as_is else simplify(self.graph, whole))
            new = {name: [next(nodes) for _ in part] for name, part in parts.items()}
            if bounded is not None:
                new["rounding"] = rounding_bounds(self.graph, new[bounded])
            own = shapes or {}
            blocks = [(name, own.get(name, (len(part),)), part) for name, part in new.items()]
            return lower(self.graph, sizes or self.sizes, blocks)

    def fingerprint(self) -> bytes:
        """Return a digest of all that Programs are made from."""
        blocks = [*(getattr(self, name) for name in ("sizes", *_BLOCKS)), *self.open.values()]
        ready = self.ready and (self.ready[0], self.ready[1].ops, self.ready[1].args, self.ready[2])
        content = (self.graph.ops, self.graph.args, blocks, ready, sorted(self.graph.off))
        # Version 2 of the format writes every object in full: equal content gives equal bytes.
        return hashlib.sha256(marshal.dumps(content, 2)).digest()
