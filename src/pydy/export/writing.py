"""Write a model to files; the suffix selects the format."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from inspect import getsource
from pathlib import Path
from typing import Any

from pydy._checks import choice, flag
from pydy._files import write_files
from pydy._graph.interpret import constrained_sample
from pydy._graph.operations import OPERATIONS, is_constrained, operands
from pydy._graph.program import Program
from pydy._graph.tuning import numbered
from pydy._names import nearest
from pydy._version import __version__
from pydy.export.c import c_header, c_model_source, with_c_names
from pydy.export.fmu import write_fmu
from pydy.export.javascript import javascript_module
from pydy.export.model import Exported, Model, Variable, resource

# -- A model as Python functions that need NumPy or JAX, but not pydy ------------------------------


_INFIX = {
    "add": "+", "sub": "-", "mul": "*", "div": "/", "lt": "<", "le": "<=", "eq": "==", "ne": "!=",
}  # fmt: skip
_PURPOSES = {
    "rates": "Return the derivatives of the states.",
    "outputs": "Return the outputs.",
    "jacobian": "Return the derivatives of rates and outputs (rows) by states and inputs.",
    "events": "Return the expressions whose zero crossings are events.",
    "resets": "Return the states after each event, a row for each.",
}


def python_source(model: Model, target: str, head: Sequence[str]) -> str:
    """Return a module.

    Parameters
    ----------
    model : Model
    target : {'numpy', 'jax'}
    head : sequence of str
        Lines for the docstring at the top.
    """
    names = ["rates", "outputs", "jacobian"]
    if target == "jax":
        names.remove("jacobian")  # jax.jacfwd makes it
    if model.events:
        names += ["events", "resets"]
    parts = {
        "HEAD": "\n".join(_harmless(line) for line in head),
        "STATES": _dictionary(model.states),
        "INPUTS": _dictionary(model.inputs),
        "CONSTANTS": _dictionary(model.constants),
        "OUTPUTS": repr(tuple(v.identifier for v in model.outputs)),
        "NAMES": repr(model.renamed),
        "CONSTRAINED": numbered(getsource(constrained_sample)),
        "FUNCTIONS": "\n\n".join(_function(model.program(n), n, target) for n in names),
    }
    text = numbered(resource(f"{target}_module.py.txt"))
    if "_guarded(_constrained" not in parts["FUNCTIONS"]:
        text = re.sub(r"def _constrained\(.*?(?=def _guarded)", "", text, flags=re.DOTALL)
    return re.sub(r"\{\{([A-Z]+)\}\}", lambda m: parts[m[1]], text)


def _harmless(text: str) -> str:
    return "".join(c if c.isprintable() else " " for c in text).replace("\\", "/").replace('"', "'")


def _dictionary(variables: Sequence[Variable]) -> str:
    entries = "".join(f"    {v.identifier!r}: {float(v.value)!r},\n" for v in variables)
    return f"{{\n{entries}}}" if entries else "{}"


def _function(program: Program, name: str, target: str) -> str:
    writer = _Writer(program, "np" if target == "numpy" else "jnp")
    lines = [f"    {line}" for line in writer.lines()]
    quiet = ['@np.errstate(all="ignore")'] if target == "numpy" else []
    shape = program.blocks[0].shape
    outputs = ", ".join(writer.names[k] for k in program.outputs)
    size = "" if len(shape) == 1 else f", {shape}"
    return "\n".join(
        [
            *quiet,
            f"def {name}(t, x, r=None, p=None):",
            f'    """{_PURPOSES[name]}"""',
            "    t, x, r, p = _arguments(t, x, r, p)",
            *lines,
            f"    return _stacked([{outputs}], t, x, r{size})",
            "",
        ]
    )


class _Writer:
    """Writes the operations of a Program, both stages in one."""

    def __init__(self, program: Program, module: str) -> None:
        self.program = program
        self.module = module
        self.names: dict[int, str] = {}

    def lines(self) -> Iterator[str]:
        put_off = {k for nodes in self.program.fallback.values() for k in nodes}
        yield from self._several_lines(k for k in range(len(self.program.ops)) if k not in put_off)

    def _several_lines(self, nodes: Iterable[int], within: int | None = None) -> Iterator[str]:
        """Yield the lines of nodes; those of the fallback of a guard are within its condition."""
        for node in nodes:
            op, args = self.program.ops[node], self.program.args[node]
            if op in ("const", "bool"):
                self.names[node] = _literal(args[0], self.module)
            elif op == "input":
                group, index = args
                self.names[node] = "t" if group == "t" else f"{group}[..., {index}]"
            elif op == "item":
                self.names[node] = f"{self.names[args[0]]}[..., {args[1]}]"
            else:
                if op == "guard":
                    condition = args[3] if within is None else within
                    yield from self._several_lines(self.program.fallback[node], condition)
                    args = (*args[:3], condition, args[4])
                self.names[node] = f"v{node}"
                yield f"v{node} = {self._text(op, args)}"

    def _text(self, op: str, args: tuple[Any, ...]) -> str:
        if op == "factor":
            return f"({args[1]}, [{self._several(args[2])}])"
        if op == "solve":
            return f"_solve(*{self.names[args[0]]}, [{self._several(args[1])}])"
        if op == "guard":
            n, entries, column, sound, fast = args
            lists = ", ".join(f"[{self._several(part)}]" for part in (entries, column, fast))
            solve = "_constrained" if is_constrained(self.program, entries) else "_solve"
            return f"_guarded({solve}, {n}, {self.names[sound]}, {lists})"
        names = [self.names[k] for k in operands(op, args)]
        if op in _INFIX:
            return f"{names[0]} {_INFIX[op]} {names[1]}"
        if op == "neg":
            return f"-{names[0]}"
        return f"{self.module}.{OPERATIONS[op].numpy.__name__}({', '.join(names)})"

    def _several(self, nodes: Sequence[int]) -> str:
        return ", ".join(self.names[k] for k in nodes)


def _literal(value: float | bool, module: str) -> str:
    if isinstance(value, bool):
        return str(value)
    if not math.isfinite(value):
        name = f"{module}.nan" if math.isnan(value) else f"{module}.inf"
        return f"(-{name})" if value < 0.0 else name
    return f"({value!r})" if math.copysign(1.0, value) < 0.0 else repr(value)


# -- Every format ----------------------------------------------------------------------------------


# The options of each kind.
KINDS: dict[str, tuple[str, ...]] = {
    ".c": (),
    ".fmu": ("fmi", "binary"),
    ".js": (),
    ".py": ("target",),
}


def write(model: Model, path: Path, **options: Any) -> Exported:
    """Write a model to a file, and for C to the header beside it.

    Parameters
    ----------
    model : Model
    path : Path
        With the suffix ``.c``, ``.fmu``, ``.js`` or ``.py``.
    target : {'numpy', 'jax'}, optional
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
    check_options(path, options)
    kind = path.suffix.lower()
    model = with_c_names(model) if kind == ".c" else model
    files = _WRITERS[kind](model, path, **options)
    return Exported(path, files, model.renamed)


def check_options(path: Path, options: dict[str, Any]) -> None:
    """Raise the errors of `write` before any work is done."""
    kind = path.suffix.lower()
    if kind not in KINDS:
        raise ValueError(
            f"`path` must have one of the suffixes {', '.join(KINDS)}, which says what to write, "
            f"got '{path.name}'."
        )
    for name in options:
        if name not in KINDS[kind]:
            known = [n for names in KINDS.values() for n in names]
            others = [k for k, names in KINDS.items() if name in names]
            remedy = f"It is one of {others[0]}." if others else nearest(name, known)
            raise TypeError(f"export() to {kind} has no option `{name}`. {remedy}")
    choice(options.get("target", "numpy"), ("numpy", "jax"), "`target`")
    choice(options.get("fmi", "3.0"), ("3.0", "2.0"), "`fmi`")
    flag(options.get("binary", True), "`binary`")


def _head(model: Model) -> list[str]:
    """Return lines for the top of a file."""
    lines = [f"{model.title}: exported by pydy {__version__}."]
    lines += [f"{name} is called {known}" for name, known in model.renamed.items()]
    return lines


def _write_c(model: Model, path: Path) -> tuple[Path, ...]:
    header = path.with_suffix(".h")
    head = _head(model)
    write_files({path: c_model_source(model, head), header: c_header(model, head)})
    return path, header


def _write_js(model: Model, path: Path) -> tuple[Path, ...]:
    write_files({path: javascript_module(model, _head(model))})
    return (path,)


def _write_py(model: Model, path: Path, target: str = "numpy") -> tuple[Path, ...]:
    write_files({path: python_source(model, target, _head(model))})
    return (path,)


def _write_fmu(model: Model, path: Path, fmi: str = "3.0", binary: bool = True) -> tuple[Path, ...]:
    write_fmu(model, path, fmi, binary)
    return (path,)


_WRITERS: dict[str, Callable[..., tuple[Path, ...]]] = {
    ".c": _write_c,
    ".fmu": _write_fmu,
    ".js": _write_js,
    ".py": _write_py,
}
