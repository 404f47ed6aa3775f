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
from pydy.analysis.tuning import CHANCE, THINNED


def autocorrelation(series: Sequence[np.ndarray]) -> tuple[float, float]:
    """Return r of residuals in the order of time, and how many standard deviations that is.

    Missing samples, NaN, are left out. Both are zero where there is nothing to compare.
    """
    kept = [e[np.isfinite(e)] for e in series]
    whole = sum(float(e @ e) for e in kept)
    count = sum(map(len, kept))
    if not whole > 0.0 or not np.isfinite(whole):
        return 0.0, 0.0
    r = sum(float(e[1:] @ e[:-1]) for e in kept) / whole
    return r, r * count**0.5


def text_of_correlation(
    residuals: Sequence[dict[str, np.ndarray]], least: dict[str, float], known: bool
) -> str:
    """Return what to say of quantities whose neighbouring residuals are alike, or ''.

    They are in units of their noise; where that is `known`, it counts unless the residuals are
    larger or alike. White noise is taken for correlated in `CHANCE` of all fits. Residuals whose
    root mean square is below the `least` of a quantity are errors of the motion, not noise.
    """
    names = [*residuals[0]] if residuals else []
    limit = float(scipy.special.ndtri(1.0 - CHANCE / max(len(names), 1)))
    found = []
    for name in names:
        series = [table[name] for table in residuals if name in table]
        every = np.concatenate(series)
        every = every[np.isfinite(every)]
        r, deviations = autocorrelation(series)
        if not deviations > limit:
            continue
        size = float(np.sqrt(np.mean(every**2)))
        factor = ((1.0 + r) / (1.0 - r)) ** 0.5 if r < 1.0 else np.inf
        factor = factor * size if known else factor
        if size > least.get(name, 0.0) and factor > 1.0:
            found.append((factor, r, name, len(every)))
    if not found:
        return ""
    factor, r, _, count = max(found)
    every_nth = int(min(np.ceil(np.log(THINNED) / np.log(min(r, 0.999))), count))
    texts = [f"{name} by {r:.2g}" for _, r, name, _ in found]
    return (
        f"The residuals are no white noise: neighbouring ones of {few(texts)} are correlated, of "
        f"{count} samples. Standard errors and confidence intervals assume independent samples, "
        f"and may be too small by a factor of about {factor:.2g}. If the noise has a memory, fit "
        f"every {every_nth}th sample alone, or multiply them by the factor; if the model lacks "
        "something, plot the residuals (`result.plot_residuals()`), or give `process_noise` with "
        "method='collocation'."
    )
