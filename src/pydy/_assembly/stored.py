"""Programs on disk, beside the machine code: a second process simplifies nothing again."""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import pydy._assembly
import pydy._graph
from pydy import _cache_folder
from pydy._assembly.assembly import Assembly
from pydy._graph.jacobian_columns import JacobianColumns
from pydy._graph.operations import OPERATIONS, SHIPPED
from pydy._graph.passes import ONCE, ROUND
from pydy._graph.program import Program
from pydy._graph.solve.choose import FACTORISATIONS, UNKNOWNS

__all__ = ["stored_jacobian", "stored_program"]

# Small systems are simplified sooner than a file is read.
_WORTH_STORING = 300


def _made_by() -> bytes:
    """Return a digest of everything but the equations that decides what the Program is."""
    sha = hashlib.sha256(sys.version.encode())
    for package in (pydy._assembly, pydy._graph):
        for source in sorted(Path(str(package.__file__)).parent.rglob("*.py")):
            sha.update(source.read_bytes())
    return sha.digest()


# Now: the package may be replaced while this process runs, see `pydy._backends.llvm.compiling`.
_CIRCUMSTANCES = _made_by()


def _as_shipped() -> bool:
    """Return whether all operations, passes and strategies are the package's own.

    Others change without a change of the package's files.
    """
    functions = [function for _, function in (*ONCE, *ROUND, *UNKNOWNS, *FACTORISATIONS)]
    return OPERATIONS == SHIPPED and all(f.__module__.startswith("pydy.") for f in functions)


def stored_program(assembly: Assembly, what: str, make: Callable[[], Program]) -> Program:
    """Return a Program from the cache, or make it and put it there.

    Parameters
    ----------
    assembly : Assembly
        Where it comes from.
    what : str
        Which of the assembly's Programs it is.
    make : callable
        Returns the Program.
    """
    return _stored(assembly, what, make, Program.from_bytes)


def stored_jacobian(
    assembly: Assembly, what: str, make: Callable[[], Program | JacobianColumns]
) -> Program | JacobianColumns:
    """Return a Jacobian from the cache, or make it and put it there; see `stored_program`."""

    def read(data: bytes) -> Program | JacobianColumns:
        return kinds[data[:1]].from_bytes(data[1:])

    kinds: dict[bytes, type[Program | JacobianColumns]] = {b"p": Program, b"c": JacobianColumns}
    names = {kind: name for name, kind in kinds.items()}
    return _stored(assembly, what, make, read, lambda made: names[type(made)] + made.to_bytes())


_T = TypeVar("_T", Program, "Program | JacobianColumns")


def _stored(
    assembly: Assembly,
    what: str,
    make: Callable[[], _T],
    read: Callable[[bytes], _T],
    write: Callable[[_T], bytes] = lambda made: made.to_bytes(),
) -> _T:
    if len(assembly.graph) < _WORTH_STORING or not _as_shipped():
        return make()
    parts = (_CIRCUMSTANCES, assembly.fingerprint(), what.encode())
    key = hashlib.sha256(b"".join(parts)).hexdigest()
    data = _cache_folder.read(key)
    if data is not None:
        return read(data)
    made = make()
    _cache_folder.write(key, write(made))
    return made
