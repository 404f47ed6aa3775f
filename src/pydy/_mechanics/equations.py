"""The equations of motion, and the bodies and loads behind them, as plain data.

This is the last thing that knows SymPy's mechanics package.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import sympy as sm
from sympy.physics.mechanics import Particle, Point, ReferenceFrame

from pydy._forks import cached_property
from pydy._mechanics.constraints import ConstraintEquations
from pydy._mechanics.equation_graph import EquationGraph
from pydy._mechanics.forces import ConstraintForces
from pydy._mechanics.frame_tree import FrameTree, given_velocity, velocities_in
from pydy._mechanics.kinematic_constraints import DependentStates
from pydy._mechanics.kinematic_equations import KinematicEquations
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reader import curve_coefficients
from pydy._mechanics.symbols import find_symbols
from pydy._names import name_of

if TYPE_CHECKING:
    from sympy.physics.mechanics import Vector
    from sympy.physics.mechanics.joint import Joint

    from pydy._sympy_types import AnySymbol, Body, Load, TimeFunction


@dataclass(frozen=True, eq=False)
class Mechanism:
    """Bodies and loads as the user gave them; everything else is derived on demand."""

    frame: ReferenceFrame  # the inertial frame
    bodies: tuple[Body, ...]
    loads: tuple[Load, ...] = ()
    known_energy: sm.Expr | None = None  # the kinetic energy, where it was formed already
    joints: tuple[Joint, ...] = ()  # those of SymPy that connect the bodies, where they are known
    # The kinetic energy less the potential one of all that is not among the loads.
    lagrangian: sm.Expr | None = None
    _rotations: dict[tuple[ReferenceFrame, ReferenceFrame], sm.Matrix] = field(
        default_factory=dict, repr=False
    )

    @cached_property
    def kinetic_energy(self) -> sm.Expr:
        """The kinetic energy by the velocities as the user wrote them, q' included."""
        return self._written_energy()

    @cached_property
    def body_velocities(self) -> dict[Point, Vector]:
        """The velocities of the mass centres."""
        return self._velocities([body.masscenter for body in self.bodies])

    @cached_property
    def load_velocities(self) -> dict[Point, Vector]:
        """The velocities of the points at which loads act."""
        points = dict.fromkeys(item for item, _ in self.loads if isinstance(item, Point))
        centres = {p: v for p, v in self.body_velocities.items() if p in points}
        return centres | self._velocities([p for p in points if p not in centres])

    @cached_property
    def curve_coefficients(self) -> tuple[sm.Symbol, ...]:
        """The symbols for coefficients of muscles' curves among the loads, in order."""
        return curve_coefficients(self.loads)

    def _velocities(self, points: Sequence[Point]) -> dict[Point, Vector]:
        with warnings.catch_warnings():
            # SymPy derives velocities that were not set, and warns if the result is ambiguous.
            warnings.simplefilter("ignore", UserWarning)
            return velocities_in(self.frame, points)

    @property
    def energy(self) -> sm.Expr:
        """The kinetic energy as it was formed, or else as written."""
        return self.kinetic_energy if self.known_energy is None else self.known_energy

    def _written_energy(self) -> sm.Expr:
        terms = []
        for body in self.bodies:
            velocity = self.body_velocities[body.masscenter]
            terms.append(body.mass * self._square(velocity) / 2)
            if not isinstance(body, Particle):
                rate = body.frame.ang_vel_in(self.frame)
                for size, first, second in body.central_inertia.args:
                    terms.append(size * self.dot(rate, first) * self.dot(rate, second) / 2)
        return sm.Add(*terms)

    @cached_property
    def symbols(self) -> set[sm.Symbol]:
        """The symbols in the bodies and loads, whether they occur in the equations or not."""
        inertias = (size for body in self.bodies for size in self._inertias(body))
        parts = self._terms(self.body_velocities.values())
        return set().union(*(sm.sympify(part).free_symbols for part in (*parts, *inertias)))

    @cached_property
    def parts(self) -> tuple[sm.Expr, ...]:
        """Masses, loads, inertias of rotating bodies, and the velocities that the user set.

        Together with the positions they hold all symbols of the energies; SymPy takes seconds to
        derive the other velocities.
        """
        return self._terms(v for v in self._set_velocities() if v is not None)

    @property
    def velocities_are_set(self) -> bool:
        """Whether the user set the velocities of all mass centres."""
        return None not in self._set_velocities()

    def _set_velocities(self) -> list[Vector | None]:
        return [given_velocity(body.masscenter, self.frame) for body in self.bodies]

    def _terms(self, velocities: Iterable[Vector]) -> tuple[sm.Expr, ...]:
        parts = [body.mass for body in self.bodies]
        vectors = [*(vector for _, vector in self.loads), *velocities]
        for body in self.bodies:
            if (sizes := self._inertias(body)) and body.frame.ang_vel_in(self.frame) != 0:
                parts += sizes
        parts += [
            part for vector in vectors for components, _ in vector.args for part in components
        ]
        return tuple(map(sm.sympify, parts))

    @staticmethod
    def _inertias(body: Body) -> list[sm.Expr]:
        """Return the moments and products of inertia of a body; none for a particle."""
        point = isinstance(body, Particle)
        return [] if point else [size for size, _, _ in body.central_inertia.args]

    def _square(self, vector: Vector) -> sm.Expr:
        if len(vector.args) == 1:
            return sum(part**2 for part in vector.args[0][0])
        # SymPy's dot pairs every frame with every other, which for a chain of n links is n³ dots.
        return sum(part**2 for part in self.components(vector, self.frame))

    def components(self, vector: Vector, frame: ReferenceFrame) -> sm.Matrix:
        """Return the column matrix of a vector's components in a frame."""
        rows: tuple[list[sm.Expr], ...] = ([], [], [])
        for part, source in vector.args:
            if source == frame:
                parts = part
            else:
                turn = self._rotation(frame, source)
                parts = [_sum_of_products(turn[k, :], part) for k in range(3)]
            for row, entry in zip(rows, parts, strict=True):
                row.append(entry)
        return sm.Matrix([sm.Add(*row) for row in rows])

    def dot(self, a: Vector, b: Vector) -> sm.Expr:
        """Return the scalar product; `b` should have components in few frames."""
        return sm.Add(
            *(_sum_of_products(self.components(a, frame), part) for part, frame in b.args)
        )

    def _rotation(self, target: ReferenceFrame, source: ReferenceFrame) -> sm.Matrix:
        key = (target, source)
        if key not in self._rotations:
            self._rotations[key] = target.dcm(source)
        return self._rotations[key]


def _sum_of_products(a: Iterable[sm.Expr], b: Iterable[sm.Expr]) -> sm.Expr:
    """Return the scalar product of two vectors, faster than by SymPy's matrices."""
    return sm.Add(*(x * y for x, y in zip(a, b, strict=True) if x != 0 and y != 0))


@dataclass(frozen=True, eq=False)
class MassAndForcing:
    """M and F of a method object; both are empty if the equations are `formed` on a graph."""

    mass_matrix: sm.Matrix = ()  # the empty tuple if they are `formed`
    forcing: tuple[sm.Expr, ...] = ()
    # Whether the mass matrix is symmetric positive definite by construction.
    positive_definite: bool = True


@dataclass(frozen=True, eq=False)
class AuxiliaryEquations:
    """The equations of noncontributing forces, which auxiliary speeds bring into evidence."""

    speeds: tuple[TimeFunction, ...] = ()  # zero in motion
    residuals: tuple[sm.Expr, ...] = ()  # one for each auxiliary speed
    # The rate of a loop whose share in the residuals cannot be determined; these are empty then.
    unresolved_loop: sm.Expr | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Equations:
    """Equations of motion ``M u' = F`` with kinematics ``q' = G`` and constraints."""

    time: sm.Symbol
    coordinates: tuple[TimeFunction, ...]
    speeds: tuple[TimeFunction, ...]
    kinematics: KinematicEquations
    matrices: MassAndForcing
    constraints: ConstraintEquations = field(default_factory=ConstraintEquations)
    dependents: DependentStates = field(default_factory=DependentStates)
    auxiliary: AuxiliaryEquations = field(default_factory=AuxiliaryEquations)
    # The bodies and loads behind the equations, where the method knows them.
    mechanism: Mechanism | None = None
    # The equations of motion as nodes of a graph, formed from the bodies and loads.
    formed: EquationGraph | None = None
    # What the equations of motion can be formed from, where the method knows it.
    multibody: Multibody | None = None

    def __repr__(self) -> str:
        q, u = (", ".join(map(name_of, part)) for part in (self.coordinates, self.speeds))
        lines = [f"Equations: {q}; speeds {u}"]
        matrices, constraints = self.matrices, self.constraints
        if self.formed is not None:
            made_from = self.mechanism or self.multibody  # a Lagrangian may come without bodies
            counts = [len(made_from.bodies), len(made_from.loads)] if made_from else [0, 0]
            lines.append("formed on the graph from {} bodies and {} loads".format(*counts))
        else:
            shape, count = matrices.mass_matrix.shape, len(matrices.forcing)
            lines.append(f"a mass matrix {shape} and {count} forces")
        rows = {
            "holonomic constraints": constraints.holonomic,
            "velocity constraints": constraints.velocity,
            "nonholonomic constraints": constraints.nonholonomic,
            "auxiliary equations": self.auxiliary.residuals,
        }
        lines += [f"{len(group)} {kind}" for kind, group in rows.items() if group]
        return "\n  ".join(lines)

    @cached_property
    def unit_quaternions(self) -> dict[tuple[int, ...], list[sm.MatrixBase]]:
        """The columns of quaternions that orient frames at unit length alone, and their matrices.

        Quaternions whose matrix is divided by the square of the length may have any.
        """
        made_from = self.mechanism or self.multibody
        matrices = () if made_from is None else FrameTree(made_from.frame).rotation_matrices()
        quaternions: dict[tuple[int, ...], list[sm.MatrixBase]] = {}
        for matrix in matrices:
            if _is_of_unit_quaternion(matrix, self.coordinates):
                symbols = find_symbols(matrix)
                columns = tuple(k for k, q in enumerate(self.coordinates) if q in symbols)
                quaternions.setdefault(columns, []).append(matrix)
        return quaternions

    @cached_property
    def symbols(self) -> dict[AnySymbol, None]:
        """The symbols, functions of time and derivatives that occur in the equations of motion."""
        occurring = find_symbols(self.expressions)
        if self.formed is not None:
            occurring.update(dict.fromkeys(self.formed.symbols(self.kinematics.speed_rates)))
        return occurring

    @property
    def expressions(self) -> tuple[sm.Expr, ...]:
        """The expressions in the equations of motion, as far as they are written as such.

        Constraints that were omitted as redundant are so with the right numbers only.
        """
        return (
            *self.kinematics.coordinate_derivatives,
            *self.matrices.mass_matrix,
            *self.matrices.forcing,
            *self.constraints.holonomic,
            *self.constraints.velocity,
            *self.constraints.redundant.holonomic,
            *self.constraints.redundant.velocity,
        )

    @cached_property
    def kinetic_energy(self) -> sm.Expr | None:
        """The kinetic energy in terms of q, u, t, constants and specifieds; None without bodies."""
        if self.mechanism is None or not self.mechanism.bodies:
            return None
        if self.multibody is not None:
            self.multibody.check_unchanged()
        return self.kinematics.in_states(self.mechanism.kinetic_energy)

    @cached_property
    def constraint_forces(self) -> ConstraintForces | None:
        """The equations of multipliers and reactions; None without bodies."""
        if self.multibody is None:
            return None
        self.multibody.check_unchanged()
        constraints = self.constraints
        holonomic, nonholonomic = len(constraints.holonomic), len(constraints.nonholonomic)
        return ConstraintForces(
            self.multibody,
            {k: constraints.holonomic[k] for k in constraints.implied_holonomic},
            {holonomic + k: e for k, e in enumerate(constraints.nonholonomic)},
            {holonomic + nonholonomic + k: e for k, e in enumerate(constraints.implied_velocity)},
        )


_UNITS = [[sm.Rational(n, 10) for n in numbers] for numbers in ((5, 5, 5, 5), (1, 7, 1, 7))]


def _is_of_unit_quaternion(matrix: sm.MatrixBase, coordinates: Sequence[TimeFunction]) -> bool:
    """Return whether a matrix is a rotation for quaternions of unit length alone.

    Matrices of small angles are not rotations.
    """
    if matrix.has(sm.sin, sm.cos):  # a quick test that excludes most matrices
        return False
    symbols = find_symbols(matrix)
    if len(symbols) != 4 or not symbols.keys() <= {*coordinates}:
        return False
    for numbers in _UNITS:
        rotation = matrix.xreplace(dict(zip(symbols, numbers, strict=True)))
        if rotation * rotation.T != sm.eye(3):
            return False
    longer = matrix.xreplace(dict.fromkeys(symbols, sm.S.One))  # of length 2
    return bool(longer * longer.T != sm.eye(3))
