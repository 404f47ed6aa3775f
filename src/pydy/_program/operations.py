"""The table of operations: one row has all facts of an operation.

Differentiation, evaluation with NumPy, values modulo a prime, C and LLVM code are made from these
rows. `register` adds an operation. Operations with other arguments than nodes (sums with
coefficients, powers, linear solves) are in a second table, which says where the nodes are.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Protocol

import numpy as np

from pydy._modular import cosine, sine
from pydy._program.tuning import INDEPENDENT, REDUNDANT

Nodes = tuple[int, ...]
# What an operation takes: nodes, alone or in tuples with numbers, and names (see `_STRUCTURES`).
Args = tuple[Any, ...]
# The numbers and truth values of operands, None for those that are not known.
Values = Sequence[float | bool | None]


class OperationSequence(Protocol):
    """What has operations and their arguments: a Program, or the nodes of a graph."""

    @property
    def ops(self) -> Sequence[str]: ...
    @property
    def args(self) -> Sequence[Args]: ...


class NodeBuilder(OperationSequence, Protocol):
    """What makes nodes, for the rules below: `pydy._graph.Graph`."""

    zero: int
    one: int

    def make(self, op: str, args: Args) -> int: ...
    def boolean(self, value: bool) -> int: ...
    def call(self, op: str, *nodes: int) -> int: ...
    def scaled(self, node: int) -> tuple[float, int]: ...
    def sum(self, terms: Iterable[tuple[int, float]], c0: float = 0.0) -> int: ...
    def product(self, factors: Iterable[tuple[int, int]], coefficient: float = 1.0) -> int: ...
    def add(self, *nodes: int) -> int: ...
    def sub(self, a: int, b: int) -> int: ...
    def neg(self, a: int) -> int: ...
    def mul(self, *nodes: int) -> int: ...
    def div(self, a: int, b: int) -> int: ...
    def powi(self, a: int, exponent: int) -> int: ...


@dataclass(frozen=True)
class Operation:
    """An elementary operation: real numbers or truth values in, one number or truth value out."""

    name: str  # its kind in graphs and Programs
    arity: int
    # Evaluates it for arrays. Numbers are folded with it too, so that NaN and infinity arise where
    # the machine would give them.
    numpy: Callable[..., Any]
    c: str  # an expression in C with ``{0}``, ``{1}``, … for the operands
    # The name of an emitter of `pydy._backends.llvm.emit` and its argument, such as ``'libm
    # cbrt'``: the C library's function of that name.
    llvm: str
    # ``partials(graph, node, *operands)`` returns the nodes of the partial derivatives with respect
    # to each operand. Both forward and reverse accumulation use them. Without it the operation is
    # piecewise constant.
    partials: Callable[..., Nodes] | None = None
    # ``rewrite(graph, operands, values)`` returns a simpler node or None; ``values`` holds the
    # operands' numbers and truth values, None for those that are not known.
    rewrite: Callable[[NodeBuilder, Nodes, Values], int | None] | None = None
    parity: int = 0  # 1 for an even function, −1 for an odd one: signs then leave the argument
    truth: bool = False  # whether the result is a truth value
    # Its value modulo `pydy._modular.PRIME` from the operands' values. Without it, a number
    # that depends on the operands' values alone.
    modular: Callable[..., int] | None = None
    sympy: str = ""  # the name of the SymPy class with the same arguments
    # Whether its code was generated from an expression (`pydy._program.of_scipy`).
    is_generated: ClassVar[bool] = False

    @property
    def written(self) -> str:
        """Its code in all languages, for digests."""
        return f"{self.c} {self.llvm}"


class OperationTable(dict[str, Operation]):
    """The rows by their names, and which operations belong together."""

    solves = frozenset({"factor", "solve", "guard"})
    """What solves linear systems: vectors, of which there are items."""
    angles = ("sin", "cos")
    """Computed as a pair."""
    together = (*angles, "atan")
    """Computed for several arguments together, also of one state."""

    def __init__(self) -> None:
        super().__init__()
        self.truths = {"bool"}
        """The operations whose result is a truth value."""
        self.partly_constant: frozenset[str] = frozenset()
        """Operations by which an expression may be constant on an interval and vary elsewhere."""
        self._of_sympy: dict[str, str] = {}

    def add(self, row: Operation) -> None:
        """Add an operation, or replace the one of the same name."""
        self[row.name] = row
        if row.truth:
            self.truths.add(row.name)
        if row.sympy:
            self._of_sympy[row.sympy] = row.name

    def named_in_sympy(self, name: str) -> str | None:
        """Return the operation that a SymPy class of this name stands for."""
        return self._of_sympy.get(name)

    def are_shipped(self) -> bool:
        """Return whether all rows are those of the package, generated ones aside."""
        return {name: row for name, row in self.items() if not row.is_generated} == SHIPPED

    @staticmethod
    def operands(op: str, args: Args) -> Nodes:
        """Return the nodes that an operation refers to, in order."""
        structure = _STRUCTURES.get(op)
        return args if structure is None else structure[0](args)

    @staticmethod
    def with_operands(op: str, args: Args, new: Mapping[int, int]) -> Args:
        """Return an operation's arguments with its operands looked up in `new`."""
        structure = _STRUCTURES.get(op)
        return _renamed(args, new) if structure is None else structure[1](args, new)


OPERATIONS = OperationTable()
register = OPERATIONS.add


# -- rules of simplification ----------------------------------------------------------------------


def _extremum(g: NodeBuilder, nodes: Nodes, values: Values) -> int | None:
    return nodes[0] if nodes[0] == nodes[1] else None


def _not(g: NodeBuilder, nodes: Nodes, values: Values) -> int | None:
    return None if values[0] is None else int(g.boolean(not values[0]))


def _rule_of_and_or(op: str) -> Callable[[NodeBuilder, Nodes, Values], int | None]:
    """Return the rule of ``and`` or ``or``, which take any number of operands here."""
    neutral = op == "and"

    def rule(g: NodeBuilder, nodes: Nodes, values: Values) -> int | None:
        if any(v is (not neutral) for v in values):
            return int(g.boolean(not neutral))
        unknown = tuple(dict.fromkeys(n for n, v in zip(nodes, values, strict=True) if v is None))
        if not unknown:
            return int(g.boolean(neutral))
        node = unknown[0]
        for operand in unknown[1:]:
            node = g.make(op, (node, operand))
        return node

    return rule


def _select(g: NodeBuilder, nodes: Nodes, values: Values) -> int | None:
    _, yes, no = nodes
    if values[0] is not None:
        return yes if values[0] else no
    return yes if yes == no else None


def _root(g: NodeBuilder, nodes: Nodes, values: Values) -> int | None:
    """Take squares out of a root: √(c x² y) is √c |x| √y, with a slope where x passes zero."""
    c, core = g.scaled(nodes[0])
    factors = g.args[core] if g.ops[core] == "prod" else ()
    if c < 0.0 or all(-2 < e < 2 for _, e in factors):
        return None
    halves = [(m, int(e / 2)) for m, e in factors]
    remaining = [(m, e % 2 if e > 0 else -(-e % 2)) for m, e in factors]
    odd = [m for m, e in remaining if e]
    # A factor that stays alone under a root is not negative.
    out = g.product([(m, e) for m, e in halves if [m] != odd])
    root = g.call("sqrt", g.product(remaining))
    return int(
        g.product(
            [(g.call("abs", out), 1), *((m, e) for m, e in halves if [m] == odd), (root, 1)],
            math.sqrt(c),
        )
    )


def _rule_of_kept(g: NodeBuilder, nodes: Nodes, values: Values) -> int | None:
    return nodes[0] if values[0] is not None or g.ops[nodes[0]] == "kept" else None


# -- derivatives ----------------------------------------------------------------------------------


def _root_of(g: NodeBuilder, x: int, sign: float, c0: float) -> int:
    """Return ``1/√(c0 + sign·x²)``."""
    return int(g.powi(g.call("sqrt", g.sum([(g.powi(x, 2), sign)], c0)), -1))


def _bell(g: NodeBuilder, x: int) -> int:
    """Return the derivative of the error function."""
    return int(g.product([(g.call("exp", g.neg(g.powi(x, 2))), 1)], 2.0 / math.sqrt(math.pi)))


def _pow(g: NodeBuilder, n: int, a: int, b: int) -> Nodes:
    by_base = g.mul(b, g.call("pow", a, g.sum([(b, 1.0)], -1.0)))
    # log(0) · 0 at a zero base would be NaN where the derivative is 0.
    by_exponent = g.call("select", g.call("eq", a, g.zero), g.zero, g.mul(n, g.call("log", a)))
    return by_base, by_exponent


def _partials_of_atan2(g: NodeBuilder, n: int, y: int, x: int) -> Nodes:
    """Return x / (x² + y²) and −y / (x² + y²), by y and by x."""
    square = g.add(g.powi(y, 2), g.powi(x, 2))
    return g.div(x, square), g.neg(g.div(y, square))


def _leads(g: OperationSequence, a: int, b: int) -> bool:
    """Return whether the first term of a − b is positive: where a = b, derivatives take a > b."""
    difference: dict[int, float] = {}
    for node, sign in ((a, 1.0), (b, -1.0)):
        terms = g.args[node][1] if g.ops[node] == "sum" else ((node, 1.0),)
        for n, c in terms:
            if g.ops[n] != "const":
                difference[n] = difference.get(n, 0.0) + sign * c
    return next((difference[n] > 0.0 for n in sorted(difference) if difference[n] != 0.0), True)


def _chosen(first: Callable[[NodeBuilder, int, int], int]) -> Callable[..., Nodes]:
    """Return the derivatives of a function that is one of its two operands."""

    def partials(g: NodeBuilder, n: int, a: int, b: int) -> Nodes:
        takes_first = first(g, a, b)
        return g.call("select", takes_first, g.one, g.zero), g.call(
            "select", takes_first, g.zero, g.one
        )

    return partials


# -- the table ------------------------------------------------------------------------------------


# NumPy has none, and those of SciPy lose digits in the tails.
_ERF, _ERFC = (np.vectorize(f, otypes=[float]) for f in (math.erf, math.erfc))


def _function(
    name: str,
    numpy: Callable[..., Any],
    llvm: str,
    partials: Callable[..., Nodes] | None = None,
    **fields: Any,
) -> None:
    """Register a function of one operand."""
    c = fields.pop("c", name)
    register(Operation(name, 1, numpy, f"{c}({{0}})", llvm, partials, **fields))


def _infix(name: str, numpy: Callable[..., Any], c: str, llvm: str, **fields: Any) -> None:
    register(Operation(name, 2, numpy, f"{{0}} {c} {{1}}", llvm, **fields))


# Graphs hold sums and products, which Programs write out with these.
_infix("add", np.add, "+", "arithmetic fadd")
_infix("sub", np.subtract, "-", "arithmetic fsub")
_infix("mul", np.multiply, "*", "arithmetic fmul")
_infix("div", np.divide, "/", "arithmetic fdiv")
register(Operation("neg", 1, np.negative, "-{0}", "negation"))

_function(
    "sqrt", np.sqrt, "intrinsic sqrt", lambda g, n, x: (g.product([(n, -1)], 0.5),), rewrite=_root
)
_function("exp", np.exp, "libm exp", lambda g, n, x: (n,), sympy="exp")
_function("log", np.log, "libm log", lambda g, n, x: (g.powi(x, -1),))
_function(
    "sin", np.sin, "sincos 0", lambda g, n, x: (g.call("cos", x),),
    parity=-1, modular=sine, sympy="sin",
)  # fmt: skip
_function(
    "cos", np.cos, "sincos 1", lambda g, n, x: (g.neg(g.call("sin", x)),),
    parity=1, modular=cosine, sympy="cos",
)  # fmt: skip
_function(
    "tan", np.tan, "libm tan", lambda g, n, x: (g.sum([(g.powi(n, 2), 1.0)], 1.0),),
    parity=-1, sympy="tan",
)  # fmt: skip
_function(
    "asin", np.arcsin, "libm asin", lambda g, n, x: (_root_of(g, x, -1.0, 1.0),),
    parity=-1, sympy="asin",
)  # fmt: skip
_function(
    "acos", np.arccos, "libm acos", lambda g, n, x: (g.neg(_root_of(g, x, -1.0, 1.0)),),
    sympy="acos",
)  # fmt: skip
_function(
    "atan", np.arctan, "arctangent",
    lambda g, n, x: (g.powi(g.sum([(g.powi(x, 2), 1.0)], 1.0), -1),), parity=-1, sympy="atan",
)  # fmt: skip
_function(
    "sinh", np.sinh, "libm sinh", lambda g, n, x: (g.call("cosh", x),), parity=-1, sympy="sinh"
)
_function(
    "cosh", np.cosh, "libm cosh", lambda g, n, x: (g.call("sinh", x),), parity=1, sympy="cosh"
)
_function(
    "tanh", np.tanh, "libm tanh", lambda g, n, x: (g.sum([(g.powi(n, 2), -1.0)], 1.0),),
    parity=-1, sympy="tanh",
)  # fmt: skip
_function(
    "asinh", np.arcsinh, "libm asinh", lambda g, n, x: (_root_of(g, x, 1.0, 1.0),),
    parity=-1, sympy="asinh",
)  # fmt: skip
_function(
    "acosh", np.arccosh, "libm acosh", lambda g, n, x: (_root_of(g, x, 1.0, -1.0),), sympy="acosh"
)
_function(
    "atanh", np.arctanh, "libm atanh",
    lambda g, n, x: (g.powi(g.sum([(g.powi(x, 2), -1.0)], 1.0), -1),), parity=-1, sympy="atanh",
)  # fmt: skip
_function("erf", _ERF, "libm erf", lambda g, n, x: (_bell(g, x),), parity=-1, sympy="erf")
_function("erfc", _ERFC, "libm erfc", lambda g, n, x: (g.neg(_bell(g, x)),), sympy="erfc")
_function(
    "abs", np.abs, "intrinsic fabs", lambda g, n, x: (g.call("sign", x),),
    parity=1, c="fabs", sympy="Abs",
)  # fmt: skip
_function("sign", np.sign, "sign", parity=-1, sympy="sign")
_function("floor", np.floor, "intrinsic floor", sympy="floor")
_function("ceil", np.ceil, "intrinsic ceil", sympy="ceiling")

register(Operation("pow", 2, np.power, "pow({0}, {1})", "libm pow", _pow))
register(
    Operation(
        "atan2", 2, np.arctan2, "atan2({0}, {1})", "libm atan2", _partials_of_atan2, sympy="atan2"
    )
)
register(
    Operation(
        "min", 2, np.minimum, "minimum({0}, {1})", "intrinsic minimum",
        _chosen(lambda g, a, b: g.call("lt" if _leads(g, a, b) else "le", a, b)), _extremum,
    )
)  # fmt: skip
register(
    Operation(
        "max", 2, np.maximum, "maximum({0}, {1})", "intrinsic maximum",
        _chosen(lambda g, a, b: g.call("le" if _leads(g, a, b) else "lt", b, a)), _extremum,
    )
)  # fmt: skip

_infix("lt", np.less, "<", "comparison olt", truth=True, sympy="StrictLessThan")
_infix("le", np.less_equal, "<=", "comparison ole", truth=True, sympy="LessThan")
_infix("eq", np.equal, "==", "comparison oeq", truth=True, sympy="Equality")
_infix("ne", np.not_equal, "!=", "comparison une", truth=True, sympy="Unequality")
_infix(
    "and", np.logical_and, "&", "logic and", rewrite=_rule_of_and_or("and"), truth=True, sympy="And"
)
_infix("or", np.logical_or, "|", "logic or", rewrite=_rule_of_and_or("or"), truth=True, sympy="Or")
register(
    Operation("not", 1, np.logical_not, "!{0}", "inversion", rewrite=_not, truth=True, sympy="Not")
)
register(Operation("select", 3, np.where, "{0} ? {1} : {2}", "selection", rewrite=_select))

# A number computed by the formula at hand. Rewriting stops here, since equal formulas may lose
# different numbers of digits. Lowering omits it.
register(
    Operation(
        "kept", 1, np.positive, "+{0}", "intrinsic arithmetic.fence",
        lambda g, n, x: (g.one,), _rule_of_kept,
    )
)  # fmt: skip

SHIPPED = dict(OPERATIONS)
"""The rows of the package itself."""


# -- operations with other arguments than nodes ---------------------------------------------------

Renamed = Callable[[Args, Mapping[int, int]], Args]


def _renamed(nodes: Sequence[int], new: Mapping[int, int]) -> Nodes:
    return tuple([new[n] for n in nodes])


def _leaf(args: Args, new: Mapping[int, int]) -> Args:
    return args


OPERATIONS.partly_constant = frozenset({"abs", "min", "max"}) | {
    name for name, row in OPERATIONS.items() if row.partials is None and name != "neg"
}

# For each kind: its operands, in order, and its arguments with other operands.
_STRUCTURES: dict[str, tuple[Callable[[Args], Nodes], Renamed]] = {
    "const": (lambda a: (), _leaf),
    "bool": (lambda a: (), _leaf),
    "input": (lambda a: (), _leaf),
    "sum": (
        lambda a: tuple([n for n, _ in a[1]]),
        lambda a, new: (a[0], tuple([(new[n], c) for n, c in a[1]])),
    ),
    "prod": (
        lambda a: tuple([n for n, _ in a]),
        lambda a, new: tuple([(new[n], e) for n, e in a]),
    ),
    "factor": (lambda a: a[2], lambda a, new: (a[0], a[1], _renamed(a[2], new))),
    "solve": (lambda a: (a[0], *a[1]), lambda a, new: (new[a[0]], _renamed(a[1], new))),
    "guard": (
        lambda a: (*a[1], *a[2], a[3], *a[4]),
        lambda a, new: (
            a[0],
            _renamed(a[1], new),
            _renamed(a[2], new),
            new[a[3]],
            _renamed(a[4], new),
        ),
    ),
    "item": (lambda a: (a[0],), lambda a, new: (new[a[0]], a[1])),
}


def symmetric(n: int, entries: Sequence[int]) -> list[int]:
    """Return the matrix that the lower triangle stands for, whatever the upper one holds."""
    rows = ((entries[i * n : i * n + i], entries[i * n + i :: n]) for i in range(n))
    return [entry for before, below in rows for entry in (*before, *below)]


def constraint_mark(*, independent: bool) -> float:
    """Return what marks a constraint on the diagonal of a system; see `is_constrained`."""
    return INDEPENDENT if independent else REDUNDANT


def is_constrained(nodes: OperationSequence, entries: Sequence[int]) -> bool:
    """Return whether a guard solves a constrained system, by the mark of its last row.

    Rows so marked on the diagonal are constraints, in units of their rounding errors; as many as
    are marked `INDEPENDENT` are so at generic states (`pydy._program.interpret.constrained`).
    """
    marks = (INDEPENDENT,), (REDUNDANT,)
    return bool(entries) and nodes.ops[entries[-1]] == "const" and nodes.args[entries[-1]] in marks
