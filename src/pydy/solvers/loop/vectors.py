"""Eight numbers at once, in compiled code: the type `Block`, its arithmetic, and masks.

numba's own Python knows scalars and arrays. Here it learns a block, a vector register or two of the
processor, so that code for eight trajectories reads like code for one::

    error = load(errors, i) / (atol + rtol * maximum(absolute(old), absolute(new)))
    size = where(error < 1.0, longer, shorter)

Every operation works place by place: no place's result depends on its neighbours.
"""

from __future__ import annotations

import math
import operator
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import lower_builtin, models, register_model
from numba.np.arrayobj import make_array

from pydy.solvers.loop.intrinsics import intrinsic
from pydy.solvers.tuning import BLOCK

__all__ = [
    "absolute",
    "bits",
    "ceiling",
    "gather",
    "load",
    "mask_of",
    "maximum",
    "minimum",
    "power",
    "root",
    "splat",
    "store",
    "where",
]

_DOUBLE, _LONG, _INT = ir.DoubleType(), ir.IntType(64), ir.IntType(32)
_DOUBLES = ir.VectorType(_DOUBLE, BLOCK)
_LONGS = ir.VectorType(_LONG, BLOCK)
_INTS = ir.VectorType(_INT, BLOCK)
_FLAGS = ir.VectorType(ir.IntType(1), BLOCK)


class _Type(types.Type):
    def __init__(self, name: str) -> None:
        super().__init__(name=name)


class _BlockType(_Type):
    pass


class _MaskType(_Type):
    pass


block, mask = _BlockType("Block"), _MaskType("Mask")


@register_model(_BlockType)
class _BlockModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _DOUBLES)  # type: ignore[no-untyped-call]


@register_model(_MaskType)
class _MaskModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _FLAGS)  # type: ignore[no-untyped-call]


def _spread(builder: Any, value: Any, kind: Any = _DOUBLES) -> Any:
    """Return a vector of one number, unless it is a vector already."""
    if value.type == kind:
        return value
    one = builder.insert_element(ir.Constant(kind, ir.Undefined), value, _INT(0))
    return builder.shuffle_vector(one, one, ir.Constant(_INTS, [0] * BLOCK))


def _all(value: float) -> Any:
    return ir.Constant(_DOUBLES, [value] * BLOCK)


def _call(builder: Any, name: str, *arguments: Any) -> Any:
    kind = ir.FunctionType(_DOUBLES, [_DOUBLES] * len(arguments))
    function = cgutils.get_or_insert_function(builder.module, kind, f"llvm.{name}.v{BLOCK}f64")
    return builder.call(function, arguments)


# -- operators ------------------------------------------------------------------------------------


def _define(operation: Any, result: Any, operands: Any, build: Any) -> None:
    """Teach numba one operator for some pairs of operands."""

    def lower(context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        if operands[0][0] is mask:
            return build(builder, *arguments)
        return build(builder, *(_spread(builder, a) for a in arguments))

    for kinds in operands:
        lower_builtin(operation, *kinds)(lower)
    cases = [signature(result, *kinds) for kinds in operands]
    infer_global(operation)(type("_Template", (ConcreteTemplate,), {"cases": cases}))


_PAIRS = ((block, block), (block, types.float64), (types.float64, block))
for _operation, _name in (
    (operator.add, "fadd"),
    (operator.sub, "fsub"),
    (operator.mul, "fmul"),
    (operator.truediv, "fdiv"),
):
    _define(_operation, block, _PAIRS, lambda b, x, y, name=_name: getattr(b, name)(x, y))
for _operation, _name in (
    (operator.lt, "<"),
    (operator.le, "<="),
    (operator.gt, ">"),
    (operator.ge, ">="),
    (operator.eq, "=="),
):
    _define(_operation, mask, _PAIRS, lambda b, x, y, name=_name: b.fcmp_ordered(name, x, y))
for _operation, _name in ((operator.and_, "and_"), (operator.or_, "or_")):
    _define(_operation, mask, ((mask, mask),), lambda b, x, y, name=_name: getattr(b, name)(x, y))
_define(operator.invert, mask, ((mask,),), lambda b, x: b.not_(x))


# -- functions ------------------------------------------------------------------------------------


def _block_at(context: Any, builder: Any, kind: Any, array: Any, k: Any) -> Any:
    data = make_array(kind)(context, builder, array).data
    place = builder.mul(k, k.type(BLOCK))
    return builder.bitcast(builder.gep(data, [place]), _DOUBLES.as_pointer())


@intrinsic
def load(typingctx, array, k):
    """Return block k of a contiguous array."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        value = builder.load(_block_at(context, builder, signature.args[0], *arguments))
        value.align = 8
        return value

    return block(array, types.intp), codegen


@intrinsic
def store(typingctx, array, k, value):
    """Write block k of a contiguous array."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        array, k, value = arguments
        where = _block_at(context, builder, signature.args[0], array, k)
        builder.store(value, where).align = 8
        return context.get_dummy_value()

    return types.void(array, types.intp, block), codegen


@intrinsic
def gather(typingctx, array, places):
    """Return the numbers at some places, a block of whole floats, of a contiguous array."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        data = make_array(signature.args[0])(context, builder, arguments[0]).data
        result = ir.Constant(_DOUBLES, ir.Undefined)
        for k in range(BLOCK):
            place = builder.fptosi(builder.extract_element(arguments[1], _INT(k)), _LONG)
            value = builder.load(builder.gep(data, [place]))
            result = builder.insert_element(result, value, _INT(k))
        return result

    return block(array, block), codegen


@intrinsic
def splat(typingctx, value):
    """Return a block of one number."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _spread(builder, arguments[0])

    return block(types.float64), codegen


def _choose(builder: Any, comparison: str, x: Any, y: Any) -> Any:
    return builder.select(builder.fcmp_ordered(comparison, x, y), x, y)


@intrinsic
def maximum(typingctx, x, y):
    """Return the larger of two, y where either is NaN."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _choose(builder, ">", *(_spread(builder, a) for a in arguments))

    return block(x, y), codegen


@intrinsic
def minimum(typingctx, x, y):
    """Return the smaller of two, y where either is NaN."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _choose(builder, "<", *(_spread(builder, a) for a in arguments))

    return block(x, y), codegen


@intrinsic
def where(typingctx, condition, x, y):
    """Return x where a mask is true, else y."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.select(arguments[0], *(_spread(builder, a) for a in arguments[1:]))

    return block(mask, x, y), codegen


def _of_one(name: str, doc: str) -> Any:
    def function(typingctx, x):
        def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return _call(builder, name, arguments[0])

        return block(block), codegen

    function.__doc__ = doc
    return intrinsic(function)


absolute = _of_one("fabs", "Return the absolute values.")
root = _of_one("sqrt", "Return the square roots.")
ceiling = _of_one("ceil", "Return the smallest whole numbers not below.")


@intrinsic
def bits(typingctx, condition):
    """Return a mask as an integer, bit k for place k."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.zext(builder.bitcast(arguments[0], ir.IntType(BLOCK)), _LONG)

    return types.int64(mask), codegen


@intrinsic
def mask_of(typingctx, flags):
    """Return the mask of an integer's lowest bits."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.bitcast(builder.trunc(arguments[0], ir.IntType(BLOCK)), _FLAGS)

    return mask(types.int64), codegen


_LOWEST = 0x3FE6A09E667F3BCD  # the bits of √½
_LOGARITHM = tuple(2.0 / math.log(2.0) / k for k in (9, 7, 5, 3, 1))  # of artanh, in z²
_EXPONENTIAL = tuple(math.log(2.0) ** k / math.factorial(k) for k in range(7, -1, -1))


@intrinsic
def power(typingctx, x, exponent):
    """Return x to a power, to eight digits, for positive and normal x.

    A step size needs no more, and the library's function takes longer than a whole step. With x =
    2^k m, √½ ≤ m < √2, and z = (m − 1) / (m + 1), log2 x = k + 2 artanh(z) / ln 2.
    """

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        def polynomial(coefficients: tuple[float, ...], variable: Any) -> Any:
            total = _all(coefficients[0])
            for coefficient in coefficients[1:]:
                total = _call(builder, "fma", total, variable, _all(coefficient))
            return total

        places = ir.Constant(_LONGS, [52] * BLOCK)
        as_bits = builder.bitcast(arguments[0], _LONGS)
        above = builder.sub(as_bits, ir.Constant(_LONGS, [_LOWEST] * BLOCK))
        k = builder.ashr(above, places)
        m = builder.bitcast(builder.sub(as_bits, builder.shl(k, places)), _DOUBLES)
        z = builder.fdiv(builder.fsub(m, _all(1.0)), builder.fadd(m, _all(1.0)))
        series = builder.fmul(polynomial(_LOGARITHM, builder.fmul(z, z)), z)
        logarithm = builder.fadd(builder.sitofp(builder.trunc(k, _INTS), _DOUBLES), series)
        y = builder.fmul(logarithm, _spread(builder, arguments[1]))
        y = _choose(builder, "<", _choose(builder, ">", y, _all(-1000.0)), _all(1000.0))
        whole = _call(builder, "rint", y)
        fraction = polynomial(_EXPONENTIAL, builder.fsub(y, whole))
        scale = builder.shl(builder.sext(builder.fptosi(whole, _INTS), _LONGS), places)
        return builder.bitcast(builder.add(builder.bitcast(fraction, _LONGS), scale), _DOUBLES)

    return block(block, types.float64), codegen
