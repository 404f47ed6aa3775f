"""Evaluate a problem at many states: values, derivatives, and natural sizes.

Derivatives by the states are exact (`EvaluationPoints.slopes`), except for specifieds that are
Python functions of the state, such as controllers: their derivatives are differences (`feedback`).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Self

import numpy as np

from pydy._assembly import Assembly, Definition, kinetic_hessian
from pydy._checks import SymbolIndex
from pydy._forks import cached_property
from pydy._graph import jacobian, sizes_of_terms
from pydy._kernel import Kernel
from pydy._mechanics import BodyDynamics
from pydy._problem import Problem, StateSamples
from pydy._rank import HALF, OF_FEW, ROUNDING, equilibrated, is_zero, or_one
from pydy._states.dependence import independent_columns_of, tangents
from pydy.codegen import SpecifiedsPlan

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, SymbolOrName

GROUPS = {"states": "x", "specifieds": "r", "constants": "p"}
"""The kinds of symbols, and the arrays that hold their numbers."""

_DECADES = 10  # of step sizes in finite differences
_OF_NUMBERS = {"sin", "cos", "tan", "exp", "sinh", "cosh", "tanh"}  # functions without units


def located(
    definition: Definition,
    symbol: SymbolOrName,
    argument: str,
    kinds: Iterable[str] = GROUPS,
    description: str = "states, constants and specifieds of the system",
) -> tuple[str, int]:
    """Return the kind of a symbol or name (state, constant or specified) and its index there."""
    for kind in kinds:
        index = definition.places[kind].get(symbol, argument)
        if index is not None:
            return kind, index
    everything = [s for kind in kinds for s in definition.places[kind].symbols]
    SymbolIndex(everything, description).find(symbol, argument)  # raises, with names that are alike
    raise AssertionError(symbol)


def members(
    definition: Definition,
    keys: Iterable[SymbolOrName],
    excluded: Mapping[str, Iterable[AnySymbol]] | None = None,
) -> list[AnySymbol]:
    """Replace names of groups by their symbols, except those in `excluded`."""
    symbols: list[AnySymbol] = []
    for key in keys:
        if isinstance(key, str) and key in GROUPS:
            left_out = set((excluded or {}).get(key, ()))
            symbols += [s for s in definition.places[key].symbols if s not in left_out]
        else:
            symbols.append(key)
    return symbols


@dataclass(frozen=True, eq=False)
class EvaluationPoints(StateSamples):
    """States, times, inputs and constants at m points."""

    plan: SpecifiedsPlan

    @cached_property
    def input_feedback(self) -> np.ndarray:
        """The derivatives of Python functions among the specifieds by the states, (m, s, n)."""
        return feedback(self.plan, self.x, self.t)

    def alone(self) -> list[Self]:
        """Return batches with one p each: this one, or each state separately."""
        if self.p.ndim == 1:
            return [self]
        return [replace(self.subset([k]), p=p) for k, p in enumerate(self.p)]

    def tried(self, kernel: Kernel) -> np.ndarray:
        """Return the outputs of a Kernel, shape (m, o); NaN where singular."""
        parts = [kernel.evaluate(at.t, at.x, at.r, at.p) for at in self.alone()]
        out, failed = (np.concatenate(part) for part in zip(*parts, strict=True))
        return np.where(failed[:, None], np.nan, out) if failed.any() else out

    def value(self, kernel: Kernel, width: int | None = None) -> np.ndarray:
        """Return the outputs of a Kernel, reshaped to rows of `width` columns."""
        out = self.tried(kernel) if self.p.ndim > 1 else self.evaluate(kernel)
        return out if width is None else out.reshape(len(self.x), -1, width)

    @cached_property
    def natural(self) -> dict[str, np.ndarray]:
        """The natural sizes of angles and similar arguments, (m, n) by kind; 0 for other inputs."""
        sizes, m = self.model.assembly.sizes, len(self.x)
        r = np.broadcast_to(self.r, (m, self.r.shape[1]))
        numbers = replace(self, r=r, p=np.atleast_2d(self.p)[0])
        slopes = numbers.interpret(_arguments)["slopes"].reshape(m, -1, sum(sizes))
        steepest = np.abs(slopes).max(axis=1, initial=0.0)
        finite = (steepest > 0.0) & np.isfinite(steepest)
        natural = np.where(finite, 1.0 / np.where(finite, steepest, 1.0), 0.0)
        return dict(zip(GROUPS, np.split(natural, np.cumsum(sizes)[:-1], axis=1), strict=True))

    def inertias(self) -> np.ndarray:
        """Return the diagonal of the mass matrix of all speeds, shape (m, n)."""
        masses = self.interpret(_masses)["masses"]
        if not masses.size:
            masses = self.interpret(ForcesWithoutConstraints(self.definition))["masses"]
        sizes: np.ndarray = np.abs(masses)
        return sizes

    def steepness(self, block: str) -> np.ndarray:
        """Return the sizes of a block's derivatives by the states, without feedback."""
        slopes = self.tried(self.model.compiled_jacobian(block, "x"))
        sizes: np.ndarray = np.abs(np.nan_to_num(slopes)).reshape(len(self.x), -1, self.x.shape[1])
        return sizes

    @cached_property
    def motions(self) -> np.ndarray:
        """The rates of coordinates and speeds in motions of unit energy, shape (m, n)."""
        first, n = (len(getattr(self.definition.equations, s)) for s in ("coordinates", "speeds"))
        masses, moving = self.inertias(), slice(first, first + n)
        speeds = np.where(masses > 0.0, 1.0 / np.sqrt(or_one(masses)), 0.0)
        if "velocity" in self.blocks and not speeds.all():
            slopes = self.steepness("velocity")[:, :, moving]
            for _ in range(n):  # along chains
                rows = (slopes * speeds[:, None]).max(axis=2, initial=0.0)
                with np.errstate(over="ignore"):  # divisors may be rounding errors of zeros
                    shares = rows[:, :, None] / or_one(slopes)
                driven = _least(shares * (slopes > 0.0), 1)
                speeds = np.where(speeds > 0.0, speeds, driven)
        speeds = or_one(speeds)
        slopes = self.interpret(_kinematics)["kinematics"].reshape(len(self.x), first, n)
        rates = np.abs(np.nan_to_num(slopes)) @ speeds[:, :, None]
        return np.concatenate([rates[:, :, 0], speeds], axis=1)

    def slopes(self, block: str) -> np.ndarray:
        """Return the derivatives of a block by the states, with all feedback."""
        direct = self.value(self.model.compiled_jacobian(block, "x"), self.x.shape[1])
        if not self.input_feedback.any():
            return direct
        by_input = self.value(self.model.compiled_jacobian(block, "r"), self.r.shape[1])
        input_feedback = self.input_feedback
        with np.errstate(all="ignore"):
            total: np.ndarray = direct + by_input @ input_feedback
        return total

    def directional(self, block: str, T: np.ndarray) -> np.ndarray:
        """Return the derivatives of a block along columns T; callers report nonfinite values."""
        slopes = self.slopes(block)
        with np.errstate(all="ignore"):
            moved: np.ndarray = slopes @ T
        return moved

    @property
    def blocks(self) -> list[str]:
        """The blocks of constraints that are not empty."""
        constraints = self.definition.equations.constraints
        return [b for b in ("holonomic", "velocity") if getattr(constraints, b)]

    def tangents(self) -> tuple[np.ndarray, np.ndarray]:
        """Return T, shape (m, n, k), and the columns of the independent states."""
        # Coordinates first: in one linear system with the speeds, the choice of dependent states
        # would depend on the unit of time.
        definition, n = self.definition, self.x.shape[1]
        equations, moving = definition.equations, n - len(definition.auxiliaries)
        first = len(equations.coordinates)
        kinds = {"holonomic": range(first), "velocity": range(first, moving)}
        dependent = (*equations.dependents.coordinates, *equations.dependents.speeds)
        chosen = [definition.states.index(state) for state in dependent]
        free = np.arange(moving)  # integrals of outputs move nothing
        T = np.broadcast_to(np.eye(n)[:, :moving], (len(self.x), n, moving))
        for block in self.blocks:
            gradient = self.slopes(block)
            with np.errstate(all="ignore"):
                rows, columns = self._units(block, gradient, kinds[block])
                moved, units = gradient / rows @ T, columns[:, free]
            of_kind = np.flatnonzero(np.isin(free, kinds[block]))
            named = np.flatnonzero(np.isin(free[of_kind], chosen))
            scaled = moved[0][:, of_kind] * units[0, of_kind]
            bound = of_kind[independent_columns_of(scaled, named.tolist())[1]]
            remaining = np.setdiff1d(np.arange(len(free)), bound)
            T, free = T @ tangents(moved, remaining, bound, units), free[remaining]
        return T, free

    def _units(
        self, block: str, gradient: np.ndarray, columns_of_kind: range
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return units of the rows (m, c, 1) of a block's gradient, and of the states (m, n)."""
        # A row that vanishes in a singular configuration consists of rounding errors: its size is
        # evaluated at a nearby state.
        n, coordinate_count = gradient.shape[2], len(self.definition.equations.coordinates)
        large = np.maximum(np.abs(self.x), self.natural["states"])
        motions = np.concatenate([at.motions for at in self.alone()])
        columns = equilibrated(
            gradient[:, :, :coordinate_count], units=motions[:, :coordinate_count]
        )[2][:, 0]
        shares = large[:, :coordinate_count] / columns
        share = shares.max(axis=1, keepdims=True, initial=0.0)
        usual = or_one(share) * columns
        large[:, :coordinate_count] = np.where(
            is_zero(shares, share), usual, large[:, :coordinate_count]
        )
        # In the singular configuration the gradient is rounding errors, far below 1e-3.
        offset = 1e-3 * large * np.cos(np.arange(n))
        neighbour = replace(self, x=self.x + offset)
        moved = neighbour.value(self.model.compiled_jacobian(block, "x"), n)
        largest = np.maximum(np.abs(gradient), np.nan_to_num(np.abs(moved), posinf=0.0))
        units = np.ones((len(self.x), n))
        _, rows, columns = equilibrated(
            largest[..., columns_of_kind], True, motions[:, columns_of_kind]
        )
        units[:, columns_of_kind] = columns[:, 0]
        return rows, units


def point_at(problem: Problem, times: np.ndarray, states: np.ndarray) -> EvaluationPoints:
    """Return the states (m, n) of a System at its numbers."""
    x = np.ascontiguousarray(states)
    r = np.broadcast_to(problem.inputs.rows(x, times), (len(x), len(problem.plan.symbols)))
    return EvaluationPoints(problem.definition, problem.code, times, x, r, problem.p, problem.plan)


def energetic_motions(
    problem: Problem, times: np.ndarray, states: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return least sizes of coordinates, and of changes at one energy; 0 if unknown."""
    m, q = len(states), len(problem.definition.equations.coordinates)
    at = point_at(problem, times, states)
    masses = at.inertias()
    has_mass = masses > 0.0
    speeds = np.where(has_mass, 1.0 / np.sqrt(np.where(has_mass, masses, 1.0)), 0.0)
    table = np.abs(at.interpret(_kinematics)["kinematics"].reshape(m, q, -1))
    moved = np.concatenate([(table * speeds[:, None]).max(axis=2, initial=0.0), speeds], axis=1)
    angles = at.natural["states"][:, :q]
    kinematic_sizes = _least((angles[:, :, None] / or_one(table)) * (table > 0.0), 1)
    # Auxiliary states, the integrals of outputs, come last; their size is unknown.
    unknown_sizes = np.zeros((m, states.shape[1] - moved.shape[1]))
    natural = np.concatenate([angles, kinematic_sizes, unknown_sizes], axis=1)
    return _least(natural, 0), _least(np.concatenate([moved, unknown_sizes], axis=1), 0)


def _least(values: np.ndarray, axis: int) -> np.ndarray:
    """Return the smallest nonzero entry along an axis, or zero if all are zero."""
    smallest = np.where(values > 0.0, values, np.inf).min(axis=axis, initial=np.inf)
    return np.where(np.isinf(smallest), 0.0, smallest)


def _kinematics(assembly: Assembly) -> dict[str, list[int]]:
    """Return the derivatives of the coordinates' rates by the speeds."""
    graph, speeds = assembly.graph, assembly.speeds
    first = graph.args[speeds[0]][1] if speeds else 0
    return {"kinematics": jacobian(graph, assembly.blocks.rates[:first], speeds).flat()}


def _masses(assembly: Assembly) -> dict[str, list[int]]:
    """Return the diagonal of the mass matrix of all speeds, or nothing if there is none yet."""
    return {"masses": kinetic_hessian(assembly)[:: len(assembly.speeds) + 1]}


@dataclass(frozen=True)
class ForcesWithoutConstraints:
    """The masses and forces at all speeds without constraints."""

    definition: Definition

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        """Return the diagonal of the mass matrix, and the sizes of the terms of forces."""
        g, n = assembly.graph, len(assembly.speeds)
        body = self.definition.equations.multibody
        if body is None:
            masses = assembly.blocks.mass_matrix[:: n + 1] or [g.one] * n
            return {"masses": masses, "forces": sizes_of_terms(g, assembly.blocks.forcing)}
        dynamics = BodyDynamics(None, self.definition.outputs.forces, {})
        forces = assembly.read(
            dynamics.inverse_dynamics(body).expressions(), "the forces", sizes=True
        )
        matrix = dynamics.mass_matrix(body).expressions()
        masses = assembly.read(matrix[:: n + 1], "the mass matrix", sizes=True)
        return {"masses": masses, "forces": sizes_of_terms(g, forces)}


def _arguments(assembly: Assembly) -> dict[str, list[int]]:
    """Return the derivatives of the arguments of functions like the sine by all inputs."""
    g, blocks = assembly.graph, assembly.blocks
    reached = g.reachable([*blocks.rates, *blocks.holonomic, *blocks.velocity])
    inner = sorted({g.operands(n)[0] for n in reached if g.ops[n] in _OF_NUMBERS})
    inputs = [
        g.input(kind, k)
        for kind, size in zip("xrp", assembly.sizes, strict=True)
        for k in range(size)
    ]
    return {"slopes": jacobian(g, inner, inputs).flat()}


def feedback(plan: SpecifiedsPlan, x: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Return the derivatives of Python functions by the states, (m, s, n), by differences."""
    # A function of micrometres may change completely within a micrometre: shorter steps are tried
    # if half the step gives another result, longer ones if rounding errors dominate.
    m, n = x.shape
    slopes = np.zeros((m, len(plan.symbols), n))
    for k in range(n if plan.inputs.functions else 0):
        # Ten decades in both directions from one: a state may be zero except for rounding.
        begin = size = np.cbrt(ROUNDING) * np.maximum(np.abs(x[:, k]), 1.0)
        least = np.full((m, len(plan.symbols)), np.inf)
        for _ in range(_DECADES):
            slope, rounding, missed = _central(plan, x, t, k, size)
            better = ((missed < least) & (least > HALF)) | np.isinf(least)
            slopes[:, :, k] = np.where(better, slope, slopes[:, :, k])
            least = np.fmin(least, missed)
            if (least <= HALF).all():
                break
            size = 0.1 * size
        slope, error, missed = _central(plan, x, t, k, begin)
        size = begin
        for _ in range(_DECADES):
            unsure = (missed == 0.0) & (error > HALF * np.abs(slope))
            if not unsure.any():
                break
            size = 10.0 * size
            longer, rounding, missed = _central(plan, x, t, k, size)
            agrees = unsure & (missed <= HALF) & (np.abs(longer - slope) <= error)
            slopes[:, :, k] = np.where(agrees, longer, slopes[:, :, k])
            slope, error = np.where(agrees, longer, slope), np.where(agrees, rounding, 0.0)
    return slopes


def _central(
    plan: SpecifiedsPlan, x: np.ndarray, t: np.ndarray, k: int, size: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return central differences by state k, their rounding and truncation errors, (m, s)."""
    differences = []
    for share in (1.0, 0.5):
        step = np.zeros_like(x)
        step[:, k] = share * size
        ahead, behind = x + step, x - step
        width = (ahead - behind)[:, k, None]
        after, before = plan.inputs.rows(ahead, t), plan.inputs.rows(behind, t)
        largest = np.maximum(np.abs(after), np.abs(before))
        differences.append(((after - before) / width, OF_FEW * largest / width))
    (slope, rounding), (halved, _) = differences
    discrepancy, largest = np.abs(slope - halved), np.maximum(np.abs(slope), np.abs(halved))
    missed = np.where(
        discrepancy <= rounding, 0.0, discrepancy / np.where(largest > 0.0, largest, 1.0)
    )
    return slope, rounding, missed
