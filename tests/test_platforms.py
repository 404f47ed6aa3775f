"""What differs between operating systems, simulated: no fork, open files, names, consoles, ABIs."""

import contextlib
import io
import os
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest
import solvers_ir
from llvmlite import binding

import pydy.examples
from graphs import everything, solves
from pydy import _cache_folder, cli
from pydy._backends.llvm.compiling import Source
from pydy._backends.llvm.text import kernel_text
from pydy._names import printable

ROOT = Path(__file__).parents[1]


def run(code, **environment):
    """What a Python of its own prints, as bytes."""
    command = [sys.executable, "-W", "error", "-c", code]
    done = subprocess.run(
        command, env={**os.environ, **environment}, capture_output=True, timeout=300, check=False
    )
    assert done.returncode == 0, done.stderr.decode(errors="replace")
    return done.stdout


SIMULATION = """
import numpy as np
from pydy.models import n_link_pendulum_on_cart
system = n_link_pendulum_on_cart(2)
system.ode_solver = "dop853"
system.initial_conditions = {system.coordinates[1]: 0.5}
system.times = np.linspace(0.0, 1.0, 5)
x = system.integrate(rtol=1e-10, atol=1e-10)
print(x[-1].tobytes().hex())
"""

# -- Windows has no fork, no owners of files, no priorities and no affinities ----------------------

BARE = """
import os, signal, sys
for name in ("fork", "register_at_fork", "geteuid", "getuid", "nice", "sched_getaffinity",
             "getloadavg", "O_NOFOLLOW", "O_NONBLOCK"):
    if hasattr(os, name):
        delattr(os, name)
for name in ("pwd", "grp", "fcntl", "resource", "termios"):
    sys.modules[name] = None
for name in ("setitimer", "pthread_sigmask", "SIGALRM"):
    if hasattr(signal, name):
        delattr(signal, name)
"""


@pytest.fixture(scope="module")
def expected():
    """What the simulation prints in this process."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(SIMULATION, {})
    return printed.getvalue().encode()


def test_nothing_needs_what_only_posix_has(tmp_path, expected):
    assert run(BARE + SIMULATION, PYDY_CACHE_DIR=str(tmp_path)) == expected


# -- Windows does not replace a file that somebody has open ---------------------------------------


def test_an_entry_that_is_open_elsewhere_stays_and_leaves_nothing_beside(tmp_path, monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path))
    _cache_folder.write("0" * 64, b"first")
    before = sorted(path.name for path in _cache_folder.folder().iterdir())

    def refuse(*_):
        raise PermissionError(13, "The process cannot access the file")

    monkeypatch.setattr(os, "replace", refuse)
    _cache_folder.write("0" * 64, b"second")
    assert _cache_folder.read("0" * 64) == b"first"
    assert sorted(path.name for path in _cache_folder.folder().iterdir()) == before


# -- names of users and folders -------------------------------------------------------------------


def test_folders_may_have_spaces_and_letters_of_any_language(tmp_path, expected):
    folder = tmp_path / "Zoë Müller 张伟" / "App Data"
    code = SIMULATION + "print(len(list(__import__('pathlib').Path(r'%s').rglob('*.code'))) > 0)"
    found = run(code % folder, PYDY_CACHE_DIR=str(folder))
    assert found.split() == [expected.strip(), b"True"]


def names_of_files():
    """Paths of the files that git keeps, or of those that an archive has."""
    listed = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=False
    ).stdout.split(b"\0")
    if len(listed) > 1:
        return [name.decode() for name in listed if name]
    return [p.relative_to(ROOT).as_posix() for p in (ROOT / "src").rglob("*")]


def test_names_of_files_suit_every_system():
    # Windows refuses some characters, drops dots and blanks at the end, and has names of devices.
    wrong = [name for name in names_of_files() if not re.fullmatch(r"[\w./+-]+", name, re.ASCII)]
    assert not wrong
    parts = {part for name in names_of_files() for part in name.split("/")}
    device = re.compile(r"(aux|con|nul|prn|com\d|lpt\d)(\..*)?", re.IGNORECASE)
    assert not [part for part in parts if part.endswith(".") or device.fullmatch(part)]


def test_no_two_files_differ_in_case_alone():
    twice = Counter(name.lower() for name in names_of_files())
    assert not [name for name, count in twice.items() if count > 1]


def test_keys_of_the_cache_are_in_lower_case():
    assert re.fullmatch(r"[0-9a-f]{64}", Source("X", str, ()).key)


# -- consoles without UTF-8 -----------------------------------------------------------------------


@pytest.mark.parametrize("encoding", ["ascii", "cp1252"])
def test_what_is_printed_needs_no_utf_8(encoding):
    code = (
        SIMULATION
        + """
print(repr(system), system)
print(system.simulate(rtol=1e-8, atol=1e-8))
print(system.model.compiled("rates").program)
system.integrate(progress=True)
"""
    )
    found = run(code, PYTHONIOENCODING=encoding, PYTHONUTF8="0", LC_ALL="C")
    assert b"Program: 6 states" in found


def test_letters_that_a_console_lacks_are_escaped():
    console = io.TextIOWrapper(io.BytesIO(), encoding="cp1252")
    assert printable("Zoë – 张", console) == "Zoë – \\u5f20"
    assert printable("Zoë", object()) == "Zoë"


def test_the_demo_tells_of_folders_that_a_console_cannot_spell(tmp_path, monkeypatch):
    for name in ("_print_model", "_print_ride", "_print_eigenvalues", "_print_seconds"):
        monkeypatch.setattr(cli, name, lambda ride: None)
    monkeypatch.setattr(cli, "_verdict", lambda ride: 0)
    monkeypatch.setattr(pydy.examples, "ride", lambda: None)
    for name in ("draw", "animate", "simulate"):
        monkeypatch.setattr(pydy.examples, name, lambda ride, path: path.touch())
    console = io.TextIOWrapper(io.BytesIO(), encoding="cp1252")
    monkeypatch.setattr(sys, "stdout", console)
    assert cli.main(["demo", "--output", str(tmp_path / "张伟")]) == 0
    console.flush()
    assert rb"\u5f20\u4f1f" in console.buffer.getvalue()


COMPILING = """
import sympy as sm
from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.errors import GeneratorError
x, v, k = sm.symbols("x, v, k")
try:
    rhs = generate_ode_function(
        sm.Matrix([v, -k * x]), [x], [v], [k], generator="cython", verbose=True, tmp_dir=FOLDER
    )
    print(rhs([1.0, 2.0], 0.0, [3.0]))
except GeneratorError:
    print("refused")
"""


def test_code_is_built_in_folders_that_the_console_cannot_spell(tmp_path):
    folder = tmp_path / "Zoë Müller 张伟"
    code = COMPILING.replace("FOLDER", ascii(str(folder)))
    assert b"[ 2. -3.]" in run(code, PYTHONIOENCODING="ascii")


def test_what_a_compiler_says_need_not_be_printable(tmp_path):
    script = tmp_path / "cc"
    script.write_bytes("#!/bin/sh\necho 'Datei fehlt: „ä“' >&2\nexit 1\n".encode())
    script.chmod(0o755)
    named = dict.fromkeys(("CC", "CXX", "LDSHARED"), str(script))
    code = COMPILING.replace("FOLDER", ascii(str(tmp_path / "build")))
    said = run(code, PYTHONIOENCODING="ascii", **named)
    assert rb"Datei fehlt: \u201e\xe4\u201c" in said
    assert said.endswith(b"refused\n")


# -- the C interface by triple ---------------------------------------------------------------------

TRIPLES = {
    "x86_64-pc-windows-msvc": "x86-64-v3",
    "x86_64-apple-darwin": "x86-64-v3",
    "x86_64-unknown-linux-gnu": "x86-64-v3",
    "aarch64-apple-darwin": "apple-m1",
    "aarch64-unknown-linux-gnu": "generic",
    "aarch64-pc-windows-msvc": "generic",
}
# The C library, what LLVM adds where a frame is larger than a page, and our own routines.
ALLOWED = re.compile(
    r"_?(pydy_\w+|kernel|prepare|strided|malloc|free|mem(cpy|set)|__chkstk|fmax|fmin"
    r"|a?(sin|cos|tan)h?|atan2|exp|log|pow|erfc?|floor|ceil|sqrt|bzero|turn\.\w+|\w+\.lanes\d?)"
)


@pytest.mark.parametrize("triple", TRIPLES)
@pytest.mark.parametrize("lanes", [1, 8])
def test_kernels_can_be_emitted_for_every_system_and_call_nothing_unknown(triple, lanes):
    binding.initialize_all_targets()
    binding.initialize_all_asmprinters()
    machine = binding.Target.from_triple(triple).create_target_machine(
        cpu=TRIPLES[triple], opt=2, codemodel="jitdefault", jit=True
    )
    head = f'target datalayout = "{machine.target_data}"\ntarget triple = "{triple}"\n'
    for program in (everything(), solves()):
        for width in {lanes, min(lanes, 4)}:
            text = head + kernel_text(program, lanes, width)
            # Closed before anything fails: in a cycle the context may be freed before the module.
            context = binding.create_context()
            with binding.parse_assembly(text, context) as module:
                assembly = machine.emit_assembly(module)
            called = re.findall(r"^\s+(?:callq?|bl|jmp)\s+\"?([\w.$@]+)", assembly, re.MULTILINE)
            names = {re.sub(r"@PLT$", "", name) for name in called}
            unknown = {n for n in names if not ALLOWED.fullmatch(n) and not re.match(r"\.?L", n)}
            assert not unknown


# Of Python and the C library, what gates, sweeps and the solvers' loops call.
LIBRARY = {"memcmp", "memcpy", "memset", "hypot", "sqrt", "__chkstk", "_chkstk"}


@pytest.mark.parametrize("triple", TRIPLES)
def test_loops_sweeps_and_gates_can_be_emitted_for_every_system(triple):
    binding.initialize_all_targets()
    binding.initialize_all_asmprinters()
    machine = binding.Target.from_triple(triple).create_target_machine(
        cpu=TRIPLES[triple], opt=2, codemodel="jitdefault", jit=True
    )
    head = f'target datalayout = "{machine.target_data}"\ntarget triple = "{triple}"\n'
    shipped = [solvers_ir.ir(name).read_text("utf-8") for name in solvers_ir.ENTRIES]
    assert len(shipped) > 9
    for text in shipped:
        context = binding.create_context()
        with binding.parse_assembly(head + text, context) as module:  # as above
            assert machine.emit_object(module)
            assembly = machine.emit_assembly(module)
            named = set(re.findall(r"\b_?([A-Za-z_]\w+)\b", assembly))
            own = {f.name for f in module.functions if not f.is_declaration}
            outside = {f.name for f in module.functions if f.is_declaration} & named
        assert outside - own <= solvers_ir.PYTHON | LIBRARY


def test_integers_that_python_takes_have_the_same_size_everywhere():
    # A long has 32 bits on Windows, 64 elsewhere.
    text = solvers_ir.ir("gates").read_text("utf-8")
    assert not re.search(r"Py\w*(From|As)(Unsigned)?Long\b", text)


@pytest.mark.parametrize("lanes", [1, 8])
def test_what_is_called_from_outside_takes_pointers_alone(lanes):
    # Pointers and integers are passed alike by every compiler of a system; vectors and
    # structures are not.
    text = kernel_text(everything(), lanes)
    for name in ("kernel", "prepare", *(["strided"] if lanes > 1 else [])):
        [(result, parameters)] = re.findall(rf"define\s+(\w+) @{name}\(([^)]*)\)", text)
        assert result in ("i32", "i64", "void")
        kinds = {part.split()[0] for part in parameters.split(", ")}
        assert kinds == {"ptr"}
