"""A model as JavaScript: a module of its own, or the part of a page that simulates."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, replace
from operator import attrgetter

from pydy._backends import HELPERS, Dialect, RepeatedLine, Template, Writer, stages
from pydy._program import Program, numbered
from pydy.export.model import Model, Variable, plain_text, resource
from pydy.solvers import method_arrays, native_constants, portable_sources, tableau_of

# -- A Program as straight-line JavaScript ---------------------------------------------------------
# The expressions are those of C, which are also valid JavaScript once functions with the names of
# the C library are defined, as by `PRELUDE`. Numbers are 64-bit floats in both. Arrays are
# allocated once, outside the functions.


_MATHEMATICS = """\
const { sqrt, exp, log, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh,
  floor, ceil, pow, atan2, sign } = Math;
const fabs = Math.abs, minimum = Math.min, maximum = Math.max, NAN = NaN, INFINITY = Infinity;

// Error functions: a series of positive terms, and a continued fraction where x is large
// (Abramowitz and Stegun, 7.1.6 and 7.1.14).
function erf(x) {
  const square = x * x;
  if (!(square < 9)) return x > 0 ? 1 - erfc(x) : x < 0 ? erfc(-x) - 1 : x;
  let term = x, sum = x;
  for (let k = 1; fabs(term) > 1e-17 * fabs(sum); k += 1) {
    term *= 2 * square / (2 * k + 1);
    sum += term;
  }
  return 2 / sqrt(Math.PI) * exp(-square) * sum;
}

function erfc(x) {
  if (!(x > 1)) return 1 - erf(x);
  let tail = x;
  for (let k = 200; k > 0; k -= 1) tail = x + k / 2 / tail;
  return exp(-x * x) / (sqrt(Math.PI) * tail);
}

"""
# C syntax in the linear algebra that JavaScript does not have: types, and macros for lanes and
# compilers.
_C_SYNTAX = (
    (r"(?:static inline|INLINE|APART) \w+ ", "function "),
    (r"(?:const )?(?:double|Real|int\d+_t) \*?(\w+)(?=[,)])", r"\1"),
    (r"const (?:double|Real|int\d+_t) ", "const "),
    (r"(?:double|Real|int\d+_t) ", "let "),
    (r"LESS\(([^,]+), ([^,]+), ([^;]+)\);", r"\1 - \2 * \3;"),
    (r"\[AT\((.*?)\)\]", r"[\1]"),
    (r" *SERIAL\n|\((?:double|Real)\)", ""),
)


def _script(code: str) -> str:
    """Translate C functions to JavaScript, which has the same arithmetic."""
    for pattern, replacement in _C_SYNTAX:
        code = re.sub(pattern, replacement, code)
    return code


PRELUDE = _MATHEMATICS + "\n".join(
    _script(numbered(HELPERS[name])) for name in ("lu_factor", "lu_solve", "constrained")
)

LONGEST = 4000
"""Largest number of operations in one function. Engines interpret longer ones, uncompiled."""

_VECTOR = "const {name} = new Float64Array({many});"
_MATRIX = (
    "const {name}_a = new Float64Array({n} * {n}), {name}_pivots = new Int32Array({n});",
    "const {name}_scales = new Float64Array(2 * {n});",
)
_FILLED = RepeatedLine("entries", "{name}_a[{k}] = {value};")
_CALL = "{n}, {name}_a, {name}_pivots, {name}_scales"
_FACTOR = (_FILLED, f"if (lu_factor({_CALL})) failed = true;")
_COLUMN = RepeatedLine("column", "{name}[{k}] = {value};")
_GUARDED = (RepeatedLine("fast", "{name}[{k}] = {value};"), "if (!({sound})) {{", "  {body}")

JAVASCRIPT = Dialect(
    operation=attrgetter("c"),
    literals={"nan": "NAN", "inf": "INFINITY", "True": "true", "False": "false"},
    inputs={
        "t": "t",
        **{group: f"{group}[{{k}}]" for group in "xrpc"},
        "c truth": "(c[{k}] !== 0)",
    },
    assignment="const {name} = {value};",
    rules={
        "factor": _FACTOR,
        "solve": (_COLUMN, "lu_solve({n}, {factor}_a, {factor}_pivots, {name});"),
        "guard": (
            *_GUARDED,
            *_FACTOR,
            _COLUMN,
            "for (let k = 0; k < {many}; k += {n})",
            "  lu_solve({n}, {name}_a, {name}_pivots, {name}.subarray(k, k + {n}));",
            "}}",
        ),
        "constrained": (
            *_GUARDED,
            _FILLED,
            _COLUMN,
            f"if (constrained({_CALL}, {{many}}, {{name}})) failed = true;",
            "}}",
        ),
    },
    array="{function}_s{node}",
    reserved={
        "factor": _MATRIX,
        "solve": (_VECTOR,),
        "guard": (_VECTOR, *_MATRIX),
        "constrained": (_VECTOR, *_MATRIX),
    },
)
_PARTS = replace(JAVASCRIPT, assignment="{name} = {value};", name="{function}_v[{node}]")
_FUNCTION: Template = (
    "function {function}{part}({arguments}) {{",
    "  let failed = false;",
    "  {body}",
    RepeatedLine("results", "  {result}[{k}] = {value};"),
    "  return failed;",
    "}}",
)


def javascript_of(program: Program, name: str) -> str:
    """Return a Program as the two functions ``NAME_prepare(p, c)`` and ``NAME(t, x, r, c, out)``.

    The second returns whether a linear solve encountered a singular matrix. `c` holds
    ``len(program.carried)`` numbers.
    """
    setup, run = stages(program)
    prepare = {"function": f"{name}_prepare", "arguments": "p, c", "result": "c"}
    rates = {"function": name, "arguments": "t, x, r, c, out", "result": "out"}
    lines = [
        *_functions(program, setup, program.carried, prepare),
        *_functions(program, run, program.outputs, rates),
        "",
    ]
    return "\n".join(lines)


def _functions(
    program: Program, nodes: list[int], results: Sequence[int], fields: dict[str, str]
) -> Iterator[str]:
    """Yield the lines of a function, divided into several where it is very long."""
    chunked = len(nodes) > LONGEST
    writer = Writer(
        program, _PARTS if chunked else JAVASCRIPT, "r" in fields["arguments"], **fields
    )
    bodies = [
        writer.lines(nodes[first : first + LONGEST]) for first in range(0, len(nodes) or 1, LONGEST)
    ]
    yield from writer.reserved
    if chunked:
        name, arguments = fields["function"], fields["arguments"]
        yield f"const {name}_v = new Float64Array({len(program.ops)});"
        for k, body in enumerate(bodies):
            yield from writer.filled(_FUNCTION, body, {"results": ()}, part=f"_{k}")
        bodies = [[f"if ({name}_{k}({arguments})) failed = true;" for k in range(len(bodies))]]
    yield from writer.filled(_FUNCTION, bodies[0], {"results": results}, part="")


# -- The module ------------------------------------------------------------------------------------


METHOD = "dop853"


def literal(value: object) -> str:
    """Return JSON in which no string can end the script element of an HTML page."""
    text = json.dumps(value, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def javascript_module(model: Model, head: Sequence[str]) -> str:
    """Return an ECMAScript module with the functions of a model, and a comment at the top."""
    comment = "\n".join(f"// {plain_text(line)}".rstrip() for line in head)
    return f"""{comment}

const model = {javascript_object(model)};

export default model;
export const {{ states, inputs, constants, outputs, bind, rates, simulate }} = model;
export const evaluateOutputs = model.evaluateOutputs;
"""


def javascript_object(model: Model, extra: Sequence[str] = ()) -> str:
    """Return the expression of an object: a model's names, numbers and functions.

    Further Programs of the model, by name, become functions ``(t, x, r, out)``.
    """
    names = ["rates", "outputs", *extra]
    if model.events:
        names += ["events", "event_rates", "event_bounds", "resets"]
    if model.constraints:
        names.append("projection")
    if model.switches:
        names.append("switches")
    if model.constraint_names:
        names.append("start_residuals")
    programs = {name: model.program(name) for name in names}
    code = "\n".join(javascript_of(program, name) for name, program in programs.items())
    buffers = "\n".join(
        f"const {name}_c = new Float64Array({len(program.carried)});"
        for name, program in programs.items()
    )
    bound = "\n".join(f"  {name}_prepare(p, {name}_c);" for name in names)
    extras = "".join(
        f"\n  {name}: (t, x, r, out) => {name}(t, x, r, {name}_c, out),\n"
        f"  {name}_size: {programs[name].signature.num_outputs}," for name in extra
    )  # fmt: skip
    integrator = resource("integrator.js")
    projection = _projection() if model.constraints else ""
    parts = {
        "PRELUDE": PRELUDE,
        "CODE": code,
        "BUFFERS": buffers,
        "BOUND": bound,
        "CONSTANTS": _constants(integrator + projection),
        "INTEGRATOR": integrator,
        "PROJECTION": projection,
        "METHOD": literal(_method()),
        "INFO": literal(_description(model)),
        "EVENTS": literal(asdict(model.events)),
        "SYSTEM_EVENTS": _EVENTS if model.events else "null",
        "SYSTEM_PROJECTION": (
            f"projector({literal(dict(model.constraints))}, (t, x, out) => "
            "projection(t, x, r, projection_c, out))"
            if model.constraints
            else "null"
        ),
        "SYSTEM_SWITCHES": (
            f"(out) => switches(0, [], r, switches_c, out), switchCount: {model.switches}"
            if model.switches
            else "null"
        ),
        "CONSTRAINT_NAMES": literal(list(model.constraint_names)),
        "START_RESIDUALS": (
            "start_residuals(t, x, r, start_residuals_c, values)"
            if model.constraint_names
            else "false"
        ),
        "EXTRAS": extras,
    }
    # In one pass, because a name that the user chose may look like a placeholder.
    return re.sub(r"/\*([A-Z_]+)\*/", lambda m: parts[m[1]], resource("model.js"))


_EVENTS = """{
        ...eventNames,
        count: eventNames.names.length,
        values: (t, x, out) => events(t, x, r, events_c, out),
        rates: (t, x, out) => event_rates(t, x, r, event_rates_c, out),
        bounds: (t, x, out) => event_bounds(t, x, r, event_bounds_c, out),
        reset(k, t, x) {
          resets(t, x, r, resets_c, allResets);
          x.set(allResets.subarray(k * x.length, (k + 1) * x.length));
        },
      }"""


def _constants(text: str) -> str:
    """Define the constants of the native solvers that a text uses, as ``layout.h`` does for C."""
    words = set(re.findall(r"\b[A-Z][A-Z_]+\b", text))
    constants = {name: x for name, x in native_constants().items() if name in words}
    return "\n".join(f"const {name} = {literal(x)};" for name, x in constants.items())


def _projection() -> str:
    """Return the projection onto the constraints, with the factorisation of native solvers."""
    header = portable_sources("projection.h")["projection.h"]
    algebra = header[header.index("INLINE void set_identity") : header.index("/* Compute `step`")]
    return resource("projection.js").replace("/*ALGEBRA*/", _script(algebra))


def _description(model: Model) -> dict[str, object]:
    """Return the names, default values and time span of a model."""
    return {
        "name": model.name,
        "title": model.title,
        "states": _variables(model.states),
        "inputs": _variables(model.inputs),
        "constants": _variables(model.constants),
        "outputs": _variables(model.outputs),
        "unknowns": model.unknowns,
        "start": model.start,
        "stop": model.stop,
    }


def _variables(variables: Sequence[Variable]) -> list[dict[str, object]]:
    return [{"name": v.name, "id": v.identifier, "value": v.value} for v in variables]


def _method() -> dict[str, object]:
    """Return the tableau and the constants of the step-size control."""
    tableau = tableau_of(METHOD)
    method = method_arrays(METHOD, 8)

    def rows(part: Iterable[Mapping[int, float]]) -> list[list[object]]:
        return [[list(row), list(row.values())] for row in part]

    return {
        "nodes": tableau.nodes,
        "stages": rows(tableau.stages),
        "weights": rows([tableau.weights])[0],
        "errors": rows(tableau.errors),
        "dense": rows(tableau.dense_stages),
        "interpolant": rows(tableau.interpolant),
        "endInEstimate": any(len(tableau.stages) in row for row in tableau.errors),
        "control": method.control.tolist(),
    }
