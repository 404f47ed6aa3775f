"""Results of analyses: equilibria, periodic motions, linear models, sweeps, gradients and fits.

`System.find_equilibrium`, `System.linearize`, `System.eigenvalues` and related methods return them.
"""

from pydy.analysis.adjoint import AdjointGradient
from pydy.analysis.continuation import EquilibriumBranch, SpecialPoint
from pydy.analysis.equilibria import Equilibrium
from pydy.analysis.fit import FitResult
from pydy.analysis.linear import LinearModel
from pydy.analysis.orbits import PeriodicOrbit
from pydy.analysis.sweeps import Crossing, EigenvalueSweep
from pydy.analysis.trial import Trial

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
