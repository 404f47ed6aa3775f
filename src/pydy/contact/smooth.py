"""Check that gaps have continuous rates and that sliding speeds are continuous.

Where a Piecewise, Abs or Max switches, its values on both sides are compared at points of the
switching surface. If the slope of a gap or a sliding speed jumped there, the equations would use
the value of one side while the body moves on the other, without an impact or a force.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm
from sympy.core.relational import Relational

from pydy._checks import shown
from pydy._graph import Graph, SymPyReader, jacobian, rounding_bounds, substitute
from pydy._mechanics import find_symbols, replace_symbols
from pydy._rank import ROUNDING
from pydy.contact.tuning import DRAWS, ROUNDING_MARGIN

if TYPE_CHECKING:
    from pydy._program import Evaluator
    from pydy._sympy_types import AnySymbol

_STEPS = (sm.floor, sm.ceiling, sm.frac, sm.Mod)
_KINDS = (sm.Piecewise, sm.Abs, sm.Min, sm.Max, sm.sign, sm.Heaviside, sm.DiracDelta, *_STEPS)
_INVERSES: dict[type[sm.Function], type[sm.Function] | tuple[type[sm.Function], ...]] = {
    sm.asin: (sm.sin, sm.cos), sm.acos: (sm.sin, sm.cos), sm.atan: sm.tan
}  # fmt: skip
_BOUNDED = {
    sm.sin: "asin",
    sm.cos: "asin",
    sm.tanh: "atanh",
}  # inverses that are NaN outside the range


def switched(
    subject: str, expression: sm.Expr, moving: Iterable[AnySymbol], slopes: bool
) -> Switched | None:
    """Return the switches of an expression, or None if it has none; refuse jumps and kinks."""
    visited: dict[int, sm.Basic] = {}
    stack = [expression]
    while stack:
        e = stack.pop()
        if isinstance(e, _KINDS) or _is_folded(e):
            switches = Switched(subject, expression, moving, slopes)
            switches.check()
            return switches
        if id(e) not in visited:
            visited[id(e)] = e
            stack += e.args
    return None


class Switched:
    """An expression with functions that switch on surfaces of coordinates or time.

    With `slopes` the derivatives must be continuous, too. Pieces may be continuous for certain
    values of the constants only, such as switching times in ascending order; `check` takes them.
    """

    def __init__(
        self, subject: str, expression: sm.Expr, moving: Iterable[AnySymbol], slopes: bool
    ) -> None:
        self.subject, self.slopes = subject, slopes
        self.symbols = {s: sm.Dummy(str(s), real=True) for s in find_symbols([expression])}
        self.moving = [self.symbols[s] for s in moving if s in self.symbols]
        self.steps: dict[sm.Expr, sm.Dummy] = {}  # integer symbols, by the argument of their floor
        # SymPy writes roots of squares of these as Abs.
        real = replace_symbols(expression, self.symbols).replace(_is_folded, _unfolded)
        # SymPy would add floats: the remainder of 0.1 + 0.2 - 0.3 would look like a jump.
        self.floats = {
            f: sm.Integer(int(f)) if f == int(f) else sm.Dummy(str(f), real=True)
            for f in real.atoms(sm.Float, sm.NumberSymbol)
        }
        functions = [f for f in real.atoms(*_KINDS) if self._depends_on_motion(f)]
        self.functions = sorted(functions, key=lambda f: (f.count_ops(), sm.default_sort_key(f)))
        self.piecewise = self._rewritten(real.xreplace(self.floats))
        self.graph = Graph()
        self.surfaces: list[tuple[sm.Basic, int, Evaluator]] = []
        if self.functions:
            self._read()

    def _depends_on_motion(self, expression: sm.Basic) -> bool:
        return not expression.free_symbols.isdisjoint(self.moving)

    def _rewritten(self, expression: sm.Expr) -> sm.Expr:
        """Replace functions such as Abs and Max by Piecewise expressions."""
        return expression.replace(
            lambda e: isinstance(e, _KINDS) and self._depends_on_motion(e), self._by_conditions
        )

    @property
    def expression(self) -> sm.Expr:
        """The expression in Piecewise form, whose second derivatives have no DiracDelta."""
        symbols = {d: s for s, d in self.symbols.items()}
        symbols |= {d: f for f, d in self.floats.items() if d.is_Dummy}
        symbols |= {k: sm.floor(s) for s, k in self.steps.items()}
        result = self.piecewise
        while not find_symbols([result]).keys().isdisjoint(symbols):  # floors may be nested
            result = replace_symbols(result, symbols)
        return result

    def _by_conditions(self, f: sm.Expr) -> sm.Expr:
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

    def _floor(self, s: sm.Expr) -> sm.Dummy:
        return self.steps.setdefault(s, sm.Dummy("k", integer=True))

    def _surfaces(self) -> Iterator[tuple[sm.Basic, sm.Expr, sm.Expr, tuple[sm.Expr, sm.Expr]]]:
        """Yield each switch, both sides of its surface's equation, and both expressions."""
        conditions = [
            r for r in self.piecewise.atoms(Relational)
            if self._depends_on_motion(r)
            and not isinstance(r, (sm.Eq, sm.Ne))  # these concern isolated points only
        ]  # fmt: skip
        conditions.sort(key=sm.default_sort_key)
        excess = {r: r.gts - r.lts for r in conditions}  # positive where it holds
        done: set[Relational] = set()
        for r in conditions:
            if r in done:
                continue
            sides = {
                relation: sm.true if same == 0 else sm.false
                for relation in conditions
                for same in (sm.expand(excess[relation] - excess[r]),)
                if same == 0 or sm.expand(excess[relation] + excess[r]) == 0
            }
            done.update(sides)
            opposite = {relation: sm.Not(holds) for relation, holds in sides.items()}
            equal = (r.lhs, r.rhs) if r.lhs.free_symbols else (r.rhs, r.lhs)
            yield (r, *equal, (self.piecewise.xreplace(sides), self.piecewise.xreplace(opposite)))
        for s, k in self.steps.items():
            yield k, s, k, (self.piecewise, self.piecewise.xreplace({k: k - 1}))

    def _read(self) -> None:
        """Read each surface into the graph: its equation, and the expressions on both sides."""
        g = self.graph
        names = [*self.symbols.values(), *self.steps.values()]
        names += [d for d in self.floats.values() if d.is_Dummy]
        self.inputs = {d: g.input("x", k) for k, d in enumerate(names)}
        self.exact = {d: float(f) for f, d in self.floats.items()}
        read = SymPyReader(g, {sm.nan: g.const(np.nan), **self.inputs}, self.subject)
        moving_nodes = [self.inputs[v] for v in self.moving]
        for switch, left_side, right, sides in self._surfaces():
            nodes = read.all(_without_common_terms(*sides))
            if self.slopes:
                a, b = (jacobian(g, [node], moving_nodes).flat() for node in nodes)
                nodes += [n for pair in zip(a, b, strict=True) for n in pair]
            for substitution in _surface_substitutions(left_side, right, self.moving):
                targets = [
                    self._number_input(v) if v.is_number else read(v) for v in substitution.values()
                ]
                onto = dict(zip(read.all(substitution), targets, strict=True))
                for f, node in zip(substitution, list(targets), strict=True):
                    if f.func in _BOUNDED:  # outside its range there is no surface
                        targets.append(g.call(_BOUNDED[f.func], node))
                substituted = substitute(g, nodes, onto)
                every = [*substituted, *rounding_bounds(g, substituted), *targets]
                self.surfaces.append((switch, len(nodes), g.evaluator(every)))

    def _number_input(self, value: sm.Expr) -> int:
        """Return an input with the value of a number, so that rounding bounds include it."""
        symbol = sm.Dummy(str(value), real=True)
        self.exact[symbol] = float(value) if value.is_extended_real else np.nan
        self.inputs[symbol] = self.graph.input("x", len(self.inputs))
        return self.inputs[symbol]

    def check(self, constants: Mapping[AnySymbol, float] | None = None) -> None:
        """Refuse switches with a jump; constants without values are drawn at random."""
        for f in self.functions:
            if isinstance(f, sm.DiracDelta):
                self._refuse(f)
        inputs = self._drawn(constants) if self.surfaces else {}
        for switch, n, evaluate in self.surfaces:
            with np.errstate(all="ignore"):
                values = evaluate(inputs, DRAWS**2).T
                a, b = values[:n:2], values[1:n:2]
                near = np.nan_to_num(values[n : 2 * n : 2] + values[n + 1 : 2 * n : 2])
                off = ~(np.abs(a - b) <= ROUNDING_MARGIN * ROUNDING * near) & (a != b)
            off &= ~(np.isnan(a) & np.isnan(b))
            # No surface, or no value on one side of it: other checks report that.
            off = off.any(axis=0) & np.isfinite([*values[:2], *values[2 * n :]]).all(axis=0)
            if off.reshape(DRAWS, DRAWS).any(axis=1).all():
                self._refuse(
                    next(
                        f
                        for f in self.functions
                        if self._rewritten(f.xreplace(self.floats)).has(switch)
                    )
                )

    def _drawn(self, values: Mapping[AnySymbol, float] | None) -> dict[int, np.ndarray]:
        """Draw random inputs: the constants vary by row, the other inputs by column, too.

        Coordinates are drawn over all magnitudes, because their units are unknown.
        """
        draws, shape = np.random.default_rng(0), (DRAWS, DRAWS)
        exact = dict(self.exact)
        if values is not None:
            exact |= {d: values[s] for s, d in self.symbols.items() if s in values}
        drawn = {}
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
            drawn[node] = x.ravel()
        return drawn

    def _refuse(self, function: sm.Expr) -> None:
        function_text = replace_symbols(function, {d: s for s, d in self.symbols.items()})
        must, part = "must not jump", "a ramp"
        if self.slopes:
            must, part = "must have no jumps and no kinks", "one with a continuous slope"
        raise ValueError(
            f"{self.subject} {must}, got `{shown(function_text)}` in it. Give one contact for each "
            f"smooth part, or a smooth transition: {part}."
        )


def _is_folded(e: sm.Basic) -> bool:
    """Whether an expression is √(s²), an inverse such as asin(sin(s)), or an acot."""
    if e.is_Pow:
        powers = (f for f in sm.Mul.make_args(e.base) if f.is_Pow)
        return e.exp.is_integer is False and any(f.exp.is_even for f in powers)
    return isinstance(e, sm.acot) or (
        bool(e.args) and isinstance(e.args[0], _INVERSES.get(e.func, ()))
    )


def _unfolded(e: sm.Expr) -> sm.Expr:
    """Return an equivalent expression in functions that switch."""
    half = sm.pi / 2
    if e.is_Pow:
        return e
    if isinstance(e, sm.acot):  # SymPy's acot jumps at zero
        return half - sm.atan(e.args[0]) - sm.pi * sm.Heaviside(-e.args[0])
    s = e.args[0].args[0]
    if isinstance(e, sm.atan):
        return sm.Mod(s + half, sm.pi) - half
    s = s - half if isinstance(e.args[0], sm.sin) else s
    angle = sm.Abs(sm.Mod(s + sm.pi, 2 * sm.pi) - sm.pi)  # the angle of the cosine of s
    return half - angle if isinstance(e, sm.asin) else angle


def _surface_substitutions(
    left_side: sm.Expr, right_side: sm.Expr, moving: Sequence[sm.Dummy]
) -> list[dict[sm.Expr, sm.Expr]]:
    """Return substitutions that solve the equation of a surface, left_side = right_side."""
    excess = left_side - right_side
    parts = [e for e in excess.atoms(sm.Function, sm.Pow) if not e.free_symbols.isdisjoint(moving)]
    parts.sort(key=sm.default_sort_key)
    for degree, unknowns in ((1, moving), (2, moving), (1, parts)):
        for v in unknowns:
            z = sm.Dummy("z", real=True)
            polynomial = excess.xreplace({v: z})
            if not (
                polynomial.has(z)
                and polynomial.is_polynomial(z)
                and sm.degree(polynomial, z) == degree
            ):
                continue
            *square, a, b = sm.Poly(polynomial, z).all_coeffs()
            if not square:
                return [{v: -b / a}]
            root = sm.sqrt(a**2 - 4 * square[0] * b)
            return [{v: (root - a) / (2 * square[0])}, {v: (-root - a) / (2 * square[0])}]
    return [{left_side: right_side}]


def _without_common_terms(a: sm.Expr, b: sm.Expr) -> tuple[sm.Expr, sm.Expr]:
    """Return two expressions without their common terms."""
    first, second = (Counter(sm.Add.make_args(e)) for e in (a, b))
    return sm.Add(*(first - second).elements()), sm.Add(*(second - first).elements())
