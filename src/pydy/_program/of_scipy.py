"""Functions that only SciPy computes, such as gamma or an integral, as operations.

They are made when an expression is read (`pydy._graph.from_sympy`). The name of such an operation
contains its code, as SymPy's printer for SciPy writes it, with the operands `_0`, `_1`, …, so that
another process can make the operation from its name. Only NumPy's back end evaluates them, sample
by sample.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from importlib import import_module

import numpy as np

from pydy._errors import UnsupportedFunctionError
from pydy._names import few
from pydy._program.operations import Nodes, Operation, register

_PREFIX = "scipy "
DESCRIPTIONS: dict[str, str] = {}
"""The names of the operations made so far, and their text in messages."""


class ScipyOperation(Operation):
    """An operation without code for compilers; asking for its code raises an error."""

    is_generated = True

    def __init__(self, name: str, arity: int, partials: Callable[..., Nodes] | None) -> None:
        code = name.removeprefix(_PREFIX)
        fields = {"name": name, "arity": arity, "numpy": _evaluator(code, arity)}
        for field, value in {**fields, "partials": partials or _no_partials(code)}.items():
            object.__setattr__(self, field, value)

    def __repr__(self) -> str:
        return f"ScipyOperation({self.name!r})"

    @property
    def c(self) -> str:
        """Refuse to be written in C."""
        raise refusal([self.name])

    @property
    def llvm(self) -> str:
        """Refuse to be written for LLVM."""
        raise refusal([self.name])

    @property
    def written(self) -> str:
        """There is no code but the name."""
        return ""

    @staticmethod
    def named(
        code: str, arity: int, description: str = "", partials: Callable[..., Nodes] | None = None
    ) -> str:
        """Return the name of the operation that some code stands for, and register it."""
        name = _PREFIX + code
        if name not in DESCRIPTIONS or partials is not None:
            register(ScipyOperation(name, arity, partials))
            DESCRIPTIONS[name] = description or f"`{code}`"
        return name

    @staticmethod
    def restore(ops: Iterable[str]) -> None:
        """Register the operations of a Program that was made in another process."""
        for name in {op for op in set(ops) if op.startswith(_PREFIX)} - DESCRIPTIONS.keys():
            code = name.removeprefix(_PREFIX)
            ScipyOperation.named(
                code, 1 + max(map(int, re.findall(r"\b_(\d+)\b", code)), default=-1)
            )

    @staticmethod
    def refuse(backend: object, ops: Iterable[str]) -> None:
        """Refuse functions of SciPy for a back end that does not take them."""
        if (
            DESCRIPTIONS
            and not getattr(backend, "scipy", False)
            and (refused := DESCRIPTIONS.keys() & {*ops})
        ):
            raise refusal(refused)


def refusal(names: Iterable[str]) -> UnsupportedFunctionError:
    """Return the error for a back end that takes no functions of SciPy."""
    return UnsupportedFunctionError(
        f"The expressions hold {few(sorted({DESCRIPTIONS[n] for n in names}))}, which only SciPy "
        "computes. The generator 'lambdify' takes that, and is slower: "
        "system.generate_ode_function(generator='lambdify'). Compiled code does not, nor do "
        "exports, contacts, ensembles and optimal control: rewrite it with elementary functions, "
        "or interpolate it over the range that occurs, `sympy.interpolating_spline(3, x, points, "
        "values)`."
    )


def _no_partials(code: str) -> Callable[..., Nodes]:
    def partials(*_: object) -> Nodes:
        raise UnsupportedFunctionError(
            f"The derivative of `{code}` is needed, but not known in this process."
        )

    return partials


def _evaluator(code: str, arity: int) -> Callable[..., np.ndarray | float]:
    modules = {m: import_module(m) for m in ("builtins", "functools", "math", "numpy", "scipy")}
    for name in re.findall(r"\bscipy\.\w+", code):
        import_module(name)
    operands = ", ".join(f"_{k}" for k in range(arity))
    function = eval(f"lambda {operands}: {code}", modules)

    def real(*values: float) -> float:
        value = complex(function(*map(float, values)))
        return value.real if value.imag == 0.0 else float("nan")

    if not arity:
        return lambda: real()
    return np.vectorize(real, otypes=[float])
