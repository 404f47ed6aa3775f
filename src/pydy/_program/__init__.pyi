from .interpret import (
    constrained_sample as constrained_sample,
    evaluator as evaluator,
    run as run,
    singular as singular,
)
from .nodes import Nodes as Nodes
from .of_scipy import (
    KNOWN as KNOWN,
    check as check,
    operation_of as operation_of,
    remember as remember,
)
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
    named_in_sympy as named_in_sympy,
    operands as operands,
    symmetric as symmetric,
    with_operands as with_operands,
)
from .program import NEVER_PUT_OFF as NEVER_PUT_OFF, Program as Program, Tape as Tape
from .tangent import Part as Part, Tangent as Tangent, program_from_bytes as program_from_bytes
from .tuning import (
    INDEPENDENT as INDEPENDENT,
    REDUNDANT as REDUNDANT,
    SINGULAR as SINGULAR,
    numbered as numbered,
)
