"""Whether gaps have rates and sliding speeds are continuous, as the laws of contacts need.

Where a Piecewise, Abs or Max switches, what it gives on both sides is compared, at points of the
surface where it does: rates of a gap whose slope jumps, or a sliding speed that jumps, would be
those of one side, and the body would follow the other without an impact or a force.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sm
from sympy.core.relational import Relational

from pydy._checks import shown
from pydy._graph import Graph, SymPyReader, jacobian, rounding_bounds, substitute
from pydy._mechanics import find_symbols, replace_symbols
from pydy._rank import ROUNDING
from pydy.contact.tuning import DRAWS, WITHIN

_STEPS = (sm.floor, sm.ceiling, sm.frac, sm.Mod)
_KINDS = (sm.Piecewise, sm.Abs, sm.Min, sm.Max, sm.sign, sm.Heaviside, sm.DiracDelta, *_STEPS)
_INVERSES: dict[Any, Any] = {
    sm.asin: (sm.sin, sm.cos), sm.acos: (sm.sin, sm.cos), sm.atan: sm.tan
}  # fmt: skip
_BOUNDED = {sm.sin: "asin", sm.cos: "asin", sm.tanh: "atanh"}  # what is NaN beyond their bounds


def switched(what: str, expression: Any, moving: Iterable[Any], slopes: bool) -> Switched | None:
    """Return the switches of an expression, or None; refuse jumps and kinks."""
    seen: dict[int, Any] = {}
    stack = [expression]
    while stack:
        e = stack.pop()
        if isinstance(e, _KINDS) or _is_folded(e):
            found = Switched(what, expression, moving, slopes)
            found.check()
            return found
        if id(e) not in seen:
            seen[id(e)] = e
            stack += e.args
    return None


class Switched:
    """An expression with functions that switch where coordinates, or time, have some value.

    With `slopes` the derivatives must be continuous too. Pieces may meet for some values of the
    constants alone, such as times in their order: `check` is given these when they are known.
    """

    def __init__(self, what: str, expression: Any, moving: Iterable[Any], slopes: bool) -> None:
        self.what, self.slopes = what, slopes
        self.symbols = {s: sm.Dummy(str(s), real=True) for s in find_symbols([expression])}
        self.moving = [self.symbols[s] for s in moving if s in self.symbols]
        self.steps: dict[Any, Any] = {}  # whole numbers, by what they are the floors of
        # SymPy writes roots of squares of these as Abs.
        real = replace_symbols(expression, self.symbols).replace(_is_folded, _unfolded)
        # SymPy would add them up, and what remains of 0.1 + 0.2 - 0.3 would be a jump.
        self.floats = {
            f: sm.Integer(int(f)) if f == int(f) else sm.Dummy(str(f), real=True)
            for f in real.atoms(sm.Float, sm.NumberSymbol)
        }
        found = [f for f in real.atoms(*_KINDS) if self._moves(f)]
        self.functions = sorted(found, key=lambda f: (f.count_ops(), sm.default_sort_key(f)))
        self.whole = self._rewritten(real.xreplace(self.floats))
        self.graph, self.kept = Graph(), list[tuple[Any, int, Any]]()
        if self.functions:
            self._read()

    def _moves(self, expression: Any) -> bool:
        return not expression.free_symbols.isdisjoint(self.moving)

    def _rewritten(self, expression: Any) -> Any:
        """Return an expression with conditions in place of functions."""
        return expression.replace(
            lambda e: isinstance(e, _KINDS) and self._moves(e), self._by_conditions
        )

    @property
    def expression(self) -> Any:
        """The same in conditions: SymPy has second derivatives of these, without DiracDelta."""
        symbols = {d: s for s, d in self.symbols.items()}
        symbols |= {d: f for f, d in self.floats.items() if d.is_Dummy}
        symbols |= {k: sm.floor(s) for s, k in self.steps.items()}
        found = self.whole
        while not find_symbols([found]).keys().isdisjoint(symbols):  # floors may hold floors
            found = replace_symbols(found, symbols)
        return found

    def _by_conditions(self, f: Any) -> Any:
        s = f.args[0]
        if isinstance(f, sm.Abs):
            return sm.Piecewise((s, s >= 0), (-s, True))
        if isinstance(f, (sm.sign, sm.Heaviside)):
            return sm.Piecewise((1, s > 0), (-1 if isinstance(f, sm.sign) else 0, True))
        if isinstance(f, (sm.Min, sm.Max)):
            high = isinstance(f, sm.Max)
            pairs = [
                (a, sm.And(*(a >= b if high else a <= b for b in f.args[k + 1 :] + f.args[:k])))
                for k, a in enumerate(f.args)
            ]
            return sm.Piecewise(*pairs[:-1], (pairs[-1][0], True))
        if isinstance(f, sm.floor):
            return self._floor(s)
        if isinstance(f, sm.ceiling):
            return -self._floor(-s)
        if isinstance(f, sm.frac):
            return s - self._floor(s)
        return s - f.args[1] * self._floor(s / f.args[1]) if isinstance(f, sm.Mod) else f

    def _floor(self, s: Any) -> Any:
        return self.steps.setdefault(s, sm.Dummy("k", integer=True))

    def _surfaces(self) -> Iterator[tuple[Any, Any, Any, Any]]:
        """Yield each switch, both sides of the equation of its surface, and both expressions."""
        conditions = [
            r for r in self.whole.atoms(Relational)
            if self._moves(r) and not isinstance(r, (sm.Eq, sm.Ne))  # true at a point, or but there
        ]  # fmt: skip
        conditions.sort(key=sm.default_sort_key)
        excess = {r: r.gts - r.lts for r in conditions}  # positive where it holds
        done: set[Any] = set()
        for r in conditions:
            if r in done:
                continue
            sides = {
                other: sm.true if same == 0 else sm.false
                for other in conditions
                for same in (sm.expand(excess[other] - excess[r]),)
                if same == 0 or sm.expand(excess[other] + excess[r]) == 0
            }
            done.update(sides)
            turned = {other: sm.Not(holds) for other, holds in sides.items()}
            equal = (r.lhs, r.rhs) if r.lhs.free_symbols else (r.rhs, r.lhs)
            yield (r, *equal, (self.whole.xreplace(sides), self.whole.xreplace(turned)))
        for s, k in self.steps.items():
            yield k, s, k, (self.whole, self.whole.xreplace({k: k - 1}))

    def _read(self) -> None:
        """Read each surface into the graph: its equation, and the expressions on both sides."""
        g = self.graph
        names = [*self.symbols.values(), *self.steps.values()]
        names += [d for d in self.floats.values() if d.is_Dummy]
        self.inputs = {d: g.input("x", k) for k, d in enumerate(names)}
        self.exact = {d: float(f) for f, d in self.floats.items()}
        read = SymPyReader(g, {sm.nan: g.const(np.nan), **self.inputs}, self.what)
        by = [self.inputs[v] for v in self.moving]
        for switch, left, right, sides in self._surfaces():
            nodes = read.all(_apart(*sides))
            if self.slopes:
                a, b = (jacobian(g, [node], by).flat() for node in nodes)
                nodes += [n for pair in zip(a, b, strict=True) for n in pair]
            for place in _places(left, right, self.moving):
                where = [self._known(v) if v.is_number else read(v) for v in place.values()]
                onto = dict(zip(read.all(place), where, strict=True))
                for f, node in zip(place, list(where), strict=True):
                    if f.func in _BOUNDED:  # beyond their bounds there is no such surface
                        where.append(g.call(_BOUNDED[f.func], node))
                there = substitute(g, nodes, onto)
                every = [*there, *rounding_bounds(g, there), *where]
                self.kept.append((switch, len(nodes), g.evaluator(every)))

    def _known(self, value: Any) -> int:
        """Return an input in place of a number, so that rounding bounds include it."""
        made = sm.Dummy(str(value), real=True)
        self.exact[made] = float(value) if value.is_extended_real else np.nan
        self.inputs[made] = self.graph.input("x", len(self.inputs))
        return self.inputs[made]

    def check(self, values: Mapping[Any, float] | None = None) -> None:
        """Refuse switches with a jump in value; constants without values may be any."""
        for f in self.functions:
            if isinstance(f, sm.DiracDelta):
                self._refuse(f)
        inputs = self._drawn(values) if self.kept else {}
        for switch, n, evaluate in self.kept:
            with np.errstate(all="ignore"):
                found = evaluate(inputs, DRAWS**2).T
                a, b = found[:n:2], found[1:n:2]
                near = np.nan_to_num(found[n : 2 * n : 2] + found[n + 1 : 2 * n : 2])
                off = ~(np.abs(a - b) <= WITHIN * ROUNDING * near) & (a != b)
            off &= ~(np.isnan(a) & np.isnan(b))
            # There is no such surface, or no value on one side of it: other errors tell.
            off = off.any(axis=0) & np.isfinite([*found[:2], *found[2 * n :]]).all(axis=0)
            if off.reshape(DRAWS, DRAWS).any(axis=1).all():
                self._refuse(
                    next(
                        f
                        for f in self.functions
                        if self._rewritten(f.xreplace(self.floats)).has(switch)
                    )
                )

    def _drawn(self, values: Mapping[Any, float] | None) -> dict[int, np.ndarray]:
        """Return inputs: a row for each draw of the constants, in which the others change.

        Coordinates are drawn from all sizes, since nothing tells their units.
        """
        draws, shape = np.random.default_rng(0), (DRAWS, DRAWS)
        exact = dict(self.exact)
        if values is not None:
            exact |= {d: values[s] for s, d in self.symbols.items() if s in values}
        found = {}
        for d, node in self.inputs.items():
            if d in self.moving:
                reach = np.where(np.arange(DRAWS) % 2, 1.0, 12.0)
                x = draws.choice([-1.0, 1.0], shape) * 10.0 ** (reach * draws.uniform(-1, 1, shape))
            elif d in exact:
                x = np.full(shape, exact[d])
            elif d.is_integer:
                x = draws.integers(-9, 10, shape).astype(float)
            else:
                x = np.repeat(10.0 ** draws.uniform(-1, 1, (DRAWS, 1)), DRAWS, axis=1)
            found[node] = x.ravel()
        return found

    def _refuse(self, function: Any) -> None:
        got = replace_symbols(function, {d: s for s, d in self.symbols.items()})
        must, part = "must not jump", "a ramp"
        if self.slopes:
            must, part = "must have no jumps and no kinks", "one with a continuous slope"
        raise ValueError(
            f"{self.what} {must}, got `{shown(got)}` in it. Give one contact for each smooth part, "
            f"or a smooth transition: {part}."
        )


def _is_folded(e: Any) -> bool:
    """Whether an expression is a root of a square, an angle of its own sine, say, or an acot."""
    if e.is_Pow:
        powers = (f for f in sm.Mul.make_args(e.base) if f.is_Pow)
        return e.exp.is_integer is False and any(f.exp.is_even for f in powers)
    return isinstance(e, sm.acot) or (
        bool(e.args) and isinstance(e.args[0], _INVERSES.get(e.func, ()))
    )


def _unfolded(e: Any) -> Any:
    """Return the same with functions that switch."""
    half = sm.pi / 2
    if e.is_Pow:
        return e
    if isinstance(e, sm.acot):  # as SymPy has it, it jumps at zero
        return half - sm.atan(e.args[0]) - sm.pi * sm.Heaviside(-e.args[0])
    s = e.args[0].args[0]
    if isinstance(e, sm.atan):
        return sm.Mod(s + half, sm.pi) - half
    s = s - half if isinstance(e.args[0], sm.sin) else s
    turned = sm.Abs(sm.Mod(s + sm.pi, 2 * sm.pi) - sm.pi)  # the angle of the cosine of s
    return half - turned if isinstance(e, sm.asin) else turned


def _places(left: Any, right: Any, moving: Sequence[Any]) -> list[dict[Any, Any]]:
    """Return substitutions that lead onto the surface where both sides are equal."""
    excess = left - right
    parts = [e for e in excess.atoms(sm.Function, sm.Pow) if not e.free_symbols.isdisjoint(moving)]
    parts.sort(key=sm.default_sort_key)
    for degree, unknowns in ((1, moving), (2, moving), (1, parts)):
        for v in unknowns:
            z = sm.Dummy("z", real=True)
            plain = excess.xreplace({v: z})
            if not (plain.has(z) and plain.is_polynomial(z) and sm.degree(plain, z) == degree):
                continue
            *square, a, b = sm.Poly(plain, z).all_coeffs()
            if not square:
                return [{v: -b / a}]
            root = sm.sqrt(a**2 - 4 * square[0] * b)
            return [{v: (root - a) / (2 * square[0])}, {v: (-root - a) / (2 * square[0])}]
    return [{left: right}]


def _apart(a: Any, b: Any) -> tuple[Any, Any]:
    """Return two expressions without the terms that both have."""
    one, other = (Counter(sm.Add.make_args(e)) for e in (a, b))
    return sm.Add(*(one - other).elements()), sm.Add(*(other - one).elements())
