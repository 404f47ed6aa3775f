"""Programs of an Assembly: of its blocks and their Jacobians, and of further expressions.

Functions make them; `Programs` makes each at most once.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any, TypeVar, cast

from pydy._assembly.assembly import Assembly
from pydy._assembly.mechanical_blocks import kinetic_hessian
from pydy._assembly.program_cache import stored_program
from pydy._collector import collector_paused
from pydy._graph import (
    derivative_program,
    jacobian_tangent,
    lower,
    rounding_bounds,
    simplify,
    substitute,
)
from pydy._program import Program, Tangent

_T = TypeVar("_T", bound="Program | Tangent")


@cache
def every_input(group: str, size: int) -> tuple[tuple[str, int], ...]:
    """Return all inputs of a group."""
    return tuple((group, k) for k in range(size))


def block_program(assembly: Assembly, *names: str, bounded: str | None = None) -> Program:
    """Return the Program of the named blocks; for `bounded` see `lower_nodes`.

    In addition to the blocks of the equations, 'kinetic_hessian' is one.
    """
    if names == ("rates",):
        graph, nodes = assembly.simplified("rates")
        with collector_paused():
            blocks = [("rates", (len(nodes),), nodes)]
            return lower(graph, assembly.sizes, blocks)
    own = assembly.fork()
    parts = {
        name: kinetic_hessian(own) if name == "kinetic_hessian" else getattr(own.blocks, name)
        for name in names
    }
    squares = {"kinetic_hessian": len(own.speeds), "mass_matrix": len(own.blocks.forcing)}
    shapes = {name: (n, n) for name, n in squares.items() if parts.get(name)}
    return lower_nodes(own, parts, shapes, bounded=bounded)


def open_program(assembly: Assembly, *names: str) -> Program:
    """Return the Program of blocks that takes the accelerations, at the end of its r."""
    own = assembly.fork()
    n, s, c = own.sizes
    count = len(own.blocks.forcing)
    places = {own.graph.input("a", k): own.graph.input("r", s + k) for k in range(count)}
    parts = {name: own.open.get(name) or getattr(own.blocks, name) for name in names}
    parts = {name: substitute(own.graph, nodes, places) for name, nodes in parts.items()}
    return lower_nodes(own, parts, sizes=(n, s + count, c))


def expression_program(
    assembly: Assembly, name: str, shape: tuple[int, ...], expressions: Any
) -> Program:
    """Return the Program of one block of further expressions, which may hold q' and u'."""
    own = assembly.fork()
    return lower_nodes(own, {name: own.read(expressions, name)}, {name: shape})


def jacobian_program(
    assembly: Assembly, name: str, by: str | Sequence[tuple[str, int]], kind: str = "jacobian"
) -> Program:
    """Return the Program of a block's Jacobian, or of a product with it; see `KINDS`."""
    graph, nodes = assembly.simplified(name)
    inputs = _inputs(assembly, by)
    return derivative_program(graph, nodes, inputs, kind, assembly.sizes)


def jacobian_in_parts(
    assembly: Assembly, name: str, by: str | Sequence[tuple[str, int]]
) -> Program | Tangent:
    """Return the same in parts, where that is less work."""
    graph, nodes = assembly.simplified(name)
    inputs = _inputs(assembly, by)
    tangent = jacobian_tangent(graph, nodes, inputs, assembly.sizes)
    return jacobian_program(assembly, name, by) if tangent is None else tangent


def _inputs(assembly: Assembly, by: str | Sequence[tuple[str, int]]) -> Sequence[tuple[str, int]]:
    if not isinstance(by, str):
        return by
    return every_input(by, assembly.sizes["xrp".index(by)])


def lower_nodes(
    assembly: Assembly,
    parts: Mapping[str, Sequence[int]],
    shapes: Mapping[str, tuple[int, ...]] | None = None,
    *,
    sizes: tuple[int, int, int] | None = None,
    bounded: str | None = None,
    as_is: bool = False,
) -> Program:
    """Simplify, unless they stay `as_is`, and lower named nodes of an Assembly that is a fork.

    The rounding bounds of the block `bounded`, as it is computed, follow as 'rounding'.
    """
    graph = assembly.graph
    with collector_paused():
        whole = [n for part in parts.values() for n in part]
        nodes = iter(whole if as_is else simplify(graph, whole))
        new = {name: [next(nodes) for _ in part] for name, part in parts.items()}
        if bounded is not None:
            new["rounding"] = rounding_bounds(graph, new[bounded])
        own = shapes or {}
        blocks = [(name, own.get(name, (len(part),)), part) for name, part in new.items()]
        return lower(graph, sizes or assembly.sizes, blocks)


class Programs:
    """The Programs of an Assembly, each lowered when first asked for, or read from the cache."""

    def __init__(self, assembly: Assembly) -> None:
        self._assembly = assembly
        self._programs: dict[str, Program | Tangent] = {}

    def of(self, *blocks: str) -> Program:
        """Return the Program of some blocks; see `block_program`."""
        # What is made from the bodies has no fingerprint.
        storable = "kinetic_hessian" not in blocks
        what = ", ".join(blocks)
        return self._program(what, lambda: block_program(self._assembly, *blocks), storable)

    def given_accelerations(self, *blocks: str) -> Program:
        """Return the Program of blocks that takes accelerations; see `open_program`."""
        what = f"{', '.join(blocks)} given accelerations"
        return self._program(what, lambda: open_program(self._assembly, *blocks))

    def bounded(self, block: str) -> Program:
        """Return the Program of a block and its rounding bounds; see `lower_nodes`."""
        what = f"{block}, bounded"
        return self._program(what, lambda: block_program(self._assembly, block, bounded=block))

    def jacobian(self, block: str, by: str | tuple[tuple[str, int], ...]) -> Program:
        """Return the Program of a Jacobian; see `jacobian_program`."""
        return self._program(
            f"{block} by {by}", lambda: jacobian_program(self._assembly, block, by)
        )

    def product(self, block: str, by: Sequence[tuple[str, int]], kind: str) -> Program:
        """Return the Program of a product with a Jacobian; see `derivative_program`."""
        return jacobian_program(self._assembly, block, by, kind)

    def jacobian_in_parts(
        self, block: str, by: str | tuple[tuple[str, int], ...]
    ) -> Program | Tangent:
        """Return a Jacobian; see the function `jacobian_in_parts`."""
        what = f"{block} by {by}, in parts"
        return self._program(what, lambda: jacobian_in_parts(self._assembly, block, by))

    def _program(self, what: str, make: Callable[[], _T], storable: bool = True) -> _T:
        """Return the result of `make`, called at most once, or the cache's if it is `storable`."""
        known = self._programs.get(what)
        if known is None:
            known = stored_program(self._assembly, what, make) if storable else make()
            self._programs[what] = known
        return cast("_T", known)
