from .base import arguments_fit as arguments_fit
from .c.source import HELPERS as HELPERS, c_functions as c_functions
from .llvm.compiling import Shipped as Shipped
from .llvm.jit import Code as Code, load as load
from .llvm.native import (
    LLVMBackend as LLVMBackend,
    gates as gates,
    nlp_functions as nlp_functions,
    sweep_by_columns as sweep_by_columns,
)
from .registry import (
    compile_program as compile_program,
    compiled_by as compiled_by,
    refusal as refusal,
    resolve as resolve,
)
from .writer import (
    Dialect as Dialect,
    RepeatedLine as RepeatedLine,
    Template as Template,
    Writer as Writer,
    stages as stages,
)
