"""The package's own exceptions and warnings.

Each one subclasses the built-in that a caller would catch, so that ``except ValueError`` keeps
working in scripts that never heard of this module.
"""

from __future__ import annotations

import numpy as np

__all__ = [
    "GeneratorError",
    "MissingDependencyError",
    "PyDyUserWarning",
    "SingularMatrixError",
    "UnsupportedFunctionError",
]


class PyDyUserWarning(UserWarning):
    """Every warning that this package gives to a user is one of these."""


class SingularMatrixError(np.linalg.LinAlgError):
    """A linear solve inside the equations met a singular matrix.

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

    def __reduce__(self) -> tuple[object, ...]:
        return (type(self), (str(self), self.time, self.state))


class UnsupportedFunctionError(NotImplementedError):
    """An expression holds a function that cannot be translated to numbers."""


class GeneratorError(RuntimeError):
    """A code generator could not build the equations: a compiler is missing or it failed."""


class MissingDependencyError(GeneratorError, ImportError):
    """A code generator needs a package that is not installed."""
