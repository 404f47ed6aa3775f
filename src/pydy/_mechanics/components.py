"""Components of vectors and tensors as nodes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy._graph import Branches, Graph, inputs_of, jacobian, linear_terms, rounding_bounds
from pydy._mechanics.tuning import ACROSS
from pydy._rank import DIGITS, ROUNDED

_STATES = 3
_ATTEMPTS = 4  # links of random lengths close a loop in every second state or so


def dot(graph: Graph, a: Sequence[int], b: Sequence[int], *further_terms: tuple[int, float]) -> int:
    """Return the scalar product, plus `further_terms` with their factors."""
    zero = graph.zero
    pairs = [(x, y) for x, y in zip(a, b, strict=True) if x != zero != y]
    return graph.sum([*further_terms, *((graph.mul(x, y), 1.0) for x, y in pairs)])


def product(graph: Graph, matrix: Sequence[Sequence[int]], v: Sequence[int]) -> list[int]:
    """Return the product of a matrix and a vector."""
    return [dot(graph, row, v) for row in matrix]


def identity(graph: Graph, n: int = 3) -> list[list[int]]:
    """Return the identity matrix with n rows."""
    return [[graph.one if i == j else graph.zero for j in range(n)] for i in range(n)]


def in_rows(flat: Sequence[int]) -> list[list[int]]:
    """Return nine nodes as a 3 by 3 matrix."""
    return [list(flat[k : k + 3]) for k in (0, 3, 6)]


def flat(matrix: Sequence[Sequence[int]]) -> list[int]:
    """Return the entries of a matrix, row by row."""
    return [n for row in matrix for n in row]


def axis_rotation(graph: Graph, axis: int, c: int, s: int) -> list[list[int]]:
    """Return the matrix of a rotation about a coordinate axis, by cosine and sine."""
    j, m = (axis + 1) % 3, (axis + 2) % 3
    matrix = [[graph.one if i == r == axis else graph.zero for i in range(3)] for r in range(3)]
    matrix[j][j] = matrix[m][m] = c
    matrix[j][m], matrix[m][j] = s, graph.neg(s)
    return matrix


def transposed(matrix: Sequence[Sequence[int]]) -> list[list[int]]:
    """Return the transpose of a matrix."""
    return [list(column) for column in zip(*matrix, strict=True)]


def unrounded(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Drop terms that are rounding errors of numeric rotations, relative to the vector."""
    rows = [linear_terms(graph, n) for n in nodes]
    sizes: dict[int, float] = {}
    for row in rows:
        for n, c in row.items():
            sizes[n] = max(sizes.get(n, 0.0), abs(c))
    retained = [{n: c for n, c in row.items() if abs(c) > ROUNDED * sizes[n]} for row in rows]
    return [
        node if len(retained_row) == len(row) else graph.sum(retained_row.items())
        for node, row, retained_row in zip(nodes, rows, retained, strict=True)
    ]


def numbers_of(
    graph: Graph,
    flat: Sequence[int],
    zero_rows: Sequence[int] = (),
    zeros: Sequence[int] = (),
    common: Sequence[int] = (),
    kept: Sequence[int] = (),
    seed: int = 0,
) -> np.ndarray:
    """Return values of nodes at random states, one row for each, at which `zero_rows` vanish.

    All inputs of these rows may change, except those `kept`: quaternions get unit length, random
    lengths close a loop. Inputs among `zeros` that do not occur in them are zero. Those among
    `common` start equal in all states; they differ at the end only if `zero_rows` contain them.
    """
    inputs = [*inputs_of(graph, [*flat, *zero_rows])]
    x = np.random.default_rng(seed).uniform(0.5, 1.5, (_STATES, len(inputs)))
    determined = {*graph.reachable(zero_rows)}
    x[:, [n in zeros and n not in determined for n in inputs]] = 0.0
    shared = [n in common for n in inputs]
    x[:, shared] = x[0, shared]

    def values(nodes: Sequence[int]) -> np.ndarray:
        return graph.evaluator(nodes)(dict(zip(inputs, x.T, strict=True)), _STATES)

    if zero_rows:
        slopes = jacobian(graph, zero_rows, inputs).flat()
        is_kept = [n in kept for n in inputs]
        for _ in range(12):  # each Newton step doubles the digits
            newton = values([*zero_rows, *slopes])
            if not np.isfinite(newton).all():
                break
            residuals, slope = newton[:, : len(zero_rows)], newton[:, len(zero_rows) :]
            for k in range(_STATES):
                matrix = slope[k].reshape(len(zero_rows), -1)
                matrix[:, is_kept] = 0.0
                x[k] -= np.linalg.lstsq(matrix, residuals[k], rcond=None)[0]
    return values(flat)


def consistent_numbers(
    graph: Graph, flat: Sequence[int], zero_rows: Sequence[int], zeros: Sequence[int] = ()
) -> np.ndarray:
    """Return values as `numbers_of`, at the states alone where `zero_rows` do vanish.

    Constants keep their random values if some states can be found so: Newton's method may close a
    loop with links of no length. There may be none, if a mechanism cannot be assembled.
    """
    nodes = [*flat, *zero_rows, *rounding_bounds(graph, zero_rows)]
    splits = [len(flat), len(flat) + len(zero_rows)]
    constants = [n for n in inputs_of(graph, zero_rows) if graph.args[n][0] == "p"]
    attempts = [(constants, seed) for seed in range(_ATTEMPTS)] if constants else []
    consistent = np.empty((0, len(flat)))
    for kept, seed in [*attempts, ((), 0)]:
        with np.errstate(all="ignore"):
            rows = numbers_of(graph, nodes, zero_rows, zeros, kept=kept, seed=seed)
        values, residuals, bounds = np.split(rows, splits, axis=1)
        vanish = (np.abs(residuals) <= ROUNDED * bounds).all(axis=1)
        consistent = np.vstack([consistent, values[vanish]])
        if len(consistent) >= _STATES:
            break
    return consistent


def nonzero_somewhere(graph: Graph, nodes: Sequence[int], zero_rows: Sequence[int]) -> np.ndarray:
    """Return which nodes differ from zero at some consistent state, by more than typed decimals."""
    bounds_of = rounding_bounds(graph, nodes, constants=True)
    values = consistent_numbers(graph, [*nodes, *bounds_of], zero_rows)
    sizes, bounds = np.split(np.abs(values), 2, axis=1)
    differ: np.ndarray = ((sizes > DIGITS * bounds) & np.isfinite(bounds)).any(axis=0)
    return differ


def finite_rows(values: np.ndarray) -> np.ndarray:
    """Return the rows whose numbers are all finite."""
    finite: np.ndarray = values[np.isfinite(values).all(axis=1)]
    return finite


def numbers_across(
    graph: Graph, flat: Sequence[int], switched: Sequence[int], zero_rows: Sequence[int] = ()
) -> np.ndarray:
    """Return values of nodes as `numbers_of`, and on the other side of each switch of `switched`.

    A one-sided force is zero at most states.
    """
    rows = [numbers_of(graph, flat, zero_rows)]
    for switch in Branches(graph, switched).switches():
        before = numbers_of(graph, [switch], zero_rows)[0, 0]
        for share in ACROSS:
            row = graph.sum([(switch, 1.0)], -share * before)
            values = numbers_of(graph, [*flat, switch], [*zero_rows, row])
            across = np.isfinite(values).all(axis=1) & (values[:, -1] * before < 0.0)
            rows.append(values[across, :-1])
    return np.vstack(rows)
