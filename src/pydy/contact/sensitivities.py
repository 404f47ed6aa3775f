"""Derivatives of a motion with contacts by parameters, through its transitions.

Within a mode the columns S = ∂x/∂θ are integrated beside the state. A transition at the time τ(θ)
turns the state x into R(x, t, θ), which an impact changes and which held rows are projected on:

    D = S + f dτ/dθ,    S⁺ = R_x D + R_t dτ/dθ + R_θ − f⁺ dτ/dθ,

with the derivatives f of the states before it and f⁺ after it. The impulses p of an impact follow
from the equations of its modes by the implicit function theorem.

References
----------
M. di Bernardo et al., Piecewise-smooth Dynamical Systems, Springer, 2008, section 2.5.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from pydy._forks import cached_property
from pydy._graph import directional
from pydy._integration import AugmentedSystem, SensitivityRequest, simulate
from pydy._motion import Motion, Segment
from pydy._names import column_names
from pydy._problem import Problem
from pydy._rank import DEPENDENT, ROUNDING
from pydy.contact.decide import CLOSED, OPEN, SLIDES, STARTING, STICKS
from pydy.contact.impacts import Blow, Phase
from pydy.contact.modes import Mode
from pydy.contact.rows import ContactRows, Numbers, by_name
from pydy.contact.trajectory import SegmentedSensitivities
from pydy.contact.tuning import SLACK, WITHIN
from pydy.trajectory import EventRecord

_SLOPES = ("gap", "speed", "square", "moves", "restitution", "mu", "free")


class Transitions:
    """Derivatives of the state at transitions, by columns.

    `total` (n, k) is D, the derivatives of the state where the motion is, at the time that moves;
    `time` (k,) has those of that time. Columns are by the `constants`, or, where that is None, by
    what no transition holds.
    """

    def __init__(
        self, rows: ContactRows, now: Problem, constants: Sequence[Any], total: np.ndarray
    ) -> None:
        self.rows, self.now, self._constants = rows, now, constants
        self._first = len(rows.equations.coordinates)  # the place of the first speed
        self.total = total
        self.time = np.zeros(len(constants))
        self.doubtful = np.zeros(len(constants), dtype=bool)  # whose time is not known
        # By contact: how far roundings of the impulses' derivatives may have moved the gap since.
        self.blurred = np.zeros((len(rows.contacts), len(constants)))

    @cached_property
    def _slopes(self) -> Any:
        """The differentiated blocks, their evaluator, and the columns of inputs' directions."""
        rows = self.rows
        parts = {name: rows.parts[name] for name in _SLOPES}
        nodes = [n for _, own in parts.values() for n in own]
        g = rows.graph.copy()
        moving = {*self.now.definition.states, self.now.definition.equations.time}
        moving.update(symbol for symbol in self._constants if symbol is not None)
        places = {node: s for node, s in rows.symbols.items() if s in moving}
        if "r" in g.inputs_of(nodes[: -len(rows.speeds)]):  # but for accelerations
            raise NotImplementedError(
                "`sensitivities` of contacts that depend on specifieds are not supported yet. "
                "Write a prescribed motion as an expression of time."
            )
        along = {node: g.input("along", k) for k, node in enumerate(places)}
        slopes = directional(g, nodes, {node: {0: unit} for node, unit in along.items()})
        found = g.evaluator([row.get(0, g.zero) for row in slopes])
        return parts, found, {along[node]: symbol for node, symbol in places.items()}

    def slopes(self, values: Mapping[Any, float]) -> dict[str, np.ndarray]:
        """Return derivatives of `Numbers` along D by k parameters, given a number for each symbol.

        The last axis is that of the parameters; accelerations are those without contact forces.
        """
        parts, evaluate, directions = self._slopes
        states = list(self.now.definition.states)
        inputs: dict[int, Any] = {
            node: values.get(symbol, 0.0) for node, symbol in self.rows.symbols.items()
        }
        for node, symbol in directions.items():
            if symbol in self.now.definition.states:
                inputs[node] = self.total[states.index(symbol)]
            elif symbol in self._constants:
                inputs[node] = np.eye(len(self.time))[self._constants.index(symbol)]
            else:
                inputs[node] = self.time
        return by_name(parts, evaluate(inputs, len(self.time)).T)

    # -- what transitions do ----------------------------------------------------------------------

    def ends(self, before: np.ndarray, time: np.ndarray, rates: np.ndarray) -> None:
        """Take S before the event that ends a mode, and the derivatives of its time.

        These are NaN where they are not known.
        """
        self.doubtful = np.isnan(time)
        self.time = np.where(self.doubtful, 0.0, time)
        self.total = before + np.outer(rates, self.time)

    def starts(self, rates: np.ndarray, slides: bool) -> np.ndarray:
        """Return S⁺ of the mode that begins, in which something that was at rest `slides` or not.

        Where it is held, what follows from the time of a stop is taken out.
        """
        if slides and self.doubtful.any():
            raise NotImplementedError(
                "`sensitivities` where a body comes to rest in a plane after a slide that curves, "
                "and slides on, are not known. Simulate without `sensitivities`."
            )
        return self.total - np.outer(rates, self.time)

    def begun(self, start: float, given: np.ndarray, records: list[EventRecord]) -> None:
        """Keep S⁺ of a mode that lasts no time, as it begins at the last."""

    def opened(self, i: int, slopes: np.ndarray, p: Numbers, share: float) -> np.ndarray:
        """Return whether the gap of a contact that closes opens by each column.

        A `share` of their terms may be missing of its `slopes` at the time that moves.
        """
        terms = np.abs(p.gradient[i]) @ np.abs(self.total[: self._first])
        terms += np.abs(p.speed[self.rows.normal[i]] * self.time)
        wrong: np.ndarray = ~(np.abs(slopes) <= share * terms + self.blurred[i])
        return wrong

    def impact(
        self,
        values: Mapping[Any, float],
        p: Numbers,
        found: Blow,
        kept: Mapping[int, float],
        still: Collection[int],
    ) -> dict[str, np.ndarray]:
        """Apply the derivatives of an impact; return the rows' derivatives before it.

        The `values` are numbers before it. By Newton's hypothesis, `kept` is the restitution of
        each contact that closes, zero where it rests; those that are `still` touched before it.
        """
        d = self.slopes(values)
        # Velocities before impulses; normal ones are those of them that impulses take away.
        moved = d["speed"].copy()
        for i, normal in enumerate(self.rows.normal):
            if normal is None:
                continue
            if i in kept:
                more = d["restitution"][i] if kept[i] > 0.0 else 0.0
                moved[normal] = d["speed"][normal] * (1.0 + kept[i]) + p.speed[normal] * more
            elif i in still:
                moved[normal] = 0.0
        total = np.zeros_like(moved)  # of the impulses
        for phase in found.phases:
            impulses, slopes = phase.forces.copy(), np.zeros_like(moved)
            given = np.zeros((len(phase.given), len(self.time)))
            for i in np.flatnonzero(phase.given).tolist():  # e Λ_C, where e is not zero
                e, normal = p.restitution[i], self.rows.normal[i]
                given[i] = d["restitution"][i] * phase.given[i] / e + e * total[normal]
                impulses[normal] += phase.given[i]
                slopes[normal] = given[i]
            moved = moved + np.einsum("ijk,j->ik", d["square"], impulses) + p.square @ slopes
            own = self._impulses(d, p, phase, given, moved)
            moved = moved + p.square @ own
            total = total + slopes + own
        # Entries of J M⁻¹ Jᵀ that should be zero are rounded as √(A_ii A_jj).
        root = np.sqrt(np.abs(p.square.diagonal()))
        span = WITHIN * ROUNDING * float(np.ptp(self.now.settings.times))
        for i, normal in enumerate(self.rows.normal):
            if normal is not None:
                self.blurred[i] += span * root[normal] * (root @ np.abs(total))
        change = np.einsum("ijk,j->ik", d["moves"], found.forces) + p.moves @ total
        self.total = self.total.copy()
        self.total[self._first : self._first + len(change)] += change
        return d

    def _impulses(
        self,
        d: Mapping[str, np.ndarray],
        p: Numbers,
        phase: Phase,
        given: np.ndarray,
        moved: np.ndarray,
    ) -> np.ndarray:
        """Return the derivatives of a phase's impulses in addition to those `given`.

        What is `moved` are velocities after it but for what these derivatives add.
        """
        f = phase.forces
        matrix, right = np.eye(len(f)), np.zeros_like(moved)
        told: set[int] = set()  # rows whose velocities are given; of the others impulses are
        for i, mode in enumerate(phase.modes):
            normal, tangent = self.rows.normal[i], list(self.rows.tangent[i])
            if mode == OPEN or normal is None:
                continue
            held = [] if i in phase.leaves else [normal]
            held += tangent if mode in (STICKS, CLOSED) else ()
            matrix[held], right[held] = p.square[held], -moved[held]
            told.update(held)
            if mode not in SLIDES:
                continue
            if mode != STARTING:
                unit, turning = np.array([SLIDES[mode]]), np.zeros((1, 1))
            else:
                after = phase.rates[tangent]
                unit = after / np.linalg.norm(after)
                turning = (np.eye(2) - np.outer(unit, unit)) / np.linalg.norm(after)
            press = phase.given[i] + f[normal]
            push = p.mu[i] * press
            matrix[tangent, normal] += p.mu[i] * unit
            matrix[tangent] += push * turning @ p.square[tangent]
            right[tangent] = (
                -np.outer(unit, d["mu"][i] * press + p.mu[i] * given[i])
                - push * turning @ moved[tangent]
            )
        for row in {*range(len(f))} - told:
            matrix[row] *= p.square[row, row]
            right[row] *= p.square[row, row]
        return _least(matrix, right, p.square.diagonal())

    def project(self, values: Mapping[Any, float], p: Numbers, held: Sequence[int]) -> None:
        """Project D onto the directions that active rows leave free."""
        owners, first = self.rows.owners_of(held), self._first
        normals = list(owners)
        self.total = self.total.copy()
        if normals:
            rest = self.slopes(values)["gap"][list(owners.values())]
            square = p.square[np.ix_(normals, normals)]
            shares = _least(square, -rest, square.diagonal())
            self.total[:first] += p.kinematics @ (p.moves[:, normals] @ shares)
        if held:
            rest = self.slopes(values)["speed"][list(held)]
            square = p.square[np.ix_(held, held)]
            shares = _least(square, -rest, square.diagonal())
            self.total[first : first + len(p.moves)] += p.moves[:, list(held)] @ shares


class HybridSensitivities(Transitions):
    """Sensitivities that are carried from mode to mode.

    `counts` has the number of columns of each parameter. Where `controlled`, the step control looks
    at them too.
    """

    def __init__(self, wanted: Any, controlled: bool, rows: ContactRows, now: Problem) -> None:
        self.sensitive = sensitive = AugmentedSystem.of(now, now.model.code, now.plan, wanted)
        parameters = sensitive.parameters
        every = [p for p in parameters for _ in range(p.count)]
        constants = [p.symbol if p.kind == "constants" else None for p in every]
        super().__init__(rows, now, constants, sensitive.start(now.x, float(now.settings.times[0])))
        self._controlled = controlled
        self._counts = {p.symbol: p.count for p in parameters}
        self._before: np.ndarray | None = None  # the last event; None if there was none
        self._columns = np.full((len(now.settings.times), *self.total.shape), np.nan)

    def simulate(
        self, mode: Mode, given: np.ndarray, now: Problem, solver: Any, options: dict[str, Any]
    ) -> Motion:
        """Simulate in one mode, with S at the start `given`."""
        self._columns[self.now.settings.times == now.settings.times[0]] = given
        controlled = self._controlled or mode.turns
        wanted = SensitivityRequest([*self._counts], controlled, given, mode.untimed)
        return simulate(now, now.settings.times, solver=solver, sensitivities=wanted, **options)

    def begun(self, start: float, given: np.ndarray, records: list[EventRecord]) -> None:
        """Keep S⁺ of a mode that lasts no time, as it begins at the last."""
        self._columns[self.now.settings.times == start] = given
        self._note(start, given, records)

    def _note(self, start: float, given: np.ndarray, records: list[EventRecord]) -> None:
        """Note S⁺ in the records of the transition that led to it."""
        told: dict[str, Any] = {
            "time_sensitivity": np.where(self.doubtful, np.nan, self.time),
            "sensitivity_before": self._before,
            "sensitivity_after": given,
        }
        for k, record in enumerate(records):
            if record.time == start and record.time_sensitivity is None:
                records[k] = replace(record, **told)

    def took(self, motion: Motion, end: float, records: list[EventRecord]) -> None:
        """Store the sensitivities of a segment."""
        start, values = motion.times[0], motion.sensitivities
        assert values is not None
        self._note(start, values[0], records)
        rows = (self.now.settings.times > start) & (self.now.settings.times <= end)
        self._columns[rows] = values[1 : 1 + int(rows.sum())]

    def ended(self, record: EventRecord, rates: np.ndarray) -> None:
        """Take the derivatives at the event that ends a mode."""
        assert record.sensitivity_before is not None
        assert record.time_sensitivity is not None
        self._before = record.sensitivity_before
        self.ends(self._before, record.time_sensitivity, rates)

    def doubt(self, values: Mapping[Any, float], rows: Sequence[int]) -> None:
        """Tell of which parameters the time of a stop in a plane is not known.

        Both sliding speeds are zero there, for all parameters. One of them gives the time; where
        the other contradicts it, friction turned the velocity too quickly at the end. What follows
        does not depend on it: the rows that are held take out what it adds.
        """
        rest = self.slopes(values)["speed"][rows]
        total, time = self.total, self.time
        assert self._before is not None
        self.total, self.time = self._before, np.zeros(len(time))
        size = np.linalg.norm(self.slopes(values)["speed"][rows], axis=0)
        self.total, self.time = total, time
        self.doubtful |= ~(np.linalg.norm(rest, axis=0) <= SLACK * size)

    def apart(self, i: int, slopes: np.ndarray, p: Numbers, share: float) -> list[str]:
        """Return by which parameters the gap of a contact that closes opens."""
        wrong = self.opened(i, slopes, p, share)
        return [name for name, off in zip(column_names(self._counts), wrong, strict=True) if off]

    def results(self, reached: np.ndarray) -> np.ndarray:
        """Return the sensitivities at the times that were reached, shape (m, n, k)."""
        found: np.ndarray = self._columns[reached]
        return found

    def labels(self, values: Any, segments: Sequence[Segment]) -> dict[str, Any]:
        """Return the trajectory's arguments for its sensitivities (m, n, k)."""
        model = SegmentedSensitivities(segments)
        return {"sensitivities": (self._counts, values), "sensitivity_model": model}


def _least(matrix: np.ndarray, right: np.ndarray, square: np.ndarray) -> np.ndarray:
    """Solve for the least unknowns: rows of several feet may hold the same thing.

    Rows and unknowns are measured by what a unit of each force does to its own row, so that ranks
    are those of the mechanism in any units.
    """
    size = np.sqrt(np.where(square > 0.0, square, 1.0))
    scaled = matrix / np.outer(size, size)
    found: np.ndarray = np.linalg.lstsq(scaled, right / size[:, None], rcond=DEPENDENT)[0]
    return found / size[:, None]
