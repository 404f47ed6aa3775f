"""Code for other processors than this one: the same bits, and never code that cannot run."""

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).parents[3] / "benchmarks"))

from harness import frozen
from harness.program import assembly_of

from graphs import solve_program
from pydy._assembly.programs import block_program
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.llvm.sources import width_of
from pydy._backends.llvm.targets import TABLE, chosen, registers_for, target
from pydy._backends.llvm.text import kernel_text
from pydy._program import Program, Tape

TESTS = Path(__file__).parents[2]
V3 = {"avx", "avx2", "bmi", "bmi2", "cx16", "f16c", "fma", "lzcnt", "movbe", "popcnt", "sse3"}
V3 |= {"sse4.1", "sse4.2", "ssse3", "sse2"}
V4 = V3 | {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"}
X86 = "x86_64-unknown-linux-gnu"


def test_by_default_it_is_this_machines_processor():
    found = chosen("native", X86, "znver5", V4)
    assert (found.processor, found.registers.count, found.registers.widest) == ("znver5", 32, 8)
    assert "+avx512vl" in found.features


def test_a_level_has_its_own_features_and_registers_whatever_the_machine_has():
    found = chosen("x86-64-v3", X86, "znver5", V4)
    assert (found.processor, found.features) == ("x86-64-v3", "")
    assert (found.registers.doubles, found.registers.widest) == (4, 4)


@pytest.mark.parametrize("name", ["x86-64-v5", "znver5", "Native", "avx2"])
def test_a_target_that_there_is_not_is_refused(name):
    with pytest.raises(ValueError, match=rf"PYDY_CPU is '{name}'.*'native', 'generic'"):
        chosen(name, X86, "znver5", V4)


def test_a_target_that_the_machine_cannot_run_is_refused_with_what_it_lacks():
    with pytest.raises(ValueError, match=r"haswell lacks avx512bw, avx512cd.*'generic'"):
        chosen("x86-64-v4", X86, "haswell", V3)
    with pytest.raises(ValueError, match=r"none of x86-64 \(aarch64-unknown-linux-gnu\)"):
        chosen("x86-64-v3", "aarch64-unknown-linux-gnu", "cortex-a72", {"neon"})


@pytest.mark.parametrize(
    ("features", "machine", "row"),
    [
        (V4, "x86_64", (32, 8, 8)),
        (V3, "x86_64", (16, 4, 4)),
        ({"sse2"}, "x86_64", (16, 2, 2)),
        ({"fp-armv8"}, "aarch64", (32, 2, 4)),
        ((), "arm64", (32, 2, 4)),
        ((), "riscv64", (16, 2, 2)),
    ],
)
def test_registers_follow_from_features(features, machine, row):
    found = registers_for(features, machine)
    assert (found.count, found.doubles, found.widest) == row


def test_registers_hold_a_dozen_values_of_the_widest_code():
    for row in TABLE:
        assert row.count * row.doubles // row.widest >= 15


# -- width ----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def bicycle():
    """A Program that is long, has angles, constants, inputs and a solve with a guard."""
    return block_program(assembly_of(frozen.read("bicycle")), "rates")


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("several", [True, False], ids=["inputs each", "inputs for all"])
def test_lanes_in_turns_give_the_bits_of_one_lane(bicycle, order, several):
    rng = np.random.default_rng(2)
    m = 19
    x = np.asarray(rng.uniform(0.2, 0.9, (m, bicycle.signature.num_states)), order=order)
    r = rng.uniform(-1.0, 1.0, (m if several else 1, bicycle.signature.num_specifieds))
    t, p = rng.uniform(0.0, 1.0, m), rng.uniform(0.5, 1.5, bicycle.signature.num_constants)
    expected, _ = LLVMBackend().compile(bicycle).evaluate(t, np.ascontiguousarray(x), r, p)
    assert np.isfinite(expected).all()
    for lanes, width in [(8, 8), (8, 4), (8, 2), (4, 2)]:
        found, failed = LLVMBackend(lanes=lanes, width=width).compile(bicycle).evaluate(t, x, r, p)
        assert not failed.any()
        np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("width", [2, 4, 8])
def test_lanes_in_turns_tell_each_lane_that_fails(width):
    solve = solve_program(3, "ldl")
    rng = np.random.default_rng(1)
    root = rng.normal(size=(16, 3, 3))
    matrices = root @ root.transpose(0, 2, 1) + np.eye(3)
    matrices[[1, 6, 12]] = 0.0
    x = np.asfortranarray(np.hstack([matrices.reshape(16, 9), rng.normal(size=(16, 3))]))
    kernel = LLVMBackend(lanes=8, width=width).compile(solve)
    out, failed = kernel.evaluate(np.zeros(16), x, np.empty((1, 0)), np.empty(0))
    assert np.flatnonzero(failed).tolist() == [1, 6, 12]
    good = np.setdiff1d(np.arange(16), [1, 6, 12])
    expected = np.linalg.solve(matrices[good], x[good, 9:, None])[:, :, 0]
    np.testing.assert_allclose(out[good], expected, rtol=1e-10)


@pytest.mark.parametrize("width", [1, 3, 16, "4"])
def test_a_width_that_there_is_not_is_refused(width):
    with pytest.raises(ValueError, match=r"`width` is .*2, 4 or 8"):
        LLVMBackend(lanes=8, width=width)
    with pytest.raises(ValueError, match="at most `lanes`"):
        LLVMBackend(lanes=2, width=4)


# -- bits -----------------------------------------------------------------------------------------

BITS = """
import hashlib, sys
import numpy as np
sys.path[:0] = sys.argv[2:]
import zoo
from registry import SOLVER_NAMES, step_options
from zoo.cases import system_of
from harness import frozen
from harness.program import assembly_of
from pydy._assembly.programs import block_program
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.llvm.sources import width_of

def say(what, values):
    print(what, hashlib.sha256(np.ascontiguousarray(values).tobytes()).hexdigest())

for name in ("bicycle", "pendulum-1", "rods-3"):
    program = block_program(assembly_of(frozen.read(name)), "rates")
    rng = np.random.default_rng(1)
    x, t = rng.uniform(0.2, 0.9, (19, program.signature.num_states)), rng.uniform(0.3, 2.0, 19)
    r = rng.uniform(-1.0, 1.0, (19, program.signature.num_specifieds))
    p = rng.uniform(0.5, 1.5, program.signature.num_constants)
    for lanes in (1, 8):
        say(f"{name} {lanes}", LLVMBackend(lanes=lanes).compile(program).evaluate(t, x, r, p)[0])
for name in ("disc",):
    model = zoo.MODELS[name]()
    system = system_of(model, times=np.linspace(0.0, 2.0, 9))
    for solver in SOLVER_NAMES if sys.argv[1] == "all" else ():
        system.ode_solver = solver
        options = step_options(solver, 1e-9, 0.01)
        say(f"{name} {solver}", system.integrate(**options))
"""


def bits(cpu, folder, what):
    environment = {**os.environ, "PYDY_CPU": cpu, "PYDY_CACHE_DIR": str(folder)}
    command = [sys.executable, "-c", BITS, what, str(TESTS), str(TESTS.parent / "benchmarks")]
    done = subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=600, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def native(tmp_path_factory):
    """A folder of code, and the bits of this machine's own."""
    folder = tmp_path_factory.mktemp("code")
    return folder, bits("native", folder, "all")


def test_code_for_processors_with_fused_arithmetic_computes_the_same_bits(native):
    # In one folder: the target is part of the keys, or one would run the other's code.
    folder, own = native
    assert own.count("\n") == 6 + 5
    level = "x86-64-v3" if target().triple.startswith("x86_64") else "generic"
    assert bits(level, folder, "all") == own


def test_kernels_compute_the_same_bits_even_where_arithmetic_is_not_fused(native):
    # LLVM then calls the C library's fma, which rounds once too.
    folder, own = native
    kernels = bits("generic", folder, "kernels")
    assert kernels.count("\n") == 6
    assert own.startswith(kernels)


@pytest.mark.parametrize("angles", [1, 2, 3, 4, 5, 9])
def test_code_for_one_state_has_no_vectors_that_halve_the_ports_for_scalars(angles):
    tape = Tape()
    sines = [tape.make("sin", tape.make("input", "x", k)) for k in range(angles)]
    program = Program.from_tape(tape, (angles, 0, 0), [("v", (angles,), sines)])
    widths = {int(w) for w in re.findall(r"fadd <(\d+) x double>", kernel_text(program, 1))}
    assert widths <= {2, 4}
    assert bool(widths) == (angles > 1)
    x = np.linspace(-2.0, 7.0, 16 * angles).reshape(16, angles)
    arguments = np.zeros(16), x, np.empty((1, 0)), np.empty(0)
    one, _ = LLVMBackend().compile(program).evaluate(*arguments)
    eight, _ = LLVMBackend(lanes=8).compile(program).evaluate(*arguments)
    np.testing.assert_array_equal(one, eight)


def test_a_wrong_target_is_told_where_code_is_first_compiled(tmp_path):
    code = "from pydy.models import n_link_pendulum_on_cart as n; n(1).generate_ode_function()"
    environment = {**os.environ, "PYDY_CPU": "pentium", "PYDY_CACHE_DIR": str(tmp_path)}
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=False
    )
    assert "ValueError: The environment variable PYDY_CPU is 'pentium'" in done.stderr


@pytest.mark.parametrize(
    ("name", "features", "width"),
    [
        ("bicycle", V3, 4),
        ("springs-100-absolute", V3, 8),
        ("springs-100-absolute", V4, 8),
        ("springs-100-absolute", {"sse2"}, 2),
        ("pendulum-1", {"sse2"}, 8),
    ],
)
def test_where_little_is_done_for_each_result_all_lanes_go_at_once(
    monkeypatch, name, features, width
):
    host = chosen("native", X86, "some", features)
    monkeypatch.setattr("pydy._backends.llvm.sources.target", lambda: host)
    program = block_program(assembly_of(frozen.read(name)), "rates")
    assert width_of(program, 8) == width


@pytest.mark.parametrize(("features", "blocks"), [(V3, False), (V4, True), ({"sse2"}, True)])
def test_with_few_registers_a_model_is_one_basic_block_and_llvm_chooses_what_waits_in_memory(
    monkeypatch, bicycle, features, blocks
):
    host = chosen("native", X86, "some", features)
    monkeypatch.setattr("pydy._backends.llvm.text.target", lambda: host)
    text = kernel_text(bicycle, 8, host.registers.widest)
    run = text[text.index("strided(") : text.index("%done = ")]
    spills = re.findall(r"store <\d x double> %\S+, ptr %slot", run)
    assert ("label %block." in run) is blocks
    assert (len(spills) > 20) is blocks  # else those of sines of large angles alone
