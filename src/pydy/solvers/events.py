"""Events: what a user says of them, and what happened."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from pydy._kernel import Kernel
from pydy.trajectory import EventRecord

__all__ = ["CompiledEvents", "Event", "EventRecord"]


@dataclass(frozen=True)
class Event:
    """Something that happens where an expression crosses zero.

    Parameters
    ----------
    expression : sympy.Expr
        In states, specifieds, constants, time, and the time derivatives of the coordinates.
    direction : {0, 1, -1}, optional
        1: only from negative to positive; −1: only from positive to negative; 0: both.
    terminal : bool, optional
        Whether the integration ends there.
    reset : dict, optional
        Maps states to expressions: their values after the event, in terms of those before it.
        States that are not named keep theirs.
    name : str, optional
        What to call it; by default its expression.

    Raises
    ------
    ValueError
        Another direction.

    Notes
    -----
    Signs are compared at the ends of four parts of each step: an expression that only touches zero,
    or crosses and returns within such a part, is not seen.

    Examples
    --------
    >>> import sympy as sm
    >>> from pydy.solvers import Event
    >>> height, velocity, e = sm.symbols('height, velocity, e')
    >>> Event(height, direction=-1, reset={velocity: -e*velocity}, name='bounce').name
    'bounce'
    """

    expression: Any
    direction: int = 0
    terminal: bool = False
    reset: Mapping[Any, Any] = field(default_factory=dict)
    name: str = ""

    def __post_init__(self) -> None:
        if self.direction not in (-1, 0, 1):
            raise ValueError(f"`direction` must be −1, 0 or 1, got {self.direction!r}.")
        if self.reset is None:
            object.__setattr__(self, "reset", {})
        if not isinstance(self.reset, Mapping):
            raise TypeError(
                f"`reset` must map states to expressions, got {type(self.reset).__name__}."
            )
        if not self.name:
            object.__setattr__(self, "name", str(self.expression))


@dataclass(frozen=True, eq=False)
class CompiledEvents:
    """Events as Kernels.

    Attributes
    ----------
    names : tuple of str
    directions : tuple of int
    terminal : tuple of bool
    constant : tuple of bool
        Whether the expression depends on neither state nor time nor specifieds.
    values : Kernel
        The expressions.
    rates : Kernel
        Their time derivatives along the motion.
    resets : tuple of Kernel or None
        The states after each event.
    """

    names: tuple[str, ...]
    directions: tuple[int, ...]
    terminal: tuple[bool, ...]
    constant: tuple[bool, ...]
    values: Kernel
    rates: Kernel
    resets: Sequence[Kernel | None]
