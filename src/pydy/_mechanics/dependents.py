"""Which coordinates and speeds depend on the others, by elimination at generic states.

The derivatives of the constraints are eliminated with complete pivoting at several states at once:
a pivot is rated by the worst of them. Rows beyond the rank are redundant.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pydy._checks import describe
from pydy._graph import Graph, jacobian, rounding_bounds, signatures
from pydy._mechanics.equations import Equations
from pydy._mechanics.generic import AROUND, Block, GenericStates, closed, openness, units_of
from pydy._mechanics.kinematic_constraints import RedundantConstraints
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.select_formulation import kinematics_of
from pydy._mechanics.tuning import DIGITS, NEARLY_DEPENDENT
from pydy._names import few
from pydy._rank import HALF, OF_FEW, ROUNDED, equilibrated, is_zero, or_one

if TYPE_CHECKING:
    import sympy as sm

    from pydy._sympy_types import AnySymbol, TimeFunction

_TRIALS = 12
_SHARE = 0.1  # of the largest residual: what is named with it


class Chosen:
    """Rows that are independent, and as many columns that can be solved for, in ascending order.

    The `samples` (m, n) are one matrix at several states, accurate within `bounds`; the columns are
    chosen from those `allowed`, with those in `first` before others. Entries that are `varying`
    depend on the configuration and may vanish elsewhere. A pivot is accepted if it exceeds its
    bound and half the digits of its row, or of its row and column after equilibration.
    """

    def __init__(
        self,
        samples: np.ndarray,
        allowed: Sequence[int] | None = None,
        varying: np.ndarray | None = None,
        bounds: np.ndarray | None = None,
        first: Sequence[int] = (),
    ) -> None:
        work = np.array(samples, dtype=float)
        errors = np.zeros_like(work) if bounds is None else np.array(bounds, dtype=float)
        varies = np.ones(work.shape[1:], dtype=bool) if varying is None else varying.copy()
        sizes = or_one(np.abs(work).max(axis=2, keepdims=True, initial=0.0))
        _, tall, wide = _in_one_size(_without_errors(work, errors))
        units = sizes * wide / tall
        work /= sizes
        errors /= sizes
        rows: list[int] = []
        columns: list[int] = []
        free = np.zeros(work.shape[1:], dtype=bool)
        free[:, range(work.shape[2]) if allowed is None else list(allowed)] = True
        while free.any():
            least = np.minimum(HALF, np.maximum(HALF / units, errors))
            sound = free & (np.abs(work) >= least).all(axis=0)
            worst = np.where(sound, np.abs(work).min(axis=0), 0.0)
            # A constant pivot counts ten times: it cannot vanish in other configurations.
            weighed = np.where(varies, worst, 10.0 * worst)
            if weighed[:, first].any():
                weighed[:, ~np.isin(np.arange(weighed.shape[1]), first)] = 0.0
            i, j = np.unravel_index(int(weighed.argmax()), worst.shape)
            if not sound[i, j]:
                break
            rows.append(int(i))
            columns.append(int(j))
            ratio = work[:, :, j] / work[:, i, j][:, None]
            ratio[:, rows] = 0.0
            moved = (ratio != 0.0).any(axis=0)
            varies[moved] |= varies[i] | varies[moved, j][:, None]
            column_errors = errors[:, :, j] + np.abs(ratio) * errors[:, i, j][:, None]
            column_errors = np.where(
                ratio != 0.0, column_errors / np.abs(work[:, i, j])[:, None], 0.0
            )
            errors += np.abs(ratio)[:, :, None] * errors[:, i, :][:, None, :]
            errors += column_errors[:, :, None] * np.abs(work[:, i, :])[:, None, :]
            work -= ratio[:, :, None] * work[:, i, :][:, None, :]
            free[i, :] = free[:, j] = False
        self.rows, self.columns = sorted(rows), sorted(columns)


def _without_errors(matrices: np.ndarray, bounds: np.ndarray) -> np.ndarray:
    """Replace entries that are small in their row and within their rounding bound by zeros."""
    sizes = np.abs(matrices)
    small = sizes < HALF * sizes.max(axis=2, keepdims=True, initial=0.0)
    cleaned: np.ndarray = np.where(small & (sizes <= bounds), 0.0, matrices)
    return cleaned


def _in_one_size(matrices: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Equilibrate matrices at several states with common scales; return the scales too.

    The largest entry over all states is near one: rows may vanish in singular positions.
    """
    _, rows, columns = equilibrated(np.abs(matrices).max(axis=0), exact=True)
    return matrices * columns / rows, rows, columns


def constrained(
    body: Multibody,
    holonomic: Sequence[sm.Expr],
    velocity: Sequence[sm.Expr],
    coordinates: Sequence[TimeFunction] | None = None,
    speeds: Sequence[TimeFunction] | None = None,
    near: Mapping[AnySymbol, float] | None = None,
) -> Multibody:
    """Return the body with constraints, and with dependent coordinates and speeds chosen.

    Redundant constraints are omitted, and those that all motions satisfy, such as the norm of a
    quaternion. The user may choose dependent `coordinates` and `speeds`, and a configuration `near`
    which the mechanism is assembled.
    """
    velocity = _moving_rows(kinematics_of(body), velocity)
    constraints = replace(body.constraints, holonomic=tuple(holonomic), velocity=tuple(velocity))
    body = replace(body, constraints=constraints)
    choices = _choose(kinematics_of(body), coordinates, speeds, near)
    (of_positions, q_dep), (of_velocities, u_dep), rounded = choices
    constraints = replace(
        constraints,
        holonomic=tuple(constraints.holonomic[k] for k in of_positions.rows),
        velocity=tuple(constraints.velocity[k] for k in of_velocities.rows),
        redundant=RedundantConstraints(
            _omitted(holonomic, of_positions.rows, rounded),
            _omitted(velocity, of_velocities.rows, [k - len(holonomic) for k in rounded]),
        ),
    )
    dependents = replace(
        body.dependents,
        coordinates=q_dep,
        speeds=u_dep,
        chosen=(
            *(() if coordinates else (q for q in q_dep if q not in body.dependents.coordinates)),
            *(() if speeds else u_dep),
        ),
        changing=speeds is None,
    )
    return replace(body, constraints=constraints, dependents=dependents)


def _omitted(
    rows: Sequence[sm.Expr], retained: Sequence[int], rounded: Sequence[int]
) -> tuple[sm.Expr, ...]:
    return tuple(e for k, e in enumerate(rows) if k not in retained and k not in rounded)


def _moving_rows(equations: Equations, expressions: Sequence[sm.Expr]) -> list[sm.Expr]:
    """Return the velocity constraints that do not vanish identically."""
    states = GenericStates(equations, expressions, "the velocity constraints")
    values = signatures(states.graph, states.read.all(expressions))
    return [e for e, value in zip(expressions, values, strict=True) if value]


def _choose(
    equations: Equations,
    coordinates: Sequence[TimeFunction] | None,
    speeds: Sequence[TimeFunction] | None,
    near: Mapping[AnySymbol, float] | None,
) -> tuple[
    tuple[Chosen, tuple[TimeFunction, ...]], tuple[Chosen, tuple[TimeFunction, ...]], list[int]
]:
    """Return the independent constraints, and the coordinates and speeds that follow from them."""
    states = GenericStates(equations, (), "the constraints")
    _check_linear(equations, states)
    rows = _of_rounding(states)
    # √(x²) - x vanishes for the positive x of the samples, but otherwise selects a configuration.
    one_sided = {*_constant(states, rows)}.difference(_constant(states, rows, sign=-1.0))
    rows = [k for k in rows if k not in one_sided]
    states.leave_out(rows if near else [*rows, *one_sided])
    tables, every = _searched(states, near)
    samples = closed(every)
    if not every:
        raise ValueError(
            "The constraints cannot be evaluated: they give NaN or infinity at random states. "
            "Check what they divide by."
        )
    if not samples:
        best = every[int(np.argmin(openness(every)))]["residuals"]
        sizes = np.abs(best) / units_of(every)
        constraints = equations.constraints
        names = [f"holonomic constraint {k}, `{e}`" for k, e in enumerate(constraints.holonomic)]
        names += [f"velocity constraint {k}, `{e}`" for k, e in enumerate(constraints.velocity)]
        worst = [k for k in np.argsort(-sizes) if sizes[k] > _SHARE * sizes.max()]
        open_ones = few([f"the {names[k]}, is left at {best[k]:.3g}" for k in worst])
        raise ValueError(
            "The constraints contradict each other: no state was found that satisfies all of them; "
            f"{open_ones}. Leave out one of them, or correct it."
        )
    choices = []
    for block, symbols, chosen in zip(
        tables,
        (equations.coordinates, equations.speeds),
        (coordinates, speeds),
        strict=True,
    ):
        name, shape, cells = block
        matrices, bounds = _with_bounds(states, samples, block)
        full, rank = _of_full_rank(matrices, bounds)
        varying = np.array([states.changes(node) for node in cells], dtype=bool).reshape(shape)
        first = [k for k, s in enumerate(symbols) if s in equations.dependents.coordinates]
        for count in range(3, 0, -1):  # assembly configurations may have no common pivot
            clearest = matrices[full[:count]], bounds[full[:count]]
            choice = Chosen(clearest[0], varying=varying, bounds=clearest[1], first=first)
            if len(choice.rows) == rank:
                break
        matrices, bounds = clearest
        if chosen is not None:
            choice = _checked(name, symbols, chosen, matrices, bounds, len(choice.columns))
        choices.append((choice, tuple(symbols[k] for k in choice.columns)))
    return choices[0], choices[1], rows


def _searched(
    states: GenericStates, near: Mapping[AnySymbol, float] | None
) -> tuple[list[Block], list[dict[str, np.ndarray]]]:
    """Return the constraints' derivatives by coordinates and by speeds, and values of both."""
    blocks = states.closing()
    every = list(states.samples(blocks, _TRIALS, near=near, left_open=True))
    samples = closed(every)
    if not near and (not samples or _seem_redundant(*_with_bounds(states, samples, blocks[1]))):
        every += states.samples(blocks, AROUND, around=True, left_open=True)
    return blocks[:2], every


def _of_rounding(states: GenericStates) -> list[int]:
    """Return rows that are zero up to rounding, and rows whose terms are rounding errors.

    In an oblique plane the axes of two hinges are parallel at all angles, up to the rounding errors
    of cancelling terms. If SymPy has folded the numbers, a row of 1e-17 remains: its terms are no
    larger than the rounding errors of the numbers that cancelled, or of all other rows of its kind.
    Generic states are used, not consistent ones, since such a row may have a root, and a row of
    squared nanometres is as small when it is satisfied. Rates have the units of their holonomic
    rows and are classified with them.

    Rows have different units: directions and gears are numbers of order one, next to lengths of
    nanometres and squares of kilometres. A row of the order of one, or of the lengths of the
    mechanism or their squares, is not small because other rows are large.
    """
    graph, holonomic, velocity = states.graph, states.holonomic, states.velocity
    every = [*holonomic, *velocity]
    bounds = rounding_bounds(graph, every)
    blocks = [
        ("bounds", (len(bounds),), bounds),
        ("holonomic", (len(holonomic),), holonomic),
        ("rates", (len(holonomic),), states.rates(holonomic)),
        ("velocity", (len(velocity),), velocity),
    ]
    at = states.anywhere(blocks)
    sizes = np.nan_to_num(at["bounds"]).max(axis=0, initial=0.0)
    first, rates = len(holonomic), at["rates"]
    holonomic_of_rate = {
        first + j: int(k)
        for j, column in enumerate(at["velocity"].T)
        for k in np.flatnonzero(
            (np.abs(rates - column[:, None]) <= HALF * np.abs(rates)).all(axis=0) & column.any()
        )[:1]
    }
    values = np.concatenate([at["holonomic"], at["velocity"]], axis=1)
    vanishing = _vanishing(values, at["bounds"])
    rounded = _constant(states, np.flatnonzero(vanishing))
    cancelled = np.array([_cancelled(graph, node) for node in every])
    rounded += [int(k) for k in np.flatnonzero((sizes > 0.0) & (sizes <= OF_FEW * cancelled))]
    lengths = np.array(states.lengths_of_bodies)
    for part in (range(first), [k for k in range(first, len(sizes)) if k not in holonomic_of_rate]):
        largest = max((sizes[k] for k in part), default=0.0)
        rounded += [
            k
            for k in part
            if sizes[k] > 0.0
            and sizes[k] <= OF_FEW * largest
            and not _as_large_as(sizes[k], lengths)
            and k not in rounded
        ]
    return rounded + [j for j, k in holonomic_of_rate.items() if k in rounded and j not in rounded]


def _cancelled(graph: Graph, node: int) -> float:
    """Estimate the size of the numbers whose cancellation left the coefficients of a sum.

    A sum of floats is a multiple of the last place of the smallest: the remainder of a cancellation
    has few significant bits, but many decimals. Typed numbers, and numbers computed from them
    without cancellation, do not have both.
    """
    if graph.ops[node] != "sum":
        return 0.0
    constant, terms = graph.args[node]
    size = 0.0
    for value in map(abs, (constant, *(c for _, c in terms))):
        if not math.isfinite(value):
            continue
        odd, last = value.as_integer_ratio()  # the last place is one over a power of two
        decimals = repr(value).partition("e")[0].replace(".", "").strip("0")
        if 2 * odd.bit_length() < sys.float_info.mant_dig and len(decimals) > DIGITS:
            size = max(size, math.ldexp(1.0, sys.float_info.mant_dig + 1 - last.bit_length()))
    return size


def _as_large_as(size: float, lengths: np.ndarray) -> bool:
    """Return whether a row has the order of one, or of lengths or their squares."""
    units = np.concatenate([lengths, lengths**2])
    return bool(size > HALF or ((size > HALF * units) & (HALF * size < units)).any())


def _with_bounds(
    states: GenericStates, samples: list[dict[str, np.ndarray]], block: Block
) -> tuple[np.ndarray, np.ndarray]:
    """Return the matrices of a block at samples, and bounds on the errors of their entries.

    The bounds are evaluated if an entry is so small in its row that rounding errors could become a
    pivot after equilibration. Otherwise the sizes of rows suffice.
    """
    name, (count, width), cells = block
    matrices = np.array([s[name] for s in samples]).reshape(len(samples), count, width)
    sizes = np.abs(matrices)
    largest = sizes.max(axis=2, keepdims=True, initial=0.0)
    if not ((sizes > 0.0) & is_zero(HALF * sizes, largest)).any():
        return matrices, np.broadcast_to(largest, matrices.shape)
    return matrices, states.uncertain(samples, cells).reshape(matrices.shape)


def _vanishing(values: np.ndarray, bounds: np.ndarray) -> np.ndarray:
    """Return which values vanish up to rounding at all states although their terms do not."""
    zero: np.ndarray = (np.abs(values) <= ROUNDED * bounds).all(axis=0) & (bounds > 0.0).all(axis=0)
    return zero


def _constant(states: GenericStates, rows: Iterable[int], sign: float = 1.0) -> list[int]:
    """Return the rows whose derivatives vanish up to rounding, with inputs of one `sign`.

    The value of a row of large terms may be within their rounding, but its derivatives are not.
    """
    every = [*states.holonomic, *states.velocity]
    constant = []
    for k in map(int, rows):
        name, shape, cells = states.table("slopes", [every[k]], states.inputs)
        bounds = rounding_bounds(states.graph, cells)
        at = states.anywhere([(name, shape, cells), ("bounds", shape, bounds)], sign)
        slopes, terms = at[name], at["bounds"]
        small = np.abs(slopes) <= ROUNDED * terms
        if (small | (np.isnan(slopes) & (sign < 0.0))).all():  # NaN, as of √x, is no evidence
            constant.append(k)
    return constant


def _check_linear(equations: Equations, states: GenericStates) -> None:
    """Refuse holonomic constraints with speeds, and velocity constraints not linear in them."""
    speeds, slopes = set(states.speeds), jacobian(states.graph, states.velocity, states.speeds)

    def has_speeds(nodes: Sequence[int]) -> bool:
        return not speeds.isdisjoint(states.graph.reachable(nodes))

    rows = equations.constraints
    for k, (e, node) in enumerate(zip(rows.holonomic, states.holonomic, strict=True)):
        if has_speeds([node]):
            raise ValueError(
                f"The holonomic constraint {k}, `{e}`, holds speeds or derivatives. Give it as a "
                "velocity constraint."
            )
    for k, (e, row) in enumerate(zip(rows.velocity, slopes, strict=True)):
        if has_speeds([*row.values()]):
            raise ValueError(
                f"The velocity constraint {k}, `{e}`, is not linear in the speeds. Replace it with "
                "one that is."
            )


def _seem_redundant(matrices: np.ndarray, bounds: np.ndarray) -> bool:
    return bool(_of_full_rank(matrices, bounds)[1] < matrices.shape[1])


def _of_full_rank(matrices: np.ndarray, bounds: np.ndarray) -> tuple[list[int], int]:
    """Return the matrices of highest rank, and the rank, preferring regular positions.

    A linkage may also have a degenerate configuration in which its constraints are redundant.
    """
    clean = _in_one_size(_without_errors(matrices, bounds))[0]
    clear = [k for k, matrix in enumerate(clean) if not _nearly_singular(matrix)]
    clear = clear or list(range(len(matrices)))
    ranks = [len(Chosen(matrices[k : k + 1], bounds=bounds[k : k + 1]).rows) for k in clear]
    return [k for k, rank in zip(clear, ranks, strict=True) if rank == max(ranks)], max(ranks)


def _nearly_singular(matrix: np.ndarray) -> bool:
    sizes = np.linalg.svd(matrix, compute_uv=False) if matrix.size else np.zeros(1)
    low, high = NEARLY_DEPENDENT
    return bool(((sizes > low * sizes[0]) & (sizes < high * sizes[0])).any())


def _checked(
    name: str,
    symbols: Sequence[TimeFunction],
    chosen: Sequence[TimeFunction],
    matrices: np.ndarray,
    bounds: np.ndarray,
    rank: int,
) -> Chosen:
    """Return the user's choice, or raise an error if the constraints do not determine it."""
    argument, kind = (
        ("`dependent_coordinates`", "coordinates")
        if name == "holonomic"
        else ("`dependent_speeds`", "speeds")
    )
    if len(chosen) != rank:
        raise ValueError(
            f"{argument} must have {rank} {kind}, as many as there are independent {name} "
            f"constraints, got {len(chosen)}: {describe(chosen)}. Leave it out to have them chosen."
        )
    choice = Chosen(matrices, [symbols.index(s) for s in chosen], bounds=bounds)
    if len(choice.columns) < rank:
        raise ValueError(
            f"The {name} constraints do not give the {kind} {describe(chosen)}: their matrix is "
            f"singular at generic states. Choose other {argument}, or leave it out to have them "
            "chosen."
        )
    return choice
