from .assembly import Assembly as Assembly
from .assumptions import Assumptions as Assumptions, errors_of as errors_of
from .baumgarte import stabilised as stabilised
from .definition import (
    Definition as Definition,
    Layout as Layout,
    Outputs as Outputs,
    lower_derivatives as lower_derivatives,
)
from .linear_solver import (
    resolve_solver as resolve_solver,
    solve_symbolically as solve_symbolically,
)
from .mechanical_blocks import (
    constraints_with_redundant as constraints_with_redundant,
    kinetic_hessian as kinetic_hessian,
)
from .model import (
    CompiledModel as CompiledModel,
    singular_mass_matrix as singular_mass_matrix,
)
from .program_cache import stored as stored, stored_program as stored_program
from .programs import (
    every_input as every_input,
    expression_program as expression_program,
    lower_nodes as lower_nodes,
)
from .specifieds import (
    Plan as Plan,
    check_expressions as check_expressions,
    differentiated as differentiated,
    followed as followed,
    with_compiled_inputs as with_compiled_inputs,
)
from .system import (
    Form as Form,
    Group as Group,
    assemble_form as assemble_form,
    assemble_system as assemble_system,
    auxiliary_groups as auxiliary_groups,
    check_accelerations as check_accelerations,
)
