"""SymPy expressions into graph nodes, each distinct sub-expression once.

The walk keeps a table by object identity, not by SymPy's ``==``: comparing two equal expressions
that were built separately walks both trees, and the trees of multibody equations can be millions
of times larger than their graphs. Equal expressions still meet, because the graph hash-conses.
The walk is iterative, so that depth is no limit.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache, partial
from typing import TYPE_CHECKING, SupportsIndex

import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.core.numbers import NumberSymbol
from sympy.logic.boolalg import BooleanFalse, BooleanTrue

from pydy._errors import UnsupportedFunctionError
from pydy._graph.derivative import directional
from pydy._graph.inputs import inputs_of
from pydy._graph.node import Graph
from pydy._graph.rewrite import make_canonical, rebuild, substitute
from pydy._program import OPERATIONS, ScipyOperation

if TYPE_CHECKING:
    from sympy.printing.str import StrPrinter

    from pydy._program import Args
    from pydy._sympy_types import AnySymbol

Handler = Callable[[Graph, sm.Basic, list[int]], int]


def _reciprocal(op: str) -> Handler:
    return lambda graph, expr, args: graph.powi(graph.call(op, *args), -1)


def _of_reciprocal(op: str) -> Handler:
    return lambda graph, expr, args: graph.call(op, graph.powi(args[0], -1))


def _fold(op: str) -> Handler:
    def handler(graph: Graph, expr: sm.Basic, args: list[int]) -> int:
        node = args[0]
        for operand in args[1:]:
            node = graph.call(op, node, operand)
        return node

    return handler


def _swapped(op: str) -> Handler:
    return lambda graph, expr, args: graph.call(op, args[1], args[0])


def _power(graph: Graph, expr: sm.Pow, args: list[int]) -> int:
    base, exponent = args
    number = expr.exp
    if number.is_Float and float(number).is_integer() and abs(number) <= 64:
        number = sm.Integer(int(number))
    if number.is_Integer and abs(int(number)) <= 64:
        return graph.powi(base, int(number))
    if number.is_Rational and number.q == 2 and abs(number.p) <= 64:
        return graph.powi(graph.call("sqrt", base), int(number.p))
    if expr.base is sm.E:
        return graph.call("exp", exponent)
    return graph.call("pow", base, exponent)


def _piecewise(graph: Graph, expr: sm.Piecewise, args: list[int]) -> int:
    node = graph.const(float("nan"))  # where no condition holds SymPy gives NaN
    for pair in reversed(args):
        value, condition = graph.args[pair]
        node = graph.call("select", condition, value, node)
    return node


def _heaviside(graph: Graph, expr: sm.Heaviside, args: list[int]) -> int:
    x, at_zero = args
    above = graph.call("select", graph.call("eq", x, graph.zero), at_zero, graph.one)
    node = graph.call("select", graph.call("lt", x, graph.zero), graph.zero, above)
    # A NaN argument must give NaN, and comparisons with NaN are all false.
    return graph.call("select", graph.call("eq", x, x), node, x)


def _mod(graph: Graph, expr: sm.Mod, args: list[int]) -> int:
    a, b = args
    return graph.sub(a, graph.mul(b, graph.call("floor", graph.div(a, b))))


def _sinc(graph: Graph, expr: sm.sinc, args: list[int]) -> int:
    x = args[0]
    ratio = graph.div(graph.call("sin", x), x)
    # Below 1 a series, to rounding with its second derivative: those of the ratio cancel there.
    square, series = graph.powi(x, 2), graph.zero
    for k in range(9, -1, -1):
        coefficient = (-1) ** k / math.factorial(2 * k + 1)
        series = graph.sum([(graph.mul(square, series), 1.0)], coefficient)
    return graph.call("select", graph.call("lt", square, graph.one), series, ratio)


def _acot(graph: Graph, expr: sm.acot, args: list[int]) -> int:
    return graph.call("atan", graph.powi(args[0], -1))


def _xor(graph: Graph, expr: sm.Xor, args: list[int]) -> int:
    node = args[0]
    for operand in args[1:]:
        either = graph.call("or", node, operand)
        conjunction = graph.call("and", node, operand)
        node = graph.call("and", either, graph.call("not", conjunction))
    return node


def _if_then_else(graph: Graph, expr: sm.ITE, args: list[int]) -> int:
    # Of truth values; SymPy makes it of a Piecewise inside a condition.
    condition, yes, no = args
    otherwise = graph.call("and", graph.call("not", condition), no)
    return graph.call("or", graph.call("and", condition, yes), otherwise)


def _equivalent(graph: Graph, expr: sm.Equivalent, args: list[int]) -> int:
    none = graph.call("and", *(graph.call("not", a) for a in args))
    return graph.call("or", graph.call("and", *args), none)


def _log(graph: Graph, expr: sm.log, args: list[int]) -> int:
    node = graph.call("log", args[0])
    return node if len(args) == 1 else graph.div(node, graph.call("log", args[1]))


# What is not a row of the table of operations under its own name.
class Formula(sm.Atom):  # type: ignore[misc]
    """A node of a graph, as a function of some of its inputs."""

    __slots__ = ("graph", "inputs", "name", "node")

    graph: Graph
    node: int
    inputs: tuple[int, ...]
    name: sm.Basic | str

    def __new__(
        cls, graph: Graph, node: int, inputs: tuple[int, ...], name: sm.Basic | str | None = None
    ) -> Formula:
        """Make a formula; two are equal if they are of the same node of the same graph."""
        self: Formula = super().__new__(cls)
        self.graph, self.node, self.inputs = graph, node, inputs
        self.name = f"formula {node}" if name is None else name
        return self

    def __reduce_ex__(self, protocol: SupportsIndex) -> tuple[type[Formula], tuple[object, ...]]:
        return type(self), (self.graph, self.node, self.inputs, self.name)

    def _hashable_content(self) -> tuple[int, int]:
        return (id(self.graph), self.node)

    def _sympystr(self, printer: StrPrinter) -> str:
        return str(self.name)


class NodeExpression(sm.Expr):  # type: ignore[misc]
    """A SymPy expression that is kept as a node of a graph: a formula, applied to symbols."""

    is_commutative = True

    @classmethod
    def of(
        cls,
        graph: Graph,
        node: int,
        symbols: Mapping[int, sm.Expr],
        name: sm.Basic | str | None = None,
    ) -> NodeExpression:
        """Return the expression of a node; `symbols` are those of the inputs.

        It prints as its name, which may be an expression, or as a number.
        """
        inputs = tuple(inputs_of(graph, [node]))
        formula = Formula(graph, node, inputs, name)
        expression: NodeExpression = cls(formula, *(symbols[n] for n in inputs))
        return expression

    @staticmethod
    def of_derivative(expr: sm.Basic) -> NodeExpression | None:
        """Return a derivative that SymPy left unevaluated, by the rules of the graph; else None.

        At steps the derivatives of ``Mod``, ``floor`` and others are those of the branch that is
        taken. An UnsupportedFunctionError tells that it is by something that an undefined function
        depends on, or holds a function that cannot be translated.
        """
        return _differentiated(expr) if _is_unevaluated(expr) else None

    def _eval_derivative(self, symbol: AnySymbol) -> sm.Derivative:
        return sm.Derivative(self, symbol, evaluate=False)

    def _sympystr(self, printer: StrPrinter) -> str:
        return str(self.args[0].name)


def _node_expression(graph: Graph, expr: NodeExpression, args: list[int]) -> int:
    formula = expr.args[0]
    inputs = dict(zip(formula.inputs, args[1:], strict=True))
    return substitute(formula.graph, [formula.node], inputs, into=graph)[0]


HANDLERS: dict[type[sm.Basic], Handler] = {
    NodeExpression: _node_expression,
    Formula: lambda graph, expr, args: graph.zero,  # read by what applies it
    sm.Add: lambda graph, expr, args: graph.add(*args),
    sm.Mul: lambda graph, expr, args: graph.mul(*args),
    sm.Pow: _power,
    sm.log: _log,
    sm.cot: _reciprocal("tan"),
    sm.sec: _reciprocal("cos"),
    sm.csc: _reciprocal("sin"),
    sm.sinc: _sinc,
    sm.acot: _acot,
    sm.asec: _of_reciprocal("acos"),
    sm.acsc: _of_reciprocal("asin"),
    sm.coth: _reciprocal("tanh"),
    sm.sech: _reciprocal("cosh"),
    sm.csch: _reciprocal("sinh"),
    sm.acoth: _of_reciprocal("atanh"),
    sm.asech: _of_reciprocal("acosh"),
    sm.acsch: _of_reciprocal("asinh"),
    sm.frac: lambda graph, expr, args: graph.sub(args[0], graph.call("floor", args[0])),
    sm.Mod: _mod,
    sm.Min: _fold("min"),
    sm.Max: _fold("max"),
    sm.Heaviside: _heaviside,
    sm.Piecewise: _piecewise,
    sm.functions.elementary.piecewise.ExprCondPair: lambda graph, expr, args: graph.make(
        "pair", tuple(args)
    ),
    sm.StrictGreaterThan: _swapped("lt"),
    sm.GreaterThan: _swapped("le"),
    sm.Xor: _xor,
    sm.Implies: lambda graph, expr, args: graph.call("or", graph.call("not", args[0]), args[1]),
    sm.Equivalent: _equivalent,
    sm.ITE: _if_then_else,
    # Everything here is real, so these are what SymPy could not simplify for want of assumptions.
    sm.re: lambda graph, expr, args: args[0],
    sm.conjugate: lambda graph, expr, args: args[0],
    sm.im: lambda graph, expr, args: graph.zero,
    sm.UnevaluatedExpr: lambda graph, expr, args: args[0],  # the curves of muscles hold some
}


def _handler(kind: type) -> Handler | None:
    """Return the translator of expressions of a SymPy class, or None."""
    handler = HANDLERS.get(kind)
    if handler is None and issubclass(kind, sm.Basic) and not issubclass(kind, AppliedUndef):
        name = OPERATIONS.named_in_sympy(kind.__name__)
        return None if name is None else lambda graph, expr, args: graph.call(name, *args)
    return handler


class SymPyReader:
    """Reads SymPy expressions into one graph.

    The `atoms` map symbols, functions of time and derivatives to nodes; names can be added later.
    Messages say `what` is being read.
    """

    def __init__(
        self, graph: Graph, atoms: Mapping[AnySymbol, int], what: str = "the expressions"
    ) -> None:
        self.graph = graph
        self.atoms = dict(atoms)
        self.what = what
        self._node_of: dict[int, int] = {}
        self._alive: list[sm.Basic] = []  # keeps ids unique while the table lives

    @staticmethod
    def of_inputs(graph: Graph, what: str, /, **groups: Iterable[AnySymbol]) -> SymPyReader:
        """Return a reader of symbols that are inputs, made in the order of the arguments.

        Each group of inputs has its symbols in order: ``x=states, t=[time]``. A symbol in several
        groups belongs to the last.
        """
        atoms = {
            symbol: graph.input(group, k)
            for group, symbols in groups.items()
            for k, symbol in enumerate(symbols)
        }
        return SymPyReader(graph, atoms, what)

    def define(self, atom: AnySymbol, node: int) -> None:
        """Let `atom` stand for `node` from now on."""
        self.atoms[atom] = node
        self._node_of.clear()
        self._alive.clear()

    def __call__(self, expression: sm.Basic | float) -> int:
        """Return the node of one expression, or say which part of it has none."""
        root = expression if isinstance(expression, sm.Basic) else sm.sympify(expression)
        try:
            return self._read(root)
        except _ImaginaryUnitError:
            return self._read(real_part(root, self.what))

    def _read(self, root: sm.Basic) -> int:
        graph, node_of, alive = self.graph, self._node_of, self._alive
        stack: list[tuple[sm.Basic, Handler | None]] = [(root, None)]
        while stack:
            expr, handler = stack.pop()
            key = id(expr)
            if key in node_of:
                continue
            args = expr.args
            if handler is not None:  # its operands are done
                node_of[key] = handler(graph, expr, [node_of[id(a)] for a in args])
                continue
            alive.append(expr)
            handler = _handler(type(expr)) if args else None
            if handler is None:
                leaf = None if _is_unevaluated(expr) else self._leaf(expr)
                if leaf is not None:
                    node_of[key] = leaf
                    continue
                handler = _handler(expr.func)
                if handler is None:
                    node_of[key] = self._otherwise(expr)
                    continue
            stack.append((expr, handler))
            stack += [(a, None) for a in reversed(args) if id(a) not in node_of]
        return node_of[id(root)]

    def all(self, expressions: Iterable[sm.Basic | float]) -> list[int]:
        """Return the nodes of several expressions."""
        node_of = self._node_of
        if isinstance(expressions, sm.MatrixBase):
            expressions = expressions.flat()  # one by one, each takes as long as reading it
        nodes = ((node_of.get(id(e)), e) for e in expressions)
        return [self(e) if node is None else node for node, e in nodes]

    def _leaf(self, expr: sm.Basic) -> int | None:
        if isinstance(expr, Formula) or (
            expr.args and not isinstance(expr, (AppliedUndef, sm.Derivative))
        ):
            return None
        node: int | None = self.atoms.get(expr)
        if node is not None:
            return node
        if isinstance(expr, (BooleanTrue, BooleanFalse)):
            return self.graph.boolean(bool(expr))
        if isinstance(expr, (sm.Number, NumberSymbol)) and expr is not sm.nan:
            value = float(expr)
            if math.isinf(value) and expr.is_finite:
                raise ValueError(f"A number in {self.what} is beyond the range of floats.")
            return self.graph.const(value)
        if isinstance(expr, (sm.Symbol, AppliedUndef, sm.Derivative)):
            raise ValueError(
                f"`{expr}` occurs in {self.what}, but no argument provides it: it is not one of "
                "the coordinates, speeds, constants or specifieds. Add it to one of them: where a "
                f"System's motion does not depend on it, {_place_of(expr)}."
            )
        if expr is sm.I:
            raise _ImaginaryUnitError
        if expr.is_number:
            raise ValueError(
                f"`{expr}` occurs in {self.what}, and is not a real number. Simplify the "
                "expression or restrict its symbols so that it cannot arise, and look for infinite "
                "numbers: SymPy makes `nan` of `oo` times what may be zero."
            )
        raise UnsupportedFunctionError(self._unsupported(expr))

    def _otherwise(self, expr: sm.Basic) -> int:
        """Return the node of what is no operation: written out, or as a function of SciPy."""
        try:
            expansion = self._written_out(expr)
        except UnsupportedFunctionError:
            if (expansion := written_for_scipy(expr)) is None:
                raise
            code, operands, partials = expansion
            description = f"the function `{expr.func.__name__}` in `{_brief(expr)}`"
            name = ScipyOperation.named(code, len(operands), description, partials)
            return self.graph.call(name, *map(self, operands))
        return self(expansion)

    def _written_out(self, expr: sm.Basic) -> sm.Basic:
        """Return the expression that a function stands for, as the curves of muscles do."""
        if (derivative := NodeExpression.of_derivative(expr)) is not None:
            return derivative
        written = expr.doit(deep=False) if isinstance(expr, (sm.Function, sm.Product)) else expr
        if isinstance(written, type(expr)):
            raise UnsupportedFunctionError(self._unsupported(expr))
        return written

    def _unsupported(self, expr: sm.Basic) -> str:
        return (
            f"The function `{expr.func.__name__}` occurs in {self.what}, in `{_brief(expr)}`, and "
            "cannot be translated to numerical code. Rewrite it with elementary functions "
            "(`expr.rewrite(...)`, `expr.doit()`), Piecewise, Min, Max, Abs or sign, or "
            "interpolate it over the range that occurs: `sympy.interpolating_spline(3, x, points, "
            "values)`. What depends on constants alone may be a constant of its own."
        )


def _brief(expr: sm.Basic) -> str:
    text = str(expr)
    return text if len(text) <= 120 else text[:117] + "..."


class _ImaginaryUnitError(Exception):
    """An expression holds the imaginary unit."""


def real_part(expr: sm.Expr, what: str) -> sm.Expr:
    """Return an expression that holds `I` without it, as exp(I x) + exp(-I x); x is real here."""
    named = {
        s: sm.Dummy(s.name if s.is_Symbol else str(s), real=True)
        for s in expr.atoms(sm.Symbol, AppliedUndef, sm.Derivative)
    }
    separated = expr.xreplace(named)
    if isinstance(separated, sm.Expr):
        real, imaginary = separated.as_real_imag()
        if sm.expand(imaginary) == 0 or sm.simplify(imaginary) == 0:
            return real.xreplace({dummy: symbol for symbol, dummy in named.items()})
    raise ValueError(
        f"The imaginary unit occurs in {what}, in `{_brief(expr)}`, which is not known to be real "
        "for real symbols. Give its real part without `I`: `expand_complex(re(expr))` of symbols "
        "that are real, or other solutions of the equation it comes from."
    )


# -- functions that only SciPy computes ------------------------------------------------------------

# Functions of scipy.special that SymPy's printer does not know; both take the parameter m = k².
_FURTHER_FUNCTIONS = {
    "elliptic_k": "scipy.special.ellipk",
    "elliptic_f": "scipy.special.ellipkinc",
    "elliptic_e": [
        (lambda *arguments: len(arguments) == 1, "scipy.special.ellipe"),
        (lambda *arguments: len(arguments) == 2, "scipy.special.ellipeinc"),
    ],
    "zeta": "scipy.special.zeta",
}
_OF_SCIPY = {
    "strict": True,
    "allow_unknown_functions": False,
    "fully_qualified_modules": True,
    "user_functions": _FURTHER_FUNCTIONS,
}


def written_for_scipy(
    expr: sm.Expr,
) -> tuple[str, list[sm.Expr], Callable[..., tuple[int, ...]]] | None:
    """Return a function, sum or integral as code for SciPy, its operands, and its derivatives.

    None if SymPy's printer for SciPy does not know it.
    """
    from sympy.printing.codeprinter import PrintMethodNotImplementedError
    from sympy.printing.numpy import SciPyPrinter

    if isinstance(expr, sm.Function) and not isinstance(expr, AppliedUndef):
        operands = [a for a in dict.fromkeys(expr.args) if not a.is_number]
    elif isinstance(expr, (sm.Sum, sm.Integral)) and _is_definite(expr):
        functions = {e: sm.Dummy() for e in expr.atoms(AppliedUndef, sm.Derivative)}
        free = expr.xreplace(functions).free_symbols  # not the variables of the limits
        free_functions = {e for e, dummy in functions.items() if dummy in free}
        free = free_functions | (free - {*functions.values()})
        operands = sorted(free, key=sm.default_sort_key)
    else:
        return None
    slots = [sm.Symbol(f"_{k}", real=True) for k in range(len(operands))]
    template = expr.xreplace(dict(zip(operands, slots, strict=True)))
    try:
        code = SciPyPrinter(_OF_SCIPY).doprint(template)
    except (PrintMethodNotImplementedError, NotImplementedError, TypeError):
        return None

    def partials(graph: Graph, node: int, *nodes: int) -> tuple[int, ...]:
        read = SymPyReader(graph, dict(zip(slots, nodes, strict=True)), f"the derivative of {expr}")
        derivatives = [sm.diff(template, slot) for slot in slots]
        for derivative in derivatives:
            if any(_is_unevaluated(e) for e in derivative.atoms(sm.Derivative, sm.Subs)):
                raise UnsupportedFunctionError(
                    f"The derivative of `{_brief(expr)}` is needed, but SymPy does not know it."
                )
        return tuple(map(read, derivatives))

    return code, operands, partials


def _is_definite(expr: sm.Sum | sm.Integral) -> bool:
    """Return whether limits are numbers or expressions without the variables of others."""
    bound = {limit[0] for limit in expr.limits}
    return all(
        len(limit) == 3 and not bound & {*limit[1].free_symbols, *limit[2].free_symbols}
        for limit in expr.limits
    )


# -- derivatives that SymPy leaves unevaluated ----------------------------------------------------


def _place_of(symbol: sm.Expr) -> str:
    """Return where a user names a symbol that the equations do not hold."""
    if isinstance(symbol, sm.Symbol):
        return "by name in its `constants_symbols`"
    return "by an output that holds it, in its `outputs`"


def _is_unevaluated(expr: sm.Basic) -> bool:
    """Return whether an expression is a derivative that can be taken, or holds one at a point.

    SymPy has no rules for those of ``Mod``, ``floor`` and others. A derivative of an undefined
    function is a symbol.
    """
    if isinstance(expr, sm.Derivative):
        return not isinstance(expr.expr, AppliedUndef)
    return isinstance(expr, sm.Subs)


class _OpenReader(SymPyReader):
    """Reads expressions; each symbol becomes an input when it is met."""

    def _leaf(self, expr: sm.Basic) -> int | None:
        if isinstance(expr, (sm.Symbol, AppliedUndef, sm.Derivative)) and expr not in self.atoms:
            self.atoms[expr] = self.graph.input("x", len(self.atoms))
        return super()._leaf(expr)


@lru_cache(maxsize=512)
def _differentiated(expr: sm.Derivative | sm.Subs) -> NodeExpression:
    graph = Graph()
    read = _OpenReader(graph, {})
    node = read(expr.expr)
    if isinstance(expr, sm.Subs):
        points = dict(zip(expr.variables, expr.point, strict=True))
        if any(_inside(v, read.atoms) for v in points):
            raise UnsupportedFunctionError(read._unsupported(expr))
        symbols = {n: points.get(s, s) for s, n in read.atoms.items()}
        return NodeExpression.of(graph, node, symbols, expr)
    for variable, count in expr.variable_count:
        if not count.is_Integer:
            raise UnsupportedFunctionError(read._unsupported(expr))
        for _ in range(int(count)):
            rates = _rates(variable, read.atoms)
            if rates is None:
                raise UnsupportedFunctionError(read._unsupported(expr))
            seeds = {read.atoms[s]: {0: read(rate)} for s, rate in rates.items()}
            (row,) = directional(graph, [node], seeds)
            (node,) = rebuild(graph, [row.get(0, graph.zero)], partial(_flattened, graph))
    return NodeExpression.of(graph, node, {n: s for s, n in read.atoms.items()}, expr)


def _flattened(graph: Graph, node: int, op: str, args: Args) -> int:
    """Return a node with sums of sums written as one, as SymPy writes derivatives.

    Like terms then meet, and 0.5(2a + b) is a + 0.5b: mechanisms take up to 5 % fewer operations.
    """
    if op != "sum":
        return node if args == graph.args[node] else make_canonical(graph, op, args)
    c0, terms = args[0], []
    stack = list(args[1][::-1])
    while stack:
        n, c = stack.pop()
        if graph.ops[n] == "sum":
            inner, inner_terms = graph.args[n]
            c0 += c * inner
            stack += [(m, c * d) for m, d in inner_terms[::-1]]
        else:
            terms.append(_distributed(graph, n, c))
    return graph.sum(terms, c0)


def _distributed(graph: Graph, node: int, c: float) -> tuple[int, float]:
    """Multiply a product's coefficient into one of its sums if it cancels one there."""
    if abs(c) == 1.0 or graph.ops[node] != "prod":
        return node, c
    factors = graph.args[node]
    for k, (n, exponent) in enumerate(factors):
        if exponent == 1 and graph.ops[n] == "sum":
            inner, terms = graph.args[n]
            if any(abs(c * d) == 1.0 for _, d in terms):
                scaled_sum = graph.sum([(m, c * d) for m, d in terms], c * inner)
                return graph.product([*factors[:k], (scaled_sum, 1), *factors[k + 1 :]]), 1.0
    return node, c


def _rates(variable: AnySymbol, symbols: Iterable[AnySymbol]) -> dict[AnySymbol, sm.Expr] | None:
    """Return the derivatives of symbols by one variable; None where they are not known."""
    rates: dict[AnySymbol, sm.Expr] = {}
    for symbol in symbols:
        function = symbol.expr if isinstance(symbol, sm.Derivative) else symbol
        if symbol == variable:
            rates[symbol] = sm.S.One
        elif isinstance(function, AppliedUndef) and function.args == (variable,):
            rates[symbol] = symbol.diff(variable)
        elif _inside(variable, [function]):
            return None
    return rates


def _inside(variable: AnySymbol, symbols: Iterable[AnySymbol]) -> bool:
    """Return whether a variable is an argument of an undefined function, or a part of one."""
    return any(s != variable and s.has(variable) for s in symbols)
