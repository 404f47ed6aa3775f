"""Parameters of tires from measured forces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._checks import check_mapping, listed, real_array, refuse_twice, shown
from pydy._errors import warn_user
from pydy._names import nearest, some
from pydy.vehicles.algebra import is_symbolic
from pydy.vehicles.forces import Tire, TireForces, unknown_parameter

_INPUTS = ("Fz", "kappa", "alpha", "gamma", "speed", "pressure")
_FORCES = TireForces._fields


@dataclass(frozen=True, eq=False)
class TireFit:
    """A tire that was fitted to measurements.

    Attributes
    ----------
    tire : tire
        The tire with the estimates, of the class that was fitted.
    estimates : dict of str to float
        The free parameters by name.
    standard_errors : dict of str to float
        Their standard deviations, if all residuals are noise; infinite for what the measurements
        do not determine.
    residuals : dict of str to ndarray
        Measurement minus model, for each measured force and moment.
    errors : dict of str to float
        Root mean squares of the residuals, relative to that of the measured values.
    evaluations : int
        How often the forces were evaluated.
    success : bool
        Whether the search converged.
    message : str
        Why it ended.
    """

    tire: Any
    estimates: dict[str, float]
    standard_errors: dict[str, float]
    residuals: dict[str, np.ndarray]
    errors: dict[str, float]
    evaluations: int
    success: bool
    message: str

    def __repr__(self) -> str:
        errors = ", ".join(f"{name} {error:.1%}" for name, error in self.errors.items())
        return f"<TireFit of {some(list(self.estimates))}: remaining errors {errors}>"


def fit_tire(
    measurements: Mapping[str, Any],
    tire: Tire,
    free: Sequence[str],
    *,
    bounds: Mapping[str, Sequence[float]] | None = None,
) -> TireFit:
    """Fit parameters of a tire to measured forces and moments.

    The sum of squares of the residuals is minimised by SciPy's `least_squares`, from the tire's own
    parameters on. The residuals of each force are divided by the root mean square of its measured
    values, so that forces and moments count alike.

    Parameters
    ----------
    measurements : mapping of str to array
        The inputs ``'Fz'``, ``'kappa'``, ``'alpha'`` and, if needed, ``'gamma'``, ``'speed'`` and
        ``'pressure'``, and at least one of ``'Fx'``, ``'Fy'``, ``'Mx'``, ``'My'`` and ``'Mz'``:
        arrays of one length, or numbers for what was constant. Units and signs are those of
        `MagicFormula.forces`. NaN stands for forces that were not measured at a sample.
    tire : tire
        The parameters that are not free, and where the search begins.
    free : sequence of str
        Names of the parameters to estimate, of ``tire.parameters``.
    bounds : mapping of str to pair of float, optional
        Lowest and highest value of some parameters; None or infinity where there is no limit.

    Returns
    -------
    TireFit

    Warns
    -----
    PyDyUserWarning
        The search did not converge, or the measurements do not determine a parameter.

    Examples
    --------
    >>> import numpy as np
    >>> from pydy.vehicles import BrushTire, fit_tire
    >>> alpha = np.linspace(-0.2, 0.2, 21)
    >>> true = BrushTire(4000, stiffness=70e3, friction=0.9)
    >>> measurements = {'Fz': 4000, 'kappa': 0, 'alpha': alpha,
    ...                 'Fy': true.forces(4000, 0, alpha).Fy}
    >>> guess = BrushTire(4000, stiffness=40e3, friction=1.2)
    >>> fit = fit_tire(measurements, guess, ['stiffness', 'friction'])
    >>> round(fit.estimates['stiffness']), round(fit.tire.friction, 6)
    (70000, 0.9)
    """
    for method in ("forces", "replace", "parameters"):
        if not hasattr(tire, method) or isinstance(tire, type):
            raise TypeError(f"`tire` must be a tire, such as MagicFormula, got {shown(tire)}.")
    names = _free_parameters(free, tire)
    inputs, measured = _read(measurements)
    lower, upper = _read_bounds(bounds, names)
    start = np.array([float(tire.parameters[name]) for name in names])
    if not ((lower <= start) & (start <= upper)).all():
        k = int(((start < lower) | (start > upper)).argmax())
        raise ValueError(
            f"`bounds` of {names[k]!r} must contain the tire's own value {start[k]:g}, got "
            f"{lower[k]:g} and {upper[k]:g}."
        )
    sizes = {name: _root_mean_square(values) or 1.0 for name, values in measured.items()}

    def residuals_of(values: np.ndarray) -> dict[str, np.ndarray]:
        forces = tire.replace(**dict(zip(names, map(float, values), strict=True))).forces(**inputs)
        return {name: data - getattr(forces, name) for name, data in measured.items()}

    def scaled(values: np.ndarray) -> np.ndarray:
        columns = [r[np.isfinite(measured[n])] / sizes[n] for n, r in residuals_of(values).items()]
        return np.concatenate(columns)

    from scipy.optimize import least_squares

    found = least_squares(scaled, start, bounds=(lower, upper), x_scale="jac", jac="3-point")
    errors = _standard_errors(found, len(names))
    undetermined = [name for name, error in zip(names, errors, strict=True) if np.isinf(error)]
    if undetermined:
        warn_user(
            f"The measurements do not determine {some(undetermined)}. Fit fewer parameters, or add "
            "measurements that these have an effect on."
        )
    if not found.success:
        warn_user(f"The fit did not converge: {found.message}")
    remaining = residuals_of(found.x)
    estimates = dict(zip(names, map(float, found.x), strict=True))
    return TireFit(
        tire=tire.replace(**estimates),
        estimates=estimates,
        standard_errors=dict(zip(names, map(float, errors), strict=True)),
        residuals=remaining,
        errors={name: _root_mean_square(r) / sizes[name] for name, r in remaining.items()},
        evaluations=int(found.nfev),
        success=bool(found.success),
        message=str(found.message),
    )


def _free_parameters(free: Sequence[str], tire: Tire) -> list[str]:
    names = listed("free", [free] if isinstance(free, str) else free, "names of parameters")
    if not names:
        raise ValueError("`free` is empty: there is nothing to fit.")
    for name in names:
        if not isinstance(name, str):
            raise TypeError(f"`free` must hold names of parameters, got {shown(name)}.")
        if name not in tire.parameters:
            raise ValueError(f"`free`: {unknown_parameter(name, tire.parameters)}")
        if is_symbolic(tire.parameters[name]):
            raise ValueError(
                f"`free` has {name!r}, which is the expression {tire.parameters[name]} in the "
                "tire. Give it a number to begin with."
            )
    refuse_twice(names, "free")
    return [str(name) for name in names]


def _read(measurements: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """Return the inputs and the measured forces, as arrays of one length."""
    given = check_mapping("measurements", measurements)
    known = (*_INPUTS, *_FORCES)
    for name in given:
        if name not in known:
            hint = nearest(str(name), list(known))
            raise ValueError(f"`measurements` has {name!r}, which is no quantity of tires. {hint}")
    absent = [name for name in _INPUTS[:3] if name not in given]
    if absent or not set(_FORCES) & given.keys():
        lacking = " and ".join([*map(repr, absent), *(["a force"] if not absent else [])])
        raise ValueError(f"`measurements` lacks {lacking}.")
    arrays = {name: real_array(v, f"`measurements[{name!r}]`") for name, v in given.items()}
    for name, array in arrays.items():
        if array.ndim > 1:
            raise ValueError(
                f"`measurements[{name!r}]` must be one-dimensional, got the shape {array.shape}."
            )
        finite = np.isfinite(array) if name in _INPUTS else ~np.isinf(array)
        if not finite.all():
            raise ValueError(f"`measurements[{name!r}]` must be finite, got {shown(array)}.")
    lengths = {len(a) for a in arrays.values() if a.ndim}
    if len(lengths) > 1:
        raise ValueError(
            "`measurements` must hold arrays of one length, got "
            + ", ".join(f"{len(a)} of {n!r}" for n, a in arrays.items() if a.ndim)
            + "."
        )
    length = next(iter(lengths), 1)
    whole = {name: np.broadcast_to(a, (length,)).copy() for name, a in arrays.items()}
    measured = {name: whole.pop(name) for name in _FORCES if name in whole}
    if not any(np.isfinite(values).any() for values in measured.values()):
        raise ValueError("`measurements` has no measured force: all are NaN.")
    return whole, measured


def _read_bounds(
    bounds: Mapping[str, Sequence[float]] | None, names: list[str]
) -> tuple[np.ndarray, np.ndarray]:
    lower, upper = np.full(len(names), -np.inf), np.full(len(names), np.inf)
    for name, pair in check_mapping("bounds", bounds).items():
        if name not in names:
            raise ValueError(f"`bounds` has {name!r}, which is not among `free`: {some(names)}.")
        if not isinstance(pair, (tuple, list, np.ndarray)) or len(pair) != 2:
            raise TypeError(f"`bounds[{name!r}]` must be a pair of numbers, got {shown(pair)}.")
        k = names.index(name)
        low, high = (
            end if value is None else float(real_array(value, f"`bounds[{name!r}]`"))
            for value, end in zip(pair, (-np.inf, np.inf), strict=True)
        )
        if not low < high:
            raise ValueError(f"`bounds[{name!r}]` must ascend, got {shown(pair)}.")
        lower[k], upper[k] = low, high
    return lower, upper


def _root_mean_square(values: np.ndarray) -> float:
    finite = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(finite**2))) if finite.size else 0.0


def _standard_errors(found: Any, count: int) -> np.ndarray:
    """Return standard deviations from the derivatives at the minimum; infinite where these fail.

    Columns are scaled to unit length, so that the rank does not depend on the parameters' units.
    """
    sizes = np.linalg.norm(found.jac, axis=0)
    errors = np.full(count, np.inf)
    acting = sizes > 0.0
    degrees = max(len(found.fun) - count, 1)
    if acting.any():
        _, values, rows = np.linalg.svd(found.jac[:, acting] / sizes[acting], full_matrices=False)
        noise = 2.0 * found.cost / degrees
        regular = values > values[0] * np.finfo(float).eps ** 0.5
        weak = (np.abs(rows[~regular]) > 0.1).any(axis=0)
        spread = noise * ((rows[regular] / values[regular, None]) ** 2).sum(axis=0)
        errors[acting] = np.where(weak, np.inf, np.sqrt(spread) / sizes[acting])
    return errors
