from .identification import Experiment as Experiment, Identification as Identification
from .phases import PhasedTrajectory as PhasedTrajectory, Phases as Phases
from .problem import OptimalControl as OptimalControl
from .result import OptimalTrajectory as OptimalTrajectory
from .solvers import fitting_solver_of as fitting_solver_of
