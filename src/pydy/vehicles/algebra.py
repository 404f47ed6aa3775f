"""One set of functions for numbers, NumPy arrays and SymPy expressions.

Equations of tires are written once with these. For expressions, nothing is simplified by SymPy
that takes long on large expressions: the graph of expressions does that later.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from pydy._checks import number, real_array, shown

if TYPE_CHECKING:
    from pydy._sympy_types import Expression

# What the equations take and return: a number, an array, or an expression.
Quantity: TypeAlias = "float | np.ndarray | Expression"
# The same inside the equations, where no type says which sums and products there are.
Operand: TypeAlias = Any


class Zero(int):
    """The number 0 among expressions: sums and products with it are made without SymPy.

    SymPy would first ask whether each factor is finite, which takes long for large expressions.
    """

    _op_priority = 100.0  # SymPy leaves operations to whatever has such an attribute

    def __mul__(self, other: Operand) -> Operand:
        return self

    __rmul__ = __truediv__ = __mul__

    def __neg__(self) -> Zero:
        return self

    def __add__(self, other: Operand) -> Operand:
        return other

    __radd__ = __rsub__ = __add__

    def __sub__(self, other: Operand) -> Operand:
        return -other

    def __pow__(self, exponent: Operand) -> Operand:  # type: ignore[override]
        return self


class NumericAlgebra:
    """Functions of numbers and arrays."""

    symbolic = False
    sin = staticmethod(np.sin)
    cos = staticmethod(np.cos)
    tan = staticmethod(np.tan)
    atan = staticmethod(np.arctan)
    exp = staticmethod(np.exp)
    sqrt = staticmethod(np.sqrt)
    abs = staticmethod(np.abs)
    sign = staticmethod(np.sign)
    minimum = staticmethod(np.minimum)
    maximum = staticmethod(np.maximum)

    @staticmethod
    def side(x: Operand) -> Operand:
        """Return −1 where x < 0, otherwise 1."""
        return np.where(np.less(x, 0.0), -1.0, 1.0)

    @staticmethod
    def where_negative(x: Operand, yes: Operand, no: Operand) -> Operand:
        """Return `yes` where x < 0, otherwise `no`."""
        return np.where(np.less(x, 0.0), yes, no)

    @staticmethod
    def constant(value: Operand) -> Operand:
        """Return a coefficient as it enters the equations."""
        return float(value)


class SymbolicAlgebra:
    """The same functions of SymPy expressions."""

    symbolic = True

    def __init__(self) -> None:
        import sympy

        self.sympy = sympy
        self.sqrt = sympy.sqrt

    def sin(self, x: Operand) -> Operand:
        """Return the sine."""
        return self._of_angle(self.sympy.sin, x)

    def cos(self, x: Operand) -> Operand:
        """Return the cosine."""
        return self._of_angle(self.sympy.cos, x)

    def tan(self, x: Operand) -> Operand:
        """Return the tangent."""
        return self._of_angle(self.sympy.tan, x)

    def atan(self, x: Operand) -> Operand:
        """Return the arctangent."""
        return self._unevaluated(self.sympy.atan, x)

    def asin(self, x: Operand) -> Operand:
        """Return the arcsine."""
        return self._unevaluated(self.sympy.asin, x)

    def exp(self, x: Operand) -> Operand:
        """Return the exponential function."""
        return self._unevaluated(self.sympy.exp, x)

    def abs(self, x: Operand) -> Operand:
        """Return the absolute value."""
        return self._unevaluated(self.sympy.Abs, x)

    def sign(self, x: Operand) -> Operand:
        """Return the sign."""
        return self._unevaluated(self.sympy.sign, x)

    def minimum(self, x: Operand, y: Operand) -> Operand:
        """Return the smaller value."""
        return self._extreme(self.sympy.Min, x, y)

    def maximum(self, x: Operand, y: Operand) -> Operand:
        """Return the larger value."""
        return self._extreme(self.sympy.Max, x, y)

    def side(self, x: Operand) -> Operand:
        """Return −1 where x < 0, otherwise 1."""
        # SymPy would rewrite each Piecewise in the condition of another one, for many seconds.
        return self.sign(self.sign(x) + self.sympy.Rational(1, 2))

    def where_negative(self, x: Operand, yes: Operand, no: Operand) -> Operand:
        """Return `yes` where x < 0, otherwise `no`."""
        condition = self.sympy.StrictLessThan(x, 0, evaluate=not is_symbolic(x))
        if condition in (True, False):
            return yes if condition else no
        return self.sympy.Piecewise((yes, condition), (no, True), evaluate=False)

    @staticmethod
    def constant(value: Operand) -> Operand:
        """Return a coefficient as it enters the equations: terms with 0 and factors 1 vanish."""
        if is_symbolic(value):
            return value
        value = float(value)
        if value == 0.0:
            return Zero()
        return int(value) if value in (-1.0, 1.0, 2.0) else value

    def _of_angle(self, function: Operand, x: Operand) -> Operand:
        # An angle that is an arctangent, such as a slip angle, needs no function. SymPy knows that
        # too, but first looks for multiples of π in the angle, which takes long.
        if is_symbolic(x) and isinstance(x, (self.sympy.atan, self.sympy.asin, self.sympy.acos)):
            sine, cosine = self._sine_and_cosine(x)
            if function is self.sympy.tan:
                return x.args[0] if isinstance(x, self.sympy.atan) else sine / cosine
            return sine if function is self.sympy.sin else cosine
        return self._unevaluated(function, x)

    def _sine_and_cosine(self, angle: Operand) -> tuple[Operand, Operand]:
        (z,) = angle.args
        if isinstance(angle, self.sympy.atan):
            hypotenuse = self.sqrt(1 + z**2)
            return z / hypotenuse, 1 / hypotenuse
        leg = self.sqrt(1 - z**2)
        return (z, leg) if isinstance(angle, self.sympy.asin) else (leg, z)

    def _extreme(self, kind: Operand, x: Operand, y: Operand) -> Operand:
        # SymPy would sort the arguments by how many terms they have, and walk through all of them.
        if not (is_symbolic(x) or is_symbolic(y)):
            return self._unevaluated(kind, x, y)
        arguments = frozenset((self.sympy.sympify(x), self.sympy.sympify(y)))
        if len(arguments) == 1:
            return x
        result = self.sympy.Expr.__new__(kind, *map(self.sympy.sympify, (x, y)))
        result._argset = arguments
        return result

    def _unevaluated(self, function: Operand, *arguments: Operand) -> Operand:
        # SymPy would ask for the sign of each part of an expression.
        sympify = self.sympy.sympify
        if any(map(is_symbolic, arguments)):
            return function(*map(sympify, arguments), evaluate=False)
        return self.constant(function(*map(sympify, arguments)))


Algebra: TypeAlias = NumericAlgebra | SymbolicAlgebra


def algebra_of(*values: object) -> Algebra:
    """Return the algebra that some quantities need."""
    return SymbolicAlgebra() if any(map(is_symbolic, values)) else NumericAlgebra()


def is_symbolic(value: Operand) -> bool:
    """Return whether a value is a SymPy expression and no number."""
    # Of the class: to ask an expression for its symbols walks through all of it.
    return hasattr(type(value), "free_symbols") and not getattr(value, "is_number", False)


def checked_quantity(value: Operand, label: str, *, arrays: bool = True) -> Operand:
    """Return a number or an array as floats, an expression as it is; refuse all else."""
    if is_symbolic(value):
        import sympy as sm

        from pydy._expressions import has_real_values

        if not isinstance(value, sm.Expr):
            raise TypeError(f"{label} must be a number or an expression, got {shown(value)}.")
        if not has_real_values(value):
            raise ValueError(f"{label} must have real values, got {shown(value)}.")
        return value
    if not arrays or isinstance(value, (float, int)):
        return number(value, label, finite=True)
    array = real_array(value, label)
    if not np.isfinite(array).all():
        raise ValueError(f"{label} must be finite, got {shown(value)}.")
    return array if array.ndim else float(array)
