"""Step-size control with sensitivities: what a native solver takes into account."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import factorial
from typing import Any

import numpy as np

from pydy._integration.event_derivatives import compiled_event
from pydy._integration.parameters import Parameter, mean_spacing
from pydy._integration.sensitivities import AugmentedSystem, with_all_constraints
from pydy.solvers import (
    CompiledSensitivities,
    Event,
    Options,
    ParameterSize,
    Solver,
    read_options,
    tableau_of,
)

# Motions smaller than this many tolerances are invisible to the step control: their errors are at
# most a thousandth of them, if errors are as large as the tolerances.
_VISIBLE = 1e3


def compiled_sensitivities(
    augmented: AugmentedSystem,
    x: np.ndarray,
    options: Mapping[str, object],
    controlled: bool = False,
    events: Sequence[Event] = (),
) -> CompiledSensitivities:
    """Return the sensitivities of a motion that begins at x, for native solvers.

    If `controlled`, the step control includes them.
    """
    columns, model = augmented.columns, augmented.model
    sizes = ParameterSize.scales(
        parameter_sizes(augmented, options), x, augmented.inputs.values, augmented.p, columns.count
    )
    return CompiledSensitivities(
        columns.states,
        columns.sources,
        sizes,
        x,
        are_controlled(augmented.parameters, controlled),
        lambda event: compiled_event(model, events[event], columns.wanted),
        lambda: with_all_constraints(augmented).kernel("holonomic", "velocity"),
    )


def are_controlled(parameters: Sequence[Parameter], requested: bool) -> bool:
    """Return whether the step control includes the sensitivities: those by samples, always."""
    return requested or mean_spacing(parameters) is not None


def parameter_sizes(
    augmented: AugmentedSystem, options: Mapping[str, object]
) -> tuple[ParameterSize, ...]:
    """Return the parameters' sizes.

    States with individual absolute tolerances have sizes of at least atol / rtol; all others have
    sizes of at least 1.
    """
    sizes = tuple(parameter.sized for parameter in augmented.parameters)
    least = least_sizes(options, augmented.columns.states).tolist()
    return tuple(s._replace(least=least[s.position]) if s.group == "x" else s for s in sizes)


def least_sizes(options: Mapping[str, Any], n: int) -> np.ndarray:
    """Return the least sizes of n initial conditions; see `parameter_sizes`."""
    if np.shape(options.get("atol", 0.0)) == (n,):
        rtol, atol = (np.asarray(options.get(name, 0.0), dtype=float) for name in ("rtol", "atol"))
        if (rtol > 0.0).all() and (atol > 0.0).all():
            sizes: np.ndarray = atol / rtol
            return np.broadcast_to(sizes, n)
    return np.ones(n)


def with_step_limit(
    augmented: AugmentedSystem,
    solver: Solver,
    options: dict[str, object],
    x0: np.ndarray,
    times: np.ndarray,
    controlled: bool,
) -> dict[str, Any]:
    """Return options with a maximum step where the error of the states is no indicator.

    Collinear samples leave no kink in the states. A motion that begins at rest or in a steady
    state shows no error either: growth and oscillations near it appear only in the
    sensitivities, unless these are `controlled` too.
    """
    if not solver.adaptive:
        return options
    spacing = mean_spacing(augmented.parameters)
    longest = np.inf if spacing is None else spacing
    if not controlled:
        longest = min(longest, _step_limit_at_rest(augmented, solver, options, x0, times))
    return options if longest == np.inf else {"max_step": longest, **options}


def _step_limit_at_rest(
    augmented: AugmentedSystem,
    solver: Solver,
    options: Mapping[str, object],
    x0: np.ndarray,
    times: np.ndarray,
) -> float:
    """Return the maximum step for a motion that begins steadily and shows no error, or inf."""
    model, n, at = augmented.model, len(x0), times[:1]
    tolerances = {k: options[k] for k in ("rtol", "atol") if k in options}
    read = read_options(solver.name, solver.adaptive, tolerances)
    if any(np.shape(tolerance) not in ((), (n,)) for tolerance in (read.rtol, read.atol)):
        return float(np.inf)  # an invalid shape, which is reported elsewhere
    args = at, x0[None], augmented.inputs.rows(x0[None], at), augmented.p
    equations = augmented.definition.equations
    first = len(equations.coordinates)
    speeds = slice(first, first + len(equations.speeds))
    changes = np.abs(model.compiled("rates").evaluate(*args)[0][0, speeds])
    visible = (_VISIBLE * (read.atol + read.rtol * np.abs(x0)))[speeds]
    if not (changes * (times[-1] - times[0]) <= _VISIBLE * visible).all():
        return float(np.inf)  # the derivatives are not needed
    slopes = model.compiled_jacobian("rates", "x").evaluate(*args)[0].reshape(n, n)
    if not np.isfinite(slopes).all():
        return float(np.inf)
    eigenvalues = np.linalg.eigvals(slopes)
    implicit = solver.name == "radau"  # decaying modes need no short steps
    fastest = (
        np.maximum(eigenvalues.real, np.abs(eigenvalues.imag)) if implicit else np.abs(eigenvalues)
    ).max()
    if not (fastest > 0.0 and (changes <= fastest * visible).all()):
        return float(np.inf)
    order = 5 if implicit else tableau_of(solver.name).order
    # The relative error of a step h for exp(λ t) is (h λ)ᵖ⁺¹ / (p + 1)!.
    allowed = float(np.max(read.rtol)) or Options.rtol
    share = (allowed * factorial(order + 1)) ** (1.0 / (order + 1))
    return float(min(share, 1.0) / fastest)
