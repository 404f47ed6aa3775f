"""Functions of Python whose code is ours."""

import gc
from weakref import ref

import numpy as np

from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import Source
from pydy._backends.llvm.native import Gate

# Returns the first argument, with one more reference to it.
TEXT = """
declare void @Py_IncRef(ptr)

define ptr @first(ptr %self, ptr %args, i64 %count) nounwind {
  %it = load ptr, ptr %args
  call void @Py_IncRef(ptr %it)
  ret ptr %it
}
"""


def test_a_function_keeps_its_machine_code():
    """Two threads that make the same gate at once keep one of them, and a function of each."""
    source = Source("gate of the tests", lambda: TEXT, ("first",))
    code = jit.load(source)
    gate, left = Gate(b"first", code, "first"), ref(code)
    function = gate.function(np.zeros(1))
    del gate, code
    gc.collect()
    assert left() is not None
    assert function("this") == "this"
    del function
    gc.collect()
    assert left() is None
