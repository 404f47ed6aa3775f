"""Whether a motion kept its constraints and its energy: judged by the errors allowed in a step.

The equations keep the accelerations of all rows c at zero and, where no load or input changes it,
the energy E constant. An error of a step moves a residual or the energy once and for all; an error
of a residual's rate moves the residual further as time goes, and beside the constraints their
forces F do work. If all N steps are in error by e = atol + rtol |x|, all in one direction, then

    |c| ≤ 3 N (|∂c/∂x| + ∫ |∂c'/∂x| dt) e,
    |E - E₀| ≤ (N + 10) (|∂E/∂x| + ∫ |F| dt) e.

Tolerances may be below rounding errors: what a constraint holds against a large force keeps some
2⁻⁵² of that. A residual J u of velocities is of no account, too, if the least motion that has it,
of the energy (J u)² / (2 J M⁻¹ Jᵀ), has less than a rounding of the kinetic energy.

Sound motions stay below that, most by a factor of a hundred, whatever the method, the tolerances
and the units; a mechanism that left its constraints, or a branch of its motion, is beyond it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import isqrt
from typing import Any, NamedTuple

import numpy as np

from pydy._errors import warn_user
from pydy._interpolation import evenly
from pydy._names import few
from pydy._rank import DIGITS, least_step, or_one, roundings
from pydy.solvers.outcome import Outcome
from pydy.solvers.tuning import EXCESS, LOST, NEAR_SINGULAR, TRIED

Part = Callable[[str, np.ndarray, np.ndarray], dict[str, np.ndarray]]
"""Gives values at times (m,) and states (m, n), by name, each of the shape (m, values):

'rows'
    ``rows``, all constraints, and ``sizes``, what rounding is in proportion to.
'bounds'
    The same with bounds on rounding errors as sizes, and what 'slopes' has of the rows.
'products'
    ``products`` of the rows of the velocity constraints that were kept, as linear in the speeds.
'contradictions'
    ``rates`` of holonomic constraints that velocity constraints may not keep, ``sizes`` of their
    terms, and their derivatives ``slopes`` by the speeds; the velocity constraints ``left`` and
    their ``rows`` of derivatives. Nothing where there are none.
'slopes'
    ``rows``, ``rates`` of the holonomic ones, and derivatives of both by the states, ``slopes`` and
    ``turns``; ``solved``, the derivatives by what is solved for; ``per_unit``, the inverses of
    units that states have by themselves, or zeros.
'moving'
    ``kinetic`` energy, ``hessian``, its second derivatives by the states as far as these are
    speeds, and ``rates``, the states' derivatives. Nothing where it is not known.
'energy'
    ``kinetic`` and ``total`` energy, and the derivatives ``slopes`` of this by the states. Nothing
    where it is not known, or may change.
"""


class DriftReport(NamedTuple):
    """A defect of a motion."""

    outcome: Outcome  # LEFT_CONSTRAINTS or ENERGY_CHANGED
    place: int  # of the time and state where it was seen first
    details: dict[str, Any]  # for the text of the outcome; `row` is a number


@dataclass(frozen=True, eq=False)
class Ran:
    """Some states of a motion, and how they were computed."""

    times: np.ndarray  # (m,)
    states: np.ndarray  # (m, n): the first is where the motion begins
    steps: float | None  # None where errors are not controlled
    rtol: Any
    atol: Any
    # How near the constraints came to losing rank, where projection holds them.
    nearness: float | None = None
    mended: bool = False  # whether the motion is brought back onto the constraints
    resets: list[tuple[float, np.ndarray]] = field(default_factory=list)  # where events put it
    redundant: bool = False  # whether constraints were left out

    def errors(self, steps: float) -> np.ndarray:
        """Return the sum of the errors of so many steps if each has the allowed size."""
        sizes: np.ndarray = np.abs(self.states)
        if self.steps is None:
            return 1e-2 * sizes  # a method without error control
        return np.asarray((self.atol + self.rtol * sizes) * steps)

    def summed(self, values: np.ndarray) -> np.ndarray:
        """Integrate values over time from the beginning to each state, shape (m, values)."""
        whole: np.ndarray = np.zeros_like(values)
        parts = (values[1:] + values[:-1]) / 2.0 * np.abs(np.diff(self.times))[:, None]
        np.cumsum(parts, axis=0, out=whole[1:])
        return whole


def looked_at(states: np.ndarray, projected: bool) -> np.ndarray:
    """Return the indices of a few states, spread over the motion, including the last one.

    By projection a motion begins beside the state that was given.
    """
    found = np.flatnonzero(np.isfinite(states).all(axis=1))
    found = found[int(projected and len(found) > 1) :]
    some: np.ndarray = found[evenly(len(found), TRIED)]
    return some


def beyond_digits(rows: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Return at which states residuals exceed six digits; the axis before the last is time."""
    limits = DIGITS * sizes.max(axis=-2, keepdims=True)
    beyond: np.ndarray = (np.abs(rows) > limits).any(axis=(-2, -1))
    return beyond


def allowed_after(allowed: np.ndarray, before: np.ndarray | None) -> np.ndarray:
    """Return the allowed residuals after a reset: existing drift is not the reset's fault."""
    # It has passed on what the motion has drifted by, as it does with speeds.
    return allowed if before is None else np.maximum(allowed, 16.0 * np.abs(before))


def described(t: float, rows: np.ndarray, allowed: np.ndarray, names: Sequence[str]) -> str:
    """Describe the residuals that are larger than allowed, or return ''."""
    far = np.flatnonzero(~(np.abs(rows) <= allowed))  # NaN is
    if not far.size:
        return ""
    shares = np.abs(rows[far]) / np.where(allowed[far] > 0.0, allowed[far], 1.0)
    worst = far[np.argsort(-shares, kind="stable")]
    told = few([f"{rows[k]:.3g} in the {names[k]}" for k in worst])
    return f"The residuals at t = {t!r} are {told}."


def warn_of_reset(event: str, residuals: str, where: str = "The") -> None:
    """Warn that a reset moved the state off the constraints."""
    warn_user(
        f"{where} reset of the event `{event}` leaves the constraints, and nothing will bring the "
        f"motion back onto them. {residuals} Let the reset give all states that change, the "
        "dependent ones too."
    )


def is_near(products: np.ndarray) -> np.ndarray:
    """Return for which motions the rows nearly lost rank, given their Gram matrices (…, m, rows²).

    The measure is the least part of a row that is orthogonal to the rows before, over the largest
    that it has along the motion.
    """
    n = isqrt(products.shape[-1])
    products = products.reshape(*products.shape[:-1], n, n).copy()
    own = np.empty(products.shape[:-1])
    for k in range(n):  # Cholesky's, without roots
        own[..., k] = products[..., k, k]
        column = products[..., k + 1 :, k]
        pivot = np.where(own[..., k] > 0.0, own[..., k], np.inf)[..., None]
        products[..., k + 1 :, k + 1 :] -= (column / pivot)[..., None] * column[..., None, :]
    most = own.max(axis=-2, initial=0.0)
    shares = np.fmax(own, 0.0).min(axis=-2, initial=np.inf) / np.where(most > 0.0, most, np.inf)
    near = np.where(most > 0.0, shares, 1.0) < NEAR_SINGULAR**2
    return np.asarray(near.any(axis=-1))


def judge(ran: Ran, part: Part) -> DriftReport | None:
    """Return the defect of a motion, or None.

    Energies are looked at where residuals exceed six digits, or the constraints nearly lost rank.
    What begins beside the constraints was told of, or comes back to them: it has other energies.
    """
    t, x = ran.times, ran.states
    if not len(t):
        return None
    near = ran.nearness is not None and ran.nearness < NEAR_SINGULAR
    if ran.nearness is not None:
        if wrong := contradicted(part("contradictions", t, x)):
            return DriftReport(
                Outcome.LEFT_CONSTRAINTS, wrong[0], {"unimplied": wrong[1], "rate": wrong[2]}
            )
        if not (near or ran.redundant):  # projection holds the rows
            return None
    found = part("rows", t, x)
    limits, beyond = DIGITS * found["sizes"].max(axis=0), False
    if beyond_digits(found["rows"], found["sizes"]):
        sizes, found = found["sizes"], part("slopes", t, x)
        limits = limits + left_by_rounding(found, sizes, x).max(axis=0)
        beyond = bool((np.abs(found["rows"]) > limits).any())
    if not beyond:
        if ran.nearness is None and ran.steps is not None:
            near = bool(is_near(part("products", t, x)["products"]))
        return _energy(ran, part) if near else None
    begins = [(t[0], x[0]), *ran.resets]
    start = part("slopes", *(np.array(values) for values in zip(*begins, strict=True)))
    errors = ran.errors(EXCESS * (ran.steps or 1.0))
    beside, allowed = np.abs(start["rows"]), _moved(found["slopes"], errors).max(axis=0)
    sound = bool((beside <= allowed).all())
    if (beside > limits).any() or (ran.mended and not sound):
        return None
    allowed = allowed + beside.sum(axis=0) + ran.summed(_moved(found["turns"], errors))
    allowed = allowed + np.abs(t - t[0])[:, None] * np.abs(start["rates"]).sum(axis=0)
    if (np.abs(found["rows"]) > np.fmax(allowed, limits)).any():
        allowed = allowed + _unseen(ran, part, found["slopes"])
    off = np.abs(found["rows"]) / np.fmax(allowed, np.where(limits > 0.0, limits, 1.0))
    if (off > 1.0).any():
        k = int((off > 1.0).any(axis=1).argmax())
        row = int(np.argmax(off[k]))
        details = {"row": row, "residual": found["rows"][k, row], "explained": allowed[k, row]}
        return DriftReport(Outcome.LEFT_CONSTRAINTS, k, details)
    return _energy(ran, part) if sound else None


def contradicted(found: Mapping[str, np.ndarray]) -> tuple[int, int, float] | None:
    """Return the first state whose velocities keep the velocity but not the holonomic constraints.

    Returned are its index, that of the constraint, and its rate. The rate due to residuals of
    velocity constraints is not counted.
    """
    if not found:
        return None
    left, rates, sizes = np.abs(found["left"]), found["rates"], found["sizes"]
    m, count = rates.shape
    slopes = found["slopes"].reshape(m, count, -1)
    rows = found["rows"].reshape(m, -1, slopes.shape[2])
    for k in range(m):
        allowed = DIGITS * sizes[k]
        if left.size and np.isfinite(rows[k]).all() and np.isfinite(slopes[k]).all():
            allowed = allowed + np.abs(least_step(rows[k].T, slopes[k].T)).T @ left[k]
        if (off := np.abs(rates[k]) > allowed).any():
            j = int(off.argmax())
            return k, j, float(rates[k, j])
    return None


def _energy(ran: Ran, part: Part) -> DriftReport | None:
    if ran.resets or ran.steps is None:
        return None
    found = part("energy", ran.times, ran.states)
    if not found or not found["total"].size:
        return None
    kinetic = found["kinetic"].max()
    changes = np.abs(found["total"] - found["total"][0])[:, 0]
    # Ten more steps: long ones, and states between them, are in error by more than is allowed.
    errors = ran.errors(ran.steps + 10.0)
    allowed = _moved(found["slopes"], errors).max() + LOST * kinetic
    allowed = np.broadcast_to(allowed, changes.shape)
    if ran.nearness is None:  # beside the constraints
        found = part("moving", ran.times, ran.states)
        hessian, rates = (
            np.nan_to_num(found[name], nan=0.0, posinf=0.0, neginf=0.0)
            for name in ("hessian", "rates")
        )
        # M u' is what the constraints and loads are on each state.
        forces = np.einsum("kij,kj->ki", hessian.reshape(*rates.shape, -1), rates)
        allowed = allowed + ran.summed(_moved(forces, errors))[:, 0]
    if not (changes > allowed).any():
        return None
    k = int((changes > allowed).argmax())
    details = {"change": changes[k], "explained": allowed[k], "kinetic": kinetic}
    return DriftReport(Outcome.ENERGY_CHANGED, k, details)


def _unseen(ran: Ran, part: Part, slopes: np.ndarray) -> np.ndarray:
    """Return for each row the residual whose energy is a rounding of the kinetic energy."""
    m, n = ran.states.shape
    slopes, found = slopes.reshape(m, -1, n), part("moving", ran.times, ran.states)
    if not found:
        return np.zeros(slopes.shape[1])
    mobility = np.linalg.pinv(found["hessian"].reshape(m, n, n), hermitian=True)
    moved = np.einsum("kri,kij,krj->kr", slopes, mobility, slopes)
    share = 2.0 * np.finfo(float).eps * found["kinetic"].max()
    largest: np.ndarray = np.sqrt(share * np.fmax(moved, 0.0)).max(axis=0)
    return largest


def left_by_rounding(
    found: Mapping[str, np.ndarray], sizes: np.ndarray, x: np.ndarray
) -> np.ndarray:
    """Return the residuals (m, rows) that a search leaves by rounding, in any units.

    The rows' terms have `sizes`; ``slopes``, ``solved`` and ``per_unit`` are those of `Part`.
    States are as large as they are at any of the times, and those with a unit of their own, such as
    angles, as large as that.
    """
    m, n = x.shape
    parts = (found[name].reshape(m, -1, n) for name in ("slopes", "solved"))
    slopes, solved = (np.nan_to_num(a, nan=0.0, posinf=0.0, neginf=0.0) for a in parts)
    per_unit = found["per_unit"]
    units = np.where(per_unit > 0.0, 1.0 / or_one(per_unit), 0.0)
    natural = np.fmax(np.abs(x).max(axis=0), units)
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is told as it is
        terms = (np.abs(slopes) @ natural[..., None])[..., 0]
        return roundings(solved, np.fmax(sizes, terms))


def _moved(slopes: np.ndarray, errors: np.ndarray) -> np.ndarray:
    """Return bounds on the change of some values by errors of the states, at each state."""
    sizes = np.abs(slopes.reshape(len(errors), -1, errors.shape[1])) * errors[:, None]
    moved: np.ndarray = sizes.sum(axis=2)
    return moved
