"""Which coordinates and speeds depend on the others, by elimination at generic states.

The derivatives of the constraints are eliminated with complete pivoting, at several states at once:
a pivot is as good as it is at the worst of them. What is left below the rank is redundant.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from pydy._checks import describe
from pydy._graph import Graph, jacobian, rounding_bounds, signatures
from pydy._mechanics.equations import Equations
from pydy._mechanics.formed import kinematics_of
from pydy._mechanics.generic import AROUND, Block, GenericStates, closed, openness, units_of
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.tuning import DIGITS, NEARLY_DEPENDENT
from pydy._names import few
from pydy._rank import HALF, OF_FEW, ROUNDED, equilibrated, is_zero, or_one

_TRIALS = 12
_SHARE = 0.1  # of the largest residual: what is named with it


class Chosen:
    """Rows that are independent, and as many columns that can be solved for, in ascending order.

    The `samples` (m, n) are one matrix at several states, known within `bounds`; the columns are
    chosen from those `allowed`, those that come `first` before others. Entries that are `varying`
    depend on the configuration: elsewhere they may vanish, as no constant does. A pivot counts if
    half the digits of its row tell it, or of its row and column after all were brought to one size,
    and it is larger than its bound.
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
            # A pivot that is the same in all configurations is as good as a ten times larger one.
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
            known = errors[:, :, j] + np.abs(ratio) * errors[:, i, j][:, None]
            known = np.where(ratio != 0.0, known / np.abs(work[:, i, j])[:, None], 0.0)
            errors += np.abs(ratio)[:, :, None] * errors[:, i, :][:, None, :]
            errors += known[:, :, None] * np.abs(work[:, i, :])[:, None, :]
            work -= ratio[:, :, None] * work[:, i, :][:, None, :]
            free[i, :] = free[:, j] = False
        self.rows, self.columns = sorted(rows), sorted(columns)


def _without_errors(matrices: np.ndarray, bounds: np.ndarray) -> np.ndarray:
    """Replace entries that are small in their row and within their rounding bound by zeros."""
    sizes = np.abs(matrices)
    small = sizes < HALF * sizes.max(axis=2, keepdims=True, initial=0.0)
    found: np.ndarray = np.where(small & (sizes <= bounds), 0.0, matrices)
    return found


def _in_one_size(matrices: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Scale matrices at several states to rows and columns of size one; return the scales too.

    The largest of each is near one at one of the states: rows may vanish in singular positions.
    """
    _, rows, columns = equilibrated(np.abs(matrices).max(axis=0), exact=True)
    return matrices * columns / rows, rows, columns


def constrained(
    body: Multibody,
    holonomic: Sequence[Any],
    velocity: Sequence[Any],
    coordinates: Sequence[Any] | None = None,
    speeds: Sequence[Any] | None = None,
    near: Mapping[Any, float] | None = None,
) -> Multibody:
    """Return the same with constraints, and with dependent coordinates and speeds chosen.

    Redundant constraints are left out, and those that all motions satisfy: the kinematic equations
    keep the norm of a quaternion. The user may choose dependent `coordinates` and `speeds`, and a
    configuration `near` which the mechanism is assembled.
    """
    velocity = _moving_rows(kinematics_of(body), velocity)
    body = replace(body, holonomic=tuple(holonomic), velocity=tuple(velocity))
    found = _choose(kinematics_of(body), coordinates, speeds, near)
    (places, q_dep), (motions, u_dep), rounded = found
    return replace(
        body,
        holonomic=tuple(body.holonomic[k] for k in places.rows),
        velocity=tuple(body.velocity[k] for k in motions.rows),
        dependent_coordinates=q_dep,
        dependent_speeds=u_dep,
        chosen=(
            *(() if coordinates else (q for q in q_dep if q not in body.dependent_coordinates)),
            *(() if speeds else u_dep),
        ),
        redundant=_others(body.velocity, motions.rows, [k - len(holonomic) for k in rounded]),
        closed=_others(body.holonomic, places.rows, rounded),
        changing=speeds is None,
    )


def _others(rows: Sequence[Any], kept: Sequence[int], rounded: Sequence[int]) -> tuple[Any, ...]:
    return tuple(e for k, e in enumerate(rows) if k not in kept and k not in rounded)


def _moving_rows(equations: Equations, expressions: Sequence[Any]) -> list[Any]:
    """Return the velocity constraints that are not zero for all motions."""
    states = GenericStates(equations, expressions, "the velocity constraints")
    values = signatures(states.graph, states.read.all(expressions))
    return [e for e, value in zip(expressions, values, strict=True) if value]


def _choose(
    equations: Equations,
    coordinates: Sequence[Any] | None,
    speeds: Sequence[Any] | None,
    near: Mapping[Any, float] | None,
) -> tuple[tuple[Chosen, tuple[Any, ...]], tuple[Chosen, tuple[Any, ...]], list[int]]:
    """Return the independent constraints, and the coordinates and speeds that follow from them."""
    states = GenericStates(equations, (), "the constraints")
    _check_linear(equations, states)
    rows = _of_rounding(states)
    # √(x²) - x is nothing where x is positive, as all was. Where it is not tells a configuration.
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
    found = []
    for block, symbols, chosen in zip(
        tables,
        (equations.coordinates, equations.speeds),
        (coordinates, speeds),
        strict=True,
    ):
        name, shape, cells = block
        matrices, bounds = _known(states, samples, block)
        full, rank = _of_full_rank(matrices, bounds)
        varying = np.array([states.changes(node) for node in cells], dtype=bool).reshape(shape)
        first = [k for k, s in enumerate(symbols) if s in equations.dependents.coordinates]
        for some in range(3, 0, -1):  # other ways of assembly may have no pivot in common
            own = matrices[full[:some]], bounds[full[:some]]
            choice = Chosen(own[0], varying=varying, bounds=own[1], first=first)
            if len(choice.rows) == rank:
                break
        matrices, bounds = own
        if chosen is not None:
            choice = _checked(name, symbols, chosen, matrices, bounds, len(choice.columns))
        found.append((choice, tuple(symbols[k] for k in choice.columns)))
    return found[0], found[1], rows


def _searched(
    states: GenericStates, near: Mapping[Any, float] | None
) -> tuple[list[Block], list[dict[str, np.ndarray]]]:
    """Return the constraints' derivatives by coordinates and by speeds, and values of both."""
    blocks = states.closing()
    every = list(states.samples(blocks, _TRIALS, near=near, left_open=True))
    samples = closed(every)
    if not near and (not samples or _seem_redundant(*_known(states, samples, blocks[1]))):
        every += states.samples(blocks, AROUND, around=True, left_open=True)
    return blocks[:2], every


def _of_rounding(states: GenericStates) -> list[int]:
    """Return rows that are zero up to rounding, and rows of terms that are rounding errors.

    In an oblique plane the directions of two hinges are parallel whatever the angles, up to what
    rounding leaves of terms that cancel. Where SymPy adds up numbers beforehand, it leaves a row of
    1e-17: terms no larger than rounding errors of what they were made of, as the numbers tell, or
    of all other rows of their kind. At states that have not been searched for, since such a row may
    have a root, and a row of squares of nanometres is as small where it holds. Rates are in the
    units of their holonomic rows, which may be any beside those of the others: they are what these
    are.

    Rows have units: directions and gears are numbers, of order one beside lengths of nanometres and
    squares of kilometres. What is as large as a number, or as lengths of the mechanism and their
    squares, is not small because other rows are large.
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
    known = {
        first + j: int(k)
        for j, own in enumerate(at["velocity"].T)
        for k in np.flatnonzero(
            (np.abs(rates - own[:, None]) <= HALF * np.abs(rates)).all(axis=0) & own.any()
        )[:1]
    }
    values = np.concatenate([at["holonomic"], at["velocity"]], axis=1)
    nothing = _nothing(values, at["bounds"])
    found = _constant(states, np.flatnonzero(nothing))
    made_of = np.array([_cancelled(graph, node) for node in every])
    found += [int(k) for k in np.flatnonzero((sizes > 0.0) & (sizes <= OF_FEW * made_of))]
    lengths = np.array(states.placed)
    for part in (range(first), [k for k in range(first, len(sizes)) if k not in known]):
        largest = max((sizes[k] for k in part), default=0.0)
        found += [
            k
            for k in part
            if sizes[k] > 0.0
            and sizes[k] <= OF_FEW * largest
            and not _as_large_as(sizes[k], lengths)
            and k not in found
        ]
    return found + [j for j, k in known.items() if k in found and j not in found]


def _cancelled(graph: Graph, node: int) -> float:
    """Return how large the numbers were that left the coefficients of a sum when they cancelled.

    A sum of numbers is a multiple of the last place of the smallest: what is left of terms that
    cancel has few of a float's bits, but many decimals. A number that someone typed, or that was
    computed from such without cancellation, has not both.
    """
    if graph.ops[node] != "sum":
        return 0.0
    constant, terms = graph.args[node]
    found = 0.0
    for value in map(abs, (constant, *(c for _, c in terms))):
        if not math.isfinite(value):
            continue
        odd, last = value.as_integer_ratio()  # the last place is one over a power of two
        decimals = repr(value).partition("e")[0].replace(".", "").strip("0")
        if 2 * odd.bit_length() < sys.float_info.mant_dig and len(decimals) > DIGITS:
            found = max(found, math.ldexp(1.0, sys.float_info.mant_dig + 1 - last.bit_length()))
    return found


def _as_large_as(size: float, lengths: np.ndarray) -> bool:
    """Return whether a row may be one of numbers, or of lengths or their squares."""
    units = np.concatenate([lengths, lengths**2])
    return bool(size > HALF or ((size > HALF * units) & (HALF * size < units)).any())


def _known(
    states: GenericStates, samples: list[dict[str, np.ndarray]], block: Block
) -> tuple[np.ndarray, np.ndarray]:
    """Return the matrices of a block at samples, and bounds on their entries' errors.

    Those are evaluated where an entry is so small in its row that rounding could make a pivot of
    it after it was brought to the size of the others. Elsewhere rows tell enough.
    """
    name, (count, width), cells = block
    matrices = np.array([s[name] for s in samples]).reshape(len(samples), count, width)
    sizes = np.abs(matrices)
    largest = sizes.max(axis=2, keepdims=True, initial=0.0)
    if not ((sizes > 0.0) & is_zero(HALF * sizes, largest)).any():
        return matrices, np.broadcast_to(largest, matrices.shape)
    return matrices, states.uncertain(samples, cells).reshape(matrices.shape)


def _nothing(values: np.ndarray, bounds: np.ndarray) -> np.ndarray:
    """Return which values are zero up to rounding at all states although their terms are not."""
    left: np.ndarray = (np.abs(values) <= ROUNDED * bounds).all(axis=0) & (bounds > 0.0).all(axis=0)
    return left


def _constant(states: GenericStates, rows: Iterable[int], sign: float = 1.0) -> list[int]:
    """Return the rows that no input changes by more than rounding, with inputs of one `sign`.

    A row of large terms may be no more than their rounding, but changes with what they hold.
    """
    every = [*states.holonomic, *states.velocity]
    found = []
    for k in map(int, rows):
        name, shape, cells = states.table("slopes", [every[k]], states.inputs)
        bounds = rounding_bounds(states.graph, cells)
        at = states.anywhere([(name, shape, cells), ("bounds", shape, bounds)], sign)
        slopes, terms = at[name], at["bounds"]
        small = np.abs(slopes) <= ROUNDED * terms
        if (small | (np.isnan(slopes) & (sign < 0.0))).all():  # no value, as of √x, tells nothing
            found.append(k)
    return found


def _check_linear(equations: Equations, states: GenericStates) -> None:
    """Refuse holonomic constraints that hold speeds, and others that are not linear in them."""
    speeds, slopes = set(states.speeds), jacobian(states.graph, states.velocity, states.speeds)

    def held(nodes: Sequence[int]) -> bool:
        return not speeds.isdisjoint(states.graph.reachable(nodes))

    rows = equations.constraints
    for k, (e, node) in enumerate(zip(rows.holonomic, states.holonomic, strict=True)):
        if held([node]):
            raise ValueError(
                f"The holonomic constraint {k}, `{e}`, holds speeds or derivatives. Give it as a "
                "velocity constraint."
            )
    for k, (e, row) in enumerate(zip(rows.velocity, slopes, strict=True)):
        if held([*row.values()]):
            raise ValueError(
                f"The velocity constraint {k}, `{e}`, is not linear in the speeds. Replace it with "
                "one that is."
            )


def _seem_redundant(matrices: np.ndarray, bounds: np.ndarray) -> bool:
    return bool(_of_full_rank(matrices, bounds)[1] < matrices.shape[1])


def _of_full_rank(matrices: np.ndarray, bounds: np.ndarray) -> tuple[list[int], int]:
    """Return which are of highest rank, and the rank, away from singular positions where possible.

    A linkage may be assembled in a degenerate way too, in which its constraints are redundant.
    """
    clean = _in_one_size(_without_errors(matrices, bounds))[0]
    clear = [k for k, own in enumerate(clean) if not _nearly_singular(own)]
    clear = clear or list(range(len(matrices)))
    ranks = [len(Chosen(matrices[k : k + 1], bounds=bounds[k : k + 1]).rows) for k in clear]
    return [k for k, rank in zip(clear, ranks, strict=True) if rank == max(ranks)], max(ranks)


def _nearly_singular(matrix: np.ndarray) -> bool:
    sizes = np.linalg.svd(matrix, compute_uv=False) if matrix.size else np.zeros(1)
    low, high = NEARLY_DEPENDENT
    return bool(((sizes > low * sizes[0]) & (sizes < high * sizes[0])).any())


def _checked(
    name: str,
    symbols: Sequence[Any],
    chosen: Sequence[Any],
    matrices: np.ndarray,
    bounds: np.ndarray,
    rank: int,
) -> Chosen:
    """Return a user's choice, or say why the constraints do not give it."""
    argument, others = (
        ("`dependent_coordinates`", "coordinates")
        if name == "holonomic"
        else ("`dependent_speeds`", "speeds")
    )
    if len(chosen) != rank:
        raise ValueError(
            f"{argument} must have {rank} {others}, as many as there are independent {name} "
            f"constraints, got {len(chosen)}: {describe(chosen)}. Leave it out to have them chosen."
        )
    made = Chosen(matrices, [symbols.index(s) for s in chosen], bounds=bounds)
    if len(made.columns) < rank:
        raise ValueError(
            f"The {name} constraints do not give the {others} {describe(chosen)}: their matrix is "
            f"singular at generic states. Choose other {argument}, or leave it out to have them "
            "chosen."
        )
    return made
