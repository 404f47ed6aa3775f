from .adjoint import adjoints as adjoints
from .branches import sides as sides, switches as switches
from .collector import collector_paused as collector_paused
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
from .interpret import (
    constrained_sample as constrained_sample,
    evaluator as evaluator,
    run as run,
    singular as singular,
)
from .lowering import lower as lower
from .modular import PRIME as PRIME, inverse as inverse
from .node import Graph as Graph, input_nodes as input_nodes, input_symbols as input_symbols
from .of_scipy import KNOWN as KNOWN, check as check, remember as remember
from .operations import (
    ANGLES as ANGLES,
    FLAT as FLAT,
    OPERATIONS as OPERATIONS,
    SHIPPED as SHIPPED,
    SOLVES as SOLVES,
    TRUTHS as TRUTHS,
    Operation as Operation,
    is_constrained as is_constrained,
    is_symmetric as is_symmetric,
    operands as operands,
    with_operands as with_operands,
)
from .passes import ONCE as ONCE, ROUND as ROUND, rewriting as rewriting
from .passes.factor import factor_sums as factor_sums
from .products import derivative_program as derivative_program
from .program import Program as Program, Tape as Tape
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
from .tangent import (
    Part as Part,
    Tangent as Tangent,
    jacobian_tangent as jacobian_tangent,
    program_from_bytes as program_from_bytes,
    worthwhile_parts as worthwhile_parts,
)
from .time_switches import SwitchTimes as SwitchTimes, TimeSwitches as TimeSwitches
from .tuning import (
    INDEPENDENT as INDEPENDENT,
    REDUNDANT as REDUNDANT,
    SINGULAR as SINGULAR,
    numbered as numbered,
)
