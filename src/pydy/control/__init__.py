"""Optimal control by direct collocation: motions that minimise an objective.

`OptimalControl` states a problem, and `System.optimize_trajectory` solves one in a single call.
"""

from pydy.control.phases import PhasedTrajectory, Phases
from pydy.control.problem import OptimalControl
from pydy.control.result import OptimalTrajectory

__all__ = ["OptimalControl", "OptimalTrajectory", "PhasedTrajectory", "Phases"]
