"""The kinematic differential equations, q' = G(q, u, t)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sm

from pydy._mechanics.symbols import rate_of, replace_symbols

if TYPE_CHECKING:
    from pydy._sympy_types import TimeFunction


@dataclass(frozen=True, eq=False)
class KinematicEquations:
    """The kinematic differential equations q' = G(q, u, t) and the symbols of all rates."""

    coordinate_rates: tuple[sm.Derivative, ...]  # the symbols q'
    speed_rates: tuple[sm.Derivative, ...]  # the symbols u'
    coordinate_derivatives: tuple[sm.Expr, ...]  # q' in terms of q, u and t
    # Symbols that are zero in motion: auxiliary speeds, their rates.
    zeros: tuple[TimeFunction, ...] = ()

    @classmethod
    def of(
        cls,
        time: sm.Symbol,
        speeds: Sequence[TimeFunction],
        coordinate_rates: Sequence[sm.Derivative],
        coordinate_derivatives: Sequence[sm.Expr],
        auxiliary: Sequence[TimeFunction] = (),
    ) -> KinematicEquations:
        """Return the equations for these q', speeds and auxiliary speeds."""
        return cls(
            tuple(coordinate_rates),
            tuple(rate_of(u, time) for u in speeds),
            tuple(coordinate_derivatives),
            (*auxiliary, *(rate_of(u, time) for u in auxiliary)),
        )

    def in_states(self, expression: sm.Expr) -> sm.Expr:
        """Return an expression in terms of the states, without auxiliary speeds.

        Each distinct sub-expression is rewritten once.
        """
        rates = zip(self.coordinate_rates, self.coordinate_derivatives, strict=True)
        return replace_symbols(expression, {**dict(rates), **dict.fromkeys(self.zeros, sm.S.Zero)})
