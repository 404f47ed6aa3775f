from .arguments import (
    OfTime as OfTime,
    SpecifiedsPlan as SpecifiedsPlan,
    checked_expression as checked_expression,
    one_format as one_format,
    symbolic_entries as symbolic_entries,
    without as without,
)
from .ode_function_generators import make_function as make_function
from .right_hand_side import (
    RightHandSide as RightHandSide,
    make_backend as make_backend,
    rates_function as rates_function,
)
