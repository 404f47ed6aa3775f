"""IPOPT by its C interface, out of the library that the wheel of CasADi contains.

Nothing else of CasADi is used or loaded. The solver's callbacks are machine code that reads and
writes the solver's memory (see `nlp.Native`). Python runs once in each iteration, to record it, to
show progress and to check for Ctrl-C.

References
----------
A. Wächter and L. T. Biegler, On the implementation of an interior-point filter line-search
algorithm for large-scale nonlinear programming, Math. Program. 106 (2006) 25–57.
"""

from __future__ import annotations

import ctypes
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from ctypes import c_bool, c_char_p, c_double, c_int, c_void_p
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from pydy._checks import shown
from pydy._errors import MissingDependencyError, OptimizationError
from pydy._forks import in_child
from pydy._interrupts import Interrupts
from pydy.control.nlp import SIGNATURES, Nlp
from pydy.control.tuning import TOLERANCE, WARM_BARRIER

STATUS = {
    0: "solved",
    1: "solved to the `acceptable_tol` of IPOPT, not to its `tol`",
    2: "where it ended, the violation of equations and bounds is locally smallest: they contradict "
    "each other, or no motion is near the guess",
    3: "the steps became too small",
    4: "the iterates diverge: the objective may have no lower bound",
    5: "stopped",
    6: "a point that satisfies the equations was found",
    -1: "`max_iter` iterations were not enough",
    -2: "the search for a point that satisfies the equations failed",
    -3: "a step could not be computed",
    -4: "the processor time `max_cpu_time` is over",
    -5: "the time `max_wall_time` is over",
    -10: "there are fewer unknowns than equations",
    -11: "the bounds contradict each other",
    -12: "IPOPT does not take its `options`: it has no such option or value, or lacks what one "
    "names, such as a linear solver",
    -13: "the equations or their derivatives are not finite",
    -102: "there is not enough memory",
}
INFEASIBLE = 2
_WARM = {
    "warm_start_init_point": "yes",
    "mu_init": WARM_BARRIER,
    **{f"warm_start_{name}": WARM_BARRIER for name in
       ("bound_push", "bound_frac", "slack_bound_push", "slack_bound_frac", "mult_bound_push")},
}  # fmt: skip

# Options of IPOPT 3.14 that are integers, beside most of those of linear solvers.
_INTEGER_OPTIONS = """
    max_iter acceptable_iter print_level file_print_level print_frequency_iter num_linear_variables
    adaptive_mu_kkterror_red_iters quality_function_max_section_steps accept_after_max_steps
    watchdog_shortened_iter_trigger watchdog_trial_iter_max max_soc max_filter_resets
    filter_reset_trigger soc_method min_refinement_steps max_refinement_steps max_soft_resto_iters
    max_resto_iter limited_memory_max_history limited_memory_max_skipping
"""
_LINEAR = ("ma27_", "ma57_", "ma77_", "ma86_", "ma97_", "mumps_", "pardiso_", "spral_", "wsmp_")

_ITERATION_CALLBACK = ctypes.CFUNCTYPE(c_bool, c_int, c_int, *[c_double] * 8, c_int, c_void_p)


@dataclass(frozen=True)
class Iteration:
    """An iteration of IPOPT."""

    number: int
    objective: float
    violation: float  # the largest violation of an equation, relative to the equation's size
    dual_violation: float  # the largest scaled derivative of the Lagrangian
    barrier: float


@dataclass(frozen=True, eq=False)
class NlpSolution:
    """The point at which a solver ended, with its multipliers."""

    z: np.ndarray  # (n,)
    multipliers: np.ndarray  # (m,), of the unscaled rows, in the objective's units
    # (n,), the multipliers of the lower and the upper bounds of z, not negative.
    below: np.ndarray
    above: np.ndarray
    objective: float
    status: int  # a key of `STATUS`
    history: tuple[Iteration, ...]
    interrupted: BaseException | None  # what stopped it: Ctrl-C, or a MemoryError

    @property
    def solved(self) -> bool:
        """Whether the search converged."""
        return self.status in (0, 1)

    @property
    def message(self) -> str:
        """Why the search ended."""
        return STATUS.get(self.status, f"IPOPT ended with status {self.status}")

    @property
    def iterations(self) -> int:
        """Number of iterations; the first entry of the history is the initial guess."""
        return max(len(self.history) - 1, 0)

    def seeds(self, nlp: Nlp) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the scaled multipliers of rows, lower bounds and upper bounds."""
        return (
            self.multipliers * nlp.row_sizes / nlp.cost_size,
            self.below * nlp.sizes / nlp.cost_size,
            self.above * nlp.sizes / nlp.cost_size,
        )


_running: set[int] = set()  # the threads that are inside a solver
_locked = False  # in a child that was forked while another thread was inside


def _after_fork() -> None:
    global _locked
    current = {threading.get_ident()}
    _locked = _locked or bool(_running - current)
    _running.intersection_update(current)


in_child(_after_fork)


@contextmanager
def solving() -> Iterator[None]:
    """Mark this thread as inside a solver; refuse that in a child that was forked during a solve.

    MUMPS is not reentrant, so IPOPT locks it. In such a child the lock remains taken for ever, as
    the thread that holds it does not exist there.
    """
    if _locked:
        raise OptimizationError(
            "This process was forked while a thread of its parent searched for an optimum: the "
            "solver's locks are held by that thread, which does not exist here. Fork before the "
            "search or after it, or start processes by "
            "multiprocessing.get_context('spawn') or 'forkserver'.",
            None,
        )
    current = threading.get_ident()
    outer = current in _running
    _running.add(current)
    try:
        yield
    finally:
        if not outer:
            _running.discard(current)


@cache
def library() -> ctypes.CDLL:
    """Return the shared library of IPOPT, or raise an error that says how to install it."""
    spec = find_spec("casadi")
    if spec is None or not spec.submodule_search_locations:
        raise MissingDependencyError(
            "Optimal control needs IPOPT from the wheel of CasADi, which is not installed: "
            "pip install 'pydy[optimal]'."
        )
    folder = Path(next(iter(spec.submodule_search_locations)))
    pattern = {"win32": "*ipopt*.dll", "darwin": "libipopt*.dylib"}.get(
        sys.platform, "libipopt.so*"
    )
    candidates = [p for p in sorted(folder.glob(pattern)) if "casadi" not in p.name]
    reason = ""
    for path in candidates:
        try:
            lib = ctypes.CDLL(str(path))
            lib.CreateIpoptProblem, lib.SetIntermediateCallback  # noqa: B018
        except (OSError, AttributeError) as error:
            reason = reason or f" ({error})"
            continue
        _declare(lib)
        if _probe(lib):
            return lib
    raise MissingDependencyError(
        f"Optimal control needs the C interface of IPOPT, but {folder} has no library with "
        f"it{reason}: "
        "install a wheel of CasADi 3.6 or newer from PyPI, pip install --force-reinstall casadi."
    )


def _declare(lib: ctypes.CDLL) -> None:
    lib.CreateIpoptProblem.restype = c_void_p
    lib.CreateIpoptProblem.argtypes = [
        c_int, c_void_p, c_void_p, c_int, c_void_p, c_void_p, c_int, c_int, c_int, *[c_void_p] * 5,
    ]  # fmt: skip
    lib.FreeIpoptProblem.argtypes = [c_void_p]
    lib.FreeIpoptProblem.restype = None
    for kind, value in (("Str", c_char_p), ("Int", c_int), ("Num", c_double)):
        add = getattr(lib, f"AddIpopt{kind}Option")
        add.argtypes, add.restype = [c_void_p, c_char_p, value], c_bool
    lib.SetIntermediateCallback.argtypes = [c_void_p, c_void_p]
    lib.SetIntermediateCallback.restype = c_bool
    lib.IpoptSolve.argtypes = [c_void_p] * 8
    lib.IpoptSolve.restype = c_int


def _probe(lib: ctypes.CDLL) -> bool:
    """Return whether the library's numbers and indices have the sizes that we pass.

    The problem min (x − 3)² with 1 ≤ x ≤ 2 has the solution 2.
    """

    def write(address: int, value: float, kind: Any = c_double) -> bool:
        _view(address, kind)[0] = value
        return True

    def bend(*arguments: Any) -> bool:
        weight, (i, j, out) = arguments[3], arguments[-4:-1]
        return write(out, 2.0 * weight) if out else write(i, 0, c_int) and write(j, 0, c_int)

    functions = {
        "cost": lambda _n, y, _new, out, _: write(out, (_view(y)[0] - 3.0) ** 2),
        "gradient": lambda _n, y, _new, out, _: write(out, 2.0 * (_view(y)[0] - 3.0)),
        "hessian": bend,
    }
    calls = {
        name: ctypes.CFUNCTYPE(c_bool, *kinds)(functions.get(name, lambda *_: True))
        for name, kinds in SIGNATURES.items()
    }
    pointers = {name: ctypes.cast(call, c_void_p).value for name, call in calls.items()}
    empty, unit, at = np.empty(0), np.ones(1), np.zeros(1, np.int32)
    square: Any = SimpleNamespace(
        size=1, rows=0, cost_size=1.0, estimated=False, lower=unit, upper=2.0 * unit, sizes=unit,
        row_sizes=empty, row_bounds=(empty, empty), jacobian_at=(empty, empty), hessian_at=(at, at),
        native=SimpleNamespace(addresses=pointers, handle=None),
    )  # fmt: skip
    solution = solve(square, np.array([1.5]), lib=lib)
    return solution.status == 0 and abs(solution.z[0] - 2.0) < 0.001


class IterationRecorder:
    """The iterations of a search, and the exception that ended it, if any."""

    def __init__(
        self, nlp: Nlp, watch: Callable[[Iteration], None], interrupts: Interrupts
    ) -> None:
        self.nlp, self._watch, self._interrupts = nlp, watch, interrupts
        self.history: list[Iteration] = []
        self.raised: list[BaseException] = []
        self.stopped: BaseException | None = None  # reported as `interrupted` of the NlpSolution

    def solution(
        self,
        y: np.ndarray,
        multipliers: np.ndarray,
        below: np.ndarray,
        above: np.ndarray,
        objective: float,
        status: int,
    ) -> NlpSolution:
        """Return a solver's scaled result as an NlpSolution."""
        nlp = self.nlp
        return NlpSolution(
            # IPOPT widens bounds by 1e-8; without that, some searches do not terminate.
            z=np.clip(y * nlp.sizes, nlp.lower, nlp.upper),
            multipliers=multipliers * nlp.cost_size / nlp.row_sizes,
            below=below * nlp.cost_size / nlp.sizes,
            above=above * nlp.cost_size / nlp.sizes,
            objective=objective * nlp.cost_size,
            status=status,
            history=tuple(self.history),
            interrupted=self.stopped,
        )

    def guarded(
        self, _mode: int, number: int, objective: float, primal: float, dual: float, barrier: float,
        *_: object,
    ) -> bool:  # fmt: skip
        """Record an iteration; return whether to continue.

        An exception is stored, as ctypes would only print it.
        """
        try:
            if not self.raised:
                objective *= self.nlp.cost_size
                self.history.append(Iteration(number, objective, primal, dual, barrier))
                self._watch(self.history[-1])
                self._interrupts.check()
        except BaseException as error:  # noqa: BLE001
            self.raised.append(error)
        return not self.raised


@contextmanager
def _capture_handler_errors(raised: list[BaseException], guard: Any) -> Iterator[None]:
    """Store an exception that a signal handler raises at the entry of a callback.

    ctypes reports it as unraisable, and the callback returns an undefined result, often true; the
    search then ends at the next iteration. Only the main thread receives signals.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = sys.unraisablehook

    def note(report: Any) -> None:
        error, trace = report.exc_value, report.exc_traceback
        if trace is None or trace.tb_frame.f_code is not guard.__code__:
            before(report)
            return
        raised.append(error)

    sys.unraisablehook = note
    try:
        yield
    finally:
        sys.unraisablehook = before


def _view(address: int, kind: Any = c_double) -> Any:
    """Return one number of the solver's memory as an array."""
    return (kind * 1).from_address(address)


def program_bounds(nlp: Nlp) -> list[np.ndarray]:
    """Return the scaled bounds of unknowns and rows: low, high, low, high."""
    low, high = nlp.row_bounds
    return [  # beyond 1e19 a bound is none, `nlp_upper_bound_inf`
        np.clip(np.ascontiguousarray(value), -2e19, 2e19)
        for value in (nlp.lower / nlp.sizes, nlp.upper / nlp.sizes, low / nlp.row_sizes,
                      high / nlp.row_sizes)
    ]  # fmt: skip


def solver_options(nlp: Nlp, warm: NlpSolution | None) -> dict[str, object]:
    """Return the default options, which the user's options override."""
    # The program is scaled already.
    defaults: dict[str, object] = {
        "print_level": 0,
        "sb": "yes",
        "nlp_scaling_method": "none",
        "tol": TOLERANCE,
    }
    if nlp.estimated:
        defaults["hessian_approximation"] = "limited-memory"
    return defaults if warm is None else defaults | _WARM


def solve(
    nlp: Nlp,
    z: np.ndarray,
    *,
    options: Mapping[str, object] | None = None,
    watch: Callable[[Iteration], None] = lambda iteration: None,
    warm: NlpSolution | None = None,
    lib: ctypes.CDLL | None = None,
) -> NlpSolution:
    """Solve a nonlinear program from the initial guess z; `watch` is called in each iteration.

    `warm` is the NlpSolution of a program with the same unknowns and rows: the search starts with
    its multipliers. `lib` is `library()` by default.
    """
    lib = library() if lib is None else lib
    n, m = nlp.size, nlp.rows
    interrupts = Interrupts()
    recorder = IterationRecorder(nlp, watch, interrupts)
    callback = _ITERATION_CALLBACK(recorder.guarded)
    bounds, native = program_bounds(nlp), nlp.native
    addresses = [native.addresses[k] for k in SIGNATURES]
    problem = c_void_p(
        lib.CreateIpoptProblem(
            *(n, bounds[0].ctypes.data, bounds[1].ctypes.data),
            *(m, bounds[2].ctypes.data, bounds[3].ctypes.data),
            *(len(nlp.jacobian_at[0]), len(nlp.hessian_at[0]), 0, *addresses),
        )
    )
    if not problem:
        none = np.zeros(n)
        return NlpSolution(z, np.zeros(m), none, none, np.nan, -11, (), None)
    try:
        for name, value in {**solver_options(nlp, warm), **(options or {})}.items():
            _set_option(lib, problem, name, value)
        lib.SetIntermediateCallback(problem, ctypes.cast(callback, c_void_p))
        y, values, objective = np.array(z / nlp.sizes), np.empty(m), np.zeros(1)
        multipliers, below, above = np.zeros(m), np.zeros(n), np.zeros(n)
        if warm is not None:
            multipliers[:], below[:], above[:] = warm.seeds(nlp)
        status = None
        try:
            with solving(), interrupts, _capture_handler_errors(recorder.raised, recorder.guarded):
                status = lib.IpoptSolve(
                    problem,
                    *(a.ctypes.data for a in (y, values, objective, multipliers, below, above)),
                    native.handle,
                )
                if recorder.raised:
                    raise recorder.raised[0]
        except (KeyboardInterrupt, MemoryError) as stop:
            if status is None:
                raise
            recorder.stopped = stop
    finally:
        lib.FreeIpoptProblem(problem)
    return recorder.solution(y, multipliers, below, above, float(objective[0]), status)


def option_values(name: object, value: Any) -> list[str | int | float]:
    """Return a user's option in the types that it may have in IPOPT, the likely type first.

    IPOPT prints a message if an integer is set as a number, or the reverse.
    """
    supported = isinstance(value, (str, bool, np.bool_, int, np.integer, float, np.floating))
    supported = supported and not isinstance(value, np.timedelta64)  # for NumPy an integer
    if not isinstance(name, str) or not supported or value != value:
        raise TypeError(
            "`options` must hold numbers, strings, True or False by names of options of IPOPT, got "
            f"{shown(name)}: {shown(value)}."
        )
    if isinstance(value, str):
        return [str(value)]  # of NumPy's too
    if isinstance(value, (bool, np.bool_)):
        return ["yes" if value else "no"]
    forms: list[str | int | float] = []
    with suppress(OverflowError):  # no float is as large, and no option
        forms.append(float(value))
    if -(2**31) <= value < 2**31 and value == int(value):  # C's has 32 bits
        is_integer = name in _INTEGER_OPTIONS.split() or name.startswith(_LINEAR)
        forms.insert(0 if is_integer else 1, int(value))
    return forms


def _set_option(lib: ctypes.CDLL, problem: c_void_p, name: str, value: object) -> None:
    add = {str: lib.AddIpoptStrOption, int: lib.AddIpoptIntOption, float: lib.AddIpoptNumOption}
    for form in option_values(name, value):
        encoded = form.encode(errors="replace") if isinstance(form, str) else form
        if add[type(form)](problem, name.encode(errors="replace"), encoded):
            return
    raise ValueError(
        f"`options` has {name!r}: {value!r}, which IPOPT does not know as an option, or not as "
        "a value of it. See its list of options, https://coin-or.github.io/Ipopt/OPTIONS.html."
    )
