"""The package's own exceptions and warnings.

Each one subclasses the built-in that a caller would catch, so that ``except ValueError`` keeps
working in scripts that do not know this module.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Sequence
from inspect import signature
from typing import Any

import numpy as np

from pydy._names import counted, few


class PyDyUserWarning(UserWarning):
    """Base class of all warnings that this package gives to users."""


def warn_user(message: str) -> None:
    """Issue a warning that points at the line of user code that called this package."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and _is_internal(frame.f_globals.get("__name__", "")):
        level, frame = level + 1, frame.f_back
    warnings.warn(message, PyDyUserWarning, stacklevel=level)


_AROUND = ("contextlib", "functools")  # of decorators


def _is_internal(module: str) -> bool:
    """Return whether a module is part of this package, or of a decorator around its functions."""
    return module.startswith("pydy.") or module in _AROUND or module.endswith("._ufunc_config")


def warn_not_finite(
    wrong: np.ndarray,
    names: Sequence[str],
    describe_sample: Callable[[int], tuple[str, str | None]],
) -> None:
    """Warn of named values that are not finite (`wrong`, (m, o)) although their inputs are.

    `describe_sample` returns a sample's position, and the singularity there if it is known.
    """
    bad = np.flatnonzero(wrong.any(axis=1))
    if bad.size:
        rows = [name for name, flag in zip(names, wrong[bad[0]], strict=True) if flag]
        others_text = (
            f"; the same at {counted(bad.size - 1, 'other sample')}" if bad.size > 1 else ""
        )
        position, why = describe_sample(int(bad[0]))
        why = why or "Look for a division by zero, or a function outside its domain."
        warn_user(
            f"These values are not finite: {few(rows, 4, ', ')} at {position}{others_text}. {why}"
        )


def note_finished(error: MemoryError, results_text: str, **finished: object) -> None:
    """Attach finished results to an error as attributes, and add a note with their names."""
    vars(error).update(finished)
    error.add_note(f"{results_text} in the attributes of this error: {', '.join(finished)}.")


def finished_before(
    stop: BaseException, finished: str, message: str, results: object
) -> BaseException:
    """Return the error to raise after Ctrl-C or lack of memory stopped an analysis.

    This is an `AnalysisInterrupted`, or the MemoryError with a note about the `finished` results.
    """
    if isinstance(stop, MemoryError):
        note_finished(stop, finished, results=results)
        return stop
    return AnalysisInterrupted(message, results)


class _Pickled(BaseException):
    """An exception that pickles as its message and attributes."""

    def __reduce__(self) -> tuple[object, ...]:
        _, *names = signature(type(self)).parameters
        return type(self), (str(self), *(getattr(self, name) for name in names))


class SingularMatrixError(_Pickled, np.linalg.LinAlgError):
    """A linear solve inside the equations encountered a singular matrix.

    Attributes
    ----------
    time : float
        Where it happened.
    state : numpy.ndarray, shape (n,)
        The state at which the equations were evaluated.
    """

    def __init__(self, message: str, time: float, state: np.ndarray) -> None:
        super().__init__(message)
        self.time = time
        self.state = state


class UnsupportedFunctionError(NotImplementedError):
    """An expression contains a function that has no numerical translation."""


class GeneratorError(RuntimeError):
    """A code generator could not build the equations: a compiler is missing or failed."""


class MissingDependencyError(GeneratorError, ImportError):
    """A code generator needs a package that is not installed."""


class _Partial(_Pickled):
    """The results of an integration up to where it stopped."""

    def __init__(
        self,
        message: str,
        times: np.ndarray,
        states: np.ndarray,
        time: float,
        state: np.ndarray,
        info: dict[str, Any],
    ) -> None:
        super().__init__(message)
        self.times = times
        self.states = states
        self.time = time
        self.state = state
        self.info = info
        self.motion: Any = None  # a `pydy._motion.motion.Motion`

    @property
    def trajectory(self) -> Any:
        """The results so far with names, outputs and energies, as a Trajectory.

        None where a solver was called by itself, where contacts failed before they moved, and for
        copies of the error.
        """
        return None if self.motion is None else self.motion.trajectory


class IntegrationError(_Partial, RuntimeError):
    """An integration could not continue. The exception contains the results so far.

    Attributes
    ----------
    times : numpy.ndarray, shape (m,)
        The requested times that were reached.
    states : numpy.ndarray, shape (m, n)
        The states at these times.
    time : float
        Where it stopped.
    state : numpy.ndarray, shape (n,)
        The state there.
    info : dict
        What ``full_output=True`` would have returned.
    """


class ContactError(IntegrationError):
    """No combination of the modes of the exact contacts satisfies the equations.

    The message names the reason, such as Painlevé's paradox or jamming. `info` has ``'modes'``, the
    modes of the contacts before.
    """


class IntegrationInterrupted(_Partial, KeyboardInterrupt):
    """The user interrupted an integration. The exception contains the results so far.

    A `KeyboardInterrupt`, so that no ``except Exception`` swallows it, with the attributes of
    `IntegrationError`.
    """


class _Interrupted(_Pickled, KeyboardInterrupt):
    """Base class of interrupts by the user; `results` holds the results so far."""

    def __init__(self, message: str, results: object) -> None:
        super().__init__(message)
        self.results = results


class AnalysisInterrupted(_Interrupted):
    """The user interrupted an analysis of a System. What was found so far is here.

    A `KeyboardInterrupt`, so that no ``except Exception`` swallows it.

    Attributes
    ----------
    results : EquilibriumBranch, EigenvalueSweep, dict or OptimalTrajectory
        Of `follow_equilibria`, the branch up to where it was, with `ended` equal to
        ``'interrupted'``; of `eigenvalues`, the sweep over the first values, whose eigenvalues are
        computed when they are first asked for; of `find_periodic_orbit`, the ``'period'`` and the
        ``'initial_conditions'`` of the motion that came nearest to an orbit, to start from again;
        of `optimize_trajectory`, the OptimalTrajectory of the latest iteration.
    """


class FitInterrupted(_Pickled, KeyboardInterrupt):
    """The user interrupted a fit. The exception contains the best estimates so far.

    A `KeyboardInterrupt`, so that no ``except Exception`` swallows it.

    Attributes
    ----------
    values : dict of str to float
        The parameters by name.
    """

    def __init__(self, message: str, values: dict[str, float]) -> None:
        super().__init__(message)
        self.values = values


class EnsembleInterrupted(_Interrupted):
    """The user interrupted an ensemble. The exception contains the finished samples.

    A `KeyboardInterrupt`, so that no ``except Exception`` swallows it.

    Attributes
    ----------
    results : xarray.Dataset
        What the ensemble would have returned. Unfinished samples have the status −1 and no values.
    """


class _SearchError(_Pickled, RuntimeError):
    """A search found nothing; it ended at `values` of its unknowns, with these `residuals`."""

    def __init__(self, message: str, values: np.ndarray, residuals: np.ndarray) -> None:
        super().__init__(message)
        self.values = values
        self.residuals = residuals


class PeriodicOrbitError(_SearchError):
    """No periodic orbit was found. The exception contains the point where the search ended.

    Attributes
    ----------
    values : numpy.ndarray, shape (k,)
        The unknown states at the start of the period.
    residuals : numpy.ndarray, shape (k,)
        Their changes over the period.
    """


class OptimizationError(_Pickled, RuntimeError):
    """No optimal trajectory was found. The exception contains the motion where the search ended.

    Attributes
    ----------
    trajectory : pydy.control.OptimalTrajectory or None
        Its `message` and `history` say how the search went. None if its duration is zero.
    """

    def __init__(self, message: str, trajectory: object) -> None:
        super().__init__(message)
        self.trajectory = trajectory


class EquilibriumError(_SearchError):
    """No equilibrium was found. The exception contains the point where the search ended.

    Attributes
    ----------
    values : numpy.ndarray, shape (k,)
        Values of the unknowns.
    residuals : numpy.ndarray, shape (m,)
        The residuals there, which should be zero.
    """


class RobotFileError(ValueError):
    """A file does not describe a robot; the message names the file and the line or element."""


class TireFileError(ValueError):
    """A file is no tire property file; the message names the file and the line or unit."""
