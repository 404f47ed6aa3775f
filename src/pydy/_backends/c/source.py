"""A Program as straight-line C99 that stands alone: for the 'cython' back end and for export.

Every value is a constant local variable; a stage is one function without branches but for the
fallback behind a guard.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from pydy._graph.operations import OPERATIONS, TRUTHS, is_constrained, operands
from pydy._graph.program import Program
from pydy._graph.tuning import numbered

# A matrix is singular when a pivot is not above n·eps of its row's and column's scale; its
# solution is then NaN, by a NaN in the last pivot. A NaN in the matrix is not a failure: every
# comparison below is false for it, and it comes out as NaN.
_HEAD = """\
#include <math.h>
#include <stdint.h>

#if defined(_MSC_VER) || defined(__cplusplus)
#define RESTRICT __restrict
#else
#define RESTRICT restrict
#endif
"""

# By the name of the function; only those that a Program calls are written.
_HELPERS = {
    "minimum": """\
/* Unlike fmin and fmax, these give NaN when either argument is NaN. */
static inline double minimum(double a, double b) { return a < b || a != a ? a : b; }
""",
    "maximum": """\
/* Unlike fmin and fmax, these give NaN when either argument is NaN. */
static inline double maximum(double a, double b) { return a > b || a != a ? a : b; }
""",
    "sign": """\
static inline double sign(double a) { return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : a; }
""",
    "lu_factor": """\
/* Factorise the n by n matrix a in place by LU with partial pivoting; `scales` is 2 n numbers of
   work space, the reciprocal sizes of the rows and then of the columns. Returns whether a is
   singular. */
static inline int32_t lu_factor(int n, double *a, int *pivots, double *scales)
{
    const double tolerance = n * SINGULAR;
    int32_t singular = 0;
    for (int i = 0; i < n; i++) {
        double top = 0.0;
        for (int j = 0; j < n; j++) {
            const double size = fabs(a[i * n + j]);
            top = size > top ? size : top;
        }
        scales[i] = 1.0 / (top > 0.0 ? top : 1.0);
    }
    for (int j = 0; j < n; j++) {
        double top = 0.0;
        for (int i = 0; i < n; i++) {
            const double size = fabs(a[i * n + j]) * scales[i];
            top = size > top ? size : top;
        }
        scales[n + j] = 1.0 / (top > 0.0 ? top : 1.0);
    }
    for (int k = 0; k < n; k++) {
        int pivot = k;
        double best = fabs(a[k * n + k]) * scales[k];
        for (int i = k + 1; i < n; i++) {
            const double size = fabs(a[i * n + k]) * scales[i];
            if (size > best) {
                best = size;
                pivot = i;
            }
        }
        if (best * scales[n + k] <= tolerance)
            singular = 1;
        pivots[k] = pivot;
        if (pivot != k) {
            for (int j = 0; j < n; j++) {
                const double swapped = a[k * n + j];
                a[k * n + j] = a[pivot * n + j];
                a[pivot * n + j] = swapped;
            }
            const double swapped = scales[k];
            scales[k] = scales[pivot];
            scales[pivot] = swapped;
        }
        const double inverse = 1.0 / a[k * n + k];
        for (int i = k + 1; i < n; i++) {
            const double factor = a[i * n + k] * inverse;
            a[i * n + k] = factor;
            for (int j = k + 1; j < n; j++)
                a[i * n + j] -= factor * a[k * n + j];
        }
    }
    if (singular)
        a[n * n - 1] = NAN; /* so that every solution is NaN */
    return singular;
}
""",
    "constrained": """\
/* Solve M x - A^T l = f, A x = b in place of the right-hand side by Gauss and Jordan's elimination,
   whatever the rank of A; `scales` is 2 n numbers of work space. The last rows, with a mark on the
   diagonal, are those of A in units of their rounding errors; so many are independent as are
   marked so. Pivots are the largest of A, then of the diagonal of M. Returns whether M is
   singular. */
static inline int32_t constrained(int n, double *a, int *pivots, double *scales, double *b)
{
    int first = n, left = 0;
    int32_t singular = 0;
    double rest = 0.0; /* NaN, if anything is not finite */
    for (int i = 0; i < n; i++) {
        rest += 0.0 * b[i];
        pivots[i] = -1;
        for (int j = 0; j < n; j++)
            rest += 0.0 * a[i * n + j];
    }
    for (; first; first--) {
        const double mark = a[first * n - n + first - 1];
        if (mark != INDEPENDENT && mark != REDUNDANT)
            break;
        left += mark == INDEPENDENT;
        a[first * n - n + first - 1] = 0.0;
    }
    for (int j = 0; j < first; j++) {
        double top = 0.0;
        for (int i = first; i < n; i++)
            top = fabs(a[i * n + j]) > top ? fabs(a[i * n + j]) : top;
        scales[j] = a[j * n + j] > 0.0 ? 1.0 / sqrt(a[j * n + j])
                                       : 1.0 / (SINGULAR * (top > 0.0 ? top : 1.0));
    }
    for (int k = 0; k < first; k++) {
        double best = n;
        int row = -1, column = -1;
        for (int i = first; left && i < n; i++)
            for (int j = 0; j < first && pivots[i] < 0; j++)
                if (pivots[j] < 0 && fabs(a[i * n + j]) * scales[j] > best) {
                    best = fabs(a[i * n + j]) * scales[j];
                    row = i;
                    column = j;
                }
        if (row < 0) {
            left = 0;
            best = n * SINGULAR;
            for (int j = 0; j < first; j++)
                if (pivots[j] < 0 && fabs(a[j * n + j]) * scales[j] * scales[j] > best) {
                    best = fabs(a[j * n + j]) * scales[j] * scales[j];
                    row = column = j;
                }
        } else
            left--;
        if (row < 0) {
            singular = rest == 0.0;
            rest = NAN;
            break;
        }
        for (int turn = 0; turn < 1 + (row != column); turn++) {
            const int p = turn ? column : row, q = turn ? row : column;
            const double inverse = 1.0 / a[p * n + q];
            for (int i = 0; i < n; i++) {
                const double factor = a[i * n + q] * inverse;
                if (i == p || factor == 0.0)
                    continue;
                for (int j = 0; j < n; j++)
                    a[i * n + j] -= factor * a[p * n + j];
                b[i] -= factor * b[p];
            }
            pivots[p] = q;
        }
    }
    for (int i = 0; i < n; i++)
        scales[n + i] = 0.0;
    for (int i = 0; i < n; i++)
        if (pivots[i] >= 0)
            scales[n + pivots[i]] = b[i] / a[i * n + pivots[i]];
    for (int i = 0; i < n; i++)
        b[i] = scales[n + i] + rest;
    return singular;
}
""",
    "lu_solve": """\
/* Solve in place of the right-hand side b, with the factors from lu_factor. */
static inline void lu_solve(int n, const double *a, const int *pivots, double *b)
{
    for (int k = 0; k < n; k++) {
        const double swapped = b[k];
        b[k] = b[pivots[k]];
        b[pivots[k]] = swapped;
    }
    for (int i = 0; i < n; i++)
        for (int k = 0; k < i; k++)
            b[i] -= a[i * n + k] * b[k];
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            b[i] -= a[i * n + k] * b[k];
        b[i] /= a[i * n + i];
    }
}
""",
}


def c_source(program: Program, *, prefix: str = "", static: bool = False) -> str:
    """Return a Program as one file of C99 that needs nothing but the C library's math.

    It defines two functions, which keep no state and allocate nothing::

        void prepare(const double *p, double *c);
        int32_t kernel(const double *t, const double *x, const double *r, const double *c,
                       double *out);

    `prepare` computes from the constants p what all calls share, ``len(program.carried)`` numbers.
    `kernel` writes ``len(program.outputs)`` numbers, the blocks of the Program one after the other,
    and returns 1 where a linear solve met a singular matrix, whose solution is then NaN, else 0.

    Parameters
    ----------
    program : Program
    prefix : str, optional
        What the names of both functions begin with.
    static : bool, optional
        Whether they are visible in this file alone, which another one includes.
    """
    head = f"/* Written by pydy for the program {program.digest}. */\n\n"
    return head + c_functions({prefix: program}, static=static)


def c_functions(programs: Mapping[str, Program], *, static: bool = False) -> str:
    """Return the functions of several Programs, by their prefixes, as `c_source` describes them."""
    kind = "static " if static else ""
    lines = []
    for prefix, program in programs.items():
        first, second = (kind + s for s in _signatures(prefix))
        lines += [first, *_prepare(program), "", second, *_kernel(program), ""]
    code = "\n".join(lines)
    called = [text for name, text in _HELPERS.items() if f"{name}(" in code]
    return "\n".join([_HEAD, *map(numbered, called), code])


def _signatures(prefix: str) -> tuple[str, str]:
    pointer = "const double *RESTRICT "
    t, x, r, c = (pointer + name for name in "txrc")
    return (
        f"void {prefix}prepare({pointer}p, double *RESTRICT c)",
        f"int32_t {prefix}kernel(\n    {t}, {x}, {r},\n    {c}, double *RESTRICT out)",
    )


def _prepare(program: Program) -> Iterable[str]:
    yield "{"
    yield _used(["p", "c"])
    stage = _Stage(program)
    for node, setup in enumerate(program.setup):
        if setup:
            stage.node(node)
    yield from stage.lines
    for index, node in enumerate(program.carried):
        yield f"    c[{index}] = {stage.names[node]};"
    yield "}"


def _kernel(program: Program) -> Iterable[str]:
    yield "{"
    yield _used(["t", "x", "r", "c", "out"])
    yield "    int32_t status = 0;"
    stage = _Stage(program)
    stage.carried(program.carried)
    put_off = {k for nodes in program.fallback.values() for k in nodes}
    for node, setup in enumerate(program.setup):
        if not setup and node not in put_off:
            stage.node(node)
    yield from stage.lines
    for index, node in enumerate(program.outputs):
        yield f"    out[{index}] = {stage.names[node]};"
    yield "    return status;"
    yield "}"


def _used(parameters: Iterable[str]) -> str:
    """Keep compilers from warning of parameters that this Program does not read."""
    return "    " + " ".join(f"(void){name};" for name in parameters)


class _Stage:
    """Writes the operations of one stage; every value is a constant local variable."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.lines: list[str] = []
        self.names: dict[int, str] = {}
        for node, op in enumerate(program.ops):
            if op in ("const", "bool"):
                self.names[node] = _literal(program.args[node][0])

    def carried(self, nodes: Iterable[int]) -> None:
        """Read the values of the setup stage."""
        for index, node in enumerate(nodes):
            test = " != 0.0" if self.program.ops[node] in TRUTHS else ""
            self._let(node, f"c[{index}]{test}")

    def node(self, node: int) -> None:
        """Write one operation."""
        op, args = self.program.ops[node], self.program.args[node]
        names = [self.names.get(k, "") for k in operands(op, args)]
        if op in ("const", "bool"):
            pass
        elif op == "input":
            self._let(node, f"{args[0]}[{args[1]}]")
        elif op in OPERATIONS:
            self._let(node, OPERATIONS[op].c.format(*names))
        elif op == "item":
            self._let(node, f"s{args[0]}[{args[1]}]")
        elif op == "factor":
            self._factor(f"{node}", args[1], args[2], "    ")
        elif op == "solve":
            self._array(f"s{node}", args[1], "    ")
            self._line(f"lu_solve({len(args[1])}, a{args[0]}, i{args[0]}, s{node});", "    ")
        elif op == "guard":
            self._guard(node, *args)
        else:
            raise AssertionError(f"no C for {op!r}")

    def _line(self, text: str, indent: str) -> None:
        self.lines.append(indent + text)

    def _let(self, node: int, value: str) -> None:
        kind = "int" if self.program.ops[node] in TRUTHS else "double"
        self.names[node] = f"v{node}"
        self._line(f"const {kind} v{node} = {value};", "    ")

    def _array(self, name: str, nodes: tuple[int, ...], indent: str) -> None:
        values = ", ".join(self.names[k] for k in nodes) or "0.0"  # C knows no empty array
        self._line(f"double {name}[] = {{{values}}};", indent)

    def _matrix(self, suffix: str, n: int, entries: tuple[int, ...], indent: str) -> None:
        self._array(f"a{suffix}", entries, indent)
        self._line(f"int i{suffix}[{max(n, 1)}];", indent)
        self._line(f"double w{suffix}[{max(2 * n, 1)}];", indent)

    def _factor(self, suffix: str, n: int, entries: tuple[int, ...], indent: str) -> None:
        self._matrix(suffix, n, entries, indent)
        self._line(f"status |= lu_factor({n}, a{suffix}, i{suffix}, w{suffix});", indent)

    def _guard(
        self,
        node: int,
        n: int,
        entries: tuple[int, ...],
        column: tuple[int, ...],
        sound: int,
        fast: tuple[int, ...],
    ) -> None:
        self._array(f"s{node}", fast, "    ")
        self._line(f"if (!({self.names[sound]})) {{", "    ")
        inside = "        "
        for k in self.program.fallback[node]:
            self.node(k)
        for k, value in enumerate(column):
            self._line(f"s{node}[{k}] = {self.names[value]};", inside)
        if is_constrained(self.program, entries):
            self._matrix("", n, entries, inside)
            self._line(f"status |= constrained({n}, a, i, w, s{node});", inside)
        else:
            self._factor("", n, entries, inside)
            self._line(f"lu_solve({n}, a, i, s{node});", inside)
        self._line("}", "    ")


def _literal(value: float | bool) -> str:
    """Return a number in C, exactly."""
    if isinstance(value, bool):
        return str(int(value))
    if math.isnan(value):
        return "NAN"
    text = "INFINITY" if math.isinf(value) else repr(abs(float(value)))
    return f"(-{text})" if math.copysign(1.0, value) < 0.0 else text
