"""Tell genuinely nonholonomic constraints from the rates of holonomic ones.

The velocity constraints span a row space that holds the differentiated holonomic constraints. Its
dimension beyond theirs is the number of nonholonomic constraints: it does not depend on the axes
in which a contact's velocity is resolved, where each single row may mix both kinds. Ranks are
taken at generic points of the configuration manifold: a user may have simplified a rate with the
constraint itself, so that it agrees only there.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from pydy._graph.derivative import jacobian
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.interpret import run
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.program import Program
from pydy._mechanics.equations import Equations
from pydy._mechanics.symbols import find_symbols, sort_symbols

__all__ = ["classify"]

_TRIALS = 3
_DEPENDENT = 1e-8  # a unit row with less than this outside a span lies in it


def classify(equations: Equations) -> Equations:
    """Return the equations with `nonholonomic` filled in."""
    if not equations.velocity:
        return equations
    if not equations.holonomic:
        return replace(equations, nonholonomic=equations.velocity)
    program, sizes = _rows_program(equations)
    completing = list(range(len(equations.velocity)))  # where nothing can be evaluated
    for seed in range(_TRIALS):
        rates, motion = _rows_at_generic_point(program, sizes, np.random.default_rng(seed))
        if np.isfinite(rates).all() and np.isfinite(motion).all():
            completing = _completing(rates, motion)
            break
    return replace(equations, nonholonomic=tuple(equations.velocity[k] for k in completing))


def _completing(rates: np.ndarray, motion: np.ndarray) -> list[int]:
    """Return which motion rows, taken in order, complete the row space of the rates."""
    basis: list[np.ndarray] = []

    def extends(row: np.ndarray) -> bool:
        size = np.linalg.norm(row)
        rest = row / size if size else row
        for _ in range(2):  # the second orthogonalization removes the rounding of the first
            for unit in basis:
                rest = rest - (unit @ rest) * unit
        left = np.linalg.norm(rest)
        if left > _DEPENDENT:
            basis.append(rest / left)
        return bool(left > _DEPENDENT)

    for row in rates:
        extends(row)
    return [k for k, row in enumerate(motion) if extends(row)]


def _rows_program(equations: Equations) -> tuple[Program, tuple[int, int, int]]:
    """Return a Program of the holonomic residuals, their gradients, and both sets of rows.

    All symbols that are not states count as specifieds here: the search for a generic point may
    move them too, since a four-bar with lengths chosen at random need not close.
    """
    graph = Graph()
    q, u = equations.coordinates, equations.speeds
    states = [*q, *u]
    known = {*states, *equations.zeros, equations.time}
    expressions = (*equations.holonomic, *equations.velocity, *equations.coordinate_derivatives)
    rates = set(equations.coordinate_rates)
    others = sort_symbols(s for s in find_symbols(expressions) if s not in known | rates)
    inputs = [graph.input("x", k) for k in range(len(states))]
    extra = [graph.input("r", k) for k in range(len(others))]
    time = graph.input("t", 0)
    atoms: dict[Any, int] = dict(zip(states, inputs, strict=True))
    atoms.update(zip(others, extra, strict=True))
    atoms[equations.time] = time
    atoms.update((z, graph.zero) for z in equations.zeros)
    read = SymPyReader(graph, atoms, "the constraints")
    derivatives = read.all(equations.coordinate_derivatives)
    for rate, node in zip(equations.coordinate_rates, derivatives, strict=True):
        read.define(rate, node)
    residuals = read.all(equations.holonomic)
    moving = inputs[: len(q)]
    # A prescribed motion y(t) moves a constraint through y'(t).
    place = {s: k for k, s in enumerate(others)}
    chained = [(inputs[k], d) for k, d in enumerate(derivatives)] + [(time, graph.one)]
    chained += [
        (extra[k], extra[place[s.diff(equations.time)]])
        for s, k in place.items()
        if s.diff(equations.time) in place
    ]
    partials = jacobian(graph, residuals, [v for v, _ in chained])
    total = [
        graph.sum([(graph.mul(d, chained[k][1]), 1.0) for k, d in row.items()]) for row in partials
    ]
    motion = read.all(equations.velocity)
    speeds = inputs[len(q) :]

    def rows(nodes: list[int]) -> list[int]:
        table = jacobian(graph, nodes, speeds)
        at_rest = [(n, row) for n, row in zip(nodes, table, strict=True)]
        cells = []
        for node, row in at_rest:
            slope = [row.get(k, graph.zero) for k in range(len(speeds))]
            drift = graph.sum(
                [(node, 1.0)]
                + [(graph.mul(c, s), -1.0) for c, s in zip(slope, speeds, strict=True)]
            )
            cells += [*slope, drift]
        return cells

    gradient = jacobian(graph, residuals, [*moving, *extra])
    width = len(moving) + len(extra)
    blocks = [
        ("residuals", (len(residuals),), residuals),
        (
            "gradient",
            (len(residuals), width),
            [row.get(k, graph.zero) for row in gradient for k in range(width)],
        ),
        ("rates", (len(total), len(speeds) + 1), rows(total)),
        ("motion", (len(motion), len(speeds) + 1), rows(motion)),
    ]
    sizes = (len(states), len(others), 0)
    return lower(graph, sizes, blocks), (len(q), len(u), len(others))


def _rows_at_generic_point(
    program: Program, sizes: tuple[int, int, int], rng: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    n, o, s = sizes
    x = rng.uniform(0.3, 1.3, n + o)
    r = rng.uniform(0.5, 1.5, s)
    t = rng.uniform(0.1, 1.0, 1)
    for _ in range(50):
        out, _ = run(program, t, x[None], r[None], np.empty(0))
        values = {b.name: out[0, b.start : b.stop].reshape(b.shape) for b in program.blocks}
        residuals, gradient = values["residuals"], values["gradient"]
        if not np.isfinite(gradient).all() or not np.isfinite(residuals).all():
            break
        if np.abs(residuals).max() < 1e-13:
            break
        step = -np.linalg.lstsq(gradient, residuals, rcond=None)[0]
        x[:n] += step[:n]
        r += step[n:]
    return values["rates"], values["motion"]
