"""The IR of a Tangent: a function for the shared part and for each other, and what calls them.

With one lane a part takes as many columns at once as a register holds numbers: it reads a row of
seeds as a vector and spreads each shared value over the columns. The last columns of a part that
are no whole vector are computed together with some before them, once more; where there are fewer,
memory with room for a vector stands between. With several lanes these are states, and a part takes
one column after the other.

The array c holds the constants of the shared part, then those of each vector of columns.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy._backends.llvm.emit import BRANCH_WEIGHTS
from pydy._backends.llvm.ir import WIDTHS, Function
from pydy._backends.llvm.plan import Layout
from pydy._backends.llvm.targets import target
from pydy._backends.llvm.text import KERNEL, PREPARE, module_text, prepare_text, stage_text
from pydy._graph.program import Program
from pydy._graph.tangent import Part, Tangent


def pieces(program: Program | Tangent, lanes: int) -> list[tuple[Program, int]]:
    """Return the Programs that code is made of, with how many lanes or columns each takes at once.

    Those of a Tangent are the shared part and the others.
    """
    if isinstance(program, Program):
        return [(program, lanes)]
    widest = target().registers.widest
    own = min(lanes, widest)
    counts = [own if lanes > 1 else min(part.count, widest) for part in program.parts]
    widths = [next(width for width in WIDTHS if width >= count) for count in counts]
    programs = [program.shared, *(part.program for part in program.parts)]
    return [*zip(programs, (own, *widths), strict=True)]


def tangent_text(tangent: Tangent, lanes: int, brief: bool) -> str:
    """Return the module of a Tangent, with the functions `kernel` and `prepare`."""
    return _Text(tangent, lanes, brief).module()


class _Text:
    def __init__(self, tangent: Tangent, lanes: int, brief: bool) -> None:
        self.tangent, self.lanes, self.brief = tangent, lanes, brief
        self.pieces = pieces(tangent, lanes)
        self.kernel = Function("kernel", "i32", KERNEL, "|nounwind")
        self.prepare = Function("prepare", "void", PREPARE, "|nounwind")
        self.status = "0"
        self.functions: list[str] = []
        self.tables: dict[str, str] = {}
        self.values = ""
        self.carried = lanes * len(tangent.shared.carried)  # where the next constants lie in c

    def module(self) -> str:
        """Return the module."""
        tangent, lanes, f = self.tangent, self.lanes, self.kernel
        self._shared()
        f.do(self._memory("cpy.p0.p0", "%out", f"ptr {self.values}", tangent.values * lanes))
        rows, columns = tangent.shape
        if sum(part.count for part in tangent.parts) < columns:
            out = f.at("%out", str(tangent.values * lanes))
            f.do(self._memory("set.p0", out, "i8 0", rows * columns * lanes))
        for part, (_, width) in zip(tangent.parts, self.pieces[1:], strict=True):
            self._part(part, width)
        f.do(f"ret i32 {self.status}")
        self.prepare.do("ret void")
        texts = [f.text(), self.prepare.text(), *BRANCH_WEIGHTS, ""]
        declared = [
            "declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)",
            "declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)",
        ]
        body = "\n".join([*declared, *self.tables.values(), *self.functions, *texts])
        return module_text(body, self.pieces)

    def _memory(self, what: str, place: str, source: str, count: int) -> str:
        return f"call void @llvm.mem{what}.i64(ptr {place}, {source}, i64 {8 * count}, i1 false)"

    def _table(self, name: str, numbers: Sequence[float]) -> str:
        """Return the name of an array of numbers."""
        items = ", ".join(f"double {number!r}" for number in numbers)
        kind = f"[{len(numbers)} x double]"
        self.tables[name] = f"@{name} = private constant {kind} [{items}]"
        return f"@{name}"

    def _call(self, name: str, lane: int, *places: str) -> None:
        """Call a function whose first lane is that one of the kernel."""
        f = self.kernel
        arguments = ", ".join(f"ptr {place}" for place in places)
        bad = f.let(f"call i32 @{name}({arguments})")
        if self.lanes == 1:  # its lanes are columns
            bad = f.let(f"zext i1 {f.let(f'icmp ne i32 {bad}, 0')} to i32")
        self.status = f.let(f"or i32 {self.status}, {f.let(f'shl i32 {bad}, {lane}')}")

    def _shared(self) -> None:
        (program, width), lanes, f = self.pieces[0], self.lanes, self.kernel
        layout = Layout(dict.fromkeys(("%x", "%r", "%p", "%out"), lanes))
        self.functions += [
            prepare_text(program, width, self.brief, "shared.", layout=layout),
            stage_text(program, width, self.brief, "shared", layout),
        ]
        self.values = f.slot(f"<{lanes} x double>", max(len(program.outputs), 1))
        for lane in range(0, lanes, width):
            first, c = str(lane), str(lane * len(program.carried))
            places = [f.at(f"%{name}", first) for name in "txr"]
            self._call("shared", lane, *places, f.at("%c", c), f.at(self.values, first))
            p, own = self.prepare.at("%p", first), self.prepare.at("%c", c)
            self.prepare.do(f"call void @shared.prepare(ptr {p}, ptr {own})")

    def _part(self, part: Part, width: int) -> None:
        tangent, lanes, f, name = self.tangent, self.lanes, self.kernel, f"part.{part.first}"
        (rows, columns), given = tangent.shape, tangent.directions is not None
        single, few = lanes == 1, lanes == 1 and part.count < width
        row = width if few else columns * lanes
        # A row of the unit matrix is the one above, moved by a place.
        steps = {"%x": row if given else -1, "%out": row, "%r": lanes}
        spread = ["%r"] if single else ["%p", *([] if given else ["%x"])]
        layout = Layout(steps if single else {**steps, "%p": 1}, spread)
        self.functions += [
            prepare_text(part.program, width, self.brief, f"{name}.", layout=layout),
            stage_text(part.program, width, self.brief, name, layout),
        ]
        after, begin = tangent.values * lanes, tangent.shared.num_states * lanes
        starts = [*range(0, part.count, width if single else 1)]
        if single and not few:
            starts[-1] = part.count - width
        for start in starts:
            column, c = part.first + start, self.carried
            self.carried += width * len(part.program.carried)
            if part.program.carried:
                self._direction(part, column, width, c)
            for lane in range(0, lanes, 1 if single else width):
                place = column * lanes + lane
                x, out = f.at("%x", str(begin + place)), f.at("%out", str(after + place))
                if not given:
                    row_of_units = [0.0] * (2 * part.count + width)
                    row_of_units[part.count] = 1.0
                    units = self._table(f"units.{part.count}.{width}", row_of_units)
                    x = f.at(units, str(part.count + start))
                values, own = f.at(self.values, str(after + lane)), f.at("%c", str(c))
                end = f.slot(f"<{width} x double>", rows) if few else out
                if few and given:
                    x = self._filled(x, part, width)
                self._call(name, lane, f.at("%t", str(lane)), x, values, own, end)
                if few:
                    self._copy(end, width, out, columns, (rows, part.count))

    def _filled(self, x: str, part: Part, width: int) -> str:
        """Return seeds in memory that has room for a vector in each row."""
        rows, columns = part.program.num_states, self.tangent.shape[1]
        filled = self.kernel.slot(f"<{width} x double>", rows)
        self.kernel.do(self._memory("set.p0", filled, "i8 0", width * rows))
        self._copy(x, columns, filled, width, (rows, part.count))
        return filled

    def _direction(self, part: Part, column: int, width: int, c: int) -> None:
        """Bind the directions of a vector of columns."""
        directions, g = self.tangent.directions, self.prepare
        assert directions is not None
        own = directions[:, column : column + (width if self.lanes == 1 else 1)]
        numbers = own
        if self.lanes == 1:
            numbers = np.pad(own, [(0, 0), (0, width - own.shape[1])])
        table = self._table(f"direction.{column}", numbers.ravel().tolist())
        place = g.at("%c", str(c))
        g.do(f"call void @part.{part.first}.prepare(ptr {table}, ptr {place})")

    def _copy(self, source: str, step: int, place: str, other: int, shape: tuple[int, int]) -> None:
        """Copy a table whose rows lie `step` apart to where they lie `other` apart."""
        f = self.kernel
        with f.loop("0", str(shape[0])) as i, f.loop("0", str(shape[1])) as j:
            here, there = (
                f.let(f"add i64 {f.let(f'mul i64 {i}, {distance}')}, {j}")
                for distance in (step, other)
            )
            f.store("double", f.load("double", source, here), place, there)
