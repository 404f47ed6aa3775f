"""The options of a solver, checked."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, TypedDict

import numpy as np

from pydy._checks import number, real_array, whole
from pydy._names import nearest
from pydy.solvers.adjoint.recording import Recording
from pydy.solvers.events import CompiledEvents
from pydy.solvers.run.constraints import CompiledConstraints
from pydy.solvers.sensitivities import CompiledSensitivities

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "Options",
    "SolverOptions",
    "StepOptions",
    "check_option_names",
    "check_scipy_options",
    "read_options",
]

_DEFAULT = 1.49012e-8  # odeint's: the square root of the rounding unit


class StepOptions(TypedDict, total=False):
    """Options for the size and number of steps, for type checkers; see `Options`."""

    rtol: ArrayLike
    atol: ArrayLike
    first_step: float | None
    max_step: float
    max_steps: int
    step: float | None


class SolverOptions(StepOptions, total=False):
    """Options of a solver called directly, except `full_output`; see `Options`."""

    progress: bool
    dense_output: bool
    events: CompiledEvents | None
    constraints: CompiledConstraints | None
    sensitivities: CompiledSensitivities | None


@dataclass(frozen=True)
class Options:
    """The options of a solver.

    Attributes
    ----------
    rtol, atol : float or array_like, shape (n,)
        The error allowed in a step is ``atol + rtol * abs(x)``.
    first_step : float, optional
        The size of the first step; found automatically by default.
    max_step : float
    max_steps : int
        Accepted and rejected steps together.
    step : float, optional
        The size of steps of a method without error control. Each interval between two times is
        divided into equal steps not larger than this.
    full_output : bool
        Whether ``(states, info)`` is returned.
    progress : bool
        Whether a bar shows the simulated time; needs tqdm.
    events : CompiledEvents or None
    constraints : CompiledConstraints or None
    sensitivities : CompiledSensitivities or None
        Of a state that has columns of sensitivities after it; `rtol` and `atol` are those of the
        state alone.
    recording : Recording or None
        What notes the steps.
    dense_output : bool
        Whether the steps are kept, so that the solution between them is known.
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
    sensitivities: CompiledSensitivities | None = None
    recording: Recording | None = None
    dense_output: bool = False


_MOST = 2**62
_NAMES = {field.name for field in fields(Options)} - {"recording"}


def read_options(method: str, adaptive: bool, given: Mapping[str, Any]) -> Options:
    """Check the names and values of options.

    Raises
    ------
    TypeError
        The method has no such option.
    ValueError
        A value is not valid.
    """
    foreign = {"step"} if adaptive else {"rtol", "atol", "first_step", "max_step"}
    names = _NAMES - foreign
    check_option_names(method, names, given)
    _check_kinds(given)
    if given.get("max_step", np.inf) is None:
        given = {**given, "max_step": np.inf}
    for name in given.keys() & {"first_step", "max_step", "step"}:
        if given[name] is not None:
            given = {**given, name: number(given[name], f"`{name}`")}
            if not given[name] > 0.0:
                raise ValueError(f"`{name}` must be positive, got {given[name]!r}.")
    for name in given.keys() & {"rtol", "atol"}:
        value = real_array(given[name], f"`{name}`")
        if not (np.isfinite(value).all() and (value >= 0.0).all()):
            raise ValueError(f"`{name}` must be finite and not negative, got {value}.")
        if value.ndim > 1:
            raise ValueError(f"`{name}` must be one-dimensional, got the shape {value.shape}.")
        given = {**given, name: value if value.ndim else float(value)}
    if "max_steps" in given:
        most = number(given["max_steps"], "`max_steps`")
        if not most >= 1.0:
            raise ValueError(f"`max_steps` must be at least 1, got {given['max_steps']!r}.")
        given = {**given, "max_steps": int(min(most, _MOST))}
    options = Options(**given)
    if not adaptive and options.step is None:
        raise ValueError(f"`{method}` takes steps of fixed size: pass `step`, their largest size.")
    return options


# The same options of the native solvers and `solve_ivp`, and of `odeint`.
_SAME = (
    *(("max_step", "hmax"), ("first_step", "h0"), ("min_step", "hmin"), ("max_steps", "mxstep")),
    *(("jac", "Dfun"), ("lband", "ml"), ("uband", "mu")),
)


_OPTIONAL = {"rtol", "atol", "tcrit", "ml", "mu", "lband", "uband", "first_step"}  # may be None


def check_option_names(solver: str, names: Iterable[str], given: Mapping[str, Any]) -> None:
    """Raise for an option that a solver does not have, and suggest the nearest one."""
    names = sorted(names)
    unknown = [name for name in given if name not in names]
    if unknown:
        alike = [name for pair in _SAME if unknown[0] in pair for name in pair if name in names]
        hint = f"It is called `{alike[0]}` there." if alike else ""
        raise TypeError(
            f"`{solver}` has no option `{unknown[0]}`; its options are {', '.join(names)}. "
            f"{hint or nearest(unknown[0], names, or_all=False)}".rstrip()
        )


def check_scipy_options(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return options of SciPy's solvers, or say which is no number; SciPy's own errors do not."""
    checked = dict(given)
    for name, value in given.items():
        what = f"`{name}`"
        if name in _OPTIONAL and value is None:
            continue
        if name in ("rtol", "atol", "tcrit"):
            checked[name] = real_array(value, what)
        elif name in ("hmax", "hmin", "h0", "first_step", "max_step", "min_step"):
            checked[name] = number(value, what)
        elif name in ("mxstep", "mxhnil", "mxordn", "mxords", "ml", "mu", "lband", "uband"):
            checked[name] = whole(value, what, 0)
    return checked


def _check_kinds(given: Mapping[str, Any]) -> None:
    """Refuse flags that are no flags, and events and constraints that are not compiled."""
    for name in given.keys() & {"full_output", "progress", "dense_output"}:
        value = given[name]
        if not isinstance(value, bool | np.bool_ | int) or value not in (0, 1):
            raise TypeError(f"`{name}` must be True or False, got {value!r}.")
    kinds = {
        "events": ("integrate", CompiledEvents),
        "constraints": ("integrate", CompiledConstraints),
        "sensitivities": ("simulate", CompiledSensitivities),
    }
    for name, (method, kind) in kinds.items():
        value = given.get(name)
        if not isinstance(value, kind | None):
            raise TypeError(
                f"`{name}` cannot be passed directly to a solver, got {value!r}: they must be "
                f"compiled with the equations. Call system.{method}({name}=…), with "
                "`system.ode_solver` set to this solver."
            )
