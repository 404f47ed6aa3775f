"""Results of analyses: equilibria, periodic motions, linear models, sweeps, gradients and fits.

`System.find_equilibrium`, `System.linearize`, `System.eigenvalues` and related methods return them.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
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

__dir__ = __all__.copy  # the stub lists what other rooms take, too
