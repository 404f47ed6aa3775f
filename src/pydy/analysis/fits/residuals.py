"""Whether the residuals of a fit are independent of each other, as its standard errors assume.

The statistic is the autocorrelation of neighbouring samples, that of Durbin and Watson,

    r = Σ e_k e_{k+1} / Σ e_k²,   d ≈ 2 (1 − r),

over all trials of a quantity. For white noise of n samples r is nearly normal with the standard
deviation 1/√n. Where r is positive, neighbours repeat each other: of AR(1) noise, the variance of
a mean is (1 + r)/(1 − r) times that of independent samples.

References
----------
J. Durbin and G. S. Watson, Testing for serial correlation in least squares regression. I,
Biometrika 37 (1950) 409–428. G. E. P. Box, G. M. Jenkins, G. C. Reinsel and G. M. Ljung, Time
Series Analysis, 5th ed., §2.1.6 (the standard error of r).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy

from pydy._names import few
from pydy.analysis.tuning import FALSE_ALARM_RATE, THINNED_CORRELATION


def autocorrelation(series: Sequence[np.ndarray]) -> tuple[float, float]:
    """Return r of residuals in the order of time, and r in units of its standard deviation.

    Missing samples (NaN) are ignored. Both are zero if all residuals are zero or missing.
    """
    finite = [e[np.isfinite(e)] for e in series]
    power = sum(float(e @ e) for e in finite)
    count = sum(map(len, finite))
    if not power > 0.0 or not np.isfinite(power):
        return 0.0, 0.0
    r = sum(float(e[1:] @ e[:-1]) for e in finite) / power
    return r, r * count**0.5


def is_smooth(series: Sequence[np.ndarray], r: float) -> bool:
    """Return whether residuals are samples of a smooth curve, as no noise with a memory is.

    With r₂ the autocorrelation of samples two apart, (1 − r₂)/(1 − r) is 1 + r of AR(1) noise, less
    than 2, and nearly 4 of a smooth curve.
    """
    finite = [e[np.isfinite(e)] for e in series]
    power = sum(float(e @ e) for e in finite)
    second = sum(float(e[2:] @ e[:-2]) for e in finite) / power
    return 1.0 - second > 3.0 * (1.0 - r)


def text_of_correlation(
    residuals: Sequence[dict[str, np.ndarray]],
    least: dict[str, float],
    noise_is_known: bool,
    unknowns: int,
) -> str:
    """Return a warning about quantities with correlated neighbouring residuals, or ''.

    The residuals are in units of their noise. If `noise_is_known`, the warning applies only if
    correlation and size together exceed that noise. White noise is reported as correlated in the
    fraction `FALSE_ALARM_RATE` of all fits. Residuals with a root mean square below the quantity's
    `least` are errors of the motion, not noise. Residuals that are smooth, or worth no more
    independent samples than there are `unknowns`, or too large for the noise that was given
    whatever its memory, are those of a wrong model or of a local minimum.
    """
    names = [*residuals[0]] if residuals else []
    limit = float(scipy.special.ndtri(1.0 - FALSE_ALARM_RATE / max(len(names), 1)))
    correlated, misfits = [], []
    for name in names:
        series = [table[name] for table in residuals if name in table]
        combined = np.concatenate(series)
        combined = combined[np.isfinite(combined)]
        r, deviations = autocorrelation(series)
        if not deviations > limit:
            continue
        size = float(np.sqrt(np.mean(combined**2)))
        factor = ((1.0 + r) / (1.0 - r)) ** 0.5 if r < 1.0 else np.inf
        factor = factor * size if noise_is_known else factor
        if size > least.get(name, 0.0) and factor > 1.0:
            correlated.append((factor, r, name, len(combined)))
            independent = len(combined) * max(1.0 - r, 0.0) / (1.0 + r)
            if noise_is_known:
                # Chi-squared with as many degrees of freedom, at least one.
                half = max(independent, 1.0) / 2.0
                is_misfit = size**2 > scipy.special.gammainccinv(half, FALSE_ALARM_RATE) / half
            else:
                is_misfit = independent <= unknowns or is_smooth(series, r)
            if is_misfit:
                times_noise = f", and {size:.3g} times the noise" if noise_is_known else ""
                misfits.append(f"{name} are correlated by {r:.2g}{times_noise}")
    if not correlated:
        return ""
    factor, r, _, count = max(correlated)
    if misfits:
        return (
            "The model does not describe the data, or the search ended in a local minimum: "
            f"neighbouring residuals of {few(misfits)}, of {count} samples. Plot them "
            "(`result.plot_residuals()`), and try other starting values, `segments=` or "
            "method='collocation'. Standard errors and confidence intervals mean nothing here, "
            "unless the noise itself has such a memory."
        )
    every_nth = int(min(np.ceil(np.log(THINNED_CORRELATION) / np.log(min(r, 0.999))), count))
    texts = [f"{name} by {r:.2g}" for _, r, name, _ in correlated]
    return (
        f"The residuals are no white noise: neighbouring ones of {few(texts)} are correlated, of "
        f"{count} samples. Standard errors and confidence intervals assume independent samples, "
        f"and may be too small by a factor of about {factor:.2g}. If the noise has a memory, fit "
        f"every {every_nth}th sample alone, or multiply them by the factor; if the model lacks "
        "something, plot the residuals (`result.plot_residuals()`), or give `process_noise` with "
        "method='collocation'."
    )
