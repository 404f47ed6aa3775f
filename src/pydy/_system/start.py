"""Whether a motion begins on the constraints: initially, and after the reset of an event."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._errors import few, warn_user
from pydy._rank import DIGITS
from pydy._system.redundancy import check_redundant, evaluated_rows
from pydy._system.solving import constraint_names
from pydy._system.tuning import TRIED
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
    held = surely_held(definition, model, np.array([t]), x[None], r[None], p)[0]
    if held and not any(definition.equations.left_out):
        return False
    told = "" if held else violations(definition, model, t, x, r, p, redundant=False)
    if not told:
        check_redundant(definition, model, t, x, r, p)
        told = violations(definition, model, t, x, r, p)
    if told and not mended:
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
    """Return which of m states have no `violations`, as far as the last operations tell."""
    residuals, sizes = evaluated_rows(definition, model, "sizes", (t, x, r, p))
    held: np.ndarray = (np.abs(residuals) <= DIGITS * sizes).all(axis=1)  # NaN is not
    return held


def violations(
    definition: Definition,
    model: CompiledModel,
    t: float,
    x: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
    redundant: bool = True,
) -> str:
    """Name the residuals of a state that is farther from the constraints than six digits are.

    A residual is compared with the bound on its rounding errors, if six digits were computed with.

    Parameters
    ----------
    definition : Definition
    model : CompiledModel
        With all expressions compiled in.
    t, x, r, p
    redundant : bool
        Whether constraints that were left out as redundant are judged too.

    Returns
    -------
    str
        A sentence, or nothing.
    """
    at = (np.array([t]), x[None], r[None], p)
    if surely_held(definition, model, *at)[0]:
        return ""
    residuals, bounds = (part[0] for part in evaluated_rows(definition, model, "bounds", at))
    allowed = DIGITS * bounds
    off = ~(np.abs(residuals) <= allowed)
    equations = definition.equations
    parts = zip((equations.holonomic, equations.velocity), equations.left_out, strict=True)
    lengths = [len(rows) for pair in parts for rows in pair]
    off &= np.repeat([True, redundant] * 2, lengths)
    far = np.flatnonzero(off)
    if not far.size:
        return ""
    shares = np.abs(residuals[far]) / np.where(allowed[far] > 0.0, allowed[far], 1.0)
    worst = far[np.argsort(-shares, kind="stable")]
    names = constraint_names(equations, redundant=True)
    told = few([f"{residuals[k]:.3g} in the {names[k]}" for k in worst])
    return f"The residuals at t = {t!r} are {told}."


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
