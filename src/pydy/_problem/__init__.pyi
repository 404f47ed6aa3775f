from .definition import (
    DefinitionBuilder as DefinitionBuilder,
    SymbolSet as SymbolSet,
    base_symbols as base_symbols,
    check_forces as check_forces,
    check_times as check_times,
    read_term as read_term,
    refuse_descending as refuse_descending,
    sort_out as sort_out,
)
from .energy import Energy as Energy, EnergyModel as EnergyModel, check_potential as check_potential
from .model import Model as Model, compile_definition as compile_definition
from .problem import (
    At as At,
    Problem as Problem,
    check_specifieds as check_specifieds,
    checked_plan as checked_plan,
    read_numbers as read_numbers,
    samples as samples,
    solved_residuals as solved_residuals,
)
from .scene import make_scene as make_scene
from .tuning import FIT as FIT, TOGETHER as TOGETHER, TYPED as TYPED
from .undefined import first_undefined as first_undefined
