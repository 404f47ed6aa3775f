"""The 'cython' generator: a Program as straight-line C, built as an extension module.

The C file from `pydy._backends.c.source` holds the two functions of the native signature; a Cython
module of a few lines includes it and tells their addresses. `pydy._backends.llvm.native` puts its
sweep and its call gate around them as for LLVM. The build runs in a process of its own: setuptools
works on the current directory and on `sys.argv`, which belong to the user here.
"""

from __future__ import annotations

import importlib.util
import itertools
import os
import re
import shutil
import sys
import tempfile
import warnings
from importlib.machinery import EXTENSION_SUFFIXES, ExtensionFileLoader
from pathlib import Path
from types import ModuleType
from typing import Any

from pydy._backends.c.source import c_source
from pydy._backends.llvm.functions import LinkedFunctions
from pydy._backends.llvm.native import native_kernel
from pydy._backends.registry import compile_program
from pydy._cache_folder import unsafe
from pydy._errors import GeneratorError, MissingDependencyError, PyDyUserWarning
from pydy._interrupts import Interrupts
from pydy._kernel import Kernel
from pydy._names import printable
from pydy._processes import started
from pydy._program import Program


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
        force_c_contiguous: bool | None = None,
    ) -> None:
        if not isinstance(prefix, str) or not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", prefix):
            raise ValueError(
                f"`prefix` is {prefix!r}, but it begins the name of a module: it must consist of "
                "ASCII letters, digits and underscores, and not begin with a digit."
            )
        self.force_c_contiguous = force_c_contiguous  # the code is the same
        self.options: dict[str, Any] = {
            "prefix": prefix,
            "tmp_dir": None if tmp_dir is None else os.path.abspath(tmp_dir),
            "verbose": verbose,
            "cse": cse,
        }

    def compile(self, program: Program) -> Kernel:
        """Return the Kernel of a Program.

        A `GeneratorError` tells that Cython or setuptools is missing, or how the build failed, with
        the compiler's own words.
        """
        _require("Cython", "setuptools")
        directory = None
        try:
            with Interrupts():  # a Ctrl-C here would leave a folder behind
                name, directory = self._reserve(program.digest)
            (directory / f"{name}_equations.c").write_text(
                c_source(program, static=True), encoding="ascii"
            )
            (directory / f"{name}.pyx").write_text(_WRAPPER.format(name=name), encoding="ascii")
            _build(name, directory, self.options["verbose"])
            module = _load(name, directory)
            if self.options["tmp_dir"] is None:
                # Windows keeps the file of a loaded module; its own cleaning takes what stays.
                shutil.rmtree(directory, ignore_errors=True)
        except BaseException as error:
            if directory is not None and not isinstance(error, GeneratorError):  # they name it
                shutil.rmtree(directory, ignore_errors=True)
            raise
        recipe = ("cython", self.options)
        functions = LinkedFunctions()
        functions.replace(module.addresses(), module)
        return native_kernel(program, functions, 1, compile_program, recipe)

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
            private_folder = tempfile.mkdtemp(prefix=f"{self.options['prefix']}_")
            message = (
                f"{trouble}, so that code loaded from `tmp_dir` could be somebody else's. The "
                f"files are in '{private_folder}' instead; pass a directory that only you can "
                "write to."
            )
            warnings.warn(message, PyDyUserWarning, stacklevel=2)
            return next(names), Path(private_folder)
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

# binding=False: a plain function, with which the C compiler is done in less than half the time.
_WRAPPER = '''\
# cython: language_level=3, binding=False
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


def _require(*packages: str) -> None:
    """Raise if one of the packages is not installed, without importing it."""
    for package in packages:
        try:
            installed = importlib.util.find_spec(package) is not None
        except ValueError:  # something in sys.modules that is no module
            installed = False
        if not installed:
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
        with started(
            command,
            cwd=directory,
            encoding="utf-8",
            # Names of folders need not have letters that the console knows.
            env={**os.environ, "PYTHONIOENCODING": "utf-8:backslashreplace"},
        ) as process:
            assert process.stdout is not None
            for line in process.stdout:
                lines.append(line)
                if verbose:
                    sys.stdout.write(printable(line, sys.stdout))
    except OSError as error:
        raise GeneratorError(
            f"Python could not be started to build the C code in '{directory}': {error}. {_REMEDY}"
        ) from error
    if process.returncode:
        (directory / "build.log").write_text("".join(lines), encoding="utf-8")
        tail = "".join(lines[-40:]).rstrip()
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
            f"The module built in '{directory}' could not be loaded: {error}. If that directory "
            f"is mounted noexec, pass a different `tmp_dir`. {_REMEDY}"
        ) from error
    sys.modules.pop(name, None)  # Cython puts it there; its file may be gone soon
    return module
