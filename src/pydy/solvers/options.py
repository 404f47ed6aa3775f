"""The options of a solver, checked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from pydy._checks import number, real_array
from pydy.solvers.constraints import CompiledConstraints
from pydy.solvers.events import CompiledEvents

__all__ = ["Options", "read_options"]

_DEFAULT = 1.49012e-8  # odeint's: the square root of the rounding unit


@dataclass(frozen=True)
class Options:
    """What a user may say to a solver.

    Attributes
    ----------
    rtol, atol : float or array_like, shape (n,)
        The error allowed in a step is ``atol + rtol * abs(x)``.
    first_step : float, optional
        The size of the first step; found automatically by default.
    max_step : float
    max_steps : int
        Accepted and rejected ones together.
    step : float, optional
        The size of steps of a method without error control. Each interval between two times is
        divided into equal steps not larger than this.
    full_output : bool
        Whether ``(states, info)`` is returned.
    progress : bool
        Whether a bar shows the simulated time; needs tqdm.
    events : CompiledEvents or None
    constraints : CompiledConstraints or None
    """

    rtol: Any = _DEFAULT
    atol: Any = _DEFAULT
    first_step: float | None = None
    max_step: float = np.inf
    max_steps: int = 10_000_000
    step: float | None = None
    full_output: bool = False
    progress: bool = False
    events: CompiledEvents | None = None
    constraints: CompiledConstraints | None = None


_NAMES = {field.name for field in fields(Options)}


def read_options(method: str, adaptive: bool, given: Mapping[str, Any]) -> Options:
    """Check the names and values of options.

    Raises
    ------
    TypeError
        An option that the method does not have.
    ValueError
        A value that makes no sense.
    """
    foreign = {"step"} if adaptive else {"rtol", "atol", "first_step", "max_step"}
    names = _NAMES - foreign
    unknown = [name for name in given if name not in names]
    if unknown:
        raise TypeError(
            f"`{method}` has no option `{unknown[0]}`; its options are {', '.join(sorted(names))}."
        )
    options = Options(**given)
    for name in given.keys() & {"first_step", "max_step", "step"}:
        value = given[name]
        if value is not None and not number(value, f"`{name}`") > 0.0:
            raise ValueError(f"`{name}` must be positive, got {value!r}.")
    if not adaptive and options.step is None:
        raise ValueError(f"`{method}` takes steps of fixed size: pass `step`, their largest size.")
    if not options.max_steps >= 1:
        raise ValueError(f"`max_steps` must be at least 1, got {options.max_steps!r}.")
    for name in given.keys() & {"rtol", "atol"}:
        value = given[name]
        if type(value) is float and 0.0 <= value < np.inf:
            continue
        value = real_array(value, f"`{name}`")
        if not (np.isfinite(value).all() and (value >= 0.0).all()):
            raise ValueError(f"`{name}` must be finite and not negative, got {value}.")
    return options
