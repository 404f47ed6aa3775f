"""Warn where rates are linearised at a kink, or in a branch that holds for one state alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from pydy._assembly import Assembly
from pydy._errors import warn_user
from pydy._graph import Branches, jacobian, rounding_bounds
from pydy._judges.discontinuities import (
    has_any,
    inputs_of_groups,
    loads_and_rates,
    switched_blocks,
)
from pydy._problem import StateSamples
from pydy._rank import HALF, ROUNDING


def warn_of_kinks(
    at: StateSamples, T: np.ndarray, free: np.ndarray, columns: Sequence[int]
) -> None:
    """Warn of the first state at which the rates to be linearised have a kink or jump.

    The variables are the tangents T, (m, n, k), of the `free` states, and the specifieds in
    `columns`.
    """
    definition, (m, n, _) = at.definition, T.shape
    parts = DerivativeDiscontinuities(len(definition.equations.coordinates))
    if not has_any(at, parts):
        return
    values, columns, w = at.interpret(parts), [*columns], len(definition.specifieds)
    near = np.abs(values["switches"]) <= ROUNDING * values["bounds"]
    count, width = near.shape[1], values["nodes"].shape[1]
    steps = np.abs(values["steps"].reshape(m, count, width))
    steps[steps <= HALF * np.abs(values["nodes"])[:, None]] = 0.0
    symbols = [*(definition.states[j] for j in free), *(definition.specifieds[j] for j in columns)]

    def by_variables(block: str, k: int, *shape: int) -> np.ndarray:
        slopes = values[block][k].reshape(*shape, n + w)
        with np.errstate(all="ignore"):  # non-finite values are reported where they are used
            return np.concatenate([slopes[..., :n] @ T[k], slopes[..., n:][..., columns]], axis=-1)

    for k in map(int, np.flatnonzero(near.any(axis=1))):
        of_switches = by_variables("switch_slopes", k, count)[near[k]]
        sides = by_variables("slopes", k, count, 2, width)[near[k]]
        kinks = _kinks_of_each(of_switches, steps[k, near[k]], sides)
        bending = _differ(*np.moveaxis(sides, 1, 0)).any(axis=(0, 1))
        if len(of_switches) > 1 or (not kinks and bending.any()):
            weights = _weights(involved=(of_switches != 0.0).any(axis=0) | bending)
            directions = _Directions.axes(T[k], columns, w).combined(weights)
            beside = _slopes_beside(at, k, directions, parts)
            kinks = _kinks_of_all(by_variables("returned", k, width), weights, beside, kinks)
        for kink in kinks[:1]:
            rate = definition.states[kink.rate]
            load = "load on" if rate in definition.equations.speeds else "rate of"
            point = [*at.x[k, free], *np.broadcast_to(at.r, (m, w))[k, columns]]
            place = ", ".join(f"{symbols[j]} = {point[j]:.6g}" for j in kink.variables)
            warn_user(
                f"There is no linear model for both sides of t = {at.t[k]:.6g}, {place}: the "
                f"{load} {rate} {kink.description}. What is returned takes one side. Linearize "
                "beside it, or give a smooth expression."
            )
            return


class _Kink(NamedTuple):
    """A kink or jump of a rate by some of the variables."""

    rate: int
    variables: list[int]
    description: str

    @classmethod
    def with_slopes(cls, rate: int, variable: int, above: float, below: float) -> _Kink:
        """Return a kink at which both sides have different slopes by a variable."""
        description = f"has the slope {above:.3g} on one side by it and {below:.3g} on the other"
        return cls(rate, [variable], description)


def _kinks_of_each(of_switches: np.ndarray, steps: np.ndarray, sides: np.ndarray) -> list[_Kink]:
    """Return the kinks and jumps that each switch makes alone.

    From the slopes of the switches, (switches, variables), the steps of the rates, (switches,
    rates), and the slopes on their two sides, (switches, 2, rates, variables).
    """
    kinks = []
    for of_switch, jumps, (above, below) in zip(of_switches, steps, sides, strict=True):
        turns = (_differ(above, below) | (jumps > 0.0)[:, None]) & (of_switch != 0.0)
        for i, j in np.argwhere(turns).tolist():
            kinks.append(
                _Kink(i, [j], f"jumps by {jumps[i]:.3g}")
                if jumps[i]
                else _Kink.with_slopes(i, j, above[i, j], below[i, j])
            )
    return kinks


def _differ(above: np.ndarray, below: np.ndarray) -> np.ndarray:
    """Return where the slopes on two sides differ."""
    differ: np.ndarray = np.abs(above - below) > HALF * np.maximum(np.abs(above), np.abs(below))
    return differ


def _weights(involved: np.ndarray) -> np.ndarray:
    """Return weights of variables, one row a direction: each alone, then random sums of some.

    The sums find kinks that no variable alone meets, as Abs(z)*sign(x) has at x = z = 0.
    """
    alone = np.eye(len(involved))
    sums = np.random.default_rng(0).uniform(-1.0, 1.0, alone.shape) * involved
    return np.concatenate([alone, sums])


def _kinks_of_all(
    returned: np.ndarray,
    weights: np.ndarray,
    beside: tuple[np.ndarray, np.ndarray, np.ndarray],
    of_each: list[_Kink],
) -> list[_Kink]:
    """Return the kinks that all switches at a state make together.

    The slopes on both sides and their errors, each (rates, directions), replace what each switch
    makes alone, where they are known. Along no direction they may differ from the derivatives that
    are `returned`, (rates, variables).
    """
    above, below, error = beside
    count = returned.shape[1]
    alone = np.arange(len(weights)) < count
    with np.errstate(all="ignore"):
        linear, sizes = returned @ weights.T, np.abs(returned) @ np.abs(weights).T
        sizes = np.fmax(sizes, np.maximum(np.abs(above), np.abs(below)))
        known, least = error <= _SAME_SLOPE * sizes, np.maximum(4.0 * error, HALF * sizes)
        bends = known & (np.abs(above - below) > least)
        away = np.maximum(np.abs(above - linear), np.abs(below - linear)) > least
    kinks = [
        _Kink.with_slopes(i, j, above[i, j], below[i, j])
        for i, j in np.argwhere(bends[:, :count]).tolist()
    ]
    kinks += [kink for kink in of_each if not known[kink.rate, kink.variables].all()]
    for i, j in np.argwhere(known & away & ~(bends & alone)).tolist():
        if alone[j]:
            both = f"{above[i, j]:.3g} by it alone and {linear[i, j]:.3g}"
            kinks.append(_Kink(i, [j], f"has the slope {both} where others move with it"))
        else:
            moved = np.flatnonzero(weights[j]).tolist()
            steps = ", ".join(f"{weight:.3g}" for weight in weights[j, moved])
            sides = f"{above[i, j]:.3g} on one side and {below[i, j]:.3g} on the other"
            description = f"has the slope {sides} where they move by ({steps})"
            kinks.append(
                _Kink(i, moved, f"{description}, and {linear[i, j]:.3g} in what is returned")
            )
    return kinks


@dataclass(frozen=True)
class DerivativeDiscontinuities:
    """The switches of rates with rounding bounds, and the rates' derivatives on both sides.

    `returned` are the derivatives at the state itself, as a linear model takes them.
    """

    coordinates: int

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph, variables = assembly.graph, inputs_of_groups(assembly, "xr")
        nodes, searched = loads_and_rates(assembly, self.coordinates)
        switches, blocks = switched_blocks(assembly, nodes, searched, "xr", "tp", bends=True)
        both_sides = [
            n
            for switch in switches
            for side in Branches(graph, nodes).sides(switch, True)
            for n in side
        ]
        groups = {"switch_slopes": switches, "slopes": both_sides, "returned": blocks["nodes"]}
        slopes = {name: jacobian(graph, group, variables).flat() for name, group in groups.items()}
        return {**blocks, **slopes, "bounds": rounding_bounds(graph, switches)}


# Distances from a state to both sides. Whatever its unit is, neighbours among them are small beside
# natural lengths and large beside rounding errors, and give the same slope.
_DISTANCES = 2.0 ** -np.arange(4.0, 100.0, step=4.0)
_SAME_SLOPE = 2.0**-8  # an error of the first order changes sixteenfold between neighbours


@dataclass(frozen=True)
class _Directions:
    """Directions of the states, (directions, n), and of the specifieds, (directions, w)."""

    x: np.ndarray
    r: np.ndarray

    @classmethod
    def axes(cls, T: np.ndarray, columns: Sequence[int], specifieds: int) -> _Directions:
        """Return the tangents T, (n, k), then single specifieds."""
        n, k = T.shape
        x, r = np.zeros((k + len(columns), n)), np.zeros((k + len(columns), specifieds))
        x[:k] = T.T
        r[range(k, k + len(columns)), columns] = 1.0
        return cls(x, r)

    def combined(self, weights: np.ndarray) -> _Directions:
        """Return a weighted sum of these for each row of weights."""
        return _Directions(weights @ self.x, weights @ self.r)


def _beside(
    at: StateSamples,
    k: int,
    directions: _Directions,
    parts: Callable[[Assembly], dict[str, list[int]]],
    block: str,
) -> np.ndarray:
    """Return values beside state k, shape (directions, distances, sides, values)."""
    steps = _DISTANCES[:, None, None] * np.array([1.0, -1.0])[:, None]
    x = at.x[k] + directions.x[:, None, None] * steps
    specifieds = np.broadcast_to(at.r, (len(at.x), directions.r.shape[1]))[k]
    r = specifieds + directions.r[:, None, None] * steps
    count = x[..., 0].size
    samples = replace(at.subset(np.full(count, k)), x=x.reshape(count, -1), r=r.reshape(count, -1))
    return samples.interpret(parts)[block].reshape(*x.shape[:3], -1)


def _best(slopes: np.ndarray, rounding: np.ndarray | float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Return slopes and their errors, (values, directions), from those at all distances.

    `rounding` is that of the differences of values.
    """
    change = np.abs(np.diff(slopes, axis=1)) + rounding / _DISTANCES[1:, None]
    change[~np.isfinite(change)] = np.inf
    best = change.argmin(axis=1)[:, None]
    slope = np.take_along_axis(slopes, best + 1, axis=1)[:, 0].T
    return slope, np.take_along_axis(change, best, axis=1)[:, 0].T


@dataclass(frozen=True)
class _RoundingOfRates:
    """The rounding bounds of the rates, with loads for u' where these suffice."""

    coordinates: int

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        nodes, _ = loads_and_rates(assembly, self.coordinates)
        return {"bounds": rounding_bounds(assembly.graph, nodes)}


def _slopes_beside(
    at: StateSamples,
    k: int,
    directions: _Directions,
    parts: DerivativeDiscontinuities,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the rates' slopes on both sides of state k, and errors, each (rates, directions).

    By difference quotients; at a jump the errors are infinite, or larger than the slopes.
    """
    values, here = _beside(at, k, directions, parts, "nodes"), at.interpret(parts)["nodes"][k]
    of_rates = _RoundingOfRates(parts.coordinates)
    # Terms may be zero at the state itself.
    bounds = _beside(at, k, directions, of_rates, "bounds") + at.interpret(of_rates)["bounds"][k]
    with np.errstate(all="ignore"):
        (above, error_above), (below, error_below) = (
            _best(
                sign * (values[:, :, side] - here) / _DISTANCES[:, None],
                ROUNDING * bounds[:, 1:, side],
            )
            for side, sign in enumerate((1.0, -1.0))
        )
    return above, below, error_above + error_below


@dataclass(frozen=True)
class _ProtectedStates:
    """The rates, and conditions that are true at single states; see `warn_of_protected_states`."""

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:

        graph, rates = assembly.graph, assembly.blocks.rates
        conditions = Branches(graph, rates).protected_conditions()
        truths = [graph.call("select", n, graph.one, graph.zero) for n in conditions]
        return {"conditions": truths, "rates": [*rates] if conditions else []}


def warn_of_protected_states(
    at: StateSamples, T: np.ndarray, free: np.ndarray, A: np.ndarray
) -> None:
    """Warn of the first state at which a Piecewise protects the rates from a division by zero.

    In ``Piecewise((0, Eq(s, 0)), (tanh(s) v / s, True))``, with a sliding speed s, what stands at
    s = 0 has the slope zero by v, and both sides have the slope 1. The derivatives A, (m, k, k),
    are compared with difference quotients along the tangents T, (m, n, k), of the `free` states.
    """
    parts = _ProtectedStates()
    if not has_any(at, parts, "conditions"):
        return
    states, specifieds = at.definition.states, len(at.definition.specifieds)
    for k in map(int, np.flatnonzero(at.interpret(parts)["conditions"].any(axis=1))):
        rates = _beside(at, k, _Directions.axes(T[k], (), specifieds), parts, "rates")[..., free]
        with np.errstate(all="ignore"):
            slope, error = _best((rates[:, :, 0] - rates[:, :, 1]) / (2.0 * _DISTANCES[:, None]))
        largest = np.maximum(np.abs(slope), np.abs(A[k]))
        lost = (error <= _SAME_SLOPE * np.abs(slope)) & (np.abs(slope - A[k]) > HALF * largest)
        for row, column in np.argwhere(lost)[:1]:
            rate, state = (states[free[i]] for i in (row, column))
            speed = rate in at.definition.equations.speeds
            warn_user(
                f"At t = {at.t[k]:.6g}, {state} = {at.x[k, free[column]]:.6g} a Piecewise has a "
                f"branch for this state alone: the {'load on' if speed else 'rate of'} {rate} has "
                f"the slope {slope[row, column]:.3g} by {state} on both sides, but "
                f"{A[k][row, column]:.3g} is returned, that of the branch. Linearize beside it, or "
                "write it without a division by zero, for example with sqrt(v**2 + epsilon**2)."
            )
            return
