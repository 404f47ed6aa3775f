"""Constraints of coordinates and speeds, and the states that are dependent because of them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

from pydy._forks import cached_property

if TYPE_CHECKING:
    import sympy as sm

    from pydy._sympy_types import TimeFunction


class RedundantConstraints(NamedTuple):
    """Constraints that follow from the others at generic states."""

    holonomic: tuple[sm.Expr, ...] = ()  # wherever their rates do
    velocity: tuple[sm.Expr, ...] = ()


@dataclass(frozen=True, eq=False)
class KinematicConstraints:
    """The constraints of a mechanism, each zero when satisfied."""

    holonomic: tuple[sm.Expr, ...] = ()  # of the configuration
    velocity: tuple[sm.Expr, ...] = ()  # one for each dependent speed
    # Their derivatives, in u' and the states; empty where they are just that.
    acceleration: tuple[sm.Expr, ...] = ()
    # In addition to these.
    redundant: RedundantConstraints = field(default_factory=RedundantConstraints)
    implicit: Any = None  # the `Implicit` that gave some coordinates and holonomic constraints

    @property
    def of_positions(self) -> list[sm.Expr]:
        """The holonomic constraints, except the residuals of an `Implicit`."""
        residuals = set() if self.implicit is None else {*self.implicit.residuals.values()}
        return [e for e in (*self.holonomic, *self.redundant.holonomic) if e not in residuals]


@dataclass(frozen=True, eq=False)
class DependentStates:
    """The dependent coordinates and speeds, anywhere among the states.

    The speeds are in the order of the velocity constraints.
    """

    coordinates: tuple[TimeFunction, ...] = ()
    speeds: tuple[TimeFunction, ...] = ()
    all_speeds: tuple[TimeFunction, ...] = ()
    chosen: tuple[TimeFunction, ...] = ()  # the dependent ones that the user did not choose
    # Whether the choice of dependent speeds may become invalid: the rank of the constraints, or
    # the speeds for which they can be solved, may change as the system moves.
    changing: bool = False

    @cached_property
    def speed_columns(self) -> tuple[int, ...]:
        """The positions of the dependent speeds among all, in their own order."""
        return tuple(self.all_speeds.index(u) for u in self.speeds)

    @cached_property
    def independent_columns(self) -> tuple[int, ...]:
        """The positions of the other speeds, ascending."""
        return tuple(k for k in range(len(self.all_speeds)) if k not in self.speed_columns)
