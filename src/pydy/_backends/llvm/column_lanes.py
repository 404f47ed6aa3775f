"""Sensitivities of several trajectories side by side: a `SplitProgram` whose lanes are samples.

Everything lies ``[item][lane]``. The shared part is the kernel of all lanes, with the bits of that
of one; the one of the columns is called for each column, in its strided form: from one state's
derivative to the next, those by all parameters lie in between.

Its array c holds the constants of the shared kernel, then those of each column.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import Source
from pydy._backends.llvm.ir import Function
from pydy._backends.llvm.tiers import wide_code
from pydy._graph.split import SplitProgram


@dataclass(frozen=True, eq=False)
class LanesOfColumns:
    """Native code for states and sensitivities of several trajectories."""

    program: SplitProgram
    addresses: tuple[int, int]  # (int, int): of ``kernel`` and ``prepare``
    lanes: int
    _owners: tuple[Any, ...] = field(repr=False)


def compile_lanes_of_columns(split: SplitProgram, lanes: int) -> LanesOfColumns:
    """Compile a SplitProgram for several trajectories at a time."""
    shared, column = (wide_code(part, lanes) for part in (split.shared, split.column))
    text = _both(split, lanes, shared, column)
    source = Source(f"lanes {lanes} {split.digest}", lambda brief: text, ("kernel", "prepare"))
    both = jit.load_quickly(source)
    addresses = both.addresses["kernel"], both.addresses["prepare"]
    return LanesOfColumns(split, addresses, lanes, (shared, column, both))


def _both(split: SplitProgram, lanes: int, shared: jit.Code, column: jit.Code) -> str:
    n, columns = split.shared.num_states, split.columns
    own, part = (lanes * len(program.carried) for program in (split.shared, split.column))

    def of(code: jit.Code, name: str) -> str:
        return f"inttoptr (i64 {code.addresses[name]} to ptr)"

    steps = ", ".join(f"i64 {k}" for k in (columns * lanes, lanes, columns * lanes, 1, lanes))
    lines = [f"@steps = private constant [5 x i64] [{steps}]"]
    names = ("t", "x", "r", "c", "out")
    f = Function("kernel", "i32", ", ".join(f"ptr %{name}" for name in names), "|nounwind")
    values = f.slot(f"<{lanes} x double>", len(split.shared.outputs))
    call = f"call i32 {of(shared, 'kernel')}(ptr %t, ptr %x, ptr %r, ptr %c, ptr {values})"
    status = f.let(call)
    size = 8 * n * lanes
    f.do(f"call void @llvm.memcpy.p0.p0.i64(ptr %out, ptr {values}, i64 {size}, i1 false)")
    after = f.at(values, str(n * lanes))
    g = Function("prepare", "void", "ptr %p, ptr %c", "|nounwind")
    g.do(f"call void {of(shared, 'prepare')}(ptr %p, ptr %c)")
    for k in range(columns):
        first, c = str((n + k) * lanes), str(own + k * part)
        places = [f.at("%x", first), after, f.at("%c", c), f.at("%out", first)]
        arguments = ", ".join(f"ptr {place}" for place in ("%t", *places, "@steps"))
        both = f.let(f"call i64 {of(column, 'strided')}({arguments})")
        status = f.let(f"or i32 {status}, {f.let(f'trunc i64 {both} to i32')}")
        numbers = [float(one) for one in split.directions[:, k] for _ in range(lanes)]
        items = ", ".join(f"double {one!r}" for one in numbers)
        if numbers:
            lines.append(f"@direction.{k} = private constant [{len(numbers)} x double] [{items}]")
        direction = f"@direction.{k}" if numbers else "null"
        g.do(f"call void {of(column, 'prepare')}(ptr {direction}, ptr {g.at('%c', c)})")
    f.do(f"ret i32 {status}")
    g.do("ret void")
    lines.append("declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)\n")
    return "\n".join([*lines, f.text(), g.text()])
