"""A plugin of pytest: the solvers' loops as libraries that end the process where C is undefined.

``make test-undefined`` runs tests with it. What is checked is what the compiler of the loops knows
to check: overflows, shifts, casts, alignment, null pointers, and the bounds of C's own arrays.
"""

from __future__ import annotations

import ctypes
import subprocess
import sys
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import solvers_ir

from pydy.solvers.core.declarations import FOLDER, layout_header
from pydy.solvers.run import shipped

_HERE = Path(mkdtemp())  # libraries stay loaded as long as the process lives
# Not optimised: that takes minutes where eight lanes are compiled for AVX-512.
_CHECKS = ("-O0", "-fsanitize=undefined", "-fsanitize-trap=undefined", "-shared", "-fPIC", "-lm")


@cache
def _address_of(name: str) -> int:
    library, source = _HERE / f"{name}.so", FOLDER / f"{name}.c"
    command = [sys.executable, "-m", "ziglang", "cc", *solvers_ir.FLAGS, *_CHECKS]
    command += ["-Wno-unused-command-line-argument"]  # of clang's own linker
    command += [f"-I{FOLDER}", f"-I{_HERE}", str(source), "-o", str(library)]
    subprocess.run(command, check=True)
    found = getattr(ctypes.CDLL(str(library)), name)
    return ctypes.cast(found, ctypes.c_void_p).value or 0


def pytest_configure() -> None:
    """Have every loop called in its library."""
    (_HERE / "layout.h").write_text(layout_header(), encoding="utf-8")
    shipped.address_of = _address_of
