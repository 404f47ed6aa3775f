"""Equations of motion as plain data on disk, so that no SymPy release can move a measurement.

A frozen model holds M, F and q' (``M u' = F``) as a list of hash-consed nodes, each of which refers
to earlier ones: ``["Symbol", "m0"]``, ``["Function", "q1"]`` (of time), ``["Integer", "2"]``,
``["Mul", 3, 7, 8]``. Reading gives SymPy expressions back, unevaluated, shared as the nodes are.
"""

from __future__ import annotations

import gzip
import json
from typing import Any

import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from harness.driver import BENCHMARKS
from harness.model import Model

FOLDER = BENCHMARKS / "frozen"

_SYMBOLS = ("coordinates", "speeds", "specifieds", "constants")
_EXPRESSIONS = ("mass_matrix", "forcing", "coordinate_derivatives")


def names() -> list[str]:
    """Return the names of all frozen models."""
    return sorted(path.name.removesuffix(".json.gz") for path in FOLDER.glob("*.json.gz"))


def write(model: Model) -> int:
    """Freeze a model; returns the number of nodes."""
    freezer = _Freezer()
    data: dict[str, Any] = {"name": model.name, "about": model.about, "values": model.values}
    data["positive_definite"] = model.positive_definite
    for key in (*_SYMBOLS, *_EXPRESSIONS):
        data[key] = [freezer(e) for e in getattr(model, key)]
    data["nodes"] = freezer.nodes
    text = json.dumps(data, separators=(",", ":"))
    FOLDER.mkdir(exist_ok=True)
    # No time stamp: the same model gives the same bytes.
    (FOLDER / f"{model.name}.json.gz").write_bytes(gzip.compress(text.encode(), 9, mtime=0))
    return len(freezer.nodes)


def read(name: str) -> Model:
    """Return a frozen model; one without a file is made now."""
    if name not in names():
        from harness.models import MODELS  # derivations need what a peer's environment may lack

        return MODELS[name]()
    data = json.loads(gzip.decompress((FOLDER / f"{name}.json.gz").read_bytes()))
    made: list[Any] = []
    for head, *args in data.pop("nodes"):
        made.append(_ATOMS[head](*args) if head in _ATOMS else _thaw(head, [made[k] for k in args]))
    for key in (*_SYMBOLS, *_EXPRESSIONS):
        data[key] = [made[k] for k in data[key]]
    return Model(**data)


def sizes(model: Model) -> dict[str, int]:
    """Return how many coordinates, speeds and so on there are."""
    return {key: len(getattr(model, key)) for key in _SYMBOLS}


_ATOMS = {
    "Symbol": sm.Symbol,
    "Time": lambda: dynamicsymbols._t,
    "Function": lambda name: sm.Function(name)(dynamicsymbols._t),
    "Integer": lambda text: sm.Integer(int(text)),
    "Rational": lambda text: sm.Rational(text),
    "Float": lambda text: sm.Float(float(text)),
    "Pi": lambda: sm.pi,
}


def _thaw(head: str, args: list[Any]) -> Any:
    if head == "Derivative":
        return args[0].diff(dynamicsymbols._t)
    return getattr(sm, head)(*args, evaluate=False)


class _Freezer:
    def __init__(self) -> None:
        self.nodes: list[list[Any]] = []
        self._known: dict[tuple[Any, ...], int] = {}
        self._seen: dict[int, int] = {}
        self._alive: list[Any] = []

    def __call__(self, root: Any) -> int:
        stack = [root]
        while stack:
            expr = stack[-1]
            if id(expr) in self._seen:
                stack.pop()
                continue
            atom = _atom(expr)
            missing = [] if atom else [a for a in _arguments(expr) if id(a) not in self._seen]
            if missing:
                stack.extend(missing)
                continue
            stack.pop()
            key = atom or (
                type(expr).__name__,
                *(self._seen[id(a)] for a in _arguments(expr)),
            )
            if key not in self._known:
                self._known[key] = len(self.nodes)
                self.nodes.append(list(key))
            self._seen[id(expr)] = self._known[key]
            self._alive.append(expr)  # an id is unique only while its object lives
        return self._seen[id(root)]


def _arguments(expr: Any) -> tuple[Any, ...]:
    return expr.args[:1] if isinstance(expr, sm.Derivative) else expr.args


def _atom(expr: Any) -> tuple[Any, ...] | None:
    if expr is dynamicsymbols._t:
        return ("Time",)
    if isinstance(expr, AppliedUndef):
        return ("Function", expr.func.__name__)
    if isinstance(expr, sm.Symbol):
        return ("Symbol", expr.name)
    if isinstance(expr, sm.Integer):
        return ("Integer", str(int(expr)))
    if isinstance(expr, sm.Rational):
        return ("Rational", str(expr))
    if isinstance(expr, sm.Float):
        return ("Float", repr(float(expr)))
    return ("Pi",) if expr is sm.pi else None
