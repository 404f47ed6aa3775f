"""What numba's Python cannot say: calls of code by address, and sums in vector registers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic as _intrinsic

from pydy.solvers.run.layout import COLUMNS
from pydy.solvers.tuning import BLOCK

__all__ = [
    "address_of",
    "array_of_row",
    "call_kernel",
    "call_part",
    "call_prepare",
    "combine",
    "fused",
    "get",
    "intrinsic",
    "lowest_bit",
    "nested",
    "numbers_at",
    "put",
]

intrinsic: Any = _intrinsic  # what it returns is called from compiled code only

_DOUBLE = ir.DoubleType()
_INT = ir.IntType(64)
_BLOCK = ir.VectorType(_DOUBLE, BLOCK)


def _pointer(builder: Any, address: Any, kind: Any) -> Any:
    return builder.inttoptr(address, kind.as_pointer())


@intrinsic
def call_kernel(typingctx, address, t, x, r, c, out):
    """Call ``int32 kernel(t, x, r, c, out)``; every argument is an address."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        pointer = _DOUBLE.as_pointer()
        kind = ir.FunctionType(ir.IntType(32), [pointer] * 5)
        function = _pointer(builder, arguments[0], kind)
        return builder.call(function, [_pointer(builder, a, _DOUBLE) for a in arguments[1:]])

    return types.int32(*[types.intp] * 6), codegen


@intrinsic
def call_prepare(typingctx, address, p, c):
    """Call ``void prepare(p, c)``; every argument is an address."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        kind = ir.FunctionType(ir.VoidType(), [_DOUBLE.as_pointer()] * 2)
        function = _pointer(builder, arguments[0], kind)
        builder.call(function, [_pointer(builder, a, _DOUBLE) for a in arguments[1:]])
        return context.get_dummy_value()

    return types.void(*[types.intp] * 3), codegen


@intrinsic
def call_part(typingctx, address, table, t, last):
    """Call what `compiled.part` compiled: by its address, with that of a table of arrays."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        function, *rest = arguments
        kind = ir.FunctionType(_INT, [value.type for value in rest])
        return builder.call(_pointer(builder, function, kind), rest)

    return types.int64(types.intp, types.intp, types.float64, last), codegen


_TOGETHER = 4  # sums that grow side by side hide each other's latency, and share the weights


def _combine_function(module: ir.Module) -> ir.Function:
    """Return the function behind `combine`, one for all of a module's calls."""
    kind = ir.FunctionType(ir.VoidType(), [_INT] * 9)
    function = cgutils.get_or_insert_function(module, kind, "pydy_combine")
    if not function.is_declaration:
        return function
    builder = _begin(function)
    y, x, h, stages, offsets, weights, count, further, blocks = function.args
    three = ir.FunctionType(_BLOCK, [_BLOCK] * 3)
    fma = cgutils.get_or_insert_function(module, three, f"llvm.fma.v{BLOCK}f64")
    step = _load(builder, _pointer(builder, h, _BLOCK))
    offsets = _pointer(builder, offsets, _INT)
    weights = _pointer(builder, weights, _DOUBLE)
    stages = _pointer(builder, stages, _DOUBLE)
    zero = ir.Constant(_BLOCK, [0.0] * BLOCK)
    totals = [cgutils.alloca_once(builder, _BLOCK) for _ in range(_TOGETHER)]

    def write(first: Any, number: int) -> None:
        """Write some blocks from `first` on."""
        start = builder.mul(first, _INT(BLOCK))
        starts = [builder.add(start, _INT(BLOCK * k)) for k in range(number)]

        def add(term: Any, factor: Any) -> None:
            """Add a term, its weight times `factor`, to the totals."""
            weight = _splat(builder, builder.load(builder.gep(weights, [term])))
            weight = weight if factor is None else builder.fmul(factor, weight)
            offset = builder.load(builder.gep(offsets, [term]))
            where = builder.gep(stages, [builder.add(offset, start)])
            where = builder.bitcast(where, _BLOCK.as_pointer())
            for k, total in enumerate(totals[:number]):
                stage = _load(builder, builder.gep(where, [_INT(k)]))
                builder.store(builder.call(fma, [weight, stage, builder.load(total)]), total)

        for total in totals[:number]:
            builder.store(zero, total)
        with cgutils.for_range(builder, count) as inner:
            add(inner.index, None)
        for begin, total in zip(starts, totals, strict=False):
            base = _load(builder, _block_at(builder, x, begin))
            builder.store(builder.call(fma, [step, builder.load(total), base]), total)
        with cgutils.for_range(builder, further) as inner:
            add(builder.add(count, inner.index), step)
        for begin, total in zip(starts, totals, strict=False):
            builder.store(builder.load(total), _block_at(builder, y, begin)).align = 8

    _in_groups(builder, blocks, write)
    builder.ret_void()
    return function


@intrinsic
def combine(typingctx, y, x, h, stages, offsets, weights, count, further, blocks):
    """Compute ``y = x + h * sum(weights[j] * stages[offsets[j]:])`` for `blocks` blocks.

    The sum is that of `count` terms; `further` ones, each times h, are added to y afterwards. `y`,
    `x`, `h` (one block), `stages`, `offsets` (int64) and `weights` are addresses. Products are
    fused with their sums, in order: the same bits for every block, whatever its neighbours.
    """

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        builder.call(_combine_function(builder.module), arguments)
        return context.get_dummy_value()

    return types.void(*[types.intp] * 9), codegen


def _nested_function(module: ir.Module) -> ir.Function:
    """Return the function behind `nested`, one for all of a module's calls."""
    kind = ir.FunctionType(ir.VoidType(), [_INT] * 7)
    function = cgutils.get_or_insert_function(module, kind, "pydy_nested")
    if not function.is_declaration:
        return function
    builder = _begin(function)
    y, x, parts, length, depth, theta, blocks = function.args
    near = _load(builder, _pointer(builder, theta, _BLOCK))
    far = builder.fsub(ir.Constant(_BLOCK, [1.0] * BLOCK), near)
    parts = _pointer(builder, parts, _DOUBLE)
    totals = [cgutils.alloca_once(builder, _BLOCK) for _ in range(_TOGETHER)]

    three = ir.FunctionType(_BLOCK, [_BLOCK] * 3)
    fma = cgutils.get_or_insert_function(module, three, f"llvm.fma.v{BLOCK}f64")

    def write(first: Any, number: int) -> None:
        start = builder.mul(first, _INT(BLOCK))

        def part(level: Any, k: int) -> Any:
            place = builder.add(builder.mul(level, length), start)
            where = builder.bitcast(builder.gep(parts, [place]), _BLOCK.as_pointer())
            return _load(builder, builder.gep(where, [_INT(k)]))

        last = builder.sub(depth, _INT(1))
        for k, total in enumerate(totals[:number]):
            builder.store(part(last, k), total)
        with cgutils.for_range(builder, last) as inner:
            level = builder.sub(builder.sub(last, _INT(1)), inner.index)
            weight = builder.select(builder.trunc(level, ir.IntType(1)), near, far)
            for k, total in enumerate(totals[:number]):
                builder.store(
                    builder.call(fma, [weight, builder.load(total), part(level, k)]), total
                )
        for k, total in enumerate(totals[:number]):
            begin = builder.add(start, _INT(BLOCK * k))
            base = _load(builder, _block_at(builder, x, begin))
            result = builder.call(fma, [near, builder.load(total), base])
            builder.store(result, _block_at(builder, y, begin)).align = 8

    _in_groups(builder, blocks, write)
    builder.ret_void()
    return function


@intrinsic
def nested(typingctx, y, x, parts, length, depth, theta, blocks):
    """Compute ``y = x + θ (F0 + (1 − θ)(F1 + θ (F2 + …)))`` for `blocks` blocks.

    `y`, `x`, `parts`, where `depth` vectors F lie `length` numbers apart, and `theta`, one block,
    are addresses.
    """

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        builder.call(_nested_function(builder.module), arguments)
        return context.get_dummy_value()

    return types.void(*[types.intp] * 7), codegen


@intrinsic
def fused(typingctx, a, b, c):
    """Return a b + c, rounded once on every processor."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.fma(*arguments)

    return types.float64(*[types.float64] * 3), codegen


@intrinsic
def put(typingctx, place, value):
    """Write a number at an address.

    The store is atomic, an ordinary one to the processor, so that LLVM does not make scatters of
    loops over a few numbers.
    """

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place, value = arguments
        builder.store_atomic(value, _pointer(builder, place, _DOUBLE), "unordered", 8)
        return context.get_dummy_value()

    return types.void(types.intp, types.float64), codegen


@intrinsic
def get(typingctx, place):
    """Return the number at an address."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.load(_pointer(builder, arguments[0], _DOUBLE))

    return types.float64(types.intp), codegen


@intrinsic
def lowest_bit(typingctx, bits):
    """Return the place of the lowest bit of an integer that is not zero."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.cttz(arguments[0], ir.IntType(1)(1))

    return types.intp(types.int64), codegen


def _begin(function: ir.Function) -> ir.IRBuilder:
    """Return a builder for a function that its module keeps to itself, and calls."""
    function.linkage = "internal"
    function.attributes.add("noinline")
    return ir.IRBuilder(function.append_basic_block())


def _in_groups(builder: Any, blocks: Any, write: Callable[[Any, int], None]) -> None:
    """Call ``write(first, number)`` for all blocks, several together as long as there are."""
    groups = builder.udiv(blocks, _INT(_TOGETHER))
    together = builder.mul(groups, _INT(_TOGETHER))
    with cgutils.for_range(builder, groups) as outer:
        write(builder.mul(outer.index, _INT(_TOGETHER)), _TOGETHER)
    with cgutils.for_range(builder, builder.sub(blocks, together)) as outer:
        write(builder.add(together, outer.index), 1)


def _splat(builder: Any, value: Any) -> Any:
    one = builder.insert_element(ir.Constant(_BLOCK, ir.Undefined), value, ir.IntType(32)(0))
    mask = ir.Constant(ir.VectorType(ir.IntType(32), BLOCK), [0] * BLOCK)
    return builder.shuffle_vector(one, one, mask)


def _load(builder: Any, pointer: Any) -> Any:
    value = builder.load(pointer)
    value.align = 8
    return value


def _block_at(builder: Any, address: Any, start: Any) -> Any:
    where = builder.gep(_pointer(builder, address, _DOUBLE), [start])
    return builder.bitcast(where, _BLOCK.as_pointer())


@intrinsic
def address_of(typingctx, array, index):
    """Return the address of ``array[index]`` for a contiguous array of 8-byte numbers."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        from numba.np.arrayobj import make_array

        data = make_array(signature.args[0])(context, builder, arguments[0]).data
        start = builder.ptrtoint(data, _INT)
        return builder.add(start, builder.mul(arguments[1], _INT(8)))

    return types.intp(array, types.intp), codegen


def array_of_row(kind: Any, table: Any, k: int, context: Any, builder: Any) -> Any:
    """Return the array of row k of a table of addresses, in an intrinsic."""
    row = builder.gep(_pointer(builder, table, _INT), [_INT(COLUMNS * k)])
    words = [builder.load(builder.gep(row, [_INT(j)])) for j in range(1 + kind.ndim)]
    return _array(kind, kind.dtype.bitwidth // 8, words[0], words[1:], context, builder)


def _array(kind: Any, size: int, place: Any, shape: Any, context: Any, builder: Any) -> Any:
    """Return the array at an address.

    numba's `carray` needs functions that return arrays, which ours, without reference counts,
    cannot be.
    """
    from numba.np.arrayobj import make_array, populate_array

    array = make_array(kind)(context, builder)
    steps = [_INT(size)]
    if len(shape) == 2:
        steps.insert(0, builder.mul(shape[1], _INT(size)))
    populate_array(
        array,
        data=builder.inttoptr(place, array.data.type),
        shape=shape,
        strides=steps,
        itemsize=_INT(size),
        meminfo=None,
    )
    return array._getvalue()


@intrinsic
def numbers_at(typingctx, place, count):
    """Return the floats at an address."""
    kind = types.Array(types.float64, 1, "C")

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _array(kind, 8, arguments[0], [arguments[1]], context, builder)

    return kind(types.intp, types.intp), codegen
