"""The table of arguments: what all families of them share."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sm

from fuzz.kinds import Kind, RefusedError, array, flag, nothing, real

__all__ = ["FAMILIES", "TARGETS", "Target", "load", "module_name", "target"]


TESTS = Path(__file__).parents[1]
# Modules that add targets: the files of `families`, and any test file that imports this module.
FAMILIES = tuple(
    path.relative_to(TESTS).as_posix()
    for path in (*sorted((TESTS / "fuzz/families").glob("*.py")), *sorted(TESTS.rglob("test_*.py")))
    if "\nfrom fuzz.table import" in path.read_text(encoding="utf-8")
    and path.parent != TESTS / "fuzz"
)


def module_name(family: str) -> str:
    """Return the name that a module of targets is imported by."""
    return family.removesuffix(".py").replace("/", ".")


def load(family: str) -> None:
    """Import a module of targets, once."""
    name = module_name(family)
    if name in sys.modules:
        return
    spec = spec_from_file_location(name, TESTS / family)
    assert spec is not None
    assert spec.loader is not None
    sys.modules[name] = module = module_from_spec(spec)
    spec.loader.exec_module(module)


@dataclass(frozen=True)
class Target:
    """One argument of one function.

    Attributes
    ----------
    name : str
        Its family, a dot, and the argument.
    kind : Kind
    call : callable
        Takes the value, returns what depends on it, for comparison with the plain value's result.
    mentions : tuple of str
        One of these must be in the message of an error.
    own : dict of str to callable
        More values, for this argument only.
    """

    name: str
    kind: Kind
    call: Callable[[Any], Any]
    mentions: tuple[str, ...]
    own: dict[str, Callable[[], Any]] = field(default_factory=dict)


TARGETS: list[Target] = []


def target(
    name: str, kind: Kind, *mentions: str, own: dict[str, Callable[[], Any]] | None = None
) -> Callable[[Callable[[Any], Any]], None]:
    """Add an argument; the function that is decorated takes the value.

    Without `mentions` an error must name what follows the last dot of the name.
    """

    def add(call: Callable[[Any], Any]) -> None:
        short = name.rsplit(".", 1)[1].split("[")[0].rstrip("=)")
        TARGETS.append(Target(name, kind, call, mentions or (f"`{short}",), own or {}))

    return add


def plotted(function: Any, *arguments: Any, **options: Any) -> Any:
    """Return what a function of plots returns, and close its figures."""
    from matplotlib import pyplot

    try:
        return function(*arguments, **options)
    finally:
        pyplot.close("all")


def hashable(value: Any) -> Any:
    """Return a value as it may be a key."""
    try:
        hash(value)
    except TypeError:
        return frozenset()
    return value


def empty_or_none(value: Any) -> bool:
    """Whether a value stands for "none of them"."""
    return value is None or (isinstance(value, (dict, list, tuple, set)) and not value)


def is_number(value: Any) -> bool:
    """Whether a value is a finite number."""
    try:
        real().read(value)
    except RefusedError:
        return False
    return True


def one_of(*options: Any) -> Callable[[Any], bool]:
    """Return whether a value is one of some objects."""
    return lambda value: any(value is option for option in options)


def expression(value: Any) -> Any:
    """Return what can be an expression with real values, or refuse it."""
    if isinstance(value, (sm.Expr, sm.logic.boolalg.Boolean)):
        if value.has(sm.nan, sm.zoo, sm.I, sm.MatrixSymbol) or value.is_Matrix:
            raise RefusedError
        if value.is_number and value.is_finite:
            return real().read(value)
        return value
    return real().read(value)


def _empty_dictionary(value: Any) -> Any:
    if isinstance(value, dict) and not value:
        return value
    raise RefusedError


number = real()
a_dictionary = Kind(_empty_dictionary, ())
flags = flag()
mapping = nothing("symbols", "arrays", allowed=empty_or_none)
key = nothing("symbols", "texts")
STATE = array((2,))
STATES = array((2,), (None, 2))


def ascend(t: np.ndarray) -> bool:
    """Whether finite times ascend; neighbours may be equal."""
    return bool(np.isfinite(t).all() and (np.diff(t) >= 0).all())


def monotonic(t: np.ndarray) -> bool:
    """Whether finite times ascend or descend."""
    return ascend(t) or ascend(t[::-1])


instants = array((None,), check=monotonic)
two_instants = array((None,), check=lambda t: len(t) > 1 and monotonic(t))
ascending_instants = array((None,), check=lambda t: len(t) > 1 and ascend(t))
