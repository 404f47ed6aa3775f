"""The default back end: straight-line LLVM IR for a Program, compiled in the process.

No compiler is needed on the user's machine.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, cast

from pydy._backends.llvm.columns import compile_columns
from pydy._backends.llvm.compiling import Source
from pydy._backends.llvm.emit import BRANCH_WEIGHTS
from pydy._backends.llvm.ir import WIDTHS, Function
from pydy._backends.llvm.native import Entry, native_kernel
from pydy._backends.llvm.targets import target
from pydy._backends.llvm.text import KERNEL_PARAMETERS, module_text, prepare_text, stage_text
from pydy._backends.llvm.tiers import Tiers, calls_routines, tiers_of, wide_code
from pydy._backends.registry import compile_program
from pydy._graph.jacobian_columns import JacobianColumns
from pydy._graph.program import Program
from pydy._graph.split import SplitProgram
from pydy._kernel import Kernel

# -- Jacobians in vector registers: the columns of each part of a `JacobianColumns` side by side ---
# One module: the shared part for one state; a function for each part, which takes as many columns
# at once as a register holds doubles, reads a row of unit vectors as a vector and spreads each
# shared value over the columns; and a `kernel` that calls them. The last columns of a part that
# are no whole vector are computed together with some before them, once more.


def compile_jacobian(jacobian: JacobianColumns) -> Kernel:
    """Return the Kernel of a Jacobian in parts, compiled when it is first called."""
    source = Source(f"jacobian {jacobian.digest}", _Text(jacobian), ("kernel", "prepare"))
    widths = {1} if calls_routines(jacobian.shared) else set()
    widths |= {_width(p.count) for p in jacobian.parts if calls_routines(p.program)}
    entry = Entry(Tiers(source, tuple(sorted(widths))))
    return native_kernel(cast("Program", jacobian), entry, 1, compile_jacobian, ())


@dataclass(frozen=True)
class _Text:
    """The IR of a Jacobian; pickled as bytes, as that of a Program."""

    jacobian: JacobianColumns

    def __call__(self, brief: bool) -> str:
        return _text(self.jacobian, brief)

    def __reduce__(self) -> tuple[Any, ...]:
        return _read_text, (self.jacobian.to_bytes(),)


def _read_text(data: bytes) -> _Text:
    return _Text(JacobianColumns.from_bytes(data))


def _width(columns: int) -> int:
    """Return how many columns are taken at a time."""
    most = min(columns, target().registers.widest)
    return max(width for width in WIDTHS if width <= most)


def _text(jacobian: JacobianColumns, brief: bool) -> str:
    shared, (rows, columns) = jacobian.shared, jacobian.shape
    functions = [
        prepare_text(shared, 1, brief),
        stage_text(shared, 1, brief, "shared", linkage="internal"),
    ]
    tables = []
    f = Function("kernel", "i32", KERNEL_PARAMETERS, "|nounwind")
    values = f.slot("double", max(len(shared.outputs), 1))
    arguments = ", ".join(f"ptr {name}" for name in ("%t", "%x", "%r", "%c", values))
    status = f.let(f"call i32 @shared({arguments})")
    if sum(part.count for part in jacobian.parts) < columns:
        size = 8 * rows * columns
        f.do(f"call void @llvm.memset.p0.i64(ptr %out, i8 0, i64 {size}, i1 false)")
        tables.append("declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)")
    for k, part in enumerate(jacobian.parts):
        width, name = _width(part.count), f"part.{k}"
        steps = {"%x": -1, "%out": columns}
        functions.append(stage_text(part.program, width, brief, name, steps, "internal"))
        # A row of the unit matrix is the one above, moved by a place.
        units, row = f"@units.{part.count}", [0.0] * (2 * part.count)
        row[part.count] = 1.0
        numbers = ", ".join(f"double {number}" for number in row)
        tables.append(f"{units} = private constant [{len(row)} x double] [{numbers}]")
        for start in (*range(0, part.count - width, width), part.count - width):
            places = ("%t", f.at(units, str(part.count + start)), values, "%c")
            arguments = ", ".join(f"ptr {place}" for place in places)
            out = f.at("%out", str(part.first + start))
            bad = f.let(f"call i32 @{name}({arguments}, ptr {out})")
            status = f.let(f"or i32 {status}, {bad}")
    failed = f.let(f"icmp ne i32 {status}, 0")
    f.do(f"ret i32 {f.let(f'zext i1 {failed} to i32')}")
    made = [(shared, 1), *((part.program, _width(part.count)) for part in jacobian.parts)]
    body = "\n".join([*dict.fromkeys(tables), *functions, f.text(), *BRANCH_WEIGHTS, ""])
    return module_text(body, made)


# -- The back end ----------------------------------------------------------------------------------


class LLVMBackend:
    """Compiles Programs with LLVM.

    Parameters
    ----------
    cse : bool, optional
        Accepted for scripts that pass it; common sub-expressions are always shared.
    lanes : {1, 2, 4, 8}, optional
        How many states the native code takes at once. Right-hand sides for Python need 1.
    width : {2, 4, 8}, optional
        How many of several lanes the equations' code takes at once; the rest follow in further
        turns. By default what suits the processor's registers. It does not change the bits.
    """

    def __init__(self, cse: bool = True, lanes: int = 1, width: int | None = None) -> None:
        if lanes not in WIDTHS:
            raise ValueError(f"`lanes` is {lanes!r}, but it must be 1, 2, 4 or 8.")
        if width is not None and (width not in WIDTHS[1:] or width > lanes):
            raise ValueError(f"`width` is {width!r}, but it must be 2, 4 or 8 and at most `lanes`.")
        self.options: dict[str, Any] = {"cse": cse, "lanes": lanes}
        if width is not None:
            self.options["width"] = width

    def compile(self, program: Program) -> Kernel:
        """Return the Kernel of a Program.

        Nothing is compiled before the Kernel is called or asked for its best code; see `tiers`.
        Wide kernels get the best at once.
        """
        lanes: int = self.options["lanes"]
        recipe = ("llvm", self.options)
        if lanes == 1:
            return native_kernel(program, Entry(tiers_of(program)), 1, compile_program, recipe)
        code = wide_code(program, lanes, self.options.get("width"))
        entry = Entry()
        entry.replace((code.addresses["kernel"], code.addresses["prepare"]), code)
        strided = code.addresses["strided"]
        return native_kernel(program, entry, lanes, compile_program, recipe, strided)

    def compile_jacobian(self, jacobian: JacobianColumns) -> Kernel:
        """Return the Kernel of a Jacobian, with several columns at a time."""
        return compile_jacobian(jacobian)

    def compile_columns(self, split: SplitProgram) -> Kernel:
        """Return the Kernel of states and sensitivities, with several columns at a time."""
        return compile_columns(split)
