from .interpret import run as run, solver_sources as solver_sources
from .nodes import Evaluator as Evaluator, Nodes as Nodes
from .of_scipy import ScipyOperation as ScipyOperation
from .operations import (
    OPERATIONS as OPERATIONS,
    Args as Args,
    Operation as Operation,
    constraint_mark as constraint_mark,
    is_constrained as is_constrained,
    symmetric as symmetric,
)
from .program import Program as Program, Tape as Tape
from .serialization import (
    program_from_bytes as program_from_bytes,
    program_to_bytes as program_to_bytes,
)
from .switch_times import SwitchTimes as SwitchTimes
from .tangent import Part as Part, Tangent as Tangent
from .tuning import numbered as numbered
