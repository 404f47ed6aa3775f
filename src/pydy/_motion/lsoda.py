"""`odeint`, the default solver: SciPy's interface to LSODA.

`scipy.integrate` imports 350 modules, which take a third of the processor time to a first result;
`odeint` needs one of them, which is compiled and no public interface of SciPy. It is called only in
releases in which the tests compare it with `scipy.integrate.odeint`, and while that package is not
loaded. Otherwise `scipy.integrate.odeint` is called, which returns the same bits.
"""

from __future__ import annotations

import sys
import threading
import warnings
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from functools import cache, partial
from importlib.machinery import PathFinder
from importlib.util import module_from_spec
from inspect import signature, unwrap
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy

from pydy._checks import descends
from pydy._collector import collector_paused
from pydy._errors import IntegrationError
from pydy._motion.scipy_options import check_scipy_options
from pydy._names import numbers_of
from pydy.solvers import Outcome

if TYPE_CHECKING:
    from types import ModuleType

    from pydy._sympy_types import AnySymbol

# The latest release of SciPy whose compiled module is called by itself.
COMPARED_UP_TO = (1, 17)
_PACKAGE = "scipy.integrate"
# Options in the order in which the compiled function takes them, with odeint's defaults; -1 stands
# for the full Jacobian.
_DEFAULTS: dict[str, Any] = {
    "Dfun": None, "col_deriv": 0, "ml": -1, "mu": -1, "full_output": 0, "rtol": None, "atol": None,
    "tcrit": None, "h0": 0.0, "hmax": 0.0, "hmin": 0.0, "ixpr": 0, "mxstep": 0, "mxhnil": 0,
    "mxordn": 12, "mxords": 5,
}  # fmt: skip
# LSODA's codes, as odeint words them.
_MESSAGES = {
    2: "Integration successful.",
    1: "Nothing was done; the integration time was 0.",
    -1: "Excess work done on this call (perhaps wrong Dfun type).",
    -2: "Excess accuracy requested (tolerances too small).",
    -3: "Illegal input detected (internal error).",
    -4: "Repeated error test failures (internal error).",
    -5: "Repeated convergence failures (perhaps bad Jacobian or tolerances).",
    -6: "Error weight became zero during problem.",
    -7: "Internal workspace insufficient to finish (internal error).",
    -8: "Run terminated (internal error).",
}
_ILLEGAL = "Illegal input"
_GOOD = ("Integration successful", "Nothing was done")
MORE_STEPS = (
    "Raise `mxstep`, how many steps it may take between two times (500 by default), ask for more "
    "`times`, or set `system.ode_solver = 'dop853'`."
)


def odeint(*args: Any, **options: Any) -> Any:
    """Stand for `scipy.integrate.odeint` until it is called: only then is it loaded."""
    return public_odeint()(*args, **options)


def public_odeint() -> Callable[..., Any]:
    """Return `scipy.integrate.odeint`.

    The first import of its package runs with the cycle collector paused: its modules would start a
    full collection, which visits all of SymPy's objects and takes a tenth of the import.
    """
    if _PACKAGE in sys.modules:
        return scipy.integrate.odeint  # type: ignore[no-any-return]
    with collector_paused():
        return scipy.integrate.odeint  # type: ignore[no-any-return]


def is_odeint(solver: object) -> bool:
    """Return whether a solver is `odeint`; without loading SciPy's package."""
    package = sys.modules.get(_PACKAGE)
    return solver is odeint or (package is not None and solver is getattr(package, "odeint", None))


def odeint_options() -> frozenset[str]:
    """Return the options of odeint that users can pass."""
    if _compiled_odeint() is not None:
        return frozenset({*_DEFAULTS, "printmessg"})
    positional = {"func", "y0", "t", "args", "tfirst"}
    return frozenset(signature(public_odeint()).parameters) - positional


def refuse_nested(name: str) -> None:
    """Raise if LSODA is running: a function that it calls must not start the solver `name`.

    LSODA, which odeint and solve_ivp call, has static memory.
    """
    # The call stack is always up to date, unlike a flag after an interrupt.
    running = {_run_compiled.__code__: "odeint"}
    if _PACKAGE in sys.modules:
        running[unwrap(scipy.integrate.odeint).__code__] = "odeint"
        running[unwrap(scipy.integrate.LSODA._step_impl).__code__] = "LSODA"
    frame = sys._getframe()
    while frame := frame.f_back:  # type: ignore[assignment]
        if frame.f_code in running:
            raise RuntimeError(
                f"`{name}` cannot be started by a function that `{running[frame.f_code]}` calls: "
                "SciPy's LSODA, which is behind both, works on one integration at a time. Give one "
                "of the two systems another solver, such as `system.ode_solver = 'dop853'`."
            )


def _compiled_odeint() -> Callable[..., Any] | None:
    """Return the compiled function behind odeint, or None where odeint is called itself."""
    return None if _PACKAGE in sys.modules else getattr(_compiled_module(), "odeint", None)


@cache
def _compiled_module() -> ModuleType | None:
    """Load SciPy's compiled LSODA without its package; None if this release was not compared."""
    release = scipy.__version__.split(".")[:2]
    if not all(part.isdigit() for part in release) or (*map(int, release),) > COMPARED_UP_TO:
        return None
    folder = Path(scipy.__file__).parent / "integrate"
    spec = PathFinder.find_spec(f"{_PACKAGE}._odepack", [str(folder)])
    if spec is None or spec.loader is None:
        return None
    try:
        module = module_from_spec(spec)
        spec.loader.exec_module(module)
    except ImportError:
        return None
    return module


def _run_public(
    f: Callable[..., np.ndarray],
    x0: np.ndarray,
    times: np.ndarray,
    args: tuple[object, ...],
    **options: Any,
) -> tuple[np.ndarray, dict[str, Any]]:
    """Call `scipy.integrate.odeint` without its warning, which an error replaces."""
    # Filters are global to the process, so that they are changed only in the main thread.
    alone = threading.current_thread() is threading.main_thread()
    with warnings.catch_warnings() if alone else nullcontext():
        if alone and not options.get("printmessg"):
            warnings.simplefilter("ignore", scipy.integrate.ODEintWarning)
        states, info = public_odeint()(f, x0, times, args=args, **options)
    return states, info


def _run_compiled(
    compiled: Callable[..., Any],
    f: Callable[..., np.ndarray],
    x0: np.ndarray,
    times: np.ndarray,
    args: tuple[object, ...],
    **options: Any,
) -> tuple[np.ndarray, dict[str, Any]]:
    """Call the compiled function as odeint does: with copies, which it writes to."""
    values = {**_DEFAULTS, **{k: v for k, v in options.items() if v is not None}}
    states, info, code = compiled(f, np.array(x0), np.array(times), args, *values.values(), 0)
    return states, {**info, "message": _MESSAGES[code]}


def check_scales(options: dict[str, object], x0: np.ndarray) -> None:
    """Refuse a zero `atol` for a state that is zero: SciPy's first step would remain NaN."""
    atol = np.asarray(options.get("atol", 1.0))
    x0 = np.asarray(x0)
    if atol.ndim and atol.shape != x0.shape:
        return  # which SciPy refuses
    zero_columns = np.flatnonzero((atol == 0.0) & (x0 == 0.0))
    if zero_columns.size:
        raise ValueError(
            "`atol` must be above 0 for states that are 0 at the start, got 0 for "
            f"x[{zero_columns[0]}]: SciPy divides errors by `atol` + `rtol`·|x|."
        )


def came_to_the_end(states: np.ndarray, info: dict[str, Any]) -> bool:
    """Return whether `odeint` reached the last time."""
    return bool(info["message"].startswith(_GOOD) and np.isfinite(states).all())


def call_odeint(
    f: Callable[..., np.ndarray],
    x0: np.ndarray,
    times: np.ndarray,
    args: tuple[object, ...],
    names: Sequence[AnySymbol],
    options: dict[str, object],
) -> tuple[np.ndarray, dict[str, Any]]:
    """Return the states and information of `odeint`; raise IntegrationError if it gives up."""
    refuse_nested("odeint")
    options = check_scipy_options(options)
    check_scales(options, x0)
    compiled = None if "printmessg" in options else _compiled_odeint()
    run = _run_public if compiled is None else partial(_run_compiled, compiled)
    states, info = run(f, x0, times, args, **{**options, "full_output": True})
    if came_to_the_end(states, info):
        return states, info
    good = info["message"].startswith(_GOOD)
    # Rows that were not reached contain uninitialised memory, also in the times.
    came, sign = np.isfinite(states).all(axis=1), -1.0 if descends(times) else 1.0
    if not good:
        came[1:] &= sign * info["tcur"] >= sign * times[1:]
    # Illegal input after successful steps means infinite derivatives.
    advanced = (sign * info["tcur"]).max() > sign * times[0]
    if good or (info["message"].startswith(_ILLEGAL) and advanced):
        outcome, reason = Outcome.NOT_FINITE, "met derivatives or errors that are not finite"
    else:
        reason = info["message"].split(".")[0]
        excess = reason.startswith("Excess work")
        outcome = Outcome.TOO_MANY_STEPS if excess else Outcome.STEP_UNDERFLOW
        reason = f"gave up ({reason})"
    reached = max(1, int(np.argmin(came)))
    t, x = float(times[reached - 1]), states[reached - 1].copy()
    stop_time = float(info["tcur"][reached - 1])
    if (
        not good
        and sign * t <= sign * stop_time <= sign * times[reached]
        and np.isfinite(states[reached]).all()
    ):
        t, x = stop_time, states[reached].copy()  # the row of the time at which it gave up
    rows = {k: v[:reached] if isinstance(v, np.ndarray) else v for k, v in info.items()}
    raise IntegrationError(
        f"`odeint` {reason} at t = {t!r} in the state {numbers_of(names, x)}. "
        f"{MORE_STEPS if outcome == Outcome.TOO_MANY_STEPS else outcome.remedy}",
        times[:reached].copy(),
        states[:reached].copy(),
        t,
        x,
        {**rows, "method": "odeint", "code": int(outcome), "status": reason, "reached": reached},
    )
