"""The potential energy of loads that can be recognised as conservative.

A load is recognised by its form: a force that is constant in the inertial frame, equal and opposite
forces between two points that depend on their distance alone, forces of floors that depend on the
height of a point, and loads whose work SymPy can integrate, such as linear springs along a
coordinate, -K sin 2q or the Piecewise force of a contact. Such loads are integrated together, one
by one, or as opposite torques on two frames. Loads that depend on speeds, time or specifieds have
no potential. Other loads that depend on the configuration may or may not: they are reported.

Each candidate is verified numerically: at generic states that satisfy the constraints, the rate of
the energy must be minus the power of the loads. A one-sided force, such as that of a floor, is zero
at most of these states, so further states are sampled on both sides of every switch.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, Vector
from sympy.utilities.iterables import sift

from pydy._checks import shown
from pydy._errors import UnsupportedFunctionError
from pydy._forks import cached_property
from pydy._graph import Graph
from pydy._mechanics.distance import (
    SWITCHED,
    beside_constants,
    integral_over,
    may_depend_on,
    primitive,
    random_values,
)
from pydy._mechanics.equations import Equations, Mechanism
from pydy._mechanics.frame_tree import FrameTree, distances, given_velocity, steps_to
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.reader import InputReader
from pydy._mechanics.symbols import find_symbols, replace_symbols
from pydy._mechanics.verify_potential import has_momenta_of, is_potential_of
from pydy._mechanics.work import forces_of_power, has_quotients, may_be_exact
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, Load, Location, TimeFunction

_MASS = sm.Rational(7, 11)  # a number that occurs in no formula


@dataclass
class Potential:
    """The potential energy of the loads that were recognised, and the loads that were not."""

    # In terms of q, t, constants and specifieds.
    expression: sm.Expr = sm.S.Zero
    # The loads that depend on the configuration but could not be recognised, for messages.
    unknown: list[str] = field(default_factory=list)
    advice: str = ""  # why they were not recognised


_NO_PLACE = (
    "A constant force needs the position of its point from a point that stands still in the "
    "inertial frame (`Point.set_pos`)."
)
_NO_INTEGRAL = (
    "The work of a load that depends on the configuration must be one that SymPy can integrate, "
    "along coordinates whose derivatives are speeds or constant combinations of them, and the same "
    "on every path."
)


@dataclass(frozen=True, eq=False)
class _Term:
    """One component of a load: a magnitude along a unit vector."""

    location: Location  # a Point or ReferenceFrame
    size: sm.Expr
    frame: ReferenceFrame
    axis: int

    @property
    def direction(self) -> Vector:
        return (self.frame.x, self.frame.y, self.frame.z)[self.axis]

    @property
    def vector(self) -> Vector:
        return self.size * self.direction


def _names(terms: Iterable[_Term]) -> list[str]:
    """Return a name for messages of each load that has some of the terms."""
    vectors: dict[Location, Vector] = {}
    for term in terms:
        vectors[term.location] = vectors.get(term.location, Vector(0)) + term.vector
    return [
        f"the {'force on the point' if isinstance(location, Point) else 'torque on the frame'} "
        f"{location}, `{shown(vector)}`"
        for location, vector in vectors.items()
    ]


def find_potential(equations: Equations) -> Potential:
    """Return the potential energy of the loads that are recognised."""
    mechanism = equations.mechanism
    if mechanism is None:
        return Potential()
    if equations.multibody is not None:
        equations.multibody.check_unchanged()
    with warnings.catch_warnings():
        # SymPy derives velocities that were not set, and warns if the result is ambiguous.
        warnings.simplefilter("ignore", UserWarning)
        potential = _PotentialSearch(equations, mechanism).result()
    if mechanism.lagrangian is not None:
        potential.expression += _potential_of_lagrangian(equations, mechanism)
    return potential


def _potential_of_lagrangian(equations: Equations, mechanism: Mechanism) -> sm.Expr:
    """Return the kinetic energy of the bodies minus the Lagrangian."""
    kinetic = equations.kinematics.in_states(mechanism.kinetic_energy)
    lagrangian = equations.kinematics.in_states(mechanism.lagrangian)
    if not has_momenta_of(equations, lagrangian, kinetic):
        raise ValueError(
            "Cannot determine the potential energy: the Lagrangian depends on the speeds in "
            "another way than the kinetic energy of the `bodies` of `eom_method`. Give it all "
            "bodies, or set `system.potential_energy`."
        )
    return replace_symbols(kinetic - lagrangian, dict.fromkeys(equations.speeds, sm.S.Zero))


class _PotentialSearch:
    """Recognises loads form by form, simple forms first; `result` has the order.

    Each method `_recognise_…` appends an energy and the power of its loads to `recognised`. Those
    of one load return whether they did; those of several return the loads that remain unknown.
    """

    def __init__(self, equations: Equations, mechanism: Mechanism) -> None:
        self.equations, self.mechanism = equations, mechanism
        self.frame = mechanism.frame
        forces = equations.constraints.residuals.unknowns_of_speeds
        self.coordinates = {*equations.coordinates} - forces
        # Energies, and the powers of their loads: the sum of powers is minus the energy's rate.
        self.recognised: list[tuple[sm.Expr, sm.Expr]] = []
        self.fixed = cache(self._fixed)
        self.away = cache(lambda point: distances(point, FrameTree.positions))
        self.line = cache(self._line)
        # Groups of loads are tried again with fewer members; single loads that failed are cached.
        self.exact, self.antiderivative = cache(self._may_be_exact), cache(self._antiderivative)
        read = InputReader(Graph(), {}, ())
        matrices = FrameTree(self.frame).rotation_matrices()
        self.turns = [m for m in matrices if orthogonality_residuals([m], read)]

    def result(self) -> Potential:
        """Return the potential of all loads that do work, verified; or what has none, and why."""
        loads = [load for load in self.mechanism.loads if self._does_work(load[0])]
        loads = [load for load in loads if not self._recognise_constant_load(*load)]
        if (given := self._given_potential(loads)) is not None:
            return Potential(given)
        before = len(self.recognised)
        unlocated, unknown = self._recognise_loads(loads)
        if unknown:  # forces of different laws may have been added at a point
            parts = [part for load in loads for part in self._parts_by_law(*load)]
            of_whole_loads = self.recognised[before:]
            del self.recognised[before:]
            if len(parts) == len(loads) or self._recognise_loads(parts)[1]:
                self.recognised[before:] = of_whole_loads
            else:
                unlocated, unknown = [], []
        load_energy, powers = (
            sm.Add(*(energy for energy, _ in self.recognised)),
            [p for _, p in self.recognised],
        )
        bodies = self.mechanism.bodies if self.mechanism.lagrangian is None else ()
        of_bodies = sm.Add(*(body.potential_energy for body in bodies))
        body_energy = self.equations.kinematics.in_states(of_bodies)
        everything = [*powers, *(self._power(t.location, t.vector) for t in unknown)]
        sound = not powers or is_potential_of(self.equations, load_energy, powers)
        if sound and not unknown:
            return Potential(load_energy)
        # The bodies' `potential_energy` may belong to all loads, or to those not recognised.
        for candidate in (body_energy, load_energy + body_energy):
            if body_energy != 0 and is_potential_of(self.equations, candidate, everything):
                return Potential(candidate)
        if not sound:
            return Potential(
                sm.S.Zero,
                [
                    f"the load on {location}, `{shown(vector)}`"
                    for location, vector in self.mechanism.loads
                ],
                _NO_INTEGRAL,
            )
        advice = [_NO_PLACE] * bool(unlocated) + [_NO_INTEGRAL] * (len(unknown) > len(unlocated))
        return Potential(load_energy, _names(unknown), " ".join(advice))

    def _recognise_loads(self, loads: Sequence[Load]) -> tuple[list[_Term], list[_Term]]:
        """Recognise loads in all forms; return those without a position, and all unknown ones."""
        terms = [
            term
            for location, vector in self._recognise_central_forces(loads)
            for term in self._terms(location, vector)
        ]
        terms = [term for term in terms if not self._recognise_constant_force(term)]
        terms = [term for term in terms if not self._recognise_by_height(term)]
        before = len(self.recognised)
        unlocated, unknown = self._recognise_closed_forms(terms)
        if unknown:  # one load of an opposite pair may have been recognised alone
            del self.recognised[before:]
            unlocated, unknown = self._recognise_closed_forms(self._recognise_along_one_rate(terms))
        return unlocated, unknown

    def _parts_by_law(self, location: Location, vector: Vector) -> list[Load]:
        """Return the parts of a load whose terms have the same law.

        The law of a term is the product of its factors that are neither constants nor polynomials
        in coordinates, sines and cosines, as a component of the line between two points is: the
        attraction and the rope in ``-mu*r/r³ + k*Max(0, L - l)*line/L`` have 1/r³ and Max(0, …)/L.
        """
        parts: dict[sm.Expr, Vector] = {}
        for term in self._terms(location, vector):
            factors, law = sift(sm.Mul.make_args(term.size), self._is_polynomial, binary=True)
            part = sm.Mul(*factors) * term.direction
            parts[sm.Mul(*law)] = parts.get(sm.Mul(*law), Vector(0)) + part
        # k x₁ − k x₂ as a multiple of x₁ − x₂, which the line between two points is.
        return [(location, law * part.applyfunc(sm.factor_terms)) for law, part in parts.items()]

    def _is_polynomial(self, factor: sm.Expr) -> bool:
        """Whether a factor is a constant, or a power of a coordinate, a sine or a cosine."""
        base, exponent = factor.as_base_exp()
        known = base in self.coordinates or isinstance(base, (sm.sin, sm.cos))
        return self._is_constant(factor) or (known and bool(exponent.is_Integer and exponent > 0))

    def _given_potential(self, loads: Sequence[Load]) -> sm.Expr | None:
        """Return the potential of the multibody's definition if the power of all loads agrees.

        `loads` are those that are not constant. The forms below recognise many springs of robots
        only after long integrations, or not at all, since products of decimals do not cancel.
        """
        multibody = self.equations.multibody
        if multibody is None or multibody.potential is None:
            return None
        remaining = [term for load in loads for term in self._terms(*load)]
        powers = [p for _, p in self.recognised]
        powers += [self._power(term.location, term.vector) for term in remaining]
        given = self.equations.kinematics.in_states(multibody.potential)
        of_constant_loads = sm.Add(*(energy for energy, _ in self.recognised))
        for candidate in (of_constant_loads + given, given):
            if is_potential_of(self.equations, candidate, powers):
                return candidate
        return None

    def _velocity(self, location: Location) -> Vector:
        if isinstance(location, Point):
            return self.mechanism.load_velocities[location]
        return location.ang_vel_in(self.frame)

    def _power(self, location: Location, vector: Vector) -> sm.Expr:
        power = self.mechanism.dot(self._velocity(location), vector)
        return self.equations.kinematics.in_states(power)

    def _does_work(self, location: Location) -> bool:
        """Whether a load there does work in real motion, in which auxiliary speeds are zero."""
        in_states = self.equations.kinematics.in_states
        return any(
            in_states(part) != 0 for parts, _ in self._velocity(location).args for part in parts
        )

    def _is_constant(self, expression: sm.Expr) -> bool:
        time = self.equations.time
        return all(s.is_Symbol and s != time for s in find_symbols([sm.sympify(expression)]))

    def _is_static(self, expression: sm.Expr) -> bool:
        """Whether an expression depends on coordinates and constants alone."""
        return all(
            s in self.coordinates or self._is_constant(s) for s in find_symbols([expression])
        )

    def _static_part(self, expression: sm.Expr) -> sm.Expr:
        """Return the terms of an expression that depend on coordinates and constants alone.

        Products of sums are not expanded: products of velocities have very many terms.
        """
        if expression.is_Add or expression.is_Mul:
            return expression.func(*map(self._static_part, expression.args))
        if expression.is_Pow and expression.exp.is_Integer and expression.exp > 0:
            return self._static_part(expression.base) ** expression.exp
        return expression if self._is_static(expression) else sm.S.Zero

    def _terms(self, location: Location, vector: Vector) -> Iterator[_Term]:
        for parts, frame in vector.args:
            for axis, part in enumerate(parts):
                for size in sm.Add.make_args(sm.expand_mul(self._static_part(part))):
                    if size != 0:
                        yield _Term(location, size, frame, axis)

    def _fixed(self, point: Point) -> list[Point]:
        """Return the points at rest in the inertial frame that are located from a point."""
        nearest_first = self.away(point)
        at_rest = [p for p in nearest_first if given_velocity(p, self.frame) == 0]
        for point_at_rest in at_rest:  # and the points at fixed positions from them
            at_rest += [
                p
                for p in FrameTree.positions(point_at_rest)
                if p not in at_rest and self._is_at_fixed_position(p, point_at_rest)
            ]
        return at_rest

    def _line(self, start: Point, end: Point) -> Vector | None:
        """Return the vector between two points; None if their positions are unrelated.

        All steps are summed at once: adding them one by one, as SymPy does, costs n² terms.
        """
        away = self.away(start)
        if end not in away:
            return None
        parts: dict[ReferenceFrame, list[sm.Matrix]] = {}
        for step in steps_to(end, away):
            for part, frame in step.args:
                parts.setdefault(frame, []).append(part)
        sums = {
            f: [sm.Add(*row) for row in zip(*components, strict=True)]
            for f, components in parts.items()
        }
        return Vector([(sm.Matrix(row), frame) for frame, row in sums.items()])

    def _is_at_fixed_position(self, point: Point, rest_point: Point) -> bool:
        """Return whether a point without a velocity is fixed relative to a point at rest."""
        return given_velocity(point, self.frame) is None and all(
            all(map(self._is_constant, parts)) and frame.ang_vel_in(self.frame) == 0
            for parts, frame in point.pos_from(rest_point).args
        )

    # -- forces between two points ----------------------------------------------------------------

    def _recognise_central_forces(self, loads: Sequence[Load]) -> list[Load]:
        """Recognise forces along the lines between points; return the other loads."""
        remaining: list[Load] = []
        opposite = _opposite([vector for _, vector in loads], self.turns)
        numbers_of_remaining: list[int] = []
        for number, (location, vector) in enumerate(loads):
            partner = next(
                (k for k, j in enumerate(numbers_of_remaining) if opposite(number, j)), None
            )
            fixed_points = self.fixed(location) if isinstance(location, Point) else []
            if partner is not None and self._recognise_central_force(
                location, remaining[partner][0], vector
            ):
                self.recognised.append((sm.S.Zero, self._power(*remaining.pop(partner))))
                numbers_of_remaining.pop(partner)
            elif not any(
                self._recognise_central_force(location, fixed_point, vector)
                for fixed_point in fixed_points
            ):
                remaining.append((location, vector))
                numbers_of_remaining.append(number)
        opposites = [[opposite(i, j) for j in numbers_of_remaining] for i in numbers_of_remaining]
        return self._recognise_pathways(remaining, opposites)

    def _recognise_pathways(
        self, loads: list[Load], opposites: Sequence[Sequence[bool]]
    ) -> list[Load]:
        """Recognise equal tensions in all segments of a pathway; return the other loads."""
        segments: list[tuple[int, int, sm.Expr, sm.Expr]] = []  # two loads, force/line, L²
        for j in range(len(loads)):
            used = {i for pair in segments for i in pair[:2]}
            for i in range(j):
                (start, _), (end, force) = loads[i], loads[j]
                points = isinstance(start, Point) and isinstance(end, Point)
                if points and opposites[j][i] and i not in used and start != end:
                    line = end.pos_from(start)
                    if (ratio := _ratio(force, line, self.turns)) is not None:
                        segments.append((i, j, ratio, line.dot(line)))
                        break
        tensions = [ratio * sm.sqrt(square) for _, _, ratio, square in segments]
        values = random_values(tensions, self.turns) if tensions else np.zeros((1, 0))
        used_loads: set[int] = set()
        for k in range(len(segments)):
            alike = np.abs(values - values[:, [k]]) <= ROUNDED * np.abs(values[:, [k]])
            pathway = [segments[n] for n in np.flatnonzero(alike.all(axis=0))]
            if len(pathway) > 1 and used_loads.isdisjoint(
                ends := {i for pair in pathway for i in pair[:2]}
            ):
                power = sm.Add(*(self._power(*loads[i]) for i in sorted(ends)))
                energy = self._of_length([pair[2:] for pair in pathway])
                if energy is not None and self._is_sound(energy, [power]):
                    self.recognised.append((energy, power))
                    used_loads |= ends
        return [load for i, load in enumerate(loads) if i not in used_loads]

    def _of_length(self, segments: Sequence[tuple[sm.Expr, sm.Expr]]) -> sm.Expr | None:
        """Return the energy of a tension that depends on the total length of segments, or None."""
        lengths = {sm.Dummy("L", positive=True): square for _, square in segments}
        law, (first, *further) = segments[0][0], lengths
        for length, square in lengths.items():
            law = _in_terms_of(law, square, length, self.turns)
        energy = self._by_law(replace_symbols(law, dict.fromkeys(further, sm.S.Zero)), first)
        total = sm.Add(*map(sm.sqrt, lengths.values()))
        return None if energy is None else replace_symbols(energy, {first: total})

    def _recognise_central_force(self, point: Location, partner: Location, force: Vector) -> bool:
        """Recognise a force along the line to `partner` that depends on the distance alone."""
        if not (isinstance(point, Point) and isinstance(partner, Point)):
            return False
        if (line := self.line(partner, point)) is None:
            return False
        if (ratio := _ratio(force, line, self.turns)) is None:
            return False
        square = line.dot(line)
        if self._is_constant(square):  # no work: two points of one body, for instance
            self.recognised.append((sm.S.Zero, self._power(point, force)))
            return True
        moving = [s for s in find_symbols([ratio, square]) if not self._is_constant(s)]
        # With quaternions only gradients along the unit sphere count.
        if not (self.turns or may_depend_on(ratio, square, moving)):
            return False
        distance = sm.Dummy("L", positive=True)
        energy = self._by_law(_in_terms_of(ratio, square, distance, self.turns), distance)
        if energy is None:
            return False
        energy = replace_symbols(energy, {distance: sm.sqrt(square)})
        self.recognised.append((energy, self._power(point, force)))
        return True

    def _by_law(self, ratio: sm.Expr, distance: sm.Symbol) -> sm.Expr | None:
        """Return the energy of the force `ratio · line` between two points, or None."""
        law = ratio * distance
        if not self._is_constant(law):  # it may contain both a - b and b - a
            law = sm.signsimp(law)
        return integral_over(-law, distance) if self._is_constant(law) else None

    def _recognise_constant_load(self, location: Location, vector: Vector) -> bool:
        """Recognise a constant load, or one proportional to a changing mass at its point."""
        if (mass := self._changing_mass(location)) != 1 and vector.args:
            # Products of decimals are rounded: divide at one value of the mass, then compare.
            at = dict.fromkeys((s for s in find_symbols([mass]) if not self._is_constant(s)), _MASS)
            share = replace_symbols(mass, at)
            per_mass = vector.applyfunc(lambda e: sm.cancel(replace_symbols(e, at) / share))
            if not _opposite([vector, -mass * per_mass], self.turns)(0, 1):
                return False
            vector = per_mass
        components = [part for parts, _ in vector.args for part in parts if part != 0]
        if not all(map(self._is_constant, components)):
            return False
        before = len(self.recognised)
        if all(
            self._recognise_constant_force(term, mass) for term in self._terms(location, vector)
        ):
            return True
        del self.recognised[before:]
        return False

    def _changing_mass(self, location: Location) -> sm.Expr:
        """Return the mass of the body at a point if it depends on time or specifieds, else 1."""
        for mass in (sm.sympify(b.mass) for b in self.mechanism.bodies if b.masscenter is location):
            if not (self._is_constant(mass) or self.coordinates & {*find_symbols([mass])}):
                return mass
        return sm.S.One

    def _height(self, term: _Term) -> sm.Expr | None:
        """Return the height of a force's point along its direction; None if that changes."""
        origins = self.fixed(term.location) if isinstance(term.location, Point) else []
        if not origins:
            return None
        direction = self.mechanism.components(term.direction, self.frame)
        if not all(self._is_constant(part) for part in direction):
            return None
        unit_vector = Vector([(direction, self.frame)])
        return self.mechanism.dot(self.line(origins[0], term.location), unit_vector)

    def _recognise_constant_force(self, term: _Term, mass: sm.Expr = sm.S.One) -> bool:
        """Recognise a constant force, for each unit of a `mass` that may change with time."""
        height = self._height(term) if self._is_constant(term.size) else None
        if height is None:
            return False
        power = mass * self._power(term.location, term.vector)
        # Mass that is added at this height has a potential energy there.
        added_power = term.size * height * mass.diff(self.equations.time)
        self.recognised.append((-term.size * height * mass, power + added_power))
        return True

    def _recognise_by_height(self, term: _Term) -> bool:
        """Recognise a switched force along a fixed line that depends on height alone."""
        height = self._height(term) if term.size.has(*SWITCHED) else None
        if height is None:
            return False
        h = sm.Dummy("h", real=True)
        coordinates = [s for s in find_symbols([height]) if not s.is_Symbol]
        sums = {height, *term.size.atoms(sm.Add)} if coordinates else set()
        shares = {e: beside_constants(e, height, coordinates) for e in sums}
        named = {e: share[0] * h + share[1] for e, share in shares.items() if share is not None}
        law = term.size.xreplace(named)
        part = primitive(law, h) if self._is_constant(law) else None
        if part is None:
            return False
        energy = replace_symbols(-part, {h: height})
        self.recognised.append((energy, self._power(term.location, term.vector)))
        return True

    # -- closed forms -----------------------------------------------------------------------------

    def _recognise_closed_forms(self, terms: list[_Term]) -> tuple[list[_Term], list[_Term]]:
        """Recognise integrable loads; return those without a position, and all others."""
        remaining = self._recognise_integrable(terms)
        # A constant force has a potential, but its point may have no position.
        constant = [
            t for t in remaining if isinstance(t.location, Point) and self._is_constant(t.size)
        ]
        unlocated = [term for term in constant if not self.fixed(term.location)]
        located = [term for term in remaining if term not in unlocated]
        return unlocated, [
            *unlocated,
            *(self._recognise_integrable(located) if len(located) < len(terms) else located),
        ]

    def _recognise_integrable(self, terms: list[_Term]) -> list[_Term]:
        """Recognise loads whose work can be integrated; return the others.

        They are integrated together, as a spring between two bodies requires, or else one by one.
        """
        if not terms:
            return []
        powers = tuple(self._power(t.location, t.vector) for t in terms)
        *each, together = self.exact(powers)
        energy = self.antiderivative(powers) if together else None
        if energy is not None:
            self.recognised.append((energy, sm.Add(*powers)))
            return []
        remaining = []
        for term, power, exact in zip(terms, powers, each, strict=True):
            if not exact or (energy := self.antiderivative((power,))) is None:
                remaining.append(term)
            else:
                self.recognised.append((energy, power))
        return remaining

    def _recognise_along_one_rate(self, terms: list[_Term]) -> list[_Term]:
        """Recognise loads that do work along one coordinate only; return the others.

        The power of a single load, or of opposite torques on two frames, is then a force times the
        rate of the coordinate: a spring or a stop of a joint.
        """
        opposite = _opposite([term.vector for term in terms], self.turns)
        numbers = range(len(terms))
        pairs = [[j, k] for k in numbers for j in range(k) if opposite(k, j)]
        powers = [self._power(term.location, term.vector) for term in terms]
        remaining = set(numbers)
        for group in [*pairs, *([k] for k in numbers)]:
            if not remaining.issuperset(group):
                continue
            power = sm.Add(*(powers[k] for k in group))
            energy = self._along_rate(power)
            if energy is not None:
                self.recognised.append((energy, power))
                remaining.difference_update(group)
        return [terms[k] for k in sorted(remaining)]

    def _along_rate(self, power: sm.Expr) -> sm.Expr | None:
        """Return minus the integral of a force times the rate of one coordinate, or None."""
        factors = [find_symbols([factor]) for factor in sm.Mul.make_args(power)]
        speeds = {u for _, u, _ in self._single}
        if any(speeds.isdisjoint(f) and len(self.coordinates & f.keys()) > 1 for f in factors):
            return None  # a factor of the force depends on two coordinates
        for c, u, slope in self._single:
            force = power.diff(u) / slope
            if force == 0 or not self._is_constant(force.xreplace({c: sm.S.One})):
                continue
            x = sm.Dummy(c.func.__name__, real=True)
            part = primitive(replace_symbols(force, {c: x}), x)
            if part is not None:
                energy = replace_symbols(-part, {x: c})
                if self._is_sound(energy, [power]):
                    return energy
        return None

    def _is_sound(self, energy: sm.Expr, powers: Sequence[sm.Expr]) -> bool:
        try:
            return is_potential_of(self.equations, energy, powers)
        except UnsupportedFunctionError:
            return False

    @cached_property
    def _in_rates(self) -> tuple[dict[TimeFunction, sm.Expr], dict[AnySymbol, TimeFunction]]:
        """Substitutions of speeds by coordinate rates, and the coordinate of each rate.

        A rate is a speed, or a Dummy if it is a constant combination of several speeds.
        """
        speeds, q_dot = self.equations.speeds, self.equations.kinematics.coordinate_derivatives
        rates = dict(zip(self.equations.coordinates, q_dot, strict=True))
        direct = {rate: c for c, rate in rates.items() if rate in speeds}
        mixed = find_symbols(rate for rate in rates.values() if rate not in speeds)
        combined = [u for u in speeds if u in mixed]
        rows = {c: rate for c, rate in rates.items() if rate in combined or rate not in speeds}
        if not combined or len(combined) != len(rows):
            return {}, direct
        slopes = sm.Matrix([[rate.diff(u) for u in combined] for rate in rows.values()])
        offsets = sm.Matrix(list(rows.values())) - slopes * sm.Matrix(combined)
        linear = all(self._is_constant(c) for c in slopes) and not any(map(sm.expand, offsets))
        if not linear or slopes.det() == 0:
            return {}, direct
        dummies = {sm.Dummy(str(c)): c for c in rows}
        in_rates = dict(zip(combined, slopes.LUsolve(sm.Matrix(list(dummies))), strict=True))
        return in_rates, {**{u: c for u, c in direct.items() if u not in combined}, **dummies}

    @cached_property
    def _single(self) -> list[tuple[TimeFunction, TimeFunction, sm.Expr]]:
        """Coordinates, each with one speed and that speed's constant factor in the rate."""
        single = []
        rates = self.equations.kinematics.coordinate_derivatives
        for c, rate in zip(self.equations.coordinates, rates, strict=True):
            slopes = ((u, rate.diff(u)) for u in self.equations.speeds)
            single += [(c, u, slope) for u, slope in slopes if slope.is_number and slope][:1]
        return single

    def _may_be_exact(self, powers: tuple[sm.Expr, ...]) -> list[bool]:
        in_rates, coordinates = self._in_rates
        in_speeds = [replace_symbols(power, in_rates) for power in powers]
        return may_be_exact(in_speeds, coordinates, self.turns)

    def _antiderivative(self, powers: tuple[sm.Expr, ...]) -> sm.Expr | None:
        """Return minus the integral of the work, one coordinate after the other, or None."""
        in_rates, speed = self._in_rates
        if not speed:
            return None
        in_speeds = [replace_symbols(power, in_rates) for power in powers]
        # Expanded polynomials that are equal are identical; quotients need not be.
        is_polynomial = not any(map(has_quotients, in_speeds))
        forces = forces_of_power(in_speeds, speed) if is_polynomial else None
        if forces is not None and all(map(self._is_static, forces.values())):
            return self._integrated({speed[u]: force for u, force in forces.items()}, powers)
        try:
            terms = sm.Poly(sm.Add(*in_speeds), *speed).terms()
        except sm.PolynomialError:
            return None
        if any(sum(monomial) != 1 or not self._is_static(force) for monomial, force in terms):
            return None
        rates = list(speed.values())
        return self._integrated({rates[m.index(1)]: force for m, force in terms}, powers)

    def _integrated(
        self, forces: dict[TimeFunction, sm.Expr], powers: Sequence[sm.Expr]
    ) -> sm.Expr | None:
        """Return minus the integral of forces along coordinates, one after the other, or None."""
        real = {c: sm.Dummy(c.func.__name__, real=True) for c in self.equations.coordinates}
        parts: list[sm.Expr] = []
        holding: dict[sm.Symbol, list[sm.Expr]] = {}  # the parts that depend on a coordinate
        done: set[sm.Symbol] = set()
        for c, force in forces.items():
            x = real[c]
            before = (part.diff(x) for part in holding.get(x, ()))
            remaining = sm.expand(sm.Add(replace_symbols(force, real), *before))
            if remaining.free_symbols & done:  # the work appears to depend on the path
                return None
            if (part := primitive(remaining, x)) is None:
                return None
            parts.append(-part)
            for symbol in part.free_symbols:
                holding.setdefault(symbol, []).append(-part)
            done.add(x)
        absent = {*real.values()} - done
        exact = absent.isdisjoint(holding) and all(
            part.is_polynomial(*(part.free_symbols & done)) for part in parts
        )
        energy = replace_symbols(sm.Add(*parts), {x: c for c, x in real.items()})
        return energy if exact or self._is_sound(energy, powers) else None


def _opposite(vectors: Sequence[Vector], turns: Iterable[sm.Matrix]) -> Callable[[int, int], bool]:
    """Return a predicate that compares two vectors: opposite, up to rounding.

    A law times a vector of decimals and its opposite may be rounded differently.
    """
    parts = [{(f, i): part for row, f in v.args for i, part in enumerate(row)} for v in vectors]
    keys = list(dict.fromkeys(key for components in parts for key in components))
    rows = [[components.get(key, sm.S.Zero) for key in keys] for components in parts]
    values = np.zeros((1, len(vectors), 1))
    if len(vectors) > 1:
        with suppress(UnsupportedFunctionError):
            values = random_values([part for row in rows for part in row], turns)
            values = values.reshape(-1, len(vectors), len(keys))
    sizes = np.abs(values).max(axis=2)

    def opposite(i: int, j: int) -> bool:
        if not sizes[:, i].any():  # it may be zero at the samples only
            return bool(vectors[i] != 0 and vectors[i] + vectors[j] == 0)
        residual = np.abs(values[:, i] + values[:, j]).max(axis=1)
        return bool((residual <= ROUNDED * sizes[:, i]).all())

    return opposite


def _ratio(force: Vector, line: Vector, turns: Iterable[sm.Matrix]) -> sm.Expr | None:
    """Return s in ``force = s · line``, or None if there is none.

    Values are compared, since positions and forces given in decimals are rounded differently.
    """
    line_parts = {(f, i): part for parts, f in line.args for i, part in enumerate(parts)}
    force_parts = {(f, i): part for parts, f in force.args for i, part in enumerate(parts)}
    keys = list(line_parts | force_parts)
    pairs = [(force_parts.get(p, sm.S.Zero), line_parts.get(p, sm.S.Zero)) for p in keys]
    flat = [part for pair in pairs for part in pair]
    values = random_values(flat, turns).reshape(-1, len(pairs), 2)
    pull, offset = values[..., 0], values[..., 1]
    largest = int(np.abs(offset[0]).argmax())
    if not (np.isfinite(values).all() and offset[:, largest].all() and pull.any()):
        return None  # they may be zero at the samples only
    ratio = pull[:, [largest]] / offset[:, [largest]]
    # The whole potential is verified against the power of the loads at the end.
    if (np.abs(pull - ratio * offset) > ROUNDED * np.abs(pull).max(axis=1, keepdims=True)).any():
        return None
    f, r = pairs[largest]
    return f / r


def _in_terms_of(
    expression: sm.Expr, square: sm.Expr, distance: sm.Symbol, turns: Iterable[sm.Matrix]
) -> sm.Expr:
    """Rewrite an expression in terms of a distance: replace multiples of its square."""
    moving = find_symbols([square])
    sums = {square, *(p.base for p in expression.atoms(sm.Pow)), *expression.atoms(sm.Add)}
    bases = [e for e in sums if find_symbols([e]) == moving]
    values = random_values([square, *bases], turns)
    shares = values[:, 1:] / values[:, :1]
    alike = np.abs(shares - shares[0]).max(axis=0) <= ROUNDED * np.abs(shares[0])
    named = {
        base: (1 if abs(share - 1.0) <= ROUNDED else sm.Float(share)) * distance**2
        for base, share, same in zip(bases, shares[0], alike, strict=True)
        if same
    }

    def is_power(e: sm.Expr) -> bool:
        return bool(e in named or (e.is_Pow and e.base in named))

    def written(expression: sm.Expr) -> sm.Expr:
        return expression.replace(
            is_power,
            lambda e: named[e] if e in named else sm.powdenest(named[e.base] ** e.exp, force=True),
        )

    rewritten = written(expression)
    coordinates = [s for s in moving if not s.is_Symbol]
    if coordinates and rewritten.has(*coordinates):
        for e in rewritten.atoms(sm.Add):
            softened = beside_constants(e, square, coordinates)
            if softened is not None:
                named[e] = softened[0] * distance**2 + softened[1]
        rewritten = written(rewritten)
    return rewritten
