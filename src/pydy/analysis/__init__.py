"""Results of analyses: equilibria, periodic motions, linear models, sweeps, gradients and fits.

`System.find_equilibrium`, `System.linearize`, `System.eigenvalues` and related methods return them.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pydy.analysis.adjoint import AdjointGradient
    from pydy.analysis.continuation import EquilibriumBranch, SpecialPoint
    from pydy.analysis.equilibria import Equilibrium
    from pydy.analysis.fits.result import FitResult
    from pydy.analysis.fits.trial import Trial
    from pydy.analysis.linear import LinearModel
    from pydy.analysis.orbits import PeriodicOrbit
    from pydy.analysis.sweeps import Crossing, EigenvalueSweep

__all__ = [
    "AdjointGradient",
    "Crossing",
    "EigenvalueSweep",
    "Equilibrium",
    "EquilibriumBranch",
    "FitResult",
    "LinearModel",
    "PeriodicOrbit",
    "SpecialPoint",
    "Trial",
]

# Modules are imported when a name of theirs is first used: those that integrate load SymPy.
_MODULES = {
    "AdjointGradient": "adjoint",
    "Crossing": "sweeps",
    "EigenvalueSweep": "sweeps",
    "Equilibrium": "equilibria",
    "EquilibriumBranch": "continuation",
    "FitResult": "fits.result",
    "LinearModel": "linear",
    "PeriodicOrbit": "orbits",
    "SpecialPoint": "continuation",
    "Trial": "fits.trial",
}


def __getattr__(name: str) -> Any:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = getattr(import_module(f"{__name__}.{_MODULES[name]}"), name)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted(__all__)
