"""Write a model to files; the suffix selects the format."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

from pydy._backends import Dialect, Template, Writer, stages
from pydy._checks import flag, instance
from pydy._files import file_of, write_files
from pydy._names import nearest
from pydy._option_checks import Check, checked, one_of
from pydy._program import (
    OPERATIONS,
    Operation,
    Program,
    Tape,
    is_constrained,
    numbered,
    solver_sources,
)
from pydy._version import __version__
from pydy.export.c import c_header, c_model_source, with_c_names
from pydy.export.fmu import fmu_archive
from pydy.export.javascript import javascript_module
from pydy.export.model import PARTS, Exported, Model, Variable, plain_text, resource

# -- A model as Python functions that need NumPy, JAX or CasADi, but not pydy ----------------------


_SPECIAL = {
    "erf": {"numpy": "np.vectorize(math.erf, otypes=[float])", "jax": "jax.scipy.special.erf"},
    "erfc": {"numpy": "np.vectorize(math.erfc, otypes=[float])", "jax": "jax.scipy.special.erfc"},
}
"""Functions that NumPy does not have, and their definitions in modules of `_ALIASES`."""


def _dialect(module: str) -> Dialect:
    """Return the language of NumPy, or of a module with the same functions."""

    def operation(row: Operation) -> str:
        if re.fullmatch(r"\{0\} (\+|-|\*|/|<|<=|==|!=) \{1\}|-\{0\}", row.c):
            return row.c
        operands = ", ".join(f"{{{k}}}" for k in range(row.arity))
        name = row.name if row.name in _SPECIAL else f"{module}.{row.numpy.__name__}"
        return f"{name}({operands})"

    guarded = "{n}, {sound}, [{entries}], [{column}], [{fast}])"
    return Dialect(
        operation=operation,
        literals={
            "nan": f"{module}.nan",
            "inf": f"{module}.inf",
            "True": "True",
            "False": "False",
        },
        inputs={"t": "t", **{group: f"{group}[..., {{k}}]" for group in "xrp"}},
        rules={
            "factor": "({n}, [{entries}])",
            "solve": "_solve(*{factor}, [{column}])",
            "guard": f"_guarded(_solve, {guarded}",
            "constrained": f"_guarded(_constrained, {guarded}",
        },
        item="{vector}[..., {k}]",
    )


_OF_CASADI = {
    **{"abs": "fabs({0})", "min": "fmin({0}, {1})", "max": "fmax({0}, {1})"},
    **{"and": "logic_and({0}, {1})", "or": "logic_or({0}, {1})", "not": "logic_not({0})"},
    **{"select": "if_else({0}, {1}, {2})", "pow": "{0} ** {1}", "erfc": "_erfc({0})"},
}
_CASADI = Dialect(
    operation=lambda row: re.sub(r"\b(?=[a-z]\w*\()", "ca.", _OF_CASADI.get(row.name, row.c)),
    literals={"nan": "ca.SX.nan()", "inf": "ca.SX.inf()", "True": "ca.SX(1)", "False": "ca.SX(0)"},
    inputs={"t": "t", **{group: f"{group}[{{k}}]" for group in "xrp"}},
    rules={
        "factor": "_matrix({n}, [{entries}])",
        "solve": "_solve({n}, {factor}, [{column}])",
        "guard": "_guarded({n}, {sound}, [{entries}], [{column}], [{fast}])",
        # An expression cannot find out which constraints are redundant at a singular position.
        "constrained": "ca.vertcat({fast})",
    },
)
_ALIASES = {"numpy": "np", "jax": "jnp"}
DIALECTS = {**{target: _dialect(name) for target, name in _ALIASES.items()}, "casadi": _CASADI}
_JAX: Template = (
    "def {name}(t, x, r=None, p=None):",
    '    """{purpose}"""',
    "    t, x, r, p = _arguments(t, x, r, p)",
    "    {body}",
    "    return _stacked([{results}], t, x, r, p{shape})",
    "",
)
_FUNCTION = {
    "numpy": ('@np.errstate(all="ignore")', *_JAX),
    "jax": _JAX,
    "casadi": (
        "def {name}(t, x, r, p):",
        "    {body}",
        "    return [{results}]",
        "",
        "",
        "{name} = _function({name}, {rows}, {columns})  # {purpose}",
        "",
    ),
}
_PURPOSES = {
    "rates": "Return the derivatives of the states.",
    "outputs": "Return the outputs.",
    "jacobian": "Return the derivatives of rates and outputs (rows) by states and inputs.",
    "events": "Return the expressions whose zero crossings are events.",
    "resets": "Return the states after each event, a row for each.",
    "mass_matrix": "Return M of the equations M u' = f for the derivatives u' of the speeds.",
    "forcing": "Return f of these equations.",
    "holonomic": "Return the residuals of the constraints of positions.",
    "velocity": "Return the residuals of the constraints of velocities.",
}


def _refuse_redundant(program: Program) -> None:
    """Refuse constraints that are redundant at every state: it takes numbers to select some."""
    todo, visited = [*program.outputs], set()
    while todo:
        node = todo.pop()
        if node in visited:
            continue
        visited.add(node)
        op, args = program.ops[node], program.args[node]
        if op != "guard":
            todo += OPERATIONS.operands(op, args)
            continue
        _, entries, column, sound, fast = args
        never = program.ops[sound] == "bool" and not program.args[sound][0]
        if never and is_constrained(program, entries):
            raise ValueError(
                "`target='casadi'` needs constraints that are independent: which of the redundant "
                "ones count is found by numbers, and an expression cannot. Leave the redundant "
                "ones out, or use the target 'numpy' or 'jax'."
            )
        todo += [*entries, *column] if never else fast


def python_source(model: Model, target: str, head: Sequence[str]) -> str:
    """Return a module for one of `DIALECTS`, with some lines at the top of its docstring."""
    names = ["rates", "outputs"]
    if target == "numpy":
        names.append("jacobian")  # JAX and CasADi differentiate
    if target == "casadi":
        names += [name for name in PARTS if name in model.builders]
    if model.events:
        names += ["events", "resets"]
    for name in names if target == "casadi" else ():
        _refuse_redundant(model.program(name))
    sources = solver_sources()
    parts = {
        "HEAD": "\n".join(_harmless(line) for line in head),
        "STATES": _dictionary(model.states),
        "INPUTS": _dictionary(model.inputs),
        "CONSTANTS": _dictionary(model.constants),
        "OUTPUTS": repr(tuple(v.identifier for v in model.outputs)),
        "NAMES": repr(model.renamed),
        "ARGUMENTS": re.sub(r"\bnp\b", _ALIASES.get(target, ""), resource("arguments.py.txt")),
        "PIVOTS": sources["singular"],
        "CONSTRAINED": sources["constrained_sample"],
        "FUNCTIONS": "\n\n".join(
            python_function(
                with_safe_branches(model.program(n)) if target == "jax" else model.program(n),
                n,
                target,
            )
            for n in names
        ),
    }
    special = [name for name in _SPECIAL if re.search(rf"\b{name}\(", parts["FUNCTIONS"])]
    imports = "import math\n\n" if special and target == "numpy" else "\n" if special else ""
    parts["SPECIAL"] = imports + "".join(f"{n} = {_SPECIAL[n].get(target)}\n" for n in special)
    text = numbered(resource(f"{target}_module.py.txt"))
    if "_guarded(_constrained" not in parts["FUNCTIONS"]:
        text = re.sub(r"def _constrained\(.*?(?=def _guarded)", "", text, flags=re.DOTALL)
    if "_erfc(" not in parts["FUNCTIONS"]:
        text = re.sub(r"def _erfc\(.*?(?=def _guarded)", "", text, flags=re.DOTALL)
    return re.sub(r"\{\{([A-Z]+)\}\}", lambda m: parts[m[1]], text)


def _harmless(text: str) -> str:
    return plain_text(text).replace("\\", "/").replace('"', "'")


def _dictionary(variables: Sequence[Variable]) -> str:
    entries = "".join(f"    {v.identifier!r}: {float(v.value)!r},\n" for v in variables)
    return f"{{\n{entries}}}" if entries else "{}"


_SAFE: dict[str, dict[int, float]] = {
    **{name: {0: 1.0} for name in ("sqrt", "log")},
    **{name: {0: 0.0} for name in ("asin", "acos", "atanh", "exp", "sinh", "cosh")},
    **{"acosh": {0: 2.0}, "div": {1: 1.0}, "pow": {0: 1.0, 1: 1.0}, "atan2": {1: 1.0}},
}
"""Safe operands, by position, of operations whose value or derivative may not be finite."""


def with_safe_branches(program: Program) -> Program:
    """Return a Program with the same values, in which inactive branches are finite.

    Reverse accumulation multiplies the derivatives of an inactive branch by zero, which is NaN if
    they are infinite. So an operation that only branches use gets a safe operand while these are
    inactive. The branches' conditions do not depend on it, as otherwise not only branches use it.
    """
    if "select" not in program.ops:
        return program
    guards: dict[int, frozenset[tuple[int, bool]]] = dict.fromkeys(program.outputs, frozenset())
    for node in reversed(range(len(program.ops))):
        op, args, node_guards = program.ops[node], program.args[node], guards[node]
        for position, k in enumerate(OPERATIONS.operands(op, args)):
            branch_guards = (
                node_guards | {(args[0], position == 1)}
                if op == "select" and position
                else node_guards
            )
            guards[k] = guards[k] & branch_guards if k in guards else branch_guards
    tape, new = Tape(), dict[int, int]()
    stack = list(program.outputs[::-1])
    while stack:
        node = stack[-1]
        op, args = program.ops[node], program.args[node]
        safe = _SAFE.get(op, {}) if guards[node] else {}
        needs = [
            *OPERATIONS.operands(op, args),
            *(condition for condition, _ in sorted(guards[node]) if safe),
        ]
        if node in new or new.keys() >= set(needs):
            stack.pop()
            if node in new:
                continue
            ends = list(OPERATIONS.with_operands(op, args, new))
            for position, value in safe.items():
                for condition, first_branch in sorted(guards[node]):
                    operands = (ends[position], tape.const(value))
                    ends[position] = tape.make(
                        "select", new[condition], *(operands if first_branch else operands[::-1])
                    )
            new[node] = tape.make(op, *ends)
        else:
            stack += [k for k in needs if k not in new]
    blocks = [
        (b.name, b.shape, [new[n] for n in program.outputs[b.start : b.stop]])
        for b in program.signature.blocks
    ]
    return Program.from_tape(tape, program.signature.sizes, blocks)


def python_function(program: Program, name: str, target: str) -> str:
    """Return the definition of a function of a module, for one of `DIALECTS`."""
    writer = Writer(program, DIALECTS[target])
    nodes = sorted(itertools.chain(*stages(program)))
    shape = program.signature.blocks[0].shape
    return "\n".join(
        writer.filled(
            _FUNCTION[target],
            writer.lines(nodes),
            {"results": program.outputs},
            name=name,
            purpose=_PURPOSES[name],
            shape="" if len(shape) == 1 else f", {shape}",
            rows=shape[0] if len(shape) == 2 else program.signature.num_outputs,
            columns=shape[1] if len(shape) == 2 else 1,
        )
    )


# -- Every format ----------------------------------------------------------------------------------


def write(model: Model, path: Path, **options: Any) -> Exported:
    """Write a model to a file, for C with a header next to it.

    Parameters
    ----------
    model : Model
    path : Path
        With the suffix ``.c``, ``.fmu``, ``.js`` or ``.py``.
    target : {'numpy', 'jax', 'casadi'}, optional
        For ``.py``.
    fmi : {'3.0', '2.0'}, optional
        For ``.fmu``.
    binary : bool, optional
        For ``.fmu``: whether to include, besides the sources, the binary for this platform, which
        needs a C compiler.

    Returns
    -------
    Exported

    Raises
    ------
    ValueError
        An unknown suffix, or an invalid value of an option.
    TypeError
        The format has no such option.
    """
    instance(model, Model, "`model`", "a model, as `System.export` makes it")
    path = file_of(path, "`path`")
    check_options(path, options)
    kind = path.suffix.lower()
    model = with_c_names(model) if kind == ".c" else model
    files = FORMATS[kind].files(model, path, **options)
    write_files(files)
    return Exported(path, tuple(files), model.renamed)


def check_options(path: Path, options: dict[str, object]) -> None:
    """Raise the errors of `write` before any work is done."""
    kind = path.suffix.lower()
    if kind not in FORMATS:
        raise ValueError(
            f"`path` must have one of the suffixes {', '.join(FORMATS)}, which says what to write, "
            f"got '{path.name}'."
        )
    for name in options:
        if name not in FORMATS[kind].options:
            option_names = [n for form in FORMATS.values() for n in form.options]
            suffixes = [k for k, form in FORMATS.items() if name in form.options]
            remedy = f"It is one of {suffixes[0]}." if suffixes else nearest(name, option_names)
            raise TypeError(f"export() to {kind} has no option `{name}`. {remedy}")
    checked(FORMATS[kind].options, options)


def solves(path: Path) -> bool:
    """Return whether the code in a file of this name will have a solver."""
    return FORMATS[path.suffix.lower()].solves


def _head(model: Model) -> list[str]:
    """Return lines for the top of a file."""
    lines = [f"{model.title}: exported by pydy {__version__}."]
    lines += [f"{name} is called {identifier}" for name, identifier in model.renamed.items()]
    return lines


def _c_files(model: Model, path: Path) -> dict[Path, str]:
    head = _head(model)
    return {path: c_model_source(model, head), path.with_suffix(".h"): c_header(model, head)}


def _py_files(model: Model, path: Path, target: str = "numpy") -> dict[Path, str]:
    return {path: python_source(model, target, _head(model))}


class Format(NamedTuple):
    """The format of a suffix: the functions that return its files and check its options."""

    files: Callable[..., dict[Path, Any]]
    options: Mapping[str, Check] = MappingProxyType({})
    solves: bool = False  # whether its code has a solver


FORMATS = {
    ".c": Format(_c_files),
    ".fmu": Format(
        lambda model, path, **options: {path: fmu_archive(model, **options)},
        {"fmi": one_of("3.0", "2.0"), "binary": flag},
        solves=True,
    ),
    ".js": Format(lambda model, path: {path: javascript_module(model, _head(model))}, solves=True),
    ".py": Format(_py_files, {"target": one_of(*DIALECTS)}),
}
