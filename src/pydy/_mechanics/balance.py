"""Whether a potential energy is that of some loads: its rate must be minus their power.

It is decided by numbers at generic states that keep the constraints, as in `classify`: velocities
that a user simplified with a constraint agree only there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy.core.function import AppliedUndef

from pydy._graph.derivative import jacobian
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.interpret import run
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.program import Program
from pydy._mechanics.equations import Equations
from pydy._mechanics.symbols import find_symbols, sort_symbols

__all__ = ["is_potential_of"]

_TRIALS = 3
_TOLERANCE = 1e-8


def is_potential_of(equations: Equations, potential: Any, powers: Sequence[Any]) -> bool:
    """Return whether ``d potential/dt = -sum(powers)``.

    Parameters
    ----------
    equations : Equations
    potential : expression in q, t, constants and specifieds
    powers : sequence of expressions in q, u, t, constants and specifieds
    """
    problem = _assemble(equations, potential, powers)
    for seed in range(_TRIALS):
        values = _at_consistent_state(problem, np.random.default_rng(seed))
        terms = values["terms"]
        if np.isfinite(terms).all():
            return bool(abs(terms.sum()) <= _TOLERANCE * max(np.abs(terms).sum(), 1e-300))
    return False


@dataclass(frozen=True)
class _Problem:
    program: Program
    coordinates: int
    speeds: int
    others: int


def _assemble(equations: Equations, potential: Any, powers: Sequence[Any]) -> _Problem:
    graph, t = Graph(), equations.time
    q, u = equations.coordinates, equations.speeds
    states = [*q, *u]
    known = {*states, *equations.zeros, t, *equations.coordinate_rates}
    expressions = (
        potential,
        *powers,
        *equations.holonomic,
        *equations.velocity,
        *equations.coordinate_derivatives,
    )
    found = {s for s in find_symbols(expressions) if s not in known}
    found |= {s.diff(t) for s in found if isinstance(s, AppliedUndef)}
    others = sort_symbols(found)
    x = [graph.input("x", k) for k in range(len(states))]
    r = [graph.input("r", k) for k in range(len(others))]
    time = graph.input("t", 0)
    atoms: dict[Any, int] = {
        **dict(zip(states, x, strict=True)),
        **dict(zip(others, r, strict=True)),
    }
    atoms[t] = time
    atoms.update((z, graph.zero) for z in equations.zeros)
    read = SymPyReader(graph, atoms, "the energy")
    rates = read.all(equations.coordinate_derivatives)
    for rate, node in zip(equations.coordinate_rates, rates, strict=True):
        read.define(rate, node)
    # What moves, and how fast.
    moving = [*zip(x[: len(q)], rates, strict=True), (time, graph.one)]
    moving += [(atoms[s], atoms[s.diff(t)]) for s in others if isinstance(s, AppliedUndef)]
    (row,) = jacobian(graph, [read(potential)], [node for node, _ in moving])
    terms = [graph.mul(d, moving[k][1]) for k, d in row.items()] + read.all(powers)
    holonomic, velocity = read.all(equations.holonomic), read.all(equations.velocity)

    def table(nodes: list[int], variables: list[int]) -> list[int]:
        rows = jacobian(graph, nodes, variables)
        return [row.get(k, graph.zero) for row in rows for k in range(len(variables))]

    free = [*x[: len(q)], *r]
    n = len(q)
    blocks = [
        ("terms", (len(terms),), terms),
        ("holonomic", (len(holonomic),), holonomic),
        ("gradient", (len(holonomic), len(free)), table(holonomic, free)),
        ("velocity", (len(velocity),), velocity),
        ("slope", (len(velocity), len(u)), table(velocity, x[n:])),
    ]
    program = lower(graph, (len(states), len(others), 0), blocks)
    return _Problem(program, n, len(u), len(others))


def _at_consistent_state(problem: _Problem, rng: np.random.Generator) -> dict[str, np.ndarray]:
    """Return the blocks at a generic state; constants move too, or a loop might not close."""
    n, program = problem.coordinates, problem.program
    x = rng.uniform(0.3, 1.3, n + problem.speeds)
    r = rng.uniform(0.5, 1.5, problem.others)
    t = rng.uniform(0.1, 1.0, 1)

    def values() -> dict[str, np.ndarray]:
        out, _ = run(program, t, x[None], r[None], np.empty(0))
        return {b.name: out[0, b.start : b.stop].reshape(b.shape) for b in program.blocks}

    for _ in range(50):
        now = values()
        if not np.isfinite(now["gradient"]).all() or not np.isfinite(now["holonomic"]).all():
            return now
        if np.abs(now["holonomic"]).max(initial=0.0) < 1e-13:
            break
        step = -np.linalg.lstsq(now["gradient"], now["holonomic"], rcond=None)[0]
        x[:n] += step[:n]
        r += step[n:]
    if now["velocity"].size and np.isfinite(now["slope"]).all():
        x[n:] -= np.linalg.lstsq(now["slope"], now["velocity"], rcond=None)[0]
        now = values()
    return now
