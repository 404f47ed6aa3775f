"""The conditions of equilibrium of a Problem as functions of its unknowns, vectorised."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from copy import copy
from typing import TYPE_CHECKING

import numpy as np

from pydy._assembly import Definition
from pydy._checks import check_mapping, describe, listed, number, refuse_twice, shown
from pydy._errors import EquilibriumError, warn_user
from pydy._graph import inputs_of
from pydy._judges import free_quaternions, warn_of_missing_derivatives
from pydy._names import some, unique_names
from pydy._problem import Problem
from pydy._program import run
from pydy._rank import or_one
from pydy._states import GROUPS, EvaluationPoints, ForcesWithoutConstraints, located
from pydy.analysis.bounds import limits
from pydy.analysis.equilibria import Equilibrium, RootProblem, Sizes, nonzero_row, solve_equilibrium
from pydy.codegen import SpecifiedsPlan

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, SymbolOrName

# Number of times at which an equilibrium is checked again; powers of two if `times` is a point.
_TIMES = 64


class Unknowns:
    """Unknown states, constants and specifieds, with their positions among all of these."""

    def __init__(self, definition: Definition, symbols: Sequence[SymbolOrName]) -> None:
        self.symbols: list[AnySymbol] = []
        self.order: list[tuple[str, int]] = []
        for symbol in symbols:
            kind, index = located(definition, symbol, "unknowns")
            self.order.append((kind, index))
            self.symbols.append(definition.places[kind].symbols[index])
        refuse_twice(self.symbols, "unknowns")
        self._by_kind = {
            kind: ([k for k, (unknown_kind, _) in enumerate(self.order) if unknown_kind == kind],
                   [index for unknown_kind, index in self.order if unknown_kind == kind])
            for kind in GROUPS
        }  # fmt: skip

    @property
    def names(self) -> tuple[str, ...]:
        """Their names."""
        return unique_names(self.symbols)

    def of_kind(self, kind: str) -> tuple[list[int], list[int]]:
        """Return the columns of the unknowns of a kind, and their indices among that kind."""
        return self._by_kind[kind]


class EquilibriumResidual:
    """Derivatives of the states and residuals of the constraints as functions of unknowns z.

    The squared length of each quaternion less one is a residual, too: motions conserve it, so the
    rates do not determine it, and a quaternion of zero length would be at rest anywhere.
    """

    def __init__(
        self,
        problem: Problem,
        unknowns: Iterable[SymbolOrName] | None,
        fixed_values: Mapping[SymbolOrName, float] | None,
        moving: Iterable[SymbolOrName],
        varied: Sequence[SymbolOrName] = (),
    ) -> None:
        definition = self.definition = problem.definition
        equations = definition.equations
        states = definition.places["states"]
        q, n = len(equations.coordinates), len(equations.coordinates) + len(equations.speeds)
        self.steady = steady = states.columns(listed("moving", moving), "moving").tolist()
        if any(index >= q for index in steady):
            names = [str(states.symbols[k]) for k in steady if k >= q]
            raise ValueError(f"`moving` must hold coordinates, got {some(names)}.")
        self.x, self.p = problem.x.copy(), problem.p.copy()
        fixed_slots = self._apply_values(check_mapping("given", fixed_values))
        if isinstance(unknowns, Mapping):
            raise TypeError(
                f"`unknowns` must be a sequence of symbols, got {shown(unknowns)}. To start from "
                "these values: `find_equilibrium(list(guess), given=guess)`, or set "
                "`system.initial_conditions`; to fix them: `given`."
            )
        if unknowns is None:
            excluded = {*fixed_slots, *(located(definition, key, "over") for key in varied)}
            unknowns = [
                s
                for k, s in enumerate((*equations.coordinates, *equations.speeds))
                if k not in steady and ("states", k) not in excluded
            ]
        unknowns = listed("unknowns", unknowns)
        if not unknowns and not varied:
            raise ValueError("`unknowns` must name at least one state, constant or specified.")
        self.unknowns = all_unknowns = Unknowns(definition, [*unknowns, *varied])
        self.rows = [k for k in range(n) if k not in steady]
        by_specified, self.columns = all_unknowns.of_kind("specifieds")
        unknown_specifieds = {definition.specifieds[k]: k for k in self.columns}
        starting = np.empty(0)
        if unknown_specifieds:
            starting = problem.inputs.rows(problem.x[None], np.array([problem.t]))[0]
        self.plan = problem.plan.updated(
            SpecifiedsPlan(
                {s: float(starting[k]) for s, k in unknown_specifieds.items()}
                | {s: v for s, v in self.fixed_values.items() if s in definition.specifieds},
                definition.places["specifieds"],
                argument="given",
            )
        )
        self.model = problem.model.with_compiled_inputs(
            self.plan, perturbed=bool(unknown_specifieds or self.plan.inputs.functions)
        )
        constraints = equations.constraints
        self.blocks = ["rates", *(b for b in ("holonomic", "velocity") if getattr(constraints, b))]
        unknown_states = {*all_unknowns.of_kind("states")[1]}
        unknown = [q for q in free_quaternions(equations) if unknown_states.intersection(q)]
        self.quaternions = np.array(unknown, dtype=int).reshape(-1, 4)
        self.t, self.time_span, self.warned = (
            problem.t,
            float(np.ptp(np.append(problem.settings.times, problem.t))),
            False,
        )
        self.start = np.empty(len(all_unknowns.symbols))
        self.start[all_unknowns.of_kind("states")[0]] = self.x[all_unknowns.of_kind("states")[1]]
        self.start[all_unknowns.of_kind("constants")[0]] = self.p[
            all_unknowns.of_kind("constants")[1]
        ]
        r = self.plan.inputs.rows(self.x[None], np.array([self.t]))[0]
        self.start[by_specified] = r[self.columns]

    def _apply_values(self, values: Mapping[SymbolOrName, float]) -> list[tuple[str, int]]:
        """Replace the System's numbers by the given ones; return each one's kind and index."""
        definition = self.definition
        self.fixed_values: dict[AnySymbol, float] = {}
        slots = [located(definition, key, "given") for key in values]
        refuse_twice([definition.places[kind].symbols[k] for kind, k in slots], "given")
        for (kind, index), (key, entry) in zip(slots, values.items(), strict=True):
            amount = number(entry, f"`given[{key}]`", finite=True)
            if kind != "states":
                self.fixed_values[getattr(definition, kind)[index]] = amount
            if kind != "specifieds":
                (self.x if kind == "states" else self.p)[index] = amount
        return slots

    @property
    def row_names(self) -> list[str]:
        """The names of the residual's rows."""
        names = self.definition.row_names("rates")
        constraint_rows = [t for b in self.blocks[1:] for t in self.definition.row_names(b)]
        states = self.definition.states
        lengths = [
            f"the squared length of the quaternion {describe([states[k] for k in indices])}, less 1"
            for indices in self.quaternions
        ]
        return [names[k] for k in self.rows] + constraint_rows + lengths

    def pairs(self, k: int) -> dict[int, int]:
        """Return the rows that are rates of the first k unknowns, with these unknowns' columns."""
        column = dict(zip(*reversed(self.unknowns.of_kind("states")), strict=True))
        return {row: column[q] for row, q in enumerate(self.rows) if column.get(q, k) < k}

    def point_at(self, z: np.ndarray) -> EvaluationPoints:
        """Return the points of unknowns z (m, l); p has m rows if constants are unknown."""
        m = len(z)
        by_state, at_state = self.unknowns.of_kind("states")
        by_constant, at_constant = self.unknowns.of_kind("constants")
        x, p, t = np.repeat(self.x[None], m, axis=0), self.p, np.full(m, self.t)
        x[:, at_state] = z[:, by_state]
        if by_constant:
            p = np.repeat(p[None], m, axis=0)
            p[:, at_constant] = z[:, by_constant]
        r = np.broadcast_to(
            self.plan.inputs.rows(x, t), (m, len(self.definition.specifieds))
        ).copy()
        r[:, self.columns] = z[:, self.unknowns.of_kind("specifieds")[0]]
        return EvaluationPoints(self.definition, self.model, t, x, r, p, self.plan)

    def residuals(self, z: np.ndarray) -> np.ndarray:
        """Return the residuals, shape (m, rows); NaN in singular states."""
        point = self.point_at(z)
        parts = [point.tried(self.model.compiled(b)) for b in self.blocks]
        lengths = (point.x[:, self.quaternions] ** 2).sum(axis=2) - 1.0
        return np.concatenate([parts[0][:, self.rows], *parts[1:], lengths], axis=1)

    def slopes(self, z: np.ndarray) -> np.ndarray:
        """Return the derivatives of the residuals by the unknowns, shape (m, rows, l)."""
        m, model, point = len(z), self.model, self.point_at(z)
        input_by_state = point.input_feedback
        input_by_state[:, self.columns] = 0.0
        by_state, at_state = self.unknowns.of_kind("states")
        parts = []
        for block in self.blocks:
            part = np.zeros((m, len(getattr(model.assembly.blocks, block)), z.shape[1]))
            if input_by_state.any():
                by_input = point.tried(model.compiled_jacobian(block, "r"))
                through_inputs = by_input.reshape(m, part.shape[1], -1) @ input_by_state
                part[:, :, by_state] = through_inputs[:, :, at_state]
            for kind, group in GROUPS.items():
                columns, indices = self.unknowns.of_kind(kind)
                if columns:
                    slopes = point.tried(model.compiled_jacobian(block, group))
                    part[:, :, columns] += slopes.reshape(m, part.shape[1], -1)[:, :, indices]
            parts.append(part)
        lengths = np.zeros((m, len(self.quaternions), z.shape[1]))
        lengths[:, :, by_state] = self._length_slopes(point.x)[:, :, at_state]
        return np.concatenate([parts[0][:, self.rows], *parts[1:], lengths], axis=1)

    def _length_slopes(self, x: np.ndarray) -> np.ndarray:
        """Return the derivatives of the quaternions' squared lengths by the states."""
        slopes = np.zeros((len(x), len(self.quaternions), x.shape[1]))
        rows = np.arange(len(self.quaternions))[:, None]
        slopes[:, rows, self.quaternions] = 2.0 * x[:, self.quaternions]
        return slopes

    def sizes(self, slopes: np.ndarray, z: np.ndarray) -> list[Sizes]:
        """Return the scales of unknowns and rows; slopes (m, rows, k) are by k unknowns."""
        m, k = len(z), slopes.shape[2]
        points = self.point_at(z).alone()
        order = self.unknowns.order
        sizes = [np.stack([at.natural[kind][:, k] for kind, k in order], axis=1) for at in points]
        natural, rows = np.concatenate(sizes), np.concatenate([*map(self._inertia, points)])
        powers = np.zeros(len(self.row_names))
        first = len(self.definition.equations.coordinates)
        powers[: len(self.rows)] = np.array(self.rows) >= first
        num_holonomic = len(self.definition.equations.constraints.holonomic)
        powers[len(self.rows) : len(self.rows) + num_holonomic] = -1.0
        powers[len(powers) - len(self.quaternions) :] = -1.0
        return [
            Sizes(slopes[i], z[i, :k], natural[i, :k], self.pairs(k), (rows[i], powers))
            for i in range(m)
        ]

    def _inertia(self, point: EvaluationPoints) -> np.ndarray:
        """Return the size of the rows for motions of one energy, shape (m, rows); see `Sizes`."""
        equations = self.definition.equations
        first, n = len(equations.coordinates), len(equations.speeds)
        rates = point.motions

        moving = {"holonomic": slice(first), "velocity": slice(first, first + n)}
        parts = [rates[:, self.rows]]
        for block in self.blocks[1:]:
            columns = moving[block]
            parts.append((point.steepness(block)[:, :, columns] @ rates[:, columns, None])[:, :, 0])
        steepness = np.abs(self._length_slopes(point.x))
        parts.append((steepness[:, :, :first] @ rates[:, :first, None])[:, :, 0])
        return np.concatenate(parts, axis=1)

    def terms(self, z: np.ndarray) -> np.ndarray:
        """Return the size of the residuals' terms due to constants, specifieds and loads."""
        point = self.point_at(z[None]).alone()[0]
        numbers = {"r": point.r[0], "p": np.atleast_2d(point.p)[0]}
        arrays = point.t, point.x, point.r, numbers["p"]
        parts = []
        for block in self.blocks:
            part = np.zeros(len(getattr(self.model.assembly.blocks, block)))
            for group, values in numbers.items():
                if len(values):
                    program = self.model.programs.jacobian(block, group)
                    slopes = run(program, *arrays)[0].reshape(len(part), -1)
                    part += np.abs(np.nan_to_num(slopes)) @ np.abs(values)
            parts.append(part)
        first, n = len(self.definition.equations.coordinates), len(self.model.assembly.speeds)
        forces = point.interpret(ForcesWithoutConstraints(self.definition))["forces"][0]
        speeds = point.motions[0, first : first + n]
        parts[0][first : first + n] += np.max(forces * speeds, initial=0.0) * speeds
        return np.concatenate([parts[0][self.rows], *parts[1:], np.ones(len(self.quaternions))])

    def problem(self, last: float | None = None) -> RootProblem:
        """Return the conditions of equilibrium, with the `last` unknown fixed unless None."""
        appended = [] if last is None else [last]
        k = len(self.unknowns.symbols) - len(appended)

        def with_last(z: np.ndarray) -> np.ndarray:
            return np.append(z, appended)

        return RootProblem(
            residual=lambda z: self.residuals(with_last(z)[None])[0],
            jacobian=lambda z: self.slopes(with_last(z)[None])[0, :, :k],
            unknowns=self.unknowns.names[:k],
            rows=self.row_names,
            rates=self.pairs(k),
            num_constraints=len(self.row_names) - len(self.rows),
            sizes=lambda slopes, z: self.sizes(slopes[None], with_last(z)[None])[0],
            terms=lambda z: self.terms(with_last(z)),
        )

    def solve(
        self, z: np.ndarray, bounds: tuple[np.ndarray, np.ndarray], last: float | None = None
    ) -> tuple[np.ndarray, float, tuple[str, ...]]:
        """Call `solve_equilibrium` from unknowns z, with the `last` one fixed unless None."""
        accepted = solve_equilibrium(self.problem(last), z, bounds)
        solution = np.append(accepted[0], [] if last is None else [last])
        rates = np.zeros(0)
        if self.steady:
            point = self.point_at(solution[None])
            rates = point.tried(self.model.compiled("rates"))[0, self.steady]
            fastest = np.abs(rates / or_one(point.natural["states"][0, self.steady])).max()
            if fastest > 0.0:  # the fastest advances by its size, such as an angle by a radian
                ahead = self._advanced_copy(rates / fastest)
                if nonzero := nonzero_row(ahead.problem(last), accepted[0]):
                    names = unique_names(self.definition.states)
                    raise EquilibriumError(
                        "`moving` must not have coordinates that the motion depends on, got "
                        f"{some(names[k] for k in self.steady)}: as they advance, {nonzero[0]} "
                        "does not stay zero, and the motion is not steady. Leave them out, or find "
                        "a periodic orbit.",
                        accepted[0],
                        nonzero[2],
                    )
        if not self.warned:
            self._warn_of_time(solution, rates)
        return accepted

    def _advanced_copy(self, advance: np.ndarray, t: float | None = None) -> EquilibriumResidual:
        """Return a copy with advanced steady coordinates, or at another time."""
        ahead = copy(self)
        ahead.x, ahead.t = self.x.copy(), self.t if t is None else t
        ahead.x[self.steady] += advance
        return ahead

    def _warn_of_time(self, z: np.ndarray, rates: np.ndarray) -> None:
        """Warn once if z is not an equilibrium at other times."""
        graph, assembly, plan = self.model.assembly.graph, self.model.assembly, self.plan
        nodes = [node for block in self.blocks for node in getattr(assembly.blocks, block)]
        if plan.inputs.constant and "t" not in inputs_of(graph, nodes).groups:
            return
        times = self.t + 2.0 ** np.array(sorted(range(-_TIMES // 2, _TIMES // 2), key=abs))
        if self.time_span > 0.0:
            times = self.t + self.time_span * np.arange(1, _TIMES + 1) / _TIMES
        elif not plan.inputs.constant:
            return
        reference = self.residuals(z[None])[0]
        for t in times[
            [all(s.covers(times[[k]]) for _, s in plan.inputs.sampled) for k in range(_TIMES)]
        ]:
            ahead = self._advanced_copy(rates * (t - self.t), float(t))
            values = ahead.residuals(z[None])[0]
            if (values == reference).all() or not np.isfinite(values).all():
                continue
            if nonzero := nonzero_row(ahead.problem(), z):
                changed = (ahead.point_at(z[None]).r != self.point_at(z[None]).r)[0]
                expressions, time = plan.expressions, self.definition.equations.time
                inputs = [
                    symbol
                    for symbol, is_changed in zip(plan.symbols, changed, strict=True)
                    if is_changed or (symbol in expressions and expressions[symbol].has(time))
                ]
                subject = describe(inputs) if inputs else "the loads"
                warn_user(
                    f"The equilibrium is one for {subject} at t = {self.t:.6g} alone: at t = "
                    f"{t:.6g} {nonzero[0]} is {nonzero[1]:.3g}. Give constant values, as in "
                    "`given`, or find a periodic orbit."
                )
                self.warned = True
                return

    def equilibrium(self, z: np.ndarray, largest: float, free: tuple[str, ...]) -> Equilibrium:
        """Return the result for solved unknowns z, shape (l,)."""
        unknowns = self.unknowns
        values = dict(zip(unknowns.symbols, z.tolist(), strict=True))
        x = self.point_at(z[None]).x[0]
        return Equilibrium(
            values=values,
            initial_conditions=dict(zip(self.definition.states, x.tolist(), strict=True)),
            constants={unknowns.symbols[k]: float(z[k]) for k in unknowns.of_kind("constants")[0]},
            specifieds={
                unknowns.symbols[k]: float(z[k]) for k in unknowns.of_kind("specifieds")[0]
            },
            state=x,
            residual=largest,
            free=free,
            given={s: value for s, value in self.fixed_values.items() if s not in values},
        )


def _bounds(
    definition: Definition,
    unknowns: Unknowns,
    bounds: Mapping[SymbolOrName, Sequence[float | None]] | None,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the lowest and highest values of the unknowns, in their order."""
    low = np.full(len(unknowns.symbols), -np.inf)
    high = -low
    pairs = check_mapping("bounds", bounds)
    slots = [located(definition, key, "bounds") for key in pairs]
    refuse_twice([definition.places[kind].symbols[k] for kind, k in slots], "bounds")
    for slot, (key, pair) in zip(slots, pairs.items(), strict=True):
        if slot not in unknowns.order:
            raise ValueError(f"`bounds` has the key `{key}`, which is not one of `unknowns`.")
        k = unknowns.order.index(slot)
        low[k], high[k] = limits(pair, f"`bounds[{key}]`")
    return low, high


def find_equilibrium(
    problem: Problem,
    unknowns: Iterable[SymbolOrName] | None = None,
    given: Mapping[SymbolOrName, float] | None = None,
    bounds: Mapping[SymbolOrName, Sequence[float | None]] | None = None,
    moving: Iterable[SymbolOrName] = (),
) -> Equilibrium:
    """Find an equilibrium of a Problem; see `System.find_equilibrium`."""
    warn_of_missing_derivatives(problem)
    residual = EquilibriumResidual(problem, unknowns, given, moving)
    limits = _bounds(problem.definition, residual.unknowns, bounds)
    return residual.equilibrium(*residual.solve(residual.start, limits))
