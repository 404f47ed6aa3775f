"""A model as C99: one header, one source."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import accumulate

from pydy._backends import c_functions
from pydy.export.model import Model, Variable, plain_text

# Macros that a header may define are in capitals. Those in small letters are reserved in all
# formats; B0 and the like are in termios.h.
_MACRO = re.compile(
    r"(?=.*[A-Z_].*[A-Z_])[A-Z][A-Z0-9_]*(?<!_)|I|B\d+|(PRI|SCN|M_|L_|P_|[AP]F_)\w+"
)


_DESCRIPTIONS = {
    "rates": "the derivatives of the states",
    "outputs": "the outputs",
    "jacobian": "the derivatives of rates and outputs by states and inputs, row by row",
    "events": "the expressions whose zero crossings are events",
    "event_rates": "the derivatives of these by time, along the motion",
    "event_bounds": "what rounding may do to the events' expressions, in units of 2^-52",
    "event_input_rates": "what rates of the inputs, behind these in r, add to the events' rates",
    "resets": "for each event the states after it, event by event",
    "start_residuals": "the constraints' residuals, then what typed digits and rounding allow",
    "switches": "the times, in any order, at which rates switch whatever the states are",
}


def with_c_names(model: Model) -> Model:
    """Return a model whose constants have names that no macro has."""
    used = {v.identifier for v in model.constants}
    constants = []
    for v in model.constants:
        if _MACRO.fullmatch(v.identifier):
            name = f"{v.identifier}_"
            while name in used:
                name += "_"
            used.add(name)
            v = replace(v, identifier=name)
        constants.append(v)
    return replace(model, constants=tuple(constants))


# The kinds of a model's variables, in the singular.
_KINDS = ("state", "input", "constant", "output")


def functions_of(model: Model) -> tuple[str, ...]:
    """Return the names of a model's functions in C."""
    names = ["rates", "outputs", "jacobian"]
    if model.events:
        names += ["events", "event_rates", "event_bounds"]
        names += [name for name in ("event_input_rates",) if name in model.builders]
        names += ["resets"]
    if model.constraint_names:
        names.append("start_residuals")
    return (*names, "switches") if model.switches else tuple(names)


def c_header(model: Model, head: Sequence[str]) -> str:
    """Return the header: the constants' struct, sizes, names, numbers and functions."""
    return "\n".join(_header(model, head))


def _header(model: Model, head: Sequence[str]) -> Iterator[str]:
    name, guard = model.name, model.name.upper()
    yield c_comment(head)
    yield f"#ifndef PYDY_{guard}_H\n#define PYDY_{guard}_H\n\n#include <stdint.h>\n"
    yield '#ifdef __cplusplus\nextern "C" {\n#endif\n'
    sizes = {f"{kind.upper()}S": len(getattr(model, f"{kind}s")) for kind in (*_KINDS, "event")}
    if model.switches:
        sizes["SWITCHES"] = model.switches
    sizes["PREPARED"] = max(sum(len(model.program(f).carried) for f in functions_of(model)), 1)
    yield "enum {"
    yield ",\n".join(f"    {guard}_{quantity} = {size}" for quantity, size in sizes.items())
    yield "};\n"
    yield "typedef struct {"
    for v in model.constants:
        yield f"    double {v.identifier};{_remark(v)}"
    if not model.constants:
        yield "    char nothing; /* C knows no empty structs */"
    yield f"}} {name}_constants;\n"
    yield f"extern const {name}_constants {name}_defaults;"
    yield f"extern const double {name}_initial[]; /* states at the start */"
    yield f"extern const double {name}_inputs[]; /* inputs at the start */"
    kinds = [*_KINDS, *(["event"] if model.events else [])]
    kinds += ["constraint"] if model.constraint_names else []
    for kind in kinds:
        yield f"extern const char *const {name}_{kind}_names[];"
    yield ""
    yield "/* Compute what all calls with the same constants share: an array of so many numbers. */"
    yield f"void {name}_prepare(const {name}_constants *constants, double *prepared);"
    for function in functions_of(model):
        description = _DESCRIPTIONS[function]
        yield f"\n/* Write {description}. Returns 1 where the mass matrix is singular. */"
        yield f"{_signature(name, function)};"
    yield "\n#ifdef __cplusplus\n}\n#endif\n"
    yield "#endif\n"


def _signature(name: str, function: str) -> str:
    return (
        f"int32_t {name}_{function}(double t, const double *x, const double *r,\n"
        f"    const double *prepared, double *out)"
    )


def c_model_source(model: Model, head: Sequence[str]) -> str:
    """Return the source. It contains the header, so that it does not depend on the file's name."""
    return "\n".join([*_header(model, head), *_source(model)])


def _source(model: Model) -> Iterator[str]:
    name = model.name
    programs = {f"{name}_{function}_": model.program(function) for function in functions_of(model)}
    yield c_functions(programs, static=True)
    values = ", ".join(c_literal(v.value) for v in model.constants) or "0"
    yield f"const {name}_constants {name}_defaults = {{{values}}};"
    yield _numbers(f"{name}_initial", model.states)
    yield _numbers(f"{name}_inputs", model.inputs)
    for kind in _KINDS:
        yield _strings(f"{name}_{kind}_names", [v.name for v in getattr(model, f"{kind}s")])
    if model.events:
        yield _strings(f"{name}_event_names", model.events.names)
    if model.constraint_names:
        yield _strings(f"{name}_constraint_names", model.constraint_names)
    yield f"\nvoid {name}_prepare(const {name}_constants *constants, double *prepared)\n{{"
    fields = ", ".join(f"constants->{v.identifier}" for v in model.constants) or "0.0"
    yield f"    const double p[] = {{{fields}}};"
    yield "    (void)constants;"
    functions = functions_of(model)
    starts = [0, *accumulate(len(model.program(function).carried) for function in functions)]
    for function, start in zip(functions, starts, strict=False):
        yield f"    {name}_{function}_prepare(p, prepared + {start});"
    yield "}"
    for function, start in zip(functions, starts, strict=False):
        yield f"\n{_signature(name, function)}\n{{"
        yield f"    return {name}_{function}_kernel(&t, x, r, prepared + {start}, out);\n}}"
    yield ""


def c_comment(lines: Sequence[str]) -> str:
    """Return a comment; text that would end it is altered."""
    text = "\n   ".join(_harmless(line) for line in lines)
    return f"/* {text} */\n"


def _harmless(text: str) -> str:
    cleaned = plain_text(text).replace("\\", "/")
    return cleaned.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")


def _remark(variable: Variable) -> str:
    if variable.name == variable.identifier:
        return ""
    return f" /* {_harmless(variable.name)} */"


def c_literal(value: float) -> str:
    """Return a finite number in C, exactly."""
    return repr(float(value))


def c_string(text: str) -> str:
    """Return a string literal of C: UTF-8, octal where it is not plain ASCII."""
    escaped = "".join(
        chr(b) if (chr(b).isalnum() and b < 128) or b in b" _()+-*.,:=[]" else f"\\{b:03o}"
        for b in text.encode(errors="backslashreplace")
    )
    return f'"{escaped}"'


def _numbers(name: str, variables: Sequence[Variable]) -> str:
    values = ", ".join(c_literal(v.value) for v in variables) or "0.0"
    return f"const double {name}[] = {{{values}}};"


def _strings(name: str, texts: Sequence[str]) -> str:
    values = ", ".join(map(c_string, texts)) or '""'
    return f"const char *const {name}[] = {{{values}}};"
