from .adjoint import (
    AdjointGradient as AdjointGradient,
    adjoint_gradient as adjoint_gradient,
    explicit_solver as explicit_solver,
    motion_and_gradient as motion_and_gradient,
)
from .adjoint_segment import AdjointSegment as AdjointSegment
from .continuation import EquilibriumBranch as EquilibriumBranch, SpecialPoint as SpecialPoint
from .equilibria import Equilibrium as Equilibrium
from .equilibrium_residual import find_equilibrium as find_equilibrium
from .families import eigenvalues as eigenvalues, follow_equilibria as follow_equilibria
from .fits.fit import fit as fit
from .fits.problem import FittedSystem as FittedSystem
from .fits.result import FitResult as FitResult
from .fits.trial import Trial as Trial
from .linear import LinearModel as LinearModel, linearize as linearize
from .orbits import PeriodicOrbit as PeriodicOrbit, find_periodic_orbit as find_periodic_orbit
from .sweeps import Crossing as Crossing, EigenvalueSweep as EigenvalueSweep
