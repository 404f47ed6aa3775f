"""The options of a solver, checked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypedDict

import numpy as np

from pydy._checks import flag, number, positive, shown, tolerance
from pydy._option_checks import Check, check_option_names, checked, optional
from pydy.solvers.compiled_events import CompiledEvents
from pydy.solvers.constraints import CompiledConstraints
from pydy.solvers.sensitivities import CompiledSensitivities

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

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
class EventContinuation:
    """The state of the events at the start of a motion that continues another one."""

    # Events that do not happen at the first time; None: no event does.
    handled: frozenset[int] | None = None
    sides: tuple[int, ...] | None = None  # the signs of all just after the first time


@dataclass(frozen=True)
class Options:
    """The options of a solver."""

    # a number or (n,): the error allowed in a step is ``atol + rtol * abs(x)``
    rtol: float | np.ndarray = _DEFAULT
    atol: float | np.ndarray = _DEFAULT
    first_step: float | None = None  # chosen automatically by default
    max_step: float = np.inf
    max_steps: int = 10_000_000  # accepted and rejected ones together
    # The step size of a method without error control: each interval between two times is divided
    # into equal steps not larger than this.
    step: float | None = None
    full_output: bool = False  # whether ``(states, info)`` is returned
    progress: bool = False  # whether a bar shows the simulated time; needs tqdm
    events: CompiledEvents | None = None
    constraints: CompiledConstraints | None = None
    # If columns of sensitivities follow the state; `rtol` and `atol` are those of the state alone.
    sensitivities: CompiledSensitivities | None = None
    # The number of states if integrals follow them; all steps are then recorded.
    recorded: int | None = None
    # Whether the steps are recorded, for the solution between them.
    dense_output: bool = False
    continuation: EventContinuation | None = None  # None: the motion starts at the first time


def _max_step(value: Any, label: str) -> float:
    return np.inf if value is None else positive(value, label)


def _max_steps(value: Any, label: str) -> int:
    most = number(value, label)
    if not most >= 1.0:
        raise ValueError(f"{label} must be at least 1, got {value!r}.")
    return int(min(most, 2**62))


def _compiled(kind: type, method: str) -> Check:
    """Return a check that a System has compiled an option."""

    def check(value: Any, label: str) -> Any:
        if isinstance(value, kind | None):
            return value
        raise TypeError(
            f"{label} cannot be passed directly to a solver, got {shown(value)}: they must be "
            f"compiled with the equations. Call system.{method}({label[1:-1]}=…), with "
            "`system.ode_solver` set to this solver."
        )

    return check


_NATIVE: dict[str, Check] = {
    **dict.fromkeys(("full_output", "progress", "dense_output"), flag),
    "events": _compiled(CompiledEvents, "integrate"),
    "constraints": _compiled(CompiledConstraints, "integrate"),
    "sensitivities": _compiled(CompiledSensitivities, "simulate"),
    "continuation": _compiled(EventContinuation, "simulate"),
    **dict.fromkeys(("first_step", "step"), optional(positive)),
    "max_step": _max_step,
    **dict.fromkeys(("rtol", "atol"), tolerance),
    "max_steps": _max_steps,
}


def read_options(method: str, adaptive: bool, values: Mapping[str, object]) -> Options:
    """Check the names and values of options."""
    foreign = {"step"} if adaptive else {"rtol", "atol", "first_step", "max_step"}
    check_option_names(method, _NATIVE.keys() - foreign, values)
    options = Options(**checked(_NATIVE, values))
    if not adaptive and options.step is None:
        raise ValueError(f"`{method}` takes steps of fixed size: pass `step`, their largest size.")
    return options
