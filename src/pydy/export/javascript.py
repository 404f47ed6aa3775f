"""A model as JavaScript: a module of its own, or the part of a page that simulates."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator, Sequence
from typing import Any

from pydy._graph.operations import OPERATIONS, TRUTHS, is_constrained, operands
from pydy._graph.program import Program
from pydy._graph.tuning import numbered
from pydy.export.model import Model, Variable, resource
from pydy.solvers.run.layout import ALPHA, BETA, EXPONENT
from pydy.solvers.run.methods import method_arrays
from pydy.solvers.tableaus import tableau_of
from pydy.solvers.tuning import ROUNDINGS

# -- A Program as straight-line JavaScript ---------------------------------------------------------
# The expressions are those of C, which are also valid JavaScript once functions with the names of
# the C library are defined, as by `PRELUDE`. Numbers are 64-bit floats in both.


PRELUDE = numbered(resource("prelude.js"))

LONGEST = 4000
"""Operations in one function at most: engines leave longer ones to their interpreter."""


def javascript_of(program: Program, name: str) -> str:
    """Return a Program as the two functions ``NAME_prepare(p, c)`` and ``NAME(t, x, r, c, out)``.

    The second returns whether a linear solve encountered a singular matrix. `c` holds
    ``len(program.carried)`` numbers.
    """
    return "\n".join([*_prepare(program, name), *_run(program, name), ""])


def _prepare(program: Program, name: str) -> Iterator[str]:
    nodes = [k for k, setup in enumerate(program.setup) if setup]
    writer = _Writer(program, f"{name}_prepare", nodes)
    yield from writer.functions("p, c", "c", program.carried)


def _run(program: Program, name: str) -> Iterator[str]:
    put_off = {k for nodes in program.fallback.values() for k in nodes}
    nodes = [k for k, setup in enumerate(program.setup) if not setup and k not in put_off]
    writer = _Writer(program, name, nodes, program.carried)
    yield from writer.functions("t, x, r, c, out", "out", program.outputs)


class _Writer:
    """Writes the operations of one stage, in several functions where they are very many."""

    def __init__(
        self, program: Program, name: str, nodes: list[int], carried: Sequence[int] = ()
    ) -> None:
        self.program = program
        self.name = name
        self.nodes = nodes
        self.chunked = len(nodes) > LONGEST
        self.arrays: list[str] = []
        self.names: dict[int, str] = {}
        for node, op in enumerate(program.ops):
            if op in ("const", "bool"):
                self.names[node] = _literal(program.args[node][0])
        for index, node in enumerate(carried):
            truth = program.ops[node] in TRUTHS
            self.names[node] = f"(c[{index}] !== 0)" if truth else f"c[{index}]"

    def functions(self, arguments: str, result: str, nodes: Sequence[int]) -> Iterator[str]:
        """Yield the lines of the function that writes some nodes, and of those that it calls."""
        bodies: list[list[str]] = []
        for first in range(0, max(len(self.nodes), 1), LONGEST):
            lines: list[str] = []
            for node in self.nodes[first : first + LONGEST]:
                lines += self._node(node)
            bodies.append(lines)
        ends = [f"{result}[{i}] = {self.names[node]};" for i, node in enumerate(nodes)]
        if self.chunked:
            yield f"const {self.name}_v = new Float64Array({len(self.program.ops)});"
        yield from self.arrays
        if self.chunked:
            for k, lines in enumerate(bodies):
                yield f"function {self.name}_{k}({arguments}) {{"
                yield "  let failed = false;"
                yield from (f"  {line}" for line in lines)
                yield "  return failed;"
                yield "}"
            count = len(bodies)
            bodies = [[f"if ({self.name}_{k}({arguments})) failed = true;" for k in range(count)]]
        yield f"function {self.name}({arguments}) {{"
        yield "  let failed = false;"
        yield from (f"  {line}" for line in bodies[0])
        yield from (f"  {line}" for line in ends)
        yield "  return failed;"
        yield "}"

    def _node(self, node: int) -> list[str]:
        op, args = self.program.ops[node], self.program.args[node]
        if op in ("const", "bool"):
            return []
        if op == "input":
            group, index = args
            self.names[node] = group if group == "t" else f"{group}[{index}]"
            return []
        if op == "item":
            self.names[node] = f"{self.name}_s{args[0]}[{args[1]}]"
            return []
        if op in OPERATIONS:
            names = [self.names[k] for k in operands(op, args)]
            text = OPERATIONS[op].c.format(*names)
            if self.chunked:
                self.names[node] = f"{self.name}_v[{node}]"
                return [f"{self.names[node]} = {text};"]
            self.names[node] = f"v{node}"
            return [f"const v{node} = {text};"]
        if op == "factor":
            self._reserve_matrix(f"{self.name}_a{node}", args[1])
            return self._factor(node, args[1], args[2])
        if op == "solve":
            kept = f"{self.name}_s{node}"
            self._reserve(kept, len(args[1]))
            a = f"{self.name}_a{args[0]}"
            lines = [f"{kept}[{k}] = {self.names[n]};" for k, n in enumerate(args[1])]
            return [*lines, f"luSolve({len(args[1])}, {a}, {a}_pivots, {kept});"]
        assert op == "guard", op
        return self._guard(node, *args)

    def _guard(
        self,
        node: int,
        n: int,
        entries: tuple[int, ...],
        column: tuple[int, ...],
        sound: int,
        fast: tuple[int, ...],
    ) -> list[str]:
        kept = f"{self.name}_s{node}"
        self._reserve(kept, n)
        self._reserve_matrix(f"{self.name}_a{node}", n)
        lines = [f"{kept}[{k}] = {self.names[v]};" for k, v in enumerate(fast)]
        inside = [line for k in self.program.fallback[node] for line in self._node(k)]
        a = f"{self.name}_a{node}"
        column_set = [f"{kept}[{k}] = {self.names[v]};" for k, v in enumerate(column)]
        if is_constrained(self.program, entries):
            inside += [*self._filled(a, entries), *column_set]
            call = f"constrained({n}, {a}, {a}_pivots, {a}_scales, {kept})"
            inside.append(f"if ({call}) failed = true;")
        else:
            inside += [*self._factor(node, n, entries), *column_set]
            inside.append(f"luSolve({n}, {a}, {a}_pivots, {kept});")
        return [*lines, f"if (!({self.names[sound]})) {{", *(f"  {i}" for i in inside), "}"]

    def _reserve(self, name: str, size: int) -> None:
        self.arrays.append(f"const {name} = new Float64Array({size});")

    def _reserve_matrix(self, name: str, n: int) -> None:
        self._reserve(name, n * n)
        self.arrays.append(
            f"const {name}_pivots = new Int32Array({n}), {name}_scales = new Float64Array({2 * n});"
        )

    def _factor(self, node: int, n: int, entries: tuple[int, ...]) -> list[str]:
        a = f"{self.name}_a{node}"
        factor = f"if (luFactor({n}, {a}, {a}_pivots, {a}_scales)) failed = true;"
        return [*self._filled(a, entries), factor]

    def _filled(self, a: str, entries: tuple[int, ...]) -> list[str]:
        return [f"{a}[{k}] = {self.names[e]};" for k, e in enumerate(entries)]


def _literal(value: float | bool) -> str:
    """Return a number in JavaScript, exactly."""
    if isinstance(value, bool):
        return str(value).lower()
    if math.isnan(value):
        return "NAN"
    text = "INFINITY" if math.isinf(value) else repr(abs(float(value)))
    return f"(-{text})" if math.copysign(1.0, value) < 0.0 else text


# -- The module ------------------------------------------------------------------------------------


METHOD = "dop853"


def literal(value: Any) -> str:
    """Return JSON that can stand in a script of an HTML page, whatever its strings hold."""
    text = json.dumps(value, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def javascript_module(model: Model, head: Sequence[str]) -> str:
    """Return an ECMAScript module with the functions of a model.

    Parameters
    ----------
    model : Model
    head : sequence of str
        Lines for the comment at the top.
    """
    plain = ("".join(c if c.isprintable() else " " for c in line) for line in head)
    comment = "\n".join(f"// {line}".rstrip() for line in plain)
    return f"""{comment}

const model = {javascript_object(model)};

export default model;
export const {{ states, inputs, constants, outputs, bind, rates, simulate }} = model;
export const evaluateOutputs = model.evaluateOutputs;
"""


def javascript_object(model: Model, extra: Sequence[str] = ()) -> str:
    """Return the expression of an object: a model's names, numbers and functions.

    Parameters
    ----------
    model : Model
    extra : sequence of str
        Names of further Programs of the model, which become functions ``(t, x, r, out)``.
    """
    names = ["rates", "outputs", *extra]
    if model.events:
        names += ["events", "event_rates", "resets"]
    if model.constraints:
        names.append("projection")
    programs = {name: model.program(name) for name in names}
    code = "\n".join(javascript_of(program, name) for name, program in programs.items())
    kept = "\n".join(
        f"const {name}_c = new Float64Array({len(program.carried)});"
        for name, program in programs.items()
    )
    bound = "\n".join(f"  {name}_prepare(p, {name}_c);" for name in names)
    extras = "".join(
        f"\n  {name}: (t, x, r, out) => {name}(t, x, r, {name}_c, out),\n"
        f"  {name}_size: {len(programs[name].outputs)}," for name in extra
    )  # fmt: skip
    events = model.events
    parts = {
        "PRELUDE": PRELUDE,
        "CODE": code,
        "KEPT": kept,
        "BOUND": bound,
        "INTEGRATOR": resource("integrator.js"),
        "PROJECTION": resource("projection.js").replace("{{ROUNDINGS}}", repr(ROUNDINGS))
        if model.constraints
        else "",
        "METHOD": literal(_method()),
        "INFO": literal(
            {
                "name": model.name,
                "title": model.title,
                "states": _variables(model.states),
                "inputs": _variables(model.inputs),
                "constants": _variables(model.constants),
                "outputs": _variables(model.outputs),
                "start": model.start,
                "stop": model.stop,
            }
        ),
        "EVENTS": literal(
            {
                "names": events.names,
                "directions": events.directions,
                "terminal": events.terminal,
                "acting": events.acting,
            }
        ),
        "SYSTEM_EVENTS": _EVENTS if model.events else "null",
        "SYSTEM_PROJECTION": (
            f"projector({literal(dict(model.constraints))}, (t, x, out) => "
            "projection(t, x, r, projection_c, out))"
            if model.constraints
            else "null"
        ),
        "EXTRAS": extras,
    }
    # In one pass: a name of the user's may look like a place to put something.
    return re.sub(r"/\*([A-Z_]+)\*/", lambda m: parts[m[1]], resource("model.js"))


_EVENTS = """{
        ...eventNames,
        count: eventNames.names.length,
        values: (t, x, out) => events(t, x, r, events_c, out),
        rates: (t, x, out) => event_rates(t, x, r, event_rates_c, out),
        reset(k, t, x) {
          resets(t, x, r, resets_c, allResets);
          x.set(allResets.subarray(k * x.length, (k + 1) * x.length));
        },
      }"""


def _variables(variables: Sequence[Variable]) -> list[dict[str, Any]]:
    return [{"name": v.name, "id": v.identifier, "value": v.value} for v in variables]


def _method() -> dict[str, Any]:
    """Return the tableau and the constants of the step-size control."""
    tableau = tableau_of(METHOD)
    control = method_arrays(METHOD, 8).control

    def rows(part: Any) -> list[Any]:
        return [[list(row), list(row.values())] for row in part]

    return {
        "nodes": tableau.nodes,
        "stages": rows(tableau.stages),
        "weights": rows([tableau.weights])[0],
        "errors": rows(tableau.errors),
        "dense": rows(tableau.dense_stages),
        "interpolant": rows(tableau.interpolant),
        "endInEstimate": any(len(tableau.stages) in row for row in tableau.errors),
        "exponent": float(control[EXPONENT]),
        "alpha": float(control[ALPHA]),
        "beta": float(control[BETA]),
    }
