"""Compiling in another process, and what the program notices of it: nothing."""

from __future__ import annotations

import gc
import os
import re
import shutil
import subprocess
import sys
import threading
import time
import weakref
from pathlib import Path

import numpy as np
import pytest

from graphs import on_tape
from pydy._backends.llvm import background, compiling, jit
from pydy._backends.llvm.compiling import Source
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.llvm.tiers import _Text
from pydy._graph.node import Graph

THREE = "define double @three() {\nret double 3.0\n}"


def text(_brief):
    return THREE


def nonsense(_brief):
    return "this is no IR"


SOURCE = Source("three", text, ("three",))


def program(number):
    """A Program of its own for each number."""
    graph = Graph()
    x = [graph.input("x", k) for k in range(2)]
    return on_tape(graph, [x[1], graph.mul(x[0], graph.const(float(number)))], (2, 0, 0))


@pytest.fixture
def nothing_cached(monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", "off")
    jit.memory.clear()


@pytest.fixture
def helper():
    helper = compiling.Helper()
    yield helper
    helper.close()


def begun(number):
    """Return a Kernel whose quick code is there."""
    kernel = LLVMBackend().compile(program(number))
    assert kernel.call
    return kernel


PATIENCE = 600.0  # seconds on a busy machine, where a tenth is meant


def until(condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


# -- the other process ----------------------------------------------------------------------------


def test_another_process_gives_the_same_code(helper):
    assert helper.compile(SOURCE) == compiling.object_code(SOURCE)
    assert helper.compile(SOURCE) == compiling.object_code(SOURCE)


def test_a_process_that_has_ended_is_an_error_that_is_expected(helper):
    helper.compile(SOURCE)
    helper._process.kill()
    with pytest.raises(compiling.HelperError, match="does not answer"):
        helper.compile(SOURCE)


def test_what_does_not_compile_is_an_error_that_is_expected(helper):
    with pytest.raises(compiling.HelperError, match="does not answer"):
        helper.compile(Source("nonsense", nonsense, ()))


@pytest.mark.parametrize("executable", ["", None, "/usr/bin/blender"])
def test_a_program_that_is_not_python_is_not_started(helper, monkeypatch, executable):
    monkeypatch.setattr(sys, "executable", executable)
    with pytest.raises(compiling.HelperError):
        helper.compile(SOURCE)
    assert helper._process is None


def test_a_program_goes_there_and_back(helper):
    source = Source("program", _Text(program(4), 1, 1), ("kernel", "prepare"))
    assert helper.compile(source) == compiling.object_code(source)


def test_what_pythons_own_settings_print_is_no_code(helper, monkeypatch, tmp_path):
    (tmp_path / "sitecustomize.py").write_text("print('good morning' * 100)")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    assert helper.compile(SOURCE) == compiling.object_code(SOURCE)


@pytest.mark.skipif(sys.platform != "linux", reason="a limit on memory is Linux's")
def test_without_memory_for_llvm_the_process_goes_on():
    code = """
import resource
from pydy._backends.llvm import compiling
functions = "".join(f"define i64 @f{k}() {{\\nret i64 {k}\\n}}\\n" for k in range(4000))
small, large = (
    compiling.Source(name, lambda brief, t=text: t, ("f0",))
    for name, text in (("small", functions[:31]), ("large", functions))
)
compiling.object_code(small, quick=True)
with open("/proc/self/statm") as file:
    taken = int(file.read().split()[0]) * resource.getpagesize()
limit = resource.getrlimit(resource.RLIMIT_AS)
resource.setrlimit(resource.RLIMIT_AS, (taken + 2**20, limit[1]))
try:
    compiling.object_code(large, quick=True)
except MemoryError as error:
    print(error)
resource.setrlimit(resource.RLIMIT_AS, limit)
print(len(compiling.object_code(large, quick=True)) > 4000)
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
emitter, compiling._emitter = compiling._emitter, lambda quick: Machine()
source = compiling.Source("f", lambda brief: "define i64 @f() {\\nret i64 1\\n}\\n", ("f",))
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


def test_it_ends_with_the_program():
    code = """
from pydy._backends.llvm import background
from pydy._backends.llvm.native import LLVMBackend
import test_compiling, time
background.QUIET_SECONDS = 0.0
kernel = test_compiling.begun(5)
test_compiling.until(lambda: background._helper._process is not None)
print(background._helper._process.pid)
"""
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYDY_CACHE_DIR": "off", "PYTHONPATH": os.pathsep.join(sys.path)},
        cwd=os.path.dirname(__file__),
        capture_output=True,
        text=True,
        check=True,
        timeout=PATIENCE,
    )
    assert done.stderr == ""
    with pytest.raises(ProcessLookupError):
        os.kill(int(done.stdout), 0)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # Python 3.12: there are threads
def test_a_forked_child_leaves_the_process_to_its_parent(helper):
    helper.compile(SOURCE)
    child = os.fork()
    if child == 0:
        helper.close(ours=False)
        os._exit(0)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    assert helper.compile(SOURCE)


# -- the side thread ------------------------------------------------------------------------------


@pytest.fixture
def at_once(monkeypatch):
    monkeypatch.setattr(background, "QUIET_SECONDS", 0.0)


@pytest.fixture
def nothing_on_the_side(monkeypatch):
    """Tasks are known, but nobody is told."""
    monkeypatch.setattr(background, "submit", lambda task: known.update({task: None}))
    known = weakref.WeakKeyDictionary()
    return known


def test_the_side_thread_compiles_nothing_in_this_process(nothing_cached, at_once, monkeypatch):
    compilers = []
    emitter = compiling._emitter
    monkeypatch.setattr(
        compiling,
        "_emitter",
        lambda quick: compilers.append(threading.current_thread().name) or emitter(quick),
    )
    kernel = begun(11)
    entry = kernel.entry
    until(lambda: len(entry._owners) == 2)
    assert set(compilers) == {threading.current_thread().name}


def test_nothing_waits_for_what_is_compiled_on_the_side(nothing_cached, at_once, monkeypatch):
    started, end, waited = threading.Event(), threading.Event(), []

    def slow(_self, source):
        started.set()
        waited.append(end.wait(PATIENCE))
        return compiling.object_code(source)

    monkeypatch.setattr(compiling.Helper, "compile", slow)
    first = begun(12)
    assert started.wait(PATIENCE)
    # If one of these waited for the side, it would do so until the latter gave up.
    second = begun(13)
    second.settle()
    before = first.cell.copy()
    first.settle()  # not even for its own
    assert (first.cell != before).all()
    before = first.cell.copy()
    assert not waited
    end.set()
    until(lambda: not background._TASKS)
    assert (first.cell == before).all()


def test_where_no_process_can_be_started_the_program_compiles(nothing_cached, nothing_on_the_side):
    def none(source):
        raise compiling.HelperError("there is none")

    kernel = begun(14)
    task = kernel.entry.better
    with pytest.raises(compiling.HelperError):
        task.run_with(none)
    before = kernel.cell.copy()
    kernel.settle()
    assert (kernel.cell != before).all()


def test_a_process_without_work_is_ended(nothing_cached, at_once, monkeypatch):
    monkeypatch.setattr(background, "IDLE_SECONDS", 0.05)
    kernel = begun(15)
    assert kernel.entry
    until(lambda: not background._TASKS and background._helper._process is None)


# -- what stays behind ----------------------------------------------------------------------------


@pytest.mark.parametrize("settled", [False, True])
def test_code_goes_with_the_last_reference_to_its_kernel(
    nothing_cached, nothing_on_the_side, settled
):
    kernel = begun(16)
    if settled:
        kernel.settle()
    engines = [weakref.ref(code._engine) for code in kernel.entry._owners]
    assert len(engines) == 1 + settled
    assert len(nothing_on_the_side) == 1
    gc.disable()  # no cycles either
    try:
        del kernel
        assert [engine() for engine in engines] == [None] * len(engines)
    finally:
        gc.enable()
    assert len(nothing_on_the_side) == 0


def test_code_of_the_side_goes_too(nothing_cached, at_once):
    kernel = begun(17)
    owners = kernel.entry._owners
    until(lambda: len(owners) == 2)
    engines = [weakref.ref(code._engine) for code in owners]
    kernel = owners = None
    until(lambda: [engine() for engine in engines] == [None, None])


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


def test_bits_are_the_same_whoever_compiled(nothing_cached, at_once):
    kernel = begun(18)
    entry, x = kernel.entry, np.random.default_rng(0).normal(size=(9, 2))
    arguments = np.zeros(9), x, np.zeros((1, 0)), np.zeros(0)
    quick = kernel.evaluate(*arguments)[0]
    until(lambda: len(entry._owners) == 2)
    np.testing.assert_array_equal(kernel.evaluate(*arguments)[0], quick)


REPLACED = """
import sys
from pathlib import Path

import numpy as np
import pydy
import zoo
from cases import system_of
from pydy import _cache_folder
from pydy._backends.llvm import background, compiling, tiers
from pydy.solvers.run import shipped

background.submit = lambda task: None  # which entries are written does not depend on time
package = Path(pydy.__file__).parent
if sys.argv[1] == "old":  # another version is installed from here on
    for path in (*package.rglob("emit.py"), *package.rglob("lower.py")):
        path.write_text(path.read_text() + "# the next version\\n")
    for path in package.rglob("*.ll"):
        path.rename(path.with_suffix(".away"))
system = system_of(zoo.fourbar(), times=[0.0, 0.1], ode_solver="vern9")
states = system.integrate(constraints="project")
system.evaluate_jacobian(states[0])
if sys.argv[1] == "old":
    source = compiling.Source("nothing", str, ())
    try:
        compiling.Helper().compile(source)
    except compiling.HelperError:
        pass
    else:
        raise AssertionError("a process of the next version compiled")
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


def test_what_is_compiled_quickly_is_kept_for_other_processes(tmp_path):
    script = """\
from pydy._backends.llvm import background, compiling, jit
background.QUIET_SECONDS = 1e9  # as in a short script
compiled, own = [], compiling.object_code
jit.object_code = lambda source, quick=False: compiled.append(quick) or own(source, quick)
from pydy.models import multi_mass_spring_damper
system = multi_mass_spring_damper(2)
system.ode_solver, system.times = "dop853", [0.0, 1.0]
print(system.integrate().tobytes().hex(), compiled.count(True))
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
