"""A Program as straight-line C99 that stands alone: for the 'cython' back end and for export.

Every value is a constant local variable; a stage is one function without branches but for the
fallback behind a guard.
"""

from __future__ import annotations

from collections.abc import Mapping
from operator import attrgetter

from pydy._backends.writer import Dialect, Each, Writer, stages
from pydy._graph.program import Program
from pydy._graph.tuning import numbered

# -- the language ---------------------------------------------------------------------------------

# The matrix of a system beside its solution, with the work space of its solver.
_MATRIX = (
    "double {name}_a[] = {{{entries}}};",
    "int {name}_pivots[{n} + 1];",
    "double {name}_scales[2 * {n} + 1];",
)
_CALL = "{n}, {name}_a, {name}_pivots, {name}_scales"
_FACTOR = (*_MATRIX, f"status |= lu_factor({_CALL});")
# The fast solution, and in its place the other one where that is not sound.
_GUARDED = ("double {name}[{many}] = {{{fast}}};", "if (!({sound})) {{", "    {body}",
            Each("column", "    {name}[{k}] = {value};"))  # fmt: skip


def _inside(*lines: str) -> list[str]:
    return [f"    {line}" for line in lines]


C = Dialect(
    operation=attrgetter("c"),
    literals={"nan": "NAN", "inf": "INFINITY", "True": "1", "False": "0"},
    inputs={**{group: f"{group}[{{k}}]" for group in "txrpc"}, "c truth": "(c[{k}] != 0.0)"},
    let="const double {name} = {value};",
    let_truth="const int {name} = {value};",
    rules={
        "factor": _FACTOR,
        "solve": (
            "double {name}[] = {{{column}}};",
            "lu_solve({n}, {factor}_a, {factor}_pivots, {name});",
        ),
        "guard": (
            *_GUARDED,
            *_inside(
                *_FACTOR,
                "for (int k = 0; k < {many}; k += {n})",
                "    lu_solve({n}, {name}_a, {name}_pivots, {name} + k);",
            ),
            "}}",
        ),
        "constrained": (
            *_GUARDED,
            *_inside(*_MATRIX, f"status |= constrained({_CALL}, {{many}}, {{name}});"),
            "}}",
        ),
    },
    empty="0.0",  # C knows no empty arrays
)
_PREPARE = (
    "{static}void {prefix}prepare(const double *RESTRICT p, double *RESTRICT c)",
    "{{",
    "    (void)p; (void)c;",  # which a Program may leave alone
    "    {body}",
    Each("results", "    c[{k}] = {value};"),
    "}}",
    "",
)
_KERNEL = (
    "{static}int32_t {prefix}kernel(",
    "    const double *RESTRICT t, const double *RESTRICT x, const double *RESTRICT r,",
    "    const double *RESTRICT c, double *RESTRICT out)",
    "{{",
    "    (void)t; (void)x; (void)r; (void)c; (void)out;",
    "    int32_t status = 0;",
    "    {body}",
    Each("results", "    out[{k}] = {value};"),
    "    return status;",
    "}}",
    "",
)

# -- what the code calls --------------------------------------------------------------------------

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
HELPERS = {
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
/* Solve M x - A^T l = f, A x = b in place of right-hand sides, so many numbers in all, by Gauss
   and Jordan's elimination, whatever the rank of A; `scales` is 2 n numbers of work space. The last
   rows, with a mark on the diagonal, are those of A in units of their rounding errors; so many are
   independent as are marked so. Pivots are the largest of A, then of the diagonal of M. Returns
   whether M is singular. */
static inline int32_t constrained(int n, double *a, int *pivots, double *scales, int many,
                                  double *b)
{
    int first = n, left = 0;
    int32_t singular = 0;
    double rest = 0.0, any = 0.0; /* NaN, if anything is not finite, of a or of b */
    for (int i = 0; i < many; i++)
        any += 0.0 * b[i];
    for (int i = 0; i < n; i++) {
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
            singular = rest + any == 0.0;
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
                for (int k = 0; k < many; k += n)
                    b[k + i] -= factor * b[k + p];
            }
            pivots[p] = q;
        }
    }
    for (; many > 0; many -= n, b += n) {
        double added = rest;
        for (int i = 0; i < n; i++) {
            added += 0.0 * b[i];
            scales[n + i] = 0.0;
        }
        for (int i = 0; i < n; i++)
            if (pivots[i] >= 0)
                scales[n + pivots[i]] = b[i] / a[i * n + pivots[i]];
        for (int i = 0; i < n; i++)
            b[i] = scales[n + i] + added;
    }
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
    lines: list[str] = []
    for prefix, program in programs.items():
        fields = {"prefix": prefix, "static": "static " if static else ""}
        setup, run = stages(program)
        for template, nodes, results, carried in (
            (_PREPARE, setup, program.carried, False),
            (_KERNEL, run, program.outputs, True),
        ):
            writer = Writer(program, C, carried, **fields)
            lines += writer.filled(template, writer.lines(nodes), {"results": results})
    code = "\n".join(lines)
    called = [text for name, text in HELPERS.items() if f"{name}(" in code]
    return "\n".join([_HEAD, *map(numbered, called), code])
