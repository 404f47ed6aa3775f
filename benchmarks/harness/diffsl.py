"""Equations in DiffSL, the language of diffsol: shared subexpressions have names of their own."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np

from harness.convert import Algebra
from harness.elimination import derivatives
from harness.model import Model

# The parser recurses; longer expressions are cut into named pieces.
_LONGEST = 2000


class _Node:
    """One operation; equal ones have the same place in the book."""

    def __init__(self, book: _Book, place: int) -> None:
        self.book = book
        self.place = place

    def __add__(self, other: _Node) -> _Node:
        return self.book.add("+", self, other)

    def __sub__(self, other: _Node) -> _Node:
        return self.book.add("-", self, other)

    def __mul__(self, other: _Node) -> _Node:
        return self.book.add("*", self, other)

    def __truediv__(self, other: _Node) -> _Node:
        return self.book.add("/", self, other)

    def __neg__(self) -> _Node:
        return self.book.add("-", self)


class _Book:
    """Operations in an order in which they can be computed: ``(operation, *places)``."""

    def __init__(self) -> None:
        self.rows: list[tuple[Any, ...]] = []
        self._known: dict[tuple[Any, ...], int] = {}

    def add(self, operation: str, *nodes: _Node) -> _Node:
        return self._node((operation, *(n.place for n in nodes)))

    def leaf(self, text: str) -> _Node:
        return self._node((text,))

    def _node(self, row: tuple[Any, ...]) -> _Node:
        if row not in self._known:
            self._known[row] = len(self.rows)
            self.rows.append(row)
        return _Node(self, self._known[row])


class _DiffSL(Algebra):
    def __init__(self, book: _Book) -> None:
        functions: dict[str, Any] = {
            name: lambda a, name=name: book.add(name, a) for name in ("sin", "cos", "sqrt")
        }
        # Its differentiation does not know the tangent.
        functions["tan"] = lambda a: functions["sin"](a) / functions["cos"](a)
        super().__init__(functions)
        self._book = book

    def number(self, value: float) -> _Node:
        return self._book.leaf(repr(value) if value >= 0.0 else f"({value!r})")

    def integer_power(self, base: _Node, exponent: int) -> _Node:
        if exponent == 1:
            return base
        half = self.integer_power(base, exponent // 2)
        square = half * half
        return square * base if exponent % 2 else square

    def power(self, base: _Node, exponent: float) -> _Node:
        whole = round(2.0 * exponent)
        if whole != 2.0 * exponent:
            raise ValueError(f"only halves as exponents, got {exponent}")
        return self.integer_power(self.functions["sqrt"](base), whole)


def code_of(model: Model, start: np.ndarray, inputs: np.ndarray) -> str:
    """Return a model in DiffSL; its inputs are the specifieds and then the constants."""
    book = _Book()
    x = [book.leaf(f"x{k}") for k in range(len(start))]
    given = [*inputs.tolist(), *model.values]
    p = [book.leaf(f"p{k}") for k in range(len(given))]
    count = len(inputs)
    rates = derivatives(model, _DiffSL(book), x, p[:count], p[count:])
    lines, results = _text(book, [node.place for node in rates])
    return "\n".join(
        (
            f"in_i {{ {', '.join(f'p{k} = {v!r}' for k, v in enumerate(given))} }}",
            f"u_i {{ {', '.join(f'x{k} = {v!r}' for k, v in enumerate(start.tolist()))} }}",
            *lines,
            f"F_i {{ {', '.join(results)} }}",
        )
    )


def _text(book: _Book, roots: list[int]) -> tuple[list[str], list[str]]:
    """Return the definitions, and the expressions of some places.

    What occurs once stands where it is used. What depends on the inputs alone is named where it
    meets the state, for diffsol computes such tensors once, before it integrates.
    """
    rows = book.rows
    needed: set[int] = set()
    stack = list(roots)
    while stack:
        place = stack.pop()
        if place not in needed:
            needed.add(place)
            stack.extend(rows[place][1:])
    order = sorted(needed)
    uses = Counter([*roots, *(a for place in order for a in rows[place][1:])])
    moves: dict[int, bool] = {}
    bound: set[int] = set(roots)  # used where the state has a part
    for place in order:
        name, *arguments = rows[place]
        moves[place] = any(moves[a] for a in arguments) or name.startswith("x")
        if moves[place]:
            bound.update(arguments)
    text: dict[int, str] = {}
    lines = []
    for place in order:
        name, *arguments = rows[place]
        parts = [text[a] for a in arguments]
        if not parts:
            text[place] = name
            continue
        if len(parts) == 2:
            written = f"({parts[0]} {name} {parts[1]})"
        else:
            written = f"({name}{parts[0]})" if name == "-" else f"{name}({parts[0]})"
        alone = not moves[place] and place in bound
        if uses[place] > 1 or alone or len(written) > _LONGEST:
            lines.append(f"v{place} {{ {written} }}")
            written = f"v{place}"
        text[place] = written
    return lines, [text[place] for place in roots]
