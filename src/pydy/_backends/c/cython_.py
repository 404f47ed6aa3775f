"""The 'cython' generator: a Program as straight-line C, built as an extension module.

The C file holds the two functions of the package's native signature; a Cython module of a few
lines includes it and tells their addresses, and `pydy._backends.llvm.native` puts its sweep and its
call gate around them as for LLVM. The build runs in a process of its own: setuptools works on the
current directory and on `sys.argv`, which belong to the user here.
"""

from __future__ import annotations

import importlib.util
import itertools
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Iterable
from importlib.machinery import EXTENSION_SUFFIXES, ExtensionFileLoader
from pathlib import Path
from types import ModuleType
from typing import Any

from pydy._backends.llvm.native import Entry, native_kernel
from pydy._backends.registry import compile_program
from pydy._cache_folder import unsafe
from pydy._errors import GeneratorError, MissingDependencyError, PyDyUserWarning
from pydy._graph.operations import OPERATIONS, TRUTHS, operands
from pydy._graph.program import Program
from pydy._kernel import Kernel

__all__ = ["CythonBackend", "c_source"]


class CythonBackend:
    """Compiles Programs as C, through Cython and the machine's C compiler.

    Parameters
    ----------
    prefix : str, optional
        What the names of the modules and of their source files begin with: ASCII letters, digits
        and underscores, not beginning with a digit.
    tmp_dir : path, optional
        Where the files are written and kept, each build in a new folder of its own; made if it
        does not exist. Others must not be able to write there. By default the files lie in a
        temporary directory, which is removed once the module is loaded.
    verbose : bool, optional
        Whether the output of the build is written to `sys.stdout`.
    cse : bool, optional
        Accepted for scripts that pass it; common sub-expressions are always shared.

    Raises
    ------
    ValueError
        `prefix` is no such name.
    """

    def __init__(
        self,
        prefix: str = "pydy_codegen",
        tmp_dir: str | os.PathLike[str] | None = None,
        verbose: bool = False,
        cse: bool = True,
    ) -> None:
        if not isinstance(prefix, str) or not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", prefix):
            raise ValueError(
                f"`prefix` is {prefix!r}, but it begins the name of a module: it must consist of "
                "ASCII letters, digits and underscores, and not begin with a digit."
            )
        self.options: dict[str, Any] = {
            "prefix": prefix,
            "tmp_dir": None if tmp_dir is None else os.path.abspath(tmp_dir),
            "verbose": verbose,
            "cse": cse,
        }

    def compile(self, program: Program) -> Kernel:
        """Return the Kernel of a Program.

        Raises
        ------
        MissingDependencyError
            Cython or setuptools is not installed. It is a GeneratorError and an ImportError.
        GeneratorError
            The build failed; the message ends with the compiler's own.
        ValueError
            `tmp_dir` is not a directory and cannot be made one.
        """
        _require("Cython", "setuptools")
        name, directory = self._reserve(program.digest)
        (directory / f"{name}_equations.c").write_text(c_source(program), encoding="ascii")
        (directory / f"{name}.pyx").write_text(_WRAPPER.format(name=name), encoding="ascii")
        _build(name, directory, self.options["verbose"])
        module = _load(name, directory)
        if self.options["tmp_dir"] is None:
            # Windows keeps the file of a loaded module; its own cleaning takes what stays.
            shutil.rmtree(directory, ignore_errors=True)
        recipe = ("cython", self.options)
        entry = Entry(module.addresses(), module)
        return native_kernel(program, entry, 1, compile_program, recipe)

    def _reserve(self, digest: str) -> tuple[str, Path]:
        """Return a module name that is new to this process, and a new directory for it.

        Each build has its own: setuptools reads any setup.cfg and pyproject.toml beside the
        sources, and a file that is loaded somewhere must never be written again.
        """
        names = (f"{self.options['prefix']}_{digest[:12]}_{n}" for n in _NUMBERS)
        if self.options["tmp_dir"] is None:
            return next(names), Path(tempfile.mkdtemp(prefix=f"{self.options['prefix']}_"))
        folder = Path(self.options["tmp_dir"])
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except (FileExistsError, NotADirectoryError):
            raise ValueError(
                f"`tmp_dir` must be a directory or a path where one can be made, got "
                f"'{folder}', which is a file or lies below one."
            ) from None
        if trouble := unsafe(folder.resolve()):
            kept = tempfile.mkdtemp(prefix=f"{self.options['prefix']}_")
            message = (
                f"{trouble}, so that code loaded from `tmp_dir` could be somebody else's. The "
                f"files are in '{kept}' instead; pass a directory that only you can write to."
            )
            warnings.warn(message, PyDyUserWarning, stacklevel=2)
            return next(names), Path(kept)
        for name in names:
            try:
                (folder / name).mkdir(0o700)
            except FileExistsError:
                continue  # of an earlier process, or of another one at work in the same folder
            return name, folder / name
        raise AssertionError("the numbers never end")


_NUMBERS = itertools.count()


# -- the build ------------------------------------------------------------------------------------

_REMEDY = "generator='llvm' needs neither Cython nor a compiler."

_WRAPPER = '''\
# cython: language_level=3
"""Compiled equations; written by pydy."""

from libc.stdint cimport int32_t, uintptr_t


cdef extern from "{name}_equations.c":
    int32_t kernel(
        const double *t, const double *x, const double *r, const double *c, double *out
    ) nogil
    void prepare(const double *p, double *c) nogil


def addresses():
    """Return the addresses of `kernel` and `prepare`."""
    return <uintptr_t> <void *> kernel, <uintptr_t> <void *> prepare
'''

# Run by a Python of its own, in the directory of the sources. -g0: debug information of
# straight-line code takes a compiler longer than the code. Nobody reads errno.
_SCRIPT = """\
import sys, sysconfig
name, *path = sys.argv[1:]
sys.path += [p for p in path if p not in sys.path]
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from Cython.Build import cythonize

class Build(build_ext):
    def build_extensions(self):
        if self.compiler.compiler_type == "msvc":
            flags = ["/O2"]
        else:
            flags = ["-O2", "-g0", "-ffp-contract=fast", "-fno-math-errno"]
        for extension in self.extensions:
            extension.extra_compile_args = flags
        super().build_extensions()

directives = {}
if sysconfig.get_config_var("Py_GIL_DISABLED"):
    directives["freethreading_compatible"] = True
setup(
    name=name,
    packages=[],
    py_modules=[],
    ext_modules=cythonize([Extension(name, [name + ".pyx"])], compiler_directives=directives),
    cmdclass={"build_ext": Build},
    script_args=["build_ext", "--inplace"],
)
"""

_TAIL = 40  # lines of the build's output that an error shows


def _require(*packages: str) -> None:
    """Raise if one of the packages cannot be imported; none of them is."""
    for package in packages:
        try:
            found = importlib.util.find_spec(package) is not None
        except ValueError:  # something in sys.modules that is no module
            found = False
        if not found:
            raise MissingDependencyError(
                f"The 'cython' generator needs Cython and setuptools, but {package} is not "
                f'installed: `pip install "pydy[cython]"` installs both. {_REMEDY}'
            )


def _build(name: str, directory: Path, verbose: bool) -> None:
    """Build the extension module `name` in its directory."""
    # -P: nothing that lies beside the sources shadows a module of the build. The script adds this
    # process's search path at the end, so that it finds what `_require` has found.
    command = [sys.executable, "-P", "-c", _SCRIPT, name, *map(os.path.abspath, sys.path)]
    lines = []
    try:
        with subprocess.Popen(
            command,
            cwd=directory,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,  # compilers differ in where they write their errors
            text=True,
            errors="replace",
        ) as process:
            assert process.stdout is not None
            for line in process.stdout:
                lines.append(line)
                if verbose:
                    sys.stdout.write(line)
    except OSError as error:
        raise GeneratorError(
            f"Python could not be started to build the C code in '{directory}': {error}. {_REMEDY}"
        ) from error
    if process.returncode:
        (directory / "build.log").write_text("".join(lines), encoding="utf-8")
        tail = "".join(lines[-_TAIL:]).rstrip()
        raise GeneratorError(
            f"The C code could not be built. Its source and the whole output, build.log, lie in "
            f"'{directory}'. The 'cython' generator needs a C compiler that works; {_REMEDY} "
            f"The output ends with:\n\n{tail}"
        )


def _load(name: str, directory: Path) -> ModuleType:
    """Import the built module from its file, wherever that is."""
    path = next(p for s in EXTENSION_SUFFIXES if (p := directory / f"{name}{s}").exists())
    loader = ExtensionFileLoader(name, str(path))
    spec = importlib.util.spec_from_file_location(name, path, loader=loader)
    assert spec is not None
    try:
        module = importlib.util.module_from_spec(spec)
        loader.exec_module(module)
    except ImportError as error:
        raise GeneratorError(
            f"The module built in '{directory}' could not be loaded: {error}. Where that directory "
            f"forbids to execute files, `tmp_dir` gives another. {_REMEDY}"
        ) from error
    sys.modules.pop(name, None)  # Cython puts it there; its file may be gone soon
    return module


# -- the C code -----------------------------------------------------------------------------------

# A matrix is singular when a pivot is not above n·eps of its row's and column's scale; its
# solution is then NaN, by a NaN in the last pivot. A NaN in the matrix is not a failure: every
# comparison below is false for it, and it comes out as NaN.
_HELPERS = """\
#include <math.h>
#include <stdint.h>

/* Unlike fmin and fmax, these give NaN when either argument is NaN. */
static inline double minimum(double a, double b) { return a < b || a != a ? a : b; }
static inline double maximum(double a, double b) { return a > b || a != a ? a : b; }
static inline double sign(double a) { return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : a; }

/* Factorise the n by n matrix a in place by LU with partial pivoting; `scales` is 2 n numbers of
   work space, the reciprocal sizes of the rows and then of the columns. Returns whether a is
   singular. */
static inline int32_t lu_factor(int n, double *a, int *pivots, double *scales)
{
    const double tolerance = n * 2.220446049250313e-16;
    int32_t singular = 0;
    for (int i = 0; i < n; i++) {
        double top = 0.0;
        for (int j = 0; j < n; j++) {
            const double size = fabs(a[i * n + j]);
            top = size > top ? size : top;
        }
        scales[i] = 1.0 / (top > 0.0 ? top : 1.0);
    }
    for (int j = 0; j < n; j++) {
        double top = 0.0;
        for (int i = 0; i < n; i++) {
            const double size = fabs(a[i * n + j]) * scales[i];
            top = size > top ? size : top;
        }
        scales[n + j] = 1.0 / (top > 0.0 ? top : 1.0);
    }
    for (int k = 0; k < n; k++) {
        int pivot = k;
        double best = fabs(a[k * n + k]) * scales[k];
        for (int i = k + 1; i < n; i++) {
            const double size = fabs(a[i * n + k]) * scales[i];
            if (size > best) {
                best = size;
                pivot = i;
            }
        }
        if (best * scales[n + k] <= tolerance)
            singular = 1;
        pivots[k] = pivot;
        if (pivot != k) {
            for (int j = 0; j < n; j++) {
                const double swapped = a[k * n + j];
                a[k * n + j] = a[pivot * n + j];
                a[pivot * n + j] = swapped;
            }
            const double swapped = scales[k];
            scales[k] = scales[pivot];
            scales[pivot] = swapped;
        }
        const double inverse = 1.0 / a[k * n + k];
        for (int i = k + 1; i < n; i++) {
            const double factor = a[i * n + k] * inverse;
            a[i * n + k] = factor;
            for (int j = k + 1; j < n; j++)
                a[i * n + j] -= factor * a[k * n + j];
        }
    }
    if (singular)
        a[n * n - 1] = NAN; /* so that every solution is NaN */
    return singular;
}

/* Solve in place of the right-hand side b, with the factors from lu_factor. */
static inline void lu_solve(int n, const double *a, const int *pivots, double *b)
{
    for (int k = 0; k < n; k++) {
        const double swapped = b[k];
        b[k] = b[pivots[k]];
        b[pivots[k]] = swapped;
    }
    for (int i = 0; i < n; i++)
        for (int k = 0; k < i; k++)
            b[i] -= a[i * n + k] * b[k];
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            b[i] -= a[i * n + k] * b[k];
        b[i] /= a[i * n + i];
    }
}
"""

_EPS = 2.0**-52


def c_source(program: Program) -> str:
    """Return the C file of a Program, with the functions `prepare` and `kernel`."""
    head = f"/* Written by pydy for the program {program.digest}. */\n\n"
    return "\n".join([head + _HELPERS, *_prepare(program), "", *_kernel(program), ""])


def _prepare(program: Program) -> Iterable[str]:
    yield "static void prepare(const double *__restrict p, double *__restrict c)"
    yield "{"
    stage = _Stage(program)
    for node, setup in enumerate(program.setup):
        if setup:
            stage.node(node)
    yield from stage.lines
    for index, node in enumerate(program.carried):
        yield f"    c[{index}] = {stage.names[node]};"
    yield "}"


def _kernel(program: Program) -> Iterable[str]:
    yield "static int32_t kernel("
    yield "    const double *__restrict t, const double *__restrict x, const double *__restrict r,"
    yield "    const double *__restrict c, double *__restrict out)"
    yield "{"
    yield "    int32_t status = 0;"
    stage = _Stage(program)
    stage.carried(program.carried)
    for node, setup in enumerate(program.setup):
        if not setup:
            stage.node(node)
    yield from stage.lines
    for index, node in enumerate(program.outputs):
        yield f"    out[{index}] = {stage.names[node]};"
    yield "    return status;"
    yield "}"


class _Stage:
    """Writes the operations of one stage; every value is a constant local variable."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.lines: list[str] = []
        self.names: dict[int, str] = {}
        for node, op in enumerate(program.ops):
            if op in ("const", "bool"):
                self.names[node] = _literal(program.args[node][0])

    def carried(self, nodes: Iterable[int]) -> None:
        """Read the values of the setup stage."""
        for index, node in enumerate(nodes):
            test = " != 0.0" if self.program.ops[node] in TRUTHS else ""
            self._let(node, f"c[{index}]{test}")

    def node(self, node: int) -> None:
        """Write one operation."""
        op, args = self.program.ops[node], self.program.args[node]
        names = [self.names.get(k, "") for k in operands(op, args)]
        if op in ("const", "bool"):
            pass
        elif op == "input":
            self._let(node, f"{args[0]}[{args[1]}]")
        elif op in OPERATIONS:
            self._let(node, OPERATIONS[op].c.format(*names))
        elif op == "item":
            self._let(node, f"s{args[0]}[{args[1]}]")
        elif op == "factor":
            self._factor(f"{node}", args[1], args[2], "    ")
        elif op == "solve":
            self._array(f"s{node}", args[1], "    ")
            self._line(f"lu_solve({len(args[1])}, a{args[0]}, i{args[0]}, s{node});", "    ")
        elif op == "guard":
            self._guard(node, *args)
        else:
            raise AssertionError(f"no C for {op!r}")

    def _line(self, text: str, indent: str) -> None:
        self.lines.append(indent + text)

    def _let(self, node: int, value: str) -> None:
        kind = "int" if self.program.ops[node] in TRUTHS else "double"
        self.names[node] = f"v{node}"
        self._line(f"const {kind} v{node} = {value};", "    ")

    def _array(self, name: str, nodes: tuple[int, ...], indent: str) -> None:
        values = ", ".join(self.names[k] for k in nodes) or "0.0"  # C knows no empty array
        self._line(f"double {name}[] = {{{values}}};", indent)

    def _factor(self, suffix: str, n: int, entries: tuple[int, ...], indent: str) -> None:
        self._array(f"a{suffix}", entries, indent)
        self._line(f"int i{suffix}[{max(n, 1)}];", indent)
        self._line(f"double w{suffix}[{max(2 * n, 1)}];", indent)
        self._line(f"status |= lu_factor({n}, a{suffix}, i{suffix}, w{suffix});", indent)

    def _guard(
        self,
        node: int,
        n: int,
        entries: tuple[int, ...],
        column: tuple[int, ...],
        sound: int,
        fast: tuple[int, ...],
    ) -> None:
        self._array(f"s{node}", fast, "    ")
        self._line(f"if (!({self.names[sound]})) {{", "    ")
        inside = "        "
        self._factor("", n, entries, inside)
        for k, value in enumerate(column):
            self._line(f"s{node}[{k}] = {self.names[value]};", inside)
        self._line(f"lu_solve({n}, a, i, s{node});", inside)
        self._line("}", "    ")


def _literal(value: float | bool) -> str:
    """Return a number in C, exactly."""
    if isinstance(value, bool):
        return str(int(value))
    if math.isnan(value):
        return "NAN"
    text = "INFINITY" if math.isinf(value) else repr(abs(float(value)))
    return f"(-{text})" if math.copysign(1.0, value) < 0.0 else text
