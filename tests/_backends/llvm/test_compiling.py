"""Machine code: limits on memory, what stays behind, and which version wrote it."""

from __future__ import annotations

import gc
import os
import re
import shutil
import subprocess
import sys
import weakref
from pathlib import Path

import pytest

from graphs import on_tape
from pydy._backends.llvm import compiling, jit
from pydy._backends.llvm.native import LLVMBackend
from pydy._graph.node import Graph
from pydy.models import n_link_pendulum_on_cart


def program(number):
    """A Program of its own for each number."""
    graph = Graph()
    x = [graph.input("x", k) for k in range(2)]
    return on_tape(graph, [x[1], graph.mul(x[0], graph.const(float(number)))], (2, 0, 0))


@pytest.fixture
def nothing_cached(monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", "off")
    jit.memory.clear()


PATIENCE = 600.0  # seconds on a busy machine, where a tenth is meant


@pytest.mark.skipif(sys.platform != "linux", reason="a limit on memory is Linux's")
def test_without_memory_for_llvm_the_process_goes_on():
    code = """
import resource
from pydy._backends.llvm import compiling
functions = "".join(f"define i64 @f{k}() {{\\nret i64 {k}\\n}}\\n" for k in range(4000))
small, large = (
    compiling.Source(name, lambda t=text: t, ("f0",))
    for name, text in (("small", functions[:31]), ("large", functions))
)
compiling.object_code(small)
with open("/proc/self/statm") as file:
    taken = int(file.read().split()[0]) * resource.getpagesize()
limit = resource.getrlimit(resource.RLIMIT_AS)
resource.setrlimit(resource.RLIMIT_AS, (taken + 2**20, limit[1]))
try:
    compiling.object_code(large)
except MemoryError as error:
    print(error)
resource.setrlimit(resource.RLIMIT_AS, limit)
print(len(compiling.object_code(large)) > 4000)
"""
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYDY_CACHE_DIR": "off", "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    first, second = done.stdout.splitlines() or [done.stderr, ""]
    assert re.fullmatch(r"Compiling may need \d+ MB of memory, .*`ulimit -v` .*", first)
    assert second == "True"


def test_what_an_exception_holds_in_a_cycle_is_freed_once():
    code = """
import gc
from pydy._backends.llvm import compiling
class Machine:
    def emit_object(self, module):
        error = KeyboardInterrupt()
        error.itself = error  # the frames of its traceback go when the collector finds them
        raise error
emitter, compiling._emitter = compiling._emitter, lambda: Machine()
source = compiling.Source("f", lambda: "define i64 @f() {\\nret i64 1\\n}\\n", ("f",))
for _ in range(3):
    try:
        compiling.object_code(source)
    except KeyboardInterrupt:
        pass
print(gc.collect() > 0)
compiling._emitter = emitter
print(len(compiling.object_code(source)) > 100)
"""
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYDY_CACHE_DIR": "off", "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    assert done.stdout.split() == ["True", "True"], done.stderr


def test_code_goes_with_the_last_reference_to_its_kernel(nothing_cached):
    kernels = LLVMBackend().compile(program(16)), n_link_pendulum_on_cart(5).model.compiled("rates")
    assert all(kernel.call for kernel in kernels)
    engines = [weakref.ref(code._engine) for k in kernels for code in k.functions._owners]
    assert len(engines) == 2
    gc.collect()
    gc.disable()  # no cycles either
    try:
        del kernels
        assert [engine() for engine in engines] == [None, None]
    finally:
        gc.enable()


RESIDENT = """
import gc, sys
import numpy as np
import test_compiling
from pydy._backends.llvm.native import LLVMBackend

def resident():
    return int(open("/proc/self/statm").read().split()[1]) * 4096

x, none, out = np.ones(2), np.zeros(0), np.empty(2)
def use(number):
    kernel = LLVMBackend().compile(test_compiling.program(number))
    assert kernel.call(x, 0.0, none, none, out) == 0
    assert out[1] == number

for number in range(2, 152):
    use(number)
gc.collect()
before = resident()
for number in range(152, 652):
    use(number)
gc.collect()
print((resident() - before) / 500)
"""


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="memory is read from /proc")
def test_a_distinct_right_hand_side_leaves_no_memory_behind():
    done = subprocess.run(
        [sys.executable, "-c", RESIDENT],
        env={**os.environ, "PYDY_CACHE_DIR": "off", "PYTHONPATH": os.pathsep.join(sys.path)},
        cwd=os.path.dirname(__file__),
        capture_output=True,
        text=True,
        check=True,
        timeout=PATIENCE,
    )
    assert float(done.stdout) < 10_000.0  # bytes; it was 55,000


REPLACED = """
import sys
from inspect import unwrap
from pathlib import Path

import numpy as np
import pydy
import zoo
from zoo.cases import system_of
from pydy import _cache_folder
from pydy._backends.llvm import compiling
from pydy.solvers.run import shipped

package = Path(pydy.__file__).parent
if sys.argv[1] == "old":  # another version is installed from here on
    for path in (*package.rglob("emit.py"), *package.rglob("lowering.py")):
        path.write_text(path.read_text() + "# the next version\\n")
    for path in package.rglob("*.ll"):
        path.rename(path.with_suffix(".away"))
system = system_of(unwrap(zoo.fourbar)(), times=[0.0, 0.1], ode_solver="vern9")
states = system.integrate(constraints="project")
system.evaluate_jacobian(states[0])
if sys.argv[1] == "old":
    for path in package.rglob("*.away"):
        path.rename(path.with_suffix(".ll"))
sys.stdout.write("\\n".join(p.name for p in _cache_folder.folder().rglob("*.code")))
"""


def test_a_process_whose_package_is_replaced_leaves_nothing_for_the_next_version(tmp_path):
    installed = Path(compiling.__file__).parents[2]
    shutil.copytree(installed, tmp_path / "pydy", ignore=shutil.ignore_patterns("__pycache__"))
    tests = [str(Path(__file__).parents[2]), *(p for p in sys.path if p)]
    paths = [str(tmp_path), *(p for p in tests if p != str(installed.parent))]
    cache = tmp_path / "cache"
    env = {"PYTHONPATH": os.pathsep.join(paths), "PYDY_CACHE_DIR": str(cache)}
    found = []
    for who in ("old", "new"):
        run = subprocess.run(
            [sys.executable, "-c", REPLACED, who],
            env=os.environ | env, capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert run.returncode == 0, run.stderr
        found.append({name for name in run.stdout.split() if name})
    assert len(found[1]) == 2 * len(found[0]) > 0  # the new one has found none of them


def test_what_is_compiled_is_kept_for_other_processes(tmp_path):
    script = """\
from pydy._backends.llvm import compiling, jit
compiled, own = [], compiling.object_code
jit.object_code = lambda source: compiled.append(source) or own(source)
from pydy.models import multi_mass_spring_damper
system = multi_mass_spring_damper(2)
system.ode_solver, system.times = "dop853", [0.0, 1.0]
print(system.integrate().tobytes().hex(), len(compiled))
"""
    states, compiled = zip(*(running(script, tmp_path).split() for _ in range(2)), strict=True)
    assert states[0] == states[1]
    assert int(compiled[0]) > 0
    assert int(compiled[1]) == 0


def running(script, place):
    done = subprocess.run(
        [sys.executable, "-c", script],
        env={**os.environ, "PYDY_CACHE_DIR": str(place)},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout
