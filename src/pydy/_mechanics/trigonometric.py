"""Polynomials in sines and cosines, in the short forms of textbooks.

A node of sums, products and powers of inputs, and of sines and cosines of sums of angles, is a
Laurent polynomial in e^{iθ} of each angle θ:

    f = Σ c_{n,m} e^{i n·θ} x^m,        n whole numbers, x all other inputs,

which is unique, so that all terms cancel that can. It is then expressed in several bases, cosines
of sums of angles or products of functions of single or accumulated angles with sin² or cos²
eliminated, and the shortest result is selected. Common factors are extracted, the most frequent
first. A node that is not such a polynomial, a root for instance, counts as an input.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import TYPE_CHECKING

import sympy as sm

from pydy._graph import Graph
from pydy._mechanics.to_sympy import applied, exact
from pydy._mechanics.tuning import READABLE
from pydy._program import OPERATIONS
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    from sympy.logic.boolalg import Boolean

    from pydy._sympy_types import AnySymbol

Powers = tuple[tuple[int, int], ...]  # of angles or factors, none zero, in order
Key = tuple[Powers, Powers]  # the harmonic n, and the powers m
# Coefficients, each with the sum of the magnitudes of its terms.
Polynomial = dict[Key, tuple[complex, float]]


class TooLongError(Exception):
    """The expression has too many terms to be readable."""


def _times(a: Powers, b: Powers) -> Powers:
    powers = dict(a)
    for key, n in b:
        powers[key] = powers.get(key, 0) + n
    return tuple(sorted((key, n) for key, n in powers.items() if n))


def _added(parts: Sequence[tuple[Polynomial, complex]]) -> Polynomial:
    total: Polynomial = {}
    for polynomial, factor in parts:
        for key, (c, size) in polynomial.items():
            before = total.get(key, (0.0, 0.0))
            total[key] = before[0] + factor * c, before[1] + abs(factor) * size
    return {key: pair for key, pair in total.items() if abs(pair[0]) > ROUNDED * pair[1]}


def _multiplied(a: Polynomial, b: Polynomial) -> Polynomial:
    if len(a) * len(b) > READABLE**2:
        raise TooLongError
    parts = [
        ({(_times(n, m), _times(p, q)): (c * d, s * t)}, 1.0)
        for (n, p), (c, s) in a.items()
        for (m, q), (d, t) in b.items()
    ]
    product_ = _added(parts)
    if len(product_) > READABLE:
        raise TooLongError
    return product_


def _power(base: Polynomial, exponent: int) -> Polynomial:
    power: Polynomial = {((), ()): (1.0, 1.0)}
    for _ in range(exponent):
        power = _multiplied(power, base)
    return power


@dataclass
class Textbook:
    """Writes nodes of one graph, whose inputs have `symbols`.

    ``name('sin', expression)`` returns what the sine of an angle is called; `names` has what was
    named so far, and what it stands for.
    """

    graph: Graph
    symbols: Mapping[int, AnySymbol]
    name: Callable[[str, sm.Expr], sm.Symbol]
    names: dict[sm.Symbol, sm.Expr] = field(default_factory=dict)
    _polynomials: dict[int, Polynomial] = field(default_factory=dict)
    _truths: dict[int, Boolean] = field(default_factory=dict)
    _factors: list[sm.Expr] = field(default_factory=list)
    _angles: list[sm.Expr] = field(default_factory=list)
    _named: dict[sm.Symbol, sm.Expr] = field(default_factory=dict)

    def __call__(self, nodes: Sequence[int]) -> list[sm.Expr]:
        """Return nodes as expressions; raises TooLongError if they would be too long."""
        for node in self.graph.reachable(nodes):
            op, args = self.graph.ops[node], self.graph.args[node]
            if op == "bool":
                self._truths[node] = sm.true if args[0] else sm.false
            elif op in OPERATIONS.truths:
                self._truths[node] = applied(op, self._operands(node))
            else:
                self._polynomials[node] = self._polynomial(node)
        return [self._shortest(self._polynomials[node]) for node in nodes]

    # -- reading -----------------------------------------------------------------------------------

    def _polynomial(self, node: int) -> Polynomial:
        op, args = self.graph.ops[node], self.graph.args[node]
        if op == "const":
            return {((), ()): (args[0], abs(args[0]))} if args[0] else {}
        if op == "input":
            return self._factor(self.symbols[node])
        if op == "sum":
            parts: list[tuple[Polynomial, complex]] = [
                (self._polynomials[n], c) for n, c in args[1]
            ]
            return _added([({((), ()): (1.0, 1.0)}, args[0]), *parts])
        if op == "prod":
            product_: Polynomial = {((), ()): (1.0, 1.0)}
            for n, e in args:
                product_ = _multiplied(product_, self._raised(self._polynomials[n], e))
            return product_
        if (
            op in ("sin", "cos")
            and (harmonic := self._harmonic(self._polynomials[args[0]])) is not None
        ):
            back = tuple((angle, -n) for angle, n in harmonic)
            half = (0.5, 0.5) if op == "cos" else (-0.5j, 0.5)
            return {(harmonic, ()): half, (back, ()): (half[0].conjugate(), 0.5)}
        if op == "kept":
            return self._polynomials[args[0]]
        return self._factor(applied(op, self._operands(node)))

    def _operands(self, node: int) -> list[sm.Expr]:
        return [
            self._truths[n] if n in self._truths else self._shortest(self._polynomials[n])
            for n in self.graph.operands(node)
        ]

    def _factor(self, expression: sm.Expr, exponent: int = 1) -> Polynomial:
        if expression.is_Number and (expression or exponent > 0):
            value = float(expression) ** exponent
            return {((), ()): (value, abs(value))}
        if expression not in self._factors:
            self._factors.append(expression)
        return {((), ((self._factors.index(expression), exponent),)): (1.0, 1.0)}

    def _raised(self, base: Polynomial, exponent: int) -> Polynomial:
        if exponent > 0:
            return _power(base, exponent)
        if len(base) == 1:
            ((harmonic, powers), (c, _)) = next(iter(base.items()))
            if not harmonic:
                inverse = c**exponent
                return {((), tuple((k, exponent * n) for k, n in powers)): (inverse, abs(inverse))}
        return self._factor(self._shortest(base), exponent)

    def _harmonic(self, angle: Polynomial) -> Powers | None:
        """Return whole multiples of angles, or None for other arguments."""
        multiples = []
        for (harmonic, powers), (c, _) in angle.items():
            is_integer = c == complex(c).real and float(complex(c).real).is_integer()
            if harmonic or not is_integer or len(powers) != 1 or powers[0][1] != 1:
                return None
            symbol = self._factors[powers[0][0]]
            if symbol not in self._angles:
                self._angles.append(symbol)
            multiples.append((self._angles.index(symbol), int(complex(c).real)))
        return tuple(sorted(multiples)) if multiples else None

    # -- writing -----------------------------------------------------------------------------------

    def _shortest(self, polynomial: Polynomial) -> sm.Expr:
        candidates = [self._nested([*terms]) for terms in self._written(polynomial)]
        best = min(candidates, key=lambda expression: sm.count_ops(expression))
        used = best.free_symbols
        for candidate, meaning in self._named.items():
            if candidate in used:
                self.names[candidate] = meaning
        return best

    def _written(self, polynomial: Polynomial) -> Iterator[list[tuple[float, dict[sm.Expr, int]]]]:
        """Yield the terms in several bases: coefficients, and powers of factors."""
        yield list(self._as_harmonics(polynomial))
        used = sorted({angle for harmonic, _ in polynomial for angle, _ in harmonic})
        if not any(sum(abs(n) for _, n in harmonic) > 1 for harmonic, _ in polynomial):
            return
        for accumulated in product((False, True), repeat=max(len(used) - 1, 0)):
            for square in ("sin", "cos"):
                try:
                    yield self._as_products(polynomial, used, accumulated, square)
                except TooLongError:
                    continue

    def _as_harmonics(self, polynomial: Polynomial) -> Iterator[tuple[float, dict[sm.Expr, int]]]:
        for (harmonic, powers), (c, _) in polynomial.items():
            factors = [(self._factors[k], n) for k, n in powers]
            if not harmonic:
                yield complex(c).real, _collected(factors)
            elif harmonic[0][1] > 0:
                for op, value in (("cos", 2.0 * complex(c).real), ("sin", -2.0 * complex(c).imag)):
                    if value:
                        yield value, _collected([(self._trigonometric(op, harmonic), 1), *factors])

    def _trigonometric(self, op: str, harmonic: Powers) -> sm.Symbol:
        angle = sm.Add(*(n * self._angles[k] for k, n in harmonic))
        symbol = self.name(op, angle)
        self._named[symbol] = applied(op, [angle])
        return symbol

    def _as_products(
        self, polynomial: Polynomial, used: Sequence[int], accumulated: Sequence[bool], square: str
    ) -> list[tuple[float, dict[sm.Expr, int]]]:
        """Write e^{i n θ} as powers of cosines and sines; one of the two occurs at most once.

        If `accumulated`, an angle is replaced by its sum with those before.
        """
        sums: list[Powers] = []
        for k, angle in enumerate(used):
            sums.append(
                ((angle, 1),) if k == 0 or not accumulated[k - 1] else (*sums[-1], (angle, 1))
            )
        # Numbers after the existing factors: cosine and sine of each angle.
        first = len(self._factors)
        total: list[tuple[Polynomial, complex]] = []
        for (harmonic, powers), (c, size) in polynomial.items():
            remaining, counts = dict(harmonic), [0] * len(used)
            for k in reversed(range(len(used))):
                counts[k] = remaining.get(used[k], 0)
                for angle, _ in sums[k]:
                    remaining[angle] = remaining.get(angle, 0) - counts[k]
            term: Polynomial = {((), powers): (c, size)}
            for k, count in enumerate(counts):
                cosine, sine = first + 2 * k, first + 2 * k + 1
                turn: Polynomial = {
                    ((), ((cosine, 1),)): (1.0, 1.0),
                    ((), ((sine, 1),)): (1.0j if count > 0 else -1.0j, 1.0),
                }
                for _ in range(abs(count)):
                    term = _reduced(_multiplied(term, turn), cosine, sine, square)
            total.append((term, 1.0))
        functions = {
            first + 2 * k + j: (op, sums[k])
            for k in range(len(used))
            for j, op in enumerate(("cos", "sin"))
        }
        terms = []
        for (_, powers), (c, _) in _added(total).items():
            factors = [
                (self._trigonometric(*functions[k]) if k in functions else self._factors[k], n)
                for k, n in powers
            ]
            terms.append((complex(c).real, _collected(factors)))
        return terms

    def _nested(self, terms: list[tuple[float, dict[sm.Expr, int]]]) -> sm.Expr:
        """Return a sum with common factors extracted, the most frequent first."""
        if len(terms) < 2:
            return sm.Add(*(_product(c, powers) for c, powers in terms))
        counts: Counter[tuple[sm.Expr, int]] = Counter()
        kinds: dict[sm.Expr, set[int]] = {}
        for _, powers in terms:
            counts.update((f, n) for f, n in powers.items() if n > 0)
            for f, n in powers.items():
                kinds.setdefault(f, set()).add(n)
        # l² + 2 l c is not factored: textbooks do not write l (l + 2 c).
        even = {f: count for (f, n), count in counts.items() if kinds[f] == {n}}
        most = max(even.values(), default=0)
        if most < 2:
            return sm.Add(*(_product(c, powers) for c, powers in terms))
        factor = min((f for f, count in even.items() if count == most), key=sm.default_sort_key)
        with_factor = [(c, powers) for c, powers in terms if factor in powers]
        without_factor = [(c, powers) for c, powers in terms if factor not in powers]
        least = with_factor[0][1][factor]
        inner = []
        for c, powers in with_factor:
            inner.append((c, {f: n for f, n in powers.items() if f != factor}))
        sizes = {abs(c) for c, _ in inner}
        number = sizes.pop() if len(sizes) == 1 else 1.0
        if all(c < 0.0 for c, _ in inner):
            number = -number
        quotient = self._nested([(c / number, powers) for c, powers in inner])
        product_ = sm.Mul(exact(number), factor**least, quotient, evaluate=True)
        return product_ + self._nested(without_factor) if without_factor else product_


def _collected(factors: Sequence[tuple[sm.Expr, int]]) -> dict[sm.Expr, int]:
    """Sum the powers of equal factors; 1/cos θ is a separate factor from cos θ."""
    powers: dict[sm.Expr, int] = {}
    for factor, n in factors:
        powers[factor] = powers.get(factor, 0) + n
    return {factor: n for factor, n in powers.items() if n}


def _product(c: float, powers: Mapping[sm.Expr, int]) -> sm.Expr:
    return sm.Mul(exact(c), *(f**n for f, n in powers.items()))


def _reduced(polynomial: Polynomial, cosine: int, sine: int, square: str) -> Polynomial:
    """Replace the square of a sine (or cosine) by one minus that of the other."""
    replaced, replacement = (sine, cosine) if square == "sin" else (cosine, sine)
    parts: list[tuple[Polynomial, complex]] = []
    for (harmonic, powers), pair in polynomial.items():
        n = dict(powers).get(replaced, 0)
        if n < 2:
            parts.append(({(harmonic, powers): pair}, 1.0))
            continue
        reduced = _times(powers, ((replaced, -2),))
        parts.append(({(harmonic, reduced): pair}, 1.0))
        parts.append(({(harmonic, _times(reduced, ((replacement, 2),))): pair}, -1.0))
    return _added(parts)
