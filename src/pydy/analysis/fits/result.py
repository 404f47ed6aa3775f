"""The result of a fit: estimates, their covariance, and residuals.

The estimates minimise the sum of squares of the residuals, each divided by the standard deviation
of its noise. Their covariance follows from the derivatives of the residuals at the minimum.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy

from pydy._axes import legend_beside, rows_of_axes, typeset
from pydy._checks import number
from pydy._errors import warn_user
from pydy._names import few, name_of, place_of, some, table_of
from pydy._optional import require
from pydy._problem import FIT, warn_of_contradictions
from pydy._rank import HALF, or_one
from pydy.analysis.directions import direction_text
from pydy.analysis.fits.residuals import autocorrelation, text_of_correlation
from pydy.analysis.tuning import NAMED_IN_FIT, NOISE_TOLERANCE_FACTOR

if TYPE_CHECKING:
    import pandas

    from pydy._sympy_types import AnySymbol, SymbolOrName
    from pydy.analysis.fits.problem import FitProblem
    from pydy.analysis.fits.samples import TrialSamples


@dataclass(frozen=True, eq=False)
class FitResult:
    """Estimates of parameters, and how well the data determine them.

    Attributes
    ----------
    names : tuple of str
        Names of the parameters; initial conditions of a trial are named like ``'q1 of trial 0'``.
    estimates : ndarray, shape (k,)
    covariance : ndarray, shape (k, k)
        Of the estimates. Directions that the data do not determine have an infinite variance.
    constants, initial_conditions : dict
        The parameters that all trials share; they can be assigned to the System's attributes.
    undetermined : tuple of str
        Combinations of parameters, as relative changes, that the data do not determine.
    at_bounds : tuple of str
        Parameters that lie at a bound.
    residuals : list of dict
        For each trial: measurement minus model, by name of the measured quantity.
    times : list of ndarray
        The sampling times of each trial.
    noise : float
        The standard deviation of the residuals divided by the given standard deviation of the
        noise: near 1 if model and noise are right. If no noise was given, the estimated standard
        deviation of the noise.
    degrees : int
        Degrees of freedom: samples plus priors minus parameters.
    evaluations : int
        Number of simulations of all trials.
    success : bool
        Whether the search converged.
    message : str
        Why it ended.
    measured : list of dict
        For each trial: the samples, by name of the measured quantity; NaN where one is missing.
    labels : tuple of str
        The names of the trials.
    warnings : tuple of str
        What the fit warned of.
    noise_given : bool
        Whether the trials gave the standard deviation of the noise; `noise` is a ratio then.
    measured_states : tuple of str
        Those of the measured quantities that are states of the System.
    """

    names: tuple[str, ...]
    estimates: np.ndarray
    covariance: np.ndarray
    constants: dict[AnySymbol, float]
    initial_conditions: dict[AnySymbol, float]
    undetermined: tuple[str, ...]
    at_bounds: tuple[str, ...]
    residuals: list[dict[str, np.ndarray]]
    times: list[np.ndarray]
    noise: float
    degrees: int
    evaluations: int
    success: bool
    message: str
    measured: list[dict[str, np.ndarray]] = field(default_factory=list)
    labels: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    noise_given: bool = False
    measured_states: tuple[str, ...] = ()

    def __getitem__(self, parameter: SymbolOrName) -> float:
        """Return an estimate, by symbol or name."""
        return float(self.estimates[place_of(parameter, self.names, "parameters")])

    @property
    def standard_errors(self) -> np.ndarray:
        """Standard deviations of the estimates, shape (k,)."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def correlation(self) -> np.ndarray:
        """Correlation matrix of the estimates, shape (k, k)."""
        sizes = self.standard_errors
        with np.errstate(all="ignore"):
            result: np.ndarray = self.covariance / np.outer(sizes, sizes)
        return result

    def confidence_intervals(self, level: float = 0.95) -> np.ndarray:
        """Return the lowest and highest values that are compatible with the data, shape (k, 2).

        They follow from the model linearised at the estimates, with Student's distribution.
        """
        share = number(level, "`level`", finite=True)
        if not 0.0 < share < 1.0:
            raise ValueError(f"`level` must lie between 0 and 1, got {share!r}.")
        reach = (
            scipy.special.stdtrit(max(self.degrees, 1), 0.5 + 0.5 * share) * self.standard_errors
        )
        return np.stack([self.estimates - reach, self.estimates + reach], axis=1)

    @property
    def fitted(self) -> list[dict[str, np.ndarray]]:
        """The model at the sampling times of each trial, by name of the measured quantity."""
        return [
            {name: samples - missed[name] for name, samples in table.items()}
            for table, missed in zip(self.measured, self.residuals, strict=True)
        ]

    def to_dataframe(self, level: float = 0.95) -> pandas.DataFrame:
        """Return a `pandas.DataFrame` with a row for each parameter.

        Parameters
        ----------
        level : float, optional
            Of the confidence intervals.

        Returns
        -------
        pandas.DataFrame
            Indexed by ``parameter``, with the columns ``estimate``, ``standard_error``, and
            ``low`` and ``high`` of the confidence interval.

        Raises
        ------
        ImportError
            pandas is not installed.
        """
        pandas = require("pandas", "labels", "FitResult.to_dataframe")
        low, high = self.confidence_intervals(level).T
        columns = {"estimate": self.estimates, "standard_error": self.standard_errors,
                   "low": low, "high": high}  # fmt: skip
        return pandas.DataFrame(columns, index=pandas.Index(self.names, name="parameter"))

    def summary(self, level: float = 0.95) -> str:
        """Return a table of estimates and residuals as text.

        Parameters
        ----------
        level : float, optional
            Of the confidence intervals.

        Returns
        -------
        str
            Each parameter with its standard error and confidence interval; each measured quantity
            with the number of samples, the root mean square of its residuals and the correlation
            of neighbouring ones, which is near zero for white noise; and what was warned of.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.analysis import Trial
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> times = np.linspace(0.0, 10.0, num=101)
        >>> swing = np.exp(-0.1 * times) * np.cos(np.sqrt(3.99) * times)
        >>> noise = np.random.default_rng(0).normal(0.0, 0.01, 101)
        >>> trial = Trial(times, {'x0': swing + noise}, {'x0': 1.0, 'v0': -0.1})
        >>> print(system.fit(['k0', 'c0'], trial).summary())  # doctest: +ELLIPSIS
        Fit of 2 parameters to 101 samples of 1 trial: converged after ... evaluations
        <BLANKLINE>
        parameter  estimate  standard error  95 % interval
        k0         ...
        c0         ...
        <BLANKLINE>
        quantity  samples  rms of residuals  correlation of neighbours
        x0        101      ...
        <BLANKLINE>
        standard deviation of the noise: 0.009..., 99 degrees of freedom
        """
        intervals, share = self.confidence_intervals(level), number(level, "`level`")
        rows = [
            (name, f"{value:.8g}", f"{error:.2g}", f"[{low:.6g}, {high:.6g}]")
            for name, value, error, (low, high) in zip(
                self.names, self.estimates, self.standard_errors, intervals, strict=True
            )
        ]
        heads = ("parameter", "estimate", "standard error", f"{100 * share:g} % interval")
        quantities = list(dict.fromkeys(name for table in self.residuals for name in table))
        missed, count = [], 0
        for name in quantities:
            series = [table[name] for table in self.residuals if name in table]
            combined = np.concatenate(series)
            combined = combined[np.isfinite(combined)]
            count += len(combined)
            size = float(np.sqrt(np.mean(combined**2))) if len(combined) else np.nan
            r = autocorrelation(series)[0]
            missed.append((name, str(len(combined)), f"{size:.4g}", f"{r:.2g}"))
        quantity_heads = ("quantity", "samples", "rms of residuals", "correlation of neighbours")
        ended = "converged after" if self.success else "did not converge in"
        trials = f"{len(self.times)} trial{'s' if len(self.times) != 1 else ''}"
        warnings = [f"warning: {text}" for text in self.warnings]
        label = "residuals divided by the given noise" if self.noise_given else "the noise"
        return "\n".join([
            f"Fit of {len(self.names)} parameter{'s' if len(self.names) != 1 else ''} to {count} "
            f"samples of {trials}: {ended} {self.evaluations} evaluations",
            "", *table_of(heads, rows), "", *table_of(quantity_heads, missed), "",
            f"standard deviation of {label}: {self.noise:.4g}, {self.degrees} degrees of freedom",
            *warnings,
        ])  # fmt: skip

    def plot_residuals(self, axes: Any = None) -> Any:
        """Plot the residuals of each trial over time; return the Axes."""
        axes, rows = rows_of_axes(axes, len(self.times), "trial", sharex=False)
        trials = zip(rows, self.labels, self.times, self.residuals, strict=True)
        for ax, label, times, columns in trials:
            ax.axhline(0.0, color="0.7", linewidth=0.8)
            for name, column in columns.items():
                ax.plot(times, column, ".", markersize=3, label=typeset(name, ""))
            ax.set_title(label)
            ax.set_xlabel("time")
            several = ", each in its unit" if len(columns) > 1 else ""
            ax.set_ylabel(f"measured minus model{several}")
            legend_beside(ax)
        return axes

    def __str__(self) -> str:
        rows = [
            f"{name} = {value:.8g} +- {error:.2g}"
            for name, value, error in zip(
                self.names, self.estimates, self.standard_errors, strict=True
            )
        ]
        suffix = f"; undetermined: {few(self.undetermined)}" if self.undetermined else ""
        return f"Fit of {some(rows)}; residuals {self.noise:.4g}{suffix}"

    __repr__ = __str__


def covariance_of(
    jacobian: np.ndarray, values: np.ndarray, sizes: np.ndarray, names: Sequence[str], least: float
) -> tuple[np.ndarray, tuple[str, ...]]:
    """Return (JᵀJ)⁻¹, and combinations of parameters that J does not determine.

    The rank is determined in units of the parameters' `sizes`, so that it does not depend on the
    user's units. Combinations are shown as changes relative to the `values`, unless these are
    nearly zero. Combinations that change the samples by no more than `least` are undetermined.
    """
    sizes = or_one(sizes)
    relative = np.where(np.abs(values) > NAMED_IN_FIT * sizes, np.abs(values), sizes)
    missing = max(len(sizes) - len(jacobian), 0)  # rows of zeros: directions without a sample
    rows = np.concatenate([jacobian * sizes, np.zeros((missing, len(sizes)))])
    _, singular, right = np.linalg.svd(rows, full_matrices=False)
    largest = singular.max(initial=0.0)
    weak = singular <= max(HALF * largest, least)
    inverse = np.where(weak, 0.0, 1.0 / np.where(weak, 1.0, singular))
    covariance = (right.T * inverse**2) @ right
    texts = []
    for direction in right[weak]:
        texts.append(direction_text(direction * sizes / relative, names, NAMED_IN_FIT))
        touched = np.abs(direction) > NAMED_IN_FIT * np.abs(direction).max()
        covariance[touched, touched] = np.inf
    return covariance * np.outer(sizes, sizes), tuple(texts)


def parameters_at_bounds(
    values: np.ndarray, bounds: tuple[np.ndarray, np.ndarray], names: Sequence[str]
) -> tuple[str, ...]:
    """Return the parameters that lie at a bound."""
    low, high = bounds
    size = np.maximum(np.abs(values), np.finfo(float).tiny)
    near = (values - low <= HALF * size) | (high - values <= HALF * size)
    return tuple(name for name, flag in zip(names, near, strict=True) if flag)


@dataclass(frozen=True, eq=False)
class Minimum:
    """The least-squares minimum at the end of a search."""

    z: np.ndarray  # the parameters, and further unknowns of the search
    values: np.ndarray  # (r,), residuals of the samples and priors, divided by their noise
    jacobian: np.ndarray  # (r, k), by the parameters
    residuals: list[dict[str, np.ndarray]]  # of each trial: sample minus model
    sizes: np.ndarray  # (n,), sizes of the states
    tolerance: float  # of the motions
    success: bool
    message: str
    evaluations: int
    equations: int = 1  # number of equations that were solved for a motion
    white: bool = True  # whether residuals should be white noise: there is no process noise


def result_of(problem: FitProblem, minimum: Minimum) -> FitResult:
    """Return the result of a fit; warn of undetermined parameters and correlated residuals."""
    names, k = tuple(problem.names), problem.count
    z, values, residuals = minimum.z, minimum.values, minimum.residuals
    degrees = problem.samples + len(problem.priors) - k
    noise = float(np.sqrt(values @ values / degrees)) if degrees > 0 else np.nan
    sizes = np.maximum(np.abs(z[:k]), problem.sizes(minimum.sizes))
    # The error of a motion is at least the tolerance to which each equation is solved.
    samples = [np.nan_to_num(d.values / d.noise).ravel() for d in problem.trials]
    least = FIT * minimum.equations**0.5 * float(np.linalg.norm(np.concatenate(samples)))
    covariance, undetermined = covariance_of(minimum.jacobian, z[:k], sizes, names, least)
    if problem.noise_is_estimated:
        covariance = covariance * noise**2
    at_bounds = parameters_at_bounds(z[:k], (problem.limits[0][:k], problem.limits[1][:k]), names)
    success = minimum.success
    messages = [] if success else [f"The fit did not converge: {minimum.message}"]
    messages += warn_of_estimates(undetermined, at_bounds)
    if minimum.white and success and not at_bounds and degrees > 0:
        scaled, errors = in_units_of_noise(problem.trials, residuals, max(minimum.tolerance, FIT))
        if text := text_of_correlation(scaled, errors, not problem.noise_is_estimated, k):
            messages.append(text)
            warn_user(text)
    shared = list(zip(problem.shared, z.tolist(), strict=False))
    for group in ("constants", "states", "specifieds"):
        estimates = {s: v for (kind, s), v in shared if kind == group}
        warn_of_contradictions(problem.base, group, estimates, "The estimate of ")
    names_of_states = {name_of(s) for s in problem.base.definition.states}
    return FitResult(
        names=names,
        estimates=z[:k].copy(),
        covariance=covariance,
        constants={s: v for (kind, s), v in shared if kind == "constants"},
        initial_conditions={s: v for (kind, s), v in shared if kind == "states"},
        undetermined=undetermined,
        at_bounds=at_bounds,
        residuals=residuals,
        times=[d.times for d in problem.trials],
        noise=noise,
        degrees=degrees,
        evaluations=minimum.evaluations,
        success=success,
        message=minimum.message,
        measured=[dict(zip(d.names, d.values.T.copy(), strict=True)) for d in problem.trials],
        labels=tuple(d.label for d in problem.trials),
        warnings=tuple(messages),
        noise_given=not problem.noise_is_estimated,
        measured_states=tuple(names_of_states & {n for d in problem.trials for n in d.names}),
    )


def in_units_of_noise(
    trials: Sequence[TrialSamples], residuals: Sequence[dict[str, np.ndarray]], tolerance: float
) -> tuple[list[dict[str, np.ndarray]], dict[str, float]]:
    """Return residuals divided by their noise, and bounds on the errors of the motions.

    The motions are computed to the relative `tolerance`.
    """
    least: dict[str, float] = {}
    scaled: list[dict[str, np.ndarray]] = []
    for d, table in zip(trials, residuals, strict=True):
        noise = dict(zip(d.names, d.noise.T, strict=True))
        scaled.append({name: column / noise[name] for name, column in table.items()})
        for name, column in zip(d.names, (d.values / d.noise).T, strict=True):
            size = NOISE_TOLERANCE_FACTOR * tolerance * np.fmax.reduce(np.abs(column), initial=0.0)
            least[name] = max(least.get(name, 0.0), float(size))
    return scaled, least


def warn_of_estimates(undetermined: Sequence[str], at_bounds: Sequence[str]) -> list[str]:
    """Warn of estimates that are undetermined or at a bound; return the messages."""
    messages = []
    if undetermined:
        messages.append(
            f"The data do not determine these relative changes of parameters: "
            f"{few(undetermined)}. Fix one of them, give `priors`, or measure more."
        )
    if at_bounds:
        messages.append(
            f"The fit stopped at a bound of {some(at_bounds)}: the estimates there, and all "
            "standard errors, are not those of a free fit."
        )
    for message in messages:
        warn_user(message)
    return messages
