from .compiled_events import CompiledEvents as CompiledEvents, EventTraits as EventTraits
from .constraint_drift import (
    ConstraintResiduals as ConstraintResiduals,
    DriftCheck as DriftCheck,
    DriftReport as DriftReport,
)
from .constraints import (
    CompiledConstraints as CompiledConstraints,
    ConstraintSizes as ConstraintSizes,
)
from .core.declarations import (
    native_constants as native_constants,
    portable_sources as portable_sources,
)
from .events import Event as Event, Turn as Turn
from .options import (
    EventContinuation as EventContinuation,
    Options as Options,
    SolverOptions as SolverOptions,
    StepOptions as StepOptions,
    read_options as read_options,
)
from .outcome import Outcome as Outcome
from .run.backward import DiscreteAdjoint as DiscreteAdjoint
from .run.integration import Integration as Integration
from .run.lanes import LaneSolver as LaneSolver, LaneTasks as LaneTasks
from .run.problem import sampled_input_tables as sampled_input_tables
from .run.recorded_steps import RecordedSteps as RecordedSteps
from .sensitivities import (
    CompiledSensitivities as CompiledSensitivities,
    ParameterSize as ParameterSize,
)
from .solver import (
    SOLVERS as SOLVERS,
    Prepared as Prepared,
    Solver as Solver,
    dop853 as dop853,
    radau as radau,
    rk4 as rk4,
    tsit5 as tsit5,
    vern9 as vern9,
)
from .tableaus import Tableau as Tableau, method_arrays as method_arrays, tableau_of as tableau_of
from .tuning import NO_LATER as NO_LATER
