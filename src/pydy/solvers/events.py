"""Events as the user defines them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from numbers import Real
from typing import Any

import numpy as np

from pydy._checks import flag, text, typed


@dataclass(frozen=True)
class Event:
    """An event that happens where an expression crosses zero.

    Parameters
    ----------
    expression : sympy.Expr
        A function of states, specifieds, constants, time, and the time derivatives of the
        coordinates.
    direction : {0, 1, -1}, optional
        1: only from negative to positive; −1: only from positive to negative; 0: both. That is
        along the motion as it is integrated: where times descend, backward in time.
    terminal : bool, optional
        Whether the integration ends there.
    reset : dict, optional
        Maps states to expressions: their values after the event, as functions of those before it.
        Other states keep their values.
    name : str, optional
        Name of the event; by default its expression.

    Raises
    ------
    TypeError
        `expression` or an entry of `reset` is not an expression, or `terminal` is neither True nor
        False.
    ValueError
        `direction` has another value, or `expression` is an inequality.

    Notes
    -----
    Signs are compared at the ends of four parts of each step, and where an expression is least
    between them. One that only touches zero is not detected, nor may be one that crosses and
    returns within such a part and is not smooth there. One that is not linear, or holds specifieds,
    shortens the steps of methods with step-size control where it may do so. Where an expression
    that had a sign becomes NaN, as ``sqrt(q)`` does where q passes zero, the integration ends with
    an error; one that is NaN at first is watched from where it is a number on.

    An expression that is zero over an interval, as ``Max(0, x)`` is, defines no time there: a
    simulation warns if its steps meet such an interval. Pass ``x``.

    A motion may start on the surface, where the expression is zero within rounding. The event
    happens there, and acts, where the motion departs to the side that `direction` points to: by the
    first derivative that is not zero. With ``direction=0`` it is recorded there, but acts only if
    the motion is at rest on the surface: otherwise the start counts as the state after it. An event
    whose reset leaves the motion at rest on the surface, from where it would pass through, happens
    again at once: the events accumulate, and the integration ends with a warning. An expression
    that is zero at the last time is an event there.

    Examples
    --------
    >>> import sympy as sm
    >>> from pydy.solvers import Event
    >>> height, velocity, e = sm.symbols('height, velocity, e')
    >>> Event(height, direction=-1, reset={velocity: -e*velocity}, name='bounce').name
    'bounce'
    """

    expression: Any  # of SymPy, or a number
    direction: int = 0
    terminal: bool = False
    reset: Mapping[Any, Any] = field(default_factory=dict)
    name: str = ""

    def __post_init__(self) -> None:
        expression = self.expression
        if getattr(expression, "is_Relational", False):
            upper = getattr(expression, "gts", expression.lhs)
            lower = getattr(expression, "lts", expression.rhs)
            raise ValueError(
                f"`expression` must cross zero, but `{expression}` is only true or false. Pass "
                f"`{upper - lower}`; with direction=1 the event is where it becomes positive."
            )
        _check_expression(expression, "`expression`")
        number = isinstance(self.direction, Real) and not isinstance(self.direction, bool)
        if not number or self.direction not in (-1, 0, 1):
            raise ValueError(f"`direction` must be −1, 0 or 1, got {self.direction!r}.")
        flag(self.terminal, "`terminal`")
        if self.reset is None:
            object.__setattr__(self, "reset", {})
        if not isinstance(self.reset, Mapping):
            raise TypeError(
                f"`reset` must map states to expressions, got {type(self.reset).__name__}."
            )
        for state, value in self.reset.items():
            _check_expression(value, f"`reset[{state}]`")
        if not text(self.name, "`name`"):
            object.__setattr__(self, "name", str(expression))


class Turn(Event):
    """The minimum of the previous event's expression, which is located near its zeros."""


def _check_expression(value: Any, label: str) -> None:
    """Check that a value is a scalar expression, by its attributes: solvers never import SymPy."""
    number = isinstance(value, Real) and not isinstance(value, bool | np.bool_ | np.timedelta64)
    symbolic = isinstance(getattr(value, "free_symbols", None), set)
    scalar = symbolic and getattr(value, "is_commutative", False)
    excluded = ("is_Relational", "is_Boolean", "is_Matrix")
    if not (number or (scalar and not isinstance(value, type))) or any(
        getattr(value, name, False) for name in excluded
    ):
        raise TypeError(f"{label} must be a SymPy expression or a number, got {typed(value)}.")
