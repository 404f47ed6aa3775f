from .assumption_checks import (
    AssumptionChecks as AssumptionChecks,
    warn_of_contradictions as warn_of_contradictions,
)
from .call_arguments import CallArguments as CallArguments, read_times as read_times
from .definition import (
    SymbolSet as SymbolSet,
    check_forces as check_forces,
    check_times as check_times,
    read_term as read_term,
    sort_out as sort_out,
)
from .energy import Energy as Energy, EnergyModel as EnergyModel, check_potential as check_potential
from .model import Model as Model, ModelBuilder as ModelBuilder
from .problem import (
    Problem as Problem,
    evaluate_specifieds as evaluate_specifieds,
    problem_of as problem_of,
    redefined as redefined,
    with_settings as with_settings,
)
from .residuals import solved_residuals as solved_residuals, with_unknowns as with_unknowns
from .scene import make_scene as make_scene
from .settings import (
    Settings as Settings,
    read_numbers as read_numbers,
)
from .specifieds import checked_plan as checked_plan
from .state_samples import StateSamples as StateSamples
from .trajectory_model import TrajectoryModel as TrajectoryModel
from .tuning import FIT as FIT, TOGETHER as TOGETHER
from .undefined import first_undefined as first_undefined
