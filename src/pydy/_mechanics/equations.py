"""The equations of motion as plain data: the last thing that knows SymPy's mechanics package."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import sympy as sm

from pydy._forks import cached_property
from pydy._mechanics.forces import ConstraintForces
from pydy._mechanics.form import Formed
from pydy._mechanics.mechanism import Mechanism
from pydy._mechanics.reader import Multibody
from pydy._mechanics.symbols import find_symbols, replace_symbols
from pydy._names import name_of

__all__ = ["Equations"]


@dataclass(frozen=True, eq=False, repr=False)
class Equations:
    """Equations of motion ``M u' = F`` with kinematics ``q' = G``, and what constrains them.

    Attributes
    ----------
    time : sympy.Symbol
    coordinates, speeds : tuple of functions of time
    coordinate_rates, speed_rates : tuple of derivatives
        The symbols q' and u'.
    coordinate_derivatives : tuple of expressions
        q' in terms of q, u and t.
    mass_matrix : sympy.Matrix, shape (o, o)
        Empty, like the forcing, where the equations are `formed`.
    forcing : tuple of expressions
    positive_definite : bool
        Whether the mass matrix is symmetric positive definite by construction.
    holonomic : tuple of expressions
        Configuration constraints, zero when satisfied.
    velocity : tuple of expressions
        All velocity-level constraints, differentiated holonomic ones included.
    nonholonomic : tuple of expressions
        Those of `velocity` that no holonomic constraint implies.
    dependent_coordinates, dependent_speeds : tuple of functions of time
    auxiliary_speeds : tuple of functions of time
        Speeds that exist only to bring noncontributing forces into evidence; zero in motion.
    auxiliary_equations : tuple of expressions
    mechanism : Mechanism or None
        The bodies and loads behind the equations, where the method knows them.
    formed : Formed or None
        The equations of motion as nodes of a graph, formed from the bodies and loads.
    multibody : Multibody or None
        What the equations of motion can be formed from, where the method knows it.
    enforced : tuple of int
        The places of the holonomic constraints whose rates the velocity constraints imply.
    repeated : tuple of expressions
        The velocity constraints that follow from those and from `nonholonomic`.
    """

    time: sm.Symbol
    coordinates: tuple[Any, ...]
    speeds: tuple[Any, ...]
    coordinate_rates: tuple[Any, ...]
    speed_rates: tuple[Any, ...]
    coordinate_derivatives: tuple[Any, ...]
    mass_matrix: Any
    forcing: tuple[Any, ...]
    positive_definite: bool
    holonomic: tuple[Any, ...] = ()
    velocity: tuple[Any, ...] = ()
    nonholonomic: tuple[Any, ...] = ()
    dependent_coordinates: tuple[Any, ...] = ()
    dependent_speeds: tuple[Any, ...] = ()
    auxiliary_speeds: tuple[Any, ...] = ()
    auxiliary_equations: tuple[Any, ...] = ()
    zeros: tuple[Any, ...] = field(default=(), repr=False)
    mechanism: Mechanism | None = field(default=None, repr=False)
    formed: Formed | None = field(default=None, repr=False)
    multibody: Multibody | None = field(default=None, repr=False)
    enforced: tuple[int, ...] = ()
    repeated: tuple[Any, ...] = ()

    def __repr__(self) -> str:
        q, u = (", ".join(map(name_of, part)) for part in (self.coordinates, self.speeds))
        lines = [f"Equations: {q}; speeds {u}"]
        if self.formed is not None and self.mechanism is not None:
            bodies, loads = len(self.mechanism.bodies), len(self.mechanism.loads)
            lines.append(f"formed on the graph from {bodies} bodies and {loads} loads")
        else:
            lines.append(f"a mass matrix {self.mass_matrix.shape} and {len(self.forcing)} forces")
        for kind in ("holonomic", "velocity", "nonholonomic", "auxiliary_equations"):
            rows = getattr(self, kind)
            if rows:
                what = "auxiliary equations" if "_" in kind else f"{kind} constraints"
                lines.append(f"{len(rows)} {what}")
        return "\n  ".join(lines)

    @cached_property
    def symbols(self) -> dict[Any, None]:
        """The symbols, functions of time and derivatives that occur in the equations of motion."""
        found = find_symbols(self.expressions)
        if self.formed is not None:
            found.update(dict.fromkeys(self.formed.symbols(self.speed_rates)))
        return found

    @property
    def expressions(self) -> tuple[Any, ...]:
        """What the equations of motion are made of, as far as it is written as expressions.

        Constraints that were left out as redundant are so with the right numbers only.
        """
        closed, redundant = self.left_out
        return (
            *self.coordinate_derivatives,
            *self.mass_matrix,
            *self.forcing,
            *self.holonomic,
            *self.velocity,
            *closed,
            *redundant,
        )

    def in_states(self, expression: Any) -> Any:
        """Return an expression with q' in terms of the states, and what is zero in motion left out.

        Each distinct sub-expression is rewritten once.
        """
        rates = zip(self.coordinate_rates, self.coordinate_derivatives, strict=True)
        return replace_symbols(expression, {**dict(rates), **dict.fromkeys(self.zeros, sm.S.Zero)})

    @cached_property
    def left_out(self) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        """The holonomic and the velocity constraints that are redundant, in terms of the states."""
        body = self.multibody
        if body is None:
            return (), ()
        return body.closed, tuple(map(self.in_states, body.redundant))

    @property
    def constrained(self) -> bool:
        """Whether there are constraints, those that were left out as redundant included."""
        return bool(self.holonomic or self.velocity or any(self.left_out))

    @cached_property
    def kinetic_energy(self) -> Any:
        """The kinetic energy in terms of q, u, t, constants and specifieds; None without bodies."""
        if self.mechanism is None or not self.mechanism.bodies:
            return None
        return self.in_states(self.mechanism.kinetic_energy)

    @cached_property
    def constraint_forces(self) -> ConstraintForces | None:
        """What gives multipliers and reactions; None without bodies."""
        if self.multibody is None:
            return None
        states = {*self.coordinates, *self.speeds, *self.coordinate_rates, *self.speed_rates}
        found = find_symbols(self.auxiliary_equations)
        return ConstraintForces(
            self.multibody,
            {k: self.holonomic[k] for k in self.enforced},
            {len(self.holonomic) + k: e for k, e in enumerate(self.nonholonomic)},
            {
                len(self.holonomic) + len(self.nonholonomic) + k: e
                for k, e in enumerate(self.repeated)
            },
            [s for s in found if not s.is_Symbol and s not in states and s not in self.symbols],
        )
