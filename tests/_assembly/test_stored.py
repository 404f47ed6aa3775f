"""What one process has simplified and compiled, the next one loads."""

import json
import subprocess
import sys
from dataclasses import replace

import sympy as sm

import zoo
from graphs import P, T, X, program_of
from pydy._assembly import program_cache
from pydy._assembly.program_cache import fingerprint
from pydy._assembly.programs import block_program, jacobian_program
from pydy._assembly.system import Form, assemble_form
from pydy._graph import passes
from pydy._program.operations import OPERATIONS
from pydy._program.serialization import program_from_bytes, program_to_bytes

SCRIPT = """
import json
import numpy as np
from sympy.physics.mechanics.models import n_link_pendulum_on_cart
from pydy._assembly import assembly, programs
from pydy._backends.llvm import compiling
from pydy.system import System

counts = {"simplified": 0, "compiled": 0}

def counted(module, name, kind):
    function = getattr(module, name)
    def wrapper(*args, **kwargs):
        counts[kind] += 1
        return function(*args, **kwargs)
    setattr(module, name, wrapper)

counted(assembly, "simplify", "simplified")
counted(programs, "simplify", "simplified")
counted(compiling, "_emitter", "compiled")
system = System(n_link_pendulum_on_cart(12, cart_force=False))
x = np.linspace(-1.0, 1.0, 26)
rates = system.evaluate_ode(x)
jacobian = system.evaluate_jacobian(x)
assert all(kernel.addresses[0] for kernel in system.model._kernels.values())
print(json.dumps([counts, rates.tolist(), jacobian.tolist()]))
"""


def run(folder, monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", str(folder))
    out = subprocess.run([sys.executable, "-c", SCRIPT], capture_output=True, text=True, check=True)
    return json.loads(out.stdout)


def test_a_second_process_neither_simplifies_nor_compiles(tmp_path, monkeypatch):
    first, *values = run(tmp_path, monkeypatch)
    assert first["simplified"] == 1  # for the rates and their Jacobian: none was counted before
    assert first["compiled"] >= 2
    second, *again = run(tmp_path, monkeypatch)
    assert second == {"simplified": 0, "compiled": 0}
    assert again == values


def test_a_program_comes_back_from_bytes_as_it_was():
    x, y, z, _ = X
    program = program_of([x * sm.sin(y) + P[0] * z, sm.Piecewise((x, x > y), (y, True))])
    found = program_from_bytes(program_to_bytes(program))
    assert found.digest == program.digest
    assert found.setup == program.setup
    assert found.carried == program.carried


def assembly():
    pendulum = zoo.pendulum()
    q, u = list(pendulum.kane.q), list(pendulum.kane.u)
    matrix, forcing = pendulum.kane.mass_matrix, pendulum.kane.forcing
    known = pendulum.kane.kindiffdict()
    constants = sorted(pendulum.constants, key=sm.default_sort_key)
    specifieds = sorted(pendulum.specifieds, key=sm.default_sort_key)
    t = sm.physics.mechanics.dynamicsymbols._t
    rates = [known[c.diff(t)] for c in q]
    return assemble_form(Form(list(forcing), q, u, constants, specifieds, t, matrix, rates))


def test_a_program_does_not_depend_on_which_others_were_made_before():
    one, two = assembly(), assembly()
    block_program(two, "forcing")
    jacobian_program(two, "rates", "x")
    assert block_program(one, "rates").digest == block_program(two, "rates").digest
    assert fingerprint(one) == fingerprint(two)


def test_a_pass_of_somebody_else_is_never_passed_over(tmp_path, monkeypatch):
    """It may be another function today than when the Program was stored."""
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(program_cache, "_WORTH_STORING", 0)
    assembly = assemble_form(Form([X[0] * P[0]], [X[0]], [], P, [], T))

    def made():
        calls.append(True)
        return block_program(assembly, "rates")

    def own(graph, roots):
        return list(roots)

    calls = []
    for expected in (1, 1):  # found the second time
        program_cache.stored_program(assembly, "rates", made)
        assert len(calls) == expected
    monkeypatch.setattr(passes, "ROUND", [*passes.ROUND, ("own", own)])
    for expected in (2, 3):
        program_cache.stored_program(assembly, "rates", made)
        assert len(calls) == expected


def test_code_is_stored_under_what_the_table_says_of_its_operations(monkeypatch):
    before = program_of([sm.tan(X[0])]).digest
    row = replace(OPERATIONS["tan"], llvm="libm tan_of_another_library")
    monkeypatch.setitem(OPERATIONS, "tan", row)
    assert program_of([sm.tan(X[0])]).digest != before
