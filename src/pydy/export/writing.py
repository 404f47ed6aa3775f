"""Write a model to files; the suffix selects the format."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from pydy._checks import choice, flag
from pydy._files import write_files
from pydy._names import nearest
from pydy._version import __version__
from pydy.export.c import c_header, c_model_source, with_c_names
from pydy.export.fmu import write_fmu
from pydy.export.javascript import javascript_module
from pydy.export.model import Exported, Model
from pydy.export.python import python_source

__all__ = ["KINDS", "write"]

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
