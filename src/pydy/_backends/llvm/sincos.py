"""Sine and cosine in LLVM IR, together, written in line and the same in every lane.

The argument is reduced by multiples of π/2 in three parts (Cody & Waite, Software Manual for the
Elementary Functions, 1980, ch. 8) with fused multiply-adds, and kept as head and tail. Up to 1e5
the first product cancels exactly; the second one's rounding errors are carried in the tail, so
that the doubles nearest to multiples of π/2 come out right too. The polynomials on [−π/4, π/4] are
those of fdlibm (k_sin.c and k_cos.c, Sun Microsystems 1993), of degree 13 and 14. Lanes beyond
1e5, infinities and NaN go to libm.
"""

from __future__ import annotations

from pydy._backends.llvm.ir import WIDTHS, IrFunction, literal, suffix, vector_type

LIMIT = 1e5

# π/2 as the exact sum of three doubles, to about 1e-49.
PI_2 = (
    float.fromhex("0x1.921fb54442d18p+0"),
    float.fromhex("0x1.1a62633145c07p-54"),
    float.fromhex("-0x1.f1976b7ed8fbcp-110"),
)
_TWO_OVER_PI = float.fromhex("0x1.45f306dc9c883p-1")
_ROUND = 1.5 * 2.0**52  # adding and subtracting it rounds to an integer, which its low bits hold

SIN = (
    -1.66666666666666324348e-01,
    8.33333333332248946124e-03,
    -1.98412698298579493134e-04,
    2.75573137070700676789e-06,
    -2.50507602534068634195e-08,
    1.58969099521155010221e-10,
)
COS = (
    4.16666666666666019037e-02,
    -1.38888888888741095749e-03,
    2.48015872894767294178e-05,
    -2.75573143513906633035e-07,
    2.08757232129817482790e-09,
    -1.13596475577881948265e-11,
)


class _Arithmetic:
    """Double arithmetic without any fast-math flag."""

    def __init__(self, f: IrFunction, lanes: int) -> None:
        self.f = f
        self.lanes = lanes
        self.v = vector_type("double", lanes)
        self.suffix = suffix(lanes)

    def number(self, value: float) -> str:
        return literal(value, self.lanes)

    def __call__(self, op: str, *args: str) -> str:
        return self.f.let(f"{op} {self.v} {', '.join(args)}")

    def fma(self, a: str, b: str, c: str) -> str:
        v = self.v
        return self.f.let(f"call {v} @llvm.fma.{self.suffix}({v} {a}, {v} {b}, {v} {c})")

    def polynomial(self, z: str, z2: str, c: tuple[float, ...]) -> str:
        """Evaluate six coefficients in pairs (Estrin's scheme)."""
        low, middle, high = (
            self.fma(z, self.number(c[k + 1]), self.number(c[k])) for k in (0, 2, 4)
        )
        return self.fma(self.fma(high, z2, middle), z2, low)


def _near(f: IrFunction, x: str, lanes: int) -> tuple[str, str, str]:
    """Write sin(x) and cos(x) for |x| up to the limit; return them and the mask of these lanes."""
    m = _Arithmetic(f, lanes)
    v, bits, flag = m.v, vector_type("i64", lanes), vector_type("i1", lanes)
    # The quadrant, as a number and as an integer.
    shifted = m.fma(x, m.number(_TWO_OVER_PI), m.number(_ROUND))
    quadrant = f.let(f"bitcast {v} {shifted} to {bits}")
    k = m("fsub", shifted, m.number(_ROUND))
    # Head and tail of x − k·π/2. The first difference r is exact. It is a multiple of 2⁻⁵³, hence
    # of the last bit of w, and so the short two-sum loses nothing, whichever of r and w is larger
    # (Boldo, Graillat, Muller, ACM TOMS 44, 2017). The tail is written with its sign turned, which
    # keeps the sign of −0.
    r = m.fma(m("fneg", k), m.number(PI_2[0]), x)
    w = m("fmul", k, m.number(PI_2[1]))
    w_error = m.fma(k, m.number(PI_2[1]), m("fneg", w))
    head = m("fsub", r, w)
    minus_tail = m("fadd", m("fadd", m("fsub", head, r), w), m.fma(k, m.number(PI_2[2]), w_error))
    # sin(head + tail) and cos(head + tail) as fdlibm's kernels, arranged for short chains: what
    # comes before a value decides how long a right-hand side with few operations takes.
    z = m("fmul", head, head)
    z2 = m("fmul", z, z)
    cube = m("fmul", z, head)
    lead = m.fma(m.number(-0.5), z, m.number(1.0))
    s = m.polynomial(z, z2, tuple(-c for c in SIN))
    sine = m("fsub", head, m.fma(cube, s, m("fmul", minus_tail, lead)))
    correction = m.fma(m.number(-0.5), z, m("fsub", m.number(1.0), lead))
    correction = m.fma(head, minus_tail, correction)
    cosine = m("fadd", lead, m.fma(z2, m.polynomial(z, z2, COS), correction))
    # Quadrants 1 and 3 swap them; signs follow from the quadrant's bits.

    def splat(n: int) -> str:
        return str(n) if lanes == 1 else f"splat (i64 {n})"

    odd = f.let(f"trunc {bits} {quadrant} to {flag}")
    sin_core = f.let(f"select {flag} {odd}, {v} {cosine}, {v} {sine}")
    cos_core = f.let(f"select {flag} {odd}, {v} {sine}, {v} {cosine}")
    sign = -(2**63)
    sin_sign = f.let(f"and {bits} {f.let(f'shl {bits} {quadrant}, {splat(62)}')}, {splat(sign)}")
    ahead = f.let(f"add {bits} {quadrant}, {splat(1)}")
    cos_sign = f.let(f"and {bits} {f.let(f'shl {bits} {ahead}, {splat(62)}')}, {splat(sign)}")

    def signed(value: str, flip: str) -> str:
        as_bits = f.let(f"bitcast {v} {value} to {bits}")
        return f.let(f"bitcast {bits} {f.let(f'xor {bits} {as_bits}, {flip}')} to {v}")

    # -0 must stay -0, and tiny arguments lose nothing: head is then x itself.
    size = f.let(f"call {v} @llvm.fabs.{m.suffix}({v} {x})")
    near = f.let(f"fcmp ole {v} {size}, {m.number(LIMIT)}")
    return signed(sin_core, sin_sign), signed(cos_core, cos_sign), near


def _every(f: IrFunction, near: str, lanes: int) -> str:
    """Write whether the mask is true in all lanes."""
    if lanes == 1:
        return near
    word = f.let(f"bitcast {vector_type('i1', lanes)} {near} to i{lanes}")
    return f.let(f"icmp eq i{lanes} {word}, -1")


def sincos_together(f: IrFunction, angles: list[str], lanes: int) -> list[tuple[str, str]]:
    """Write sines and cosines of several angles with one branch to libm for all of them.

    Only these results are live across that branch, whose calls clobber the vector registers.
    """
    v, flag = vector_type("double", lanes), vector_type("i1", lanes)
    quick = []
    near = ""
    for x in angles:
        sine, cosine, lane_near = _near(f, x, lanes)
        quick += [sine, cosine]
        near = f.let(f"and {flag} {near}, {lane_near}") if near else lane_near
    slow, join = f.name("far"), f.name("angles")
    room = f.slot(v, len(quick))
    before = f.current
    f.do(f"br i1 {_every(f, near, lanes)}, label {join}, label {slow}, !prof !1")
    f.label(slow)
    for k, x in enumerate(angles):
        f.do(f"call void @pydy_sincos_{lanes}({v} {x}, ptr {f.at(room, str(2 * k), v)})")
    slower = [f.load(v, room, str(k)) for k in range(len(quick))]
    f.do(f"br label {join}")
    f.label(join)
    results = [
        f.let(f"phi {v} [ {a}, %{before} ], [ {b}, {slow} ]")
        for a, b in zip(quick, slower, strict=True)
    ]
    return list(zip(results[::2], results[1::2], strict=True))


def sincos(f: IrFunction, x: str, lanes: int) -> tuple[str, str]:
    """Write sin(x) and cos(x) and return their names."""
    v, flag = vector_type("double", lanes), vector_type("i1", lanes)
    sine, cosine, near = _near(f, x, lanes)
    fast = sine, cosine
    every = _every(f, near, lanes)
    slow, join = f.name("far"), f.name("angle")
    before = f.current
    f.do(f"br i1 {every}, label {join}, label {slow}, !prof !1")
    f.label(slow)
    room = f.slot(v, 2)
    f.do(f"call void @pydy_sincos_far_{lanes}({v} {x}, ptr {room})")
    chosen = []
    for index, quick in enumerate(fast):
        value = f.load(v, room, str(index))
        chosen.append(f.let(f"select {flag} {near}, {v} {quick}, {v} {value}"))
    end = f.current
    f.do(f"br label {join}")
    f.label(join)
    sin_x, cos_x = (
        f.let(f"phi {v} [ {a}, %{before} ], [ {b}, %{end} ]")
        for a, b in zip(fast, chosen, strict=True)
    )
    return sin_x, cos_x


def sincos_names(lanes: int) -> tuple[str, ...]:
    """Return the routines that a kernel of `lanes` lanes may call.

    Scalar code takes up to eight angles side by side.
    """
    widths = WIDTHS if lanes == 1 else (lanes,)
    return tuple(f"pydy_sincos_{kind}{w}" for w in widths for kind in ("", "far_"))


def sincos_declarations(lanes: int, kind: str = "") -> str:
    """Return the IR declaration of a routine; `kind` is empty or ``far_``."""
    v = vector_type("double", lanes)
    return f"declare void @pydy_sincos_{kind}{lanes}({v}, ptr) nounwind\n"


def sincos_functions(lanes: int) -> str:
    """Return the routines for one width: the complete one, and the calls of libm for each lane."""
    v = vector_type("double", lanes)
    complete = IrFunction(f"pydy_sincos_{lanes}", "void", f"{v} %x, ptr %out", "|nounwind")
    for index, value in enumerate(sincos(complete, "%x", lanes)):
        complete.store(v, value, "%out", str(index))
    complete.do("ret void")
    f = IrFunction(f"pydy_sincos_far_{lanes}", "void", f"{v} %x, ptr %out", "|noinline nounwind")
    for index, name in enumerate(("sin", "cos")):
        f.store(v, f.lane_by_lane(name, [f"{v} %x"], lanes), "%out", str(index))
    f.do("ret void")
    return complete.text() + f.text()
