"""The constraints of equations of motion: which there are, and which follow from which."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from pydy._forks import cached_property
from pydy._mechanics.implicit import Implicit, blocks_of
from pydy._mechanics.kinematic_constraints import RedundantConstraints
from pydy._mechanics.symbols import find_symbols

if TYPE_CHECKING:
    import sympy as sm

    from pydy._sympy_types import TimeFunction


class ImplicitResiduals:
    """The holonomic constraints that are residuals of an `Implicit`, and their unknowns in q."""

    def __init__(
        self,
        implicit: Implicit | None = None,
        holonomic: Sequence[sm.Expr] = (),
        coordinates: Sequence[TimeFunction] = (),
        speeds: Sequence[TimeFunction] = (),
    ) -> None:
        self.implicit = implicit
        self._holonomic, self._coordinates, self._speeds = holonomic, coordinates, speeds

    @cached_property
    def rows(self) -> tuple[int, ...]:
        """The positions of the residuals among the holonomic constraints."""
        if self.implicit is None:
            return ()
        residuals = {*self.implicit.residuals.values()}
        return tuple(k for k, e in enumerate(self._holonomic) if e in residuals)

    @cached_property
    def columns(self) -> tuple[int, ...]:
        """The positions of the unknowns among the coordinates."""
        if self.implicit is None:
            return ()
        return tuple(k for k, q in enumerate(self._coordinates) if q in self.implicit.residuals)

    @cached_property
    def blocks(self) -> list[tuple[tuple[int, ...], tuple[int, ...]]]:
        """The rows and columns of blocks that are solved one after the other."""
        residuals = [self._holonomic[k] for k in self.rows]
        blocks = blocks_of(residuals, [self._coordinates[k] for k in self.columns])
        return [
            (tuple(self.rows[k] for k in rows), tuple(self.columns[k] for k in columns))
            for rows, columns in blocks
        ]

    @cached_property
    def unknowns_of_speeds(self) -> frozenset[TimeFunction]:
        """The unknowns whose residuals contain speeds: forces of friction, say."""
        moving = {*self._speeds}
        for rows, columns in self.blocks:
            if moving & {*find_symbols([self._holonomic[k] for k in rows])}:
                moving.update(self._coordinates[k] for k in columns)
        return frozenset(moving - {*self._speeds})


@dataclass(frozen=True, eq=False)
class ConstraintEquations:
    """Holonomic and velocity constraints, each zero when satisfied."""

    holonomic: tuple[sm.Expr, ...] = ()
    velocity: tuple[sm.Expr, ...] = ()  # differentiated holonomic constraints included
    # Those of `holonomic` that give unknowns.
    residuals: ImplicitResiduals = field(default_factory=ImplicitResiduals)
    # In addition to these, in terms of the states.
    redundant: RedundantConstraints = field(default_factory=RedundantConstraints)
    # Those of `velocity` that no holonomic constraint implies.
    nonholonomic: tuple[sm.Expr, ...] = ()
    # The positions of the holonomic constraints whose rates the velocity constraints imply.
    implied_holonomic: tuple[int, ...] = ()
    # Those whose rates no velocity constraint and no kinematic equation implies.
    undifferentiated_holonomic: tuple[int, ...] = ()
    # The velocity constraints that follow from `implied_holonomic` and from `nonholonomic`.
    implied_velocity: tuple[sm.Expr, ...] = ()

    @property
    def are_present(self) -> bool:
        """Whether there are constraints, including redundant ones."""
        return bool(self.holonomic or self.velocity or any(self.redundant))

    @property
    def enforced_holonomic(self) -> tuple[int, ...]:
        """The positions of holonomic constraints that a discretised motion has to satisfy as such.

        The implied ones, then the residuals.
        """
        return (*self.implied_holonomic, *self.residuals.rows)

    @cached_property
    def unenforced_holonomic(self) -> tuple[int, ...]:
        """The positions of the other holonomic constraints.

        At random states and constants their rates do not follow from velocity constraints; with
        others they may.
        """
        enforced = self.enforced_holonomic
        return tuple(k for k, _ in enumerate(self.holonomic) if k not in enforced)

    @cached_property
    def has_unprojected_rows(self) -> bool:
        """Whether there are more constraints to satisfy than projection enforces."""
        return any(self.redundant) or bool(self.unenforced_holonomic)
