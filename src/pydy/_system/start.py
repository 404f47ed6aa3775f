"""Whether a motion begins on the constraints: initially, and after the reset of an event."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._errors import warn_user
from pydy._graph.derivative import dense_jacobian
from pydy._system.redundancy import check_redundant
from pydy._system.solving import constraint_names
from pydy._system.tuning import DIGITS, HELD, TRIED
from pydy.trajectory import EventRecord

__all__ = ["check_resets", "check_samples", "check_start", "surely_held", "violations"]


def check_start(
    definition: Definition,
    model: CompiledModel,
    t: float,
    x: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
    whose: str = "",
    mended: bool = False,
) -> bool:
    """Warn where a motion starts off the constraints; return whether it does.

    Where it does not, what was left out as redundant must hold too: see `check_redundant`.

    The parameters are those of `violations`, and

    whose : str
        Says in the warning which initial conditions are meant.
    mended : bool
        Whether the motion is brought onto the constraints, so that there is nothing to warn of.
    """
    told = violations(definition, model, t, x, r, p)
    if not told:
        check_redundant(definition, model, t, x, r, p)
    elif not mended:
        warn_user(
            f"The initial conditions{whose} do not satisfy the constraints, and nothing will bring "
            f"the motion back onto them. {told} Call "
            "`system.set_dependent_initial_conditions()` first."
        )
    return bool(told)


def check_resets(
    definition: Definition,
    model: CompiledModel,
    records: Iterable[EventRecord],
    specified: Callable[[np.ndarray, float], np.ndarray],
    p: np.ndarray,
) -> None:
    """Warn of the first reset of each event that leaves the constraints.

    Parameters
    ----------
    definition : Definition
    model : CompiledModel
        With all expressions compiled in.
    records : iterable of EventRecord
    specified : callable
        Gives r at a state and time.
    p : ndarray
    """
    told: set[str] = set()
    for record in records:
        if record.name in told or (record.after == record.before).all():
            continue
        x, t = record.after, record.time
        if off := violations(definition, model, t, x, specified(x, t), p):
            told.add(record.name)
            warn_user(
                f"The reset of the event `{record.name}` leaves the constraints, and nothing will "
                f"bring the motion back onto them. {off} Let the reset give all states that "
                "change, the dependent ones too."
            )


def surely_held(
    definition: Definition,
    model: CompiledModel,
    t: np.ndarray,
    x: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
) -> np.ndarray:
    """Return which of m states have no `violations`, as far as their residuals alone tell."""
    return _residuals_at(len(definition.equations.coordinates), model, (t, x, r, p))[1]


def _residuals_at(
    n: int,
    model: CompiledModel,
    at: tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray],
) -> tuple[np.ndarray, np.ndarray]:
    """Return residuals (m, rows), and which states they are nothing in."""
    residuals = np.concatenate(list(model.interpreted(_residuals, at).values()), axis=1)
    # Residuals may be squares of lengths: of micrometres these are 1e-12 m².
    lengths = np.abs(at[1][:, :n]).max(axis=1, initial=0.0)
    lengths = np.where(lengths > 0.0, np.minimum(lengths, 1.0), 1.0)
    within = np.abs(residuals).max(axis=1, initial=0.0) < HELD * lengths**2  # NaN is not
    return residuals, within


def violations(
    definition: Definition,
    model: CompiledModel,
    t: float,
    x: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
) -> str:
    """Name the residuals of a state that is farther from the constraints than six digits are.

    A residual is compared with the sum of the products of its derivatives by the states and the
    rounding of these, a part of 1e-5 of each state, or of the largest coordinate or speed where
    that is larger.

    Parameters
    ----------
    definition : Definition
    model : CompiledModel
        With all expressions compiled in.
    t, x, r, p

    Returns
    -------
    str
        A sentence, or nothing.
    """
    n = len(definition.equations.coordinates)
    at = (np.array([t]), x[None], r[None], p)
    residuals, within = _residuals_at(n, model, at)
    if within[0]:
        return ""
    residuals = residuals[0]
    size = np.abs(x)
    for part in (slice(n), slice(n, None)):
        size[part] = np.maximum(size[part], size[part].max(initial=0.0) or 1.0)
    found = model.interpreted(_slopes, at).values()
    slopes = np.concatenate([part.reshape(-1, len(x)) for part in found])
    with np.errstate(over="ignore"):
        allowed = DIGITS * (np.abs(slopes) @ size)
    far = np.flatnonzero(~(np.abs(residuals) <= allowed))
    if not far.size:
        return ""
    names = constraint_names(definition.equations)
    worst = far[np.argsort(-np.abs(residuals[far]))][:3]
    told = "; ".join(f"{residuals[k]:.3g} in the {names[k]}" for k in worst)
    more = f"; and {far.size - 3} more" if far.size > 3 else ""
    return f"The residuals at t = {t!r} are {told}{more}."


def _residuals(assembly: Assembly) -> dict[str, list[int]]:
    return {"holonomic": assembly.holonomic, "velocity": assembly.velocity}


def _slopes(assembly: Assembly) -> dict[str, list[int]]:
    graph = assembly.graph
    states = [graph.input("x", k) for k in range(assembly.sizes[0])]
    return {
        name: dense_jacobian(graph, nodes, states) for name, nodes in _residuals(assembly).items()
    }


def check_samples(
    definition: Definition,
    model: CompiledModel,
    t: float,
    specified: Callable[[np.ndarray, float], np.ndarray],
    columns: tuple[Sequence[np.ndarray], Sequence[np.ndarray], Sequence[np.ndarray]],
    shape: tuple[int, ...],
    mended: bool,
) -> None:
    """Warn of the first sample of an ensemble that is off the constraints, of 64 that are tried.

    Parameters
    ----------
    definition : Definition
    model : CompiledModel
    t : float
    specified : callable
        Gives r at a state and time, where no sample has its own.
    columns : (x, r, p)
        For each symbol an array that can be broadcast to `shape`.
    shape : tuple of int
        Of the samples.
    mended : bool
        See `check_start`.
    """
    total = int(np.prod(shape))
    for number in np.unique(np.linspace(0, total - 1, min(total, TRIED)).astype(int)):
        at = np.unravel_index(number, shape)
        x, own, p = (np.array([np.broadcast_to(a, shape)[at] for a in part]) for part in columns)
        varied = [np.size(a) > 1 for a in columns[1]]
        r = np.where(varied, own, specified(x, t)) if len(own) else own
        whose = f" of sample {', '.join(map(str, at))}" if shape else ""
        if check_start(definition, model, t, x, r, p, whose, mended):
            return
