"""The cache of Programs, and of what else is derived from a graph, on disk."""

from __future__ import annotations

import hashlib
import marshal
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeVar, cast

import pydy._assembly
import pydy._graph
import pydy._program
from pydy import _cache_folder
from pydy._assembly.assembly import Assembly
from pydy._graph import passes_are_shipped
from pydy._program import OPERATIONS, Program, Tangent, program_from_bytes, program_to_bytes

# Small systems are simplified sooner than a file is read.
_WORTH_STORING = 300
_S = TypeVar("_S")
_T = TypeVar("_T", bound="Program | Tangent")


def _made_by() -> bytes:
    """Return a digest of everything except the equations that determines a Program."""
    sha = hashlib.sha256(sys.version.encode())
    for package in (pydy._assembly, pydy._graph, pydy._program):
        for source in sorted(Path(str(package.__file__)).parent.rglob("*.py")):
            sha.update(source.read_bytes())
    return sha.digest()


# Now: the package may be replaced while this process runs, see `pydy._backends.llvm.compiling`.
_CIRCUMSTANCES = _made_by()


def _as_shipped() -> bool:
    """Return whether all operations and passes are the package's own."""
    return OPERATIONS.are_shipped() and passes_are_shipped()


def stored(
    parts: Sequence[bytes],
    make: Callable[[], _S],
    write: Callable[[_S], bytes],
    read: Callable[[bytes], _S],
) -> _S:
    """Return the cache's entry for the key `parts`, or make the object and store it."""
    if not _as_shipped():
        return make()
    key = hashlib.sha256(b"".join((_CIRCUMSTANCES, *parts))).hexdigest()
    data = _cache_folder.read(key)
    if data is not None:
        return read(data)
    made = make()
    _cache_folder.write(key, write(made))
    return made


def fingerprint(assembly: Assembly) -> bytes:
    """Return a digest of all that Programs are made from."""
    graph, ready = assembly.graph, assembly.ready
    blocks = [assembly.sizes, *vars(assembly.blocks).values(), *assembly.open.values()]
    simplified = ready and (ready[0], ready[1].ops, ready[1].args, ready[2])
    content = (graph.ops, graph.args, blocks, simplified, sorted(graph.off))
    # Version 2 of the format writes every object in full: equal content gives equal bytes.
    return hashlib.sha256(marshal.dumps(content, 2)).digest()


def stored_program(assembly: Assembly, what: str, make: Callable[[], _T]) -> _T:
    """Return a Program or Tangent from the cache, or make it and put it there."""
    if len(assembly.graph) < _WORTH_STORING:
        return make()
    parts = (fingerprint(assembly), what.encode())
    return stored(parts, make, program_to_bytes, lambda data: cast("_T", program_from_bytes(data)))
