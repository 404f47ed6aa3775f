"""Verification of energies: minus the rate of a potential must be the power of its loads."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from pydy._graph import Branches, jacobian, rounding_bounds
from pydy._mechanics.equations import Equations
from pydy._mechanics.generic import Block, GenericStates
from pydy._mechanics.tuning import ACROSS, NEAR
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    import sympy as sm

_TRIALS = 3
_SEARCH_STARTS = (-41.0, 41.0)  # 6 revolutions from zero, or as many units of length


def is_potential_of(equations: Equations, potential: sm.Expr, powers: Sequence[sm.Expr]) -> bool:
    """Return whether ``d potential/dt = -sum(powers)``, on both sides of every switch."""
    states = GenericStates(equations, (potential, *powers), "the energy")
    energy, power_nodes = states.read(potential), states.read.all(powers)
    sums = [[*states.rates([energy]), *power_nodes]]
    blocks = [_with_bounds(states, sums), ("powers", (len(power_nodes),), power_nodes)]
    # The rate may be finite where the energy is not: the rate of atan(x/√-l) has no root.
    generic = list(states.samples([*blocks, ("energy", (), [energy])], _TRIALS))
    samples = [*generic]
    switching = Branches(states.graph, [energy, *power_nodes]).switches()
    # An integral of |sin(q)|, for instance, may be valid for some revolutions only.
    for far in _SEARCH_STARTS if switching else ():
        near = dict.fromkeys(equations.coordinates, far)
        samples += states.consistent_samples(blocks, _TRIALS, near=near)
    for switch in switching:
        across = list(_across_switch(states, switch, blocks))
        if across and _jumps(states, switch, energy):
            return False
        samples += across
    if not (generic and all(_small(sample["pairs"], sums) for sample in samples)):
        return False
    # A one-sided load that acts at none of the states must have an energy with a switch.
    acting = np.any([sample["powers"] for sample in samples], axis=0).tolist()
    inactive = [n for n, acts in zip(power_nodes, acting, strict=True) if not acts]
    return not Branches(states.graph, inactive).switches() or bool(
        Branches(states.graph, [energy]).switches()
    )


def has_momenta_of(equations: Equations, lagrangian: sm.Expr, kinetic: sm.Expr) -> bool:
    """Return whether two energies have the same derivatives with respect to the speeds."""
    states = GenericStates(equations, (lagrangian, kinetic), "the energy")
    nodes = states.read.all((lagrangian, kinetic))
    shape = 2, len(states.speeds)
    momenta = np.reshape(jacobian(states.graph, nodes, states.speeds).flat(), shape).tolist()
    sums = [[a, states.graph.neg(b)] for a, b in zip(*momenta, strict=True)]
    samples = list(states.samples([_with_bounds(states, sums)], _TRIALS))
    return bool(samples) and all(_small(sample["pairs"], sums) for sample in samples)


def _with_bounds(states: GenericStates, sums: Sequence[Sequence[int]]) -> Block:
    """Return a block with the terms of sums and their rounding bounds.

    The terms are summed numerically afterwards: the graph would fold constants, and the rounding
    error of √2 - √2 would become a term of its own.
    """
    terms = [node for sum_terms in sums for node in sum_terms]
    return "pairs", (2, len(terms)), [*terms, *rounding_bounds(states.graph, terms)]


def _small(pairs: np.ndarray, sums: Sequence[Sequence[int]]) -> bool:
    starts = np.cumsum([0, *map(len, sums[:-1])])
    residual, bound = np.add.reduceat(pairs, starts, axis=1)
    return bool((np.abs(residual) <= ROUNDED * bound).all())


def _jumps(states: GenericStates, switch: int, energy: int) -> bool:
    """Return whether an energy jumps at a switch."""
    above, below = Branches(states.graph, [energy]).sides(switch)
    step = states.graph.sub(*above, *below)
    block = [("step", (1,), [step])]
    samples = list(states.samples_where_zero(switch, block, _TRIALS))
    if not samples:  # undefined at the switch, but it may have a limit
        near = [list(_across_switch(states, switch, block, (share,))) for share in NEAR]
        first_jump, second_jump = (
            np.median([abs(s["step"][0]) for s in group] or [0.0]) for group in near
        )
        return bool(abs(second_jump - first_jump) < NEAR[0] ** 0.5 * first_jump)
    steps = np.array([sample["step"] for sample in samples])
    return bool((np.abs(steps) > states.uncertain(samples, [step])).any())


def _across_switch(
    states: GenericStates, switch: int, blocks: Sequence[Block], shares: Sequence[float] = ACROSS
) -> Iterator[dict[str, np.ndarray]]:
    """Yield values at consistent states on the other side of a switch."""
    graph = states.graph
    if set(states.coordinates).isdisjoint(graph.reachable([switch])):
        return
    sizes = [float(s["switch"][0]) for s in states.samples([("switch", (1,), [switch])], 1)]
    for target in (size * share for size in sizes for share in shares):
        yield from states.samples_where_zero(graph.sum([(switch, 1.0)], -target), blocks, _TRIALS)
