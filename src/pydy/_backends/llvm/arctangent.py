"""The arctangent in LLVM IR, without branches and the same in every lane.

The size of the argument is reduced to less than 7/16 by atan x = atan c + atan((x − c)/(1 + c x)),
with c = 1/2, 1, 3/2 or ∞, whose arctangents are kept as head and tail. Intervals, c and the
polynomial of degree 21 are those of fdlibm (s_atan.c, Sun Microsystems 1993).
"""

from __future__ import annotations

from pydy._backends.llvm.emit import ARCTANGENT
from pydy._backends.llvm.ir import IrFunction, literal, suffix, vector_type

# From where on each c is used; before the first the argument is taken as it is.
STARTS = (7 / 16, 11 / 16, 19 / 16, 39 / 16)
# The reduced argument (k x − c)/(d + c x), with k and d beside c where both sides are scaled by 2.
# Where c is infinite, they are divided by it: −1/x.
NUMERATOR = (1.0, 2.0, 1.0, 1.0, 0.0)
CENTRE = (0.0, 1.0, 1.0, 1.5, 1.0)
DENOMINATOR = (1.0, 2.0, 1.0, 1.0, 0.0)
# atan c as the sum of two doubles.
HEAD = (
    0.0,
    4.63647609000806093515e-01,
    7.85398163397448278999e-01,
    9.82793723247329054082e-01,
    1.57079632679489655800e00,
)
TAIL = (
    0.0,
    2.26987774529616870924e-17,
    3.06161699786838301793e-17,
    1.39033110312309984516e-17,
    6.12323399573676603587e-17,
)
ATAN = (
    3.33333333333329318027e-01,
    -1.99999999998764832476e-01,
    1.42857142725034663711e-01,
    -1.11111104054623557880e-01,
    9.09088713343650656196e-02,
    -7.69187620504482999495e-02,
    6.66107313738753120669e-02,
    -5.83357013379057348645e-02,
    4.97687799461593236017e-02,
    -3.65315727442169155270e-02,
    1.62858201153657823623e-02,
)


def function(lanes: int) -> str:
    """Return the function of one number of lanes, for the module that calls it."""
    v, flag, end = vector_type("double", lanes), vector_type("i1", lanes), suffix(lanes)
    f = IrFunction(
        f"{ARCTANGENT}{lanes}", v, f"{v} %x", "internal|nounwind willreturn memory(none)"
    )

    def number(value: float) -> str:
        return literal(value, lanes)

    def fma(a: str, b: str, c: str) -> str:
        return f.let(f"call {v} @llvm.fma.{end}({v} {a}, {v} {b}, {v} {c})")

    def op(word: str, a: str, b: str) -> str:
        return f.let(f"{word} {v} {a}, {b}")

    size = f.let(f"call {v} @llvm.fabs.{end}({v} %x)")
    beyond = [f.let(f"fcmp oge {v} {size}, {number(start)}") for start in STARTS]

    def chosen(values: tuple[float, ...]) -> str:
        result = number(values[0])
        for mask, before, value in zip(beyond, values, values[1:], strict=False):
            if value != before:
                result = f.let(f"select {flag} {mask}, {v} {number(value)}, {v} {result}")
        return result

    centre = chosen(CENTRE)
    numerator = fma(chosen(NUMERATOR), size, f.let(f"fneg {v} {centre}"))
    # 0 · ∞ is no number.
    numerator = f.let(f"select {flag} {beyond[-1]}, {v} {number(-1.0)}, {v} {numerator}")
    z = op("fdiv", numerator, fma(centre, size, chosen(DENOMINATOR)))
    square = op("fmul", z, z)
    fourth = op("fmul", square, square)
    even, odd = number(ATAN[10]), number(ATAN[9])
    for k in (8, 6, 4, 2, 0):
        even = fma(even, fourth, number(ATAN[k]))
    for k in (7, 5, 3, 1):
        odd = fma(odd, fourth, number(ATAN[k]))
    series = fma(odd, fourth, op("fmul", even, square))
    below = op("fsub", op("fsub", op("fmul", z, series), chosen(TAIL)), z)
    result = op("fsub", chosen(HEAD), below)
    f.do(f"ret {v} {f.let(f'call {v} @llvm.copysign.{end}({v} {result}, {v} %x)')}")
    return f.text()


def declarations(lanes: int) -> str:
    """Return the declarations of the intrinsics that it calls, but for those of arithmetic."""
    v = vector_type("double", lanes)
    return f"declare {v} @llvm.copysign.{suffix(lanes)}({v}, {v})"
