"""Tell genuinely nonholonomic constraints from the rates of holonomic ones.

The velocity constraints span a row space that holds the differentiated holonomic constraints. Its
dimension beyond theirs is the number of nonholonomic constraints: it does not depend on the axes
in which a contact's velocity is resolved, where each single row may mix both kinds. Ranks are
taken at generic points of the configuration manifold: a user may have simplified a rate with the
constraint itself, so that it agrees only there.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pydy._graph.derivative import dense_rows, jacobian
from pydy._mechanics.equations import Equations
from pydy._mechanics.generic import Block, GenericStates
from pydy._mechanics.tuning import WITHIN_SPAN

__all__ = ["classify"]

_TRIALS = 3


def classify(equations: Equations) -> Equations:
    """Return the equations with `nonholonomic`, `enforced` and `repeated` filled in."""
    redundant = equations.left_out[1]
    equations = replace(equations, repeated=redundant)
    if not equations.velocity:
        return equations
    if not equations.holonomic:
        return replace(equations, nonholonomic=equations.velocity)
    states = GenericStates(equations, redundant, "the constraints")
    moving, rates = (list(nodes) for nodes in zip(*states.moving, strict=True))
    blocks = [
        states.table("gradient", states.holonomic, moving),
        _rows(states, "kinematics", rates),
        _rows(states, "motion", states.velocity),
        _rows(states, "redundant", states.read.all(redundant)),
    ]
    values = next(states.samples(blocks, _TRIALS), None)
    if values is None:  # nothing can be evaluated
        return replace(equations, nonholonomic=equations.velocity)
    rows, motion = values["gradient"] @ values["kinematics"], values["motion"]
    terms = np.abs(values["gradient"]) @ np.abs(values["kinematics"])
    sizes = np.linalg.norm(terms, axis=1)
    # What cancels is no row: the rate of a quaternion's norm.
    rows[np.linalg.norm(rows, axis=1) <= WITHIN_SPAN * sizes] = 0.0
    enforced = tuple(k for k, row in enumerate(rows) if _implied(row, motion))
    chosen = _completing(rows, motion)
    # What was redundant may be the rate of a holonomic constraint, which stands for itself now, and
    # what was kept may be what is redundant beside it.
    others = [k for k in range(len(motion)) if k not in chosen]
    pool = [*zip(redundant, values["redundant"], strict=True)]
    pool += [(equations.velocity[k], motion[k]) for k in others]
    held = rows[list(enforced)]
    pool.sort(key=lambda pair: max((_likeness(row, pair[1]) for row in held), default=0))
    return replace(
        equations,
        nonholonomic=tuple(equations.velocity[k] for k in chosen),
        enforced=enforced,
        repeated=tuple(e for e, _ in pool[: len(redundant)]),
    )


def _implied(row: np.ndarray, motion: np.ndarray) -> bool:
    """Return whether the motion rows imply a row, which must not be zero."""
    return bool(row.any()) and not _completing(motion, row[None])


def _likeness(row: np.ndarray, other: np.ndarray) -> int:
    """Tell whether rows are equal (2) or parallel (1), which where one speed moves all rows are."""
    if np.linalg.norm(row - other) <= WITHIN_SPAN * np.linalg.norm(row):
        return 2
    return int(not _completing(row[None], other[None]))


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
        if left > WITHIN_SPAN:
            basis.append(rest / left)
        return bool(left > WITHIN_SPAN)

    for row in rates:
        extends(row)
    return [k for k, row in enumerate(motion) if extends(row)]


def _rows(states: GenericStates, name: str, nodes: list[int]) -> Block:
    """Return the block of linear equations in the speeds: coefficients, and what is left."""
    g, speeds = states.graph, states.speeds
    cells: list[int] = []
    rows = dense_rows(g, jacobian(g, nodes, speeds), len(speeds))
    for node, slope in zip(nodes, rows, strict=True):
        terms = [(g.mul(c, s), -1.0) for c, s in zip(slope, speeds, strict=True)]
        cells += [*slope, g.sum([(node, 1.0), *terms])]
    return name, (len(nodes), len(speeds) + 1), cells
