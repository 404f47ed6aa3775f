"""Back ends by name; what stands in where LLVM is missing, as in a browser."""

import json
import pickle
import subprocess
import sys
from functools import partial

import numpy as np

from pydy._assembly.programs import block_program
from pydy._backends.base import kernel_of
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.registry import compiled_by
from pydy._program import Tangent, run
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart

# `None` makes every import of the module fail, as if it were not installed.
WITHOUT = """
import json, pickle, sys, warnings
import numpy as np
sys.modules["llvmlite"] = None
from pydy.models import multi_mass_spring_damper
system = multi_mass_spring_damper()
system.initial_conditions, system.times = {"x0": 1.0}, [0.0, 0.5, 1.0]
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    system.ode_solver = "DOP853"
    states = system.integrate(rtol=1e-10, atol=1e-10)
    energy = system.simulate(rtol=1e-10, atol=1e-10).energy
    system.linearize()
    system.generate_ode_function(generator="llvm", lanes=1)
    kernel = pickle.loads(LLVM_KERNEL)
    value = kernel.evaluate(*[np.array(a) for a in ARGUMENTS])[0].tolist()
system.ode_solver = "dop853"
errors = []
for attempt in (
    system.integrate,
    lambda: system.integrate_ensemble(constants={"k0": [1.0, 2.0]}),
    lambda: system.adjoint_gradient("constants", final="x0"),
):
    try:
        attempt()
    except ModuleNotFoundError as error:
        errors.append(str(error))
words = [str(w.message) for w in caught]
print(json.dumps([states.tolist(), energy.tolist(), words, errors, value]))
"""


def test_numpy_and_scipy_stand_in_for_llvm_and_say_so_once():
    program = block_program(multi_mass_spring_damper().model.assembly, "rates")
    kernel = LLVMBackend(lanes=1).compile(program)
    arguments = [[0.0], [[0.3, 0.1]], [[]], [1.0, 2.0, 3.0]]
    script = f"LLVM_KERNEL, ARGUMENTS = {pickle.dumps(kernel)!r}, {arguments!r}\n{WITHOUT}"
    done = subprocess.run(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, check=True, timeout=120
    )
    states, energy, warned, errors, value = json.loads(done.stdout)
    known = kernel.evaluate(*[np.array(a) for a in arguments])[0]
    np.testing.assert_allclose(value, known, rtol=1e-14)
    system = multi_mass_spring_damper()
    system.initial_conditions, system.times = {"x0": 1.0}, [0.0, 0.5, 1.0]
    system.ode_solver = "DOP853"
    known = system.simulate(rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(states, known.states, rtol=0, atol=1e-12)
    np.testing.assert_allclose(energy, known.energy, rtol=0, atol=1e-12)
    assert len(warned) == 1
    assert warned[0].startswith("llvmlite is not installed: NumPy evaluates the equations")
    assert len(errors) == 3
    for error in errors:
        assert "`pip install llvmlite`" in error
        assert "adjoint gradients" in error
        assert "ode_solver = 'DOP853'" in error


def test_a_back_end_in_python_may_take_tangents():
    """Its sweep takes no array to write to, as native ones do."""

    class Interpreter:
        tangents = True

        def compile(self, program):
            plain = program.written_out() if isinstance(program, Tangent) else program
            return kernel_of(plain, partial(run, plain), Interpreter, {})

    programs = n_link_pendulum_on_cart(4).model.programs
    tangent = programs.jacobian_in_parts("rates", "x")
    assert isinstance(tangent, Tangent)
    n, s, k = tangent.signature.sizes
    x = np.random.default_rng(0).uniform(0.2, 0.9, (3, n))
    arguments = np.zeros(3), x, np.zeros((1, s)), np.ones(k)
    found, failed = compiled_by(Interpreter(), tangent).evaluate(*arguments)
    expected, _ = compiled_by(LLVMBackend(), programs.jacobian("rates", "x")).evaluate(*arguments)
    assert not failed.any()
    np.testing.assert_allclose(found[:, -expected.shape[1] :], expected, rtol=1e-12)
