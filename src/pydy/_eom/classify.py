"""Tell genuinely nonholonomic constraints from the rates of holonomic ones.

A velocity constraint is the rate of holonomic ones when its row lies in the row space of their
differentiated rows. That is decided by rank at generic points of the configuration manifold: a
user may have simplified the rate with the constraint itself, so that it agrees only there.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from pydy._eom.equations import Equations
from pydy._eom.symbols import find_symbols, sort_symbols
from pydy._graph.derivative import jacobian
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.interpret import run
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.program import Program

__all__ = ["classify"]

_TRIALS = 3


def classify(equations: Equations) -> Equations:
    """Return the equations with `nonholonomic` filled in."""
    if not equations.velocity:
        return equations
    if not equations.holonomic:
        return replace(equations, nonholonomic=equations.velocity)
    program, sizes = _rows_program(equations)
    implied: list[bool] = []
    for seed in range(_TRIALS):
        rates, motion = _rows_at_generic_point(program, sizes, np.random.default_rng(seed))
        if np.isfinite(rates).all() and np.isfinite(motion).all():
            implied = _implied(rates, motion)
            break
    if not implied:  # no point where the constraints could be evaluated
        implied = [False] * len(equations.velocity)
    genuine = (row for row, flag in zip(equations.velocity, implied, strict=True) if not flag)
    return replace(equations, nonholonomic=tuple(genuine))


def _implied(rates: np.ndarray, motion: np.ndarray) -> list[bool]:
    """Return for each motion row whether it lies in the row space of the rates."""
    rates = rates / np.maximum(np.linalg.norm(rates, axis=1, keepdims=True), 1e-300)
    motion = motion / np.maximum(np.linalg.norm(motion, axis=1, keepdims=True), 1e-300)
    rank = np.linalg.matrix_rank(rates, tol=1e-8)
    return [
        bool(np.linalg.matrix_rank(np.vstack([rates, row]), tol=1e-8) == rank) for row in motion
    ]


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
