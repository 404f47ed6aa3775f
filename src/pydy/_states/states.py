"""Evaluate a problem at many states: values, derivatives, and natural sizes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np

from pydy._assembly import Assembly, Definition
from pydy._checks import Places
from pydy._forks import cached_property
from pydy._graph import jacobian, sizes_of_terms
from pydy._kernel import Kernel
from pydy._mechanics import BodyDynamics
from pydy._problem import Problem, StateSamples
from pydy._rank import HALF, OF_FEW, ROUNDING, equilibrated, is_zero, or_one
from pydy._states.dependence import independent_places, tangents
from pydy.codegen import SpecifiedsPlan

GROUPS = {"states": "x", "specifieds": "r", "constants": "p"}
"""The kinds of symbols, and the arrays that hold their numbers."""

# Decades of steps of differences that are tried.
_DECADES = 10
_OF_NUMBERS = {"sin", "cos", "tan", "exp", "sinh", "cosh", "tanh"}  # functions of what has no unit


def located(
    definition: Definition,
    symbol: Any,
    argument: str,
    kinds: Iterable[str] = GROUPS,
    what: str = "states, constants and specifieds of the system",
) -> tuple[str, int]:
    """Return the kind of a symbol or name, a state, constant or specified, and its place there."""
    for kind in kinds:
        place = definition.places[kind].get(symbol, argument)
        if place is not None:
            return kind, place
    everything = [s for kind in kinds for s in definition.places[kind].symbols]
    Places(everything, what).find(symbol, argument)  # raises, with names that are alike
    raise AssertionError(symbol)


def members(
    definition: Definition, keys: Iterable[Any], without: Mapping[str, Iterable[Any]] | None = None
) -> list[Any]:
    """Replace names of groups by their symbols, with the exception of some."""
    found: list[Any] = []
    for key in keys:
        if isinstance(key, str) and key in GROUPS:
            left_out = set((without or {}).get(key, ()))
            found += [s for s in definition.places[key].symbols if s not in left_out]
        else:
            found.append(key)
    return found


@dataclass(frozen=True, eq=False)
class Point(StateSamples):
    """States, times and numbers at m points; additions to specifieds are inputs."""

    plan: SpecifiedsPlan

    @cached_property
    def through(self) -> np.ndarray:
        """How Python functions among the specifieds change with the states, shape (m, s, n)."""
        return feedback(self.plan, self.x, self.t)

    def alone(self) -> list[Self]:
        """Return points with one p each: this one, or every state by itself."""
        if self.p.ndim == 1:
            return [self]
        return [replace(self.subset([k]), p=p) for k, p in enumerate(self.p)]

    def tried(self, kernel: Kernel) -> np.ndarray:
        """Return the outputs of a Kernel, shape (m, o); NaN where singular."""
        parts = [kernel.evaluate(at.t, at.x, at.r, at.p) for at in self.alone()]
        out, failed = (np.concatenate(part) for part in zip(*parts, strict=True))
        return np.where(failed[:, None], np.nan, out) if failed.any() else out

    def value(self, kernel: Kernel, width: int | None = None) -> np.ndarray:
        """Return the outputs of a Kernel, in rows of so many columns."""
        out = self.tried(kernel) if self.p.ndim > 1 else self.evaluate(kernel)
        return out if width is None else out.reshape(len(self.x), -1, width)

    @cached_property
    def natural(self) -> dict[str, np.ndarray]:
        """The natural size of states inside sines and the like, (m, n) by kind; 0 for others."""
        sizes, m = self.model.assembly.sizes, len(self.x)
        r = np.broadcast_to(self.r, (m, self.r.shape[1]))
        numbers = replace(self, r=r, p=np.atleast_2d(self.p)[0])
        slopes = numbers.interpret(_arguments)["slopes"].reshape(m, -1, sum(sizes))
        steepest = np.abs(slopes).max(axis=1, initial=0.0)
        known = (steepest > 0.0) & np.isfinite(steepest)
        natural = np.where(known, 1.0 / np.where(known, steepest, 1.0), 0.0)
        return dict(zip(GROUPS, np.split(natural, np.cumsum(sizes)[:-1], axis=1), strict=True))

    def inertias(self) -> np.ndarray:
        """Return the diagonal of the mass matrix of all speeds, shape (m, n)."""
        found = self.interpret(_masses)["masses"]
        if not found.size:
            found = self.interpret(ForcesWithoutConstraints(self.definition))["masses"]
        sizes: np.ndarray = np.abs(found)
        return sizes

    def steepness(self, block: str) -> np.ndarray:
        """Return the sizes of a block's derivatives by the states, without feedback."""
        slopes = self.tried(self.model.compiled_jacobian(block, "x"))
        sizes: np.ndarray = np.abs(np.nan_to_num(slopes)).reshape(len(self.x), -1, self.x.shape[1])
        return sizes

    @cached_property
    def motions(self) -> np.ndarray:
        """How fast coordinates and speeds change in motions of one energy, shape (m, n)."""
        first, n = (len(getattr(self.definition.equations, s)) for s in ("coordinates", "speeds"))
        masses, moving = self.inertias(), slice(first, first + n)
        speeds = np.where(masses > 0.0, 1.0 / np.sqrt(or_one(masses)), 0.0)
        if "velocity" in self.blocks and not speeds.all():
            slopes = self.steepness("velocity")[:, :, moving]
            for _ in range(n):  # along chains
                rows = (slopes * speeds[:, None]).max(axis=2, initial=0.0)
                with np.errstate(over="ignore"):  # by what is left of zeros
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
        if not self.through.any():
            return direct
        by_input = self.value(self.model.compiled_jacobian(block, "r"), self.r.shape[1])
        through = self.through
        with np.errstate(all="ignore"):
            whole: np.ndarray = direct + by_input @ through
        return whole

    def along(self, block: str, T: np.ndarray) -> np.ndarray:
        """Return the derivatives of a block along columns T; callers report nonfinite values."""
        slopes = self.slopes(block)
        with np.errstate(all="ignore"):
            moved: np.ndarray = slopes @ T
        return moved

    @property
    def blocks(self) -> list[str]:
        """The constraints there are."""
        constraints = self.definition.equations.constraints
        return [b for b in ("holonomic", "velocity") if getattr(constraints, b)]

    def tangents(self) -> tuple[np.ndarray, np.ndarray]:
        """Return T, shape (m, n, k), and the places of the independent states."""
        # Coordinates first: in one system with speeds, units of time would decide what is bound.
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
            own = np.flatnonzero(np.isin(free, kinds[block]))
            named = np.flatnonzero(np.isin(free[own], chosen))
            scaled = moved[0][:, own] * units[0, own]
            bound = own[independent_places(scaled, named.tolist())[1]]
            left = np.setdiff1d(np.arange(len(free)), bound)
            T, free = T @ tangents(moved, left, bound, units), free[left]
        return T, free

    def _units(self, block: str, gradient: np.ndarray, own: range) -> tuple[np.ndarray, np.ndarray]:
        """Return units of the rows (m, c, 1) of a block's gradient, and of the states (m, n)."""
        # A row that vanishes in a singular configuration is rounding errors there: its size is
        # taken beside it.
        n, places = gradient.shape[2], len(self.definition.equations.coordinates)
        large = np.maximum(np.abs(self.x), self.natural["states"])
        motions = np.concatenate([at.motions for at in self.alone()])
        columns = equilibrated(gradient[:, :, :places], units=motions[:, :places])[2][:, 0]
        shares = large[:, :places] / columns
        share = shares.max(axis=1, keepdims=True, initial=0.0)
        usual = or_one(share) * columns
        large[:, :places] = np.where(is_zero(shares, share), usual, large[:, :places])
        # In a singular configuration itself the gradient is rounding errors, far below 1e-3.
        offset = 1e-3 * large * np.cos(np.arange(n))
        beside = replace(self, x=self.x + offset)
        moved = beside.value(self.model.compiled_jacobian(block, "x"), n)
        both = np.maximum(np.abs(gradient), np.nan_to_num(np.abs(moved), posinf=0.0))
        units = np.ones((len(self.x), n))
        _, rows, columns = equilibrated(both[..., own], True, motions[:, own])
        units[:, own] = columns[:, 0]
        return rows, units


def point_at(problem: Problem, times: np.ndarray, states: np.ndarray) -> Point:
    """Return the states (m, n) of a System at its numbers."""
    x = np.ascontiguousarray(states)
    r = np.broadcast_to(problem.inputs.rows(x, times), (len(x), len(problem.plan.symbols)))
    return Point(problem.definition, problem.code, times, x, r, problem.p, problem.plan)


def energetic_motions(
    problem: Problem, times: np.ndarray, states: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return least sizes of coordinates, and of changes at one energy; 0 if unknown."""
    m, q = len(states), len(problem.definition.equations.coordinates)
    at = point_at(problem, times, states)
    masses = at.inertias()
    known = masses > 0.0
    speeds = np.where(known, 1.0 / np.sqrt(np.where(known, masses, 1.0)), 0.0)
    table = np.abs(at.interpret(_kinematics)["kinematics"].reshape(m, q, -1))
    moved = np.concatenate([(table * speeds[:, None]).max(axis=2, initial=0.0), speeds], axis=1)
    angles = at.natural["states"][:, :q]
    own = _least((angles[:, :, None] / or_one(table)) * (table > 0.0), 1)
    # Auxiliary states, the integrals of outputs, come last; nothing tells their size.
    rest = np.zeros((m, states.shape[1] - moved.shape[1]))
    natural = np.concatenate([angles, own, rest], axis=1)
    return _least(natural, 0), _least(np.concatenate([moved, rest], axis=1), 0)


def _least(values: np.ndarray, axis: int) -> np.ndarray:
    """Return the smallest nonzero entry along an axis, or zero if all are zero."""
    found = np.where(values > 0.0, values, np.inf).min(axis=axis, initial=np.inf)
    return np.where(np.isinf(found), 0.0, found)


def _kinematics(assembly: Assembly) -> dict[str, list[int]]:
    """Return the derivatives of the coordinates' rates by the speeds."""
    graph, speeds = assembly.graph, assembly.speeds
    first = graph.args[speeds[0]][1] if speeds else 0
    return {"kinematics": jacobian(graph, assembly.rates[:first], speeds).flat()}


def _masses(assembly: Assembly) -> dict[str, list[int]]:
    """Return the diagonal of the mass matrix of all speeds, or nothing where none is known yet."""
    return {"masses": assembly.kinetic_hessian[:: len(assembly.speeds) + 1]}


@dataclass(frozen=True)
class ForcesWithoutConstraints:
    """The masses and forces at all speeds as if no constraint held them."""

    definition: Definition

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        """Return the diagonal of the mass matrix, and how large the terms of forces are."""
        g, n = assembly.graph, len(assembly.speeds)
        body = self.definition.equations.multibody
        if body is None:
            masses = assembly.mass_matrix[:: n + 1] or [g.one] * n
            return {"masses": masses, "forces": sizes_of_terms(g, assembly.forcing)}
        dynamics = BodyDynamics(None, self.definition.forces, {})
        forces = assembly.read(
            dynamics.inverse_dynamics(body).expressions(), "the forces", sizes=True
        )
        matrix = dynamics.mass_matrix(body).expressions()
        masses = assembly.read(matrix[:: n + 1], "the mass matrix", sizes=True)
        return {"masses": masses, "forces": sizes_of_terms(g, forces)}


def _arguments(assembly: Assembly) -> dict[str, list[int]]:
    """Return the derivatives of the arguments of functions like the sine by all inputs."""
    g = assembly.graph
    reached = g.reachable([*assembly.rates, *assembly.holonomic, *assembly.velocity])
    inner = sorted({g.operands(n)[0] for n in reached if g.ops[n] in _OF_NUMBERS})
    inputs = [
        g.input(kind, k)
        for kind, size in zip("xrp", assembly.sizes, strict=True)
        for k in range(size)
    ]
    return {"slopes": jacobian(g, inner, inputs).flat()}


def feedback(plan: SpecifiedsPlan, x: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Return how specifieds that are functions change with states, (m, s, n), by differences."""
    # A function of micrometres may be anything a micrometre away: where half the step has another
    # result, shorter ones are tried; where rounding is all that is left, longer ones.
    m, n = x.shape
    slopes = np.zeros((m, len(plan.symbols), n))
    for k in range(n if plan.inputs.functions else 0):
        # Ten decades both ways from one: a state may be zero but for rounding.
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
        slope, known, missed = _central(plan, x, t, k, begin)
        size = begin
        for _ in range(_DECADES):
            unsure = (missed == 0.0) & (known > HALF * np.abs(slope))
            if not unsure.any():
                break
            size = 10.0 * size
            longer, rounding, missed = _central(plan, x, t, k, size)
            agrees = unsure & (missed <= HALF) & (np.abs(longer - slope) <= known)
            slopes[:, :, k] = np.where(agrees, longer, slopes[:, :, k])
            slope, known = np.where(agrees, longer, slope), np.where(agrees, rounding, 0.0)
    return slopes


def _central(
    plan: SpecifiedsPlan, x: np.ndarray, t: np.ndarray, k: int, size: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return central differences by state k, their rounding and truncation errors, (m, s)."""
    found = []
    for share in (1.0, 0.5):
        step = np.zeros_like(x)
        step[:, k] = share * size
        ahead, behind = x + step, x - step
        width = (ahead - behind)[:, k, None]
        after, before = plan.inputs.rows(ahead, t), plan.inputs.rows(behind, t)
        largest = np.maximum(np.abs(after), np.abs(before))
        found.append(((after - before) / width, OF_FEW * largest / width))
    (slope, rounding), (halved, _) = found
    apart, largest = np.abs(slope - halved), np.maximum(np.abs(slope), np.abs(halved))
    missed = np.where(apart <= rounding, 0.0, apart / np.where(largest > 0.0, largest, 1.0))
    return slope, rounding, missed
