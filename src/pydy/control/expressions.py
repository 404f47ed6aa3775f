"""Split objectives and conditions, as users write them, into integrands and values at instants.

``q.subs(t, tf)`` is q at the end; ``sm.Integral(u**2, t)`` is the integral over the motion, which
begins at t = 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from pydy._checks import describe, shown
from pydy._rank import is_zero
from pydy.control.transcription import Condition, Instant

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol


@dataclass(eq=False)
class ExpressionReader:
    """Reads expressions of one problem; `instants` collects their instants.

    States and controls are functions of time or derivatives of such. `parameters` are the symbols
    of the constants and of the duration.
    """

    time: sm.Symbol
    states: Sequence[AnySymbol]
    controls: Sequence[AnySymbol]
    parameters: set[AnySymbol]
    duration: sm.Symbol | float
    instants: list[Instant] = field(default_factory=list)

    def objective(self, expression: sm.Expr) -> tuple[sm.Expr, sm.Expr]:
        """Split the objective into its integrand and a term at instants; refuse other forms."""
        integrals = sorted(expression.atoms(sm.Integral), key=sm.default_sort_key)
        dummies = {integral: sm.Dummy(f"integral{k}") for k, integral in enumerate(integrals)}
        remainder = expression.xreplace(dummies)
        running, none = sm.S.Zero, dict.fromkeys(dummies.values(), sm.S.Zero)
        for integral, dummy in dummies.items():
            self._check_limits(integral)
            factor = remainder.diff(dummy)
            if factor.has(*dummies.values()) or not factor.free_symbols <= self.parameters:
                raise ValueError(
                    f"`objective` must be a sum of integrals, each times constants, and values at "
                    f"instants, got {shown(expression)}."
                )
            running += factor * integral.function
        if self._instants_in(running):
            raise ValueError(
                f"`objective` has the integrand {running}, with a value at an instant: "
                f"integrands are functions of {self.time}."
            )
        return running, self.at_instants(remainder.xreplace(none), "`objective`")

    def _check_limits(self, integral: sm.Integral) -> None:
        limits = integral.limits
        variable, *ends = limits[0]
        spans_motion = not ends or (
            len(ends) == 2 and ends[0] == 0 and sm.simplify(ends[1] - self.duration) == 0
        )
        if len(limits) != 1 or variable != self.time or not spans_motion:
            raise ValueError(
                f"`objective` has {integral}, but integrals are over the whole motion: write "
                f"Integral(expression, {self.time})."
            )

    def squares(self, expression: sm.Expr) -> tuple[tuple[sm.Expr, sm.Expr], ...]:
        """Return factors and residuals whose squares the expression is a sum of, or raise.

        Terms of constants and the duration alone do not count.
        """
        pairs = []
        for term in sm.Add.make_args(expression):
            if term.free_symbols <= self.parameters and not term.atoms(AppliedUndef):
                continue
            factor, residual, fine = sm.S.One, sm.S.One, True
            for part in sm.Mul.make_args(term):
                base, exponent = part.as_base_exp()
                if part.free_symbols <= self.parameters and not part.atoms(AppliedUndef):
                    factor *= part
                elif exponent.is_Integer and exponent > 0 and exponent % 2 == 0:
                    residual *= base ** (exponent / 2)
                else:
                    fine = False
            if not fine or factor.is_negative:
                raise ValueError(
                    f"`hessian` is 'gauss-newton', which needs an `objective` that is a sum of "
                    f"squares, but it has the term {term}. Use 'exact', or 'lbfgs'."
                )
            pairs.append((factor, residual))
        return tuple(pairs)

    def boundary(self, relations: Sequence[sm.Basic]) -> tuple[Condition, ...]:
        """Return relations between instants as conditions."""
        conditions = self.path("boundary", relations)
        return tuple(
            replace(c, expression=self.at_instants(c.expression, "`boundary`")) for c in conditions
        )

    def path(self, argument: str, relations: Sequence[sm.Basic]) -> tuple[Condition, ...]:
        """Return relations as conditions with the same meaning."""
        conditions = []
        for relation in relations:
            if not isinstance(relation, Relational) or isinstance(relation, sm.Ne):
                raise ValueError(
                    f"`{argument}` must hold equations and inequalities, `Eq(a, b)`, `a <= b` or "
                    f"`a >= b`, got {shown(relation)}."
                )
            expression = relation.lhs - relation.rhs
            if expression.has(sm.oo, -sm.oo, sm.zoo, sm.nan):
                raise ValueError(
                    f"`{argument}` has `{relation}`, which is not finite. Leave out a condition "
                    "that always holds."
                )
            low = 0.0 if isinstance(relation, (sm.Eq, sm.Ge, sm.Gt)) else float("-inf")
            high = float("inf") if isinstance(relation, (sm.Ge, sm.Gt)) else 0.0
            conditions.append(Condition(expression, low, high, str(relation)))
        return tuple(conditions)

    @staticmethod
    def check_functions(
        argument: str, expressions: Iterable[sm.Expr], allowed: Iterable[AnySymbol]
    ) -> None:
        """Refuse functions of time that occur in none of the `allowed` symbols and derivatives."""
        functions = {f for symbol in allowed for f in symbol.atoms(AppliedUndef)}
        strange = {f for e in expressions for f in sm.sympify(e).atoms(AppliedUndef)} - functions
        if strange:
            example = min(strange, key=sm.default_sort_key)
            raise ValueError(
                f"{argument} has `{example}`, which is in none of the system's equations. To have "
                "it as a control all the same, give the system an output that holds it: "
                f"system.outputs[sm.Symbol('name')] = {example}."
            )

    # -- values at instants ----------------------------------------------------------------------

    def at_instants(self, expression: sm.Expr, argument: str) -> sm.Expr:
        """Replace each value at an instant by a symbol; refuse other functions of time."""
        values = self._instants_in(expression)
        replaced = {old: self._symbol(*value, argument) for old, value in values.items()}
        result = expression.xreplace(replaced)
        instants = {i.symbol for i in self.instants}
        kinds = (sm.Subs, sm.Derivative, AppliedUndef)  # outermost first
        unresolved = [
            e for kind in kinds for e in sorted(result.atoms(kind), key=sm.default_sort_key)
        ]
        strange = sorted(result.free_symbols - instants - self.parameters, key=sm.default_sort_key)
        if unresolved or strange:
            example = (unresolved or strange)[0]
            names = describe((*self.states, *self.controls))
            raise ValueError(
                f"{argument} has `{example}`, which is neither a constant of the system nor a "
                f"state or control at an instant. Write `q.subs({self.time}, {self.duration})` for "
                f"the value of q at the end; states and controls are {names}."
            )
        return result

    def _instants_in(self, expression: sm.Expr) -> dict[sm.Expr, tuple[str, int, sm.Expr]]:
        """Return the quantities at instants in an expression: kind, index and time."""
        kinds = [("state", k, s) for k, s in enumerate(self.states)]
        kinds += [("control", k, s) for k, s in enumerate(self.controls)]
        instants: dict[sm.Expr, tuple[str, int, sm.Expr]] = {}
        # SymPy writes a derivative at an instant as a Subs, or by the instant if it is a symbol.
        for node in expression.atoms(sm.Subs, sm.Derivative):
            variable = node.variables[0]
            if isinstance(node, sm.Subs):
                inner, instant = node.expr.xreplace({variable: self.time}), node.point[0]
            else:
                inner, instant = node.xreplace({variable: self.time}), variable
            for kind, k, symbol in kinds:
                if inner == symbol and instant != self.time and len({*node.variables}) == 1:
                    instants[node] = (kind, k, instant)
        remainder = expression.xreplace({node: sm.Dummy() for node in instants})
        for node in remainder.atoms(AppliedUndef):
            if len(node.args) == 1 and node.args[0] != self.time:
                for kind, k, symbol in kinds:
                    if isinstance(symbol, AppliedUndef) and node.func == symbol.func:
                        instants[node] = (kind, k, node.args[0])
        return instants

    def _symbol(self, kind: str, index: int, time: sm.Expr, argument: str) -> sm.Dummy:
        ratio = sm.simplify(sm.sympify(time) / self.duration)
        if ratio.is_number and is_zero(complex(ratio - 1).real, 1.0):
            ratio = sm.Integer(1)  # 2*pi exceeds its value as a float
        if not (ratio.is_number and ratio.is_real) or not 0 <= ratio <= 1:
            raise ValueError(
                f"{argument} has a value at the time {time}, but instants lie between 0 and "
                f"{self.duration}"
                + (
                    f" and are given as a part of it, such as {self.duration}/2."
                    if getattr(self.duration, "free_symbols", None)
                    else "."
                )
            )
        fraction = float(ratio)
        for existing in self.instants:
            if (existing.kind, existing.index, existing.fraction) == (kind, index, fraction):
                return existing.symbol
        instant = Instant(sm.Dummy(f"{kind}{index}"), kind, index, fraction)
        self.instants.append(instant)
        return instant.symbol


def bends(objective: sm.Expr) -> str:
    """Return a message on places where the objective may have no derivative, or ''."""
    kinds = (sm.Abs, sm.Max, sm.Min, sm.sign, sm.Piecewise, sm.Heaviside)
    bent = sorted((e for e in objective.atoms(*kinds) if not e.is_number), key=sm.default_sort_key)
    if not bent:
        return ""
    return (
        f" `objective` has `{bent[0]}`, which bends: a search that ends there finds no minimum. "
        "Write it without: a term max(a, b) that is minimised is a control s with the conditions "
        "s >= a and s >= b in `path`."
    )
