"""Replace kinks of an objective, where its minimum may be, by unknowns and smooth conditions.

A term c·max(a, b) with c ≥ 0 that is minimised has the same minimum as c·s with s ≥ a and s ≥ b
(the epigraph form; S. Boyd and L. Vandenberghe, Convex Optimization, §4.1.3): at the minimum s is
as small as both conditions allow, for any a and b. Likewise |a| = max(a, −a), and min(a, b) with
c ≤ 0. Derivatives are then smooth, so that a search can converge to a point with a = b, which is
common for sums of absolute values.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import sympy as sm
from sympy.core.function import AppliedUndef

from pydy.control.transcription import Condition, Lifted

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol

_MOST_PARTS = 16  # most smooth conditions that replace one with kinks
_LARGE = 400  # operations of a Piecewise whose branches are compared by SymPy


@dataclass(frozen=True)
class Epigraph:
    """A smooth objective, with the unknowns and conditions that replace its kinks."""

    expression: sm.Expr
    unknown: tuple[Lifted, ...] = ()
    kinks: tuple[sm.Expr, ...] = ()  # the expression that each unknown equals at the minimum
    conditions: tuple[Condition, ...] = ()


def epigraph(
    expression: sm.Expr,
    depends_on_unknowns: Callable[[sm.Expr], bool],
    values: Mapping[AnySymbol, float],
) -> Epigraph:
    """Replace the kinks of an objective where that changes no minimum.

    `depends_on_unknowns` is a test of an expression. `values` are the numbers of the constants that
    are not free; only their signs matter.
    """
    unchanged = Epigraph(sm.sympify(expression))
    candidates = list(dict.fromkeys(_outermost(unchanged.expression)))
    kinks = [
        (kink, form)
        for kink in candidates
        if depends_on_unknowns(kink) and (form := _extremum(kink))
    ]
    if not kinks:
        return unchanged
    dummies = {kink: sm.Dummy(f"kink{k}", real=True) for k, (kink, _) in enumerate(kinks)}
    remainder = unchanged.expression.xreplace(dummies)
    unknown, conditions, unlifted = [], [], {}
    for kink, (sign, parts) in kinks:
        dummy = dummies[kink]
        factor = remainder.diff(dummy)
        if factor.has(*dummies.values()) or not _has_sign(factor, sign, values):
            unlifted[dummy] = kink
            continue
        unknown.append(Lifted(dummy, sign, len(parts)))
        for part in parts:
            relation = f"{part} <= {kink}" if sign > 0 else f"{part} >= {kink}"
            # The rows are scaled, so no factor is needed.
            conditions.append(Condition(sign * (dummy - part), 0.0, float("inf"), relation))
    if not unknown:
        return unchanged
    lifted = tuple(kink for kink, dummy in dummies.items() if dummy not in unlifted)
    return Epigraph(remainder.xreplace(unlifted), tuple(unknown), lifted, tuple(conditions))


def split(
    condition: Condition,
    depends_on_unknowns: Callable[[sm.Expr], bool],
    values: Mapping[AnySymbol, float],
) -> list[Condition]:
    """Return smooth conditions that are together equivalent to a condition with kinks.

    A maximum is below a limit if and only if all of its arguments are. The arguments are those of
    `epigraph`.
    """
    conditions, done = [condition], 0
    side = {(True, False): 1, (False, True): -1}.get(
        (condition.low == -float("inf"), condition.high == float("inf")), 0
    )
    while side and done < len(conditions) <= _MOST_PARTS:
        expression = conditions[done].expression
        for kink in dict.fromkeys(_outermost(expression)):
            form = _extremum(kink) if depends_on_unknowns(kink) else None
            dummy = sm.Dummy("kink", real=True)
            remainder = expression.xreplace({kink: dummy})
            factor = remainder.diff(dummy)
            if form is None or factor.has(dummy) or not _has_sign(factor, side * form[0], values):
                continue
            conditions[done : done + 1] = [
                replace(condition, expression=remainder.xreplace({dummy: part})) for part in form[1]
            ]
            break
        else:
            done += 1
    return conditions if len(conditions) <= _MOST_PARTS else [condition]


def _outermost(expression: sm.Expr) -> Sequence[sm.Expr]:
    """Return the kinks that are not nested in others, in a fixed order."""
    if _may_bend(expression):
        return [expression]
    return [kink for part in expression.args for kink in _outermost(part)]


def _may_bend(expression: sm.Expr) -> bool:
    if isinstance(expression, sm.Pow):  # the root of a square
        base, power = expression.args
        return bool(power == sm.S.Half and base.is_Pow and base.exp == 2)
    return isinstance(expression, (sm.Abs, sm.Max, sm.Min, sm.Piecewise))


def _extremum(kink: sm.Expr) -> tuple[int, tuple[sm.Expr, ...]] | None:
    """Return (1, arguments) of a maximum, (−1, arguments) of a minimum, or None."""
    if isinstance(kink, (sm.Max, sm.Min)):
        return (1 if isinstance(kink, sm.Max) else -1), kink.args
    if isinstance(kink, sm.Piecewise):
        return _of_branches(kink)
    inner = kink.args[0] if isinstance(kink, sm.Abs) else kink.args[0].base
    return 1, (inner, -inner)


def _of_branches(kink: sm.Expr) -> tuple[int, tuple[sm.Expr, ...]] | None:
    """Return a Piecewise of two branches as a maximum or minimum, or None; as `_extremum` does.

    The difference of the branches must be a multiple of the switch. With a − b = k·s, where the
    first branch a holds for s > 0, it is max(a, b) for k > 0.
    """
    if len(kink.args) != 2 or kink.args[1].cond != sm.true or kink.count_ops() > _LARGE:
        return None
    (first, condition), (second, _) = kink.args
    if not isinstance(condition, (sm.Gt, sm.Ge, sm.Lt, sm.Le)):
        return None
    ratio = sm.cancel((first - second) / (condition.gts - condition.lts))
    if not ratio.is_number or not ratio.is_real or ratio.is_zero:
        return None
    return (1 if ratio.is_positive else -1), (first, second)


def _has_sign(factor: sm.Expr, sign: int, values: Mapping[AnySymbol, float]) -> bool:
    """Return whether sign · factor is nonnegative for all real values of its symbols.

    Only the signs of constants are used, so that the result holds for other values of these signs.
    """
    real: dict[AnySymbol, sm.Dummy] = {}
    for a in factor.atoms(sm.Symbol, AppliedUndef, sm.Derivative):
        value = values.get(a)
        kinds = {} if value is None else {
            "zero": value == 0.0, "positive": value > 0.0, "negative": value < 0.0,
        }  # fmt: skip
        real[a] = sm.Dummy(real=True, **{k: True for k, holds in kinds.items() if holds})
    return bool((sign * factor.xreplace(real)).is_nonnegative)
