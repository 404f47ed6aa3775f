"""Kinetic and potential energy of a System, each computed when it is first needed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._assembly import CompiledModel, Layout
from pydy._checks import describe, shown
from pydy._forks import cached_property
from pydy._kernel import Kernel
from pydy._mechanics import (
    Equations,
    FrameTree,
    find_potential,
    find_symbols,
    replace_symbols,
)
from pydy.codegen import checked_expression

_NO_BODIES = (
    "Cannot compute the system's energy: its `eom_method` has no bodies, or no frame in which "
    "their velocities are known. Give it both, as in LagrangesMethod(…, bodies=[…], frame=N)."
)


class Energy(NamedTuple):
    """Energies at one state, or along a trajectory.

    Attributes
    ----------
    kinetic, potential, total : float or ndarray, shape (m,)
    """

    kinetic: Any
    potential: Any
    total: Any


@dataclass(frozen=True, eq=False)
class EnergyModel:
    """The energies as expressions."""

    equations: Equations
    given: Any = None  # the potential energy, where the user told it

    @property
    def kinetic(self) -> Any:
        """The kinetic energy, or an error where the method knows no bodies."""
        energy = self.equations.kinetic_energy
        if energy is None:
            raise ValueError(_NO_BODIES)
        return energy

    @cached_property
    def potential(self) -> Any:
        """The potential energy, or an error that names the loads that have an unknown one."""
        if self.given is not None:
            return self.given
        if self.equations.mechanism is None:
            raise ValueError(_NO_BODIES)
        found = find_potential(self.equations)
        if found.unknown:
            raise ValueError(
                "Cannot determine the potential energy, because it is not clear whether these "
                f"loads have one: {'; '.join(found.unknown[:5])}. {found.advice} Or set it "
                "yourself: `system.potential_energy = ...`, an expression for all loads together."
            )
        return found.expression

    @property
    def symbols(self) -> tuple[Any, ...]:
        """The constants in energies and positions; some may cancel from the equations of motion."""
        return tuple(s for s in self._held if isinstance(s, sm.Symbol))

    @property
    def motions(self) -> tuple[Any, ...]:
        """The specifieds there, of which the equations of motion may hold none."""
        return tuple(s for s in self._held if not isinstance(s, sm.Symbol))

    @cached_property
    def _held(self) -> tuple[Any, ...]:
        """The symbols in energies and positions that are neither time nor states."""
        parts: list[Any] = [] if self.given is None else [self.given]
        equations, mechanism = self.equations, self.equations.mechanism
        if equations.multibody is not None and equations.multibody.lagrangian is not None:
            parts.append(equations.multibody.lagrangian)  # it may come without bodies
        if equations.multibody is not None and equations.multibody.potential is not None:
            parts.append(equations.multibody.potential)
        if mechanism is not None:
            parts += [*mechanism.parts]
            parts += [body.potential_energy for body in mechanism.bodies]
            points = [body.masscenter for body in mechanism.bodies]
            for point in points:
                points += [other for other in FrameTree.positions(point) if other not in points]
            steps = [vector for point in points for vector in FrameTree.positions(point).values()]
            parts += [part for vector in steps for own, _ in vector.args for part in own]
            turns = map(FrameTree.orientations, FrameTree(mechanism.frame).frame_depth)
            parts += [entry for turn in turns for matrix in turn.values() for entry in matrix]
        found = find_symbols(sm.sympify(part) for part in parts)
        kinematics = equations.kinematics
        states = {*equations.coordinates, *equations.speeds, *kinematics.zeros, equations.time}
        states.update((*kinematics.coordinate_rates, *kinematics.speed_rates))
        held = dict.fromkeys(s for s in found if s not in states)
        if mechanism is not None and not mechanism.velocities_are_set:
            # Of motions in positions, velocities that are derived hold the rates.
            functions = [s for s in held if isinstance(s, AppliedUndef)]
            held |= dict.fromkeys(s.diff(equations.time) for s in functions)
        return tuple(held)

    def expressions(self, layout: Layout) -> tuple[Any, Any]:
        """Return the kinetic and the potential energy; 1 stands for constants without a value."""
        return self.moving(layout), self._in(layout, self.potential)

    def moving(self, layout: Layout) -> Any:
        """Return the kinetic energy, with 1 for constants without a value."""
        mechanism = self.equations.mechanism
        known = None if mechanism is None else mechanism.known_energy
        return self._in(layout, self.kinetic if known is None else known)

    def _in(self, layout: Layout, energy: Any) -> Any:
        ones = dict.fromkeys({*self.symbols} - {*layout.constants}, sm.Float(1.0))
        found = replace_symbols(energy, ones) if ones else energy
        known = {*layout.states, *layout.constants, *layout.specifieds, self.equations.time}
        known.update(self.equations.kinematics.coordinate_rates)
        missing = [s for s in find_symbols([found]) if s not in known]
        if missing:
            raise ValueError(
                f"The energy holds {describe(missing)}, which the equations of motion do not. Give "
                "the motion as an expression of time, or these values beside it, in `specifieds`."
            )
        return found

    def kernel(self, model: CompiledModel) -> Kernel:
        """Return the Kernel of kinetic, potential and total energy."""
        # Looking for symbols in long expressions takes longer than a thousand states.
        stored: tuple[EnergyModel, Kernel] | None = model.latest.get("the energy")
        if stored is None or stored[0] is not self:
            kinetic, potential = self.expressions(model.layout)
            expressions = kinetic, potential, sm.Add(kinetic, potential)
            stored = self, model.compiled_expressions("the energy", (3,), expressions)
            model.latest["the energy"] = stored
        return stored[1]

    @cached_property
    def static(self) -> bool:
        """Whether all loads depend on nothing but the configuration."""
        equations, mechanism = self.equations, self.equations.mechanism
        loads = () if mechanism is None else mechanism.loads
        parts = [e for _, vector in loads for column, _ in vector.args for e in column]
        found = find_symbols(map(equations.kinematics.in_states, parts))
        coordinates = set(equations.coordinates)
        return all(s in coordinates or (s.is_Symbol and s != equations.time) for s in found)


def check_potential(
    value: Any,
    coordinates: Sequence[Any],
    others: Sequence[Any],
) -> Any:
    """Return a user's potential energy as an expression in coordinates and other symbols."""
    if value is None:
        return None
    expression = checked_expression(value, "`potential_energy`")
    if not isinstance(expression, sm.Expr):
        raise ValueError(f"`potential_energy` must be a SymPy expression, got {shown(value)}.")
    known = {*coordinates, *others}
    strange = [s for s in find_symbols([expression]) if s not in known]
    if strange:
        raise ValueError(
            "`potential_energy` must be an expression in the coordinates, constants, specifieds "
            f"and time of the system, got one with {describe(strange)}."
        )
    return expression
