"""Eight numbers at once, in compiled code: the type `Block`, its arithmetic, and masks.

numba's own Python knows scalars and arrays. Here it learns a block, a vector register or two of the
processor, so that code for eight trajectories reads like code for one::

    error = item(errors, i, like) / (atol + rtol * maximum(absolute(old), absolute(new)))
    size = where(error < 1.0, longer, shorter)

The functions take floats as well, and give the same bits: what is written with them serves one
trajectory and eight. Every operation works place by place: no place's result depends on its
neighbours.
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
    "item",
    "load",
    "mask_of",
    "maximum",
    "minimum",
    "number",
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


def _same(builder: Any, *values: Any) -> Any:
    """Return floats as they are, or vectors of all if one is a vector."""
    if all(value.type == _DOUBLE for value in values):
        return values
    return [_spread(builder, value) for value in values]


def _kind(*kinds: Any) -> Any:
    """Return the type of what is computed of some: blocks, if one is a block."""
    return block if block in kinds else types.float64


def _alike(*kinds: Any) -> list[Any]:
    """Return the types of operands, a number's as a float's."""
    return [kind if kind == block else types.float64 for kind in kinds]


def _all(value: float | int, kind: Any = _DOUBLES) -> Any:
    """Return a constant, a vector of it if `kind` is one."""
    return ir.Constant(kind, [value] * BLOCK if isinstance(kind, ir.VectorType) else value)


def _call(builder: Any, name: str, *arguments: Any) -> Any:
    kind = arguments[0].type
    suffix = f"v{BLOCK}f64" if kind == _DOUBLES else "f64"
    function = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(kind, [kind] * len(arguments)), f"llvm.{name}.{suffix}"
    )
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


def _item_at(context: Any, builder: Any, kind: Any, array: Any, k: Any, one: Any) -> Any:
    """Return where item k of a contiguous array is: a block if `one` is one, else a float."""
    if one == block:
        return _block_at(context, builder, kind, array, k)
    return builder.gep(make_array(kind)(context, builder, array).data, [k])


@intrinsic
def load(typingctx, array, k):
    """Return block k of a contiguous array."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        value = builder.load(_block_at(context, builder, signature.args[0], *arguments))
        value.align = 8
        return value

    return block(array, types.intp), codegen


@intrinsic
def item(typingctx, array, k, like):
    """Return block k of a contiguous array if `like` is a block, float k if it is a float."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        array, k, _ = arguments
        where = _item_at(context, builder, signature.args[0], array, k, signature.args[2])
        value = builder.load(where)
        value.align = 8
        return value

    return _kind(like)(array, types.intp, *_alike(like)), codegen


@intrinsic
def store(typingctx, array, k, value):
    """Write item k, a block or a float as `value` is, of a contiguous array."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        array, k, value = arguments
        where = _item_at(context, builder, signature.args[0], array, k, signature.args[2])
        builder.store(value, where).align = 8
        return context.get_dummy_value()

    return types.void(array, types.intp, *_alike(value)), codegen


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


@intrinsic
def number(typingctx, value, like):
    """Return one number, a block of it if `like` is a block."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _same(builder, *arguments)[0]

    return _kind(like)(types.float64, *_alike(like)), codegen


def _choose(builder: Any, comparison: str, x: Any, y: Any) -> Any:
    return builder.select(builder.fcmp_ordered(comparison, x, y), x, y)


@intrinsic
def maximum(typingctx, x, y):
    """Return the larger of two, y where either is NaN."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _choose(builder, ">", *_same(builder, *arguments))

    return _kind(x, y)(*_alike(x, y)), codegen


@intrinsic
def minimum(typingctx, x, y):
    """Return the smaller of two, y where either is NaN."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _choose(builder, "<", *_same(builder, *arguments))

    return _kind(x, y)(*_alike(x, y)), codegen


@intrinsic
def where(typingctx, condition, x, y):
    """Return x where a condition is true, else y."""

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        vectors = signature.return_type == block
        choices = [_spread(builder, a) for a in arguments[1:]] if vectors else arguments[1:]
        return builder.select(arguments[0], *choices)

    result = block if condition == mask else _kind(x, y)
    return result(condition, *_alike(x, y)), codegen


def _of_one(name: str, doc: str) -> Any:
    def function(typingctx, x):
        def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return _call(builder, name, arguments[0])

        return _kind(x)(*_alike(x)), codegen

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
        x, exponent = _same(builder, *arguments)
        vectors = x.type == _DOUBLES
        doubles, longs, ints = (_DOUBLES, _LONGS, _INTS) if vectors else (_DOUBLE, _LONG, _INT)

        def polynomial(coefficients: tuple[float, ...], variable: Any) -> Any:
            total = _all(coefficients[0], doubles)
            for coefficient in coefficients[1:]:
                total = _call(builder, "fma", total, variable, _all(coefficient, doubles))
            return total

        places, one = _all(52, longs), _all(1.0, doubles)
        as_bits = builder.bitcast(x, longs)
        k = builder.ashr(builder.sub(as_bits, _all(_LOWEST, longs)), places)
        m = builder.bitcast(builder.sub(as_bits, builder.shl(k, places)), doubles)
        z = builder.fdiv(builder.fsub(m, one), builder.fadd(m, one))
        series = builder.fmul(polynomial(_LOGARITHM, builder.fmul(z, z)), z)
        logarithm = builder.fadd(builder.sitofp(builder.trunc(k, ints), doubles), series)
        y = _choose(builder, ">", builder.fmul(logarithm, exponent), _all(-1000.0, doubles))
        y = _choose(builder, "<", y, _all(1000.0, doubles))
        whole = _call(builder, "rint", y)
        fraction = polynomial(_EXPONENTIAL, builder.fsub(y, whole))
        scale = builder.shl(builder.sext(builder.fptosi(whole, ints), longs), places)
        return builder.bitcast(builder.add(builder.bitcast(fraction, longs), scale), doubles)

    return _kind(x)(*_alike(x), types.float64), codegen
