"""A Program as straight-line C99 that stands alone: for the 'cython' back end and for export.

Every value is a constant local variable; a stage is one function without branches but for the
fallback behind a guard.
"""

from __future__ import annotations

from collections.abc import Mapping
from operator import attrgetter
from pathlib import Path

from pydy._backends.writer import Dialect, RepeatedLine, Writer, stages
from pydy._program import Program, numbered

# -- the language ---------------------------------------------------------------------------------

# The matrix of a system beside its solution, with the work space of its solver.
_MATRIX = (
    "double {name}_a[] = {{{entries}}};",
    "int64_t {name}_pivots[{n} + 1];",
    "double {name}_scales[2 * {n} + 1];",
)
_CALL = "{n}, {name}_a, {name}_pivots, {name}_scales"
_FACTOR = (*_MATRIX, f"status |= lu_factor({_CALL});")
# The fast solution, and in its place the other one where that is not sound.
_GUARDED = ("double {name}[{many}] = {{{fast}}};", "if (!({sound})) {{", "    {body}",
            RepeatedLine("column", "    {name}[{k}] = {value};"))  # fmt: skip


def _inside(*lines: str) -> list[str]:
    return [f"    {line}" for line in lines]


C = Dialect(
    operation=attrgetter("c"),
    literals={"nan": "NAN", "inf": "INFINITY", "True": "1", "False": "0"},
    inputs={**{group: f"{group}[{{k}}]" for group in "txrpc"}, "c truth": "(c[{k}] != 0.0)"},
    assignment="const double {name} = {value};",
    truth_assignment="const int {name} = {value};",
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
    RepeatedLine("results", "    c[{k}] = {value};"),
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
    RepeatedLine("results", "    out[{k}] = {value};"),
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

_CORE = Path(__file__).parents[1] / "core"
# What files of the core leave open, around them.
_BEGIN = "#define AT(k) (k)\n#define LESS(c, a, b) ((c) - (a) * (b))\n#define SERIAL\n"
_END = "#undef AT\n#undef LESS\n#undef SERIAL\n"


def _shared(name: str) -> str:
    return (_CORE / f"{name}.h").read_text("utf-8")


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
    # Shared with the kernels of LLVM, where the lanes of an item lie side by side.
    **{name: _shared(name) for name in ("lu_factor", "constrained", "lu_solve")},
}


def c_source(program: Program, *, prefix: str = "", static: bool = False) -> str:
    """Return a Program as one file of C99 that needs nothing but the C library's math.

    It defines two functions, which keep no state and allocate nothing::

        void prepare(const double *p, double *c);
        int32_t kernel(const double *t, const double *x, const double *r, const double *c,
                       double *out);

    `prepare` computes from the constants p what all calls share, ``len(program.carried)`` numbers.
    `kernel` writes the flat output, the blocks of the Program's signature one after the other,
    and returns 1 where a linear solve met a singular matrix, whose solution is then NaN, else 0.
    Both names begin with `prefix`; `static` ones are visible in this file alone, which another one
    includes.
    """
    head = f"/* Written by pydy for the program {program.digest}. */\n\n"
    return head + c_functions({prefix: program}, static=static)


def c_functions(programs: Mapping[str, Program], *, static: bool = False) -> str:
    """Return the functions of several Programs, by their prefixes, as `c_source` describes them."""
    lines: list[str] = []
    for prefix, program in programs.items():
        fields = {"prefix": prefix, "static": "static " if static else ""}
        setup, run = stages(program)
        for template, nodes, results, after_setup in (
            (_PREPARE, setup, program.carried, False),
            (_KERNEL, run, program.outputs, True),
        ):
            writer = Writer(program, C, after_setup, **fields)
            lines += writer.filled(template, writer.lines(nodes), {"results": results})
    code = "\n".join(lines)
    helpers = [text for name, text in HELPERS.items() if f"{name}(" in code]
    if any("AT(" in text for text in helpers):
        helpers = [_BEGIN, *helpers, _END]
    return "\n".join([_HEAD, *map(numbered, helpers), code])
