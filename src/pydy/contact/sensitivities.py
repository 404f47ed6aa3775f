"""Derivatives of a motion with contacts by parameters, through its transitions.

Within a mode the columns S = ∂x/∂θ are integrated together with the state. A transition at the time
τ(θ) maps the state x to R(x, t, θ), by an impact and by projection onto the active rows:

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
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._forks import cached_property
from pydy._graph import directional, inputs_of
from pydy._integration import (
    AugmentedSystem,
    InitialSensitivities,
    SensitivityRequest,
    simulate,
)
from pydy._motion import Motion, Segment
from pydy._names import column_names
from pydy._problem import Problem
from pydy._rank import DEPENDENT, ROUNDING
from pydy.contact.complementarity import CLOSED, OPEN, SLIDES, STARTING, STICKS
from pydy.contact.impacts import ImpactResult, Phase
from pydy.contact.modes import Mode
from pydy.contact.rows import ContactRows, RowValues, by_name
from pydy.contact.trajectory import SegmentedSensitivities
from pydy.contact.tuning import ROUNDING_MARGIN, SLACK
from pydy.trajectory import EventRecord

if TYPE_CHECKING:
    from pydy._program import Evaluator
    from pydy._sympy_types import AnySymbol
    from pydy.contact.rows import Parts
    from pydy.solvers import Solver

_SLOPES = ("gap", "speed", "delassus", "response", "restitution", "mu", "free")


class Transitions:
    """Derivatives of the state at transitions, as columns.

    `total` (n, k) is D, the derivatives of the state at the time of the transition, which depends
    on the parameters; `time` (k,) has the derivatives of that time. Each column belongs to one of
    the `constants`, or, where that is None, to a parameter that no transition depends on.
    """

    def __init__(
        self,
        rows: ContactRows,
        problem: Problem,
        constants: Sequence[AnySymbol | None],
        total: np.ndarray,
    ) -> None:
        self.rows, self.problem, self._constants = rows, problem, constants
        self._first = len(rows.equations.coordinates)  # the column of the first speed
        self.total = total
        self.time = np.zeros(len(constants))
        self.doubtful = np.zeros(len(constants), dtype=bool)  # columns whose `time` is unknown
        # Columns of a slide that ended at its `rest_speed`, where it had turned to the side.
        self.turned = np.zeros(len(constants), dtype=bool)
        self.rest_speeds: dict[int, float] = {}
        # By contact: bounds on the effect of rounding of impulse derivatives on its gap.
        self.blurred = np.zeros((len(rows.contacts), len(constants)))

    @cached_property
    def _slopes(self) -> tuple[Parts, Evaluator, dict[int, AnySymbol]]:
        """The differentiated blocks, their evaluator, and the symbol of each seed."""
        rows = self.rows
        parts = {name: rows.parts[name] for name in _SLOPES}
        nodes = [n for _, nodes_of_part in parts.values() for n in nodes_of_part]
        g = rows.graph.copy()
        moving = {*self.problem.definition.states, self.problem.definition.equations.time}
        moving.update(symbol for symbol in self._constants if symbol is not None)
        moving_symbols = {node: s for node, s in rows.symbols.items() if s in moving}
        if "r" in inputs_of(g, nodes[: -len(rows.speeds)]).groups:  # except accelerations
            raise NotImplementedError(
                "`sensitivities` of contacts that depend on specifieds are not supported yet. "
                "Write a prescribed motion as an expression of time."
            )
        seeds = {node: g.input("along", k) for k, node in enumerate(moving_symbols)}
        slopes = directional(g, nodes, {node: {0: unit} for node, unit in seeds.items()})
        evaluator = g.evaluator([row.get(0, g.zero) for row in slopes])
        return parts, evaluator, {seeds[node]: symbol for node, symbol in moving_symbols.items()}

    def slopes(self, values: Mapping[AnySymbol, float]) -> dict[str, np.ndarray]:
        """Return derivatives of `RowValues` along D by k parameters, from the values by symbol.

        The last axis is that of the parameters; accelerations are those without contact forces.
        """
        parts, evaluate, directions = self._slopes
        states = list(self.problem.definition.states)
        inputs: dict[int, np.ndarray | float] = {
            node: values.get(symbol, 0.0) for node, symbol in self.rows.symbols.items()
        }
        for node, symbol in directions.items():
            if symbol in self.problem.definition.states:
                inputs[node] = self.total[states.index(symbol)]
            elif symbol in self._constants:
                inputs[node] = np.eye(len(self.time))[self._constants.index(symbol)]
            else:
                inputs[node] = self.time
        return by_name(parts, evaluate(inputs, len(self.time)).T)

    # -- effects of transitions -------------------------------------------------------------------

    def rest_speed(self, i: int, speed: np.ndarray, tolerance: float, rounding: float) -> float:
        """Return the sliding speed at which a slide in a plane ends, 0 for where it vanishes.

        Friction μ N turns derivatives of the velocity v towards it at the rate μ N/(m |v|), so that
        no step leads to v = 0 where the direction of v depends on a parameter. At the solver's
        `tolerance` they have turned; projection onto the rows of sticking does the rest.
        """
        rest = max(tolerance, rounding)
        self.rest_speeds[i] = rest if np.linalg.norm(speed) > rest else 0.0
        return self.rest_speeds[i]

    def end_mode(self, before: np.ndarray, time: np.ndarray, rates: np.ndarray) -> None:
        """Set D from S before the event that ends a mode, and the derivatives of its time.

        The latter are NaN where they are unknown.
        """
        self.doubtful, self.turned = np.isnan(time), np.zeros(len(time), dtype=bool)
        self.time = np.where(self.doubtful, 0.0, time)
        self.total = before + np.outer(rates, self.time)

    def begin_mode(self, rates: np.ndarray, slides: bool) -> np.ndarray:
        """Return S⁺ of the next mode; `slides`: a contact at rest slides in it.

        If it sticks, projection removes the effect of the time of the stop.
        """
        if slides and (self.doubtful | self.turned).any():
            raise NotImplementedError(
                "`sensitivities` where a body comes to rest in a plane after a slide that curves, "
                "and slides on, are not known. Simulate without `sensitivities`."
            )
        return self.total - np.outer(rates, self.time)

    def store_instant(self, start: float, values: np.ndarray, records: list[EventRecord]) -> None:
        """Keep S⁺ of a mode that lasts no time, as it begins at the last."""

    def gap_opens(self, i: int, slopes: np.ndarray, p: RowValues, share: float) -> np.ndarray:
        """Return for each column whether it moves the gap of a closing contact away from zero.

        The `slopes` of the gap may have errors of a `share` of their terms.
        """
        terms = np.abs(p.gradient[i]) @ np.abs(self.total[: self._first])
        terms += np.abs(p.speed[self.rows.normal[i]] * self.time)
        wrong: np.ndarray = ~(np.abs(slopes) <= share * terms + self.blurred[i])
        return wrong

    def impact(
        self,
        values: Mapping[AnySymbol, float],
        p: RowValues,
        result: ImpactResult,
        rebound_ratios: Mapping[int, float],
        closed_before: Collection[int],
    ) -> dict[str, np.ndarray]:
        """Apply the derivatives of an impact; return the rows' derivatives before it.

        The `values` are those before it. By Newton's hypothesis, `rebound_ratios` has the
        restitution of each contact that closes, zero where it rests; those in `closed_before`
        were closed before it.
        """
        d = self.slopes(values)
        # Velocities before the impact; of normal ones, the change that the impulses must cause.
        velocities = d["speed"].copy()
        for i, normal in enumerate(self.rows.normal):
            if normal is None:
                continue
            if i in rebound_ratios:
                ratio_slope = d["restitution"][i] if rebound_ratios[i] > 0.0 else 0.0
                velocities[normal] = (
                    d["speed"][normal] * (1.0 + rebound_ratios[i]) + p.speed[normal] * ratio_slope
                )
            elif i in closed_before:
                velocities[normal] = 0.0
        impulse_slopes = np.zeros_like(velocities)  # of the impulses
        for phase in result.phases:
            impulses, slopes = phase.forces.copy(), np.zeros_like(velocities)
            restitution_slopes = np.zeros((len(phase.restitution_impulses), len(self.time)))
            for i in np.flatnonzero(
                phase.restitution_impulses
            ).tolist():  # e Λ_C, where e is not zero
                e, normal = p.restitution[i], self.rows.normal[i]
                restitution_slopes[i] = (
                    d["restitution"][i] * phase.restitution_impulses[i] / e
                    + e * impulse_slopes[normal]
                )
                impulses[normal] += phase.restitution_impulses[i]
                slopes[normal] = restitution_slopes[i]
            velocities = (
                velocities + np.einsum("ijk,j->ik", d["delassus"], impulses) + p.delassus @ slopes
            )
            increments = self._impulses(d, p, phase, restitution_slopes, velocities)
            velocities = velocities + p.delassus @ increments
            impulse_slopes = impulse_slopes + slopes + increments
        # Entries of J M⁻¹ Jᵀ that should be zero are rounded as √(A_ii A_jj).
        root = np.sqrt(np.abs(p.delassus.diagonal()))
        span = ROUNDING_MARGIN * ROUNDING * float(np.ptp(self.problem.settings.times))
        for i, normal in enumerate(self.rows.normal):
            if normal is not None:
                self.blurred[i] += span * root[normal] * (root @ np.abs(impulse_slopes))
        change = np.einsum("ijk,j->ik", d["response"], result.forces) + p.response @ impulse_slopes
        self.total = self.total.copy()
        self.total[self._first : self._first + len(change)] += change
        return d

    def _impulses(
        self,
        d: Mapping[str, np.ndarray],
        p: RowValues,
        phase: Phase,
        restitution_slopes: np.ndarray,
        velocities: np.ndarray,
    ) -> np.ndarray:
        """Return the derivatives of a phase's impulses, without the `restitution_slopes`.

        `velocities` has the derivatives of the velocities after it, without those impulses.
        """
        f = phase.forces
        matrix, right = np.eye(len(f)), np.zeros_like(velocities)
        constrained: set[int] = (
            set()
        )  # rows with given velocities; the impulses of the others are given
        for i, mode in enumerate(phase.modes):
            normal, tangent = self.rows.normal[i], list(self.rows.tangent[i])
            if mode == OPEN or normal is None:
                continue
            zero_rows = [] if i in phase.leaves else [normal]
            zero_rows += tangent if mode in (STICKS, CLOSED) else ()
            matrix[zero_rows], right[zero_rows] = p.delassus[zero_rows], -velocities[zero_rows]
            constrained.update(zero_rows)
            if mode not in SLIDES:
                continue
            if mode != STARTING:
                unit, turning = np.array([SLIDES[mode]]), np.zeros((1, 1))
            else:
                after = phase.rates[tangent]
                unit = after / np.linalg.norm(after)
                turning = (np.eye(2) - np.outer(unit, unit)) / np.linalg.norm(after)
            press = phase.restitution_impulses[i] + f[normal]
            push = p.mu[i] * press
            matrix[tangent, normal] += p.mu[i] * unit
            matrix[tangent] += push * turning @ p.delassus[tangent]
            right[tangent] = (
                -np.outer(unit, d["mu"][i] * press + p.mu[i] * restitution_slopes[i])
                - push * turning @ velocities[tangent]
            )
        for row in {*range(len(f))} - constrained:
            matrix[row] *= p.delassus[row, row]
            right[row] *= p.delassus[row, row]
        return _least(matrix, right, p.delassus.diagonal())

    def project(
        self, values: Mapping[AnySymbol, float], p: RowValues, active: Sequence[int]
    ) -> None:
        """Project D onto the null space of the active rows."""
        owners, first = self.rows.owners_of(active), self._first
        normals = list(owners)
        self.total = self.total.copy()
        if normals:
            residuals = self.slopes(values)["gap"][list(owners.values())]
            square = p.delassus[np.ix_(normals, normals)]
            shares = _least(square, -residuals, square.diagonal())
            self.total[:first] += p.kinematics @ (p.response[:, normals] @ shares)
        if active:
            residuals = self.slopes(values)["speed"][list(active)]
            square = p.delassus[np.ix_(active, active)]
            shares = _least(square, -residuals, square.diagonal())
            self.total[first : first + len(p.response)] += p.response[:, list(active)] @ shares


class HybridSensitivities(Transitions):
    """Sensitivities of a motion, passed from mode to mode.

    `controlled` includes them in the step-size control.
    """

    def __init__(
        self, requested: object, controlled: bool, rows: ContactRows, problem: Problem
    ) -> None:
        self.augmented = augmented = AugmentedSystem.for_parameters(
            problem, problem.model.code, problem.plan, requested
        )
        parameters = augmented.parameters
        every = [p for p in parameters for _ in range(p.count)]
        constants = [p.symbol if p.kind == "constants" else None for p in every]
        initial = InitialSensitivities(augmented, problem.dependent)
        start = initial.values(problem.x, float(problem.settings.times[0]))
        super().__init__(rows, problem, constants, start)
        self._controlled = controlled
        self._counts = {p.symbol: p.count for p in parameters}
        self._before: np.ndarray | None = None  # S before the last event; None at the start
        self._columns = np.full((len(problem.settings.times), *self.total.shape), np.nan)

    def simulate(
        self,
        mode: Mode,
        start: np.ndarray,
        problem: Problem,
        solver: Solver,
        options: dict[str, Any],
    ) -> Motion:
        """Simulate in one mode, with the sensitivities S at the start."""
        self._columns[self.problem.settings.times == problem.settings.times[0]] = start
        controlled = self._controlled or mode.turns
        request = SensitivityRequest([*self._counts], controlled, start, mode.untimed)
        return simulate(
            problem, problem.settings.times, solver=solver, sensitivities=request, **options
        )

    def store_instant(self, start: float, values: np.ndarray, records: list[EventRecord]) -> None:
        """Keep S⁺ of a mode that lasts no time, as it begins at the last."""
        self._columns[self.problem.settings.times == start] = values
        self._note(start, values, records)

    def _note(self, start: float, values: np.ndarray, records: list[EventRecord]) -> None:
        """Store S⁺ in the records of the transition that led to it."""
        fields: dict[str, Any] = {
            "time_sensitivity": np.where(self.doubtful, np.nan, self.time),
            "sensitivity_before": self._before,
            "sensitivity_after": values,
        }
        for k, record in enumerate(records):
            if record.time == start and record.time_sensitivity is None:
                records[k] = replace(record, **fields)

    def store_segment(self, motion: Motion, end: float, records: list[EventRecord]) -> None:
        """Store the sensitivities of a segment."""
        start, values = motion.times[0], motion.sensitivities
        assert values is not None
        self._note(start, values[0], records)
        rows = (self.problem.settings.times > start) & (self.problem.settings.times <= end)
        self._columns[rows] = values[1 : 1 + int(rows.sum())]

    def locate_end(self, record: EventRecord, rates: np.ndarray) -> None:
        """Set D from the record of the event that ends a mode."""
        assert record.sensitivity_before is not None
        assert record.time_sensitivity is not None
        self._before = record.sensitivity_before
        self.end_mode(self._before, record.time_sensitivity, rates)

    def doubt(self, values: Mapping[AnySymbol, float], i: int) -> None:
        """Mark parameters for which the derivative of the time of a stop in a plane is unknown.

        At a stop both sliding speeds vanish for all parameter values. One of them determines the
        derivative of the time; if the other contradicts it, friction turned the velocity too fast
        at the end. A contact that sticks next does not depend on it: projection removes its effect.
        Where the slide ended at its `rest_speed`, that determines the derivative of the time.
        """
        rows = self.rows.tangent[i]
        speeds = self.slopes(values)["speed"][rows]
        total, time = self.total, self.time
        assert self._before is not None
        self.total, self.time = self._before, np.zeros(len(time))
        size = np.linalg.norm(self.slopes(values)["speed"][rows], axis=0)
        self.total, self.time = total, time
        remains = ~(np.linalg.norm(speeds, axis=0) <= SLACK * size)
        marked = self.turned if self.rest_speeds.get(i) else self.doubtful
        marked |= remains

    def limit_of_rebounds(
        self,
        i: int,
        p: RowValues,
        rebound: tuple[float, float, float],
        later: float,
        slopes: Mapping[str, np.ndarray],
        known: bool,
    ) -> np.ndarray:
        """Return the derivatives of the time at which rebounds accumulate (Zeno behaviour).

        `rebound` and `slopes` are as in `ContactRun.note_rest`; with the first rebound at v and the
        acceleration −a the limit is 2 v `later` after the impact. The forces of other contacts are
        constant, and so is the ratio of successive speeds. Without a `known` ratio they are NaN.
        """
        v, a, _ = rebound
        normal, by_e = self.rows.normal[i], slopes["restitution"][i]
        slower = v * later * a * by_e + v / a * slopes["free"][normal]
        faster = -p.restitution[i] * slopes["speed"][normal] - p.speed[normal] * by_e
        result: np.ndarray = self.time + 2.0 * later * (faster + slower)
        return result if known else np.full(len(result), np.nan)

    def separating_parameters(
        self, i: int, slopes: np.ndarray, p: RowValues, share: float
    ) -> list[str]:
        """Return the parameters that move the gap of a closing contact away from zero."""
        wrong = self.gap_opens(i, slopes, p, share)
        return [name for name, off in zip(column_names(self._counts), wrong, strict=True) if off]

    def results(self, count: int) -> np.ndarray:
        """Return the sensitivities at the times that were reached, shape (count, n, k)."""
        columns: np.ndarray = self._columns[:count]
        return columns

    def labels(self, values: np.ndarray | None, segments: Sequence[Segment]) -> dict[str, object]:
        """Return the trajectory's arguments for its sensitivities (m, n, k)."""
        model = SegmentedSensitivities(segments)
        return {"sensitivities": (self._counts, values), "sensitivity_model": model}


def _least(matrix: np.ndarray, right: np.ndarray, square: np.ndarray) -> np.ndarray:
    """Solve for the unknowns of least norm, since rows may be redundant.

    Rows and unknowns are scaled by the acceleration of each row per unit of its own force, which
    makes the rank independent of units.
    """
    size = np.sqrt(np.where(square > 0.0, square, 1.0))
    scaled = matrix / np.outer(size, size)
    solution: np.ndarray = np.linalg.lstsq(scaled, right / size[:, None], rcond=DEPENDENT)[0]
    return solution / size[:, None]
