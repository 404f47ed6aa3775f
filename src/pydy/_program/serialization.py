"""Programs and Tangents as bytes, for the cache of one version of Python."""

from __future__ import annotations

import marshal
from dataclasses import astuple

import numpy as np

from pydy._program.program import Program
from pydy._program.signature import Block, Signature
from pydy._program.tangent import Part, Tangent

_MARK = b"tangent"


def program_to_bytes(program: Program | Tangent) -> bytes:
    """Return a Program or Tangent as bytes."""
    if isinstance(program, Program):
        values = program.ops, program.args, program.setup, program.carried, program.outputs
        return marshal.dumps((astuple(program.signature), values))
    parts = tuple((p.first, p.count, program_to_bytes(p.program)) for p in program.parts)
    table = program.directions
    directions = None if table is None else (table.shape, table.tobytes())
    content = (program_to_bytes(program.shared), parts, program.shape, directions)
    return _MARK + marshal.dumps(content)


def program_from_bytes(data: bytes) -> Program | Tangent:
    """Return the Program or Tangent that `program_to_bytes` wrote."""
    return _tangent(data[len(_MARK) :]) if data.startswith(_MARK) else _program(data)


def _program(data: bytes) -> Program:
    (states, specifieds, constants, blocks), values = marshal.loads(data)
    signature = Signature(states, specifieds, constants, tuple(Block(*block) for block in blocks))
    return Program(signature, *values)


def _tangent(data: bytes) -> Tangent:
    shared, parts, shape, table = marshal.loads(data)
    parts = tuple(Part(first, count, _program(program)) for first, count, program in parts)
    directions = None if table is None else np.frombuffer(table[1]).reshape(table[0])
    return Tangent(_program(shared), parts, shape, directions)
