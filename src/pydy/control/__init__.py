"""Optimal control by direct collocation: motions that minimise an objective.

`OptimalControl` states a problem, and `System.optimize_trajectory` solves one in a single call.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__ = [
    "OptimalControl",
    "OptimalTrajectory",
    "PhasedTrajectory",
    "Phases",
]

__dir__ = __all__.copy  # the stub lists what other rooms take, too
