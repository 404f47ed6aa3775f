from .adjoint import adjoints as adjoints
from .branches import sides as sides, switches as switches
from .columns import Columns as Columns, Direction as Direction
from .derivative import (
    Row as Row,
    Rows as Rows,
    dense as dense,
    dense_jacobian as dense_jacobian,
    dense_rows as dense_rows,
    directional as directional,
    hessian as hessian,
    jacobian as jacobian,
    jacobian_rows as jacobian_rows,
)
from .from_sympy import (
    NodeExpression as NodeExpression,
    SymPyReader as SymPyReader,
    differentiated as differentiated,
    is_unevaluated as is_unevaluated,
)
from .identities import signatures as signatures, vanish as vanish
from .lowering import lower as lower
from .node import Graph as Graph, input_nodes as input_nodes, input_symbols as input_symbols
from .passes import ONCE as ONCE, ROUND as ROUND, rewriting as rewriting
from .passes.factor import factor_sums as factor_sums
from .products import derivative_program as derivative_program
from .reachability import reach as reach
from .rewrite import substitute as substitute, transplanted as transplanted
from .rounding import (
    per_unit as per_unit,
    rounding_bounds as rounding_bounds,
    sizes_of_terms as sizes_of_terms,
)
from .simplification import operation_count as operation_count, simplify as simplify
from .solve.choose import (
    difference_basis as difference_basis,
    solve_accelerations as solve_accelerations,
)
from .solve.ldl import elimination_order as elimination_order
from .tangent import jacobian_tangent as jacobian_tangent, worthwhile_parts as worthwhile_parts
from .time_switches import SwitchTimes as SwitchTimes, TimeSwitches as TimeSwitches
