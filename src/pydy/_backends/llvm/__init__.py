"""Programs as machine code: LLVM IR written as text, compiled, kept, linked."""

from importlib.util import find_spec

if find_spec("llvmlite") is None:
    raise ModuleNotFoundError(
        "Compiled code needs llvmlite, which is not installed. NumPy and SciPy work without it: "
        "leave `generator` out, and choose a solver of SciPy's, as system.ode_solver = 'DOP853'.",
        name="llvmlite",
    )
