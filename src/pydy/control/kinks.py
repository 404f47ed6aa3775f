"""Kinks of an objective that a minimum may lie on, replaced by unknowns and smooth conditions.

A term c·max(a, b) with c ≥ 0 that is minimised has the same minimum as c·s with s ≥ a and s ≥ b
(the epigraph form; S. Boyd and L. Vandenberghe, Convex Optimization, §4.1.3): at the minimum s is
as small as both conditions allow. This holds whatever a and b are. Likewise |a| = max(a, −a), and
min(a, b) with c ≤ 0. Derivatives are then smooth, so that a search can end where a = b, as sums of
absolute values mostly do.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sm
from sympy.core.function import AppliedUndef

from pydy.control.transcription import Condition, Lifted

_MOST_PARTS = 16  # smooth conditions that one with kinks may become
_LARGE = 400  # operations of a Piecewise whose branches are compared by SymPy


@dataclass(frozen=True)
class Epigraph:
    """A smooth objective, and what takes the places of its kinks."""

    expression: Any
    unknown: tuple[Lifted, ...] = ()
    kinks: tuple[Any, ...] = ()  # what each stands for at the minimum
    conditions: tuple[Condition, ...] = ()


def epigraph(
    expression: Any, depends_on_unknowns: Callable[[Any], bool], values: Mapping[Any, float]
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
            # With rows in units of their own, it does not matter how large they are.
            conditions.append(Condition(sign * (dummy - part), 0.0, float("inf"), relation))
    if not unknown:
        return unchanged
    lifted = tuple(kink for kink, dummy in dummies.items() if dummy not in unlifted)
    return Epigraph(remainder.xreplace(unlifted), tuple(unknown), lifted, tuple(conditions))


def split(
    condition: Condition, depends_on_unknowns: Callable[[Any], bool], values: Mapping[Any, float]
) -> list[Condition]:
    """Return smooth conditions that hold together if and only if a condition with kinks holds.

    A largest value is below a limit if and only if all of them are; as in `epigraph`.
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


def _outermost(expression: Any) -> Sequence[Any]:
    """Return the kinks that are not inside of others, in a fixed order."""
    if _may_bend(expression):
        return [expression]
    return [kink for part in expression.args for kink in _outermost(part)]


def _may_bend(expression: Any) -> bool:
    if isinstance(expression, sm.Pow):  # the root of a square
        base, power = expression.args
        return bool(power == sm.S.Half and base.is_Pow and base.exp == 2)
    return isinstance(expression, (sm.Abs, sm.Max, sm.Min, sm.Piecewise))


def _extremum(kink: Any) -> tuple[int, tuple[Any, ...]] | None:
    """Return 1 and what a kink is the largest of, −1 and what it is the least of, or None."""
    if isinstance(kink, (sm.Max, sm.Min)):
        return (1 if isinstance(kink, sm.Max) else -1), kink.args
    if isinstance(kink, sm.Piecewise):
        return _of_branches(kink)
    inner = kink.args[0] if isinstance(kink, sm.Abs) else kink.args[0].base
    return 1, (inner, -inner)


def _of_branches(kink: Any) -> tuple[int, tuple[Any, ...]] | None:
    """Return the same of a Piecewise of two branches whose difference is a multiple of its switch.

    With a − b = k·s, where the first branch a holds for s > 0, it is max(a, b) for k > 0.
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


def _has_sign(factor: Any, sign: int, values: Mapping[Any, float]) -> bool:
    """Return whether a factor is never of the other sign, for real values of what it depends on.

    Of constants the signs alone count, so that others of the same signs change nothing.
    """
    real: dict[Any, Any] = {}
    for a in factor.atoms(sm.Symbol, AppliedUndef, sm.Derivative):
        value = values.get(a)
        kinds = {} if value is None else {
            "zero": value == 0.0, "positive": value > 0.0, "negative": value < 0.0,
        }  # fmt: skip
        real[a] = sm.Dummy(real=True, **{k: True for k, holds in kinds.items() if holds})
    return bool((sign * factor.xreplace(real)).is_nonnegative)
