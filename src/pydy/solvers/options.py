"""The options of a solver, checked."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypedDict

import numpy as np

from pydy._checks import Check, checked, flag, number, optional, positive, shown, tolerance
from pydy._names import nearest
from pydy.solvers.constraints import CompiledConstraints
from pydy.solvers.events import CompiledEvents
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
class Begun:
    """What is known of events where a motion continues another one."""

    handled: frozenset[int] | None = None  # which do not happen at the first time; None: none do
    sides: tuple[int, ...] | None = None  # the signs of all just after the first time


@dataclass(frozen=True)
class Options:
    """The options of a solver."""

    # a number or (n,): the error allowed in a step is ``atol + rtol * abs(x)``
    rtol: Any = _DEFAULT
    atol: Any = _DEFAULT
    first_step: float | None = None  # found automatically by default
    max_step: float = np.inf
    max_steps: int = 10_000_000  # accepted and rejected ones together
    # the size of steps of a method without error control. Each interval between two times is
    # divided into equal steps not larger than this
    step: float | None = None
    full_output: bool = False  # whether ``(states, info)`` is returned
    progress: bool = False  # whether a bar shows the simulated time; needs tqdm
    events: CompiledEvents | None = None
    constraints: CompiledConstraints | None = None
    # of a state that has columns of sensitivities after it; `rtol` and `atol` are those of the
    # state alone
    sensitivities: CompiledSensitivities | None = None
    # how many states there are, where integrals follow them: then all steps are kept
    recorded: int | None = None
    # whether the steps are kept, so that the solution between them is known
    dense_output: bool = False
    begun: Begun | None = None  # None: the motion starts at the first time


def _max_step(value: Any, what: str) -> float:
    return np.inf if value is None else positive(value, what)


def _max_steps(value: Any, what: str) -> int:
    most = number(value, what)
    if not most >= 1.0:
        raise ValueError(f"{what} must be at least 1, got {value!r}.")
    return int(min(most, 2**62))


def _compiled(kind: type, method: str) -> Check:
    """Return the check that an option which a System compiles has been compiled."""

    def check(value: Any, what: str) -> Any:
        if isinstance(value, kind | None):
            return value
        raise TypeError(
            f"{what} cannot be passed directly to a solver, got {shown(value)}: they must be "
            f"compiled with the equations. Call system.{method}({what[1:-1]}=…), with "
            "`system.ode_solver` set to this solver."
        )

    return check


_NATIVE: dict[str, Check] = {
    **dict.fromkeys(("full_output", "progress", "dense_output"), flag),
    "events": _compiled(CompiledEvents, "integrate"),
    "constraints": _compiled(CompiledConstraints, "integrate"),
    "sensitivities": _compiled(CompiledSensitivities, "simulate"),
    "begun": _compiled(Begun, "simulate"),
    **dict.fromkeys(("first_step", "step"), optional(positive)),
    "max_step": _max_step,
    **dict.fromkeys(("rtol", "atol"), tolerance),
    "max_steps": _max_steps,
}


def read_options(method: str, adaptive: bool, given: Mapping[str, Any]) -> Options:
    """Check the names and values of options."""
    foreign = {"step"} if adaptive else {"rtol", "atol", "first_step", "max_step"}
    check_option_names(method, _NATIVE.keys() - foreign, given)
    options = Options(**checked(_NATIVE, given))
    if not adaptive and options.step is None:
        raise ValueError(f"`{method}` takes steps of fixed size: pass `step`, their largest size.")
    return options


# The same options of the native solvers and `solve_ivp`, and of `odeint`.
_SAME = (
    *(("max_step", "hmax"), ("first_step", "h0"), ("min_step", "hmin"), ("max_steps", "mxstep")),
    *(("jac", "Dfun"), ("lband", "ml"), ("uband", "mu")),
    # Of methods with steps of one size: the largest.
    *(("max_step", "step"), ("hmax", "step")),
)


def check_option_names(solver: str, names: Iterable[str], given: Mapping[str, Any]) -> None:
    """Refuse an option that a solver does not have, and suggest the nearest one."""
    names = sorted({*names} - {"begun"} if "begun" not in given else names)
    unknown = [name for name in given if name not in names]
    if unknown:
        alike = [name for pair in _SAME if unknown[0] in pair for name in pair if name in names]
        hint = f"It is called `{alike[0]}` there." if alike else ""
        raise TypeError(
            f"`{solver}` has no option `{unknown[0]}`; its options are {', '.join(names)}. "
            f"{hint or nearest(unknown[0], names, or_all=False)}".rstrip()
        )
