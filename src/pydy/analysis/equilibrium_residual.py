"""Equilibria of a Problem: their conditions as functions of chosen unknowns, at many values."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from copy import copy
from typing import Any

import numpy as np

from pydy._assembly import Definition
from pydy._checks import check_mapping, describe, listed, number, refuse_twice
from pydy._errors import EquilibriumError, warn_user
from pydy._judges import warn_of_missing_derivatives
from pydy._names import some, unique_names
from pydy._problem import Problem
from pydy._program import run
from pydy._rank import or_one
from pydy._states import GROUPS, ForcesWithoutConstraints, Point, located
from pydy.analysis.bounds import limits
from pydy.analysis.equilibria import Equilibrium, RootProblem, Sizes, left_ahead, solve_equilibrium
from pydy.codegen import SpecifiedsPlan

# Times at which an equilibrium is tried again; powers of two where none are given.
_TIMES = 64


class Unknowns:
    """Symbols of all three kinds, and where they lie."""

    def __init__(self, definition: Definition, symbols: Sequence[Any]) -> None:
        self.symbols: list[Any] = []
        self.order: list[tuple[str, int]] = []
        for symbol in symbols:
            kind, place = located(definition, symbol, "unknowns")
            self.order.append((kind, place))
            self.symbols.append(definition.places[kind].symbols[place])
        refuse_twice(self.symbols, "unknowns")
        self._found = {
            kind: ([k for k, (what, _) in enumerate(self.order) if what == kind],
                   [place for what, place in self.order if what == kind])
            for kind in GROUPS
        }  # fmt: skip

    @property
    def names(self) -> tuple[str, ...]:
        """Their names."""
        return unique_names(self.symbols)

    def of(self, kind: str) -> tuple[list[int], list[int]]:
        """Return which of the unknowns are of a kind, and their places there."""
        return self._found[kind]


class EquilibriumResidual:
    """Derivatives of the states and residuals of the constraints as functions of unknowns z."""

    def __init__(
        self,
        problem: Problem,
        unknowns: Iterable[Any] | None,
        given: Mapping[Any, Any] | None,
        moving: Iterable[Any],
        varied: Sequence[Any] = (),
    ) -> None:
        definition = self.definition = problem.definition
        equations = definition.equations
        states = definition.places["states"]
        q, n = len(equations.coordinates), len(equations.coordinates) + len(equations.speeds)
        self.steady = steady = states.columns(listed("moving", moving), "moving").tolist()
        if any(place >= q for place in steady):
            names = [str(states.symbols[k]) for k in steady if k >= q]
            raise ValueError(f"`moving` must hold coordinates, got {some(names)}.")
        self.x, self.p = problem.x.copy(), problem.p.copy()
        places = self._take(check_mapping("given", given))
        if unknowns is None:
            held = {*places, *(located(definition, key, "over") for key in varied)}
            unknowns = [
                s
                for k, s in enumerate((*equations.coordinates, *equations.speeds))
                if k not in steady and ("states", k) not in held
            ]
        unknowns = listed("unknowns", unknowns)
        if not unknowns and not varied:
            raise ValueError("`unknowns` must name at least one state, constant or specified.")
        self.wanted = wanted = Unknowns(definition, [*unknowns, *varied])
        self.rows = [k for k in range(n) if k not in steady]
        by_specified, self.columns = wanted.of("specifieds")
        own = {definition.specifieds[k]: k for k in self.columns}
        starting = np.empty(0)
        if own:
            starting = problem.inputs.rows(problem.x[None], np.array([problem.t]))[0]
        self.plan = problem.plan.updated(
            SpecifiedsPlan(
                {s: float(starting[k]) for s, k in own.items()}
                | {s: v for s, v in self.given.items() if s in definition.specifieds},
                definition.places["specifieds"],
                argument="given",
            )
        )
        self.made = problem.model.with_compiled_inputs(
            self.plan, perturbed=bool(own or self.plan.inputs.functions)
        )
        constraints = equations.constraints
        self.blocks = ["rates", *(b for b in ("holonomic", "velocity") if getattr(constraints, b))]
        self.t, self.within, self.told = (
            problem.t,
            float(np.ptp(np.append(problem.settings.times, problem.t))),
            False,
        )
        self.start = np.empty(len(wanted.symbols))
        self.start[wanted.of("states")[0]] = self.x[wanted.of("states")[1]]
        self.start[wanted.of("constants")[0]] = self.p[wanted.of("constants")[1]]
        r = self.plan.inputs.rows(self.x[None], np.array([self.t]))[0]
        self.start[by_specified] = r[self.columns]

    def _take(self, given: Mapping[Any, Any]) -> list[tuple[str, int]]:
        """Take numbers in place of the System's; return of which kind each is, and its place."""
        definition, self.given = self.definition, dict[Any, float]()
        places = [located(definition, key, "given") for key in given]
        refuse_twice([definition.places[kind].symbols[k] for kind, k in places], "given")
        for (kind, place), (key, entry) in zip(places, given.items(), strict=True):
            amount = number(entry, f"`given[{key}]`", finite=True)
            if kind != "states":
                self.given[getattr(definition, kind)[place]] = amount
            if kind != "specifieds":
                (self.x if kind == "states" else self.p)[place] = amount
        return places

    @property
    def titles(self) -> list[str]:
        """The names of the residual's rows."""
        names = self.definition.row_names("rates")
        rest = [t for b in self.blocks[1:] for t in self.definition.row_names(b)]
        return [names[k] for k in self.rows] + rest

    def pairs(self, k: int) -> dict[int, int]:
        """Return the rows that are rates of states among the first k unknowns, and of which."""
        column = dict(zip(*reversed(self.wanted.of("states")), strict=True))
        return {row: column[q] for row, q in enumerate(self.rows) if column.get(q, k) < k}

    def at(self, z: np.ndarray) -> Point:
        """Return where unknowns z (m, l) are; p has rows where it is among them."""
        m = len(z)
        by_state, at_state = self.wanted.of("states")
        by_constant, at_constant = self.wanted.of("constants")
        x, p, t = np.repeat(self.x[None], m, axis=0), self.p, np.full(m, self.t)
        x[:, at_state] = z[:, by_state]
        if by_constant:
            p = np.repeat(p[None], m, axis=0)
            p[:, at_constant] = z[:, by_constant]
        r = np.broadcast_to(
            self.plan.inputs.rows(x, t), (m, len(self.definition.specifieds))
        ).copy()
        r[:, self.columns] = z[:, self.wanted.of("specifieds")[0]]
        return Point(self.definition, self.made, t, x, r, p, self.plan)

    def residuals(self, z: np.ndarray) -> np.ndarray:
        """Return the residuals, shape (m, rows); NaN in singular states."""
        at = self.at(z)
        parts = [at.tried(self.made.compiled(b)) for b in self.blocks]
        return np.concatenate([parts[0][:, self.rows], *parts[1:]], axis=1)

    def slopes(self, z: np.ndarray) -> np.ndarray:
        """Return the derivatives of the residuals by the unknowns, shape (m, rows, l)."""
        m, made, at = len(z), self.made, self.at(z)
        through = at.through
        through[:, self.columns] = 0.0
        by_state, at_state = self.wanted.of("states")
        parts = []
        for block in self.blocks:
            part = np.zeros((m, len(getattr(made.assembly, block)), z.shape[1]))
            if through.any():
                by_input = at.tried(made.compiled_jacobian(block, "r"))
                whole = by_input.reshape(m, part.shape[1], -1) @ through
                part[:, :, by_state] = whole[:, :, at_state]
            for kind, group in GROUPS.items():
                places, found = self.wanted.of(kind)
                if places:
                    slopes = at.tried(made.compiled_jacobian(block, group))
                    part[:, :, places] += slopes.reshape(m, part.shape[1], -1)[:, :, found]
            parts.append(part)
        return np.concatenate([parts[0][:, self.rows], *parts[1:]], axis=1)

    def sizes(self, slopes: np.ndarray, z: np.ndarray) -> list[Sizes]:
        """Return how large unknowns and rows are; slopes (m, rows, k) are by k unknowns."""
        m, k = len(z), slopes.shape[2]
        points = self.at(z).alone()
        own = self.wanted.order
        sizes = [np.stack([at.natural[kind][:, k] for kind, k in own], axis=1) for at in points]
        natural, rows = np.concatenate(sizes), np.concatenate([*map(self._inertia, points)])
        powers = np.zeros(len(self.titles))
        first = len(self.definition.equations.coordinates)
        powers[: len(self.rows)] = np.array(self.rows) >= first
        held = len(self.definition.equations.constraints.holonomic)
        powers[len(self.rows) : len(self.rows) + held] = -1.0
        return [
            Sizes(slopes[i], z[i, :k], natural[i, :k], self.pairs(k), (rows[i], powers))
            for i in range(m)
        ]

    def _inertia(self, at: Point) -> np.ndarray:
        """Return how large rows are for motions of one energy, shape (m, rows); see `Sizes`."""
        equations = self.definition.equations
        first, n = len(equations.coordinates), len(equations.speeds)
        rates = at.motions

        moving = {"holonomic": slice(first), "velocity": slice(first, first + n)}
        parts = [rates[:, self.rows]]
        for block in self.blocks[1:]:
            by = moving[block]
            parts.append((at.steepness(block)[:, :, by] @ rates[:, by, None])[:, :, 0])
        return np.concatenate(parts, axis=1)

    def terms(self, z: np.ndarray) -> np.ndarray:
        """Return how large the residuals' terms are that constants, specifieds, loads make."""
        at = self.at(z[None]).alone()[0]
        numbers = {"r": at.r[0], "p": np.atleast_2d(at.p)[0]}
        arrays = at.t, at.x, at.r, numbers["p"]
        parts = []
        for block in self.blocks:
            part = np.zeros(len(getattr(self.made.assembly, block)))
            for group, values in numbers.items():
                if len(values):
                    program = self.made.jacobian_program(block, group)
                    slopes = run(program, *arrays)[0].reshape(len(part), -1)
                    part += np.abs(np.nan_to_num(slopes)) @ np.abs(values)
            parts.append(part)
        first, n = len(self.definition.equations.coordinates), len(self.made.assembly.speeds)
        forces = at.interpret(ForcesWithoutConstraints(self.definition))["forces"][0]
        speeds = at.motions[0, first : first + n]
        parts[0][first : first + n] += np.max(forces * speeds, initial=0.0) * speeds
        return np.concatenate([parts[0][self.rows], *parts[1:]])

    def problem(self, last: float | None = None) -> RootProblem:
        """Return the conditions of equilibrium; the `last` unknown may be given."""
        more = [] if last is None else [last]
        k = len(self.wanted.symbols) - len(more)

        def whole(z: np.ndarray) -> np.ndarray:
            return np.append(z, more)

        return RootProblem(
            residual=lambda z: self.residuals(whole(z)[None])[0],
            jacobian=lambda z: self.slopes(whole(z)[None])[0, :, :k],
            unknowns=self.wanted.names[:k],
            rows=self.titles,
            rates=self.pairs(k),
            held=len(self.titles) - len(self.rows),
            sizes=lambda slopes, z: self.sizes(slopes[None], whole(z)[None])[0],
            terms=lambda z: self.terms(whole(z)),
        )

    def solved(
        self, z: np.ndarray, bounds: tuple[np.ndarray, np.ndarray], last: float | None = None
    ) -> tuple[np.ndarray, float, tuple[str, ...]]:
        """Call `solve_equilibrium` from unknowns z; the `last` residual may be given."""
        accepted = solve_equilibrium(self.problem(last), z, bounds)
        found = np.append(accepted[0], [] if last is None else [last])
        rates = np.zeros(0)
        if self.steady:
            at = self.at(found[None])
            rates = at.tried(self.made.compiled("rates"))[0, self.steady]
            fastest = np.abs(rates / or_one(at.natural["states"][0, self.steady])).max()
            if fastest > 0.0:  # one of them by its size, such as an angle by a radian
                ahead = self._ahead(rates / fastest)
                if left := left_ahead(ahead.problem(last), accepted[0]):
                    names = unique_names(self.definition.states)
                    raise EquilibriumError(
                        "`moving` must not have coordinates that the motion depends on, got "
                        f"{some(names[k] for k in self.steady)}: as they advance, {left[0]} does "
                        "not stay zero, and the motion is not steady. Leave them out, or find a "
                        "periodic orbit.",
                        accepted[0],
                        left[2],
                    )
        if not self.told:
            self._warn_of_time(found, rates)
        return accepted

    def _ahead(self, moved: np.ndarray, t: float | None = None) -> EquilibriumResidual:
        """Return the same where steady coordinates have moved, or at another time."""
        ahead = copy(self)
        ahead.x, ahead.t = self.x.copy(), self.t if t is None else t
        ahead.x[self.steady] += moved
        return ahead

    def _warn_of_time(self, z: np.ndarray, rates: np.ndarray) -> None:
        """Warn once if the equilibria z are none at other times."""
        graph, assembly, plan = self.made.assembly.graph, self.made.assembly, self.plan
        nodes = [node for block in self.blocks for node in getattr(assembly, block)]
        if plan.inputs.constant and "t" not in graph.inputs_of(nodes):
            return
        times = self.t + 2.0 ** np.array(sorted(range(-_TIMES // 2, _TIMES // 2), key=abs))
        if self.within > 0.0:
            times = self.t + self.within * np.arange(1, _TIMES + 1) / _TIMES
        elif not plan.inputs.constant:
            return
        own = self.residuals(z[None])[0]
        for t in times[
            [all(s.covers(times[[k]]) for _, s in plan.inputs.sampled) for k in range(_TIMES)]
        ]:
            ahead = self._ahead(rates * (t - self.t), float(t))
            values = ahead.residuals(z[None])[0]
            if (values == own).all() or not np.isfinite(values).all():
                continue
            if left := left_ahead(ahead.problem(), z):
                changed = (ahead.at(z[None]).r != self.at(z[None]).r)[0]
                moved, time = plan.expressions, self.definition.equations.time
                inputs = [
                    symbol
                    for symbol, other in zip(plan.symbols, changed, strict=True)
                    if other or (symbol in moved and moved[symbol].has(time))
                ]
                what = describe(inputs) if inputs else "the loads"
                warn_user(
                    f"The equilibrium is one for {what} at t = {self.t:.6g} alone: at t = {t:.6g} "
                    f"{left[0]} is {left[1]:.3g}. Give constant values, as in `given`, or find a "
                    "periodic orbit."
                )
                self.told = True
                return

    def equilibrium(self, z: np.ndarray, largest: float, free: tuple[str, ...]) -> Equilibrium:
        """Return the result for the unknowns that were found, shape (l,)."""
        wanted = self.wanted
        values = dict(zip(wanted.symbols, z.tolist(), strict=True))
        x = self.at(z[None]).x[0]
        return Equilibrium(
            values=values,
            initial_conditions=dict(zip(self.definition.states, x.tolist(), strict=True)),
            constants={wanted.symbols[k]: float(z[k]) for k in wanted.of("constants")[0]},
            specifieds={wanted.symbols[k]: float(z[k]) for k in wanted.of("specifieds")[0]},
            state=x,
            residual=largest,
            free=free,
            given={s: value for s, value in self.given.items() if s not in values},
        )


def _bounds(
    definition: Definition, wanted: Unknowns, bounds: Mapping[Any, Any] | None
) -> tuple[np.ndarray, np.ndarray]:
    low = np.full(len(wanted.symbols), -np.inf)
    high = -low
    given = check_mapping("bounds", bounds)
    places = [located(definition, key, "bounds") for key in given]
    refuse_twice([definition.places[kind].symbols[k] for kind, k in places], "bounds")
    for place, (key, pair) in zip(places, given.items(), strict=True):
        if place not in wanted.order:
            raise ValueError(f"`bounds` has the key `{key}`, which is not one of `unknowns`.")
        k = wanted.order.index(place)
        low[k], high[k] = limits(pair, f"`bounds[{key}]`")
    return low, high


def find_equilibrium(
    problem: Problem,
    unknowns: Iterable[Any] | None = None,
    given: Mapping[Any, Any] | None = None,
    bounds: Mapping[Any, Any] | None = None,
    moving: Iterable[Any] = (),
) -> Equilibrium:
    """Find an equilibrium of a Problem; see `System.find_equilibrium`."""
    warn_of_missing_derivatives(problem)
    residual = EquilibriumResidual(problem, unknowns, given, moving)
    limits = _bounds(problem.definition, residual.wanted, bounds)
    return residual.equilibrium(*residual.solved(residual.start, limits))
