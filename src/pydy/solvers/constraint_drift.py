"""Whether a motion satisfied its constraints and conserved its energy, within its tolerances.

The equations keep the accelerations of all rows c at zero and, where no load or input changes it,
the energy E constant. An error of a step changes a residual or the energy once; an error of a
residual's rate changes the residual in proportion to time, and off the constraints their forces F
do work. If all N steps are in error by e = atol + rtol |x|, all in one direction, then

    |c| ≤ 3 N (|∂c/∂x| + ∫ |∂c'/∂x| dt) e,
    |E - E₀| ≤ (N + 10) (|∂E/∂x| + ∫ |F| dt) e.

Tolerances may be below rounding errors: a constraint against a large force has a residual of some
2⁻⁵² of that force. A residual J u of velocities does not count either if the smallest motion with
that residual, of energy (J u)² / (2 J M⁻¹ Jᵀ), has less than a rounding of the kinetic energy.

Sound motions stay below these bounds, most by a factor of a hundred, whatever the method, the
tolerances and the units; a mechanism that left its constraints, or a branch of its motion, exceeds
them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import isqrt
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from pydy._errors import warn_user
from pydy._interpolation import evenly
from pydy._names import few
from pydy._rank import DIGITS, least_step, or_one, roundings
from pydy.solvers.outcome import Outcome
from pydy.solvers.tuning import ENERGY_ROUNDING, EXCESS, NEAR_SINGULAR

if TYPE_CHECKING:
    pass

DriftQuantities = Callable[[str, np.ndarray, np.ndarray], dict[str, np.ndarray]]
"""Evaluates quantities at times (m,) and states (m, n), by name, each of the shape (m, values):

'rows'
    ``rows``, residuals of all constraints, and ``sizes``, the scales of their rounding errors.
'bounds'
    The same with bounds on rounding errors as sizes, and the derivatives of the rows as in
    'slopes'.
'products'
    ``products``, the Gram matrices of the independent velocity constraints, linear in the speeds.
'contradictions'
    ``rates`` of holonomic constraints that velocity constraints may not imply, ``sizes`` of their
    terms, and their derivatives ``slopes`` by the speeds; the residuals ``left`` of the velocity
    constraints and their ``rows`` of derivatives. Empty if there are none.
'slopes'
    ``rows``, ``rates`` of the holonomic ones, and derivatives of both by the states, ``slopes`` and
    ``turns``; ``solved``, the derivatives by the unknowns of the projection; ``per_unit``, the
    inverses of units that states have by themselves, or zeros.
'moving'
    ``kinetic`` energy, ``hessian``, its second derivatives by the states as far as these are
    speeds, and ``rates``, the states' derivatives. Empty if it is not known.
'energy'
    ``kinetic`` and ``total`` energy, and the derivatives ``slopes`` of this by the states. Empty
    if it is not known, or may change.
"""


class DriftReport(NamedTuple):
    """A defect of a motion: which it is, and the first state that shows it."""

    outcome: Outcome  # LEFT_CONSTRAINTS or ENERGY_CHANGED
    state_index: int  # of the first time and state at which it was observed
    details: dict[str, Any]  # for the text of the outcome; `row` is a number

    @classmethod
    def contradiction(cls, rates: Mapping[str, np.ndarray]) -> DriftReport | None:
        """Report the first state that satisfies the velocity but not the holonomic constraints.

        The `rates` are the 'contradictions' of `DriftQuantities`. The details are the constraint's
        number, `unimplied`, and its `rate`. The rate due to residuals of velocity constraints is
        not counted.
        """
        if not rates:
            return None
        residuals, sizes = np.abs(rates["left"]), rates["sizes"]
        m, count = rates["rates"].shape
        slopes = rates["slopes"].reshape(m, count, -1)
        rows = rates["rows"].reshape(m, -1, slopes.shape[2])
        for k, values in enumerate(rates["rates"]):
            allowed = DIGITS * sizes[k]
            if residuals.size and np.isfinite(rows[k]).all() and np.isfinite(slopes[k]).all():
                step = least_step(rows[k].T, slopes[k].T)
                allowed = allowed + np.abs(step).T @ residuals[k]
            if (off := np.abs(values) > allowed).any():
                j = int(off.argmax())
                return cls(Outcome.LEFT_CONSTRAINTS, k, {"unimplied": j, "rate": float(values[j])})
        return None


class ConstraintResiduals(NamedTuple):
    """Residuals of the constraints in one state or in several, and the largest that are allowed."""

    rows: np.ndarray  # (..., rows)
    allowed: np.ndarray

    @staticmethod
    def rounding(
        values: Mapping[str, np.ndarray], sizes: np.ndarray, states: np.ndarray
    ) -> np.ndarray:
        """Return the residuals (m, rows) that a projection leaves by rounding, in any units.

        The rows' terms have `sizes`; `values` are the 'slopes' of `DriftQuantities`. States are
        taken as large as they are at any of the times, and those with a unit of their own, such as
        angles, at least as large as that unit.
        """
        m, n = states.shape
        derivatives = (values[name].reshape(m, -1, n) for name in ("slopes", "solved"))
        slopes, solved = (
            np.nan_to_num(rows, nan=0.0, posinf=0.0, neginf=0.0) for rows in derivatives
        )
        per_unit = values["per_unit"]
        units = np.where(per_unit > 0.0, 1.0 / or_one(per_unit), 0.0)
        scales = np.fmax(np.abs(states).max(axis=0), units)
        with np.errstate(over="ignore", invalid="ignore"):  # an overflow is reported as inf
            terms = (np.abs(slopes) @ scales[..., None])[..., 0]
            return roundings(solved, np.fmax(sizes, terms))

    def after_reset(self, before: np.ndarray | None) -> ConstraintResiduals:
        """Allow residuals that those `before` a reset explain: a reset does not cause drift.

        A reset may pass on the drift enlarged, as it does with speeds.
        """
        if before is None:
            return self
        return self._replace(allowed=np.maximum(self.allowed, 16.0 * np.abs(before)))

    def describe(self, t: float, names: Sequence[str]) -> str:
        """Describe the residuals (rows,) that are larger than allowed, or return ''."""
        rows, allowed = self
        exceeding = np.flatnonzero(~(np.abs(rows) <= allowed))  # NaN does
        if not exceeding.size:
            return ""
        limits = np.where(allowed[exceeding] > 0.0, allowed[exceeding], 1.0)
        worst = exceeding[np.argsort(-(np.abs(rows[exceeding]) / limits), kind="stable")]
        residuals = few([f"{rows[k]:.3g} in the {names[k]}" for k in worst])
        return f"The residuals at t = {t!r} are {residuals}."

    @staticmethod
    def warn_of_reset(event: str, description: str, subject: str = "The") -> None:
        """Warn that a reset moved the state off the constraints."""
        warn_user(
            f"{subject} reset of the event `{event}` leaves the constraints, and nothing will "
            f"bring the motion back onto them. {description} Let the reset give all states that "
            "change, the dependent ones too."
        )


@dataclass(frozen=True, eq=False)
class DriftCheck:
    """Selected states of a motion, with the solver's tolerances and steps, to check for drift."""

    NEAR_SINGULAR: ClassVar[float] = NEAR_SINGULAR
    MOST_STATES: ClassVar[int] = 64
    """States along a motion, or samples of an ensemble, whose constraints are checked.

    One is enough to warn; 64 take milliseconds, and are spread over all."""

    times: np.ndarray  # (m,)
    states: np.ndarray  # (m, n): the first is where the motion begins
    steps: float | None  # None if errors are not controlled
    rtol: float | np.ndarray
    atol: float | np.ndarray
    # The smallest measure of the constraints' rank, if the solver projects the states.
    nearness: float | None = None
    corrected: bool = False  # whether the motion is brought back onto the constraints
    resets: list[tuple[float, np.ndarray]] = field(default_factory=list)  # times, states after
    redundant: bool = False  # whether constraints were left out

    @classmethod
    def selected(cls, states: np.ndarray, projected: bool) -> np.ndarray:
        """Return the indices of a few states, spread over the motion, including the last one.

        The first one is left out if the motion is `projected`: it may be off the constraints.
        """
        finite = np.flatnonzero(np.isfinite(states).all(axis=1))
        finite = finite[int(projected and len(finite) > 1) :]
        indices: np.ndarray = finite[evenly(len(finite), cls.MOST_STATES)]
        return indices

    @staticmethod
    def exceeds_six_digits(rows: np.ndarray, sizes: np.ndarray) -> np.ndarray:
        """Return at which states residuals exceed six digits; the axis before the last is time."""
        limits = DIGITS * sizes.max(axis=-2, keepdims=True)
        exceeds: np.ndarray = (np.abs(rows) > limits).any(axis=(-2, -1))
        return exceeds

    @staticmethod
    def nearly_loses_rank(products: np.ndarray) -> np.ndarray:
        """Return for which motions the rows nearly lost rank, from Gram matrices (…, m, rows²).

        The measure is the smallest part of a row that is orthogonal to the rows before, divided by
        the largest such part along the motion.
        """
        n = isqrt(products.shape[-1])
        products = products.reshape(*products.shape[:-1], n, n).copy()
        pivots = np.empty(products.shape[:-1])
        for k in range(n):  # Cholesky factorisation without square roots
            pivots[..., k] = products[..., k, k]
            column = products[..., k + 1 :, k]
            pivot = np.where(pivots[..., k] > 0.0, pivots[..., k], np.inf)[..., None]
            products[..., k + 1 :, k + 1 :] -= (column / pivot)[..., None] * column[..., None, :]
        most = pivots.max(axis=-2, initial=0.0)
        least = np.fmax(pivots, 0.0).min(axis=-2, initial=np.inf)
        shares = least / np.where(most > 0.0, most, np.inf)
        near = np.where(most > 0.0, shares, 1.0) < NEAR_SINGULAR**2
        return np.asarray(near.any(axis=-1))

    def report(self, quantities: DriftQuantities) -> DriftReport | None:
        """Return the defect of the motion, or None.

        Energies are compared if residuals exceed six digits or the constraints nearly lost rank.
        A motion that begins off the constraints has been warned of, or comes back to them with
        another energy.
        """
        t, x = self.times, self.states
        if not len(t):
            return None
        near = self.nearness is not None and self.nearness < NEAR_SINGULAR
        if self.nearness is not None:
            contradiction = DriftReport.contradiction(quantities("contradictions", t, x))
            # Projection satisfies the rows that it projects onto.
            if contradiction is not None or not (near or self.redundant):
                return contradiction
        values = quantities("rows", t, x)
        limits, exceeds = DIGITS * values["sizes"].max(axis=0), False
        if self.exceeds_six_digits(values["rows"], values["sizes"]):
            sizes, values = values["sizes"], quantities("slopes", t, x)
            limits = limits + ConstraintResiduals.rounding(values, sizes, x).max(axis=0)
            exceeds = bool((np.abs(values["rows"]) > limits).any())
        if not exceeds:
            if self.nearness is None and self.steps is not None:
                near = bool(self.nearly_loses_rank(quantities("products", t, x)["products"]))
            return self._energy_report(quantities) if near else None
        begins = [(t[0], x[0]), *self.resets]
        start = quantities("slopes", *(np.array(column) for column in zip(*begins, strict=True)))
        errors = self._errors(EXCESS * (self.steps or 1.0))
        offsets, allowed = np.abs(start["rows"]), _propagated(values["slopes"], errors).max(axis=0)
        sound = bool((offsets <= allowed).all())
        if (offsets > limits).any() or (self.corrected and not sound):
            return None
        allowed = allowed + offsets.sum(axis=0)
        allowed = allowed + self._integrated(_propagated(values["turns"], errors))
        allowed = allowed + np.abs(t - t[0])[:, None] * np.abs(start["rates"]).sum(axis=0)
        if (np.abs(values["rows"]) > np.fmax(allowed, limits)).any():
            allowed = allowed + self._residuals_of_rounding(quantities, values["slopes"])
        limits = np.fmax(allowed, np.where(limits > 0.0, limits, 1.0))
        ratios = np.abs(values["rows"]) / limits
        if (ratios > 1.0).any():
            k = int((ratios > 1.0).any(axis=1).argmax())
            row = int(np.argmax(ratios[k]))
            details = {"row": row, "residual": values["rows"][k, row], "explained": allowed[k, row]}
            return DriftReport(Outcome.LEFT_CONSTRAINTS, k, details)
        return self._energy_report(quantities) if sound else None

    def _errors(self, steps: float) -> np.ndarray:
        """Return the sum of the errors of so many steps if each has the allowed size."""
        sizes: np.ndarray = np.abs(self.states)
        if self.steps is None:
            return 1e-2 * sizes  # a method without error control
        return np.asarray((self.atol + self.rtol * sizes) * steps)

    def _integrated(self, values: np.ndarray) -> np.ndarray:
        """Integrate values over time from the beginning to each state, shape (m, values)."""
        integrals: np.ndarray = np.zeros_like(values)
        means = (values[1:] + values[:-1]) / 2.0 * np.abs(np.diff(self.times))[:, None]
        np.cumsum(means, axis=0, out=integrals[1:])
        return integrals

    def _energy_report(self, quantities: DriftQuantities) -> DriftReport | None:
        """Return a change of the total energy that the tolerances do not explain, or None."""
        if self.resets or self.steps is None:
            return None
        energy = quantities("energy", self.times, self.states)
        if not energy or not energy["total"].size:
            return None
        kinetic = energy["kinetic"].max()
        changes = np.abs(energy["total"] - energy["total"][0])[:, 0]
        # Ten more steps: the errors of long steps, and of states between them, exceed the allowed.
        errors = self._errors(self.steps + 10.0)
        allowed = _propagated(energy["slopes"], errors).max() + ENERGY_ROUNDING * kinetic
        allowed = np.broadcast_to(allowed, changes.shape)
        if self.nearness is None:  # off the constraints their forces do work
            moving = quantities("moving", self.times, self.states)
            hessian, rates = (
                np.nan_to_num(moving[name], nan=0.0, posinf=0.0, neginf=0.0)
                for name in ("hessian", "rates")
            )
            # M u' is the sum of the loads and constraint forces on each state.
            forces = np.einsum("kij,kj->ki", hessian.reshape(*rates.shape, -1), rates)
            allowed = allowed + self._integrated(_propagated(forces, errors))[:, 0]
        if not (changes > allowed).any():
            return None
        k = int((changes > allowed).argmax())
        details = {"change": changes[k], "explained": allowed[k], "kinetic": kinetic}
        return DriftReport(Outcome.ENERGY_CHANGED, k, details)

    def _residuals_of_rounding(self, quantities: DriftQuantities, slopes: np.ndarray) -> np.ndarray:
        """Return for each row the residual whose energy is a rounding of the kinetic energy."""
        m, n = self.states.shape
        slopes, moving = slopes.reshape(m, -1, n), quantities("moving", self.times, self.states)
        if not moving:
            return np.zeros(slopes.shape[1])
        mobility = np.linalg.pinv(moving["hessian"].reshape(m, n, n), hermitian=True)
        squares = np.einsum("kri,kij,krj->kr", slopes, mobility, slopes)
        share = 2.0 * np.finfo(float).eps * moving["kinetic"].max()
        largest: np.ndarray = np.sqrt(share * np.fmax(squares, 0.0)).max(axis=0)
        return largest


def _propagated(slopes: np.ndarray, errors: np.ndarray) -> np.ndarray:
    """Return bounds on the change of some values by errors of the states, at each state."""
    changes = np.abs(slopes.reshape(len(errors), -1, errors.shape[1])) * errors[:, None]
    bounds: np.ndarray = changes.sum(axis=2)
    return bounds
