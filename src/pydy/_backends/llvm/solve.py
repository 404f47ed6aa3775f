"""Linear solves in LLVM IR: LU with partial pivoting lane by lane, and LDLᵀ in a vectorised loop.

These routines are compiled once, not with every model; a kernel knows them by name. Every array is
laid out ``[item][lane]``. A matrix is singular when a pivot is not above n·eps of
its row's and column's scale; the lane's bit is then set and its solution is NaN. A NaN in the
matrix is not a failure: it comes out as NaN.
"""

from __future__ import annotations

from pydy._backends.llvm.ir import Function, hex_double, literal, vector_type
from pydy._graph.tuning import INDEPENDENT, REDUNDANT, SINGULAR

_INTERNAL = "internal|nounwind"
_PUBLIC = "|nounwind"


def solver_names(lanes: int) -> tuple[str, ...]:
    """Return the routines that a kernel of `lanes` lanes may call."""
    names = ("lu", "ldl_factor", "ldl_solve", "guard", "constrained")
    return tuple(f"pydy_{name}_{lanes}" for name in names)


def solver_declarations(lanes: int) -> str:
    """Return their IR declarations."""
    lu, factor, solve, guard, constrained = solver_names(lanes)
    return (
        f"declare i32 @{lu}(ptr, ptr, ptr, ptr, i64, i32)\n"
        f"declare i32 @{factor}(ptr, ptr, i64)\n"
        f"declare void @{solve}(ptr, ptr, ptr, i64)\n"
        f"declare i32 @{guard}(ptr, ptr, i64, ptr, i64, i32)\n"
        f"declare i32 @{constrained}(ptr, ptr, ptr, ptr, i64, i64, i32)\n"
    )


def solver_functions(lanes: int) -> str:
    """Return the routines; the module declares the arithmetic they use."""
    return "\n".join(
        [
            _lu_factor(),
            _lu_solve(),
            _lu_lanes(lanes),
            _ldl_factor(lanes),
            _ldl_solve(lanes),
            _guard(lanes),
            _constrained(),
            _eliminate(),
            _constrained_lanes(lanes),
        ]
    )


def _index(f: Function, i: str, j: str, n: str, stride: str) -> str:
    row = f.let(f"mul nsw i64 {i}, {n}")
    cell = f.let(f"add nsw i64 {row}, {j}")
    return f.let(f"mul nsw i64 {cell}, {stride}")


def _fabs(f: Function, x: str) -> str:
    return f.let(f"call double @llvm.fabs.f64(double {x})")


def _less(f: Function, c: str, a: str, b: str, lanes: int = 1) -> str:
    """Return ``c − a·b``, fused in so many words: the same bits at any level of LLVM's effort."""
    v = vector_type("double", lanes)
    suffix = "f64" if lanes == 1 else f"v{lanes}f64"
    minus = f.let(f"fneg {v} {a}")
    return f.let(f"call {v} @llvm.fma.{suffix}({v} {minus}, {v} {b}, {v} {c})")


def _lu_factor() -> str:
    """Factorise one lane in place; gives whether it is singular.

    a: n·n, pivots: n, scales: 2n; all with the lane's stride, pointers moved to the lane.
    """
    f = Function("lu_factor", "i1", "ptr %a, ptr %pivots, ptr %scales, i64 %n, i64 %s", _INTERNAL)
    size = f.let("sitofp i64 %n to double")
    tolerance = f.let(f"fmul double {size}, {hex_double(SINGULAR)}")
    singular = f.variable("i1", "false")

    def scale(value: str, place: str) -> None:
        positive = f.let(f"fcmp ogt double {value}, 0.0")
        safe = f.let(f"select i1 {positive}, double {value}, double 1.0")
        f.store("double", f.let(f"fdiv double 1.0, {safe}"), "%scales", place)

    with f.loop("0", "%n") as i:
        top = f.variable("double", "0.0")
        with f.loop("0", "%n") as j:
            value = _fabs(f, f.load("double", "%a", _index(f, i, j, "%n", "%s")))
            old = f.get("double", top)
            more = f.let(f"fcmp ogt double {value}, {old}")
            f.set("double", top, f.let(f"select i1 {more}, double {value}, double {old}"))
        scale(f.get("double", top), i)
    with f.loop("0", "%n") as j:
        top = f.variable("double", "0.0")
        with f.loop("0", "%n") as i:
            value = _fabs(f, f.load("double", "%a", _index(f, i, j, "%n", "%s")))
            value = f.let(f"fmul double {value}, {f.load('double', '%scales', i)}")
            old = f.get("double", top)
            more = f.let(f"fcmp ogt double {value}, {old}")
            f.set("double", top, f.let(f"select i1 {more}, double {value}, double {old}"))
        scale(f.get("double", top), f.let(f"add i64 {j}, %n"))
    with f.loop("0", "%n") as k:
        best = f.variable("double", "0.0")
        row = f.variable("i64", k)
        value = _fabs(f, f.load("double", "%a", _index(f, k, k, "%n", "%s")))
        f.set("double", best, f.let(f"fmul double {value}, {f.load('double', '%scales', k)}"))
        after = f.let(f"add nsw i64 {k}, 1")
        with f.loop(after, "%n") as i:
            value = _fabs(f, f.load("double", "%a", _index(f, i, k, "%n", "%s")))
            value = f.let(f"fmul double {value}, {f.load('double', '%scales', i)}")
            old = f.get("double", best)
            more = f.let(f"fcmp ogt double {value}, {old}")
            f.set("double", best, f.let(f"select i1 {more}, double {value}, double {old}"))
            now = f.get("i64", row)
            f.set("i64", row, f.let(f"select i1 {more}, i64 {i}, i64 {now}"))
        column = f.load("double", "%scales", f.let(f"add i64 {k}, %n"))
        size = f.let(f"fmul double {f.get('double', best)}, {column}")
        tiny = f.let(f"fcmp ole double {size}, {tolerance}")
        f.set("i1", singular, f.let(f"or i1 {f.get('i1', singular)}, {tiny}"))
        pivot = f.get("i64", row)
        f.store("i64", pivot, "%pivots", f.let(f"mul nsw i64 {k}, %s"))
        with f.when(f.let(f"icmp ne i64 {pivot}, {k}")):
            with f.loop("0", "%n") as j:
                one = f.at("%a", _index(f, k, j, "%n", "%s"))
                two = f.at("%a", _index(f, pivot, j, "%n", "%s"))
                a, b = f.load("double", one), f.load("double", two)
                f.store("double", b, one)
                f.store("double", a, two)
            a, b = f.load("double", "%scales", k), f.load("double", "%scales", pivot)
            f.store("double", b, "%scales", k)
            f.store("double", a, "%scales", pivot)
        diagonal = f.load("double", "%a", _index(f, k, k, "%n", "%s"))
        inverse = f.let(f"fdiv double 1.0, {diagonal}")
        with f.loop(after, "%n") as i:
            place = f.at("%a", _index(f, i, k, "%n", "%s"))
            factor = f.let(f"fmul double {f.load('double', place)}, {inverse}")
            f.store("double", factor, place)
            with f.loop(after, "%n") as j:
                above = f.load("double", "%a", _index(f, k, j, "%n", "%s"))
                place = f.at("%a", _index(f, i, j, "%n", "%s"))
                f.store("double", _less(f, f.load("double", place), factor, above), place)
    f.do(f"ret i1 {f.get('i1', singular)}")
    return f.text()


def _lu_solve() -> str:
    """Solve one lane in place of the right-hand side b."""
    f = Function("lu_solve", "void", "ptr %a, ptr %pivots, ptr %b, i64 %n, i64 %s", _INTERNAL)
    with f.loop("0", "%n") as k:
        pivot = f.load("i64", "%pivots", f.let(f"mul nsw i64 {k}, %s"))
        one = f.at("%b", f.let(f"mul nsw i64 {k}, %s"))
        two = f.at("%b", f.let(f"mul nsw i64 {pivot}, %s"))
        a, b = f.load("double", one), f.load("double", two)
        f.store("double", b, one)
        f.store("double", a, two)
    with f.loop("0", "%n") as i:
        _subtract_products(f, i, "0", i)
    with f.loop("0", "%n") as back:
        last = f.let("sub nsw i64 %n, 1")
        i = f.let(f"sub nsw i64 {last}, {back}")
        _subtract_products(f, i, f.let(f"add nsw i64 {i}, 1"), "%n")
        place = f.at("%b", f.let(f"mul nsw i64 {i}, %s"))
        diagonal = f.load("double", "%a", _index(f, i, i, "%n", "%s"))
        f.store("double", f.let(f"fdiv double {f.load('double', place)}, {diagonal}"), place)
    f.do("ret void")
    return f.text()


def _subtract_products(f: Function, i: str, start: str, stop: str) -> None:
    """b[i] −= Σ a[i][k] · b[k]."""
    place = f.at("%b", f.let(f"mul nsw i64 {i}, %s"))
    total = f.variable("double", f.load("double", place))
    with f.loop(start, stop) as k:
        a = f.load("double", "%a", _index(f, i, k, "%n", "%s"))
        b = f.load("double", "%b", f.let(f"mul nsw i64 {k}, %s"))
        f.set("double", total, _less(f, f.get("double", total), a, b))
    f.store("double", f.get("double", total), place)


def _lu_lanes(lanes: int) -> str:
    """Factorise (%b null) or solve the lanes in %mask; gives the mask of the singular ones.

    A singular lane's matrix is remembered by a NaN in its last pivot, so that every later solve
    with it gives NaN.
    """
    f = Function(
        f"pydy_lu_{lanes}",
        "i32",
        "ptr %a, ptr %pivots, ptr %scales, ptr %b, i64 %n, i32 %mask",
        _PUBLIC,
    )
    bad = f.variable("i32", "0")
    factorise = f.let("icmp eq ptr %b, null")
    with f.loop("0", str(lanes)) as lane:
        bit = f.let(f"shl i32 1, {f.let(f'trunc i64 {lane} to i32')}")
        wanted = f.let(f"icmp ne i32 {f.let(f'and i32 %mask, {bit}')}, 0")
        with f.when(wanted):
            a = f.at("%a", lane)
            pivots = f.at("%pivots", lane, "i64")
            with f.when(factorise):
                singular = f.let(
                    f"call i1 @lu_factor(ptr {a}, ptr {pivots}, ptr %scales, i64 %n, i64 {lanes})"
                )
                with f.when(singular):
                    f.set("i32", bad, f.let(f"or i32 {f.get('i32', bad)}, {bit}"))
                    last = f.let("sub i64 %n, 1")
                    corner = _index(f, last, last, "%n", str(lanes))
                    f.store("double", hex_double(float("nan")), a, corner)
            with f.when(f.let(f"xor i1 {factorise}, true")):
                b = f.at("%b", lane)
                f.do(f"call void @lu_solve(ptr {a}, ptr {pivots}, ptr {b}, i64 %n, i64 {lanes})")
    f.do(f"ret i32 {f.get('i32', bad)}")
    return f.text()


def _ldl_factor(lanes: int) -> str:
    """Factorise all lanes in place, right-looking on the upper triangle, rows contiguous.

    Row k keeps d·U, `inverse` gets 1/d. Gives the mask of the lanes with a pivot that is not
    sound.
    """
    v = vector_type("double", lanes)
    b = vector_type("i1", lanes)
    f = Function(f"pydy_ldl_factor_{lanes}", "i32", "ptr %a, ptr %inverse, i64 %n", _PUBLIC)
    flags = f.slot(b)
    size = f.let("sitofp i64 %n to double")
    tolerance = f.let(f"fmul double {size}, {hex_double(SINGULAR)}")
    if lanes > 1:
        one = f.let(f"insertelement {v} poison, double {tolerance}, i32 0")
        tolerance = f.let(f"shufflevector {v} {one}, {v} poison, <{lanes} x i32> zeroinitializer")
    with f.loop("0", "%n") as k:  # the original diagonal is the scale
        diagonal = f.load(v, "%a", _index(f, k, k, "%n", "1"))
        f.store(v, f.let(f"fmul {v} {diagonal}, {tolerance}"), "%inverse", k)
    f.set(b, flags, "false" if lanes == 1 else "zeroinitializer")
    with f.loop("0", "%n") as k:
        pivot = f.load(v, "%a", _index(f, k, k, "%n", "1"))
        limit = f.load(v, "%inverse", k)
        sound = f.let(f"fcmp ogt {v} {pivot}, {limit}")
        weak = f.let(f"xor {b} {sound}, {'true' if lanes == 1 else 'splat (i1 true)'}")
        f.set(b, flags, f.let(f"or {b} {f.get(b, flags)}, {weak}"))
        inverse = f.let(f"fdiv {v} {literal(1.0, lanes)}, {pivot}")
        f.store(v, inverse, "%inverse", k)
        after = f.let(f"add nsw i64 {k}, 1")
        row = f.at("%a", _index(f, k, "0", "%n", "1"), v)
        with f.loop(after, "%n") as i:
            factor = f.let(f"fmul {v} {f.load(v, row, i)}, {inverse}")
            target = f.at("%a", _index(f, i, "0", "%n", "1"), v)
            with f.loop(i, "%n") as j:
                place = f.at(target, j, v)
                value = _less(f, f.load(v, place), factor, f.load(v, row, j), lanes)
                f.store(v, value, place)
    f.do(f"ret i32 {mask(f, f.get(b, flags), lanes)}")
    return f.text()


def _ldl_solve(lanes: int) -> str:
    """Solve all lanes in place of x."""
    v = vector_type("double", lanes)
    f = Function(f"pydy_ldl_solve_{lanes}", "void", "ptr %a, ptr %inverse, ptr %x, i64 %n", _PUBLIC)
    with f.loop("0", "%n") as k:
        value = f.let(f"fmul {v} {f.load(v, '%x', k)}, {f.load(v, '%inverse', k)}")
        row = f.at("%a", _index(f, k, "0", "%n", "1"), v)
        after = f.let(f"add nsw i64 {k}, 1")
        with f.loop(after, "%n") as i:
            place = f.at("%x", i, v)
            less = _less(f, f.load(v, place), f.load(v, row, i), value, lanes)
            f.store(v, less, place)
        f.store(v, value, "%x", k)
    with f.loop("0", "%n") as back:
        last = f.let("sub nsw i64 %n, 1")
        k = f.let(f"sub nsw i64 {last}, {back}")
        row = f.at("%a", _index(f, k, "0", "%n", "1"), v)
        total = f.variable(v, literal(0.0, lanes))
        with f.loop(f.let(f"add nsw i64 {k}, 1"), "%n") as i:
            less = _less(f, f.get(v, total), f.load(v, row, i), f.load(v, "%x", i), lanes)
            f.set(v, total, less)
        step = f.let(f"fmul {v} {f.get(v, total)}, {f.load(v, '%inverse', k)}")
        f.store(v, f.let(f"fadd {v} {f.load(v, '%x', k)}, {step}"), "%x", k)
    f.do("ret void")
    return f.text()


def _guard(lanes: int) -> str:
    """Solve again, by LU, the lanes in %mask of a symmetric system that LDL^T could not.

    lower: the lower triangle row by row; b: %count right-hand sides, solved in place; a: room for
    n*n + 3n items, of which the LU uses all. Gives the mask of the singular lanes.
    """
    v = vector_type("double", lanes)
    arguments = "ptr %lower, ptr %b, i64 %count, ptr %a, i64 %n, i32 %mask"
    f = Function(f"pydy_guard_{lanes}", "i32", arguments, _PUBLIC)
    place = f.variable("i64", "0")
    with f.loop("0", "%n") as i, f.loop("0", f.let(f"add nsw i64 {i}, 1")) as j:
        k = f.get("i64", place)
        value = f.load(v, "%lower", k)
        f.set("i64", place, f.let(f"add nsw i64 {k}, 1"))
        f.store(v, value, "%a", _index(f, i, j, "%n", "1"))
        f.store(v, value, "%a", _index(f, j, i, "%n", "1"))
    square = f.let("mul nsw i64 %n, %n")
    pivots = f.at("%a", square, v)
    scales = f.at(pivots, "%n", v)
    call = f"ptr %a, ptr {pivots}, ptr {scales}"
    bad = f.let(f"call i32 @pydy_lu_{lanes}({call}, ptr null, i64 %n, i32 %mask)")
    with f.loop("0", "%count") as k:
        b = f.at("%b", f.let(f"mul nsw i64 {k}, %n"), v)
        f.let(f"call i32 @pydy_lu_{lanes}({call}, ptr {b}, i64 %n, i32 %mask)")
    f.do(f"ret i32 {bad}")
    return f.text()


def _constrained() -> str:
    """Solve one lane as `pydy._graph.interpret.constrained` does; gives whether it is singular.

    Arrays are those of `_lu_factor`, and %m numbers of right-hand sides; a pivot is its column, −1
    where a row has none.
    """
    arguments = "ptr %a, ptr %pivots, ptr %scales, ptr %b, i64 %m, i64 %n, i64 %s"
    f = Function("constrained", "i1", arguments, _INTERNAL)
    rest, beside = f.variable("double", "0.0"), f.variable("double", "0.0")
    singular = f.variable("i1", "false")
    first, left = f.variable("i64", "%n"), f.variable("i64", "0")
    best = f.variable("double", "0.0")
    row, column = f.variable("i64", "-1"), f.variable("i64", "-1")

    def stride(i: str) -> str:
        return f.let(f"mul nsw i64 {i}, %s")

    def cell(i: str, j: str) -> str:
        return f.load("double", "%a", _index(f, i, j, "%n", "%s"))

    def unused(i: str) -> str:
        return f.let(f"icmp slt i64 {f.load('i64', '%pivots', stride(i))}, 0")

    def watch(value: str, rest: str = rest) -> None:
        nothing = f.let(f"fmul double {value}, 0.0")
        f.set("double", rest, f.let(f"fadd double {f.get('double', rest)}, {nothing}"))

    def offer(size: str, i: str, j: str) -> None:
        with f.when(f.let(f"fcmp ogt double {size}, {f.get('double', best)}")):
            f.set("double", best, size)
            f.set("i64", row, i)
            f.set("i64", column, j)

    with f.loop("0", "%m") as i:
        watch(f.load("double", "%b", stride(i)), beside)
    with f.loop("0", "%n") as i:
        f.store("i64", "-1", "%pivots", stride(i))
        with f.loop("0", "%n") as j:
            watch(cell(i, j))
        # Constraints are the last rows: the first of them is the first with a mark.
        diagonal = cell(i, i)
        one = f.let(f"fcmp oeq double {diagonal}, {hex_double(INDEPENDENT)}")
        two = f.let(f"fcmp oeq double {diagonal}, {hex_double(REDUNDANT)}")
        with f.when(f.let(f"or i1 {one}, {two}")):
            size = f.get("i64", first)
            sooner = f.let(f"icmp slt i64 {i}, {size}")
            f.set("i64", first, f.let(f"select i1 {sooner}, i64 {i}, i64 {size}"))
            count = f.let(f"zext i1 {one} to i64")
            f.set("i64", left, f.let(f"add i64 {f.get('i64', left)}, {count}"))
            f.store("double", "0.0", "%a", _index(f, i, i, "%n", "%s"))
    masses = f.get("i64", first)
    with f.loop("0", masses) as j:
        top = f.variable("double", "0.0")
        with f.loop(masses, "%n") as i:
            size, old = _fabs(f, cell(i, j)), f.get("double", top)
            more = f.let(f"fcmp ogt double {size}, {old}")
            f.set("double", top, f.let(f"select i1 {more}, double {size}, double {old}"))
        largest = f.get("double", top)
        some = f.let(f"fcmp ogt double {largest}, 0.0")
        largest = f.let(f"select i1 {some}, double {largest}, double 1.0")
        massless = f.let(f"fmul double {largest}, {hex_double(SINGULAR)}")
        diagonal = cell(j, j)
        heavy = f.let(f"fcmp ogt double {diagonal}, 0.0")
        root = f.let(f"call double @llvm.sqrt.f64(double {diagonal})")
        unit = f.let(f"select i1 {heavy}, double {root}, double {massless}")
        f.store("double", f.let(f"fdiv double 1.0, {unit}"), "%scales", j)
    size = f.let("sitofp i64 %n to double")
    with f.loop("0", masses):
        f.set("double", best, size)
        f.set("i64", row, "-1")
        some = f.let(f"icmp sgt i64 {f.get('i64', left)}, 0")
        with (
            f.when(some), f.loop(masses, "%n") as i, f.when(unused(i)),
            f.loop("0", masses) as j, f.when(unused(j)),
        ):  # fmt: skip
            own = _fabs(f, cell(i, j))
            offer(f.let(f"fmul double {own}, {f.load('double', '%scales', j)}"), i, j)
        none = f.let(f"icmp slt i64 {f.get('i64', row)}, 0")
        less = f.let(f"sub i64 {f.get('i64', left)}, 1")
        f.set("i64", left, f.let(f"select i1 {none}, i64 0, i64 {less}"))
        with f.when(none):
            f.set("double", best, f.let(f"fmul double {size}, {hex_double(SINGULAR)}"))
            with f.loop("0", masses) as j, f.when(unused(j)):
                scale = f.load("double", "%scales", j)
                own = f.let(f"fmul double {_fabs(f, cell(j, j))}, {scale}")
                offer(f.let(f"fmul double {own}, {scale}"), j, j)
        p, q = f.get("i64", row), f.get("i64", column)
        found = f.let(f"icmp sge i64 {p}, 0")
        f.set(
            "i1",
            singular,
            f.let(f"or i1 {f.get('i1', singular)}, {f.let(f'xor i1 {found}, true')}"),
        )
        arrays = "ptr %a, ptr %pivots, ptr %b, i64 %m"
        with f.when(found):
            f.do(f"call void @eliminate({arrays}, i64 {p}, i64 {q}, i64 %n, i64 %s)")
        with f.when(f.let(f"and i1 {found}, {f.let(f'icmp ne i64 {p}, {q}')}")):
            f.do(f"call void @eliminate({arrays}, i64 {q}, i64 {p}, i64 %n, i64 %s)")
    failed = f.get("i1", singular)
    nothing = f.get("double", rest)
    nan = hex_double(float("nan"))
    added = f.let(f"select i1 {failed}, double {nan}, double {nothing}")
    with f.loop("0", "%m", "%n") as k:
        own, b = f.variable("double", added), f.at("%b", stride(k))
        with f.loop("0", "%n") as i:
            watch(f.load("double", b, stride(i)), own)
            f.store("double", "0.0", "%scales", f.let(f"add i64 {i}, %n"))
        with f.loop("0", "%n") as i, f.when(f.let(f"xor i1 {unused(i)}, true")):
            q = f.load("i64", "%pivots", stride(i))
            x = f.let(f"fdiv double {f.load('double', b, stride(i))}, {cell(i, q)}")
            f.store("double", x, "%scales", f.let(f"add i64 {q}, %n"))
        with f.loop("0", "%n") as i:
            x = f.load("double", "%scales", f.let(f"add i64 {i}, %n"))
            f.store("double", f.let(f"fadd double {x}, {f.get('double', own)}"), b, stride(i))
    whole = f.let(f"fadd double {nothing}, {f.get('double', beside)}")
    finite = f.let(f"fcmp oeq double {whole}, 0.0")
    f.do(f"ret i1 {f.let(f'and i1 {failed}, {finite}')}")
    return f.text()


def _eliminate() -> str:
    """Eliminate column q from all rows but p, which is divided by nothing."""
    arguments = "ptr %a, ptr %pivots, ptr %b, i64 %m, i64 %p, i64 %q, i64 %n, i64 %s"
    f = Function("eliminate", "void", arguments, _INTERNAL)
    pivot = f.load("double", "%a", _index(f, "%p", "%q", "%n", "%s"))
    inverse = f.let(f"fdiv double 1.0, {pivot}")
    with f.loop("0", "%n") as i:
        value = f.load("double", "%a", _index(f, i, "%q", "%n", "%s"))
        factor = f.let(f"fmul double {value}, {inverse}")
        other, some = f.let(f"icmp ne i64 {i}, %p"), f.let(f"fcmp une double {factor}, 0.0")
        with f.when(f.let(f"and i1 {other}, {some}")):
            with f.loop("0", "%n") as j:
                above = f.load("double", "%a", _index(f, "%p", j, "%n", "%s"))
                place = f.at("%a", _index(f, i, j, "%n", "%s"))
                f.store("double", _less(f, f.load("double", place), factor, above), place)
            with f.loop("0", "%m", "%n") as k:
                below, own = (
                    f.at("%b", f.let(f"mul nsw i64 {f.let(f'add nsw i64 {k}, {row}')}, %s"))
                    for row in (i, "%p")
                )
                less = _less(f, f.load("double", below), factor, f.load("double", own))
                f.store("double", less, below)
    f.store("i64", "%q", "%pivots", f.let("mul nsw i64 %p, %s"))
    f.do("ret void")
    return f.text()


def _constrained_lanes(lanes: int) -> str:
    """Solve the lanes in %mask in place of b; gives the mask of the singular ones."""
    arguments = "ptr %a, ptr %pivots, ptr %scales, ptr %b, i64 %m, i64 %n, i32 %mask"
    f = Function(f"pydy_constrained_{lanes}", "i32", arguments, _PUBLIC)
    bad = f.variable("i32", "0")
    with f.loop("0", str(lanes)) as lane:
        bit = f.let(f"shl i32 1, {f.let(f'trunc i64 {lane} to i32')}")
        with f.when(f.let(f"icmp ne i32 {f.let(f'and i32 %mask, {bit}')}, 0")):
            a, b = f.at("%a", lane), f.at("%b", lane)
            arrays = f"ptr {a}, ptr {f.at('%pivots', lane, 'i64')}, ptr %scales, ptr {b}"
            singular = f.let(f"call i1 @constrained({arrays}, i64 %m, i64 %n, i64 {lanes})")
            with f.when(singular):
                f.set("i32", bad, f.let(f"or i32 {f.get('i32', bad)}, {bit}"))
    f.do(f"ret i32 {f.get('i32', bad)}")
    return f.text()


def mask(f: Function, flags: str, lanes: int) -> str:
    """Return a vector of truth values as the bits of an i32."""
    if lanes == 1:
        return f.let(f"zext i1 {flags} to i32")
    bits = f.let(f"bitcast <{lanes} x i1> {flags} to i{lanes}")
    return bits if lanes == 32 else f.let(f"zext i{lanes} {bits} to i32")
