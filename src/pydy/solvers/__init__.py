"""Integration in machine code: solvers that call a compiled right-hand side by its address.

=============  ===============================================================================
`dop853`       explicit, order 8: the first choice for smooth motion at tolerances below 1e-6
`tsit5`        explicit, order 5: for loose tolerances and frequent events
`vern9`        explicit, order 9: for tolerances near rounding
`rk4`          explicit, order 4, in steps of fixed size
`radau`        implicit, order 5: for stiff systems
=============  ===============================================================================

They have the signature of `scipy.integrate.odeint`; select one by ``system.ode_solver = 'dop853'``.
Their loops are compiled for the processor when one of them first runs.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__ = [
    "Event",
    "Prepared",
    "Solver",
    "SolverOptions",
    "StepOptions",
    "Tableau",
    "dop853",
    "radau",
    "rk4",
    "tsit5",
    "vern9",
]

__dir__ = __all__.copy  # the stub lists what other rooms take, too
