"""What numba's Python cannot say: calls of code by address, and sums in vector registers."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic as _intrinsic

__all__ = ["BLOCK", "address_of", "call_kernel", "combine", "nested"]

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
def combine(typingctx, y, x, h, stages, offsets, weights, count, blocks):
    """Compute ``y = x + h * sum(weights[j] * stages[offsets[j]:])`` for `blocks` blocks.

    `y`, `x`, `h` (one block), `stages`, `offsets` (int64) and `weights` are addresses. Products are
    fused with their sums, in order: the same bits for every block, whatever its neighbours.
    """

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        y, x, h, stages, offsets, weights, count, blocks = arguments
        kind = ir.FunctionType(_BLOCK, [_BLOCK] * 3)
        fma = cgutils.get_or_insert_function(builder.module, kind, f"llvm.fma.v{BLOCK}f64")
        step = _load(builder, _pointer(builder, h, _BLOCK))
        offsets = _pointer(builder, offsets, _INT)
        weights = _pointer(builder, weights, _DOUBLE)
        stages = _pointer(builder, stages, _DOUBLE)
        zero = ir.Constant(_BLOCK, [0.0] * BLOCK)
        total = cgutils.alloca_once(builder, _BLOCK)
        with cgutils.for_range(builder, blocks) as outer:
            builder.store(zero, total)
            start = builder.mul(outer.index, _INT(BLOCK))
            with cgutils.for_range(builder, count) as inner:
                weight = builder.load(builder.gep(weights, [inner.index]))
                offset = builder.load(builder.gep(offsets, [inner.index]))
                where = builder.gep(stages, [builder.add(offset, start)])
                stage = _load(builder, builder.bitcast(where, _BLOCK.as_pointer()))
                splat = _splat(builder, weight)
                builder.store(builder.call(fma, [splat, stage, builder.load(total)]), total)
            base = _load(builder, _block_at(builder, x, start))
            result = builder.call(fma, [step, builder.load(total), base])
            store = builder.store(result, _block_at(builder, y, start))
            store.align = 8
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
