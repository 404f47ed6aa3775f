"""A model as JavaScript: a module of its own, or the part of a page that simulates."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from typing import Any

from pydy.export.model import Model, Variable
from pydy.export.resources import resource
from pydy.export.straight import PRELUDE, javascript_of
from pydy.solvers.run.layout import ALPHA, BETA, EXPONENT
from pydy.solvers.run.methods import method_arrays
from pydy.solvers.tableaus import tableau_of
from pydy.solvers.tuning import ROUNDINGS

__all__ = ["javascript_module", "javascript_object", "literal"]

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
