"""Constraints stabilised by constraint forces, after Baumgarte.

J. Baumgarte, "Stabilization of constraints and integrals of motion in dynamical systems", Computer
Methods in Applied Mechanics and Engineering 1 (1972) 1–16, with both gains chosen for critical
damping.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pydy._assembly.assembly import Assembly
from pydy._assembly.mechanical_blocks import constraints_with_redundant, kinetic_hessian
from pydy._graph import LinearSystem, directional, jacobian, substitute
from pydy._mechanics import (
    AccelerationConstraints,
    generic_values,
)
from pydy._rank import DEPENDENT, HALF, ROUNDED


def stabilised(assembly: Assembly, gain: float) -> Assembly:
    """Return the system whose constraint residuals c obey c'' + 2 g c' + g² c = 0."""
    graph, speeds, blocks = assembly.graph, assembly.speeds, assembly.blocks
    n, count = len(speeds), len(blocks.velocity)
    body = None if assembly.equations is None else assembly.equations.multibody
    holonomic, velocity = constraints_with_redundant(assembly)
    pull = [
        graph.sum(
            [(v, 2.0 * gain)]
            + [(h, gain * gain * float(s)) for h, s in zip(holonomic, shares, strict=True) if s]
        )
        for v, shares in zip(velocity, _shares(assembly, holonomic, velocity), strict=True)
    ]
    first = graph.args[speeds[0]][1]
    before = blocks.rates[first : first + n]
    cells = kinetic_hessian(assembly) if body is not None and body.dependents.changing else []
    matrix = [cells[i * n : (i + 1) * n] for i in range(n if cells else 0)]
    forcing = list(blocks.forcing)
    massive = matrix and all(matrix[k][k] != graph.zero for k in range(n))
    if massive or (matrix and len(velocity) > count):
        rows = jacobian(graph, velocity, speeds).dense()
        motion = {graph.input("x", k): {0: rate} for k, rate in enumerate(blocks.rates[:first])}
        motion[graph.input("t", 0)] = {0: graph.one}

        def dt(nodes: list[int]) -> list[int]:
            return directional(graph, nodes, motion).flat()

        along = jacobian(graph, dt(holonomic), speeds).dense()
        positions = list(zip(holonomic, along, strict=True))
        row_rates = [dt(row) for row in rows]
        constraints = AccelerationConstraints(rows, pull, count, row_rates, velocity, positions)
        no_force = [graph.zero] * n
        if massive:
            pulled = constraints.accelerations(graph, matrix, no_force)
        else:
            pulled = constraints.accelerations_at_any_rank(graph, matrix, no_force)
        after = [graph.add(a, b) for a, b in zip(before, pulled, strict=True)]
    else:
        rows = [blocks.mass_matrix[i * n : (i + 1) * n] for i in range(n)]
        for k, own in zip(_constraint_rows(assembly), pull, strict=True):
            forcing[k] = graph.sub(forcing[k], own)
        after = LinearSystem(graph, rows).solve(forcing, judged=True)
    pairs = zip(before, after, strict=True)
    mapping = {old: new for old, new in pairs if not graph.constant[old]}
    rates = substitute(graph, blocks.rates, mapping)
    rates[first : first + n] = after
    changed = replace(
        blocks,
        forcing=forcing,
        rates=rates,
        outputs=substitute(graph, blocks.outputs, mapping),
        ordinary=substitute(graph, blocks.ordinary, mapping),
    )
    return replace(assembly, blocks=changed)


def _constraint_rows(assembly: Assembly) -> Sequence[int]:
    """Return which rows of the mass matrix are the acceleration constraints, in their order."""
    n, equations = len(assembly.speeds), assembly.equations
    last = range(n - len(assembly.blocks.velocity), n)
    return last if equations is None else equations.dependents.speed_columns


def _shares(assembly: Assembly, holonomic: list[int], velocity: list[int]) -> np.ndarray:
    """Return of which holonomic constraints each velocity constraint is the rate, and how much."""
    graph, speeds = assembly.graph, assembly.speeds
    n, count = len(speeds), len(assembly.blocks.velocity)
    first = graph.args[speeds[0]][1]
    coordinates = [graph.input("x", k) for k in range(first)]
    names = {
        "motion": (velocity, speeds),
        "gradient": (holonomic, coordinates),
        "kinematics": (assembly.blocks.rates[:first], speeds),
    }
    blocks = []
    for name, (nodes, by) in names.items():
        cells = jacobian(graph, nodes, by).flat()
        blocks.append((name, (len(nodes), len(by)), cells))
    matrix = assembly.blocks.mass_matrix
    below = [matrix[k * n + j] for k in _constraint_rows(assembly) for j in range(n)]
    blocks.append(("rows", (count, n), below))
    parts = generic_values(graph, blocks, assembly.sizes, 3 + len(holonomic))
    given, rates = parts["rows"], parts["motion"][:, :count]
    entries = np.maximum(np.abs(given), np.abs(rates))
    rounding = ROUNDED * entries.max(axis=2, keepdims=True, initial=0.0)  # of a row's zeros
    if not (np.abs(given - rates) <= HALF * entries + rounding).all():
        raise ValueError(
            "`constraints='baumgarte'` needs acceleration constraints that are the rates of "
            "the velocity constraints, in the same order and not scaled; these are not. Use "
            "constraints='project'."
        )
    reach, motion = parts["gradient"] @ parts["kinematics"], parts["motion"]
    # Rows of size one: some may be lengths in kilometres, others squares of micrometres.
    sizes = [np.linalg.norm(a, axis=(0, 2))[:, None] for a in (reach, motion)]
    sizes = [np.where(size > 0.0, size, 1.0) for size in sizes]
    reach, motion = reach / sizes[0], motion / sizes[1]
    # At a single state other factors may do too: redundant rows depend on each other there.
    share, left = _combined(np.concatenate([*reach.transpose(0, 2, 1)]), motion)
    genuine = left > HALF
    for k in np.flatnonzero(genuine):
        own = [_combined(a.T, b[None, k : k + 1])[1][0] for a, b in zip(reach, motion, strict=True)]
        if max(own) <= HALF and np.linalg.matrix_rank(reach[0]) < n:
            raise ValueError(
                "`constraints='baumgarte'` needs velocity constraints that are the rates of "
                "holonomic ones with constant factors; here the factors depend on the state. Use "
                "constraints='project', or write the velocity constraints as `holonomic.diff(t)`."
            )
    share[genuine] = 0.0
    share[np.abs(share) < ROUNDED] = 0.0
    result: np.ndarray = share * (sizes[1] / sizes[0].T)
    return result


def _combined(columns: np.ndarray, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Fit rows by one linear combination of columns at all states; return it and the residual."""
    right = rows.transpose(0, 2, 1).reshape(len(columns), -1)
    share = np.linalg.lstsq(columns, right, rcond=DEPENDENT)[0]
    left = np.linalg.norm(right - columns @ share, axis=0)
    size = np.linalg.norm(right, axis=0)
    return share.T, left / np.where(size > 0.0, size, 1.0)
