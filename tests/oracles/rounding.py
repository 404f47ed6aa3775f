"""How far floating-point arithmetic may take the value of an expression: a running bound.

`bounded` walks a SymPy expression with 50 digits and carries, beside each value, a bound on what
rounding does to it. An operation adds its own rounding (half a unit of the last place for
arithmetic and square roots, a whole one for other functions) to what it makes of the bounds of its
operands. That is evaluated at the operands moved by `SAFETY` times their bounds, not by derivatives
at the point, so that curvature is no loophole: as long as operands are within SAFETY times their
bounds, so is the result.

A sum is bounded by the sizes of its terms, whatever their order (Higham, Accuracy and Stability of
Numerical Algorithms, 2nd ed., §4.2): its partial sums may be as large as all of them together.
"""

import mpmath as mp
import sympy as sm
from sympy.core.numbers import NumberSymbol

__all__ = ["SAFETY", "OutsideError", "UnclearError", "bounded"]

SAFETY = 8
DIGITS = 50
UNIT = mp.mpf(2) ** -53
LARGE, SMALL = mp.mpf(10) ** 40, mp.mpf(10) ** -40


class UnclearError(Exception):
    """A switch, the edge of a domain, a pole or the edge of the range is within the bound."""


class OutsideError(Exception):
    """An operand is outside the domain of a real function, by more than its bound: NaN."""


def bounded(expression, numbers):
    """The value of an expression and a bound on its rounding error, as mpf.

    Parameters
    ----------
    expression : SymPy expression
    numbers : dict of symbols to floats
        Taken as exact.
    """
    with mp.workdps(DIGITS):
        return _Walk({s: mp.mpf(float(v)) for s, v in numbers.items()}).visit(expression)


class _Walk:
    def __init__(self, numbers):
        self.known = {s: (v, mp.mpf(0)) for s, v in numbers.items()}

    def visit(self, expression):
        pair = self.known.get(expression)
        if pair is None:
            if isinstance(expression, (sm.Number, NumberSymbol)):
                pair = _number(expression)
            elif isinstance(expression, sm.Piecewise):
                pair = self._piecewise(expression)
            elif isinstance(expression, sm.Pow):
                pair = _power(*self.visit(expression.base), expression.exp)
            else:
                rule = _RULES[expression.func]
                pair = rule(*(self.visit(a) for a in expression.args))
            if pair[0] and not SMALL < abs(pair[0]) < LARGE:
                raise UnclearError
            self.known[expression] = pair
        return pair

    def _piecewise(self, expression):
        for value, condition in expression.args:
            try:
                truth = self._truth(condition)
            except OutsideError:
                raise UnclearError from None
            if truth:
                return self.visit(value)
        raise OutsideError

    def _truth(self, condition):
        if condition in (sm.true, sm.false):
            return condition == sm.true
        if isinstance(condition, (sm.And, sm.Or, sm.Not)):
            parts = [self._truth(a) for a in condition.args]
            return {sm.And: all, sm.Or: any}.get(condition.func, lambda p: not p[0])(parts)
        if isinstance(condition, sm.ITE):
            test, yes, no = condition.args
            return self._truth(yes if self._truth(test) else no)
        (a, ea), (b, eb) = (self.visit(side) for side in condition.args)
        if ea + eb and abs(a - b) <= SAFETY * (ea + eb):
            raise UnclearError
        return {"<": a < b, "<=": a <= b, ">": a > b, ">=": a >= b, "==": a == b, "!=": a != b}[
            condition.rel_op
        ]


def _number(number):
    if isinstance(number, sm.Rational):
        value = mp.mpf(int(number.p)) / int(number.q)
    elif isinstance(number, sm.Float):
        value = mp.mpf(number._mpf_)
    else:
        value = number._to_mpmath(mp.mp.prec)
    return value, UNIT * abs(value) if float(value) != value else mp.mpf(0)


def _moved(function, x, e):
    """How far f(x) moves while x moves within its bound."""
    if not e:
        return mp.mpf(0)
    value = function(x)
    ends = [abs(function(x + s * SAFETY * e) - value) for s in (-1, 1)]
    return max(ends) / SAFETY


def _sum(*terms):
    size = sum(abs(v) for v, _ in terms)
    value = sum(v for v, _ in terms)
    return value, sum(e for _, e in terms) + (len(terms) - 1) * UNIT * size


def _product(*factors):
    value, wide = mp.mpf(1), mp.mpf(1)
    for v, e in factors:
        value *= v
        wide *= abs(v) + SAFETY * e
    return value, (wide - abs(value)) / SAFETY + (len(factors) - 1) * UNIT * abs(value)


def _power(base, e, exponent):
    whole = isinstance(exponent, sm.Integer)
    n, rounded = _number(exponent)
    if not whole and base < -SAFETY * e:
        raise OutsideError
    if (n < 0 or not whole) and abs(base) <= SAFETY * e:
        if e or n < 0:
            raise UnclearError
        return mp.mpf(0), mp.mpf(0)
    n = int(exponent) if whole else n
    value = base**n
    if mp.isint(2 * n):
        # By multiplications: each adds a rounding, and a squaring doubles those before it.
        own = (abs(n) + (n < 0) + (not whole)) * UNIT
    else:
        own = 2 * UNIT + abs(mp.log(base)) * rounded
    return value, _moved(lambda x: x**n, base, e) + own * abs(value)


def _smooth(function):
    def rule(argument):
        x, e = argument
        if SAFETY * e > mp.mpf("0.1"):
            raise UnclearError
        value = function(x)
        return value, _moved(function, x, e) + 2 * UNIT * abs(value)

    return rule


def _between(function, low, high):
    """A function that is defined from `low` to `high`, with whatever slope at the ends."""

    def rule(argument):
        x, e = argument
        if x < low - SAFETY * e or x > high + SAFETY * e:
            raise OutsideError
        if e and (x - SAFETY * e <= low or x + SAFETY * e >= high):
            raise UnclearError
        if function is mp.log and x <= 0:
            raise UnclearError
        return _smooth(function)(argument)

    return rule


def _tan(argument):
    x, e = argument
    if abs(mp.cos(x)) <= 2 * SAFETY * e:
        raise UnclearError
    return _smooth(mp.tan)(argument)


def _cot(argument):  # SymPy's tan(x + π/2); evaluated as 1 / tan(x)
    return _power(*_tan(argument), sm.Integer(-1))


def _atan2(y, x):
    (y, ey), (x, ex) = y, x
    radius, e = mp.hypot(y, x), mp.hypot(ey, ex)
    if radius <= 2 * SAFETY * e or (x <= SAFETY * ex and abs(y) <= SAFETY * ey):
        raise UnclearError
    value = mp.atan2(y, x)
    return value, e / (radius - SAFETY * e) + 2 * UNIT * abs(value)


def _sign(argument):
    x, e = argument
    if e and abs(x) <= SAFETY * e:
        raise UnclearError
    return mp.sign(x), mp.mpf(0)


def _floor(argument):
    x, e = argument
    if e and abs(x - mp.nint(x)) <= SAFETY * e:
        raise UnclearError
    return mp.floor(x), mp.mpf(0)


def _extreme(choose):
    # Neither is a jump: the error of the greatest is no greater than the greatest error.
    return lambda *parts: (choose(v for v, _ in parts), max(e for _, e in parts))


_RULES = {
    sm.Add: _sum,
    sm.Mul: _product,
    sm.exp: _smooth(mp.exp),
    sm.log: _between(mp.log, 0, mp.inf),
    sm.sin: _smooth(mp.sin),
    sm.cos: _smooth(mp.cos),
    sm.tan: _tan,
    sm.cot: _cot,
    sm.asin: _between(mp.asin, -1, 1),
    sm.atan: _smooth(mp.atan),
    sm.sinh: _smooth(mp.sinh),
    sm.tanh: _smooth(mp.tanh),
    sm.atan2: _atan2,
    sm.Abs: lambda x: (abs(x[0]), x[1]),
    sm.sign: _sign,
    sm.floor: _floor,
    sm.Min: _extreme(min),
    sm.Max: _extreme(max),
    sm.re: lambda x: x,
}
