"""The potential energy of loads that can be recognised as conservative.

Only what follows from the form of a load is taken: a force that is constant in the inertial frame,
equal and opposite forces between two points that depend on their distance alone, forces of floors
by the height of a point, and loads whose work SymPy integrates, such as that of linear springs
along a coordinate, -K sin 2q or a Piecewise force of a contact; all together, one by one, or as
opposite torques on two frames. What depends on speeds, time or specifieds has no potential. What
depends on the configuration in another way may have one or not: it is named rather than left out.

Whether an energy is that of some loads is decided by numbers: at generic states that keep the
constraints its rate is minus their power. A force that acts on one side only, as that of a floor,
is zero at most of them: what an expression switches at is looked for, and both its sides count.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, Vector

from pydy._errors import UnsupportedFunctionError
from pydy._forks import cached_property
from pydy._graph import Branches, Graph, jacobian, rounding_bounds
from pydy._mechanics.components import numbers_of
from pydy._mechanics.distance import beside_constants, may_depend_on
from pydy._mechanics.equations import Equations, Mechanism
from pydy._mechanics.frame_tree import FrameTree, distances, given_velocity, steps_to, velocity_in
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.generic import Block, GenericStates
from pydy._mechanics.reader import InputReader
from pydy._mechanics.symbols import find_symbols, replace_symbols
from pydy._mechanics.tuning import NEAR
from pydy._mechanics.work import forces_of_power, has_quotients
from pydy._rank import ROUNDED

_TRIALS, _MASS = 3, sm.Rational(7, 11)  # a number that no formula holds
_SWITCHED = sm.Max, sm.Min, sm.Abs, sm.sign, sm.Heaviside, sm.Piecewise
# How far beyond a switch states are looked for, of their distance before: limbs reach no further.
_BEYOND = (-1.0, -0.1, -0.01)
_FAR = (-41.0, 41.0)  # six turns from there, or as many units


@dataclass
class Potential:
    """The potential energy, as far as it is known."""

    # Of the loads that were recognised, in terms of q, t, constants and specifieds.
    expression: Any = sm.S.Zero
    # The loads that depend on the configuration but could not be recognised, for messages.
    unknown: list[str] = field(default_factory=list)
    advice: str = ""  # what they lack


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
    """A part of a load: one size along one unit vector."""

    where: Any
    size: Any
    frame: ReferenceFrame
    axis: int

    @property
    def direction(self) -> Vector:
        return (self.frame.x, self.frame.y, self.frame.z)[self.axis]

    @property
    def vector(self) -> Vector:
        return self.size * self.direction

    def __str__(self) -> str:
        kind = "force on the point" if isinstance(self.where, Point) else "torque on the frame"
        return f"the {kind} {self.where}, `{self.vector}`"


def find_potential(equations: Equations) -> Potential:
    """Return the potential energy of the loads, as far as they are recognised."""
    mechanism = equations.mechanism
    if mechanism is None:
        return Potential()
    if equations.multibody is not None:
        equations.multibody.check_unchanged()
    with warnings.catch_warnings():
        # SymPy makes up velocities that nobody set, and warns where there are several ways.
        warnings.simplefilter("ignore", UserWarning)
        found = _Search(equations, mechanism).result()
    if mechanism.lagrangian is not None:
        found.expression += _within(equations, mechanism)
    return found


def _within(equations: Equations, mechanism: Mechanism) -> Any:
    """Return the potential energy that a Lagrangian holds, with the bodies' kinetic one."""
    kinetic = equations.kinematics.in_states(mechanism.kinetic_energy)
    lagrangian = equations.kinematics.in_states(mechanism.lagrangian)
    if not has_momenta_of(equations, lagrangian, kinetic):
        raise ValueError(
            "Cannot determine the potential energy: the Lagrangian depends on the speeds in "
            "another way than the kinetic energy of the `bodies` of `eom_method`. Give it all "
            "bodies, or set `system.potential_energy`."
        )
    return replace_symbols(kinetic - lagrangian, dict.fromkeys(equations.speeds, sm.S.Zero))


class _Search:
    def __init__(self, equations: Equations, mechanism: Mechanism) -> None:
        self.equations, self.mechanism = equations, mechanism
        self.frame = mechanism.frame
        forces = equations.constraints.residuals.unknowns_of_speeds
        self.coordinates = {*equations.coordinates} - forces
        self.taken: list[tuple[Any, Any]] = []  # energies, and powers of the loads that have them
        self.fixed = cache(self._fixed)
        self.away = cache(lambda point: distances(point, FrameTree.positions))
        self.line = cache(self._line)
        # Loads are tried again with fewer beside them: one alone that failed fails again.
        self.antiderivative = cache(self._antiderivative)
        read = InputReader(Graph(), {}, ())
        matrices = FrameTree(self.frame).rotation_matrices()
        self.turns = [m for m in matrices if orthogonality_residuals([m], read)]

    def result(self) -> Potential:
        loads = [load for load in self.mechanism.loads if self._moves(load[0])]
        loads = [load for load in loads if not self._constant_load(*load)]
        terms = [
            term for where, vector in self._radial(loads) for term in self._terms(where, vector)
        ]
        terms = [term for term in terms if not self._constant_force(term)]
        terms = [term for term in terms if not self._by_height(term)]
        before = len(self.taken)
        lost, unknown = self._closed(terms)
        if unknown:  # a part of a load may have been taken without the opposite part
            del self.taken[before:]
            lost, unknown = self._closed(self._along_one_rate(terms))
        found, powers = sm.Add(*(energy for energy, _ in self.taken)), [p for _, p in self.taken]
        bodies = self.mechanism.bodies if self.mechanism.lagrangian is None else ()
        of_bodies = sm.Add(*(body.potential_energy for body in bodies))
        own = self.equations.kinematics.in_states(of_bodies)
        everything = [*powers, *(self._power(t.where, t.vector) for t in unknown)]
        sound = not powers or is_potential_of(self.equations, found, powers)
        if sound and not unknown:
            return Potential(found)
        # The bodies' own potential energies tell of loads: of all of them, or of the others.
        for candidate in (own, found + own):
            if own != 0 and is_potential_of(self.equations, candidate, everything):
                return Potential(candidate)
        if not sound:
            return Potential(
                sm.S.Zero,
                [f"the load on {where}, `{vector}`" for where, vector in self.mechanism.loads],
                _NO_INTEGRAL,
            )
        advice = [_NO_PLACE] * bool(lost) + [_NO_INTEGRAL] * (len(unknown) > len(lost))
        return Potential(found, [str(term) for term in unknown], " ".join(advice))

    def _velocity(self, where: Any) -> Vector:
        if isinstance(where, Point):
            return velocity_in(where, self.frame)
        return where.ang_vel_in(self.frame)

    def _power(self, where: Any, vector: Vector) -> Any:
        power = self.mechanism.dot(self._velocity(where), vector)
        return self.equations.kinematics.in_states(power)

    def _moves(self, where: Any) -> bool:
        """Whether a load there does work, other than on the fictitious auxiliary motion."""
        in_states = self.equations.kinematics.in_states
        return any(
            in_states(part) != 0 for parts, _ in self._velocity(where).args for part in parts
        )

    def _is_constant(self, expression: Any) -> bool:
        time = self.equations.time
        return all(s.is_Symbol and s != time for s in find_symbols([sm.sympify(expression)]))

    def _is_static(self, expression: Any) -> bool:
        """Whether an expression depends on coordinates and constants alone."""
        return all(
            s in self.coordinates or self._is_constant(s) for s in find_symbols([expression])
        )

    def _static_part(self, expression: Any) -> Any:
        """Return the terms of an expression that depend on coordinates and constants alone.

        Products of sums are not expanded for it: those of velocities have very many terms.
        """
        if expression.is_Add or expression.is_Mul:
            return expression.func(*map(self._static_part, expression.args))
        if expression.is_Pow and expression.exp.is_Integer and expression.exp > 0:
            return self._static_part(expression.base) ** expression.exp
        return expression if self._is_static(expression) else sm.S.Zero

    def _terms(self, where: Any, vector: Vector) -> Iterator[_Term]:
        for parts, frame in vector.args:
            for axis, part in enumerate(parts):
                for size in sm.Add.make_args(sm.expand_mul(self._static_part(part))):
                    if size != 0:
                        yield _Term(where, size, frame, axis)

    def _fixed(self, point: Point) -> list[Point]:
        """Return the points that stand still in the inertial frame and whose places are known."""
        nearest_first = self.away(point)
        still = [p for p in nearest_first if given_velocity(p, self.frame) == 0]
        for other in still:  # and what is placed from them without a velocity of its own
            still += [
                p
                for p in FrameTree.positions(other)
                if p not in still and self._is_beside(p, other)
            ]
        return still

    def _line(self, start: Point, end: Point) -> Vector | None:
        """Return the vector between two points, None where nobody said where they are.

        All steps between them are added up at once: one by one, as SymPy does, takes n² terms.
        """
        away = self.away(start)
        if end not in away:
            return None
        parts: dict[ReferenceFrame, list[Any]] = {}
        for step in steps_to(end, away):
            for part, frame in step.args:
                parts.setdefault(frame, []).append(part)
        sums = {f: [sm.Add(*row) for row in zip(*own, strict=True)] for f, own in parts.items()}
        return Vector([(sm.Matrix(row), frame) for frame, row in sums.items()])

    def _is_beside(self, point: Point, still: Point) -> bool:
        """Return whether a point without a velocity is at a constant place from one at rest."""
        return given_velocity(point, self.frame) is None and all(
            all(map(self._is_constant, parts)) and frame.ang_vel_in(self.frame) == 0
            for parts, frame in point.pos_from(still).args
        )

    # -- forces between two points ----------------------------------------------------------------

    def _radial(self, loads: Sequence[tuple[Any, Any]]) -> list[tuple[Any, Any]]:
        """Take forces along the lines between two points, or several; return the other loads."""
        rest: list[tuple[Any, Any]] = []
        opposite = _opposite([vector for _, vector in loads], self.turns)
        places_in_rest: list[int] = []
        for number, (where, vector) in enumerate(loads):
            partner = next((k for k, j in enumerate(places_in_rest) if opposite(number, j)), None)
            others = self.fixed(where) if isinstance(where, Point) else []
            if partner is not None and self._pair(where, rest[partner][0], vector):
                self.taken.append((sm.S.Zero, self._power(*rest.pop(partner))))
                places_in_rest.pop(partner)
            elif not any(self._pair(where, other, vector) for other in others):
                rest.append((where, vector))
                places_in_rest.append(number)
        opposites = [[opposite(i, j) for j in places_in_rest] for i in places_in_rest]
        return self._pathways(rest, opposites)

    def _pathways(
        self, loads: list[tuple[Any, Any]], opposites: Sequence[Sequence[bool]]
    ) -> list[tuple[Any, Any]]:
        """Take loads that pull equally in all segments of a pathway; return the others."""
        segments: list[tuple[int, int, Any, Any]] = []  # two loads, the force by its line, L²
        for j in range(len(loads)):
            used = {i for pair in segments for i in pair[:2]}
            for i in range(j):
                (one, _), (two, force) = loads[i], loads[j]
                points = isinstance(one, Point) and isinstance(two, Point)
                if points and opposites[j][i] and i not in used and one != two:
                    line = two.pos_from(one)
                    if (ratio := _ratio(force, line, self.turns)) is not None:
                        segments.append((i, j, ratio, line.dot(line)))
                        break
        tensions = [ratio * sm.sqrt(square) for _, _, ratio, square in segments]
        values = _numbers(tensions, self.turns) if tensions else np.zeros((1, 0))
        taken: set[int] = set()
        for k in range(len(segments)):
            alike = np.abs(values - values[:, [k]]) <= ROUNDED * np.abs(values[:, [k]])
            own = [segments[n] for n in np.flatnonzero(alike.all(axis=0))]
            if len(own) > 1 and taken.isdisjoint(ends := {i for pair in own for i in pair[:2]}):
                power = sm.Add(*(self._power(*loads[i]) for i in sorted(ends)))
                energy = self._of_length([pair[2:] for pair in own])
                if energy is not None and self._is_sound(energy, [power]):
                    self.taken.append((energy, power))
                    taken |= ends
        return [load for i, load in enumerate(loads) if i not in taken]

    def _of_length(self, segments: Sequence[tuple[Any, Any]]) -> Any:
        """Return the energy of a pull along segments, if it depends on the sum of their lengths."""
        lengths = {sm.Dummy("L", positive=True): square for _, square in segments}
        law, (first, *others) = segments[0][0], lengths
        for length, square in lengths.items():
            law = _in_terms_of(law, square, length, self.turns)
        energy = self._by_law(replace_symbols(law, dict.fromkeys(others, sm.S.Zero)), first)
        whole = sm.Add(*map(sm.sqrt, lengths.values()))
        return None if energy is None else replace_symbols(energy, {first: whole})

    def _pair(self, point: Any, other: Any, force: Vector) -> bool:
        """Take a force on `point` that pulls to or pushes from `other`, by their distance alone."""
        if not (isinstance(point, Point) and isinstance(other, Point)):
            return False
        if (line := self.line(other, point)) is None:
            return False
        if (ratio := _ratio(force, line, self.turns)) is None:
            return False
        square = line.dot(line)
        if self._is_constant(square):  # it does no work: both are points of one body, say
            self.taken.append((sm.S.Zero, self._power(point, force)))
            return True
        moving = [s for s in find_symbols([ratio, square]) if not self._is_constant(s)]
        # With quaternions gradients count along what keeps them of length one.
        if not (self.turns or may_depend_on(ratio, square, moving)):
            return False
        distance = sm.Dummy("L", positive=True)
        energy = self._by_law(_in_terms_of(ratio, square, distance, self.turns), distance)
        if energy is None:
            return False
        energy = replace_symbols(energy, {distance: sm.sqrt(square)})
        self.taken.append((energy, self._power(point, force)))
        return True

    def _by_law(self, ratio: Any, distance: Any) -> Any:
        """Return the energy of so many times the line between two points, None if unknown."""
        law = ratio * distance
        if not self._is_constant(law):  # a - b beside b - a, say
            law = sm.signsimp(law)
        return _integral(-law, distance) if self._is_constant(law) else None

    def _constant_load(self, where: Any, vector: Vector) -> bool:
        """Take a load all of whose terms are constant forces, by the mass there if that changes."""
        if (mass := self._changing_mass(where)) != 1 and vector.args:
            # Numbers that were multiplied are rounded: the share at one mass is that at others.
            at = dict.fromkeys((s for s in find_symbols([mass]) if not self._is_constant(s)), _MASS)
            share = replace_symbols(mass, at)
            own = vector.applyfunc(lambda e: sm.cancel(replace_symbols(e, at) / share))
            if not _opposite([vector, -mass * own], self.turns)(0, 1):
                return False
            vector = own
        whole = [part for parts, _ in vector.args for part in parts if part != 0]
        if not all(map(self._is_constant, whole)):
            return False
        before = len(self.taken)
        if all(self._constant_force(term, mass) for term in self._terms(where, vector)):
            return True
        del self.taken[before:]
        return False

    def _changing_mass(self, where: Any) -> Any:
        """Return the mass of a body there that depends on time or specifieds, else 1."""
        for mass in (sm.sympify(b.mass) for b in self.mechanism.bodies if b.masscenter is where):
            if not (self._is_constant(mass) or self.coordinates & {*find_symbols([mass])}):
                return mass
        return sm.S.One

    def _height(self, term: _Term) -> Any:
        """Return how far the point of a force is along its line, if that keeps its direction."""
        origins = self.fixed(term.where) if isinstance(term.where, Point) else []
        if not origins:
            return None
        direction = self.mechanism.components(term.direction, self.frame)
        if not all(self._is_constant(part) for part in direction):
            return None
        along = Vector([(direction, self.frame)])
        return self.mechanism.dot(self.line(origins[0], term.where), along)

    def _constant_force(self, term: _Term, mass: Any = sm.S.One) -> bool:
        height = self._height(term) if self._is_constant(term.size) else None
        if height is None:
            return False
        power = mass * self._power(term.where, term.vector)
        brought = term.size * height * mass.diff(self.equations.time)  # by what is added to a mass
        self.taken.append((-term.size * height * mass, power + brought))
        return True

    def _by_height(self, term: _Term) -> bool:
        """Take a force as of a floor: along a line, with a switch, by the height there alone."""
        height = self._height(term) if term.size.has(*_SWITCHED) else None
        if height is None:
            return False
        h = sm.Dummy("h", real=True)
        coordinates = [s for s in find_symbols([height]) if not s.is_Symbol]
        sums = {height, *term.size.atoms(sm.Add)} if coordinates else set()
        shares = {e: beside_constants(e, height, coordinates) for e in sums}
        named = {e: share[0] * h + share[1] for e, share in shares.items() if share is not None}
        law = term.size.xreplace(named)
        part = _primitive(law, h) if self._is_constant(law) else None
        if part is None:
            return False
        energy = replace_symbols(-part, {h: height})
        self.taken.append((energy, self._power(term.where, term.vector)))
        return True

    # -- closed forms -----------------------------------------------------------------------------

    def _closed(self, terms: list[_Term]) -> tuple[list[_Term], list[_Term]]:
        """Take integrable loads; return those without a position, and all that are unknown."""
        rest = self._integrable(terms)
        # A constant force may lack a place that would tell its potential.
        constant = [t for t in rest if isinstance(t.where, Point) and self._is_constant(t.size)]
        lost = [term for term in constant if not self.fixed(term.where)]
        others = [term for term in rest if term not in lost]
        return lost, [*lost, *(self._integrable(others) if len(others) < len(terms) else others)]

    def _integrable(self, terms: list[_Term]) -> list[_Term]:
        """Take loads whose work can be integrated; return the others.

        All of them together, as a spring between two bodies needs; else each alone.
        """
        if not terms:
            return []
        powers = tuple(self._power(t.where, t.vector) for t in terms)
        energy = self.antiderivative(powers)
        if energy is not None:
            self.taken.append((energy, sm.Add(*powers)))
            return []
        rest = []
        for term, power in zip(terms, powers, strict=True):
            if (energy := self.antiderivative((power,))) is None:
                rest.append(term)
            else:
                self.taken.append((energy, power))
        return rest

    def _along_one_rate(self, terms: list[_Term]) -> list[_Term]:
        """Take loads that do work along one coordinate, at any speeds; return the others.

        That is a load alone, or opposite torques on two frames, whose power is a force by the
        coordinate's rate: a spring or a stop of a joint.
        """
        opposite = _opposite([term.vector for term in terms], self.turns)
        numbers = range(len(terms))
        pairs = [[j, k] for k in numbers for j in range(k) if opposite(k, j)]
        left = set(numbers)
        for group in [*pairs, *([k] for k in numbers)]:
            if not left.issuperset(group):
                continue
            power = sm.Add(*(self._power(terms[k].where, terms[k].vector) for k in group))
            energy = self._along_rate(power)
            if energy is not None:
                self.taken.append((energy, power))
                left.difference_update(group)
        return [terms[k] for k in sorted(left)]

    def _along_rate(self, power: Any) -> Any:
        """Return minus the integral of a force times the rate of one coordinate, or None."""
        for c, u, slope in self._single:
            force = power.diff(u) / slope
            if force == 0 or not self._is_constant(force.xreplace({c: sm.S.One})):
                continue
            x = sm.Dummy(c.func.__name__, real=True)
            part = _primitive(replace_symbols(force, {c: x}), x)
            if part is not None:
                energy = replace_symbols(-part, {x: c})
                if self._is_sound(energy, [power]):
                    return energy
        return None

    def _is_sound(self, energy: Any, powers: Sequence[Any]) -> bool:
        try:
            return is_potential_of(self.equations, energy, powers)
        except UnsupportedFunctionError:
            return False

    @cached_property
    def _in_rates(self) -> tuple[dict[Any, Any], dict[Any, Any]]:
        """The speeds in symbols for the rates of coordinates, and the coordinate of each.

        Those are the speeds themselves, or Dummies where rates are constant combinations of them.
        """
        speeds, q_dot = self.equations.speeds, self.equations.kinematics.coordinate_derivatives
        rates = dict(zip(self.equations.coordinates, q_dot, strict=True))
        plain = {rate: c for c, rate in rates.items() if rate in speeds}
        mixed = find_symbols(rate for rate in rates.values() if rate not in speeds)
        own = [u for u in speeds if u in mixed]
        rows = {c: rate for c, rate in rates.items() if rate in own or rate not in speeds}
        if not own or len(own) != len(rows):
            return {}, plain
        slopes = sm.Matrix([[rate.diff(u) for u in own] for rate in rows.values()])
        rest = sm.Matrix(list(rows.values())) - slopes * sm.Matrix(own)
        linear = all(self._is_constant(c) for c in slopes) and not any(map(sm.expand, rest))
        if not linear or slopes.det() == 0:
            return {}, plain
        found = {sm.Dummy(str(c)): c for c in rows}
        in_rates = dict(zip(own, slopes.LUsolve(sm.Matrix(list(found))), strict=True))
        return in_rates, {**{u: c for u, c in plain.items() if u not in own}, **found}

    @cached_property
    def _single(self) -> list[tuple[Any, Any, Any]]:
        """Coordinates with a speed and the constant factor of that speed in their rate."""
        found = []
        rates = self.equations.kinematics.coordinate_derivatives
        for c, rate in zip(self.equations.coordinates, rates, strict=True):
            slopes = ((u, rate.diff(u)) for u in self.equations.speeds)
            found += [(c, u, slope) for u, slope in slopes if slope.is_number and slope][:1]
        return found

    def _antiderivative(self, powers: tuple[Any, ...]) -> Any:
        """Return minus the integral of the work, one coordinate after the other, or None."""
        in_rates, speed = self._in_rates
        if not speed:
            return None
        in_speeds = [replace_symbols(power, in_rates) for power in powers]
        # Sums that are multiplied out are alike where they are equal; quotients need not be.
        plain = not any(map(has_quotients, in_speeds))
        forces = forces_of_power(in_speeds, speed) if plain else None
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

    def _integrated(self, forces: dict[Any, Any], powers: Sequence[Any]) -> Any:
        """Return minus the integral of forces along coordinates, one after the other, or None."""
        real = {c: sm.Dummy(c.func.__name__, real=True) for c in self.equations.coordinates}
        parts: list[Any] = []
        holding: dict[Any, list[Any]] = {}  # the parts that depend on a coordinate
        done: set[Any] = set()
        for c, force in forces.items():
            x = real[c]
            before = (part.diff(x) for part in holding.get(x, ()))
            rest = sm.expand(sm.Add(replace_symbols(force, real), *before))
            if rest.free_symbols & done:  # the work depends on the path, as far as can be seen
                return None
            if (part := _primitive(rest, x)) is None:
                return None
            parts.append(-part)
            for symbol in part.free_symbols:
                holding.setdefault(symbol, []).append(-part)
            done.add(x)
        left = {*real.values()} - done
        exact = left.isdisjoint(holding) and all(
            part.is_polynomial(*(part.free_symbols & done)) for part in parts
        )
        energy = replace_symbols(sm.Add(*parts), {x: c for c, x in real.items()})
        return energy if exact or self._is_sound(energy, powers) else None


def _primitive(force: Any, x: Any) -> Any:
    """Return a continuous integral over x, or None where SymPy finds none."""
    if force.has(*_SWITCHED):
        force = sm.piecewise_fold(force.rewrite(sm.Piecewise))
    try:
        found = sm.integrate(force, x, manual=True)
    except (NotImplementedError, ValueError, TypeError, AttributeError, RecursionError):
        return None  # what SymPy raises for intervals that it cannot sort
    if found.has(sm.Integral, sm.I, sm.S.NaN):
        return None
    return _of_either_sign(found)


def _of_either_sign(energy: Any) -> Any:
    """Return an integral whose logarithms allow arguments of either sign."""
    return energy.replace(sm.log, lambda e: sm.log(e if e.is_positive else sm.Abs(e)))


def _numbers(expressions: Sequence[Any], turns: Iterable[Any]) -> np.ndarray:
    """Return the values of expressions at random states and constants, one row for each draw.

    There the matrices `turns`, of quaternions, are rotations: lengths are none elsewhere. States
    beyond what the expressions switch at follow.
    """
    graph = Graph()
    read = InputReader(graph, {}, ())
    nodes, held = read.all(expressions), orthogonality_residuals(turns, read)
    rows = [numbers_of(graph, nodes, held)]
    for switch in Branches(graph, nodes).switches():
        before = numbers_of(graph, [switch], held)[0, 0]
        for share in _BEYOND:
            row = graph.sum([(switch, 1.0)], -share * before)
            found = numbers_of(graph, [*nodes, switch], [*held, row])
            beyond = np.isfinite(found).all(axis=1) & (found[:, -1] * before < 0.0)
            rows.append(found[beyond, :-1])
    return np.vstack(rows)


def _opposite(vectors: Sequence[Vector], turns: Iterable[Any]) -> Callable[[int, int], bool]:
    """Return a function that tells whether two of the vectors are opposite, up to rounding.

    A law times a vector of decimals is rounded in other ways than its opposite.
    """
    parts = [{(f, i): part for row, f in v.args for i, part in enumerate(row)} for v in vectors]
    places = list(dict.fromkeys(place for own in parts for place in own))
    rows = [[own.get(place, sm.S.Zero) for place in places] for own in parts]
    values = np.zeros((1, len(vectors), 1))
    if len(vectors) > 1:
        with suppress(UnsupportedFunctionError):
            values = _numbers([part for row in rows for part in row], turns)
            values = values.reshape(-1, len(vectors), len(places))
    sizes = np.abs(values).max(axis=2)

    def opposite(i: int, j: int) -> bool:
        if not sizes[:, i].any():  # what is zero there may be so there only
            return bool(vectors[i] != 0 and vectors[i] + vectors[j] == 0)
        left = np.abs(values[:, i] + values[:, j]).max(axis=1)
        return bool((left <= ROUNDED * sizes[:, i]).all())

    return opposite


def _ratio(force: Vector, line: Vector, turns: Iterable[Any]) -> Any:
    """Return s of ``force = s · line``, or None when it cannot be seen.

    Numbers are compared: places given in decimals are rounded, and forces by other ways.
    """
    along = {(f, i): part for parts, f in line.args for i, part in enumerate(parts)}
    pulls = {(f, i): part for parts, f in force.args for i, part in enumerate(parts)}
    places = list(along | pulls)
    pairs = [(pulls.get(p, sm.S.Zero), along.get(p, sm.S.Zero)) for p in places]
    values = _numbers([part for pair in pairs for part in pair], turns).reshape(-1, len(pairs), 2)
    pull, way = values[..., 0], values[..., 1]
    largest = int(np.abs(way[0]).argmax())
    if not (np.isfinite(values).all() and way[:, largest].all() and pull.any()):
        return None  # what is zero there may be so there only
    found = pull[:, [largest]] / way[:, [largest]]
    # The potential as a whole is compared with the loads' power in the end.
    if (np.abs(pull - found * way) > ROUNDED * np.abs(pull).max(axis=1, keepdims=True)).any():
        return None
    f, r = pairs[largest]
    return f / r


def _in_terms_of(expression: Any, square: Any, distance: Any, turns: Iterable[Any]) -> Any:
    """Write an expression in terms of a distance: so many times its square are written by it."""
    moving = find_symbols([square])
    sums = {square, *(p.base for p in expression.atoms(sm.Pow)), *expression.atoms(sm.Add)}
    bases = [e for e in sums if find_symbols([e]) == moving]
    values = _numbers([square, *bases], turns)
    shares = values[:, 1:] / values[:, :1]
    alike = np.abs(shares - shares[0]).max(axis=0) <= ROUNDED * np.abs(shares[0])
    named = {
        base: (1 if abs(share - 1.0) <= ROUNDED else sm.Float(share)) * distance**2
        for base, share, same in zip(bases, shares[0], alike, strict=True)
        if same
    }

    def is_power(e: Any) -> bool:
        return bool(e in named or (e.is_Pow and e.base in named))

    def written(expression: Any) -> Any:
        return expression.replace(
            is_power,
            lambda e: named[e] if e in named else sm.powdenest(named[e.base] ** e.exp, force=True),
        )

    found = written(expression)
    coordinates = [s for s in moving if not s.is_Symbol]
    if coordinates and found.has(*coordinates):
        for e in found.atoms(sm.Add):
            softened = beside_constants(e, square, coordinates)
            if softened is not None:
                named[e] = softened[0] * distance**2 + softened[1]
        found = written(found)
    return found


def _integral(law: Any, distance: Any) -> Any:
    """Integrate a law over the distance; None where SymPy finds no elementary function."""
    if (powers := _integral_of_powers(law, distance)) is not None:
        return powers
    found = sm.S.NaN
    if not law.has(*_SWITCHED):
        with suppress(NotImplementedError, ValueError, TypeError, AttributeError, RecursionError):
            found = sm.integrate(law, distance, risch=True)
    if found.has(sm.Integral, sm.S.NaN):
        # Many laws are functions of the square, which SymPy integrates sooner.
        square = sm.Dummy("S", positive=True)
        by_square = replace_symbols(law / distance, {distance: sm.sqrt(square)}) / 2
        odd = any(p.base == square and not p.exp.is_Integer for p in by_square.atoms(sm.Pow))
        found = _primitive(*((law, distance) if odd else (by_square, square)))
        found = None if found is None else replace_symbols(found, {square: distance**2})
    if found is None:
        return None
    found = _of_either_sign(found)
    try:
        _numbers([found], ())
    except UnsupportedFunctionError:  # an exponential integral, say
        return None
    return found


def _integral_of_powers(law: Any, distance: Any) -> Any:
    """Integrate a sum of powers of the distance; None for anything else."""
    parts = []
    for term in sm.Add.make_args(sm.expand(law)):
        size, power = term.as_independent(distance, as_Add=False)
        _, exponent = power.as_base_exp() if power != 1 else (distance, sm.S.Zero)
        if power not in (1, distance**exponent) or not exponent.is_number:
            return None
        if exponent == -1:
            parts.append(size * sm.log(distance))
        else:
            parts.append(size * distance ** (exponent + 1) / (exponent + 1))
    return sm.Add(*parts)


# -- by numbers ------------------------------------------------------------------------------------


def is_potential_of(equations: Equations, potential: Any, powers: Sequence[Any]) -> bool:
    """Return whether ``d potential/dt = -sum(powers)``, on both sides of every switch."""
    states = GenericStates(equations, (potential, *powers), "the energy")
    energy, lost = states.read(potential), states.read.all(powers)
    sums = [[*states.rates([energy]), *lost]]
    blocks = [_with_bounds(states, sums), ("lost", (len(lost),), lost)]
    # The rate may be finite where the energy is not: that of atan(x/√-l) holds no root.
    generic = list(states.samples([*blocks, ("energy", (), [energy])], _TRIALS))
    samples = [*generic]
    turned = Branches(states.graph, [energy, *lost]).switches()
    # An integral of |sin(q)|, say, may hold for some turns alone.
    for far in _FAR if turned else ():
        near = dict.fromkeys(equations.coordinates, far)
        samples += states.kept(blocks, _TRIALS, near=near)
    for switch in turned:
        beyond = list(_beyond(states, switch, blocks))
        if beyond and _jumps(states, switch, energy):
            return False
        samples += beyond
    if not (generic and all(_small(sample["pairs"], sums) for sample in samples)):
        return False
    # What acts on one side only, and at none of the states, has an energy that tells of sides.
    acting = np.any([sample["lost"] for sample in samples], axis=0).tolist()
    idle = [n for n, acts in zip(lost, acting, strict=True) if not acts]
    return not Branches(states.graph, idle).switches() or bool(
        Branches(states.graph, [energy]).switches()
    )


def has_momenta_of(equations: Equations, lagrangian: Any, kinetic: Any) -> bool:
    """Return whether a Lagrangian and a kinetic energy have the same derivatives by the speeds."""
    states = GenericStates(equations, (lagrangian, kinetic), "the energy")
    nodes = states.read.all((lagrangian, kinetic))
    shape = 2, len(states.speeds)
    momenta = np.reshape(jacobian(states.graph, nodes, states.speeds).flat(), shape).tolist()
    sums = [[a, states.graph.neg(b)] for a, b in zip(*momenta, strict=True)]
    samples = list(states.samples([_with_bounds(states, sums)], _TRIALS))
    return bool(samples) and all(_small(sample["pairs"], sums) for sample in samples)


def _with_bounds(states: GenericStates, sums: Sequence[Sequence[int]]) -> Block:
    """Return the block of the terms of sums, with their bounds of rounding below.

    They are added up later, since the graph joins numbers: what it leaves of √2 less √2 is a term
    of its own, of which nothing tells that it was rounding.
    """
    terms = [node for own in sums for node in own]
    return "pairs", (2, len(terms)), [*terms, *rounding_bounds(states.graph, terms)]


def _small(pairs: np.ndarray, sums: Sequence[Sequence[int]]) -> bool:
    starts = np.cumsum([0, *map(len, sums[:-1])])
    left, bound = np.add.reduceat(pairs, starts, axis=1)
    return bool((np.abs(left) <= ROUNDED * bound).all())


def _jumps(states: GenericStates, switch: int, energy: int) -> bool:
    """Return whether an energy jumps at a switch."""
    above, below = Branches(states.graph, [energy]).sides(switch)
    step = states.graph.sub(*above, *below)
    block = [("step", (1,), [step])]
    samples = list(states.where(switch, block, _TRIALS))
    if not samples:  # it has no value there, but may tend to one
        near = [list(_beyond(states, switch, block, (share,))) for share in NEAR]
        one, other = (np.median([abs(s["step"][0]) for s in some] or [0.0]) for some in near)
        return bool(abs(other - one) < NEAR[0] ** 0.5 * one)
    steps = np.array([sample["step"] for sample in samples])
    return bool((np.abs(steps) > states.uncertain(samples, [step])).any())


def _beyond(
    states: GenericStates, switch: int, blocks: Sequence[Block], shares: Sequence[float] = _BEYOND
) -> Iterator[dict[str, np.ndarray]]:
    """Yield values at states that keep the constraints, beyond a switch of generic ones."""
    graph = states.graph
    if set(states.coordinates).isdisjoint(graph.reachable([switch])):
        return
    sizes = [float(s["switch"][0]) for s in states.samples([("switch", (1,), [switch])], 1)]
    for target in (size * share for size in sizes for share in shares):
        yield from states.where(graph.sum([(switch, 1.0)], -target), blocks, _TRIALS)
