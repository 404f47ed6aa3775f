"""Programs as machine code: LLVM IR written as text, compiled, kept, linked."""

from importlib.util import find_spec

if find_spec("llvmlite") is None:
    raise ModuleNotFoundError(
        "Compiled code needs llvmlite, which is not installed: `pip install llvmlite`. Without it "
        "the equations are evaluated with NumPy and integrated with SciPy (leave `generator` out, "
        "and set system.ode_solver = 'DOP853'). Native solvers, and with them events, projection, "
        "ensembles, adjoint gradients, periodic orbits and optimal control, do not work without.",
        name="llvmlite",
    )
