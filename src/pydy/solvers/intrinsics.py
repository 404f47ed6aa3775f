"""What numba's Python cannot say: calls of code by address, and sums in vector registers."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic as _intrinsic

__all__ = ["BLOCK", "address_of", "call_kernel", "call_prepare", "combine", "nested"]

BLOCK = 8
"""Vectors are worked on in blocks of so many numbers, padded with zeros."""

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


_TOGETHER = 4  # sums that grow side by side hide each other's latency, and share the weights


def _combine_function(module: ir.Module) -> ir.Function:
    """Return the function behind `combine`, one for all of a module's calls."""
    kind = ir.FunctionType(ir.VoidType(), [_INT] * 8)
    function = cgutils.get_or_insert_function(module, kind, "pydy_combine")
    if not function.is_declaration:
        return function
    function.linkage = "internal"
    function.attributes.add("noinline")
    builder = ir.IRBuilder(function.append_basic_block())
    y, x, h, stages, offsets, weights, count, blocks = function.args
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
        for total in totals[:number]:
            builder.store(zero, total)
        with cgutils.for_range(builder, count) as inner:
            splat = _splat(builder, builder.load(builder.gep(weights, [inner.index])))
            offset = builder.load(builder.gep(offsets, [inner.index]))
            where = builder.gep(stages, [builder.add(offset, start)])
            where = builder.bitcast(where, _BLOCK.as_pointer())
            for k, total in enumerate(totals[:number]):
                stage = _load(builder, builder.gep(where, [_INT(k)]))
                builder.store(builder.call(fma, [splat, stage, builder.load(total)]), total)
        for begin, total in zip(starts, totals, strict=False):
            base = _load(builder, _block_at(builder, x, begin))
            result = builder.call(fma, [step, builder.load(total), base])
            builder.store(result, _block_at(builder, y, begin)).align = 8

    groups = builder.udiv(blocks, _INT(_TOGETHER))
    together = builder.mul(groups, _INT(_TOGETHER))
    with cgutils.for_range(builder, groups) as outer:
        write(builder.mul(outer.index, _INT(_TOGETHER)), _TOGETHER)
    with cgutils.for_range(builder, builder.sub(blocks, together)) as outer:
        write(builder.add(together, outer.index), 1)
    builder.ret_void()
    return function


@intrinsic
def combine(typingctx, y, x, h, stages, offsets, weights, count, blocks):
    """Compute ``y = x + h * sum(weights[j] * stages[offsets[j]:])`` for `blocks` blocks.

    `y`, `x`, `h` (one block), `stages`, `offsets` (int64) and `weights` are addresses. Products are
    fused with their sums, in order: the same bits for every block, whatever its neighbours.
    """

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        builder.call(_combine_function(builder.module), arguments)
        return context.get_dummy_value()

    return types.void(*[types.intp] * 8), codegen


@intrinsic
def nested(typingctx, y, x, parts, length, depth, theta, blocks):
    """Compute ``y = x + θ (F0 + (1 − θ)(F1 + θ (F2 + …)))`` for `blocks` blocks.

    `y`, `x` and `parts`, where `depth` vectors F lie `length` numbers apart, are addresses.
    """

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        y, x, parts, length, depth, theta, blocks = arguments
        near = _splat(builder, theta)
        far = _splat(builder, builder.fsub(_DOUBLE(1.0), theta))
        parts = _pointer(builder, parts, _DOUBLE)
        total = cgutils.alloca_once(builder, _BLOCK)
        with cgutils.for_range(builder, blocks) as outer:
            start = builder.mul(outer.index, _INT(BLOCK))
            builder.store(ir.Constant(_BLOCK, [0.0] * BLOCK), total)
            with cgutils.for_range(builder, depth) as inner:
                level = builder.sub(builder.sub(depth, _INT(1)), inner.index)
                where = builder.gep(parts, [builder.add(builder.mul(level, length), start)])
                part = _load(builder, builder.bitcast(where, _BLOCK.as_pointer()))
                odd = builder.trunc(level, ir.IntType(1))
                weight = builder.select(odd, far, near)
                builder.store(builder.fmul(weight, builder.fadd(part, builder.load(total))), total)
            base = _load(builder, _block_at(builder, x, start))
            store = builder.store(
                builder.fadd(base, builder.load(total)), _block_at(builder, y, start)
            )
            store.align = 8
        return context.get_dummy_value()

    arguments = [types.intp] * 5 + [types.float64, types.intp]
    return types.void(*arguments), codegen


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
