"""Least squares with exact derivatives, in units of the parameters' sizes."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import scipy

from pydy._errors import FitInterrupted, note_finished, warn_user
from pydy._names import counted
from pydy.analysis.tuning import FIT_TOLERANCE, LARGEST_RESIDUAL


def estimate(
    evaluate: Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]],
    start: np.ndarray,
    bounds: tuple[np.ndarray, np.ndarray],
    names: Sequence[str],
    most: int,
    warns: bool = True,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, scipy.optimize.OptimizeResult]:
    """Minimise the sum of squares of residuals with at most `most` evaluations.

    `evaluate` returns residuals (m,) and their Jacobian (m, k); NaN if the motion cannot be
    computed. Return the estimates, their residuals and Jacobian, and SciPy's result. Ctrl-C raises
    FitInterrupted with the best estimates so far.

    SciPy's tolerances of the gradient and of the step depend on units: a search for a stiffness
    of atoms or of planets in kg/s² would end at once. Parameters are therefore searched for in
    units of their sizes at the start. If these sizes change by more than half of FIT_TOLERANCE's
    digits, the search is repeated.
    """
    cache: dict[bytes, tuple[np.ndarray, np.ndarray]] = {}
    least, best = np.inf, start

    def at(z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        nonlocal least, best
        key = z.tobytes()
        if key not in cache:
            for old in cache.keys() - {best.tobytes()}:
                del cache[old]
            with np.errstate(**outer):  # a user's function keeps its warnings
                values, slopes = evaluate(z)
            far = np.abs(values).max(initial=0.0), np.abs(slopes).max(initial=0.0)
            if max(far) > LARGEST_RESIDUAL:
                if least == np.inf:
                    raise ValueError(
                        "The motion that the search begins with is too far from the samples, or "
                        f"changes too fast with the parameters: {far[0]:.3g} and {far[1]:.3g}, in "
                        "units of `noise`, of which floats hold no powers. Begin with other "
                        "constants or initial conditions, or set `segments`."
                    )
                values = np.full_like(values, np.nan)  # no step of the search
            cache[key] = values, slopes
            cost = float(values @ values)
            if cost < least:
                least, best = cost, z.copy()
        return cache[key]

    z, evaluations_left, repeats, outer = start, most, True, np.geterr()
    try:
        # A step may lead to residuals with infinite squares; SciPy then rejects it.
        with np.errstate(all="ignore"):
            size, units = _sizes(*at(z), z)
            while repeats:
                result = _search(at, z, bounds, size, units, evaluations_left)
                z, evaluations_left, before = (
                    result.x * units,
                    evaluations_left - result.nfev,
                    np.append(units, size),
                )
                size, units = _sizes(*at(z), z)
                change = np.abs(np.log2(before / np.append(units, size))).max()
                repeats = (
                    result.status in (1, 3)
                    and evaluations_left > 0
                    and change > -0.5 * np.log2(FIT_TOLERANCE)
                )
            residuals, jacobian = at(z)
    except (KeyboardInterrupt, MemoryError) as stop:
        values = dict(zip(names, best.tolist(), strict=True))
        if isinstance(stop, MemoryError):
            note_finished(stop, "The best estimates so far are", values=values)
            raise
        raise FitInterrupted(
            "The fit was interrupted. Its best estimates so far are in `values`.", values
        ) from stop
    if warns and result.status == 0:
        warn_user(
            f"The fit did not converge in {counted(most, 'evaluation')}; the estimates are "
            "the last ones. Start closer to the solution, set `bounds`, or use `segments` for long "
            "or unstable motions."
        )
    return z, residuals, jacobian, result


def _sizes(
    residuals: np.ndarray, jacobian: np.ndarray, z: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the size of the residuals, and the parameter changes that change them as much."""
    size = _power_of_two(np.linalg.norm(residuals), np.ones(()))
    # Parameters may have no effect, and residuals may not be finite.
    return size, _power_of_two(size / np.linalg.norm(jacobian, axis=0), np.abs(z))


def _search(
    at: Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]],
    z: np.ndarray,
    bounds: tuple[np.ndarray, np.ndarray],
    size: np.ndarray,
    units: np.ndarray,
    most: int,
) -> scipy.optimize.OptimizeResult:
    """Call SciPy's search with residuals and parameters in units of their sizes."""
    return scipy.optimize.least_squares(
        lambda w: at(w * units)[0] / size, z / units, lambda w: at(w * units)[1] * (units / size),
        (bounds[0] / units, bounds[1] / units), x_scale="jac",
        xtol=FIT_TOLERANCE, ftol=FIT_TOLERANCE, gtol=FIT_TOLERANCE, max_nfev=most,
    )  # fmt: skip


def _power_of_two(sizes: np.ndarray | np.floating, otherwise: np.ndarray) -> np.ndarray:
    """Return powers of two near some sizes; invalid sizes are replaced by `otherwise`, or 1."""
    for substitute in (otherwise, np.ones(())):
        sizes = np.where(np.isfinite(sizes) & (sizes > 0.0), sizes, substitute)
    powers: np.ndarray = np.ldexp(1.0, np.frexp(sizes)[1])
    return powers
