"""Checks of what users hand to System: each returns plain data or says what is wrong."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from pydy._assembly.system import Group, check_accelerations
from pydy._checks import Places, ascending, describe, listed, real_array, resolved, shown
from pydy._errors import UnsupportedFunctionError
from pydy._mechanics.equations import Equations
from pydy._mechanics.symbols import find_symbols, sort_symbols
from pydy._names import told_apart
from pydy.codegen.arguments import checked_expression


class SymbolSet(set[Any]):
    """A set of symbols that iterates and prints in sorted order."""

    def __iter__(self) -> Iterator[Any]:
        return iter(sort_symbols(set.__iter__(self)))

    def __repr__(self) -> str:
        symbols = list(self)
        return (
            "{" + ", ".join(told_apart(symbols, [str(s) for s in symbols])) + "}"
            if self
            else "set()"
        )

    __str__ = __repr__


def check_times(times: Any) -> np.ndarray:
    """Return times as a float array, shape (n,)."""
    if times is None:
        return np.empty(0)
    array = np.array(real_array(times, "`times`")) if hasattr(times, "__len__") else np.empty(())
    if array.ndim == 0:
        raise TypeError(
            f"`times` must be a sequence of time values, got the {type(times).__name__} "
            f"{shown(times)}."
        )
    ascending(array, "`times`")
    if array.size and array[0] < 0.0:
        raise ValueError(f"`times` must not be negative, got {array[0]} at index 0.")
    return array


def check_symbols(argument: str, symbols: Any, kind: str, equations: Equations) -> list[Any]:
    """Return a user's own list of constants or specifieds, sorted."""
    given = listed(argument, symbols, hashable=True)
    unique = dict.fromkeys(
        resolved(argument, given, equations.symbols, "symbols of the equations")
        if any(isinstance(s, str) for s in given)
        else given
    )
    for symbol in unique:
        constant = isinstance(symbol, sm.Symbol)
        if symbol == equations.time:
            raise ValueError(f"`{argument}` has `{symbol}`, which is time in the equations.")
        function = isinstance(symbol, (AppliedUndef, sm.Derivative))
        if not (constant if kind == "constant" else function):
            expected = "symbols" if kind == "constant" else "functions of time"
            raise ValueError(f"`{argument}` must hold {expected}, got `{symbol}`.")
    return sort_symbols(unique)


def base_symbols(
    equations: Equations, constants: Any, specifieds: Any
) -> tuple[list[Any], list[Any]]:
    """Return the constants and specifieds of the equations, searched for where not given."""
    found: tuple[list[Any], list[Any]] = ([], [])
    if constants is None or specifieds is None:
        found = sort_out(equations)
        check_accelerations(equations, *found)
    if constants is not None:
        constants = check_symbols("constants_symbols", constants, "constant", equations)
    if specifieds is not None:
        specifieds = check_symbols("specifieds_symbols", specifieds, "specified", equations)
    return (
        found[0] if constants is None else constants,
        found[1] if specifieds is None else specifieds,
    )


def sort_out(
    equations: Equations, expressions: Iterable[Any] | None = None, known: Iterable[Any] = ()
) -> tuple[list[Any], list[Any]]:
    """Return constants and specifieds in expressions, by default the equations'."""
    t = equations.time
    states = {*equations.coordinates, *equations.speeds}
    skip = {*states, *equations.zeros, *known, t}
    skip.update((*equations.coordinate_rates, *equations.speed_rates))
    constants, specifieds = [], []
    if expressions is None:
        expressions, found = equations.expressions, equations.symbols
    else:
        expressions = list(expressions)
        found = find_symbols(expressions)
    for symbol in found:
        if symbol in skip:
            continue
        if isinstance(symbol, sm.Symbol):
            constants.append(symbol)
            continue
        function = symbol.expr if isinstance(symbol, sm.Derivative) else symbol
        if function in states or function in equations.auxiliary_speeds:
            raise ValueError(
                f"The term `{_term_with(symbol, expressions)}` holds `{symbol}`, but of the "
                "coordinates and speeds only the first derivatives are available. Rewrite it in "
                "terms of the speeds and their first derivatives."
            )
        variables = symbol.variables if isinstance(symbol, sm.Derivative) else ()
        if (
            not isinstance(function, AppliedUndef)
            or function.args != (t,)
            or any(v != t for v in variables)
        ):
            other = [v for v in (*function.args, *variables) if str(v) == str(t) and v != t]
            raise UnsupportedFunctionError(
                f"The expressions hold `{symbol}`, which is not a function of time `{t}` alone. "
                + (
                    f"Its `{t}` has other assumptions than `dynamicsymbols._t`, so that SymPy "
                    "takes it for another symbol. Make functions of time with `dynamicsymbols`."
                    if other
                    else "Make it a function of time and give its values as a specified, or write "
                    "it with elementary functions."
                )
            )
        specifieds.append(symbol)
    return sort_symbols(constants), sort_symbols(specifieds)


def _term_with(symbol: Any, expressions: Iterable[Any]) -> Any:
    for expression in expressions:
        if symbol in find_symbols([expression]):
            for term in sm.Add.make_args(expression):
                if symbol in find_symbols([term]):
                    return term
    return symbol


def named_outputs(outputs: Mapping[Any, Any]) -> dict[Any, Any]:
    """Return an outputs dictionary with symbols in place of names."""
    result: dict[Any, Any] = {}
    for key, value in outputs.items():
        several = isinstance(key, (tuple, list))
        names = key if several else (key,)
        if any(isinstance(name, str) for name in names):
            if "" in names:
                raise ValueError("`outputs` has an empty name.")
            entries = value if isinstance(value, (tuple, list, sm.MatrixBase)) else (value,)
            own = Places(
                list(find_symbols([e for e in entries if isinstance(e, sm.Basic)])), "symbols"
            )
            found = [own.get(n, "outputs") if isinstance(n, str) else None for n in names]
            names = tuple(
                own.symbols[k] if k is not None else sm.Symbol(n) if isinstance(n, str) else n
                for n, k in zip(names, found, strict=True)
            )
            key = names if several else names[0]
        if key in result:
            raise ValueError(f"`outputs` gives `{key}` more than once.")
        result[key] = value
    return result


def output_groups(outputs: Mapping[Any, Any]) -> list[Group]:
    """Return the entries of an outputs dictionary as groups of names and expressions."""
    groups = []
    for key, value in outputs.items():
        several = isinstance(key, (tuple, list))
        names = tuple(key) if several else (key,)
        for name in names:
            named = isinstance(name, sm.Symbol) or (
                isinstance(name, AppliedUndef) and name.args == (dynamicsymbols._t,)
            )
            if not named:
                raise ValueError(
                    f"`outputs` has the key `{key!r}`, but keys must be a symbol or a function of "
                    "time, or a tuple of them."
                )
        if isinstance(value, (tuple, list, sm.MatrixBase)):
            expressions = tuple(_expression(names, e) for e in value)
        else:
            expressions = (_expression(names, value),)
        if len(expressions) != len(names):
            raise ValueError(
                f"`outputs` for {describe(names)} must be {len(names)} expressions, one for each "
                f"name, got {len(expressions)}."
            )
        groups.append(Group(names, expressions))
    return groups


def _expression(names: Sequence[Any], value: Any) -> Any:
    return checked_expression(value, f"`outputs` for {describe(names)}")


def check_forces(equations: Equations, forces: Any) -> list[Any]:
    """Return the symbols of noncontributing forces that a user gave by themselves or by name."""
    if forces is None:
        return []
    several = isinstance(forces, Iterable) and not isinstance(forces, str)
    names = resolved(
        "noncontributing_forces",
        listed("noncontributing_forces", forces) if several else [forces],
        find_symbols(equations.auxiliary_equations),
        "symbols of the auxiliary equations",
    )
    if not names:
        return names
    wanted = len(equations.auxiliary_equations)
    if not wanted:
        raise RuntimeError(
            f"`noncontributing_forces` are {describe(names)}, but the KanesMethod has no auxiliary "
            "equations that could give them: pass `u_auxiliary` to KanesMethod."
        )
    if len(names) != wanted:
        raise ValueError(
            f"`noncontributing_forces` must have {wanted} names, one for each auxiliary speed, got "
            f"{len(names)}: {describe(names)}."
        )
    for name in names:
        if not isinstance(name, sm.Basic):
            raise TypeError(f"`noncontributing_forces` must be symbols, got {shown(name)}.")
    if len(set(names)) != len(names):
        raise ValueError(f"`noncontributing_forces` repeat a name: {describe(names)}.")
    present = find_symbols(equations.auxiliary_equations)
    for name in names:
        if name not in present:
            raise ValueError(
                f"`noncontributing_forces` has `{name}`, which does not occur in the auxiliary "
                "equations of the KanesMethod."
            )
        if name in equations.symbols:
            raise ValueError(
                f"`noncontributing_forces` has `{name}`, which still occurs in the equations of "
                "motion: it contributes, and must be a specified."
            )
    return names
