"""Events: their definition by the user, and their compiled form."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from numbers import Real
from typing import Any

import numpy as np

from pydy._checks import flag, text, typed
from pydy._kernel import Kernel, KernelCall
from pydy.solvers.tuning import CLOSE, ROUNDING, ROUNDINGS


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


@dataclass(frozen=True, eq=False)
class CompiledEvents:
    """Events as Kernels."""

    names: tuple[str, ...]
    directions: tuple[int, ...]
    terminal: tuple[bool, ...]
    constant: tuple[bool, ...]  # whether it depends on neither state nor time nor specifieds
    linear: tuple[bool, ...]  # whether it is linear in states and time, and holds no specifieds
    values: Kernel  # the expressions
    rates: Kernel  # their time derivatives along the motion, and bounds on their roundings
    turns: tuple[bool, ...]  # whether it is a Turn
    # Expressions, and how far they may come from these in a step (`Watch.reach`); of a Turn, those
    # of the event before it. None where that is not known of all.
    reach: Kernel | None
    resetting: tuple[bool, ...]  # whether the states change at each
    resets: Kernel | None  # the states after each event, one below the other; None: no event resets
    sources: tuple[Event, ...] = ()  # what they were compiled from
    redirects: tuple[bool, ...] = ()  # whether the rate depends on a state that the reset changes
    # Whether an expression may be zero all along a stretch, as Max(0, x) is; if any may.
    may_rest: tuple[bool, ...] = ()

    @staticmethod
    def key(events: Any) -> list[tuple[Event, dict[Any, Any]]] | None:
        """Return a key that identifies a user's events, even if a reset is edited in place.

        None if they come from an iterator, which reading would exhaust.
        """
        several = [events] if isinstance(events, Event) else events
        if type(several) not in (list, tuple) or {*map(type, several)} - {Event, Turn}:
            return None
        return [(event, dict(event.reset)) for event in several]

    def zero_interval_warnings(self, intervals: np.ndarray, span: float) -> list[str]:
        """Return warnings of expressions that stayed at zero, from ``Watch.rests`` and a span."""
        warnings = []
        for k in np.flatnonzero(self.may_rest):
            first, last = intervals[2 * k : 2 * k + 2].tolist()
            # A shorter interval may be rounding.
            if first < last and last - first <= CLOSE**2 * max(abs(last), span):
                continue
            if first <= last:  # neither is NaN
                when = f"from t = {first:.6g} to {last:.6g}, at least"
                when = f"at and beside t = {first:.6g}" if first == last else when
                warnings.append(
                    f"The expression of the event `{self.names[k]}` is exactly zero {when}: there "
                    "no sign tells when the event happens, and its times are arbitrary. Pass an "
                    "expression that passes through zero, such as `x` in place of `Max(0, x)`."
                )
        return warnings

    def forcing_time(self, call: KernelCall, event: int, x: np.ndarray, t: float) -> float | None:
        """Return the time of the sample or switch whose jump makes an event happen, or None.

        The expression then does not pass through zero: its sign differs before and after the jump,
        and the event's time depends on no state. The state x is that before the event, which was
        located at t.
        """
        jumps: dict[float, list[Any]] = {}
        for columns, samples in call.sampled:
            time = float(samples.breaks[np.abs(samples.breaks - t).argmin()])
            near = abs(time - t) <= ROUNDINGS * ROUNDING * abs(t)
            if samples.interpolation == "previous" and near:
                jumps[time] = [*jumps.get(time, ()), (columns, samples)]
        n, inputs, _ = self.values.program.signature.sizes
        state, r = x[:n], call.inputs_at(x, t)
        state_twice = np.stack([state, state])
        for time, jumping in jumps.items():
            rows = np.stack([r, r])
            for columns, samples in jumping:
                rows[:, columns] = samples.rows(np.array([np.nextafter(time, -np.inf), time]))
            rows, times = rows[:, :inputs], np.full(2, time)
            values = self.values.evaluate(times, state_twice, rows, call.p)[0][:, event]
            if values[0] * values[1] < 0.0:
                return time
        reach = ROUNDINGS * ROUNDING * abs(t)
        switched = () if call.switched is None else call.switched
        for _, earlier, later in (row for row in switched if abs(row[0] - t) <= reach):
            times = np.array([earlier, later])
            rows = np.stack([call.inputs_at(x, time)[:inputs] for time in times])
            values = self.values.evaluate(times, state_twice, rows, call.p)[0][:, event]
            if values[0] * values[1] < 0.0:
                return float(later)
        return None

    def value_after_jump(
        self, call: KernelCall, event: int, x: np.ndarray, t: float, error: float
    ) -> float | None:
        """Return the value of an event's expression where it happens, or None if that is zero.

        Zero means: within the resolution of time and expression, and the `error` that the
        tolerances of the states allow; else the expression has jumped.
        """
        rates_and_bounds = call.evaluate(self.rates, x, t)
        value = float(call.evaluate(self.values, x, t)[event])
        rate, bound = map(float, rates_and_bounds[[event, len(self.names) + event]])
        time = ROUNDINGS * ROUNDING * abs(t) * abs(rate)
        rounding = ROUNDINGS * ROUNDING * bound
        return value if CLOSE * abs(value) > time + rounding + error else None
