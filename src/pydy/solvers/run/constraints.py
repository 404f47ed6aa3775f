"""What projection onto the constraints needs of a system, as a Kernel."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from pydy._kernel import Kernel, KernelCall
from pydy.solvers.tuning import (
    DEPENDENT,
    MISSING,
    NEARLY_SINGULAR,
    NUDGE,
    ROUNDING,
    ROUNDINGS,
)

__all__ = ["CompiledConstraints", "passage", "satisfied"]


def satisfied(residuals: np.ndarray, bounds: np.ndarray) -> bool:
    """Return whether residuals are nothing but rounding.

    Parameters
    ----------
    residuals : ndarray, shape (h,)
    bounds : ndarray, shape (h,)
        On their rounding errors, in units of 2⁻⁵²; see `pydy._graph.rounding`.
    """
    return bool((np.abs(residuals) <= ROUNDINGS * ROUNDING * bounds).all())


def passage(solver: str, t: float, rows: str, lost: float) -> str:
    """Return a warning of a singular configuration that a motion passed.

    Parameters
    ----------
    solver : str
    t : float
    rows : str
        The constraints of which a combination vanishes there.
    lost : float
        The share of the kinetic energy that may be lost, 1 in the configuration itself.
    """
    if lost < 1.0:
        return (
            f"`{solver}` passed close to a singular configuration of the constraints at t = {t!r}, "
            f"where these rows nearly depend on each other: {rows}. Their forces could not be "
            f"determined there, and up to {lost:.1g} of the kinetic energy may be lost. Compare "
            "the energy before and after; other constraints may have no such configuration."
        )
    return (
        f"`{solver}` passed a singular configuration of the constraints at t = {t!r}, where "
        f"a combination of these rows vanishes: {rows}. From there the motion may have gone on "
        "along another branch, with another energy. Compare the energy before and after, and "
        "runs at other tolerances; other constraints may have no such configuration."
    )


@dataclass(frozen=True, eq=False)
class CompiledConstraints:
    """What the projection needs to know of a system.

    Attributes
    ----------
    kernel : Kernel
        Outputs, one after the other: holonomic residuals (h), velocity residuals (v), ∂h/∂q
        (h, q), N of q' = N u (q, u), ∂v/∂u (v, u), the unreduced mass matrix (u, u) where
        `weighted`, and bounds on the rounding errors of the holonomic residuals (h).
    holonomic, velocity, coordinates, speeds : int
    dependent_speeds : int
        How many speeds, the last ones, the equations of motion take from the velocity constraints.
    weighted : bool
        Whether corrections are measured by the mass matrix; by their square sum otherwise.
    names : sequence of str
        What to call the holonomic residuals, then the velocity residuals.
    """

    kernel: Kernel
    holonomic: int
    velocity: int
    coordinates: int
    speeds: int
    dependent_speeds: int
    weighted: bool
    names: Sequence[str]

    def dependent(self, values: np.ndarray) -> list[str]:
        """Return the names of redundant constraints: combinations of those before them.

        Parameters
        ----------
        values : ndarray
            What the kernel gives at some state.
        """
        part = self.kernel.program.by_block(values)
        rows = [
            *(_dependent(part["gradient"].reshape(self.holonomic, self.coordinates))),
            *(_dependent(part["velocity_gradient"].reshape(self.velocity, self.speeds))),
        ]
        return [self.names[k] for k, found in enumerate(rows) if found]

    def combination(
        self, values: np.ndarray, longest: np.ndarray, rank: int
    ) -> tuple[float, list[str]]:
        """Return how near the velocity constraints are to losing rank, and which of them do.

        Parameters
        ----------
        values : ndarray
            What the kernel gives at some state.
        longest : ndarray, shape (v,)
            The lengths of their rows elsewhere, in the norm of corrections.
        rank : int
            Elsewhere.

        Returns
        -------
        nearness : float
            The least singular value of the rows in units of `longest`, but for those that are zero
            elsewhere too; 1 where the rows are not finite.
        names : list of str
            Of the constraints whose combination then vanishes.
        """
        part = self.kernel.program.by_block(values)
        rows = part["velocity_gradient"].reshape(self.velocity, self.speeds)
        if self.weighted:
            hessian = part["kinetic_hessian"].reshape(self.speeds, self.speeds)
            with suppress(np.linalg.LinAlgError):
                rows = np.linalg.solve(np.linalg.cholesky(hessian), rows.T).T
        if not np.isfinite(rows).all():
            return 1.0, []
        left, sizes, _ = np.linalg.svd(rows / np.where(longest > 0.0, longest, 1.0)[:, None])
        parts = np.abs(left[:, rank - 1])
        names = self.names[self.holonomic :]
        return float(sizes[rank - 1]), [
            name for name, size in zip(names, parts, strict=True) if size > 0.1 * parts.max()
        ]

    def lost(self, call: KernelCall, x: np.ndarray, t: float) -> float:
        """Return how much of the kinetic energy forces may change that cannot be determined.

        Where the constraints are nearly dependent, their multipliers are regularised, and some of
        the acceleration is missing. What it adds up to, from the nearest state both ways to where
        nothing is missing, is a velocity that projection takes away, with its energy.

        Parameters
        ----------
        call : KernelCall
            Gives the derivative of the state.
        x : ndarray, shape (n,)
            Where the constraints were nearest to losing rank.
        t : float

        Returns
        -------
        float
            The share of the kinetic energy, at most 1.
        """
        rates = call.evaluate(call.kernel, x, t)
        pace = float(np.abs(rates / (1.0 + np.abs(x))).max(initial=0.0))
        if not np.isfinite(pace) or pace == 0.0:
            return 0.0
        change = np.zeros(self.speeds)
        for way in (1.0, -1.0):
            before, after = 0.0, NUDGE / pace
            while after * pace < 1.0:
                missing, share = self._missing(call, x + way * after * rates, t + way * after, pace)
                if not share > MISSING:
                    break
                change += missing * (after - before)
                before, after = after, 2.0 * after
        weights = self._weights(call.evaluate(self.kernel, x, t))
        u = x[self.coordinates : self.coordinates + self.speeds]
        lost, all_of_it = (float(v @ weights @ v) for v in (change, u))
        return min(1.0, lost / all_of_it) if lost > 0.0 < all_of_it else 0.0

    def _weights(self, values: np.ndarray) -> np.ndarray:
        if not self.weighted:
            return np.eye(self.speeds)
        hessian = self.kernel.program.by_block(values)["kinetic_hessian"]
        return hessian.reshape(self.speeds, self.speeds)

    def _missing(
        self, call: KernelCall, x: np.ndarray, t: float, pace: float
    ) -> tuple[np.ndarray, float]:
        """Return what accelerations lack to satisfy the constraints, and which share of them."""
        rates, split = call.evaluate(call.kernel, x, t), self.kernel.program.by_block
        step = NUDGE / pace
        ahead, behind = (
            split(call.evaluate(self.kernel, x + h * rates, t + h))["velocity"]
            for h in (step, -step)
        )
        left = (behind - ahead) / (2.0 * step)
        rows = split(call.evaluate(self.kernel, x, t))["velocity_gradient"]
        rows = rows.reshape(self.velocity, self.speeds)
        if not (np.isfinite(rows).all() and np.isfinite(left).all()):
            return np.zeros(self.speeds), 0.0
        lengths = np.linalg.norm(rows, axis=1)
        lengths[lengths == 0.0] = 1.0
        missing = np.linalg.lstsq(rows / lengths[:, None], left / lengths, rcond=NEARLY_SINGULAR)[0]
        found = rates[self.coordinates : self.coordinates + self.speeds]
        size, whole = float(np.linalg.norm(missing)), float(np.linalg.norm(found))
        return missing, size / (size + whole) if size > 0.0 else 0.0

    def determinacy(self, values: np.ndarray) -> float:
        """Return how near the velocity constraints are to not giving the dependent speeds.

        Parameters
        ----------
        values : ndarray
            What the kernel gives at some state.

        Returns
        -------
        float
            The least singular value of their rows' part that belongs to the dependent speeds, in
            units of the rows' lengths; 1 where there are no such speeds.
        """
        part = self.kernel.program.by_block(values)
        rows = part["velocity_gradient"].reshape(self.velocity, self.speeds)
        lengths = np.linalg.norm(rows, axis=1)
        if not self.dependent_speeds or not np.isfinite(rows).all() or not lengths.all():
            return 1.0
        given = (rows / lengths[:, None])[:, -self.dependent_speeds :]
        return float(np.linalg.svd(given, compute_uv=False)[-1])


def _dependent(rows: np.ndarray) -> list[bool]:
    """Tell which rows are combinations of earlier ones, whatever their lengths."""
    basis = np.empty((0, rows.shape[1]))
    found = []
    for row in rows:
        length = np.linalg.norm(row)
        rest = row / length if length else row
        for _ in range(2):  # once more for what rounding left
            rest = rest - basis.T @ (basis @ rest)
        size = np.linalg.norm(rest)
        found.append(bool(size < DEPENDENT))
        if not found[-1]:
            basis = np.vstack([basis, rest / size])
    return found
