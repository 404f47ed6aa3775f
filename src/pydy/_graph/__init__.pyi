from .adjoint import adjoints as adjoints
from .branches import Branches as Branches
from .columns import (
    SensitivityColumns as SensitivityColumns,
    SensitivityDirection as SensitivityDirection,
)
from .derivative import (
    DerivativeRows as DerivativeRows,
    directional as directional,
    hessian as hessian,
    jacobian as jacobian,
)
from .from_sympy import NodeExpression as NodeExpression, SymPyReader as SymPyReader
from .identities import signatures as signatures
from .inputs import inputs_of as inputs_of
from .linear_system import LinearSystem as LinearSystem
from .lowering import lower as lower
from .node import Graph as Graph
from .passes import passes_are_shipped as passes_are_shipped, rewriting as rewriting
from .passes.factor import factor_sums as factor_sums
from .products import derivative_program as derivative_program
from .reachability import reach as reach
from .rewrite import substitute as substitute
from .rounding import (
    per_unit as per_unit,
    rounding_bounds as rounding_bounds,
    sizes_of_terms as sizes_of_terms,
)
from .simplification import operation_count as operation_count, simplify as simplify
from .solve.ldl import elimination_order as elimination_order
from .tangent import jacobian_tangent as jacobian_tangent
from .terms import linear_terms as linear_terms
from .time_switches import TimeSwitches as TimeSwitches
