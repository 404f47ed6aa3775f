"""Print the equations of motion: SymPy expressions as short as in a textbook."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from html import escape
from itertools import chain, count
from typing import TYPE_CHECKING

import sympy as sm
from sympy.physics.vector import vlatex

from pydy._collector import collector_paused
from pydy._graph import Graph, SymPyReader, jacobian, simplify
from pydy._mechanics.equations import Equations
from pydy._mechanics.inverse import BodyDynamics
from pydy._mechanics.symbols import find_symbols, replace_symbols
from pydy._mechanics.to_sympy import written
from pydy._mechanics.trigonometric import Textbook, TooLongError
from pydy._names import name_of

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, TimeFunction


@dataclass(frozen=True, eq=False)
class EquationsOfMotion:
    """Equations of motion to read.

    ``mass_matrix * u' = forcing + constraint_jacobian.T * λ`` and ``q' = kinematics``, where
    λ are the multipliers of ``constraint_jacobian * u + … = 0``, for all speeds.

    Attributes
    ----------
    coordinates, speeds : tuple
    mass_matrix : Matrix, shape (n, n)
    forcing : Matrix, shape (n, 1)
    kinematics : Matrix, shape (k, 1)
    constraint_jacobian : Matrix, shape (c, n)
    names : dict
        What the short names stand for, in an order in which each needs earlier ones alone.
    """

    coordinates: tuple[TimeFunction, ...]
    speeds: tuple[TimeFunction, ...]
    mass_matrix: sm.Matrix
    forcing: sm.Matrix
    kinematics: sm.Matrix
    constraint_jacobian: sm.Matrix
    names: dict[sm.Symbol, sm.Expr] = field(default_factory=dict)

    def written_out(self, expression: sm.Expr | sm.Matrix) -> sm.Expr | sm.Matrix:
        """Return an expression, or a matrix of them, without the short names."""
        needed = set(sm.sympify(expression).free_symbols)
        for symbol in reversed(self.names):
            if symbol in needed:
                needed |= self.names[symbol].free_symbols
        full: dict[sm.Symbol, sm.Expr] = {}
        for symbol, meaning in self.names.items():
            if symbol in needed:
                full[symbol] = replace_symbols(meaning, full)
        if isinstance(expression, sm.MatrixBase):
            return expression.applyfunc(lambda entry: replace_symbols(entry, full))
        return replace_symbols(sm.sympify(expression), full)

    def without_names(self) -> EquationsOfMotion:
        """Return the same without the short names."""
        parts = ("mass_matrix", "forcing", "kinematics", "constraint_jacobian")
        full = {name: self.written_out(getattr(self, name)) for name in parts}
        return replace(self, **full, names={})

    def __str__(self) -> str:
        parts = [
            ("M", self.mass_matrix), ("F", self.forcing), ("q'", self.kinematics),
            ("J", self.constraint_jacobian),
        ]  # fmt: skip
        head = "M u' = F" + (" + J.T λ, J u + … = 0" if self.constraint_jacobian.rows else "")
        lines = [f"{head}, with u = ({', '.join(map(_as_text, self.speeds))})"]
        for name, matrix in parts:
            for i in range(matrix.rows):
                for j in range(matrix.cols):
                    is_repeated = name == "M" and j < i and matrix[i, j] == matrix[j, i]
                    if matrix[i, j] != 0 and not is_repeated:
                        indices = f"{i + 1}{j + 1}" if matrix.cols > 1 else f"{i + 1}"
                        lines.append(f"{name}{indices} = {_as_text(matrix[i, j])}")
        lines += [f"{symbol} = {_as_text(meaning)}" for symbol, meaning in self.names.items()]
        return "\n".join(lines)

    def _repr_latex_(self) -> str:
        rates = sm.Matrix([sm.Symbol(rf"\dot{{{vlatex(u)}}}") for u in self.speeds])
        forces = vlatex(self.forcing)
        lines = [f"{vlatex(self.mass_matrix)} {vlatex(rates)} &= {forces}"]
        if self.constraint_jacobian.rows:
            lines[0] += rf" + {vlatex(self.constraint_jacobian)}^T \lambda"
        moving = zip(self.coordinates, self.kinematics, strict=True)
        lines += [rf"\dot{{{vlatex(q)}}} &= {vlatex(rate)}" for q, rate in moving]
        lines += [f"{vlatex(s)} &= {vlatex(meaning)}" for s, meaning in self.names.items()]
        return r"$\displaystyle \begin{aligned} " + r" \\ ".join(lines) + r" \end{aligned}$"

    def _repr_html_(self) -> str | None:
        """Return a page in which the many names are folded away; None where LaTeX is enough."""
        if not any(re.fullmatch(r"z\d+", name_of(symbol)) for symbol in self.names):
            return None
        lines = str(self).split("\n")
        first = len(lines) - len(self.names)
        parts = ["\n".join(map(escape, part)) for part in (lines[:first], lines[first:])]
        title = f"{len(self.names)} intermediate quantities"
        return (
            f"<pre>{parts[0]}</pre><details><summary>{title}</summary><pre>{parts[1]}</pre>"
            "</details>"
        )


def _as_text(expression: sm.Expr) -> str:
    """Return an expression as text, functions of time by their names, derivatives with dashes."""
    short = {}
    for symbol in find_symbols([expression]):
        if isinstance(symbol, sm.Derivative):
            dashes = "'" * symbol.derivative_count
            short[symbol] = sm.Symbol(f"{name_of(symbol.expr)}{dashes}")
        elif not isinstance(symbol, sm.Symbol):
            short[symbol] = sm.Symbol(name_of(symbol))
    return str(replace_symbols(expression, short))


@collector_paused()
def equations_to_read(equations: Equations, forces: tuple[AnySymbol, ...]) -> EquationsOfMotion:
    """Return the equations with short names."""
    q, u, n = equations.coordinates, equations.speeds, len(equations.speeds)
    kinematics, velocity = equations.kinematics, [*equations.constraints.velocity]
    if equations.formed is None and not velocity:  # the method's own alone are known
        matrix, bias = [*equations.matrices.mass_matrix], [-f for f in equations.matrices.forcing]
    else:
        body, dynamics = equations.multibody, BodyDynamics(None, forces, {})
        if body is None:
            raise ValueError(
                "The equations of motion with constraints follow from bodies and loads, but "
                "`eom_method` holds no bodies. Use the `mass_matrix_full` and `forcing_full` of "
                "the method itself."
            )
        body.check_unchanged()
        matrix = dynamics.mass_matrix(body).expressions()
        bias = dynamics.inverse_dynamics(body).expressions()
    rates = [*kinematics.coordinate_derivatives]
    moving = {*kinematics.coordinate_rates, *kinematics.speed_rates, *kinematics.zeros}
    parts = [*matrix, *bias, *rates, *velocity]
    graph = Graph()
    order = (*q, *u, *(s for s in find_symbols(parts) if s not in moving))
    read = SymPyReader.of_inputs(graph, "the equations of motion", x=dict.fromkeys(order))
    symbols = {node: symbol for symbol, node in read.atoms.items()}
    absent = [s for s in kinematics.speed_rates if s not in read.atoms]
    read.atoms.update(dict.fromkeys((*kinematics.zeros, *absent), graph.zero))
    moved = read.all(rates)
    for rate, node in zip(kinematics.coordinate_rates, moved, strict=True):
        read.define(rate, node)
    nodes = [*read.all(matrix), *(graph.neg(node) for node in read.all(bias)), *moved]
    rows = read.all(velocity)
    nodes += jacobian(graph, rows, [read.atoms[s] for s in u]).flat()
    expressions, names = _short(graph, nodes, symbols, q)
    cells = iter(expressions)
    sizes = ((n, n), (n, 1), (len(q), 1), (len(velocity), n))
    matrices = [sm.Matrix(*size, [next(cells) for _ in range(size[0] * size[1])]) for size in sizes]
    return EquationsOfMotion(q, u, matrices[0], matrices[1], matrices[2], matrices[3], names)


def _short(
    graph: Graph,
    nodes: list[int],
    symbols: Mapping[int, AnySymbol],
    coordinates: tuple[TimeFunction, ...],
) -> tuple[list[sm.Expr], dict[sm.Symbol, sm.Expr]]:
    """Write nodes as a textbook would, or with named intermediate quantities."""
    used_names = {name_of(s) for s in symbols.values()}
    name = _namer(coordinates, used_names)
    # Multiplied out as in textbooks. The number of terms of an arm in space grows tenfold with each
    # joint: beyond three they are not printed.
    if len(coordinates) <= 3:
        textbook = Textbook(graph, symbols, name)
        try:
            expressions = textbook(nodes)
            names = sorted(textbook.names, key=lambda s: (s.name[1:], s.name[0]))
            return expressions, {symbol: textbook.names[symbol] for symbol in names}
        except TooLongError:
            pass
    nodes = simplify(graph, nodes)
    numbers = count(1)

    def intermediate(op: str, expression: sm.Expr) -> sm.Symbol:
        if op in ("sin", "cos") and set(find_symbols(expression.args)) <= {*coordinates}:
            return name(op, expression.args[0])
        return next(z for z in (sm.Symbol(f"z{k}") for k in numbers) if z.name not in used_names)

    return written(graph, nodes, symbols, intermediate)


def _namer(
    coordinates: tuple[TimeFunction, ...], used_names: set[str]
) -> Callable[[str, sm.Expr], sm.Symbol]:
    """Return a function that names sines and cosines of sums of coordinates: s1, c12, s1m2."""
    names = [name_of(q) for q in coordinates]
    digits = [re.sub(r"^.*?(\d*)$", r"\1", n) for n in names]
    labels = dict(zip(coordinates, digits if all(digits) else names, strict=True))
    if len({*labels.values()}) < len(labels):
        labels = dict(zip(coordinates, names, strict=True))
    separator = "" if all(len(label) == 1 for label in labels.values()) else "_"
    symbols_of: dict[tuple[str, sm.Expr], sm.Symbol] = {}

    def name(op: str, angle: sm.Expr) -> sm.Symbol:
        if (op, angle) not in symbols_of:
            text = ""
            for part in sm.Add.make_args(angle):
                number, symbol = part.as_coeff_Mul()
                label = labels.get(symbol)
                if label is None or not number.is_Integer:
                    text = f"_{len(symbols_of) + 1}"
                    break
                sign = "m" if number < 0 else separator if text else ""
                text += sign + separator.join([label] * abs(int(number)))
            alternatives = (f"{op}_{text}{'_' * k}" for k in count())
            text = next(s for s in chain([f"{op[0]}{text}"], alternatives) if s not in used_names)
            used_names.add(text)
            symbols_of[op, angle] = sm.Symbol(text)
        return symbols_of[op, angle]

    return name
